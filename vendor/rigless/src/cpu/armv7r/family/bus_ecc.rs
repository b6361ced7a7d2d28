// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The AXI master's bus ECC, DDI 0460D 9.1.1, over the memories whose 64-bit words the part stores
//! check bits for, the part's [`CheckBits`].
//!
//! A word whose stored check bits match it is plain memory, read inline. The core checks a page's
//! words the first time it reads the page after its bytes or their check bits change, and holds
//! back the pages with a word that doesn't match, so only reads of those pages leave the translated
//! code. A read of a word that doesn't match, a load's or a fetch's, goes to the bus as
//! [`CoreBus::read_checked`](crate::emulator::CoreBus::read_checked), since the part's memory
//! decides the word and check bits it hands the core, and the part decodes them as the core does:
//!
//! - A corrected word is what the instruction reads or runs, and counts the PMU's events 0x6E and
//!   0x70, Table 6-1.
//! - An uncorrectable one counts 0x6F and 0x71 and aborts, a load with a Data Abort and a fetch
//!   with a Prefetch Abort, B1.9.8 and B1.9.7. 9.1.1 has the bus ECC report its errors as events
//!   and leaves the rest to the system, and a part that aborts what the core uses gets Table 4-28's
//!   synchronous parity or ECC error, with `ADFSR` or `AIFSR` reading zero, the AXI master's side
//!   and unrecoverable, Tables 4-31 and 4-32.
//! - With `PMCR.X` set the part hears of either, since that's what exports the events, 6.4.
//!
//! A fetch from a word that doesn't match runs on its own, translated from the word the bus
//! answered for that one run, so every run of it is checked and the bus sees it each time.
//!
//! While the part asks, every read of guarded memory goes to the bus that way, matching or not,
//! for a part whose memory is about to hand the core something other than what it holds.
//!
//! Memory whose check bits the part keeps apart from the core, its RAM say, which the core writes
//! inline with no check bits to keep, has only the words the part names as disagreeing with their
//! bytes held back, [`Processor::check_words`](crate::emulator::Processor::check_words). A read of
//! one goes to the bus the same way, and so does a store, as
//! [`CoreBus::write_checked`](crate::emulator::CoreBus::write_checked), since the part decides
//! what a store to a word in error does.

use std::collections::BTreeSet;

use super::{Family, Refused};
use crate::cpu::armv7::access::read_host;
use crate::cpu::armv7::translate::Size;
use crate::cpu::armv7r::translate::{Instruction, LONGEST_BLOCK};
use crate::emulator::core::{PAGE_BITS, PAGE_SIZE};
use crate::emulator::memory::from_target;
use crate::emulator::{Access, AccessKind, CheckBits, Checked};
use crate::soc::{Endian, Width};

/// The bytes one set of check bits covers.
const WORD: u64 = 8;
/// The most bytes a block's instructions take.
const BLOCK_BYTES: u64 = LONGEST_BLOCK as u64 * 4;

/// What the core knows of the words of guarded memory: the pages it checked since their bytes
/// last changed, and among them the words whose stored check bits don't match. With `every`, the
/// bus sees every word.
#[derive(Debug, Default)]
pub(super) struct Words {
    checked: BTreeSet<u64>,
    wrong: BTreeSet<u64>,
    every: bool,
    /// The words the part named as disagreeing with check bits it keeps itself.
    listed: BTreeSet<u64>,
}

/// The 64-bit word holding `address`.
fn word(address: u64) -> u64 {
    address & !(WORD - 1)
}

/// The bytes `count` from `offset` of `value`, a word with its first byte in the top bits, in
/// `endian`.
fn bytes_of(value: u64, offset: u64, count: u64, endian: Endian) -> u32 {
    let bytes = value.to_be_bytes();
    let from = usize::try_from(offset).expect("inside a word");
    let to = from + usize::try_from(count).expect("four bytes at most");
    u32::try_from(from_target(&bytes[from..to], endian)).expect("four bytes at most")
}

impl Family {
    /// Holds back every page of guarded memory in the `length` bytes mapped at `start`, to be
    /// checked before its first read.
    pub(super) fn hold_guarded(&mut self, start: u64, length: u64) {
        let Some(ecc) = self.ties.options.axi_bus_ecc else {
            return;
        };
        for memory in ecc.memories {
            let from = start.max(memory.data);
            let to = (start + length).min(memory.data + memory.bytes);
            if from < to {
                self.forget_words(from, to);
            }
        }
    }

    /// The bytes in `start..end` changed: the words of guarded memory there, and the words whose
    /// check bits are there, are checked again before they're next read, and code translated from
    /// the latter goes.
    pub(super) fn guarded_changed(&mut self, start: u64, end: u64) {
        let Some(ecc) = self.ties.options.axi_bus_ecc else {
            return;
        };
        for memory in ecc.memories {
            let (from, to) = (start.max(memory.data), end.min(memory.data + memory.bytes));
            if from < to {
                self.forget_words(from, to);
            }
            let checks_end = memory.checks + memory.bytes / WORD;
            let (from, to) = (start.max(memory.checks), end.min(checks_end));
            if from < to {
                let data = memory.data + (from - memory.checks) * WORD;
                let data_end = memory.data + (to - memory.checks) * WORD;
                self.forget_words(data, data_end);
                self.invalidate(data, data_end);
            }
        }
    }

    /// Sends every read of guarded memory to the bus while `every`,
    /// [`Processor::check_reads`](crate::emulator::Processor::check_reads). Code translated from it
    /// goes, so a fetch reaches the bus too.
    pub(super) fn check_every_read(&mut self, every: bool) {
        let Some(ecc) = self.ties.options.axi_bus_ecc else {
            return;
        };
        self.words.every = every;
        if every {
            for memory in ecc.memories {
                let end = memory.data + memory.bytes;
                self.forget_words(memory.data, end);
                self.invalidate(memory.data, end);
            }
        }
    }

    /// Holds back the words `words` names, in place of those it named before, and lets each page
    /// that has none left and nothing else held back be inline again. Code translated from a word
    /// that's named or no longer named goes, so its next fetch is checked or plain again.
    pub(super) fn check_words(&mut self, words: &[u64]) {
        let listed: BTreeSet<u64> = words.iter().map(|&at| word(at)).collect();
        let changed: Vec<u64> = self
            .words
            .listed
            .symmetric_difference(&listed)
            .copied()
            .collect();
        self.words.listed = listed;
        for at in changed {
            self.invalidate(at, at + WORD);
            let page = at >> PAGE_BITS;
            if self.words.listed.contains(&at) {
                self.pages.hold(at, true);
            } else if !self.has_listed(page) && !self.is_guarded(page) {
                self.pages.hold(at, self.words.every);
            }
        }
    }

    /// Whether the part named the word holding `address`.
    pub(super) fn listed(&self, address: u64) -> bool {
        !self.words.listed.is_empty() && self.words.listed.contains(&word(address))
    }

    /// Whether the part named a word of `page`.
    fn has_listed(&self, page: u64) -> bool {
        let start = page << PAGE_BITS;
        self.words
            .listed
            .range(start..start + PAGE_SIZE)
            .next()
            .is_some()
    }

    /// Whether `page` holds words whose stored check bits the core checks itself, which
    /// [`Family::check_page`] holds back or lets be inline.
    fn is_guarded(&self, page: u64) -> bool {
        let start = page << PAGE_BITS;
        self.ties.options.axi_bus_ecc.is_some_and(|ecc| {
            ecc.memories
                .iter()
                .any(|memory| start < memory.data + memory.bytes && memory.data < start + PAGE_SIZE)
        })
    }

    /// Forgets what the core knew of the words in `start..end`, and holds back their pages.
    fn forget_words(&mut self, start: u64, end: u64) {
        let gone: Vec<u64> = self.words.wrong.range(word(start)..end).copied().collect();
        for each in gone {
            self.words.wrong.remove(&each);
        }
        for page in start >> PAGE_BITS..=(end - 1) >> PAGE_BITS {
            self.words.checked.remove(&page);
            self.pages.hold(page << PAGE_BITS, true);
        }
    }

    /// Whether the word holding `address` is guarded and its stored check bits don't match it,
    /// checking its page first if it hasn't been since it changed.
    pub(super) fn wrong(&mut self, address: u64) -> bool {
        if !self.pages.held(address) {
            return false;
        }
        if self.words.listed.contains(&word(address)) {
            return true;
        }
        let Some(ecc) = self.ties.options.axi_bus_ecc else {
            return false;
        };
        if self.words.every {
            return ecc
                .memories
                .iter()
                .any(|memory| (memory.data..memory.data + memory.bytes).contains(&address));
        }
        let page = address >> PAGE_BITS;
        if !self.words.checked.contains(&page) {
            self.check_page(ecc, page);
        }
        self.words.wrong.contains(&word(address))
    }

    /// Checks the pages a block from `pc` may reach that the core hasn't, so it stops only before
    /// a word whose check bits don't match.
    pub(super) fn check_ahead(&mut self, pc: u32) {
        let Some(ecc) = self.ties.options.axi_bus_ecc else {
            return;
        };
        let first = u64::from(pc) >> PAGE_BITS;
        let last = (u64::from(pc) + BLOCK_BYTES) >> PAGE_BITS;
        for page in first..=last {
            if self.pages.held(page << PAGE_BITS) && !self.words.checked.contains(&page) {
                self.check_page(ecc, page);
            }
        }
    }

    /// Checks every guarded word of `page`, and lets the page be inline when they all match.
    fn check_page(&mut self, ecc: CheckBits, page: u64) {
        let start = page << PAGE_BITS;
        let mut clean = true;
        for memory in ecc.memories {
            let from = start.max(memory.data);
            let to = (start + PAGE_SIZE).min(memory.data + memory.bytes);
            for at in (from..to).step_by(usize::try_from(WORD).expect("a word")) {
                let check_at = memory.check_address(at).expect("a word of the memory");
                let (Some(data), Some(check)) = (self.host_word(at), self.host_byte(check_at))
                else {
                    continue;
                };
                if (ecc.code)(at, data) != check {
                    self.words.wrong.insert(at);
                    clean = false;
                }
            }
        }
        self.words.checked.insert(page);
        if clean && !self.words.every && !self.has_listed(page) {
            self.pages.hold(start, false);
        }
    }

    /// The 64-bit word at `address` as memory holds it, its first byte in the top bits.
    fn host_word(&self, address: u64) -> Option<u64> {
        let halves = [address, address + 4].map(|at| {
            self.pages.host(at).map(|(host, _)| {
                // SAFETY: `host` is the page table's for `at`, which is word-aligned, so the four
                // bytes are inside the mapped page.
                u64::from(unsafe { read_host(host, Size::Word, Endian::Big) })
            })
        });
        Some(halves[0]? << 32 | halves[1]?)
    }

    /// The byte at `address` as memory holds it.
    fn host_byte(&self, address: u64) -> Option<u8> {
        let (host, _) = self.pages.host(address)?;
        // SAFETY: `host` is the page table's for `address`, and one byte is inside its page.
        let byte = unsafe { read_host(host, Size::Byte, Endian::Big) };
        Some(u8::try_from(byte).expect("a byte"))
    }

    /// Asks the bus what its check finds of the word holding `address`, for an access of `width`
    /// by the instruction at `pc` with `instructions` retired, counting the PMU's events for what
    /// it found. `None` where the part checks nothing there.
    fn check_on_bus(
        &mut self,
        address: u64,
        width: Width,
        pc: u32,
        instructions: u64,
    ) -> Option<Checked> {
        self.reached_bus();
        let report = self.system.pmu.exports();
        let checked = self.on_bus(None, |bus| {
            let access = Access {
                kind: AccessKind::Read,
                address,
                width,
                value: 0,
                instruction_count: instructions,
                virtual_time: bus.time(instructions),
                program_counter: Some(u64::from(pc)),
            };
            bus.read_checked(access, report)
        });
        self.settle();
        match checked {
            Some(Checked::Corrected(_)) => self.system.pmu.bus_corrected += 1,
            Some(Checked::Uncorrectable) => self.system.pmu.bus_fatal += 1,
            _ => {}
        }
        checked
    }

    /// A load of `size` at `address`, by the instruction at `pc` with `instructions` retired
    /// counting its own, from a word whose check bits don't match it: the bytes of the word the
    /// bus answered, or an abort for an uncorrectable one.
    pub(super) fn load_checked(
        &mut self,
        address: u32,
        size: Size,
        pc: u32,
        instructions: u64,
    ) -> Option<Result<u32, Refused>> {
        let wide = u64::from(address);
        let width = match size {
            Size::Byte => Width::W8,
            Size::Halfword => Width::W16,
            Size::Word => Width::W32,
        };
        let checked = self.check_on_bus(wide, width, pc, instructions)?;
        let (Checked::Clean(value) | Checked::Corrected(value)) = checked else {
            self.returning = super::RETURN;
            return Some(Err(Refused::Ecc(address)));
        };
        self.hand_back(instructions);
        let endian = self.data_endian();
        Some(Ok(bytes_of(
            value,
            wide - word(wide),
            u64::from(size.bytes()),
            endian,
        )))
    }

    /// A store of `size` of `value` at `address` to a word the part named, by the instruction at `pc`
    /// with `instructions` retired counting its own, which the bus makes: the value stored, a
    /// refusal the core takes as a failed bus transaction, or `None` where the part checks nothing
    /// there, so the core stores it as plain memory.
    // ceiling: the core stores 32 bits at most, so a doubleword store to a named word reaches the
    // bus as two where the AXI master makes one 64-bit write; upgrade when the core makes 64-bit
    // accesses
    pub(super) fn store_checked(
        &mut self,
        (address, size, value): (u32, Size, u32),
        pc: u32,
        instructions: u64,
    ) -> Option<Result<u32, Refused>> {
        let wide = u64::from(address);
        let width = match size {
            Size::Byte => Width::W8,
            Size::Halfword => Width::W16,
            Size::Word => Width::W32,
        };
        self.reached_bus();
        let written = self.on_bus(None, |bus| {
            let access = Access {
                kind: AccessKind::Write,
                address: wide,
                width,
                value: u64::from(value),
                instruction_count: instructions,
                virtual_time: bus.time(instructions),
                program_counter: Some(u64::from(pc)),
            };
            bus.write_checked(access)
        });
        self.settle();
        if written? {
            self.hand_back(instructions);
            Some(Ok(value))
        } else {
            self.returning = super::RETURN;
            Some(Err(Refused::Bus(address)))
        }
    }

    /// The fetch of the instruction at `pc`, `thumb` or not, where it reads a word whose check bits
    /// don't match it: `None` when it reads none, and otherwise the words the bus answered, which
    /// [`Family::fetch_corrected`] reads while the instruction is translated, or the Prefetch
    /// Abort's address for an uncorrectable one, B5.5.3.
    pub(super) fn fetch_checked(&mut self, pc: u32, thumb: bool) -> Option<Result<(), Refused>> {
        let first = u64::from(pc);
        let second = first + 2;
        if !(self.pages.held(first) || thumb && self.pages.held(second)) {
            return None;
        }
        let width = if thumb { Width::W16 } else { Width::W32 };
        let mut fetched = Vec::new();
        let leading = match self.fetch_word(first, width, pc, &mut fetched) {
            Ok(leading) => leading,
            Err(refused) => return Some(Err(refused)),
        };
        let order = self.instruction_endian();
        let wide = leading.is_some_and(|value| {
            let halfword = bytes_of(value, first - word(first), 2, order);
            Instruction::is_wide(u16::try_from(halfword).expect("a halfword"))
        });
        if thumb
            && wide
            && word(second) != word(first)
            && let Err(refused) = self.fetch_word(second, width, pc, &mut fetched)
        {
            return Some(Err(refused));
        }
        if fetched.is_empty() {
            return None;
        }
        self.hand_back(self.retired + 1);
        self.corrected = fetched;
        Some(Ok(()))
    }

    /// The word holding `at` as an instruction fetch reads it: from memory when its check bits
    /// match, and otherwise as the bus answers it, which goes in `fetched`.
    fn fetch_word(
        &mut self,
        at: u64,
        width: Width,
        pc: u32,
        fetched: &mut Vec<(u64, u64)>,
    ) -> Result<Option<u64>, Refused> {
        if !self.wrong(at) {
            return Ok(self.host_word(word(at)));
        }
        match self.check_on_bus(at, width, pc, self.retired) {
            None => Ok(self.host_word(word(at))),
            Some(Checked::Clean(value) | Checked::Corrected(value)) => {
                fetched.push((word(at), value));
                Ok(Some(value))
            }
            Some(Checked::Uncorrectable) => {
                self.returning = super::RETURN;
                Err(Refused::Ecc(u32::try_from(at).expect("a 32-bit address")))
            }
        }
    }

    /// The `size` bytes at `address` of the words [`Family::fetch_checked`] answered, in
    /// instruction order, for the one instruction being translated from them.
    pub(super) fn fetch_corrected(
        corrected: &[(u64, u64)],
        address: u32,
        size: Size,
        order: Endian,
    ) -> Option<u32> {
        let wide = u64::from(address);
        corrected
            .iter()
            .find(|&&(at, _)| at == word(wide))
            .map(|&(at, value)| bytes_of(value, wide - at, u64::from(size.bytes()), order))
    }

    /// Whether a block stops before the instruction at `address`, which reads a held page the core
    /// hasn't checked or a word whose check bits don't match.
    pub(super) fn unchecked_fetch(words: &Words, held: impl Fn(u64) -> bool, address: u32) -> bool {
        [u64::from(address), u64::from(address) + 2]
            .into_iter()
            .any(|at| {
                held(at)
                    && (!words.checked.contains(&(at >> PAGE_BITS))
                        || words.wrong.contains(&word(at))
                        || words.listed.contains(&word(at)))
            })
    }
}
