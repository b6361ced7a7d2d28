//! Python packages that tests read our files back with.
//!
//! Independent readers (`pyuff`, `dcclib`, `pyvisa`, ...) live in a virtual
//! environment below `target`. Without Python those tests say so and pass,
//! except in CI, where a missing reader is a failure.

use crate::packages;
use crate::shell::{root, run, target_dir};
use anyhow::Result;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Packages to install, and how: of the second list the packages alone, without the browsers they would drive.
const LISTS: [(&str, &[&str]); 2] = [
    ("requirements.txt", &[]),
    ("requirements-alone.txt", &["--no-deps"]),
];

/// The interpreter tests are given, when one could be set up.
pub(crate) fn interpreter() -> Result<Option<PathBuf>> {
    let folder = target_dir().join("python");
    let python = folder.join("bin").join("python3");
    let lists = LISTS.map(|(name, arguments)| (root().join("tests").join(name), arguments));
    let stamp = folder.join("requirements.txt");
    let mut wanted = Vec::new();
    for (list, _) in &lists {
        wanted.extend(std::fs::read(list)?);
    }
    if std::fs::read(&stamp).is_ok_and(|have| have == wanted) {
        return Ok(Some(python));
    }
    match install(&folder, &python, &lists) {
        Ok(()) => {
            std::fs::write(&stamp, wanted)?;
            Ok(Some(python))
        }
        Err(error) if std::env::var_os("CI").is_some() => Err(error),
        Err(error) => {
            eprintln!("no Python readers ({error:#}): tests that need them say so and pass");
            Ok(None)
        }
    }
}

/// The engine of the fleet, which is a program for Java.
pub(crate) const SPARK: &str = "pyspark==4.*";

/// Adds Spark for the tests, where there is a Java.
pub(crate) fn with_spark(interpreter: &Path) -> Result<()> {
    if packages::for_tests("java", "the fleet on Spark")?.is_none() {
        return Ok(());
    }
    match with(interpreter, SPARK) {
        Err(error) if std::env::var_os("CI").is_none() => {
            eprintln!("no Spark ({error:#}): tests of it say so and pass");
            Ok(())
        }
        other => other,
    }
}

/// Adds packages that the lists do not have: large ones, which few need.
pub(crate) fn with(interpreter: &Path, packages: &str) -> Result<()> {
    run(Command::new(interpreter)
        .args(["-m", "pip", "install", "--quiet"])
        .args(packages.split_whitespace()))
}

fn install(folder: &Path, python: &Path, lists: &[(PathBuf, &[&str])]) -> Result<()> {
    eprintln!("setting up the Python readers of the tests ...");
    run(Command::new("python3").args(["-m", "venv"]).arg(folder))?;
    for (list, arguments) in lists {
        let mut pip = Command::new(python);
        pip.args(["-m", "pip", "install", "--quiet"])
            .args(*arguments);
        run(pip.arg("--requirement").arg(list))?;
    }
    Ok(())
}
