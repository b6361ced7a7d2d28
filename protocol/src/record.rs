//! Records: what a calibration leaves behind, as hosts get and keep it.
//!
//! In flash it takes less room: see [`crate::stored`].
//!
//! | bytes | content |
//! |---|---|
//! | 2 | u16 LE: [`RECORD_VERSION`], with the kind in the upper byte |
//! | n | [sections](crate::sections) |
//! | 4 | CRC-32 of everything before, LE |
//!
//! | id | section | fields |
//! |---|---|---|
//! | 1 | head | [`RecordHead`] |
//! | 2 | settings | [`crate::settings_form`] |
//! | 3 | run | incident, complete |
//! | 4 | points | [`crate::stored_point`] |
//! | 5 | before | channel of the reference before a change: [`crate::change`] |
//! | 6 | all before | all settings before a change |
//! | 7 | provenance | [`Provenance`] of the settings |
//! | 9 | image | [`ImageOrigin`]: digest and signer, where a loader has checked it |
//! | 10 | list | [`calib_core::stored_list::ListTerms`] of the list a tap of the button chose |
//! | 11 | clock | [`ClockReading`] of a run without a host |
//! | 12 | closing | [`Closing`], where the first point was repeated at the end |
//! | 8 | signature | [`crate::signature::Signature`] of the instrument, the last of all |
//!
//! The head comes first. Records of version 1 had no sections: they are read, and written no more.

pub use crate::calibration::{MAX_POINTS, Record};
use crate::clock::ClockReading;
pub use crate::envelope::check;
use crate::envelope::{Content, MARK_BYTES, content_of, open, seal};
pub use crate::error::RecordError;
use crate::form1;
pub use crate::head::{RecordHead, RunLabels, Sha256Sum, digest};
use crate::kind::Form;
pub use crate::kind::{RECORD_VERSION, RecordKind};
use crate::lists::tame_terms;
use crate::provenance::Provenance;
use crate::sections::{Fields, Optional, fill, find, needed, section, section_unless};
use crate::settings_form::{self, InSections};
use crate::signature;
use crate::stored_point::{self, InColumns};
use crate::text::tame;
use crate::update::ImageOrigin;
use calib_core::closing::Closing;
use calib_core::point::PointSpec;
use calib_core::settings::{ReferenceChannel, Settings};
use core::ops::Range;
use heapless::String;
use serde::{Deserialize, Serialize};

const HEAD: u8 = 1;
const SETTINGS: u8 = 2;
const RUN: u8 = 3;
const POINTS: u8 = 4;
const BEFORE: u8 = 5;
const ALL_BEFORE: u8 = 6;
const PROVENANCE: u8 = 7;
const IMAGE: u8 = 9;
const LIST: u8 = 10;
const CLOCK: u8 = 11;
const CLOSING: u8 = 12;
const UNTRIED: u8 = 13;

/// One line of the record list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RecordSummary {
    /// Running number.
    pub id: u32,
    /// Stored bytes.
    pub bytes: u32,
    /// Seconds since 1970-01-01 UTC; 0 = not known.
    pub unix_time_s: u64,
    /// Serial number of the device under test.
    pub dut_serial: String<48>,
    /// Points in the record.
    pub points: u16,
    /// Points refused.
    pub refused: u16,
    /// [`digest`] of the record.
    pub sha256: Sha256Sum,
    /// Kind of record.
    pub kind: RecordKind,
}

/// Where a record stands in the hash chain of its instrument.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HashLink {
    /// Kind of record.
    pub kind: RecordKind,
    /// Running number.
    pub id: u32,
    /// Serial number of the instrument.
    pub instrument_serial: String<32>,
    /// [`digest`] of the record before, as stored in this one.
    pub previous_sha256: Sha256Sum,
    /// Its own [`digest`].
    pub sha256: Sha256Sum,
}

/// Writes a record and returns its length in bytes.
///
/// # Errors
/// [`RecordError::Length`] when the buffer is too small.
pub fn encode(record: &Record, buffer: &mut [u8]) -> Result<usize, RecordError> {
    let content = (
        section(HEAD, &record.head),
        section(SETTINGS, InSections(&record.settings)),
        section(RUN, (&record.incident, record.complete)),
        section(POINTS, InColumns(&record.points)),
        origin(&record.provenance),
        section_unless(record.image == ImageOrigin::UNKNOWN, IMAGE, &record.image),
        section_unless(record.list.is_none(), LIST, &record.list),
        section_unless(record.clock == ClockReading::NONE, CLOCK, record.clock),
        section_unless(record.closing == Closing::None, CLOSING, &record.closing),
        section_unless(record.untried.is_empty(), UNTRIED, &record.untried),
    );
    seal(RecordKind::Calibration, &content, buffer)
}

/// Writes the log of a change; see [`crate::change::encode`].
pub(crate) fn encode_change(
    head: &RecordHead,
    settings: &Settings,
    before: &Settings,
    provenance: &Provenance,
    buffer: &mut [u8],
) -> Result<usize, RecordError> {
    let content = (
        section(HEAD, head),
        section(SETTINGS, InSections(settings)),
        // For a reader that knows the reference's alone.
        section(BEFORE, settings_form::Channel(before)),
        section(ALL_BEFORE, InSections(before)),
        origin(provenance),
    );
    seal(RecordKind::ReferenceChange, &content, buffer)
}

/// The section of the provenance; none where nothing is known.
fn origin(provenance: &Provenance) -> Optional<&Provenance> {
    section_unless(*provenance == Provenance::UNKNOWN, PROVENANCE, provenance)
}

impl Content<'_> {
    /// The head, which comes first.
    pub(crate) fn head(self) -> Result<RecordHead, RecordError> {
        match self.form {
            Form::Plain => form1::head(&mut Fields(self.bytes)),
            Form::Sections => form1::head(&mut needed(self.bytes, HEAD)?),
        }
    }

    /// Reads settings of its form.
    pub(crate) fn read_settings(
        self,
        bytes: &[u8],
        settings: &mut Settings,
    ) -> Result<(), RecordError> {
        match self.form {
            Form::Plain => form1::read_settings(bytes, settings),
            Form::Sections => settings_form::read(bytes, settings),
        }
    }

    /// Where the settings lie in it; points, and of them refused.
    fn survey(self) -> Result<(Range<usize>, (u16, u16)), RecordError> {
        if self.form == Form::Plain {
            return form1::survey(self.kind, self.bytes);
        }
        let (at, settings) = find(self.bytes, SETTINGS, 1)?.ok_or(RecordError::Content)?;
        let points = match self.kind {
            RecordKind::Calibration => stored_point::count(needed(self.bytes, POINTS)?)?,
            RecordKind::ReferenceChange => needed(self.bytes, BEFORE).map(|_| (0, 0))?,
        };
        Ok((at..at + settings.len(), points))
    }

    /// Reads the run of a calibration.
    fn read_run(self, record: &mut Record) -> Result<(), RecordError> {
        if self.form == Form::Plain {
            return form1::record(self.bytes, record);
        }
        settings_form::read(needed(self.bytes, SETTINGS)?.0, &mut record.settings)?;
        let mut run = needed(self.bytes, RUN)?;
        record.incident = run.take()?;
        record.complete = run.take()?;
        record.provenance = self.provenance()?;
        fill(self.bytes, IMAGE, &mut record.image)?;
        fill(self.bytes, LIST, &mut record.list)?;
        fill(self.bytes, CLOCK, &mut record.clock)?;
        fill(self.bytes, CLOSING, &mut record.closing)?;
        fill(self.bytes, UNTRIED, &mut record.untried)?;
        // What is no point cannot be measured.
        record.untried.retain(PointSpec::is_usable);
        stored_point::read(needed(self.bytes, POINTS)?, &mut record.points)
    }

    /// Provenance of the settings, unknown where there is none.
    pub(crate) fn provenance(self) -> Result<Provenance, RecordError> {
        let mut provenance = Provenance::UNKNOWN;
        if self.form == Form::Sections {
            fill(self.bytes, PROVENANCE, &mut provenance)?;
        }
        Ok(provenance)
    }

    /// Reads settings and channel of the log of a change, and all settings before where they are there.
    pub(crate) fn read_change(
        self,
        settings: &mut Settings,
        before: &mut ReferenceChannel,
    ) -> Result<Option<Settings>, RecordError> {
        if self.form == Form::Plain {
            form1::change(self.bytes, settings, before)?;
            return Ok(None);
        }
        settings_form::read(needed(self.bytes, SETTINGS)?.0, settings)?;
        settings_form::read_channel(needed(self.bytes, BEFORE)?.0, before)?;
        let Some((_, content)) = find(self.bytes, ALL_BEFORE, 1)? else {
            return Ok(None);
        };
        let mut all = Settings::BLANK;
        settings_form::read(content, &mut all)?;
        Ok(Some(all))
    }
}

/// Where a record of any kind stands in the hash chain.
///
/// # Errors
/// As [`decode`], for any kind.
pub fn hash_link(bytes: &[u8]) -> Result<HashLink, RecordError> {
    let content = open(bytes)?;
    let head = content.head()?;
    Ok(HashLink {
        kind: content.kind,
        id: head.id,
        instrument_serial: head.instrument_serial,
        previous_sha256: head.previous_sha256,
        sha256: digest(bytes),
    })
}

/// Line of the record list for a record, and the place of the settings in its bytes. Of the points only
/// the states of the points are read: that takes little memory, where [`decode`] takes room for the longest record.
///
/// # Errors
/// As [`decode`].
pub fn inspect(bytes: &[u8]) -> Result<(RecordSummary, Range<usize>), RecordError> {
    let content = open(bytes)?;
    let head = content.head()?;
    let (settings, (points, refused)) = content.survey()?;
    if usize::from(points) > MAX_POINTS {
        return Err(RecordError::Content);
    }
    let summary = RecordSummary {
        id: head.id,
        bytes: bytes.len() as u32,
        unix_time_s: head.labels.unix_time_s,
        dut_serial: head.labels.dut_serial,
        points,
        refused,
        sha256: digest(bytes),
        kind: content.kind,
    };
    // Behind the version.
    Ok((
        summary,
        settings.start + MARK_BYTES..settings.end + MARK_BYTES,
    ))
}

/// Texts of settings as words of one line each.
pub(crate) fn tame_settings(settings: &mut Settings) {
    tame(&mut settings.reference.serial);
    tame(&mut settings.reference.certificate);
}

/// Reads the record of a calibration. Its texts are words of one line each ([`crate::text`]), and a point
/// without numbers is no result, whatever its state says.
///
/// # Errors
/// Those of [`check`], [`RecordError::Content`], [`RecordError::Section`] and [`RecordError::Kind`].
pub fn decode(bytes: &[u8]) -> Result<Record, RecordError> {
    let content = content_of(RecordKind::Calibration, bytes)?;
    let mut record = Record {
        head: content.head()?,
        sha256: Some(digest(bytes)),
        signed_by: signature::of(bytes)?.map(|(signature, _)| signature.key),
        ..Record::BLANK
    };
    content.read_run(&mut record)?;
    record.head.tame();
    tame_settings(&mut record.settings);
    record.incident.iter_mut().for_each(tame);
    tame_terms(&mut record.list);
    for point in &mut record.points {
        point.refuse_without_result();
    }
    Ok(record)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::CRC;
    use crate::update::ImageSigner;
    use calib_core::closing::Change;
    use calib_core::point::PointResult;
    use calib_core::point_state::{PointState, Reason};
    use calib_core::stored_list::{Band, Base, ListTerms, Rule};

    fn record() -> Record {
        let head = RecordHead {
            id: 7,
            previous_sha256: [3; 32],
            instrument_serial: "A1".try_into().expect("short"),
            firmware: "0.1.0".try_into().expect("short"),
            sample_rate_hz: 50_000.0,
            ..RecordHead::BLANK
        };
        let complete = true;
        Record {
            head,
            complete,
            ..Record::BLANK
        }
    }

    fn stored() -> std::vec::Vec<u8> {
        let mut bytes = vec![0; 1024];
        let length = encode(&record(), &mut bytes).expect("fits");
        bytes.truncate(length);
        bytes
    }

    #[test]
    fn a_default_run_stays_small() {
        // 31 points with a full table of the reference: 20 bytes a row of the
        // table, and the texts. What the points share stands there once.
        let mut record = record();
        record.settings = Settings::field_calibrator();
        let spec = PointSpec {
            frequency_hz: 31.5,
            acceleration_rms_ms2: 10.0,
        };
        let mut point = PointResult::refused(spec, None, Reason::DriveLimit);
        point.sensitivity_v_per_ms2 = 0.009_8;
        let points = core::iter::repeat_n(point, 31);
        record.points = points.collect();
        let mut bytes = vec![0; 8192];
        let length = encode(&record, &mut bytes).expect("fits");
        assert!(length < 1_400, "{length}");
        let read = decode(&bytes[..length]).expect("whole");
        assert_eq!(read.settings, record.settings);
        assert_eq!(read.points, record.points);
    }

    /// Frequency and level of each, their number, and what says that it is a section: 3. What no run can measure is
    /// not taken from a record that was tampered with.
    #[test]
    fn points_that_were_never_tried_are_kept_and_a_record_without_is_read() {
        let point = |frequency_hz| PointSpec {
            frequency_hz,
            acceleration_rms_ms2: 10.0,
        };
        let mut record = record();
        record.untried = [20.0, 25.0].map(point).into_iter().collect();
        let mut bytes = vec![0; 1024];
        let length = encode(&record, &mut bytes).expect("fits");
        assert_eq!(length, stored().len() + 2 * 8 + 1 + 3);
        let read = decode(&bytes[..length]).expect("whole");
        assert_eq!(read.untried, record.untried);
        assert!(decode(&stored()).expect("whole").untried.is_empty());
        record.untried = [f32::NAN, -1.0, 31.5].map(point).into_iter().collect();
        let length = encode(&record, &mut bytes).expect("fits");
        let read = decode(&bytes[..length]).expect("whole");
        assert_eq!(read.untried[..], [point(31.5)]);
    }

    #[test]
    fn decoding_inverts_encoding() {
        let bytes = stored();
        let read = Record {
            sha256: Some(digest(&bytes)),
            ..record()
        };
        assert_eq!(decode(&bytes), Ok(read));
    }

    /// 32 bytes of digest, the signer, and what says that it is a section: 3.
    #[test]
    fn the_image_that_measured_is_told_and_a_record_without_is_read() {
        let mut record = record();
        record.image = ImageOrigin {
            sha256: [5; 32],
            signer: ImageSigner::Development,
        };
        let mut bytes = vec![0; 1024];
        let length = encode(&record, &mut bytes).expect("fits");
        assert_eq!(length, stored().len() + 32 + 1 + 3);
        let read = decode(&bytes[..length]).expect("whole");
        assert_eq!(read.image, record.image);
        let before = decode(&stored()).expect("whole");
        assert_eq!(before.image, ImageOrigin::UNKNOWN);
    }

    /// Name 6 bytes, nominal 4, unit 5, rule 1, count of bands 1, a band 4 + 4 + 1 + 4 + 4 + 1, and what says
    /// that it is a section: 3.
    #[test]
    fn the_list_and_its_limits_are_told_and_a_record_without_is_read() {
        let band = Band::everywhere(Base::Nominal, 0.05);
        let mut record = record();
        record.list = ListTerms {
            name: "field".try_into().expect("short"),
            nominal_v_per_ms2: 0.0102,
            unit: "mV/g".try_into().expect("short"),
            rule: Rule::GuardBand,
            bands: [band].into_iter().collect(),
        };
        let mut bytes = vec![0; 1024];
        let length = encode(&record, &mut bytes).expect("fits");
        assert_eq!(length, stored().len() + 6 + 4 + 5 + 1 + 1 + 18 + 3);
        let read = decode(&bytes[..length]).expect("whole");
        assert_eq!(read.list, record.list);
        assert!(decode(&stored()).expect("whole").list.is_none());
    }

    #[test]
    fn the_clock_of_a_run_without_a_host_is_told_and_a_record_without_is_read() {
        let mut record = record();
        record.clock = ClockReading {
            told_unix_time_s: 1_800_000_000,
            uncertainty_s: 88,
        };
        let mut bytes = vec![0; 1024];
        let length = encode(&record, &mut bytes).expect("fits");
        // Five bytes and one, and what says that it is a section.
        assert_eq!(length, stored().len() + 5 + 1 + 3);
        assert_eq!(decode(&bytes[..length]).expect("whole").clock, record.clock);
        let before = decode(&stored()).expect("whole");
        assert_eq!(before.clock, ClockReading::NONE);
    }

    #[test]
    fn the_closing_is_told_and_a_record_without_is_read() {
        for (closing, bytes_of_it) in [
            (Closing::Refused(Reason::DutOpen), 2),
            (
                Closing::Changed(Change {
                    magnitude_rel: -0.05,
                    phase_rad: 0.01,
                    noise_rel: 1.0e-4,
                    noise_phase_rad: 1.0e-4,
                }),
                17,
            ),
        ] {
            let mut record = record();
            record.closing = closing;
            let mut bytes = vec![0; 1024];
            let length = encode(&record, &mut bytes).expect("fits");
            // And what says that it is a section.
            assert_eq!(length, stored().len() + bytes_of_it + 3);
            assert_eq!(decode(&bytes[..length]).expect("whole").closing, closing);
        }
        let before = decode(&stored()).expect("whole");
        assert_eq!(before.closing, Closing::None);
    }

    #[test]
    fn the_summary_is_that_of_the_whole_record() {
        let mut record = record();
        record.head.labels.dut_serial = "D 9".try_into().expect("short");
        record.head.labels.unix_time_s = 1_800_000_000;
        for reason in [None, Some(Reason::Clipped), None] {
            let spec = PointSpec {
                frequency_hz: 160.0,
                acceleration_rms_ms2: 10.0,
            };
            let mut point = PointResult::refused(spec, None, reason.unwrap_or(Reason::Stopped));
            if reason.is_none() {
                point.state = PointState::Valid;
            }
            record.points.push(point).expect("room");
        }
        let mut bytes = vec![0; 2048];
        let length = encode(&record, &mut bytes).expect("fits");
        let summary = RecordSummary {
            id: 7,
            bytes: length as u32,
            unix_time_s: 1_800_000_000,
            dut_serial: record.head.labels.dut_serial.clone(),
            points: 3,
            refused: 1,
            sha256: digest(&bytes[..length]),
            kind: RecordKind::Calibration,
        };
        let (found, settings) = inspect(&bytes[..length]).expect("a record");
        assert_eq!(found, summary);
        let mut read = Settings::BLANK;
        assert_eq!(settings_form::read(&bytes[settings], &mut read), Ok(()));
        assert_eq!(read, record.settings);
        assert_eq!(inspect(&bytes[..length - 1]), Err(RecordError::Checksum));
    }

    #[test]
    fn every_flipped_bit_is_noticed() {
        let whole = stored();
        for bit in 0..whole.len() * 8 {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(decode(&bytes), Err(RecordError::Checksum), "bit {bit}");
        }
    }

    #[test]
    fn every_shortened_record_is_refused() {
        let whole = stored();
        for length in 0..whole.len() {
            assert!(decode(&whole[..length]).is_err(), "{length}");
        }
    }

    /// A record whose content is changed by somebody who knows the checksum.
    fn resealed(change: impl FnOnce(&mut std::vec::Vec<u8>)) -> std::vec::Vec<u8> {
        let mut bytes = stored();
        bytes.truncate(bytes.len() - 4);
        change(&mut bytes);
        let checksum = CRC.checksum(&bytes).to_le_bytes();
        bytes.extend(checksum);
        bytes
    }

    #[test]
    fn what_a_newer_release_adds_is_passed_over() {
        let bytes = resealed(|bytes| bytes.extend([99, 7, 3, 1, 2, 3]));
        let read = decode(&bytes).expect("a record");
        assert_eq!(read.settings, record().settings);
        assert_eq!(read.sha256, Some(digest(&bytes)));
        let (summary, _) = inspect(&bytes).expect("a record");
        assert_eq!(summary.bytes as usize, bytes.len());
    }

    #[test]
    fn a_section_of_a_newer_version_is_named() {
        // The head: id 1, version behind it.
        let bytes = resealed(|bytes| bytes[3] = 2);
        let error = RecordError::Section { id: 1, version: 2 };
        assert_eq!(decode(&bytes), Err(error));
        assert!(error.is_of_newer_release());
    }

    #[test]
    fn a_newer_version_is_named() {
        let mut bytes = stored();
        bytes[0] = 9;
        let end = bytes.len() - 4;
        let checksum = CRC.checksum(&bytes[..end]).to_le_bytes();
        bytes[end..].copy_from_slice(&checksum);
        assert_eq!(decode(&bytes), Err(RecordError::Version { found: 9 }));
    }

    #[test]
    fn a_buffer_of_any_short_length_is_refused() {
        for room in 0..stored().len() {
            let mut buffer = vec![0; room];
            assert_eq!(
                encode(&record(), &mut buffer),
                Err(RecordError::Length),
                "{room}"
            );
        }
    }
}
