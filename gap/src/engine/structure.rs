//! What a fit leaves: tests by class, their significance calibrated by simulation.

use super::column::Column;
use super::evaluation::Evaluation;
use super::fit::{Fit, Workspace};
use super::linear::Linearised;
use super::normal::Tangent;
use super::problem::Problem;
use super::significance::{chi_square_tail, of_smallest, two_sided};
use crate::model::row::{NOISE, REF_HARMONICS, Row, SLOTS};
use nalgebra::DVector;

/// Effective number of open data that a test of them needs.
const FEWEST_OPEN: f64 = 12.0;
/// Factor to which the size of open scatter is known.
const ROUGHLY: f64 = 3.0;
/// Bands of the tests for local structure.
pub(crate) const BANDS: usize = 14;

/// One test of the residual and its outcome.
#[derive(Debug, Clone)]
pub(crate) struct Outcome {
    pub(crate) slot: usize,
    pub(crate) axis: &'static str,
    /// Number of the shape within its slot: the same in all response slots.
    pub(crate) shape: usize,
    /// Standard normal deviate.
    pub(crate) z: f64,
}

/// Outcome of all tests.
#[derive(Debug, Clone)]
pub(crate) struct Structure {
    pub(crate) outcomes: Vec<Outcome>,
    /// Probability that pure noise leaves as much structure somewhere.
    pub(crate) p_value: f64,
    /// Residuals, one per datum.
    pub(crate) residual: Vec<f64>,
}

struct Test {
    slot: usize,
    axis: &'static str,
    shape: usize,
    column: Column,
}

/// Tests what a fit leaves.
pub(crate) fn examine(problem: &Problem, fit: &Fit, work: &mut Workspace) -> Structure {
    let bounded: Vec<bool> = problem.free.iter().map(|f| f.bounded).collect();
    let Some((evaluation, tangent)) = Linearised::new(problem, fit, work).tangent() else {
        return Structure {
            outcomes: Vec::new(),
            p_value: 0.0,
            residual: vec![0.0; problem.len()],
        };
    };
    // Where an effect leaves scatter open its size is a rough guess: such data count less.
    let counted: Vec<f64> = evaluation
        .residual
        .iter()
        .zip(&evaluation.weight)
        .enumerate()
        .map(|(at, (r, w))| r * (w * problem.uncertainty(at)).powi(2))
        .collect();
    // A search ends a little beside the best values, and they move with how much data count; a test
    // of a direction that hardly differs from one of theirs would enlarge the rest of the way.
    let (left, theta) = settled(problem, fit, &tangent, &counted);
    let tests = battery(problem);
    let loads: Vec<_> = tests.iter().map(|t| tangent.load(&t.column)).collect();
    let norms: Vec<f64> = tests
        .iter()
        .zip(&loads)
        .map(|(t, l)| (t.column.norm2() - l.dot(l)).max(1e-12))
        .collect();
    let usable: Vec<usize> = (0..tests.len())
        .filter(|i| norms[*i] > 1e-3 * tests[*i].column.norm2())
        .collect();
    // The residual of a fit has the covariance I - T G^-1 T'.
    let scores = |left: &[f64]| -> Vec<f64> {
        usable
            .iter()
            .map(|&i| tests[i].column.dot_data(problem, left) / norms[i].sqrt())
            .collect()
    };
    // A nuisance with a prior is estimated with the variance 1 - c about that prior.
    let covariance = tangent.covariance();
    let pulls = |values: &mut dyn Iterator<Item = f64>| -> f64 {
        let pulled = values.zip(&bounded).enumerate().filter(|(_, (_, b))| **b);
        pulled.fold(0.0, |most, (i, (value, _))| {
            let known = 1.0 - covariance[(i, i)];
            if known > 0.1 {
                most.max(value.abs() / known.sqrt())
            } else {
                most
            }
        })
    };
    let open = OpenData::new(problem, &evaluation, &tests);
    let pull = pulls(&mut theta.iter().copied()).max(open.largest(problem, &evaluation.residual));
    let here = fit_scores(&scores(&left), &left, problem, &tangent).min(two_sided(pull));
    let p_value = of_smallest(here, |draw| {
        let mut noise: Vec<f64> = (0..problem.len()).map(|_| draw.next()).collect();
        for (column, _) in tangent.columns.iter().zip(&bounded).filter(|(_, b)| **b) {
            let value = draw.next();
            for (slot, values) in &column.parts {
                for (n, v) in noise[problem.slots[*slot].clone()].iter_mut().zip(values) {
                    *n += value * v;
                }
            }
        }
        let (reduced, values) = tangent.reduce(problem, &noise);
        let pull = pulls(&mut values.iter().copied()).max(open.largest(problem, &noise));
        fit_scores(&scores(&reduced), &reduced, problem, &tangent).min(two_sided(pull))
    });
    let z = scores(&left);
    let outcomes = usable
        .iter()
        .zip(z)
        .map(|(&i, z)| Outcome {
            slot: tests[i].slot,
            axis: tests[i].axis,
            shape: tests[i].shape,
            z,
        })
        .collect();
    Structure {
        outcomes,
        p_value,
        residual: evaluation.residual,
    }
}

/// What is left at the best values of a tangent space, and the nuisances there.
fn settled(problem: &Problem, fit: &Fit, tangent: &Tangent, left: &[f64]) -> (Vec<f64>, Vec<f64>) {
    let nuisances = problem.free.iter().zip(&fit.theta);
    let pulled = nuisances.map(|(free, value)| if free.bounded { *value } else { 0.0 });
    // A parameter stays at its bound.
    let stays = fit.effects.iter().flat_map(|effect| {
        let bounds = effect.effect.about().parameters.iter();
        let values = bounds.zip(&effect.parameters);
        values.map(|(bound, value)| *value <= bound.lower || *value >= bound.upper)
    });
    let moves = vec![true; problem.free.len()];
    let moves = moves.into_iter().chain(stays.map(|stays| !stays));
    let pulled = pulled.chain(std::iter::repeat(0.0));
    let columns = tangent.columns.iter().zip(moves).zip(pulled);
    let gradient = columns.map(|((column, moves), pulled)| {
        if moves {
            column.dot_data(problem, left) - pulled
        } else {
            0.0
        }
    });
    let gradient = DVector::from_iterator(tangent.columns.len(), gradient);
    let step = tangent.solve(&gradient);
    let mut left = left.to_vec();
    for (column, by) in tangent.columns.iter().zip(step.iter()) {
        column.add_to(problem, &mut left, -by);
    }
    let theta = fit.theta.iter().zip(step.iter());
    (left, theta.map(|(value, by)| value + by).collect())
}

/// Tests of data whose scatter an effect leaves open: they may scatter, but not follow a pattern.
struct OpenData<'a> {
    tests: Vec<&'a Test>,
    /// Whether half of a datum's variance or more is open.
    open: Vec<bool>,
}

impl<'a> OpenData<'a> {
    fn new(problem: &Problem, evaluation: &Evaluation, tests: &'a [Test]) -> Self {
        let open: Vec<bool> = evaluation
            .weight
            .iter()
            .enumerate()
            .map(|(at, w)| w * problem.uncertainty(at) < 0.7)
            .collect();
        let covers = |test: &&Test| {
            let slot = &test.column.parts[0];
            let inside = slot.1.iter().zip(&open[problem.slots[slot.0].clone()]);
            let (mut square, mut fourth) = (0.0, 0.0);
            for (v, _) in inside.filter(|(_, open)| **open) {
                square += v * v;
                fourth += v.powi(4);
            }
            // How the noise itself is left open is a matter of shape: no pattern is asked of it.
            slot.0 < NOISE && square * square > FEWEST_OPEN * fourth
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
    fn largest(&self, problem: &Problem, residual: &[f64]) -> f64 {
        let open = residual.iter().zip(&self.open).filter(|(_, open)| **open);
        let outlier = open.fold(0.0, |m: f64, (r, _)| m.max(r.abs() / ROUGHLY));
        self.tests.iter().fold(outlier, |most: f64, test| {
            let (slot, values) = &test.column.parts[0];
            let range = problem.slots[*slot].clone();
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
        square += v * v * (r * r).max(0.25);
    }
    sum.abs() / square.sqrt().max(1e-300) * 0.9
}

/// The same of its sign: what is not locked to the excitation has either sign
/// by chance, however large, so that a few large data do not hide the others.
fn by_sign(data: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut sum, mut square) = (0.0, 0.0);
    for (v, r) in data.filter(|(v, _)| *v != 0.0) {
        let bounded = r.clamp(-1.0, 1.0);
        sum += v.signum() * bounded;
        square += (bounded * bounded).max(0.1);
    }
    sum.abs() / square.sqrt().max(1e-300)
}

/// Smallest p-value of all tests: directions, sums of squares by class, single outliers.
fn fit_scores(z: &[f64], residual: &[f64], problem: &Problem, tangent: &Tangent) -> f64 {
    let largest = z.iter().fold(0.0_f64, |m, z| m.max(z.abs()));
    let mut smallest = two_sided(largest);
    let idle = tangent.columns.len() as f64;
    let groups = [
        (0, REF_HARMONICS),
        (REF_HARMONICS, NOISE),
        (NOISE, SLOTS),
        (0, 2),
        (2, REF_HARMONICS),
    ];
    for (index, (from, to)) in groups.into_iter().enumerate() {
        let range = problem.slots[from].start..problem.slots[to - 1].end;
        let count = range.len() as f64;
        if count > 0.0 {
            let square: f64 = residual[range].iter().map(|r| r * r).sum();
            let taken = if index == 0 || index > 2 {
                (0.5 * idle).min(0.5 * count)
            } else {
                0.0
            };
            smallest = smallest.min(chi_square_tail(square, count - taken));
        }
    }
    let outlier = residual.iter().fold(0.0_f64, |m, r| m.max(r.abs()));
    smallest.min(-libm::expm1(
        residual.len() as f64 * libm::log1p(-two_sided(outlier).min(1.0 - 1e-15)),
    ))
}

fn battery(problem: &Problem) -> Vec<Test> {
    let facts = &problem.facts;
    let ln = |f: f64| {
        if facts.highest_hz > facts.lowest_hz {
            2.0 * (f / facts.lowest_hz).ln() / (facts.highest_hz / facts.lowest_hz).ln() - 1.0
        } else {
            0.0
        }
    };
    let mut tests = Vec::new();
    let mut shape_of = [0; SLOTS];
    let mut add = |slot: usize, axis: &'static str, shape: &dyn Fn(&Row) -> f64| {
        let range = problem.slots[slot].clone();
        if range.is_empty() {
            return;
        }
        let values: Vec<f64> = range
            .map(|at| finite(shape(&problem.rows[problem.row_of[at]])))
            .collect();
        shape_of[slot] += 1;
        if values.iter().any(|v| *v != 0.0) {
            tests.push(Test {
                slot,
                axis,
                shape: shape_of[slot],
                column: Column {
                    parts: vec![(slot, values)],
                },
            });
        }
    };
    for slot in (0..SLOTS).filter(|s| !problem.slots[*s].is_empty()) {
        let response = !(REF_HARMONICS..NOISE).contains(&slot);
        let most = if response { 7 } else { 2 };
        for order in 0..=most {
            add(slot, "frequency_hz", &|row| {
                legendre(order, ln(row.frequency_hz))
            });
        }
        for order in 0..=2 {
            let p = |row: &Row| legendre(order, ln(row.frequency_hz));
            add(slot, "acceleration_ms2", &|row| p(row) * row.level_ms2.ln());
            if response {
                add(slot, "inverse level", &|row| p(row) / row.level_ms2);
                if facts.rotation_varies {
                    add(slot, "rotation_deg", &|row| p(row) * row.rotation.0);
                    add(slot, "rotation_deg", &|row| p(row) * row.rotation.1);
                }
                if facts.payload_varies {
                    add(slot, "payload_kg", &|row| p(row) * row.payload_kg);
                }
                if facts.temperature_varies {
                    add(slot, "temperature_c", &|row| p(row) * row.warmer_k);
                }
                add(slot, "time_s", &|row| p(row) * row.time_s);
            }
        }
        add(slot, "acceleration_ms2", &|row| row.level_ms2);
        add(slot, "acceleration_ms2", &|row| {
            row.level_ms2 * row.level_ms2
        });
        add(slot, "travel_m", &|row| {
            row.level_ms2 / (row.omega * row.omega)
        });
        add(slot, "travel_m", &|row| {
            (row.level_ms2 / (row.omega * row.omega)).powi(2)
        });
        add(slot, "coil_v", &|row| row.coil_peak_v);
        if response {
            let bands = BANDS.min(facts.frequencies_hz.len());
            for band in 0..bands {
                let limit = |b: usize| {
                    facts.frequencies_hz[(b * facts.frequencies_hz.len() / bands)
                        .min(facts.frequencies_hz.len() - 1)]
                };
                let (low, high) = (
                    limit(band),
                    if band + 1 == bands {
                        f64::INFINITY
                    } else {
                        limit(band + 1)
                    },
                );
                add(slot, "frequency_hz", &|row| {
                    f64::from(u8::from((low..high).contains(&row.frequency_hz)))
                });
            }
        }
    }
    tests
}

fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

fn legendre(order: usize, x: f64) -> f64 {
    let (mut a, mut b) = (1.0, x);
    if order == 0 {
        return 1.0;
    }
    for n in 1..order {
        let k = n as f64;
        (a, b) = (b, ((2.0 * k + 1.0) * x * b - k * a) / (k + 1.0));
    }
    b
}

#[cfg(test)]
mod tests {
    use super::super::example::measured;
    use super::super::nuisance::Nuisance;
    use super::*;

    /// A gain that is off by one of its standard uncertainties costs 1 in the sum of squares, and
    /// any search may stop there. No structure is left by it.
    #[test]
    fn where_a_search_stops_is_no_structure() {
        let (rig, points) = measured(&[]);
        let problem = Problem::new(&rig, &points);
        let mut work = Workspace::new(&problem);
        let start = vec![0.0; problem.free.len()];
        let effort = super::super::fit::Effort::FULL;
        let mut fit = super::super::fit::refine(&problem, Vec::new(), start, effort, &mut work);
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
