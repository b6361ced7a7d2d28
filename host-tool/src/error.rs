//! What can go wrong on the host, with the way out and the exit code.
//!
//! | exit code | meaning |
//! |---|---|
//! | 0 | done |
//! | 1 | a file could not be read or written, or the tool itself failed |
//! | 2 | wrong use of the command line |
//! | 3 | link: no such device, no answer, damaged answers |
//! | 4 | the device speaks another protocol version, or answers nonsense |
//! | 5 | the device understood and refused |
//! | 6 | an input file (points, record, settings, ...) is not usable |
//! | 7 | done, but a verdict is not "pass": a point was refused, a sensor drifted, a check failed |

use crate::link::{LinkError, ProtocolError, Refused};
use std::path::{Path, PathBuf};

/// Result of a host operation.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// A failure of the host tool; [`Error::hint`] says what to do about it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Bytes do not get through to the calibrator.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// The calibrator and this tool do not understand each other.
    #[error(transparent)]
    Protocol(#[from] ProtocolError),
    /// The calibrator understood and declined.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// A file or directory could not be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// What was tried: "read", "write", "create".
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// An input is not usable: which one, where in it, why, and the way out.
    #[error("{place}: {problem}")]
    Input {
        /// File with line or field, such as `points.toml:7`.
        place: String,
        /// What is wrong there.
        problem: String,
        /// What to do about it; empty when the problem says it.
        hint: String,
    },
    /// The command line asks for something that cannot be.
    #[error("{problem}")]
    Usage {
        /// What is wrong.
        problem: String,
        /// What to type instead.
        hint: String,
    },
    /// The work was done and its result is not a pass.
    #[error("{0}")]
    NotPassed(String),
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

    /// The same complaint about an input, where it is this file that was meant.
    #[must_use]
    pub fn of_file(self, path: &Path) -> Self {
        match self {
            Self::Input { problem, hint, .. } => {
                Self::input(path.display().to_string(), problem, hint)
            }
            other => other,
        }
    }

    /// What the user can do about it, if the message does not say it already.
    pub fn hint(&self) -> Option<&str> {
        match self {
            Self::Link(error) => Some(error.hint()),
            Self::Protocol(error) => Some(error.hint()),
            Self::Refused(error) => Some(error.hint()),
            Self::Input { hint, .. } | Self::Usage { hint, .. } if !hint.is_empty() => Some(hint),
            _ => None,
        }
    }

    /// Exit code of the process, per the table above.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::File { .. } => 1,
            Self::Usage { .. } => 2,
            Self::Link(_) => 3,
            Self::Protocol(_) => 4,
            Self::Refused(_) => 5,
            Self::Input { .. } => 6,
            Self::NotPassed(_) => 7,
        }
    }
}
