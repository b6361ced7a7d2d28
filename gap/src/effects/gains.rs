//! Gains that depend on frequency, level, temperature or time.

use super::about::{About, Parameter, Stage};
use super::start::Start;
use super::{Effect, Facts};
use crate::model::chain::{Chain, Transfer};
use crate::model::row::Row;

/// Sensitivity that falls by a constant amount per decade.
pub(super) struct FrequencySlope;

/// Sensitivity that grows with level; how it distorts depends on its symmetry.
pub(super) enum LevelNonlinearity {
    /// Gain only.
    Plain,
    /// Gain with a second harmonic in proportion to level.
    Second,
    /// Gain with the third harmonic of an odd a|a| term.
    Third,
}

/// A gain that follows temperature or time.
pub(super) enum Slow {
    DutTemperature,
    ReferenceTemperature,
    ReferenceDrift,
    DutDrift,
    AmplifierGainDrift,
}

static SLOPE: About = About {
    id: "dut_frequency_slope",
    stage: Stage::Dut,
    formula: "r = 1 - s lg(f/fref)",
    parameters: &[Parameter::linear("slope_per_decade", "1", 0.0, 0.3)],
    columns: &["frequency_hz", "ratio"],
    confused_with: &["dut_highpass", "base_strain", "reference_highpass"],
    separate_by: "more decades of frequency, with phase",
};
const LEVEL_COLUMNS: &[&str] = &["acceleration_ms2", "ratio", "dut_h2"];
static LEVEL: About = About {
    id: "dut_level_nonlinearity",
    stage: Stage::Dut,
    formula: "r = 1 + gamma A, A = r.m.s. acceleration in m/s2; H2 if asymmetric",
    parameters: &[Parameter::linear("gamma_per_ms2", "s2/m", -0.1, 0.1)],
    columns: LEVEL_COLUMNS,
    confused_with: &["adc_cubic", "adc_dead_zone"],
    separate_by: "a wider range of levels, with harmonics",
};
static LEVEL_SECOND: About = About {
    parameters: &[
        Parameter::linear("gamma_per_ms2", "s2/m", -0.1, 0.1),
        Parameter::linear("second_harmonic_per_ms2", "s2/m", -0.1, 0.1),
    ],
    ..LEVEL
};
static DUT_TEMPERATURE: About = About {
    id: "dut_temperature",
    stage: Stage::Dut,
    formula: "r = 1 + alpha (T - T0)",
    parameters: &[Parameter::linear("alpha_per_k", "1/K", -0.05, 0.05)],
    columns: &["temperature_c", "ratio"],
    confused_with: &["reference_temperature", "dut_drift"],
    separate_by: "coil voltage beside the ratio; temperature changed out of step with time",
};
static REFERENCE_TEMPERATURE: About = About {
    id: "reference_temperature",
    stage: Stage::Reference,
    formula: "r = 1 - alpha (T - T0), d the other way",
    parameters: DUT_TEMPERATURE.parameters,
    columns: &["temperature_c", "ratio", "ref_v", "coil_v"],
    confused_with: &["dut_temperature", "reference_drift"],
    separate_by: "coil voltage beside the ratio; temperature changed out of step with time",
};
static REFERENCE_DRIFT: About = About {
    id: "reference_drift",
    stage: Stage::Reference,
    formula: "r = 1 + b t, d the other way",
    parameters: &[Parameter::linear("drift_per_s", "1/s", -1e-2, 1e-2)],
    columns: &["time_s", "ratio", "ref_v", "coil_v"],
    confused_with: &["dut_drift", "reference_temperature", "amplifier_gain_drift"],
    separate_by: "coil voltage beside the ratio; repeated points over time at constant temperature",
};
static DUT_DRIFT: About = About {
    id: "dut_drift",
    stage: Stage::Dut,
    formula: "r = 1 + b t",
    parameters: REFERENCE_DRIFT.parameters,
    columns: &["time_s", "ratio"],
    confused_with: &["reference_drift", "dut_temperature"],
    separate_by: "coil voltage beside the ratio; repeated points over time at constant temperature",
};
static AMPLIFIER_DRIFT: About = About {
    id: "amplifier_gain_drift",
    stage: Stage::Amplifier,
    formula: "d = 1 + b t, r and z stay",
    parameters: REFERENCE_DRIFT.parameters,
    columns: &["time_s", "ref_v", "coil_v"],
    confused_with: &["reference_drift", "coil_heating"],
    separate_by: "the ratio over the same time (a drift of the reference shows there)",
};

impl Effect for FrequencySlope {
    fn is_linear(&self) -> bool {
        true
    }
    fn about(&self) -> &'static About {
        &SLOPE
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio
    }
    fn starts(&self, _facts: &Facts) -> Vec<Start> {
        vec![Start::positive(vec![0.002], 0)]
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        transfer.dut *= 1.0 - p[0] * (frequency_hz / 160.0).log10();
    }
}

impl Effect for LevelNonlinearity {
    fn about(&self) -> &'static About {
        if matches!(self, Self::Second) {
            &LEVEL_SECOND
        } else {
            &LEVEL
        }
    }
    fn distorts(&self) -> bool {
        !matches!(self, Self::Plain)
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.level_varies && facts.ratio && (matches!(self, Self::Plain) || facts.dut_harmonics)
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let unit = 0.002 / facts.largest_level_ms2;
        match self {
            Self::Second => {
                let members = vec![vec![unit, 0.0], vec![0.0, unit]];
                vec![Start {
                    members,
                    amplitude: None,
                    signed: true,
                }]
            }
            _ => vec![Start::signed(vec![unit], 0)],
        }
    }
    fn combine(&self, start: &Start, amplitudes: &[f64]) -> Vec<f64> {
        match self {
            Self::Second => vec![
                start.members[0][0] * amplitudes[0],
                start.members[1][1] * amplitudes[1],
            ],
            _ => start.scaled(amplitudes[0]),
        }
    }
    fn transfer(&self, p: &[f64], row: &Row, _frequency_hz: f64, transfer: &mut Transfer) {
        transfer.dut *= 1.0 + p[0] * row.level_ms2;
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        chain.dut_level_per_ms2 += p[0];
        match self {
            Self::Plain => {}
            Self::Second => chain.dut_harmonics[0] += p[1] * row.level_ms2,
            // a|a| of a cosine: fundamental 8/(3 pi), third harmonic 8/(15 pi).
            Self::Third => chain.dut_harmonics[1] += p[0] * row.level_ms2 / 5.0,
        }
    }
}

impl Slow {
    fn follows_temperature(&self) -> bool {
        matches!(self, Self::DutTemperature | Self::ReferenceTemperature)
    }
}

impl Effect for Slow {
    fn is_linear(&self) -> bool {
        true
    }
    fn about(&self) -> &'static About {
        match self {
            Self::DutTemperature => &DUT_TEMPERATURE,
            Self::ReferenceTemperature => &REFERENCE_TEMPERATURE,
            Self::ReferenceDrift => &REFERENCE_DRIFT,
            Self::DutDrift => &DUT_DRIFT,
            Self::AmplifierGainDrift => &AMPLIFIER_DRIFT,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        let seen = match self {
            Self::DutTemperature | Self::DutDrift => facts.ratio,
            Self::ReferenceTemperature | Self::ReferenceDrift => facts.ratio || facts.drive,
            Self::AmplifierGainDrift => facts.drive,
        };
        seen && if self.follows_temperature() {
            facts.temperature_varies
        } else {
            facts.longest_s > 0.0
        }
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let span = if self.follows_temperature() {
            facts.warmest_k
        } else {
            facts.longest_s
        };
        vec![Start::signed(vec![0.002 / span], 0)]
    }
    fn transfer(&self, p: &[f64], row: &Row, _frequency_hz: f64, transfer: &mut Transfer) {
        match self {
            Self::DutTemperature => transfer.dut *= 1.0 + p[0] * row.warmer_k,
            Self::ReferenceTemperature => transfer.reference *= 1.0 + p[0] * row.warmer_k,
            Self::ReferenceDrift => transfer.reference *= 1.0 - p[0] * row.time_s,
            Self::DutDrift => transfer.dut *= 1.0 + p[0] * row.time_s,
            Self::AmplifierGainDrift => transfer.drive *= 1.0 + p[0] * row.time_s,
        }
    }
}
