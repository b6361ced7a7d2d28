//! Answers as they were given.

use calib_files::{Error, Result, text};
use serde::Deserialize;
use std::path::Path;

/// Fields of an answer that scoring needs; anybody's diagnosis can write them.
#[derive(Clone, Debug, Deserialize)]
pub struct ScoredAnswer {
    pub(super) verdict: String,
    pub(super) causes: Vec<ScoredCause>,
    pub(super) none_of_these_p_value: f64,
    #[serde(default)]
    pub(super) r#where: Vec<Place>,
    pub(super) gap: Closed,
    pub(super) dataset: Identity,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct ScoredCause {
    pub(super) effects: Vec<String>,
    pub(super) probability: f64,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct Place {
    pub(super) stage: String,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct Closed {
    pub(super) closed: Option<f64>,
}

#[derive(Clone, Debug, Deserialize)]
pub(super) struct Identity {
    pub(super) sha256: String,
}

/// Reads answers: JSON lines, or one JSON array.
///
/// # Errors
/// [`Error::File`]; [`Error::Input`] with the line.
pub fn read_answers(path: &Path) -> Result<Vec<ScoredAnswer>> {
    let text = text::read(path)?;
    let broken = |line: usize, error: serde_json::Error| {
        let place = format!("{}:{line}", path.display());
        let hint = "answers are what `calib gap diagnose --json-lines` prints";
        Error::input(place, error.to_string(), hint)
    };
    if text.trim_start().starts_with('[') {
        return serde_json::from_str(&text).map_err(|e| broken(e.line(), e));
    }
    let lines = text.lines().enumerate();
    let filled = lines.filter(|(_, line)| !line.trim().is_empty());
    filled
        .map(|(at, line)| serde_json::from_str(line).map_err(|e| broken(at + 1, e)))
        .collect()
}
