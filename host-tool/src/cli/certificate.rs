//! `calib certificate RECORD`: the certificate of a downloaded or stored record.

use super::laboratory_key::{self, Password};
use super::source::{self, Found, Whose};
use super::substitute::Known;
use super::{Context, time};
use calib_certificate::decision::Stated;
use calib_certificate::{
    self as certificate, ConformityStatement, Existing, Format, Language, Mark, Options, Prepared,
    Seal, Standard,
};
use calib_host::amendment::Amended;
use calib_host::issuing::{self, Entries};
use calib_host::{Error, Result, assurance, judged, self_check, terminal};
use calib_logbook::Logbook;
use calib_protocol::record::Record;
use calib_record::hash_chain::Standing;
use clap::Args;
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// `calib certificate RECORD`.
#[derive(Debug, Args)]
pub(crate) struct CertificateVerb {
    /// File of a downloaded record, or the running number of one that is still
    /// in the calibrator (it is downloaded first).
    #[arg(required_unless_present_any = ["write_template", "sensor", "amend"])]
    record: Option<PathBuf>,
    #[command(flatten)]
    whose: Whose,
    /// The latest record of this sensor in the logbook, instead of RECORD.
    #[arg(long, value_name = "SERIAL", conflicts_with = "record")]
    sensor: Option<String>,
    /// Number of an issued certificate that the new one replaces. It is made of the same records, under a number
    /// of its own, such as 17-A1 for 17.
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "reason",
        conflicts_with = "sensor"
    )]
    amend: Option<String>,
    /// Mistake on the old certificate; the new one prints it.
    #[arg(long, value_name = "TEXT", requires = "amend")]
    reason: Option<String>,
    /// Customer, in place of the one in the files of particulars.
    #[arg(long, value_name = "NAME")]
    customer: Option<String>,
    /// Directory for the files.
    #[arg(long, short, default_value = ".", value_name = "DIR")]
    out: PathBuf,
    /// Formats, separated by commas: pdf, dcc, html, csv, json, uff [default: all but
    /// uff; a DCC only where the country of the laboratory is stated].
    #[arg(long, value_delimiter = ',', value_name = "FORMAT")]
    format: Vec<Format>,
    /// Language: en or de; else that of the particulars, else English.
    #[arg(long, short, value_name = "LANGUAGE")]
    language: Option<Language>,
    /// TOML file with customer, conditions ...; may be given again: later files
    /// win. The laboratory's file comes first.
    #[arg(long, short, value_name = "FILE")]
    particulars: Vec<PathBuf>,
    #[command(flatten)]
    laboratory: Laboratory,
    /// The record from before an adjustment, a file or its number; RECORD is then from after it.
    #[arg(long, value_name = "RECORD")]
    as_found: Option<PathBuf>,
    /// Records that measured again what had no result in RECORD (`calib run --retry`), files or numbers, separated by
    /// commas. With --sensor those of the last day are found.
    #[arg(
        long,
        value_name = "RECORD",
        value_delimiter = ',',
        conflicts_with = "remounted"
    )]
    retried: Vec<PathBuf>,
    /// Records of the same device taken off and mounted again (`calib run --remount`): files or numbers, separated
    /// by commas. The certificate states means, with the scatter between mountings in the budget.
    #[arg(
        long,
        value_name = "RECORD",
        value_delimiter = ',',
        conflicts_with = "as_found"
    )]
    remounted: Vec<PathBuf>,
    /// The record of the standard that was measured in the channel of the device (`calib run --substitute`), a file or
    /// its number: the certificate states the result by substitution.
    #[arg(long, value_name = "RECORD", conflicts_with_all = ["as_found", "remounted"])]
    substituted: Option<PathBuf>,
    /// Table of that standard's certificate (CSV: frequency_hz, sensitivity_mv, expanded_uncertainty_percent); else what
    /// the logbook knows of the check standard.
    #[arg(long, value_name = "FILE")]
    standard: Option<PathBuf>,
    /// Refuses a certificate that is not complete, instead of marking it DRAFT.
    #[arg(long)]
    strict: bool,
    /// Signs PDF and DCC, and the logbook's journal, with the laboratory's key, a PKCS#12 file [default: that
    /// of `calib config key`].
    #[arg(long, env = "CALIB_LABORATORY_KEY", value_name = "FILE")]
    sign: Option<PathBuf>,
    #[command(flatten)]
    password: Password,
    /// Writes the built-in page as certificate.typ into a directory, to begin your
    /// own; writes no certificate.
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with_all = ["record", "sensor", "format", "language", "particulars", "as_found"]
    )]
    write_template: Option<PathBuf>,
}

/// Formats written unless stated otherwise.
const USUAL: [Format; 5] = [
    Format::Pdf,
    Format::Dcc,
    Format::Html,
    Format::Csv,
    Format::Json,
];

#[derive(Serialize, JsonSchema)]
pub(super) struct Written {
    files: Vec<PathBuf>,
}

impl CertificateVerb {
    /// Writes the files; none appears when one of them cannot be written. With a
    /// logbook they are entered there first, and none is written if another
    /// one of that number was issued.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        if let Some(folder) = &self.write_template {
            return template(context, folder);
        }
        let mut logbook = context.logbook_if_there()?;
        let amended = self.amended(logbook.as_ref())?;
        let (found, retried) = self.found(context, logbook.as_ref(), amended.as_ref())?;
        let record = found.calibration()?;
        let mut options = Options {
            record_chain: Some(found.standing),
            failed_checks: assurance::failed_checks(logbook.as_ref(), record)?,
            remounted: self.read(context, &self.remounted)?,
            retried,
            standard: self.standard(context)?,
            seal: self.seal(context)?,
            ..self.options(context, record, logbook.as_ref())?
        };
        issuing::has_come(&options.particulars, jiff::Timestamp::now())?;
        let check = self_check::of_certificate(logbook.as_ref(), record)?;
        options.particulars.reference_check = check;
        if let (Some(amended), Some(logbook)) = (&amended, &logbook) {
            amended.state(&mut options.particulars);
            amended.join(&mut options, logbook)?;
        }
        self.know_standard(context, options.standard.as_mut())?;
        let entries = Entries::of(record, &options);
        let formats = match self.format.is_empty() {
            true => certificate::possible(record, &USUAL, &options.particulars),
            false => self.format,
        };
        let mut prepared = certificate::prepare(record, &formats, &options)?;
        if self.strict {
            complete(&prepared)?;
        }
        let seal = options.seal.as_ref();
        let files = prepared.paths(&self.out);
        issuing::resume(&mut prepared, &files, seal, logbook.as_ref())?;
        let key = seal.map(|seal| &*seal.key);
        if let Some(logbook) = &logbook {
            for issue in entries.issues(&prepared, &files, key) {
                logbook.may_issue(&issue)?;
            }
        }
        // What was issued is never overwritten.
        let staged = prepared.stage(&self.out, Existing::Keep)?;
        if let Some(logbook) = &mut logbook {
            let now = i64::try_from(time::unix_time_s()).unwrap_or(0);
            let now = seal.map_or(now, |seal| seal.at.as_second());
            logbook.issue(&entries.issues(&prepared, &files, key), now)?;
        }
        // Nothing is there that the logbook does not know, whenever this program ends.
        staged.name_all()?;
        let journal = logbook.as_ref();
        let journal = journal.map(|logbook| issuing::sign_journal(logbook, seal));
        let journal = journal.transpose()?.and_then(|journal| journal.remark());
        if found.standing == Standing::Broken {
            context.remark("the chain of records is broken: the certificate says so in red");
        }
        if let Some(lack) = &prepared.lack {
            context.remark(lack);
        }
        for (_, said) in &prepared.marks {
            context.remark(said);
        }
        if let Some(conformity) = &prepared.conformity_statement {
            context.remark(&terminal::conformity_statement(conformity));
        }
        if let Some(journal) = journal {
            context.remark(&journal);
        }
        print(context, files)?;
        passed(prepared.conformity_statement.as_ref())
    }

    /// Certificate to be replaced.
    fn amended(&self, logbook: Option<&Logbook>) -> Result<Option<Amended>> {
        let (Some(number), Some(reason)) = (&self.amend, &self.reason) else {
            return Ok(None);
        };
        let none = || {
            let hint = "name the one it was issued from with --logbook or CALIB_LOGBOOK";
            Error::input(format!("certificate {number}"), "there is no logbook", hint)
        };
        Amended::find(logbook.ok_or_else(none)?, number, reason).map(Some)
    }

    /// The record, by whatever names it, and those that complete it.
    fn found(
        &self,
        context: &Context,
        logbook: Option<&Logbook>,
        amended: Option<&Amended>,
    ) -> Result<(Found, Vec<Record>)> {
        let named = self.read(context, &self.retried)?;
        let found = match (&self.sensor, &self.record, logbook.zip(amended)) {
            (Some(serial), _, _) => {
                let (found, retried) = source::latest(context, serial)?;
                let retried = if named.is_empty() { retried } else { named };
                if !retried.is_empty() {
                    context.remark(&completed(found.calibration()?, &retried));
                }
                return Ok((found, retried));
            }
            // What is stated of its neighbours is what the logbook has, or nothing is issued.
            (None, Some(name), _) => {
                source::find_beside(context, logbook, &self.whose, name, &self.out)?
            }
            (None, None, Some((logbook, amended))) => {
                source::of_logbook(logbook, &amended.record(logbook)?)?
            }
            // The command line asks for one of them.
            (None, None, None) => source::find(context, Path::new(""), &self.out)?,
        };
        Ok((found, named))
    }

    /// The record of the standard, if one is named.
    fn standard(&self, context: &Context) -> Result<Option<Standard>> {
        let record = self.read(context, self.substituted.as_slice())?.pop();
        Ok(record.map(|record| Standard {
            record,
            certified: Vec::new(),
        }))
    }

    /// Takes over the statements of the standard's certificate.
    fn know_standard(&self, context: &Context, standard: Option<&mut Standard>) -> Result<()> {
        match (standard, &self.standard) {
            (Some(standard), table) => {
                let serial = standard.record.head.labels.dut_serial.trim();
                standard.certified = Known::find(context, serial, table.as_deref())?.certified;
                Ok(())
            }
            (None, Some(_)) => Err(Error::usage(
                "--standard is the table of a standard, and none was measured",
                "name the record of the standard with --substituted",
            )),
            (None, None) => Ok(()),
        }
    }

    fn seal(&self, context: &Context) -> Result<Option<Seal>> {
        let Some(path) = laboratory_key::file(self.sign.as_deref(), context) else {
            return Ok(None);
        };
        let at = Timestamp::now();
        let key = Arc::new(self.password.open(&path, at)?);
        Ok(Some(Seal { key, at }))
    }

    fn read(&self, context: &Context, names: &[PathBuf]) -> Result<Vec<Record>> {
        let read = |name: &PathBuf| {
            let found = source::find_of(context, &self.whose, name, &self.out)?;
            found.calibration().cloned()
        };
        names.iter().map(read).collect()
    }

    fn options(
        &self,
        context: &Context,
        record: &Record,
        logbook: Option<&Logbook>,
    ) -> Result<Options> {
        let files = self.laboratory.before(&self.particulars);
        let mut particulars = judged::of_record(&files, record, logbook)?;
        let stated = self.language.or(particulars.language);
        particulars.language = stated.or(context.defaults.language);
        if let Some(customer) = &self.customer {
            particulars.customer.name = Some(customer.clone());
        }
        Ok(Options {
            particulars,
            existing: Existing::Keep,
            as_found: self.read(context, self.as_found.as_slice())?.pop(),
            ..Options::default()
        })
    }
}

/// Which records a certificate is made of.
fn completed(record: &Record, retried: &[Record]) -> String {
    let ids: Vec<String> = retried.iter().map(|r| r.head.id.to_string()).collect();
    format!(
        "record {}, completed by what record {} measured again",
        record.head.id,
        ids.join(", ")
    )
}

fn print(context: &Context, files: Vec<PathBuf>) -> Result<()> {
    let written = Written { files };
    context.print(&written, || {
        let line = |file: &PathBuf| format!("{}\n", file.display());
        written.files.iter().map(line).collect()
    })
}

fn template(context: &Context, folder: &Path) -> Result<()> {
    let files = certificate::write_template(folder)?;
    context.remark("name it as `template` under [layout] in the file of the laboratory");
    print(context, files)
}

/// An error when something is missing that a certificate cannot be without.
fn complete(prepared: &Prepared) -> Result<()> {
    let draft = prepared.marks.iter().find(|(mark, _)| *mark == Mark::Draft);
    draft.map_or(Ok(()), |(_, said)| {
        let place = format!("certificate {}", prepared.number);
        let hint = "state it in the file of the laboratory, or in one given with --particulars";
        Err(Error::input(place, said.as_str(), hint))
    })
}

/// The file of the laboratory, for every verb that states or judges.
#[derive(Clone, Debug, Args)]
pub(super) struct Laboratory {
    /// TOML file of the laboratory: its name, its decision rule [default:
    /// calib/laboratory.toml in the user's configuration directory, if there].
    #[arg(long, env = "CALIB_LABORATORY", value_name = "FILE")]
    laboratory: Option<PathBuf>,
}

impl Laboratory {
    /// The file of the laboratory, and those that win over it.
    pub(super) fn before(&self, job: &[PathBuf]) -> Vec<PathBuf> {
        let laboratory = laboratory_file(self.laboratory.clone());
        laboratory.into_iter().chain(job.iter().cloned()).collect()
    }
}

/// The file of the laboratory: the one named, else that of the user if there is one.
pub(super) fn laboratory_file(named: Option<PathBuf>) -> Option<PathBuf> {
    let own = || dirs::config_dir().map(|folder| folder.join("calib/laboratory.toml"));
    named.or_else(|| own().filter(|path| path.exists()))
}

/// An error unless a conformity that was asked for is a pass.
pub(super) fn passed(conformity: Option<&ConformityStatement>) -> Result<()> {
    let other = conformity.filter(|conformity| conformity.conformity != Stated::Pass);
    Error::not_passed(
        other.map(|conformity| format!("{}: {}", conformity.title, conformity.because)),
    )
}
