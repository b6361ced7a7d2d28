//! `calib doctor`: what keeps this computer from talking to a calibrator.

use super::Context;
use calib_host::doctor::{self, Finding, State};
use calib_host::{Device, Error, Result};
use clap::Args;

/// `calib doctor`.
#[derive(Debug, Args)]
pub(crate) struct Doctor {}

impl Doctor {
    /// Prints what was found; a failed check is not a pass.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let address = context.device.as_deref().map(|device| {
            let Ok(address) = device.parse::<Device>();
            address
        });
        let findings = doctor::examine(address.as_ref());
        context.print(&findings, || findings.iter().map(text).collect())?;
        let failed = findings.iter().filter(|f| f.state == State::Failed).count();
        Error::not_passed((failed > 0).then(|| format!("{failed} checks failed")))
    }
}

fn text(finding: &Finding) -> String {
    let state = match finding.state {
        State::Good => "good   ",
        State::Warning => "warning",
        State::Failed => "FAILED ",
    };
    let mut text = format!("{state}  {:<9} {}\n", finding.check, finding.finding);
    for line in finding.remedy.lines() {
        text += &format!("{:>19} {line}\n", "");
    }
    text
}
