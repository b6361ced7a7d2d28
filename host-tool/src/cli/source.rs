//! A record as named on the command line: a file, or one in the calibrator.

use super::Context;
use calib_certificate::{complete, completes};
use calib_files::file::Existing;
use calib_host::{Error, Result, judged};
use calib_link::{Client, session};
use calib_logbook::{Filter, Logbook};
use calib_protocol::change::{self, ReferenceChange};
use calib_protocol::record::{self, Record, RecordError, RecordKind};
use calib_record::hash_chain::{Evidence, Standing};
use clap::Args;
use std::path::Path;

/// Whose record of the logbook a number is, where several are of it.
#[derive(Clone, Debug, Default, Args)]
pub(super) struct Whose {
    /// RECORD is the number of a record in the logbook, of the instrument whose serial number ends so.
    #[arg(long, value_name = "SERIAL")]
    instrument: Option<String>,
    /// RECORD is the number of a record in the logbook, of this series of its instrument's numbers: 0 is the first, 1 since
    /// its memory was erased or its board changed, and so on.
    #[arg(long, value_name = "N")]
    series: Option<i64>,
}

impl Whose {
    fn is_stated(&self) -> bool {
        self.instrument.is_some() || self.series.is_some()
    }

    /// The record of this number in the logbook.
    fn find(&self, logbook: Option<&Logbook>, path: &Path) -> Result<Found> {
        let wrong = |problem: &str, hint: &str| {
            Error::usage(format!("record {}: {problem}", path.display()), hint)
        };
        let number = path.to_str().and_then(|name| name.parse().ok());
        let Some(number) = number.filter(|_| !path.exists()) else {
            let hint = "leave out --instrument and --series, which say whose record of the logbook a number is";
            return Err(wrong("is a file", hint));
        };
        let Some(logbook) = logbook else {
            return Err(wrong(
                "there is no logbook",
                "name one with --logbook or CALIB_LOGBOOK",
            ));
        };
        let kept = logbook.record_of(number, self.instrument.as_deref(), self.series)?;
        of_logbook(logbook, &kept)
    }
}

/// A record that was found.
pub(super) struct Found {
    /// Content.
    pub(super) content: Content,
    /// Its place in the hash chain, by what is at hand.
    pub(super) standing: Standing,
}

/// Content of a record, by its kind.
pub(super) enum Content {
    /// A run that was measured.
    Calibration(Box<Record>),
    /// Other settings.
    ReferenceChange(Box<ReferenceChange>),
}

impl Found {
    /// The record of a calibration: what a certificate can be made of.
    pub(super) fn calibration(&self) -> Result<&Record> {
        match &self.content {
            Content::Calibration(record) => Ok(record),
            Content::ReferenceChange(change) => Err(Error::input(
                format!("record {}", change.head.id),
                "logs a change of settings and is no calibration",
                "`calib show` shows it; `calib records` lists the calibrations",
            )),
        }
    }
}

/// [`find_beside`] the user's logbook: a record can be looked at though that cannot be read.
pub(super) fn find(context: &Context, path: &Path, out: &Path) -> Result<Found> {
    find_of(context, &Whose::default(), path, out)
}

/// [`find`] where it is said whose record it is.
pub(super) fn find_of(context: &Context, whose: &Whose, path: &Path, out: &Path) -> Result<Found> {
    let logbook = context.logbook_if_there().ok().flatten();
    find_beside(context, logbook.as_ref(), whose, path, out)
}

/// The record of this file or, when its name is a number and no file, the one of
/// this number in the calibrator, which is downloaded into `out` first. Without a calibrator it is that of the logbook, and
/// where it is said whose it is.
pub(super) fn find_beside(
    context: &Context,
    logbook: Option<&Logbook>,
    whose: &Whose,
    path: &Path,
    out: &Path,
) -> Result<Found> {
    if whose.is_stated() {
        return whose.find(logbook, path);
    }
    match path.to_str().map(str::parse) {
        Some(Ok(id)) if !path.exists() => {
            let mut client = match connected(context) {
                Ok(client) => client,
                Err(error) => return without_calibrator(context, logbook, id, error),
            };
            let fetched = session::fetch(&mut client, id, out, Existing::Keep, |_| ())?;
            let fetched = [fetched];
            let evidence = session::evidence(&mut client, &fetched, out)?;
            let [fetched] = fetched;
            Ok(Found {
                content: content(&fetched.path, &fetched.bytes)?,
                standing: evidence.standing(id),
            })
        }
        _ => from_file(path, logbook),
    }
}

fn connected(context: &Context) -> Result<Client> {
    let mut client = context.connect()?;
    client.info()?;
    Ok(client)
}

/// The record of the logbook, if it has one of this number; else why there is no calibrator to be asked.
fn without_calibrator(
    context: &Context,
    logbook: Option<&Logbook>,
    id: u32,
    error: Error,
) -> Result<Found> {
    let Some(logbook) = logbook else {
        return Err(error);
    };
    let kept = match logbook.records(&Filter::default())? {
        all if all.iter().all(|record| record.number != id) => return Err(error),
        _ => logbook.record_of(id, None, None)?,
    };
    context.remark(&format!("record {id} of the logbook: {error}"));
    of_logbook(logbook, &kept)
}

/// The latest calibration of this sensor in the logbook, and the records that measured again what had no result in
/// it, oldest first.
pub(super) fn latest(context: &Context, serial: &str) -> Result<(Found, Vec<Record>)> {
    let none = || {
        Error::input(
            format!("sensor {serial}"),
            "has no record in the logbook",
            "`calib logbook records` lists what is there; a downloaded file can be named instead",
        )
    };
    let logbook = context.logbook_if_there()?.ok_or_else(none)?;
    let of_sensor = Filter {
        sensor: Some(serial.to_owned()),
        ..Filter::default()
    };
    let mut found = None;
    for listed in logbook.records(&of_sensor)?.into_iter().take(MOST_RETRIES) {
        let earlier = of_logbook(&logbook, &logbook.record(listed.id)?)?;
        found = Some(match found.take() {
            None => (earlier, Vec::new()),
            Some((later, retried)) => join(earlier, later, retried)?,
        });
    }
    let (found, retried) = found.ok_or_else(none)?;
    Ok((found, retried))
}

/// Records of a sensor that are looked at for the one that the latest completes.
const MOST_RETRIES: usize = 10;

/// The earlier record and those that complete it, if the later is one of them.
fn join(earlier: Found, later: Found, retried: Vec<Record>) -> Result<(Found, Vec<Record>)> {
    let (first, next) = (earlier.calibration()?, later.calibration()?);
    if !completes(first, next) {
        return Ok((later, retried));
    }
    let mut all = vec![next.clone()];
    all.extend(retried);
    // One in which everything was refused again adds nothing.
    all.retain(|record| complete(first, std::slice::from_ref(record)).is_ok());
    Ok((earlier, all))
}

/// A record of the logbook, with those beside it there.
pub(super) fn of_logbook(logbook: &Logbook, bytes: &[u8]) -> Result<Found> {
    let content = content(Path::new("record of the logbook"), bytes)?;
    let head = match &content {
        Content::Calibration(record) => &record.head,
        Content::ReferenceChange(change) => &change.head,
    };
    Ok(Found {
        standing: judged::standing(head, bytes, Some(logbook))?,
        content,
    })
}

/// A downloaded record, with what lies beside it, and what the logbook knows of it.
fn from_file(path: &Path, logbook: Option<&Logbook>) -> Result<Found> {
    let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    let content = content(path, &bytes)?;
    let link = record::hash_link(&bytes).map_err(|error| unusable(path, error))?;
    let mut evidence = Evidence::of(&link.instrument_serial);
    evidence.bytes(link.id, &bytes);
    evidence.neighbours(link.id, path.parent().unwrap_or(Path::new("")));
    if let Some(logbook) = logbook {
        judged::ask(
            logbook,
            &link.instrument_serial,
            link.id,
            &bytes,
            &mut evidence,
        )?;
    }
    Ok(Found {
        content,
        standing: evidence.standing(link.id),
    })
}

fn content(path: &Path, bytes: &[u8]) -> Result<Content> {
    let found = RecordKind::ReferenceChange;
    match record::decode(bytes) {
        Ok(record) => Ok(Content::Calibration(Box::new(record))),
        Err(RecordError::Kind { found: kind }) if kind == found => {
            let change = change::decode(bytes).map_err(|error| unusable(path, error))?;
            Ok(Content::ReferenceChange(Box::new(change)))
        }
        Err(error) => Err(unusable(path, error)),
    }
}

fn unusable(path: &Path, error: RecordError) -> Error {
    let hint = match error {
        _ if error.is_of_newer_release() => {
            "install a newer calib: this one is older than the record"
        }
        RecordError::Kind { .. } => "`calib show` shows it",
        _ => "download it again with `calib download ID`",
    };
    Error::input(path.display().to_string(), error.to_string(), hint)
}
