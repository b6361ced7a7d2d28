//! Datasets of `kind = "oscillator"`: which term a linear oscillator lacks.

mod across;
mod fit;
mod model;
mod stability;

use crate::answer::{Answer, Cause, DatasetSummary, Estimate, Verdict, Where};
use crate::dataset::{Dataset, Measured, Record};
use crate::diagnose::Options;
use crate::engine::holdout::{Gap, ObservableGap};
use crate::error::GapError;
use crate::pictures::{Pictures, Trace};
use fit::{Fitted, SETTLING, all_terms, begin, fitted_part, linear, refine, rms, validation};
use model::{HIGHPASS, HYSTERESIS, SATURATION, SECOND_MODE, TERMS, places};
use std::collections::BTreeMap;

/// Share of the squared error a term must remove to be named.
///
/// A record has tens of thousands of samples: any term is "significant", and
/// model error is not white. A term counts if it lowers the simulation error by 5 %,
/// its square by 10 %.
const WORTH_NAMING: f64 = 0.1;

/// Difference of squared errors below which two terms do equally well: what is
/// left is model error, not noise, and favours none of them.
const AS_GOOD: f64 = 0.05;

/// 2 ln of the odds of a leading term against a later one, or one with a kink:
/// forces of a real oscillator expand in powers first.
const ODDS_OF_LEADING: f64 = 4.6;

/// Steps after which terms are compared, and steps of those that lead.
const FIRST_STEPS: usize = 4;
const MOST_STEPS: usize = 10;
/// Terms that are refined to the end.
const REFINED: usize = 5;

/// Share of the samples that count as independent.
const INDEPENDENT: f64 = 0.02;

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
    let start = linear(&part, resonance, delta)
        .ok_or_else(|| unusable("no linear oscillator fits the record at all"))?;
    let steps = grow(&part, start, options);
    answer(path, dataset, record, &part, &held, &steps)
        .ok_or_else(|| unusable("the fitted oscillator diverges on the held-out record"))
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

/// One step: the fit, and the alternatives that were tried beside it with their squares.
struct Step {
    fit: Fitted,
    tried: Vec<Fitted>,
}

fn grow(record: &Record, start: Fitted, options: &Options) -> Vec<Step> {
    let most = options
        .most_effects
        .max(if options.most_effects == 0 { 0 } else { 2 });
    let mut steps = vec![Step {
        fit: start,
        tried: Vec::new(),
    }];
    while steps.len() <= most {
        let base = &steps[steps.len() - 1].fit;
        let mut tried: Vec<Fitted> = all_terms()
            .filter(|t| {
                !base.terms.contains(t) && !options.without.iter().any(|w| w == TERMS[*t].name)
            })
            .filter_map(|t| {
                let mut terms = base.terms.clone();
                terms.push(t);
                refine(record, begin(record, &base.values, t), &terms, FIRST_STEPS)
            })
            .collect();
        tried.sort_by(|a, b| a.square.total_cmp(&b.square));
        for fit in tried.iter_mut().take(REFINED) {
            if let Some(further) = refine(record, fit.values, &fit.terms, MOST_STEPS) {
                *fit = further;
            }
        }
        // The same weights as in the answer: what is scored is what leads.
        let least = least_square(tried.iter());
        let score = |f: &Fitted| score(f, f.square, least, record.output.len() as f64);
        tried.sort_by(|a, b| {
            let order = score(a).total_cmp(&score(b));
            order.then_with(|| a.terms.last().cmp(&b.terms.last()))
        });
        let Some(best) = tried
            .first()
            .filter(|b| b.square < base.square * (1.0 - WORTH_NAMING))
        else {
            if let Some(last) = steps.last_mut() {
                last.tried.extend(tried);
            }
            break;
        };
        steps.push(Step {
            fit: best.clone(),
            tried,
        });
    }
    steps
}

/// Sum of squares, the cost of parameters and the odds of kinks: -2 ln posterior of a fit
/// among those of one size, of which the best has the square `least`.
fn score(fit: &Fitted, square: f64, least: f64, count: f64) -> f64 {
    // Simulation errors are correlated over about a period of the resonance and the
    // smallest error is model error: the samples count as many times less.
    let square = square.max(least * (1.0 + AS_GOOD));
    let leading = fit.terms.iter().all(|t| TERMS[*t].leading);
    let independent = (INDEPENDENT * count).max(std::f64::consts::E);
    let parameters: usize = fit.terms.iter().map(|t| places(*t).len()).sum();
    independent * (square / count).ln()
        + parameters as f64 * independent.ln()
        + if leading { 0.0 } else { ODDS_OF_LEADING }
}

fn least_square<'a>(fits: impl Iterator<Item = &'a Fitted>) -> f64 {
    fits.map(|f| f.square).fold(f64::INFINITY, f64::min)
}

fn names_of(fit: &Fitted) -> Vec<&'static str> {
    fit.terms.iter().map(|t| TERMS[*t].name).collect()
}

fn answer(
    path: String,
    dataset: &Dataset,
    record: &Record,
    part: &Record,
    held: &Record,
    steps: &[Step],
) -> Option<Answer> {
    let (nominal, last) = (&steps[0].fit, &steps[steps.len() - 1]);
    let left = [validation(nominal, held)?, validation(&last.fit, held)?];
    let (before, after, rows) = (rms(&left[0]), rms(&left[1]), left[0].len());
    let floor = noise_floor(held);
    let size = (held.output.iter().map(|x| x * x).sum::<f64>() / held.output.len() as f64).sqrt();
    let percent = |e: f64| 100.0 * e / size;
    let closed = (before > floor).then(|| ((before - after) / (before - floor)).clamp(-9.0, 1.0));
    let observable = ObservableGap {
        before_percent: percent(before),
        after_percent: percent(after),
        floor_percent: percent(floor),
        closed,
        chi_before: before / floor,
        chi_after: after / floor,
    };
    let explained = after < 3.0 * floor;
    let verdict = match (last.fit.terms.is_empty(), explained) {
        (true, true) => Verdict::NoGap,
        (_, false) => Verdict::Unexplained,
        (false, true) => Verdict::Explained,
    };
    let share = 1.0 - last.fit.square / nominal.square;
    let errors = across::Errors {
        output: held.output.get(SETTLING..).unwrap_or_default(),
        before: &left[0],
        after: &left[1],
        noise: floor,
        interval_s: held.interval_s,
        resonance_hz: nominal.values[0].exp() / std::f64::consts::TAU,
        chosen: names_of(&last.fit),
        fitted_peak: peak(&part.output),
    };
    let (by_level, by_band) = (errors.by_level(), errors.by_band());
    Some(Answer {
        verdict,
        r#where: vec![Where {
            stage: "dut",
            observable: "output",
            axis: "amplitude",
            from: 0.0,
            to: peak(&held.output),
            share,
            p_value: 0.0,
            class: if last.fit.terms.contains(&1) {
                "odd and even"
            } else {
                "odd"
            },
        }],
        causes: causes(steps, part),
        none_of_these_p_value: if explained { 1.0 } else { 0.0 },
        confusable: Vec::new(),
        next_measurement: "a record of larger amplitude, and one of half the amplitude".into(),
        gap: Gap {
            before_percent: observable.before_percent,
            after_percent: observable.after_percent,
            floor_percent: observable.floor_percent,
            closed,
            chi_before: observable.chi_before,
            chi_after: observable.chi_after,
            held_out_rows: rows,
            chosen: names_of(&last.fit),
            rms_before: Some(before),
            rms_after: Some(after),
            by_observable: BTreeMap::from([("output", observable)]),
            by_level,
            by_band,
        },
        nominal_parameters: linear_parameters(&last.fit),
        dataset: DatasetSummary {
            path,
            rows: record.input.len(),
            columns_used: vec!["time_s".into(), "input".into(), "output".into()],
            sha256: dataset.sha256.clone(),
        },
        confirmation: None,
        pictures: trace(held, left),
    })
}

fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// Samples of a stretch that is drawn.
const MOST_DRAWN: usize = 4000;

fn trace(held: &Record, [before, after]: [Vec<f64>; 2]) -> Pictures {
    // The stretch in which the linear simulation errs most.
    let parts = before.chunks(MOST_DRAWN).map(rms).enumerate();
    let worst = parts.max_by(|a, b| a.1.total_cmp(&b.1));
    let from = worst.map_or(0, |w| w.0) * MOST_DRAWN;
    let drawn = |values: &[f64]| -> Vec<f64> {
        values.iter().skip(from).take(MOST_DRAWN).copied().collect()
    };
    Pictures::Record(Trace {
        interval_s: held.interval_s,
        measured: drawn(held.output.get(SETTLING..).unwrap_or_default()),
        before: drawn(&before),
        after: drawn(&after),
    })
}

/// Noise of the output from its fourth differences: what no smooth motion can follow.
fn noise_floor(record: &Record) -> f64 {
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

fn causes(steps: &[Step], part: &Record) -> Vec<Cause> {
    let last = &steps[steps.len() - 1];
    if last.fit.terms.is_empty() {
        return Vec::new();
    }
    let count = part.output.len() as f64;
    let same: Vec<&Fitted> = last
        .tried
        .iter()
        .filter(|f| f.terms.len() == last.fit.terms.len())
        .collect();
    let least = least_square(same.iter().copied());
    let score = |f: &Fitted| self::score(f, f.square, least, count);
    let resonance_hz = steps[0].fit.values[0].exp() / std::f64::consts::TAU;
    let length = across::stretch(resonance_hz, part.interval_s);
    // Drawn again, every set may come out better than the best does on average.
    let drawn = |f: &Fitted, square: f64| self::score(f, square, 0.0, count);
    let stability = stability::stability(&same, part, length, drawn);
    let best = same.iter().map(|f| score(f)).fold(f64::INFINITY, f64::min);
    let total: f64 = same.iter().map(|f| (-0.5 * (score(f) - best)).exp()).sum();
    let mut list: Vec<Cause> = same
        .into_iter()
        .zip(stability)
        .map(|(f, stability)| Cause {
            effects: names_of(f),
            probability: (-0.5 * (score(f) - best)).exp() / total,
            delta_bic: score(f) - best,
            stability,
            stability_over_runs: None,
            parameters: term_parameters(f),
        })
        .filter(|c| c.probability > 0.01)
        .collect();
    list.sort_by(|a, b| b.probability.total_cmp(&a.probability));
    list
}

fn term_parameters(fit: &Fitted) -> BTreeMap<&'static str, BTreeMap<&'static str, Estimate>> {
    let mut at = model::LINEAR;
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

fn linear_parameters(fit: &Fitted) -> BTreeMap<&'static str, Estimate> {
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
