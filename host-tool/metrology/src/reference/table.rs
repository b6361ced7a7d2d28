//! A CSV with a column each for frequency, sensitivity or deviation, U, k and phase, as laboratories write it; what it
//! is of stands in remarks (`# serial: R 17`), or in columns as on this tool's own certificates.

use super::certified::{
    Certified, CertifiedPoint, RAD_PER_DEGREE, Reading, STANDARD_GRAVITY_MS2, checked,
};
use crate::input::{Column, Row, Source, Table};
use calib_files::Result;
use jiff::civil::Date;

/// Names of the column of sensitivities, and V/(m/s2) of one of them.
const SENSITIVITIES: [(&str, f64); 3] = [
    (
        "sensitivity_mv_per_ms2 sensitivity_mv_m_s2 sensitivity_mv_m_s² sensitivity_mv_ms2 s_mv_per_ms2 s_mv_m_s2 s_mv_m_s²",
        1e-3,
    ),
    (
        "sensitivity_v_per_ms2 sensitivity_v_m_s2 sensitivity_v_m_s² s_v_per_ms2 s_v_m_s2 s_v_m_s²",
        1.0,
    ),
    (
        "sensitivity_mv_per_g sensitivity_mv_g s_mv_per_g s_mv_g",
        1e-3 / STANDARD_GRAVITY_MS2,
    ),
];
const FREQUENCIES: &str = "frequency_hz freq_hz f_hz frequenz_hz frequency_in_hz";
const DEVIATIONS: &str = "deviation_percent abweichung_percent deviation_in_percent dev_percent";
const UNCERTAINTIES: &str =
    "expanded_uncertainty_percent u_percent u_s_percent uncertainty_percent u_in_percent";
const FACTORS: &str = "coverage_factor k coverage_factor_k";
const PHASES: [(&str, f64); 2] = [
    (
        "phase_deg phase_in_deg phase_degree phase_degrees",
        RAD_PER_DEGREE,
    ),
    ("phase_rad", 1.0),
];
const PHASE_UNCERTAINTIES: [(&str, f64); 2] = [
    (
        "expanded_uncertainty_phase_deg u_phase_deg u_phi_deg",
        RAD_PER_DEGREE,
    ),
    ("expanded_uncertainty_phase_rad u_phase_rad u_phi_rad", 1.0),
];

/// Columns of the table, with what their numbers are to be multiplied by.
struct Columns {
    frequency: Column,
    sensitivity: (Column, f64),
    deviates: bool,
    uncertainty: Column,
    factor: Column,
    phase: Option<((Column, f64), (Column, f64))>,
    /// Whether the point was refused, on this tool's own certificates.
    state: Option<Column>,
}

pub(super) fn read(source: Source, reading: &Reading) -> Result<Certified> {
    let table = Table::parse(source)?;
    let columns = Columns::of(&table, reading)?;
    let (mut points, mut lines) = (Vec::new(), Vec::new());
    for row in &table.rows {
        let refused = columns
            .state
            .as_ref()
            .is_some_and(|state| row.cells[state.index] == "refused");
        if !refused {
            points.push(columns.point(&table, row, reading)?);
            lines.push(row.line);
        }
    }
    let source = &table.source;
    if points.is_empty() {
        return Err(source.at_line(
            table.header_line,
            "every row is refused",
            "nothing was calibrated",
        ));
    }
    checked(source, &points, &lines)?;
    let said = |keys: &[&str]| stated(&table, keys);
    Ok(Certified {
        serial: said(&["serial", "serial number", "dut_serial"]),
        model: said(&["model", "dut_model"]),
        certificate: said(&["certificate"]),
        laboratory: said(&["laboratory"]),
        calibrated: day(&table, &["calibrated", "date"])?,
        due: day(&table, &["due"])?,
        traceability: said(&["traceability", "traceable"]),
        equipment: Vec::new(),
        points,
    })
}

impl Columns {
    fn of(table: &Table, reading: &Reading) -> Result<Self> {
        let deviation = table.find(DEVIATIONS)?.cloned();
        let sensitivity = first(table, &SENSITIVITIES)?;
        let deviates = sensitivity.is_none();
        let sensitivity = match (sensitivity, deviation, reading.sensitivity_v_per_ms2) {
            (Some(found), ..) => found,
            (None, Some(deviation), Some(_)) => (deviation, 0.01),
            (None, Some(_), None) => {
                return Err(table.source.at_line(
                    table.header_line,
                    "deviations alone: the sensitivity they are of is not in the file",
                    "state it with --sensitivity, in the unit of --unit",
                ));
            }
            (None, None, _) => {
                let names = SENSITIVITIES.map(|(names, _)| names).join(" ");
                let column =
                    table.require("the sensitivity with its unit, or the deviation", &names)?;
                (column.clone(), 1.0)
            }
        };
        let phase = first(table, &PHASES)?;
        let u_phase = first(table, &PHASE_UNCERTAINTIES)?;
        if let (Some((column, _)), None) = (&phase, &u_phase) {
            return Err(table.source.at_line(
                table.header_line,
                format!("{} without an uncertainty", column.written),
                "add the column expanded_uncertainty_phase_deg, or take the phase out",
            ));
        }
        Ok(Self {
            frequency: table.require("the frequency", FREQUENCIES)?.clone(),
            sensitivity,
            deviates,
            uncertainty: table
                .require(
                    "the expanded uncertainty in percent of the sensitivity",
                    UNCERTAINTIES,
                )?
                .clone(),
            factor: table.require("the coverage factor", FACTORS)?.clone(),
            phase: phase.zip(u_phase),
            state: table.find("state")?.cloned(),
        })
    }

    fn point(&self, table: &Table, row: &Row, reading: &Reading) -> Result<CertifiedPoint> {
        let number = |column: &Column| table.number(row, column);
        let (column, scale) = &self.sensitivity;
        let stated = number(column)? * scale;
        let sensitivity_v_per_ms2 = match (self.deviates, reading.sensitivity_v_per_ms2) {
            (true, Some(reference)) => reference * (1.0 + stated),
            _ => stated,
        };
        let coverage_factor = number(&self.factor)?;
        let phase = self.phase.as_ref().map(|((phase, scale), (u, u_scale))| {
            Ok((number(phase)? * scale, number(u)? * u_scale))
        });
        let phase: Option<(f64, f64)> = phase.transpose()?;
        Ok(CertifiedPoint {
            frequency_hz: number(&self.frequency)?,
            sensitivity_v_per_ms2,
            expanded_uncertainty_rel: 0.01 * number(&self.uncertainty)?,
            coverage_factor,
            phase_rad: phase.map(|(phase, _)| phase),
            expanded_uncertainty_phase_rad: phase.map(|(_, u)| u),
            coverage_factor_phase: phase.map(|_| coverage_factor),
        })
    }
}

/// The first of these columns there is, with its factor.
fn first(table: &Table, all: &[(&str, f64)]) -> Result<Option<(Column, f64)>> {
    for (names, factor) in all {
        if let Some(column) = table.find(names)? {
            return Ok(Some((column.clone(), *factor)));
        }
    }
    Ok(None)
}

/// Value of a remark `# key: value` or of a column about the object; a column must hold one value.
fn stated(table: &Table, keys: &[&str]) -> Option<String> {
    let remarks = table
        .source
        .text
        .lines()
        .filter_map(|line| line.strip_prefix('#')?.split_once(':'));
    let mut of_remark =
        remarks.filter(|(key, _)| keys.contains(&key.trim().to_lowercase().as_str()));
    let of_column = || {
        let column = table
            .columns
            .iter()
            .find(|column| keys.contains(&column.name.as_str()))?;
        let mut cells = table.rows.iter().map(|row| row.cells[column.index].clone());
        let one = cells.next()?;
        cells.all(|cell| cell == one).then_some(one)
    };
    let said = of_remark
        .next()
        .map(|(_, value)| value.trim().to_owned())
        .or_else(of_column);
    said.filter(|said| !said.is_empty())
}

fn day(table: &Table, keys: &[&str]) -> Result<Option<Date>> {
    let Some(text) = stated(table, keys) else {
        return Ok(None);
    };
    let day = text.parse().map_err(|_| {
        let line = table
            .source
            .text
            .lines()
            .position(|line| line.contains(&text));
        let line = line.map_or(table.header_line, |at| at + 1);
        table
            .source
            .at_line(line, format!("'{text}' is no day"), "a day is 2026-11-20")
    })?;
    Ok(Some(day))
}
