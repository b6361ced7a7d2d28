//! Random effects of random size.

use super::random::Random;
use super::rig::Truth;

pub(crate) const NAMES: [&str; 40] = [
    "dut_resonance",
    "reference_resonance",
    "mount_compliance",
    "relative_motion",
    "transverse_motion",
    "base_strain",
    "gravity_tilt",
    "loose_mount",
    "dut_frequency_slope",
    "dut_level_nonlinearity",
    "dut_temperature",
    "reference_temperature",
    "reference_drift",
    "dut_drift",
    "dut_highpass",
    "reference_highpass",
    "dut_lowpass_1",
    "dut_lowpass_2",
    "averaging_window",
    "crosstalk",
    "mains_pickup",
    "channel_skew",
    "sampling_jitter",
    "clock_offset",
    "adc_cubic",
    "adc_quadratic",
    "adc_dead_zone",
    "adc_clipping",
    "suspension_cubic",
    "suspension_asymmetry",
    "force_factor_droop",
    "coulomb_friction",
    "mechanical_damping",
    "back_emf",
    "lossy_inductance",
    "coil_heating",
    "armature_mode",
    "payload_mass",
    "amplifier_clipping",
    "amplifier_even_order",
];
pub(crate) const EXTRA: [&str; 2] = ["amplifier_gain_drift", "ambient_vibration"];

/// Adds an effect of a visible size.
pub(crate) fn add(t: &mut Truth, name: &str, r: &mut Random) {
    let ch = if r.uniform() < 0.5 { 0 } else { 1 };
    let pick = |a: &'static str, b: &'static str| if ch == 0 { a } else { b };
    let mut set = |k: &'static str, v: f64| {
        t.e.insert(k, v);
    };
    match name {
        "dut_resonance" => {
            set("dut_resonance.f", r.log_between(12e3, 60e3));
            set("dut_resonance.q", r.log_between(4.0, 60.0))
        }
        "reference_resonance" => {
            set("reference_resonance.f", r.log_between(12e3, 60e3));
            set("reference_resonance.q", r.log_between(4.0, 60.0))
        }
        "mount_compliance" => {
            set("mount_compliance.k", r.log_between(4e8, 4e9));
            set("mount_compliance.q", r.log_between(5.0, 50.0))
        }
        "relative_motion" => set("relative_motion.k", r.log_between(0.005, 0.2) / (0.1 * 1e8)),
        "transverse_motion" => {
            set(
                "transverse_motion.t0",
                r.log_between(0.001, 0.02) * r.sign(),
            );
            set("transverse_motion.t1", r.log_between(0.001, 0.02));
            set("transverse_motion.f", r.log_between(300.0, 5000.0));
            set("transverse_motion.q", r.log_between(4.0, 30.0));
            set(
                "transverse_motion.beta",
                r.between(0.0, std::f64::consts::TAU),
            )
        }
        "base_strain" => {
            set("base_strain.s", r.log_between(0.001, 0.02) * r.sign());
            set("base_strain.f1", r.log_between(10.0, 100.0))
        }
        "gravity_tilt" => set("gravity_tilt.g", r.log_between(0.05, 1.0) * r.sign()),
        "loose_mount" => {
            set("loose_mount.t", 9.81 * r.between(0.6, 3.0));
            set("loose_mount.side", r.sign());
            set("loose_mount.noise", r.log_between(1e-4, 1e-2))
        }
        "dut_frequency_slope" => set("dut_frequency_slope.s", r.log_between(0.002, 0.03)),
        "dut_level_nonlinearity" => {
            let g = r.log_between(5e-5, 1e-3);
            set("dut_level_nonlinearity.g", g);
            if ch == 0 {
                set("dut_level_nonlinearity.h2", g * r.between(0.2, 0.6))
            }
        }
        "dut_temperature" => set("dut_temperature.a", r.log_between(2e-4, 3e-3) * r.sign()),
        "reference_temperature" => set(
            "reference_temperature.a",
            r.log_between(2e-4, 3e-3) * r.sign(),
        ),
        "reference_drift" => set("reference_drift.b", r.log_between(3e-7, 5e-6) * r.sign()),
        "dut_drift" => set("dut_drift.b", r.log_between(3e-7, 5e-6) * r.sign()),
        "dut_highpass" => set("dut_highpass.f", r.log_between(0.02, 2.0)),
        "reference_highpass" => set("reference_highpass.f", r.log_between(0.02, 2.0)),
        "dut_lowpass_1" => set("dut_lowpass_1.f", r.log_between(2e4, 1e6)),
        "dut_lowpass_2" => {
            set("dut_lowpass_2.f", r.log_between(2e4, 2e5));
            set("dut_lowpass_2.q", r.between(0.5, 1.0))
        }
        "averaging_window" => set("averaging_window.t", r.log_between(3e-6, 6e-5)),
        "crosstalk" => set("crosstalk.c", r.log_between(3e-6, 3e-5)),
        "mains_pickup" => set("mains_pickup.v", r.log_between(2e-5, 2e-3)),
        "channel_skew" => set("channel_skew.t", r.log_between(2e-7, 1e-5) * r.sign()),
        "sampling_jitter" => set("sampling_jitter.s", r.log_between(5e-9, 5e-7)),
        "clock_offset" => set("clock_offset.d", r.log_between(2e-11, 1e-9) * r.sign()),
        "adc_cubic" => set(
            pick("adc_cubic.ref", "adc_cubic.dut"),
            r.log_between(1e-3, 3e-2) * r.sign(),
        ),
        "adc_quadratic" => set(
            pick("adc_quadratic.ref", "adc_quadratic.dut"),
            r.log_between(5e-4, 3e-2) * r.sign(),
        ),
        "adc_dead_zone" => set(
            pick("adc_dead_zone.ref", "adc_dead_zone.dut"),
            r.log_between(1e-5, 3e-4),
        ),
        "adc_clipping" => set(
            pick("adc_clipping.ref", "adc_clipping.dut"),
            r.between(0.72, 0.85),
        ),
        "suspension_cubic" => set("suspension_cubic.k", r.log_between(5e6, 2e9)),
        "suspension_asymmetry" => set("suspension_asymmetry.k", r.log_between(5e3, 1e6) * r.sign()),
        "force_factor_droop" => set("force_factor_droop.b", r.log_between(1e3, 8e4)),
        "coulomb_friction" => set("coulomb_friction.f", r.log_between(1e-4, 1e-2)),
        "mechanical_damping" => set("mechanical_damping.c", r.log_between(4.0, 15.0)),
        "back_emf" => set("back_emf.b", r.log_between(0.05, 0.5) * r.sign()),
        "lossy_inductance" => set("lossy_inductance.n", r.between(0.5, 0.9)),
        "coil_heating" => {
            set("coil_heating.dt", r.log_between(5.0, 60.0));
            set("coil_heating.tau", r.log_between(200.0, 3000.0))
        }
        "armature_mode" => {
            set("armature_mode.k", r.log_between(0.01, 0.4));
            set("armature_mode.f", r.log_between(2e3, 1.5e4));
            set("armature_mode.z", r.log_between(0.01, 0.05))
        }
        "payload_mass" => set("payload_mass.m", r.log_between(0.003, 0.02)),
        "amplifier_clipping" => set("amplifier_clipping.v", r.log_between(6.6, 7.9)),
        "amplifier_even_order" => set("amplifier_even_order.b", r.log_between(1e-5, 3e-3)),
        "amplifier_gain_drift" => set(
            "amplifier_gain_drift.b",
            r.log_between(1e-6, 1e-5) * r.sign(),
        ),
        "ambient_vibration" => {
            set("ambient_vibration.a", r.log_between(2e-3, 0.05));
            set("ambient_vibration.tone", r.log_between(1e-3, 0.05));
            set("ambient_vibration.f", r.between(4.0, 30.0))
        }
        other => panic!("no case for {other}"),
    }
}

/// Makes the effects smaller by a factor: amplitudes shrink, corners and modes move away.
pub(crate) fn shrink(t: &mut Truth, factor: f64) {
    for (key, value) in &mut t.e {
        match *key {
            "dut_resonance.f" | "reference_resonance.f" => *value /= factor.sqrt(),
            "dut_lowpass_1.f" | "dut_lowpass_2.f" | "mount_compliance.k" => *value /= factor,
            "lossy_inductance.n" => *value = 1.0 - (1.0 - *value) * factor,
            "adc_clipping.ref" | "adc_clipping.dut" => *value += 0.15 * (1.0 - factor),
            "amplifier_clipping.v" => *value += 2.0 * (1.0 - factor),
            "loose_mount.t" => *value += 60.0 * (1.0 - factor),
            key if is_shape(key) => {}
            _ => *value *= factor,
        }
    }
}

/// Parameters that say where or how an effect acts, not how much.
fn is_shape(key: &str) -> bool {
    let (_, parameter) = key.split_once('.').unwrap_or((key, ""));
    matches!(parameter, "q" | "beta" | "f1" | "side" | "tau" | "z")
        || matches!(
            key,
            "transverse_motion.f" | "armature_mode.f" | "ambient_vibration.f"
        )
}
