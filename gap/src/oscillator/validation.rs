//! A fitted oscillator on another record: only the state at its start is fitted.

use super::fit::Fitted;
use super::model::{VALUES, states};
use super::residual::{SETTLING, residual};
use super::run::Run;
use super::simulate::simulate;
use super::slopes::normal;
use nalgebra::{Cholesky, DVector};

/// Samples at the start of which the states are fitted.
const HEAD: usize = 400;
/// Samples that each step looks at; SETTLING samples take part here only. A few of them first:
/// over many periods a bent spring's phase has more than one solution.
const LOOKED_AT: [usize; 6] = [
    SETTLING / 4,
    SETTLING / 4,
    SETTLING / 2,
    SETTLING,
    SETTLING,
    SETTLING,
];
/// Change of a state for its slope.
const NUDGE: f64 = 1e-6;

/// Simulation errors on another record; `None` where the simulation diverges.
pub(crate) fn validation(fit: &Fitted, record: &Run) -> Option<Vec<f64>> {
    let head = record.head(HEAD);
    let mut values = fit.values;
    let states = states(&fit.terms);
    states.iter().for_each(|state| values[*state] = 0.0);
    (values[4], values[5]) = head.first_state(values[0]);
    for count in LOOKED_AT {
        let step = step(&values, &head, &states, count)?;
        for (state, change) in states.iter().zip(step.iter()) {
            values[*state] += change;
        }
    }
    residual(&values, record)
}

/// Change of the states that explains the first samples best.
fn step(
    values: &[f64; VALUES],
    head: &Run,
    states: &[usize],
    count: usize,
) -> Option<DVector<f64>> {
    let here = simulate(values, head)?;
    let errors = head.output.iter().zip(&here).take(count);
    let left: Vec<f64> = errors.map(|(m, s)| m - s).collect();
    let of = |&state: &usize| {
        let mut there = *values;
        there[state] += NUDGE;
        let moved = simulate(&there, head)?;
        let change = moved.iter().zip(&here).take(count);
        Some(change.map(|(a, b)| (a - b) / NUDGE).collect())
    };
    let columns: Vec<Vec<f64>> = states.iter().map(of).collect::<Option<_>>()?;
    let (matrix, gradient) = normal(&columns, &left);
    Some(Cholesky::new(matrix)?.solve(&gradient))
}
