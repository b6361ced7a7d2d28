//! The verifier of XML signatures that is not ours.

use crate::packages::{find, install};
use anyhow::{Result, bail};
use std::path::PathBuf;

const PROGRAM: &str = "xmlsec1";

/// The program the tests of signed certificates are given, when there is one.
pub(crate) fn program() -> Result<Option<PathBuf>> {
    if let Some(program) = find(PROGRAM) {
        return Ok(Some(program));
    }
    if std::env::var_os("CI").is_none() {
        eprintln!(
            "no xmlsec1: the tests of the DCC's signature say so and pass (apt-get install xmlsec1)"
        );
        return Ok(None);
    }
    install(&[PROGRAM])?;
    match find(PROGRAM) {
        Some(program) => Ok(Some(program)),
        None => bail!("{PROGRAM} is not there after it was installed"),
    }
}
