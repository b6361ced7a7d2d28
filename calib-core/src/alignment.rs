//! Whether both channels of a sample pair are of the same instant.
//!
//! A shift by one sample turns the phase by 360 degrees times the frequency over the sample rate and
//! leaves the magnitude alone: no other check sees it. What tells is a signal with edges that reaches
//! both inputs at once. Steps from sample to sample are correlated, so that offsets, gains, hum and
//! the ringing of a suspension count little against an edge.

/// Pairs that are judged at once, at most.
pub const MAX_PAIRS: usize = 1000;

/// Shifts that are looked for, samples to either side.
const FARTHEST: isize = 3;

/// Correlation from which a common signal is seen: 14 edges of 164 samples in 500 have seventy times
/// the power of the steps of a noise of 2.3 r.m.s., so that it correlates by 0.98; with a noise of 6.5, a
/// single conversion's, by 0.9.
const SEEN: f32 = 0.5;
/// By how much the right shift must exceed every other. An edge that takes two samples correlates with
/// itself by 0.5 at the next one; 500 pairs of noise by 0.05 (one in the square root of their number).
const MARGIN: f32 = 0.25;

/// Alignment of the two channels, by a signal common to both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Alignment {
    /// Both halves of a pair are of one instant.
    Aligned,
    /// The device under test's half is so many samples later than the reference's.
    Shifted(i8),
    /// No common signal, or something else beside it.
    Unclear,
}

/// Judges `pairs` (low half reference, high half device under test) taken while one signal with edges
/// was on both inputs. More than [`MAX_PAIRS`] are not looked at.
pub fn judge(pairs: &[u32]) -> Alignment {
    let pairs = &pairs[..pairs.len().min(MAX_PAIRS)];
    let mut best = (0, f32::NEG_INFINITY);
    let mut second = f32::NEG_INFINITY;
    for shift in -FARTHEST..=FARTHEST {
        let correlation = correlation(pairs, shift);
        if correlation > best.1 {
            second = best.1;
            best = (shift, correlation);
        } else {
            second = second.max(correlation);
        }
    }
    let clear = best.1 >= SEEN && best.1 - second >= MARGIN;
    match best.0 {
        _ if !clear => Alignment::Unclear,
        0 => Alignment::Aligned,
        shift => Alignment::Shifted(shift as i8),
    }
}

/// Correlation, -1 to 1, of the reference's steps with those `shift` samples later of the device under
/// test; 0 where either stands still.
fn correlation(pairs: &[u32], shift: isize) -> f32 {
    let (mut product, mut reference, mut dut) = (0.0_f32, 0.0_f32, 0.0_f32);
    for place in 0..pairs.len() {
        let Some(later) = place.checked_add_signed(shift) else {
            continue;
        };
        let (Some(own), Some(other)) = (step(pairs, place, 0), step(pairs, later, 16)) else {
            continue;
        };
        product += own * other;
        reference += own * own;
        dut += other * other;
    }
    let power = libm::sqrtf(reference) * libm::sqrtf(dut);
    if power > 0.0 { product / power } else { 0.0 }
}

/// From one sample to the next, in samples of [`crate::converter`]; `half` is the place of the channel.
fn step(pairs: &[u32], place: usize, half: u32) -> Option<f32> {
    let sample = |place: usize| Some(f32::from((pairs.get(place)? >> half) as u16));
    Some(sample(place + 1)? - sample(place)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Noise of a converter, samples: even within +-4, 2.3 r.m.s.
    fn noise(seed: &mut u32) -> f64 {
        *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(*seed >> 8) / f64::from(1 << 24) * 8.0 - 4.0
    }

    /// Both inputs at 32 768 with edges of `edge` every 35 samples and `hum` of 50 Hz beside, the device
    /// under test `late` samples later and a fifth larger.
    fn pairs(edge: f64, hum: f64, late: isize) -> Vec<u32> {
        let mut seed = 1;
        let mut at = |place: isize, gain: f64| {
            let high = (place + 350) / 35 % 2 == 0;
            let edges = if high { edge } else { -edge } / 2.0;
            let hum = hum * (core::f64::consts::TAU * 50.0 * place as f64 / 50_000.0).sin();
            (32_768.0 + gain * (edges + hum) + noise(&mut seed)).clamp(0.0, 65_535.0) as u32
        };
        (0..500)
            .map(|place| at(place, 1.0) | at(place - late, 1.2) << 16)
            .collect()
    }

    #[test]
    fn edges_tell_the_shift() {
        for late in -3..=3_isize {
            let want = match late {
                0 => Alignment::Aligned,
                _ => Alignment::Shifted(late as i8),
            };
            // Half of the edge that 100 ohm at the pins give. And hum of 0.5 V beside.
            assert_eq!(judge(&pairs(82.0, 0.0, late)), want);
            assert_eq!(judge(&pairs(164.0, 3000.0, late)), want);
        }
    }

    #[test]
    fn a_quiet_input_is_no_proof() {
        assert_eq!(judge(&pairs(0.0, 0.0, 0)), Alignment::Unclear);
        assert_eq!(judge(&[0x8000_8000; 500]), Alignment::Unclear);
        assert_eq!(judge(&[]), Alignment::Unclear);
        assert_eq!(judge(&[0x8000_8000]), Alignment::Unclear);
    }

    /// A slow tone moves both channels alike at every small shift.
    #[test]
    fn a_tone_is_no_proof() {
        for late in 0..=1 {
            assert_eq!(judge(&pairs(0.0, 20_000.0, late)), Alignment::Unclear);
        }
    }

    #[test]
    fn an_edge_that_takes_two_samples_still_tells() {
        let sharp = pairs(164.0, 0.0, 0);
        let soft: Vec<u32> = sharp
            .windows(2)
            .map(|two| {
                let half =
                    |place: u32| ((two[0] >> place & 0xFFFF) + (two[1] >> place & 0xFFFF)) / 2;
                half(0) | half(16) << 16
            })
            .collect();
        assert_eq!(judge(&soft), Alignment::Aligned);
    }
}
