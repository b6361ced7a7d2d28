//! Uncertainty of the parameters by propagation of distributions.

use super::fit::inverse_response;
use super::identification::Identification;
use super::points::Points;
use crate::monte_carlo::{Interval, Lanes, coverage_intervals};
use crate::oscillator::Oscillator;
use crate::statistics::{mean, standard_deviation};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

/// Distribution of one parameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Parameter {
    /// Mean.
    pub mean: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
    /// Shortest 95 % interval.
    pub interval_95: Interval,
}

/// Distributions of the parameters.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Spread {
    /// Trials drawn.
    pub trials: usize,
    /// Seed they were drawn with.
    pub seed: u64,
    /// Trials whose parameters were no oscillator, left out.
    pub failed: usize,
    /// Sensitivity at low frequencies.
    pub s0: Parameter,
    /// Resonance frequency, Hz.
    pub f0_hz: Parameter,
    /// Damping coefficient.
    pub delta: Parameter,
}

/// Draws magnitudes and phases from normal distributions and repeats the
/// weighted fit with the weights of the measured points.
///
/// Returns `None` when hardly any trial has a resonance.
///
/// # Source
/// ISO 16063-43 7.2.1; GUM-S1.
pub fn propagate(
    points: &Points,
    result: &Identification,
    trials: usize,
    seed: u64,
) -> Option<Spread> {
    let mut lanes = Lanes::new(seed, 0);
    let mut normal = vec![0.0; 2 * points.points.len()];
    let mut samples: [Vec<f64>; 3] = Default::default();
    for _ in 0..trials {
        lanes.fill_normal(&mut normal);
        let mu = drawn_mu(points, result, &normal);
        if let Some(drawn) = Oscillator::from_inverse(&mu) {
            for (list, value) in samples.iter_mut().zip([drawn.s0, drawn.f0_hz, drawn.delta]) {
                list.push(value);
            }
        }
    }
    let failed = trials - samples[0].len();
    if samples[0].len() < 100 {
        return None;
    }
    let [s0, f0_hz, delta] = samples.map(|mut values| parameter(&mut values));
    Some(Spread {
        trials,
        seed,
        failed,
        s0,
        f0_hz,
        delta,
    })
}

fn drawn_mu(points: &Points, result: &Identification, normal: &[f64]) -> Vector3<f64> {
    let mut mu = Vector3::zeros();
    let blocks = &result.estimator.blocks;
    for ((point, block), draw) in points.points.iter().zip(blocks).zip(normal.chunks(2)) {
        let magnitude = point.magnitude + point.u_magnitude * draw[0];
        let phase = point.phase_rad + point.u_phase_rad * draw[1];
        mu += block * inverse_response(magnitude, phase);
    }
    mu
}

fn parameter(values: &mut [f64]) -> Parameter {
    let (centre, deviation) = (mean(values), standard_deviation(values));
    let (_, shortest) = coverage_intervals(values, 0.95);
    Parameter {
        mean: centre,
        standard_uncertainty: deviation,
        interval_95: shortest,
    }
}
