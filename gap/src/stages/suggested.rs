//! The stages a gap points to by its classes and by what its harmonics and noise do.

use super::class::Found;
use super::kind::Kind;
use crate::effects::Stage;
use crate::engine::battery::BANDS;
use crate::engine::problem::Problem;
use crate::engine::structure::{Outcome, Structure};
use crate::model::row::{DC, DRIVE, DUT_HARMONICS, NOISE, RATIO, REF_HARMONICS, SLOTS};

/// Stages suggested by the classes of a gap, with the chi-square that speaks for each.
pub(super) fn by_class(problem: &Problem, s: &Structure, found: &[Found]) -> Vec<(Stage, f64)> {
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

/// Chi-square of a range of slots beyond what noise gives.
fn excess(problem: &Problem, structure: &Structure, from: usize, to: usize) -> f64 {
    let range = problem.slots[from].start..problem.slots[to - 1].end;
    let count = range.len() as f64;
    let sum: f64 = structure.residual[range].iter().map(|r| r * r).sum();
    (sum - count - 2.0 * (2.0 * count).sqrt()).max(0.0)
}

/// Largest squared deviate of the tests of a range of slots along an axis.
fn along(structure: &Structure, from: usize, to: usize, axis: &str) -> f64 {
    let chosen = structure
        .outcomes
        .iter()
        .filter(|o| (from..to).contains(&o.slot) && o.axis == axis);
    chosen.fold(0.0_f64, |m, o| m.max(o.z * o.z))
}
