//! A tone and lines beside it, told apart over the blocks of a point.

use super::normal::{MOST, Normal};
use super::watch::{Hum, LINES};
use core::f32::consts::{FRAC_1_SQRT_2, TAU};
use num_complex::Complex32;

/// Most lines fitted with a tone; the others count as they are.
const MOST_FITTED: usize = MOST / 2 - 1;
/// Smallest part of a tone a line must be in a block for anything to be done about it: a tenth of
/// what repeatability is at best.
const NEGLIGIBLE_REL: f32 = 1.0e-5;
/// How far a line keeps amplitude and phase over a point, relative: machines come and go. It also keeps
/// the equations within what f32 can tell apart.
const STEADY_REL: f32 = 0.02;
/// How far the mains frequency may have moved since it was measured, Hz: the continental grid moves by
/// some 10 mHz in 10 s.
const MOVED_HZ: f32 = 0.01;

/// The stretches of samples amplitudes were taken of, one after another without a gap.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    /// Frequency of the tone, cycles per sample.
    pub tone_per_sample: f32,
    /// Samples per second.
    pub sample_rate_hz: f32,
    /// Samples of a stretch: whole cycles of the tone.
    pub samples: u32,
    /// Phase of the tone at the first sample, as the amplitudes count it.
    pub start: Complex32,
}

/// Remainder of the lines after separating them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Left {
    /// Amplitude of a sine of unknown phase that may still be in the result, relative to the tone.
    pub relative: f32,
    /// Lines that were fitted.
    pub fitted: usize,
}

/// A line near a tone, relative to it.
#[derive(Clone, Copy, Debug, Default)]
struct Line {
    per_sample: f32,
    /// Multiple of the mains.
    multiple: f32,
    peak_rel: f32,
    /// Largest effect on the amplitude of a stretch.
    stretch_rel: f32,
    /// Largest effect on the mean amplitude.
    mean_rel: f32,
}

/// Takes the lines of `hum` out of the amplitudes of a channel, as far as they can be told from the tone.
///
/// `noise_rel` is the noise of a stretch's amplitude over the tone's.
///
/// # Equation
/// A line `Re{H exp(j W n)}` adds to the amplitude of stretch `b`, which begins at sample `s`, correlated
/// at `w`: `H p_b + conj(H) q_b` with `p_b = exp(j (W - w) s) D(W - w)`, `q_b = exp(-j (W + w) s) D(-W - w)`
/// and `D(x)` the mean of `exp(j x k)` over the stretch. Tone and lines are the least squares solution, in which
/// `|H|` is known from the exciter at rest and its phase is not: a normal prior of variance `|H|^2 / 2` in
/// each part. A line that cannot be told from the tone keeps that variance, and one that can loses it.
///
/// # Accuracy
/// `lines_beside_a_tone_are_taken_out`, `a_line_on_the_tone_is_stated`.
#[inline(never)]
pub fn separate(
    amplitudes: &mut [Complex32],
    channel: usize,
    span: &Span,
    hum: &Hum,
    noise_rel: f32,
) -> Left {
    let count = amplitudes.len();
    let mean = amplitudes.iter().sum::<Complex32>() / count.max(1) as f32;
    if !(mean.norm_sqr() > 0.0 && mean.is_finite()) {
        return Left::default();
    }
    let mut lines = [Line::default(); LINES];
    let near = near(&mut lines, channel, span, hum, mean.norm(), count);
    let most = MOST_FITTED.min(count.saturating_sub(1) / 3);
    let (fitted, others) = near.split_at(near.len().min(most));
    let untouched = Left {
        relative: libm::sqrtf(square(near, |line| line.mean_rel)),
        fitted: 0,
    };
    if fitted.is_empty() {
        return untouched;
    }
    let fit = Fit::new(amplitudes, mean, span, fitted, noise_rel, 0.0);
    // The mains may have moved either way: what that does to the tone, and how far it could be told apart then.
    let (mut by_frequency, mut variance) = (0.0_f32, fit.variance);
    for moved_hz in [-MOVED_HZ, MOVED_HZ] {
        let per_sample = moved_hz / span.sample_rate_hz;
        let moved = Fit::new(amplitudes, mean, span, fitted, noise_rel, per_sample);
        by_frequency = by_frequency.max((moved.tone_rel - fit.tone_rel).norm_sqr());
        variance = variance.max(moved.variance);
    }
    let relative =
        libm::sqrtf(2.0 * (variance + by_frequency) + square(others, |line| line.mean_rel));
    if relative * relative >= square(near, |line| line.stretch_rel) {
        // Too near to be told apart by more than is known of the mains.
        return untouched;
    }
    fit.take_out(amplitudes, mean, span, fitted);
    Left {
        relative,
        fitted: fitted.len(),
    }
}

/// Sum of the squares of what lines do, as sines of phases of their own.
#[inline(never)]
fn square(lines: &[Line], of: impl Fn(&Line) -> f32) -> f32 {
    lines
        .iter()
        .fold(0.0, |sum, line| sum + of(line) * of(line))
}

/// The lines that matter to a tone, those that do most first.
fn near<'l>(
    lines: &'l mut [Line; LINES],
    channel: usize,
    span: &Span,
    hum: &Hum,
    tone_peak: f32,
    count: usize,
) -> &'l [Line] {
    let mut found = 0;
    for (peaks, multiple) in hum.lines_peak.iter().zip(1_u16..) {
        let peak_rel = peaks.get(channel).copied().unwrap_or_default() / tone_peak;
        let multiple = f32::from(multiple);
        let per_sample = multiple * hum.mains_hz / span.sample_rate_hz;
        let Some(place) = lines.get_mut(found) else {
            break;
        };
        let [first, image] = kernels(span, per_sample, 0);
        let stretch_rel = peak_rel * (first.norm() + image.norm());
        if stretch_rel > NEGLIGIBLE_REL {
            let moved = multiple * MOVED_HZ / span.sample_rate_hz;
            let at = [per_sample - moved, per_sample, per_sample + moved];
            let share = at.map(|at| share_of_mean(span, at, count));
            *place = Line {
                per_sample,
                multiple,
                peak_rel,
                stretch_rel,
                mean_rel: peak_rel * share.into_iter().fold(0.0, f32::max),
            };
            found += 1;
        }
    }
    let found = lines.get_mut(..found).unwrap_or_default();
    largest_first(found);
    found
}

/// Ten at most: the standard library's sort takes more flash than all else here.
fn largest_first(lines: &mut [Line]) {
    for end in (1..lines.len()).rev() {
        for at in 0..end {
            if let Some([before, after]) = lines.get_mut(at..at + 2)
                && after.mean_rel > before.mean_rel
            {
                core::mem::swap(before, after);
            }
        }
    }
}

/// Largest part of a line in the mean amplitude over so many stretches.
#[inline(never)]
fn share_of_mean(span: &Span, line_per_sample: f32, count: usize) -> f32 {
    let sums = (0..count).fold([Complex32::default(); 2], |[p, q], block| {
        let [first, image] = kernels(span, line_per_sample, block);
        [p + first, q + image]
    });
    (sums[0].norm() + sums[1].norm()) / count.max(1) as f32
}

/// `p_b` and `q_b` of a line in stretch `block`.
#[inline(never)]
fn kernels(span: &Span, line_per_sample: f32, block: usize) -> [Complex32; 2] {
    let start = block as f32 * span.samples as f32;
    [1.0, -1.0].map(|sign| {
        let beside = sign * line_per_sample - span.tone_per_sample;
        let turns = beside * start;
        let at_start = Complex32::from_polar(1.0, TAU * (turns - libm::floorf(turns)));
        at_start * mean_of_turn(beside, span.samples) * span.start.conj()
    })
}

/// Mean of `exp(j 2 pi x k)` for `k` from 0 to `samples - 1`.
fn mean_of_turn(x: f32, samples: u32) -> Complex32 {
    let count = samples.max(1) as f32;
    let half = 0.5 * TAU * x;
    let sine = libm::sinf(half);
    let magnitude = if sine.abs() < 1.0e-7 {
        1.0
    } else {
        libm::sinf(half * count) / (count * sine)
    };
    Complex32::from_polar(1.0, half * (count - 1.0)) * magnitude
}

/// A solution, relative to the mean amplitude.
struct Fit {
    /// Tone, beside the mean.
    tone_rel: Complex32,
    /// The lines, complex.
    lines_rel: [Complex32; MOST_FITTED],
    /// Variance of each part of the tone that is the lines' doing.
    variance: f32,
    moved_per_sample: f32,
}

impl Fit {
    #[inline(never)]
    fn new(
        amplitudes: &[Complex32],
        mean: Complex32,
        span: &Span,
        lines: &[Line],
        noise_rel: f32,
        moved_per_sample: f32,
    ) -> Self {
        let largest = lines.iter().fold(0.0_f32, |a, line| a.max(line.peak_rel));
        let unsteady = STEADY_REL * largest;
        let deviation = libm::hypotf(noise_rel, unsteady);
        let blocks = amplitudes.len() as f32;
        // Unknowns are scaled to an expected size of 1, which f32 asks for.
        let tone_scale = deviation / libm::sqrtf(blocks);
        let mut normal = Normal::new(
            2 + 2 * lines.len(),
            |index| if index < 2 { 0.0 } else { 1.0 },
        );
        for (block, amplitude) in amplitudes.iter().enumerate() {
            let beside = (amplitude / mean - 1.0) / deviation;
            let [mut real, mut imaginary] = [[0.0; MOST]; 2];
            (real[0], imaginary[1]) = (tone_scale / deviation, tone_scale / deviation);
            for (index, line) in lines.iter().enumerate() {
                let [p, q] = line.in_block(span, block, moved_per_sample, mean);
                let scale = line.scale() / deviation;
                let at = 2 + 2 * index;
                set(
                    &mut real,
                    at,
                    [(p.re + q.re) * scale, (q.im - p.im) * scale],
                );
                set(
                    &mut imaginary,
                    at,
                    [(p.im + q.im) * scale, (p.re - q.re) * scale],
                );
            }
            normal.add(&real, beside.re);
            normal.add(&imaginary, beside.im);
        }
        let (x, inverse) = normal.solve();
        let excess = (inverse[0].max(inverse[1]) - 1.0).max(0.0);
        let mut lines_rel = [Complex32::default(); MOST_FITTED];
        let parts = x.get(2..).unwrap_or_default().as_chunks::<2>().0;
        for ((value, line), [re, im]) in lines_rel.iter_mut().zip(lines).zip(parts) {
            *value = Complex32::new(*re, *im) * line.scale();
        }
        Self {
            tone_rel: Complex32::new(x[0], x[1]) * tone_scale,
            lines_rel,
            variance: tone_scale * tone_scale * excess + unsteady * unsteady / blocks,
            moved_per_sample,
        }
    }

    fn take_out(&self, amplitudes: &mut [Complex32], mean: Complex32, span: &Span, lines: &[Line]) {
        for (block, amplitude) in amplitudes.iter_mut().enumerate() {
            for (line, value) in lines.iter().zip(self.lines_rel) {
                let [p, q] = line.in_block(span, block, self.moved_per_sample, mean);
                *amplitude -= (value * p + value.conj() * q) * mean;
            }
        }
    }
}

impl Line {
    /// Expected size of each part of the complex amplitude.
    fn scale(&self) -> f32 {
        self.peak_rel * FRAC_1_SQRT_2
    }

    /// The kernels of a stretch, relative to a tone of the phase of `mean`.
    fn in_block(
        &self,
        span: &Span,
        block: usize,
        moved_per_sample: f32,
        mean: Complex32,
    ) -> [Complex32; 2] {
        let per_sample = self.per_sample + self.multiple * moved_per_sample;
        let turned = mean.conj() / mean.norm();
        kernels(span, per_sample, block).map(|kernel| kernel * turned)
    }
}

fn set(row: &mut [f32; MOST], at: usize, values: [f32; 2]) {
    for (place, value) in row.iter_mut().skip(at).zip(values) {
        *place = value;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RATE_HZ: f64 = 50_000.0;

    /// Amplitudes of 10 stretches of 0.1 s of a tone of amplitude 1 with lines, in f64.
    fn measured(tone_hz: f64, samples: u32, lines: &[(f64, f64, f64)]) -> Vec<Complex32> {
        let tau = std::f64::consts::TAU;
        (0..10_u32)
            .map(|block| {
                let mut sum = num_complex::Complex::new(0.0_f64, 0.0);
                for k in 0..samples {
                    let t = f64::from(block * samples + k) / RATE_HZ;
                    let wave: f64 = lines
                        .iter()
                        .map(|(hz, a, ph)| a * (tau * hz * t + ph).cos())
                        .sum();
                    let value = (tau * tone_hz * t + 0.4).cos() + wave;
                    sum += value * num_complex::Complex::from_polar(1.0, -tau * tone_hz * t);
                }
                let amplitude = sum * 2.0 / f64::from(samples);
                Complex32::new(amplitude.re as f32, amplitude.im as f32)
            })
            .collect()
    }

    fn hum(mains_hz: f64, peaks: &[f32]) -> Hum {
        let mut hum = Hum {
            mains_hz: mains_hz as f32,
            lines_peak: [[0.0; 2]; LINES],
        };
        for (line, peak) in hum.lines_peak.iter_mut().zip(peaks) {
            line[1] = *peak;
        }
        hum
    }

    fn span(tone_hz: f64, samples: u32) -> Span {
        Span {
            tone_per_sample: (tone_hz / RATE_HZ) as f32,
            sample_rate_hz: RATE_HZ as f32,
            samples,
            start: Complex32::new(1.0, 0.0),
        }
    }

    /// Error of the mean after separating `lines` as multiples of `mains_hz` of these amplitudes, and what is said
    /// to be left.
    fn left(
        tone_hz: f64,
        samples: u32,
        lines: &[(f64, f64, f64)],
        mains_hz: f64,
        peaks: &[f32],
    ) -> (f32, Left) {
        let mut amplitudes = measured(tone_hz, samples, lines);
        let span = span(tone_hz, samples);
        let left = separate(&mut amplitudes, 1, &span, &hum(mains_hz, peaks), 1.0e-5);
        let mean = amplitudes.iter().sum::<Complex32>() / 10.0;
        ((mean / Complex32::from_polar(1.0, 0.4) - 1.0).norm(), left)
    }

    /// 0.3 mV r.m.s. beside 1 m/s2 of 10 mV/(m/s2): 3 % of the tone, with harmonics; tones at least
    /// 3 Hz away. Aim of the budget: 0.2 % of U = k u at 1 m/s2, that is 0.14 % of amplitude.
    #[test]
    fn lines_beside_a_tone_are_taken_out() {
        let cases = [
            (31.5, 4762 * 2),
            (53.5, 5 * 1869 / 2),
            (63.0, 4762),
            (80.0, 5000),
            (105.0, 10_000 / 2),
            (125.0, 5200),
            (160.0, 5000),
            (205.0, 5122),
        ];
        for (tone_hz, samples) in cases {
            // Whole cycles: the frequency follows.
            let cycles = (tone_hz * f64::from(samples) / RATE_HZ).round();
            let tone_hz = cycles * RATE_HZ / f64::from(samples);
            for mains_hz in [49.9, 50.0, 50.08, 59.95, 60.1] {
                let off = (1..=3).map(|n| (tone_hz - f64::from(n) * mains_hz).abs());
                if off.fold(f64::INFINITY, f64::min) < 2.9 {
                    continue;
                }
                let lines = [(1.0, 0.03, 1.1), (2.0, 0.01, 2.2), (3.0, 0.01, 3.3)];
                let lines = lines.map(|(n, peak, phase)| (n * mains_hz, peak, phase));
                let peaks = [0.03, 0.01, 0.01];
                let (error, left) = left(tone_hz, samples, &lines, mains_hz, &peaks);
                // U of several sines is sqrt(2) times the root of their squares; f32 keeps 1e-6.
                assert!(
                    error < 1.42 * left.relative + 1.0e-6,
                    "{tone_hz} {mains_hz}: {error} {left:?}"
                );
                assert!(left.relative < 1.4e-3, "{tone_hz} {mains_hz}: {left:?}");
            }
        }
    }

    /// A line within 1/T of the tone stays in it, and is stated with its amplitude over that of tone and line
    /// together, 0.03 / 1.03 to 0.03 / 0.97. A little further away it is told apart in part. What is stated covers
    /// the error at every phase, also where the mains has moved by 10 mHz: U is sqrt(2) times the amplitude.
    #[test]
    fn a_line_on_the_tone_is_stated() {
        let least = |mains_hz: f64| if mains_hz == 50.0 { 0.0291 } else { 0.0 };
        for mains_hz in [50.0, 50.01, 49.98, 50.03, 50.1, 49.8, 50.3, 51.0] {
            for (moved_hz, allowed) in [(0.0, 1.05), (0.01, 1.42), (-0.01, 1.42)] {
                for phase in [0.0, 0.8, 1.6, 2.4, 3.2, 4.0, 4.8, 5.6] {
                    let lines = [(mains_hz + moved_hz, 0.03, phase)];
                    let (error, left) = left(50.0, 5000, &lines, mains_hz, &[0.03]);
                    let within = error <= allowed * left.relative;
                    assert!(within, "{mains_hz} {moved_hz} {phase}: {error} {left:?}");
                    assert!(
                        (least(mains_hz)..0.0313).contains(&left.relative),
                        "{left:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn where_nothing_matters_nothing_changes() {
        let mut amplitudes = measured(1000.0, 5000, &[(50.0, 0.001, 0.0)]);
        let before = amplitudes.clone();
        let left = separate(
            &mut amplitudes,
            1,
            &span(1000.0, 5000),
            &hum(50.0, &[0.001]),
            1e-5,
        );
        assert_eq!((amplitudes, left), (before, Left::default()));
    }
}
