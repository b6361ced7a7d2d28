//! `rig.toml`: nominal values, each with a standard uncertainty.

use crate::error::GapError;
use serde::Deserialize;
use std::path::Path;

/// Uncertainty over value beyond which a statement says nothing.
const LEAST_KNOWN: f64 = 10.0;

/// A value and its standard uncertainty in the unit of the entry (0 = exact).
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Quantity {
    /// Best estimate.
    pub(crate) value: f64,
    /// Standard uncertainty.
    pub(crate) u: f64,
}

impl Quantity {
    /// Relative standard uncertainty.
    pub(crate) fn relative_u(self) -> f64 {
        self.u / self.value
    }
}

/// What a dataset is about.
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

/// Voltage-driven moving-coil exciter.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Exciter {
    /// Armature without payload, in kg.
    pub(crate) moving_mass_kg: Option<Quantity>,
    /// Suspension stiffness, in N/m.
    pub(crate) stiffness_n_per_m: Option<Quantity>,
    /// Mechanical damping, in N s/m.
    pub(crate) damping_ns_per_m: Option<Quantity>,
    /// Force factor Bl, in N/A.
    pub(crate) force_factor_n_per_a: Option<Quantity>,
    /// Coil resistance, in ohm.
    pub(crate) coil_resistance_ohm: Option<Quantity>,
    /// Coil inductance at 1 kHz, in H.
    pub(crate) coil_inductance_h: Option<Quantity>,
}

impl Exciter {
    /// Mass, stiffness, damping, force factor, resistance, inductance: all known, or not simulated.
    #[must_use]
    pub(crate) fn complete(&self) -> Option<[Quantity; 6]> {
        Some([
            self.moving_mass_kg?,
            self.stiffness_n_per_m?,
            self.damping_ns_per_m?,
            self.force_factor_n_per_a?,
            self.coil_resistance_ohm?,
            self.coil_inductance_h?,
        ])
    }

    /// Names of the entries of [`Exciter::complete`], in order.
    pub(crate) const NAMES: [&str; 6] = [
        "moving_mass_kg",
        "stiffness_n_per_m",
        "damping_ns_per_m",
        "force_factor_n_per_a",
        "coil_resistance_ohm",
        "coil_inductance_h",
    ];
}

/// What all rows of a run share: relative standard deviations of one draw per run.
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

/// What the simulation believes about the rig; absent parts are not simulated.
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
    pub(crate) exciter: Option<Exciter>,
    /// What a run shares.
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

impl Rig {
    /// Parses and checks the text of a `rig.toml`.
    ///
    /// # Errors
    /// [`GapError::Rig`] for unknown entries, missing `kind`, and values no rig can have.
    pub(crate) fn parse(text: &str, path: &Path) -> Result<Self, GapError> {
        let problem = |problem: String| GapError::Rig {
            path: path.into(),
            problem,
        };
        let rig: Self =
            toml::from_str(text).map_err(|e| problem(e.to_string().trim_end().into()))?;
        rig.check().map_err(problem)?;
        Ok(rig)
    }

    fn check(&self) -> Result<(), String> {
        for (name, quantity) in self.quantities() {
            if !(quantity.value.is_finite() && quantity.value > 0.0) {
                return Err(format!(
                    "{name}: value {} must be a positive number",
                    quantity.value
                ));
            }
            if !MAGNITUDES.contains(&quantity.value) {
                return Err(format!(
                    "{name}: value {:e} is out of the range {:e} to {:e} of any rig; check its unit",
                    quantity.value,
                    MAGNITUDES.start(),
                    MAGNITUDES.end()
                ));
            }
            if !(quantity.u.is_finite() && quantity.u >= 0.0) {
                return Err(format!(
                    "{name}: u {} must be zero (exact) or positive",
                    quantity.u
                ));
            }
            if quantity.u > LEAST_KNOWN * quantity.value {
                return Err(format!(
                    "{name}: u {} is more than {LEAST_KNOWN} times the value {}; leave out what is not known",
                    quantity.u, quantity.value
                ));
            }
        }
        for (name, value) in self.plain_values() {
            if !(value.is_finite() && value > 0.0) {
                return Err(format!("{name}: {value} must be a positive number"));
            }
            if !MAGNITUDES.contains(&value) {
                return Err(format!(
                    "{name}: {value:e} is out of the range {:e} to {:e} of any rig",
                    MAGNITUDES.start(),
                    MAGNITUDES.end()
                ));
            }
        }
        for (name, value) in [
            (
                "repeatability.reference_gain",
                self.repeatability.reference_gain,
            ),
            ("repeatability.dut_gain", self.repeatability.dut_gain),
        ] {
            if !(value.is_finite() && (0.0..1.0).contains(&value)) {
                return Err(format!(
                    "{name}: {value} must be a relative standard deviation, 0 or more and below 1"
                ));
            }
        }
        if self
            .environment
            .reference_temperature_c
            .is_some_and(|t| !(-273.15..1000.0).contains(&t))
        {
            return Err("environment.reference_temperature_c is no temperature in degC".into());
        }
        Ok(())
    }

    fn quantities(&self) -> Vec<(&'static str, Quantity)> {
        let mut list = Vec::new();
        let mut push = |name, quantity: Option<Quantity>| list.extend(quantity.map(|q| (name, q)));
        push(
            "reference.sensitivity_v_per_ms2",
            self.reference.and_then(|t| t.sensitivity_v_per_ms2),
        );
        push(
            "dut.sensitivity_v_per_ms2",
            self.dut.and_then(|t| t.sensitivity_v_per_ms2),
        );
        if let Some(e) = self.exciter {
            push("exciter.moving_mass_kg", e.moving_mass_kg);
            push("exciter.stiffness_n_per_m", e.stiffness_n_per_m);
            push("exciter.damping_ns_per_m", e.damping_ns_per_m);
            push("exciter.force_factor_n_per_a", e.force_factor_n_per_a);
            push("exciter.coil_resistance_ohm", e.coil_resistance_ohm);
            push("exciter.coil_inductance_h", e.coil_inductance_h);
        }
        push("digitiser.noise_v", self.digitiser.noise_v);
        push("oscillator.rho", self.oscillator.rho);
        push("oscillator.resonance_hz", self.oscillator.resonance_hz);
        push("oscillator.delta", self.oscillator.delta);
        list
    }

    fn plain_values(&self) -> Vec<(&'static str, f64)> {
        let mut list = Vec::new();
        let mut push = |name, value: Option<f64>| list.extend(value.map(|v| (name, v)));
        push("digitiser.sample_rate_hz", self.digitiser.sample_rate_hz);
        push("digitiser.block_samples", self.digitiser.block_samples);
        push("digitiser.full_scale_v", self.digitiser.full_scale_v);
        push("digitiser.bits", self.digitiser.bits);
        push("environment.mains_hz", self.environment.mains_hz);
        list
    }
}
