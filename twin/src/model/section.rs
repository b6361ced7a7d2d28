//! Linear elements of a measuring chain, each with its response in frequency.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

/// A second-order section `(n0 + n1 p + n2 p^2) / (1 + p/Q + p^2)` with `p = s / w0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SecondOrder {
    /// Corner frequency `w0 / 2 pi`, Hz, positive.
    pub corner_hz: f64,
    /// Quality factor Q, positive.
    pub quality_factor: f64,
    /// Numerator `n0, n1, n2`, dimensionless.
    pub numerator: [f64; 3],
}

impl SecondOrder {
    /// A resonator or low-pass: `1 / (1 + p/Q + p^2)`.
    pub fn low_pass(corner_hz: f64, quality_factor: f64) -> Self {
        Self {
            corner_hz,
            quality_factor,
            numerator: [1.0, 0.0, 0.0],
        }
    }

    /// A high-pass: `p^2 / (1 + p/Q + p^2)`.
    pub fn high_pass(corner_hz: f64, quality_factor: f64) -> Self {
        Self {
            corner_hz,
            quality_factor,
            numerator: [0.0, 0.0, 1.0],
        }
    }

    fn response(&self, frequency_hz: f64) -> Complex<f64> {
        let p = Complex::new(0.0, frequency_hz / self.corner_hz);
        let [n0, n1, n2] = self.numerator;
        (p * p * n2 + p * n1 + n0) / (p * p + p / self.quality_factor + 1.0)
    }
}

/// Lowest pole of a ladder, Hz, and poles to a decade; it ends above 1e7 Hz.
const LADDER_LOWEST_HZ: f64 = 1e-4;
const LADDER_PER_DECADE: f64 = 2.0;
/// Sections of a ladder, of two poles each.
const LADDER_SECTIONS: i32 = 12;

/// One linear element.
///
/// Some responses of the field's first-order formulas are real although they depend on frequency;
/// no causal element has such a response. In steady state they are taken as written; how the plant
/// in time realises them is said at each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Section {
    /// Resonance, second-order filter, rocking or axial mode.
    SecondOrder(SecondOrder),
    /// First-order high-pass, corner in Hz.
    HighPass(f64),
    /// First-order low-pass, corner in Hz.
    LowPass(f64),
    /// Pure delay, s; negative is an advance.
    Delay(f64),
    /// Mean over the past, window in s: `sinc(f T) e^{-j pi f T}`.
    Average(f64),
    /// `1 - k f^2`, k in 1/Hz2. In time: with a second derivative.
    InverseSquare(f64),
    /// `1 + g / f^2`, g in Hz2. In time: from the travel.
    Tilt(f64),
    /// `1 + gain / (1 + (f/corner)^2)`. In time: two first-order low-passes in series, whose
    /// magnitude is the same.
    Strain {
        /// Gain far below the corner.
        gain: f64,
        /// Corner, Hz.
        corner_hz: f64,
    },
    /// `1 - slope lg(f / reference)`. In time: a relaxation spectrum with the same magnitude and
    /// the loss angle causality demands, `-pi/2 slope / ln 10`.
    Slope {
        /// Fall per decade.
        per_decade: f64,
        /// Frequency where the response is 1, Hz.
        reference_hz: f64,
    },
    /// `1 + j f k + c`: capacitive and resistive coupling. In time: without the imaginary part
    /// of `c`.
    Coupling {
        /// k, s.
        inverse_fx_s: f64,
        /// Real part of c.
        in_phase: f64,
        /// Imaginary part of c.
        quadrature: f64,
    },
}

impl Section {
    /// Response at `frequency_hz`, which is positive.
    pub fn response(&self, frequency_hz: f64) -> Complex<f64> {
        let imaginary = |value| Complex::new(0.0, value);
        let real = |value| Complex::new(value, 0.0);
        match *self {
            Self::SecondOrder(section) => section.response(frequency_hz),
            Self::HighPass(corner_hz) => {
                let p = imaginary(frequency_hz / corner_hz);
                p / (p + 1.0)
            }
            Self::LowPass(corner_hz) => 1.0 / (imaginary(frequency_hz / corner_hz) + 1.0),
            Self::Delay(delay_s) => Complex::from_polar(1.0, -TAU * frequency_hz * delay_s),
            Self::Average(window_s) => {
                let angle = PI * frequency_hz * window_s;
                let sinc = if angle == 0.0 {
                    1.0
                } else {
                    angle.sin() / angle
                };
                Complex::from_polar(1.0, -angle) * sinc
            }
            Self::InverseSquare(per_hz2) => real(1.0 - per_hz2 * frequency_hz * frequency_hz),
            Self::Tilt(hz2) => real(1.0 + hz2 / (frequency_hz * frequency_hz)),
            Self::Strain { gain, corner_hz } => {
                let q = frequency_hz / corner_hz;
                real(1.0 + gain / (1.0 + q * q))
            }
            Self::Slope {
                per_decade,
                reference_hz,
            } => real(1.0 - per_decade * (frequency_hz / reference_hz).log10()),
            Self::Coupling {
                inverse_fx_s,
                in_phase,
                quadrature,
            } => Complex::new(1.0 + in_phase, frequency_hz * inverse_fx_s + quadrature),
        }
    }

    /// A ladder of real poles, each with a zero a little above it, whose response falls with the power
    /// `exponent` of the frequency and lags by as many right angles, and is 1 at `reference_hz`.
    ///
    /// # Accuracy
    /// 3e-3 of the exponent from 1 Hz to 20 kHz: test `a_ladder_falls_with_a_power_of_the_frequency`.
    pub fn power_law(exponent: f64, reference_hz: f64) -> Vec<Self> {
        let ratio = 10.0_f64.powf(1.0 / LADDER_PER_DECADE);
        let apart = ratio.powf(exponent);
        let pair = |at: i32| {
            let pole_hz = LADDER_LOWEST_HZ * ratio.powi(at);
            [pole_hz, pole_hz * ratio]
        };
        let section = |at: i32| {
            let [first_hz, second_hz] = pair(2 * at);
            let corner_hz = (first_hz * second_hz).sqrt();
            let sum = corner_hz / first_hz + corner_hz / second_hz;
            SecondOrder {
                corner_hz,
                quality_factor: 1.0 / sum,
                numerator: [1.0, sum / apart, 1.0 / (apart * apart)],
            }
        };
        let mut sections: Vec<SecondOrder> = (0..LADDER_SECTIONS).map(section).collect();
        for section in &mut sections {
            let gain = 1.0 / section.response(reference_hz).norm();
            section.numerator = section.numerator.map(|n| n * gain);
        }
        sections.into_iter().map(Self::SecondOrder).collect()
    }

    /// Response of a chain of sections.
    pub fn chain(sections: &[Self], frequency_hz: f64) -> Complex<f64> {
        sections
            .iter()
            .map(|section| section.response(frequency_hz))
            .product()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(got: Complex<f64>, real: f64, imaginary: f64) {
        assert!(
            (got - Complex::new(real, imaginary)).norm() < 1e-12,
            "{got}"
        );
    }

    /// The lattice of poles is even in the logarithm, h = ln(10^0.5) apart; beside the power it has a
    /// ripple of 2 pi exp(-pi^2/h) = 1.2e-3 of the exponent, in size (twice, against the reference) and
    /// phase, and lacks what the ends lack, the frequency over the last pole: 6e-4.
    #[test]
    fn a_ladder_falls_with_a_power_of_the_frequency() {
        for exponent in [0.002, 0.02, 0.1] {
            let ladder = Section::power_law(exponent, 160.0);
            for frequency_hz in [1.0, 5.0, 160.0, 2e3, 2e4] {
                let got = Section::chain(&ladder, frequency_hz).ln();
                let fall = -exponent * (frequency_hz / 160.0_f64).ln();
                let lag = -exponent * PI / 2.0;
                let error = (got - Complex::new(fall, lag)).norm();
                assert!(
                    error < 3e-3 * exponent,
                    "{exponent} {frequency_hz}: {error}"
                );
            }
        }
    }

    #[test]
    fn sections_at_frequencies_where_the_result_is_known() {
        // At resonance a resonator is Q times the input, 90 degrees behind.
        close(
            Section::SecondOrder(SecondOrder::low_pass(100.0, 7.0)).response(100.0),
            0.0,
            -7.0,
        );
        close(Section::HighPass(5.0).response(5.0), 0.5, 0.5);
        // A mass on a spring moves against its base: at resonance Q times, 90 degrees ahead.
        close(
            Section::SecondOrder(SecondOrder::high_pass(100.0, 7.0)).response(100.0),
            0.0,
            7.0,
        );
        close(Section::LowPass(5.0).response(5.0), 0.5, -0.5);
        // A quarter period late is -j; a mean over a whole period is nothing, over half 2/pi.
        close(Section::Delay(0.25).response(1.0), 0.0, -1.0);
        close(Section::Average(1.0).response(1.0), 0.0, 0.0);
        close(Section::Average(0.5).response(1.0), 0.0, -2.0 / PI);
        close(Section::InverseSquare(1e-4).response(10.0), 0.99, 0.0);
        close(Section::Tilt(0.5).response(10.0), 1.005, 0.0);
        let strain = Section::Strain {
            gain: 0.02,
            corner_hz: 30.0,
        };
        close(strain.response(30.0), 1.01, 0.0);
        let slope = Section::Slope {
            per_decade: 0.02,
            reference_hz: 160.0,
        };
        close(slope.response(16.0), 1.02, 0.0);
        let coupling = Section::Coupling {
            inverse_fx_s: 1e-3,
            in_phase: 0.1,
            quadrature: 0.2,
        };
        close(coupling.response(100.0), 1.1, 0.3);
        close(
            Section::chain(&[strain, slope], 30.0),
            1.01 * slope.response(30.0).re,
            0.0,
        );
    }
}
