//! The circuit simulator the netlists of `hardware/` are for.

use crate::packages::{find, install};
use anyhow::{Context, Result};
use std::path::PathBuf;

const PROGRAM: &str = "ngspice";

/// The program the tests of the front end are given, when there is one.
pub(crate) fn program() -> Result<Option<PathBuf>> {
    if let Some(program) = find(PROGRAM) {
        return Ok(Some(program));
    }
    if std::env::var_os("CI").is_none() {
        eprintln!("no ngspice: tests of the front end say so and pass (apt-get install ngspice)");
        return Ok(None);
    }
    installed().map(Some)
}

/// The same for who asked for it by name: a bench that is nothing without it installs it.
pub(crate) fn installed() -> Result<PathBuf> {
    if find(PROGRAM).is_none() {
        install(&[PROGRAM])?;
    }
    find(PROGRAM).with_context(|| format!("{PROGRAM} is not there after it was installed"))
}
