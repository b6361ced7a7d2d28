//! `calib version`: what this tool understands.

use super::Context;
use calib_host::Result;
use calib_protocol::{frame::PROTOCOL_VERSION, record::RECORD_VERSION};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

/// `calib version`.
#[derive(Debug, Args)]
pub(crate) struct Version {}

#[derive(Serialize, JsonSchema)]
pub(super) struct Versions {
    tool_version: &'static str,
    protocol_version: u16,
    record_version: u16,
}

impl Version {
    /// Prints the versions.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let versions = Versions {
            tool_version: env!("CARGO_PKG_VERSION"),
            protocol_version: PROTOCOL_VERSION,
            record_version: RECORD_VERSION,
        };
        context.print(&versions, || {
            format!(
                "calib {}, protocol {}, records {}",
                versions.tool_version, versions.protocol_version, versions.record_version
            )
        })
    }
}
