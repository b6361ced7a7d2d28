//! An update of the firmware, from its file to the slot the instrument does not run from.
//!
//! The instrument is asked all along: what runs, whether it takes this one, whether what was written is what
//! was signed. A link that breaks leaves what runs as it is: the same call again begins anew.

use crate::{Client, Error, Result};
use calib_boot::file::{self, Part};
use calib_boot::layout::Slot;
use calib_boot::manifest::Version;
use calib_protocol::update::{ImageSlot, RunningImage, UPDATE_CHUNK, UpdateStep};
use std::time::Duration;

/// From the answer to a reset until the new image answers: its loader reads two images, the record area
/// may have a sector to erase.
const START_LIMIT: Duration = Duration::from_secs(12);
/// Time between two looks.
const LOOK: Duration = Duration::from_millis(300);

/// Bytes of the image written so far, and of how many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Written.
    pub written: usize,
    /// Of these.
    pub total: usize,
}

/// Image that an instrument was sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sent {
    /// Version of the image.
    pub version: Version,
    /// Slot it goes to.
    pub slot: ImageSlot,
    /// SHA-256 of the image.
    pub sha256: [u8; 32],
    /// It runs already, and at most wants to be confirmed.
    pub runs_already: bool,
}

/// Sends the image of a file for the slot that is free; the next start tries it. One that runs already is
/// not sent again.
///
/// # Errors
/// [`Error::Files`] when the file is no update, [`Error::Refused`] with the reason of the instrument, and
/// those of the link: then what ran goes on, and the update may be begun again.
pub fn send(client: &mut Client, file: &[u8], mut progress: impl FnMut(Progress)) -> Result<Sent> {
    let parts = file::parts(file).ok_or_else(|| {
        Error::input(
            "the update",
            "this is no update, or not all of one",
            "download it again; a release has one file for each board, `calib-*.update`",
        )
    })?;
    let running = client.running_image()?;
    let of = |slot| parts[usize::from(slot == ImageSlot::B)];
    let same = of(running.slot);
    if same.told.sha256 == running.origin.sha256 {
        return Ok(sent(&same, true));
    }
    let part = of(match running.slot {
        ImageSlot::A => ImageSlot::B,
        ImageSlot::B => ImageSlot::A,
    });
    let manifest = heapless::Vec::from_slice(part.manifest).unwrap_or_default();
    client.update(&UpdateStep::Begin { manifest })?;
    let total = part.image.len();
    for (offset, data) in (0..)
        .step_by(UPDATE_CHUNK)
        .zip(part.image.chunks(UPDATE_CHUNK))
    {
        let block = UpdateStep::Block {
            offset,
            data: heapless::Vec::from_slice(data).unwrap_or_default(),
        };
        client.update(&block)?;
        progress(Progress {
            written: offset as usize + data.len(),
            total,
        });
    }
    client.update(&UpdateStep::Finish)?;
    Ok(sent(&part, false))
}

fn sent(part: &Part<'_>, runs_already: bool) -> Sent {
    Sent {
        version: part.told.version,
        slot: match part.told.slot {
            Slot::A => ImageSlot::A,
            Slot::B => ImageSlot::B,
        },
        sha256: part.told.sha256,
        runs_already,
    }
}

/// Waits until the instrument answers after its restart, on a link that stays there.
///
/// # Errors
/// Those of the link, when it does not.
pub fn wait_for_start(client: &mut Client) -> Result<()> {
    let mut waited = Duration::ZERO;
    loop {
        client.wait(LOOK)?;
        waited += LOOK;
        match client.info() {
            Err(Error::Link(_)) if waited < START_LIMIT => {}
            answered => return answered.map(drop),
        }
    }
}

/// Looks at what runs after the restart and confirms it, if it is what was sent.
///
/// # Errors
/// [`Error::Files`] when another image runs; [`Error::Refused`], and those of the link: the trial goes on,
/// and the same update again confirms it.
pub fn confirm(client: &mut Client, sent: &Sent) -> Result<RunningImage> {
    let running = client.running_image()?;
    if running.origin.sha256 != sent.sha256 {
        return Err(Error::input(
            "the update",
            "the instrument has started the image it had before",
            "the new one did not start, or was not confirmed in time: update again, and report it if it \
             happens twice; the instrument works as before",
        ));
    }
    client.update(&UpdateStep::Confirm)?;
    client.running_image()
}
