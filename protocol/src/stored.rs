//! Records as they lie in flash: without settings a neighbour has.
//!
//! A run's settings with the reference's table are a third of a record, and the
//! same in most. In flash they are cut out and named by a checksum; put back
//! where they were, they give the record to the byte.
//!
//! | part | content |
//! |---|---|
//! | head | [`StoredHead`], postcard |
//! | body | the bytes of the record, with or without its settings |

use crate::envelope::Content;
use crate::frame::CRC;
use crate::record::{self, RecordSummary, Sha256Sum};
use calib_core::settings::Settings;
use core::ops::Range;
use postcard::take_from_bytes;
use serde::{Deserialize, Serialize};

/// Everything needed to list a stored record and to put it together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct StoredHead {
    /// SHA-256 of the whole record.
    pub sha256: Sha256Sum,
    /// [`settings_mark`] of its settings.
    pub settings_mark: u32,
    /// Where they begin in the record.
    pub settings_at: u16,
    /// Their length in bytes.
    pub settings_bytes: u16,
    /// They are in the body.
    pub with_settings: bool,
    /// Length of the body in bytes.
    pub body_bytes: u16,
    /// Points.
    pub points: u16,
    /// Points refused.
    pub refused: u16,
}

/// Longest head: the sum, and up to 5, 3 and 1 bytes for each number.
pub const MAX_HEAD: usize = 32 + 5 + 5 * 3 + 1;

impl StoredHead {
    /// Length of the whole record in bytes.
    pub fn record_bytes(&self) -> usize {
        usize::from(self.body_bytes) + self.cut().len()
    }

    /// Gap in the body: range of the record's bytes.
    pub fn cut(&self) -> Range<usize> {
        let at = usize::from(self.settings_at);
        let missing = if self.with_settings {
            0
        } else {
            usize::from(self.settings_bytes)
        };
        at..at + missing
    }

    /// The settings in the whole body, if it has them.
    pub fn settings_in(&self, body: &[u8]) -> Option<Settings> {
        let at = usize::from(self.settings_at);
        let bytes = body.get(at..at + usize::from(self.settings_bytes))?;
        let content = Content::begun(body).ok()?;
        let mut settings = Settings::BLANK;
        let read = content.read_settings(bytes, &mut settings);
        (self.with_settings && read.is_ok()).then_some(settings)
    }

    /// The line of the record list; `body` must hold the record's beginning.
    ///
    /// # Errors
    /// [`StoredError`] when it does not.
    pub fn summary(&self, body: &[u8]) -> Result<RecordSummary, StoredError> {
        let content = Content::begun(body).map_err(|_| StoredError)?;
        let head = content.head().map_err(|_| StoredError)?;
        Ok(RecordSummary {
            id: head.id,
            bytes: self.record_bytes() as u32,
            unix_time_s: head.labels.unix_time_s,
            dut_serial: head.labels.dut_serial,
            points: self.points,
            refused: self.refused,
            sha256: self.sha256,
            kind: content.kind,
        })
    }
}

/// Stored bytes that are no stored record, or too little room for one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct StoredError;

impl core::fmt::Display for StoredError {
    fn fmt(&self, formatter: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        formatter.write_str("content is no stored record")
    }
}

impl core::error::Error for StoredError {}

/// Number by which a stored record names its settings: CRC-32 of their bytes.
pub fn settings_mark(settings: &[u8]) -> u32 {
    CRC.checksum(settings)
}

/// Head of the stored form of `record`.
///
/// # Errors
/// [`StoredError`] when the bytes are no record.
pub fn head_of(record: &[u8], with_settings: bool) -> Result<StoredHead, StoredError> {
    let (summary, settings) = record::inspect(record).map_err(|_| StoredError)?;
    let bytes = record.get(settings.clone()).ok_or(StoredError)?;
    let cut = if with_settings { 0 } else { settings.len() };
    let short = |length: usize| u16::try_from(length).map_err(|_| StoredError);
    Ok(StoredHead {
        sha256: summary.sha256,
        settings_mark: settings_mark(bytes),
        settings_at: short(settings.start)?,
        settings_bytes: short(settings.len())?,
        with_settings,
        body_bytes: short(record.len() - cut)?,
        points: summary.points,
        refused: summary.refused,
    })
}

/// Writes the head; its length in bytes.
///
/// # Errors
/// [`StoredError`] when the buffer is shorter than [`MAX_HEAD`].
pub fn write_head(head: &StoredHead, buffer: &mut [u8]) -> Result<usize, StoredError> {
    let written = postcard::to_slice(head, buffer).map_err(|_| StoredError)?;
    Ok(written.len())
}

/// Cuts the settings out of the record in `buffer`, if the head says so; the
/// body is what is left at its beginning.
///
/// # Errors
/// [`StoredError`] when the head is not that of the record.
pub fn cut_out(head: &StoredHead, buffer: &mut [u8]) -> Result<(), StoredError> {
    let (cut, end) = (head.cut(), head.record_bytes());
    if cut.end > end || end > buffer.len() {
        return Err(StoredError);
    }
    buffer.copy_within(cut.end..end, cut.start);
    Ok(())
}

/// Makes room for the settings in the body at the beginning of `buffer`; where
/// they must be put to make it the record again.
///
/// # Errors
/// [`StoredError`] when the record does not fit the buffer.
pub fn open_up(head: &StoredHead, buffer: &mut [u8]) -> Result<Range<usize>, StoredError> {
    let (cut, body) = (head.cut(), usize::from(head.body_bytes));
    if cut.start > body || head.record_bytes() > buffer.len() {
        return Err(StoredError);
    }
    buffer.copy_within(cut.start..body, cut.end);
    Ok(cut)
}

/// Reads a head; what follows is the body.
///
/// # Errors
/// [`StoredError`].
pub fn head(stored: &[u8]) -> Result<(StoredHead, &[u8]), StoredError> {
    take_from_bytes(stored).map_err(|_| StoredError)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{MAX_POINTS, Record, RecordHead, RunLabels, digest, encode};
    use crate::settings_form::InSections;
    use calib_core::point::{PointResult, PointSpec};
    use calib_core::point_state::{PointState, Reason};
    use calib_core::tone::Tone;
    use heapless::{String, Vec};
    use proptest::prelude::*;

    fn point(frequency_hz: f32, seed: u32) -> PointResult {
        let spec = PointSpec {
            frequency_hz,
            acceleration_rms_ms2: 10.0,
        };
        let tone = Tone::nearest(frequency_hz, 50_000.0);
        let mut point = PointResult::refused(spec, tone, Reason::Clipped);
        if !seed.is_multiple_of(3) {
            point.state = PointState::Valid;
        }
        // Numbers of no special form.
        point.acceleration_rms_ms2 = 10.0 + 1.0e-4 / seed as f32;
        point.sensitivity_v_per_ms2 = 0.1 / (7 + seed) as f32;
        point.coverage_factor = 2.0 + 0.1 / seed as f32;
        point.blocks = 10;
        point.instrument_temperature_c = Some(47.0 + 0.01 * seed as f32);
        let odd = |base: f32| base / (3 + seed) as f32;
        point.phase_rad = odd(1.0);
        point.repeatability_rel = odd(1.0e-4);
        point.repeatability_phase_rad = odd(1.1e-4);
        point.expanded_uncertainty_rel = odd(0.01);
        point.expanded_uncertainty_phase_rad = odd(0.02);
        point.effective_degrees_of_freedom = odd(1.0e4);
        point.distortion_reference_rel = odd(0.01);
        point.distortion_dut_rel = odd(0.02);
        point.signal_to_noise_reference_db = odd(60.0);
        point.signal_to_noise_dut_db = odd(55.0);
        point.amplitude_stability_rel = odd(1.0e-4);
        point.drive_peak_v = odd(1.0);
        point.settling_s = odd(2.0);
        point.overshoot_rel = odd(0.1);
        point
    }

    fn record(points: Vec<PointResult, MAX_POINTS>) -> std::vec::Vec<u8> {
        let record = Record {
            head: RecordHead {
                id: 4711,
                previous_sha256: [0xA5; 32],
                instrument_serial: "23004100075457494E303120".try_into().expect("short"),
                firmware: "0.1.0 0123456789ab-dirty".try_into().expect("short"),
                sample_rate_hz: 50_000.0,
                labels: RunLabels {
                    unix_time_s: 1_795_269_900,
                    dut_model: "Examplia 352C33".try_into().expect("short"),
                    dut_serial: "LW 123456".try_into().expect("short"),
                    operator: "M. Beispiel".try_into().expect("short"),
                    temperature_centi_c: Some(2310),
                    mounting: String::try_from("stud M5, 2 Nm, light oil").expect("short"),
                },
            },
            settings: Settings::field_calibrator(),
            complete: true,
            points,
            ..Record::BLANK
        };
        let mut bytes = vec![0; 32 * 1024];
        let length = encode(&record, &mut bytes).expect("fits");
        bytes.truncate(length);
        bytes
    }

    fn one_third_octaves() -> Vec<PointResult, MAX_POINTS> {
        let list = calib_core::preferred::PREFERRED_HZ.iter().skip(3).take(31);
        (1..).zip(list).map(|(seed, hz)| point(*hz, seed)).collect()
    }

    /// Head and body, as they are stored.
    fn written(record: &[u8], with_settings: bool) -> std::vec::Vec<u8> {
        let found = head_of(record, with_settings).expect("a record");
        let mut bytes = vec![0; MAX_HEAD];
        let length = write_head(&found, &mut bytes).expect("fits");
        bytes.truncate(length);
        let mut body = record.to_vec();
        cut_out(&found, &mut body).expect("its own head");
        bytes.extend_from_slice(&body[..usize::from(found.body_bytes)]);
        bytes
    }

    #[test]
    fn a_record_comes_back_to_the_byte() {
        let record = record(one_third_octaves());
        let mut room = [0; 2048];
        let settings = Settings::field_calibrator();
        let settings = postcard::to_slice(&InSections(&settings), &mut room);
        let settings = settings.expect("fits");
        for with_settings in [false, true] {
            let stored = written(&record, with_settings);
            let (head, body) = head(&stored).expect("a head");
            assert_eq!(head.settings_mark, settings_mark(settings));
            assert_eq!(head.record_bytes(), record.len());
            let mut buffer = vec![0; record.len()];
            buffer[..body.len()].copy_from_slice(body);
            let gap = open_up(&head, &mut buffer).expect("fits");
            if !with_settings {
                buffer[gap].copy_from_slice(settings);
            }
            assert_eq!(buffer, record);
            assert_eq!(digest(&buffer), head.sha256);
        }
    }

    #[test]
    fn five_hundred_records_of_31_points_find_room() {
        // 8 sectors of 128 KiB; each loses two words to its marks, the first
        // record of a sector carries settings, a copy of the settings in force
        // follows it, and every item has a head of 32 bytes, a mark of 2, and
        // is padded to 32.
        let item = |bytes: usize| 32 + (2 + bytes).next_multiple_of(32);
        let points = one_third_octaves();
        assert_eq!(points.len(), 31);
        let record = record(points);
        let short = item(written(&record, false).len());
        let long = item(written(&record, true).len());
        let settings = item(64 + long - short);
        let room = 128 * 1024 - 2 * 32 - long - settings;
        let records = 8 * (1 + room / short);
        println!("{short} bytes each, {long} with settings: {records} records");
        assert!(records >= 500, "{records}");
    }

    #[test]
    fn the_list_needs_no_more_than_the_beginning() {
        let record = record(one_third_octaves());
        for with_settings in [false, true] {
            let stored = written(&record, with_settings);
            let (head, body) = head(&stored[..400]).expect("a head");
            let summary = head.summary(body).expect("its labels");
            let (expected, _) = record::inspect(&record).expect("a record");
            assert_eq!(summary, expected);
            // Seeds 3, 6, ... 30.
            assert_eq!(summary.refused, 10);
        }
    }

    proptest! {
        #[test]
        fn any_bytes_are_read_without_a_panic(
            bytes in proptest::collection::vec(any::<u8>(), 0..400),
        ) {
            if let Ok((head, body)) = head(&bytes) {
                let _ = head.summary(body);
                let mut buffer = vec![0; 1024];
                let _ = open_up(&head, &mut buffer);
                let _ = cut_out(&head, &mut buffer);
            }
        }
    }
}
