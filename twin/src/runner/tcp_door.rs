//! The board's serial line on a TCP port of this computer, for several hosts at a time.
//!
//! One line has room for one speaker: what hosts send is passed on in whole frames and lines, one at a time and
//! in turn, as fast as the line carries it. A host that sends rubbish fills its own connection and nobody
//! else's. All hear what the board answers; each knows its own answers by their numbers.
//!
//! | a host | then |
//! |---|---|
//! | speaks HTTP or TLS: a web page found this port | it is cut off, and nothing of it reaches the board |
//! | sends [`LONGEST`] bytes that are no frame and no line | it is cut off |
//! | does not read | the oldest of its answers are dropped |
//! | is one more than [`MOST`] | the oldest that never sent a whole frame or line makes room; else it is not let in |

use std::collections::VecDeque;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};

use super::paced::{Door, HostLine};

/// Bytes taken from a host at one look.
const CHUNK: usize = 4096;

/// Longest frame or line: the firmware's frames have 4 126 bytes at most.
const LONGEST: usize = 4200;

/// Bytes kept for a host that does not read; older ones are dropped, as a port's driver does.
const BACKLOG: usize = 1 << 20;

/// Hosts at a time.
const MOST: usize = 8;

/// Words a web browser begins with, on behalf of any page.
const HTTP: [&[u8]; 9] = [
    b"get ",
    b"post ",
    b"head ",
    b"put ",
    b"options ",
    b"delete ",
    b"patch ",
    b"connect ",
    b"host:",
];

/// Listens on the loopback interface.
#[derive(Debug)]
pub struct TcpDoor {
    listener: TcpListener,
    address: SocketAddr,
    hosts: VecDeque<Host>,
}

/// A host program.
#[derive(Debug)]
struct Host {
    stream: TcpStream,
    /// It has sent a whole frame or line.
    spoke: bool,
    /// Sent by it, and not yet passed on.
    sent: Vec<u8>,
    /// For it, and not yet taken.
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
            hosts: VecDeque::new(),
        })
    }

    /// The port listened on.
    #[must_use]
    pub fn port(&self) -> u16 {
        self.address.port()
    }

    fn accept(&mut self) {
        while let Ok((stream, _)) = self.listener.accept() {
            // A line of a few bytes per answer would otherwise wait 40 ms for more to send.
            let usable = stream.set_nodelay(true).and(stream.set_nonblocking(true));
            if usable.is_ok() && self.has_room() {
                self.hosts.push_back(Host {
                    stream,
                    spoke: false,
                    sent: Vec::new(),
                    waiting: VecDeque::new(),
                });
            }
        }
    }

    /// Whether another host may be let in, in place of the oldest silent one if need be.
    fn has_room(&mut self) -> bool {
        if self.hosts.len() < MOST {
            return true;
        }
        let silent = self.hosts.iter().position(|host| !host.spoke);
        silent.and_then(|place| self.hosts.remove(place)).is_some()
    }

    /// Passes the next frame or line on; whose it was comes last the next time.
    fn pass_on(&mut self, line: &dyn HostLine) {
        for place in 0..self.hosts.len() {
            if let Some(unit) = self.hosts[place].next_unit() {
                line.send(&unit);
                let served = self.hosts.remove(place);
                self.hosts.extend(served);
                return;
            }
        }
    }
}

impl Host {
    /// Hands over what the board said and takes what the host says; an error says that it has gone, or is to
    /// be cut off.
    fn look(&mut self, from_board: &[u8]) -> io::Result<()> {
        self.waiting.extend(from_board);
        let excess = self.waiting.len().saturating_sub(BACKLOG);
        self.waiting.drain(..excess);
        flush(&mut self.stream, &mut self.waiting)?;
        if unit_length(&self.sent).is_none() {
            self.read()?;
        }
        let is_endless = self.sent.len() > LONGEST && unit_length(&self.sent).is_none();
        match is_endless || speaks_http(&self.sent) {
            true => Err(ErrorKind::InvalidData.into()),
            false => Ok(()),
        }
    }

    fn read(&mut self) -> io::Result<()> {
        let mut chunk = [0; CHUNK];
        match self.stream.read(&mut chunk) {
            Ok(0) => Err(ErrorKind::UnexpectedEof.into()),
            Ok(count) => {
                self.sent.extend(&chunk[..count]);
                Ok(())
            }
            Err(error) if would_wait(&error) => Ok(()),
            Err(error) => Err(error),
        }
    }

    fn next_unit(&mut self) -> Option<Vec<u8>> {
        let length = unit_length(&self.sent)?;
        self.spoke = true;
        let rest = self.sent.split_off(length);
        Some(std::mem::replace(&mut self.sent, rest))
    }
}

/// Bytes of the first whole frame or line. As the firmware tells them apart: a frame comes after a zero or
/// begins with what no text begins with, and ends with a zero; a line ends with LF.
fn unit_length(bytes: &[u8]) -> Option<usize> {
    let zeros = bytes.iter().take_while(|byte| **byte == 0).count();
    let rest = &bytes[zeros..];
    let is_text = |byte: &u8| matches!(byte, b' '..=b'~' | b'\t' | b'\r' | b'\n');
    let is_line = zeros == 0 && is_text(rest.first()?);
    let ends = |byte: &u8| *byte == 0 || (is_line && *byte == b'\n');
    Some(zeros + rest.iter().position(ends)? + 1)
}

/// Whether it begins as TLS does: the record of a handshake, and in it a client's greeting shorter than 64 KiB. A
/// frame that begins with 0x16 has no zero among its next 21 bytes.
fn speaks_tls(bytes: &[u8]) -> bool {
    matches!(bytes, [0x16, 0x03, _, _, _, 0x01, 0x00, ..])
}

/// Whether a line begins as those of HTTP do, or all of it as TLS does.
fn speaks_http(bytes: &[u8]) -> bool {
    if speaks_tls(bytes) {
        return true;
    }
    let lower = bytes.to_ascii_lowercase();
    let mut lines = lower.split(|byte| *byte == b'\n');
    lines.any(|line| HTTP.iter().any(|word| line.starts_with(word)))
}

impl Door for TcpDoor {
    fn address(&self) -> String {
        format!("tcp:{}", self.address)
    }

    fn serve(&mut self, line: &dyn HostLine, from_board: &[u8]) -> io::Result<()> {
        self.accept();
        self.hosts.retain_mut(|host| host.look(from_board).is_ok());
        if !line.is_sending() {
            self.pass_on(line);
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
    // What the line has not carried yet stays with the host.
    if !line.is_sending() {
        match host.read(&mut chunk) {
            Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
            Ok(count) => line.send(&chunk[..count]),
            Err(error) if would_wait(&error) => {}
            Err(error) => return Err(error),
        }
    }
    flush(host, waiting)
}

fn flush(host: &mut impl Write, waiting: &mut VecDeque<u8>) -> io::Result<()> {
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
    use std::cell::RefCell;
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
        host.write_all(b"ask\n").unwrap();
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
        host.write_all(b"next\n").unwrap();
        serve_until(&mut door, &line, || line.is_sending());
        door.serve(&line, b"!").unwrap();
        let mut answer = [0; 1];
        host.read_exact(&mut answer).unwrap();
        assert_eq!(&answer, b"!", "and nothing of what the first one missed");
    }

    /// A line that carries 11 bytes a look, as 115 200 baud do in a millisecond.
    #[derive(Default)]
    struct SlowLine {
        queued: RefCell<VecDeque<u8>>,
        carried: RefCell<Vec<u8>>,
    }

    impl SlowLine {
        fn pass_a_millisecond(&self) {
            let mut queued = self.queued.borrow_mut();
            let count = queued.len().min(11);
            self.carried.borrow_mut().extend(queued.drain(..count));
        }

        fn has_carried(&self, bytes: &[u8]) -> bool {
            let carried = self.carried.borrow();
            carried.windows(bytes.len()).any(|part| part == bytes)
        }
    }

    impl HostLine for SlowLine {
        fn send(&self, bytes: &[u8]) {
            self.queued.borrow_mut().extend(bytes);
        }

        fn receive(&self) -> Vec<u8> {
            Vec::new()
        }

        fn is_sending(&self) -> bool {
            !self.queued.borrow().is_empty()
        }
    }

    /// Looks until `done`; returns the looks at which the line had something to carry.
    fn looks_until(door: &mut TcpDoor, line: &SlowLine, done: impl Fn() -> bool) -> usize {
        let mut looks = 0;
        for _ in 0..50_000 {
            door.serve(line, &[]).unwrap();
            match line.is_sending() {
                true => looks += 1,
                false => std::thread::sleep(Duration::from_micros(100)),
            }
            line.pass_a_millisecond();
            if done() {
                return looks;
            }
        }
        panic!("never");
    }

    /// 300 kB took 26 s of the line, and whoever came next waited for all of it.
    #[test]
    fn rubbish_of_one_host_keeps_no_other_waiting() {
        let mut door = TcpDoor::listen(0).unwrap();
        let line = SlowLine::default();
        let mut bad = connect(&door);
        let rubbish: Vec<u8> = (0..300_000_u32)
            .map(|n| (n.wrapping_mul(2_654_435_761) >> 24) as u8)
            .collect();
        std::thread::scope(|scope| {
            // It waits for room, and ends with the door.
            scope.spawn(move || bad.write_all(&rubbish));
            looks_until(&mut door, &line, || line.carried.borrow().len() > 1000);
            let mut good = connect(&door);
            good.write_all(b"\0\x03stop\0").unwrap();
            let looks = looks_until(&mut door, &line, || line.has_carried(b"\0\x03stop\0"));
            assert!(looks < 500, "{looks} ms");
            drop(door);
        });
    }

    /// Its code is 22 and its number 3: no greeting of TLS.
    #[test]
    fn a_frame_that_begins_as_tls_does_is_passed_on() {
        let mut door = TcpDoor::listen(0).unwrap();
        let line = SlowLine::default();
        let mut host = connect(&door);
        let frame = b"\x16\x03\x01\x02\x03\x01\x02 and fourteen..\0";
        host.write_all(frame).unwrap();
        looks_until(&mut door, &line, || line.has_carried(frame));
    }

    /// Eight connections that say nothing made a calibrator deaf.
    #[test]
    fn silent_hosts_make_room_and_one_that_spoke_does_not() {
        let mut door = TcpDoor::listen(0).unwrap();
        let line = SlowLine::default();
        let mut first = connect(&door);
        first.write_all(b"first\n").unwrap();
        looks_until(&mut door, &line, || line.has_carried(b"first\n"));
        let _silent: Vec<TcpStream> = (0..2 * MOST).map(|_| connect(&door)).collect();
        let mut last = connect(&door);
        last.write_all(b"\0\x03stop\0").unwrap();
        looks_until(&mut door, &line, || line.has_carried(b"\0\x03stop\0"));
        first.write_all(b"still there\n").unwrap();
        looks_until(&mut door, &line, || line.has_carried(b"still there\n"));
    }

    #[test]
    fn a_second_host_leaves_the_first_its_line() {
        let mut door = TcpDoor::listen(0).unwrap();
        let line = SlowLine::default();
        let (mut first, mut second) = (connect(&door), connect(&door));
        first.write_all(b"\0\x05one").unwrap();
        second.write_all(b"\0\x05two\0").unwrap();
        looks_until(&mut door, &line, || line.has_carried(b"\0\x05two\0"));
        // A frame that came in two parts has nobody else's bytes in it.
        first.write_all(b" and a half\0").unwrap();
        looks_until(&mut door, &line, || {
            line.has_carried(b"\0\x05one and a half\0")
        });
        door.serve(&line, b"answer").unwrap();
        for host in [&mut first, &mut second] {
            let mut answer = [0; 6];
            host.read_exact(&mut answer).unwrap();
            assert_eq!(&answer, b"answer");
        }
    }

    /// A page on the web can make a browser send this to any port: its body began a run.
    #[test]
    fn a_browser_is_cut_off_before_anything_reaches_the_board() {
        let endless = vec![b'x'; 100_000];
        let post =
            b"POST / HTTP/1.1\r\nHost: 127.0.0.1:5025\r\nContent-Type: text/plain\r\n\r\nINIT\n";
        for words in [
            &post[..],
            b"GET / HTTP/1.1\r\n\r\nINIT\n",
            b"x\nhOsT: a\nINIT\n",
            b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03 and so on INIT\n",
            &endless,
        ] {
            let mut door = TcpDoor::listen(0).unwrap();
            let line = SlowLine::default();
            let mut host = connect(&door);
            host.set_read_timeout(Some(Duration::from_millis(1)))
                .unwrap();
            let _ = host.write_all(words);
            let mut answer = [0; 1];
            // Closed, or cut off with something unread.
            let is_cut = |heard: io::Result<usize>| match heard {
                Ok(count) => count == 0,
                Err(error) => !would_wait(&error),
            };
            let mut cut = false;
            for _ in 0..5_000 {
                door.serve(&line, &[]).unwrap();
                line.pass_a_millisecond();
                cut = cut || is_cut(host.read(&mut answer));
                if cut {
                    break;
                }
            }
            assert!(cut, "{:?}", String::from_utf8_lossy(&words[..20]));
            assert!(!line.has_carried(b"INIT"));
        }
    }
}
