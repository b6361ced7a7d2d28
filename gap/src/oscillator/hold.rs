//! Whether the input of a record is held between its samples.
//!
//! A converter holds what it puts out; the samples of a sensor are those of a smooth signal. No file says which of the
//! two its input is. One taken for the other is a delay of half a sample that nothing at the rig causes.

use super::fit::{Fitted, refine};
use super::grow::grow;
use super::model_selection::{Step, cost_of_last};
use super::run::Run;
use crate::options::Options;
use crate::thresholds;

/// Terms one at a time, with an input that is smooth, and with one that is held where that describes the record
/// better: whichever comes out more probable.
pub(super) fn grown(
    run: Run,
    start: Fitted,
    held_out: &Run,
    options: &Options,
) -> (Vec<Step>, Run) {
    let holding = run.driven.then(|| run.holding(true));
    let smooth = grow(run, start, held_out, options);
    let Some(holding) = holding else {
        return smooth;
    };
    let (first, last) = (&smooth.0[0].fit, &smooth.0[smooth.0.len() - 1].fit);
    let anew = |fit: &Fitted| {
        refine(
            &holding,
            fit.values,
            &fit.terms,
            thresholds::STEPS_OF_LEADING,
        )
    };
    let suits = |fit: &Fitted| anew(fit).is_some_and(|held| held.square < fit.square);
    match anew(first) {
        Some(start) if start.square < first.square || suits(last) => {
            let held = grow(holding, start, held_out, options);
            if is_better(&held.0, &smooth.0) {
                held
            } else {
                smooth
            }
        }
        _ => smooth,
    }
}

/// Whether some steps come to a more probable set than others do. Of model error the next term always takes a little,
/// so each may be the last.
fn is_better(steps: &[Step], others: &[Step]) -> bool {
    let clean = [steps, others]
        .iter()
        .any(|s| s[s.len() - 1].left.leaves_noise());
    let best = |steps: &[Step]| {
        let mut costs = 0.0;
        let scores = steps.iter().map(|step| {
            let all = step.left.samples;
            let samples = if clean {
                all
            } else {
                step.left.independent(all)
            };
            costs += cost_of_last(&step.fit, samples);
            samples * step.fit.square.ln() + costs
        });
        scores.fold(f64::INFINITY, f64::min)
    };
    best(steps) < best(others)
}
