// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! Translates a block of Thumb instructions to one host function, DDI 0403E.b chapters A5 to A7.
//!
//! [`translate`] decodes from an address until an instruction ends the block, the next one has a
//! breakpoint, can't be fetched, or the block is as long as it may be, and lowers each instruction
//! through an [`Emitter`]. The branches and the system instructions are this profile's own, in
//! [`control`], and [`thumb16`] and [`thumb32`] decode the rest. What the lowering needs of this
//! core is [`Family`]'s [`Profile`], in [`profile`].
//!
//! The block's function takes the core, `&mut Family`, and answers why it ended in its low eight
//! bits, one of [`status`], with the instructions it retired above them.

mod control;
mod profile;
#[cfg(any(test, fuzzing))]
pub(crate) mod testing;

use std::cell::RefCell;

use cranelift_codegen::ir::{InstBuilder, JumpTableData, MemFlagsData, condcodes::IntCC, types};

use super::family::{Family, offsets};
use super::shared::{self, Asked, Translation, Wanted};
use crate::cpu::armv7::translate::{
    ALWAYS, Chain, Emitter, Fault, Head, InstructionSet, Profile, Translated, Undefined, bits,
    compare_branch, it_advance, status, thumb16, thumb32,
};
use crate::emulator::Error;
use crate::emulator::core::{Jit, Place, Tier};

/// How many runs make a quickly translated block worth translating again.
pub(crate) const HOT_RUNS: i64 = 256;

/// The most instructions a block holds.
pub(crate) const LONGEST_BLOCK: u32 = 64;

/// One instruction fetched: its first halfword, and its second when it's 32 bits, A5.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Instruction {
    Narrow(u16),
    Wide(u16, u16),
}

impl Instruction {
    /// Whether `first` starts a 32-bit instruction, A5.1.
    pub(crate) fn is_wide(first: u16) -> bool {
        matches!(first >> 11, 0b11101..=0b11111)
    }

    fn length(self) -> u32 {
        match self {
            Self::Narrow(_) => 2,
            Self::Wide(..) => 4,
        }
    }

    /// Whether it's one of B1.5.10's exception-continuable instructions on a core with the
    /// floating-point extension when `fp`: `STM` and `LDM`, Table A5-1, `PUSH` and `POP`, A5.2.5,
    /// the wide `STM`, `LDM`, `STMDB`, `LDMDB`, `PUSH` and `POP`, Table A5-16, and only with the
    /// extension, `VSTM`, `VLDM`, `VPUSH` and `VPOP`, Table A6-7. `VSTR` and `VLDR` are the rows
    /// of that table with `P` set and `W` clear, and aren't.
    fn continuable(self, fp: bool) -> bool {
        match self {
            Self::Narrow(hw) => matches!(hw >> 11, 0b11000 | 0b11001) || hw & 0xF600 == 0xB400,
            Self::Wide(hw1, hw2) => {
                let multiple = hw1 & 0xFE40 == 0xE800 && matches!((hw1 >> 7) & 0b11, 0b01 | 0b10);
                let (p, u, w) = ((hw1 >> 8) & 1, (hw1 >> 7) & 1, (hw1 >> 5) & 1);
                let extension = fp
                    && hw1 & 0xFE00 == 0xEC00
                    && hw2 & 0x0E00 == 0x0A00
                    && matches!((p, u, w), (0, 1, _) | (1, 0, 1));
                multiple || extension
            }
        }
    }
}

/// What a block is translated from: where it starts, the `ITSTATE` there, and the most
/// instructions it may hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Start {
    pub(crate) pc: u32,
    pub(crate) it: u32,
    pub(crate) longest: u32,
    /// Every instruction is to check the budget and may be the first to run, for a budget that doesn't
    /// hold the whole block and for what follows where it ran out.
    pub(crate) checked: bool,
}

/// The key of the block at `start`, with the MPU off. [`Family::finish`] works it out the same
/// way in code.
pub(crate) fn block_key(start: Start) -> u64 {
    u64::from(start.pc)
        | u64::from(start.it) << 32
        | u64::from(start.longest) << 40
        | u64::from(start.checked) << CHECKED
}

/// The bit of a block's key that says its instructions check the budget where another block from
/// the same instruction checks it on entry.
const CHECKED: u32 = 51;

/// Translates one block from `start` for a core with `features`, fetching halfwords with `fetch`,
/// and ending before any address `stop_before` names but the first. A checked block starts at the
/// instruction [`Family`]'s step says. It may loop back to its first instruction inside itself, which
/// only one that doesn't start at a breakpoint does.
pub(crate) fn translate(
    jit: &mut Jit,
    wanted: Wanted,
    fetch: &mut dyn FnMut(u32) -> Option<u16>,
    stop_before: &dyn Fn(u32) -> bool,
) -> Result<Translation, Error> {
    let Wanted {
        start,
        features,
        tier,
        space,
    } = wanted;
    let pointer = jit.pointer();
    let fma = jit.fma();
    let mut fetched = Vec::new();
    let mut fetch = |address: u32| {
        let answer = fetch(address);
        fetched.push((address, answer));
        answer
    };
    let stops = RefCell::new(Vec::new());
    let stop_before = |address: u32| {
        let answer = stop_before(address);
        stops.borrow_mut().push((address, answer));
        answer
    };
    let mut exits = Vec::new();
    let mut cells = |pc: u32, it: u32| {
        exits.push((pc, it));
        Place::Own(shared::CELLS + u32::try_from(exits.len() - 1).expect("few exits"))
    };
    let mut steps = Vec::new();
    // The first and last byte the block came from.
    let mut range = (start.pc, start.pc);
    let mut looped = false;
    let code = jit.code(tier, |builder, core, signature| {
        let entry = builder.current_block().expect("in the entry block");
        // The builder lays a block out when it first holds an instruction, and the body fills
        // before the entry does, so the entry goes first now.
        builder.func.layout.append_block(entry);
        let body = builder.create_block();
        builder.switch_to_block(body);
        let signature = builder.import_signature(signature.clone());
        let mut e = Emitter::new(builder, pointer, features.isa, InstructionSet::Thumb);
        e.fma = fma;
        // A block that's translated again runs often, and mostly with budget to spare.
        let whole = features.isa.shortcuts && tier == Tier::Best && !start.checked;
        (e.in_hand, e.checked_on_entry) = (whole, whole);
        e.chain = space.map(|space| Chain {
            cells: &mut cells,
            signature,
            recent: Place::Own(shared::RECENT),
            space,
        });
        // The registers, the flags and the budget are read in `body`, and each pass round the
        // block starts after them, at `head`.
        let head = e.b.create_block();
        e.b.ins().jump(head, &[]);
        e.b.switch_to_block(head);
        // A block that starts at a breakpoint, run once to pass it, leaves at its back edge, so
        // the next lap stops there.
        e.head = (!stop_before(start.pc) && !start.checked).then_some(Head {
            pc: start.pc,
            it: start.it,
            block: head,
            looped: false,
        });
        let mut pc = start.pc;
        let mut it = start.it;
        let mut count: u32 = 0;
        let mut entries = Vec::new();
        loop {
            if count > 0 && (count == start.longest || stop_before(pc)) {
                // The block ends where the next instruction starts, which it hasn't run: the
                // last one it ran stands as the one that retired.
                e.index = count - 1;
                e.next_it = Some(it);
                if stop_before(pc) {
                    let next = e.constant(pc);
                    e.exit_to(next, status::NEXT);
                } else {
                    e.exit_to_known(pc);
                }
                break;
            }
            let Some(instruction) = fetch_one(&mut fetch, pc) else {
                // A wide instruction's first halfword was fetched, and a change to it drops this
                // block too.
                if fetch(pc).is_some() {
                    range.1 = pc + 1;
                }
                e.begin(count, pc, 2, it);
                Family::raise(&mut e, Fault::InstructionFetch);
                break;
            };
            if count == 0 && it != 0 && it.trailing_zeros() >= 4 {
                // B1.5.10: ICI bits, which only an exception return brings back, belong to a Load
                // Multiple or Store Multiple, which this core restarts from its first register.
                // On anything else they're an INVSTATE UsageFault.
                if !instruction.continuable(features.isa.fp()) {
                    range.1 = pc + instruction.length() - 1;
                    e.begin(count, pc, instruction.length(), it);
                    Family::raise(&mut e, Fault::InvalidState);
                    break;
                }
                it = 0;
            }
            e.begin(count, pc, instruction.length(), it);
            range.1 = pc + instruction.length() - 1;
            if start.checked {
                let entry = e.b.create_block();
                e.b.ins().jump(entry, &[]);
                e.b.switch_to_block(entry);
                e.start_afresh();
                entries.push(entry);
                steps.push((pc, it));
            }
            emit_one(&mut e, instruction);
            count += 1;
            if e.ended() {
                break;
            }
            e.stop_if_spent(count);
            it = e.next_it.take().unwrap_or_else(|| it_advance(it));
            pc = e.next_pc();
        }
        looped = e.head.is_some_and(|head| head.looped);
        Family::finish(&mut e);
        e.b.switch_to_block(entry);
        let budget =
            e.b.ins()
                .load(types::I32, MemFlagsData::trusted(), core, offsets::BUDGET);
        // A block that ends at a fetch it can't make retires what's before it, and still needs a
        // budget to raise the fault with.
        let needed = if e.checked_on_entry { count.max(1) } else { 1 };
        let short =
            e.b.ins()
                .icmp_imm_s(IntCC::UnsignedLessThan, budget, i64::from(needed));
        let refuse = e.b.create_block();
        if wanted.counts() {
            // A quick translation counts its runs, and hands back untouched once they make it
            // worth translating again.
            let count = e.b.create_block();
            e.b.ins().brif(short, refuse, &[], count, &[]);
            e.b.seal_block(count);
            e.b.switch_to_block(count);
            let counter = Place::Own(shared::COUNTER).emit(e.b, pointer);
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
        } else if start.checked {
            let chosen = e.b.create_block();
            e.b.ins().brif(short, refuse, &[], chosen, &[]);
            e.b.seal_block(chosen);
            e.b.switch_to_block(chosen);
            let step =
                e.b.ins()
                    .load(types::I32, MemFlagsData::trusted(), core, offsets::STEP);
            let mut call = |block| e.b.func.dfg.block_call(block, &[]);
            let otherwise = call(body);
            let calls: Vec<_> = entries.iter().map(|&entry| call(entry)).collect();
            let table = e.b.create_jump_table(JumpTableData::new(otherwise, &calls));
            e.b.ins().br_table(step, table);
            for entry in entries {
                e.b.seal_block(entry);
            }
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
    Ok(Translation {
        code,
        exits,
        range,
        looped,
        steps,
        asked: Asked {
            fetched,
            stops: stops.into_inner(),
        },
    })
}

fn fetch_one(fetch: &mut dyn FnMut(u32) -> Option<u16>, pc: u32) -> Option<Instruction> {
    let first = fetch(pc)?;
    if !Instruction::is_wide(first) {
        return Some(Instruction::Narrow(first));
    }
    Some(Instruction::Wide(first, fetch(pc.wrapping_add(2))?))
}

/// Lowers one instruction, inside its IT block's condition when it has one and the instruction
/// tests it, A7.3.1.
fn emit_one(e: &mut Emitter<'_, '_, Family>, instruction: Instruction) {
    let cond = if e.in_it() && !control::ignores_it_condition(instruction) {
        e.it >> 4
    } else {
        ALWAYS
    };
    e.under_condition(cond, |e| decode(e, instruction));
}

/// Decodes one instruction to its group, A5.1, and raises UNDEFINED for one no group defines.
fn decode(e: &mut Emitter<'_, '_, Family>, instruction: Instruction) {
    let translated = match instruction {
        Instruction::Narrow(hw) => decode16(e, hw),
        Instruction::Wide(hw1, hw2) => decode32(e, hw1, hw2),
    };
    if translated.is_err() {
        Family::raise(e, Fault::Undefined);
    }
}

/// A5.2, the 16-bit encodings, by `opcode`, bits 15 to 10: the conditional branch, the supervisor
/// call and the unconditional branch here, and the rest by [`thumb16`].
fn decode16(e: &mut Emitter<'_, '_, Family>, hw: u16) -> Translated {
    match hw >> 10 {
        0b10_1100..=0b10_1111 => miscellaneous16(e, hw),
        0b11_0100..=0b11_0111 => control::conditional_branch_supervisor_call(e, hw),
        0b11_1000 | 0b11_1001 => {
            control::branch16(e, hw);
            Ok(())
        }
        _ => thumb16(e, hw),
    }
}

/// A5.2.5, the miscellaneous 16-bit instructions, by `opcode`, bits 11 to 5, Table A5-6: CPS, CBZ
/// and CBNZ, BKPT, and IT and the hints here, and the rest by [`thumb16`].
fn miscellaneous16(e: &mut Emitter<'_, '_, Family>, hw: u16) -> Translated {
    let opcode = (hw >> 5) & 0x7F;
    match opcode {
        0b011_0011 => control::change_processor_state(e, hw),
        0b000_1000..=0b000_1111
        | 0b001_1000..=0b001_1111
        | 0b100_1000..=0b100_1111
        | 0b101_1000..=0b101_1111 => compare_branch(e, u32::from(hw)),
        0b111_0000..=0b111_0111 => control::breakpoint(e, hw),
        0b111_1000..=0b111_1111 => control::if_then_hints(e, hw),
        _ => return thumb16(e, hw),
    }
    Ok(())
}

/// A5.3, the 32-bit encodings, by `op1` and `op`: the branches and miscellaneous control here, and
/// the rest by [`thumb32`].
fn decode32(e: &mut Emitter<'_, '_, Family>, hw1: u16, hw2: u16) -> Translated {
    let op1 = (hw1 >> 11) & 0b11;
    let op = hw2 >> 15;
    if op1 == 0b10 && op == 1 {
        return control::branches_miscellaneous_control(e, hw1, hw2);
    }
    thumb32(e, hw1, hw2)
}

#[cfg(test)]
mod tests {
    use super::testing::emit_alone;
    use super::*;
    use crate::cpu::armv7::translate::{Attributes, Size, exits_of};

    /// One instruction lowered by `lower` into a function that never runs: whether it ended the
    /// block, and how many ways out of the block the function has.
    fn lowered(lower: impl FnOnce(&mut Emitter<'_, '_, Family>)) -> (bool, usize) {
        let (ended, function) = emit_alone(|e| {
            e.begin(0, 0, 4, 0);
            lower(e);
            e.ended()
        });
        (ended, exits_of(&function))
    }

    /// B1.5.10's exception-continuable instructions, from every row of Table A5-16, the two
    /// multiples of Table A5-1, `PUSH` and `POP` from A5.2.5, and the multiples of Table A6-7 only
    /// with the floating-point extension, against their neighbors in the same tables.
    #[test]
    fn the_exception_continuable_instructions_are_b1_5_10s() {
        use Instruction::{Narrow, Wide};
        let always = [
            (Narrow(0xC002), "STM r0!, {r1}"),
            (Narrow(0xC806), "LDM r0!, {r1, r2}"),
            (Narrow(0xB510), "PUSH {r4, lr}"),
            (Narrow(0xBD10), "POP {r4, pc}"),
            (Wide(0xE8A0, 0x0006), "STM.W r0!, {r1, r2}"),
            (Wide(0xE890, 0x0006), "LDM.W r0, {r1, r2}"),
            (Wide(0xE8BD, 0x8010), "POP.W {r4, pc}"),
            (Wide(0xE900, 0x0006), "STMDB r0, {r1, r2}"),
            (Wide(0xE92D, 0x4010), "PUSH.W {r4, lr}"),
            (Wide(0xE910, 0x0006), "LDMDB r0, {r1, r2}"),
        ];
        let with_the_extension = [
            (Wide(0xECA0, 0x0A02), "VSTMIA r0!, {s0, s1}"),
            (Wide(0xEC90, 0x0A02), "VLDMIA r0, {s0, s1}"),
            (Wide(0xED20, 0x0A02), "VSTMDB r0!, {s0, s1}"),
            (Wide(0xED30, 0x0A02), "VLDMDB r0!, {s0, s1}"),
            (Wide(0xED2D, 0x8B02), "VPUSH {d8}"),
            (Wide(0xECBD, 0x8A02), "VPOP {s16, s17}"),
        ];
        let never = [
            (Narrow(0x2001), "MOVS r0, #1"),
            (Narrow(0x6808), "LDR r0, [r1]"),
            (Narrow(0x9000), "STR r0, [sp]"),
            (Narrow(0xB001), "ADD sp, #4"),
            (Narrow(0xB100), "CBZ r0"),
            (Narrow(0xB672), "CPSID i"),
            (Wide(0xE9D2, 0x0100), "LDRD r0, r1, [r2]"),
            (Wide(0xE841, 0x0200), "STREX r2, r0, [r1]"),
            (Wide(0xE8D0, 0xF000), "TBB [r0, r0]"),
            (Wide(0xED90, 0x0A00), "VLDR s0, [r0]"),
            (Wide(0xED80, 0x0A00), "VSTR s0, [r0]"),
            (Wide(0xEC51, 0x0B10), "VMOV r0, r1, d0"),
        ];
        for (instruction, name) in always {
            assert!(instruction.continuable(false), "{name}");
            assert!(instruction.continuable(true), "{name}");
        }
        for (instruction, name) in with_the_extension {
            assert!(
                !instruction.continuable(false),
                "{name} without the extension"
            );
            assert!(instruction.continuable(true), "{name}");
        }
        for (instruction, name) in never {
            assert!(!instruction.continuable(true), "{name}");
        }
    }

    /// A core without the DSP extension takes its instructions as UNDEFINED, A5.3.
    #[test]
    fn a_core_without_the_dsp_extension_refuses_its_instructions() {
        use super::super::registers::cfsr;
        use super::testing::Bench;
        use super::testing::spec_of;
        use crate::cpu::armv7::registers::mask;
        use crate::machine::armv7m::{Fpu, MpuRegions, Variant};
        let undefined = mask(cfsr::UNDEFINSTR);
        for (model, status, sum) in [(Variant::M3, undefined, 0), (Variant::M4, 0, 0x0003_0005)] {
            let sadd16 = [0xFA91, 0xF002];
            let mut bench = Bench::of(&spec_of(model, Fpu::None, MpuRegions::Eight), &sadd16);
            bench.core.state.r[1] = 0x0001_0002;
            bench.core.state.r[2] = 0x0002_0003;
            bench.run(1);
            let core = &bench.core;
            assert_eq!(
                (core.system.cfsr & undefined, core.state.r[0]),
                (status, sum),
                "{}",
                model.name()
            );
        }
    }

    /// A load or store leaves through its fault exit only where it faults, so the instruction and
    /// the block go on after it.
    #[test]
    fn an_access_goes_on_after_its_fault_exit() {
        let load = lowered(|e| {
            let address = e.constant(0x2000_0000);
            Family::load(e, address, Size::Word, Attributes::default());
        });
        let store = lowered(|e| {
            let address = e.constant(0x2000_0000);
            Family::store(e, address, address, Size::Word, Attributes::default());
        });
        assert_eq!((load, store), ((false, 1), (false, 1)));
    }

    #[test]
    fn raise_if_goes_on_where_it_does_not_raise() {
        let raised = lowered(|e| {
            let holds = e.b.ins().iconst(types::I8, 1);
            e.raise_if(holds, Fault::Unaligned);
        });
        assert_eq!(raised, (false, 1));
    }

    /// B1.5.15: an SVC that locks up is UNDEFINED and leaves unretired, which is a way out of its
    /// own beside the one past it.
    #[test]
    fn svc_has_a_way_out_for_locking_up() {
        assert_eq!(
            lowered(|e| Family::raise(e, Fault::SupervisorCall)),
            (true, 2)
        );
        assert_eq!(lowered(|e| Family::raise(e, Fault::Undefined)), (true, 1));
    }

    /// A7.7.192: UDIV raises DIVBYZERO only where `CCR.DIV_0_TRP` traps a zero divisor, so the
    /// block goes on after it.
    #[test]
    fn a_divide_goes_on_in_its_block() {
        let divided = lowered(|e| assert_eq!(decode32(e, 0xFBB1, 0xF0F2), Ok(())));
        assert_eq!(divided, (false, 1));
    }
}
