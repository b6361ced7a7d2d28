//! The serial line as a host program sees a port, with time-outs in virtual time.

use std::io::{self, Read, Write};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use super::Emulator;

/// An emulator several owners share: a test that presses the button, and the link it tests.
pub type SharedEmulator = Arc<Mutex<Emulator>>;

/// One end of the board's serial line. Virtual time passes only while a read waits.
#[derive(Debug, Clone)]
pub struct VirtualSerial {
    emulator: SharedEmulator,
    timeout: Duration,
    received: Vec<u8>,
}

impl VirtualSerial {
    /// The line of `emulator`, whose reads wait at most `timeout` of virtual time.
    #[must_use]
    pub fn new(emulator: SharedEmulator, timeout: Duration) -> Self {
        Self {
            emulator,
            timeout,
            received: Vec::new(),
        }
    }

    /// Lets virtual time pass.
    ///
    /// # Errors
    ///
    /// The emulator failed.
    pub fn wait(&mut self, duration: Duration) -> io::Result<()> {
        let mut emulator = self.emulator.lock().unwrap_or_else(PoisonError::into_inner);
        emulator.run_for(duration).map_err(io::Error::other)
    }

    /// Sets how long a read waits.
    pub fn set_timeout(&mut self, timeout: Duration) {
        self.timeout = timeout;
    }
}

impl Read for VirtualSerial {
    /// Reads what has come, waiting in virtual time for the first byte.
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.received.is_empty() {
            let mut emulator = self.emulator.lock().unwrap_or_else(PoisonError::into_inner);
            emulator
                .run_until_received(self.timeout)
                .map_err(io::Error::other)?;
            self.received = emulator.read_serial();
        }
        if self.received.is_empty() && !buffer.is_empty() {
            return Err(io::ErrorKind::TimedOut.into());
        }
        let count = buffer.len().min(self.received.len());
        for (place, byte) in buffer.iter_mut().zip(self.received.drain(..count)) {
            *place = byte;
        }
        Ok(count)
    }
}

impl Write for VirtualSerial {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut emulator = self.emulator.lock().unwrap_or_else(PoisonError::into_inner);
        emulator.write_serial(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
