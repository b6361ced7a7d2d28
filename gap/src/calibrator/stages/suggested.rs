//! The stages a gap points to by its classes and by what its harmonics and noise do.

use super::pattern::Kind;
use super::rules::Found;
use crate::axis::Axis;
use crate::calibrator::lack_of_fit::{LackOfFit, Outcome};
use crate::calibrator::problem::Problem;
use crate::calibrator::shapes::BANDS;
use crate::observable::{Channel, Group, Observable};
use crate::thresholds;
use calib_effects::Stage;
use std::ops::Range;

/// Stages suggested by the classes of a gap, with the chi-square that speaks for each.
pub(super) fn by_class(problem: &Problem, s: &LackOfFit, found: &[Found]) -> Vec<(Stage, f64)> {
    let of = |group| excess(s, problem.data_of_group(group));
    let harmonics = [of(Group::RefHarmonics), of(Group::DutHarmonics)];
    let direct = of(Group::Dc);
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
fn of_kind(kind: Kind, s: &LackOfFit) -> [Stage; 2] {
    match kind {
        Kind::Ratio => of_the_ratio(s),
        Kind::PhaseInTime => [Stage::Digitiser, Stage::Conditioning],
        Kind::Rotation | Kind::Payload => [Stage::Mount, Stage::Dut],
        Kind::Temperature | Kind::Time => [Stage::Dut, Stage::Reference],
        Kind::Level => [Stage::Dut, Stage::Digitiser],
        Kind::Mirrored if is_low(s) => [Stage::Conditioning, Stage::Reference],
        Kind::Mirrored => [Stage::Reference, Stage::Conditioning],
        Kind::MirroredSlow => [Stage::Reference, Stage::Dut],
        Kind::MirroredLevel => [Stage::Digitiser, Stage::Reference],
        Kind::DriveInTime => [Stage::Amplifier, Stage::Exciter],
        Kind::Exciter | Kind::ExciterInTime => [Stage::Exciter, Stage::Amplifier],
        Kind::NoiseOfDut => [Stage::Conditioning, Stage::Mount],
        Kind::NoiseOfBoth => noisy(s),
    }
}

/// Whether the strongest band of the ratio lies in the lower half of the frequencies.
fn is_low(s: &LackOfFit) -> bool {
    let bands = of_tests(s, Group::Ratio, Axis::Frequency);
    // The bands come last among the shapes of an observable, in ascending order.
    let last = bands.clone().map(|o| o.shape).max().unwrap_or(0);
    let strongest = bands
        .filter(|o| o.shape + BANDS > last)
        .max_by(|a, b| a.z.abs().total_cmp(&b.z.abs()));
    strongest.is_some_and(|o| o.shape + BANDS / 2 <= last)
}

/// A deviation of the ratio over frequency alone: by its place and by how much of it is phase.
fn of_the_ratio(s: &LackOfFit) -> [Stage; 2] {
    let most = |of: Observable| {
        let tests = of_tests(s, Group::Ratio, Axis::Frequency);
        largest_square(tests.filter(move |o| o.observable == of))
    };
    let (size, phase) = (most(Observable::Ratio), most(Observable::RatioPhase));
    if is_low(s) {
        if phase > thresholds::LOW_PHASE * size {
            [Stage::Conditioning, Stage::Mount]
        } else {
            [Stage::Mount, Stage::Dut]
        }
    } else if phase > thresholds::SKEWED_PHASE * size {
        [Stage::Digitiser, Stage::Conditioning]
    } else if phase > thresholds::FILTERED_PHASE * size {
        [Stage::Conditioning, Stage::Digitiser]
    } else {
        [Stage::Dut, Stage::Conditioning]
    }
}

/// Harmonics: of the motion if both channels show the same, else of one channel.
fn distorted(problem: &Problem, s: &LackOfFit, [reference, dut]: [f64; 2]) -> [Stage; 2] {
    let of_order = |[real, imaginary]: [Observable; 2]| {
        excess(
            s,
            problem.data_of(real).start..problem.data_of(imaginary).end,
        )
    };
    let [second, third, fourth, fifth] = Observable::harmonics(Channel::Dut).map(of_order);
    let (even, odd) = (second + fourth, third + fifth);
    let (shared, data) = shared(problem, s);
    if shared > thresholds::SHARED_SHARE * reference.max(dut)
        && shared > thresholds::SHARED_SIGMA * data.sqrt()
    {
        [Stage::Exciter, Stage::Amplifier]
    } else if dut > reference && even.min(odd) > thresholds::BOTH_PARITIES * even.max(odd) {
        [Stage::Mount, Stage::Digitiser]
    } else if dut > reference {
        [Stage::Digitiser, Stage::Dut]
    } else {
        [Stage::Digitiser, Stage::Conditioning]
    }
}

/// Inner product of the harmonics of both channels, and the number of data in it:
/// what noise gives has the variance of that number.
fn shared(problem: &Problem, s: &LackOfFit) -> (f64, f64) {
    let (mut product, mut data) = (0.0, 0.0);
    let of_dut = Group::DutHarmonics.observables();
    for (of_reference, of_dut) in Group::RefHarmonics.observables().zip(of_dut) {
        let mut other = problem.data_of(of_dut).peekable();
        for at in problem.data_of(of_reference) {
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
fn noisy(s: &LackOfFit) -> [Stage; 2] {
    let along = |axis| largest_square(of_tests(s, Group::Noise, axis));
    let grows = along(Axis::Frequency).max(along(Axis::Level));
    let all = s.outcomes.iter();
    let most = largest_square(all.filter(|o| o.observable.is_noise()));
    if grows >= thresholds::NOISE_GROWS * most && level_counts(s) {
        [Stage::Digitiser, Stage::Environment]
    } else {
        [Stage::Environment, Stage::Digitiser]
    }
}

/// Whether the noise grows with the level: jitter does, motion of the base does not.
fn level_counts(s: &LackOfFit) -> bool {
    let largest = |axis| {
        let tests = of_tests(s, Group::Noise, axis);
        tests.fold(0.0_f64, |m, o| m.max(o.z.abs()))
    };
    largest(Axis::Level) > thresholds::LEVEL_COUNTS * largest(Axis::Frequency)
}

/// Chi-square of some data beyond what noise gives.
fn excess(lack_of_fit: &LackOfFit, data: Range<usize>) -> f64 {
    let count = data.len() as f64;
    let sum: f64 = lack_of_fit.residual[data].iter().map(|r| r * r).sum();
    (sum - count - thresholds::EXCESS_SIGMA * (2.0 * count).sqrt()).max(0.0)
}

/// Tests of a group along an axis.
fn of_tests(s: &LackOfFit, group: Group, axis: Axis) -> impl Iterator<Item = &Outcome> + Clone {
    let all = s.outcomes.iter();
    all.filter(move |o| o.observable.group() == group && o.axis == axis)
}

fn largest_square<'a>(tests: impl Iterator<Item = &'a Outcome>) -> f64 {
    tests.fold(0.0_f64, |m, o| m.max(o.z * o.z))
}
