//! A dataset as a fitting problem: whitened data by observable, nuisance parameters.

use super::nuisance::{Free, Nuisance, nuisances, stretched, stretched_slope};
use crate::dataset::{ExciterParameter, ExciterParameters, Measured, Point, Quantity, Rig};
use crate::estimation::column::Blocks;
use crate::model::facts::Facts;
use crate::model::memory::Memory;
use crate::model::prediction::Nominal;
use crate::model::row::Row;
use crate::observable::{Group, Observable, Table};
use crate::thresholds;
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// The fitting problem.
#[derive(Debug, Clone)]
pub(crate) struct Problem {
    pub(crate) rows: Vec<Row>,
    pub(crate) free: Vec<Free>,
    pub(crate) facts: Facts,
    /// Row of each datum; data are ordered by observable, then by row.
    pub(crate) row_of: Vec<usize>,
    data: Table<Range<usize>>,
    pub(super) base: Nominal,
    /// Relative standard uncertainties.
    exciter_u: ExciterParameters<f64>,
    pub(super) measured: Vec<f64>,
    u: Vec<f64>,
    /// One over the stated standard uncertainty.
    pub(super) stated_weight: Vec<f64>,
    /// The data once more in the order of the rows, and where each row starts.
    by_row: Vec<Datum>,
    first_of_row: Vec<usize>,
}

/// A measured value of a row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Datum {
    pub(super) observable: Observable,
    /// Place among all data.
    pub(super) at: usize,
    pub(super) measured: f64,
}

impl Problem {
    /// Sets the problem up from the points of a dataset.
    pub(crate) fn new(rig: &Rig, points: &[Point]) -> Self {
        let rows: Vec<Row> = points.iter().map(|p| Row::new(p, rig)).collect();
        Self::from_rows(rig, rows)
    }

    /// Sets the problem up from the measured part of a dataset, if it holds points.
    pub(crate) fn from_dataset(rig: &Rig, measured: &Measured) -> Option<Self> {
        match measured {
            Measured::Points { points, .. } => Some(Self::new(rig, points)),
            Measured::Record(_) => None,
        }
    }

    fn from_rows(rig: &Rig, rows: Vec<Row>) -> Self {
        let exciter = rig.exciter.and_then(|e| e.complete());
        let noise_v = rig.digitiser.noise_v.map_or(0.0, |q| q.value);
        let facts = Facts::new(&rows, exciter.map(|e| e.map(|q| q.value)), noise_v);
        let s1 = rig.reference.and_then(|t| t.sensitivity_v_per_ms2);
        let s2 = rig.dut.and_then(|t| t.sensitivity_v_per_ms2);
        let base = Nominal {
            exciter: exciter.map(|e| e.map(|q| q.value)),
            drive_ln: s1.map_or(0.0, |q| q.value.ln()),
            ratio_ln: s1.zip(s2).map_or(0.0, |(a, b)| (b.value / a.value).ln()),
            dut_gain: 1.0,
            reference_gain: 1.0,
            noise_v: [noise_v; 2],
            noise_ln: [noise_v.ln(); 2],
        };
        let exciter_u =
            exciter.map_or(ExciterParameters::all(0.0), |e| e.map(Quantity::relative_u));
        let free = nuisances(rig, &rows, &facts);
        let mut problem = Self {
            rows,
            free,
            facts,
            row_of: Vec::new(),
            data: Table::from_fn(|_| 0..0),
            base,
            exciter_u,
            measured: Vec::new(),
            u: Vec::new(),
            stated_weight: Vec::new(),
            by_row: Vec::new(),
            first_of_row: Vec::new(),
        };
        problem.lay_out();
        problem
    }

    fn lay_out(&mut self) {
        for (observable, data) in self.data.iter_mut() {
            let start = self.row_of.len();
            for (index, row) in self.rows.iter().enumerate() {
                if row.u[observable].is_finite() {
                    self.row_of.push(index);
                    self.measured.push(row.value[observable]);
                    self.u.push(row.u[observable]);
                    self.stated_weight.push(1.0 / row.u[observable]);
                }
            }
            *data = start..self.row_of.len();
        }
        let mut next = self.data.clone();
        for row in &self.rows {
            self.first_of_row.push(self.by_row.len());
            for (observable, place) in next.iter_mut() {
                if row.u[observable].is_finite()
                    && let Some(at) = place.next()
                {
                    self.by_row.push(Datum {
                        observable,
                        at,
                        measured: row.value[observable],
                    });
                }
            }
        }
        self.first_of_row.push(self.by_row.len());
    }

    /// Measured values of a row, in the order of the observables.
    pub(super) fn of_row(&self, row: usize) -> &[Datum] {
        &self.by_row[self.first_of_row[row]..self.first_of_row[row + 1]]
    }

    /// Keeps the rig with some of the rows only.
    pub(crate) fn subset(&self, rig: &Rig, keep: &dyn Fn(usize) -> bool) -> Self {
        let rows = self
            .rows
            .iter()
            .enumerate()
            .filter(|(i, _)| keep(*i))
            .map(|(_, r)| r.clone())
            .collect();
        Self::from_rows(rig, rows)
    }

    /// Some of the rows, with the uncertainties of each group of observables times a factor.
    pub(super) fn with_uncertainties(
        &self,
        rig: &Rig,
        keep: &dyn Fn(usize) -> bool,
        factor: &dyn Fn(Group) -> f64,
    ) -> Self {
        let kept = self.rows.iter().enumerate().filter(|(i, _)| keep(*i));
        let rescaled = kept.map(|(_, row)| {
            let mut row = row.clone();
            for (observable, u) in row.u.iter_mut() {
                *u *= factor(observable.group());
            }
            row
        });
        Self::from_rows(rig, rescaled.collect())
    }

    /// Nuisance values of another problem with the same rig, in the order of this one.
    pub(crate) fn translate(&self, other: &Self, theta: &[f64]) -> Vec<f64> {
        let of = |free: &Free| {
            let at = other.free.iter().position(|f| f.kind == free.kind);
            at.map_or(0.0, |i| theta[i])
        };
        self.free.iter().map(of).collect()
    }

    /// Objective that noise leaves at most: one per datum, and three standard deviations.
    pub(super) fn most_of_noise(&self) -> f64 {
        let count = self.len() as f64;
        count + thresholds::NOISE_CHI_SIGMA * (2.0 * count).sqrt()
    }

    /// Whether an objective is what noise leaves.
    pub(super) fn is_noise(&self, objective: f64) -> bool {
        objective < self.most_of_noise()
    }

    /// Number of data.
    pub(crate) fn len(&self) -> usize {
        self.row_of.len()
    }

    /// Data of an observable.
    pub(crate) fn data_of(&self, observable: Observable) -> Range<usize> {
        self.data[observable].clone()
    }

    /// Data of a group, its observables one after the other.
    pub(crate) fn data_of_group(&self, group: Group) -> Range<usize> {
        let data = group
            .observables()
            .map(|observable| self.data_of(observable));
        data.reduce(|a, b| a.start..b.end).unwrap_or_default()
    }

    /// Observables that were measured, with their data.
    pub(crate) fn measured_observables(&self) -> impl Iterator<Item = (Observable, Range<usize>)> {
        let all = self.data.iter().map(|(o, data)| (o, data.clone()));
        all.filter(|(_, data)| !data.is_empty())
    }

    /// Datum of an observable in a row, if it was measured.
    pub(super) fn datum(&self, row: usize, observable: Observable) -> Option<usize> {
        let mut inside = self.of_row(row).iter().rev();
        inside.find(|d| d.observable == observable).map(|d| d.at)
    }

    /// Stated standard uncertainty of a datum.
    pub(crate) fn uncertainty(&self, datum: usize) -> f64 {
        self.u[datum]
    }

    /// Fresh memory for the balances.
    pub(crate) fn memory(&self) -> Vec<Memory> {
        vec![Memory::default(); self.rows.len()]
    }

    /// Relative change of a nominal value with its nuisance value.
    pub(super) fn relative_unit(&self, free: &Free, theta: f64) -> f64 {
        match free.kind {
            Nuisance::Exciter(parameter) => {
                let u = self.exciter_u[parameter];
                stretched_slope(u * theta, u) * u / stretched(u * theta, u)
            }
            _ => free.unit,
        }
    }

    /// Values of the exciter for nuisance values.
    pub(super) fn exciter(&self, theta: &[f64]) -> Option<ExciterParameters<f64>> {
        self.nominal(theta).exciter
    }

    /// Value of a parameter of the exciter for a nuisance value.
    pub(crate) fn exciter_value(&self, parameter: ExciterParameter, theta: f64) -> f64 {
        let value = self.base.exciter.map_or(0.0, |e| e[parameter]);
        let u = self.exciter_u[parameter];
        value * stretched(u * theta, u)
    }
}

impl Blocks for Problem {
    type Block = Observable;

    fn data_of(&self, observable: Observable) -> Range<usize> {
        self.data[observable].clone()
    }

    fn blocks(&self) -> impl Iterator<Item = (Observable, Range<usize>)> {
        self.measured_observables()
    }
}

/// Column of a Jacobian, sparse by observable.
pub(crate) type Column = crate::estimation::column::Column<Observable>;
/// Tangent space of a fit.
pub(crate) type Tangent = crate::estimation::tangent::Tangent<Observable>;

/// An angle within half a turn of zero.
pub(crate) fn wrapped(angle: f64) -> f64 {
    if angle.abs() <= PI {
        angle
    } else {
        angle - TAU * (angle / TAU).round()
    }
}
