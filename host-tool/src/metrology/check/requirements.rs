//! Rows of Tables 1 to 6, each with the worst point of the record.

use calib_core::point::PointResult;
use calib_core::requirements::VibrationGeneration;
use calib_core::settings::Example;
use calib_core::verdict::Verdict;
use calib_protocol::record::Record;
use serde::Serialize;

/// Outcome of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Every point fulfils it.
    Pass,
    /// At least one point does not.
    Fail,
    /// The record does not hold the quantity.
    NotMeasured,
}

/// One row of a table, judged.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Requirement {
    /// Table of ISO 16063-21.
    pub table: &'static str,
    /// What is required.
    pub parameter: &'static str,
    /// Unit of limit and value.
    pub unit: &'static str,
    /// Limit that applies where the worst value was found.
    pub limit: Option<f64>,
    /// Worst value measured.
    pub worst: Option<f64>,
    /// Frequency it was measured at, Hz.
    pub at_hz: Option<f64>,
    /// Outcome.
    pub outcome: Outcome,
}

/// Whether values must stay below or above their limit.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    AtMost,
    AtLeast,
}

/// Judges the points that passed; a refused point has no valid numbers.
pub fn requirements(record: &Record, example: Example) -> Vec<Requirement> {
    let points: Vec<&PointResult> = record
        .points
        .iter()
        .filter(|point| point.verdict == Verdict::Pass)
        .collect();
    let first = example == Example::Example1;
    let pick = |one: f64, two: f64| if first { one } else { two };
    let table2 = VibrationGeneration::of(example);
    let rate = record.sample_rate_hz;
    let row = |table, parameter, unit, side, judge: &dyn Fn(&PointResult) -> (f64, f64)| {
        worst(table, parameter, unit, side, &points, judge)
    };
    let percent = |value: f32| 100.0 * f64::from(value);
    let mut rows = vec![
        row("1", "U of the magnitude", "%", Side::AtMost, &|p| {
            (
                percent(p.expanded_uncertainty_rel),
                magnitude_limit(p.spec.frequency_hz, first),
            )
        }),
        row("1", "U of the phase", "deg", Side::AtMost, &|p| {
            (
                f64::from(p.expanded_uncertainty_phase_rad).to_degrees(),
                phase_limit(record, p.spec.frequency_hz, first),
            )
        }),
        row("2", "frequency uncertainty", "%", Side::AtMost, &|p| {
            let nominal = p.spec.frequency_hz;
            let off = f64::from(p.tone.frequency_hz(rate)) / f64::from(nominal) - 1.0;
            (100.0 * off.abs(), percent(table2.frequency_rel))
        }),
        row("2", "amplitude stability", "%", Side::AtMost, &|p| {
            (
                percent(p.amplitude_stability_rel),
                percent(table2.amplitude_stability_rel),
            )
        }),
        row("2", "total harmonic distortion", "%", Side::AtMost, &|p| {
            (
                percent(p.distortion_reference_rel),
                percent(table2.distortion_at(p.spec.frequency_hz)),
            )
        }),
        row(
            "2",
            "hum and noise below signal",
            "dB",
            Side::AtLeast,
            &|p| {
                (
                    f64::from(p.signal_to_noise_reference_db),
                    f64::from(table2.noise_at(p.spec.frequency_hz)),
                )
            },
        ),
    ];
    rows.insert(2, reference_row(record, pick(0.5, 2.0)));
    rows.extend(not_measured(&pick));
    rows
}

/// Table 1, magnitude of accelerometers, percent.
fn magnitude_limit(frequency_hz: f32, first: bool) -> f64 {
    match (frequency_hz, first) {
        (f, true) if f <= 1000.0 => 1.0,
        (f, true) if f <= 2000.0 => 2.0,
        (_, true) => 3.0,
        (f, false) if f <= 1000.0 => 3.0,
        (f, false) if f <= 2000.0 => 5.0,
        (_, false) => 10.0,
    }
}

/// Table 1, phase, degrees: tighter where the reference was calibrated.
fn phase_limit(record: &Record, frequency_hz: f32, first: bool) -> f64 {
    let at_reference = record
        .settings
        .reference
        .points
        .iter()
        .any(|point| (point.frequency_hz / frequency_hz - 1.0).abs() < 1.0e-3);
    match (at_reference, first) {
        (true, true) => 1.0,
        (true, false) => 3.0,
        (false, true) => 2.5,
        (false, false) => 5.0,
    }
}

/// 4.3: uncertainty of the reference at its own reference frequency.
fn reference_row(record: &Record, limit: f64) -> Requirement {
    let reference = record.settings.reference.points.iter().min_by(|a, b| {
        let distance = |f: f32| (f / 160.0).ln().abs();
        distance(a.frequency_hz).total_cmp(&distance(b.frequency_hz))
    });
    let worst = reference.map(|point| 100.0 * f64::from(point.expanded_uncertainty_rel));
    Requirement {
        table: "4.3",
        parameter: "reference transducer, k = 2",
        unit: "%",
        limit: Some(limit),
        worst,
        at_hz: reference.map(|point| f64::from(point.frequency_hz)),
        outcome: match worst {
            None => Outcome::NotMeasured,
            Some(worst) if worst <= limit => Outcome::Pass,
            Some(_) => Outcome::Fail,
        },
    }
}

fn worst(
    table: &'static str,
    parameter: &'static str,
    unit: &'static str,
    side: Side,
    points: &[&PointResult],
    judge: &dyn Fn(&PointResult) -> (f64, f64),
) -> Requirement {
    // The excess over the limit in its own direction; NaN counts as worst.
    let excess = |value: f64, limit: f64| match side {
        Side::AtMost => value / limit,
        Side::AtLeast => limit - value,
    };
    let found = points
        .iter()
        .map(|point| (judge(point), f64::from(point.spec.frequency_hz)))
        .max_by(|(a, _), (b, _)| excess(a.0, a.1).total_cmp(&excess(b.0, b.1)));
    let Some(((value, limit), at_hz)) = found else {
        return Requirement {
            table,
            parameter,
            unit,
            limit: None,
            worst: None,
            at_hz: None,
            outcome: Outcome::NotMeasured,
        };
    };
    let fulfilled = match side {
        Side::AtMost => value <= limit * (1.0 + 1.0e-6),
        Side::AtLeast => value >= limit - 1.0e-3,
    };
    Requirement {
        table,
        parameter,
        unit,
        limit: Some(limit),
        worst: Some(value),
        at_hz: Some(at_hz),
        outcome: if fulfilled {
            Outcome::Pass
        } else {
            Outcome::Fail
        },
    }
}

/// Rows a record cannot answer: they belong to the rig's own qualification.
fn not_measured(pick: &dyn Fn(f64, f64) -> f64) -> Vec<Requirement> {
    [
        ("2", "frequency stability", "%", pick(0.1, 0.2)),
        ("2", "transverse, rocking motion", "%", 10.0),
        ("3", "voltage linearity", "%", pick(0.1, 0.3)),
        ("3", "reference before and after", "%", pick(0.1, 0.3)),
        ("4", "voltage ratio", "%", pick(0.2, 0.5)),
        ("5", "distortion measurement", "%", 10.0),
        ("6", "phase measurement", "deg", pick(0.2, 0.5)),
    ]
    .into_iter()
    .map(|(table, parameter, unit, limit)| Requirement {
        table,
        parameter,
        unit,
        limit: Some(limit),
        worst: None,
        at_hz: None,
        outcome: Outcome::NotMeasured,
    })
    .collect()
}
