//! Numbers of the command line.

use std::str::FromStr;

/// A finite number above zero.
pub(crate) fn positive<T: FromStr + Into<f64> + Copy>(text: &str) -> Result<T, String> {
    let finite = |value: &T| (*value).into().is_finite() && (*value).into() > 0.0;
    text.parse()
        .ok()
        .filter(finite)
        .ok_or_else(|| "must be a number above zero".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_positive_number_is_refused() {
        assert_eq!(positive::<f32>("1.5e3"), Ok(1500.0));
        // 1e39 is beyond f32, 1e-400 rounds to zero.
        for text in ["0", "-1", "nan", "inf", "1e39", "1e-400", "", "1,5", "x"] {
            assert!(positive::<f32>(text).is_err(), "{text}");
        }
    }
}
