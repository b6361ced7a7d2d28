//! Sensors that are no accelerometers with a voltage: every format in their own quantity.

use super::decision::Stated;
use super::model::{Certificate, Value};
use super::{Document, Format, Known, Language, Options, Particulars, SensorKind, prepare, render};
use calib_protocol::record::Record;
use calib_record::sample::{point, record};
use serde_json::Value as Json;
use std::f64::consts::TAU;

/// Points of the sample's calibrator with a device of 4 V/(m/s) that follows the velocity without any lag, as the
/// instrument measures it: 4/w volts per m/s2, a quarter turn behind, and half of the motion's second harmonic.
fn coil(frequencies_hz: &[f32]) -> Record {
    let mut record = record(frequencies_hz);
    for point in &mut record.points {
        let played_hz = f64::from(point.tone.frequency_hz(record.head.sample_rate_hz));
        point.sensitivity_v_per_ms2 = (4.0 / (TAU * played_hz)) as f32;
        point.phase_rad = -std::f32::consts::FRAC_PI_2;
        point.distortion_dut_rel = 0.5 * point.distortion_reference_rel;
    }
    record
}

fn known(kind: &str, nominal: &str, tolerance: &str) -> Known {
    Known {
        kind: Some(kind.parse().expect(kind)),
        nominal: Some(nominal.parse().expect(nominal)),
        tolerance: Some(tolerance.parse().expect(tolerance)),
        ..Known::default()
    }
}

fn of_known(record: &Record, known: &Known) -> Certificate {
    let mut particulars: Particulars =
        toml::from_str("[laboratory]\ncountry = 'DE'").expect("TOML");
    particulars.for_device(known).expect("complete");
    Certificate::from_record(record, &particulars)
}

fn of_kind(record: &Record, kind: &str) -> Certificate {
    let mut particulars = Particulars::default();
    particulars.item.unit = Some(kind.parse().expect(kind));
    Certificate::from_record(record, &particulars)
}

fn json(certificate: &Certificate) -> Json {
    let document = Document::new(certificate, Language::En);
    serde_json::to_value(&document).expect("JSON")
}

fn text(certificate: &Certificate, format: Format) -> String {
    let bytes = render(certificate, format, Language::En).expect("renders");
    // As HTML has it.
    String::from_utf8_lossy(&bytes).replace("&#x2f;", "/")
}

/// Against acceleration the response falls as 1/f: nothing but its own quantity could be judged.
#[test]
fn a_velocity_transducer_is_judged_and_stated_in_its_own_quantity() {
    let known = known("mV/(mm/s)", "4 mV/(mm/s)", "5,3:reference");
    let certificate = of_known(&coil(&[10.0, 80.0, 160.0, 1000.0]), &known);
    assert_eq!(certificate.stated_conformity(), Stated::Pass);
    let stated = json(&certificate);
    assert_eq!(stated["kind"]["quantity"], "velocity");
    assert_eq!(stated["kind"]["unit"], "mV/(mm/s)");
    assert_eq!(stated["inverted"], false);
    for point in stated["points"].as_array().expect("points") {
        let number = |value: &Json| value.as_f64().expect("a number");
        let own = &point["in_unit"];
        // The record keeps magnitude and phase as f32.
        assert!(
            (number(&own["sensitivity"]) / 4.0 - 1.0).abs() < 2e-7,
            "{own}"
        );
        assert!(number(&own["phase_deg"]).abs() < 1e-4, "{own}");
        assert!(
            (number(&own["lower_limit"]) - 3.88).abs() < 1e-6,
            "3 % of 4: {own}"
        );
        assert!(number(&point["deviation_rel"]).abs() < 2e-7, "{point}");
        // Volts per m/s2 stay what the instrument measured; nobody takes them for the sensor's.
        assert!(point["printed_mv_per_ms2"].is_null() && point["lower_limit_v_per_ms2"].is_null());
    }
    // 9.9992 m/s2 at 160 Hz are 9.946 mm/s.
    let at_160 = &stated["points"][2]["in_unit"]["amplitude_rms"];
    assert!(
        (at_160.as_f64().expect("mm/s") / 9.947 - 1.0).abs() < 2e-3,
        "{at_160}"
    );
}

#[test]
fn every_format_speaks_in_the_quantity_of_the_sensor() {
    let known = known("mV/(mm/s)", "4 mV/(mm/s)", "5");
    let certificate = of_known(&coil(&[80.0, 160.0, 1000.0]), &known);
    let csv = text(&certificate, Format::Csv);
    assert!(
        csv.contains(
            ",acceleration_rms_ms2,velocity_rms_mm_per_s,sensitivity_mv_per_mm_per_s,expanded"
        ),
        "{csv}"
    );
    assert!(
        csv.contains("lower_limit_mv_per_mm_per_s") && !csv.contains("per_ms2,"),
        "{csv}"
    );
    // A single-precision number has at most nine digits, and no computed ones behind them.
    let velocity = csv.lines().nth(1).and_then(|line| line.split(',').nth(7));
    assert!(velocity.is_some_and(|v| v.len() <= 10), "{velocity:?}");
    // A reader that is not told otherwise refuses rows of another length than the heading.
    let mut rows = ::csv::Reader::from_reader(csv.as_bytes());
    assert!(rows.records().all(|row| row.is_ok()), "{csv}");
    // 10 m/s2 over 2 pi 160 Hz are 9.947 mm/s; 80 Hz is the row before.
    let row = csv.lines().nth(2).expect("160 Hz");
    let cell = |at: usize| row.split(',').nth(at).expect("a cell").parse::<f64>();
    let (acceleration_ms2, velocity) = (cell(6).expect("m/s2"), cell(7).expect("mm/s"));
    let expected = acceleration_ms2 * 1e3 / (TAU * 160.0);
    assert!((velocity / expected - 1.0).abs() < 1e-3, "{row}");
    let page = text(&certificate, Format::Html);
    for words in [
        "mV/(mm/s)",
        "velocity, in mV/(mm/s)",
        "mm/s",
        "Sensitivity in mV/(mm/s)",
    ] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains("mV/g") && !page.contains("mV/(m/s²)"));
    let dcc = text(&certificate, Format::Dcc);
    assert!(dcc.contains(r"<si:unitXMLList>\volt\metre\tothe{-1}\second</si:unitXMLList>"));
    assert!(dcc.contains("vib_velocity") && !dcc.contains(r"\milli\volt\metre"));
    let uff = text(&certificate, Format::Uff);
    assert!(uff.contains("Velocity             m/s"), "{uff}");
    assert!(
        uff.contains("complex sensitivity in V/(m/s), velocity r.m.s."),
        "{uff}"
    );
    for language in [Language::En, Language::De] {
        render(&certificate, Format::Pdf, language).expect("renders");
    }
}

/// A polarity that the instrument tells by half a turn against acceleration is a toss-up at a quarter.
#[test]
fn an_inverted_coil_is_inverted_whatever_the_instrument_took_it_for() {
    for told in [false, true] {
        let mut record = coil(&[80.0, 160.0, 1000.0]);
        for point in &mut record.points {
            // 91 degrees ahead, which is an output against the velocity, 1 degree ahead of that.
            let ahead_deg: f32 = if told { 91.0 - 180.0 } else { 91.0 };
            (point.phase_rad, point.inverted) = (ahead_deg.to_radians(), told);
        }
        let certificate = of_kind(&record, "mV/(mm/s)");
        assert!(certificate.inverted, "{told}");
        for (_, values) in certificate.results() {
            assert!(
                (values.phase_deg - 1.0).abs() < 1e-4,
                "{}",
                values.phase_deg
            );
        }
    }
}

/// 10.2 mV/(m/s2) through 10 mV/pC are 1.02 pC/(m/s2). U of the sample is 0.6664 %, that of the gain 1 %:
/// sqrt(0.6664^2 + 1^2) = 1.2017 %; of the frequency twice 0.01 %/sqrt(3) is nothing beside it.
#[test]
fn the_gain_of_a_charge_amplifier_is_in_the_value_and_in_u() {
    let certificate = of_kind(&record(&[160.0, 1000.0]), "pC/g at 10 mV/pC +-1%");
    let (_, values) = certificate.reference_result().expect("valid");
    assert!((values.sensitivity / 1.020_025_5e-12 - 1.0).abs() < 1e-6);
    let u = values.expanded_uncertainty_percent;
    assert!((u / 1.2017 - 1.0).abs() < 1e-3, "{u}");
    // One gain for all frequencies: a response has none of it.
    let plain = of_kind(&record(&[160.0, 1000.0]), "mV/g");
    let deviation = |certificate: &Certificate| {
        let values = certificate.points[1].values().expect("valid");
        let of = values.deviation.and_then(|deviation| deviation.uncertainty);
        of.expect("beside the reference point").expanded_percent
    };
    let (with, without) = (deviation(&certificate), deviation(&plain));
    assert!((with / without - 1.0).abs() < 1e-4, "{with} {without}");
    let rows = &certificate.budget.as_ref().expect("a budget").rows;
    assert_eq!(rows.iter().filter(|row| row.row == 2).count(), 2);
    let page = text(&certificate, Format::Html).replace('\u{a0}', " ");
    assert!(
        page.contains("10 mV/pC ± 1 % (k = 2)") && page.contains("pC/g"),
        "{page}"
    );
}

#[test]
fn the_frequency_of_a_conversion_is_in_the_budget() {
    let of = |kind: &str| of_kind(&coil(&[160.0]), kind).budget.expect("a budget");
    for (kind, times) in [("mV/(mm/s)", 1.0), ("mV/um", 2.0)] {
        let budget = of(kind);
        let frequency: Vec<f64> = budget
            .rows
            .iter()
            .filter(|row| row.row == 12)
            .map(|row| row.value_percent)
            .collect();
        assert!(
            frequency
                .iter()
                .any(|v| (v / (0.01 * times) - 1.0).abs() < 1e-5),
            "{frequency:?}"
        );
    }
}

#[test]
fn linearity_of_a_velocity_transducer_is_over_velocity() {
    let mut record = record(&[80.0]);
    record.points.clear();
    for acceleration_rms_ms2 in [1.0, 10.0, 50.0] {
        let mut measured = point(160.0);
        measured.spec.acceleration_rms_ms2 = acceleration_rms_ms2;
        record.points.push(measured).expect("room");
    }
    let certificate = of_kind(&record, "mV/(mm/s)");
    let stated = certificate
        .statement("calibration", "linearity")
        .expect("three levels");
    let Value::List(all) = stated else {
        panic!("{stated:?}")
    };
    let Value::Phrase(_, values) = &all[0] else {
        panic!("{all:?}")
    };
    // 1 and 50 m/s2 over w = 1005.31 rad/s.
    assert_eq!(values[1], Value::Exact(0.9947, "mm/s"));
    assert_eq!(values[2], Value::Exact(49.74, "mm/s"));
}

#[test]
fn a_transmitter_is_reported_only() {
    let burden = "mA/(mm/s) at 250 ohm +-0.1%";
    let certificate = of_kind(&coil(&[80.0, 160.0]), burden);
    let (_, values) = certificate.reference_result().expect("valid");
    // 4 V/(m/s) over 250 ohm.
    assert!((values.sensitivity / 0.016 - 1.0).abs() < 2e-7);
    let said = certificate
        .remarks
        .iter()
        .any(|remark| remark.key == "reported_only");
    assert!(said, "{:?}", certificate.remarks);
    let german = render(&certificate, Format::Html, Language::De).expect("renders");
    let german = String::from_utf8_lossy(&german).replace('\u{a0}', " ");
    assert!(
        german.contains("Bürde von 250 Ω ± 0,1 % (k = 2)"),
        "{german}"
    );
    let judged = known(burden, "0.016 mA/(mm/s)", "5");
    let error = Particulars::default()
        .for_device(&judged)
        .expect_err("no tolerance");
    assert!(error.to_string().contains("reported only"), "{error}");
}

#[test]
fn what_does_not_fit_the_kind_is_refused() {
    for (kind, decision, names) in [
        ("mV/(mm/s)", "specification = 'api670'", "accelerometers"),
        (
            "mV/(mm/s)",
            "specification = 'nominal'\ntolerance_percent = 5\nnominal_mv_per_g = 100",
            "mV/g is no unit of a sensor that is specified in mV/(mm/s)",
        ),
        (
            "mV/um",
            "specification = 'nominal'\ntolerance_percent = 5",
            "nominal",
        ),
    ] {
        let text = format!("[item]\nunit = '{kind}'\n[decision]\n{decision}");
        let mut particulars: Particulars = toml::from_str(&text).expect("TOML");
        let error = particulars.for_device(&Known::default()).expect_err(kind);
        assert!(error.to_string().contains(names), "{kind}: {error}");
    }
    // A file for the whole laboratory, and a sensor that the logbook knows better.
    let mut house: Particulars = toml::from_str("[item]\nunit = 'mV/g'").expect("TOML");
    let coil = known("mV/(mm/s)", "4 mV/(mm/s)", "5");
    let error = house.for_device(&coil).expect_err("an accelerometer's");
    assert!(
        error.to_string().contains("specified in mV/(mm/s)"),
        "{error}"
    );
    let stated: Result<Particulars, _> = toml::from_str("[item]\nunit = 'pC/g'");
    assert!(
        stated
            .expect_err("no gain")
            .to_string()
            .contains("charge amplifier")
    );
}

/// The calibration before is kept as it was measured, and compared in the quantity of the sensor.
#[test]
fn the_last_calibration_is_compared_in_the_same_quantity() {
    let record = coil(&[80.0, 160.0]);
    let last = |percent: f64| {
        let before = |hz: f64| (hz, 4.0 / (TAU * hz) / (1.0 + percent / 100.0));
        Known {
            kind: Some("mV/(mm/s)".parse().expect("a kind")),
            tolerance: Some("2:last".parse().expect("a tolerance")),
            last: vec![before(80.0), before(160.0)],
            ..Known::default()
        }
    };
    // U is 0.77 %.
    assert_eq!(
        of_known(&record, &last(0.5)).stated_conformity(),
        Stated::Pass
    );
    assert_eq!(
        of_known(&record, &last(4.0)).stated_conformity(),
        Stated::Fail
    );
}

#[test]
fn as_found_and_as_left_are_of_one_kind() {
    let (left, mut found) = (coil(&[80.0, 160.0]), coil(&[160.0]));
    found.head.id = 16;
    found.head.labels.unix_time_s -= 3600;
    found.points[0].sensitivity_v_per_ms2 /= 1.04;
    let mut particulars = Particulars::default();
    particulars.item.unit = Some("mV/(mm/s)".parse::<SensorKind>().expect("a kind"));
    let options = Options {
        particulars,
        as_found: Some(found),
        ..Options::default()
    };
    let prepared = prepare(&left, &[Format::Html], &options).expect("prepared");
    let page = String::from_utf8_lossy(&prepared.files[0].content).into_owned();
    assert!(page.contains("<td>4.00</td>"), "the change in %");
    assert!(!page.contains("mV/(m/s²)"));
}
