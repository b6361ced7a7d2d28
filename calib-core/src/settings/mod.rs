//! Everything the instrument knows before it measures: reference, inputs, limits,
//! influence quantities. Plain SI values, stored and exchanged as one message.

mod ceilings;
mod field;
mod point_influences;
mod validate;

pub use point_influences::{AtPoint, PointInfluences};
pub use validate::SettingsError;

pub use crate::reference::{MAX_REFERENCE_POINTS, ReferenceCalibration, ReferencePoint};
pub use crate::requirements::Example;

use crate::channel_ratio::ChannelRatio;
use crate::reference::ReferenceSensitivity;
use heapless::{String, Vec};
use num_complex::Complex32;
use serde::{Deserialize, Serialize};

/// Most influence quantities of a budget (Table A.1 has 18 rows).
pub const MAX_INFLUENCES: usize = 20;

/// How the sensitivity is formed (ISO 16063-21, clause 6).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Method {
    /// S = X / A, the reference being part of the calibrator.
    #[serde(alias = "Calibrator")]
    Calibrator,
    /// S2 = S1 X2 / X1 against a reference transducer.
    #[serde(alias = "Comparison")]
    Comparison,
}

/// One input: sample to volts at the conditioner's output.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InputScale {
    /// Volts at the input connector from one sample to the next, 1/65 536 of the
    /// range whatever the width of the converter.
    pub volt_per_code: f32,
}

/// Limits the exciter must never exceed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Limits {
    /// Drive voltage at the exciter output, V peak.
    pub drive_peak_v: f32,
    /// Acceleration, m/s2 peak.
    pub acceleration_peak_ms2: f32,
    /// Velocity, m/s peak.
    pub velocity_peak_ms: f32,
    /// Displacement, m peak (5 mm is typical of the class, clause 3.2).
    pub displacement_peak_m: f32,
}

/// Assumed probability distribution of an influence quantity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[serde(deny_unknown_fields, rename_all = "snake_case")]
pub enum Distribution {
    /// The value is an expanded uncertainty with this coverage factor.
    #[serde(alias = "Normal")]
    Normal {
        /// Coverage factor the value was stated with.
        coverage_factor: f32,
    },
    /// The value is a half-width; divisor sqrt(3).
    #[serde(alias = "Rectangular")]
    Rectangular,
    /// The value is a half-width; divisor sqrt(6).
    #[serde(alias = "Triangular")]
    Triangular,
    /// The value is an amplitude of an arcsine law; divisor sqrt(2).
    #[serde(alias = "UShaped")]
    UShaped,
    /// The value is divided by an explicit divisor, such as sqrt(18) of Table D.1, Note 3.
    #[serde(alias = "Special")]
    Special {
        /// Value over standard uncertainty: `1 / x_i` of Table D.1.
        divisor: f32,
    },
}

/// An influence quantity of the budget, valid for every point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Influence {
    /// Row number of Table A.1 (1..=18).
    pub row: u8,
    /// Half-width, or expanded uncertainty for `Normal`: relative.
    pub value_rel: f32,
    /// Half-width for the phase (Table A.2), rad.
    pub value_phase_rad: f32,
    /// Probability distribution of both.
    pub distribution: Distribution,
}

/// Turns samples of the reference's channel into acceleration, and compares the device's channel
/// with it: every result rests on it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ReferenceChannel {
    /// The reference's own calibration.
    pub calibration: ReferenceCalibration,
    /// Its input.
    pub input: InputScale,
    /// The device's channel over it.
    pub ratio: ChannelRatio,
}

/// Everything that is set before a measurement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Settings {
    /// How the sensitivity is formed.
    pub method: Method,
    /// Which requirements the checks apply.
    pub example: Example,
    /// The reference's own calibration.
    pub reference: ReferenceCalibration,
    /// Reference input.
    pub reference_input: InputScale,
    /// Input of the device under test.
    pub dut_input: InputScale,
    /// Volts peak at the exciter output per full-scale half-range of the DAC.
    pub drive_full_scale_peak_v: f32,
    /// Limits of the exciter.
    pub limits: Limits,
    /// Most blocks averaged at each point, at least 2. Three are enough where more would not make U smaller.
    pub blocks: u16,
    /// Influence quantities beside the reference's own calibration (row 1) and
    /// the repeatability of the measurement (row 18), which are per point.
    #[cfg_attr(feature = "schema", schemars(with = "[Influence]"))]
    pub influences: Vec<Influence, MAX_INFLUENCES>,
    /// Influence quantities that differ from point to point.
    #[serde(default)]
    pub point_influences: PointInfluences,
    /// The device's channel over the reference's, where it was measured.
    #[serde(default)]
    pub channel_ratio: ChannelRatio,
    /// Quiet of all hosts after which a run that a host began ends in silence, s; 0: it goes on to its end.
    #[serde(default)]
    pub lease_s: u16,
}

impl Settings {
    /// Settings of nothing, for memory that waits for some: [`Settings::validate`] refuses them. Every
    /// byte is zero, so that they may lie in memory that is cleared at the start.
    pub const BLANK: Self = Self {
        method: Method::Calibrator,
        example: Example::Example1,
        reference: ReferenceCalibration {
            serial: String::new(),
            certificate: String::new(),
            calibrated_day: 0,
            due_day: 0,
            points: Vec::new(),
        },
        reference_input: InputScale { volt_per_code: 0.0 },
        dut_input: InputScale { volt_per_code: 0.0 },
        drive_full_scale_peak_v: 0.0,
        limits: Limits {
            drive_peak_v: 0.0,
            acceleration_peak_ms2: 0.0,
            velocity_peak_ms: 0.0,
            displacement_peak_m: 0.0,
        },
        blocks: 0,
        influences: Vec::new(),
        point_influences: PointInfluences::NONE,
        channel_ratio: ChannelRatio::UNKNOWN,
        lease_s: 0,
    };

    /// Settings of the reference's channel.
    pub fn reference_channel(&self) -> ReferenceChannel {
        ReferenceChannel {
            calibration: self.reference.clone(),
            input: self.reference_input,
            ratio: self.channel_ratio.clone(),
        }
    }

    /// Whether `other` says the same of the reference's channel.
    pub fn has_reference_channel_of(&self, other: &Self) -> bool {
        self.reference == other.reference
            && self.reference_input == other.reference_input
            && self.channel_ratio == other.channel_ratio
    }

    /// Sensitivity of the device, V/(m/s2), of which `ratio` is the device's samples over the
    /// reference's at `frequency_hz`.
    ///
    /// # Equation
    /// `S = S1 (x2 v2)/(x1 v1) / R` with the samples x, the scales v of the inputs, the reference's
    /// sensitivity S1 and the ratio R of the channels, 1 where it is not known.
    ///
    /// # Source
    /// ISO 16063-21:2003, clause 6.
    pub(crate) fn sensitivity(
        &self,
        ratio: Complex32,
        reference: &ReferenceSensitivity,
        frequency_hz: f32,
    ) -> Complex32 {
        let scale = self.dut_input.volt_per_code / self.reference_input.volt_per_code
            * reference.sensitivity_v_per_ms2;
        let reference = Complex32::from_polar(scale, reference.phase_rad);
        ratio * reference / self.channel_ratio.taken_away(frequency_hz)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_of_the_reference_channel_counts_and_nothing_else() {
        type Change = fn(&mut Settings);
        let of_reference: [Change; 8] = [
            |s| s.reference.serial = String::try_from("R 2").expect("short"),
            |s| s.reference.certificate = String::try_from("C 2").expect("short"),
            |s| s.reference.due_day += 1,
            |s| s.reference.points.truncate(9),
            |s| s.reference.points[3].sensitivity_v_per_ms2 *= 1.001,
            |s| s.reference.points[3].expanded_uncertainty_phase_rad *= 1.001,
            |s| s.reference_input.volt_per_code *= 1.001,
            |s| s.channel_ratio.measured_day += 1,
        ];
        let of_others: [Change; 4] = [
            |s| s.dut_input.volt_per_code *= 1.001,
            |s| s.limits.drive_peak_v = 1.0,
            |s| s.blocks += 1,
            |s| s.influences.truncate(9),
        ];
        let before = Settings::field_calibrator();
        let same = |change: Change| {
            let mut after = before.clone();
            change(&mut after);
            assert_ne!(after, before);
            after.has_reference_channel_of(&before)
        };
        assert!(of_others.into_iter().all(same));
        assert!(!of_reference.into_iter().any(same));
    }
}
