//! Answer for a record: verdict, place, next measurement, pictures.

use super::fit::{Fitted, compared, rms};
use super::holdout::{HeldOut, motion, peak};
use super::lack_of_fit::Parity;
use super::model::TERMS;
use super::model_selection::Step;
use super::parameters::Parameter;
use super::run::Run;
use super::slices::stretch;
use crate::answer::{
    Answer, Cause, DatasetSummary, Estimate, OwnNoise, Remainder, Verdict, Where, hardly_separated,
};
use crate::axis::Axis;
use crate::estimation::verdict::{Evidence, conclude, doubted, heard};
use crate::observable::Group;
use crate::others::share_with_others;
use crate::pictures::{Pictures, Trace};
use crate::thresholds;
use calib_effects::{Of, Stage, named};
use std::collections::BTreeMap;

/// Samples of a stretch that is drawn.
const MOST_DRAWN: usize = 4000;

/// The answer to a record of which `part` was fitted and `held` was not.
pub(super) fn answer(
    steps: &[Step],
    part: &Run,
    held: &Run,
    mut held_out: HeldOut,
    dataset: DatasetSummary,
) -> Answer {
    let last = &steps[steps.len() - 1];
    let resonance_hz = steps[0].fit.values.resonance_hz();
    let causes = match last.fit.terms[..] {
        [] => Vec::new(),
        _ => last
            .compared()
            .causes(part, stretch(resonance_hz, part.interval_s)),
    };
    let mut causes = causes;
    let verdict = verdict(&causes, steps, &held_out);
    if verdict == Verdict::NoGap {
        held_out.gap.size.closed = None;
    }
    let confusable = hardly_separated(&causes, verdict);
    let probability_other = share_with_others(
        &mut causes,
        verdict,
        last.left.p_value,
        &held_out.gap,
        &thresholds::OUTSIDE_OF_RECORDS,
    );
    let verdict = doubted(
        verdict,
        causes.first().map(|c| c.probability),
        &held_out.gap,
    );
    let partly = matches!(verdict, Verdict::PartlyExplained | Verdict::Unexplained);
    let answer = Answer {
        summary: String::new(),
        remainder: partly.then(|| Remainder {
            observable: Group::Output,
            rms_rel: held_out.gap.size.after_rel,
            axis: Axis::Amplitude,
            from: 0.0,
            to: peak(&motion(&last.fit, held)),
        }),
        noise: OwnNoise::default(),
        probability_other,
        verdict,
        r#where: place(verdict, steps, held),
        none_of_these_p_value: last.left.p_value,
        confusable,
        next_measurement: next_measurement(verdict, &causes),
        gap: held_out.gap,
        nominal_parameters: linear_parameters(&last.fit, part.driven),
        dataset,
        confirmation: None,
        pictures: trace(held, held_out.errors),
        causes,
    };
    answer.summarised()
}

fn verdict(causes: &[Cause], steps: &[Step], held_out: &HeldOut) -> Verdict {
    let evidence = Evidence {
        // A term is only added where it is worth its cost.
        none: 0.0,
        leading: causes.first().map(|c| c.probability),
        p_nominal: steps[0].left.p_value,
        p_value: steps[steps.len() - 1].left.p_value,
    };
    let white = Evidence {
        p_value: 1.0,
        ..evidence
    };
    let tied = conclude(&white) == Verdict::Ambiguous;
    let nearly_all = held_out
        .gap
        .size
        .closed
        .is_some_and(|c| c > thresholds::NEARLY_ALL);
    match conclude(&evidence) {
        Verdict::Unexplained if tied && nearly_all => Verdict::Ambiguous,
        verdict => heard(verdict, &held_out.gap, false),
    }
}

/// Where the linear oscillator and the record differ: by the set that was found, and by the parity of the traces.
fn place(verdict: Verdict, steps: &[Step], held: &Run) -> Vec<Where> {
    if verdict == Verdict::NoGap {
        return Vec::new();
    }
    let (first, last) = (&steps[0], &steps[steps.len() - 1]);
    let strongest = |parity: Parity| {
        let of = first.left.traces.iter().filter(|t| t.0 == parity);
        of.fold(0.0_f64, |m, t| m.max(t.1.abs()))
    };
    let [odd, even, linear] = [Parity::Odd, Parity::Even, Parity::Linear].map(strongest);
    let class = if linear > odd.max(even) {
        "frequency"
    } else if even < thresholds::OTHER_PARITY * odd {
        "odd"
    } else if odd < thresholds::OTHER_PARITY * even {
        "even"
    } else {
        "odd and even"
    };
    let stage = last
        .fit
        .terms
        .first()
        .map_or(Stage::Dut, |t| TERMS[*t].entry.stage);
    vec![Where {
        stage,
        observable: Group::Output,
        axis: Axis::Amplitude,
        or_along: Vec::new(),
        from: 0.0,
        to: peak(&motion(&last.fit, held)),
        share: 1.0 - last.fit.square / first.fit.square,
        p_value: first.left.p_value,
        class,
        shape: None,
    }]
}

fn next_measurement(verdict: Verdict, causes: &[Cause]) -> String {
    let how = |name: &str| {
        named(Of::Oscillator, name).map_or("another record", |entry| entry.separate_by)
    };
    let last = |c: &Cause| c.effects.last().copied().unwrap_or_default();
    match (verdict, causes) {
        (Verdict::NoGap, _) => "none needed: repeat the record after the next change".into(),
        (Verdict::Ambiguous, [first, second, ..]) => format!(
            "to tell {} from {}: {}",
            first.effects.join("+"),
            second.effects.join("+"),
            how(last(second))
        ),
        (Verdict::Explained | Verdict::PartlyExplained, [first, ..]) => {
            format!("to confirm {}: {}", last(first), how(last(first)))
        }
        _ => "a record of larger amplitude, and one of half the amplitude".into(),
    }
}

/// The stretch in which the linear simulation errs most.
fn trace(held: &Run, [before, after]: [Vec<f64>; 2]) -> Pictures {
    let parts = before.chunks(MOST_DRAWN).map(rms).enumerate();
    let worst = parts.max_by(|a, b| a.1.total_cmp(&b.1));
    let from = worst.map_or(0, |w| w.0) * MOST_DRAWN;
    let drawn = |values: &[f64]| -> Vec<f64> {
        values.iter().skip(from).take(MOST_DRAWN).copied().collect()
    };
    Pictures::Record(Trace {
        interval_s: held.interval_s,
        measured: drawn(compared(&held.output, held)),
        before: drawn(&before),
        after: drawn(&after),
    })
}

/// Resonance, damping, gain and offset; no gain where nothing drives the oscillator.
pub(super) fn linear_parameters(fit: &Fitted, driven: bool) -> BTreeMap<&'static str, Estimate> {
    let of = |parameter: Parameter| Estimate {
        value: fit.values[parameter],
        u: fit.covariance_of(parameter, parameter).sqrt(),
    };
    let resonance_hz = fit.values.resonance_hz();
    let ln_resonance = of(Parameter::LnResonance);
    let resonance = Estimate {
        value: resonance_hz,
        u: resonance_hz * ln_resonance.u,
    };
    let mut values = BTreeMap::from([
        ("resonance_hz", resonance),
        ("delta", of(Parameter::Delta)),
        ("offset", of(Parameter::Offset)),
    ]);
    if driven {
        values.insert("gain", of(Parameter::Gain));
    }
    values
}
