//! Which measurements best separate what is still possible, and by how many sigma.
//!
//! ```text
//! proposals   settings and points the rig can hold, with what would be measured there
//! hypotheses   sets of effects that are still possible, as fitted or of a usual size
//! duel         one set is true, the other is refitted: what is left, in sigma
//! side         what both say of the same data, and what is refitted
//! ```
//!
//! # Equation
//! With `r` the difference of two predictions over the uncertainties, `J` the
//! slopes of the refitted one (nuisances with their priors) and `M = J'J + P`,
//! the separation is `sqrt(r'r - r'J M^-1 J'r)`, over the data there are and
//! the points that are added. Points are chosen one by one, each the one that
//! raises the pairs below five sigma most.

mod duel;
mod hypotheses;
mod proposals;
mod side;

use crate::answer::Verdict;
use crate::calibrator::problem::Problem;
use crate::dataset::{Dataset, Measured};
use crate::error::GapError;
use crate::thresholds;
use duel::Duel;
pub use proposals::Measurement;
use proposals::Proposals;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;

const ENOUGH: f64 = thresholds::ENOUGH_SIGMA * thresholds::ENOUGH_SIGMA;

/// Next measurement.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Plan {
    /// Diagnosis so far; null where nothing was measured yet.
    pub verdict: Option<Verdict>,
    /// Pairs of what is still possible.
    pub pairs: Vec<Pair>,
    /// Points in the order in which they help most; one new run.
    pub measurements: Vec<Measurement>,
}

/// Two sets of effects that are still possible; no names: no effect.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Pair {
    /// One set.
    pub one: Vec<&'static str>,
    /// The other.
    pub other: Vec<&'static str>,
    /// How well the data there are tell them apart.
    pub sigma_now: f64,
    /// How well all measurements of the plan tell them apart.
    pub sigma_after: f64,
}

/// Plans for a dataset folder. With `nothing_measured` only the conditions of
/// its rows are used, and every effect of the library is still possible.
///
/// # Errors
/// [`GapError`] for unusable input, and for records of oscillators.
pub fn plan(folder: &Path, nothing_measured: bool, most: usize) -> Result<Plan, GapError> {
    let dataset = Dataset::read(folder)?;
    let Measured::Points { points, .. } = &dataset.measured else {
        return Err(GapError::Usage(
            "a plan is made of sine points; of an oscillator take a record of larger amplitude, and one of half of it".into(),
        ));
    };
    let problem = Problem::new(&dataset.rig, points);
    let proposals = Proposals::new(&dataset.rig, points, &problem, nothing_measured);
    let (verdict, pairs) = if nothing_measured {
        (None, hypotheses::of_library(&proposals.problem))
    } else {
        hypotheses::of_data(&problem, &proposals.problem)
    };
    let old = (!nothing_measured).then_some(&problem);
    let mut duels: Vec<Duel> = pairs
        .list
        .par_iter()
        .filter_map(|(truth, rival)| Duel::new(old, &proposals.problem, pairs.of, [truth, rival]))
        .collect();
    duels.sort_by(|a, b| a.sigma().total_cmp(&b.sigma()));
    let before: Vec<f64> = duels.iter().map(Duel::sigma).collect();
    let mut measurements = Vec::new();
    // Up to the last one that separates anything.
    let mut useful = 0;
    while measurements.len() < most {
        let told: f64 = duels.iter().map(|d| d.square().min(ENOUGH)).sum();
        let Some(measurement) = next(&proposals, &mut duels) else {
            break;
        };
        measurements.push(measurement);
        let now: f64 = duels.iter().map(|d| d.square().min(ENOUGH)).sum();
        if now - told > thresholds::WORTH_A_POINT {
            useful = measurements.len();
        }
    }
    measurements.truncate(useful);
    Ok(Plan {
        verdict,
        pairs: merged(&duels, &before),
        measurements,
    })
}

/// One entry per pair: the direction that is harder to tell.
fn merged(duels: &[Duel], before: &[f64]) -> Vec<Pair> {
    let mut pairs: Vec<Pair> = Vec::new();
    for (duel, sigma_now) in duels.iter().zip(before) {
        let (one, other, sigma_after) = (&duel.truth, &duel.rival, duel.sigma());
        let same = |p: &&mut Pair| p.one == *other && p.other == *one;
        if let Some(pair) = pairs.iter_mut().find(same) {
            pair.sigma_now = pair.sigma_now.min(*sigma_now);
            pair.sigma_after = pair.sigma_after.min(sigma_after);
        } else {
            pairs.push(Pair {
                one: one.clone(),
                other: other.clone(),
                sigma_now: *sigma_now,
                sigma_after,
            });
        }
    }
    pairs
}

/// Takes the point that helps most, if any does.
fn next(proposals: &Proposals, duels: &mut [Duel]) -> Option<Measurement> {
    let worth = |duel: &Duel, gain: f64| (duel.square() + gain).min(ENOUGH) - duel.square();
    let gains: Vec<(f64, usize, usize)> = (0..proposals.list.len())
        .into_par_iter()
        .map(|at| {
            let proposal = &proposals.list[at];
            let mut sum = 0.0;
            let mut most = (0.0, 0);
            for (index, duel) in duels.iter().enumerate() {
                if duel.square() >= ENOUGH {
                    continue;
                }
                let (gain, taught) = duel.gain(proposal.row, &proposal.known);
                let gain = worth(duel, gain);
                // A cause that needs two points to show is found by the first that prepares it.
                sum += gain + thresholds::PREPARES * taught.min(thresholds::MOST_TAUGHT);
                if gain > most.0 {
                    most = (gain, index);
                }
            }
            // Settings that are dear to reach must be worth it.
            (sum / proposal.effort, at, most.1)
        })
        .collect();
    let best = gains.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    if best.0 < thresholds::WORTH_A_POINT {
        return None;
    }
    let proposal = &proposals.list[best.1];
    let look_at = duels[best.2].look_at(proposal.row, &proposal.known);
    duels
        .par_iter_mut()
        .for_each(|duel| duel.add(proposal.row, &proposal.known));
    let duel = &duels[best.2];
    Some(proposals.describe(proposal, look_at, duel))
}
