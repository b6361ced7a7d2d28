//! The identified model as `calib identify --json` wrote it.

use crate::input::Source;
use crate::oscillator::Oscillator;
use calib_files::{Error, Result};
use nalgebra::Matrix3;
use serde::Deserialize;
use std::path::Path;

/// Parameters with their covariance.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Parameters.
    pub oscillator: Oscillator,
    /// Covariance matrix of (S0, f0 in Hz, delta).
    pub covariance: Matrix3<f64>,
}

#[derive(Deserialize)]
struct Raw {
    s0: f64,
    f0_hz: f64,
    delta: f64,
    #[serde(default)]
    #[serde(alias = "standard_uncertainty_s0")]
    u_s0: f64,
    #[serde(default)]
    #[serde(alias = "standard_uncertainty_f0_hz")]
    u_f0_hz: f64,
    #[serde(default)]
    #[serde(alias = "standard_uncertainty_delta")]
    u_delta: f64,
    correlation: Option<[[f64; 3]; 3]>,
}

const HINT: &str = "give the file written by `calib identify --json`, or a TOML file with s0, \
f0_hz, delta, and u_s0, u_f0_hz, u_delta";

/// Reads a model: JSON when the file begins with a brace, else TOML.
///
/// # Errors
/// A parameter that is missing or cannot be.
pub fn load_model(path: &Path) -> Result<Model> {
    let source = Source::read(path)?;
    let raw: Raw = match source.text.trim_start().starts_with('{') {
        true => serde_json::from_str(&source.text)
            .map_err(|error| source.at_line(error.line(), error.to_string(), HINT))?,
        false => source.parse_toml(HINT)?,
    };
    model(&raw).map_err(|problem| source.at_line(1, problem, HINT))
}

impl Model {
    /// A model from numbers: parameters and standard uncertainties.
    ///
    /// # Errors
    /// A parameter that cannot be.
    pub fn new(oscillator: Oscillator, u: [f64; 3]) -> Result<Self> {
        let raw = Raw {
            s0: oscillator.s0,
            f0_hz: oscillator.f0_hz,
            delta: oscillator.delta,
            u_s0: u[0],
            u_f0_hz: u[1],
            u_delta: u[2],
            correlation: None,
        };
        model(&raw).map_err(|problem| Error::usage(problem, HINT))
    }
}

fn model(raw: &Raw) -> Result<Model, String> {
    let u = [raw.u_s0, raw.u_f0_hz, raw.u_delta];
    let finite = [raw.s0, raw.f0_hz, raw.delta]
        .iter()
        .chain(&u)
        .all(|v| v.is_finite());
    if !finite || raw.s0 == 0.0 || raw.f0_hz <= 0.0 || raw.delta <= 0.0 {
        return Err("s0, f0_hz and delta must be finite, f0_hz and delta above zero".into());
    }
    if u.iter().any(|u| *u < 0.0) {
        return Err("an uncertainty is negative".into());
    }
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let r = raw.correlation.unwrap_or(identity);
    Ok(Model {
        oscillator: Oscillator {
            s0: raw.s0,
            f0_hz: raw.f0_hz,
            delta: raw.delta,
        },
        covariance: Matrix3::from_fn(|a, b| r[a][b] * u[a] * u[b]),
    })
}
