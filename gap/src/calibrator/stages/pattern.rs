//! Patterns of a deviation: the kinds there are, and columns with free amounts that take each out of
//! a residual.

use crate::calibrator::problem::{Column, Problem, Tangent};
use crate::estimation::tangent::Beside;
use crate::model::row::Row;
use crate::observable::Observable;
use crate::thresholds;
use nalgebra::{Cholesky, DVector, Dyn};

/// A rule with one choice of free courses.
pub(super) struct Pattern {
    pub(super) kind: Kind,
    columns: Vec<Column>,
    beside: Beside,
    /// Of the normal matrix, the nuisances taken out.
    factor: Cholesky<f64, Dyn>,
    /// Chi-square that pays for the free amounts: their number times the logarithm of that of the data.
    pub(super) cost: f64,
}

impl Pattern {
    pub(super) fn new(
        problem: &Problem,
        tangent: &Tangent,
        kind: Kind,
        columns: Vec<Column>,
    ) -> Option<Self> {
        if columns.iter().any(|c| c.norm2() == 0.0) {
            return None;
        }
        let beside = tangent.beside(&columns, thresholds::PATTERN_RIDGE);
        let data = touched(&columns)
            .map(|observable| problem.data_of(observable).len())
            .sum::<usize>();
        Some(Self {
            kind,
            factor: Cholesky::new(beside.matrix.clone())?,
            cost: columns.len() as f64 * (data as f64).ln(),
            columns,
            beside,
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
    pub(super) fn take_out(&self, problem: &Problem, tangent: &Tangent, residual: &mut [f64]) {
        let (sizes, _) = self.fit(problem, residual);
        let refitted = tangent.refitted(&self.beside, &sizes);
        for (column, size) in self.columns.iter().zip(sizes.iter()) {
            column.add_to(problem, residual, -size);
        }
        for (column, size) in tangent.columns.iter().zip(refitted.iter()) {
            column.add_to(problem, residual, -size);
        }
    }
}

/// Observables of a rule with the sign of the deviation in each.
pub(super) type Parts = [(Observable, f64)];

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
    let filled = parts.iter().map(|(observable, sign)| {
        let data = problem.data_of(*observable);
        (
            *observable,
            data.map(|at| sign * value(at)).collect::<Vec<_>>(),
        )
    });
    Column {
        parts: filled
            .filter(|(_, v)| v.iter().any(|x| *x != 0.0))
            .collect(),
    }
}

/// Observables for which columns have values.
fn touched(columns: &[Column]) -> impl Iterator<Item = Observable> {
    let parts = || columns.iter().flat_map(|c| &c.parts);
    let all = Observable::ALL.into_iter();
    all.filter(move |observable| parts().any(|p| p.0 == *observable))
}

/// A rule: which observables deviate together, and along which condition.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The ratio, over frequency only.
    Ratio,
    /// The phase of the ratio, growing with time.
    PhaseInTime,
    /// The ratio, with the cosine and sine of the rotation, or of twice that.
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
    /// Mirrored, with temperature or time.
    MirroredSlow,
    /// Mirrored, with level.
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

/// Most bands of a course with a sharp feature.
const MOST_BANDS: usize = 26;

/// A course over frequency: one function of the frequency for each free amount.
pub(super) type Course = Vec<Box<dyn Fn(f64) -> f64>>;

/// Chebyshev polynomials of the logarithm of frequency.
pub(super) fn smooth(problem: &Problem, order: usize) -> Course {
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
