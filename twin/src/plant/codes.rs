//! Codes and volts of an ideal input converter.

use crate::converters::{MID_CODE, nearest_code};
use crate::rig::Converter;

/// Code of an ideal 16-bit converter for `volt`: the nearest, saturating at both ends.
pub(super) fn input_code(converter: &Converter, volt: f64) -> u16 {
    nearest_code(MID_CODE + volt * (MID_CODE / converter.input_full_scale_peak_v))
}

/// Volts of `code`.
pub(super) fn input_v(converter: &Converter, code: u16) -> f64 {
    (f64::from(code) - MID_CODE) * (converter.input_full_scale_peak_v / MID_CODE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rig::Rig;

    #[test]
    fn input_codes_round_to_nearest_and_saturate() {
        let converter = Rig::standard().converter;
        let step = 10.0 / 65_536.0;
        for (volt, code) in [
            (0.0, 32_768),
            (0.49 * step, 32_768),
            (0.51 * step, 32_769),
            (-0.51 * step, 32_767),
            (5.0, 65_535),
            (-5.0, 0),
            (-7.0, 0),
            (f64::INFINITY, 65_535),
        ] {
            assert_eq!(input_code(&converter, volt), code, "{volt}");
        }
        for code in [0, 1, 32_768, 40_000, u16::MAX] {
            assert_eq!(input_code(&converter, input_v(&converter, code)), code);
        }
    }
}
