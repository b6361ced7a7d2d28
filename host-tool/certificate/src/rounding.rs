//! Rounding of results: two digits of U, the value to the same digit.
//!
//! U is rounded to two significant digits, to the nearest; it is rounded up
//! instead when the nearest number would make it smaller by more than 5 %
//! (practice of GUM 7.2.6). The value is then rounded to the digit U ends at,
//! so a reader sees no digit that carries no information.

use serde::Serialize;

/// A value and its expanded uncertainty, rounded together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Rounded {
    /// Value, rounded to the last digit of the uncertainty.
    pub value: f64,
    /// Expanded uncertainty, rounded to two digits.
    #[serde(rename = "expanded_uncertainty")]
    pub uncertainty: f64,
    /// Digits after the decimal point of both; never negative.
    pub decimals: usize,
}

impl Rounded {
    /// Rounds `value` with its expanded `uncertainty` (same unit).
    ///
    /// `None` when the uncertainty is not finite and positive or the value is
    /// not finite: such a result is not reportable.
    ///
    /// # Accuracy
    /// Tests `uncertainty_keeps_two_digits` and `value_ends_at_the_digit_of_u`.
    pub fn new(value: f64, uncertainty: f64) -> Option<Self> {
        let (uncertainty, digit) = round_uncertainty(uncertainty, 2)?;
        if !value.is_finite() {
            return None;
        }
        Some(Self {
            value: at_digit(value, digit),
            uncertainty,
            decimals: usize::try_from(digit).unwrap_or(0),
        })
    }
}

/// Rounds an expanded uncertainty to `digits` significant digits.
///
/// Returns the rounded number and the position of its last digit (2 means
/// hundredths, -1 means tens); `None` when it is not finite and positive.
///
/// # Accuracy
/// Test `rounding_never_loses_more_than_five_percent`.
pub fn round_uncertainty(uncertainty: f64, digits: i32) -> Option<(f64, i32)> {
    // Below this the powers of ten used here leave the range of f64.
    if !uncertainty.is_finite() || uncertainty < 1.0e-290 {
        return None;
    }
    let digit = digits - 1 - uncertainty.log10().floor() as i32;
    let nearest = at_digit(uncertainty, digit);
    let rounded = if nearest < 0.95 * uncertainty {
        at_digit(nearest + 10.0_f64.powi(-digit), digit)
    } else {
        nearest
    };
    // 0.0996 becomes 0.10, not 0.100.
    let carried = rounded.log10() >= f64::from(digits - digit) - 1.0e-9;
    Some((rounded, if carried { digit - 1 } else { digit }))
}

/// `value` rounded at a digit: 2 means hundredths, -1 means tens.
fn at_digit(value: f64, digit: i32) -> f64 {
    // Dividing by a whole power of ten keeps 0.3 what a person reads as 0.3.
    let scale = 10.0_f64.powi(digit.abs());
    if digit >= 0 {
        (value * scale).round() / scale
    } else {
        (value / scale).round() * scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn uncertainty_keeps_two_digits() {
        // Worked by hand: input, rounded, last digit.
        let cases = [
            (0.031_84, 0.032, 3),
            (0.0996, 0.10, 2),
            (0.099_49, 0.099, 3),
            (1.049, 1.0, 1),
            (9.96, 10.0, 0),
            (123.0, 120.0, -1),
            (996.0, 1000.0, -2),
            (0.84, 0.84, 2),
        ];
        for (input, rounded, digit) in cases {
            assert_eq!(
                round_uncertainty(input, 2),
                Some((rounded, digit)),
                "{input}"
            );
        }
    }

    #[test]
    fn value_ends_at_the_digit_of_u() {
        let rounded = Rounded::new(10.183_44, 0.031_84).expect("reportable");
        assert_eq!(
            (rounded.value, rounded.uncertainty, rounded.decimals),
            (10.183, 0.032, 3)
        );
        let rounded = Rounded::new(98_765.4, 123.0).expect("reportable");
        assert_eq!(
            (rounded.value, rounded.uncertainty, rounded.decimals),
            (98_770.0, 120.0, 0)
        );
    }

    #[test]
    fn one_digit_is_rounded_up_when_it_would_lose_more_than_five_percent() {
        // 1.4 to the nearest is 1 and loses 29 %; 2.05 to 2 loses 2.4 %.
        assert_eq!(round_uncertainty(1.4, 1), Some((2.0, 0)));
        assert_eq!(round_uncertainty(2.05, 1), Some((2.0, 0)));
    }

    #[test]
    fn what_is_not_positive_and_finite_is_not_reportable() {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Rounded::new(1.0, bad), None, "{bad}");
        }
        assert_eq!(Rounded::new(f64::NAN, 0.1), None);
    }

    proptest! {
        #[test]
        fn rounding_never_loses_more_than_five_percent(
            mantissa in 1.0_f64..10.0, exponent in -12_i32..6, digits in 1_i32..4,
        ) {
            let uncertainty = mantissa * 10.0_f64.powi(exponent);
            let (rounded, digit) = round_uncertainty(uncertainty, digits).expect("positive");
            // The slack is f64 rounding of the products.
            prop_assert!(rounded >= 0.95 * uncertainty * (1.0 - 1.0e-12));
            // At most one unit of the last digit away, the carry being coarser.
            prop_assert!((rounded - uncertainty).abs() <= 10.0_f64.powi(-digit));
        }
    }
}
