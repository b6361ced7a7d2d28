//! Updates whose supply fails in every operation there is, in every way there is.

use super::*;
use crate::choice::choose;
use crate::journal::{TRIES, WORDS};
use crate::manifest::{Seed, public_key, sign};
use crate::model::{Cut, Model};

const SEED: Seed = [3; 32];
const BOARD: &str = "board";
/// Two sectors and some words, the last not whole: every kind of operation, in a time a test may take.
const LONG: usize = 2 * SECTOR as usize + 5 * WORD + 7;
const SHORT: usize = 9 * WORD + 7;

fn image(length: usize, seed: u8) -> Vec<u8> {
    let byte = |at: usize| (at as u8).wrapping_mul(31) ^ seed;
    (0..length).map(byte).collect()
}

fn manifest(image: &[u8], slot: Slot, version: [u16; 3]) -> [u8; MANIFEST_BYTES] {
    let manifest = Manifest::of(image, slot, Version(version), BOARD);
    sign(&manifest.expect("fits"), &SEED)
}

fn running(slot: Slot) -> Running<'static> {
    Running {
        slot,
        version: Version([1, 0, 0]),
        board: BOARD,
        trusted: public_key(&SEED),
    }
}

/// A part with an image in slot A, as it comes from the bench.
fn part(length: usize) -> Model {
    let mut flash = Model::erased();
    let image = image(length, 1);
    flash.put(Slot::A.start(), &image);
    flash.put(Slot::A.manifest(), &manifest(&image, Slot::A, [1, 0, 0]));
    flash
}

fn start(flash: &mut Model) -> Option<Slot> {
    choose(flash, &public_key(&SEED))
}

/// Updates as a host does; ends where the supply does.
fn update(flash: &mut Model, from: Slot, new: &[u8]) -> Result<(), UpdateError> {
    let mut updater = Updater::NONE;
    let told = manifest(new, from.other(), [1, 1, 0]);
    updater.begin(flash, &running(from), &told, false)?;
    for (offset, data) in (0..).step_by(BLOCK_BYTES).zip(new.chunks(BLOCK_BYTES)) {
        updater.block(flash, offset, data)?;
    }
    updater.finish(flash)
}

#[test]
fn an_update_is_tried_and_confirmed_and_the_next_goes_back() {
    let mut flash = part(SHORT);
    assert_eq!(start(&mut flash), Some(Slot::A));
    assert_eq!(update(&mut flash, Slot::A, &image(LONG, 2)), Ok(()));
    assert_eq!(start(&mut flash), Some(Slot::B));
    // What is on trial does not overwrite what it may fall back to.
    let again = update(&mut flash, Slot::B, &image(SHORT, 3));
    assert_eq!(again, Err(UpdateError::Unconfirmed));
    assert_eq!(confirm(&mut flash, Slot::B), Ok(()));
    for _ in 0..2 * TRIES {
        assert_eq!(start(&mut flash), Some(Slot::B));
    }
    assert_eq!(update(&mut flash, Slot::B, &image(SHORT, 3)), Ok(()));
    assert_eq!(start(&mut flash), Some(Slot::A));
}

#[test]
fn an_image_that_is_never_confirmed_is_rolled_back() {
    let mut flash = part(SHORT);
    assert_eq!(update(&mut flash, Slot::A, &image(SHORT, 2)), Ok(()));
    for _ in 0..TRIES {
        assert_eq!(start(&mut flash), Some(Slot::B));
    }
    for _ in 0..3 {
        assert_eq!(start(&mut flash), Some(Slot::A));
    }
    // And another update may follow.
    assert_eq!(update(&mut flash, Slot::A, &image(SHORT, 4)), Ok(()));
    assert_eq!(start(&mut flash), Some(Slot::B));
}

/// Cuts operation after operation of `act`, each in every way; afterwards one of the two images starts, and
/// the update, made again, gets there. The number of cuts.
fn cut_everywhere(before: &Model, from: Slot, new: &[u8], stride: u32) -> u32 {
    let mut whole = before.clone();
    let first = whole.operations;
    assert_eq!(update(&mut whole, from, new), Ok(()));
    let mut cuts = 0;
    for nth in first + 1..=whole.operations {
        // Words of the image are all alike; what is around them is not.
        let of_image = nth > first + 8 && nth + 32 < whole.operations;
        if of_image && !nth.is_multiple_of(stride) {
            continue;
        }
        for how in Cut::ALL {
            let mut flash = before.clone();
            flash.cut = Some((nth, how));
            let _ = update(&mut flash, from, new);
            assert!(flash.is_off, "operation {nth} was made");
            flash.restore();
            let started = start(&mut flash);
            assert!(started.is_some(), "operation {nth} {how:?}: nothing starts");
            let is_new = started == Some(from.other());
            let at_the_end = nth == whole.operations && how == Cut::After;
            assert!(
                !is_new || at_the_end,
                "operation {nth} {how:?}: half an update"
            );
            if is_new {
                assert_eq!(confirm(&mut flash, from.other()), Ok(()));
            } else {
                assert_eq!(update(&mut flash, from, new), Ok(()), "{nth} {how:?}");
                assert_eq!(start(&mut flash), Some(from.other()), "{nth} {how:?}");
            }
            cuts += 1;
        }
    }
    cuts
}

#[test]
fn a_cut_in_every_operation_of_an_update_leaves_an_image_that_starts() {
    // Every single one: 10 words, 3 erases, 8 words of the manifest, one of the journal.
    let cuts = cut_everywhere(&part(SHORT), Slot::A, &image(SHORT, 2), 1);
    assert_eq!(cuts, 4 * (10 + 3 + 8 + 1));
    // With all sectors, and another image there before.
    let mut flash = part(SHORT);
    assert_eq!(update(&mut flash, Slot::A, &image(LONG, 5)), Ok(()));
    assert_eq!(start(&mut flash), Some(Slot::B));
    assert_eq!(confirm(&mut flash, Slot::B), Ok(()));
    let cuts = cut_everywhere(&flash, Slot::B, &image(LONG, 6), 509);
    assert!(cuts > 4 * 40, "{cuts}");
}

/// The journal is full: it is renewed, and cut in that as well.
#[test]
fn a_cut_while_the_journal_is_renewed_leaves_an_image_that_starts() {
    let mut flash = part(SHORT);
    assert_eq!(update(&mut flash, Slot::A, &image(SHORT, 2)), Ok(()));
    assert_eq!(start(&mut flash), Some(Slot::B));
    assert_eq!(confirm(&mut flash, Slot::B), Ok(()));
    let mut journal = Journal::read(&mut flash);
    // What misleads most, if an erase leaves it alone: trials and confirmations of the other slot.
    for nth in 0..WORDS {
        let entry = match nth % 5 {
            0 => Entry::Try(Slot::A),
            1 => Entry::Start(Slot::A),
            2 => Entry::Confirm(Slot::A),
            _ => Entry::Confirm(Slot::B),
        };
        if journal.is_full() && nth % 5 == 4 {
            break;
        }
        assert!(journal.note(&mut flash, entry));
    }
    assert!(journal.is_full() && !journal.is_on_trial(Slot::B));
    assert_eq!(start(&mut flash), Some(Slot::B));
    let mut whole = flash.clone();
    let first = whole.operations;
    assert_eq!(update(&mut whole, Slot::B, &image(SHORT, 7)), Ok(()));
    for nth in first + 1..=whole.operations {
        for how in Cut::ALL {
            let mut flash = flash.clone();
            flash.cut = Some((nth, how));
            let _ = update(&mut flash, Slot::B, &image(SHORT, 7));
            flash.restore();
            for again in 0..2 * TRIES {
                let started = start(&mut flash);
                assert!(started.is_some(), "operation {nth} {how:?}, start {again}");
                if nth < whole.operations {
                    assert_eq!(started, Some(Slot::B), "operation {nth} {how:?}");
                }
            }
        }
    }
}

/// The starts of a trial are cut as well: the count may lose one, and never what starts.
#[test]
fn a_cut_in_the_note_of_a_start_leaves_an_image_that_starts() {
    for how in Cut::ALL {
        let mut flash = part(SHORT);
        assert_eq!(update(&mut flash, Slot::A, &image(SHORT, 2)), Ok(()));
        for _ in 0..10 {
            flash.cut = Some((flash.operations + 1, how));
            let _ = start(&mut flash);
            flash.restore();
        }
        let started = start(&mut flash);
        // Whatever of them was noted, one image starts, and the old one once all were.
        assert!(started.is_some(), "{how:?}");
        if how == Cut::After {
            assert_eq!(started, Some(Slot::A));
        }
    }
}

#[test]
fn what_is_not_for_here_is_refused_and_named() {
    let mut flash = part(SHORT);
    let new = image(SHORT, 2);
    let begin = |flash: &mut Model, manifest: &[u8; MANIFEST_BYTES], hand| {
        let mut updater = Updater::NONE;
        updater.begin(flash, &running(Slot::A), manifest, hand)
    };
    let for_a = manifest(&new, Slot::A, [1, 0, 0]);
    let refused = begin(&mut flash, &for_a, false);
    assert_eq!(refused, Err(UpdateError::NotForHere));
    let older = manifest(&new, Slot::B, [0, 9, 9]);
    assert_eq!(begin(&mut flash, &older, false), Err(UpdateError::Older));
    assert_eq!(begin(&mut flash, &older, true), Ok(()));
    let foreign = Manifest::of(&new, Slot::B, Version([1, 0, 0]), "other").expect("fits");
    let refused = begin(&mut flash, &sign(&foreign, &SEED), false);
    assert_eq!(refused, Err(UpdateError::NotForHere));
    let of_nobody = sign(&foreign, &[9; 32]);
    let refused = begin(&mut flash, &of_nobody, false);
    assert_eq!(refused, Err(UpdateError::Signature));
    assert_eq!(flash.operations, 0, "nothing was written");
}

#[test]
fn an_image_that_is_not_the_signed_one_is_never_tried() {
    let mut flash = part(SHORT);
    let new = image(SHORT, 2);
    let mut updater = Updater::NONE;
    let told = manifest(&new, Slot::B, [1, 1, 0]);
    let begun = updater.begin(&mut flash, &running(Slot::A), &told, false);
    assert_eq!(begun, Ok(()));
    let mut other = new.clone();
    other[17] ^= 1;
    assert_eq!(updater.block(&mut flash, 0, &other), Ok(()));
    assert_eq!(updater.finish(&mut flash), Err(UpdateError::Damaged));
    assert_eq!(start(&mut flash), Some(Slot::A));
}

#[test]
fn blocks_come_in_order_and_may_be_repeated() {
    let mut flash = part(SHORT);
    let new = image(4 * BLOCK_BYTES + 5, 2);
    let mut updater = Updater::NONE;
    assert_eq!(
        updater.block(&mut flash, 0, &new[..32]),
        Err(UpdateError::Order)
    );
    let told = manifest(&new, Slot::B, [1, 1, 0]);
    let begun = updater.begin(&mut flash, &running(Slot::A), &told, false);
    assert_eq!(begun, Ok(()));
    let block = |nth: usize| &new[nth * BLOCK_BYTES..new.len().min((nth + 1) * BLOCK_BYTES)];
    assert_eq!(
        updater.block(&mut flash, 1024, block(1)),
        Err(UpdateError::Order)
    );
    for nth in 0..=4 {
        let at = (nth * BLOCK_BYTES) as u32;
        for _ in 0..2 {
            assert_eq!(updater.block(&mut flash, at, block(nth)), Ok(()));
        }
        if nth == 2 {
            assert_eq!(updater.finish(&mut flash), Err(UpdateError::Order));
            assert_eq!(
                updater.block(&mut flash, at + 1024, &new[..31]),
                Err(UpdateError::Order)
            );
        }
    }
    assert_eq!(updater.finish(&mut flash), Ok(()));
    assert_eq!(start(&mut flash), Some(Slot::B));
}

/// A bit that has flipped in the image that would start, in its manifest, or both images gone.
#[test]
fn an_image_that_has_changed_does_not_start() {
    let mut flash = part(SHORT);
    assert_eq!(update(&mut flash, Slot::A, &image(SHORT, 2)), Ok(()));
    assert_eq!(confirm(&mut flash, Slot::B), Ok(()));
    for address in [Slot::B.start() + 100, Slot::B.manifest() + 60] {
        let mut flash = flash.clone();
        flash.flip(address, 3);
        assert_eq!(start(&mut flash), Some(Slot::A));
        flash.flip(Slot::A.start(), 0);
        assert_eq!(start(&mut flash), None);
    }
    flash.poison(Slot::B.start() + 64);
    assert_eq!(start(&mut flash), Some(Slot::A));
}
