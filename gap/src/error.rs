//! Errors in the input of a diagnosis, and the way out.

use std::path::PathBuf;

/// An input that cannot be diagnosed: names the file, the place and the remedy.
#[derive(Debug, thiserror::Error)]
pub enum GapError {
    /// A file of the dataset cannot be read or written.
    #[error("{path}: {source}")]
    File {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: std::io::Error,
    },
    /// `rig.toml` is not a rig.
    #[error("{path}: {problem}")]
    Rig {
        /// The file.
        path: PathBuf,
        /// Problem, and the expected value.
        problem: String,
    },
    /// A table as a whole is unusable.
    #[error("{file}: {problem}")]
    Table {
        /// File name inside the dataset.
        file: &'static str,
        /// Problem, and the expected value.
        problem: String,
    },
    /// One cell of a table is unusable.
    #[error("{file}, line {line}, column {column}: {problem}")]
    Cell {
        /// File name inside the dataset.
        file: &'static str,
        /// Line in the file, the header being line 1.
        line: usize,
        /// Name of the column.
        column: String,
        /// Problem, and the expected value.
        problem: String,
    },
    /// A name that is not in the library of effects.
    #[error("effect \"{name}\" is not in the library; `calib gap effects` lists it{hint}")]
    UnknownEffect {
        /// The name given.
        name: String,
        /// The nearest name, or nothing.
        hint: String,
    },
    /// An option or combination of options that makes no sense.
    #[error("{0}")]
    Usage(String),
    /// The report could not be written from the answers: a defect of its template.
    #[error("the report cannot be rendered: {0}")]
    Report(String),
}

impl GapError {
    pub(crate) fn file(path: impl Into<PathBuf>, source: std::io::Error) -> Self {
        Self::File {
            path: path.into(),
            source,
        }
    }
}
