//! `calib sign FILE...`: the laboratory's signature on certificates.

use super::Context;
use super::laboratory_key::{self, Password};
use calib_certificate::Seal;
use calib_files::file::{self, Existing};
use calib_host::{Error, Result, issuing};
use calib_signing::{Kind, LaboratoryKey};
use clap::Args;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// `calib sign FILE...`.
#[derive(Debug, Args)]
#[command(after_help = "\
FILE.pdf gets a signature of PAdES (level B-B) as FILE.signed.pdf, FILE.dcc.xml an XML signature as
FILE.signed.dcc.xml; FILE itself stays. `calib certificate --sign` does it as the certificate is
made. Where the logbook has FILE as it was issued, the signed file and its signer are entered, and the
journal is signed too. How a laboratory makes its key: docs/certificate.md.")]
pub(crate) struct Sign {
    /// Certificates: PDF or DCC.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The laboratory's key with its certificate: a PKCS#12 file [default: that of `calib config key`].
    #[arg(long, env = "CALIB_LABORATORY_KEY", value_name = "FILE")]
    key: Option<PathBuf>,
    #[command(flatten)]
    password: Password,
}

/// What was written.
#[derive(Serialize, JsonSchema)]
pub(super) struct Signed {
    files: Vec<PathBuf>,
    /// Subject of the certificate it was signed with.
    signed_by: String,
}

impl Sign {
    /// Signs every file, or none when one of them cannot be.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let at = Timestamp::now();
        let key = laboratory_key::required(self.key.as_deref(), context)?;
        let key = Arc::new(self.password.open(&key, at)?);
        let made = self.files.iter().map(|path| Made::of(path, &key, at));
        let made: Vec<_> = made.collect::<Result<_>>()?;
        for file in &made {
            file::write(&file.path, &file.signed, Existing::Keep)?;
        }
        let signed_by = key.certificate().subject();
        enter(context, &made, &Seal { key, at })?;
        let signed = Signed {
            files: made.into_iter().map(|file| file.path).collect(),
            signed_by,
        };
        context.print(&signed, || {
            let line = |file: &PathBuf| format!("{}\n", file.display());
            signed.files.iter().map(line).collect()
        })
    }
}

/// A signed file, and what it was made of.
struct Made {
    path: PathBuf,
    unsigned: Vec<u8>,
    signed: Vec<u8>,
}

impl Made {
    fn of(path: &Path, key: &LaboratoryKey, at: Timestamp) -> Result<Self> {
        let unsigned = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        let refused = |problem: String| {
            let hint = "PDF and DCC as `calib certificate` wrote them can be signed, once";
            Error::input(path.display().to_string(), problem, hint)
        };
        let kind = Kind::of(&unsigned).ok_or_else(|| refused("is neither PDF nor DCC".into()))?;
        let signed = calib_signing::sign(kind, &unsigned, key, at);
        Ok(Self {
            path: beside(path, kind),
            signed: signed.map_err(|problem| refused(problem.to_string()))?,
            unsigned,
        })
    }
}

/// Enters what was signed, where the logbook knows what it was made of; then its journal is signed too.
fn enter(context: &Context, made: &[Made], seal: &Seal) -> Result<()> {
    let Some(logbook) = context.logbook_if_there()? else {
        return Ok(());
    };
    let mut is_any = false;
    for file in made {
        let signed = calib_logbook::Signed {
            content: &file.signed,
            by: seal.key.certificate(),
        };
        let of = logbook.enter_signed(&file.unsigned, &signed, seal.at.as_second())?;
        is_any |= of.is_some();
        if of.is_none() {
            let name = file.path.display();
            context.remark(&format!(
                "{name}: not entered, the logbook issued nothing of this content"
            ));
        }
    }
    let journal = is_any.then(|| issuing::sign_journal(&logbook, Some(seal)));
    if let Some(remark) = journal.transpose()?.and_then(|journal| journal.remark()) {
        context.remark(&remark);
    }
    Ok(())
}

/// `NAME.signed.pdf`, `NAME.signed.dcc.xml`.
fn beside(path: &Path, kind: Kind) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let endings: &[&str] = match kind {
        Kind::Pdf => &[".pdf"],
        Kind::Dcc => &[".dcc.xml", ".xml"],
    };
    let ending = endings.iter().find(|ending| name.ends_with(**ending));
    let ending = ending.copied().unwrap_or_default();
    let stem = name.strip_suffix(ending).unwrap_or(&name);
    path.with_file_name(format!("{stem}.signed{ending}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_signed_file_lies_beside_the_one_without() {
        for (path, kind, expected) in [
            ("a/c.pdf", Kind::Pdf, "a/c.signed.pdf"),
            ("c.dcc.xml", Kind::Dcc, "c.signed.dcc.xml"),
            ("c.xml", Kind::Dcc, "c.signed.xml"),
            ("c", Kind::Pdf, "c.signed"),
        ] {
            assert_eq!(beside(Path::new(path), kind), Path::new(expected));
        }
    }
}
