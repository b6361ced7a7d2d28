//! `calib gap`: where simulation and measurement differ, why, and what to do.

mod diagnose;
mod effects;
mod text;

use super::Context;
use calib_gap::GapError;
use calib_host::{Error, Result};
use clap::{Args, Subcommand};

/// `calib gap`.
#[derive(Debug, Args)]
pub(crate) struct Gap {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Says where measurement and simulation differ, which effect does it, and how far the gap shrinks.
    Diagnose(diagnose::Diagnose),
    /// Lists the library of effects, or describes one of them.
    Effects(effects::Effects),
}

impl Gap {
    /// Carries the verb out.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        match self.command {
            Command::Diagnose(verb) => verb.run(context),
            Command::Effects(verb) => verb.run(context),
        }
    }
}

/// An unusable dataset as an error of the tool.
fn refused(error: GapError) -> Error {
    match error {
        GapError::UnknownEffect { .. } | GapError::Usage(_) => Error::Usage {
            problem: error.to_string(),
            hint: "see `calib gap --help`".into(),
        },
        other => Error::input(
            "dataset",
            other.to_string(),
            "docs/gap.md describes the format of a dataset",
        ),
    }
}
