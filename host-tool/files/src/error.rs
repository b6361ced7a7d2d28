//! Complaints about files, inputs and requests, each with its way out and exit code.

use std::path::{Path, PathBuf};

/// Result of an operation on what a user gave.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// A file, an input or a request that is not usable; [`Error::hint`] says what to do.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file or directory could not be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// Action tried: "read", "write", "create".
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// Error of the operating system.
        source: std::io::Error,
    },
    /// An input is not usable: which one, where in it, why, and the way out.
    #[error("{place}: {problem}")]
    Input {
        /// File with line or field, such as `points.toml:7`.
        place: String,
        /// Problem at that place.
        problem: String,
        /// Remedy; empty when the problem says it.
        hint: String,
    },
    /// The request, such as a command line, asks for something that cannot be.
    #[error("{problem}")]
    Usage {
        /// Problem.
        problem: String,
        /// Request to make instead.
        hint: String,
    },
}

impl Error {
    /// A failed file operation.
    pub fn file(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        Self::File {
            action,
            path: path.to_owned(),
            source,
        }
    }

    /// An input that is not usable.
    pub fn input(
        place: impl Into<String>,
        problem: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        Self::Input {
            place: place.into(),
            problem: problem.into(),
            hint: hint.into(),
        }
    }

    /// A request for something that cannot be.
    pub fn usage(problem: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::Usage {
            problem: problem.into(),
            hint: hint.into(),
        }
    }

    /// Moves an error about an input to this file.
    #[must_use]
    pub fn of_file(self, path: &Path) -> Self {
        match self {
            Self::Input { problem, hint, .. } => {
                Self::input(path.display().to_string(), problem, hint)
            }
            other => other,
        }
    }

    /// Remedy, if the message does not state it already.
    pub fn hint(&self) -> Option<&str> {
        match self {
            Self::Input { hint, .. } | Self::Usage { hint, .. } if !hint.is_empty() => Some(hint),
            _ => None,
        }
    }

    /// Exit code of a program that ends with this error: 1 file, 2 usage, 6 input.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::File { .. } => 1,
            Self::Usage { .. } => 2,
            Self::Input { .. } => 6,
        }
    }
}
