//! Power fails in every single flash operation of a session.

use super::*;
use told::{Told, step};

/// After a restart, everything promised is there and nothing is half there.
fn check(flash: &MockFlash<SMALL>, told: &Told, cut: u64) {
    let mut desk = Desk::new();
    let mut archive = desk
        .open(flash)
        .unwrap_or_else(|error| panic!("cut at {cut}: {error}"));
    let last = told.records.keys().last().copied().unwrap_or(0);
    let checked = told.clone().check(&mut archive);
    checked.unwrap_or_else(|fault| panic!("cut at {cut}: {fault}"));
    // And the session goes on.
    let settings = Settings::field_calibrator();
    let before = archive.next_id();
    assert!(before > last);
    // Now and then for longer than a sector.
    for seed in 0..if cut.is_multiple_of(16) { 12 } else { 2 } {
        let (id, bytes) = store(&mut archive, 31, seed, &settings)
            .unwrap_or_else(|error| panic!("cut at {cut}: {error} when it went on"));
        assert_eq!(download(&mut archive, id), Ok(bytes), "cut at {cut}");
        block_on(archive.release(id)).expect("releases");
    }
}

/// The power fails once more, in every operation of the start that follows; how many there were.
fn cut_the_start(torn: &MockFlash<SMALL>, told: &Told, cut: u64) -> u64 {
    let mut desk = Desk::new();
    let whole = torn.duplicate(cut);
    let before = whole.0.borrow().operations;
    desk.open(&whole)
        .unwrap_or_else(|error| panic!("cut at {cut}: {error}"));
    let operations = whole.0.borrow().operations - before;
    for again in 1..=operations {
        let twice = torn.duplicate(cut + again);
        twice.0.borrow_mut().cut_at = Some(before + again);
        assert!(
            desk.open(&twice).is_err(),
            "cut at {cut}: mended without power"
        );
        twice.0.borrow_mut().cut_at = None;
        check(&twice, told, cut);
    }
    operations
}

#[test]
fn nothing_promised_is_lost_whenever_the_power_fails() {
    // The first steps on a new flash, and then, when the ring has gone round,
    // a stretch that erases several sectors.
    let is_cut = |number: u32| number < 8 || (115..185).contains(&number);
    let mut desk = Desk::new();
    let flash = MockFlash::<SMALL>::erased(SECTORS);
    let mut promised = Told::default();
    let (mut checked, mut in_starts, mut poisoned_reads) = (0, 0, 0);
    for number in 0..185 {
        // The step without a cut, to know how many operations it takes.
        let whole = flash.duplicate(0);
        let first = whole.0.borrow().operations;
        let mut after = promised.clone();
        step(&mut desk.open(&whole).expect("opens"), &mut after, number).expect("steps");
        let last = whole.0.borrow().operations;
        for cut in (first + 1..=last).filter(|_| is_cut(number)) {
            let torn = flash.duplicate(cut);
            torn.0.borrow_mut().cut_at = Some(cut);
            let mut told = promised.clone();
            if let Ok(mut archive) = desk.open(&torn) {
                let outcome = step(&mut archive, &mut told, number);
                // A record is safe before the state behind it is written.
                assert!(outcome.is_err() || torn.0.borrow().operations >= cut);
            }
            torn.0.borrow_mut().cut_at = None;
            in_starts += cut_the_start(&torn, &told, cut);
            check(&torn, &told, cut);
            poisoned_reads += torn.0.borrow().poisoned_reads;
            checked += 1;
        }
        step(
            &mut desk.open(&flash).expect("opens"),
            &mut promised,
            number,
        )
        .expect("steps");
    }
    let erases: u32 = flash.0.borrow().erases.iter().sum();
    println!(
        "{checked} cuts, {in_starts} more in starts, {erases} erases, {poisoned_reads} reads of poisoned words"
    );
    assert!(
        in_starts > 0 && poisoned_reads > checked,
        "hardly a torn word was met"
    );
    assert!(erases >= 5, "the ring went round: {erases}");
}
