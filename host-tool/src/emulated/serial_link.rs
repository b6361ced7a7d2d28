//! A link to the emulated board in this process: waiting runs the board.

use calib_link::{Transport, pause_as_nothing};
use calib_twin::runner::{SharedEmulator, VirtualSerial};
use std::io::{self, Read, Write};
use std::sync::PoisonError;
use std::time::Duration;

/// The virtual COM port of an emulated board, in virtual time.
pub struct EmulatedTransport {
    emulator: SharedEmulator,
    serial: VirtualSerial,
}

impl EmulatedTransport {
    /// The link to `emulator`, which others may hold too: to reset the board,
    /// to press its button or to look at the drive output.
    pub fn new(emulator: SharedEmulator) -> Self {
        let serial = VirtualSerial::new(emulator.clone(), Duration::ZERO);
        Self { emulator, serial }
    }
}

impl Transport for EmulatedTransport {
    fn name(&self) -> String {
        "emulated".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.serial.write_all(bytes)
    }

    fn now(&self) -> Duration {
        let emulator = self.emulator.lock();
        emulator.unwrap_or_else(PoisonError::into_inner).elapsed()
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.serial.set_timeout(timeout);
        pause_as_nothing(self.serial.read(buffer))
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        let mut emulator = self.emulator.lock().unwrap_or_else(PoisonError::into_inner);
        emulator.run_for(duration).map_err(io::Error::other)
    }
}
