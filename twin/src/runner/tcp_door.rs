//! The board's serial line on a TCP port of this computer.

use std::collections::VecDeque;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};

use super::paced::{Door, HostLine};

/// Bytes taken from a host at one look: more than a line carries in a millisecond.
const CHUNK: usize = 4096;

/// Bytes kept for a host that does not read; older ones are dropped, as a port's driver does.
const BACKLOG: usize = 1 << 20;

/// Listens on the loopback interface. The latest host to connect has the line.
#[derive(Debug)]
pub struct TcpDoor {
    listener: TcpListener,
    address: SocketAddr,
    host: Option<TcpStream>,
    waiting: VecDeque<u8>,
}

impl TcpDoor {
    /// Listens on `port`, or on any free port for 0.
    ///
    /// # Errors
    ///
    /// The port is taken or not allowed.
    pub fn listen(port: u16) -> io::Result<Self> {
        let listener = TcpListener::bind(("127.0.0.1", port))?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok(Self {
            listener,
            address,
            host: None,
            waiting: VecDeque::new(),
        })
    }

    /// The port listened on.
    #[must_use]
    pub fn port(&self) -> u16 {
        self.address.port()
    }

    fn accept(&mut self) {
        if let Ok((host, _)) = self.listener.accept() {
            // A line of a few bytes per answer would otherwise wait 40 ms for more to send.
            let usable = host.set_nodelay(true).and(host.set_nonblocking(true));
            self.host = usable.is_ok().then_some(host);
            self.waiting.clear();
        }
    }
}

impl Door for TcpDoor {
    fn address(&self) -> String {
        format!("tcp:{}", self.address)
    }

    fn serve(&mut self, line: &dyn HostLine, from_board: &[u8]) -> io::Result<()> {
        self.accept();
        let Some(host) = &mut self.host else {
            return Ok(());
        };
        self.waiting.extend(from_board);
        let excess = self.waiting.len().saturating_sub(BACKLOG);
        self.waiting.drain(..excess);
        if exchange(host, line, &mut self.waiting).is_err() {
            self.host = None;
        }
        Ok(())
    }
}

/// Moves bytes both ways without waiting; an error says that the host has gone.
pub(super) fn exchange(
    host: &mut (impl Read + Write),
    line: &dyn HostLine,
    waiting: &mut VecDeque<u8>,
) -> io::Result<()> {
    let mut chunk = [0; CHUNK];
    match host.read(&mut chunk) {
        Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
        Ok(count) => line.send(&chunk[..count]),
        Err(error) if would_wait(&error) => {}
        Err(error) => return Err(error),
    }
    while !waiting.is_empty() {
        match host.write(waiting.make_contiguous()) {
            Ok(count) => drop(waiting.drain(..count)),
            Err(error) if would_wait(&error) => break,
            Err(error) => return Err(error),
        }
    }
    Ok(())
}

fn would_wait(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::board::SerialLine;
    use std::time::Duration;

    fn connect(door: &TcpDoor) -> TcpStream {
        let host = TcpStream::connect(("127.0.0.1", door.port())).unwrap();
        host.set_read_timeout(Some(Duration::from_secs(5))).unwrap();
        host
    }

    /// Serves until `done`: the loopback interface delivers in its own time.
    fn serve_until(door: &mut TcpDoor, line: &SerialLine, done: impl Fn() -> bool) {
        for _ in 0..5_000 {
            door.serve(line, &[]).unwrap();
            if done() {
                return;
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        panic!("nothing came through the door in five seconds");
    }

    #[test]
    fn bytes_pass_both_ways() {
        let mut door = TcpDoor::listen(0).unwrap();
        let line = SerialLine::default();
        let mut host = connect(&door);
        host.write_all(b"ask").unwrap();
        serve_until(&mut door, &line, || line.is_sending());
        door.serve(&line, b"answer").unwrap();
        let mut answer = [0; 6];
        host.read_exact(&mut answer).unwrap();
        assert_eq!(&answer, b"answer");
    }

    #[test]
    fn a_host_that_goes_leaves_the_door_open_for_the_next() {
        let mut door = TcpDoor::listen(0).unwrap();
        let line = SerialLine::default();
        drop(connect(&door));
        door.serve(&line, b"to nobody").unwrap();
        let mut host = connect(&door);
        host.write_all(b"next").unwrap();
        serve_until(&mut door, &line, || line.is_sending());
        door.serve(&line, b"!").unwrap();
        let mut answer = [0; 1];
        host.read_exact(&mut answer).unwrap();
        assert_eq!(&answer, b"!", "and nothing of what the first one missed");
    }
}
