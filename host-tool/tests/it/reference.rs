//! `calib reference`: a certificate of the reference is shown beside what is in force, then stored.

use crate::command_line::{calib, json, serve, text};
use crate::device::{Device, settings};
use crate::words;
use calib_record::sample;
use std::path::Path;
use std::process::Output;

const TABLE: &str = "# serial: R 17\n# certificate: K-2026-17\n# laboratory: Lab\n# calibrated: 2026-05-04\n# due: 2028-05-04\n\
    # traceability: to the SI\nfrequency_hz,sensitivity_mv_per_ms2,u_percent,k,phase_deg,u_phase_deg\n";

/// The table in force, times `factor`, without its last row.
fn table(factor: f32) -> String {
    let points = settings().reference.points;
    let kept = points.len() - 1;
    let row = |p: &calib_core::settings::ReferencePoint| {
        let s = 1e3 * f64::from(p.sensitivity_v_per_ms2 * factor);
        format!("{},{s},0.5,2,0.1,0.5\n", p.frequency_hz)
    };
    let rows: String = points.iter().take(kept).map(row).collect();
    format!("{TABLE}{rows}")
}

fn go(folder: &Path, address: &str, arguments: &[&str]) -> Output {
    calib(folder, &[arguments, &["--device", address]].concat())
}

#[test]
fn a_certificate_is_shown_beside_what_is_in_force_and_stored() {
    let folder = tempfile::tempdir().expect("folder");
    let folder = folder.path();
    let (device, address) = serve(Device::new());
    std::fs::write(folder.join("r.csv"), table(1.01)).expect("written");
    let shown = json(&go(folder, &address, &["reference", "r.csv", "--json"]));
    assert_eq!(shown["stored"], false);
    assert_eq!(shown["certified"]["serial"], "R 17");
    let change = shown["compared"][0]["change_rel"]
        .as_f64()
        .expect("in force");
    // Two roundings of single precision.
    assert!((change - 0.01).abs() < 3e-7, "{change}");
    let last = settings()
        .reference
        .points
        .last()
        .map(|p| f64::from(p.frequency_hz));
    assert_eq!(shown["lost_hz"][0].as_f64(), last);
    assert_eq!(
        device.lock().expect("device").settings,
        settings(),
        "nothing changed yet"
    );
    let said = go(folder, &address, &["reference", "r.csv"]);
    let said = text(&said.stdout);
    assert!(
        said.lines().all(|line| line.chars().count() <= 80),
        "{said}"
    );
    assert!(
        said.contains("no longer measured") && said.contains("+1.00"),
        "{said}"
    );
    let stored = go(
        folder,
        &address,
        &words("reference r.csv --write --operator N. --json"),
    );
    assert_eq!(json(&stored)["stored"], true, "{}", text(&stored.stderr));
    let now = device.lock().expect("device").settings.clone();
    assert_eq!(now.reference.serial.as_str(), "R 17");
    assert_eq!(now.reference.certificate.as_str(), "K-2026-17, Lab");
    assert_eq!(
        now.reference.points.len(),
        settings().reference.points.len() - 1
    );
    assert_eq!(now.limits, settings().limits);
}

#[test]
fn our_own_certificate_of_a_sensor_is_read() {
    let folder = tempfile::tempdir().expect("folder");
    let folder = folder.path();
    let record = sample::record(&sample::THIRD_OCTAVES_HZ);
    std::fs::write(folder.join("s.calibrec"), sample::bytes(&record)).expect("written");
    std::fs::write(folder.join("job.toml"), "[laboratory]\ncountry = 'DE'\n").expect("written");
    let made = calib(
        folder,
        &words("certificate s.calibrec --format dcc,csv -p job.toml"),
    );
    assert!(made.status.success(), "{}", text(&made.stderr));
    for name in [
        "certificate-CAL-0042-000017.dcc.xml",
        "certificate-CAL-0042-000017.csv",
    ] {
        let read = calib(folder, &["reference", name, "--offline", "--json"]);
        assert!(read.status.success(), "{name}: {}", text(&read.stderr));
        let read = json(&read);
        assert_eq!(
            read["certified"]["serial"],
            record.head.labels.dut_serial.as_str()
        );
        assert_eq!(read["certified"]["certificate"], "CAL-0042-000017");
        for (point, measured) in read["compared"]
            .as_array()
            .expect("points")
            .iter()
            .zip(&record.points)
        {
            let stated = point["sensitivity_v_per_ms2"].as_f64().expect("S");
            let u = point["expanded_uncertainty_rel"].as_f64().expect("U");
            // A certificate ends where U ends: two digits of U, so 5 % of U at most.
            let off = (stated / f64::from(measured.sensitivity_v_per_ms2) - 1.0).abs();
            assert!(off < 0.051 * u, "{point}");
        }
    }
}

#[test]
fn what_cannot_be_trusted_is_not_stored() {
    let folder = tempfile::tempdir().expect("folder");
    let folder = folder.path();
    let (device, address) = serve(Device::new());
    let record = include_bytes!("../../../tests/frozen/records/demo.calibrec");
    std::fs::write(folder.join("demo.calibrec"), record).expect("written");
    std::fs::write(folder.join("job.toml"), "[laboratory]\ncountry = 'DE'\n").expect("written");
    let key = concat!(env!("CARGO_MANIFEST_DIR"), "/signing/test-keys/p256.p12");
    std::fs::write(folder.join("password"), "test").expect("written");
    let sign = [
        "certificate",
        "demo.calibrec",
        "--format",
        "dcc",
        "-p",
        "job.toml",
        "--sign",
        key,
        "--password-file",
        "password",
    ];
    let made = calib(folder, &sign);
    assert!(made.status.success(), "{}", text(&made.stderr));
    let name = "certificate-23004100075457494E303120-000002.dcc.xml";
    let refused = |name: &str, words: &str| {
        let output = go(folder, &address, &["reference", name, "--write"]);
        assert_eq!(output.status.code(), Some(6), "{}", text(&output.stdout));
        assert!(
            text(&output.stderr).contains(words),
            "{}",
            text(&output.stderr)
        );
        assert_eq!(device.lock().expect("device").settings, settings());
    };
    refused(name, "measured by the emulated instrument");
    let signed = std::fs::read_to_string(folder.join(name)).expect("written");
    let altered = signed.replacen("<dcc:uniqueIdentifier>2", "<dcc:uniqueIdentifier>3", 1);
    std::fs::write(folder.join("altered.xml"), altered).expect("written");
    refused("altered.xml", "its signature does not hold");
    std::fs::write(folder.join("k.csv"), table(1.0).replace(",k,", ",l,")).expect("written");
    refused("k.csv", "k.csv:7: no column for the coverage factor");
}
