//! Amplifiers and filters between transducer and converter.

use super::{Entry, Parameter, Stage};

pub(crate) static ENTRIES: &[&Entry] = &[
    &DUT_HIGHPASS,
    &REFERENCE_HIGHPASS,
    &DUT_HIGHPASS_2,
    &REFERENCE_HIGHPASS_2,
    &DUT_LOWPASS_1,
    &REFERENCE_LOWPASS_1,
    &DUT_LOWPASS_2,
    &DUT_LOWPASS_4,
    &AVERAGING_WINDOW,
    &SINC2_FILTER,
    &CROSSTALK,
    &MAINS_PICKUP,
];

/// High-pass of first order: a charge amplifier's time constant or an IEPE coupling capacitor, some
/// 0.1 to 100 s.
pub static DUT_HIGHPASS: Entry = Entry {
    id: "dut_highpass",
    stage: Stage::Conditioning,
    formula: "r = j f/fc / (1 + j f/fc)",
    parameters: &[Parameter::log("corner_hz", "Hz", [1e-5, 1e6], 0.8).on_site(1e-3, 5.0)],
    plain: "the device's electronics cut off low frequencies",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["gravity_tilt", "base_strain", "dut_frequency_slope"],
    separate_by: "phase at the lowest frequencies",
    ..Entry::CALIBRATOR
};

/// High-pass of the reference: the ratio shows its inverse, the drive transfer the high-pass itself.
pub static REFERENCE_HIGHPASS: Entry = Entry {
    id: "reference_highpass",
    stage: Stage::Conditioning,
    formula: "1/r = j f/fc / (1 + j f/fc), the same in d",
    parameters: DUT_HIGHPASS.parameters,
    plain: "the reference's electronics cut off low frequencies",
    columns: &["frequency_hz", "ratio", "dut_deg", "ref_v", "coil_v"],
    confused_with: &["gravity_tilt", "dut_frequency_slope", "base_strain"],
    separate_by: "phase at the lowest frequencies; coil voltage beside the ratio",
    ..Entry::CALIBRATOR
};

/// High-pass of second order: a geophone or a servo accelerometer below its natural frequency, a
/// microphone's vent with its coupling capacitor, two coupled stages. Geophones have quality factors of
/// 0.7 to 2 at 4.5 to 14 Hz; two corners that differ make one below 0.5, 1/3 where the second of two equal
/// RC stages loads the first.
pub static DUT_HIGHPASS_2: Entry = Entry {
    id: "dut_highpass_2",
    stage: Stage::Conditioning,
    formula: "r = -q^2/(1 - q^2 + j q/Q), q = f/fc",
    parameters: &[
        Parameter::log("corner_hz", "Hz", [1e-5, 1e6], 1.0).on_site(1e-2, 15.0),
        Parameter::log("quality", "1", [0.25, 30.0], 0.7).on_site(0.5, 3.0),
    ],
    plain: "the device cuts off low frequencies steeply, as a spring and a mass do",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["dut_highpass", "gravity_tilt", "base_strain"],
    separate_by: "phase at the lowest frequencies, an octave lower if the exciter reaches it",
    ..Entry::CALIBRATOR
};

/// High-pass of second order of the reference: the ratio shows its inverse, the drive transfer the high-pass itself.
pub static REFERENCE_HIGHPASS_2: Entry = Entry {
    id: "reference_highpass_2",
    stage: Stage::Conditioning,
    formula: "1/r = -q^2/(1 - q^2 + j q/Q), q = f/fc, the same in d",
    parameters: DUT_HIGHPASS_2.parameters,
    plain: "the reference cuts off low frequencies steeply, as a spring and a mass do",
    columns: &["frequency_hz", "ratio", "dut_deg", "ref_v", "coil_v"],
    confused_with: &["reference_highpass", "gravity_tilt", "base_strain"],
    separate_by: "phase at the lowest frequencies; coil voltage beside the ratio",
    ..Entry::CALIBRATOR
};

/// Low-pass of first order: a cable's capacitance (100 pF/m) on a source of up to 10 kilohm.
pub static DUT_LOWPASS_1: Entry = Entry {
    id: "dut_lowpass_1",
    stage: Stage::Conditioning,
    formula: "r = 1/(1 + j f/fc)",
    parameters: &[Parameter::log("corner_hz", "Hz", [0.01, 1e9], 80e3).on_site(5e3, 1e6)],
    plain: "the device's electronics cut off high frequencies",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &[
        "averaging_window",
        "dut_lowpass_2",
        "channel_skew",
        "crosstalk",
    ],
    separate_by: "higher frequencies, magnitude and phase",
    ..Entry::CALIBRATOR
};

/// Low-pass of the reference: the ratio shows its inverse, the drive transfer the low-pass itself.
pub static REFERENCE_LOWPASS_1: Entry = Entry {
    id: "reference_lowpass_1",
    stage: Stage::Conditioning,
    formula: "1/r = 1/(1 + j f/fc), the same in d",
    parameters: DUT_LOWPASS_1.parameters,
    plain: "the reference's electronics cut off high frequencies",
    columns: &["frequency_hz", "ratio", "dut_deg", "ref_v", "coil_v"],
    confused_with: &["channel_skew", "reference_resonance", "crosstalk"],
    separate_by: "higher frequencies, magnitude and phase; coil voltage beside the ratio",
    ..Entry::CALIBRATOR
};

/// Low-pass of second order, Bessel to slightly peaked: the output filter of a conditioner.
pub static DUT_LOWPASS_2: Entry = Entry {
    id: "dut_lowpass_2",
    stage: Stage::Conditioning,
    formula: "r = 1/(1 - (f/fc)^2 + j f/(Q fc)), Q 0.25..1.5",
    parameters: &[
        Parameter::log("corner_hz", "Hz", [0.01, 1e7], 50e3).on_site(5e3, 2e5),
        // From 1.5 on it is a resonance. Two corners that differ make one below 0.5.
        Parameter::log("quality", "1", [0.25, 1.5], 0.7)
            .simulated(0.5, 1.0)
            .on_site(0.5, 1.0),
    ],
    plain: "a filter of the device's electronics cuts off high frequencies",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &[
        "dut_lowpass_1",
        "averaging_window",
        "dut_resonance",
        "channel_skew",
    ],
    separate_by: "higher frequencies, magnitude and phase",
    ..Entry::CALIBRATOR
};

/// Low-pass of fourth order: the anti-alias filter of a digitiser or a conditioner, of Butterworth's or
/// Bessel's kind.
pub static DUT_LOWPASS_4: Entry = Entry {
    id: "dut_lowpass_4",
    stage: Stage::Conditioning,
    formula: "r = two sections of second order; -3 dB at fc",
    parameters: &[
        Parameter::log("corner_hz", "Hz", [0.01, 1e7], 50e3).on_site(5e3, 2e5),
        Parameter::switch("bessel", "0 Butterworth, 1 Bessel", 0.0),
    ],
    plain: "a steep filter of the device's electronics cuts off high frequencies",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["dut_lowpass_2", "channel_skew", "sinc2_filter"],
    separate_by: "magnitude at the highest frequencies: a steep filter delays before it cuts off",
    ..Entry::CALIBRATOR
};

/// Digital sensors and boxcar filters report the mean of the past window: a sample period of 1 kHz
/// to 1 MHz.
pub static AVERAGING_WINDOW: Entry = Entry {
    id: "averaging_window",
    stage: Stage::Conditioning,
    formula: "r = sinc(f T) exp(-j pi f T)",
    parameters: &[Parameter::log("duration_s", "s", [1e-9, 0.1], 1e-5).on_site(1e-6, 1e-3)],
    plain: "the device averages over a short time before it reports",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["dut_lowpass_1", "dut_lowpass_2", "channel_skew"],
    separate_by: "higher frequencies, up to the zero at 1/T",
    ..Entry::CALIBRATOR
};

/// Two means one after the other, as the cascaded integrator and comb (CIC) of a sigma-delta converter
/// takes: twice the delay and twice the loss of one, so half the loss of one with the same delay.
pub static SINC2_FILTER: Entry = Entry {
    id: "sinc2_filter",
    stage: Stage::Conditioning,
    formula: "r = (sinc(f T) exp(-j pi f T))^2",
    parameters: &[Parameter::log("duration_s", "s", [1e-9, 0.1], 1e-5).on_site(1e-6, 1e-3)],
    plain: "the device's converter averages twice before it reports",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["averaging_window", "dut_lowpass_4", "channel_skew"],
    separate_by: "higher frequencies, up to the zero at 1/T, magnitude beside phase",
    ..Entry::CALIBRATOR
};

/// Coupling from one channel into the other: through a capacitance the derivative of the
/// neighbour's signal, through a common resistance the signal itself, with a constant phase if it
/// comes from elsewhere. 40 dB apart is a poor cable, 60 dB a sound one.
pub static CROSSTALK: Entry = Entry {
    id: "crosstalk",
    stage: Stage::Conditioning,
    formula: "r = 1 + j f/fx (capacitive) or a constant complex factor (resistive)",
    parameters: &[
        Parameter::linear("inverse_fx_s", "s", [-1e-3, 1e-3], 5e-7).on_site(-5e-8, 5e-8),
        Parameter::linear("in_phase", "1", [-0.5, 0.5], 0.0).on_site(-5e-4, 5e-4),
        Parameter::linear("quadrature", "1", [-0.5, 0.5], 0.0).on_site(-0.01, 0.01),
    ],
    plain: "one channel leaks into the other",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["channel_skew", "dut_lowpass_1", "averaging_window"],
    separate_by: "magnitude at the highest frequencies; the source of the coupled channel switched off",
    sizes: 3,
    other_way: Some(&[0.0, 0.003, 0.003]),
    ..Entry::CALIBRATOR
};

/// Lines at multiples of the mains frequency, not locked to the block: they add to the noise and
/// leak into components near them, each time with another phase. A ground loop gives millivolts.
pub static MAINS_PICKUP: Entry = Entry {
    id: "mains_pickup",
    stage: Stage::Conditioning,
    formula: "lines at n x mains in the DUT channel, not locked to the block: noise, and leakage near n x mains",
    parameters: &[
        // None is 0, which no factor reaches.
        Parameter::log("pickup_v", "V", [1e-9, 1.0], 1e-3)
            .simulated(0.0, 1.0)
            .on_site(3e-5, 1e-3),
        Parameter::linear("second_v", "V", [0.0, 1.0], 2e-4).on_site(1e-5, 3e-4),
        Parameter::linear("third_v", "V", [0.0, 1.0], 4e-4).on_site(1e-5, 3e-4),
    ],
    // What the window of the instrument lets through beside the lines.
    only_fitted: &[Parameter::linear("leaking_share", "1", [0.0, 2.0], 0.3)],
    plain: "the mains gets into the device's signal",
    columns: &["dut_noise_v", "ratio", "acceleration_ms2"],
    confused_with: &["ambient_vibration"],
    separate_by: "noise of both channels with the exciter at rest; points at and beside multiples of the mains frequency",
    only_scatters: true,
    ..Entry::CALIBRATOR
};
