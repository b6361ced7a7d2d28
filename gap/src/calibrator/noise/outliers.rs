//! Rows that a set of effects cannot hold while it holds all others.

use crate::calibrator::evaluation::Evaluation;
use crate::calibrator::fit::{Fit, Workspace};
use crate::calibrator::problem::Problem;
use crate::calibrator::refine::{FULL, refine};
use crate::dataset::Rig;
use crate::estimation::descent::Effort;
use crate::estimation::significance::two_sided;
use crate::observable::Group;
use crate::thresholds;

/// A fit to the rows that it can hold.
pub(super) struct Kept {
    /// Those rows.
    pub(super) problem: Problem,
    pub(super) fit: Fit,
    pub(super) evaluation: Evaluation,
    /// The others, by their number in the whole.
    pub(super) dropped: Vec<usize>,
}

impl Kept {
    /// Drops the worst row and fits anew, until no row stands out; none where too many do.
    ///
    /// A fit that leaves more than noise without a row gets a few steps: the next row is dropped from there.
    pub(super) fn new(whole: &Problem, rig: &Rig, fit: Fit, work: &mut Workspace) -> Self {
        let most = thresholds::FEW_OUTLIERS.max(whole.rows.len() / thresholds::ROWS_PER_OUTLIER);
        let most = most.min(whole.rows.len() / thresholds::LEAST_ROWS_PER_OUTLIER);
        let start = Self::fitted(whole.clone(), fit, FULL, work.clone(), Vec::new());
        let mut rows: Vec<usize> = (0..whole.rows.len()).collect();
        let mut now = None;
        let mut dropped = Vec::new();
        while let Some(worst) = now.as_ref().unwrap_or(&start).outlier() {
            let misread = now.as_ref().unwrap_or(&start).is_misread(worst);
            if dropped.len() == most || !misread {
                return start;
            }
            dropped.push(rows.remove(worst));
            let last = now.as_ref().unwrap_or(&start);
            let kept = last.problem.subset(rig, &|row| row != worst);
            let mut fit = last.fit.clone();
            fit.theta = kept.translate(&last.problem, &fit.theta);
            let work = Workspace::new(&kept);
            let effort = Effort {
                within: kept.most_of_noise(),
                ..FULL
            };
            now = Some(Self::fitted(kept, fit, effort, work, dropped.clone()));
        }
        now.unwrap_or(start)
    }

    fn fitted(
        problem: Problem,
        from: Fit,
        effort: Effort,
        mut work: Workspace,
        dropped: Vec<usize>,
    ) -> Self {
        let fit = refine(&problem, from.effects, from.theta, effort, &mut work);
        let evaluation = problem.evaluate(&fit.effects, &fit.theta, &mut work.memory);
        Self {
            problem,
            fit,
            evaluation,
            dropped,
        }
    }

    /// The row that stands out most of the scatter of its observables.
    fn outlier(&self) -> Option<usize> {
        let mut worst: Option<(f64, usize)> = None;
        for (_, data) in self.problem.measured_observables() {
            let scale = scale(&self.evaluation.residual[data.clone()]).max(1.0);
            for at in data {
                let deviate = self.evaluation.residual[at].abs() / scale;
                if worst.is_none_or(|(most, _)| deviate > most) {
                    worst = Some((deviate, self.problem.row_of[at]));
                }
            }
        }
        worst.filter(|w| self.stands_out(w.0)).map(|w| w.1)
    }

    fn stands_out(&self, deviate: f64) -> bool {
        let count = self.problem.len() as f64;
        deviate > thresholds::OUTLIER_SIGMA
            && count * two_sided(deviate) < thresholds::OUTLIER_P_VALUE
    }

    /// Whether one or two readings of a row stand out. Where more do, or its wave is bent, something
    /// happened in it: clipping may show in the largest row alone.
    fn is_misread(&self, row: usize) -> bool {
        let stands_out = |group: &Group| {
            let data = self.problem.data_of_group(*group);
            let scale = scale(&self.evaluation.residual[data.clone()]).max(1.0);
            let mut own = data.filter(|at| self.problem.row_of[*at] == row);
            own.any(|at| self.stands_out(self.evaluation.residual[at].abs() / scale))
        };
        let readings: Vec<&Group> = Group::ALL.iter().filter(|g| stands_out(g)).collect();
        readings.len() <= thresholds::MOST_READINGS
            && readings.iter().all(|group| group.is_response())
    }

    /// Square of the scatter over the stated one, by the middle of the data.
    pub(super) fn scale2(&self) -> f64 {
        scale(&self.evaluation.residual).powi(2)
    }

    /// -2 ln posterior at that scatter, with what effects and dropped rows cost.
    pub(super) fn score(&self, whole: &Problem, scale2: f64) -> f64 {
        let missing = (whole.len() - self.problem.len()) as f64;
        let rows = thresholds::ROW_COST * self.dropped.len() as f64;
        let effects = thresholds::EFFECT_COST * self.fit.effects.len() as f64;
        self.fit.objective / scale2 + missing + rows + effects
    }
}

/// Standard deviation of most of the values: 1.4826 times their median distance from zero.
pub(super) fn scale(values: &[f64]) -> f64 {
    let mut sizes: Vec<f64> = values.iter().map(|v| v.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).map_or(0.0, |m| 1.4826 * m)
}
