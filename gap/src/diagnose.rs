//! Diagnosis of one dataset of points.

use crate::answer::{Answer, Cause, DatasetSummary, Estimate, Verdict, Where};
use crate::dataset::{Dataset, Measured};
use crate::effects::list;
use crate::engine::across;
use crate::engine::fit::{Fit, Workspace};
use crate::engine::holdout::{self, Gap, OBSERVABLES};
use crate::engine::limits::Limits;
use crate::engine::linear::Linearised;
use crate::engine::nuisance::{EXCITER_NAMES, Nuisance};
use crate::engine::problem::Problem;
use crate::engine::score::Scored;
use crate::engine::search::{Search, search, search_from};
use crate::engine::significance::two_sided;
use crate::engine::structure::{Structure, examine};
use crate::error::GapError;
use crate::model::row::RATIO;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;

/// What a diagnosis may use.
#[derive(Debug, Clone)]
pub struct Options {
    /// Names that must not be used.
    pub without: Vec<String>,
    /// Another dataset to score on.
    pub validate: Option<std::path::PathBuf>,
    /// Largest number of effects at a time.
    pub most_effects: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            without: Vec::new(),
            validate: None,
            most_effects: 2,
        }
    }
}

/// Structure left by the best set at which "none of these" is the answer.
pub(crate) const NONE_BELOW: f64 = 0.01;
/// Structure left by the nominal simulation at which there is a gap without a name.
const GAP_BELOW: f64 = 0.002;
/// Probability above which a set leads clearly.
const CLEAR: f64 = 0.8;
/// Smallest probability that is listed.
pub(crate) const LISTED: f64 = 0.01;

/// Probability above which a set is possible beside the leading one.
const POSSIBLE: f64 = 0.05;

/// Diagnoses a dataset folder.
///
/// # Errors
/// [`GapError`] for unusable input; a gap that cannot be explained is an answer.
pub fn diagnose(folder: &Path, options: &Options) -> Result<Answer, GapError> {
    for name in &options.without {
        crate::effects::check_name(name)?;
    }
    let dataset = Dataset::read(folder)?;
    let validate = options.validate.as_deref().map(Dataset::read).transpose()?;
    let path = folder.display().to_string();
    match &dataset.measured {
        Measured::Record(record) => {
            crate::oscillator::diagnose(path, &dataset, record, validate.as_ref(), options)
        }
        Measured::Points {
            points, columns, ..
        } => {
            if matches!(
                validate.as_ref().map(|v| &v.measured),
                Some(Measured::Record(_))
            ) {
                return Err(GapError::Usage(
                    "--validate needs points of a calibrator too".into(),
                ));
            }
            let problem = Problem::new(&dataset.rig, points);
            if problem.len() < 2 {
                return Err(GapError::Table {
                    file: "points.csv",
                    problem: "holds nothing that rig.toml lets simulate; a ratio, or drive with a complete [exciter], is needed".into(),
                });
            }
            let summary = DatasetSummary {
                path,
                rows: points.len(),
                columns_used: columns.clone(),
                sha256: dataset.sha256.clone(),
            };
            Ok(diagnose_points(
                &dataset,
                &problem,
                validate.as_ref(),
                options,
                summary,
            ))
        }
    }
}

/// -2 ln posterior density (up to a constant of the dataset) of the best fit with just these effects.
///
/// The square root of the difference between two sets is the size of what
/// tells them apart, in standard deviations of the whole dataset. With the
/// true effects named it is the best any method can do.
///
/// # Errors
/// [`GapError`] for unusable input, an unknown name, or a record instead of points.
pub fn misfit(folder: &Path, effects: &[&str]) -> Result<f64, GapError> {
    for name in effects {
        crate::effects::check_name(name)?;
    }
    let dataset = Dataset::read(folder)?;
    let problem = Problem::from_dataset(&dataset.rig, &dataset.measured)
        .ok_or_else(|| GapError::Usage("only a dataset of points has a misfit by effect".into()))?;
    let limits = Limits::only(effects);
    let found = search(&problem, &limits);
    let just_these = found.every.iter().filter(|fit| {
        let names = fit.names();
        names.len() == effects.len() && effects.iter().all(|e| names.contains(e))
    });
    let best = just_these.map(|fit| fit.objective).reduce(f64::min);
    Ok(best.unwrap_or(found.nominal.objective))
}

/// Diagnoses many datasets on all cores; `progress(done, all)` is called after each.
pub fn diagnose_all(
    folders: &[std::path::PathBuf],
    options: &Options,
    progress: impl Fn(usize, usize) + Sync,
) -> Vec<Result<Answer, GapError>> {
    let done = std::sync::atomic::AtomicUsize::new(0);
    folders
        .par_iter()
        .map(|folder| {
            let answer = diagnose(folder, options);
            progress(
                done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1,
                folders.len(),
            );
            answer
        })
        .collect()
}

fn diagnose_points(
    dataset: &Dataset,
    problem: &Problem,
    validate: Option<&Dataset>,
    options: &Options,
    summary: DatasetSummary,
) -> Answer {
    let limits = Limits::without(&options.without, options.most_effects);
    let other = validate.and_then(|v| Problem::from_dataset(&v.rig, &v.measured));
    // The part is searched before the whole: what it finds may guide the whole, not the other way.
    let (training, testing) = holdout::split(problem, &dataset.rig);
    let part = other.is_none().then(|| search(&training, &limits));
    let found = search_from(problem, &limits, part.as_ref().map(|p| (&training, p)));
    let mut work = Workspace::new(problem);
    let best = found.sets.first().map_or(&found.nominal, |s| &s.fit);
    let nominal_left = examine(problem, &found.nominal, &mut work);
    let left = if best.effects.is_empty() {
        nominal_left.clone()
    } else {
        examine(problem, best, &mut work)
    };
    let mut verdict = verdict(&found, &left);
    if matches!(verdict, Verdict::Explained | Verdict::Ambiguous)
        && crate::tuning::cancels(problem, best)
    {
        verdict = Verdict::Unexplained;
    }
    let mut gap = match (&other, &part) {
        (Some(other), _) => holdout::score_on(problem, other, &found.nominal, best),
        (None, Some(part)) => held_out(&training, &testing, part, verdict),
        (None, None) => held_out(problem, problem, &found, verdict),
    };
    [gap.by_level, gap.by_band] = match &other {
        Some(other) => {
            let rig = validate.map_or(&dataset.rig, |v| &v.rig);
            across::of_other(problem, other, rig, &found.nominal, best)
        }
        None => across::left_out(problem, &dataset.rig, &found.nominal, best, &mut work),
    };
    let causes = causes(problem, &found, &mut work);
    let confusable = confusable(&causes, verdict, problem);
    let mut next_measurement = next_measurement(verdict, &causes, &left, problem);
    let mut places = places(problem, &found, &nominal_left, &left, verdict, &mut work);
    if verdict == Verdict::Unexplained {
        let local = local(problem, &nominal_left, &left, &places);
        if let Some(sweep) = sweep(&local) {
            next_measurement = sweep;
        }
        places.extend(local);
    }
    Answer {
        verdict,
        r#where: places,
        none_of_these_p_value: left.p_value,
        confusable,
        next_measurement,
        gap,
        nominal_parameters: nominal_parameters(problem, best, &mut work),
        causes,
        dataset: summary,
        confirmation: None,
        pictures: crate::pictures::residuals(problem, &found.nominal, best),
    }
}

/// Scores what was chosen on part of the rows on the others.
fn held_out(training: &Problem, testing: &Problem, part: &Search, verdict: Verdict) -> Gap {
    let chosen = match part.sets.first() {
        Some(best) if verdict != Verdict::NoGap => &best.fit,
        _ => &part.nominal,
    };
    holdout::score_on(training, testing, &part.nominal, chosen)
}

pub(crate) fn verdict(found: &Search, left: &Structure) -> Verdict {
    let best = found.sets.first();
    let leading = best.filter(|set| !set.fit.effects.is_empty());
    conclude(leading.map(|set| set.probability), left.p_value)
}

/// Verdict from the probability of the leading set, if there is one, and the p-value of what is left.
pub(crate) fn conclude(leading: Option<f64>, p_value: f64) -> Verdict {
    match leading {
        None if p_value < GAP_BELOW => Verdict::Unexplained,
        None => Verdict::NoGap,
        Some(_) if p_value < NONE_BELOW => Verdict::Unexplained,
        Some(probability) if probability >= CLEAR => Verdict::Explained,
        Some(_) => Verdict::Ambiguous,
    }
}

fn causes(problem: &Problem, found: &Search, work: &mut Workspace) -> Vec<Cause> {
    let smallest = found
        .sets
        .iter()
        .map(|s| s.bic)
        .fold(f64::INFINITY, f64::min);
    let every = found.sets.iter().enumerate();
    let listed: Vec<(usize, &Scored)> = every
        .filter(|(_, s)| !s.fit.effects.is_empty() && s.probability >= LISTED)
        .take(12)
        .collect();
    let stability = crate::stability::stability(problem, &found.sets, work);
    listed
        .into_iter()
        .map(|(at, set)| Cause {
            effects: set.fit.names(),
            probability: set.probability,
            delta_bic: set.bic - smallest,
            stability: stability[at].rows,
            stability_over_runs: stability[at].runs,
            parameters: parameters(problem, &set.fit, work),
        })
        .collect()
}

fn parameters(
    problem: &Problem,
    fit: &Fit,
    work: &mut Workspace,
) -> BTreeMap<&'static str, BTreeMap<&'static str, Estimate>> {
    let covariance = Linearised::new(problem, fit, work)
        .tangent()
        .map(|(_, t)| t.covariance());
    let mut at = problem.free.len();
    let mut all = BTreeMap::new();
    for active in &fit.effects {
        let about = active.effect.about();
        let mut values = BTreeMap::new();
        let of = about.parameters.iter().zip(&active.unit);
        for ((parameter, unit), &value) in of.zip(&active.parameters) {
            let step = covariance.as_ref().map_or(f64::NAN, |c| c[(at, at)].sqrt());
            let scale = if parameter.scale == crate::effects::Scale::Log {
                value
            } else {
                *unit
            };
            // A parameter the data do not move is known no better than its bounds.
            let u = (step * scale).min(parameter.upper - parameter.lower);
            values.insert(parameter.name, Estimate { value, u });
            at += 1;
        }
        all.insert(about.id, values);
    }
    all
}

fn nominal_parameters(
    problem: &Problem,
    fit: &Fit,
    work: &mut Workspace,
) -> BTreeMap<&'static str, Estimate> {
    let covariance = Linearised::new(problem, fit, work)
        .tangent()
        .map(|(_, t)| t.covariance());
    let mut all = BTreeMap::new();
    for (i, (free, &theta)) in problem.free.iter().zip(&fit.theta).enumerate() {
        let sigma = covariance.as_ref().map_or(f64::NAN, |c| c[(i, i)].sqrt());
        let relative = |value: f64| Estimate {
            value,
            u: sigma * free.unit * value,
        };
        match free.kind {
            Nuisance::RatioGain => {
                all.insert("ratio_gain", relative((theta * free.unit).exp()));
            }
            Nuisance::DriveGain => {
                all.insert("drive_gain", relative((theta * free.unit).exp()));
            }
            Nuisance::Exciter(index) => {
                all.insert(
                    EXCITER_NAMES[index],
                    relative(problem.exciter_value(index, theta)),
                );
            }
            _ => {}
        }
    }
    all
}

/// Sets that the data hardly separate, and effects that no data of this kind can.
fn confusable(causes: &[Cause], verdict: Verdict, problem: &Problem) -> Vec<Vec<String>> {
    let mut pairs = hardly_separated(causes, verdict);
    if verdict != Verdict::NoGap && problem.facts.drive && !problem.facts.current {
        // Bl^2/R and the damping of the suspension only ever act as a sum on the drive.
        pairs.push(vec!["mechanical_damping".into(), "back_emf".into()]);
    }
    pairs
}

/// The leading set with each other that these data leave possible.
pub(crate) fn hardly_separated(causes: &[Cause], verdict: Verdict) -> Vec<Vec<String>> {
    let name = |c: &Cause| c.effects.join("+");
    match causes {
        [first, rest @ ..] if verdict != Verdict::NoGap => {
            let possible = rest.iter().filter(|c| c.probability > POSSIBLE);
            possible.map(|c| vec![name(first), name(c)]).collect()
        }
        _ => Vec::new(),
    }
}

fn next_measurement(
    verdict: Verdict,
    causes: &[Cause],
    left: &Structure,
    problem: &Problem,
) -> String {
    let about = |id: &str| list().into_iter().find(|a| a.id == id);
    match verdict {
        Verdict::NoGap => "none needed: repeat the plan after the next change of the rig".into(),
        Verdict::Explained => {
            let first = causes.first().map_or("", |c| c.effects[0]);
            format!(
                "to confirm {first}: {}",
                about(first).map_or("repeat with another run", |a| a.separate_by)
            )
        }
        Verdict::Ambiguous => match causes {
            [first, second, ..] => {
                let differing = first
                    .effects
                    .iter()
                    .find(|e| !second.effects.contains(*e))
                    .unwrap_or(&first.effects[0]);
                let how = about(differing).map_or("more points", |a| a.separate_by);
                format!(
                    "to tell {} from {}: {how}",
                    first.effects.join("+"),
                    second.effects.join("+")
                )
            }
            _ => "repeat the points with the smallest probability of noise in another run".into(),
        },
        Verdict::Unexplained => {
            let worst = left
                .outcomes
                .iter()
                .max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
            let (name, axis) =
                worst.map_or(("ratio", "frequency_hz"), |w| (observable(w.slot), w.axis));
            let band = (problem.facts.lowest_hz, problem.facts.highest_hz);
            format!(
                "more points of {name} along {axis} between {} Hz and {} Hz, in at least two runs",
                band.0, band.1
            )
        }
    }
}

fn observable(slot: usize) -> &'static str {
    OBSERVABLES
        .iter()
        .find(|(_, from, to)| (*from..*to).contains(&slot))
        .map_or("ratio", |o| o.0)
}

/// Where the gap lies: stages in the order of what their effects (or the shape of the structure) explain.
fn places(
    problem: &Problem,
    found: &Search,
    nominal: &Structure,
    left: &Structure,
    verdict: Verdict,
    work: &mut Workspace,
) -> Vec<Where> {
    if verdict == Verdict::NoGap {
        return Vec::new();
    }
    let excess =
        (nominal.residual.iter().map(|r| r * r).sum::<f64>() - problem.len() as f64).max(1.0);
    let shape = crate::stages::of_ratio(problem, &found.nominal, work);
    let mut places = Vec::new();
    for (stage, share) in crate::stages::rank(problem, found, nominal, verdict, work) {
        let (slot, axis, z) = crate::stages::evidence(
            stage,
            if places.is_empty() { nominal } else { left },
            nominal,
        );
        let (from, to) = extent(problem, axis, slot, &nominal.residual);
        let tests = nominal.outcomes.len().max(1) as f64;
        places.push(Where {
            stage: stage.name(),
            observable: observable(slot),
            axis,
            from,
            to,
            share: (share / excess).clamp(0.0, 1.0),
            p_value: (two_sided(z) * tests).min(1.0),
            class: class(slot, axis),
            shape: shape
                .clone()
                .filter(|_| slot == RATIO && axis == "frequency_hz"),
        });
    }
    places
}

/// Bumps over frequency that the best set leaves, as places of the stage that comes first.
fn local(problem: &Problem, nominal: &Structure, left: &Structure, places: &[Where]) -> Vec<Where> {
    let total = nominal.residual.iter().map(|r| r * r).sum::<f64>();
    let excess = (total - problem.len() as f64).max(1.0);
    let bumps = crate::bumps::bumps(problem, &left.residual);
    bumps
        .into_iter()
        .map(|bump| Where {
            stage: places.first().map_or("dut", |place| place.stage),
            observable: observable(bump.slot),
            axis: "frequency_hz",
            from: bump.from_hz,
            to: bump.to_hz,
            share: (bump.square / excess).clamp(0.0, 1.0),
            p_value: bump.p_value,
            class: LOCAL,
            shape: None,
        })
        .collect()
}

/// What tells where bumps come from.
fn sweep(local: &[Where]) -> Option<String> {
    let range = |place: &Where| match place.from == place.to {
        true => format!("{} Hz", place.from),
        false => format!("{} .. {} Hz", place.from, place.to),
    };
    let ranges: Vec<String> = local.iter().map(range).collect();
    (!ranges.is_empty()).then(|| {
        format!(
            "a finer sweep about {}, once as it is and once mounted anew with another cable and \
             adapter: a bump that moves belongs to the mounting",
            ranges.join(", ")
        )
    })
}

/// Class of a bump that a few neighbouring frequencies show.
const LOCAL: &str = "local bump";

fn class(slot: usize, axis: &str) -> &'static str {
    match (slot, axis) {
        (6..22, _) => {
            if ((slot - 6) / 2).is_multiple_of(2) {
                "even"
            } else {
                "odd"
            }
        }
        (24.., _) => "noise",
        (_, "inverse level") => "additive 1/A",
        (_, "time_s") => "drift",
        (_, "acceleration_ms2" | "travel_m") => "level",
        (_, "rotation_deg" | "payload_kg" | "temperature_c" | "tilt_deg") => "condition",
        _ => "frequency",
    }
}

/// Range of the axis that holds the middle 90 % of the squared residual of an observable.
fn extent(problem: &Problem, axis: &str, slot: usize, residual: &[f64]) -> (f64, f64) {
    let value = |row: usize| {
        let r = &problem.rows[row];
        match axis {
            "acceleration_ms2" | "inverse level" => r.level_ms2,
            "time_s" => r.time_s,
            "payload_kg" => r.payload_kg,
            "temperature_c" => r.warmer_k,
            "rotation_deg" => r.rotation.1.atan2(r.rotation.0).to_degrees(),
            "travel_m" => r.level_ms2 / (r.omega * r.omega),
            "coil_v" => r.coil_peak_v,
            _ => r.frequency_hz,
        }
    };
    let mut list: Vec<(f64, f64)> = problem.slots[slot]
        .clone()
        .map(|at| (value(problem.row_of[at]), residual[at] * residual[at]))
        .filter(|(v, _)| v.is_finite())
        .collect();
    list.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = list.iter().map(|l| l.1).sum();
    let at = |share: f64| {
        let mut sum = 0.0;
        list.iter().find(|(_, w)| {
            sum += w;
            sum >= share * total
        })
    };
    (at(0.05).map_or(0.0, |l| l.0), at(0.95).map_or(0.0, |l| l.0))
}
