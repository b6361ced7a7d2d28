//! A measured point, as every output states it.

use crate::code;
use crate::measured::Observed;
use crate::number::{degrees, finite};
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::PointState;
use schemars::JsonSchema;
use serde::Serialize;

/// Whether the results of a point may be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "PointState")]
pub enum StateView {
    /// Every check passed: results and uncertainty hold.
    Valid,
    /// There is no result; `reason` says why.
    Refused,
}

impl StateView {
    /// State, and the code of the reason for a refusal.
    pub fn of(state: PointState) -> (Self, Option<String>) {
        match state {
            PointState::Valid => (Self::Valid, None),
            PointState::Refused(reason) => (Self::Refused, Some(code(&reason))),
        }
    }
}

/// A point to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SetPoint {
    /// Nominal frequency, Hz.
    pub frequency_hz: f32,
    /// Set acceleration, m/s2 r.m.s.
    pub set_acceleration_rms_ms2: f32,
}

impl From<&PointSpec> for SetPoint {
    fn from(spec: &PointSpec) -> Self {
        Self {
            frequency_hz: spec.frequency_hz,
            set_acceleration_rms_ms2: spec.acceleration_rms_ms2,
        }
    }
}

impl From<&SetPoint> for PointSpec {
    fn from(set: &SetPoint) -> Self {
        Self {
            frequency_hz: set.frequency_hz,
            acceleration_rms_ms2: set.set_acceleration_rms_ms2,
        }
    }
}

/// A measured point. Results are missing when it was refused; what was observed
/// meanwhile is stated in any case.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PointView {
    /// The request.
    #[serde(flatten)]
    pub set: SetPoint,
    /// Frequency that was played, Hz; none when there was no tone.
    pub actual_frequency_hz: Option<f64>,
    /// Acceleration reached, m/s2 r.m.s.
    pub acceleration_rms_ms2: f32,
    /// Whether there are results.
    pub state: StateView,
    /// Code of the reason for a refusal, in snake case.
    pub reason: Option<String>,
    /// Magnitude of the sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: Option<f32>,
    /// Relative expanded uncertainty of the magnitude.
    pub expanded_uncertainty_rel: Option<f32>,
    /// Coverage factor of the magnitude.
    pub coverage_factor: Option<f32>,
    /// Effective degrees of freedom of the magnitude; none when infinite.
    pub effective_degrees_of_freedom: Option<f32>,
    /// Phase of the sensitivity, degrees; polarity is apart.
    pub phase_deg: Option<f64>,
    /// Expanded uncertainty of the phase, degrees.
    pub expanded_uncertainty_phase_deg: Option<f64>,
    /// The device under test is inverted in the sense of Annex B.
    pub inverted: bool,
    /// Observed beside the result.
    #[serde(flatten)]
    pub observed: Observed,
    /// Coherence of both channels; none with a single sine.
    pub coherence: Option<f32>,
    /// Temperature of the instrument's processor, degrees Celsius; none when not read.
    pub instrument_temperature_c: Option<f32>,
}

impl PointView {
    /// A point measured with this many samples per second.
    pub fn new(point: &PointResult, sample_rate_hz: f32) -> Self {
        let (state, reason) = StateView::of(point.state);
        let result = |value: f32| finite(value).filter(|_| reason.is_none());
        Self {
            set: SetPoint::from(&point.spec),
            actual_frequency_hz: actual_frequency_hz(point, sample_rate_hz),
            acceleration_rms_ms2: point.acceleration_rms_ms2,
            state,
            sensitivity_v_per_ms2: result(point.sensitivity_v_per_ms2),
            expanded_uncertainty_rel: result(point.expanded_uncertainty_rel),
            coverage_factor: result(point.coverage_factor),
            effective_degrees_of_freedom: result(point.effective_degrees_of_freedom),
            phase_deg: result(point.phase_rad).map(degrees),
            expanded_uncertainty_phase_deg: result(point.expanded_uncertainty_phase_rad)
                .map(degrees),
            inverted: point.inverted,
            observed: Observed::of(point),
            coherence: point.coherence.and_then(finite),
            instrument_temperature_c: point.instrument_temperature_c.and_then(finite),
            reason,
        }
    }

    /// Takes the results back, for a reason that the instrument did not see.
    pub fn refuse(&mut self, reason: &str) {
        self.state = StateView::Refused;
        self.reason = Some(reason.to_owned());
        for result in [
            &mut self.sensitivity_v_per_ms2,
            &mut self.expanded_uncertainty_rel,
            &mut self.coverage_factor,
            &mut self.effective_degrees_of_freedom,
        ] {
            *result = None;
        }
        (self.phase_deg, self.expanded_uncertainty_phase_deg) = (None, None);
    }

    /// True when the results may be used.
    pub fn is_valid(&self) -> bool {
        self.state == StateView::Valid
    }
}

/// The frequency that was played, Hz; none when there was no tone.
fn actual_frequency_hz(point: &PointResult, sample_rate_hz: f32) -> Option<f64> {
    let (cycles, period) = (point.tone.cycles, point.tone.period_samples);
    let played = f64::from(cycles) * f64::from(sample_rate_hz) / f64::from(period);
    (cycles > 0 && period > 0).then_some(played)
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::point_state::Reason;
    use calib_core::tone::Tone;

    fn point() -> PointResult {
        let spec = PointSpec {
            frequency_hz: 160.0,
            acceleration_rms_ms2: 10.0,
        };
        let tone = Tone {
            cycles: 2,
            period_samples: 625,
        };
        PointResult {
            state: PointState::Valid,
            sensitivity_v_per_ms2: 0.010_018,
            phase_rad: -0.5,
            effective_degrees_of_freedom: f32::INFINITY,
            ..PointResult::refused(spec, Some(tone), Reason::Stopped)
        }
    }

    #[test]
    fn a_valid_point_has_results_in_degrees_and_no_reason() {
        let view = PointView::new(&point(), 50_000.0);
        assert!(view.is_valid() && view.reason.is_none());
        assert_eq!(view.actual_frequency_hz, Some(160.0));
        assert_eq!(view.phase_deg, Some(-28.647_889_8));
        assert_eq!(view.effective_degrees_of_freedom, None);
        let json = crate::json::line(&view).expect("writes");
        let keys = "\"frequency_hz\":160.0,\"set_acceleration_rms_ms2\":10.0";
        assert!(json.starts_with(&format!("{{{keys}")), "{json}");
        assert!(
            json.contains("\"sensitivity_v_per_ms2\":0.010018,"),
            "{json}"
        );
    }

    #[test]
    fn a_refused_point_has_a_reason_and_no_result() {
        let refused = PointResult {
            state: PointState::Refused(Reason::DutOpen),
            tone: Tone {
                cycles: 0,
                period_samples: 1,
            },
            ..point()
        };
        let view = PointView::new(&refused, 50_000.0);
        assert_eq!(view.reason.as_deref(), Some("dut_open"));
        assert_eq!(view.sensitivity_v_per_ms2, None);
        assert_eq!(view.actual_frequency_hz, None);
        let mut taken_back = PointView::new(&point(), 50_000.0);
        taken_back.refuse("not_reportable");
        assert!(!taken_back.is_valid() && taken_back.phase_deg.is_none());
    }
}
