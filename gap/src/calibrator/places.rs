//! Where the gap lies.

use super::fit::Workspace;
use super::lack_of_fit::LackOfFit;
use super::problem::Problem;
use super::search::Search;
use crate::answer::{Remainder, Verdict, Where};
use crate::axis::Axis;
use crate::estimation::significance::two_sided;
use crate::observable::{Group, Observable};
use crate::thresholds;
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
    if matches!(verdict, Verdict::NoGap | Verdict::Data) {
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
            observable: observable.group(),
            axis,
            or_along: inseparable(problem, axis, observable),
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
            observable: bump.observable.group(),
            axis: Axis::Frequency,
            or_along: Vec::new(),
            from: bump.from_hz,
            to: bump.to_hz,
            share: (bump.square / excess).clamp(0.0, 1.0),
            p_value: bump.p_value,
            class: LOCAL,
            shape: None,
        })
        .collect()
}

/// Remainder of the leading set, in the group of observables with most of it; none where it is noise.
pub(super) fn remainder(
    problem: &Problem,
    left: &LackOfFit,
    verdict: Verdict,
) -> Option<Remainder> {
    if !matches!(verdict, Verdict::PartlyExplained | Verdict::Unexplained) {
        return None;
    }
    let excess = |group: Group| {
        let left = &left.residual[problem.data_of_group(group)];
        left.iter().map(|r| r * r - 1.0).sum::<f64>()
    };
    let groups = Group::ALL.into_iter();
    let measured = groups.filter(|group| !problem.data_of_group(*group).is_empty());
    let group = measured.max_by(|a, b| excess(*a).total_cmp(&excess(*b)))?;
    let outcomes = left.outcomes.iter();
    let inside = outcomes.filter(|outcome| outcome.observable.group() == group);
    let strongest = inside.max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
    let first = group.observables().next()?;
    let (observable, axis) = strongest.map_or((first, Axis::Frequency), |o| (o.observable, o.axis));
    let (from, to) = extent(problem, axis, observable, &left.residual);
    let differences = problem
        .data_of_group(group)
        .map(|at| (left.residual[at] * problem.uncertainty(at)).powi(2));
    let rows = problem.data_of(observable).len().max(1) as f64;
    Some(Remainder {
        observable: group,
        rms_rel: (differences.sum::<f64>() / rows).sqrt(),
        axis,
        from,
        to,
    })
}

/// Conditions that rise or fall with another one in the rows of an observable, so that these do not
/// tell along which a deviation varies.
fn inseparable(problem: &Problem, axis: Axis, observable: Observable) -> Vec<Axis> {
    let rows = problem.data_of(observable).map(|at| problem.row_of[at]);
    let rows: Vec<usize> = rows.collect();
    let ranks = |axis: Axis| {
        ranks(
            rows.iter()
                .map(|row| axis.value(&problem.rows[*row]))
                .collect(),
        )
    };
    let Some(own) = ranks(axis) else {
        return Vec::new();
    };
    let alike = |other: &Axis| {
        let other = ranks(*other);
        other.is_some_and(|other| correlation(&own, &other).abs() > thresholds::INSEPARABLE)
    };
    let others = Axis::CONDITIONS.into_iter();
    others
        .filter(|other| *other != axis)
        .filter(alike)
        .collect()
}

/// Ranks of values, equal ones sharing theirs; none where a value is unknown or all are equal.
fn ranks(values: Vec<f64>) -> Option<Vec<f64>> {
    let mut sorted = values.clone();
    sorted.sort_by(f64::total_cmp);
    let differ = sorted.first()? < sorted.last()?;
    let rank = |value: &f64| {
        let below = sorted.partition_point(|other| other < value);
        let upto = sorted.partition_point(|other| other <= value);
        0.5 * (below + upto) as f64
    };
    (differ && values.iter().all(|v| v.is_finite())).then(|| values.iter().map(rank).collect())
}

/// Of two lists as long as one another, neither of which is constant.
fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |list: &[f64]| list.iter().sum::<f64>() / list.len() as f64;
    let (mean_a, mean_b) = (mean(a), mean(b));
    let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
    for (x, y) in a.iter().zip(b) {
        let (x, y) = (x - mean_a, y - mean_b);
        ab += x * y;
        aa += x * x;
        bb += y * y;
    }
    ab / (aa * bb).sqrt()
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
