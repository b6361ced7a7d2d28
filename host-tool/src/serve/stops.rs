//! A stop: for which run it is, and what became of it.
//!
//! | stop for | while | then |
//! |---|---|---|
//! | the run that goes on, or whatever does | | passed on ahead of everything, confirmed or not |
//! | a run that has ended | nothing runs | the same: silence is silence |
//! | a run that has ended | the next one runs | refused: it came late, and would end another run |
//!
//! Confirmed means: the calibrator answered the stop. What it did not answer within [`STOP_ALARM`] has failed as
//! far as anybody can know, and the page says so, full screen. An answer that comes later takes that back, and
//! says how late it was.

use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use calib_link::STOP_ALARM;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Stop that a page sends.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Asked {
    /// Number of the run it is for, 0 for none of this server's; without it, for whatever goes on.
    pub(super) run: Option<u32>,
}

/// State of the latest stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum StopState {
    /// It is on its way.
    Asked,
    /// The calibrator has answered: the exciter is silent.
    Confirmed,
    /// It has not answered in time.
    Unconfirmed,
}

/// The latest stop.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StopView {
    /// Running number among those of this server.
    pub number: u64,
    /// The run it ends; 0 when none of this server's went on.
    pub run: u32,
    /// Its state.
    pub state: StopState,
    /// Time to the confirmation, s.
    pub after_s: Option<f64>,
}

/// Why nobody can say that the exciter is silent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NotStopped {
    /// Another run has begun since.
    Late { of: u32, running: u32 },
    /// The calibrator did not answer in time.
    Unconfirmed,
}

impl NotStopped {
    /// For the operator.
    pub(super) fn text(self) -> String {
        match self {
            Self::Late { of, running } => {
                format!("the stop was for run {of}; run {running} has begun since: STOP again")
            }
            Self::Unconfirmed => {
                let limit_ms = STOP_ALARM.as_millis();
                format!("the calibrator did not confirm the stop within {limit_ms} ms")
            }
        }
    }
}

impl IntoResponse for NotStopped {
    fn into_response(self) -> Response {
        let status = match self {
            Self::Late { .. } => StatusCode::CONFLICT,
            Self::Unconfirmed => StatusCode::GATEWAY_TIMEOUT,
        };
        (status, self.text()).into_response()
    }
}
