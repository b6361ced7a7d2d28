//! Values of a fitted oscillator as an answer states them.

use super::fit::Fitted;
use super::model::{HIGHPASS, HYSTERESIS, LINEAR, SATURATION, SECOND_MODE, TERMS, places};
use crate::answer::Estimate;
use std::collections::BTreeMap;

/// Values of the terms, by name.
pub(super) fn term_parameters(
    fit: &Fitted,
) -> BTreeMap<&'static str, BTreeMap<&'static str, Estimate>> {
    let mut at = LINEAR;
    let mut all = BTreeMap::new();
    for &term in &fit.terms {
        let mut values = BTreeMap::new();
        for (name, place) in TERMS[term].parameters.iter().zip(places(term)) {
            values.insert(*name, estimate(fit, place, at));
            at += 1;
        }
        all.insert(TERMS[term].name, values);
    }
    all
}

/// A value of a term, from its place and its row in the covariance matrix.
fn estimate(fit: &Fitted, place: usize, row: usize) -> Estimate {
    let (value, c) = (fit.values[place], &fit.covariance);
    let u = c[(row, row)].sqrt();
    if place == SECOND_MODE + 1 {
        // Fitted as ln of the ratio to w0, which is fitted itself.
        let mode_hz = (fit.values[0] + value).exp() / std::f64::consts::TAU;
        let variance = c[(row, row)] + c[(0, 0)] + 2.0 * c[(0, row)];
        return Estimate {
            value: mode_hz,
            u: mode_hz * variance.max(0.0).sqrt(),
        };
    }
    let scaled = |value: f64, slope: f64| Estimate {
        value,
        u: slope.abs() * u,
    };
    match place {
        SATURATION => scaled(1.0 / value, 1.0 / (value * value)),
        HIGHPASS => scaled(value / std::f64::consts::TAU, 1.0 / std::f64::consts::TAU),
        _ if place == HYSTERESIS + 1 => scaled(value.exp(), value.exp()),
        _ => scaled(value, 1.0),
    }
}

/// Resonance, damping, gain and offset.
pub(super) fn linear_parameters(fit: &Fitted) -> BTreeMap<&'static str, Estimate> {
    let u = |i: usize| fit.covariance[(i, i)].sqrt();
    let resonance = fit.values[0].exp() / std::f64::consts::TAU;
    BTreeMap::from([
        (
            "resonance_hz",
            Estimate {
                value: resonance,
                u: resonance * u(0),
            },
        ),
        (
            "delta",
            Estimate {
                value: fit.values[1],
                u: u(1),
            },
        ),
        (
            "gain",
            Estimate {
                value: fit.values[2],
                u: u(2),
            },
        ),
        (
            "offset",
            Estimate {
                value: fit.values[3],
                u: u(3),
            },
        ),
    ])
}
