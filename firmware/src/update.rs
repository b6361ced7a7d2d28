//! The image that runs, and updates of it, in the slot the firmware does not run from.

use crate::board::{CodeFlash, running_slot};
use calib_boot::journal::Journal;
use calib_boot::layout::Slot;
use calib_boot::manifest::{self, Manifest, Version};
use calib_boot::trusted::{self, Signer};
use calib_boot::updater::{Running, UpdateError, Updater, confirm};
use calib_protocol::message::Refusal;
use calib_protocol::update::{ImageOrigin, ImageSigner, ImageSlot, RunningImage, UpdateStep};
use core::cell::RefCell;
use embassy_sync::blocking_mutex::ThreadModeMutex;

/// The folder of the board in `firmware/boards`, as manifests name it.
const BOARD: &str = env!("CALIB_BOARD");

/// Both links may ask; they are of one executor, and nothing is awaited here.
static UPDATER: ThreadModeMutex<RefCell<Updater>> =
    ThreadModeMutex::new(RefCell::new(Updater::NONE));

/// Which image runs, as the loader found it; unknown where there is none.
pub(crate) fn origin() -> ImageOrigin {
    told().unwrap_or(ImageOrigin::UNKNOWN)
}

fn told() -> Option<ImageOrigin> {
    let key = trusted::key(&mut CodeFlash)?;
    let manifest = manifest::stored(&mut CodeFlash, running_slot())?;
    Some(ImageOrigin {
        sha256: Manifest::parse(&manifest).ok()?.sha256,
        signer: match Signer::of(&key) {
            Signer::Development => ImageSigner::Development,
            Signer::Release => ImageSigner::Release,
        },
    })
}

/// The image that runs, as [`Request::Image`](calib_protocol::message::Request::Image) asks for it.
pub(crate) fn image(origin: ImageOrigin) -> Option<RunningImage> {
    if origin == ImageOrigin::UNKNOWN {
        return None;
    }
    let slot = running_slot();
    let journal = Journal::read(&mut CodeFlash);
    Some(RunningImage {
        origin,
        slot: match slot {
            Slot::A => ImageSlot::A,
            Slot::B => ImageSlot::B,
        },
        on_trial: journal.is_on_trial(slot),
        rolled_back: journal.is_on_trial(slot.other()),
    })
}

/// Carries out a step. The exciter rests.
///
/// # Timing
/// A block takes some 10 ms, or a sector's erase more, 2.2 s at most, in which nothing else runs.
pub(crate) fn carry_out(step: &UpdateStep, older_allowed: bool) -> Result<(), Refusal> {
    let trusted = trusted::key(&mut CodeFlash).ok_or(Refusal::NoLoader)?;
    let slot = running_slot();
    let running = Running {
        slot,
        version: Version::parse(env!("CARGO_PKG_VERSION")).unwrap_or_default(),
        board: BOARD,
        trusted,
    };
    let carried_out = UPDATER.lock(|updater| {
        let updater = &mut *updater.borrow_mut();
        match step {
            UpdateStep::Begin { manifest } => match manifest.as_slice().try_into() {
                Ok(manifest) => updater.begin(&mut CodeFlash, &running, manifest, older_allowed),
                Err(_) => Err(UpdateError::Signature),
            },
            UpdateStep::Block { offset, data } => updater.block(&mut CodeFlash, *offset, data),
            UpdateStep::Finish => updater.finish(&mut CodeFlash),
            UpdateStep::Confirm => confirm(&mut CodeFlash, slot),
        }
    });
    carried_out.map_err(|error| match error {
        UpdateError::Signature => Refusal::ImageSignature,
        UpdateError::NotForHere => Refusal::ImageNotForHere,
        UpdateError::Older => Refusal::ImageOlder,
        UpdateError::Unconfirmed => Refusal::ImageOnTrial,
        UpdateError::Order => Refusal::UpdateOrder,
        UpdateError::Damaged => Refusal::ImageDamaged,
        UpdateError::Flash => Refusal::StorageFailed,
    })
}
