//! `calib stop`: ends a run, from any terminal.

use super::{Context, alarm};
use calib_host::Result;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

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
        let emulated = !context.is_outside();
        let confirmed = Arc::new(AtomicBool::new(false));
        let seen = Arc::clone(&confirmed);
        let watch = alarm::watch(move || seen.load(Ordering::SeqCst) || emulated);
        context.connect()?.stop()?;
        confirmed.store(true, Ordering::SeqCst);
        // What it says, it says before this does.
        let _ = watch.join();
        let stopped = Stopped { stopped: true };
        context.print(&stopped, || "the exciter is silent".to_owned())
    }
}
