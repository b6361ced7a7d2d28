//! Which effects to add to which sets.

use super::atom::Promise;
use super::fit::Fit;
use super::slopes::Slopes;
use crate::effects::library;
use std::rc::Rc;

/// Gain of -2 ln likelihood below which a promise is not worth a refinement.
pub(super) const WORTH_REFINING: f64 = 5.0;

/// A set to which effects are added, with its slopes.
pub(super) struct Base {
    pub(super) fit: Fit,
    pub(super) slopes: Option<Slopes>,
}

/// An effect to add to a base, with the objective that the screening predicts.
pub(super) struct Plan {
    pub(super) predicted: f64,
    pub(super) base: Rc<Base>,
    pub(super) promise: Promise,
}

impl Plan {
    pub(super) fn new(base: &Rc<Base>, promise: Promise) -> Self {
        Self {
            predicted: base.fit.objective - promise.gain,
            base: Rc::clone(base),
            promise,
        }
    }

    /// Places in the library of the effects of the set, ascending.
    pub(super) fn entries(&self) -> Vec<usize> {
        let mut entries = entries(&self.base.fit);
        entries.push(self.promise.entry);
        entries.sort_unstable();
        entries
    }

    /// Whether the base holds an effect of the same name.
    pub(super) fn repeats(&self) -> bool {
        let name = library()[self.promise.entry].about().id;
        let mut there = self.base.fit.effects.iter();
        there.any(|e| e.effect.about().id == name)
    }
}

/// Places in the library of the effects of a set, ascending.
pub(super) fn entries(fit: &Fit) -> Vec<usize> {
    let mut entries: Vec<usize> = fit.effects.iter().map(|e| e.entry).collect();
    entries.sort_unstable();
    entries
}

/// The best promises overall and the best of each group.
pub(super) fn chosen(
    promises: &[Promise],
    overall: usize,
    per_group: usize,
    floor: f64,
) -> Vec<Promise> {
    let mut counts = [0; 3];
    let mut list = Vec::new();
    for (rank, promise) in promises.iter().enumerate() {
        let count = &mut counts[promise.group];
        let in_group = *count < per_group && promise.gain > WORTH_REFINING;
        if (promise.gain > floor && rank < overall) || in_group {
            *count += 1;
            list.push(promise.clone());
        }
    }
    list
}
