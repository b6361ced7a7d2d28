//! Certificates: from a decoded record to files people and machines read.
//!
//! | file | idea |
//! |---|---|
//! | `from_record` | the one place that computes: record to [`Certificate`] |
//! | `sections` | statements, each with the clause that asks for it |
//! | [`particulars`] | what a TOML file states and no record knows |
//! | `adjustment` | what was found before an adjustment, beside what was left |
//! | `around` | the date of a run whose time nobody told |
//! | `marks` | DRAFT, SIMULATED |
//! | `refused` | what no certificate may say |
//! | `assurance` | check standards that speak against it |
//! | `budget` | the budgets of the points, recomputed and compared |
//! | `retried` | what had no result, measured again |
//! | `mountings` | several mountings of one device as one result |
//! | `substitution` | a standard and then the device in one channel |
//! | `deviation` | uncertainty of the deviation from the reference point |
//! | `change` | uncertainty of the change since another calibration |
//! | `temperature` | what the temperature told adds to row 11 |
//! | `harmonics` | what one channel bends and the other does not |
//! | `resonance` | the mounted resonance a sweep shows, and what its shift adds to row 8 |
//! | `standing` | the record's sum and its place in the chain |
//! | `conformity_statement` | conformity of the whole object in words, for every output |
//! | `conformity` | judgement of the results by a decision rule |
//! | `rounding` | two digits of U, the value to the same digit |
//! | `kind` | accelerometers, velocity and displacement transducers, charge, current: quantity and unit |
//! | `present` | [`Certificate`] to strings in a language |
//! | `seal` | PDF and DCC signed with the laboratory's key |
//! | `square` | number, sum and where to verify, for a telephone |
//! | `plot`, `band` | frequency response and tolerance as SVG |
//! | `csv`, `json`, `html`, `pdf`, `dcc`, `uff` | one format each |
//! | [`decision`] | tolerances, decision rules and their risks |

#![forbid(unsafe_code)]

mod adjustment;
mod around;
mod assurance;
mod band;
mod budget;
mod change;
mod conformity;
mod conformity_statement;
mod csv;
mod dcc;
pub mod decision;
mod deviation;
mod from_record;
mod harmonics;
mod html;
mod interval;
mod json;
mod kind;
mod linearity;
mod marks;
pub mod model;
mod mountings;
pub mod particulars;
mod pdf;
mod plot;
mod polarity;
mod present;
#[cfg(test)]
pub(crate) mod python;
mod refused;
mod resonance;
mod retried;
pub mod rounding;
mod seal;
mod search;
mod sections;
mod square;
mod standing;
mod stored;
mod substitution;
mod temperature;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_dcc;
#[cfg(test)]
mod tests_kind;
#[cfg(test)]
mod tests_lone;
#[cfg(test)]
mod tests_marks;
#[cfg(test)]
mod tests_pdf;
#[cfg(test)]
mod tests_standing;
#[cfg(test)]
mod tests_statements;
#[cfg(test)]
mod tests_uff;
#[cfg(test)]
mod tests_uncertainty;
mod uff;
mod words;

pub use around::minute;
pub use assurance::{CheckProblem, FailedCheck};
pub use calib_files::file::Existing;
pub use change::{
    certified_uncertainty_rel, expanded_uncertainty_of_change_rel, with_certified_uncertainty,
};
pub use conformity_statement::ConformityStatement;
pub use html::page;
pub use json::{Document, said_of_closing};
pub use kind::{OfSensor, Output, SensitivityUnit, SensorKind, Specified};
pub use marks::Mark;
pub use model::{Certificate, MountedResonance};
pub use mountings::{MountingScatter, scatter as mounting_scatter};
pub use particulars::{
    Adjustment, Amendment, Around, IntervalRule, Known, Particulars, ReferenceCheck,
};
pub use polarity::Polarity;
pub use present::Presented;
pub use retried::{complete, completes, without_result};
pub use seal::Seal;
pub use standing::digest;
pub use stored::day;
pub use substitution::{Standard, StandardPoint, Substituted, substitute};
pub use temperature::instrument_covers;
pub use words::{Language, REASONS};

use calib_files::Result;
use calib_files::set::{self, Staged};
use calib_protocol::record::Record;
use calib_record::hash_chain::Standing;
use calib_signing::Kind;
use seal::Sealed;
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
    /// Digital calibration certificate 3.3.0, XML.
    Dcc,
    /// PDF/A-3b with the digital calibration certificate inside.
    Pdf,
    /// Universal file, dataset 58.
    Uff,
}

impl Format {
    /// Every format there is, in the order they are written.
    pub const ALL: [Self; 6] = [
        Self::Csv,
        Self::Json,
        Self::Html,
        Self::Dcc,
        Self::Pdf,
        Self::Uff,
    ];

    /// Extension of the file.
    fn extension(self) -> &'static str {
        match self {
            Self::Dcc => "dcc.xml",
            other => other.name(),
        }
    }

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Html => "html",
            Self::Dcc => "dcc",
            Self::Pdf => "pdf",
            Self::Uff => "uff",
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
    /// Statements beside the record; their language is the certificate's.
    pub particulars: Particulars,
    /// Treatment of files of the same name with other content.
    pub existing: Existing,
    /// Record from before an adjustment, when `record` is from after it.
    pub as_found: Option<Record>,
    /// Knowledge of the record's place in the chain; by default nothing but
    /// what its number says.
    pub record_chain: Option<Standing>,
    /// Records of the same device mounted again, beside `record`.
    pub remounted: Vec<Record>,
    /// Records that measured again what had no result in `record`.
    pub retried: Vec<Record>,
    /// Standard that was measured in the channel of the device: the result is by substitution.
    pub standard: Option<Standard>,
    /// Check standards that speak against it: without an override in writing it is refused.
    pub failed_checks: Vec<FailedCheck>,
    /// Seal with which PDF and DCC are signed.
    pub seal: Option<Seal>,
}

/// Writes the certificate of `record` in `formats` into `out_dir`.
///
/// Files are named after the certificate number. Either all of them appear,
/// complete, or none does. Returns their paths in the order of `formats`.
///
/// # Errors
/// Those of [`prepare`] and [`Prepared::write`].
pub fn write_with(
    record: &Record,
    formats: &[Format],
    out_dir: &Path,
    options: &Options,
) -> Result<Vec<PathBuf>> {
    prepare(record, formats, options)?.write(out_dir, options.existing)
}

/// The files of a certificate before they are written.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Number of the certificate.
    pub number: String,
    /// Its files, in the order of the formats asked for.
    pub files: Vec<File>,
    /// Why the printed one has no DCC inside, and the way out.
    pub lack: Option<String>,
    /// Conformity of the object in words, if a tolerance was stated.
    pub conformity_statement: Option<ConformityStatement>,
    /// The marks it carries, each with its reason.
    pub marks: Vec<(Mark, String)>,
}

/// A file of a certificate.
#[derive(Clone, Debug)]
pub struct File {
    /// Its form.
    pub format: Format,
    /// Its name, made of the number of the certificate.
    pub name: String,
    /// Its content.
    pub content: Vec<u8>,
    /// The content without any signature, where it has one: it stays the same however often it is signed.
    pub unsigned: Option<Vec<u8>>,
    /// Content its signature covers, where it has one.
    page: Option<Vec<u8>>,
}

impl File {
    /// The file as it is when this signs it; one without a signature stays as it is. The same key and time make the
    /// same bytes.
    ///
    /// # Errors
    /// As [`prepare`].
    pub fn sealed(&self, seal: &Seal) -> Result<Vec<u8>> {
        match (&self.page, self.format) {
            (Some(page), Format::Pdf) => seal::signed(Kind::Pdf, page, seal),
            (Some(page), _) => seal::signed(Kind::Dcc, page, seal),
            (None, _) => Ok(self.content.clone()),
        }
    }
}

/// Makes the files of a certificate in memory.
///
/// # Errors
/// [`calib_files::Error::Input`] when something stated makes no sense, the reference was
/// overdue or a check standard failed without an override, or a template does not render, [`calib_files::Error::File`] when a template cannot be read.
pub fn prepare(record: &Record, formats: &[Format], options: &Options) -> Result<Prepared> {
    let record = &retried::complete(record, &options.retried)?;
    let mut certificate = certificate_of(record, options)?;
    retried::state(&mut certificate, &options.retried);
    refused::check(&certificate, record)?;
    assurance::attach(&mut certificate, &options.failed_checks)?;
    if let Some(found) = &options.as_found {
        adjustment::attach(&mut certificate, record, found)?;
    }
    standing::attach(&mut certificate, record, options.record_chain);
    let language = options.particulars.language.unwrap_or_default();
    let dcc = seal::dcc(&certificate, language, options.seal.as_ref())?;
    let file = |format: &Format| {
        let sealed = match (format, &dcc) {
            (Format::Dcc, Some(dcc)) => dcc.clone(),
            (Format::Pdf, dcc) => {
                let presented = Presented::new(&certificate, language);
                let page = |dcc: Option<&[u8]>| pdf::render(&certificate, &presented, dcc);
                seal::pdf(dcc.as_ref(), options.seal.as_ref(), page)?
            }
            (format, _) => Sealed::plain(render(&certificate, *format, language)?),
        };
        Ok(File {
            format: *format,
            name: file_name(&certificate, *format),
            content: sealed.content,
            unsigned: sealed.unsigned,
            page: sealed.page,
        })
    };
    let files: Result<Vec<File>> = formats.iter().map(file).collect();
    let lack = formats.contains(&Format::Pdf).then(|| lack(&certificate));
    Ok(Prepared {
        files: files?,
        lack: lack.flatten(),
        conformity_statement: certificate.conformity_statement(language),
        marks: certificate
            .marks()
            .into_iter()
            .zip(certificate.marks_in_words(language))
            .map(|(mark, (title, reason))| (mark, format!("{title}: {reason}")))
            .collect(),
        number: certificate.number,
    })
}

fn certificate_of(record: &Record, options: &Options) -> Result<Certificate> {
    let particulars = &options.particulars;
    let Some(standard) = &options.standard else {
        return Certificate::from_records(record, &options.remounted, particulars);
    };
    let certificate = Certificate::by_substitution(record, standard, particulars)?;
    refused::overdue_standard(&certificate, standard)?;
    Ok(certificate)
}

/// Why there can be no DCC, and the way out.
fn lack(certificate: &Certificate) -> Option<String> {
    let error = dcc::needs(certificate).err()?;
    let hint = error.hint().unwrap_or_default();
    Some(format!("no DCC: {error}; {hint}"))
}

/// The formats among these that a certificate of this record can have: all of
/// them, or all but the DCC when what it cannot be without is not stated.
pub fn possible(record: &Record, formats: &[Format], particulars: &Particulars) -> Vec<Format> {
    let certificate = Certificate::from_record(record, particulars);
    let complete = dcc::needs(&certificate).is_ok();
    let can_be = |format: &Format| complete || *format != Format::Dcc;
    formats.iter().copied().filter(can_be).collect()
}

impl Particulars {
    /// Reads TOML files; what a later one states wins.
    ///
    /// # Errors
    /// [`calib_files::Error::File`] when one cannot be read, [`calib_files::Error::Input`]
    /// with file and line when it is not TOML or states something unknown.
    pub fn read(paths: &[PathBuf]) -> Result<Self> {
        let columns: Vec<_> = present::columns().map(|column| column.name).collect();
        Self::read_knowing(paths, &columns)
    }
}

/// Items ISO 16063-21 asks for that neither record nor laboratory states:
/// item and clause, in English.
pub fn missing(
    record: &Record,
    particulars: &Particulars,
) -> impl Iterator<Item = (String, String)> + use<> {
    let sections = Certificate::from_record(record, particulars).sections;
    sections.into_iter().flat_map(|section| {
        let entries = section.entries.into_iter();
        let asked = entries.filter(|entry| entry.clause.contains("16063-21"));
        asked
            .filter(|entry| entry.value.is_none())
            .map(move |entry| {
                let key = format!("{}.{}", section.key, entry.key);
                (Language::En.word(&key).to_owned(), entry.clause.to_owned())
            })
    })
}

/// Writes the built-in page as `certificate.typ` into `folder`, for a laboratory to
/// begin its own with. A file that is there with other content stays.
///
/// # Errors
/// [`calib_files::Error::Input`] when there is another one, [`calib_files::Error::File`] when the
/// directory cannot be written.
pub fn write_template(folder: &Path) -> Result<Vec<PathBuf>> {
    let file = ("certificate.typ".to_owned(), pdf::TEMPLATE.into());
    set::write_all(folder, &[file], Existing::Keep)
}

impl Prepared {
    /// Where the files will be.
    pub fn paths(&self, out_dir: &Path) -> Vec<PathBuf> {
        let path = |file: &File| out_dir.join(&file.name);
        self.files.iter().map(path).collect()
    }

    /// Writes the files: all of them appear, complete, or none does.
    ///
    /// # Errors
    /// [`calib_files::Error::Input`] when another certificate has this name and is to be
    /// kept, [`calib_files::Error::File`] when the directory cannot be written.
    pub fn write(&self, out_dir: &Path, existing: Existing) -> Result<Vec<PathBuf>> {
        self.stage(out_dir, existing)?.name_all()
    }

    /// Writes the files, whole, and gives them no names yet.
    ///
    /// # Errors
    /// As [`Self::write`].
    pub fn stage(&self, out_dir: &Path, existing: Existing) -> Result<Staged> {
        let mut staged = Staged::new(existing);
        for (file, path) in self.files.iter().zip(self.paths(out_dir)) {
            staged.add(path, &file.content)?;
        }
        Ok(staged)
    }
}

/// One format of a certificate, as bytes.
///
/// # Errors
/// [`calib_files::Error::Input`] when a template does not render.
pub fn render(certificate: &Certificate, format: Format, language: Language) -> Result<Vec<u8>> {
    match format {
        Format::Csv => csv::render(certificate, language),
        Format::Json => json::render(certificate, language),
        Format::Html => html::render(&Presented::new(certificate, language)),
        Format::Dcc => dcc::render(certificate, language),
        Format::Pdf => pdf::render(
            certificate,
            &Presented::new(certificate, language),
            // Without date or country there is no DCC; the certificate says what is missing.
            dcc::render(certificate, language).ok().as_deref(),
        ),
        Format::Uff => Ok(uff::render(certificate)),
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
    format!("certificate-{stem}.{}", format.extension())
}
