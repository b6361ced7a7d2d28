//! From a request to its answer.
//!
//! Every request that can be read gets exactly one answer; what is done lies
//! behind [`Instrument`], which the tasks implement on the board.

use calib_core::point::{PointResult, PointSpec};
use calib_core::points::possible;
use calib_core::self_test::{Line, MAX_LINES};
use calib_core::settings::Settings;
use calib_protocol::capture::CapturePart;
use calib_protocol::health::{Defect, Health};
use calib_protocol::lists::{KeptList, ListChange};
use calib_protocol::message::{
    Info, RECORD_CHUNK, Refusal, Request, Response, RunSpec, SettingsChange, Status,
};
use calib_protocol::record::{RecordSummary, RunLabels};
use calib_protocol::signature::DeviceKey;
use calib_protocol::update::{RunningImage, UpdateStep};
use heapless::Vec;

/// Part of a stored record.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordPart {
    /// Length of the whole record, in bytes.
    pub total: u32,
    /// Bytes from the offset asked for.
    pub data: Vec<u8, RECORD_CHUNK>,
}

/// A page of the record list.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordPage {
    /// Summaries in rising running number.
    pub records: Vec<RecordSummary, 16>,
    /// True when there are more.
    pub more: bool,
}

/// Commands of a host to the calibrator.
// Both ends are in this crate and run on one executor: no `Send` is needed.
#[allow(async_fn_in_trait)]
pub trait Instrument {
    /// Whether this host may ask for this now ([`crate::session`]).
    fn admit(&mut self, request: &Request) -> Result<(), Refusal>;
    /// Identity and health.
    fn info(&mut self) -> Info;
    /// Defects, and what the instrument went through.
    fn health(&mut self) -> Health;
    /// Asks for the state.
    fn status(&mut self) -> Status;
    /// Result of a point of the running or last run.
    fn point(&mut self, index: u16) -> Option<PointResult>;
    /// Begins a run and returns the running number of its record.
    async fn start(&mut self, spec: RunSpec) -> Result<u32, Refusal>;
    /// Ends the run, if there is one, and returns when the exciter is at rest.
    async fn stop(&mut self) -> Result<(), Refusal>;
    /// As [`Self::stop`], if the run that goes on is that of this record.
    async fn stop_run(&mut self, record_id: u32) -> Result<(), Refusal>;
    /// Stored records from a running number on.
    async fn records(&mut self, from: u32) -> Result<RecordPage, Refusal>;
    /// Bytes of a stored record.
    async fn read_record(&mut self, id: u32, offset: u32) -> Result<RecordPart, Refusal>;
    /// Lets records up to this number make room.
    async fn release(&mut self, through: u32) -> Result<(), Refusal>;
    /// Waits until what is stored has been read, so that no default is told for it.
    ///
    /// # Errors
    /// [`Refusal::Busy`] after some seconds.
    async fn ready(&mut self) -> Result<(), Refusal> {
        Ok(())
    }
    /// The settings in force.
    fn settings(&mut self) -> Settings;
    /// Captures sample pairs from the next block on.
    fn capture(&mut self, pairs: u16) -> Result<(), Refusal>;
    /// Pairs of the capture, or how far it is.
    fn read_capture(&mut self, offset: u16) -> Result<CapturePart, Refusal>;
    /// Tests the board, with the table at rest.
    async fn self_test(&mut self) -> Result<Vec<Line, MAX_LINES>, Refusal>;
    /// Whether a hand is on the button. That was what its press was for: letting go has no effect.
    fn button_held(&mut self) -> bool;
    /// The public key, once there is one.
    async fn key(&mut self) -> Result<Option<DeviceKey>, Refusal>;
    /// Makes the key.
    async fn make_key(&mut self) -> Result<(), Refusal>;
    /// Logs new settings and takes them into force.
    async fn change_settings(&mut self, change: &SettingsChange) -> Result<(), Refusal>;
    /// The image that runs; none where no loader has checked it.
    fn image(&mut self) -> Option<RunningImage>;
    /// Carries out a step of an update; `older_allowed` where a hand allows an image that is older.
    fn update(&mut self, step: &UpdateStep, older_allowed: bool) -> Result<(), Refusal>;
    /// The list at this place, from 0.
    async fn list(&mut self, place: u8) -> Result<Option<KeptList>, Refusal>;
    /// Changes the lists, if they are not so already; `held` where a hand allows it.
    async fn change_lists(&mut self, change: &ListChange, held: bool) -> Result<(), Refusal>;
    /// Takes the time a host tells; 0 is none.
    fn tell_time(&mut self, unix_time_s: u64);
}

/// Carries out `request`; a reset is left to the caller, who answers first.
pub async fn answer(request: Request, instrument: &mut impl Instrument) -> Response {
    carry_out(request, instrument)
        .await
        .unwrap_or_else(Response::Refused)
}

async fn carry_out(
    request: Request,
    instrument: &mut impl Instrument,
) -> Result<Response, Refusal> {
    instrument.admit(&request)?;
    Ok(match request {
        Request::Info => Response::Info(instrument.info()),
        Request::Status => Response::Status(instrument.status()),
        Request::Point { index } => Response::Point {
            index,
            result: instrument.point(index),
        },
        Request::Start(spec) => {
            check_points(&spec)?;
            check_conditions(&spec.labels)?;
            instrument.ready().await?;
            check_possible(&spec, instrument)?;
            let record_id = instrument.start(spec).await?;
            Response::Started { record_id }
        }
        Request::Stop => {
            instrument.stop().await?;
            Response::Done
        }
        Request::StopRun { record_id } => {
            instrument.stop_run(record_id).await?;
            Response::Done
        }
        Request::Records { from } => {
            let RecordPage { records, more } = instrument.records(from).await?;
            Response::Records { records, more }
        }
        Request::ReadRecord { id, offset } => {
            let RecordPart { total, data } = instrument.read_record(id, offset).await?;
            Response::RecordData {
                id,
                offset,
                total,
                data,
            }
        }
        Request::SettingsRead => {
            instrument.ready().await?;
            Response::Settings(instrument.settings())
        }
        Request::SettingsWrite(change) => {
            write_settings(&change, instrument).await?;
            Response::Done
        }
        Request::Reset => Response::Done,
        Request::Release { through } => {
            instrument.release(through).await?;
            Response::Done
        }
        Request::Capture { pairs } => {
            instrument.capture(pairs)?;
            Response::Done
        }
        Request::ReadCapture { offset } => Response::CaptureData(instrument.read_capture(offset)?),
        Request::Health => Response::Health(instrument.health()),
        Request::SelfTest => Response::SelfTest {
            lines: instrument.self_test().await?,
        },
        Request::Key => Response::Key(instrument.key().await?),
        Request::MakeKey => {
            make_key(instrument).await?;
            Response::Key(instrument.key().await?)
        }
        Request::Image => Response::Image(instrument.image()),
        Request::Update(step) => {
            update(&step, instrument)?;
            Response::Done
        }
        Request::List { place } => {
            instrument.ready().await?;
            Response::List(instrument.list(place).await?)
        }
        Request::ChangeLists(change) => {
            change_lists(&change, instrument).await?;
            Response::Done
        }
        Request::Clock { unix_time_s } => {
            instrument.tell_time(unix_time_s);
            Response::Done
        }
    })
}

/// The key of an instrument is made once, under a hand.
async fn make_key(instrument: &mut impl Instrument) -> Result<(), Refusal> {
    // Asked first: a press for a key that is there already is no tap either.
    let held = instrument.button_held();
    if instrument.key().await?.is_some() {
        return Err(Refusal::KeyExists);
    }
    match held {
        true => instrument.make_key().await,
        false => Err(Refusal::ButtonNotHeld),
    }
}

/// The exciter rests during an update, which holds the core up. A hand is asked for where an update begins:
/// its press is then no tap.
fn update(step: &UpdateStep, instrument: &mut impl Instrument) -> Result<(), Refusal> {
    if instrument.status().state.is_running() {
        return Err(Refusal::Busy);
    }
    let begins = matches!(step, UpdateStep::Begin { .. });
    let older_allowed = begins && instrument.button_held();
    instrument.update(step, older_allowed)
}

/// Changes the lists. The lamps judge by a list: it changes only with a hand on the button, as settings do.
pub async fn change_lists(
    change: &ListChange,
    instrument: &mut impl Instrument,
) -> Result<(), Refusal> {
    if !change.is_usable() {
        return Err(Refusal::List);
    }
    if let ListChange::Store(list) = change {
        let (settings, sample_rate_hz) = (instrument.settings(), instrument.info().sample_rate_hz);
        check_list(&list.points, &settings, sample_rate_hz)?;
    }
    // Asked first: a short press for what is so already is no tap either.
    let held = instrument.button_held();
    instrument.change_lists(change, held).await
}

/// There is no setting that shapes neither a result, nor its uncertainty, nor a
/// limit: each changes only under a hand on the instrument, and leaves a record.
/// Whoever sends the same again is told that it is done. Where the stored ones
/// cannot be read, any other may be a change.
async fn write_settings(
    change: &SettingsChange,
    instrument: &mut impl Instrument,
) -> Result<(), Refusal> {
    change.settings.validate().map_err(|_| Refusal::Settings)?;
    let known = !instrument.health().defects.has(Defect::Settings);
    // Asked first: a short press for settings that are there already is no tap either.
    let held = instrument.button_held();
    if known && change.settings == instrument.settings() {
        return Ok(());
    }
    match held {
        true => instrument.change_settings(change).await,
        false => Err(Refusal::ButtonNotHeld),
    }
}

/// Temperatures of a transducer that are no slip of the pen, hundredths of a degree Celsius: what
/// accelerometers are made for, -55 to 200 degrees.
const TEMPERATURES_CENTI_C: core::ops::RangeInclusive<i16> = -5_500..=20_000;

/// Whether conditions an operator says for one run can be true.
fn check_conditions(labels: &RunLabels) -> Result<(), Refusal> {
    match labels.temperature_centi_c {
        Some(stated) if !TEMPERATURES_CENTI_C.contains(&stated) => Err(Refusal::Conditions),
        _ if !labels.is_plain() => Err(Refusal::Conditions),
        _ => Ok(()),
    }
}

/// Whether every point of a run can be measured. Broadband excitation moves points to its lines, at a level of all of them.
fn check_possible(spec: &RunSpec, instrument: &mut impl Instrument) -> Result<(), Refusal> {
    if spec.excitation.is_broadband() {
        return Ok(());
    }
    let (settings, sample_rate_hz) = (instrument.settings(), instrument.info().sample_rate_hz);
    check_list(&spec.points, &settings, sample_rate_hz)
}

/// Whether every point of a list can be measured, so that none moves the table before another is refused.
pub fn check_list(
    points: &[PointSpec],
    settings: &Settings,
    sample_rate_hz: f32,
) -> Result<(), Refusal> {
    for (index, point) in points.iter().enumerate() {
        possible(*point, settings, sample_rate_hz).map_err(|reason| Refusal::PointImpossible {
            // A list has 200 points at most.
            index: index as u16,
            reason,
        })?;
    }
    Ok(())
}

/// Whether every value of a list is finite and positive, and there is one; a
/// broadband run has one level.
fn check_points(spec: &RunSpec) -> Result<(), Refusal> {
    let points = &spec.points;
    let level = points.first().map(|point| point.acceleration_rms_ms2);
    let one_level = !spec.excitation.is_broadband()
        || points
            .iter()
            .all(|point| Some(point.acceleration_rms_ms2) == level);
    let all = points.iter().all(PointSpec::is_usable);
    if points.is_empty() || !all || !one_level {
        return Err(Refusal::PointList);
    }
    Ok(())
}
