//! A certificate that cannot lie: every statement here was false once.

use super::tests_dcc::FULL;
use super::{Format, IntervalRule, Mark, Options, Particulars, Prepared, ReferenceCheck, prepare};
use calib_protocol::record::Record;
use calib_record::sample::{record, text};

/// The serial number of the emulated instrument.
const EMULATED: &str = "23004100075457494E303120";

fn particulars(text: &str) -> Particulars {
    toml::from_str(text).expect("TOML")
}

/// [`FULL`] with one line replaced, or left out.
fn without(line: &str, instead: &str) -> Particulars {
    let begins = |found: &str| found.starts_with(line);
    assert!(FULL.lines().any(begins), "{line}");
    let lines = FULL.lines();
    let lines = lines.map(|found| if begins(found) { instead } else { found });
    particulars(&lines.collect::<Vec<_>>().join("\n"))
}

fn prepared(record: &Record, particulars: Particulars) -> calib_files::Result<Prepared> {
    let options = Options {
        particulars,
        ..Options::default()
    };
    prepare(record, &Format::ALL, &options)
}

fn sample() -> Record {
    record(&[160.0, 1000.0])
}

fn of(prepared: &Prepared, format: Format) -> String {
    let file = prepared.files.iter().find(|file| file.format == format);
    String::from_utf8_lossy(&file.expect("asked for").content).into_owned()
}

fn marks(prepared: &Prepared) -> Vec<Mark> {
    prepared.marks.iter().map(|(mark, _)| *mark).collect()
}

/// Formats that are text; the PDF is looked at page by page in `tests_pdf`.
const TEXTS: [Format; 5] = [
    Format::Csv,
    Format::Json,
    Format::Html,
    Format::Dcc,
    Format::Uff,
];

#[test]
fn a_complete_certificate_carries_no_mark_in_any_format() {
    let complete = prepared(&sample(), particulars(FULL)).expect("rendered");
    assert_eq!(complete.marks, []);
    for format in TEXTS {
        let text = of(&complete, format).to_lowercase();
        for word in ["entwurf", "draft", "simul"] {
            assert!(!text.contains(word), "{format:?}: {word}");
        }
    }
}

#[test]
fn whatever_is_missing_makes_a_draft_of_every_format() {
    let lines = [
        "name = \"Beispiel",
        "street",
        "city = \"Braun",
        "name = \"Pumpen",
        "issued",
        "approved_by",
        "measurand",
        "ambient",
        "humidity",
    ];
    for line in lines {
        let draft = prepared(&sample(), without(line, "")).expect("rendered");
        assert_eq!(marks(&draft), [Mark::Draft], "{line}");
        for format in TEXTS {
            let text = of(&draft, format);
            let said = ["ENTWURF", "draft", "DRAFT"];
            assert!(said.iter().any(|word| text.contains(word)), "{format:?}");
        }
    }
    let mut nobody = sample();
    nobody.head.labels.dut_serial = text("");
    let draft = prepared(&nobody, particulars(FULL)).expect("rendered");
    assert_eq!(marks(&draft), [Mark::Draft]);
    assert!(
        draft.marks[0].1.contains("Seriennummer"),
        "{:?}",
        draft.marks
    );
}

#[test]
fn what_an_emulated_instrument_measured_is_marked_and_not_traceable() {
    let mut emulated = sample();
    emulated.head.instrument_serial = text(EMULATED);
    let simulated = prepared(&emulated, particulars(FULL)).expect("rendered");
    assert_eq!(marks(&simulated), [Mark::Simulated]);
    for format in TEXTS {
        let text = of(&simulated, format);
        let said = ["SIMULIERT", "simulated", "SIMULATED"];
        assert!(said.iter().any(|word| text.contains(word)), "{format:?}");
    }
    let dcc = of(&simulated, Format::Dcc);
    assert!(dcc.contains("<dcc:traceable>false</dcc:traceable>"));
    let real = of(
        &prepared(&sample(), particulars(FULL)).expect("rendered"),
        Format::Dcc,
    );
    assert!(real.contains("<dcc:traceable>true</dcc:traceable>"));
}

#[test]
fn traceable_is_what_has_a_chain_that_was_in_force() {
    let changes: [fn(&mut Record); 5] = [
        |r| r.settings.reference.certificate = text(""),
        |r| r.settings.reference.serial = text(" "),
        |r| r.settings.reference.calibrated_day = 0,
        |r| r.settings.reference.due_day = 0,
        // Calibrated after it was used: the run is of 2025-11-21, day 20 413.
        |r| r.settings.reference.calibrated_day = 20_414,
    ];
    for (index, change) in changes.iter().enumerate() {
        let mut record = sample();
        change(&mut record);
        let untraceable = prepared(&record, particulars(FULL)).expect("rendered");
        let dcc = of(&untraceable, Format::Dcc);
        assert!(
            dcc.contains("<dcc:traceable>false</dcc:traceable>"),
            "{index}"
        );
    }
}

#[test]
fn an_overdue_reference_is_refused_unless_overridden_in_writing() {
    let mut overdue = sample();
    overdue.settings.reference.due_day = 20_400; // the run is of day 20 413
    let error = prepared(&overdue, particulars(FULL)).expect_err("overdue");
    assert!(error.to_string().contains("2025-11-08"), "{error}");
    assert!(
        error
            .hint()
            .expect("a way out")
            .contains("overdue_reference")
    );
    let reason = "overdue_reference = \"recalibration ordered, check standard in control\"";
    let allowed = without("deviations", reason);
    let allowed = prepared(&overdue, allowed).expect("overridden");
    for format in TEXTS {
        let text = of(&allowed, format);
        assert!(text.contains("check standard in control"), "{format:?}");
    }
    assert!(of(&allowed, Format::Dcc).contains("<dcc:traceable>false</dcc:traceable>"));
}

#[test]
fn a_check_standard_that_failed_blocks_every_format_or_is_overridden_in_each() {
    use crate::{CheckProblem, FailedCheck};
    let failed = FailedCheck {
        serial: "CHK-1".into(),
        problem: CheckProblem::OutOfControl(jiff::civil::date(2025, 11, 20)),
    };
    let with = |particulars: Particulars| {
        let options = Options {
            particulars,
            failed_checks: vec![failed.clone()],
            ..Options::default()
        };
        prepare(&sample(), &Format::ALL, &options)
    };
    let error = with(particulars(FULL)).expect_err("out of control");
    assert!(
        error.to_string().contains("CHK-1 is out of control"),
        "{error}"
    );
    assert!(error.hint().expect("a way out").contains("check_override"));
    let reason = "check_override = \"repeated by hand, agrees\"";
    let overridden = with(without("deviations", reason)).expect("overridden");
    for format in TEXTS {
        let text = of(&overridden, format);
        assert!(text.contains("repeated by hand, agrees"), "{format:?}");
    }
}

/// A check two days before the run of the sample: -0.12 % +- 0.40 %.
const CHECK: ReferenceCheck = ReferenceCheck {
    day: jiff::civil::date(2025, 11, 19),
    by_gravity: false,
    since_baseline: true,
    change_rel: -0.0012,
    expanded_rel: 0.004,
    significant: false,
};

fn checked(check: ReferenceCheck, particulars: Particulars) -> Particulars {
    Particulars {
        reference_check: Some(check),
        ..particulars
    }
}

#[test]
fn a_check_of_the_reference_is_stated_where_remarks_are() {
    let sound = prepared(&sample(), checked(CHECK, particulars(FULL))).expect("rendered");
    for format in [Format::Json, Format::Html, Format::Dcc] {
        let text = of(&sound, format).replace('\u{2212}', "-");
        assert!(text.contains("durch Reziprozität geprüft"), "{format:?}");
        let value = text.contains("-0,12") && text.contains("0,40");
        assert!(value, "{format:?}");
    }
}

#[test]
fn a_reference_that_changed_blocks_a_certificate_or_is_overridden_in_each() {
    let changed = ReferenceCheck {
        significant: true,
        ..CHECK
    };
    let error = prepared(&sample(), checked(changed, particulars(FULL))).expect_err("changed");
    assert!(error.to_string().contains("2025-11-19"), "{error}");
    assert!(error.hint().expect("a way out").contains("check_override"));
    let reason = "check_override = \"mass was mounted loose, repeated\"";
    let overridden = checked(changed, without("deviations", reason));
    let overridden = prepared(&sample(), overridden).expect("overridden");
    for format in [Format::Json, Format::Html, Format::Dcc] {
        let text = of(&overridden, format);
        assert!(text.contains("GEÄNDERT"), "{format:?}");
        assert!(text.contains("mass was mounted loose"), "{format:?}");
    }
}

/// Due on 2025-11-08, used on 2025-11-21: by the rule until 2025-11-28, as the check is two days old and shows at
/// most 0.52 %.
#[test]
fn a_rule_of_the_laboratory_extends_the_interval_while_the_reference_is_checked() {
    let mut overdue = sample();
    overdue.settings.reference.due_day = 20_400;
    let rule = |days: [u32; 2], percent: f64| IntervalRule {
        extend_days: days[0],
        checked_within_days: days[1],
        largest_change_percent: percent,
    };
    let with = |rule, check| {
        let particulars = Particulars {
            reference_interval: Some(rule),
            ..checked(check, particulars(FULL))
        };
        prepared(&overdue, particulars)
    };
    let extended = with(rule([20, 2], 0.53), CHECK).expect("by the rule");
    for format in [Format::Json, Format::Html, Format::Dcc] {
        let text = of(&extended, format);
        assert!(
            text.contains("nach der Regel") || text.contains("Nach der Regel"),
            "{format:?}"
        );
    }
    assert!(of(&extended, Format::Json).contains("2025-11-28"));
    assert!(of(&extended, Format::Dcc).contains("<dcc:traceable>true</dcc:traceable>"));
    let refused = [
        (rule([12, 2], 0.53), CHECK),
        (rule([20, 1], 0.53), CHECK),
        (rule([20, 2], 0.51), CHECK),
        (
            rule([20, 2], 0.53),
            ReferenceCheck {
                since_baseline: false,
                ..CHECK
            },
        ),
        (
            rule([20, 9], 0.53),
            ReferenceCheck {
                day: jiff::civil::date(2025, 11, 22),
                ..CHECK
            },
        ),
    ];
    for (place, (rule, check)) in refused.into_iter().enumerate() {
        let error = with(rule, check).expect_err(&place.to_string());
        assert!(error.to_string().contains("2025-11-08"), "{place}: {error}");
    }
}

#[test]
fn only_who_authorised_is_the_main_signer() {
    let nobody = prepared(&sample(), without("approved_by", "")).expect("rendered");
    let dcc = of(&nobody, Format::Dcc);
    assert!(!dcc.contains("<dcc:mainSigner>true</dcc:mainSigner>"));
    assert!(dcc.contains("<dcc:mainSigner>false</dcc:mainSigner>"));
    let named = of(
        &prepared(&sample(), particulars(FULL)).expect("rendered"),
        Format::Dcc,
    );
    let signer = named.find("<dcc:mainSigner>true").expect("a signer");
    assert!(named[..signer].contains("Dr. A. Prüferin"));
}

#[test]
fn a_day_of_issue_is_never_made_up_nor_before_the_calibration() {
    let undated = prepared(&sample(), without("issued", "")).expect("rendered");
    assert!(!of(&undated, Format::Dcc).contains("dcc:issueDate"));
    let json: serde_json::Value = serde_json::from_str(&of(&undated, Format::Json)).expect("JSON");
    assert!(json["calibration"]["issued"].is_null());
    let early = without("issued", "issued = 1990-01-01");
    let error = prepared(&sample(), early).expect_err("before");
    assert!(error.to_string().contains("1990-01-01"), "{error}");
    let another = without("issued", "issued = 2025-11-22\ndate = 2025-11-20");
    let error = prepared(&sample(), another).expect_err("two days");
    assert!(error.to_string().contains("2025-11-20"), "{error}");
}

#[test]
fn conditions_that_cannot_be_are_refused_with_their_range() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("job.toml");
    for item in [
        "ambient_temperature_c = -300",
        "humidity_percent = 400",
        "humidity_percent = nan",
        "temperature_difference_k = 1e9",
    ] {
        std::fs::write(&path, format!("[conditions]\n{item}\n")).expect("written");
        let error = Particulars::read(std::slice::from_ref(&path)).expect_err(item);
        assert!(error.to_string().contains("is not between"), "{error}");
    }
}

#[test]
fn no_number_is_minus_nothing() {
    let mut record = sample();
    for point in &mut record.points {
        point.phase_rad = -1.0e-9;
    }
    record.points[1].sensitivity_v_per_ms2 = record.points[0].sensitivity_v_per_ms2 * 0.999_999_9;
    let prepared = prepared(&record, particulars(FULL)).expect("rendered");
    for format in [Format::Csv, Format::Html, Format::Dcc] {
        let text = of(&prepared, format).replace('\u{2212}', "-");
        let nothing = [
            "-0,0;", "-0,00;", "-0,000;", ">-0,0<", ">-0,00<", " -0.00 ", " -0.0 ", ">-0.0",
        ];
        for wrong in nothing {
            assert!(!text.contains(wrong), "{format:?}: {wrong}");
        }
    }
}
