//! Harmonics that one channel has and the other has not: a conditioner with a dead zone, or one that bends.
//!
//! # Equation
//! A nonlinearity alike for both signs of a sine `X` takes from its fundamental, or adds to it, three times the third
//! harmonic that it makes: a dead zone of `d` takes `4 d / (pi X)` and leaves `4 d / (3 pi X)`; a cube adds `3/4 c X^2`
//! and leaves `1/4 c X^2`. The motion's own harmonics are in both channels alike, so that the channel's are the
//! difference of both distortions, or more, since they add at any angle: `sqrt(2)` times it in the mean square. As
//! both may be right, a U-shaped component of row 4.
//!
//! A velocity transducer sees of a harmonic `n` of the motion `1/n` of what the reference sees, a displacement
//! transducer `1/n^2`: with `s` such steps, the device's own is what is beyond `d_ref/2^s`, the reference's own what is
//! beyond `5^s d_dut`.
//!
//! Not counted: what noise explains (two standard deviations), and what the resonance of the device makes of the
//! motion's harmonics, at most `(5 f / fr)^2` of them at the fifth.
//!
//! # Source
//! ISO 16063-21:2003, Table A.1, row 4.

use calib_core::correlation::Block;
use calib_core::point::PointResult;
use std::f64::consts::SQRT_2;

/// Fundamental that is lost or added over the third harmonic.
const OVER_THIRD: f64 = 3.0;
/// Lowest harmonic that is measured.
const LOWEST: f64 = 2.0;
/// Highest.
const HIGHEST: f64 = 5.0;
/// Standard deviations of noise that explain a difference.
const BY_NOISE: f64 = 2.0;
/// A half-width below this share of U adds at most 4 % to it, and is left out: some devices have harmonics of their own.
const SMALL_OF_U: f64 = 0.2;
/// Shortest block of a point, s.
const BLOCK_S: f32 = 0.1;

/// By how much the sensitivity of a point may be off, relative; `resonance_s2` is the inverse square of the mounted
/// resonance, `steps` how often the device's motion was differentiated less than acceleration.
pub(super) fn half_width_rel(
    point: &PointResult,
    sample_rate_hz: f32,
    resonance_s2: f64,
    steps: i32,
) -> f64 {
    let [reference, device] =
        [point.distortion_reference_rel, point.distortion_dut_rel].map(f64::from);
    let in_band = HIGHEST * f64::from(point.tone.frequency_hz(sample_rate_hz));
    let raised = (in_band.powi(2) * resonance_s2).min(1.0);
    let [of_reference, of_device] = noises_rel(point, sample_rate_hz);
    let (least, most) = (HIGHEST.powi(-steps), LOWEST.powi(-steps));
    let beyond = [
        (
            device - reference * (most + raised),
            of_device.hypot(most * of_reference),
        ),
        (
            reference * (1.0 - raised) - device / least,
            of_reference.hypot(of_device / least),
        ),
    ];
    let counts = |&(difference, by_noise): &(f64, f64)| {
        let half_width_rel = OVER_THIRD * SQRT_2 * difference;
        let is_seen = half_width_rel > SMALL_OF_U * f64::from(point.expanded_uncertainty_rel);
        // What is no number counts neither.
        (difference > BY_NOISE * by_noise && is_seen).then_some(half_width_rel)
    };
    beyond.iter().filter_map(counts).fold(0.0, f64::max)
}

/// Noise at a harmonic over the fundamental in a whole point: reference and device.
fn noises_rel(point: &PointResult, sample_rate_hz: f32) -> [f64; 2] {
    let noise_rel = [
        point.signal_to_noise_reference_db,
        point.signal_to_noise_dut_db,
    ]
    .map(|db| 10.0_f64.powf(-f64::from(db) / 20.0));
    let block = Block::measuring(point.tone, (BLOCK_S * sample_rate_hz) as u32);
    let samples = f64::from(block.samples()) * f64::from(point.blocks.max(1));
    noise_rel.map(|noise_rel| noise_rel / samples.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_record::sample::point;

    const RATE_HZ: f32 = 50_000.0;
    /// Of a resonance at 35 kHz.
    const RESONANCE_S2: f64 = 8.163e-10;

    /// Distortions of the reference and the device, both with this signal to noise, dB.
    fn half_width(frequency_hz: f32, distortions: [f32; 2], noise_db: f32) -> f64 {
        of_steps(frequency_hz, distortions, noise_db, 0)
    }

    /// Of a device whose motion was differentiated so often less than acceleration.
    fn of_steps(frequency_hz: f32, distortions: [f32; 2], noise_db: f32, steps: i32) -> f64 {
        let mut point = point(frequency_hz);
        [point.distortion_reference_rel, point.distortion_dut_rel] = distortions;
        point.signal_to_noise_reference_db = noise_db;
        point.signal_to_noise_dut_db = noise_db;
        half_width_rel(&point, RATE_HZ, RESONANCE_S2, steps)
    }

    /// A dead zone of 0.15 mV under 14.14 mV: by hand 4 d / (pi X) = 1.35 %, of which a third is left at the third
    /// harmonic. Beside a still motion the distortion is that and the fifth, 1/3 and 1/5 of 1.35 %: 0.525 %.
    #[test]
    fn a_dead_zone_is_within_the_half_width_in_either_channel() {
        for distortions in [[2.0e-4, 5.25e-3], [5.25e-3, 2.0e-4]] {
            let found = half_width(160.0, distortions, 60.0);
            assert!((0.0135..0.03).contains(&found), "{found}");
        }
    }

    /// 26 dB and 20 blocks of 5000 samples: noise of 5 % of the signal, of a harmonic 0.016 %, in both channels 0.022 %;
    /// twice that is 0.045 %.
    #[test]
    fn noise_and_what_is_small_beside_u_do_not_count() {
        assert_eq!(half_width(160.0, [0.037, 0.037_4], 26.0), 0.0);
        assert!(half_width(160.0, [0.037, 0.037_6], 26.0) > 0.0);
        // 3 sqrt(2) 0.03 % is 0.13 %, of U = 0.77 % less than a fifth.
        assert_eq!(half_width(160.0, [0.004, 0.0043], 71.0), 0.0);
        assert_eq!(half_width(160.0, [f32::NAN, 0.0], 71.0), 0.0);
    }

    /// At 5 kHz the device answers the motion's third harmonic a fifth more than its fundamental.
    #[test]
    fn harmonics_that_the_device_raises_are_the_motions() {
        assert_eq!(half_width(5000.0, [0.02, 0.024], 60.0), 0.0);
        assert!(half_width(160.0, [0.02, 0.024], 60.0) > 0.0);
    }

    /// A motion with 2 % of any harmonic: a velocity transducer shows 1 % to 0.4 % of it, one of displacement 0.5 % to
    /// 0.08 %. Beyond that it is a channel's: of 2.4 % in the device's 1.4 %, of 2 % in the reference's beside 0.1 % in
    /// the device 1.5 %.
    #[test]
    fn a_velocity_transducer_shows_less_of_the_motions_harmonics_and_not_more() {
        for (device, steps) in [(0.01, 1), (0.004, 1), (0.005, 2), (0.0008, 2)] {
            let found = of_steps(160.0, [0.02, device], 60.0, steps);
            assert_eq!(found, 0.0, "{device} {steps}");
        }
        for (device, own) in [(0.024, 0.014), (0.001, 0.015)] {
            let found = of_steps(160.0, [0.02, device], 60.0, 1);
            let expected = 3.0 * SQRT_2 * own;
            assert!((found / expected - 1.0).abs() < 0.02, "{device}: {found}");
        }
    }
}
