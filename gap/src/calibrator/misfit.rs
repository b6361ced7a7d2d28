//! How badly given effects describe a dataset.

use super::limits::Limits;
use super::problem::Problem;
use super::search::search;
use crate::dataset::Dataset;
use crate::error::GapError;
use std::path::Path;

/// -2 ln posterior density (up to a constant of the dataset) of the best fit with just these effects,
/// or some of them.
///
/// The square root of the difference between two sets is the size of what
/// tells them apart, in standard deviations of the whole dataset. With the
/// true effects named it is the best any method can do.
///
/// # Errors
/// [`GapError`] for unusable input, an unknown name, or a record instead of points.
pub fn misfit(folder: &Path, effects: &[&str]) -> Result<f64, GapError> {
    for name in effects {
        crate::effects::check_name(name)?;
    }
    let dataset = Dataset::read(folder)?;
    let problem = Problem::from_dataset(&dataset.rig, &dataset.measured)
        .ok_or_else(|| GapError::Usage("only a dataset of points has a misfit by effect".into()))?;
    let limits = Limits::only(effects);
    let found = search(&problem, &limits);
    let each = found.every.iter().map(|fit| fit.objective);
    Ok(each.fold(found.nominal.objective, f64::min))
}
