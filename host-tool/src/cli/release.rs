//! `calib release ID`: downloaded records may make room.

use super::Context;
use calib_host::Result;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

/// `calib release ID`.
#[derive(Debug, Args)]
#[command(after_help = "\
Nothing is erased now. A calibrator whose record area is full refuses to measure until records
are released; then the oldest released ones are overwritten, a flash sector at a time.")]
pub(crate) struct Release {
    /// Running number of the last record that is kept elsewhere.
    id: u32,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Released {
    released_through: u32,
}

impl Release {
    /// Releases the records up to the number.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let mut client = context.connect()?;
        client.info()?;
        client.release(self.id)?;
        let released = Released {
            released_through: self.id,
        };
        context.print(&released, || {
            format!("records up to {} may be overwritten", self.id)
        })
    }
}
