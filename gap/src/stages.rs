//! Which stage a gap points to, by what explains it and by its class.

use crate::answer::Verdict;
use crate::effects::Stage;
use crate::engine::problem::{Nuisance, Problem};
use crate::engine::search::Search;
use crate::engine::structure::{BANDS, Outcome, Structure};
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
    let stretched = stretched(problem, found);
    let by_class = by_class(problem, nominal, stretched);
    let mut order: Vec<Stage> = Vec::new();
    let named = found
        .sets
        .first()
        .into_iter()
        .flat_map(|best| &best.fit.effects);
    let named: Vec<Stage> = named.map(|e| e.effect.about().stage).collect();
    if verdict == Verdict::Unexplained {
        // What was named is a substitute: the gap itself speaks first.
        order.extend(by_class.iter().take(2).map(|s| s.0));
        order.extend(&named);
        order.extend(self::by_class(problem, left, 0.0).first().map(|s| s.0));
    } else {
        order.extend(&named);
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

/// How far beyond three of their uncertainties the exciter's values were stretched, squared.
fn stretched(problem: &Problem, found: &Search) -> f64 {
    let values = problem.free.iter().zip(&found.nominal.theta);
    let exciter = values.filter(|(free, _)| matches!(free.kind, Nuisance::Exciter(_)));
    exciter.map(|(_, t)| (t * t - 9.0).max(0.0)).sum()
}

/// Stages suggested by the observables and axes alone, with the chi-square that speaks for each.
fn by_class(problem: &Problem, s: &Structure, stretched: f64) -> Vec<(Stage, f64)> {
    let of = |from: usize, to: usize| excess(problem, s, from, to);
    let (ratio, drive, current) = (
        of(RATIO, DRIVE),
        of(DRIVE, CURRENT),
        of(CURRENT, REF_HARMONICS),
    );
    let harmonics = [of(REF_HARMONICS, DUT_HARMONICS), of(DUT_HARMONICS, DC)];
    let noise = [of(NOISE, NOISE + 1), of(NOISE + 1, SLOTS)];
    let direct = of(DC, NOISE);
    let mirrored = ratio.min(drive) > 0.2 * ratio && mirror(s) < -0.6;
    let mut classes: Vec<(f64, [Stage; 2])> = vec![
        (
            harmonics[0].max(harmonics[1]) + direct,
            distorted(problem, s, harmonics),
        ),
        (0.5 * noise[0].max(noise[1]), noisy(s, noise)),
        (stretched, [Stage::Exciter, Stage::Amplifier]),
    ];
    if mirrored {
        classes.push((ratio + drive, of_the_reference(s)));
        classes.push((current, [Stage::Exciter, Stage::Amplifier]));
    } else {
        classes.push((ratio, of_the_ratio(s)));
        classes.push((drive + current, driven(s, drive, current)));
    }
    classes.retain(|c| c.0 > 0.0);
    if classes.is_empty() {
        // Nothing is left in the data, so the nuisances were stretched: they are the exciter's.
        return vec![(Stage::Exciter, 1.0), (Stage::Reference, 0.5)];
    }
    classes.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut list: Vec<(Stage, f64)> = Vec::new();
    for (weight, stages) in classes {
        for stage in stages {
            if !list.iter().any(|l| l.0 == stage) {
                list.push((stage, weight));
            }
        }
    }
    list
}

/// Correlation of what ratio and drive show over the same shapes: -1 for the reference, which is in both.
fn mirror(s: &Structure) -> f64 {
    let (mut product, mut first, mut second) = (0.0, 0.0, 0.0);
    for a in s.outcomes.iter().filter(|o| o.slot < DRIVE) {
        let same = |b: &&Outcome| b.slot == a.slot + DRIVE && b.shape == a.shape;
        if let Some(b) = s.outcomes.iter().find(same) {
            product += a.z * b.z;
            first += a.z * a.z;
            second += b.z * b.z;
        }
    }
    product / (first * second).sqrt().max(1e-300)
}

/// Whether the strongest band of a slot lies in the lower half of the frequencies.
fn is_low(s: &Structure, slots: std::ops::Range<usize>) -> bool {
    let bands = s
        .outcomes
        .iter()
        .filter(|o| slots.contains(&o.slot) && o.axis == "frequency_hz");
    // The bands come last among the shapes of a slot, in ascending order.
    let last = bands.clone().map(|o| o.shape).max().unwrap_or(0);
    let strongest = bands
        .filter(|o| o.shape + BANDS > last)
        .max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
    strongest.is_some_and(|o| o.shape + BANDS / 2 <= last)
}

fn of_the_reference(s: &Structure) -> [Stage; 2] {
    let slow = along(s, RATIO, DRIVE, "temperature_c").max(along(s, RATIO, DRIVE, "time_s"));
    let plain = along(s, RATIO, DRIVE, "frequency_hz");
    if slow > plain {
        [Stage::Reference, Stage::Dut]
    } else if is_low(s, RATIO..DRIVE) {
        [Stage::Conditioning, Stage::Reference]
    } else {
        [Stage::Reference, Stage::Conditioning]
    }
}

fn of_the_ratio(s: &Structure) -> [Stage; 2] {
    let plain = along(s, RATIO, DRIVE, "frequency_hz");
    let [payload, rotation, warm, time, level] = [
        "payload_kg",
        "rotation_deg",
        "temperature_c",
        "time_s",
        "acceleration_ms2",
    ]
    .map(|axis| along(s, RATIO, DRIVE, axis));
    let phase = along(s, RATIO + 1, DRIVE, "frequency_hz");
    let size = along(s, RATIO, RATIO + 1, "frequency_hz");
    let most = [plain, payload, rotation, warm, time, level]
        .into_iter()
        .fold(0.0, f64::max);
    if most == rotation || payload > 0.9 * most && payload > 1.05 * plain {
        [Stage::Mount, Stage::Dut]
    } else if along(s, RATIO + 1, DRIVE, "time_s") > plain {
        [Stage::Digitiser, Stage::Conditioning]
    } else if most == warm || most == time {
        [Stage::Dut, Stage::Reference]
    } else if most == level {
        [Stage::Dut, Stage::Digitiser]
    } else if is_low(s, RATIO..DRIVE) {
        if phase > 0.05 * size {
            [Stage::Conditioning, Stage::Mount]
        } else {
            [Stage::Mount, Stage::Dut]
        }
    } else if phase > 15.0 * size {
        [Stage::Digitiser, Stage::Conditioning]
    } else if phase > 0.3 * size {
        [Stage::Conditioning, Stage::Digitiser]
    } else if payload > 0.5 * plain {
        [Stage::Mount, Stage::Dut]
    } else {
        [Stage::Dut, Stage::Conditioning]
    }
}

fn driven(s: &Structure, drive: f64, current: f64) -> [Stage; 2] {
    let slow = along(s, DRIVE, CURRENT, "time_s");
    if current < 0.02 * drive && slow > along(s, DRIVE, CURRENT, "frequency_hz") {
        [Stage::Amplifier, Stage::Exciter]
    } else {
        [Stage::Exciter, Stage::Amplifier]
    }
}

fn distorted(problem: &Problem, s: &Structure, [reference, dut]: [f64; 2]) -> [Stage; 2] {
    let parity = |offset: usize| {
        let orders = [DUT_HARMONICS + offset, DUT_HARMONICS + offset + 4];
        orders
            .iter()
            .map(|o| excess(problem, s, *o, o + 2))
            .sum::<f64>()
    };
    let (even, odd) = (parity(0), parity(2));
    if reference.min(dut) > 0.05 * reference.max(dut) {
        [Stage::Exciter, Stage::Amplifier]
    } else if dut > reference && even.min(odd) > 0.02 * even.max(odd) {
        [Stage::Mount, Stage::Digitiser]
    } else if dut > reference {
        [Stage::Digitiser, Stage::Dut]
    } else {
        [Stage::Digitiser, Stage::Conditioning]
    }
}

fn noisy(s: &Structure, [reference, dut]: [f64; 2]) -> [Stage; 2] {
    let grows =
        along(s, NOISE, SLOTS, "frequency_hz").max(along(s, NOISE, SLOTS, "acceleration_ms2"));
    let z2 = s
        .outcomes
        .iter()
        .filter(|o| o.slot >= NOISE)
        .map(|o| o.z * o.z);
    let most = z2.fold(0.0, f64::max);
    if reference < 0.05 * dut {
        [Stage::Conditioning, Stage::Mount]
    } else if grows >= 0.5 * most && level_counts(s) {
        [Stage::Digitiser, Stage::Environment]
    } else {
        [Stage::Environment, Stage::Digitiser]
    }
}

/// Whether the noise grows with the level: jitter does, motion of the base does not.
fn level_counts(s: &Structure) -> bool {
    let first = |o: &&Outcome| o.slot >= NOISE && o.axis == "frequency_hz";
    let plain = s
        .outcomes
        .iter()
        .filter(first)
        .fold(0.0_f64, |m, o| m.max(o.z.abs()));
    let level = |o: &&Outcome| o.slot >= NOISE && o.axis == "acceleration_ms2";
    let level = s
        .outcomes
        .iter()
        .filter(level)
        .fold(0.0_f64, |m, o| m.max(o.z.abs()));
    level > 0.8 * plain
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
