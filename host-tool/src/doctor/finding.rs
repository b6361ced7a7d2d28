//! One check of this computer, and how it ended.

use schemars::JsonSchema;
use serde::Serialize;

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// As it should be.
    Good,
    /// Not what is usual; measuring may still work.
    Warning,
    /// Measuring will not work.
    Failed,
}

/// One check.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Finding {
    /// Subject of the check.
    pub check: &'static str,
    /// How it ended.
    pub state: State,
    /// Finding.
    pub finding: String,
    /// Remedy; empty when there is nothing to do.
    pub remedy: String,
}

impl Finding {
    pub(super) fn new(check: &'static str, state: State, finding: impl Into<String>) -> Self {
        Self {
            check,
            state,
            finding: finding.into(),
            remedy: String::new(),
        }
    }

    pub(super) fn with_remedy(self, remedy: impl Into<String>) -> Self {
        Self {
            remedy: remedy.into(),
            ..self
        }
    }
}
