//! The link between a host and a calibrator, as bad as it is told to be: what the host asks arrives, what the
//! calibrator answers comes late or never.

use crate::device::{DRIP, REPEAT, Way};
use calib_tests::rigged::Fault;
use std::collections::VecDeque;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Longest wait for something from the calibrator before the way is looked at again.
const LOOK: Duration = Duration::from_millis(5);

/// The link.
pub(crate) struct Relay {
    way: Arc<Mutex<Way>>,
    /// Address for `--device`.
    pub(crate) address: String,
}

impl Relay {
    /// Listens for hosts of the calibrator at `board`.
    pub(crate) fn before(board: &str) -> Result<Self, Fault> {
        let board = board.strip_prefix("tcp:").ok_or("no TCP port")?.to_owned();
        let listener = TcpListener::bind("127.0.0.1:0")?;
        let address = format!("tcp:{}", listener.local_addr()?);
        let way = Arc::new(Mutex::new(Way::Plain));
        let of_link = Arc::clone(&way);
        std::thread::spawn(move || {
            for host in listener.incoming().flatten() {
                let Ok(board) = TcpStream::connect(&board) else {
                    continue;
                };
                let way = Arc::clone(&of_link);
                // A host that goes ends its thread.
                std::thread::spawn(move || pass(host, board, &way));
            }
        });
        Ok(Self { way, address })
    }

    /// From now on answers come like this.
    pub(crate) fn behave(&self, way: Way) {
        *self.way.lock().unwrap_or_else(PoisonError::into_inner) = way;
    }
}

/// Passes both directions on until one end is closed.
fn pass(mut host: TcpStream, board: TcpStream, way: &Mutex<Way>) -> io::Result<()> {
    host.set_nodelay(true)?;
    board.set_nodelay(true)?;
    let (mut asked, mut to_board) = (host.try_clone()?, board.try_clone()?);
    std::thread::spawn(move || {
        let _ = io::copy(&mut asked, &mut to_board);
        let _ = to_board.shutdown(Shutdown::Both);
    });
    let answered = answers(&mut host, board, way);
    let _ = host.shutdown(Shutdown::Both);
    answered
}

fn answers(host: &mut TcpStream, mut board: TcpStream, way: &Mutex<Way>) -> io::Result<()> {
    board.set_read_timeout(Some(LOOK))?;
    let (mut waiting, mut last, mut frame) = (VecDeque::new(), Vec::new(), Vec::new());
    let mut sent = Instant::now();
    let mut buffer = [0; 4096];
    loop {
        match board.read(&mut buffer) {
            Ok(0) => return Ok(()),
            Ok(count) => waiting.extend(&buffer[..count]),
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {}
            Err(error) => return Err(error),
        }
        let way = *way.lock().unwrap_or_else(PoisonError::into_inner);
        match way {
            Way::Plain => {
                let bytes: Vec<u8> = waiting.drain(..).collect();
                host.write_all(&bytes)?;
                for byte in bytes {
                    frame.push(byte);
                    // A frame ends with a zero.
                    if byte == 0 {
                        last = std::mem::take(&mut frame);
                    }
                }
            }
            Way::Drip if sent.elapsed() >= DRIP => {
                if let Some(byte) = waiting.pop_front() {
                    host.write_all(&[byte])?;
                    sent = Instant::now();
                }
            }
            Way::OldFrames if sent.elapsed() >= REPEAT => {
                waiting.clear();
                host.write_all(&last)?;
                sent = Instant::now();
            }
            Way::Drip | Way::OldFrames => {}
        }
    }
}
