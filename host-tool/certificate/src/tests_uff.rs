//! The universal file, read back by a reader of others.

use super::model::Certificate;
use super::python::python;
use super::{Format, Language, Particulars, render};
use calib_record::sample::{THIRD_OCTAVES_HZ, point, record, text, truth};
use std::ffi::OsStr;

const READ: &str = "\
import sys, json, pyuff
sets = pyuff.UFF(sys.argv[1]).read_sets()
s = sets[0] if isinstance(sets, list) else sets
print(json.dumps({'type': int(s['type']), 'func': int(s['func_type']), 'x': [float(x) for x in s['x']],
  're': [float(d.real) for d in s['data']], 'im': [float(d.imag) for d in s['data']],
  'id1': s['id1'], 'unit': s['ordinate_axis_units_lab'].strip(), 'abscissa': int(s['abscissa_spec_data_type'])}))
";

/// A file for modal software said nothing of the conformity that every other format has.
#[test]
fn the_conformity_stands_behind_the_date() {
    for (tolerance_percent, title) in [(0.1, "NOT JUDGEABLE"), (5.0, "PASS"), (-1.0, "")] {
        let decision = format!(
            "[decision]\nspecification = 'nominal'\nnominal_mv_per_ms2 = 10.2\ntolerance_percent = {tolerance_percent}"
        );
        let stated = match title {
            "" => Particulars::default(),
            _ => toml::from_str(&decision).expect("TOML"),
        };
        let certificate = Certificate::from_record(&record(&[160.0]), &stated);
        let file = render(&certificate, Format::Uff, Language::De).expect("renders");
        let file = String::from_utf8(file).expect("ASCII");
        let expected = match title {
            "" => "2025-11-21".to_owned(),
            title => format!("2025-11-21, {title}"),
        };
        assert_eq!(file.lines().nth(4), Some(expected.as_str()), "{file}");
    }
}

/// The sample is a mass on a spring of 32 kHz; 50 m/s2 0.38 % lower, or lower by nothing that is printed.
#[test]
fn the_fifth_line_has_resonance_and_linearity() {
    for (relative, linearity) in [(0.9962, "-0.38 %"), (0.999_999, "0.00 %")] {
        let mut record = record(&THIRD_OCTAVES_HZ);
        for (acceleration_rms_ms2, relative) in [(1.0, 1.0), (50.0, relative)] {
            let mut measured = point(160.0);
            measured.spec.acceleration_rms_ms2 = acceleration_rms_ms2;
            measured.sensitivity_v_per_ms2 *= relative;
            record.points.push(measured).expect("room");
        }
        let certificate = Certificate::from_record(&record, &Particulars::default());
        let file = render(&certificate, Format::Uff, Language::De).expect("renders");
        let file = String::from_utf8(file).expect("ASCII");
        let line = file.lines().nth(6).expect("a fifth line");
        let end = format!("r.m.s.; fr 32.0 kHz; lin {linearity}");
        assert!(line.ends_with(&end), "{line}");
    }
}

#[test]
fn pyuff_reads_the_complex_sensitivity_back() {
    let mut record = record(&THIRD_OCTAVES_HZ);
    record.head.labels.dut_serial = text("Ö'1 🎛");
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("response.uff");
    std::fs::write(
        &path,
        render(&certificate, Format::Uff, Language::En).expect("renders"),
    )
    .expect("written");
    let arguments = [OsStr::new("-c"), OsStr::new(READ), path.as_os_str()];
    let Some(output) = python("pyuff", &arguments) else {
        return;
    };
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let read: serde_json::Value = serde_json::from_str(said.trim()).expect("JSON");
    assert_eq!(
        (&read["type"], &read["func"], &read["abscissa"]),
        (&58.into(), &4.into(), &18.into())
    );
    assert_eq!(read["unit"], "V");
    let numbers = |key: &str| -> Vec<f64> {
        read[key]
            .as_array()
            .expect(key)
            .iter()
            .map(|n| n.as_f64().expect("number"))
            .collect()
    };
    let (x, re, im) = (numbers("x"), numbers("re"), numbers("im"));
    assert_eq!(x.len(), THIRD_OCTAVES_HZ.len());
    for ((frequency_hz, re), im) in x.into_iter().zip(re).zip(im) {
        let (magnitude, phase) = truth(frequency_hz);
        // The file has six digits of the frequency: 5e-6 of it, which at
        // 10 kHz is 0.22 x 5e-6 of the magnitude (ratio 0.3125, slope
        // 2 r^2 / (1 - r^2)) and 6.3e-8 rad; f32 of the record adds 6e-8.
        let close = (re.hypot(im) / magnitude - 1.0).abs() < 1.2e-6;
        assert!(close, "{frequency_hz}");
        assert!((im.atan2(re) - phase).abs() < 2.0e-7, "{frequency_hz}");
    }
}
