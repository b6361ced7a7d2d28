//! How good the substitutes are that a diagnosis finds for an effect it has to do without.

use super::answers::{ScoredAnswer, matched};
use crate::truth::Truth;
use calib_files::{Error, Result};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Remainder of the first cause of each withheld case beyond that of the true effects, both
/// fitted to the dataset in `folder`, in standard uncertainties of the whole dataset; by the name of
/// the case. A substitute that leaves nothing is as good as the truth, and no answer can tell.
/// Left out is what cannot be known: an effect that another's library has, a dataset that is gone.
///
/// # Errors
/// [`Error::Input`] for datasets that cannot be read, and for answers about others.
pub fn left_by_substitutes(
    folder: &Path,
    answers: &[ScoredAnswer],
    truth: &Truth,
    progress: impl Fn(usize, usize) + Sync,
) -> Result<BTreeMap<String, f64>> {
    let withheld = matched(answers, truth)?.into_iter().filter_map(|pair| {
        let effects = &pair.answer?.causes.first()?.effects;
        let is_known = effects.iter().all(|e| calib_gap::check_name(e).is_ok())
            && folder.join(&pair.truth.name).is_dir();
        (pair.truth.is_withheld() && is_known).then_some((pair.truth, effects))
    });
    let withheld: Vec<_> = withheld.collect();
    let done = AtomicUsize::new(0);
    withheld
        .par_iter()
        .map(|(case, substitute)| {
            let dataset = folder.join(&case.name);
            let misfit = |effects: &[String]| {
                let names: Vec<&str> = effects.iter().map(String::as_str).collect();
                calib_gap::misfit(&dataset, &names).map_err(|error| {
                    let hint = "score beside the set as it was sealed";
                    Error::input(dataset.display().to_string(), error.to_string(), hint)
                })
            };
            let left = misfit(substitute)? - misfit(&case.names)?;
            progress(done.fetch_add(1, Ordering::Relaxed) + 1, withheld.len());
            Ok((case.name.clone(), left.max(0.0).sqrt()))
        })
        .collect()
}
