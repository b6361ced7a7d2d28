//! Datasets of `kind = "oscillator"`: which term a linear oscillator lacks.
//!
//! ```text
//! run, simulate, mode   a record on a fine grid, and the oscillator driven by it
//! model, terms          the terms and their values, and what they do at one instant
//! moves                 which values a fit moves, between which bounds, in which steps
//! residual, slopes      measured less simulated output, and how it changes with the values
//! fit, begin            least squares, and where the fit of a term begins; gross: far away
//! grow, finely          one term at a time; steps of the integration as fine as it takes
//! left, score, across   what a fit leaves; its errors on what was held out, and by level and band
//! validation            another record, of which the first state is fitted
//! weigh, stability      probabilities of the sets, and how often each leads if stretches are drawn again
//! estimates             values as an answer states them
//! ```

mod across;
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
mod residual;
mod run;
mod score;
mod simulate;
mod slopes;
mod stability;
mod terms;
mod validation;
mod weigh;

use crate::answer::{Answer, Cause, DatasetSummary, Verdict, Where};
use crate::dataset::{Dataset, Measured, Record};
use crate::effects::Stage;
use crate::error::GapError;
use crate::options::Options;
use crate::pictures::{Pictures, Trace};
use crate::verdict::{conclude, hardly_separated};
use estimates::linear_parameters;
use fit::linear;
use grow::{Step, grow};
use left::Parity;
use model::TERMS;
use residual::{compared, fitted_part, rms};
use run::{FEWEST_STEPS, Run};
use score::Scored;
use weigh::causes;

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
    let resonance = oscillator
        .resonance_hz
        .map_or(0.05 / record.interval_s, |q| q.value);
    let delta = oscillator.delta.map_or(0.05, |q| q.value);
    let held = match validate.map(|v| &v.measured) {
        Some(Measured::Record(other)) => other.clone(),
        Some(Measured::Points { .. }) => {
            return Err(GapError::Usage(
                "--validate needs a record of an oscillator too".into(),
            ));
        }
        None => last_quarter(record),
    };
    let part = if validate.is_some() {
        fitted_part(record)
    } else {
        fitted_part(&first_part(record))
    };
    let part = Run::new(&part, FEWEST_STEPS);
    let start = linear(&part, resonance, delta)
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

fn answer(
    steps: &[Step],
    part: &Run,
    held: &Run,
    mut scored: Scored,
    dataset: DatasetSummary,
) -> Answer {
    let last = &steps[steps.len() - 1];
    let causes = causes(last, part, score::resonance_hz(&steps[0].fit));
    let leading = causes.first().map(|c| c.probability);
    let verdict = verdict(leading, last, &scored);
    if verdict == Verdict::NoGap {
        scored.gap.closed = None;
    }
    Answer {
        verdict,
        r#where: place(verdict, steps, held),
        none_of_these_p_value: last.left.p_value,
        confusable: hardly_separated(&causes, verdict),
        next_measurement: next_measurement(verdict, &causes),
        gap: scored.gap,
        nominal_parameters: linear_parameters(&last.fit),
        dataset,
        confirmation: None,
        pictures: trace(held, scored.errors),
        causes,
    }
}

/// Share closed from which sets that do equally well are called ambiguous although what they
/// leave is not white: the model error of a real oscillator.
const NEARLY_ALL: f64 = 0.95;

fn verdict(leading: Option<f64>, last: &Step, scored: &Scored) -> Verdict {
    let concluded = conclude(leading, last.left.p_value);
    let tied = leading.is_some_and(|p| conclude(Some(p), 1.0) == Verdict::Ambiguous);
    let nearly_all = scored.gap.closed.is_some_and(|c| c > NEARLY_ALL);
    match concluded {
        Verdict::Unexplained if tied && nearly_all => Verdict::Ambiguous,
        other => other,
    }
}

/// Where the linear oscillator and the record differ: by the set that was found, and by the parity of the traces.
fn place(verdict: Verdict, steps: &[Step], held: &Run) -> Vec<Where> {
    if verdict == Verdict::NoGap {
        return Vec::new();
    }
    let (first, last) = (&steps[0], &steps[steps.len() - 1]);
    let strongest = |parity: Parity| {
        let of = first.left.traces.iter().filter(|t| t.0 == parity);
        of.fold(0.0_f64, |m, t| m.max(t.1.abs()))
    };
    let [odd, even, linear] = [Parity::Odd, Parity::Even, Parity::Linear].map(strongest);
    let class = if linear > odd.max(even) {
        "frequency"
    } else if even < 0.1 * odd {
        "odd"
    } else if odd < 0.1 * even {
        "even"
    } else {
        "odd and even"
    };
    let stage = last
        .fit
        .terms
        .first()
        .map_or(Stage::Dut, |t| TERMS[*t].stage);
    vec![Where {
        stage: stage.name(),
        observable: "output",
        axis: "amplitude",
        from: 0.0,
        to: score::peak(&held.output),
        share: 1.0 - last.fit.square / first.fit.square,
        p_value: first.left.p_value,
        class,
        shape: None,
    }]
}

fn next_measurement(verdict: Verdict, causes: &[Cause]) -> String {
    let how = |name: &str| {
        let term = TERMS.iter().find(|t| t.name == name);
        term.map_or("another record", |t| t.separate_by)
    };
    let last = |c: &Cause| c.effects.last().copied().unwrap_or_default();
    match (verdict, causes) {
        (Verdict::NoGap, _) => "none needed: repeat the record after the next change".into(),
        (Verdict::Ambiguous, [first, second, ..]) => format!(
            "to tell {} from {}: {}",
            first.effects.join("+"),
            second.effects.join("+"),
            how(last(second))
        ),
        (Verdict::Explained, [first, ..]) => {
            format!("to confirm {}: {}", last(first), how(last(first)))
        }
        _ => "a record of larger amplitude, and one of half the amplitude".into(),
    }
}

fn cut(record: &Record, from: usize, to: usize) -> Record {
    Record {
        interval_s: record.interval_s,
        input: record.input[from..to].to_vec(),
        output: record.output[from..to].to_vec(),
    }
}

fn first_part(record: &Record) -> Record {
    cut(record, 0, record.input.len() * 3 / 4)
}

fn last_quarter(record: &Record) -> Record {
    cut(record, record.input.len() * 3 / 4, record.input.len())
}

/// Samples of a stretch that is drawn.
const MOST_DRAWN: usize = 4000;

fn trace(held: &Run, [before, after]: [Vec<f64>; 2]) -> Pictures {
    // The stretch in which the linear simulation errs most.
    let parts = before.chunks(MOST_DRAWN).map(rms).enumerate();
    let worst = parts.max_by(|a, b| a.1.total_cmp(&b.1));
    let from = worst.map_or(0, |w| w.0) * MOST_DRAWN;
    let drawn = |values: &[f64]| -> Vec<f64> {
        values.iter().skip(from).take(MOST_DRAWN).copied().collect()
    };
    Pictures::Record(Trace {
        interval_s: held.interval_s,
        measured: drawn(compared(&held.output)),
        before: drawn(&before),
        after: drawn(&after),
    })
}
