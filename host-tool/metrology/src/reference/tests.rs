//! Certificates as laboratories give them out, and as somebody who means no good writes them.

use super::*;
use calib_files::Error;

fn parsed(name: &str, text: &str, reading: &Reading) -> Result<Certified> {
    let source = Source::from_text(Path::new(name), text)?;
    match text.trim_start().starts_with('<') {
        true => dcc::read(&source, reading),
        false => table::read(source, reading),
    }
}

fn plain(name: &str, text: &str) -> Result<Certified> {
    parsed(name, text, &Reading::default())
}

/// A DCC of one object with these quantities in its list.
fn dcc(quantities: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?>\n<dcc:digitalCalibrationCertificate xmlns:dcc=\"https://ptb.de/dcc\" \
         xmlns:si=\"https://ptb.de/si\" schemaVersion=\"3.3.0\">\n<dcc:administrativeData>\n<dcc:coreData>\
         <dcc:uniqueIdentifier>K 7</dcc:uniqueIdentifier><dcc:endPerformanceDate>2026-05-04</dcc:endPerformanceDate>\
         </dcc:coreData>\n<dcc:items><dcc:item><dcc:manufacturer><dcc:name><dcc:content>Maker</dcc:content></dcc:name>\
         </dcc:manufacturer><dcc:model>M 1</dcc:model><dcc:identifications><dcc:identification>\
         <dcc:issuer>customer</dcc:issuer><dcc:value>X</dcc:value></dcc:identification><dcc:identification>\
         <dcc:issuer>manufacturer</dcc:issuer><dcc:value>R 17</dcc:value></dcc:identification></dcc:identifications>\
         </dcc:item></dcc:items>\n<dcc:calibrationLaboratory><dcc:contact><dcc:name><dcc:content>Lab</dcc:content>\
         </dcc:name></dcc:contact></dcc:calibrationLaboratory>\n<dcc:statements><dcc:statement>\
         <dcc:traceable>true</dcc:traceable><dcc:declaration><dcc:content>to the SI</dcc:content></dcc:declaration>\
         </dcc:statement></dcc:statements></dcc:administrativeData>\n<dcc:measurementResults><dcc:measurementResult>\
         <dcc:results><dcc:result><dcc:name><dcc:content>Results</dcc:content></dcc:name><dcc:data><dcc:list>\n\
         {quantities}\n</dcc:list></dcc:data></dcc:result></dcc:results></dcc:measurementResult>\
         </dcc:measurementResults></dcc:digitalCalibrationCertificate>"
    )
}

fn quantity(name: &str, unit: &str, values: &str, expanded: Option<(&str, &str)>) -> String {
    let expanded = expanded.map_or(String::new(), |(u, k)| {
        let k = match k {
            "" => String::new(),
            k => format!("<si:coverageFactorXMLList>{k}</si:coverageFactorXMLList>"),
        };
        format!(
            "<si:measurementUncertaintyUnivariateXMLList><si:expandedMUXMLList><si:valueExpandedMUXMLList>{u}\
             </si:valueExpandedMUXMLList>{k}</si:expandedMUXMLList></si:measurementUncertaintyUnivariateXMLList>"
        )
    });
    format!(
        "<dcc:quantity refType=\"{name}\"><si:realListXMLList><si:valueXMLList>{values}</si:valueXMLList>\
         <si:unitXMLList>{unit}</si:unitXMLList>{expanded}</si:realListXMLList></dcc:quantity>\n"
    )
}

const HZ: &str = r"\hertz";
const MV: &str = r"\milli\volt\metre\tothe{-1}\second\tothe{2}";

/// Frequencies, magnitudes with U and k, and phases.
fn lists(hz: &str, unit: &str, s: &str, u: &str, k: &str) -> String {
    dcc(&[
        quantity("vib_frequency", HZ, hz, None),
        quantity("vib_sensitivityMagnitude", unit, s, Some((u, k))),
        quantity(
            "vib_sensitivityPhase",
            r"\degree",
            "0.1 179 0.2",
            Some(("0.5", "2")),
        ),
    ]
    .concat())
}

#[test]
fn a_dcc_says_whose_it_is_and_its_table() {
    let text = lists(
        "80 160 1000",
        MV,
        "10.1 10.2 10.3",
        "0.1 0.15 0.2",
        "2 2.5 2",
    );
    let read = plain("r.xml", &text).expect("a DCC");
    let said = (
        read.serial.as_deref(),
        read.model.as_deref(),
        read.certificate.as_deref(),
    );
    assert_eq!(said, (Some("R 17"), Some("Maker M 1"), Some("K 7")));
    assert_eq!(
        (read.laboratory.as_deref(), read.traceability.as_deref()),
        (Some("Lab"), Some("to the SI"))
    );
    assert_eq!(read.calibrated, Some(jiff::civil::date(2026, 5, 4)));
    let stored = read.calibration("r.xml", false).expect("complete");
    assert_eq!(stored.certificate.as_str(), "K 7, Lab");
    // 2026-05-04 is day 20 577: 56 years of 365 days, 14 leap days, and 123 days of 2026.
    assert_eq!(stored.calibrated_day, 56 * 365 + 14 + 123);
    let row = stored.points[1];
    assert!((row.sensitivity_v_per_ms2 / 0.0102 - 1.0).abs() < 1e-6);
    // U = 0.15 of 10.2 with k = 2.5 is 0.12 of 10.2 with k = 2.
    assert!((row.expanded_uncertainty_rel * 10.2 / 0.12 - 1.0).abs() < 1e-6);
    assert!((row.phase_rad.to_degrees() - 179.0).abs() < 1e-4);
    assert!((row.expanded_uncertainty_phase_rad.to_degrees() - 0.5).abs() < 1e-5);
}

#[test]
fn what_is_wrong_with_a_dcc_is_named_with_its_line() {
    let good = lists("80 160 1000", MV, "10.1 10.2 10.3", "0.1", "2");
    assert!(plain("r.xml", &good).is_ok());
    let two = good.replace(
        "</dcc:item></dcc:items>",
        "</dcc:item><dcc:item/></dcc:items>",
    );
    let other_unit = |unit| lists("80 160 1000", unit, "10.1 10.2 10.3", "0.1", "2");
    let without_u = dcc(&[
        quantity("vib_frequency", HZ, "80", None),
        quantity("vib_sensitivityMagnitude", MV, "10", None),
    ]
    .concat());
    let bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE b [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;\">]>\n<b>&b;</b>";
    for (text, words) in [
        (two, "more than one object"),
        (
            lists("80 160 160", MV, "10.1 10.2 10.3", "0.1", "2"),
            "160 Hz after 160 Hz",
        ),
        (
            lists("160 80 1000", MV, "10.1 10.2 10.3", "0.1", "2"),
            "80 Hz after 160 Hz",
        ),
        (
            lists("80 160 1000", MV, "10,1 10.2 10.3", "0.1", "2"),
            "'10,1'",
        ),
        (
            lists("80 160 1000", MV, "NaN 10.2 10.3", "0.1", "2"),
            "'NaN'",
        ),
        (
            lists("80 160 1000", MV, "inf 10.2 10.3", "0.1", "2"),
            "'inf'",
        ),
        (
            lists("80 160 1000", MV, "10.1 10.2", "0.1", "2"),
            "3 frequencies, and 2 values",
        ),
        (
            lists("80 160 1000", MV, "10.1 10.2 10.3", "0.1 0.1", "2"),
            "2 uncertainties for 3 values",
        ),
        (
            lists("80 160 1000", MV, "10.1 10.2 10.3", "0.1", ""),
            "without a coverage factor",
        ),
        (
            lists("80 160 1000", MV, "10.1 10.2 10.3", "0.1", "0.1"),
            "no coverage factor",
        ),
        (
            lists("80 160 1000", MV, "10.1 10.2 10.3", "0", "2"),
            "U = 0 %",
        ),
        (
            lists("80 160 1000", MV, "-10.1 10.2 10.3", "0.1", "2"),
            "no sensitivity",
        ),
        (
            lists("80 160 1e9", MV, "10.1 10.2 10.3", "0.1", "2"),
            "no frequency",
        ),
        (without_u, "no expanded uncertainties"),
        (
            other_unit(r"\furlong"),
            "no unit of vib_sensitivityMagnitude",
        ),
        (
            other_unit(r"\pico\coulomb\metre\tothe{-1}\second\tothe{2}"),
            "of charge",
        ),
        (
            other_unit(r"\milli\volt\milli\metre\tothe{-1}\second"),
            "velocity or displacement",
        ),
        (bomb.to_owned(), "no XML that can be read"),
        ("<a><b></a>".to_owned(), "no XML that can be read"),
        ("<html/>".to_owned(), "no DCC"),
        (dcc(""), "no list of sensitivities"),
        ("<a>".repeat(300_000), "no XML that can be read"),
    ] {
        let error = plain("r.xml", &text).expect_err(words);
        let said = error.to_string();
        assert!(
            said.contains(words) && said.starts_with("r.xml:"),
            "{words}: {said}"
        );
        assert_eq!(error.exit_code(), 6);
    }
}

#[test]
fn a_csv_as_a_laboratory_writes_it_is_read() {
    let german = "# serial: R 17\n# certificate: K 7\n# laboratory: Labor\n# calibrated: 2026-05-04\n# due: 2028-05-04\n\
        # traceability: PTB\nFrequenz (Hz);S (mV/(m/s²));U (%);k;Phase (°);U_phase (°)\n80;10,1;0,5;2;-0,1;0,5\n160;10,2;0,5;2;0;0,5\n";
    let read = plain("r.csv", german).expect("a table");
    let stored = read.calibration("r.csv", false).expect("complete");
    assert_eq!(
        (stored.serial.as_str(), stored.certificate.as_str()),
        ("R 17", "K 7, Labor")
    );
    assert_eq!(stored.due_day, 56 * 365 + 14 + 123 + 731);
    assert!((stored.points[0].sensitivity_v_per_ms2 / 0.0101 - 1.0).abs() < 1e-6);
    assert!((stored.points[0].phase_rad.to_degrees() + 0.1).abs() < 1e-6);
    // Deviations from 10 mV/(m/s2), and no phase.
    let deviations = "frequency_hz,deviation_percent,u_percent,k\n80,-1,0.5,2\n160,0,0.5,2\n";
    let reading = Reading {
        sensitivity_v_per_ms2: Some(0.01),
        ..Reading::default()
    };
    let read = parsed("d.csv", deviations, &reading).expect("deviations");
    assert!((read.points[0].sensitivity_v_per_ms2 / 0.0099 - 1.0).abs() < 1e-12);
    let named = Certified {
        serial: Some("R".into()),
        certificate: Some("K".into()),
        calibrated: Some(jiff::civil::date(2026, 5, 4)),
        ..read
    };
    let error = named.calibration("d.csv", false).expect_err("no phase");
    assert!(
        error
            .hint()
            .is_some_and(|hint| hint.contains("--without-phase")),
        "{error}"
    );
    let stored = named.calibration("d.csv", true).expect("without");
    assert_eq!(
        stored.points[0].expanded_uncertainty_phase_rad,
        std::f32::consts::PI
    );
}

#[test]
fn what_is_wrong_with_a_csv_is_named_with_its_line() {
    let head = "frequency_hz,sensitivity_mv_per_ms2,u_percent,k\n";
    for (text, words) in [
        (
            format!("{head}80,10,0.5,2\n80,10,0.5,2\n"),
            "r.csv:3: 80 Hz after 80 Hz",
        ),
        (
            format!("{head}160,10,0.5,2\n80,10,0.5,2\n"),
            "r.csv:3: 80 Hz after 160 Hz",
        ),
        (
            format!("{head}80,nan,0.5,2\n"),
            "r.csv:2: sensitivity_mv_per_ms2 = 'nan'",
        ),
        (format!("{head}80,10,,2\n"), "r.csv:2: u_percent = ''"),
        (format!("{head}80,10,0.5,\n"), "r.csv:2: k = ''"),
        (format!("{head}80,10,60,2\n"), "U = 60 %"),
        (format!("{head}80,10,0.5,20\n"), "no coverage factor"),
        (format!("{head}80,10,5,0.5,2\n"), "5 cells"),
        (
            "frequency_hz,sensitivity_mv_per_ms2,k\n80,10,2\n".into(),
            "expanded uncertainty",
        ),
        (
            "frequency_hz,sensitivity_mv_per_ms2,u_percent\n80,10,1\n".into(),
            "coverage factor",
        ),
        (
            "frequency_hz,sensitivity,u_percent,k\n80,10,1,2\n".into(),
            "sensitivity with its unit",
        ),
        (
            "frequency,sensitivity_mv_per_ms2,u_percent,k\n80,10,1,2\n".into(),
            "the frequency",
        ),
        (
            "frequency_hz,deviation_percent,u_percent,k\n80,1,1,2\n".into(),
            "deviations alone",
        ),
        (
            "frequency_hz,sensitivity_mv_per_ms2,u_percent,k,phase_deg\n80,10,1,2,0\n".into(),
            "without an uncertainty",
        ),
        (
            format!("# calibrated: 4.5.2026\n{head}80,10,1,2\n"),
            "r.csv:1: '4.5.2026' is no day",
        ),
    ] {
        let error = plain("r.csv", &text).expect_err(words);
        assert!(error.to_string().contains(words), "{words}: {error}");
        assert!(error.to_string().starts_with("r.csv:"), "{error}");
    }
}

#[test]
fn what_the_settings_have_no_room_for_is_refused() {
    let rows: String = (0..60)
        .map(|n| format!("{},10,0.5,2,0,1\n", 20 + n))
        .collect();
    let text = format!(
        "# calibrated: 2026-05-04\nfrequency_hz,sensitivity_mv_per_ms2,u_percent,k,phase_deg,u_phase_deg\n{rows}"
    );
    let mut read = plain("r.csv", &text).expect("a table");
    let refused = |read: &Certified, words: &str| {
        let error: Error = read.calibration("r.csv", false).expect_err(words);
        assert!(error.to_string().contains(words), "{error}");
    };
    refused(&read, "60 frequencies: the instrument holds 48");
    read.points.truncate(48);
    refused(&read, "does not say the serial number");
    read.serial = Some("R".repeat(33));
    refused(&read, "longer than 32 bytes");
    read.serial = Some("R".into());
    refused(&read, "does not say the number of the certificate");
    read.certificate = Some("K\u{7}".into());
    refused(&read, "control characters");
    read.certificate = Some("K".into());
    read.calibrated = None;
    refused(&read, "the day of calibration");
}

/// Values of somebody who means no good.
const NASTY: [&str; 14] = [
    "-",
    "NaN",
    "1e400",
    "<",
    "&",
    "\"",
    "{-2147483648}",
    "\\per",
    "",
    "\n",
    ",",
    ";",
    "\u{20ac}",
    "2147483648",
];

proptest::proptest! {
    /// Damaged anywhere, a certificate is refused with its place, or what it says can be stored or is refused.
    #[test]
    fn damage_is_refused_or_harmless(
        is_dcc in proptest::bool::ANY,
        damage in proptest::collection::vec((0.0..1.0_f64, 0_usize..14, 0_usize..9), 1..4),
    ) {
        let mut text = match is_dcc {
            true => lists("80 160 1000", MV, "10.1 10.2 10.3", "0.1", "2"),
            false => "# calibrated: 2026-05-04\nfrequency_hz;sensitivity_mv_per_ms2;u_percent;k\n80;10,1;0,5;2\n".to_owned(),
        };
        for (place, nasty, length) in damage {
            let boundary = |at: usize| (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(0);
            let begin = boundary((place * text.len() as f64) as usize);
            let end = boundary((begin + length).min(text.len()));
            text.replace_range(begin..end, NASTY[nasty]);
        }
        match plain("r.file", &text) {
            Ok(read) => drop(read.calibration("r.file", true)),
            Err(error) => proptest::prop_assert!(error.to_string().starts_with("r.file"), "{}", error),
        }
    }
}
