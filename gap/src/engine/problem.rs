//! A dataset as a fitting problem: whitened data, nuisance parameters, slots.

use super::nuisance::{Free, Nuisance, nuisances, slope, stretched, stretched_slope};
use super::remainder::Remainders;
use crate::dataset::{Measured, Point, Rig};
use crate::effects::{Active, Facts};
use crate::model::predict::{Memory, Nominal, Prediction, Recall, predict};
use crate::model::row::{CURRENT, DRIVE, NOISE, RATIO, Row, SLOTS};
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
    base: Nominal,
    exciter_u: [f64; 6],
    pub(super) measured: Vec<f64>,
    u: Vec<f64>,
    /// Place of each row's slots in the data.
    place: Vec<[u32; SLOTS]>,
}

/// State of the simulation for one set of effects and nuisance values.
#[derive(Debug, Clone)]
pub(crate) struct Evaluation {
    /// (measured - simulated)/u.
    pub(crate) residual: Vec<f64>,
    /// 1/u, lowered where an effect leaves scatter open.
    pub(crate) weight: Vec<f64>,
    /// Sum of squares, priors and the logarithm of widened uncertainties: -2 ln posterior.
    pub(crate) objective: f64,
    /// Rows whose balance was not reached.
    pub(crate) diverged: usize,
}

/// One column of a Jacobian: values in the slots it touches.
#[derive(Debug, Clone, Default)]
pub(crate) struct Column {
    pub(crate) parts: Vec<(usize, Vec<f64>)>,
}

/// Memory of all rows, as an evaluation uses it.
pub(crate) enum Memories<'a> {
    Keep(&'a mut [Memory]),
    Look(&'a [Memory]),
}

impl Memories<'_> {
    fn of(&mut self, row: usize) -> Recall<'_> {
        match self {
            Self::Keep(memory) => Recall::Keep(&mut memory[row]),
            Self::Look(memory) => Recall::Look(&memory[row]),
        }
    }
}

const ABSENT: u32 = u32::MAX;

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
        };
        let exciter_u = exciter.map_or([0.0; 6], |e| e.map(|q| q.u / q.value));
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
            place: Vec::new(),
        };
        problem.lay_out();
        problem
    }

    fn lay_out(&mut self) {
        self.place = vec![[ABSENT; SLOTS]; self.rows.len()];
        for slot in 0..SLOTS {
            let start = self.row_of.len();
            for (index, row) in self.rows.iter().enumerate() {
                if row.u[slot].is_finite() {
                    self.place[index][slot] = self.row_of.len() as u32;
                    self.row_of.push(index);
                    self.measured.push(row.value[slot]);
                    self.u.push(row.u[slot]);
                }
            }
            self.slots[slot] = start..self.row_of.len();
        }
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
        let at = self.place[row][slot];
        (at != ABSENT).then_some(at as usize)
    }

    /// Stated standard uncertainty of a datum.
    pub(crate) fn uncertainty(&self, datum: usize) -> f64 {
        self.u[datum]
    }

    /// Fresh memory for the balances.
    pub(crate) fn memory(&self) -> Vec<Memory> {
        vec![Memory::default(); self.rows.len()]
    }

    /// Value of one exciter entry for a nuisance value.
    pub(crate) fn exciter_value(&self, index: usize, theta: f64) -> f64 {
        let value = self.base.exciter.map_or(0.0, |e| e[index]);
        value * stretched(self.exciter_u[index] * theta, self.exciter_u[index])
    }

    pub(super) fn nominal(&self, theta: &[f64]) -> Nominal {
        let mut nominal = self.base.clone();
        for (free, &value) in self.free.iter().zip(theta) {
            let change = value * free.unit;
            match free.kind {
                Nuisance::RatioGain => {
                    nominal.ratio_ln += change;
                    nominal.dut_gain *= change.exp();
                }
                Nuisance::DriveGain => {
                    nominal.drive_ln += change;
                    if free.bounded {
                        nominal.reference_gain *= change.exp();
                    }
                }
                Nuisance::Exciter(i) => {
                    if let Some(exciter) = nominal.exciter.as_mut() {
                        exciter[i] = self.exciter_value(i, value);
                    }
                }
                Nuisance::Noise(channel) => nominal.noise_v[channel] *= change.exp(),
                Nuisance::RunReference(_) | Nuisance::RunDut(_) => {}
            }
        }
        nominal
    }

    /// Added to ln ratio and ln drive by the gains of each run.
    fn run_gains(&self, theta: &[f64]) -> Vec<[f64; 2]> {
        let runs = self.rows.iter().map(|r| r.run).max().unwrap_or(0) + 1;
        let mut gains = vec![[0.0; 2]; runs];
        for (free, &value) in self.free.iter().zip(theta) {
            match free.kind {
                Nuisance::RunReference(run) => {
                    gains[run][0] -= value * free.unit;
                    gains[run][1] += value * free.unit;
                }
                Nuisance::RunDut(run) => gains[run][0] += value * free.unit,
                _ => {}
            }
        }
        gains
    }

    /// Calls `visit(row, prediction)` for every row.
    pub(crate) fn predictions(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: Memories<'_>,
        mut visit: impl FnMut(usize, &Prediction),
    ) {
        let mut memory = memory;
        let nominal = self.nominal(theta);
        let gains = self.run_gains(theta);
        // The reference holds the level, with its gain in each run.
        let of_run: Vec<Nominal> = gains
            .iter()
            .map(|g| Nominal {
                reference_gain: nominal.reference_gain * g[1].exp(),
                ..nominal.clone()
            })
            .collect();
        for (index, row) in self.rows.iter().enumerate() {
            let mut prediction = predict(row, &of_run[row.run], effects, memory.of(index));
            prediction.value[RATIO] += gains[row.run][0];
            prediction.value[DRIVE] += gains[row.run][1];
            visit(index, &prediction);
        }
    }

    /// Compares simulation and measurement.
    pub(crate) fn evaluate(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: &mut [Memory],
    ) -> Evaluation {
        self.evaluate_with(effects, theta, Memories::Keep(memory), |_, _| {})
    }

    /// The same a small step aside: starts from the memory and leaves it as it is.
    pub(crate) fn evaluate_aside(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: &[Memory],
    ) -> Evaluation {
        self.evaluate_with(effects, theta, Memories::Look(memory), |_, _| {})
    }

    fn evaluate_with(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: Memories<'_>,
        mut visit: impl FnMut(usize, &Prediction),
    ) -> Evaluation {
        let mut evaluation = Evaluation {
            residual: vec![0.0; self.len()],
            weight: vec![0.0; self.len()],
            objective: self.prior(theta),
            diverged: 0,
        };
        let mut remainders = Remainders::default();
        self.predictions(effects, theta, memory, |index, prediction| {
            evaluation.diverged += usize::from(prediction.diverged);
            self.compare(index, prediction, &mut evaluation);
            self.compare_remainder(index, prediction, &evaluation, &mut remainders);
            visit(index, prediction);
        });
        remainders.settle(&mut evaluation);
        // A balance that fails on many rows is no description of them.
        evaluation.objective += 1e3 * evaluation.diverged as f64;
        if !evaluation.objective.is_finite() {
            evaluation.objective = f64::MAX;
        }
        evaluation
    }

    /// What the noise would be with the harmonics above 5 in it.
    fn compare_remainder(
        &self,
        index: usize,
        prediction: &Prediction,
        evaluation: &Evaluation,
        remainders: &mut Remainders,
    ) {
        for channel in 0..2 {
            let at = self.place[index][NOISE + channel];
            let power = prediction.noise_power_v2[channel];
            let added = prediction.remainder_v2[channel];
            if at == ABSENT || power <= 0.0 || added <= 1e-9 * power {
                continue;
            }
            let at = at as usize;
            let rise = 0.5 * (1.0 + added / power).ln();
            let difference = self.measured[at] - prediction.value[NOISE + channel] - rise;
            let open = prediction.open[NOISE + channel]
                + (prediction.remainder_open[channel] * rise).powi(2);
            let u = self.u[at];
            let ratio = 1.0 + open / (u * u);
            let weight = 1.0 / (u * ratio.sqrt());
            let before = evaluation.residual[at];
            let plain = 1.0 / (u * evaluation.weight[at]).powi(2);
            remainders.data.push((at, difference * weight, weight));
            remainders.gain +=
                before * before + plain.ln() - (difference * weight).powi(2) - ratio.ln();
        }
    }

    /// Nuisance values with the noise of healthy channels at its stated value: a fit
    /// without an effect that makes noise has stretched it.
    pub(crate) fn stated_noise(&self, theta: &[f64]) -> Vec<f64> {
        let relaxed = self.free.iter().zip(theta).map(|(free, value)| {
            if matches!(free.kind, Nuisance::Noise(_)) {
                0.0
            } else {
                *value
            }
        });
        relaxed.collect()
    }

    fn prior(&self, theta: &[f64]) -> f64 {
        self.free
            .iter()
            .zip(theta)
            .filter(|(f, _)| f.bounded)
            .map(|(_, t)| t * t)
            .sum()
    }

    fn compare(&self, index: usize, prediction: &Prediction, evaluation: &mut Evaluation) {
        for (slot, &at) in self.place[index].iter().enumerate() {
            if at == ABSENT {
                continue;
            }
            let at = at as usize;
            let mut difference = self.measured[at] - prediction.value[slot];
            if is_phase(slot) {
                difference = wrapped(difference);
            }
            let (u, open) = (self.u[at], prediction.open[slot]);
            let weight = if open > 0.0 {
                let ratio = 1.0 + open / (u * u);
                evaluation.objective += ratio.ln();
                1.0 / (u * ratio.sqrt())
            } else {
                1.0 / u
            };
            let residual = difference * weight;
            evaluation.residual[at] = residual;
            evaluation.weight[at] = weight;
            evaluation.objective += residual * residual;
        }
    }

    /// Compares, and gives the slope of the prediction (times weight) against each nuisance.
    pub(crate) fn linearise(
        &self,
        effects: &[Active<'_>],
        theta: &[f64],
        memory: &mut [Memory],
    ) -> (Evaluation, Vec<Column>) {
        let mut columns: Vec<Column> = self
            .free
            .iter()
            .map(|f| self.empty_column(f.kind))
            .collect();
        let offsets: [usize; SLOTS] = std::array::from_fn(|s| self.slots[s].start);
        let memory = Memories::Keep(memory);
        let evaluation = self.evaluate_with(effects, theta, memory, |index, prediction| {
            for ((free, column), &value) in self.free.iter().zip(&mut columns).zip(theta) {
                let unit = self.relative_unit(free, value);
                for (slot, values) in &mut column.parts {
                    let at = self.place[index][*slot];
                    if at != ABSENT {
                        values[at as usize - offsets[*slot]] =
                            unit * slope(free.kind, *slot, &self.rows[index], prediction);
                    }
                }
            }
        });
        for column in &mut columns {
            for (slot, values) in &mut column.parts {
                for (value, weight) in values
                    .iter_mut()
                    .zip(&evaluation.weight[self.slots[*slot].clone()])
                {
                    *value *= weight;
                }
            }
        }
        (evaluation, columns)
    }

    fn relative_unit(&self, free: &Free, theta: f64) -> f64 {
        match free.kind {
            Nuisance::Exciter(i) => {
                let u = self.exciter_u[i];
                stretched_slope(u * theta, u) * u / stretched(u * theta, u)
            }
            _ => free.unit,
        }
    }

    fn empty_column(&self, kind: Nuisance) -> Column {
        let slots: &[usize] = match kind {
            Nuisance::RatioGain | Nuisance::RunDut(_) => &[RATIO],
            Nuisance::DriveGain => &[DRIVE],
            Nuisance::RunReference(_) => &[RATIO, DRIVE],
            Nuisance::Exciter(_) => &[DRIVE, DRIVE + 1, CURRENT, CURRENT + 1],
            Nuisance::Noise(0) => &[NOISE],
            Nuisance::Noise(_) => &[NOISE + 1],
        };
        let parts = slots.iter().filter(|s| !self.slots[**s].is_empty());
        Column {
            parts: parts
                .map(|s| (*s, vec![0.0; self.slots[*s].len()]))
                .collect(),
        }
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
