//! From nominal values and effects to every observable of a row.

use super::chain::{Chain, Transfer};
use super::channels::{Path, Reference, channels};
use super::drive::drive;
use super::exciter::Slopes;
use super::memory::Recall;
use super::row::{CURRENT, DRIVE, NOISE, RATIO, Row, SLOTS};
use crate::effects::Active;
use num_complex::Complex64;

/// Nominal values of a rig as a fit moves them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Nominal {
    /// Mass, stiffness, damping, force factor, resistance, inductance.
    pub(crate) exciter: Option<[f64; 6]>,
    /// ln of reference sensitivity (0 if unknown), and of DUT over reference sensitivity.
    pub(crate) drive_ln: f64,
    pub(crate) ratio_ln: f64,
    /// Gain of the device under test relative to its nominal value.
    pub(crate) dut_gain: f64,
    /// Sensitivity of the reference relative to its nominal value: the level is held by it.
    pub(crate) reference_gain: f64,
    /// Noise of a healthy channel: reference, device under test, in V.
    pub(crate) noise_v: [f64; 2],
    /// Its logarithm.
    pub(crate) noise_ln: [f64; 2],
}

/// What the simulation says about one row.
#[derive(Debug, Clone)]
pub(crate) struct Prediction {
    /// Value of each slot.
    pub(crate) value: [f64; SLOTS],
    /// Variance that the effects leave open, per slot.
    pub(crate) open: [f64; SLOTS],
    /// Slopes of drive and current against the six exciter values, relative.
    pub(crate) slopes: Option<[Slopes; 2]>,
    /// Mean square of the harmonics above 5 in each channel, in V^2.
    pub(crate) remainder_v2: [f64; 2],
    /// Share of it that is not known better.
    pub(crate) remainder_open: [f64; 2],
    /// Noise power of each channel without it, in V^2.
    pub(crate) noise_power_v2: [f64; 2],
    /// Share of the healthy noise in the noise power of each channel.
    pub(crate) noise_share: [f64; 2],
    /// The balance of a nonlinear exciter was not reached.
    pub(crate) diverged: bool,
}

/// Times the level is corrected for what a bent reference channel makes of the harmonics.
const MOST_LEVELS: usize = 4;

/// Simulates one row.
pub(crate) fn predict(
    row: &Row,
    nominal: &Nominal,
    effects: &[Active<'_>],
    memory: Recall<'_>,
) -> Prediction {
    let mut chain = Chain::default();
    for effect in effects {
        effect.chain(row, &mut chain);
        effect.scatter(row, nominal.dut_gain, &mut chain.scatter);
    }
    let first = transfer(row, effects, row.frequency_hz);
    let mut out = Prediction {
        value: [0.0; SLOTS],
        open: [0.0; SLOTS],
        slopes: None,
        remainder_v2: [0.0; 2],
        remainder_open: [0.0; 2],
        noise_power_v2: [0.0; 2],
        noise_share: [1.0; 2],
        diverged: false,
    };
    let mut memory = memory;
    let mut reference = Reference::new(row, &chain);
    let mut tries = 0;
    let (motion, path) = loop {
        let motion = nominal.exciter.map(|values| {
            let level = reference.input_ms2(row)
                / size(first.reference * first.table)
                / nominal.reference_gain;
            drive(row, &values, &chain, level, &mut memory)
        });
        let balanced = motion.as_ref().and_then(|m| m.balanced.as_ref());
        let path = Path::new(row, effects, first, balanced);
        // What bends the reference channel meets the harmonics of the motion, which follow the level.
        match reference
            .behind(&chain, &path)
            .filter(|_| tries < MOST_LEVELS)
        {
            Some(next) => reference = next,
            None => break (motion, path),
        }
        tries += 1;
    };
    let [ref_gain, dut_gain] = channels(nominal, &chain, &reference, &path, &mut out);
    let ratio = ln(first.dut / first.reference * dut_gain / ref_gain);
    put(&mut out, RATIO, ratio + nominal.ratio_ln);
    if let Some(motion) = motion {
        let shown = ln(first.table * first.reference * first.drive * ref_gain);
        put(
            &mut out,
            DRIVE,
            motion.first.ln[0] + shown + nominal.drive_ln,
        );
        put(&mut out, CURRENT, motion.first.ln[1]);
        out.slopes = Some(motion.first.slopes);
        out.diverged = motion.balanced.as_ref().is_some_and(|b| !b.converged);
    }
    noise(nominal, &chain, &mut out);
    if chain.scatter.leaks.any() {
        for (slot, open) in out.open[..NOISE].iter_mut().enumerate() {
            *open += chain.scatter.leaks.of(slot);
        }
    }
    out
}

/// Logarithm without the care for overflow that the library's takes: no value here is near it.
pub(super) fn ln(value: Complex64) -> Complex64 {
    if value == Complex64::ONE {
        return Complex64::ZERO;
    }
    Complex64::new(0.5 * value.norm_sqr().ln(), value.im.atan2(value.re))
}

/// Size of a value, likewise.
pub(super) fn size(value: Complex64) -> f64 {
    value.norm_sqr().sqrt()
}

pub(super) fn put(out: &mut Prediction, slot: usize, value: Complex64) {
    out.value[slot] = value.re;
    out.value[slot + 1] = value.im;
}

/// Linear responses of all effects together.
pub(super) fn transfer(row: &Row, effects: &[Active<'_>], frequency_hz: f64) -> Transfer {
    let mut transfer = Transfer::default();
    for effect in effects {
        effect.transfer(row, frequency_hz, &mut transfer);
    }
    transfer
}

fn noise(nominal: &Nominal, chain: &Chain, out: &mut Prediction) {
    for channel in 0..2 {
        let healthy = nominal.noise_v[channel] * nominal.noise_v[channel];
        let (power, open) = chain.scatter.noise(channel, healthy);
        if power > 0.0 {
            // Most sets make no noise: its logarithm is known.
            out.value[NOISE + channel] = if power == healthy {
                nominal.noise_ln[channel]
            } else {
                0.5 * power.ln()
            };
            out.noise_power_v2[channel] = power;
            out.noise_share[channel] = healthy / power;
        }
        out.open[NOISE + channel] += open;
    }
}
