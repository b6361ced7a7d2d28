//! The causes with their parameters, and what they may be mistaken for.

use super::fit::{Fit, Workspace};
use super::linear::Linearised;
use super::model_selection::Scored;
use super::nuisance::Nuisance;
use super::problem::Problem;
use super::search::Search;
use crate::answer::{Cause, Estimate, Verdict, hardly_separated};
use crate::effects::library;
use crate::estimation::selection::{bootstrap, without_each};
use crate::model::effect::{Effect, Stated};
use crate::thresholds;
use calib_effects::{Of, Scale};
use std::collections::BTreeMap;

/// The causes that are probable enough to be listed, best first.
pub(super) fn causes(problem: &Problem, found: &Search, work: &mut Workspace) -> Vec<Cause> {
    let smallest = found
        .sets
        .iter()
        .map(|s| s.bic)
        .fold(f64::INFINITY, f64::min);
    let every = found.sets.iter().enumerate();
    let listed: Vec<(usize, &Scored)> = every
        .filter(|(_, s)| {
            !s.fit.effects.is_empty() && s.probability >= thresholds::LISTED_PROBABILITY
        })
        .take(thresholds::MOST_CAUSES)
        .collect();
    let stability = Stability::new(problem, &found.sets, work);
    listed
        .into_iter()
        .map(|(at, set)| Cause {
            effects: set.fit.names(),
            probability: set.probability,
            delta_bic: set.bic - smallest,
            stability: stability.rows.get(at).copied().unwrap_or(0.0),
            stability_over_runs: stability
                .runs
                .as_ref()
                .map(|r| r.get(at).copied().unwrap_or(0.0)),
            cautions: Vec::new(),
            parameters: parameters(problem, &set.fit, work),
        })
        .map(|cause| cause.with_cautions(Of::Calibrator))
        .collect()
}

/// How often each set leads.
struct Stability {
    /// Share of bootstrap samples of the rows.
    rows: Vec<f64>,
    /// Share of the runs without any one of which it still leads; none where there is one run.
    runs: Option<Vec<f64>>,
}

impl Stability {
    fn new(problem: &Problem, sets: &[Scored], work: &mut Workspace) -> Self {
        let compared = &sets[..sets.len().min(thresholds::MOST_COMPARED)];
        let by_row = compared.iter().map(|set| {
            let at = problem.evaluate(&set.fit.effects, &set.fit.theta, &mut work.memory);
            let mut rows = vec![0.0; problem.rows.len()];
            for (datum, residual) in at.residual.iter().enumerate() {
                rows[problem.row_of[datum]] += residual * residual
                    - 2.0 * (at.weight[datum] * problem.uncertainty(datum)).ln();
            }
            rows
        });
        let by_row: Vec<Vec<f64>> = by_row.collect();
        // Priors and costs, which no row has a part in.
        let rest = |(set, rows): (&Scored, &Vec<f64>)| set.score - rows.iter().sum::<f64>();
        let rest: Vec<f64> = compared.iter().zip(&by_row).map(rest).collect();
        let scores =
            |sums: Vec<f64>| -> Vec<f64> { sums.iter().zip(&rest).map(|(s, r)| s + r).collect() };
        let runs: Vec<usize> = problem.rows.iter().map(|row| row.run).collect();
        Self {
            rows: bootstrap(&by_row, scores),
            runs: without_each(&runs, &by_row, scores),
        }
    }
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
        let parameters = active.effect.parameters();
        let mut values = Vec::new();
        let of = parameters.iter().zip(&active.unit);
        for ((parameter, unit), &value) in of.zip(&active.parameters) {
            let step = covariance.as_ref().map_or(f64::NAN, |c| c[(at, at)].sqrt());
            let scale = if parameter.scale == Scale::Log {
                value
            } else {
                *unit
            };
            // A parameter the data do not move is known no better than its bounds.
            let u = (step * scale).min(parameter.upper - parameter.lower);
            values.push(Stated { value, u });
            at += 1;
        }
        active.effect.state(&mut values);
        let named = parameters.iter().zip(values);
        let named = named.map(|(of, Stated { value, u })| (of.name, Estimate { value, u }));
        all.insert(active.effect.entry().id, named.collect());
    }
    all
}

/// Nominal values as fitted within their uncertainties.
pub(super) fn nominal_parameters(
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
            Nuisance::Exciter(parameter) => {
                let value = problem.exciter_value(parameter, theta);
                all.insert(parameter.name(), relative(value));
            }
            _ => {}
        }
    }
    all
}

/// Sets that the data hardly separate, and effects that no data of this kind can.
pub(super) fn confusable(
    causes: &[Cause],
    verdict: Verdict,
    problem: &Problem,
) -> Vec<Vec<String>> {
    let mut pairs = hardly_separated(causes, verdict);
    if verdict != Verdict::NoGap {
        let alike = |e: &&dyn Effect| Some([e.entry().id, e.alike(&problem.facts)?.id]);
        let alike = library().iter().filter_map(alike);
        pairs.extend(alike.map(|pair| pair.map(String::from).to_vec()));
    }
    pairs
}
