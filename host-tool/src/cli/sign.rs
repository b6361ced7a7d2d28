//! `calib sign FILE...`: the laboratory's signature on certificates.

use super::Context;
use super::laboratory_key::Password;
use calib_files::file::{self, Existing};
use calib_host::{Error, Result};
use calib_signing::{Kind, LaboratoryKey};
use clap::Args;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// `calib sign FILE...`.
#[derive(Debug, Args)]
#[command(after_help = "\
FILE.pdf gets a signature of PAdES (level B-B) as FILE.signed.pdf, FILE.dcc.xml an XML signature as
FILE.signed.dcc.xml; FILE itself stays. `calib certificate --sign` does it as the certificate is
made. How a laboratory makes its key: docs/certificate.md.")]
pub(crate) struct Sign {
    /// Certificates: PDF or DCC.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The laboratory's key with its certificate: a PKCS#12 file.
    #[arg(long, env = "CALIB_LABORATORY_KEY", value_name = "FILE")]
    key: PathBuf,
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
        let now = Timestamp::now();
        let key = self.password.open(&self.key, now)?;
        let made = self.files.iter().map(|path| signed(path, &key, now));
        let made: Vec<_> = made.collect::<Result<_>>()?;
        for (path, content) in &made {
            file::write(path, content, Existing::Keep)?;
        }
        let signed = Signed {
            files: made.into_iter().map(|(path, _)| path).collect(),
            signed_by: key.certificate().subject(),
        };
        context.print(&signed, || {
            let line = |file: &PathBuf| format!("{}\n", file.display());
            signed.files.iter().map(line).collect()
        })
    }
}

/// Where the signed file will be, and its content.
fn signed(path: &Path, key: &LaboratoryKey, now: Timestamp) -> Result<(PathBuf, Vec<u8>)> {
    let content = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    let refused = |problem: String| {
        let hint = "PDF and DCC as `calib certificate` wrote them can be signed, once";
        Error::input(path.display().to_string(), problem, hint)
    };
    let kind = Kind::of(&content).ok_or_else(|| refused("is neither PDF nor DCC".into()))?;
    let signed = calib_signing::sign(kind, &content, key, now);
    let signed = signed.map_err(|problem| refused(problem.to_string()))?;
    Ok((beside(path, kind), signed))
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
