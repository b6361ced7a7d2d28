//! Datasets of `kind = "oscillator"`: which term a linear oscillator lacks.
//!
//! ```text
//! run, simulate, mode   a record on a fine grid, and the oscillator driven by it
//! model, terms          the terms and their values, and what they do at one instant
//! moves                 which values a fit moves, between which bounds, in which steps
//! residual, slopes      measured less simulated output, and how it changes with the values
//! fit, begin            least squares, and where the fit of a term begins; gross: far away
//! grow, step, finely    one term at a time; steps of the integration as fine as it takes
//! left, score, across   what a fit leaves; its errors on what was held out, and by level and band
//! validation            another record, of which the first state is fitted
//! weigh, stability      probabilities of the sets, and how often each leads if stretches are drawn again
//! parts                 which part of a record is fitted, and which is held out
//! answer, estimates     what an answer states: verdict, place, what next, values
//! ```

mod across;
mod answer;
mod begin;
mod estimates;
mod finely;
mod fit;
mod gross;
mod grow;
mod left;
mod mode;
mod model;
mod moves;
mod parts;
mod residual;
mod run;
mod score;
mod simulate;
mod slopes;
mod stability;
mod step;
mod terms;
mod validation;
mod weigh;

use crate::answer::{Answer, DatasetSummary};
use crate::dataset::{Dataset, Record};
use crate::error::GapError;
use crate::options::Options;
use answer::answer;
use fit::linear;
use grow::grow;
use model::TERMS;
use parts::parts;
use run::{FEWEST_STEPS, Run};
use score::Scored;

/// Names of the terms.
pub(crate) fn names() -> Vec<&'static str> {
    TERMS.iter().map(|t| t.name).collect()
}

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
    let resonance_hz = oscillator
        .resonance_hz
        .map_or(0.05 / record.interval_s, |q| q.value);
    let delta = oscillator.delta.map_or(0.05, |q| q.value);
    let [part, held] = parts(record, validate)?;
    let part = Run::new(&part, FEWEST_STEPS);
    let start = linear(&part, resonance_hz, delta)
        .ok_or_else(|| unusable("no linear oscillator fits the record at all"))?;
    let (steps, part) = grow(part, start, options)
        .ok_or_else(|| unusable("the fitted oscillator diverges beside its best values"))?;
    let held = Run::new(&held, part.steps);
    let scored = Scored::new(&steps, &part, &held)
        .ok_or_else(|| unusable("the fitted oscillator diverges on the held-out record"))?;
    let summary = DatasetSummary {
        path,
        rows: record.input.len(),
        columns_used: vec!["time_s".into(), "input".into(), "output".into()],
        sha256: dataset.sha256.clone(),
    };
    Ok(answer(&steps, &part, &held, scored, summary))
}
