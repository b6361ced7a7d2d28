//! What the library says about an effect.

use serde::Serialize;

/// Part of the measuring chain in which an effect sits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// Device under test.
    Dut,
    /// Reference transducer.
    Reference,
    /// Between table and transducers.
    Mount,
    /// Amplifiers and filters between transducer and converter.
    Conditioning,
    /// Converter and its clock.
    Digitiser,
    /// Moving coil and suspension.
    Exciter,
    /// Power amplifier.
    Amplifier,
    /// What comes from outside.
    Environment,
}

impl Stage {
    /// Name as in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Dut => "dut",
            Self::Reference => "reference",
            Self::Mount => "mount",
            Self::Conditioning => "conditioning",
            Self::Digitiser => "digitiser",
            Self::Exciter => "exciter",
            Self::Amplifier => "amplifier",
            Self::Environment => "environment",
        }
    }
}

/// How a parameter is moved by a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// By addition.
    Linear,
    /// By factors: positive and of unknown order of magnitude.
    Log,
}

/// A parameter of an effect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Parameter {
    /// Name with its unit as suffix.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Smallest physical value.
    pub lower: f64,
    /// Largest physical value.
    pub upper: f64,
    /// How a fit moves it.
    pub scale: Scale,
}

impl Parameter {
    pub(crate) const fn linear(
        name: &'static str,
        unit: &'static str,
        lower: f64,
        upper: f64,
    ) -> Self {
        Self {
            name,
            unit,
            lower,
            upper,
            scale: Scale::Linear,
        }
    }

    pub(crate) const fn log(
        name: &'static str,
        unit: &'static str,
        lower: f64,
        upper: f64,
    ) -> Self {
        Self {
            scale: Scale::Log,
            ..Self::linear(name, unit, lower, upper)
        }
    }
}

/// Description of one effect.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct About {
    /// Name in the library, on the command line and in JSON.
    pub id: &'static str,
    /// Where it sits.
    pub stage: Stage,
    /// First-order shape; r = dut/ref, d = ref/coil voltage, z = coil voltage/current.
    pub formula: &'static str,
    /// Parameters with units and bounds.
    pub parameters: &'static [Parameter],
    /// Columns of a dataset that reveal it.
    pub columns: &'static [&'static str],
    /// Effects it is mistaken for.
    pub confused_with: &'static [&'static str],
    /// The measurement that tells it from those.
    pub separate_by: &'static str,
}
