//! `calib stop`: ends a run, from any terminal.

use super::Context;
use calib_host::Result;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

/// `calib stop`.
#[derive(Debug, Args)]
pub(crate) struct Stop {}

#[derive(Serialize, JsonSchema)]
pub(super) struct Stopped {
    stopped: bool,
}

impl Stop {
    /// Silences the exciter and ends the run, if there is one.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        context.connect()?.stop()?;
        let stopped = Stopped { stopped: true };
        context.print(&stopped, || "the exciter is silent".to_owned())
    }
}
