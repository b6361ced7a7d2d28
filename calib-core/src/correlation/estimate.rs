//! From the integer fold to complex amplitudes and residual noise.

use super::block::Block;
use super::fold::{Energy, FoldSum, SQUARE_STRIDE};
use super::mirror::{HARMONICS, Mirror, Spectrum};
use super::sums::Sums;
use crate::converter::{MID_SAMPLE, Width};
use crate::tone::Tone;
use num_complex::Complex32;

/// Estimates of one channel in one block, in the unit of its samples.
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
    /// True when samples reached an end of the converter's range: in every
    /// period at the same place, as a signal that is too large does, or as a
    /// spike far beyond the rest of the signal.
    pub clipped: bool,
}

impl ChannelEstimate {
    /// Converts to another unit, such as volts for codes.
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

/// [`MID_SAMPLE`] where sums of it are formed.
const MIDDLE: i64 = MID_SAMPLE as i64;

/// How far a spike stands out of what else the fit leaves: in normal noise, one
/// of 1e15 places does. A spike in a fold of n places stands out by sqrt(n),
/// at least 22 times.
const SPIKE_FACTOR: f32 = 8.0;

/// Correlates a full fold.
///
/// # Accuracy
/// Amplitude 1e-6 relative and phase 1e-6 rad at full scale, for 10 ms as for
/// 10 s: test `full_scale_signals_agree_with_an_f64_oracle`. The residual is
/// the sum of two parts that are formed without cancellation, see
/// [`spread_within_places`] and [`rests`]; test
/// `noise_far_below_the_signal_is_measured`.
pub(super) fn estimate(
    block: Block,
    start_index: u32,
    fold: &[FoldSum],
    energy: Energy,
    width: Width,
) -> PairEstimate {
    let means = [mean_code(fold, 0), mean_code(fold, 1)];
    let mirror = Mirror::new(block, start_index, fold);
    let fit = correlate(&mirror, means, block);
    let rests = rests(&mirror, means, block.passes(), &fit);
    let channel = |index: usize| {
        let [amplitude, harmonics @ ..] = mirror.since_start(&fit.spectra[index]);
        let within = spread_within_places(fold, index, energy, block.passes());
        ChannelEstimate {
            amplitude,
            mean: mean_of_sample(means[index], block.passes()) + fit.offsets[index],
            harmonics,
            residual_rms: libm::sqrtf((within + rests[index].energy) / block.samples() as f32),
            clipped: stays_at_an_end(fold, index, block.passes(), width)
                || rests[index].has_spike(block.passes(), width),
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
fn mean_code(fold: &[FoldSum], channel: usize) -> u32 {
    let sum: u64 = fold
        .iter()
        .map(|sum| u64::from(sum.channels()[channel]))
        .sum();
    (sum / fold.len().max(1) as u64) as u32
}

/// Mean of a sample about mid-scale, from the mean of the sums.
fn mean_of_sample(mean: u32, passes: u32) -> f32 {
    (i64::from(mean) - MIDDLE * i64::from(passes)) as f32 / passes as f32
}

/// True when some place held the first or the last sample of the range, or one beyond it, over all passes.
fn stays_at_an_end(fold: &[FoldSum], channel: usize, passes: u32, width: Width) -> bool {
    let [bottom, top] =
        [width.first_sample(), width.last_sample()].map(|sample| u32::from(sample) * passes);
    let mut sums = fold.iter().map(|sum| sum.channels()[channel]);
    sums.any(|sum| sum <= bottom || sum >= top)
}

/// Sums of a place, free of the mean, in codes per sample.
#[inline]
fn centred(sum: FoldSum, means: [u32; 2], per_pass: f32) -> [f32; 2] {
    let [reference, dut] = sum.channels();
    // Sums stay below 2^31, see `MAX_PASSES`: their difference fits.
    let difference = |sum: u32, mean: u32| sum.wrapping_sub(mean) as i32 as f32;
    [
        difference(reference, means[0]) * per_pass,
        difference(dut, means[1]) * per_pass,
    ]
}

/// Harmonics that lie below half the sample rate.
fn usable_harmonics(tone: Tone) -> usize {
    let below = |h: &usize| 2 * h * usize::from(tone.cycles) < usize::from(tone.period_samples);
    (1..=HARMONICS).take_while(below).count().max(1)
}

/// Components of both averaged periods.
struct Fit {
    /// Spectra of both channels, phases counted from the middle of the fold.
    spectra: [Spectrum; 2],
    /// Remainder of their means.
    offsets: [f32; 2],
}

/// Fits both channels.
fn correlate(mirror: &Mirror<'_>, means: [u32; 2], block: Block) -> Fit {
    let per_pass = 1.0 / block.passes() as f32;
    let mut sums = Sums::new();
    if let Some(centre) = mirror.centre() {
        let here = [Complex32::new(1.0, 0.0); HARMONICS];
        sums.add(terms(&here, centred(centre, means, per_pass), [0.0; 2]));
    }
    for (phasors, places) in mirror.pairs() {
        let [before, behind] = places.map(|place| centred(place, means, per_pass));
        let even = [behind[0] + before[0], behind[1] + before[1]];
        let odd = [behind[0] - before[0], behind[1] - before[1]];
        sums.add(terms(&phasors, even, odd));
    }
    let total = sums.total();
    let scale = 2.0 / mirror.places();
    let usable = usable_harmonics(block.tone());
    let spectrum = |half: &[f32]| {
        let mut spectrum = [Complex32::new(0.0, 0.0); HARMONICS];
        let pairs = half.as_chunks::<2>().0.iter().take(usable);
        for (amplitude, pair) in spectrum.iter_mut().zip(pairs) {
            *amplitude = Complex32::new(pair[0], pair[1]) * scale;
        }
        spectrum
    };
    let (reference, dut) = total.split_at(TERMS / 2);
    let mut spectra = [spectrum(reference), spectrum(dut)];
    if !block.is_exact() {
        let leakage = mirror.leakage();
        spectra
            .iter_mut()
            .for_each(|s| s[0] = without_leakage(s[0], leakage));
    }
    let offsets = [reference, dut].map(|half| 0.5 * scale * half[2 * HARMONICS]);
    Fit { spectra, offsets }
}

/// Terms of the sums of a correlation: for each channel five cosine sums beside five sine sums, and a plain one.
const TERMS: usize = 2 * (2 * HARMONICS + 1);

/// Terms that two places add to the sums, by the sum and the difference of their values.
#[inline(always)]
fn terms(phasors: &Spectrum, even: [f32; 2], odd: [f32; 2]) -> [f32; TERMS] {
    let mut terms = [0.0; TERMS];
    let halves = terms.as_chunks_mut::<{ TERMS / 2 }>().0;
    for ((even, odd), half) in even.into_iter().zip(odd).zip(halves) {
        for (phasor, pair) in phasors.iter().zip(half.as_chunks_mut::<2>().0) {
            pair[0] = even * phasor.re;
            pair[1] = -odd * phasor.im;
        }
        half[2 * HARMONICS] = even;
    }
    terms
}

/// The amplitude behind `seen = A + conj(A) leakage`: the normal equations of
/// a single sine, solved.
fn without_leakage(seen: Complex32, leakage: f32) -> Complex32 {
    Complex32::new(seen.re / (1.0 + leakage), seen.im / (1.0 - leakage))
}

/// Residual of the fit in a channel's averaged period.
#[derive(Clone, Copy, Default)]
struct Rest {
    /// Its energy times the passes: the part of the residual that repeats in
    /// every period.
    energy: f32,
    /// Its largest square, codes squared.
    largest_square: f32,
    /// Its mean square, codes squared.
    mean_square: f32,
}

impl Rest {
    /// True when one place stands out as a lone sample at an end of the range
    /// does: by half the range when its passes are summed again, and by eight
    /// times what all places leave.
    ///
    /// The signal around a spike must stay within half of the range. In a larger
    /// one a lone clipped sample is off by less than the signal itself, and
    /// shows in the residual.
    fn has_spike(self, passes: u32, width: Width) -> bool {
        // From an end of the range to half of it, less one code for rounding.
        let spike = f32::from(MID_SAMPLE / 2 - width.sample_step());
        let summed = spike / passes as f32;
        self.largest_square >= summed * summed
            && self.largest_square >= SPIKE_FACTOR * SPIKE_FACTOR * self.mean_square
    }
}

/// Residual of mean, fundamental and harmonics in both averaged periods.
fn rests(mirror: &Mirror<'_>, means: [u32; 2], passes: u32, fit: &Fit) -> [Rest; 2] {
    let per_pass = 1.0 / passes as f32;
    let mut sums = Sums::<2>::new();
    // As bits: squares are never negative, and the bits of such numbers are in the
    // order of the numbers. What is not a number comes out largest of all.
    let mut largest = [0_u32; 2];
    let mut square = |channel: usize, value: f32, fitted: f32| {
        let rest = value - fit.offsets[channel] - fitted;
        let square = rest * rest;
        largest[channel] = largest[channel].max(square.to_bits());
        square
    };
    if let Some(centre) = mirror.centre() {
        let values = centred(centre, means, per_pass);
        let fitted = |channel: usize| fit.spectra[channel].iter().map(|a| a.re).sum();
        let squares = [0, 1].map(|channel| square(channel, values[channel], fitted(channel)));
        sums.add(squares);
    }
    for (phasors, places) in mirror.pairs() {
        let [before, behind] = places.map(|place| centred(place, means, per_pass));
        let squares = [0, 1].map(|channel| {
            let (mut even, mut odd) = (0.0, 0.0);
            for (amplitude, phasor) in fit.spectra[channel].iter().zip(&phasors) {
                even += amplitude.re * phasor.re;
                odd += amplitude.im * phasor.im;
            }
            square(channel, before[channel], even + odd)
                + square(channel, behind[channel], even - odd)
        });
        sums.add(squares);
    }
    let total = sums.total();
    [0, 1].map(|channel| Rest {
        energy: total[channel] * passes as f32,
        largest_square: f32::from_bits(largest[channel]),
        mean_square: total[channel] / mirror.places(),
    })
}

/// Energy of the samples about the average of their own place: the part of
/// the residual that differs from period to period, estimated for all places
/// from those whose squares were summed.
///
/// `sum x^2 - sum F^2 / passes` is formed in 128-bit integers: exact, so
/// nothing is lost when the signal is a million times the noise.
fn spread_within_places(fold: &[FoldSum], channel: usize, energy: Energy, passes: u32) -> f32 {
    let middle = MIDDLE * i64::from(passes);
    let (mut folded, mut places) = (0_i128, 0_u32);
    for sums in fold.iter().step_by(SQUARE_STRIDE) {
        let sum = i128::from(i64::from(sums.channels()[channel]) - middle);
        folded += sum * sum;
        places += 1;
    }
    let spread = i128::from(energy.squares[channel]) * i128::from(passes) - folded;
    let all = fold.len() as f32 / places.max(1) as f32;
    spread.max(0) as f32 / passes as f32 * all
}
