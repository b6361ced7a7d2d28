//! Which set of effects: none, singles, pairs, with their probabilities.

use super::fit::{Fit, Workspace};
use super::found::{Base, Extension, Found, chosen, entries};
use super::model_selection::{Scored, normalise, score};
use super::problem::Problem;
use super::race::race;
use super::refine::{FULL, refine};
use super::screen::Candidates;
use crate::dataset::Dataset;
use crate::effects::library;
use crate::error::GapError;
use crate::options::Options;
use crate::thresholds;
use std::path::Path;
use std::rc::Rc;

/// All sets that were refined, best first.
pub(crate) struct Search {
    /// The fit without effects.
    pub(crate) nominal: Fit,
    /// Every refined set, best variant of each name, by score.
    pub(crate) sets: Vec<Scored>,
    /// All refined fits, those that a subset does better included.
    pub(crate) every: Vec<Fit>,
}

impl Search {
    /// Strikes the sets worth listing that `stands` does not hold of, and those that come up in their place.
    pub(crate) fn strike(&mut self, mut stands: impl FnMut(&Fit) -> bool) {
        let (mut at, mut struck) = (0, 0);
        while let Some(set) = self.sets.get(at)
            && set.probability >= thresholds::LISTED_PROBABILITY
            && struck < thresholds::MOST_STRUCK
        {
            if set.fit.effects.is_empty() || stands(&set.fit) {
                at += 1;
            } else {
                self.sets.remove(at);
                struck += 1;
                normalise(&mut self.sets);
            }
        }
    }

    /// The leading set; the nominal simulation where there is none.
    pub(crate) fn best(&self) -> &Fit {
        self.sets.first().map_or(&self.nominal, |set| &set.fit)
    }
}

/// How sets grow by one effect.
struct Growth {
    /// Effects of the larger sets.
    size: usize,
    /// Whether that is beyond the usual size.
    beyond: bool,
    /// Most of them that are refined a round.
    most: usize,
    /// Most sets of the size below that are grown.
    bases: usize,
    /// Predicted gain from which an effect is tried.
    floor: f64,
    /// Predicted gain from which the best effect of its kind of observable is tried.
    least: f64,
    /// That gain as a share of what the set leaves beyond noise.
    share: f64,
    /// Predicted gain over that of a part of the set that leaves noise only.
    worth: f64,
}

impl Growth {
    /// Beyond the usual size a set is grown only where it shows lack of fit.
    fn new(size: usize, beyond: bool) -> Self {
        let shows = thresholds::SHOWS_LACK_OF_FIT;
        let usual = Self {
            size,
            beyond,
            most: thresholds::MOST_PAIRS,
            bases: usize::MAX,
            floor: thresholds::WORTH_ADDING,
            least: thresholds::WORTH_REFINING,
            share: 0.0,
            worth: 0.0,
        };
        if !beyond {
            return usual;
        }
        Self {
            most: thresholds::MOST_LARGER,
            bases: thresholds::LEADERS,
            floor: shows,
            least: shows,
            share: thresholds::PREDICTED_SHARE,
            worth: shows,
            ..usual
        }
    }
}

struct Searcher<'a> {
    problem: &'a Problem,
    candidates: Candidates,
    work: Workspace,
    found: Found<'a>,
    /// Library entries of sets that were screened beside, with their objective.
    screened: Vec<(Vec<usize>, f64)>,
}

/// Fits nothing, singles and sets.
pub(crate) fn search(problem: &Problem, limits: &Limits) -> Search {
    search_from(problem, limits, None)
}

/// Searches from the sets that a search on part of the rows has found.
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
        FULL,
        &mut work,
    );
    let candidates = Candidates::new(problem, &limits.allowed, &nominal, &mut work);
    let mut searcher = Searcher {
        problem,
        candidates,
        work,
        found: Found::new(problem),
        screened: Vec::new(),
    };
    let seeded = part.is_some_and(|(of, search)| searcher.seed(of, search));
    if limits.most_effects > 0 {
        searcher.singles(&nominal, seeded);
    }
    for size in 2..=limits.most_of(problem.len()) {
        let growth = Growth::new(size, size > limits.most_effects);
        if !searcher.grow(&growth, nominal.objective) {
            break;
        }
    }
    let every = searcher.found.fits;
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
        let near = |s: &&Scored| !s.fit.effects.is_empty() && s.score < best + thresholds::SEEDED;
        for set in search.sets.iter().filter(near) {
            let fit = refine(
                self.problem,
                set.fit.effects.clone(),
                self.problem.translate(of, &set.fit.theta),
                FULL,
                &mut self.work,
            );
            self.found.keep(fit);
        }
        !self.found.fits.is_empty()
    }

    fn singles(&mut self, nominal: &Fit, seeded: bool) {
        let (predicted, slopes) = self.candidates.scan(self.problem, nominal, &mut self.work);
        let best = predicted.first().map_or(0.0, |p| p.gain);
        let floor = thresholds::WORTH_REFINING.max(thresholds::REACH_SHARE * best);
        let base = Rc::new(Base {
            fit: nominal.clone(),
            slopes,
        });
        let mut extensions: Vec<Extension> = chosen(&predicted, 16, 4, floor)
            .into_iter()
            .filter(|p| {
                let mut singles = self.found.of_size(1);
                !singles.any(|f| f.has(p.entry))
            })
            .map(|p| Extension::new(&base, p))
            .collect();
        if seeded {
            self.found.drop_hopeless(&mut extensions, 1, 0.0);
        }
        for extension in extensions {
            self.race(&extension, nominal.objective);
        }
    }

    /// Adds an effect to the best sets of the size below; false if no candidate is worth trying.
    fn grow(&mut self, growth: &Growth, nominal: f64) -> bool {
        let size = growth.size;
        let mut tried = self.found.tried(size);
        let mut any = !tried.is_empty();
        // Objective of the set whose effects were exchanged last: the same set has nothing new to say.
        let mut exchanged = f64::INFINITY;
        for round in 0..3 {
            let bases = if round == 0 {
                self.found.leaders(size - 1, nominal, growth.bases)
            } else {
                let leads = self.found.leader(size).map_or(exchanged, |f| f.objective);
                if leads >= exchanged {
                    break;
                }
                exchanged = leads;
                self.exchange_bases(size)
            };
            let mut extensions = self.extensions(bases, growth, &tried);
            self.found
                .drop_hopeless(&mut extensions, size, growth.worth);
            if extensions.is_empty() {
                break;
            }
            any = true;
            extensions.sort_by(|a, b| a.predicted.total_cmp(&b.predicted));
            self.refine_extensions(extensions, &mut tried, growth.most, nominal);
            if growth.beyond && !self.found.closes(size) {
                return false;
            }
        }
        any
    }

    /// Additions worth a try beside each of some sets, but for sets that were tried.
    fn extensions(
        &mut self,
        bases: Vec<Fit>,
        growth: &Growth,
        tried: &[Vec<usize>],
    ) -> Vec<Extension> {
        let mut extensions: Vec<Extension> = Vec::new();
        for fit in bases {
            if !self.is_news(&fit) {
                continue;
            }
            let (predicted, slopes) = self.candidates.scan(self.problem, &fit, &mut self.work);
            let share = growth.share * self.found.beyond_noise(&fit);
            let base = Rc::new(Base { fit, slopes });
            let shows = predicted.partition_point(|p| p.gain > growth.least.max(share));
            let extension = chosen(&predicted[..shows], 5, 2, growth.floor).into_iter();
            extensions.extend(
                extension
                    .map(|predicted_gain| Extension::new(&base, predicted_gain))
                    .filter(|extension| {
                        !extension.repeats() && !tried.contains(&extension.entries())
                    }),
            );
        }
        extensions
    }

    /// Whether a set was not screened beside yet, or only where it described the data less well.
    fn is_news(&mut self, fit: &Fit) -> bool {
        let entries = entries(fit);
        let mut before = self.screened.iter().filter(|(of, _)| *of == entries);
        let news = !before.any(|(_, objective)| fit.objective > objective - FULL.enough);
        if news {
            self.screened.push((entries, fit.objective));
        }
        news
    }

    fn race(&mut self, extension: &Extension, nominal: f64) {
        race(
            self.problem,
            extension,
            nominal,
            &mut self.found,
            &mut self.work,
        );
    }

    fn refine_extensions(
        &mut self,
        extensions: Vec<Extension>,
        tried: &mut Vec<Vec<usize>>,
        most: usize,
        nominal: f64,
    ) {
        // Steady sets and those that scatter: one kind does not take the other's turns.
        let mut turns = [most; 2];
        for extension in extensions {
            let entries = extension.entries();
            let left = &mut turns[usize::from(extension.scatters())];
            if *left == 0 || tried.contains(&entries) {
                continue;
            }
            *left -= 1;
            tried.push(entries);
            self.race(&extension, nominal);
        }
    }

    /// The best set with each of its effects left out in turn, the others kept as they are.
    fn exchange_bases(&mut self, size: usize) -> Vec<Fit> {
        let Some(best) = self.found.leader(size).cloned() else {
            return Vec::new();
        };
        let mut bases = Vec::new();
        for leave in 0..best.effects.len() {
            let mut base = best.clone();
            base.effects.remove(leave);
            // The smaller set restarts from where the larger one arrived: a gain
            // that is only better convergence must not look like a second effect.
            let base = refine(self.problem, base.effects, base.theta, FULL, &mut self.work);
            self.found.keep(base.clone());
            bases.push(base);
        }
        bases
    }
}

/// -2 ln posterior density (up to a constant of the dataset) of the best fit with just these effects,
/// or some of them.
///
/// The square root of the difference between two sets is the size of what
/// tells them apart, in standard deviations of the whole dataset. With the
/// true effects named it is the best any method can do.
///
/// # Errors
/// [`GapError`] for unusable input, an unknown name, or a record instead of points.
pub fn misfit(folder: &Path, effects: &[&str]) -> Result<f64, GapError> {
    for name in effects {
        crate::effects::check_name(name)?;
    }
    let dataset = Dataset::read(folder)?;
    let problem = Problem::from_dataset(&dataset.rig, &dataset.measured)
        .ok_or_else(|| GapError::Usage("only a dataset of points has a misfit by effect".into()))?;
    let limits = Limits::only(effects);
    let found = search(&problem, &limits);
    let each = found.every.iter().map(|fit| fit.objective);
    Ok(each.fold(found.nominal.objective, f64::min))
}

/// Limits of a search.
#[derive(Debug, Clone)]
pub(crate) struct Limits {
    /// Entries of the library that may take part.
    pub(crate) allowed: Vec<bool>,
    /// Largest number of effects in a set, whatever they leave.
    pub(crate) most_effects: usize,
    /// Whether somebody stated that number.
    pub(crate) is_stated: bool,
    /// Largest number where fewer show lack of fit.
    pub(crate) most_beside_lack_of_fit: usize,
}

impl Limits {
    /// Only the given names, all of them at a time.
    pub(crate) fn only(names: &[&str]) -> Self {
        let allowed = library()
            .iter()
            .map(|e| names.contains(&e.entry().id))
            .collect();
        Self {
            allowed,
            most_effects: names.len(),
            is_stated: true,
            most_beside_lack_of_fit: names.len(),
        }
    }

    /// Largest number of effects that so many data can tell apart, if fewer show lack of fit.
    pub(crate) fn most_of(&self, data: usize) -> usize {
        if self.is_stated {
            return self.most_effects;
        }
        let usual = self
            .most_effects
            .min((data / thresholds::FEWEST_PER_EFFECT).max(1));
        usual.max(
            self.most_beside_lack_of_fit
                .min(data / thresholds::DATA_PER_EFFECT),
        )
    }

    /// These limits without the third and fourth effect: rows that remember those before look like one.
    pub(crate) fn without_more(&self) -> Self {
        Self {
            most_beside_lack_of_fit: self.most_effects,
            ..self.clone()
        }
    }

    /// Those of a diagnosis.
    pub(crate) fn of(options: &Options) -> Self {
        let withheld = |name: &str| options.without.iter().any(|n| n == name);
        let allowed = library().iter().map(|e| !withheld(e.entry().id));
        Self {
            allowed: allowed.collect(),
            most_effects: options.usual_effects(),
            is_stated: options.most_effects.is_some(),
            most_beside_lack_of_fit: options.most_effects.unwrap_or(thresholds::MOST_EFFECTS),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::calibrator::candidate::active;

    /// A set of one effect that is so probable; its parameters do not matter here.
    fn scored(entry: Option<usize>, probability: f64) -> Scored {
        let parameters = |entry: usize| vec![1.0; library()[entry].parameters().len()];
        let effects = entry.map(|entry| active(entry, parameters(entry)));
        let fit = Fit {
            effects: effects.into_iter().collect(),
            theta: Vec::new(),
            objective: 0.0,
        };
        let score = -2.0 * probability.ln();
        Scored {
            fit,
            bic: score,
            score,
            probability,
        }
    }

    /// A set that was negligible beside one that is struck leads where that is gone: it is heard too.
    #[test]
    fn a_set_that_comes_up_is_struck_as_well() {
        let mut found = Search {
            nominal: scored(None, 0.0).fit,
            sets: vec![
                scored(Some(0), 0.996),
                scored(Some(1), 0.003),
                scored(Some(2), 9e-4),
                scored(Some(3), 1e-6),
                scored(None, 1e-9),
            ],
            every: Vec::new(),
        };
        found.strike(|fit| fit.effects[0].entry > 1);
        let entries: Vec<_> = found
            .sets
            .iter()
            .map(|set| set.fit.effects.first().map(|e| e.entry))
            .collect();
        assert_eq!(entries, [Some(2), Some(3), None]);
        assert!(found.sets[0].probability > 0.99);
    }

    #[test]
    fn a_short_table_has_no_room_for_a_third_effect() {
        let usual = Limits::of(&Options::default());
        let most = [5, 11, 12, 59, 60, 79, 80, 5000].map(|data| usual.most_of(data));
        assert_eq!(most, [1, 1, 2, 2, 3, 3, 4, 4]);
        // Who asks for a number gets it.
        let stated = Options {
            most_effects: Some(3),
            ..Options::default()
        };
        assert_eq!(Limits::of(&stated).most_of(8), 3);
        // Where rows remember, none is tried for what they remember.
        assert_eq!(
            Limits::of(&Options::default()).without_more().most_of(5000),
            2
        );
        assert_eq!(Limits::only(&["back_emf"; 3]).most_of(8), 3);
    }
}
