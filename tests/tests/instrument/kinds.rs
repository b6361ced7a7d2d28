//! Sensors that are no accelerometers, measured by the shipping image and stated in their own quantity.

use calib_certificate::model::{Certificate, PointValues};
use calib_certificate::{Particulars, complete};
use calib_core::point::{ExcitationKind, PointSpec};
use calib_core::point_state::PointState;
use calib_link::session;
use calib_protocol::message::RunState;
use calib_protocol::record::{self, Record, RunLabels};
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

fn measured(rig: &Rig, list: &[PointSpec]) -> Result<Record, Fault> {
    let mut rigged = Rigged::with_rig(rig)?;
    let outcome = rigged.run(list)?;
    assert_eq!(outcome.state, RunState::Finished);
    Ok(record::decode(&rigged.record(outcome.record_id)?)?)
}

fn stated(record: &Record, kind: &str) -> Certificate {
    let mut particulars = Particulars::default();
    particulars.item.unit = Some(kind.parse().expect(kind));
    Certificate::from_record(record, &particulars)
}

/// Sensitivity and phase of the object at the reference point, with their U.
fn at_reference(certificate: &Certificate) -> &PointValues {
    certificate.reference_result().expect("valid").1
}

/// A heavily damped seismic mass of 160 Hz follows the velocity there: `H = -j Q` of formula (1) of ISO 16063-43, so
/// that `S = j w (-j Q S0) = w Q S0`, in phase. Against acceleration it lies at a quarter turn.
#[test]
fn a_damped_mass_at_its_resonance_is_a_velocity_transducer() -> Result<(), Fault> {
    for inverted in [false, true] {
        let mut rig = Rig::standard();
        (rig.dut.resonance_hz, rig.dut.quality_factor) = (160.0, 0.3);
        rig.dut.conditioner_gain *= if inverted { -1.0 } else { 1.0 };
        let truth =
            TAU * 160.0 * 0.3 * rig.dut.sensitivity_v_per_ms2 * rig.dut.conditioner_gain.abs();
        let record = measured(&rig, &[point(160.0, 10.0), point(80.0, 10.0)])?;
        let certificate = stated(&record, "mV/(mm/s)");
        let values = at_reference(&certificate);
        let off = values.sensitivity / truth - 1.0;
        assert!(
            off.abs() < values.expanded_uncertainty_percent / 100.0,
            "{off}"
        );
        assert!(
            values.phase_deg.abs() < values.expanded_uncertainty_phase_deg,
            "{values:?}"
        );
        assert_eq!(certificate.inverted, inverted);
    }
    Ok(())
}

/// Far above its resonance a seismic mass stands still and gives the displacement: `H = -1/q^2`, so that
/// `S = -w^2 H S0 = w0^2 S0`; at 640 Hz and 10 Hz 1/q^2 is 2.4e-4 beside that, the damping 1.3 degrees.
#[test]
fn a_mass_far_above_its_resonance_is_a_displacement_transducer() -> Result<(), Fault> {
    let mut rig = Rig::standard();
    (rig.dut.resonance_hz, rig.dut.quality_factor) = (10.0, 0.7);
    // 4 V/(m/s2) below its resonance are 1 mV/(m/s2) at 640 Hz.
    rig.dut.sensitivity_v_per_ms2 = 4.0;
    let truth = (TAU * 10.0).powi(2) * rig.dut.sensitivity_v_per_ms2 * rig.dut.conditioner_gain;
    let record = measured(&rig, &[point(640.0, 10.0)])?;
    let certificate = stated(&record, "mV/um");
    let values = at_reference(&certificate);
    let off = values.sensitivity / truth - 1.0;
    assert!(
        off.abs() < 3.0e-4 + values.expanded_uncertainty_percent / 100.0,
        "{off}"
    );
    assert!(!certificate.inverted);
    assert!(
        values.phase_deg.abs() < 1.4 + values.expanded_uncertainty_phase_deg,
        "{values:?}"
    );
    Ok(())
}

/// A list that was stopped has its untried points in the record; what measures them makes one calibration of both.
#[test]
fn what_a_stopped_run_never_tried_is_known_and_completes_it() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let list = [point(160.0, 10.0), point(80.0, 10.0), point(1000.0, 10.0)];
    // Stopped as soon as the first point has ended.
    let stop = |progress: &session::Progress<'_>| match progress.points.is_empty() {
        true => ControlFlow::Continue(()),
        false => ControlFlow::Break(()),
    };
    let (kind, labels) = (ExcitationKind::SingleSine, RunLabels::default());
    let outcome = session::run_excited(&mut rigged.client, &list, kind, labels, stop)?;
    assert_eq!(outcome.state, RunState::Stopped);
    let first = record::decode(&rigged.record(outcome.record_id)?)?;
    assert_eq!(first.points.len() + first.untried.len(), list.len());
    assert!(!first.untried.is_empty());
    let left: Vec<PointSpec> = calib_certificate::without_result(&first).collect();
    let outcome = rigged.run(&left)?;
    let later = record::decode(&rigged.record(outcome.record_id)?)?;
    let whole = complete(&first, &[later])?;
    assert!(whole.untried.is_empty());
    let valid = |hz: f32| {
        whole
            .points
            .iter()
            .any(|p| p.spec.frequency_hz == hz && p.state == PointState::Valid)
    };
    assert!([160.0, 80.0, 1000.0].map(valid).iter().all(|valid| *valid));
    Ok(())
}
