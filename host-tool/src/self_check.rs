//! Checks of the reference in the logbook: kept, compared with their baseline, stated on certificates.

use crate::{Error, Result};
use calib_certificate::ReferenceCheck;
use calib_logbook::{Logbook, SelfCheck};
use calib_metrology::control_chart::{Signal, control_chart};
use calib_metrology::reciprocity::{self, Against, Change, Evaluation, change, from_certificate};
use calib_metrology::turn_over::TurnOver;
use calib_protocol::record::Record;
use jiff::Timestamp;
use jiff::civil::Date;
use jiff::tz::TimeZone;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Result of a check, by its method.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Found {
    /// A mass and the ratio of two voltages.
    Reciprocity(Box<Evaluation>),
    /// Turned over in gravity.
    Gravity(TurnOver),
}

impl Found {
    /// Against an earlier check by the same method, if it had the same equipment.
    fn since(&self, baseline: &Self) -> Option<Change> {
        match (self, baseline) {
            (Self::Reciprocity(now), Self::Reciprocity(then)) => change(now, then),
            (Self::Gravity(now), Self::Gravity(then)) => Some(now.since(then)),
            _ => None,
        }
    }

    fn against_certificate(&self) -> Option<Change> {
        match self {
            Self::Reciprocity(found) => from_certificate(found),
            Self::Gravity(found) => Some(found.against_certificate()),
        }
    }

    fn is_by_gravity(&self) -> bool {
        matches!(self, Self::Gravity(_))
    }
}

/// Keeps a check of the reference of the instrument that measured `last`; false where it is there already.
///
/// # Errors
/// Those of the logbook.
pub fn keep(logbook: &Logbook, last: &Record, found: &Found, is_baseline: bool) -> Result<bool> {
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

/// Changes by a check against its baseline, if there is one with the same reference, certificate and equipment, and
/// against the certificate.
///
/// # Errors
/// Those of the logbook.
pub fn changes(logbook: Option<&Logbook>, last: &Record, found: &Found) -> Result<Vec<Change>> {
    let since = baseline_of(logbook, last, found)?.and_then(|baseline| found.since(&baseline));
    Ok(since
        .into_iter()
        .chain(found.against_certificate())
        .collect())
}

/// The baseline a check is compared with.
fn baseline_of(logbook: Option<&Logbook>, last: &Record, found: &Found) -> Result<Option<Found>> {
    let Some(logbook) = logbook else {
        return Ok(None);
    };
    let checks = of_reference(logbook, last)?;
    baseline(&checks, measured_s(last) - 1, found.is_by_gravity())
}

/// Warning about the ratio of the channels in a check, by the baseline it is compared with.
///
/// # Errors
/// Those of the logbook.
pub fn about_the_ratio(
    logbook: Option<&Logbook>,
    last: &Record,
    found: &Found,
) -> Result<Option<String>> {
    let Found::Reciprocity(now) = found else {
        return Ok(None);
    };
    let before = match baseline_of(logbook, last, found)? {
        Some(Found::Reciprocity(then)) => Some(then),
        _ => None,
    };
    Ok(reciprocity::about_the_ratio(now, before.as_deref()))
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

/// The latest baseline of a method until a time.
fn baseline(checks: &[SelfCheck], until_s: i64, by_gravity: bool) -> Result<Option<Found>> {
    let is_earlier = |check: &&SelfCheck| check.is_baseline && check.measured_s <= until_s;
    for check in checks.iter().rev().filter(is_earlier) {
        let found = evaluation(check)?;
        if found.is_by_gravity() == by_gravity {
            return Ok(Some(found));
        }
    }
    Ok(None)
}

fn evaluation(check: &SelfCheck) -> Result<Found> {
    read(&check.evaluation).map_err(|error| {
        Error::input(
            format!("check of the reference of {}", check.instrument),
            error.to_string(),
            "it was kept by another release of calib; `calib logbook check` says whether it is whole",
        )
    })
}

/// Checks by reciprocity have points, and were the only ones in earlier releases.
fn read(kept: &str) -> serde_json::Result<Found> {
    #[derive(Deserialize)]
    struct Points {
        points: Option<serde::de::IgnoredAny>,
    }
    match serde_json::from_str::<Points>(kept)?.points {
        Some(_) => serde_json::from_str(kept).map(Found::Reciprocity),
        None => serde_json::from_str(kept).map(Found::Gravity),
    }
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
    let before = baseline(&checks, latest.measured_s - 1, found.is_by_gravity())?;
    let since = before.and_then(|before| found.since(&before));
    let stated = since.or_else(|| found.against_certificate());
    Ok(stated.map(|change| ReferenceCheck {
        day: day(latest.measured_s),
        by_gravity: found.is_by_gravity(),
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
    pub last_unix_time_s: i64,
    /// Change by the latest.
    pub latest: Option<Change>,
    /// Signals of the chart against the latest; empty with fewer than six checks.
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
    let says = evaluation(latest)?;
    let mut its: Vec<(&SelfCheck, Found)> = Vec::new();
    for check in checks.iter().filter(is_its) {
        let found = evaluation(check)?;
        if found.is_by_gravity() == says.is_by_gravity() {
            its.push((check, found));
        }
    }
    let begin = its.iter().rposition(|(check, _)| check.is_baseline);
    let baseline = begin.map(|at| &its[at].1);
    let mut changes = Vec::new();
    for (check, found) in &its[begin.unwrap_or(its.len())..] {
        let since = baseline.and_then(|baseline| found.since(baseline));
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
        None => says.against_certificate(),
    };
    let judged = chart.is_some();
    let signals = chart.map(|chart| chart.signals).unwrap_or_default();
    Ok(ReferenceState {
        instrument_serial: latest.instrument.clone(),
        reference_serial: latest.reference.clone(),
        reference_certificate: latest.certificate.clone(),
        checks: changes.len(),
        last_unix_time_s: latest.measured_s,
        in_control: signals.is_empty() && !says.is_some_and(|change| change.significant),
        latest: says,
        signals,
        judged,
        changes,
    })
}

/// Day of a time, UTC.
pub(crate) fn day(unix_time_s: i64) -> Date {
    let time = Timestamp::from_second(unix_time_s).unwrap_or(Timestamp::UNIX_EPOCH);
    time.to_zoned(TimeZone::UTC).date()
}
