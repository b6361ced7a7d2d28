//! `calib settings`: what the calibrator knows before it measures.

use super::Context;
use calib_core::settings::Settings as InstrumentSettings;
use calib_files::text;
use calib_host::{Error, Result};
use calib_link::Client;
use calib_link::session;
use calib_protocol::message::SettingsChange;
use clap::Args;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How often to ask again while the button is up.
const LOOKS_PER_SECOND: u32 = 2;

/// `calib settings`.
#[derive(Debug, Args)]
#[command(after_help = "\
Edit what `calib settings > mine.toml` printed (limits of the exciter, scales of the inputs,
influence quantities, the calibration table of the reference) and hand it back with
`calib settings --write mine.toml`. All values are SI; phases are in radians.

The calibration of the reference (its table, serial number, certificate and days, and the scale of its
input) changes only while the button on the instrument is held; calib waits for that. Each such change
is logged as a record, with the time and the operator.")]
pub(crate) struct Settings {
    /// Stores the settings of this TOML file in the calibrator; nothing is changed
    /// unless all of them are accepted.
    #[arg(long, value_name = "FILE")]
    write: Option<PathBuf>,
    /// Who changes them, for the log of a change of the reference.
    #[arg(long, value_name = "NAME", default_value = "", env = "CALIB_OPERATOR")]
    operator: String,
    /// How long to wait for a hand on the button, where one is needed.
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    wait: u16,
    /// Puts a hand on the button of the emulated calibrator (`--device emulated`).
    #[arg(long, requires = "write")]
    hold_button: bool,
}

impl Settings {
    /// Prints the settings in force, after writing new ones if asked to.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let new = self.write.as_deref().map(read).transpose()?;
        let mut client = match self.hold_button {
            true => context.connect_under_a_hand()?,
            false => context.connect()?,
        };
        client.info()?;
        if let Some(settings) = new {
            self.store(context, &mut client, settings)?;
            context.remark("stored");
        }
        let settings = client.settings()?;
        let text = toml::to_string(&settings).map_err(|error| {
            Error::input("settings", error.to_string(), "report this as a defect")
        })?;
        context.print(&settings, || text)
    }
}

impl Settings {
    /// Hands the settings over, and waits for a hand on the button if they change
    /// the reference.
    fn store(
        &self,
        context: &Context,
        client: &mut Client,
        settings: InstrumentSettings,
    ) -> Result<()> {
        let change = SettingsChange {
            settings,
            unix_time_s: super::time::unix_time_s(),
            operator: session::label("--operator", &self.operator)?,
        };
        let mut looks = u32::from(self.wait) * LOOKS_PER_SECOND;
        loop {
            match client.write_settings(change.clone()) {
                Err(calib_link::Error::Refused(refused)) if refused.wants_button() && looks > 0 => {
                    if looks == u32::from(self.wait) * LOOKS_PER_SECOND {
                        context.remark(
                            "this changes the calibration of the reference: hold the button on the \
                             instrument",
                        );
                    }
                    looks -= 1;
                    client.wait(Duration::from_secs(1) / LOOKS_PER_SECOND)?;
                }
                done => return Ok(done?),
            }
        }
    }
}

fn read(path: &Path) -> Result<InstrumentSettings> {
    let text = text::read(path)?;
    let hint = "`calib settings` prints a file of the right form; the factor of a special \
                distribution in files of before is 1 / divisor";
    Ok(text::parse_toml(path, &text, hint)?)
}
