//! Both channels of a pair are of one instant, or nothing is measured: a sample between them is
//! 72 degrees at 10 kHz and leaves the magnitude alone.

use calib_core::point_state::{PointState, Reason};
use calib_protocol::message::{RunSpec, RunState};
use calib_protocol::record::RunLabels;
use calib_tests::judge::deviation;
use calib_tests::rigged::{Fault, Rigged, point, true_certificate};
use calib_twin::board::PartFault;
use calib_twin::rig::Rig;
use std::time::Duration;

/// A part with `fault` from its first instruction on, on the standard rig, whose reference is known.
fn calibrator(fault: PartFault) -> Result<(Rigged, Rig), Fault> {
    let rig = Rig::standard();
    let mut rigged = Rigged::with_rig(&rig)?;
    rigged.board().fail(fault)?;
    // The part keeps its fault; the converters start again.
    rigged.board().reset()?;
    rigged.client.wait(Duration::from_millis(300))?;
    rigged.certify_reference(&true_certificate(&rig))?;
    rigged.adjust(|settings| settings.blocks = 3)?;
    Ok((rigged, rig))
}

/// Measures at 160 Hz and 10 kHz: both pass, and their phase is the rig's.
fn measures_the_phase(rigged: &mut Rigged, rig: &Rig) -> Result<(), Fault> {
    let outcome = rigged.run(&[point(160.0, 10.0), point(10_000.0, 10.0)])?;
    assert_eq!(outcome.state, RunState::Finished);
    let sample_rate_hz = rigged.client.info()?.sample_rate_hz;
    for result in &outcome.points {
        let off = deviation(result, rig, sample_rate_hz);
        println!(
            "{} Hz: S {:+.3} %, phase {:+.3} deg, {}",
            result.spec.frequency_hz,
            100.0 * off.magnitude_rel,
            off.phase_rad.to_degrees(),
            result.state
        );
        assert_eq!(result.state, PointState::Valid);
        assert!(off.phase_rad.abs() <= f64::from(result.expanded_uncertainty_phase_rad));
    }
    Ok(())
}

#[test]
fn a_part_with_the_erratum_of_the_slave_measures_the_phase() -> Result<(), Fault> {
    let (mut rigged, rig) = calibrator(PartFault::SlaveShifted)?;
    measures_the_phase(&mut rigged, &rig)
}

#[test]
fn starts_that_go_wrong_are_repeated() -> Result<(), Fault> {
    // The third start is right.
    let (mut rigged, rig) = calibrator(PartFault::StartsShifted { starts: 2 })?;
    measures_the_phase(&mut rigged, &rig)
}

#[test]
fn channels_that_cannot_be_aligned_measure_nothing() -> Result<(), Fault> {
    let (mut rigged, _) = calibrator(PartFault::StartsShifted { starts: u32::MAX })?;
    let records = rigged.client.records()?;
    let refusal = rigged
        .run(&[point(160.0, 10.0)])
        .map(|outcome| outcome.state);
    let told = refusal.expect_err("a run is started").to_string();
    assert!(told.contains("not of the same instants"), "{told}");
    // The table has not moved, and everything else works.
    let board = rigged.board();
    assert_eq!(board.silent_for(), Some(board.uptime()));
    drop(board);
    assert_eq!(rigged.client.records()?, records);
    Ok(())
}

#[test]
fn a_run_in_which_the_alignment_is_lost_ends_with_that_reason() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    rigged.client.start(run_of_one())?;
    rigged.client.wait(Duration::from_millis(450))?;
    // The converters start again after an overrun, wrongly for good.
    rigged
        .board()
        .fail(PartFault::StartsShifted { starts: u32::MAX })?;
    rigged.board().fail(PartFault::AdcOverrun)?;
    rigged.client.wait(Duration::from_secs(1))?;
    let state = rigged.client.point(0)?.map(|result| result.state);
    assert_eq!(state, Some(PointState::Refused(Reason::ChannelsNotAligned)));
    rigged.expect_silence(Duration::from_millis(200))?;
    assert!(rigged.client.start(run_of_one()).is_err());
    Ok(())
}

fn run_of_one() -> RunSpec {
    RunSpec {
        points: [point(160.0, 10.0)].into_iter().collect(),
        labels: RunLabels::default(),
        excitation: Default::default(),
    }
}
