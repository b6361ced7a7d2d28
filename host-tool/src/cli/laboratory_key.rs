//! The laboratory's key on the command line: its file, and the password that is never an argument.

use super::Context;
use calib_host::{Error, Result};
use calib_signing::LaboratoryKey;
use clap::Args;
use jiff::Timestamp;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

/// Where a password is that is not asked for.
const VARIABLE: &str = "CALIB_KEY_PASSWORD";

/// The file of the key: the one that is named, else that of `calib config`.
pub(super) fn file(named: Option<&Path>, context: &Context) -> Option<PathBuf> {
    named
        .or(context.defaults.key.as_deref())
        .map(Path::to_owned)
}

/// The file of the key, for verbs that do nothing without one.
///
/// # Errors
/// [`Error::Files`] when there is none.
pub(super) fn required(named: Option<&Path>, context: &Context) -> Result<PathBuf> {
    file(named, context).ok_or_else(|| {
        Error::usage(
            "no key of the laboratory is named",
            "--key FILE names it, CALIB_LABORATORY_KEY, or once and for all `calib config key FILE`",
        )
    })
}

/// The file of the password.
#[derive(Debug, Args)]
pub(super) struct Password {
    /// File whose first line is the password of the key; else CALIB_KEY_PASSWORD, else it is asked for.
    #[arg(long, value_name = "FILE")]
    password_file: Option<PathBuf>,
}

impl Password {
    /// Opens the key.
    ///
    /// # Errors
    /// Those of [`LaboratoryKey::open`], and [`Error::Files`] when there is nobody to ask for the password.
    pub(super) fn open(&self, key: &Path, now: Timestamp) -> Result<LaboratoryKey> {
        Ok(LaboratoryKey::open(key, &self.read(key)?, now)?)
    }

    fn read(&self, key: &Path) -> Result<String> {
        if let Some(path) = &self.password_file {
            let text = std::fs::read_to_string(path).map_err(|e| Error::file("read", path, e))?;
            return Ok(text.lines().next().unwrap_or_default().to_owned());
        }
        if let Ok(password) = std::env::var(VARIABLE) {
            return Ok(password);
        }
        if !std::io::stdin().is_terminal() {
            return Err(Error::usage(
                format!("nobody is there to state the password of {}", key.display()),
                format!("name a file with --password-file, or set {VARIABLE}"),
            ));
        }
        let prompt = format!("password of {}: ", key.display());
        rpassword::prompt_password(prompt)
            .map_err(|error| Error::file("read", Path::new("the terminal"), error))
    }
}
