//! One dataset of known cause.

use super::believed::Believed;
use crate::{Error, Result};
use calib_twin::dataset::{self, Columns, Options, RecordOptions, standard_design};
use calib_twin::effects::oscillator::OscillatorAction;
use calib_twin::effects::{ActiveEffect, CalibratorAction, EffectError, Library};
use schemars::JsonSchema;
use serde::Serialize;
use std::path::Path;

/// How a dataset is made.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// Effects as `NAME` or `NAME=PARAM:VALUE,...`.
    pub effects: Vec<String>,
    /// Seed of everything random.
    pub seed: u64,
    /// Columns that are kept.
    pub columns: Columns,
    /// If stated, every nominal parameter is off by this many standard uncertainties.
    pub off_by: Option<f64>,
}

/// Dataset that was made.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Simulated {
    /// Rows (points) or samples written.
    pub rows: usize,
    /// Points the rig could not hold, or with a harmonic above 0.3.
    pub left_out: usize,
    /// Effects with the values they had.
    pub effects: Vec<String>,
    /// Seed.
    pub seed: u64,
}

/// Reads effects of one library.
///
/// # Errors
/// [`Error::Usage`] naming effect, parameter and bounds.
pub fn effects<A: Library>(texts: &[String]) -> Result<Vec<ActiveEffect<A>>> {
    let parse = |text: &String| text.parse().map_err(|e: EffectError| usage(&e));
    texts.iter().map(parse).collect()
}

fn usage(error: &EffectError) -> Error {
    Error::usage(
        error.to_string(),
        "`calib gap effects NAME` lists parameters, units and bounds",
    )
}

/// Simulates `believed` with effects nobody told it, and writes the dataset
/// folder `out`. Nothing in it tells the cause.
///
/// # Errors
/// [`Error::Usage`] for an effect; [`Error::File`].
pub fn simulate(believed: &Believed, request: &Request, out: &Path) -> Result<Simulated> {
    match believed {
        Believed::Calibrator(nominal) => {
            let effects = effects::<CalibratorAction>(&request.effects)?;
            let options = Options {
                seed: request.seed,
                columns: request.columns,
                parameters_off_by: request.off_by,
                ..Options::default()
            };
            let design = standard_design(nominal);
            let made = dataset::generate(nominal, &design, &effects, &options);
            dataset::write(out, nominal, &made.points)
                .map_err(|error| Error::file("write", out, error))?;
            Ok(Simulated {
                rows: made.points.len(),
                left_out: made.left_out,
                effects: effects.iter().map(ToString::to_string).collect(),
                seed: request.seed,
            })
        }
        Believed::Oscillator(nominal) => {
            let effects = effects::<OscillatorAction>(&request.effects)?;
            let options = RecordOptions {
                seed: request.seed,
                ..RecordOptions::default()
            };
            let record = nominal.record(&effects, &options);
            record
                .write(out, nominal)
                .map_err(|error| Error::file("write", out, error))?;
            Ok(Simulated {
                rows: record.input.len(),
                left_out: 0,
                effects: effects.iter().map(ToString::to_string).collect(),
                seed: request.seed,
            })
        }
    }
}
