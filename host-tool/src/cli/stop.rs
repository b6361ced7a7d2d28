//! `calib stop`: ends a run, from any terminal.

use super::Context;
use calib_host::Result;
use clap::Args;

/// `calib stop`.
#[derive(Debug, Args)]
pub(crate) struct Stop {}

impl Stop {
    /// Silences the exciter and ends the run, if there is one.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        context.connect()?.stop()?;
        context.remark("the exciter is silent");
        Ok(())
    }
}
