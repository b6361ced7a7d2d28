//! `calib update`: other firmware for the instrument.

use super::hand::Hand;
use super::{Context, progress};
use calib_host::{Error, Result};
use calib_link::Client;
use calib_link::session::update::{Sent, confirm, send, wait_for_start};
use calib_output::ImageView;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;
use std::time::Duration;

/// How often a port is opened again, and how long to wait in between: a USB port goes and comes with the
/// instrument.
const REOPENED: u32 = 20;
const BETWEEN: Duration = Duration::from_millis(500);

/// `calib update`.
#[derive(Debug, Args)]
#[command(after_help = "\
The new firmware goes to the slot of the flash that is not in use. It is tried once it is there
as a whole and signed with the key the instrument trusts. The running firmware is never touched:
after a failed supply or a broken link it runs on, and the same command begins again. The new
firmware is confirmed as soon as it answers here. If it never answers, the instrument starts the
old one again after three starts. Older firmware needs the button held. Records and settings
stay. docs/safety.md says what this protects from and what it does not.")]
pub(crate) struct Update {
    /// The update, `calib-*.update` of a release.
    file: PathBuf,
    #[command(flatten)]
    hand: Hand,
}

/// How an update ended.
#[derive(Serialize, JsonSchema)]
pub(super) struct UpdateView {
    /// Version before.
    version_before: String,
    /// Version that runs now.
    version: String,
    /// Bytes that were sent; 0 where it was there already.
    sent_bytes: usize,
    /// Image that runs now.
    image: ImageView,
}

impl Update {
    /// Sends, restarts, looks, confirms.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let read = std::fs::read(&self.file);
        let file = read.map_err(|source| Error::file("read", &self.file, source))?;
        let mut client = self.hand.connect(context)?;
        let before = client.info()?.firmware_version.to_string();
        let (sent, sent_bytes) = self.send(context, &mut client, &file)?;
        if !sent.runs_already {
            client.reset()?;
            client = restarted(context, client)?;
        }
        let running = confirm(&mut client, &sent)?;
        let view = UpdateView {
            version_before: before,
            version: sent.version.to_string(),
            sent_bytes,
            image: ImageView::from(&running),
        };
        context.print(&view, || view.text())
    }

    fn send(&self, context: &Context, client: &mut Client, file: &[u8]) -> Result<(Sent, usize)> {
        let bar = progress::update(context);
        let mut sent_bytes = 0;
        // Firmware that is older is refused before anything is written, until there is a hand.
        let sent = self.hand.wait_for(context, client, |client| {
            send(client, file, |progress| {
                sent_bytes = progress.written;
                bar.set_length(progress.total as u64);
                bar.set_position(progress.written as u64);
            })
        });
        bar.finish_and_clear();
        Ok((sent?, sent_bytes))
    }
}

/// The instrument once it answers again. A port that goes with it is opened anew.
fn restarted(context: &Context, mut client: Client) -> Result<Client> {
    if wait_for_start(&mut client).is_ok() {
        return Ok(client);
    }
    drop(client);
    let mut tries = 0;
    loop {
        tries += 1;
        let opened = context.connect().and_then(|mut client| {
            client.info()?;
            Ok(client)
        });
        match opened {
            Err(Error::Calibrator(calib_link::Error::Link(_))) if tries < REOPENED => {
                std::thread::sleep(BETWEEN);
            }
            opened => return opened,
        }
    }
}

impl UpdateView {
    fn text(&self) -> String {
        let Self {
            version,
            image,
            sent_bytes,
            ..
        } = self;
        let was = match sent_bytes {
            0 => "ran already",
            _ => "runs",
        };
        let confirmed = match image.on_trial {
            true => "NOT confirmed",
            false => "confirmed",
        };
        format!(
            "{version} {was} from slot {}, {confirmed}; {}\n",
            image.slot,
            image.text()
        )
    }
}
