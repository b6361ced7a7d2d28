//! Particulars and judgement of a certificate: the files of the laboratory and the job,
//! completed by what the logbook knows of the sensor. Every verb and the page ask here.

use crate::{Error, Result};
use calib_certificate::{
    Around, Certificate, ConformityStatement, Known, Language, Particulars, SensorKind,
};
use calib_logbook::Logbook;
use calib_protocol::record::{Record, RecordHead, RunLabels};
use calib_record::hash_chain::{Evidence, Standing};
use calib_record::signature::signer;
use std::path::PathBuf;

/// Statements for the certificate of a run with these labels.
///
/// # Errors
/// [`crate::Error::Files`] when a file states nonsense, or the tolerance needs a nominal
/// sensitivity that nobody stated.
pub fn particulars(
    files: &[PathBuf],
    labels: &RunLabels,
    logbook: Option<&Logbook>,
) -> Result<Particulars> {
    let mut particulars = Particulars::read(files)?;
    let known = match logbook {
        Some(logbook) => logbook.known(&labels.dut_serial, labels.unix_time_s)?,
        None => Known::default(),
    };
    particulars.for_device(&known)?;
    Ok(particulars)
}

/// Has results stated in this unit. That of a sensor whose kind is known is another unit of the same sensitivity.
///
/// # Errors
/// [`crate::Error::Files`] when it is none.
pub fn show_in(particulars: &mut Particulars, unit: Option<SensorKind>) -> Result<()> {
    let Some(unit) = unit else { return Ok(()) };
    let shown = match particulars.item.unit {
        Some(known) => known.shown_in(unit.unit()).map_err(|problem| {
            Error::usage(
                problem,
                "`calib convert` turns one sensitivity into another",
            )
        })?,
        None => unit,
    };
    particulars.item.unit = Some(shown);
    Ok(())
}

/// [`particulars`] for the certificate of a record that was made: where it has no time, what is known of it by the
/// records around it.
///
/// # Errors
/// As there.
pub fn of_record(
    files: &[PathBuf],
    record: &Record,
    logbook: Option<&Logbook>,
) -> Result<Particulars> {
    let head = &record.head;
    let mut particulars = particulars(files, &head.labels, logbook)?;
    if let Some(logbook) = logbook {
        let instrument = &head.instrument_serial;
        let series = logbook.series(instrument, record.signed_by)?.number;
        let (before, behind) = logbook.times_around(instrument, series, head.id)?;
        particulars.around = Around {
            before_unix_time_s: before,
            behind_unix_time_s: behind,
        };
    }
    Ok(particulars)
}

/// Place in the hash chain of the record whose bytes these are, by its neighbours in the logbook.
///
/// # Errors
/// Those of the logbook.
pub fn standing(head: &RecordHead, stored: &[u8], logbook: Option<&Logbook>) -> Result<Standing> {
    let mut evidence = Evidence::of(&head.instrument_serial);
    evidence.bytes(head.id, stored);
    if let Some(logbook) = logbook {
        ask(
            logbook,
            &head.instrument_serial,
            head.id,
            stored,
            &mut evidence,
        )?;
    }
    Ok(evidence.standing(head.id))
}

/// Adds what the logbook knows of an instrument's record: its key, and the records on both sides.
///
/// # Errors
/// Those of the logbook.
pub fn ask(
    logbook: &Logbook,
    instrument: &str,
    id: u32,
    stored: &[u8],
    evidence: &mut Evidence,
) -> Result<()> {
    let series = logbook.series(instrument, signer(stored))?;
    evidence.key(series.key);
    for id in [id.checked_sub(1), id.checked_add(1)].into_iter().flatten() {
        if let Some(bytes) = logbook.numbered(instrument, series.number, id)? {
            evidence.bytes(id, &bytes);
        }
    }
    Ok(())
}

/// Conformity of a record, if a tolerance was stated.
pub fn conformity_statement(
    record: &Record,
    particulars: &Particulars,
) -> Option<ConformityStatement> {
    let language = particulars.language.unwrap_or(Language::En);
    Certificate::from_record(record, particulars).conformity_statement(language)
}
