//! Certificates: from a decoded record to files people and machines read.
//!
//! | file | idea |
//! |---|---|
//! | `from_record` | the one place that computes: record to [`Certificate`] |
//! | `sections` | statements, each with the clause that asks for it |
//! | [`particulars`] | what a TOML file states and no record knows |
//! | `budget` | the budget at the reference point, recomputed and compared |
//! | `rounding` | two digits of U, the value to the same digit |
//! | `present` | [`Certificate`] to strings in a language |
//! | `plot` | frequency response as SVG |
//! | `csv`, `json`, `html` | one format each |
//! | `output` | files that are never half-written |

mod budget;
mod csv;
mod from_record;
mod html;
mod json;
pub mod model;
mod output;
pub mod particulars;
mod plot;
mod present;
pub mod rounding;
mod sections;
#[cfg(test)]
pub(crate) mod testing;
#[cfg(test)]
mod tests;
mod words;

pub use crate::file::Existing;
pub use json::document;
pub use model::Certificate;
pub use particulars::Particulars;
pub use present::Presented;
pub use words::Language;

use crate::Result;
use calib_protocol::record::Record;
use std::path::{Path, PathBuf};

/// A form of the certificate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Table for spreadsheets.
    Csv,
    /// Every number for programs.
    Json,
    /// Self-contained page for people.
    Html,
}

impl Format {
    /// Every format there is, in the order they are written.
    pub const ALL: [Self; 3] = [Self::Csv, Self::Json, Self::Html];

    /// Name on the command line, and extension of the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Html => "html",
        }
    }
}

impl std::str::FromStr for Format {
    type Err = String;

    fn from_str(name: &str) -> std::result::Result<Self, Self::Err> {
        let known = Self::ALL.map(Self::name).join(", ");
        let format = Self::ALL.into_iter().find(|format| format.name() == name);
        format.ok_or_else(|| format!("no format '{name}'; there are {known}"))
    }
}

/// How a certificate is written.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// What is stated beside the record; its language is the certificate's.
    pub particulars: Particulars,
    /// What happens to files of the same name with other content.
    pub existing: Existing,
}

/// Writes the certificate of `record` in `formats` into `out_dir`, in English;
/// files that are there with other content are kept.
///
/// Files are named after the certificate number. Either all of them appear,
/// complete, or none does. Returns their paths in the order of `formats`.
///
/// # Errors
/// [`crate::Error::Input`] when another certificate has this name,
/// [`crate::Error::File`] when the directory cannot be written.
pub fn write(record: &Record, formats: &[Format], out_dir: &Path) -> Result<Vec<PathBuf>> {
    write_with(record, formats, out_dir, &Options::default())
}

/// As [`write`], with options.
///
/// # Errors
/// As [`write`].
pub fn write_with(
    record: &Record,
    formats: &[Format],
    out_dir: &Path,
    options: &Options,
) -> Result<Vec<PathBuf>> {
    let certificate = Certificate::from_record(record, &options.particulars);
    let language = options.particulars.language.unwrap_or_default();
    let file = |format: &Format| {
        let content = render(&certificate, *format, language)?;
        Ok((file_name(&certificate, *format), content))
    };
    let files: Result<Vec<_>> = formats.iter().map(file).collect();
    output::write_all(out_dir, &files?, options.existing)
}

/// One format of a certificate, as bytes.
///
/// # Errors
/// [`crate::Error::Input`] when a template does not render.
pub fn render(certificate: &Certificate, format: Format, language: Language) -> Result<Vec<u8>> {
    match format {
        Format::Csv => csv::render(certificate, language),
        Format::Json => json::render(certificate, language),
        Format::Html => html::render(&Presented::new(certificate, language)),
    }
}

/// A file name from the number: what a file system may not like becomes `_`.
fn file_name(certificate: &Certificate, format: Format) -> String {
    let safe = |c: char| {
        if c.is_ascii_alphanumeric() || c == '-' {
            c
        } else {
            '_'
        }
    };
    let stem: String = certificate.number.chars().map(safe).collect();
    format!("certificate-{stem}.{}", format.name())
}
