//! A link over the USB port of the emulated board in this process.

use calib_link::Transport;
use calib_twin::runner::SharedEmulator;
use calib_twin::usb_host::{Enumerated, HostError, UsbHost, UsbSerial};
use std::io;
use std::time::Duration;

/// From power to a device on the bus: the board boots first.
const BOOT: Duration = Duration::from_secs(1);
/// Baud rate serial ports are opened with; over USB it means nothing.
const BAUD: u32 = calib_protocol::frame::SERIAL_BAUD;

/// The USB serial port of an emulated board, in virtual time.
pub struct EmulatedUsbTransport {
    host: UsbHost,
    device: Enumerated,
    serial: UsbSerial,
}

impl EmulatedUsbTransport {
    /// Plugs the cable in, sets the device up as an operating system does and
    /// opens its serial port.
    ///
    /// # Errors
    /// The board shows no device, or one without a serial port.
    pub fn plug_in(emulator: SharedEmulator) -> Result<Self, HostError> {
        let host = UsbHost::new(emulator);
        host.plug(BOOT)?;
        let device = host.enumerate()?;
        let serial = host.open_serial(&device, BAUD)?;
        Ok(Self {
            host,
            device,
            serial,
        })
    }

    /// The host's end of the cable.
    pub fn host(&self) -> &UsbHost {
        &self.host
    }

    /// Who the device says it is.
    pub fn device(&self) -> &Enumerated {
        &self.device
    }
}

impl Transport for EmulatedUsbTransport {
    fn name(&self) -> String {
        "emulated-usb".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.serial.send(bytes)
    }

    fn now(&self) -> Duration {
        self.host.now()
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.serial.receive(buffer, timeout)
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        self.serial.wait(duration)
    }
}
