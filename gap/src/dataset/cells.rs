//! The values of a row as a point, and whether they can be one.

use super::layout::FILE;
use super::point::{Harmonic, Point};
use crate::error::GapError;
use crate::thresholds;
use std::collections::HashMap;

/// Values of one row by column.
pub(super) struct Cells<'a> {
    pub(super) line: usize,
    pub(super) values: HashMap<&'a str, f64>,
}

impl Cells<'_> {
    fn get(&self, name: &str) -> Option<f64> {
        self.values.get(name).copied()
    }

    fn radians(&self, name: &str) -> Option<f64> {
        self.get(name).map(f64::to_radians)
    }

    fn unusable(&self, column: &str, problem: String) -> GapError {
        GapError::Cell {
            file: FILE,
            line: self.line,
            column: column.into(),
            problem,
        }
    }

    fn harmonics(&self, channel: &str) -> [Option<Harmonic>; 4] {
        std::array::from_fn(|k| {
            let amplitude = self.get(&format!("{channel}_h{}", k + 2))?;
            Some(Harmonic {
                amplitude,
                phase_rad: self.radians(&format!("{channel}_h{}_deg", k + 2)),
            })
        })
    }

    /// The point of a row.
    ///
    /// # Errors
    /// No frequency, values without their uncertainty or amplitude, a ratio stated twice that differs.
    pub(super) fn point(&self, run: usize) -> Result<Point, GapError> {
        let frequency_hz = self
            .get("frequency_hz")
            .ok_or_else(|| self.unusable("frequency_hz", "every row needs a frequency".into()))?;
        let point = Point {
            frequency_hz,
            run,
            time_s: self.get("time_s"),
            temperature_c: self.get("temperature_c"),
            rotation_rad: self.radians("rotation_deg"),
            tilt_rad: self.radians("tilt_deg"),
            payload_kg: self.get("payload_kg"),
            acceleration_ms2: self.get("acceleration_ms2"),
            coil_v: self.get("coil_v"),
            coil_a: self.get("coil_a"),
            coil_a_rad: self.radians("coil_a_deg"),
            ref_v: self.get("ref_v"),
            ref_rad: self.radians("ref_deg"),
            dut_v: self.get("dut_v"),
            dut_rad: self.radians("dut_deg"),
            ratio: self.get("ratio"),
            ref_harmonics: self.harmonics("ref"),
            dut_harmonics: self.harmonics("dut"),
            ref_dc_v: self.get("ref_dc_v"),
            dut_dc_v: self.get("dut_dc_v"),
            ref_noise_v: self.get("ref_noise_v"),
            dut_noise_v: self.get("dut_noise_v"),
            u_ratio: self.get("u_ratio"),
            u_phase_rad: self.radians("u_phase_deg"),
            u_drive: self.get("u_drive"),
            u_current: self.get("u_current"),
            u_harmonic: self.get("u_harmonic"),
            u_dc_v: self.get("u_dc_v"),
        };
        self.check_uncertainties(&point)?;
        self.check_phases()?;
        self.check_ratio(&point)?;
        Ok(point)
    }

    /// The phase of a harmonic says nothing without its amplitude, and nothing is dropped in silence.
    fn check_phases(&self) -> Result<(), GapError> {
        for column in ["ref", "dut"]
            .into_iter()
            .flat_map(|channel| (2..=5).map(move |order| format!("{channel}_h{order}")))
        {
            let phase = format!("{column}_deg");
            if self.get(&phase).is_some() && self.get(&column).is_none() {
                return Err(self.unusable(
                    &phase,
                    format!("is given without its amplitude; fill in {column} or leave both empty"),
                ));
            }
        }
        Ok(())
    }

    /// A ratio stated twice must be one ratio.
    fn check_ratio(&self, p: &Point) -> Result<(), GapError> {
        let (Some(ratio), Some(dut_v), Some(ref_v)) = (p.ratio, p.dut_v, p.ref_v) else {
            return Ok(());
        };
        let quotient = dut_v / ref_v;
        if (ratio / quotient - 1.0).abs() > thresholds::RATIO_AGREES {
            return Err(self.unusable(
                "ratio",
                format!("{ratio} contradicts dut_v/ref_v = {quotient:.6}; give one of the two"),
            ));
        }
        Ok(())
    }

    /// A value that takes part must say how good it is.
    fn check_uncertainties(&self, p: &Point) -> Result<(), GapError> {
        let harmonics = p
            .ref_harmonics
            .iter()
            .chain(&p.dut_harmonics)
            .any(Option::is_some);
        let pairs = [
            (
                "u_ratio",
                p.u_ratio,
                "the ratio",
                p.ratio.is_some() || (p.dut_v.is_some() && p.ref_v.is_some()),
            ),
            ("u_phase_deg", p.u_phase_rad, "dut_deg", p.dut_rad.is_some()),
            (
                "u_drive",
                p.u_drive,
                "ref_v/coil_v",
                p.coil_v.is_some() && p.ref_v.is_some() || p.ref_rad.is_some(),
            ),
            (
                "u_current",
                p.u_current,
                "coil_a/coil_v",
                p.coil_a.is_some() && p.coil_v.is_some(),
            ),
            ("u_harmonic", p.u_harmonic, "the harmonics", harmonics),
            (
                "u_dc_v",
                p.u_dc_v,
                "the d.c. values",
                p.ref_dc_v.is_some() || p.dut_dc_v.is_some(),
            ),
        ];
        for (column, uncertainty, of, needed) in pairs {
            if needed && uncertainty.is_none() {
                return Err(self.unusable(
                    column,
                    format!("{of} is given without its standard uncertainty; fill in {column}"),
                ));
            }
        }
        Ok(())
    }
}
