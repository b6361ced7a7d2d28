//! Does the first-order budget hold? The comparison of GUM-S1 8.2.

use super::adaptive::Outcome;
use super::tolerance::numerical_tolerance;
use crate::budget::{Evaluation, Unit};
use crate::text::{significant, wrap};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;

/// Propagated distributions (GUM-S1) and the comparison with the budget.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "PropagatedView")]
pub struct Comparison {
    /// The propagated distributions.
    #[serde(flatten)]
    pub outcome: Outcome,
    /// Tolerance of the comparison (GUM-S1 7.9.2).
    pub tolerance: f64,
    /// Distance of the lower interval ends.
    pub d_low: f64,
    /// Distance of the upper interval ends.
    pub d_high: f64,
    /// Both distances within the tolerance.
    pub first_order_valid: bool,
    /// Why not, and which interval to report.
    pub statement: String,
}

impl Comparison {
    /// Values in the unit of the budget.
    pub(crate) fn values_mut(&mut self) -> [&mut f64; 10] {
        let of = &mut self.outcome;
        [
            &mut of.numerical_tolerance,
            &mut of.estimate,
            &mut of.standard_uncertainty,
            &mut of.symmetric_interval.low,
            &mut of.symmetric_interval.high,
            &mut of.shortest_interval.low,
            &mut of.shortest_interval.high,
            &mut self.tolerance,
            &mut self.d_low,
            &mut self.d_high,
        ]
    }
}

/// Compares `estimate +- U` with the probabilistically symmetric interval.
///
/// `digits` are the digits of the standard uncertainty that matter, 1 or 2;
/// the trials should have been drawn to one digit more (a fifth of the
/// tolerance, GUM-S1 8.2 Note 2).
pub fn validate(evaluation: &Evaluation, outcome: &Outcome, digits: u32) -> Comparison {
    let expanded = evaluation.expanded_uncertainty;
    let tolerance = numerical_tolerance(evaluation.combined_standard_uncertainty, digits);
    let d_low = (-expanded - outcome.symmetric_interval.low).abs();
    let d_high = (expanded - outcome.symmetric_interval.high).abs();
    let first_order_valid = d_low <= tolerance && d_high <= tolerance;
    Comparison {
        outcome: *outcome,
        tolerance,
        d_low,
        d_high,
        first_order_valid,
        statement: statement(evaluation, outcome, d_low, d_high, tolerance),
    }
}

fn statement(
    evaluation: &Evaluation,
    outcome: &Outcome,
    d_low: f64,
    d_high: f64,
    tolerance: f64,
) -> String {
    let unit = evaluation.unit.symbol();
    let percent = significant(100.0 * outcome.coverage_probability, 4);
    if d_low <= tolerance && d_high <= tolerance {
        return format!(
            "The first-order result is valid at {percent} %: both interval ends agree within {} {unit}.",
            significant(tolerance, 2)
        );
    }
    format!(
        "The first-order result is NOT valid at {percent} %: its interval ends are off by {} and \
         {} {unit}, more than {} {unit}. Report the interval {} .. {} {unit} found by Monte Carlo \
         instead.",
        significant(d_low, 2),
        significant(d_high, 2),
        significant(tolerance, 2),
        significant(outcome.symmetric_interval.low, 3),
        significant(outcome.symmetric_interval.high, 3),
    )
}

/// The comparison as text.
pub fn report(comparison: &Comparison, unit: Unit) -> String {
    let outcome = &comparison.outcome;
    let symbol = unit.symbol();
    let percent = significant(100.0 * outcome.coverage_probability, 4);
    let mut text = format!(
        "\nMonte Carlo (GUM Supplement 1): {} trials, seed {}{}\n",
        outcome.trials,
        outcome.seed,
        match outcome.stable {
            true => "",
            false => ", stopped before it was stable",
        }
    );
    let mut line = |name: &str, value: String| {
        let _ = writeln!(text, "  {name:<34} {value} {symbol}");
    };
    line("mean deviation", significant(outcome.estimate, 2));
    line(
        "standard uncertainty",
        significant(outcome.standard_uncertainty, 3),
    );
    for (name, interval) in [
        ("symmetric interval", outcome.symmetric_interval),
        ("shortest interval", outcome.shortest_interval),
    ] {
        line(
            &format!("{name}, {percent} %"),
            format!(
                "{} .. {}",
                significant(interval.low, 3),
                significant(interval.high, 3)
            ),
        );
    }
    text.push_str(&wrap(&comparison.statement, 2));
    text
}
