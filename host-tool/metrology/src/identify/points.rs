//! The table of points: frequency, magnitude, phase and their uncertainties.

use super::header::{Form, Meaning, Quantity, meaning};
use crate::input::{Column, HIGHEST_HZ, Row, Source, Table};
use calib_files::{Error, Result};
use std::f64::consts::TAU;

/// One frequency of a calibration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Frequency, Hz, above zero.
    pub frequency_hz: f64,
    /// Magnitude of the sensitivity, above zero.
    pub magnitude: f64,
    /// Phase of the sensitivity, rad; negative for an output that lags.
    pub phase_rad: f64,
    /// Standard uncertainty of the magnitude, in its unit.
    pub u_magnitude: f64,
    /// Standard uncertainty of the phase, rad.
    pub u_phase_rad: f64,
}

/// A table of points in rising frequency.
#[derive(Clone, Debug)]
pub struct Points {
    /// At least two points.
    pub points: Vec<Point>,
    /// Whether the table states uncertainties; without them the standard
    /// uncertainties are 1 and mean nothing.
    pub has_uncertainties: bool,
    /// How the columns were understood, and which were not read.
    pub remarks: Vec<String>,
}

struct Chosen {
    frequency: (Column, Meaning),
    magnitude: (Column, Meaning),
    phase: (Column, Meaning),
    u_magnitude: Option<(Column, Meaning)>,
    u_phase: Option<(Column, Meaning)>,
}

/// Reads a table of points.
///
/// # Errors
/// A missing or doubtful column, a value that cannot be, a frequency twice:
/// each with line and remedy.
pub fn read(source: Source) -> Result<Points> {
    let table = Table::parse(source)?;
    let mut remarks = Vec::new();
    let chosen = choose(&table, &mut remarks)?;
    let mut points: Vec<(Point, usize)> = Vec::new();
    for row in &table.rows {
        let point = point(&table, row, &chosen)?;
        if let Some((_, line)) = points
            .iter()
            .find(|(other, _)| other.frequency_hz == point.frequency_hz)
        {
            return Err(table.source.at_line(
                row.line,
                format!(
                    "{} Hz is there twice, first in line {line}",
                    point.frequency_hz
                ),
                "average repeated points, or remove one of them",
            ));
        }
        points.push((point, row.line));
    }
    if points.len() < 2 {
        return Err(table.source.at_line(
            table.header_line,
            "one point cannot determine three parameters",
            "measure at two frequencies or more, better at ten",
        ));
    }
    points.sort_by(|a, b| a.0.frequency_hz.total_cmp(&b.0.frequency_hz));
    Ok(Points {
        points: points.into_iter().map(|(point, _)| point).collect(),
        has_uncertainties: chosen.u_magnitude.is_some(),
        remarks,
    })
}

fn choose(table: &Table, remarks: &mut Vec<String>) -> Result<Chosen> {
    let lower_case = table
        .columns
        .iter()
        .any(|column| column.written.starts_with(|c: char| c.is_ascii_lowercase()));
    let mut all = Vec::new();
    for column in &table.columns {
        match meaning(column, lower_case) {
            Some(meaning) => all.push((column.clone(), meaning)),
            None => remarks.push(format!("column '{}' is not read", column.written)),
        }
    }
    let pick = |quantity: Quantity, uncertain: bool| -> Result<Option<(Column, Meaning)>> {
        let mut found = all.iter().filter(|(_, meaning)| {
            meaning.quantity == quantity && meaning.uncertainty.is_some() == uncertain
        });
        let first = found.next().cloned();
        match found.next() {
            None => Ok(first),
            Some((second, _)) => Err(table.source.at_line(
                table.header_line,
                format!(
                    "column '{}' states a quantity that is already there",
                    second.written
                ),
                "keep one column for each quantity",
            )),
        }
    };
    let need =
        |name: &str, found: Option<(Column, Meaning)>| found.ok_or_else(|| missing(table, name));
    let chosen = Chosen {
        frequency: need("frequency_hz", pick(Quantity::Frequency, false)?)?,
        magnitude: need("magnitude", pick(Quantity::Magnitude, false)?)?,
        phase: need("phase_deg", pick(Quantity::Phase, false)?)?,
        u_magnitude: pick(Quantity::Magnitude, true)?,
        u_phase: pick(Quantity::Phase, true)?,
    };
    check_uncertainties(table, chosen, remarks)
}

fn check_uncertainties(
    table: &Table,
    mut chosen: Chosen,
    remarks: &mut Vec<String>,
) -> Result<Chosen> {
    if chosen.phase.1.form == Form::Unstated {
        return Err(table.source.at_line(
            table.header_line,
            format!("column '{}' does not say its unit", chosen.phase.0.written),
            "name it phase_deg or phase_rad",
        ));
    }
    let stated = std::iter::once(&chosen.magnitude).chain(&chosen.u_magnitude);
    let mut in_db = stated.filter(|(_, meaning)| meaning.form == Form::Decibel);
    if let Some((column, _)) = in_db.next() {
        return Err(table.source.at_line(
            table.header_line,
            format!("column '{}' is in dB", column.written),
            "write magnitudes: 10^(dB / 20) times what the dB refer to; 0.1 dB of uncertainty are 1.16 %",
        ));
    }
    if let Some((_, meaning)) = &mut chosen.u_phase
        && meaning.form == Form::Unstated
    {
        meaning.form = chosen.phase.1.form;
    }
    match (&chosen.u_magnitude, &chosen.u_phase) {
        (Some(_), None) => return Err(missing(table, "u_phase_deg")),
        (None, Some(_)) => return Err(missing(table, "u_magnitude")),
        _ => {}
    }
    for (column, meaning) in chosen.u_magnitude.iter().chain(&chosen.u_phase) {
        if meaning.uncertainty == Some(2.0) {
            remarks.push(format!(
                "column '{}' is read as expanded uncertainty, k = 2",
                column.written
            ));
        }
    }
    if let Some((column, meaning)) = &chosen.u_magnitude {
        let kind = match meaning.form {
            Form::Relative(_) => "relative to the magnitude",
            _ => "in the unit of the magnitude",
        };
        remarks.push(format!("column '{}' is read as {kind}", column.written));
    }
    Ok(chosen)
}

fn missing(table: &Table, name: &str) -> Error {
    let have: Vec<_> = table
        .columns
        .iter()
        .map(|column| column.written.as_str())
        .collect();
    table.source.at_line(
        table.header_line,
        format!("no column '{name}'; there are: {}", have.join(", ")),
        "columns: frequency_hz, magnitude, phase_deg (or phase_rad), u_magnitude \
         (or u_magnitude_percent, u_magnitude_rel), u_phase_deg (or u_phase_rad)",
    )
}

fn point(table: &Table, row: &Row, chosen: &Chosen) -> Result<Point> {
    let frequency_hz = value(table, row, &chosen.frequency, 1.0)?;
    let magnitude = value(table, row, &chosen.magnitude, 1.0)?;
    let uncertainty = |column: &Option<(Column, Meaning)>| match column {
        Some(column) => value(table, row, column, magnitude),
        None => Ok(1.0),
    };
    let point = Point {
        frequency_hz,
        magnitude,
        phase_rad: value(table, row, &chosen.phase, 1.0)?,
        u_magnitude: uncertainty(&chosen.u_magnitude)?,
        u_phase_rad: uncertainty(&chosen.u_phase)?,
    };
    for (name, value) in [
        ("frequency", point.frequency_hz),
        ("magnitude", point.magnitude),
        ("uncertainty of the magnitude", point.u_magnitude),
        ("uncertainty of the phase", point.u_phase_rad),
    ] {
        if value <= 0.0 {
            return Err(table.source.at_line(
                row.line,
                format!("{name} {value} is not greater than zero"),
                "correct the row; an uncertainty of zero would outweigh all others",
            ));
        }
    }
    let has_uncertainty = chosen.u_magnitude.is_some();
    believable(&point, has_uncertainty)
        .map_err(|(problem, hint)| table.source.at_line(row.line, problem, hint))?;
    Ok(point)
}

/// Refuses a point that looks like a column in another unit than its name says: problem and way out.
fn believable(point: &Point, has_uncertainty: bool) -> Result<(), (String, &'static str)> {
    if point.frequency_hz > HIGHEST_HZ {
        return Err((
            format!("frequency {} Hz: no exciter reaches it", point.frequency_hz),
            "the column holds Hz and says kHz? Name it frequency_hz",
        ));
    }
    // A single resonance turns the phase by half a turn, an inverted transducer by as much again.
    if point.phase_rad.abs() > 1.001 * TAU {
        return Err((
            format!("phase {} rad is more than a turn", point.phase_rad),
            "the column holds degrees and says rad? Name it phase_deg; else take whole turns off",
        ));
    }
    if has_uncertainty && point.u_magnitude > point.magnitude {
        return Err((
            format!(
                "uncertainty {} of a magnitude {} is more than all of it",
                point.u_magnitude, point.magnitude
            ),
            "name the column u_magnitude_percent or u_magnitude_rel if it is relative",
        ));
    }
    Ok(())
}

fn value(table: &Table, row: &Row, column: &(Column, Meaning), magnitude: f64) -> Result<f64> {
    let (column, meaning) = column;
    let number = table.number(row, column)? / meaning.uncertainty.unwrap_or(1.0);
    Ok(match meaning.form {
        Form::Scaled(factor) => number * factor,
        Form::Relative(factor) => number * factor * magnitude,
        Form::Unstated | Form::Decibel => number,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    /// Millivolts and no uncertainties: the weights of one that stand in for them were taken for uncertainties of 1 V.
    #[test]
    fn what_has_no_uncertainties_is_read_whatever_its_magnitude() {
        let read = |heads: &str, more: &str| {
            let rows = ["100,0.01,0", "1000,0.01,-1"].map(|row| format!("{row}{more}\n"));
            let text = format!("{heads}\n{}", rows.concat());
            super::read(Source::from_text(Path::new("points.csv"), text).expect("text"))
        };
        let plain = "frequency_hz,magnitude,phase_deg";
        assert_eq!(read(plain, "").expect("two points").points.len(), 2);
        let stated = format!("{plain},u_magnitude,u_phase_deg");
        assert!(read(&stated, ",0.0001,0.1").is_ok());
        let problem = read(&stated, ",1,0.1").expect_err("more than all of it");
        assert!(
            problem.to_string().contains("more than all of it"),
            "{problem}"
        );
    }
}
