//! Diagnosis of the points of a calibrator.
//!
//! ```text
//! problem             whitened data by observable; nuisance: what a fit moves that is no effect
//! evaluate            simulation and measurement compared, which gives an evaluation
//! remainder, higher   harmonics above those that are reported: as noise, and where they would show
//! linear              slopes at a fit; closed_form: those for which no row is computed anew, of
//!                     nuisances among them; finite_difference: the others
//! fit, refine         a set of effects, and the estimator's model of it: its steps, within bounds
//! candidate, screen   starts of effects, each with its predicted gain; scatter: of those that only
//!                     scatter
//! search              none, singles, pairs, within limits; race: one refined
//! found               what is worth a try, and what came of it; model_selection: scores and probabilities
//! lack_of_fit         what is left by shapes; settled: best values
//! verdict             the outcomes, and pairs that cancel
//! noise               noise that is not what is stated, and misread rows
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
pub(crate) mod linear;
pub(crate) mod model_selection;
mod next;
mod noise;
pub(crate) mod nuisance;
mod places;
pub(crate) mod problem;
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
mod unseen;
pub(crate) mod verdict;

use crate::answer::{Answer, DatasetSummary, Verdict};
use crate::dataset::Dataset;
use crate::estimation::gap::Gap;
use crate::estimation::verdict::{doubted, heard};
use crate::options::Options;
use crate::others::share_with_others;
use crate::thresholds;
use causes::{causes, confusable, nominal_parameters};
use fit::{Fit, Workspace};
use lack_of_fit::examine;
use next::Next;
use noise::{Noise, stated};
use places::{local, places, remainder};
use problem::Problem;
use residuals::residuals;
use search::{Limits, Search, search_from};
use unseen::Unseen;
use verdict::{Judgement, cancels, judge};

pub use search::misfit;

/// Diagnoses the points of a dataset; `validate` is another one to score on.
pub(crate) fn diagnose_points(
    dataset: &Dataset,
    problem: &Problem,
    validate: Option<&Dataset>,
    options: &Options,
    summary: DatasetSummary,
) -> Answer {
    let limits = Limits::of(options);
    // The part is searched before the whole: what it finds may guide the whole, not the other way.
    let unseen = Unseen::new(dataset, problem, validate, &limits, None);
    let stated = |summary| {
        let found = heard_search(problem, &limits, &unseen);
        Diagnosis::new(problem, &unseen, None, &found).answer(summary)
    };
    let Some(noise) = unseen.noise(dataset, problem) else {
        return stated(summary);
    };
    let quietened = noise.applied(problem, &dataset.rig);
    let limits_there = match noise.remembers() {
        true => limits.without_more(),
        false => limits.clone(),
    };
    let before = noise.is_of_size_only().then_some(&unseen);
    let again = Unseen::new(dataset, &quietened, validate, &limits_there, before);
    let found = heard_search(&quietened, &limits_there, &again);
    // Rows that stand out beside a structure that stays belong to it.
    if noise.is_of_rows_only() && shows_lack_of_fit(&quietened, found.best()) {
        return stated(summary);
    }
    Diagnosis::new(&quietened, &again, Some(&noise), &found).answer(summary)
}

/// A search on all rows, less what unseen rows speak against.
fn heard_search(problem: &Problem, limits: &Limits, unseen: &Unseen<'_>) -> Search {
    let mut found = search_from(problem, limits, unseen.searched());
    unseen.veto(problem, &mut found);
    if limits.most_effects < limits.most_beside_lack_of_fit {
        // More names than are asked for have to describe all of the data: of a cause with another form than ours
        // the next effects would only be corrections, which are small.
        found.strike(|fit| {
            fit.effects.len() <= limits.most_effects
                || !shows_lack_of_fit(problem, fit)
                || unseen.needs_each(problem, fit)
        });
    }
    found
}

/// Whether a fit leaves more than noise.
fn shows_lack_of_fit(problem: &Problem, fit: &Fit) -> bool {
    let left = examine(problem, fit, &mut Workspace::new(problem));
    left.p_value < thresholds::UNEXPLAINED_P_VALUE
}

/// Parts of an answer.
struct Diagnosis<'a> {
    problem: &'a Problem,
    unseen: &'a Unseen<'a>,
    noise: Option<&'a Noise>,
    found: &'a Search,
}

impl<'a> Diagnosis<'a> {
    fn new(
        problem: &'a Problem,
        unseen: &'a Unseen<'a>,
        noise: Option<&'a Noise>,
        found: &'a Search,
    ) -> Self {
        Self {
            problem,
            unseen,
            noise,
            found,
        }
    }

    fn answer(&self, dataset: DatasetSummary) -> Answer {
        let (problem, found) = (self.problem, self.found);
        let mut work = Workspace::new(problem);
        let judgement = judge(problem, found, &mut work);
        let (verdict, gap) = self.concluded(judgement.verdict, &mut work);
        let Judgement {
            nominal_left, left, ..
        } = judgement;
        let mut causes = causes(problem, found, &mut work);
        let confusable = confusable(&causes, verdict, problem);
        let probability_other = share_with_others(
            &mut causes,
            verdict,
            left.p_value,
            &gap,
            &thresholds::OUTSIDE_OF_POINTS,
        );
        let verdict = doubted(verdict, causes.first().map(|c| c.probability), &gap);
        let remainder = remainder(problem, &left, verdict);
        let mut places = places(problem, found, &nominal_left, &left, verdict, &mut work);
        let local = match verdict {
            Verdict::Unexplained | Verdict::PartlyExplained => {
                local(problem, &nominal_left, &left, &places)
            }
            _ => Vec::new(),
        };
        let noise = self.noise.map(stated).unwrap_or_default();
        let next = Next {
            causes: &causes,
            left: &left,
            problem,
            remainder: remainder.as_ref(),
            noise: &noise,
            local: &local,
        };
        let next_measurement = next.measurement(verdict);
        places.extend(local);
        let answer = Answer {
            summary: String::new(),
            verdict,
            r#where: places,
            none_of_these_p_value: left.p_value,
            confusable,
            next_measurement,
            gap,
            remainder,
            noise,
            probability_other,
            nominal_parameters: nominal_parameters(problem, found.best(), &mut work),
            causes,
            dataset,
            confirmation: None,
            pictures: residuals(problem, &found.nominal, found.best()),
        };
        answer.summarised()
    }

    /// The verdict with the gap on rows that took no part.
    fn concluded(&self, verdict: Verdict, work: &mut Workspace) -> (Verdict, Gap) {
        let (problem, found) = (self.problem, self.found);
        let verdict = match verdict {
            Verdict::Explained | Verdict::Ambiguous if cancels(problem, found.best()) => {
                Verdict::Unexplained
            }
            Verdict::NoGap if self.noise.is_some() => Verdict::Data,
            verdict => verdict,
        };
        let gap = self.unseen.gap(problem, found, verdict, work);
        let of_leading = Gap {
            by_level: gap.by_level.clone(),
            by_band: gap.by_band.clone(),
            ..self.unseen.gap_with(problem, found, found.best())
        };
        let remembers = self.noise.is_some_and(Noise::remembers);
        (heard(verdict, &of_leading, remembers), gap)
    }
}
