//! Serving a host over any byte stream.
//!
//! The stream is read until it holds a frame. A damaged frame is dropped: the
//! host asks again. A whole frame is answered with its own sequence number,
//! also when its message means nothing to this version.

use crate::command::{self, Instrument};
use calib_protocol::frame::{self, Frame, FrameError, MAX_FRAME, Receiver};
use calib_protocol::message::{Refusal, Request, Response};

/// What a frame asked for beside its answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aftermath {
    /// Nothing.
    None,
    /// The board is to be reset once the answer is on its way.
    Reset,
}

/// One link's memory: the frame being received and the one being sent.
pub struct Link {
    receiver: Receiver,
    answer: [u8; MAX_FRAME],
}

impl Default for Link {
    fn default() -> Self {
        Self::new()
    }
}

impl Link {
    /// A link on which nothing came yet.
    pub const fn new() -> Self {
        Self {
            receiver: Receiver::new(),
            answer: [0; MAX_FRAME],
        }
    }

    /// Forgets a half-received frame, when bytes were lost or the host left.
    pub fn forget(&mut self) {
        self.receiver = Receiver::new();
    }

    /// Takes one byte; at the end of a readable frame, carries it out and
    /// returns the bytes of the answer.
    pub async fn push(
        &mut self,
        byte: u8,
        instrument: &mut impl Instrument,
    ) -> Option<(&[u8], Aftermath)> {
        let frame = Frame::check(self.receiver.push(byte)?).ok()?;
        let sequence = frame.sequence;
        let request = frame.message::<Request>();
        let aftermath = match request {
            Ok(Request::Reset) => Aftermath::Reset,
            _ => Aftermath::None,
        };
        let response = match request {
            Ok(request) => command::answer(request, instrument).await,
            Err(_) => Response::Refused(Refusal::Unknown),
        };
        let length = encode(sequence, &response, &mut self.answer)?;
        Some((self.answer.get(..length)?, aftermath))
    }
}

/// Encodes an answer, or in its place a refusal if it were too long.
fn encode(sequence: u16, response: &Response, buffer: &mut [u8]) -> Option<usize> {
    match frame::encode(sequence, response, buffer) {
        Err(FrameError::TooLong) => {
            frame::encode(sequence, &Response::Refused(Refusal::Unknown), buffer).ok()
        }
        written => written.ok(),
    }
}
