//! The shipping image on the emulated board: boot, repeatability, restarts.

use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::{Emulator, Firmware};
use std::time::Duration;

const ON: Duration = Duration::from_millis(500);

fn board() -> Result<Emulator, Fault> {
    let firmware = Firmware::shipping()?;
    let rig = Box::new(Plant::new(&Rig::standard()));
    Ok(Emulator::power_on(&firmware, rig)?)
}

/// Accesses of the firmware so far that no model answers, bar known and harmless ones.
pub(crate) fn unmodelled(board: &mut Emulator) -> Result<Vec<String>, Fault> {
    // The clock driver writes fields that hardware ignores while a PLL runs. Clocks above what the
    // voltage scale allows are not among them: voltage scale 0 is reached before 480 MHz is.
    // And what cures revision Y's AXI SRAM has no model: the emulated memory has not that erratum.
    const KNOWN: [&str; 3] = [
        "RCC.PLLCKSELR: RM0433",
        "RCC.BDCR: RM0433",
        "stored only at 0x51008108",
    ];
    let gaps = board.gaps()?.into_iter().map(|gap| gap.0);
    Ok(gaps
        .filter(|gap| !KNOWN.iter().any(|known| gap.starts_with(known)))
        .collect())
}

/// Every register the firmware touches is answered by a model.
#[test]
fn the_firmware_asks_for_nothing_the_board_does_not_model() -> Result<(), Fault> {
    let mut board = board()?;
    board.run_for(ON)?;
    assert_eq!(unmodelled(&mut board)?, [""; 0]);
    Ok(())
}

/// AXI SRAM is filled with zeros at the start: whatever lies there must begin as zeros. Its values are in
/// the file once more, padding at their ends aside.
#[test]
fn what_lies_in_axi_sram_begins_as_zeros() -> Result<(), Fault> {
    let firmware = Firmware::shipping()?;
    let (bytes, _) = firmware.section(".axisram")?;
    let (promised, values) = firmware.section(".axisram_promise")?;
    assert!(
        bytes > 300_000 && bytes.abs_diff(promised) < 256,
        "{promised} of {bytes} bytes"
    );
    let begun_otherwise = values.iter().position(|byte| *byte != 0);
    assert_eq!(begun_otherwise, None, "{promised} bytes promised");
    Ok(())
}

/// Code that runs while samples come in is in ITCM (64 KiB from 0 on), where no fetch waits, and the board has it
/// there: a name in `memory.x` that fits nothing any more would leave it in flash and show nowhere else.
#[test]
fn the_hot_path_runs_from_tightly_coupled_memory() -> Result<(), Fault> {
    let firmware = Firmware::shipping()?;
    for path in [
        ["fold", "fold_run"],
        ["dma_bdma", "on_irq"],
        ["Watch", "means"],
        ["Generator", "change_tone"],
    ] {
        let address = firmware.symbol_at_path(&path)?;
        assert!(address < 0x1_0000, "{path:?} is at {address:#x}");
    }
    // The three tasks that work on blocks are the most of it.
    let (bytes, _) = firmware.section(".itcm")?;
    assert!((30_000..0x1_0000).contains(&bytes), "{bytes} bytes");
    Ok(())
}

/// 50 kHz from a 480 MHz core is exact, so one second more is 50 000 pairs more.
#[test]
fn the_sample_clock_is_exact() -> Result<(), Fault> {
    let mut board = board()?;
    board.run_for(ON)?;
    let before = board.sample_pairs();
    assert!(before > 0, "the converters run from boot on");
    board.run_for(Duration::from_secs(1))?;
    assert_eq!(board.sample_pairs() - before, 50_000);
    Ok(())
}

/// Virtual time is all there is: two boards go through the same states instruction by instruction.
#[test]
fn two_runs_are_the_same_run_however_they_are_cut() -> Result<(), Fault> {
    let (mut whole, mut pieces) = (board()?, board()?);
    whole.run_for(ON)?;
    for _ in 0..50 {
        pieces.run_for(ON / 50)?;
    }
    assert_eq!(whole.instructions(), pieces.instructions());
    assert_eq!(whole.sample_pairs(), pieces.sample_pairs());
    assert_eq!(whole.log().bytes, pieces.log().bytes);
    assert!(!whole.log().bytes.is_empty());
    Ok(())
}

#[test]
fn flash_survives_a_power_cycle_and_the_board_boots_again() -> Result<(), Fault> {
    let firmware = Firmware::shipping()?;
    let mut board = Emulator::power_on(&firmware, Box::new(ShortedInputs))?;
    board.run_for(ON)?;
    let before = board.record_flash()?;
    board.power_cycle()?;
    assert_eq!(board.record_flash()?, before);
    board.run_for(ON)?;
    assert_eq!(board.uptime(), ON);
    let boots = board.log().lines(&firmware);
    let boots = boots.iter().filter(|line| line.contains("serial")).count();
    assert_eq!(boots, 2, "it said hello twice");
    Ok(())
}

#[test]
fn a_pulled_reset_pin_restarts_the_board_silently() -> Result<(), Fault> {
    let mut board = board()?;
    board.run_for(ON)?;
    board.reset()?;
    board.run_for(ON)?;
    assert_eq!(board.resets()?, ["Pin"]);
    assert!(
        board.silent_for() >= Some(ON),
        "not a single code off mid-scale"
    );
    Ok(())
}

/// A long run that was kept and resumed gives one record, byte for byte, at the same
/// instruction of the same nanosecond, with the noise of the same rig.
#[test]
fn a_run_that_was_kept_goes_on_as_one_that_was_not() -> Result<(), Fault> {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("kept.run");
    let rig = Rig::standard();
    let mut rigged = Rigged::with_rig(&rig)?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    rigged.keep(&file)?;
    let (record, end) = measure(&mut rigged)?;
    let mut resumed = Rigged::go_on(&rig, &file)?;
    let (again, its_end) = measure(&mut resumed)?;
    assert_eq!(end, its_end);
    assert!(record == again, "another record");
    Ok(())
}

/// Virtual time, instructions and sample pairs at the end of a run.
type End = (Duration, u64, u64);

/// A record, and where its run ended.
fn measure(rigged: &mut Rigged) -> Result<(Vec<u8>, End), Fault> {
    let outcome = rigged.run(&[point(160.0, 10.0)])?;
    let record = rigged.record(outcome.record_id)?;
    let board = rigged.board();
    let end = (board.elapsed(), board.instructions(), board.sample_pairs());
    Ok((record, end))
}
