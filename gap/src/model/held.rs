//! The motion of a row: the level is held by what the reference channel shows.

use super::chain::Chain;
use super::drive::{Drive, drive};
use super::grid::{ORDERS, size};
use super::memory::Recall;
use super::path::{Path, mixes};
use super::prediction::Nominal;
use super::row::Row;
use super::transfers::Transfers;
use crate::thresholds;
use num_complex::Complex64;

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
