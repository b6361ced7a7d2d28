//! Certificates of a run that no host began.

use super::decision::{Stated, Tolerance};
use super::{
    Around, Certificate, Document, Format, Known, Language, Options, Particulars, SensitivityUnit,
    Specified, prepare,
};
use calib_core::stored_list::{Band, Base, ListTerms, Rule};
use calib_protocol::clock::ClockReading;
use calib_protocol::record::Record;
use calib_record::sample::record;

/// A record of 10.2 mV/(m/s2) with U = 0.8 %, of a list whose nominal sensitivity is this.
fn of_a_list(nominal_v_per_ms2: f32) -> Record {
    let band = Band::everywhere(Base::Nominal, 0.05);
    let mut record = record(&[80.0, 160.0, 1000.0]);
    record.list = ListTerms {
        name: "pump".try_into().expect("short"),
        nominal_v_per_ms2,
        unit: "mV/g".try_into().expect("short"),
        rule: Rule::Simple,
        bands: [band].into_iter().collect(),
    };
    record
}

#[test]
fn a_run_of_a_list_is_judged_again_by_the_limits_in_its_record() {
    let stated = |record: &Record, particulars: &Particulars| {
        Certificate::from_record(record, particulars).stated_conformity()
    };
    let nothing = Particulars::default();
    assert_eq!(stated(&of_a_list(0.0102), &nothing), Stated::Pass);
    // 10.2 is 5.9 % above 9.632.
    assert_eq!(stated(&of_a_list(0.009_632), &nothing), Stated::Fail);
    let certificate = Certificate::from_record(&of_a_list(0.009_632), &nothing);
    let conformity = certificate
        .conformity_statement(Language::En)
        .expect("it was judged");
    assert!(
        conformity.because.starts_with("+5.90 % of nominal"),
        "{}",
        conformity.because
    );
    let document = Document::new(&certificate, Language::En);
    let text = serde_json::to_string(&document).expect("JSON");
    assert!(text.contains("\"pump\""), "the list is named");
    // What is stated for the job wins: the same within 10 %.
    let mut wider = Particulars::default();
    let tolerance: Tolerance = "10".parse().expect("percent");
    wider
        .for_device(&Known {
            tolerance: Some(tolerance),
            nominal: Some(Specified::of_si(0.009_632, SensitivityUnit::default())),
            ..Known::default()
        })
        .expect("complete");
    assert_eq!(stated(&of_a_list(0.009_632), &wider), Stated::Pass);
}

#[test]
fn a_run_of_a_host_is_judged_by_nothing_in_its_record() {
    let certificate = Certificate::from_record(&record(&[160.0]), &Particulars::default());
    assert_eq!(certificate.stated_conformity(), Stated::NotSpecified);
    assert!(certificate.statement("calibration", "list").is_none());
}

/// 2025-11-21, noon, and days around it.
const NOON: u64 = 1_763_726_400;
const DAY: u64 = 86_400;

/// A run that nobody told the time, between records of these times.
fn dated(before: Option<u64>, behind: Option<u64>, own: u64) -> Certificate {
    let mut record = record(&[160.0]);
    record.head.labels.unix_time_s = own;
    let particulars = Particulars {
        around: Around {
            before_unix_time_s: before,
            behind_unix_time_s: behind,
        },
        ..Particulars::default()
    };
    Certificate::from_record(&record, &particulars)
}

#[test]
fn a_run_without_a_time_is_dated_by_the_records_around_it() {
    let words = |before, behind| dated(before, behind, 0).dated(Language::En);
    let said = |text: &str| Some(text.to_owned());
    assert_eq!(
        words(Some(NOON - 3 * DAY), Some(NOON)),
        said("between 2025-11-18 and 2025-11-21, by the records before and after")
    );
    assert_eq!(words(Some(NOON), Some(NOON + 3_600)), said("2025-11-21"));
    assert_eq!(
        words(Some(NOON), None),
        said("not before 2025-11-21, by the record before")
    );
    assert_eq!(
        words(None, Some(NOON)),
        said("not after 2025-11-21, by the record after")
    );
    assert_eq!(words(None, None), None);
    // A time of its own wins.
    let own = dated(Some(NOON - 3 * DAY), Some(NOON + DAY), NOON);
    assert_eq!(own.dated(Language::En), said("2025-11-21"));
    assert!(own.between.is_none());
}

#[test]
fn a_clock_that_went_backwards_is_told_and_dates_nothing() {
    let told = |certificate: &Certificate| {
        let mut keys = certificate.remarks.iter().map(|remark| remark.key);
        keys.any(|key| key == "clock_backwards")
    };
    let contradictory = dated(Some(NOON), Some(NOON - DAY), 0);
    assert!(told(&contradictory));
    assert_eq!(contradictory.dated(Language::En), None);
    // Of a run of an hour before the one before it, and of one just before the one behind it.
    assert!(told(&dated(Some(NOON + 3_600), None, NOON)));
    assert!(!told(&dated(Some(NOON + 60), Some(NOON + 3_600), NOON)));
}

#[test]
fn a_digital_certificate_states_first_and_last_day() {
    let mut record = record(&[160.0]);
    record.head.labels.unix_time_s = 0;
    let mut particulars: Particulars = toml::from_str(super::tests_dcc::FULL).expect("TOML");
    particulars.calibration.date = None;
    particulars.around = Around {
        before_unix_time_s: Some(NOON - 3 * DAY),
        behind_unix_time_s: Some(NOON),
    };
    let options = Options {
        particulars,
        ..Options::default()
    };
    let prepared = prepare(&record, &[Format::Dcc], &options).expect("written");
    let dcc = String::from_utf8(prepared.files[0].content.clone()).expect("UTF-8");
    assert!(
        dcc.contains("<dcc:beginPerformanceDate>2025-11-18<"),
        "{dcc}"
    );
    assert!(dcc.contains("<dcc:endPerformanceDate>2025-11-21<"), "{dcc}");
}

#[test]
fn how_the_instrument_knows_the_time_is_said() {
    let mut record = record(&[160.0]);
    record.clock = ClockReading {
        told_unix_time_s: NOON - 10 * DAY,
        uncertainty_s: 88,
    };
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let document = Document::new(&certificate, Language::En);
    let text = serde_json::to_string(&document).expect("JSON");
    assert!(
        text.contains("host told it on 2025-11-11 12:00 UTC; it may be off by 88"),
        "{text}"
    );
}
