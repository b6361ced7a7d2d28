//! The statements of a certificate, each with the clause that asks for it.
//!
//! Everything ISO 16063-21 clause 7 and ISO/IEC 17025 7.8.2.1 and 7.8.4.1 ask
//! for has a line here; a line without a value is printed as missing.

use super::from_record::{day, run_day};
use super::model::{Entry, Section, Value};
use super::particulars::{Adjustment, Contact, Equipment, Particulars, Place};
use calib_core::verdict::Verdict;
use calib_protocol::record::Record;

/// Key, clause, value.
type Line = (&'static str, &'static str, Option<Value>);

/// All statements in the order they are printed.
pub(super) fn sections(record: &Record, particulars: &Particulars) -> Vec<Section> {
    vec![
        item(record, particulars),
        laboratory(particulars),
        calibration(record, particulars),
        conditions(record, particulars),
        mounting(record, particulars),
        amplifier(record, particulars),
        equipment(record, particulars),
    ]
}

fn section(key: &'static str, lines: Vec<Line>) -> Section {
    let entry = |(key, clause, value)| Entry { key, clause, value };
    Section {
        key,
        entries: lines.into_iter().map(entry).collect(),
    }
}

/// Words, or `None` when nothing but blanks was said.
fn text(words: &str) -> Option<Value> {
    let words = words.trim();
    (!words.is_empty()).then(|| Value::Text(words.to_owned()))
}

fn said(words: &Option<String>) -> Option<Value> {
    words.as_deref().and_then(text)
}

fn phrase(key: impl Into<String>, values: &[String]) -> Option<Value> {
    let values = values.iter().cloned().map(Value::Text).collect();
    Some(Value::Phrase(key.into(), values))
}

fn exact(number: Option<f64>, unit: &'static str) -> Option<Value> {
    number
        .filter(|n| n.is_finite())
        .map(|n| Value::Exact(n, unit))
}

/// What the record states, else what the file states.
fn either(recorded: &str, stated: &Option<String>) -> Option<Value> {
    text(recorded).or_else(|| said(stated))
}

fn item(record: &Record, particulars: &Particulars) -> Section {
    let item = &particulars.item;
    section(
        "item",
        vec![
            (
                "description",
                "ISO/IEC 17025 7.8.2.1 g",
                said(&item.description),
            ),
            (
                "model",
                "ISO/IEC 17025 7.8.2.1 g",
                either(&record.head.labels.dut_model, &item.model),
            ),
            (
                "serial",
                "ISO/IEC 17025 7.8.2.1 g",
                either(&record.head.labels.dut_serial, &item.serial),
            ),
            (
                "customer_id",
                "ISO/IEC 17025 7.8.2.1 g",
                said(&item.customer_id),
            ),
            (
                "condition",
                "ISO/IEC 17025 7.8.2.1 g",
                said(&item.condition),
            ),
            (
                "received",
                "ISO/IEC 17025 7.8.2.1 h",
                item.received.map(Value::Day),
            ),
        ],
    )
}

fn laboratory(particulars: &Particulars) -> Section {
    section(
        "laboratory",
        vec![
            (
                "name",
                "ISO/IEC 17025 7.8.2.1 b",
                contact(&particulars.laboratory),
            ),
            (
                "accreditation",
                "",
                said(&particulars.laboratory.accreditation),
            ),
            (
                "customer",
                "ISO/IEC 17025 7.8.2.1 e",
                contact(&particulars.customer),
            ),
        ],
    )
}

/// A contact on one line: name, street, post code and city, country.
fn contact(contact: &Contact) -> Option<Value> {
    let part = |words: &Option<String>| {
        words
            .as_deref()
            .map(str::trim)
            .unwrap_or_default()
            .to_owned()
    };
    let city = format!("{} {}", part(&contact.postcode), part(&contact.city));
    let parts = [
        part(&contact.name),
        part(&contact.street),
        city.trim().to_owned(),
        part(&contact.country),
    ];
    let stated: Vec<String> = parts.into_iter().filter(|p| !p.is_empty()).collect();
    text(&stated.join(", "))
}

fn calibration(record: &Record, particulars: &Particulars) -> Section {
    let settings = &record.settings;
    let stated = &particulars.calibration;
    let extent = if record.complete {
        "points.complete"
    } else {
        "points.incomplete"
    };
    let number = [
        record.head.id.to_string(),
        record.head.instrument_serial.to_string(),
    ];
    let date = run_day(record).or(stated.date);
    section(
        "calibration",
        vec![
            (
                "method",
                "ISO/IEC 17025 7.8.2.1 f",
                phrase(format!("method.{:?}", settings.method), &[]),
            ),
            (
                "example",
                "",
                phrase(format!("example.{:?}", settings.example), &[]),
            ),
            (
                "deviations",
                "ISO/IEC 17025 7.8.2.1 n",
                said(&stated.deviations),
            ),
            ("date", "ISO/IEC 17025 7.8.2.1 i", date.map(Value::Day)),
            (
                "issued",
                "ISO/IEC 17025 7.8.2.1 j",
                stated.issued.or(date).map(Value::Day),
            ),
            ("place", "ISO/IEC 17025 7.8.2.1 c", place(particulars)),
            ("operator", "", text(&record.head.labels.operator)),
            (
                "approved_by",
                "ISO/IEC 17025 7.8.2.1 o",
                said(&stated.approved_by),
            ),
            (
                "adjustment",
                "ISO/IEC 17025 7.8.4.1 d",
                stated.adjustment.and_then(adjustment),
            ),
            ("record", "", phrase("record.value", &number)),
            (
                "points",
                "",
                phrase(extent, &[record.points.len().to_string()]),
            ),
            (
                "blocks",
                "",
                Some(Value::Number(f64::from(settings.blocks), 0, "")),
            ),
            ("excitation", "", excitation(record)),
            ("quantity", "ISO 16063-21 7 e", phrase("quantity.rms", &[])),
            ("coherence", "ISO 16063-21 7 e", coherence(record)),
        ],
    )
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
        .filter(|point| point.verdict == Verdict::Pass);
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

fn adjustment(adjustment: Adjustment) -> Option<Value> {
    let key = match adjustment {
        Adjustment::AsFound => "adjustment.as_found",
        Adjustment::AsLeft => "adjustment.as_left",
        Adjustment::ReportedOnly => "adjustment.reported_only",
        Adjustment::NotAdjusted => "adjustment.not_adjusted",
    };
    phrase(key, &[])
}

fn conditions(record: &Record, particulars: &Particulars) -> Section {
    let stated = &particulars.conditions;
    let transducer = record.head.labels.temperature_centi_c;
    let mut lines = vec![
        (
            "transducer_temperature",
            "ISO 16063-21 7 a, b",
            transducer.map(|centi| Value::Number(f64::from(centi) / 100.0, 1, "°C")),
        ),
        (
            "ambient_temperature",
            "ISO 16063-21 7 a",
            exact(stated.ambient_temperature_c, "°C"),
        ),
        (
            "temperature_difference",
            "ISO 16063-21 7 a",
            exact(stated.temperature_difference_k, "K"),
        ),
        (
            "humidity",
            "ISO/IEC 17025 7.8.4.1 b",
            exact(stated.humidity_percent, "%"),
        ),
    ];
    // No clause asks for it, so it is no statement that may be missing.
    if let Some(processor_c) = instrument_temperature_c(record) {
        let value = Value::Number(processor_c, 0, "°C");
        let clause = "ISO/IEC 17025 7.8.4.1 b";
        lines.push(("instrument_temperature", clause, Some(value)));
    }
    section("conditions", lines)
}

/// Mean over the points that have one. The processor's: good to some kelvin,
/// and some 25 K above the ambient air.
fn instrument_temperature_c(record: &Record) -> Option<f64> {
    let points = record.points.iter();
    let seen: Vec<f64> = points
        .filter_map(|point| point.instrument_temperature_c.map(f64::from))
        .collect();
    (!seen.is_empty()).then(|| seen.iter().sum::<f64>() / seen.len() as f64)
}

fn mounting(record: &Record, particulars: &Particulars) -> Section {
    let stated = &particulars.mounting;
    section(
        "mounting",
        vec![
            (
                "description",
                "ISO 16063-21 7 c",
                text(&record.head.labels.mounting),
            ),
            ("surface", "ISO 16063-21 7 c", said(&stated.surface)),
            (
                "torque",
                "ISO 16063-21 7 c",
                exact(stated.torque_n_m, "N m"),
            ),
            ("adhesive", "ISO 16063-21 7 c", said(&stated.adhesive)),
            ("adapters", "ISO 16063-21 7 c", said(&stated.adapters)),
            ("lubricant", "ISO 16063-21 7 c", said(&stated.lubricant)),
            ("cable", "ISO 16063-21 7 c", said(&stated.cable)),
            ("orientation", "ISO 16063-21 7 c", said(&stated.orientation)),
        ],
    )
}

fn amplifier(record: &Record, particulars: &Particulars) -> Section {
    let settings = &record.settings;
    let stated = &particulars.amplifier;
    // The seven digits an f32 holds.
    let digits = |value: f64| format!("{value:.6e}").parse().ok();
    let scale = |volt_per_code: f32| exact(digits(f64::from(volt_per_code) * 1.0e6), "µV");
    section(
        "amplifier",
        vec![
            ("description", "ISO 16063-21 7 d", said(&stated.description)),
            ("gain", "ISO 16063-21 7 d", said(&stated.gain)),
            (
                "lower_cutoff",
                "ISO 16063-21 7 d",
                exact(stated.lower_cutoff_hz, "Hz"),
            ),
            (
                "upper_cutoff",
                "ISO 16063-21 7 d",
                exact(stated.upper_cutoff_hz, "Hz"),
            ),
            (
                "slope",
                "ISO 16063-21 7 d",
                exact(stated.slope_db_per_octave, "dB/oct"),
            ),
            ("dut_input", "", scale(settings.dut_input.volt_per_code)),
            (
                "reference_input",
                "",
                scale(settings.reference_input.volt_per_code),
            ),
        ],
    )
}

fn equipment(record: &Record, particulars: &Particulars) -> Section {
    let reference = &record.settings.reference;
    let mut section = section(
        "equipment",
        vec![
            (
                "instrument",
                "ISO 16063-21 7",
                text(&record.head.instrument_serial),
            ),
            ("firmware", "", text(&record.head.firmware)),
            (
                "instrument_certificate",
                "ISO/IEC 17025 7.8.4.1 c",
                said(&particulars.calibrator.certificate),
            ),
            (
                "instrument_due",
                "ISO 16063-21 7",
                particulars.calibrator.due.map(Value::Day),
            ),
            ("reference", "ISO 16063-21 7", text(&reference.serial)),
            (
                "reference_certificate",
                "ISO/IEC 17025 7.8.4.1 c",
                text(&reference.certificate),
            ),
            (
                "reference_calibrated",
                "",
                day(reference.calibrated_day).map(Value::Day),
            ),
            (
                "reference_due",
                "ISO 16063-21 7",
                day(reference.due_day).map(Value::Day),
            ),
            (
                "traceability",
                "ISO/IEC 17025 7.8.4.1 c",
                said(&particulars.texts.traceability).or_else(|| traceability(record)),
            ),
        ],
    );
    // What was not used is not missing.
    if !particulars.equipment.is_empty() {
        let list = particulars.equipment.iter().map(instrument).collect();
        section.entries.push(Entry {
            key: "others",
            clause: "ISO 16063-21 7",
            value: Some(Value::List(list)),
        });
    }
    section
}

/// Traceability through the reference, if it has a certificate.
fn traceability(record: &Record) -> Option<Value> {
    let reference = &record.settings.reference;
    let due = day(reference.due_day).map_or("\u{2013}".to_owned(), |due| due.to_string());
    text(&reference.certificate)?;
    let values = [
        reference.serial.to_string(),
        reference.certificate.to_string(),
        due,
    ];
    phrase("statement.traceability", &values)
}

fn instrument(used: &Equipment) -> Value {
    let dash = || "\u{2013}".to_owned();
    let due = used.due.map_or_else(dash, |due| due.to_string());
    let certificate = used.certificate.clone().unwrap_or_else(dash);
    let values = [used.name.clone(), used.serial.clone(), certificate, due];
    let values = values.map(Value::Text).to_vec();
    Value::Phrase("equipment.item".to_owned(), values)
}
