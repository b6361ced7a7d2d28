//! Actions that only a hand at the instrument does: holding the button, and what else calib asks for.

use super::Context;
use calib_core::settings::Settings;
use calib_host::{Error, Result};
use calib_link::Client;
use calib_link::session;
use calib_protocol::message::SettingsChange;
use clap::Args;
use std::io::stdin;
use std::time::Duration;

/// How often to ask again while the button is up.
const LOOKS_PER_SECOND: u32 = 2;

/// Who changes settings, and whose hand is on the button.
#[derive(Debug, Args)]
pub(crate) struct Hand {
    /// Who changes them, for the log of the change.
    #[arg(long, value_name = "NAME", default_value = "", env = "CALIB_OPERATOR")]
    operator: String,
    /// How long to wait for a hand on the button.
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    wait: u16,
    /// Holds the button of the emulated calibrator (`--device emulated`).
    #[arg(long)]
    hold_button: bool,
}

impl Hand {
    /// The name for the log.
    pub(super) fn operator(&self) -> &str {
        &self.operator
    }

    /// Connects, with a hand on the button of the emulated calibrator if asked to.
    pub(super) fn connect(&self, context: &Context) -> Result<Client> {
        match self.hold_button {
            true => context.connect_under_a_hand(),
            false => context.connect(),
        }
    }

    /// Hands the settings over, and waits for a hand on the button if they need one.
    pub(super) fn store(
        &self,
        context: &Context,
        client: &mut Client,
        settings: Settings,
    ) -> Result<()> {
        let change = SettingsChange {
            settings,
            unix_time_s: super::time::unix_time_s(),
            operator: session::label("--operator", &self.operator)?,
        };
        self.wait_for(context, client, |client| {
            client.write_settings(change.clone())
        })
    }

    /// Asks until there is a hand on the button, or nobody can be waited for any longer.
    pub(super) fn wait_for<T>(
        &self,
        context: &Context,
        client: &mut Client,
        mut ask: impl FnMut(&mut Client) -> calib_link::Result<T>,
    ) -> Result<T> {
        let mut looks = u32::from(self.wait) * LOOKS_PER_SECOND;
        loop {
            match ask(client) {
                Err(calib_link::Error::Refused(refused)) if refused.wants_button() && looks > 0 => {
                    if looks == u32::from(self.wait) * LOOKS_PER_SECOND {
                        context.remark(
                            "results and limits rest on this: hold the button on the instrument",
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

/// Asks for something at the instrument; a line on standard input says that it is done, and its end that the
/// operator has `left`.
pub(super) fn done_by_hand(asked: &str, left: Error) -> Result<()> {
    eprintln!("{asked}");
    match stdin().read_line(&mut String::new()) {
        Ok(1..) => Ok(()),
        Ok(0) | Err(_) => Err(left),
    }
}
