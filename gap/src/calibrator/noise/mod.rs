//! Noise as the data show it, where it is not as stated.
//!
//! No stated uncertainty is right to the last digit, and every long table has a misread row. Each set
//! that a first search holds possible is fitted with the rows left out that it cannot hold
//! (`outliers`); what the best of them leaves is examined for its size and its memory (`colour`). Only
//! what looks like noise in every order of the rows changes what the diagnosis goes by: structure stays
//! a gap.

mod colour;
mod outliers;

use super::fit::{Fit, Workspace};
use super::problem::Problem;
use crate::answer::OwnNoise;
use crate::dataset::Rig;
use crate::observable::Group;
use crate::thresholds;
use colour::{Colour, Demand};
use outliers::Kept;

/// Noise that is not what is stated.
#[derive(Debug, Clone)]
pub(super) struct Noise {
    /// By group of observables: scatter over the stated uncertainty; 1 where that holds.
    pub(super) factor: [f64; Group::ALL.len()],
    /// By group: share of its deviate that a row remembers of the row before; 0 where none.
    pub(super) memory: [f64; Group::ALL.len()],
    /// Rows that nothing describes which describes the others, from 0.
    pub(super) outliers: Vec<usize>,
}

impl Noise {
    /// The noise beside the best of some fits; none where it is as stated.
    pub(super) fn of(
        problem: &Problem,
        rig: &Rig,
        fits: impl Iterator<Item = Fit>,
        work: &mut Workspace,
    ) -> Option<Self> {
        let kept: Vec<Kept> = fits.map(|fit| Kept::new(problem, rig, fit, work)).collect();
        let scale2 = kept.iter().map(Kept::scale2).fold(f64::INFINITY, f64::min);
        let score = |kept: &&Kept| kept.score(problem, scale2.max(1.0));
        let best = kept.iter().min_by(|a, b| score(a).total_cmp(&score(b)))?;
        let mut noise = Self {
            factor: [1.0; Group::ALL.len()],
            memory: [0.0; Group::ALL.len()],
            outliers: best.dropped.clone(),
        };
        let colours = Group::ALL.map(|group| Colour::of(best, group));
        for demand in [Demand::OfFirst, Demand::OfOthers] {
            // What one group shows plainly is believed of others sooner.
            if demand == Demand::OfOthers && noise.is_as_stated() {
                break;
            }
            let remembers = noise.remembers();
            for (at, colour) in colours.iter().enumerate() {
                let Some(colour) = colour else { continue };
                if demand == Demand::OfFirst || remembers {
                    noise.memory[at] = colour.memory(demand);
                }
                noise.factor[at] = colour.factor(demand, noise.memory[at] > 0.0);
            }
        }
        noise.outliers.sort_unstable();
        (!noise.is_as_stated()).then_some(noise)
    }

    /// Whether single rows are all that is not as stated.
    pub(super) fn is_of_rows_only(&self) -> bool {
        self.factor.iter().all(|f| *f == 1.0) && !self.remembers()
    }

    /// Whether the size of the noise is all that is not as stated: every row is still as good as another, and the
    /// sets that were found there do not describe what rows remember.
    pub(super) fn is_of_size_only(&self) -> bool {
        self.outliers.is_empty() && !self.remembers()
    }

    fn is_as_stated(&self) -> bool {
        self.outliers.is_empty() && self.is_of_rows_only()
    }

    /// Whether rows remember those before them.
    pub(super) fn remembers(&self) -> bool {
        self.memory.iter().any(|m| *m > 0.0)
    }

    /// The problem with this noise: misread rows left out, uncertainties as they are.
    ///
    /// Where rows remember, their mean is as uncertain as that of fewer independent ones; the
    /// uncertainty of each is raised by as much.
    pub(super) fn applied(&self, problem: &Problem, rig: &Rig) -> Problem {
        let factors = self.factor.iter().zip(&self.memory);
        let factors: Vec<f64> = factors.map(|(f, m)| f * hidden_by(*m)).collect();
        let factor = |group: Group| {
            let at = Group::ALL.iter().position(|g| *g == group);
            at.map_or(1.0, |at| factors[at])
        };
        problem.with_uncertainties(rig, &|row| !self.outliers.contains(&row), &factor)
    }
}

/// Factor on the uncertainty of a mean over many rows, of which each remembers a share of the one before.
fn hidden_by(memory: f64) -> f64 {
    ((1.0 + memory) / (1.0 - memory).max(thresholds::LEAST_FORGOTTEN)).sqrt()
}

/// The noise as an answer states it.
pub(super) fn stated(noise: &Noise) -> OwnNoise {
    let by_group = |values: &[f64; Group::ALL.len()], none: f64| {
        let groups = Group::ALL.iter().zip(values);
        let found = groups.filter(|(_, value)| **value != none);
        found.map(|(group, value)| (*group, *value)).collect()
    };
    OwnNoise {
        factor_on_u: by_group(&noise.factor, 1.0),
        memory: by_group(&noise.memory, 0.0),
        outlier_rows: noise.outliers.iter().map(|row| row + 1).collect(),
    }
}
