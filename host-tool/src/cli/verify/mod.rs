//! `calib verify FILE...`: what the signature of a record or a certificate proves.

mod document;
mod record;

use super::{Context, key, time};
use calib_host::{Error, Result};
use calib_logbook::Issued;
use calib_protocol::signature::PublicKey;
use calib_signing::{Certificate, Kind};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// `calib verify FILE...`.
#[derive(Debug, Args)]
#[command(after_help = "\
The file and a public key are enough: no instrument and no logbook is needed. Where there is a
logbook, calib also says whether it knows a certificate as issued, signed or not. For a record the
key is that of its instrument, which `calib key --json` prints; without --key the logbook gives
it. For a certificate, PDF or DCC, it is the certificate of the laboratory's key, or that of the
authority that issued it.
Exit code 7 where a file is not proven to be theirs: it is not signed, was altered, or nobody
here knows its key.

A signature proves that no byte was altered since the owner of the key signed. It does not prove
that it was measured well; that time, operator and sensor are true, which a host stated; or when
it was signed, which the signer stated. docs/safety.md says more.")]
pub(crate) struct Verify {
    /// Downloaded records, certificates as PDF or DCC.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Public key of the instrument: 64 hexadecimal digits, spaces allowed.
    #[arg(long, value_name = "DIGITS", value_parser = key::parse)]
    key: Option<PublicKey>,
    /// Certificate of the laboratory, or of the authority that issued it, PEM or DER; may be given again.
    #[arg(long, value_name = "FILE")]
    certificate: Vec<PathBuf>,
}

/// Proof of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Proof {
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
enum What {
    /// A record of an instrument.
    Record,
    /// A certificate as PDF.
    Pdf,
    /// A digital calibration certificate.
    Dcc,
}

/// A file and what is known of it.
#[derive(Serialize, JsonSchema)]
pub(super) struct Verified {
    file: PathBuf,
    kind: What,
    /// Of a record: its number.
    record_id: Option<u32>,
    /// Of a record: its instrument.
    instrument_serial: Option<String>,
    proof: Proof,
    /// Public key it is signed by, in hexadecimal digits; of a certificate the subject of that key's certificate.
    signed_by: Option<String>,
    /// SHA-256 of the certificate it is signed with.
    signer_certificate_sha256: Option<String>,
    /// When it was signed, as the signer says, s since 1970-01-01 UTC.
    signed_unix_time_s: Option<i64>,
    /// The certificate of the logbook that this file is, if there is a logbook and it has one.
    issued: Option<Issued>,
    /// The proof in words.
    words: String,
}

impl Verify {
    /// Prints what is known of each file.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let known: Result<Vec<_>> = self.certificate.iter().map(|p| read(p)).collect();
        let known = known?.concat();
        let files = self.files.iter();
        let verified = files.map(|file| self.verify(context, file, &known));
        let verified: Vec<_> = verified.collect::<Result<_>>()?;
        context.print(&verified, || verified.iter().map(Verified::text).collect())?;
        let open = verified.iter().filter(|one| one.proof != Proof::Proven);
        let replaced = verified.iter().filter(|one| one.replaced_by().is_some());
        match open.count() {
            0 if replaced.clone().count() > 0 => Err(Error::NotPassed(format!(
                "{} of {} certificates were replaced and are no longer valid",
                replaced.count(),
                verified.len()
            ))),
            0 => Ok(()),
            count => Err(Error::NotPassed(format!(
                "{count} of {} files are not proven to be what they say",
                verified.len()
            ))),
        }
    }

    fn verify(&self, context: &Context, file: &Path, known: &[Certificate]) -> Result<Verified> {
        let bytes = std::fs::read(file).map_err(|error| Error::file("read", file, error))?;
        match Kind::of(&bytes) {
            Some(kind) => {
                let verified = document::verify(file, kind, &bytes, known);
                Ok(verified.known_to(context, &bytes))
            }
            None => record::verify(context, file, &bytes, self.key),
        }
    }
}

fn read(path: &Path) -> Result<Vec<Certificate>> {
    Ok(Certificate::read(path)?)
}

impl Verified {
    /// Adds what the logbook says of a certificate. That it cannot be read speaks against no file.
    fn known_to(mut self, context: &Context, bytes: &[u8]) -> Self {
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
    fn replaced_by(&self) -> Option<&str> {
        self.issued.as_ref()?.replaced_by.as_deref()
    }

    fn text(&self) -> String {
        format!("{}: {}\n", self.file.display(), self.words)
    }
}
