//! The shipping firmware measures many frequencies at once (4.4, Note 1).

use calib_core::point::ExcitationKind;
use calib_core::point_state::{PointState, Reason};
use calib_link::session::{self, Outcome};
use calib_protocol::message::RunState;
use calib_protocol::record::RunLabels;
use calib_tests::judge::deviation;
use calib_tests::rigged::{Fault, Rigged, point, true_certificate};
use calib_twin::rig::Rig;
use std::ops::ControlFlow;
use std::time::Duration;

const SAMPLE_RATE_HZ: f32 = 50_000.0;

fn multisine(rigged: &mut Rigged) -> Result<Outcome, Fault> {
    let wanted = [160.0, 80.0, 500.0, 1000.0, 2000.0, 5000.0, 8000.0];
    let points = session::on_lines(&wanted.map(|f| point(f, 10.0)), SAMPLE_RATE_HZ)?;
    let labels = RunLabels::default();
    let kind = ExcitationKind::Multisine;
    let client = &mut rigged.client;
    let outcome =
        session::run_excited(client, &points, kind, labels, |_| ControlFlow::Continue(()))?;
    assert_eq!(outcome.state, RunState::Finished);
    assert_eq!(outcome.points.len(), wanted.len());
    rigged.expect_silence(Duration::from_millis(200))?;
    assert_eq!(rigged.client.status()?.overruns, 0, "no sample was lost");
    Ok(outcome)
}

#[test]
fn a_multisine_finds_an_inverted_device_and_refuses_a_noisy_one() -> Result<(), Fault> {
    let mut rig = Rig::standard();
    rig.dut.sensitivity_v_per_ms2 = -rig.dut.sensitivity_v_per_ms2;
    // What is allowed is the method's own error.
    rig.converter.errors = 0.0;
    let mut rigged = Rigged::with_rig(&rig)?;
    rigged.certify_reference(&true_certificate(&rig))?;
    for result in multisine(&mut rigged)?.points {
        assert_eq!(result.state, PointState::Valid, "{result:?}");
        assert!(result.coherence.is_some_and(|coherence| coherence > 0.99));
        // Annex B: inverted, and not 180 degrees of phase shift.
        assert!(result.inverted && result.phase_rad.abs() < 0.2);
        let mut upright = result;
        upright.phase_rad += std::f32::consts::PI;
        let off = deviation(&upright, &rig, SAMPLE_RATE_HZ);
        println!("{} Hz: {off:?}", result.spec.frequency_hz);
        // The certificate is linear between its rows where the reference's
        // resonance is not: 0.1 %, as the single sine; and five times the noise.
        let allowed = 1.0e-3 + 5.0 * f64::from(result.repeatability_rel);
        assert!(off.magnitude_rel.abs() <= allowed, "{result:?} {off:?}");
        assert!(off.phase_rad.abs() <= 2.0e-3 + allowed, "{off:?}");
    }

    // 10 m/s2 are 0.1 V on some 650 lines, and 0.1 V of noise lies on 2048: a
    // third of the signal's power on each, coherence about 0.76.
    rig.dut.noise_rms_v = 0.1;
    rigged.mount(&rig);
    for result in multisine(&mut rigged)?.points {
        assert_eq!(result.state, PointState::Refused(Reason::LowCoherence));
        assert!(result.coherence.is_some_and(|coherence| coherence < 0.98));
    }
    Ok(())
}
