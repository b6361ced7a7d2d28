//! Filters forwards and backwards, with the uncertainty of every sample.

use super::model::Model;
use crate::discrete::{Discrete, Mapping, run};
use crate::oscillator::Oscillator;
use calib_files::{Error, Result};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::{PI, SQRT_2};

/// Quantity to compute.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Samples per second, Hz.
    pub sample_rate_hz: f64,
    /// Mapping of the s-plane.
    pub mapping: Mapping,
    /// Standard uncertainty of each sample of the record, independent from
    /// sample to sample, in the record's unit.
    pub u_sample: f64,
    /// Cut-off frequency of the inverse filter, Hz.
    pub cutoff_hz: f64,
}

/// A signal with its standard uncertainty.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Estimate {
    /// Samples.
    pub values: Vec<f64>,
    /// Standard uncertainty of each sample: parameters and noise.
    #[serde(rename = "standard_uncertainties")]
    pub u_values: Vec<f64>,
    /// Inverse only: what the low-pass filter takes from the signal, found by
    /// filtering the estimate once more; not part of `u_values`. At corners
    /// of the signal it is too small by a factor of up to four.
    pub regularisation_error: Option<Vec<f64>>,
}

/// Output of the transducer for an acceleration record.
///
/// # Accuracy
/// Parameter part to first order; test `predicted_uncertainty_is_that_of_monte_carlo`.
pub fn predict_output(model: &Model, acceleration: &[f64], request: &Request) -> Estimate {
    estimate(model, acceleration, request, |oscillator, values| {
        Discrete::new(oscillator, request.sample_rate_hz, request.mapping).respond(values)
    })
}

/// Acceleration behind an output record.
///
/// # Errors
/// A cut-off frequency outside 0 .. half the sample rate.
///
/// # Accuracy
/// Test `the_input_is_found_again`.
pub fn estimate_input(model: &Model, output: &[f64], request: &Request) -> Result<Estimate> {
    let low_pass = LowPass::new(request)?;
    let mut result = estimate(model, output, request, |oscillator, values| {
        let discrete = Discrete::new(oscillator, request.sample_rate_hz, request.mapping);
        low_pass.inverse(&discrete, values)
    });
    let again = low_pass.zero_phase(&result.values);
    result.regularisation_error = Some(
        result
            .values
            .iter()
            .zip(&again)
            .map(|(once, twice)| once - twice)
            .collect(),
    );
    Ok(result)
}

/// Runs a linear filter and propagates parameters and white noise.
fn estimate(
    model: &Model,
    record: &[f64],
    request: &Request,
    filter: impl Fn(&Oscillator, &[f64]) -> Vec<f64>,
) -> Estimate {
    let values = filter(&model.oscillator, record);
    let slopes: Vec<Vec<f64>> = (0..3).map(|n| slope(model, n, record, &filter)).collect();
    let noise = request.u_sample * noise_gain(record.len(), |u| filter(&model.oscillator, u));
    let u_values = (0..values.len())
        .map(|k| {
            let gradient = Vector3::new(slopes[0][k], slopes[1][k], slopes[2][k]);
            let variance = gradient.dot(&(model.covariance * gradient));
            (variance.max(0.0) + noise * noise).sqrt()
        })
        .collect();
    Estimate {
        values,
        u_values,
        regularisation_error: None,
    }
}

/// Derivative of the filtered record by one parameter, central difference.
fn slope(
    model: &Model,
    parameter: usize,
    record: &[f64],
    filter: &impl Fn(&Oscillator, &[f64]) -> Vec<f64>,
) -> Vec<f64> {
    if model.covariance[(parameter, parameter)] == 0.0 {
        return vec![0.0; record.len()];
    }
    let changed = |by: f64| {
        let mut o = model.oscillator;
        match parameter {
            0 => o.s0 += by,
            1 => o.f0_hz += by,
            _ => o.delta += by,
        }
        filter(&o, record)
    };
    let own = match parameter {
        0 => model.oscillator.s0,
        1 => model.oscillator.f0_hz,
        _ => model.oscillator.delta,
    };
    let step = 1.0e-5 * own.abs();
    changed(step)
        .iter()
        .zip(changed(-step))
        .map(|(high, low)| (high - low) / (2.0 * step))
        .collect()
}

/// Root of the sum of squares of the impulse response.
fn noise_gain(count: usize, filter: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
    let count = count.clamp(64, 65_536);
    let mut impulse = vec![0.0; count];
    impulse[count / 2] = 1.0;
    filter(&impulse).iter().map(|h| h * h).sum::<f64>().sqrt()
}

/// Second-order Butterworth low-pass filter, bilinear and pre-warped.
struct LowPass {
    gain: f64,
    feedback: [f64; 2],
}

impl LowPass {
    fn new(request: &Request) -> Result<Self> {
        let half = request.sample_rate_hz / 2.0;
        if !request.cutoff_hz.is_finite() || request.cutoff_hz <= 0.0 || request.cutoff_hz >= half {
            return Err(Error::usage(
                format!("cut-off {} Hz is outside 0 .. {half} Hz", request.cutoff_hz),
                "choose it above the signal and below the resonance",
            ));
        }
        let w = (PI * request.cutoff_hz / request.sample_rate_hz).tan();
        let sum = 1.0 + SQRT_2 * w + w * w;
        Ok(Self {
            gain: w * w / sum,
            feedback: [2.0 * (w * w - 1.0) / sum, (1.0 - SQRT_2 * w + w * w) / sum],
        })
    }

    fn forward(&self, values: &[f64]) -> Vec<f64> {
        run(
            [self.gain, 2.0 * self.gain, self.gain],
            self.feedback,
            values,
        )
    }

    fn backward(&self, mut values: Vec<f64>) -> Vec<f64> {
        values.reverse();
        let mut filtered = self.forward(&values);
        filtered.reverse();
        filtered
    }

    fn zero_phase(&self, values: &[f64]) -> Vec<f64> {
        self.backward(self.forward(values))
    }

    /// `(1 + c1 z^-1 + c2 z^-2) / (b (1 + z^-1)^2)` times the filter: its
    /// numerator `g (1 + z^-1)^2` cancels the double pole at z = -1.
    fn inverse(&self, discrete: &Discrete, values: &[f64]) -> Vec<f64> {
        let scale = self.gain / discrete.b;
        let numerator = [scale, scale * discrete.c1, scale * discrete.c2];
        self.backward(run(numerator, self.feedback, values))
    }
}
