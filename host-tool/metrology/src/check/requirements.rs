//! Rows of Tables 1 to 6, each with the worst value the record holds.

use super::linearity;
use super::rows::{PER_POINT, Row, Side, percent};
use calib_core::budget::Component;
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_core::requirements::{
    Environment, Instruments, ReferenceTransducer, SingleVoltmeter, VibrationGeneration,
    transverse_at,
};
use calib_core::settings::Example;
use calib_protocol::record::Record;
use schemars::JsonSchema;
use serde::Serialize;

/// Outcome of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Every point fulfils it.
    Pass,
    /// At least one point does not.
    Fail,
    /// The record does not hold the quantity.
    NotMeasured,
}

/// Where a value comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Basis {
    /// Measured at the points of the record.
    Measured,
    /// Stated in the settings or labels of the record.
    Stated,
}

/// One row of a table, judged.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Requirement {
    /// Table or clause of ISO 16063-21.
    pub table: &'static str,
    /// Required parameter.
    pub parameter: &'static str,
    /// Unit of limit and value.
    pub unit: &'static str,
    /// Limit that applies where the worst value was found.
    pub limit: Option<f64>,
    /// Worst value.
    pub worst: Option<f64>,
    /// Frequency it was found at, Hz.
    pub at_hz: Option<f64>,
    /// Where the value comes from; none when there is none.
    pub basis: Option<Basis>,
    /// Outcome.
    pub outcome: Outcome,
}

impl Requirement {
    /// A row without a value.
    fn open(table: &'static str, parameter: &'static str, unit: &'static str, limit: f64) -> Self {
        Self {
            table,
            parameter,
            unit,
            limit: Some(limit),
            worst: None,
            at_hz: None,
            basis: None,
            outcome: Outcome::NotMeasured,
        }
    }

    /// Adds a value, which must not exceed the limit.
    fn holding(mut self, value: Option<f64>, at_hz: Option<f64>, basis: Basis) -> Self {
        let (Some(value), Some(limit)) = (value, self.limit) else {
            return self;
        };
        self.worst = Some(value);
        self.at_hz = at_hz;
        self.basis = Some(basis);
        self.outcome = match Side::AtMost.fulfilled(value, limit) {
            true => Outcome::Pass,
            false => Outcome::Fail,
        };
        self
    }
}

/// Every row with its worst point; a refused point has no valid numbers.
pub fn requirements(record: &Record, example: Example) -> Vec<Requirement> {
    let points: Vec<&PointResult> = record
        .points
        .iter()
        .filter(|point| point.state == PointState::Valid)
        .collect();
    let mut rows: Vec<Requirement> = PER_POINT
        .iter()
        .map(|row| worst(row, record, example, &points))
        .collect();
    rows.extend(generation_rows(example));
    rows.extend(surroundings_rows(record, example));
    rows.extend(instrument_rows(record, example, &points));
    rows.sort_by_key(|row| row.table);
    rows
}

fn worst(row: &Row, record: &Record, example: Example, points: &[&PointResult]) -> Requirement {
    let found = points
        .iter()
        .filter_map(|point| {
            let (value, limit) = (row.judge)(record, example, point)?;
            Some((value, limit, f64::from(point.spec.frequency_hz)))
        })
        .max_by(|a, b| {
            let excess = |one: &(f64, f64, f64)| row.side.excess(one.0, one.1);
            excess(a).total_cmp(&excess(b))
        });
    let outcome = match found {
        None => Outcome::NotMeasured,
        Some((value, limit, _)) if row.side.fulfilled(value, limit) => Outcome::Pass,
        Some(_) => Outcome::Fail,
    };
    Requirement {
        table: row.table,
        parameter: row.parameter,
        unit: row.unit,
        limit: found.map(|(_, limit, _)| limit),
        worst: found.map(|(value, ..)| value),
        at_hz: found.map(|(.., at_hz)| at_hz),
        basis: found.map(|_| Basis::Measured),
        outcome,
    }
}

/// Rows of Table 2 that belong to the qualification of the exciter.
fn generation_rows(example: Example) -> [Requirement; 3] {
    let stability = VibrationGeneration::of(example).frequency_stability_rel;
    let transverse = |parameter, frequency_hz| {
        Requirement::open("2", parameter, "%", percent(transverse_at(frequency_hz)))
    };
    [
        Requirement::open("2", "frequency stability", "%", percent(stability)),
        transverse("transverse, to 1 kHz", 1_000.0),
        transverse("transverse, above 1 kHz", 10_000.0),
    ]
}

/// Clauses 4.2 and 4.3: room, and the reference at its reference frequency.
fn surroundings_rows(record: &Record, example: Example) -> Vec<Requirement> {
    let environment = Environment::of(example);
    let reference = ReferenceTransducer::of(example);
    let from_23 = record
        .head
        .labels
        .temperature_centi_c
        .map(|hundredths| (f64::from(hundredths) / 100.0 - 23.0).abs());
    let at_160 = record.settings.reference.points.iter().min_by(|a, b| {
        let distance = |f: f32| (f / 160.0).ln().abs();
        distance(a.frequency_hz).total_cmp(&distance(b.frequency_hz))
    });
    let at_hz = at_160.map(|point| f64::from(point.frequency_hz));
    let magnitude = at_160.map(|point| percent(point.expanded_uncertainty_rel));
    let phase = at_160.map(|point| f64::from(point.expanded_uncertainty_phase_rad).to_degrees());
    let temperature_limit = f64::from(environment.temperature_half_width_c);
    let phase_limit = f64::from(reference.expanded_uncertainty_phase_deg);
    vec![
        Requirement::open("4.2", "temperature, from 23", "degC", temperature_limit).holding(
            from_23,
            None,
            Basis::Stated,
        ),
        Requirement::open(
            "4.2",
            "relative humidity",
            "%",
            percent(environment.humidity),
        ),
        Requirement::open(
            "4.3",
            "reference, U",
            "%",
            percent(reference.expanded_uncertainty_rel),
        )
        .holding(magnitude, at_hz, Basis::Stated),
        Requirement::open("4.3", "reference, U of phase", "deg", phase_limit).holding(
            phase,
            at_hz,
            Basis::Stated,
        ),
        Requirement::open("4.3", "reference, days overdue", "d", 0.0).holding(
            days_overdue(record),
            None,
            Basis::Stated,
        ),
    ]
}

/// Days from the day the reference's calibration was due to that of the run, negative before it; none
/// where one of the two is not known.
fn days_overdue(record: &Record) -> Option<f64> {
    const DAY_S: u64 = 86_400;
    let (due, run_s) = (
        record.settings.reference.due_day,
        record.head.labels.unix_time_s,
    );
    let known = due > 0 && run_s > 0;
    known.then(|| (run_s / DAY_S) as f64 - f64::from(due))
}

/// Tables 3 to 6: linearity from a linearity list, the others as the budget of
/// the settings states them (row 3 of Tables A.1 and A.2, k = 2).
fn instrument_rows(record: &Record, example: Example, points: &[&PointResult]) -> Vec<Requirement> {
    let voltmeter = SingleVoltmeter::of(example);
    let instruments = Instruments::of(example);
    let linearity = linearity::worst(points);
    let ratio = record.settings.influences.iter().find(|line| line.row == 3);
    let expanded = |value: f32| {
        ratio.map(|line| {
            let row = calib_core::budget::Row::a1(3);
            2.0 * f64::from(Component::new(row, value, line.distribution).contribution())
        })
    };
    let ratio_percent = ratio
        .and_then(|line| expanded(line.value_rel))
        .map(|u| 100.0 * u);
    let phase_deg = ratio
        .and_then(|line| expanded(line.value_phase_rad))
        .map(f64::to_degrees);
    let phase_limit = f64::from(instruments.phase_deg);
    vec![
        Requirement::open(
            "3",
            "voltage linearity",
            "%",
            percent(voltmeter.linearity_rel),
        )
        .holding(
            linearity.map(|found| 100.0 * found.deviation_rel),
            linearity.map(|found| found.frequency_hz),
            Basis::Measured,
        ),
        Requirement::open(
            "3",
            "reference before and after",
            "%",
            percent(voltmeter.repeat_rel),
        ),
        Requirement::open("4", "voltage ratio, U", "%", percent(instruments.ratio_rel)).holding(
            ratio_percent,
            None,
            Basis::Stated,
        ),
        Requirement::open(
            "5",
            "distortion, of reading",
            "%",
            percent(instruments.distortion_of_reading_rel),
        ),
        Requirement::open("6", "phase measurement, U", "deg", phase_limit).holding(
            phase_deg,
            None,
            Basis::Stated,
        ),
    ]
}
