//! The device under test.

use super::{Entry, Parameter, Stage};

pub(crate) static ENTRIES: &[&Entry] = &[
    &RESONANCE,
    &FREQUENCY_SLOPE,
    &POWER_LAW,
    &LEVEL_NONLINEARITY,
    &TEMPERATURE,
    &DRIFT,
    &WARM_UP,
    &GAIN,
];

/// Resonance of the mounted transducer: the element is a mass on a stiff spring, lightly damped.
/// Data sheets of general-purpose accelerometers state 5 to 60 kHz. A quality factor below 1.5 is
/// a filter.
pub static RESONANCE: Entry = Entry {
    id: "dut_resonance",
    stage: Stage::Dut,
    formula: "r = 1/(1 - (f/fr)^2 + j f/(Q fr))",
    parameters: &[
        Parameter::log("resonance_hz", "Hz", [10.0, 120e3], 30e3).on_site(5e3, 60e3),
        Parameter::log("quality", "1", [1.5, 1000.0], 25.0).on_site(3.0, 100.0),
    ],
    plain: "the device under test has a resonance that already shows in this range",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["mount_compliance", "dut_lowpass_2", "averaging_window"],
    separate_by: "other payloads; higher frequencies with phase",
    ..Entry::CALIBRATOR
};

/// Sensitivity that falls by a constant share per decade: piezoelectric ceramics relax over a wide
/// spectrum of time constants. ISO 16063-21:2003, Annex D has 2 % per decade.
pub static FREQUENCY_SLOPE: Entry = Entry {
    id: "dut_frequency_slope",
    stage: Stage::Dut,
    formula: "r = 1 - s lg(f/fref), fref = 160 Hz",
    parameters: &[Parameter::linear("slope_per_decade", "1", [0.0, 0.3], 0.02).on_site(0.0, 0.05)],
    plain: "the device's sensitivity falls slowly with frequency",
    columns: &["frequency_hz", "ratio"],
    confused_with: &["dut_highpass", "base_strain", "reference_highpass"],
    separate_by: "more decades of frequency, with phase",
    ..Entry::CALIBRATOR
};

/// A constant-phase element, as a piezoelectric ceramic with losses of the same share at all frequencies
/// is: the slope over frequency with the phase that causality demands beside it, 90 degrees times the
/// exponent. 0.01 is 2.3 % per decade and 0.9 degrees.
pub static POWER_LAW: Entry = Entry {
    id: "dut_power_law",
    stage: Stage::Dut,
    formula: "r = (j f/fref)^-n: falls by 2.3 n per decade, phase -n 90 degrees",
    parameters: &[Parameter::linear("exponent", "1", [0.0, 0.3], 0.008).on_site(0.0, 0.02)],
    plain: "the device's ceramic has losses at all frequencies, so that it falls and lags",
    columns: &["frequency_hz", "ratio", "dut_deg"],
    confused_with: &["dut_frequency_slope", "dut_highpass"],
    separate_by: "phase at middle frequencies, where filters have none",
    ..Entry::CALIBRATOR
};

/// Sensitivity that depends on the level: domains of a piezoelectric ceramic follow the stress of
/// the whole cycle, so the gain follows the r.m.s. acceleration; if the element is asymmetric, a
/// second harmonic grows alike. Sound devices state 2e-6 (1 % per 500 g), damaged ones and loose
/// preloads reach 1e-3.
pub static LEVEL_NONLINEARITY: Entry = Entry {
    id: "dut_level_nonlinearity",
    stage: Stage::Dut,
    formula: "r = 1 + gamma A, A = r.m.s. acceleration in m/s2; H2 if asymmetric",
    parameters: &[
        Parameter::linear("gamma_per_ms2", "s2/m", [-0.1, 0.1], 1e-4).on_site(-1e-3, 1e-3),
        Parameter::linear("second_harmonic_per_ms2", "s2/m", [-0.1, 0.1], 0.0).on_site(-1e-3, 1e-3),
    ],
    plain: "the device's sensitivity depends on the level",
    columns: &["acceleration_ms2", "ratio", "dut_h2"],
    confused_with: &["adc_cubic", "adc_dead_zone", "reference_level_nonlinearity"],
    separate_by: "a wider range of levels, with harmonics and coil voltage",
    ..Entry::CALIBRATOR
};

/// Temperature coefficient: data sheets state 0.02 to 0.3 % per kelvin.
pub static TEMPERATURE: Entry = Entry {
    id: "dut_temperature",
    stage: Stage::Dut,
    formula: "r = 1 + alpha (T - T0)",
    parameters: &[Parameter::linear("alpha_per_k", "1/K", [-0.05, 0.05], 1e-3).on_site(-1e-3, 1e-3)],
    plain: "the device's sensitivity changes with temperature",
    columns: &["temperature_c", "ratio"],
    confused_with: &["reference_temperature", "dut_drift"],
    separate_by: "coil voltage beside the ratio; temperature changed out of step with time",
    ..Entry::CALIBRATOR
};

/// Drift while a device warms up, ages or its charge amplifier discharges: up to 2 % an hour.
pub static DRIFT: Entry = Entry {
    id: "dut_drift",
    stage: Stage::Dut,
    formula: "r = 1 + b t",
    parameters: &[Parameter::linear("drift_per_s", "1/s", [-1e-2, 1e-2], 2e-6).on_site(-5e-6, 5e-6)],
    plain: "the device drifts with time",
    columns: &["time_s", "ratio"],
    confused_with: &["reference_drift", "dut_temperature", "dut_warm_up"],
    separate_by: "coil voltage beside the ratio; repeated points over time at constant temperature",
    ..Entry::CALIBRATOR
};

/// From switching on to the temperature it keeps, the gain of a device with its electronics comes to rest at
/// what is stated: within minutes for a sensor, an hour for a rack. Makers ask for 15 to 60 minutes. Faster
/// ones are over before a second point is measured, slower ones are a drift.
pub static WARM_UP: Entry = Entry {
    id: "dut_warm_up",
    stage: Stage::Dut,
    formula: "r = 1 + g exp(-t/tau)",
    parameters: &[
        Parameter::linear("cold_rel", "1", [-0.3, 0.3], 5e-3).on_site(-0.01, 0.01),
        Parameter::log("time_constant_s", "s", [60.0, 7200.0], 600.0).on_site(60.0, 4e3),
    ],
    plain: "the device was still warming up",
    columns: &["time_s", "ratio"],
    confused_with: &["reference_warm_up", "dut_drift", "dut_temperature"],
    separate_by: "coil voltage beside the ratio; points repeated soon after switching on, and an hour later",
    ..Entry::CALIBRATOR
};

/// A constant error of the gain: the measurand itself. Field devices come back up to 10 % off.
pub static GAIN: Entry = Entry {
    id: "dut_gain",
    stage: Stage::Dut,
    formula: "constant r: the measurand itself; a second reference would tell",
    parameters: &[Parameter::linear("gain", "1", [-0.9, 10.0], 0.01).on_site(-0.1, 0.1)],
    plain: "the device's sensitivity is not the stated one",
    columns: &["ratio"],
    confused_with: &["reference_gain"],
    separate_by: "compare with a second reference",
    identifiable: false,
    ..Entry::CALIBRATOR
};
