// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The exception model, DDI 0406C B1.8 and B1.9, as the Cortex-R5 takes it, DDI 0460D 3.8.
//!
//! An instruction's fault leaves its block with the exception in `Family::raised`, and the run
//! loop takes it before anything else. Between blocks the loop wakes a core that waits once a
//! wake-up event comes, and takes an asynchronous abort, an FIQ or an IRQ its mask lets through.
//! Reset is `Processor::reset`, B1.9.1, and the return from an exception is the instructions'
//! `exception_return`, B1.8.10.

use serde::{Deserialize, Serialize};

use super::family::{Family, Raised, Refused};
use super::registers::{fpexc, fsr, sctlr};
use super::state::Mode;
use crate::cpu::armv7::registers::{get, is_set, set};
use crate::cpu::armv7::translate::Fault;

/// The core's interrupt input each line drives, DDI 0460D 3.8.3: nIRQ on line 0 and nFIQ on 1.
pub(crate) const IRQ: usize = 0;
pub(crate) const FIQ: usize = 1;

/// `State::sleeping` after a `WFI`, B1.8.14, and after a `WFE`, B1.8.13.
pub(crate) const FOR_INTERRUPT: u32 = 1;
pub(crate) const FOR_EVENT: u32 = 2;

/// The exception base address with `SCTLR.V` set, B1.8.1.
const HIGH_VECTORS: u32 = 0xFFFF_0000;

/// Where Table B5-2's default memory map starts Strongly-ordered memory.
const STRONGLY_ORDERED: u32 = 0xC000_0000;

/// An exception the R5 takes from its vector table, Table B1-3. Reset is `Processor::reset`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exception {
    Undefined,
    SupervisorCall,
    PrefetchAbort,
    DataAbort,
    Irq,
    Fiq,
}

impl Exception {
    /// Its offset in the vector table, Table B1-3.
    pub(crate) fn offset(self) -> u32 {
        match self {
            Self::Undefined => 0x04,
            Self::SupervisorCall => 0x08,
            Self::PrefetchAbort => 0x0C,
            Self::DataAbort => 0x10,
            Self::Irq => 0x18,
            Self::Fiq => 0x1C,
        }
    }

    /// The mode it's taken to, Table B1-4.
    pub(crate) fn mode(self) -> Mode {
        match self {
            Self::Undefined => Mode::Undefined,
            Self::SupervisorCall => Mode::Supervisor,
            Self::PrefetchAbort | Self::DataAbort => Mode::Abort,
            Self::Irq => Mode::Irq,
            Self::Fiq => Mode::Fiq,
        }
    }
}

/// A fault status, `FSR[10, 3:0]`, DDI 0460D Table 4-28.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Status {
    Background = 0b0_0000,
    Alignment = 0b0_0001,
    DebugEvent = 0b0_0010,
    SynchronousExternal = 0b0_1000,
    Permission = 0b0_1101,
    AsynchronousExternal = 0b1_0110,
    SynchronousParityEcc = 0b1_1001,
}

impl Status {
    /// What reports `refused`, Tables B5-7 and B5-8, and the address it carries.
    fn of(refused: Refused) -> (Self, u32) {
        match refused {
            Refused::Unaligned(address) => (Self::Alignment, address),
            Refused::Bus(address) => (Self::SynchronousExternal, address),
            Refused::Background(address) => (Self::Background, address),
            Refused::Permission(address) => (Self::Permission, address),
            Refused::Ecc(address) => (Self::SynchronousParityEcc, address),
        }
    }

    /// `DFSR` or `IFSR` reporting it, with `RW` set for a write. `SD` stays clear: the bus fails
    /// an access nothing answers, as AXI's decode error does, DDI 0460D Table 4-29.
    fn register(self, write: bool) -> u32 {
        let code = self as u32;
        let value = set(fsr::STATUS, 0, code);
        let value = set(fsr::S, value, code >> fsr::STATUS.width);
        set(fsr::RW, value, u32::from(write))
    }
}

/// The fault status and address registers, B5.5 and DDI 0460D 4.3.20, and an asynchronous abort
/// waiting for `A` to clear.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Faults {
    pub(crate) dfsr: u32,
    pub(crate) ifsr: u32,
    /// `ADFSR` and `AIFSR`, which only a parity or ECC error writes, DDI 0460D 4.3.20.
    pub(crate) adfsr: u32,
    pub(crate) aifsr: u32,
    pub(crate) dfar: u32,
    pub(crate) ifar: u32,
    /// An asynchronous external abort waits, DDI 0460D 3.8.4, which holds one of its kind.
    pub(crate) pending: bool,
}

/// `ADFSR` and `AIFSR` for an error the AXI master's bus ECC found: the cache or AXI master's side,
/// unrecoverable, DDI 0460D Tables 4-31 and 4-32.
const AXI_MASTER_UNRECOVERABLE: u32 = 0;

/// Whether a store the bus fails at `address` aborts asynchronously, DDI 0460D 8.3.1: a store
/// that isn't exclusive does to Normal and Device memory, and not to Strongly-ordered memory.
// ceiling: the type is Table B5-2's default map's, and an exclusive store's abort is a plain one's;
// upgrade when the MPU gives its regions their attributes
pub(crate) fn buffered(address: u32) -> bool {
    address < STRONGLY_ORDERED
}

impl Family {
    /// B1.8.1's `ExcVectorBase()`, by `SCTLR.V`.
    fn vector_base(&self) -> u32 {
        if is_set(sctlr::V, self.sctlr) {
            HIGH_VECTORS
        } else {
            0
        }
    }

    /// Takes `exception` with `link` in its mode's LR, as B1.9's pseudocode for each does: the
    /// CPSR to the new mode's SPSR, `I` set, `A` and `F` as Table B1-10 sets them, `ITSTATE`
    /// cleared, `T` from `SCTLR.TE` and `E` from `SCTLR.EE`, B1.8.5, and the next instruction at
    /// its vector. A core that waits wakes.
    fn enter(&mut self, exception: Exception, link: u32) {
        self.system.pmu.taken += 1;
        let spsr = self.state.cpsr();
        let vector = self.vector_base().wrapping_add(exception.offset());
        let control = self.sctlr;
        self.state.set_mode(exception.mode());
        self.state.set_spsr(spsr);
        let state = &mut self.state;
        state.r[14] = link;
        state.i = 1;
        if !matches!(exception, Exception::Undefined | Exception::SupervisorCall) {
            state.a = 1;
        }
        if exception == Exception::Fiq {
            state.f = 1;
        }
        state.it = 0;
        state.t = get(sctlr::TE, control);
        state.e = get(sctlr::EE, control);
        state.sleeping = 0;
        state.r[15] = vector;
    }

    /// Takes `raised`, an instruction's exception, with `r[15]` the instruction that raised it, or
    /// the one after an `SVC`. LR is that address plus Table B1-7's offset.
    ///
    /// - `UNDEFINED` encodings, a coprocessor refused and a divide by zero `SCTLR.DZ` traps are the
    ///   Undefined Instruction exception, B1.9.2. `FPEXC.DEX` says whether a floating-point
    ///   instruction on a short vector raised it, DDI 0460D Table 11-6.
    /// - `SVC` is the Supervisor Call exception, B1.9.4.
    /// - `BKPT` is a debug event, which C4.1 makes a Prefetch Abort with no halting debug. `IFSR`
    ///   says so and `IFAR` is left as it was, DDI 0460D Table 4-28.
    /// - A fetch nothing answers is a Prefetch Abort, B1.9.7, a synchronous external abort at the
    ///   halfword it couldn't read, B5.5.3.
    /// - A fetch the MPU refused is a Prefetch Abort, B1.9.7, with `IFSR` and `IFAR`, B5.5.3.
    /// - An access the core refused is a Data Abort, B1.9.8, with `DFSR` and `DFAR`, B5.5.2.
    /// - A fetch or a load of a word the bus ECC found uncorrectable is the same, a synchronous
    ///   parity or ECC error with `AIFSR` or `ADFSR` too, DDI 0460D Table 4-28 and 4.3.20.
    pub(crate) fn take_raised(&mut self, raised: Raised) {
        let pc = self.state.r[15];
        let thumb = self.state.t != 0;
        match raised {
            Raised::Fault(Fault::SupervisorCall) => self.enter(Exception::SupervisorCall, pc),
            Raised::Fault(Fault::Breakpoint) => {
                self.faults.ifsr = Status::DebugEvent.register(false);
                self.enter(Exception::PrefetchAbort, pc.wrapping_add(4));
            }
            Raised::Fault(Fault::InstructionFetch) => {
                self.faults.ifsr = Status::SynchronousExternal.register(false);
                self.faults.ifar = self.unfetchable(pc, thumb);
                self.enter(Exception::PrefetchAbort, pc.wrapping_add(4));
            }
            Raised::Fault(fault) => {
                let link = pc.wrapping_add(if thumb { 2 } else { 4 });
                self.enter(Exception::Undefined, link);
                let vector = u32::from(fault == Fault::Vector);
                self.state.fpexc = set(fpexc::DEX, self.state.fpexc, vector);
            }
            Raised::FetchRefused(refused) => {
                let (status, address) = Status::of(refused);
                self.faults.ifsr = status.register(false);
                self.faults.ifar = address;
                if status == Status::SynchronousParityEcc {
                    self.faults.aifsr = AXI_MASTER_UNRECOVERABLE;
                }
                self.enter(Exception::PrefetchAbort, pc.wrapping_add(4));
            }
            Raised::DataAbort { refused, write } => {
                let (status, address) = Status::of(refused);
                self.faults.dfsr = status.register(write);
                self.faults.dfar = address;
                if status == Status::SynchronousParityEcc {
                    self.faults.adfsr = AXI_MASTER_UNRECOVERABLE;
                }
                self.enter(Exception::DataAbort, pc.wrapping_add(8));
            }
        }
    }

    /// Takes the asynchronous exception the masks let through, if one waits, B1.8.6: an abort
    /// while `A` is clear, then an FIQ while `F` is, then an IRQ while `I` is. B1.8.2 leaves their
    /// order to the implementation, and DDI 0460D's Figure 3-5 puts an FIQ before an IRQ. Each
    /// returns to `r[15]`, the next instruction, B1.9.8, B1.9.10 and B1.9.12.
    ///
    /// An IRQ with `SCTLR.VE` set takes its handler's address over the VIC port, DDI 0460D 3.8.3.
    /// Where the part's controller supplies none, the core takes the vector table's, the simplest
    /// of the branches B1.9.10 leaves to the implementation. Answers whether it took one.
    pub(crate) fn take_asynchronous(&mut self) -> bool {
        let next = self.state.r[15];
        if self.faults.pending && self.state.a == 0 {
            self.faults.pending = false;
            self.faults.dfsr = Status::AsynchronousExternal.register(true);
            self.enter(Exception::DataAbort, next.wrapping_add(8));
        } else if self.interrupts[FIQ] && self.state.f == 0 {
            self.enter(Exception::Fiq, next.wrapping_add(4));
        } else if self.interrupts[IRQ] && self.state.i == 0 {
            self.enter(Exception::Irq, next.wrapping_add(4));
            if is_set(sctlr::VE, self.sctlr)
                && let Some(handler) = self.acknowledge_irq()
            {
                self.state.r[15] = handler;
            }
        } else {
            return false;
        }
        true
    }

    /// Waits for an interrupt, or for an event with `event`, B1.8.14 and B1.8.13. A `WFE` with the
    /// event register set clears it and goes on, and a wait something would end already doesn't
    /// start.
    pub(crate) fn sleep(&mut self, event: bool) {
        if event && std::mem::take(&mut self.state.event) != 0 {
            return;
        }
        let sleeping = if event { FOR_EVENT } else { FOR_INTERRUPT };
        if !self.woken(sleeping) {
            self.state.sleeping = sleeping;
        }
    }

    /// Ends a wait a wake-up event has come for.
    pub(crate) fn wake(&mut self) {
        if self.state.sleeping != 0 && self.woken(self.state.sleeping) {
            self.state.sleeping = 0;
        }
    }

    /// Whether a wait of `sleeping`'s kind has a wake-up event: for `WFI` an interrupt asserted
    /// or an abort waiting whatever the masks, B1.8.14, and for `WFE` one its mask lets through or
    /// the event register, B1.8.13.
    fn woken(&self, sleeping: u32) -> bool {
        let state = &self.state;
        let waiting = [
            (self.faults.pending, state.a),
            (self.interrupts[IRQ], state.i),
            (self.interrupts[FIQ], state.f),
        ];
        if sleeping == FOR_INTERRUPT {
            return waiting.iter().any(|&(waits, _)| waits);
        }
        state.event != 0 || waiting.iter().any(|&(waits, masked)| waits && masked == 0)
    }
}

#[cfg(test)]
mod tests {
    use super::super::family::Ties;
    use super::super::registers::cpsr;
    use super::super::state::State;
    use super::super::translate::testing::{Bench, CODE, DEVICE, RAM, VECTORS, ties};
    use super::*;
    use crate::cpu::armv7::registers::mask;
    use crate::device::Level;
    use crate::emulator::{Exit, InterruptLine, Processor, Queued};
    use crate::soc::Endian;

    const BOTH: [Endian; 2] = [Endian::Little, Endian::Big];
    /// Where the tests' handlers are, each a branch away from its vector.
    const HANDLERS: u32 = VECTORS + 0x100;
    /// The bytes each handler may take.
    const HANDLER_BYTES: u32 = 0x10;

    const MOV_R7_LR: u32 = 0xE1A0_700E;
    const MRS_R6_SPSR: u32 = 0xE14F_6000;
    const MOVS_PC_LR: u32 = 0xE1B0_F00E;
    const SUBS_PC_LR_4: u32 = 0xE25E_F004;
    const SUBS_PC_LR_6: u32 = 0xE25E_F006;
    const MOVS_PC_R10: u32 = 0xE1B0_F00A;
    /// `STR r0, [r4]`, which a test's bus answers by lowering a line, as a handler clears its
    /// source.
    const STR_R0_R4: u32 = 0xE584_0000;
    const CPSIE_I: u32 = 0xF108_0080;
    const CPSIE_A: u32 = 0xF108_0100;
    /// `MOV r5, #1` and `MOVS r5, #1`, which mark the code an exception returned to.
    const MARK: u32 = 0xE3A0_5001;
    const MARK_THUMB: u16 = 0x2501;
    const UDF: u32 = 0xE7F0_00F0;
    const UDF_THUMB: u16 = 0xDE00;
    const WFI: u32 = 0xE320_F003;
    const WFE: u32 = 0xE320_F002;
    const SEV: u32 = 0xE320_F004;

    fn line(input: usize) -> InterruptLine {
        InterruptLine::new(u16::try_from(input).unwrap()).unwrap()
    }

    /// `B` from `from` to `to`, A8.8.18 encoding A1.
    fn branch(from: u32, to: u32) -> u32 {
        0xEA00_0000 | to.wrapping_sub(from).wrapping_sub(8) >> 2 & 0x00FF_FFFF
    }

    /// Places `code` as `exception`'s handler, with a branch to it at its vector.
    fn handle(bench: &mut Bench, exception: Exception, code: &[u32]) {
        let vector = VECTORS + exception.offset();
        let at = HANDLERS + exception.offset() / 4 * HANDLER_BYTES;
        bench.place_arm(at, code);
        bench.place_arm(vector, &[branch(vector, at)]);
    }

    /// The address of `exception`'s handler's `index`-th instruction.
    fn in_handler(exception: Exception, index: u32) -> u32 {
        HANDLERS + exception.offset() / 4 * HANDLER_BYTES + 4 * index
    }

    /// Runs `instructions` in stretches, as the runner does after each access that reaches the
    /// bus, every one retiring, and answers how the last stretch stopped.
    fn run_all(bench: &mut Bench, instructions: u64) -> Exit {
        let mut ran = 0;
        loop {
            let (exit, more) = bench.run(u32::try_from(instructions - ran).unwrap());
            ran += more;
            if exit != Exit::Returned || ran == instructions {
                assert_eq!(ran, instructions, "{exit:?}");
                return exit;
            }
        }
    }

    /// User mode with every mask clear, from which every exception can be taken.
    fn unmasked(state: &mut State) {
        state.set_mode(Mode::User);
        (state.a, state.i, state.f) = (0, 0, 0);
    }

    /// One exception taken from User mode and returned from, in one instruction set state: the
    /// code, the handler, the instructions retired by the time the mark has run, the branch at the
    /// vector among them, and the link the handler finds.
    struct Taken {
        exception: Exception,
        code: Code,
        handler: [u32; 3],
        retired: u64,
        link: u32,
    }

    enum Code {
        Arm([u32; 2]),
        Thumb([u16; 2]),
    }

    /// The cases of [`every_exception_is_taken_and_returned_from_in_each_state`].
    fn cases() -> Vec<Taken> {
        let copied = |back| [MOV_R7_LR, MRS_R6_SPSR, back];
        // An interrupt's handler clears its source with a store before it returns.
        let cleared = [MOV_R7_LR, STR_R0_R4, SUBS_PC_LR_4];
        let arm = |faulting| Code::Arm([faulting, MARK]);
        let thumb = |faulting| Code::Thumb([faulting, MARK_THUMB]);
        let case = |exception, code, handler, retired, link| Taken {
            exception,
            code,
            handler,
            retired,
            link,
        };
        vec![
            case(Exception::Undefined, arm(UDF), copied(MOVS_PC_LR), 5, 4),
            case(
                Exception::Undefined,
                thumb(UDF_THUMB),
                copied(MOVS_PC_LR),
                5,
                2,
            ),
            case(
                Exception::SupervisorCall,
                arm(0xEF00_0042),
                copied(MOVS_PC_LR),
                6,
                4,
            ),
            // BKPT, whose Prefetch Abort the handler returns past.
            case(
                Exception::PrefetchAbort,
                arm(0xE120_0070),
                copied(MOVS_PC_LR),
                5,
                4,
            ),
            // BX r9 to an address nothing maps, back to the mark through R10.
            case(
                Exception::PrefetchAbort,
                arm(0xE12F_FF19),
                copied(MOVS_PC_R10),
                6,
                DEVICE + 4,
            ),
            case(
                Exception::PrefetchAbort,
                thumb(0x4748),
                copied(MOVS_PC_R10),
                6,
                DEVICE + 4,
            ),
            // LDR r0, [r4], which the bus fails.
            case(
                Exception::DataAbort,
                arm(0xE594_0000),
                copied(SUBS_PC_LR_4),
                5,
                8,
            ),
            case(
                Exception::DataAbort,
                thumb(0x6820),
                copied(SUBS_PC_LR_6),
                5,
                8,
            ),
            case(Exception::Irq, arm(MARK), cleared, 5, 4),
            case(Exception::Irq, thumb(MARK_THUMB), cleared, 5, 4),
            case(Exception::Fiq, arm(MARK), cleared, 5, 4),
            case(Exception::Fiq, thumb(MARK_THUMB), cleared, 5, 4),
        ]
    }

    /// B1.9.2 to B1.9.12: each exception taken from User mode in ARM state and in Thumb state, on
    /// a part of each byte order, enters its handler in its mode with the link Table B1-7 gives
    /// and the CPSR in its SPSR, and the handler's return puts back the CPSR and runs the code
    /// after the exception. An interrupt is taken before the instruction it found.
    #[test]
    fn every_exception_is_taken_and_returned_from_in_each_state() {
        for case in cases() {
            for endian in BOTH {
                let (mut bench, mark) = match case.code {
                    Code::Arm(code) => (Bench::arm(endian, &code), CODE + 4),
                    Code::Thumb(code) => (Bench::thumb(endian, &code), CODE + 2),
                };
                handle(&mut bench, case.exception, &case.handler);
                let state = &mut bench.core.state;
                unmasked(state);
                state.r[4] = DEVICE;
                state.r[9] = DEVICE | state.t;
                state.r[10] = mark | state.t;
                let before = state.cpsr();
                let input = match case.exception {
                    Exception::DataAbort => {
                        bench.bus.fails_from = Some(u64::from(DEVICE));
                        None
                    }
                    Exception::Irq => Some(IRQ),
                    Exception::Fiq => Some(FIQ),
                    _ => None,
                };
                if let Some(input) = input {
                    bench.core.interrupts[input] = true;
                    bench.bus.on_access = vec![Queued::Line(line(input), Level::Low)];
                }
                let name = format!("{:?} {endian:?} {before:#x}", case.exception);
                // An interrupt comes in before the code's first instruction, its mark.
                let mark = if input.is_some() { CODE } else { mark };
                run_all(&mut bench, case.retired);
                let state = &bench.core.state;
                assert_eq!(state.r[7], case.link, "{name}: the link");
                if input.is_none() {
                    assert_eq!(state.r[6], before, "{name}: the SPSR");
                }
                assert_eq!(
                    (state.r[5], state.cpsr(), state.r[15]),
                    (1, before, mark + if state.t == 0 { 4 } else { 2 }),
                    "{name}: back past the mark"
                );
            }
        }
    }

    /// B1.8.1: the vectors are at 0 with `SCTLR.V` clear and at 0xFFFF0000 with it set.
    #[test]
    fn the_vectors_are_low_or_high_by_sctlr_v() {
        for (high, base) in [(false, 0), (true, VECTORS)] {
            let ties = Ties {
                high_vectors: high,
                ..ties(Endian::Little)
            };
            let mut core = Family::new(ties).unwrap();
            core.take_raised(Raised::Fault(Fault::Undefined));
            assert_eq!(core.state.r[15], base + 4, "{high}");
        }
    }

    /// B1.8.5 and Table B1-10: entry sets `I`, sets `A` for every exception but the Undefined
    /// Instruction and the Supervisor Call, and `F` for an FIQ, clears `ITSTATE`, and takes `T`
    /// from `SCTLR.TE` and `E` from `SCTLR.EE`. The SPSR keeps what the CPSR was.
    #[test]
    fn entry_sets_the_cpsr_table_b1_10_gives() {
        let raised = [
            (
                Raised::Fault(Fault::Undefined),
                Exception::Undefined,
                (0, 1, 0),
            ),
            (
                Raised::Fault(Fault::SupervisorCall),
                Exception::SupervisorCall,
                (0, 1, 0),
            ),
            (
                Raised::Fault(Fault::Breakpoint),
                Exception::PrefetchAbort,
                (1, 1, 0),
            ),
        ];
        let asynchronous = [
            (Exception::DataAbort, (1, 1, 0)),
            (Exception::Irq, (1, 1, 0)),
            (Exception::Fiq, (1, 1, 1)),
        ];
        for (te, ee) in [(0, 0), (1, 1), (1, 0)] {
            let core = || {
                let mut core = Family::new(ties(Endian::Little)).unwrap();
                core.sctlr = set(sctlr::EE, set(sctlr::TE, core.sctlr, te), ee);
                unmasked(&mut core.state);
                (core.state.it, core.state.t, core.state.e) = (0b0100_1100, 1, 1 - ee);
                core
            };
            let entered = |core: &Family, exception: Exception| {
                let state = &core.state;
                assert_eq!(state.mode(), exception.mode(), "{exception:?}");
                assert_eq!(
                    (state.it, state.t, state.e),
                    (0, te, ee),
                    "{exception:?} TE {te} EE {ee}"
                );
                assert_eq!(state.spsr().map(|spsr| spsr & 0x1F), Some(0b10000));
                (state.a, state.i, state.f)
            };
            for (raised, exception, masks) in raised {
                let mut core = core();
                core.take_raised(raised);
                assert_eq!(entered(&core, exception), masks, "{exception:?}");
            }
            for (exception, masks) in asynchronous {
                let mut core = core();
                match exception {
                    Exception::DataAbort => core.faults.pending = true,
                    Exception::Irq => core.interrupts[IRQ] = true,
                    _ => core.interrupts[FIQ] = true,
                }
                assert!(core.take_asynchronous());
                assert_eq!(entered(&core, exception), masks, "{exception:?}");
            }
        }
    }

    /// B1.8.6: each mask keeps its exception out, and with several waiting an abort goes first,
    /// then an FIQ, then an IRQ. With `SCTLR.NMFI` set, an FIQ's entry still sets `F`.
    #[test]
    fn each_mask_keeps_its_exception_out_and_the_rest_come_in_order() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        core.faults.pending = true;
        core.interrupts = [true, true];
        assert!(!core.take_asynchronous(), "reset masks every one");
        unmasked(&mut core.state);
        for expected in [Mode::Abort, Mode::Fiq] {
            assert!(core.take_asynchronous());
            assert_eq!(core.state.mode(), expected);
            core.state.set_mode(Mode::User);
            (core.state.a, core.state.i, core.state.f) = (0, 0, 0);
        }
        core.state.f = 1;
        assert!(core.take_asynchronous());
        assert_eq!(core.state.mode(), Mode::Irq);
        assert!(!core.take_asynchronous(), "the IRQ's entry set I");
        let mut core = Family::new(Ties {
            nmfi: true,
            ..ties(Endian::Little)
        })
        .unwrap();
        unmasked(&mut core.state);
        core.interrupts[FIQ] = true;
        assert!(core.take_asynchronous());
        assert_eq!(core.state.f, 1, "B1.9.12 sets F whatever NMFI");
    }

    /// B1.9.10 and B1.9.12 nested: an FIQ preempts an IRQ's handler, and an IRQ comes into an FIQ
    /// handler that clears `I`. Each returns to the handler it preempted, and that one to the
    /// code.
    #[test]
    fn an_irq_and_an_fiq_nest_in_each_others_handlers() {
        // An FIQ raised by the IRQ handler's store, which comes in before the handler's next
        // instruction.
        let mut bench = Bench::arm(Endian::Big, &[MARK]);
        handle(&mut bench, Exception::Irq, &[STR_R0_R4, SUBS_PC_LR_4]);
        let fiq = [MOV_R7_LR, MRS_R6_SPSR, STR_R0_R4, SUBS_PC_LR_4];
        handle(&mut bench, Exception::Fiq, &fiq);
        unmasked(&mut bench.core.state);
        bench.core.state.r[4] = DEVICE;
        bench.core.interrupts[IRQ] = true;
        bench.bus.on_access = vec![
            Queued::Line(line(IRQ), Level::Low),
            Queued::Line(line(FIQ), Level::High),
        ];
        assert_eq!(bench.run(8), (Exit::Returned, 2), "the IRQ handler's store");
        bench.bus.on_access = vec![Queued::Line(line(FIQ), Level::Low)];
        run_all(&mut bench, 7);
        let state = &bench.core.state;
        assert_eq!(state.r[7], in_handler(Exception::Irq, 1) + 4);
        assert_eq!(state.r[6] & 0x1F, Mode::Irq as u32);
        assert_eq!((state.r[5], state.mode(), state.r[15]), (1, Mode::User, 4));
        // An IRQ already asserted, which the FIQ handler lets in by clearing `I`.
        let mut bench = Bench::arm(Endian::Little, &[MARK]);
        let fiq = [STR_R0_R4, CPSIE_I, SUBS_PC_LR_4];
        handle(&mut bench, Exception::Fiq, &fiq);
        let irq = [MOV_R7_LR, MRS_R6_SPSR, STR_R0_R4, SUBS_PC_LR_4];
        handle(&mut bench, Exception::Irq, &irq);
        unmasked(&mut bench.core.state);
        bench.core.state.r[4] = DEVICE;
        bench.core.interrupts = [true, true];
        bench.bus.on_access = vec![Queued::Line(line(FIQ), Level::Low)];
        assert_eq!(bench.run(8), (Exit::Returned, 2), "the FIQ handler's store");
        bench.bus.on_access = vec![Queued::Line(line(IRQ), Level::Low)];
        run_all(&mut bench, 8);
        let state = &bench.core.state;
        assert_eq!(state.r[7], in_handler(Exception::Fiq, 2) + 4);
        assert_eq!(state.r[6] & 0x1F, Mode::Fiq as u32);
        assert_eq!((state.r[5], state.mode(), state.r[15]), (1, Mode::User, 4));
    }

    /// B1.8.10: every way back from an IRQ, `SUBS PC, LR`, `MOVS PC, LR`, `LDM` with the PC and
    /// `^`, and `SRS` with `RFE`, onto the IRQ stack and onto Supervisor mode's, puts back the
    /// CPSR and returns. An `RFE` to a mode `BadMode()` refuses, which B9.1.2 makes
    /// UNPREDICTABLE, restores the rest and leaves the mode as it was, B1.3.3.
    #[test]
    fn every_return_form_restores_the_cpsr_and_returns() {
        const SUB_LR_4: u32 = 0xE24E_E004;
        let forms: [&[u32]; 5] = [
            &[SUBS_PC_LR_4],
            &[SUB_LR_4, MOVS_PC_LR],
            &[SUB_LR_4, 0xE92D_4000, 0xE8FD_8000], // STMFD sp!, {lr}; LDMFD sp!, {pc}^
            &[SUB_LR_4, 0xF96D_0512, 0xF8BD_0A00], // SRSDB sp!, #IRQ; RFEIA sp!
            &[SUB_LR_4, 0xF96D_0513, 0xF102_0013, 0xF8BD_0A00], // SRSDB to SVC; CPS #SVC; RFEIA
        ];
        for handler in forms {
            for endian in BOTH {
                let mut bench = Bench::arm(endian, &[MARK]);
                let mut code = vec![STR_R0_R4];
                code.extend_from_slice(handler);
                handle(&mut bench, Exception::Irq, &code);
                let state = &mut bench.core.state;
                state.set_mode(Mode::Supervisor);
                state.r[13] = RAM + 0x800;
                unmasked(state);
                (state.r[4], state.c, state.t) = (DEVICE, 1, 0);
                state.set_mode(Mode::Irq);
                state.r[13] = RAM + 0x400;
                state.set_mode(Mode::User);
                let before = state.cpsr();
                bench.core.interrupts[IRQ] = true;
                bench.bus.on_access = vec![Queued::Line(line(IRQ), Level::Low)];
                run_all(&mut bench, code.len() as u64 + 2);
                let state = &bench.core.state;
                assert_eq!(
                    (state.cpsr(), state.r[5], state.r[15]),
                    (before, 1, 4),
                    "{handler:08x?} {endian:?}"
                );
            }
        }
        // RFEIA sp! from a stack whose PSR has Monitor mode's bits and N set.
        let mut bench = Bench::arm(Endian::Little, &[MARK]);
        handle(&mut bench, Exception::Irq, &[STR_R0_R4, 0xF8BD_0A00]);
        let stack = RAM + 0x400;
        let psr = mask(cpsr::N) | 0b10110;
        bench.place_arm(stack, &[CODE, psr]);
        unmasked(&mut bench.core.state);
        bench.core.state.set_mode(Mode::Irq);
        bench.core.state.r[13] = stack;
        bench.core.state.set_mode(Mode::User);
        bench.core.state.r[4] = DEVICE;
        bench.core.interrupts[IRQ] = true;
        bench.bus.on_access = vec![Queued::Line(line(IRQ), Level::Low)];
        run_all(&mut bench, 4);
        let state = &bench.core.state;
        assert_eq!(
            (state.mode(), state.n, state.i, state.r[5], state.r[15]),
            (Mode::Irq, 1, 0, 1, 4),
            "the mode stays as it was, and the rest is restored"
        );
    }

    /// B1.9.8: an `RFE` or an `LDM` return whose load faults takes the Data Abort in the handler,
    /// with the return not made: the SPSR it saves is the handler's own CPSR.
    #[test]
    fn a_fault_during_a_return_is_taken_in_the_handler() {
        for ret in [0xF8BD_0A00, 0xE8FD_8000] {
            // RFEIA sp! and LDMFD sp!, {pc}^ from a stack the bus fails.
            let mut bench = Bench::arm(Endian::Big, &[MARK]);
            handle(&mut bench, Exception::Irq, &[ret]);
            unmasked(&mut bench.core.state);
            bench.core.state.set_mode(Mode::Irq);
            bench.core.state.r[13] = DEVICE;
            bench.core.state.set_mode(Mode::User);
            bench.core.interrupts[IRQ] = true;
            bench.bus.fails_from = Some(u64::from(DEVICE));
            assert_eq!(bench.run(4), (Exit::Returned, 1), "{ret:#010x}: the branch");
            let (link, spsr) = bench.returns(Exception::DataAbort);
            assert_eq!(bench.taken(), Some(Exception::DataAbort), "{ret:#010x}");
            assert_eq!(
                (link, spsr & 0x1F),
                (in_handler(Exception::Irq, 0) + 8, Mode::Irq as u32),
                "{ret:#010x}"
            );
        }
    }

    /// DDI 0460D 3.8.3: with `SCTLR.VE` set, an IRQ takes its handler's address from the part's
    /// interrupt controller, whose answer reaches the core's lines before the handler runs, and
    /// with none supplied takes the vector table's. An FIQ never asks.
    #[test]
    fn an_irq_takes_its_handler_from_the_vic_port_with_sctlr_ve() {
        const HANDLER: u32 = CODE + 0x200;
        let mut bench = Bench::arm(Endian::Little, &[MARK, MARK]);
        bench.place_arm(HANDLER, &[MOV_R7_LR, SUBS_PC_LR_4]);
        bench.core.sctlr |= mask(sctlr::VE);
        unmasked(&mut bench.core.state);
        bench.core.interrupts[IRQ] = true;
        bench.bus.vector = Some(u64::from(HANDLER));
        bench.bus.on_acknowledge = vec![Queued::Line(line(IRQ), Level::Low)];
        assert_eq!(bench.run(1), (Exit::Budget, 1));
        assert_eq!(bench.bus.acknowledged, [(line(IRQ), 0)]);
        assert_eq!(
            (bench.core.state.r[15], bench.core.state.r[7]),
            (HANDLER + 4, 4)
        );
        assert!(
            !bench.core.interrupts[IRQ],
            "lowered before the handler ran"
        );
        run_all(&mut bench, 2);
        assert_eq!(
            (bench.core.state.mode(), bench.core.state.r[15]),
            (Mode::User, 4)
        );
        // No address supplied, and an FIQ, take the table's.
        for (input, exception) in [(IRQ, Exception::Irq), (FIQ, Exception::Fiq)] {
            let mut bench = Bench::arm(Endian::Little, &[MARK]);
            bench.core.sctlr |= mask(sctlr::VE);
            unmasked(&mut bench.core.state);
            bench.core.interrupts[input] = true;
            bench.run(1);
            assert_eq!(bench.taken(), Some(exception));
            let asked = usize::from(input == IRQ);
            assert_eq!(bench.bus.acknowledged.len(), asked, "{exception:?}");
        }
    }

    /// A handshake that asks for the runner, as one that moves the run's next deadline earlier
    /// does, returns before the handler's first instruction.
    #[test]
    fn a_handshake_that_asks_for_the_runner_returns_before_the_handler() {
        let mut bench = Bench::arm(Endian::Little, &[MARK]);
        bench.core.sctlr |= mask(sctlr::VE);
        unmasked(&mut bench.core.state);
        bench.core.interrupts[IRQ] = true;
        bench.bus.vector = Some(u64::from(CODE + 0x200));
        bench.bus.on_acknowledge = vec![Queued::Return];
        assert_eq!(bench.run(4), (Exit::Returned, 0));
        assert_eq!(bench.core.state.r[15], CODE + 0x200);
    }

    /// B1.8.14: `WFI` waits until an interrupt is asserted, which wakes it masked or not, and only
    /// an unmasked one is taken. A branch to itself waits the same way.
    #[test]
    fn wfi_waits_for_an_interrupt_whatever_its_mask() {
        for wait in [WFI, 0xEAFF_FFFE] {
            let mut bench = Bench::arm(Endian::Little, &[wait, MARK]);
            assert_eq!(bench.run(4), (Exit::Waiting, 1), "{wait:#010x}");
            assert!(bench.core.waiting());
            assert_eq!(bench.run(4), (Exit::Waiting, 0), "still");
            bench.core.ask(Queued::Line(line(IRQ), Level::High));
            bench.run(1);
            assert!(
                !bench.core.waiting(),
                "{wait:#010x}: I is set, and it wakes"
            );
            assert_eq!(bench.taken(), None);
        }
        let mut bench = Bench::arm(Endian::Little, &[WFI, MARK]);
        unmasked(&mut bench.core.state);
        assert_eq!(bench.run(4), (Exit::Waiting, 1));
        bench.core.ask(Queued::Line(line(FIQ), Level::High));
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::Fiq, 4)));
    }

    /// B1.8.13: `WFE` with the event register set clears it and goes on, `SEV` sets it, and an
    /// exception return sets it. With it clear the core waits for an interrupt its mask lets
    /// through, and a masked one leaves it waiting.
    #[test]
    fn wfe_waits_for_an_event_or_an_unmasked_interrupt() {
        let bench = |code: &[u32]| {
            let mut bench = Bench::arm(Endian::Little, code);
            bench.core.state.event = 0;
            bench
        };
        let mut sev = bench(&[SEV, WFE, MARK]);
        assert_eq!(sev.run(3), (Exit::Budget, 3));
        assert_eq!(sev.core.state.event, 0);
        let mut wfe = bench(&[WFE, MARK]);
        assert_eq!(wfe.run(4), (Exit::Waiting, 1));
        wfe.core.ask(Queued::Line(line(IRQ), Level::High));
        assert_eq!(wfe.run(4), (Exit::Waiting, 0), "I masks it");
        wfe.core.state.i = 0;
        wfe.run(1);
        assert_eq!(wfe.raised(), Some((Exception::Irq, 4)));
        let mut returned = bench(&[SUBS_PC_LR_4, WFE, MARK]);
        returned.core.state.r[14] = 8;
        assert!(
            returned
                .core
                .state
                .set_spsr(Mode::Supervisor as u32 | 0x1C0)
        );
        assert_eq!(
            returned.run(3),
            (Exit::Budget, 3),
            "the return set the event"
        );
    }

    /// DDI 0460D 8.3.1: a store the bus fails to Normal or Device memory retires, and its
    /// asynchronous abort waits for `A` to clear, B1.9.8, with `DFSR` saying so and the link the
    /// next instruction's plus 8. One to Strongly-ordered memory aborts on the store.
    #[test]
    fn a_failed_store_aborts_asynchronously_unless_strongly_ordered() {
        const ASYNCHRONOUS_WRITE: u32 = 0b1100_0000_0110;
        const SYNCHRONOUS_WRITE: u32 = 0b1000_0000_1000;
        let code = [STR_R0_R4, CPSIE_A, MARK];
        let mut bench = Bench::arm(Endian::Little, &code);
        bench.core.state.r[4] = DEVICE;
        bench.bus.fails_from = Some(u64::from(DEVICE));
        assert_eq!(bench.run(4), (Exit::Returned, 1));
        assert!(bench.core.faults.pending);
        assert!(!bench.core.waiting());
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::DataAbort, 8)));
        assert_eq!(bench.core.faults.dfsr, ASYNCHRONOUS_WRITE);
        let ordered = 0xC000_0000;
        let mut bench = Bench::arm(Endian::Little, &code);
        bench.core.state.r[4] = ordered;
        bench.bus.fails_from = Some(u64::from(ordered));
        assert_eq!(bench.run(4), (Exit::Returned, 0));
        assert_eq!(bench.raised(), Some((Exception::DataAbort, 0)));
        let faults = &bench.core.faults;
        assert_eq!((faults.dfsr, faults.dfar), (SYNCHRONOUS_WRITE, ordered));
    }

    /// B5.5.3: a fetch nothing answers is a synchronous external abort at the halfword it
    /// couldn't read, the second of a 32-bit Thumb instruction across the end of memory.
    #[test]
    fn a_failed_fetch_reports_the_halfword_it_could_not_read() {
        const SYNCHRONOUS_EXTERNAL: u32 = 0b1000;
        let end = CODE + 0x1_0000 - 2;
        let mut bench = Bench::thumb(Endian::Big, &[]);
        bench.place_thumb(end, &[0xF201]); // ADDW, half of it
        bench.core.state.r[15] = end;
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::PrefetchAbort, end)));
        let faults = &bench.core.faults;
        assert_eq!((faults.ifsr, faults.ifar), (SYNCHRONOUS_EXTERNAL, end + 2));
    }

    /// A handler whose first instruction faults into itself takes its exception again with no
    /// instruction retired, and the core stops rather than loop with no time passing.
    #[test]
    fn a_handler_that_faults_into_itself_stops_the_core() {
        let mut bench = Bench::arm(Endian::Little, &[UDF]);
        bench.place_arm(VECTORS + Exception::Undefined.offset(), &[UDF]);
        assert_eq!(bench.run(4), (Exit::Lockup, 0));
        assert_eq!(bench.taken(), Some(Exception::Undefined));
        assert_eq!(bench.run(4), (Exit::Lockup, 0), "and again");
    }
}
