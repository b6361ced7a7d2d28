// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! A secure digital memory card: its state, its blocks and its registers, which a host reaches by
//! one of two front ends.
//!
//! The card speaks in commands and blocks, as [`crate::chip::sd`] says. [`sd_bus`] is the SD bus a
//! controller drives through the [`crate::chip::sd::Card`] seam, written from RM0090 rev 22 section
//! 31.4. [`spi`] is the serial peripheral interface, a [`crate::chip::spi::Peer`] behind a chip
//! select, written from the SD Association's "SD Physical Layer Simplified Specification 6.00",
//! chapter 7. Both read and write the same blocks and share the state below. The card starts on
//! the SD bus, enters SPI mode on `CMD0` with the select asserted, and speaks only that until
//! [`MemoryCard::power_cycle`]. Each front end's own table is in its module.
//!
//! | Register or section | Behavior | Source | Test |
//! |---|---|---|---|
//! | The card states | The states a card moves through: idle, ready, identification, standby, transfer, sending, receiving, programming | 31.4.1 to 31.4.4, 31.4.11 | `a_card_walks_the_identification_the_manual_gives`, `a_command_out_of_state_is_refused_and_says_so` |
//! | The card status register | The card status register every short answer carries, with `CURRENT_STATE` the field a driver reads | 31.4.11 | `every_answer_carries_the_state_the_card_is_in` |
//! | The blocks | The blocks themselves, as memory the machine gives it, so a run is deterministic and a test can look. A block never written reads zero, and the card is as large as its card-specific data says | 31.4.5, 31.4.6 | `a_block_written_is_the_block_read_back`, `an_unwritten_block_reads_zero_and_the_card_ends_where_its_data_says` |
//! | Capacity | A high capacity card by default, with version 2 card-specific data and a command's address in blocks. [`MemoryCard::standard_capacity`] is a standard capacity card of at most 2 GB, with version 1 card-specific data and the address in bytes | SD Physical Layer Simplified Specification 6.00, 4.3.14, 5.3.2, 5.3.3 | `a_standard_capacity_card_takes_byte_addresses`, `a_standard_capacity_card_codes_its_size_in_version_1_data` |
//! | A formatted card | A formatted card: the volume `FatFs`'s own `f_mkfs` writes, so the reader on the part finds what its writer would have left | `FatFs` R0.14b `ff.c`, `f_mkfs` | `a_formatted_card_carries_the_volume_the_firmwares_formatter_writes` |
//!
//! **What the model leaves out, and why.**
//!
//! | Behavior | Source | Reason |
//! |---|---|---|
//! | The real contents of the identification and the card-specific data, field by field | 31.4.4 | The host reads the capacity out of the card-specific data, and this model puts it there. The manufacturer, the serial number and the dates are filled with a fixed pattern, because a firmware that branches on them is one this bench doesn't have and would rather find than guess at |
//! | A wear-leveling or failure model | none | A card that returns what was written is the card a test wants. A card that fails is a condition of the board's to add, as a silent card already is |

use std::collections::BTreeMap;

use crate::chip::sd::BLOCK;
use crate::snapshot::store;
use crate::time::VirtualNanos;

mod fat32;
pub mod sd_bus;
pub mod spi;

/// The block length as the argument `CMD16` carries it, 31.4.5.
const BLOCK_LENGTH: u32 = 512;

/// The fields of 31.4.11's card status register the card sets.
mod status {
    use crate::soc::{Access, FieldSpec};

    pub(super) const CURRENT_STATE: FieldSpec =
        FieldSpec::new("CURRENT_STATE", 9, 4, Access::ReadOnly);
    pub(super) const READY_FOR_DATA: FieldSpec =
        FieldSpec::new("READY_FOR_DATA", 8, 1, Access::ReadOnly);
    pub(super) const APP_CMD: FieldSpec = FieldSpec::new("APP_CMD", 5, 1, Access::ReadOnly);
}

/// The states of 31.4.11's `CURRENT_STATE`, which every short answer carries.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum State {
    /// Out of reset, and where `CMD0` puts it, 31.4.2.
    Idle = 0,
    /// The operating range is agreed, 31.4.3.
    Ready = 1,
    /// It has answered with its identification and has no address yet, 31.4.4.
    Identification = 2,
    /// It has an address and isn't selected, 31.4.4.
    Standby = 3,
    /// Selected, and where every transfer begins, 31.4.9.
    Transfer = 4,
    /// Sending a read's blocks, 31.4.6.
    SendingData = 5,
    /// Taking a write's blocks, 31.4.5.
    ReceivingData = 6,
    /// Programming what it took, 31.4.5.
    Programming = 7,
}

/// What a transfer in flight is doing, and where.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Streaming {
    block: usize,
    multiple: bool,
}

/// A secure digital memory card of a size the board gives it.
///
/// Its blocks are memory, so a run is deterministic and a test can look at what landed. Only the
/// blocks ever written are held, so a card the size of the one a board carries costs what the
/// firmware wrote to it. A host reaches it through [`sd_bus`] or [`spi`], and the second table of
/// each module, this one's included, is everything it doesn't do.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a separate fact the specification names, set by its own command or the card's make"
)]
pub struct MemoryCard {
    capacity: usize,
    standard_capacity: bool,
    #[serde(with = "blocks")]
    blocks: BTreeMap<usize, Box<[u8; BLOCK]>>,
    state: State,
    address: u16,
    block_length: u32,
    wide: bool,
    escaped: bool,
    streaming: Option<Streaming>,
    programming_until: Option<VirtualNanos>,
    commanded: Vec<(u8, u32)>,
    answer_corrupt: bool,
    spi: spi::Port,
}

/// The blocks written, for a snapshot, each as its bytes: serde stops at arrays of 32.
mod blocks {
    use std::collections::BTreeMap;

    use serde::{Deserialize, Deserializer, Serializer};

    use super::BLOCK;

    pub(super) fn serialize<S: Serializer>(
        blocks: &BTreeMap<usize, Box<[u8; BLOCK]>>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_map(blocks.iter().map(|(index, block)| (index, &block[..])))
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<BTreeMap<usize, Box<[u8; BLOCK]>>, D::Error> {
        BTreeMap::<usize, Vec<u8>>::deserialize(deserializer)?
            .into_iter()
            .map(|(index, block)| {
                let read = block.len();
                block
                    .into_boxed_slice()
                    .try_into()
                    .map(|block| (index, block))
                    .map_err(|_short| serde::de::Error::invalid_length(read, &"a block"))
            })
            .collect()
    }
}

/// What `ACMD41` answers: the operating range, with the power-up done, 31.4.3.
///
/// Bit 31 is the card saying it has finished its power-up sequence, which is what a host polls this
/// command for. The range bits below it are the windows 31.4.3 has the host check against its own
/// supply.
const OPERATING_RANGE: u32 = 0x8010_0000;

/// What `CMD2` answers, the card identification of 31.4.4, which the SPI side also sends as a block.
const CARD_IDENTIFICATION: [u32; 4] = [0x0353_4453, 0x4330_3847, 0x3080_1234, 0x0115_8000];

/// The programming a block write takes before the card will take another, 31.4.5.
///
/// The page gives no number, because programming time is the card's own and varies by part. So this
/// is the model's, chosen small enough that a firmware polling for it can't be said to be waiting
/// on the rig, and large enough that a firmware which doesn't poll at all is caught. It's one
/// microsecond, and it's said here and nowhere else.
pub const PROGRAMMING: VirtualNanos = VirtualNanos(1_000);

impl MemoryCard {
    /// A card of `blocks` blocks, every byte zero.
    ///
    /// # Panics
    ///
    /// Panics when `blocks` is zero, which isn't a card.
    #[must_use]
    pub fn empty(blocks: usize) -> Self {
        assert!(blocks > 0, "a card has at least one block");
        Self {
            capacity: blocks,
            standard_capacity: false,
            blocks: BTreeMap::new(),
            state: State::Idle,
            address: 0,
            block_length: BLOCK_LENGTH,
            wide: false,
            escaped: false,
            streaming: None,
            programming_until: None,
            commanded: Vec::new(),
            answer_corrupt: false,
            spi: spi::Port::default(),
        }
    }

    /// A standard capacity card of `blocks` blocks, every byte zero: a card of 2 GB or less, which
    /// a host addresses in bytes rather than blocks (4.3.14) and which describes its size in version 1
    /// card-specific data (5.3.2).
    ///
    /// # Panics
    ///
    /// Panics when version 1 data can't code `blocks` exactly: `C_SIZE` plus one up to 4096 units of
    /// `2^(C_SIZE_MULT + 2)` blocks of `2^READ_BL_LEN` bytes, with `READ_BL_LEN` 9, or 10 for a 2 GB
    /// card.
    #[must_use]
    pub fn standard_capacity(blocks: usize) -> Self {
        assert!(
            csd_v1::size(blocks).is_some(),
            "version 1 card-specific data codes {blocks} blocks"
        );
        Self {
            standard_capacity: true,
            ..Self::empty(blocks)
        }
    }

    /// A card whose blocks start as `contents`, rounded up to a whole block.
    ///
    /// This is what a board with an image on its card is built with, and what a test that wants to
    /// read something it didn't write uses.
    ///
    /// # Panics
    ///
    /// Panics when `contents` is empty, which isn't a card.
    #[must_use]
    pub fn holding(contents: &[u8]) -> Self {
        assert!(!contents.is_empty(), "a card has at least one block");
        let blocks = contents.len().div_ceil(BLOCK);
        let mut card = Self::empty(blocks);
        for (index, chunk) in contents.chunks(BLOCK).enumerate() {
            card.block_mut(index)[..chunk.len()].copy_from_slice(chunk);
        }
        card
    }

    /// A card of `blocks` blocks carrying an empty FAT32 volume, which is what a board's card holds when
    /// a firmware can mount but not format.
    ///
    /// # Panics
    ///
    /// Panics when `blocks` is fewer than FAT32 can hold, which isn't a card a board carries.
    #[must_use]
    pub fn formatted(blocks: usize) -> Self {
        let mut card = Self::empty(blocks);
        for (index, sector) in fat32::volume(blocks) {
            *card.block_mut(index) = sector;
        }
        card
    }

    /// What the card holds at `block`, as a read would find it.
    #[must_use]
    pub fn stored(&self, block: usize) -> [u8; BLOCK] {
        self.blocks.get(&block).map_or([0; BLOCK], |held| **held)
    }

    fn block_mut(&mut self, index: usize) -> &mut [u8; BLOCK] {
        self.blocks
            .entry(index)
            .or_insert_with(|| Box::new([0; BLOCK]))
    }

    /// Makes every block this card gives fail its check, which is what a controller reads as `DCRCFAIL`.
    ///
    /// A card can't be asked to corrupt itself. This is the bench asking, so the error a controller
    /// must raise has a condition to be raised by. Nothing in 31.4 describes it, and nothing
    /// should. It's a fault a real card has and a model has to be told to have.
    pub fn corrupt_every_block(&mut self, corrupt: bool) {
        self.answer_corrupt = corrupt;
    }

    /// Where the card is in 31.4.11's `CURRENT_STATE`.
    #[must_use]
    pub fn state(&self) -> State {
        self.state
    }

    /// The bus width `ACMD6` last set, 31.4.9.
    #[must_use]
    pub fn wide(&self) -> bool {
        self.wide
    }

    /// The card status register every short answer carries, 31.4.11.
    ///
    /// Bits 12:9 are `CURRENT_STATE` and bit 8 is `READY_FOR_DATA`. Bit 5 is `APP_CMD`, which the
    /// page has the card set while it expects an application command.
    fn status(&self) -> u32 {
        let status = status::CURRENT_STATE.set(0, self.state as u64);
        let status = status::READY_FOR_DATA.set(status, 1);
        let status = status::APP_CMD.set(status, u64::from(self.escaped));
        u32::try_from(status).expect("the fields are inside 32 bits")
    }

    /// The card-specific data of 31.4.4, whose size fields are what a host reads its capacity from.
    ///
    /// The second version of the structure, which gives the size as a count of half-megabytes less one in
    /// bits 69:48, so a host multiplies rather than shifts. Everything else is the fixed pattern the
    /// header's second table records.
    fn card_specific(&self) -> [u32; 4] {
        if self.standard_capacity {
            return csd_v1::words(self.capacity);
        }
        let half_megabytes =
            u32::try_from(self.capacity / (512 * 1024 / BLOCK)).unwrap_or(u32::MAX);
        let size = half_megabytes.saturating_sub(1);
        [
            0x400E_0032,
            0x5B59_0000 | (size >> 16),
            (size & 0xFFFF) << 16,
            0x0A40_0001,
        ]
    }

    /// Where a command's argument points, as a block index into the card.
    ///
    /// A high capacity card takes the block and a standard capacity card the byte the block starts
    /// at, 4.3.14. A byte that isn't the start of a block points nowhere.
    fn offset(&self, argument: u32) -> Option<usize> {
        let argument = argument as usize;
        let block = if self.standard_capacity {
            argument.is_multiple_of(BLOCK).then_some(argument / BLOCK)?
        } else {
            argument
        };
        (block < self.capacity).then_some(block)
    }
}

store!(MemoryCard);

/// The card-specific data of a standard capacity card, version 1, 5.3.2 Table 5-4.
///
/// The register's 128 bits are kept as two halves, bits 127:64 and 63:0, and each field below is
/// placed in its half. `C_SIZE` straddles the two, so it's split. The fields a host doesn't size the
/// card by carry the same fixed pattern the version 2 data does.
mod csd_v1 {
    use crate::chip::sd::BLOCK;
    use crate::soc::{Access, FieldSpec};

    const TAAC: FieldSpec = FieldSpec::new("TAAC", 48, 8, Access::ReadOnly);
    const TRAN_SPEED: FieldSpec = FieldSpec::new("TRAN_SPEED", 32, 8, Access::ReadOnly);
    const CCC: FieldSpec = FieldSpec::new("CCC", 20, 12, Access::ReadOnly);
    const READ_BL_LEN: FieldSpec = FieldSpec::new("READ_BL_LEN", 16, 4, Access::ReadOnly);
    const READ_BL_PARTIAL: FieldSpec = FieldSpec::new("READ_BL_PARTIAL", 15, 1, Access::ReadOnly);
    /// `C_SIZE` bits 11:2, at the bottom of the upper half.
    const C_SIZE_UPPER: FieldSpec = FieldSpec::new("C_SIZE", 0, 10, Access::ReadOnly);
    /// `C_SIZE` bits 1:0, at the top of the lower half.
    const C_SIZE_LOWER: FieldSpec = FieldSpec::new("C_SIZE", 62, 2, Access::ReadOnly);
    const C_SIZE_MULT: FieldSpec = FieldSpec::new("C_SIZE_MULT", 47, 3, Access::ReadOnly);
    const R2W_FACTOR: FieldSpec = FieldSpec::new("R2W_FACTOR", 26, 3, Access::ReadOnly);
    const WRITE_BL_LEN: FieldSpec = FieldSpec::new("WRITE_BL_LEN", 22, 4, Access::ReadOnly);
    const END: FieldSpec = FieldSpec::new("END", 0, 1, Access::ReadOnly);

    /// Where `C_SIZE`'s own bits split between the halves.
    const C_SIZE_HIGH_BITS: FieldSpec = FieldSpec::new("C_SIZE", 2, 10, Access::ReadOnly);
    const C_SIZE_LOW_BITS: FieldSpec = FieldSpec::new("C_SIZE", 0, 2, Access::ReadOnly);

    /// `READ_BL_LEN`, `C_SIZE_MULT` and `C_SIZE` coding `blocks` exactly, if any do: the block length
    /// is 512 bytes, or 1024 for a 2 GB card, and `C_SIZE` is at most 4095.
    pub(super) fn size(blocks: usize) -> Option<(u64, u64, u64)> {
        (9..=10).find_map(|read_bl_len: u32| {
            (0..8).find_map(|c_size_mult: u32| {
                let unit = (2_usize.pow(c_size_mult + 2) * 2_usize.pow(read_bl_len)) / BLOCK;
                let units = blocks / unit;
                (blocks.is_multiple_of(unit) && (1..=4096).contains(&units)).then(|| {
                    let c_size = u64::try_from(units - 1).expect("at most 4095");
                    (u64::from(read_bl_len), u64::from(c_size_mult), c_size)
                })
            })
        })
    }

    /// The register as four words, most significant first, as `CMD9` answers it.
    pub(super) fn words(blocks: usize) -> [u32; 4] {
        let (read_bl_len, c_size_mult, c_size) = size(blocks).expect("the constructor checked");
        let upper = [
            TAAC.set(0, 0x0E),
            TRAN_SPEED.set(0, 0x32),
            CCC.set(0, 0x5B5),
            READ_BL_LEN.set(0, read_bl_len),
            READ_BL_PARTIAL.set(0, 1),
            C_SIZE_UPPER.set(0, C_SIZE_HIGH_BITS.get(c_size)),
        ]
        .into_iter()
        .fold(0, |register, field| register | field);
        let lower = [
            C_SIZE_LOWER.set(0, C_SIZE_LOW_BITS.get(c_size)),
            C_SIZE_MULT.set(0, c_size_mult),
            R2W_FACTOR.set(0, 0b010),
            WRITE_BL_LEN.set(0, read_bl_len),
            END.set(0, 1),
        ]
        .into_iter()
        .fold(0, |register, field| register | field);
        let bytes = [upper.to_be_bytes(), lower.to_be_bytes()].concat();
        let (words, _) = bytes.as_chunks::<4>();
        std::array::from_fn(|word| u32::from_be_bytes(words[word]))
    }
}
