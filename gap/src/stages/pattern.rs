//! What part of the chain a deviation comes from, without the formula of any effect.
//!
//! An effect of some part of the chain may have any course over frequency, but not in any
//! observable: one of the reference is in the ratio and, mirrored, in the drive; one of the mount
//! turns with the device or grows with the payload; one of the exciter spares the ratio. Each
//! [`Kind`] is such a rule with free courses; the one that accounts for most of the residual, less
//! the cost of what it leaves free, is the class of the gap.

use crate::engine::column::Column;
use crate::engine::fit::{Fit, Workspace};
use crate::engine::linear::Linearised;
use crate::engine::normal::Tangent;
use crate::engine::nuisance::Nuisance;
use crate::engine::problem::Problem;
use crate::model::row::{CURRENT, DRIVE, NOISE, RATIO, Row, SLOTS};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// A rule: which observables deviate together, and along which condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The ratio, over frequency only.
    Ratio,
    /// The phase of the ratio, growing with time.
    PhaseInTime,
    /// The ratio, with the cosine and sine of the rotation.
    Rotation,
    /// The ratio, in proportion to the payload.
    Payload,
    /// The ratio, with temperature.
    Temperature,
    /// The ratio, with time.
    Time,
    /// The ratio, with level.
    Level,
    /// Ratio and drive, equal and opposite, over frequency.
    Mirrored,
    /// The same, with temperature or time.
    MirroredSlow,
    /// The same, with level.
    MirroredLevel,
    /// The drive alone, with time.
    DriveInTime,
    /// Drive and current, over frequency or level.
    Exciter,
    /// Drive and current, with time.
    ExciterInTime,
    /// Noise of the channel of the device alone.
    NoiseOfDut,
    /// Noise of the reference channel or of both.
    NoiseOfBoth,
}

/// A class of deviation with the chi-square it accounts for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Found {
    pub(crate) kind: Kind,
    pub(crate) gain: f64,
}

/// A rule with one choice of free courses.
pub(super) struct Pattern {
    kind: Kind,
    columns: Vec<Column>,
    loads: Vec<DVector<f64>>,
    /// Of the normal matrix, the nuisances taken out.
    factor: Cholesky<f64, Dyn>,
    cost: f64,
}

impl Pattern {
    pub(super) fn new(
        problem: &Problem,
        tangent: &Tangent,
        kind: Kind,
        columns: Vec<Column>,
    ) -> Option<Self> {
        let loads: Vec<DVector<f64>> = columns.iter().map(|c| tangent.load(c)).collect();
        let mut matrix = DMatrix::zeros(columns.len(), columns.len());
        for i in 0..columns.len() {
            for j in 0..=i {
                let value = columns[i].dot(&columns[j]) - loads[i].dot(&loads[j]);
                (matrix[(i, j)], matrix[(j, i)]) = (value, value);
            }
            matrix[(i, i)] += RIDGE * columns[i].norm2();
        }
        let data = touched(&columns)
            .map(|slot| problem.slots[slot].len())
            .sum::<usize>();
        Some(Self {
            kind,
            factor: Cholesky::new(matrix)?,
            cost: columns.len() as f64 * (data as f64).ln(),
            columns,
            loads,
        })
    }

    /// Sizes of the columns that fit a residual best, and the chi-square they take out.
    pub(super) fn fit(&self, problem: &Problem, residual: &[f64]) -> (DVector<f64>, f64) {
        let dots = self.columns.iter().map(|c| c.dot_data(problem, residual));
        let vector = DVector::from_iterator(self.columns.len(), dots);
        let sizes = self.factor.solve(&vector);
        let gain = sizes.dot(&vector);
        (sizes, gain)
    }

    /// Takes the pattern out of a residual, the nuisances refitted.
    fn take_out(&self, problem: &Problem, tangent: &Tangent, residual: &mut [f64]) {
        let (sizes, _) = self.fit(problem, residual);
        let mut load = DVector::zeros(tangent.columns.len());
        for (part, size) in self.loads.iter().zip(sizes.iter()) {
            load.axpy(*size, part, 1.0);
        }
        let refitted = tangent.unload(load);
        for (column, size) in self.columns.iter().zip(sizes.iter()) {
            column.add_to(problem, residual, -size);
        }
        for (column, size) in tangent.columns.iter().zip(refitted.iter()) {
            column.add_to(problem, residual, *size);
        }
    }
}

/// Orders of the smooth courses that are tried, before bands.
const ORDERS: [usize; 3] = [0, 2, 5];
/// Most bands of a course with a sharp feature.
const MOST_BANDS: usize = 26;
/// Ridge that keeps directions still which the nuisances take over.
const RIDGE: f64 = 1e-6;

/// The two classes that account for most of what a fit leaves, the second of what the first leaves.
pub(crate) fn classes(problem: &Problem, fit: &Fit, work: &mut Workspace) -> Vec<Found> {
    let Some((evaluation, tangent)) = Linearised::new(problem, fit, work).tangent() else {
        return Vec::new();
    };
    let library = Library::new(problem, &evaluation.weight, &tangent, fit);
    let mut residual = at_the_optimum(problem, fit, &tangent, evaluation.residual);
    let mut found: Vec<Found> = Vec::new();
    for _ in 0..2 {
        let others = library
            .patterns
            .iter()
            .filter(|p| found.iter().all(|f| f.kind != p.kind));
        let gains = others.map(|p| (p, p.fit(problem, &residual).1));
        let best = gains.max_by(|a, b| (a.1 - a.0.cost).total_cmp(&(b.1 - b.0.cost)));
        let Some((pattern, gain)) = best.filter(|(p, gain)| *gain > p.cost) else {
            break;
        };
        let kind = pattern.kind;
        found.push(Found { kind, gain });
        pattern.take_out(problem, &tangent, &mut residual);
    }
    found
}

/// The residual where the nuisances stand still: a fit may have stopped a little before.
pub(super) fn at_the_optimum(
    problem: &Problem,
    fit: &Fit,
    tangent: &Tangent,
    mut residual: Vec<f64>,
) -> Vec<f64> {
    let pulls = problem.free.iter().zip(&fit.theta);
    let pulls = pulls.map(|(free, theta)| if free.bounded { *theta } else { 0.0 });
    let dots = tangent
        .columns
        .iter()
        .map(|c| c.dot_data(problem, &residual));
    let gradient = dots.zip(pulls).map(|(dot, pull)| dot - pull);
    let gradient = DVector::from_iterator(tangent.columns.len(), gradient);
    for (column, size) in tangent.columns.iter().zip(tangent.solve(&gradient).iter()) {
        column.add_to(problem, &mut residual, -size);
    }
    residual
}

/// A course over frequency: one function of the frequency for each free amount.
pub(super) type Course = Vec<Box<dyn Fn(f64) -> f64>>;

/// Chebyshev polynomials of the logarithm of frequency.
fn smooth(problem: &Problem, order: usize) -> Course {
    let facts = &problem.facts;
    let (low, high) = (facts.lowest_hz.ln(), facts.highest_hz.ln());
    let place = move |f: f64| {
        if high > low {
            (2.0 * (f.ln() - low) / (high - low) - 1.0).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    };
    let term = |k: usize| -> Box<dyn Fn(f64) -> f64> {
        Box::new(move |f| (k as f64 * place(f).acos()).cos())
    };
    (0..=order).map(term).collect()
}

/// Steps, one for each few of the frequencies.
pub(super) fn bands(problem: &Problem) -> Course {
    let frequencies = &problem.facts.frequencies_hz;
    let count = MOST_BANDS.min(frequencies.len());
    let edge = |b: usize| {
        let at = b * frequencies.len() / count;
        frequencies.get(at).copied().unwrap_or(f64::INFINITY)
    };
    let band = |b: usize| -> Box<dyn Fn(f64) -> f64> {
        let inside = edge(b)..edge(b + 1);
        Box::new(move |f| f64::from(u8::from(inside.contains(&f))))
    };
    (0..count).map(band).collect()
}

/// Slots of a rule with the sign of the deviation in each.
pub(super) type Parts = [(usize, f64)];

const IN_RATIO: [&Parts; 2] = [&[(RATIO, 1.0)], &[(RATIO + 1, 1.0)]];
const SIZE_OF_RATIO: [&Parts; 1] = [&[(RATIO, 1.0)]];
const PHASE_OF_RATIO: [&Parts; 1] = [&[(RATIO + 1, 1.0)]];
const IN_BOTH: [&Parts; 2] = [
    &[(RATIO, -1.0), (DRIVE, 1.0)],
    &[(RATIO + 1, -1.0), (DRIVE + 1, 1.0)],
];
const IN_DRIVE: [&Parts; 1] = [&[(DRIVE, 1.0)]];
const IN_EXCITER: [&Parts; 4] = [
    &[(DRIVE, 1.0)],
    &[(DRIVE + 1, 1.0)],
    &[(CURRENT, 1.0)],
    &[(CURRENT + 1, 1.0)],
];

/// All rules with all courses.
struct Library<'a> {
    problem: &'a Problem,
    weight: &'a [f64],
    tangent: &'a Tangent,
    patterns: Vec<Pattern>,
}

impl<'a> Library<'a> {
    fn new(problem: &'a Problem, weight: &'a [f64], tangent: &'a Tangent, fit: &Fit) -> Self {
        let mut library = Self {
            problem,
            weight,
            tangent,
            patterns: Vec::new(),
        };
        for order in ORDERS {
            let course = smooth(problem, order);
            library.add_sharp(&course);
            library.add_smooth(&course);
        }
        library.add_sharp(&bands(problem));
        library.add_values(fit);
        library.add_noise();
        library
    }

    /// Rules whose course may have a resonance.
    fn add_sharp(&mut self, course: &Course) {
        let turning: [fn(&Row) -> f64; 2] = [|r| r.rotation.0, |r| r.rotation.1];
        self.add(Kind::Ratio, &IN_RATIO, course, &[|_| 1.0]);
        self.add(Kind::Mirrored, &IN_BOTH, course, &[|_| 1.0]);
        self.add(Kind::Rotation, &IN_RATIO, course, &turning);
        self.add(Kind::Payload, &IN_RATIO, course, &[|r| r.payload_kg]);
        self.add(Kind::Exciter, &IN_EXCITER, course, &[|_| 1.0]);
        self.add(Kind::Exciter, &IN_EXCITER[..2], course, &[|_| 1.0]);
    }

    /// Rules that depend on time, temperature or level, without sharp features.
    fn add_smooth(&mut self, course: &Course) {
        let slow: [fn(&Row) -> f64; 2] = [|r| r.warmer_k, |r| r.time_s];
        let level: [fn(&Row) -> f64; 2] = [|r| r.level_ms2, |r| 1.0 / r.level_ms2];
        self.add(Kind::PhaseInTime, &PHASE_OF_RATIO, course, &[slow[1]]);
        self.add(Kind::Temperature, &SIZE_OF_RATIO, course, &[slow[0]]);
        self.add(Kind::Time, &SIZE_OF_RATIO, course, &[slow[1]]);
        self.add(Kind::DriveInTime, &IN_DRIVE, course, &[slow[1]]);
        self.add(Kind::ExciterInTime, &IN_EXCITER, course, &[slow[1]]);
        for one in slow {
            self.add(Kind::MirroredSlow, &IN_BOTH[..1], course, &[one]);
        }
        for one in level {
            self.add(Kind::Level, &SIZE_OF_RATIO, course, &[one]);
            self.add(Kind::MirroredLevel, &IN_BOTH[..1], course, &[one]);
            self.add(Kind::Exciter, &IN_EXCITER, course, &[one]);
        }
    }

    /// The values of the exciter, beyond their stated uncertainty.
    fn add_values(&mut self, fit: &Fit) {
        let of_exciter = |i: &usize| matches!(self.problem.free[*i].kind, Nuisance::Exciter(_));
        let every: Vec<usize> = (0..fit.theta.len()).filter(of_exciter).collect();
        let columns = |list: &[usize]| -> Vec<Column> {
            let columns = list.iter().map(|i| self.tangent.columns[*i].clone());
            columns.collect()
        };
        let mut sets: Vec<Vec<Column>> = every.iter().map(|i| columns(&[*i])).collect();
        sets.push(columns(&every));
        for set in sets {
            self.push(Kind::Exciter, set);
        }
    }

    fn add_noise(&mut self) {
        let shapes: [fn(&Row) -> f64; 3] = [
            |_| 1.0,
            |r| r.frequency_hz.ln(),
            |r| {
                if r.level_ms2 > 0.0 {
                    r.level_ms2.ln()
                } else {
                    0.0
                }
            },
        ];
        for count in [1, 3] {
            for (kind, channels) in [
                (Kind::NoiseOfDut, &[1][..]),
                (Kind::NoiseOfBoth, &[0]),
                (Kind::NoiseOfBoth, &[0, 1]),
            ] {
                let columns = channels.iter().flat_map(|c| {
                    let parts = [(NOISE + c, 1.0)];
                    let of = |shape: &fn(&Row) -> f64| self.column(&parts, shape);
                    shapes[..count].iter().map(of).collect::<Vec<_>>()
                });
                let columns = columns.collect();
                self.push(kind, columns);
            }
        }
    }

    fn add(&mut self, kind: Kind, parts: &[&Parts], course: &Course, along: &[fn(&Row) -> f64]) {
        let mut columns = Vec::new();
        for part in parts {
            for shape in course {
                for condition in along {
                    let value = |row: &Row| shape(row.frequency_hz) * condition(row);
                    columns.push(self.column(part, &value));
                }
            }
        }
        self.push(kind, columns);
    }

    fn column(&self, parts: &Parts, shape: &dyn Fn(&Row) -> f64) -> Column {
        column(self.problem, self.weight, parts, shape)
    }

    fn push(&mut self, kind: Kind, mut columns: Vec<Column>) {
        columns.retain(|c| c.norm2() > 0.0);
        if columns.is_empty() {
            return;
        }
        self.patterns
            .extend(Pattern::new(self.problem, self.tangent, kind, columns));
    }
}

/// A column of whitened data; what is not finite or was not measured deviates by nothing.
pub(super) fn column(
    problem: &Problem,
    weight: &[f64],
    parts: &Parts,
    shape: &dyn Fn(&Row) -> f64,
) -> Column {
    let value = |at: usize| {
        let value = shape(&problem.rows[problem.row_of[at]]);
        if value.is_finite() {
            value * weight[at]
        } else {
            0.0
        }
    };
    let filled = parts.iter().map(|(slot, sign)| {
        let range = problem.slots[*slot].clone();
        (*slot, range.map(|at| sign * value(at)).collect::<Vec<_>>())
    });
    Column {
        parts: filled
            .filter(|(_, v)| v.iter().any(|x| *x != 0.0))
            .collect(),
    }
}

/// Slots in which columns have values.
fn touched(columns: &[Column]) -> impl Iterator<Item = usize> {
    (0..SLOTS).filter(|slot| columns.iter().any(|c| c.parts.iter().any(|p| p.0 == *slot)))
}
