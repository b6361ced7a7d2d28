//! Several mountings of one device as one result.
//!
//! # Equation
//! Mean of `n` mountings, and `s / sqrt(n)` with `n - 1` degrees of freedom of it, as a contribution to row 8 of
//! Table A.1 beside what the settings say of torque, cable and mass: mountings by one hand do not show these.
//! Angles are averaged on the circle.
//!
//! # Source
//! ISO 16063-21:2003, 5.2; GUM 4.2.

use super::model::{Certificate, Entry, Value};
use calib_core::point::{PointResult, PointSpec};
use calib_core::point_state::PointState;
use calib_files::{Error, Result};
use calib_protocol::record::Record;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Scatter between the mountings of a point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MountingScatter {
    /// Nominal frequency, Hz.
    pub frequency_hz: f32,
    /// Set acceleration, m/s2 r.m.s.
    pub set_acceleration_rms_ms2: f32,
    /// Mountings.
    pub mountings: usize,
    /// Mean of the magnitude, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Mean of the phase, degrees.
    pub phase_deg: f64,
    /// Relative experimental standard deviation of one mounting.
    pub scatter_rel: f64,
    /// Scatter of the phase, degrees.
    pub scatter_phase_deg: f64,
    /// Relative standard uncertainty of the mean.
    pub standard_uncertainty_rel: f64,
    /// Standard uncertainty of the mean phase, degrees.
    pub standard_uncertainty_phase_deg: f64,
    /// Degrees of freedom of both.
    pub degrees_of_freedom: f64,
}

/// Scatter of every point that is valid in all runs, in the order of the first; empty for a single run.
pub fn scatter(runs: &[&[PointResult]]) -> Vec<MountingScatter> {
    let Some((first, others)) = runs.split_first().filter(|(_, others)| !others.is_empty()) else {
        return Vec::new();
    };
    let of_all = |point: &PointResult| {
        let same = others.iter().map(|run| twin(run, &point.spec));
        let all: Option<Vec<&PointResult>> = std::iter::once(Some(point)).chain(same).collect();
        let all = all.filter(|all| all.iter().all(|p| p.state == PointState::Valid))?;
        Some(of_point(&all))
    };
    first.iter().filter_map(of_all).collect()
}

fn twin<'a>(run: &'a [PointResult], spec: &PointSpec) -> Option<&'a PointResult> {
    run.iter().find(|point| point.spec == *spec)
}

/// Of one point, measured at least twice.
fn of_point(all: &[&PointResult]) -> MountingScatter {
    let n = all.len() as f64;
    let magnitudes: Vec<f64> = all
        .iter()
        .map(|p| f64::from(p.sensitivity_v_per_ms2))
        .collect();
    // Around the first, so that half a turn has no two sides.
    let first_rad = f64::from(all[0].phase_rad);
    let turns = |angle: f64| angle - TAU * (angle / TAU).round();
    let phases: Vec<f64> = all
        .iter()
        .map(|p| turns(f64::from(p.phase_rad) - first_rad))
        .collect();
    let (mean, deviation) = mean_and_deviation(&magnitudes);
    let (mean_rad, deviation_rad) = mean_and_deviation(&phases);
    MountingScatter {
        frequency_hz: all[0].spec.frequency_hz,
        set_acceleration_rms_ms2: all[0].spec.acceleration_rms_ms2,
        mountings: all.len(),
        sensitivity_v_per_ms2: mean,
        phase_deg: turns(first_rad + mean_rad).clamp(-PI, PI).to_degrees(),
        scatter_rel: deviation / mean,
        scatter_phase_deg: deviation_rad.to_degrees(),
        standard_uncertainty_rel: deviation / mean / n.sqrt(),
        standard_uncertainty_phase_deg: deviation_rad.to_degrees() / n.sqrt(),
        degrees_of_freedom: n - 1.0,
    }
}

/// Arithmetic mean and experimental standard deviation.
fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (mean, (squares / (n - 1.0)).sqrt())
}

/// Records of one device, mounted again for each.
pub(super) struct Mountings {
    /// Running numbers of the records.
    numbers: Vec<u32>,
    scatter: Vec<MountingScatter>,
}

impl Mountings {
    /// A single one.
    pub(super) const ONCE: Self = Self {
        numbers: Vec::new(),
        scatter: Vec::new(),
    };

    /// The record with the means of all mountings, refused where one of them was.
    ///
    /// # Errors
    /// [`Error::Input`] when the records are not of one device, instrument, list and settings.
    pub(super) fn join(record: &Record, others: &[Record]) -> Result<(Record, Self)> {
        let mut joined = record.clone();
        let mut numbers = vec![record.head.id];
        for other in others {
            belongs(record, other, &numbers)?;
            numbers.push(other.head.id);
        }
        let mut runs: Vec<&[PointResult]> = vec![&record.points];
        runs.extend(others.iter().map(|other| &other.points[..]));
        let mountings = Self {
            scatter: scatter(&runs),
            numbers,
        };
        for point in &mut joined.points {
            let refused = others.iter().find_map(|other| {
                let twin = twin(&other.points, &point.spec)?;
                (twin.state != PointState::Valid).then_some(twin.state)
            });
            if let (PointState::Valid, Some(other)) = (point.state, refused) {
                point.state = other;
            }
            if let Some(mean) = mountings.of(&point.spec) {
                point.sensitivity_v_per_ms2 = mean.sensitivity_v_per_ms2 as f32;
                point.phase_rad = mean.phase_deg.to_radians() as f32;
            }
        }
        Ok((joined, mountings))
    }

    /// Scatter at a point; none where it was mounted once.
    pub(super) fn of(&self, spec: &PointSpec) -> Option<&MountingScatter> {
        let same = |found: &&MountingScatter| {
            found.frequency_hz == spec.frequency_hz
                && found.set_acceleration_rms_ms2 == spec.acceleration_rms_ms2
        };
        self.scatter.iter().find(same)
    }

    /// True when it was mounted more than once.
    pub(super) fn are_repeated(&self) -> bool {
        self.numbers.len() > 1
    }

    /// Says among the statements on mounting whether it was repeated.
    pub(super) fn state(&self, certificate: &mut Certificate) {
        let value = match self.are_repeated() {
            false => Value::Phrase("mounting.once".to_owned(), vec![]),
            true => {
                let count = Value::Number(self.numbers.len() as f64, 0, "");
                let numbers: Vec<String> = self.numbers.iter().map(u32::to_string).collect();
                let numbers = Value::Text(numbers.join(", "));
                Value::Phrase("mounting.times".to_owned(), vec![count, numbers])
            }
        };
        let mut sections = certificate.sections.iter_mut();
        if let Some(section) = sections.find(|section| section.key == "mounting") {
            section.entries.push(Entry {
                key: "repeated",
                clause: "ISO 16063-21 5.2",
                value: Some(value),
            });
        }
    }
}

fn belongs(record: &Record, other: &Record, numbers: &[u32]) -> Result<()> {
    let specs = |record: &Record| record.points.iter().map(|p| p.spec).collect::<Vec<_>>();
    let problem = match () {
        () if record.head.instrument_serial != other.head.instrument_serial => {
            "is of another instrument"
        }
        () if numbers.contains(&other.head.id) => "is there twice",
        () if record.head.labels.dut_serial != other.head.labels.dut_serial => {
            "is of another device"
        }
        () if record.settings != other.settings => "was measured with other settings",
        () if specs(record) != specs(other) => "has another list of points",
        () => return Ok(()),
    };
    Err(Error::input(
        format!("record {} of another mounting", other.head.id),
        format!("{problem} than record {}", record.head.id),
        "`calib run --remount N` measures records that belong together",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_record::sample::record;

    /// Magnitudes 0.99, 1, 1.01 of the sample's; phases of 179.9, -179.9 and 180 degrees.
    fn three() -> Vec<Record> {
        let angle = [179.9_f32, -179.9, 180.0];
        let one = |(index, factor): (usize, f32)| {
            let mut record = record(&[160.0]);
            record.head.id += index as u32;
            record.points[0].sensitivity_v_per_ms2 *= factor;
            record.points[0].phase_rad = angle[index].to_radians();
            record
        };
        [0.99, 1.0, 1.01].into_iter().enumerate().map(one).collect()
    }

    /// By hand: s = 1 %, s of the mean 0.577 %, two degrees of freedom; s of the phase 0.1 degrees around 180.
    #[test]
    fn scatter_between_mountings_is_evaluated_by_hand() {
        let records = three();
        let runs: Vec<&[PointResult]> = records.iter().map(|r| &r.points[..]).collect();
        let found = scatter(&runs)[0];
        assert!((found.scatter_rel - 0.01).abs() < 1e-6, "{found:?}");
        assert!((found.standard_uncertainty_rel - 0.01 / 3.0_f64.sqrt()).abs() < 1e-6);
        assert_eq!((found.mountings, found.degrees_of_freedom), (3, 2.0));
        assert!((found.phase_deg.abs() - 180.0).abs() < 1e-4, "{found:?}");
        assert!((found.scatter_phase_deg - 0.1).abs() < 1e-4, "{found:?}");
        assert_eq!(scatter(&runs[..1]), []);
    }

    #[test]
    fn records_that_do_not_belong_together_are_refused() {
        let records = three();
        let refused = |change: fn(&mut Record), words: &str| {
            let mut other = records[1].clone();
            change(&mut other);
            let error = Mountings::join(&records[0], &[other]).err().expect(words);
            assert!(error.to_string().contains(words), "{error}");
        };
        refused(|r| r.head.id = 17, "twice");
        refused(|r| r.head.labels.dut_serial.clear(), "another device");
        refused(|r| r.head.instrument_serial.clear(), "another instrument");
        refused(|r| r.settings.blocks += 1, "other settings");
        refused(|r| r.points[0].spec.frequency_hz = 80.0, "another list");
    }

    #[test]
    fn a_point_that_was_refused_in_one_mounting_has_no_result() {
        let mut records = three();
        let reason = calib_core::point_state::Reason::NotSettled;
        records[2].points[0].state = PointState::Refused(reason);
        let (joined, _) = Mountings::join(&records[0], &records[1..]).expect("one device");
        assert_eq!(joined.points[0].state, PointState::Refused(reason));
    }
}
