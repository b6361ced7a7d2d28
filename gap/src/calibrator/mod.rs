//! Diagnosis of the points of a calibrator.
//!
//! ```text
//! problem             whitened data by observable; nuisance: what a fit moves that is no effect
//! evaluate            simulation and measurement compared, which gives an evaluation
//! remainder, higher   harmonics above those that are reported: as noise, and where they would show
//! linear              slopes at a fit; nuisance_columns and closed_form: of which no row is computed
//!                     anew; finite_difference: the others
//! fit, refine         a set of effects, and the estimator's model of it; step, polish
//! candidate, screen   starts of effects, each with its predicted gain; scatter: of those that only
//!                     scatter; noise_sum
//! search              none, singles, pairs, within limits; proposal: what is tried, race: refined
//! found               what came of it; model_selection: scores and probabilities
//! lack_of_fit         what is left by shapes; open_data: scatter left open; settled: best values
//! verdict             the four outcomes, and pairs that cancel
//! unseen              the part that takes no part; holdout and cross_validation: errors there
//! causes, places      what an answer states; stages, bumps: where; next: what to measure; residuals
//! ```

mod bumps;
pub(crate) mod candidate;
mod causes;
mod closed_form;
pub(crate) mod cross_validation;
pub(crate) mod evaluate;
pub(crate) mod evaluation;
#[cfg(test)]
pub(crate) mod example;
mod finite_difference;
pub(crate) mod fit;
pub(crate) mod found;
mod higher;
pub(crate) mod holdout;
pub(crate) mod lack_of_fit;
pub(crate) mod limits;
pub(crate) mod linear;
mod misfit;
pub(crate) mod model_selection;
mod next;
mod noise_sum;
pub(crate) mod nuisance;
mod nuisance_columns;
mod open_data;
mod places;
mod polish;
pub(crate) mod problem;
mod proposal;
mod race;
mod refine;
mod remainder;
mod residuals;
mod scatter;
pub(crate) mod screen;
pub(crate) mod search;
pub(crate) mod settled;
pub(crate) mod shapes;
mod stages;
mod step;
mod unseen;
pub(crate) mod verdict;

use crate::answer::{Answer, DatasetSummary, Verdict};
use crate::dataset::Dataset;
use crate::options::Options;
use causes::{causes, confusable, nominal_parameters};
use fit::Workspace;
use limits::Limits;
use next::{next_measurement, sweep};
use places::{local, places};
use problem::Problem;
use residuals::residuals;
use search::search_from;
use unseen::Unseen;
use verdict::{Judgement, cancels, judge};

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
    let Judgement {
        verdict,
        nominal_left,
        left,
    } = judge(problem, &found, &mut work);
    let verdict = match verdict {
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
        pictures: residuals(problem, &found.nominal, best),
    }
}
