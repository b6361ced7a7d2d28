//! Every statement of every format compared with every other: CSV, JSON, HTML, DCC and the text of the PDF.

use super::python::python;
use super::tests_dcc::FULL;
use super::{Format, Options, Particulars, Prepared, Standard, StandardPoint, prepare};
use calib_core::point_state::{PointState, Reason};
use calib_protocol::record::Record;
use calib_record::sample::{record, text};
use std::collections::HashMap;
use std::ffi::OsStr;

/// A record in which everything is said that can be: a judged, a refused and a point beyond the specification,
/// a device that is warm, a reference that was overdue, settings of an emulated instrument.
fn talkative() -> Record {
    let mut record = record(&[80.0, 160.0, 1000.0, 5000.0, 16_000.0]);
    record.points[2].state = PointState::Refused(Reason::NotSettled);
    record.head.labels.temperature_centi_c = Some(3150);
    record.settings.reference.due_day = 20_400; // the run is of day 20 413
    record.head.instrument_serial = text("23004100075457494E303120");
    // The reference frequency at three levels more: a statement on linearity.
    for (acceleration_rms_ms2, relative, blocks) in
        [(1.0, 1.0012, 10), (2.0, 1.0, 10), (50.0, 0.9962, 3)]
    {
        let mut measured = record.points[1];
        measured.spec.acceleration_rms_ms2 = acceleration_rms_ms2;
        measured.acceleration_rms_ms2 = acceleration_rms_ms2;
        measured.sensitivity_v_per_ms2 *= relative;
        measured.blocks = blocks;
        record.points.push(measured).expect("room");
    }
    record
}

fn particulars(language: &str) -> Particulars {
    let overdue = "overdue_reference = \"recalibration ordered\"\n[conditions]";
    let text = FULL
        .replace("[conditions]", overdue)
        .replace("language = \"de\"", &format!("language = \"{language}\""))
        .replace("approved_by = \"Dr. A. Prüferin\"\n", "");
    let amended = "replaces = { certificate = \"K-2026-0117\", reason = \"Name des Kunden <GmbH>\" }\n[conditions]";
    toml::from_str(&text.replace("[conditions]", amended)).expect("TOML")
}

/// Languages, by comparison with the instrument's reference and by substitution.
const CASES: [(&str, bool); 4] = [("de", false), ("en", false), ("de", true), ("en", true)];

struct Written {
    csv: Vec<HashMap<String, String>>,
    json: serde_json::Value,
    html: String,
    dcc: String,
    pdf: Vec<u8>,
}

/// The standard whose place the device took; certified at two frequencies.
fn standard() -> Standard {
    let mut record = talkative();
    record.head.id -= 1;
    record.head.labels.dut_serial = text("CHK-1");
    let at = |frequency_hz| StandardPoint {
        frequency_hz,
        sensitivity_v_per_ms2: 0.0102,
        expanded_uncertainty_rel: 0.004,
    };
    Standard {
        record,
        certified: [80.0, 160.0, 5000.0].map(at).to_vec(),
    }
}

fn written(language: &str, standard: Option<Standard>) -> Written {
    let options = Options {
        particulars: particulars(language),
        standard,
        ..Options::default()
    };
    let prepared = prepare(&talkative(), &Format::ALL, &options).expect("rendered");
    let of = |format| content(&prepared, format);
    let utf8 = |format| String::from_utf8(of(format)).expect("UTF-8");
    let delimiter = if language == "de" { b';' } else { b',' };
    let csv = utf8(Format::Csv);
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .from_reader(csv.trim_start_matches('\u{feff}').as_bytes());
    Written {
        csv: reader
            .deserialize()
            .map(|row| row.expect("a row"))
            .collect(),
        json: serde_json::from_slice(&of(Format::Json)).expect("JSON"),
        html: unescaped(&utf8(Format::Html)),
        dcc: unescaped(&utf8(Format::Dcc)),
        pdf: of(Format::Pdf),
    }
}

fn content(prepared: &Prepared, format: Format) -> Vec<u8> {
    let file = prepared.files.iter().find(|file| file.format == format);
    file.expect("asked for").content.clone()
}

fn unescaped(text: &str) -> String {
    [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&#x27;", "'"),
        ("&#x2f;", "/"),
        ("&apos;", "'"),
        ("&amp;", "&"),
    ]
    .iter()
    .fold(text.to_owned(), |text, (from, to)| text.replace(from, to))
}

/// Without white space, which lines and tables add, and with one kind of minus.
fn bare(text: &str) -> String {
    let kept = text.chars().filter(|c| !c.is_whitespace());
    kept.map(|c| if c == '\u{2212}' { '-' } else { c })
        .collect()
}

/// Columns of CSV whose numbers are printed in the table, with their places in a list of the DCC and the keys
/// of JSON, where there are: JSON is times this what CSV has.
const NUMBERS: [(&str, Option<&str>, &str, f64); 9] = [
    (
        "sensitivity_mv_per_ms2",
        Some("vib_sensitivityMagnitude value"),
        "sensitivity_v_per_ms2",
        1e-3,
    ),
    (
        "expanded_uncertainty_percent",
        None,
        "expanded_uncertainty_rel",
        1e-2,
    ),
    (
        "coverage_factor",
        Some("vib_sensitivityMagnitude factor"),
        "coverage_factor",
        1.0,
    ),
    (
        "deviation_percent",
        Some("vib_sensitivityMagnitudeDeviation value"),
        "deviation_rel",
        1e-2,
    ),
    ("deviation_db", None, "deviation_db", 1.0),
    (
        "expanded_uncertainty_deviation_percent",
        Some("vib_sensitivityMagnitudeDeviation expanded"),
        "expanded_uncertainty_deviation_rel",
        1e-2,
    ),
    (
        "phase_deg",
        Some("vib_sensitivityPhase value"),
        "phase_deg",
        1.0,
    ),
    (
        "expanded_uncertainty_phase_deg",
        Some("vib_sensitivityPhase expanded"),
        "expanded_uncertainty_phase_deg",
        1.0,
    ),
    (
        "sensitivity_mv_per_g",
        None,
        "sensitivity_v_per_ms2",
        1e-3 / 9.806_65,
    ),
];

/// Numbers of all lists of a quantity of the DCC, judged points first: by reference type and part.
fn lists(dcc: &str, place: &str) -> Vec<f64> {
    let (kind, part) = place.split_once(' ').expect("two words");
    let tag = match part {
        "value" => "si:valueXMLList",
        "expanded" => "si:valueExpandedMUXMLList",
        _ => "si:coverageFactorXMLList",
    };
    let begin = format!("refType=\"{kind}\"");
    let quantities = dcc.split(begin.as_str()).skip(1);
    quantities
        .flat_map(|quantity| {
            let list = quantity.split(&format!("<{tag}>")).nth(1).expect(tag);
            let list = list.split('<').next().expect("an end");
            list.split(' ')
                .map(|n| n.parse().expect("a number"))
                .collect::<Vec<f64>>()
        })
        .collect()
}

fn parsed(cell: &str) -> Option<f64> {
    (!cell.is_empty()).then(|| cell.replace(',', ".").parse().expect(cell))
}

/// Rows of the table over frequency of a page, each without white space.
fn rows_of_html(html: &str) -> Vec<String> {
    let rows = html
        .split("<tr")
        .skip(1)
        .map(|row| row.split("</tr>").next().expect("a row"));
    let words = |row: &str| {
        let cells = row.split("<td").skip(1);
        cells
            .map(|cell| {
                let text = cell.split_once('>').expect("a tag").1;
                format!("|{}", bare(text.split('<').next().expect("text")))
            })
            .collect::<String>()
    };
    rows.map(words).collect()
}

#[test]
fn the_numbers_of_a_point_are_the_same_in_every_format() {
    for (language, standard) in CASES.map(|(language, has)| (language, has.then(standard))) {
        let written = written(language, standard);
        let html = rows_of_html(&written.html);
        let points = written.json["points"].as_array().expect("points");
        assert_eq!(points.len(), written.csv.len());
        // The DCC lists judged points first; 16 kHz is beyond the specification and last anyway.
        let valid: Vec<_> = written
            .csv
            .iter()
            .filter(|row| row["state"] == "valid")
            .collect();
        for (column, place, key, factor) in NUMBERS {
            for (row, point) in written.csv.iter().zip(points) {
                let (cell, json) = (parsed(&row[column]), point[key].as_f64());
                assert_eq!(cell.is_some(), json.is_some(), "{column}");
                let (Some(cell), Some(json)) = (cell, json) else {
                    continue;
                };
                let (_, fraction) = row[column].split_once([',', '.']).unwrap_or(("", ""));
                // Half of the last digit printed; U is rounded up where more than 5 % would be lost.
                let digit = 10.0_f64.powi(-(fraction.len() as i32));
                assert!(
                    (cell * factor - json).abs() <= 0.96 * digit * factor,
                    "{column}: {cell} {json}"
                );
                let printed = format!("|{}", bare(&row[column]));
                let hz = format!("|{}|", row["frequency_hz"]);
                let own = |found: &&String| found.starts_with(&hz) && found.contains(&printed);
                assert!(
                    html.iter().any(|found| own(&found)),
                    "{column}: {printed} {html:?}"
                );
            }
            let Some(place) = place else { continue };
            let listed = lists(&written.dcc, place);
            assert_eq!(listed.len(), valid.len(), "{place}");
            for (row, listed) in valid.iter().zip(listed) {
                // At the reference point the deviation is nothing without uncertainty, which lists call 0.
                assert_eq!(parsed(&row[column]).unwrap_or(0.0), listed, "{place}");
            }
        }
    }
}

/// Marks, remarks, conformity and statements are in every format that people or programs read whole.
#[test]
fn every_statement_in_words_is_the_same_in_every_format() {
    for (language, standard) in CASES.map(|(language, has)| (language, has.then(standard))) {
        let by_substitution = standard.is_some();
        let written = written(language, standard);
        let (html, dcc) = (bare(&written.html), bare(&written.dcc));
        let pdf = text_of(&written.pdf).map(|text| bare(&text));
        let everywhere = |what: &str, in_dcc: bool| {
            let words = bare(what);
            assert!(html.contains(&words), "{language}, HTML: {what}");
            assert!(!in_dcc || dcc.contains(&words), "{language}, DCC: {what}");
            let missing = pdf.as_ref().is_some_and(|pdf| !pdf.contains(&words));
            assert!(!missing, "{language}, PDF: {what}");
        };
        let remarks = written.json["remarks"].as_array().expect("remarks");
        let keys: Vec<&str> = remarks.iter().filter_map(|r| r["key"].as_str()).collect();
        for key in [
            "refused",
            "reference_overdue",
            "reference_override",
            "temperature_told",
        ] {
            assert!(keys.contains(&key), "{keys:?}");
        }
        for remark in remarks {
            everywhere(remark["text"].as_str().expect("words"), true);
        }
        let marks = if language == "de" {
            ["SIMULIERT", "ENTWURF"]
        } else {
            ["SIMULATED", "DRAFT"]
        };
        for mark in marks {
            everywhere(mark, true);
        }
        assert_eq!(written.csv[0]["marks"], "simulated draft");
        let replaces = written.json["calibration"]["replaces"]
            .as_str()
            .expect("words");
        everywhere(replaces, true);
        for (key, column) in [("certificate", "replaces"), ("reason", "replaced_because")] {
            let stated = written.json["replaces"][key].as_str().expect("stated");
            assert!(written.csv.iter().all(|row| row[column] == stated));
            assert!(replaces.contains(stated), "{replaces}");
        }
        let element = "<dcc:replacedUniqueIdentifier>K-2026-0117</";
        assert!(written.dcc.contains(element), "{}", written.dcc);
        for (column, section, key) in [
            ("comparison", "calibration", "substitution"),
            ("linearity", "calibration", "linearity"),
            ("mounted_resonance", "mounting", "resonance"),
            ("resonance_search", "mounting", "resonance_search"),
        ] {
            let stated = written.json[section][key].as_str();
            let is_said = match column {
                "comparison" => by_substitution,
                // The list is none of a search.
                "resonance_search" => false,
                _ => true,
            };
            assert_eq!(stated.is_some(), is_said, "{column}");
            let stated = stated.unwrap_or_default();
            assert!(
                written.csv.iter().all(|row| row[column] == stated),
                "{column}"
            );
            everywhere(stated, true);
        }
        let conformity = &written.json["conformity_statement"];
        for key in ["title", "because"] {
            everywhere(conformity[key].as_str().expect("words"), false);
        }
        let mut statements = 0;
        for section in [
            "item",
            "calibration",
            "conditions",
            "mounting",
            "amplifier",
            "equipment",
        ] {
            let in_dcc = ["conditions", "mounting", "amplifier"].contains(&section);
            let section = written.json[section].as_object().expect("a section");
            for said in section.values().filter_map(|said| said.as_str()) {
                // Numbers with a unit are reals of the DCC.
                let number = said.starts_with(|c: char| c.is_ascii_digit() || c == '-');
                everywhere(said, in_dcc && !number);
                statements += 1;
            }
        }
        assert!(statements > 35, "{statements}");
    }
}

/// Text of all pages, where there is a reader.
fn text_of(pdf: &[u8]) -> Option<String> {
    const READ: &str = "import sys, pypdf\n\
        for page in pypdf.PdfReader(sys.argv[1]).pages: sys.stdout.buffer.write(page.extract_text().encode())";
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("c.pdf");
    std::fs::write(&path, pdf).expect("written");
    let arguments = [OsStr::new("-c"), OsStr::new(READ), path.as_os_str()];
    let output = python("pypdf", &arguments)?;
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    Some(String::from_utf8(output.stdout).expect("UTF-8"))
}
