//! Scores on whole levels and bands that a fit has not seen.
//!
//! A cause that wins at one level can lose at another. So each level, and each
//! band, is left out in turn: the leading set and the plain simulation are fitted
//! to all other rows, and only what is better there by more than the cost of its
//! effects is taken to the rows left out. The fits start from those to all rows.

use super::fit::{Fit, Workspace};
use super::holdout::score_on;
use super::linear::{Linearised, Slopes};
use super::problem::Problem;
use super::refine::{FULL, follow};
use crate::dataset::Rig;
use crate::estimation::descent::Effort;
use crate::estimation::gap::Slice;
use crate::model::row::Row;
use crate::thresholds;

/// From fits to all rows the rest needs few steps.
const EFFORT: Effort = Effort {
    most_steps: 4,
    enough: 0.5,
    ..FULL
};

/// Conditions that tell rows apart.
type Condition = fn(&Row) -> f64;
const LEVEL: Condition = |row| row.level_ms2;
const BAND: Condition = |row| row.frequency_hz;

/// Scores by level, then by band, each level and band left out in turn.
pub(crate) fn left_out(
    problem: &Problem,
    rig: &Rig,
    nominal: &Fit,
    best: &Fit,
    work: &mut Workspace,
) -> [Vec<Slice>; 2] {
    let slopes = Linearised::new(problem, best, work).all_slopes();
    let whole = Whole {
        problem,
        rig,
        nominal,
        best,
        slopes: &slopes,
        work,
    };
    [LEVEL, BAND].map(|condition| {
        let folds = folds(&stated(&problem.rows, condition));
        let score = |(at, fold): (usize, &Fold)| {
            let mut slice = whole.without(fold, condition)?;
            slice.beyond = at == 0 || at + 1 == folds.len();
            Some(slice)
        };
        folds.iter().enumerate().filter_map(score).collect()
    })
}

/// Scores by level, then by band, of another dataset on which nothing was fitted.
pub(crate) fn of_other(
    fitted: &Problem,
    other: &Problem,
    rig: &Rig,
    nominal: &Fit,
    best: &Fit,
) -> [Vec<Slice>; 2] {
    [LEVEL, BAND].map(|condition| {
        let known = range(&stated(&fitted.rows, condition));
        let of = |fold: &Fold| {
            let part = other.subset(rig, &|row| fold.holds(condition(&other.rows[row])));
            let gap = score_on(fitted, &part, nominal, best);
            let mut slice = Slice::new((fold.from, fold.to), &gap);
            slice.beyond = fold.from < known.0 || fold.to > known.1;
            slice
        };
        folds(&stated(&other.rows, condition))
            .iter()
            .map(of)
            .collect()
    })
}

struct Whole<'a> {
    problem: &'a Problem,
    rig: &'a Rig,
    nominal: &'a Fit,
    best: &'a Fit,
    slopes: &'a Slopes,
    work: &'a Workspace,
}

impl Whole<'_> {
    fn without(&self, fold: &Fold, condition: Condition) -> Option<Slice> {
        let inside = |row: usize| fold.holds(condition(&self.problem.rows[row]));
        let rest = self.problem.subset(self.rig, &|row| !inside(row));
        let part = self.problem.subset(self.rig, &inside);
        if rest.len() == 0 || part.len() == 0 {
            return None;
        }
        let rows = (0..self.problem.rows.len()).filter(|row| !inside(*row));
        let mut work = Workspace {
            memory: rows.map(|row| self.work.memory[row].clone()).collect(),
        };
        let slopes = self
            .slopes
            .of_part(self.problem, &rest, &|row| !inside(row));
        let mut fitted = |fit: &Fit| {
            let mut start = fit.clone();
            start.theta = rest.translate(self.problem, &fit.theta);
            follow(&rest, start, &slopes, EFFORT, &mut work)
        };
        let nominal = fitted(self.nominal);
        let best = if self.best.effects.is_empty() {
            nominal.clone()
        } else {
            fitted(self.best)
        };
        let cost = thresholds::EFFECT_COST * best.effects.len() as f64;
        let chosen = if best.objective + cost < nominal.objective {
            &best
        } else {
            &nominal
        };
        let gap = score_on(&rest, &part, &nominal, chosen);
        Some(Slice::new((fold.from, fold.to), &gap))
    }
}

/// Rows of a level or a band.
struct Fold {
    from: f64,
    to: f64,
}

impl Fold {
    fn holds(&self, value: f64) -> bool {
        (self.from..=self.to).contains(&value)
    }
}

/// Values of a condition that rows state.
fn stated(rows: &[Row], condition: Condition) -> Vec<f64> {
    let values = rows.iter().map(condition);
    values.filter(|v| *v > 0.0 && v.is_finite()).collect()
}

/// Lowest and highest value.
fn range(values: &[f64]) -> (f64, f64) {
    let ends = (f64::INFINITY, 0.0_f64);
    values.iter().fold(ends, |(a, b), v| (a.min(*v), b.max(*v)))
}

/// Groups of values by equal steps of the logarithm; none where there is one value only.
fn folds(values: &[f64]) -> Vec<Fold> {
    let (lowest, highest) = range(values);
    if highest <= thresholds::ONE_LEVEL * lowest {
        return Vec::new();
    }
    let step = (highest / lowest).ln() / thresholds::MOST_SLICES as f64;
    // Levels that were held alike are one level.
    let place = |value: f64| {
        let alike =
            ((value / lowest).ln() / thresholds::LEVELS_ALIKE).round() * thresholds::LEVELS_ALIKE;
        ((alike / step + 1e-9) as usize).min(thresholds::MOST_SLICES - 1)
    };
    let of = |at: usize| {
        let inside: Vec<f64> = values.iter().copied().filter(|v| place(*v) == at).collect();
        let (from, to) = range(&inside);
        (!inside.is_empty()).then_some(Fold { from, to })
    };
    (0..thresholds::MOST_SLICES).filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_that_were_held_alike_stay_together() {
        // Two decades in four steps: edges at 3.16, 10 and 31.6.
        let levels = [1.0, 3.0, 9.999_999, 10.0, 10.000_001, 30.0, 100.0];
        let found: Vec<(f64, f64)> = folds(&levels).iter().map(|g| (g.from, g.to)).collect();
        assert_eq!(found, [(1.0, 3.0), (9.999_999, 30.0), (100.0, 100.0)]);
        assert!(folds(&[10.0, 10.000_001]).is_empty());
    }
}
