//! `calib logbook`: what is kept, and whether it is whole.

use super::sensors::cut;
use super::upkeep::{self, Signing};
use crate::cli::text::sensitivity;
use crate::cli::{Context, time};
use calib_files::file;
use calib_host::{Error, Result};
use calib_logbook::{Filter, Instrument, Issued, Kept, Listed, Logbook, Operator};
use calib_metrology::text::Table;
use calib_protocol::record;
use calib_protocol::record::RecordKind;
use calib_record::hash_chain;
use clap::{Args, Subcommand};
use jiff::{civil::Date, tz::TimeZone};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::PathBuf;

/// `calib logbook`.
#[derive(Debug, Args)]
pub(crate) struct LogbookVerb {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Keeps downloaded records.
    Add {
        /// Files of downloaded records.
        #[arg(required = true)]
        files: Vec<PathBuf>,
    },
    /// Lists records, newest first.
    Records {
        /// Only those of this sensor.
        #[arg(long, value_name = "SERIAL")]
        sensor: Option<String>,
        /// Only those measured on this day or later, UTC.
        #[arg(long, value_name = "DAY")]
        from: Option<Date>,
        /// Only those measured before this day, UTC.
        #[arg(long, value_name = "DAY")]
        before: Option<Date>,
    },
    /// Writes a record into a file, as it was downloaded.
    Get {
        /// Number of the record, its instrument's.
        record: u32,
        /// Serial number of the instrument, or how it ends, where several have a record of this number.
        #[arg(long, value_name = "SERIAL")]
        instrument: Option<String>,
        /// Series of its numbers: 0 is the first, 1 since its memory was erased or its board changed, and so on.
        #[arg(long, value_name = "N")]
        series: Option<i64>,
        /// The file [default: such as record-00012.calibrec].
        #[arg(long, short, value_name = "FILE")]
        out: Option<PathBuf>,
    },
    /// Lists certificates in the order they were issued.
    Certificates,
    /// Lists instruments, with the references of their last records.
    Instruments,
    /// Lists the operators named on records.
    Operators,
    /// Checks every sum, number and signature again.
    Check {
        /// Certificate of the laboratory's key, or of the authority that issued it; may be given again, for
        /// those of former keys.
        #[arg(long, value_name = "FILE")]
        certificate: Vec<PathBuf>,
    },
    /// Signs all that was entered until now with the laboratory's key.
    Sign(Signing),
    /// Copies the logbook into a new file.
    Backup {
        /// The file.
        file: PathBuf,
    },
    /// Takes over what another logbook has and this one has not.
    Merge {
        /// The other logbook; it stays as it is.
        file: PathBuf,
    },
}

#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Added {
    file: PathBuf,
    /// Number of the record, its instrument's.
    record_id: u32,
    /// Key of the record in the logbook.
    logbook_record: i64,
    /// False when it was there already.
    new: bool,
}

#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Written {
    file: PathBuf,
}

impl LogbookVerb {
    /// Carries it out.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let logbook = match &self.what {
            What::Add { .. } => context.logbook_to_add_to()?,
            _ => context.logbook()?,
        };
        match self.what {
            What::Add { files } => add(context, logbook, files),
            What::Records {
                sensor,
                from,
                before,
            } => {
                let records = logbook.records(&Filter {
                    sensor,
                    from_s: from.map(midnight_s).transpose()?,
                    before_s: before.map(midnight_s).transpose()?,
                })?;
                context.print(&records, || record_table(&records))
            }
            What::Get {
                record,
                instrument,
                series,
                out,
            } => {
                let bytes = logbook.record_of(record, instrument.as_deref(), series)?;
                let usual = || hash_chain::file_name(record);
                let written = Written {
                    file: out.unwrap_or_else(usual),
                };
                file::create(&written.file, &bytes)?;
                context.print(&written, || written.file.display().to_string())
            }
            What::Certificates => {
                let issued = logbook.certificates()?;
                context.print(&issued, || certificate_table(&issued))
            }
            What::Instruments => {
                let instruments = logbook.instruments()?;
                context.print(&instruments, || instrument_table(&instruments))
            }
            What::Operators => {
                let operators = logbook.operators()?;
                context.print(&operators, || operator_table(&operators))
            }
            What::Check { certificate } => upkeep::check(context, &logbook, &certificate),
            What::Sign(signing) => signing.run(context, &logbook),
            What::Backup { file } => upkeep::backup(context, &logbook, &file),
            What::Merge { file } => upkeep::merge(context, logbook, &file),
        }
    }
}

fn midnight_s(day: Date) -> Result<i64> {
    let midnight = day
        .to_zoned(TimeZone::UTC)
        .map_err(|error| Error::usage(format!("{day}: {error}"), "a day looks like 2026-11-20"))?;
    Ok(midnight.timestamp().as_second())
}

fn add(context: &Context, mut logbook: Logbook, files: Vec<PathBuf>) -> Result<()> {
    let mut added = Vec::new();
    for path in files {
        let bytes = std::fs::read(&path).map_err(|error| Error::file("read", &path, error))?;
        let kept = logbook.keep(&bytes).map_err(|error| error.of_file(&path))?;
        let (logbook_record, new) = match kept {
            Kept::Added(id) => (id, true),
            Kept::Known(id) => (id, false),
        };
        let link = record::hash_link(&bytes).map_err(|error| {
            Error::input(
                path.display().to_string(),
                error.to_string(),
                "download it again",
            )
        })?;
        added.push(Added {
            file: path,
            record_id: link.id,
            logbook_record,
            new,
        });
    }
    context.print(&added, || {
        let line = |added: &Added| {
            let known = if added.new { "" } else { ", was there already" };
            format!(
                "{}: record {}{known}\n",
                added.file.display(),
                added.record_id
            )
        };
        added.iter().map(line).collect()
    })
}

fn when(unix_time_s: i64) -> String {
    time::date_and_minute(u64::try_from(unix_time_s).unwrap_or(0))
}

fn record_table(records: &[Listed]) -> String {
    let mut table = Table::new(&[
        "record",
        "measured",
        "sensor",
        "valid",
        "f/Hz",
        "S",
        "",
        "U*/%",
        // Several instruments have records of one number.
        if several(records) { "instrument" } else { "" },
    ]);
    let number = |value: Option<f64>, factor: f64, decimals: usize| {
        value.map_or(String::new(), |v| format!("{:.decimals$}", factor * v))
    };
    for record in records {
        table.row([
            record.number.to_string(),
            when(record.unix_time_s.unwrap_or(0)),
            match record.kind {
                RecordKind::Calibration => cut(&record.sensor_serial, 16),
                RecordKind::ReferenceChange => "(settings)".to_owned(),
            },
            match record.kind {
                RecordKind::Calibration => valid_of(record),
                RecordKind::ReferenceChange => String::new(),
            },
            record
                .reference_frequency_hz
                .map_or(String::new(), |hz| hz.to_string()),
            record.sensitivity.map_or(String::new(), sensitivity),
            record.sensitivity.map_or("", |_| record.unit).to_owned(),
            number(record.expanded_uncertainty_rel, 100.0, 2),
            match several(records) {
                true => cut_front(&record.instrument, 8),
                false => String::new(),
            },
        ]);
    }
    format!(
        "{table}* of the instrument, without temperature and mount; a certificate states another\n"
    )
}

/// Valid points, of how many.
fn valid_of(record: &Listed) -> String {
    let valid = record.points.saturating_sub(record.refused);
    format!("{valid}/{}", record.points)
}

/// Whether the records are of more than one instrument.
fn several(records: &[Listed]) -> bool {
    let first = records.first().map(|record| &record.instrument);
    records
        .iter()
        .any(|record| Some(&record.instrument) != first)
}

/// The last letters of a serial number, by which an instrument is named.
fn cut_front(serial: &str, letters: usize) -> String {
    let count = serial.chars().count();
    serial.chars().skip(count.saturating_sub(letters)).collect()
}

fn certificate_table(issued: &[Issued]) -> String {
    let mut table = Table::new(&[
        "no.",
        "issued",
        "certificate",
        "form",
        "SHA-256",
        "signed by",
    ]);
    for certificate in issued {
        table.row([
            certificate.number.to_string(),
            when(certificate.issued_s),
            cut(&certificate.certificate, 34),
            certificate.format.clone(),
            certificate.sha256.chars().take(12).collect(),
            certificate
                .signed
                .last()
                .map_or(String::new(), |file| cut(&file.signed_by, 32)),
        ]);
    }
    let mut text = table.to_string();
    for old in issued {
        let line = replaced(old).unwrap_or_default();
        if !text.contains(&line) {
            text.push_str(&line);
        }
    }
    text
}

/// That a certificate is no longer valid.
fn replaced(old: &Issued) -> Option<String> {
    let (by, why) = (old.replaced_by.as_ref()?, old.replaced_because.as_ref()?);
    Some(format!("{} was replaced by {by}: {why}\n", old.certificate))
}

fn instrument_table(instruments: &[Instrument]) -> String {
    let mut table = Table::new(&["instrument", "reference", "certificate", "due"]);
    for instrument in instruments {
        table.row([
            cut(&instrument.serial, 24),
            cut(&instrument.reference_serial, 16),
            cut(&instrument.reference_certificate, 20),
            instrument.due_day.clone().unwrap_or_default(),
        ]);
    }
    table.to_string()
}

fn operator_table(operators: &[Operator]) -> String {
    let mut table = Table::new(&["operator", "first", "last"]);
    for operator in operators {
        table.row([
            cut(&operator.name, 40),
            when(operator.first_s),
            when(operator.last_s),
        ]);
    }
    table.to_string()
}
