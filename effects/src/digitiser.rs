//! The converter and its clock.

use super::{Entry, Parameter, Stage};

pub(crate) static ENTRIES: &[&Entry] = &[
    &CHANNEL_SKEW,
    &SAMPLING_JITTER,
    &CLOCK_OFFSET,
    &CUBIC,
    &QUADRATIC,
    &DEAD_ZONE,
    &CLIPPING,
    &SOFT_CLIPPING,
    &RANGE_STEP,
];

const CHANNEL: Parameter = Parameter::switch("channel", "0 reference, 1 DUT", 1.0);
const HARMONIC_COLUMNS: &[&str] = &[
    "acceleration_ms2",
    "ratio",
    "ref_h3",
    "dut_h3",
    "ref_h5",
    "dut_h5",
];

/// Fixed delay between the channels: multiplexed converters sample one channel later than the
/// other, by a conversion of 1 to 20 microseconds.
pub static CHANNEL_SKEW: Entry = Entry {
    id: "channel_skew",
    stage: Stage::Digitiser,
    formula: "r = exp(-j 2 pi f tau)",
    parameters: &[Parameter::linear("tau_s", "s", [-0.1, 0.1], 1e-6).on_site(-3e-7, 3e-7)],
    plain: "the two channels are not sampled at the same instant",
    columns: &["frequency_hz", "dut_deg"],
    confused_with: &[
        "crosstalk",
        "dut_lowpass_1",
        "averaging_window",
        "dut_lowpass_2",
    ],
    separate_by: "magnitude at the highest frequencies; both channels on one signal",
    ..Entry::CALIBRATOR
};

/// Scatter of the sampling instants: noise in proportion to the slope of the signal, and a mean
/// that is a little smaller. Quartz clocks scatter by picoseconds, sampling by software by less
/// than a microsecond.
pub static SAMPLING_JITTER: Entry = Entry {
    id: "sampling_jitter",
    stage: Stage::Digitiser,
    formula: "d = exp(-(2 pi f sigma)^2/2), noise 2 pi f sigma A in both channels",
    parameters: &[
        // None is 0, which no factor reaches.
        Parameter::log("sigma_s", "s", [1e-12, 1e-3], 3e-8)
            .simulated(0.0, 1e-3)
            .on_site(1e-10, 1e-7),
    ],
    plain: "the instants of sampling scatter",
    columns: &[
        "frequency_hz",
        "acceleration_ms2",
        "ref_noise_v",
        "dut_noise_v",
    ],
    confused_with: &["ambient_vibration", "mains_pickup"],
    separate_by: "noise at the highest frequency and level",
    only_scatters: true,
    ..Entry::CALIBRATOR
};

/// Two digitisers whose clocks run apart: the delay of the device's channel grows with time. Clocks
/// locked to one another; with free quartz clocks, 1e-5 apart, no phase is stated at all.
pub static CLOCK_OFFSET: Entry = Entry {
    id: "clock_offset",
    stage: Stage::Digitiser,
    formula: "r = exp(-j 2 pi f delta t)",
    parameters: &[Parameter::linear("delta", "1", [-1e-2, 1e-2], 5e-11).on_site(-1e-9, 1e-9)],
    plain: "the two channels run on clocks that drift apart",
    columns: &["frequency_hz", "time_s", "dut_deg"],
    confused_with: &["channel_skew"],
    separate_by: "the highest frequency repeated over time",
    ..Entry::CALIBRATOR
};

/// Odd bend of one converter: the gain changes with the square of the amplitude, and a third
/// harmonic appears. 0.03 is 2 % at 1 V, a damaged input.
pub static CUBIC: Entry = Entry {
    id: "adc_cubic",
    stage: Stage::Digitiser,
    formula: "gain 1 + 3/4 c3 A^2, H3 = c3 A^2/4 in one channel",
    parameters: &[
        Parameter::linear("c3_per_v2", "1/V2", [-0.5, 0.5], 1e-4).on_site(-1e-4, 1e-4),
        CHANNEL,
    ],
    plain: "a converter is curved, alike to both sides",
    columns: HARMONIC_COLUMNS,
    confused_with: &["dut_level_nonlinearity", "adc_clipping", "adc_dead_zone"],
    separate_by: "a wider range of levels, with harmonics",
    ..Entry::CALIBRATOR
};

/// Even bend of one converter: second harmonic and d.c., no change of gain. Size as of the odd bend.
pub static QUADRATIC: Entry = Entry {
    id: "adc_quadratic",
    stage: Stage::Digitiser,
    formula: "H2 = c2 A/2 and d.c. = c2 A^2/2 in one channel",
    parameters: &[
        Parameter::linear("c2_per_v", "1/V", [-0.5, 0.5], 3e-4).on_site(-3e-4, 3e-4),
        CHANNEL,
    ],
    plain: "a converter is curved to one side",
    columns: &[
        "acceleration_ms2",
        "ref_h2",
        "dut_h2",
        "ref_dc_v",
        "dut_dc_v",
    ],
    confused_with: &["dut_level_nonlinearity"],
    separate_by: "d.c. of both channels at the highest level",
    ..Entry::CALIBRATOR
};

/// Nothing happens until the input leaves a band around zero: worst at small amplitudes. A
/// crossover error of a few steps of a converter of 12 to 16 bit.
pub static DEAD_ZONE: Entry = Entry {
    id: "adc_dead_zone",
    stage: Stage::Digitiser,
    formula: "gain 1 - 4 delta/(pi A), H3 and H5 as 1/A in one channel",
    parameters: &[
        Parameter::linear("delta_v", "V", [0.0, 1.0], 1e-4).on_site(0.0, 2e-4),
        CHANNEL,
    ],
    plain: "a converter does not see the smallest signals",
    columns: HARMONIC_COLUMNS,
    confused_with: &["dut_level_nonlinearity", "adc_cubic"],
    separate_by: "the smallest levels, with harmonics",
    ..Entry::CALIBRATOR
};

/// The output stays at the threshold above it, on both sides: a wrong range, a low supply.
pub static CLIPPING: Entry = Entry {
    id: "adc_clipping",
    stage: Stage::Digitiser,
    formula: "saturation of one channel at large outputs: odd harmonics and loss of gain",
    parameters: &[
        Parameter::log("threshold_v", "V", [1e-4, 100.0], 0.6).on_site(0.1, 5.0),
        CHANNEL,
    ],
    plain: "a converter is overdriven at large signals",
    columns: HARMONIC_COLUMNS,
    confused_with: &["adc_cubic", "loose_mount"],
    separate_by: "levels around the threshold, with harmonics",
    ..Entry::CALIBRATOR
};

/// The input stage bends before it stops, as a pair of transistors or a saturating transformer does. Up to a
/// quarter of the threshold it is a cubic bend, and called so.
pub static SOFT_CLIPPING: Entry = Entry {
    id: "adc_soft_clipping",
    stage: Stage::Digitiser,
    formula: "output c tanh(e/c) of one channel: loss of gain and H3 as A^2, then higher odd harmonics",
    parameters: &[
        Parameter::log("threshold_v", "V", [1e-4, 1e3], 3.0).on_site(0.1, 30.0),
        CHANNEL,
    ],
    plain: "an input bends before it is overdriven",
    columns: HARMONIC_COLUMNS,
    confused_with: &["adc_cubic", "adc_clipping", "dut_level_nonlinearity"],
    separate_by: "the largest levels, with the third and the fifth harmonic",
    ..Entry::CALIBRATOR
};

/// An input that takes a coarser range above a level, whose gain is another one: instruments state 0.05 to
/// 0.5 % between neighbouring ranges. Range and gain are those of the upper one.
pub static RANGE_STEP: Entry = Entry {
    id: "range_step",
    stage: Stage::Digitiser,
    formula: "gain 1 + e in one channel where its peak is above a threshold",
    parameters: &[
        Parameter::linear("step_rel", "1", [-0.3, 0.3], 3e-3).on_site(-0.01, 0.01),
        Parameter::log("threshold_v", "V", [1e-6, 100.0], 0.1).on_site(0.01, 10.0),
        CHANNEL,
    ],
    plain: "an input has another gain in its next range",
    columns: &["acceleration_ms2", "ratio"],
    confused_with: &["dut_level_nonlinearity", "adc_dead_zone", "adc_cubic"],
    separate_by: "levels closely below and above the step; the range held by hand",
    ..Entry::CALIBRATOR
};
