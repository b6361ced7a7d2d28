//! `calib serve` as a process of its own.
#![cfg(unix)]

use crate::rigged::Fault;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};

/// The program: what the environment names, else the one beside this test.
///
/// # Errors
/// There is neither.
pub fn tool() -> Result<PathBuf, Fault> {
    if let Some(path) = std::env::var_os("CALIB_TOOL") {
        return Ok(PathBuf::from(path));
    }
    let test = std::env::current_exe()?;
    let release = test.ancestors().nth(2).ok_or("no target folder")?;
    Ok(release.join("calib"))
}

/// The server; ended when it is dropped.
pub struct Served {
    process: Child,
    /// Address it printed.
    pub url: String,
}

impl Served {
    /// Starts it in `folder`, with a logbook there.
    ///
    /// # Errors
    /// It does not start.
    pub fn start(folder: &Path, arguments: &[&str]) -> Result<Self, Fault> {
        let mut process = Command::new(tool()?)
            .args(["serve", "--quiet", "--listen", "127.0.0.1:0"])
            .args(arguments)
            .current_dir(folder)
            .env_remove("CALIB_DEVICE")
            .env_remove("CALIB_LABORATORY")
            .env("CALIB_CONFIG", folder.join("config.toml"))
            .env("CALIB_LOGBOOK", folder.join("logbook.sqlite"))
            .stdout(Stdio::piped())
            .spawn()?;
        let mut url = String::new();
        let output = process.stdout.take().ok_or("it says nothing")?;
        BufReader::new(output).read_line(&mut url)?;
        Ok(Self {
            process,
            url: url.trim().to_owned(),
        })
    }

    /// Ctrl-C, and how it ended.
    ///
    /// # Errors
    /// There is no such process.
    pub fn interrupt(mut self) -> Result<ExitStatus, Fault> {
        let process = self.process.id().to_string();
        Command::new("kill").args(["-INT", &process]).status()?;
        Ok(self.process.wait()?)
    }
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
