//! Independent readers in Python, for tests: validators and parsers of others.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn in_ci() -> bool {
    std::env::var("CI").is_ok_and(|value| value == "true")
}

/// A file or folder of the data shared between projects, which a user's clone
/// does not have. Says so and returns `None`; in CI that is a failure.
pub(crate) fn shared(path: &str) -> Option<PathBuf> {
    let full = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../../shared")
        .join(path);
    if full.exists() {
        return Some(full);
    }
    assert!(!in_ci(), "{} is missing", full.display());
    eprintln!(
        "{} is missing: nothing is tested against it",
        full.display()
    );
    None
}

/// Runs Python with these arguments if it has `module`; `./run test` sets up
/// an interpreter that has all of them and names it in `CALIB_PYTHON`.
pub(crate) fn python(module: &str, arguments: &[&std::ffi::OsStr]) -> Option<Output> {
    let named = std::env::var_os("CALIB_PYTHON");
    let interpreter = named.clone().unwrap_or_else(|| "python3".into());
    let has = Command::new(&interpreter)
        .args(["-c", &format!("import {module}")])
        .output();
    if !has.is_ok_and(|output| output.status.success()) {
        assert!(
            named.is_none() || !in_ci(),
            "{module} is missing in {interpreter:?}"
        );
        eprintln!("no Python with {module}: nothing is read back with it");
        return None;
    }
    Some(
        Command::new(&interpreter)
            .args(arguments)
            .output()
            .expect("Python starts"),
    )
}
