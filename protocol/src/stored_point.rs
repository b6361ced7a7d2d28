//! The compact stored form of a point.
//!
//! | quantity | stored as | kept |
//! |---|---|---|
//! | frequency, level, sensitivity, phase | f32 | exactly |
//! | acceleration reached | millionths of the set level | 5e-7 of the set level |
//! | expanded uncertainties, coverage factor | upper 24 bits of the f32 | 1.6e-5 |
//! | repeatability, degrees of freedom, distortion, noise, drive ... | upper 16 bits | 0.2 % |
//! | temperature of the instrument | hundredths of a degree | 0.005 K |
//!
//! Rounded values are for reading; the host evaluates the budget again where it
//! needs every digit. Round frequencies and levels take two or three bytes.
//!
//! Where a format is for people (JSON), points are written as they are.

use calib_core::point::{PointResult, PointSpec};
use calib_core::tone::Tone;
use calib_core::verdict::Verdict;
use core::fmt;
use heapless::Vec;
use serde::de::{Error, SeqAccess, Visitor};
use serde::ser::SerializeSeq;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Acceleration is stored in these parts of the set level.
const LEVEL_PARTS: f64 = 1.0e6;

/// A round number in 2 to 3 bytes, any other in 5: `200 x` when that is a whole
/// number, else the bits of the f32 and an odd end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Round(u64);

impl From<f32> for Round {
    fn from(value: f32) -> Self {
        let hundredths = (f64::from(value) * 100.0 + 0.5) as u32;
        let same = hundredths < 1 << 24 && hundredths as f32 / 100.0 == value;
        // Minus zero equals zero, and is not the same bits.
        if same && value.is_sign_positive() {
            Self(u64::from(hundredths) << 1)
        } else {
            Self(u64::from(value.to_bits()) << 1 | 1)
        }
    }
}

impl From<Round> for f32 {
    fn from(Round(code): Round) -> Self {
        let value = (code >> 1) as u32;
        if code & 1 == 1 {
            Self::from_bits(value)
        } else {
            value as Self / 100.0
        }
    }
}

/// The upper `N` bytes of an f32, rounded to the nearest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Upper<const N: usize>([u8; N]);

impl<const N: usize> From<f32> for Upper<N> {
    fn from(value: f32) -> Self {
        let half = 1_u32 << (31 - 8 * N as u32);
        // Rounding must not turn the largest numbers, or NaN, into others.
        let bits = value.to_bits();
        let rounded = match value.is_finite() {
            true if f32::from_bits(bits.wrapping_add(half)).is_finite() => bits.wrapping_add(half),
            _ => bits,
        };
        let bytes = rounded.to_be_bytes();
        let mut upper = [0; N];
        upper
            .iter_mut()
            .zip(bytes)
            .for_each(|(to, from)| *to = from);
        Self(upper)
    }
}

impl<const N: usize> From<Upper<N>> for f32 {
    fn from(Upper(upper): Upper<N>) -> Self {
        let mut bytes = [0; 4];
        bytes
            .iter_mut()
            .zip(upper)
            .for_each(|(to, from)| *to = from);
        Self::from_be_bytes(bytes)
    }
}

/// A point as it is stored.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct StoredPoint {
    frequency: Round,
    level: Round,
    tone: Tone,
    verdict: Verdict,
    /// Bit 0: inverted. Bit 1: the coverage factor is 2. Bit 2: a broadband
    /// point, which has no distortion; in its place is one less the coherence.
    flags: u8,
    coverage_factor: Option<[u8; 3]>,
    acceleration: i32,
    sensitivity: [u8; 4],
    phase: [u8; 4],
    uncertainty: [u8; 3],
    uncertainty_phase: [u8; 3],
    blocks: u16,
    diagnostics: [[u8; 2]; DIAGNOSTICS],
    /// Hundredths of a degree Celsius, or [`NO_TEMPERATURE`].
    temperature: [u8; 2],
}

/// In place of a temperature that could not be read.
const NO_TEMPERATURE: i16 = i16::MIN;

/// Hundredths of a degree: up to 327 degrees, far beyond any silicon.
fn hundredths(temperature_c: Option<f32>) -> i16 {
    match temperature_c {
        Some(value) if value.is_finite() => {
            let nearest = round(f64::from(value) * 100.0);
            nearest.clamp(-i32::from(i16::MAX), i32::from(i16::MAX)) as i16
        }
        _ => NO_TEMPERATURE,
    }
}

fn temperature_c(hundredths: i16) -> Option<f32> {
    (hundredths != NO_TEMPERATURE).then(|| f32::from(hundredths) / 100.0)
}

/// Values of the diagnostics, in the order of [`diagnostics`].
const DIAGNOSTICS: usize = 11;

fn diagnostics(point: &PointResult) -> [f32; DIAGNOSTICS] {
    [
        point.repeatability_rel,
        point.repeatability_phase_rad,
        point.effective_degrees_of_freedom,
        point.distortion_reference_rel,
        point
            .coherence
            .map_or(point.distortion_dut_rel, |coherence| 1.0 - coherence),
        point.signal_to_noise_reference_db,
        point.signal_to_noise_dut_db,
        point.amplitude_stability_rel,
        point.drive_peak_v,
        point.settling_s,
        point.overshoot_rel,
    ]
}

impl From<&PointResult> for StoredPoint {
    fn from(point: &PointResult) -> Self {
        let level = f64::from(point.spec.acceleration_rms_ms2);
        let reached = f64::from(point.acceleration_rms_ms2) / level - 1.0;
        let k_is_two = point.coverage_factor == 2.0;
        Self {
            frequency: point.spec.frequency_hz.into(),
            level: point.spec.acceleration_rms_ms2.into(),
            tone: point.tone,
            verdict: point.verdict,
            flags: u8::from(point.inverted)
                | u8::from(k_is_two) << 1
                | u8::from(point.coherence.is_some()) << 2,
            coverage_factor: (!k_is_two).then(|| Upper::from(point.coverage_factor).0),
            acceleration: round(reached * LEVEL_PARTS),
            sensitivity: point.sensitivity_v_per_ms2.to_le_bytes(),
            phase: point.phase_rad.to_le_bytes(),
            uncertainty: Upper::from(point.expanded_uncertainty_rel).0,
            uncertainty_phase: Upper::from(point.expanded_uncertainty_phase_rad).0,
            blocks: point.blocks,
            diagnostics: diagnostics(point).map(|value| Upper::from(value).0),
            temperature: hundredths(point.instrument_temperature_c).to_le_bytes(),
        }
    }
}

/// Nearest whole number; what is not a number becomes 0.
fn round(value: f64) -> i32 {
    let half = if value < 0.0 { -0.5 } else { 0.5 };
    (value + half) as i32
}

impl From<StoredPoint> for PointResult {
    fn from(stored: StoredPoint) -> Self {
        let level: f32 = stored.level.into();
        let reached = f64::from(level) * (1.0 + f64::from(stored.acceleration) / LEVEL_PARTS);
        let [
            repeatability_rel,
            repeatability_phase_rad,
            effective_degrees_of_freedom,
            distortion_reference_rel,
            distortion_or_incoherence,
            signal_to_noise_reference_db,
            signal_to_noise_dut_db,
            amplitude_stability_rel,
            drive_peak_v,
            settling_s,
            overshoot_rel,
        ] = stored.diagnostics.map(|bytes| Upper(bytes).into());
        let (distortion_dut_rel, coherence) = match stored.flags & 4 {
            0 => (distortion_or_incoherence, None),
            _ => (0.0, Some(1.0 - distortion_or_incoherence)),
        };
        Self {
            spec: PointSpec {
                frequency_hz: stored.frequency.into(),
                acceleration_rms_ms2: level,
            },
            tone: stored.tone,
            verdict: stored.verdict,
            acceleration_rms_ms2: reached as f32,
            sensitivity_v_per_ms2: f32::from_le_bytes(stored.sensitivity),
            phase_rad: f32::from_le_bytes(stored.phase),
            inverted: stored.flags & 1 != 0,
            repeatability_rel,
            repeatability_phase_rad,
            blocks: stored.blocks,
            expanded_uncertainty_rel: Upper(stored.uncertainty).into(),
            coverage_factor: stored
                .coverage_factor
                .map_or(2.0, |bytes| Upper(bytes).into()),
            effective_degrees_of_freedom,
            expanded_uncertainty_phase_rad: Upper(stored.uncertainty_phase).into(),
            distortion_reference_rel,
            distortion_dut_rel,
            signal_to_noise_reference_db,
            signal_to_noise_dut_db,
            amplitude_stability_rel,
            drive_peak_v,
            settling_s,
            overshoot_rel,
            coherence,
            instrument_temperature_c: temperature_c(i16::from_le_bytes(stored.temperature)),
        }
    }
}

/// Rounds a result as storing does, so that what is shown live and what is
/// read back later are the same numbers.
pub fn as_stored(point: &PointResult) -> PointResult {
    StoredPoint::from(point).into()
}

/// Reads one stored point; returns what follows it.
pub(crate) fn take(bytes: &[u8]) -> postcard::Result<(PointResult, &[u8])> {
    let (stored, rest) = postcard::take_from_bytes::<StoredPoint>(bytes)?;
    Ok((stored.into(), rest))
}

/// Writes a list of points: compact in binary formats.
pub(crate) fn serialize<S: Serializer, const N: usize>(
    points: &Vec<PointResult, N>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let plain = serializer.is_human_readable();
    let mut list = serializer.serialize_seq(Some(points.len()))?;
    for point in points {
        if plain {
            list.serialize_element(point)?;
        } else {
            list.serialize_element(&StoredPoint::from(point))?;
        }
    }
    list.end()
}

/// Reads a list of points, one by one.
pub(crate) fn deserialize<'de, D: Deserializer<'de>, const N: usize>(
    deserializer: D,
) -> Result<Vec<PointResult, N>, D::Error> {
    let plain = deserializer.is_human_readable();
    deserializer.deserialize_seq(List::<N> { plain })
}

struct List<const N: usize> {
    plain: bool,
}

impl<'de, const N: usize> Visitor<'de> for List<N> {
    type Value = Vec<PointResult, N>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at most {N} points")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let mut points = Vec::new();
        loop {
            let point = if self.plain {
                list.next_element::<PointResult>()?
            } else {
                list.next_element::<StoredPoint>()?.map(PointResult::from)
            };
            let Some(point) = point else {
                return Ok(points);
            };
            if points.push(point).is_err() {
                return Err(A::Error::custom("too many points"));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::verdict::Reason;
    use proptest::prelude::*;

    fn point() -> PointResult {
        PointResult {
            verdict: Verdict::Pass,
            acceleration_rms_ms2: 10.001_23,
            sensitivity_v_per_ms2: 0.009_876_543,
            phase_rad: -0.123_456_79,
            inverted: true,
            repeatability_rel: 1.234e-5,
            repeatability_phase_rad: 9.87e-6,
            blocks: 10,
            expanded_uncertainty_rel: 0.007_929_2,
            coverage_factor: 2.0,
            effective_degrees_of_freedom: f32::INFINITY,
            expanded_uncertainty_phase_rad: 0.006_77,
            distortion_reference_rel: 5.3e-5,
            distortion_dut_rel: 6.4e-5,
            signal_to_noise_reference_db: 51.24,
            signal_to_noise_dut_db: 53.06,
            amplitude_stability_rel: 6.5e-5,
            drive_peak_v: 1.107,
            settling_s: 0.3568,
            overshoot_rel: 0.0123,
            coherence: None,
            instrument_temperature_c: Some(47.126),
            ..PointResult::refused(
                PointSpec {
                    frequency_hz: 63.0,
                    acceleration_rms_ms2: 10.0,
                },
                Some(Tone {
                    cycles: 3,
                    period_samples: 2381,
                }),
                Reason::Stopped,
            )
        }
    }

    fn close(value: f32, expected: f32, rel: f64) {
        let error = (f64::from(value) - f64::from(expected)).abs();
        assert!(
            error <= rel * f64::from(expected).abs(),
            "{value} {expected}"
        );
    }

    #[test]
    fn what_is_read_back_is_what_the_table_promises() {
        let (before, after) = (point(), as_stored(&point()));
        assert_eq!(after.spec, before.spec);
        assert_eq!(after.tone, before.tone);
        assert_eq!(after.verdict, before.verdict);
        assert_eq!(after.sensitivity_v_per_ms2, before.sensitivity_v_per_ms2);
        assert_eq!(after.phase_rad, before.phase_rad);
        assert_eq!((after.inverted, after.blocks), (true, 10));
        assert_eq!(after.coverage_factor, 2.0);
        assert_eq!(after.effective_degrees_of_freedom, f32::INFINITY);
        // Half a millionth of the set level, and f32.
        close(
            after.acceleration_rms_ms2,
            before.acceleration_rms_ms2,
            6.0e-7,
        );
        // Half of the last of 16 and of 8 bits of the significand.
        let narrow = 2.0_f64.powi(-16);
        close(
            after.expanded_uncertainty_rel,
            before.expanded_uncertainty_rel,
            narrow,
        );
        close(
            after.expanded_uncertainty_phase_rad,
            before.expanded_uncertainty_phase_rad,
            narrow,
        );
        for (value, expected) in diagnostics(&after).into_iter().zip(diagnostics(&before)) {
            if expected.is_finite() {
                close(value, expected, 2.0_f64.powi(-8));
            }
        }
    }

    #[test]
    fn coherence_is_kept_where_there_is_one() {
        let mut before = point();
        before.coherence = Some(0.998_7);
        let after = as_stored(&before).coherence.expect("kept");
        // The incoherence keeps 8 bits.
        close(1.0 - after, 1.0 - 0.998_7, 2.0_f64.powi(-8));
        let once = as_stored(&before);
        assert_eq!(as_stored(&once), once);
        assert_eq!(as_stored(&point()).coherence, None);
    }

    #[test]
    fn temperatures_are_kept_to_hundredths_and_no_temperature_stays_none() {
        let kept = |temperature_c| {
            let mut point = point();
            point.instrument_temperature_c = temperature_c;
            as_stored(&point).instrument_temperature_c
        };
        assert_eq!(kept(Some(47.126)), Some(47.13));
        assert_eq!(kept(Some(-9.994)), Some(-9.99));
        assert_eq!(kept(Some(1.0e9)), Some(327.67));
        assert_eq!(kept(Some(-1.0e9)), Some(-327.67));
        assert_eq!(kept(Some(f32::NAN)), None);
        assert_eq!(kept(None), None);
    }

    #[test]
    fn storing_twice_changes_nothing_more() {
        let once = as_stored(&point());
        assert_eq!(as_stored(&once), once);
        let refused = PointResult::refused(point().spec, None, Reason::DriveLimit);
        assert_eq!(as_stored(&refused), refused);
    }

    #[test]
    fn a_point_takes_little_more_than_fifty_bytes() {
        let mut buffer = [0; 128];
        let length = postcard::to_slice(&StoredPoint::from(&point()), &mut buffer)
            .expect("fits")
            .len();
        assert!(length <= 52, "{length}");
        let mut plain = [0; 128];
        let before = postcard::to_slice(&point(), &mut plain)
            .expect("fits")
            .len();
        assert!(before > 80, "{before}");
    }

    proptest! {
        #[test]
        fn round_numbers_of_any_kind_come_back_exactly(bits: u32) {
            let value = f32::from_bits(bits);
            let back = f32::from(Round::from(value));
            prop_assert_eq!(back.to_bits(), bits);
        }

        #[test]
        fn hundredths_are_short(hundredths in 0_u32..1 << 20) {
            let value = hundredths as f32 / 100.0;
            let code = Round::from(value);
            prop_assert_eq!(f32::from(code), value);
            prop_assert!(code.0 <= 1 << 21);
        }

        #[test]
        fn shortened_numbers_keep_their_bits(bits: u32) {
            let value = f32::from_bits(bits);
            let back = f32::from(Upper::<2>::from(value));
            if value.is_nan() {
                // Its payload may be lost, and with it that it is none.
                prop_assert!(!back.is_finite());
            } else if value.is_finite() && value.is_normal() {
                prop_assert!(back.is_finite());
                prop_assert!((f64::from(back) / f64::from(value) - 1.0).abs() <= 2.0_f64.powi(-8));
            } else if value.is_infinite() {
                prop_assert_eq!(back, value);
            }
        }

        #[test]
        fn any_point_survives(values in prop::collection::vec(any::<f32>(), 8)) {
            let mut point = point();
            point.acceleration_rms_ms2 = values[0];
            point.sensitivity_v_per_ms2 = values[1];
            point.expanded_uncertainty_rel = values[2];
            point.coverage_factor = values[3];
            point.drive_peak_v = values[4];
            point.spec.acceleration_rms_ms2 = values[5];
            point.spec.frequency_hz = values[6];
            point.settling_s = values[7];
            let stored = as_stored(&point);
            prop_assert_eq!(stored.sensitivity_v_per_ms2.to_bits(), values[1].to_bits());
            prop_assert_eq!(stored.spec.frequency_hz.to_bits(), values[6].to_bits());
        }
    }
}
