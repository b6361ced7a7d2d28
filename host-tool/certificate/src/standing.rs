//! A record's place in the chain, as a certificate states it.

use super::model::{Certificate, Entry, Remark, Severity, Value};
use calib_output::code;
use calib_protocol::provenance::Provenance;
use calib_protocol::record::{self, Record, Sha256Sum};
use calib_protocol::update::ImageOrigin;
use calib_record::hash_chain::Standing;

/// Room for any record.
const LONGEST: usize = 64 * 1024;

/// States the record's sum and its place, before anything is said of
/// conformity: of a record that cannot be trusted, nothing is.
pub(super) fn attach(certificate: &mut Certificate, record: &Record, standing: Option<Standing>) {
    // Who looks at the chain verifies the signature.
    let is_verified = standing.is_some_and(|standing| standing != Standing::Broken);
    let standing = standing.unwrap_or(match record.head.id {
        1 => Standing::First,
        _ => Standing::NotAtHand,
    });
    let before = Value::Text(record.head.id.saturating_sub(1).to_string());
    let said = Value::Phrase(
        format!("record_chain.{}", code(&standing)),
        vec![before.clone()],
    );
    let sum = Value::Text(hexadecimal(&digest(record)));
    let calibration = certificate
        .sections
        .iter_mut()
        .find(|section| section.key == "calibration");
    if let Some(section) = calibration {
        let at = |entry: &Entry| entry.key == "record";
        let at = section.entries.iter().position(at).map_or(0, |at| at + 1);
        let entry = |key, value| Entry {
            key,
            clause: "",
            value: Some(value),
        };
        let known = record.provenance != Provenance::UNKNOWN;
        let settings = known.then(|| Value::Text(hexadecimal(&record.provenance.sha256)));
        let settings = settings.map(|sum| entry("settings_sha256", sum));
        let known = record.image != ImageOrigin::UNKNOWN;
        let image = known.then(|| Value::Text(hexadecimal(&record.image.sha256)));
        let image = image.map(|sum| entry("image_sha256", sum));
        let key = record.signed_by.filter(|_| is_verified);
        let key = key.map(|key| entry("signed_by", Value::Text(hexadecimal(&key))));
        let entries = [entry("sha256", sum), entry("chain", said)];
        let entries = entries.into_iter().chain(key).chain(settings).chain(image);
        section.entries.splice(at..at, entries);
    }
    certificate.record_chain = Some(standing);
    if standing == Standing::Broken {
        let remark = Remark {
            severity: Severity::Error,
            key: "chain_broken",
            values: vec![Value::Text(record.head.id.to_string()), before],
        };
        certificate.remarks.insert(0, remark);
        certificate.decision = None;
        certificate
            .sections
            .retain(|section| section.key != "decision");
        for point in &mut certificate.points {
            if let Ok(values) = &mut point.outcome {
                values.assessment = None;
            }
        }
    }
}

/// Sum of the bytes the record was read from; of one made here, of those it would be written as.
pub fn digest(record: &Record) -> Sha256Sum {
    record.sha256.unwrap_or_else(|| {
        let mut buffer = vec![0; LONGEST];
        let length = record::encode(record, &mut buffer).unwrap_or(0);
        record::digest(&buffer[..length])
    })
}

/// In groups of eight digits: lines may break between them.
fn hexadecimal(sum: &Sha256Sum) -> String {
    let groups: Vec<String> = sum.chunks(4).map(hex::encode).collect();
    groups.join(" ")
}
