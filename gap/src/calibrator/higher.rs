//! Where harmonics above those that are reported would show in the noise.

use super::evaluate::Memories;
use super::fit::{Fit, Workspace};
use super::problem::Problem;
use crate::observable::Group;
use crate::thresholds;

/// Mean square of the harmonics above 5 in each row and channel, in V^2, where a fit has any that
/// would show in the noise.
pub(super) fn higher_harmonics(
    problem: &Problem,
    fit: &Fit,
    work: &Workspace,
) -> Option<Vec<[f64; 2]>> {
    // Nothing moves but by a fundamental without effects, and nothing shows without noise columns.
    if fit.effects.is_empty() || problem.data_of_group(Group::Noise).is_empty() {
        return None;
    }
    let healthy_v2 = problem.base.noise_v.map(|v| v * v);
    let mut all = vec![[0.0; 2]; problem.rows.len()];
    let mut any = false;
    let memory = Memories::Look(&work.memory);
    problem.predictions(&fit.effects, &fit.theta, memory, |row, found| {
        all[row] = found.remainder_v2;
        let shows = all[row].iter().zip(healthy_v2);
        any |= shows
            .into_iter()
            .any(|(added, own)| *added > thresholds::HARMONICS_SHOW * own);
    });
    any.then_some(all)
}
