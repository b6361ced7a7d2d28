//! Periodic waveforms: samples over one period and harmonics.

use std::f64::consts::TAU;

use nalgebra::Complex;

/// Highest harmonic that is carried. Nonlinear terms of the exciter act on the motion, which falls
/// by the square of the frequency above resonance: beyond this nothing is left.
pub(super) const HARMONICS: usize = 48;

/// Harmonics of a periodic waveform, peak: `y(t) = Re sum c_h e^{j h w t}`, `c_0` real.
pub(super) type Spectrum = [Complex<f64>; HARMONICS + 1];

/// No waveform.
pub(super) const SILENCE: Spectrum = [Complex::new(0.0, 0.0); HARMONICS + 1];

/// Converts between samples and harmonics on a grid of fixed size.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    /// `e^{j 2 pi k / n}`.
    turns: Vec<Complex<f64>>,
}

impl Grid {
    /// A grid of `size` samples per period, above twice [`HARMONICS`].
    pub(super) fn new(size: usize) -> Self {
        let turn = |index| Complex::from_polar(1.0, TAU * index as f64 / size as f64);
        Self {
            turns: (0..size).map(turn).collect(),
        }
    }

    /// Samples per period.
    pub(super) fn size(&self) -> usize {
        self.turns.len()
    }

    /// Samples of a waveform over one period.
    pub(super) fn samples(&self, spectrum: &Spectrum) -> Vec<f64> {
        let mut samples = vec![spectrum[0].re; self.size()];
        for (order, &amplitude) in spectrum.iter().enumerate().skip(1) {
            if amplitude == Complex::new(0.0, 0.0) {
                continue;
            }
            let mut position = 0;
            for sample in &mut samples {
                let turn = self.turns[position];
                *sample += amplitude.re * turn.re - amplitude.im * turn.im;
                position += order;
                position -= if position >= self.size() {
                    self.size()
                } else {
                    0
                };
            }
        }
        samples
    }

    /// Harmonics up to `highest` of a waveform; those above are zero.
    pub(super) fn spectrum(&self, samples: &[f64], highest: usize) -> Spectrum {
        let mut spectrum = SILENCE;
        let count = self.size() as f64;
        spectrum[0].re = samples.iter().sum::<f64>() / count;
        for (order, amplitude) in spectrum.iter_mut().enumerate().take(highest + 1).skip(1) {
            let (mut real, mut imaginary) = (0.0, 0.0);
            let mut position = 0;
            for sample in samples {
                let turn = self.turns[position];
                real += sample * turn.re;
                imaginary -= sample * turn.im;
                position += order;
                position -= if position >= self.size() {
                    self.size()
                } else {
                    0
                };
            }
            *amplitude = Complex::new(real, imaginary) * (2.0 / count);
        }
        spectrum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_and_harmonics_are_inverse() {
        let grid = Grid::new(256);
        let mut spectrum = SILENCE;
        spectrum[0].re = 0.3;
        for (order, value) in spectrum.iter_mut().enumerate().skip(1) {
            *value = Complex::from_polar(1.0 / order as f64, order as f64);
        }
        let back = grid.spectrum(&grid.samples(&spectrum), HARMONICS);
        for (got, want) in back.iter().zip(&spectrum) {
            assert!((got - want).norm() < 1e-12);
        }
    }

    #[test]
    fn a_square_wave_has_odd_harmonics_of_four_over_pi_n() {
        let grid = Grid::new(4096);
        let square: Vec<f64> = grid
            .turns
            .iter()
            .map(|turn| if turn.re > 0.0 { 1.0 } else { -1.0 })
            .collect();
        let spectrum = grid.spectrum(&square, 5);
        for (order, sign) in [(1, 1.0), (3, -1.0), (5, 1.0)] {
            let expected = sign * 4.0 / (std::f64::consts::PI * f64::from(order));
            // The edges lie within half a sample of where they belong.
            assert!((spectrum[order as usize].re - expected).abs() < 2.0 / 4096.0);
        }
        assert!(spectrum[2].norm() < 2.0 / 4096.0);
    }
}
