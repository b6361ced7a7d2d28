//! How, when, where and by whom it was calibrated.

use super::clause;
use super::value::{phrase, said, text};
use crate::model::{Line, Section, Value};
use crate::particulars::{Adjustment, Measurand, Particulars, Place};
use crate::stored::run_day;
use calib_core::point_state::PointState;
use calib_protocol::record::Record;

pub(super) fn calibration(record: &Record, particulars: &Particulars) -> Section {
    let statement = statement(record, particulars);
    let replaced = replaces(particulars).into_iter().chain(statement);
    // Only a run that the instrument began has one.
    let list = text(&record.list.name).map(|name| ("list", clause::NONE, Some(name)));
    let lines = replaced.chain(measurement(record)).chain(list);
    Section::new("calibration", lines)
}

/// Which certificate this one replaces, and why; one that replaces none lacks nothing.
fn replaces(particulars: &Particulars) -> Option<Line> {
    let amended = particulars.calibration.replaces.as_ref()?;
    let values = [amended.certificate.clone(), amended.reason.clone()];
    let said = phrase("replaces.value", &values);
    Some(("replaces", clause::AMENDMENT, said))
}

/// Method, days, place and people.
fn statement(record: &Record, particulars: &Particulars) -> [Line; 10] {
    let stated = &particulars.calibration;
    let date = run_day(record).or(stated.date).map(Value::Day);
    let date = date.or_else(|| particulars.around.value(record));
    let issued = stated.issued.map(Value::Day);
    let measurand = stated.measurand.and_then(measurand);
    let operator = text(&record.head.labels.operator);
    let adjustment = stated.adjustment.and_then(adjustment);
    let method = phrase(format!("method.{:?}", record.settings.method), &[]);
    let example = phrase(format!("example.{:?}", record.settings.example), &[]);
    [
        ("method", clause::METHOD, method),
        ("measurand", clause::METHOD, measurand),
        ("example", clause::NONE, example),
        ("deviations", clause::DEVIATIONS, said(&stated.deviations)),
        ("date", clause::DAY, date),
        ("issued", clause::ISSUED, issued),
        ("place", clause::PLACE, place(particulars)),
        ("operator", clause::NONE, operator),
        ("approved_by", clause::APPROVED, said(&stated.approved_by)),
        ("adjustment", clause::ADJUSTMENT, adjustment),
    ]
}

/// Measured values in the record.
fn measurement(record: &Record) -> [Line; 6] {
    let id = record.head.id.to_string();
    let number = [id, record.head.instrument_serial.to_string()];
    let extent = match record.complete {
        true => "points.complete",
        false => "points.incomplete",
    };
    let points = phrase(extent, &[record.points.len().to_string()]);
    [
        ("record", clause::NONE, phrase("record.value", &number)),
        ("points", clause::NONE, points),
        ("blocks", clause::NONE, Some(blocks(record))),
        ("excitation", clause::NONE, excitation(record)),
        ("quantity", clause::RESULTS, phrase("quantity.rms", &[])),
        ("coherence", clause::RESULTS, coherence(record)),
    ]
}

/// As many as the noise asked for at each point.
fn blocks(record: &Record) -> Value {
    let valid = record
        .points
        .iter()
        .filter(|point| point.state == PointState::Valid);
    let counts = || valid.clone().map(|point| point.blocks);
    match counts().min().zip(counts().max()) {
        Some((fewest, most)) if fewest < most => {
            let range = [fewest, most].map(|count| Value::Number(f64::from(count), 0, ""));
            Value::Phrase("blocks.range".to_owned(), range.to_vec())
        }
        Some((all, _)) => Value::Number(f64::from(all), 0, ""),
        None => Value::Number(f64::from(record.settings.blocks), 0, ""),
    }
}

fn excitation(record: &Record) -> Option<Value> {
    match lowest_coherence(record) {
        None => phrase("excitation.sine", &[]),
        Some(_) => phrase("excitation.broadband", &[]),
    }
}

/// That of the worst point that passed.
fn coherence(record: &Record) -> Option<Value> {
    match lowest_coherence(record) {
        None => phrase("coherence.sine", &[]),
        Some(lowest) => Some(Value::Number(lowest, 4, "")),
    }
}

fn lowest_coherence(record: &Record) -> Option<f64> {
    let passed = record
        .points
        .iter()
        .filter(|point| point.state == PointState::Valid);
    passed
        .filter_map(|point| point.coherence.map(f64::from))
        .reduce(f64::min)
}

fn place(particulars: &Particulars) -> Option<Value> {
    let stated = &particulars.calibration;
    let kind = stated.place.and_then(|place| match place {
        Place::Laboratory => phrase("place.laboratory", &[]),
        Place::Customer => phrase("place.customer", &[]),
        Place::Other => phrase("place.other", &[]),
    });
    said(&stated.place_text).or(kind)
}

fn measurand(measurand: Measurand) -> Option<Value> {
    let key = match measurand {
        Measurand::WithConditioner => "measurand.with_conditioner",
        Measurand::WithoutConditioner => "measurand.without_conditioner",
    };
    phrase(key, &[])
}

fn adjustment(adjustment: Adjustment) -> Option<Value> {
    let key = match adjustment {
        Adjustment::AsFound => "adjustment.as_found",
        Adjustment::AsLeft => "adjustment.as_left",
        Adjustment::ReportedOnly => "adjustment.reported_only",
        Adjustment::NotAdjusted => "adjustment.not_adjusted",
    };
    phrase(key, &[])
}
