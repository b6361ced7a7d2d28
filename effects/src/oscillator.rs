//! Terms of real oscillators beside mass, damping and spring of ISO 16063-43 formula (1).
//!
//! Terms of like parity and like force are confused: conservative ones move the resonance with
//! level, dissipative ones its height. Amplitudes are in the unit of the output, which is whatever
//! the record states, so most site sizes are all that can be simulated.

use super::{Entry, Parameter, Stage};

pub(crate) static ENTRIES: &[&Entry] = &[
    &CUBIC_STIFFNESS,
    &QUADRATIC_STIFFNESS,
    &QUADRATIC_DAMPING,
    &CUBIC_DAMPING,
    &COULOMB_FRICTION,
    &INPUT_DELAY,
    &INPUT_SATURATION,
    &INPUT_OFFSET,
    &OUTPUT_HIGHPASS,
    &OUTPUT_LOWPASS,
    &OUTPUT_CLIPPING,
    &OUTPUT_TREND,
    &RESONANCE_DRIFT,
    &SECOND_MODE,
    &DEAD_ZONE,
    &HYSTERESIS,
];

/// A symmetric hardening or softening spring: Duffing's oscillator.
pub static CUBIC_STIFFNESS: Entry = Entry {
    id: "cubic_stiffness",
    formula: "w0^2 (x + k3 x^3)",
    parameters: &[Parameter::linear("k3", "1/output2", [-1e6, 1e6], 3.0)],
    plain: "the spring stiffens alike to both sides as it is deflected",
    confused_with: &["dead_zone", "hysteresis", "input_saturation"],
    separate_by: "the same record at half and at twice the amplitude",
    ..Entry::OSCILLATOR
};

/// An asymmetric spring: even harmonics and a mean deflection.
pub static QUADRATIC_STIFFNESS: Entry = Entry {
    id: "quadratic_stiffness",
    formula: "w0^2 (x + k2 x^2)",
    parameters: &[Parameter::linear("k2", "1/output", [-1e6, 1e6], 0.3)],
    plain: "the spring is stiffer to one side",
    confused_with: &["input_offset", "output_highpass"],
    separate_by: "the same input with its sign turned, and one with a steady offset",
    ..Entry::OSCILLATOR
};

/// Air or a liquid around the mass: it opposes the motion in both directions.
pub static QUADRATIC_DAMPING: Entry = Entry {
    id: "quadratic_damping",
    formula: "2 delta w0 x' (1 + d2 |x'|/w0)",
    parameters: &[Parameter::linear("d2", "1/output", [0.0, 1e6], 1.0)],
    plain: "the damping grows with speed",
    confused_with: &["coulomb_friction", "cubic_damping"],
    separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    ..Entry::OSCILLATOR
};

/// Damping that grows with the square of the velocity, stated for a velocity `w0 x` of unit
/// amplitude.
pub static CUBIC_DAMPING: Entry = Entry {
    id: "cubic_damping",
    formula: "2 delta w0 x' (1 + d3 (x'/w0)^2)",
    parameters: &[Parameter::linear("d3", "1/output2", [0.0, 1e6], 3.0)],
    plain: "the damping grows steeply with speed",
    confused_with: &["quadratic_damping", "input_saturation"],
    separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    ..Entry::OSCILLATOR
};

/// A constant force against the velocity, stated as the deflection it would hold.
pub static COULOMB_FRICTION: Entry = Entry {
    id: "coulomb_friction",
    formula: "x'' + ... + w0^2 xc sign(x')",
    parameters: &[Parameter::linear("deflection", "output", [0.0, 1e6], 0.01)],
    plain: "something rubs against the moving part",
    confused_with: &["quadratic_damping", "hysteresis", "dead_zone"],
    separate_by: "a decay from the resonance down to rest, and the smallest amplitudes",
    ..Entry::OSCILLATOR
};

/// A filter or a multiplexed converter in the input channel: at most a few samples.
pub static INPUT_DELAY: Entry = Entry {
    id: "input_delay",
    stage: Stage::Amplifier,
    formula: "a(t - tau)",
    parameters: &[Parameter::linear("tau_s", "s", [0.0, 1.0], 3e-4).on_site(0.0, 0.01)],
    plain: "the input acts with a delay",
    confused_with: &["output_lowpass", "second_mode", "output_highpass"],
    separate_by: "frequencies far above the resonance",
    ..Entry::OSCILLATOR
};

/// The amplifier that drives the oscillator runs into its rails after the input is recorded.
pub static INPUT_SATURATION: Entry = Entry {
    id: "input_saturation",
    stage: Stage::Amplifier,
    formula: "clip(a, +-a0)",
    parameters: &[Parameter::linear("threshold", "input", [1e-9, 1e9], 0.1)],
    plain: "the input is cut at large values",
    confused_with: &["output_clipping", "cubic_stiffness", "cubic_damping"],
    separate_by: "an input of half the peak value, and the input as it arrives",
    ..Entry::OSCILLATOR
};

/// A steady force, as of weight or a magnet, or an amplifier with an offset. It moves the rest of the
/// spring. Only a spring that is not straight shows that: on a straight one, or where a quadratic part is
/// in question, it is one with the zero of the output.
pub static INPUT_OFFSET: Entry = Entry {
    id: "input_offset",
    stage: Stage::Amplifier,
    formula: "a + a0",
    parameters: &[Parameter::linear("offset", "input", [-1e9, 1e9], 0.01)],
    plain: "a steady force acts beside the input",
    confused_with: &["quadratic_stiffness"],
    separate_by: "the output at rest with the input on and off, and a record about another rest",
    ..Entry::OSCILLATOR
};

/// First order, as of an a.c. coupled conditioner.
pub static OUTPUT_HIGHPASS: Entry = Entry {
    id: "output_highpass",
    stage: Stage::Conditioning,
    formula: "s/wc / (1 + s/wc)",
    parameters: &[Parameter::linear("corner_hz", "Hz", [1e-5, 1e5], 0.5).on_site(1e-3, 10.0)],
    plain: "the output loses its slow part",
    confused_with: &["quadratic_stiffness", "input_delay", "output_trend"],
    separate_by: "frequencies far below the resonance",
    ..Entry::OSCILLATOR
};

/// First order, as of a filter before the converter. Far below its corner it is a delay, which any
/// record that is sampled a few times a period tells from it.
pub static OUTPUT_LOWPASS: Entry = Entry {
    id: "output_lowpass",
    stage: Stage::Conditioning,
    formula: "1/(1 + s/wc)",
    parameters: &[Parameter::linear("corner_hz", "Hz", [1e-5, 1e5], 200.0).on_site(0.1, 1e4)],
    plain: "the output loses its fast part",
    confused_with: &["input_delay", "second_mode"],
    separate_by: "frequencies far above the resonance, magnitude and phase",
    ..Entry::OSCILLATOR
};

/// The converter, or the amplifier before it, runs into its rails: alike to both sides.
pub static OUTPUT_CLIPPING: Entry = Entry {
    id: "output_clipping",
    stage: Stage::Digitiser,
    formula: "clip(y, +-y0)",
    parameters: &[Parameter::linear("threshold", "output", [1e-9, 1e9], 0.1)],
    plain: "the output is cut at large values",
    confused_with: &["input_saturation", "cubic_stiffness"],
    separate_by: "the range of the converter doubled, or half the input",
    ..Entry::OSCILLATOR
};

/// The zero of the output drifts, evenly over the record: its first sample is at time 0.
pub static OUTPUT_TREND: Entry = Entry {
    id: "output_trend",
    stage: Stage::Conditioning,
    formula: "y + b t",
    parameters: &[Parameter::linear(
        "drift_per_s",
        "output/s",
        [-1e6, 1e6],
        0.01,
    )],
    plain: "the zero of the output drifts",
    confused_with: &["output_highpass"],
    separate_by: "the output at rest before and after the record",
    ..Entry::OSCILLATOR
};

/// A spring that warms, a mass that loads or a clamp that works loose: the resonance moves evenly over the
/// record, from its value at the first sample.
pub static RESONANCE_DRIFT: Entry = Entry {
    id: "resonance_drift",
    formula: "w0^2 (1 + r t)^2 x",
    parameters: &[Parameter::linear("drift_per_s", "1/s", [-1e3, 1e3], 0.01)],
    plain: "the resonance drifts",
    confused_with: &["cubic_stiffness", "output_trend"],
    separate_by: "the same record once more, after a rest",
    ..Entry::OSCILLATOR
};

/// A second mode is driven by the same input and adds to the output.
pub static SECOND_MODE: Entry = Entry {
    id: "second_mode",
    formula: "y = x + x2, x2'' + 2 d2 w2 x2' + w2^2 x2 = g rho a",
    parameters: &[
        Parameter::linear("gain", "1", [-100.0, 100.0], 0.1).on_site(-1.0, 1.0),
        Parameter::linear("mode_hz", "Hz", [1e-3, 1e6], 150.0),
        Parameter::linear("damping", "1", [1e-4, 1.0], 0.02).on_site(1e-3, 0.2),
    ],
    plain: "a second part vibrates along",
    confused_with: &["input_delay"],
    separate_by: "a small-amplitude sweep around the second frequency",
    ..Entry::OSCILLATOR
};

/// Play of the spring: no restoring force until the deflection leaves a band around zero.
pub static DEAD_ZONE: Entry = Entry {
    id: "dead_zone",
    formula: "w0^2 (x - clip(x, +-x0))",
    parameters: &[Parameter::linear("half_width", "output", [0.0, 1e6], 0.005)],
    plain: "the spring has play",
    confused_with: &["cubic_stiffness", "coulomb_friction"],
    separate_by: "the smallest amplitudes, below and above the play",
    ..Entry::OSCILLATOR
};

/// Hysteresis (Bouc-Wen): a part of the force follows a state that yields, so that loading and
/// unloading differ.
pub static HYSTERESIS: Entry = Entry {
    id: "hysteresis",
    formula: "w0^2 (x + alpha z), z' = x' - (|x'| z + x' |z|)/(2 zy)",
    parameters: &[
        Parameter::linear("alpha", "1", [0.0, 10.0], 0.1).on_site(0.0, 1.0),
        Parameter::linear("yield_deflection", "output", [1e-9, 1e6], 0.03),
    ],
    plain: "the spring yields, and pulls less on the way back",
    confused_with: &["coulomb_friction", "cubic_stiffness"],
    separate_by: "slow loading and unloading: the path of the restoring force",
    ..Entry::OSCILLATOR
};
