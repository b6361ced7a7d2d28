//! The share of the gap that is closed on rows that took no part, observable by observable.

use super::fit::Fit;
use super::problem::Problem;
use crate::dataset::Rig;
use crate::estimation::gap::{Gap, GapSize, closed_share};
use crate::observable::{Group, Observable};
use crate::thresholds;
use std::collections::BTreeMap;

/// Rows to choose and fit on, and rows that take no part: every third frequency.
pub(crate) fn split(problem: &Problem, rig: &Rig) -> (Problem, Problem) {
    let held = held_out(problem);
    let training = problem.subset(rig, &|row| !held[row]);
    let testing = problem.subset(rig, &|row| held[row]);
    (training, testing)
}

/// Every third frequency; every third row where there are few frequencies.
pub(crate) fn held_out(problem: &Problem) -> Vec<bool> {
    let frequencies = &problem.facts.frequencies_hz;
    if frequencies.len() < thresholds::FEWEST_FREQUENCIES {
        return (0..problem.rows.len()).map(|i| i % 3 == 1).collect();
    }
    problem
        .rows
        .iter()
        .map(|r| frequencies.partition_point(|f| *f < r.frequency_hz) % 3 == 1)
        .collect()
}

/// Scores fits of one problem on another with the same rig.
pub(crate) fn score_on(training: &Problem, testing: &Problem, nominal: &Fit, chosen: &Fit) -> Gap {
    let compared = Compared::by_group(training, testing, nominal, chosen);
    let mut responses = Group::RESPONSES.into_iter();
    let has_response = responses.any(|group| !testing.data_of_group(group).is_empty());
    let mut pooled = Compared::default();
    let mut by_observable = BTreeMap::new();
    let (mut closed, mut weights) = (0.0, 0.0);
    for (compared, group) in compared.iter().zip(Group::ALL) {
        if compared.before.rows == 0.0 {
            continue;
        }
        let gap = compared.gap();
        if let Some(share) = gap.closed {
            closed += share * compared.excess();
            weights += compared.excess();
        }
        let counts = group.is_response() || !has_response;
        pool(&mut pooled, compared, counts);
        by_observable.insert(group, gap);
    }
    let closed = if weights > 0.0 {
        Some(closed / weights)
    } else {
        // No observable stands out of its noise by itself: what all of them together show.
        let is_gap = pooled.before.square > pooled.before.floor;
        (!chosen.effects.is_empty() && is_gap).then(|| pooled.share())
    };
    Gap {
        size: pooled.size(closed),
        held_out_rows: testing.rows.len(),
        chosen: chosen.names(),
        rms_before: None,
        rms_after: None,
        by_observable,
        by_level: Vec::new(),
        by_band: Vec::new(),
    }
}

/// Adds a group to the sums over all; relative errors of responses stand for themselves.
fn pool(pooled: &mut Compared, one: &Compared, counts: bool) {
    let sums = [&mut pooled.before, &mut pooled.after].into_iter();
    for (sum, errors) in sums.zip([&one.before, &one.after]) {
        if counts {
            sum.square += errors.square;
            sum.floor += errors.floor;
            sum.rows += errors.rows;
        }
        sum.chi += errors.chi;
        sum.data += errors.data;
    }
}

/// Sums over the data of a group.
#[derive(Clone, Copy, Default)]
pub(super) struct Errors {
    /// Of squared errors; relative to the signal where they are voltages.
    pub(super) square: f64,
    /// Of squared standard uncertainties, likewise.
    pub(super) floor: f64,
    /// Rows with data.
    pub(super) rows: f64,
    /// Of squared errors in standard uncertainties.
    pub(super) chi: f64,
    /// Number of data.
    pub(super) data: f64,
}

impl Errors {
    /// Errors of a fit of `training` on each group of `testing`.
    fn of(fit: &Fit, training: &Problem, testing: &Problem) -> [Self; Group::ALL.len()] {
        let theta = testing.translate(training, &fit.theta);
        let evaluation = testing.evaluate(&fit.effects, &theta, &mut testing.memory());
        Group::ALL.map(|group| {
            let mut errors = Self::default();
            let mut seen = vec![false; testing.rows.len()];
            for at in testing.data_of_group(group) {
                let difference = evaluation.residual[at] / evaluation.weight[at];
                let scale = if group == Group::Dc {
                    over_peak(testing, at)
                } else {
                    1.0
                };
                if scale.is_finite() {
                    errors.square += (difference * scale).powi(2);
                    errors.floor += (testing.uncertainty(at) * scale).powi(2);
                }
                errors.chi += evaluation.residual[at].powi(2);
                errors.data += 1.0;
                seen[testing.row_of[at]] = true;
            }
            errors.rows = seen.iter().filter(|s| **s).count() as f64;
            errors
        })
    }
}

/// Factor that makes a mean, in V, relative to the amplitude of its channel.
fn over_peak(problem: &Problem, at: usize) -> f64 {
    let row = &problem.rows[problem.row_of[at]];
    let of_dut = problem.data_of(Observable::DutDc).contains(&at);
    1.0 / if of_dut {
        row.dut_peak_v
    } else {
        row.ref_peak_v
    }
}

/// Errors of the plain simulation and of one with effects on the same data.
#[derive(Clone, Copy, Default)]
pub(super) struct Compared {
    pub(super) before: Errors,
    pub(super) after: Errors,
}

impl Compared {
    /// Compares fits of `training` on each group of `testing`.
    pub(super) fn by_group(
        training: &Problem,
        testing: &Problem,
        nominal: &Fit,
        chosen: &Fit,
    ) -> [Self; Group::ALL.len()] {
        let before = Errors::of(nominal, training, testing);
        let after = Errors::of(chosen, training, testing);
        std::array::from_fn(|i| Self {
            before: before[i],
            after: after[i],
        })
    }

    /// Root mean square relative errors before and after, and what noise alone leaves.
    pub(super) fn errors_rel(&self) -> [f64; 3] {
        let rows = self.before.rows.max(1.0);
        let sums = [self.before.square, self.after.square, self.before.floor];
        sums.map(|sum| (sum / rows).sqrt())
    }

    /// Root mean square of error over standard uncertainty, before and after.
    pub(super) fn chi(&self) -> [f64; 2] {
        let data = self.before.data.max(1.0);
        [self.before, self.after].map(|errors| (errors.chi / data).sqrt())
    }

    /// Share of the gap that is closed.
    pub(super) fn share(&self) -> f64 {
        let [before, after, floor] = self.errors_rel();
        closed_share(before, after, floor)
    }

    /// Chi-square of the plain simulation beyond what noise leaves.
    pub(super) fn excess(&self) -> f64 {
        self.before.chi - self.before.data
    }

    /// The gap of a group; a share of it only where it stands out of the noise.
    pub(super) fn gap(&self) -> GapSize {
        let [before, _, floor] = self.errors_rel();
        let is_gap = self.excess() > thresholds::GAP_SHOWN_SIGMA * (2.0 * self.before.data).sqrt()
            && before > floor;
        self.size(is_gap.then(|| self.share()))
    }

    /// The size of the gap, of which a share is closed.
    pub(super) fn size(&self, closed: Option<f64>) -> GapSize {
        let [before_rel, after_rel, floor_rel] = self.errors_rel();
        let [chi_before, chi_after] = self.chi();
        GapSize {
            before_rel,
            after_rel,
            floor_rel,
            closed,
            chi_before,
            chi_after,
        }
    }
}
