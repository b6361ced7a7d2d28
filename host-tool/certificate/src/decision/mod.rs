//! Statements of conformity: tolerances, decision rules and their risks.
//!
//! | file | idea |
//! |---|---|
//! | [`specification`] | what is tolerated, over frequency |
//! | [`rule`] | how a result with its uncertainty is judged |
//! | [`risk`] | probabilities of false acceptance and rejection |
//!
//! ISO/IEC 17025 7.8.6 wants three things said: which results, which
//! specification, which rule. All three come from a [`Request`].

pub mod risk;
pub mod rule;
pub mod specification;

pub use rule::{Assessment, Conformity, Limits, Rule, assess};
pub use specification::{Band, Base, Specification};

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

/// Specification and rule, checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// What is tolerated.
    pub specification: Specification,
    /// How results are judged.
    pub rule: Rule,
}

impl Request {
    /// Checks the request.
    ///
    /// # Errors
    /// A sentence that names what is missing or makes no sense.
    pub fn build(&self) -> Result<Decision, String> {
        Ok(Decision {
            specification: Specification::build(self)?,
            rule: Rule::build(self)?,
        })
    }

    /// Checks what does not depend on the device under test: its nominal
    /// sensitivity may come from another file, or from the logbook.
    ///
    /// # Errors
    /// As [`Self::build`].
    pub fn check(&self) -> Result<(), String> {
        let mut request = self.clone();
        request.know_nominal(1.0);
        request.build().map(drop)
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
