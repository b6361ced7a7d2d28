//! The serial port of a configured device, with time-outs in virtual time.

use std::collections::VecDeque;
use std::io::{self, ErrorKind, Read};
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
    received: VecDeque<u8>,
}

impl UsbSerial {
    pub(super) fn new(emulator: SharedEmulator, port: UsbPort) -> Self {
        Self {
            emulator,
            port,
            received: VecDeque::new(),
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

    /// Queues bytes for the device.
    ///
    /// # Errors
    ///
    /// The device has gone or refuses its pipes.
    pub fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.check()?;
        self.port.send(bytes);
        Ok(())
    }

    /// Reads what has come, waiting up to `timeout` for the first byte; 0 when none came.
    ///
    /// # Errors
    ///
    /// As [`Self::send`] and [`Self::wait`].
    pub fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        let mut waited = Duration::ZERO;
        while self.received.is_empty() {
            self.received = self.port.receive().into();
            if !self.received.is_empty() || buffer.is_empty() {
                break;
            }
            self.check()?;
            if waited >= timeout {
                break;
            }
            let step = STEP.min(timeout - waited);
            self.wait(step)?;
            waited += step;
        }
        self.received.read(buffer)
    }

    fn check(&self) -> io::Result<()> {
        match self.port.pipe_error() {
            Some(error) => Err(io::Error::new(ErrorKind::BrokenPipe, error)),
            None => Ok(()),
        }
    }
}
