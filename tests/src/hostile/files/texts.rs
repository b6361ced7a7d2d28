//! Points, settings, particulars of a certificate, TEDS.

use super::{put, read_or_refused};
use crate::hostile::seeds::record as example_record;
use calib_certificate::{Format, Options, Particulars, prepare};
use calib_core::settings::Settings;
use calib_link::session;
use calib_metrology::teds;
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::Request;
use calib_protocol::record;
use std::path::Path;

/// Most points of a run.
const MOST_POINTS: usize = 200;

/// A point list; an odd first byte makes it TOML, an even one CSV. What is read
/// is what an instrument may be asked for.
pub fn points(data: &[u8]) {
    let Some((form, text)) = data.split_first() else {
        return;
    };
    let name = ["points.csv", "points.toml"][usize::from(form % 2)];
    let path = put(name, text);
    let Some(points) = read_or_refused(&path, session::read_points(&path, 10.0)) else {
        return;
    };
    assert!((1..=MOST_POINTS).contains(&points.len()));
    for point in points {
        for value in [point.frequency_hz, point.acceleration_rms_ms2] {
            assert!(value.is_finite() && value > 0.0, "{value}");
        }
    }
}

/// Settings as `calib settings --write` reads them. Those that are valid reach
/// an instrument as they are.
pub fn settings(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else {
        return;
    };
    let Ok(settings) = toml::from_str::<Settings>(text) else {
        return;
    };
    if settings.validate().is_err() {
        return;
    }
    let written = toml::to_string(&settings).expect("settings are a file again");
    assert_eq!(toml::from_str(&written), Ok(settings.clone()));
    let mut buffer = vec![0; MAX_FRAME];
    let request = Request::SettingsWrite(settings.into());
    let length = encode(1, &request, &mut buffer).expect("any valid settings fit");
    let mut receiver = Receiver::new();
    let mut whole = None;
    for byte in &buffer[..length] {
        if let Some(raw) = receiver.push(*byte) {
            let frame = Frame::check(raw).expect("whole");
            whole = Some(frame.message::<Request>().expect("a request"));
        }
    }
    assert_eq!(whole, Some(request));
}

/// The file of a laboratory or of one certificate: refused, or a certificate is
/// made with it in every form but the printed one.
pub fn particulars(data: &[u8]) {
    let path = put("particulars.toml", data);
    let read = Particulars::read(std::slice::from_ref(&path));
    let Some(particulars) = read_or_refused(&path, read) else {
        return;
    };
    let record = record::decode(&example_record()).expect("a record");
    let options = Options {
        particulars,
        ..Options::default()
    };
    for format in [
        Format::Csv,
        Format::Json,
        Format::Html,
        Format::Dcc,
        Format::Uff,
    ] {
        let Ok(prepared) = prepare(&record, &[format], &options) else {
            continue;
        };
        for file in prepared.files {
            expect_a_file_name(&file.name);
            let text = String::from_utf8(file.content).expect("text");
            if format == Format::Dcc {
                expect_xml(&text);
            }
        }
    }
}

/// A name that stays in its folder.
fn expect_a_file_name(name: &str) {
    assert_eq!(Path::new(name).file_name(), Some(name.as_ref()), "{name}");
}

/// XML 1.0, section 2.2: no character that may not occur, and tags that match.
fn expect_xml(text: &str) {
    let forbidden = |c: &char| matches!(*c, '\0'..'\t' | '\x0B' | '\x0C' | '\x0E'..' ' | '\u{FFFE}' | '\u{FFFF}');
    assert_eq!(text.chars().find(forbidden), None, "{text}");
    let mut reader = quick_xml::Reader::from_str(text);
    while reader.read_event().expect("well-formed") != quick_xml::events::Event::Eof {}
}

/// A virtual TEDS: values that are numbers, of a sensor with a number.
pub fn teds(data: &[u8]) {
    let path = put("sensor.teds", data);
    let Some((sensor, bytes)) = read_or_refused(&path, teds::read(&path)) else {
        return;
    };
    assert!(bytes.len() <= data.len());
    assert!((17..=16_381).contains(&sensor.basic.manufacturer_id));
    for value in [
        sensor.sensitivity_v_per_ms2,
        sensor.high_pass_hz,
        sensor.mass_kg,
        sensor.low_pass_hz,
        sensor.resonance_hz,
        sensor.quality_factor,
        sensor.reference_frequency_hz,
    ] {
        assert!(value.is_none_or(|value| value.is_finite() && value > 0.0));
    }
    let _ = sensor.due();
}
