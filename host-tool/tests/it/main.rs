//! The host tool against a calibrator in memory: a device that speaks the real
//! protocol over a link that can damage, lose and add any byte.

mod amended;
mod bad_input;
mod capture;
mod certificate;
mod command_line;
mod device;
mod documentation;
mod download;
mod forged;
mod gap;
mod hostile;
mod killed;
mod lake;
mod link;
mod logbook;
mod logbook_cut;
mod logbook_forged;
mod logbook_sealed;
mod memory_link;
mod odd_use;
mod python;
mod reference;
mod refusals;
mod run;
mod schema;
mod serve;
mod signed;

use std::ffi::OsStr;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// The tool, [`alone`] in this folder.
fn tool(folder: &Path) -> Command {
    alone(env!("CARGO_BIN_EXE_calib"), folder)
}

/// A program in `folder` that finds nothing of what whoever runs the tests keeps.
fn alone(program: impl AsRef<OsStr>, folder: &Path) -> Command {
    let mut command = Command::new(program);
    command
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .env("XDG_CONFIG_HOME", folder.join("config"))
        .env("CALIB_CONFIG", folder.join("config.toml"))
        .env("CALIB_LOGBOOK", folder.join("no-logbook.sqlite"))
        .env_remove("CALIB_DEVICE")
        .env_remove("CALIB_KEY_PASSWORD")
        .env_remove("CALIB_LABORATORY");
    command
}

/// The output of the tool while this is typed; it may have ended already.
fn typed(tool: &mut Command, keys: &str) -> Output {
    tool.stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut tool = tool.spawn().expect("calib starts");
    let _ = tool.stdin.take().expect("piped").write_all(keys.as_bytes());
    tool.wait_with_output().expect("ends")
}

/// Arguments of a command line that has no quotes.
fn words(line: &str) -> Vec<&str> {
    line.split(' ').collect()
}
