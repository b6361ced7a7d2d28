//! The far end of USART3: the ST-LINK's virtual COM port as two queues of bytes.
//!
//! Bytes cross at the line rate the firmware set: the emulator frames each one in virtual time.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard};

use rigless::chip::Timeline;
use rigless::chip::uart::Peer;
use rigless::snapshot::{self, Reader, Store, Writer};
use rigless::time::VirtualNanos;

#[derive(Debug, Default, serde::Serialize, serde::Deserialize)]
struct Queues {
    to_board: VecDeque<u8>,
    from_board: VecDeque<u8>,
}

/// A handle of the line: the board's port holds one, the host side holds others.
#[derive(Debug, Clone, Default)]
pub struct SerialLine(Arc<Mutex<Queues>>);

impl SerialLine {
    /// Queues `bytes` for the board. They reach it one frame after another from the next instant at
    /// which the emulator looks outside.
    pub fn send(&self, bytes: &[u8]) {
        self.lock().to_board.extend(bytes);
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
