//! A set of effects as a search has it.

use super::problem::Problem;
use crate::model::effect::Active;
use crate::model::memory::Memory;

/// A refined set of effects.
#[derive(Clone)]
pub(crate) struct Fit {
    /// Library entries and their parameters.
    pub(crate) effects: Vec<Active<'static>>,
    /// Nuisance values in units of their uncertainty.
    pub(crate) theta: Vec<f64>,
    /// -2 ln posterior at the optimum.
    pub(crate) objective: f64,
}

impl Fit {
    /// Number of parameters of the effects.
    pub(crate) fn parameter_count(&self) -> usize {
        self.effects.iter().map(|e| e.parameters.len()).sum()
    }

    /// Names of the effects in the order in which they were found.
    pub(crate) fn names(&self) -> Vec<&'static str> {
        self.effects.iter().map(|e| e.effect.entry().id).collect()
    }

    /// Names of the effects, the same for the same set.
    pub(crate) fn sorted_names(&self) -> Vec<&'static str> {
        let mut names = self.names();
        names.sort_unstable();
        names
    }

    /// Whether a library entry takes part.
    pub(crate) fn has(&self, entry: usize) -> bool {
        self.effects.iter().any(|e| e.entry == entry)
    }
}

/// Memory of balances, reused between refinements of one problem.
#[derive(Clone)]
pub(crate) struct Workspace {
    pub(crate) memory: Vec<Memory>,
}

impl Workspace {
    pub(crate) fn new(problem: &Problem) -> Self {
        Self {
            memory: problem.memory(),
        }
    }
}
