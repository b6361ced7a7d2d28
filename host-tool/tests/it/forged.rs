//! The words of a record or a device forge no line anywhere, and no number that is none passes for a result.

use crate::tool;
use calib_core::point_state::PointState;
use calib_protocol::record::Record;
use calib_record::sample::{bytes, record, text};
use std::path::{Path, PathBuf};

/// A line that would pass for one of ours, and marks that turn the rest of a line round.
const FORGED: &str = "D 1\nPASS 9.99\u{202e}1\r\u{2066}2";

/// A record whose every text is forged.
fn forged() -> Record {
    let mut record = record(&[80.0, 160.0]);
    let labels = &mut record.head.labels;
    labels.dut_model = text(FORGED);
    labels.dut_serial = text(FORGED);
    labels.operator = text(FORGED);
    labels.mounting = text(FORGED);
    record.head.firmware = text(FORGED);
    record.settings.reference.certificate = text(FORGED);
    record
}

fn stored(folder: &Path, record: &Record) -> PathBuf {
    let path = folder.join("record.calibrec");
    std::fs::write(&path, bytes(record)).expect("written");
    path
}

/// Words of the tool about it.
fn said(folder: &Path, arguments: &[&str]) -> String {
    let mut tool = tool(folder);
    tool.env("CALIB_LOGBOOK", folder.join("logbook.sqlite"));
    let output = tool.args(arguments).output().expect("calib starts");
    String::from_utf8(output.stdout).expect("text") + &String::from_utf8_lossy(&output.stderr)
}

/// Fails where a line begins as the forged one, or anything turns a line round.
fn expect_plain(what: &str, text: &str) {
    assert!(
        text.contains("D 1?PASS 9.99?1"),
        "{what} has other words: {text}"
    );
    let forged = text
        .lines()
        .any(|line| line.trim_start().starts_with("PASS 9.99"));
    assert!(!forged, "{what}: a forged line\n{text}");
    let turned = text.contains(['\u{202e}', '\u{2066}']);
    assert!(!turned, "{what}: a line is turned round");
}

#[test]
fn no_text_of_a_record_forges_a_line_in_terminal_certificate_or_csv() {
    let folder = tempfile::tempdir().expect("folder");
    stored(folder.path(), &forged());
    let shown = said(folder.path(), &["show", "record.calibrec"]);
    expect_plain("terminal", &shown);
    let certificate = ["certificate", "record.calibrec", "--format"];
    for format in ["csv", "html", "json"] {
        let out = folder.path().join(format);
        let out_argument = out.to_str().expect("a path");
        let arguments = [&certificate[..], &[format, "--out", out_argument]].concat();
        let printed = said(folder.path(), &arguments);
        let files: Vec<_> = std::fs::read_dir(&out)
            .unwrap_or_else(|error| panic!("{format}: {error}: {printed}"))
            .flatten()
            .collect();
        assert_eq!(files.len(), 1, "{printed}");
        let text = std::fs::read_to_string(files[0].path()).expect("text");
        expect_plain(format, &text);
    }
    let added = said(folder.path(), &["logbook", "add", "record.calibrec"]);
    assert!(!added.contains("PASS 9.99\u{202e}"), "{added}");
    expect_plain(
        "logbook",
        &said(folder.path(), &["logbook", "records", "--json"]),
    );
}

#[test]
fn a_point_that_passed_without_numbers_is_refused_everywhere() {
    let folder = tempfile::tempdir().expect("folder");
    let mut record = record(&[80.0, 160.0]);
    assert_eq!(record.points[1].state, PointState::Valid);
    record.points[1].sensitivity_v_per_ms2 = f32::NAN;
    let path = stored(folder.path(), &record);
    let bytes = std::fs::read(&path).expect("read");
    let read = calib_protocol::record::decode(&bytes).expect("a record");
    assert!(matches!(read.points[1].state, PointState::Refused(_)));
    let json = said(folder.path(), &["show", "record.calibrec", "--json"]);
    let shown: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let points = shown["points"].as_array().expect("points").iter();
    let states: Vec<_> = points.map(|point| point["state"].as_str()).collect();
    assert_eq!(states, [Some("valid"), Some("refused")], "{json}");
    said(folder.path(), &["logbook", "add", "record.calibrec"]);
    let json = said(folder.path(), &["logbook", "records", "--json"]);
    let listed: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(listed[0]["refused"], 1, "{json}");
}
