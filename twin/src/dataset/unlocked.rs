//! Tones that are not locked to the block: what of them a block shows.

use std::f64::consts::{PI, SQRT_2};

use nalgebra::Complex;

/// A tone over one block.
#[derive(Clone, Copy, Debug)]
pub(super) struct UnlockedTone {
    /// Amplitude, r.m.s.
    pub(super) rms: f64,
    /// Frequency, Hz.
    pub(super) frequency_hz: f64,
    /// Phase at the start of the block, rad.
    pub(super) phase_rad: f64,
}

impl UnlockedTone {
    /// Component that a correlation over `block_s` finds at `frequency_hz`, peak.
    ///
    /// # Equation
    /// `2/T Integral sqrt(2) A cos(w0 t + p) e^{-j w t} dt`, its two exponentials each giving
    /// `sinc(df T) e^{j pi df T}`.
    pub(super) fn leaked(&self, frequency_hz: f64, block_s: f64) -> Complex<f64> {
        let kernel = |difference_hz: f64| {
            let angle = PI * difference_hz * block_s;
            let sinc = if angle == 0.0 {
                1.0
            } else {
                angle.sin() / angle
            };
            Complex::from_polar(1.0, angle) * sinc
        };
        let turn = Complex::from_polar(SQRT_2 * self.rms, self.phase_rad);
        turn * kernel(self.frequency_hz - frequency_hz)
            + turn.conj() * kernel(-self.frequency_hz - frequency_hz)
    }

    /// Mean a block finds.
    pub(super) fn mean(&self, block_s: f64) -> f64 {
        self.leaked(0.0, block_s).re / 2.0
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn leakage_is_that_of_a_sum_over_samples() {
        let tone = UnlockedTone {
            rms: 0.7,
            frequency_hz: 50.0,
            phase_rad: 1.1,
        };
        let (rate_hz, count) = (51_200.0, 16_384);
        let block_s = f64::from(count) / rate_hz;
        for frequency_hz in [0.0, 5.0, 49.0, 50.0, 52.0, 160.0] {
            let mut sum = Complex::new(0.0, 0.0);
            for index in 0..count {
                // Samples stand for the middle of their interval.
                let time_s = (f64::from(index) + 0.5) / rate_hz;
                let value = SQRT_2 * 0.7 * (TAU * 50.0 * time_s + 1.1).cos();
                sum += Complex::from_polar(
                    value * 2.0 / f64::from(count),
                    -TAU * frequency_hz * time_s,
                );
            }
            // The midpoint rule over 1024 samples per period: (pi/1024)^2/6 of the amplitude.
            assert!(
                (tone.leaked(frequency_hz, block_s) - sum).norm() < 2e-6,
                "{frequency_hz}"
            );
        }
    }
}
