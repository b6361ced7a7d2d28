//! Screening: how much each effect could explain of what a fit leaves.

use super::atom::{Atom, Promise, active};
use super::evaluation::Evaluation;
use super::fit::{Fit, Workspace};
use super::linear::Linearised;
use super::problem::Problem;
use super::scatter::{QuietStarts, Scene};
use super::slopes::Slopes;
use crate::effects::library;

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
                let atom = Atom::new(problem, entry, start, nominal, &base, work);
                atoms.list.extend(atom);
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
            let at = (&evaluation, &tangent);
            let beside =
                (bent && atom.moves_exciter()).then(|| atom.beside(problem, fit, at, work));
            let columns = beside.as_ref().unwrap_or(&atom.columns);
            let best = &mut best[atom.entry];
            let floor = best.as_ref().map_or(f64::NEG_INFINITY, |p| p.gain);
            if let Some(promise) = atom.promise(columns, problem, at, floor) {
                *best = Some(promise);
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
