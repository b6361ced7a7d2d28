//! Bytes of version 1 are read for ever.
//!
//! The files in `form1/` were written by the firmware's archive on 2026-11-22, before there were
//! sections: a calibration of six points, the log of a change of the reference, and settings.

use calib_core::point_state::{PointState, Reason};
use calib_core::settings::{Distribution, Settings};
use calib_protocol::record::{self, RecordError, RecordKind, digest};
use calib_protocol::stored::{self, MAX_HEAD};
use calib_protocol::{change, form1};

const CALIBRATION: &[u8] = include_bytes!("form1/calibration.calibrec");
const CHANGE: &[u8] = include_bytes!("form1/change.calibrec");
const SETTINGS: &[u8] = include_bytes!("form1/settings.bin");

/// Settings common to all three, but for the table of the reference.
fn check_settings(settings: &Settings) {
    assert_eq!(settings.blocks, 12);
    assert_eq!(settings.reference.serial, "R 1");
    assert_eq!(settings.limits.displacement_peak_m, 0.005);
    assert_eq!(settings.drive_full_scale_peak_v, 10.0);
    assert_eq!(settings.dut_input.volt_per_code, 10.0 / 65_536.0);
    assert_eq!(settings.influences.len(), 15);
    let first = settings.influences[0];
    assert_eq!((first.row, first.value_rel), (2, 0.0025));
    assert_eq!(first.distribution, Distribution::Rectangular);
    // Version 1 kept the factor 1/sqrt(18).
    let Distribution::Special { divisor } = settings.influences[3].distribution else {
        panic!("row 6 is special");
    };
    assert!((f64::from(divisor) / 18.0_f64.sqrt() - 1.0).abs() < 1.0e-6);
    assert_eq!(settings.validate(), Ok(()));
}

#[test]
fn a_calibration_keeps_its_values() {
    let read = record::decode(CALIBRATION).expect("a record");
    assert_eq!(read.sha256, Some(digest(CALIBRATION)));
    assert_eq!(read.head.id, 2);
    assert_eq!(read.head.instrument_serial, "SN-1");
    assert_eq!(read.head.firmware, "0.1.0 0123456789ab");
    assert_eq!(read.head.labels.unix_time_s, 2);
    assert_ne!(read.head.previous_sha256, [0; 32]);
    assert!(read.complete);
    check_settings(&read.settings);
    assert_eq!(read.settings.reference.points.len(), 34);
    // Values by the number 2 that seeded them.
    assert_eq!(read.points.len(), 6);
    for point in &read.points {
        assert_eq!(point.state, PointState::Valid);
        assert_eq!(point.sensitivity_v_per_ms2, 0.01 + 2.0 * 1e-6);
        assert_eq!(point.phase_rad, -0.02);
        assert!((point.distortion_dut_rel - 0.002).abs() < 0.002 / 256.0);
        assert_eq!(point.spec.acceleration_rms_ms2, 10.0);
        assert_eq!(point.instrument_temperature_c, None);
    }
    assert_eq!(read.points[0].spec.frequency_hz, 10_000.0);
    let (summary, settings) = record::inspect(CALIBRATION).expect("a record");
    assert_eq!((summary.points, summary.refused), (6, 0));
    let mut read = Settings::BLANK;
    let bytes = &CALIBRATION[settings];
    assert_eq!(form1::read_settings(bytes, &mut read), Ok(()));
    check_settings(&read);
}

#[test]
fn a_change_of_the_reference_keeps_its_values() {
    let read = change::decode(CHANGE).expect("a change");
    assert_eq!((read.head.id, read.head.labels.unix_time_s), (4, 4));
    check_settings(&read.settings);
    assert_eq!(read.settings.reference.points.len(), 9);
    assert_eq!(read.before.calibration.points.len(), 34);
    let (before, after) = (&read.before.calibration, &read.settings.reference);
    let ratio = after.points[7].sensitivity_v_per_ms2 / before.points[7].sensitivity_v_per_ms2;
    assert!((ratio - 1.002).abs() < 1.0e-6);
    let link = record::hash_link(CHANGE).expect("a record");
    assert_eq!(link.kind, RecordKind::ReferenceChange);
    let found = RecordKind::ReferenceChange;
    assert_eq!(record::decode(CHANGE), Err(RecordError::Kind { found }));
}

#[test]
fn settings_keep_their_values() {
    let mut read = Settings::BLANK;
    assert_eq!(form1::read_settings(SETTINGS, &mut read), Ok(()));
    check_settings(&read);
    assert_eq!(read.reference.points.len(), 9);
}

#[test]
fn a_refused_point_keeps_its_reason() {
    // The state of the first point, behind head, settings, incident, complete, number, frequency,
    // level and tone, becomes refused, clipped: 01 00 for 00.
    let (_, settings) = record::inspect(CALIBRATION).expect("a record");
    let state = settings.end + 3 + 3 + 2 + 2;
    let mut bytes = CALIBRATION[..CALIBRATION.len() - 4].to_vec();
    assert_eq!(bytes[state], 0);
    bytes.splice(state..=state, [1, 0]);
    let checksum = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC)
        .checksum(&bytes)
        .to_le_bytes();
    bytes.extend(checksum);
    let read = record::decode(&bytes).expect("a record");
    assert_eq!(read.points[0].state, PointState::Refused(Reason::Clipped));
    assert_eq!(read.points[0].phase_rad, -0.02);
    let (summary, _) = record::inspect(&bytes).expect("a record");
    assert_eq!((summary.points, summary.refused), (6, 1));
}

#[test]
fn the_stored_form_gives_the_same_line() {
    for whole in [CALIBRATION, CHANGE] {
        let (summary, _) = record::inspect(whole).expect("a record");
        let head = stored::head_of(whole, true).expect("a record");
        let mut front = [0; MAX_HEAD];
        stored::write_head(&head, &mut front).expect("fits");
        assert_eq!(head.summary(&whole[..400]), Ok(summary));
        check_settings(&head.settings_in(whole).expect("settings"));
    }
}

#[test]
fn every_shortening_is_noticed() {
    for whole in [CALIBRATION, CHANGE] {
        for length in 0..whole.len() {
            assert!(record::inspect(&whole[..length]).is_err(), "{length}");
        }
    }
}
