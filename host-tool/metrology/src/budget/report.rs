//! A budget as text: the shape of Table D.1, and what to do about it.

use super::{CoverageBasis, EvaluatedComponent, Evaluation};
use crate::text::{bar, cell, significant, wrap};
use std::fmt::Write;

/// The evaluated budget as a table, 80 columns wide.
pub fn report(evaluation: &Evaluation) -> String {
    let mut text = format!("Uncertainty budget: {}\n\n", evaluation.measurand);
    let unit = evaluation.unit.symbol();
    let _ = writeln!(
        text,
        "  {:<28} {:>8}  {:<11} {:>7} {:>6} {:>9}",
        "component",
        format!("value/{unit}"),
        "distrib.",
        "divisor",
        "c",
        format!("u_i/{unit}"),
    );
    for component in &evaluation.components {
        text.push_str(&line(component));
    }
    text.push('\n');
    text.push_str(&result(evaluation));
    text.push_str("\nShare of the combined variance\n");
    text.push_str(&shares(evaluation));
    text.push_str(&advice(evaluation));
    if !evaluation.remarks.is_empty() {
        text.push_str("\nRemarks\n");
        for remark in &evaluation.remarks {
            text.push_str(&wrap(remark, 2));
        }
    }
    text
}

fn line(component: &EvaluatedComponent) -> String {
    format!(
        "  {} {:>8}  {:<11} {:>7} {:>6} {:>9}\n",
        cell(&component.label, 28),
        significant(component.value, 3),
        component.distribution,
        format!("{:.4}", component.divisor),
        significant(component.sensitivity_coefficient, 3),
        significant(component.contribution, 3),
    )
}

fn result(evaluation: &Evaluation) -> String {
    let unit = evaluation.unit.symbol();
    let freedom = evaluation.effective_degrees_of_freedom;
    let freedom = match freedom.is_finite() {
        true => format!("{freedom:.1}"),
        false => "infinite".into(),
    };
    format!(
        "  combined standard uncertainty u {:>10} {unit}\n\
         \x20 effective degrees of freedom    {:>10}\n\
         \x20 coverage factor k               {:>10.2}    {}\n\
         \x20 expanded uncertainty U = k u    {:>10} {unit}\n",
        significant(evaluation.combined_standard_uncertainty, 3),
        freedom,
        evaluation.coverage_factor,
        basis(evaluation),
        significant(evaluation.expanded_uncertainty, 3),
    )
}

fn basis(evaluation: &Evaluation) -> String {
    let percent = significant(100.0 * evaluation.coverage_probability, 4);
    match evaluation.coverage_basis {
        CoverageBasis::Stated => "as stated".into(),
        CoverageBasis::Normal => "normal, about 95 %".into(),
        CoverageBasis::StudentT => format!("Student's t, {percent} %"),
        CoverageBasis::Rectangular => format!("dominant rectangular, {percent} %"),
        CoverageBasis::Trapezoidal => format!("dominant trapezoidal, {percent} %"),
        CoverageBasis::UShaped => format!("dominant u-shaped, {percent} %"),
        CoverageBasis::Triangular => format!("dominant triangular, {percent} %"),
    }
}

fn shares(evaluation: &Evaluation) -> String {
    let mut order: Vec<&EvaluatedComponent> = evaluation.components.iter().collect();
    order.sort_by(|a, b| b.variance_share.total_cmp(&a.variance_share));
    order
        .iter()
        .filter(|component| component.variance_share.abs() >= 0.0005)
        .map(|component| {
            let share = 100.0 * component.variance_share;
            let line = format!(
                "  {} {share:>5.1} % {}",
                cell(&component.label, 28),
                bar(component.variance_share, 40)
            );
            format!("{}\n", line.trim_end())
        })
        .collect()
}

fn advice(evaluation: &Evaluation) -> String {
    let mut text = String::from("\nImprove first\n");
    for improvement in &evaluation.improve_first {
        let _ = writeln!(
            text,
            "  {} halved gives U = {} {} (now {})",
            cell(&improvement.label, 28),
            significant(improvement.expanded_uncertainty_if_halved, 3),
            evaluation.unit.symbol(),
            significant(evaluation.expanded_uncertainty, 3),
        );
    }
    text
}
