// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The far end of a CAN bus: the nodes a controller shares its wires with.
//!
//! A bus carries one frame at a time. A node that wants to send starts at the first bit time the
//! bus is free, and nodes that start in the same bit time arbitrate by identifier, the lowest
//! winning, since a dominant bit overrides a recessive one. The node that wins sends the whole
//! frame. Every other node receives it, and any one of them can acknowledge it, which is what tells
//! the sender the frame arrived. A controller owns the bus it is on, so it plays the arbiter: it
//! asks each peer what it wants to send, picks the winner, and hands each peer the frame at the
//! instant its end of frame passes. A peer implements [`Peer`] and never learns there's a controller.
//!
//! The seam carries whole frames, not bits. How long a frame takes is the wire's, so [`Frame`]
//! counts its own bits, stuff bits included, from the format ISO 11898-1 gives it, and the
//! controller multiplies by its bit time. What a bit error does inside a frame can't be seen from
//! here, so a fault takes effect at the frame's acknowledge slot, which the seam's users say.

use std::any::Any;
use std::cmp::Ordering;
use std::collections::VecDeque;

use crate::chip::Timeline;
use crate::snapshot::{Store, store};
use crate::time::{EventId, VirtualNanos};

/// The bits of the end of frame field, which every frame closes with.
pub const END_OF_FRAME_BITS: u32 = 7;
/// The bits of the intermission after a frame, before any node may start the next.
pub const INTERMISSION_BITS: u32 = 3;
/// The bits of an error flag, active or passive.
pub const ERROR_FLAG_BITS: u32 = 6;
/// The bits of the error delimiter that ends an error frame.
pub const ERROR_DELIMITER_BITS: u32 = 8;
/// The bits an error passive transmitter waits after the intermission before it sends again.
pub const SUSPEND_BITS: u32 = 8;
/// The recessive bits that make a node accept the bus is idle.
pub const BUS_IDLE_BITS: u32 = 11;

/// The CRC's generator polynomial, ISO 11898-1's `x^15 + x^14 + x^10 + x^8 + x^7 + x^4 + x^3 + 1`.
const CRC_POLYNOMIAL: u16 = 0x4599;
/// The bits of the CRC sequence.
const CRC_BITS: u32 = 15;
/// The length of a run of equal bits after which the sender stuffs the opposite one.
const STUFF_RUN: u32 = 5;
/// The most data bytes a frame carries.
const MAX_DATA: usize = 8;

/// A frame's identifier: 11 bits for a standard frame and 29 for an extended one, whose base
/// identifier is the high 11.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Id {
    /// An 11-bit identifier.
    Standard(u16),
    /// A 29-bit identifier.
    Extended(u32),
}

impl Id {
    /// The 11-bit identifier `value`, or `None` past `0x7FF`.
    #[must_use]
    pub fn standard(value: u16) -> Option<Self> {
        (value <= 0x7FF).then_some(Self::Standard(value))
    }

    /// The 29-bit identifier `value`, or `None` past `0x1FFF_FFFF`.
    #[must_use]
    pub fn extended(value: u32) -> Option<Self> {
        (value <= 0x1FFF_FFFF).then_some(Self::Extended(value))
    }

    /// The identifier of `value` in the extended format if `extended`, else the standard, or `None`
    /// where it doesn't fit.
    #[must_use]
    pub fn new(value: u32, extended: bool) -> Option<Self> {
        if extended {
            Self::extended(value)
        } else {
            Self::standard(u16::try_from(value).ok()?)
        }
    }

    /// The number, in as many bits as the format has.
    #[must_use]
    pub fn value(self) -> u32 {
        match self {
            Self::Standard(value) => u32::from(value),
            Self::Extended(value) => value,
        }
    }

    /// Whether it's the 29-bit format.
    #[must_use]
    pub fn is_extended(self) -> bool {
        matches!(self, Self::Extended(_))
    }
}

/// One frame, as the identifier, the frame type and the bytes a node sees.
///
/// A dominant bit is 0 and a recessive one 1. A remote frame has a data length code and no data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Frame {
    /// The identifier.
    pub id: Id,
    /// Whether it requests a data frame instead of carrying one.
    pub remote: bool,
    /// The data length code, 0 to 15. A data frame carries as many bytes as it says up to eight.
    pub dlc: u8,
    /// The data bytes, the first one sent first. Only the first [`Frame::payload`] of them travel.
    pub data: [u8; 8],
}

impl Frame {
    /// A data frame of `data`, up to eight bytes.
    ///
    /// # Panics
    ///
    /// On more than eight bytes.
    #[must_use]
    pub fn data_frame(id: Id, data: &[u8]) -> Self {
        assert!(
            data.len() <= MAX_DATA,
            "a data frame carries eight bytes at most"
        );
        let mut bytes = [0; MAX_DATA];
        bytes[..data.len()].copy_from_slice(data);
        Self {
            id,
            remote: false,
            dlc: u8::try_from(data.len()).expect("up to eight"),
            data: bytes,
        }
    }

    /// A remote frame asking for `dlc` bytes.
    #[must_use]
    pub fn remote_frame(id: Id, dlc: u8) -> Self {
        Self {
            id,
            remote: true,
            dlc: dlc & 0xF,
            data: [0; MAX_DATA],
        }
    }

    /// The data bytes that cross the wire: none for a remote frame, and eight for a code above eight.
    #[must_use]
    pub fn payload(&self) -> &[u8] {
        if self.remote {
            &[]
        } else {
            &self.data[..usize::from(self.dlc).min(MAX_DATA)]
        }
    }

    /// The bits of the arbitration field, after the start of frame: the identifier and the bits
    /// that tell frame types apart, which the lowest value wins by.
    fn arbitration(&self) -> Vec<bool> {
        let mut bits = Vec::new();
        let push = |bits: &mut Vec<bool>, value: u32, width: u32| {
            bits.extend((0..width).rev().map(|bit| value >> bit & 1 == 1));
        };
        match self.id {
            Id::Extended(id) => {
                push(&mut bits, id >> 18, 11);
                bits.extend([true, true]);
                push(&mut bits, id & 0x3_FFFF, 18);
                bits.push(self.remote);
            }
            Id::Standard(id) => {
                push(&mut bits, u32::from(id), 11);
                bits.extend([self.remote, false]);
            }
        }
        bits
    }

    /// The bits from the start of frame through the CRC sequence, before stuffing.
    fn unstuffed(&self) -> Vec<bool> {
        let mut bits = vec![false];
        bits.extend(self.arbitration());
        // The reserved bits, one in the standard format and two in the extended one.
        bits.extend(if self.id.is_extended() {
            &[false, false][..]
        } else {
            &[false]
        });
        let push = |bits: &mut Vec<bool>, value: u32, width: u32| {
            bits.extend((0..width).rev().map(|bit| value >> bit & 1 == 1));
        };
        push(&mut bits, u32::from(self.dlc), 4);
        for byte in self.payload() {
            push(&mut bits, u32::from(*byte), 8);
        }
        let mut crc: u16 = 0;
        for &bit in &bits {
            let feedback = (crc >> (CRC_BITS - 1) & 1 == 1) != bit;
            crc = crc << 1 & 0x7FFF;
            if feedback {
                crc ^= CRC_POLYNOMIAL;
            }
        }
        push(&mut bits, u32::from(crc), CRC_BITS);
        bits
    }

    /// How this frame ranks against `other` in arbitration: [`Ordering::Less`] wins the bus, and
    /// [`Ordering::Equal`] is two frames that no bit tells apart.
    #[must_use]
    pub fn arbitrates(&self, other: &Self) -> Ordering {
        let (mine, theirs) = (self.arbitration(), other.arbitration());
        mine.iter()
            .zip(&theirs)
            .find(|(first, second)| first != second)
            .map_or(Ordering::Equal, |(first, _)| {
                // A dominant bit, 0, wins, so the frame that sent one ranks first.
                if *first {
                    Ordering::Greater
                } else {
                    Ordering::Less
                }
            })
    }

    /// The bit times from the start of frame through the last stuffed bit of the CRC sequence.
    #[must_use]
    pub fn stuffed_bits(&self) -> u32 {
        let mut count = 0;
        let mut run = 0;
        let mut last = None;
        for bit in self.unstuffed() {
            count += 1;
            if last == Some(bit) {
                run += 1;
            } else {
                run = 1;
                last = Some(bit);
            }
            if run == STUFF_RUN {
                count += 1;
                last = Some(!bit);
                run = 1;
            }
        }
        count
    }

    /// The bit times from the start of frame through the acknowledge slot, where a frame nobody
    /// acknowledges fails: the stuffed bits, then the CRC delimiter and the slot.
    #[must_use]
    pub fn bits_through_acknowledge(&self) -> u32 {
        self.stuffed_bits() + 2
    }

    /// The bit times from the start of frame to the last-but-one bit of the end of frame field, when
    /// a frame is valid at the nodes that receive it, ISO 11898-1.
    #[must_use]
    pub fn bits_until_valid(&self) -> u32 {
        self.bits_on_the_wire() - 1
    }

    /// The bit times from the start of frame to the end of the end of frame field, which is when
    /// the sender is sure of the frame: the stuffed bits, the CRC delimiter, the acknowledge slot and its
    /// delimiter, and the seven of the end of frame.
    #[must_use]
    pub fn bits_on_the_wire(&self) -> u32 {
        self.stuffed_bits() + 3 + END_OF_FRAME_BITS
    }
}

/// What a node finds wrong with a frame it receives, the codes of the last error field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Fault {
    /// More than five equal bits in a row where stuffing applies.
    Stuff,
    /// A fixed-format field with the wrong value.
    Form,
    /// A CRC sequence that doesn't match the frame.
    Crc,
}

/// A frame a node wants to send and when it asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Offer {
    /// The instant the node asked for the bus. A node that asks while the bus is busy starts when it
    /// frees, and one that asks in the bit time another starts in arbitrates.
    pub since: VirtualNanos,
    /// The frame.
    pub frame: Frame,
    /// What every other node finds wrong with it, for a node that sends a damaged one.
    pub fault: Option<Fault>,
}

/// A node on a CAN bus: what a controller, on a part or inside another chip, shares its wires with.
///
/// The controller calls this and never learns what's behind it. A chip implements it and never
/// learns there's a controller. Every peer on the bus is a receiving node, so a frame the
/// controller sends is acknowledged while any of them answers, and not while none does. A silenced
/// peer ([`Place::silence`](crate::chip::Place::silence)) is off the bus: it hears nothing, offers
/// nothing and acknowledges nothing. A snapshot keeps a chip through its own [`Store`].
pub trait Peer: Store + std::fmt::Debug + Send + Any {
    /// A frame that is valid on the bus at the instant `context` gives, the last-but-one bit of its
    /// end of frame, which the peer didn't send. Called for every frame that was acknowledged, the
    /// controller's and another peer's.
    fn receive(&mut self, frame: &Frame, context: &mut Timeline<'_, '_>);

    /// The frame this peer wants to send next, or `None` where it has none. Asked often and never
    /// consumed: it's the controller looking at what the peer holds, and the peer keeps the frame
    /// until [`Peer::sent`], so one that loses arbitration is still on offer.
    fn offer(&self) -> Option<Offer>;

    /// The offered frame was on the bus from its start to its end, at the instant `context` gives,
    /// which is a bit after receivers had it. `acknowledged` says some node answered in the
    /// acknowledge slot. A peer sends an unacknowledged frame again, as ISO 11898-1 has it, by
    /// keeping it on offer, and drops one that was acknowledged here.
    fn sent(&mut self, acknowledged: bool, context: &mut Timeline<'_, '_>);

    /// Whether this peer drives an error flag into `frame`, a frame the controller sends. It fails
    /// at the controller as a bit error, which the controller then counts. A peer with no fault to
    /// give leaves it.
    fn disturbs(&mut self, _frame: &Frame) -> bool {
        false
    }

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

    /// The chip's own supply went off, with `on` false, or came back, at the instant `context`
    /// gives. A chip loses what it keeps when its supply goes and starts from power on when it comes
    /// back. Its place keeps the controller from it while it's off. Nothing, for a chip that keeps
    /// nothing.
    fn power_changed(&mut self, _on: bool, _context: &mut Timeline<'_, '_>) {}

    /// The supply outputs this chip switches for the board, bit n for output n, set while the
    /// output is on. A controller that carries them to the part asks after every call it makes of
    /// the chip and reports each change on a request line of its own. None, for a chip that switches
    /// no supply.
    fn supplies(&self) -> u32 {
        0
    }
}

/// A peer that records every frame it hears with the instant it heard it, and sends the frames it
/// was given, one at a time in the order it was given them.
///
/// It's what a bench hangs on a bus with no chip model for it yet. What it sends is known and
/// different from what the controller sent, so a controller that never reached it is caught, and
/// what it records is the far end's own evidence that a frame arrived.
#[derive(Debug, Default, serde::Serialize, serde::Deserialize)]
pub struct Pattern {
    offers: VecDeque<Offer>,
    heard: Vec<(VirtualNanos, Frame)>,
    outcomes: Vec<bool>,
    disturbed: u32,
}

impl Pattern {
    /// A peer that sends `offers`, oldest first, each when it asked for the bus.
    #[must_use]
    pub fn offering(offers: impl IntoIterator<Item = Offer>) -> Self {
        Self {
            offers: offers.into_iter().collect(),
            ..Self::default()
        }
    }

    /// Adds `offer` after the frames this peer already has to send.
    pub fn queue(&mut self, offer: Offer) {
        self.offers.push_back(offer);
    }

    /// This peer drives an error flag into the next `count` frames the controller sends.
    #[must_use]
    pub fn disturbing(mut self, count: u32) -> Self {
        self.disturbed = count;
        self
    }

    /// Every frame heard, with the instant its end of frame passed.
    #[must_use]
    pub fn heard(&self) -> &[(VirtualNanos, Frame)] {
        &self.heard
    }

    /// Whether each frame this peer sent was acknowledged, in the order it sent them.
    #[must_use]
    pub fn outcomes(&self) -> &[bool] {
        &self.outcomes
    }
}

store!(Pattern);

impl Peer for Pattern {
    fn receive(&mut self, frame: &Frame, context: &mut Timeline<'_, '_>) {
        self.heard.push((context.now(), *frame));
    }

    fn offer(&self) -> Option<Offer> {
        self.offers.front().copied()
    }

    fn sent(&mut self, acknowledged: bool, _context: &mut Timeline<'_, '_>) {
        if acknowledged {
            self.offers.pop_front();
        }
        self.outcomes.push(acknowledged);
    }

    fn disturbs(&mut self, _frame: &Frame) -> bool {
        let disturbs = self.disturbed > 0;
        self.disturbed = self.disturbed.saturating_sub(1);
        disturbs
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extended(id: u32, data: &[u8]) -> Frame {
        Frame::data_frame(Id::Extended(id), data)
    }

    /// The lengths below were counted from the frame format by a separate program, which builds the
    /// bit stream field by field, computes the CRC bit by bit and inserts the stuff bits.
    #[test]
    fn a_frame_takes_the_bits_its_format_and_stuffing_give_it() {
        let cases = [
            (Frame::data_frame(Id::Standard(0x123), &[0xAB, 0xCD]), 52),
            (Frame::data_frame(Id::Standard(0), &[]), 40),
            (Frame::remote_frame(Id::Standard(0x7FF), 0), 37),
            (extended(0x1FFF_FFFF, &[0xFF; 8]), 136),
            (extended(0x18F3_A5C1, &[1, 2, 3, 4, 5, 6, 7, 8]), 130),
            (extended(0x1555_5555, &[0x55; 8]), 118),
            (Frame::data_frame(Id::Standard(0x555), &[0x55; 8]), 99),
        ];
        for (frame, stuffed) in cases {
            assert_eq!(frame.stuffed_bits(), stuffed, "{frame:?}");
            assert_eq!(frame.bits_on_the_wire(), stuffed + 10, "{frame:?}");
            assert_eq!(frame.bits_through_acknowledge(), stuffed + 2, "{frame:?}");
        }
    }

    #[test]
    fn a_data_length_code_above_eight_carries_eight_bytes_and_a_remote_frame_none() {
        let mut frame = Frame::data_frame(Id::Standard(1), &[1, 2, 3, 4, 5, 6, 7, 8]);
        frame.dlc = 12;
        assert_eq!(frame.payload(), [1, 2, 3, 4, 5, 6, 7, 8]);
        assert_eq!(Frame::remote_frame(Id::Standard(1), 5).payload(), []);
        assert_eq!(Frame::remote_frame(Id::Standard(1), 5).dlc, 5);
    }

    #[test]
    fn the_lower_identifier_wins_and_the_types_rank_by_their_bits() {
        let low = Frame::data_frame(Id::Standard(0x100), &[]);
        let high = Frame::data_frame(Id::Standard(0x101), &[]);
        assert_eq!(low.arbitrates(&high), Ordering::Less);
        assert_eq!(high.arbitrates(&low), Ordering::Greater);
        assert_eq!(low.arbitrates(&low), Ordering::Equal);
        let base = Frame::data_frame(Id::Standard(0x100), &[]);
        let wide = extended(0x100 << 18, &[]);
        assert_eq!(base.arbitrates(&wide), Ordering::Less);
        let remote = Frame::remote_frame(Id::Standard(0x100), 0);
        assert_eq!(remote.arbitrates(&wide), Ordering::Less);
        assert_eq!(base.arbitrates(&remote), Ordering::Less);
    }

    #[test]
    fn an_identifier_that_doesnt_fit_its_format_is_refused() {
        assert_eq!(Id::new(0x7FF, false), Some(Id::Standard(0x7FF)));
        assert_eq!(Id::new(0x800, false), None);
        assert_eq!(Id::new(0x1FFF_FFFF, true), Some(Id::Extended(0x1FFF_FFFF)));
        assert_eq!(Id::extended(0x2000_0000), None);
        assert_eq!(Id::standard(0x800), None);
    }

    #[test]
    fn extended_identifiers_arbitrate_on_the_low_bits_after_the_base() {
        let first = extended(0x0555_0001, &[]);
        let second = extended(0x0555_0002, &[]);
        assert_eq!(first.arbitrates(&second), Ordering::Less);
    }
}
