//! Settings as they are stored and sent: [`sections`](crate::sections).
//!
//! | id | section | fields |
//! |---|---|---|
//! | 1 | method | method, example, blocks u16 |
//! | 2 | reference | serial number, certificate, day of its calibration u32, day the next is due u32 |
//! | 3 | table of the reference | rows of 5 f32: Hz, V/(m/s2), rad, relative U, U in rad |
//! | 4 | inputs | volt per code of the reference's f32, of the device's f32 |
//! | 5 | exciter | full scale V peak f32, limits f32: V, m/s2, m/s, m peak |
//! | 6 | influences | rows: row u8, relative value f32, value in rad f32, distribution |
//! | 7 | influences that differ from point to point | list of their coefficients, f32 |
//! | 8 | ratio of the channels | day it was measured u32, rows of 5 f32: Hz, 1, rad, relative U, U in rad |
//! | 9 | lease | quiet of all hosts after which a run ends, s, u16 |
//!
//! Rows, scales and limits are written as their types are: a field that one of them gets changes the form.
//! Sections 8 and 9 are written where they say something: the sum over all of them
//! ([`crate::provenance`]) stays what it is when a release adds one. Missing sections are as in [`Settings::BLANK`], which no instrument accepts where it matters.

use crate::error::RecordError;
use crate::sections::{Fields, Optional, Read, fill, find, needed, section, section_unless};
use calib_core::channel_ratio::ChannelRatio;
use calib_core::settings::{PointInfluences, ReferenceCalibration, ReferenceChannel, Settings};
use heapless::Vec;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

const METHOD: u8 = 1;
const REFERENCE: u8 = 2;
const REFERENCE_TABLE: u8 = 3;
const INPUTS: u8 = 4;
const EXCITER: u8 = 5;
const INFLUENCES: u8 = 6;
const POINT_INFLUENCES: u8 = 7;
const CHANNEL_RATIO: u8 = 8;
const LEASE: u8 = 9;

/// Bytes of settings, at most.
pub const LONGEST_SETTINGS: usize = 2048;

/// Id of settings where they are a section themselves.
const SETTINGS: u8 = 1;

/// Settings, to be written in sections.
pub struct InSections<'a>(pub &'a Settings);

impl Serialize for InSections<'_> {
    // Once for each kind of output: the image's slot is small.
    #[inline(never)]
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let settings = self.0;
        let mut point_influences = settings.point_influences;
        let coefficients = point_influences.coefficients_mut().map(|value| *value);
        (
            section(METHOD, (settings.method, settings.example, settings.blocks)),
            Calibration(&settings.reference),
            section(INPUTS, [settings.reference_input, settings.dut_input]),
            section(
                EXCITER,
                (settings.drive_full_scale_peak_v, &settings.limits),
            ),
            section(INFLUENCES, &settings.influences),
            section(POINT_INFLUENCES, coefficients.as_slice()),
            ratio(&settings.channel_ratio),
            section_unless(settings.lease_s == 0, LEASE, settings.lease_s),
        )
            .serialize(serializer)
    }
}

/// The section of the ratio of the channels; none where it was not measured.
fn ratio(ratio: &ChannelRatio) -> Optional<&ChannelRatio> {
    section_unless(*ratio == ChannelRatio::UNKNOWN, CHANNEL_RATIO, ratio)
}

/// The two sections of the reference's calibration.
struct Calibration<'a>(&'a ReferenceCalibration);

impl Serialize for Calibration<'_> {
    // Once for each kind of output: the image's slot is small.
    #[inline(never)]
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ReferenceCalibration {
            serial,
            certificate,
            calibrated_day,
            due_day,
            points,
        } = self.0;
        (
            section(REFERENCE, (serial, certificate, calibrated_day, due_day)),
            section(REFERENCE_TABLE, points),
        )
            .serialize(serializer)
    }
}

/// Reads settings from their sections.
///
/// # Errors
/// [`RecordError::Content`] and [`RecordError::Section`]; what was read until then is in `settings`.
pub fn read(sections: &[u8], settings: &mut Settings) -> Result<(), RecordError> {
    let mut method = needed(sections, METHOD)?;
    settings.method = method.take()?;
    settings.example = method.take()?;
    settings.blocks = method.take()?;
    read_calibration(sections, &mut settings.reference)?;
    let mut inputs = needed(sections, INPUTS)?;
    settings.reference_input = inputs.take()?;
    settings.dut_input = inputs.take()?;
    let mut exciter = needed(sections, EXCITER)?;
    settings.drive_full_scale_peak_v = exciter.take()?;
    settings.limits = exciter.take()?;
    let mut influences = needed(sections, INFLUENCES)?;
    read_rows(&mut influences, &mut settings.influences)?;
    settings.point_influences = PointInfluences::NONE;
    if let Some((_, list)) = find(sections, POINT_INFLUENCES, 1)? {
        read_coefficients(Fields(list), &mut settings.point_influences)?;
    }
    settings.lease_s = 0;
    fill(sections, LEASE, &mut settings.lease_s)?;
    read_ratio(sections, &mut settings.channel_ratio)
}

/// Ratio of the channels; unknown where there is none.
fn read_ratio(sections: &[u8], ratio: &mut ChannelRatio) -> Result<(), RecordError> {
    *ratio = ChannelRatio::UNKNOWN;
    let Some((_, content)) = find(sections, CHANNEL_RATIO, 1)? else {
        return Ok(());
    };
    let mut fields = Fields(content);
    ratio.measured_day = fields.take()?;
    read_rows(&mut fields, &mut ratio.points)
}

/// Coefficients, as many as there are on both sides.
fn read_coefficients(
    mut fields: Fields<'_>,
    influences: &mut PointInfluences,
) -> Result<(), RecordError> {
    let count: usize = fields.take()?;
    for coefficient in influences.coefficients_mut().into_iter().take(count) {
        *coefficient = fields.take()?;
    }
    Ok(())
}

fn read_calibration(
    sections: &[u8],
    calibration: &mut ReferenceCalibration,
) -> Result<(), RecordError> {
    read_identity(&mut needed(sections, REFERENCE)?, calibration)?;
    let mut table = needed(sections, REFERENCE_TABLE)?;
    read_rows(&mut table, &mut calibration.points)
}

/// Serial number, certificate and days of the reference.
pub(crate) fn read_identity(
    fields: &mut Fields<'_>,
    calibration: &mut ReferenceCalibration,
) -> Result<(), RecordError> {
    calibration.serial = fields.take()?;
    calibration.certificate = fields.take()?;
    calibration.calibrated_day = fields.take()?;
    calibration.due_day = fields.take()?;
    Ok(())
}

/// As many rows as the list says, one by one: no list lies on the stack.
pub(crate) fn read_rows<'a, T: Deserialize<'a>, const N: usize>(
    fields: &mut Fields<'a>,
    rows: &mut Vec<T, N>,
) -> Result<(), RecordError> {
    rows.clear();
    let count: usize = fields.take()?;
    for _ in 0..count {
        let pushed = rows.push(fields.take()?);
        pushed.map_err(|_| RecordError::Content)?;
    }
    Ok(())
}

/// The reference's channel before a change of it: sections 2, 3, 4 and 8, of which 4 has one input.
pub(crate) struct Channel<'a>(pub(crate) &'a Settings);

impl Serialize for Channel<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (
            Calibration(&self.0.reference),
            section(INPUTS, self.0.reference_input),
            ratio(&self.0.channel_ratio),
        )
            .serialize(serializer)
    }
}

/// Reads what [`Channel`] writes.
pub(crate) fn read_channel(
    sections: &[u8],
    channel: &mut ReferenceChannel,
) -> Result<(), RecordError> {
    read_calibration(sections, &mut channel.calibration)?;
    channel.input = needed(sections, INPUTS)?.take()?;
    read_ratio(sections, &mut channel.ratio)
}

/// For `#[serde(with)]`: settings in a message, as one section.
pub(crate) fn serialize<S: Serializer>(
    settings: &Settings,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    section(SETTINGS, InSections(settings)).serialize(serializer)
}

/// For `#[serde(with)]`.
pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Settings, D::Error> {
    let (_, version, sections) = Read::deserialize(deserializer)?;
    let mut settings = Settings::BLANK;
    match version {
        1 => read(sections, &mut settings).map_err(D::Error::custom)?,
        _ => return Err(D::Error::custom("settings of another version")),
    }
    Ok(settings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_core::channel_ratio::ChannelRatioPoint;

    fn written(settings: &Settings) -> std::vec::Vec<u8> {
        let mut bytes = vec![0; 2048];
        let length = postcard::to_slice(&InSections(settings), &mut bytes)
            .expect("fits")
            .len();
        bytes.truncate(length);
        bytes
    }

    #[test]
    fn reading_inverts_writing() {
        let mut settings = Settings::field_calibrator();
        settings.reference.serial = "R 1".try_into().expect("short");
        settings.reference.due_day = 20_565;
        settings.channel_ratio.measured_day = 20_779;
        settings.lease_s = 300;
        let row = ChannelRatioPoint {
            frequency_hz: 160.0,
            magnitude: 1.002,
            phase_rad: -0.003,
            expanded_uncertainty_rel: 2e-4,
            expanded_uncertainty_phase_rad: 3e-4,
        };
        settings.channel_ratio.points.extend([row]);
        let mut back = Settings::BLANK;
        assert_eq!(read(&written(&settings), &mut back), Ok(()));
        assert_eq!(back, settings);
    }

    #[test]
    fn what_a_newer_release_adds_is_passed_over() {
        let settings = Settings::field_calibrator();
        let mut bytes = vec![77, 9, 3, 1, 2, 3];
        bytes.extend(written(&settings));
        bytes.extend([78, 1, 0]);
        let mut back = Settings::BLANK;
        assert_eq!(read(&bytes, &mut back), Ok(()));
        assert_eq!(back, settings);
    }

    #[test]
    fn more_rows_than_there_is_room_for_are_refused() {
        let mut settings = Settings::field_calibrator();
        let bytes = written(&settings);
        let (at, _) = find(&bytes, INFLUENCES, 1)
            .expect("sections")
            .expect("there");
        let mut longer = bytes.clone();
        // 21 rows, of which 15 are there.
        longer[at] = 21;
        assert_eq!(read(&longer, &mut settings), Err(RecordError::Content));
    }

    #[test]
    fn every_shortening_is_noticed() {
        let bytes = written(&Settings::field_calibrator());
        let found = find(&bytes, POINT_INFLUENCES, 1).expect("sections");
        let (last, _) = found.expect("there");
        for length in 0..bytes.len() {
            let mut back = Settings::BLANK;
            // Without its last section they are those of a release that did not have it.
            let whole = length == last - 3;
            assert_eq!(read(&bytes[..length], &mut back).is_ok(), whole, "{length}");
        }
    }
}
