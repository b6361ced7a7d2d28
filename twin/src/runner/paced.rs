//! A board that keeps the time of the wall, with doors for host programs in other processes.
//!
//! Nothing in an emulator paces virtual time, so this does: a millisecond of it is run, doors are
//! served, and the rest of the millisecond on the wall is slept. A computer that is too slow falls
//! behind and says so instead of running faster later.

use std::time::{Duration, Instant};

use super::{Emulator, Error};
use crate::board::SerialLine;
use crate::board::usb::UsbPort;

/// Virtual time run between two looks at the doors.
const STEP: Duration = Duration::from_millis(1);

/// How far behind the wall virtual time may be before the difference is given up.
const PATIENCE: Duration = Duration::from_millis(50);

/// A link of the board: its serial line, or its USB port with the serial port opened.
pub trait HostLine {
    /// Queues `bytes` for the board.
    fn send(&self, bytes: &[u8]);

    /// Takes what the board has sent since the last call.
    fn receive(&self) -> Vec<u8>;

    /// Whether some of what was queued has not reached the board yet.
    fn is_sending(&self) -> bool;
}

impl HostLine for SerialLine {
    fn send(&self, bytes: &[u8]) {
        self.send(bytes);
    }

    fn receive(&self) -> Vec<u8> {
        self.receive()
    }

    fn is_sending(&self) -> bool {
        self.is_sending()
    }
}

impl HostLine for UsbPort {
    fn send(&self, bytes: &[u8]) {
        self.send(bytes);
    }

    fn receive(&self) -> Vec<u8> {
        self.receive()
    }

    fn is_sending(&self) -> bool {
        self.waiting() > 0
    }
}

/// A way for a host program to a link of the board. Serving it never waits.
pub trait Door: Send {
    /// How a host program addresses it.
    fn address(&self) -> String;

    /// Moves what has come from the host to the line, and `from_board` to the host.
    ///
    /// # Errors
    ///
    /// The door itself is broken; a host that goes is none.
    fn serve(&mut self, line: &dyn HostLine, from_board: &[u8]) -> std::io::Result<()>;
}

/// How a paced run keeps up.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Pace {
    /// Virtual time run.
    pub virtual_time: Duration,
    /// Time on the wall.
    pub wall_time: Duration,
    /// Virtual time given up because this computer was too slow.
    pub lost: Duration,
}

/// Runs `emulator` with `doors` to its link `line` at the pace of the wall until `go_on` says no; it is asked every millisecond.
///
/// # Errors
///
/// [`Error::Ended`] when the emulator or a door fails.
pub fn run_paced(
    emulator: &mut Emulator,
    line: &dyn HostLine,
    doors: &mut [Box<dyn Door>],
    mut go_on: impl FnMut(&mut Emulator, Pace) -> bool,
) -> Result<Pace, Error> {
    let start = Instant::now();
    let mut pace = Pace::default();
    while go_on(emulator, pace) {
        emulator.run_for(STEP)?;
        pace.virtual_time += STEP;
        let from_board = line.receive();
        for door in doors.iter_mut() {
            door.serve(line, &from_board)
                .map_err(|error| Error::Ended(format!("{}: {error}", door.address())))?;
        }
        pace.wall_time = start.elapsed();
        let due = pace.virtual_time + pace.lost;
        if let Some(early) = due.checked_sub(pace.wall_time) {
            std::thread::sleep(early);
        } else if pace.wall_time - due > PATIENCE {
            pace.lost += pace.wall_time - due;
        }
    }
    Ok(pace)
}
