//! Where the gap lies.

use crate::answer::{Verdict, Where};
use crate::engine::errors::OBSERVABLES;
use crate::engine::fit::Workspace;
use crate::engine::problem::Problem;
use crate::engine::search::Search;
use crate::engine::significance::two_sided;
use crate::engine::structure::Structure;
use crate::model::row::RATIO;

/// Name of the observable of a slot.
pub(super) fn observable(slot: usize) -> &'static str {
    OBSERVABLES
        .iter()
        .find(|(_, from, to)| (*from..*to).contains(&slot))
        .map_or("ratio", |o| o.0)
}

/// Where the gap lies: stages in the order of what their effects (or the shape of the structure) explain.
pub(super) fn places(
    problem: &Problem,
    found: &Search,
    nominal: &Structure,
    left: &Structure,
    verdict: Verdict,
    work: &mut Workspace,
) -> Vec<Where> {
    if verdict == Verdict::NoGap {
        return Vec::new();
    }
    let excess =
        (nominal.residual.iter().map(|r| r * r).sum::<f64>() - problem.len() as f64).max(1.0);
    let shape = crate::stages::of_ratio(problem, &found.nominal, work);
    let mut places = Vec::new();
    for (stage, share) in crate::stages::rank(problem, found, nominal, verdict, work) {
        let (slot, axis, z) = crate::stages::evidence(
            stage,
            if places.is_empty() { nominal } else { left },
            nominal,
        );
        let (from, to) = extent(problem, axis, slot, &nominal.residual);
        let tests = nominal.outcomes.len().max(1) as f64;
        places.push(Where {
            stage: stage.name(),
            observable: observable(slot),
            axis,
            from,
            to,
            share: (share / excess).clamp(0.0, 1.0),
            p_value: (two_sided(z) * tests).min(1.0),
            class: class(slot, axis),
            shape: shape
                .clone()
                .filter(|_| slot == RATIO && axis == "frequency_hz"),
        });
    }
    places
}

/// Bumps over frequency that the best set leaves, as places of the stage that comes first.
pub(super) fn local(
    problem: &Problem,
    nominal: &Structure,
    left: &Structure,
    places: &[Where],
) -> Vec<Where> {
    let total = nominal.residual.iter().map(|r| r * r).sum::<f64>();
    let excess = (total - problem.len() as f64).max(1.0);
    let bumps = crate::bumps::bumps(problem, &left.residual);
    bumps
        .into_iter()
        .map(|bump| Where {
            stage: places.first().map_or("dut", |place| place.stage),
            observable: observable(bump.slot),
            axis: "frequency_hz",
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

fn class(slot: usize, axis: &str) -> &'static str {
    match (slot, axis) {
        (6..22, _) => {
            if ((slot - 6) / 2).is_multiple_of(2) {
                "even"
            } else {
                "odd"
            }
        }
        (24.., _) => "noise",
        (_, "inverse level") => "additive 1/A",
        (_, "time_s") => "drift",
        (_, "acceleration_ms2" | "travel_m") => "level",
        (_, "rotation_deg" | "payload_kg" | "temperature_c" | "tilt_deg") => "condition",
        _ => "frequency",
    }
}

/// Range of the axis that holds the middle 90 % of the squared residual of an observable.
fn extent(problem: &Problem, axis: &str, slot: usize, residual: &[f64]) -> (f64, f64) {
    let value = |row: usize| {
        let r = &problem.rows[row];
        match axis {
            "acceleration_ms2" | "inverse level" => r.level_ms2,
            "time_s" => r.time_s,
            "payload_kg" => r.payload_kg,
            "temperature_c" => r.warmer_k,
            "rotation_deg" => r.rotation.1.atan2(r.rotation.0).to_degrees(),
            "travel_m" => r.level_ms2 / (r.omega * r.omega),
            "coil_v" => r.coil_peak_v,
            _ => r.frequency_hz,
        }
    };
    let mut list: Vec<(f64, f64)> = problem.slots[slot]
        .clone()
        .map(|at| (value(problem.row_of[at]), residual[at] * residual[at]))
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
