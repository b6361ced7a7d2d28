//! Errors of the diagnosis as errors of the tool.

use calib_gap::GapError;
use calib_host::Error;
use std::path::Path;

/// A misuse of the library of effects as an error of the tool.
pub(super) fn refused(error: GapError) -> Error {
    unusable(Path::new("dataset"), error)
}

/// A dataset that cannot be used as an error of the tool.
pub(super) fn unusable(folder: &Path, error: GapError) -> Error {
    let (place, problem) = match error {
        GapError::UnknownEffect { .. } | GapError::Usage(_) => {
            return Error::usage(error.to_string(), "see `calib gap --help`");
        }
        GapError::File { path, source } => (path, source.to_string()),
        GapError::Rig { path, problem } => (path, problem),
        other => (folder.to_owned(), other.to_string()),
    };
    Error::input(
        place.display().to_string(),
        problem,
        "docs/gap.md describes the format of a dataset",
    )
}
