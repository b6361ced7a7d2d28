//! Which image the loader starts.
//!
//! | first that is whole and signed | unless |
//! |---|---|
//! | the new image on trial | it was started [`TRIES`] times, or its start cannot be noted |
//! | the one confirmed last | |
//! | the one beside the new image, or A | |
//! | the other | |
//!
//! The last two are for a journal that says nothing: of a new board, or of one whose supply failed while it
//! was erased. While one image is whole, one starts.

use crate::BootFlash;
use crate::journal::{Entry, Journal, TRIES};
use crate::layout::Slot;
use crate::manifest::{self, PublicKey};

/// The slot to start; none where no image is whole and signed with the trusted key.
pub fn choose(flash: &mut impl BootFlash, trusted: &PublicKey) -> Option<Slot> {
    let mut journal = Journal::read(flash);
    let trial = journal.trial;
    if let Some(trial) = trial
        && trial.starts < TRIES
        && is_whole(flash, trial.slot, trusted)
        && journal.note(flash, Entry::Start(trial.slot))
    {
        return Some(trial.slot);
    }
    let beside = trial.map_or(Slot::A, |trial| trial.slot.other());
    let first = journal.confirmed.unwrap_or(beside);
    [first, first.other()]
        .into_iter()
        .find(|slot| is_whole(flash, *slot, trusted))
}

fn is_whole(flash: &mut impl BootFlash, slot: Slot, trusted: &PublicKey) -> bool {
    manifest::of_whole(flash, slot, trusted).is_some()
}
