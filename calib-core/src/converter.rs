//! Width and scale of a board's converters.
//!
//! All are offset binary: 0 V is mid-scale. A *code* is what the converter itself counts, right
//! justified. A *sample* is the code of an input left justified in 16 bits, as the board delivers it:
//! [`MID_SAMPLE`] is 0 V on every board, and only the ends of the range and the step from one code to
//! the next depend on the width.

/// Sample of 0 V.
pub const MID_SAMPLE: u16 = 0x8000;

/// Samples from one end of the range to the other.
const SAMPLES: f32 = 65_536.0;

/// Samples at either end of an input's range that the dither of the front end takes
/// (docs/hardware.md): 8700 by its parts, 10 % more by their tolerance and that of the supply.
const DITHER_SAMPLES: u16 = 9600;

/// Width of a converter, and how much of its range a signal has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Width {
    bits: u8,
    /// Samples at either end that are dither's.
    dither_samples: u16,
}

impl Width {
    /// The width of a converter of 8 to 16 bits.
    ///
    /// # Panics
    /// Outside of that; in a constant the compiler says so.
    pub const fn of_bits(bits: u8) -> Self {
        assert!(8 <= bits && bits <= 16, "converters have 8 to 16 bits");
        Self {
            bits,
            dither_samples: 0,
        }
    }

    /// This width behind a front end that adds dither.
    ///
    /// A sample is then the mean of conversions that lie apart by the dither. Those of a signal that comes
    /// too near to an end are cut off one by one, long before their mean is the last code.
    pub const fn with_dither(self) -> Self {
        Self {
            dither_samples: DITHER_SAMPLES,
            ..self
        }
    }

    /// Bits of a code.
    pub const fn bits(self) -> u8 {
        self.bits
    }

    /// Code of 0 V.
    pub const fn mid_code(self) -> u16 {
        MID_SAMPLE >> self.spare_bits()
    }

    /// Highest code.
    pub const fn last_code(self) -> u16 {
        u16::MAX >> self.spare_bits()
    }

    /// Lowest sample of a signal: there and below conversions are cut off.
    pub const fn first_sample(self) -> u16 {
        self.dither_samples
    }

    /// Highest sample of a signal: there and above conversions are cut off.
    pub const fn last_sample(self) -> u16 {
        (u16::MAX << self.spare_bits()) - self.dither_samples
    }

    /// From the sample of one code to that of the next.
    pub const fn sample_step(self) -> u16 {
        1 << self.spare_bits()
    }

    /// Bits by which a sample is shifted to the left of its code.
    pub const fn spare_bits(self) -> u8 {
        16 - self.bits
    }
}

/// The converters of a board, and what stands before and behind them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Converters {
    /// Of both inputs.
    pub input: Width,
    /// Volts at the input connector for half of the input's range, peak.
    pub input_full_scale_peak_v: f32,
    /// Of the drive output.
    pub drive: Width,
    /// Volts at the exciter for half of the drive's range, peak.
    pub drive_full_scale_peak_v: f32,
}

impl Converters {
    /// The converters of an STM32H743 behind the front end of `docs/hardware.md`: -5 V to +5 V at the
    /// inputs, -10 V to +10 V at the exciter.
    pub const FIELD: Self = Self {
        input: Width::of_bits(16).with_dither(),
        input_full_scale_peak_v: 5.0,
        drive: Width::of_bits(12),
        drive_full_scale_peak_v: 10.0,
    };

    /// Volts at the input connector from one sample to the next.
    pub const fn volt_per_sample(&self) -> f32 {
        2.0 * self.input_full_scale_peak_v / SAMPLES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_and_samples_of_a_width_by_hand() {
        let sixteen = Width::of_bits(16);
        assert_eq!((sixteen.mid_code(), sixteen.last_code()), (32_768, 65_535));
        assert_eq!((sixteen.last_sample(), sixteen.sample_step()), (65_535, 1));
        let dithered = sixteen.with_dither();
        // 8700 and 10 %, 9570, rounded up to hundreds.
        assert_eq!(
            (dithered.first_sample(), dithered.last_sample()),
            (9600, 55_935)
        );
        // 14 bits: 8192 and 16 383 times 4.
        let fourteen = Width::of_bits(14);
        assert_eq!((fourteen.mid_code(), fourteen.last_code()), (8192, 16_383));
        assert_eq!(fourteen.mid_code() << 2, MID_SAMPLE);
        assert_eq!(
            (fourteen.last_sample(), fourteen.sample_step()),
            (65_532, 4)
        );
        let twelve = Width::of_bits(12);
        assert_eq!((twelve.mid_code(), twelve.last_code()), (2048, 4095));
    }

    #[test]
    fn a_sample_of_the_field_front_end_is_152_6_microvolts() {
        // docs/hardware.md: 10 V / 65 536.
        let step_v = Converters::FIELD.volt_per_sample();
        assert!((f64::from(step_v) - 152.587_890_6e-6).abs() < 1.0e-12);
    }
}
