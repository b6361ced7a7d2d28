//! Wireshark's own word on the captures of the emulated USB.

use crate::packages::{find, install};
use anyhow::{Result, bail};
use std::path::PathBuf;

const PROGRAM: &str = "tshark";

/// The program the test of the capture is given, when there is one.
pub(crate) fn program() -> Result<Option<PathBuf>> {
    if let Some(program) = find(PROGRAM) {
        return Ok(Some(program));
    }
    if std::env::var_os("CI").is_none() {
        eprintln!(
            "no tshark: the test of the USB capture says so and passes (apt-get install tshark)"
        );
        return Ok(None);
    }
    install(&[PROGRAM])?;
    match find(PROGRAM) {
        Some(program) => Ok(Some(program)),
        None => bail!("{PROGRAM} is not there after it was installed"),
    }
}
