//! An identification as text.

use super::identification::{Identification, Weighting};
use super::monte_carlo::Spread;
use crate::text::{significant, table, wrap};
use std::fmt::Write;

/// Parameters, test and advice, 80 columns wide.
pub fn report(result: &Identification, spread: Option<&Spread>) -> String {
    let mut text = format!(
        "Accelerometer model by ISO 16063-43, 7.2\n{} frequencies, {}\n\n",
        result.frequencies,
        match result.weighting {
            Weighting::Covariance => "weighted with the covariance of (7)",
            Weighting::None => "unweighted",
        }
    );
    text.push_str(&parameters(result, spread));
    text.push('\n');
    text.push_str(&chi_squared_test(result));
    let deviation = &result.deviation;
    let _ = writeln!(
        text,
        "  points from model: magnitude {} % rms, {} % at most;\n  \
         phase {} deg rms, {} deg at most",
        significant(100.0 * deviation.magnitude_rms_rel, 2),
        significant(100.0 * deviation.magnitude_max_rel, 2),
        significant(deviation.phase_rms_deg, 2),
        significant(deviation.phase_max_deg, 2),
    );
    if !result.warnings.is_empty() {
        text.push_str("\nRemarks\n");
        for warning in &result.warnings {
            text.push_str(&wrap(warning, 2));
        }
    }
    text
}

fn parameters(result: &Identification, spread: Option<&Spread>) -> String {
    let oscillator = &result.oscillator;
    let by_monte_carlo = |pick: fn(&Spread) -> f64| match spread {
        Some(spread) => significant(pick(spread), 2),
        None => "-".into(),
    };
    let row = |name: &str, value: f64, u: f64, drawn: String| {
        vec![
            name.to_owned(),
            significant(value, 7),
            significant(u, 2),
            drawn,
        ]
    };
    table(
        &["parameter", "estimate", "u by (16)", "u by Monte Carlo"],
        &[
            row(
                "S0",
                oscillator.s0,
                result.u_s0,
                by_monte_carlo(|spread| spread.s0.standard_uncertainty),
            ),
            row(
                "f0 / Hz",
                oscillator.f0_hz,
                result.u_f0_hz,
                by_monte_carlo(|spread| spread.f0_hz.standard_uncertainty),
            ),
            row(
                "delta",
                oscillator.delta,
                result.u_delta,
                by_monte_carlo(|spread| spread.delta.standard_uncertainty),
            ),
            row("rho", result.rho, result.u_rho, "-".into()),
        ],
    )
}

fn chi_squared_test(result: &Identification) -> String {
    let (Some(chi2), Some(limit)) = (result.chi2, result.chi2_limit) else {
        return wrap(
            "chi-squared test (37): not possible without uncertainties; those of the parameters \
             follow from the residuals",
            2,
        );
    };
    let numbers = format!(
        "chi-squared {} for {} degrees of freedom, limit {} (37)",
        significant(chi2, 4),
        result.degrees_of_freedom,
        significant(limit, 4)
    );
    match result.consistent {
        Some(true) => wrap(
            &format!("{numbers}: the model is consistent with the data."),
            2,
        ),
        _ => wrap(
            &format!(
                "{numbers}: the model is REJECTED. Either the transducer is no single \
                 mass-spring-damper at this accuracy, or the uncertainties are too small; the \
                 uncertainties of the parameters above must not be used."
            ),
            2,
        ),
    }
}
