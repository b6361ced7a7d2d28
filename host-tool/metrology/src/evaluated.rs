//! An evaluated budget for programs: relative values are fractions, phases degrees.
//!
//! A budget is relative or of a phase, so its keys name no unit; `unit` does.

use super::budget::{Evaluation, Unit};
use super::monte_carlo::Comparison;
use schemars::JsonSchema;
use serde::Serialize;

/// An evaluated budget.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct EvaluationView {
    #[serde(flatten)]
    evaluation: Evaluation,
    /// Propagated distributions beside the budget, where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    monte_carlo: Option<Comparison>,
}

impl EvaluationView {
    /// The budget and, where they were drawn, the propagated distributions.
    pub fn new(evaluation: &Evaluation, monte_carlo: Option<&Comparison>) -> Self {
        let scale = match evaluation.unit {
            Unit::Percent => 0.01,
            Unit::Degree => 1.0,
        };
        let mut view = Self {
            evaluation: evaluation.clone(),
            monte_carlo: monte_carlo.cloned(),
        };
        let Evaluation {
            components,
            combined_standard_uncertainty,
            expanded_uncertainty,
            improve_first,
            ..
        } = &mut view.evaluation;
        let of_component = components.iter_mut().flat_map(|component| {
            [
                &mut component.value,
                &mut component.standard_uncertainty,
                &mut component.contribution,
            ]
        });
        let halved = improve_first.iter_mut();
        of_component
            .chain([combined_standard_uncertainty, expanded_uncertainty])
            .chain(halved.map(|improvement| &mut improvement.expanded_uncertainty_if_halved))
            .chain(view.monte_carlo.iter_mut().flat_map(Comparison::values_mut))
            .for_each(|value| *value *= scale);
        view
    }
}
