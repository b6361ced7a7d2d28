//! Checks of the reference in the logbook: kept, compared with their baseline, stated on certificates.

use crate::{Error, Result};
use calib_certificate::ReferenceCheck;
use calib_logbook::{Logbook, SelfCheck};
use calib_metrology::control_chart::{Signal, control_chart};
use calib_metrology::reciprocity::{Against, Change, Evaluation, change, from_certificate};
use calib_protocol::record::Record;
use jiff::Timestamp;
use jiff::civil::Date;
use jiff::tz::TimeZone;
use schemars::JsonSchema;
use serde::Serialize;

/// Keeps a check of the reference of the instrument that measured `last`; false where it is there already.
///
/// # Errors
/// Those of the logbook.
pub fn keep(
    logbook: &Logbook,
    last: &Record,
    found: &Evaluation,
    is_baseline: bool,
) -> Result<bool> {
    let evaluation = serde_json::to_string(found).map_err(|error| {
        Error::input("check of the reference", error.to_string(), "report this")
    })?;
    let reference = &last.settings.reference;
    Ok(logbook.keep_self_check(&SelfCheck {
        instrument: last.head.instrument_serial.to_string(),
        reference: reference.serial.to_string(),
        certificate: reference.certificate.to_string(),
        measured_s: measured_s(last),
        is_baseline,
        evaluation,
    })?)
}

/// When a record was measured; now where it does not say.
fn measured_s(record: &Record) -> i64 {
    match i64::try_from(record.head.labels.unix_time_s) {
        Ok(at_s) if at_s > 0 => at_s,
        _ => Timestamp::now().as_second(),
    }
}

/// What a check says against its baseline, if there is one with the same reference, certificate and equipment, and
/// against the certificate.
///
/// # Errors
/// Those of the logbook.
pub fn changes(
    logbook: Option<&Logbook>,
    last: &Record,
    found: &Evaluation,
) -> Result<Vec<Change>> {
    let at_s = measured_s(last);
    let baseline = match logbook {
        Some(logbook) => baseline(&of_reference(logbook, last)?, at_s - 1)?,
        None => None,
    };
    let since = baseline.and_then(|baseline| change(found, &baseline));
    Ok(since.into_iter().chain(from_certificate(found)).collect())
}

/// Checks of this record's instrument with its reference and the certificate of that, the oldest first.
fn of_reference(logbook: &Logbook, record: &Record) -> Result<Vec<SelfCheck>> {
    let (head, reference) = (&record.head, &record.settings.reference);
    let mut checks = logbook.self_checks()?;
    checks.retain(|check| {
        check.instrument == head.instrument_serial.as_str()
            && check.reference == reference.serial.as_str()
            && check.certificate == reference.certificate.as_str()
    });
    Ok(checks)
}

/// The latest baseline until a time.
fn baseline(checks: &[SelfCheck], until_s: i64) -> Result<Option<Evaluation>> {
    let is_earlier = |check: &&SelfCheck| check.is_baseline && check.measured_s <= until_s;
    checks
        .iter()
        .rev()
        .find(is_earlier)
        .map(evaluation)
        .transpose()
}

fn evaluation(check: &SelfCheck) -> Result<Evaluation> {
    serde_json::from_str(&check.evaluation).map_err(|error| {
        Error::input(
            format!("check of the reference of {}", check.instrument),
            error.to_string(),
            "it was kept by another release of calib; `calib logbook check` says whether it is whole",
        )
    })
}

/// The latest check of the reference until a record was measured, as its certificate states it.
///
/// # Errors
/// Those of the logbook.
pub fn of_certificate(
    logbook: Option<&Logbook>,
    record: &Record,
) -> Result<Option<ReferenceCheck>> {
    let Some(logbook) = logbook else {
        return Ok(None);
    };
    let checks = of_reference(logbook, record)?;
    let at_s = measured_s(record);
    let Some(latest) = checks.iter().rev().find(|check| check.measured_s <= at_s) else {
        return Ok(None);
    };
    let found = evaluation(latest)?;
    let before = baseline(&checks, latest.measured_s - 1)?;
    let since = before.and_then(|before| change(&found, &before));
    let stated = since.or_else(|| from_certificate(&found));
    Ok(stated.map(|change| ReferenceCheck {
        day: day(latest.measured_s),
        since_baseline: change.against == Against::Baseline,
        change_rel: change.change_rel,
        expanded_rel: change.expanded_rel,
        significant: change.significant,
    }))
}

/// How the reference of an instrument stands by its checks since the last baseline.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ReferenceState {
    /// Serial number of the instrument.
    pub instrument_serial: String,
    /// Serial number of its reference.
    pub reference_serial: String,
    /// Certificate of that.
    pub reference_certificate: String,
    /// Checks with the equipment of the baseline, which is the first of them.
    pub checks: usize,
    /// Time of the latest, s since 1970-01-01 UTC.
    pub latest_unix_time_s: i64,
    /// What the latest says.
    pub latest: Option<Change>,
    /// What speaks against the latest on the chart; empty with fewer than six checks.
    pub signals: Vec<Signal>,
    /// The chart can judge.
    pub judged: bool,
    /// Neither the latest check nor the chart speaks against the reference.
    pub in_control: bool,
    /// Changes since the baseline, each at its time.
    #[serde(skip)]
    pub changes: Vec<(i64, Change)>,
}

/// Every reference that was ever checked, by its latest certificate.
///
/// # Errors
/// Those of the logbook.
pub fn states(logbook: &Logbook) -> Result<Vec<ReferenceState>> {
    let checks = logbook.self_checks()?;
    let mut known: Vec<&SelfCheck> = Vec::new();
    for latest in checks.iter().rev() {
        if known
            .iter()
            .all(|known| known.instrument != latest.instrument)
        {
            known.push(latest);
        }
    }
    known.sort_by(|a, b| a.instrument.cmp(&b.instrument));
    known
        .into_iter()
        .map(|latest| state(&checks, latest))
        .collect()
}

fn state(checks: &[SelfCheck], latest: &SelfCheck) -> Result<ReferenceState> {
    let is_its = |check: &&SelfCheck| {
        check.instrument == latest.instrument
            && check.reference == latest.reference
            && check.certificate == latest.certificate
    };
    let its: Vec<&SelfCheck> = checks.iter().filter(is_its).collect();
    let begin = its.iter().rposition(|check| check.is_baseline);
    let baseline = begin.map(|at| evaluation(its[at])).transpose()?;
    let mut changes = Vec::new();
    for check in &its[begin.unwrap_or(its.len())..] {
        let found = evaluation(check)?;
        let since = baseline
            .as_ref()
            .and_then(|baseline| change(&found, baseline));
        changes.extend(since.map(|change| (check.measured_s, change)));
    }
    let values: Vec<f64> = changes
        .iter()
        .map(|(_, change)| change.change_rel)
        .collect();
    let chart = control_chart(&values);
    let compared = changes
        .last()
        .filter(|(at_s, _)| *at_s == latest.measured_s);
    let says = match compared.filter(|_| !latest.is_baseline) {
        Some((_, change)) => Some(*change),
        None => from_certificate(&evaluation(latest)?),
    };
    let judged = chart.is_some();
    let signals = chart.map(|chart| chart.signals).unwrap_or_default();
    Ok(ReferenceState {
        instrument_serial: latest.instrument.clone(),
        reference_serial: latest.reference.clone(),
        reference_certificate: latest.certificate.clone(),
        checks: changes.len(),
        latest_unix_time_s: latest.measured_s,
        in_control: signals.is_empty() && !says.is_some_and(|change| change.significant),
        latest: says,
        signals,
        judged,
        changes,
    })
}

/// Day of a time, UTC.
fn day(unix_time_s: i64) -> Date {
    let time = Timestamp::from_second(unix_time_s).unwrap_or(Timestamp::UNIX_EPOCH);
    time.to_zoned(TimeZone::UTC).date()
}
