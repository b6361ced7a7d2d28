//! Diagnosis of a dataset, or of many.

use crate::answer::{Answer, DatasetSummary};
use crate::calibrator::diagnose_points;
use crate::calibrator::problem::Problem;
use crate::dataset::{Dataset, Measured};
use crate::error::GapError;
use crate::options::Options;
use rayon::prelude::*;
use std::path::Path;

/// Diagnoses a dataset folder.
///
/// # Errors
/// [`GapError`] for unusable input; a gap that cannot be explained is an answer.
pub fn diagnose(folder: &Path, options: &Options) -> Result<Answer, GapError> {
    for name in &options.without {
        crate::effects::check_name(name)?;
    }
    let dataset = Dataset::read(folder)?;
    let validate = options.validate.as_deref().map(Dataset::read).transpose()?;
    let path = folder.display().to_string();
    match &dataset.measured {
        Measured::Record(record) => {
            crate::oscillator::diagnose(path, &dataset, record, validate.as_ref(), options)
        }
        Measured::Points {
            points, columns, ..
        } => {
            if matches!(
                validate.as_ref().map(|v| &v.measured),
                Some(Measured::Record(_))
            ) {
                return Err(GapError::Usage(
                    "--validate needs points of a calibrator too".into(),
                ));
            }
            let problem = Problem::new(&dataset.rig, points);
            if problem.len() < 2 {
                return Err(GapError::Table {
                    file: "points.csv",
                    problem: "holds nothing that rig.toml lets simulate; a ratio, or drive with a complete [exciter], is needed".into(),
                });
            }
            let summary = DatasetSummary {
                path,
                rows: points.len(),
                columns_used: columns.clone(),
                sha256: dataset.sha256.clone(),
            };
            Ok(diagnose_points(
                &dataset,
                &problem,
                validate.as_ref(),
                options,
                summary,
            ))
        }
    }
}

/// Diagnoses many datasets on all cores; `progress(done, all)` is called after each.
pub fn diagnose_all(
    folders: &[std::path::PathBuf],
    options: &Options,
    progress: impl Fn(usize, usize) + Sync,
) -> Vec<Result<Answer, GapError>> {
    let done = std::sync::atomic::AtomicUsize::new(0);
    folders
        .par_iter()
        .map(|folder| {
            let answer = diagnose(folder, options);
            progress(
                done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1,
                folders.len(),
            );
            answer
        })
        .collect()
}
