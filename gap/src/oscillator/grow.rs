//! One term at a time: what is tried, and when it stops.

use super::fit::{Fitted, compared, integrate_finely, refine};
use super::holdout::square_on;
use super::lack_of_fit::{Left, examine};
use super::model::{TERMS, shows};
use super::model_selection::{Step, cost_of_last};
use super::run::Run;
use super::starts::{SPRING, begin, bent_spring};
use crate::estimation::verdict::stands;
use crate::options::Options;
use crate::thresholds;
use rayon::prelude::*;

/// From the linear oscillator on, the best term is added until none is worth a name; what is `held` out has
/// a veto.
pub(super) fn grow(run: Run, mut start: Fitted, held: &Run, options: &Options) -> (Vec<Step>, Run) {
    let mut run = run;
    start.unseen = square_on(&run, &held.as_in(&run), &start);
    let left = examine(&run, &start);
    let mut steps = vec![Step {
        fit: start,
        left,
        tried: Vec::new(),
    }];
    while steps.len() <= options.usual_effects() {
        let base = &steps[steps.len() - 1];
        if base.left.unresolved {
            break;
        }
        let far = may_add(&run, &base.fit, SPRING, options)
            .then(|| bent_spring(&run, &base.fit))
            .flatten();
        if let Some((_, steps)) = &far {
            run = run.stretch(usize::MAX, *steps);
        }
        let mut tried = tried(&run, &base.fit, far.map(|f| f.0), options);
        run = integrate_finely(run, &mut tried);
        let Some(best) = tried.first() else { break };
        let (led, mut left) = (best.terms.clone(), examine(&run, best));
        let held = held.as_in(&run);
        strike(&mut tried, &steps, &left, [&run, &held]);
        let Some(best) = tried.first() else { break };
        if best.terms != led {
            left = examine(&run, best);
        }
        if !worth(&base.fit, best, &left) {
            break;
        }
        if let Some(better) = without_one(&run, best, &steps, &left, &held)
            && let Some(last) = steps.last_mut()
        {
            last.left = examine(&run, &better);
            last.tried.insert(0, better.clone());
            last.fit = better;
            continue;
        }
        let step = Step {
            fit: best.clone(),
            left,
            tried,
        };
        steps.push(led_by_the_most_probable(step, &run));
    }
    (steps, run)
}

fn may_add(run: &Run, base: &Fitted, term: usize, options: &Options) -> bool {
    let withheld = options.without.iter().any(|w| w == TERMS[term].entry.id);
    !withheld && !base.terms.contains(&term) && shows(term, &base.terms, run)
}

/// Every further term beside those of a fit, best first; `far` is one that was found otherwise.
fn tried(run: &Run, base: &Fitted, far: Option<Fitted>, options: &Options) -> Vec<Fitted> {
    // Errors of the integration up to the size of the noise do not change who leads.
    let coarse = if far.is_some() {
        run.stretch(usize::MAX, run.steps)
    } else {
        run.coarser()
    };
    let with = |t: usize| {
        let terms = [base.terms.as_slice(), &[t]].concat();
        let start = begin(&coarse, &base.values, t);
        let near = refine(&coarse, start, &terms, thresholds::FIRST_STEPS);
        let far = far.clone().filter(|far| far.terms == terms);
        near.into_iter()
            .chain(far)
            .min_by(|a, b| a.square.total_cmp(&b.square))
    };
    let free: Vec<usize> = (0..TERMS.len())
        .filter(|t| may_add(run, base, *t, options))
        .collect();
    let mut tried: Vec<Fitted> = free.into_par_iter().filter_map(with).collect();
    tried.sort_by(|a, b| a.square.total_cmp(&b.square));
    let leading = tried.len().min(thresholds::MOST_REFINED);
    tried[..leading].par_iter_mut().for_each(|fit| {
        if let Some(further) = refine(run, fit.values, &fit.terms, thresholds::STEPS_OF_LEADING) {
            *fit = further;
        }
    });
    tried.sort_by(|a, b| a.square.total_cmp(&b.square));
    // Of what a fit that ends early leaves, a further term would take its share.
    if let Some(best) = tried.first_mut()
        && let Some(further) = refine(run, best.values, &best.terms, thresholds::STEPS_TO_THE_END)
    {
        *best = further;
    }
    tried
}

/// A set less one of its earlier terms, where that does as well: a first term may have stood for what the
/// last one is. It errs less than the set that was grown from.
fn without_one(run: &Run, set: &Fitted, steps: &[Step], left: &Left, held: &Run) -> Option<Fitted> {
    let (last, before) = steps.split_last()?;
    let earlier = set.terms.split_last().map_or(&[][..], |(_, terms)| terms);
    let less = earlier.iter().filter_map(|term| {
        let mut values = set.values;
        TERMS[*term].values.iter().for_each(|v| values[*v] = 0.0);
        let kept: Vec<usize> = set.terms.iter().copied().filter(|t| t != term).collect();
        refine(run, values, &kept, thresholds::STEPS_OF_LEADING)
    });
    let mut less: Vec<Fitted> = less
        .filter(|fit| fit.square < last.fit.square && !worth(fit, set, left))
        .collect();
    if !less.is_empty() {
        strike(&mut less, before, left, [run, held]);
    }
    less.into_iter()
        .min_by(|a, b| a.square.total_cmp(&b.square))
}

/// Strikes the sets that what is held out speaks against. `before` are the steps so far, `left` is what the
/// best set leaves of the part that is fitted.
fn strike(tried: &mut Vec<Fitted>, before: &[Step], left: &Left, [part, held]: [&Run; 2]) {
    tried
        .par_iter_mut()
        .for_each(|fit| fit.unseen = square_on(part, held, fit));
    let clean = left.leaves_noise();
    let samples = left.independent(compared(&held.output, held).len() as f64);
    let misfit = |fit: &Fitted| samples * fit.unseen.ln();
    let smaller = &before[before.len() - 1].tried;
    tried.retain(|fit| {
        let part = |of: &&Fitted| of.terms.iter().all(|term| fit.terms.contains(term));
        let without = smaller.iter().filter(part).map(misfit);
        stands(misfit(fit), misfit(&before[0].fit), without, clean)
    });
}

/// Whether the last term of a set says more than chance: by the likelihood where
/// it leaves noise, by a share of the error where it leaves more.
fn worth(base: &Fitted, best: &Fitted, left: &Left) -> bool {
    if left.leaves_noise() {
        left.samples * (base.square / best.square).ln() > cost_of_last(best, left.samples)
    } else {
        best.square < base.square * (1.0 - thresholds::WORTH_NAMING)
    }
}

/// The step with the most probable of its sets: that which errs least is not always it.
fn led_by_the_most_probable(mut step: Step, record: &Run) -> Step {
    let first = step.compared().weighed().first().map(|w| w.fit.clone());
    if let Some(first) = first.filter(|first| first.terms != step.fit.terms) {
        step.left = examine(record, &first);
        step.fit = first;
    }
    step
}
