//! Every test there is, in the order that fails soonest.

use crate::shell::{self, cargo, target_dir};
use crate::{browser, demo, deny, elf, no_panic, packages, python, update, wheel};
use anyhow::{Context, Result, bail};
use std::path::PathBuf;
use std::process::Command;

/// Programs that are not ours and judge what we make: the variable that names one to the tests, its name, and what
/// it judges.
const JUDGES: [(&str, &str, &str); 4] = [
    ("CALIB_TSHARK", "tshark", "the USB capture"),
    ("CALIB_NGSPICE", "ngspice", "the front end"),
    ("CALIB_XMLSEC1", "xmlsec1", "the DCC's signature"),
    ("CALIB_STRACE", "strace", "kills in every write"),
];

/// Format, lints, images, tool, tests. With a filter: only tests of that name.
pub(crate) fn run(filter: &[String]) -> Result<()> {
    if filter.is_empty() {
        shell::run(cargo_plain("fmt").args(["--all", "--check"]))?;
        no_test_is_skipped()?;
    }
    let images = shell::beside(images, || shell::run(rust_tests().arg("--no-run")))?;
    if filter.is_empty() {
        images.iter().try_for_each(|image| no_panic::check(image))?;
    }
    let image = images.last().context("no board")?;
    let mut tests = rust_tests();
    tests
        .env("CALIB_FIRMWARE_ELF", image)
        .env("CALIB_TOOL", demo::tool());
    let interpreter = python::interpreter()?;
    if filter.is_empty() {
        deny::check(interpreter.as_deref())?;
    }
    if let Some(interpreter) = &interpreter {
        tests.env("CALIB_PYTHON", interpreter);
    }
    for (variable, program, about) in JUDGES {
        if let Some(program) = packages::for_tests(program, about)? {
            tests.env(variable, program);
        }
    }
    if let Some(driver) = browser::driver()? {
        tests.env("CALIB_CHROMEDRIVER", driver);
    }
    // By name, a test of Rust is meant: the package is tested as a whole, or by `./run test python`.
    let whole = filter.is_empty() || filter == ["python"];
    let package = match interpreter.filter(|_| whole) {
        Some(interpreter) => Some(wheel::tests(&interpreter, image)?),
        None => None,
    };
    // Those in Python wait most of their time, for instruments whose time passes as on a clock.
    shell::beside(
        || package.map_or(Ok(()), shell::run_quietly),
        || shell::run(tests.arg("--").args(filter)),
    )?;
    if filter.is_empty() {
        shell::run(cargo("test").args(["--release", "--workspace", "--doc", "--quiet"]))?;
        lint()?;
    }
    eprintln!(
        "all tests passed; the host tool is {}",
        demo::tool().display()
    );
    Ok(())
}

/// Builds the images of all boards, the loader and an update, and returns the paths of the images.
fn images() -> Result<Vec<PathBuf>> {
    let images = elf::build_all()?;
    update::build_loader()?;
    update::build(None)?;
    Ok(images)
}

/// The tests in Rust. Those of the tool need it, so cargo builds and places it with them; the programs
/// of the benches are left to the lints: each would be linked here and never run.
fn rust_tests() -> Command {
    let mut tests = cargo("test");
    tests.args(["--release", "--workspace", "--no-fail-fast"]);
    tests.args(["--lib", "--bins", "--tests"]);
    tests
}

/// Lints with warnings denied. After the tests: clippy shares no build with
/// them, and a failing test is the more urgent news.
fn lint() -> Result<()> {
    let mut clippy = cargo("clippy");
    clippy.args([
        "--release",
        "--workspace",
        "--all-targets",
        "--",
        "-D",
        "warnings",
    ]);
    shell::run(&mut clippy)
}

/// `cargo fmt` knows no `--ignore-rust-version`.
fn cargo_plain(subcommand: &str) -> Command {
    let mut command = Command::new("cargo");
    command.current_dir(shell::root()).arg(subcommand);
    command
}

/// A skipped test is a behaviour nobody watches.
fn no_test_is_skipped() -> Result<()> {
    let needle = concat!("#[", "ignore");
    let mut folders = vec![shell::root()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder)?.flatten() {
            let path = entry.path();
            let name = entry.file_name();
            if path.is_dir() && name != "target" && name != ".git" && path != target_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs")
                && std::fs::read_to_string(&path)?.contains(needle)
            {
                bail!("{} skips a test: fix it or take it out", path.display());
            }
        }
    }
    Ok(())
}
