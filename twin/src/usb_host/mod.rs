//! A USB host for the emulated board: enumeration, and the serial port of a CDC-ACM device.
//!
//! - [`UsbHost`]: the cable, bus resets and control transfers, in virtual time.
//! - [`UsbHost::enumerate`]: from a plugged cable to a configured device, as an operating system does.
//! - [`UsbSerial`]: the device's serial port.
//! - [`capture`]: what crossed the bus as a file Wireshark reads.
//!
//! USB 2.0 is the specification of April 2000; CDC 1.2 and PSTN 1.2 those of the communication class.

pub mod capture;
mod descriptor;
mod enumerate;
mod serial;

use std::sync::{MutexGuard, PoisonError};
use std::time::Duration;

pub use descriptor::{CdcFunction, DeviceDescriptor};
pub use enumerate::Enumerated;
pub use serial::UsbSerial;

use crate::board::usb::{Setup, UsbError, UsbPort};
use crate::runner::{Emulator, Error, SharedEmulator};

/// From VBUS to the first reset: contact bounce (USB 2.0, section 7.1.7.3).
const DEBOUNCE: Duration = Duration::from_millis(100);
/// A reset of the bus by a root port (USB 2.0, section 7.1.7.5).
const RESET: Duration = Duration::from_millis(50);
/// How often a waiting host looks.
const STEP: Duration = Duration::from_millis(1);
/// Longest a control transfer takes: what a device is allowed, and some.
const CONTROL_LIMIT: Duration = Duration::from_secs(6);

/// Errors between host and device.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HostError {
    /// A transfer failed.
    #[error("{what}: {error}")]
    Transfer {
        /// Request.
        what: &'static str,
        /// Why it failed.
        error: UsbError,
    },
    /// The device answers with something that is no such descriptor.
    #[error("{what}: {reason}")]
    Descriptor {
        /// Which descriptor.
        what: &'static str,
        /// Problem.
        reason: String,
    },
    /// No device shows itself.
    #[error("no device on the bus within {0:?}")]
    NoDevice(Duration),
    /// The emulated board failed.
    #[error(transparent)]
    Board(#[from] Error),
}

/// A host at the other end of the board's cable.
#[derive(Debug, Clone)]
pub struct UsbHost {
    emulator: SharedEmulator,
    port: UsbPort,
}

impl UsbHost {
    /// A host for `emulator`, the cable not plugged in.
    #[must_use]
    pub fn new(emulator: SharedEmulator) -> Self {
        let port = {
            let board = emulator.lock().unwrap_or_else(PoisonError::into_inner);
            board.usb().clone()
        };
        Self { emulator, port }
    }

    /// The port itself.
    #[must_use]
    pub fn port(&self) -> &UsbPort {
        &self.port
    }

    /// Virtual time since the first power-on.
    #[must_use]
    pub fn now(&self) -> Duration {
        self.board().elapsed()
    }

    /// Plugs the cable in and waits for a device to show itself.
    ///
    /// # Errors
    ///
    /// [`HostError::NoDevice`] when none does within `limit`.
    pub fn plug(&self, limit: Duration) -> Result<(), HostError> {
        self.port.plug(true);
        let mut waited = Duration::ZERO;
        while !self.port.device_present() {
            if waited >= limit {
                return Err(HostError::NoDevice(limit));
            }
            self.wait(STEP)?;
            waited += STEP;
        }
        self.wait(DEBOUNCE)
    }

    /// Pulls the cable out.
    pub fn unplug(&self) {
        self.port.plug(false);
    }

    /// Resets the bus: the device is at address 0 afterwards.
    ///
    /// # Errors
    ///
    /// The board failed.
    pub fn reset(&self) -> Result<(), HostError> {
        self.port.begin_reset();
        self.wait(RESET)?;
        self.port.end_reset();
        // Recovery time (USB 2.0, section 7.1.7.5).
        self.wait(Duration::from_millis(10))
    }

    /// Does a control transfer and waits for its end: the data of one to the host.
    ///
    /// # Errors
    ///
    /// [`HostError::Transfer`] with `what`.
    pub fn control(
        &self,
        what: &'static str,
        address: u8,
        setup: Setup,
        data: &[u8],
    ) -> Result<Vec<u8>, HostError> {
        self.port.start_control(address, setup, data.to_vec());
        let mut waited = Duration::ZERO;
        while waited < CONTROL_LIMIT {
            self.wait(STEP)?;
            waited += STEP;
            if let Some(result) = self.port.control_result() {
                return result.map_err(|error| HostError::Transfer { what, error });
            }
        }
        let error = UsbError::Timeout;
        Err(HostError::Transfer { what, error })
    }

    /// Lets virtual time pass.
    ///
    /// # Errors
    ///
    /// The board failed.
    pub fn wait(&self, duration: Duration) -> Result<(), HostError> {
        Ok(self.board().run_for(duration)?)
    }

    fn board(&self) -> MutexGuard<'_, Emulator> {
        self.emulator.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
