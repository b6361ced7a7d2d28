//! Requests: what is asked, and what is answered.
//!
//! | request | answer |
//! |---|---|
//! | `GET /`, `/style.css`, `/page.js` | the page |
//! | `GET /api/state`, `/api/events` | the view; its changes |
//! | `GET /api/devices`, `/api/sensors`, `/api/records` | ports; the bench |
//! | `GET /api/history/SERIAL` | drift of a sensor at 160 Hz |
//! | `GET /api/certificate/FORMAT` | certificate of the last run |
//! | `POST /api/connect` | `{"device"}` |
//! | `POST /api/run` | `{"sensor" or "model", "serial"; "operator", "mounting", "level_ms2", "frequencies_hz"}` |
//! | `POST /api/stop` | silences the exciter |
//!
//! What is posted is JSON and says so, which a page of a stranger cannot send.

use super::access::Access;
use super::bench_side::{Handle, Order};
use super::{Snapshot, events};
use crate::bench::{Bench, Filter, Sensor};
use crate::certificate::{self, Certificate, Format, Language, Particulars};
use crate::{Error, session};
use axum::extract::{Path, Query, Request, State};
use axum::http::{StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use axum::{Json, Router};
use calib_core::point::PointSpec;
use calib_protocol::record::RunLabels;
use serde::Deserialize;
use std::path::PathBuf;
use std::sync::Arc;

const PAGE: &str = include_str!("page/index.html");
const STYLE: &str = include_str!("page/style.css");
const SCRIPT: &str = include_str!("page/page.js");

#[derive(Clone)]
struct App {
    handle: Handle,
    bench: Arc<PathBuf>,
}

pub(super) fn router(handle: Handle, access: Access, bench: PathBuf) -> Router {
    let text = |kind: &'static str, text: &'static str| {
        get(move || async move { ([(header::CONTENT_TYPE, kind)], text) })
    };
    Router::new()
        .route("/", text("text/html; charset=utf-8", PAGE))
        .route("/style.css", text("text/css", STYLE))
        .route("/page.js", text("text/javascript", SCRIPT))
        .route("/api/state", get(state))
        .route("/api/events", get(changes))
        .route(
            "/api/devices",
            get(|| async { Json(crate::link::port::list()) }),
        )
        .route("/api/sensors", get(sensors))
        .route("/api/records", get(records))
        .route("/api/history/{serial}", get(history))
        .route("/api/certificate/{format}", get(certificate_file))
        .route("/api/connect", post(connect))
        .route("/api/run", post(run))
        .route("/api/stop", post(stop))
        .layer(middleware::from_fn_with_state(Arc::new(access), admit))
        .with_state(App {
            handle,
            bench: Arc::new(bench),
        })
}

#[derive(Deserialize)]
struct Token {
    token: Option<String>,
}

/// Lets in who may come in. The page keeps to itself: no other site frames it.
async fn admit(
    State(access): State<Arc<Access>>,
    Query(Token { token }): Query<Token>,
    request: Request,
    next: Next,
) -> Response {
    let host = request.headers().get(header::HOST);
    let host = host.and_then(|host| host.to_str().ok());
    // Style and script hold nothing of anybody's, and links to them no token.
    let open = matches!(request.uri().path(), "/style.css" | "/page.js");
    if !open && !access.admits(host, token.as_deref()) {
        let why = "open the address that `calib serve` printed";
        return (StatusCode::FORBIDDEN, why).into_response();
    }
    let mut response = next.run(request).await;
    let own = "default-src 'self'; frame-ancestors 'none'";
    for (name, value) in [
        (header::CONTENT_SECURITY_POLICY, own),
        (header::CACHE_CONTROL, "no-store"),
        (header::REFERRER_POLICY, "no-referrer"),
    ] {
        response
            .headers_mut()
            .insert(name, header::HeaderValue::from_static(value));
    }
    response
}

async fn state(State(app): State<App>) -> Json<Snapshot> {
    Json(app.handle.shared.snapshot())
}

async fn changes(State(app): State<App>) -> Response {
    events::stream(app.handle.shared.clone()).into_response()
}

async fn sensors(State(app): State<App>) -> Result<Response, Failure> {
    let sensors = match Bench::open_if_there(&app.bench)? {
        Some(bench) => bench.sensors("")?,
        None => Vec::new(),
    };
    Ok(Json(sensors).into_response())
}

async fn records(State(app): State<App>) -> Result<Response, Failure> {
    let records = match Bench::open_if_there(&app.bench)? {
        Some(bench) => bench.records(&Filter::default())?,
        None => Vec::new(),
    };
    Ok(Json(records).into_response())
}

async fn history(State(app): State<App>, Path(serial): Path<String>) -> Result<Response, Failure> {
    match Bench::open_if_there(&app.bench)? {
        Some(bench) => Ok(Json(bench.history(&serial, 160.0)?).into_response()),
        None => Ok(StatusCode::NOT_FOUND.into_response()),
    }
}

async fn certificate_file(
    State(app): State<App>,
    Path(format): Path<String>,
) -> Result<Response, Failure> {
    let Some(bytes) = app.handle.shared.record() else {
        return Ok((StatusCode::NOT_FOUND, "no run has ended yet").into_response());
    };
    let unknown = |problem: String| Error::Usage {
        problem,
        hint: String::new(),
    };
    let format: Format = format.parse().map_err(unknown)?;
    let record = calib_protocol::record::decode(&bytes)
        .map_err(|error| Error::input("record", error.to_string(), "run once more"))?;
    let certificate = Certificate::from_record(&record, &Particulars::default());
    let content = certificate::render(&certificate, format, Language::default())?;
    let (kind, shown) = match format.name() {
        "html" => ("text/html; charset=utf-8", "inline"),
        "pdf" => ("application/pdf", "inline"),
        "json" => ("application/json", "attachment"),
        "csv" => ("text/csv; charset=utf-8", "attachment"),
        _ => ("application/octet-stream", "attachment"),
    };
    let name = format!("{shown}; filename=\"certificate.{}\"", format.name());
    Ok((
        [
            (header::CONTENT_TYPE, kind.to_owned()),
            (header::CONTENT_DISPOSITION, name),
        ],
        content,
    )
        .into_response())
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

#[derive(Deserialize)]
#[serde(default)]
struct Run {
    sensor: String,
    model: String,
    serial: String,
    operator: String,
    mounting: String,
    level_ms2: f32,
    frequencies_hz: Vec<f32>,
}

impl Default for Run {
    fn default() -> Self {
        Self {
            sensor: String::new(),
            model: String::new(),
            serial: String::new(),
            operator: String::new(),
            mounting: String::new(),
            level_ms2: 10.0,
            frequencies_hz: Vec::new(),
        }
    }
}

async fn run(State(app): State<App>, Json(asked): Json<Run>) -> Result<Response, Failure> {
    if is_running(&app) {
        return Ok((StatusCode::CONFLICT, "a run is going on").into_response());
    }
    // First of all: a stop from here on is meant for this run.
    let stops = app.handle.stops();
    let points = asked.points()?;
    let labels = Box::new(asked.labels(&app)?);
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

impl Run {
    fn points(&self) -> Result<Vec<PointSpec>, Error> {
        let usable = |value: f32| value.is_finite() && value > 0.0;
        let all = self.frequencies_hz.iter().copied().all(usable);
        if !usable(self.level_ms2) || !all {
            return Err(Error::Usage {
                problem: "frequencies and level are numbers above zero".to_owned(),
                hint: String::new(),
            });
        }
        if self.frequencies_hz.is_empty() {
            return Ok(session::default_points(self.level_ms2));
        }
        let point = |frequency_hz: &f32| PointSpec {
            frequency_hz: *frequency_hz,
            acceleration_rms_ms2: self.level_ms2,
        };
        Ok(self.frequencies_hz.iter().map(point).collect())
    }

    /// A sensor of the bench by its serial number, or what was typed.
    fn labels(&self, app: &App) -> Result<RunLabels, Error> {
        let known = match (self.sensor.as_str(), Bench::open_if_there(&app.bench)?) {
            ("", _) | (_, None) => Sensor {
                serial: self.serial.clone(),
                model: self.model.clone(),
                ..Sensor::default()
            },
            (serial, Some(bench)) => bench.known_sensor(serial)?,
        };
        let mounting = match self.mounting.as_str() {
            "" => known.mounting.clone().unwrap_or_default(),
            stated => stated.to_owned(),
        };
        Ok(RunLabels {
            unix_time_s: u64::try_from(jiff::Timestamp::now().as_second()).unwrap_or(0),
            dut_model: label("model", &known.name())?,
            dut_serial: label("serial number", &known.serial)?,
            operator: label("operator", &self.operator)?,
            temperature_centi_c: None,
            mounting: label("mounting", &mounting)?,
        })
    }
}

fn label<const N: usize>(what: &str, text: &str) -> Result<heapless::String<N>, Error> {
    text.try_into().map_err(|_| Error::Usage {
        problem: format!("{what} has room for {N} bytes, this is {}", text.len()),
        hint: String::new(),
    })
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
            Error::Usage { .. } | Error::Input { .. } => StatusCode::BAD_REQUEST,
            _ => StatusCode::INTERNAL_SERVER_ERROR,
        };
        let hint = self.0.hint().unwrap_or_default();
        (status, format!("{} {hint}", self.0)).into_response()
    }
}
