//! Arguments of `calib`: one struct per verb, each in its own file.
//!
//! A verb is a struct that derives `clap::Args` with
//! `run(self, context) -> Result<()>`. Data goes to standard output (tables,
//! or JSON with `--json` and `--json-lines`), everything else to standard error.

mod adjust;
mod again;
mod alarm;
mod answer;
mod budget;
mod capture;
mod certificate;
mod check;
mod completions;
mod config;
mod context;
mod convert;
mod demo;
mod devices;
mod doctor;
mod download;
mod emulate;
mod gap;
mod hand;
mod help;
mod identify;
mod info;
mod key;
mod laboratory_key;
mod linking;
mod lists;
mod logbook;
mod measure;
mod misuse;
mod nomogram;
mod number;
mod phase;
mod points;
mod predict;
mod progress;
mod records;
mod reference;
mod release;
mod remount;
mod risk;
mod run;
mod schema;
mod selfcheck;
mod selftest;
mod sensitivity;
mod serve;
mod settings;
mod show;
mod sign;
mod sink;
mod source;
mod stop;
mod substitute;
mod sync;
mod text;
mod time;
mod turnover;
mod update;
mod verbs;
mod verify;
mod version;

pub use answer::answer;
pub use context::Failure;
pub(crate) use context::{Context, GlobalOptions};
pub use measure::ask_for_silence;
pub use sink::Said;
pub(crate) use verbs::Command;

use calib_host::Result;
use calib_host::config::Config;
use clap::{CommandFactory, FromArgMatches, Parser};
use std::ffi::OsString;
use std::process::ExitCode;

/// Exit codes, printed at the end of `calib --help`.
const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  a file could not be read or written, or the tool itself failed
  2  wrong use of the command line
  3  link: no such device, no answer, damaged answers
  4  the device speaks another protocol version, or answers nonsense
  5  the device understood and refused
  6  an input file (points, record, settings, ...) is not usable
  7  done, but a point was refused, a conformity is not \"pass\", or a check failed";

/// Carries out what was typed, says how it ended, and returns it.
pub fn main() -> ExitCode {
    // What is wrong with them is said in the form that was asked for, which the arguments tell.
    let (defaults, broken) = match Config::load(&calib_host::config::path()) {
        Ok(defaults) => (defaults, None),
        Err(error) => (Config::default(), Some(error)),
    };
    let arguments = match Arguments::read(std::env::args_os(), &defaults) {
        Ok(arguments) => arguments,
        Err(said) => return misuse::tell(said),
    };
    let context = arguments.context(defaults);
    let done = broken.map_or_else(|| arguments.command.run(&context), Err);
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            context.report(&error);
            ExitCode::from(error.exit_code())
        }
    }
}

/// Calibrates vibration transducers with the open field calibrator.
#[derive(Debug, Parser)]
#[command(name = "calib", version, about, after_help = EXIT_CODES, max_term_width = 100)]
pub(crate) struct Arguments {
    /// Options every verb knows.
    #[command(flatten)]
    pub(crate) global: GlobalOptions,
    /// Verb.
    #[command(subcommand)]
    pub(crate) command: Command,
}

impl Arguments {
    /// Reads the command line.
    ///
    /// # Errors
    /// Text to print instead: help, the version, or what is wrong.
    pub(crate) fn read(
        words: impl IntoIterator<Item = OsString>,
        defaults: &Config,
    ) -> Result<Self, clap::Error> {
        let calib = number::signed(Self::described());
        let mut calib = config::with_defaults(calib, defaults);
        let matches = calib.try_get_matches_from_mut(words)?;
        Self::from_arg_matches(&matches).map_err(|error| error.format(&mut calib))
    }

    /// The command line with its help.
    fn described() -> clap::Command {
        help::described(Self::command())
    }

    /// The context that its verb works with.
    fn context(&self, defaults: Config) -> Context {
        Context::new(&self.global, defaults, Self::described)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        Arguments::command().debug_assert();
    }
}
