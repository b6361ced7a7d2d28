//! The ratio of the two channels, from two runs with one source at both inputs.
//!
//! # Equation
//! With the source at both inputs the reference's sensitivity S1 only says what is called acceleration:
//! a run states `S = S1 R (v2/v1)` with the ratio R of the channels and the voltages v at their
//! connectors. With the leads exchanged it states `S' = S1 R (v1/v2)`, so `R = sqrt(S S') / S1` whatever
//! the leads do. A ratio that was in force already is put back first.
//!
//! # What does not cancel
//! Both inputs must load a lead alike: 1 kilohm of source before inputs of 1 Mohm that differ by 10 %
//! leaves 1e-4. Keep the source below 100 ohm.

use calib_core::budget::{
    Budget, BudgetError, Component, CoverageRule, Expanded, PROBABILITY_K2, Row,
};
use calib_core::channel_ratio::{ChannelRatio, ChannelRatioPoint, MAX_CHANNEL_RATIO_POINTS};
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_core::settings::Distribution;
use calib_protocol::record::Record;
use num_complex::Complex32;
use schemars::JsonSchema;
use serde::Serialize;
use thiserror::Error;

/// By how much the leads may differ: more is a broken one, or a source at one input alone.
pub const LEADS_REL: f32 = 0.05;
/// Error bound of the correlation itself, relative and in rad (`calib_core::correlation`).
const CORRELATION: f32 = 1e-6;
/// Row of Table A.1 for the measurement of the ratio of the voltages.
const RATIO_ROW: u8 = 3;
const SECONDS_OF_A_DAY: u64 = 86_400;

/// Why two runs give no ratio.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RatioError {
    /// Both runs are one.
    #[error("both runs are record {0}: measure the second with the leads exchanged")]
    OneRun(u32),
    /// They are of two instruments.
    #[error("the runs are of two instruments, {0} and {1}")]
    Instruments(String, String),
    /// Reference, inputs or the ratio in force changed in between.
    #[error("settings changed between the runs: measure both again")]
    Settings,
    /// They have not the same frequencies.
    #[error("the runs have not the same frequencies: measure both with the same list")]
    Frequencies,
    /// More frequencies than an instrument keeps.
    #[error("{0} frequencies are more than the {MAX_CHANNEL_RATIO_POINTS} an instrument keeps")]
    TooMany(usize),
    /// A point was refused.
    #[error("{frequency_hz} Hz of record {record} was refused: see `calib show`")]
    Refused {
        /// Its frequency, Hz.
        frequency_hz: f32,
        /// Number of its record.
        record: u32,
    },
    /// The leads differ too much.
    #[error(
        "at {frequency_hz} Hz the leads differ by {difference_percent:.1} %: is one source at both inputs?"
    )]
    Leads {
        /// Frequency, Hz.
        frequency_hz: f32,
        /// Difference, %.
        difference_percent: f32,
    },
    /// Its uncertainty cannot be stated.
    #[error("at {frequency_hz} Hz: {error}")]
    Budget {
        /// Frequency, Hz.
        frequency_hz: f32,
        /// Error of the budget.
        error: BudgetError,
    },
}

/// One frequency, as it is printed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RatioLine {
    /// Frequency, Hz.
    pub frequency_hz: f32,
    /// Device's channel over the reference's, less 1.
    pub magnitude_deviation_rel: f32,
    /// Phase of it, degrees.
    pub phase_deg: f32,
    /// Relative expanded uncertainty of the magnitude (k = 2).
    pub expanded_uncertainty_rel: f32,
    /// Expanded uncertainty of the phase (k = 2), degrees.
    pub expanded_uncertainty_phase_deg: f32,
    /// Difference of the leads, relative; it cancelled.
    pub leads_rel: f32,
}

/// A ratio and what is printed of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluated {
    /// For the settings.
    pub ratio: ChannelRatio,
    /// For people.
    pub lines: Vec<RatioLine>,
}

/// Evaluates two runs, the second with the leads exchanged.
///
/// # Errors
/// [`RatioError`].
///
/// # Accuracy
/// Tests `exchanged_leads_cancel` and, through the instrument,
/// `adjust::a_ratio_brings_the_phase_back_within_its_uncertainty`.
pub fn evaluate(straight: &Record, exchanged: &Record) -> Result<Evaluated, RatioError> {
    check_runs(straight, exchanged)?;
    let mut evaluated = Evaluated {
        ratio: ChannelRatio {
            measured_day: day(straight.head.labels.unix_time_s),
            ..ChannelRatio::UNKNOWN
        },
        lines: Vec::new(),
    };
    let mut pairs: Vec<_> = straight.points.iter().zip(&exchanged.points).collect();
    pairs.sort_by(|a, b| a.0.spec.frequency_hz.total_cmp(&b.0.spec.frequency_hz));
    for (before, after) in pairs {
        let frequency_hz = before.spec.frequency_hz;
        let [first, second] = [(straight, before), (exchanged, after)]
            .map(|(record, point)| channels_and_leads(record, point));
        let (first, second) = (first?, second?);
        let leads_rel = (first / second).norm().sqrt() - 1.0;
        if leads_rel.is_nan() || leads_rel.abs() > LEADS_REL {
            let difference_percent = 100.0 * leads_rel;
            return Err(RatioError::Leads {
                frequency_hz,
                difference_percent,
            });
        }
        let ratio = (first * second).sqrt();
        let expand = |error| RatioError::Budget {
            frequency_hz,
            error,
        };
        let [magnitude, phase] = uncertainty(straight, before, after).map_err(expand)?;
        let row = ChannelRatioPoint {
            frequency_hz,
            magnitude: ratio.norm(),
            phase_rad: ratio.arg(),
            expanded_uncertainty_rel: magnitude.expanded_uncertainty,
            expanded_uncertainty_phase_rad: phase.expanded_uncertainty,
        };
        let pushed = evaluated.ratio.points.push(row);
        pushed.map_err(|_| RatioError::TooMany(straight.points.len()))?;
        evaluated.lines.push(line(&row, leads_rel));
    }
    Ok(evaluated)
}

fn check_runs(straight: &Record, exchanged: &Record) -> Result<(), RatioError> {
    let (a, b) = (&straight.head, &exchanged.head);
    if a.instrument_serial != b.instrument_serial {
        let serials = [a, b].map(|head| head.instrument_serial.as_str().to_owned());
        let [first, second] = serials;
        return Err(RatioError::Instruments(first, second));
    }
    if a.id == b.id {
        return Err(RatioError::OneRun(a.id));
    }
    if straight.settings != exchanged.settings {
        return Err(RatioError::Settings);
    }
    let frequencies = |record: &Record| -> Vec<f32> {
        let points = record.points.iter();
        points.map(|point| point.spec.frequency_hz).collect()
    };
    match frequencies(straight) == frequencies(exchanged) {
        true => Ok(()),
        false => Err(RatioError::Frequencies),
    }
}

/// Sensitivity a run states, over that of the reference's table: `R v2/v1`.
fn channels_and_leads(record: &Record, point: &PointResult) -> Result<Complex32, RatioError> {
    let frequency_hz = point.spec.frequency_hz;
    let reference = record.settings.reference.at(frequency_hz);
    let (PointState::Valid, Some(reference)) = (point.state, reference) else {
        let record = record.head.id;
        return Err(RatioError::Refused {
            frequency_hz,
            record,
        });
    };
    let called = Complex32::from_polar(reference.sensitivity_v_per_ms2, reference.phase_rad);
    let stated = Complex32::from_polar(point.sensitivity_v_per_ms2, point.phase_rad);
    Ok(stated / called * record.settings.channel_ratio.taken_away(frequency_hz))
}

/// Expanded uncertainty of magnitude and phase: the scatter of both runs, each of which counts half, the
/// correlation, and what differs from point to point of the converters, which is in both alike.
fn uncertainty(
    record: &Record,
    straight: &PointResult,
    exchanged: &PointResult,
) -> Result<[Expanded; 2], BudgetError> {
    let settings = &record.settings;
    let reference = settings.reference.at(straight.spec.frequency_hz);
    let mut at_point = settings.point_influences;
    // What is measured here is no uncertainty of it.
    at_point.channel_delay_s = 0.0;
    let steps = reference.map(|reference| at_point.at(straight, &reference));
    let of = |row: Row, scatter: fn(&PointResult) -> f32, step: fn([f32; 2]) -> f32| {
        let mut budget = Budget::new();
        for run in [straight, exchanged] {
            let standard = Distribution::Normal {
                coverage_factor: 1.0,
            };
            let degrees = f32::from(run.blocks.saturating_sub(1).max(1));
            let component = Component::new(row, scatter(run) / 2.0, standard);
            budget.add(component.with_degrees_of_freedom(degrees))?;
        }
        let correlation = Component::new(row, CORRELATION, Distribution::Rectangular);
        budget.add(correlation)?;
        for at in steps.iter().flatten().filter(|at| at.row == RATIO_ROW) {
            let half_width = step([at.half_width_rel, at.half_width_phase_rad]);
            budget.add(Component::new(row, half_width, at.distribution))?;
        }
        budget.expand(CoverageRule::Probability(PROBABILITY_K2))
    };
    Ok([
        of(Row::a1(18), |run| run.repeatability_rel, |at| at[0])?,
        of(
            Row::a2_from_a1(18),
            |run| run.repeatability_phase_rad,
            |at| at[1],
        )?,
    ])
}

fn line(row: &ChannelRatioPoint, leads_rel: f32) -> RatioLine {
    RatioLine {
        frequency_hz: row.frequency_hz,
        magnitude_deviation_rel: row.magnitude - 1.0,
        phase_deg: row.phase_rad.to_degrees(),
        expanded_uncertainty_rel: row.expanded_uncertainty_rel,
        expanded_uncertainty_phase_deg: row.expanded_uncertainty_phase_rad.to_degrees(),
        leads_rel,
    }
}

/// Days since 1970-01-01.
fn day(unix_time_s: u64) -> u32 {
    u32::try_from(unix_time_s / SECONDS_OF_A_DAY).unwrap_or(0)
}

/// A table of the ratio.
pub fn report(lines: &[RatioLine]) -> String {
    let mut text = "       Hz   device over reference      U (k = 2)         leads\n".to_owned();
    for line in lines {
        text += &format!(
            "{:>9} {:>+9.4} % {:>+9.4} deg {:>8.4} % {:>7.4} deg {:>+8.3} %\n",
            line.frequency_hz,
            100.0 * line.magnitude_deviation_rel,
            line.phase_deg,
            100.0 * line.expanded_uncertainty_rel,
            line.expanded_uncertainty_phase_deg,
            100.0 * line.leads_rel
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run of one point in which the device's channel reads 1.004 at -0.01 rad of the reference's, and
    /// the leads `leads_rel` apart.
    fn run(id: u32, leads_rel: f32) -> Record {
        let mut record = calib_record::sample::record(&[160.0]);
        record.head.id = id;
        let point = &mut record.points[0];
        point.state = PointState::Valid;
        let reference = record.settings.reference.at(point.spec.frequency_hz);
        let reference = reference.expect("in the table");
        point.sensitivity_v_per_ms2 = reference.sensitivity_v_per_ms2 * 1.004 * (1.0 + leads_rel);
        point.phase_rad = reference.phase_rad - 0.01;
        point.repeatability_rel = 1e-4;
        point.repeatability_phase_rad = 1e-4;
        record.settings.point_influences.converter_step_v = 0.0;
        record
    }

    /// Leads 1 % apart: sqrt(1.01 / 1.01), to second order of nothing. The scatter of either run counts half:
    /// 1e-4 / sqrt(2), times a factor from 2.0 (no end of freedom) to 2.3 (10 degrees).
    #[test]
    fn exchanged_leads_cancel() {
        let evaluated = evaluate(&run(1, 0.01), &run(2, 1.0 / 1.01 - 1.0)).expect("a ratio");
        let row = evaluated.ratio.points[0];
        assert!((row.magnitude - 1.004).abs() < 1e-6, "{row:?}");
        assert!((row.phase_rad + 0.01).abs() < 1e-6, "{row:?}");
        let scatter = 1e-4 / 2.0_f32.sqrt();
        assert!((2.0..2.4).contains(&(row.expanded_uncertainty_rel / scatter)));
        assert!((evaluated.lines[0].leads_rel - 0.01).abs() < 1e-5);
    }

    #[test]
    fn a_ratio_in_force_is_put_back() {
        let runs = [(1, 0.0), (2, 0.0)].map(|(id, leads_rel)| {
            let mut record = run(id, leads_rel);
            let point = &mut record.points[0];
            let known = evaluate(&run(1, 0.0), &run(2, 0.0)).expect("a ratio").ratio;
            point.sensitivity_v_per_ms2 /= 1.004;
            point.phase_rad += 0.01;
            record.settings.channel_ratio = known;
            record
        });
        let [straight, exchanged] = runs;
        let row = evaluate(&straight, &exchanged)
            .expect("a ratio")
            .ratio
            .points[0];
        assert!((row.magnitude - 1.004).abs() < 2e-6, "{row:?}");
        assert!((row.phase_rad + 0.01).abs() < 2e-6, "{row:?}");
    }

    #[test]
    fn runs_that_are_none_are_told() {
        let told = |straight: &Record, exchanged: &Record| {
            evaluate(straight, exchanged)
                .expect_err("no ratio")
                .to_string()
        };
        assert!(told(&run(1, 0.0), &run(1, 0.0)).contains("both runs are record 1"));
        assert!(told(&run(1, 0.2), &run(2, -0.2)).contains("one source at both inputs"));
        let mut other = run(2, 0.0);
        other.settings.blocks += 1;
        assert!(told(&run(1, 0.0), &other).contains("settings changed"));
        let mut refused = run(2, 0.0);
        refused.points[0].state = PointState::Refused(calib_core::point_state::Reason::Clipped);
        assert!(told(&run(1, 0.0), &refused).contains("of record 2 was refused"));
        let mut fewer = run(2, 0.0);
        fewer.points.clear();
        assert!(told(&run(1, 0.0), &fewer).contains("not the same frequencies"));
        let mut elsewhere = run(2, 0.0);
        elsewhere.head.instrument_serial = "B7".try_into().expect("short");
        assert!(told(&run(1, 0.0), &elsewhere).contains("two instruments"));
    }
}
