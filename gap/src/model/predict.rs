//! From nominal values and effects to every observable of a row.

use super::balance::{Balanced, Bend, Motion, ORDERS, Purpose, balance};
use super::chain::{Chain, Transfer};
use super::channels::{Path, Reference, channels};
use super::exciter::{Added, Exciter, Linear};
use super::row::{CURRENT, DRIVE, NOISE, RATIO, Row, SLOTS};
use crate::effects::Active;
use num_complex::Complex64;
use std::f64::consts::SQRT_2;

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
}

/// What the simulation says about one row.
#[derive(Debug, Clone)]
pub(crate) struct Prediction {
    /// Value of each slot.
    pub(crate) value: [f64; SLOTS],
    /// Variance that the effects leave open, per slot.
    pub(crate) open: [f64; SLOTS],
    /// Slopes of drive and current against the six exciter values, relative.
    pub(crate) slopes: Option<([Complex64; 6], [Complex64; 6])>,
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

/// Memory of the harmonic balance of one row between evaluations.
#[derive(Debug, Clone)]
pub(crate) struct Memory {
    motion: Motion,
    /// What was balanced last, and the result: many effects leave the exciter as it was.
    last: Option<(Exciter, Bend, f64, Balanced)>,
}

impl Default for Memory {
    fn default() -> Self {
        Self {
            motion: [Complex64::ZERO; ORDERS + 1],
            last: None,
        }
    }
}

/// How an evaluation uses the memory of a row.
pub(crate) enum Recall<'a> {
    /// Starts from it, and leaves its own solution there.
    Keep(&'a mut Memory),
    /// Starts from it and leaves it as it is: for a small step aside.
    Look(&'a Memory),
}

impl Recall<'_> {
    fn balance(&mut self, exciter: &Exciter, bend: &Bend, omega: f64, peak_ms2: f64) -> Balanced {
        let memory = match &*self {
            Self::Keep(memory) => &**memory,
            Self::Look(memory) => memory,
        };
        if let Some((e, b, level, balanced)) = &memory.last
            && (e, b, level) == (exciter, bend, &peak_ms2)
        {
            return *balanced;
        }
        let mut motion = memory.motion;
        // Only from a balance nearby is the first correction the size of the step aside.
        let purpose = match (&*self, &memory.last) {
            (Self::Look(_), Some((.., near))) if near.converged => Purpose::Slope,
            _ => Purpose::Value,
        };
        let balanced = balance(exciter, bend, omega, peak_ms2, &mut motion, purpose);
        if let Self::Keep(memory) = self {
            memory.motion = motion;
            memory.last = Some((*exciter, *bend, peak_ms2, balanced));
        }
        balanced
    }
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
        let per_v = motion.linear.acceleration_per_v
            * first.table
            * first.reference
            * first.drive
            * ref_gain;
        put(&mut out, DRIVE, ln(per_v) + nominal.drive_ln);
        put(&mut out, CURRENT, ln(motion.linear.admittance));
        out.slopes = Some((motion.linear.drive_slope, motion.linear.current_slope));
        out.diverged = motion.balanced.is_some_and(|b| !b.converged);
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
fn ln(value: Complex64) -> Complex64 {
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

struct Drive {
    linear: Linear,
    balanced: Option<Balanced>,
}

fn drive(
    row: &Row,
    values: &[f64; 6],
    chain: &Chain,
    level_ms2: f64,
    memory: &mut Recall<'_>,
) -> Drive {
    let exciter = Exciter {
        mass_kg: values[0] + row.payload_kg + chain.mass_kg,
        stiffness_n_per_m: values[1],
        damping_ns_per_m: values[2] + chain.damping_ns_per_m,
        force_factor_n_per_a: values[3],
        resistance_ohm: values[4] * chain.resistance,
        inductance_h: values[5],
        emf_ratio: chain.emf,
        inductance_exponent: chain.inductance_exponent,
    };
    let added = Added {
        mass_kg: row.payload_kg + chain.mass_kg,
        damping_ns_per_m: chain.damping_ns_per_m,
    };
    let mut stiffness = exciter.dynamic_stiffness(row.omega);
    if chain.bend.is_linear()
        || !level_ms2.is_finite()
        || is_negligible(row, &exciter, chain, level_ms2)
    {
        return Drive {
            linear: exciter.linear(row.omega, added, stiffness),
            balanced: None,
        };
    }
    let balanced = memory.balance(&exciter, &chain.bend, row.omega, level_ms2 * SQRT_2);
    stiffness = balanced.stiffness;
    let mut linear = exciter.linear(row.omega, added, stiffness);
    linear.acceleration_per_v = balanced.acceleration_per_v;
    linear.admittance = balanced.admittance;
    Drive {
        linear,
        balanced: Some(balanced),
    }
}

/// At high frequency the travel is too small to bend anything; the row is then linear to 1e-7.
fn is_negligible(row: &Row, exciter: &Exciter, chain: &Chain, level_ms2: f64) -> bool {
    let bend = &chain.bend;
    if bend.friction_n != 0.0 || bend.even_per_v != 0.0 {
        return false;
    }
    if let Some(threshold) = bend.clip_v {
        let stiffness = exciter.dynamic_stiffness(row.omega);
        let per_v = exciter
            .linear(row.omega, Added::default(), stiffness)
            .acceleration_per_v
            .norm();
        if level_ms2 * SQRT_2 / per_v > 0.75 * threshold {
            return false;
        }
    }
    let sag = bend.gravity_ms2.abs() * exciter.mass_kg / exciter.stiffness_n_per_m;
    let travel = level_ms2 * SQRT_2 / (row.omega * row.omega);
    let slope = 2.0 * bend.quadratic_n_per_m2.abs() * (travel + sag)
        + 3.0 * bend.cubic_n_per_m3.abs() * travel * travel;
    slope < 1e-7 * exciter.dynamic_stiffness(row.omega).norm()
        && bend.droop_per_m2.abs() * travel * travel < 1e-7
}

fn noise(nominal: &Nominal, chain: &Chain, out: &mut Prediction) {
    for channel in 0..2 {
        let healthy = nominal.noise_v[channel] * nominal.noise_v[channel];
        let (power, open) = chain.scatter.noise(channel, healthy);
        if power > 0.0 {
            out.value[NOISE + channel] = 0.5 * power.ln();
            out.noise_power_v2[channel] = power;
            out.noise_share[channel] = healthy / power;
        }
        out.open[NOISE + channel] += open;
    }
}
