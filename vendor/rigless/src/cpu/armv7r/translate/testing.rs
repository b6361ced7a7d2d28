// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! A processor with code and RAM mapped and a bus that records what reaches it, on a part whose
//! instructions and data are in either byte order, for the tests of the core and of every class of
//! encodings.
//!
//! A fuzz build runs code on the bench too, and uses no more of it than a restart and a run.
#![expect(
    unsafe_code,
    reason = "the core keeps pointers into the bench's memory"
)]
#![cfg_attr(
    not(test),
    allow(
        dead_code,
        reason = "a fuzz build uses the bench's restart and run and nothing else of it"
    )
)]

use super::super::exception::Exception;
use super::super::exception::Faults;
use std::num::NonZeroU8;

use super::super::family::{Family, MpuRegions, Options, PortRegion, Raised, Refused, Ties};
use super::super::registers::{cpsr, fsr};
use crate::cpu::armv7::registers::{get, is_set, mask};
use crate::cpu::armv7::translate::float::Fpu;
use crate::cpu::armv7m::testing::Recorder;
use crate::emulator::memory::{Mapped, Memory};
use crate::emulator::{Exit, Processor};
use crate::soc::{Endian, Region, Width};

/// Where [`Bench`] maps its code.
pub(crate) const CODE: u32 = 0x0000_0000;
/// Where it maps its RAM.
pub(crate) const RAM: u32 = 0x2000_0000;
/// The bytes of each.
pub(crate) const SIZE: usize = 0x1_0000;
/// Where it has a region smaller than a page, which the core leaves to the bus.
pub(crate) const SMALL: u32 = 0x3000_0000;
/// An address nothing maps, so every access there reaches the bus.
pub(crate) const DEVICE: u32 = 0x4000_0000;
/// Where the bench's vectors are, high, B1.8.1, each a branch to itself, so a test finds the
/// core waiting at the vector of the exception it took.
pub(crate) const VECTORS: u32 = 0xFFFF_0000;
/// What a run retires at a vector after an exception: the branch to itself the core then waits in.
pub(crate) const SPUN: u64 = 1;
/// The bytes the vectors' page holds.
const VECTORS_SIZE: u64 = 0x400;
/// `B .` in ARM state, A8.8.18 encoding A1.
pub(crate) const SPIN: u32 = 0xEAFF_FFFE;
/// `FSR[10, 3:0]` for an alignment fault and a synchronous external abort, DDI 0460D Table 4-28.
const ALIGNMENT: u32 = 0b0_0001;
const SYNCHRONOUS_EXTERNAL: u32 = 0b0_1000;
/// A Background fault and a Permission fault, Table B5-8.
const BACKGROUND: u32 = 0b0_0000;
const PERMISSION: u32 = 0b0_1101;
/// The exceptions with a vector, by their order in the table.
const EXCEPTIONS: [Exception; 6] = [
    Exception::Undefined,
    Exception::SupervisorCall,
    Exception::PrefetchAbort,
    Exception::DataAbort,
    Exception::Irq,
    Exception::Fiq,
];

/// What a part ties low but its byte order, as a test that builds a core of its own takes it,
/// with build options no particular part need have: a 16 KB instruction cache and a 32 KB data
/// cache without ECC, 12 MPU regions, six breakpoints and four watchpoints, and no TCMs, lock-step,
/// AXI bus ECC or ACP. The AXI peripheral port's region is the top 64 MB.
pub(crate) fn ties(endian: Endian) -> Ties {
    Ties {
        endian,
        nmfi: false,
        thumb_exceptions: false,
        high_vectors: false,
        options: Options {
            instruction_cache_kb: 16,
            data_cache_kb: 32,
            mpu_regions: MpuRegions::Twelve,
            tcms: false,
            lock_step: false,
            breakpoints: NonZeroU8::new(6).expect("six"),
            watchpoints: NonZeroU8::new(4).expect("four"),
            cache_error_schemes: [0, 0],
            hard_error_cache: false,
            axi_bus_ecc: None,
            acp: false,
            axi_peripheral: PortRegion {
                base: 0xFC00_0000,
                size: 0b1_0001,
            },
            fpu: Fpu::VfpV3D16,
        },
    }
}

/// A processor with [`SIZE`] bytes of code at [`CODE`] and of RAM at [`RAM`], the stack at the
/// top of RAM, reset with its vectors at [`VECTORS`], and about to run code placed at the start of
/// code.
pub(crate) struct Bench {
    pub(crate) core: Box<Family>,
    pub(crate) bus: Recorder,
    memory: Mapped,
}

impl Bench {
    /// A processor on a part whose instructions and data are `endian`, about to run Thumb `code`,
    /// halfwords in the order they're fetched.
    pub(crate) fn thumb(endian: Endian, code: &[u16]) -> Self {
        let mut bench = Self::empty(endian);
        bench.place_thumb(CODE, code);
        bench.core.state.t = 1;
        bench
    }

    /// [`Bench::thumb`] for ARM `code`, words in the order they're fetched.
    pub(crate) fn arm(endian: Endian, code: &[u32]) -> Self {
        let mut bench = Self::empty(endian);
        bench.place_arm(CODE, code);
        bench
    }

    /// A processor on a part whose instructions and data are `endian`, with nothing placed.
    pub(crate) fn empty(endian: Endian) -> Self {
        Self::of(Ties {
            high_vectors: true,
            ..ties(endian)
        })
    }

    /// [`Bench::empty`] on a part that ties the core's inputs to `ties`.
    pub(crate) fn of(ties: Ties) -> Self {
        let endian = ties.endian;
        let mut core = Family::new(ties).expect("a processor");
        let memory = Memory::new(
            &[
                Region::flash("code", u64::from(CODE), SIZE as u64),
                Region::ram("ram", u64::from(RAM), SIZE as u64),
                Region::ram("small", u64::from(SMALL), 0x200),
                Region::flash("vectors", u64::from(VECTORS), VECTORS_SIZE),
            ],
            &[],
            endian,
        );
        // SAFETY: the bench declares its core before its memory, so the memory outlives the core
        // and its `Drop`. The bench lends its memory only through `&self` methods called between
        // the core's own, so nothing borrows the bytes while a method of the core runs.
        unsafe {
            memory.map_into(&mut *core);
        }
        let mut bench = Self {
            core,
            bus: Recorder::default(),
            memory: Mapped::new(memory),
        };
        bench.core.state.r[13] = RAM + u32::try_from(SIZE).expect("a bench-sized region");
        bench.core.state.r[15] = CODE;
        for exception in EXCEPTIONS {
            bench.place_arm(VECTORS + exception.offset(), &[SPIN]);
        }
        bench
    }

    /// Starts the core over on `bytes` placed at the start of code as they are, in ARM state where
    /// `thumb` is false, reset, with code and RAM cleared first, which drops what was translated
    /// from them, and the code generator kept.
    #[cfg(fuzzing)]
    pub(crate) fn restart(&mut self, bytes: &[u8], thumb: bool) {
        self.core.reset();
        let zeros = vec![0; SIZE];
        self.write(CODE, &zeros);
        self.write(RAM, &zeros);
        self.write(CODE, &bytes[..bytes.len().min(SIZE)]);
        self.core.state.t = u32::from(thumb);
        self.core.state.r[13] = RAM + u32::try_from(SIZE).expect("a bench-sized region");
        self.core.state.r[15] = CODE;
        self.bus = Recorder::default();
    }

    /// Writes Thumb halfwords at `address`, each in the part's order, as a loader would.
    pub(crate) fn place_thumb(&mut self, address: u32, halfwords: &[u16]) {
        let endian = self.memory.endian();
        let bytes: Vec<u8> = halfwords
            .iter()
            .flat_map(|&halfword| match endian {
                Endian::Little => halfword.to_le_bytes(),
                Endian::Big => halfword.to_be_bytes(),
            })
            .collect();
        self.write(address, &bytes);
    }

    /// Writes ARM words at `address`, each in the part's order, as a loader would.
    pub(crate) fn place_arm(&mut self, address: u32, words: &[u32]) {
        let endian = self.memory.endian();
        let bytes: Vec<u8> = words
            .iter()
            .flat_map(|&word| match endian {
                Endian::Little => word.to_le_bytes(),
                Endian::Big => word.to_be_bytes(),
            })
            .collect();
        self.write(address, &bytes);
    }

    /// Writes bytes at `address`, in code or RAM, as a loader would.
    pub(crate) fn write(&mut self, address: u32, bytes: &[u8]) {
        assert!(
            self.memory.place(u64::from(address), bytes),
            "inside a region"
        );
        for range in self.memory.written() {
            self.core.invalidate(range.start, range.end);
        }
    }

    /// The byte at `address`, in code or RAM.
    pub(crate) fn byte(&self, address: u32) -> u8 {
        let byte = self
            .memory
            .read(u64::from(address), Width::W8)
            .expect("inside a region");
        u8::try_from(byte).expect("a byte")
    }

    /// The exception whose vector the core waits at in the mode it takes, or `None` anywhere
    /// else.
    pub(crate) fn taken(&self) -> Option<Exception> {
        let state = &self.core.state;
        EXCEPTIONS.into_iter().find(|exception| {
            state.r[15] == VECTORS + exception.offset() && state.mode() == exception.mode()
        })
    }

    /// The link and the SPSR of the mode `exception` is taken to.
    pub(crate) fn returns(&self, exception: Exception) -> (u32, u32) {
        let mut state = self.core.state.clone();
        state.set_mode(exception.mode());
        (state.r[14], state.spsr().expect("an exception mode's"))
    }

    /// The exception the core waits at the vector of, and the address of the instruction it was
    /// taken at, which its LR less Table B1-7's offset gives: the one that raised it, the `SVC`, or
    /// for an interrupt the one it would have run next.
    pub(crate) fn raised(&self) -> Option<(Exception, u32)> {
        let exception = self.taken()?;
        let (link, spsr) = self.returns(exception);
        let thumb = spsr & mask(cpsr::T) != 0;
        let offset = match exception {
            Exception::Undefined | Exception::SupervisorCall if thumb => 2,
            Exception::DataAbort => 8,
            _ => 4,
        };
        Some((exception, link.wrapping_sub(offset)))
    }

    /// The refused access a Data Abort the core waits at the vector of reports, by `DFSR` and
    /// `DFAR`, as the instruction raised it.
    pub(crate) fn aborted(&self) -> Option<Raised> {
        if self.taken()? != Exception::DataAbort {
            return None;
        }
        let Faults { dfsr, dfar, .. } = self.core.faults;
        let status = get(fsr::S, dfsr) << fsr::STATUS.width | get(fsr::STATUS, dfsr);
        let refused = match status {
            ALIGNMENT => Refused::Unaligned(dfar),
            SYNCHRONOUS_EXTERNAL => Refused::Bus(dfar),
            BACKGROUND => Refused::Background(dfar),
            PERMISSION => Refused::Permission(dfar),
            _ => return None,
        };
        Some(Raised::DataAbort {
            refused,
            write: is_set(fsr::RW, dfsr),
        })
    }

    /// R0 to R15 and the CPSR as they stood when the core took the exception it waits at: the
    /// CPSR from the SPSR, its mode's registers back in place, and R15 the instruction it was
    /// taken at.
    pub(crate) fn before_taken(&self) -> ([u32; 16], u32) {
        let (exception, at) = self.raised().expect("the core waits at a vector");
        let (_, spsr) = self.returns(exception);
        let mut state = self.core.state.clone();
        state.set_cpsr(spsr);
        state.r[15] = at;
        (state.r, state.cpsr())
    }

    /// Runs at most `instructions`, and answers why it stopped and how many it ran.
    pub(crate) fn run(&mut self, instructions: u32) -> (Exit, u64) {
        self.core.run(instructions, &mut self.bus)
    }
}
