//! Between table and transducers.

use super::{Entry, Parameter, Stage};
use std::f64::consts::PI;

pub(crate) static ENTRIES: &[&Entry] = &[
    &COMPLIANCE,
    &RELATIVE_MOTION,
    &TRANSVERSE_MOTION,
    &ROTATION_TWICE,
    &BASE_STRAIN,
    &GRAVITY_TILT,
    &LOOSE_MOUNT,
];

/// Contact stiffness between table and device: the mounted mass on it is a resonator that a heavier
/// payload lowers. 40 g resonate at 2.5 kHz on a magnet and at 50 kHz on a stud (ISO 5348 compares
/// the mountings).
pub static COMPLIANCE: Entry = Entry {
    id: "mount_compliance",
    stage: Stage::Mount,
    formula: "r = 1/(1 - (f/fm)^2 + j f/(Q fm)), fm = sqrt(km/payload)/2pi",
    parameters: &[
        Parameter::log("stiffness_n_per_m", "N/m", [1e5, 1e12], 2e9).on_site(1.3e9, 1.8e10),
        Parameter::log("quality", "1", [1.5, 1000.0], 20.0).on_site(5.0, 50.0),
    ],
    plain: "the mount gives way like a spring under the device",
    columns: &["frequency_hz", "payload_kg", "ratio", "dut_deg"],
    confused_with: &["dut_resonance", "relative_motion"],
    separate_by: "a second payload at the highest frequencies",
    ..Entry::CALIBRATOR
};

/// The table between the two mounting faces strains under the inertia of the payload. 2e-8 is 8 %
/// at 10 kHz with 40 g.
pub static RELATIVE_MOTION: Entry = Entry {
    id: "relative_motion",
    stage: Stage::Mount,
    formula: "r = 1 - kappa m f^2",
    parameters: &[
        Parameter::linear("kappa_per_kg_hz2", "1/(kg Hz2)", [0.0, 1e-4], 5e-9).on_site(0.0, 2.5e-9),
    ],
    plain: "reference and device do not move quite alike at high frequency",
    columns: &["frequency_hz", "payload_kg", "ratio"],
    confused_with: &["mount_compliance", "dut_lowpass_2", "averaging_window"],
    separate_by: "a second payload; phase at the highest frequencies",
    ..Entry::CALIBRATOR
};

/// Transverse motion seen through transverse sensitivity: at all frequencies by a share and more at
/// a rocking mode; rotating the device changes the sign. 20 % of motion through 10 % of sensitivity
/// give 2 %.
pub static TRANSVERSE_MOTION: Entry = Entry {
    id: "transverse_motion",
    stage: Stage::Mount,
    formula: "r = 1 + (t0 + t1 H(f; fr, Q)) cos(rotation - beta), H a second-order rocking mode",
    parameters: &[
        Parameter::linear("t0", "1", [-0.3, 0.3], 0.004).on_site(-3.5e-3, 3.5e-3),
        Parameter::linear("beta_rad", "rad", [-10.0, 10.0], 0.5).on_site(-PI, PI),
        Parameter::linear("t1", "1", [-0.3, 0.3], 0.01).on_site(-1e-3, 1e-3),
        Parameter::log("rocking_hz", "Hz", [20.0, 60e3], 2500.0).on_site(1200.0, 5000.0),
        Parameter::log("quality", "1", [0.7, 300.0], 12.0).on_site(5.0, 20.0),
    ],
    plain: "the table also moves sideways, and the device feels it",
    columns: &["frequency_hz", "rotation_deg", "ratio"],
    confused_with: &["gravity_tilt"],
    separate_by: "all frequencies with the device turned by 90 degrees at a time",
    ..Entry::CALIBRATOR
};

/// A table that is not round, or a base that is stiffer along one axis than along the other: the
/// device feels it twice a turn, at 0 and 180 degrees alike.
pub static ROTATION_TWICE: Entry = Entry {
    id: "rotation_twice",
    stage: Stage::Mount,
    formula: "r = 1 + s cos(2 (rotation - beta))",
    parameters: &[
        Parameter::linear("share", "1", [-0.3, 0.3], 0.003).on_site(-0.02, 0.02),
        Parameter::linear("beta_rad", "rad", [-10.0, 10.0], 0.5).on_site(-1.6, 1.6),
    ],
    plain: "the mounting surface bends differently along its two axes",
    columns: &["rotation_deg", "ratio"],
    confused_with: &["transverse_motion"],
    separate_by: "the same points with the device turned by 45, 90 and 180 degrees",
    ..Entry::CALIBRATOR
};

/// Strain of the mounting face where the suspension pulls, at low frequency, and the more the
/// heavier the payload (stated for 40 g).
pub static BASE_STRAIN: Entry = Entry {
    id: "base_strain",
    stage: Stage::Mount,
    formula: "r = 1 + s (payload/40 g)/(1 + (f/f1)^2)",
    parameters: &[
        Parameter::linear("strain", "1", [-0.3, 0.3], 0.01).on_site(-1e-3, 1e-3),
        Parameter::log("corner_hz", "Hz", [5.0, 200.0], 30.0).on_site(10.0, 100.0),
    ],
    plain: "bending of the mounting surface strains the device",
    columns: &["frequency_hz", "payload_kg", "ratio"],
    confused_with: &["dut_highpass", "gravity_tilt", "dut_frequency_slope"],
    separate_by: "a second payload below the corner; phase at low frequency",
    ..Entry::CALIBRATOR
};

/// Tilt of the table in proportion to its travel: a tilted device senses a part of gravity. The
/// direction is fixed to the exciter, that of the device turns with it. 1 Hz2 is 0.23 degrees per
/// millimetre.
pub static GRAVITY_TILT: Entry = Entry {
    id: "gravity_tilt",
    stage: Stage::Mount,
    formula: "r = 1 + g cos(rotation)/f^2",
    parameters: &[Parameter::linear("tilt_hz2", "Hz2", [-1e4, 1e4], 0.5).on_site(-0.2, 0.2)],
    plain: "the table tilts as it travels, so that gravity leaks into the signal",
    columns: &["frequency_hz", "rotation_deg", "ratio"],
    confused_with: &["reference_highpass", "dut_highpass", "transverse_motion"],
    separate_by: "the device rotated by 180 degrees at the lowest frequencies",
    ..Entry::CALIBRATOR
};

/// A loose device that lifts off when the table falls away faster than the mounting pulls: its
/// acceleration is cut on one side (`upper`), and impacts add noise in proportion to the excess.
/// With `weight` the threshold is that of a vertical axis and tilting takes the weight away. A
/// device held by its weight lifts off at 1 g, by a weak magnet at 3 g.
pub static LOOSE_MOUNT: Entry = Entry {
    id: "loose_mount",
    stage: Stage::Mount,
    formula: "acceleration of the device cut on one side at a threshold of 0.5..3 g, impact noise above it",
    parameters: &[
        Parameter::log("threshold_ms2", "m/s2", [0.5, 300.0], 15.0).on_site(5.0, 30.0),
        // None is 0, which no factor reaches.
        Parameter::log("impact_noise", "1", [1e-7, 3.0], 0.01)
            .simulated(0.0, 3.0)
            .on_site(1e-3, 0.1),
        Parameter::switch("upper", "0 or 1", 0.0),
        Parameter::switch("weight", "0 or 1", 0.0),
    ],
    plain: "the device lifts off its mount at high level",
    columns: &[
        "acceleration_ms2",
        "ratio",
        "dut_h2",
        "dut_h3",
        "dut_noise_v",
        "tilt_deg",
    ],
    confused_with: &["adc_clipping"],
    separate_by: "levels around the threshold with harmonics; another tilt",
    ..Entry::CALIBRATOR
};
