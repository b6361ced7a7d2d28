//! Uncertainty of a ratio of two sensitivities, the deviation from the reference point or the change since
//! another calibration: what both results share cancels.
//!
//! # Equation
//! `D = S / S0 - 1`. A row that acts on both points alike leaves of its contributions `u` and `u0` what the
//! larger has beyond the smaller, `u^2 + u0^2 - 2 r min(u, u0)^2`, with r = 1, or what is stated for row 1; any
//! other row counts with both, r = 0.
//!
//! # Source
//! ISO 16063-21:2003, 5.3 and (A.1); GUM 5.2.2.

use calib_core::budget::{Budget, Component, CoverageRule, PROBABILITY_K2, Row};
use calib_core::settings::Distribution;

/// Row of the reference's calibration.
const REFERENCE: u8 = 1;
/// Rows of Table A.1 that are one number for a whole response: calibration of the reference, gain of the
/// conditioner, ratio of the converters, drift of the reference, temperature. What was interpolated, measured or
/// computed for each point has a label of its own and is not meant.
const OF_A_RESPONSE: [u8; 5] = [REFERENCE, 2, 3, 10, 11];
/// Rows that are one number for two calibrations with one reference in one instrument: what drifts, and the
/// temperature, are not.
const OF_AN_INSTRUMENT: [u8; 3] = [REFERENCE, 2, 3];

/// Label of the gain of the sensor's own charge amplifier, or of its burden: one number for a whole response.
pub(super) const OF_CONDITIONER: &str = "gain of the charge amplifier, or burden";
/// Label of the frequency in what is stated of a sensor to velocity or displacement: one clock.
pub(super) const OF_FREQUENCY: &str = "conversion by the frequency";

/// Correlation of a row of Table A.1 between two results.
pub(super) type Correlation = dyn Fn(u8) -> f64;

/// Between two frequencies of one calibration.
pub(super) fn within_a_response(of_reference: f64) -> impl Fn(u8) -> f64 {
    move |row| match row {
        REFERENCE => of_reference,
        row if OF_A_RESPONSE.contains(&row) => 1.0,
        _ => 0.0,
    }
}

/// Between two calibrations in one instrument with one calibration of its reference.
pub(super) fn within_an_instrument(row: u8) -> f64 {
    match OF_AN_INSTRUMENT.contains(&row) {
        true => 1.0,
        false => 0.0,
    }
}

/// Between two devices, one after the other in one channel: the reference has not drifted in between.
pub(super) fn within_a_substitution(row: u8) -> f64 {
    match [1, 2, 3, 10].contains(&row) {
        true => 1.0,
        false => 0.0,
    }
}

const STANDARD: Distribution = Distribution::Normal {
    coverage_factor: 1.0,
};

/// Expanded uncertainty of a ratio of two sensitivities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OfRatio {
    /// Relative to the ratio.
    pub(super) expanded_rel: f64,
    /// Its coverage factor.
    pub(super) coverage_factor: f64,
}

/// U of `S / S0` from the budgets of both points; none when they give none.
pub(super) fn of_ratio(
    point: &Budget<'_>,
    reference: &Budget<'_>,
    correlation: &Correlation,
) -> Option<OfRatio> {
    let expanded = left_of(point, reference, correlation)?
        .expand(CoverageRule::Probability(PROBABILITY_K2))
        .ok()?;
    Some(OfRatio {
        expanded_rel: f64::from(expanded.expanded_uncertainty),
        coverage_factor: f64::from(expanded.coverage.factor),
    })
}

/// Components left in the ratio of two results of both their budgets; none where it does not fit into one.
pub(super) fn left_of(
    point: &Budget<'_>,
    reference: &Budget<'_>,
    correlation: &Correlation,
) -> Option<Budget<'static>> {
    let mut left = Budget::new();
    let mut others = reference.components().to_vec();
    for own in point.components() {
        let twin = others.iter().position(|other| is_same(own, other));
        let other = twin.map(|at| others.swap_remove(at));
        add(&mut left, own, other.as_ref(), correlation)?;
    }
    for other in &others {
        add(&mut left, other, None, correlation)?;
    }
    Some(left)
}

fn is_same(a: &Component<'_>, b: &Component<'_>) -> bool {
    a.row == b.row && a.label == b.label
}

fn add(
    left: &mut Budget<'_>,
    own: &Component<'_>,
    other: Option<&Component<'_>>,
    correlation: &Correlation,
) -> Option<()> {
    let of = |component: &Component<'_>| f64::from(component.contribution()).abs();
    let (u, u0) = (of(own), other.map_or(0.0, of));
    let mut add = |contribution: f64, degrees_of_freedom: f32| {
        let row = Row::a1(own.row.number);
        let component = Component::new(row, contribution as f32, STANDARD);
        left.add(component.with_degrees_of_freedom(degrees_of_freedom))
            .ok()
    };
    // Scatter is evaluated at each point, with degrees of freedom of its own.
    if let Some(other) = other.filter(|_| own.degrees_of_freedom.is_finite()) {
        add(u, own.degrees_of_freedom)?;
        add(u0, other.degrees_of_freedom)?;
        return Some(());
    }
    let shared = match own.label {
        OF_CONDITIONER | OF_FREQUENCY => 1.0,
        label if label == own.row.source() => correlation(own.row.number),
        _ => 0.0,
    };
    let variance = u * u + u0 * u0 - 2.0 * shared * u.min(u0).powi(2);
    add(variance.max(0.0).sqrt(), own.degrees_of_freedom)?;
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn budget(rows: &[(u8, f32, f32)]) -> Budget<'static> {
        let mut budget = Budget::new();
        for &(row, contribution, degrees) in rows {
            let component = Component::new(Row::a1(row), contribution, STANDARD);
            let component = component.with_degrees_of_freedom(degrees);
            budget.add(component).expect("valid");
        }
        budget
    }

    const INFINITE: f32 = f32::INFINITY;

    /// By hand: row 1 leaves sqrt(0.5^2 - 0.3^2) = 0.4 %, row 2 nothing, row 6 sqrt(0.1^2 + 0.2^2) = 0.2236 %,
    /// scatter sqrt(2) 0.01 %: u = 0.4585 %.
    #[test]
    fn what_both_points_share_cancels() {
        let reference = budget(&[
            (1, 0.003, INFINITE),
            (2, 0.002, INFINITE),
            (6, 0.001, INFINITE),
            (18, 1.0e-4, 9.0),
        ]);
        let point = budget(&[
            (1, 0.005, INFINITE),
            (2, 0.002, INFINITE),
            (6, 0.002, INFINITE),
            (18, 1.0e-4, 9.0),
        ]);
        let found = of_ratio(&point, &reference, &within_a_response(1.0)).expect("a budget");
        let u = (0.16e-4_f64 + 0.05e-4 + 2.0e-8).sqrt();
        assert!(
            (found.expanded_rel / (2.0 * u) - 1.0).abs() < 1e-4,
            "{found:?}"
        );
        // Nothing of the reference's calibration cancels: 0.34e-4 in place of 0.16e-4.
        let none = of_ratio(&point, &reference, &within_a_response(0.0)).expect("a budget");
        let u = (0.34e-4_f64 + 0.05e-4 + 2.0e-8).sqrt();
        assert!(
            (none.expanded_rel / (2.0 * u) - 1.0).abs() < 1e-4,
            "{none:?}"
        );
    }

    /// A row that only one point has stays, and rows of other names are not shared.
    #[test]
    fn what_is_no_row_of_both_counts_in_full() {
        let reference = budget(&[(6, 0.001, INFINITE)]);
        let mut point = budget(&[(6, 0.001, INFINITE)]);
        let label = "interpolation in the table of the reference";
        let interpolated = Component::new(Row::a1(1), 0.002, STANDARD).labelled(label);
        point.add(interpolated).expect("valid");
        let u = (2.0e-6_f64 + 4.0e-6).sqrt();
        for (a, b) in [(&point, &reference), (&reference, &point)] {
            let found = of_ratio(a, b, &within_a_response(1.0)).expect("a budget");
            assert!(
                (found.expanded_rel / (2.0 * u) - 1.0).abs() < 1e-4,
                "{found:?}"
            );
        }
    }
}
