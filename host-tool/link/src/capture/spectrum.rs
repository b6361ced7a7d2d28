//! Amplitudes over frequency, for displays.

use num_complex::Complex;
use rustfft::FftPlanner;
use serde::Serialize;
use std::f64::consts::TAU;

/// How a waveform is faded in and out before its spectrum is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Window {
    /// Narrow lines; a tone between two lines shows up to 15.1 % (1.42 dB) low.
    #[default]
    Hann,
    /// Broad lines of the right height: at most 0.11 % low between two lines.
    FlatTop,
}

impl Window {
    /// Coefficients of `a0 - a1 cos x + a2 cos 2x - ...`.
    ///
    /// Those of the flat top are the ones spectrum analysers use; what they do is
    /// held by `a_tone_between_lines_is_low_by_the_scallop_loss`.
    const fn coefficients(self) -> &'static [f64] {
        match self {
            Self::Hann => &[1.0, 1.0],
            Self::FlatTop => &[1.0, 1.933, 1.286, 0.388, 0.0322],
        }
    }

    /// Weight of sample `index` of `length`, of mean 1.
    fn weight(self, index: usize, length: usize) -> f64 {
        let angle_rad = TAU * index as f64 / length as f64;
        let terms = self.coefficients().iter().enumerate();
        let terms = terms.map(|(order, factor)| {
            let sign = if order % 2 == 0 { 1.0 } else { -1.0 };
            sign * factor * (order as f64 * angle_rad).cos()
        });
        terms.sum()
    }

    /// Equivalent noise bandwidth, in lines: the mean square of the weights.
    pub fn noise_bandwidth_lines(self) -> f64 {
        let factors = self.coefficients();
        let cosines = factors.iter().skip(1).map(|factor| 0.5 * factor * factor);
        1.0 + cosines.sum::<f64>()
    }
}

/// An amplitude spectrum: line `k` at `k` times the spacing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spectrum {
    /// Distance of two lines, Hz.
    pub spacing_hz: f64,
    /// Window that was used.
    pub window: Window,
    /// Lines from 0 Hz to half the sample rate, V r.m.s.; line 0 is the mean, V.
    /// A line shows a tone of its frequency at its r.m.s. value. White noise of n
    /// V r.m.s. shows as `n sqrt(2 B / N)`, with N samples and B the window's
    /// noise bandwidth in lines.
    pub rms_v: Vec<f64>,
}

impl Spectrum {
    /// Frequency of a line, Hz.
    pub fn frequency_hz(&self, line: usize) -> f64 {
        line as f64 * self.spacing_hz
    }

    /// The highest lines with their frequencies, highest first: only those that
    /// stand above both neighbours, so a tone counts once, and not the mean.
    pub fn peaks(&self, count: usize) -> Vec<(f64, f64)> {
        let stands_out = |at: &usize| {
            let around = &self.rms_v[at - 1..=at + 1];
            around[1] > around[0] && around[1] >= around[2]
        };
        let last = self.rms_v.len().saturating_sub(1);
        let mut lines: Vec<usize> = (2..last).filter(stands_out).collect();
        lines.sort_by(|a, b| self.rms_v[*b].total_cmp(&self.rms_v[*a]));
        let pair = |line: &usize| (self.frequency_hz(*line), self.rms_v[*line]);
        lines.iter().take(count).map(pair).collect()
    }
}

/// The spectrum of a waveform: all of it, through one window.
///
/// The mean is taken off first, so that a large d.c. voltage does not leak into
/// the first lines. Empty for fewer than two samples.
///
/// # Accuracy
/// A tone on a line: f64 rounding; between lines as [`Window`] says. Tests
/// `a_tone_on_a_line_has_its_rms_value`, `a_tone_between_lines_is_low_by_the_scallop_loss`.
pub fn spectrum(volts: &[f64], sample_rate_hz: f64, window: Window) -> Spectrum {
    let length = volts.len();
    let spacing_hz = sample_rate_hz / length.max(1) as f64;
    if length < 2 {
        return Spectrum {
            spacing_hz,
            window,
            rms_v: Vec::new(),
        };
    }
    let mean = volts.iter().sum::<f64>() / length as f64;
    let weighted = |(index, volt): (usize, &f64)| {
        Complex::new((volt - mean) * window.weight(index, length), 0.0)
    };
    let mut lines: Vec<Complex<f64>> = volts.iter().enumerate().map(weighted).collect();
    FftPlanner::new()
        .plan_fft_forward(length)
        .process(&mut lines);
    // A real tone has half its amplitude at each of two lines: 2/N gives the peak.
    let scale = 2_f64.sqrt() / length as f64;
    let rms_v = lines[..=length / 2].iter().map(|line| line.norm() * scale);
    let mut rms_v: Vec<f64> = rms_v.collect();
    rms_v[0] = mean.abs();
    Spectrum {
        spacing_hz,
        window,
        rms_v,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE_HZ: f64 = 50_000.0;

    fn tone(samples: usize, line: f64, rms_v: f64) -> Vec<f64> {
        let at = |index: usize| (TAU * line * index as f64 / samples as f64 + 0.4).cos();
        let peak_v = 2_f64.sqrt() * rms_v;
        (0..samples)
            .map(|index| 0.25 + peak_v * at(index))
            .collect()
    }

    #[test]
    fn a_tone_on_a_line_has_its_rms_value() {
        for window in [Window::Hann, Window::FlatTop] {
            // 5000 is no power of two.
            for samples in [4096, 5000] {
                let found = spectrum(&tone(samples, 100.0, 0.7), RATE_HZ, window);
                assert_eq!(found.rms_v.len(), samples / 2 + 1);
                assert!((found.rms_v[100] - 0.7).abs() < 1e-12);
                assert!((found.rms_v[0] - 0.25).abs() < 1e-12);
                assert_eq!(found.frequency_hz(100), 100.0 * RATE_HZ / samples as f64);
                // Six lines off nothing is left of either window.
                assert!(found.rms_v[106] < 1e-12);
                let (frequency_hz, rms_v) = found.peaks(1)[0];
                assert_eq!(
                    (frequency_hz, rms_v),
                    (found.frequency_hz(100), found.rms_v[100])
                );
            }
        }
    }

    #[test]
    fn a_tone_between_lines_is_low_by_the_scallop_loss() {
        // Half a line off, the mean of window times exp(j pi n/N): for Hann
        // 8/(3 pi) = 0.8488, for the flat top summed with Python.
        let between = |window| spectrum(&tone(4096, 100.5, 1.0), RATE_HZ, window).rms_v[100];
        let hann = 8.0 / (3.0 * std::f64::consts::PI);
        // The negative line leaks less than (1/200)^3 of the tone to here.
        assert!((between(Window::Hann) - hann).abs() < 1e-6);
        // The flat top ends at -0.0028, not 0: a line 201 off leaks 0.0028/(201 pi).
        assert!((between(Window::FlatTop) - 0.998_967_6).abs() < 5e-6);
    }

    #[test]
    fn noise_stands_as_high_as_its_bandwidth_says() {
        // Shift register noise of +-1, that is 1 V r.m.s., over 16 384 samples.
        let mut register = 1_u32;
        let mut bit = || {
            register = register.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            if register >> 31 == 0 { -1.0 } else { 1.0 }
        };
        let volts: Vec<f64> = (0..16_384).map(|_| bit()).collect();
        for window in [Window::Hann, Window::FlatTop] {
            let found = spectrum(&volts, RATE_HZ, window);
            let lines = &found.rms_v[10..8000];
            let square = lines.iter().map(|v| v * v).sum::<f64>() / lines.len() as f64;
            let wanted = 2.0 * window.noise_bandwidth_lines() / volts.len() as f64;
            // 8000 lines, some four of which belong together: 4 sqrt(4/8000).
            assert!((square / wanted - 1.0).abs() < 0.09, "{square} {wanted}");
        }
        // Harris 1978: 1.5 lines for Hann.
        assert_eq!(Window::Hann.noise_bandwidth_lines(), 1.5);
    }

    #[test]
    fn next_to_nothing_has_no_spectrum() {
        assert!(spectrum(&[], RATE_HZ, Window::Hann).rms_v.is_empty());
        assert!(spectrum(&[1.0], RATE_HZ, Window::Hann).peaks(3).is_empty());
    }
}
