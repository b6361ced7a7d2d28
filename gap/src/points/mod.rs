//! Diagnosis of a dataset of points.

mod causes;
mod misfit;
mod next;
mod places;

use crate::answer::{Answer, DatasetSummary, Verdict};
use crate::dataset::Dataset;
use crate::engine::across;
use crate::engine::fit::Workspace;
use crate::engine::gap::Gap;
use crate::engine::holdout;
use crate::engine::limits::Limits;
use crate::engine::problem::Problem;
use crate::engine::search::{Search, search, search_from};
use crate::engine::structure::examine;
use crate::options::Options;
use crate::verdict::verdict;
use causes::{causes, confusable, nominal_parameters};
use next::{next_measurement, sweep};
use places::{local, places};

pub use misfit::misfit;

/// Diagnoses the points of a dataset; `validate` is another one to score on.
pub(crate) fn diagnose_points(
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
