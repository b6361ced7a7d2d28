//! An example rig and points of it, for tests.

use super::candidate::active;
use super::evaluate::Memories;
use super::problem::Problem;
use crate::dataset::{Point, Rig};
use crate::effects::library;
use crate::estimation::significance::stream;
use crate::model::effect::Active;
use crate::observable::Observable;
use rand::RngExt;
use rand_distr::StandardNormal;

const RIG: &str = r#"
kind = "calibrator"
[reference]
sensitivity_v_per_ms2 = { value = 0.01, u = 0.00003 }
[dut]
sensitivity_v_per_ms2 = { value = 0.02, u = 0.0002 }
[exciter]
moving_mass_kg = { value = 0.05, u = 0.0005 }
stiffness_n_per_m = { value = 8000.0, u = 400.0 }
damping_ns_per_m = { value = 3.0, u = 0.6 }
force_factor_n_per_a = { value = 7.0, u = 0.2 }
coil_resistance_ohm = { value = 4.0, u = 0.05 }
coil_inductance_h = { value = 0.00012, u = 0.00001 }
"#;

/// The rig.
pub(crate) fn rig() -> Rig {
    toml::from_str(RIG).expect("the rig is good")
}

/// An effect of the library with values; entries of one name are told apart by their number.
pub(crate) fn named(name: &str, number: usize, parameters: &[f64]) -> Active<'static> {
    let entries = library().iter().enumerate();
    let mut named = entries.filter(|(_, e)| e.entry().id == name);
    let (entry, _) = named.nth(number).expect("an entry of the library");
    active(entry, parameters.to_vec())
}

/// Points of the rig with some effects, and the scatter they state.
pub(super) fn measured(effects: &[(&str, Vec<f64>)]) -> (Rig, Vec<Point>) {
    let rig = rig();
    let blank = |i: usize| Point {
        frequency_hz: 5.0 * 1.07_f64.powi(i as i32),
        acceleration_ms2: Some(10.0),
        payload_kg: Some(0.04),
        coil_v: Some(1.0),
        ref_v: Some(1.0),
        ref_rad: Some(0.0),
        coil_a: Some(1.0),
        coil_a_rad: Some(0.0),
        u_drive: Some(5e-4),
        u_current: Some(5e-4),
        ..Point::default()
    };
    let mut points: Vec<Point> = (0..120).map(blank).collect();
    let problem = Problem::new(&rig, &points);
    let mut memory = problem.memory();
    let mut draw = stream(8);
    let mut noise = || -> f64 { 5e-4 * draw.sample::<f64, _>(StandardNormal) };
    let theta = vec![0.0; problem.free.len()];
    let effects = effects.iter();
    let active: Vec<_> = effects
        .map(|(name, values)| named(name, 0, values))
        .collect();
    problem.predictions(
        &active,
        &theta,
        Memories::Keep(&mut memory),
        |row, found| {
            let mut value = |observable| found.value[observable] + noise();
            let [drive, drive_rad] = Observable::DRIVE.map(&mut value);
            let [current, current_rad] = Observable::CURRENT.map(value);
            let point = &mut points[row];
            (point.ref_v, point.ref_rad) = (Some(drive.exp()), Some(drive_rad));
            (point.coil_a, point.coil_a_rad) = (Some(current.exp()), Some(current_rad));
        },
    );
    (rig, points)
}
