//! Where what a verb says goes: to the streams of this process, or to the program that asked.

use calib_host::{Error, Result};
use std::io::Write;

/// Message of a verb on its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said<'a> {
    /// Its document, or a line of its stream.
    Output(&'a str),
    /// A remark beside it, in a sentence.
    Remark(&'a str),
}

/// Hears what a verb says.
pub(crate) type Listener = Box<dyn Fn(Said<'_>) + Send + Sync>;

/// Where what a verb says goes.
pub(crate) enum Sink {
    /// Standard output, and standard error for remarks.
    Streams {
        /// No remarks.
        quiet: bool,
    },
    /// A program, which hears everything.
    Program(Listener),
}

impl Sink {
    /// Gives out a document or a line; `calib ... | head` is not a failure.
    pub(crate) fn write(&self, output: &str) -> Result<()> {
        match self.put(output) {
            Err(error) if !nobody_reads(&error) => {
                Err(Error::file("write", "standard output".as_ref(), error))
            }
            _ => Ok(()),
        }
    }

    /// [`Self::write`] for who does no more work once nobody reads.
    pub(crate) fn put(&self, output: &str) -> std::io::Result<()> {
        match self {
            Self::Streams { .. } => std::io::stdout().write_all(output.as_bytes()),
            Self::Program(listener) => {
                listener(Said::Output(output));
                Ok(())
            }
        }
    }

    /// Makes a remark.
    pub(crate) fn remark(&self, text: &str) {
        match self {
            Self::Program(listener) => listener(Said::Remark(text)),
            Self::Streams { quiet: true } => {}
            Self::Streams { quiet: false } => {
                let _ = writeln!(std::io::stderr(), "{text}");
            }
        }
    }
}

/// Whether writing failed because the reader has gone, which Windows tells in a way of its own too.
pub(crate) fn nobody_reads(error: &std::io::Error) -> bool {
    /// `ERROR_PIPE_NOT_CONNECTED`.
    const NOT_CONNECTED: i32 = 233;
    error.kind() == std::io::ErrorKind::BrokenPipe
        || cfg!(windows) && error.raw_os_error() == Some(NOT_CONNECTED)
}
