//! A dataset as a fitting problem: whitened data, nuisance parameters, slots.

use super::nuisance::{Free, Nuisance, nuisances, stretched, stretched_slope};
use crate::dataset::{Measured, Point, Quantity, Rig};
use crate::effects::Facts;
use crate::model::memory::Memory;
use crate::model::prediction::Nominal;
use crate::model::row::{CURRENT, Row, SLOTS};
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// The fitting problem.
#[derive(Debug, Clone)]
pub(crate) struct Problem {
    pub(crate) rows: Vec<Row>,
    pub(crate) free: Vec<Free>,
    pub(crate) facts: Facts,
    /// Row of each datum; data are ordered by slot, then by row.
    pub(crate) row_of: Vec<usize>,
    /// Data of each slot.
    pub(crate) slots: [Range<usize>; SLOTS],
    pub(super) base: Nominal,
    exciter_u: [f64; 6],
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
    pub(super) slot: usize,
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
        let exciter_u = exciter.map_or([0.0; 6], |e| e.map(Quantity::relative_u));
        let free = nuisances(rig, &rows, &facts);
        let mut problem = Self {
            rows,
            free,
            facts,
            row_of: Vec::new(),
            slots: std::array::from_fn(|_| 0..0),
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
        for slot in 0..SLOTS {
            let start = self.row_of.len();
            for (index, row) in self.rows.iter().enumerate() {
                if row.u[slot].is_finite() {
                    self.row_of.push(index);
                    self.measured.push(row.value[slot]);
                    self.u.push(row.u[slot]);
                    self.stated_weight.push(1.0 / row.u[slot]);
                }
            }
            self.slots[slot] = start..self.row_of.len();
        }
        let mut next = self.slots.clone();
        for row in &self.rows {
            self.first_of_row.push(self.by_row.len());
            for (slot, place) in next.iter_mut().enumerate() {
                if row.u[slot].is_finite()
                    && let Some(at) = place.next()
                {
                    let measured = row.value[slot];
                    self.by_row.push(Datum { slot, at, measured });
                }
            }
        }
        self.first_of_row.push(self.by_row.len());
    }

    /// What was measured in a row, by slot.
    pub(super) fn of_row(&self, row: usize) -> &[Datum] {
        &self.by_row[self.first_of_row[row]..self.first_of_row[row + 1]]
    }

    /// The same rig with some of the rows only.
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

    /// Nuisance values of another problem with the same rig, in the order of this one.
    pub(crate) fn translate(&self, other: &Self, theta: &[f64]) -> Vec<f64> {
        let of = |free: &Free| {
            let at = other.free.iter().position(|f| f.kind == free.kind);
            at.map_or(0.0, |i| theta[i])
        };
        self.free.iter().map(of).collect()
    }

    /// Number of data.
    pub(crate) fn len(&self) -> usize {
        self.row_of.len()
    }

    /// Slot of a datum.
    pub(crate) fn slot_of(&self, datum: usize) -> usize {
        (0..SLOTS)
            .find(|s| self.slots[*s].contains(&datum))
            .unwrap_or(SLOTS - 1)
    }

    /// Datum in a slot of a row, if it was measured.
    pub(super) fn datum(&self, row: usize, slot: usize) -> Option<usize> {
        let inside = self.of_row(row).iter().rev();
        inside.into_iter().find(|d| d.slot == slot).map(|d| d.at)
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
            Nuisance::Exciter(i) => {
                let u = self.exciter_u[i];
                stretched_slope(u * theta, u) * u / stretched(u * theta, u)
            }
            _ => free.unit,
        }
    }

    /// Values of the exciter for nuisance values.
    pub(super) fn exciter(&self, theta: &[f64]) -> Option<[f64; 6]> {
        self.nominal(theta).exciter
    }

    /// Value of one exciter entry for a nuisance value.
    pub(crate) fn exciter_value(&self, index: usize, theta: f64) -> f64 {
        let value = self.base.exciter.map_or(0.0, |e| e[index]);
        value * stretched(self.exciter_u[index] * theta, self.exciter_u[index])
    }
}

/// Whether a slot is a phase, known up to whole turns.
pub(crate) fn is_phase(slot: usize) -> bool {
    slot < CURRENT + 2 && slot % 2 == 1
}

/// An angle within half a turn of zero.
pub(crate) fn wrapped(angle: f64) -> f64 {
    if angle.abs() <= PI {
        angle
    } else {
        angle - TAU * (angle / TAU).round()
    }
}
