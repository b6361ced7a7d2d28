//! How far the error shrinks on a record that took no part.

use super::across;
use super::fit::Fitted;
use super::residual::{compared, rms};
use super::run::Run;
use super::step::Step;
use super::validation::validation;
use super::weigh::names_of;
use crate::engine::gap::{Gap, ObservableGap, closed_share};
use std::collections::BTreeMap;

/// Errors on the held-out record before and after, and what is stated of them.
pub(super) struct Scored {
    pub(super) gap: Gap,
    /// Simulation errors without and with the terms.
    pub(super) errors: [Vec<f64>; 2],
}

impl Scored {
    /// `None` if a simulation diverges on the held-out record.
    pub(super) fn new(steps: &[Step], part: &Run, held: &Run) -> Option<Self> {
        let last = &steps[steps.len() - 1];
        let errors = [
            validation(&steps[0].fit, held)?,
            validation(&last.fit, held)?,
        ];
        let [before, after] = [rms(&errors[0]), rms(&errors[1])];
        // The differences see the motion too where the record is sampled coarsely; noise is no
        // larger than what the errors' own past does not predict.
        let floor = noise_floor(held).min(unpredicted(&errors[1]));
        let observable = observable([before, after], floor, rms(&held.output));
        let across = across::Errors {
            output: compared(&held.output),
            before: &errors[0],
            after: &errors[1],
            noise: floor,
            interval_s: held.interval_s,
            resonance_hz: resonance_hz(&steps[0].fit),
            chosen: names_of(&last.fit),
            fitted_peak: peak(&part.output),
        };
        let (by_level, by_band) = (across.by_level(), across.by_band());
        let gap = Gap {
            before_percent: observable.before_percent,
            after_percent: observable.after_percent,
            floor_percent: observable.floor_percent,
            closed: observable.closed,
            chi_before: observable.chi_before,
            chi_after: observable.chi_after,
            held_out_rows: errors[0].len(),
            chosen: names_of(&last.fit),
            rms_before: Some(before),
            rms_after: Some(after),
            by_observable: BTreeMap::from([("output", observable)]),
            by_level,
            by_band,
        };
        Some(Self { gap, errors })
    }
}

/// Gap of the output, r.m.s. before and after, beside its noise and its size.
fn observable([before, after]: [f64; 2], floor: f64, size: f64) -> ObservableGap {
    let percent = |e: f64| 100.0 * e / size;
    ObservableGap {
        before_percent: percent(before),
        after_percent: percent(after),
        floor_percent: percent(floor),
        closed: (before > floor).then(|| closed_share(before, after, floor)),
        chi_before: before / floor,
        chi_after: after / floor,
    }
}

/// Resonance of a fit.
pub(super) fn resonance_hz(fit: &Fitted) -> f64 {
    fit.values[0].exp() / std::f64::consts::TAU
}

/// Largest size.
pub(super) fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// Noise of the output from its fourth differences: what no smooth motion can follow.
fn noise_floor(record: &Run) -> f64 {
    // The resonance lies far below the sampling rate; differences of order 8
    // suppress it and amplify white noise by sqrt(C(16, 8)) = 113.4.
    let mut signal = record.output.clone();
    for _ in 0..8 {
        signal = signal.windows(2).map(|w| w[1] - w[0]).collect();
    }
    let mut sizes: Vec<f64> = signal.iter().map(|x| x.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes[sizes.len() / 2] / 0.6745 / 12_870_f64.sqrt()
}

/// Samples of the past from which the next error is predicted.
const PAST: usize = 40;

/// Root mean square of errors beyond what a linear prediction from their past takes out
/// (recursion of Levinson and Durbin).
fn unpredicted(errors: &[f64]) -> f64 {
    let past = PAST.min(errors.len() / 4);
    let product = |lag: usize| -> f64 {
        let pairs = errors[lag..].iter().zip(errors);
        pairs.map(|(a, b)| a * b).sum::<f64>() / errors.len() as f64
    };
    let products: Vec<f64> = (0..=past).map(product).collect();
    let (mut left, mut weights) = (products[0], Vec::<f64>::new());
    for order in 1..=past {
        let known = weights.iter().zip(products[1..order].iter().rev());
        let reflection = (products[order] - known.map(|(w, p)| w * p).sum::<f64>()) / left;
        let turned: Vec<f64> = weights.iter().rev().map(|w| w * reflection).collect();
        weights.iter_mut().zip(turned).for_each(|(w, t)| *w -= t);
        weights.push(reflection);
        left *= 1.0 - reflection * reflection;
        if left <= 0.0 || left.is_nan() {
            return 0.0;
        }
    }
    left.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::significance::Gauss;

    /// x = 0.9 x' + w has the variance of w over 0.19; 20 000 samples know it to 1 %.
    #[test]
    fn only_the_new_part_of_a_first_order_process_is_not_predicted() {
        let mut draw = Gauss::new(5);
        let mut x = 0.0;
        let process: Vec<f64> = (0..20_000)
            .map(|_| {
                x = 0.9 * x + draw.next();
                x
            })
            .collect();
        assert!((rms(&process) - 1.0 / 0.19_f64.sqrt()).abs() < 0.15);
        assert!((unpredicted(&process) - 1.0).abs() < 0.02);
    }
}
