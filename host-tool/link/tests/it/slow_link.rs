//! A calibrator behind a link of a given unkindness, in virtual time: an hour of waiting takes none.

use calib_link::Transport;
use calib_protocol::frame::{Frame, MAX_FRAME, Receiver, encode};
use calib_protocol::message::{Request, Response, Status};
use std::io;
use std::sync::{Arc, Mutex, MutexGuard};
use std::time::Duration;

/// Behaviour of the way back from the device.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    /// Noise comes byte by byte, with this pause before each, and never an answer.
    Drip(Duration),
    /// Intact frames with a number of long ago, one after each pause, and never an answer.
    OldFrames(Duration),
    /// The answer to each request begins, and never ends.
    Begun,
    /// Nothing comes.
    Silent,
}

/// Bytes the device has seen, and the time of the link.
#[derive(Default)]
pub(crate) struct Seen {
    pub(crate) clock: Duration,
    /// Requests, each with the time it came.
    pub(crate) requests: Vec<(Duration, Request)>,
    /// Bytes that come as they should: the answer to a stop, or what has begun of one.
    at_once: Option<Vec<u8>>,
    /// The answer to the last request, with another number.
    old_frame: Vec<u8>,
    /// Action of somebody at a time.
    due: Option<(Duration, Box<dyn FnOnce() + Send>)>,
}

impl Seen {
    /// When a request like this came first.
    pub(crate) fn first(&self, is: impl Fn(&Request) -> bool) -> Option<Duration> {
        self.requests
            .iter()
            .find(|(_, request)| is(request))
            .map(|(at, _)| *at)
    }

    /// Lets time pass; what falls due is done.
    fn pass(&mut self, duration: Duration) -> Option<Box<dyn FnOnce() + Send>> {
        self.clock += duration;
        match self.due.take() {
            Some((at, act)) if at <= self.clock => Some(act),
            other => {
                self.due = other;
                None
            }
        }
    }
}

pub(crate) struct SlowLink {
    way: Way,
    /// It answers stops.
    pub(crate) confirms: bool,
    /// When something came last.
    last: Duration,
    receiver: Receiver,
    seen: Arc<Mutex<Seen>>,
}

impl SlowLink {
    pub(crate) fn new(way: Way) -> Self {
        Self {
            way,
            confirms: true,
            last: Duration::ZERO,
            receiver: Receiver::new(),
            seen: Arc::default(),
        }
    }

    pub(crate) fn seen(&self) -> Arc<Mutex<Seen>> {
        Arc::clone(&self.seen)
    }

    /// Somebody does this at that time of the link.
    pub(crate) fn at(&mut self, time: Duration, act: impl FnOnce() + Send + 'static) {
        self.lock().due = Some((time, Box::new(act)));
    }

    fn lock(&self) -> MutexGuard<'_, Seen> {
        self.seen.lock().expect("one thread")
    }

    fn pass(&self, duration: Duration) {
        let due = self.lock().pass(duration);
        if let Some(act) = due {
            act();
        }
    }

    fn answer(&self, raw: &mut [u8]) {
        let Ok(frame) = Frame::check(raw) else { return };
        let Ok(request) = frame.message::<Request>() else {
            return;
        };
        let old = frame.sequence.wrapping_sub(1000);
        let mut seen = self.lock();
        let at = seen.clock;
        if request == Request::Stop && self.confirms {
            seen.at_once = Some(encoded(frame.sequence, &Response::Done));
        }
        if matches!(self.way, Way::Begun) {
            let mut begun = encoded(frame.sequence, &Response::Status(Status::IDLE));
            begun.truncate(begun.len() / 2);
            seen.at_once = Some(begun);
        }
        seen.old_frame = encoded(old, &Response::Status(Status::IDLE));
        seen.requests.push((at, request));
    }
}

impl Transport for SlowLink {
    fn name(&self) -> String {
        "slow".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        for byte in bytes {
            let whole = self.receiver.push(*byte).map(|raw| raw.to_vec());
            if let Some(mut raw) = whole {
                self.answer(&mut raw);
            }
        }
        Ok(())
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        if let Some(answer) = self.lock().at_once.take() {
            buffer[..answer.len()].copy_from_slice(&answer);
            return Ok(answer.len());
        }
        let (pause, whole) = match self.way {
            Way::Drip(pause) => (pause, false),
            Way::OldFrames(pause) => (pause, true),
            Way::Begun | Way::Silent => (Duration::from_secs(1 << 20), false),
        };
        let left = (self.last + pause).saturating_sub(self.now());
        if left > timeout {
            self.pass(timeout);
            return Ok(0);
        }
        self.pass(left);
        self.last = self.now();
        if !whole {
            buffer[0] = 0x55;
            return Ok(1);
        }
        let seen = self.lock();
        buffer[..seen.old_frame.len()].copy_from_slice(&seen.old_frame);
        Ok(seen.old_frame.len())
    }

    fn now(&self) -> Duration {
        self.lock().clock
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        self.pass(duration);
        Ok(())
    }
}

fn encoded(sequence: u16, response: &Response) -> Vec<u8> {
    let mut buffer = vec![0; MAX_FRAME];
    let length = encode(sequence, response, &mut buffer).expect("fits");
    buffer.truncate(length);
    buffer
}
