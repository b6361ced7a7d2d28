//! Errors that keep an image from running.

use std::path::PathBuf;

/// Why an emulator could not be started or go on.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The image is not there.
    #[error("no firmware image at {}: build it with `cargo xtask elf`", path.display())]
    NoImage {
        /// Where it was looked for.
        path: PathBuf,
    },
    /// The image cannot be read.
    #[error("cannot read the firmware image {}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: std::io::Error,
    },
    /// The file is no image for this board.
    #[error("{} is no firmware image for this board: {reason}", path.display())]
    NotAnImage {
        /// The file.
        path: PathBuf,
        /// Problem.
        reason: String,
    },
    /// A stored copy of the record flash has the wrong size.
    #[error("the record flash is {expected} bytes, the copy given has {found}")]
    FlashSize {
        /// Size of flash bank 2.
        expected: usize,
        /// Size of what was given.
        found: usize,
    },
    /// A run cannot be kept, or not be gone on with.
    #[error("the run at {}: {reason}", path.display())]
    Keep {
        /// The file.
        path: PathBuf,
        /// Why not.
        reason: String,
    },
    /// The image has no such symbol.
    #[error("the firmware image has no function called {0}")]
    NoSymbol(String),
    /// The emulator ended the run.
    #[error("the emulated board stopped: {0}")]
    Ended(String),
}
