//! Numbers as people type them.

use std::str::FromStr;

/// A finite number.
///
/// # Errors
/// Why the text is no finite number.
pub fn finite<T: FromStr + Into<f64> + Copy>(text: &str) -> Result<T, String> {
    read(text).ok_or_else(|| format!("must be a number{}", hint(text)))
}

/// A finite number above zero.
///
/// # Errors
/// Why the text is no number above zero.
pub fn positive<T: FromStr + Into<f64> + Copy>(text: &str) -> Result<T, String> {
    let above = |value: &T| (*value).into() > 0.0;
    let value = read(text).filter(above);
    value.ok_or_else(|| format!("must be a number above zero{}", hint(text)))
}

fn read<T: FromStr + Into<f64> + Copy>(text: &str) -> Option<T> {
    let finite = |value: &T| (*value).into().is_finite();
    text.trim().parse().ok().filter(finite)
}

/// The usual slip of those who write it otherwise.
fn hint(text: &str) -> &'static str {
    match text.trim().replacen(',', ".", 1).parse::<f64>() {
        Ok(_) if text.contains(',') => ", written 12.5 with a point",
        Ok(value) if value.is_nan() => ", not NaN",
        Ok(value) if value.is_infinite() => " that is finite",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_refused_with_what_is_wanted() {
        assert_eq!(finite::<f64>(" -1.5e3 "), Ok(-1500.0));
        // 1e39 is beyond f32.
        for (text, said) in [
            ("nan", "must be a number, not NaN"),
            ("-inf", "must be a number that is finite"),
            ("1e400", "must be a number that is finite"),
            ("1e39", "must be a number"),
            ("", "must be a number"),
            ("9,8", "must be a number, written 12.5 with a point"),
            ("1,000,000", "must be a number"),
        ] {
            assert_eq!(finite::<f32>(text), Err(said.to_owned()), "{text}");
        }
    }

    #[test]
    fn what_is_no_positive_number_is_refused() {
        assert_eq!(positive::<f32>("1.5e3"), Ok(1500.0));
        // 1e-400 rounds to zero.
        for text in ["0", "-1", "nan", "inf", "1e39", "1e-400", "", "1,5", "x"] {
            let said = positive::<f32>(text).expect_err(text);
            assert!(
                said.starts_with("must be a number above zero"),
                "{text}: {said}"
            );
        }
    }
}
