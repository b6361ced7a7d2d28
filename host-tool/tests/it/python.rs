//! Programs of others that read our files back, in Python.

use std::path::Path;
use std::process::{Command, Output};

/// Runs a script with the interpreter that has the readers; `None`, after saying
/// so, when there is no such interpreter. In CI that is a failure.
pub(crate) fn run(script: &str, arguments: &[&Path]) -> Option<Output> {
    let Some(interpreter) = std::env::var_os("CALIB_PYTHON") else {
        assert!(std::env::var_os("CI").is_none(), "CALIB_PYTHON is not set");
        println!("CALIB_PYTHON is not set: not read back by another program");
        return None;
    };
    let output = Command::new(interpreter)
        .args(["-c", script])
        .args(arguments)
        .output()
        .expect("the interpreter starts");
    Some(output)
}
