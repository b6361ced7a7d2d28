//! The mass-spring-damper model of a seismic transducer.
//!
//! # Equation
//! `H(f) = S0 w0^2 / (w0^2 + 2 i delta w0 w - w^2)`, `rho = S0 w0^2`.
//!
//! # Source
//! ISO 16063-43:2015 (1), (2), (14).

use nalgebra::{Complex, Matrix3, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Continuous-time parameters.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Oscillator {
    /// Sensitivity at low frequencies, output per m/s2.
    pub s0: f64,
    /// Resonance frequency without damping, Hz.
    pub f0_hz: f64,
    /// Damping coefficient, 1.
    pub delta: f64,
}

impl Oscillator {
    /// Electromechanical conversion factor `rho = S0 w0^2`.
    pub fn rho(&self) -> f64 {
        self.s0 * (TAU * self.f0_hz).powi(2)
    }

    /// Complex sensitivity at a frequency.
    pub fn response(&self, frequency_hz: f64) -> Complex<f64> {
        let ratio = frequency_hz / self.f0_hz;
        self.s0 / Complex::new(1.0 - ratio * ratio, 2.0 * self.delta * ratio)
    }

    /// Parameters from `mu = (w0^2/rho, 2 delta w0/rho, 1/rho)`; `None` when
    /// no resonance belongs to them.
    ///
    /// # Source
    /// ISO 16063-43 (13), (14). The printed (13) lacks the factor 2 of delta:
    /// with (4), mu2 / sqrt(mu1 mu3) = 2 delta.
    pub fn from_inverse(mu: &Vector3<f64>) -> Option<Self> {
        let possible = mu[0] > 0.0 && mu[2] > 0.0;
        possible.then(|| Self {
            s0: 1.0 / mu[0],
            f0_hz: (mu[0] / mu[2]).sqrt() / TAU,
            delta: mu[1] / (2.0 * (mu[0] * mu[2]).sqrt()),
        })
    }

    /// Derivatives of (S0, f0, delta) by mu: the rows of (15), with S0 for rho
    /// and f0 for w0.
    pub fn inverse_jacobian(mu: &Vector3<f64>) -> Matrix3<f64> {
        let f0 = (mu[0] / mu[2]).sqrt() / TAU;
        let root = (mu[0] * mu[2]).sqrt();
        let delta = mu[1] / (2.0 * root);
        Matrix3::new(
            -1.0 / (mu[0] * mu[0]),
            0.0,
            0.0,
            f0 / (2.0 * mu[0]),
            0.0,
            -f0 / (2.0 * mu[2]),
            -delta / (2.0 * mu[0]),
            1.0 / (2.0 * root),
            -delta / (2.0 * mu[2]),
        )
    }
}
