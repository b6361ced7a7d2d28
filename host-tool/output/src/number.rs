//! Numbers of records are f32: what a person would write of them, not their binary tail.

use serde::Serializer;

/// The decimal number a person would write for an f32: 31.5, not 31.499999.
pub fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::NAN)
}

/// The value, unless it is infinite or NaN.
pub(crate) fn finite(value: f32) -> Option<f32> {
    value.is_finite().then_some(value)
}

/// A relative value in percent: 10.71 of the f32 nearest to 0.1071, not 10.709999999999999.
pub fn percent(relative: f32) -> f64 {
    format!("{relative}e2")
        .parse()
        .unwrap_or(f64::from(relative))
}

/// An angle in degrees, to the nine digits that tell any f32 from its neighbours.
pub fn degrees(angle_rad: f32) -> f64 {
    shortened(f64::from(angle_rad).to_degrees(), 9)
}

/// The decimal number of so many digits nearest to a computed one, whose binary tail
/// says nothing.
pub fn shortened(value: f64, digits: usize) -> f64 {
    let decimals = digits.saturating_sub(1);
    format!("{value:.decimals$e}").parse().unwrap_or(value)
}

/// A number with this many decimals; zero has no sign.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    match text.strip_prefix('-') {
        Some(zero) if is_zero => zero.to_owned(),
        _ => text,
    }
}

/// For `serialize_with`: an angle that is kept in radians, stated in degrees.
///
/// # Errors
/// Those of the writer.
pub fn rad_as_deg<S: Serializer>(angle_rad: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(angle_rad.to_degrees())
}

/// [`rad_as_deg`] of an angle that may be missing.
///
/// # Errors
/// Those of the writer.
pub fn maybe_rad_as_deg<S: Serializer>(
    angle_rad: &Option<f64>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    match angle_rad {
        Some(angle_rad) => rad_as_deg(angle_rad, serializer),
        None => serializer.serialize_none(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stored_numbers_have_no_binary_tail() {
        assert_eq!(decimal(31.5).to_string(), "31.5");
        assert_eq!(decimal(0.1).to_string(), "0.1");
        // 0.1071 * 100 is 10.709999999999999 in f64.
        assert_eq!(percent(0.1071).to_string(), "10.71");
        assert_eq!(percent(1.0e-7).to_string(), "0.00001");
        assert_eq!(percent(f32::INFINITY), f64::INFINITY);
        assert_eq!(fixed(-0.004, 2), "0.00");
        assert_eq!(fixed(-0.04, 2), "-0.04");
        // 28.64788975654116 degrees.
        assert_eq!(degrees(-0.5), -28.647_889_8);
    }
}
