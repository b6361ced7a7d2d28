//! Which set of effects: none, singles, pairs, with their probabilities.

use super::atom::{Promise, active};
use super::fit::{Effort, Fit, Workspace, refine, refine_with};
use super::problem::Problem;
use super::score::{Scored, score};
use super::screen::Atoms;
use super::slopes::Slopes;
use super::step::moved;
use crate::effects::library;
use std::rc::Rc;

/// Gain of -2 ln likelihood below which a promise is not worth a refinement.
const WORTH_REFINING: f64 = 5.0;
/// Singles from which pairs are grown.
const BASES: usize = 7;
/// Share of a promise by which the truth may exceed it.
const SLACK: f64 = 0.1;
/// Difference in score, on part of the rows, above which a set is not tried on all of them.
const SEEDED: f64 = 60.0;
/// Least cost of one more effect in the score.
pub(crate) const COST: f64 = 12.0;
/// Difference in score above which a set is not worth listing.
const COMPETING: f64 = 14.0;
/// Objective above the best set of a size from which a set is not refined further.
const OUT_OF_REACH: f64 = 60.0;
/// The same as a share of what the best set gained, as long as that leaves more than noise.
const REACH: f64 = 0.02;
/// Uncertainties by which noise does not move a nominal value.
const STRETCHED: f64 = 3.5;
/// Pairs refined fully.
const MOST_PAIRS: usize = 14;

/// All sets that were refined, best first.
pub(crate) struct Search {
    /// The fit without effects.
    pub(crate) nominal: Fit,
    /// Every refined set, best variant of each name, by score.
    pub(crate) sets: Vec<Scored>,
    /// All refined fits, those that a subset does better included.
    pub(crate) every: Vec<Fit>,
}

/// What a search may do.
#[derive(Debug, Clone)]
pub(crate) struct Limits {
    /// Entries of the library that may take part.
    pub(crate) allowed: Vec<bool>,
    /// Largest number of effects in a set.
    pub(crate) most_effects: usize,
}

impl Limits {
    /// Only the given names, all of them at a time.
    pub(crate) fn only(names: &[&str]) -> Self {
        let allowed = library()
            .iter()
            .map(|e| names.contains(&e.about().id))
            .collect();
        Self {
            allowed,
            most_effects: names.len(),
        }
    }

    /// The whole library without the given names.
    pub(crate) fn without(names: &[String], most_effects: usize) -> Self {
        let allowed = library()
            .iter()
            .map(|e| !names.iter().any(|n| n == e.about().id))
            .collect();
        Self {
            allowed,
            most_effects,
        }
    }
}

/// A set to which effects are added, with its slopes.
struct Base {
    fit: Fit,
    slopes: Option<Slopes>,
}

/// An effect to add to a base, with the objective that the screening predicts.
struct Plan {
    predicted: f64,
    base: Rc<Base>,
    promise: Promise,
}

impl Plan {
    fn new(base: &Rc<Base>, promise: Promise) -> Self {
        Self {
            predicted: base.fit.objective - promise.gain,
            base: Rc::clone(base),
            promise,
        }
    }

    /// Places in the library of the effects of the set, ascending.
    fn entries(&self) -> Vec<usize> {
        let mut entries = entries(&self.base.fit);
        entries.push(self.promise.entry);
        entries.sort_unstable();
        entries
    }
}

struct Searcher<'a> {
    problem: &'a Problem,
    atoms: Atoms,
    work: Workspace,
    found: Vec<Fit>,
}

/// Fits nothing, singles and sets.
pub(crate) fn search(problem: &Problem, limits: &Limits) -> Search {
    search_from(problem, limits, None)
}

/// The same, from the sets that a search on part of the rows has found.
///
/// Sets that were out of reach there are not tried again; what only all rows
/// show is found by screening from the best sets once more.
pub(crate) fn search_from(
    problem: &Problem,
    limits: &Limits,
    part: Option<(&Problem, &Search)>,
) -> Search {
    let mut work = Workspace::new(problem);
    let nominal = refine(
        problem,
        Vec::new(),
        vec![0.0; problem.free.len()],
        Effort::FULL,
        &mut work,
    );
    let atoms = Atoms::new(problem, &limits.allowed, &nominal, &mut work);
    let mut searcher = Searcher {
        problem,
        atoms,
        work,
        found: Vec::new(),
    };
    let seeded = part.is_some_and(|(of, search)| searcher.seed(of, search));
    if limits.most_effects > 0 {
        searcher.singles(&nominal, seeded);
    }
    for size in 2..=limits.most_effects {
        if !searcher.grow(size, nominal.objective) {
            break;
        }
    }
    let every = searcher.found;
    let sets = score(problem, &nominal, every.clone(), &limits.allowed);
    Search {
        nominal,
        sets,
        every,
    }
}

impl Searcher<'_> {
    /// Refines the sets that were within reach on part of the rows.
    fn seed(&mut self, of: &Problem, search: &Search) -> bool {
        let best = search.sets.first().map_or(0.0, |s| s.score);
        let near = |s: &&Scored| !s.fit.effects.is_empty() && s.score < best + SEEDED;
        for set in search.sets.iter().filter(near) {
            let fit = refine(
                self.problem,
                set.fit.effects.clone(),
                self.problem.translate(of, &set.fit.theta),
                Effort::FULL,
                &mut self.work,
            );
            if fit.objective < f64::MAX {
                self.found.push(fit);
            }
        }
        !self.found.is_empty()
    }

    fn singles(&mut self, nominal: &Fit, seeded: bool) {
        let (promises, slopes) = self.atoms.scan(self.problem, nominal, &mut self.work);
        let best = promises.first().map_or(0.0, |p| p.gain);
        let floor = WORTH_REFINING.max(0.02 * best);
        let base = Rc::new(Base {
            fit: nominal.clone(),
            slopes,
        });
        let mut plans: Vec<Plan> = chosen(&promises, 16, 4, floor)
            .into_iter()
            .filter(|p| {
                !self
                    .found
                    .iter()
                    .any(|f| f.effects.len() == 1 && f.has(p.entry))
            })
            .map(|p| Plan::new(&base, p))
            .collect();
        if seeded {
            self.drop_hopeless(&mut plans, 1);
        }
        for plan in plans {
            self.race(&plan, nominal.objective);
        }
    }

    /// A few steps first; all steps only for a set that is within reach of the best of its size.
    fn race(&mut self, plan: &Plan, nominal: f64) {
        let size = plan.base.fit.effects.len() + 1;
        let of_size = self.found.iter().filter(|f| f.effects.len() == size);
        let leader = of_size.min_by(|a, b| a.objective.total_cmp(&b.objective));
        let best = leader.map_or(nominal, |f| f.objective.min(nominal));
        let settled = leader.is_some_and(|f| self.is_noise(f));
        let objective = self.glance(plan);
        let reach = if settled {
            OUT_OF_REACH
        } else {
            OUT_OF_REACH.max(REACH * (nominal - best))
        };
        if objective < best + reach
            && let Some(fit) = self.found.pop_if(|f| f.effects.len() == size)
        {
            let start = fit.clone();
            let further = refine(
                self.problem,
                fit.effects,
                fit.theta,
                Effort::FULL,
                &mut self.work,
            );
            let better = further.objective < start.objective;
            self.found.push(if better { further } else { start });
        }
    }

    /// The base moved to where the screening expects it beside the new effect, if that is an improvement.
    fn shifted(&mut self, base: &Fit, promise: &Promise) -> Fit {
        let there = match &promise.shift {
            Some(shift) => moved(self.problem, base, shift),
            None => Fit {
                theta: self.problem.stated_noise(&base.theta),
                ..base.clone()
            },
        };
        let mut objective = |base: &Fit| {
            let mut effects = base.effects.clone();
            effects.push(active(promise.entry, promise.parameters.clone()));
            let memory = &mut self.work.memory;
            self.problem
                .evaluate(&effects, &base.theta, memory)
                .objective
        };
        if objective(&there) < objective(base) {
            there
        } else {
            base.clone()
        }
    }

    /// A few steps of a set; its objective.
    fn glance(&mut self, plan: &Plan) -> f64 {
        let promise = &plan.promise;
        let base = self.shifted(&plan.base.fit, promise);
        let mut effects = base.effects.clone();
        effects.push(active(promise.entry, promise.parameters.clone()));
        let effect = library()[promise.entry];
        // A second bend changes the slopes of the first.
        let slopes = plan.base.slopes.as_ref().filter(|_| !effect.bends());
        let mut fit = refine_with(
            self.problem,
            effects,
            base.theta.clone(),
            slopes,
            Effort::GLANCE,
            &mut self.work,
        );
        if effect.bends() && base.effects.is_empty() {
            // The screening of a bent exciter is linear in its size: try the other sizes too.
            for start in effect.starts(&self.problem.facts).into_iter().skip(1) {
                let mut other = base.effects.clone();
                other.push(active(promise.entry, start.members[0].clone()));
                let evaluation = self
                    .problem
                    .evaluate(&other, &fit.theta, &mut self.work.memory);
                if evaluation.objective < fit.objective {
                    let again = refine(
                        self.problem,
                        other,
                        fit.theta.clone(),
                        Effort::GLANCE,
                        &mut self.work,
                    );
                    if again.objective < fit.objective {
                        fit = again;
                    }
                }
            }
        }
        let objective = fit.objective;
        if objective.is_finite() && objective < f64::MAX {
            self.found.push(fit);
        }
        objective
    }

    /// Adds an effect to the best sets of the size below; false if nothing promises anything.
    fn grow(&mut self, size: usize, nominal: f64) -> bool {
        let mut tried: Vec<Vec<usize>> = self
            .found
            .iter()
            .filter(|f| f.effects.len() == size)
            .map(entries)
            .collect();
        let mut any = !tried.is_empty();
        for round in 0..3 {
            let bases = if round == 0 {
                self.bases(size - 1, nominal)
            } else {
                self.exchange_bases(size)
            };
            let mut plans: Vec<Plan> = Vec::new();
            for fit in bases {
                let (promises, slopes) = self.atoms.scan(self.problem, &fit, &mut self.work);
                let base = Rc::new(Base { fit, slopes });
                let plan = chosen(&promises, 5, 2, 9.0).into_iter();
                plans.extend(
                    plan.map(|promise| Plan::new(&base, promise))
                        .filter(|plan| {
                            !same_name(&base.fit, plan.promise.entry)
                                && !tried.contains(&plan.entries())
                        }),
                );
            }
            self.drop_hopeless(&mut plans, size);
            if plans.is_empty() {
                break;
            }
            any = true;
            plans.sort_by(|a, b| a.predicted.total_cmp(&b.predicted));
            self.refine_plans(plans, &mut tried, nominal);
        }
        any
    }

    fn refine_plans(&mut self, plans: Vec<Plan>, tried: &mut Vec<Vec<usize>>, nominal: f64) {
        let before = tried.len();
        for plan in plans {
            let entries = plan.entries();
            if tried.contains(&entries) {
                continue;
            }
            if tried.len() - before >= MOST_PAIRS {
                break;
            }
            tried.push(entries);
            self.race(&plan, nominal);
        }
    }

    /// Whether a fit leaves what noise leaves: one per datum within three standard
    /// deviations, and no nominal value stretched.
    fn is_noise(&self, fit: &Fit) -> bool {
        let count = self.problem.len() as f64;
        let mut nominal = self.problem.free.iter().zip(&fit.theta);
        fit.objective < count + 3.0 * (2.0 * count).sqrt()
            && nominal.all(|(free, theta)| !free.bounded || theta.abs() < STRETCHED)
    }

    /// Drops plans that cannot compete even if they gain more than the screening promised.
    fn drop_hopeless(&self, plans: &mut Vec<Plan>, size: usize) {
        let best = self
            .found
            .iter()
            .map(|f| f.objective + COST * f.effects.len() as f64)
            .fold(f64::INFINITY, f64::min);
        let found = &self.found;
        plans.retain(|plan| {
            let entries = plan.entries();
            // Worse than a part of it that leaves noise only: the part is the better base for the same set.
            let worse = found.iter().any(|f| {
                f.effects.len() < size
                    && f.objective < plan.predicted
                    && self.is_noise(f)
                    && f.effects.iter().all(|e| entries.contains(&e.entry))
            });
            !worse
                && plan.predicted - SLACK * plan.promise.gain + COST * (size as f64)
                    < best + COMPETING
        });
    }

    /// Best sets of a size, and the best of each kind of observable.
    fn bases(&self, size: usize, nominal: f64) -> Vec<Fit> {
        let mut list: Vec<Fit> = self
            .found
            .iter()
            .filter(|f| f.effects.len() == size)
            .cloned()
            .collect();
        list.sort_by(|a, b| a.objective.total_cmp(&b.objective));
        list.retain(|f| f.objective < nominal - WORTH_REFINING);
        let mut kept: Vec<Fit> = Vec::new();
        let mut of_kind = [0; 3];
        for fit in list {
            let kind = kind(&fit);
            if kept.len() < BASES || of_kind[kind] < 2 {
                of_kind[kind] += 1;
                kept.push(fit);
            }
        }
        kept
    }

    /// The best set with each of its effects left out in turn, the others kept as they are.
    fn exchange_bases(&mut self, size: usize) -> Vec<Fit> {
        let best = self
            .found
            .iter()
            .filter(|f| f.effects.len() == size)
            .min_by(|a, b| a.objective.total_cmp(&b.objective));
        let Some(best) = best.cloned() else {
            return Vec::new();
        };
        let mut bases = Vec::new();
        for leave in 0..best.effects.len() {
            let mut base = best.clone();
            base.effects.remove(leave);
            // The smaller set restarts from where the larger one arrived: a gain
            // that is only better convergence must not look like a second effect.
            let base = refine(
                self.problem,
                base.effects,
                base.theta,
                Effort::FULL,
                &mut self.work,
            );
            if base.objective < f64::MAX {
                self.found.push(base.clone());
            }
            bases.push(base);
        }
        bases
    }
}

fn kind(fit: &Fit) -> usize {
    match fit.effects.first() {
        Some(e) if e.effect.scatters() => 2,
        Some(e) if e.effect.bends() || e.effect.about().id.starts_with("adc") => 1,
        _ => 0,
    }
}

/// Places in the library of the effects of a set, ascending.
fn entries(fit: &Fit) -> Vec<usize> {
    let mut entries: Vec<usize> = fit.effects.iter().map(|e| e.entry).collect();
    entries.sort_unstable();
    entries
}

fn same_name(base: &Fit, entry: usize) -> bool {
    base.effects
        .iter()
        .any(|e| e.effect.about().id == library()[entry].about().id)
}

/// The best promises overall and the best of each group.
fn chosen(promises: &[Promise], overall: usize, per_group: usize, floor: f64) -> Vec<Promise> {
    let mut counts = [0; 3];
    let mut list = Vec::new();
    for (rank, promise) in promises.iter().enumerate() {
        let count = &mut counts[promise.group];
        let in_group = *count < per_group && promise.gain > WORTH_REFINING;
        if (promise.gain > floor && rank < overall) || in_group {
            *count += 1;
            list.push(promise.clone());
        }
    }
    list
}
