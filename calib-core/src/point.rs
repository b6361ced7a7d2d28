//! Request for a point, and its result.

use crate::point_state::{PointState, Reason};
use crate::tone::Tone;
use serde::{Deserialize, Serialize};

/// One calibration point to be measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointSpec {
    /// Nominal frequency, Hz; one-third-octave series preferred (5.1).
    pub frequency_hz: f32,
    /// Set acceleration, m/s2 r.m.s.
    pub acceleration_rms_ms2: f32,
}

impl PointSpec {
    /// Whether frequency and level are numbers above zero.
    pub fn is_usable(&self) -> bool {
        let usable = |value: f32| value.is_finite() && value > 0.0;
        usable(self.frequency_hz) && usable(self.acceleration_rms_ms2)
    }
}

/// How the exciter is driven (4.4, Note 1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ExcitationKind {
    /// One tone after another.
    #[default]
    SingleSine,
    /// All lines of the band at once, the same record every time.
    Multisine,
    /// Noise that repeats with the record, drawn anew for each average.
    Random,
    /// One tone after another, each held for all blocks of the settings: somebody looks at it meanwhile.
    HeldSine,
}

impl ExcitationKind {
    /// All points at once.
    pub const fn is_broadband(self) -> bool {
        matches!(self, Self::Multisine | Self::Random)
    }
}

/// One measured calibration point.
///
/// Amplitudes are r.m.s.; uncertainties are standard uncertainties unless the
/// name says expanded; `_rel` is relative to the quantity's own value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointResult {
    /// The request.
    pub spec: PointSpec,
    /// The tone that was played; its frequency follows from the sample rate.
    pub tone: Tone,
    /// Outcome. Unless it is `Pass`, the numbers below are only diagnostic.
    pub state: PointState,
    /// Acceleration reached, m/s2 r.m.s.
    pub acceleration_rms_ms2: f32,
    /// Magnitude of the sensitivity of the device under test, V/(m/s2).
    pub sensitivity_v_per_ms2: f32,
    /// Phase of the sensitivity, rad, in (-pi, pi]; polarity is apart.
    pub phase_rad: f32,
    /// True when the device under test is inverted in the sense of Annex B.
    pub inverted: bool,
    /// Relative experimental standard deviation of the mean over the blocks.
    pub repeatability_rel: f32,
    /// Experimental standard deviation of the mean phase over the blocks, rad.
    pub repeatability_phase_rad: f32,
    /// Amplitude of what the mains may still do to the result, relative, and as many rad of phase: a sine of
    /// unknown phase ([`crate::hum`]). 0 where no line comes near, and with broadband excitation.
    pub hum_rel: f32,
    /// Part of the tone that may be missing, relative: power beside tone and harmonics that is absent at rest, over
    /// that of the tone, both channels as root sum square. 0 with broadband excitation.
    ///
    /// A contact that is open for a share `m` of the time at instants of its own takes `m` of the amplitude and leaves
    /// `m (1 - m)` of the power beside it: over the power left in the tone that is `m / (1 - m)`.
    pub dropout_rel: f32,
    /// Blocks averaged.
    pub blocks: u16,
    /// Relative expanded uncertainty of the magnitude.
    pub expanded_uncertainty_rel: f32,
    /// Coverage factor of the magnitude.
    pub coverage_factor: f32,
    /// Effective degrees of freedom of the magnitude; infinite is `f32::INFINITY`.
    pub effective_degrees_of_freedom: f32,
    /// Expanded uncertainty of the phase, rad.
    pub expanded_uncertainty_phase_rad: f32,
    /// Total harmonic distortion of the reference channel, 1.
    pub distortion_reference_rel: f32,
    /// Total harmonic distortion of the device under test, 1.
    pub distortion_dut_rel: f32,
    /// Signal to residual noise of the reference channel, dB.
    pub signal_to_noise_reference_db: f32,
    /// Signal to residual noise of the device under test, dB.
    pub signal_to_noise_dut_db: f32,
    /// Signal to residual noise of the device under test in its worst block, dB: what the point is
    /// judged by. None with broadband excitation, which has no blocks.
    pub signal_to_noise_worst_block_db: Option<f32>,
    /// Largest relative change of the acceleration amplitude while measuring.
    pub amplitude_stability_rel: f32,
    /// Drive voltage at the exciter output, V peak.
    pub drive_peak_v: f32,
    /// Time from the start of the drive until the level was settled, s.
    pub settling_s: f32,
    /// Largest excess of the amplitude over the set level while settling, 1.
    pub overshoot_rel: f32,
    /// Coherence of both channels with broadband excitation, 0 to 1; none with
    /// a single sine. Where there is one, level and acceleration are the total
    /// r.m.s. of the band (5.1), and distortion, stability and overshoot are
    /// not measured; signal to noise is what the coherence says of both
    /// channels together.
    pub coherence: Option<f32>,
    /// Temperature of the instrument's processor when the point ended, degrees
    /// Celsius, good to some kelvin ([`crate::thermometer`]); none when it could
    /// not be read.
    pub instrument_temperature_c: Option<f32>,
}

impl PointResult {
    /// Whether magnitude, phase, their uncertainties and the coverage factor are numbers.
    pub fn has_result(&self) -> bool {
        [
            self.sensitivity_v_per_ms2,
            self.expanded_uncertainty_rel,
            self.coverage_factor,
            self.phase_rad,
            self.expanded_uncertainty_phase_rad,
        ]
        .into_iter()
        .all(f32::is_finite)
    }

    /// Takes back a state that no number stands behind: what was stored or sent may be damaged or
    /// forged, and is then no result.
    pub fn refuse_without_result(&mut self) {
        if self.state == PointState::Valid && !self.has_result() {
            self.state = PointState::Refused(Reason::BudgetInvalid);
        }
    }

    /// A point without numbers, refused for `reason`.
    ///
    /// Without a tone (no frequency of the sample clock fits), zero cycles are
    /// noted.
    pub fn refused(spec: PointSpec, tone: Option<Tone>, reason: Reason) -> Self {
        Self {
            spec,
            tone: tone.unwrap_or(Tone {
                cycles: 0,
                period_samples: 1,
            }),
            state: PointState::Refused(reason),
            acceleration_rms_ms2: 0.0,
            sensitivity_v_per_ms2: 0.0,
            phase_rad: 0.0,
            inverted: false,
            repeatability_rel: 0.0,
            repeatability_phase_rad: 0.0,
            hum_rel: 0.0,
            dropout_rel: 0.0,
            blocks: 0,
            expanded_uncertainty_rel: 0.0,
            coverage_factor: 0.0,
            effective_degrees_of_freedom: 0.0,
            expanded_uncertainty_phase_rad: 0.0,
            distortion_reference_rel: 0.0,
            distortion_dut_rel: 0.0,
            signal_to_noise_reference_db: 0.0,
            signal_to_noise_dut_db: 0.0,
            signal_to_noise_worst_block_db: None,
            amplitude_stability_rel: 0.0,
            drive_peak_v: 0.0,
            settling_s: 0.0,
            overshoot_rel: 0.0,
            coherence: None,
            instrument_temperature_c: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_passes_with_numbers_alone() {
        let spec = PointSpec {
            frequency_hz: 160.0,
            acceleration_rms_ms2: 10.0,
        };
        let whole = PointResult {
            state: PointState::Valid,
            sensitivity_v_per_ms2: 0.01,
            expanded_uncertainty_rel: 0.01,
            coverage_factor: 2.0,
            ..PointResult::refused(spec, None, Reason::Stopped)
        };
        let judged = |mut point: PointResult| {
            point.refuse_without_result();
            point.state
        };
        assert_eq!(judged(whole), PointState::Valid);
        type Damage = fn(&mut PointResult);
        let damages: [Damage; 6] = [
            |p| p.sensitivity_v_per_ms2 = f32::NAN,
            |p| p.expanded_uncertainty_rel = f32::NAN,
            |p| p.expanded_uncertainty_rel = f32::INFINITY,
            |p| p.coverage_factor = f32::NAN,
            |p| p.phase_rad = f32::NAN,
            |p| p.expanded_uncertainty_phase_rad = f32::NAN,
        ];
        for damage in damages {
            let mut point = whole;
            damage(&mut point);
            assert_eq!(judged(point), PointState::Refused(Reason::BudgetInvalid));
        }
    }
}
