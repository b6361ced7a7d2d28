//! `calib verify FILE...`: whether a record is as its instrument signed it.

use super::{Context, key::parse};
use calib_host::{Error, Result};
use calib_protocol::record;
use calib_protocol::signature::PublicKey;
use calib_record::signature::{Signed, short, signed};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// `calib verify FILE...`.
#[derive(Debug, Args)]
#[command(after_help = "\
Nothing but the file and the public key is needed: no instrument and no logbook. The key is
what `calib key --json` prints of the instrument; without --key the logbook is asked for it.
Exit code 7 where a record is not proven to be the instrument's: it is not signed, or nobody
here knows its key.

What a signature proves: no byte was altered since the instrument signed. What not: that it
measured well, and that time, operator and sensor are true, which a host stated.
docs/safety.md says more.")]
pub(crate) struct Verify {
    /// Files of downloaded records.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Public key of the instrument: 64 hexadecimal digits, spaces allowed.
    #[arg(long, value_name = "DIGITS", value_parser = parse)]
    key: Option<PublicKey>,
}

/// What is known of a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Proof {
    /// Every byte is as the instrument's key signed it.
    Proven,
    /// Every byte is as some key signed it, which nobody here knows.
    KeyNotKnown,
    /// Every byte is as a key signed it that is not the instrument's.
    OtherKey,
    /// It carries no signature.
    NotSigned,
    /// It carries a signature that does not fit.
    Altered,
}

/// A record and what is known of it.
#[derive(Serialize, JsonSchema)]
pub(super) struct Verified {
    file: PathBuf,
    record_id: u32,
    instrument_serial: String,
    proof: Proof,
    /// Public key it is signed by, in hexadecimal digits.
    signed_by: Option<String>,
}

impl Verify {
    /// Prints what is known of each record.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let files = self.files.iter();
        let verified: Result<Vec<_>> = files.map(|file| self.verify(context, file)).collect();
        let verified = verified?;
        context.print(&verified, || verified.iter().map(Verified::text).collect())?;
        let open = verified.iter().filter(|one| one.proof != Proof::Proven);
        match open.count() {
            0 => Ok(()),
            count => Err(Error::NotPassed(format!(
                "{count} of {} records are not proven to be the instrument's",
                verified.len()
            ))),
        }
    }

    fn verify(&self, context: &Context, file: &Path) -> Result<Verified> {
        let bytes = std::fs::read(file).map_err(|error| Error::file("read", file, error))?;
        let unusable = |error: record::RecordError| {
            let hint = "download it again with `calib download ID`";
            Error::input(file.display().to_string(), error.to_string(), hint)
        };
        let link = record::link(&bytes).map_err(unusable)?;
        let known = match self.key {
            Some(key) => Some(key),
            None => match context.logbook_if_there()? {
                Some(logbook) => logbook.key(&link.instrument_serial)?.map(|key| key.public),
                None => None,
            },
        };
        let signed = signed(&bytes).map_err(unusable)?;
        let proof = match (signed, known) {
            (Signed::No, _) => Proof::NotSigned,
            (Signed::Falsely, _) => Proof::Altered,
            (Signed::By(_), None) => Proof::KeyNotKnown,
            (Signed::By(key), Some(known)) if key == known => Proof::Proven,
            (Signed::By(_), Some(_)) => Proof::OtherKey,
        };
        Ok(Verified {
            file: file.to_owned(),
            record_id: link.id,
            instrument_serial: link.instrument_serial.as_str().to_owned(),
            proof,
            signed_by: match signed {
                Signed::By(key) => Some(calib_output::hex(&key)),
                _ => None,
            },
        })
    }
}

impl Verified {
    fn text(&self) -> String {
        let key = self
            .signed_by
            .as_deref()
            .and_then(|digits| parse(digits).ok());
        let key = key.map(|key| short(&key)).unwrap_or_default();
        let words = match self.proof {
            Proof::Proven => {
                format!("proven: every byte is as the instrument signed it, with its key {key}")
            }
            Proof::KeyNotKnown => format!(
                "signed by the key {key}, which nobody here knows: compare it with the instrument's paper, \
                 then name it with --key"
            ),
            Proof::OtherKey => format!("NOT THE INSTRUMENT'S: signed by another key, {key}"),
            Proof::NotSigned => "not signed: nothing is proven".to_owned(),
            Proof::Altered => "ALTERED: its signature does not fit".to_owned(),
        };
        let Self {
            file,
            record_id,
            instrument_serial,
            ..
        } = self;
        format!(
            "{}: record {record_id} of {instrument_serial}: {words}\n",
            file.display()
        )
    }
}
