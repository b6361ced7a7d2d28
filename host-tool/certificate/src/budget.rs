//! The budget at the reference point, recomputed from the record's settings.
//!
//! The instrument stored U; the certificate prints where it comes from. Both
//! are the same function of calib-core on the same numbers, so they agree to the
//! digits a record keeps; a record whose settings do not give its U is not trusted.

use super::model::{Budget, BudgetRow, Certificate, Remark, Severity, Value};
use calib_core::budget::{Budget as CoreBudget, Component, PointBudget, point_budget};
use calib_core::point::PointResult;
use calib_core::settings::Distribution;
use calib_protocol::record::Record;

/// A record keeps U to 1.6e-5 (upper 24 bits of the f32); sums of squares of
/// host and target differ in the last bits of f32 (6e-8, at most 22 terms).
const STORED_U_REL: f64 = 2.0e-5;
/// A record keeps the repeatability to half a unit of the upper 16 bits.
const STORED_REPEATABILITY_REL: f64 = 1.0 / 512.0;

/// Largest relative difference between stored and recomputed U: that of U, and
/// that of the repeatability by its share of the variance; twice, because the
/// coverage factor follows the degrees of freedom.
fn agreement_rel(budget: &CoreBudget<'_>) -> f64 {
    let square = |component: &Component<'_>| f64::from(component.contribution()).powi(2);
    let of = |repeated: bool| -> f64 {
        let wanted = |c: &&Component<'_>| !repeated || c.degrees_of_freedom.is_finite();
        budget.components().iter().filter(wanted).map(square).sum()
    };
    let share = if of(false) > 0.0 {
        of(true) / of(false)
    } else {
        0.0
    };
    STORED_U_REL + 2.0 * share * STORED_REPEATABILITY_REL
}

/// Recomputes the budget of `point` and compares it with the stored U.
pub(super) fn attach(certificate: &mut Certificate, record: &Record, point: &PointResult) {
    let mut error = |key, values| {
        let severity = Severity::Error;
        certificate.remarks.push(Remark {
            severity,
            key,
            values,
        });
    };
    match recompute(record, point) {
        Err(problem) => error("budget_failed", vec![Value::Text(problem)]),
        Ok((budget, agreement_rel)) => {
            let stored = 100.0 * f64::from(point.expanded_uncertainty_rel);
            if (budget.expanded_percent / stored - 1.0).abs() > agreement_rel {
                let number = |percent| Value::Number(percent, 4, "");
                error(
                    "budget_mismatch",
                    vec![number(budget.expanded_percent), number(stored)],
                );
            }
            certificate.budget = Some(budget);
        }
    }
}

/// Coverage factor of the phase of a point: the record stores that of the
/// magnitude only, the budget of the phase gives its own.
pub(super) fn coverage_factor_phase(record: &Record, point: &PointResult) -> Option<f64> {
    let budget = of_point(record, point).ok()?;
    let (_, phase) = budget.expand().ok()?;
    let ratio = f64::from(phase.expanded_uncertainty / point.expanded_uncertainty_phase_rad);
    let agrees = (ratio - 1.0).abs() <= agreement_rel(&budget.phase);
    agrees.then(|| f64::from(phase.coverage.factor))
}

fn of_point(record: &Record, point: &PointResult) -> Result<PointBudget<'static>, String> {
    let frequency_hz = point.tone.frequency_hz(record.head.sample_rate_hz);
    let reference = record.settings.reference.at(frequency_hz);
    let reference = reference
        .ok_or_else(|| format!("the table of the reference does not reach {frequency_hz} Hz"))?;
    point_budget(&record.settings, &reference, point).map_err(|e| e.to_string())
}

fn recompute(record: &Record, point: &PointResult) -> Result<(Budget, f64), String> {
    let budget = of_point(record, point)?;
    let (expanded, _) = budget.expand().map_err(|e| e.to_string())?;
    let reported = Budget {
        rows: rows(&budget.magnitude),
        combined_percent: 100.0 * f64::from(expanded.standard_uncertainty),
        effective_degrees_of_freedom: f64::from(expanded.effective_degrees_of_freedom),
        coverage_factor: f64::from(expanded.coverage.factor),
        expanded_percent: 100.0 * f64::from(expanded.expanded_uncertainty),
    };
    Ok((reported, agreement_rel(&budget.magnitude)))
}

fn rows(budget: &CoreBudget<'_>) -> Vec<BudgetRow> {
    let mut rows: Vec<BudgetRow> = budget.components().iter().map(row).collect();
    rows.sort_by_key(|row| row.row);
    rows
}

fn row(component: &Component<'_>) -> BudgetRow {
    BudgetRow {
        row: component.row.number,
        value_percent: 100.0 * f64::from(component.value),
        distribution: distribution(component),
        divisor: f64::from(component.distribution.divisor()),
        sensitivity_coefficient: f64::from(component.sensitivity_coefficient),
        contribution_percent: 100.0 * f64::from(component.contribution().abs()),
        degrees_of_freedom: f64::from(component.degrees_of_freedom),
    }
}

/// Message key after `distribution.` and its parameter.
fn distribution(component: &Component<'_>) -> (&'static str, Option<f64>) {
    match component.distribution {
        Distribution::Normal { .. } if component.degrees_of_freedom.is_finite() => {
            ("student", None)
        }
        Distribution::Normal { coverage_factor } => (
            "normal",
            Some(calib_output::number::decimal(coverage_factor)),
        ),
        Distribution::Rectangular => ("rectangular", None),
        Distribution::Triangular => ("triangular", None),
        Distribution::UShaped => ("u_shaped", None),
        Distribution::Special { .. } => ("special", None),
    }
}
