//! The self-test passes on a sound board, moves no table, and names each defect.

use calib_core::self_test::{Check, Line};
use calib_protocol::message::Refusal;
use calib_tests::bench::{Bench, Fault, point};
use calib_twin::board::{Flaw, Flawed, PartFault};
use calib_twin::rig::Rig;
use std::time::Duration;

/// After it the processor's sensors were read anew (5 Hz).
const SENSED: Duration = Duration::from_millis(450);

fn failed(lines: &[Line]) -> Vec<Check> {
    let failed = lines.iter().filter(|line| !line.passed());
    failed.map(|line| line.check).collect()
}

/// The lines that fail with `faults` on the board.
fn found(bench: &mut Bench, faults: &[PartFault]) -> Result<Vec<Check>, Fault> {
    for fault in faults {
        bench.board().fail(*fault)?;
    }
    bench.client.wait(SENSED)?;
    let lines = bench.client.self_test()?;
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
    let mut bench = Bench::with_rig(&Rig::standard())?;
    for _ in 0..2 {
        bench.client.wait(SENSED)?;
        let lines = bench.client.self_test()?;
        for line in &lines {
            println!("{line:?}");
        }
        assert_eq!(failed(&lines), []);
        // The tone went nowhere: not one code but mid-scale since power on, on the exciter's pin.
        let board = bench.board();
        assert_eq!(board.silent_for(), Some(board.uptime()));
        drop(board);
        assert_eq!(super::board::unmodelled(&mut bench.board())?, [""; 0]);
    }
    // And everything is as before: what is measured passes.
    bench.adjust(|settings| settings.blocks = 3)?;
    let outcome = bench.run(&[point(160.0, 10.0)])?;
    assert_eq!(outcome.points.len(), 1);
    bench.expect_silence(Duration::from_millis(100))?;
    bench.client.wait(SENSED)?;
    assert_eq!(failed(&bench.client.self_test()?), []);
    Ok(())
}

#[test]
fn no_test_during_a_run() -> Result<(), Fault> {
    use calib_protocol::message::RunSpec;
    let mut bench = Bench::with_rig(&Rig::standard())?;
    bench.client.start(RunSpec {
        points: [point(160.0, 10.0)].into_iter().collect(),
        labels: Default::default(),
        excitation: Default::default(),
    })?;
    bench.client.wait(Duration::from_millis(300))?;
    let refused = bench.client.self_test().expect_err("a run is going on");
    let calib_link::Error::Refused(refused) = refused else {
        return Err(refused.into());
    };
    assert_eq!(refused.refusal, Refusal::Busy);
    bench.client.stop()?;
    bench.expect_silence(Duration::from_millis(200))
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
        ("ADC1 dead", flaw(adc1, dead), &[ReferenceNoise, Alignment]),
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
    let mut bench = Bench::with_rig(&Rig::standard())?;
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
        let seen = found(&mut bench, &[fault])?;
        if seen != want {
            wrong.push(format!("{defect}: {seen:?} and not {want:?}"));
        }
        let after = found(&mut bench, &mend)?;
        if !after.is_empty() {
            wrong.push(format!("after {defect}: {after:?}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    Ok(())
}

#[test]
fn what_happened_since_the_start_is_named() -> Result<(), Fault> {
    let mut bench = Bench::with_rig(&Rig::standard())?;
    let lost = found(&mut bench, &[PartFault::AdcOverrun])?;
    assert_eq!(lost, [Check::LostPairs]);
    // The task that takes the samples stands still, and the board starts again for it.
    let restarted = found(&mut bench, &[PartFault::DmaStops { stream: 1 }])?;
    println!("{restarted:?}");
    bench.client.wait(Duration::from_secs(1))?;
    assert_eq!(failed(&bench.client.self_test()?), [Check::LastStart]);
    Ok(())
}
