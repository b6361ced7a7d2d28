//! Torn flash: the firmware tears no word of its own, and starts whatever an outage has torn.

use calib_core::point::ExcitationKind;
use calib_protocol::frame::{MAX_FRAME, encode};
use calib_protocol::message::{Request, ResetCause, RunSpec, RunState};
use calib_protocol::record::RunLabels;
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::board::{PartFault, RECORD_FLASH, SECTOR_BYTES};
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::{Emulator, Firmware, Torn};
use std::time::Duration;

/// Longest time from a request to a flash operation it leads to.
const BUSY: Duration = Duration::from_secs(5);
/// From a restart until requests are heard, after a sector was erased again.
const BOOT: Duration = Duration::from_secs(2);
/// From power-on until the part runs.
const RESET: Duration = Duration::from_micros(10);
/// A word takes 0.13 ms: what happens at this share of it leaves time to finish it.
const EARLY: f64 = 0.1;
/// The operation of a write of settings that is met: one in the middle of its words.
const NTH: u64 = 9;

/// Cause that restarts the board at once.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cause {
    /// The rail falls below the level of the detector.
    SupplySinks,
    /// A driver gives up.
    Panic,
}

#[test]
fn no_restart_tears_the_word_that_is_being_programmed() -> Result<(), Fault> {
    for cause in [Cause::SupplySinks, Cause::Panic] {
        let mut rigged = Rigged::with_port(Box::new(ShortedInputs))?;
        let mut settings = rigged.client.settings()?;
        settings.blocks += 2;
        let mut board = rigged.board();
        board.press_button(true)?;
        board.run_for(Duration::from_millis(60))?;
        let ordinal = board.flash_watch().operations() + NTH;
        send(&mut board, &Request::SettingsWrite(settings.into()))?;
        assert!(board.run_into_flash_operation(ordinal, EARLY, BUSY)?);
        let resets = board.resets()?.len();
        match cause {
            Cause::SupplySinks => board.set_supply(2700)?,
            Cause::Panic => board.fail(PartFault::DmaError { stream: 0 })?,
        }
        board.run_for(Duration::from_millis(20))?;
        board.set_supply(3300)?;
        board.run_for(BOOT)?;
        assert_eq!(board.resets()?.len(), resets + 1, "{cause:?}");
        let begun = board.flash_watch().operations();
        assert_eq!(begun, ordinal, "{cause:?}: another operation was begun");
        let torn = board.flash_watch().torn();
        assert_eq!(torn, [0, 0], "{cause:?}: words and sectors torn");
    }
    Ok(())
}

#[test]
fn a_host_that_resets_while_a_record_is_stored_tears_nothing_and_gets_it() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let id = rigged.client.start(RunSpec {
        points: [point(1000.0, 10.0)].into_iter().collect(),
        excitation: ExcitationKind::SingleSine,
        labels: RunLabels::default(),
    })?;
    {
        let mut board = rigged.board();
        let ordinal = board.flash_watch().operations() + NTH;
        let stored = Duration::from_secs(20);
        assert!(board.run_into_flash_operation(ordinal, EARLY, stored)?);
        drop(board.read_serial());
        send(&mut board, &Request::Reset)?;
    }
    rigged.client.wait(BOOT)?;
    let torn = rigged.board().flash_watch().torn();
    assert_eq!(torn, [0, 0], "words and sectors torn");
    assert_eq!(rigged.client.info()?.reset_cause, ResetCause::Software);
    assert_eq!(rigged.client.status()?.state, RunState::Idle);
    let ids: Vec<u32> = rigged.client.records()?.iter().map(|r| r.id).collect();
    assert_eq!(ids, [id]);
    Ok(())
}

/// A sector is torn, and the supply fails again and again in the erase that mends it.
#[test]
fn a_start_that_is_cut_again_and_again_comes_up_at_last() -> Result<(), Fault> {
    let mut flash = vec![0xFF; 8 * SECTOR_BYTES as usize];
    // Neither erased nor a mark: the erase of this sector was cut.
    flash[3 * SECTOR_BYTES as usize] = 0x5A;
    let firmware = Firmware::shipping()?;
    let mut board = Emulator::power_on_with_flash(&firmware, Box::new(ShortedInputs), &flash)?;
    for (nth, fraction) in (1..).zip([0.02, 0.98, 0.5, 0.3, 0.9]) {
        // A power-on takes the trap away.
        board.run_for(RESET)?;
        assert!(
            board.run_into_flash_operation(nth, fraction, BUSY)?,
            "{nth}"
        );
        let torn = board.power_cycle()?;
        let address = RECORD_FLASH + 3 * SECTOR_BYTES;
        let expected = matches!(torn, Torn::Sector { address: at, .. } if at == address);
        assert!(expected, "{nth}: {torn:?}");
    }
    board.run_for(BOOT)?;
    assert_eq!(board.flash_watch().poisoned_words(), 0, "healed");
    assert!(
        board.flash_watch().poisoned_loads() > 0,
        "no poison was met"
    );
    drop(board.read_serial());
    send(&mut board, &Request::Info)?;
    assert!(board.run_until_received(Duration::from_secs(1))?, "silent");
    let causes = board.resets()?;
    assert!(causes.iter().all(|cause| cause == "PowerOn"), "{causes:?}");
    Ok(())
}

/// Puts a request on the line.
fn send(board: &mut Emulator, request: &Request) -> Result<(), Fault> {
    let mut frame = [0; 1 + MAX_FRAME];
    let length = encode(0x7000, request, &mut frame[1..]).map_err(|_| "too long a frame")?;
    board.write_serial(&frame[..=length]);
    Ok(())
}
