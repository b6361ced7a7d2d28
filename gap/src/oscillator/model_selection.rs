//! How the sets of terms that were tried compare.

use super::fit::{Fitted, residual};
use super::lack_of_fit::Left;
use super::model::TERMS;
use super::parameters::Parameter;
use super::run::Run;
use crate::answer::{Cause, Estimate};
use crate::estimation::selection::{bootstrap, cost_of_cause, cost_of_parameter, probabilities};
use crate::thresholds;
use calib_effects::Of;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Sets of one size, and how they compare.
pub(super) struct Tried<'a> {
    sets: &'a [Fitted],
    /// Independent samples.
    samples: f64,
    /// Share by which squared errors may exceed the least and still count as equal.
    tied: f64,
}

/// A set among those of its size.
pub(super) struct Weighed<'a> {
    pub(super) fit: &'a Fitted,
    pub(super) probability: f64,
    /// -2 ln of the posterior probability above that of the best.
    pub(super) above_best: f64,
}

impl<'a> Tried<'a> {
    /// Sets of which the best leaves `left`.
    pub(super) fn new(sets: &'a [Fitted], left: &Left) -> Self {
        let noise = left.leaves_noise();
        Self {
            sets,
            samples: left.independent(left.samples),
            tied: if noise { 0.0 } else { thresholds::AS_GOOD },
        }
    }

    /// The sets, most probable first.
    pub(super) fn weighed(&self) -> Vec<Weighed<'a>> {
        let scores = self.scores(self.sets.iter(), self.sets.iter().map(|f| f.square));
        let least = scores.iter().copied().fold(f64::INFINITY, f64::min);
        let weighed = self.sets.iter().zip(probabilities(&scores)).zip(&scores);
        let mut list: Vec<Weighed<'a>> = weighed
            .map(|((fit, probability), score)| Weighed {
                fit,
                probability,
                above_best: score - least,
            })
            .collect();
        list.sort_by(|a, b| a.above_best.total_cmp(&b.above_best));
        list
    }

    /// -2 ln of the posterior probability of each set with its sum of squared errors.
    fn scores<'f>(
        &self,
        fits: impl Iterator<Item = &'f Fitted>,
        squares: impl Iterator<Item = f64> + Clone,
    ) -> Vec<f64> {
        let least = squares.clone().fold(f64::INFINITY, f64::min);
        let least = least * (1.0 + self.tied);
        let score = |(fit, square): (&Fitted, f64)| {
            let square = square.max(least).max(f64::MIN_POSITIVE);
            self.samples * square.ln() + cost_of_last(fit, self.samples)
        };
        fits.zip(squares).map(score).collect()
    }

    /// Sets that are worth listing. Errors are correlated over a few periods of the resonance: where
    /// samples are drawn again, `stretch` of them come together.
    pub(super) fn causes(&self, part: &Run, stretch: usize) -> Vec<Cause> {
        let mut listed = self.weighed();
        listed.retain(|w| w.probability >= thresholds::LISTED_PROBABILITY);
        listed.truncate(thresholds::MOST_CAUSES);
        let squares = listed.iter().map(|w| {
            let left = residual(&w.fit.values, part).unwrap_or_default();
            let stretches = left.chunks_exact(stretch.max(1));
            stretches.map(|s| s.iter().map(|r| r * r).sum()).collect()
        });
        let squares: Vec<Vec<f64>> = squares.collect();
        let stability = bootstrap(&squares, |sums| {
            self.scores(listed.iter().map(|w| w.fit), sums.into_iter())
        });
        let causes = listed.iter().zip(stability);
        causes
            .map(|(set, stability)| Cause {
                effects: names_of(set.fit),
                probability: set.probability,
                delta_bic: set.above_best,
                stability,
                stability_over_runs: None,
                cautions: Vec::new(),
                parameters: term_parameters(set.fit, part.interval_s),
            })
            .map(|cause| cause.with_cautions(Of::Oscillator))
            .collect()
    }
}

/// Cost of the last term of a set, in -2 ln of the posterior probability.
pub(super) fn cost_of_last(fit: &Fitted, samples: f64) -> f64 {
    fit.terms.last().map_or(0.0, |term| {
        let term = &TERMS[*term];
        let odds = if term.leading {
            1.0
        } else {
            thresholds::ODDS_OF_LEADING
        };
        let parameters = cost_of_parameter(samples.max(std::f64::consts::E));
        term.values.len() as f64 * parameters + cost_of_cause(odds * TERMS.len() as f64)
    })
}

/// Names of the terms of a fit.
pub(super) fn names_of(fit: &Fitted) -> Vec<&'static str> {
    fit.terms.iter().map(|t| TERMS[*t].entry.id).collect()
}

/// One step of a diagnosis that adds a term at a time.
pub(super) struct Step {
    pub(super) fit: Fitted,
    /// Residuals of the fit.
    pub(super) left: Left,
    /// The sets of its size that were tried and stand on what is held out.
    pub(super) tried: Vec<Fitted>,
}

impl Step {
    /// The sets of its size as what the fit leaves lets them compare.
    pub(super) fn compared(&self) -> Tried<'_> {
        Tried::new(&self.tried, &self.left)
    }
}

/// Values of the terms as the vocabulary defines them, by name.
fn term_parameters(
    fit: &Fitted,
    interval_s: f64,
) -> BTreeMap<&'static str, BTreeMap<&'static str, Estimate>> {
    let mut all = BTreeMap::new();
    for term in fit.terms.iter().map(|t| &TERMS[*t]) {
        let mut values = BTreeMap::new();
        for (stated, parameter) in term.entry.parameters.iter().zip(term.values) {
            values.insert(stated.name, estimate(fit, *parameter, interval_s));
        }
        all.insert(term.entry.id, values);
    }
    all
}

/// A value of a term in the unit it is stated in.
fn estimate(fit: &Fitted, parameter: Parameter, interval_s: f64) -> Estimate {
    let value = fit.values[parameter];
    let beside = |other| fit.covariance_of(other, parameter);
    let of = |other| fit.covariance_of(other, other);
    let variance = of(parameter);
    // A value that is fitted as its logarithm is known relatively.
    let relative = |value: f64, variance: f64| (value, value * variance.max(0.0).sqrt());
    let (value, u) = match parameter {
        Parameter::ModeLnRatio => {
            // Fitted as ln of the ratio to w0, which is fitted itself.
            let mode_hz = fit.values.resonance_hz() * value.exp();
            relative(
                mode_hz,
                variance + of(Parameter::LnResonance) + 2.0 * beside(Parameter::LnResonance),
            )
        }
        Parameter::QuadraticDamping | Parameter::CubicDamping => {
            // Stated relative to the linear damping, 2 delta, which is fitted itself.
            let linear = 2.0 * fit.values[Parameter::Delta];
            let (own, of_delta) = (1.0 / linear, -2.0 * value / (linear * linear));
            let variance = own * own * variance
                + of_delta * of_delta * of(Parameter::Delta)
                + 2.0 * own * of_delta * beside(Parameter::Delta);
            (value / linear, variance.max(0.0).sqrt())
        }
        Parameter::SteadyForce => {
            // Stated at the input, over the gain that is fitted itself.
            let gain = fit.values[Parameter::Gain];
            let offset = value / gain;
            let variance = variance + offset * offset * of(Parameter::Gain)
                - 2.0 * offset * beside(Parameter::Gain);
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
