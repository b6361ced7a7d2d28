//! The tests on the target (`hitl/on_target.rs`), on the emulated board: they pass on a sound one, and
//! what is wrong with one is named.

use calib_tests::rigged::Fault;
use calib_twin::board::{PartFault, RECORD_FLASH, SECTOR_BYTES};
use calib_twin::rig_port::ShortedInputs;
use calib_twin::runner::{Emulator, Firmware};
use std::time::Duration;

/// Longer than all of them: the erase of a sector takes 1.1 s.
const LIMIT_S: u32 = 8;

/// Their words on a board with `faults` from its first instruction on.
fn said(faults: &[PartFault]) -> Result<Vec<String>, Fault> {
    let shipping = Firmware::shipping()?;
    let path = shipping.path().with_file_name("hitl").join("calib-hitl");
    let firmware = Firmware::read(&path)
        .map_err(|error| format!("{error}; `./run hitl emulated` builds it"))?;
    let mut board = Emulator::power_on(&firmware, Box::new(ShortedInputs))?;
    for fault in faults {
        board.fail(*fault)?;
    }
    if !faults.is_empty() {
        board.power_cycle()?;
    }
    for _ in 0..10 * LIMIT_S {
        board.run_for(Duration::from_millis(100))?;
        let lines = board.log().lines(&firmware);
        if lines
            .iter()
            .any(|line| line.contains("tests passed") || line.contains("tests FAILED"))
        {
            return Ok(lines);
        }
    }
    Err(format!("no end in {LIMIT_S} s: {:#?}", board.log().lines(&firmware)).into())
}

/// Names of the tests that failed.
fn failed(faults: &[PartFault]) -> Result<Vec<String>, Fault> {
    let lines = said(faults)?;
    println!("{}", lines.join("\n"));
    let tests = lines.iter().filter_map(|line| line.split("test ").nth(1));
    let failed = tests.filter_map(|line| {
        line.split(" ... FAILED")
            .next()
            .filter(|name| *name != line)
    });
    Ok(failed.map(str::to_owned).collect())
}

#[test]
fn the_tests_on_the_target_pass_on_a_sound_board() -> Result<(), Fault> {
    assert_eq!(failed(&[])?, [""; 0]);
    Ok(())
}

#[test]
fn the_tests_on_the_target_name_what_is_wrong() -> Result<(), Fault> {
    let faults = [
        PartFault::OptionBytes {
            status: 0x0006_AAF0,
        },
        PartFault::ConverterDead { nth: 1 },
        PartFault::PoisonedWord {
            address: RECORD_FLASH + 7 * SECTOR_BYTES + 4096,
        },
    ];
    assert_eq!(failed(&faults)?, ["option bytes", "converters", "flash"]);
    Ok(())
}
