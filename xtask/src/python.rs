//! Python packages that tests read our files back with.
//!
//! Independent readers (`pyuff`, `dcclib`, `pyvisa`, ...) live in a virtual
//! environment below `target`. Without Python those tests say so and pass,
//! except in CI, where a missing reader is a failure.

use crate::shell::{root, run, target_dir};
use anyhow::Result;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What is installed, and how: of the second list the packages alone, without the browsers they would drive.
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

/// Adds what one benchmark alone compares itself with.
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
