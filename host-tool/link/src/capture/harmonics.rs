//! Components of a waveform of known frequency.

use nalgebra::{DMatrix, DVector, Dyn, linalg::Cholesky};
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Highest harmonic that is fitted.
pub const HIGHEST_ORDER: u8 = 5;

/// A harmonic beside its fundamental.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Harmonic {
    /// Its number; 2 is the octave of the fundamental.
    pub order: u8,
    /// Amplitude over that of the fundamental, 1.
    pub amplitude_rel: f64,
    /// Phase minus `order` times the phase of the fundamental, in (-pi, pi] rad.
    #[schemars(description = "Phase minus `order` times the phase of the fundamental, degrees.")]
    #[serde(
        rename = "phase_deg",
        serialize_with = "calib_output::number::rad_as_deg"
    )]
    pub phase_rad: f64,
    /// Standard uncertainty of the real and of the imaginary part of the relative
    /// harmonic, 1, as far as the noise of this waveform goes.
    pub standard_uncertainty_rel: f64,
}

/// Mean, fundamental, harmonics and rest of a waveform.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ToneFit {
    /// Frequency of the fundamental, Hz, as given.
    pub frequency_hz: f64,
    /// Mean, V.
    pub dc_v: f64,
    /// Its standard uncertainty, V.
    pub standard_uncertainty_dc_v: f64,
    /// Fundamental, V r.m.s.
    pub rms_v: f64,
    /// Its standard uncertainty, V r.m.s.
    pub standard_uncertainty_rms_v: f64,
    /// Phase of the fundamental as `A cos(2 pi f t + phase)`, t from the first
    /// sample on, in (-pi, pi] rad.
    #[schemars(
        description = "Phase of the fundamental as a cosine, t from the first sample on, degrees."
    )]
    #[serde(
        rename = "phase_deg",
        serialize_with = "calib_output::number::rad_as_deg"
    )]
    pub phase_rad: f64,
    /// Its standard uncertainty, rad.
    #[schemars(description = "Standard uncertainty of the phase, degrees.")]
    #[serde(
        rename = "standard_uncertainty_phase_deg",
        serialize_with = "calib_output::number::rad_as_deg"
    )]
    pub standard_uncertainty_phase_rad: f64,
    /// Harmonics 2 to 5 that lie below half the sample rate.
    pub harmonics: Vec<Harmonic>,
    /// Residual, V r.m.s.
    pub noise_rms_v: f64,
}

impl ToneFit {
    /// Total harmonic distortion: the root sum of squares of the relative
    /// harmonics that were fitted.
    pub fn distortion_rel(&self) -> f64 {
        let squares = self.harmonics.iter().map(|h| h.amplitude_rel.powi(2));
        squares.sum::<f64>().sqrt()
    }

    /// Fundamental over noise, dB, in the whole band up to half the sample rate;
    /// infinite without noise.
    pub fn signal_to_noise_db(&self) -> f64 {
        20.0 * (self.rms_v / self.noise_rms_v).log10()
    }

    /// Phase of the fundamental minus that of another channel of the same
    /// capture, rad in (-pi, pi].
    pub fn phase_after(&self, reference: &Self) -> f64 {
        wrapped(self.phase_rad - reference.phase_rad)
    }
}

/// Why a waveform cannot be taken apart.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum FitError {
    /// The frequency is not above 0, or too close to half the sample rate.
    #[error(
        "{frequency_hz} Hz cannot be told from its image: the sample rate is {sample_rate_hz} Hz"
    )]
    Frequency {
        /// Frequency asked for, Hz.
        frequency_hz: f64,
        /// Sample rate, Hz.
        sample_rate_hz: f64,
    },
    /// Less than a cycle, or fewer samples than are needed.
    #[error("{samples} samples are too few for {frequency_hz} Hz: one cycle at least")]
    TooShort {
        /// Samples there are.
        samples: usize,
        /// Frequency asked for, Hz.
        frequency_hz: f64,
    },
    /// A sample is not a number.
    #[error("sample {0} is not a finite number")]
    NotFinite(usize),
}

/// Takes a waveform apart into its mean, the tone of `frequency_hz`, harmonics 2
/// to 5 of it as far as they lie below half the sample rate, and the rest.
///
/// `frequency_hz` must be the exact one
/// ([`tone_frequency_hz`](super::tone_frequency_hz)): a deviation of d Hz leaves
/// up to `pi d T` of the amplitude in the rest, T the length.
///
/// # Equation
/// Least squares of `y(t) = c + sum_n a_n cos(2 pi n f t) + b_n sin(2 pi n f t)`
/// on all samples; no whole number of cycles is needed. The covariance is
/// `s^2 (X' X)^-1` with `s^2` the sum of squares of the rest over the degrees of
/// freedom, which holds for a rest that is white noise.
///
/// # Errors
/// [`FitError`].
///
/// # Accuracy
/// Tests `a_known_waveform_is_taken_apart`,
/// `estimates_scatter_as_their_uncertainties_say`.
///
/// # Source
/// GUM (JCGM 100:2008) H.3 for the covariance of a least-squares fit.
pub fn fit(volts: &[f64], sample_rate_hz: f64, frequency_hz: f64) -> Result<ToneFit, FitError> {
    let orders = orders(volts, sample_rate_hz, frequency_hz)?;
    let design = Design {
        angle_rad: TAU * frequency_hz / sample_rate_hz,
        orders,
    };
    let (normal, right) = design.normal_equations(volts);
    // Distinct frequencies below half the sample rate over a cycle or more:
    // the columns are independent.
    let factor = Cholesky::new(normal).ok_or(FitError::TooShort {
        samples: volts.len(),
        frequency_hz,
    })?;
    let solution = factor.solve(&right);
    let squares = design.sum_of_squares_left(volts, &solution);
    let variance = squares / (volts.len() - design.columns()) as f64;
    Ok(design.describe(frequency_hz, &solution, &factor, variance))
}

/// Number of the highest harmonic that can be fitted.
fn orders(volts: &[f64], sample_rate_hz: f64, frequency_hz: f64) -> Result<u8, FitError> {
    let samples = volts.len();
    if let Some(at) = volts.iter().position(|volt| !volt.is_finite()) {
        return Err(FitError::NotFinite(at));
    }
    let cycles = frequency_hz * samples as f64 / sample_rate_hz;
    // A line of the record below half the sample rate, sine and cosine are two.
    let fits = |order: &u8| f64::from(*order) * cycles <= 0.5 * samples as f64 - 1.0;
    if !(frequency_hz > 0.0 && sample_rate_hz.is_finite() && fits(&1)) {
        return Err(FitError::Frequency {
            frequency_hz,
            sample_rate_hz,
        });
    }
    let orders = (1..=HIGHEST_ORDER).take_while(fits).last().unwrap_or(1);
    if cycles < 1.0 || samples < 2 * (1 + 2 * usize::from(orders)) {
        return Err(FitError::TooShort {
            samples,
            frequency_hz,
        });
    }
    Ok(orders)
}

/// The columns 1, cos, sin, cos 2, sin 2, ...
struct Design {
    /// Angle of the fundamental per sample, rad.
    angle_rad: f64,
    orders: u8,
}

impl Design {
    fn columns(&self) -> usize {
        1 + 2 * usize::from(self.orders)
    }

    /// The row of sample `index`.
    fn row(&self, index: usize) -> [f64; 1 + 2 * HIGHEST_ORDER as usize] {
        let mut row = [1.0; 1 + 2 * HIGHEST_ORDER as usize];
        // The angle within its cycle first: large angles lose digits.
        let cycles = self.angle_rad / TAU * index as f64;
        let angle_rad = TAU * cycles.fract();
        for (order, pair) in (1_u8..).zip(row[1..].as_chunks_mut::<2>().0) {
            let (sin, cos) = (f64::from(order) * angle_rad).sin_cos();
            *pair = [cos, sin];
        }
        row
    }

    /// `X' X` and `X' y`.
    fn normal_equations(&self, volts: &[f64]) -> (DMatrix<f64>, DVector<f64>) {
        let columns = self.columns();
        let mut normal = DMatrix::zeros(columns, columns);
        let mut right = DVector::zeros(columns);
        for (index, volt) in volts.iter().enumerate() {
            let row = self.row(index);
            for i in 0..columns {
                right[i] += row[i] * volt;
                for j in 0..=i {
                    normal[(i, j)] += row[i] * row[j];
                }
            }
        }
        normal.fill_upper_triangle_with_lower_triangle();
        (normal, right)
    }

    fn sum_of_squares_left(&self, volts: &[f64], solution: &DVector<f64>) -> f64 {
        let left = |(index, volt): (usize, &f64)| {
            let row = self.row(index);
            let parts = solution.iter().zip(row).map(|(factor, x)| factor * x);
            volt - parts.sum::<f64>()
        };
        let squares = volts.iter().enumerate().map(left).map(|rest| rest * rest);
        squares.sum()
    }

    fn describe(
        &self,
        frequency_hz: f64,
        solution: &DVector<f64>,
        factor: &Cholesky<f64, Dyn>,
        variance: f64,
    ) -> ToneFit {
        let covariance = factor.inverse() * variance;
        // Root mean variance of a component's two parts.
        let spread = |order: u8| {
            let at = 2 * usize::from(order) - 1;
            (0.5 * (covariance[(at, at)] + covariance[(at + 1, at + 1)])).sqrt()
        };
        let (amplitude_v, phase_rad) = component(solution, 1);
        let harmonic = |order: u8| {
            let (of_v, of_rad) = component(solution, order);
            Harmonic {
                order,
                amplitude_rel: of_v / amplitude_v,
                phase_rad: wrapped(of_rad - f64::from(order) * phase_rad),
                standard_uncertainty_rel: spread(order) / amplitude_v,
            }
        };
        ToneFit {
            frequency_hz,
            dc_v: solution[0],
            standard_uncertainty_dc_v: covariance[(0, 0)].sqrt(),
            rms_v: amplitude_v / 2_f64.sqrt(),
            standard_uncertainty_rms_v: spread(1) / 2_f64.sqrt(),
            phase_rad,
            standard_uncertainty_phase_rad: spread(1) / amplitude_v,
            harmonics: (2..=self.orders).map(harmonic).collect(),
            noise_rms_v: variance.sqrt(),
        }
    }
}

/// Amplitude (peak) and phase of component `order`: `a cos + b sin` is
/// `A cos(. + phase)` with `a = A cos(phase)`, `b = -A sin(phase)`.
fn component(solution: &DVector<f64>, order: u8) -> (f64, f64) {
    let at = 2 * usize::from(order) - 1;
    let (a, b) = (solution[at], solution[at + 1]);
    (a.hypot(b), (-b).atan2(a))
}

/// Angle reduced to (-pi, pi].
fn wrapped(angle_rad: f64) -> f64 {
    let turned = angle_rad.rem_euclid(TAU);
    if turned > PI { turned - TAU } else { turned }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::{Rng, SeedableRng};

    const RATE_HZ: f64 = 50_000.0;

    /// Mean, then (peak amplitude, phase) of fundamental and harmonics.
    fn waveform(
        samples: usize,
        frequency_hz: f64,
        dc_v: f64,
        components: &[(f64, f64)],
    ) -> Vec<f64> {
        let at = |index: usize| {
            let turn_rad = TAU * (frequency_hz * index as f64 / RATE_HZ);
            let parts = (1..).zip(components);
            let parts = parts.map(|(order, (amplitude_v, phase_rad))| {
                amplitude_v * (f64::from(order) * turn_rad + phase_rad).cos()
            });
            dc_v + parts.sum::<f64>()
        };
        (0..samples).map(at).collect()
    }

    /// Independent numbers of mean 0 and standard deviation 1: sums of twelve
    /// even ones, each of variance 1/12.
    fn noise(generator: &mut ChaCha8Rng) -> f64 {
        let even = |generator: &mut ChaCha8Rng| f64::from(generator.next_u32()) / 2_f64.powi(32);
        (0..12).map(|_| even(generator)).sum::<f64>() - 6.0
    }

    #[test]
    fn a_known_waveform_is_taken_apart() {
        let components = [
            (1.5, 0.7),
            (0.03, -2.0),
            (0.01, 3.0),
            (0.002, 0.1),
            (1e-3, -0.4),
        ];
        // 11.8 cycles: no whole number, so nothing is orthogonal by chance.
        let volts = waveform(3689, 160.0, -0.2, &components);
        let found = fit(&volts, RATE_HZ, 160.0).expect("fits");
        // Rounding: 1e-16 each of some thousand sums, times a condition below 2.
        let near = |value: f64, wanted: f64| assert!((value - wanted).abs() < 1e-11, "{value}");
        near(found.dc_v, -0.2);
        near(found.rms_v, 1.5 / 2_f64.sqrt());
        near(found.phase_rad, 0.7);
        assert_eq!(found.harmonics.len(), 4);
        for (harmonic, (amplitude_v, phase_rad)) in found.harmonics.iter().zip(&components[1..]) {
            near(harmonic.amplitude_rel, amplitude_v / 1.5);
            let relative_rad = phase_rad - f64::from(harmonic.order) * 0.7;
            // A phase is worth what its amplitude is.
            near(
                wrapped(harmonic.phase_rad - relative_rad) * amplitude_v,
                0.0,
            );
        }
        near(found.noise_rms_v, 0.0);
        let squares = components[1..].iter().map(|(a, _)| (a / 1.5).powi(2));
        near(found.distortion_rel(), squares.sum::<f64>().sqrt());
    }

    #[test]
    fn estimates_scatter_as_their_uncertainties_say() {
        let mut generator = ChaCha8Rng::seed_from_u64(5);
        let components = [(1.0, 0.3), (0.02, 1.0)];
        let clean = waveform(2000, 130.0, 0.1, &components);
        let (runs, noise_rms_v) = (200, 0.05);
        let mut sums = [0.0; 5];
        for _ in 0..runs {
            let noisy = |volt: &f64| volt + noise_rms_v * noise(&mut generator);
            let volts: Vec<f64> = clean.iter().map(noisy).collect();
            let found = fit(&volts, RATE_HZ, 130.0).expect("fits");
            let second = found.harmonics[0];
            let real = second.amplitude_rel * second.phase_rad.cos() - 0.02 * 0.4_f64.cos();
            let squares = [
                (found.dc_v - 0.1) / found.standard_uncertainty_dc_v,
                (found.rms_v - 0.5_f64.sqrt()) / found.standard_uncertainty_rms_v,
                (found.phase_rad - 0.3) / found.standard_uncertainty_phase_rad,
                real / second.standard_uncertainty_rel,
                found.noise_rms_v / noise_rms_v,
            ];
            for (sum, value) in sums.iter_mut().zip(squares) {
                *sum += value * value / f64::from(runs);
            }
        }
        // Mean squares of 200 numbers of unit variance scatter by sqrt(2/200) =
        // 0.1; four times that. The noise itself is known from 2000 samples each.
        for mean_square in &sums[..4] {
            assert!((mean_square - 1.0).abs() < 0.4, "{sums:?}");
        }
        assert!(
            (sums[4] - 1.0).abs() < 4.0 * (2.0_f64 / 400_000.0).sqrt(),
            "{sums:?}"
        );
    }

    #[test]
    fn harmonics_above_half_the_sample_rate_are_not_there() {
        let volts = waveform(4096, 8000.0, 0.0, &[(1.0, 0.0), (0.1, 0.0), (0.05, 0.0)]);
        let found = fit(&volts, RATE_HZ, 8000.0).expect("fits");
        // 24 kHz is the third, 32 kHz the fourth.
        let orders: Vec<u8> = found.harmonics.iter().map(|h| h.order).collect();
        assert_eq!(orders, [2, 3]);
        assert!((found.harmonics[1].amplitude_rel - 0.05).abs() < 1e-11);
    }

    #[test]
    fn what_cannot_be_fitted_is_said() {
        let volts = vec![0.0; 400];
        for frequency_hz in [0.0, -1.0, f64::NAN, f64::INFINITY, 25_000.0, 24_990.0] {
            let error = fit(&volts, RATE_HZ, frequency_hz);
            assert!(
                matches!(error, Err(FitError::Frequency { .. })),
                "{frequency_hz}"
            );
        }
        // 400 samples are a cycle of 125 Hz.
        let short = fit(&volts, RATE_HZ, 124.0);
        assert!(matches!(short, Err(FitError::TooShort { .. })));
        assert!(matches!(
            fit(&[1.0; 5], RATE_HZ, 10_000.0),
            Err(FitError::TooShort { .. })
        ));
        let mut volts = volts;
        volts[7] = f64::NAN;
        assert_eq!(fit(&volts, RATE_HZ, 125.0), Err(FitError::NotFinite(7)));
    }

    proptest! {
        #[test]
        fn any_tone_comes_back_whatever_its_start(
            frequency_hz in 20.0..5_000.0_f64,
            amplitude_v in 1e-3..5.0_f64,
            phase_rad in -3.0..3.0_f64,
            second_rel in 0.0..0.3_f64,
            dc_v in -1.0..1.0_f64,
        ) {
            let volts = waveform(4096, frequency_hz, dc_v,
                &[(amplitude_v, phase_rad), (second_rel * amplitude_v, 2.0 * phase_rad + 0.5)]);
            let found = fit(&volts, RATE_HZ, frequency_hz).expect("a cycle or more");
            let near = |value: f64, wanted: f64| (value - wanted).abs() < 1e-9;
            prop_assert!(near(found.rms_v * 2_f64.sqrt(), amplitude_v));
            prop_assert!(near(wrapped(found.phase_rad - phase_rad) * amplitude_v, 0.0));
            prop_assert!(near(found.dc_v, dc_v));
            let second = found.harmonics[0];
            prop_assert!(near(second.amplitude_rel * amplitude_v, second_rel * amplitude_v));
            prop_assert!(near(second_rel * amplitude_v * wrapped(second.phase_rad - 0.5), 0.0));
        }
    }
}
