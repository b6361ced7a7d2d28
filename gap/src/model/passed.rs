//! A wave of a channel behind what bends it.
//!
//! Where a wave is bent once only, the closed forms for a cosine do; harmonics
//! so small that a second bend does nothing to them are added.

use super::complex::size;
use super::grid::ORDERS;
use super::wave::Wave;
use super::waveform::Characteristic;
use crate::thresholds;
use num_complex::Complex64;

/// Whether a bend does to the harmonics that arrive what a sum would not.
pub(super) fn mixes(bend: Option<Characteristic>, peak: f64, others: f64) -> bool {
    let strength = |bend| match bend {
        Characteristic::Polynomial { second, third } => {
            2.0 * second.abs() * peak + 3.0 * third.abs() * peak * peak
        }
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
pub(super) fn bends_by(bend: Characteristic, peak: f64) -> f64 {
    let spectrum = bend.spectrum(peak);
    let harmonics = spectrum.order[2..].iter().map(|c| c.abs());
    harmonics.sum::<f64>() / peak
}
