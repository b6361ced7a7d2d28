//! Power fails in every single flash operation of a session.

use super::*;
use std::collections::BTreeMap;

/// What a host was told: records stored, settings in force, records released.
#[derive(Clone, Default)]
struct Promised {
    records: BTreeMap<u32, std::vec::Vec<u8>>,
    settings: Option<Settings>,
    /// A change that was begun may or may not have come through.
    attempted: Option<Settings>,
    released: u32,
}

/// One step of a session; `Err` when the power failed.
fn step(
    archive: &mut Archive<'_, MockFlash<SMALL>>,
    promised: &mut Promised,
    number: u32,
) -> Result<(), ArchiveError> {
    let mut settings = promised
        .settings
        .clone()
        .unwrap_or_else(Settings::field_calibrator);
    match number % 8 {
        3 => {
            settings.blocks = 2 + number as u16;
            promised.attempted = Some(settings.clone());
            block_on(archive.store_settings(&settings))?;
            promised.settings = Some(settings);
        }
        6 => {
            // What may be gone after a cut is what the host has let go.
            promised.released = archive.next_id() - 1;
            block_on(archive.release(promised.released))?;
        }
        _ => {
            let points = [2, 9, 31][number as usize % 3];
            let (id, bytes) = store(archive, points, number, &settings)?;
            promised.records.insert(id, bytes);
        }
    }
    Ok(())
}

/// After a restart, everything promised is there and nothing is half there.
fn check(flash: &MockFlash<SMALL>, promised: &Promised, cut: u64) {
    let mut room = Room::new();
    let mut archive = room
        .open(flash)
        .unwrap_or_else(|error| panic!("cut at {cut}: {error}"));
    let found: std::vec::Vec<u32> = list(&mut archive).iter().map(|s| s.id).collect();
    for (id, bytes) in &promised.records {
        if found.contains(id) {
            let read = download(&mut archive, *id);
            assert_eq!(read.as_ref(), Ok(bytes), "cut at {cut}: record {id}");
        } else {
            assert!(
                *id <= promised.released,
                "cut at {cut}: record {id} is lost"
            );
        }
    }
    for id in &found {
        // A record being stored may be there, but then it is whole.
        let bytes = download(&mut archive, *id);
        let bytes = bytes.unwrap_or_else(|_| panic!("cut at {cut}: record {id} is half there"));
        assert_eq!(record::decode(&bytes).map(|record| record.id), Ok(*id));
    }
    if let Some(settings) = &promised.settings {
        let kept = archive.settings();
        let expected = kept == Some(settings) || kept == promised.attempted.as_ref();
        assert!(expected, "cut at {cut}: {kept:?}");
    }
    // And the session goes on.
    let settings = Settings::field_calibrator();
    let before = archive.next_id();
    assert!(before > promised.records.keys().last().copied().unwrap_or(0));
    // Now and then for longer than a sector.
    for seed in 0..if cut.is_multiple_of(16) { 12 } else { 2 } {
        let (id, bytes) = store(&mut archive, 31, seed, &settings)
            .unwrap_or_else(|error| panic!("cut at {cut}: {error} when it went on"));
        assert_eq!(download(&mut archive, id), Ok(bytes), "cut at {cut}");
        block_on(archive.release(id)).expect("releases");
    }
}

#[test]
fn nothing_promised_is_lost_whenever_the_power_fails() {
    // The first steps on a new flash, and then, when the ring has gone round,
    // a stretch that erases several sectors.
    let is_cut = |number: u32| number < 8 || (115..185).contains(&number);
    let mut room = Room::new();
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut promised = Promised::default();
    let mut checked = 0;
    for number in 0..185 {
        // The step without a cut, to know how many operations it takes.
        let whole = flash.duplicate(0);
        let first = whole.0.borrow().operations;
        let mut after = promised.clone();
        step(&mut room.open(&whole).expect("opens"), &mut after, number).expect("steps");
        let last = whole.0.borrow().operations;
        for cut in (first + 1..=last).filter(|_| is_cut(number)) {
            let torn = flash.duplicate(cut);
            torn.0.borrow_mut().cut_at = Some(cut);
            let mut told = promised.clone();
            if let Ok(mut archive) = room.open(&torn) {
                let outcome = step(&mut archive, &mut told, number);
                // A record is safe before the state behind it is written.
                assert!(outcome.is_err() || torn.0.borrow().operations >= cut);
            }
            torn.0.borrow_mut().cut_at = None;
            check(&torn, &told, cut);
            checked += 1;
        }
        step(
            &mut room.open(&flash).expect("opens"),
            &mut promised,
            number,
        )
        .expect("steps");
    }
    let erases: u32 = flash.0.borrow().erases.iter().sum();
    println!("{checked} cuts, {erases} erases");
    assert!(erases >= 5, "the ring went round: {erases}");
}
