//! Facts about a file once it was verified.

use crate::cli::{Context, time};
use calib_logbook::Issued;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// Proof of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(super) enum Proof {
    /// Every byte is as the key of its instrument or laboratory signed it.
    Proven,
    /// Every byte is as some key signed it, which nobody here knows.
    KeyNotKnown,
    /// Every byte is as a key signed it that is not the instrument's.
    OtherKey,
    /// Every byte is as a known key signed it, whose certificate was not in force.
    NotInForce,
    /// It carries no signature.
    NotSigned,
    /// It carries a signature that does not fit.
    Altered,
}

/// Kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(super) enum What {
    /// A record of an instrument.
    Record,
    /// A certificate as PDF.
    Pdf,
    /// A digital calibration certificate.
    Dcc,
}

/// A file and what is known of it.
#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Verified {
    pub(super) file: PathBuf,
    pub(super) kind: What,
    /// Of a record: its number.
    pub(super) record_id: Option<u32>,
    /// Of a record: its instrument.
    pub(super) instrument_serial: Option<String>,
    pub(super) proof: Proof,
    /// Public key it is signed by, in hexadecimal digits; of a certificate the subject of that key's certificate.
    pub(super) signed_by: Option<String>,
    /// SHA-256 of the certificate it is signed with.
    pub(super) signer_certificate_sha256: Option<String>,
    /// When it was signed, as the signer says, s since 1970-01-01 UTC.
    pub(super) signed_unix_time_s: Option<i64>,
    /// The certificate of the logbook that this file is, if there is a logbook and it has one.
    pub(super) issued: Option<Issued>,
    /// The proof in words.
    pub(super) words: String,
}

impl Verified {
    /// Adds what the logbook says of a certificate. That it cannot be read speaks against no file.
    pub(super) fn known_to(mut self, context: &Context, bytes: &[u8]) -> Self {
        let found = context.logbook_if_there();
        let found = found.and_then(|logbook| match logbook {
            Some(logbook) => Ok(Some(logbook.issued_as(bytes)?)),
            None => Ok(None),
        });
        match found {
            Ok(None) => {}
            Ok(Some(None)) => self.words.push_str("; the logbook has no such file"),
            Ok(Some(Some(issued))) => {
                let when = time::date_and_minute(u64::try_from(issued.issued_s).unwrap_or(0));
                let (number, format) = (&issued.certificate, &issued.format);
                let words = format!("; in the logbook as {format} of certificate {number}, {when}");
                self.words.push_str(&words);
                if let Some(by) = &issued.replaced_by {
                    let no_more = format!("REPLACED by certificate No. {by}, not valid any more; ");
                    self.words.insert_str(0, &no_more);
                }
                self.issued = Some(issued);
            }
            Err(error) => context.remark(&format!("the logbook was not asked: {error}")),
        }
        self
    }

    /// Number of the certificate that took the place of this one.
    pub(super) fn replaced_by(&self) -> Option<&str> {
        self.issued.as_ref()?.replaced_by.as_deref()
    }

    pub(super) fn text(&self) -> String {
        format!("{}: {}\n", self.file.display(), self.words)
    }
}
