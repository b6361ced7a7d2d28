//! The oscillator sampled: the bilinear mapping and its difference equation.
//!
//! # Source
//! ISO 16063-43:2015 (18) to (22), Note 1 of 7.3.1 on pre-warping.

use super::oscillator::Oscillator;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// How the s-plane is mapped to the z-plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mapping {
    /// `s -> (2/T) (1 - z^-1)/(1 + z^-1)`; frequencies are warped.
    Bilinear,
    /// Bilinear transform with w0/tan(w0 T/2) for 2/T: exact at the resonance.
    BilinearPrewarped,
}

impl Mapping {
    /// The factor K of `s -> K (1 - z^-1)/(1 + z^-1)`, rad/s.
    pub fn factor(self, f0_hz: f64, sample_rate_hz: f64) -> f64 {
        match self {
            Self::Bilinear => 2.0 * sample_rate_hz,
            Self::BilinearPrewarped => {
                let omega = TAU * f0_hz;
                omega / (omega / (2.0 * sample_rate_hz)).tan()
            }
        }
    }

    /// The mapping in words and symbols, which 9.2 demands beside b, c1, c2.
    pub fn formula(self) -> &'static str {
        match self {
            Self::Bilinear => "s -> (2/T) (1 - z^-1)/(1 + z^-1)",
            Self::BilinearPrewarped => {
                "s -> w0/tan(w0 T/2) (1 - z^-1)/(1 + z^-1), pre-warped at f0"
            }
        }
    }
}

/// Parameters of `x_k = -c1 x_(k-1) - c2 x_(k-2) + b (a_k + 2 a_(k-1) + a_(k-2))`.
///
/// They hold for one sample rate and one mapping only.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Discrete {
    /// Input factor.
    pub b: f64,
    /// First feedback factor.
    pub c1: f64,
    /// Second feedback factor.
    pub c2: f64,
}

impl Discrete {
    /// Samples an oscillator (20).
    pub fn new(oscillator: &Oscillator, sample_rate_hz: f64, mapping: Mapping) -> Self {
        let k = mapping.factor(oscillator.f0_hz, sample_rate_hz);
        let omega = TAU * oscillator.f0_hz / k;
        let (square, damping) = (omega * omega, 2.0 * oscillator.delta * omega);
        let sum = 1.0 + damping + square;
        Self {
            b: oscillator.s0 * square / sum,
            c1: 2.0 * (square - 1.0) / sum,
            c2: (1.0 - damping + square) / sum,
        }
    }

    /// Output for an input that was zero before the record (8.4.2).
    pub fn respond(&self, input: &[f64]) -> Vec<f64> {
        let numerator = [self.b, 2.0 * self.b, self.b];
        run(numerator, [self.c1, self.c2], input)
    }
}

/// Runs `y_k = n0 u_k + n1 u_(k-1) + n2 u_(k-2) - d1 y_(k-1) - d2 y_(k-2)`.
pub fn run(numerator: [f64; 3], denominator: [f64; 2], input: &[f64]) -> Vec<f64> {
    let (mut u1, mut u2, mut y1, mut y2) = (0.0, 0.0, 0.0, 0.0);
    input
        .iter()
        .map(|&u| {
            let y = numerator[0] * u + numerator[1] * u1 + numerator[2] * u2
                - denominator[0] * y1
                - denominator[1] * y2;
            (u2, u1, y2, y1) = (u1, u, y1, y);
            y
        })
        .collect()
}
