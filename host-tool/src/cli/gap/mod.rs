//! `calib gap`: where simulation and measurement differ, why, and what to do.

mod challenge;
mod diagnose;
mod effects;
mod plan;
mod progress;
mod record;
mod simulate;
mod text;

use super::Context;
use calib_gap::GapError;
use calib_host::{Error, Result};
use clap::{Args, Subcommand};
use std::path::Path;

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
    /// Finds the measurements that best separate what is still possible.
    Plan(plan::PlanVerb),
    /// Writes a dataset of known cause, from the digital twin.
    Simulate(simulate::Simulate),
    /// Runs the diagnostic plan on a calibrator and writes a dataset.
    Record(record::RecordVerb),
    /// Writes a sealed set: datasets whose truth is locked away.
    Challenge(challenge::Challenge),
    /// Opens the truth of a sealed set and says what answers are worth.
    Score(challenge::ScoreVerb),
}

impl Gap {
    /// Carries the verb out.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        match self.command {
            Command::Diagnose(verb) => verb.run(context),
            Command::Effects(verb) => verb.run(context),
            Command::Plan(verb) => verb.run(context),
            Command::Simulate(verb) => verb.run(context),
            Command::Record(verb) => verb.run(context),
            Command::Challenge(verb) => verb.run(context),
            Command::Score(verb) => verb.run(context),
        }
    }
}

/// A misuse of the library of effects as an error of the tool.
fn refused(error: GapError) -> Error {
    unusable(Path::new("dataset"), error)
}

/// A dataset that cannot be used as an error of the tool.
fn unusable(folder: &Path, error: GapError) -> Error {
    let (place, problem) = match error {
        GapError::UnknownEffect { .. } | GapError::Usage(_) => {
            return Error::Usage {
                problem: error.to_string(),
                hint: "see `calib gap --help`".into(),
            };
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
