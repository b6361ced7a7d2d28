//! A shock identification as text.

use super::fit::ShockIdentification;
use crate::text::{significant, table, wrap};
use std::fmt::Write;

/// Parameters, discrete parameters with rate and mapping, and tests.
pub fn report(result: &ShockIdentification) -> String {
    let oscillator = &result.oscillator;
    let row = |name: &str, value: f64, u: f64| {
        vec![name.to_owned(), significant(value, 8), significant(u, 2)]
    };
    let mut text = format!(
        "Accelerometer model by ISO 16063-43, 7.3\n{} bins, {} Hz to {} Hz\n\n",
        result.frequencies,
        significant(result.range.from_hz, 5),
        significant(result.range.to_hz, 5)
    );
    text.push_str(&table(
        &["parameter", "estimate", "u by (36)"],
        &[
            row("S0", oscillator.s0, result.u_s0),
            row("f0 / Hz", oscillator.f0_hz, result.u_f0_hz),
            row("delta", oscillator.delta, result.u_delta),
            row("b", result.discrete.b, result.u_discrete.b),
            row("c1", result.discrete.c1, result.u_discrete.c1),
            row("c2", result.discrete.c2, result.u_discrete.c2),
        ],
    ));
    text.push_str(&wrap(
        &format!(
            "b, c1, c2 hold only for {} S/s and {} (9.2).",
            significant(result.sample_rate_hz, 7),
            result.mapping_formula
        ),
        2,
    ));
    text.push('\n');
    text.push_str(&wrap(&test(result), 2));
    match (result.simulation_rms_rel, result.simulation_max_rel) {
        (Some(rms), Some(most)) => {
            let _ = writeln!(
                text,
                "  forward simulation (8.4.2): {} % rms, {} % at most, of the peak",
                significant(100.0 * rms, 2),
                significant(100.0 * most, 2)
            );
        }
        _ => text.push_str("  forward simulation (8.4.2): not possible, delta is not positive\n"),
    }
    let _ = writeln!(
        text,
        "  peak ratio of this shock: {}, {} % from S0",
        significant(result.peak_ratio, 5),
        significant(100.0 * (result.peak_ratio / oscillator.s0 - 1.0), 2)
    );
    for warning in &result.warnings {
        text.push_str(&wrap(&format!("Remark: {warning}."), 2));
    }
    text
}

fn test(result: &ShockIdentification) -> String {
    let numbers = format!(
        "chi-squared {} for {} degrees of freedom",
        significant(result.chi2, 4),
        result.degrees_of_freedom
    );
    match result.consistent {
        None => format!(
            "chi-squared test: not applicable, u0 = {} was taken from the residuals (8.5.3); \
             state --u0 from a budget to test the model.",
            significant(result.u0, 3)
        ),
        Some(true) => format!("{numbers}: the model is consistent with the record."),
        Some(false) => format!("{numbers}: the model is REJECTED."),
    }
}
