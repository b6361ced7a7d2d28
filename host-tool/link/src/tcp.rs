//! A TCP connection: `calib emulate --tcp`, or a serial server in the field.

use super::transport::{end_as_error, pause_as_nothing, since_start};
use super::{LinkError, Transport};
use std::io::{self, Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::time::Duration;

/// Longest wait for room to send: a request is small, and its peer reads.
const WRITE_LIMIT: Duration = Duration::from_millis(200);

/// An open connection.
pub struct TcpTransport {
    peer: String,
    stream: TcpStream,
}

impl TcpTransport {
    /// Connects to `HOST:PORT` within three seconds.
    ///
    /// # Errors
    /// [`LinkError::Open`] when the name is unknown or nobody listens there.
    pub fn connect(peer: &str) -> Result<Self, LinkError> {
        let failed = |source, hint: &str| LinkError::Open {
            address: format!("tcp:{peer}"),
            source,
            hint: hint.to_owned(),
        };
        let addresses = peer
            .to_socket_addrs()
            .map_err(|error| failed(error, "an address looks like tcp:192.168.0.7:4000"))?;
        let mut last = io::Error::from(io::ErrorKind::AddrNotAvailable);
        for address in addresses {
            match TcpStream::connect_timeout(&address, Duration::from_secs(3)) {
                Ok(stream) => return Self::from_stream(peer, stream).map_err(|e| failed(e, "")),
                Err(error) => last = error,
            }
        }
        Err(failed(
            last,
            "nobody listens there: is `calib emulate --tcp PORT` running?",
        ))
    }

    fn from_stream(peer: &str, stream: TcpStream) -> io::Result<Self> {
        // A request is one small packet: waiting for more would only delay it.
        stream.set_nodelay(true)?;
        // A peer that reads nothing must not keep a stop waiting.
        stream.set_write_timeout(Some(WRITE_LIMIT))?;
        Ok(Self {
            peer: peer.to_owned(),
            stream,
        })
    }
}

impl Transport for TcpTransport {
    fn name(&self) -> String {
        format!("tcp:{}", self.peer)
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.stream.write_all(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        // Zero would mean "for ever".
        self.stream
            .set_read_timeout(Some(timeout.max(Duration::from_millis(1))))?;
        pause_as_nothing(end_as_error(self.stream.read(buffer)))
    }

    fn now(&self) -> Duration {
        since_start()
    }
}
