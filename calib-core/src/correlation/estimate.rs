//! From the integer fold to complex amplitudes and residual noise.

use super::block::Block;
use super::fold::FoldSum;
use super::sums::Sums;
use crate::phase::PhaseWalk;
use crate::tone::Tone;
use num_complex::Complex32;

/// Highest harmonic that is looked at.
pub const HARMONICS: usize = 5;

/// What one channel shows in one block, in the unit of its samples.
///
/// The signal is described as `mean + sum Re{amplitude_h exp(j h w t)} + rest`:
/// amplitudes are peak values, phases those of a cosine at the block's sample
/// number 0 of the tone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelEstimate {
    /// Complex peak amplitude of the fundamental.
    pub amplitude: Complex32,
    /// Mean value.
    pub mean: f32,
    /// Complex peak amplitudes of harmonics 2 to 5; zero where the harmonic
    /// lies at or above half the sample rate.
    pub harmonics: [Complex32; HARMONICS - 1],
    /// Root mean square of what mean, fundamental and harmonics leave.
    pub residual_rms: f32,
    /// True when a sample reached an end of the converter's range.
    pub clipped: bool,
}

impl ChannelEstimate {
    /// The same in another unit, such as volts for codes.
    pub fn scaled(self, unit_per_code: f32) -> Self {
        Self {
            amplitude: self.amplitude * unit_per_code,
            mean: self.mean * unit_per_code,
            harmonics: self.harmonics.map(|harmonic| harmonic * unit_per_code),
            residual_rms: self.residual_rms * unit_per_code,
            clipped: self.clipped,
        }
    }

    /// Magnitude of the fundamental, peak.
    pub fn amplitude_peak(&self) -> f32 {
        self.amplitude.norm()
    }

    /// Total harmonic distortion: r.m.s. of harmonics 2 to 5 over that of the
    /// fundamental; 0 when there is no fundamental.
    pub fn distortion_rel(&self) -> f32 {
        let harmonics: f32 = self.harmonics.iter().map(Complex32::norm_sqr).sum();
        let fundamental = self.amplitude.norm_sqr();
        if fundamental > 0.0 {
            libm::sqrtf(harmonics / fundamental)
        } else {
            0.0
        }
    }

    /// Fundamental over residual noise, dB, both r.m.s.; limited to +-200 dB.
    pub fn signal_to_noise_db(&self) -> f32 {
        let signal_rms = self.amplitude_peak() * core::f32::consts::FRAC_1_SQRT_2;
        if self.residual_rms > 0.0 && signal_rms > 0.0 {
            (20.0 * libm::log10f(signal_rms / self.residual_rms)).clamp(-200.0, 200.0)
        } else if signal_rms > 0.0 {
            200.0
        } else {
            -200.0
        }
    }

    /// Standard uncertainty of the peak amplitude by the residual noise of
    /// `samples` samples, taken as white: `residual * sqrt(2 / samples)`.
    pub fn amplitude_noise(&self, samples: u32) -> f32 {
        self.residual_rms * libm::sqrtf(2.0 / samples.max(1) as f32)
    }
}

/// Both channels of one block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairEstimate {
    /// Shape of the block.
    pub block: Block,
    /// Reference channel.
    pub reference: ChannelEstimate,
    /// Device under test.
    pub dut: ChannelEstimate,
}

/// Complex amplitudes of harmonics 1 to 5.
type Spectrum = [Complex32; HARMONICS];

/// Correlates a full fold.
///
/// # Accuracy
/// Amplitude 1e-6 relative and phase 1e-6 rad at full scale, for 10 ms as for
/// 10 s: test `full_scale_signals_agree_with_an_f64_oracle`. The residual is
/// the sum of two parts that are formed without cancellation, see
/// [`spread_within_places`] and [`residual_energy`]; test
/// `noise_far_below_the_signal_is_measured`.
pub(super) fn estimate(
    block: Block,
    start_index: u32,
    fold: &[FoldSum],
    squares: [i64; 2],
    clipped: [bool; 2],
) -> PairEstimate {
    let means = [mean_code(fold, 0), mean_code(fold, 1)];
    let walk = PhaseWalk::new(block.tone(), start_index);
    let (spectra, offsets) = correlate(walk, fold, means, block);
    let fit_energy = residual_energy(walk, fold, means, block, &spectra, offsets);
    let channel = |index: usize| {
        let [amplitude, harmonics @ ..] = spectra[index];
        let within = spread_within_places(fold, index, squares[index], block.passes());
        ChannelEstimate {
            amplitude,
            mean: means[index] as f32 / block.passes() as f32 + offsets[index],
            harmonics,
            residual_rms: libm::sqrtf((within + fit_energy[index]) / block.samples() as f32),
            clipped: clipped[index],
        }
    };
    PairEstimate {
        block,
        reference: channel(0),
        dut: channel(1),
    }
}

/// Rounded mean of a channel's sums: subtracting it in integers keeps a large
/// offset out of the f32 sums.
fn mean_code(fold: &[FoldSum], channel: usize) -> i32 {
    let sum: i64 = fold.iter().map(|sums| i64::from(sums[channel])).sum();
    (sum / fold.len().max(1) as i64) as i32
}

/// Sums of a place, free of the mean, in codes per sample.
#[inline]
fn centred(sums: FoldSum, means: [i32; 2], per_pass: f32) -> [f32; 2] {
    [
        sums[0].wrapping_sub(means[0]) as f32 * per_pass,
        sums[1].wrapping_sub(means[1]) as f32 * per_pass,
    ]
}

/// exp(j h phase) for h = 1 to 5, by multiplication.
#[inline]
fn harmonic_phasors((cosine, sine): (f32, f32)) -> Spectrum {
    let first = Complex32::new(cosine, sine);
    let second = first * first;
    let third = second * first;
    [first, second, third, second * second, third * second]
}

/// Harmonics that lie below half the sample rate.
fn usable_harmonics(tone: Tone) -> usize {
    let below = |h: &usize| 2 * h * usize::from(tone.cycles) < usize::from(tone.period_samples);
    (1..=HARMONICS).take_while(below).count().max(1)
}

/// Spectra of both channels, and what is left of their means.
fn correlate(
    mut walk: PhaseWalk,
    fold: &[FoldSum],
    means: [i32; 2],
    block: Block,
) -> ([Spectrum; 2], [f32; 2]) {
    let per_pass = 1.0 / block.passes() as f32;
    // Per channel: five cosine sums, five sine sums, one plain sum; and the
    // mean of exp(-2j phase), by which the fundamental leaks into itself.
    let mut sums = Sums::<24>::new();
    for &place in fold {
        let phasors = harmonic_phasors(walk.next_cos_sin());
        let values = centred(place, means, per_pass);
        let mut terms = [0.0; 24];
        terms[22] = phasors[1].re;
        terms[23] = -phasors[1].im;
        for (value, half) in values.into_iter().zip(terms.as_chunks_mut::<11>().0) {
            for (phasor, pair) in phasors.iter().zip(half.as_chunks_mut::<2>().0) {
                pair[0] = value * phasor.re;
                pair[1] = -value * phasor.im;
            }
            half[10] = value;
        }
        sums.add(terms);
    }
    let total = sums.total();
    let scale = 2.0 / fold.len().max(1) as f32;
    let usable = usable_harmonics(block.tone());
    let spectrum = |half: &[f32]| {
        let mut spectrum = [Complex32::new(0.0, 0.0); HARMONICS];
        let pairs = half.as_chunks::<2>().0.iter().take(usable);
        for (amplitude, pair) in spectrum.iter_mut().zip(pairs) {
            *amplitude = Complex32::new(pair[0], pair[1]) * scale;
        }
        spectrum
    };
    let (reference, rest) = total.split_at(11);
    let (dut, leak) = rest.split_at(11);
    let offsets = [0.5 * scale * reference[10], 0.5 * scale * dut[10]];
    let mut spectra = [spectrum(reference), spectrum(dut)];
    if !block.is_exact() {
        let leakage = Complex32::new(leak[0], leak[1]) * (0.5 * scale);
        spectra
            .iter_mut()
            .for_each(|s| s[0] = without_leakage(s[0], leakage));
    }
    (spectra, offsets)
}

/// The amplitude behind `seen = A + conj(A) leakage`: the normal equations of
/// a single sine, solved.
fn without_leakage(seen: Complex32, leakage: Complex32) -> Complex32 {
    (seen - seen.conj() * leakage) / (1.0 - leakage.norm_sqr())
}

/// Energy of the difference between the averaged period and the fit, times the
/// passes: the part of the residual that repeats in every period.
fn residual_energy(
    mut walk: PhaseWalk,
    fold: &[FoldSum],
    means: [i32; 2],
    block: Block,
    spectra: &[Spectrum; 2],
    offsets: [f32; 2],
) -> [f32; 2] {
    let per_pass = 1.0 / block.passes() as f32;
    let mut sums = Sums::<2>::new();
    for &place in fold {
        let phasors = harmonic_phasors(walk.next_cos_sin());
        let values = centred(place, means, per_pass);
        let rest = |channel: usize| {
            let fit = spectra[channel].iter().zip(&phasors);
            let fitted: f32 = fit.map(|(a, p)| a.re * p.re - a.im * p.im).sum();
            let rest = values[channel] - offsets[channel] - fitted;
            rest * rest
        };
        sums.add([rest(0), rest(1)]);
    }
    sums.total().map(|energy| energy * block.passes() as f32)
}

/// Energy of the samples about the average of their own place: the part of
/// the residual that differs from period to period.
///
/// `sum x^2 - sum F^2 / passes` is formed in 128-bit integers: exact, so
/// nothing is lost when the signal is a million times the noise.
fn spread_within_places(fold: &[FoldSum], channel: usize, squares: i64, passes: u32) -> f32 {
    let folded: i128 = fold
        .iter()
        .map(|sums| i128::from(i64::from(sums[channel]) * i64::from(sums[channel])))
        .sum();
    let spread = i128::from(squares) * i128::from(passes) - folded;
    spread.max(0) as f32 / passes as f32
}
