//! `rig.toml`: nominal values, each with a standard uncertainty.

use super::exciter::{ExciterParameters, Quantity};
use serde::Deserialize;

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
