//! Diagnosis of a dataset, or of many.

use crate::answer::{Answer, DatasetSummary};
use crate::calibrator::diagnose_points;
use crate::calibrator::problem::Problem;
use crate::dataset::{Dataset, ExciterParameter, Measured, Rig};
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
                return Err(nothing_simulated(&dataset.rig));
            }
            let summary = DatasetSummary {
                path,
                rows: points.len(),
                columns_used: columns.clone(),
                input_held: None,
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

/// No column can be compared with the rig: which may be, and what that lacks.
fn nothing_simulated(rig: &Rig) -> GapError {
    let lacking = ExciterParameter::ALL.into_iter();
    let known =
        |parameter: &ExciterParameter| rig.exciter.is_some_and(|all| all[*parameter].is_some());
    let lacking = lacking.filter(|parameter| !known(parameter));
    let lacking: Vec<&str> = lacking.map(ExciterParameter::name).collect();
    let of_exciter = match lacking.is_empty() {
        true => String::new(),
        false => format!(" (missing there: {})", lacking.join(", ")),
    };
    GapError::Table {
        file: "points.csv",
        problem: format!(
            "holds nothing that rig.toml lets simulate; needed is ratio (or dut_v and ref_v), or ref_v or coil_a \
             with coil_v and a complete [exciter]{of_exciter}"
        ),
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
