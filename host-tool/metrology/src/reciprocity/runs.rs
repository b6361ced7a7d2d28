//! The runs of a check.

use crate::statistics::mean;
use calib_core::channel_ratio::{ChannelRatio, ChannelRatioPoint};
use calib_core::point_state::PointState;
use calib_protocol::record::Record;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A voltage ratio as a run states it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Device's input over the reference's, V/V, the ratio of the channels taken away.
    pub ratio: Complex64,
    /// Standard deviation of the mean over the blocks, relative, of either part.
    pub scatter_rel: f64,
    /// Acceleration, m/s2 r.m.s.
    pub acceleration_rms_ms2: f64,
}

/// Shunt and divider at one load.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// Readings with the shunt at the device's input.
    pub shunt: Vec<Reading>,
    /// With the divider.
    pub divider: Vec<Reading>,
}

/// Certified values of the reference at a frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Certified {
    /// Sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Phase, rad.
    pub phase_rad: f64,
    /// Relative expanded uncertainty, k = 2.
    pub expanded_uncertainty_rel: f64,
    /// Standard uncertainty of the ratio of the channels, relative.
    pub ratio_standard_rel: f64,
}

/// The ratio of the channels at a frequency, as the settings of the runs state it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RatioRow {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Device's channel over the reference's, 1.
    pub magnitude: f64,
    /// Its phase, rad.
    pub phase_rad: f64,
    /// Relative expanded uncertainty (k = 2).
    pub expanded_uncertainty_rel: f64,
}

/// The runs of a check, each with the same frequencies.
#[derive(Clone, Debug, PartialEq)]
pub struct Runs {
    /// Without the mass, before and after.
    pub bare: [Pair; 2],
    /// With it, in three orientations.
    pub loaded: [Pair; 3],
    /// Certified values at each frequency.
    pub certified: Vec<Certified>,
    /// The ratio of the channels; empty where nobody measured it.
    pub ratio: Vec<RatioRow>,
    /// Temperature of the calibrator, mean of what was told of the runs, degrees Celsius.
    pub temperature_c: Option<f64>,
}

/// A run of a check, in the order measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Step {
    /// Signal at the device's input.
    pub input: &'static str,
    /// Where the mass is.
    pub mass: &'static str,
}

impl Step {
    /// Nothing is on the table.
    pub fn is_bare(&self) -> bool {
        self.mass == NO_MASS
    }
}

const NO_MASS: &str = "no mass";

const fn step(input: &'static str, mass: &'static str) -> Step {
    Step { input, mass }
}

/// The runs in their order.
pub const STEPS: [Step; 10] = [
    step("shunt", NO_MASS),
    step("divider", NO_MASS),
    step("shunt", "mass, mark 1 in front"),
    step("divider", "mass, mark 1 in front"),
    step("shunt", "mass, mark 2 in front"),
    step("divider", "mass, mark 2 in front"),
    step("shunt", "mass, mark 3 in front"),
    step("divider", "mass, mark 3 in front"),
    step("shunt", NO_MASS),
    step("divider", NO_MASS),
];

/// Greatest travel without the mass, m peak: Bl falls with its square.
const TRAVEL_PEAK_M: f64 = 2.5e-4;
/// Level where travel and current allow it, m/s2 r.m.s.
const LEVEL_RMS_MS2: f64 = 20.0;
/// From here on the current is the same in both loads, below the acceleration, Hz.
const SAME_CURRENT_HZ: f64 = 75.0;

/// Levels at a frequency without the mass and with it, m/s2 r.m.s.
///
/// Around the resonance of the suspension, below 75 Hz, they are equal, so that what depends on travel is:
/// suspension and Bl. Above, the current is, so that the coil is as warm and the converters read the same
/// voltages, whose errors cancel.
pub fn levels(frequency_hz: f64, moving_mass_kg: f64, added_kg: f64) -> [f64; 2] {
    let omega = std::f64::consts::TAU * frequency_hz;
    let by_travel = omega * omega * TRAVEL_PEAK_M / std::f64::consts::SQRT_2;
    let bare = LEVEL_RMS_MS2.min(by_travel);
    let share = match frequency_hz < SAME_CURRENT_HZ {
        true => 1.0,
        false => moving_mass_kg / (moving_mass_kg + added_kg),
    };
    [bare, bare * share]
}

/// Why records are no check.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum RunError {
    /// Not ten.
    #[error("a check has 10 runs, and these are {0}")]
    Count(usize),
    /// One record twice.
    #[error("record {0} is named twice: each run is a record of its own")]
    Twice(u32),
    /// Two instruments.
    #[error("the runs are of two instruments, {0} and {1}")]
    Instruments(String, String),
    /// Other settings in between.
    #[error("settings changed between records {0} and {1}: measure all runs again")]
    Settings(u32, u32),
    /// Not the same frequencies.
    #[error("run {0} has other frequencies than the first: measure all with the same list")]
    Frequencies(usize),
    /// Too few.
    #[error("{0} frequencies are too few: a check needs six, some of them from 63 to 250 Hz")]
    TooFew(usize),
    /// Refused by the instrument.
    #[error("{frequency_hz} Hz of record {record} was refused: see `calib show`")]
    Refused {
        /// Frequency, Hz.
        frequency_hz: f32,
        /// Number of its record.
        record: u32,
    },
    /// The calibrator was warmed or cooled in between.
    #[error(
        "the runs were made from {0} to {1} degrees Celsius: wait until it stands, and measure all again"
    )]
    Temperatures(f64, f64),
    /// A value that is none.
    #[error("run {0} holds a value that is no number, or nothing at an input")]
    NotANumber(usize),
}

/// By how much the temperatures told may differ from run to run, K.
const SAME_TEMPERATURE_K: f64 = 2.0;
/// Fewest frequencies.
const FEWEST: usize = 6;
/// u of the ratio of channels of ordered parts, as nobody measured it (docs/hardware.md): 0.07 % below 1 kHz.
const UNKNOWN_RATIO_STANDARD_REL: f64 = 7e-4;

impl Runs {
    /// The runs of ten records in the order of [`STEPS`].
    ///
    /// # Errors
    /// [`RunError`].
    pub fn from_records(records: &[&Record]) -> Result<Self, RunError> {
        let [first, others @ ..] = records else {
            return Err(RunError::Count(0));
        };
        for other in others {
            same_instrument(first, other)?;
        }
        for (place, record) in records.iter().enumerate() {
            let id = record.head.id;
            if records[..place].iter().any(|before| before.head.id == id) {
                return Err(RunError::Twice(id));
            }
        }
        let runs: Result<Vec<Vec<Reading>>, RunError> =
            records.iter().map(|record| readings(record)).collect();
        let temperature_c = temperature_c(records)?;
        Ok(Self {
            temperature_c,
            ratio: ratio(&first.settings.channel_ratio),
            ..Self::new(runs?, certified(first)?)?
        })
    }

    /// The runs of ten lists of readings in the order of [`STEPS`].
    ///
    /// # Errors
    /// [`RunError`].
    pub fn new(runs: Vec<Vec<Reading>>, certified: Vec<Certified>) -> Result<Self, RunError> {
        let count = runs.len();
        let frequencies = |run: &[Reading]| -> Vec<f64> {
            run.iter().map(|reading| reading.frequency_hz).collect()
        };
        let first = runs.first().map(|run| frequencies(run)).unwrap_or_default();
        for (place, run) in runs.iter().enumerate() {
            if frequencies(run) != first || run.len() != certified.len() {
                return Err(RunError::Frequencies(place + 1));
            }
            if !run.iter().all(is_usable) {
                return Err(RunError::NotANumber(place + 1));
            }
        }
        if first.len() < FEWEST {
            return Err(RunError::TooFew(first.len()));
        }
        let [s0, d0, s1, d1, s2, d2, s3, d3, s4, d4] =
            <[Vec<Reading>; 10]>::try_from(runs).map_err(|_| RunError::Count(count))?;
        let pair = |shunt, divider| Pair { shunt, divider };
        Ok(Self {
            bare: [pair(s0, d0), pair(s4, d4)],
            loaded: [pair(s1, d1), pair(s2, d2), pair(s3, d3)],
            certified,
            ratio: Vec::new(),
            temperature_c: None,
        })
    }

    /// Number of frequencies.
    pub fn len(&self) -> usize {
        self.certified.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.certified.is_empty()
    }
}

fn is_usable(reading: &Reading) -> bool {
    let positive = |value: f64| value.is_finite() && value > 0.0;
    positive(reading.frequency_hz)
        && positive(reading.ratio.norm())
        && positive(reading.acceleration_rms_ms2)
        && reading.scatter_rel.is_finite()
        && reading.scatter_rel >= 0.0
}

fn same_instrument(first: &Record, other: &Record) -> Result<(), RunError> {
    let serials = [first, other].map(|record| record.head.instrument_serial.as_str().to_owned());
    let [one, another] = serials;
    if one != another {
        return Err(RunError::Instruments(one, another));
    }
    match first.settings == other.settings {
        true => Ok(()),
        false => Err(RunError::Settings(first.head.id, other.head.id)),
    }
}

/// Mean of the temperatures told; none where a run has none.
fn temperature_c(records: &[&Record]) -> Result<Option<f64>, RunError> {
    let told = records
        .iter()
        .map(|record| record.head.labels.temperature_centi_c);
    let told: Option<Vec<f64>> = told
        .map(|centi| centi.map(|centi| f64::from(centi) / 100.0))
        .collect();
    let Some(told) = told else {
        return Ok(None);
    };
    let [least, most] = [f64::min, f64::max].map(|of| told.iter().copied().reduce(of));
    match least
        .zip(most)
        .filter(|(least, most)| most - least > SAME_TEMPERATURE_K)
    {
        Some((least, most)) => Err(RunError::Temperatures(least, most)),
        None => Ok(Some(mean(&told))),
    }
}

fn refused(record: &Record, frequency_hz: f32) -> RunError {
    RunError::Refused {
        frequency_hz,
        record: record.head.id,
    }
}

/// Ratio of voltages: the sensitivity a run states, over that of the reference's table.
fn readings(record: &Record) -> Result<Vec<Reading>, RunError> {
    let points = record.points.iter().map(|point| {
        let frequency_hz = point.spec.frequency_hz;
        let reference = record.settings.reference.at(frequency_hz);
        let (PointState::Valid, Some(reference)) = (point.state, reference) else {
            return Err(refused(record, frequency_hz));
        };
        // An input that is inverted is stated apart from the phase.
        let turned = if point.inverted {
            std::f64::consts::PI
        } else {
            0.0
        };
        let magnitude = point.sensitivity_v_per_ms2 / reference.sensitivity_v_per_ms2;
        let phase_rad = point.phase_rad - reference.phase_rad;
        let scatter = point.repeatability_rel.max(point.repeatability_phase_rad);
        Ok(Reading {
            frequency_hz: f64::from(frequency_hz),
            ratio: Complex64::from_polar(f64::from(magnitude), f64::from(phase_rad) + turned),
            scatter_rel: f64::from(scatter),
            acceleration_rms_ms2: f64::from(point.acceleration_rms_ms2),
        })
    });
    points.collect()
}

fn certified(record: &Record) -> Result<Vec<Certified>, RunError> {
    let settings = &record.settings;
    let points = record.points.iter().map(|point| {
        let frequency_hz = point.spec.frequency_hz;
        let reference = settings.reference.at(frequency_hz);
        let reference = reference.ok_or_else(|| refused(record, frequency_hz))?;
        let ratio = ratio_standard_rel(&settings.channel_ratio, frequency_hz);
        Ok(Certified {
            sensitivity_v_per_ms2: f64::from(reference.sensitivity_v_per_ms2),
            phase_rad: f64::from(reference.phase_rad),
            expanded_uncertainty_rel: f64::from(reference.expanded_uncertainty_rel),
            ratio_standard_rel: ratio.unwrap_or(UNKNOWN_RATIO_STANDARD_REL),
        })
    });
    points.collect()
}

fn ratio(stated: &ChannelRatio) -> Vec<RatioRow> {
    let row = |row: &ChannelRatioPoint| RatioRow {
        frequency_hz: f64::from(row.frequency_hz),
        magnitude: f64::from(row.magnitude),
        phase_rad: f64::from(row.phase_rad),
        expanded_uncertainty_rel: f64::from(row.expanded_uncertainty_rel),
    };
    stated.points.iter().map(row).collect()
}

/// The larger of what is stated of the ratio at the frequencies around this one; none outside of its table.
fn ratio_standard_rel(ratio: &ChannelRatio, frequency_hz: f32) -> Option<f64> {
    // As near as a row counts as hit.
    let near = 5e-4 * frequency_hz;
    let above = ratio
        .points
        .iter()
        .position(|row| row.frequency_hz >= frequency_hz - near)?;
    let hit = (ratio.points[above].frequency_hz - frequency_hz).abs() <= near;
    let below = if hit { above } else { above.checked_sub(1)? };
    let rows = &ratio.points[below..=above];
    let stated = rows.iter().map(|row| row.expanded_uncertainty_rel);
    stated.reduce(f32::max).map(|most| f64::from(most) / 2.0)
}
