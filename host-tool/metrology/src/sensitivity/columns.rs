//! The columns of a table of readings, and what each method reads from them.

use super::conversion::Quantity;
use super::reading::{Reading, Values};
use crate::input::{Column, HIGHEST_HZ, Row, Table};
use calib_core::consecutive::Consecutive;
use calib_files::Result;
use num_complex::Complex32;
use std::f32::consts::SQRT_2;

/// Sensitivity above which no accelerometer is known, V/(m/s2): 20 V/g, twice that of the largest seismic ones.
const HIGHEST_V_PER_MS2: f32 = 2.0;

/// Magnitude with the phase beside it, if there is one.
#[derive(Clone, Copy)]
pub(super) struct Polar<'a> {
    magnitude: &'a Column,
    /// Written value times this is the value in V, or V per unit of the quantity.
    scale: f32,
    pub(super) phase: Option<&'a Column>,
}

impl<'a> Polar<'a> {
    fn find(table: &'a Table, magnitude: &str, phase: &str) -> Result<Option<Self>> {
        let phase = table.find(phase)?;
        Ok(table.find(magnitude)?.map(|magnitude| Self {
            magnitude,
            scale: 1.0,
            phase,
        }))
    }

    fn require(table: &'a Table, magnitude: &str, phase: &str) -> Result<Self> {
        Ok(Self {
            magnitude: table.require(magnitude, magnitude)?,
            scale: 1.0,
            phase: table.find(phase)?,
        })
    }

    /// The reference's sensitivity, in the unit its column says.
    fn sensitivity(table: &'a Table) -> Result<Self> {
        let phase = "reference_sensitivity_deg";
        let in_mv = Self::find(table, "reference_sensitivity_mv", phase)?;
        match (in_mv, Self::find(table, "reference_sensitivity_v", phase)?) {
            (Some(polar), _) => Ok(Self {
                scale: 1e-3,
                ..polar
            }),
            (None, Some(polar)) => Ok(polar),
            (None, None) => Self::require(table, "reference_sensitivity", phase),
        }
    }

    fn value(&self, table: &Table, row: &Row) -> Result<Complex32> {
        let magnitude = self.scale * positive(table, row, self.magnitude)?;
        let degrees = match self.phase {
            Some(column) => table.number(row, column)?,
            None => 0.0,
        };
        Ok(Complex32::from_polar(
            magnitude,
            degrees.to_radians() as f32,
        ))
    }
}

fn positive(table: &Table, row: &Row, column: &Column) -> Result<f32> {
    let value = table.number(row, column)? as f32;
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(table.source.at_line(
        row.line,
        format!("{} = {value} is not above zero", column.written),
        "amplitudes, sensitivities and frequencies are positive; a sign is a phase of 180",
    ))
}

/// The columns of each method.
pub(super) struct Columns<'a> {
    frequency: &'a Column,
    pub(super) dut: Polar<'a>,
    method: Method<'a>,
}

enum Method<'a> {
    Comparison {
        reference: Polar<'a>,
        output: Polar<'a>,
    },
    Consecutive {
        reference: Polar<'a>,
        before: Polar<'a>,
        after: Polar<'a>,
    },
    Calibrator {
        amplitude: &'a Column,
        /// The amplitude is stated as this times its r.m.s. value.
        over_rms: f32,
    },
}

/// A column of an amplitude that says whether it is r.m.s. or peak, with its ratio to r.m.s.
fn measured<'a>(table: &'a Table, rms: &str, peak: &str) -> Result<Option<(&'a Column, f32)>> {
    Ok(match (table.find(rms)?, table.find(peak)?) {
        (Some(column), _) => Some((column, 1.0)),
        (None, Some(column)) => Some((column, SQRT_2)),
        (None, None) => None,
    })
}

impl<'a> Columns<'a> {
    pub(super) fn of(table: &'a Table) -> Result<Self> {
        let frequency = table.require("the frequency", "frequency_hz f f_hz")?;
        let before = Polar::find(table, "reference_before_v", "reference_before_deg")?;
        let output = Polar::find(table, "reference_v", "reference_deg")?;
        let method = match (before, output) {
            (Some(before), _) => Method::Consecutive {
                reference: Polar::sensitivity(table)?,
                before,
                after: Polar::require(table, "reference_after_v", "reference_after_deg")?,
            },
            (None, Some(output)) => Method::Comparison {
                reference: Polar::sensitivity(table)?,
                output,
            },
            (None, None) => return Self::of_calibrator(table, frequency),
        };
        Ok(Self {
            frequency,
            dut: Polar::require(table, "dut_v", "dut_deg")?,
            method,
        })
    }

    /// Output and amplitude, where r.m.s. or peak makes 41 %: both have to say which they are.
    fn of_calibrator(table: &'a Table, frequency: &'a Column) -> Result<Self> {
        let amplitude = measured(table, "amplitude_rms", "amplitude_peak")?;
        let dut = measured(table, "dut_rms_v", "dut_peak_v")?;
        let (Some((amplitude, over_rms)), Some((dut, dut_over_rms))) = (amplitude, dut) else {
            return Err(table.source.at_line(
                table.header_line,
                "neither a reference (reference_v, reference_before_v), nor an amplitude and an output that \
                 say whether they are r.m.s. or peak, which differ by 41 %",
                "with a calibrator name the columns amplitude_rms or amplitude_peak, and dut_rms_v or dut_peak_v",
            ));
        };
        Ok(Self {
            frequency,
            dut: Polar {
                magnitude: dut,
                scale: dut_over_rms.recip(),
                phase: table.find("dut_deg")?,
            },
            method: Method::Calibrator {
                amplitude,
                over_rms,
            },
        })
    }

    /// Refuses what a column in another unit than meant looks like.
    pub(super) fn believable(&self, table: &Table, row: &Row, quantity: Quantity) -> Result<()> {
        let hz = positive(table, row, self.frequency)?;
        if f64::from(hz) > HIGHEST_HZ {
            return Err(table.source.at_line(
                row.line,
                format!("{} = {hz}: no exciter reaches it", self.frequency.written),
                "write the frequency in Hz",
            ));
        }
        let (Method::Comparison { reference, .. } | Method::Consecutive { reference, .. }) =
            self.method
        else {
            return Ok(());
        };
        let stated = reference.value(table, row)?.norm();
        let says_its_unit = reference.magnitude.name != "reference_sensitivity";
        if says_its_unit || quantity != Quantity::Acceleration || stated <= HIGHEST_V_PER_MS2 {
            return Ok(());
        }
        Err(table.source.at_line(
            row.line,
            format!(
                "{} = {stated} V/(m/s2) is more than any accelerometer has",
                reference.magnitude.written
            ),
            "name the column reference_sensitivity_mv if it is in mV/(m/s2), reference_sensitivity_v if it is \
             meant so",
        ))
    }

    pub(super) fn all(&self) -> Vec<&Column> {
        let polars = match &self.method {
            Method::Comparison { reference, output } => vec![reference, output],
            Method::Consecutive {
                reference,
                before,
                after,
            } => vec![reference, before, after],
            Method::Calibrator { .. } => Vec::new(),
        };
        let mut all = vec![self.frequency];
        if let Method::Calibrator { amplitude, .. } = self.method {
            all.push(amplitude);
        }
        for polar in polars.into_iter().chain([&self.dut]) {
            all.push(polar.magnitude);
            all.extend(polar.phase);
        }
        all
    }

    pub(super) fn reading(&self, table: &Table, row: &Row) -> Result<Reading> {
        let dut = self.dut.value(table, row)?;
        let values = match &self.method {
            Method::Comparison { reference, output } => Values::Comparison {
                reference: reference.value(table, row)?,
                reference_output: output.value(table, row)?,
                dut,
            },
            Method::Consecutive {
                reference,
                before,
                after,
            } => Values::Consecutive {
                reference: reference.value(table, row)?,
                readings: Consecutive {
                    before: before.value(table, row)?,
                    dut,
                    after: after.value(table, row)?,
                },
            },
            Method::Calibrator {
                amplitude,
                over_rms,
            } => Values::Calibrator {
                amplitude_rms: positive(table, row, amplitude)? / over_rms,
                dut,
            },
        };
        Ok(Reading {
            frequency_hz: positive(table, row, self.frequency)?,
            values,
        })
    }
}
