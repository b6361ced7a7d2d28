//! Surroundings.

use super::{Entry, Parameter, Stage};

pub(crate) static ENTRIES: &[&Entry] = &[&AMBIENT_VIBRATION];

/// Traffic, machines and people shake the base: a tone and broadband motion, both transducers
/// alike, not locked to the block. Floors of workshops move by 0.001 to 0.1 m/s2.
pub static AMBIENT_VIBRATION: Entry = Entry {
    id: "ambient_vibration",
    stage: Stage::Environment,
    formula: "a tone (1..30 Hz) and broadband motion of the base, the same in both channels: noise, and leakage near the tone",
    parameters: &[
        // None is 0, which no factor reaches.
        Parameter::log("broadband_ms2", "m/s2", [1e-7, 10.0], 5e-3)
            .simulated(0.0, 10.0)
            .on_site(1e-3, 0.02),
        Parameter::log("tone_ms2", "m/s2", [1e-7, 10.0], 0.0)
            .simulated(0.0, 10.0)
            .on_site(3e-3, 0.3),
        Parameter::linear("tone_hz", "Hz", [0.8, 32.0], 12.0).on_site(8.0, 30.0),
    ],
    plain: "the floor vibrates",
    columns: &["ref_noise_v", "dut_noise_v", "ref_v", "coil_v"],
    confused_with: &["mains_pickup"],
    separate_by: "noise of both channels with the exciter at rest",
    only_scatters: true,
    ..Entry::CALIBRATOR
};
