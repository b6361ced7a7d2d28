//! `calib selfcheck` on records that were measured before, and what certificates say of it.

use super::{folder, json, output};
use calib_core::point::PointResult;
use calib_protocol::record::Record;
use calib_record::sample;
use calib_tests::self_check::{FREQUENCIES_HZ, plan};
use calib_twin::reciprocity::session::{self, Reading};
use calib_twin::reciprocity::{Hold, SelfCheckDraw};
use std::path::Path;

/// 2025-12-01 00:00 UTC, and a day.
const FIRST_S: u64 = 1_764_547_200;
const DAY_S: u64 = 86_400;

/// The sample's certificate says 10 mV/(m/s2), the twin's rig has 10.2.
fn calibrator() -> SelfCheckDraw {
    SelfCheckDraw::new(5, Hold::Current).with_reference_changed(10.0 / 10.2)
}

/// A reading as an instrument states it: over what it believes of its reference.
fn stated(reading: &Reading) -> PointResult {
    let mut point = sample::point(reading.frequency_hz as f32);
    let believed = 10.0e-3;
    point.sensitivity_v_per_ms2 = (reading.ratio.norm() * believed) as f32;
    point.phase_rad = reading.ratio.arg() as f32;
    point.acceleration_rms_ms2 = reading.acceleration_rms_ms2 as f32;
    point.repeatability_rel = reading.scatter_rel as f32;
    point.repeatability_phase_rad = reading.scatter_rel as f32;
    point
}

/// The ten records of a check on a day, as files.
fn records(folder: &Path, draw: &SelfCheckDraw, day: u64) -> Vec<String> {
    let runs = session::measure(draw, &plan(0.050, draw.stated.mass_kg), day);
    let write = |(place, run): (usize, &Vec<Reading>)| {
        let id = 100 * (day as u32 + 1) + place as u32;
        let mut record: Record = sample::record(&FREQUENCIES_HZ.map(|hz| hz as f32));
        record.head.id = id;
        record.head.labels.unix_time_s = FIRST_S + DAY_S * day + 30 * place as u64;
        record.points = run.iter().map(stated).collect();
        let name = format!("record-{id:05}.calibrec");
        std::fs::write(folder.join(&name), sample::bytes(&record)).expect("written");
        name
    };
    runs.iter().enumerate().map(write).collect()
}

fn arguments<'a>(records: &'a [String], more: &[&'a str]) -> Vec<&'a str> {
    let verb = ["selfcheck", "--logbook", "book.sqlite"];
    let names = records.iter().map(String::as_str);
    verb.into_iter()
        .chain(names)
        .chain(more.iter().copied())
        .collect()
}

#[test]
fn a_drifted_reference_is_told_from_its_baseline_and_stated_on_the_certificate() {
    let folder = folder();
    let at = folder.path();
    let book = ["--logbook", "book.sqlite"];
    let sensor = ["sensors", "add", "--serial", "LW1"];
    assert!(output(at, &[&sensor[..], &book].concat()).status.success());
    let draw = calibrator();

    let baseline = json(at, &arguments(&records(at, &draw, 0), &["--baseline"]));
    assert_eq!(
        baseline["points"].as_array().expect("points").len(),
        FREQUENCIES_HZ.len()
    );
    assert_eq!(
        (&baseline["kept"], &baseline["changes"][0]["against"]),
        (&true.into(), &"certificate".into())
    );
    let sound = json(
        at,
        &arguments(&records(at, &draw.on_another_day(1), 1), &[]),
    );
    assert_eq!(sound["changes"][0]["against"], "baseline");
    assert_eq!(sound["changes"][0]["significant"], false);

    let drifted = draw.on_another_day(2).with_reference_changed(0.995);
    let said = output(at, &arguments(&records(at, &drifted, 2), &[]));
    assert_eq!(said.status.code(), Some(7));
    let text = String::from_utf8_lossy(&said.stdout).into_owned();
    assert!(
        text.contains("reference changed by -0.") && text.contains("since the baseline"),
        "{text}"
    );

    // It is on the chart, and out of control.
    let chart = output(at, &[&["assure"], &book[..]].concat());
    assert_eq!(chart.status.code(), Some(7));
    let text = String::from_utf8_lossy(&chart.stdout).into_owned();
    assert!(text.contains("OUT OF CONTROL by 3 checks"), "{text}");

    // A certificate of the day after the sound check states that one, one of the day after the last is refused, or
    // says why not.
    let written = "[calibration]\ncheck_override = \"mass was not seated\"\n";
    std::fs::write(at.join("job.toml"), written).expect("written");
    for (day, particulars, expected) in [
        (1, None, Ok("was checked on 2025-12-02 by reciprocity")),
        (3, None, Err("the reference is not what it was")),
        (3, Some("job.toml"), Ok("CHANGED by")),
    ] {
        let mut record = sample::record(&[160.0, 1000.0]);
        record.head.id = 900 + day as u32;
        record.head.labels.unix_time_s = FIRST_S + DAY_S * day + 40_000;
        std::fs::write(at.join("job.calibrec"), sample::bytes(&record)).expect("written");
        let made = [
            "certificate",
            "job.calibrec",
            "--format",
            "html",
            "--out",
            "out",
        ];
        let stated = particulars.map(|file| ["--particulars", file]);
        let stated = stated.iter().flatten().copied();
        let made: Vec<&str> = made.into_iter().chain(book).chain(stated).collect();
        let made = output(at, &made);
        let said = String::from_utf8_lossy(&made.stderr).into_owned();
        let expected = match expected {
            Ok(expected) => expected,
            Err(refusal) => {
                assert!(!made.status.success() && said.contains(refusal), "{said}");
                continue;
            }
        };
        assert!(made.status.success(), "{said}");
        let html = std::fs::read_dir(at.join("out"))
            .expect("a folder")
            .flatten();
        let pages: Vec<String> = html
            .map(|file| std::fs::read_to_string(file.path()).expect("text"))
            .collect();
        assert!(
            pages.iter().any(|page| page.contains(expected)),
            "{expected}"
        );
    }
    let whole = ["logbook", "check"];
    assert!(output(at, &[&whole[..], &book].concat()).status.success());
}

/// S g of 0.010 V/(m/s2), the sample's reference, with its axis up and down: sound, and after a loss of 1 %.
#[test]
fn a_reference_turned_over_in_gravity_is_compared_kept_and_stated() {
    let folder = folder();
    let at = folder.path();
    let book = ["--logbook", "book.sqlite"];
    let sensor = ["sensors", "add", "--serial", "LW1"];
    assert!(output(at, &[&sensor[..], &book].concat()).status.success());
    let mut record = sample::record(&[160.0, 1000.0]);
    // After both checks.
    record.head.labels.unix_time_s = FIRST_S + 3 * DAY_S;
    std::fs::write(at.join("any.calibrec"), sample::bytes(&record)).expect("written");
    let readings = |sensitivity: f64, more: &str| {
        let [up, down] = [1.0, -1.0].map(|sign| 0.012 + sign * sensitivity * 9.812);
        let group = format!("{up}, {down}, {down}, {}", up * (1.0 + 1e-5));
        let text = format!(
            "readings_v = [{group}, {group}]\ngravity_ms2 = [9.812, 1e-5]\nvoltmeter_rel = 1e-4\ntilt_deg = 0.5\n\
             step_rel = 1e-3\ntemperature_c = 23.0\n{more}"
        );
        std::fs::write(at.join("readings.toml"), text).expect("written");
    };
    let verb = |more: &[&'static str]| {
        [
            &["turnover", "readings.toml", "any.calibrec"],
            &book[..],
            more,
        ]
        .concat()
    };
    readings(0.010, "measured = \"2025-12-01T14:30:00Z\"");
    let baseline = json(at, &verb(&["--baseline"]));
    let off = baseline["change_rel"].as_f64().expect("a number");
    // Of the fourth readings, 1e-5 of 0.11 V in 4 g S.
    assert!(off.abs() < 1e-5, "{off}");
    assert_eq!(baseline["changes"][0]["against"], "certificate");
    readings(0.0099, "measured = \"2025-12-02T14:30:00Z\"");
    let said = output(at, &verb(&[]));
    assert_eq!(said.status.code(), Some(7));
    let text = String::from_utf8_lossy(&said.stdout).into_owned();
    assert!(text.contains("reference changed by -1.00 %"), "{text}");
    let chart = output(at, &[&["assure"], &book[..]].concat());
    assert_eq!(chart.status.code(), Some(7));
    let refused = output(at, &[&["certificate", "any.calibrec"], &book[..]].concat());
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(said.contains("is not what it was"), "{said}");

    readings(0.010, "latitude_deg = 50.0");
    let both = output(at, &verb(&[]));
    assert_eq!(both.status.code(), Some(6));
    let said = String::from_utf8_lossy(&both.stderr).into_owned();
    assert!(
        said.contains("neither or both of gravity_ms2 and latitude_deg"),
        "{said}"
    );
}

#[test]
fn records_that_are_no_check_are_refused_with_the_way_out() {
    let folder = folder();
    let at = folder.path();
    let mut names = records(at, &calibrator(), 0);
    names.swap(0, 1);
    let said = output(at, &arguments(&names, &[]));
    assert_eq!(said.status.code(), Some(6));
    let nobody = output(at, &["selfcheck", "--device", "emulated"]);
    assert_eq!(nobody.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&nobody.stderr).contains("nobody is at the keyboard"));
    std::fs::write(at.join("mass.toml"), "mass = 0.05\n").expect("written");
    names.swap(0, 1);
    let said = output(at, &arguments(&names, &["--equipment", "mass.toml"]));
    assert!(
        String::from_utf8_lossy(&said.stderr).contains("mass.toml:1: "),
        "{said:?}"
    );
}
