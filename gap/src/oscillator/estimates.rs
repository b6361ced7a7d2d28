//! Values of a fitted oscillator as an answer states them.

use super::fit::Fitted;
use super::model::TERMS;
use super::parameters::{LINEAR, Parameter};
use crate::answer::Estimate;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Values of the terms as the vocabulary defines them, by name.
pub(super) fn term_parameters(
    fit: &Fitted,
    interval_s: f64,
) -> BTreeMap<&'static str, BTreeMap<&'static str, Estimate>> {
    let mut row = LINEAR.len();
    let mut all = BTreeMap::new();
    for term in fit.terms.iter().map(|t| &TERMS[*t]) {
        let mut values = BTreeMap::new();
        for (stated, parameter) in term.entry.parameters.iter().zip(term.values) {
            values.insert(stated.name, estimate(fit, *parameter, row, interval_s));
            row += 1;
        }
        all.insert(term.entry.id, values);
    }
    all
}

/// A value of a term in the unit it is stated in; `row` is its row in the covariance matrix.
fn estimate(fit: &Fitted, parameter: Parameter, row: usize, interval_s: f64) -> Estimate {
    let (value, c) = (fit.values[parameter], &fit.covariance);
    let variance = c[(row, row)];
    // A value that is fitted as its logarithm is known relatively.
    let relative = |value: f64, variance: f64| (value, value * variance.max(0.0).sqrt());
    let (value, u) = match parameter {
        Parameter::ModeLnRatio => {
            // Fitted as ln of the ratio to w0, which is fitted itself.
            let mode_hz = fit.values.resonance_hz() * value.exp();
            relative(mode_hz, variance + c[(0, 0)] + 2.0 * c[(0, row)])
        }
        Parameter::QuadraticDamping | Parameter::CubicDamping => {
            // Stated relative to the linear damping, 2 delta, which is fitted itself.
            let linear = 2.0 * fit.values[Parameter::Delta];
            let (own, of_delta) = (1.0 / linear, -2.0 * value / (linear * linear));
            let variance = own * own * variance
                + of_delta * of_delta * c[(1, 1)]
                + 2.0 * own * of_delta * c[(1, row)];
            (value / linear, variance.max(0.0).sqrt())
        }
        Parameter::SteadyForce => {
            // Stated at the input, over the gain that is fitted itself.
            let gain = fit.values[Parameter::Gain];
            let offset = value / gain;
            let variance = variance + offset * offset * c[(2, 2)] - 2.0 * offset * c[(2, row)];
            (offset, variance.max(0.0).sqrt() / gain.abs())
        }
        Parameter::Trend | Parameter::ResonanceDrift => {
            (value / interval_s, variance.sqrt() / interval_s)
        }
        Parameter::Delay => (value * interval_s, variance.sqrt() * interval_s),
        Parameter::LnYieldDeflection => relative(value.exp(), variance),
        Parameter::Saturation | Parameter::Clipping => {
            (1.0 / value, variance.sqrt() / (value * value))
        }
        Parameter::Lag => relative(1.0 / (TAU * value * interval_s), variance / (value * value)),
        Parameter::HighpassCorner => (value / TAU, variance.sqrt() / TAU),
        _ => (value, variance.sqrt()),
    };
    Estimate { value, u }
}

/// Resonance, damping, gain and offset; no gain where nothing drives the oscillator.
pub(super) fn linear_parameters(fit: &Fitted, driven: bool) -> BTreeMap<&'static str, Estimate> {
    let of = |parameter: Parameter, row: usize| Estimate {
        value: fit.values[parameter],
        u: fit.covariance[(row, row)].sqrt(),
    };
    let resonance_hz = fit.values.resonance_hz();
    let ln_resonance = of(Parameter::LnResonance, 0);
    let resonance = Estimate {
        value: resonance_hz,
        u: resonance_hz * ln_resonance.u,
    };
    let mut values = BTreeMap::from([
        ("resonance_hz", resonance),
        ("delta", of(Parameter::Delta, 1)),
        ("offset", of(Parameter::Offset, 3)),
    ]);
    if driven {
        values.insert("gain", of(Parameter::Gain, 2));
    }
    values
}
