//! `rig.toml`: nominal values, each with a standard uncertainty; values no rig can have are refused.

use super::exciter::{ExciterParameters, Quantity};
use crate::error::GapError;
use crate::thresholds::STATES_NOTHING;
use serde::Deserialize;
use std::path::Path;

/// Subject of a dataset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Kind {
    /// A vibration calibrator, measured at sine points.
    Calibrator,
    /// A single-degree-of-freedom oscillator, recorded over time.
    Oscillator,
}

/// The constant factor that is never known beforehand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Measurand {
    /// Gain of the device under test.
    #[default]
    DutSensitivity,
    /// Gain from coil (or generator) voltage to reference voltage.
    Drive,
}

/// A transducer with its conditioning.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Transducer {
    /// Sensitivity in V/(m/s2).
    pub(crate) sensitivity_v_per_ms2: Option<Quantity>,
}

/// Relative standard deviations of the draws that all rows of a run share.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Repeatability {
    /// Of the reference channel's gain.
    pub(crate) reference_gain: f64,
    /// Of the gain of the device under test.
    pub(crate) dut_gain: f64,
}

/// Two-channel digitiser.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Digitiser {
    /// Sample rate, in Hz.
    pub(crate) sample_rate_hz: Option<f64>,
    /// Samples in one block of the demodulation.
    pub(crate) block_samples: Option<f64>,
    /// Full scale, peak, in V.
    pub(crate) full_scale_v: Option<f64>,
    /// Resolution in bits.
    pub(crate) bits: Option<f64>,
    /// Noise of a healthy channel, r.m.s., in V.
    pub(crate) noise_v: Option<Quantity>,
}

/// Surroundings.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Environment {
    /// Temperature at which the sensitivities hold, in degC.
    pub(crate) reference_temperature_c: Option<f64>,
    /// Mains frequency, in Hz.
    pub(crate) mains_hz: Option<f64>,
}

/// Linear oscillator of ISO 16063-43, formula (1).
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Oscillator {
    /// Gain.
    pub(crate) rho: Option<Quantity>,
    /// Resonance frequency, in Hz.
    pub(crate) resonance_hz: Option<Quantity>,
    /// Damping ratio.
    pub(crate) delta: Option<Quantity>,
}

/// Beliefs of the simulation about the rig; absent parts are not simulated.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Rig {
    /// Kind of dataset.
    pub(crate) kind: Kind,
    /// The factor that is always free.
    #[serde(default)]
    pub(crate) measurand: Measurand,
    /// Reference transducer.
    pub(crate) reference: Option<Transducer>,
    /// Device under test.
    pub(crate) dut: Option<Transducer>,
    /// Exciter.
    pub(crate) exciter: Option<ExciterParameters<Option<Quantity>>>,
    /// Values common to a run.
    #[serde(default)]
    pub(crate) repeatability: Repeatability,
    /// Digitiser.
    #[serde(default)]
    pub(crate) digitiser: Digitiser,
    /// Surroundings.
    #[serde(default)]
    pub(crate) environment: Environment,
    /// Oscillator.
    #[serde(default)]
    pub(crate) oscillator: Oscillator,
}

/// Magnitudes of the entries of a rig, each in its unit, from the inductance of a single turn to the stiffest mounting.
const MAGNITUDES: std::ops::RangeInclusive<f64> = 1e-12..=1e15;

/// Parses and checks the text of a `rig.toml`.
///
/// # Errors
/// [`GapError::Rig`] for unknown entries, missing `kind`, and values no rig can have.
pub(super) fn parse(text: &str, path: &Path) -> Result<Rig, GapError> {
    let problem = |problem: String| GapError::Rig {
        path: path.into(),
        problem,
    };
    let rig: Rig = toml::from_str(text).map_err(|e| problem(e.to_string().trim_end().into()))?;
    check(&rig).map_err(problem)?;
    Ok(rig)
}

fn check(rig: &Rig) -> Result<(), String> {
    for (name, quantity) in quantities(rig) {
        check_quantity(name, quantity)?;
    }
    for (name, value) in plain_values(rig) {
        check_plain(name, value)?;
    }
    check_repeatability(rig.repeatability)?;
    check_environment(rig.environment)
}

fn check_quantity(name: &str, Quantity { value, u }: Quantity) -> Result<(), String> {
    if !is_positive(value) {
        return Err(format!("{name}: value {value} must be a positive number"));
    }
    if !MAGNITUDES.contains(&value) {
        return Err(format!(
            "{name}: value {value:e} is {}; check its unit",
            out_of_range()
        ));
    }
    if !(u.is_finite() && u >= 0.0) {
        return Err(format!("{name}: u {u} must be zero (exact) or positive"));
    }
    if u > STATES_NOTHING * value {
        return Err(format!(
            "{name}: u {u} is more than {STATES_NOTHING} times the value {value}; leave out what is not known"
        ));
    }
    Ok(())
}

fn check_plain(name: &str, value: f64) -> Result<(), String> {
    if !is_positive(value) {
        return Err(format!("{name}: {value} must be a positive number"));
    }
    if !MAGNITUDES.contains(&value) {
        return Err(format!("{name}: {value:e} is {}", out_of_range()));
    }
    Ok(())
}

fn check_repeatability(of_run: Repeatability) -> Result<(), String> {
    for (name, value) in [
        ("reference_gain", of_run.reference_gain),
        ("dut_gain", of_run.dut_gain),
    ] {
        if !(0.0..1.0).contains(&value) {
            return Err(format!(
                "repeatability.{name}: {value} must be a relative standard deviation, 0 or more and below 1"
            ));
        }
    }
    Ok(())
}

fn check_environment(environment: Environment) -> Result<(), String> {
    let mut temperature_c = environment.reference_temperature_c.into_iter();
    if temperature_c.all(|t| (-273.15..1000.0).contains(&t)) {
        Ok(())
    } else {
        Err("environment.reference_temperature_c is no temperature in degC".into())
    }
}

fn is_positive(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

fn out_of_range() -> String {
    format!(
        "out of the range {:e} to {:e} of any rig",
        MAGNITUDES.start(),
        MAGNITUDES.end()
    )
}

/// Entries with an uncertainty that are stated.
fn quantities(rig: &Rig) -> Vec<(&'static str, Quantity)> {
    let mut list = Vec::new();
    let mut push = |name, quantity: Option<Quantity>| list.extend(quantity.map(|q| (name, q)));
    push(
        "reference.sensitivity_v_per_ms2",
        rig.reference.and_then(|t| t.sensitivity_v_per_ms2),
    );
    push(
        "dut.sensitivity_v_per_ms2",
        rig.dut.and_then(|t| t.sensitivity_v_per_ms2),
    );
    if let Some(e) = rig.exciter {
        push("exciter.moving_mass_kg", e.moving_mass_kg);
        push("exciter.stiffness_n_per_m", e.stiffness_n_per_m);
        push("exciter.damping_ns_per_m", e.damping_ns_per_m);
        push("exciter.force_factor_n_per_a", e.force_factor_n_per_a);
        push("exciter.coil_resistance_ohm", e.coil_resistance_ohm);
        push("exciter.coil_inductance_h", e.coil_inductance_h);
    }
    push("digitiser.noise_v", rig.digitiser.noise_v);
    push("oscillator.rho", rig.oscillator.rho);
    push("oscillator.resonance_hz", rig.oscillator.resonance_hz);
    push("oscillator.delta", rig.oscillator.delta);
    list
}

/// Entries without an uncertainty that are stated.
fn plain_values(rig: &Rig) -> Vec<(&'static str, f64)> {
    let mut list = Vec::new();
    let mut push = |name, value: Option<f64>| list.extend(value.map(|v| (name, v)));
    push("digitiser.sample_rate_hz", rig.digitiser.sample_rate_hz);
    push("digitiser.block_samples", rig.digitiser.block_samples);
    push("digitiser.full_scale_v", rig.digitiser.full_scale_v);
    push("digitiser.bits", rig.digitiser.bits);
    push("environment.mains_hz", rig.environment.mains_hz);
    list
}
