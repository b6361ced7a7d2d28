//! The reference value: weighted mean, its consistency, and what if it fails.

use crate::statistics;
use schemars::JsonSchema;
use serde::Serialize;

/// Reference value of a comparison.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReferenceValue {
    /// Mean, weighted with 1/(u^2 + tau^2).
    pub value: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
    /// Chi-squared of the results about their weighted mean.
    pub chi2: f64,
    /// Degrees of freedom, results minus one.
    pub degrees_of_freedom: usize,
    /// Probability of a larger chi-squared if the results are consistent.
    pub p_value: f64,
    /// `p_value` is at least 5 %.
    pub consistent: bool,
    /// Standard deviation between laboratories, tau; zero if consistent.
    pub between_laboratories: f64,
    /// Weight of each result; they sum to one.
    #[serde(skip)]
    pub weights: Vec<f64>,
}

/// Chi-squared probability below which results are inconsistent.
const SIGNIFICANCE: f64 = 0.05;

/// Treatment of results that fail the chi-squared test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnFailure {
    /// Add a variance between laboratories (Mandel and Paule).
    MandelPaule,
    /// Keep the weighted mean and only say so.
    Keep,
}

/// Weighted mean of `values` with standard uncertainties `u`.
///
/// Both slices have the same length, at least 1, and every `u` is above zero.
///
/// # Accuracy
/// Test `mandel_paule_examples`.
pub fn reference_value(values: &[f64], u: &[f64], on_failure: OnFailure) -> ReferenceValue {
    let plain = weighted(values, u, 0.0);
    let chi2 = sum_of_squares(values, u, plain.0, 0.0);
    let degrees_of_freedom = values.len() - 1;
    let p_value = match degrees_of_freedom {
        0 => 1.0,
        n => statistics::chi_squared_survival(chi2, n as f64),
    };
    let consistent = p_value >= SIGNIFICANCE;
    let variance = match consistent || on_failure == OnFailure::Keep {
        true => 0.0,
        false => between_variance(values, u),
    };
    let (value, standard_uncertainty, weights) = weighted(values, u, variance);
    ReferenceValue {
        value,
        standard_uncertainty,
        chi2,
        degrees_of_freedom,
        p_value,
        consistent,
        between_laboratories: variance.sqrt(),
        weights,
    }
}

/// Mean, standard uncertainty and weights for a variance between laboratories.
fn weighted(values: &[f64], u: &[f64], variance: f64) -> (f64, f64, Vec<f64>) {
    let raw: Vec<f64> = u.iter().map(|u| 1.0 / (u * u + variance)).collect();
    let sum: f64 = raw.iter().sum();
    let weights: Vec<f64> = raw.iter().map(|weight| weight / sum).collect();
    let mean = weights.iter().zip(values).map(|(w, x)| w * x).sum();
    (mean, (1.0 / sum).sqrt(), weights)
}

fn sum_of_squares(values: &[f64], u: &[f64], mean: f64, variance: f64) -> f64 {
    values
        .iter()
        .zip(u)
        .map(|(x, u)| (x - mean).powi(2) / (u * u + variance))
        .sum()
}

/// The variance at which chi-squared equals its degrees of freedom, by
/// bisection: chi-squared falls monotonically with it.
fn between_variance(values: &[f64], u: &[f64]) -> f64 {
    let wanted = values.len() as f64 - 1.0;
    let excess = |variance: f64| {
        let (mean, ..) = weighted(values, u, variance);
        sum_of_squares(values, u, mean, variance) - wanted
    };
    let spread = statistics::standard_deviation(values).powi(2);
    // Twice the variance of the values always brings chi-squared below n - 1.
    let (mut low, mut high) = (0.0, 2.0 * spread);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        match excess(middle) > 0.0 {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mandel_paule_examples() {
        // The two examples of the R package metRology (mpaule).
        let x = [201.533, 216.55];
        let u = [0.154 / 6.0_f64.sqrt(), 0.25 / 2.0_f64.sqrt()];
        let result = reference_value(&x, &u, OnFailure::MandelPaule);
        assert!((result.value - 209.040_591_119).abs() < 1e-8);
        assert!((result.standard_uncertainty - 7.508_499_945).abs() < 1e-8);
        assert!((result.between_laboratories.powi(2) - 112.737_543_167).abs() < 1e-7);
        assert!((result.chi2 - 6406.06).abs() < 0.005);
        let (mean, u_mean, _) = weighted(&x, &u, 0.0);
        assert!((mean - 203.219_156_219).abs() < 1e-8);
        assert!((u_mean - 0.059_235_536_3).abs() < 1e-10);

        let x = [27.044, 26.022, 26.340, 26.787, 26.796];
        let u = [3e-3_f64, 76e-3, 464e-3, 3e-3, 14e-3].map(f64::sqrt);
        let result = reference_value(&x, &u, OnFailure::MandelPaule);
        assert!(!result.consistent);
        assert!((result.chi2 - 22.631_075).abs() < 1e-6);
        assert!((result.p_value - 1.5e-4).abs() < 0.5e-5);
        assert!((result.value - 26.712_128_748).abs() < 1e-8);
        assert!((result.standard_uncertainty - 0.171_136_964).abs() < 1e-8);
        assert!((result.between_laboratories.powi(2) - 0.105_219_388).abs() < 1e-8);
        let (mean, u_mean, _) = weighted(&x, &u, 0.0);
        assert!((mean - 26.886_919_754).abs() < 1e-8);
        assert!((u_mean - 0.036_432_149_7).abs() < 1e-9);
        // U(D) = 2 sqrt(u^2 - u_ref^2) against the weighted mean.
        assert!((x[0] - mean - 0.157_080).abs() < 1e-6);
        let expanded = 2.0 * (u[0] * u[0] - u_mean * u_mean).sqrt();
        assert!((expanded - 0.081_797).abs() < 1e-6);
    }
}
