//! The drive converter: from its code to the voltage at the exciter.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::{Quantity, Sheet};
use crate::rig_port::DRIVE_MID_CODE;

/// Highest code.
const LAST_CODE: u16 = 4095;
const MID_CODE: f64 = DRIVE_MID_CODE as f64;
/// The largest bits, whose elements differ enough to show.
const UNEQUAL_BITS: u32 = 6;
/// Stream of random numbers of a unit, beside those of its inputs.
const STREAM: u64 = 2;
/// Network on the pin that holds mid-scale while the converter is off, ohm: docs/hardware.md.
const BIAS_OHM: f64 = 500.0e3;
/// The buffer's output comes within 0.2 V of either rail, of 3.3 V (DS12110 Rev 10, table 93).
const BUFFER_REACH: f64 = 1.0 - 2.0 * 0.2 / 3.3;

/// One unit's drive converter, with the output stage behind it.
#[derive(Debug, Clone)]
pub(crate) struct DriveConverter {
    /// Voltage at the exciter by code, without buffer and with it.
    volts: [Vec<f64>; 2],
    buffered: bool,
    glitch_v: f64,
    /// Code before.
    before: u16,
}

impl DriveConverter {
    /// Drive converter of the unit of this number; `full_scale_peak_v` is at the exciter for half of an
    /// ideal converter's codes.
    pub(crate) fn new(sheet: Sheet, full_scale_peak_v: f64, unit: u64) -> Self {
        let mut random = ChaCha12Rng::seed_from_u64(unit);
        random.set_stream(STREAM);
        let codes = pin_codes(sheet, &mut random);
        let step_v = full_scale_peak_v / MID_CODE;
        // The network divides what the converter gives without its buffer.
        let loaded = loaded(sheet.value(Quantity::DriveSource), BIAS_OHM);
        let reach = match sheet.is_ideal() {
            true => MID_CODE,
            false => BUFFER_REACH * MID_CODE,
        };
        Self {
            volts: [
                codes.iter().map(|code| code * loaded * step_v).collect(),
                codes
                    .iter()
                    .map(|code| code.clamp(-reach, reach) * step_v)
                    .collect(),
            ],
            buffered: true,
            glitch_v: sheet.value(Quantity::DriveGlitch) * step_v,
            before: DRIVE_MID_CODE,
        }
    }

    /// With its buffer or without, from now on.
    pub(crate) fn buffer(&mut self, on: bool) {
        self.buffered = on;
    }

    /// Volts at the exciter while `code` is held; codes above the last act as the last.
    pub(crate) fn volt(&mut self, code: u16) -> f64 {
        let code = code.min(LAST_CODE);
        let before = std::mem::replace(&mut self.before, code);
        let turned = (code ^ before) & DRIVE_MID_CODE != 0;
        let glitch_v = if turned { self.glitch_v } else { 0.0 };
        self.volts[usize::from(self.buffered)][usize::from(code)] + glitch_v
    }
}

/// Share of its swing that a source of `source_ohm` keeps against the network at the pin.
fn loaded(source_ohm: f64, bias_ohm: f64) -> f64 {
    bias_ohm / (bias_ohm + source_ohm)
}

/// Codes from mid-scale that the pin really has, by code.
fn pin_codes(sheet: Sheet, random: &mut ChaCha12Rng) -> Vec<f64> {
    let mut within = |size: f64| size * random.random_range(-1.0..=1.0);
    let gain = 1.0 + within(sheet.value(Quantity::DriveGain));
    let offset = within(sheet.value(Quantity::DriveOffset));
    let carry = sheet.value(Quantity::DriveCarry);
    let mut weights: Vec<f64> = (1..UNEQUAL_BITS)
        .map(|bit| within(carry * 0.5_f64.powf(f64::from(bit) / 2.0)))
        .collect();
    weights.insert(0, carry + weights.iter().sum::<f64>());
    let bow = sheet.value(Quantity::DriveBow);
    let beside = |code: u16| -> f64 {
        let set = |bit: &usize| code >> (11 - bit) & 1 == 1;
        (0..weights.len()).filter(set).map(|bit| weights[bit]).sum()
    };
    let slope = beside(LAST_CODE) / f64::from(LAST_CODE);
    // The line through mid-scale, so that the offset alone is what rest has.
    let rest = beside(DRIVE_MID_CODE) - slope * MID_CODE;
    (0..=LAST_CODE)
        .map(|code| {
            let x = (f64::from(code) - MID_CODE) / MID_CODE;
            let bowed = bow * (x * x - x * x * x * x) * 4.0;
            let bits = beside(code) - slope * f64::from(code) - rest;
            (x * MID_CODE + bowed + bits) * gain + offset
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ideal_codes_span_the_whole_range() {
        let mut ideal = DriveConverter::new(Sheet::new(0.0), 10.0, 1);
        // 10 V for +2048 codes: one code is 10/2048 V.
        for (code, volt) in [(2048, 0.0), (0, -10.0), (4095, 10.0 - 10.0 / 2048.0)] {
            for buffered in [false, true] {
                ideal.buffer(buffered);
                assert_eq!(ideal.volt(code), volt);
            }
        }
        assert_eq!(ideal.volt(u16::MAX), ideal.volt(4095));
    }

    /// Behind 13 kOhm 50 kOhm leave 79 %, twice 1 MOhm all but 2.5 %. With the buffer nothing is lost but the
    /// ends.
    #[test]
    fn the_bias_network_divides_what_comes_without_buffer() {
        let mut drive = DriveConverter::new(Sheet::new(1.0), 10.0, 1);
        let mut swing = |buffered, away: u16| {
            drive.buffer(buffered);
            drive.volt(2048 + away) - drive.volt(2048 - away)
        };
        let (without, with) = (swing(false, 1000), swing(true, 1000));
        // The glitch is not divided: a tenth of a code in 2000.
        assert!((without / with - 0.9747).abs() < 2e-4);
        assert!((loaded(13.0e3, 50.0e3) - 0.794).abs() < 1e-3);
        // 2000 codes of 4.88 mV, within the gain error and some codes of the curve.
        assert!((with / 9.7656 - 1.0).abs() < 0.02, "{with}");
        // 0.2 V of 1.65 V are 12 % of 10 V at either end.
        assert!((swing(true, 2040) / 2.0 - 8.788).abs() < 0.001);
    }

    #[test]
    fn rest_is_the_offset_and_turning_the_largest_bit_rings() {
        let mut drive = DriveConverter::new(Sheet::new(1.0), 10.0, 3);
        let step_v = 10.0 / 2048.0;
        let (rising, rest) = (drive.volt(2047), drive.volt(2048));
        let held = drive.volt(2048);
        assert!(held.abs() <= 8.0 * step_v);
        assert!((rest - held - 0.1 * step_v).abs() < 1e-9);
        // A code, the step of 2 beside the line, and the first glitch.
        assert!((held - rising).abs() < 4.0 * step_v);
    }
}
