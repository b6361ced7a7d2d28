//! What a component contributes to a budget.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// A component with what it contributes.
#[derive(Clone, Debug)]
pub struct EvaluatedComponent {
    /// Name.
    pub label: String,
    /// Half-width or expanded uncertainty, as stated.
    pub value: f64,
    /// Distribution, as the budget file spells it.
    pub distribution: &'static str,
    /// Value over standard uncertainty.
    pub divisor: f64,
    /// Sensitivity coefficient.
    pub sensitivity_coefficient: f64,
    /// Degrees of freedom; may be infinite.
    pub degrees_of_freedom: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
    /// `|c_i| u(x_i)`.
    pub contribution: f64,
    /// Share of the combined variance, covariances halved between partners;
    /// negative when a correlation makes the component compensate others.
    pub variance_share: f64,
}

impl Serialize for EvaluatedComponent {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        component_fields(self, "percent", serializer)
    }
}

fn component_fields<S: Serializer>(
    component: &EvaluatedComponent,
    unit: &str,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let mut map = serializer.serialize_map(None)?;
    map.serialize_entry("label", &component.label)?;
    map.serialize_entry(&format!("value_{unit}"), &component.value)?;
    map.serialize_entry("distribution", component.distribution)?;
    map.serialize_entry("divisor", &component.divisor)?;
    map.serialize_entry(
        "sensitivity_coefficient",
        &component.sensitivity_coefficient,
    )?;
    map.serialize_entry("degrees_of_freedom", &component.degrees_of_freedom)?;
    map.serialize_entry(
        &format!("standard_uncertainty_{unit}"),
        &component.standard_uncertainty,
    )?;
    map.serialize_entry(&format!("contribution_{unit}"), &component.contribution)?;
    map.serialize_entry(
        "variance_share_percent",
        &(100.0 * component.variance_share),
    )?;
    map.end()
}

/// A component of a phase budget: the same fields, in degrees.
pub(super) struct InDegrees<'a>(pub(super) &'a EvaluatedComponent);

impl Serialize for InDegrees<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        component_fields(self.0, "deg", serializer)
    }
}
