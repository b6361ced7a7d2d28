//! `calib settings`: what the calibrator knows before it measures.

use super::Context;
use calib_core::settings::Settings as InstrumentSettings;
use calib_host::{Error, Result};
use clap::Args;
use std::path::{Path, PathBuf};

/// `calib settings`.
#[derive(Debug, Args)]
#[command(after_help = "\
Edit what `calib settings > mine.toml` printed (limits of the exciter, scales of the inputs,
influence quantities, the calibration table of the reference) and hand it back with
`calib settings --write mine.toml`. All values are SI; phases are in radians.")]
pub(crate) struct Settings {
    /// Stores the settings of this TOML file in the calibrator; nothing is changed
    /// unless all of them are accepted.
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
}

impl Settings {
    /// Prints the settings in force, after writing new ones if asked to.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let new = self.write.as_deref().map(read).transpose()?;
        let mut client = context.connect()?;
        client.info()?;
        if let Some(settings) = new {
            client.write_settings(settings)?;
            context.remark("stored");
        }
        let settings = client.settings()?;
        let text = toml::to_string(&settings).map_err(|error| {
            Error::input("settings", error.to_string(), "report this as a defect")
        })?;
        context.print(&settings, || text)
    }
}

fn read(path: &Path) -> Result<InstrumentSettings> {
    let text = std::fs::read_to_string(path).map_err(|error| Error::file("read", path, error))?;
    toml::from_str(&text).map_err(|error| {
        Error::input(
            path.display().to_string(),
            error.to_string(),
            "`calib settings` prints a file of the right form",
        )
    })
}
