//! The wave of the table on its way through linear responses.

use super::balance::Balanced;
use super::chain::Transfer;
use super::grid::{ORDERS, Wave, size};
use super::transfers::Transfers;
use super::waveform::{Characteristic, REPORTED};
use crate::thresholds;
use num_complex::Complex64;

/// Orders that stand for all above [`ORDERS`] of a jump, whose powers fall with the square of the
/// order: in the middle of quarters of 1/n.
const JUMP: [usize; 4] = [128, 43, 26, 18];
/// Orders for a kink, whose powers fall with the fourth power: above 5, and above [`ORDERS`].
const KINK: [[usize; 4]; 2] = [[6, 7, 8, 11], [16, 18, 22, 31]];

/// Orders above 5 behind a response.
pub(super) struct Above {
    /// Mean square over that of the fundamental.
    pub(super) remainder: f64,
    /// Part of it that no wave holds.
    pub(super) beyond: f64,
}

/// The wave of the table, and the linear responses on its way.
pub(super) struct Path<'a> {
    pub(super) transfers: Transfers<'a>,
    /// Relative to the fundamental, whose phase is zero.
    pub(super) table: Wave,
    /// Sum of the sizes of its harmonics.
    pub(super) others: f64,
    /// Mean square of the orders above 5 over that of the fundamental.
    pub(super) remainder: f64,
    /// Part of it that no wave holds.
    pub(super) beyond: f64,
}

impl<'a> Path<'a> {
    /// The way from an exciter's motion; `None` is a sine.
    pub(super) fn new(transfers: Transfers<'a>, motion: Option<&Balanced>) -> Self {
        let mut table = [Complex64::ZERO; ORDERS + 1];
        if let Some(motion) = motion {
            table[2..REPORTED].copy_from_slice(&motion.harmonics);
            table[REPORTED..].copy_from_slice(&motion.above);
        }
        Self {
            transfers,
            others: motion.map_or(0.0, |_| sizes(&table)),
            table,
            remainder: motion.map_or(0.0, |m| m.remainder),
            beyond: motion.map_or(0.0, |m| m.beyond),
        }
    }

    /// Whether the table moves without harmonics.
    pub(super) fn is_sine(&self) -> bool {
        self.others == 0.0 && self.remainder == 0.0
    }

    /// Relative harmonics up to an order behind a response.
    pub(super) fn carry(
        &self,
        wave: &Wave,
        highest: usize,
        of: fn(&Transfer) -> Complex64,
    ) -> Wave {
        let mut out = [Complex64::ZERO; ORDERS + 1];
        let first = of(&self.transfers.first);
        for n in (2..=highest).filter(|n| wave[*n] != Complex64::ZERO) {
            let there = self.transfers.at_order(n);
            out[n] = wave[n] * carried(of(&there), first, n as u32);
        }
        out
    }

    /// Mean square of the orders above 5 behind a response, over that of the fundamental there, and
    /// what of it no wave holds.
    pub(super) fn above(&self, of: fn(&Transfer) -> Complex64) -> Above {
        if self.remainder < thresholds::UNSEEN {
            return Above {
                remainder: self.remainder,
                beyond: self.beyond,
            };
        }
        let filled = (REPORTED..=ORDERS).filter(|n| self.table[*n] != Complex64::ZERO);
        let within = filled.map(|n| self.table[n].norm_sqr() * self.carried_power(of, &[n]));
        let within: f64 = within.sum();
        let beyond = if self.beyond > 0.0 {
            self.beyond * self.carried_power(of, &JUMP)
        } else {
            0.0
        };
        Above {
            remainder: within + beyond,
            beyond,
        }
    }

    /// Power behind a response over that in front of it, of what a kink has above the orders that are
    /// followed: all of a whole wave, or those that are reported.
    pub(super) fn carries_kink(&self, of: fn(&Transfer) -> Complex64, whole: bool) -> f64 {
        self.carried_power(of, &KINK[usize::from(whole)])
    }

    /// Power carried, the mean of some orders.
    fn carried_power(&self, of: fn(&Transfer) -> Complex64, orders: &[usize]) -> f64 {
        let first = of(&self.transfers.first).norm_sqr();
        let power = |n: &usize| of(&self.transfers.at_order(*n)).norm_sqr() / first;
        orders.iter().map(power).sum::<f64>() / orders.len() as f64
    }

    /// Input of the reference channel.
    pub(super) fn to_reference(&self, highest: usize) -> Wave {
        self.carry(&self.table, highest, |t| t.table * t.reference)
    }
}

/// Sum of the sizes of relative harmonics.
fn sizes(wave: &Wave) -> f64 {
    wave[2..].iter().map(|c| size(*c)).sum()
}

/// Response at order n relative to the fundamental, phase relative to n times its phase.
fn carried(at_order: Complex64, at_first: Complex64, n: u32) -> Complex64 {
    let first = size(at_first);
    at_order / first * (at_first / first).powu(n).conj()
}

/// Orders that have to be followed: all where a wave is bent twice.
pub(super) fn highest(twice: bool) -> usize {
    if twice { ORDERS } else { REPORTED - 1 }
}

/// Whether a bend does to the harmonics that arrive what a sum would not.
pub(super) fn mixes(bend: Option<Characteristic>, peak: f64, others: f64) -> bool {
    let strength = |bend| match bend {
        Characteristic::Polynomial { second, third } => {
            2.0 * second.abs() * peak + 3.0 * third.abs() * peak * peak
        }
        // Its cubic part is v^3 over three squares of the threshold.
        Characteristic::Soft { threshold } => (peak / threshold).powi(2),
        Characteristic::DeadZone { .. } => 1.0,
        Characteristic::Clip { threshold } | Characteristic::OneSided { threshold, .. } => {
            f64::from(u8::from(peak * (1.0 + others) > threshold))
        }
    };
    peak.is_finite() && bend.is_some_and(|bend| strength(bend) * others > thresholds::NEGLIGIBLE)
}

/// A wave behind a characteristic.
pub(super) struct Passed {
    /// Fundamental over that in front.
    pub(super) gain: Complex64,
    /// Relative harmonics; phases relative to n times that of the fundamental.
    pub(super) wave: Wave,
    pub(super) mean: f64,
    /// Mean square of the orders that are not in the wave.
    pub(super) beyond: f64,
}

/// Output of a characteristic for a fundamental of the given peak and its relative harmonics;
/// as a whole wave, or by the closed form to which the harmonics are added.
pub(super) fn pass(bend: Characteristic, peak: f64, arriving: &Wave, whole: bool) -> Passed {
    if whole {
        return shaped(bend, peak, arriving);
    }
    let spectrum = bend.spectrum(peak);
    let gain = spectrum.order[1] / peak;
    let mut wave = arriving.map(|c| c / gain);
    for (n, order) in spectrum.order.iter().enumerate().skip(2) {
        wave[n] += order / spectrum.order[1];
    }
    Passed {
        gain: Complex64::from(gain),
        wave,
        mean: spectrum.order[0],
        beyond: spectrum.remainder_mean_square,
    }
}

/// As a whole wave.
pub(super) fn shaped(bend: Characteristic, peak: f64, arriving: &Wave) -> Passed {
    let mut wave = arriving.map(|c| c * peak);
    wave[0] = Complex64::ZERO;
    wave[1] = Complex64::from(peak);
    let shaped = bend.shape(&wave);
    let first = shaped.wave[1];
    let (length, back) = (size(first), (first / size(first)).conj());
    let mut turned = back;
    let mut relative = [Complex64::ZERO; ORDERS + 1];
    for (order, there) in relative.iter_mut().zip(&shaped.wave).skip(2) {
        turned *= back;
        *order = there / length * turned;
    }
    Passed {
        gain: first / peak,
        wave: relative,
        mean: shaped.wave[0].re,
        beyond: shaped.beyond,
    }
}

/// Harmonics of a sine behind a cut, roughly: none below the threshold.
pub(super) fn distortion(bend: Characteristic, peak: f64) -> f64 {
    let spectrum = bend.spectrum(peak);
    let harmonics = spectrum.order[2..].iter().map(|c| c.abs());
    harmonics.sum::<f64>() / peak
}
