//! A host without a hand on the button changes nothing that shapes a number or a limit.

use calib_core::settings::{Method, PointInfluences, Settings};
use calib_link::Error;
use calib_protocol::message::Refusal;
use calib_tests::rigged::{Fault, Rigged, point};
use calib_twin::rig::Rig;

/// Changes by an adversary, by name.
type Attack = (&'static str, fn(&mut Settings));

const ATTACKS: [Attack; 9] = [
    ("scale of the device's input", |s| {
        s.dut_input.volt_per_code *= 0.85
    }),
    ("influences", |s| {
        for influence in &mut s.influences {
            influence.value_rel = 0.0;
            influence.value_phase_rad = 0.0;
        }
    }),
    ("influences of points", |s| {
        s.point_influences = PointInfluences::NONE
    }),
    ("acceleration limit", |s| {
        s.limits.acceleration_peak_ms2 *= 2.0
    }),
    ("velocity limit", |s| s.limits.velocity_peak_ms = 1.0e30),
    ("displacement limit", |s| {
        s.limits.displacement_peak_m = 1.0e30
    }),
    ("full scale of the drive", |s| {
        s.drive_full_scale_peak_v *= 10.0
    }),
    ("blocks", |s| s.blocks = 2),
    ("method", |s| s.method = Method::Comparison),
];

#[test]
fn a_host_without_a_hand_changes_nothing_that_shapes_a_number_or_a_limit() -> Result<(), Fault> {
    let mut rigged = Rigged::with_rig(&Rig::standard())?;
    let before = rigged.client.settings()?;
    let honest = rigged.run(&[point(160.0, 10.0)])?;
    let mut taken = Vec::new();
    for (name, attack) in ATTACKS {
        let mut settings = rigged.client.settings()?;
        attack(&mut settings);
        match rigged.client.write_settings(settings) {
            Err(Error::Refused(refused)) => {
                assert!(
                    [Refusal::ButtonNotHeld, Refusal::Settings].contains(&refused.refusal),
                    "{name}: {refused:?}"
                );
            }
            Err(other) => return Err(other.into()),
            Ok(()) => taken.push(name),
        }
    }
    let attacked = rigged.run(&[point(160.0, 10.0)])?;
    let (honest, attacked) = (honest.points[0], attacked.points[0]);
    for (name, point) in [("before", honest), ("after", attacked)] {
        println!(
            "{name}: S {:.4} mV/(m/s2), U {:.2} %, {}",
            1e3 * point.sensitivity_v_per_ms2,
            100.0 * point.expanded_uncertainty_rel,
            point.state
        );
    }
    assert_eq!(taken, [""; 0], "taken without a hand");
    assert_eq!(rigged.client.settings()?, before);
    // Two runs of one rig agree within twice what both say of their scatter, k = 2: 4 u of each.
    let scatter_rel = 4.0 * honest.repeatability_rel.hypot(attacked.repeatability_rel);
    let change_rel = attacked.sensitivity_v_per_ms2 / honest.sensitivity_v_per_ms2 - 1.0;
    assert!(
        change_rel.abs() <= scatter_rel,
        "{change_rel} {scatter_rel}"
    );
    Ok(())
}
