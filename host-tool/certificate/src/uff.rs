//! Universal file format, dataset 58: the frequency response function.
//!
//! One dataset 58 per record: complex sensitivity over frequency, uneven
//! abscissa, ASCII double precision. Points without a result are left out.
//! Read back by PyPI `pyuff` in a test.
//!
//! # Source
//! Universal File Datasets, dataset 58 (University of Cincinnati, Structural
//! Dynamics Research Laboratory): records 1 to 12.

use super::kind::{Output, SensorKind};
use super::model::{Certificate, Value};
use super::present;
use super::words::Language;
use calib_core::quantity::MotionQuantity;
use calib_output::number::fixed;
use calib_record::hash_chain::Standing;
use std::fmt::Write;

/// The response as a universal file.
pub(super) fn render(certificate: &Certificate) -> Vec<u8> {
    let results: Vec<_> = certificate.results().collect();
    let mut file = String::from("    -1\n    58\n");
    for line in identification(certificate) {
        let _ = writeln!(file, "{line}");
    }
    // Record 6: frequency response (4), function 1, no load case, response at
    // node 1 in +Z from reference node 2 in +Z.
    let _ = writeln!(
        file,
        "{:5}{:10}{:5}{:10} {:<10}{:10}{:4} {:<10}{:10}{:4}",
        4, 1, 0, 0, "DUT", 1, 3, "REFERENCE", 2, 3
    );
    // Record 7: complex double precision (6), uneven abscissa (0).
    let _ = writeln!(
        file,
        "{:10}{:10}{:10}{:13.5E}{:13.5E}{:13.5E}",
        6,
        results.len(),
        0,
        0.0,
        0.0,
        0.0
    );
    // Records 8 to 11: abscissa frequency (18), ordinate numerator voltage, charge or current
    // (general, 1), denominator acceleration (12), velocity (11) or displacement (8), no third axis.
    axis(&mut file, 18, "Frequency", "Hz");
    let (output, motion) = (output(certificate.kind), motion(certificate.kind));
    axis(&mut file, 1, output.0, output.1);
    axis(&mut file, motion.0, motion.1, motion.2);
    axis(&mut file, 0, "NONE", "NONE");
    for (point, values) in results {
        let phase_rad = values.phase_deg.to_radians();
        // Annex B polarity is part of the transfer function.
        let sign = if certificate.inverted { -1.0 } else { 1.0 };
        let magnitude = sign * values.sensitivity;
        let (sine, cosine) = phase_rad.sin_cos();
        let _ = writeln!(
            file,
            "{}{}{}",
            // E13.5, as the format has it for an uneven abscissa.
            exponential(point.frequency_hz, 13, 5),
            exponential(magnitude * cosine, 20, 12),
            exponential(magnitude * sine, 20, 12)
        );
    }
    file.push_str("    -1\n");
    file.into_bytes()
}

/// Name and unit of what the sensor gives.
fn output(kind: SensorKind) -> (&'static str, &'static str) {
    match kind.unit().output() {
        Output::Voltage => ("Voltage", "V"),
        Output::Charge => ("Charge", "C"),
        Output::Current => ("Current", "A"),
    }
}

/// Type, name and unit of the motion.
fn motion(kind: SensorKind) -> (u32, &'static str, &'static str) {
    match kind.quantity() {
        MotionQuantity::Acceleration => (12, "Acceleration", "m/s2"),
        MotionQuantity::Velocity => (11, "Velocity", "m/s"),
        MotionQuantity::Displacement => (8, "Displacement", "m"),
    }
}

/// As Fortran writes it: two digits of exponent, with its sign.
fn exponential(value: f64, width: usize, decimals: usize) -> String {
    let text = format!("{value:.decimals$E}");
    let (mantissa, exponent) = text.split_once('E').unwrap_or((&text, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    format!("{:>width$}", format!("{mantissa}E{exponent:+03}"))
}

/// Records 1 to 5: 80 characters each; NONE where nothing is said.
fn identification(certificate: &Certificate) -> [String; 5] {
    let said = |section, key| {
        let value = certificate.statement(section, key);
        value.map_or_else(|| "NONE".to_owned(), |v| present::value(v, Language::En))
    };
    let object = format!("{} {}", said("item", "model"), said("item", "serial"));
    let warning = match certificate.record_chain {
        Some(Standing::Broken) => ": DO NOT USE, the chain of its record is broken",
        _ => "",
    };
    let last = match certificate.overrides().join("; ") {
        reasons if reasons.is_empty() => {
            let (output, motion) = (output(certificate.kind), motion(certificate.kind));
            let per = if motion.2.contains('/') {
                format!("({})", motion.2)
            } else {
                motion.2.to_owned()
            };
            format!(
                "complex sensitivity in {}/{per}, {} r.m.s.{}",
                output.1,
                motion.1.to_lowercase(),
                of_response(certificate)
            )
        }
        // Units are in records 8 to 10, too.
        reasons => format!("in spite of: {reasons}"),
    };
    let object = match certificate.marked(Language::En) {
        marks if marks.is_empty() => object,
        marks => format!("{marks}: {object}"),
    };
    let amended = certificate.particulars.calibration.replaces.as_ref();
    let replaces = amended.map_or_else(String::new, |amended| {
        format!(", replaces {}", amended.certificate)
    });
    let conformity = certificate.conformity_statement(Language::En);
    let conformity = conformity.map_or_else(String::new, |stated| format!(", {}", stated.title));
    let lines = [
        object,
        format!("certificate {}{warning}{replaces}", certificate.number),
        format!("{}{conformity}", said("calibration", "date")),
        format!(
            "{}{}",
            by_substitution(certificate),
            said("calibration", "method")
        ),
        last,
    ];
    lines.map(|line| ascii(&line))
}

/// Mounted resonance and amplitude linearity, as short as the line has room for.
fn of_response(certificate: &Certificate) -> String {
    let resonance = certificate.resonance.and_then(|shown| shown.frequency_hz);
    let resonance = resonance.map(|hz| format!("; fr {:.1} kHz", hz / 1000.0));
    let linearity = match certificate.statement("calibration", "linearity") {
        Some(Value::List(all)) => match all.first() {
            Some(Value::Phrase(_, values)) => values.get(4),
            _ => None,
        },
        _ => None,
    };
    let linearity = linearity.and_then(|of| match of {
        Value::Number(percent, ..) => Some(format!("; lin {} %", fixed(*percent, 2))),
        _ => None,
    });
    resonance.into_iter().chain(linearity).collect()
}

/// The standard, where the result is by substitution.
fn by_substitution(certificate: &Certificate) -> String {
    match certificate.statement("calibration", "substitution") {
        Some(Value::Phrase(_, values)) => values.first().map_or_else(String::new, |serial| {
            format!("substitution of {}; ", present::value(serial, Language::En))
        }),
        _ => String::new(),
    }
}

/// The format is ASCII with lines of 80 characters.
fn ascii(line: &str) -> String {
    let printable = |c: char| {
        if c.is_ascii() && !c.is_ascii_control() {
            c
        } else {
            '?'
        }
    };
    line.chars().map(printable).take(80).collect()
}

fn axis(file: &mut String, data_type: u32, label: &str, unit: &str) {
    let _ = writeln!(
        file,
        "{data_type:10}{:5}{:5}{:5} {label:<20} {unit:<20}",
        0, 0, 0
    );
}
