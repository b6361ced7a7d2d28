//! Secondary calibration by comparison of phase angles.
//!
//! The standard of 1993 adds systematic limits linearly and combines them with
//! a random part; the GUM treats each as a rectangular contribution. Both are
//! reported, each under its name.
//!
//! # Source
//! ISO 5347-9:1993, clauses 2, 3, 4 and Annex A.

mod file;
mod limits;
mod report;

pub use file::{PhaseFile, PhasePoint, load, parse};
pub use limits::Limits;
pub use report::report;

use super::budget::{self, Budget, Component, CoverageRule, Distribution, Model, Unit};
use super::statistics::{mean, standard_deviation, student_factor, unwrapped_deg, wrapped_deg};
use schemars::JsonSchema;
use serde::Serialize;

/// Preferred frequencies of clause 3, Hz.
pub const PREFERRED_HZ: [f64; 9] = [
    20.0, 40.0, 80.0, 160.0, 315.0, 630.0, 1250.0, 2500.0, 5000.0,
];

/// Result at one frequency, degrees.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PhaseResult {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Readings.
    pub readings: usize,
    /// Phase of the pick-up: mean difference plus phase of the reference.
    pub phase_deg: f64,
    /// Random uncertainty X_r(95).
    pub x_random_deg: f64,
    /// Systematic uncertainty X_s(95).
    pub x_systematic_deg: f64,
    /// Total uncertainty X_95 by ISO 5347-9.
    pub x95_deg: f64,
    /// Combined standard uncertainty by the GUM.
    pub gum_standard_uncertainty_deg: f64,
    /// Effective degrees of freedom; infinite is `null` in JSON.
    #[schemars(with = "Option<f64>")]
    pub gum_effective_degrees_of_freedom: f64,
    /// Coverage factor for 95 %.
    pub gum_coverage_factor: f64,
    /// Expanded uncertainty by the GUM, 95 %.
    pub gum_expanded_uncertainty_deg: f64,
}

/// Evaluates readings of the phase difference at one frequency.
///
/// There must be at least two readings.
///
/// # Equation
/// `X_95 = sqrt(X_r^2 + X_s^2)`, `X_r = t s / sqrt(n)` with n - 1 degrees of
/// freedom, `X_s = 2 / sqrt(3) (phi_r + phi_p + phi_a)`.
///
/// # Accuracy
/// Test `annex_a_by_hand`.
pub fn evaluate(point: &PhasePoint, limits: &Limits) -> PhaseResult {
    let n = point.readings_deg.len() as f64;
    let readings_deg = unwrapped_deg(&point.readings_deg);
    let of_mean = standard_deviation(&readings_deg) / n.sqrt();
    let x_random_deg = student_factor(0.95, n - 1.0) * of_mean;
    let sum = limits.reference_deg + limits.phasemeter_deg + limits.amplifier_deg;
    let x_systematic_deg = 2.0 / 3.0_f64.sqrt() * sum;
    let gum = budget::evaluate(&gum_budget(of_mean, n - 1.0, limits));
    PhaseResult {
        frequency_hz: point.frequency_hz,
        readings: point.readings_deg.len(),
        phase_deg: wrapped_deg(mean(&readings_deg) + point.reference_phase_deg),
        x_random_deg,
        x_systematic_deg,
        x95_deg: x_random_deg.hypot(x_systematic_deg),
        gum_standard_uncertainty_deg: gum.combined_standard_uncertainty,
        gum_effective_degrees_of_freedom: gum.effective_degrees_of_freedom,
        gum_coverage_factor: gum.coverage_factor,
        gum_expanded_uncertainty_deg: gum.expanded_uncertainty,
    }
}

fn gum_budget(of_mean: f64, degrees_of_freedom: f64, limits: &Limits) -> Budget {
    let rectangular = |label: &str, value: f64| Component {
        label: label.into(),
        value,
        distribution: Distribution::Rectangular,
        sensitivity_coefficient: 1.0,
        degrees_of_freedom: f64::INFINITY,
    };
    Budget {
        measurand: "phase of the pick-up".into(),
        unit: Unit::Degree,
        model: Model::Sum,
        coverage: CoverageRule::Probability(0.95),
        truncate_degrees_of_freedom: false,
        components: vec![
            Component {
                label: "readings".into(),
                value: of_mean,
                distribution: Distribution::Normal {
                    coverage_factor: 1.0,
                },
                sensitivity_coefficient: 1.0,
                degrees_of_freedom,
            },
            rectangular("reference pick-up and amplifier", limits.reference_deg),
            rectangular("phasemeter", limits.phasemeter_deg),
            rectangular("amplifier of the pick-up", limits.amplifier_deg),
        ],
        correlations: Vec::new(),
        remarks: Vec::new(),
    }
}

/// Requirements of clauses 2 and 3 that the data do not fulfil.
pub fn remarks(file: &PhaseFile) -> Vec<String> {
    let mut remarks = Vec::new();
    let limits = &file.limits;
    for (name, value, clause) in [
        (
            "reference pick-up and amplifier",
            limits.reference_deg,
            "2.2",
        ),
        ("phasemeter", limits.phasemeter_deg, "2.5"),
    ] {
        if value > 1.0 {
            remarks.push(format!(
                "{name}: {value} deg is more than the 1 deg of {clause}"
            ));
        }
    }
    let preferred = |f: f64| PREFERRED_HZ.iter().any(|p| (f / p - 1.0).abs() < 0.01);
    let count = file
        .points
        .iter()
        .filter(|p| preferred(p.frequency_hz))
        .count();
    if count < 6 {
        remarks.push(format!(
            "{count} of the preferred frequencies are measured; clause 3 asks for six that cover \
             the range: 20, 40, 80, 160, 315, 630, 1250, 2500, 5000 Hz"
        ));
    }
    for point in &file.points {
        if !preferred(point.frequency_hz) {
            remarks.push(format!(
                "{} Hz is not a preferred frequency (3)",
                point.frequency_hz
            ));
        }
    }
    remarks
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Averaged as numbers, these were 36 degrees with a scatter of 197.
    #[test]
    fn readings_around_half_a_turn_are_averaged_on_the_circle() {
        let limits = Limits {
            reference_deg: 1.0,
            phasemeter_deg: 0.5,
            amplifier_deg: 0.3,
        };
        let evaluated = |readings_deg: &[f64]| {
            let point = PhasePoint {
                frequency_hz: 160.0,
                readings_deg: readings_deg.to_vec(),
                reference_phase_deg: 0.0,
            };
            evaluate(&point, &limits)
        };
        let around = evaluated(&[179.9, -179.9, 179.8, -179.8, 180.0]);
        // The same readings turned by 180 degrees: -0.1, 0.1, -0.2, 0.2, 0.
        let at_zero = evaluated(&[-0.1, 0.1, -0.2, 0.2, 0.0]);
        assert!((around.phase_deg.abs() - 180.0).abs() < 1e-9, "{around:?}");
        assert!((around.x_random_deg - at_zero.x_random_deg).abs() < 1e-9);
        assert!((at_zero.phase_deg).abs() < 1e-12);
    }

    #[test]
    fn annex_a_by_hand() {
        let point = PhasePoint {
            frequency_hz: 160.0,
            readings_deg: vec![-1.0, -1.2, -0.8, -1.1, -0.9],
            reference_phase_deg: 0.5,
        };
        let limits = Limits {
            reference_deg: 1.0,
            phasemeter_deg: 0.5,
            amplifier_deg: 0.3,
        };
        let result = evaluate(&point, &limits);
        assert!((result.phase_deg + 0.5).abs() < 1e-12);
        // Deviations 0, 0.2, 0.2, 0.1, 0.1: squares sum to 0.10; / (5 * 4).
        let random = 2.776_445 * (0.10_f64 / 20.0).sqrt();
        assert!((result.x_random_deg - random).abs() < 1e-6);
        let systematic = 2.0 * 1.8 / 3.0_f64.sqrt();
        assert!((result.x_systematic_deg - systematic).abs() < 1e-12);
        assert!((result.x95_deg - random.hypot(systematic)).abs() < 1e-6);
        // By the GUM: 0.005 + (1 + 0.25 + 0.09) / 3.
        let u = (0.005 + 1.34 / 3.0_f64).sqrt();
        assert!((result.gum_standard_uncertainty_deg - u).abs() < 1e-12);
        assert!(result.gum_expanded_uncertainty_deg < result.x95_deg);
    }
}
