//! Requests: what is asked, and what is answered.
//!
//! | request | answer |
//! |---|---|
//! | `GET /` and what it names | the page |
//! | `GET /api/state` | the view |
//! | `GET /api/live` | the page's channel: the view at each change, and stops |
//! | `GET /api/waveforms` | the latest waveforms and spectra of both inputs |
//! | `GET /api/devices`, `/api/sensors`, `/api/records` | ports; the logbook |
//! | `GET /api/history/SERIAL` | drift of a sensor at 160 Hz |
//! | `GET /api/assurance`, `/api/assurance/report` | check standards and references: how each stands; the same as a page that stands alone |
//! | `GET /api/refusals?language=de` | every reason of a refusal in words, and what to do |
//! | `GET /api/judged` | results of the last run with the conformity; no certificate is issued |
//! | `GET /api/certificate/html`, `/api/records/ID/certificate/html` | certificate of the last run, or of a record of the logbook, to look at |
//! | `GET /api/certificates` | certificates that were issued, and which of them were replaced |
//! | `GET /api/amended/html?replaces=NUMBER&reason=TEXT` | what would take the place of an issued certificate, to look at |
//! | `POST` there, and to the other formats | the same issued: entered in the logbook; both take what [`Stated`] names |
//! | `POST /api/connect` | `{"device"}` |
//! | `POST /api/sensors` | what `calib sensors add` takes, or `{"teds"}` in hexadecimal: registers a sensor |
//! | `POST /api/run` | `{"sensor" or "dut_model", "dut_serial"; "operator", "mounting", "set_acceleration_rms_ms2", "temperature_c", "frequencies_hz"}` |
//! | `POST /api/stop`, here and on the port for stops | `{"run"}`: silences the exciter, and waits until the calibrator says so |
//!
//! Nothing is changed by a GET. Posts must be JSON and say so, which a stranger's page cannot send, and a
//! request that a browser says comes from another site is refused ([`super::access`]).

use super::access::{Access, Caller};
use super::asked::{NewSensor, Run};
use super::documents::{self, Stated, Wanted};
use super::handle::{Handle, Order};
use super::options::Options;
use super::stops::{Asked, NotStopped};
use super::view::{Measured, RunView};
use super::{assets, live};
use crate::assurance::{self, AssuranceReport};
use crate::{Error, assurance_report, judged, refusals};
use axum::extract::ws::WebSocketUpgrade;
use axum::extract::{DefaultBodyLimit, FromRequest, Path, Query, Request, State};
use axum::http::{HeaderValue, Method, StatusCode, header};
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
    let refusals = |Query(stated): Query<Stated>| async move {
        let language = stated.language.unwrap_or_default();
        said(&refusals::table(language))
    };
    assets::add(Router::new())
        .route("/api/state", get(state))
        .route("/api/live", get(channel))
        .route("/api/waveforms", get(waveforms))
        .route("/api/devices", get(devices))
        .route("/api/sensors", get(sensors).post(register))
        .route("/api/records", get(records))
        .route("/api/history/{serial}", get(history))
        .route("/api/assurance", get(check_standards))
        .route("/api/assurance/report", get(check_report))
        .route(
            "/api/certificate/{format}",
            get(last_certificate).post(last_certificate),
        )
        .route("/api/judged", get(judged))
        .route("/api/refusals", get(refusals))
        .route(
            "/api/records/{id}/certificate/{format}",
            get(certificate).post(certificate),
        )
        .route("/api/certificates", get(certificates))
        .route("/api/amended/{format}", get(amended).post(amended))
        .route("/api/connect", post(connect))
        .route("/api/run", post(run))
        .route("/api/stop", post(stop))
        .layer(middleware::from_fn_with_state(Arc::new(access), admit))
        .with_state(App {
            handle,
            options: Arc::new(options),
        })
}

/// Requests on the port for stops: nothing else is answered there.
pub(super) fn stops(handle: Handle, access: Access) -> Router {
    let access = Arc::new(access);
    Router::new()
        .route("/api/stop", post(stop_from_other_port))
        .layer(DefaultBodyLimit::max(live::LONGEST))
        .layer(middleware::from_fn_with_state(access, admit_stop))
        .with_state(handle)
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
    let path = request.uri().path();
    let from = Caller::of(request.headers(), token.as_deref());
    let admitted = match path {
        // A link on another site may lead here.
        "/" => access.admits(&from),
        _ => access.admits(&from) && from.is_page_itself(),
    };
    if !assets::is_open(path) && !admitted {
        return stranger();
    }
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    let own = HeaderValue::try_from(access.content_policy());
    if let Ok(own) = own {
        headers
            .entry(header::CONTENT_SECURITY_POLICY)
            .or_insert(own);
    }
    for (name, value) in [
        (header::CACHE_CONTROL, "no-store"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

/// Lets in stops of the page, which comes from another port of this host, and tells its browser so.
async fn admit_stop(
    State(access): State<Arc<Access>>,
    Query(Token { token }): Query<Token>,
    request: Request,
    next: Next,
) -> Response {
    let from = Caller::of(request.headers(), token.as_deref());
    if !access.admits_stop(&from) {
        return stranger();
    }
    let origin = request.headers().get(header::ORIGIN).cloned();
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    if let Some(origin) = origin {
        headers.insert(header::ACCESS_CONTROL_ALLOW_ORIGIN, origin);
    }
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
    response
}

fn stranger() -> Response {
    let why = "open the address that `calib serve` printed";
    (StatusCode::FORBIDDEN, why).into_response()
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

async fn channel(State(app): State<App>, upgrade: WebSocketUpgrade) -> Response {
    let upgrade = upgrade.max_message_size(live::LONGEST);
    upgrade.on_upgrade(move |page| live::talk(page, app.handle))
}

async fn sensors(State(app): State<App>) -> Result<Response, Failure> {
    aside(move || {
        let logbook = Logbook::open_if_there(&app.options.logbook)?;
        let sensors = logbook.map(|logbook| logbook.sensors("")).transpose()?;
        Ok(said(&sensors.unwrap_or_default()))
    })
    .await
}

async fn register(
    State(app): State<App>,
    Json(body): Json<serde_json::Value>,
) -> Result<Response, Failure> {
    aside(move || {
        let new = NewSensor::read(body)?;
        Ok(said(&new.register(&app.options.logbook)?))
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

async fn check_standards(State(app): State<App>) -> Result<Response, Failure> {
    aside(move || Ok(said(&assured(&app)?))).await
}

async fn check_report(State(app): State<App>) -> Result<Response, Failure> {
    aside(move || {
        let at_s = jiff::Timestamp::now().as_second();
        Ok(match assured(&app)? {
            Some(report) => documents::alone(assurance_report::html(&report, at_s)?),
            None => StatusCode::NOT_FOUND.into_response(),
        })
    })
    .await
}

/// Check standards and references as they stand now; none without a logbook.
fn assured(app: &App) -> crate::Result<Option<AssuranceReport>> {
    let logbook = Logbook::open_if_there(&app.options.logbook)?;
    let at_s = jiff::Timestamp::now().as_second();
    logbook
        .map(|logbook| assurance::report(&logbook, at_s))
        .transpose()
}

/// The last of the path is its format. A GET looks at it; a POST, which must be JSON and say so, has it issued.
impl<S: Send + Sync> FromRequest<S> for Wanted {
    type Rejection = Response;

    async fn from_request(request: Request, state: &S) -> Result<Self, Response> {
        let format = request.uri().path().rsplit('/').next();
        let format = format.unwrap_or_default().to_owned();
        let stated =
            Query::<Stated>::try_from_uri(request.uri()).map_err(IntoResponse::into_response);
        let Query(stated) = stated?;
        let issues = request.method() == Method::POST;
        if issues {
            let body = Json::<serde_json::Value>::from_request(request, state).await;
            let Json(_) = body.map_err(IntoResponse::into_response)?;
        }
        Ok(Self {
            format,
            stated,
            issues,
        })
    }
}

async fn certificates(State(app): State<App>) -> Result<Response, Failure> {
    aside(move || {
        let logbook = Logbook::open_if_there(&app.options.logbook)?;
        let issued = logbook.map(|logbook| logbook.certificates()).transpose()?;
        Ok(said(&issued.unwrap_or_default()))
    })
    .await
}

async fn amended(State(app): State<App>, wanted: Wanted) -> Result<Response, Failure> {
    aside(move || match wanted.may_be_given() {
        true => {
            let options = &app.options;
            documents::amended(&wanted, options, &app.handle.shared)
        }
        false => Ok(only_posted()),
    })
    .await
}

async fn last_certificate(State(app): State<App>, wanted: Wanted) -> Result<Response, Failure> {
    aside(move || match app.handle.shared.records().split_first() {
        Some((stored, retried)) => document(&app, stored, retried, &wanted),
        None => Ok(none_ended()),
    })
    .await
}

async fn judged(State(app): State<App>, Query(stated): Query<Stated>) -> Result<Response, Failure> {
    aside(move || match app.handle.shared.records().split_first() {
        Some(stored) => {
            let options = &app.options;
            let (files, logbook) = (&options.particulars, &options.logbook);
            Ok(said(&documents::judged(stored, &stated, files, logbook)?))
        }
        None => Ok(none_ended()),
    })
    .await
}

async fn certificate(
    State(app): State<App>,
    Path((id, _)): Path<(i64, String)>,
    wanted: Wanted,
) -> Result<Response, Failure> {
    aside(
        move || match Logbook::open_if_there(&app.options.logbook)? {
            Some(logbook) => document(&app, &logbook.record(id)?, &[], &wanted),
            None => Ok((StatusCode::NOT_FOUND, "there is no logbook").into_response()),
        },
    )
    .await
}

fn none_ended() -> Response {
    (StatusCode::NOT_FOUND, "no run has ended yet").into_response()
}

fn document(
    app: &App,
    stored: &[u8],
    retried: &[Vec<u8>],
    wanted: &Wanted,
) -> Result<Response, Error> {
    if !wanted.may_be_given() {
        return Ok(only_posted());
    }
    documents::certificate((stored, retried), wanted, &app.options, &app.handle.shared)
}

fn only_posted() -> Response {
    let why = "this is given out by POST, and entered in the logbook";
    (StatusCode::METHOD_NOT_ALLOWED, why).into_response()
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
    match app.handle.connect(asked.device) {
        true => StatusCode::ACCEPTED,
        false => StatusCode::CONFLICT,
    }
}

async fn stop(State(app): State<App>, Json(asked): Json<Asked>) -> Result<Response, NotStopped> {
    stop_and_say(app.handle, asked).await
}

/// As [`stop`]. The page comes from another port, so its browser would ask whether it may send JSON, and lose
/// time: it sends the same as plain text. Who may is told by its origin.
async fn stop_from_other_port(
    State(handle): State<Handle>,
    body: String,
) -> Result<Response, NotStopped> {
    // Whoever is let in and says STOP is understood.
    let asked = serde_json::from_str(&body).unwrap_or_default();
    stop_and_say(handle, asked).await
}

async fn stop_and_say(handle: Handle, asked: Asked) -> Result<Response, NotStopped> {
    handle.stop(asked).await?;
    Ok("stopped, the exciter is silent".into_response())
}

async fn run(State(app): State<App>, Json(asked): Json<Run>) -> Result<Response, Failure> {
    let last = app.handle.shared.snapshot().run;
    let points = asked.points(last.as_ref())?;
    // Accepted before the logbook is looked at, which may take its time: a stop meanwhile is for this run.
    let kept = last.as_ref().filter(|_| asked.retry).map(RunView::valid);
    let Some(number) = app.handle.accept_run(&points, kept) else {
        return Ok((StatusCode::CONFLICT, "a run is going on").into_response());
    };
    aside(move || {
        let shared = &app.handle.shared;
        let measured = asked.measured(&app.options.logbook, last.as_ref());
        let fitting = measured.and_then(|measured| fitting(&app.options, measured));
        let measured = fitting.inspect_err(|_| shared.not_begun("did not begin"))?;
        let labels = Box::new(measured.labels.clone());
        shared.change_run(|run| {
            run.dut_serial = labels.dut_serial.to_string();
            run.unit = measured.kind.unit().name();
            run.measured = measured;
        });
        app.handle.order(Order::Run {
            number,
            points,
            labels,
        });
        Ok(StatusCode::ACCEPTED.into_response())
    })
    .await
}

/// A kind of sensor that the files of the laboratory cannot judge afterwards is named before anything moves.
fn fitting(options: &Options, measured: Measured) -> Result<Measured, Error> {
    if !measured.kind.is_as_measured() {
        let logbook = Logbook::open_if_there(&options.logbook)?;
        judged::particulars(&options.particulars, &measured.labels, logbook.as_ref())?;
    }
    Ok(measured)
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
        (status, self.0.with_hint()).into_response()
    }
}
