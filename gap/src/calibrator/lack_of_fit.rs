//! Tests of the residuals of a fit by class, their significance calibrated by simulation.

use super::evaluation::Evaluation;
use super::fit::{Fit, Workspace};
use super::linear::Linearised;
use super::problem::{Problem, Tangent};
use super::settled::Settled;
use super::shapes::{Test, shapes};
use crate::axis::Axis;
use crate::estimation::significance::{
    chi_square_tail, lack_of_fit, length_beside, normal_deviates, two_sided,
};
use crate::observable::{Group, Observable};
use crate::thresholds;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// One test of the residual and its outcome.
#[derive(Debug, Clone)]
pub(crate) struct Outcome {
    pub(crate) observable: Observable,
    pub(crate) axis: Axis,
    /// Number of the shape within its observable: the same in all responses.
    pub(crate) shape: usize,
    /// Standard normal deviate.
    pub(crate) z: f64,
}

/// Outcome of all tests.
#[derive(Debug, Clone)]
pub(crate) struct LackOfFit {
    pub(crate) outcomes: Vec<Outcome>,
    /// Probability that pure noise leaves as much structure somewhere.
    pub(crate) p_value: f64,
    /// Residuals, one per datum.
    pub(crate) residual: Vec<f64>,
}

/// Tests what a fit leaves.
pub(crate) fn examine(problem: &Problem, fit: &Fit, work: &mut Workspace) -> LackOfFit {
    let Some((evaluation, tangent)) = Linearised::new(problem, fit, work).tangent() else {
        return LackOfFit {
            outcomes: Vec::new(),
            p_value: 0.0,
            residual: vec![0.0; problem.len()],
        };
    };
    let settled = Settled::new(problem, fit, &tangent, counted(problem, &evaluation));
    let tests = shapes(problem);
    let examination = Examination::new(problem, &evaluation, &tangent, &tests);
    let here = examination.smallest(&settled.left, &settled.theta, &evaluation.residual);
    let p_value = lack_of_fit(
        here,
        &tangent,
        problem,
        |draw| examination.noise(draw),
        |left, theta, data| examination.smallest(left, theta, data),
    );
    LackOfFit {
        outcomes: examination.outcomes(&settled.left),
        p_value,
        residual: evaluation.residual,
    }
}

/// The residual; where an effect leaves scatter open its size is a rough guess: such data count less. One that leaves
/// most of the noise open predicts none of it: there the data count as they are stated.
fn counted(problem: &Problem, evaluation: &Evaluation) -> Vec<f64> {
    let share = |at: usize| evaluation.weight[at] * problem.uncertainty(at);
    let noise = problem.data_of_group(Group::Noise);
    let open = noise.clone().filter(|at| share(*at) < thresholds::OPEN);
    let predicts = open.count() as f64 <= thresholds::MOST_OPEN * noise.len() as f64;
    let data = evaluation.residual.iter().enumerate();
    data.map(|(at, r)| match predicts || !noise.contains(&at) {
        true => r * share(at).powi(2),
        false => r / share(at),
    })
    .collect()
}

/// All tests of what a fit leaves, with what the fit would take over taken out of each.
struct Examination<'a> {
    problem: &'a Problem,
    tangent: &'a Tangent,
    /// Tests the fit leaves something of, each with the length of that.
    usable: Vec<(&'a Test, f64)>,
    /// Of each nuisance with a prior: its variance about that prior once it is estimated.
    known: Vec<Option<f64>>,
    open: OpenData<'a>,
}

impl<'a> Examination<'a> {
    fn new(
        problem: &'a Problem,
        evaluation: &Evaluation,
        tangent: &'a Tangent,
        tests: &'a [Test],
    ) -> Self {
        let usable = tests.iter().filter_map(|test| {
            let length = length_beside(tangent, &test.column);
            (length * length > thresholds::LEAST_LEFT * test.column.norm2())
                .then_some((test, length))
        });
        // A nuisance with a prior is estimated with the variance 1 - c about that prior.
        let covariance = tangent.covariance();
        let known = problem.free.iter().enumerate();
        let known = known.map(|(i, free)| free.bounded.then(|| 1.0 - covariance[(i, i)]));
        Self {
            problem,
            tangent,
            usable: usable.collect(),
            known: known.collect(),
            open: OpenData::new(problem, evaluation, tests),
        }
    }

    /// Deviates of the usable tests.
    fn scores(&self, left: &[f64]) -> Vec<f64> {
        let deviate = |(test, length): &(&Test, f64)| {
            let along = test.column.dot_data(self.problem, left);
            along / length
        };
        self.usable.iter().map(deviate).collect()
    }

    /// Largest deviate of a nuisance from its prior.
    fn pull(&self, theta: &[f64]) -> f64 {
        let pulled = theta.iter().zip(&self.known);
        pulled.fold(0.0, |most, (value, known)| match known {
            Some(known) if *known > thresholds::LEAST_KNOWN => most.max(value.abs() / known.sqrt()),
            _ => most,
        })
    }

    /// Smallest p-value of all tests, of what is left at the values `theta` of the nuisances,
    /// and of the data before that.
    fn smallest(&self, left: &[f64], theta: &[f64], data: &[f64]) -> f64 {
        let pull = self.pull(theta).max(self.open.largest(self.problem, data));
        let largest = self.scores(left).iter().fold(0.0, largest_of);
        two_sided(largest)
            .min(self.of_squares(left))
            .min(of_outlier(left))
            .min(two_sided(pull))
    }

    /// Smallest p-value of the sums of squares by class.
    fn of_squares(&self, left: &[f64]) -> f64 {
        let idle = self.tangent.columns.len() as f64;
        let classes: [&[Group]; 5] = [
            &Group::RESPONSES,
            &[Group::RefHarmonics, Group::DutHarmonics, Group::Dc],
            &[Group::Noise],
            &[Group::Ratio],
            &[Group::Drive, Group::Current],
        ];
        let mut smallest = f64::INFINITY;
        for class in classes {
            let data = class
                .iter()
                .map(|group| &left[self.problem.data_of_group(*group)]);
            let count = data.clone().map(<[f64]>::len).sum::<usize>() as f64;
            if count > 0.0 {
                let square: f64 = data.flatten().map(|r| r * r).sum();
                // The fit moves along the responses.
                let taken = if class.iter().all(|group| group.is_response()) {
                    (0.5 * idle).min(0.5 * count)
                } else {
                    0.0
                };
                smallest = smallest.min(chi_square_tail(square, count - taken));
            }
        }
        smallest
    }

    /// Pure noise, with nuisances that deviate as their priors say.
    fn noise(&self, draw: &mut ChaCha8Rng) -> Vec<f64> {
        let mut noise = normal_deviates(draw, self.problem.len());
        let columns = self.tangent.columns.iter().zip(&self.known);
        for (column, _) in columns.filter(|(_, known)| known.is_some()) {
            column.add_to(self.problem, &mut noise, StandardNormal.sample(draw));
        }
        noise
    }

    fn outcomes(&self, left: &[f64]) -> Vec<Outcome> {
        let scored = self.usable.iter().zip(self.scores(left));
        let outcome = |((test, _), z): (&(&Test, f64), f64)| Outcome {
            observable: test.observable,
            axis: test.axis,
            shape: test.shape,
            z,
        };
        scored.map(outcome).collect()
    }
}

/// P-value of the largest single residual among all.
fn of_outlier(left: &[f64]) -> f64 {
    let outlier = left.iter().fold(0.0, largest_of);
    -libm::expm1(left.len() as f64 * libm::log1p(-two_sided(outlier).min(1.0 - 1e-15)))
}

fn largest_of(most: f64, value: &f64) -> f64 {
    most.max(value.abs())
}

/// The open data of an evaluation, and the tests that cover enough of them.
pub(super) struct OpenData<'a> {
    tests: Vec<&'a Test>,
    /// Whether half of a datum's variance or more is open.
    open: Vec<bool>,
}

impl<'a> OpenData<'a> {
    pub(super) fn new(problem: &Problem, evaluation: &Evaluation, tests: &'a [Test]) -> Self {
        let open: Vec<bool> = evaluation
            .weight
            .iter()
            .enumerate()
            .map(|(at, w)| w * problem.uncertainty(at) < thresholds::OPEN)
            .collect();
        let covers = |test: &&Test| {
            let (observable, values) = &test.column.parts[0];
            let inside = values.iter().zip(&open[problem.data_of(*observable)]);
            let (mut square, mut fourth) = (0.0, 0.0);
            for (v, _) in inside.filter(|(_, open)| **open) {
                square += v * v;
                fourth += v.powi(4);
            }
            // How the noise itself is left open is a matter of shape: no pattern is asked of it.
            !observable.is_noise() && square * square > thresholds::FEWEST_OPEN * fourth
        };
        let tests = if open.iter().any(|o| *o) {
            tests.iter().filter(covers).collect()
        } else {
            Vec::new()
        };
        Self { tests, open }
    }

    /// Largest deviate over the tests, the scatter taken from the data themselves, and of a
    /// single datum, whose scatter is known to a factor.
    pub(super) fn largest(&self, problem: &Problem, residual: &[f64]) -> f64 {
        let open = residual.iter().zip(&self.open).filter(|(_, open)| **open);
        let outlier = open.fold(0.0, |m: f64, (r, _)| {
            m.max(r.abs() / thresholds::OPEN_FACTOR)
        });
        self.tests.iter().fold(outlier, |most: f64, test| {
            let (observable, values) = &test.column.parts[0];
            let range = problem.data_of(*observable);
            let inside = values
                .iter()
                .zip(&residual[range.clone()])
                .zip(&self.open[range])
                .filter(|(_, open)| **open)
                .map(|((v, r), _)| (*v, *r));
            most.max(by_size(inside.clone())).max(by_sign(inside))
        })
    }
}

/// Deviate of a pattern in data of unknown scatter: divided by its own scatter,
/// a wrong guess of the open size does not matter.
fn by_size(data: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut square) = (0.0, 0.0);
    for (v, r) in data {
        sum += v * r;
        square += v * v * (r * r).max(thresholds::LEAST_SQUARE);
    }
    sum.abs() / square.sqrt().max(1e-300) * thresholds::OWN_SCATTER
}

/// Tests the sign: a component not locked to the excitation has either sign
/// by chance, however large, so that a few large data do not hide the others.
fn by_sign(data: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut square) = (0.0, 0.0);
    for (v, r) in data.filter(|(v, _)| *v != 0.0) {
        let bounded = r.clamp(-1.0, 1.0);
        sum += v.signum() * bounded;
        square += (bounded * bounded).max(thresholds::LEAST_SIGN);
    }
    sum.abs() / square.sqrt().max(1e-300)
}

#[cfg(test)]
mod tests {
    use super::super::example::measured;
    use super::super::nuisance::Nuisance;
    use super::*;

    /// A gain that is off by one of its standard uncertainties costs 1 in the sum of squares, and
    /// any search may stop there. No lack of fit comes of it.
    #[test]
    fn where_a_search_stops_is_no_lack_of_fit() {
        let (rig, points) = measured(&[]);
        let problem = Problem::new(&rig, &points);
        let mut work = Workspace::new(&problem);
        let start = vec![0.0; problem.free.len()];
        let effort = super::super::refine::FULL;
        let mut fit = super::super::refine::refine(&problem, Vec::new(), start, effort, &mut work);
        let at_best = examine(&problem, &fit, &mut work).p_value;
        assert!(at_best > 0.01, "{at_best}");
        let gain = problem
            .free
            .iter()
            .position(|f| f.kind == Nuisance::DriveGain);
        let gain = gain.expect("the drive has a gain");
        let (_, tangent) = Linearised::new(&problem, &fit, &mut work)
            .tangent()
            .expect("the rig can be fitted");
        fit.theta[gain] += tangent.covariance()[(gain, gain)].sqrt();
        let beside = examine(&problem, &fit, &mut work).p_value;
        assert!((beside / at_best - 1.0).abs() < 0.05, "{beside} {at_best}");
    }
}
