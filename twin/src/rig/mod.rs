//! The rig file: every parameter of the simulated calibrator, in SI units.
//!
//! A rig is plain data, read from TOML. [`Rig::standard`] is the one of the demo, [`Rig::draw`] gives
//! another device under test and another plant of the same kind.

mod certificate;
mod common_source;
mod converter;
mod draw;
mod error;
mod exciter;
mod file;
mod model;
mod range;
mod reciprocity;
mod sensing;
mod surroundings;
mod validate;

use serde::{Deserialize, Serialize};

use crate::effects::ActiveEffect;
use crate::effects::fault::ActiveFault;
use crate::model::Reciprocity;

pub use certificate::Certificate;
pub use common_source::CommonSource;
pub use converter::{Amplifier, Converter};
pub use error::RigError;
pub use exciter::Exciter;
pub use file::STANDARD_RIG_TOML;
pub use sensing::Sensing;
pub use surroundings::Surroundings;

/// A calibrator with its device under test: the truth of a simulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rig {
    /// A name for people.
    pub name: String,
    /// Seed of the noise; two runs with the same seed give the same codes. At most 2^63 - 1, the
    /// largest integer of TOML.
    pub noise_seed: u64,
    /// Converters and the filters beside them.
    pub converter: Converter,
    /// Power amplifier.
    pub amplifier: Amplifier,
    /// Electrodynamic exciter.
    pub exciter: Exciter,
    /// Reference transducer with its conditioner.
    pub reference: Sensing,
    /// Device under test with its conditioner.
    pub dut: Sensing,
    /// Certificate of the reference's own calibration.
    pub certificate: Certificate,
    /// Effects of this rig, each as `NAME` or `NAME=PARAM:VALUE,PARAM:VALUE`; may be left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub effects: Vec<ActiveEffect>,
    /// Faults of this rig, in the same form; may be left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub faults: Vec<ActiveFault>,
    /// Coil sensing and an added mass in place of the device under test; may be left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reciprocity: Option<Reciprocity>,
    /// Under which conditions it works; may be left out.
    #[serde(default, skip_serializing_if = "Surroundings::are_usual")]
    pub surroundings: Surroundings,
}
