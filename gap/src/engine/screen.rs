//! Screening: how much each effect could explain of what a fit leaves.

use super::fit::{Fit, Linearised, Slopes, Workspace};
use super::normal::{Tangent, difference, gram};
use super::problem::{Column, Evaluation, Problem, wrapped};
use super::scatter::{QuietStarts, Scene};
use crate::effects::{Active, Effect, Parameter, Scale, Stage, Start, library};
use crate::model::chain::Transfer;
use crate::model::row::{DC, DRIVE, RATIO, REF_HARMONICS};
use nalgebra::{Cholesky, DMatrix, DVector};

/// A start with the change of the weighted prediction of each member.
pub(crate) struct Atom {
    pub(crate) entry: usize,
    start: Start,
    columns: Vec<Column>,
}

/// What an effect promises.
#[derive(Clone)]
pub(crate) struct Promise {
    pub(crate) entry: usize,
    pub(crate) gain: f64,
    pub(crate) parameters: Vec<f64>,
    /// Step of the nuisances and of the effects already there that goes with it.
    pub(crate) shift: Option<DVector<f64>>,
    /// Group of observables in which the gain lies: response, harmonics and d.c., noise.
    pub(crate) group: usize,
}

/// All starts of all effects that apply, with their changes at the nominal fit.
pub(crate) struct Atoms {
    list: Vec<Atom>,
    /// Entries that only scatter, with their starts.
    scattering: Vec<(usize, Vec<Vec<f64>>)>,
    quiet: QuietStarts,
}

impl Atoms {
    /// Prepares the starts of the entries that are allowed.
    pub(crate) fn new(
        problem: &Problem,
        allowed: &[bool],
        nominal: &Fit,
        work: &mut Workspace,
    ) -> Self {
        let base = problem.evaluate(&[], &nominal.theta, &mut work.memory);
        let mut atoms = Self {
            list: Vec::new(),
            scattering: Vec::new(),
            quiet: QuietStarts::default(),
        };
        for (entry, effect) in library()
            .iter()
            .enumerate()
            .filter(|(i, e)| allowed[*i] && e.applies(&problem.facts))
        {
            let mut starts = effect.starts(&problem.facts);
            if effect.scatters() {
                let list = starts.into_iter().map(|s| s.members[0].clone());
                atoms.scattering.push((entry, list.collect()));
                continue;
            }
            if effect.bends() {
                // One balance per row and start: the screening takes the smallest start only.
                if effect.about().id != "amplifier_clipping" {
                    starts.truncate(1);
                }
                if effect.about().id == "suspension_cubic"
                    || effect.about().id == "suspension_asymmetry"
                {
                    starts.iter_mut().for_each(|s| s.signed = true);
                }
            }
            for start in starts {
                let columns: Vec<Column> = start
                    .members
                    .iter()
                    .map(|m| change(problem, entry, m, nominal, &base, work))
                    .collect();
                if columns.iter().any(|c| c.norm2() > 0.0) {
                    atoms.list.push(Atom {
                        entry,
                        start,
                        columns,
                    });
                }
            }
        }
        atoms
    }

    /// The best promise of every entry that the fit does not hold yet, best first,
    /// and the slopes at the fit.
    pub(crate) fn scan(
        &mut self,
        problem: &Problem,
        fit: &Fit,
        work: &mut Workspace,
    ) -> (Vec<Promise>, Option<Slopes>) {
        let Some((evaluation, tangent)) = Linearised::new(problem, fit, work).tangent() else {
            return (Vec::new(), None);
        };
        let mut best: Vec<Option<Promise>> = vec![None; library().len()];
        let bent = fit.effects.iter().any(|e| e.effect.bends());
        for atom in &self.list {
            if fit.has(atom.entry) {
                continue;
            }
            let beside = (bent && atom.moves_exciter())
                .then(|| atom.beside(problem, fit, &evaluation, work));
            let columns = beside.as_ref().unwrap_or(&atom.columns);
            if let Some(promise) = atom.promise(columns, problem, &evaluation, &tangent) {
                keep(&mut best, promise);
            }
        }
        self.scan_scatter(problem, fit, &evaluation, &mut best);
        let mut list: Vec<Promise> = best.into_iter().flatten().collect();
        list.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        (list, Some(Slopes::new(tangent.columns, evaluation.weight)))
    }

    /// The best start of each effect that only scatters, then other sizes and details around it.
    fn scan_scatter(
        &mut self,
        problem: &Problem,
        fit: &Fit,
        evaluation: &Evaluation,
        best: &mut [Option<Promise>],
    ) {
        let scene = Scene::new(problem, &fit.effects, &fit.theta, evaluation);
        for (entry, starts) in self.scattering.iter().filter(|(e, _)| !fit.has(*e)) {
            for round in [None, Some(0), Some(1), Some(2)] {
                let list = match (round, &best[*entry]) {
                    (None, _) => starts.clone(),
                    (Some(round), Some(found)) => {
                        library()[*entry].around(&found.parameters, round, &problem.facts)
                    }
                    (Some(_), None) => break,
                };
                let floor = best[*entry].as_ref().map_or(f64::NEG_INFINITY, |p| p.gain);
                let starts = list.into_iter().map(|p| active(*entry, p));
                if let Some((start, gain)) = scene.best(starts, floor, &mut self.quiet) {
                    best[*entry] = Some(Promise {
                        entry: *entry,
                        gain,
                        parameters: start.parameters,
                        shift: None,
                        group: 2,
                    });
                }
            }
        }
    }
}

fn keep(best: &mut [Option<Promise>], promise: Promise) {
    let slot = &mut best[promise.entry];
    if promise.gain.is_finite() && slot.as_ref().is_none_or(|p| p.gain < promise.gain) {
        *slot = Some(promise);
    }
}

/// An entry of the library with values.
pub(crate) fn active(entry: usize, parameters: Vec<f64>) -> Active<'static> {
    let effect = library()[entry];
    let unit = |(value, about): (&f64, &Parameter)| match about.scale {
        Scale::Log => 1.0,
        Scale::Linear if *value != 0.0 => value.abs(),
        Scale::Linear => 1e-3 * (about.upper - about.lower).min(1.0),
    };
    let unit = parameters.iter().zip(effect.about().parameters).map(unit);
    Active {
        entry,
        effect,
        unit: unit.collect(),
        parameters,
    }
}

/// Change of the weighted prediction when one effect is added to the nominal fit.
fn change(
    problem: &Problem,
    entry: usize,
    parameters: &[f64],
    nominal: &Fit,
    base: &Evaluation,
    work: &mut Workspace,
) -> Column {
    let effect = library()[entry];
    if effect.is_linear() {
        return linear_change(problem, effect, parameters);
    }
    let effects = [active(entry, parameters.to_vec())];
    let there = problem.evaluate(&effects, &nominal.theta, &mut work.memory);
    let unweighted: Vec<f64> = there
        .residual
        .iter()
        .zip(&there.weight)
        .zip(&base.weight)
        .map(|((r, wt), wb)| r / wt * wb)
        .collect();
    Column::difference(problem, &unweighted, &base.residual, 1.0)
}

/// The same for an effect that is a linear response: no exciter has to be computed.
fn linear_change(problem: &Problem, effect: &dyn Effect, parameters: &[f64]) -> Column {
    let transfers: Vec<Transfer> = problem
        .rows
        .iter()
        .map(|row| {
            let mut transfer = Transfer::default();
            effect.transfer(parameters, row, row.frequency_hz, &mut transfer);
            transfer
        })
        .collect();
    let mut column = Column::default();
    for slot in [RATIO, RATIO + 1, DRIVE, DRIVE + 1] {
        let range = problem.slots[slot].clone();
        let values: Vec<f64> = range
            .map(|at| {
                let t = &transfers[problem.row_of[at]];
                let quotient = if slot < DRIVE {
                    t.dut / t.reference
                } else {
                    t.table * t.reference * t.drive
                };
                let value = if slot % 2 == 0 {
                    0.5 * quotient.norm_sqr().ln()
                } else {
                    wrapped(quotient.arg())
                };
                value / problem.uncertainty(at)
            })
            .collect();
        if values.iter().any(|v| v.abs() > 1e-9) {
            column.parts.push((slot, values));
        }
    }
    column
}

impl Atom {
    /// Whether the effect changes the linear exciter, and with it the harmonics of a bent one.
    fn moves_exciter(&self) -> bool {
        let effect = library()[self.entry];
        effect.about().stage == Stage::Exciter && !effect.is_linear() && !effect.bends()
    }

    /// The changes beside the effects that a fit holds.
    fn beside(
        &self,
        problem: &Problem,
        fit: &Fit,
        here: &Evaluation,
        work: &Workspace,
    ) -> Vec<Column> {
        let members = self.start.members.iter();
        let columns = members.map(|parameters| {
            let mut effects = fit.effects.clone();
            effects.push(active(self.entry, parameters.clone()));
            let there = problem.evaluate_aside(&effects, &fit.theta, &work.memory);
            let left = difference(problem, here, &there);
            let none = vec![0.0; left.len()];
            Column::difference(problem, &none, &left, 1.0)
        });
        columns.collect()
    }

    fn promise(
        &self,
        columns: &[Column],
        problem: &Problem,
        evaluation: &Evaluation,
        tangent: &Tangent,
    ) -> Option<Promise> {
        let count = columns.len();
        let loads: Vec<DVector<f64>> = columns.iter().map(|c| tangent.load(c)).collect();
        let mut matrix: DMatrix<f64> = gram(columns, &vec![0.0; count]);
        let mut vector = DVector::zeros(count);
        for i in 0..count {
            // At the optimum the nuisances' own gradients are balanced by their priors.
            vector[i] = columns[i].dot_data(problem, &evaluation.residual);
            for j in 0..count {
                matrix[(i, j)] -= loads[i].dot(&loads[j]);
            }
            // A direction that the nuisances can take over completely promises nothing.
            // (One that they take over against their priors does: the priors are the evidence.)
            if matrix[(i, i)] < 1e-11 * columns[i].norm2() {
                return None;
            }
        }
        let mut amplitude = Cholesky::new(matrix.clone())?.solve(&vector);
        let effect = library()[self.entry];
        if count == 1 {
            let free = self.start.amplitude.is_some();
            let (low, high) = if self.start.signed {
                (f64::NEG_INFINITY, f64::INFINITY)
            } else if free {
                (0.0, 1e4)
            } else {
                (0.3, 3.0)
            };
            amplitude[0] = amplitude[0].clamp(low, high);
        }
        let gain =
            2.0 * amplitude.dot(&vector) - (amplitude.transpose() * &matrix * &amplitude)[(0, 0)];
        let parameters = effect.combine(&self.start, amplitude.as_slice());
        let mut taken = DVector::zeros(tangent.columns.len());
        for (load, size) in loads.iter().zip(amplitude.iter()) {
            taken.axpy(-size, load, 1.0);
        }
        Some(Promise {
            entry: self.entry,
            gain,
            parameters,
            shift: Some(tangent.unload(taken)),
            group: self.group(),
        })
    }

    fn group(&self) -> usize {
        let weight = |from: usize, to: usize| -> f64 {
            let parts = self
                .columns
                .iter()
                .flat_map(|c| &c.parts)
                .filter(|p| (from..to).contains(&p.0));
            parts
                .map(|(_, v)| v.iter().map(|x| x * x).sum::<f64>())
                .sum()
        };
        let harmonics = weight(REF_HARMONICS, DC + 2);
        if harmonics > weight(0, REF_HARMONICS) {
            1
        } else {
            0
        }
    }
}
