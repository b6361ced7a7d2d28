//! Points as they are stored and sent: their number, then a column for each quantity.
//!
//! A column is a [section](crate::sections) with the values of all points, or with one value that all of
//! them have. [`COLUMNS`] is the only list of them: id, coding, field. A column that is missing leaves
//! the field as [`PointResult::refused`] has it, so a new quantity is a new line with an id of its own.
//!
//! | coding | bytes | kept |
//! |---|---|---|
//! | `f32` | 4 | every bit |
//! | [`Round`] | 2 to 5 | every bit; hundredths in 2 or 3 bytes |
//! | [`Upper3`], [`Upper2`] | 3, 2 | upper bytes of the f32: 1.6e-5, 0.2 % |
//! | `u16`, `bool`, [`PointState`] | 1 to 3 | as postcard writes them |
//! | [`Maybe2`] | 2 | as [`Upper2`], of what may be missing |
//! | [`Incoherence`] | 2 | one less the coherence, to 0.2 % |
//! | [`Temperature`] | 1 to 3 | hundredths of a degree |
//! | acceleration reached | 1 to 5 | millionths of the set level above it |
//!
//! Rounded values are for reading; the host evaluates the budget again where it needs every digit.

use crate::error::RecordError;
use crate::sections::{Fields, Read, find, section};
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::{PointState, Reason};
use heapless::Vec;
use serde::de::Error;
use serde::ser::SerializeTuple;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Longest code of a value, bytes.
const LONGEST_CODE: usize = 5;

/// A value as it is written.
type Code = Vec<u8, LONGEST_CODE>;

/// A quantity of all points.
struct Column {
    /// Section id.
    id: u8,
    /// The value of a point, written.
    write: fn(&PointResult) -> Code,
    /// Reads the value of a point.
    read: fn(&mut PointResult, &mut Fields<'_>) -> Result<(), RecordError>,
}

/// A column with the values of a field, in a coding.
macro_rules! column {
    ($id:expr, $coding:ty, $($field:ident).+) => {
        Column {
            id: $id,
            write: |point| code(<$coding>::from(point.$($field).+)),
            read: |point, fields| {
                point.$($field).+ = fields.take::<$coding>()?.into();
                Ok(())
            },
        }
    };
}

/// The column that tells refused points.
const STATE: u8 = 5;

/// Every column there is, in the order they are written and read.
const COLUMNS: [Column; 29] = [
    column!(1, Round, spec.frequency_hz),
    column!(2, Round, spec.acceleration_rms_ms2),
    column!(3, u16, tone.cycles),
    column!(4, u16, tone.period_samples),
    column!(STATE, PointState, state),
    // Behind the set level, which it is relative to.
    Column {
        id: 6,
        write: |point| code(parts_above(point)),
        read: |point, fields| {
            let level = f64::from(point.spec.acceleration_rms_ms2);
            let above = f64::from(fields.take::<i32>()?) / LEVEL_PARTS;
            point.acceleration_rms_ms2 = (level * (1.0 + above)) as f32;
            Ok(())
        },
    },
    column!(7, f32, sensitivity_v_per_ms2),
    column!(8, f32, phase_rad),
    column!(9, bool, inverted),
    column!(10, Upper3, expanded_uncertainty_rel),
    column!(11, Upper3, expanded_uncertainty_phase_rad),
    column!(12, Upper3, coverage_factor),
    column!(13, Upper2, effective_degrees_of_freedom),
    column!(14, u16, blocks),
    column!(15, Upper2, repeatability_rel),
    column!(16, Upper2, repeatability_phase_rad),
    column!(17, Upper2, distortion_reference_rel),
    column!(18, Upper2, distortion_dut_rel),
    column!(19, Upper2, signal_to_noise_reference_db),
    column!(20, Upper2, signal_to_noise_dut_db),
    column!(21, Upper2, amplitude_stability_rel),
    column!(22, Upper2, drive_peak_v),
    column!(23, Upper2, settling_s),
    column!(24, Upper2, overshoot_rel),
    column!(25, Incoherence, coherence),
    column!(26, Temperature, instrument_temperature_c),
    column!(27, Maybe2, signal_to_noise_worst_block_db),
    column!(28, Upper3, hum_rel),
    column!(29, Upper3, dropout_rel),
];

/// Bytes of a point at most: the columns that take more than three are outweighed by those of two.
pub const LONGEST_POINT: usize = COLUMNS.len() * 3;
/// Bytes of number and headings at most.
pub const LONGEST_HEADINGS: usize = 3 + COLUMNS.len() * 5;

/// The points as they will be read back.
pub(crate) struct InColumns<'a>(pub(crate) &'a [PointResult]);

impl Serialize for InColumns<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut parts = serializer.serialize_tuple(1 + COLUMNS.len())?;
        parts.serialize_element(&(self.0.len() as u16))?;
        for column in &COLUMNS {
            let values = Values(column, self.0);
            parts.serialize_element(&section(column.id, values))?;
        }
        parts.end()
    }
}

/// The values of a column: one, if it is that of all points.
struct Values<'a>(&'a Column, &'a [PointResult]);

impl Serialize for Values<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(column, points) = self;
        let mut codes = points.iter().map(column.write);
        let first = codes.next();
        let differ = codes.any(|code| Some(&code) != first.as_ref());
        let written = if differ { points.len() } else { 1 };
        let mut values = serializer.serialize_tuple(written)?;
        for point in points.iter().take(written) {
            for byte in &(column.write)(point) {
                values.serialize_element(byte)?;
            }
        }
        values.end()
    }
}

/// Reads points.
///
/// # Errors
/// [`RecordError::Content`] and [`RecordError::Section`].
pub(crate) fn read<const N: usize>(
    mut fields: Fields<'_>,
    points: &mut Vec<PointResult, N>,
) -> Result<(), RecordError> {
    let count: u16 = fields.take()?;
    points.clear();
    let resized = points.resize(usize::from(count), nothing());
    resized.map_err(|_| RecordError::Content)?;
    for column in &COLUMNS {
        if let Some((_, values)) = find(fields.0, column.id, 1)? {
            read_column(column, Fields(values), points)?;
        }
    }
    Ok(())
}

fn read_column(
    column: &Column,
    values: Fields<'_>,
    points: &mut [PointResult],
) -> Result<(), RecordError> {
    let mut rest = values;
    let mut points = points.iter_mut();
    if let Some(first) = points.next() {
        (column.read)(first, &mut rest)?;
    }
    let one_for_all = rest.0.is_empty();
    for point in points {
        if one_for_all {
            rest = values;
        }
        (column.read)(point, &mut rest)?;
    }
    match rest.0 {
        [] => Ok(()),
        _ => Err(RecordError::Content),
    }
}

/// Number of points, and of those refused.
///
/// # Errors
/// As [`read`].
pub(crate) fn count(mut fields: Fields<'_>) -> Result<(u16, u16), RecordError> {
    let points: u16 = fields.take()?;
    let Some((_, states)) = find(fields.0, STATE, 1)? else {
        return Ok((points, points));
    };
    let mut rest = Fields(states);
    let (mut read, mut refused) = (0_u16, 0_u16);
    while !rest.0.is_empty() {
        read = read.saturating_add(1);
        refused =
            refused.saturating_add(u16::from(rest.take::<PointState>()? != PointState::Valid));
    }
    match read {
        1 if refused == 1 => Ok((points, points)),
        1 => Ok((points, 0)),
        _ if read == points => Ok((points, refused)),
        _ => Err(RecordError::Content),
    }
}

/// A point before anything of it was read.
fn nothing() -> PointResult {
    let spec = PointSpec {
        frequency_hz: 0.0,
        acceleration_rms_ms2: 0.0,
    };
    PointResult::refused(spec, None, Reason::Stopped)
}

/// A point as it comes back from where it is stored.
pub fn as_stored(point: &PointResult) -> PointResult {
    let mut stored = nothing();
    for column in &COLUMNS {
        let code = (column.write)(point);
        // What was just written can be read.
        let _ = (column.read)(&mut stored, &mut Fields(&code));
    }
    stored
}

/// For `#[serde(with)]`: the result of a point in a message, as one section.
pub(crate) mod result {
    use super::{Deserialize, Serialize, read, section};
    use super::{Deserializer, Error, Fields, InColumns, PointResult, Read, Serializer, Vec};

    /// Id of a point where it is a section itself.
    const POINT: u8 = 1;

    pub(crate) fn serialize<S: Serializer>(
        point: &Option<PointResult>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        section(POINT, InColumns(point.as_slice())).serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<PointResult>, D::Error> {
        let mut points: Vec<PointResult, 1> = Vec::new();
        match Read::deserialize(deserializer)? {
            (_, 1, columns) => read(Fields(columns), &mut points).map_err(D::Error::custom)?,
            _ => return Err(D::Error::custom("a point of another version")),
        }
        Ok(points.pop())
    }
}

/// The bytes of a value.
fn code(value: impl Serialize) -> Code {
    let mut bytes = [0; LONGEST_CODE];
    let written = postcard::to_slice(&value, &mut bytes);
    // No coding takes more; if one did, its column could not be read.
    let written = written.map_or(&[][..], |written| written);
    Code::from_slice(written).unwrap_or_default()
}

/// A round number in 2 to 3 bytes, any other in 5: `200 x` when that is a whole
/// number, else the bits of the f32 and an odd end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Round(u64);

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

/// The upper bytes of an f32, rounded to the nearest.
fn upper<const N: usize>(value: f32) -> [u8; N] {
    let half = 1_u32 << (31 - 8 * N as u32);
    // Rounding must not turn the largest numbers, or NaN, into others.
    let bits = value.to_bits();
    let rounded = match value.is_finite() {
        true if f32::from_bits(bits.wrapping_add(half)).is_finite() => bits.wrapping_add(half),
        _ => bits,
    };
    let mut upper = [0; N];
    let bytes = upper.iter_mut().zip(rounded.to_be_bytes());
    bytes.for_each(|(to, from)| *to = from);
    upper
}

/// The f32 with these upper bytes.
pub(crate) fn from_upper<const N: usize>(upper: [u8; N]) -> f32 {
    let mut bytes = [0; 4];
    let pairs = bytes.iter_mut().zip(upper);
    pairs.for_each(|(to, from)| *to = from);
    f32::from_be_bytes(bytes)
}

/// The upper three bytes of an f32.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Upper3([u8; 3]);

impl From<f32> for Upper3 {
    fn from(value: f32) -> Self {
        Self(upper(value))
    }
}

impl From<Upper3> for f32 {
    fn from(Upper3(bytes): Upper3) -> Self {
        from_upper(bytes)
    }
}

/// The upper two bytes of an f32.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Upper2([u8; 2]);

impl From<f32> for Upper2 {
    fn from(value: f32) -> Self {
        Self(upper(value))
    }
}

impl From<Upper2> for f32 {
    fn from(Upper2(bytes): Upper2) -> Self {
        from_upper(bytes)
    }
}

/// The upper two bytes of an f32 that may be missing: not a number then.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Maybe2(Upper2);

impl From<Option<f32>> for Maybe2 {
    fn from(value: Option<f32>) -> Self {
        Self(value.unwrap_or(f32::NAN).into())
    }
}

impl From<Maybe2> for Option<f32> {
    fn from(Maybe2(value): Maybe2) -> Self {
        Some(f32::from(value)).filter(|value| !value.is_nan())
    }
}

/// One less a coherence, if there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Incoherence(Maybe2);

impl From<Option<f32>> for Incoherence {
    fn from(coherence: Option<f32>) -> Self {
        Self(coherence.map(|coherence| 1.0 - coherence).into())
    }
}

impl From<Incoherence> for Option<f32> {
    fn from(Incoherence(value): Incoherence) -> Self {
        Self::from(value).map(|incoherence| 1.0 - incoherence)
    }
}

/// Hundredths of a degree, up to 327 degrees, far beyond any silicon; [`i16::MIN`] where none was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Temperature(pub(crate) i16);

impl From<Option<f32>> for Temperature {
    fn from(celsius: Option<f32>) -> Self {
        Self(match celsius {
            Some(value) if value.is_finite() => {
                let nearest = nearest(f64::from(value) * 100.0);
                nearest.clamp(-i32::from(i16::MAX), i32::from(i16::MAX)) as i16
            }
            _ => i16::MIN,
        })
    }
}

impl From<Temperature> for Option<f32> {
    fn from(Temperature(hundredths): Temperature) -> Self {
        (hundredths != i16::MIN).then(|| f32::from(hundredths) / 100.0)
    }
}

/// Acceleration is stored in these parts of the set level.
pub(crate) const LEVEL_PARTS: f64 = 1.0e6;

/// Acceleration reached above the set level, in parts of it.
fn parts_above(point: &PointResult) -> i32 {
    let level = f64::from(point.spec.acceleration_rms_ms2);
    nearest((f64::from(point.acceleration_rms_ms2) / level - 1.0) * LEVEL_PARTS)
}

/// Nearest whole number; what is not a number becomes 0.
fn nearest(value: f64) -> i32 {
    let half = if value < 0.0 { -0.5 } else { 0.5 };
    (value + half) as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::tone::Tone;
    use proptest::prelude::*;

    fn point() -> PointResult {
        PointResult {
            state: PointState::Valid,
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
        assert_eq!(after.state, before.state);
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
        let (mut before, mut after) = (before, after);
        for (value, expected) in diagnostics_mut(&mut after)
            .into_iter()
            .zip(diagnostics_mut(&mut before))
        {
            if expected.is_finite() {
                close(*value, *expected, 2.0_f64.powi(-8));
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

    fn written(points: &[PointResult]) -> std::vec::Vec<u8> {
        let mut bytes = vec![0; 32 * 1024];
        let written = postcard::to_slice(&InColumns(points), &mut bytes);
        written.expect("fits").to_vec()
    }

    fn read_back(bytes: &[u8]) -> Result<Vec<PointResult, 200>, RecordError> {
        let mut points = Vec::new();
        read(Fields(bytes), &mut points).map(|()| points)
    }

    #[test]
    fn points_come_back_in_their_order() {
        let mut points = [as_stored(&point()); 5];
        points[1].spec.frequency_hz = 80.0;
        points[1].tone.cycles = 9;
        points[3] = PointResult::refused(points[3].spec, None, Reason::DriveLimit);
        points[4].coherence = Some(0.5);
        let points = points.map(|point| as_stored(&point));
        for count in 0..=points.len() {
            let bytes = written(&points[..count]);
            let back = read_back(&bytes).expect("points");
            assert_eq!(back, points[..count]);
            let refused = back.iter().filter(|p| p.state != PointState::Valid).count();
            let expected = (count as u16, refused as u16);
            assert_eq!(super::count(Fields(&bytes)), Ok(expected));
        }
        let all_refused = written(&[points[3]; 4]);
        assert_eq!(super::count(Fields(&all_refused)), Ok((4, 4)));
    }

    #[test]
    fn what_all_points_share_is_written_once() {
        let (one, many) = (written(&[point()]), written(&[point(); 40]));
        // The number alone: 1 and 40 take a byte each.
        assert_eq!(one.len(), many.len());
    }

    #[test]
    fn a_column_of_more_or_fewer_values_than_points_is_refused() {
        let mut points = [point(); 3];
        points[1].blocks = 11;
        let bytes = written(&points);
        let whole = read_back(&bytes);
        assert!(whole.is_ok());
        for count in [2, 4] {
            let mut other = bytes.clone();
            other[0] = count;
            assert_eq!(read_back(&other), Err(RecordError::Content), "{count}");
        }
    }

    #[test]
    fn a_column_of_a_newer_release_is_passed_over_and_a_missing_one_is_none() {
        let point = as_stored(&point());
        let mut bytes = written(&[point]);
        bytes.extend([200, 1, 2, 7, 7]);
        assert_eq!(read_back(&bytes).as_deref(), Ok(&[point][..]));
        // The last four columns away: 3, 3, 2 and 2 bytes of content, 3 of each heading, 5 just added.
        bytes.truncate(bytes.len() - 5 - 6 - 6 - 5 - 5);
        let older = PointResult {
            coherence: None,
            instrument_temperature_c: None,
            ..point
        };
        assert_eq!(read_back(&bytes).as_deref(), Ok(&[older][..]));
    }

    #[test]
    fn no_point_is_longer_than_the_longest() {
        // Numbers of no special form and not the same in any two points, so that no column is short.
        let mut points = [point(); 200];
        for (point, number) in points.iter_mut().zip(0_u16..) {
            let odd = |base: f32| base + f32::from(number);
            point.spec.frequency_hz = odd(1.0e9 + 0.123);
            point.spec.acceleration_rms_ms2 = odd(1.0e9);
            point.acceleration_rms_ms2 = odd(1.0e3) * point.spec.acceleration_rms_ms2;
            point.tone = Tone {
                cycles: u16::MAX - number,
                period_samples: u16::MAX - number,
            };
            point.state = PointState::Refused(Reason::Clipped);
            if number == 1 {
                point.state = PointState::Refused(Reason::Stopped);
            }
            point.sensitivity_v_per_ms2 = odd(0.5);
            point.phase_rad = odd(0.5);
            point.inverted = number % 2 == 0;
            point.expanded_uncertainty_rel = odd(0.5);
            point.expanded_uncertainty_phase_rad = odd(0.5);
            point.coverage_factor = odd(0.5);
            point.blocks = u16::MAX - number;
            for value in diagnostics_mut(point) {
                *value = odd(0.5);
            }
            point.coherence = Some(odd(-9.0));
            point.instrument_temperature_c = Some(300.0 + 0.01 * f32::from(number));
        }
        let length = written(&points).len();
        assert!(length > 200 * 70, "{length}");
        assert!(length <= 200 * LONGEST_POINT + LONGEST_HEADINGS, "{length}");
    }

    #[test]
    fn no_id_stands_for_two_columns() {
        let ids = COLUMNS.map(|column| column.id);
        assert!(ids.is_sorted_by(|a, b| a < b), "{ids:?}");
    }

    fn diagnostics_mut(point: &mut PointResult) -> [&mut f32; 11] {
        [
            &mut point.repeatability_rel,
            &mut point.repeatability_phase_rad,
            &mut point.effective_degrees_of_freedom,
            &mut point.distortion_reference_rel,
            &mut point.distortion_dut_rel,
            &mut point.signal_to_noise_reference_db,
            &mut point.signal_to_noise_dut_db,
            &mut point.amplitude_stability_rel,
            &mut point.drive_peak_v,
            &mut point.settling_s,
            &mut point.overshoot_rel,
        ]
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
            let back = f32::from(Upper2::from(value));
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
