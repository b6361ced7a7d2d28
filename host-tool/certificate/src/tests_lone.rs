//! What a run says that no host began.

use super::decision::{Stated, Tolerance};
use super::{Certificate, Document, Known, Language, Particulars};
use calib_core::stored_list::{Band, Base, ListTerms, Rule};
use calib_protocol::record::Record;
use calib_record::sample::record;

/// A record of 10.2 mV/(m/s2) with U = 0.8 %, of a list whose nominal sensitivity is this.
fn of_a_list(nominal_v_per_ms2: f32) -> Record {
    let band = Band {
        from_hz: 0.0,
        to_hz: f32::MAX,
        base: Base::Nominal,
        lower_rel: -0.05,
        upper_rel: 0.05,
        reference_point_only: false,
    };
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
    let verdict = certificate.verdict(Language::En).expect("it was judged");
    assert!(
        verdict.because.starts_with("+5.90 % of nominal"),
        "{}",
        verdict.because
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
            nominal_v_per_ms2: Some(0.009_632),
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
