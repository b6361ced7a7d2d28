//! Every fault ends in a named state and a silent exciter.

use calib_core::point::PointSpec;
use calib_core::point_state::{PointState, Reason};
use calib_protocol::message::RunState;
use calib_protocol::record::{RecordKind, RecordSummary};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;
use std::time::Duration;

/// Runs one point on `rig`, and expects its state and silence.
fn expect(rig: &Rig, spec: PointSpec, reason: Reason) -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(rig)?;
    let outcome = rigged.run(&[spec])?;
    assert_ne!(outcome.state, RunState::Failed);
    let result = outcome.points.first().ok_or("no result")?;
    assert_eq!(result.state, PointState::Refused(reason));
    rigged.expect_silence(Duration::from_millis(200))?;
    assert_eq!(rigged.client.status()?.overruns, 0);
    // The refusal is stored like any other result.
    let records = rigged.client.records()?;
    assert_eq!(records.last().map(|record| record.refused), Some(1));
    Ok(())
}

#[test]
fn a_clipped_input_is_refused() -> Result<(), Fault> {
    let mut rig = Rig::standard();
    // 10 m/s2 r.m.s. are 14.1 m/s2 peak: 7 V at a 5 V input.
    rig.dut.sensitivity_v_per_ms2 = 0.5;
    expect(&rig, point(160.0, 10.0), Reason::Clipped)
}

#[test]
fn a_dead_reference_is_refused() -> Result<(), Fault> {
    let mut rig = Rig::standard();
    rig.reference.conditioner_gain = 0.0;
    expect(&rig, point(160.0, 10.0), Reason::ReferenceDead)
}

#[test]
fn an_open_device_under_test_is_refused() -> Result<(), Fault> {
    let mut rig = Rig::standard();
    rig.dut.conditioner_gain = 0.0;
    expect(&rig, point(160.0, 10.0), Reason::DutOpen)
}

#[test]
fn a_level_beyond_the_amplifier_is_refused() -> Result<(), Fault> {
    let mut rig = Rig::standard();
    // A twentieth of the force: 10 m/s2 would take more than 10 V at 1 kHz.
    rig.exciter.force_factor_n_per_a *= 0.05;
    expect(&rig, point(1000.0, 10.0), Reason::DriveLimit)
}

#[test]
fn a_level_beyond_the_stroke_is_refused_before_the_table_moves() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    // 60 m/s2 r.m.s. at 20 Hz are 5.4 mm peak, above the limit of 5 mm, and
    // 0.68 m/s peak, below the limit of 1 m/s. The points before it do not move the table either.
    let list = [point(160.0, 10.0), point(80.0, 10.0), point(20.0, 60.0)];
    let refused = rigged
        .run(&list)
        .map(drop)
        .expect_err("before anything moves");
    let said = refused.to_string();
    assert!(
        said.contains("point 3 of the list: the level exceeds the displacement limit"),
        "{said}"
    );
    rigged.expect_silence(Duration::from_millis(500))?;
    assert!(!rigged.client.status()?.state.is_running());
    let calibrations = |record: &RecordSummary| record.kind == RecordKind::Calibration;
    assert!(
        !rigged.client.records()?.iter().any(calibrations),
        "no run began"
    );
    Ok(())
}
