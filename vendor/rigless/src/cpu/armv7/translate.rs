// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! Lowers instructions to Cranelift IR: the Thumb instructions both profiles have, DDI 0403E.b
//! chapters A5 to A7, and through the [`Emitter`] those of ARM state, DDI 0406C.
//!
//! [`Emitter`] is what an instruction is lowered through, in either instruction set state, and
//! [`thumb16`] and [`thumb32`] decode every Thumb encoding but the ones a family decodes itself, its
//! branches and its system instructions.
//! The encoding groups are split by DDI 0403E.b's own tables, A5.2 for 16-bit instructions and
//! A5.3 for 32-bit ones, and each group lives in a module of its own.
//!
//! A family's core implements [`Profile`], and every function here is generic over it, so each
//! family gets code of its own and nothing is looked up while a block is lowered.

pub(crate) mod alu;
mod data16;
pub(crate) mod data32;
pub(crate) mod float;
pub(crate) mod memory;
pub(crate) mod multiply;

use std::marker::PhantomData;

use cranelift_codegen::ir::{self, InstBuilder, MemFlagsData, Value, condcodes::IntCC, types};
use cranelift_frontend::{FunctionBuilder, Variable};

use crate::emulator::core::{Fma, Place, host_convention};
use crate::soc::Endian;
use float::Fpu;

/// Why a block ended, in the low eight bits of what it answers.
pub(crate) mod status {
    /// It ran to its end, or took a branch, and the next instruction is at `r[15]`.
    pub(crate) const NEXT: u32 = 0;
    /// The budget was spent before the block, so it ran nothing.
    pub(crate) const SHORT: u32 = 1;
    /// An instruction raised an exception, which the core takes before the next one.
    pub(crate) const EXCEPTION: u32 = 2;
    /// `WFI` retired, and the core waits for an interrupt.
    pub(crate) const WAIT_FOR_INTERRUPT: u32 = 3;
    /// `WFE` retired, and the core waits for an event.
    pub(crate) const WAIT_FOR_EVENT: u32 = 4;
    /// A branch returned from an exception, to the value in `r[15]`, which the family's exception
    /// model reads.
    pub(crate) const EXCEPTION_RETURN: u32 = 5;
    /// A branch to itself retired, which runs nothing but itself until an interrupt.
    pub(crate) const SPIN: u32 = 6;
    /// A quick translation has run often enough to translate again with better code, and ran
    /// nothing this time.
    pub(crate) const HOT: u32 = 7;
}

/// A helper's answer with this set raised a fault, and its instruction leaves as if it hadn't run.
pub(crate) const FAULTED: u64 = 1 << 32;
/// With [`FAULTED`]: the helper set `r[15]` itself, as a lockup does, and the fault exit keeps it.
pub(crate) const KEEP_PC: u64 = 1 << 33;

/// What an instruction's encoding doesn't define, A5.1, which the core raises as
/// [`Fault::Undefined`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Undefined;

/// What a group's function answers for one encoding.
pub(crate) type Translated = Result<(), Undefined>;

/// A fault an instruction raises, which the family's exception model turns into its exception and
/// its status bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub(crate) enum Fault {
    /// An UNDEFINED encoding.
    Undefined = 1,
    /// An instruction the core can't run in its state: with the Thumb bit clear, or a bad
    /// `ITSTATE`.
    InvalidState = 2,
    /// A coprocessor instruction with the coprocessor off or absent.
    NoCoprocessor = 3,
    /// An unaligned access the core refuses.
    Unaligned = 4,
    /// A divide by zero the core traps.
    DivideByZero = 5,
    /// A fetch the bus or the MPU refused.
    InstructionFetch = 6,
    /// `SVC`, which is a call rather than a fault.
    SupervisorCall = 8,
    /// `BKPT`.
    Breakpoint = 9,
    /// A semihosting call's trap, which the run may serve before it's the breakpoint it otherwise
    /// is.
    HostCall = 10,
    /// A floating-point instruction on a short vector, which a unit without them leaves UNDEFINED.
    Vector = 11,
}

impl Fault {
    pub(crate) fn from_code(code: u32) -> Option<Self> {
        Some(match code {
            1 => Self::Undefined,
            2 => Self::InvalidState,
            3 => Self::NoCoprocessor,
            4 => Self::Unaligned,
            5 => Self::DivideByZero,
            6 => Self::InstructionFetch,
            8 => Self::SupervisorCall,
            9 => Self::Breakpoint,
            10 => Self::HostCall,
            11 => Self::Vector,
            _ => return None,
        })
    }
}

/// How wide a load or store is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Size {
    Byte = 1,
    Halfword = 2,
    Word = 4,
}

impl Size {
    /// The size of `bytes`, as a helper's argument gives it: 1, 2, or anything else for a word.
    pub(crate) fn from_bytes(bytes: u32) -> Self {
        match bytes {
            1 => Self::Byte,
            2 => Self::Halfword,
            _ => Self::Word,
        }
    }

    pub(crate) fn bytes(self) -> u32 {
        self as u32
    }

    /// The bits of a word an access of this size holds, its low bytes.
    pub(crate) fn low_bytes(self) -> u32 {
        match self {
            Self::Byte => 0xFF,
            Self::Halfword => 0xFFFF,
            Self::Word => u32::MAX,
        }
    }

    pub(crate) fn host(self) -> ir::Type {
        match self {
            Self::Byte => types::I8,
            Self::Halfword => types::I16,
            Self::Word => types::I32,
        }
    }
}

/// What a load or store asks of the memory system beyond its address and size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Attributes {
    /// The address must be aligned to the size even where the core allows an unaligned access,
    /// A3.2.1: `LDM`, `STM`, `LDRD`, `STRD`, the exclusives and the floating-point loads and
    /// stores.
    pub(crate) aligned: bool,
    /// The access is checked as an unprivileged one, `LDRT` and its kind, A5.3.
    pub(crate) unprivileged: bool,
}

impl Attributes {
    pub(crate) const ALIGNED: Self = Self {
        aligned: true,
        unprivileged: false,
    };

    pub(crate) fn bits(self) -> u32 {
        u32::from(self.aligned) | u32::from(self.unprivileged) << 1
    }

    pub(crate) fn from_bits(bits: u32) -> Self {
        Self {
            aligned: bits & 1 != 0,
            unprivileged: bits & 2 != 0,
        }
    }
}

/// The instruction set a block's instructions are in, DDI 0406C A2.5.1's `CurrentInstrSet()`. The
/// M profile has only Thumb.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InstructionSet {
    Arm,
    Thumb,
}

/// The condition that always holds, AL, which DDI 0406C Table A8-1 encodes `0b1110`.
pub(crate) const ALWAYS: u32 = 0b1110;

/// One of the condition flags, A2.3.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flag {
    N = 0,
    Z = 1,
    C = 2,
    V = 3,
}

/// Bits `high` down to `low` of `value`, as the manual writes `value<high:low>`.
pub(crate) fn bits(value: u32, high: u32, low: u32) -> u32 {
    (value >> low) & (u32::MAX >> (31 - (high - low)))
}

/// The offset from the core of the state field at `offset` into the state.
fn field_offset<F: Profile>(offset: usize) -> i32 {
    i32::try_from(F::STATE + offset).expect("inside the core")
}

/// `ITSTATE` after one more instruction of its IT block, A7.3.3's `ITAdvance()`.
pub(crate) fn it_advance(it: u32) -> u32 {
    if it.trailing_zeros() >= 3 {
        0
    } else {
        (it & 0xE0) | ((it << 1) & 0x1F)
    }
}

/// The written registers and flags, a bit each: `R0` to `R14`, then N, Z, C, V from bit 16.
type Written = u32;

const FLAG_BIT: u32 = 16;

/// What a core implements past its architecture's base that its instructions depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Features {
    /// The DSP extension.
    pub(crate) dsp: bool,
    pub(crate) fpu: Fpu,
    /// The order of a value's bytes in a data access, A3.3.1. Instruction fetches are always
    /// little-endian.
    pub(crate) endian: Endian,
    /// Whether the core takes the shortcuts that change nothing but how long a run takes.
    pub(crate) shortcuts: bool,
}

impl Features {
    /// B1.6's `HaveFPExt()`.
    pub(crate) fn fp(self) -> bool {
        self.fpu != Fpu::None
    }
}

/// What a core family supplies so its instructions can be lowered here.
///
/// The constants are its core's layout, as offsets in bytes, but for [`Profile::ALIGNS_SP`].
/// `STATE`, `BUDGET` and `RETURNING` are from the start of the core, which is what a block's
/// function takes, and the rest are from the start of the state. The methods emit the parts of an
/// instruction the family does its own way into the instruction an [`Emitter`] is lowering: memory
/// accesses, faults, the branches that can change state or return from an exception, the
/// floating-point check and the divide by zero trap.
/// [`Profile::fp_registers`] finds the floating-point registers for the helpers that run the
/// arithmetic.
pub(crate) trait Profile: Sized {
    /// Where the state starts.
    const STATE: usize;
    /// The instructions the stretch has left, an `i32`.
    const BUDGET: i32;
    /// An `i32` that's nonzero once the core was asked to return to the run loop.
    const RETURNING: i32;
    /// `R0` to `R15`, a word each.
    const R: usize;
    /// `N`, `Z`, `C`, `V` and `Q`, a word each holding 0 or 1.
    const N: usize;
    const Z: usize;
    const C: usize;
    const V: usize;
    const Q: usize;
    /// `GE`, in a word's low four bits.
    const GE: usize;
    /// The floating-point extension's single registers, a word each, and `FPSCR`.
    const S: usize;
    const FPSCR: usize;
    /// Whether the local exclusive monitor is in the Exclusive Access state, 0 or 1.
    const MONITOR: usize;
    /// Whether `R[]` forces the SP's bits 1 and 0 to zero whenever it reads or writes it, as the
    /// M profile does, DDI 0403E.b B1.4.7. The R profile doesn't, DDI 0406C B1.3.2.
    const ALIGNS_SP: bool;

    /// Loads `size` bytes at `address`, zero-extended to an `i32`. A fault leaves the block as if
    /// the instruction hadn't run, so an instruction loads before it writes a register.
    fn load(
        e: &mut Emitter<'_, '_, Self>,
        address: Value,
        size: Size,
        attributes: Attributes,
    ) -> Value;

    /// Stores the low `size` bytes of `value` at `address`. A fault leaves the block as
    /// [`Profile::load`]'s does.
    fn store(
        e: &mut Emitter<'_, '_, Self>,
        address: Value,
        value: Value,
        size: Size,
        attributes: Attributes,
    );

    /// Raises `fault` for this instruction, which the core takes before the next one. Ends the
    /// block.
    fn raise(e: &mut Emitter<'_, '_, Self>, fault: Fault);

    /// Raises the alignment fault of an access to `address` that A3.2.1 checks whatever the core
    /// allows, a store's when `write`, where `misaligned`, an `i8`, is set, and goes on with the
    /// instruction where it isn't.
    fn raise_unaligned(
        e: &mut Emitter<'_, '_, Self>,
        misaligned: Value,
        address: Value,
        write: bool,
    );

    /// `BXWritePC(address)`, which `LoadWritePC` is too. Ends the block.
    fn branch_exchange(e: &mut Emitter<'_, '_, Self>, address: Value);

    /// `BLXWritePC(address)`. Ends the block.
    fn blx_write_pc(e: &mut Emitter<'_, '_, Self>, address: Value);

    /// The check every floating-point instruction starts with, or only that the extension is on
    /// when not `execute`, for an encoding that's UNDEFINED. Leaves through a fault when it
    /// refuses.
    fn fp_check(e: &mut Emitter<'_, '_, Self>, execute: bool);

    /// Whether a divide by zero traps, as an `i32` that's 0 or 1.
    fn divide_by_zero_traps(e: &mut Emitter<'_, '_, Self>) -> Value;

    /// Leaves for `pc` with `ITSTATE` `it` and `left` of the budget, by tail-calling the block the link
    /// cell at `cell` holds, without the leave block. Answers whether it did; a family that has no
    /// such exit doesn't.
    fn hand_over(
        e: &mut Emitter<'_, '_, Self>,
        pc: u32,
        it: u32,
        left: Value,
        cell: Place,
    ) -> bool {
        let _ = (e, pc, it, left, cell);
        false
    }

    /// The floating-point extension's single registers and `FPSCR` in `core`.
    fn fp_registers(core: &mut Self) -> (&mut [u32; 32], &mut u32);
}

/// Lowers one block's instructions to Cranelift IR.
///
/// Registers `R0` to `R14` and the N, Z, C and V flags live in variables while the block runs, and
/// each instruction writes the ones it changed to the core's state once it's done, so an exit after
/// an instruction finds the state current and one that leaves as if it hadn't run finds the state
/// as the instruction found it. Everything else,
/// `Q`, `GE`, the floating-point registers and the special registers, stays in the state, which
/// [`Emitter::load_field`] and [`Emitter::store_field`] reach.
///
/// An instruction's function reads its operands with [`Emitter::reg`] and [`Emitter::flag`],
/// computes with the builder in [`Emitter::b`], and writes with [`Emitter::set_reg`] and
/// [`Emitter::set_flag`]. It accesses memory with [`Profile::load`] and [`Profile::store`], which
/// leave the block through a fault on their own. It changes the flow with the `branch` methods,
/// [`Profile::raise`] and [`Emitter::wait`], each of which ends the block, and it ends the block
/// with [`Emitter::end_block`] after changing anything the next instruction's translation or the
/// interrupt it might take depends on.
pub(crate) struct Emitter<'a, 'b, F: Profile> {
    /// The builder, positioned where the instruction's code goes.
    pub(crate) b: &'a mut FunctionBuilder<'b>,
    regs: [Variable; 15],
    flags: [Variable; 4],
    /// The registers and flags the instruction has written, which reach the state once it's done.
    pub(crate) written: Written,
    /// Whether what an instruction wrote stays in hand until the block is left, or a helper that
    /// may read it is called, rather than reaching the state once the instruction is done.
    pub(crate) in_hand: bool,
    /// What the instructions before this one wrote and the state may not have yet.
    pending: Written,
    /// How many instructions the budget holds on entry when the block checks it there, so that no
    /// instruction has to.
    pub(crate) checked_on_entry: bool,
    /// The address of the instruction being translated.
    pc: u32,
    /// Its length in bytes, 2 or 4.
    length: u32,
    /// The instruction set every instruction of the block is in.
    state: InstructionSet,
    /// `ITSTATE` as the instruction sees it.
    pub(crate) it: u32,
    /// `ITSTATE` for the next instruction when this one sets it, as `IT` does.
    pub(crate) next_it: Option<u32>,
    /// The instructions of the block before this one.
    pub(crate) index: u32,
    /// The instruction ended the block.
    ended: bool,
    /// The instruction made an access that may have gone to the bus.
    pub(crate) accessed: bool,
    pub(crate) pointer: ir::Type,
    /// The budget when this pass through the block started, which every exit leaves less what
    /// it retired.
    pub(crate) budget: Variable,
    /// The block's first instruction, for a branch back to it to loop inside the block.
    pub(crate) head: Option<Head>,
    /// Where an exit to a known next block can chain to it, when the block may.
    pub(crate) chain: Option<Chain<'a>>,
    /// Where every exit goes, to write the block's registers back once for all of them.
    pub(crate) leave: Option<ir::Block>,
    /// What the core implements, which decides what an encoding is.
    pub(crate) features: Features,
    /// How the host makes a fused multiply-add.
    pub(crate) fma: Fma,
    /// An instruction of the block has passed [`Profile::fp_check`] on every way to this one, so
    /// the next has nothing left to check.
    pub(crate) fp_checked: bool,
    profile: PhantomData<F>,
}

/// A block's first instruction: its address, its `ITSTATE`, where its code starts, and whether a
/// branch back to it loops inside the block.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Head {
    pub(crate) pc: u32,
    pub(crate) it: u32,
    pub(crate) block: ir::Block,
    pub(crate) looped: bool,
}

/// Where an exit leaves the block for: the next instruction's `ITSTATE`, the instructions the
/// pass retired, and the status the block answers.
#[derive(Clone, Copy, Debug)]
struct Exit {
    it: u32,
    retired: u32,
    status: u32,
}

/// A new link cell for an exit to the block at an address with an `ITSTATE`: where the exit reads it.
pub(crate) type Cells<'a> = &'a mut dyn FnMut(u32, u32) -> Place;

/// What a block needs to chain an exit to the block after it.
pub(crate) struct Chain<'a> {
    pub(crate) cells: Cells<'a>,
    /// The signature every block has, for the tail call.
    pub(crate) signature: ir::SigRef,
    /// The core's cache of recent lookups, where an exit to a computed address finds the next
    /// block.
    pub(crate) recent: Place,
    /// What every key of a block this one chains to has beside where that starts.
    pub(crate) space: u64,
}

impl<'a, 'b, F: Profile> Emitter<'a, 'b, F> {
    /// An emitter at the start of a function for a core with `features`, whose pointers are
    /// `pointer`, for instructions in `state`, with every register and flag read from the state.
    pub(crate) fn new(
        b: &'a mut FunctionBuilder<'b>,
        pointer: ir::Type,
        features: Features,
        state: InstructionSet,
    ) -> Self {
        let regs = std::array::from_fn(|_| b.declare_var(types::I32));
        let flags = std::array::from_fn(|_| b.declare_var(types::I32));
        let budget = b.declare_var(types::I32);
        let core = b.ins().get_pinned_reg(pointer);
        let left = b
            .ins()
            .load(types::I32, MemFlagsData::trusted(), core, F::BUDGET);
        b.def_var(budget, left);
        let mut emitter = Self {
            b,
            regs,
            flags,
            written: 0,
            in_hand: false,
            pending: 0,
            checked_on_entry: false,
            pc: 0,
            length: 2,
            state,
            it: 0,
            next_it: None,
            index: 0,
            ended: false,
            accessed: false,
            pointer,
            budget,
            head: None,
            chain: None,
            leave: None,
            features,
            fma: Fma::Library,
            fp_checked: false,
            profile: PhantomData,
        };
        emitter.reload();
        emitter
    }

    /// The core's state, from the register the core is pinned to while blocks run, so no block
    /// keeps it anywhere else.
    pub(crate) fn core(&mut self) -> Value {
        self.b.ins().get_pinned_reg(self.pointer)
    }

    /// The address of this instruction.
    pub(crate) fn pc(&self) -> u32 {
        self.pc
    }

    /// The address of the next instruction.
    pub(crate) fn next_pc(&self) -> u32 {
        self.pc.wrapping_add(self.length)
    }

    /// The instruction set the block is in, DDI 0406C A2.5.1.
    pub(crate) fn state(&self) -> InstructionSet {
        self.state
    }

    /// Whether this instruction is inside an IT block, A7.3.3's `InITBlock()`.
    pub(crate) fn in_it(&self) -> bool {
        self.it & 0xF != 0
    }

    /// Sets `ITSTATE` for the instructions after this one, as `IT` does, A7.7.37. The block goes
    /// on, with each instruction after it under its condition.
    pub(crate) fn set_next_it(&mut self, it: u32) {
        self.next_it = Some(it);
    }

    /// `R[n]`, A2.3.1: `R15` reads as this instruction's address plus 4, or plus 8 in ARM state,
    /// DDI 0406C B1.3.2.
    pub(crate) fn reg(&mut self, n: u32) -> Value {
        if n == 15 {
            return self.constant(self.pc_read());
        }
        self.b.use_var(self.regs[n as usize])
    }

    /// What `R[15]` reads as, which is known when the instruction is translated.
    fn pc_read(&self) -> u32 {
        let ahead = match self.state() {
            InstructionSet::Arm => 8,
            InstructionSet::Thumb => 4,
        };
        self.pc.wrapping_add(ahead)
    }

    /// `Align(PC, 4)`, A2.3.1, the base of a literal and of `ADR`.
    pub(crate) fn aligned_pc(&self) -> u32 {
        self.pc_read() & !3
    }

    /// Writes `R[n]` for `n` below 15. The PC is written only through the branch methods.
    pub(crate) fn set_reg(&mut self, n: u32, value: Value) {
        assert!(n < 15, "the PC is written by a branch");
        self.b.def_var(self.regs[n as usize], value);
        self.written |= 1 << n;
    }

    /// A flag, as 0 or 1 in an `i32`.
    pub(crate) fn flag(&mut self, flag: Flag) -> Value {
        self.b.use_var(self.flags[flag as usize])
    }

    /// Sets a flag from `value`, which is 0 or 1 in an `i32`.
    pub(crate) fn set_flag(&mut self, flag: Flag, value: Value) {
        self.b.def_var(self.flags[flag as usize], value);
        self.written |= 1 << (FLAG_BIT + flag as u32);
    }

    /// Sets N and Z from a 32-bit result.
    pub(crate) fn set_nz(&mut self, result: Value) {
        let n = self.b.ins().ushr_imm_u(result, 31);
        let z = self.b.ins().icmp_imm_s(IntCC::Equal, result, 0);
        let z = self.b.ins().uextend(types::I32, z);
        self.set_flag(Flag::N, n);
        self.set_flag(Flag::Z, z);
    }

    /// An `i32` constant.
    pub(crate) fn constant(&mut self, value: u32) -> Value {
        self.b
            .ins()
            .iconst(types::I32, i64::from(value.cast_signed()))
    }

    /// Lowers one instruction with `lower` under condition `cond`, A7.3.1 for an instruction in an
    /// IT block and DDI 0406C A8.3 for one in ARM state. Where the condition fails, the
    /// instruction retires having done nothing. An instruction that ends the block when it runs
    /// ends it when it's skipped too. Under [`ALWAYS`] it just runs.
    pub(crate) fn under_condition(&mut self, cond: u32, lower: impl FnOnce(&mut Self)) {
        if cond == ALWAYS {
            lower(self);
            self.done();
            self.return_if_asked();
            return;
        }
        // A check the condition may skip leaves the next instruction its own.
        let checked = self.fp_checked;
        let holds = self.condition(cond);
        let run = self.b.create_block();
        let skip = self.b.create_block();
        self.b.ins().brif(holds, run, &[], skip, &[]);
        self.b.seal_block(run);
        self.b.switch_to_block(run);
        lower(self);
        self.fp_checked = checked;
        self.done();
        self.return_if_asked();
        if self.ended() {
            // It ended the block where it ran, so where it doesn't, the block ends after it too,
            // having written nothing.
            self.b.seal_block(skip);
            self.b.switch_to_block(skip);
            self.written = 0;
            self.end_block();
            return;
        }
        self.b.ins().jump(skip, &[]);
        self.b.seal_block(skip);
        self.b.switch_to_block(skip);
    }

    /// Whether condition `cond` holds, A7.3.1's `ConditionPassed()`, as an `i8` that's 0 or 1.
    pub(crate) fn condition(&mut self, cond: u32) -> Value {
        let n = self.flag(Flag::N);
        let z = self.flag(Flag::Z);
        let c = self.flag(Flag::C);
        let v = self.flag(Flag::V);
        let holds = match cond >> 1 {
            0b000 => z,
            0b001 => c,
            0b010 => n,
            0b011 => v,
            0b100 => {
                let not_z = self.b.ins().bxor_imm_s(z, 1);
                self.b.ins().band(c, not_z)
            }
            0b101 => self.b.ins().icmp(IntCC::Equal, n, v),
            0b110 => {
                let ge = self.b.ins().icmp(IntCC::Equal, n, v);
                let ge = self.b.ins().uextend(types::I32, ge);
                let not_z = self.b.ins().bxor_imm_s(z, 1);
                self.b.ins().band(ge, not_z)
            }
            _ => self.constant(1),
        };
        let holds = self.b.ins().icmp_imm_s(IntCC::NotEqual, holds, 0);
        if cond & 1 == 1 && cond != 0b1111 {
            self.b.ins().bxor_imm_s(holds, 1)
        } else {
            holds
        }
    }

    /// Loads the `i32` at `offset` into the core.
    pub(crate) fn load_core(&mut self, offset: i32) -> Value {
        let core = self.core();
        self.b
            .ins()
            .load(types::I32, MemFlagsData::trusted(), core, offset)
    }

    /// Loads the `i32` state field at `offset` into the state.
    pub(crate) fn load_field(&mut self, offset: usize) -> Value {
        let offset = field_offset::<F>(offset);
        let core = self.core();
        self.b
            .ins()
            .load(types::I32, MemFlagsData::trusted(), core, offset)
    }

    /// Stores an `i32` to the state field at `offset`.
    pub(crate) fn store_field(&mut self, offset: usize, value: Value) {
        let offset = field_offset::<F>(offset);
        let core = self.core();
        self.b
            .ins()
            .store(MemFlagsData::trusted(), value, core, offset);
    }

    /// Leaves the block through a fault exit when a helper's answer has [`FAULTED`] set, and goes
    /// on with the instruction where it hasn't. The exit is at the instruction, or where the
    /// helper left `r[15]` with [`KEEP_PC`].
    pub(crate) fn fault_unless(&mut self, answer: Value) {
        let failed = self
            .b
            .ins()
            .ushr_imm_u(answer, i64::from(FAULTED.trailing_zeros()));
        let fault = self.b.create_block();
        self.b.set_cold_block(fault);
        let fine = self.b.create_block();
        self.b.ins().brif(failed, fault, &[], fine, &[]);
        self.b.seal_block(fault);
        self.b.seal_block(fine);
        self.b.switch_to_block(fault);
        let keep = self.b.ins().band_imm_s(answer, KEEP_PC.cast_signed());
        let here = self.constant(self.pc);
        let kept = self.load_field(F::R + 15 * 4);
        let pc = self.b.ins().select(keep, kept, here);
        self.exit_before_at(pc, status::EXCEPTION);
        self.ended = false;
        self.b.switch_to_block(fine);
    }

    /// Calls `function`, an `extern "C" fn` of the core and `args` answering a `u32`, and answers
    /// what it returns. The registers and flags reach the state before the call and are read back
    /// after it, so the helper may read or write any of them. Its answer is the instruction's to
    /// use, and the call doesn't end the block.
    pub(crate) fn call(&mut self, function: usize, args: &[Value]) -> Value {
        self.commit();
        let answer = self.call_helper(function, args, types::I32);
        self.reload();
        // What's pending stays so: an instruction that's skipped hasn't made this call.
        self.written = 0;
        answer
    }

    /// Calls `function` as [`Emitter::call`] does, for a helper that reads and writes none of
    /// `R0` to `R14` or the N, Z, C and V flags, so nothing is written back or read again.
    pub(crate) fn call_plain(&mut self, function: usize, args: &[Value]) -> Value {
        self.call_helper(function, args, types::I32)
    }

    pub(crate) fn call_helper(
        &mut self,
        function: usize,
        args: &[Value],
        returns: ir::Type,
    ) -> Value {
        let mut params = vec![self.pointer];
        params.extend(args.iter().map(|&arg| self.b.func.dfg.value_type(arg)));
        let mut signature = ir::Signature::new(host_convention());
        signature.params = params.into_iter().map(ir::AbiParam::new).collect();
        signature.returns = vec![ir::AbiParam::new(returns)];
        let signature = self.b.import_signature(signature);
        let callee = self
            .b
            .ins()
            .iconst(self.pointer, i64::try_from(function).expect("an address"));
        let core = self.core();
        let mut all = vec![core];
        all.extend_from_slice(args);
        let call = self.b.ins().call_indirect(signature, callee, &all);
        self.b.inst_results(call)[0]
    }

    /// `BranchWritePC(address)`, A2.3.1: the next instruction is at `address` with bit 0 cleared,
    /// and bit 1 too in ARM state, DDI 0406C A2.3.2. Ends the block.
    pub(crate) fn branch(&mut self, address: Value) {
        let aligned = match self.state() {
            InstructionSet::Arm => !3,
            InstructionSet::Thumb => !1,
        };
        let target = self.b.ins().band_imm_s(address, aligned);
        let chains = self.constant(1);
        self.exit_to_computed(target, chains);
    }

    /// A branch to the constant `address`, which ends the block. A branch to itself outside an IT
    /// block spins, and the core treats it as waiting for an interrupt.
    pub(crate) fn branch_to(&mut self, address: u32) {
        let target = address & !1;
        if target == self.pc && !self.in_it() {
            let target = self.constant(target);
            self.exit_to(target, status::SPIN);
        } else {
            self.exit_to_known(target);
        }
    }

    /// `ALUWritePC(address)`, DDI 0406C A2.3.2: `BXWritePC()` in ARM state, and `BranchWritePC()`
    /// in Thumb state. Ends the block.
    pub(crate) fn alu_write_pc(&mut self, address: Value) {
        match self.state() {
            InstructionSet::Arm => F::branch_exchange(self, address),
            InstructionSet::Thumb => self.branch(address),
        }
    }

    /// Branches to `address` when `holds`, an `i8`, is set, and goes on to the next instruction
    /// otherwise. Ends the block.
    pub(crate) fn branch_if(&mut self, holds: Value, address: u32) {
        let taken = self.b.create_block();
        let not_taken = self.b.create_block();
        self.b.ins().brif(holds, taken, &[], not_taken, &[]);
        self.b.seal_block(taken);
        self.b.seal_block(not_taken);
        self.b.switch_to_block(not_taken);
        self.exit_to_known(self.next_pc());
        self.ended = false;
        self.b.switch_to_block(taken);
        let target = address & !1;
        if target == self.pc && !self.in_it() {
            let target = self.constant(target);
            self.exit_to(target, status::SPIN);
        } else {
            self.exit_to_known(target);
        }
    }

    /// Raises `fault` as [`Profile::raise`] does where `holds`, an `i8`, is set, and goes on with
    /// the instruction where it isn't.
    pub(crate) fn raise_if(&mut self, holds: Value, fault: Fault) {
        let raise = self.b.create_block();
        self.b.set_cold_block(raise);
        let go_on = self.b.create_block();
        self.b.ins().brif(holds, raise, &[], go_on, &[]);
        self.b.seal_block(raise);
        self.b.seal_block(go_on);
        self.b.switch_to_block(raise);
        F::raise(self, fault);
        self.ended = false;
        self.b.switch_to_block(go_on);
    }

    /// Retires a `WFI`, or a `WFE` when `event`, and leaves the core waiting. Ends the block.
    pub(crate) fn wait(&mut self, event: bool) {
        let next = self.constant(self.next_pc());
        self.exit_to(
            next,
            if event {
                status::WAIT_FOR_EVENT
            } else {
                status::WAIT_FOR_INTERRUPT
            },
        );
    }

    /// Ends the block after this instruction, for one that changed what the next instruction's
    /// translation depends on, or the masks an interrupt is taken by.
    pub(crate) fn end_block(&mut self) {
        let next = self.constant(self.next_pc());
        self.exit_to(next, status::NEXT);
    }

    /// Leaves after the `retired`-th instruction of the block, which has just run, when that
    /// spends the budget. The block runs as far as its budget and no further, with nothing
    /// translated for a shorter one.
    pub(crate) fn stop_if_spent(&mut self, retired: u32) {
        if self.checked_on_entry {
            return;
        }
        let budget = self.b.use_var(self.budget);
        let spent = self
            .b
            .ins()
            .icmp_imm_s(IntCC::Equal, budget, i64::from(retired));
        let next = self.next_pc();
        let exit = Exit {
            it: self.it_after(),
            retired: self.index + 1,
            status: status::NEXT,
        };
        self.leave_if(spent, next, exit);
    }

    /// Leaves for `pc` with `exit` where `condition` is set, and goes on where it isn't. The way
    /// out is laid out away from the way on, which is the one usually taken.
    fn leave_if(&mut self, condition: Value, pc: u32, exit: Exit) {
        let out = self.b.create_block();
        let stay = self.b.create_block();
        self.b.set_cold_block(out);
        self.b.ins().brif(condition, out, &[], stay, &[]);
        self.b.seal_block(out);
        self.b.seal_block(stay);
        self.b.switch_to_block(out);
        let pc = self.constant(pc);
        let arguments = self.leaving(pc, exit, None);
        let leave = self.leave_block();
        self.b.ins().jump(leave, &arguments);
        self.b.switch_to_block(stay);
    }

    /// Whether the instruction ended the block.
    pub(crate) fn ended(&self) -> bool {
        self.ended
    }

    /// Goes round the block again from `head`, its first instruction, with the registers and
    /// flags still in hand. The pass that ends here spends its instructions, and when that's the
    /// whole budget, or a helper asked the core to return, the block leaves instead, at its
    /// first instruction.
    fn loop_to(&mut self, head: ir::Block) {
        self.commit();
        self.written = 0;
        let retired = self.index + 1;
        let budget = self.b.use_var(self.budget);
        let left = self.b.ins().iadd_imm_s(budget, -i64::from(retired));
        let core = self.core();
        let returning = self
            .b
            .ins()
            .load(types::I32, MemFlagsData::trusted(), core, F::RETURNING);
        // The branch back is the block's last instruction, so a pass is as long as the block.
        let pass = if self.checked_on_entry { retired } else { 1 };
        let spent = self
            .b
            .ins()
            .icmp_imm_s(IntCC::UnsignedLessThan, left, i64::from(pass));
        let asked = self.b.ins().icmp_imm_s(IntCC::NotEqual, returning, 0);
        let leave = self.b.ins().bor(spent, asked);
        let first = self.head.as_mut().expect("looping to the head");
        first.looped = true;
        let (pc, it) = (first.pc, first.it);
        let pc = self.constant(pc);
        let arguments = self.leaving(
            pc,
            Exit {
                it,
                retired,
                status: status::NEXT,
            },
            None,
        );
        let again = self.b.create_block();
        let out = self.leave_block();
        self.b.ins().brif(leave, out, &arguments, again, &[]);
        self.b.seal_block(again);
        self.b.switch_to_block(again);
        self.b.def_var(self.budget, left);
        let core = self.core();
        // A helper counts the instructions before its access from the budget in the state.
        self.b
            .ins()
            .store(MemFlagsData::trusted(), left, core, F::BUDGET);
        self.b.ins().jump(head, &[]);
        self.ended = true;
    }

    /// Leaves after this instruction, which retires, to `pc`, with `status`.
    pub(crate) fn exit_to(&mut self, pc: Value, status: u32) {
        let arguments = self.leaving(
            pc,
            Exit {
                it: self.it_after(),
                retired: self.index + 1,
                status,
            },
            None,
        );
        let leave = self.leave_block();
        self.b.ins().jump(leave, &arguments);
        self.ended = true;
    }

    /// Leaves after this instruction for `target`, which it computed. Where the block may chain,
    /// the exit hands over to the block there when the core has it at hand, as an exit to a known
    /// address does through its link cell, unless `chains` is 0. The M core passes the Thumb bit,
    /// since it faults on a target without it.
    pub(crate) fn exit_to_computed(&mut self, target: Value, chains: Value) {
        self.commit();
        let address = if self.chain.is_some() {
            let find = self.b.ins().iconst(self.pointer, FIND);
            let none = self.b.ins().iconst(self.pointer, 0);
            self.b.ins().select(chains, find, none)
        } else {
            self.b.ins().iconst(self.pointer, 0)
        };
        let exit = Exit {
            it: self.it_after(),
            retired: self.index + 1,
            status: status::NEXT,
        };
        let packed = self.constant(exit.it | exit.retired << 8 | exit.status << 16);
        let leave = self.leave_block();
        self.b
            .ins()
            .jump(leave, &[target.into(), packed.into(), address.into()]);
        self.ended = true;
    }

    /// `ITSTATE` for the instruction after this one.
    fn it_after(&self) -> u32 {
        self.next_it.unwrap_or_else(|| it_advance(self.it))
    }

    /// The block every exit goes to, made the first time one does. Its parameters are the next
    /// instruction's address, `ITSTATE`, the instructions the pass retired and the status to
    /// answer packed in a byte each, and a link cell's address or 0.
    fn leave_block(&mut self) -> ir::Block {
        if let Some(leave) = self.leave {
            return leave;
        }
        let leave = self.b.create_block();
        self.b.append_block_param(leave, types::I32);
        self.b.append_block_param(leave, types::I32);
        self.b.append_block_param(leave, self.pointer);
        self.leave = Some(leave);
        leave
    }

    /// The arguments of a jump to the leave block.
    fn leaving(&mut self, pc: Value, exit: Exit, cell: Option<Place>) -> Vec<ir::BlockArg> {
        if exit.retired > self.index {
            self.commit();
        } else {
            assert!(
                self.pending & self.written == 0,
                "an instruction leaves as if it hadn't run before it writes what's in hand"
            );
            self.store(self.pending);
        }
        let packed = self.constant(exit.it | exit.retired << 8 | exit.status << 16);
        let address = cell.unwrap_or(Place::At(0)).emit(self.b, self.pointer);
        [pc, packed, address]
            .into_iter()
            .map(ir::BlockArg::from)
            .collect()
    }

    /// Leaves after this instruction for the next one at `target`, which the core runs next as
    /// it would after any block. Where the block may chain, the exit hands over to the block
    /// at `target` itself once the core has linked it, and the core comes back only when the
    /// budget is too short for that block or nothing is linked yet.
    pub(crate) fn exit_to_known(&mut self, target: u32) {
        let it = self.next_it.unwrap_or_else(|| it_advance(self.it));
        if let Some(head) = self.head
            && head.pc == target
            && head.it == it
        {
            self.loop_to(head.block);
            return;
        }
        let cell = self.chain.as_mut().map(|chain| (chain.cells)(target, it));
        if self.in_hand
            && let Some(cell) = cell
        {
            self.commit();
            let budget = self.b.use_var(self.budget);
            let retired = i64::from(self.index + 1);
            let left = self.b.ins().iadd_imm_s(budget, -retired);
            if F::hand_over(self, target, it, left, cell) {
                self.ended = true;
                return;
            }
        }
        let pc = self.constant(target);
        let arguments = self.leaving(
            pc,
            Exit {
                it,
                retired: self.index + 1,
                status: status::NEXT,
            },
            cell,
        );
        let leave = self.leave_block();
        self.b.ins().jump(leave, &arguments);
        self.ended = true;
    }

    /// Leaves as if this instruction hadn't run, with `status`.
    pub(crate) fn exit_before(&mut self, status: u32) {
        let pc = self.constant(self.pc);
        self.exit_before_at(pc, status);
    }

    /// Leaves for `pc` as if this instruction hadn't run, with `status`.
    fn exit_before_at(&mut self, pc: Value, status: u32) {
        let arguments = self.leaving(
            pc,
            Exit {
                it: self.it,
                retired: self.index,
                status,
            },
            None,
        );
        let leave = self.leave_block();
        self.b.ins().jump(leave, &arguments);
        self.ended = true;
    }

    /// Writes the registers and flags that the instruction has written, and what's in hand from those
    /// before it, to the state, on the way the builder is on.
    fn commit(&mut self) {
        self.store(self.pending | self.written);
    }

    fn store(&mut self, written: Written) {
        for bit in 0..32 {
            if written & (1 << bit) != 0 {
                let (variable, offset) = self.slot(bit);
                let value = self.b.use_var(variable);
                self.store_field(offset, value);
            }
        }
    }

    /// Finishes the instruction where it didn't end the block: what it wrote reaches the state, or
    /// is in hand from here on.
    pub(crate) fn done(&mut self) {
        if !self.ended {
            if self.in_hand {
                self.pending |= self.written;
            } else {
                self.commit();
            }
            self.written = 0;
        }
    }

    /// Reads every register and flag from the state into its variable.
    fn reload(&mut self) {
        for bit in (0..15).chain(FLAG_BIT..FLAG_BIT + 4) {
            let (variable, offset) = self.slot(bit);
            let value = self.load_field(offset);
            self.b.def_var(variable, value);
        }
    }

    /// Reads everything from the state that instructions before this one may have left in variables,
    /// so this one may be the first to run. Each of them has reached the state.
    pub(crate) fn start_afresh(&mut self) {
        self.reload();
        let left = self.load_core(F::BUDGET);
        self.b.def_var(self.budget, left);
        self.fp_checked = false;
    }

    /// The variable and the state's offset of written-bit `bit`.
    fn slot(&self, bit: u32) -> (Variable, usize) {
        if bit < FLAG_BIT {
            let n = bit as usize;
            (self.regs[n], F::R + 4 * n)
        } else {
            let flag = (bit - FLAG_BIT) as usize;
            let offset = [F::N, F::Z, F::C, F::V][flag];
            (self.flags[flag], offset)
        }
    }

    /// Starts instruction `index` at `pc`, `length` bytes long, with `ITSTATE` `it`, once the one
    /// before is done.
    pub(crate) fn begin(&mut self, index: u32, pc: u32, length: u32, it: u32) {
        self.done();
        self.index = index;
        self.pc = pc;
        self.length = length;
        self.it = it;
        self.next_it = None;
        self.ended = false;
        self.accessed = false;
        self.written = 0;
    }

    /// Ends the block after this instruction when an access of it went to the bus, which asks
    /// the core to return to the runner before the next instruction.
    pub(crate) fn return_if_asked(&mut self) {
        if !self.accessed || self.ended {
            return;
        }
        let core = self.core();
        let returning = self
            .b
            .ins()
            .load(types::I32, MemFlagsData::trusted(), core, F::RETURNING);
        let exit = Exit {
            it: self.it_after(),
            retired: self.index + 1,
            status: status::NEXT,
        };
        self.leave_if(returning, self.next_pc(), exit);
    }
}

/// `PC + imm32` for a Thumb branch, with the PC reading as the instruction's address plus 4,
/// A2.3.1.
pub(crate) fn relative<P: Profile>(e: &Emitter<'_, '_, P>, imm32: u32) -> u32 {
    e.pc().wrapping_add(4).wrapping_add(imm32)
}

/// `SignExtend(value, 32)` of a `width`-bit value.
pub(crate) fn sign_extend(value: u32, width: u32) -> u32 {
    let above = 32 - width;
    ((value << above).cast_signed() >> above).cast_unsigned()
}

/// `SignExtend(S:I1:I2:imm10:imm11:'0', 32)`, where `I1 = NOT(J1 EOR S)` and
/// `I2 = NOT(J2 EOR S)`, DDI 0406C A8.8.18 encoding T4 and A8.8.25. `BLX`'s `imm10L:H:'0'` is the
/// same with `H` clear.
pub(crate) fn long_offset(hw1: u32, hw2: u32) -> u32 {
    let s = bits(hw1, 10, 10);
    let i1 = !(bits(hw2, 13, 13) ^ s) & 1;
    let i2 = !(bits(hw2, 11, 11) ^ s) & 1;
    let imm =
        (s << 24) | (i1 << 23) | (i2 << 22) | (bits(hw1, 9, 0) << 12) | (bits(hw2, 10, 0) << 1);
    sign_extend(imm, 25)
}

/// CBZ and CBNZ by `op`, bit 11, DDI 0406C A8.8.29. Whether it may be in an IT block is the
/// caller's to check.
pub(crate) fn compare_branch<P: Profile>(e: &mut Emitter<'_, '_, P>, hw: u32) {
    let imm32 = (bits(hw, 9, 9) << 6) | (bits(hw, 7, 3) << 1);
    let value = e.reg(bits(hw, 2, 0));
    let taken = if bits(hw, 11, 11) == 1 {
        IntCC::NotEqual
    } else {
        IntCC::Equal
    };
    let holds = e.b.ins().icmp_imm_s(taken, value, 0);
    let target = relative(e, imm32);
    e.branch_if(holds, target);
}

/// How many ways a lowered function has of leaving: every branch to its leave block, which is
/// the only block with three parameters, before the leave block is filled.
#[cfg(test)]
pub(crate) fn exits_of(function: &ir::Function) -> usize {
    let dfg = &function.dfg;
    function
        .layout
        .blocks()
        .flat_map(|block| function.layout.block_insts(block))
        .flat_map(|inst| {
            dfg.insts[inst]
                .branch_destination(&dfg.jump_tables, &dfg.exception_tables)
                .iter()
                .map(|call| call.block(&dfg.value_lists))
        })
        .filter(|&block| dfg.num_block_params(block) == 3)
        .count()
}

/// A5.2, the 16-bit encodings, by `opcode`, bits 15 to 10, but for the conditional branch, the
/// supervisor call and the unconditional branch, which are the family's to decode. Those are
/// UNDEFINED here.
pub(crate) fn thumb16<F: Profile>(e: &mut Emitter<'_, '_, F>, hw: u16) -> Translated {
    let opcode = hw >> 10;
    match opcode {
        0b00_0000..=0b00_1111 => data16::shift_add_subtract_move_compare(e, hw),
        0b01_0000 => data16::data_processing(e, hw),
        0b01_0001 => data16::special_data_branch_exchange(e, hw),
        0b01_0010 | 0b01_0011 => memory::load_literal16(e, hw),
        0b01_0100..=0b10_0111 => memory::load_store_single16(e, hw)?,
        0b10_1000 | 0b10_1001 => data16::adr(e, hw),
        0b10_1010 | 0b10_1011 => data16::add_sp_immediate(e, hw),
        0b10_1100..=0b10_1111 => miscellaneous16(e, hw)?,
        0b11_0000 | 0b11_0001 => memory::store_multiple16(e, hw)?,
        0b11_0010 | 0b11_0011 => memory::load_multiple16(e, hw)?,
        _ => return Err(Undefined),
    }
    Ok(())
}

/// A5.2.5, the miscellaneous 16-bit instructions, by `opcode`, bits 11 to 5, Table A5-6, but for
/// CPS, CBZ and CBNZ, BKPT, and IT and the hints, which are the family's to decode.
fn miscellaneous16<F: Profile>(e: &mut Emitter<'_, '_, F>, hw: u16) -> Translated {
    let opcode = (hw >> 5) & 0x7F;
    match opcode {
        0b000_0000..=0b000_0111 => data16::adjust_sp(e, hw),
        0b001_0000..=0b001_0111 => data16::extend(e, hw),
        0b010_0000..=0b010_1111 => memory::push16(e, hw)?,
        0b101_0000..=0b101_0011 | 0b101_0110 | 0b101_0111 => data16::reverse(e, hw)?,
        0b110_0000..=0b110_1111 => memory::pop16(e, hw)?,
        _ => return Err(Undefined),
    }
    Ok(())
}

/// A5.3, the 32-bit encodings, by `op1`, `op2` and `op`, but for the branches and miscellaneous
/// control, which are the family's to decode.
pub(crate) fn thumb32<F: Profile>(e: &mut Emitter<'_, '_, F>, hw1: u16, hw2: u16) -> Translated {
    if !e.features.dsp && dsp_only(u32::from(hw1), u32::from(hw2)) {
        return Err(Undefined);
    }
    let op1 = (hw1 >> 11) & 0b11;
    let op2 = (hw1 >> 4) & 0x7F;
    let op = hw2 >> 15;
    match op1 {
        0b01 => match op2 >> 5 {
            0b00 if op2 & 0b100 == 0 => memory::load_store_multiple(e, hw1, hw2),
            0b00 => memory::load_store_dual_exclusive_table_branch(e, hw1, hw2),
            0b01 => data32::shifted_register(e, hw1, hw2),
            _ => float::coprocessor(e, hw1, hw2),
        },
        0b10 if op == 0 && op2 & 0b10_0000 == 0 => data32::modified_immediate(e, hw1, hw2),
        0b10 if op == 0 => data32::plain_binary_immediate(e, hw1, hw2),
        0b11 => match op2 {
            _ if op2 & 0b111_0001 == 0 => memory::store_single(e, hw1, hw2),
            _ if op2 & 0b110_0111 == 0b000_0001 => memory::load_byte_hints(e, hw1, hw2),
            _ if op2 & 0b110_0111 == 0b000_0011 => memory::load_halfword_hints(e, hw1, hw2),
            _ if op2 & 0b110_0111 == 0b000_0101 => memory::load_word(e, hw1, hw2),
            _ if op2 & 0b110_0111 == 0b000_0111 => Err(Undefined),
            _ if op2 & 0b111_0000 == 0b010_0000 => data32::register(e, hw1, hw2),
            _ if op2 & 0b111_1000 == 0b011_0000 => multiply::multiply_accumulate(e, hw1, hw2),
            _ if op2 & 0b111_1000 == 0b011_1000 => multiply::long_multiply_divide(e, hw1, hw2),
            _ if op2 & 0b100_0000 != 0 => float::coprocessor(e, hw1, hw2),
            _ => Err(Undefined),
        },
        _ => Err(Undefined),
    }
}

/// Whether a 32-bit encoding is one the DSP extension adds: the rows A5.3's tables mark v7E-M, in
/// Tables A5-12, A5-22, A5-24, A5-27, A5-28 and A5-29, and all of A5-25 and A5-26.
fn dsp_only(hw1: u32, hw2: u32) -> bool {
    let op2 = bits(hw1, 10, 4);
    match bits(hw1, 12, 11) {
        // Table A5-12: SSAT16 and USAT16 are SSAT and USAT with no shift.
        0b10 if bits(hw2, 15, 15) == 0 && bits(hw1, 9, 9) == 1 => {
            matches!(bits(hw1, 8, 4), 0b1_0010 | 0b1_1010)
                && bits(hw2, 14, 12) == 0
                && bits(hw2, 7, 6) == 0
        }
        // Table A5-22: PKHBT and PKHTB.
        0b01 if op2 >> 5 == 0b01 => bits(hw1, 8, 5) == 0b0110,
        0b11 => match op2 >> 3 {
            0b0100 | 0b0101 => register_dsp_only(hw1, hw2),
            // Table A5-28: all but MLA, MUL and MLS.
            0b0110 => bits(hw1, 6, 4) != 0,
            // Table A5-29: the halfword and dual accumulates, and UMAAL.
            0b0111 => match (bits(hw1, 6, 4), bits(hw2, 7, 4)) {
                (0b100, op2) => op2 != 0,
                (0b101, _) | (0b110, 0b0110) => true,
                _ => false,
            },
            _ => false,
        },
        _ => false,
    }
}

/// [`dsp_only`] for Table A5-24, by its `op1` and `op2`: the extends that add or work on byte
/// pairs, the parallel arithmetic of Tables A5-25 and A5-26, and Table A5-27's saturating
/// arithmetic and SEL.
fn register_dsp_only(hw1: u32, hw2: u32) -> bool {
    let (op1, op2) = (bits(hw1, 7, 4), bits(hw2, 7, 4));
    match (op1 >> 3, op2 >> 2) {
        (0, 0b10 | 0b11) => bits(hw1, 3, 0) != 0b1111 || op1 >> 1 == 0b001,
        (1, 0b00 | 0b01) => true,
        (1, 0b10) => matches!(bits(hw1, 5, 4), 0b00 | 0b10),
        _ => false,
    }
}

/// The leave block's cell address for an exit that finds the next block by its key, which no
/// cell's address is, since cells are words.
pub(crate) const FIND: i64 = 1;

#[cfg(test)]
mod tests {
    use super::*;

    /// Every row the tables mark v7E-M is the DSP extension's, and its siblings marked All aren't.
    #[test]
    fn the_dsp_extension_is_the_rows_marked_v7e_m() {
        let dsp = [
            (0xF321_0003, "SSAT16"),
            (0xF3A1_0003, "USAT16"),
            (0xEAC1_0002, "PKHBT"),
            (0xFA01_F082, "SXTAH"),
            (0xFA2F_F082, "SXTB16"),
            (0xFA51_F082, "UXTAB"),
            (0xFA91_F002, "SADD16"),
            (0xFA81_F042, "UADD8"),
            (0xFA81_F082, "QADD"),
            (0xFAA1_F082, "SEL"),
            (0xFB11_F002, "SMULBB"),
            (0xFB71_F002, "USAD8"),
            (0xFBC2_0183, "SMLALBB"),
            (0xFBD2_01C3, "SMLSLD"),
            (0xFBE2_0163, "UMAAL"),
        ];
        let base = [
            (0xF321_0043, "SSAT with a shift"),
            (0xF201_0000, "ADDW"),
            (0xEA01_0002, "AND"),
            (0xFA0F_F082, "SXTH"),
            (0xFA5F_F082, "UXTB"),
            (0xFA01_F002, "LSL"),
            (0xFA91_F081, "REV"),
            (0xFAB1_F081, "CLZ"),
            (0xFB01_F002, "MUL"),
            (0xFB01_3012, "MLS"),
            (0xFB82_0103, "SMULL"),
            (0xFB91_F0F2, "SDIV"),
            (0xFBE2_0103, "UMLAL"),
            (0xF000_B800, "B"),
        ];
        let split = |instruction: u32| (instruction >> 16, instruction & 0xFFFF);
        for (instruction, name) in dsp {
            let (hw1, hw2) = split(instruction);
            assert!(dsp_only(hw1, hw2), "{name}");
        }
        for (instruction, name) in base {
            let (hw1, hw2) = split(instruction);
            assert!(!dsp_only(hw1, hw2), "{name}");
        }
    }
}
