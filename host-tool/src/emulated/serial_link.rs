//! A link to the emulated board in this process: waiting runs the board.

use calib_link::Transport;
use calib_twin::runner::{Emulator, SharedEmulator};
use std::collections::VecDeque;
use std::io::{self, Read};
use std::sync::{MutexGuard, PoisonError};
use std::time::Duration;

/// The virtual COM port of an emulated board. Virtual time passes only while a read waits.
pub struct EmulatedTransport {
    emulator: SharedEmulator,
    received: VecDeque<u8>,
}

impl EmulatedTransport {
    /// The link to `emulator`, which others may hold too: to reset the board,
    /// to press its button or to look at the drive output.
    pub fn new(emulator: SharedEmulator) -> Self {
        let received = VecDeque::new();
        Self { emulator, received }
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

    fn now(&self) -> Duration {
        self.emulator().elapsed()
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        if self.received.is_empty() {
            let mut emulator = self.emulator();
            let ended = emulator.run_until_received(timeout);
            ended.map_err(io::Error::other)?;
            let received = emulator.read_serial();
            drop(emulator);
            self.received = received.into();
        }
        self.received.read(buffer)
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        self.emulator().run_for(duration).map_err(io::Error::other)
    }
}
