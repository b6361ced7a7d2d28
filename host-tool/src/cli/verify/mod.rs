//! `calib verify FILE...`: what the signature of a record or a certificate proves.

mod document;
mod record;
mod verified;

use super::{Context, key};
use calib_host::{Error, Result};
use calib_protocol::signature::PublicKey;
use calib_signing::{Certificate, Kind};
use clap::Args;
use std::path::{Path, PathBuf};
use verified::Proof;
pub(super) use verified::Verified;

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
