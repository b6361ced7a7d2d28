//! Beliefs of the simulation about a rig: nominal values with standard uncertainties.

use serde::{Deserialize, Serialize};

use crate::model::CoilModel;

/// A value and its standard uncertainty in the same unit; 0 is exact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quantity {
    /// Best estimate.
    pub value: f64,
    /// Standard uncertainty.
    pub u: f64,
}

/// A transducer with its conditioner.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Transducer {
    /// Sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: Quantity,
}

/// Voltage-driven moving coil.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exciter {
    /// Armature without payload, kg.
    pub moving_mass_kg: Quantity,
    /// Suspension stiffness, N/m.
    pub stiffness_n_per_m: Quantity,
    /// Viscous damping, N s/m.
    pub damping_ns_per_m: Quantity,
    /// Force factor, N/A.
    pub force_factor_n_per_a: Quantity,
    /// Coil resistance, ohm.
    pub coil_resistance_ohm: Quantity,
    /// Coil inductance at 1 kHz, H.
    pub coil_inductance_h: Quantity,
}

impl Exciter {
    /// The linear coil of the nominal values with `payload_kg` mounted.
    pub fn model(&self, payload_kg: f64) -> CoilModel {
        CoilModel {
            mass_kg: self.moving_mass_kg.value + payload_kg,
            stiffness_n_per_m: self.stiffness_n_per_m.value,
            damping_ns_per_m: self.damping_ns_per_m.value,
            force_factor_n_per_a: self.force_factor_n_per_a.value,
            resistance_ohm: self.coil_resistance_ohm.value,
            inductance_h: self.coil_inductance_h.value,
            ..CoilModel::LINEAR
        }
    }
}

/// Relative standard deviations of one draw per run, shared by all its rows.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Repeatability {
    /// Gain of the reference channel.
    pub reference_gain: f64,
    /// Gain of the device's channel.
    pub dut_gain: f64,
}

/// Digitiser of both channels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Digitiser {
    /// Sample rate, Hz.
    pub sample_rate_hz: f64,
    /// Samples of a block.
    pub block_samples: f64,
    /// Full scale, V peak.
    pub full_scale_v: f64,
    /// Resolution, bits.
    pub bits: f64,
    /// Noise of a healthy channel, V r.m.s.
    pub noise_v: Quantity,
}

/// Surroundings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Environment {
    /// Temperature at which the sensitivities hold, degC.
    pub reference_temperature_c: f64,
    /// Frequency of the mains, Hz.
    pub mains_hz: f64,
}

/// `rig.toml` of a calibrator's dataset.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Nominal {
    /// Always `calibrator`.
    pub kind: String,
    /// The constant factor that is never known beforehand.
    pub measurand: String,
    /// Reference.
    pub reference: Transducer,
    /// Device under test, from its data sheet.
    pub dut: Transducer,
    /// Exciter.
    pub exciter: Exciter,
    /// Values common to a run.
    pub repeatability: Repeatability,
    /// Digitiser.
    pub digitiser: Digitiser,
    /// Surroundings.
    pub environment: Environment,
}

/// Why a nominal rig was not accepted.
#[derive(Debug, thiserror::Error)]
pub enum NominalError {
    /// No TOML of this shape.
    #[error("rig file {file} is not understood: {source}")]
    Malformed {
        /// File as it was named.
        file: String,
        /// Line, column and reason.
        source: Box<toml::de::Error>,
    },
    /// A value no rig has.
    #[error("rig file {file}: {parameter} = {value} must be {range}")]
    OutOfRange {
        /// File as it was named.
        file: String,
        /// Table and key.
        parameter: &'static str,
        /// The value.
        value: f64,
        /// Requirement.
        range: &'static str,
    },
}

impl Nominal {
    /// The rig of the format's description: a small calibrator.
    pub fn standard() -> Self {
        let q = |value, u| Quantity { value, u };
        Self {
            kind: "calibrator".to_owned(),
            measurand: "dut_sensitivity".to_owned(),
            reference: Transducer {
                sensitivity_v_per_ms2: q(0.0102, 0.00003),
            },
            dut: Transducer {
                sensitivity_v_per_ms2: q(0.0100, 0.0005),
            },
            exciter: Exciter {
                moving_mass_kg: q(0.050, 0.0005),
                stiffness_n_per_m: q(8000.0, 400.0),
                damping_ns_per_m: q(3.0, 0.6),
                force_factor_n_per_a: q(7.0, 0.2),
                coil_resistance_ohm: q(4.0, 0.05),
                coil_inductance_h: q(0.00012, 0.00001),
            },
            repeatability: Repeatability {
                reference_gain: 0.0002,
                dut_gain: 0.0002,
            },
            digitiser: Digitiser {
                sample_rate_hz: 51_200.0,
                block_samples: 16_384.0,
                full_scale_v: 5.0,
                bits: 16.0,
                noise_v: q(4e-5, 4e-7),
            },
            environment: Environment {
                reference_temperature_c: 23.0,
                mains_hz: 50.0,
            },
        }
    }

    /// Reads a nominal rig; `file` is for messages.
    ///
    /// # Errors
    /// [`NominalError`], naming key and range. Every table is needed: a simulation cannot guess.
    pub fn parse(text: &str, file: &str) -> Result<Self, NominalError> {
        let nominal: Self = toml::from_str(text).map_err(|source| NominalError::Malformed {
            file: file.to_owned(),
            source: Box::new(source),
        })?;
        nominal.check(file)?;
        Ok(nominal)
    }

    /// The text of `rig.toml`.
    ///
    /// # Errors
    /// A value TOML cannot hold, which a checked rig does not have.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        toml::to_string(self)
    }

    fn check(&self, file: &str) -> Result<(), NominalError> {
        let fail = |parameter, value, range| {
            Err(NominalError::OutOfRange {
                file: file.to_owned(),
                parameter,
                value,
                range,
            })
        };
        for (parameter, quantity) in self.quantities() {
            if !(quantity.value.is_finite() && quantity.value > 0.0) {
                return fail(parameter, quantity.value, "positive");
            }
            // Three standard uncertainties are drawn at most: the rig must stay a rig.
            if !(0.0..0.3 * quantity.value).contains(&quantity.u) {
                return fail(
                    parameter,
                    quantity.u,
                    "an uncertainty below 30 % of the value",
                );
            }
        }
        for (parameter, value) in self.plain_values() {
            if !(value.is_finite() && value > 0.0) {
                return fail(parameter, value, "positive");
            }
        }
        for (parameter, value) in [
            (
                "repeatability.reference_gain",
                self.repeatability.reference_gain,
            ),
            ("repeatability.dut_gain", self.repeatability.dut_gain),
        ] {
            if !(0.0..0.3).contains(&value) {
                return fail(parameter, value, "from 0 to 0.3");
            }
        }
        Ok(())
    }

    fn quantities(&self) -> [(&'static str, Quantity); 9] {
        let exciter = &self.exciter;
        [
            (
                "reference.sensitivity_v_per_ms2",
                self.reference.sensitivity_v_per_ms2,
            ),
            ("dut.sensitivity_v_per_ms2", self.dut.sensitivity_v_per_ms2),
            ("exciter.moving_mass_kg", exciter.moving_mass_kg),
            ("exciter.stiffness_n_per_m", exciter.stiffness_n_per_m),
            ("exciter.damping_ns_per_m", exciter.damping_ns_per_m),
            ("exciter.force_factor_n_per_a", exciter.force_factor_n_per_a),
            ("exciter.coil_resistance_ohm", exciter.coil_resistance_ohm),
            ("exciter.coil_inductance_h", exciter.coil_inductance_h),
            ("digitiser.noise_v", self.digitiser.noise_v),
        ]
    }

    fn plain_values(&self) -> [(&'static str, f64); 5] {
        let digitiser = &self.digitiser;
        [
            ("digitiser.sample_rate_hz", digitiser.sample_rate_hz),
            ("digitiser.block_samples", digitiser.block_samples),
            ("digitiser.full_scale_v", digitiser.full_scale_v),
            ("digitiser.bits", digitiser.bits),
            ("environment.mains_hz", self.environment.mains_hz),
        ]
    }
}
