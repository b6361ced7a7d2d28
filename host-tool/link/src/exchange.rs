//! One request and its answer: repetition, resynchronisation, damage.
//!
//! | what happens | what is done |
//! |---|---|
//! | answer damaged | asked again as soon as the link is quiet |
//! | answer does not come | asked again after the timeout |
//! | half a frame in the device's receiver | a zero byte before each request ends it |
//! | late answer to an earlier request | dropped by its sequence number |
//! | endless bytes without an answer | the attempt ends after [`BYTES_PER_ATTEMPT`] |

use super::{LinkError, Transport};
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::{Request, Response, version_of_info};
use std::io;
use std::time::Duration;

/// Bytes read for one answer before the attempt is given up: an answer, a late
/// one before it, and as much noise again.
const BYTES_PER_ATTEMPT: usize = 4 * MAX_FRAME;

/// Quiet that ends an attempt after damage. What was damaged may have been noise
/// before the answer, so the rest of what is on its way is still read.
const QUIET_AFTER_DAMAGE: Duration = Duration::from_millis(100);

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
}

/// A whole frame with our sequence number.
type Answer = Result<Box<Response>, Failure>;

/// Kind of a received frame.
enum Heard {
    Answer(Answer),
    Late,
    Damage,
}

/// Counts for the message when all attempts failed.
#[derive(Default)]
struct Tally {
    bytes: usize,
    damaged: u32,
}

/// Sequence numbers and buffers of a conversation.
pub(super) struct Exchange {
    transport: Box<dyn Transport>,
    receiver: Receiver,
    sequence: u16,
    repetitions: u64,
}

impl Exchange {
    pub(super) fn new(transport: Box<dyn Transport>) -> Self {
        Self {
            transport,
            receiver: Receiver::new(),
            sequence: first_sequence(),
            repetitions: 0,
        }
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

    pub(super) fn wait(&mut self, duration: Duration) -> Result<(), LinkError> {
        let result = self.transport.wait(duration);
        result.map_err(|source| self.closed(source))
    }

    /// Sends a request until its answer is here, `attempts` times at most.
    pub(super) fn request(
        &mut self,
        request: &Request,
        timeout: Duration,
        attempts: u32,
    ) -> Result<Response, Failure> {
        self.sequence = self.sequence.wrapping_add(1);
        let frame = self.frame(request)?;
        let mut tally = Tally::default();
        for attempt in 1..=attempts {
            self.repetitions += u64::from(attempt > 1);
            self.receiver.clear();
            let outcome = self
                .transport
                .send(&frame)
                .and_then(|()| self.answer(timeout, &mut tally));
            if let Some(answer) = outcome.map_err(|source| Failure::Link(self.closed(source)))? {
                return answer.map(|response| *response);
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

    /// Reads until the answer, or quiet.
    fn answer(&mut self, timeout: Duration, tally: &mut Tally) -> io::Result<Option<Answer>> {
        let mut buffer = [0; 1024];
        let (mut read, mut timeout) = (0, timeout);
        while read < BYTES_PER_ATTEMPT {
            let count = self.transport.receive(&mut buffer, timeout)?;
            if count == 0 {
                break;
            }
            read += count;
            tally.bytes += count;
            for byte in &buffer[..count] {
                let Some(raw) = self.receiver.push(*byte) else {
                    continue;
                };
                match judge(raw, self.sequence) {
                    Heard::Answer(answer) => return Ok(Some(answer)),
                    Heard::Damage => {
                        tally.damaged += 1;
                        timeout = timeout.min(QUIET_AFTER_DAMAGE);
                    }
                    Heard::Late => {}
                }
            }
        }
        Ok(None)
    }

    fn closed(&self, source: io::Error) -> LinkError {
        LinkError::Closed {
            address: self.name(),
            source,
        }
    }

    fn gave_up(&self, attempts: u32, tally: &Tally) -> LinkError {
        let address = self.name();
        match *tally {
            Tally { bytes: 0, .. } => LinkError::NoAnswer { address, attempts },
            Tally { damaged: 0, bytes } => LinkError::NotACalibrator { address, bytes },
            Tally { damaged, .. } => LinkError::Damaged {
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
