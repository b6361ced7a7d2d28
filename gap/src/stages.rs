//! Which stage a gap points to, by what explains it and by its class.

use crate::answer::Verdict;
use crate::effects::Stage;
use crate::engine::problem::Problem;
use crate::engine::search::Search;
use crate::engine::structure::Structure;
use crate::model::row::{CURRENT, DC, DRIVE, DUT_HARMONICS, NOISE, RATIO, REF_HARMONICS, SLOTS};
use std::collections::BTreeMap;

/// Stages in the order of what speaks for them, with the chi-square they account for.
pub(crate) fn rank(
    problem: &Problem,
    found: &Search,
    nominal: &Structure,
    left: &Structure,
    verdict: Verdict,
) -> Vec<(Stage, f64)> {
    let by_effects = by_effects(found);
    let by_class = by_class(problem, nominal);
    let mut order: Vec<Stage> = Vec::new();
    let best = found.sets.first();
    if let Some(best) = best {
        order.extend(best.fit.effects.iter().map(|e| e.effect.about().stage));
    }
    if verdict == Verdict::Unexplained {
        let remaining = self::by_class(problem, left);
        let leading = if best.is_some_and(|b| b.fit.effects.is_empty()) {
            by_class.first()
        } else {
            remaining.first()
        };
        let at = usize::from(!order.is_empty());
        order.truncate(1);
        order.extend(leading.map(|s| s.0));
        let _ = at;
    }
    order.extend(by_effects.iter().map(|s| s.0));
    order.extend(by_class.iter().map(|s| s.0));
    let share = |stage: Stage| {
        let of = |list: &[(Stage, f64)]| list.iter().find(|s| s.0 == stage).map(|s| s.1);
        of(&by_effects).or_else(|| of(&by_class)).unwrap_or(0.0)
    };
    let mut ranked: Vec<(Stage, f64)> = Vec::new();
    for stage in order {
        if !ranked.iter().any(|r| r.0 == stage) {
            ranked.push((stage, share(stage)));
        }
    }
    ranked.truncate(4);
    ranked
}

/// Gain of the best set that has an effect of a stage and nothing else.
fn by_effects(found: &Search) -> Vec<(Stage, f64)> {
    let mut best: BTreeMap<Stage, f64> = BTreeMap::new();
    for set in found.sets.iter().filter(|s| s.fit.effects.len() == 1) {
        let gain = found.nominal.objective - set.fit.objective;
        let stage = set.fit.effects[0].effect.about().stage;
        let entry = best.entry(stage).or_insert(0.0);
        *entry = entry.max(gain);
    }
    let mut list: Vec<_> = best.into_iter().filter(|(_, g)| *g > 9.0).collect();
    list.sort_by(|a, b| b.1.total_cmp(&a.1));
    list
}

fn excess(problem: &Problem, structure: &Structure, from: usize, to: usize) -> f64 {
    let range = problem.slots[from].start..problem.slots[to - 1].end;
    let count = range.len() as f64;
    let sum: f64 = structure.residual[range].iter().map(|r| r * r).sum();
    (sum - count - 2.0 * (2.0 * count).sqrt()).max(0.0)
}

fn along(structure: &Structure, from: usize, to: usize, axis: &str) -> f64 {
    let chosen = structure
        .outcomes
        .iter()
        .filter(|o| (from..to).contains(&o.slot) && o.axis == axis);
    chosen.fold(0.0_f64, |m, o| m.max(o.z * o.z))
}

/// Stages suggested by the observables and axes alone: what remains when no effect fits.
fn by_class(problem: &Problem, s: &Structure) -> Vec<(Stage, f64)> {
    let mut votes: BTreeMap<Stage, f64> = BTreeMap::new();
    let mut vote = |stage, weight: f64| *votes.entry(stage).or_insert(0.0) += weight;
    let [ratio, drive, current] = [(RATIO, DRIVE), (DRIVE, CURRENT), (CURRENT, REF_HARMONICS)]
        .map(|(a, b)| excess(problem, s, a, b));
    let [ref_h, dut_h] = [(REF_HARMONICS, DUT_HARMONICS), (DUT_HARMONICS, DC)]
        .map(|(a, b)| excess(problem, s, a, b));
    let [ref_n, dut_n] =
        [(NOISE, NOISE + 1), (NOISE + 1, SLOTS)].map(|(a, b)| excess(problem, s, a, b));
    vote(Stage::Exciter, current);
    if drive > 0.0 {
        let reference = drive.min(ratio);
        vote(Stage::Exciter, drive - reference);
        vote(Stage::Reference, reference);
    }
    let common = ref_h.min(dut_h);
    vote(Stage::Exciter, common);
    vote(Stage::Amplifier, 0.9 * common);
    vote(Stage::Digitiser, (ref_h - common) + 0.6 * (dut_h - common));
    vote(Stage::Mount, 0.4 * (dut_h - common));
    let base = ref_n.min(dut_n);
    let grows = along(s, NOISE, SLOTS, "frequency_hz") > 30.0;
    vote(
        if grows {
            Stage::Digitiser
        } else {
            Stage::Environment
        },
        base,
    );
    vote(Stage::Conditioning, dut_n - base);
    let mounted = along(s, RATIO, DRIVE, "rotation_deg").max(along(s, RATIO, DRIVE, "payload_kg"));
    let slow = along(s, RATIO, DRIVE, "temperature_c").max(along(s, RATIO, DRIVE, "time_s"));
    let plain = along(s, RATIO, DRIVE, "frequency_hz");
    let sum = mounted + slow + plain;
    if ratio > 0.0 && sum > 0.0 {
        vote(Stage::Mount, ratio * mounted / sum);
        vote(Stage::Dut, ratio * (slow + 0.5 * plain) / sum);
        vote(Stage::Conditioning, 0.4 * ratio * plain / sum);
        if along(s, RATIO + 1, DRIVE, "frequency_hz") > along(s, RATIO, RATIO + 1, "frequency_hz") {
            vote(Stage::Digitiser, 0.5 * ratio * plain / sum);
            vote(Stage::Conditioning, 0.5 * ratio * plain / sum);
        }
    }
    let mut list: Vec<_> = votes.into_iter().filter(|(_, v)| *v > 0.0).collect();
    list.sort_by(|a, b| b.1.total_cmp(&a.1));
    list
}

/// The strongest test in the observables of a stage: slot, axis, deviate.
pub(crate) fn evidence(
    stage: Stage,
    first: &Structure,
    second: &Structure,
) -> (usize, &'static str, f64) {
    let slots: &[(usize, usize)] = match stage {
        Stage::Exciter | Stage::Amplifier => &[(DRIVE, DUT_HARMONICS)],
        Stage::Environment => &[(NOISE, SLOTS)],
        Stage::Digitiser => &[(RATIO, DRIVE), (REF_HARMONICS, SLOTS)],
        Stage::Conditioning => &[(RATIO, DRIVE), (NOISE, SLOTS)],
        Stage::Reference => &[(RATIO, CURRENT)],
        Stage::Dut | Stage::Mount => &[(RATIO, DRIVE), (DUT_HARMONICS, DC)],
    };
    let strongest = |structure: &Structure, slots: &[(usize, usize)]| {
        let inside = |slot: usize| slots.iter().any(|(a, b)| (*a..*b).contains(&slot));
        let chosen = structure.outcomes.iter().filter(|o| inside(o.slot));
        chosen
            .max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()))
            .map(|o| (o.slot, o.axis, o.z))
    };
    strongest(first, slots)
        .or_else(|| strongest(second, slots))
        .or_else(|| strongest(second, &[(0, SLOTS)]))
        .unwrap_or((RATIO, "frequency_hz", 0.0))
}
