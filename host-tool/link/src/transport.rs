//! Carriers of bytes to a calibrator and back.

use std::io;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

/// A two-way stream of bytes with timeouts.
///
/// Implementations: [`super::SerialTransport`], [`super::TcpTransport`], the
/// emulated board, and whatever a test needs.
pub trait Transport: Send {
    /// Address for messages, in the words of the command line.
    fn name(&self) -> String;

    /// Hands all bytes to the link.
    ///
    /// # Errors
    /// The link is gone; there is no point in trying again.
    fn send(&mut self, bytes: &[u8]) -> io::Result<()>;

    /// Reads what is there, waiting up to `timeout` for the first byte.
    /// Returns the number of bytes; 0 means that none came in time.
    ///
    /// # Errors
    /// The link is gone; `UnexpectedEof` when the other end closed it.
    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize>;

    /// Time on the clock of this link, from any moment on: [`since_start`] for hardware, virtual time for a
    /// transport into a twin. It moves while [`Self::receive`] and [`Self::wait`] wait.
    fn now(&self) -> Duration;

    /// Lets time pass. A transport into a twin runs the twin instead.
    ///
    /// # Errors
    /// The link is gone.
    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        std::thread::sleep(duration);
        Ok(())
    }
}

impl<T: Transport + ?Sized> Transport for Box<T> {
    fn name(&self) -> String {
        (**self).name()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        (**self).send(bytes)
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        (**self).receive(buffer, timeout)
    }

    fn now(&self) -> Duration {
        (**self).now()
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        (**self).wait(duration)
    }
}

/// Time on the wall since this was first asked: the clock of links to hardware.
pub fn since_start() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}

/// A read that ended for want of bytes in time has read none.
pub(super) fn pause_as_nothing(read: io::Result<usize>) -> io::Result<usize> {
    match read {
        Err(error)
            if matches!(
                error.kind(),
                io::ErrorKind::TimedOut | io::ErrorKind::WouldBlock | io::ErrorKind::Interrupted
            ) =>
        {
            Ok(0)
        }
        other => other,
    }
}

/// A read of no bytes says of a port or socket that its other end is gone.
pub(super) fn end_as_error(read: io::Result<usize>) -> io::Result<usize> {
    match read {
        Ok(0) => Err(io::ErrorKind::UnexpectedEof.into()),
        other => other,
    }
}
