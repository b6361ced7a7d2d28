//! Every linear effect of the channels against its formula, as it stands in the description of the
//! effect: r in the ratio of the channels, d in the reference's signal over the coil voltage.

use super::*;

const J: Complex<f64> = Complex::new(0.0, 1.0);
const ONE: Complex<f64> = Complex::new(1.0, 0.0);
const PAYLOAD_KG: f64 = 0.08;
const ROTATION_RAD: f64 = 0.7;

/// An effect as on the command line, its r and its d.
type Shape = (&'static str, Complex<f64>, Complex<f64>);

/// 1000 s into a session, 5 K warmer than usual.
fn conditions() -> Conditions {
    Conditions {
        time_s: 1000.0,
        warmer_k: 5.0,
        rotation_rad: ROTATION_RAD,
        tilt_rad: 0.0,
        payload_kg: PAYLOAD_KG,
        mains_hz: 50.0,
    }
}

fn resonance(f: f64, resonance_hz: f64, quality: f64) -> Complex<f64> {
    let relative = f / resonance_hz;
    1.0 / (1.0 - relative * relative + J * relative / quality)
}

fn real(value: f64) -> Complex<f64> {
    Complex::new(value, 0.0)
}

/// An effect of the device under test alone.
fn of_dut(text: &'static str, r: Complex<f64>) -> Shape {
    (text, r, ONE)
}

/// An effect of the reference alone: what it reads too much, the ratio has too little.
fn of_reference(text: &'static str, d: Complex<f64>) -> Shape {
    (text, 1.0 / d, d)
}

/// Motion that the reference does not see.
fn motion(f: f64) -> Vec<Shape> {
    let mounted_hz = (2e9 / PAYLOAD_KG).sqrt() / TAU;
    let rocking = resonance(f, 2500.0, 12.0);
    let across = (0.004 + 0.01 * rocking) * (ROTATION_RAD - 0.5).cos();
    let q = f / 8000.0;
    let mode = 1.0 + 0.3 * q * q / (1.0 - q * q + 2.0 * J * 0.02 * q);
    vec![
        of_dut(
            "mount_compliance=stiffness_n_per_m:2e9,quality:20",
            resonance(f, mounted_hz, 20.0),
        ),
        of_dut(
            "relative_motion=kappa_per_kg_hz2:5e-9",
            real(1.0 - 5e-9 * PAYLOAD_KG * f * f),
        ),
        of_dut(
            "transverse_motion=t0:0.004,beta_rad:0.5,t1:0.01,rocking_hz:2500,quality:12",
            1.0 + across,
        ),
        of_dut(
            "base_strain=strain:0.01,corner_hz:30",
            real(1.0 + 0.02 / (1.0 + (f / 30.0).powi(2))),
        ),
        of_dut(
            "gravity_tilt=tilt_hz2:0.5",
            real(1.0 + 0.5 * ROTATION_RAD.cos() / (f * f)),
        ),
        // Of the exciter: both channels follow.
        ("armature_mode=kappa:0.3,mode_hz:8000,zeta:0.02", ONE, mode),
    ]
}

/// Signals of the transducers for a motion.
fn transducers(f: f64) -> Vec<Shape> {
    vec![
        of_dut(
            "dut_resonance=resonance_hz:30e3,quality:25",
            resonance(f, 30e3, 25.0),
        ),
        of_reference(
            "reference_resonance=resonance_hz:30e3,quality:25",
            resonance(f, 30e3, 25.0),
        ),
        of_dut(
            "dut_frequency_slope=slope_per_decade:0.02",
            real(1.0 - 0.02 * (f / 160.0).log10()),
        ),
        of_dut("dut_temperature=alpha_per_k:1e-3", real(1.005)),
        of_reference("reference_temperature=alpha_per_k:1e-3", real(1.005)),
        of_dut("dut_drift=drift_per_s:2e-6", real(1.002)),
        of_reference("reference_drift=drift_per_s:2e-6", real(0.998)),
        // At 2 m/s2.
        of_dut("dut_level_nonlinearity=gamma_per_ms2:1e-3", real(1.002)),
    ]
}

/// Signal after conditioners, converters and the evaluation.
fn electronics(f: f64) -> Vec<Shape> {
    let high = J * f / 0.8 / (1.0 + J * f / 0.8);
    let window = PI * f * 1e-5;
    vec![
        of_dut("dut_gain=gain:0.01", real(1.01)),
        of_reference("reference_gain=gain:0.01", real(1.01)),
        of_dut("dut_highpass=corner_hz:0.8", high),
        of_reference("reference_highpass=corner_hz:0.8", high),
        of_dut("dut_lowpass_1=corner_hz:80e3", 1.0 / (1.0 + J * f / 80e3)),
        of_dut(
            "dut_lowpass_2=corner_hz:50e3,quality:0.7",
            resonance(f, 50e3, 0.7),
        ),
        of_dut(
            "averaging_window=duration_s:1e-5",
            window.sin() / window * (-J * window).exp(),
        ),
        of_dut("crosstalk=inverse_fx_s:5e-7", 1.0 + J * f * 5e-7),
        of_dut("channel_skew=tau_s:1e-6", (-J * TAU * f * 1e-6).exp()),
        of_dut("clock_offset=delta:5e-11", (-J * TAU * f * 5e-8).exp()),
        // Both channels lose as much.
        (
            "sampling_jitter=sigma_s:3e-8",
            ONE,
            real((-0.5 * (TAU * f * 3e-8).powi(2)).exp()),
        ),
    ]
}

#[test]
fn every_linear_effect_of_the_channels_has_its_shape() {
    for f in [10.0, 160.0, 8000.0] {
        let plain = hold(&[], &conditions(), f, 2.0);
        for (text, r, d) in [motion(f), transducers(f), electronics(f)].concat() {
            let state = hold(&[text], &conditions(), f, 2.0);
            let ratio = state.dut.harmonics_v[0] / state.reference.harmonics_v[0];
            let drive = |state: &SteadyState| state.reference.harmonics_v[0] / state.coil_v;
            // Exact but for the level, which is held to 1e-4 of itself.
            assert!((ratio / r - 1.0).norm() < 1e-6, "{text} {f}: {ratio} {r}");
            let changed = drive(&state) / drive(&plain);
            assert!((changed / d - 1.0).norm() < 1e-9, "{text} {f}: {changed}");
        }
    }
}

/// Held at what the reference shows: A (1 + gamma A) = 2, so 1 + gamma A = (1 + sqrt(1 + 8 gamma)) / 2.
#[test]
fn a_reference_whose_gain_follows_the_level_moves_ratio_and_drive_alike() {
    let plain = hold(&[], &conditions(), 160.0, 2.0);
    let text = "reference_level_nonlinearity=gamma_per_ms2:1e-3";
    let state = hold(&[text], &conditions(), 160.0, 2.0);
    let ratio = state.dut.harmonics_v[0] / state.reference.harmonics_v[0];
    let drive = |state: &SteadyState| state.reference.harmonics_v[0] / state.coil_v;
    let changed = drive(&state) / drive(&plain);
    assert!((ratio * changed - 1.0).norm() < 1e-9, "{ratio} {changed}");
    // But for the level, which is held to 1e-4 of itself.
    let expected = (1.0 + 1.008_f64.sqrt()) / 2.0;
    assert!((changed - expected).norm() < 1e-6, "{changed}");
}
