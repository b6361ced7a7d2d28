//! The two files of a case.

use super::characteristic::ORDERS;
use super::design::Condition;
use super::disturbed::disturbed;
use super::random::Random;
use super::scatter::{Deviates, Scatter};
use super::steady::{Steady, relative, steady};
use super::truth::{NOMINAL, REFERENCE_V_PER_MS2, Truth};
use num_complex::Complex64 as C;
use std::fmt::Write;

/// Standard uncertainties of each row.
pub(crate) struct Quality {
    pub(crate) u_ratio: f64,
    pub(crate) u_phase_deg: f64,
    pub(crate) u_drive: f64,
    pub(crate) u_current: f64,
    pub(crate) u_harmonic: f64,
    pub(crate) u_dc_v: f64,
}

pub(crate) const GOOD: Quality = Quality {
    u_ratio: 0.0005,
    u_phase_deg: 0.03,
    u_drive: 0.001,
    u_current: 0.001,
    u_harmonic: 5e-5,
    u_dc_v: 5e-6,
};

/// Values of a row that scatter as stated: ratio, drive and current, harmonics, means.
pub(crate) const VALUES: usize = 24;
/// Number of the first value of drive, current, harmonics and means.
const DRIVE: usize = 2;
const CURRENT: usize = 4;
const REF_HARMONICS: usize = 6;
const DUT_HARMONICS: usize = 14;
const MEANS: usize = 22;

/// Repeatability of a mounting.
const U_MOUNTING: f64 = 2e-4;

const CONDITIONS: &str = "frequency_hz,run,time_s,temperature_c,rotation_deg,tilt_deg,payload_kg";
const ALL: &str = "acceleration_ms2,coil_v,coil_a,coil_a_deg,ref_v,ref_deg,dut_v,dut_deg,\
    ref_h2,ref_h3,ref_h4,ref_h5,ref_h2_deg,ref_h3_deg,ref_h4_deg,ref_h5_deg,\
    dut_h2,dut_h3,dut_h4,dut_h5,dut_h2_deg,dut_h3_deg,dut_h4_deg,dut_h5_deg,\
    ref_dc_v,dut_dc_v,ref_noise_v,dut_noise_v,\
    u_ratio,u_phase_deg,u_drive,u_current,u_harmonic,u_dc_v";
const RATIO: &str = "ratio,dut_deg,u_ratio,u_phase_deg";

/// `points.csv` of a rig: all columns, or those of a certificate. Rows that would be too
/// distorted are left out.
pub(crate) fn points(
    truth: &Truth,
    design: &[Condition],
    quality: &Quality,
    all_columns: bool,
    random: &mut Random,
) -> String {
    let stated = &mut Deviates::new(Scatter::AsStated, design.len(), random);
    scattered(truth, design, quality, all_columns, stated, random)
}

/// As [`points`], with scatter that may not be the stated one.
pub(crate) fn scattered(
    truth: &Truth,
    design: &[Condition],
    quality: &Quality,
    all_columns: bool,
    deviates: &mut Deviates,
    random: &mut Random,
) -> String {
    let columns = if all_columns { ALL } else { RATIO };
    let mut csv = format!("{CONDITIONS},{columns}\n");
    let runs = design.iter().map(|row| row.run).max().unwrap_or(0) + 1;
    let gains: Vec<[f64; 2]> = (0..runs)
        .map(|_| [random.gain(U_MOUNTING), random.gain(U_MOUNTING)])
        .collect();
    let mut number = 0;
    for row in design {
        let Some(steady) = steady(truth, row, gains[row.run]) else {
            continue;
        };
        let mut deviate = |value: usize, random: &mut Random| deviates.of(number, value, random);
        let values = values(
            truth,
            row,
            &steady,
            quality,
            all_columns,
            &mut deviate,
            random,
        );
        let text: Vec<String> = values.iter().map(f64::to_string).collect();
        let _ = writeln!(csv, "{},{}", conditions(row), text.join(","));
        number += 1;
    }
    csv
}

fn conditions(row: &Condition) -> String {
    format!(
        "{},r{},{},{},{},{},{}",
        row.frequency_hz,
        row.run,
        row.time_s,
        row.temperature_c,
        row.rotation_deg,
        row.tilt_deg,
        row.payload_kg
    )
}

/// Deviate of a value of the row, by its number.
type Deviate<'a> = dyn FnMut(usize, &mut Random) -> f64 + 'a;

/// Measured values of a row, in the order of the columns.
fn values(
    truth: &Truth,
    row: &Condition,
    steady: &Steady,
    quality: &Quality,
    all_columns: bool,
    deviate: &mut Deviate<'_>,
    random: &mut Random,
) -> Vec<f64> {
    let q = quality;
    let seen = disturbed(truth, row, steady, random);
    let ratio = seen.ratio.norm() * (1.0 + q.u_ratio * deviate(0, random));
    let phase_deg = seen.ratio.arg().to_degrees() + q.u_phase_deg * deviate(1, random);
    if !all_columns {
        return vec![ratio, phase_deg, q.u_ratio, q.u_phase_deg];
    }
    let mut deviate = |value: usize| deviate(value, random);
    let ref_v = row.acceleration_rms_ms2 * REFERENCE_V_PER_MS2;
    let drive = polar(seen.drive, q.u_drive, DRIVE, &mut deviate);
    let coil_v = ref_v / drive[0];
    let current = polar(seen.current, q.u_current, CURRENT, &mut deviate);
    let mut values = vec![row.acceleration_rms_ms2];
    values.extend([coil_v, coil_v * current[0], current[1], ref_v, drive[1]]);
    values.extend([ratio * ref_v, phase_deg]);
    for (orders, first) in [
        (&steady.reference_v, REF_HARMONICS),
        (&steady.dut_v, DUT_HARMONICS),
    ] {
        values.extend(harmonics(orders, q.u_harmonic, first, &mut deviate));
    }
    for (orders, value) in [(&steady.reference_v, MEANS), (&steady.dut_v, MEANS + 1)] {
        values.push(orders[0].re + q.u_dc_v * deviate(value));
    }
    values.extend(seen.noise_rms_v.map(|v| v * random.gain(0.01)));
    values.extend([q.u_ratio, q.u_phase_deg, q.u_drive]);
    values.extend([q.u_current, q.u_harmonic, q.u_dc_v]);
    values
}

/// Magnitude and phase in degrees, both with noise.
fn polar(value: C, u: f64, first: usize, deviate: &mut dyn FnMut(usize) -> f64) -> [f64; 2] {
    let magnitude = value.norm() * (1.0 + u * deviate(first));
    [
        magnitude,
        (value.arg() + u * deviate(first + 1)).to_degrees(),
    ]
}

/// Magnitudes, then phases in degrees, of orders 2..=5.
fn harmonics(
    orders: &[C],
    u: f64,
    first: usize,
    deviate: &mut dyn FnMut(usize) -> f64,
) -> Vec<f64> {
    let noisy: Vec<C> = (2..=ORDERS)
        .map(|n| {
            let at = first + 2 * (n - 2);
            let (re, im) = (deviate(at), deviate(at + 1));
            relative(orders, n) + C::new(u * re, u * im)
        })
        .collect();
    let magnitudes = noisy.iter().map(|z| z.norm());
    let phases_deg = noisy.iter().map(|z| z.arg().to_degrees());
    magnitudes.chain(phases_deg).collect()
}

/// `rig.toml`: what everybody believes.
pub(crate) fn rig() -> String {
    let mut rig = String::from(BEGINNING);
    for (name, value, u) in NOMINAL {
        let _ = writeln!(rig, "{name} = {{ value = {value}, u = {u} }}");
    }
    rig + END
}

const BEGINNING: &str = r#"kind = "calibrator"
measurand = "dut_sensitivity"
[reference]
sensitivity_v_per_ms2 = { value = 0.0102, u = 0.00003 }
[dut]
sensitivity_v_per_ms2 = { value = 0.01, u = 0.0005 }
[exciter]
"#;

const END: &str = "[repeatability]
reference_gain = 0.0002
dut_gain = 0.0002
[digitiser]
sample_rate_hz = 51200.0
block_samples = 16384
full_scale_v = 5.0
bits = 16
noise_v = { value = 4e-5, u = 4e-7 }
[environment]
reference_temperature_c = 23.0
mains_hz = 50.0
";
