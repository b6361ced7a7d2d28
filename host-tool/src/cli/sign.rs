//! `calib sign FILE...`: the laboratory's signature on certificates.

use super::Context;
use super::laboratory_key::{self, Password};
use calib_certificate::Seal;
use calib_files::file::Existing;
use calib_files::set::Staged;
use calib_host::{Error, Result, issuing};
use calib_logbook::Logbook;
use calib_signing::Kind;
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
journal is signed too. docs/certificate.md says how a laboratory makes its key.")]
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

/// Files that were written.
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
        let logbook = context.logbook_if_there()?;
        let signed_by = key.certificate().subject();
        let seal = Seal { key, at };
        let made = self.files.iter();
        let made = made.map(|path| Made::of(path, &seal, logbook.as_ref()));
        let made: Vec<_> = made.collect::<Result<_>>()?;
        let mut staged = Staged::new(Existing::Keep);
        for file in &made {
            staged.add(file.path.clone(), &file.signed)?;
        }
        let is_any = match &logbook {
            Some(logbook) => enter(context, logbook, &made, &seal)?,
            None => false,
        };
        // Nothing is there that the logbook does not know, whenever this program ends.
        staged.name_all()?;
        if let Some(logbook) = logbook.filter(|_| is_any)
            && let Some(remark) = issuing::sign_journal(&logbook, Some(&seal))?.remark()
        {
            context.remark(&remark);
        }
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
    fn of(path: &Path, seal: &Seal, logbook: Option<&Logbook>) -> Result<Self> {
        let unsigned = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        let refused = |problem: String| {
            let hint = "PDF and DCC as `calib certificate` wrote them can be signed, once";
            Error::input(path.display().to_string(), problem, hint)
        };
        let kind = Kind::of(&unsigned).ok_or_else(|| refused("is neither PDF nor DCC".into()))?;
        let sign = |at| {
            let signed = calib_signing::sign(kind, &unsigned, &seal.key, at);
            signed.map_err(|problem| refused(problem.to_string()))
        };
        let issued = logbook.map(|logbook| logbook.issued_as(&unsigned));
        let entered = issued.transpose()?.flatten();
        let entered = entered.map(|issued| issued.signed).unwrap_or_default();
        let path = beside(path, kind);
        let before = issuing::as_before(&entered, &path, &seal.key, sign)?;
        let signed = before.map_or_else(|| sign(seal.at), Ok)?;
        Ok(Self {
            path,
            unsigned,
            signed,
        })
    }
}

/// Enters what was signed, where the logbook knows what it was made of; whether any of it.
fn enter(context: &Context, logbook: &Logbook, made: &[Made], seal: &Seal) -> Result<bool> {
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
    Ok(is_any)
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
