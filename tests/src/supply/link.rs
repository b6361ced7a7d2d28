//! A serial line to a board whose supply fails at a given instant, or might.

use super::outage::{Cut, Next, Outage};
use crate::rigged::Fault;
use calib_link::Transport;
use calib_twin::runner::{Emulator, SharedEmulator, Torn};
use std::io;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// State the cut left, once it has come.
#[derive(Clone, Debug, Default)]
pub(super) struct Failure(Arc<Mutex<Option<Torn>>>);

impl Failure {
    pub(super) fn torn(&self) -> Option<Torn> {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn note(&self, torn: Torn) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(torn);
    }
}

/// An instant to come.
#[derive(Clone, Copy, Debug)]
enum Due {
    At(Duration),
    Operation {
        ordinal: u64,
        fraction: f64,
    },
    /// In that operation, or when there were more erases than so many.
    OperationOrErase {
        ordinal: u64,
        before: u64,
        fraction: f64,
    },
    /// When there were more erases than so many.
    Erase {
        before: u64,
        fraction: f64,
    },
}

impl Due {
    fn of(cut: Cut, board: &Emulator) -> Self {
        match cut {
            Cut::After(duration) => Self::At(board.elapsed().saturating_add(duration)),
            Cut::InOperation { nth, fraction } => Self::Operation {
                ordinal: board.flash_watch().operations() + nth,
                fraction,
            },
            Cut::InErase(fraction) => Self::Erase {
                before: erases(board),
                fraction,
            },
            Cut::InOperationOrErase { nth, fraction } => Self::OperationOrErase {
                ordinal: board.flash_watch().operations() + nth,
                before: erases(board),
                fraction,
            },
        }
    }

    /// The trap ends a run in its operation. When bytes for the host end one first, the operation
    /// has begun as well, and this instant is as good.
    fn has_come(self, board: &Emulator) -> bool {
        match self {
            Self::At(instant) => board.elapsed() >= instant,
            Self::Operation { ordinal, .. } => board.flash_watch().operations() >= ordinal,
            Self::Erase { before, .. } => erases(board) > before,
            Self::OperationOrErase {
                ordinal, before, ..
            } => board.flash_watch().operations() >= ordinal || erases(board) > before,
        }
    }

    /// How long to run at most; sets the trap, which every reset of the part takes away.
    fn prepare(self, board: &Emulator, wanted: Duration) -> Duration {
        match self {
            Self::At(instant) => wanted.min(instant.saturating_sub(board.elapsed())),
            Self::Operation { ordinal, fraction } => {
                board.flash_watch().set_trap(ordinal, fraction);
                wanted
            }
            Self::Erase { fraction, .. } => {
                board.flash_watch().set_erase_trap(fraction);
                wanted
            }
            Self::OperationOrErase {
                ordinal, fraction, ..
            } => {
                board.flash_watch().set_trap_or_erase(ordinal, fraction);
                wanted
            }
        }
    }
}

/// Erases begun so far.
pub(super) fn erases(board: &Emulator) -> u64 {
    board.flash_watch().erases().iter().sum()
}

/// The line; after the cut it is gone.
pub(super) struct FailingLink {
    board: SharedEmulator,
    due: Due,
    outage: Arc<Mutex<dyn Outage>>,
    failure: Failure,
    received: Vec<u8>,
}

impl FailingLink {
    /// A line whose first cut is `cut`; `outage` says what comes of it.
    pub(super) fn new(
        board: SharedEmulator,
        cut: Cut,
        outage: Arc<Mutex<dyn Outage>>,
        failure: Failure,
    ) -> Self {
        let due = {
            let board = board.lock().unwrap_or_else(PoisonError::into_inner);
            Due::of(cut, &board)
        };
        Self {
            board,
            due,
            outage,
            failure,
            received: Vec::new(),
        }
    }

    /// Runs for `duration`, with `wake` until the board has sent something, or until the cut.
    fn run(&mut self, duration: Duration, wake: bool) -> io::Result<()> {
        let shared = Arc::clone(&self.board);
        let mut board = shared.lock().unwrap_or_else(PoisonError::into_inner);
        let goal = board.elapsed().saturating_add(duration);
        loop {
            if self.failure.torn().is_some() {
                return Err(io::ErrorKind::BrokenPipe.into());
            }
            if self.outage().is_due() {
                self.meet(&mut board).map_err(io::Error::other)?;
                continue;
            }
            let limit = goal.saturating_sub(board.elapsed());
            let limit = self.due.prepare(&board, limit);
            let ran = match wake {
                true => board.run_until_received(limit).map(drop),
                false => board.run_for(limit),
            };
            ran.map_err(io::Error::other)?;
            if self.due.has_come(&board) {
                self.meet(&mut board).map_err(io::Error::other)?;
                continue;
            }
            self.received.extend(board.read_serial());
            let heard = wake && !self.received.is_empty();
            if heard || board.elapsed() >= goal {
                return Ok(());
            }
        }
    }

    /// The instant has come: the supply fails, or goes on to the next one.
    fn meet(&mut self, board: &mut Emulator) -> Result<(), Fault> {
        let next = self.outage().come(board)?;
        match next {
            Next::Fail => self.failure.note(board.cut_power()?),
            Next::GoOn(cut) => self.due = Due::of(cut, board),
        }
        Ok(())
    }

    fn outage(&self) -> MutexGuard<'_, dyn Outage + 'static> {
        self.outage.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Transport for FailingLink {
    fn name(&self) -> String {
        "emulated".to_owned()
    }

    fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        if self.failure.torn().is_some() {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        let mut board = self.board.lock().unwrap_or_else(PoisonError::into_inner);
        board.write_serial(bytes);
        Ok(())
    }

    fn now(&self) -> Duration {
        let board = self.board.lock();
        board.unwrap_or_else(PoisonError::into_inner).elapsed()
    }

    fn receive(&mut self, buffer: &mut [u8], timeout: Duration) -> io::Result<usize> {
        if self.received.is_empty() {
            self.run(timeout, true)?;
        }
        let count = buffer.len().min(self.received.len());
        for (place, byte) in buffer.iter_mut().zip(self.received.drain(..count)) {
            *place = byte;
        }
        Ok(count)
    }

    fn wait(&mut self, duration: Duration) -> io::Result<()> {
        self.run(duration, false)
    }
}
