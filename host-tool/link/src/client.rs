//! Requests and answers over any transport. Words of a device are words of one line each
//! ([`calib_protocol::text`]), and a point without numbers is no result.

use super::exchange::{Exchange, Failure};
use super::{ProtocolError, Refused, StopSwitch, Transport};
use crate::{Error, Result};
use calib_core::point::PointResult;
use calib_core::self_test::Line;
use calib_core::settings::Settings;
use calib_core::stored_list::MAX_LISTS;
use calib_protocol::capture::CapturePart;
use calib_protocol::frame::PROTOCOL_VERSION;
use calib_protocol::health::Health;
use calib_protocol::lists::{KeptList, ListChange, tame_terms};
use calib_protocol::message::{Info, Refusal, Request, Response, RunSpec, SettingsChange, Status};
use calib_protocol::record::RecordSummary;
use calib_protocol::signature::DeviceKey;
use calib_protocol::text::tame;
use calib_protocol::update::{RunningImage, UpdateStep};
use std::time::Duration;

/// More records than any flash holds: a device that lists more goes on for ever.
const MOST_RECORDS: usize = 10_000;

/// How patient a client is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RetryPolicy {
    /// Times a request is sent before giving up.
    pub attempts: u32,
    /// Longest wait for an answer. A record chunk takes 0.1 s at 115 200 baud.
    pub answer_timeout: Duration,
    /// Time limit of requests that may erase a flash sector (4 s at most,
    /// STM32H743 data sheet DS12110, table "Flash memory programming").
    pub flash_timeout: Duration,
}

impl Default for RetryPolicy {
    fn default() -> Self {
        Self {
            attempts: 4,
            answer_timeout: Duration::from_secs(1),
            flash_timeout: Duration::from_secs(6),
        }
    }
}

/// A conversation with one calibrator.
///
/// Every call sends a request, repeats it when the answer is damaged or missing,
/// and returns the answer's content.
///
/// # Errors
/// All calls: [`Error::Link`] when bytes do not get through, [`Error::Protocol`]
/// when the peers do not understand each other, [`Error::Refused`] when the
/// calibrator declines.
pub struct Client {
    exchange: Exchange,
    policy: RetryPolicy,
    /// Time to be told once the calibrator has said who it is, s since 1970.
    telling_unix_time_s: u64,
}

/// Part of a stored record.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chunk {
    /// Length of the whole record, bytes.
    pub total: u32,
    /// Bytes from the offset asked for.
    pub data: Vec<u8>,
}

impl Client {
    /// A client over an open transport, with the default patience.
    pub fn new(transport: Box<dyn Transport>) -> Self {
        Self::with_policy(transport, RetryPolicy::default())
    }

    /// A client with its own patience.
    pub fn with_policy(transport: Box<dyn Transport>, policy: RetryPolicy) -> Self {
        Self {
            exchange: Exchange::new(transport),
            policy,
            telling_unix_time_s: 0,
        }
    }

    /// From now on this switch is looked at all the time: a stop goes ahead of any answer that is waited
    /// for, and of any run that is to begin. Then [`Error::Stopped`] is what a start returns.
    #[must_use]
    pub fn heeding(mut self, stop: StopSwitch) -> Self {
        self.heed(stop);
        self
    }

    /// [`Self::heeding`], for a client that is there already.
    pub fn heed(&mut self, stop: StopSwitch) {
        self.exchange.heed(stop);
    }

    /// Tells the calibrator this time, seconds since 1970-01-01 UTC, once it has said who it is: runs that a tap of
    /// its button begins are dated by it.
    #[must_use]
    pub fn telling(mut self, unix_time_s: u64) -> Self {
        self.telling_unix_time_s = unix_time_s;
        self
    }

    /// Passes a stop on now, if one waits on the switch; whether one did.
    pub fn pass_stop(&mut self) -> Result<bool> {
        let passed = self.exchange.pass_stop();
        passed.map_err(|failure| explained(failure, "to stop"))
    }

    /// Sets the number of the first request to the one after `sequence` instead
    /// of one by chance: what is sent is then the same in every run of a test.
    #[must_use]
    pub fn counting_from(mut self, sequence: u16) -> Self {
        self.exchange.count_from(sequence);
        self
    }

    /// Address of the calibrator, for messages.
    pub fn name(&self) -> String {
        self.exchange.name()
    }

    /// Lets time pass (virtual time, if the calibrator lives in it).
    pub fn wait(&mut self, duration: Duration) -> Result<()> {
        let waited = self.exchange.wait(duration);
        waited.map_err(|failure| explained(failure, "to wait"))
    }

    /// Repetitions of requests so far: 0 on a good link.
    pub fn repetitions(&self) -> u64 {
        self.exchange.repetitions()
    }

    /// Identity and health, and the check that both speak the same version.
    pub fn info(&mut self) -> Result<Info> {
        match self.ask("its identity", &Request::Info)? {
            Response::Info(mut info) if info.protocol_version == PROTOCOL_VERSION => {
                tame(&mut info.firmware_version);
                tame(&mut info.git_hash);
                tame(&mut info.serial);
                info.last_panic.iter_mut().for_each(tame);
                self.tell_time()?;
                Ok(info)
            }
            Response::Info(info) => Err(Error::Protocol(ProtocolError::Version {
                device: info.protocol_version,
            })),
            _ => Err(unexpected("its identity")),
        }
    }

    /// Tells the time there is to be told, once. A release that takes none is as good.
    fn tell_time(&mut self) -> Result<()> {
        let unix_time_s = core::mem::take(&mut self.telling_unix_time_s);
        if unix_time_s == 0 {
            return Ok(());
        }
        match self.ask("the time", &Request::Clock { unix_time_s }) {
            Ok(_) | Err(Error::Refused(_)) => Ok(()),
            Err(error) => Err(error),
        }
    }

    /// Defects of the instrument, and what it went through; none from a release that does not
    /// know the question.
    pub fn health(&mut self) -> Result<Option<Health>> {
        match self.ask("its health", &Request::Health) {
            Ok(Response::Health(mut health)) => {
                health.restarts.iter_mut().for_each(tame);
                Ok(Some(health))
            }
            Err(Error::Refused(refused)) if refused.refusal == Refusal::Unknown => Ok(None),
            Ok(_) => Err(unexpected("its health")),
            Err(error) => Err(error),
        }
    }

    /// State of the calibrator.
    pub fn status(&mut self) -> Result<Status> {
        match self.ask("its status", &Request::Status)? {
            Response::Status(status) => Ok(status),
            _ => Err(unexpected("its status")),
        }
    }

    /// Result of one point of the running or last run, when it is there.
    pub fn point(&mut self, index: u16) -> Result<Option<PointResult>> {
        match self.ask("a point", &Request::Point { index })? {
            Response::Point {
                index: of,
                mut result,
            } if of == index => {
                result
                    .iter_mut()
                    .for_each(PointResult::refuse_without_result);
                Ok(result)
            }
            _ => Err(unexpected("a point")),
        }
    }

    /// Starts a run; returns the running number its record will have.
    pub fn start(&mut self, spec: RunSpec) -> Result<u32> {
        match self.ask("to start a run", &Request::Start(spec))? {
            Response::Started { record_id } => Ok(record_id),
            _ => Err(unexpected("to start a run")),
        }
    }

    /// From now on stops are for the run whose record has this number, and one that comes late ends no
    /// other; with none they are for whatever goes on.
    pub fn stop_for(&mut self, run: Option<u32>) {
        self.exchange.stop_for(run);
    }

    /// Silences the exciter and ends the run, if there is one ([`Self::stop_for`]).
    pub fn stop(&mut self) -> Result<()> {
        let RetryPolicy {
            attempts,
            answer_timeout,
            ..
        } = self.policy;
        let stopped = self.exchange.stop_now(answer_timeout, attempts);
        stopped.map_err(|failure| explained(failure, "to stop"))
    }

    /// Summaries of all stored records, in rising running number.
    pub fn records(&mut self) -> Result<Vec<RecordSummary>> {
        let mut all: Vec<RecordSummary> = Vec::new();
        let mut from = 0;
        loop {
            let (records, more) = self.page(from)?;
            all.extend(records);
            let last = all.last().map_or(u32::MAX, |last| last.id);
            if !more || last == u32::MAX {
                return Ok(all);
            }
            if all.len() > MOST_RECORDS {
                return Err(unexpected("its records"));
            }
            from = last + 1;
        }
    }

    /// Summaries of the stored records from a running number on: at most 16, and
    /// whether there are more.
    pub fn page(&mut self, from: u32) -> Result<(Vec<RecordSummary>, bool)> {
        let Response::Records { mut records, more } =
            self.ask("its records", &Request::Records { from })?
        else {
            return Err(unexpected("its records"));
        };
        // Numbers must rise, or a broken device would keep us here for ever.
        let numbers = || records.iter().map(|record| record.id);
        let rise = numbers().is_sorted_by(|a, b| a < b);
        if !rise || numbers().next().is_some_and(|first| first < from) {
            return Err(unexpected("its records"));
        }
        records
            .iter_mut()
            .for_each(|record| tame(&mut record.dut_serial));
        Ok((records.to_vec(), more))
    }

    /// Bytes of a stored record from `offset` on; none at its end.
    pub fn read_record(&mut self, id: u32, offset: u32) -> Result<Chunk> {
        match self.ask("a record", &Request::ReadRecord { id, offset })? {
            Response::RecordData {
                id: of,
                offset: at,
                total,
                data,
            } if of == id && at == offset => Ok(Chunk {
                total,
                data: data.to_vec(),
            }),
            _ => Err(unexpected("a record")),
        }
    }

    /// Says that records up to `through` are kept by the host: the oldest make
    /// room when the record area is full.
    pub fn release(&mut self, through: u32) -> Result<()> {
        let request = Request::Release { through };
        self.done("to release records", &request, self.policy.flash_timeout)
    }

    /// The settings in force.
    pub fn settings(&mut self) -> Result<Settings> {
        match self.ask("its settings", &Request::SettingsRead)? {
            Response::Settings(mut settings) => {
                tame(&mut settings.reference.serial);
                tame(&mut settings.reference.certificate);
                Ok(settings)
            }
            _ => Err(unexpected("its settings")),
        }
    }

    /// Replaces the settings; they are stored in flash, which needs the button held on the
    /// instrument.
    pub fn write_settings(&mut self, change: impl Into<SettingsChange>) -> Result<()> {
        let request = Request::SettingsWrite(change.into());
        self.done("new settings", &request, self.policy.flash_timeout)
    }

    /// Asks for `pairs` consecutive sample pairs from the next block on, at most
    /// [`MAX_CAPTURE_PAIRS`](calib_protocol::capture::MAX_CAPTURE_PAIRS). What was
    /// captured before is forgotten. [`crate::capture`] does all of it.
    pub fn capture(&mut self, pairs: u16) -> Result<()> {
        let request = Request::Capture { pairs };
        self.done("to capture", &request, self.policy.answer_timeout)
    }

    /// Pairs of the capture from `offset` on, none before all are taken or at
    /// the end.
    pub fn read_capture(&mut self, offset: u16) -> Result<CapturePart> {
        match self.ask("a capture", &Request::ReadCapture { offset })? {
            Response::CaptureData(part) if part.offset == offset => Ok(part),
            _ => Err(unexpected("a capture")),
        }
    }

    /// Tests the board, with the table at rest: what was looked at, with its limits.
    pub fn self_test(&mut self) -> Result<Vec<Line>> {
        // It looks at the record area, which may be busy.
        let timeout = self.policy.flash_timeout;
        match self.ask_within("a self-test", &Request::SelfTest, timeout)? {
            Response::SelfTest { lines } => Ok(lines.to_vec()),
            _ => Err(unexpected("a self-test")),
        }
    }

    /// The public key of the instrument; none where it signs nothing, be it because its release cannot.
    pub fn key(&mut self) -> Result<Option<DeviceKey>> {
        match self.ask("its key", &Request::Key) {
            Ok(Response::Key(key)) => Ok(key),
            Ok(_) => Err(unexpected("its key")),
            Err(Error::Refused(refused)) if refused.refusal == Refusal::Unknown => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Makes the key of the instrument, under a hand; it signs every record from then on.
    pub fn make_key(&mut self) -> Result<DeviceKey> {
        let timeout = self.policy.flash_timeout;
        match self.ask_within("to make its key", &Request::MakeKey, timeout)? {
            Response::Key(Some(key)) => Ok(key),
            _ => Err(unexpected("to make its key")),
        }
    }

    /// The image that runs; none where no loader has checked it, be it because its release knows of none.
    pub fn image(&mut self) -> Result<Option<RunningImage>> {
        match self.ask("its image", &Request::Image) {
            Ok(Response::Image(image)) => Ok(image),
            Ok(_) => Err(unexpected("its image")),
            Err(Error::Refused(refused)) if refused.refusal == Refusal::Unknown => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// [`Self::image`] of an instrument that is to be updated.
    pub fn running_image(&mut self) -> Result<RunningImage> {
        let no_loader = Error::Refused(Refused {
            request: "an update",
            refusal: Refusal::NoLoader,
        });
        self.image()?.ok_or(no_loader)
    }

    /// Carries out a step of an update; [`crate::session::update`] does all of it.
    pub fn update(&mut self, step: &UpdateStep) -> Result<()> {
        let request = Request::Update(step.clone());
        // A block may wait for the erase of its sector.
        self.done("an update", &request, self.policy.flash_timeout)
    }

    /// The lists kept on the instrument, in its order; none of a release that keeps none.
    pub fn lists(&mut self) -> Result<Vec<KeptList>> {
        let mut lists = Vec::new();
        for place in 0..MAX_LISTS as u8 {
            match self.ask("its lists", &Request::List { place }) {
                Ok(Response::List(Some(mut kept))) => {
                    tame_terms(&mut kept.list.terms);
                    lists.push(kept);
                }
                Ok(Response::List(None)) => break,
                Err(Error::Refused(refused)) if refused.refusal == Refusal::Unknown => break,
                Ok(_) => return Err(unexpected("its lists")),
                Err(error) => return Err(error),
            }
        }
        Ok(lists)
    }

    /// Stores, removes or chooses a list, which needs the button held on the instrument.
    pub fn change_lists(&mut self, change: &ListChange) -> Result<()> {
        let request = Request::ChangeLists(change.clone());
        self.done("to change its lists", &request, self.policy.flash_timeout)
    }

    /// Resets the board. It answers before it does.
    pub fn reset(&mut self) -> Result<()> {
        self.done("to reset", &Request::Reset, self.policy.answer_timeout)
    }

    fn done(&mut self, what: &'static str, request: &Request, timeout: Duration) -> Result<()> {
        match self.ask_within(what, request, timeout)? {
            Response::Done => Ok(()),
            _ => Err(unexpected(what)),
        }
    }

    fn ask(&mut self, what: &'static str, request: &Request) -> Result<Response> {
        self.ask_within(what, request, self.policy.answer_timeout)
    }

    fn ask_within(
        &mut self,
        what: &'static str,
        request: &Request,
        timeout: Duration,
    ) -> Result<Response> {
        match self
            .exchange
            .request(request, timeout, self.policy.attempts)
        {
            Ok(Response::Refused(refusal)) => Err(Error::Refused(Refused {
                request: what,
                refusal,
            })),
            Ok(response) => Ok(response),
            Err(failure) => Err(explained(failure, what)),
        }
    }
}

fn explained(failure: Failure, what: &'static str) -> Error {
    match failure {
        Failure::Link(error) => Error::Link(error),
        Failure::Stopped => Error::Stopped,
        Failure::Refused(refusal) => Error::Refused(Refused {
            request: "to stop",
            refusal,
        }),
        Failure::Unreadable {
            version: Some(device),
        } if device != PROTOCOL_VERSION => Error::Protocol(ProtocolError::Version { device }),
        Failure::Unreadable { .. } => unexpected(what),
    }
}

fn unexpected(request: &'static str) -> Error {
    Error::Protocol(ProtocolError::UnexpectedAnswer { request })
}
