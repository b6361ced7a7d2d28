//! The phase file: limits and readings, TOML.

use super::limits::Limits;
use crate::input::{self, Number, Source};
use crate::statistics::unwrapped_deg;
use calib_files::Result;
use serde::Deserialize;
use std::path::Path;
use toml::Spanned;

const KEYS: &str = "known keys: reference_deg, phasemeter_deg, amplifier_deg, and [[frequency]] \
with frequency_hz, phase_difference_deg = [readings], reference_phase_deg; see \
docs/metrology/phase.md";

/// Readings at one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct PhasePoint {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Phase of the pick-up against the reference, degrees; two or more.
    pub readings_deg: Vec<f64>,
    /// Phase of the reference itself, degrees.
    pub reference_phase_deg: f64,
}

/// A checked phase file, frequencies rising.
#[derive(Clone, Debug, PartialEq)]
pub struct PhaseFile {
    /// Systematic limits.
    pub limits: Limits,
    /// Points.
    pub points: Vec<PhasePoint>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Raw {
    reference_deg: Number,
    phasemeter_deg: Number,
    amplifier_deg: Number,
    #[serde(default)]
    frequency: Vec<Spanned<RawPoint>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawPoint {
    frequency_hz: Number,
    phase_difference_deg: Spanned<Vec<Number>>,
    reference_phase_deg: Option<Number>,
}

/// Reads a phase file.
///
/// # Errors
/// Every fault with file, line and remedy.
pub fn load(path: &Path) -> Result<PhaseFile> {
    parse(&Source::read(path)?)
}

/// Reads phases from text.
///
/// # Errors
/// As [`load`].
pub fn parse(source: &Source) -> Result<PhaseFile> {
    let raw: Raw = source.parse_toml(KEYS)?;
    let limits = Limits {
        reference_deg: limit(source, "reference_deg", &raw.reference_deg)?,
        phasemeter_deg: limit(source, "phasemeter_deg", &raw.phasemeter_deg)?,
        amplifier_deg: limit(source, "amplifier_deg", &raw.amplifier_deg)?,
    };
    if limits.reference_deg + limits.phasemeter_deg + limits.amplifier_deg == 0.0 {
        return Err(source.at(
            &raw.reference_deg.span(),
            "every limit is zero: no phasemeter and no reference is without error",
            "state the limits of their certificates, in degrees",
        ));
    }
    let mut points: Vec<PhasePoint> = Vec::new();
    for table in &raw.frequency {
        let point = point(source, table.get_ref())?;
        if points
            .iter()
            .any(|other| other.frequency_hz == point.frequency_hz)
        {
            return Err(source.at(
                &table.get_ref().frequency_hz.span(),
                format!("{} Hz is there twice", point.frequency_hz),
                "put all readings of a frequency into one list",
            ));
        }
        points.push(point);
    }
    if points.is_empty() {
        return Err(source.at_line(1, "there is no frequency", "add [[frequency]] tables"));
    }
    points.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Ok(PhaseFile { limits, points })
}

fn limit(source: &Source, name: &str, number: &Number) -> Result<f64> {
    let value = input::finite(source, name, number)?;
    let problem = match value {
        _ if value < 0.0 => "a limit is never negative",
        _ if value > 180.0 => "is more than half a turn",
        _ => return Ok(value),
    };
    Err(source.at(
        &number.span(),
        format!("{name} = {value}: {problem}"),
        "write its magnitude in degrees",
    ))
}

fn point(source: &Source, raw: &RawPoint) -> Result<PhasePoint> {
    let readings = raw.phase_difference_deg.get_ref();
    if readings.len() < 2 {
        return Err(source.at(
            &raw.phase_difference_deg.span(),
            "one reading has no scatter",
            "give two readings or more; Student's t shrinks quickly with their number",
        ));
    }
    let readings_deg = readings
        .iter()
        .map(|number| input::finite(source, "phase_difference_deg", number))
        .collect::<Result<Vec<f64>>>()?;
    let turned = unwrapped_deg(&readings_deg);
    let end = |of: fn(f64, f64) -> f64| turned.iter().copied().reduce(of).unwrap_or(0.0);
    if end(f64::max) - end(f64::min) > 90.0 {
        return Err(source.at(
            &raw.phase_difference_deg.span(),
            "the readings lie more than a quarter of a turn apart and have no common phase",
            "readings of one phase scatter by a few degrees; look for an exchanged channel",
        ));
    }
    Ok(PhasePoint {
        frequency_hz: input::positive(source, "frequency_hz", &raw.frequency_hz)?,
        readings_deg,
        reference_phase_deg: match &raw.reference_phase_deg {
            Some(number) => input::finite(source, "reference_phase_deg", number)?,
            None => 0.0,
        },
    })
}
