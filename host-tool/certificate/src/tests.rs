//! Every format against the numbers the record was made from.

use super::model::{Certificate, Value};
use super::{
    Format, Known, Language, Options, Particulars, SensitivityUnit, Specified, render, write_with,
};
use crate::decision::Conformity;
use calib_core::point_state::{PointState, Reason};
use calib_protocol::record::Record;
use calib_record::sample::{SENSITIVITY_V_PER_MS2, THIRD_OCTAVES_HZ, point, record, text, truth};

/// The least a DCC needs.
fn country() -> Particulars {
    toml::from_str("[laboratory]\ncountry = 'DE'").expect("TOML")
}

fn bytes(record: &Record, format: Format, language: Language) -> Vec<u8> {
    let certificate = Certificate::from_record(record, &country());
    render(&certificate, format, language).expect("renders")
}

fn rendered(record: &Record, format: Format, language: Language) -> String {
    String::from_utf8(bytes(record, format, language)).expect("UTF-8")
}

fn rows(csv: &str, delimiter: u8) -> Vec<std::collections::HashMap<String, String>> {
    let text = csv.strip_prefix('\u{feff}').expect("byte order mark");
    let mut reader = ::csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("row")).collect()
}

#[test]
fn the_reference_point_is_160_hz_and_states_its_uncertainty() {
    let certificate = Certificate::from_record(&record(&THIRD_OCTAVES_HZ), &Particulars::default());
    let (point, values) = certificate.reference_result().expect("a reference point");
    assert_eq!(point.nominal_frequency_hz, 160.0);
    // 10.2 mV/(m/s2) raised by 1/(1 - (160/32000)^2) = 2.5e-5: 10.20026.
    // Row 11 for 23.1 degrees, told to 1 K: 0.12 % x 1.1.
    // U = 2 sqrt(0.25^2 + (0.25^2+0.2^2+0.05^2+0.15^2+0.132^2)/3 + 0.015^2) %
    //   = 2 sqrt(0.0625 + 0.14492/3 + 0.000225) = 0.6664 %, 0.0680 mV/(m/s2).
    let printed = values.printed;
    assert_eq!(
        (printed.value, printed.uncertainty, printed.decimals),
        (10.2, 0.068, 3)
    );
    assert_eq!(values.printed_uncertainty_percent, (0.67, 2));
    // 10.20026 x 9.80665 = 100.0304 mV/g with U = 0.6664 %.
    let printed = values.printed_per_g.expect("an accelerometer");
    assert_eq!(
        (printed.value, printed.uncertainty, printed.decimals),
        (100.03, 0.67, 2)
    );
}

#[test]
fn the_reference_point_moves_to_80_hz_when_160_hz_was_refused() {
    let mut record = record(&[40.0, 80.0, 160.0, 315.0]);
    record.points[2].state = PointState::Refused(Reason::Distortion);
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let (point, _) = certificate.reference_result().expect("a reference point");
    assert_eq!(point.nominal_frequency_hz, 80.0);
}

#[test]
fn among_levels_at_160_hz_100_ms2_comes_first_then_10() {
    let mut record = record(&[160.0, 160.0, 160.0]);
    for (index, level) in [20.0, 10.0, 100.0].into_iter().enumerate() {
        record.points[index].spec.acceleration_rms_ms2 = level;
    }
    let level = |record: &Record| {
        let certificate = Certificate::from_record(record, &Particulars::default());
        let (point, _) = certificate.reference_result().expect("a reference point");
        point.nominal_acceleration_ms2
    };
    assert_eq!(level(&record), 100.0);
    record.points[2].state = PointState::Refused(Reason::Overload);
    assert_eq!(level(&record), 10.0);
}

#[test]
fn csv_gives_every_point_as_printed() {
    let rows = rows(
        &rendered(&record(&THIRD_OCTAVES_HZ), Format::Csv, Language::En),
        b',',
    );
    assert_eq!(rows.len(), THIRD_OCTAVES_HZ.len());
    for (row, nominal_hz) in rows.iter().zip(THIRD_OCTAVES_HZ) {
        let number = |key: &str| row[key].parse::<f64>().expect(key);
        assert_eq!(
            number("frequency_hz"),
            nominal_hz.to_string().parse::<f64>().expect("number")
        );
        let (magnitude, phase) = truth(number("actual_frequency_hz"));
        // Printed to the second digit of U: half of that digit is 0.5 % of U
        // at U = 0.0786, that is 0.0005 mV/(m/s2) below 10 mV/(m/s2).
        assert!((number("sensitivity_mv_per_ms2") - 1000.0 * magnitude).abs() <= 0.000_51);
        // U of the phase is 0.32 deg: two digits end at 0.01 deg.
        assert!((number("phase_deg") - phase.to_degrees()).abs() <= 0.005_1);
        assert_eq!(row["state"], "valid");
    }
}

#[test]
fn german_csv_has_semicolons_and_decimal_commas() {
    let rows = rows(
        &rendered(&record(&[31.5, 160.0]), Format::Csv, Language::De),
        b';',
    );
    assert_eq!(rows[0]["frequency_hz"], "31,5");
    assert_eq!(rows[1]["sensitivity_mv_per_ms2"], "10,200");
}

#[test]
fn json_gives_numbers_that_are_not_rounded() {
    let json: serde_json::Value = serde_json::from_str(&rendered(
        &record(&THIRD_OCTAVES_HZ),
        Format::Json,
        Language::En,
    ))
    .expect("JSON");
    let points = json["points"].as_array().expect("points");
    assert_eq!(points.len(), THIRD_OCTAVES_HZ.len());
    for point in points {
        let (magnitude, phase) = truth(point["actual_frequency_hz"].as_f64().expect("number"));
        let sensitivity = point["sensitivity_v_per_ms2"].as_f64().expect("number");
        // The record holds f32: half a unit in the last place is 6e-8.
        assert!((sensitivity / magnitude - 1.0).abs() < 1.0e-7);
        let degrees = point["phase_deg"].as_f64().expect("number");
        assert!((degrees - phase.to_degrees()).abs() < 1.0e-6);
    }
    assert_eq!(json["item"]["serial"], "LW 12345");
    assert_eq!(json["calibration"]["date"], "2025-11-21");
    assert_eq!(json["reference"]["frequency_hz"], 160.0);
}

#[test]
fn a_refused_point_has_a_reason_and_no_result() {
    let mut record = record(&[160.0, 1000.0]);
    record.points[1].state = PointState::Refused(Reason::SignalToNoise);
    let rows = rows(&rendered(&record, Format::Csv, Language::En), b',');
    assert_eq!(
        (rows[1]["state"].as_str(), rows[1]["reason"].as_str()),
        ("refused", "signal_to_noise")
    );
    assert_eq!(rows[1]["sensitivity_mv_per_ms2"], "");
    let json: serde_json::Value =
        serde_json::from_str(&rendered(&record, Format::Json, Language::En)).expect("JSON");
    assert!(json["points"][1]["sensitivity_v_per_ms2"].is_null());
    let html = rendered(&record, Format::Html, Language::En);
    assert!(html.contains("refused: too little signal over noise"));
    assert!(html.contains("1 of 2 points were refused"));
}

#[test]
fn a_failure_stays_one_when_another_point_was_refused() {
    let decided = |text: &str, refused: bool| {
        let particulars: Particulars = toml::from_str(text).expect("TOML");
        let mut record = record(&[160.0, 1000.0]);
        if refused {
            record.points[1].state = PointState::Refused(Reason::Distortion);
        }
        Certificate::from_record(&record, &particulars)
    };
    // 10.2 mV/(m/s2) against 9 within 5 % fails, against 10 within 5 % passes.
    let nominal = |mv: f64| {
        format!(
            "[decision]\nspecification = 'nominal'\ntolerance_percent = 5.5\nnominal_mv_per_ms2 = {mv}"
        )
    };
    assert_eq!(
        decided(&nominal(9.0), true).conformity(),
        Some(Conformity::Fail)
    );
    assert_eq!(
        decided(&nominal(10.0), false).conformity(),
        Some(Conformity::Pass)
    );
    assert_eq!(decided(&nominal(10.0), true).conformity(), None);
    // Numbers in statements follow the language, too.
    let certificate = decided(&nominal(10.0), false);
    let page = render(&certificate, Format::Html, Language::De).expect("renders");
    let page = String::from_utf8(page).expect("UTF-8");
    assert!(page.contains("Nennwert ± 5,5\u{a0}%"));
}

/// The sample record, 10.2 mV/(m/s2) with U = 0.77 %, of a sensor of which this is known.
fn judged(nominal_mv: f64, tolerance: &str, rule: &str, last: &[(f64, f64)]) -> Certificate {
    let mut particulars: Particulars = toml::from_str(rule).expect("TOML");
    let known = Known {
        nominal: Some(Specified::new(nominal_mv, SensitivityUnit::default())),
        tolerance: Some(tolerance.parse().expect("a tolerance")),
        last: last.to_vec(),
        ..Known::default()
    };
    particulars.for_device(&known).expect("complete");
    Certificate::from_record(&record(&[160.0, 1000.0]), &particulars)
}

#[test]
fn the_statement_of_conformity_says_what_decided() {
    // 10.20026 / 9.63 - 1 = 5.92 %; conditional within U = 0.67 % of the limit of 5 %, not beyond.
    let minus = '\u{2212}';
    let cases = [
        (
            9.63,
            "5",
            "FAIL",
            "+5.92 % of nominal, limit ±5 %, at 160 Hz (U = 0.67 %)".to_owned(),
        ),
        (
            9.68,
            "5",
            "CONDITIONAL FAIL",
            "+5.37 % of nominal, limit ±5 %".to_owned(),
        ),
        (
            9.75,
            "5",
            "CONDITIONAL PASS",
            "+4.62 % of nominal, limit ±5 %".to_owned(),
        ),
        (
            10.3,
            "5",
            "PASS",
            format!("{minus}0.97 % of nominal, limit ±5 %, at 160 Hz"),
        ),
        (
            10.2,
            "0.5",
            "NOT JUDGEABLE",
            "U = 0.67 % is too large for this limit".to_owned(),
        ),
        (
            10.2,
            "api670",
            "PASS",
            "+0.03 % of nominal, limit ±5 %".to_owned(),
        ),
        (
            9.0,
            "0.5:last",
            "NOT JUDGEABLE",
            "nothing is known of the last calibration".to_owned(),
        ),
    ];
    for (nominal, tolerance, title, because) in cases {
        let certificate = judged(nominal, tolerance, "", &[]);
        let conformity = certificate
            .conformity_statement(Language::En)
            .expect("a tolerance");
        assert_eq!(
            conformity.title, title,
            "{tolerance} of {nominal}: {conformity:?}"
        );
        assert!(conformity.because.contains(&because), "{conformity:?}");
        for format in [Format::Html, Format::Json] {
            let page = render(&certificate, format, Language::En).expect("renders");
            let page = String::from_utf8(page).expect("UTF-8");
            assert!(page.contains(title), "{format:?} {title}");
        }
    }
    let german = judged(9.63, "5", "", &[]).conformity_statement(Language::De);
    let german = german.expect("a tolerance");
    assert_eq!(german.title, "NICHT ERFÜLLT");
    assert!(
        german.because.starts_with("+5,92 % vom Nennwert"),
        "{german:?}"
    );
}

#[test]
fn the_rule_is_the_laboratorys_and_the_tolerance_the_sensors() {
    let title = |rule: &str| {
        let certificate = judged(9.75, "5:nominal:reference,8:reference:500-5000", rule, &[]);
        certificate
            .conformity_statement(Language::En)
            .expect("a tolerance")
            .title
    };
    assert_eq!(title(""), "CONDITIONAL PASS");
    assert_eq!(title("[decision]\nrule = 'simple'"), "PASS");
    // 10.2 against 10.0 within 2.5 %, of the same frequency's last calibration.
    let last = [(160.0, 0.0100), (1000.0, 0.0100)];
    let certificate = judged(1.0, "2.5:last", "[decision]\nrule = 'simple'", &last);
    let conformity = certificate
        .conformity_statement(Language::En)
        .expect("a tolerance");
    assert_eq!(conformity.title, "PASS");
    assert!(
        conformity
            .because
            .starts_with("+2.00 % of the last calibration"),
        "{conformity:?}"
    );
    // A rule alone judges nothing.
    let particulars: Particulars = toml::from_str("[decision]\nrule = 'simple'").expect("TOML");
    let certificate = Certificate::from_record(&record(&[160.0]), &particulars);
    assert_eq!(certificate.conformity_statement(Language::En), None);
    assert!(
        certificate
            .remarks
            .iter()
            .all(|r| r.key == "temperature_told")
    );
}

#[test]
fn coherence_has_a_column_when_it_was_measured() {
    let mut record = record(&[160.0, 1000.0]);
    let page = rendered(&record, Format::Html, Language::En);
    assert!(!page.contains("<th scope=\"col\">Coherence</th>"));
    record.points[1].coherence = Some(0.9975);
    let page = rendered(&record, Format::Html, Language::De);
    assert!(page.contains("<th scope=\"col\">Kohärenz</th>") && page.contains("<td>0,9975</td>"));
    let csv = rendered(&record, Format::Csv, Language::En);
    assert_eq!(rows(&csv, b',')[1]["coherence"], "0.9975");
}

#[test]
fn every_reason_has_words_in_every_language() {
    // Reasons are numbered without gaps, so postcard bytes 0, 1, 2 ... are all.
    let reasons: Vec<Reason> = (0..=u8::MAX)
        .map_while(|n| postcard::from_bytes(&[n]).ok())
        .collect();
    assert!(reasons.len() >= 16);
    for reason in reasons {
        for language in Language::ALL {
            let key = format!("reason.{reason:?}");
            assert_ne!(language.word(&key), key, "{language:?}");
        }
    }
}

#[test]
fn numbers_that_are_none_never_reach_the_page() {
    let broken: [fn(&mut Record); 4] = [
        |r| r.points[0].sensitivity_v_per_ms2 = f32::NAN,
        |r| r.points[0].expanded_uncertainty_rel = f32::NAN,
        |r| r.points[0].expanded_uncertainty_rel = 0.0,
        |r| r.points[0].coverage_factor = f32::NAN,
    ];
    for break_it in broken {
        let mut record = record(&[160.0]);
        break_it(&mut record);
        let html = rendered(&record, Format::Html, Language::En);
        assert!(!html.contains("NaN"), "{html}");
        assert!(html.contains("there is no result"));
        let csv = rendered(&record, Format::Csv, Language::En);
        assert_eq!(rows(&csv, b',')[0]["reason"], "not_reportable");
    }
}

#[test]
fn one_point_and_two_hundred_points_render() {
    let many: Vec<f32> = (0..200).map(|n| 20.0 * 1.03_f32.powi(n)).collect();
    for frequencies in [&[160.0][..], &many] {
        for format in Format::ALL {
            let output = bytes(&record(frequencies), format, Language::De);
            assert!(!output.is_empty());
        }
        let html = rendered(&record(frequencies), Format::Html, Language::En);
        assert_eq!(html.matches("class='mark'").count(), 2 * frequencies.len());
    }
}

#[test]
fn an_empty_record_says_that_there_is_no_result() {
    let html = rendered(&record(&[]), Format::Html, Language::En);
    assert!(html.contains("No point passed its checks"));
}

#[test]
fn the_page_loads_nothing_from_elsewhere() {
    let html = rendered(&record(&THIRD_OCTAVES_HZ), Format::Html, Language::En);
    let without_namespace = html.replace("xmlns='http://www.w3.org/2000/svg'", "");
    for outside in ["http:", "https:", "src=", "<link", "@import", "url(//"] {
        assert!(!without_namespace.contains(outside), "{outside}");
    }
}

#[test]
fn hostile_names_stay_text() {
    let mut record = record(&[160.0]);
    record.head.labels.dut_model = text("=cmd|' /C calc'!A0");
    record.head.labels.dut_serial = text("O'Neil <script>alert(1)</script> 🎛");
    let html = rendered(&record, Format::Html, Language::En);
    assert!(!html.contains("<script>alert"));
    assert!(html.contains("&lt;script&gt;alert(1)") && html.contains('🎛'));
    let rows = rows(&rendered(&record, Format::Csv, Language::En), b',');
    assert_eq!(rows[0]["dut_model"], "'=cmd|' /C calc'!A0");
    assert!(rows[0]["dut_serial"].contains('🎛'));
}

#[test]
fn what_is_not_stated_is_printed_as_missing() {
    let mut record = record(&[160.0]);
    record.head.labels.temperature_centi_c = None;
    record.head.labels.operator = text("  ");
    record.head.labels.unix_time_s = 0;
    record.settings.reference.due_day = 0;
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let missing = [
        ("conditions", "transducer_temperature"),
        ("calibration", "operator"),
        ("calibration", "date"),
        ("equipment", "reference_due"),
    ];
    for (section, key) in missing {
        assert_eq!(certificate.statement(section, key), None, "{key}");
    }
    let html = rendered(&record, Format::Html, Language::En);
    assert!(html.matches(">not stated<").count() >= missing.len());
}

#[test]
fn the_instruments_temperature_is_a_mean_and_no_ambient_temperature() {
    let mut record = record(&[160.0, 1000.0, 2000.0]);
    let seen = [Some(47.4), None, Some(51.2)];
    for (point, temperature_c) in record.points.iter_mut().zip(seen) {
        point.instrument_temperature_c = temperature_c;
    }
    let certificate = Certificate::from_record(&record, &Particulars::default());
    match certificate.statement("conditions", "instrument_temperature") {
        // 49.3 in halves; the bound is that of two f32.
        Some(Value::Number(mean_c, 0, "°C")) => assert!((mean_c - 49.3).abs() < 1.0e-5),
        other => panic!("{other:?}"),
    }
    assert_eq!(
        certificate.statement("conditions", "ambient_temperature"),
        None
    );
    record.points.clear();
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let conditions = certificate.sections.iter().find(|s| s.key == "conditions");
    let mut entries = conditions.expect("a section").entries.iter();
    assert!(entries.all(|entry| entry.key != "instrument_temperature"));
}

#[test]
fn a_reference_past_its_due_date_is_an_error() {
    let mut record = record(&[160.0]);
    record.settings.reference.due_day = 20_000; // 2024-10-04, the run is 2025-11-21
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let remark = certificate
        .remarks
        .iter()
        .find(|r| r.key == "reference_overdue")
        .expect("said");
    assert_eq!(remark.values, [Value::Day(jiff::civil::date(2024, 10, 4))]);
}

#[test]
fn deviations_refer_to_the_reference_point() {
    let certificate =
        Certificate::from_record(&record(&[160.0, 10_000.0]), &Particulars::default());
    let values = certificate.points[1].outcome.as_ref().expect("passed");
    let expected = truth(10_000.0).0 / truth(160.0).0;
    // Two f32 roundings of 6e-8 each.
    let deviation = values.deviation.expect("said");
    assert!((deviation.percent / 100.0 + 1.0 - expected).abs() < 2.0e-7);
    assert!((deviation.db - 20.0 * expected.log10()).abs() < 2.0e-6);
    assert!((SENSITIVITY_V_PER_MS2 * 1000.0 - 10.2).abs() < 1e-12);
}

#[test]
fn inverted_polarity_is_said_and_not_hidden_in_the_phase() {
    let mut record = record(&[160.0]);
    record.points[0].inverted = true;
    let html = rendered(&record, Format::Html, Language::En);
    assert!(html.contains("polarity is inverted (Annex B)"));
}

#[test]
fn files_are_named_after_the_certificate_and_complete() {
    let folder = tempfile::tempdir().expect("folder");
    let out = folder.path().join("a/b");
    let mut record = record(&[160.0]);
    record.head.instrument_serial = text("../x y");
    let options = Options {
        particulars: country(),
        ..Options::default()
    };
    let paths = write_with(&record, &Format::ALL, &out, &options).expect("written");
    let names: Vec<_> = paths
        .iter()
        .map(|p| p.file_name().expect("name").to_string_lossy().into_owned())
        .collect();
    assert_eq!(
        names,
        [
            "certificate-___x_y-000017.csv",
            "certificate-___x_y-000017.json",
            "certificate-___x_y-000017.html",
            "certificate-___x_y-000017.dcc.xml",
            "certificate-___x_y-000017.pdf",
            "certificate-___x_y-000017.uff"
        ]
    );
    assert_eq!(std::fs::read_dir(&out).expect("folder").count(), 6);
}

#[test]
fn the_same_record_gives_the_same_bytes() {
    let record = record(&THIRD_OCTAVES_HZ);
    for format in Format::ALL {
        let once = bytes(&record, format, Language::En);
        assert!(once == bytes(&record, format, Language::En), "{format:?}");
    }
    assert_ne!(
        point(160.0).sensitivity_v_per_ms2,
        point(10_000.0).sensitivity_v_per_ms2
    );
}

#[test]
fn a_diagnostic_that_is_no_number_is_left_empty() {
    let mut record = record(&[160.0]);
    record.points[0].signal_to_noise_dut_db = f32::INFINITY;
    record.points[0].distortion_dut_rel = f32::NAN;
    let csv = rendered(&record, Format::Csv, Language::En);
    let row = &rows(&csv, b',')[0];
    assert_eq!(
        (
            row["signal_to_noise_dut_db"].as_str(),
            row["distortion_dut_percent"].as_str()
        ),
        ("", "")
    );
    let html = rendered(&record, Format::Html, Language::En);
    assert!(!html.contains("NaN") && !html.contains(">inf<"));
}

#[test]
fn the_budget_adds_up_to_the_stated_uncertainty() {
    let certificate = Certificate::from_record(&record(&[160.0]), &Particulars::default());
    let keys: Vec<&str> = certificate.remarks.iter().map(|r| r.key).collect();
    assert_eq!(keys, ["temperature_told"]);
    let budget = certificate.budget.expect("a budget");
    // Rows 1, 2, 3, 8, 10, 11 and 18, and 5, which is zero without hum; the sum is worked out in
    // `the_reference_point_is_160_hz_and_states_its_uncertainty`.
    let rows: Vec<u8> = budget.rows.iter().map(|row| row.row).collect();
    assert_eq!(rows, [1, 2, 3, 5, 8, 10, 11, 18]);
    let sum: f64 = budget
        .rows
        .iter()
        .map(|row| row.contribution_percent.powi(2))
        .sum();
    assert!((2.0 * sum.sqrt() / 0.666_43 - 1.0).abs() < 1.0e-4);
    assert!((budget.expanded_percent / 0.666_43 - 1.0).abs() < 1.0e-4);
    // 0.132 % rectangular is 0.0762 %.
    assert!((budget.rows[6].contribution_percent - 0.076_21).abs() < 1.0e-5);
}

#[test]
fn a_stored_uncertainty_that_the_settings_do_not_give_is_an_error() {
    let mut record = record(&[160.0]);
    record.points[0].expanded_uncertainty_rel *= 0.9;
    let html = rendered(&record, Format::Html, Language::En);
    assert!(html.contains("Do not use this certificate"));
    assert!(
        html.contains("U = 0.7705 %, the record states 0.6935 %"),
        "{html}"
    );
}

#[test]
fn a_record_that_was_stored_still_agrees_with_its_settings() {
    let mut record = record(&[160.0]);
    // Told within 1 K: the 3 K of the settings.
    record.head.labels.temperature_centi_c = Some(2500);
    // Repeatability dominates: what rounding in a record does to U is largest.
    record.points[0].repeatability_rel = 0.010_03;
    let exact = Certificate::from_record(&record, &Particulars::default());
    let budget = exact.budget.expect("a budget");
    record.points[0].expanded_uncertainty_rel = (budget.expanded_percent / 100.0) as f32;
    let mut buffer = vec![0; 8192];
    let length = calib_protocol::record::encode(&record, &mut buffer).expect("fits");
    let stored = calib_protocol::record::decode(&buffer[..length]).expect("a record");
    assert_ne!(stored.points[0].repeatability_rel, 0.010_03);
    let certificate = Certificate::from_record(&stored, &Particulars::default());
    let keys: Vec<_> = certificate.remarks.iter().map(|r| r.key).collect();
    assert!(!keys.contains(&"budget_mismatch"), "{keys:?}");
    assert!(
        certificate.points[0]
            .values()
            .expect("passed")
            .coverage_factor_phase
            .is_some()
    );
}

#[test]
fn a_reference_table_that_does_not_reach_the_point_is_an_error() {
    let mut record = record(&[160.0]);
    record.settings.reference.points.truncate(1);
    let html = rendered(&record, Format::Html, Language::En);
    assert!(html.contains("does not reach 160 Hz"), "{html}");
}

#[test]
fn what_clause_7_asks_for_and_nobody_states_is_listed() {
    let missing = super::missing(&record(&[160.0]), &Particulars::default());
    let air = (
        "Ambient air temperature".to_owned(),
        "ISO 16063-21 7 a".to_owned(),
    );
    assert!(missing.into_iter().any(|missing| missing == air));
}
