//! An integration as fine as what a fit leaves needs.

use super::fit::{Fitted, refine, residual, rms};
use super::run::Run;
use crate::thresholds;
use rayon::prelude::*;

/// Steps of the fits that lead.
pub(super) const MOST_STEPS: usize = 10;
/// Sets that are refined to the end.
pub(super) const REFINED: usize = 5;

/// Halves the steps of the integration until its error is small beside what the best set leaves,
/// and fits the leading sets anew.
pub(super) fn integrate_finely(run: Run, tried: &mut [Fitted]) -> Run {
    let mut run = run;
    while let (Some(best), Some(finer)) = (tried.first_mut(), run.finer()) {
        let (Some(off), Some(left)) = (best.off(&run, &finer), residual(&best.values, &run)) else {
            break;
        };
        best.integration = off;
        if off < thresholds::RESOLVED_FINELY * rms(&left) {
            break;
        }
        run = finer;
        let leading = tried.len().min(REFINED);
        tried[..leading].par_iter_mut().for_each(|fit| {
            if let Some(mut further) = refine(&run, fit.values, &fit.terms, MOST_STEPS) {
                // Half the steps err by half at most, a kink included.
                further.integration = 0.5 * off;
                *fit = further;
            }
        });
        tried[..leading].sort_by(|a, b| a.square.total_cmp(&b.square));
    }
    run
}
