// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! A node of a CSP 1.x network on a CAN bus: the packet header, the CRC32 trailer, and the CAN
//! Fragmentation Protocol that carries a packet in 8-byte frames, both ways.
//!
//! The Cubesat Space Protocol is a small network layer, and its CAN interface cuts each packet into
//! frames with 29-bit identifiers. [`Interface`] is that interface for a chip that sits on a
//! [`can`](crate::chip::can) bus. It takes the frames the chip hears, hands back whole packets, and
//! turns a packet the chip sends into the frames to put on the bus. What the packets mean is the
//! chip's. HMAC, XTEA and RDP are not here. A packet that asks for one is the chip's to refuse.
//!
//! The format is libcsp 1.6's, which is public, and it's what the flight software links.
//!
//! | Behavior | Source | Test |
//! |---|---|---|
//! | Header: 2 bits priority, 5 source, 5 destination, 6 destination port, 6 source port, 8 flags, most significant first. A priority, a node or a port past its width can't be made | libcsp 1.6 `csp_types.h`, `CSP_ID_*_SIZE` and the masks | `a_header_packs_into_its_thirty_two_bits`, `a_field_past_its_width_is_refused` |
//! | Flags: CRC32 `0x01`, RDP `0x02`, XTEA `0x04`, HMAC `0x08` | libcsp 1.6 `csp_types.h`, `CSP_FCRC32` and the rest | `a_header_packs_into_its_thirty_two_bits` |
//! | CRC32 trailer: the Castagnoli polynomial, initial value and final XOR all ones, over the data alone, appended most significant byte first and counted in the length | libcsp 1.6 `csp_crc32.c` and `csp_io.c`, which leave the header out for CSP 1.x | `the_crc_of_the_standard_check_string_is_castagnolis`, `a_sealed_packet_opens_and_a_damaged_one_does_not` |
//! | Identifier: 5 bits source, 5 destination, 1 type, 8 remaining frames, 10 sequence, most significant first. The source is the packet's, not the interface's | libcsp 1.6 `csp_if_can.h`, `CFP_*` and `csp_if_can.c` `csp_can_tx` | `an_identifier_carries_its_fields_in_order` |
//! | First frame: the header and the 16-bit length, most significant byte first, then up to two bytes of data. Each later frame: up to eight. Remaining counts the frames after this one | `csp_can_tx` | `a_packet_is_cut_into_a_first_frame_and_eight_byte_frames`, `a_packet_with_no_data_is_one_frame` |
//! | One sequence number for every frame of a packet, counting up and wrapping at 1024 | `csp_can_tx`, `cfp_frame_id` | `the_sequence_counts_up_and_wraps_at_ten_bits` |
//! | A packet past 2042 bytes isn't sent | `csp_can_tx`, `MAX_CAN_DATA_SIZE` | `a_packet_past_the_longest_is_refused` |
//! | Reassembly keyed by source, destination and sequence, so packets from two sources under one sequence don't mix. A first frame starts a packet, and a later frame with none started is dropped | `csp_can_rx` | `a_packet_comes_back_out_of_its_frames`, `two_packets_interleaved_by_sequence_both_come_back`, `packets_from_two_sources_under_one_sequence_both_come_back`, `a_later_frame_with_no_first_one_is_dropped` |
//! | A first frame under six bytes, a length past 2042, a remaining count out of step and data past the length all drop the packet | `csp_can_rx` | `a_short_first_frame_is_dropped`, `a_remaining_count_out_of_step_drops_the_packet`, `data_past_the_length_drops_the_packet`, `a_length_past_the_longest_is_dropped` |
//! | A first frame while one is half heard restarts the packet | `csp_can_rx` | `a_first_frame_restarts_a_half_heard_packet` |
//! | A node takes the frames addressed to it. Remote frames and 11-bit identifiers aren't CFP | the interface listens by destination | `frames_for_another_node_and_standard_frames_are_not_heard` |
//!
//! **Left out.** A half-heard packet never times out. libcsp frees it after a while, and the model
//! keeps it until a first frame with the same source, destination and sequence starts it over.
//! Nothing in this repository gives that time.

use std::collections::BTreeMap;

use crate::chip::can::{Frame, Id};
use crate::snapshot::store;

/// The header flag for a CRC32 trailer.
pub const CRC32: u8 = 0x01;
/// The header flag for RDP.
pub const RDP: u8 = 0x02;
/// The header flag for XTEA encryption.
pub const XTEA: u8 = 0x04;
/// The header flag for an HMAC trailer.
pub const HMAC: u8 = 0x08;

/// The most data a packet carries over CAN: 256 frames of eight bytes, less the header and length.
pub const LONGEST: usize = 256 * 8 - HEADER_AND_LENGTH_BYTES;

const HEADER_BYTES: usize = 4;
const HEADER_AND_LENGTH_BYTES: usize = HEADER_BYTES + 2;
const FRAME_BYTES: usize = 8;
const SEQUENCE_MODULUS: u16 = 1 << 10;
const CASTAGNOLI_REFLECTED: u32 = 0x82F6_3B78;

/// A number too wide for the header field it was meant for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{0} doesn't fit its field of the CSP header")]
pub struct OutOfRange(pub u8);

macro_rules! field {
    ($(#[$meta:meta])* $name:ident, $bits:literal, $what:literal) => {
        $(#[$meta])*
        #[derive(
            Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize,
            serde::Deserialize,
        )]
        #[serde(try_from = "u8", into = "u8")]
        pub struct $name(u8);

        impl $name {
            #[doc = concat!("The ", $what, " `value`, or `None` past ", $bits, " bits.")]
            #[must_use]
            pub const fn new(value: u8) -> Option<Self> {
                if value >> $bits == 0 {
                    Some(Self(value))
                } else {
                    None
                }
            }

            #[doc = concat!("The ", $what, " as a number.")]
            #[must_use]
            pub const fn get(self) -> u8 {
                self.0
            }

            fn low_bits_of(word: u32, shift: u32) -> Self {
                Self(u8::try_from(word >> shift & ((1 << $bits) - 1)).expect("a field of at most eight bits"))
            }
        }

        impl TryFrom<u8> for $name {
            type Error = OutOfRange;

            fn try_from(value: u8) -> Result<Self, OutOfRange> {
                Self::new(value).ok_or(OutOfRange(value))
            }
        }

        impl From<$name> for u8 {
            fn from(value: $name) -> u8 {
                value.0
            }
        }
    };
}

field!(
    /// A packet's priority, 0 to 3.
    Priority,
    2,
    "priority"
);
field!(
    /// A node's address, 0 to 31.
    Node,
    5,
    "node"
);
field!(
    /// A port, 0 to 63.
    Port,
    6,
    "port"
);

/// The header of a CSP 1.x packet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Header {
    /// The priority.
    pub priority: Priority,
    /// The node it came from.
    pub source: Node,
    /// The node it's for.
    pub destination: Node,
    /// The port it's for.
    pub destination_port: Port,
    /// The port it came from.
    pub source_port: Port,
    /// The flags: [`CRC32`], [`RDP`], [`XTEA`] and [`HMAC`].
    pub flags: u8,
}

impl Header {
    /// The header as the 32 bits on the wire.
    #[must_use]
    pub fn pack(self) -> u32 {
        u32::from(self.priority.0) << 30
            | u32::from(self.source.0) << 25
            | u32::from(self.destination.0) << 20
            | u32::from(self.destination_port.0) << 14
            | u32::from(self.source_port.0) << 8
            | u32::from(self.flags)
    }

    /// The header in `word`.
    #[must_use]
    pub fn unpack(word: u32) -> Self {
        Self {
            priority: Priority::low_bits_of(word, 30),
            source: Node::low_bits_of(word, 25),
            destination: Node::low_bits_of(word, 20),
            destination_port: Port::low_bits_of(word, 14),
            source_port: Port::low_bits_of(word, 8),
            flags: u8::try_from(word & 0xFF).expect("eight bits"),
        }
    }

    /// The header of an answer from this packet's destination: the nodes and the ports swapped,
    /// the priority kept and `flags` as given.
    #[must_use]
    pub fn answer(self, flags: u8) -> Self {
        Self {
            priority: self.priority,
            source: self.destination,
            destination: self.source,
            destination_port: self.source_port,
            source_port: self.destination_port,
            flags,
        }
    }
}

/// A packet: a header and the data after it, as the network carries them. A packet with the
/// [`CRC32`] flag carries its trailer as the last four bytes of the data.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Packet {
    /// The header.
    pub header: Header,
    /// The data, trailer included.
    pub data: Vec<u8>,
}

/// A packet that claims a CRC32 and doesn't carry a good one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the packet's CRC32 doesn't match its data")]
pub struct BadCrc;

/// A packet too long for CAN.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{0} bytes of data is more than the {LONGEST} a CAN packet carries")]
pub struct TooLong(pub usize);

/// The CRC32 of `bytes` in the Castagnoli polynomial, as CSP's trailer is.
#[must_use]
pub fn crc32c(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, &byte| {
        (0..u8::BITS).fold(crc ^ u32::from(byte), |crc, _| {
            if crc & 1 == 0 {
                crc >> 1
            } else {
                (crc >> 1) ^ CASTAGNOLI_REFLECTED
            }
        })
    })
}

impl Packet {
    /// The packet with its data sealed: the trailer appended and the [`CRC32`] flag set.
    #[must_use]
    pub fn sealed(mut self) -> Self {
        self.data.extend(crc32c(&self.data).to_be_bytes());
        self.header.flags |= CRC32;
        self
    }

    /// The data without its trailer, after checking the trailer, if the packet has the [`CRC32`]
    /// flag. Without the flag it's the data as it is.
    pub fn opened(&self) -> Result<&[u8], BadCrc> {
        if self.header.flags & CRC32 == 0 {
            return Ok(&self.data);
        }
        let split = self.data.len().checked_sub(4).ok_or(BadCrc)?;
        let (data, trailer) = self.data.split_at(split);
        if trailer == crc32c(data).to_be_bytes() {
            Ok(data)
        } else {
            Err(BadCrc)
        }
    }
}

/// The fields of a CFP identifier.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Identifier {
    /// The packet's source node.
    pub source: Node,
    /// The node the frame goes to.
    pub destination: Node,
    /// Whether this is a packet's first frame.
    pub first: bool,
    /// The frames after this one.
    pub remaining: u8,
    /// Which packet, 0 to 1023.
    pub sequence: u16,
}

impl Identifier {
    /// The 29 bits of the identifier.
    #[must_use]
    pub fn pack(self) -> u32 {
        u32::from(self.source.0) << 24
            | u32::from(self.destination.0) << 19
            | u32::from(!self.first) << 18
            | u32::from(self.remaining) << 10
            | u32::from(self.sequence % SEQUENCE_MODULUS)
    }

    /// The fields in `id`.
    #[must_use]
    pub fn unpack(id: u32) -> Self {
        Self {
            source: Node::low_bits_of(id, 24),
            destination: Node::low_bits_of(id, 19),
            first: id >> 18 & 1 == 0,
            remaining: u8::try_from(id >> 10 & 0xFF).expect("eight bits"),
            sequence: u16::try_from(id & u32::from(SEQUENCE_MODULUS - 1)).expect("ten bits"),
        }
    }
}

#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Reassembly {
    header: Header,
    length: usize,
    data: Vec<u8>,
    frames_to_come: u8,
}

type ReassemblyKey = (Node, Node, u16);

/// What hearing a frame came to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Heard {
    /// A frame for another node, or one that isn't CFP.
    Ignored,
    /// A frame that's part of a packet not yet whole.
    Partial,
    /// A frame the interface dropped, and the packet it belonged to with it.
    Dropped,
    /// The last frame of a packet.
    Packet(Packet),
}

/// A node's CAN interface: its address, the sequence of the packets it sends and the packets it's
/// part way through hearing.
#[derive(Debug, Clone, serde::Serialize, serde::Deserialize)]
pub struct Interface {
    address: Node,
    next_sequence: u16,
    // ceiling: a half-heard packet is kept until its source, destination and sequence begin again;
    // upgrade when a run needs libcsp's timeout on a packet that never finishes
    reassembling: BTreeMap<ReassemblyKey, Reassembly>,
}

store!(Interface);

impl Interface {
    /// The interface of the node at `address`.
    #[must_use]
    pub fn new(address: Node) -> Self {
        Self {
            address,
            next_sequence: 0,
            reassembling: BTreeMap::new(),
        }
    }

    /// Takes one frame heard on the bus.
    pub fn hear(&mut self, frame: &Frame) -> Heard {
        let Id::Extended(id) = frame.id else {
            return Heard::Ignored;
        };
        let fields = Identifier::unpack(id);
        if frame.remote || fields.destination != self.address {
            return Heard::Ignored;
        }
        let key = (fields.source, fields.destination, fields.sequence);
        let payload = frame.payload();
        if !fields.first {
            return self.reassemble(key, payload, fields.remaining);
        }
        if payload.len() < HEADER_AND_LENGTH_BYTES {
            self.reassembling.remove(&key);
            return Heard::Dropped;
        }
        let word = u32::from_be_bytes(payload[..HEADER_BYTES].try_into().expect("four bytes"));
        let length = usize::from(u16::from_be_bytes([payload[4], payload[5]]));
        if length > LONGEST {
            self.reassembling.remove(&key);
            return Heard::Dropped;
        }
        self.reassembling.insert(
            key,
            Reassembly {
                header: Header::unpack(word),
                length,
                data: Vec::with_capacity(length),
                frames_to_come: fields.remaining.wrapping_add(1),
            },
        );
        self.reassemble(key, &payload[HEADER_AND_LENGTH_BYTES..], fields.remaining)
    }

    fn reassemble(&mut self, key: ReassemblyKey, bytes: &[u8], remaining: u8) -> Heard {
        let Some(packet) = self.reassembling.get_mut(&key) else {
            return Heard::Dropped;
        };
        if remaining != packet.frames_to_come.wrapping_sub(1)
            || packet.data.len() + bytes.len() > packet.length
        {
            self.reassembling.remove(&key);
            return Heard::Dropped;
        }
        packet.frames_to_come = remaining;
        packet.data.extend_from_slice(bytes);
        if packet.data.len() < packet.length {
            return Heard::Partial;
        }
        let done = self.reassembling.remove(&key).expect("held a moment ago");
        Heard::Packet(Packet {
            header: done.header,
            data: done.data,
        })
    }

    /// The frames that carry `packet` to the node `via`, which is the packet's destination where
    /// the sender has no route to put between.
    pub fn send(&mut self, packet: &Packet, via: Node) -> Result<Vec<Frame>, TooLong> {
        let length = packet.data.len();
        if length > LONGEST {
            return Err(TooLong(length));
        }
        let sequence = self.next_sequence;
        self.next_sequence = (self.next_sequence + 1) % SEQUENCE_MODULUS;
        let frames_after = |taken: usize| (length - taken).div_ceil(FRAME_BYTES);
        let identifier = |first, remaining: usize| {
            let remaining = u8::try_from(remaining).expect("at most 255 more frames");
            let id = Identifier {
                source: packet.header.source,
                destination: via,
                first,
                remaining,
                sequence,
            };
            Id::Extended(id.pack())
        };
        let head = length.min(FRAME_BYTES - HEADER_AND_LENGTH_BYTES);
        let mut bytes = packet.header.pack().to_be_bytes().to_vec();
        bytes.extend(
            u16::try_from(length)
                .expect("under the longest")
                .to_be_bytes(),
        );
        bytes.extend_from_slice(&packet.data[..head]);
        let mut frames = vec![Frame::data_frame(
            identifier(true, frames_after(head)),
            &bytes,
        )];
        let mut taken = head;
        while taken < length {
            let next = (length - taken).min(FRAME_BYTES);
            frames.push(Frame::data_frame(
                identifier(false, frames_after(taken + next)),
                &packet.data[taken..taken + next],
            ));
            taken += next;
        }
        Ok(frames)
    }
}
