//! Figures of the converters from blocks of sample pairs.

use crate::converter::{MID_SAMPLE, Width};
use core::f32::consts::TAU;
use libm::{cosf, roundf, sinf, sqrtf};

/// Periods of the tone in a block: prime to its 500 pairs, so that each sample is of another phase and
/// the tone visits some 500 codes.
const PERIODS: usize = 7;
/// Peak of the tone, of half the drive's range: 0.33 V from either rail.
const PEAK_REL: f32 = 0.8;
/// Samples of half the range.
const HALF_RANGE: f32 = MID_SAMPLE as f32;

/// An input at rest, in samples of [`crate::converter`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtRest {
    /// Mean, from mid-scale.
    pub offset: f32,
    /// Standard deviation about the mean.
    pub noise_rms: f32,
}

/// The drive's converter as the input of the device under test hears it on the chip. Relative to what
/// the tone should be there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loopback {
    /// Amplitude heard over amplitude played.
    pub gain: f32,
    /// Mean, from mid-scale, in samples.
    pub offset: f32,
    /// R.m.s. of what repeats and is no tone, over the r.m.s. of the tone.
    pub distortion_rel: f32,
    /// R.m.s. of what does not repeat, over the r.m.s. of the tone.
    pub noise_rel: f32,
}

/// The sample of the reference (half 0) or of the device under test (half 16), from mid-scale.
fn sample(pair: u32, half: u32) -> f32 {
    f32::from((pair >> half) as u16) - f32::from(MID_SAMPLE)
}

/// Offset and noise of both inputs, reference first. Of no pairs, not a number.
pub fn at_rest(pairs: &[u32]) -> [AtRest; 2] {
    let count = pairs.len() as f32;
    [0, 16].map(|half| {
        let offset = pairs.iter().map(|pair| sample(*pair, half)).sum::<f32>() / count;
        let power = |pair: &u32| {
            let apart = sample(*pair, half) - offset;
            apart * apart
        };
        AtRest {
            offset,
            noise_rms: sqrtf(pairs.iter().map(power).sum::<f32>() / count),
        }
    })
}

/// Angle of the tone at a place of a block.
fn angle_rad(place: usize, length: usize) -> f32 {
    let turned = (PERIODS * place).checked_rem(length).unwrap_or(0);
    TAU * turned as f32 / length as f32
}

/// A block of the tone for a converter of this width, to be played over and over.
pub fn fill_tone(codes: &mut [u16], width: Width) {
    let (length, mid) = (codes.len(), f32::from(width.mid_code()));
    for (place, code) in codes.iter_mut().enumerate() {
        *code = roundf(mid + mid * PEAK_REL * sinf(angle_rad(place, length))) as u16;
    }
}

/// Figures of the tone from two consecutive blocks, in the half of the device under test.
///
/// # Equation
/// A sine fit of known frequency to the mean of both blocks (IEEE Std 1057, three parameters, whole
/// periods). What the blocks differ by is noise, once more than the blocks' own by the square root of 2;
/// what is left of their mean is distortion and half of the noise's power.
///
/// # Accuracy
/// 1e-5 of the tone, by the arithmetic: test `a_tone_with_known_faults`. A converter of 12 bits has 3e-4 of
/// rounding, which counts as distortion.
pub fn loopback(first: &[u32], second: &[u32]) -> Loopback {
    let length = first.len().min(second.len());
    let count = length as f32;
    let both = || {
        first
            .iter()
            .zip(second)
            .map(|(a, b)| (sample(*a, 16), sample(*b, 16)))
    };
    let offset = both().map(|(a, b)| (a + b) / 2.0).sum::<f32>() / count;
    let (mut sine, mut cosine, mut apart) = (0.0, 0.0, 0.0);
    for (place, (a, b)) in both().enumerate() {
        let mean = (a + b) / 2.0 - offset;
        sine += mean * sinf(angle_rad(place, length)) * 2.0 / count;
        cosine += mean * cosf(angle_rad(place, length)) * 2.0 / count;
        apart += (a - b) * (a - b) / count;
    }
    let mut left = 0.0;
    for (place, (a, b)) in both().enumerate() {
        let angle = angle_rad(place, length);
        let rest = (a + b) / 2.0 - offset - sine * sinf(angle) - cosine * cosf(angle);
        left += rest * rest / count;
    }
    let noise_power = apart / 2.0;
    let peak = HALF_RANGE * PEAK_REL;
    let tone_rms = peak / core::f32::consts::SQRT_2;
    Loopback {
        gain: sqrtf(sine * sine + cosine * cosine) / peak,
        offset,
        distortion_rel: sqrtf((left - noise_power / 2.0).max(0.0)) / tone_rms,
        noise_rel: sqrtf(noise_power) / tone_rms,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTH: usize = 500;

    /// A block of the tone as a part hears it whose converter has these faults.
    fn heard(gain: f64, offset: f64, second_harmonic: f64, noise: f64, seed: u64) -> Vec<u32> {
        let mut state = seed;
        (0..LENGTH)
            .map(|place| {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1);
                let even = (state >> 40) as f64 / f64::from(1 << 23) - 1.0;
                let angle = std::f64::consts::TAU * 7.0 * place as f64 / LENGTH as f64 + 0.3;
                let tone =
                    0.8 * 32_768.0 * (gain * angle.sin() + second_harmonic * (2.0 * angle).cos());
                let code = (32_768.0 + tone + offset + noise * even).round() as u32;
                code << 16 | 0x8000
            })
            .collect()
    }

    #[test]
    fn a_tone_with_known_faults() {
        let (a, b) = (
            heard(0.97, 100.0, 0.004, 0.0, 1),
            heard(0.97, 100.0, 0.004, 0.0, 2),
        );
        let seen = loopback(&a, &b);
        assert!((seen.gain - 0.97).abs() < 1e-5, "{seen:?}");
        assert!((seen.offset - 100.0).abs() < 0.1, "{seen:?}");
        assert!((seen.distortion_rel - 0.004).abs() < 2e-5, "{seen:?}");
        assert!(seen.noise_rel < 1e-5, "{seen:?}");
    }

    /// Even noise of peak p has an r.m.s. of p / sqrt(3); of 500 samples it is known to 3 %.
    #[test]
    fn noise_is_told_from_distortion() {
        let (a, b) = (
            heard(1.0, 0.0, 0.0, 100.0, 1),
            heard(1.0, 0.0, 0.0, 100.0, 2),
        );
        let seen = loopback(&a, &b);
        let want = 100.0 / 3.0_f32.sqrt() / (0.8 * 32_768.0 / 2.0_f32.sqrt());
        assert!((seen.noise_rel / want - 1.0).abs() < 0.1, "{seen:?}");
        assert!(seen.distortion_rel < 0.4 * want, "{seen:?}");
    }

    #[test]
    fn the_tone_played_is_the_tone_heard_but_for_its_rounding() {
        let mut codes = [0; LENGTH];
        fill_tone(&mut codes, Width::of_bits(12));
        assert_eq!(
            (codes.iter().min(), codes.iter().max()),
            (Some(&410), Some(&3686))
        );
        let pairs: Vec<u32> = codes.iter().map(|code| u32::from(*code) << 20).collect();
        let seen = loopback(&pairs, &pairs);
        assert!(
            (seen.gain - 1.0).abs() < 1e-4 && seen.offset.abs() < 1.0,
            "{seen:?}"
        );
        // A twelfth of a code, 16 samples of the 16 bits, squared: 2.5e-4 of the tone.
        assert!((2.0e-4..3.0e-4).contains(&seen.distortion_rel), "{seen:?}");
        assert_eq!(seen.noise_rel, 0.0);
    }

    #[test]
    fn rest_by_hand() {
        let [reference, dut] = at_rest(&[0x8003_7FFF, 0x8005_8001]);
        assert_eq!((reference.offset, reference.noise_rms), (0.0, 1.0));
        assert_eq!((dut.offset, dut.noise_rms), (4.0, 1.0));
    }
}
