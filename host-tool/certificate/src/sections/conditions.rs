//! Conditions of the calibration: climate and mounting.

use super::clause;
use super::value::{exact, said, text};
use crate::model::{Section, Value};
use crate::particulars::Particulars;
use calib_protocol::record::Record;

pub(super) fn conditions(record: &Record, particulars: &Particulars) -> Section {
    let stated = &particulars.conditions;
    let celsius = |centi| Value::Number(f64::from(centi) / 100.0, 1, "°C");
    let transducer = record.head.labels.temperature_centi_c.map(celsius);
    let ambient = exact(stated.ambient_temperature_c, "°C");
    let difference = exact(stated.temperature_difference_k, "K");
    let humidity = exact(stated.humidity_percent, "%");
    let asked = [
        (
            "transducer_temperature",
            clause::TRANSDUCER_TEMPERATURE,
            transducer,
        ),
        ("ambient_temperature", clause::AMBIENT, ambient),
        ("temperature_difference", clause::AMBIENT, difference),
        ("humidity", clause::INFLUENCES, humidity),
    ];
    // No clause asks for it, so it is no statement that may be missing.
    let processor = instrument_temperature_c(record).map(|processor_c| {
        let value = Value::Number(processor_c, 0, "°C");
        ("instrument_temperature", clause::INFLUENCES, Some(value))
    });
    Section::new("conditions", asked.into_iter().chain(processor))
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

pub(super) fn mounting(record: &Record, particulars: &Particulars) -> Section {
    let stated = &particulars.mounting;
    let description = text(&record.head.labels.mounting);
    let values = [
        ("description", description),
        ("surface", said(&stated.surface)),
        ("torque", exact(stated.torque_n_m, "N m")),
        ("adhesive", said(&stated.adhesive)),
        ("adapters", said(&stated.adapters)),
        ("lubricant", said(&stated.lubricant)),
        ("cable", said(&stated.cable)),
        ("orientation", said(&stated.orientation)),
    ];
    Section::new(
        "mounting",
        values.map(|(key, value)| (key, clause::MOUNTING, value)),
    )
}
