//! Diagnosis of a dataset of points.

mod causes;
mod misfit;
mod next;
mod places;
mod unseen;

use crate::answer::{Answer, DatasetSummary, Verdict};
use crate::dataset::Dataset;
use crate::engine::fit::Workspace;
use crate::engine::limits::Limits;
use crate::engine::problem::Problem;
use crate::engine::search::search_from;
use crate::options::Options;
use crate::tuning::cancels;
use crate::verdict::{left_by, verdict};
use causes::{causes, confusable, nominal_parameters};
use next::{next_measurement, sweep};
use places::{local, places};
use unseen::Unseen;

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
    // The part is searched before the whole: what it finds may guide the whole, not the other way.
    let unseen = Unseen::new(dataset, problem, validate, &limits);
    let found = search_from(problem, &limits, unseen.searched());
    let mut work = Workspace::new(problem);
    let best = found.best();
    let (nominal_left, left) = left_by(problem, &found, &mut work);
    let verdict = match verdict(&found, &left, &nominal_left) {
        Verdict::Explained | Verdict::Ambiguous if cancels(problem, best) => Verdict::Unexplained,
        verdict => verdict,
    };
    let gap = unseen.gap(problem, [&found.nominal, best], verdict, &mut work);
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
