//! Scores on whole levels and bands that a fit has not seen.
//!
//! A cause that wins at one level can lose at another. So each level, and each
//! band, is left out in turn: the leading set and the plain simulation are fitted
//! to all other rows, and only what is better there by more than the cost of its
//! effects is taken to the rows left out. The fits start from those to all rows.

use super::fit::{Effort, Fit, Linearised, Slopes, Workspace, follow};
use super::holdout::{Slice, score_on};
use super::problem::Problem;
use super::search::COST;
use crate::dataset::Rig;
use crate::model::row::Row;

/// Most levels, or bands, of a dataset: equal steps of the logarithm.
const MOST: usize = 4;
/// From fits to all rows the rest needs few steps.
const EFFORT: Effort = Effort {
    most_steps: 4,
    enough: 0.5,
};

/// What rows are told apart by.
type Axis = fn(&Row) -> f64;
const LEVEL: Axis = |row| row.level_ms2;
const BAND: Axis = |row| row.frequency_hz;

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
    [LEVEL, BAND].map(|axis| {
        let groups = groups(&problem.rows, axis);
        let score = |(at, group): (usize, &Group)| {
            let mut slice = whole.without(group, axis)?;
            slice.beyond = at == 0 || at + 1 == groups.len();
            Some(slice)
        };
        groups.iter().enumerate().filter_map(score).collect()
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
    [LEVEL, BAND].map(|axis| {
        let known = range(&fitted.rows, axis);
        let of = |group: &Group| {
            let part = other.subset(rig, &|row| group.holds(axis(&other.rows[row])));
            let gap = score_on(fitted, &part, nominal, best);
            let mut slice = Slice::new((group.from, group.to), &gap);
            slice.beyond = group.from < known.0 || group.to > known.1;
            slice
        };
        groups(&other.rows, axis).iter().map(of).collect()
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
    fn without(&self, group: &Group, axis: Axis) -> Option<Slice> {
        let inside = |row: usize| group.holds(axis(&self.problem.rows[row]));
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
        let cost = COST * best.effects.len() as f64;
        let chosen = if best.objective + cost < nominal.objective {
            &best
        } else {
            &nominal
        };
        let gap = score_on(&rest, &part, &nominal, chosen);
        Some(Slice::new((group.from, group.to), &gap))
    }
}

/// Rows of a level or a band.
struct Group {
    from: f64,
    to: f64,
}

impl Group {
    fn holds(&self, value: f64) -> bool {
        (self.from..=self.to).contains(&value)
    }
}

/// Lowest and highest value of what was stated.
fn range(rows: &[Row], axis: Axis) -> (f64, f64) {
    let stated = rows.iter().map(axis).filter(|v| *v > 0.0 && v.is_finite());
    stated.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)))
}

/// Groups of rows by equal steps of a logarithm; none where there is one value only.
fn groups(rows: &[Row], axis: Axis) -> Vec<Group> {
    let (lowest, highest) = range(rows, axis);
    if highest <= 1.01 * lowest {
        return Vec::new();
    }
    let step = (highest / lowest).ln() / MOST as f64;
    let place = |value: f64| (((value / lowest).ln() / step) as usize).min(MOST - 1);
    let of = |at: usize| {
        let stated = rows.iter().map(axis).filter(|v| *v > 0.0 && v.is_finite());
        let inside = stated.filter(|v| place(*v) == at);
        inside.fold(None, |group: Option<Group>, value| {
            let (from, to) = group.map_or((value, value), |g| (g.from, g.to));
            Some(Group {
                from: value.min(from),
                to: value.max(to),
            })
        })
    };
    (0..MOST).filter_map(of).collect()
}
