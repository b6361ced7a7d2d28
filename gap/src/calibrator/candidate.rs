//! A candidate: one start of one effect, its change of the prediction and its predicted gain.

use super::closed_form::{by_values, response_added};
use super::evaluation::{Evaluation, difference};
use super::fit::{Fit, Workspace};
use super::problem::{Column, Problem, Tangent};
use crate::effects::library;
use crate::estimation::tangent::RIDGE;
use crate::model::effect::{Active, Shows, Start};
use crate::observable::Group;
use calib_effects::{Parameter, Scale, Stage};
use nalgebra::{Cholesky, DVector};

/// How much a fit would gain by an effect, as the slopes foresee it.
#[derive(Clone)]
pub(crate) struct PredictedGain {
    pub(crate) entry: usize,
    pub(crate) gain: f64,
    pub(crate) parameters: Vec<f64>,
    /// Step of the nuisances and of the effects already there that goes with it.
    pub(crate) shift: Option<DVector<f64>>,
    /// Where the gain lies.
    pub(crate) shows: Shows,
}

/// A start with the change of the weighted prediction of each member.
pub(crate) struct Candidate {
    pub(crate) entry: usize,
    start: Start,
    pub(super) columns: Vec<Column>,
    shows: Shows,
}

/// An entry of the library with values.
pub(crate) fn active(entry: usize, parameters: Vec<f64>) -> Active<'static> {
    let effect = library()[entry];
    let unit = |(value, about): (&f64, &Parameter)| match about.scale {
        Scale::Log => 1.0,
        Scale::Linear if *value != 0.0 => value.abs(),
        Scale::Linear => 1e-3 * (about.upper - about.lower).min(1.0),
    };
    let unit = parameters.iter().zip(effect.parameters()).map(unit);
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
        let added = active(entry, parameters.to_vec());
        return response_added(problem, &added, &base.weight);
    }
    let effects = [active(entry, parameters.to_vec())];
    let there = problem.evaluate(&effects, &nominal.theta, &mut work.memory);
    let unweighted = there.residual_as_weighted_by(base);
    Column::difference(problem, &unweighted, &base.residual, 1.0)
}

impl Candidate {
    /// A start with its changes at the nominal fit; `None` where nothing changes.
    pub(super) fn new(
        problem: &Problem,
        entry: usize,
        start: Start,
        nominal: &Fit,
        base: &Evaluation,
        work: &mut Workspace,
    ) -> Option<Self> {
        let members = start.members.iter();
        let columns = members.map(|m| change(problem, entry, m, nominal, base, work));
        let columns: Vec<Column> = columns.collect();
        let any = columns.iter().any(|c| c.norm2() > 0.0);
        any.then(|| Self {
            entry,
            start,
            shows: shows(&columns),
            columns,
        })
    }

    /// Whether the effect changes the linear exciter, and with it the harmonics of a bent one.
    pub(super) fn moves_exciter(&self) -> bool {
        let effect = library()[self.entry];
        effect.entry().stage == Stage::Exciter && !effect.is_linear() && !effect.makes_nonlinear()
    }

    /// The changes beside the effects that a fit holds, from the slopes there; `None` where they do not tell.
    pub(super) fn by_slopes(
        &self,
        problem: &Problem,
        fit: &Fit,
        tangent: &Tangent,
    ) -> Option<Vec<Column>> {
        let members = self.start.members.iter();
        let columns = members.map(|parameters| {
            let added = active(self.entry, parameters.clone());
            by_values(problem, fit, &added, &tangent.columns)
        });
        columns.collect()
    }

    /// The candidates from a simulation of each.
    pub(super) fn simulated(
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
            let there = problem.evaluate_beside(&effects, &fit.theta, &work.memory);
            let left = difference(problem, here, &there);
            let none = vec![0.0; left.len()];
            Column::difference(problem, &none, &left, 1.0)
        });
        columns.collect()
    }

    /// The gain of the effect with the given changes, if it is more than `floor`.
    pub(super) fn predicted_gain(
        &self,
        columns: &[Column],
        problem: &Problem,
        (evaluation, tangent): (&Evaluation, &Tangent),
        owed: &DVector<f64>,
        floor: f64,
    ) -> Option<PredictedGain> {
        let beside = tangent.beside(columns, RIDGE);
        let vector = beside.products(problem, columns, &evaluation.residual, owed)?;
        let matrix = &beside.matrix;
        let mut amplitude = Cholesky::new(matrix.clone())?.solve(&vector);
        if let [size] = amplitude.as_mut_slice() {
            let (low, high) = self.sizes();
            *size = size.clamp(low, high);
        }
        let gain =
            2.0 * amplitude.dot(&vector) - (amplitude.transpose() * matrix * &amplitude)[(0, 0)];
        if !gain.is_finite() || gain <= floor {
            return None;
        }
        let effect = library()[self.entry];
        let parameters = effect.combine(&self.start, amplitude.as_slice());
        Some(PredictedGain {
            entry: self.entry,
            gain,
            parameters,
            shift: Some(tangent.refitted(&beside, &amplitude)),
            shows: self.shows,
        })
    }

    /// Smallest and largest factor on the start.
    fn sizes(&self) -> (f64, f64) {
        if self.start.signed {
            (f64::NEG_INFINITY, f64::INFINITY)
        } else if self.start.amplitude.is_some() {
            (0.0, 1e4)
        } else {
            (0.3, 3.0)
        }
    }
}

/// Where most of a change lies: in the response, or in harmonics and d.c.
fn shows(columns: &[Column]) -> Shows {
    let weight = |inside: fn(Group) -> bool| -> f64 {
        let parts = columns.iter().flat_map(|c| &c.parts);
        let inside = parts.filter(|p| inside(p.0.group()));
        inside
            .map(|(_, v)| v.iter().map(|x| x * x).sum::<f64>())
            .sum()
    };
    let distorts = |group: Group| !group.is_response() && group != Group::Noise;
    match weight(distorts) > weight(Group::is_response) {
        true => Shows::Harmonics,
        false => Shows::Response,
    }
}
