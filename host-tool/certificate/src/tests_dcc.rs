//! The digital calibration certificate against schema and schematron.

use super::model::Certificate;
use super::python::{python, shared};
use super::{Amendment, Format, Language, Options, Particulars, Seal, prepare, render};
use calib_core::point_state::{PointState, Reason};
use calib_record::sample::{THIRD_OCTAVES_HZ, record, text};
use calib_signing::LaboratoryKey;
use jiff::Timestamp;
use std::path::Path;
use std::sync::Arc;

fn xml(certificate: &Certificate, language: Language) -> Vec<u8> {
    render(certificate, Format::Dcc, language).expect("renders")
}

/// Certificates that differ in what is stated and what was measured.
fn variants() -> Vec<Vec<u8>> {
    let full: Particulars = toml::from_str(FULL).expect("TOML");
    let mut many: Vec<f32> = (0..200).map(|n| 20.0 * 1.03_f32.powi(n)).collect();
    many.dedup();
    let mut hostile = record(&[160.0]);
    hostile.head.labels.dut_serial = text("O'Neil & <b>Söhne</b> 🎛 \u{7}");
    let mut partly = record(&THIRD_OCTAVES_HZ);
    partly.points[3].state = PointState::Refused(Reason::NotSettled);
    let mut none = record(&[160.0]);
    none.points[0].state = PointState::Refused(Reason::DutOpen);
    // A DCC cannot be without the country of the laboratory.
    let bare: Particulars = toml::from_str("[laboratory]\ncountry = 'DE'").expect("TOML");
    let of = Certificate::from_record;
    let mut amended = full.clone();
    amended.calibration.replaces = Some(Amendment {
        certificate: "K-2026-0117".to_owned(),
        reason: "name of the customer".to_owned(),
    });
    let mut left = of(&record(&[160.0, 16_000.0]), &full);
    left.as_found = Some(Box::new(of(&record(&[160.0]), &full)));
    let of_kind = |text: &str| {
        let mut particulars = bare.clone();
        particulars.item.unit = Some(text.parse().expect(text));
        xml(&of(&record(&[160.0, 1000.0]), &particulars), Language::De)
    };
    vec![
        of_kind("mV/(mm/s)"),
        of_kind("mV/um"),
        of_kind("pC/g at 10 mV/pC +-0.5%"),
        of_kind("mA/g at 250 ohm +-0.1%"),
        of_kind("mA/(mm/s) at 250 ohm +-0.1%"),
        of_kind("mA/um at 250 ohm +-0.1%"),
        // 16 kHz is beyond API 670: judged and others.
        xml(&left, Language::En),
        xml(&of(&record(&THIRD_OCTAVES_HZ), &full), Language::De),
        xml(&of(&record(&[160.0]), &bare), Language::En),
        xml(&of(&record(&many), &full), Language::En),
        xml(&of(&hostile, &bare), Language::En),
        xml(&of(&partly, &full), Language::En),
        xml(&of(&none, &full), Language::De),
        xml(&of(&record(&[160.0]), &amended), Language::En),
        signed(),
    ]
}

/// The key of a laboratory that does not exist.
pub(super) fn seal() -> Seal {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../signing/test-keys/p256.p12");
    let at = Timestamp::from_second(1_795_392_000).expect("23 November 2026");
    let key = LaboratoryKey::open(&path, "test", at).expect("opens");
    Seal {
        key: Arc::new(key),
        at,
    }
}

fn signed() -> Vec<u8> {
    let options = Options {
        particulars: toml::from_str(FULL).expect("TOML"),
        seal: Some(seal()),
        ..Options::default()
    };
    let record = record(&THIRD_OCTAVES_HZ);
    let prepared = prepare(&record, &[Format::Dcc], &options).expect("prepared");
    prepared.files[0].content.clone()
}

/// Every item stated.
pub(super) const FULL: &str = r#"
language = "de"
[laboratory]
name = "Beispiel Kalibrierung GmbH"
street = "Bundesallee 100"
postcode = "38116"
city = "Braunschweig"
country = "DE"
email = "labor@example.org"
phone = "+49 531 0000"
accreditation = "D-K-00000-01-00"
[customer]
name = "Pumpenwerk Musterstadt"
city = "Musterstadt"
[item]
description = "Beschleunigungsaufnehmer mit IEPE-Elektronik"
customer_id = "P-101-VIB-2"
condition = "ohne sichtbare Mängel"
received = 2025-11-19
[calibration]
issued = "2025-11-22"
place = "customer"
place_text = "Pumpenwerk, Halle 3"
approved_by = "Dr. A. Prüferin"
measurand = "with_conditioner"
deviations = "keine"
adjustment = "reported_only"
[conditions]
ambient_temperature_c = 22.6
temperature_difference_k = 0.5
humidity_percent = 44
[mounting]
surface = "Edelstahl, geschliffen"
torque_n_m = 2.0
adhesive = "keiner"
adapters = "keine"
lubricant = "dünner Ölfilm"
cable = "nach 5 cm am Tisch befestigt"
orientation = "senkrecht"
[amplifier]
description = "IEPE-Speisung 4 mA"
gain = "1"
lower_cutoff_hz = 0.5
upper_cutoff_hz = 22000
slope_db_per_octave = 12
[decision]
specification = "api670"
rule = "guard_band"
[texts]
introduction = ["Die Kalibrierung erfolgte nach Hausverfahren HV-7."]
closing = ["Ende des Kalibrierscheins."]
"#;

#[test]
fn schema_and_schematron_accept_every_variant() {
    let Some(script) = shared("dcc/validate_dcc.py") else {
        return;
    };
    let folder = tempfile::tempdir().expect("folder");
    let mut paths = Vec::new();
    for (index, xml) in variants().iter().enumerate() {
        let path = folder.path().join(format!("{index}.xml"));
        std::fs::write(&path, xml).expect("written");
        paths.push(path);
    }
    let mut arguments = vec![script.as_os_str()];
    arguments.extend(paths.iter().map(|path| path.as_os_str()));
    let Some(output) = python("dcclib", &arguments) else {
        return;
    };
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success(),
        "{said}\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    assert_eq!(said.matches("XSD valid").count(), paths.len(), "{said}");
}

#[test]
fn lists_carry_the_printed_numbers_and_their_uncertainties() {
    let particulars: Particulars = toml::from_str(FULL).expect("TOML");
    let certificate = Certificate::from_record(&record(&[160.0, 10_000.0]), &particulars);
    let xml = String::from_utf8(xml(&certificate, Language::En)).expect("UTF-8");
    // 10.2 / (1 - (10/32)^2 ...) = 11.3032 at 10 kHz. Air of 22.6 degrees, told to 1 K: row 11 is 0.168 %, and U =
    // 0.6772 % is 0.0691 and 0.0765.
    assert!(
        xml.contains("<si:valueXMLList>10.200 11.303</si:valueXMLList>"),
        "{xml}"
    );
    assert!(
        xml.contains("<si:valueExpandedMUXMLList>0.069 0.077</si:valueExpandedMUXMLList>"),
        "{xml}"
    );
    assert!(xml.contains("<si:coverageFactorXMLList>2.00 2.00</si:coverageFactorXMLList>"));
    assert!(xml.contains("<dcc:conformityXMLList>pass pass</dcc:conformityXMLList>"));
}

#[test]
fn points_nothing_is_specified_for_have_a_list_of_their_own() {
    let particulars: Particulars = toml::from_str(FULL).expect("TOML");
    let certificate = Certificate::from_record(&record(&[160.0, 16_000.0]), &particulars);
    let xml = String::from_utf8(xml(&certificate, Language::En)).expect("UTF-8");
    assert_eq!(xml.matches("<dcc:result>").count(), 2);
    assert!(xml.contains("<dcc:conformityXMLList>pass</dcc:conformityXMLList>"));
    assert!(xml.contains("nothing is specified for these points"));
}

#[test]
fn without_a_country_there_is_no_dcc_and_the_way_out_is_named() {
    let record = record(&[160.0]);
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let error = render(&certificate, Format::Dcc, Language::En).expect_err("no country");
    assert!(error.to_string().contains("country of the laboratory"));
    assert!(
        error
            .hint()
            .is_some_and(|hint| hint.contains("[laboratory]"))
    );
    // The printed one says that none is inside, and holds none.
    let pdf = render(&certificate, Format::Pdf, Language::En).expect("renders");
    assert!(!String::from_utf8_lossy(&pdf).contains("certificate.dcc.xml"));
    let formats = [Format::Pdf, Format::Dcc];
    let prepared = super::prepare(&record, &formats[..1], &Default::default());
    let lack = prepared.expect("a PDF").lack.expect("said");
    assert!(lack.contains("country"), "{lack}");
    let possible = super::possible(&record, &formats, &Particulars::default());
    assert_eq!(possible, [Format::Pdf]);
    let full: Particulars = toml::from_str(FULL).expect("TOML");
    assert_eq!(super::possible(&record, &formats, &full), formats);
}

#[test]
fn a_record_without_a_date_is_refused_with_the_way_out() {
    let mut record = record(&[160.0]);
    record.head.labels.unix_time_s = 0;
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let error = render(&certificate, Format::Dcc, Language::En).expect_err("no date");
    assert!(
        error
            .hint()
            .is_some_and(|hint| hint.contains("[calibration]")),
        "{error}"
    );
    let particulars: Particulars =
        toml::from_str("[laboratory]\ncountry = 'DE'\n[calibration]\ndate = '2025-11-21'")
            .expect("TOML");
    let certificate = Certificate::from_record(&record, &particulars);
    assert!(render(&certificate, Format::Dcc, Language::En).is_ok());
}
