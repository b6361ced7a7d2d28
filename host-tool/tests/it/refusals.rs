//! Refused points: said with their remedy, not repeated without need, and measured again alone.

use crate::command_line::{calib, json, serve, text};
use crate::device::Device;
use calib_protocol::message::Request;
use std::path::Path;

fn list(folder: &Path, frequencies_hz: &str) {
    let lines = frequencies_hz.replace(' ', "\n");
    std::fs::write(folder.join("p.csv"), format!("frequency_hz\n{lines}\n")).expect("list");
}

#[test]
fn a_list_that_cannot_be_measured_moves_nothing() {
    let folder = tempfile::tempdir().expect("folder");
    let (device, address) = serve(Device::new());
    // The reference is calibrated to 20 kHz; 10 m/s2 at 6 Hz need 9.95 mm of 5.
    list(folder.path(), "160 30000 6");
    let run = ["run", "--points", "p.csv", "-d", &address];
    let output = calib(folder.path(), &run);
    assert_eq!(output.status.code(), Some(6));
    let said = text(&output.stderr);
    assert!(
        said.contains("30000 Hz: this frequency is not available"),
        "{said}"
    );
    assert!(
        said.contains("6 Hz: the level exceeds the displacement limit"),
        "{said}"
    );
    assert!(said.contains("calib settings"), "{said}");
    let device = device.lock().expect("device");
    assert!(
        !device
            .requests
            .iter()
            .any(|r| matches!(r, Request::Start(_)))
    );
}

#[test]
fn a_sensor_that_is_dead_from_the_start_ends_the_list_with_advice() {
    let folder = tempfile::tempdir().expect("folder");
    let frequencies_hz = [
        20.0, 40.0, 80.0, 160.0, 315.0, 630.0, 1250.0, 2500.0, 5000.0,
    ];
    let mut silent = Device::new();
    silent.silent_hz = frequencies_hz.to_vec();
    let (_, address) = serve(silent);
    list(folder.path(), "20 40 80 160 315 630 1250 2500 5000");
    let run = ["run", "--points", "p.csv", "-d", &address];
    let output = calib(folder.path(), &run);
    assert_eq!(output.status.code(), Some(7));
    let shown = text(&output.stdout);
    assert!(shown.contains("Is the cable in"), "{shown}");
    // Nine refusals before.
    assert!(shown.matches("refused").count() < 4, "{shown}");
    assert!(text(&output.stderr).contains("the other points of 9 were not tried"));
}

#[test]
fn retry_measures_what_was_refused_and_nothing_else() {
    let folder = tempfile::tempdir().expect("folder");
    let mut partly = Device::new();
    partly.silent_hz = vec![315.0, 5000.0];
    let (device, address) = serve(partly);
    list(folder.path(), "160 315 1250 5000");
    let run = "run --points p.csv --serial S1 --mounting stud --json";
    let run: Vec<&str> = run.split(' ').chain(["-d", &address]).collect();
    let first = calib(folder.path(), &run);
    assert_eq!(first.status.code(), Some(7));
    let first: serde_json::Value = serde_json::from_slice(&first.stdout).expect("JSON");
    assert_eq!(first["refusals"][0]["reason"], "dut_open");
    assert_eq!(
        first["refusals"][0]["frequencies_hz"],
        serde_json::json!([315.0, 5000.0])
    );
    device.lock().expect("device").silent_hz.clear();
    let record = first["record_id"].to_string();
    let retry = ["run", "--retry", &record, "--json", "-d", &address];
    let again = calib(folder.path(), &retry);
    assert_eq!(again.status.code(), Some(0), "{}", text(&again.stderr));
    let again = json(&again);
    let points = again["points"].as_array().expect("points");
    let hz: Vec<f64> = points
        .iter()
        .filter_map(|p| p["frequency_hz"].as_f64())
        .collect();
    assert_eq!(hz, [315.0, 5000.0]);
    let device = device.lock().expect("device");
    let starts = device
        .requests
        .iter()
        .rev()
        .find_map(|request| match request {
            Request::Start(spec) => Some(spec.labels.clone()),
            _ => None,
        });
    let labels = starts.expect("started");
    assert_eq!(
        (labels.dut_serial.as_str(), labels.mounting.as_str()),
        ("S1", "stud")
    );
    drop(device);
    let nothing = ["run", "--retry", "2", "-d", &address];
    let nothing = calib(folder.path(), &nothing);
    assert_eq!(nothing.status.code(), Some(6));
    assert!(text(&nothing.stderr).contains("a result for every point"));
}

/// Before: a list that ended early was retried at what was refused alone, and the conformity was that of these points.
#[test]
fn what_was_never_tried_is_measured_too_and_the_conformity_is_that_of_both() {
    let folder = tempfile::tempdir().expect("folder");
    let mut dead = Device::new();
    dead.silent_hz = vec![160.0];
    let (device, address) = serve(dead);
    list(folder.path(), "160 315 1250");
    let laboratory = "[decision]\nspecification = 'relative'\ntolerance_percent = 5\n";
    std::fs::write(folder.path().join("l.toml"), laboratory).expect("file");
    let go = |line: &str| {
        let words: Vec<&str> = line.split(' ').chain(["-d", &address]).collect();
        calib(folder.path(), &words)
    };
    let run =
        "run --points p.csv --serial S1 --operator N. --temperature 23 --laboratory l.toml --json";
    let first: serde_json::Value = serde_json::from_slice(&go(run).stdout).expect("JSON");
    assert_eq!(first["conformity_statement"]["conformity"], "not_judgeable");
    assert!(
        first["points"].as_array().expect("points").len() < 3,
        "ended early"
    );
    device.lock().expect("device").silent_hz.clear();
    let id = first["record_id"].to_string();
    let again = go(&format!("run --retry {id} --laboratory l.toml --json"));
    assert_eq!(again.status.code(), Some(0), "{}", text(&again.stderr));
    let again = json(&again);
    let points = again["points"].as_array().expect("points");
    let hz: Vec<&serde_json::Value> = points.iter().map(|point| &point["frequency_hz"]).collect();
    assert_eq!(hz, [160.0, 315.0, 1250.0]);
    assert_eq!(again["conformity_statement"]["conformity"], "pass");
    // What was stated in the morning is stated still.
    let record = again["record_id"].to_string();
    go(&format!("download {record}"));
    let file = format!(
        "record-{:05}.calibrec",
        again["record_id"].as_u64().expect("a number")
    );
    let bytes = std::fs::read(folder.path().join(file)).expect("a record");
    let labels = calib_protocol::record::decode(&bytes)
        .expect("whole")
        .head
        .labels;
    assert_eq!(
        (labels.operator.as_str(), labels.temperature_centi_c),
        ("N.", Some(2300))
    );
    let made = go(&format!(
        "certificate {id} --retried {record} --laboratory l.toml --format json --out c"
    ));
    assert_eq!(made.status.code(), Some(0), "{}", text(&made.stderr));
    let file = folder.path().join(text(&made.stdout).trim());
    let certificate = std::fs::read_to_string(file).expect("written");
    let certificate: serde_json::Value = serde_json::from_str(&certificate).expect("JSON");
    assert_eq!(certificate["points"].as_array().expect("points").len(), 3);
    let said = certificate["calibration"]["retried"]
        .as_str()
        .expect("said");
    assert!(said.starts_with(&format!("record {record} of ")), "{said}");
    let wrong = go(&format!("certificate {record} --retried {id} --out c"));
    assert_eq!(wrong.status.code(), Some(6));
}
