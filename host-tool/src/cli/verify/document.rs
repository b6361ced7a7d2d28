//! A certificate, PDF or DCC, by the certificate of its laboratory's key.

use super::verified::{Proof, Verified, What};
use calib_signing::{Certificate, Kind, Signature};
use jiff::Timestamp;
use std::path::Path;

/// Proof of a certificate.
pub(super) fn verify(file: &Path, kind: Kind, bytes: &[u8], known: &[Certificate]) -> Verified {
    let now = Timestamp::now();
    let (proof, signature, words) = match calib_signing::verify(kind, bytes) {
        Ok(signature) => {
            let proof = proof(&signature, known, now);
            let words = words(&signature, proof);
            (proof, Some(signature), words)
        }
        Err(_) if !kind.is_signed(bytes) => {
            let words = "not signed: nothing is proven".to_owned();
            (Proof::NotSigned, None, words)
        }
        Err(problem) => (Proof::Altered, None, format!("NOT PROVEN: {problem}")),
    };
    let signer = signature.as_ref().map(|signature| &signature.by);
    Verified {
        file: file.to_owned(),
        kind: match kind {
            Kind::Pdf => What::Pdf,
            Kind::Dcc => What::Dcc,
        },
        record_id: None,
        instrument_serial: None,
        proof,
        signed_by: signer.map(Certificate::subject),
        signer_certificate_sha256: signer.map(|by| hex::encode(by.fingerprint())),
        signed_unix_time_s: signature.and_then(|one| one.at).map(Timestamp::as_second),
        issued: None,
        words,
    }
}

fn proof(signature: &Signature, known: &[Certificate], now: Timestamp) -> Proof {
    match (signature.is_of(known, now), signature.is_in_force(now)) {
        (false, _) => Proof::KeyNotKnown,
        (true, false) => Proof::NotInForce,
        (true, true) => Proof::Proven,
    }
}

fn words(signature: &Signature, proof: Proof) -> String {
    let by = signature.by.subject();
    let issuer = match signature.by.issuer() {
        issuer if issuer == by => "itself".to_owned(),
        issuer => issuer,
    };
    let (from, to) = signature.by.period();
    let when = match signature.at {
        Some(at) => format!("says {at}"),
        None => "the file does not say when".to_owned(),
    };
    match proof {
        Proof::Proven => format!(
            "proven: every byte is as \"{by}\" signed it ({when}); certificate issued by {issuer}, in force \
             {from} to {to}. Not proven: that it was measured well, and the time of signing"
        ),
        Proof::NotInForce => format!(
            "signed by \"{by}\" ({when}), whose certificate was in force {from} to {to} only: ask the laboratory"
        ),
        _ => {
            let sum = hex::encode(signature.by.fingerprint());
            format!(
                "signed by \"{by}\" ({when}), issued by {issuer}, which nobody here knows: compare the SHA-256 of \
                 its certificate, {sum}, with what the laboratory tells, then name that with --certificate"
            )
        }
    }
}
