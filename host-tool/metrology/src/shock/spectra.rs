//! Spectra of a record, and the bins that can be used.

use super::choice::Choice;
use calib_files::{Error, Result};
use nalgebra::Complex;
use rustfft::FftPlanner;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;

/// Frequencies used, Hz.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Range {
    /// Lowest bin.
    pub from_hz: f64,
    /// Highest bin.
    pub to_hz: f64,
}

/// Share of its maximum to which the input's spectrum may fall by default.
const USABLE: f64 = 0.1;

pub(super) fn spectrum(values: &[f64]) -> Vec<Complex<f64>> {
    let mut buffer: Vec<Complex<f64>> = values.iter().map(|&v| Complex::new(v, 0.0)).collect();
    FftPlanner::new()
        .plan_fft_forward(buffer.len())
        .process(&mut buffer);
    buffer
}

/// Undoes a delay of so many samples.
pub(super) fn advance(spectrum: &mut [Complex<f64>], samples: f64) {
    let count = spectrum.len();
    for (n, bin) in spectrum.iter_mut().enumerate() {
        // The upper half are negative frequencies; Nyquist stays real.
        let signed = match (2 * n).cmp(&count) {
            std::cmp::Ordering::Less => n as f64,
            std::cmp::Ordering::Equal => 0.0,
            std::cmp::Ordering::Greater => n as f64 - count as f64,
        };
        *bin *= Complex::from_polar(1.0, TAU * signed * samples / count as f64);
    }
}

/// Bins in the range asked for; bin n lies at n/(N T). Bin 0 is left out, as
/// for a.c.-coupled amplifiers (7.3.1).
pub(super) fn bins(a: &[Complex<f64>], sample_rate_hz: f64, choice: &Choice) -> Result<Vec<usize>> {
    let spacing_hz = sample_rate_hz / a.len() as f64;
    let half = &a[1..a.len() / 2];
    let largest = half.iter().map(|bin| bin.norm()).fold(0.0, f64::max);
    let usable = half
        .iter()
        .rposition(|bin| bin.norm() >= USABLE * largest)
        .map_or(0, |index| index + 1);
    let bin_of = |f: f64| (f / spacing_hz).round().max(1.0) as usize;
    let first = choice.from_hz.map_or(1, bin_of);
    let last = choice.to_hz.map_or(usable, bin_of).min(half.len());
    match last >= first + 2 {
        true => Ok((first..=last).collect()),
        false => Err(Error::input(
            "record",
            format!(
                "only {} usable bins of {spacing_hz:.1} Hz",
                (last + 1).saturating_sub(first)
            ),
            "give a longer record, or a wider range with --from-hz and --to-hz",
        )),
    }
}

pub(super) fn range(bins: &[usize], count: usize, sample_rate_hz: f64) -> Range {
    let hz = |bin: Option<&usize>| bin.map_or(0.0, |&n| n as f64 * sample_rate_hz / count as f64);
    Range {
        from_hz: hz(bins.first()),
        to_hz: hz(bins.last()),
    }
}

/// The real signal behind a spectrum.
pub(super) fn from_spectrum(spectrum: &[Complex<f64>]) -> Vec<f64> {
    let mut values = spectrum.to_vec();
    FftPlanner::new()
        .plan_fft_inverse(values.len())
        .process(&mut values);
    let scale = 1.0 / values.len() as f64;
    values.iter().map(|value| value.re * scale).collect()
}
