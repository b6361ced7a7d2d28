//! `calib run --substitute CHECK`: a standard and then the device in the same channel.

use super::Context;
use crate::assurance;
use calib_certificate::{Particulars, Standard, StandardPoint, Substituted, substitute};
use calib_host::Result;
use calib_metrology::input::{Column, HIGHEST_HZ, Source, Table as Input};
use calib_metrology::text::Table;
use calib_protocol::record::Record;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;

/// Result of a substitution.
#[derive(Serialize, JsonSchema)]
pub(super) struct Substitution {
    /// Serial number of the standard.
    standard_serial: String,
    /// Running number of its record.
    standard_record_id: u32,
    /// Running number of the device's.
    dut_record_id: u32,
    /// Every point that both records have, and the standard's certificate.
    points: Vec<Substituted>,
}

/// A standard by its serial number, and what its certificate says.
pub(super) struct Known {
    pub(super) serial: String,
    pub(super) certified: Vec<StandardPoint>,
}

impl Known {
    /// The standard of this serial number: by the table of its certificate, else by what the logbook knows of a
    /// check standard.
    ///
    /// # Errors
    /// [`calib_host::Error::Files`] when the table is none, or nobody stated what it is.
    pub(super) fn find(context: &Context, serial: &str, table: Option<&Path>) -> Result<Self> {
        let certified = match table {
            Some(path) => read(path)?,
            None => assurance::certified(context.logbook_if_there()?.as_ref(), serial)?,
        };
        Ok(Self {
            serial: serial.to_owned(),
            certified,
        })
    }

    /// The device by this standard, from both records.
    ///
    /// # Errors
    /// Those of [`substitute`].
    pub(super) fn substituted(
        &self,
        standard: Record,
        device: &Record,
        particulars: &Particulars,
    ) -> Result<Substitution> {
        let standard = Standard {
            record: standard,
            certified: self.certified.clone(),
        };
        Ok(Substitution {
            standard_serial: self.serial.clone(),
            standard_record_id: standard.record.head.id,
            dut_record_id: device.head.id,
            points: substitute(&standard, device, particulars)?,
        })
    }
}

/// The table of a certificate: frequency_hz, sensitivity_mv or sensitivity_v, expanded_uncertainty_percent.
fn read(path: &Path) -> Result<Vec<StandardPoint>> {
    let table = Input::parse(Source::read(path)?)?;
    let frequency = table.require("the frequency", "frequency_hz")?;
    let u = table.require("U (k = 2)", "expanded_uncertainty_percent")?;
    let (sensitivity, scale) = match table.find("sensitivity_mv")? {
        Some(column) => (column, 1e-3),
        None => (table.require("the sensitivity", "sensitivity_v")?, 1.0),
    };
    let hint = "frequencies are in Hz, sensitivities in their column's unit, U (k = 2) in percent";
    let between = |row, column: &Column, [least, most]: [f64; 2]| {
        let value = table.number(row, column)?;
        if (least..=most).contains(&value) {
            return Ok(value);
        }
        let written = &column.written;
        let problem = format!("{written} = {value} is not between {least} and {most}");
        Err(table.source.at_line(row.line, problem, hint))
    };
    let mut points: Vec<StandardPoint> = Vec::new();
    for row in &table.rows {
        let point = StandardPoint {
            frequency_hz: between(row, frequency, [0.01, HIGHEST_HZ])?,
            sensitivity_v_per_ms2: scale * between(row, sensitivity, [1e-6 / scale, 2.0 / scale])?,
            expanded_uncertainty_rel: between(row, u, [0.01, 20.0])? / 100.0,
        };
        // A point takes what is within 1 % of its frequency: two of that are one too many.
        let near =
            |other: &StandardPoint| (other.frequency_hz / point.frequency_hz - 1.0).abs() <= 0.02;
        if points.iter().any(near) {
            let problem = format!("{} Hz is there twice, or nearly", point.frequency_hz);
            let refused = table
                .source
                .at_line(row.line, problem, "leave one of them in");
            return Err(refused.into());
        }
        points.push(point);
    }
    Ok(points)
}

/// Results as a table.
pub(super) fn text(substitution: &Substitution) -> String {
    let mut table = Table::new(&["f/Hz", "X2/X1", "U of it/%", "mV/(m/s2)", "U/%"]);
    for point in &substitution.points {
        table.row([
            point.frequency_hz.to_string(),
            format!("{:.5}", point.ratio),
            format!("{:.2}", 100.0 * point.expanded_uncertainty_ratio_rel),
            format!("{:.5}", 1000.0 * point.sensitivity_v_per_ms2),
            format!("{:.2}", 100.0 * point.expanded_uncertainty_rel),
        ]);
    }
    format!(
        "\nby substitution of {} (record {standard}), S2 = S1 X2 / X1\n{table}calib certificate {} --substituted {standard}",
        substitution.standard_serial,
        substitution.dut_record_id,
        standard = substitution.standard_record_id,
    )
}
