//! The board's serial line as a pseudo terminal, which programs open like any serial port.

use std::collections::VecDeque;
use std::fs::File;
use std::io;
use std::os::fd::OwnedFd;

use rustix::fs::{Mode, OFlags};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

use super::paced::{Door, HostLine};
use super::tcp_door::exchange;

/// Bytes kept for a program that does not read, as long as a terminal's own buffer.
const BACKLOG: usize = 4096;

/// A pseudo terminal. Any program may open [`PtyDoor::path`].
#[derive(Debug)]
pub struct PtyDoor {
    master: File,
    /// Held open so that a program that closes the port does not hang it up.
    _slave: OwnedFd,
    path: String,
    waiting: VecDeque<u8>,
}

impl PtyDoor {
    /// Opens a pseudo terminal in raw mode.
    ///
    /// # Errors
    ///
    /// The system gives none.
    pub fn open() -> io::Result<Self> {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC)?;
        grantpt(&master)?;
        unlockpt(&master)?;
        let name = ptsname(&master, Vec::new())?;
        let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
        let slave = rustix::fs::open(name.as_c_str(), flags, Mode::empty())?;
        let mut settings = tcgetattr(&slave)?;
        settings.make_raw();
        tcsetattr(&slave, OptionalActions::Now, &settings)?;
        let blocking = rustix::fs::fcntl_getfl(&master)?;
        rustix::fs::fcntl_setfl(&master, blocking | OFlags::NONBLOCK)?;
        Ok(Self {
            master: File::from(master),
            _slave: slave,
            path: name.to_string_lossy().into_owned(),
            waiting: VecDeque::new(),
        })
    }

    /// The device file to open.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }
}

impl Door for PtyDoor {
    fn address(&self) -> String {
        self.path.clone()
    }

    fn serve(&mut self, line: &dyn HostLine, from_board: &[u8]) -> io::Result<()> {
        self.waiting.extend(from_board);
        let excess = self.waiting.len().saturating_sub(BACKLOG);
        self.waiting.drain(..excess);
        exchange(&mut self.master, line, &mut self.waiting)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::board::SerialLine;
    use std::io::{Read, Write};

    #[test]
    fn a_program_opens_it_like_a_port_and_closes_it_and_opens_it_again() {
        let mut door = PtyDoor::open().unwrap();
        let line = SerialLine::default();
        for _ in 0..2 {
            let open = File::options().read(true).write(true).open(door.path());
            let mut port = open.unwrap();
            // Raw: neither end nor meaning of a byte is changed on the way.
            port.write_all(b"\x03\x00\r\n").unwrap();
            door.serve(&line, b"\x04\n\x11").unwrap();
            assert!(line.is_sending());
            line.clear();
            let mut answer = [0; 3];
            port.read_exact(&mut answer).unwrap();
            assert_eq!(&answer, b"\x04\n\x11");
        }
    }
}
