// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! ARM state's miscellaneous and unconditional instructions, DDI 0406C A5.2.11, A5.2.12 and A5.7.
//!
//! Every write to the CPSR or an SPSR is B1.3.3's `CPSRWriteByInstr()` or `SPSRWriteByInstr()` in a
//! helper, which [`Emitter::call`] saves the registers around, since a change of mode swaps the
//! banked ones in, and the block ends after it.
//!
//! Where the manual says UNPREDICTABLE, you get what the pseudocode does when it can run: the PC
//! reads as the instruction's address plus 8, A2.3, and the `(0)` and `(1)` bits are ignored. A
//! write to the PC through `R[]` is UNDEFINED, A2.3.2, as is an encoding with no pseudocode at all,
//! which the glossary lets an UNPREDICTABLE one be.

use std::mem::offset_of;

use cranelift_codegen::ir::{InstBuilder, Value, condcodes::IntCC};

use super::super::family::{EVERY_BYTE, Family, helpers};
use super::super::registers::cpsr;
use super::super::state::{Mode, State};
use super::arm_alu::arm_expand_imm;
use crate::cpu::armv7::registers::{get, is_set, mask, set};
use crate::cpu::armv7::translate::multiply::{self, Rearrange};
use crate::cpu::armv7::translate::{
    Attributes, Emitter, Fault, Profile, Size, Translated, Undefined, bits, memory,
};

/// A5.2.11, `MSR` with an immediate to the CPSR or the current mode's SPSR, B9.3.11, and the hints
/// of Table A5-13, which are the encodings with `R` clear and no byte selected.
pub(super) fn msr_immediate_hints(e: &mut Emitter<'_, '_, Family>, word: u32) {
    let (spsr, bytemask) = (bits(word, 22, 22) == 1, bits(word, 19, 16));
    if !spsr && bytemask == 0 {
        hint(e, bits(word, 7, 0));
        return;
    }
    let value = e.constant(arm_expand_imm(bits(word, 11, 0)));
    write_psr(e, spsr, value, bytemask);
}

/// The hints of Table A5-13, by `op2`. The unallocated ones run as `NOP`, A8.8.119, as the table
/// says, and so do `YIELD`, A8.8.426, with no other thread to yield to, and `DBG`, A8.8.42, with
/// no debug system to hint to.
pub(super) fn hint(e: &mut Emitter<'_, '_, Family>, op2: u32) {
    match op2 {
        // WFE, A8.8.424. Whether it waits is the event register's, B1.8.13.
        0b0000_0010 => e.wait(true),
        // WFI, A8.8.425.
        0b0000_0011 => e.wait(false),
        // SEV, A8.8.168. `SendEvent()` sets every processor's event register, this one's too,
        // B1.8.13.
        0b0000_0100 => {
            let one = e.constant(1);
            e.store_field(offset_of!(State, event), one);
        }
        _ => {}
    }
}

/// A5.2.12, the miscellaneous instructions of Table A5-14, by `op2`, bits 6 to 4, and `op`, bits
/// 22 and 21. The banked `MRS` and `MSR`, `ERET` and `HVC` are the Virtualization Extensions', and
/// `SMC` the Security Extensions', which the R profile hasn't got, so they're UNDEFINED, B9.1.
pub(super) fn miscellaneous(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (op2, op) = (bits(word, 6, 4), bits(word, 22, 21));
    let (d, m) = (bits(word, 15, 12), bits(word, 3, 0));
    let banked = bits(word, 9, 9) == 1;
    match (op2, op) {
        (0b000, _) if banked => return Err(Undefined),
        (0b000, 0b00 | 0b10) => move_from_psr(e, d, op == 0b10)?,
        (0b000, _) => {
            let value = e.reg(m);
            write_psr(e, op == 0b11, value, bits(word, 19, 16));
        }
        // BX, A8.8.27, and BXJ, A8.8.28, which DDI 0460D 3.9 makes BX on a core with no Jazelle
        // hardware.
        (0b001 | 0b010, 0b01) => {
            let target = e.reg(m);
            Family::branch_exchange(e, target);
        }
        // CLZ, A8.8.33.
        (0b001, 0b11) => {
            if d == 15 {
                return Err(Undefined);
            }
            let result = multiply::rearrange(e, m, Rearrange::CountLeadingZeros);
            e.set_reg(d, result);
        }
        // BLX with a register, A8.8.26, which reads its target before it writes LR.
        (0b011, 0b01) => {
            let target = e.reg(m);
            let link = e.constant(e.next_pc());
            e.set_reg(14, link);
            Family::blx_write_pc(e, target);
        }
        // BKPT, A8.8.24, the debug event the exception model takes as a Prefetch Abort.
        (0b111, 0b01) => Family::raise(e, Fault::Breakpoint),
        _ => return Err(Undefined),
    }
    Ok(())
}

/// `MRS`, B9.3.9: the CPSR with its execution state bits but `E` reading as zero, or the current
/// mode's SPSR. User mode and System mode have no SPSR, which makes it UNPREDICTABLE, and they
/// read the CPSR, as [`helpers::spsr`] answers.
pub(super) fn move_from_psr(e: &mut Emitter<'_, '_, Family>, d: u32, spsr: bool) -> Translated {
    if d == 15 {
        return Err(Undefined);
    }
    let read = if spsr {
        helpers::spsr as *const () as usize
    } else {
        read_cpsr as *const () as usize
    };
    let value = e.call(read, &[]);
    e.set_reg(d, value);
    Ok(())
}

/// `MSR` to the CPSR or the current mode's SPSR, B9.3.11 and B9.3.12: the bytes `bytemask` selects
/// of `value`. One that selects none writes nothing, which B9.3.11 makes UNPREDICTABLE. Ends the
/// block.
pub(super) fn write_psr(e: &mut Emitter<'_, '_, Family>, spsr: bool, value: Value, bytemask: u32) {
    let write = if spsr {
        write_spsr as *const () as usize
    } else {
        write_cpsr as *const () as usize
    };
    let bytemask = e.constant(bytemask);
    e.call(write, &[value, bytemask]);
    e.end_block();
}

/// A5.7, the unconditional instructions of Table A5-23. The coprocessor forms are UNDEFINED, since
/// none of the R5's coprocessors defines one, DDI 0406C B5.6.2 and DDI 0460D 4.2 and 11.1.
pub(super) fn unconditional(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    match (bits(word, 27, 25), bits(word, 22, 22), bits(word, 20, 20)) {
        (0b000..=0b011, _, _) => hints_barriers(e, word)?,
        (0b100, 1, 0) => {
            store_return_state(e, get(cpsr::M, word), step(word), bits(word, 21, 21) == 1)?;
        }
        (0b100, 0, 1) => {
            return_from_exception(e, bits(word, 19, 16), step(word), bits(word, 21, 21) == 1)?;
        }
        (0b101, _, _) => branch_link_exchange(e, word),
        _ => return Err(Undefined),
    }
    Ok(())
}

/// A5.7.1, Table A5-24, by `op1`, bits 26 to 20, `op2`, bits 7 to 4, and `Rn`. The Advanced SIMD
/// rows are UNDEFINED, since the R5 hasn't got it, DDI 0460D 11.3.4 Table 11-8, and so are the rows with no
/// pseudocode, which the table calls UNPREDICTABLE.
fn hints_barriers(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (op1, op2, rn) = (bits(word, 26, 20), bits(word, 7, 4), bits(word, 19, 16));
    match op1 {
        0b001_0000 if op2 & 0b0010 == 0 && rn & 1 == 0 => change_processor_state(
            e,
            bits(word, 19, 18),
            word & (mask(cpsr::A) | mask(cpsr::I) | mask(cpsr::F)),
            (bits(word, 17, 17) == 1).then(|| get(cpsr::M, word)),
        ),
        0b001_0000 if op2 == 0 && rn & 1 == 1 => set_endianness(e, is_set(cpsr::E, word)),
        // PLI, PLD and PLDW with an immediate, A8.8.126, A8.8.127 and A8.8.129, and with a
        // register, A8.8.128 and A8.8.130, and the unallocated hints beside them, which the table
        // treats as NOP. Nothing here caches, so each is a NOP, the PC as a base or an index too.
        _ if op1 & 0b110_0011 == 0b100_0001 => {}
        _ if op1 & 0b110_0011 == 0b110_0001 && op2 & 1 == 0 => {}
        0b101_0111 => barrier(e, op2)?,
        _ => return Err(Undefined),
    }
    Ok(())
}

/// The barriers and `CLREX` of Table A5-24's `1010111` row, by `op2`.
pub(super) fn barrier(e: &mut Emitter<'_, '_, Family>, op2: u32) -> Translated {
    match op2 {
        // CLREX, A8.8.32, with the local monitor the only one, A3.4.
        0b0001 => memory::clear_exclusive(e),
        // DSB, A8.8.44, and DMB, A8.8.43. Every access completes before the next instruction
        // starts here, so there's nothing to wait for.
        0b0100 | 0b0101 => {}
        // ISB, A8.8.53. What the next instruction's translation depends on may have changed.
        0b0110 => e.end_block(),
        _ => return Err(Undefined),
    }
    Ok(())
}

/// `CPS`, B9.3.2: `imod` of 10 clears and 11 sets the masks among `A`, `I` and `F` that the
/// instruction names, at the bits the CPSR has them, and `M` changes the mode. User mode changes
/// nothing, since `CPSRWriteByInstr()` writes no mask and no mode there. The forms B9.3.2 makes
/// UNPREDICTABLE run the pseudocode: an `imod` of 00 or 01 changes no mask, and a mode without `M`
/// isn't written. `named` holds the masks at the CPSR's bits, and `mode` is there with `M`. Ends
/// the block.
pub(super) fn change_processor_state(
    e: &mut Emitter<'_, '_, Family>,
    imod: u32,
    named: u32,
    mode: Option<u32>,
) {
    let (mut clear, mut set) = match imod {
        0b10 => (named, 0),
        0b11 => (named, named),
        _ => (0, 0),
    };
    if let Some(mode) = mode {
        clear |= mask(cpsr::M);
        set |= mode;
    }
    update_cpsr(e, clear, set);
}

/// `SETEND`, A8.8.167: `E` set for big-endian data, in any mode. The data's byte order is part of
/// what a block is translated for, so the block ends.
pub(super) fn set_endianness(e: &mut Emitter<'_, '_, Family>, big: bool) {
    update_cpsr(e, mask(cpsr::E), set(cpsr::E, 0, u32::from(big)));
}

/// The CPSR with `clear`'s bits cleared and `set`'s set, through [`change_cpsr`]. Ends the block.
fn update_cpsr(e: &mut Emitter<'_, '_, Family>, clear: u32, set: u32) {
    let (clear, set) = (e.constant(clear), e.constant(set));
    e.call(change_cpsr as *const () as usize, &[clear, set]);
    e.end_block();
}

/// `BLX` with an immediate, A8.8.25 encoding A2: LR is the next instruction, and the branch is to
/// the PC, the instruction's address plus 8, and `imm24:H:'0'` sign-extended, in Thumb state.
fn branch_link_exchange(e: &mut Emitter<'_, '_, Family>, word: u32) {
    let imm32 =
        ((bits(word, 23, 0) << 8 | bits(word, 24, 24) << 7).cast_signed() >> 6).cast_unsigned();
    let link = e.constant(e.next_pc());
    e.set_reg(14, link);
    let target = e.pc().wrapping_add(8).wrapping_add(imm32);
    let thumb = e.constant(target | 1);
    Family::branch_exchange(e, thumb);
}

/// The way `SRS` and `RFE` walk from their base, by `P` and `U`, B9.3.16 and B9.3.13, the same as
/// a block transfer's of two words.
fn step(word: u32) -> memory::Step {
    match (bits(word, 24, 24), bits(word, 23, 23)) {
        (0, 0) => memory::Step::DecrementAfter,
        (0, _) => memory::Step::IncrementAfter,
        (_, 0) => memory::Step::DecrementBefore,
        _ => memory::Step::IncrementBefore,
    }
}

/// The bytes `SRS` and `RFE` transfer, LR or the PC and a PSR.
const RETURN_STATE: u32 = 8;

/// `SRS`, B9.3.16: LR and the SPSR to the stack of the mode the instruction names, whose SP moves
/// past them with `W`. User mode reaching another mode's SP would let it change what it can't
/// otherwise, so B9.3.16's UNPREDICTABLE is UNDEFINED there. System mode runs the pseudocode, and
/// stores the CPSR, which [`helpers::spsr`] answers for an SPSR it hasn't got. A mode the R profile
/// hasn't got, Hyp mode or Monitor mode among them, is UNDEFINED, since `Rmode[]` can't reach it,
/// B1.3.2.
pub(super) fn store_return_state(
    e: &mut Emitter<'_, '_, Family>,
    mode: u32,
    step: memory::Step,
    wback: bool,
) -> Translated {
    if Mode::from_bits(mode).is_none() {
        return Err(Undefined);
    }
    refuse_in_user_mode(e);
    let mode = e.constant(mode);
    let base = e.call(banked_sp as *const () as usize, &[mode]);
    let (address, written) = memory::span(e, base, RETURN_STATE, step);
    let lr = e.reg(14);
    Family::store(e, address, lr, Size::Word, Attributes::ALIGNED);
    let spsr = e.call(helpers::spsr as *const () as usize, &[]);
    let next = e.b.ins().iadd_imm_s(address, 4);
    Family::store(e, next, spsr, Size::Word, Attributes::ALIGNED);
    if wback {
        e.call(set_banked_sp as *const () as usize, &[mode, written]);
    }
    Ok(())
}

/// `RFE`, B9.3.13: the PC and then the CPSR from two words at `R[n]`, the base moving past them
/// with `W`, through [`Family::exception_return`]. User mode makes it UNPREDICTABLE and runs the
/// pseudocode, whose `CPSRWriteByInstr()` changes no mask and no mode there. A base of the PC reads
/// as its address plus 8, and a writeback to it is UNDEFINED.
pub(super) fn return_from_exception(
    e: &mut Emitter<'_, '_, Family>,
    n: u32,
    step: memory::Step,
    wback: bool,
) -> Translated {
    if n == 15 && wback {
        return Err(Undefined);
    }
    let base = e.reg(n);
    let (address, written) = memory::span(e, base, RETURN_STATE, step);
    let pc = Family::load(e, address, Size::Word, Attributes::ALIGNED);
    let next = e.b.ins().iadd_imm_s(address, 4);
    let psr = Family::load(e, next, Size::Word, Attributes::ALIGNED);
    if wback {
        e.set_reg(n, written);
    }
    Family::exception_return(e, pc, psr);
    Ok(())
}

/// Raises UNDEFINED where the core is in User mode.
pub(super) fn refuse_in_user_mode(e: &mut Emitter<'_, '_, Family>) {
    let mode = e.load_field(offset_of!(State, mode));
    let user =
        e.b.ins()
            .icmp_imm_s(IntCC::Equal, mode, i64::from(Mode::User as u32));
    e.raise_if(user, Fault::Undefined);
}

/// The CPSR as `MRS` reads it, B9.3.9: the execution state bits, `ITSTATE` and `T`, read as zero.
extern "C" fn read_cpsr(core: &mut Family) -> u32 {
    core.state.cpsr() & !(mask(cpsr::IT_1_0) | mask(cpsr::IT_7_2) | mask(cpsr::T))
}

/// B1.3.3's `CPSRWriteByInstr(value, bytemask, FALSE)`. A call answers a value, and this one's is
/// always 0.
extern "C" fn write_cpsr(core: &mut Family, value: u32, bytemask: u32) -> u32 {
    core.cpsr_write_by_instr(value, bytemask, false);
    0
}

/// B1.3.3's `SPSRWriteByInstr(value, bytemask)`. Answers 0.
extern "C" fn write_spsr(core: &mut Family, value: u32, bytemask: u32) -> u32 {
    core.spsr_write_by_instr(value, bytemask);
    0
}

/// The CPSR with `clear`'s bits cleared and `set`'s set, written through every byte of
/// `CPSRWriteByInstr()` as `CPS` writes it, B9.3.2. Answers 0.
extern "C" fn change_cpsr(core: &mut Family, clear: u32, set: u32) -> u32 {
    let value = core.state.cpsr() & !clear | set;
    core.cpsr_write_by_instr(value, EVERY_BYTE, false);
    0
}

/// B1.3.2's `Rmode[13, mode]`: the SP `mode` banks, read from any mode.
extern "C" fn banked_sp(core: &mut Family, mode: u32) -> u32 {
    in_mode(core, mode, |state| state.r[13])
}

/// `Rmode[13, mode] = value`, B1.3.2. Answers 0.
extern "C" fn set_banked_sp(core: &mut Family, mode: u32, value: u32) -> u32 {
    in_mode(core, mode, |state| state.r[13] = value);
    0
}

/// Runs `reach` on the state with `mode`'s banked registers swapped in, and swaps the current
/// mode's back after.
fn in_mode<T>(core: &mut Family, mode: u32, reach: impl FnOnce(&mut State) -> T) -> T {
    let current = core.state.mode();
    let mode = Mode::from_bits(mode).expect("the translator refuses a mode BadMode() refuses");
    core.state.set_mode(mode);
    let answer = reach(&mut core.state);
    core.state.set_mode(current);
    answer
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::family::helpers;
    use super::super::super::registers::{cpsr, sctlr};
    use super::super::super::state::{Mode, State};
    use super::super::testing::{Bench, RAM, SPUN};
    use super::super::{Instruction, emit_one};
    use super::Family;
    use crate::cpu::armv7::registers::mask;
    use crate::cpu::armv7::translate::float::Fpu;
    use crate::cpu::armv7::translate::{Emitter, Features, InstructionSet, status};
    use crate::soc::Endian;

    const BOTH: [Endian; 2] = [Endian::Little, Endian::Big];
    /// The Undefined Instruction exception, taken at the instruction at 0.
    const UNDEFINED: Option<(Exception, u32)> = Some((Exception::Undefined, 0));
    /// Where the tests' data is.
    const BASE: u32 = RAM + 0x100;
    const FLAGS: u32 =
        mask(cpsr::N) | mask(cpsr::Z) | mask(cpsr::C) | mask(cpsr::V) | mask(cpsr::Q);

    /// A bench on a part in `endian` that's run every instruction of `code` after `prepare`, each
    /// retiring.
    fn after(endian: Endian, code: &[u32], prepare: impl FnOnce(&mut Family)) -> Bench {
        let mut bench = Bench::arm(endian, code);
        prepare(&mut bench.core);
        let count = u32::try_from(code.len()).unwrap();
        let (_, ran) = bench.run(count);
        assert_eq!(
            (ran, bench.taken()),
            (u64::from(count), None),
            "{endian:?} {code:08x?}"
        );
        bench
    }

    /// The state after `word` ran on a little-endian part, set up by `prepare`.
    fn run(word: u32, prepare: impl FnOnce(&mut State)) -> State {
        after(Endian::Little, &[word], |core| prepare(&mut core.state))
            .core
            .state
    }

    /// Whether `word` is refused as UNDEFINED, from `prepare`, without retiring or changing a
    /// register.
    fn undefined_after(word: u32, prepare: impl FnOnce(&mut Family)) {
        let mut bench = Bench::arm(Endian::Little, &[word]);
        prepare(&mut bench.core);
        let before = bench.core.state.clone();
        assert_eq!(bench.run(1).1, SPUN, "{word:#010x}");
        assert_eq!(bench.raised(), UNDEFINED, "{word:#010x}");
        assert_eq!(
            bench.before_taken(),
            (before.r, before.cpsr()),
            "{word:#010x}"
        );
    }

    fn undefined(word: u32) {
        undefined_after(word, |_| {});
    }

    /// Lowers `word` alone at `0x100` into a block, run once on a core set up by `prepare`, and
    /// answers whether it ended the block and the status the block answered.
    fn lowered(word: u32, prepare: impl FnOnce(&mut Family)) -> (bool, u32) {
        let mut bench = Bench::arm(Endian::Little, &[]);
        prepare(&mut bench.core);
        let mut ended = false;
        let answer = helpers::run_built(&mut bench.core, |builder, core, _| {
            let pointer = builder.func.dfg.value_type(core);
            let features = Features {
                dsp: true,
                fpu: Fpu::None,
                endian: Endian::Little,
                shortcuts: true,
            };
            let mut e = Emitter::new(builder, pointer, features, InstructionSet::Arm);
            e.begin(0, 0x100, 4, 0);
            emit_one(&mut e, Instruction::Arm(word));
            ended = e.ended();
            if !ended {
                e.end_block();
            }
            Family::finish(&mut e, 0);
        });
        (ended, answer & 0xFF)
    }

    /// The word at `at` as `endian` reads it.
    fn word_at(bench: &Bench, endian: Endian, at: u32) -> u32 {
        let bytes = [0, 1, 2, 3].map(|k| bench.byte(at + k));
        match endian {
            Endian::Little => u32::from_le_bytes(bytes),
            Endian::Big => u32::from_be_bytes(bytes),
        }
    }

    /// Writes `words` at `at` in `endian`'s order.
    fn place_words(bench: &mut Bench, endian: Endian, at: u32, words: &[u32]) {
        let bytes: Vec<u8> = words
            .iter()
            .flat_map(|&word| match endian {
                Endian::Little => word.to_le_bytes(),
                Endian::Big => word.to_be_bytes(),
            })
            .collect();
        bench.write(at, &bytes);
    }

    /// `mode`'s SP, reached by switching to it and back.
    fn sp_of(state: &mut State, mode: Mode) -> u32 {
        let current = state.mode();
        state.set_mode(mode);
        let sp = state.r[13];
        state.set_mode(current);
        sp
    }

    /// Sets `mode`'s SP to `sp`.
    fn set_sp_of(state: &mut State, mode: Mode, sp: u32) {
        let current = state.mode();
        state.set_mode(mode);
        state.r[13] = sp;
        state.set_mode(current);
    }

    /// A8.8.27 and A8.8.28: `BX` and `BXJ` take the instruction set from bit 0 of the target, and
    /// `BXJ` is `BX`, DDI 0460D 3.9. A target of the PC, which A8.8.28 makes UNPREDICTABLE for
    /// `BXJ`, is the address plus 8.
    #[test]
    fn bx_and_bxj_take_the_instruction_set_from_bit_0() {
        for (word, r1, pc, thumb) in [
            (0xE12F_FF11, 0x2001, 0x2000, 1), // BX r1
            (0xE12F_FF11, 0x2004, 0x2004, 0),
            (0xE12F_FF21, 0x2001, 0x2000, 1), // BXJ r1
            (0xE12F_FF21, 0x2004, 0x2004, 0),
            (0xE12F_FF1F, 0, 8, 0), // BX pc
            (0xE12F_FF2F, 0, 8, 0), // BXJ pc
        ] {
            let state = run(word, |s| s.r[1] = r1);
            assert_eq!((state.r[15], state.t), (pc, thumb), "{word:#010x}");
        }
    }

    /// A8.8.26: `BLX` with a register links the next instruction and branches to the register as it
    /// was, LR included. Its target of the PC is UNPREDICTABLE and branches to the address plus 8.
    #[test]
    fn blx_register_links_the_next_instruction() {
        for (word, (r1, lr), pc, thumb) in [
            (0xE12F_FF31, (0x3001, 0), 0x3000, 1), // BLX r1
            (0xE12F_FF3E, (0, 0x2000), 0x2000, 0), // BLX lr
            (0xE12F_FF3F, (0, 0), 8, 0),           // BLX pc
        ] {
            let state = run(word, |s| (s.r[1], s.r[14]) = (r1, lr));
            assert_eq!(
                (state.r[15], state.t, state.r[14]),
                (pc, thumb, 4),
                "{word:#010x}"
            );
        }
    }

    /// A8.8.33: `CLZ` counts from bit 31 and answers 32 for zero. A destination of the PC is
    /// UNDEFINED.
    #[test]
    fn clz_counts_the_leading_zeros() {
        for (value, zeros) in [(0, 32), (1, 31), (0x8000_0000, 0), (0x1_0000, 15)] {
            let state = run(0xE16F_0F11, |s| s.r[1] = value); // CLZ r0, r1
            assert_eq!(state.r[0], zeros, "{value:#x}");
        }
        undefined(0xE16F_FF11); // CLZ pc, r1
    }

    /// A8.8.24: `BKPT` raises its debug event before it retires, a Prefetch Abort whose `IFSR`
    /// says so, C4.1 and DDI 0460D Table 4-28.
    #[test]
    fn bkpt_raises_its_debug_event_before_it_retires() {
        const DEBUG_EVENT: u32 = 0b0_0010;
        let mut bench = Bench::arm(Endian::Little, &[0xE120_0070]);
        assert_eq!(bench.run(1).1, SPUN);
        assert_eq!(
            (bench.raised(), bench.core.faults.ifsr),
            (Some((Exception::PrefetchAbort, 0)), DEBUG_EVENT)
        );
    }

    /// Table A5-14's rows for the Virtualization Extensions and the Security Extensions, which the
    /// R profile hasn't got, and the rows it leaves out, are UNDEFINED.
    #[test]
    fn table_a5_14_s_other_rows_are_undefined() {
        for word in [
            0xE100_0200, // MRS r0, R8_usr
            0xE120_F200, // MSR R8_usr, r0
            0xE160_006E, // ERET
            0xE140_0070, // HVC #0
            0xE160_0070, // SMC #0
            0xE100_0070, // op2 111, op 00
            0xE120_0040, // op2 100
            0xE120_0060, // op2 110, op 01
            0xE100_0010, // op2 001, op 00
            0xE160_0030, // op2 011, op 11
        ] {
            undefined(word);
        }
    }

    /// B9.3.9: `MRS` reads the CPSR with `ITSTATE` and `T` as zero, and the current mode's SPSR. In
    /// System mode, which has none, it reads the CPSR. A destination of the PC is UNDEFINED.
    #[test]
    fn mrs_reads_the_cpsr_less_its_execution_state_bits() {
        let state = run(0xE10F_0000, |s| {
            (s.n, s.q, s.ge, s.it, s.e) = (1, 1, 0b1010, 0b1010_0101, 1);
        }); // MRS r0, CPSR
        let read = mask(cpsr::N)
            | mask(cpsr::Q)
            | 0b1010 << cpsr::GE.bit
            | mask(cpsr::E)
            | mask(cpsr::A)
            | mask(cpsr::I)
            | mask(cpsr::F)
            | Mode::Supervisor as u32;
        assert_eq!(state.r[0], read);
        let state = run(0xE14F_0000, |s| assert!(s.set_spsr(0x8000_0010))); // MRS r0, SPSR
        assert_eq!(state.r[0], 0x8000_0010);
        let state = run(0xE14F_0000, |s| s.set_mode(Mode::System));
        assert_eq!(state.r[0], 0x1C0 | Mode::System as u32);
        undefined(0xE10F_F000); // MRS pc, CPSR
    }

    /// B9.3.12: `MSR` with a register writes the bytes its mask selects, and a mode with them,
    /// whose banked SP comes in. From User mode only the flags, `GE` and `E` change, and a mask
    /// of none, which is UNPREDICTABLE, writes nothing.
    #[test]
    fn msr_register_writes_the_bytes_its_mask_selects() {
        let value = FLAGS | 0b0110 << cpsr::GE.bit | Mode::Irq as u32;
        let state = run(0xE129_F001, |s| {
            s.r[1] = value;
            set_sp_of(s, Mode::Irq, 0x1200);
        }); // MSR CPSR_fc, r1
        assert_eq!(
            (state.cpsr(), state.r[13]),
            (FLAGS | mask(cpsr::A) | Mode::Irq as u32, 0x1200)
        );
        let state = run(0xE124_F001, |s| s.r[1] = value); // MSR CPSR_s, r1
        assert_eq!(
            (state.ge, state.n, state.mode()),
            (0b0110, 0, Mode::Supervisor)
        );
        let state = run(0xE12F_F001, |s| {
            s.r[1] = value | mask(cpsr::E);
            s.set_mode(Mode::User);
        }); // MSR CPSR_fsxc, r1
        assert_eq!(
            state.cpsr(),
            FLAGS | 0b0110 << cpsr::GE.bit | mask(cpsr::E) | 0x1C0 | Mode::User as u32
        );
        let state = run(0xE120_F001, |s| s.r[1] = value); // MSR CPSR_, r1
        assert_eq!(state.cpsr(), 0x1C0 | Mode::Supervisor as u32);
        let state = run(0xE16F_F001, |s| s.r[1] = 0xF80F_0012); // MSR SPSR_fsxc, r1
        assert_eq!(
            (state.spsr(), state.mode()),
            (Some(0xF80F_0012), Mode::Supervisor)
        );
    }

    /// B9.3.11: `MSR` with an immediate writes `ARMExpandImm(imm12)` to the bytes its mask selects
    /// of the CPSR or the SPSR, and with none selected writes nothing.
    #[test]
    fn msr_immediate_writes_the_expanded_constant() {
        let state = run(0xE328_F20F, |_| {}); // MSR CPSR_f, #0xF0000000
        assert_eq!(
            (state.n, state.z, state.c, state.v, state.q),
            (1, 1, 1, 1, 0)
        );
        let state = run(0xE361_F01F, |s| assert!(s.set_spsr(0x8000_0010))); // MSR SPSR_c, #0x1F
        assert_eq!(state.spsr(), Some(0x8000_001F));
        let state = run(0xE360_F01F, |s| assert!(s.set_spsr(0x8000_0010))); // MSR SPSR_, #0x1F
        assert_eq!(state.spsr(), Some(0x8000_0010));
    }

    /// Every write to a PSR ends the block, A5.2.11 and A5.2.12, and so do `CPS`, `SETEND` and
    /// `ISB`, A5.7.1. The others go on.
    #[test]
    fn a_psr_write_ends_the_block() {
        for word in [
            0xE328_F20F, // MSR CPSR_f, #0xF0000000
            0xE361_F01F, // MSR SPSR_c, #0x1F
            0xE129_F001, // MSR CPSR_fc, r1
            0xF10C_0080, // CPSID i
            0xF101_0200, // SETEND BE
            0xF57F_F06F, // ISB SY
        ] {
            assert_eq!(lowered(word, |_| {}), (true, status::NEXT), "{word:#010x}");
        }
        for word in [0xE10F_0000, 0xF57F_F04F, 0xE320_F000] {
            assert!(!lowered(word, |_| {}).0, "{word:#010x}");
        }
    }

    /// Table A5-13's hints: `WFE` and `WFI` retire and wait, A8.8.424 and A8.8.425, `SEV` sets the
    /// event register, A8.8.168, and `NOP`, `YIELD`, `DBG` and the unallocated hints change
    /// nothing.
    #[test]
    fn the_hints_wait_signal_or_do_nothing() {
        assert_eq!(
            lowered(0xE320_F003, |_| {}),
            (true, status::WAIT_FOR_INTERRUPT)
        );
        assert_eq!(lowered(0xE320_F002, |_| {}), (true, status::WAIT_FOR_EVENT));
        assert_eq!(run(0xE320_F004, |_| {}).event, 1); // SEV
        for word in [
            0xE320_F000,
            0xE320_F001,
            0xE320_F0F3,
            0xE320_F005,
            0xE320_F080,
        ] {
            let state = run(word, |s| s.r[0] = 9);
            let mut expected = State::default();
            (expected.r[0], expected.r[13], expected.r[15]) = (9, state.r[13], 4);
            assert_eq!(state, expected, "{word:#010x}");
        }
    }

    /// B9.3.2: `CPS` sets or clears the masks it names and changes the mode, with the new mode's
    /// SP. User mode changes nothing, and the forms B9.3.2 makes UNPREDICTABLE run the pseudocode:
    /// an `imod` of 01 changes no mask, and a mode without `M` isn't written.
    #[test]
    fn cps_changes_the_masks_and_the_mode() {
        let masks = |s: &State| (s.a, s.i, s.f, s.mode());
        let clear = (0, 0, 0);
        let all = (1, 1, 1);
        for (word, user, before, after) in [
            (0xF10C_0080, false, clear, (0, 1, 0, Mode::Supervisor)), // CPSID i
            (0xF10C_01C0, false, clear, (1, 1, 1, Mode::Supervisor)), // CPSID aif
            (0xF108_00C0, false, all, (1, 0, 0, Mode::Supervisor)),   // CPSIE if
            (0xF102_0012, false, all, (1, 1, 1, Mode::Irq)),          // CPS #0x12
            (0xF10E_0051, false, clear, (0, 0, 1, Mode::Fiq)),        // CPSID f, #0x11
            (0xF104_0080, false, clear, (0, 0, 0, Mode::Supervisor)), // imod 01
            (0xF10C_0092, false, clear, (0, 1, 0, Mode::Supervisor)), // CPSID i, no M
            (0xF100_0012, false, clear, (0, 0, 0, Mode::Supervisor)), // a mode, no M
            (0xF10C_01D2, true, clear, (0, 0, 0, Mode::User)),        // CPSID aif, #0x12
            (0xF108_01C0, true, all, (1, 1, 1, Mode::User)),          // CPSIE aif
        ] {
            let state = run(word, |s| {
                (s.a, s.i, s.f) = before;
                set_sp_of(s, Mode::Irq, 0x1200);
                if user {
                    s.set_mode(Mode::User);
                }
            });
            assert_eq!(masks(&state), after, "{word:#010x}");
            if after.3 == Mode::Irq {
                assert_eq!(state.r[13], 0x1200);
            }
        }
    }

    /// A8.8.167: `SETEND` changes the byte order of the data that follows it, in any mode, and the
    /// instruction after it is translated for the new one.
    #[test]
    fn setend_changes_the_byte_order_of_the_data_that_follows() {
        let code = [
            0xF101_0200, // SETEND BE
            0xE582_1000, // STR r1, [r2]
            0xF101_0000, // SETEND LE
            0xE582_1004, // STR r1, [r2, #4]
        ];
        for endian in BOTH {
            for mode in [Mode::Supervisor, Mode::User] {
                let bench = after(endian, &code, |core| {
                    let state = &mut core.state;
                    (state.r[1], state.r[2]) = (0x1122_3344, BASE);
                    state.set_mode(mode);
                });
                let stored: Vec<u8> = (BASE..BASE + 8).map(|at| bench.byte(at)).collect();
                assert_eq!(
                    stored,
                    [0x11, 0x22, 0x33, 0x44, 0x44, 0x33, 0x22, 0x11],
                    "{endian:?} {mode:?}"
                );
                assert_eq!(bench.core.state.e, 0);
            }
        }
    }

    /// A8.8.126 to A8.8.130: the preloads and the unallocated memory hints are NOPs, the forms
    /// A5.7.1 makes UNPREDICTABLE but gives pseudocode too, and the rows of Table A5-24 with none,
    /// and its Advanced SIMD rows, are UNDEFINED.
    #[test]
    fn the_memory_hints_change_nothing() {
        for word in [
            0xF5D0_F004, // PLD [r0, #4]
            0xF590_F004, // PLDW [r0, #4]
            0xF55F_F004, // PLD [pc, #-4]
            0xF51F_F004, // PLDW [pc, #-4]
            0xF4D0_F004, // PLI [r0, #4]
            0xF7D0_F001, // PLD [r0, r1]
            0xF790_F001, // PLDW [r0, r1]
            0xF6D0_F001, // PLI [r0, r1]
            0xF7D0_F00F, // PLD [r0, pc]
            0xF410_F000, // an unallocated hint, immediate
            0xF610_F000, // an unallocated hint, register
        ] {
            let state = run(word, |s| s.r[0] = 9);
            let mut expected = State::default();
            (expected.r[0], expected.r[13], expected.r[15]) = (9, state.r[13], 4);
            assert_eq!(state, expected, "{word:#010x}");
        }
        for word in [
            0xF430_F000, // 100xx11
            0xF530_F000, // 1010011
            0xF5B0_F000, // 1011x11
            0xF630_F000, // 11xxx11
            0xF7D0_F011, // PLD with op2 bit 4 set
            0xF220_0000, // Advanced SIMD data processing
            0xF400_0000, // Advanced SIMD element load
            0xF7F0_00F0, // permanently UNDEFINED
            0xF100_0020, // 0010000 with op2 xx1x
            0xF000_0000, // 0000000
        ] {
            undefined(word);
        }
    }

    /// A8.8.32: `CLREX` leaves the local monitor open, and A8.8.43 and A8.8.44: `DMB` and `DSB`
    /// change nothing. Table A5-24's other options in the barriers' row are UNDEFINED.
    #[test]
    fn clrex_opens_the_monitor_and_the_barriers_change_nothing() {
        assert_eq!(
            run(0xF57F_F01F, |s| s.exclusive_valid = 1).exclusive_valid,
            0
        );
        for word in [0xF57F_F04F, 0xF57F_F05F, 0xF57F_F06F] {
            assert_eq!(run(word, |s| s.exclusive_valid = 1).exclusive_valid, 1);
        }
        for word in [0xF57F_F00F, 0xF57F_F02F, 0xF57F_F07F, 0xF57F_F08F] {
            undefined(word);
        }
    }

    /// `P` and `U` for each way `SRS` and `RFE` walk, B9.3.16 and B9.3.13.
    const IA: u32 = 0b01;
    const IB: u32 = 0b11;
    const DA: u32 = 0b00;
    const DB: u32 = 0b10;

    /// Table A5-23's `SRS`, walking `step` with `W` from `mode`'s SP.
    fn srs(step: u32, w: u32, mode: Mode) -> u32 {
        0xF84D_0500 | step << 23 | w << 21 | mode as u32
    }

    /// Table A5-23's `RFE`, walking `step` with `W` from `Rn`.
    fn rfe(step: u32, w: u32, n: u32) -> u32 {
        0xF810_0A00 | step << 23 | w << 21 | n << 16
    }

    /// B9.3.16: `SRS` stores LR and the SPSR at the SP of the mode it names, and moves that SP with
    /// `W`, each of the four ways, in the data's byte order.
    #[test]
    fn srs_stores_lr_and_the_spsr_on_the_named_mode_s_stack() {
        for (step, first, written) in [
            (IA, BASE, BASE + 8),
            (IB, BASE + 4, BASE + 8),
            (DA, BASE - 4, BASE - 8),
            (DB, BASE - 8, BASE - 8),
        ] {
            for endian in BOTH {
                for w in [0, 1] {
                    let bench = after(endian, &[srs(step, w, Mode::Irq)], |core| {
                        let state = &mut core.state;
                        (state.r[13], state.r[14]) = (0x5000, 0x1234);
                        assert!(state.set_spsr(0x6000_0010));
                        set_sp_of(state, Mode::Irq, BASE);
                    });
                    let stored = [first, first + 4].map(|at| word_at(&bench, endian, at));
                    assert_eq!(stored, [0x1234, 0x6000_0010], "{step:02b} {endian:?}");
                    let mut state = bench.core.state.clone();
                    let sp = if w == 1 { written } else { BASE };
                    assert_eq!(sp_of(&mut state, Mode::Irq), sp, "{step:02b} W {w}");
                    assert_eq!((state.r[13], state.mode()), (0x5000, Mode::Supervisor));
                }
            }
        }
    }

    /// B9.3.16: `SRS` to the current mode's own stack moves its SP. In System mode, which has no
    /// SPSR, it stores the CPSR. In User mode, where it would reach another mode's SP, and for a
    /// mode the R profile hasn't got, it's UNDEFINED.
    #[test]
    fn srs_reaches_any_mode_s_stack_but_from_user_mode() {
        let bench = after(Endian::Little, &[srs(DB, 1, Mode::Supervisor)], |core| {
            (core.state.r[13], core.state.r[14]) = (BASE, 0x44);
        });
        assert_eq!(bench.core.state.r[13], BASE - 8);
        assert_eq!(word_at(&bench, Endian::Little, BASE - 8), 0x44);
        let bench = after(Endian::Big, &[srs(IA, 0, Mode::Abort)], |core| {
            set_sp_of(&mut core.state, Mode::Abort, BASE);
            core.state.set_mode(Mode::System);
        });
        let cpsr = bench.core.state.cpsr();
        assert_eq!(word_at(&bench, Endian::Big, BASE + 4), cpsr);
        undefined_after(srs(DB, 1, Mode::Irq), |core| {
            set_sp_of(&mut core.state, Mode::Irq, BASE);
            core.state.set_mode(Mode::User);
        });
        undefined(0xF96D_051A); // SRSDB sp!, #0x1A, Hyp mode
        undefined(0xF96D_0516); // SRSDB sp!, #0x16, Monitor mode
    }

    /// B9.3.13: `RFE` loads the PC and then the CPSR, each of the four ways, moving its base with
    /// `W`, and returns to the instruction set and mode the CPSR names, its banked SP among them.
    #[test]
    fn rfe_returns_to_the_pc_and_cpsr_it_loads() {
        let thumb_user = mask(cpsr::T) | mask(cpsr::Z) | Mode::User as u32;
        for (step, first, written) in [
            (IA, BASE, BASE + 8),
            (IB, BASE + 4, BASE + 8),
            (DA, BASE - 4, BASE - 8),
            (DB, BASE - 8, BASE - 8),
        ] {
            for endian in BOTH {
                for (w, psr, pc, sp) in [
                    (1, thumb_user, 0x2002, 0x7000),
                    (0, Mode::Abort as u32, 0x2000, 0x7100),
                ] {
                    let mut bench = Bench::arm(endian, &[rfe(step, w, 0)]);
                    place_words(&mut bench, endian, first, &[0x2003, psr]);
                    let state = &mut bench.core.state;
                    (state.r[0], state.r[13]) = (BASE, 0x5000);
                    set_sp_of(state, Mode::User, 0x7000);
                    set_sp_of(state, Mode::Abort, 0x7100);
                    assert_eq!(bench.run(1).1, 1, "{step:02b} {endian:?}");
                    let state = &bench.core.state;
                    let base = if w == 1 { written } else { BASE };
                    assert_eq!(
                        (state.r[15], state.cpsr(), state.r[0]),
                        (pc, psr, base),
                        "{step:02b} {endian:?}"
                    );
                    assert_eq!(state.r[13], sp, "{step:02b} {endian:?}");
                }
            }
        }
    }

    /// B9.3.13: `RFEIA sp!` from Supervisor mode moves Supervisor mode's SP past the two words,
    /// and the mode it returns to has its own SP.
    #[test]
    fn rfe_writes_back_the_sp_of_the_mode_it_leaves() {
        for endian in BOTH {
            let mut bench = Bench::arm(endian, &[rfe(IA, 1, 13)]);
            place_words(&mut bench, endian, BASE, &[0x2000, Mode::Abort as u32]);
            let state = &mut bench.core.state;
            state.r[13] = BASE;
            set_sp_of(state, Mode::Abort, 0x7100);
            assert_eq!(bench.run(1).1, 1, "{endian:?}");
            let mut state = bench.core.state.clone();
            assert_eq!(
                (state.r[15], state.mode(), state.r[13]),
                (0x2000, Mode::Abort, 0x7100),
                "{endian:?}"
            );
            assert_eq!(sp_of(&mut state, Mode::Supervisor), BASE + 8, "{endian:?}");
        }
    }

    /// B9.3.13: from User mode `RFE` is UNPREDICTABLE, and its `CPSRWriteByInstr()` changes the
    /// flags and the instruction set but no mask and no mode. A base of the PC reads as the address
    /// plus 8, and a writeback to it is UNDEFINED.
    #[test]
    fn rfe_from_user_mode_changes_no_mask_or_mode() {
        let mut bench = Bench::arm(Endian::Little, &[rfe(IA, 0, 15)]);
        place_words(
            &mut bench,
            Endian::Little,
            8,
            &[0x2001, FLAGS | mask(cpsr::T) | Mode::Fiq as u32],
        );
        bench.core.state.set_mode(Mode::User);
        assert_eq!(bench.run(1).1, 1);
        let state = &bench.core.state;
        assert_eq!(
            (state.r[15], state.cpsr()),
            (0x2000, FLAGS | 0x1F0 | Mode::User as u32)
        );
        undefined(rfe(IA, 1, 15));
    }

    /// A8.8.25 encoding A2: `BLX` with an immediate links the next instruction and branches to the
    /// PC and `imm24:H:'0'` in Thumb state, whatever the flags.
    #[test]
    fn blx_immediate_branches_to_thumb_state() {
        for (word, pc) in [
            (0xFA00_0001, 0xC), // BLX . + 0xC
            (0xFB00_0001, 0xE), // BLX . + 0xE
            (0xFAFF_FFFE, 0),   // BLX . + 0
        ] {
            let state = run(word, |s| s.z = 1);
            assert_eq!(
                (state.r[15], state.t, state.r[14]),
                (pc, 1, 4),
                "{word:#010x}"
            );
        }
    }

    /// Table A5-23's coprocessor rows are UNDEFINED, since no coprocessor of the R5 defines a
    /// `2` form, B5.6.2, and so are the rows beside `SRS` and `RFE` it leaves out.
    #[test]
    fn the_unconditional_coprocessor_forms_are_undefined() {
        for word in [
            0xFC80_5E00, // STC2 p14, c5, [r0]
            0xFC90_5E00, // LDC2 p14, c5, [r0]
            0xFC40_0F00, // MCRR2 p15, 0, r0, r0, c0
            0xFC50_0F00, // MRRC2 p15, 0, r0, r0, c0
            0xFE00_0F00, // CDP2 p15, 0, c0, c0, c0
            0xFE01_0F10, // MCR2 p15, 0, r0, c1, c0
            0xFE11_0F10, // MRC2 p15, 0, r0, c1, c0
            0xF800_0000, // 100xx0x0
            0xF850_0000, // 100xx1x1
        ] {
            undefined(word);
        }
    }

    /// B1.3.3: with `SCTLR.NMFI` set, `CPS` can clear `F` but not set it.
    #[test]
    fn cps_keeps_f_clear_with_nmfi() {
        let bench = after(Endian::Little, &[0xF10C_0040], |core| {
            core.sctlr |= mask(sctlr::NMFI);
            core.state.f = 0;
        }); // CPSID f
        assert_eq!(bench.core.state.f, 0);
    }
}
