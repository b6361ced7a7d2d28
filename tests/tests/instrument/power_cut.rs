//! The supply fails in a flash operation: the instrument comes back with all of the old or all of
//! the new, and goes on.

use calib_core::settings::Settings;
use calib_protocol::frame::{MAX_FRAME, encode};
use calib_protocol::message::Request;
use calib_tests::rigged::{Fault, Rigged};
use calib_tests::supply::{Cut, Desk, Doing, Survey};
use calib_twin::board::SECTOR_BYTES;
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::{Emulator, Firmware, Torn};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Longest time from a request to its last flash operation: the frame on the line, two sector erases.
const BUSY: Duration = Duration::from_secs(5);
/// From power-on until requests are heard.
const BOOT: Duration = Duration::from_millis(200);
/// Time after which the firmware has seen the button go up or down.
const BUTTON_SEEN: Duration = Duration::from_millis(60);
/// How far into an operation the supply fails, in turn.
const FRACTIONS: [f64; 3] = [0.02, 0.5, 0.98];

/// Every so many operations one is cut: a boot takes a second of wall time, mostly the emulator's
/// code generator. A number that is no multiple of three, so that every fraction meets every place.
const STRIDE: usize = 11;

/// Cuts the supply once in flash operations all along a write of settings.
#[test]
fn settings_are_the_old_or_the_new_wherever_the_supply_fails() -> Result<(), Fault> {
    let mut rigged = Rigged::with_port(Box::new(ShortedInputs))?;
    let mut settings = rigged.client.settings()?;
    let operations = (1..).step_by(STRIDE);
    for (nth, fraction) in operations.zip(FRACTIONS.into_iter().cycle()) {
        let before = settings.blocks;
        settings.blocks = if before == 10 { 12 } else { 10 };
        let Some(torn) = cut_while_writing(&mut rigged, &settings, nth, fraction)? else {
            // The write has fewer operations than this: it is done.
            assert_eq!(rigged.client.settings()?, settings);
            // Settings of some hundred bytes take several words of 32 each.
            assert!(nth > 8, "only {nth} operations");
            return Ok(());
        };
        assert_ne!(torn, Torn::Nothing, "operation {nth} at {fraction}");
        rigged.client.wait(BOOT)?;
        let after = rigged.client.settings()?;
        assert!(
            [before, settings.blocks].contains(&after.blocks),
            "{torn:?}"
        );
        settings.blocks = after.blocks;
        assert_eq!(after, settings, "{torn:?}: a mixture");
    }
    Err("a write of settings without an end".into())
}

/// Sends new settings and cuts the supply at `fraction` of flash operation `nth` from there, then
/// restores it; `None` when there is no such operation.
fn cut_while_writing(
    rigged: &mut Rigged,
    settings: &Settings,
    nth: u64,
    fraction: f64,
) -> Result<Option<Torn>, Fault> {
    let mut frame = [0; 1 + MAX_FRAME];
    let request = Request::SettingsWrite(settings.clone().into());
    let length = encode(0x7000, &request, &mut frame[1..]).map_err(|_| "too long a frame")?;
    let mut board = rigged.board();
    // One that is down at a start opens nothing.
    board.press_button(false)?;
    board.run_for(BUTTON_SEEN)?;
    board.press_button(true)?;
    board.run_for(BUTTON_SEEN)?;
    let ordinal = board.flash_watch().operations() + nth;
    board.write_serial(&frame[..=length]);
    if !board.run_into_flash_operation(ordinal, fraction, BUSY)? {
        return Ok(None);
    }
    let torn = cut_as_foreseen(&mut board)?;
    board.restore_power()?;
    Ok(Some(torn))
}

/// Cuts the supply; a second board that gets the flash such a cut leaves, taken just before, has the same.
fn cut_as_foreseen(board: &mut Emulator) -> Result<Torn, Fault> {
    let foreseen = board.flash_at_cut()?;
    let torn = board.cut_power()?;
    assert_eq!(torn, foreseen.torn());
    let mut second = Emulator::power_on(&Firmware::shipping()?, Box::new(ShortedInputs))?;
    second.cut_power()?;
    second.fit_flash(&foreseen)?;
    assert!(second.record_flash()? == board.record_flash()?, "{torn:?}");
    let poisoned = [&second, &*board].map(|board| board.flash_watch().poisoned_words());
    assert_eq!(poisoned[0], poisoned[1], "{torn:?}");
    Ok(torn)
}

/// A sector is left so, too, half way through the erase of a start that mends it.
#[test]
fn a_flash_at_a_cut_is_what_the_cut_leaves() -> Result<(), Fault> {
    let mut flash = vec![0xFF; 8 * SECTOR_BYTES as usize];
    // Neither erased nor a mark: the erase of this sector was cut.
    flash[3 * SECTOR_BYTES as usize] = 0x5A;
    let firmware = Firmware::shipping()?;
    let mut board = Emulator::power_on_with_flash(&firmware, Box::new(ShortedInputs), &flash)?;
    assert!(board.run_into_flash_operation(1, 0.5, BUSY)?);
    let torn = cut_as_foreseen(&mut board)?;
    assert!(matches!(torn, Torn::Sector { .. }), "{torn:?}");
    assert!(board.flash_watch().poisoned_words() > 0);
    Ok(())
}

/// Flash operations of a change of settings: its log, and two copies of them.
fn operations_of_a_change() -> Result<u64, Fault> {
    let mut rigged = Rigged::with_port(Box::new(ShortedInputs))?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    let operations = rigged.board().flash_watch().operations();
    Ok(operations)
}

/// A small `./run bench hard-power`: cuts all along a session are seen on a second board, the last one
/// comes, and the first board then starts to the same flash.
#[test]
fn a_session_that_goes_on_is_cut_on_a_second_board() -> Result<(), Fault> {
    let folders = [tempfile::tempdir()?, tempfile::tempdir()?];
    let mut desk = Desk::new(folders[0].path())?;
    let survey = Survey::new(&desk, folders[1].path(), 12, 1)?;
    let survey = Arc::new(Mutex::new(survey));
    let met = desk.surveyed(&survey)?;
    desk.end(&survey)?;
    let survey = survey.lock().unwrap_or_else(PoisonError::into_inner);
    let tally = survey.tally();
    assert!(survey.is_done() && tally.cuts() >= 12, "{tally:?}");
    assert_eq!(tally.came, 1, "{met:?}");
    assert!(tally.rows.values().any(|row| row.words > 0), "{tally:?}");
    assert!(tally.compared > 0, "{tally:?}");
    Ok(())
}

/// The host finds everything it was told, whatever it was doing when the supply failed.
#[test]
fn nothing_told_is_lost_when_the_supply_fails_in_a_session() -> Result<(), Fault> {
    let folder = tempfile::tempdir()?;
    let mut desk = Desk::new(folder.path())?;
    // The words behind those of a change of settings are the record's.
    let in_the_record = Cut::InOperation {
        nth: operations_of_a_change()? + 4,
        fraction: 0.5,
    };
    let met = desk.cut(in_the_record)?;
    assert_eq!(met.doing, Doing::Measure);
    assert!(matches!(met.torn, Torn::Word { .. }), "{met:?}");
    // Long enough for a whole round and the next: a record of the first is told.
    desk.cut(Cut::After(Duration::from_millis(2500)))?;
    assert!(desk.records() > 0, "nothing was stored");
    desk.look()?;
    assert!(desk.compared() > 0, "nothing was compared");
    Ok(())
}
