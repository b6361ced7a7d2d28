//! Datasets of `kind = "oscillator"`: which term a linear oscillator lacks.
//!
//! ```text
//! model, terms      the terms, and what they do at one instant
//! parameters        values of a simulation: names, bounds, steps for slopes
//! run, mode         a record on a fine grid, and a linear oscillator driven by it
//! channel           what the channel of the output makes of the motion
//! simulate          the oscillator over a record
//! fit               the estimator's model: simulated against recorded output, in steps as fine as it takes
//! hold              what the input does between its samples
//! starts            where the fit of the oscillator, and of a term, begins
//! grow              one term at a time
//! lack_of_fit       what a fit leaves
//! model_selection   probabilities of the sets of terms
//! holdout, slices   errors on what was held out, and by level and band
//! answer            what an answer states: verdict, place, what next, values
//! ```

mod answer;
mod channel;
mod fit;
mod grow;
mod hold;
mod holdout;
mod lack_of_fit;
mod mode;
mod model;
mod model_selection;
mod parameters;
mod run;
mod simulate;
mod slices;
mod starts;
mod terms;

use crate::answer::{Answer, DatasetSummary};
use crate::dataset::{Dataset, Record};
use crate::error::GapError;
use crate::options::Options;
use answer::answer;
use hold::grown;
use holdout::{HeldOut, parts};
use run::{FEWEST_STEPS, Run};
use starts::linear;

/// Diagnoses a record by adding one term at a time.
pub(crate) fn diagnose(
    path: String,
    dataset: &Dataset,
    record: &Record,
    validate: Option<&Dataset>,
    options: &Options,
) -> Result<Answer, GapError> {
    let unusable = |problem: &str| GapError::Table {
        file: "record.csv",
        problem: problem.into(),
    };
    let oscillator = dataset.rig.oscillator;
    let resonance_hz = oscillator.resonance_hz.map(|q| q.value);
    let delta = oscillator.delta.map_or(0.05, |q| q.value);
    let [part, held] = parts(record, validate)?;
    let part = Run::new(&part, FEWEST_STEPS);
    let start = linear(&part, resonance_hz, delta)
        .ok_or_else(|| unusable("no linear oscillator fits the record at all"))?;
    let held = Run::new(&held, FEWEST_STEPS);
    let (steps, part) = grown(part, start, &held, options);
    let held = held.as_in(&part);
    let held_out = HeldOut::new(&steps, &part, &held)
        .ok_or_else(|| unusable("the oscillator diverges on the held-out record"))?;
    let summary = DatasetSummary {
        path,
        rows: record.input.len(),
        columns_used: vec!["time_s".into(), "input".into(), "output".into()],
        input_held: part.driven.then_some(part.holds),
        sha256: dataset.sha256.clone(),
    };
    Ok(answer(&steps, &part, &held, held_out, summary))
}
