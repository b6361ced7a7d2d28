//! Errors of the program, with the way out and the exit code.
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
//! | 7 | done, but a point was refused, a conformity that was asked for is not "pass", a sensor drifted, or a check failed |

use std::path::Path;

/// Result of a verb.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// A failure of the program; [`Error::hint`] says what to do about it.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Any error between this computer and a calibrator.
    #[error(transparent)]
    Calibrator(calib_link::Error),
    /// A file, an input or the command line is not usable.
    #[error(transparent)]
    Files(#[from] calib_files::Error),
    /// The work was done and its result is not a pass.
    #[error("{0}")]
    NotPassed(String),
}

impl From<calib_link::Error> for Error {
    fn from(error: calib_link::Error) -> Self {
        match error {
            calib_link::Error::Files(error) => Self::Files(error),
            other => Self::Calibrator(other),
        }
    }
}

impl Error {
    /// [`calib_files::Error::file`].
    pub fn file(action: &'static str, path: &Path, source: std::io::Error) -> Self {
        calib_files::Error::file(action, path, source).into()
    }

    /// [`calib_files::Error::input`].
    pub fn input(
        place: impl Into<String>,
        problem: impl Into<String>,
        hint: impl Into<String>,
    ) -> Self {
        calib_files::Error::input(place, problem, hint).into()
    }

    /// [`calib_files::Error::usage`].
    pub fn usage(problem: impl Into<String>, hint: impl Into<String>) -> Self {
        calib_files::Error::usage(problem, hint).into()
    }

    /// [`Self::NotPassed`] for this reason, where there is one.
    ///
    /// # Errors
    /// That.
    pub fn not_passed(why: Option<String>) -> Result<()> {
        why.map_or(Ok(()), |why| Err(Self::NotPassed(why)))
    }

    /// Remedy, if the message does not state it already.
    pub fn hint(&self) -> Option<&str> {
        match self {
            Self::Calibrator(error) => error.hint(),
            Self::Files(error) => error.hint(),
            Self::NotPassed(_) => None,
        }
    }

    /// Message, and its remedy on a line below, for a page.
    pub(crate) fn with_hint(&self) -> String {
        match self.hint() {
            Some(hint) => format!("{self}\n{hint}"),
            None => self.to_string(),
        }
    }

    /// Exit code of the process, per the table above.
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Calibrator(error) => error.exit_code(),
            Self::Files(error) => error.exit_code(),
            Self::NotPassed(_) => 7,
        }
    }
}
