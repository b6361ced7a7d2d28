//! The host's client against a device that answers anything.

use super::frames::{Whole, framed, whole_frames};
use calib_link::capture::Inputs;
use calib_link::{Client, RetryPolicy, Transport};
use calib_protocol::record;
use std::io;
use std::time::Duration;

/// As a good device has it.
const INPUTS: Inputs = Inputs {
    sample_rate_hz: 50_000.0,
    reference_volt_per_code: 1.5e-4,
    dut_volt_per_code: 1.5e-4,
};

/// Asks everything of a device whose answers are `data`: each ends in a result
/// or an error, after a bounded number of bytes.
pub fn client(data: &[u8]) {
    let policy = RetryPolicy {
        attempts: 2,
        ..RetryPolicy::default()
    };
    let device = Babbler::new(data);
    let mut client = Client::with_policy(Box::new(device), policy);
    let _ = client.info();
    let _ = client.status();
    let _ = client.point(0);
    let _ = client.settings();
    let _ = client.records();
    let _ = client.stop();
    let _ = INPUTS.capture(&mut client, 3);
    if let Ok(chunk) = client.read_record(1, 0) {
        let _ = record::decode(&chunk.data);
    }
}

/// Answers each request with the next part of its bytes: as they are, or as the
/// message of a frame with the right number and checksum.
struct Babbler {
    parts: Vec<Vec<u8>>,
    inbox: Vec<u8>,
    asked: usize,
}

impl Babbler {
    fn new(data: &[u8]) -> Self {
        Self {
            parts: data
                .split(|byte| *byte == 0xFF)
                .map(<[u8]>::to_vec)
                .collect(),
            inbox: Vec::new(),
            asked: 0,
        }
    }
}

impl Transport for Babbler {
    fn name(&self) -> String {
        "babbler".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        let part = &self.parts[self.asked % self.parts.len()];
        self.asked += 1;
        assert!(self.asked < 10_000, "the client gives up");
        match (whole_frames(bytes).pop(), part.split_first()) {
            (Some(request), Some((kind, message))) if kind % 2 == 1 => {
                self.inbox.extend(framed(&Whole {
                    sequence: request.sequence,
                    message: message.to_vec(),
                }));
            }
            _ => self.inbox.extend(part),
        }
        Ok(())
    }

    fn now(&self) -> Duration {
        Duration::ZERO
    }

    fn receive(&mut self, buffer: &mut [u8], _: Duration) -> io::Result<usize> {
        let count = buffer.len().min(self.inbox.len());
        for (slot, byte) in buffer.iter_mut().zip(self.inbox.drain(..count)) {
            *slot = byte;
        }
        Ok(count)
    }

    fn wait(&mut self, _: Duration) -> io::Result<()> {
        Ok(())
    }
}
