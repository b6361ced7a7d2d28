//! The logbook: kept, listed, issued, exported, damaged.

use crate::command_line::{calib, json, serve, text};
use crate::device::{Device, record};
use crate::python;
use crate::{tool, typed, words};
use calib_logbook::{Filter, Issue, Kept, Logbook, Sensor, export};
use calib_protocol::change;
use calib_protocol::record::{RecordKind, digest};
use calib_record::sample::bytes;
use std::path::Path;

/// A year of 365.25 days, s.
const YEAR_S: u64 = 31_557_600;

/// Record `id` of a sensor, `years` later, with another sensitivity.
pub(crate) fn later(id: u32, sensor: &str, years: u64, factor: f32) -> Vec<u8> {
    after(id, sensor, years * YEAR_S, factor)
}

/// Record `id` of a sensor, `days` later.
pub(crate) fn on_day(id: u32, sensor: &str, days: u64, factor: f32) -> Vec<u8> {
    after(id, sensor, days * 86_400, factor)
}

fn after(id: u32, sensor: &str, seconds: u64, factor: f32) -> Vec<u8> {
    let mut record = record(id, 3);
    record.head.labels.unix_time_s += seconds;
    record.head.labels.dut_serial = sensor.try_into().expect("short");
    record.head.labels.operator = "N. N.".try_into().expect("short");
    for point in &mut record.points {
        point.sensitivity_v_per_ms2 *= factor;
    }
    bytes(&record)
}

pub(crate) fn logbook(folder: &Path) -> Logbook {
    Logbook::open(&folder.join("logbook.sqlite")).expect("a logbook")
}

#[test]
fn a_record_is_kept_once_and_comes_back_byte_for_byte() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    let (one, two) = (later(1, "A", 0, 1.0), later(2, "B", 1, 1.0));
    let Kept::Added(id) = logbook.keep(&one).expect("kept") else {
        panic!("it is new");
    };
    assert_eq!(logbook.keep(&one).expect("known"), Kept::Known(id));
    logbook.keep(&two).expect("kept");
    assert_eq!(logbook.record(id).expect("there"), one);
    assert_eq!(logbook.record(99).expect_err("none").exit_code(), 6);
    let serials = |filter: &Filter| -> Vec<String> {
        let records = logbook.records(filter).expect("a list");
        records.into_iter().map(|r| r.sensor_serial).collect()
    };
    assert_eq!(serials(&Filter::default()), ["B", "A"], "newest first");
    let of = |sensor: &str| Filter {
        sensor: Some(sensor.to_owned()),
        ..Filter::default()
    };
    assert_eq!(serials(&of("A")), ["A"]);
    assert!(serials(&of("a' OR 1=1 --")).is_empty());
    let time_s = record(1, 0).head.labels.unix_time_s as i64;
    let before = Filter {
        before_s: Some(time_s + 1),
        ..Filter::default()
    };
    assert_eq!(serials(&before), ["A"]);
    assert_eq!(logbook.operators().expect("operators")[0].name, "N. N.");
    assert_eq!(
        logbook.instruments().expect("instruments")[0].serial,
        "MEM-1"
    );
    let nonsense = logbook.keep(b"no record").expect_err("refused");
    assert_eq!(nonsense.exit_code(), 6);
    assert_eq!(logbook.inspect().expect("readable"), Vec::<String>::new());
}

/// A laboratory keeps what it downloads: without it the chain of the records has a gap.
#[test]
fn the_log_of_a_change_of_the_reference_is_kept_like_any_record() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    let run = record(3, 1);
    let (mut head, mut settings) = (run.head.clone(), run.settings.clone());
    head.id = 4;
    head.labels.dut_serial.clear();
    head.labels.operator = "M. Beispiel".try_into().expect("short");
    head.labels.unix_time_s += YEAR_S;
    settings.reference.certificate = "R-2027-01".try_into().expect("short");
    let mut change = vec![0; 8192];
    let length = change::encode(
        &head,
        &settings,
        &run.settings,
        &run.provenance,
        &mut change,
    )
    .expect("fits");
    change.truncate(length);
    logbook.keep(&bytes(&run)).expect("kept");
    let Kept::Added(id) = logbook.keep(&change).expect("kept too") else {
        panic!("it is new");
    };
    assert_eq!(logbook.keep(&change).expect("known"), Kept::Known(id));
    assert_eq!(logbook.record(id).expect("there"), change);
    let numbered = logbook
        .numbered(&head.instrument_serial, 0, 4)
        .expect("read");
    assert_eq!(numbered, Some(change));
    let listed = logbook.records(&Filter::default()).expect("a list");
    let kinds: Vec<_> = listed.iter().map(|line| (line.kind, line.points)).collect();
    let (log, calibration) = (RecordKind::ReferenceChange, RecordKind::Calibration);
    assert_eq!(kinds, [(log, 0), (calibration, 1)], "newest first");
    let instruments = logbook.instruments().expect("instruments");
    assert_eq!(instruments[0].reference_certificate, "R-2027-01");
    assert_eq!(
        logbook.operators().expect("operators")[0].name,
        "M. Beispiel"
    );
    assert_eq!(logbook.inspect().expect("readable"), Vec::<String>::new());
}

#[test]
fn a_flipped_bit_in_a_record_or_in_the_list_is_found() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("logbook.sqlite");
    let content = later(1, "needle-in-the-list", 0, 1.0);
    logbook(folder.path()).keep(&content).expect("kept");
    let whole = std::fs::read(&path).expect("file");
    let places = |needle: &[u8]| -> Vec<usize> {
        let windows = whole.windows(needle.len()).enumerate();
        windows
            .filter(|(_, w)| *w == needle)
            .map(|(at, _)| at)
            .collect()
    };
    // In the middle of the record's bytes, and in the serial number of the list.
    let in_record = places(&content[..200])[0] + 190;
    let name = places(b"needle-in-the-list");
    let in_list = *name
        .iter()
        .find(|at| !(in_record - 190..in_record + 10).contains(at))
        .expect("also in the list");
    for place in [in_record, in_list] {
        let mut damaged = whole.clone();
        damaged[place] ^= 1;
        std::fs::write(&path, &damaged).expect("written");
        let logbook = Logbook::open(&path).expect("the file is one still");
        let wrong = logbook.inspect().expect("readable");
        assert!(!wrong.is_empty(), "byte {place}");
    }
    let mut damaged = whole;
    damaged[in_record] ^= 1;
    std::fs::write(&path, &damaged).expect("written");
    let error = Logbook::open(&path)
        .expect("logbook")
        .record(1)
        .expect_err("damaged");
    assert!(error.to_string().contains("SHA-256"), "{error}");
}

#[test]
fn an_issued_certificate_is_never_changed() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    let issue = |content: &'static [u8], format: &'static str| Issue {
        certificate: "C-1",
        format,
        file: "c.csv",
        content,
        record: digest(b"record"),
        signed: None,
        joined: &[],
        replaces: None,
    };
    logbook.issue(&[issue(b"one", "csv")], 10).expect("issued");
    logbook
        .issue(&[issue(b"one", "csv")], 20)
        .expect("the same");
    let error = logbook.issue(&[issue(b"x", "html"), issue(b"two", "csv")], 30);
    let error = error.expect_err("another content");
    assert!(error.hint().expect("way out").contains("number"), "{error}");
    logbook
        .issue(&[issue(b"two", "json")], 40)
        .expect("another form");
    let issued = logbook.certificates().expect("list");
    let line = |n: usize| {
        (
            issued[n].number,
            issued[n].format.as_str(),
            issued[n].issued_s,
        )
    };
    assert_eq!(
        (issued.len(), line(0), line(1)),
        (2, (1, "csv", 10), (2, "json", 40))
    );
    // printf one | sha256sum
    assert!(issued[0].sha256.starts_with("7692c3ad3540bb80"));
    let raw = rusqlite::Connection::open(logbook.path()).expect("the file");
    for change in [
        "DELETE FROM certificates",
        "UPDATE certificates SET file = 'x'",
    ] {
        let error = raw.execute(change, []).expect_err(change);
        assert!(error.to_string().contains("issued certificate"), "{error}");
    }
}

#[test]
fn a_sensor_of_any_name_is_found_again() {
    let folder = tempfile::tempdir().expect("folder");
    let logbook = logbook(folder.path());
    let sensor = Sensor {
        serial: "O'Neill \u{1f4a5} \"1\"; --".to_owned(),
        manufacturer: "Müller & Söhne".to_owned(),
        sensitivity: Some(0.01),
        ..Sensor::default()
    };
    logbook.add_sensor(&sensor).expect("added");
    assert_eq!(
        logbook.sensor(&sensor.serial).expect("found"),
        Some(sensor.clone())
    );
    assert_eq!(logbook.sensors("o'neill").expect("list").len(), 1);
    assert_eq!(
        logbook.add_sensor(&sensor).expect_err("twice").exit_code(),
        6
    );
    for wrong in [
        Sensor {
            serial: " ".to_owned(),
            ..Sensor::default()
        },
        Sensor {
            sensitivity: Some(f64::NAN),
            ..sensor.clone()
        },
        Sensor {
            due_day: Some("soon".to_owned()),
            ..sensor
        },
    ] {
        assert_eq!(
            logbook.put_sensor(&wrong).expect_err("refused").exit_code(),
            2
        );
    }
}

/// A device of 32 kHz on a mount that resonates at 45 kHz: the logbook knows the data sheet, and what is made of the record
/// says that the mount gives way; without the sheet nobody can know.
#[test]
fn a_data_sheet_that_is_known_tells_a_mount_that_gives_way() {
    let folder = tempfile::tempdir().expect("folder");
    let mut record = calib_record::sample::record(&calib_record::sample::THIRD_OCTAVES_HZ);
    record.settings.point_influences.mounting_at_10_khz_rel = 0.0075;
    for point in &mut record.points {
        let ratio = point.spec.frequency_hz / 45.0e3;
        point.sensitivity_v_per_ms2 /= 1.0 - ratio * ratio;
    }
    std::fs::write(folder.path().join("r.calibrec"), bytes(&record)).expect("written");
    let go = |arguments: &[&str]| calib(folder.path(), arguments);
    let said = |shown: &serde_json::Value| -> Vec<String> {
        let remarks = shown["remarks"].as_array().expect("remarks");
        let keys = remarks
            .iter()
            .map(|remark| remark["key"].as_str().unwrap_or_default());
        keys.map(str::to_owned).collect()
    };
    let show = || json(&go(&["show", "r.calibrec", "--json"]));
    let untold = show();
    assert!(!said(&untold).contains(&"mount_gives_way".to_owned()));
    let serial = record.head.labels.dut_serial.as_str();
    for (wrong, words) in [("32", "500 Hz"), ("-1", "500 Hz"), ("nan", "a number")] {
        let resonance = format!("--resonance={wrong}");
        let output = go(&["sensors", "add", "--serial", serial, &resonance]);
        assert_eq!(output.status.code(), Some(2), "{wrong}");
        assert!(
            text(&output.stderr).contains(words),
            "{}",
            text(&output.stderr)
        );
    }
    json(&go(&[
        "sensors",
        "add",
        "--serial",
        serial,
        "--resonance",
        "32000",
        "--json",
    ]));
    let told = show();
    assert!(
        said(&told).contains(&"mount_gives_way".to_owned()),
        "{:?}",
        said(&told)
    );
    assert_eq!(told["mounted_resonance"]["data_sheet_hz"], 32_000.0);
    let u = |shown: &serde_json::Value| {
        shown["points"][27]["expanded_uncertainty_rel"]
            .as_f64()
            .expect("10 kHz")
    };
    // By hand: 1/(1 - (10/45)^2) - 1 = 5.2 %, as it reads at 10 kHz.
    assert!(
        u(&told) > 0.052 && u(&untold) < 0.04,
        "{} {}",
        u(&told),
        u(&untold)
    );
    let shown = text(&go(&["show", "r.calibrec"]).stdout);
    assert!(
        shown.contains("mounted resonance, effective: 26."),
        "{shown}"
    );
}

#[test]
fn the_export_is_read_by_duckdb_as_it_was_kept() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    for years in 0..3 {
        let id = years as u32 + 1;
        logbook
            .keep(&later(id, "D'1", years, 1.0 + 0.01 * years as f32))
            .expect("kept");
    }
    let sensor = Sensor {
        serial: "D'1".to_owned(),
        iepe: Some(true),
        ..Sensor::default()
    };
    logbook.add_sensor(&sensor).expect("added");
    let data = folder.path().join("data");
    let files = export(&logbook, &data).expect("exported");
    assert!(files.iter().all(|file| file.is_file()));
    let again = export(&logbook, &data).expect_err("not over another");
    assert_eq!(again.exit_code(), 6);
    let script = "
import duckdb, json, sys
d = sys.argv[1]
points = f\"read_parquet('{d}/points/*/*.parquet', hive_partitioning = true)\"
print(json.dumps({
    'years': duckdb.sql(f'select distinct year from {points} order by 1').fetchall(),
    'sum': duckdb.sql(f'select count(*), sum(sensitivity_v_per_ms2) from {points}').fetchone(),
    'time_ms': duckdb.sql(f'select epoch_ms(min(time)) from {points}').fetchone()[0],
    'sensor': duckdb.sql(f\"select serial, iepe, owner from '{d}/sensors/*.parquet'\").fetchone(),
}))";
    let Some(output) = python::run(script, &[&data]) else {
        return;
    };
    assert!(output.status.success(), "{}", text(&output.stderr));
    let read: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(read["years"], serde_json::json!([[2026], [2027], [2028]]));
    assert_eq!(read["sum"][0], 9);
    // Three points each of 0.01 V/(m/s2) times 1, 1.01 and 1.02; stored in f32.
    let sum = read["sum"][1].as_f64().expect("a sum");
    assert!((sum / 0.0909 - 1.0).abs() < 1e-4, "{sum}");
    let time_s = record(1, 0).head.labels.unix_time_s;
    assert_eq!(read["time_ms"], 1000 * time_s);
    assert_eq!(read["sensor"], serde_json::json!(["D'1", true, null]));
}

#[test]
fn a_run_with_a_known_sensor_needs_nothing_typed_twice() {
    let folder = tempfile::tempdir().expect("folder");
    let (_, address) = serve(Device::new());
    let path = folder.path().join("points.csv");
    std::fs::write(path, "frequency_hz\n80\n160\n").expect("list");
    let logbook = ["--logbook", "logbook.sqlite", "--device", &address];
    let go = |arguments: &[&str]| calib(folder.path(), &[arguments, &logbook].concat());
    let run = ["run", "--sensor", "S'1", "--points", "points.csv", "--json"];
    let early = go(&run);
    assert_eq!(early.status.code(), Some(6));
    assert!(text(&early.stderr).contains("calib sensors add"));
    let add = [
        "sensors",
        "add",
        "--serial",
        "S'1",
        "--manufacturer",
        "Maker",
    ];
    let more = [
        "--model",
        "M 1",
        "--sensitivity",
        "10",
        "--mounting",
        "stud, 2 N m",
    ];
    assert!(go(&[&add[..], &more].concat()).status.success());
    let change = ["sensors", "change", "S'1", "--owner", "Plant 3"];
    assert!(go(&change).status.success());
    assert_eq!(json(&go(&run))["logbook_record"], 1);
    assert_eq!(json(&go(&run))["logbook_record"], 2);
    let records = json(&go(&["logbook", "records", "--sensor", "S'1", "--json"]));
    assert_eq!(records[0]["dut_model"], "Maker M 1");
    let file = ["logbook", "get", "1", "--out", "one.calibrec"];
    assert!(go(&file).status.success());
    let kept = std::fs::read(folder.path().join("one.calibrec")).expect("file");
    let kept = calib_protocol::record::decode(&kept).expect("a record");
    assert_eq!(kept.head.labels.mounting.as_str(), "stud, 2 N m");
    let certificate = ["certificate", "one.calibrec", "--out", "c", "--json"];
    let files = json(&go(&certificate))["files"]
        .as_array()
        .expect("files")
        .len();
    let issued = json(&go(&["logbook", "certificates", "--json"]));
    assert_eq!(issued.as_array().expect("certificates").len(), files);
    // A tolerance around the nominal sensitivity takes that from the logbook too.
    let laboratory = "[decision]\nspecification = 'nominal'\ntolerance_percent = 50\n";
    std::fs::write(folder.path().join("l.toml"), laboratory).expect("file");
    assert!(
        go(&["logbook", "get", "2", "--out", "two.calibrec"])
            .status
            .success()
    );
    let judge = "certificate two.calibrec --out j --format json --laboratory l.toml --json";
    let judge: Vec<&str> = judge.split(' ').collect();
    let nowhere = [&judge[..], &["--logbook", "none.sqlite"]].concat();
    let nowhere = calib(folder.path(), &nowhere);
    assert_eq!(nowhere.status.code(), Some(6));
    assert!(text(&nowhere.stderr).contains("calib sensors add"));
    let file = json(&go(&judge))["files"][0].clone();
    let file = folder.path().join(file.as_str().expect("a name"));
    let judged = std::fs::read_to_string(file).expect("the certificate");
    let judged: serde_json::Value = serde_json::from_str(&judged).expect("JSON");
    assert_eq!(judged["conformity"], "pass");
    for verb in [
        &["history", "S'1"][..],
        &["sensors", "list"],
        &["logbook", "records"],
        &["logbook", "certificates"],
        &["logbook", "instruments"],
    ] {
        let shown = go(verb);
        assert!(shown.status.success(), "{verb:?}: {}", text(&shown.stderr));
        let shown = text(&shown.stdout);
        assert!(shown.lines().count() > 1, "{verb:?}");
        assert!(
            shown.lines().all(|line| line.chars().count() <= 80),
            "{shown}"
        );
    }
    assert!(go(&["logbook", "check"]).status.success());
}

/// The device measures 10 mV/(m/s2) with U = 1 % at every point.
#[test]
fn a_sensor_out_of_its_tolerance_fails_wherever_one_looks() {
    let folder = tempfile::tempdir().expect("folder");
    let (_, address) = serve(Device::new());
    std::fs::write(folder.path().join("points.csv"), "frequency_hz\n80\n160\n").expect("list");
    let logbook = ["--logbook", "logbook.sqlite", "--device", &address];
    let go = |line: &str| {
        let words: Vec<&str> = line.split(' ').chain(logbook).collect();
        calib(folder.path(), &words)
    };
    // 10 / 9.2 - 1 = 8.70 %; 98.0665 mV/g is 10 mV/(m/s2) exactly.
    let add = "sensors add --sensitivity 9.2 --tolerance 5 --serial F";
    assert!(go(add).status.success());
    assert!(
        go("sensors add --sensitivity 98.0665 --unit mV/g --tolerance 5 --serial P")
            .status
            .success()
    );
    let failed = go("run --sensor F --points points.csv --temperature 23");
    assert_eq!(failed.status.code(), Some(7));
    let said = text(&failed.stdout);
    assert!(said.lines().any(|line| line.trim() == "FAIL"), "{said}");
    assert!(
        said.contains("+8.7 % of nominal, limit \u{b1}5 %, at 160 Hz (U = 1.0 %)"),
        "{said}"
    );
    let passed = go("run --sensor P --points points.csv --temperature 23 --json");
    assert_eq!(passed.status.code(), Some(0), "{}", text(&passed.stderr));
    let passed = json(&passed);
    assert_eq!(passed["conformity_statement"]["title"], "PASS");
    assert_eq!(passed["conformity_statement"]["frequency_hz"], 160.0);
    let shown = go("run --sensor P --points points.csv --temperature 23");
    let shown = text(&shown.stdout);
    assert!(
        shown.contains("98.0665 mV/g") && !shown.contains("e-2"),
        "{shown}"
    );
    let get = "logbook get 1 --out f.calibrec";
    assert!(go(get).status.success());
    assert!(text(&go("show f.calibrec").stdout).contains("FAIL"));
    let certificate = go("certificate f.calibrec --format json --out c");
    assert_eq!(
        certificate.status.code(),
        Some(7),
        "{}",
        text(&certificate.stderr)
    );
    assert!(text(&certificate.stderr).contains("FAIL"));
    assert_eq!(
        std::fs::read_dir(folder.path().join("c"))
            .expect("written")
            .count(),
        1
    );
    // Of the two records of P the later one, whose place the logbook knows by the one before.
    let latest = go("certificate --sensor P --format json --out p --json");
    assert_eq!(latest.status.code(), Some(0), "{}", text(&latest.stderr));
    let file = json(&latest)["files"][0]
        .as_str()
        .expect("a file")
        .to_owned();
    assert!(file.ends_with("-000003.json"), "{file}");
    let stated = std::fs::read(folder.path().join(file)).expect("written");
    let stated: serde_json::Value = serde_json::from_slice(&stated).expect("JSON");
    assert_eq!(stated["record_chain"], "verified");
    let nobody = go("certificate --sensor Q --format json --out p");
    assert_eq!(nobody.status.code(), Some(6));
    assert!(text(&nobody.stderr).contains("calib logbook records"));
}

#[test]
fn a_tolerance_that_cannot_be_judged_is_refused_when_it_is_typed() {
    let folder = tempfile::tempdir().expect("folder");
    let add = |more: &str| {
        let line = format!("sensors add --logbook l.sqlite --serial A {more}");
        calib(folder.path(), &line.split(' ').collect::<Vec<_>>())
    };
    let without = add("--tolerance 5");
    assert_eq!(without.status.code(), Some(2));
    assert!(
        text(&without.stderr).contains("nominal"),
        "{}",
        text(&without.stderr)
    );
    let nonsense = add("--tolerance five --sensitivity 10");
    assert_eq!(nonsense.status.code(), Some(2));
    assert!(text(&nonsense.stderr).contains("5:nominal:reference"));
    assert!(add("--tolerance 5:reference:20-5000").status.success());
    let verb = |line: &str| {
        let line = format!("sensors {line} --logbook l.sqlite");
        calib(folder.path(), &line.split(' ').collect::<Vec<_>>())
    };
    // Capitals are no other sensor.
    assert!(text(&verb("show a").stdout).contains("5:reference:20-5000"));
    assert_eq!(verb("add --serial a").status.code(), Some(6));
    assert!(verb("remove a").status.success());
    assert_eq!(verb("show A").status.code(), Some(6));
}

#[test]
fn a_sensor_that_changed_by_more_than_u_is_reported() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    for (id, (years, factor)) in [(0, 1.0), (1, 1.005), (2, 1.03)].into_iter().enumerate() {
        logbook
            .keep(&later(id as u32 + 1, "D", years, factor))
            .expect("kept");
    }
    // The points of these records are at 20, 21 and 22 Hz, with U = 1 %.
    let history = words("history D --frequency 20 --logbook logbook.sqlite");
    let output = calib(folder.path(), &history);
    assert_eq!(output.status.code(), Some(7));
    let shown = text(&output.stdout);
    assert_eq!(shown.matches("changed").count(), 1, "{shown}");
    assert!(
        shown.contains("2027") && shown.matches('●').count() == 3,
        "{shown}"
    );
    let json = calib(folder.path(), &[&history[..], &["--json"]].concat());
    let read: serde_json::Value = serde_json::from_slice(&json.stdout).expect("JSON");
    // 1.03 / 1.005 - 1 = 2.49 %; sensitivities are stored with 16 bits.
    let drift = read["results"][2]["drift_rel"].as_f64().expect("drift");
    assert!((drift - 0.024_876).abs() < 1e-4, "{drift}");
}

/// Ten results that scatter by 0.1 %, one more like them, and one that is 1 % off.
#[test]
fn a_check_standard_is_judged_by_its_own_results() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    let assure = |more: &str| {
        let words = format!("assure C --frequency 20 --logbook logbook.sqlite{more}");
        calib(folder.path(), &words.split(' ').collect::<Vec<_>>())
    };
    let scatter = [1.0, 1.001, 0.999, 1.0005, 0.9995];
    for id in 1..=11_u32 {
        if id == 6 {
            let early = assure("");
            assert_eq!(early.status.code(), Some(6));
            assert!(
                text(&early.stderr).contains("5 results"),
                "{}",
                text(&early.stderr)
            );
        }
        let factor = scatter[id as usize % scatter.len()];
        logbook
            .keep(&later(id, "C", u64::from(id), factor))
            .expect("kept");
    }
    let sound = assure(" --json");
    assert_eq!(sound.status.code(), Some(0), "{}", text(&sound.stderr));
    assert_eq!(json(&sound)["results_before"], 10);
    logbook.keep(&later(12, "C", 12, 1.01)).expect("kept");
    let off = assure("");
    assert_eq!(off.status.code(), Some(7));
    let said = text(&off.stdout);
    assert!(
        said.contains("outside of the limits") && said.contains("OUT OF CONTROL"),
        "{said}"
    );
    // The same value against a certificate that says the same: it is only its own chart that speaks.
    let certified = assure(" --certified 10.1 --certified-u 1 --json");
    let judged: serde_json::Value = serde_json::from_slice(&certified.stdout).expect("JSON");
    let e_n = judged["e_n"].as_f64().expect("a number");
    assert!(e_n.abs() < 0.1, "{judged}");
}

/// Nobody is stopped by a sensor that is no check standard; from when it is one, certificates of its instrument
/// need it in control and measured in time, or a reason in writing.
#[test]
fn a_check_standard_blocks_certificates_unless_overridden_in_writing() {
    let folder = tempfile::tempdir().expect("folder");
    let mut logbook = logbook(folder.path());
    let run = |words: &str| {
        let line = format!("{words} --logbook logbook.sqlite");
        calib(folder.path(), &line.split(' ').collect::<Vec<_>>())
    };
    let scatter = [1.0, 1.001, 0.999, 1.0005, 0.9995];
    for id in 1..=10_u32 {
        let factor = scatter[id as usize % scatter.len()];
        logbook
            .keep(&on_day(id, "C", u64::from(id), factor))
            .expect("kept");
    }
    let unknown = run("assure C --every 7 --frequency 20");
    assert_eq!(
        unknown.status.code(),
        Some(6),
        "no sensor of the logbook yet"
    );
    assert!(run("sensors add --serial C").status.success());
    let nobody = run("assure");
    assert!(
        text(&nobody.stdout).contains("no check standard"),
        "{}",
        text(&nobody.stdout)
    );
    for (id, day) in [(40, 10), (41, 20)] {
        let name = folder.path().join(format!("job-{id}.calibrec"));
        std::fs::write(name, on_day(id, "J", day, 1.0)).expect("written");
    }
    let job = |id: u32, more: &str| {
        run(&format!(
            "certificate job-{id}.calibrec --format csv,html --out {id}{more}"
        ))
    };
    assert!(
        job(40, "-before").status.success(),
        "no check standard, no block"
    );
    assert!(run("assure C --every 7 --frequency 20").status.success());
    let sound = job(40, "-sound");
    assert!(sound.status.success(), "{}", text(&sound.stderr));
    // The last result is of day 10, the job of day 20.
    let overdue = job(41, "");
    assert_eq!(overdue.status.code(), Some(6));
    let said = text(&overdue.stderr);
    assert!(
        said.contains("check standard C was overdue") && said.contains("check_override"),
        "{said}"
    );
    // After the job, in number as in time.
    logbook.keep(&on_day(50, "C", 11, 1.01)).expect("kept");
    let off = job(40, "-off");
    assert!(
        text(&off.stderr).contains("C is out of control"),
        "{}",
        text(&off.stderr)
    );
    let all = run("assure --json");
    assert_eq!(all.status.code(), Some(7));
    let all: serde_json::Value = serde_json::from_slice(&all.stdout).expect("JSON");
    assert_eq!(all["standards"][0]["in_control"], false);
    let reason = "[calibration]\ncheck_override = 'repeated by hand, agrees'\nnumber = 'Z-1'\n";
    std::fs::write(folder.path().join("why.toml"), reason).expect("written");
    let overridden = job(40, "-why --particulars why.toml");
    assert!(overridden.status.success(), "{}", text(&overridden.stderr));
    for format in ["csv", "html"] {
        let file = folder
            .path()
            .join(format!("40-why/certificate-Z-1.{format}"));
        let certificate = std::fs::read_to_string(file).expect("written");
        assert!(certificate.contains("repeated by hand, agrees"), "{format}");
    }
    assert!(run("assure C --no-longer").status.success());
    assert!(job(40, "-after").status.success());
    assert_eq!(logbook.inspect().expect("readable"), Vec::<String>::new());
}

/// Mountings that differ by 1 % of the first's: s = 1 %, s of the mean 0.577 %, two degrees of freedom.
#[test]
fn a_run_that_is_mounted_again_evaluates_the_scatter_and_certifies_all_records() {
    let folder = tempfile::tempdir().expect("folder");
    logbook(folder.path());
    let mut device = Device::new();
    device.remounting_rel = 0.01;
    let (_, address) = serve(device);
    std::fs::write(folder.path().join("p.csv"), "frequency_hz\n80\n160\n").expect("list");
    let with = |line: &str| {
        let words = format!("{line} --logbook logbook.sqlite --device {address}");
        words.split(' ').map(str::to_owned).collect::<Vec<_>>()
    };
    let run = |enter: &str| {
        let words = with("run --serial R --points p.csv --temperature 23 --remount 3 --json");
        typed(tool(folder.path()).args(words), enter)
    };
    let output = run("\n\n");
    let remounting = &json(&output)["remounting"];
    assert_eq!(remounting["record_ids"], serde_json::json!([1, 2, 3]));
    let point = &remounting["points"][1];
    let number = |key: &str| point[key].as_f64().expect(key);
    // 1.01, 1.02, 1.03: 0.01 of 1.02; sensitivities travel as f32.
    assert!(
        (number("scatter_rel") - 0.01 / 1.02).abs() < 1e-5,
        "{point}"
    );
    assert!((number("standard_uncertainty_rel") - 0.01 / 1.02 / 3.0_f64.sqrt()).abs() < 1e-5);
    assert_eq!(number("degrees_of_freedom"), 2.0);
    assert!(
        text(&output.stderr).contains("mount it again"),
        "{}",
        text(&output.stderr)
    );
    let certificate = |more: &str| {
        let words = with(&format!("certificate 1 --format json{more}"));
        calib(
            folder.path(),
            &words.iter().map(String::as_str).collect::<Vec<_>>(),
        )
    };
    let written = certificate(" --remounted 2,3 --out all");
    assert!(written.status.success(), "{}", text(&written.stderr));
    let all = std::fs::read_to_string(folder.path().join("all/certificate-MEM-1-000001.json"));
    let all: serde_json::Value = serde_json::from_str(&all.expect("written")).expect("JSON");
    let said = all["mounting"]["repeated"].as_str().expect("said");
    assert!(said.contains("3 mountings, records 1, 2, 3"), "{said}");
    let rows = all["budget"]["components"].as_array().expect("rows");
    let row = rows
        .iter()
        .find(|row| row["distribution"] == "mountings")
        .expect("a row");
    assert_eq!(
        (row["row"].as_i64(), row["degrees_of_freedom"].as_f64()),
        (Some(8), Some(2.0))
    );
    let twice = certificate(" --remounted 1 --out twice");
    assert_eq!(twice.status.code(), Some(6));
    // Nobody at the keyboard: what was measured is kept.
    let alone = run("");
    assert_eq!(alone.status.code(), Some(2));
    assert!(
        text(&alone.stderr).contains("is kept"),
        "{}",
        text(&alone.stderr)
    );
}

/// The standard reads 1.01 of 10 mV/(m/s2), the device in its place 1.02: S2 = 10.1 mV/(m/s2) times 1.02 / 1.01.
#[test]
fn a_device_is_calibrated_by_substitution_of_a_standard() {
    let folder = tempfile::tempdir().expect("folder");
    let mut device = Device::new();
    device.remounting_rel = 0.01;
    let (_, address) = serve(device);
    let write = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).expect("written");
    };
    write("p.csv", "frequency_hz\n80\n160\n");
    write(
        "s.csv",
        "frequency_hz,sensitivity_mv,expanded_uncertainty_percent\n160,10.1,0.4\n",
    );
    let run = |more: &str| {
        let words = format!(
            "run --serial D --points p.csv --temperature 23 --json --device {address}{more}"
        );
        typed(tool(folder.path()).args(words.split(' ')), "\n\n")
    };
    let unknown = run(" --substitute CHK");
    assert_eq!(unknown.status.code(), Some(6));
    assert!(
        text(&unknown.stderr).contains("nobody stated"),
        "{}",
        text(&unknown.stderr)
    );
    // Nothing moves for a table that cannot be: no U, hardly any, mV that say V, a frequency twice.
    for (name, rows) in [
        ("expanded_uncertainty_percent", "160,10.1,0\n"),
        ("expanded_uncertainty_percent", "160,10.1,1e-9\n"),
        ("expanded_uncertainty_percent", "160,10.1,1e9\n"),
        ("sensitivity_v", "160,10.1,0.4\n"),
        ("twice", "160,10.1,0.4\n160.5,11,0.4\n"),
    ] {
        let unit = if name == "sensitivity_v" { "v" } else { "mv" };
        let heads = format!("frequency_hz,sensitivity_{unit},expanded_uncertainty_percent\n");
        write("bad.csv", &format!("{heads}{rows}"));
        let refused = run(" --substitute CHK --standard bad.csv");
        assert_eq!(refused.status.code(), Some(6), "{name}: {rows}");
        let why = text(&refused.stderr);
        assert!(why.contains(name) && why.contains("bad.csv:"), "{why}");
    }
    let output = run(" --substitute CHK --standard s.csv");
    let found = json(&output);
    let substitution = &found["substitution"];
    assert_eq!(substitution["standard_record_id"], 1);
    assert_eq!(found["record_id"], 2);
    let points = substitution["points"].as_array().expect("points");
    assert_eq!(points.len(), 1, "80 Hz is not certified");
    let number = |key: &str| points[0][key].as_f64().expect(key);
    // Records keep 16 bits of a sensitivity.
    let expected = 0.0101 * 1.02 / 1.01;
    assert!(
        (number("sensitivity_v_per_ms2") / expected - 1.0).abs() < 4e-5,
        "{substitution}"
    );
    let whole = number("expanded_uncertainty_ratio_rel").hypot(0.004);
    // f32 of the budgets.
    assert!((number("expanded_uncertainty_rel") / whole - 1.0).abs() < 1e-5);
    // The certificate of both records says the same.
    let certificate = |more: &str| {
        let words = format!(
            "certificate 2 --substituted 1 --format json --out c --logbook none.sqlite --device {address}{more}"
        );
        calib(folder.path(), &words.split(' ').collect::<Vec<_>>())
    };
    let unknown = certificate("");
    assert_eq!(unknown.status.code(), Some(6), "{}", text(&unknown.stderr));
    let written = certificate(" --standard s.csv");
    assert!(written.status.success(), "{}", text(&written.stderr));
    assert!(
        text(&written.stderr).contains("DRAFT"),
        "{}",
        text(&written.stderr)
    );
    let files = std::fs::read_dir(folder.path().join("c")).expect("written");
    let path = files
        .flatten()
        .map(|file| file.path())
        .find(|path| path.extension().is_some_and(|end| end == "json"));
    let file = std::fs::read(path.expect("a file")).expect("JSON");
    let stated: serde_json::Value = serde_json::from_slice(&file).expect("JSON");
    let points = stated["points"].as_array().expect("points");
    assert_eq!(points[0]["reason"], "frequency_unavailable");
    for key in ["sensitivity_v_per_ms2", "expanded_uncertainty_rel"] {
        let found = points[1][key].as_f64().expect(key);
        // f32 of the record.
        assert!((found / number(key) - 1.0).abs() < 2e-7, "{key}: {found}");
    }
}

#[test]
fn a_virtual_teds_becomes_a_sensor() {
    let folder = tempfile::tempdir().expect("folder");
    // Packed by an independent few lines of Python: manufacturer 21, model 4507 B3,
    // serial number 30000, template 25, sensitivity code 33017 (0.01 V/(m/s2)),
    // calibrated 2025-05-19 for 365 days.
    std::fs::write(folder.path().join("a.ted"), TEDS).expect("file");
    let logbook = ["--logbook", "b.sqlite", "--json"];
    let import = ["sensors", "import", "--teds", "a.ted", "--model", "4507-B"];
    let sensor = json(&calib(folder.path(), &[&import[..], &logbook].concat()));
    assert_eq!(sensor["serial"], "30000");
    assert_eq!(sensor["model"], "4507-B");
    assert_eq!(sensor["due_day"], "2026-05-19");
    let sensitivity = sensor["sensitivity_v_per_ms2"].as_f64().expect("stated");
    // Half a step of the code is 0.015 %.
    assert!((sensitivity / 0.01 - 1.0).abs() < 1.6e-4);
    let twice = calib(folder.path(), &[&import[..], &logbook].concat());
    assert_eq!(twice.status.code(), Some(6));
}

const TEDS: &str = "15c066440c30750064900f08658a2c84380962b4c50100";
