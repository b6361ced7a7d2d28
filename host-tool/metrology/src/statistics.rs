//! Quantiles of the distributions a budget needs.

use statrs::distribution::{ChiSquared, ContinuousCDF, Normal, StudentsT};

/// Degrees of freedom above which Student's t is the normal distribution to
/// better than 1e-8 in the coverage factor.
const NORMAL_FROM: f64 = 1.0e9;

/// Coverage probability of `mean +- k standard deviations` of a normal
/// distribution: 0.9545 for k = 2.
pub fn normal_probability(coverage_factor: f64) -> f64 {
    1.0 - 2.0 * Normal::standard().cdf(-coverage_factor)
}

/// Two-sided coverage factor of a normal distribution.
pub fn normal_factor(probability: f64) -> f64 {
    -Normal::standard().inverse_cdf(0.5 * (1.0 - probability))
}

/// Two-sided coverage factor of Student's t; `degrees_of_freedom` may be
/// fractional or infinite.
///
/// # Accuracy
/// Relative error below 1e-9, test `student_factors_match_the_table`.
///
/// # Source
/// GUM G.3.2.
pub fn student_factor(probability: f64, degrees_of_freedom: f64) -> f64 {
    if degrees_of_freedom > NORMAL_FROM {
        return normal_factor(probability);
    }
    let Ok(student) = StudentsT::new(0.0, 1.0, degrees_of_freedom) else {
        return f64::NAN;
    };
    // Bisection on the survival function: the library's quantile (0.19.1) is off by 6e-5 at 1e6
    // degrees of freedom, by half at 1e7, and does not end at 1e8.
    let tail = 0.5 * (1.0 - probability);
    let (mut low, mut high) = (0.0_f64, 2.0_f64);
    while student.sf(high) > tail {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        match student.sf(middle) > tail {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

/// Quantile of the chi-squared distribution.
pub fn chi_squared_quantile(probability: f64, degrees_of_freedom: f64) -> f64 {
    ChiSquared::new(degrees_of_freedom).map_or(f64::NAN, |law| law.inverse_cdf(probability))
}

/// Probability that chi-squared exceeds `value`.
pub fn chi_squared_survival(value: f64, degrees_of_freedom: f64) -> f64 {
    ChiSquared::new(degrees_of_freedom).map_or(f64::NAN, |law| law.sf(value))
}

/// Arithmetic mean; NaN for nothing.
pub fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Experimental standard deviation (n - 1); NaN below two values.
pub fn standard_deviation(values: &[f64]) -> f64 {
    let centre = mean(values);
    let squares: f64 = values.iter().map(|value| (value - centre).powi(2)).sum();
    (squares / (values.len() as f64 - 1.0)).sqrt()
}

/// Angles moved by whole turns to within half a turn of their mean direction, degrees: what
/// averages and scatters of angles are taken of. 179.9 and -179.9 are 0.2 degrees apart.
pub(crate) fn unwrapped_deg(angles_deg: &[f64]) -> Vec<f64> {
    let sum = |of: fn(f64) -> f64| -> f64 { angles_deg.iter().map(|a| of(a.to_radians())).sum() };
    let middle = sum(f64::sin).atan2(sum(f64::cos)).to_degrees();
    let near = |angle: &f64| middle + wrapped_deg(angle - middle);
    angles_deg.iter().map(near).collect()
}

/// An angle in [-180, 180], degrees; one that lies there is left as it is.
pub(crate) fn wrapped_deg(angle_deg: f64) -> f64 {
    match angle_deg.abs() <= 180.0 {
        true => angle_deg,
        false => angle_deg - 360.0 * (angle_deg / 360.0).round(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn student_factors_match_the_table() {
        // Two-sided quantiles, printed to six digits in tables of Student's t.
        let at_95 = [
            (1.0, 12.7062),
            (2.0, 4.30265),
            (4.0, 2.77645),
            (5.0, 2.57058),
            (9.0, 2.26216),
            (10.0, 2.22814),
            (18.0, 2.10092),
            (20.0, 2.08596),
            (50.0, 2.00856),
            (100.0, 1.98397),
            (f64::INFINITY, 1.95996),
        ];
        for (degrees_of_freedom, factor) in at_95 {
            let got = student_factor(0.95, degrees_of_freedom);
            assert!(
                (got / factor - 1.0).abs() < 4.0e-6,
                "{degrees_of_freedom}: {got}"
            );
        }
        let at_9545 = [
            (2.0, 4.52655),
            (4.0, 2.86932),
            (9.0, 2.31981),
            (20.0, 2.13303),
            (100.0, 2.02531),
        ];
        for (degrees_of_freedom, factor) in at_9545 {
            let got = student_factor(0.9545, degrees_of_freedom);
            assert!(
                (got / factor - 1.0).abs() < 4.0e-6,
                "{degrees_of_freedom}: {got}"
            );
        }
        // One degree of freedom is a Cauchy law: tan(pi p / 2) exactly.
        let exact = (std::f64::consts::FRAC_PI_2 * 0.95).tan();
        assert!((student_factor(0.95, 1.0) / exact - 1.0).abs() < 1.0e-9);
    }

    #[test]
    fn chi_squared_matches_its_closed_form_at_two_degrees() {
        // With two degrees of freedom the survival function is exp(-x / 2).
        assert!((chi_squared_survival(3.0, 2.0) - (-1.5f64).exp()).abs() < 1.0e-12);
        let quantile = -2.0 * 0.025f64.ln();
        assert!((chi_squared_quantile(0.975, 2.0) / quantile - 1.0).abs() < 1.0e-6);
    }
}
