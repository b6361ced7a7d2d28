//! A record against Tables 1 to 6 and the list of clause 7.
//!
//! # Source
//! ISO 16063-21:2003, Tables 1 to 6, clauses 4 and 7.

mod linearity;
mod report;
mod requirements;
mod rows;

pub use report::report;
pub use requirements::{Basis, Outcome, Requirement, requirements};
pub use rows::Held;

use calib_core::settings::Example;
use calib_output::{SetPoint, StateView};
use calib_protocol::record::Record;
use schemars::JsonSchema;
use serde::Serialize;

/// A record judged.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Check {
    /// Which requirements were applied: 1 (laboratory) or 2 (field).
    pub example: u8,
    /// Rows of Tables 1 to 6, each with its worst point.
    pub requirements: Vec<Requirement>,
    /// Every point against the rows that say something about it.
    pub points: Vec<PointCheck>,
    /// Items clause 7 asks for that the record lacks.
    pub missing: Vec<Missing>,
    /// No requirement failed.
    pub passed: bool,
}

/// A point judged.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PointCheck {
    /// The request.
    #[serde(flatten)]
    pub set: SetPoint,
    /// State of the point, as the instrument gave it.
    pub state: StateView,
    /// Code of the instrument's reason for a refusal, in snake case.
    pub reason: Option<String>,
    /// Rows of Tables 1 and 2; none for a refused point, whose numbers are no
    /// results.
    pub held: Vec<Held>,
    /// The instrument passed it, and every row is fulfilled.
    pub passed: bool,
}

/// A statement that is missing.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Missing {
    /// Missing item.
    pub item: String,
    /// Clause that asks for it.
    pub clause: String,
}

/// Judges a record. `missing` is what neither it nor the laboratory states;
/// `example` overrides what its settings say.
pub fn check(record: &Record, missing: Vec<Missing>, example: Option<Example>) -> Check {
    let example = example.unwrap_or(record.settings.example);
    let requirements = requirements(record, example);
    Check {
        example: match example {
            Example::Example1 => 1,
            Example::Example2 => 2,
        },
        passed: requirements
            .iter()
            .all(|requirement| requirement.outcome != Outcome::Fail),
        requirements,
        points: points(record, example),
        missing,
    }
}

fn points(record: &Record, example: Example) -> Vec<PointCheck> {
    let judged = record.points.iter().map(|point| {
        let (state, reason) = StateView::of(point.state);
        let held = match state {
            StateView::Valid => rows::held(record, example, point),
            StateView::Refused => Vec::new(),
        };
        PointCheck {
            set: SetPoint::from(&point.spec),
            passed: reason.is_none() && held.iter().all(|row| row.passed),
            state,
            reason,
            held,
        }
    });
    judged.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_record::sample;

    fn of<'a>(check: &'a Check, parameter: &str) -> &'a Requirement {
        let found = check
            .requirements
            .iter()
            .find(|requirement| requirement.parameter == parameter);
        found.expect("the row is there")
    }

    #[test]
    fn the_worst_point_decides_its_row() {
        let mut record = sample::record(&[80.0, 160.0, 1000.0]);
        let distortion = "total harmonic distortion";
        record.points[1].distortion_reference_rel = 0.10;
        let check = super::check(&record, Vec::new(), Some(Example::Example2));
        // Table 2, Example 2, above 20 Hz: 10 %, which 10 % fulfils.
        assert_eq!(of(&check, distortion).outcome, Outcome::Pass);
        assert_eq!(of(&check, distortion).limit.map(|l| l.round()), Some(10.0));
        record.points[1].distortion_reference_rel = 0.101;
        let check = super::check(&record, Vec::new(), Some(Example::Example2));
        assert_eq!(of(&check, distortion).outcome, Outcome::Fail);
        assert_eq!(of(&check, distortion).at_hz, Some(160.0));
        assert!(!check.passed);
        assert!(check.points[0].passed && !check.points[1].passed);
        // A refused point has no result that could fail.
        record.points[1].state = calib_core::point_state::PointState::Refused(
            calib_core::point_state::Reason::Distortion,
        );
        let check = super::check(&record, Vec::new(), Some(Example::Example2));
        assert_eq!(of(&check, distortion).outcome, Outcome::Pass);
    }

    #[test]
    fn limits_follow_frequency_and_example() {
        let record = sample::record(&[160.0, 1600.0, 5000.0]);
        let held = |example| {
            let check = super::check(&record, Vec::new(), Some(example));
            let limits = check.points.iter().map(|point| point.held[0].limit);
            limits.map(|limit| limit.round()).collect::<Vec<_>>()
        };
        // Table 1, accelerometers, in percent.
        assert_eq!(held(Example::Example1), [1.0, 2.0, 3.0]);
        assert_eq!(held(Example::Example2), [3.0, 5.0, 10.0]);
    }

    #[test]
    fn noise_counts_from_full_output() {
        // 71.5 dB below 10.003 m/s2 r.m.s.; 200 m/s2 peak are 23.01 dB more.
        let record = sample::record(&[160.0]);
        let check = super::check(&record, Vec::new(), None);
        let noise = of(&check, "hum and noise below full");
        assert!(noise.worst.is_some_and(|db| (db - 94.51).abs() < 0.01));
    }

    #[test]
    fn linearity_is_measured_by_several_levels_at_one_frequency() {
        let mut record = sample::record(&[160.0, 160.0, 80.0]);
        let linearity = |record: &Record| {
            let check = super::check(record, Vec::new(), Some(Example::Example2));
            of(&check, "voltage linearity").clone()
        };
        assert_eq!(linearity(&record).outcome, Outcome::NotMeasured);
        // 0.2 % and 0.4 % between two levels; Table 3 allows 0.3 %.
        record.points[1].spec.acceleration_rms_ms2 = 50.0;
        record.points[1].sensitivity_v_per_ms2 *= 1.002;
        assert_eq!(linearity(&record).outcome, Outcome::Pass);
        record.points[1].sensitivity_v_per_ms2 *= 1.002;
        let failed = linearity(&record);
        assert_eq!(failed.outcome, Outcome::Fail);
        assert!(failed.worst.is_some_and(|worst| (worst - 0.4).abs() < 0.01));
    }

    /// A day after it was due is a day too late, the day itself is none.
    #[test]
    fn a_reference_that_is_overdue_fails() {
        let mut record = sample::record(&[160.0]);
        let mut outcome = |run_s: u64, due_day: u32| {
            record.head.labels.unix_time_s = run_s;
            record.settings.reference.due_day = due_day;
            let check = super::check(&record, Vec::new(), None);
            let row = of(&check, "reference, days overdue");
            (row.outcome, row.worst, check.passed)
        };
        // 2026-04-22 is day 20 565; its last second, and the one after.
        let last_s = 20_566 * 86_400 - 1;
        assert_eq!(outcome(last_s, 20_565), (Outcome::Pass, Some(0.0), true));
        assert_eq!(
            outcome(last_s + 1, 20_565),
            (Outcome::Fail, Some(1.0), false)
        );
        assert_eq!(outcome(last_s, 0).0, Outcome::NotMeasured);
        assert_eq!(outcome(0, 20_565).0, Outcome::NotMeasured);
    }

    #[test]
    fn missing_statements_and_measurements_are_listed() {
        let mut record = sample::record(&[160.0]);
        // As its certificate states it, told 23.1 degrees.
        record.points[0].expanded_uncertainty_rel = 0.006_664;
        let missing = Missing {
            item: "Ambient air temperature".to_owned(),
            clause: "ISO 16063-21 7 a".to_owned(),
        };
        let check = super::check(&record, vec![missing], None);
        let unmeasured = of(&check, "frequency stability");
        assert_eq!(unmeasured.outcome, Outcome::NotMeasured);
        let report = super::report(&check);
        assert!(report.contains("not measured"), "{report}");
        // The worked example of the page, line by line.
        let page = include_str!("../../../../docs/metrology/points.md");
        let block = page.split("```\n  parameter").nth(1).unwrap_or("");
        for line in block.split("```").next().unwrap_or("").lines().skip(1) {
            assert!(report.contains(line), "{line}\n{report}");
        }
        assert!(
            report.lines().all(|line| line.chars().count() <= 80),
            "{report}"
        );
    }
}
