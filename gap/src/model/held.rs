//! The motion of a row: the level is held by what the reference channel shows.

use super::balance::Balanced;
use super::chain::Chain;
use super::exciter::{Added, Exciter, Fundamental};
use super::grid::{ORDERS, size};
use super::memory::Recall;
use super::path::{Path, mixes};
use super::prediction::Nominal;
use super::row::Row;
use super::transfers::Transfers;
use crate::dataset::ExciterParameters;
use crate::thresholds;
use num_complex::Complex64;
use std::f64::consts::SQRT_2;

/// Times the level is corrected for what a bent reference channel makes of the harmonics.
const MOST_LEVELS: usize = 4;

/// The motion at which the reference channel shows the level that is held.
pub(super) struct Held<'a> {
    /// Motion of the exciter; `None` without a complete exciter.
    pub(super) motion: Option<Drive>,
    pub(super) reference: Reference,
    pub(super) path: Path<'a>,
}

impl<'a> Held<'a> {
    pub(super) fn new(
        transfers: Transfers<'a>,
        nominal: &Nominal,
        chain: &Chain,
        mut memory: Recall<'_>,
    ) -> Self {
        let (row, first) = (transfers.row, transfers.first);
        let mut at = |reference: Reference| {
            let motion = nominal.exciter.map(|values| {
                let level_ms2 = reference.input_ms2(row)
                    / size(first.reference * first.table)
                    / nominal.reference_gain;
                drive(row, &values, chain, level_ms2, &mut memory)
            });
            let balanced = motion.as_ref().and_then(|m| m.balanced.as_ref());
            let path = Path::new(transfers, balanced);
            Self {
                motion,
                reference,
                path,
            }
        };
        // Not as one loop: powers of the exciter would be raised out of it, and worked out for rows
        // that remember them too (7 % more instructions in a diagnosis).
        let mut held = at(Reference::new(row, chain));
        // What bends the reference channel meets the harmonics of the motion, which follow the level.
        for _ in 0..MOST_LEVELS {
            match held.reference.behind(chain, &held.path) {
                Some(reference) => held = at(reference),
                None => break,
            }
        }
        held
    }
}

/// The reference channel holds the level: what enters it follows from what it shows.
pub(super) struct Reference {
    /// Peak voltage that enters the converter.
    pub(super) peak_v: f64,
    /// Output over input.
    pub(super) gain: f64,
}

impl Reference {
    /// For a sine.
    fn new(row: &Row, chain: &Chain) -> Self {
        let peak_v = row.ref_peak_v;
        let (peak_v, gain) = match chain.ref_adc {
            Some(adc) if peak_v.is_finite() => {
                let input_v = adc.input_for(peak_v);
                (input_v, adc.spectrum(input_v).order[1] / input_v)
            }
            _ => (peak_v, 1.0),
        };
        Self { peak_v, gain }
    }

    /// For the wave that arrives; `None` where it makes no difference.
    fn behind(&self, chain: &Chain, path: &Path<'_>) -> Option<Self> {
        let adc = chain.ref_adc?;
        if !mixes(Some(adc), self.peak_v, path.others) {
            return None;
        }
        let arriving = path.to_reference(ORDERS);
        let shown = path.transfers.row.ref_peak_v;
        // Gain, and growth of the output over that of the input.
        let at = |peak_v: f64| {
            let mut wave = arriving.map(|c| c * peak_v);
            (wave[0], wave[1]) = (Complex64::ZERO, Complex64::from(peak_v));
            let [first, moved] = adc.fundamental_behind(&wave);
            let growth = (first.conj() * moved).re / first.norm_sqr();
            (size(first) / peak_v, growth)
        };
        let mut next = Self { ..*self };
        let mut growth;
        (next.gain, growth) = at(next.peak_v);
        // A saturating channel may not be able to show what it does: then the last try holds.
        for _ in 0..12 {
            let off = shown / (next.peak_v * next.gain) - 1.0;
            if off.abs() < 1e-10 {
                break;
            }
            // The output grows less than the input where it saturates.
            next.peak_v *= 1.0 + (off / growth.max(0.02)).clamp(-0.5, 1.0);
            (next.gain, growth) = at(next.peak_v);
        }
        ((next.gain / self.gain - 1.0).abs() > thresholds::NEGLIGIBLE).then_some(next)
    }

    /// Held level corrected for the channel, r.m.s.
    fn input_ms2(&self, row: &Row) -> f64 {
        row.level_ms2 / self.gain
    }
}

/// Action of the exciter on one row.
pub(super) struct Drive {
    pub(super) first: Fundamental,
    /// A balance of harmonics where the exciter is nonlinear.
    pub(super) balanced: Option<Balanced>,
}

/// Drives a row to the level that is held.
pub(super) fn drive(
    row: &Row,
    values: &ExciterParameters<f64>,
    chain: &Chain,
    level_ms2: f64,
    memory: &mut Recall<'_>,
) -> Drive {
    let exciter = Exciter {
        mass_kg: values.moving_mass_kg + row.payload_kg + chain.mass_kg,
        stiffness_n_per_m: values.stiffness_n_per_m * chain.stiffness,
        creep_per_decade: chain.creep_per_decade,
        damping_ns_per_m: values.damping_ns_per_m + chain.damping_ns_per_m,
        force_factor_n_per_a: values.force_factor_n_per_a * chain.force_factor,
        resistance_ohm: values.coil_resistance_ohm * chain.resistance,
        inductance_h: values.coil_inductance_h * chain.inductance,
        emf_ratio: chain.emf,
        inductance_exponent: chain.inductance_exponent,
        shorted: chain.shorted,
        body: chain.body,
    };
    let added = Added {
        mass_kg: row.payload_kg + chain.mass_kg,
        damping_ns_per_m: chain.damping_ns_per_m,
    };
    if chain.bend.is_linear()
        || !level_ms2.is_finite()
        || is_negligible(row, &exciter, chain, level_ms2)
    {
        let first = memory.still(&exciter, added, || {
            let stiffness = exciter.dynamic_stiffness(row.omega);
            Fundamental::new(&exciter.linear(row.omega, added, stiffness))
        });
        return Drive {
            first,
            balanced: None,
        };
    }
    let balanced = memory.balance(&exciter, &chain.bend, row.omega, level_ms2 * SQRT_2);
    let mut linear = exciter.linear(row.omega, added, balanced.stiffness);
    linear.acceleration_per_v = balanced.acceleration_per_v;
    linear.admittance = balanced.admittance;
    Drive {
        first: Fundamental::new(&linear),
        balanced: Some(balanced),
    }
}

/// At high frequency the travel is too small to bend anything; the row is then linear.
fn is_negligible(row: &Row, exciter: &Exciter, chain: &Chain, level_ms2: f64) -> bool {
    let bend = &chain.bend;
    if bend.friction_n != 0.0 || bend.even_per_v != 0.0 {
        return false;
    }
    if let Some(threshold) = bend.clip_v {
        let per_v = size(exciter.acceleration_per_v(row.omega));
        if level_ms2 * SQRT_2 / per_v > thresholds::NEAR_CLIPPING * threshold {
            return false;
        }
    }
    // The third harmonic is a twelfth of the square of voltage over threshold.
    if let Some(knee_v) = bend.knee_v {
        let per_v = size(exciter.acceleration_per_v(row.omega));
        if level_ms2 * SQRT_2 / per_v > 1e-3 * knee_v {
            return false;
        }
    }
    let sag = bend.gravity_ms2.abs() * exciter.mass_kg / exciter.static_stiffness_n_per_m();
    let travel = level_ms2 * SQRT_2 / (row.omega * row.omega);
    let slope = 2.0 * bend.quadratic_n_per_m2.abs() * (travel + sag)
        + 3.0 * bend.cubic_n_per_m3.abs() * (travel + sag).powi(2);
    slope < thresholds::NEGLIGIBLE * exciter.dynamic_stiffness(row.omega).norm()
        && bend.droop_per_m2.abs() * travel * travel < thresholds::NEGLIGIBLE
}
