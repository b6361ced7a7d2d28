//! The self-test passes on a sound board, moves no table, and names each defect.

use calib_core::point_state::PointState;
use calib_core::self_test::{Check, Line};
use calib_protocol::message::Refusal;
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::board::{Flaw, Flawed, PartFault, RECORD_FLASH, SECTOR_BYTES};
use calib_twin::rig::Rig;
use std::time::Duration;

/// After it the processor's sensors were read anew (5 Hz).
const SENSED: Duration = Duration::from_millis(450);

fn failed(lines: &[Line]) -> Vec<Check> {
    let failed = lines.iter().filter(|line| !line.passed());
    failed.map(|line| line.check).collect()
}

/// The lines that fail with `faults` on the board.
fn found(rigged: &mut Rigged, faults: &[PartFault]) -> Result<Vec<Check>, Fault> {
    for fault in faults {
        rigged.board().fail(*fault)?;
    }
    rigged.client.wait(SENSED)?;
    let lines = rigged.client.self_test()?;
    let failed = failed(&lines);
    for line in lines.iter().filter(|line| failed.contains(&line.check)) {
        println!("    {line:?}");
    }
    Ok(failed)
}

fn flaw(of: Flawed, flaw: Flaw) -> PartFault {
    PartFault::Flaw { of, flaw }
}

#[test]
fn a_sound_board_passes_and_its_table_stays_where_it_is() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    for _ in 0..2 {
        rigged.client.wait(SENSED)?;
        let lines = rigged.client.self_test()?;
        for line in &lines {
            println!("{line:?}");
        }
        assert_eq!(failed(&lines), []);
        // The tone went nowhere: not one code but mid-scale since power on, on the exciter's pin.
        let board = rigged.board();
        assert_eq!(board.silent_for(), Some(board.uptime()));
        drop(board);
        assert_eq!(super::board::unmodelled(&mut rigged.board())?, [""; 0]);
    }
    // And everything is as before: what is measured passes.
    rigged.adjust(|settings| settings.blocks = 3)?;
    let outcome = rigged.run(&[point(160.0, 10.0)])?;
    assert_eq!(outcome.points.len(), 1);
    rigged.expect_silence(Duration::from_millis(100))?;
    rigged.client.wait(SENSED)?;
    assert_eq!(failed(&rigged.client.self_test()?), []);
    Ok(())
}

/// The converters begin anew in a self-test, at any place of the drive's ring: a command takes 10 to 20 ms to the
/// samples then, and levels are reached as before.
#[test]
fn levels_are_reached_wherever_the_rings_stand() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    for tests in 0..5 {
        let points = [160.0, 80.0, 1000.0, 1250.0].map(|hz| point(hz, 10.0));
        let outcome = rigged.run(&points)?;
        assert_eq!(outcome.points.len(), 4);
        for result in &outcome.points {
            let hz = result.spec.frequency_hz;
            println!(
                "{tests} {hz} Hz: {:.3} s, {:.4}",
                result.settling_s, result.overshoot_rel
            );
            assert_eq!(result.state, PointState::Valid, "{tests}: {result:?}");
            assert!(result.overshoot_rel < 0.05, "{tests}: {result:?}");
            assert!(
                (result.acceleration_rms_ms2 / 10.0 - 1.0).abs() < 1.0e-3,
                "{result:?}"
            );
            assert!(
                result.settling_s < (20.0 / hz).max(0.5),
                "{tests}: {result:?}"
            );
        }
        rigged
            .client
            .wait(SENSED + Duration::from_micros(3300 * tests))?;
        assert_eq!(failed(&rigged.client.self_test()?), []);
    }
    Ok(())
}

#[test]
fn no_test_during_a_run() -> Result<(), Fault> {
    use calib_protocol::message::RunSpec;
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.client.start(RunSpec {
        points: [point(160.0, 10.0)].into_iter().collect(),
        labels: Default::default(),
        excitation: Default::default(),
    })?;
    rigged.client.wait(Duration::from_millis(300))?;
    let refused = rigged.client.self_test().expect_err("a run is going on");
    let calib_link::Error::Refused(refused) = refused else {
        return Err(refused.into());
    };
    assert_eq!(refused.refusal, Refusal::Busy);
    rigged.client.stop()?;
    rigged.expect_silence(Duration::from_millis(200))
}

/// Option bytes as the factory leaves them (RM0433 Rev 9, table 21).
const FACTORY: u32 = 0x0006_AAF0;
/// Brown-out level 3 in bits 2 and 3.
const LEVEL_3: u32 = 0b1100;

/// Until this stage nothing told a part of the factory from one that was set up.
#[test]
fn a_part_of_the_factory_is_named_by_the_test_and_by_its_health() -> Result<(), Fault> {
    use Check::{BrownOut, OptionBytes};
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let health = rigged.client.health()?.ok_or("it knows its health")?;
    let options = health.option_bytes.ok_or("it knows its option bytes")?;
    assert_eq!(
        (options.0, options.brown_out_level()),
        (FACTORY | LEVEL_3, 3)
    );
    for (status, level, want) in [
        (FACTORY, 0, &[BrownOut][..]),
        (FACTORY | 0b1000, 2, &[BrownOut]),
        // Read-out protection level 1.
        (FACTORY & !0xFF00 | LEVEL_3, 3, &[OptionBytes]),
        // A watchdog of the hardware, from reset on, and level 1.
        (FACTORY & !0x10 | 0b0100, 1, &[BrownOut, OptionBytes]),
    ] {
        rigged.board().fail(PartFault::OptionBytes { status })?;
        // The part loads them when the power comes.
        rigged.board().power_cycle()?;
        rigged.client.wait(Duration::from_secs(1))?;
        assert_eq!(found(&mut rigged, &[])?, want, "{status:#x}");
        let health = rigged.client.health()?.ok_or("it knows its health")?;
        let told = health.option_bytes.ok_or("it knows its option bytes")?;
        assert_eq!((told.0, told.brown_out_level()), (status, level));
    }
    rigged.board().mend()?;
    assert_eq!(found(&mut rigged, &[])?, []);
    Ok(())
}

#[test]
fn flash_that_wears_out_is_named_by_where_it_is() -> Result<(), Fault> {
    use Check::{FlashCorrected, FlashUnreadable, ImageErrors, Records};
    const IMAGE: u64 = 0x0802_0000;
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    rigged.run(&[point(160.0, 10.0)])?;
    let poisoned = |address| PartFault::PoisonedWord { address };
    let weak = |address| PartFault::WeakWord { address };
    // Behind the image in its slot: a word of it that cannot be read is no board that runs.
    assert_eq!(found(&mut rigged, &[weak(IMAGE + 0x100)])?, [ImageErrors]);
    assert_eq!(
        found(&mut rigged, &[poisoned(IMAGE + (384 << 10) - 32)])?,
        [ImageErrors]
    );
    let erased = RECORD_FLASH + 5 * SECTOR_BYTES;
    let known = [ImageErrors];
    // A few words torn by power cuts are no wear; the seventeenth is.
    let torn: Vec<_> = (0..16).map(|word| poisoned(erased + 320 * word)).collect();
    assert_eq!(found(&mut rigged, &torn)?, known);
    let one_more = found(&mut rigged, &[poisoned(erased + 320 * 16)])?;
    assert_eq!(one_more, [ImageErrors, FlashUnreadable]);
    let worn = found(&mut rigged, &[weak(erased + 64)])?;
    assert_eq!(worn, [ImageErrors, FlashCorrected, FlashUnreadable]);
    // The board restarts and measures on all that.
    assert_eq!(rigged.client.records()?.len(), 2);
    // The words of both, the change of the settings and the run: from the first item of the first sector on.
    let flash = rigged.board().record_flash()?;
    let stored = flash
        .chunks(32)
        .take(4096)
        .rposition(|word| word.iter().any(|byte| *byte != 0xFF));
    let last = stored.ok_or("nothing is stored")? as u64 * 32;
    let all = (32..=last)
        .step_by(32)
        .map(|at| poisoned(RECORD_FLASH + at));
    let lost = found(&mut rigged, &all.collect::<Vec<_>>())?;
    assert_eq!(
        lost,
        [Records, ImageErrors, FlashCorrected, FlashUnreadable]
    );
    Ok(())
}

/// Sixteen defects that leave the board running, one after the other on one board.
#[test]
fn each_defect_fails_its_lines_and_no_other() -> Result<(), Fault> {
    use Check::*;
    let sound = Flaw::default();
    let gain = |gain_ppm| Flaw { gain_ppm, ..sound };
    let offset = |offset| Flaw { offset, ..sound };
    let noise = |noise_peak| Flaw {
        noise_peak,
        ..sound
    };
    let stuck = |stuck_high| Flaw {
        stuck_high,
        ..sound
    };
    let dead = Flaw {
        dead: true,
        ..sound
    };
    let supply = |millivolts| PartFault::ConverterSupply { millivolts };
    let processor = |celsius: i32| PartFault::Processor {
        centi_c: Some(100 * celsius),
    };
    let starts = PartFault::StartsShifted { starts: u32::MAX };
    let (adc1, adc2, dac) = (Flawed::Adc1, Flawed::Adc2, Flawed::Dac);
    // What must fail is by hand: 16-bit codes are 50 uV, 12-bit ones 0.8 mV.
    let defects: [(&str, PartFault, &[Check]); 16] = [
        ("supply 3.0 V", supply(3000), &[Supply]),
        ("supply 3.6 V", supply(3600), &[Supply]),
        ("processor at 110 degrees", processor(110), &[Temperature]),
        ("processor at -30 degrees", processor(-30), &[Temperature]),
        (
            "100 mV on the reference's input",
            flaw(adc1, offset(2000)),
            &[ReferenceOffset],
        ),
        (
            "7 mV of noise, reference",
            flaw(adc1, noise(250)),
            &[ReferenceNoise],
        ),
        (
            "ADC1 dead",
            flaw(adc1, dead),
            &[ReferenceNoise, Alignment, ReferenceDither],
        ),
        (
            "-100 mV in ADC2",
            flaw(adc2, offset(-2000)),
            &[DutOffset, DriveOffset],
        ),
        (
            "7 mV of noise in ADC2",
            flaw(adc2, noise(250)),
            &[DutNoise, DriveNoise],
        ),
        ("DAC 5 % low", flaw(dac, gain(-50_000)), &[DriveGain]),
        ("DAC 5 % high", flaw(dac, gain(50_000)), &[DriveGain]),
        ("DAC 40 mV off", flaw(dac, offset(50)), &[DriveOffset]),
        (
            "a bit of the DAC stuck",
            flaw(dac, stuck(1 << 4)),
            &[DriveDistortion],
        ),
        ("DAC noisy", flaw(dac, noise(8)), &[DriveNoise]),
        ("DAC dead", flaw(dac, dead), &[DriveGain]),
        ("slave's data shifted", starts, &[Alignment]),
    ];
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let mend = [
        flaw(adc1, sound),
        flaw(adc2, sound),
        flaw(dac, sound),
        supply(3300),
        PartFault::Processor { centi_c: None },
        PartFault::StartsShifted { starts: 0 },
    ];
    let mut wrong = Vec::new();
    for (defect, fault, want) in defects {
        println!("{defect}");
        let seen = found(&mut rigged, &[fault])?;
        if seen != want {
            wrong.push(format!("{defect}: {seen:?} and not {want:?}"));
        }
        let after = found(&mut rigged, &mend)?;
        if !after.is_empty() {
            wrong.push(format!("after {defect}: {after:?}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    Ok(())
}

/// A front end without dither, and one whose capacitor is 10 % too large: 0.244 V r.m.s.
#[test]
fn a_dither_that_is_not_there_or_too_small_is_named() -> Result<(), Fault> {
    for share in [0.0, 0.9] {
        let mut rig = Rig::standard();
        rig.converter.dither_peak_v *= share;
        let mut rigged = Rigged::with_rig(&rig)?;
        rigged.client.wait(SENSED)?;
        let named = failed(&rigged.client.self_test()?);
        assert_eq!(named, [Check::ReferenceDither, Check::DutDither], "{share}");
    }
    Ok(())
}

#[test]
fn what_happened_since_the_start_is_named() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let lost = found(&mut rigged, &[PartFault::AdcOverrun])?;
    assert_eq!(lost, [Check::LostPairs]);
    // The task that takes the samples stands still, and the board starts again for it.
    let restarted = found(&mut rigged, &[PartFault::DmaStops { stream: 1 }])?;
    println!("{restarted:?}");
    rigged.client.wait(Duration::from_secs(1))?;
    assert_eq!(failed(&rigged.client.self_test()?), [Check::LastStart]);
    Ok(())
}
