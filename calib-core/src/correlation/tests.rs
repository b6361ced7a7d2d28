//! The correlation against an independent calculation in f64.

use super::*;
use crate::converter::Width;
use crate::preferred::PREFERRED_HZ;
use crate::tone::Tone;
use num_complex::Complex32;

const RATE_HZ: f32 = 50_000.0;
const SIXTEEN_BITS: Width = Width::of_bits(16);
const TAU: f64 = std::f64::consts::TAU;

/// A tone with everything a channel may show, in codes.
#[derive(Clone, Copy)]
struct Signal {
    peak: f64,
    phase: f64,
    mean: f64,
    /// Amplitudes of harmonics 2 to 5.
    harmonics: [f64; 4],
}

const PLAIN: Signal = Signal {
    peak: 32_000.0,
    phase: 0.7,
    mean: 0.0,
    harmonics: [0.0; 4],
};

impl Signal {
    fn at(&self, tone: Tone, n: u64) -> f64 {
        let phase = |h: u64| {
            let place = (h * u64::from(tone.cycles) * n) % u64::from(tone.period_samples);
            TAU * place as f64 / f64::from(tone.period_samples)
        };
        let fundamental = self.peak * (phase(1) + self.phase).cos();
        let harmonics = (2..).zip(self.harmonics);
        let overtones: f64 = harmonics.map(|(h, a)| a * (phase(h) + 0.3).cos()).sum();
        self.mean + fundamental + overtones
    }
}

/// A seeded stream of numbers that are close to normal, variance 1.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Sum of four uniform numbers, centred, times sqrt(12 / 4).
    fn normal(&mut self) -> f64 {
        ((0..4).map(|_| self.uniform()).sum::<f64>() - 2.0) * 3.0_f64.sqrt()
    }
}

fn code(value: f64) -> u32 {
    (value.round() + 32_768.0).clamp(0.0, 65_535.0) as u32
}

fn pairs(tone: Tone, signals: [Signal; 2], first: u64, samples: u32, noise: f64) -> Vec<u32> {
    let mut random = Noise(0x9E37_79B9_7F4A_7C15);
    (first..first + u64::from(samples))
        .map(|n| {
            let [reference, dut] = signals.map(|s| s.at(tone, n) + noise * random.normal());
            code(reference) | (code(dut) << 16)
        })
        .collect()
}

/// Three-parameter least squares on the samples themselves, in f64: amplitude
/// as a complex number, and mean.
fn oracle(tone: Tone, pairs: &[u32], first: u64, shift: u32) -> ((f64, f64), f64) {
    let mut normal = [[0.0_f64; 4]; 3];
    for (n, pair) in (first..).zip(pairs) {
        let place = (u64::from(tone.cycles) * n) % u64::from(tone.period_samples);
        let angle = TAU * place as f64 / f64::from(tone.period_samples);
        let value = f64::from((pair >> shift) & 0xFFFF) - 32_768.0;
        let row = [angle.cos(), -angle.sin(), 1.0, value];
        for (i, line) in normal.iter_mut().enumerate() {
            for (sum, term) in line.iter_mut().zip(row) {
                *sum += row[i] * term;
            }
        }
    }
    let [re, im, mean] = solve(normal);
    ((re, im), mean)
}

/// Gaussian elimination of a 3 by 3 system.
fn solve(mut m: [[f64; 4]; 3]) -> [f64; 3] {
    for i in 0..3 {
        for j in 0..3 {
            if i != j {
                let factor = m[j][i] / m[i][i];
                let pivot = m[i];
                for (value, above) in m[j].iter_mut().zip(pivot) {
                    *value -= factor * above;
                }
            }
        }
    }
    [0, 1, 2].map(|i| m[i][3] / m[i][i])
}

fn correlate(block: Block, start_index: u32, pairs: &[u32]) -> PairEstimate {
    correlate_at(SIXTEEN_BITS, block, start_index, pairs)
}

fn correlate_at(width: Width, block: Block, start_index: u32, pairs: &[u32]) -> PairEstimate {
    let mut memory = Box::new(FoldMemory::new());
    let mut correlator = Correlator::new(&mut memory, width, block, start_index);
    // Odd chunks, as no buffer is a whole number of periods.
    for chunk in pairs.chunks(997) {
        correlator.push(chunk);
    }
    correlator.estimate().expect("complete")
}

/// Relative error of the magnitude and error of the phase, rad.
fn errors(seen: Complex32, (re, im): (f64, f64)) -> (f64, f64) {
    let (x, y) = (f64::from(seen.re), f64::from(seen.im));
    let magnitude = x.hypot(y) / re.hypot(im) - 1.0;
    let phase = (y * re - x * im).atan2(x * re + y * im);
    (magnitude.abs(), phase.abs())
}

fn tone(nominal_hz: f32) -> Tone {
    Tone::nearest(nominal_hz, RATE_HZ).expect("a tone")
}

#[test]
fn full_scale_signals_agree_with_an_f64_oracle() {
    let second = Signal {
        phase: -2.1,
        mean: 700.0,
        peak: 29_000.0,
        ..PLAIN
    };
    for nominal_hz in PREFERRED_HZ {
        let tone = tone(nominal_hz);
        let blocks = [
            Block::control(tone),
            Block::control_of(tone, 1_500),
            Block::measuring(tone, 5_000),
        ];
        for block in blocks {
            let first = 123_u64;
            let pairs = pairs(tone, [PLAIN, second], first, block.samples(), 0.0);
            let estimate = correlate(block, first as u32, &pairs);
            for (channel, shift) in [(estimate.reference, 0), (estimate.dut, 16)] {
                let (amplitude, mean) = oracle(tone, &pairs, first, shift);
                let (magnitude, phase) = errors(channel.amplitude, amplitude);
                assert!(magnitude < 1.0e-6, "{nominal_hz} Hz: {magnitude}");
                assert!(phase < 1.0e-6, "{nominal_hz} Hz: {phase}");
                // Against the scale of the signal; where the block is not
                // exact, its mean is not corrected for leakage (0.1 %).
                let scale = if block.is_exact() { 1.0e-6 } else { 1.0e-3 };
                assert!((f64::from(channel.mean) - mean).abs() < scale * 32_000.0);
            }
        }
    }
}

#[test]
fn ten_seconds_are_as_accurate_as_ten_milliseconds() {
    for nominal_hz in [5.0, 31.5, 160.0, 10_000.0] {
        let tone = tone(nominal_hz);
        let block = Block::measuring(tone, 500_000);
        assert!(block.samples() >= 500_000);
        let pairs = pairs(tone, [PLAIN, PLAIN], 0, block.samples(), 0.0);
        let estimate = correlate(block, 0, &pairs);
        let (amplitude, _) = oracle(tone, &pairs, 0, 0);
        let (magnitude, phase) = errors(estimate.reference.amplitude, amplitude);
        assert!(
            magnitude < 1.0e-6 && phase < 1.0e-6,
            "{nominal_hz}: {magnitude} {phase}"
        );
    }
}

#[test]
fn control_blocks_grow_by_cycles() {
    // 63 Hz is 3 cycles in 2 381 samples: a cycle is 793.7 samples, and only the
    // whole period is exact.
    let tone = tone(63.0);
    assert_eq!((tone.cycles, tone.period_samples), (3, 2_381));
    for (wanted, samples) in [(1, 794), (795, 1_587), (1_588, 2_381), (2_382, 4_762)] {
        let block = Block::control_of(tone, wanted);
        assert_eq!(block.samples(), samples, "{wanted}");
        assert_eq!(block.is_exact(), samples % 2_381 == 0, "{wanted}");
    }
}

#[test]
fn blocks_within_a_time_hold_all_whole_cycles_it_has() {
    // 160 Hz: 312.5 samples a cycle, 313 are 0.2 % off. 40 Hz: 1250. 3150 Hz: 15.87 samples, 31 cycles are 492.02.
    for (nominal_hz, most, samples) in [
        (160.0, 500, Some(313)),
        (125.0, 500, Some(400)),
        (40.0, 500, None),
        (3150.0, 500, Some(492)),
    ] {
        let block = Block::within(tone(nominal_hz), most);
        assert_eq!(block.map(Block::samples), samples, "{nominal_hz}");
    }
}

#[test]
fn control_blocks_within_a_time_are_a_thousandth_of_a_cycle_off_at_most() {
    // 315 Hz: 158.73 samples a cycle, of which neither 159 nor 317 are whole ones within 0.1 %. 3150 Hz: 15.873
    // samples, 23 cycles are 365.08.
    for (nominal_hz, most, samples) in [
        (1000.0, 374, Some(350)),
        (315.0, 374, None),
        (3150.0, 374, Some(365)),
        (63.0, 374, None),
    ] {
        let block = Block::control_within(tone(nominal_hz), most);
        assert_eq!(block.map(Block::samples), samples, "{nominal_hz}");
    }
}

#[test]
fn passed_over_is_what_was_asked_and_at_most_a_thousandth_more() {
    for samples in [1, 499, 1502, 2002, 12_000, 12_001, 100_003] {
        let passed = Block::discard(tone(160.0), samples).samples();
        assert!(
            passed >= samples && passed - samples <= samples / 1000,
            "{samples}: {passed}"
        );
    }
}

#[test]
fn sums_cannot_overflow_in_the_longest_block() {
    for nominal_hz in PREFERRED_HZ {
        let block = Block::measuring(tone(nominal_hz), u32::MAX);
        // 65 535 is the highest code; below 2^31 differences fit as well.
        assert!(u64::from(block.passes()) * 65_535 <= i32::MAX as u64);
        // 10 s fit with room: 32 767 passes of at least 500 samples.
        assert!(block.samples() >= 500_000);
    }
}

#[test]
fn whole_cycles_do_not_leak() {
    // Every preferred frequency: a mean and harmonics 2 to 5 of 10 % each must
    // not show in the fundamental. Codes are rounded: up to half a code of
    // rounding may correlate when a period has few samples, so the comparison
    // is with the oracle that fits only sine and mean to the same codes; on
    // whole cycles both reject harmonics, each by orthogonality.
    let signal = Signal {
        peak: 20_000.0,
        mean: 1_500.0,
        harmonics: [2_000.0; 4],
        ..PLAIN
    };
    for nominal_hz in PREFERRED_HZ {
        let tone = tone(nominal_hz);
        let block = Block::measuring(tone, 500);
        let below_nyquist =
            |h: usize| 2 * h * usize::from(tone.cycles) < tone.period_samples.into();
        let mut signal = signal;
        for (h, amplitude) in (2..).zip(&mut signal.harmonics) {
            if !below_nyquist(h) {
                *amplitude = 0.0;
            }
        }
        let clean = Signal {
            harmonics: [0.0; 4],
            ..signal
        };
        let noisy = pairs(tone, [signal, clean], 0, block.samples(), 0.0);
        let estimate = correlate(block, 0, &noisy);
        let (magnitude, phase) = errors(
            estimate.reference.amplitude,
            (
                f64::from(estimate.dut.amplitude.re),
                f64::from(estimate.dut.amplitude.im),
            ),
        );
        // Rounding to codes: at most 0.5 sqrt(2) on 20 000 when a period of
        // five samples repeats, 3.5e-5; leakage of the mean alone would be
        // up to 0.075.
        assert!(
            magnitude < 4.0e-5 && phase < 4.0e-5,
            "{nominal_hz}: {magnitude} {phase}"
        );
        for (h, seen) in (2..).zip(estimate.reference.harmonics) {
            let expected = if below_nyquist(h) { 2_000.0 } else { 0.0 };
            assert!(
                (seen.norm() - expected).abs() < 1.0,
                "{nominal_hz} Hz, {h}: {seen}"
            );
        }
    }
}

#[test]
fn noise_far_below_the_signal_is_measured() {
    // 0.5 codes r.m.s. under 32 000 codes peak are 93 dB. Rounding to codes
    // adds 1/12 of a code squared. The residual of n samples scatters by
    // 1 / sqrt(2 n); every 13th of 50 000 samples gives 1.14 %; 4 sigma.
    for nominal_hz in [20.0, 31.5, 160.0, 3150.0] {
        let tone = tone(nominal_hz);
        let block = Block::measuring(tone, 50_000);
        let pairs = pairs(tone, [PLAIN, PLAIN], 0, block.samples(), 0.5);
        let estimate = correlate(block, 0, &pairs);
        let expected = (0.25_f64 + 1.0 / 12.0).sqrt();
        let residual = f64::from(estimate.reference.residual_rms);
        assert!(
            (residual / expected - 1.0).abs() < 0.046,
            "{nominal_hz}: {residual}"
        );
    }
}

#[test]
fn the_variance_is_that_of_the_cramer_rao_bound() {
    // 60 dB signal to noise: sigma = A_rms / 1000. The bound of a sine of known
    // frequency in white noise is sigma^2 * 2 / N for the amplitude and the
    // same over A^2 for the phase. The variance of `runs` estimates scatters
    // by sqrt(2 / runs); both parts of both channels together are four times as
    // many, so 60 000 runs give 0.29 %. Asked is 1 %.
    let tone = tone(2500.0);
    let block = Block::measuring(tone, 500);
    let signal = Signal {
        peak: 28_000.0,
        ..PLAIN
    };
    let sigma = 28.0_f64 * std::f64::consts::FRAC_1_SQRT_2;
    let clean: Vec<f64> = (0..500).map(|n| signal.at(tone, n)).collect();
    let mut random = Noise(77);
    let mut memory = Box::new(FoldMemory::new());
    let mut correlator = Correlator::new(&mut memory, SIXTEEN_BITS, block, 0);
    let (runs, mut square, mut bias) = (60_000, 0.0, 0.0);
    let (cosine, sine) = (signal.phase.cos(), signal.phase.sin());
    for _ in 0..runs {
        let noisy: Vec<u32> = clean
            .iter()
            .map(|value| {
                let reference = code(value + sigma * random.normal());
                reference | (code(value + sigma * random.normal()) << 16)
            })
            .collect();
        correlator.start(block, 0);
        correlator.push(&noisy);
        let estimate = correlator.estimate().expect("complete");
        for channel in [estimate.reference, estimate.dut] {
            let (x, y) = (
                f64::from(channel.amplitude.re),
                f64::from(channel.amplitude.im),
            );
            let along = x * cosine + y * sine - signal.peak;
            let across = y * cosine - x * sine;
            square += along * along + across * across;
            bias += along;
        }
    }
    // The noise that is added has variance sigma^2 and 1/12 for rounding.
    let bound = (sigma * sigma + 1.0 / 12.0) * 2.0 / 500.0;
    let variance = square / (4.0 * f64::from(runs));
    assert!(
        (variance / bound - 1.0).abs() < 0.01,
        "{}",
        variance / bound
    );
    // Bias: the mean of 120 000 scatters by sqrt(bound / 120 000) / A = 1.3e-7.
    let bias = bias / (2.0 * f64::from(runs)) / signal.peak;
    assert!(bias.abs() < 1.0e-6, "{bias}");
}

#[test]
fn a_signal_beyond_the_range_is_clipped_in_its_channel() {
    for nominal_hz in PREFERRED_HZ {
        let tone = tone(nominal_hz);
        // With five samples a period, the one nearest the peak is at least
        // cos(36 degrees) = 0.81 of it.
        let large = Signal {
            peak: 33_000.0 / 0.8,
            ..PLAIN
        };
        for block in [Block::control(tone), Block::measuring(tone, 5_000)] {
            for (signals, clipped) in [
                ([large, PLAIN], [true, false]),
                ([PLAIN, large], [false, true]),
            ] {
                let pairs = pairs(tone, signals, 0, block.samples(), 3.0);
                let estimate = correlate(block, 0, &pairs);
                let seen = [estimate.reference.clipped, estimate.dut.clipped];
                assert_eq!(seen, clipped, "{nominal_hz} Hz");
            }
        }
    }
}

#[test]
fn a_single_clipped_sample_is_found_in_its_channel() {
    let tone = tone(160.0);
    let block = Block::measuring(tone, 5_000);
    let quiet = Signal {
        peak: 900.0,
        ..PLAIN
    };
    let clean = pairs(tone, [quiet, quiet], 0, block.samples(), 1.0);
    let estimate = correlate(block, 0, &clean);
    assert!(!estimate.reference.clipped && !estimate.dut.clipped);
    let cases = [
        (0xFFFF_8000, false, true),
        (0x8000_0000, true, false),
        (0x0000_8000, false, true),
    ];
    for place in [0, 63, 64, 1234, 4_999] {
        for (pair, reference, dut) in cases {
            let mut one = clean.clone();
            one[place] = pair;
            let estimate = correlate(block, 0, &one);
            assert_eq!(estimate.reference.clipped, reference, "{place}");
            assert_eq!(estimate.dut.clipped, dut, "{place}");
        }
    }
}

#[test]
fn a_narrower_converter_clips_at_its_own_last_code() {
    // The highest sample of 14 bits is 4 * 16 383.
    let fourteen_bits = Width::of_bits(14);
    let tone = tone(160.0);
    let block = Block::measuring(tone, 5_000);
    for (peak, clipped) in [(32_000.0, false), (36_000.0, true)] {
        let signal = Signal { peak, ..PLAIN };
        let pairs: Vec<u32> = pairs(tone, [signal, signal], 0, block.samples(), 0.0)
            .into_iter()
            .map(|pair| pair & 0xFFFC_FFFC)
            .collect();
        let estimate = correlate_at(fourteen_bits, block, 0, &pairs);
        assert_eq!(estimate.reference.clipped, clipped);
        assert_eq!(estimate.dut.clipped, clipped);
    }
    let quiet = Signal {
        peak: 900.0,
        ..PLAIN
    };
    let mut pairs = pairs(tone, [quiet, quiet], 0, block.samples(), 1.0);
    pairs[1234] = 0xFFFC_8000;
    let estimate = correlate_at(fourteen_bits, block, 0, &pairs);
    assert!(!estimate.reference.clipped && estimate.dut.clipped);
}

/// Behind a front end with dither conversions are cut off from sample 55 935 on, 23 167 from the middle.
#[test]
fn a_signal_that_leaves_no_room_for_the_dither_is_clipped() {
    let dithered = SIXTEEN_BITS.with_dither();
    let tone = tone(160.0);
    let block = Block::measuring(tone, 5_000);
    for (peak, clipped) in [(23_100.0, false), (23_250.0, true)] {
        let signal = Signal { peak, ..PLAIN };
        let pairs = pairs(tone, [signal, signal], 0, block.samples(), 0.0);
        let estimate = correlate_at(dithered, block, 0, &pairs);
        assert_eq!(estimate.reference.clipped, clipped, "{peak}");
        assert_eq!(estimate.dut.clipped, clipped, "{peak}");
    }
}

#[test]
fn noise_is_not_taken_for_clipping() {
    // Noise that makes the sums of a place scatter far beyond half the range,
    // by 5 000 sqrt(8) and 2 000 sqrt(800), without one that stands out.
    for (peak, noise, samples) in [(900.0, 5_000.0, 5_000), (9_000.0, 2_000.0, 500_000)] {
        let tone = tone(160.0);
        let block = Block::measuring(tone, samples);
        let signal = Signal { peak, ..PLAIN };
        let pairs = pairs(tone, [signal, signal], 0, block.samples(), noise);
        let estimate = correlate(block, 0, &pairs);
        assert!(!estimate.reference.clipped && !estimate.dut.clipped);
    }
}

#[test]
fn squared_places_are_spread_over_the_cycle() {
    // Were the stride a divisor of the period, noise that comes with the slope
    // or the size of the signal would be judged at some of its places alone.
    for nominal_hz in PREFERRED_HZ {
        let period = usize::from(tone(nominal_hz).period_samples);
        assert!(!period.is_multiple_of(fold::SQUARE_STRIDE), "{nominal_hz}");
    }
}

#[test]
fn the_phase_counts_from_sample_zero_of_the_tone_in_every_block() {
    let tone = tone(31.5);
    for block in [Block::control(tone), Block::measuring(tone, 5_000)] {
        let phase_at = |first: u64| {
            let pairs = pairs(tone, [PLAIN, PLAIN], first, block.samples(), 0.0);
            correlate(block, first as u32, &pairs).dut.amplitude.arg()
        };
        let expected = phase_at(0);
        for first in [1, 777, 4_761, 4_762, 100_003] {
            // Two estimates, each within 1e-6.
            assert!((phase_at(first) - expected).abs() < 2.0e-6, "{first}");
        }
    }
}

#[test]
fn an_unfinished_block_has_no_estimate() {
    let block = Block::measuring(tone(160.0), 5_000);
    let mut memory = Box::new(FoldMemory::new());
    let mut correlator = Correlator::new(&mut memory, SIXTEEN_BITS, block, 0);
    assert_eq!(correlator.estimate(), None);
    let pairs = vec![0x8000_8000; block.samples() as usize + 10];
    assert_eq!(correlator.push(&pairs[..100]), 100);
    assert_eq!(correlator.estimate(), None);
    assert_eq!(correlator.push(&pairs), block.samples() as usize - 100);
    let estimate = correlator.estimate().expect("complete");
    assert_eq!(estimate.reference.amplitude_peak(), 0.0);
    assert_eq!(estimate.reference.residual_rms, 0.0);
    assert_eq!(correlator.push(&pairs), 0);
}

mod properties {
    use super::*;
    use proptest::prelude::*;

    fn any_tone() -> impl Strategy<Value = Tone> {
        prop::sample::select(PREFERRED_HZ.to_vec()).prop_map(tone)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn the_estimate_is_linear(tone in any_tone(), a in 500_i32..4_000, b in 500_i32..4_000, phase in -3.0..3.0_f64) {
            // Integer samples and their sums: addition is exact before f32.
            let block = Block::measuring(tone, 1);
            let samples = |peak: i32, phase: f64| -> Vec<i32> {
                let signal = Signal { peak: f64::from(peak), phase, ..PLAIN };
                (0..block.samples()).map(|n| signal.at(tone, n.into()).round() as i32).collect()
            };
            let (x, y) = (samples(a, 0.4), samples(b, phase));
            let both = |x: &[i32], y: &[i32]| -> Vec<u32> {
                x.iter().zip(y).map(|(x, y)| (x + 32_768) as u32 | (((y + 32_768) as u32) << 16)).collect()
            };
            let sum: Vec<i32> = x.iter().zip(&y).map(|(x, y)| x + y).collect();
            let parts = correlate(block, 0, &both(&x, &y));
            let whole = correlate(block, 0, &both(&sum, &sum));
            let difference = parts.reference.amplitude + parts.dut.amplitude - whole.dut.amplitude;
            prop_assert!(difference.norm() < 1.0e-6 * (a + b) as f32);
        }

        #[test]
        fn a_common_gain_leaves_the_ratio_alone(tone in any_tone(), shift in 1_u32..5, phase in -3.0..3.0_f64) {
            // Gains of powers of two on whole codes: the samples scale exactly,
            // so the ratio may differ by f32 rounding alone: 1e-6 of each of the two.
            let block = Block::measuring(tone, 1_000);
            let quiet = [Signal { peak: 900.0, ..PLAIN }, Signal { peak: 700.0, phase, ..PLAIN }];
            let pairs = pairs(tone, quiet, 0, block.samples(), 0.0);
            let louder: Vec<u32> = pairs.iter().map(|pair| {
                let scaled = |half: u32| (((half as i32 - 32_768) << shift) + 32_768) as u32;
                scaled(pair & 0xFFFF) | (scaled(pair >> 16) << 16)
            }).collect();
            let ratio = |estimate: PairEstimate| estimate.dut.amplitude / estimate.reference.amplitude;
            let (before, after) = (ratio(correlate(block, 0, &pairs)), ratio(correlate(block, 0, &louder)));
            prop_assert!((after / before - 1.0).norm() < 2.0e-6, "{before} {after}");
        }

        #[test]
        fn a_shift_of_phase_is_seen_as_that_shift(tone in any_tone(), phase in -3.0..3.0_f64, shift in -3.0..3.0_f64) {
            let block = Block::measuring(tone, 2_000);
            let one = Signal { phase, ..PLAIN };
            let other = Signal { phase: phase + shift, ..PLAIN };
            let pairs = pairs(tone, [one, other], 0, block.samples(), 0.0);
            let estimate = correlate(block, 0, &pairs);
            let seen = f64::from((estimate.dut.amplitude / estimate.reference.amplitude).arg());
            let error = (seen - shift + TAU / 2.0).rem_euclid(TAU) - TAU / 2.0;
            // Rounding to codes: 0.7 on 32 000 for each, at most, when a period
            // has five samples.
            prop_assert!(error.abs() < 4.5e-5, "{error}");
        }

        #[test]
        fn dc_and_other_whole_cycle_tones_are_rejected(tone in any_tone(), other in 1_u16..200, mean in -3_000.0..3_000.0_f64) {
            let block = Block::measuring(tone, 1);
            let period = u64::from(tone.period_samples);
            let other = other % tone.period_samples.div_ceil(2);
            let alias = [1, 2, 3, 4, 5].map(|h| h * tone.cycles);
            prop_assume!(!alias.iter().any(|a| {
                (a + other) % tone.period_samples == 0 || a % tone.period_samples == other
            }) && other > 0);
            let pairs: Vec<u32> = (0..u64::from(block.samples())).map(|n| {
                let place = (u64::from(other) * n) % period;
                let value = 20_000.0 * (TAU * place as f64 / period as f64).cos() + mean;
                code(value) | (0x8000 << 16)
            }).collect();
            let estimate = correlate(block, 0, &pairs);
            // What is left is the rounding of the codes: at most half a code,
            // with all samples alike in sign.
            prop_assert!(estimate.reference.amplitude_peak() < 1.0, "{:?}", estimate.reference);
            prop_assert!((f64::from(estimate.reference.mean) - mean).abs() < 0.6);
        }

        #[test]
        fn any_pairs_in_any_pieces_give_a_finite_estimate(seed in any::<u64>(), piece in 1_usize..3_000) {
            let mut random = Noise(seed | 1);
            let block = Block::measuring(tone(250.0), 2_000);
            let pairs: Vec<u32> = (0..block.samples()).map(|_| (random.uniform() * 4_294_967_295.0) as u32).collect();
            let mut memory = Box::new(FoldMemory::new());
            let mut correlator = Correlator::new(&mut memory, SIXTEEN_BITS, block, 7);
            for chunk in pairs.chunks(piece) {
                correlator.push(chunk);
            }
            let estimate = correlator.estimate().expect("complete");
            prop_assert_eq!(estimate, correlate(block, 7, &pairs));
            prop_assert!(estimate.reference.residual_rms.is_finite());
        }
    }
}
