//! Requests: what is asked, and what is answered.
//!
//! | request | answer |
//! |---|---|
//! | `GET /` and what it names | the page |
//! | `GET /api/state`, `/api/events` | the view; its changes |
//! | `GET /api/waveforms` | the latest waveforms and spectra of both inputs |
//! | `GET /api/devices`, `/api/sensors`, `/api/records` | ports; the logbook |
//! | `GET /api/history/SERIAL` | drift of a sensor at 160 Hz |
//! | `GET /api/certificate/FORMAT` | certificate of the last run |
//! | `GET /api/records/ID/certificate/FORMAT` | that of a record of the logbook |
//! | `POST /api/connect` | `{"device"}` |
//! | `POST /api/run` | `{"sensor" or "dut_model", "dut_serial"; "operator", "mounting", "set_acceleration_rms_ms2", "temperature_c", "frequencies_hz"}` |
//! | `POST /api/stop` | silences the exciter |
//!
//! Posts must be JSON and say so, which a stranger's page cannot send.

use super::access::Access;
use super::asked::Run;
use super::calibrator_side::{Handle, Order};
use super::options::Options;
use super::{assets, documents, events};
use crate::Error;
use axum::extract::{Path, Query, Request, State};
use axum::http::{HeaderValue, StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use axum::{Json, Router};
use calib_files::Error as FilesError;
use calib_logbook::{Filter, Logbook};
use calib_output::json;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Newest records that a page is given.
const RECORDS: usize = 500;

#[derive(Clone)]
struct App {
    handle: Handle,
    options: Arc<Options>,
}

pub(super) fn router(handle: Handle, access: Access, options: Options) -> Router {
    let devices = || async { said(&calib_link::port::list()) };
    assets::add(Router::new())
        .route("/api/state", get(state))
        .route("/api/events", get(changes))
        .route("/api/waveforms", get(waveforms))
        .route("/api/devices", get(devices))
        .route("/api/sensors", get(sensors))
        .route("/api/records", get(records))
        .route("/api/history/{serial}", get(history))
        .route("/api/certificate/{format}", get(last_certificate))
        .route("/api/records/{id}/certificate/{format}", get(certificate))
        .route("/api/connect", post(connect))
        .route("/api/run", post(run))
        .route("/api/stop", post(stop))
        .layer(middleware::from_fn_with_state(Arc::new(access), admit))
        .with_state(App {
            handle,
            options: Arc::new(options),
        })
}

#[derive(Deserialize)]
struct Token {
    token: Option<String>,
}

/// Limits what the page may load and who may frame it.
const OWN: &str = "default-src 'self'; frame-ancestors 'none'";

/// Lets in who may come in. The page keeps to itself: no other site frames it.
async fn admit(
    State(access): State<Arc<Access>>,
    Query(Token { token }): Query<Token>,
    request: Request,
    next: Next,
) -> Response {
    let host = request.headers().get(header::HOST);
    let host = host.and_then(|host| host.to_str().ok());
    if !assets::is_open(request.uri().path()) && !access.admits(host, token.as_deref()) {
        let why = "open the address that `calib serve` printed";
        return (StatusCode::FORBIDDEN, why).into_response();
    }
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    headers
        .entry(header::CONTENT_SECURITY_POLICY)
        .or_insert(HeaderValue::from_static(OWN));
    for (name, value) in [
        (header::CACHE_CONTROL, "no-store"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

/// A document, written like those of the verbs.
fn said(document: &impl Serialize) -> Response {
    match json::line(document) {
        Ok(text) => ([(header::CONTENT_TYPE, "application/json")], text).into_response(),
        Err(_) => StatusCode::INTERNAL_SERVER_ERROR.into_response(),
    }
}

async fn state(State(app): State<App>) -> Response {
    said(&app.handle.shared.snapshot())
}

async fn waveforms(State(app): State<App>) -> Response {
    said(&app.handle.shared.waveforms())
}

async fn changes(State(app): State<App>) -> Response {
    events::stream(app.handle.shared.clone()).into_response()
}

async fn sensors(State(app): State<App>) -> Result<Response, Failure> {
    aside(move || {
        let logbook = Logbook::open_if_there(&app.options.logbook)?;
        let sensors = logbook.map(|logbook| logbook.sensors("")).transpose()?;
        Ok(said(&sensors.unwrap_or_default()))
    })
    .await
}

async fn records(State(app): State<App>) -> Result<Response, Failure> {
    aside(move || {
        let logbook = Logbook::open_if_there(&app.options.logbook)?;
        let records = logbook.map(|logbook| logbook.records(&Filter::default()));
        let mut records = records.transpose()?.unwrap_or_default();
        records.truncate(RECORDS);
        Ok(said(&records))
    })
    .await
}

async fn history(State(app): State<App>, Path(serial): Path<String>) -> Result<Response, Failure> {
    aside(
        move || match Logbook::open_if_there(&app.options.logbook)? {
            Some(logbook) => Ok(said(&logbook.history(&serial, 160.0)?)),
            None => Ok(StatusCode::NOT_FOUND.into_response()),
        },
    )
    .await
}

async fn last_certificate(
    State(app): State<App>,
    Path(format): Path<String>,
) -> Result<Response, Failure> {
    aside(move || match app.handle.shared.record() {
        Some(stored) => document(&app, &stored, &format),
        None => Ok((StatusCode::NOT_FOUND, "no run has ended yet").into_response()),
    })
    .await
}

async fn certificate(
    State(app): State<App>,
    Path((id, format)): Path<(i64, String)>,
) -> Result<Response, Failure> {
    aside(
        move || match Logbook::open_if_there(&app.options.logbook)? {
            Some(logbook) => document(&app, &logbook.record(id)?, &format),
            None => Ok((StatusCode::NOT_FOUND, "there is no logbook").into_response()),
        },
    )
    .await
}

fn document(app: &App, stored: &[u8], format: &str) -> Result<Response, Error> {
    let options = &app.options;
    documents::certificate(stored, format, &options.particulars, &options.logbook)
}

/// Does what takes its time beside the thread that answers: a stop never waits
/// for a page being typeset.
async fn aside(
    work: impl FnOnce() -> Result<Response, Error> + Send + 'static,
) -> Result<Response, Failure> {
    let lost = |error: tokio::task::JoinError| {
        let hint = "report this as a defect";
        Error::input("request", error.to_string(), hint)
    };
    let answer = tokio::task::spawn_blocking(work).await.map_err(lost)?;
    Ok(answer?)
}

#[derive(Deserialize)]
struct Connect {
    device: String,
}

async fn connect(State(app): State<App>, Json(asked): Json<Connect>) -> StatusCode {
    if is_running(&app) {
        return StatusCode::CONFLICT;
    }
    app.handle.order(Order::Connect {
        device: asked.device,
    });
    StatusCode::ACCEPTED
}

/// Whatever else goes on: the stop is counted before this answers.
async fn stop(State(app): State<App>, Json(_): Json<serde_json::Value>) -> StatusCode {
    app.handle.stop();
    StatusCode::ACCEPTED
}

async fn run(State(app): State<App>, Json(asked): Json<Run>) -> Result<Response, Failure> {
    if is_running(&app) {
        return Ok((StatusCode::CONFLICT, "a run is going on").into_response());
    }
    // First of all: a stop from here on is meant for this run.
    let stops = app.handle.stops();
    let points = asked.points()?;
    let labels = Box::new(asked.labels(&app.options.logbook)?);
    app.handle.order(Order::Run {
        points,
        labels,
        stops,
    });
    Ok(StatusCode::ACCEPTED.into_response())
}

fn is_running(app: &App) -> bool {
    let snapshot = app.handle.shared.snapshot();
    snapshot.run.is_some_and(|run| run.running)
}

/// A failure as an answer: in words, with the way out.
struct Failure(Error);

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self(error)
    }
}

impl IntoResponse for Failure {
    fn into_response(self) -> Response {
        let status = match self.0 {
            Error::Files(FilesError::Usage { .. } | FilesError::Input { .. }) => {
                StatusCode::BAD_REQUEST
            }
            _ => StatusCode::INTERNAL_SERVER_ERROR,
        };
        let hint = self.0.hint().unwrap_or_default();
        (status, format!("{} {hint}", self.0)).into_response()
    }
}
