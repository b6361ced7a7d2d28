//! Random effects of random size.

use super::random::Random;
use super::truth::Truth;

/// How a parameter is drawn.
enum Law {
    Between(f64, f64),
    /// Uniform in the logarithm.
    Log(f64, f64),
    /// Uniform in the logarithm, with either sign.
    Either(f64, f64),
    Sign,
}
use Law::{Between, Either, Log, Sign};

impl Law {
    fn draw(&self, random: &mut Random) -> f64 {
        match *self {
            Between(low, high) => random.between(low, high),
            Log(low, high) => random.log_between(low, high),
            Either(low, high) => random.log_between(low, high) * random.sign(),
            Sign => random.sign(),
        }
    }
}

/// A parameter, or one of two: of the reference's or the device's channel.
enum Key {
    One(&'static str),
    Channel([&'static str; 2]),
}
use Key::{Channel, One};

/// An effect and its parameters, in the order drawn.
type Case = (&'static str, &'static [(Key, Law)]);

const CASES: [Case; 42] = [
    (
        "dut_resonance",
        &[
            (One("dut_resonance.f"), Log(12e3, 60e3)),
            (One("dut_resonance.q"), Log(4.0, 60.0)),
        ],
    ),
    (
        "reference_resonance",
        &[
            (One("reference_resonance.f"), Log(12e3, 60e3)),
            (One("reference_resonance.q"), Log(4.0, 60.0)),
        ],
    ),
    (
        "mount_compliance",
        &[
            (One("mount_compliance.k"), Log(4e8, 4e9)),
            (One("mount_compliance.q"), Log(5.0, 50.0)),
        ],
    ),
    (
        "relative_motion",
        &[(One("relative_motion.k"), Log(5e-10, 2e-8))],
    ),
    (
        "transverse_motion",
        &[
            (One("transverse_motion.t0"), Either(0.001, 0.02)),
            (One("transverse_motion.t1"), Log(0.001, 0.02)),
            (One("transverse_motion.f"), Log(300.0, 5000.0)),
            (One("transverse_motion.q"), Log(4.0, 30.0)),
            (
                One("transverse_motion.beta"),
                Between(0.0, std::f64::consts::TAU),
            ),
        ],
    ),
    (
        "base_strain",
        &[
            (One("base_strain.s"), Either(0.001, 0.02)),
            (One("base_strain.f1"), Log(10.0, 100.0)),
        ],
    ),
    (
        "gravity_tilt",
        &[(One("gravity_tilt.g"), Either(0.05, 1.0))],
    ),
    (
        "loose_mount",
        &[
            (One("loose_mount.t"), Between(5.886, 29.43)),
            (One("loose_mount.side"), Sign),
            (One("loose_mount.noise"), Log(1e-4, 1e-2)),
        ],
    ),
    (
        "dut_frequency_slope",
        &[(One("dut_frequency_slope.s"), Log(0.002, 0.03))],
    ),
    (
        "dut_level_nonlinearity",
        &[(One("dut_level_nonlinearity.g"), Log(5e-5, 1e-3))],
    ),
    (
        "dut_temperature",
        &[(One("dut_temperature.a"), Either(2e-4, 3e-3))],
    ),
    (
        "reference_temperature",
        &[(One("reference_temperature.a"), Either(2e-4, 3e-3))],
    ),
    (
        "reference_drift",
        &[(One("reference_drift.b"), Either(3e-7, 5e-6))],
    ),
    ("dut_drift", &[(One("dut_drift.b"), Either(3e-7, 5e-6))]),
    ("dut_highpass", &[(One("dut_highpass.f"), Log(0.02, 2.0))]),
    (
        "reference_highpass",
        &[(One("reference_highpass.f"), Log(0.02, 2.0))],
    ),
    ("dut_lowpass_1", &[(One("dut_lowpass_1.f"), Log(2e4, 1e6))]),
    (
        "dut_lowpass_2",
        &[
            (One("dut_lowpass_2.f"), Log(2e4, 2e5)),
            (One("dut_lowpass_2.q"), Between(0.5, 1.0)),
        ],
    ),
    (
        "averaging_window",
        &[(One("averaging_window.t"), Log(3e-6, 6e-5))],
    ),
    ("crosstalk", &[(One("crosstalk.c"), Log(3e-6, 3e-5))]),
    ("mains_pickup", &[(One("mains_pickup.v"), Log(2e-5, 2e-3))]),
    (
        "channel_skew",
        &[(One("channel_skew.t"), Either(2e-7, 1e-5))],
    ),
    (
        "sampling_jitter",
        &[(One("sampling_jitter.s"), Log(5e-9, 5e-7))],
    ),
    (
        "clock_offset",
        &[(One("clock_offset.d"), Either(2e-11, 1e-9))],
    ),
    (
        "adc_cubic",
        &[(
            Channel(["adc_cubic.ref", "adc_cubic.dut"]),
            Either(1e-3, 3e-2),
        )],
    ),
    (
        "adc_quadratic",
        &[(
            Channel(["adc_quadratic.ref", "adc_quadratic.dut"]),
            Either(5e-4, 3e-2),
        )],
    ),
    (
        "adc_dead_zone",
        &[(
            Channel(["adc_dead_zone.ref", "adc_dead_zone.dut"]),
            Log(1e-5, 3e-4),
        )],
    ),
    (
        "adc_clipping",
        &[(
            Channel(["adc_clipping.ref", "adc_clipping.dut"]),
            Between(0.72, 0.85),
        )],
    ),
    (
        "suspension_cubic",
        &[(One("suspension_cubic.k"), Log(5e6, 2e9))],
    ),
    (
        "suspension_asymmetry",
        &[(One("suspension_asymmetry.k"), Either(5e3, 1e6))],
    ),
    (
        "force_factor_droop",
        &[(One("force_factor_droop.b"), Log(1e3, 8e4))],
    ),
    (
        "coulomb_friction",
        &[(One("coulomb_friction.f"), Log(1e-4, 1e-2))],
    ),
    (
        "mechanical_damping",
        &[(One("mechanical_damping.c"), Log(4.0, 15.0))],
    ),
    ("back_emf", &[(One("back_emf.b"), Either(0.05, 0.5))]),
    (
        "lossy_inductance",
        &[(One("lossy_inductance.n"), Between(0.5, 0.9))],
    ),
    (
        "coil_heating",
        &[
            (One("coil_heating.dt"), Log(5.0, 60.0)),
            (One("coil_heating.tau"), Log(200.0, 3000.0)),
        ],
    ),
    (
        "armature_mode",
        &[
            (One("armature_mode.k"), Log(0.01, 0.4)),
            (One("armature_mode.f"), Log(2e3, 1.5e4)),
            (One("armature_mode.z"), Log(0.01, 0.05)),
        ],
    ),
    ("payload_mass", &[(One("payload_mass.m"), Log(0.003, 0.02))]),
    (
        "amplifier_clipping",
        &[(One("amplifier_clipping.v"), Log(6.6, 7.9))],
    ),
    (
        "amplifier_even_order",
        &[(One("amplifier_even_order.b"), Log(1e-5, 3e-3))],
    ),
    (
        "amplifier_gain_drift",
        &[(One("amplifier_gain_drift.b"), Either(1e-6, 1e-5))],
    ),
    (
        "ambient_vibration",
        &[
            (One("ambient_vibration.a"), Log(2e-3, 0.05)),
            (One("ambient_vibration.tone"), Log(1e-3, 0.05)),
            (One("ambient_vibration.f"), Between(4.0, 30.0)),
        ],
    ),
];

/// Effects that came later, in a list of their own: the cases of before stay what they were.
const LATER: [Case; 18] = [
    (
        "dut_highpass_2",
        &[
            (One("dut_highpass_2.f"), Log(0.1, 3.0)),
            (One("dut_highpass_2.q"), Log(0.55, 2.5)),
        ],
    ),
    (
        "reference_highpass_2",
        &[
            (One("reference_highpass_2.f"), Log(0.1, 3.0)),
            (One("reference_highpass_2.q"), Log(0.55, 2.5)),
        ],
    ),
    (
        "dut_lowpass_4",
        &[
            (One("dut_lowpass_4.f"), Log(1.1e4, 5.5e4)),
            (One("dut_lowpass_4.bessel"), Sign),
        ],
    ),
    ("sinc2_filter", &[(One("sinc2_filter.t"), Log(8e-6, 6e-5))]),
    (
        "dut_power_law",
        &[(One("dut_power_law.n"), Log(0.001, 0.02))],
    ),
    (
        "rotation_twice",
        &[
            (One("rotation_twice.s"), Log(5e-4, 0.01)),
            (One("rotation_twice.beta"), Between(0.0, 3.1)),
        ],
    ),
    (
        "nominal_stiffness",
        &[(One("nominal_stiffness.x"), Either(0.3, 0.5))],
    ),
    (
        "nominal_force_factor",
        &[(One("nominal_force_factor.x"), Either(0.17, 0.4))],
    ),
    (
        "nominal_resistance",
        &[(One("nominal_resistance.x"), Either(0.08, 0.3))],
    ),
    (
        "nominal_inductance",
        &[(One("nominal_inductance.x"), Either(0.5, 0.8))],
    ),
    (
        "shorted_inductance",
        &[
            (One("shorted_inductance.s"), Between(0.2, 0.9)),
            (One("shorted_inductance.f"), Log(500.0, 2e4)),
        ],
    ),
    (
        "dut_warm_up",
        &[
            (One("dut_warm_up.g"), Either(1e-3, 1e-2)),
            (One("dut_warm_up.tau"), Log(100.0, 2000.0)),
        ],
    ),
    (
        "reference_warm_up",
        &[
            (One("reference_warm_up.g"), Either(1e-3, 1e-2)),
            (One("reference_warm_up.tau"), Log(100.0, 2000.0)),
        ],
    ),
    (
        "range_step",
        &[
            (
                Channel(["range_step.ref", "range_step.dut"]),
                Either(5e-4, 1e-2),
            ),
            (One("range_step.v"), Log(0.02, 0.7)),
        ],
    ),
    (
        "amplifier_soft_clipping",
        &[(One("amplifier_soft_clipping.v"), Log(10.0, 200.0))],
    ),
    (
        "body_mode",
        &[
            (One("body_mode.m"), Log(5.0, 20.0)),
            (One("body_mode.f"), Log(2.0, 200.0)),
            (One("body_mode.q"), Log(2.0, 15.0)),
        ],
    ),
    (
        "suspension_creep",
        &[(One("suspension_creep.l"), Log(0.01, 0.2))],
    ),
    (
        "adc_soft_clipping",
        &[(
            Channel(["adc_soft_clipping.ref", "adc_soft_clipping.dut"]),
            Log(0.8, 3.0),
        )],
    ),
];

/// Names of all effects that can be drawn, but the later ones.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    CASES.iter().map(|(name, _)| *name)
}

/// Names of the later ones.
pub(crate) fn later_names() -> impl Iterator<Item = &'static str> {
    LATER.iter().map(|(name, _)| *name)
}

/// Whether an effect sits in one channel or the other.
pub(crate) fn is_of_one_channel(name: &str) -> bool {
    let (_, parameters) = case(name);
    parameters.iter().any(|(key, _)| matches!(key, Channel(_)))
}

fn case(name: &str) -> Case {
    let mut all = CASES.iter().chain(&LATER);
    let found = all.find(|(effect, _)| *effect == name);
    *found.expect("a name of the list")
}

/// Adds an effect of a visible size.
pub(crate) fn add(truth: &mut Truth, name: &str, random: &mut Random) {
    let channel = usize::from(random.uniform() >= 0.5);
    let (_, parameters) = case(name);
    for (key, law) in parameters {
        let key = match key {
            One(key) => key,
            Channel(keys) => keys[channel],
        };
        truth.effects.insert(key, law.draw(random));
    }
    // Half of the devices that are nonlinear in the level show a second harmonic as well.
    if let (Some(g), true) = (truth.get("dut_level_nonlinearity.g"), channel == 0)
        && name == "dut_level_nonlinearity"
    {
        let share = random.between(0.2, 0.6);
        truth.effects.insert("dut_level_nonlinearity.h2", g * share);
    }
}
/// Makes the effects smaller by a factor: amplitudes shrink, corners and modes move away.
pub(crate) fn shrink(truth: &mut Truth, factor: f64) {
    for (key, value) in &mut truth.effects {
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
