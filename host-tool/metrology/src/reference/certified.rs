//! Statements of a certificate about a reference, checked, and as the settings hold it.

use crate::input::{HIGHEST_HZ, Source};
use calib_core::settings::{MAX_REFERENCE_POINTS, ReferenceCalibration, ReferencePoint};
use calib_files::{Error, Result};
use jiff::civil::Date;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::PI;

/// Statements of a certificate about a reference.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Certified {
    /// Serial number.
    pub serial: Option<String>,
    /// Maker and model.
    pub model: Option<String>,
    /// Number of the certificate.
    pub certificate: Option<String>,
    /// Who calibrated.
    pub laboratory: Option<String>,
    /// Day of the calibration.
    #[serde(rename = "calibrated_day", serialize_with = "as_text")]
    #[schemars(with = "Option<String>")]
    pub calibrated: Option<Date>,
    /// Day the next one is due.
    #[serde(rename = "due_day", serialize_with = "as_text")]
    #[schemars(with = "Option<String>")]
    pub due: Option<Date>,
    /// How it is traceable, in words; none where it does not say that it is.
    pub traceability: Option<String>,
    /// Serial numbers of the equipment it was calibrated with.
    pub equipment: Vec<String>,
    /// The table, in rising frequency.
    pub points: Vec<CertifiedPoint>,
}

/// A day as ISO 8601 has it.
fn as_text<S: serde::Serializer>(day: &Option<Date>, serializer: S) -> Result<S::Ok, S::Error> {
    day.map(|day| day.to_string()).serialize(serializer)
}

/// One frequency.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CertifiedPoint {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Relative expanded uncertainty.
    pub expanded_uncertainty_rel: f64,
    /// Its coverage factor.
    pub coverage_factor: f64,
    /// Phase, rad, in JSON degrees; none where the certificate has none.
    #[serde(
        rename = "phase_deg",
        serialize_with = "calib_output::number::maybe_rad_as_deg"
    )]
    pub phase_rad: Option<f64>,
    /// Expanded uncertainty of the phase, rad; in JSON degrees.
    #[serde(
        rename = "expanded_uncertainty_phase_deg",
        serialize_with = "calib_output::number::maybe_rad_as_deg"
    )]
    pub expanded_uncertainty_phase_rad: Option<f64>,
    /// Its coverage factor.
    pub coverage_factor_phase: Option<f64>,
}

/// How a file is to be read.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// Only results of a DCC whose name holds this.
    pub result: Option<String>,
    /// Sensitivity at the reference frequency, V/(m/s2), for a table of deviations.
    pub sensitivity_v_per_ms2: Option<f64>,
}

/// Coverage factor of every uncertainty in the settings.
const K: f64 = 2.0;
pub(super) const STANDARD_GRAVITY_MS2: f64 = 9.806_65;
pub(super) const RAD_PER_DEGREE: f64 = PI / 180.0;
/// U of a phase of which nothing is known, rad.
const UNKNOWN_PHASE_RAD: f64 = PI;

/// A number of a table with the line it stood in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placed {
    pub(super) value: f64,
    pub(super) line: usize,
}

/// Refuses a point in which something is wrong.
fn check(source: &Source, point: &CertifiedPoint, line: usize) -> Result<()> {
    let at = |problem: String, hint: &str| Err(source.at_line(line, problem, hint));
    let hz = point.frequency_hz;
    if !(hz > 0.0 && hz <= HIGHEST_HZ) {
        return at(
            format!("{hz} Hz is no frequency of a calibration"),
            "the unit of the frequencies is hertz",
        );
    }
    if !(1e-7..=1e3).contains(&point.sensitivity_v_per_ms2) {
        return at(
            format!(
                "{hz} Hz: {} V/(m/s2) is no sensitivity",
                point.sensitivity_v_per_ms2
            ),
            "1e-7 to 1000 V/(m/s2); the unit stands in the file",
        );
    }
    let factors = [Some(point.coverage_factor), point.coverage_factor_phase];
    if let Some(k) = factors
        .into_iter()
        .flatten()
        .find(|k| !(1.0..=14.0).contains(k))
    {
        return at(
            format!("{hz} Hz: {k} is no coverage factor: they lie between 1 and 14"),
            "k = 2 covers about 95 % of a normal distribution",
        );
    }
    if !(1e-6..=0.5).contains(&point.expanded_uncertainty_rel) {
        let percent = 100.0 * point.expanded_uncertainty_rel;
        return at(
            format!("{hz} Hz: U = {percent} % is none of a reference"),
            "0.0001 % to 50 %; a U in percent needs a unit or a column that says so",
        );
    }
    let phase = point.phase_rad.zip(point.expanded_uncertainty_phase_rad);
    match phase {
        Some((phase, u)) if phase.abs() > 2.0 * PI || !(1e-6..=PI).contains(&u) => at(
            format!("{hz} Hz: phase {phase} rad with U = {u} rad cannot be"),
            "phases in degrees need a unit or a column that says so",
        ),
        _ => Ok(()),
    }
}

/// Checks every point, and that the frequencies rise; `lines` are where they stand.
pub(super) fn checked(source: &Source, points: &[CertifiedPoint], lines: &[usize]) -> Result<()> {
    let mut last_hz = 0.0;
    for (point, line) in points.iter().zip(lines) {
        check(source, point, *line)?;
        if point.frequency_hz <= last_hz {
            let hint =
                "of several levels or results keep one; of a DCC --result NAME reads one alone";
            return Err(not_rising(
                source,
                *line,
                [last_hz, point.frequency_hz],
                hint,
            ));
        }
        last_hz = point.frequency_hz;
    }
    Ok(())
}

pub(super) fn not_rising(
    source: &Source,
    line: usize,
    [before_hz, hz]: [f64; 2],
    hint: &str,
) -> Error {
    let problem = format!("{hz} Hz after {before_hz} Hz: frequencies rise, and each is there once");
    source.at_line(line, problem, hint)
}

impl Certified {
    /// As the settings hold it: uncertainties with k = 2, the phase within half a turn. Where the certificate has
    /// no phase and `without_phase` says that this is known, it is nothing with an uncertainty of half a turn.
    ///
    /// # Errors
    /// [`Error::Input`] when serial number, certificate or day of calibration are not stated, the table is too
    /// long, or a phase is missing.
    pub fn calibration(&self, place: &str, without_phase: bool) -> Result<ReferenceCalibration> {
        let rows = self
            .points
            .iter()
            .map(|point| row(point, place, without_phase));
        let rows: Vec<ReferencePoint> = rows.collect::<Result<_>>()?;
        let count = rows.len();
        let points = heapless::Vec::from_slice(&rows).map_err(|_| {
            Error::input(
                place,
                format!("{count} frequencies: the instrument holds {MAX_REFERENCE_POINTS}"),
                "leave some out where the response is smooth: between rows it is interpolated, with the error of that \
                 in the budget",
            )
        })?;
        let day = |date: Option<Date>| {
            date.map_or(0, |date| {
                let days = (date - jiff::civil::date(1970, 1, 1)).get_days();
                u32::try_from(days).unwrap_or(0)
            })
        };
        if self.calibrated.is_none() {
            return Err(unstated(
                place,
                "the day of calibration",
                "--calibrated 2026-11-20",
            ));
        }
        Ok(ReferenceCalibration {
            serial: short(
                place,
                "the serial number",
                "--serial",
                self.serial.as_deref(),
            )?,
            certificate: short(
                place,
                "the number of the certificate",
                "--certificate",
                self.certificate_named().as_deref(),
            )?,
            calibrated_day: day(self.calibrated),
            due_day: day(self.due),
            points,
        })
    }

    /// Number of the certificate, with who issued it where there is room for both.
    fn certificate_named(&self) -> Option<String> {
        let number = self.certificate.clone()?;
        let both = self
            .laboratory
            .as_ref()
            .map(|laboratory| format!("{number}, {laboratory}"));
        Some(both.filter(|both| both.len() <= 48).unwrap_or(number))
    }
}

fn unstated(place: &str, what: &str, option: &str) -> Error {
    Error::input(
        place,
        format!("does not say {what}"),
        format!("state it with {option}"),
    )
}

/// A text that the settings have room for.
fn short<const N: usize>(
    place: &str,
    what: &str,
    option: &str,
    text: Option<&str>,
) -> Result<heapless::String<N>> {
    let text = text.map(str::trim).filter(|text| !text.is_empty());
    let text = text.ok_or_else(|| unstated(place, what, &format!("{option} TEXT")))?;
    if text.contains(char::is_control) {
        return Err(Error::input(
            place,
            format!("{what} holds control characters"),
            format!("state it with {option} TEXT"),
        ));
    }
    heapless::String::try_from(text).map_err(|_| {
        Error::input(
            place,
            format!("{what} is longer than {N} bytes: {text}"),
            format!("shorten it with {option} TEXT"),
        )
    })
}

fn row(point: &CertifiedPoint, place: &str, without_phase: bool) -> Result<ReferencePoint> {
    let phase = point.phase_rad.zip(point.expanded_uncertainty_phase_rad);
    let (phase_rad, u_phase_rad) = match phase {
        Some((phase, u)) => (phase, u * K / point.coverage_factor_phase.unwrap_or(K)),
        None if without_phase => (0.0, UNKNOWN_PHASE_RAD),
        None => {
            return Err(Error::input(
                place,
                format!("has no phase at {} Hz", point.frequency_hz),
                "--without-phase takes it without: phases of results then have U = 180 degrees",
            ));
        }
    };
    Ok(ReferencePoint {
        frequency_hz: point.frequency_hz as f32,
        sensitivity_v_per_ms2: point.sensitivity_v_per_ms2 as f32,
        phase_rad: (phase_rad - 2.0 * PI * (phase_rad / (2.0 * PI)).round()) as f32,
        expanded_uncertainty_rel: (point.expanded_uncertainty_rel * K / point.coverage_factor)
            as f32,
        expanded_uncertainty_phase_rad: u_phase_rad as f32,
    })
}
