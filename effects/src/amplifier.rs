//! The power amplifier.

use super::{Entry, Parameter, Stage, dut};

pub(crate) static ENTRIES: &[&Entry] = &[&CLIPPING, &SOFT_CLIPPING, &EVEN_ORDER, &GAIN_DRIFT];

/// The coil voltage stays at the supply rails; the coil turns the corners into harmonics of the
/// motion.
pub static CLIPPING: Entry = Entry {
    id: "amplifier_clipping",
    stage: Stage::Amplifier,
    formula: "coil voltage saturates at a threshold: odd harmonics in both channels",
    parameters: &[Parameter::log("threshold_v", "V", [1e-3, 1e4], 15.0).on_site(1.0, 100.0)],
    plain: "the power amplifier is overdriven at large signals",
    columns: &["coil_v", "ref_h3", "dut_h3", "ref_h5", "dut_h5"],
    confused_with: &["suspension_cubic", "amplifier_soft_clipping"],
    separate_by: "harmonics at the highest coil voltage, at several frequencies",
    ..Entry::CALIBRATOR
};

/// The output bends before it stops at the rails, as that of a differential pair does. At a fifth of the
/// threshold the third harmonic is 0.3 %, at half of it 2 %.
pub static SOFT_CLIPPING: Entry = Entry {
    id: "amplifier_soft_clipping",
    stage: Stage::Amplifier,
    formula: "coil voltage c tanh(e/c): H3 as V^2, then higher odd harmonics, in both channels",
    parameters: &[Parameter::log("threshold_v", "V", [1e-2, 1e5], 60.0).on_site(10.0, 500.0)],
    plain: "the power amplifier bends before it is overdriven",
    columns: &["coil_v", "ref_h3", "dut_h3", "ref_h5", "dut_h5"],
    confused_with: &["amplifier_clipping", "suspension_cubic"],
    separate_by: "harmonics over a wide range of coil voltages, at several frequencies",
    ..Entry::CALIBRATOR
};

/// Unequal halves of the output stage; the d.c. they make does not pass the coupling. 3e-3 is a
/// distortion of 1.5 % at 10 V.
pub static EVEN_ORDER: Entry = Entry {
    id: "amplifier_even_order",
    stage: Stage::Amplifier,
    formula: "coil voltage e + b e^2: H2 as V in both channels",
    parameters: &[Parameter::linear("even_per_v", "1/V", [-1.0, 1.0], 1e-3).on_site(-3e-3, 3e-3)],
    plain: "the power amplifier is curved to one side",
    columns: &["coil_v", "ref_h2", "dut_h2"],
    confused_with: &["suspension_asymmetry"],
    separate_by: "harmonics at the highest coil voltage, at several frequencies",
    ..Entry::CALIBRATOR
};

/// Drift of the gain: invisible where the coil voltage is measured; otherwise the demanded voltage
/// is recorded instead.
pub static GAIN_DRIFT: Entry = Entry {
    id: "amplifier_gain_drift",
    stage: Stage::Amplifier,
    formula: "d = 1 + b t, r and z stay (only when the coil voltage is not measured)",
    parameters: &[dut::DRIFT.parameters[0].on_site(-5e-6, 5e-6)],
    plain: "the power amplifier's gain drifts with time",
    columns: &["time_s", "ref_v", "coil_v"],
    confused_with: &["reference_drift", "coil_heating"],
    separate_by: "the ratio over the same time (a drift of the reference shows there)",
    ..Entry::CALIBRATOR
};
