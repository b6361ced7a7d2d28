// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The R profile's own Thumb instructions, DDI 0406C A6, which go ahead of the ones both
//! profiles share.
//!
//! Each one lowers through the ARM groups' code for the same operation. What's Thumb's alone is
//! the decode, the branches' offsets, and the IT block rules. Where A8 or B9 makes an instruction
//! UNPREDICTABLE inside an IT block, or anywhere but last in one, the core refuses it as UNDEFINED,
//! as it does a PC operand the pseudocode makes UNPREDICTABLE. An SP operand runs, but `MCR`'s is
//! refused.

use super::super::family::Family;
use super::super::registers::cpsr;
use super::{arm_data, arm_misc, coprocessor};
use crate::cpu::armv7::registers::{get, set};
use crate::cpu::armv7::translate::data32::Operation;
use crate::cpu::armv7::translate::{
    Emitter, Fault, Profile, Translated, Undefined, bits, compare_branch, long_offset,
    memory::Step, relative, sign_extend,
};

/// Table A6-6's `CBZ`, `CBNZ`, `SETEND`, `CPS`, `BKPT`, `IT` and the hints, by `opcode`, bits 11
/// to 5.
pub(super) fn miscellaneous16(e: &mut Emitter<'_, '_, Family>, hw: u16) -> Translated {
    let hw = u32::from(hw);
    match bits(hw, 11, 5) {
        // SETEND, A8.8.167 encoding T1.
        0b011_0010 => {
            outside_it(e)?;
            arm_misc::set_endianness(e, bits(hw, 3, 3) == 1);
        }
        // CPS, B9.3.1 encoding T1. With none of `A`, `I` and `F` it's UNPREDICTABLE, and the
        // pseudocode changes nothing.
        0b011_0011 => {
            outside_it(e)?;
            let imod = 0b10 | bits(hw, 4, 4);
            arm_misc::change_processor_state(e, imod, masks(bits(hw, 2, 0)), None);
        }
        // BKPT, A8.8.24, the debug event the exception model takes as a Prefetch Abort.
        0b111_0000..=0b111_0111 => Family::raise(e, Fault::Breakpoint),
        0b111_1000.. => if_then_hints(e, hw)?,
        _ => compare_branch_outside_it(e, hw)?,
    }
    Ok(())
}

/// A6.2.6, the conditional branch, `UDF` and `SVC`, Table A6-8.
pub(super) fn conditional_branch_supervisor_call(
    e: &mut Emitter<'_, '_, Family>,
    hw: u16,
) -> Translated {
    let hw = u32::from(hw);
    match bits(hw, 11, 8) {
        // UDF, A8.8.247 encoding T1.
        0b1110 => return Err(Undefined),
        // SVC, A8.8.228, which retires and returns past itself.
        0b1111 => Family::raise(e, Fault::SupervisorCall),
        // B, A8.8.18 encoding T1.
        cond => {
            outside_it(e)?;
            let target = relative(e, sign_extend(bits(hw, 7, 0) << 1, 9));
            let holds = e.condition(cond);
            e.branch_if(holds, target);
        }
    }
    Ok(())
}

/// The unconditional branch, A8.8.18 encoding T2.
pub(super) fn branch16(e: &mut Emitter<'_, '_, Family>, hw: u16) -> Translated {
    outside_or_last_in_it(e)?;
    let target = relative(e, sign_extend(bits(u32::from(hw), 10, 0) << 1, 12));
    e.branch_to(target);
    Ok(())
}

/// A6.3.4, the branches and miscellaneous control, Table A6-13, by `op`, bits 10 to 4 of the
/// first halfword, and `op1`, bits 14 to 12 of the second.
pub(super) fn branches_miscellaneous_control(
    e: &mut Emitter<'_, '_, Family>,
    hw1: u16,
    hw2: u16,
) -> Translated {
    let (hw1, hw2) = (u32::from(hw1), u32::from(hw2));
    let op = bits(hw1, 10, 4);
    // The banked `MRS` and `MSR` are the Virtualization Extensions', which the R profile hasn't
    // got, B9.1.
    let banked = bits(hw2, 5, 5) == 1;
    match bits(hw2, 14, 12) {
        0b000 | 0b010 => match op {
            // B, A8.8.18 encoding T3.
            _ if op & 0b011_1000 != 0b011_1000 => {
                outside_it(e)?;
                let imm = (bits(hw1, 10, 10) << 20)
                    | (bits(hw2, 11, 11) << 19)
                    | (bits(hw2, 13, 13) << 18)
                    | (bits(hw1, 5, 0) << 12)
                    | (bits(hw2, 10, 0) << 1);
                let target = relative(e, sign_extend(imm, 21));
                let holds = e.condition(bits(hw1, 9, 6));
                e.branch_if(holds, target);
            }
            0b011_1000 | 0b011_1001 | 0b011_1110 | 0b011_1111 if banked => return Err(Undefined),
            // MSR with a register, A8.8.112 and B9.3.12, whose application level form is the
            // system level one writing the top two bytes. A `mask` of 0000 is UNPREDICTABLE and
            // writes nothing.
            0b011_1000 | 0b011_1001 => {
                let n = bits(hw1, 3, 0);
                if n == 15 {
                    return Err(Undefined);
                }
                let value = e.reg(n);
                arm_misc::write_psr(e, bits(hw1, 4, 4) == 1, value, bits(hw2, 11, 8));
            }
            // Table A6-14, the hints when `op1`, bits 10 to 8, is 000, and CPS otherwise.
            0b011_1010 if bits(hw2, 10, 8) == 0 => arm_misc::hint(e, bits(hw2, 7, 0)),
            // CPS, B9.3.1 encoding T2. Its UNPREDICTABLE forms run the pseudocode, as the ARM
            // encoding's do.
            0b011_1010 => {
                outside_it(e)?;
                let mode = (bits(hw2, 8, 8) == 1).then(|| get(cpsr::M, hw2));
                arm_misc::change_processor_state(e, bits(hw2, 10, 9), masks(bits(hw2, 7, 5)), mode);
            }
            0b011_1011 => miscellaneous_control(e, hw2)?,
            // BXJ, A8.8.28, which DDI 0460D 3.9 makes BX on a core with no Jazelle hardware.
            0b011_1100 => {
                let m = bits(hw1, 3, 0);
                if m == 15 {
                    return Err(Undefined);
                }
                outside_or_last_in_it(e)?;
                let target = e.reg(m);
                Family::branch_exchange(e, target);
            }
            // SUBS PC, LR, B9.3.19. With an `imm8` of zero it's the encoding the Virtualization
            // Extensions call ERET, which Table A6-13's note a says is this instruction without
            // them.
            0b011_1101 => {
                outside_or_last_in_it(e)?;
                let imm32 = e.constant(bits(hw2, 7, 0));
                arm_data::exception_return(e, Operation::Sub, 14, imm32);
            }
            // MRS, A8.8.109 and B9.3.9.
            0b011_1110 | 0b011_1111 => {
                arm_misc::move_from_psr(e, bits(hw2, 11, 8), bits(hw1, 4, 4) == 1)?;
            }
            // HVC and SMC, which the R profile hasn't got, B9.1, and UDF encoding T2, A8.8.247.
            _ => return Err(Undefined),
        },
        // B, A8.8.18 encoding T4.
        0b001 | 0b011 => {
            outside_or_last_in_it(e)?;
            let target = relative(e, long_offset(hw1, hw2));
            e.branch_to(target);
        }
        // BL, A8.8.25 encoding T1, which leaves the next instruction's address in LR, in Thumb
        // state.
        0b101 | 0b111 => {
            outside_or_last_in_it(e)?;
            let target = relative(e, long_offset(hw1, hw2));
            let link = e.constant(e.next_pc() | 1);
            e.set_reg(14, link);
            e.branch_to(target);
        }
        // BLX with an immediate, A8.8.25 encoding T2, to `Align(PC, 4)` and the offset, in ARM
        // state. `H` set is UNDEFINED.
        _ => {
            if bits(hw2, 0, 0) == 1 {
                return Err(Undefined);
            }
            outside_or_last_in_it(e)?;
            let target = e.aligned_pc().wrapping_add(long_offset(hw1, hw2));
            let link = e.constant(e.next_pc() | 1);
            e.set_reg(14, link);
            let target = e.constant(target);
            Family::branch_exchange(e, target);
        }
    }
    Ok(())
}

/// Table A6-16's `SRS` and `RFE`, B9.3.15 and B9.3.13, by `op`, bits 8 and 7 of the first
/// halfword: 00 walks down before, and 11 up after.
pub(super) fn return_state(e: &mut Emitter<'_, '_, Family>, hw1: u16, hw2: u16) -> Translated {
    let (hw1, hw2) = (u32::from(hw1), u32::from(hw2));
    let step = if bits(hw1, 8, 7) == 0 {
        Step::DecrementBefore
    } else {
        Step::IncrementAfter
    };
    let wback = bits(hw1, 5, 5) == 1;
    if bits(hw1, 4, 4) == 0 {
        return arm_misc::store_return_state(e, get(cpsr::M, hw2), step, wback);
    }
    // B9.3.13 makes a base of the PC UNPREDICTABLE in Thumb state.
    let n = bits(hw1, 3, 0);
    if n == 15 {
        return Err(Undefined);
    }
    outside_or_last_in_it(e)?;
    arm_misc::return_from_exception(e, n, step, wback)
}

/// A6.3.18's coprocessor instructions for every coprocessor but CP10 and CP11. The encodings
/// below `coproc` are A5.6's with the condition field's place holding 1110, so the ARM group
/// lowers them. The `2` forms, with bit 12 of the first halfword set, are UNDEFINED, since none
/// of the R5's coprocessors defines one, B5.6.2 and DDI 0460D 4.2. So is the Advanced SIMD
/// space, `op1` of 11xxxx, which the R5 hasn't got, DDI 0460D 11.3.4 Table 11-8.
pub(super) fn coprocessor(e: &mut Emitter<'_, '_, Family>, hw1: u16, hw2: u16) -> Translated {
    let (hw1, hw2) = (u32::from(hw1), u32::from(hw2));
    if bits(hw1, 12, 12) == 1 || bits(hw1, 9, 8) == 0b11 {
        return Err(Undefined);
    }
    coprocessor::coprocessor_supervisor_call(e, hw1 << 16 | hw2)
}

/// CBZ and CBNZ, A8.8.29, which an IT block can't hold.
fn compare_branch_outside_it(e: &mut Emitter<'_, '_, Family>, hw: u32) -> Translated {
    outside_it(e)?;
    compare_branch(e, hw);
    Ok(())
}

/// Table A6-7's `IT` and the hints, by `opA`, bits 7 to 4, and `opB`, bits 3 to 0. Its hints are
/// numbered as the ARM ones are.
fn if_then_hints(e: &mut Emitter<'_, '_, Family>, hw: u32) -> Translated {
    let (firstcond, mask) = (bits(hw, 7, 4), bits(hw, 3, 0));
    if mask == 0 {
        arm_misc::hint(e, firstcond);
        return Ok(());
    }
    // IT, A8.8.54. A `firstcond` of 1111, or of 1110 with more than one instruction in the
    // block, is UNPREDICTABLE.
    if firstcond == 0b1111 || (firstcond == 0b1110 && mask.count_ones() != 1) {
        return Err(Undefined);
    }
    outside_it(e)?;
    e.set_next_it(bits(hw, 7, 0));
    Ok(())
}

/// Table A6-15, the miscellaneous control instructions, by `op`, bits 7 to 4. `ENTERX` and
/// `LEAVEX` are `ThumbEE`'s, which the R profile hasn't got.
fn miscellaneous_control(e: &mut Emitter<'_, '_, Family>, hw2: u32) -> Translated {
    match bits(hw2, 7, 4) {
        // CLREX, A8.8.32, the ARM row's `op2` of 0001.
        0b0010 => arm_misc::barrier(e, 0b0001),
        // DSB, DMB and ISB, numbered as the ARM rows are.
        op @ 0b0100..=0b0110 => arm_misc::barrier(e, op),
        _ => Err(Undefined),
    }
}

/// Refuses an instruction A8 and B9 say isn't permitted in an IT block, A2.5.2's `InITBlock()`.
fn outside_it(e: &Emitter<'_, '_, Family>) -> Translated {
    if e.in_it() { Err(Undefined) } else { Ok(()) }
}

/// Refuses an instruction A8 and B9 permit only outside an IT block or last in one,
/// `LastInITBlock()`, `ITSTATE<3:0>` of 1000, A2.5.2.
fn outside_or_last_in_it(e: &Emitter<'_, '_, Family>) -> Translated {
    if e.in_it() && bits(e.it, 3, 0) != 0b1000 {
        Err(Undefined)
    } else {
        Ok(())
    }
}

/// The masks `CPS` names by its `A`, `I` and `F`, bits 2 to 0 of `aif`, at the CPSR's bits.
fn masks(aif: u32) -> u32 {
    set(cpsr::A, 0, bits(aif, 2, 2))
        | set(cpsr::I, 0, bits(aif, 1, 1))
        | set(cpsr::F, 0, bits(aif, 0, 0))
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::registers::cpsr;
    use super::super::super::state::{Mode, State};
    use super::super::testing::{Bench, CODE, RAM};
    use crate::cpu::armv7::registers::mask;
    use crate::emulator::Exit;
    use crate::soc::Endian;

    /// `IT EQ`, a block of one instruction.
    const IT_EQ: u16 = 0xBF08;
    /// `ITT EQ`, a block of two.
    const ITT_EQ: u16 = 0xBF04;
    const NOP: u16 = 0xBF00;
    /// Where the tests' data is.
    const BASE: u32 = RAM + 0x100;
    /// `IFSR`'s fault status for a debug event, DDI 0460D Table 4-28.
    const DEBUG_EVENT: u32 = 0b0_0010;

    fn bench(code: &[u16], prepare: impl FnOnce(&mut State)) -> Bench {
        let mut bench = Bench::thumb(Endian::Little, code);
        prepare(&mut bench.core.state);
        bench
    }

    /// The state after `count` instructions of `code` ran from `prepare`, each retiring.
    fn ran(code: &[u16], count: u32, prepare: impl FnOnce(&mut State)) -> State {
        let mut bench = bench(code, prepare);
        assert_eq!(bench.run(count).1, u64::from(count), "{code:04x?}");
        assert_eq!(bench.taken(), None, "{code:04x?}");
        bench.core.state
    }

    /// The exception `code` raises from `prepare` with Z set, so that `IT EQ` runs its block, and
    /// the address it's raised at.
    fn raised(code: &[u16], prepare: impl FnOnce(&mut State)) -> Option<(Exception, u32)> {
        let mut bench = bench(code, |s| {
            s.z = 1;
            prepare(s);
        });
        bench.run(u32::try_from(code.len()).unwrap());
        bench.raised()
    }

    /// Whether `code` is refused as UNDEFINED at `at`.
    fn undefined(code: &[u16], at: u32, prepare: impl FnOnce(&mut State)) {
        assert_eq!(
            raised(code, prepare),
            Some((Exception::Undefined, at)),
            "{code:04x?}"
        );
    }

    /// `mode`'s SP set to `sp`, from any mode.
    fn set_sp_of(state: &mut State, mode: Mode, sp: u32) {
        let current = state.mode();
        state.set_mode(mode);
        state.r[13] = sp;
        state.set_mode(current);
    }

    /// A8.8.18 and A8.8.25: `B` in all four encodings, `BL` and `BLX` with an immediate, each
    /// from the PC as the instruction's address plus 4, and `BLX` from `Align(PC, 4)` to ARM
    /// state.
    #[test]
    fn the_branches_add_their_offsets_to_the_pc() {
        for (code, count, z, pc, lr, t) in [
            (&[0xD002][..], 1, 1, 8, 0, 1),               // BEQ +4
            (&[0xD002], 1, 0, 2, 0, 1),                   // BEQ +4, not taken
            (&[0xD0FE], 1, 1, 0, 0, 1),                   // BEQ .
            (&[0xE002], 1, 0, 8, 0, 1),                   // B +4
            (&[0xE7FE], 1, 0, 0, 0, 1),                   // B .
            (&[0xF040, 0x8080], 1, 0, 0x104, 0, 1),       // BNE.W +0x100
            (&[0xF040, 0x8080], 1, 1, 4, 0, 1),           // BNE.W, not taken
            (&[0xF001, 0xB800], 1, 0, 0x1004, 0, 1),      // B.W +0x1000
            (&[0xF001, 0xF800], 1, 0, 0x1004, 5, 1),      // BL +0x1000
            (&[NOP, 0xF001, 0xE800], 2, 0, 0x1004, 7, 0), // BLX +0x1000, from 2
        ] {
            let state = ran(code, count, |s| (s.z, s.r[14]) = (z, 0));
            assert_eq!(
                (state.r[15], state.r[14], state.t),
                (pc, lr, t),
                "{code:04x?}"
            );
        }
        undefined(&[0xF001, 0xE801], 0, |_| {}); // BLX with H set
    }

    /// A8.8.18 and A8.8.25: the conditional branches can't be in an IT block, and the others
    /// must be last in one. Elsewhere they're UNPREDICTABLE, and UNDEFINED here.
    #[test]
    fn a_branch_in_an_it_block_is_last_or_undefined() {
        for branch in [&[0xD002][..], &[0xF040, 0x8080]] {
            undefined(&[&[IT_EQ][..], branch].concat(), 2, |_| {});
        }
        for (branch, pc) in [
            (&[0xE002][..], 10),
            (&[0xF001, 0xB800], 0x1006),
            (&[0xF001, 0xF800], 0x1006),
            (&[0xF001, 0xE800], 0x1004),
        ] {
            undefined(&[&[ITT_EQ][..], branch, &[NOP]].concat(), 2, |_| {});
            let code = [&[IT_EQ][..], branch].concat();
            assert_eq!(ran(&code, 2, |s| s.z = 1).r[15], pc, "{code:04x?}");
        }
    }

    /// A8.8.29: `CBZ` branches when the register is zero and `CBNZ` when it isn't. Neither may be
    /// in an IT block.
    #[test]
    fn cbz_and_cbnz_test_the_register() {
        for (hw, r0, pc) in [
            (0xB110, 0, 8), // CBZ r0, +4
            (0xB110, 1, 2),
            (0xB910, 0, 2), // CBNZ r0, +4
            (0xB910, 1, 8),
        ] {
            assert_eq!(ran(&[hw], 1, |s| s.r[0] = r0).r[15], pc, "{hw:#06x} {r0}");
        }
        undefined(&[IT_EQ, 0xB110], 2, |_| {});
    }

    /// A8.8.228, A8.8.247 and A8.8.24: `SVC` takes its exception, both `UDF` encodings are
    /// UNDEFINED, and `BKPT` raises its debug event under no condition, in an IT block too.
    #[test]
    fn svc_udf_and_bkpt_raise_their_exceptions() {
        assert_eq!(
            raised(&[0xDF00], |_| {}),
            Some((Exception::SupervisorCall, 0))
        );
        undefined(&[0xDE00], 0, |_| {});
        undefined(&[0xF7F0, 0xA000], 0, |_| {});
        let mut bench = bench(&[IT_EQ, 0xBE00], |s| s.z = 0);
        bench.run(2);
        assert_eq!(
            (bench.raised(), bench.core.faults.ifsr),
            (Some((Exception::PrefetchAbort, 2)), DEBUG_EVENT)
        );
    }

    /// A8.8.54: `IT` runs its block under its condition. A `firstcond` of 1111, of 1110 with more
    /// than one instruction, and an `IT` in a block are UNPREDICTABLE, and UNDEFINED here.
    #[test]
    fn it_runs_its_block_under_its_condition() {
        let code = [IT_EQ, 0x2001, 0x2101]; // IT EQ; MOVEQ r0, #1; MOVS r1, #1
        for (z, r0) in [(1, 1), (0, 0)] {
            let state = ran(&code, 3, |s| (s.z, s.r[0], s.r[1]) = (z, 0, 0));
            assert_eq!((state.r[0], state.r[1], state.it), (r0, 1, 0), "Z {z}");
        }
        assert_eq!(ran(&[0xBFE8, 0x2001], 2, |s| s.r[0] = 0).r[0], 1); // IT AL
        undefined(&[0xBFF8], 0, |_| {});
        undefined(&[0xBFEC], 0, |_| {});
        undefined(&[IT_EQ, IT_EQ], 2, |_| {});
    }

    /// Tables A6-7 and A6-14: `SEV` sets the event register, `WFI` waits, and `NOP`, `YIELD`,
    /// `DBG` and the unallocated hints change nothing.
    #[test]
    fn the_hints_run_as_the_arm_ones_do() {
        for code in [&[0xBF40][..], &[0xF3AF, 0x8004]] {
            assert_eq!(ran(code, 1, |s| s.event = 0).event, 1, "{code:04x?}");
        }
        for code in [&[0xBF30][..], &[0xF3AF, 0x8003]] {
            assert_eq!(bench(code, |_| {}).run(1).0, Exit::Waiting, "{code:04x?}");
        }
        for code in [
            &[NOP][..],
            &[0xBF10],
            &[0xBF50],
            &[0xF3AF, 0x8000],
            &[0xF3AF, 0x80F0],
            &[0xF3AF, 0x8012],
        ] {
            let before = bench(code, |_| {}).core.state;
            let after = ran(code, 1, |_| {});
            assert_eq!(after.cpsr(), before.cpsr(), "{code:04x?}");
            assert_eq!(after.r[..15], before.r[..15], "{code:04x?}");
        }
    }

    /// Table A6-15: `CLREX` opens the monitor, the barriers change nothing, and `ENTERX`,
    /// `LEAVEX` and the unallocated rows are UNDEFINED.
    #[test]
    fn clrex_and_the_barriers() {
        let clrex = [0xF3BF, 0x8F2F];
        assert_eq!(ran(&clrex, 1, |s| s.exclusive_valid = 1).exclusive_valid, 0);
        for hw2 in [0x8F4F, 0x8F5F, 0x8F6F] {
            let state = ran(&[0xF3BF, hw2], 1, |s| s.exclusive_valid = 1);
            assert_eq!(state.exclusive_valid, 1, "{hw2:#06x}");
        }
        for hw2 in [0x8F0F, 0x8F1F, 0x8F3F, 0x8F7F] {
            undefined(&[0xF3BF, hw2], 0, |_| {});
        }
    }

    /// B9.3.1: `CPS` in both encodings changes the masks it names and the mode, nothing in User
    /// mode, and runs the pseudocode for its UNPREDICTABLE forms. It can't be in an IT block.
    #[test]
    fn cps_changes_the_masks_and_the_mode() {
        let clear = (0, 0, 0);
        let all = (1, 1, 1);
        for (code, user, before, after) in [
            (&[0xB672][..], false, clear, (0, 1, 0, Mode::Supervisor)), // CPSID i
            (&[0xB667], false, all, (0, 0, 0, Mode::Supervisor)),       // CPSIE aif
            (&[0xB670], false, clear, (0, 0, 0, Mode::Supervisor)),     // CPSID, none named
            (&[0xF3AF, 0x8640], false, clear, (0, 1, 0, Mode::Supervisor)), // CPSID.W i
            (&[0xF3AF, 0x8112], false, all, (1, 1, 1, Mode::Irq)),      // CPS #0x12
            (&[0xF3AF, 0x8731], false, clear, (0, 0, 1, Mode::Fiq)),    // CPSID.W f, #0x11
            (&[0xF3AF, 0x8352], false, clear, (0, 0, 0, Mode::Irq)),    // imod 01, #0x12
            (&[0xB672], true, clear, (0, 0, 0, Mode::User)),            // CPSID i
            (&[0xF3AF, 0x8112], true, all, (1, 1, 1, Mode::User)),      // CPS #0x12
        ] {
            let state = ran(code, 1, |s| {
                (s.a, s.i, s.f) = before;
                if user {
                    s.set_mode(Mode::User);
                }
            });
            assert_eq!(
                (state.a, state.i, state.f, state.mode()),
                after,
                "{code:04x?}"
            );
        }
        undefined(&[IT_EQ, 0xB672], 2, |_| {});
        undefined(&[IT_EQ, 0xF3AF, 0x8640], 2, |_| {});
    }

    /// A8.8.167: `SETEND` changes the byte order of the data that follows, and can't be in an IT
    /// block.
    #[test]
    fn setend_changes_the_byte_order_of_the_data_that_follows() {
        // SETEND BE; STR r1, [r2]; SETEND LE; STR r1, [r2, #4]
        let code = [0xB658, 0x6011, 0xB650, 0x6051];
        let mut bench = bench(&code, |s| (s.r[1], s.r[2]) = (0x1122_3344, BASE));
        assert_eq!(bench.run(4).1, 4);
        let stored: Vec<u8> = (BASE..BASE + 8).map(|at| bench.byte(at)).collect();
        assert_eq!(stored, [0x11, 0x22, 0x33, 0x44, 0x44, 0x33, 0x22, 0x11]);
        undefined(&[IT_EQ, 0xB658], 2, |_| {});
    }

    /// B9.3.9 and B9.3.12: `MRS` reads the CPSR less its execution state bits or the SPSR, and
    /// `MSR` writes the bytes its mask selects, none for a mask of 0000, which is UNPREDICTABLE. A
    /// PC operand is UNPREDICTABLE and UNDEFINED here, an SP runs the pseudocode, and the banked
    /// forms are UNDEFINED.
    #[test]
    fn mrs_and_msr_reach_the_cpsr_and_the_spsr() {
        let spsr = 0x6000_0010;
        for (hw2, d) in [(0x8000, 0), (0x8D00, 13)] {
            let state = ran(&[0xF3EF, hw2], 1, |s| s.q = 1);
            let expected = state.cpsr() & !mask(cpsr::T);
            assert_eq!(state.r[d], expected, "{hw2:#06x}");
        }
        let state = ran(&[0xF3FF, 0x8000], 1, |s| assert!(s.set_spsr(spsr)));
        assert_eq!(state.r[0], spsr);

        let state = ran(&[0xF381, 0x8100], 1, |s| s.r[1] = 0x92); // MSR CPSR_c, r1
        assert_eq!((state.mode(), state.i, state.t), (Mode::Irq, 1, 1));
        let state = ran(&[0xF381, 0x8800], 1, |s| s.r[1] = 0xF800_0000); // MSR APSR_nzcvq, r1
        assert_eq!(
            (state.n, state.z, state.c, state.v, state.q),
            (1, 1, 1, 1, 1)
        );
        let state = ran(&[0xF391, 0x8F00], 1, |s| s.r[1] = spsr); // MSR SPSR_fsxc, r1
        assert_eq!(state.spsr(), Some(spsr));
        let before = bench(&[], |_| {}).core.state.cpsr();
        assert_eq!(ran(&[0xF381, 0x8000], 1, |s| s.r[1] = !0).cpsr(), before);

        for code in [
            [0xF3EF, 0x8F00], // MRS pc, CPSR
            [0xF3EF, 0x8020], // MRS r0, R8_usr
            [0xF38F, 0x8100], // MSR CPSR_c, pc
            [0xF381, 0x8120], // MSR R8_usr, r1
            [0xF7E0, 0x8000], // HVC #0
            [0xF7F0, 0x8000], // SMC #0
        ] {
            undefined(&code, 0, |_| {});
        }
    }

    /// A8.8.28: `BXJ` is `BX`, DDI 0460D 3.9, taking the instruction set from bit 0, last in an
    /// IT block or outside one. A PC operand is UNPREDICTABLE and UNDEFINED here.
    #[test]
    fn bxj_takes_the_instruction_set_from_bit_0() {
        for (r1, pc, t) in [(0x2001, 0x2000, 1), (0x2004, 0x2004, 0)] {
            let state = ran(&[0xF3C1, 0x8F00], 1, |s| s.r[1] = r1);
            assert_eq!((state.r[15], state.t), (pc, t), "{r1:#x}");
        }
        assert_eq!(
            ran(&[IT_EQ, 0xF3C1, 0x8F00], 2, |s| (s.z, s.r[1]) = (1, 0x2001)).r[15],
            0x2000
        );
        undefined(&[0xF3CF, 0x8F00], 0, |_| {});
        undefined(&[ITT_EQ, 0xF3C1, 0x8F00, NOP], 2, |_| {});
    }

    /// B9.3.19: `SUBS PC, LR` returns to LR less `imm8` with the SPSR as the CPSR, with an `imm8`
    /// of zero too, last in an IT block or outside one.
    #[test]
    fn subs_pc_lr_returns_from_the_exception() {
        let spsr = Mode::Supervisor as u32 | mask(cpsr::T) | mask(cpsr::Z);
        for (hw2, pc) in [(0x8F04, 0x1000), (0x8F00, 0x1004)] {
            let state = ran(&[0xF3DE, hw2], 1, |s| {
                s.set_mode(Mode::Irq);
                s.r[14] = 0x1004;
                assert!(s.set_spsr(spsr));
            });
            assert_eq!((state.r[15], state.cpsr()), (pc, spsr), "{hw2:#06x}");
        }
        undefined(&[ITT_EQ, 0xF3DE, 0x8F04, NOP], 2, |_| {});
    }

    /// B9.3.15: `SRS` stores LR and the SPSR on the stack of the mode it names, walking down
    /// before or up after, with `W`. From User mode, or to a mode the R profile hasn't got, it's
    /// UNPREDICTABLE, and UNDEFINED here.
    #[test]
    fn srs_stores_lr_and_the_spsr_on_the_named_mode_s_stack() {
        let spsr = 0x6000_0010;
        for (code, first, sp) in [
            ([0xE82D, 0xC012], BASE - 8, BASE - 8), // SRSDB sp!, #0x12
            ([0xE80D, 0xC012], BASE - 8, BASE),     // SRSDB sp, #0x12
            ([0xE9AD, 0xC012], BASE, BASE + 8),     // SRSIA sp!, #0x12
        ] {
            let mut bench = bench(&code, |s| {
                s.r[14] = 0x1234;
                assert!(s.set_spsr(spsr));
                set_sp_of(s, Mode::Irq, BASE);
            });
            assert_eq!(bench.run(1).1, 1, "{code:04x?}");
            let word = |at: u32| u32::from_le_bytes([0, 1, 2, 3].map(|i| bench.byte(at + i)));
            assert_eq!(
                [word(first), word(first + 4)],
                [0x1234, spsr],
                "{code:04x?}"
            );
            let mut state = bench.core.state.clone();
            state.set_mode(Mode::Irq);
            assert_eq!(state.r[13], sp, "{code:04x?}");
        }
        undefined(&[0xE82D, 0xC01A], 0, |_| {}); // to Hyp mode
        undefined(&[0xE82D, 0xC012], 0, |s| s.set_mode(Mode::User));
    }

    /// B9.3.13: `RFE` loads the PC and then the CPSR, walking down before or up after, with `W`,
    /// last in an IT block or outside one. A base of the PC is UNPREDICTABLE, and UNDEFINED here.
    #[test]
    fn rfe_loads_the_pc_and_the_cpsr() {
        let psr = Mode::User as u32 | mask(cpsr::T) | mask(cpsr::C);
        for (code, r0, written) in [
            ([0xE9B0, 0xC000], BASE, BASE + 8),     // RFEIA r0!
            ([0xE810, 0xC000], BASE + 8, BASE + 8), // RFEDB r0
        ] {
            let mut bench = bench(&code, |s| s.r[0] = r0);
            bench.write(BASE, &0x2001_u32.to_le_bytes());
            bench.write(BASE + 4, &psr.to_le_bytes());
            assert_eq!(bench.run(1).1, 1, "{code:04x?}");
            let state = &bench.core.state;
            assert_eq!(
                (state.r[15], state.cpsr(), state.r[0]),
                (0x2000, psr, written)
            );
        }
        undefined(&[0xE81F, 0xC000], 0, |_| {});
        undefined(&[ITT_EQ, 0xE990, 0xC000, NOP], 2, |s| s.r[0] = BASE);
    }

    /// A6.3.18: CP15's `MRC` reads what the ARM encoding does, `LDC` from the PC reads from
    /// `Align(PC, 4)`, and the `2` forms, `CDP`, and the Advanced SIMD space are UNDEFINED.
    #[test]
    fn the_coprocessor_rows_run_through_the_arm_group() {
        let thumb = ran(&[0xEE11, 0x0F10], 1, |_| {}).r[0]; // MRC p15, 0, r0, c1, c0, 0
        let mut arm = Bench::arm(Endian::Little, &[0xEE11_0F10]);
        assert_eq!(arm.run(1).1, 1);
        assert_eq!(thumb, arm.core.state.r[0]);
        // LDC p14, c5, [pc, #4] from a halfword short of a word, near the end of the code, so it
        // reads Align(PC, 4) + 4 past it, where only the bus answers.
        let at = CODE + 0x1_0000 - 6;
        let mut bench = Bench::thumb(Endian::Little, &[]);
        bench.place_thumb(at, &[0xED9F, 0x5E01]);
        bench.core.state.r[15] = at;
        bench.run(1);
        let seen: Vec<u64> = bench
            .bus
            .accesses
            .iter()
            .map(|access| access.address)
            .collect();
        assert_eq!(seen, [u64::from(CODE) + 0x1_0000]);
        for code in [
            [0xEE0D, 0xDF90], // MCR p15, 0, r13, c13, c0, 4, from the SP, A8.8.98
            [0xFE11, 0x0F10], // MRC2 p15, 0, r0, c1, c0, 0
            [0xEE11, 0x0F00], // CDP p15, 1, c0, c1, c0, 0
            [0xEF11, 0x0F10],
        ] {
            undefined(&code, 0, |_| {});
        }
    }
}
