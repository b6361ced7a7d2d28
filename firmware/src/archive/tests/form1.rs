//! An area that an image before sections wrote: version 1 of records and states.
//!
//! `form1.bin` is the beginning of the area, written on 2026-11-22: settings twice, three calibrations
//! of 1, 6 and 2 points, the log of a change of the reference, two calibrations of 3 and 1 points, and
//! the release of the first two. The rest of the area is erased.

use super::*;

const AREA: &[u8] = include_bytes!("form1.bin");

fn area() -> MockFlash<SMALL> {
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    for (word, at) in AREA.chunks(flash::WORD).zip((0..).step_by(flash::WORD)) {
        flash.0.borrow_mut().put(at, word);
    }
    flash
}

#[test]
fn its_records_are_listed_and_served() {
    let flash = area();
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let lines = list(&mut archive);
    let ids: std::vec::Vec<_> = lines.iter().map(|line| (line.id, line.points)).collect();
    assert_eq!(ids, [(1, 1), (2, 6), (3, 2), (4, 0), (5, 3), (6, 1)]);
    assert_eq!(lines[3].kind, RecordKind::ReferenceChange);
    let mut previous = [0; 32];
    for line in &lines {
        let bytes = download(&mut archive, line.id).expect("reads");
        let link = record::hash_link(&bytes).expect("a record");
        assert_eq!((link.sha256, link.previous_sha256), (line.sha256, previous));
        previous = link.sha256;
        if line.kind == RecordKind::Calibration {
            let record = record::decode(&bytes).expect("a record");
            // Its seed: the number, but for those behind the change, 5 and 6.
            let seed = record.head.labels.unix_time_s as f32;
            assert_eq!(record.points[0].sensitivity_v_per_ms2, 0.01 + seed * 1e-6);
        }
    }
    assert_eq!(archive.next_id(), 7);
}

#[test]
fn its_settings_are_in_force() {
    let flash = area();
    let mut desk = Desk::new();
    let archive = desk.open(&flash).expect("opens");
    let settings = archive.settings().expect("stored");
    assert_eq!(settings.validate(), Ok(()));
    assert_eq!(settings.reference.serial, "R 1");
    assert_eq!((settings.blocks, settings.reference.points.len()), (12, 9));
}

#[test]
fn new_records_continue_it() {
    let flash = area();
    let mut desk = Desk::new();
    let (settings, stored) = {
        let mut archive = desk.open(&flash).expect("opens");
        let settings = archive.settings().expect("stored").clone();
        let stored: std::vec::Vec<_> = (7..12)
            .map(|seed| store(&mut archive, 6, seed, &settings).expect("stores"))
            .collect();
        block_on(archive.release(3)).expect("releases");
        (settings, stored)
    };
    let mut archive = desk.open(&flash).expect("opens again");
    assert_eq!(archive.settings(), Some(&settings));
    let lines = list(&mut archive);
    assert_eq!(lines.len(), 11);
    let first_new = record::decode(&stored[0].1).expect("a record");
    assert_eq!(first_new.head.previous_sha256, lines[5].sha256);
    for (id, bytes) in &stored {
        assert_eq!(download(&mut archive, *id).as_ref(), Ok(bytes), "{id}");
    }
    download(&mut archive, 2).expect("an old one");
}

/// The area of an instrument that was used, kept with the answers that are frozen.
#[test]
fn the_area_of_an_instrument_is_served() {
    const USED: &[u8] = include_bytes!("../../../../tests/frozen/stored/flash.bin");
    let flash = MockFlash::<REAL>::erased(SECTORS);
    for (word, at) in USED.chunks(flash::WORD).zip((0..).step_by(flash::WORD)) {
        flash.0.borrow_mut().put(at, word);
    }
    let mut desk = Desk::new();
    let mut archive = desk.open(&flash).expect("opens");
    let lines = list(&mut archive);
    assert!(!lines.is_empty());
    let mut previous = [0; 32];
    for line in &lines {
        let bytes = download(&mut archive, line.id).expect("reads");
        assert_eq!(record::inspect(&bytes).expect("a record").0, *line);
        let link = record::hash_link(&bytes).expect("a record");
        assert_eq!(link.previous_sha256, previous);
        previous = link.sha256;
    }
    let settings = archive.settings().expect("stored");
    assert_eq!(settings.validate(), Ok(()));
}
