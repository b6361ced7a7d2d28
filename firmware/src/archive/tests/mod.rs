//! The archive on a strict flash.

mod desk;
mod flash;
mod form1;
mod power_cut;
mod told;

use super::*;
use crate::device_key::RANDOM_BYTES;
use calib_protocol::change;
use calib_protocol::provenance::{Provenance, settings_digest};
use calib_protocol::record::{self, RecordSummary, digest};
use desk::{Desk, download, fill, log_change, result, store};
use embassy_futures::block_on;
use flash::MockFlash;
use sha2::{Digest, Sha256};

/// Sectors small enough to be filled quickly.
const SMALL: usize = 16 * 1024;
/// Sectors of the part.
const REAL: usize = 128 * 1024;

fn list<const SECTOR: usize>(
    archive: &mut Archive<'_, MockFlash<SECTOR>>,
) -> std::vec::Vec<RecordSummary> {
    desk::list(archive).expect("lists")
}

#[test]
fn records_come_back_to_the_byte_after_a_restart() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let settings = Settings::field_calibrator();
    let mut stored = std::vec::Vec::new();
    {
        let mut archive = desk.open(&flash).expect("opens");
        assert!(archive.is_empty());
        assert_eq!(archive.settings(), None);
        for seed in 0..40 {
            let points = [1, 6, 31][seed as usize % 3];
            stored.push(store(&mut archive, points, seed, &settings).expect("stores"));
        }
    }
    let mut archive = desk.open(&flash).expect("opens again");
    assert_eq!(archive.len(), 40);
    assert_eq!(archive.next_id(), 41);
    assert_eq!(archive.settings(), Some(&settings));
    for (id, bytes) in &stored {
        assert_eq!(&download(&mut archive, *id).expect("reads"), bytes);
    }
    let summaries = list(&mut archive);
    assert_eq!(summaries.len(), 40);
    for (summary, (id, bytes)) in summaries.iter().zip(&stored) {
        assert_eq!(summary.id, *id);
        assert_eq!(summary.bytes as usize, bytes.len());
        assert_eq!(summary.sha256, digest(bytes));
    }
}

#[test]
fn each_record_carries_the_sum_of_the_one_before() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let settings = Settings::field_calibrator();
    let mut previous = [0; 32];
    for seed in 0..12 {
        // A restart between any two records does not break the hash chain.
        let mut archive = desk.open(&flash).expect("opens");
        let (_, bytes) = store(&mut archive, 6, seed, &settings).expect("stores");
        let record = record::decode(&bytes).expect("a record");
        assert_eq!(record.head.previous_sha256, previous);
        previous = digest(&bytes);
    }
}

#[test]
fn a_change_of_the_reference_is_a_link_of_the_chain_and_outlives_a_restart() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let before = Settings::field_calibrator();
    let mut after = before.clone();
    after.reference.points[7].sensitivity_v_per_ms2 *= 1.002;
    let (id, first) = {
        let mut archive = desk.open(&flash).expect("opens");
        let (_, first) = store(&mut archive, 3, 1, &before).expect("stores");
        (log_change(&mut archive, 2, &after).expect("logs"), first)
    };
    let mut archive = desk.open(&flash).expect("opens again");
    assert_eq!(archive.settings(), Some(&after));
    let bytes = download(&mut archive, id).expect("reads");
    let logged = change::decode(&bytes).expect("a change");
    assert_eq!((logged.head.id, logged.head.labels.unix_time_s), (2, 2));
    assert_eq!(logged.head.previous_sha256, digest(&first));
    assert_eq!(logged.settings, after);
    assert_eq!(logged.before, before.reference_channel());
    assert_eq!(logged.all_before, Some(before.clone()));
    let kinds: std::vec::Vec<_> = list(&mut archive).iter().map(|line| line.kind).collect();
    assert_eq!(
        kinds,
        [RecordKind::Calibration, RecordKind::ReferenceChange]
    );
    let (_, next) = store(&mut archive, 3, 3, &after).expect("stores");
    let next = record::decode(&next).expect("a record");
    assert_eq!(next.head.previous_sha256, digest(&bytes));
}

#[test]
fn what_is_not_there_is_refused() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let settings = Settings::field_calibrator();
    let (id, bytes) = store(&mut archive, 3, 1, &settings).expect("stores");
    let end = bytes.len() as u32;
    for wrong in [0, id + 1, u32::MAX] {
        let answer = block_on(archive.read(wrong, 0));
        assert_eq!(answer, Err(Refusal::RecordNotFound));
    }
    for wrong in [end + 1, u32::MAX] {
        let answer = block_on(archive.read(id, wrong));
        assert_eq!(answer, Err(Refusal::OffsetOutOfRange));
    }
    let at_end = block_on(archive.read(id, end)).expect("nothing is left");
    assert!(at_end.data.is_empty());
}

#[test]
fn five_hundred_records_of_31_points_fit() {
    let flash = MockFlash::<REAL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let settings = Settings::field_calibrator();
    for seed in 0..500 {
        let room = block_on(archive.check_room(31));
        assert_eq!(room, Ok(()), "before record {seed}");
        store(&mut archive, 31, seed, &settings).expect("stores");
    }
    assert_eq!(list(&mut archive).len(), 500);
}

#[test]
fn a_full_area_refuses_before_measuring_until_records_are_released() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let settings = Settings::field_calibrator();
    let mut stored = 0;
    while block_on(archive.check_room(31)).is_ok() {
        stored = store(&mut archive, 31, stored, &settings)
            .expect("stores")
            .0;
    }
    // 8 sectors of 16 KiB take at least 6 records of 2 KiB each.
    assert!(stored >= 48, "{stored}");
    assert_eq!(block_on(archive.check_room(31)), Err(ArchiveError::Full));
    let first = list(&mut archive).first().map(|summary| summary.id);
    assert_eq!(first, Some(1), "nothing was lost on the way");

    block_on(archive.release(stored)).expect("releases");
    assert_eq!(block_on(archive.check_room(31)), Ok(()));
    // What is left of the last sector is less than the longest record of 31 points, and takes three of
    // these at most.
    for seed in 0..4 {
        store(&mut archive, 31, seed, &settings).expect("stores");
    }
    let first = list(&mut archive).first().map(|summary| summary.id);
    assert!(first > Some(1), "the oldest made room: {first:?}");
    // What was stored after the release is not released.
    while block_on(archive.check_room(31)).is_ok() {
        store(&mut archive, 31, 0, &settings).expect("stores");
    }
    let ids: std::vec::Vec<u32> = list(&mut archive).iter().map(|s| s.id).collect();
    assert!(ids.contains(&(stored + 1)));
    assert!(ids.is_sorted_by(|a, b| a + 1 == *b), "no gap: {ids:?}");
}

#[test]
fn sectors_wear_alike() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let settings = Settings::field_calibrator();
    for seed in 0..2000 {
        let (id, _) = store(&mut archive, 6, seed, &settings).expect("stores");
        if seed % 16 == 15 {
            block_on(archive.release(id)).expect("releases");
        }
    }
    let erases = flash.0.borrow().erases.clone();
    let (least, most) = (erases.iter().min(), erases.iter().max());
    let (least, most) = (*least.expect("sectors"), *most.expect("sectors"));
    assert!(least >= 5, "the ring went round: {erases:?}");
    assert!(most - least <= 1, "{erases:?}");
}

#[test]
fn settings_are_kept_through_everything() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut settings = Settings::field_calibrator();
    settings.blocks = 17;
    {
        let mut archive = desk.open(&flash).expect("opens");
        log_change(&mut archive, 1, &settings).expect("logs");
        // Round the ring, so that the sector they were written to is gone.
        for seed in 0..400 {
            let (id, _) = store(&mut archive, 6, seed, &settings).expect("stores");
            block_on(archive.release(id)).expect("releases");
        }
    }
    let archive = desk.open(&flash).expect("opens");
    assert_eq!(archive.settings(), Some(&settings));
    // The log of the change, and the runs.
    assert_eq!(archive.next_id(), 402);
}

/// The copy written last.
#[test]
fn one_damaged_copy_of_the_settings_does_not_lose_them() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut settings = Settings::field_calibrator();
    let last;
    {
        let mut archive = desk.open(&flash).expect("opens");
        settings.reference.due_day = 23;
        log_change(&mut archive, 1, &settings).expect("logs");
        last = archive.memory.last_access.longest_write() as usize;
    }
    flash.0.borrow_mut().bytes[last + 100] ^= 0x10;
    let archive = desk.open(&flash).expect("opens");
    assert_eq!(archive.settings(), Some(&settings));
}

/// Every record says which settings it was made with and since when, also once the logs of the changes
/// have made room.
#[test]
fn the_provenance_of_settings_goes_through_everything() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut settings = Settings::field_calibrator();
    let origin = |bytes: &[u8]| record::decode(bytes).expect("a record").provenance;
    let change = |record_id| LoggedChange {
        record_id,
        unix_time_s: u64::from(record_id),
    };
    let expected = {
        let mut archive = desk.open(&flash).expect("opens");
        let (_, first) = store(&mut archive, 1, 1, &settings).expect("stores");
        let untouched = Provenance {
            sha256: settings_digest(&settings),
            ..Provenance::UNKNOWN
        };
        assert_eq!(origin(&first), untouched);
        settings.reference.due_day = 23;
        assert_eq!(log_change(&mut archive, 2, &settings), Ok(2));
        let calibrated = settings_digest(&settings);
        settings.blocks = 17;
        assert_eq!(log_change(&mut archive, 3, &settings), Ok(3));
        Provenance {
            sha256: settings_digest(&settings),
            changed: change(3),
            reference_changed: change(2),
            sha256_at_reference: calibrated,
        }
    };
    assert!(expected.differs_from_reference());
    // Restarts, and round the ring.
    for seed in 0..300 {
        let mut archive = desk.open(&flash).expect("opens");
        let (id, bytes) = store(&mut archive, 6, seed, &settings).expect("stores");
        assert_eq!(origin(&bytes), expected, "{seed}");
        block_on(archive.release(id)).expect("releases");
    }
    let mut archive = desk.open(&flash).expect("opens");
    assert_eq!(download(&mut archive, 3), Err(Refusal::RecordNotFound));
    // Changed back they are the same.
    settings.blocks = Settings::field_calibrator().blocks;
    let id = log_change(&mut archive, 9, &settings).expect("logs");
    let (_, bytes) = store(&mut archive, 1, 1, &settings).expect("stores");
    assert!(!origin(&bytes).differs_from_reference());
    assert_eq!(origin(&bytes).changed.record_id, id);
}

/// The key is made once, signs from the next record on, and goes through restarts and round the ring; what it is
/// made of is in no record.
#[test]
fn the_key_goes_through_everything_and_signs_from_the_next_record_on() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let settings = Settings::field_calibrator();
    let random = [0xA5; RANDOM_BYTES];
    let key = {
        let mut archive = desk.open(&flash).expect("opens");
        store(&mut archive, 3, 1, &settings).expect("stores");
        assert_eq!(archive.public_key(), None);
        block_on(archive.make_key(&random)).expect("makes");
        let key = archive.public_key().expect("a key");
        assert_eq!(key.since, 2);
        // Another is not made of anything.
        block_on(archive.make_key(&[1; RANDOM_BYTES])).expect("keeps");
        assert_eq!(archive.public_key(), Some(key));
        key
    };
    let seed = Sha256::digest(random);
    for round in 0..300 {
        let mut archive = desk.open(&flash).expect("opens");
        // Compares the signature.
        let (id, bytes) = store(&mut archive, 6, round, &settings).expect("stores");
        assert_eq!(archive.public_key(), Some(key), "{round}");
        assert!(!bytes.windows(32).any(|part| *part == seed[..]), "{round}");
        block_on(archive.release(id)).expect("releases");
    }
    let mut archive = desk.open(&flash).expect("opens");
    let changed = log_change(&mut archive, 1, &settings).expect("logs");
    let log = download(&mut archive, changed).expect("reads");
    let signed = calib_protocol::signature::of(&log).expect("a record");
    assert_eq!(signed.map(|(signature, _)| signature.key), Some(key.public));
}

/// Once, whoever released records on a board with scales of its own made those of another board the
/// settings of the next start.
#[test]
fn a_release_changes_no_settings() {
    fn of_another_board() -> Settings {
        let mut settings = Settings::field_calibrator();
        settings.dut_input.volt_per_code *= 0.5;
        settings
    }
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    {
        let mut archive = desk.open(&flash).expect("opens");
        archive.memory.factory = of_another_board;
        block_on(archive.release(7)).expect("releases");
    }
    let archive = desk.open(&flash).expect("opens");
    assert_eq!(archive.settings(), Some(&of_another_board()));
}

#[test]
fn a_record_of_the_most_points_with_the_fullest_settings_fits() {
    let mut settings = Settings::field_calibrator();
    let point = settings.reference.points[0];
    while settings.reference.points.push(point).is_ok() {}
    let influence = settings.influences[0];
    while settings.influences.push(influence).is_ok() {}
    let flash = MockFlash::<REAL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let record = archive.draft(&settings);
    fill(record, 1, 3, &settings);
    let point = result(11.3, 3);
    while record.points.push(point).is_ok() {}
    let mut bytes = vec![0; MAX_ITEM];
    let length = record::encode(record, &mut bytes).expect("fits");
    block_on(archive.store()).expect("stores");
    assert_eq!(download(&mut archive, 1).expect("reads"), bytes[..length]);
}

/// Once, settings in older sectors filled the table at a start, and records that shared those of the
/// newest sector were not found.
#[test]
fn records_come_back_after_any_number_of_settings() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut desk = Desk::new();
    let mut settings = Settings::field_calibrator();
    let mut stored = std::vec::Vec::new();
    {
        let mut archive = desk.open(&flash).expect("opens");
        let erases = || flash.0.borrow().erases.iter().sum::<u32>();
        while erases() == 0 {
            settings.blocks = 2 + settings.blocks % 60;
            let id = log_change(&mut archive, 1, &settings).expect("logs");
            block_on(archive.release(id)).expect("releases");
        }
        for seed in 0..12 {
            settings.blocks = 2 + settings.blocks % 60;
            log_change(&mut archive, 1, &settings).expect("logs");
            for points in [1, 2] {
                stored.push(store(&mut archive, points, seed, &settings).expect("stores"));
            }
        }
    }
    let mut archive = desk.open(&flash).expect("opens again");
    for (id, bytes) in &stored {
        assert_eq!(download(&mut archive, *id).as_ref(), Ok(bytes), "{id}");
    }
}

/// Any share of the bits of a sector may be erased when the power fails in its erase. Whatever their
/// pattern looks like, the archive opens and what lies in the other sectors is there.
#[test]
fn a_half_erased_sector_keeps_nothing_else_from_being_found() {
    let full = MockFlash::<REAL>::erased(SECTORS);
    let settings = Settings::field_calibrator();
    let mut desk = Desk::new();
    let mut stored = std::vec::Vec::new();
    {
        let mut archive = desk.open(&full).expect("opens");
        while block_on(archive.check_room(31)).is_ok() {
            stored.push(store(&mut archive, 31, 1, &settings).expect("stores"));
        }
    }
    for seed in 0..120 {
        let flash = full.duplicate(seed);
        // Five shares, from just begun to nearly done.
        let share = [1, 3, 16, 128, 250][seed as usize % 5];
        flash.0.borrow_mut().tear(0..REAL, share);
        // Their check bits fit, fit for half of them, or for none.
        flash.0.borrow_mut().poison(0..REAL, (seed % 3) * 128);
        let mut archive = desk.open(&flash).expect("opens");
        for (id, bytes) in stored.iter().skip(REAL / stored[0].1.len() * 2).step_by(29) {
            assert_eq!(download(&mut archive, *id).as_ref(), Ok(bytes), "{seed}");
        }
    }
}

/// A flash with one sector whose first and last words hold these bytes.
fn with_torn_words<const SECTOR: usize>(sector: usize, first: u8, last: u8) -> MockFlash<SECTOR> {
    let flash = MockFlash::<SECTOR>::erased(SECTORS);
    {
        let mut cells = flash.0.borrow_mut();
        let (start, end) = (sector * SECTOR, (sector + 1) * SECTOR);
        cells.put(start, &[first; flash::WORD]);
        cells.put(end - flash::WORD, &[last; flash::WORD]);
    }
    flash
}

/// Marks are all zeros or all ones; a sector whose first word is neither passes for no state of a
/// sector, whatever stands in its last.
#[test]
fn a_sector_whose_first_word_is_torn_is_erased_at_the_next_start() {
    let torn = [(0x5A, 0x00), (0x7F, 0xA5), (0x01, 0xFF), (0xFE, 0x7F)];
    // These pass for whole by their bytes.
    let poisoned = [(0x00, 0x00), (0x00, 0xFF), (0xFF, 0xFF)];
    for (number, (first, last)) in torn.into_iter().chain(poisoned).enumerate() {
        let flash = with_torn_words::<SMALL>(3, first, last);
        if number >= torn.len() {
            let start = 3 * SMALL;
            flash.0.borrow_mut().poison(start..start + flash::WORD, 256);
        }
        Desk::new().open(&flash).expect("opens");
        let cells = flash.0.borrow();
        assert_eq!(cells.erases, [0, 0, 0, 1, 0, 0, 0, 0], "{first:x} {last:x}");
        assert!(cells.bytes.iter().all(|byte| *byte == 0xFF));
    }
}

/// One word of a record can no longer be read: that record is refused, and every other one is there,
/// now and after a restart.
#[test]
fn a_poisoned_word_loses_no_record_but_its_own() {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let settings = Settings::field_calibrator();
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let mut stored = std::vec::Vec::new();
    let mut places = std::vec::Vec::new();
    for seed in 0..9 {
        stored.push(store(&mut archive, 31, seed, &settings).expect("stores"));
        let entry = archive.memory.directory.last().copied().expect("stored");
        places.push(entry.address as usize + usize::from(entry.length) / 2);
    }
    assert_eq!(block_on(archive.unreadable()), 0);
    flash.0.borrow_mut().poison(places[4]..places[4] + 1, 256);
    assert_eq!(block_on(archive.unreadable()), 1);
    let lost = download(&mut archive, stored[4].0);
    assert_eq!(lost, Err(Refusal::StorageFailed));
    for restarted in [false, true] {
        let mut archive = desk.open(&flash).expect("opens");
        for (id, bytes) in stored.iter().filter(|(id, _)| *id != stored[4].0) {
            assert_eq!(
                download(&mut archive, *id).as_ref(),
                Ok(bytes),
                "{restarted}"
            );
        }
        let (id, bytes) = store(&mut archive, 31, 99, &settings).expect("and goes on");
        assert_eq!(download(&mut archive, id), Ok(bytes));
    }
}

/// Remains of an erase that kept both marks: a word that looks like the head of an item longer than
/// any, its check sum right.
#[test]
fn a_head_of_an_item_longer_than_any_is_passed_over() {
    let flash = MockFlash::<REAL>::erased(SECTORS);
    let settings = Settings::field_calibrator();
    let mut desk = Desk::new();
    let stored = {
        let mut archive = desk.open(&flash).expect("opens");
        store(&mut archive, 6, 1, &settings).expect("stores")
    };
    let longest = MAX_ITEM as u16;
    for length in [longest + 1, 0x7FFF, 0xFFFE] {
        let torn = flash.duplicate(1);
        {
            let mut cells = torn.0.borrow_mut();
            // Sector 7 as closed: marks at both ends, the head behind the first.
            let start = 7 * REAL;
            cells.put(start, &[0; flash::WORD]);
            cells.put(start + REAL - flash::WORD, &[0; flash::WORD]);
            let mut head = [0xFF; flash::WORD];
            head[..4].copy_from_slice(&0x1234_5678_u32.to_le_bytes());
            head[4..6].copy_from_slice(&length.to_le_bytes());
            head[6..8].copy_from_slice(&crc_16(&length.to_le_bytes()).to_le_bytes());
            cells.put(start + flash::WORD, &head);
        }
        let mut archive = desk.open(&torn).expect("opens");
        assert_eq!(download(&mut archive, stored.0).as_ref(), Ok(&stored.1));
        store(&mut archive, 6, 2, &settings).expect("and goes on");
    }
}

/// The check sum the queue gives the length of an item: CRC-16F/4.2 of Koopman, reflected polynomial
/// 1A2E, initial value and final inversion FFFF.
fn crc_16(bytes: &[u8]) -> u16 {
    !bytes.iter().fold(u16::MAX, |sum, byte| {
        (0..8).fold(sum ^ u16::from(*byte), |sum, _| {
            (sum >> 1) ^ (0x1A2E & (sum & 1).wrapping_neg())
        })
    })
}
