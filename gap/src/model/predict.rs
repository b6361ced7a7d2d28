//! From nominal values and effects to every observable of a row.

use super::balance::Balanced;
use super::chain::Chain;
use super::channels::channels;
use super::effect::Active;
use super::grid::ln;
use super::held::Held;
use super::memory::Recall;
use super::prediction::{Nominal, Prediction};
use super::row::Row;
use super::transfers::Transfers;
use crate::observable::{Channel, Observable};
use crate::thresholds;

/// Simulates one row.
pub(crate) fn predict(
    row: &Row,
    nominal: &Nominal,
    effects: &[Active<'_>],
    memory: Recall<'_>,
) -> Prediction {
    let chain = chain(row, nominal, effects);
    let transfers = Transfers::new(row, effects);
    let held = Held::new(transfers, nominal, &chain, memory);
    let mut out = Prediction::EMPTY;
    let [ref_gain, dut_gain] = channels(nominal, &chain, &held, &mut out);
    let first = transfers.first;
    let ratio = ln(first.dut / first.reference * dut_gain / ref_gain);
    out.put(Observable::RATIO, ratio + nominal.ratio_ln);
    if let Some(motion) = &held.motion {
        let shown = ln(first.table * first.reference * first.drive * ref_gain);
        out.put(
            Observable::DRIVE,
            motion.first.ln[0] + shown + nominal.drive_ln,
        );
        out.put(Observable::CURRENT, motion.first.ln[1]);
        out.slopes = Some(motion.first.slopes);
        if let Some(balanced) = motion.balanced.as_ref().filter(|b| b.rests) {
            leave_rough(balanced, &mut out);
        }
        out.diverged = motion.balanced.as_ref().is_some_and(|b| !b.converged);
    }
    noise(nominal, &chain, &mut out);
    leave_open(&chain, &mut out);
    out
}

/// Joint action of all effects on the chain.
fn chain(row: &Row, nominal: &Nominal, effects: &[Active<'_>]) -> Chain {
    let mut chain = Chain::default();
    for effect in effects {
        effect.chain(row, &mut chain);
        effect.scatter(row, nominal.dut_gain, &mut chain.scatter);
    }
    chain
}

/// An armature that rests for part of the period: its fundamental and odd orders are known roughly.
fn leave_rough(balanced: &Balanced, out: &mut Prediction) {
    let largest = balanced.harmonics.iter().map(|h| h.norm_sqr());
    let open = thresholds::AT_REST * thresholds::AT_REST * largest.fold(0.0, f64::max);
    let odd = Channel::BOTH.map(|channel| {
        let [_, third, _, fifth] = Observable::harmonics(channel);
        [third, fifth]
    });
    let rough = [Observable::DRIVE, Observable::CURRENT].into_iter();
    for observable in rough.chain(odd.into_iter().flatten()).flatten() {
        out.open[observable] += open;
    }
}

/// Noise of both channels, without the harmonics above those of a wave.
fn noise(nominal: &Nominal, chain: &Chain, out: &mut Prediction) {
    for (channel, of) in Channel::BOTH.into_iter().enumerate() {
        let healthy = nominal.noise_v[channel] * nominal.noise_v[channel];
        let (power, open) = chain.scatter.noise(of, healthy);
        if power > 0.0 {
            // Most sets make no noise: its logarithm is known.
            out.value[Observable::noise(of)] = if power == healthy {
                nominal.noise_ln[channel]
            } else {
                0.5 * power.ln()
            };
            out.noise_power_v2[channel] = power;
            out.noise_share[channel] = healthy / power;
        }
        out.open[Observable::noise(of)] += open;
    }
}

/// Adds what leaks from other signals to the variance that stays open.
fn leave_open(chain: &Chain, out: &mut Prediction) {
    let leaks = &chain.scatter.leaks;
    if leaks.any() {
        for (observable, open) in out.open.iter_mut() {
            *open += leaks.of(observable);
        }
    }
}
