//! Specification and rule as a file asks for them, not yet checked.

use super::limits::Band;
use crate::units::STANDARD_GRAVITY_MS2;
use serde::Deserialize;

/// The `[decision]` part of a TOML file.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Request {
    /// `api670`, `nominal`, `relative`; or a name of one's own with bands.
    pub specification: String,
    /// Nominal sensitivity, mV/g.
    pub nominal_mv_per_g: Option<f64>,
    /// Nominal sensitivity, mV/(m/s2).
    pub nominal_mv_per_ms2: Option<f64>,
    /// Tolerance of `nominal` and `relative`, plus or minus %.
    pub tolerance_percent: Option<f64>,
    /// Bands of one's own specification.
    #[serde(rename = "band")]
    pub bands: Vec<Band>,
    /// How results are judged.
    pub rule: RuleName,
    /// Largest probability of false acceptance, %, for `max_false_accept`.
    pub max_false_accept_percent: Option<f64>,
    /// Sensitivities of the last calibration, Hz and V/(m/s2); from the logbook.
    #[serde(skip)]
    pub last: Vec<(f64, f64)>,
}

/// Names of the decision rules.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RuleName {
    /// Accept inside the tolerance.
    Simple,
    /// Accept inside the tolerance less U.
    #[default]
    GuardBand,
    /// Accept while the probability of false acceptance is small enough.
    MaxFalseAccept,
}

impl Request {
    /// True when nothing is specified: a laboratory may state its rule alone, and the
    /// tolerance is the sensor's.
    pub fn is_open(&self) -> bool {
        self.specification.is_empty() && self.bands.is_empty()
    }

    /// Takes a nominal sensitivity, V/(m/s2), if none is stated. API 670 states
    /// one itself.
    pub fn know_nominal(&mut self, v_per_ms2: f64) {
        if self.nominal_v_per_ms2().is_none() && self.specification != "api670" {
            self.nominal_mv_per_ms2 = Some(1000.0 * v_per_ms2);
        }
    }

    /// Nominal sensitivity in V/(m/s2), if it is stated.
    pub(crate) fn nominal_v_per_ms2(&self) -> Option<f64> {
        let per_g = self
            .nominal_mv_per_g
            .map(|mv| mv / 1000.0 / STANDARD_GRAVITY_MS2);
        self.nominal_mv_per_ms2.map(|mv| mv / 1000.0).or(per_g)
    }
}
