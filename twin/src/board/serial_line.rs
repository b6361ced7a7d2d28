//! The far end of the serial port as two queues of bytes: on a NUCLEO board the ST-LINK's virtual COM
//! port.
//!
//! Bytes cross at the line rate the firmware set: the emulator frames each one in virtual time.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard};

use rigless::chip::Timeline;
use rigless::chip::uart::{Errors, Peer, Rate};
use rigless::snapshot::{self, Reader, Store, Writer};
use rigless::time::VirtualNanos;

use super::line_rate;

#[derive(Debug, Default, serde::Serialize, serde::Deserialize)]
struct Queues {
    to_board: VecDeque<u8>,
    from_board: VecDeque<u8>,
    garble: Garble,
}

/// How many of the bytes for the board arrive with an error, in a million.
#[derive(Debug, Default, Clone, Copy, serde::Serialize, serde::Deserialize)]
struct Garble {
    noise: u32,
    framing: u32,
}

/// A handle of the line: the board's port holds one, the host side holds others.
#[derive(Debug, Clone, Default)]
pub struct SerialLine(Arc<Mutex<Queues>>);

impl SerialLine {
    /// Queues `bytes` for the board. They reach it one frame after another from the next instant at
    /// which the emulator looks outside.
    pub fn send(&self, bytes: &[u8]) {
        let mut queues = self.lock();
        queues.garble = Garble::default();
        queues.to_board.extend(bytes);
    }

    /// Queues what the board, at `board_baud`, hears of `bytes` that a host sends at `host_baud`
    /// without a pause. As many bytes as should arrive with noise or a framing error; which of them
    /// is drawn. What was queued before counts as sent at that rate too.
    pub fn send_at(&self, bytes: &[u8], host_baud: u32, board_baud: u32) {
        let heard = line_rate::heard(bytes, host_baud, board_baud);
        let share = |is: fn(&line_rate::Heard) -> bool| {
            let count = heard.iter().filter(|heard| is(heard)).count() as u64;
            let all = heard.len().max(1) as u64;
            (count * u64::from(Rate::EVERY_WORD) / all) as u32
        };
        let mut queues = self.lock();
        queues.garble = Garble {
            noise: share(|heard| heard.noise),
            framing: share(|heard| heard.framing),
        };
        let bytes = heard.iter().map(|heard| heard.byte);
        queues.to_board.extend(bytes);
    }

    /// Tells the emulator's receiver how bytes arrive.
    pub(super) fn garble(&self, errors: &mut Errors) {
        let Garble { noise, framing } = self.lock().garble;
        errors.noise = Rate {
            name: "line.noise",
            per_million: noise,
        };
        errors.framing = Rate {
            name: "line.framing",
            per_million: framing,
        };
    }

    /// Takes everything the board has sent since the last call.
    #[must_use]
    pub fn receive(&self) -> Vec<u8> {
        self.lock().from_board.drain(..).collect()
    }

    /// Whether the board has sent something not yet taken.
    #[must_use]
    pub fn has_received(&self) -> bool {
        !self.lock().from_board.is_empty()
    }

    /// Whether bytes still wait for the board.
    #[must_use]
    pub fn is_sending(&self) -> bool {
        !self.lock().to_board.is_empty()
    }

    /// Drops what is queued in either direction, as pulling the cable does.
    pub fn clear(&self) {
        *self.lock() = Queues::default();
    }

    fn lock(&self) -> MutexGuard<'_, Queues> {
        self.0
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

impl Store for SerialLine {
    fn store(&self, to: &mut Writer) -> Result<(), snapshot::Error> {
        to.put(&*self.lock())
    }

    fn load(&mut self, from: &mut Reader) -> Result<(), snapshot::Error> {
        *self.lock() = from.take()?;
        Ok(())
    }
}

impl Peer for SerialLine {
    fn receive(&mut self, word: u16, _context: &mut Timeline<'_, '_>) {
        self.lock().from_board.push_back(word as u8);
    }

    fn transmit(&mut self, _now: VirtualNanos) -> Option<u16> {
        self.lock().to_board.pop_front().map(u16::from)
    }
}
