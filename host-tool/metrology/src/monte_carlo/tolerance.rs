//! Numerical tolerances (GUM-S1 7.9.2).

/// Half a unit of the last of `digits` significant digits.
///
/// # Source
/// GUM-S1 7.9.2: u = c 10^l with an integer c of that many digits,
/// delta = 10^l / 2.
pub fn numerical_tolerance(standard_uncertainty: f64, digits: u32) -> f64 {
    let written = format!("{standard_uncertainty:.*e}", digits.max(1) as usize - 1);
    let exponent: i32 = written
        .split('e')
        .nth(1)
        .and_then(|text| text.parse().ok())
        .unwrap_or(0);
    0.5 * 10.0_f64.powi(exponent - (digits.max(1) as i32 - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_half_of_the_last_digit() {
        // Examples of GUM-S1 7.9.2: 0.000 35 g to two digits and one digit.
        assert!((numerical_tolerance(0.000_35, 2) - 0.000_005).abs() < 1e-18);
        assert!((numerical_tolerance(0.000_35, 1) - 0.000_05).abs() < 1e-18);
        assert!((numerical_tolerance(2.0, 2) - 0.05).abs() < 1e-15);
        assert!((numerical_tolerance(0.998, 2) - 0.05).abs() < 1e-15);
    }
}
