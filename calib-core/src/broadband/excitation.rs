//! One period of a broadband signal, by an inverse Fourier transform.

use super::{LINES, RECORD_SAMPLES};
use crate::phase::cos_sin;
use microfft::complex::cfft_4096;
use num_complex::Complex32;
use serde::{Deserialize, Serialize};

/// How the phases of the lines are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Phases {
    /// Schroeder's: the signal sweeps, its crest factor stays near 1.7.
    Multisine,
    /// Drawn anew from this seed: noise that repeats with the record. Another
    /// seed for each average gives periodic random excitation.
    Random {
        /// Any number.
        seed: u32,
    },
}

/// Lines of equal amplitude from `first` to `last`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Excitation {
    /// Lowest line, at least 1.
    pub first: usize,
    /// Highest line, below [`LINES`].
    pub last: usize,
    /// Phases of the lines.
    pub phases: Phases,
}

impl Excitation {
    /// Fills `period` with one period of magnitude up to 1, as real parts;
    /// imaginary parts are rounding errors. A multisine reaches 1; noise has
    /// the same r.m.s. value for every seed, [`NOISE_CREST`] below 1, and is cut
    /// off where it is higher.
    ///
    /// Returns the r.m.s. value of the signal, or `None` when the lines are
    /// out of order or out of range.
    pub fn fill(self, period: &mut [Complex32; RECORD_SAMPLES]) -> Option<f32> {
        if self.first == 0 || self.last < self.first || self.last >= LINES {
            return None;
        }
        period.fill(Complex32::new(0.0, 0.0));
        let mut random = self.seed();
        let count = (self.last - self.first + 1) as u32;
        let lines = period.iter_mut().enumerate().skip(self.first);
        for ((_, value), index) in lines.take(count as usize).zip(0_u32..) {
            let (cosine, sine) = match self.phases {
                Phases::Multisine => schroeder(index, count),
                Phases::Random { .. } => cos_sin(next(&mut random) >> 8, 1 << 24),
            };
            *value = Complex32::new(cosine, sine);
        }
        // A forward transform of the lines: the sum of exp(-j ...), whose real
        // part is a sum of cosines with the phases negated.
        let period = cfft_4096(period);
        Some(match self.phases {
            Phases::Multisine => scale_to_peak(period),
            Phases::Random { .. } => scale_to_rms(period),
        })
    }

    fn seed(self) -> u32 {
        match self.phases {
            Phases::Multisine => 1,
            Phases::Random { seed } => seed | 1,
        }
    }
}

/// `-pi index^2 / count`, reduced to a turn in integers.
fn schroeder(index: u32, count: u32) -> (f32, f32) {
    let turn = 2 * count;
    let (cosine, sine) = cos_sin((index * index) % turn, turn);
    (cosine, -sine)
}

/// Marsaglia's xorshift, 32 bits.
fn next(state: &mut u32) -> u32 {
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    *state
}

/// Full range over r.m.s. value of noise: one record in 35 exceeds it.
pub const NOISE_CREST: f32 = 4.5;

fn rms(period: &[Complex32; RECORD_SAMPLES]) -> f32 {
    let square: f32 = period.iter().map(|v| v.re * v.re).sum();
    libm::sqrtf(square / RECORD_SAMPLES as f32)
}

/// Scales the real parts to a largest magnitude of 1; returns their r.m.s.
fn scale_to_peak(period: &mut [Complex32; RECORD_SAMPLES]) -> f32 {
    let peak = period.iter().fold(0.0_f32, |peak, v| peak.max(v.re.abs()));
    period.iter_mut().for_each(|value| value.re /= peak);
    rms(period)
}

/// Scales the real parts to the r.m.s. value of noise; returns it.
fn scale_to_rms(period: &mut [Complex32; RECORD_SAMPLES]) -> f32 {
    let factor = 1.0 / (NOISE_CREST * rms(period));
    for value in period.iter_mut() {
        value.re = (value.re * factor).clamp(-1.0, 1.0);
    }
    rms(period)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn period(excitation: Excitation) -> (Vec<f64>, f32) {
        let mut buffer = Box::new([Complex32::new(0.0, 0.0); RECORD_SAMPLES]);
        let rms = excitation.fill(&mut buffer).expect("lines in range");
        (buffer.iter().map(|v| f64::from(v.re)).collect(), rms)
    }

    /// Amplitude of one line by direct correlation in f64.
    fn line(signal: &[f64], line: usize) -> f64 {
        let (mut re, mut im) = (0.0, 0.0);
        for (n, value) in signal.iter().enumerate() {
            let place = (line * n) % RECORD_SAMPLES;
            let angle = std::f64::consts::TAU * place as f64 / RECORD_SAMPLES as f64;
            re += value * angle.cos();
            im += value * angle.sin();
        }
        2.0 * re.hypot(im) / RECORD_SAMPLES as f64
    }

    #[test]
    fn exactly_the_lines_asked_for_are_there() {
        for phases in [Phases::Multisine, Phases::Random { seed: 42 }] {
            let excitation = Excitation {
                first: 3,
                last: 820,
                phases,
            };
            let (signal, rms) = period(excitation);
            // 818 equal lines: rms^2 = 818 a^2 / 2.
            let expected = f64::from(rms) * (2.0 / 818.0_f64).sqrt();
            for inside in [3, 4, 100, 819, 820] {
                assert!(
                    (line(&signal, inside) / expected - 1.0).abs() < 1.0e-4,
                    "{inside}"
                );
            }
            for outside in [0, 1, 2, 821, 1500, 2047] {
                assert!(
                    line(&signal, outside) < 1.0e-5 * expected.sqrt(),
                    "{outside}"
                );
            }
            let peak = signal.iter().fold(0.0_f64, |peak, v| peak.max(v.abs()));
            let expected = match phases {
                Phases::Multisine => 1.0..1.000_001,
                Phases::Random { .. } => 0.6..1.000_001,
            };
            assert!(expected.contains(&peak), "{peak}");
        }
    }

    #[test]
    fn a_multisine_wastes_less_range_than_noise() {
        let crest = |phases| {
            let (_, rms) = period(Excitation {
                first: 3,
                last: 820,
                phases,
            });
            1.0 / rms
        };
        // Schroeder phases of a flat band give 1.7.
        assert!(crest(Phases::Multisine) < 1.9);
        // Every noise alike, but for what is cut off.
        for seed in 0..40 {
            let noise = crest(Phases::Random { seed });
            assert!((noise / NOISE_CREST - 1.0).abs() < 1.0e-3, "{noise}");
        }
    }

    #[test]
    fn impossible_bands_are_refused() {
        let mut buffer = Box::new([Complex32::new(0.0, 0.0); RECORD_SAMPLES]);
        for (first, last) in [(0, 5), (6, 5), (5, LINES)] {
            let excitation = Excitation {
                first,
                last,
                phases: Phases::Multisine,
            };
            assert_eq!(excitation.fill(&mut buffer), None);
        }
    }
}
