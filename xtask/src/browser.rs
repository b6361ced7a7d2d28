//! The browser that tests open the page of `calib serve` in.
//!
//! Debian's Chromium with its WebDriver. CI installs them; on a person's computer
//! nothing is installed unasked: without them those tests say so and pass.

use crate::packages::{find, install};
use crate::shell::{self, cargo};
use crate::{demo, elf, python, wheel};
use anyhow::{Context, Result, bail};
use std::path::PathBuf;

const PROGRAMS: [&str; 2] = ["chromedriver", "chromium"];
/// Packages that make pages of notebooks.
const NOTEBOOKS: &str = "nbconvert==7.* ipykernel==6.*";
const INSTALL: &str = "apt-get install chromium chromium-driver";

/// The WebDriver tests are given, when there is one.
pub(crate) fn driver() -> Result<Option<PathBuf>> {
    if PROGRAMS.iter().all(|program| find(program).is_some()) {
        return Ok(find(PROGRAMS[0]));
    }
    if std::env::var_os("CI").is_none() {
        eprintln!("no Chromium with WebDriver: the tests of the page say so and pass ({INSTALL})");
        return Ok(None);
    }
    install(&["chromium", "chromium-driver"])?;
    match find(PROGRAMS[0]) {
        Some(driver) => Ok(Some(driver)),
        None => bail!("chromedriver is not there after `{INSTALL}`"),
    }
}

/// `./run screenshots`: the pictures in `docs/images`.
pub(crate) fn screenshots() -> Result<()> {
    let driver = driver()?.with_context(|| format!("screenshots need a browser: {INSTALL}"))?;
    let image = elf::build()?;
    demo::build_tool()?;
    let interpreter = wheel::interpreter()?;
    python::with(&interpreter, NOTEBOOKS)?;
    wheel::installed(&interpreter)?;
    let mut command = cargo("run");
    command
        .args(["--release", "--package", "calib-tests"])
        .args(["--example", "screenshots", "--"])
        .arg(shell::root().join("docs").join("images"))
        .env("CALIB_FIRMWARE_ELF", image)
        .env("CALIB_TOOL", demo::tool())
        .env("CALIB_PYTHON", interpreter)
        .env("CALIB_CHROMEDRIVER", driver);
    shell::run(&mut command)
}
