//! Gains that depend on frequency, level, temperature or time.

use crate::model::chain::{Chain, Transfer};
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use calib_effects::{Entry, Parameter, amplifier, dut, reference};
use num_complex::Complex64;
use std::f64::consts::FRAC_PI_2;

pub(super) static EXPLANATIONS: Explanations = &[
    &FrequencySlope,
    &PowerLaw,
    &LevelNonlinearity::Plain,
    &LevelNonlinearity::Second,
    &LevelNonlinearity::Third,
    &ReferenceLevel,
    &Slow::DutTemperature,
    &Slow::ReferenceTemperature,
    &Slow::ReferenceDrift,
    &Slow::DutDrift,
    &Slow::AmplifierGainDrift,
    &WarmUp::Dut,
    &WarmUp::Reference,
];

/// Sensitivity that falls by a constant amount per decade.
struct FrequencySlope;

/// A constant-phase element: it falls and lags at all frequencies.
struct PowerLaw;

/// Sensitivity that grows with level; how it distorts depends on its symmetry.
enum LevelNonlinearity {
    /// Gain only.
    Plain,
    /// Gain with a second harmonic in proportion to level.
    Second,
    /// Gain with the third harmonic of an odd a|a| term.
    Third,
}

/// Sensitivity of the reference that grows with level.
struct ReferenceLevel;

/// A gain that follows temperature or time.
enum Slow {
    DutTemperature,
    ReferenceTemperature,
    ReferenceDrift,
    DutDrift,
    AmplifierGainDrift,
}

/// A gain that comes to rest.
enum WarmUp {
    Dut,
    Reference,
}

impl Effect for FrequencySlope {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &dut::FREQUENCY_SLOPE
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

impl Effect for PowerLaw {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &dut::POWER_LAW
    }
    /// Without phase it is the slope over frequency.
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio_phase
    }
    fn starts(&self, _facts: &Facts) -> Vec<Start> {
        vec![Start::positive(vec![1e-3], 0)]
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let size = (frequency_hz / 160.0).powf(-p[0]);
        transfer.dut *= Complex64::from_polar(size, -p[0] * FRAC_PI_2);
    }
}

impl Effect for LevelNonlinearity {
    fn entry(&self) -> &'static Entry {
        &dut::LEVEL_NONLINEARITY
    }
    fn parameters(&self) -> &'static [Parameter] {
        match self {
            Self::Second => self.entry().parameters,
            _ => &self.entry().parameters[..1],
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

impl Effect for ReferenceLevel {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &reference::LEVEL_NONLINEARITY
    }
    fn alike(&self, facts: &Facts) -> Option<&'static Entry> {
        (facts.level_varies && !facts.drive_modulus).then_some(&dut::LEVEL_NONLINEARITY)
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.level_varies && facts.drive_modulus
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        vec![Start::signed(vec![0.002 / facts.largest_level_ms2], 0)]
    }
    fn transfer(&self, p: &[f64], row: &Row, _frequency_hz: f64, transfer: &mut Transfer) {
        // It shows A (1 + gamma A), which is the level of the row.
        let root = (1.0 + 4.0 * p[0] * row.level_ms2).max(0.0).sqrt();
        transfer.reference *= f64::midpoint(1.0, root);
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
    fn entry(&self) -> &'static Entry {
        match self {
            Self::DutTemperature => &dut::TEMPERATURE,
            Self::ReferenceTemperature => &reference::TEMPERATURE,
            Self::ReferenceDrift => &reference::DRIFT,
            Self::DutDrift => &dut::DRIFT,
            Self::AmplifierGainDrift => &amplifier::GAIN_DRIFT,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        let seen = match self {
            Self::DutTemperature | Self::DutDrift => facts.ratio,
            Self::ReferenceTemperature | Self::ReferenceDrift => facts.ratio || facts.drive_modulus,
            Self::AmplifierGainDrift => facts.drive_modulus,
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

impl Effect for WarmUp {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        match self {
            Self::Dut => &dut::WARM_UP,
            Self::Reference => &reference::WARM_UP,
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        let seen = facts.ratio || (facts.drive_modulus && matches!(self, Self::Reference));
        seen && facts.longest_s > self.entry().parameters[1].lower
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let time_constant = &self.entry().parameters[1];
        let slowest_s = (0.7 * facts.longest_s).clamp(time_constant.lower, time_constant.upper);
        ratios(time_constant.lower.max(0.02 * slowest_s), slowest_s, 5)
            .into_iter()
            .map(|time_constant_s| Start::signed(vec![0.002, time_constant_s], 0))
            .collect()
    }
    fn transfer(&self, p: &[f64], row: &Row, _frequency_hz: f64, transfer: &mut Transfer) {
        let still_cold = (-row.time_s / p[1]).exp();
        match self {
            Self::Dut => transfer.dut *= 1.0 + p[0] * still_cold,
            Self::Reference => transfer.reference *= 1.0 - p[0] * still_cold,
        }
    }
}
