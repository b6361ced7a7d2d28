//! The serial port of a configured device, with time-outs in virtual time.

use std::io::{self, ErrorKind, Read, Write};
use std::sync::PoisonError;
use std::time::Duration;

use crate::board::usb::UsbPort;
use crate::runner::SharedEmulator;

/// How often a waiting read looks.
const STEP: Duration = Duration::from_millis(1);

/// The host's end of the serial port. Virtual time passes only while a read waits.
#[derive(Debug, Clone)]
pub struct UsbSerial {
    emulator: SharedEmulator,
    port: UsbPort,
    timeout: Duration,
    received: Vec<u8>,
}

impl UsbSerial {
    pub(super) fn new(emulator: SharedEmulator, port: UsbPort) -> Self {
        Self {
            emulator,
            port,
            timeout: Duration::ZERO,
            received: Vec::new(),
        }
    }

    /// Sets how long a read waits.
    pub fn set_timeout(&mut self, timeout: Duration) {
        self.timeout = timeout;
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

    /// Fails once the device has gone or refuses its pipes.
    fn check(&self) -> io::Result<()> {
        match self.port.pipe_error() {
            Some(error) => Err(io::Error::new(ErrorKind::BrokenPipe, error)),
            None => Ok(()),
        }
    }
}

impl Read for UsbSerial {
    /// Reads what has come, waiting in virtual time for the first byte.
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut waited = Duration::ZERO;
        while self.received.is_empty() {
            self.received = self.port.receive();
            if !self.received.is_empty() || buffer.is_empty() {
                break;
            }
            self.check()?;
            if waited >= self.timeout {
                return Err(ErrorKind::TimedOut.into());
            }
            let step = STEP.min(self.timeout - waited);
            self.wait(step)?;
            waited += step;
        }
        let count = buffer.len().min(self.received.len());
        for (place, byte) in buffer.iter_mut().zip(self.received.drain(..count)) {
            *place = byte;
        }
        Ok(count)
    }
}

impl Write for UsbSerial {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.check()?;
        self.port.send(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.check()
    }
}
