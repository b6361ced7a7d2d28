// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The chip end of an inter-integrated-circuit bus.

use std::any::Any;
use std::collections::VecDeque;

use crate::chip::Timeline;
use crate::device::Level;
use crate::snapshot::{Store, store};
use crate::time::EventId;

/// A 10-bit address's header as a 7-bit address carries it, `11110` above the address's top two bits.
const TEN_BIT_HEADER: u8 = 0x78;

/// The bus's general-call address, which a chip that takes the general call acknowledges for a write.
pub(crate) const GENERAL_CALL: u8 = 0x00;

/// The second byte of a general call that has every chip taking it reset.
pub(crate) const GENERAL_CALL_RESET: u8 = 0x06;

/// An integrated circuit on an I2C bus: what a controller, on a part or inside another chip, addresses.
///
/// A transaction is a start carrying an address and a direction, bytes one way, and a stop. A
/// restart is another start without the stop. The controller calls this and never learns what's
/// behind it. A chip implements it and never learns there's a controller. A chip that isn't at the
/// address doesn't acknowledge the start, and the controller reads nothing from it.
///
/// `Any` so a controller with several peers on one bus can hand a board back the concrete chip it
/// hung there, the way [`crate::chip::spi::Peer`] and [`crate::chip::uart::Peer`] already do. A
/// snapshot keeps a chip through its own [`Store`].
pub trait Peer: Store + std::fmt::Debug + Send + Any {
    /// A start condition carrying `address` and whether the controller will read. Returns the
    /// acknowledge.
    fn start(&mut self, address: u8, read: bool, context: &mut Timeline<'_, '_>) -> bool;

    /// One byte from the controller, after a start it acknowledged for a write. Returns the
    /// acknowledge.
    fn write(&mut self, byte: u8, context: &mut Timeline<'_, '_>) -> bool;

    /// One byte to the controller, after a start it acknowledged for a read. `last` is the
    /// controller's not-acknowledge, which says the stop is next.
    fn read(&mut self, last: bool, context: &mut Timeline<'_, '_>) -> u8;

    /// The stop condition.
    fn stop(&mut self, context: &mut Timeline<'_, '_>);

    /// An event this chip scheduled through the [`Timeline`] it was handed, at its instant. The
    /// controller hands every event of its instance to every chip it carries, after its own, so a
    /// chip ignores an id it didn't ask for. A silenced chip hears its events all the same, since
    /// what it does with time goes on while it's cut off. Nothing, for a chip that schedules none.
    fn on_event(&mut self, _event: EventId, _context: &mut Timeline<'_, '_>) {}

    /// The part this chip hangs on restarted at the instant `context` gives, and every event the
    /// chip scheduled through its controller went with the reset, since a chip keeps running
    /// through its part's reset. A chip that keeps time schedules again here. Nothing, for a chip
    /// that schedules none.
    fn restarted(&mut self, _context: &mut Timeline<'_, '_>) {}

    /// The level of the chip's one open-drain output to the board, an interrupt or an alert, at the
    /// instant of `context`. A chip with no such pin leaves it released, which is high with the
    /// pull-up the open drain needs.
    ///
    /// A controller that carries the pin to the part asks after every call it makes of the chip and
    /// every event the chip hears, and reports a change of level on a request line of its own.
    /// A chip that schedules the instant its pin changes, through the [`Timeline`] it was handed,
    /// is asked at that instant.
    fn interrupt_pin(&mut self, _context: &mut Timeline<'_, '_>) -> Level {
        Level::High
    }

    /// Every byte this peer has been written, oldest first, or nothing where it keeps no log.
    ///
    /// The far end's own record, the same job [`crate::chip::spi::Peer::received`] and
    /// [`crate::chip::uart::Peer::received`] do for their own buses: it is what says a byte reached
    /// the far end, rather than the controller's own belief that it sent one.
    fn received(&self) -> &[u8] {
        &[]
    }
}

/// A peer that answers one address, holds a known sequence, repeats its last byte once that drains,
/// and records every byte it was sent, the same job [`crate::chip::spi::Pattern`] and
/// [`crate::chip::uart::Pattern`] do for their own buses: what it answers is known and different
/// from what it was given, so a controller reading its own write back is caught, and what it records
/// is the far end's own evidence the bytes crossed.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct Pattern {
    address: u8,
    answers: VecDeque<u8>,
    held: u8,
    received: Vec<u8>,
    /// Every acknowledge this peer was asked to give a read byte, oldest first, so a check can tell
    /// the controller actually `NACKed` the last one of a bounded read rather than merely stopped
    /// asking for more.
    lasts: Vec<bool>,
}

impl Pattern {
    /// A peer at `address` answering `bytes`, oldest first, then repeating the last one.
    #[must_use]
    pub fn answering(address: u8, bytes: impl IntoIterator<Item = u8>) -> Self {
        Self {
            address,
            answers: bytes.into_iter().collect(),
            held: 0,
            received: Vec::new(),
            lasts: Vec::new(),
        }
    }

    /// Every acknowledge the controller gave a byte this peer answered, oldest first.
    #[must_use]
    pub fn lasts(&self) -> &[bool] {
        &self.lasts
    }
}

store!(Pattern);

impl Peer for Pattern {
    fn start(&mut self, address: u8, _read: bool, _context: &mut Timeline<'_, '_>) -> bool {
        address == self.address
    }

    fn write(&mut self, byte: u8, _context: &mut Timeline<'_, '_>) -> bool {
        self.received.push(byte);
        true
    }

    fn read(&mut self, last: bool, _context: &mut Timeline<'_, '_>) -> u8 {
        self.lasts.push(last);
        if let Some(byte) = self.answers.pop_front() {
            self.held = byte;
        }
        self.held
    }

    fn received(&self) -> &[u8] {
        &self.received
    }

    fn stop(&mut self, _context: &mut Timeline<'_, '_>) {}
}

/// A 10-bit-addressed stand-in for a bench with no 10-bit chip model yet. It acknowledges the header,
/// `11110` and its own top two address bits, then its own second byte, and a repeated header with
/// the read bit turns it around with no second byte at all.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
pub struct TenBit {
    address: u16,
    expecting_second_byte: bool,
    received: Vec<u8>,
    answers: VecDeque<u8>,
    held: u8,
}

impl TenBit {
    /// A peer at the 10-bit `address` answering `bytes`, oldest first, then repeating the last one.
    #[must_use]
    pub fn answering(address: u16, bytes: impl IntoIterator<Item = u8>) -> Self {
        Self {
            address,
            expecting_second_byte: false,
            received: Vec::new(),
            answers: bytes.into_iter().collect(),
            held: 0,
        }
    }
}

store!(TenBit);

impl Peer for TenBit {
    fn start(&mut self, header: u8, read: bool, _context: &mut Timeline<'_, '_>) -> bool {
        let top = u8::try_from((self.address >> 8) & 0x3).unwrap_or(0);
        if header != TEN_BIT_HEADER | top {
            return false;
        }
        self.expecting_second_byte = !read;
        true
    }

    fn write(&mut self, byte: u8, _context: &mut Timeline<'_, '_>) -> bool {
        if self.expecting_second_byte {
            self.expecting_second_byte = false;
            return byte == u8::try_from(self.address & 0xFF).unwrap_or(0);
        }
        self.received.push(byte);
        true
    }

    fn read(&mut self, _last: bool, _context: &mut Timeline<'_, '_>) -> u8 {
        if let Some(byte) = self.answers.pop_front() {
            self.held = byte;
        }
        self.held
    }

    fn received(&self) -> &[u8] {
        &self.received
    }

    fn stop(&mut self, _context: &mut Timeline<'_, '_>) {}
}
