//! The program itself, over TCP: output, files and exit codes.

use crate::device::Device;
use crate::memory_link::{SharedDevice, shared};
use crate::{tool, words};
use calib_output::conforms::check_output;
use calib_protocol::message::Request;
use std::io::{Read, Write};
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::Output;

/// Serves `device` at a free port of this computer and returns its address.
pub(crate) fn serve(device: Device) -> (SharedDevice, String) {
    let device = shared(device);
    let listener = TcpListener::bind("127.0.0.1:0").expect("a free port");
    let address = format!("tcp:{}", listener.local_addr().expect("address"));
    let served = SharedDevice::clone(&device);
    std::thread::spawn(move || {
        for stream in listener.incoming() {
            let mut stream = stream.expect("connection");
            let mut buffer = [0; 1024];
            while let Ok(count @ 1..) = stream.read(&mut buffer) {
                let mut device = served.lock().expect("device");
                let answer = buffer[..count].iter().flat_map(|byte| device.byte(*byte));
                let answer: Vec<u8> = answer.collect();
                drop(device);
                // A host that is gone is no fault of the next one.
                if stream.write_all(&answer).is_err() {
                    break;
                }
            }
        }
    });
    (device, address)
}

pub(crate) fn calib(directory: &Path, arguments: &[&str]) -> Output {
    let output = tool(directory).args(arguments).output();
    let output = output.expect("calib starts");
    if !output.stdout.is_empty() {
        check_output(&schemas(), arguments, &output.stdout).expect("as in its schema");
    }
    let for_program = arguments.iter().any(|a| a.starts_with("--json"));
    if for_program && !output.status.success() {
        let last = text(&output.stderr);
        let last = last.lines().last().unwrap_or_default().as_bytes();
        check_output(&schemas(), &["error", "--json"], last).expect("one failure");
    }
    output
}

/// The published schemas.
pub(crate) fn schemas() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/schema")
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

pub(crate) fn json(output: &Output) -> serde_json::Value {
    assert!(output.status.success(), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("one JSON document")
}

#[test]
fn a_session_from_info_to_the_file() {
    let directory = tempfile::tempdir().expect("directory");
    let (_, address) = serve(Device::new());
    let go = |arguments: &[&str]| {
        calib(
            directory.path(),
            &[arguments, &["--device", &address]].concat(),
        )
    };
    assert_eq!(json(&go(&["info", "--json"]))["instrument_serial"], "MEM-1");
    std::fs::write(
        directory.path().join("points.csv"),
        "frequency_hz\n80\n160\n",
    )
    .expect("list");
    let run = go(&words("run --points points.csv --serial Müller's --json"));
    let run = json(&run);
    assert_eq!(run["record_id"], 1);
    assert_eq!(run["points"].as_array().expect("points").len(), 2);
    let records = json(&go(&["records", "--json"]));
    assert_eq!(records[0]["dut_serial"], "Müller's");
    let download = json(&go(&["download", "1", "--json"]));
    let file = directory
        .path()
        .join(download["file"].as_str().expect("path"));
    let record = calib_protocol::record::decode(&std::fs::read(file).expect("file"));
    assert_eq!(record.expect("record").points.len(), 2);
    let streamed = go(&["run", "--points", "points.csv", "--json-lines"]);
    let streamed = text(&streamed.stdout);
    let lines: Vec<serde_json::Value> = streamed
        .lines()
        .map(|line| serde_json::from_str(line).expect("an object"))
        .collect();
    let points = lines.iter().filter(|line| line["event"] == "point");
    assert_eq!(points.count(), 2, "{streamed}");
    let last = lines.last().expect("an end");
    assert_eq!(
        (&last["event"], &last["record_id"]),
        (&"result".into(), &2.into())
    );
    let records = text(&go(&["records", "--json-lines"]).stdout);
    assert_eq!(records.lines().count(), 2, "{records}");
    let table = text(&go(&["records"]).stdout);
    assert!(table.starts_with("id  measured"), "{table}");
    assert!(
        table.lines().all(|line| line.chars().count() <= 80),
        "{table}"
    );
}

#[test]
fn progress_and_remarks_stay_off_standard_output() {
    let directory = tempfile::tempdir().expect("directory");
    let (_, address) = serve(Device::new());
    std::fs::write(directory.path().join("p.csv"), "frequency_hz\n80\n160\n").expect("list");
    let run = ["run", "--points", "p.csv", "--device", &address];
    let output = calib(directory.path(), &run);
    assert!(output.status.success(), "{}", text(&output.stderr));
    // Two points, the certificate's U and whose the others are, and the record, each said once.
    assert_eq!(text(&output.stdout).lines().count(), 5);
    let remark = "no --temperature: certificates state U for all that ISO 16063-21, 4.2 allows\n";
    assert_eq!(text(&output.stderr), remark);
    let told = calib(
        directory.path(),
        &[&run[..], &["--temperature", "23"]].concat(),
    );
    assert_eq!(text(&told.stderr), "");
    let quiet = calib(directory.path(), &[&run[..], &["-q"]].concat());
    assert_eq!(text(&quiet.stderr), "");
}

#[test]
fn every_failure_has_its_exit_code_and_a_way_out() {
    let directory = tempfile::tempdir().expect("directory");
    let (device, address) = serve(Device::new());
    std::fs::write(directory.path().join("bad.csv"), "frequency_hz\n-1\n").expect("list");
    // A port nobody listens at: bound, then given back.
    let free = TcpListener::bind("127.0.0.1:0")
        .expect("port")
        .local_addr()
        .expect("address");
    let nobody = format!("tcp:{free}");
    for (arguments, code, words) in [
        (
            &["info", "-d", &nobody][..],
            3,
            "is `calib emulate --tcp PORT` running?",
        ),
        (
            &["info", "-d", "/dev/no-such-port"],
            3,
            "`calib devices` lists the ports",
        ),
        (&["info", "-d", "tcp:nonsense"], 3, "tcp:192.168.0.7:4000"),
        (
            &["download", "9", "-d", &address],
            5,
            "`calib records` lists",
        ),
        (
            &["run", "--points", "bad.csv", "-d", &address],
            6,
            "bad.csv:2",
        ),
        (
            &["run", "--points", "none.csv", "-d", &address],
            1,
            "none.csv",
        ),
        (&["run", "--level", "0", "-d", &address], 2, "--level"),
        (&["frobnicate"], 2, "unrecognized subcommand"),
    ] {
        let output = calib(directory.path(), arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {message}");
        assert!(message.contains(words), "{arguments:?}: {message}");
        assert!(output.stdout.is_empty());
    }
    device.lock().expect("device").protocol_version = 7;
    let output = calib(directory.path(), &["info", "-d", &address]);
    assert_eq!(output.status.code(), Some(4));
    assert!(text(&output.stderr).contains("protocol version 7"));
}

#[test]
fn a_refused_point_ends_in_code_seven() {
    let directory = tempfile::tempdir().expect("directory");
    let (device, address) = serve(Device::new());
    device.lock().expect("device").flash_broken = true;
    std::fs::write(directory.path().join("p.csv"), "frequency_hz\n160\n").expect("list");
    let output = calib(
        directory.path(),
        &["run", "--points", "p.csv", "-d", &address],
    );
    assert_eq!(output.status.code(), Some(7), "{}", text(&output.stderr));
}

#[test]
fn the_help_lists_every_verb_and_the_exit_codes() {
    let help = text(&calib(Path::new("."), &["--help"]).stdout);
    for words in ["devices", "download", "Exit codes:", "CALIB_DEVICE"] {
        assert!(help.contains(words), "{words}");
    }
}

#[test]
fn stop_and_release_reach_the_device_and_say_so_in_json() {
    let (device, address) = serve(Device::with_record(4, 1));
    let go = |arguments: &[&str]| {
        calib(
            Path::new("."),
            &[arguments, &["--json", "-d", &address]].concat(),
        )
    };
    assert_eq!(json(&go(&["stop"]))["stopped"], true);
    assert_eq!(json(&go(&["release", "4"]))["released_through"], 4);
    let requests = device.lock().expect("device").requests.clone();
    assert_eq!(requests.first(), Some(&Request::Stop));
    assert_eq!(requests.last(), Some(&Request::Release { through: 4 }));
}

#[test]
fn a_self_test_that_fails_exits_with_7_and_says_what_to_do() {
    let (device, address) = serve(Device::new());
    let go = |json: &[&str]| {
        calib(
            Path::new("."),
            &[&["selftest", "-d", &address], json].concat(),
        )
    };
    let sound = go(&["--json"]);
    assert_eq!(sound.status.code(), Some(0), "{}", text(&sound.stderr));
    assert_eq!(json(&sound)["lines"][0]["check"], "supply");
    device.lock().expect("device").supply_v = 2.8;
    let low = go(&[]);
    assert_eq!(low.status.code(), Some(7));
    let said = text(&low.stdout);
    for words in [" 1 FAIL", "2.800 V", "3.100 to 3.500", "VDDA"] {
        assert!(said.contains(words), "{words}: {said}");
    }
}

#[test]
fn the_old_name_of_the_logbook_leads_to_the_new_one() {
    let folder = tempfile::tempdir().expect("directory");
    for (old, new) in [
        (&["bench", "records"][..], "`calib logbook`"),
        (
            &["sensors", "list", "--bench", "b.sqlite"],
            "`--logbook FILE`",
        ),
    ] {
        let output = calib(folder.path(), old);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(new), "{said}");
    }
}

#[test]
fn with_json_a_failure_is_one_document_on_standard_error() {
    let (_, address) = serve(Device::new());
    let output = calib(Path::new("."), &["download", "9", "--json", "-d", &address]);
    assert!(output.stdout.is_empty());
    let failure: serde_json::Value = serde_json::from_slice(&output.stderr).expect("a document");
    assert_eq!(failure["exit_code"], 5);
    let hint = failure["hint"].as_str().expect("a way out");
    assert!(hint.contains("calib records"), "{failure}");
}

#[test]
fn a_record_is_drawn_within_80_columns() {
    let directory = tempfile::tempdir().expect("directory");
    let (_, address) = serve(Device::with_record(3, 31));
    let show = ["show", "3", "-d", &address];
    let shown = text(&calib(directory.path(), &show).stdout);
    assert!(
        shown.lines().all(|line| line.chars().count() <= 80),
        "{shown}"
    );
    // One mark a point, as far as columns differ, and one line a point.
    assert!(shown.matches('●').count() > 5, "{shown}");
    assert_eq!(shown.matches("valid").count(), 31, "{shown}");
    let file = ["show", "record-00003.calibrec", "--json"];
    let document = json(&calib(directory.path(), &file));
    assert_eq!(document["points"].as_array().expect("points").len(), 31);
}

#[test]
fn completions_and_man_pages_know_every_verb() {
    let directory = tempfile::tempdir().expect("directory");
    let go = |arguments: &[&str]| calib(directory.path(), arguments);
    for shell in ["bash", "zsh", "fish"] {
        let script = text(&go(&["completions", shell]).stdout);
        for verb in ["certificate", "doctor", "download"] {
            assert!(script.contains(verb), "{shell}: {verb}");
        }
    }
    let pages = json(&go(&["man", "--out", "pages", "--json"]));
    let pages = pages["files"].as_array().expect("files").len();
    // One for the tool, and at least one for each verb of the help.
    assert!(pages > 20, "{pages}");
    let page = std::fs::read_to_string(directory.path().join("pages/calib-download.1"));
    assert!(page.expect("a page").contains(".TH calib-download 1"));
}

#[test]
fn the_doctor_names_what_is_wrong_and_the_way_out() {
    let directory = tempfile::tempdir().expect("directory");
    let (device, address) = serve(Device::new());
    let go = |device: &str| calib(directory.path(), &["doctor", "--json", "-d", device]);
    let states = |output: &Output| -> Vec<(String, String)> {
        let findings: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let findings = findings.as_array().expect("findings").clone();
        let word = |value: &serde_json::Value| value.as_str().expect("a word").to_owned();
        let pair = |f: &serde_json::Value| (word(&f["check"]), word(&f["state"]));
        findings.iter().map(pair).collect()
    };
    let well = go(&address);
    assert!(well.status.success(), "{}", text(&well.stdout));
    for check in ["clock", "ports", "link"] {
        let good = (check.to_owned(), "good".to_owned());
        assert!(states(&well).contains(&good), "{}", text(&well.stdout));
    }
    device.lock().expect("device").protocol_version = 9;
    let other = go(&address);
    assert_eq!(other.status.code(), Some(7));
    assert!(states(&other).contains(&("versions".to_owned(), "failed".to_owned())));
    let gone = go("/dev/no-such-port");
    assert_eq!(gone.status.code(), Some(7));
    assert!(states(&gone).contains(&("rights".to_owned(), "failed".to_owned())));
    assert!(text(&gone.stdout).contains("calib devices"));
}

#[test]
fn risks_of_rules_over_many_sensors_are_those_published() {
    let directory = tempfile::tempdir().expect("directory");
    let risk = |arguments: &[&str]| calib(directory.path(), &[&["risk"], arguments].concat());
    // Deaver: a ratio of four and a tolerance of two standard deviations of the
    // items, so 95.45 % of them are good: 0.8 % and 1.5 %.
    let rows = json(&risk(&words("--ratio 4 --in-tolerance 95.45 --json")));
    let percent = |row: usize, key: &str| 100.0 * rows[row][key].as_f64().expect("a number");
    assert!(
        (percent(0, "false_accept_probability") - 0.8).abs() < 0.05,
        "{rows}"
    );
    assert!(
        (percent(0, "false_reject_probability") - 1.5).abs() < 0.05,
        "{rows}"
    );
    // Root sum square: 0.968246 of the tolerance; less U: 0.75 of it.
    assert!((percent(1, "acceptance_limit_rel") - 75.0).abs() < 1e-9);
    assert!((percent(2, "acceptance_limit_rel") - 96.824_58).abs() < 1e-4);
    let table = text(&risk(&["--ratio", "4"]).stdout);
    assert!(
        table.lines().all(|line| line.chars().count() <= 80),
        "{table}"
    );
    for wrong in [
        &["--ratio", "1"][..],
        &["--ratio", "4", "--in-tolerance", "100"],
    ] {
        assert_eq!(risk(wrong).status.code(), Some(2));
    }
}

#[test]
fn what_a_user_need_not_say_each_time_is_in_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let calib = |arguments: &[&str]| calib(folder.path(), arguments);
    assert!(text(&calib(&["config"]).stdout).contains("nothing is set"));
    for (key, value) in [
        ("operator", "N. N."),
        ("level", "5"),
        ("tolerance", "-5/+10:nominal"),
        ("device", "tcp:127.0.0.1:1"),
    ] {
        assert!(calib(&["config", key, value]).status.success(), "{key}");
    }
    let shown = calib(&["config", "--json"]);
    let shown: serde_json::Value = serde_json::from_slice(&shown.stdout).expect("JSON");
    assert_eq!(shown["set"]["operator"], "N. N.");
    assert_eq!(shown["set"]["tolerance"], "-5/+10:nominal");
    // Help shows what is in force, and the calibrator that is set is the one asked: nobody is there.
    let help = text(&calib(&["run", "--help"]).stdout).to_owned();
    assert!(
        help.contains("[default: 5]") && help.contains("N. N."),
        "{help}"
    );
    let info = calib(&["info"]);
    assert_eq!(info.status.code(), Some(3));
    assert!(text(&info.stderr).contains("127.0.0.1:1"));
    let elsewhere = calib(&["info", "--device", "tcp:127.0.0.1:2"]);
    assert!(text(&elsewhere.stderr).contains("127.0.0.1:2"));
    assert_eq!(calib(&["config", "level", "0"]).status.code(), Some(6));
    assert!(calib(&["config", "--unset", "device"]).status.success());
    // A file that is none is named, by every verb.
    std::fs::write(folder.path().join("config.toml"), "level = 5\nlevle = 5\n").expect("written");
    let wrong = calib(&["devices", "--json"]);
    assert_eq!(wrong.status.code(), Some(6));
    assert!(
        text(&wrong.stderr).contains("config.toml:2"),
        "{}",
        text(&wrong.stderr)
    );
}

#[test]
fn lists_are_stored_chosen_and_removed_and_what_cannot_be_judged_is_not_sent() {
    let directory = tempfile::tempdir().expect("directory");
    std::fs::write(
        directory.path().join("pump.csv"),
        "frequency_hz\n160\n1000\n",
    )
    .expect("list");
    let (device, address) = serve(Device::new());
    let go = |words: &[&str]| {
        let arguments = [&["lists"], words, &["-d", &address]].concat();
        calib(directory.path(), &arguments)
    };
    let store = |more: &[&str]| go(&[&["store", "pump.csv"], more].concat());
    let nominal = ["--sensitivity", "100", "--unit", "mV/g"];
    for (wrong, said) in [
        (vec![], "--tolerance"),
        (vec!["--tolerance", "5"], "nominal"),
        (
            [&nominal[..], &["--tolerance", "2:last"]].concat(),
            "last calibration",
        ),
    ] {
        let refused = store(&wrong);
        assert_eq!(refused.status.code(), Some(2), "{wrong:?}");
        let words = text(&refused.stderr);
        assert!(words.contains(said), "{words}");
    }
    assert!(device.lock().expect("device").lists.all().is_empty());
    let stored = store(&[&nominal[..], &["--tolerance", "5", "--rule", "simple"]].concat());
    assert_eq!(stored.status.code(), Some(0), "{}", text(&stored.stderr));
    let chosen = json(&go(&["choose", "pump", "--json"]));
    let list = &chosen[0];
    assert_eq!(
        (&list["name"], &list["chosen"]),
        (&"pump".into(), &true.into())
    );
    assert_eq!(
        (&list["tolerance"], &list["rule"]),
        (&"5:nominal".into(), &"simple".into())
    );
    assert_eq!(list["points"][1]["frequency_hz"], 1000.0);
    // 100 / 9.80665 = 10.19716 mV/(m/s2).
    let nominal = list["nominal_sensitivity_v_per_ms2"]
        .as_f64()
        .expect("a number");
    assert!((nominal - 0.010_197_16).abs() < 5e-9, "{nominal}");
    let shown = text(&go(&["show"]).stdout);
    assert!(
        shown.contains("100.00000 mV/g") && shown.contains("->"),
        "{shown}"
    );
    let unknown = go(&["choose", "fan"]);
    assert_eq!(unknown.status.code(), Some(5));
    assert_eq!(go(&["choose", "--none"]).status.code(), Some(0));
    let gone = json(&go(&["remove", "pump", "--json"]));
    assert_eq!(gone, serde_json::json!([]));
}
