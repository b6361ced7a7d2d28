//! Logarithm and sine without branches, so that eight run as one.
//!
//! The library's functions are more general and cannot be vectorised; these
//! hold only on the intervals the generators use.

use std::f64::consts::{LN_2, TAU};

/// 2^52 as a bit pattern: integers below 2^52 in its mantissa are exact.
const EXACT_INTEGERS: u64 = 0x4330_0000_0000_0000;

/// Natural logarithm of a normal number in 2^-1022 to 2.
///
/// # Equation
/// x = 2^e m with m in sqrt(1/2) .. sqrt(2); ln m = 2 artanh((m-1)/(m+1)) by
/// its series to the 19th power.
///
/// # Accuracy
/// Truncation below (0.1716)^20 / 21 = 2e-17 relative; test
/// `logarithm_and_sine_match_the_library`.
#[inline(always)]
pub(super) fn ln(x: f64) -> f64 {
    let bits = x.to_bits();
    // Adding the distance from sqrt(1/2) to 1 moves the border of the binade.
    let shifted = bits.wrapping_add(0x3FF0_0000_0000_0000 - 0x3FE6_A09E_667F_3BCD);
    let exponent = shifted >> 52;
    let mantissa = (shifted & 0x000F_FFFF_FFFF_FFFF).wrapping_add(0x3FE6_A09E_667F_3BCD);
    let m = f64::from_bits(mantissa);
    let e = f64::from_bits(EXACT_INTEGERS | exponent) - (4_503_599_627_370_496.0 + 1023.0);
    let s = (m - 1.0) / (m + 1.0);
    let z = s * s;
    let series = polynomial(
        z,
        [
            1.0,
            1.0 / 3.0,
            1.0 / 5.0,
            1.0 / 7.0,
            1.0 / 9.0,
            1.0 / 11.0,
            1.0 / 13.0,
            1.0 / 15.0,
            1.0 / 17.0,
            1.0 / 19.0,
        ],
    );
    e.mul_add(LN_2, 2.0 * s * series)
}

/// Cosine and sine of `turn` whole turns, `turn` in 0 .. 1.
///
/// # Accuracy
/// Taylor series on an eighth of a turn, truncation below 1e-17; test
/// `logarithm_and_sine_match_the_library`.
#[inline(always)]
pub(super) fn cos_sin_turn(turn: f64) -> (f64, f64) {
    // Adding 1.5 * 2^52 rounds to the nearest integer in the mantissa.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    let rounded = 4.0 * turn + ROUND;
    let quadrant = rounded.to_bits();
    let x = (turn - 0.25 * (rounded - ROUND)) * TAU;
    let z = x * x;
    let sin = x * polynomial(
        z,
        [
            1.0,
            -1.0 / 6.0,
            1.0 / 120.0,
            -1.0 / 5040.0,
            1.0 / 362_880.0,
            -1.0 / 39_916_800.0,
            1.0 / 6_227_020_800.0,
            -1.0 / 1_307_674_368_000.0,
        ],
    );
    let cos = polynomial(
        z,
        [
            1.0,
            -0.5,
            1.0 / 24.0,
            -1.0 / 720.0,
            1.0 / 40_320.0,
            -1.0 / 3_628_800.0,
            1.0 / 479_001_600.0,
            -1.0 / 87_178_291_200.0,
            1.0 / 20_922_789_888_000.0,
        ],
    );
    // Odd quadrants swap; quadrants 1, 2 negate the cosine and 2, 3 the sine.
    let odd = 0u64.wrapping_sub(quadrant & 1);
    let (c, s) = (cos.to_bits(), sin.to_bits());
    let cos_sign = (quadrant ^ (quadrant >> 1)) << 63;
    let sin_sign = (quadrant >> 1) << 63;
    (
        f64::from_bits(((c & !odd) | (s & odd)) ^ cos_sign),
        f64::from_bits(((s & !odd) | (c & odd)) ^ sin_sign),
    )
}

/// Horner's rule, lowest coefficient first. The fused product is exact in its
/// rounding on every machine, so results do not depend on the instruction set.
#[inline(always)]
fn polynomial<const N: usize>(z: f64, coefficients: [f64; N]) -> f64 {
    let mut sum = coefficients[N - 1];
    for coefficient in coefficients[..N - 1].iter().rev() {
        sum = sum.mul_add(z, *coefficient);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithm_and_sine_match_the_library() {
        for step in 1..20_000u32 {
            let x = f64::from(step) / 20_000.0;
            let scale = x.ln().abs().max(1.0e-3);
            assert!((ln(x) - x.ln()).abs() < 4.0e-16 * scale.max(1.0), "ln {x}");
            let (cos, sin) = cos_sin_turn(x);
            // The library rounds 2 pi x first: up to 2 pi * 2^-53 = 7e-16.
            let (expected_cos, expected_sin) = ((TAU * x).cos(), (TAU * x).sin());
            assert!((cos - expected_cos).abs() < 1.0e-15, "cos {x}: {cos}");
            assert!((sin - expected_sin).abs() < 1.0e-15, "sin {x}: {sin}");
        }
        assert!((ln(2.0_f64.powi(-52)) + 52.0 * LN_2).abs() < 1.0e-14);
        assert_eq!(ln(1.0), 0.0);
    }
}
