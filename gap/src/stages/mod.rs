//! Which stage a gap points to, by what explains it and by its class.
//!
//! ```text
//! class     the class of a gap: which kind of deviation accounts for most of it
//! kind      the kinds; rules: observables and courses of each; course: over frequency
//! pattern   what columns with free amounts take out of a residual
//! shape     the course of the ratio in words
//! ```

mod class;
mod course;
mod kind;
mod pattern;
mod rules;
mod shape;

use crate::answer::Verdict;
use crate::effects::{About, Stage, list};
use crate::engine::battery::BANDS;
use crate::engine::fit::Workspace;
use crate::engine::problem::Problem;
use crate::engine::search::Search;
use crate::engine::structure::{Outcome, Structure};
use crate::model::row::{CURRENT, DC, DRIVE, DUT_HARMONICS, NOISE, RATIO, REF_HARMONICS, SLOTS};
use class::Found;
use kind::Kind;
use std::collections::BTreeMap;

pub(crate) use shape::of_ratio;

/// Stages in the order of what speaks for them, with the chi-square they account for.
pub(crate) fn rank(
    problem: &Problem,
    found: &Search,
    nominal: &Structure,
    verdict: Verdict,
    work: &mut Workspace,
) -> Vec<(Stage, f64)> {
    let by_effects = by_effects(found);
    let classes = class::classes(problem, &found.nominal, work);
    let by_class = by_class(problem, nominal, &classes);
    let named: Vec<&About> = found.sets.first().map_or_else(Vec::new, |best| {
        best.fit.effects.iter().map(|e| e.effect.about()).collect()
    });
    let mut order: Vec<Stage> = Vec::new();
    if verdict == Verdict::Unexplained {
        // What was named is a substitute: the gap itself speaks first.
        order.extend(by_class.iter().take(2).map(|s| s.0));
    }
    order.extend(named.iter().map(|about| about.stage));
    if let [alone] = named.as_slice() {
        order.extend(mistaken_for(alone));
    }
    order.extend(by_effects.iter().chain(&by_class).map(|s| s.0));
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

/// The other stage in which what is first mistaken for an effect sits.
fn mistaken_for(about: &About) -> Option<Stage> {
    let library = list();
    let stage = |id: &&str| library.iter().find(|a| a.id == *id).map(|a| a.stage);
    about
        .confused_with
        .iter()
        .filter_map(stage)
        .find(|s| *s != about.stage)
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

/// Stages suggested by the classes of a gap, with the chi-square that speaks for each.
fn by_class(problem: &Problem, s: &Structure, found: &[Found]) -> Vec<(Stage, f64)> {
    let of = |from: usize, to: usize| excess(problem, s, from, to);
    let harmonics = [of(REF_HARMONICS, DUT_HARMONICS), of(DUT_HARMONICS, DC)];
    let direct = of(DC, NOISE);
    let mut classes: Vec<(f64, [Stage; 2])> =
        found.iter().map(|f| (f.gain, of_kind(f.kind, s))).collect();
    classes.push((
        harmonics[0].max(harmonics[1]) + direct,
        distorted(problem, s, harmonics),
    ));
    classes.retain(|c| c.0 > 0.0);
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

/// The stage a class points to first, and the next best.
fn of_kind(kind: Kind, s: &Structure) -> [Stage; 2] {
    match kind {
        Kind::Ratio => of_the_ratio(s),
        Kind::PhaseInTime => [Stage::Digitiser, Stage::Conditioning],
        Kind::Rotation | Kind::Payload => [Stage::Mount, Stage::Dut],
        Kind::Temperature | Kind::Time => [Stage::Dut, Stage::Reference],
        Kind::Level => [Stage::Dut, Stage::Digitiser],
        Kind::Mirrored if is_low(s, RATIO..DRIVE) => [Stage::Conditioning, Stage::Reference],
        Kind::Mirrored => [Stage::Reference, Stage::Conditioning],
        Kind::MirroredSlow => [Stage::Reference, Stage::Dut],
        Kind::MirroredLevel => [Stage::Digitiser, Stage::Reference],
        Kind::DriveInTime => [Stage::Amplifier, Stage::Exciter],
        Kind::Exciter | Kind::ExciterInTime => [Stage::Exciter, Stage::Amplifier],
        Kind::NoiseOfDut => [Stage::Conditioning, Stage::Mount],
        Kind::NoiseOfBoth => noisy(s),
    }
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

/// A deviation of the ratio over frequency alone: by its place and by how much of it is phase.
fn of_the_ratio(s: &Structure) -> [Stage; 2] {
    let phase = along(s, RATIO + 1, DRIVE, "frequency_hz");
    let size = along(s, RATIO, RATIO + 1, "frequency_hz");
    if is_low(s, RATIO..DRIVE) {
        if phase > 0.05 * size {
            [Stage::Conditioning, Stage::Mount]
        } else {
            [Stage::Mount, Stage::Dut]
        }
    } else if phase > 15.0 * size {
        [Stage::Digitiser, Stage::Conditioning]
    } else if phase > 0.3 * size {
        [Stage::Conditioning, Stage::Digitiser]
    } else {
        [Stage::Dut, Stage::Conditioning]
    }
}

/// Harmonics: of the motion if both channels show the same, else of one channel.
fn distorted(problem: &Problem, s: &Structure, [reference, dut]: [f64; 2]) -> [Stage; 2] {
    let parity = |offset: usize| {
        let orders = [DUT_HARMONICS + offset, DUT_HARMONICS + offset + 4];
        orders
            .iter()
            .map(|o| excess(problem, s, *o, o + 2))
            .sum::<f64>()
    };
    let (even, odd) = (parity(0), parity(2));
    let (shared, data) = shared(problem, s);
    if shared > 0.3 * reference.max(dut) && shared > 3.0 * data.sqrt() {
        [Stage::Exciter, Stage::Amplifier]
    } else if dut > reference && even.min(odd) > 0.02 * even.max(odd) {
        [Stage::Mount, Stage::Digitiser]
    } else if dut > reference {
        [Stage::Digitiser, Stage::Dut]
    } else {
        [Stage::Digitiser, Stage::Conditioning]
    }
}

/// Inner product of the harmonics of both channels, and the number of data in it:
/// what noise gives has the variance of that number.
fn shared(problem: &Problem, s: &Structure) -> (f64, f64) {
    let (mut product, mut data) = (0.0, 0.0);
    for slot in REF_HARMONICS..DUT_HARMONICS {
        let of_dut = problem.slots[slot + DUT_HARMONICS - REF_HARMONICS].clone();
        let mut other = of_dut.peekable();
        for at in problem.slots[slot].clone() {
            let row = problem.row_of[at];
            while other.next_if(|o| problem.row_of[*o] < row).is_some() {}
            if let Some(o) = other.next_if(|o| problem.row_of[*o] == row) {
                product += s.residual[at] * s.residual[o];
                data += 1.0;
            }
        }
    }
    (product, data)
}

/// Noise in both channels: of the motion, or of the clock if it grows with the signal.
fn noisy(s: &Structure) -> [Stage; 2] {
    let grows =
        along(s, NOISE, SLOTS, "frequency_hz").max(along(s, NOISE, SLOTS, "acceleration_ms2"));
    let z2 = s
        .outcomes
        .iter()
        .filter(|o| o.slot >= NOISE)
        .map(|o| o.z * o.z);
    let most = z2.fold(0.0, f64::max);
    if grows >= 0.5 * most && level_counts(s) {
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
