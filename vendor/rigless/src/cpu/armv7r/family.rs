// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The ARMv7-R core: the processor, running the firmware's ARM and Thumb instructions as host
//! code.
//!
//! [`Family`] is one processor. The runner maps the target's memory into it, boots it, and runs it
//! a stretch of instructions at a time with [`Processor::run`]. A stretch runs translated blocks,
//! [`super::translate`], until its budget is spent or an access went to the bus, which hands
//! control back to the runner after that instruction.
//!
//! Generated code holds a pointer to the `Family` it runs on, and reaches its [`State`] and the
//! fields [`offsets`] names at fixed offsets. Every other access it makes calls one of [`helpers`],
//! which take the same pointer as `&mut Family`.
#![expect(
    unsafe_code,
    reason = "generated code runs on the core through a raw pointer, and reaches the host's memory"
)]

use std::collections::BTreeMap;
use std::num::NonZeroU8;
use std::ptr::NonNull;

use super::cp15::{System, sctlr_ones};
use super::exception::{Faults, IRQ};
use super::mpu::{Kind, SMALLEST_REGION_BITS};
use super::registers::{cpsr, sctlr};
use super::state::{ExceptionMode, Mode, State};
use super::translate::{self, LONGEST_BLOCK, Start, block_key};
use crate::cpu::armv7::access::{Request, read_host, write_host};
use crate::cpu::armv7::registers::{get, is_set, mask, set};
use crate::cpu::armv7::translate::float::Fpu;
use crate::cpu::armv7::translate::{Attributes, Cells, Fault, InstructionSet, Size, bits, status};
use crate::device::Level;
use crate::emulator::core::{Block, Blocks, Jit, PAGE_BITS, PAGE_SIZE, Pages, Place, Tier};
use crate::emulator::memory::{from_target, to_target};
use crate::emulator::{
    Access, AccessKind, CheckBits, CoreBus, DataModel, Error, Exit, InterruptLine, Processor,
    Queued,
};
use crate::soc::{Endian, Width};

mod bus_ecc;
mod cycle;

/// Where generated code finds what it reads of a [`Family`], in bytes from its start.
pub(crate) mod offsets {
    use super::Family;

    pub(crate) const STATE: usize = std::mem::offset_of!(Family, state);
    pub(crate) const TABLE: i32 = offset(std::mem::offset_of!(Family, table));
    pub(crate) const BUDGET: i32 = offset(std::mem::offset_of!(Family, budget));
    pub(crate) const RETURNING: i32 = offset(std::mem::offset_of!(Family, returning));
    pub(crate) const LINK: i32 = offset(std::mem::offset_of!(Family, link));
    pub(crate) const SCTLR: i32 = offset(std::mem::offset_of!(Family, sctlr));
    pub(crate) const RESTORING: i32 = offset(std::mem::offset_of!(Family, restoring));

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        reason = "asserted below 1 << 16, and a const fn has no try_from"
    )]
    const fn offset(bytes: usize) -> i32 {
        assert!(bytes < 1 << 16, "near the start");
        bytes as i32
    }
}

/// How C lays out the family's data: a 32-bit `int`, `long` and pointer.
const DATA_MODEL: DataModel = DataModel::Ilp32;

/// The bytes of the 32-bit address space.
const ADDRESS_SPACE: u64 = 1 << 32;

/// `returning` for an access that needs the runner before the next instruction.
const RETURN: u32 = 1;
/// `returning` for an access after which the processor carries on, back in its own loop.
const CARRY_ON: u32 = 2;
/// `returning` for a write that cleared a mask, after which the run loop looks for an exception
/// to take before the next block, and goes on with the budget it has.
const CHECK: u32 = 3;

/// How many blocks the code generator makes before it starts over.
const MOST_BLOCKS: u64 = 1 << 16;

/// The bit a block's key gains while a breakpoint is at its start, which no key an exit finds a
/// block by has: [`block_key`]'s fields end at bit 51.
const AT_BREAKPOINT: u64 = 1 << 52;

/// The core's interrupt inputs, nIRQ and nFIQ, DDI 0460D 3.8.3, by the line each is.
const INTERRUPT_INPUTS: usize = 2;

/// The `bytemask` of B1.3.3's `CPSRWriteByInstr()` that writes every byte of the CPSR.
pub(crate) const EVERY_BYTE: u32 = 0b1111;

/// The most synchronous exceptions the core takes with no instruction retired between them before
/// it stops. A handler whose first instruction faults back into itself would take its exception
/// forever, and no time would pass. An exception taken in the first instruction of each handler
/// it leads to, through every vector, comes nowhere near.
const MOST_ENTRIES_UNRETIRED: u32 = 8;

/// The line nIRQ is on, [`IRQ`], as the VIC port's handshake names it.
#[expect(
    clippy::cast_possible_truncation,
    reason = "line 0, and a const has no try_from"
)]
const IRQ_LINE: InterruptLine = match InterruptLine::new(IRQ as u16) {
    Some(line) => line,
    None => panic!("line 0 is a line"),
};

/// A block translated, and the first and last byte it came from.
type Translated = (Block, (u32, u32));

/// An exception an instruction raised, B1.8.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Raised {
    /// One of the instruction's own.
    Fault(Fault),
    /// A Data Abort for an access the core refused, a store when `write`, B1.9.8.
    DataAbort { refused: Refused, write: bool },
    /// A Prefetch Abort for a fetch the MPU refused, B1.9.7.
    FetchRefused(Refused),
}

/// What the part ties the core's configuration inputs to, which `SCTLR` takes at every reset,
/// DDI 0460D 4.3.16.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ties {
    /// The byte order of instructions and of data at reset, `CFGIE` and `CFGEE`, DDI 0460D 3.11.
    pub(crate) endian: Endian,
    /// `CFGNMFI`, which makes FIQs non-maskable, 3.8.3.
    pub(crate) nmfi: bool,
    /// `TEINIT`, which takes exceptions in Thumb state.
    pub(crate) thumb_exceptions: bool,
    /// `VINITHI`, which puts the vectors high.
    pub(crate) high_vectors: bool,
    /// The build options the part chose.
    pub(crate) options: Options,
}

/// The build options a part chose for its Cortex-R5, which the identification registers report.
/// The part's own module gives them.
#[derive(Clone, Copy, Debug)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a build option of its own, Table 4-59"
)]
pub(crate) struct Options {
    /// The instruction cache's size and the data cache's, in KB, 4 to 64, Table 4-21.
    pub(crate) instruction_cache_kb: u32,
    pub(crate) data_cache_kb: u32,
    /// The MPU's regions, Table 4-6.
    pub(crate) mpu_regions: MpuRegions,
    /// Whether the ATCM, BTCM0 and BTCM1 ports are built, Table 4-59.
    pub(crate) tcms: bool,
    /// Whether a redundant core runs in lock-step, Table 4-59.
    pub(crate) lock_step: bool,
    /// The breakpoints and the watchpoints, 1 to 8 each, Table 4-59.
    pub(crate) breakpoints: NonZeroU8,
    pub(crate) watchpoints: NonZeroU8,
    /// `ICACHE_ES` and `DCACHE_ES`, the caches' error schemes, Table 4-59.
    pub(crate) cache_error_schemes: [u32; 2],
    /// Whether the hard error cache and the ACP are built, Table 4-59.
    pub(crate) hard_error_cache: bool,
    pub(crate) acp: bool,
    /// AXI bus ECC, built when the part gives what its memory stores check bits for, Table 4-59
    /// and 9.1.1.
    pub(crate) axi_bus_ecc: Option<CheckBits>,
    /// The AXI peripheral port's region at reset, Table 4-61.
    pub(crate) axi_peripheral: PortRegion,
    /// The floating-point unit, the R5F's or none, DDI 0460D 11.1.
    pub(crate) fpu: Fpu,
}

/// The regions an R5's MPU may be built with, DDI 0460D 7.1.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MpuRegions {
    #[cfg_attr(
        all(feature = "tms570lc4357", not(any(test, fuzzing))),
        expect(dead_code, reason = "no part on a machine builds twelve")
    )]
    Twelve,
    Sixteen,
}

impl MpuRegions {
    /// How many.
    pub(crate) const fn count(self) -> u32 {
        match self {
            Self::Twelve => 12,
            Self::Sixteen => 16,
        }
    }
}

/// A peripheral port's region, as its region register holds it, Table 4-61.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PortRegion {
    pub(crate) base: u32,
    /// The region register's `Size` encoding.
    pub(crate) size: u32,
}

/// Why the core refused an access, with the address the instruction asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Refused {
    /// It wasn't aligned and had to be, A3.2.1.
    Unaligned(u32),
    /// The bus failed it.
    Bus(u32),
    /// The MPU found no region for it, B5.4.2.
    Background(u32),
    /// The region the MPU found for it doesn't allow it, B5.4.2.
    Permission(u32),
    /// The bus's check found more bits of the word in error than it corrects, DDI 0460D 9.1.1.
    Ecc(u32),
}

/// A CP15 register as `MRC` and `MCR` name it, by `opc1`, `CRn`, `CRm` and `opc2`, B5.8.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SystemRegister {
    pub(crate) opc1: u32,
    pub(crate) crn: u32,
    pub(crate) crm: u32,
    pub(crate) opc2: u32,
}

impl SystemRegister {
    /// The register an `MRC` or `MCR` names, A8.8.107 and A8.8.98, from its ARM word or its two
    /// Thumb halfwords as one word, which have the fields at the same bits.
    pub(crate) fn of(instruction: u32) -> Self {
        Self {
            opc1: bits(instruction, 23, 21),
            crn: bits(instruction, 19, 16),
            crm: bits(instruction, 3, 0),
            opc2: bits(instruction, 7, 5),
        }
    }
}

/// The instruction an access is made for: its address, and the instructions of its block before
/// it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Position {
    pub(crate) pc: u32,
    pub(crate) index: u32,
}

/// One ARMv7-R processor and everything it runs with.
#[repr(C)]
pub(crate) struct Family {
    /// What instructions read and write, at [`offsets::STATE`].
    pub(crate) state: State,
    /// The page table generated code reads memory through, `pages`'s own.
    table: *const usize,
    /// The instructions the stretch has left.
    budget: u32,
    /// Nonzero once an access went to the bus or the run asked the core to return: [`RETURN`] to
    /// go back to the runner, [`CARRY_ON`] to go on with the budget in `carried`.
    returning: u32,
    /// The address of the link cell of the exit a block left by unlinked, or 0.
    link: usize,
    /// The budget when the run loop last entered a block, which `budget` falls from as chained
    /// blocks retire.
    entered: u32,
    /// `SCTLR`, DDI 0460D 4.3.16, which generated code reads for `DZ`.
    pub(crate) sctlr: u32,
    /// The PSR an exception return restores, which generated code leaves here for the run loop
    /// to write to the CPSR once the block that returned has left, B1.8.10.
    restoring: u32,
    /// What the part ties the core's configuration inputs to.
    ties: Ties,
    /// Whether each interrupt input is asserted, by line: nIRQ, then nFIQ.
    pub(crate) interrupts: [bool; INTERRUPT_INPUTS],
    /// The exception the last instruction raised, which the run loop takes before anything else.
    pub(crate) raised: Option<Raised>,
    pub(crate) faults: Faults,
    /// CP15's other registers and the PMU, DDI 0460D chapters 4 and 6.
    pub(crate) system: System,
    /// The instructions retired at the last synchronous exception the core took, and how many it
    /// has taken since with none retired.
    entries: (u64, u32),
    pages: Pages,
    /// The MPU's configuration, which [`Family::mpu_changed`] moves on.
    configuration: u64,
    /// What each block key's fetches are allowed, for the configuration it was worked out for:
    /// the longest the block may be, or why its first instruction can't be fetched.
    fetches: (u64, BTreeMap<u64, Result<u32, Refused>>),
    /// The privilege the page table holds what's inline for while the MPU is on.
    inline_privileged: bool,
    /// A region register changed since the run loop last looked, which [`Family::mpu_changed`]
    /// applies once before the next block, since the `MCR` ended its own.
    pub(crate) regions_changed: bool,
    jit: Jit,
    blocks: Blocks,
    /// Every instruction retired in the run, which a reset doesn't change and a snapshot keeps.
    retired: u64,
    /// Where [`Processor::run`] keeps the bus of the stretch running, only while it does. The
    /// borrow it points to lives shorter than `'static`, which only the pointer's target type
    /// forgets.
    bus: Option<NonNull<&'static mut dyn CoreBus>>,
    /// The link cell of the last block's exit, which leads to the block run next if nothing came
    /// between.
    unlinked: Option<u32>,
    /// The budget an access left the processor to carry on with.
    carried: u32,
    /// A panic beneath a call on the bus, kept until the stretch is back in Rust, since it can't
    /// unwind through the code the core generated.
    panicked: Option<Box<dyn std::any::Any + Send>>,
    /// Every address a debugger's breakpoint is on, with how many asked for it.
    breakpoints: BTreeMap<u64, u32>,
    /// The breakpoint the next block runs past once, after its arrival was reported.
    passing: Option<u64>,
    /// Whether a debugger's step holds asynchronous exceptions and waits off.
    held: bool,
    cycles: cycle::Cycles,
    /// What the core knows of the words its bus checks.
    words: bus_ecc::Words,
    /// The words, by address, the bus answered for the one instruction being translated from them.
    corrected: Vec<(u64, u64)>,
}

impl std::fmt::Debug for Family {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Family")
            .field("state", &self.state)
            .field("sctlr", &self.sctlr)
            .field("retired", &self.retired)
            .field("blocks", &self.blocks.len())
            .finish_non_exhaustive()
    }
}

// SAFETY: `table` points into the `Pages` this owns, and `bus` is set only for the length of a
// `run` on the thread running it. Nothing else here is tied to a thread.
unsafe impl Send for Family {}

impl Family {
    /// A processor on a part that ties its inputs as `ties` says, reset, with nothing mapped.
    pub(crate) fn new(ties: Ties) -> Result<Box<Self>, Error> {
        let pages = Pages::new(DATA_MODEL)?;
        let mut family = Box::new(Self {
            state: State::default(),
            table: pages.table(),
            budget: 0,
            returning: 0,
            link: 0,
            entered: 0,
            sctlr: 0,
            restoring: 0,
            ties,
            interrupts: [false; INTERRUPT_INPUTS],
            raised: None,
            faults: Faults::default(),
            system: System::default(),
            entries: (0, 0),
            pages,
            configuration: 0,
            fetches: (0, BTreeMap::new()),
            inline_privileged: true,
            regions_changed: false,
            jit: Jit::new()?,
            blocks: Blocks::default(),
            retired: 0,
            bus: None,
            unlinked: None,
            carried: 0,
            panicked: None,
            breakpoints: BTreeMap::new(),
            passing: None,
            held: false,
            cycles: cycle::Cycles::default(),
            words: bus_ecc::Words::default(),
            corrected: Vec::new(),
        });
        family.table = family.pages.table();
        family.reset();
        Ok(family)
    }

    /// `SCTLR`'s fields the core reads as a reset leaves them, by what the part ties, DDI 0460D
    /// 3.11 and 4.3.16, and the rest clear.
    fn reset_sctlr(ties: Ties) -> u32 {
        let big = u32::from(ties.endian == Endian::Big);
        [
            (sctlr::IE, big),
            (sctlr::EE, big),
            (sctlr::NMFI, u32::from(ties.nmfi)),
            (sctlr::TE, u32::from(ties.thumb_exceptions)),
            (sctlr::V, u32::from(ties.high_vectors)),
        ]
        .into_iter()
        .fold(sctlr_ones(), |value, (field, tied)| set(field, value, tied))
    }

    /// Everything the core holds that [`Processor::save`] keeps.
    fn saved(&self) -> Saved {
        Saved {
            state: self.state.clone(),
            sctlr: self.sctlr,
            faults: self.faults.clone(),
            system: self.system.clone(),
            interrupts: self.interrupts,
            entries: self.entries,
            retired: self.retired,
        }
    }

    /// The order of a data access's bytes, by `CPSR.E`, A2.5.3.
    fn data_endian(&self) -> Endian {
        if self.state.e == 0 {
            Endian::Little
        } else {
            Endian::Big
        }
    }

    /// The order of an instruction's bytes, by `SCTLR.IE`, A3.3.1.
    fn instruction_endian(&self) -> Endian {
        if is_set(sctlr::IE, self.sctlr) {
            Endian::Big
        } else {
            Endian::Little
        }
    }

    /// Calls `call` on the bus of the stretch running, or answers `otherwise` once anything under
    /// a call has panicked. A panic is kept, the stretch ends after this instruction, and `run`
    /// hands it on, so it reaches whoever runs the processor as it would have with no generated
    /// code in between.
    fn on_bus<T>(&mut self, otherwise: T, call: impl FnOnce(&mut dyn CoreBus) -> T) -> T {
        if self.panicked.is_some() {
            return otherwise;
        }
        match std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| call(self.bus()))) {
            Ok(answer) => answer,
            Err(panic) => {
                self.panicked = Some(panic);
                self.returning = RETURN;
                otherwise
            }
        }
    }

    /// The bus of the stretch running.
    fn bus(&mut self) -> &mut dyn CoreBus {
        let mut bus = self.bus.expect("a bus while running");
        // SAFETY: `run` points it at its own borrow of the bus, which outlives the stretch, and
        // clears it before it returns or unwinds. Only this processor's own calls inside the
        // stretch reach it, one at a time.
        unsafe { *bus.as_mut() }
    }

    fn run_blocks(&mut self) -> Exit {
        loop {
            // The exception goes before anything else, whatever ended the block.
            if let Some(raised) = self.raised.take() {
                self.take_raised(raised);
                self.unlinked = None;
                if !self.entered_since_retiring() {
                    return Exit::Lockup;
                }
            }
            if self.returned() {
                return Exit::Returned;
            }
            self.wake();
            if self.state.sleeping != 0 {
                return Exit::Waiting;
            }
            // Another may preempt the one taken, or its handshake may have asked for the runner.
            if !self.held && self.take_asynchronous() {
                self.unlinked = None;
                self.interrupted();
                continue;
            }
            if self.budget == 0 {
                return Exit::Budget;
            }
            if std::mem::take(&mut self.regions_changed) {
                self.mpu_changed();
            }
            self.forget_inline_on_privilege();
            if self.breakpoints.is_empty() && !self.held {
                self.fast_forward();
            }
            let pc = self.state.r[15];
            let passing = self.passing.take();
            if self.breakpoints.contains_key(&u64::from(pc)) && passing != Some(u64::from(pc)) {
                return Exit::Breakpoint;
            }
            let start = self.start_at(pc);
            let start = match self.fetchable(start) {
                Ok(start) => start,
                Err(refused) => {
                    self.raised = Some(Raised::FetchRefused(refused));
                    continue;
                }
            };
            let block = match self.block(start) {
                Ok(Some(block)) => block,
                Ok(None) => continue,
                Err(error) => panic!("{error}"),
            };
            let budget = self.budget;
            self.entered = budget;
            self.link = 0;
            let entry = self.jit.entry();
            // SAFETY: a block this processor translated, and the code generator's entry, both
            // since its last `jit.clear()`, called with the processor the block was translated
            // for, which nothing else touches until it returns.
            let answer = unsafe { entry.run(std::ptr::from_mut(self).cast(), block) };
            self.retired += u64::from(budget - self.budget);
            self.entered = self.budget;
            if answer == status::NEXT && self.link != 0 {
                self.unlinked = self.blocks.cell_number(self.link);
            }
            match answer {
                // The budget carried on with counted the faulting instruction as retired, which it
                // isn't, so the runner works it out again.
                status::EXCEPTION if self.returning == CARRY_ON => self.returning = RETURN,
                status::EXCEPTION_RETURN => self.finish_exception_return(),
                // A branch to itself waits for an interrupt as `WFI` does, the runtime's rule of
                // time: the clock warps rather than counting the spin.
                // A step holds interrupts off, so nothing could wake it, and a wait is a hint a
                // core may take as no wait at all, B1.8.14.
                status::WAIT_FOR_INTERRUPT | status::SPIN | status::WAIT_FOR_EVENT if self.held => {
                }
                status::WAIT_FOR_INTERRUPT | status::SPIN => self.sleep(false),
                status::WAIT_FOR_EVENT => self.sleep(true),
                _ => {}
            }
            // A block that's hot ran nothing, and a lone instruction that's hot gets a block of
            // its own, and a block that's hot better code.
            if answer == status::HOT {
                let Ok(full) = self.fetchable(self.start(self.state.r[15])) else {
                    continue;
                };
                // A block run to pass its breakpoint that's hot ran nothing, so it's passed again
                // once it's better code.
                if passing == Some(u64::from(full.pc)) {
                    self.passing = passing;
                }
                let made = if self.blocks.get(self.key_of(full)).is_some() {
                    self.promote(full)
                } else {
                    self.block(full).map(drop)
                };
                if let Err(error) = made {
                    panic!("{error}");
                }
            }
        }
    }

    /// Whether the exception just taken leaves the core still running: false once it has taken
    /// more than [`MOST_ENTRIES_UNRETIRED`] in a row with no instruction retired.
    fn entered_since_retiring(&mut self) -> bool {
        let (retired, count) = self.entries;
        let count = if retired == self.retired {
            count + 1
        } else {
            1
        };
        self.entries = (self.retired, count);
        count <= MOST_ENTRIES_UNRETIRED
    }

    /// The handshake of DDI 0460D 3.8.3's VIC port for the IRQ the core is taking: the address
    /// the part's interrupt controller supplies, then whatever the run asked in answer.
    pub(crate) fn acknowledge_irq(&mut self) -> Option<u32> {
        let instructions = self.retired;
        self.reached_bus();
        let handler = self.on_bus(None, |bus| bus.acknowledge(IRQ_LINE, instructions));
        self.settle();
        // The port carries 32 bits of address.
        handler.map(|handler| u32::try_from(handler & u64::from(u32::MAX)).expect("masked"))
    }

    /// The first address at `pc` an instruction fetch can't read, for `IFAR`: `pc`, or in Thumb
    /// state the second halfword of an instruction whose first one was read.
    pub(crate) fn unfetchable(&self, pc: u32, thumb: bool) -> u32 {
        if thumb && self.pages.host(u64::from(pc)).is_some() {
            pc.wrapping_add(2)
        } else {
            pc
        }
    }

    /// Whether an access since the last asked for the runner, after taking up the budget it
    /// carried on with when it asked only for this loop.
    fn returned(&mut self) -> bool {
        match std::mem::take(&mut self.returning) {
            0 | CHECK => false,
            CARRY_ON => {
                self.budget = self.carried;
                self.entered = self.carried;
                false
            }
            _ => true,
        }
    }

    /// Finishes the exception return a block left by, B1.8.10: the PSR it restores becomes the
    /// CPSR, as B1.3.3's `CPSRWriteByInstr()` writes one for an exception return, and the next
    /// instruction is where the block left the PC, with bit 0 ignored in Thumb state and bits 1
    /// and 0 in ARM state.
    fn finish_exception_return(&mut self) {
        self.cpsr_write_by_instr(self.restoring, EVERY_BYTE, true);
        self.system.pmu.returned += 1;
        let ignored = if self.state.t == 0 { 3 } else { 1 };
        self.state.r[15] &= !ignored;
        // B1.8.13: an exception return sets the event register.
        self.state.event = 1;
    }

    /// The block at `pc` as the processor's state has it now, as long as a block may be. In ARM
    /// state `ITSTATE` is zero, A2.5.2.
    fn start(&self, pc: u32) -> Start {
        let thumb = self.state.t != 0;
        Start {
            pc,
            it: if thumb { self.state.it } else { 0 },
            longest: LONGEST_BLOCK,
            instruction_set: if thumb {
                InstructionSet::Thumb
            } else {
                InstructionSet::Arm
            },
            endian: self.data_endian(),
            privileged: self.state.privileged(),
            mpu: is_set(sctlr::M, self.sctlr),
            fpu: self.ties.options.fpu,
        }
    }

    /// Where the block to run at `pc` starts. Where there's none yet but `pc` is inside another
    /// block's bytes, as it is after a stretch that ran out partway through one, it's the one
    /// instruction there, until that's run often enough to be worth a block. Every instruction a
    /// stretch could stop after would otherwise get a block of its own.
    fn start_at(&mut self, pc: u32) -> Start {
        let full = self.start(pc);
        if self.blocks.get(self.key_of(full)).is_some() || !self.blocks.covers(u64::from(pc)) {
            return full;
        }
        Start { longest: 1, ..full }
    }

    /// The block at `start`, translated now if it isn't already, or `None` when its fetch is a
    /// Prefetch Abort the bus ECC raised. A block kept never starts at a word whose check bits
    /// don't match, since a change to the word or to its check bits drops it, so only one to
    /// translate is checked.
    fn block(&mut self, start: Start) -> Result<Option<Block>, Error> {
        let key = self.key_of(start);
        if let Some(block) = self.blocks.get(key) {
            self.link_to(key, block);
            return Ok(Some(block));
        }
        let thumb = start.instruction_set == InstructionSet::Thumb;
        match self.fetch_checked(start.pc, thumb) {
            Some(Err(refused)) => {
                self.raised = Some(Raised::FetchRefused(refused));
                return Ok(None);
            }
            Some(Ok(())) => return self.block_once(start).map(Some),
            None => {}
        }
        if self.jit.made() > MOST_BLOCKS {
            self.start_over()?;
        }
        self.check_ahead(start.pc);
        let (block, range) = self.compile_with_room(start, Tier::Quick)?;
        self.keep(key, block, range);
        self.link_to(key, block);
        Ok(Some(block))
    }

    /// The one instruction at `start`, translated from the words the bus answered for it and kept
    /// nowhere, so it's checked again the next time it runs. Nothing is linked to it.
    fn block_once(&mut self, start: Start) -> Result<Block, Error> {
        self.unlinked = None;
        if self.jit.made() > MOST_BLOCKS {
            self.start_over()?;
        }
        let made = self.compile_with_room(
            Start {
                longest: 1,
                ..start
            },
            Tier::Best,
        );
        self.corrected.clear();
        made.map(|(block, _)| block)
    }

    /// Translates the block at `start` again with better code, now that it has run often, in
    /// place of its quick translation. When the code space is full the code generator starts over
    /// instead, and the block is translated afresh the next time it runs.
    fn promote(&mut self, start: Start) -> Result<(), Error> {
        let key = self.key_of(start);
        match self.compile(start, Tier::Best) {
            Ok((block, range)) => {
                self.blocks.replace(key, block);
                self.keep(key, block, range);
                Ok(())
            }
            Err(_) if self.jit.out_of_room() => self.start_over(),
            Err(error) => Err(error),
        }
    }

    /// [`Family::compile`], starting the code generator over once when the code space fills
    /// before [`MOST_BLOCKS`] do.
    fn compile_with_room(&mut self, start: Start, tier: Tier) -> Result<Translated, Error> {
        match self.compile(start, tier) {
            Err(_) if self.jit.out_of_room() => {
                self.start_over()?;
                self.compile(start, tier)
            }
            made => made,
        }
    }

    /// Drops every translation and frees the code generator's memory, to start over.
    fn start_over(&mut self) -> Result<(), Error> {
        self.drop_translations();
        // SAFETY: no block runs between two of the run loop's calls, and every one was dropped.
        unsafe { self.jit.clear()? };
        self.blocks.free_cells();
        self.unlinked = None;
        Ok(())
    }

    /// Keeps `block` under `key`, dropped by a store to any of the bytes from `first` to `last`.
    fn keep(&mut self, key: u64, block: Block, (first, last): (u32, u32)) {
        let (first, last) = (u64::from(first), u64::from(last.max(first)));
        self.blocks.insert(key, first, last, block);
        for page in first >> PAGE_BITS..=last >> PAGE_BITS {
            self.pages.hold_code(page << PAGE_BITS);
        }
    }

    /// The key of the block at `start`. A block that starts at a breakpoint is kept apart, under a
    /// key no exit finds a block by, so only the run loop runs it, once it has seen the breakpoint.
    fn key_of(&self, start: Start) -> u64 {
        let apart = self.breakpoints.contains_key(&u64::from(start.pc));
        block_key(start) | if apart { AT_BREAKPOINT } else { 0 }
    }

    /// Translates the block at `start` at `tier`, and answers it and the first and last byte it
    /// came from. A quick translation counts its runs. Instructions are fetched in the order
    /// `SCTLR.IE` gives, A3.3.1, and an exit chains only to a block in the same instruction set,
    /// byte order and privilege as this one.
    fn compile(&mut self, start: Start, tier: Tier) -> Result<Translated, Error> {
        let counter = (tier == Tier::Quick).then(|| self.blocks.new_counter());
        let recent = Place::At(self.blocks.recent());
        let order = self.instruction_endian();
        let Self {
            jit,
            pages,
            blocks,
            breakpoints,
            words,
            corrected,
            ..
        } = self;
        let mut fetch = |address: u32, size: Size| {
            if let Some(answered) = Self::fetch_corrected(corrected, address, size, order) {
                return Some(answered);
            }
            let (host, _) = pages.host(u64::from(address))?;
            if !address.is_multiple_of(size.bytes()) {
                return None;
            }
            // SAFETY: `host` is the page table's for `address`, which is aligned to `size`.
            Some(unsafe { read_host(host, size, order) })
        };
        let mut cells = |pc: u32, it: u32| {
            let next = block_key(Start {
                pc,
                it,
                longest: LONGEST_BLOCK,
                ..start
            });
            Place::At(blocks.new_cell(next).1)
        };
        // With the MPU on every block comes back to the run loop, which checks its fetches, and so
        // does one translated from the words the bus answered, which runs once.
        let cells: Option<(Cells<'_>, Place)> =
            (!start.mpu && corrected.is_empty()).then_some((&mut cells, recent));
        let stop_before = |address: u32| {
            breakpoints.contains_key(&u64::from(address))
                || Self::unchecked_fetch(words, |at| pages.held(at), address)
        };
        translate::translate(jit, start, &mut fetch, &stop_before, cells, tier, counter)
    }

    /// Links the last block's exit to `block`, keyed `key`, if it led there and nothing came
    /// between. A block with a breakpoint at its start is never linked to, so the run loop always
    /// sees the breakpoint first.
    fn link_to(&mut self, key: u64, block: Block) {
        if let Some(cell) = self.unlinked.take() {
            self.blocks.link(cell, key, block);
        }
    }

    /// Drops every block translated.
    pub(crate) fn drop_translations(&mut self) {
        self.blocks.clear();
        self.pages.release_all_code();
    }

    /// Drops whatever was translated from the bytes in `start..end`, at every address they answer
    /// at.
    pub(crate) fn invalidate(&mut self, start: u64, end: u64) {
        // Nothing past the address space has code, however far a request reaches.
        let (start, end) = (start.min(ADDRESS_SPACE), end.min(ADDRESS_SPACE));
        // Most stores the slow path makes are to data, a stack frame say, far from any code.
        if !self.pages.touches_code(start, end) {
            return;
        }
        let blocks = self.blocks.len();
        for (start, end) in self.pages.views(start, end) {
            for (page, held) in self.blocks.drop_range(start, end) {
                if !held {
                    self.pages.release_code(page);
                }
            }
        }
        if self.blocks.len() != blocks {
            // What a fetch is allowed hangs on the bytes too, a 32-bit Thumb instruction's.
            self.fetches.1.clear();
            // A block that's running, or looping, or chained to, may be one of those dropped, and
            // the core stops running it once this instruction is done.
            self.returning = RETURN;
        }
    }

    /// Does what the run asked while the processor ran.
    fn settle(&mut self) {
        for queued in self.on_bus(Vec::new(), |bus| bus.queued()) {
            self.ask(queued);
        }
    }

    /// One access of an instruction's: aligned as it must be, A3.2.1, then answered by memory
    /// mapped here or by the runner's bus. An unaligned access the core allows is made a byte at a
    /// time, each byte where the data's byte order puts it, A3.3.
    pub(crate) fn access(
        &mut self,
        request: Request,
        attributes: Attributes,
        position: Position,
    ) -> Result<u32, Refused> {
        let Request {
            address,
            size,
            write,
        } = request;
        let bytes = size.bytes();
        let kind = if write.is_some() {
            Kind::Write
        } else {
            Kind::Read
        };
        if address.is_multiple_of(bytes) {
            self.mpu_allows(address, kind, attributes.unprivileged)?;
            return self.reach(request, position);
        }
        if attributes.aligned || is_set(sctlr::A, self.sctlr) {
            return Err(Refused::Unaligned(address));
        }
        let endian = self.data_endian();
        let mut value = 0;
        for byte in 0..bytes {
            let lane = match endian {
                Endian::Little => byte,
                Endian::Big => bytes - 1 - byte,
            };
            let part = Request {
                address: address.wrapping_add(byte),
                size: Size::Byte,
                write: write.map(|value| (value >> (8 * lane)) & 0xFF),
            };
            // The pseudocode's `MemU_with_priv()` checks an unaligned access a byte at a time, so
            // a refusal reports the byte refused.
            self.mpu_allows(part.address, kind, attributes.unprivileged)?;
            let piece = self
                .reach(part, position)
                .map_err(|refused| match refused {
                    Refused::Bus(_) => Refused::Bus(address),
                    _ => refused,
                })?;
            value |= piece << (8 * lane);
        }
        Ok(value)
    }

    /// The build options the part chose.
    pub(crate) fn options(&self) -> Options {
        self.ties.options
    }

    /// [`Family::mpu_check`] for a data access, which also lets the accesses of the page that the
    /// MPU gives the processor's privilege be inline, the first time the page is reached since the
    /// configuration or the privilege last changed.
    fn mpu_allows(&mut self, address: u32, kind: Kind, unprivileged: bool) -> Result<(), Refused> {
        if !is_set(sctlr::M, self.sctlr) {
            return Ok(());
        }
        self.mpu_check(address, kind, unprivileged)?;
        let wide = u64::from(address);
        if !self.pages.decided(wide) {
            let page = address >> PAGE_BITS << PAGE_BITS;
            let inline = self.mpu_inline(page, 1 << PAGE_BITS);
            self.pages.allow(wide, inline);
        }
        Ok(())
    }

    /// The MPU's configuration changed. Unlike the M core's, this drops no translation, since
    /// an RTOS rewrites the regions at every context switch: it moves the configuration the
    /// fetch answers are kept for on, and the page table checks every data access again while
    /// the MPU is on.
    pub(crate) fn mpu_changed(&mut self) {
        self.configuration += 1;
        self.pages.check_all(is_set(sctlr::M, self.sctlr));
        self.inline_privileged = self.state.privileged();
    }

    /// Forgets what the page table let be inline when the privilege changed since, as an
    /// exception or an exception return changes it.
    fn forget_inline_on_privilege(&mut self) {
        let privileged = self.state.privileged();
        if privileged != self.inline_privileged {
            self.inline_privileged = privileged;
            self.pages.check_all(is_set(sctlr::M, self.sctlr));
        }
    }

    /// `start` as far as the MPU lets its instructions be fetched, B5.4.2, or why the first can't
    /// be. A block that may reach a smallest region it can't fetch from is one instruction long,
    /// so the instruction there aborts on its own lookup. A 32-bit Thumb instruction is checked at
    /// both halfwords, and refused at the second, the address B5.5.3 puts in `IFAR`.
    fn fetchable(&mut self, start: Start) -> Result<Start, Refused> {
        let key = block_key(start);
        if self.fetches.0 != self.configuration {
            self.fetches = (self.configuration, BTreeMap::new());
        }
        let known = self.fetches.1.get(&key).copied();
        let longest = known.unwrap_or_else(|| {
            let answer = self.fetch_longest(start);
            self.fetches.1.insert(key, answer);
            answer
        })?;
        Ok(Start { longest, ..start })
    }

    /// What [`Family::fetchable`] keeps for `start`.
    fn fetch_longest(&self, start: Start) -> Result<u32, Refused> {
        let pc = start.pc;
        self.mpu_check(pc, Kind::Fetch, false)?;
        let thumb = start.instruction_set == InstructionSet::Thumb;
        let second = pc.wrapping_add(2);
        if thumb && !self.mpu_fetch_allows(second) && self.wide_thumb(pc) {
            self.mpu_check(second, Kind::Fetch, false)?;
        }
        let granule = |address: u32| address >> SMALLEST_REGION_BITS;
        // Four bytes an instruction at most, short of the top of the address space.
        let last = pc.saturating_add(start.longest * 4 - 1);
        let whole = (granule(pc) + 1..=granule(last))
            .all(|at| self.mpu_fetch_allows(at << SMALLEST_REGION_BITS));
        Ok(if whole { start.longest } else { 1 })
    }

    /// Whether the halfword at `pc` starts a 32-bit Thumb instruction, A6.1.
    fn wide_thumb(&self, pc: u32) -> bool {
        let order = self.instruction_endian();
        self.pages.host(u64::from(pc)).is_some_and(|(host, _)| {
            // SAFETY: `host` is the page table's for `pc`, an instruction's, which is aligned.
            let first = unsafe { read_host(host, Size::Halfword, order) };
            translate::Instruction::is_wide(u16::try_from(first).expect("a halfword"))
        })
    }

    /// An aligned access, answered by memory mapped here or by the runner's bus.
    fn reach(&mut self, request: Request, position: Position) -> Result<u32, Refused> {
        let Request {
            address,
            size,
            write,
        } = request;
        let wide = u64::from(address);
        if write.is_none()
            && self.wrong(wide)
            && let Some(loaded) =
                self.load_checked(address, size, position.pc, self.instructions(position))
        {
            return loaded;
        }
        if let Some(value) = write
            && self.listed(wide)
            && let Some(stored) = self.store_checked(
                (address, size, value),
                position.pc,
                self.instructions(position),
            )
        {
            return stored;
        }
        let endian = self.data_endian();
        if let Some((host, writable)) = self.pages.host(wide)
            && !self.pages.routed(wide)
        {
            match write {
                // SAFETY: `host` is the page table's for `wide`, which every access that reaches
                // here has aligned to `size`.
                None => return Ok(unsafe { read_host(host, size, endian) }),
                Some(value) if writable => {
                    // SAFETY: `host` is the page table's for `wide`.
                    unsafe { self.storing(host) };
                    // SAFETY: as the read's, and the page table maps the page writable.
                    unsafe { write_host(host, size, value, endian) };
                    self.invalidate(wide, wide + u64::from(size.bytes()));
                    return Ok(value);
                }
                Some(_) => {}
            }
        }
        let instructions = self.instructions(position);
        self.reached_bus();
        let width = match size {
            Size::Byte => Width::W8,
            Size::Halfword => Width::W16,
            Size::Word => Width::W32,
        };
        let answer = self.on_bus(None, |bus| {
            let access = Access {
                kind: if write.is_some() {
                    AccessKind::Write
                } else {
                    AccessKind::Read
                },
                address: wide,
                width,
                value: u64::from(write.unwrap_or(0)),
                instruction_count: instructions,
                virtual_time: bus.time(instructions),
                program_counter: Some(u64::from(position.pc)),
            };
            bus.access(access, true)
        });
        if self.panicked.is_some() {
            // The stretch ends at this instruction and hands the panic on, so nothing uses this.
            return Ok(0);
        }
        self.settle();
        if answer.is_some() {
            self.hand_back(instructions);
        } else {
            self.returning = RETURN;
        }
        answer
            .map(|value| u32::try_from(value & u64::from(size.low_bytes())).expect("masked"))
            .ok_or(Refused::Bus(address))
    }

    /// After an access that left plain memory, with `instructions` retired counting its own:
    /// whether the processor goes back to the runner after this instruction, or only to its own
    /// loop, carrying on with the budget the runner would have given it next.
    fn hand_back(&mut self, instructions: u64) {
        if self.returning == RETURN {
            return;
        }
        self.reached_bus();
        match self.on_bus(None, |bus| bus.carry_on(instructions, None)) {
            Some(left) => {
                self.returning = CARRY_ON;
                self.carried = left;
            }
            None => self.returning = RETURN,
        }
    }

    /// The instructions retired by the time an access at `position` is made, counting its own.
    /// The instructions retired before the `index`-th of the running block.
    fn before(&self, index: u32) -> u64 {
        self.retired + u64::from(self.entered - self.budget) + u64::from(index)
    }

    fn instructions(&self, position: Position) -> u64 {
        // Chained blocks spend the budget as they go, and the run loop counts them only once the
        // chain returns.
        self.retired + u64::from(self.entered - self.budget) + u64::from(position.index) + 1
    }

    /// B1.3.3's `CPSRWriteByInstr()`: writes the bytes of the CPSR `bytemask` selects from
    /// `value`, as `MSR` does, with the execution state bits too for an exception return. User
    /// mode writes only the flags, `GE` and `E`. `SCTLR.NMFI` keeps `F` from being set, and a
    /// mode `BadMode()` refuses is UNPREDICTABLE and leaves the mode as it was.
    pub(crate) fn cpsr_write_by_instr(
        &mut self,
        value: u32,
        bytemask: u32,
        exception_return: bool,
    ) {
        let privileged = self.state.privileged();
        let selected = |byte: u32| bits(bytemask, byte, byte) == 1;
        let mut writes = 0;
        if selected(3) {
            writes |= mask(cpsr::N) | mask(cpsr::Z) | mask(cpsr::C) | mask(cpsr::V);
            writes |= mask(cpsr::Q);
            if exception_return {
                writes |= mask(cpsr::IT_1_0);
            }
        }
        if selected(2) {
            writes |= mask(cpsr::GE);
        }
        if selected(1) {
            if exception_return {
                writes |= mask(cpsr::IT_7_2);
            }
            writes |= mask(cpsr::E);
            if privileged {
                writes |= mask(cpsr::A);
            }
        }
        if selected(0) {
            let nmfi = is_set(sctlr::NMFI, self.sctlr);
            if privileged {
                writes |= mask(cpsr::I) | mask(cpsr::M);
            }
            if privileged && (!nmfi || !is_set(cpsr::F, value)) {
                writes |= mask(cpsr::F);
            }
            if exception_return {
                writes |= mask(cpsr::T);
            }
        }
        let before = self.state.cpsr();
        let written = before & !writes | value & writes;
        self.state.set_cpsr(written);
        // A mask cleared may let an exception in before the next instruction, B1.8.6.
        let masks = mask(cpsr::A) | mask(cpsr::I) | mask(cpsr::F);
        if before & !written & masks != 0 && self.returning == 0 {
            self.returning = CHECK;
        }
    }

    /// B1.3.3's `SPSRWriteByInstr()`: writes the bytes of the current mode's SPSR `bytemask`
    /// selects from `value`, as `MSR` does. User mode and System mode have no SPSR, which makes it
    /// UNPREDICTABLE, and nothing changes. A mode `BadMode()` refuses is UNPREDICTABLE and leaves
    /// the SPSR's as it was.
    pub(crate) fn spsr_write_by_instr(&mut self, value: u32, bytemask: u32) {
        if let Some(mode) = ExceptionMode::of(self.state.mode()) {
            self.spsr_write(mode, value, bytemask);
        }
    }

    /// `SPSRWriteByInstr()` on `mode`'s SPSR, whichever mode the core is in.
    fn spsr_write(&mut self, mode: ExceptionMode, value: u32, bytemask: u32) {
        let spsr = self.state.spsr_of(mode);
        let mut writes = (0..4)
            .filter(|&byte| bits(bytemask, byte, byte) == 1)
            .fold(0, |writes, byte| writes | SPSR_BYTES[byte as usize]);
        if Mode::from_bits(get(cpsr::M, value)).is_none() {
            writes &= !mask(cpsr::M);
        }
        self.state
            .set_spsr_of(mode, spsr & !writes | value & writes);
    }
}

/// The fields of an SPSR each bit of `SPSRWriteByInstr()`'s `bytemask` writes, B1.3.3: the ones in
/// bits 7 to 0, in 15 to 8, the `GE` flags of 23 to 16, and the ones in 31 to 24.
const SPSR_BYTES: [u32; 4] = [
    mask(cpsr::I) | mask(cpsr::F) | mask(cpsr::T) | mask(cpsr::M),
    mask(cpsr::IT_7_2) | mask(cpsr::E) | mask(cpsr::A),
    mask(cpsr::GE),
    mask(cpsr::N)
        | mask(cpsr::Z)
        | mask(cpsr::C)
        | mask(cpsr::V)
        | mask(cpsr::Q)
        | mask(cpsr::IT_1_0),
];

impl Processor for Family {
    fn run(&mut self, budget: u32, mut bus: &mut dyn CoreBus) -> (Exit, u64) {
        self.bus = Some(NonNull::from(&mut bus).cast());
        self.budget = budget;
        self.entered = budget;
        // What the last stretch asked of its own loop, or a store made between stretches, means
        // nothing to this one.
        self.returning = 0;
        let start = self.retired;
        let exit = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            self.settle();
            self.run_blocks()
        }));
        self.bus = None;
        let panic = match exit {
            Ok(exit) => self.panicked.take().map_or(Ok(exit), Err),
            // A panic between blocks may leave a block half made, or pages of code writable, so
            // every translation goes, in case whoever caught it runs this processor again.
            Err(panic) => {
                self.panicked = None;
                self.start_over().ok();
                Err(panic)
            }
        };
        match panic {
            Ok(exit) => (exit, self.retired - start),
            Err(panic) => std::panic::resume_unwind(panic),
        }
    }

    fn retired(&self) -> u64 {
        self.retired
    }

    /// An interrupt line drives the input of the same number, DDI 0460D 3.8.3, and the core has
    /// no others.
    fn ask(&mut self, queued: Queued) {
        match queued {
            Queued::Line(line, level) => {
                if let Some(input) = self.interrupts.get_mut(usize::from(line.index())) {
                    *input = level == Level::High;
                }
            }
            Queued::Invalidate(start, end) => {
                self.forget_loops();
                // The guest's own stores never reach memory the bus checks, so only the run's do.
                self.guarded_changed(start, end);
                self.invalidate(start, end);
            }
            Queued::Route(address) => {
                self.forget_loops();
                self.pages.route(address, true);
            }
            Queued::Unroute(address) => {
                self.forget_loops();
                self.pages.route(address, false);
            }
            Queued::Return => self.returning = RETURN,
        }
    }

    fn check_reads(&mut self, every: bool) {
        self.forget_loops();
        self.check_every_read(every);
    }

    fn check_words(&mut self, words: &[u64]) {
        self.forget_loops();
        Family::check_words(self, words);
    }

    fn maps(&self, start: u64, length: u64) -> bool {
        start.saturating_add(length) <= ADDRESS_SPACE && Pages::holds(start, length)
    }

    fn page_size(&self) -> u64 {
        PAGE_SIZE
    }

    unsafe fn map(&mut self, start: u64, length: u64, host: *mut u8, writable: bool) {
        self.forget_loops();
        // SAFETY: the caller's promise is the one the page table asks for.
        unsafe { self.pages.map(start, length, host, writable) };
        self.hold_guarded(start, length);
    }

    /// B1.9.1: the core starts at the reset vector, the table's first instruction.
    fn boot(&mut self, table: u64, _read: &dyn Fn(u64, Width) -> Option<u64>) {
        self.state.r[15] = u32::try_from(table).unwrap_or(0);
    }

    /// B1.9.1's `TakeReset()`, with `CPSR.T` and `CPSR.E` from `SCTLR.TE` and `SCTLR.EE`.
    fn reset(&mut self) {
        self.sctlr = Self::reset_sctlr(self.ties);
        self.state = State {
            t: get(sctlr::TE, self.sctlr),
            e: get(sctlr::EE, self.sctlr),
            ..State::default()
        };
        self.raised = None;
        self.faults = Faults::default();
        self.system = System::default();
        self.entries = (self.retired, 0);
        self.forget_everything();
        self.drop_translations();
        self.mpu_changed();
    }

    fn waiting(&self) -> bool {
        self.state.sleeping != 0
    }

    fn pc(&self) -> u64 {
        u64::from(self.state.r[15])
    }

    /// A3.2: a Thumb instruction is halfword-aligned and an ARM one word-aligned, both in the
    /// 32-bit space, and nowhere else can the core stop.
    fn add_breakpoint(&mut self, address: u64) -> bool {
        if address >= ADDRESS_SPACE || !address.is_multiple_of(2) {
            return false;
        }
        let asked = self.breakpoints.entry(address).or_default();
        *asked += 1;
        if *asked == 1 {
            // Every block over the address would run through it.
            self.invalidate(address, address + 1);
        }
        true
    }

    fn remove_breakpoint(&mut self, address: u64) {
        if let Some(asked) = self.breakpoints.get_mut(&address) {
            *asked -= 1;
            if *asked == 0 {
                self.breakpoints.remove(&address);
                self.invalidate(address, address + 1);
            }
        }
    }

    fn pass_breakpoint(&mut self, address: u64) {
        self.passing = Some(address);
    }

    fn hold_interrupts(&mut self, held: bool) {
        self.held = held;
    }

    fn gdb_register(&self, number: usize) -> Option<Vec<u8>> {
        let (value, width) = self.gdb_value(number)?;
        Some(to_target(value, width, self.ties.endian)[..width].to_vec())
    }

    fn set_gdb_register(&mut self, number: usize, bytes: &[u8]) -> bool {
        let Some((_, width)) = self.gdb_value(number) else {
            return false;
        };
        width == bytes.len() && self.set_gdb_value(number, from_target(bytes, self.ties.endian))
    }

    fn target_xml(&self) -> &'static str {
        if self.ties.options.fpu == Fpu::None {
            Self::TARGET_XML_WITHOUT_FP
        } else {
            Self::TARGET_XML
        }
    }

    fn data_model(&self) -> DataModel {
        DATA_MODEL
    }

    /// The part's order. `CPSR.E` changes the order the core's data accesses take, not the one
    /// memory holds, A2.5.3.
    fn byte_order(&self, _address: u64) -> Endian {
        self.ties.endian
    }

    fn save(&self) -> Vec<u8> {
        postcard::to_allocvec(&self.saved()).expect("the processor's state serializes")
    }

    /// A state from a part with other tie-offs, `SCTLR.IE` and `SCTLR.NMFI`, is refused. Every
    /// block stays, since its key holds what its translation depends on.
    fn load(&mut self, bytes: &[u8]) -> Result<(), Error> {
        let saved: Saved = match postcard::take_from_bytes(bytes) {
            Ok((saved, [])) => saved,
            Ok(_) | Err(_) => return Err(Error::State),
        };
        let tied = mask(sctlr::IE) | mask(sctlr::NMFI);
        if !saved.state.consistent() || (saved.sctlr ^ Self::reset_sctlr(self.ties)) & tied != 0 {
            return Err(Error::State);
        }
        self.state = saved.state;
        self.sctlr = saved.sctlr;
        self.faults = saved.faults;
        self.system = saved.system;
        self.interrupts = saved.interrupts;
        self.entries = saved.entries;
        self.retired = saved.retired;
        self.forget_everything();
        self.raised = None;
        self.mpu_changed();
        Ok(())
    }
}

/// A register as GDB numbers it, in the order [`Family::TARGET_XML`] gives.
#[derive(Clone, Copy)]
enum GdbRegister {
    /// R0 to R15 as the current mode sees them, B1.3.2.
    Core(usize),
    Cpsr,
    /// D0 to D15, each a pair of single-precision registers.
    Double(usize),
    Fpscr,
    Fpexc,
    /// A mode's banked register from any mode, B1.3.2. User mode's are among them, since every
    /// exception mode banks some of them away.
    Banked(Mode, Bankable),
    /// An exception mode's SPSR from any mode, B1.3.3.
    Spsr(ExceptionMode),
}

/// A register some mode banks, R8 to R14, B1.3.2.
#[derive(Clone, Copy)]
enum Bankable {
    R8 = 8,
    R9,
    R10,
    R11,
    R12,
    Sp,
    Lr,
}

/// The registers each mode banks, in the order the banked feature names them: R8 to R14 of User
/// mode and of FIQ mode, then R13 and R14 of each other exception mode, each exception mode's
/// SPSR after its own, B1.3.2 and B1.3.3. System mode shares User mode's.
const BANKED: [GdbRegister; 27] = {
    use Bankable::{Lr, R8, R9, R10, R11, R12, Sp};
    use ExceptionMode::{Abort, Fiq, Irq, Supervisor, Undefined};
    use GdbRegister::{Banked, Spsr};
    [
        Banked(Mode::User, R8),
        Banked(Mode::User, R9),
        Banked(Mode::User, R10),
        Banked(Mode::User, R11),
        Banked(Mode::User, R12),
        Banked(Mode::User, Sp),
        Banked(Mode::User, Lr),
        Banked(Mode::Fiq, R8),
        Banked(Mode::Fiq, R9),
        Banked(Mode::Fiq, R10),
        Banked(Mode::Fiq, R11),
        Banked(Mode::Fiq, R12),
        Banked(Mode::Fiq, Sp),
        Banked(Mode::Fiq, Lr),
        Spsr(Fiq),
        Banked(Mode::Irq, Sp),
        Banked(Mode::Irq, Lr),
        Spsr(Irq),
        Banked(Mode::Supervisor, Sp),
        Banked(Mode::Supervisor, Lr),
        Spsr(Supervisor),
        Banked(Mode::Abort, Sp),
        Banked(Mode::Abort, Lr),
        Spsr(Abort),
        Banked(Mode::Undefined, Sp),
        Banked(Mode::Undefined, Lr),
        Spsr(Undefined),
    ]
};

/// The target description GDB reads: the core's registers and the CPSR, then the floating-point
/// registers with `FPEXC` when the core has them, B1.11, then every mode's banked registers in the
/// order [`BANKED`] gives. The core and floating-point features are "Debugging with GDB" for GDB
/// 18.1, section G.5.4. That manual names no feature for the banked registers, so they're in one
/// of the run's own, in the `banked` group, which `info registers banked` prints.
macro_rules! target_xml {
    ($($floating:expr)?) => {
        concat!(
            r#"<?xml version="1.0"?><!DOCTYPE target SYSTEM "gdb-target.dtd"><target>"#,
            "<architecture>arm</architecture>",
            r#"<feature name="org.gnu.gdb.arm.core">"#,
            crate::cpu::armv7::gdb_core_registers!(),
            r#"<reg name="cpsr" bitsize="32"/></feature>"#,
            $($floating,)?
            r#"<feature name="org.rigless.arm.banked">"#,
            r#"<reg name="r8_usr" bitsize="32" group="banked"/><reg name="r9_usr" bitsize="32" group="banked"/>"#,
            r#"<reg name="r10_usr" bitsize="32" group="banked"/><reg name="r11_usr" bitsize="32" group="banked"/>"#,
            r#"<reg name="r12_usr" bitsize="32" group="banked"/>"#,
            r#"<reg name="sp_usr" bitsize="32" type="data_ptr" group="banked"/><reg name="lr_usr" bitsize="32" group="banked"/>"#,
            r#"<reg name="r8_fiq" bitsize="32" group="banked"/><reg name="r9_fiq" bitsize="32" group="banked"/>"#,
            r#"<reg name="r10_fiq" bitsize="32" group="banked"/><reg name="r11_fiq" bitsize="32" group="banked"/>"#,
            r#"<reg name="r12_fiq" bitsize="32" group="banked"/>"#,
            r#"<reg name="sp_fiq" bitsize="32" type="data_ptr" group="banked"/><reg name="lr_fiq" bitsize="32" group="banked"/>"#,
            r#"<reg name="spsr_fiq" bitsize="32" group="banked"/>"#,
            r#"<reg name="sp_irq" bitsize="32" type="data_ptr" group="banked"/><reg name="lr_irq" bitsize="32" group="banked"/>"#,
            r#"<reg name="spsr_irq" bitsize="32" group="banked"/>"#,
            r#"<reg name="sp_svc" bitsize="32" type="data_ptr" group="banked"/><reg name="lr_svc" bitsize="32" group="banked"/>"#,
            r#"<reg name="spsr_svc" bitsize="32" group="banked"/>"#,
            r#"<reg name="sp_abt" bitsize="32" type="data_ptr" group="banked"/><reg name="lr_abt" bitsize="32" group="banked"/>"#,
            r#"<reg name="spsr_abt" bitsize="32" group="banked"/>"#,
            r#"<reg name="sp_und" bitsize="32" type="data_ptr" group="banked"/><reg name="lr_und" bitsize="32" group="banked"/>"#,
            r#"<reg name="spsr_und" bitsize="32" group="banked"/></feature>"#,
            "</target>",
        )
    };
}

impl Family {
    const TARGET_XML: &'static str = target_xml!(crate::cpu::armv7::gdb_vfp_registers!(
        r#"<reg name="fpexc" bitsize="32" type="int" group="float"/>"#
    ));
    const TARGET_XML_WITHOUT_FP: &'static str = target_xml!();

    /// The register GDB numbers `number`, if the core has it.
    fn gdb_number(&self, number: usize) -> Option<GdbRegister> {
        let fp = self.ties.options.fpu != Fpu::None;
        Some(match number {
            0..16 => GdbRegister::Core(number),
            16 => GdbRegister::Cpsr,
            17..33 if fp => GdbRegister::Double(number - 17),
            33 if fp => GdbRegister::Fpscr,
            34 if fp => GdbRegister::Fpexc,
            _ => *BANKED.get(number.checked_sub(if fp { 35 } else { 17 })?)?,
        })
    }

    /// The register GDB numbers `number`, as its value and its width in bytes, if there's one.
    fn gdb_value(&self, number: usize) -> Option<(u64, usize)> {
        let state = &self.state;
        let word = |value: u32| Some((u64::from(value), 4));
        match self.gdb_number(number)? {
            GdbRegister::Core(number) => word(state.r[number]),
            GdbRegister::Cpsr => word(state.cpsr()),
            GdbRegister::Double(number) => Some((
                u64::from(state.s[2 * number]) | u64::from(state.s[2 * number + 1]) << 32,
                8,
            )),
            GdbRegister::Fpscr => word(state.fpscr),
            GdbRegister::Fpexc => word(state.fpexc),
            GdbRegister::Banked(mode, register) => word(state.reg_of(mode, register as usize)),
            GdbRegister::Spsr(mode) => word(state.spsr_of(mode)),
        }
    }

    /// Writes `value` to the register GDB numbers `number`, and answers whether there's one. The
    /// PC drops the bits an instruction's address can't have in the state the core is in, a CPSR
    /// naming a mode `BadMode()` refuses keeps the mode, and an SPSR takes what `MSR` writes of a
    /// whole word, B1.3.3.
    fn set_gdb_value(&mut self, number: usize, value: u64) -> bool {
        let Some(register) = self.gdb_number(number) else {
            return false;
        };
        let word = u32::try_from(value & u64::from(u32::MAX)).expect("masked");
        let state = &mut self.state;
        match register {
            GdbRegister::Core(15) => {
                let ignored = if state.t == 0 { 3 } else { 1 };
                state.r[15] = word & !ignored;
            }
            GdbRegister::Core(number) => state.r[number] = word,
            GdbRegister::Cpsr => state.set_cpsr(word),
            GdbRegister::Double(number) => {
                state.s[2 * number] = word;
                state.s[2 * number + 1] = u32::try_from(value >> 32).expect("the high word");
            }
            GdbRegister::Fpscr => state.fpscr = word,
            GdbRegister::Fpexc => state.fpexc = word,
            GdbRegister::Banked(mode, register) => state.set_reg_of(mode, register as usize, word),
            GdbRegister::Spsr(mode) => self.spsr_write(mode, word, 0b1111),
        }
        true
    }
}

#[cfg(test)]
impl Family {
    /// The blocks translated.
    pub(crate) fn translated(&self) -> usize {
        self.blocks.len()
    }

    /// The accesses of the page holding `address` that are inline.
    pub(crate) fn inline(&self, address: u32) -> crate::emulator::core::Inline {
        self.pages.inline(u64::from(address))
    }
}

/// What [`Processor::save`] writes.
#[derive(Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
struct Saved {
    state: State,
    sctlr: u32,
    faults: Faults,
    system: System,
    interrupts: [bool; INTERRUPT_INPUTS],
    entries: (u64, u32),
    retired: u64,
}

/// What generated code calls, each with the processor it runs on.
pub(crate) mod helpers {
    use super::super::exception::buffered;
    use super::{
        Attributes, Family, Fault, Position, Raised, Refused, Request, Size, SystemRegister,
    };
    use crate::cpu::armv7::translate::FAULTED;

    /// A load the page table didn't answer: the value, or [`FAULTED`] when the core refused it,
    /// which raises a Data Abort.
    pub(crate) extern "C" fn read(
        core: &mut Family,
        address: u32,
        bytes: u32,
        attributes: u32,
        pc: u32,
        index: u32,
    ) -> u64 {
        let request = Request::read(address, Size::from_bytes(bytes));
        match core.access(
            request,
            Attributes::from_bits(attributes),
            Position { pc, index },
        ) {
            Ok(value) => u64::from(value),
            Err(refused) => {
                core.raised = Some(Raised::DataAbort {
                    refused,
                    write: false,
                });
                FAULTED
            }
        }
    }

    /// A store the page table didn't take: 0, or [`FAULTED`] when the core refused it, which
    /// raises a Data Abort.
    pub(crate) extern "C" fn write(
        core: &mut Family,
        address: u32,
        value: u32,
        bytes: u32,
        attributes: u32,
        pc: u32,
        index: u32,
    ) -> u64 {
        let request = Request::write(address, Size::from_bytes(bytes), value);
        match core.access(
            request,
            Attributes::from_bits(attributes),
            Position { pc, index },
        ) {
            Ok(_) => 0,
            // The store retires and its abort waits for `A` to clear, DDI 0460D 3.8.4.
            Err(Refused::Bus(at)) if buffered(at) => {
                core.faults.pending = true;
                0
            }
            Err(refused) => {
                core.raised = Some(Raised::DataAbort {
                    refused,
                    write: true,
                });
                FAULTED
            }
        }
    }

    /// `MRC` from CP15, `instruction`'s register: its value, or [`FAULTED`] where the core hasn't
    /// got the register or the privilege may not read it, which is the Undefined Instruction
    /// exception, B1.9.2.
    pub(crate) extern "C" fn mrc(core: &mut Family, instruction: u32, index: u32) -> u64 {
        let before = core.before(index);
        let Some(value) = core.cp15_read(SystemRegister::of(instruction), before) else {
            core.raised = Some(Raised::Fault(Fault::Undefined));
            return FAULTED;
        };
        u64::from(value)
    }

    /// 1 where B1.11.1's `CheckVFPEnabled()` refuses, with the `FPEXC.EN` check when
    /// `include_fpexc` is nonzero, and 0 where it doesn't.
    pub(crate) extern "C" fn fp_refused(core: &mut Family, include_fpexc: u32) -> u32 {
        u32::from(!core.fp_enabled(include_fpexc != 0))
    }

    /// `MCR` to CP15, `value` to `instruction`'s register: 0, or [`FAULTED`] where the core
    /// hasn't got the register or the privilege may not write it, B1.9.2.
    pub(crate) extern "C" fn mcr(
        core: &mut Family,
        instruction: u32,
        value: u32,
        index: u32,
    ) -> u64 {
        let before = core.before(index);
        if core.cp15_write(SystemRegister::of(instruction), value, before) {
            return 0;
        }
        core.raised = Some(Raised::Fault(Fault::Undefined));
        FAULTED
    }

    /// An access to `address` that had to be aligned and wasn't, a store when `write` is 1:
    /// always [`FAULTED`], with the alignment fault's Data Abort recorded as a refused access's
    /// is, Table A3-1 and B5.5.2.
    pub(crate) extern "C" fn unaligned(core: &mut Family, address: u32, write: u32) -> u64 {
        core.raised = Some(Raised::DataAbort {
            refused: Refused::Unaligned(address),
            write: write != 0,
        });
        FAULTED
    }

    /// The current mode's SPSR, B1.3.3's `SPSR[]`, for an exception return to restore. User mode
    /// and System mode have none, which makes the return UNPREDICTABLE, B9.1.1, and they get the
    /// CPSR, so the return restores what's already there and only branches.
    pub(crate) extern "C" fn spsr(core: &mut Family) -> u32 {
        core.state.spsr().unwrap_or_else(|| core.state.cpsr())
    }

    /// An instruction's fault, by its [`Fault`] number. A call answers a value, and this one's is
    /// always 0.
    pub(crate) extern "C" fn raise(core: &mut Family, code: u32) -> u32 {
        core.raised = Fault::from_code(code).map(Raised::Fault);
        0
    }

    /// Compiles the block `build` lowers and runs it once on `core`, outside the run loop, and
    /// answers what it answered, for the tests of what the emitter does itself. `build` gets the
    /// builder, the core's pointer and the signature every block has.
    #[cfg(test)]
    pub(crate) fn run_built(
        core: &mut Family,
        build: impl FnOnce(
            &mut cranelift_frontend::FunctionBuilder<'_>,
            cranelift_codegen::ir::Value,
            &cranelift_codegen::ir::Signature,
        ),
    ) -> u32 {
        let block = core
            .jit
            .compile(crate::emulator::core::Tier::Best, build)
            .expect("a block");
        let budget = core.budget;
        let entry = core.jit.entry();
        // SAFETY: a block just made for this processor, and the code generator's entry, both since
        // its last `jit.clear()`, called with the processor, which nothing else touches until the
        // block returns.
        let status = unsafe { entry.run(std::ptr::from_mut(core).cast(), block) };
        budget.wrapping_sub(core.budget) << 8 | status
    }
}

#[cfg(test)]
mod tests {
    use cranelift_codegen::ir::{InstBuilder, types};

    use super::super::exception::Exception;
    use super::super::translate::testing::{Bench, CODE, DEVICE, RAM, SMALL, SPUN, ties};
    use super::*;
    use crate::cpu::armv7::translate::FAULTED;
    use crate::cpu::armv7::translate::{Chain, Emitter, Features, Profile};
    use crate::emulator::InterruptLine;

    /// B1.9.1's `TakeReset()`: Supervisor mode with every asynchronous exception masked, ARM state
    /// with `SCTLR.TE` clear, and the data in the order `SCTLR.EE` gives, the part's.
    #[test]
    fn a_reset_leaves_supervisor_mode_with_every_exception_masked() {
        for (endian, big) in [(Endian::Little, 0), (Endian::Big, 1)] {
            let core = Family::new(ties(endian)).unwrap();
            let state = &core.state;
            assert_eq!(
                (state.mode(), state.a, state.i, state.f, state.t, state.e),
                (Mode::Supervisor, 1, 1, 1, 0, big),
                "{endian:?}"
            );
            assert_eq!(get(sctlr::IE, core.sctlr), big, "{endian:?}");
        }
    }

    /// A3.2.1: an unaligned `LDR` is made with `SCTLR.A` clear and refused with it set, and an
    /// `LDRD` is always refused, each a Data Abort at the address the instruction asked for.
    #[test]
    fn an_unaligned_access_is_refused_only_where_it_must_be_aligned() {
        let ldr = [0x683E]; // LDR r6, [r7]
        let ldrd = [0xE9D7, 0x0100]; // LDRD r0, r1, [r7]
        let refused = Some(Raised::DataAbort {
            refused: Refused::Unaligned(RAM + 2),
            write: false,
        });
        for (code, checked, retired, raised) in [
            (&ldr[..], false, 1, None),
            (&ldr[..], true, SPUN, refused),
            (&ldrd[..], false, SPUN, refused),
        ] {
            let mut bench = Bench::thumb(Endian::Little, code);
            bench.core.state.r[7] = RAM + 2;
            if checked {
                bench.core.sctlr |= mask(sctlr::A);
            }
            assert_eq!(bench.run(1).1, retired, "{code:04x?} {checked}");
            assert_eq!(bench.aborted(), raised, "{code:04x?} {checked}");
        }
    }

    /// DDI 0460D 3.11: instructions come in the order `SCTLR.IE` gives and data in the order
    /// `CPSR.E` gives, apart. An ARM word, a Thumb halfword and both halfwords of a 32-bit Thumb
    /// instruction each load the same word in every combination of the two.
    #[test]
    fn instructions_follow_ie_and_data_follow_e() {
        let ldr_arm = [0xE591_0000]; // LDR r0, [r1]
        let ldr_narrow = [0x6808]; // LDR r0, [r1]
        let ldr_wide = [0xF8D1, 0x0000]; // LDR.W r0, [r1]
        for ie in [Endian::Little, Endian::Big] {
            for e in [0, 1] {
                for code in [None, Some(&ldr_narrow[..]), Some(&ldr_wide[..])] {
                    let mut bench = match code {
                        Some(code) => Bench::thumb(ie, code),
                        None => Bench::arm(ie, &ldr_arm),
                    };
                    bench.write(RAM, &[0x11, 0x22, 0x33, 0x44]);
                    bench.core.state.e = e;
                    bench.core.state.r[1] = RAM;
                    assert_eq!(bench.run(1).1, 1, "{ie:?} E={e} {code:04x?}");
                    let loaded = if e == 0 { 0x4433_2211 } else { 0x1122_3344 };
                    assert_eq!(bench.core.state.r[0], loaded, "{ie:?} E={e} {code:04x?}");
                }
            }
        }
    }

    /// A debugger's breakpoint stops the core before the instruction there, ARM or Thumb, in a
    /// block translated before it was set too, and the core runs past it once it's passed or once
    /// every ask for it is taken back. One at an odd address is refused.
    #[test]
    fn a_breakpoint_stops_before_its_instruction_and_is_passed_once() {
        let arm = Bench::arm(Endian::Big, &[0xE3A0_0001, 0xE3A0_1002, 0xE3A0_2003]); // MOVs
        let thumb = Bench::thumb(Endian::Little, &[0x2001, 0xF04F_u16, 0x0102, 0x2203]);
        for (mut bench, second, third) in [(arm, CODE + 4, CODE + 8), (thumb, CODE + 2, CODE + 6)] {
            assert_eq!(bench.run(3).1, 3, "translated whole");
            bench.core.state.r[15] = CODE;
            assert!(!bench.core.add_breakpoint(u64::from(second) + 1));
            assert!(bench.core.add_breakpoint(u64::from(second)));
            assert!(bench.core.add_breakpoint(u64::from(third)));
            assert!(bench.core.add_breakpoint(u64::from(third)), "asked twice");
            assert_eq!(bench.run(3), (Exit::Breakpoint, 1));
            assert_eq!(bench.run(3), (Exit::Breakpoint, 0), "until it's passed");
            bench.core.pass_breakpoint(u64::from(second));
            assert_eq!(bench.run(3), (Exit::Breakpoint, 1));
            assert_eq!(bench.core.state.r[15], third);
            bench.core.remove_breakpoint(u64::from(third));
            assert_eq!(
                bench.run(1),
                (Exit::Breakpoint, 0),
                "until both asks are taken back"
            );
            bench.core.remove_breakpoint(u64::from(third));
            assert_eq!(bench.run(1).1, 1);
            assert_eq!(bench.core.state.r[0..3], [1, 2, 3]);
        }
    }

    /// GDB reads and writes the core's registers in the part's order, the banked ones as the mode
    /// sees them, and a CPSR written swaps the mode's in.
    #[test]
    fn gdb_registers_come_in_the_parts_order_as_the_mode_sees_them() {
        for (endian, bytes) in [
            (Endian::Big, [0x11, 0x22, 0x33, 0x44]),
            (Endian::Little, [0x44, 0x33, 0x22, 0x11]),
        ] {
            let mut core = Family::new(ties(endian)).unwrap();
            core.state.r[8] = 0x1122_3344;
            assert_eq!(core.gdb_register(8), Some(bytes.to_vec()), "{endian:?}");
            let read = core.gdb_register(16).unwrap();
            let psr = u32::try_from(from_target(&read, endian)).unwrap();
            let fiq = set(cpsr::M, psr, Mode::Fiq as u32);
            assert!(core.set_gdb_register(16, &to_target(u64::from(fiq), 4, endian)[..4]));
            assert_eq!(core.state.mode(), Mode::Fiq);
            assert_eq!(core.state.r[8], 0, "FIQ's own R8");
            assert!(core.set_gdb_register(15, &to_target(0x103, 4, endian)[..4]));
            assert_eq!(core.state.r[15], 0x100, "an ARM instruction's address");
            core.state.s[0] = 0x1122_3344;
            core.state.s[1] = 0x5566_7788;
            let d0 = to_target(0x5566_7788_1122_3344, 8, endian)[..8].to_vec();
            assert_eq!(core.gdb_register(17), Some(d0), "D0, S1 above S0");
            let written = to_target(0x0102_0304_0506_0708, 8, endian);
            assert!(core.set_gdb_register(17, &written[..8]));
            assert_eq!(core.state.s[0..2], [0x0506_0708, 0x0102_0304]);
            assert!(core.gdb_register(34).is_some(), "FPEXC");
            assert!(
                core.gdb_register(61).is_some(),
                "SPSR_und, the last banked one"
            );
            assert_eq!(core.gdb_register(62), None);
        }
        // Without the floating-point registers the banked ones follow the CPSR.
        let mut plain = ties(Endian::Little);
        plain.options.fpu = Fpu::None;
        let mut core = Family::new(plain).unwrap();
        core.state.set_reg_of(Mode::User, 8, 0x1122_3344);
        core.state.set_mode(Mode::Fiq);
        assert_eq!(
            core.gdb_register(17),
            Some(vec![0x44, 0x33, 0x22, 0x11]),
            "r8_usr"
        );
        assert!(core.gdb_register(43).is_some(), "SPSR_und");
        assert_eq!(core.gdb_register(44), None);
    }

    /// A region smaller than a page is left to the bus, which can't fetch an instruction, so a
    /// fetch from it is a Prefetch Abort with `IFSR` reporting a synchronous external abort and
    /// `IFAR` the address, B1.9.7 and B5.5.
    #[test]
    fn a_fetch_from_a_region_smaller_than_a_page_aborts() {
        let mut bench = Bench::empty(Endian::Big);
        bench.place_arm(SMALL, &[0xE3A0_0001]); // MOV r0, #1
        bench.core.state.r[15] = SMALL;
        assert_eq!(bench.run(1).1, SPUN, "at the vector");
        assert_eq!(bench.raised(), Some((Exception::PrefetchAbort, SMALL)));
        let Faults { ifsr, ifar, .. } = bench.core.faults;
        assert_eq!((ifsr, ifar), (0b1000, SMALL));
    }

    /// An access nothing maps reaches the bus counted with its instruction, which the core returns
    /// to the runner after, and a load the bus fails is a Data Abort there, B1.9.8.
    #[test]
    fn an_access_nothing_maps_reaches_the_bus() {
        let mut bench = Bench::thumb(Endian::Big, &[0x6808, 0x6008]); // LDR r0, [r1]; STR r0, [r1]
        bench.core.state.r[1] = DEVICE;
        bench.bus.answer = 0x1234;
        assert_eq!(bench.run(2), (Exit::Returned, 1));
        assert_eq!(bench.core.state.r[0], 0x1234);
        let read = bench.bus.accesses[0];
        assert_eq!(
            (read.kind, read.address, read.width, read.instruction_count),
            (AccessKind::Read, u64::from(DEVICE), Width::W32, 1)
        );
        bench.core.state.r[15] = 0;
        bench.bus.fails_from = Some(u64::from(DEVICE));
        assert_eq!(bench.run(1), (Exit::Returned, 0));
        assert_eq!(
            (bench.raised(), bench.aborted()),
            (
                Some((Exception::DataAbort, 0)),
                Some(Raised::DataAbort {
                    refused: Refused::Bus(DEVICE),
                    write: false
                })
            )
        );
    }

    /// A8.8.107 and A8.8.98: `MRC p15, 1, r0, c15, c2, 3` names CP15's register by `opc1`, `CRn`,
    /// `CRm` and `opc2`, the same as `MRCNE` in ARM state and in Thumb state's two halfwords.
    #[test]
    fn an_mrc_names_its_register_the_same_way_in_either_state() {
        let named = SystemRegister {
            opc1: 1,
            crn: 15,
            crm: 2,
            opc2: 3,
        };
        assert_eq!(SystemRegister::of(0x1E3F_0F72), named);
        assert_eq!(SystemRegister::of(0xEE3F_0F72), named);
    }

    /// DDI 0460D 4.3.16: `MRC` reads `SCTLR` at its reset value, 0x00E50878 on a little-endian
    /// part, an `MCR` from User mode is the Undefined Instruction exception, B1.9.2, and changes
    /// nothing, and the read-only `NMFI` ignores a privileged write.
    #[test]
    fn sctlr_reads_its_reset_value_and_refuses_user_mode() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        let read_sctlr = 0xEE11_0F10; // MRC p15, 0, r0, c1, c0, 0
        assert_eq!(helpers::mrc(&mut core, read_sctlr, 0), 0x00E5_0878);
        let write_sctlr = 0xEE01_0F10; // MCR p15, 0, r0, c1, c0, 0
        core.state.set_mode(Mode::User);
        assert_eq!(helpers::mcr(&mut core, write_sctlr, u32::MAX, 0), FAULTED);
        assert_eq!(core.raised, Some(Raised::Fault(Fault::Undefined)));
        assert_eq!(core.sctlr, 0x00E5_0878);
        core.raised = None;
        core.state.set_mode(Mode::Supervisor);
        assert_eq!(
            helpers::mcr(&mut core, write_sctlr, mask(sctlr::NMFI), 0),
            0
        );
        assert_eq!(core.sctlr, 0x00E5_0878);
    }

    /// DDI 0460D 3.8.3: line 0 drives nIRQ and line 1 nFIQ, and the core has no other inputs.
    #[test]
    fn each_interrupt_line_drives_its_input() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        let line = |index| InterruptLine::new(index).unwrap();
        core.ask(Queued::Line(line(1), Level::High));
        core.ask(Queued::Line(line(2), Level::High));
        assert_eq!(core.interrupts, [false, true]);
        core.ask(Queued::Line(line(0), Level::High));
        core.ask(Queued::Line(line(1), Level::Low));
        assert_eq!(core.interrupts, [true, false]);
    }

    /// A saved state loads back as it was, and one from a part whose instructions are in the other
    /// order, or that isn't a state at all, is refused.
    #[test]
    fn a_saved_state_loads_back_on_the_same_part_only() {
        let mut core = Family::new(ties(Endian::Big)).unwrap();
        core.state.r[4] = 0x44;
        core.state.set_mode(Mode::Irq);
        core.interrupts = [true, false];
        let saved = core.save();
        let mut other = Family::new(ties(Endian::Big)).unwrap();
        other.load(&saved).unwrap();
        assert_eq!(
            (&other.state, other.interrupts),
            (&core.state, core.interrupts)
        );
        let mut little = Family::new(ties(Endian::Little)).unwrap();
        assert!(matches!(little.load(&saved), Err(Error::State)));
        assert!(matches!(other.load(&saved[1..]), Err(Error::State)));
    }

    const FLAGS: u32 =
        mask(cpsr::N) | mask(cpsr::Z) | mask(cpsr::C) | mask(cpsr::V) | mask(cpsr::Q);

    /// B1.3.3's `CPSRWriteByInstr()` from User mode writes the flags, `GE` and `E`, and leaves the
    /// masks and the mode alone.
    #[test]
    fn user_mode_writes_only_the_flags_ge_and_e() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        core.state.set_mode(Mode::User);
        let value = FLAGS | mask(cpsr::GE) | mask(cpsr::E) | Mode::Fiq as u32;
        core.cpsr_write_by_instr(value, 0b1111, false);
        let state = &core.state;
        assert_eq!(
            state.cpsr(),
            FLAGS
                | mask(cpsr::GE)
                | mask(cpsr::E)
                | mask(cpsr::A)
                | mask(cpsr::I)
                | mask(cpsr::F)
                | Mode::User as u32
        );
    }

    /// B1.3.3: a privileged write changes the masks and the mode, swapping in the new mode's
    /// banked registers, and only the bytes `bytemask` selects.
    #[test]
    fn a_privileged_write_changes_the_masks_and_the_mode() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        core.state.r[13] = 0x5000;
        core.cpsr_write_by_instr(Mode::Irq as u32 | FLAGS, 0b0001, false);
        let state = &core.state;
        assert_eq!(
            (state.mode(), state.a, state.i, state.f, state.n),
            (Mode::Irq, 1, 0, 0, 0)
        );
        assert_eq!(state.r[13], 0);
        core.cpsr_write_by_instr(Mode::Supervisor as u32, 0b0001, false);
        assert_eq!(core.state.r[13], 0x5000);
    }

    /// B1.3.3: with `SCTLR.NMFI` set, an instruction can clear `F` but not set it, and a mode
    /// `BadMode()` refuses leaves the mode as it was.
    #[test]
    fn nmfi_keeps_f_clear_and_a_bad_mode_changes_nothing() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        core.sctlr |= mask(sctlr::NMFI);
        let monitor = 0b10110;
        core.cpsr_write_by_instr(monitor, 0b0001, false);
        assert_eq!((core.state.mode(), core.state.f), (Mode::Supervisor, 0));
        core.cpsr_write_by_instr(mask(cpsr::F) | Mode::Supervisor as u32, 0b0001, false);
        assert_eq!(core.state.f, 0);
    }

    /// B1.3.3: only an exception return writes `ITSTATE` and `T`.
    #[test]
    fn only_an_exception_return_writes_the_execution_state() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        let value = mask(cpsr::IT_1_0) | mask(cpsr::IT_7_2) | mask(cpsr::T) | Mode::Abort as u32;
        core.cpsr_write_by_instr(value, 0b1111, false);
        assert_eq!(
            (core.state.it, core.state.t, core.state.mode()),
            (0, 0, Mode::Abort)
        );
        core.cpsr_write_by_instr(value, 0b1111, true);
        assert_eq!((core.state.it, core.state.t), (0xFF, 1));
    }

    /// B1.3.3's `SPSRWriteByInstr()` writes the bytes `bytemask` selects of the current mode's
    /// SPSR, keeps its mode for one `BadMode()` refuses, and does nothing in System mode, which
    /// has none.
    #[test]
    fn an_spsr_write_takes_the_bytes_selected() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        core.cpsr_write_by_instr(Mode::Undefined as u32, 0b0001, false);
        core.spsr_write_by_instr(u32::MAX, 0b1010);
        assert_eq!(
            core.state.spsr(),
            Some(0xFE00_FF00),
            "bits 31 to 24 and 15 to 8, less J"
        );
        core.spsr_write_by_instr(0b10110, 0b0001);
        assert_eq!(core.state.spsr(), Some(0xFE00_FF00));
        core.spsr_write_by_instr(Mode::Fiq as u32, 0b0001);
        assert_eq!(core.state.spsr(), Some(0xFE00_FF00 | Mode::Fiq as u32));
        core.cpsr_write_by_instr(Mode::System as u32, 0b0001, false);
        core.spsr_write_by_instr(u32::MAX, 0b1111);
        assert_eq!(core.state.spsr(), None);
    }

    /// A block that lowers one ARM instruction at `0x100` with `lower` and leaves, its exits able
    /// to chain where they may, finished for a block whose byte order and privilege `context`
    /// gives, run once on `core`. Answers what it answered.
    fn exit_by(
        core: &mut Family,
        context: u64,
        lower: impl FnOnce(&mut Emitter<'_, '_, Family>),
    ) -> u32 {
        let recent = Place::At(core.blocks.recent());
        helpers::run_built(core, |builder, pointer, signature| {
            let pointer = builder.func.dfg.value_type(pointer);
            let features = Features {
                dsp: true,
                fpu: Fpu::None,
                endian: Endian::Big,
                shortcuts: true,
            };
            let signature = builder.import_signature(signature.clone());
            let mut cells = |_: u32, _: u32| Place::At(0);
            let mut e = Emitter::new(builder, pointer, features, InstructionSet::Arm);
            e.chain = Some(Chain {
                cells: &mut cells,
                signature,
                recent,
                space: 0,
            });
            e.begin(0, 0x100, 4, 0);
            lower(&mut e);
            Family::finish(&mut e, context);
        })
    }

    /// B1.8.10: an exception return leaves its block, which never chains, and the run loop then
    /// restores the PSR, its `ITSTATE`, `T` and mode with the mode's banked registers among it,
    /// and aligns the PC to the instruction set it returns to.
    #[test]
    fn an_exception_return_restores_the_psr_once_its_block_has_left() {
        let thumb = mask(cpsr::T) | mask(cpsr::IT_1_0) | mask(cpsr::C) | Mode::User as u32;
        for (psr, pc) in [(thumb, 0x2002), (Mode::Abort as u32, 0x2000)] {
            let mut core = Family::new(ties(Endian::Big)).unwrap();
            core.state.r[13] = 0x5000;
            let answer = exit_by(&mut core, 0, |e| {
                let address = e.constant(0x2003);
                let psr = e.constant(psr);
                Family::exception_return(e, address, psr);
            });
            assert_eq!(
                answer,
                1 << 8 | status::EXCEPTION_RETURN,
                "retired one, unchained"
            );
            let state = &core.state;
            assert_eq!(
                (state.it, state.mode(), state.r[15]),
                (0, Mode::Supervisor, 0x2003)
            );
            core.finish_exception_return();
            let state = &core.state;
            assert_eq!(state.cpsr(), psr, "{psr:#x}");
            assert_eq!((state.r[13], state.r[15]), (0, pc), "{psr:#x}");
        }
    }

    /// `finish` finds the next block of a computed exit by the key `block_key` gives the state the
    /// exit leaves: its address and `ITSTATE`, its instruction set from `CPSR.T`, and the block's
    /// byte order and privilege. An exit from a block of another byte order finds nothing.
    #[test]
    fn a_computed_exit_finds_the_block_keyed_for_the_state_it_leaves() {
        const FOUND: u32 = 0x77;
        let mut core = Family::new(ties(Endian::Big)).unwrap();
        let found = core
            .jit
            .compile(Tier::Best, |builder, _, _| {
                let answer = builder.ins().iconst(types::I32, i64::from(FOUND));
                builder.ins().return_(&[answer]);
            })
            .unwrap();
        let start = Start {
            pc: 0x3000,
            it: 0,
            longest: LONGEST_BLOCK,
            instruction_set: InstructionSet::Thumb,
            endian: Endian::Big,
            privileged: true,
            mpu: false,
            fpu: Fpu::VfpV3D16,
        };
        core.blocks.insert(block_key(start), 0x3000, 0x3001, found);
        let little = Start {
            endian: Endian::Little,
            ..start
        };
        for (context, answer) in [(start.context(), FOUND), (little.context(), status::NEXT)] {
            let answered = exit_by(&mut core, context, |e| {
                let to = e.constant(0x3001);
                Family::branch_exchange(e, to);
            });
            assert_eq!(answered & 0xFF, answer, "{context:#x}");
            assert_eq!(core.state.t, 1);
        }
    }
}
