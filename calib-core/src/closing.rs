//! Outcome of repeating the first point at the end of a list.
//!
//! A transducer that fades, warms up or works loose while a list is measured changes every point a little, and none
//! of them shows it. So an instrument that measured tone after tone returns to the first point that was valid: what
//! changed until then may be in any of the points.

use crate::point::PointResult;
use crate::point_state::{PointState, Reason};
use core::f32::consts::{PI, SQRT_2};
use serde::{Deserialize, Serialize};

/// A change below this share of U is left out: it adds no more than 1 % to U.
const SMALL_OF_U: f32 = 0.1;
/// Standard deviations of both results from which on a change is one: chance exceeds them in 0.3 %.
const BEYOND_NOISE: f32 = 3.0;

/// Change of the sensitivity from the first valid point to its repetition.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Change {
    /// Of the magnitude, relative.
    pub magnitude_rel: f32,
    /// Of the phase, rad, in (-pi, pi].
    pub phase_rad: f32,
    /// Standard deviation of the magnitude's by the scatter of both results, relative.
    pub noise_rel: f32,
    /// Standard deviation of the phase's, rad.
    pub noise_phase_rad: f32,
}

/// How a run was closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Closing {
    /// Nothing was repeated: fewer than two points, none valid, all points at once or held, a run that ended
    /// early, a record of an earlier release.
    #[default]
    None,
    /// Both were valid.
    Changed(Change),
    /// The repetition was refused for this reason.
    Refused(Reason),
}

impl Closing {
    /// Compares the repetition with the valid point it repeats.
    pub fn new(first: &PointResult, again: &PointResult) -> Self {
        if let PointState::Refused(reason) = again.state {
            return Self::Refused(reason);
        }
        let turned = again.phase_rad - first.phase_rad;
        let phase_rad = match again.inverted == first.inverted {
            true => turned,
            false => turned + PI,
        };
        Self::Changed(Change {
            magnitude_rel: again.sensitivity_v_per_ms2 / first.sensitivity_v_per_ms2 - 1.0,
            phase_rad: libm::atan2f(libm::sinf(phase_rad), libm::cosf(phase_rad)),
            noise_rel: libm::hypotf(again.repeatability_rel, first.repeatability_rel),
            noise_phase_rad: libm::hypotf(
                again.repeatability_phase_rad,
                first.repeatability_phase_rad,
            ),
        })
    }

    /// By how much a point of the run may be off: relative magnitude, and phase in rad. Zero of a change that
    /// noise explains, and of one that is small beside the point's own U.
    pub fn half_widths(&self, point: &PointResult) -> [f32; 2] {
        let Self::Changed(change) = self else {
            return [0.0; 2];
        };
        let counts = |change: f32, noise: f32, expanded: f32| {
            // Written so that a value that is not a number counts.
            let small = change.abs() <= (BEYOND_NOISE * noise).max(SMALL_OF_U * expanded);
            if small { 0.0 } else { change.abs() }
        };
        [
            counts(
                change.magnitude_rel,
                change.noise_rel,
                point.expanded_uncertainty_rel,
            ),
            counts(
                change.phase_rad,
                change.noise_phase_rad,
                point.expanded_uncertainty_phase_rad,
            ),
        ]
    }

    /// U of the magnitude of a point with that, relative: a U-shaped component, for `k = 2` never less than in
    /// the budget of a certificate.
    pub fn expanded_rel(&self, point: &PointResult) -> f32 {
        let [half_width, _] = self.half_widths(point);
        libm::hypotf(point.expanded_uncertainty_rel, SQRT_2 * half_width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::PointSpec;

    /// A valid point with U = 1 % and 0.01 rad.
    fn valid(sensitivity_v_per_ms2: f32, phase_rad: f32, repeatability_rel: f32) -> PointResult {
        let spec = PointSpec {
            frequency_hz: 160.0,
            acceleration_rms_ms2: 10.0,
        };
        PointResult {
            state: PointState::Valid,
            sensitivity_v_per_ms2,
            phase_rad,
            repeatability_rel,
            expanded_uncertainty_rel: 0.01,
            expanded_uncertainty_phase_rad: 0.01,
            ..PointResult::refused(spec, None, Reason::Stopped)
        }
    }

    /// 0.1 % is a tenth of U; 0.4 % is beyond it, but not beyond three times sqrt(2) 0.1 % of noise.
    #[test]
    fn a_change_counts_beyond_noise_and_a_tenth_of_u() {
        let first = valid(0.01, 0.0, 1.0e-4);
        for (sensitivity, repeatability, expected) in [
            (0.010_009_5, 1.0e-4, 0.0),
            (0.010_04, 1.0e-4, 0.004),
            (0.009_96, 1.0e-4, 0.004),
            (0.010_04, 2.0e-3, 0.0),
            (0.009, 1.0e-4, 0.1),
        ] {
            let closing = Closing::new(&first, &valid(sensitivity, 0.0, repeatability));
            let [magnitude, phase] = closing.half_widths(&first);
            assert!((magnitude - expected).abs() < 1.0e-6, "{closing:?}");
            assert_eq!(phase, 0.0);
        }
    }

    #[test]
    fn phases_go_the_short_way_round_and_polarity_counts() {
        let half_width = |first: f32, again: PointResult| {
            Closing::new(&valid(0.01, first, 1.0e-4), &again).half_widths(&again)[1]
        };
        let near = half_width(PI - 0.01, valid(0.01, -PI + 0.02, 1.0e-4));
        assert!((near - 0.03).abs() < 1.0e-6, "{near}");
        let inverted = PointResult {
            inverted: true,
            ..valid(0.01, 0.0, 1.0e-4)
        };
        assert!((half_width(0.0, inverted) - PI).abs() < 1.0e-6);
    }

    /// sqrt(1^2 + 2 0.5^2) % of U = 1 % and a change of 0.5 %.
    #[test]
    fn u_grows_by_a_change_and_by_nothing_else() {
        let first = valid(0.01, 0.0, 1.0e-4);
        let changed = Closing::new(&first, &valid(0.010_05, 0.0, 1.0e-4));
        assert!((changed.expanded_rel(&first) - 0.012_247).abs() < 2.0e-6);
        let refused = PointResult::refused(first.spec, None, Reason::DutOpen);
        for closing in [Closing::None, Closing::new(&first, &refused)] {
            assert_eq!(closing.expanded_rel(&first), 0.01);
        }
        assert_eq!(
            Closing::new(&first, &refused),
            Closing::Refused(Reason::DutOpen)
        );
    }
}
