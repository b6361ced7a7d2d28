// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! Translates a block of ARM or Thumb instructions to one host function, DDI 0406C chapters A5, A6
//! and A8.
//!
//! [`translate`] decodes from an address until an instruction ends the block, the next one can't be
//! fetched, or the block is as long as it may be, and lowers each instruction through an
//! [`Emitter`] under its condition. In ARM state, Table A5-1 hands each encoding to its class's
//! function. In Thumb state the R profile's own rows go first, and [`thumb16`] and [`thumb32`]
//! decode the rest. What the lowering needs of this core is [`Family`]'s [`Profile`], in
//! [`profile`].
//!
//! The block's function takes the core, `&mut Family`, and answers why it ended in its low eight
//! bits, one of [`status`], with the instructions it retired above them.

mod arm_alu;
mod arm_branch;
mod arm_data;
mod arm_media;
mod arm_memory;
mod arm_misc;
mod coprocessor;
mod float_r;
mod profile;
#[cfg(any(test, fuzzing))]
pub(crate) mod testing;
mod thumb_r;

use cranelift_codegen::ir::{InstBuilder, MemFlagsData, condcodes::IntCC, types};

use super::family::{Family, offsets};
use crate::cpu::armv7::translate::float::Fpu;
use crate::cpu::armv7::translate::{
    ALWAYS, Cells, Chain, Emitter, Fault, Features, Head, InstructionSet, Profile, Size,
    Translated, bits, it_advance, status, thumb16, thumb32,
};
use crate::emulator::Error;
use crate::emulator::core::{Block, Jit, Place, Tier};
use crate::soc::Endian;

/// How many runs make a quickly translated block worth translating again.
pub(crate) const HOT_RUNS: i64 = 256;

/// The most instructions a block holds.
pub(crate) const LONGEST_BLOCK: u32 = 64;

/// The condition field of the unconditional instructions, A5.7.
const UNCONDITIONAL: u32 = 0b1111;

/// One instruction fetched: an ARM instruction's word, A5.1, or a Thumb instruction's first
/// halfword, and its second when it's 32 bits, A6.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Instruction {
    Arm(u32),
    Narrow(u16),
    Wide(u16, u16),
}

impl Instruction {
    /// Whether `first` starts a 32-bit Thumb instruction, A6.1.
    pub(crate) fn is_wide(first: u16) -> bool {
        matches!(first >> 11, 0b11101..=0b11111)
    }

    fn length(self) -> u32 {
        match self {
            Self::Narrow(_) => 2,
            Self::Arm(_) | Self::Wide(..) => 4,
        }
    }
}

/// What a block is translated from, which its translation depends on: where it starts, the
/// `ITSTATE` there, the most instructions it may hold, the instruction set, the data's byte order
/// and the privilege.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Start {
    pub(crate) pc: u32,
    pub(crate) it: u32,
    pub(crate) longest: u32,
    pub(crate) instruction_set: InstructionSet,
    pub(crate) endian: Endian,
    pub(crate) privileged: bool,
    /// `SCTLR.M`: a block made with the MPU on never chains, so the run loop checks each fetch.
    pub(crate) mpu: bool,
    /// The part's floating-point unit, which never changes, so it's no part of the key.
    pub(crate) fpu: Fpu,
}

impl Start {
    /// The bits of the key an exit can't read from the state it leaves, since they're the next
    /// block's as much as this one's: only an instruction that ends the block changes them.
    pub(crate) fn context(self) -> u64 {
        u64::from(self.endian == Endian::Big) << 49
            | u64::from(self.privileged) << 50
            | u64::from(self.mpu) << 51
    }
}

/// The key of the block at `start`. [`Family::finish`] works it out the same way in code.
pub(crate) fn block_key(start: Start) -> u64 {
    u64::from(start.pc)
        | u64::from(start.it) << 32
        | u64::from(start.longest) << 40
        | u64::from(start.instruction_set == InstructionSet::Thumb) << 48
        | start.context()
}

/// Translates one block from `start`, fetching an instruction's word or halfword with `fetch` in
/// the order the core keeps its instructions and ending before any later instruction `stop_before`
/// answers true for, and answers the block and the first and last byte it came from. An exit to a
/// known address chains through `cells`, and a quick translation counts its runs in `counter`.
#[expect(
    clippy::too_many_arguments,
    reason = "a block's start, its bytes, how it chains and how hard to compile it are each the caller's"
)]
pub(crate) fn translate(
    jit: &mut Jit,
    start: Start,
    fetch: &mut dyn FnMut(u32, Size) -> Option<u32>,
    stop_before: &dyn Fn(u32) -> bool,
    cells: Option<(Cells<'_>, Place)>,
    tier: Tier,
    counter: Option<usize>,
) -> Result<(Block, (u32, u32)), Error> {
    let pointer = jit.pointer();
    let fma = jit.fma();
    // The M profile's DSP instructions are every ARMv7-R core's. A6.3.13 and A6.3.14, for two,
    // give the parallel arithmetic to every core from ARMv6T2.
    let features = Features {
        dsp: true,
        fpu: start.fpu,
        endian: start.endian,
        shortcuts: true,
    };
    let mut range = (start.pc, start.pc);
    let block = jit.compile(tier, |builder, core, signature| {
        let entry = builder.current_block().expect("in the entry block");
        // The builder lays a block out when it first holds an instruction, and the body fills
        // before the entry does, so the entry goes first now.
        builder.func.layout.append_block(entry);
        let body = builder.create_block();
        builder.switch_to_block(body);
        let signature = builder.import_signature(signature.clone());
        let mut e = Emitter::new(builder, pointer, features, start.instruction_set);
        e.fma = fma;
        e.chain = cells.map(|(cells, recent)| Chain {
            cells,
            signature,
            recent,
            space: 0,
        });
        // The registers, the flags and the budget are read in `body`, and each pass round the
        // block starts after them, at `head`.
        let head = e.b.create_block();
        e.b.ins().jump(head, &[]);
        e.b.switch_to_block(head);
        // A block that starts at a breakpoint, run once to pass it, leaves at its back edge, so
        // the next lap stops there.
        e.head = (!stop_before(start.pc)).then_some(Head {
            pc: start.pc,
            it: start.it,
            block: head,
            looped: false,
        });
        range = lower_block(&mut e, start, fetch, stop_before);
        Family::finish(&mut e, start.context());
        e.b.switch_to_block(entry);
        let budget =
            e.b.ins()
                .load(types::I32, MemFlagsData::trusted(), core, offsets::BUDGET);
        let short = e.b.ins().icmp_imm_s(IntCC::Equal, budget, 0);
        let refuse = e.b.create_block();
        if let Some(address) = counter {
            // A quick translation counts its runs, and hands back untouched once they make it
            // worth translating again.
            let count = e.b.create_block();
            e.b.ins().brif(short, refuse, &[], count, &[]);
            e.b.seal_block(count);
            e.b.switch_to_block(count);
            let counter =
                e.b.ins()
                    .iconst(pointer, i64::try_from(address).expect("an address"));
            let runs = e.b.ins().load(pointer, MemFlagsData::trusted(), counter, 0);
            let runs = e.b.ins().iadd_imm_s(runs, 1);
            e.b.ins().store(MemFlagsData::trusted(), runs, counter, 0);
            let hot = e.b.ins().icmp_imm_s(IntCC::Equal, runs, HOT_RUNS);
            let promote = e.b.create_block();
            e.b.ins().brif(hot, promote, &[], body, &[]);
            e.b.seal_block(promote);
            e.b.switch_to_block(promote);
            let answer = e.constant(status::HOT);
            e.b.ins().return_(&[answer]);
        } else {
            e.b.ins().brif(short, refuse, &[], body, &[]);
        }
        e.b.seal_block(body);
        e.b.seal_block(head);
        e.b.seal_block(refuse);
        e.b.switch_to_block(refuse);
        let answer = e.constant(status::SHORT);
        e.b.ins().return_(&[answer]);
    })?;
    Ok((block, range))
}

/// Lowers the block's instructions from `start`, up to a breakpoint past its first, and answers
/// the first and last byte they came from.
fn lower_block(
    e: &mut Emitter<'_, '_, Family>,
    start: Start,
    fetch: &mut dyn FnMut(u32, Size) -> Option<u32>,
    stop_before: &dyn Fn(u32) -> bool,
) -> (u32, u32) {
    let mut range = (start.pc, start.pc);
    let mut pc = start.pc;
    let mut it = start.it;
    let mut count = 0;
    loop {
        if count == start.longest || (count > 0 && stop_before(pc)) {
            // The block ends where the next instruction starts, which it hasn't run: the last
            // one it ran stands as the one that retired.
            e.index = count - 1;
            e.next_it = Some(it);
            e.exit_to_known(pc);
            break;
        }
        let Some(instruction) = fetch_one(fetch, pc, start.instruction_set) else {
            // A wide instruction's first halfword was fetched, and a change to it drops this
            // block too.
            if start.instruction_set == InstructionSet::Thumb && fetch(pc, Size::Halfword).is_some()
            {
                range.1 = pc + 1;
            }
            e.begin(count, pc, 2, it);
            Family::raise(e, Fault::InstructionFetch);
            break;
        };
        e.begin(count, pc, instruction.length(), it);
        range.1 = pc + instruction.length() - 1;
        emit_one(e, instruction);
        count += 1;
        if e.ended() {
            break;
        }
        e.stop_if_spent(count);
        it = e.next_it.take().unwrap_or_else(|| it_advance(it));
        pc = e.next_pc();
    }
    range
}

/// The instruction at `pc` in `set`, or `None` where it can't be fetched.
fn fetch_one(
    fetch: &mut dyn FnMut(u32, Size) -> Option<u32>,
    pc: u32,
    set: InstructionSet,
) -> Option<Instruction> {
    let halfword = |fetched: u32| u16::try_from(fetched).expect("a halfword");
    if set == InstructionSet::Arm {
        return fetch(pc, Size::Word).map(Instruction::Arm);
    }
    let first = halfword(fetch(pc, Size::Halfword)?);
    if !Instruction::is_wide(first) {
        return Some(Instruction::Narrow(first));
    }
    let second = halfword(fetch(pc.wrapping_add(2), Size::Halfword)?);
    Some(Instruction::Wide(first, second))
}

/// Lowers one instruction under its condition, [`condition`]'s. One that fails its condition is
/// a NOP, UNDEFINED or not, B1.9.2.
fn emit_one(e: &mut Emitter<'_, '_, Family>, instruction: Instruction) {
    let cond = condition(instruction, e.it);
    e.under_condition(cond, |e| decode(e, instruction));
}

/// The condition `instruction` runs under with `ITSTATE` `it`: an ARM instruction's own, A8.3, and
/// a Thumb instruction's IT block's, A8.3.1, or [`ALWAYS`] for one that's [`unconditional`].
fn condition(instruction: Instruction, it: u32) -> u32 {
    match instruction {
        _ if unconditional(instruction) => ALWAYS,
        Instruction::Arm(word) => word >> 28,
        _ if it & 0xF != 0 => it >> 4,
        _ => ALWAYS,
    }
}

/// Whether `instruction` runs whatever its condition: ARM state's unconditional instructions,
/// A5.7, and `BKPT`, which A2.5.2 says can't be conditional. A8.8.24 makes an ARM `BKPT` with a
/// condition other than AL UNPREDICTABLE, and the core runs it as it would with AL.
fn unconditional(instruction: Instruction) -> bool {
    match instruction {
        Instruction::Arm(word) => word >> 28 == UNCONDITIONAL || word & 0x0FF0_00F0 == 0x0120_0070,
        Instruction::Narrow(hw) => hw >> 8 == 0b1011_1110,
        Instruction::Wide(..) => false,
    }
}

/// Decodes one instruction to its class, and raises UNDEFINED for one no class defines.
fn decode(e: &mut Emitter<'_, '_, Family>, instruction: Instruction) {
    let translated = match instruction {
        Instruction::Arm(word) => ArmClass::of(word).lower(e, word),
        Instruction::Narrow(hw) => decode16(e, hw),
        Instruction::Wide(hw1, hw2) => decode32(e, hw1, hw2),
    };
    if translated.is_err() {
        Family::raise(e, Fault::Undefined);
    }
}

/// An ARM instruction's class, by Table A5-1, and inside data processing and the miscellaneous
/// instructions by Table A5-2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ArmClass {
    Register,
    RegisterShiftedRegister,
    Immediate,
    MoveWide,
    WordUnsignedByte,
    Extra,
    ExtraUnprivileged,
    Synchronization,
    Media,
    Multiply,
    Saturating,
    HalfwordMultiply,
    Miscellaneous,
    MsrImmediateHints,
    BranchBlockTransfer,
    CoprocessorSupervisorCall,
    Unconditional,
}

impl ArmClass {
    /// Table A5-1, by `cond`, `op1`, bits 27 to 25, and `op`, bit 4.
    fn of(word: u32) -> Self {
        if word >> 28 == UNCONDITIONAL {
            return Self::Unconditional;
        }
        match bits(word, 27, 25) {
            0b000 | 0b001 => Self::data_processing_miscellaneous(word),
            0b010 => Self::WordUnsignedByte,
            0b011 if bits(word, 4, 4) == 0 => Self::WordUnsignedByte,
            0b011 => Self::Media,
            0b100 | 0b101 => Self::BranchBlockTransfer,
            _ => Self::CoprocessorSupervisorCall,
        }
    }

    /// Table A5-2, by `op`, bit 25, `op1`, bits 24 to 20, and `op2`, bits 7 to 4.
    fn data_processing_miscellaneous(word: u32) -> Self {
        let op1 = bits(word, 24, 20);
        let op2 = bits(word, 7, 4);
        // `op1` of 10xx0 is the space the tests and compares leave free, since they always set
        // the flags.
        let free = op1 & 0b1_1001 == 0b1_0000;
        if bits(word, 25, 25) == 1 {
            return match op1 {
                0b1_0000 | 0b1_0100 => Self::MoveWide,
                _ if free => Self::MsrImmediateHints,
                _ => Self::Immediate,
            };
        }
        match op2 {
            0b1001 if op1 >> 4 == 0 => Self::Multiply,
            0b1001 => Self::Synchronization,
            0b1011 | 0b1101 | 0b1111 if op1 & 0b1_0010 == 0b0_0010 => Self::ExtraUnprivileged,
            0b1011 | 0b1101 | 0b1111 => Self::Extra,
            // A5.2.12's Table A5-14 hands its `op2` of 101 to A5.2.6.
            0b0101 if free => Self::Saturating,
            _ if free && op2 >> 3 == 0 => Self::Miscellaneous,
            _ if free => Self::HalfwordMultiply,
            _ if op2 & 1 == 0 => Self::Register,
            _ => Self::RegisterShiftedRegister,
        }
    }

    /// Lowers `word`, an instruction of this class.
    fn lower(self, e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
        match self {
            Self::Register => {
                arm_data::register(e, word);
                Ok(())
            }
            Self::RegisterShiftedRegister => arm_data::register_shifted_register(e, word),
            Self::Immediate => {
                arm_data::immediate(e, word);
                Ok(())
            }
            Self::MoveWide => arm_data::move_wide(e, word),
            Self::WordUnsignedByte => arm_memory::word_unsigned_byte(e, word),
            Self::Extra => arm_memory::extra(e, word),
            Self::ExtraUnprivileged => arm_memory::extra_unprivileged(e, word),
            Self::Synchronization => arm_memory::synchronization(e, word),
            Self::Media => arm_media::media(e, word),
            Self::Multiply => arm_media::multiply(e, word),
            Self::Saturating => arm_media::saturating(e, word),
            Self::HalfwordMultiply => arm_media::halfword_multiply(e, word),
            Self::Miscellaneous => arm_misc::miscellaneous(e, word),
            Self::MsrImmediateHints => {
                arm_misc::msr_immediate_hints(e, word);
                Ok(())
            }
            Self::BranchBlockTransfer => arm_branch::branch_block_transfer(e, word),
            Self::CoprocessorSupervisorCall => coprocessor::coprocessor_supervisor_call(e, word),
            Self::Unconditional => arm_misc::unconditional(e, word),
        }
    }
}

/// Where a Thumb instruction goes: one of the R profile's own rows, which go ahead of the ones both
/// profiles share, or a shared one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ThumbRow {
    Miscellaneous16,
    ConditionalBranchSupervisorCall,
    Branch16,
    BranchesMiscellaneousControl,
    ReturnState,
    Coprocessor,
    Shared,
}

impl ThumbRow {
    /// A 16-bit instruction's row, by Table A6-1's `opcode`, bits 15 to 10.
    fn narrow(hw: u16) -> Self {
        let hw = u32::from(hw);
        match bits(hw, 15, 10) {
            0b10_1100..=0b10_1111 if own_miscellaneous16(hw) => Self::Miscellaneous16,
            0b11_0100..=0b11_0111 => Self::ConditionalBranchSupervisorCall,
            0b11_1000 | 0b11_1001 => Self::Branch16,
            _ => Self::Shared,
        }
    }

    /// A 32-bit instruction's row, by Table A6-9's `op1`, bits 12 and 11 of its first halfword,
    /// `op2`, bits 10 to 4, and `op`, bit 15 of its second.
    fn wide(hw1: u16, hw2: u16) -> Self {
        let (first, second) = (u32::from(hw1), u32::from(hw2));
        let op2 = bits(first, 10, 4);
        match bits(first, 12, 11) {
            0b10 if bits(second, 15, 15) == 1 => Self::BranchesMiscellaneousControl,
            // Table A6-16's `SRS` and `RFE`, by its `op` of 00 or 11.
            0b01 if op2 & 0b110_0100 == 0 && matches!(bits(first, 8, 7), 0b00 | 0b11) => {
                Self::ReturnState
            }
            // Table A6-30: every coprocessor's but the floating-point extension's, CP10 and CP11.
            0b01 | 0b11 if op2 >> 6 == 1 && bits(second, 11, 9) != 0b101 => Self::Coprocessor,
            _ => Self::Shared,
        }
    }
}

/// Whether a miscellaneous 16-bit instruction is one of the R profile's own rows of Table A6-6, by
/// `opcode`, bits 11 to 5: `CBZ` and `CBNZ`, `SETEND`, `CPS`, `BKPT`, and `IT` and the hints.
fn own_miscellaneous16(hw: u32) -> bool {
    let opcode = bits(hw, 11, 5);
    opcode & 0b010_1000 == 0b000_1000 || opcode >> 1 == 0b011_001 || opcode >> 4 == 0b111
}

/// A 16-bit instruction: the R profile's own rows here, and the rest by [`thumb16`].
fn decode16(e: &mut Emitter<'_, '_, Family>, hw: u16) -> Translated {
    match ThumbRow::narrow(hw) {
        ThumbRow::Miscellaneous16 => thumb_r::miscellaneous16(e, hw),
        ThumbRow::ConditionalBranchSupervisorCall => {
            thumb_r::conditional_branch_supervisor_call(e, hw)
        }
        ThumbRow::Branch16 => thumb_r::branch16(e, hw),
        _ => thumb16(e, hw),
    }
}

/// A 32-bit instruction: the R profile's own rows here, and the rest by [`thumb32`].
fn decode32(e: &mut Emitter<'_, '_, Family>, hw1: u16, hw2: u16) -> Translated {
    match ThumbRow::wide(hw1, hw2) {
        ThumbRow::BranchesMiscellaneousControl => {
            thumb_r::branches_miscellaneous_control(e, hw1, hw2)
        }
        ThumbRow::ReturnState => thumb_r::return_state(e, hw1, hw2),
        ThumbRow::Coprocessor => thumb_r::coprocessor(e, hw1, hw2),
        _ if float_r::owns(hw1, hw2) => float_r::system_register(e, hw1, hw2),
        _ => thumb32(e, hw1, hw2),
    }
}

#[cfg(test)]
mod tests {
    use super::super::exception::Exception;
    use super::super::family::helpers;
    use super::super::registers::sctlr;
    use super::testing::{Bench, RAM, SIZE, SPUN};
    use super::*;
    use crate::cpu::armv7::registers::mask;

    const BOTH: [Endian; 2] = [Endian::Little, Endian::Big];
    /// Table A5-16's last row, `UDF` with AL and UNDEFINED with any other condition, which stays
    /// UNDEFINED in ARM state whatever the core lowers, with its condition field clear.
    const UNDEFINED_ARM: u32 = 0x07F0_00F0;
    /// An encoding of A5.7's unconditional space that Table A5-23 leaves UNDEFINED.
    const UNDEFINED_UNCONDITIONAL: u32 = 0xFFF0_00F0;

    /// A bench on a part in `endian` that's run every instruction of Thumb `code` after
    /// `prepare`, each retiring.
    fn thumb_after(endian: Endian, code: &[u16], prepare: impl FnOnce(&mut Family)) -> Bench {
        let mut bench = Bench::thumb(endian, code);
        prepare(&mut bench.core);
        let instructions = instructions_in(code);
        let (_, ran) = bench.run(instructions);
        assert_eq!(
            ran,
            u64::from(instructions),
            "{endian:?}: every instruction retires"
        );
        assert_eq!(bench.taken(), None, "{endian:?}");
        bench
    }

    /// How many instructions `code`'s halfwords make, A6.1.
    fn instructions_in(code: &[u16]) -> u32 {
        let mut count = 0;
        let mut at = 0;
        while at < code.len() {
            at += if Instruction::is_wide(code[at]) { 2 } else { 1 };
            count += 1;
        }
        count
    }

    /// One instruction lowered by `lower` at `0x100` in `set`, run once on its own, and the bench
    /// it ran on.
    fn built(set: InstructionSet, lower: impl FnOnce(&mut Emitter<'_, '_, Family>)) -> Bench {
        let mut bench = Bench::arm(Endian::Little, &[]);
        helpers::run_built(&mut bench.core, |builder, core, _| {
            let pointer = builder.func.dfg.value_type(core);
            let features = Features {
                dsp: true,
                fpu: Fpu::None,
                endian: Endian::Little,
                shortcuts: true,
            };
            let mut e = Emitter::new(builder, pointer, features, set);
            e.begin(0, 0x100, 4, 0);
            lower(&mut e);
            Family::finish(&mut e, 0);
        });
        bench
    }

    /// The shared groups' 16-bit and 32-bit data processing, A6.2.1, A6.2.2 and A6.3.3, set the
    /// flags and registers they do on the M core, fetched in either byte order.
    #[test]
    fn thumb_data_processing_runs_through_the_shared_groups() {
        let code = [
            0x2000, // MOVS r0, #0
            0x3801, // SUBS r0, #1
            0x1C81, // ADDS r1, r0, #2
            0x4041, // EORS r1, r0
            0xF201, 0x1200, // ADDW r2, r1, #0x100
        ];
        for endian in BOTH {
            let state = thumb_after(endian, &code, |_| {}).core.state;
            assert_eq!(
                (state.r[0], state.r[1], state.r[2]),
                (0xFFFF_FFFF, 0xFFFF_FFFE, 0xFE),
                "{endian:?}"
            );
            assert_eq!(
                (state.n, state.z, state.c, state.v),
                (1, 0, 1, 0),
                "{endian:?}"
            );
        }
    }

    /// A3.3: a store lays a word's bytes out in the data's byte order, a load reads them back that
    /// way, and with `SCTLR.A` clear an unaligned word is read a byte at a time, A3.2.1.
    #[test]
    fn thumb_loads_and_stores_follow_the_data_byte_order() {
        let code = [
            0x6011, // STR r1, [r2]
            0x7813, // LDRB r3, [r2]
            0x8854, // LDRH r4, [r2, #2]
            0x7111, // STRB r1, [r2, #4]
            0x6855, // LDR r5, [r2, #4]
            0x683E, // LDR r6, [r7]
        ];
        let prepare = |core: &mut Family| {
            core.state.r[1] = 0x1122_3344;
            core.state.r[2] = RAM;
            core.state.r[7] = RAM + 1;
        };
        for (endian, bytes, loaded) in [
            (
                Endian::Little,
                [0x44, 0x33, 0x22, 0x11, 0x44],
                [0x44, 0x1122, 0x44, 0x4411_2233],
            ),
            (
                Endian::Big,
                [0x11, 0x22, 0x33, 0x44, 0x44],
                [0x11, 0x3344, 0x4400_0000, 0x2233_4444],
            ),
        ] {
            let bench = thumb_after(endian, &code, prepare);
            let stored: Vec<u8> = (RAM..RAM + 5).map(|at| bench.byte(at)).collect();
            assert_eq!(stored, bytes, "{endian:?}");
            assert_eq!(bench.core.state.r[3..7], loaded, "{endian:?}");
        }
    }

    /// The shared multiplies and divides, A6.2.2 and A6.3.17: `MULS`, `UMULL` and `SDIV`.
    #[test]
    fn thumb_multiplies_and_divides_run_through_the_shared_groups() {
        let code = [
            0x4348, // MULS r0, r1, r0
            0xFBA4, 0x2305, // UMULL r2, r3, r4, r5
            0xFB97, 0xF6F1, // SDIV r6, r7, r1
        ];
        for endian in BOTH {
            let state = thumb_after(endian, &code, |core| {
                core.state.r[..2].copy_from_slice(&[7, 3]);
                core.state.r[4..6].copy_from_slice(&[0xFFFF_FFFF, 2]);
                core.state.r[7] = (-21_i32).cast_unsigned();
            })
            .core
            .state;
            assert_eq!(
                (state.r[0], state.r[2], state.r[3], state.r[6]),
                (21, 0xFFFF_FFFE, 1, (-7_i32).cast_unsigned()),
                "{endian:?}"
            );
        }
    }

    /// DDI 0460D 4.3.16: with `SCTLR.DZ` set a divide by zero is the Undefined Instruction
    /// exception, and with it clear the quotient is zero, A8.8.165.
    #[test]
    fn a_divide_by_zero_traps_only_with_sctlr_dz_set() {
        let sdiv = [0xFB97, 0xF6F1];
        let quotient = thumb_after(Endian::Little, &sdiv, |core| core.state.r[6] = 5);
        assert_eq!(quotient.core.state.r[6], 0);
        let mut bench = Bench::thumb(Endian::Little, &sdiv);
        bench.core.sctlr |= mask(sctlr::DZ);
        assert_eq!(bench.run(1).1, SPUN);
        assert_eq!(bench.raised(), Some((Exception::Undefined, 0)));
    }

    /// DDI 0406C B1.3.2: the R profile's `R[]` takes the SP as written, where the M profile's
    /// drops its bottom two bits.
    #[test]
    fn the_stack_pointer_keeps_its_low_bits() {
        let add_sp = [0x448D]; // ADD sp, r1
        let bench = thumb_after(Endian::Little, &add_sp, |core| core.state.r[1] = 1);
        let top = RAM + u32::try_from(SIZE).unwrap();
        assert_eq!(bench.core.state.r[13], top + 1);
    }

    /// The rows the R profile decodes itself, its branches, its system instructions, `SRS` and
    /// `RFE`, and its coprocessors but CP10 and CP11, go ahead of the shared ones, and the rows
    /// beside them don't.
    #[test]
    fn the_r_profiles_own_thumb_rows_go_ahead_of_the_shared_ones() {
        use ThumbRow::{
            Branch16, BranchesMiscellaneousControl, ConditionalBranchSupervisorCall, Coprocessor,
            Miscellaneous16, ReturnState, Shared,
        };
        let narrow = [
            (0xE7FE, Branch16),                        // B .
            (0xD0FE, ConditionalBranchSupervisorCall), // BEQ .
            (0xDE00, ConditionalBranchSupervisorCall), // UDF #0
            (0xDF00, ConditionalBranchSupervisorCall), // SVC #0
            (0xB100, Miscellaneous16),                 // CBZ r0
            (0xB900, Miscellaneous16),                 // CBNZ r0
            (0xBE00, Miscellaneous16),                 // BKPT #0
            (0xBF08, Miscellaneous16),                 // IT EQ
            (0xBF00, Miscellaneous16),                 // NOP
            (0xB672, Miscellaneous16),                 // CPSID i
            (0xB658, Miscellaneous16),                 // SETEND BE
            (0xB081, Shared),                          // SUB sp, #4
            (0xB200, Shared),                          // SXTH r0, r0
            (0xB401, Shared),                          // PUSH {r0}
            (0xBA00, Shared),                          // REV r0, r0
            (0xBC01, Shared),                          // POP {r0}
            (0xC002, Shared),                          // STM r0!, {r1}
            (0xC806, Shared),                          // LDM r0!, {r1, r2}
            (0x4770, Shared),                          // BX lr
        ];
        let wide = [
            (0xF7FF, 0xBFFE, BranchesMiscellaneousControl), // B.W .
            (0xF3EF, 0x8000, BranchesMiscellaneousControl), // MRS r0, CPSR
            (0xF7F0, 0xA000, BranchesMiscellaneousControl), // UDF.W #0
            (0xE82D, 0xC013, ReturnState),                  // SRSDB sp!, #19
            (0xE990, 0xC000, ReturnState),                  // RFEIA r0
            (0xEE11, 0x0F10, Coprocessor),                  // MRC p15, 0, r0, c1, c0, 0
            (0xE8A0, 0x0006, Shared),                       // STM.W r0!, {r1, r2}
            (0xE910, 0x0006, Shared),                       // LDMDB r0, {r1, r2}
            (0xE92D, 0x0003, Shared),                       // PUSH.W {r0, r1}
            (0xE8BD, 0x0003, Shared),                       // POP.W {r0, r1}
            (0xE9D7, 0x0100, Shared),                       // LDRD r0, r1, [r7]
            (0xEE30, 0x0A00, Shared),                       // VADD.F32 s0, s0, s0
            (0xF201, 0x1200, Shared),                       // ADDW r2, r1, #0x100
        ];
        for (hw, row) in narrow {
            assert_eq!(ThumbRow::narrow(hw), row, "{hw:#06x}");
        }
        for (hw1, hw2, row) in wide {
            assert_eq!(ThumbRow::wide(hw1, hw2), row, "{hw1:#06x} {hw2:#06x}");
        }
    }

    /// A8.8.57, A8.8.60, A8.8.131, A8.8.133 and A8.8.199: the load and store multiples, `PUSH` and
    /// `POP`, in both widths, run through the shared groups.
    #[test]
    fn the_thumb_load_and_store_multiples_run_through_the_shared_groups() {
        let code: [&[u16]; 8] = [
            &[0xC002],         // STM r0!, {r1}
            &[0xC806],         // LDM r0!, {r1, r2}
            &[0xE8A0, 0x0006], // STM.W r0!, {r1, r2}
            &[0xE910, 0x0006], // LDMDB r0, {r1, r2}
            &[0xB401],         // PUSH {r0}
            &[0xBC01],         // POP {r0}
            &[0xE92D, 0x0003], // PUSH.W {r0, r1}
            &[0xE8BD, 0x0003], // POP.W {r0, r1}
        ];
        for code in code {
            thumb_after(Endian::Big, code, |core| {
                core.state.r[0] = RAM + 0x40;
                core.state.r[13] = RAM + 0x100;
            });
        }
    }

    /// Words from every row of Table A5-1, and of Table A5-2 with Table A5-14's hand-off to
    /// A5.2.6, in the class the tables give them.
    const ARM_CLASSES: [(u32, ArmClass); 49] = [
        (0xE081_0002, ArmClass::Register),                // ADD r0, r1, r2
        (0xE110_0001, ArmClass::Register),                // TST r0, r1
        (0x1081_0002, ArmClass::Register),                // ADDNE r0, r1, r2
        (0xE091_0312, ArmClass::RegisterShiftedRegister), // ADDS r0, r1, r2, LSL r3
        (0xE281_0001, ArmClass::Immediate),               // ADD r0, r1, #1
        (0xE350_0001, ArmClass::Immediate),               // CMP r0, #1
        (0xE301_0234, ArmClass::MoveWide),                // MOVW r0, #0x1234
        (0xE341_0234, ArmClass::MoveWide),                // MOVT r0, #0x1234
        (0xE591_0000, ArmClass::WordUnsignedByte),        // LDR r0, [r1]
        (0xE7C1_0002, ArmClass::WordUnsignedByte),        // STRB r0, [r1, r2]
        (0xE1D1_00B0, ArmClass::Extra),                   // LDRH r0, [r1]
        (0xE1C2_00D0, ArmClass::Extra),                   // LDRD r0, r1, [r2]
        (0xE1C1_00B2, ArmClass::Extra),                   // STRH r0, [r1, #2]
        (0xE0F1_00B0, ArmClass::ExtraUnprivileged),       // LDRHT r0, [r1]
        (0xE0E1_00B0, ArmClass::ExtraUnprivileged),       // STRHT r0, [r1]
        (0xE191_0F9F, ArmClass::Synchronization),         // LDREX r0, [r1]
        (0xE102_0091, ArmClass::Synchronization),         // SWP r0, r1, [r2]
        (0xE651_0F92, ArmClass::Media),                   // UADD8 r0, r1, r2
        (0xE710_F211, ArmClass::Media),                   // SDIV r0, r1, r2
        (0xE000_0291, ArmClass::Multiply),                // MUL r0, r1, r2
        (0xE081_0392, ArmClass::Multiply),                // UMULL r0, r1, r2, r3
        (0xE102_0051, ArmClass::Saturating),              // QADD r0, r1, r2
        (0xE100_3281, ArmClass::HalfwordMultiply),        // SMLABB r0, r1, r2, r3
        (0xE160_0281, ArmClass::HalfwordMultiply),        // SMULBB r0, r1, r2
        (0xE12F_FF1E, ArmClass::Miscellaneous),           // BX lr
        (0xE16F_0F11, ArmClass::Miscellaneous),           // CLZ r0, r1
        (0xE10F_0000, ArmClass::Miscellaneous),           // MRS r0, CPSR
        (0xE129_F000, ArmClass::Miscellaneous),           // MSR CPSR_fc, r0
        (0xE120_0070, ArmClass::Miscellaneous),           // BKPT #0
        (0xE12F_FF30, ArmClass::Miscellaneous),           // BLX r0
        (0xE320_F000, ArmClass::MsrImmediateHints),       // NOP
        (0xE320_F003, ArmClass::MsrImmediateHints),       // WFI
        (0xE328_F20F, ArmClass::MsrImmediateHints),       // MSR CPSR_f, #0xF0000000
        (0xEAFF_FFFE, ArmClass::BranchBlockTransfer),     // B .
        (0xEBFF_FFFE, ArmClass::BranchBlockTransfer),     // BL .
        (0xE890_0002, ArmClass::BranchBlockTransfer),     // LDM r0, {r1}
        (0xE92D_4010, ArmClass::BranchBlockTransfer),     // PUSH {r4, lr}
        (0xEF00_0000, ArmClass::CoprocessorSupervisorCall), // SVC #0
        (0xEE01_0F10, ArmClass::CoprocessorSupervisorCall), // MCR p15, 0, r0, c1, c0, 0
        (0xEE30_0A00, ArmClass::CoprocessorSupervisorCall), // VADD.F32 s0, s0, s0
        (0xED90_0B00, ArmClass::CoprocessorSupervisorCall), // VLDR d0, [r0]
        (0xF10C_0080, ArmClass::Unconditional),           // CPSID i
        (0xF101_0200, ArmClass::Unconditional),           // SETEND BE
        (0xFAFF_FFFE, ArmClass::Unconditional),           // BLX .
        (0xF57F_F04F, ArmClass::Unconditional),           // DSB SY
        (0xF96D_0513, ArmClass::Unconditional),           // SRSDB sp!, #19
        (0xF890_0A00, ArmClass::Unconditional),           // RFEIA r0
        (0xE7F0_00F0, ArmClass::Media),                   // UDF #0
        (UNDEFINED_UNCONDITIONAL, ArmClass::Unconditional),
    ];

    #[test]
    fn table_a5_1_puts_every_arm_encoding_in_its_class() {
        for (word, class) in ARM_CLASSES {
            assert_eq!(ArmClass::of(word), class, "{word:#010x}");
        }
    }

    /// Whether Table A8-1 says `cond`, below `ALWAYS`, holds with N, Z, C and V the bits of
    /// `flags` from 3 down to 0.
    fn passes(cond: u32, flags: u32) -> bool {
        let [n, z, c, v] = [3, 2, 1, 0].map(|bit| flags >> bit & 1 == 1);
        let holds = match cond >> 1 {
            0b000 => z,
            0b001 => c,
            0b010 => n,
            0b011 => v,
            0b100 => c && !z,
            0b101 => n == v,
            _ => !z && n == v,
        };
        holds != (cond & 1 == 1)
    }

    /// A8.3: an ARM instruction runs where its condition holds, and is a NOP where it fails, even
    /// one that's UNDEFINED, B1.9.2. The one after it runs either way.
    #[test]
    fn an_arm_instruction_runs_only_where_its_condition_holds() {
        for cond in 0..ALWAYS {
            for flags in 0..16_u32 {
                let code = [cond << 28 | UNDEFINED_ARM, ALWAYS << 28 | UNDEFINED_ARM];
                let mut bench = Bench::arm(Endian::Little, &code);
                let state = &mut bench.core.state;
                [state.n, state.z, state.c, state.v] = [3, 2, 1, 0].map(|bit| flags >> bit & 1);
                let (_, ran) = bench.run(2);
                let at = if passes(cond, flags) { 0 } else { 4 };
                assert_eq!(
                    (ran, bench.raised()),
                    (u64::from(at / 4) + SPUN, Some((Exception::Undefined, at))),
                    "cond {cond:04b} flags {flags:04b}"
                );
            }
        }
    }

    /// A5.7: an instruction whose condition field is 0b1111 runs whatever the flags.
    #[test]
    fn the_unconditional_space_runs_whatever_the_flags() {
        for flags in 0..16_u32 {
            let mut bench = Bench::arm(Endian::Big, &[UNDEFINED_UNCONDITIONAL]);
            let state = &mut bench.core.state;
            [state.n, state.z, state.c, state.v] = [3, 2, 1, 0].map(|bit| flags >> bit & 1);
            assert_eq!(bench.run(1).1, SPUN);
            assert_eq!(
                bench.raised(),
                Some((Exception::Undefined, 0)),
                "flags {flags:04b}"
            );
        }
    }

    /// The condition an instruction runs under: an ARM instruction's own, but for the
    /// unconditional space, A5.7, and `BKPT`, A8.8.24, and a Thumb instruction's IT block's, but
    /// for `BKPT`, A2.5.2.
    #[test]
    fn bkpt_and_the_unconditional_space_run_under_no_condition() {
        let in_it = 0b0001_1000; // NE, the last of its block
        for (instruction, it, cond) in [
            (Instruction::Arm(0x1081_0002), 0, 0b0001), // ADDNE r0, r1, r2
            (Instruction::Arm(0x1120_0070), 0, ALWAYS), // BKPT with NE
            (Instruction::Arm(UNDEFINED_UNCONDITIONAL), 0, ALWAYS),
            (Instruction::Narrow(0x4408), in_it, 0b0001), // ADD r0, r1
            (Instruction::Narrow(0xBE00), in_it, ALWAYS), // BKPT #0
            (Instruction::Narrow(0x4408), 0, ALWAYS),
            (Instruction::Wide(0xF201, 0x1200), in_it, 0b0001), // ADDW r2, r1, #0x100
        ] {
            assert_eq!(condition(instruction, it), cond, "{instruction:x?}");
        }
    }

    /// DDI 0406C B1.3.2's `R[]` reads the PC as its instruction's address plus 8 in ARM state and
    /// plus 4 in Thumb state, and A2.3.2's `BranchWritePC()` clears bits 1 and 0 of its target in
    /// ARM state and only bit 0 in Thumb state.
    #[test]
    fn the_pc_and_a_branch_follow_the_instruction_set() {
        for (set, read, target) in [
            (InstructionSet::Arm, 0x108, 0x1000),
            (InstructionSet::Thumb, 0x104, 0x1002),
        ] {
            let bench = built(set, |e| {
                let pc = e.reg(15);
                e.set_reg(0, pc);
                let to = e.constant(0x1003);
                e.branch(to);
            });
            assert_eq!(
                (bench.core.state.r[0], bench.core.state.r[15]),
                (read, target),
                "{set:?}"
            );
        }
    }

    /// A2.3.2's `BXWritePC()`: bit 0 of the target picks Thumb state or ARM state, and an ARM
    /// target with bit 1 set, which is UNPREDICTABLE, is aligned as `BranchWritePC()` would.
    #[test]
    fn an_interworking_branch_picks_the_instruction_set_from_bit_0() {
        for (address, thumb, target) in [
            (0x2001, 1, 0x2000),
            (0x2004, 0, 0x2004),
            (0x2006, 0, 0x2004),
        ] {
            let bench = built(InstructionSet::Arm, |e| {
                let to = e.constant(address);
                Family::branch_exchange(e, to);
            });
            assert_eq!(
                (bench.core.state.t, bench.core.state.r[15]),
                (thumb, target),
                "{address:#x}"
            );
        }
    }
}
