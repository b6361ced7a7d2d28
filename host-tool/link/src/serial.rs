//! A serial port: the ST-LINK's virtual COM port, or USB CDC.

use super::transport::{end_as_error, pause_as_nothing, since_start};
use super::{LinkError, Transport};
use calib_protocol::frame::SERIAL_BAUD;
use serialport::{ErrorKind, SerialPort};
use std::io::{self, Read, Write};
use std::time::Duration;

/// Longest wait for room to send: a request is small, and a port takes it at once.
const WRITE_LIMIT: Duration = Duration::from_millis(200);

/// An open serial port.
pub struct SerialTransport {
    name: String,
    port: Box<dyn SerialPort>,
}

impl SerialTransport {
    /// Opens a port with the settings of the calibrator.
    ///
    /// # Errors
    /// [`LinkError::Open`] with a hint for a missing port, missing rights and a
    /// port in use.
    pub fn open(name: &str) -> Result<Self, LinkError> {
        let mut port = serialport::new(name, SERIAL_BAUD)
            .timeout(Duration::from_secs(1))
            .open()
            .map_err(|error| open_error(name, error))?;
        // Some USB serial devices send nothing before DTR is raised. A
        // pseudo-terminal has no such line, so a refusal means nothing.
        let _ = port.write_data_terminal_ready(true);
        Ok(Self {
            name: name.to_owned(),
            port,
        })
    }
}

fn open_error(name: &str, error: serialport::Error) -> LinkError {
    let source = io::Error::from(error.clone());
    let hint = match (error.kind, source.kind()) {
        (ErrorKind::Io(io::ErrorKind::PermissionDenied), _) => {
            "no right to use the port: `calib doctor` shows the rule to add".to_owned()
        }
        (ErrorKind::NoDevice | ErrorKind::Io(io::ErrorKind::NotFound), _) => {
            "no such port, or it is in use: `calib devices` lists the ports".to_owned()
        }
        _ => "is another program using it? `calib devices` lists the ports".to_owned(),
    };
    LinkError::Open {
        address: name.to_owned(),
        source,
        hint,
    }
}

impl Transport for SerialTransport {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        // Not flushed: a port whose other end does not read would be waited for without a limit.
        self.port.set_timeout(WRITE_LIMIT)?;
        self.port.write_all(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        self.port.set_timeout(timeout)?;
        pause_as_nothing(end_as_error(self.port.read(buffer)))
    }

    fn now(&self) -> Duration {
        since_start()
    }
}
