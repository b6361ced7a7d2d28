//! How far the error shrinks on a record that took no part.

use super::fit::{Fitted, compared, descend_from, residual, rms};
use super::model::states;
use super::model_selection::{Step, names_of};
use super::parameters::Parameter;
use super::run::Run;
use super::simulate::{LINEAR_STATES, states_behind};
use super::slices;
use crate::dataset::{Dataset, Measured, Record};
use crate::error::GapError;
use crate::estimation::gap::{Gap, GapSize};
use crate::observable::Group;
use crate::thresholds;
use std::collections::BTreeMap;

/// The part to fit, and what takes no part: another record, or the last quarter of this one.
///
/// # Errors
/// `validate` holds points.
pub(super) fn parts(record: &Record, validate: Option<&Dataset>) -> Result<[Record; 2], GapError> {
    match validate.map(|v| &v.measured) {
        Some(Measured::Record(other)) => Ok([
            cut(record, 0, record.input.len().min(thresholds::MOST_FITTED)),
            other.clone(),
        ]),
        Some(Measured::Points { .. }) => Err(GapError::Usage(
            "--validate needs a record of an oscillator too".into(),
        )),
        None => {
            let (at, end) = (
                record.input.len() * thresholds::FITTED_QUARTERS / 4,
                record.input.len(),
            );
            Ok([
                cut(record, 0, at.min(thresholds::MOST_FITTED)),
                cut(record, at, end),
            ])
        }
    }
}

fn cut(record: &Record, from: usize, to: usize) -> Record {
    Record {
        interval_s: record.interval_s,
        before: record.before + from,
        input: record.input[from..to].to_vec(),
        output: record.output[from..to].to_vec(),
    }
}

/// Samples at the start of another record by which the state there is fitted.
const HEAD: usize = 400;
/// Samples that are looked at one after the other, with the steps on each. A few of them first:
/// over many periods a bent spring's phase has more than one solution.
const LOOKED_AT: [(usize, usize); 3] = [
    (thresholds::SETTLING / 4, 2),
    (thresholds::SETTLING / 2, 1),
    (thresholds::SETTLING, 3),
];

/// Simulation errors on another record, of which only the state at the start is fitted; `None`
/// where the simulation diverges. Where it goes on behind the one that was fitted, `part`, the linear
/// states go on too: left free a slow one would be another zero of the output.
fn validation(fit: &Fitted, part: &Run, record: &Run) -> Option<Vec<f64>> {
    let head = record.head(HEAD);
    let goes_on = record.before == part.before + part.input.len();
    let mut values = fit.values;
    let mut states = states(&fit.terms, &values, record);
    if goes_on {
        values = states_behind(&values, part)?;
        states.retain(|state| !LINEAR_STATES.contains(state));
    }
    states.iter().for_each(|state| values[*state] = 0.0);
    values.set_first_state(&head);
    // Until a delay is over, what drives it is the input of before, which is not known.
    let known = (fit.values[Parameter::Delay].ceil() as usize).min(head.output.len() / 2);
    for (count, steps) in LOOKED_AT {
        let samples = known..(known + count).min(head.output.len());
        let (place, _) = descend_from(values, &states, &head, samples, steps)?;
        values = place.values;
    }
    residual(&values, record)
}

/// Sum of squared errors on a record of which only the state at the start is fitted; infinite where
/// the simulation diverges.
pub(super) fn square_on(part: &Run, record: &Run, fit: &Fitted) -> f64 {
    validation(fit, part, record).map_or(f64::INFINITY, |errors| errors.iter().map(|e| e * e).sum())
}

/// Errors on the held-out record before and after, and what is stated of them.
pub(super) struct HeldOut {
    pub(super) gap: Gap,
    /// Simulation errors without and with the terms.
    pub(super) errors: [Vec<f64>; 2],
}

impl HeldOut {
    /// `None` if a simulation diverges on the held-out record.
    pub(super) fn new(steps: &[Step], part: &Run, held: &Run) -> Option<Self> {
        let last = &steps[steps.len() - 1];
        let errors = [
            validation(&steps[0].fit, part, held)?,
            validation(&last.fit, part, held)?,
        ];
        let [before, after] = [rms(&errors[0]), rms(&errors[1])];
        // The differences see the motion too where the record is sampled coarsely; noise is no
        // larger than what the errors' own past does not predict.
        let floor = noise_floor(held).min(unpredicted(&errors[1]));
        // The zero of the output is no motion, and nothing is relative to it.
        let moved = motion(&last.fit, held);
        let observable = GapSize::of_errors([before, after], floor, rms(&moved));
        let slices = slices::Errors {
            output: compared(&moved, held),
            before: &errors[0],
            after: &errors[1],
            noise: floor,
            interval_s: held.interval_s,
            resonance_hz: steps[0].fit.values.resonance_hz(),
            chosen: names_of(&last.fit),
            fitted_peak: peak(&motion(&last.fit, part)),
        };
        let (by_level, by_band) = (slices.by_level(), slices.by_band());
        let gap = Gap {
            size: observable,
            held_out_rows: errors[0].len(),
            chosen: names_of(&last.fit),
            rms_before: Some(before),
            rms_after: Some(after),
            by_observable: BTreeMap::from([(Group::Output, observable)]),
            by_level,
            by_band,
        };
        Some(Self { gap, errors })
    }
}

/// The output about its zero.
pub(super) fn motion(fit: &Fitted, record: &Run) -> Vec<f64> {
    let zero = fit.values[Parameter::Offset];
    record.output.iter().map(|output| output - zero).collect()
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

/// Root mean square of errors beyond what a linear prediction from their past takes out
/// (recursion of Levinson and Durbin).
fn unpredicted(errors: &[f64]) -> f64 {
    let past = thresholds::PAST.min(errors.len() / 4);
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
    use crate::estimation::significance::{normal_deviates, stream};

    /// x = 0.9 x' + w has the variance of w over 0.19; 20 000 samples know it to 1 %.
    #[test]
    fn only_the_new_part_of_a_first_order_process_is_not_predicted() {
        let mut x = 0.0;
        let process: Vec<f64> = normal_deviates(&mut stream(5), 20_000)
            .into_iter()
            .map(|w| {
                x = 0.9 * x + w;
                x
            })
            .collect();
        assert!((rms(&process) - 1.0 / 0.19_f64.sqrt()).abs() < 0.15);
        assert!((unpredicted(&process) - 1.0).abs() < 0.02);
    }
}
