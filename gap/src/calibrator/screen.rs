//! Screening: how much each effect could explain of what a fit leaves.

use super::candidate::{Candidate, PredictedGain, active};
use super::evaluation::Evaluation;
use super::fit::{Fit, Workspace};
use super::higher::higher_harmonics;
use super::linear::{Linearised, Slopes};
use super::nuisance::Nuisance;
use super::problem::{Column, Problem, Tangent};
use super::scatter::{QuietStarts, Scene};
use super::settled::gradient;
use crate::effects::library;
use crate::model::effect::Shows;
use crate::thresholds;

/// All starts of all effects that apply, with their changes at the nominal fit.
pub(crate) struct Candidates {
    list: Vec<Candidate>,
    /// Entries that only scatter, with their starts.
    scattering: Vec<(usize, Vec<Vec<f64>>)>,
    quiet: QuietStarts,
}

impl Candidates {
    /// Prepares the starts of the entries that are allowed.
    pub(crate) fn new(
        problem: &Problem,
        allowed: &[bool],
        nominal: &Fit,
        work: &mut Workspace,
    ) -> Self {
        let base = problem.evaluate(&[], &nominal.theta, &mut work.memory);
        let mut candidates = Self {
            list: Vec::new(),
            scattering: Vec::new(),
            quiet: QuietStarts::default(),
        };
        for (entry, effect) in library()
            .iter()
            .enumerate()
            .filter(|(i, e)| allowed[*i] && e.applies(&problem.facts))
        {
            let starts = effect.screened(&problem.facts);
            if effect.scatters() {
                let list = starts.into_iter().map(|s| s.members[0].clone());
                candidates.scattering.push((entry, list.collect()));
                continue;
            }
            for start in starts {
                let candidate = Candidate::new(problem, entry, start, nominal, &base, work);
                candidates.list.extend(candidate);
            }
        }
        candidates
    }

    /// The largest predicted gain of every entry that the fit does not hold yet, best first,
    /// and the slopes at the fit.
    pub(crate) fn scan(
        &mut self,
        problem: &Problem,
        fit: &Fit,
        work: &mut Workspace,
    ) -> (Vec<PredictedGain>, Option<Slopes>) {
        let Some((evaluation, tangent)) = Linearised::new(problem, fit, work).tangent() else {
            return (Vec::new(), None);
        };
        let mut best: Vec<Option<PredictedGain>> = vec![None; library().len()];
        self.scan_steady(problem, fit, (&evaluation, &tangent), &mut best, work);
        let higher_v2 = higher_harmonics(problem, fit, work);
        for higher_v2 in std::iter::once(None).chain(higher_v2.as_deref().map(Some)) {
            let scene = Scene::new(problem, &fit.effects, &fit.theta, &evaluation, higher_v2);
            self.scan_scatter(problem, fit, &scene, &mut best);
        }
        let mut list: Vec<PredictedGain> = best.into_iter().flatten().collect();
        list.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        (list, Some(Slopes::new(tangent.columns, evaluation.weight)))
    }

    /// The best start of each effect that moves what is measured.
    fn scan_steady(
        &self,
        problem: &Problem,
        fit: &Fit,
        (evaluation, tangent): (&Evaluation, &Tangent),
        best: &mut [Option<PredictedGain>],
        work: &mut Workspace,
    ) {
        let moved = is_moved(problem, fit);
        let slope = gradient(problem, fit, tangent, &evaluation.residual);
        let owed = tangent.halfway(slope);
        let gain = |candidate: &Candidate, columns: &[Column], floor: f64| {
            candidate.predicted_gain(columns, problem, (evaluation, tangent), &owed, floor)
        };
        let mut compete = |candidate: &Candidate, columns: &[Column]| {
            let best = &mut best[candidate.entry];
            let floor = best.as_ref().map_or(f64::NEG_INFINITY, |p| p.gain);
            if let Some(predicted_gain) = gain(candidate, columns, floor) {
                *best = Some(predicted_gain);
            }
        };
        let mut unknown = Vec::new();
        for candidate in self.list.iter().filter(|c| !fit.has(c.entry)) {
            if !moved || !candidate.moves_exciter() {
                compete(candidate, &candidate.columns);
            } else if let Some(columns) = candidate.by_slopes(problem, fit, tangent) {
                compete(candidate, &columns);
            } else {
                unknown.push(candidate);
            }
        }
        for candidate in nearest(unknown, |c| gain(c, &c.columns, f64::NEG_INFINITY)) {
            let columns = candidate.simulated(problem, fit, evaluation, work);
            compete(candidate, &columns);
        }
    }

    /// The best start of each effect that only scatters, then other sizes and details around it.
    fn scan_scatter(
        &mut self,
        problem: &Problem,
        fit: &Fit,
        scene: &Scene<'_>,
        best: &mut [Option<PredictedGain>],
    ) {
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
                    best[*entry] = Some(PredictedGain {
                        entry: *entry,
                        gain,
                        parameters: start.parameters,
                        shift: None,
                        shows: Shows::Noise,
                    });
                }
            }
        }
    }
}

/// Whether the exciter is far from where the changes of the starts were computed: bent, or pulled from its nominal
/// values.
fn is_moved(problem: &Problem, fit: &Fit) -> bool {
    let mut nuisances = problem.free.iter().zip(&fit.theta);
    fit.effects.iter().any(|e| e.effect.makes_nonlinear())
        || nuisances.any(|(free, value)| {
            matches!(free.kind, Nuisance::Exciter(_)) && value.abs() > thresholds::EXCITER_PULLED
        })
}

/// Starts of each effect with the largest predicted gains at the nominal fit.
fn nearest(
    starts: Vec<&Candidate>,
    gain: impl Fn(&Candidate) -> Option<PredictedGain>,
) -> impl Iterator<Item = &Candidate> {
    let predicted = |start| gain(start).map_or(f64::NEG_INFINITY, |p| p.gain);
    let mut starts: Vec<(f64, &Candidate)> =
        starts.into_iter().map(|s| (predicted(s), s)).collect();
    starts.sort_by(|(a, one), (b, other)| one.entry.cmp(&other.entry).then(b.total_cmp(a)));
    let of_effects = starts.chunk_by(|(_, one), (_, other)| one.entry == other.entry);
    let nearest =
        of_effects.flat_map(|starts| &starts[..starts.len().min(thresholds::NEAREST_STARTS)]);
    let nearest: Vec<&Candidate> = nearest.map(|(_, start)| *start).collect();
    nearest.into_iter()
}

#[cfg(test)]
mod tests {
    use super::super::example::measured;
    use super::super::refine::{FULL, refine};
    use super::*;

    /// A damping 10 of its standard uncertainties off costs 100 as a pull and nothing as an
    /// effect, which leaves no other trace: that is its predicted gain beside the armature's mode,
    /// within what slopes foresee of so large a change.
    #[test]
    fn the_predicted_gain_of_an_effect_that_only_pulls_a_nominal_value_is_its_pull() {
        let mode = ("armature_mode", vec![0.3, 5000.0, 0.03]);
        let (rig, points) = measured(&[mode.clone(), ("mechanical_damping", vec![6.0])]);
        let problem = Problem::new(&rig, &points);
        let mut work = Workspace::new(&problem);
        let mut fit = |effects: Vec<_>| {
            let start = vec![0.0; problem.free.len()];
            refine(&problem, effects, start, FULL, &mut work)
        };
        let entry = |name: &str| {
            let mut entries = library().iter();
            entries.position(|e| e.entry().id == name).expect("a name")
        };
        let (nominal, beside) = (fit(vec![]), fit(vec![active(entry(mode.0), mode.1)]));
        let allowed = vec![true; library().len()];
        let mut candidates = Candidates::new(&problem, &allowed, &nominal, &mut work);
        let (predicted, _) = candidates.scan(&problem, &beside, &mut work);
        let damping = entry("mechanical_damping");
        let predicted_gain = predicted.iter().find(|p| p.entry == damping);
        let gain = predicted_gain.map_or(0.0, |p| p.gain);
        assert!((80.0..125.0).contains(&gain), "{gain} {:?}", beside.theta);
    }

    /// However much the starts of one effect promise, two of every other are simulated too, the best of its own.
    #[test]
    fn the_two_nearest_starts_of_every_effect_are_simulated() {
        let (rig, points) = measured(&[]);
        let problem = Problem::new(&rig, &points);
        let mut work = Workspace::new(&problem);
        let theta = vec![0.0; problem.free.len()];
        let nominal = refine(&problem, vec![], theta, FULL, &mut work);
        let allowed = vec![true; library().len()];
        let all = Candidates::new(&problem, &allowed, &nominal, &mut work).list;
        // The later an effect comes, the more it promises; of its starts the first most, and the second nothing.
        let at = |start: &Candidate| all.iter().position(|of| std::ptr::eq(of, start));
        let first = |entry: usize| all.iter().position(|of| of.entry == entry);
        let rank = |start: &Candidate| at(start).unwrap() - first(start.entry).unwrap();
        let gain = |start: &Candidate| {
            (rank(start) != 1).then(|| PredictedGain {
                entry: start.entry,
                gain: 100.0 * start.entry as f64 - rank(start) as f64,
                parameters: Vec::new(),
                shift: None,
                shows: Shows::Response,
            })
        };
        let chosen: Vec<_> = nearest(all.iter().collect(), gain).collect();
        let starts = |entry: usize| all.iter().filter(move |of| of.entry == entry).count();
        assert!((0..library().len()).any(|entry| starts(entry) > thresholds::NEAREST_STARTS));
        for entry in 0..library().len() {
            let ranks = chosen
                .iter()
                .filter(|of| of.entry == entry)
                .map(|of| rank(of));
            let expected: &[usize] = match starts(entry) {
                0 => &[],
                1 => &[0],
                2 => &[0, 1],
                _ => &[0, 2],
            };
            assert_eq!(ranks.collect::<Vec<_>>(), expected, "entry {entry}");
        }
    }
}
