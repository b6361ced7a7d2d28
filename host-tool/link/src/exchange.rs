//! One request and its answer: repetition, resynchronisation, damage.
//!
//! | what happens | what is done |
//! |---|---|
//! | answer damaged | asked again as soon as the link is quiet |
//! | answer does not come | asked again after the timeout |
//! | half a frame in the device's receiver | a zero byte before each request ends it |
//! | late answer to an earlier request | dropped by its sequence number |
//! | endless bytes without an answer | an attempt ends after [`BYTES_PER_ATTEMPT`] |
//! | bytes that drip, late answers for ever | the request ends by its one deadline: timeout times attempts |
//! | a stop is asked for meanwhile | it is sent at once, confirmed, and the request made again |

use super::{LinkError, StopSwitch, Transport};
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::{Refusal, Request, Response, version_of_info};
use std::io;
use std::time::Duration;

/// Bytes read for one answer before the attempt is given up: an answer, a late
/// one before it, and as much noise again.
const BYTES_PER_ATTEMPT: usize = 4 * MAX_FRAME;

/// Quiet that ends an attempt after damage. What was damaged may have been noise
/// before the answer, so the rest of what is on its way is still read.
const QUIET_AFTER_DAMAGE: Duration = Duration::from_millis(100);

/// Longest wait between two looks at the stop switch.
const LOOK: Duration = Duration::from_millis(10);

/// How often a stop is sent, and how long each is waited for: half a second in all.
const STOP_ATTEMPTS: u32 = 4;
const STOP_TIMEOUT: Duration = Duration::from_millis(125);

/// Why an exchange failed.
#[derive(Debug)]
pub(super) enum Failure {
    /// Bytes do not get through.
    Link(LinkError),
    /// A whole answer came, and its message is none of ours.
    Unreadable {
        /// Its protocol version, if it is an `Info` of any version.
        version: Option<u16>,
    },
    /// A stop was asked for before a run began.
    Stopped,
    /// The instrument could not carry out a stop.
    Refused(Refusal),
}

/// A whole frame with our sequence number.
type Answer = Result<Box<Response>, Failure>;

/// Kind of a received frame.
enum Heard {
    Answer(Answer),
    Late,
    Damage,
}

/// How an attempt ended.
enum Attempt {
    Answered(Answer),
    /// Nothing usable came in its time.
    Quiet,
    /// Somebody asks for a stop.
    Interrupted,
}

/// Counts for the message when all attempts failed.
#[derive(Default)]
struct Tally {
    bytes: usize,
    damaged: u32,
    late: u32,
    /// Answers that have begun when their time was over.
    begun: u32,
}

/// Sequence numbers and buffers of a conversation.
pub(super) struct Exchange {
    transport: Box<dyn Transport>,
    receiver: Receiver,
    sequence: u16,
    repetitions: u64,
    stop: Option<StopSwitch>,
    /// A stop is on its way: nothing interrupts it.
    stopping: bool,
    /// The run a stop is for, by the number of its record; none for whatever goes on.
    run: Option<u32>,
}

impl Exchange {
    pub(super) fn new(transport: Box<dyn Transport>) -> Self {
        Self {
            transport,
            receiver: Receiver::new(),
            sequence: first_sequence(),
            repetitions: 0,
            stop: None,
            stopping: false,
            run: None,
        }
    }

    pub(super) fn stop_for(&mut self, run: Option<u32>) {
        self.run = run;
    }

    pub(super) fn heed(&mut self, stop: StopSwitch) {
        self.stop = Some(stop);
    }

    pub(super) fn count_from(&mut self, sequence: u16) {
        self.sequence = sequence;
    }

    pub(super) fn name(&self) -> String {
        self.transport.name()
    }

    pub(super) fn repetitions(&self) -> u64 {
        self.repetitions
    }

    /// Lets time pass; a stop that is asked for meanwhile is passed on.
    pub(super) fn wait(&mut self, duration: Duration) -> Result<(), Failure> {
        let mut left = duration;
        loop {
            self.pass_stop()?;
            if left.is_zero() {
                return Ok(());
            }
            let step = self.at_most_a_look(left);
            let waited = self.transport.wait(step);
            waited.map_err(|source| Failure::Link(self.closed(source)))?;
            left -= step;
        }
    }

    /// Sends a request until its answer is here, `attempts` times at most, and within `timeout` times
    /// `attempts` whatever comes. A stop goes first, and a run is not begun past one.
    pub(super) fn request(
        &mut self,
        request: &Request,
        timeout: Duration,
        attempts: u32,
    ) -> Result<Response, Failure> {
        loop {
            let stopped = self.pass_stop()?;
            if stopped && matches!(request, Request::Start(_)) {
                return Err(Failure::Stopped);
            }
            if let Some(response) = self.converse(request, timeout, attempts)? {
                return Ok(response);
            }
        }
    }

    /// Passes a stop on, if one waits; whether one did.
    pub(super) fn pass_stop(&mut self) -> Result<bool, Failure> {
        let waiting = self.stop.as_ref().and_then(StopSwitch::waiting);
        let Some(number) = waiting else {
            return Ok(false);
        };
        self.stop_now(STOP_TIMEOUT, STOP_ATTEMPTS)?;
        if let Some(stop) = &self.stop {
            stop.confirm(number);
        }
        Ok(true)
    }

    /// Sends a stop and waits for its confirmation; nothing interrupts it.
    pub(super) fn stop_now(&mut self, timeout: Duration, attempts: u32) -> Result<(), Failure> {
        self.stopping = true;
        let answered = self.converse_stop(timeout, attempts);
        self.stopping = false;
        match answered {
            Ok(Some(Response::Done)) => Ok(()),
            Ok(Some(Response::Refused(refusal))) => Err(Failure::Refused(refusal)),
            Ok(_) => Err(Failure::Unreadable { version: None }),
            Err(Failure::Link(source)) => Err(Failure::Link(LinkError::StopUnconfirmed {
                address: self.name(),
                source: Box::new(source),
            })),
            Err(other) => Err(other),
        }
    }

    /// A stop that comes late must end no other run: it names its own, where the instrument knows of that.
    fn converse_stop(
        &mut self,
        timeout: Duration,
        attempts: u32,
    ) -> Result<Option<Response>, Failure> {
        if let Some(record_id) = self.run {
            let named = self.converse(&Request::StopRun { record_id }, timeout, attempts)?;
            if named != Some(Response::Refused(Refusal::Unknown)) {
                return Ok(named);
            }
        }
        self.converse(&Request::Stop, timeout, attempts)
    }

    /// One request under a number of its own; `None` when a stop came in between.
    fn converse(
        &mut self,
        request: &Request,
        timeout: Duration,
        attempts: u32,
    ) -> Result<Option<Response>, Failure> {
        self.sequence = self.sequence.wrapping_add(1);
        let frame = self.frame(request)?;
        let deadline = self.transport.now() + timeout * attempts;
        let mut tally = Tally::default();
        for attempt in 1..=attempts {
            self.repetitions += u64::from(attempt > 1);
            self.receiver.clear();
            let outcome = self
                .transport
                .send(&frame)
                .and_then(|()| self.answer(timeout, deadline, &mut tally));
            match outcome.map_err(|source| Failure::Link(self.closed(source)))? {
                Attempt::Answered(answer) => return answer.map(|response| Some(*response)),
                Attempt::Interrupted => return Ok(None),
                Attempt::Quiet => {
                    tally.begun += u32::from(self.receiver.begun() == Some(self.sequence))
                }
            }
            if self.transport.now() >= deadline {
                break;
            }
        }
        Err(Failure::Link(self.gave_up(attempts, &tally)))
    }

    /// The frame with a zero before it, so that half a frame left in the
    /// device's receiver ends there.
    fn frame(&self, request: &Request) -> Result<Vec<u8>, Failure> {
        let mut buffer = vec![0; 1 + MAX_FRAME];
        // Note: the longest request of the protocol fits, so this cannot happen.
        let length = encode(self.sequence, request, &mut buffer[1..])
            .map_err(|_| Failure::Unreadable { version: None })?;
        buffer.truncate(1 + length);
        Ok(buffer)
    }

    /// Reads until the answer, or quiet, or the deadline.
    fn answer(
        &mut self,
        timeout: Duration,
        deadline: Duration,
        tally: &mut Tally,
    ) -> io::Result<Attempt> {
        let mut buffer = [0; 1024];
        let (mut read, mut timeout) = (0, timeout);
        let mut quiet_at = self.transport.now() + timeout;
        while read < BYTES_PER_ATTEMPT {
            if self.stop_waits() {
                return Ok(Attempt::Interrupted);
            }
            let left = quiet_at.min(deadline).saturating_sub(self.transport.now());
            let step = self.at_most_a_look(left);
            if step.is_zero() {
                break;
            }
            let count = self.transport.receive(&mut buffer, step)?;
            if count == 0 && step < left {
                continue;
            } else if count == 0 {
                break;
            }
            read += count;
            tally.bytes += count;
            if let Some(answer) = self.take(&buffer[..count], &mut timeout, tally) {
                return Ok(Attempt::Answered(answer));
            }
            quiet_at = self.transport.now() + timeout;
        }
        Ok(Attempt::Quiet)
    }

    /// Takes bytes; the answer, if they end it. Damage shortens the quiet that ends the attempt.
    fn take(&mut self, bytes: &[u8], timeout: &mut Duration, tally: &mut Tally) -> Option<Answer> {
        for byte in bytes {
            let Some(raw) = self.receiver.push(*byte) else {
                continue;
            };
            match judge(raw, self.sequence) {
                Heard::Answer(answer) => return Some(answer),
                Heard::Damage => {
                    tally.damaged += 1;
                    *timeout = (*timeout).min(QUIET_AFTER_DAMAGE);
                }
                Heard::Late => tally.late += 1,
            }
        }
        None
    }

    fn stop_waits(&self) -> bool {
        let waiting = self.stop.as_ref().and_then(StopSwitch::waiting);
        !self.stopping && waiting.is_some()
    }

    /// As long as `duration`, or until the switch is to be looked at again.
    fn at_most_a_look(&self, duration: Duration) -> Duration {
        match self.stop {
            Some(_) => duration.min(LOOK),
            None => duration,
        }
    }

    fn closed(&self, source: io::Error) -> LinkError {
        LinkError::Closed {
            address: self.name(),
            source,
        }
    }

    fn gave_up(&self, attempts: u32, tally: &Tally) -> LinkError {
        let address = self.name();
        match (tally.bytes, tally.damaged, tally.late + tally.begun) {
            (0, ..) => LinkError::NoAnswer { address, attempts },
            (bytes, 0, 0) => LinkError::NotACalibrator { address, bytes },
            // What comes of an answer that had begun is damaged by itself.
            (_, damaged, late) if damaged <= tally.begun => LinkError::Late {
                address,
                late,
                attempts,
            },
            (_, damaged, _) => LinkError::Damaged {
                address,
                damaged,
                attempts,
            },
        }
    }
}

fn judge(raw: &mut [u8], sequence: u16) -> Heard {
    match Frame::check(raw) {
        Ok(frame) if frame.sequence != sequence => Heard::Late,
        Ok(frame) => Heard::Answer(match frame.message() {
            Ok(response) => Ok(Box::new(response)),
            Err(_) => Err(Failure::Unreadable {
                version: version_of_info(frame.message),
            }),
        }),
        Err(_) => Heard::Damage,
    }
}

/// Conversations begin anywhere, so that a device never takes the first start
/// of one for a repetition of the last start of another.
fn first_sequence() -> u16 {
    use std::hash::{BuildHasher, RandomState};
    RandomState::new().hash_one("sequence") as u16
}
