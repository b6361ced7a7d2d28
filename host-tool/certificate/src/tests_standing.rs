//! A record's place in the chain, as certificates of every format state it.

use super::{Certificate, Format, Options, Particulars, Prepared, digest, prepare};
use calib_protocol::provenance::{LoggedChange, Provenance};
use calib_protocol::record::{self, Record};
use calib_protocol::update::{ImageOrigin, ImageSigner};
use calib_record::hash_chain::{Evidence, Standing};
use calib_record::sample::{THIRD_OCTAVES_HZ, mend, record};

/// Everything passes: the object is within 5 % of its nominal sensitivity.
fn certificate(record_chain: Option<Standing>) -> Prepared {
    // A DCC cannot be without the country of the laboratory.
    let particulars = "[laboratory]\ncountry = 'DE'\n\
        [decision]\nspecification = 'nominal'\ntolerance_percent = 50\nnominal_mv_per_ms2 = 10.2";
    let particulars: Particulars = toml::from_str(particulars).expect("particulars");
    let options = Options {
        particulars,
        record_chain,
        ..Options::default()
    };
    prepare(&record(&THIRD_OCTAVES_HZ), &Format::ALL, &options).expect("rendered")
}

fn file(prepared: &Prepared, format: Format) -> String {
    let file = prepared.files.iter().find(|file| file.format == format);
    String::from_utf8_lossy(&file.expect("asked for").content).into_owned()
}

fn json(prepared: &Prepared) -> serde_json::Value {
    serde_json::from_str(&file(prepared, Format::Json)).expect("JSON")
}

#[test]
fn a_broken_chain_is_a_warning_in_every_format_and_no_conformity_in_any() {
    let broken = certificate(Some(Standing::Broken));
    let words = "Do not use this certificate";
    for format in [Format::Html, Format::Dcc, Format::Json] {
        assert!(file(&broken, format).contains(words), "{format:?}");
    }
    assert!(file(&broken, Format::Uff).contains("DO NOT USE"));
    let csv = file(&broken, Format::Csv);
    assert!(csv.lines().skip(1).all(|line| line.contains(",broken,")));
    let document = json(&broken);
    assert_eq!(document["conformity"], "not_judgeable");
    assert_eq!(document["record_chain"], "broken");
    assert_eq!(document["remarks"][0]["severity"], "error");
    for format in [Format::Html, Format::Dcc, Format::Csv] {
        let text = file(&broken, format).to_lowercase();
        let states = ["conformitypass", "value=\"pass\"", ",valid,,pass,"];
        assert!(
            !states.iter().any(|state| text.contains(state)),
            "{format:?}"
        );
    }
}

#[test]
fn any_other_standing_is_stated_and_leaves_conformity_alone() {
    for (standing, words) in [
        (Standing::Verified, "verified: record 16"),
        (Standing::NotAtHand, "record 16 before it was not at hand"),
        (Standing::First, "the first record of its calibrator"),
    ] {
        let prepared = certificate(Some(standing));
        let document = json(&prepared);
        assert_eq!(document["conformity"], "pass", "{standing:?}");
        for format in [Format::Html, Format::Dcc, Format::Json] {
            assert!(file(&prepared, format).contains(words), "{format:?}");
        }
        assert!(!file(&prepared, Format::Uff).contains("DO NOT USE"));
    }
    // Nobody looked: its number says that there was one before.
    assert_eq!(json(&certificate(None))["record_chain"], "not_at_hand");
}

#[test]
fn the_sum_on_the_certificate_is_that_of_the_file() {
    let record = record(&THIRD_OCTAVES_HZ);
    let mut bytes = vec![0; 64 * 1024];
    let length = record::encode(&record, &mut bytes).expect("fits");
    let sum = record::digest(&bytes[..length]);
    assert_eq!(digest(&record), sum);
    let hexadecimal = hex::encode(sum);
    let printed = json(&certificate(None))["calibration"]["sha256"].clone();
    let printed = printed.as_str().expect("text").replace(' ', "");
    assert_eq!(printed, hexadecimal);
}

/// An altered predecessor with a right checksum is what makes the certificate warn.
#[test]
fn an_altered_neighbour_breaks_the_chain_of_the_certificate() {
    let bytes = |record: &Record| {
        let mut bytes = vec![0; 64 * 1024];
        let length = record::encode(record, &mut bytes).expect("fits");
        bytes.truncate(length);
        bytes
    };
    let mut before = record(&[80.0]);
    before.head.id = 16;
    let mut this = record(&[160.0]);
    this.head.previous_sha256 = record::digest(&bytes(&before));
    let standing = |before: &[u8]| {
        let mut evidence = Evidence::of(&this.head.instrument_serial);
        evidence.bytes(16, before);
        evidence.bytes(17, &bytes(&this));
        evidence.standing(17)
    };
    let whole = bytes(&before);
    assert_eq!(standing(&whole), Standing::Verified);
    let mut altered = whole.clone();
    let middle = altered.len() / 2;
    altered[middle] ^= 1;
    // Damaged, it is no evidence; with its checksum mended it contradicts.
    assert_eq!(standing(&altered), Standing::NotAtHand);
    mend(&mut altered);
    assert_eq!(standing(&altered), Standing::Broken);
}

/// The key is stated where the signature was verified, and there alone.
#[test]
fn the_key_is_stated_of_a_signature_that_was_verified() {
    let bytes = calib_record::sample::signed(&record(&[160.0]), &[5; 32]);
    let signed = record::decode(&bytes).expect("a record");
    let stated = |record_chain| {
        let options = Options {
            record_chain,
            ..Options::default()
        };
        let html = prepare(&signed, &[Format::Html], &options).expect("rendered");
        file(&html, Format::Html).contains("signed by the instrument")
    };
    assert!(stated(Some(Standing::Verified)));
    assert!(!stated(Some(Standing::Broken)));
    assert!(!stated(None));
}

/// Settings that differ from those the last change of the reference's calibration left are told with both
/// changes; settings that are the same are not, whatever was changed in between.
#[test]
fn settings_changed_since_the_reference_was_calibrated_are_told() {
    let told = |sha256: u8| {
        let mut record = record(&[160.0]);
        let change = |record_id, unix_time_s| LoggedChange {
            record_id,
            unix_time_s,
        };
        record.provenance = Provenance {
            sha256: [sha256; 32],
            // date -u -d 2026-11-22 +%s; a host without a clock.
            changed: change(7, 1_795_305_600),
            reference_changed: change(3, 0),
            sha256_at_reference: [1; 32],
        };
        let certificate = Certificate::from_record(&record, &Particulars::default());
        let html = prepare(&record, &[Format::Html], &Options::default()).expect("rendered");
        let html = file(&html, Format::Html);
        assert!(html.contains("SHA-256 of all settings"));
        let key = |remark: &super::model::Remark| remark.key == "settings_changed";
        assert_eq!(certificate.remarks.iter().any(key), sha256 != 1);
        html
    };
    let words = "since the calibration of its reference was entered (record 3, \u{2013}), last by record 7 \
                 (2026-11-22)";
    assert!(told(2).contains(words));
    assert!(!told(1).contains(words));
    // A release that did not say has nothing to compare.
    let untold = record(&[160.0]);
    assert_eq!(untold.provenance, Provenance::UNKNOWN);
    let html = prepare(&untold, &[Format::Html], &Options::default()).expect("rendered");
    assert!(!file(&html, Format::Html).contains("settings have changed"));
}

/// The image that measured is told by its sum, and one that anybody may have signed is told as that.
#[test]
fn the_image_that_measured_is_told_and_one_under_development() {
    let told = |signer| {
        let mut record = record(&[160.0]);
        record.image = ImageOrigin {
            sha256: [0xA5; 32],
            signer,
        };
        let html = prepare(&record, &[Format::Html], &Options::default()).expect("rendered");
        file(&html, Format::Html)
    };
    let [development, release] = [ImageSigner::Development, ImageSigner::Release].map(told);
    for html in [&development, &release] {
        assert!(html.contains("SHA-256 of the firmware") && html.contains("a5a5"));
    }
    assert!(development.contains("DEVELOPMENT") && !release.contains("DEVELOPMENT"));
    let untold = prepare(&record(&[160.0]), &[Format::Html], &Options::default());
    let untold = untold.expect("rendered");
    assert!(!file(&untold, Format::Html).contains("SHA-256 of the firmware"));
}
