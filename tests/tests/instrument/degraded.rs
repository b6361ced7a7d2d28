//! Never silent for good: whatever of the part or of the program fails, links, lamps, button and
//! stop are there within a second, with the reason; nothing is measured, what works works.

use calib_core::point_state::PointState;
use calib_host::emulated::EmulatedUsbTransport;
use calib_link::{Client, Error};
use calib_protocol::health::{Defect, Defects, Health, Work};
use calib_protocol::message::{Refusal, ResetCause, RunState};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::board::{Leds, PartFault, SECTOR_BYTES, SECTORS, Schematic};
use calib_twin::plant::Plant;
use calib_twin::rig::Rig;
use calib_twin::runner::{Emulator, Firmware};
use std::num::NonZeroU64;
use std::time::Duration;

/// From power on, or from the last restart, until the links must answer.
const SECOND: Duration = Duration::from_secs(1);
/// `udf #0`: whoever comes here faults.
const FAULT: u16 = 0xDE00;
const FLASH_BYTES: usize = SECTORS * SECTOR_BYTES as usize;

fn power_on(flash: &[u8], fault: Option<PartFault>) -> Result<Rigged, Fault> {
    let firmware = Firmware::shipping()?;
    let plant = Box::new(Plant::new(&Rig::standard()));
    let mut board = Emulator::power_on_with_flash(&firmware, plant, flash)?;
    if let Some(fault) = fault {
        // Some show from the next start on.
        board.fail(fault)?;
        board.power_cycle()?;
    }
    board.run_for(SECOND)?;
    Ok(Rigged::of(board))
}

fn new_board(fault: PartFault) -> Result<Rigged, Fault> {
    power_on(&vec![0xFF; FLASH_BYTES], Some(fault))
}

/// It answers over both links, says what does not work, by its lamp too, refuses runs for that
/// reason, stops, and has never moved the exciter.
fn expect_degraded(rigged: &mut Rigged, defects: Defects) -> Result<Health, Fault> {
    let health = rigged.client.health()?.ok_or("it knows its health")?;
    assert_eq!(health.defects, defects);
    expect_refusal(&mut rigged.client, defects)?;
    for _ in 0..6 {
        rigged.client.stop()?;
    }
    assert_eq!(rigged.client.status()?.state, RunState::Idle);
    tap(rigged)?;
    assert_eq!(
        rigged.client.status()?.state,
        RunState::Idle,
        "a tap starts nothing"
    );
    assert_eq!(seen_blinks(rigged, defects)?, blinks(defects));
    let mut usb = Client::new(Box::new(EmulatedUsbTransport::plug_in(rigged.shared())?));
    assert_eq!(usb.health()?.map(|health| health.defects), Some(defects));
    let board = rigged.board();
    assert!(
        board.silent_for() >= Some(board.uptime()),
        "it moved the exciter"
    );
    Ok(health)
}

fn expect_refusal(client: &mut Client, defects: Defects) -> Result<(), Fault> {
    let points = [point(160.0, 10.0)];
    let labels = Default::default();
    let begun = calib_link::session::begin(client, &points, Default::default(), labels);
    match begun {
        Err(Error::Refused(refused)) => {
            assert_eq!(refused.refusal, Refusal::Degraded(defects));
            for defect in defects.iter() {
                assert!(refused.to_string().contains(defect.text()), "{refused}");
            }
            Ok(())
        }
        other => Err(format!("{other:?}").into()),
    }
}

fn tap(rigged: &mut Rigged) -> Result<(), Fault> {
    for pressed in [true, false] {
        rigged.board().press_button(pressed)?;
        rigged.client.wait(Duration::from_millis(100))?;
    }
    Ok(())
}

/// Times the red lamp goes on in one round, each defect by its number and one.
fn blinks(defects: Defects) -> u32 {
    defects.iter().map(|defect| defect as u32 + 1).sum()
}

/// Blinks as they are seen, in the time a round takes: half a second for a blink, 1.5 s between defects.
fn seen_blinks(rigged: &mut Rigged, defects: Defects) -> Result<u32, Fault> {
    let round_ms = 500 * blinks(defects) + 1_500 * defects.iter().count() as u32;
    let (mut rises, mut before) = (0, rigged.board().leds()?.red);
    for _ in 0..round_ms / 20 {
        rigged.client.wait(Duration::from_millis(20))?;
        let Leds { green, yellow, red } = rigged.board().leds()?;
        assert!(!green && !yellow);
        rises += u32::from(red && !before);
        before = red;
    }
    Ok(rises)
}

fn expect_all_well(rigged: &mut Rigged) -> Result<(), Fault> {
    let health = rigged.client.health()?.ok_or("it knows its health")?;
    assert!(
        health.defects.is_none() && health.restarts.is_empty(),
        "{health:?}"
    );
    Ok(())
}

/// It measures again, and says that all is well.
fn expect_well(rigged: &mut Rigged) -> Result<(), Fault> {
    expect_all_well(rigged)?;
    let outcome = rigged.run(&[point(160.0, 10.0)])?;
    assert_eq!(outcome.state, RunState::Finished);
    assert_eq!(outcome.points[0].state, PointState::Valid);
    Ok(())
}

/// A host's reset tries everything again.
fn mend_and_reset(rigged: &mut Rigged) -> Result<(), Fault> {
    rigged.board().mend()?;
    rigged.client.reset()?;
    rigged.client.wait(SECOND)?;
    assert_eq!(rigged.client.info()?.reset_cause, ResetCause::Software);
    Ok(())
}

#[test]
fn a_dead_converter_leaves_records_and_settings() -> Result<(), Fault> {
    for nth in [0, 1] {
        let mut rigged = new_board(PartFault::ConverterDead { nth })?;
        let defects = Defects::NONE.with(Defect::Converters);
        expect_degraded(&mut rigged, defects)?;
        assert_eq!(rigged.client.records()?.len(), 0);
        rigged.adjust(|settings| settings.blocks = 3)?;
        assert!(rigged.client.capture(100).is_err(), "there are no samples");
        assert_eq!(rigged.board().resets()?, [""; 0]);
        mend_and_reset(&mut rigged)?;
        assert_eq!(rigged.client.settings()?.blocks, 3);
        expect_well(&mut rigged)?;
    }
    Ok(())
}

/// The first sector looks half erased, and no erase is possible.
#[test]
fn a_record_area_that_cannot_be_repaired_leaves_the_links() -> Result<(), Fault> {
    let mut flash = vec![0xFF; FLASH_BYTES];
    flash[4096..8192].fill(0x5A);
    let mut rigged = power_on(&flash, Some(PartFault::FlashProtected))?;
    let defects = Defects::NONE.with(Defect::Archive);
    expect_degraded(&mut rigged, defects)?;
    let refused = rigged.client.records().expect_err("there is no archive");
    assert!(
        refused.to_string().contains(Defect::Archive.text()),
        "{refused}"
    );
    // Nothing is stored, but what is asked of the inputs can be had.
    rigged.client.capture(100)?;
    mend_and_reset(&mut rigged)?;
    // The erase that was due takes a second.
    rigged.client.wait(2 * SECOND)?;
    expect_well(&mut rigged)
}

#[test]
fn settings_that_cannot_be_read_are_not_replaced_silently() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.adjust(|settings| settings.blocks = 7)?;
    let mut flash = rigged.board().record_flash()?;
    assert_eq!(garble_settings(&mut flash), 2, "they are stored twice");
    let mut rigged = power_on(&flash, None)?;
    let defects = Defects::NONE.with(Defect::Settings);
    expect_degraded(&mut rigged, defects)?;
    // Whatever is written now may be another reference: under a hand alone.
    let settings = rigged.client.settings()?;
    assert!(rigged.client.write_settings(settings.clone()).is_err());
    rigged.under_a_hand(|client| Ok(client.write_settings(settings)?))?;
    expect_well(&mut rigged)
}

/// Gives every stored state's settings a version nobody knows, with the right check sum; how many.
fn garble_settings(flash: &mut [u8]) -> usize {
    const WORD: usize = 32;
    let mut garbled = 0;
    for at in (0..flash.len() - WORD).step_by(WORD) {
        let length = usize::from(u16::from_le_bytes([flash[at + 4], flash[at + 5]]));
        let Some(item) = flash.get(at + WORD..at + WORD + length) else {
            continue;
        };
        // A state item of version 2: its mark, then two sections, counters and settings.
        let is_state = item.get(..4) == Some(&[STATE_ITEM[0], STATE_ITEM[1], 1, 1]);
        if !is_state || flash[at..at + 4] != check_sum(item).to_le_bytes() {
            continue;
        }
        let version_at = at + WORD + 5 + usize::from(item[4]) + 1;
        assert_eq!(flash[version_at - 1..=version_at], [2, 1]);
        flash[version_at] = 99;
        let sum = check_sum(&flash[at + WORD..at + WORD + length]);
        flash[at..at + 4].copy_from_slice(&sum.to_le_bytes());
        garbled += 1;
    }
    garbled
}

/// Mark of a state item of version 2.
const STATE_ITEM: [u8; 2] = [0x02, 0x80];

/// CRC-32C of an item as `sequential-storage` 8 has it: another start, and never 0 or FF in its
/// first byte.
fn check_sum(data: &[u8]) -> u32 {
    let mut crc = 0xEEEE_EEEE_u32;
    for byte in data {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ (0x82F6_3B78 & (crc & 1).wrapping_neg());
        }
    }
    match !crc {
        0 => 1,
        value if matches!(value & 0xFF, 0 | 0xFF) => value ^ 1,
        value => value,
    }
}

#[test]
fn without_a_clock_the_links_are_up() -> Result<(), Fault> {
    let mut rigged = new_board(PartFault::NoClock)?;
    let defects = Defects::NONE.with(Defect::Clock);
    expect_degraded(&mut rigged, defects)?;
    assert_eq!(rigged.client.records()?.len(), 0);
    mend_and_reset(&mut rigged)?;
    expect_well(&mut rigged)
}

/// A fault each time the stored state is read: the fourth start leaves the record area out.
#[test]
fn three_faults_while_the_record_area_is_read_leave_it_out() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    let read = Firmware::shipping()?.symbol_at_path(&["State", "read"])? & !1;
    let before = rigged.board().patch(read, &[FAULT])?;
    rigged.board().power_cycle()?;
    rigged.client.wait(SECOND)?;
    assert_eq!(rigged.board().resets()?.len(), 1 + 3, "and no fourth try");
    let defects = Defects::NONE.with(Defect::Archive).with(Defect::Restarts);
    let health = rigged.client.health()?.ok_or("it knows its health")?;
    assert_eq!(health.defects, defects);
    assert_eq!(health.restarts.len(), 3);
    for restart in &health.restarts {
        assert!(restart.starts_with("hard fault at 0x08"), "{restart}");
    }
    expect_refusal(&mut rigged.client, defects)?;
    // It stays so, a minute later too, and until somebody tries again.
    rigged.client.wait(61 * SECOND)?;
    assert_eq!(rigged.board().resets()?.len(), 1 + 3);
    rigged.board().patch(read, &before)?;
    rigged.board().press_button(true)?;
    rigged.client.wait(Duration::from_millis(3_500))?;
    rigged.board().press_button(false)?;
    rigged.client.wait(SECOND)?;
    assert_eq!(rigged.client.settings()?.blocks, 3);
    expect_well(&mut rigged)
}

/// Faults of what runs: after three of them nothing is measured or stored, and the links are up.
#[test]
fn three_faults_of_what_runs_leave_links_and_lamps() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let measure = rigged.board().symbol("UART5")? & !1;
    let before = rigged.board().patch(measure, &[FAULT])?;
    rigged.client.wait(SECOND)?;
    assert_eq!(rigged.board().resets()?.len(), 3);
    let defects = Defects::NONE
        .with(Defect::Archive)
        .with(Defect::Converters)
        .with(Defect::Restarts);
    expect_degraded(&mut rigged, defects)?;
    rigged.board().patch(measure, &before)?;
    mend_and_reset(&mut rigged)?;
    expect_well(&mut rigged)
}

/// A clock that is 200 ppm fast, beside the frames of a host that are right.
#[test]
fn the_clock_is_compared_with_the_frames_of_a_usb_host() -> Result<(), Fault> {
    const SCHEMATIC: &str = include_str!("../../../firmware/boards/nucleo-h743zi2/schematic.toml");
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("schematic.toml");
    let fast = SCHEMATIC.replace("clock_hz = 8_000_000", "clock_hz = 8_001_600");
    assert_ne!(fast, SCHEMATIC);
    std::fs::write(&file, fast)?;
    let firmware = Firmware::shipping()?.on(Schematic::read(&file)?);
    let mut rigged = Rigged::with_image(&firmware, Box::new(Plant::new(&Rig::standard())))?;
    let none = rigged.client.health()?.ok_or("it knows its health")?;
    assert_eq!(none.timebase_ppm, None, "nobody is there");
    let _usb = EmulatedUsbTransport::plug_in(rigged.shared())?;
    rigged.client.wait(25 * SECOND)?;
    let health = rigged.client.health()?.ok_or("it knows its health")?;
    let ppm = health.timebase_ppm.ok_or("a host is there")?;
    // The edge of a frame is seen within 20 us of ten seconds.
    assert!((ppm - 200.0).abs() <= 4.0, "{ppm} ppm");
    Ok(())
}

/// At three cycles for each instruction, as from flash with wait states and without a cache: the
/// points whose periods are the longest are measured without a sample lost and without a mute.
#[test]
fn a_core_that_waits_for_its_flash_meets_every_deadline() -> Result<(), Fault> {
    let slow = NonZeroU64::new(3).ok_or("three")?;
    let firmware = Firmware::shipping()?.at(slow);
    let mut rigged = Rigged::with_image(&firmware, Box::new(Plant::new(&Rig::standard())))?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    // 31.5 Hz and 315 Hz have the folds of 4762 places.
    let points = [20.0, 31.5, 63.0, 315.0, 10_000.0].map(|frequency_hz| point(frequency_hz, 10.0));
    let outcome = rigged.run(&points)?;
    let late = rigged.late_lines(&firmware);
    assert!(late.is_empty(), "{late:?}");
    for result in &outcome.points {
        assert_eq!(
            result.state,
            PointState::Valid,
            "{} Hz",
            result.spec.frequency_hz
        );
    }
    assert_eq!(rigged.client.status()?.overruns, 0);
    let health = rigged.client.health()?.ok_or("it knows its health")?;
    assert_eq!(health.deadlines.len(), Work::ALL.len());
    for (work, deadline) in Work::ALL.iter().zip(&health.deadlines) {
        println!("{work:?}: {deadline:?}");
        assert!(deadline.longest_us < deadline.allowed_us, "{work:?}");
        // Nobody is at the USB port.
        let is_known = deadline.longest_us > 0.0 || *work == Work::UsbInterrupt;
        assert!(is_known, "{work:?} is never timed");
    }
    // What waits for AXI SRAM besides may take as long again.
    let evaluate = health.deadlines.get(Work::Evaluate as usize);
    let evaluate = evaluate.ok_or("it times its evaluations")?;
    assert!(
        evaluate.longest_us < 0.5 * evaluate.allowed_us,
        "{evaluate:?}"
    );
    Ok(())
}

/// Faults that a minute of life lies between do not add up: three without it would leave the instrument degraded.
#[test]
fn a_minute_of_life_between_faults_is_a_new_start() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let measure = rigged.board().symbol("UART5")? & !1;
    for faults in 1..=4 {
        let before = rigged.board().patch(measure, &[FAULT])?;
        rigged.client.wait(Duration::from_millis(15))?;
        rigged.board().patch(measure, &before)?;
        rigged.client.wait(2 * SECOND)?;
        assert_eq!(rigged.board().resets()?.len(), faults);
        if faults == 2 {
            rigged.client.wait(60 * SECOND)?;
            expect_all_well(&mut rigged)?;
        }
    }
    // Four in a row would be refused.
    let outcome = rigged.run(&[point(160.0, 10.0)])?;
    assert_eq!(outcome.state, RunState::Finished);
    Ok(())
}
