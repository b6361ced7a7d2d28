//! The reference transducer.

use super::{Entry, Stage, dut};

pub(crate) static ENTRIES: &[&Entry] = &[
    &RESONANCE,
    &LEVEL_NONLINEARITY,
    &TEMPERATURE,
    &DRIFT,
    &WARM_UP,
    &GAIN,
];

/// Resonance of the reference, as of a device: the ratio shows its inverse, the drive transfer the
/// resonance itself.
pub static RESONANCE: Entry = Entry {
    id: "reference_resonance",
    stage: Stage::Reference,
    formula: "1/r = 1/(1 - (f/fr)^2 + j f/(Q fr)), the same in d",
    parameters: dut::RESONANCE.parameters,
    plain: "the reference transducer has a resonance that already shows in this range",
    columns: &["frequency_hz", "ratio", "dut_deg", "ref_v", "coil_v"],
    confused_with: &["dut_lowpass_2", "relative_motion", "armature_mode"],
    separate_by: "coil voltage beside the ratio; higher frequencies with phase",
    ..Entry::CALIBRATOR
};

/// Sensitivity that depends on the level, as that of a device (ISO 16063-21, Table A.1: amplitude linearity).
/// References state 2e-6 (1 % per 500 g); ten times that is one that was dropped.
pub static LEVEL_NONLINEARITY: Entry = Entry {
    id: "reference_level_nonlinearity",
    stage: Stage::Reference,
    formula: "r = 1/(1 + gamma A), d the other way, A = r.m.s. acceleration in m/s2",
    parameters: &[dut::LEVEL_NONLINEARITY.parameters[0].on_site(-2e-5, 2e-5)],
    plain: "the reference's sensitivity depends on the level",
    columns: &["acceleration_ms2", "ratio", "ref_v", "coil_v"],
    confused_with: &["dut_level_nonlinearity", "adc_cubic", "adc_dead_zone"],
    separate_by: "coil voltage beside the ratio, over a wider range of levels",
    ..Entry::CALIBRATOR
};

/// Temperature coefficient of the reference: the ratio goes the other way, the drive transfer along.
pub static TEMPERATURE: Entry = Entry {
    id: "reference_temperature",
    stage: Stage::Reference,
    formula: "r = 1 - alpha (T - T0), d the other way",
    parameters: &[dut::TEMPERATURE.parameters[0].on_site(-2e-4, 2e-4)],
    plain: "the reference's sensitivity changes with temperature",
    columns: &["temperature_c", "ratio", "ref_v", "coil_v"],
    confused_with: &["dut_temperature", "reference_drift"],
    separate_by: "coil voltage beside the ratio; temperature changed out of step with time",
    ..Entry::CALIBRATOR
};

/// Drift of the reference. A rising ratio is a falling reference: the sign is that of the ratio.
pub static DRIFT: Entry = Entry {
    id: "reference_drift",
    stage: Stage::Reference,
    formula: "r = 1 + b t, d the other way",
    parameters: &[dut::DRIFT.parameters[0].on_site(-5e-6, 5e-6)],
    plain: "the reference drifts with time",
    columns: &["time_s", "ratio", "ref_v", "coil_v"],
    confused_with: &["dut_drift", "reference_temperature", "amplifier_gain_drift"],
    separate_by: "coil voltage beside the ratio; repeated points over time at constant temperature",
    ..Entry::CALIBRATOR
};

/// As that of the device; the ratio shows its inverse.
pub static WARM_UP: Entry = Entry {
    id: "reference_warm_up",
    stage: Stage::Reference,
    formula: "r = 1 + g exp(-t/tau), d the other way",
    parameters: dut::WARM_UP.parameters,
    plain: "the reference was still warming up",
    columns: &["time_s", "ratio", "ref_v", "coil_v"],
    confused_with: &["dut_warm_up", "reference_drift", "coil_heating"],
    separate_by: "coil voltage beside the ratio; points repeated soon after switching on, and an hour later",
    ..Entry::CALIBRATOR
};

/// A constant error of the gain, shared with the measurand: a reference that was dropped.
pub static GAIN: Entry = Entry {
    id: "reference_gain",
    stage: Stage::Reference,
    formula: "constant 1/r: shared with the measurand; a second reference would tell",
    parameters: dut::GAIN.parameters,
    plain: "the reference's sensitivity is not the stated one",
    columns: &["ratio"],
    confused_with: &["dut_gain"],
    separate_by: "compare with a second reference",
    identifiable: false,
    ..Entry::CALIBRATOR
};
