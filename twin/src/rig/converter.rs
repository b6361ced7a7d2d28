//! Converters, the filters beside them, and the power amplifier.

use serde::{Deserialize, Serialize};

use super::common_source::CommonSource;
use super::range::Range;
use crate::converters::Shape;

/// Digital-to-analogue and analogue-to-digital conversion.
///
/// # Why the filters are there
/// A held output repeats the tone's spectrum around every multiple of the sample rate: at 10 kHz the
/// first image lies at 40 kHz with a quarter of the amplitude, and sampling at 50 kHz folds it back
/// on 10 kHz exactly, where no correlation can tell it from the tone. The two transducers differ
/// most just there, near the resonance of the device under test. With the standard rig the
/// reconstruction filter takes 55 dB, the exciter's mass and inductance 24 dB, holding 12 dB and the
/// anti-alias filter 31 dB from the image, so that what is left is below 1e-4 even if the resonance
/// (+28 dB) lies on it. In the pass band to 10 kHz both filters together change the amplitude by
/// less than 0.02 %, and the two channels alike.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Converter {
    /// Rate of both converters, Hz.
    pub sample_rate_hz: f64,
    /// Volts peak at the input connector for half the codes of the 16-bit input converter.
    pub input_full_scale_peak_v: f64,
    /// Order of the Butterworth low-pass behind the drive output, even.
    pub reconstruction_order: u32,
    /// Its -3 dB corner, Hz.
    pub reconstruction_hz: f64,
    /// Order of the Butterworth low-pass before each input, even.
    pub anti_alias_order: u32,
    /// Its -3 dB corner, Hz.
    pub anti_alias_hz: f64,
    /// By how much the corner of the device's anti-alias filter lies above the reference's, relative: 0,
    /// which may be left out, for parts without tolerance.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub dut_corner_excess_rel: f64,
    /// By how much the device's input is later than the reference's, s; may be left out.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub dut_delay_s: f64,
    /// One source at both inputs in place of the transducers; may be left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub common_source: Option<CommonSource>,
    /// Number of the unit, from which what its converters do wrong is drawn; may be left out.
    #[serde(default, skip_serializing_if = "is_first")]
    pub unit: u64,
    /// Characteristic of the input converters beside the line; may be left out.
    #[serde(default, skip_serializing_if = "Shape::is_bits")]
    pub shape: Shape,
    /// Part of the square wave on the dither's pin that the front end adds to both inputs, V peak as at the
    /// connector: 0, which may be left out, for a front end without.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub dither_peak_v: f64,
    /// Errors of the part's converters ([`crate::converters::SHEET`]): 1 as the table has it, other
    /// factors are on what is assumed; 0, which may be left out, makes them ideal.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub errors: f64,
}

fn is_first(unit: &u64) -> bool {
    *unit == 0
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

impl Converter {
    pub(super) fn ranges(&self) -> Vec<Range> {
        let range = |name: &str, value, lowest, highest| {
            Range::new(format!("converter.{name}"), value, lowest, highest)
        };
        let mut ranges = vec![
            range("sample_rate_hz", self.sample_rate_hz, 1e3, 1e6),
            range(
                "input_full_scale_peak_v",
                self.input_full_scale_peak_v,
                1e-3,
                1e3,
            ),
            range(
                "reconstruction_order",
                self.reconstruction_order.into(),
                2.0,
                8.0,
            ),
            range("reconstruction_hz", self.reconstruction_hz, 100.0, 1e6),
            range("anti_alias_order", self.anti_alias_order.into(), 2.0, 8.0),
            range("anti_alias_hz", self.anti_alias_hz, 100.0, 1e6),
            range(
                "dut_corner_excess_rel",
                self.dut_corner_excess_rel,
                -0.5,
                0.5,
            ),
            range("dut_delay_s", self.dut_delay_s, 0.0, 1e-3),
            range("errors", self.errors, 0.0, 10.0),
            range("dither_peak_v", self.dither_peak_v, 0.0, 1e3),
        ];
        ranges.extend(self.common_source.iter().flat_map(CommonSource::ranges));
        ranges
    }
}

/// The power amplifier with the drive output stage.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Amplifier {
    /// Volts at the exciter for +2048 codes of the 12-bit drive converter.
    pub full_scale_peak_v: f64,
}

impl Amplifier {
    pub(super) fn ranges(&self) -> Vec<Range> {
        let volts = self.full_scale_peak_v;
        vec![Range::new("amplifier.full_scale_peak_v", volts, 1e-3, 1e3)]
    }
}
