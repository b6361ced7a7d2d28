//! When the supply fails, and the outcome: the supply fails, or a second board is asked how it would have been.

use crate::rigged::Fault;
use calib_twin::runner::Emulator;
use std::time::Duration;

/// When the supply fails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// So long after power-on.
    After(Duration),
    /// In an operation on the record flash.
    InOperation {
        /// Which one from power-on, counted from 1.
        nth: u64,
        /// How far into it, from 0 to 1.
        fraction: f64,
    },
    /// In the next erase of a sector, so far into it, from 0 to 1.
    InErase(f64),
    /// In an operation on the record flash, or in an erase that comes before it.
    InOperationOrErase {
        /// Which one from here, counted from 1.
        nth: u64,
        /// How far into it, from 0 to 1.
        fraction: f64,
    },
}

/// Event after an instant at which the supply might fail.
pub(super) enum Next {
    /// It fails.
    Fail,
    /// It holds until then.
    GoOn(Cut),
}

/// Decides about the cuts of a spell of power.
pub(super) trait Outage: Send {
    /// Whether one is to come now, whatever was planned: when the host has just been told something.
    fn is_due(&self) -> bool {
        false
    }

    /// The instant of a cut has come; `board` stands at it.
    ///
    /// # Errors
    /// Losses there would have been.
    fn come(&mut self, board: &mut Emulator) -> Result<Next, Fault>;

    /// A start is done: the host has looked for everything it was told.
    ///
    /// # Errors
    /// The start came to something else than it should have.
    fn started(&mut self, board: &mut Emulator) -> Result<(), Fault>;
}

/// The supply fails the first time it may.
pub(super) struct Fails;

impl Outage for Fails {
    fn come(&mut self, _board: &mut Emulator) -> Result<Next, Fault> {
        Ok(Next::Fail)
    }

    fn started(&mut self, _board: &mut Emulator) -> Result<(), Fault> {
        Ok(())
    }
}
