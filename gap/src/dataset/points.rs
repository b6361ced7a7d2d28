//! `points.csv`: steady-state sine points.

use super::Measured;
use super::range::{Range, columns};
use crate::error::GapError;
use num_complex::Complex64;
use std::collections::HashMap;
use std::io::Read;

const FILE: &str = "points.csv";

/// Largest table that is read: a diagnosis keeps about 30 kB per row, and takes
/// minutes beyond this.
pub(crate) const MOST_ROWS: usize = 10_000;

/// Relative distance at which a ratio and the quotient of its voltages are two different things.
const RATIO_AGREES: f64 = 0.01;

/// A harmonic relative to its fundamental; without a phase column only the amplitude is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Harmonic {
    /// Amplitude over the fundamental's.
    pub(crate) amplitude: f64,
    /// Phase relative to n times the fundamental's phase, in rad.
    pub(crate) phase_rad: Option<f64>,
}

/// One row of `points.csv`; phases in rad, amplitudes r.m.s., absent values `None`.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Point {
    /// Excitation frequency.
    pub(crate) frequency_hz: f64,
    /// Index of the run's label.
    pub(crate) run: usize,
    /// Time since the first point.
    pub(crate) time_s: Option<f64>,
    /// Transducer temperature.
    pub(crate) temperature_c: Option<f64>,
    /// Rotation of the device under test about the axis of motion.
    pub(crate) rotation_rad: Option<f64>,
    /// Angle between the axis of motion and the vertical.
    pub(crate) tilt_rad: Option<f64>,
    /// Mass on the armature.
    pub(crate) payload_kg: Option<f64>,
    /// Level the rig held, r.m.s.
    pub(crate) acceleration_ms2: Option<f64>,
    /// Coil voltage, r.m.s.
    pub(crate) coil_v: Option<f64>,
    /// Coil current, r.m.s.
    pub(crate) coil_a: Option<f64>,
    /// Phase of the current relative to the coil voltage.
    pub(crate) coil_a_rad: Option<f64>,
    /// Reference channel, r.m.s.
    pub(crate) ref_v: Option<f64>,
    /// Phase of the reference channel relative to the coil voltage.
    pub(crate) ref_rad: Option<f64>,
    /// Device under test, r.m.s.
    pub(crate) dut_v: Option<f64>,
    /// Phase of the device under test relative to the reference channel.
    pub(crate) dut_rad: Option<f64>,
    /// Ratio dut/ref, when only that was recorded.
    pub(crate) ratio: Option<f64>,
    /// Harmonics 2..5 of the reference channel.
    pub(crate) ref_harmonics: [Option<Harmonic>; 4],
    /// Harmonics 2..5 of the device under test.
    pub(crate) dut_harmonics: [Option<Harmonic>; 4],
    /// Mean of the reference channel, in V.
    pub(crate) ref_dc_v: Option<f64>,
    /// Mean of the device under test, in V.
    pub(crate) dut_dc_v: Option<f64>,
    /// Noise of the reference channel, r.m.s.
    pub(crate) ref_noise_v: Option<f64>,
    /// Noise of the device under test, r.m.s.
    pub(crate) dut_noise_v: Option<f64>,
    /// Relative standard uncertainty of the ratio.
    pub(crate) u_ratio: Option<f64>,
    /// Standard uncertainty of `dut_rad`.
    pub(crate) u_phase_rad: Option<f64>,
    /// Relative standard uncertainty of ref/coil voltage.
    pub(crate) u_drive: Option<f64>,
    /// Relative standard uncertainty of coil current/voltage.
    pub(crate) u_current: Option<f64>,
    /// Standard uncertainty of the real and the imaginary part of each harmonic.
    pub(crate) u_harmonic: Option<f64>,
    /// Standard uncertainty of the d.c. values.
    pub(crate) u_dc_v: Option<f64>,
}

impl Harmonic {
    /// Complex value, when the phase is known.
    #[must_use]
    pub(crate) fn complex(&self) -> Option<Complex64> {
        self.phase_rad
            .map(|phase| Complex64::from_polar(self.amplitude, phase))
    }
}

/// Reads the table of points.
///
/// # Errors
/// Unknown or duplicate columns, unusable cells, values without their uncertainty, too few or too many rows.
pub(super) fn read(input: impl Read) -> Result<Measured, GapError> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(input);
    let header = reader.headers().map_err(|e| table(e.to_string()))?.clone();
    let layout = Layout::new(&header)?;
    let mut points = Vec::new();
    let mut run_index = HashMap::new();
    let mut used = vec![false; layout.columns.len()];
    let mut row = csv::StringRecord::new();
    while reader
        .read_record(&mut row)
        .map_err(|e| table(e.to_string()))?
    {
        if points.len() == MOST_ROWS {
            return Err(table(format!(
                "more than {MOST_ROWS} rows; average points of the same run and conditions first"
            )));
        }
        let cells = Cells {
            line: row.position().map_or(0, |p| p.line() as usize),
            values: layout.parse(&row, &mut used)?,
        };
        let label = layout
            .run
            .and_then(|at| row.get(at))
            .unwrap_or("")
            .to_owned();
        let next = run_index.len();
        let run = *run_index.entry(label).or_insert(next);
        points.push(cells.point(run)?);
    }
    if points.len() < 2 {
        return Err(table(format!(
            "{} row(s); a diagnosis needs at least two points",
            points.len()
        )));
    }
    let mut columns: Vec<_> = layout
        .columns
        .iter()
        .zip(used)
        .filter(|(_, u)| *u)
        .map(|(c, _)| c.0.clone())
        .collect();
    columns.extend(layout.run.map(|_| "run".to_owned()));
    Ok(Measured::Points { points, columns })
}

struct Layout {
    columns: Vec<(String, Range, usize)>,
    run: Option<usize>,
}

impl Layout {
    fn new(header: &csv::StringRecord) -> Result<Self, GapError> {
        let known = columns();
        let (mut columns, mut run) = (Vec::<(String, Range, usize)>::new(), None);
        for (at, name) in header.iter().enumerate() {
            let name = name.trim_start_matches('\u{feff}');
            if columns.iter().any(|c| c.0 == name) || (name == "run" && run.is_some()) {
                return Err(table(format!("column {name} appears twice")));
            }
            if name == "run" {
                run = Some(at);
            } else if let Some((_, range)) = known.iter().find(|(n, _)| n == name) {
                columns.push((name.to_owned(), *range, at));
            } else {
                let nearest = known
                    .iter()
                    .map(|(n, _)| n)
                    .min_by_key(|n| distance(n, name));
                let hint =
                    nearest.map_or(String::new(), |n| format!("; the nearest known one is {n}"));
                return Err(table(format!("unknown column \"{name}\"{hint}")));
            }
        }
        if !columns.iter().any(|c| c.0 == "frequency_hz") {
            return Err(table(
                "column frequency_hz is missing; it is the one every table needs".into(),
            ));
        }
        Ok(Self { columns, run })
    }

    fn parse<'a>(
        &'a self,
        row: &csv::StringRecord,
        used: &mut [bool],
    ) -> Result<HashMap<&'a str, f64>, GapError> {
        let line = row.position().map_or(0, |p| p.line() as usize);
        let mut values = HashMap::with_capacity(self.columns.len());
        for ((name, range, at), used) in self.columns.iter().zip(used) {
            let text = row.get(*at).unwrap_or("");
            if text.is_empty() {
                continue;
            }
            let cell = |problem: String| GapError::Cell {
                file: FILE,
                line,
                column: name.clone(),
                problem,
            };
            let value: f64 = text.parse().map_err(|_| {
                cell(format!(
                    "\"{text}\" is not a number; the decimal mark is a point"
                ))
            })?;
            if !value.is_finite() {
                return Err(cell(format!(
                    "\"{text}\" is not finite; leave the cell empty if nothing was measured"
                )));
            }
            if let Some(problem) = range.problem(value) {
                return Err(cell(format!(
                    "{text} {problem}; leave the cell empty if nothing was measured"
                )));
            }
            values.insert(name.as_str(), value);
            *used = true;
        }
        Ok(values)
    }
}

struct Cells<'a> {
    line: usize,
    values: HashMap<&'a str, f64>,
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

    fn point(&self, run: usize) -> Result<Point, GapError> {
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
        if (ratio / quotient - 1.0).abs() > RATIO_AGREES {
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

/// Number of characters that differ, for the hint after a misspelt column.
fn distance(a: &str, b: &str) -> usize {
    let common =
        a.chars().filter(|c| b.contains(*c)).count() + b.chars().filter(|c| a.contains(*c)).count();
    (a.len() + b.len()).saturating_sub(common)
}

fn table(problem: String) -> GapError {
    GapError::Table {
        file: FILE,
        problem,
    }
}
