//! Where the gap lies.

use super::fit::Workspace;
use super::lack_of_fit::LackOfFit;
use super::problem::Problem;
use super::search::Search;
use crate::answer::{Verdict, Where};
use crate::axis::Axis;
use crate::estimation::significance::two_sided;
use crate::observable::Observable;
use calib_effects::Stage;

/// Where the gap lies: stages in the order of what their effects (or the shape of the structure) explain.
pub(super) fn places(
    problem: &Problem,
    found: &Search,
    nominal: &LackOfFit,
    left: &LackOfFit,
    verdict: Verdict,
    work: &mut Workspace,
) -> Vec<Where> {
    if verdict == Verdict::NoGap {
        return Vec::new();
    }
    let excess =
        (nominal.residual.iter().map(|r| r * r).sum::<f64>() - problem.len() as f64).max(1.0);
    let shape = super::stages::of_ratio(problem, &found.nominal, work);
    let mut places = Vec::new();
    for (stage, share) in super::stages::rank(problem, found, nominal, verdict, work) {
        let (observable, axis, z) = super::stages::evidence(
            stage,
            if places.is_empty() { nominal } else { left },
            nominal,
        );
        let (from, to) = extent(problem, axis, observable, &nominal.residual);
        let tests = nominal.outcomes.len().max(1) as f64;
        places.push(Where {
            stage,
            observable: observable.group().name(),
            axis,
            from,
            to,
            share: (share / excess).clamp(0.0, 1.0),
            p_value: (two_sided(z) * tests).min(1.0),
            class: class(observable, axis),
            shape: shape
                .clone()
                .filter(|_| observable == Observable::Ratio && axis == Axis::Frequency),
        });
    }
    places
}

/// Bumps over frequency that the best set leaves, as places of the stage that comes first.
pub(super) fn local(
    problem: &Problem,
    nominal: &LackOfFit,
    left: &LackOfFit,
    places: &[Where],
) -> Vec<Where> {
    let total = nominal.residual.iter().map(|r| r * r).sum::<f64>();
    let excess = (total - problem.len() as f64).max(1.0);
    let bumps = super::bumps::bumps(problem, &left.residual);
    bumps
        .into_iter()
        .map(|bump| Where {
            stage: places.first().map_or(Stage::Dut, |place| place.stage),
            observable: bump.observable.group().name(),
            axis: Axis::Frequency,
            from: bump.from_hz,
            to: bump.to_hz,
            share: (bump.square / excess).clamp(0.0, 1.0),
            p_value: bump.p_value,
            class: LOCAL,
            shape: None,
        })
        .collect()
}

/// Class of a bump that a few neighbouring frequencies show.
const LOCAL: &str = "local bump";

fn class(observable: Observable, axis: Axis) -> &'static str {
    match (observable.order(), axis) {
        (Some(order), _) if order % 2 == 0 => "even",
        (Some(_), _) => "odd",
        _ if observable.is_noise() => "noise",
        (_, Axis::InverseLevel) => "additive 1/A",
        (_, Axis::Time) => "drift",
        (_, Axis::Level | Axis::Travel | Axis::Amplitude) => "level",
        (_, Axis::Rotation | Axis::Payload | Axis::Temperature) => "condition",
        (_, Axis::Frequency | Axis::CoilVoltage) => "frequency",
    }
}

/// Range of the axis that holds the middle 90 % of the squared residual of an observable.
fn extent(problem: &Problem, axis: Axis, observable: Observable, residual: &[f64]) -> (f64, f64) {
    let value = |at: usize| axis.value(&problem.rows[problem.row_of[at]]);
    let mut list: Vec<(f64, f64)> = problem
        .data_of(observable)
        .map(|at| (value(at), residual[at] * residual[at]))
        .filter(|(v, _)| v.is_finite())
        .collect();
    list.sort_by(|a, b| a.0.total_cmp(&b.0));
    let total: f64 = list.iter().map(|l| l.1).sum();
    let at = |share: f64| {
        let mut sum = 0.0;
        list.iter().find(|(_, w)| {
            sum += w;
            sum >= share * total
        })
    };
    (at(0.05).map_or(0.0, |l| l.0), at(0.95).map_or(0.0, |l| l.0))
}
