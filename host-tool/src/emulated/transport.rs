//! The serial line of the emulated board as a transport.

use crate::link::Transport;
use calib_twin::runner::{Emulator, SharedEmulator};
use std::io;
use std::sync::{MutexGuard, PoisonError};
use std::time::Duration;

/// The board's serial line, with time-outs in virtual time.
#[derive(Debug)]
pub struct EmulatedTransport {
    emulator: SharedEmulator,
    received: Vec<u8>,
}

impl EmulatedTransport {
    pub(super) fn new(emulator: SharedEmulator) -> Self {
        Self {
            emulator,
            received: Vec::new(),
        }
    }

    fn emulator(&self) -> MutexGuard<'_, Emulator> {
        self.emulator.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Transport for EmulatedTransport {
    fn name(&self) -> String {
        "emulated".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.emulator().write_serial(bytes);
        Ok(())
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        if self.received.is_empty() {
            let mut emulator = self.emulator();
            emulator
                .run_until_received(timeout)
                .map_err(io::Error::other)?;
            let received = emulator.read_serial();
            drop(emulator);
            self.received = received;
        }
        let count = buffer.len().min(self.received.len());
        for (slot, byte) in buffer.iter_mut().zip(self.received.drain(..count)) {
            *slot = byte;
        }
        Ok(count)
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        self.emulator().run_for(duration).map_err(io::Error::other)
    }
}
