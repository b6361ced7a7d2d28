//! A link in memory that damages, loses and adds bytes where a test says so.

use crate::device::Device;
use calib_link::{Client, Transport};
use std::io;
use std::sync::{Arc, Mutex};
use std::time::Duration;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    ToDevice,
    ToHost,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// One bit of the byte is inverted.
    Flip,
    /// The byte never arrives.
    Lose,
    /// A zero, which ends frames, arrives before the byte.
    AddZero,
    /// Another byte arrives before the byte.
    AddOther,
    /// From here on the connection is gone.
    Cut,
}

pub(crate) type SharedDevice = Arc<Mutex<Device>>;

pub(crate) struct MemoryLink {
    device: SharedDevice,
    inbox: Vec<u8>,
    fault: Option<(Direction, usize, Fault)>,
    passed: Arc<Mutex<[usize; 2]>>,
    gone: bool,
    /// Bytes handed out at most by one read.
    pub(crate) read_size: usize,
}

impl MemoryLink {
    pub(crate) fn new(device: &SharedDevice) -> Self {
        Self {
            device: Arc::clone(device),
            inbox: Vec::new(),
            fault: None,
            passed: Arc::default(),
            gone: false,
            read_size: usize::MAX,
        }
    }

    /// A link with one fault at the byte with number `position` in `direction`.
    pub(crate) fn with_fault(
        device: &SharedDevice,
        direction: Direction,
        position: usize,
        fault: Fault,
    ) -> Self {
        Self {
            fault: Some((direction, position, fault)),
            ..Self::new(device)
        }
    }

    /// Bytes passed so far, by direction.
    pub(crate) fn counter(&self) -> Arc<Mutex<[usize; 2]>> {
        Arc::clone(&self.passed)
    }

    /// Bytes that arrive at the other end for `byte`.
    fn pass(&mut self, direction: Direction, byte: u8) -> Vec<u8> {
        let position = {
            let mut passed = self.passed.lock().expect("counter");
            passed[direction as usize] += 1;
            passed[direction as usize] - 1
        };
        let fault = self
            .fault
            .filter(|(of, at, _)| (*of, *at) == (direction, position));
        if self.gone {
            return vec![];
        }
        match fault.map(|(.., fault)| fault) {
            None => vec![byte],
            Some(Fault::Flip) => vec![byte ^ 0x10],
            Some(Fault::Lose) => vec![],
            Some(Fault::AddZero) => vec![0, byte],
            Some(Fault::AddOther) => vec![0x55, byte],
            Some(Fault::Cut) => {
                self.gone = true;
                vec![]
            }
        }
    }
}

impl Transport for MemoryLink {
    fn name(&self) -> String {
        "memory".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        for byte in bytes {
            for arrived in self.pass(Direction::ToDevice, *byte) {
                let answer = self.device.lock().expect("device").byte(arrived);
                for byte in answer {
                    let arrived = self.pass(Direction::ToHost, byte);
                    self.inbox.extend(arrived);
                }
            }
        }
        Ok(())
    }

    fn now(&self) -> Duration {
        Duration::ZERO
    }

    fn receive(&mut self, buffer: &mut [u8], _timeout: Duration) -> io::Result<usize> {
        let count = buffer.len().min(self.inbox.len()).min(self.read_size);
        if count == 0 && self.gone {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        for (slot, byte) in buffer.iter_mut().zip(self.inbox.drain(..count)) {
            *slot = byte;
        }
        Ok(count)
    }

    fn wait(&mut self, _duration: Duration) -> io::Result<()> {
        Ok(())
    }
}

pub(crate) fn shared(device: Device) -> SharedDevice {
    Arc::new(Mutex::new(device))
}

pub(crate) fn client(device: &SharedDevice) -> Client {
    Client::new(Box::new(MemoryLink::new(device)))
}
