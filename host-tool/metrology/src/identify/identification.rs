//! Result of an identification.

use crate::oscillator::Oscillator;
use schemars::JsonSchema;
use serde::Serialize;

/// How the points are weighted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Weighting {
    /// Inverse of the full covariance of (7).
    Covariance,
    /// All real and imaginary parts of the inverse response alike.
    None,
}

/// Distance of the points from the model (8.4.1, 9.2).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Deviation {
    /// Root mean square relative deviation of the magnitude.
    pub magnitude_rms_rel: f64,
    /// Largest relative deviation of the magnitude.
    pub magnitude_max_rel: f64,
    /// Root mean square deviation of the phase, degrees.
    pub phase_rms_deg: f64,
    /// Largest deviation of the phase, degrees.
    pub phase_max_deg: f64,
}

/// Identified parameters with their uncertainties and tests.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Identification {
    /// S0, f0 and delta.
    #[serde(flatten)]
    pub oscillator: Oscillator,
    /// Electromechanical conversion factor `S0 w0^2`.
    pub rho: f64,
    /// Standard uncertainty of S0.
    #[serde(rename = "standard_uncertainty_s0")]
    pub u_s0: f64,
    /// Standard uncertainty of f0, Hz.
    #[serde(rename = "standard_uncertainty_f0_hz")]
    pub u_f0_hz: f64,
    /// Standard uncertainty of delta.
    #[serde(rename = "standard_uncertainty_delta")]
    pub u_delta: f64,
    /// Standard uncertainty of rho.
    #[serde(rename = "standard_uncertainty_rho")]
    pub u_rho: f64,
    /// Correlation matrix of (S0, f0, delta).
    pub correlation: [[f64; 3]; 3],
    /// Weighting used.
    pub weighting: Weighting,
    /// Frequencies used.
    pub frequencies: usize,
    /// Minimum of the weighted sum of squares; `None` without uncertainties.
    pub chi2: Option<f64>,
    /// Degrees of freedom, 2 L - 3.
    pub degrees_of_freedom: usize,
    /// Largest chi-squared the test accepts (37).
    pub chi2_limit: Option<f64>,
    /// Probability of a larger chi-squared if model and uncertainties hold.
    pub p_value: Option<f64>,
    /// Outcome of the test; `None` when it cannot be made.
    pub consistent: Option<bool>,
    /// Distance of the points from the model.
    pub deviation: Deviation,
    /// Advice of 8.3 and warnings.
    pub warnings: Vec<String>,
    /// Inverse parameters mu and the linear estimator, for Monte Carlo.
    #[serde(skip)]
    pub(super) estimator: Estimator,
}

/// The linear map from inverse responses to mu.
#[derive(Clone, Debug)]
pub(super) struct Estimator {
    /// For each point the 3x2 block of `(D^T V^-1 D)^-1 D^T V^-1`.
    pub blocks: Vec<nalgebra::Matrix3x2<f64>>,
}
