//! Equipment of the calibration, and its traceability.

use super::clause;
use super::value::{exact, phrase, said, text};
use crate::interval::{InForce, in_force};
use crate::kind::{Output, SensorKind};
use crate::model::{Line, Section, Value};
use crate::particulars::{Equipment, Particulars};
use crate::stored::{day, run_day};
use calib_core::settings::InputScale;
use calib_protocol::record::Record;
use calib_record::origin::is_emulated;

pub(super) fn amplifier(record: &Record, particulars: &Particulars) -> Section {
    let stated = &particulars.amplifier;
    let gain = of_kind(particulars.kind());
    let lower = exact(stated.lower_cutoff_hz, "Hz");
    let upper = exact(stated.upper_cutoff_hz, "Hz");
    let slope = exact(stated.slope_db_per_octave, "dB/oct");
    let dut = scale(record.settings.dut_input);
    let reference = scale(record.settings.reference_input);
    let lines = [
        ("description", clause::AMPLIFIER, said(&stated.description)),
        ("gain", clause::AMPLIFIER, said(&stated.gain).or(gain)),
        ("lower_cutoff", clause::AMPLIFIER, lower),
        ("upper_cutoff", clause::AMPLIFIER, upper),
        ("slope", clause::AMPLIFIER, slope),
        ("dut_input", clause::NONE, dut),
        ("reference_input", clause::NONE, reference),
    ];
    Section::new("amplifier", lines)
}

/// The charge amplifier or the burden that a kind of sensor is read through.
fn of_kind(kind: SensorKind) -> Option<Value> {
    let (gain, percent) = kind.gain_and_expanded_percent()?;
    let (key, unit) = match kind.unit().output() {
        Output::Charge => ("gain.charge", "mV/pC"),
        _ => ("gain.burden", "Ω"),
    };
    let values = vec![Value::Exact(gain, unit), Value::Exact(percent, "%")];
    Some(Value::Phrase(key.to_owned(), values))
}

/// Microvolt per code, to the seven digits an f32 holds.
fn scale(input: InputScale) -> Option<Value> {
    let microvolt = f64::from(input.volt_per_code) * 1.0e6;
    exact(format!("{microvolt:.6e}").parse().ok(), "µV")
}

pub(super) fn equipment(record: &Record, particulars: &Particulars) -> Section {
    let own = calibrator(record, particulars);
    let reference = reference(record, particulars);
    // What was not used is not missing.
    let others = (!particulars.equipment.is_empty()).then(|| {
        let list = particulars.equipment.iter().map(instrument).collect();
        ("others", clause::INSTRUMENTS, Some(Value::List(list)))
    });
    let lines = own.into_iter().chain(reference).chain(others);
    Section::new("equipment", lines)
}

fn calibrator(record: &Record, particulars: &Particulars) -> [Line; 4] {
    let stated = &particulars.calibrator;
    let serial = text(&record.head.instrument_serial);
    let firmware = text(&record.head.firmware);
    let certificate = said(&stated.certificate);
    let due = stated.due.map(Value::Day);
    [
        ("instrument", clause::INSTRUMENTS, serial),
        ("firmware", clause::NONE, firmware),
        ("instrument_certificate", clause::TRACEABILITY, certificate),
        ("instrument_due", clause::INSTRUMENTS, due),
    ]
}

fn reference(record: &Record, particulars: &Particulars) -> [Line; 5] {
    let reference = &record.settings.reference;
    let certificate = text(&reference.certificate);
    let calibrated = day(reference.calibrated_day).map(Value::Day);
    let due = day(reference.due_day).map(Value::Day);
    let traceability = traceability(record, particulars);
    [
        ("reference", clause::INSTRUMENTS, text(&reference.serial)),
        ("reference_certificate", clause::TRACEABILITY, certificate),
        ("reference_calibrated", clause::NONE, calibrated),
        ("reference_due", clause::INSTRUMENTS, due),
        ("traceability", clause::TRACEABILITY, traceability),
    ]
}

/// True when serial number, certificate and days of the reference are stated, its calibration
/// was in force on the day of this one, or its interval extended by the laboratory's rule, and the instrument is no emulated one.
pub(in super::super) fn is_traceable(record: &Record, particulars: &Particulars) -> bool {
    let reference = &record.settings.reference;
    let named = text(&reference.serial)
        .and(text(&reference.certificate))
        .is_some();
    let days = (
        day(reference.calibrated_day),
        day(reference.due_day),
        run_day(record),
    );
    let in_force = match days {
        (Some(calibrated), Some(_), Some(run)) => {
            let standing = in_force(record, particulars, Some(run));
            calibrated <= run && !matches!(standing, InForce::Overdue { .. })
        }
        _ => false,
    };
    named && in_force && !is_emulated(&record.head.instrument_serial)
}

/// Traceability through the reference; where it cannot be shown, that and why, whatever the
/// laboratory's text says.
fn traceability(record: &Record, particulars: &Particulars) -> Option<Value> {
    let reference = &record.settings.reference;
    text(&reference.certificate)?;
    if is_emulated(&record.head.instrument_serial) {
        return phrase("traceability.simulated", &[]);
    }
    if !is_traceable(record, particulars) {
        return phrase("traceability.not_in_force", &[]);
    }
    let due = day(reference.due_day).map_or("\u{2013}".to_owned(), |due| due.to_string());
    let values = [
        reference.serial.to_string(),
        reference.certificate.to_string(),
        due,
    ];
    said(&particulars.texts.traceability).or_else(|| phrase("statement.traceability", &values))
}

fn instrument(used: &Equipment) -> Value {
    let dash = || "\u{2013}".to_owned();
    let due = used.due.map_or_else(dash, |due| due.to_string());
    let certificate = used.certificate.clone().unwrap_or_else(dash);
    let values = [used.name.clone(), used.serial.clone(), certificate, due];
    let values = values.map(Value::Text).to_vec();
    Value::Phrase("equipment.item".to_owned(), values)
}
