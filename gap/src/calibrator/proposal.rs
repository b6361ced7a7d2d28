//! Which effects to add to which sets.

use super::candidate::PredictedGain;
use super::fit::Fit;
use super::linear::Slopes;
use crate::effects::library;
use crate::thresholds;
use std::rc::Rc;

/// A set to which effects are added, with its slopes.
pub(super) struct Base {
    pub(super) fit: Fit,
    pub(super) slopes: Option<Slopes>,
}

/// An effect to add to a base, with the objective that the screening predicts.
pub(super) struct Plan {
    pub(super) predicted: f64,
    pub(super) base: Rc<Base>,
    pub(super) predicted_gain: PredictedGain,
}

impl Plan {
    pub(super) fn new(base: &Rc<Base>, predicted_gain: PredictedGain) -> Self {
        Self {
            predicted: base.fit.objective - predicted_gain.gain,
            base: Rc::clone(base),
            predicted_gain,
        }
    }

    /// Places in the library of the effects of the set, ascending.
    pub(super) fn entries(&self) -> Vec<usize> {
        let mut entries = entries(&self.base.fit);
        entries.push(self.predicted_gain.entry);
        entries.sort_unstable();
        entries
    }

    /// Whether the base holds an effect of the same name.
    pub(super) fn repeats(&self) -> bool {
        let name = library()[self.predicted_gain.entry].entry().id;
        let mut there = self.base.fit.effects.iter();
        there.any(|e| e.effect.entry().id == name)
    }
}

/// Places in the library of the effects of a set, ascending.
pub(super) fn entries(fit: &Fit) -> Vec<usize> {
    let mut entries: Vec<usize> = fit.effects.iter().map(|e| e.entry).collect();
    entries.sort_unstable();
    entries
}

/// The candidates of the largest predicted gains, overall and in each group.
pub(super) fn chosen(
    predicted: &[PredictedGain],
    overall: usize,
    per_group: usize,
    floor: f64,
) -> Vec<PredictedGain> {
    let mut counts = [0; 3];
    let mut list = Vec::new();
    for (rank, predicted_gain) in predicted.iter().enumerate() {
        let count = &mut counts[predicted_gain.group];
        let in_group = *count < per_group && predicted_gain.gain > thresholds::WORTH_REFINING;
        if (predicted_gain.gain > floor && rank < overall) || in_group {
            *count += 1;
            list.push(predicted_gain.clone());
        }
    }
    list
}
