//! Rows of a dataset that a calibrator can repeat.

use super::recorded::Setting;
use crate::{Error, Result};
use calib_core::point::PointSpec;
use calib_twin::dataset::Nominal;
use std::collections::HashMap;
use std::path::Path;

/// Points of one emulated run.
const MOST_POINTS: usize = 24;
/// Conditions that are emulated, those with most rows first.
const MOST_CONDITIONS: usize = 4;

/// Cells of one row, by column.
#[derive(Clone, Debug)]
pub(super) struct Row(HashMap<String, f64>);

impl Row {
    /// The cell of a column.
    pub(super) fn get(&self, column: &str) -> Option<f64> {
        self.0.get(column).copied()
    }

    /// Magnitude of the ratio of device and reference.
    pub(super) fn ratio(&self) -> Option<f64> {
        let quotient = || Some(self.get("dut_v")? / self.get("ref_v")?);
        self.get("ratio").or_else(quotient)
    }

    fn level_ms2(&self) -> Option<f64> {
        self.get("acceleration_ms2")
    }

    /// Request to a calibrator that repeats the point.
    pub(super) fn spec(&self) -> PointSpec {
        PointSpec {
            frequency_hz: self.get("frequency_hz").unwrap_or(0.0) as f32,
            acceleration_rms_ms2: self.level_ms2().unwrap_or(0.0) as f32,
        }
    }

    fn is_like(&self, other: &Self) -> bool {
        let near = |name: &str| match (self.get(name), other.get(name)) {
            (Some(a), Some(b)) => (a / b - 1.0).abs() < 0.01,
            _ => false,
        };
        near("frequency_hz") && near("acceleration_ms2")
    }

    fn setting(&self, nominal: &Nominal) -> Setting {
        let of = |name: &str, usual: f64| self.get(name).unwrap_or(usual);
        Setting {
            run: 0,
            rotation_deg: of("rotation_deg", 0.0),
            tilt_deg: of("tilt_deg", 0.0),
            payload_kg: of("payload_kg", 0.0),
            temperature_c: Some(of(
                "temperature_c",
                nominal.environment.reference_temperature_c,
            )),
        }
    }
}

/// Rows under the same conditions.
#[derive(Clone, Debug)]
pub(super) struct Condition {
    /// The conditions.
    pub(super) setting: Setting,
    /// Time of the first of them, s.
    pub(super) start_s: f64,
    /// The rows, each frequency and level once.
    pub(super) rows: Vec<Row>,
}

impl Condition {
    /// Whether harmonics can be compared.
    pub(super) fn has_harmonics(&self) -> bool {
        self.rows.iter().any(|row| row.get("ref_h2").is_some())
    }
}

/// The rows of the dataset in `folder` that state a level, by condition.
pub(super) fn conditions(folder: &Path, nominal: &Nominal) -> Result<Vec<Condition>> {
    let mut found: Vec<Condition> = Vec::new();
    for row in rows(&folder.join("points.csv"))? {
        if row.level_ms2().is_none() {
            continue;
        }
        let setting = row.setting(nominal);
        match found.iter_mut().find(|c| c.setting == setting) {
            Some(same) if same.rows.iter().any(|other| other.is_like(&row)) => {}
            Some(same) => same.rows.push(row),
            None => found.push(Condition {
                setting,
                start_s: row.get("time_s").unwrap_or(0.0),
                rows: vec![row],
            }),
        }
    }
    if found.is_empty() {
        return Err(Error::input(
            folder.display().to_string(),
            "states no level, so that no calibrator can repeat it",
            "add the column acceleration_ms2, or leave --confirm out",
        ));
    }
    found.sort_by_key(|condition| std::cmp::Reverse(condition.rows.len()));
    found.truncate(MOST_CONDITIONS);
    for condition in &mut found {
        let step = condition.rows.len().div_ceil(MOST_POINTS).max(1);
        let kept = std::mem::take(&mut condition.rows);
        condition.rows = kept.into_iter().step_by(step).collect();
    }
    Ok(found)
}

fn rows(path: &Path) -> Result<Vec<Row>> {
    let unreadable = |e: csv::Error| {
        Error::input(
            path.display().to_string(),
            e.to_string(),
            "docs/gap.md describes the format of a dataset",
        )
    };
    let mut reader = csv::Reader::from_path(path).map_err(unreadable)?;
    let header = reader.headers().map_err(unreadable)?.clone();
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(unreadable)?;
        // The diagnosis has read the table before: what is no number is a label.
        let filled = header.iter().zip(record.iter());
        let cells = filled
            .filter_map(|(name, text)| Some((name.trim().to_owned(), text.trim().parse().ok()?)));
        rows.push(Row(cells.collect()));
    }
    Ok(rows)
}
