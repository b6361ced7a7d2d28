//! Certificates of records, as answers. One that `issues` is signed where there is a key, and entered in the
//! logbook; one that is looked at is not.

use super::options::Options as House;
use super::view::Shared;
use crate::amendment::Amended;
use crate::issuing::{self, Entries, Journal};
use crate::{Error, Result, assurance, judged, self_check};
use axum::http::header;
use axum::response::{IntoResponse, Response};
use calib_certificate::{
    self as certificate, Adjustment, Certificate, Format, Language, Options, Particulars, Seal,
    Standard,
};
use calib_logbook::Logbook;
use calib_protocol::record::{self, Record, RecordError};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A certificate is a page of its own with script and style inside, and talks to
/// nobody: not to the instrument, whatever a sensor is called.
const ALONE: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; \
                     img-src data:; sandbox allow-scripts allow-modals; frame-ancestors 'none'";

/// Statements of the page on a certificate, beside the laboratory's files and before them; empty is not stated.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Stated {
    /// Language of the page; that of a certificate where the laboratory's files state none.
    pub language: Option<Language>,
    /// For whom.
    customer: String,
    /// Ambient air temperature, degrees Celsius.
    ambient_temperature_c: Option<f64>,
    /// Relative humidity, %.
    humidity_percent: Option<f64>,
    /// Whether the object was adjusted.
    adjustment: Option<Adjustment>,
    /// Record of the logbook from before the adjustment.
    as_found: Option<i64>,
    /// Record of the logbook of the check standard that was measured in the channel of the device.
    substituted: Option<i64>,
    /// Day of issue, as 2026-11-22.
    issued: String,
    /// Who authorises it.
    approved_by: String,
    /// Number of the issued certificate that this one takes the place of.
    replaces: String,
    /// Mistake on that one.
    reason: String,
}

impl Stated {
    fn complete(&self, particulars: &mut Particulars) -> Result<()> {
        let (conditions, calibration) = (&mut particulars.conditions, &mut particulars.calibration);
        let ambient = self.ambient_temperature_c;
        conditions.ambient_temperature_c = ambient.or(conditions.ambient_temperature_c);
        let humidity = self.humidity_percent;
        conditions.humidity_percent = humidity.or(conditions.humidity_percent);
        calibration.adjustment = self.adjustment.or(calibration.adjustment);
        particulars.language = particulars.language.or(self.language);
        if !self.customer.is_empty() {
            particulars.customer.name = Some(self.customer.clone());
        }
        if !self.issued.is_empty() {
            let day = self.issued.parse().map_err(|error: jiff::Error| {
                Error::usage(format!("issued: {error}"), "a day is 2026-11-22")
            })?;
            particulars.calibration.issued = Some(day);
        }
        if !self.approved_by.is_empty() {
            particulars.calibration.approved_by = Some(self.approved_by.clone());
        }
        Ok(particulars.plausible("the page")?)
    }

    /// The record from before the adjustment.
    fn found(&self, logbook: Option<&Logbook>) -> Result<Option<Record>> {
        let pair = self.as_found.zip(logbook);
        pair.map(|(id, logbook)| read(&logbook.record(id)?))
            .transpose()
    }

    /// The standard by which the result is stated, with what its certificate says.
    fn standard(&self, logbook: Option<&Logbook>) -> Result<Option<Standard>> {
        let Some((id, logbook)) = self.substituted.zip(logbook) else {
            return Ok(None);
        };
        let record = read(&logbook.record(id)?)?;
        standard(record, logbook).map(Some)
    }
}

fn standard(record: Record, logbook: &Logbook) -> Result<Standard> {
    let serial = record.head.labels.dut_serial.trim();
    let certified = assurance::certified(Some(logbook), serial)?;
    Ok(Standard { record, certified })
}

/// The certificate that is asked for.
pub(super) struct Wanted {
    /// Name of its format.
    pub format: String,
    /// Statements of the page on it.
    pub stated: Stated,
    /// Whether it is given out, so that the logbook says so from then on; else it is looked at.
    pub issues: bool,
}

impl Wanted {
    /// Whether the logbook says so of what is given: what is looked at is a page.
    pub(super) fn may_be_given(&self) -> bool {
        self.issues || self.format == "html"
    }
}

/// Stored forms of a record, and of those that measured again what had no result in it.
pub(super) type Stored<'a> = (&'a [u8], &'a [Vec<u8>]);

/// The certificate of a record's stored form.
///
/// # Errors
/// [`Error::Usage`] for a format or a day there is not, [`Error::Input`] when the record is
/// damaged, the laboratory states nonsense, its key is out of date, or another content was issued under
/// this number.
pub(super) fn certificate(
    stored: Stored<'_>,
    wanted: &Wanted,
    house: &House,
    shared: &Shared,
) -> Result<Response> {
    let logbook = Logbook::open_if_there(&house.logbook)?;
    made(stored, wanted, (house, shared), logbook, None)
}

/// A certificate in place of the one that is stated, from its records.
///
/// # Errors
/// As [`certificate`], and [`Error::Input`] when that one was never issued or was replaced already.
pub(super) fn amended(wanted: &Wanted, house: &House, shared: &Shared) -> Result<Response> {
    let logbook = Logbook::open_existing(&house.logbook)?;
    let Stated {
        replaces, reason, ..
    } = &wanted.stated;
    let amended = Amended::find(&logbook, replaces, reason)?;
    let stored = amended.record(&logbook)?;
    made(
        (&stored, &[]),
        wanted,
        (house, shared),
        Some(logbook),
        Some(&amended),
    )
}

fn made(
    (stored, retried): Stored<'_>,
    wanted: &Wanted,
    (house, shared): (&House, &Shared),
    mut logbook: Option<Logbook>,
    amended: Option<&Amended>,
) -> Result<Response> {
    let unknown = |problem: String| Error::usage(problem, "");
    let format: Format = wanted.format.parse().map_err(unknown)?;
    let record = read(stored)?;
    let kept = logbook.as_ref();
    let mut particulars = judged::of_record(&house.particulars, &record, kept)?;
    wanted.stated.complete(&mut particulars)?;
    issuing::has_come(&particulars, jiff::Timestamp::now())?;
    particulars.reference_check = self_check::of_certificate(kept, &record)?;
    let mut options = Options {
        particulars,
        record_chain: Some(judged::standing(&record.head, stored, kept)?),
        failed_checks: assurance::failed_checks(kept, &record)?,
        as_found: wanted.stated.found(kept)?,
        standard: wanted.stated.standard(kept)?,
        retried: all(retried)?,
        seal: seal(house, wanted.issues)?,
        ..Options::default()
    };
    if let (Some(amended), Some(logbook)) = (amended, kept) {
        amended.state(&mut options.particulars);
        amended.join(&mut options, logbook)?;
        if let Some(joined) = options.standard.take() {
            options.standard = Some(standard(joined.record, logbook)?);
        }
    }
    let mut prepared = certificate::prepare(&record, &[format], &options)?;
    if let Some(logbook) = &mut logbook
        && wanted.issues
    {
        let paths = prepared.paths(Path::new(""));
        let (entries, seal) = (Entries::of(&record, &options), options.seal.as_ref());
        issuing::resume(&mut prepared, &paths, seal, Some(logbook))?;
        let now = seal.map_or_else(jiff::Timestamp::now, |seal| seal.at);
        let issues = entries.issues(&prepared, &paths, seal.map(|seal| &*seal.key));
        logbook.issue(&issues, now.as_second())?;
        tell(&issuing::sign_journal(logbook, seal)?, shared);
    }
    let Some(file) = prepared.files.pop() else {
        return Err(Error::input("certificate", "is empty", "report this"));
    };
    Ok(answer(file))
}

/// Seal of a certificate that is given out, if any.
fn seal(house: &House, issues: bool) -> Result<Option<Seal>> {
    let Some(key) = house.key.as_ref().filter(|_| issues) else {
        return Ok(None);
    };
    let at = jiff::Timestamp::now();
    match key.certificate().is_in_force(at) {
        true => Ok(Some(Seal {
            key: Arc::clone(key),
            at,
        })),
        // It was in force when the server began.
        false => Err(Error::input(
            "key of the laboratory",
            "its certificate is out of date",
            "renew it, and start `calib serve --sign` with the new one",
        )),
    }
}

/// A record's results with the conformity of its sensor, as the certificate states them.
///
/// # Errors
/// [`Error::Input`] when the record is damaged, or the laboratory states nonsense.
pub(super) fn judged(
    (stored, retried): (&Vec<u8>, &[Vec<u8>]),
    stated: &Stated,
    particulars: &[PathBuf],
    logbook: &Path,
) -> Result<certificate::Document> {
    let record = certificate::complete(&read(stored)?, &all(retried)?)?;
    let logbook = Logbook::open_if_there(logbook)?;
    let mut particulars = judged::of_record(particulars, &record, logbook.as_ref())?;
    stated.complete(&mut particulars)?;
    // What the page shows is in its language, whatever that of the laboratory's certificates is.
    let language = stated.language.or(particulars.language).unwrap_or_default();
    let certificate = match stated.standard(logbook.as_ref())? {
        Some(standard) => Certificate::by_substitution(&record, &standard, &particulars)?,
        None => Certificate::from_record(&record, &particulars),
    };
    Ok(certificate::Document::new(&certificate, language))
}

fn all(stored: &[Vec<u8>]) -> Result<Vec<Record>> {
    stored.iter().map(|stored| read(stored)).collect()
}

fn read(stored: &[u8]) -> Result<Record> {
    let damaged = |error: RecordError| Error::input("record", error.to_string(), "run once more");
    record::decode(stored).map_err(damaged)
}

fn tell(journal: &Journal, shared: &Shared) {
    shared.change(|view| {
        view.unsigned_entries = match journal {
            Journal::Signed => Some(0),
            Journal::Waits(count) => Some(*count),
            Journal::Refused(_) => view.unsigned_entries,
        };
        if let Journal::Refused(_) = journal {
            view.trouble = journal.remark();
        }
    });
}

/// A page that stands alone and talks to nobody.
pub(super) fn alone(page: String) -> Response {
    let headers = [
        (header::CONTENT_TYPE, "text/html; charset=utf-8"),
        (header::CONTENT_SECURITY_POLICY, ALONE),
    ];
    (headers, page).into_response()
}

fn answer(file: certificate::File) -> Response {
    let (kind, shown) = match file.format {
        Format::Html => ("text/html; charset=utf-8", "inline"),
        Format::Pdf => ("application/pdf", "inline"),
        Format::Dcc => ("application/xml", "attachment"),
        Format::Json => ("application/json", "attachment"),
        Format::Csv => ("text/csv; charset=utf-8", "attachment"),
        _ => ("application/octet-stream", "attachment"),
    };
    let headers = [
        (header::CONTENT_TYPE, kind.to_owned()),
        (
            header::CONTENT_DISPOSITION,
            format!("{shown}; filename=\"{}\"", file.name),
        ),
        (header::CONTENT_SECURITY_POLICY, ALONE.to_owned()),
    ];
    (headers, file.content).into_response()
}
