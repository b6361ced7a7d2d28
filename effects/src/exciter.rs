//! Moving coil and suspension. Sizes are those of exciters of 10 to 100 N of force.

use super::{Entry, Parameter, Stage};

pub(crate) static ENTRIES: &[&Entry] = &[
    &SUSPENSION_CUBIC,
    &SUSPENSION_ASYMMETRY,
    &SUSPENSION_CREEP,
    &FORCE_FACTOR_DROOP,
    &COULOMB_FRICTION,
    &MECHANICAL_DAMPING,
    &BACK_EMF,
    &PAYLOAD_MASS,
    &LOSSY_INDUCTANCE,
    &SHORTED_INDUCTANCE,
    &COIL_HEATING,
    &ARMATURE_MODE,
    &BODY_MODE,
    &NOMINAL_STIFFNESS,
    &NOMINAL_FORCE_FACTOR,
    &NOMINAL_RESISTANCE,
    &NOMINAL_INDUCTANCE,
];

/// How far a nominal value is off, relative.
const OFFSET: Parameter = Parameter::linear("offset_rel", "1", [-0.9, 9.0], 0.3);
/// Where a wrong nominal value of the exciter shows.
const NOMINAL_COLUMNS: &[&str] = &["frequency_hz", "ref_v", "coil_v", "coil_a"];

const BENT_COLUMNS: &[&str] = &[
    "acceleration_ms2",
    "ref_v",
    "coil_v",
    "ref_h3",
    "dut_h3",
    "coil_a",
];

/// Real flexures stiffen symmetrically at large travel: the resonance moves with level and a third
/// harmonic appears in the motion itself, so in both channels. 2e9 doubles 8 kN/m at 2 mm. A spring that
/// was not levelled sags under the weight on it and is no longer alike to both sides.
pub static SUSPENSION_CUBIC: Entry = Entry {
    id: "suspension_cubic",
    stage: Stage::Exciter,
    formula: "restoring force k1 x + k3 x^3 about the unloaded position, sag -s M g cos(tilt)/k1: d near f0, H3 as X^2, H2 with the sag, in both channels",
    parameters: &[
        Parameter::linear("k3_n_per_m3", "N/m3", [-1e14, 1e14], 3e7).on_site(3e6, 2e9),
        // Of the weight, what no levelling takes off the spring.
        Parameter::linear("sag_share", "1", [-3.0, 3.0], 0.0)
            .simulated(0.0, 2.0)
            .on_site(0.0, 1.0),
    ],
    plain: "the spring that carries the table stiffens as it is deflected",
    columns: BENT_COLUMNS,
    confused_with: &["force_factor_droop", "coulomb_friction"],
    separate_by: "large travel at low frequency, with coil current and harmonics",
    ..Entry::CALIBRATOR
};

/// A quadratic term about the unloaded position. The weight of armature and payload shifts the
/// working point, so tilt and payload change stiffness, resonance and second harmonic. 1e6 changes
/// 8 kN/m by an eighth per millimetre.
pub static SUSPENSION_ASYMMETRY: Entry = Entry {
    id: "suspension_asymmetry",
    stage: Stage::Exciter,
    formula: "restoring force k1 x + k2 x^2 about the unloaded position, sag -M g cos(tilt)/k1: H2, f0 moves with tilt and payload",
    parameters: &[Parameter::linear("k2_n_per_m2", "N/m2", [-1e10, 1e10], 3e5).on_site(-1e6, 1e6)],
    plain: "the spring that carries the table is stiffer to one side",
    columns: &[
        "acceleration_ms2",
        "tilt_deg",
        "payload_kg",
        "ref_v",
        "coil_v",
        "ref_h2",
        "dut_h2",
    ],
    confused_with: &["amplifier_even_order"],
    separate_by: "another tilt and payload near the suspension resonance, with harmonics",
    ..Entry::CALIBRATOR
};

/// Rubber, adhesive and impregnated cloth give way for longer than a period: the compliance grows by a
/// share per decade of time, and a share of the energy is lost at all frequencies. Suspensions of
/// loudspeakers have 0.05 to 0.3 (Knudsen and Jensen, J. Audio Eng. Soc. 41, 1993), flexures of metal a
/// hundredth of that. It grows no more below 1 mHz.
pub static SUSPENSION_CREEP: Entry = Entry {
    id: "suspension_creep",
    stage: Stage::Exciter,
    formula: "stiffness k/(1 - l lg(j f/50 Hz)): d below f0 falls by l per decade, with a loss angle of 0.68 l",
    parameters: &[Parameter::linear("creep_per_decade", "1", [0.0, 0.3], 0.05).on_site(0.0, 0.25)],
    plain: "the spring that carries the table gives way slowly, as rubber does",
    columns: &[
        "frequency_hz",
        "ref_v",
        "ref_deg",
        "coil_v",
        "coil_a",
        "coil_a_deg",
    ],
    confused_with: &["nominal_stiffness", "mechanical_damping", "body_mode"],
    separate_by: "points from the lowest frequencies up to the suspension resonance, with coil current and phases",
    ..Entry::CALIBRATOR
};

/// The coil leaves the gap: less force per ampere and less induced voltage at large travel. 1e5 is
/// 10 % at 1 mm.
pub static FORCE_FACTOR_DROOP: Entry = Entry {
    id: "force_factor_droop",
    stage: Stage::Exciter,
    formula: "Bl(x) = Bl0 (1 - b2 x^2): force and back-EMF fall with travel",
    parameters: &[Parameter::linear("b2_per_m2", "1/m2", [0.0, 1e9], 2e4).on_site(0.0, 1e5)],
    plain: "the motor loses force as the coil leaves the magnet's gap",
    columns: BENT_COLUMNS,
    confused_with: &["suspension_cubic"],
    separate_by: "large travel at low frequency, with coil current",
    ..Entry::CALIBRATOR
};

/// A constant force against the motion, such as a coil that rubs or a cable that drags; where the
/// drive is too weak to break it, the armature sticks.
pub static COULOMB_FRICTION: Entry = Entry {
    id: "coulomb_friction",
    stage: Stage::Exciter,
    formula: "force Fc against the motion, 4 Fc/(pi F): odd harmonics in both channels, as 1/A",
    parameters: &[Parameter::linear("friction_n", "N", [0.0, 100.0], 0.02).on_site(2e-3, 0.2)],
    plain: "something rubs against the moving part",
    columns: BENT_COLUMNS,
    confused_with: &["mechanical_damping", "suspension_cubic"],
    separate_by: "the smallest levels at low frequency, with harmonics",
    ..Entry::CALIBRATOR
};

/// Viscous damping beside the nominal one. Rubber and grease change it by a factor of a few with
/// temperature and age.
pub static MECHANICAL_DAMPING: Entry = Entry {
    id: "mechanical_damping",
    stage: Stage::Exciter,
    formula: "added force dc x velocity: 2 zeta q near f0",
    parameters: &[
        Parameter::linear("added_damping_ns_per_m", "N s/m", [-1e3, 1e4], 3.0).on_site(-2.0, 15.0),
    ],
    plain: "the table is damped differently from what is stated",
    columns: &["frequency_hz", "ref_v", "coil_v", "coil_a"],
    confused_with: &["back_emf", "coulomb_friction"],
    separate_by: "coil current near the suspension resonance",
    ..Entry::CALIBRATOR
};

/// Induced voltage other than force factor times velocity: a shorted turn or eddy currents in the
/// gap make the transducer not reciprocal.
pub static BACK_EMF: Entry = Entry {
    id: "back_emf",
    stage: Stage::Exciter,
    formula: "induced voltage (1 + beta) Bl x velocity: damping Bl^2/Z differs from nominal",
    parameters: &[Parameter::linear("beta", "1", [-0.95, 10.0], 0.15).on_site(-0.5, 0.5)],
    plain: "the voltage induced in the coil differs from what is stated",
    columns: &["frequency_hz", "ref_v", "coil_v", "coil_a"],
    confused_with: &["mechanical_damping"],
    separate_by: "coil current near the suspension resonance",
    ..Entry::CALIBRATOR
};

/// A payload that was not weighed, a cable, an adapter.
pub static PAYLOAD_MASS: Entry = Entry {
    id: "payload_mass",
    stage: Stage::Exciter,
    formula: "M -> M + dm in d: f0 and high frequencies",
    parameters: &[
        Parameter::linear("added_mass_kg", "kg", [-10.0, 100.0], 0.005).on_site(-0.02, 0.05),
    ],
    plain: "the mass on the table differs from what is stated",
    columns: &["frequency_hz", "ref_v", "coil_v"],
    confused_with: &["reference_drift"],
    separate_by: "a weighed payload; coil current near the suspension resonance",
    ..Entry::CALIBRATOR
};

/// Eddy currents in the pole make the impedance grow slower than the frequency, with a loss angle.
/// Solid poles measure 0.5 to 0.7, laminated ones 0.9.
pub static LOSSY_INDUCTANCE: Entry = Entry {
    id: "lossy_inductance",
    stage: Stage::Exciter,
    formula: "Z = R + j^n w0 L (w/w0)^n, w0 = 2 pi 1 kHz, n 0.5..0.9 (1 = ideal)",
    parameters: &[Parameter::linear("exponent", "1", [0.3, 1.0], 0.7).on_site(0.5, 1.0)],
    plain: "the coil loses energy in the iron around it",
    columns: &["frequency_hz", "coil_v", "coil_a", "coil_a_deg", "ref_v"],
    confused_with: &["armature_mode", "shorted_inductance"],
    separate_by: "coil current at the highest frequencies",
    ..Entry::CALIBRATOR
};

/// A coil of two inductances, one of them with a resistance across it (LR-2): a shorting ring, or eddy
/// currents that all flow in one path, undo a share of the inductance above the corner R2/(2 pi L2).
/// Rings of copper and poles of iron have corners of some 100 Hz to 20 kHz.
pub static SHORTED_INDUCTANCE: Entry = Entry {
    id: "shorted_inductance",
    stage: Stage::Exciter,
    formula: "Z = R + j w L (1 - s + s/(1 + j f/fc)), s = L2/L, fc = R2/(2 pi L2)",
    parameters: &[
        Parameter::linear("shorted_share", "1", [0.0, 0.98], 0.5).on_site(0.1, 0.9),
        Parameter::log("corner_hz", "Hz", [10.0, 1e6], 3e3).on_site(300.0, 2e4),
    ],
    plain: "a ring, or the iron around the coil, shorts part of its inductance",
    columns: &["frequency_hz", "coil_v", "coil_a", "coil_a_deg", "ref_v"],
    confused_with: &["lossy_inductance", "nominal_inductance", "armature_mode"],
    separate_by: "coil current from a decade below the corner to the highest frequencies",
    ..Entry::CALIBRATOR
};

/// The resistance of copper rises by 0.39 % per kelvin while the coil approaches its final
/// temperature. A coil may warm up by 100 K; its former and the magnet take minutes to an hour.
pub static COIL_HEATING: Entry = Entry {
    id: "coil_heating",
    stage: Stage::Exciter,
    formula: "R (1 + 0.0039 dT (1 - exp(-t/tau)))",
    parameters: &[
        Parameter::linear("rise_k", "K", [0.0, 300.0], 15.0).on_site(0.0, 100.0),
        Parameter::log("time_constant_s", "s", [1.0, 1e5], 900.0).on_site(60.0, 4e3),
    ],
    plain: "the coil warms up as it works",
    columns: &["time_s", "coil_v", "coil_a", "ref_v"],
    confused_with: &["amplifier_gain_drift", "reference_drift"],
    separate_by: "coil current over time",
    ..Entry::CALIBRATOR
};

/// Axial mode of the moving element: the table resonates on the coil former and moves more than the
/// driven end near the mode.
pub static ARMATURE_MODE: Entry = Entry {
    id: "armature_mode",
    stage: Stage::Exciter,
    formula: "d and travel of the table x (1 + kappa q^2/(1 - q^2 + 2 j zeta q)), q = f/fa, the same for all payloads",
    parameters: &[
        Parameter::linear("kappa", "1", [-3.0, 3.0], 0.3).on_site(-0.5, 0.5),
        Parameter::log("mode_hz", "Hz", [10.0, 40e3], 8e3).on_site(2e3, 20e3),
        Parameter::log("zeta", "1", [5e-4, 0.7], 0.02).on_site(0.005, 0.1),
    ],
    plain: "the table itself bends at high frequency",
    columns: &["frequency_hz", "ref_v", "coil_v", "ref_deg"],
    confused_with: &["reference_resonance", "lossy_inductance"],
    separate_by: "ratio beside the drive (a reference resonance shows there); points around the mode",
    ..Entry::CALIBRATOR
};

/// The table's force acts back on the body, which has ten to two hundred times its mass and stands on
/// feet of rubber, on springs or on a bench. It gives way most where it resonates on them.
pub static BODY_MODE: Entry = Entry {
    id: "body_mode",
    stage: Stage::Exciter,
    formula: "spring, damping and induced voltage x g, g = 1 - (M/Mb) q^2/(1 - q^2 + j q/Q), q = f/fb: d and z near fb, and above it by M/Mb",
    parameters: &[
        Parameter::log("body_mass_kg", "kg", [0.1, 1e4], 10.0).on_site(2.0, 30.0),
        Parameter::log("isolator_hz", "Hz", [0.2, 1e3], 20.0).on_site(2.0, 200.0),
        Parameter::log("quality", "1", [0.5, 200.0], 5.0).on_site(2.0, 30.0),
    ],
    plain: "the body of the shaker moves on its feet as it drives the table",
    columns: &[
        "frequency_hz",
        "payload_kg",
        "ref_v",
        "ref_deg",
        "coil_v",
        "coil_a",
    ],
    confused_with: &["nominal_stiffness", "back_emf", "mechanical_damping"],
    separate_by: "points closely around the resonance of the feet, with coil current; an accelerometer on the body",
    ..Entry::CALIBRATOR
};

/// Flexures of one type differ by 5 to 10 %; rubber, or another flexure, by more. A value that is off by
/// more than its uncertainty allows is a cause of its own kind: what is stated of the rig is wrong, not
/// the rig.
pub static NOMINAL_STIFFNESS: Entry = Entry {
    id: "nominal_stiffness",
    stage: Stage::Exciter,
    formula: "stiffness k (1 + x) instead of k: f0 by x/2",
    parameters: &[OFFSET.on_site(-0.5, 0.5)],
    plain: "the spring that carries the table is not as stiff as stated",
    columns: NOMINAL_COLUMNS,
    confused_with: &["payload_mass", "suspension_cubic"],
    separate_by: "points around the suspension resonance at a small level, with coil current",
    of_nominal: true,
    ..Entry::CALIBRATOR
};

/// A magnet that was opened, or overheated, loses a tenth and more.
pub static NOMINAL_FORCE_FACTOR: Entry = Entry {
    id: "nominal_force_factor",
    stage: Stage::Exciter,
    formula: "force and induced voltage x (1 + x)",
    parameters: &[OFFSET.on_site(-0.3, 0.3)],
    plain: "the motor of the shaker is not as strong as stated",
    columns: NOMINAL_COLUMNS,
    confused_with: &["back_emf", "nominal_resistance"],
    separate_by: "coil current beside the coil voltage; a force sensor",
    of_nominal: true,
    ..Entry::CALIBRATOR
};

/// A long cable, or a connector that corrodes, is in series with the coil.
pub static NOMINAL_RESISTANCE: Entry = Entry {
    id: "nominal_resistance",
    stage: Stage::Exciter,
    formula: "resistance R (1 + x) instead of R",
    parameters: &[OFFSET.on_site(-0.2, 1.0)],
    plain: "the resistance of the coil is not the stated one",
    columns: NOMINAL_COLUMNS,
    confused_with: &["coil_heating", "nominal_force_factor"],
    separate_by: "the resistance at the terminals with an ohmmeter, the coil cold",
    of_nominal: true,
    ..Entry::CALIBRATOR
};

/// Stated at 1 kHz with the coil in its gap; out of it, or at another frequency, it is another value.
pub static NOMINAL_INDUCTANCE: Entry = Entry {
    id: "nominal_inductance",
    stage: Stage::Exciter,
    formula: "inductance L (1 + x) instead of L",
    parameters: &[OFFSET.on_site(-0.5, 1.0)],
    plain: "the inductance of the coil is not the stated one",
    columns: NOMINAL_COLUMNS,
    confused_with: &["lossy_inductance", "nominal_resistance"],
    separate_by: "coil current at the highest frequencies",
    of_nominal: true,
    ..Entry::CALIBRATOR
};
