//! An input converter: from volts at its connector to the mean code of a trigger's conversions.

use std::f64::consts::TAU;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::shape::{CELL, MID_CODE};
use super::{Quantity, Shape, Sheet};
use crate::rig_port::Conversions;

/// Frequency of the reference's ripple, Hz: 1 kHz of a host whose clock is 30 ppm off.
const RIPPLE_HZ: f64 = 1_000.03;

/// The code nearest to `code`, saturating at both ends.
pub(crate) fn nearest_code(code: f64) -> u16 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped"
    )]
    {
        // What is outside becomes the first or the last one.
        (code + 0.5) as u16
    }
}

/// One unit's converter of one channel.
#[derive(Debug, Clone)]
pub(crate) struct InputConverter {
    code_per_v: f64,
    /// Noise of one conversion, codes r.m.s.
    noise_codes: f64,
    offset_codes: f64,
    gain: f64,
    ripple_codes: f64,
    crosstalk: f64,
    settling_ns: f64,
    /// Code beside the line, by code, as the mean over the noise of a conversion; empty if ideal.
    curve: Vec<f32>,
    /// Values that follow from how it is set: conversions of a trigger, their noise, and what is left in them of
    /// the trigger before.
    count: f64,
    own_noise_rms_v: f64,
    kept: f64,
    /// Of the trigger before, V.
    before_v: f64,
}

impl InputConverter {
    /// Converter of `channel` in the unit of this number.
    pub(crate) fn new(
        sheet: Sheet,
        shape: Shape,
        full_scale_peak_v: f64,
        unit: u64,
        channel: u64,
    ) -> Self {
        let mut random = ChaCha12Rng::seed_from_u64(unit);
        random.set_stream(channel);
        let mut within = |quantity| sheet.value(quantity) * random.random_range(-1.0..=1.0);
        let (offset_codes, gain_error) =
            (within(Quantity::InputOffset), within(Quantity::InputGain));
        let noise_codes = sheet.value(Quantity::InputNoise);
        let curve = match sheet.is_ideal() {
            true => Vec::new(),
            false => smoothed(&shape.curve(sheet, &mut random), noise_codes),
        };
        let mut converter = Self {
            code_per_v: MID_CODE / full_scale_peak_v,
            noise_codes,
            offset_codes,
            gain: 1.0 + gain_error,
            ripple_codes: sheet.value(Quantity::InputRipple),
            crosstalk: sheet.value(Quantity::InputCrosstalk),
            settling_ns: sheet.value(Quantity::InputSettling),
            curve,
            count: 1.0,
            own_noise_rms_v: 0.0,
            kept: 0.0,
            before_v: 0.0,
        };
        converter.set(Conversions::default());
        converter
    }

    /// The converter is set so from now on.
    pub(crate) fn set(&mut self, conversions: Conversions) {
        self.count = f64::from(conversions.count);
        self.own_noise_rms_v = self.noise_codes / self.code_per_v / self.count.sqrt();
        self.kept = match self.settling_ns {
            0.0 => 0.0,
            settling_ns => (-(conversions.sampling_ns as f64) / settling_ns).exp(),
        };
    }

    /// Noise of a sample, V r.m.s. That of the signal, `signal_rms_v`, has passed the anti-alias filter and is
    /// the same for all conversions of a trigger; each of them adds its own.
    pub(crate) fn noise_rms_v(&self, signal_rms_v: f64) -> f64 {
        signal_rms_v.hypot(self.own_noise_rms_v)
    }

    /// The mean code of a trigger's conversions, each with its volts of `dither_v` added; without dither they
    /// are alike.
    pub(crate) fn code(&mut self, input: Input, dither_v: &[f64]) -> u16 {
        let volt = input.volt + self.crosstalk * input.other_v + self.unsettled_v(input.volt);
        let ripple = match self.ripple_codes {
            0.0 => 0.0,
            peak => peak * input.ripple,
        };
        let line = volt * self.code_per_v * self.gain + self.offset_codes + ripple;
        let middle = MID_CODE + line;
        if dither_v.is_empty() {
            return self.nearest(middle);
        }
        let code_per_v = self.code_per_v * self.gain;
        let each = dither_v
            .iter()
            .map(|volt| u32::from(self.nearest(middle + volt * code_per_v)));
        nearest_code(f64::from(each.sum::<u32>()) / dither_v.len() as f64)
    }

    fn nearest(&self, code: f64) -> u16 {
        match self.curve.get(usize::from(nearest_code(code))) {
            Some(&beside) => nearest_code(code + f64::from(beside)),
            None => nearest_code(code),
        }
    }

    /// Part of the sample before in the first conversion: its capacitor was charged to that.
    fn unsettled_v(&mut self, volt: f64) -> f64 {
        let before_v = std::mem::replace(&mut self.before_v, volt);
        match self.kept {
            0.0 => 0.0,
            kept => (before_v - volt) * kept / self.count,
        }
    }
}

/// Signals at an input converter at a trigger.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Input {
    /// Mean over the conversions of the trigger with its noise, V.
    pub(crate) volt: f64,
    /// Voltage of the other channel, V.
    pub(crate) other_v: f64,
    /// Of the reference both channels see, of its peak: [`ripple`].
    pub(crate) ripple: f64,
}

/// Ripple of the reference at an instant, of its peak.
pub(crate) fn ripple(time_s: f64) -> f64 {
    (TAU * RIPPLE_HZ * time_s).sin()
}

/// The curve at every code, its steps as wide as the noise that goes over them.
fn smoothed(cells: &[[f64; 2]], noise_codes: f64) -> Vec<f32> {
    let mut curve: Vec<f64> = cells
        .iter()
        .flat_map(|&[first, last]| {
            (0..CELL).map(move |code| first + (last - first) * code as f64 / CELL as f64)
        })
        .collect();
    let width = (5.0 * noise_codes).ceil().min(CELL as f64 / 2.0) as isize;
    for (edge, pair) in cells.windows(2).enumerate() {
        let step = pair[1][0] - pair[0][1];
        let at = ((edge + 1) * CELL) as isize;
        for offset in -width..width {
            // Share of the conversions on the other side, within 0.01 of the normal law.
            let distance = (offset as f64 + 0.5).abs() / noise_codes.max(1e-9);
            let share = 1.0 / (1.0 + (1.702 * distance).exp());
            let other = if offset < 0 { step } else { -step };
            curve[(at + offset) as usize] += other * share;
        }
    }
    curve.into_iter().map(|code| code as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn converter(factor: f64, unit: u64) -> InputConverter {
        InputConverter::new(Sheet::new(factor), Shape::Bits, 5.0, unit, 0)
    }

    fn quiet(volt: f64) -> Input {
        Input {
            volt,
            other_v: 0.0,
            ripple: 0.0,
        }
    }

    #[test]
    fn an_ideal_converter_rounds_to_the_nearest_code_and_saturates() {
        let mut ideal = converter(0.0, 1);
        let step = 10.0 / 65_536.0;
        for (volt, code) in [
            (0.0, 32_768),
            (0.49 * step, 32_768),
            (0.51 * step, 32_769),
            (-0.51 * step, 32_767),
            (5.0, 65_535),
            (-7.0, 0),
        ] {
            assert_eq!(ideal.code(quiet(volt), &[]), code, "{volt}");
        }
    }

    /// A unit is what it is; another is another; both stay within what the table says in sum.
    #[test]
    fn a_unit_keeps_its_curve_and_the_table_bounds_it() {
        let (one, again, other) = (converter(1.0, 1), converter(1.0, 1), converter(1.0, 2));
        assert_eq!(one.curve, again.curve);
        assert_ne!(one.curve, other.curve);
        for unit in 0..50 {
            let peak = |worst: f32, code: &f32| worst.max(code.abs());
            let worst = converter(1.0, unit).curve.iter().fold(0.0, peak);
            // Bow 4; bits: seven geometric steps of 3 sum up to less than 7, twice, and 3.
            assert!(worst > 1.0 && worst < 21.0, "unit {unit}: {worst}");
        }
    }

    /// Far from the edge, the step at mid-scale is the table's.
    #[test]
    fn mid_scale_has_its_step() {
        for unit in 0..10 {
            let curve = converter(1.0, unit).curve;
            let step = curve[32_768 + 60] - curve[32_768 - 60];
            // The bow's slope of at most 4 * 2.6 / 32 768 a code over 120 codes, and the line's.
            assert!((step.abs() - 3.0).abs() < 0.1, "unit {unit}: {step}");
        }
    }

    #[test]
    fn many_conversions_have_less_noise_and_a_short_one_remembers() {
        let mut one = converter(1.0, 1);
        // 6.53 codes of 152.6 uV, and as much of the signal.
        let own_v = 996.4e-6;
        assert!((one.noise_rms_v(0.0) / own_v - 1.0).abs() < 1e-3);
        one.set(Conversions {
            count: 16,
            ..Conversions::default()
        });
        assert!((one.noise_rms_v(0.0) / own_v - 0.25).abs() < 1e-3);
        assert!((one.noise_rms_v(own_v) / own_v - 1.0308).abs() < 1e-3);
        // 50 ns are 3.42 time constants of 14.6 ns: 3.3 % of the step stay.
        one.set(Conversions {
            count: 1,
            apart_ps: 0,
            sampling_ns: 50,
        });
        one.code(quiet(0.0), &[]);
        let short = f64::from(one.code(quiet(1.0), &[]));
        let long = f64::from(one.code(quiet(1.0), &[]));
        assert!(((long - short) / 6553.6 - 0.0326).abs() < 0.001);
    }

    /// The wall of 20 codes makes 12.7 codes of a sine of 930 codes, 1.37 %; spread over 8575 codes either way it
    /// is a slope of 10 / 8575, 0.117 %, at any level.
    #[test]
    fn dither_turns_a_wall_into_a_slope() {
        let dither_v: Vec<f64> = (0..328)
            .map(|nth| 1.308 * ((f64::from(nth) + 0.5) / 164.0 - 1.0))
            .collect();
        for (peak_v, dither_v, expected, within) in [
            (0.1419, &[][..], 12.73 / 930.0, 5e-4),
            (0.1419, &dither_v[..], 10.0 / 8575.0, 5e-5),
            (0.01419, &dither_v[..], 10.0 / 8575.0, 5e-4),
        ] {
            let sheet = Sheet::new(1e-9);
            let mut wall = InputConverter::new(sheet, Shape::Wall, 5.0, 1, 0);
            (wall.offset_codes, wall.gain) = (0.0, 1.0);
            let mut sum = 0.0;
            for nth in 0..5000 {
                let sine = (TAU * f64::from(nth) / 5000.0).sin();
                sum += sine * f64::from(wall.code(quiet(peak_v * sine), dither_v));
            }
            let gain = sum / 2500.0 / (peak_v * MID_CODE / 5.0) - 1.0;
            assert!((gain.abs() - expected).abs() < within, "{peak_v}: {gain}");
        }
    }
}
