//! A record, by the key of its instrument.

use super::verified::{Proof, Verified, What};
use crate::cli::Context;
use calib_host::{Error, Result};
use calib_protocol::record;
use calib_protocol::signature::PublicKey;
use calib_record::signature::{Signed, short, signed};
use std::path::Path;

/// Proof of a record.
pub(super) fn verify(
    context: &Context,
    file: &Path,
    bytes: &[u8],
    key: Option<PublicKey>,
) -> Result<Verified> {
    let unusable = |error: record::RecordError| {
        let hint = "download it again with `calib download ID`";
        Error::input(file.display().to_string(), error.to_string(), hint)
    };
    let link = record::hash_link(bytes).map_err(unusable)?;
    let serial = link.instrument_serial.as_str();
    let signed = signed(bytes).map_err(unusable)?;
    let by = match signed {
        Signed::By(key) => Some(key),
        _ => None,
    };
    let keys = match (key, context.logbook_if_there()) {
        (Some(_), _) => Vec::new(),
        (None, logbook) => match logbook? {
            Some(logbook) => logbook.keys(serial)?,
            None => Vec::new(),
        },
    };
    // Where it is signed by none of them, the last is the one it should be.
    let own = keys.iter().position(|had| Some(had.key.public) == by);
    let of_logbook = own
        .or(keys.len().checked_sub(1))
        .map(|at| keys[at].key.public);
    let proof = proof(signed, key.or(of_logbook));
    let mut words = words(proof, by.map(|key| short(&key)).unwrap_or_default());
    if let Some(later) = own.and_then(|own| keys.get(own + 1)) {
        words += &format!("; it has another key since: {}", later.reason);
    }
    Ok(Verified {
        file: file.to_owned(),
        kind: What::Record,
        record_id: Some(link.id),
        instrument_serial: Some(serial.to_owned()),
        proof,
        signed_by: by.map(hex::encode),
        signer_certificate_sha256: None,
        signed_unix_time_s: None,
        issued: None,
        words: format!("record {} of {serial}: {words}", link.id),
    })
}

fn proof(signed: Signed, known: Option<PublicKey>) -> Proof {
    match (signed, known) {
        (Signed::No, _) => Proof::NotSigned,
        (Signed::Falsely, _) => Proof::Altered,
        (Signed::By(_), None) => Proof::KeyNotKnown,
        (Signed::By(key), Some(known)) if key == known => Proof::Proven,
        (Signed::By(_), Some(_)) => Proof::OtherKey,
    }
}

fn words(proof: Proof, key: String) -> String {
    match proof {
        Proof::Proven => {
            format!("proven: every byte is as the instrument signed it, with its key {key}")
        }
        Proof::KeyNotKnown => format!(
            "signed by the key {key}, which nobody here knows: compare it with the instrument's paper, \
             then name it with --key"
        ),
        Proof::OtherKey => format!("NOT THE INSTRUMENT'S: signed by another key, {key}"),
        Proof::NotSigned => "not signed: nothing is proven".to_owned(),
        // A key without certificate is in force for ever.
        Proof::Altered | Proof::NotInForce => "ALTERED: its signature does not fit".to_owned(),
    }
}
