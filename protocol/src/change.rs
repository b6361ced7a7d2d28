//! The log of a change of settings.
//!
//! Every setting shapes a number or a limit, so whoever changes one holds the
//! button on the instrument meanwhile, and the change stays in the chain of
//! records: what was in force, what is from then on, when, and who said so. Its
//! beginning is that of every [`crate::record`].
//!
//! Releases before 2026-11-23 asked for a hand and logged where the calibration
//! of the reference changed, and said of the settings before what is the
//! reference's alone.

use crate::envelope::content_of;
use crate::provenance::Provenance;
use crate::record::{RecordError, RecordHead, RecordKind, encode_change, tame_settings};
use crate::text::tame;
use calib_core::settings::{ReferenceChannel, Settings};
use serde::Serialize;

/// Other settings. It is serialized for people alone; stored by [`encode`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReferenceChange {
    /// Number, place in the hash chain, instrument, time and operator.
    pub head: RecordHead,
    /// All settings in force from here on, those of the reference among them.
    pub settings: Settings,
    /// Settings of the reference's channel in force before.
    pub before: ReferenceChannel,
    /// All settings in force before; none in a log that says only those of the reference.
    pub all_before: Option<Settings>,
}

impl ReferenceChange {
    /// Whether the calibration of the reference changed, the scale of its input or the ratio of the
    /// channels, beside whatever else.
    pub fn concerns_reference(&self) -> bool {
        self.before != self.settings.reference_channel()
    }
}

/// Writes a [`ReferenceChange`] of these fields and returns its length in bytes.
///
/// # Errors
/// [`RecordError::Length`] when the buffer is too small.
pub fn encode(
    head: &RecordHead,
    settings: &Settings,
    before: &Settings,
    provenance: &Provenance,
    buffer: &mut [u8],
) -> Result<usize, RecordError> {
    encode_change(head, settings, before, provenance, buffer)
}

/// Reads a change.
///
/// # Errors
/// Those of [`crate::record::decode`], for this kind.
pub fn decode(bytes: &[u8]) -> Result<ReferenceChange, RecordError> {
    let content = content_of(RecordKind::ReferenceChange, bytes)?;
    let mut settings = Settings::BLANK;
    let mut before = settings.reference_channel();
    let mut all_before = content.read_change(&mut settings, &mut before)?;
    let mut head = content.head()?;
    head.tame();
    all_before
        .iter_mut()
        .chain([&mut settings])
        .for_each(tame_settings);
    tame(&mut before.calibration.serial);
    tame(&mut before.calibration.certificate);
    Ok(ReferenceChange {
        head,
        settings,
        before,
        all_before,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{self, RunLabels, digest, hash_link, inspect};
    use crate::settings_form;
    use crate::stored::{self, MAX_HEAD};

    fn change() -> ReferenceChange {
        let before = Settings::field_calibrator();
        let mut settings = before.clone();
        for row in &mut settings.reference.points {
            row.sensitivity_v_per_ms2 *= 1.01;
        }
        ReferenceChange {
            head: RecordHead {
                id: 9,
                previous_sha256: [7; 32],
                instrument_serial: "A1".try_into().expect("short"),
                firmware: "0.1.0".try_into().expect("short"),
                sample_rate_hz: 50_000.0,
                labels: RunLabels {
                    unix_time_s: 1_795_269_900,
                    operator: "M. Beispiel".try_into().expect("short"),
                    ..RunLabels::BLANK
                },
            },
            settings,
            before: before.reference_channel(),
            all_before: Some(before),
        }
    }

    fn written() -> std::vec::Vec<u8> {
        let change = change();
        let mut bytes = vec![0; 8192];
        let before = change.all_before.expect("written since");
        let provenance = Provenance::UNKNOWN;
        let length = encode(
            &change.head,
            &change.settings,
            &before,
            &provenance,
            &mut bytes,
        )
        .expect("fits");
        bytes.truncate(length);
        bytes
    }

    #[test]
    fn decoding_inverts_encoding_and_no_kind_is_taken_for_the_other() {
        let bytes = written();
        assert_eq!(decode(&bytes), Ok(change()));
        let found = RecordKind::ReferenceChange;
        assert_eq!(record::decode(&bytes), Err(RecordError::Kind { found }));
    }

    #[test]
    fn the_list_and_the_chain_know_it() {
        let bytes = written();
        let (summary, settings) = inspect(&bytes).expect("a record");
        assert_eq!((summary.id, summary.points, summary.refused), (9, 0, 0));
        assert_eq!(summary.kind, RecordKind::ReferenceChange);
        assert_eq!(summary.unix_time_s, 1_795_269_900);
        let mut read = Settings::BLANK;
        assert_eq!(settings_form::read(&bytes[settings], &mut read), Ok(()));
        assert_eq!(read, change().settings);
        let link = hash_link(&bytes).expect("a record");
        assert_eq!((link.id, link.previous_sha256), (9, [7; 32]));
        assert_eq!(link.sha256, digest(&bytes));
        assert_eq!(link.sha256, summary.sha256);
    }

    #[test]
    fn the_stored_form_gives_the_same_line() {
        let mut bytes = written();
        let head = stored::head_of(&bytes, false).expect("a record");
        let mut front = [0; MAX_HEAD];
        stored::write_head(&head, &mut front).expect("fits");
        let (summary, _) = inspect(&bytes).expect("a record");
        stored::cut_out(&head, &mut bytes).expect("its own head");
        assert_eq!(head.summary(&bytes), Ok(summary));
    }

    #[test]
    fn every_flipped_bit_and_every_shortening_is_noticed() {
        let whole = written();
        for bit in 0..whole.len() * 8 {
            let mut bytes = whole.clone();
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert_eq!(decode(&bytes), Err(RecordError::Checksum), "bit {bit}");
        }
        for length in 0..whole.len() {
            assert!(decode(&whole[..length]).is_err(), "{length}");
        }
    }
}
