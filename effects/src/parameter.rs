//! A parameter of an entry.

use schemars::JsonSchema;
use serde::Serialize;

/// How a parameter is moved by a fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// By addition.
    Linear,
    /// By factors: positive and of unknown order of magnitude.
    Log,
}

/// A parameter of an effect or a fault.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Parameter {
    /// Name, with its unit as suffix where it has one.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Smallest value that a diagnosis considers.
    pub lower: f64,
    /// Largest value that a diagnosis considers.
    pub upper: f64,
    /// How a fit moves it.
    pub scale: Scale,
    /// Smallest and largest value that a rig file may state.
    pub simulated: [f64; 2],
    /// A value that a good measurement shows clearly. It may be beyond the site size.
    pub usual: f64,
    /// Site size: the range that is plausible on the site of a calibrator, with its reason in
    /// `tests/reality/sizes.toml` where it is drawn. All that can be simulated where that depends on
    /// the unit of a record, or is a time or a choice.
    pub site: [f64; 2],
    /// Whether it chooses between two ways, 0 and 1.
    pub is_switch: bool,
}

impl Parameter {
    pub(crate) const fn linear(
        name: &'static str,
        unit: &'static str,
        bounds: [f64; 2],
        usual: f64,
    ) -> Self {
        Self {
            name,
            unit,
            lower: bounds[0],
            upper: bounds[1],
            scale: Scale::Linear,
            simulated: bounds,
            usual,
            site: bounds,
            is_switch: false,
        }
    }

    pub(crate) const fn log(
        name: &'static str,
        unit: &'static str,
        bounds: [f64; 2],
        usual: f64,
    ) -> Self {
        Self {
            scale: Scale::Log,
            ..Self::linear(name, unit, bounds, usual)
        }
    }

    pub(crate) const fn switch(name: &'static str, unit: &'static str, usual: f64) -> Self {
        Self {
            is_switch: true,
            ..Self::linear(name, unit, [0.0, 1.0], usual)
        }
    }

    /// Its site size.
    pub(crate) const fn on_site(self, lowest: f64, highest: f64) -> Self {
        Self {
            site: [lowest, highest],
            ..self
        }
    }

    /// Bounds of a rig file, where a fit has other ones.
    pub(crate) const fn simulated(self, lowest: f64, highest: f64) -> Self {
        Self {
            simulated: [lowest, highest],
            ..self
        }
    }
}
