//! A sample that is the mean of several conversions.
//!
//! Converters that convert several times at each trigger, and hand over the mean, have less noise and
//! pass less of high frequencies. Both channels alike: sensitivity and phase do not change, but the
//! acceleration must be corrected.

use core::f32::consts::PI;

/// The conversions of which a sample is the mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aperture {
    /// Conversions of a sample, at least 1.
    pub conversions: u16,
    /// From one to the next, s.
    pub apart_s: f32,
}

impl Aperture {
    /// One conversion.
    pub const POINT: Self = Self {
        conversions: 1,
        apart_s: 0.0,
    };

    /// Amplitude of the mean over that of the signal at `frequency_hz`, 0 to 1.
    ///
    /// # Equation
    /// `|sum exp(j 2 pi f n T)| / N = |sin(N x) / (N sin x)|`, `x = pi f T`: a geometric sum.
    pub fn gain(&self, frequency_hz: f32) -> f32 {
        let angle_rad = PI * frequency_hz * self.apart_s;
        let count = f32::from(self.conversions.max(1));
        let one = libm::sinf(angle_rad);
        if one == 0.0 {
            return 1.0;
        }
        (libm::sinf(count * angle_rad) / (count * one)).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gain_is_that_of_the_sum_in_f64() {
        for conversions in [1_u16, 2, 16] {
            let aperture = Aperture {
                conversions,
                apart_s: 25.0 / 30.0e6,
            };
            for frequency_hz in [20.0, 160.0, 5_000.0, 10_000.0] {
                let angle = core::f64::consts::TAU * f64::from(frequency_hz) * 25.0 / 30.0e6;
                let (mut re, mut im) = (0.0, 0.0);
                for nth in 0..conversions {
                    re += (f64::from(nth) * angle).cos();
                    im += (f64::from(nth) * angle).sin();
                }
                let want = f64::hypot(re, im) / f64::from(conversions);
                let error = f64::from(aperture.gain(frequency_hz)) / want - 1.0;
                // Some roundings of f32.
                assert!(
                    error.abs() < 1.0e-6,
                    "{conversions} {frequency_hz}: {error}"
                );
            }
        }
        assert_eq!(Aperture::POINT.gain(10_000.0), 1.0);
    }

    /// 8 conversions in 6.7 us take 0.7 % at 10 kHz: x = 0.02618, ((8 x)^2 - x^2) / 6.
    #[test]
    fn eight_conversions_take_less_than_a_percent_at_ten_kilohertz() {
        let aperture = Aperture {
            conversions: 8,
            apart_s: 25.0 / 30.0e6,
        };
        assert!((aperture.gain(10_000.0) - 0.992_8).abs() < 1.0e-4);
    }
}
