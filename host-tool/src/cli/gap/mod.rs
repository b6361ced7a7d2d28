//! `calib gap`: where simulation and measurement differ, why, and what to do.

mod challenge;
mod diagnose;
mod effects;
mod misuse;
mod plan;
mod progress;
mod record;
mod simulate;
mod text;

pub(super) use diagnose::Said;
pub(super) use record::Written;

use super::Context;
use calib_host::Result;
use clap::{Args, Subcommand};

/// `calib gap`.
#[derive(Debug, Args)]
pub(crate) struct Gap {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Says where measurement and simulation differ, which effect explains it, and how far the gap shrinks.
    Diagnose(diagnose::Diagnose),
    /// Lists the library of effects, or describes one of them.
    Effects(effects::Effects),
    /// Finds the measurements that best separate the causes that are still possible.
    Plan(plan::PlanVerb),
    /// Writes a dataset of known cause, from the digital twin.
    Simulate(simulate::Simulate),
    /// Runs the diagnostic plan on a calibrator and writes a dataset.
    ///
    /// The dataset has rig.toml (what the simulation believes) and points.csv (what was measured);
    /// `calib gap diagnose DATASET` reads it.
    ///
    /// --believed states what the simulation believes. A rig file (such as twin/rigs/default.toml) is
    /// best: the filters and resonances it states are known, and are taken out of the rows. rig.toml
    /// has no place for them, and they would show as a gap.
    ///
    /// You state the conditions, as the calibrator has no sensor for them: one value for all
    /// runs, or one for each, as in --runs 4 --rotation 0,90,180,270. Before each run but the first
    /// you are asked to mount the device anew. docs/gap.md says what each column means.
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
