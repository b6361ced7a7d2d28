//! One term at a time: what is tried, and when it stops.

use super::fit::{Fitted, all_terms, begin, refine};
use super::left::{Left, examine};
use super::model::TERMS;
use super::weigh::{cost_of_last, weigh};
use crate::dataset::Record;
use crate::diagnose::{NONE_BELOW, Options};

/// Share of the squared error a term must remove to be named, where what is left is no noise.
///
/// A record has tens of thousands of samples: beside model error any term is
/// "significant". One counts if it lowers the simulation error by 5 %.
const WORTH_NAMING: f64 = 0.1;

/// Steps after which terms are compared, and steps of those that lead.
const FIRST_STEPS: usize = 4;
const MOST_STEPS: usize = 10;
/// Terms that are refined to the end.
const REFINED: usize = 5;

/// One step: the fit, what it leaves, and the sets of its size that were tried.
pub(super) struct Step {
    pub(super) fit: Fitted,
    pub(super) left: Left,
    pub(super) tried: Vec<Fitted>,
}

impl Step {
    /// The set that errs least is not always the most probable.
    fn led_by_the_most_probable(mut self, record: &Record) -> Option<Self> {
        let first = weigh(&self).first().map(|w| w.0.clone())?;
        if first.terms != self.fit.terms {
            self.left = examine(record, &first)?;
            self.fit = first;
        }
        Some(self)
    }
}

/// From the linear oscillator on, the best term is added until none is worth a name.
pub(super) fn grow(record: &Record, start: Fitted, options: &Options) -> Option<Vec<Step>> {
    let left = examine(record, &start)?;
    let mut steps = vec![Step {
        fit: start,
        left,
        tried: Vec::new(),
    }];
    while steps.len() <= options.most_effects {
        let base = &steps[steps.len() - 1];
        if base.left.unresolved {
            break;
        }
        let tried = tried(record, &base.fit, options);
        let Some(best) = tried.first() else { break };
        let left = examine(record, best)?;
        if !worth(&base.fit, best, &left) {
            break;
        }
        let step = Step {
            fit: best.clone(),
            left,
            tried,
        };
        steps.push(step.led_by_the_most_probable(record)?);
    }
    Some(steps)
}

/// Every further term beside those of a fit, best first.
fn tried(record: &Record, base: &Fitted, options: &Options) -> Vec<Fitted> {
    let free =
        |t: &usize| !base.terms.contains(t) && !options.without.iter().any(|w| w == TERMS[*t].name);
    let with = |t: usize| {
        let mut terms = base.terms.clone();
        terms.push(t);
        refine(record, begin(record, &base.values, t), &terms, FIRST_STEPS)
    };
    let mut tried: Vec<Fitted> = all_terms().filter(free).filter_map(with).collect();
    tried.sort_by(|a, b| a.square.total_cmp(&b.square));
    for fit in tried.iter_mut().take(REFINED) {
        if let Some(further) = refine(record, fit.values, &fit.terms, MOST_STEPS) {
            *fit = further;
        }
    }
    tried.sort_by(|a, b| a.square.total_cmp(&b.square));
    tried
}

/// Whether the last term of a set says more than chance: by the likelihood where
/// it leaves noise, by a share of the error where it leaves more.
fn worth(base: &Fitted, best: &Fitted, left: &Left) -> bool {
    if left.p_value >= NONE_BELOW {
        left.samples * (base.square / best.square).ln() > cost_of_last(best, left.samples)
    } else {
        best.square < base.square * (1.0 - WORTH_NAMING)
    }
}
