// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The R profile's own floating-point system registers, DDI 0406C B1.11.2: `VMRS` and `VMSR` with
//! `FPSID`, `FPEXC`, `MVFR0` and `MVFR1`, B9.3.21 and B9.3.22. With `FPSCR` they're the shared
//! decode's, A8.8.348 and A8.8.349.
//!
//! These check that `CPACR` grants CP10 and CP11 but not `FPEXC.EN`, and they're UNDEFINED in User
//! mode, B1.11.1. The R5 defines no subarchitecture registers, DDI 0460D Table 11-2, so those are
//! UNDEFINED. Where the manual says UNPREDICTABLE, a register Table B1-24 leaves unallocated, `Rt`
//! as the PC, or as the SP in Thumb state, this takes it as UNDEFINED, the simplest outcome each
//! case allows.

use std::mem::offset_of;

use cranelift_codegen::ir::InstBuilder;

use super::super::family::Family;
use super::super::registers::{fpexc, mvfr0};
use super::super::state::State;
use super::arm_misc::refuse_in_user_mode;
use crate::cpu::armv7::registers::{mask, set};
use crate::cpu::armv7::translate::float::Fpu;
use crate::cpu::armv7::translate::{Emitter, InstructionSet, Translated, Undefined, bits};

/// `FPSID`: ARM's hardware `VFPv3` with the Common VFP subarchitecture v2, the Cortex-R5F at r1p2,
/// DDI 0460D Table 11-4.
const FPSID: u32 = 0x4102_3153;
/// `MVFR1`, DDI 0460D Table 11-8: no half precision or Advanced SIMD, NaN propagation and
/// denormals.
const MVFR1: u32 = 0x0000_0011;
/// The bits of `FPEXC` that aren't read as zero, DDI 0460D Table 11-6.
const FPEXC_WRITABLE: u32 = mask(fpexc::EN) | mask(fpexc::DEX);

/// `MVFR0` for `fpu`, DDI 0460D Table 11-7: every rounding mode, square root, divide, `VFPv3`
/// single precision, and double precision with sixteen double registers where the unit has it. No
/// short vectors and no trapping.
const fn mvfr0(fpu: Fpu) -> u32 {
    let double = match fpu {
        Fpu::VfpV3D16 => 2,
        _ => 0,
    };
    let fields = set(mvfr0::RM, 0, 1) | set(mvfr0::SR, 0, 1) | set(mvfr0::D, 0, 1);
    fields | set(mvfr0::DP, 0, double) | set(mvfr0::SP, 0, 2) | set(mvfr0::RB, 0, 1)
}

/// A system register other than `FPSCR`, by its `reg` field, Table B1-24.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Register {
    Fpsid,
    Mvfr1,
    Mvfr0,
    Fpexc,
}

impl Register {
    fn of(reg: u32) -> Option<Self> {
        match reg {
            0b0000 => Some(Self::Fpsid),
            0b0110 => Some(Self::Mvfr1),
            0b0111 => Some(Self::Mvfr0),
            0b1000 => Some(Self::Fpexc),
            _ => None,
        }
    }
}

/// Whether the Thumb encoding `hw1`, `hw2`, or an ARM one with `1110` on top, is `VMRS` or `VMSR`
/// with a register other than `FPSCR`, B9.3.21 and B9.3.22, which [`system_register`] lowers.
pub(super) fn owns(hw1: u16, hw2: u16) -> bool {
    hw1 & 0xFFE0 == 0xEEE0 && hw2 & 0x0F10 == 0x0A10 && hw1 & 0xF != 0b0001
}

/// `VMRS` and `VMSR` with `FPSID`, `FPEXC`, `MVFR0` or `MVFR1`, B9.3.21 and B9.3.22. `FPSID`,
/// `MVFR0` and `MVFR1` are read-only, and a write to `FPSID` does nothing but serialize, DDI 0460D
/// 11.3.
pub(super) fn system_register(e: &mut Emitter<'_, '_, Family>, hw1: u16, hw2: u16) -> Translated {
    let (hw1, hw2) = (u32::from(hw1), u32::from(hw2));
    let read = bits(hw1, 4, 4) == 1;
    let t = bits(hw2, 15, 12);
    let sp = t == 13 && e.state() == InstructionSet::Thumb;
    // The should-be-zero bits, `(0)`, A5.1.1.
    if bits(hw2, 7, 5) != 0 || bits(hw2, 3, 0) != 0 || t == 15 || sp || e.features.fpu == Fpu::None
    {
        return Err(Undefined);
    }
    let register = match Register::of(bits(hw1, 3, 0)) {
        Some(register) if read || matches!(register, Register::Fpsid | Register::Fpexc) => register,
        _ => return Err(Undefined),
    };
    Family::check_vfp_enabled(e, false);
    refuse_in_user_mode(e);
    if read {
        let value = match register {
            Register::Fpsid => e.constant(FPSID),
            Register::Mvfr1 => e.constant(MVFR1),
            Register::Mvfr0 => e.constant(mvfr0(e.features.fpu)),
            Register::Fpexc => e.load_field(offset_of!(State, fpexc)),
        };
        e.set_reg(t, value);
    } else if register == Register::Fpexc {
        let value = e.reg(t);
        let value = e.b.ins().band_imm_s(value, i64::from(FPEXC_WRITABLE));
        e.store_field(offset_of!(State, fpexc), value);
        // The next instruction's check reads `FPEXC.EN` again.
        e.end_block();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::family::{Options, SystemRegister, Ties};
    use super::super::super::registers::cpacr;
    use super::super::super::state::{Mode, State};
    use super::super::testing::{Bench, CODE, RAM, ties};
    use super::*;
    use crate::cpu::armv7::registers::fpscr;
    use crate::soc::Endian;

    const BOTH: [Endian; 2] = [Endian::Little, Endian::Big];
    /// The Undefined Instruction exception, taken at the instruction at 0.
    const UNDEFINED: Option<(Exception, u32)> = Some((Exception::Undefined, 0));
    /// `CPACR`, DDI 0460D 4.3.15.
    const CPACR: SystemRegister = SystemRegister {
        opc1: 0,
        crn: 1,
        crm: 0,
        opc2: 2,
    };
    const FULL: u32 = mask(cpacr::CP10) | mask(cpacr::CP11);
    /// `CPACR` granting CP10 and CP11 at PL1 only.
    const PRIVILEGED: u32 = 0b0101 << 20;

    /// A bench about to run ARM `code` with CP10 and CP11 granted and `FPEXC.EN` set.
    fn enabled(endian: Endian, code: &[u32]) -> Bench {
        let mut bench = Bench::arm(endian, code);
        grant(&mut bench, FULL, mask(fpexc::EN));
        bench
    }

    fn grant(bench: &mut Bench, cpacr: u32, fpexc: u32) {
        assert!(bench.core.cp15_write(CPACR, cpacr, 0));
        bench.core.state.fpexc = fpexc;
    }

    /// Runs ARM `code` to its end on a bench `prepare` sets up, and asserts nothing was raised.
    fn ran(code: &[u32], prepare: impl FnOnce(&mut State)) -> State {
        let mut bench = enabled(Endian::Little, code);
        prepare(&mut bench.core.state);
        bench.run(u32::try_from(code.len()).unwrap());
        assert_eq!(bench.raised(), None, "{code:#010x?}");
        bench.core.state.clone()
    }

    /// Whether ARM `word` raises the Undefined Instruction exception with the unit on, in
    /// Supervisor mode.
    fn refused(word: u32) -> bool {
        let mut bench = enabled(Endian::Little, &[word]);
        bench.run(1);
        bench.raised() == UNDEFINED
    }

    /// `word` as Thumb halfwords, its top four bits `1110` for the ARM condition, A7.5 to A7.9.
    fn thumb(word: u32) -> [u16; 2] {
        let word = word & 0x0FFF_FFFF | 0xE000_0000;
        [word >> 16, word & 0xFFFF].map(|half| u16::try_from(half).unwrap())
    }

    /// A7.5's data-processing encoding with `opc1` and `op`, `d`, `n` and `m` the `Vd`, `Vn` and
    /// `Vm` fields with `D`, `N` and `M` clear, under AL.
    fn data(opc1: u32, op: u32, double: bool, (d, n, m): (u32, u32, u32)) -> u32 {
        0xEE00_0A00
            | (opc1 >> 3) << 23
            | (opc1 >> 1 & 1) << 21
            | (opc1 & 1) << 20
            | n << 16
            | d << 12
            | u32::from(double) << 8
            | op << 6
            | m
    }

    /// Table A7-17's other data-processing instructions, by `opc2` and bit 7.
    fn other(opc2: u32, high: u32, double: bool, d: u32, m: u32) -> u32 {
        data(0b1011, 1, double, (d, opc2, m)) | high << 7
    }

    /// `S2`, `S4` and `S6`, or `D1`, `D2` and `D3`.
    const OPERANDS: (u32, u32, u32) = (1, 2, 3);

    /// Puts `values` in the operand registers in `double`, or single precision.
    fn place(state: &mut State, double: bool, values: [f64; 3]) {
        for (register, value) in [2, 4, 6].into_iter().zip(values) {
            put(state, double, register, value);
        }
    }

    fn put(state: &mut State, double: bool, register: usize, value: f64) {
        if double {
            let bits = value.to_bits();
            state.s[register] = u32::try_from(bits & 0xFFFF_FFFF).unwrap();
            state.s[register + 1] = u32::try_from(bits >> 32).unwrap();
        } else {
            #[expect(clippy::cast_possible_truncation, reason = "every value is a single's")]
            let single = value as f32;
            state.s[register] = single.to_bits();
        }
    }

    /// `S2`, or `D1`.
    fn result(state: &State, double: bool) -> f64 {
        if double {
            f64::from_bits(u64::from(state.s[3]) << 32 | u64::from(state.s[2]))
        } else {
            f64::from(f32::from_bits(state.s[2]))
        }
    }

    /// A7.5: each data-processing instruction in both precisions, on `1`, `5` and `2.5`, whose
    /// results are exact in either.
    #[test]
    fn every_data_processing_instruction_runs_in_both_precisions() {
        let cases = [
            ("VMLA", data(0b0000, 0, false, OPERANDS), 13.5),
            ("VMLS", data(0b0000, 1, false, OPERANDS), -11.5),
            ("VNMLS", data(0b0001, 0, false, OPERANDS), 11.5),
            ("VNMLA", data(0b0001, 1, false, OPERANDS), -13.5),
            ("VMUL", data(0b0010, 0, false, OPERANDS), 12.5),
            ("VNMUL", data(0b0010, 1, false, OPERANDS), -12.5),
            ("VADD", data(0b0011, 0, false, OPERANDS), 7.5),
            ("VSUB", data(0b0011, 1, false, OPERANDS), 2.5),
            ("VDIV", data(0b1000, 0, false, OPERANDS), 2.0),
            // imm8 0x78 is 1.5, A7.5.1.
            ("VMOV imm", data(0b1011, 0, false, (1, 7, 8)), 1.5),
            ("VMOV", other(0b0000, 0, false, 1, 3), 2.5),
            ("VABS", other(0b0000, 1, false, 1, 3), 2.5),
            ("VNEG", other(0b0001, 0, false, 1, 3), -2.5),
        ];
        for double in [false, true] {
            for (name, word, expected) in cases {
                let word = word | u32::from(double) << 8;
                let state = ran(&[word], |state| place(state, double, [1.0, 5.0, 2.5]));
                assert_eq!(
                    result(&state, double).to_bits(),
                    f64::to_bits(expected),
                    "{name} {double}"
                );
                assert_eq!(state.fpscr, 0, "{name} {double}");
            }
            // VNEG then VABS of the result, which clears the sign again.
            let code = [
                other(0b0001, 0, double, 1, 3),
                other(0b0000, 1, double, 1, 1),
            ];
            let state = ran(&code, |state| place(state, double, [1.0, 5.0, 2.5]));
            assert_eq!(result(&state, double).to_bits(), f64::to_bits(2.5));
        }
        let sqrt = other(0b0001, 1, false, 1, 3);
        let state = ran(&[sqrt], |state| place(state, false, [0.0, 0.0, 2.5]));
        assert_eq!(state.s[2], 2.5_f32.sqrt().to_bits());
        assert_eq!(state.fpscr, mask(fpscr::IXC));
        let state = ran(&[sqrt | 1 << 8], |state| {
            place(state, true, [0.0, 0.0, 2.5]);
        });
        assert_eq!(result(&state, true).to_bits(), f64::to_bits(2.5_f64.sqrt()));
        assert_eq!(state.fpscr, mask(fpscr::IXC));
    }

    /// A7.5's compares and conversions in both precisions.
    #[test]
    fn compares_and_conversions_run_in_both_precisions() {
        for double in [false, true] {
            // VCMP and VCMPE of `1` with `2.5`, and with zero: less, then greater.
            for (word, nzcv) in [
                (other(0b0100, 0, double, 1, 3), 0b1000),
                (other(0b0100, 1, double, 1, 3), 0b1000),
                (other(0b0101, 0, double, 1, 0), 0b0010),
                (other(0b0101, 1, double, 1, 0), 0b0010),
            ] {
                let state = ran(&[word], |state| place(state, double, [1.0, 5.0, 2.5]));
                assert_eq!(state.fpscr >> 28, nzcv, "{word:#010x}");
            }
            // VCVT to a signed integer toward zero, and VCVTR to nearest, A8.8.306: 2 from 2.5.
            for word in [
                other(0b1101, 1, double, 1, 3),
                other(0b1101, 0, double, 1, 3),
            ] {
                let state = ran(&[word], |state| place(state, double, [0.0, 0.0, 2.5]));
                assert_eq!(state.s[2], 2, "{word:#010x}");
            }
            // VCVT from a signed integer, -7 in `S6`.
            let state = ran(&[other(0b1000, 1, double, 1, 3)], |state| {
                state.s[6] = (-7_i32).cast_unsigned();
            });
            assert_eq!(result(&state, double).to_bits(), f64::to_bits(-7.0));
            // VCVT from signed 32-bit fixed point with 16 fraction bits, A8.8.308, in place.
            let state = ran(&[other(0b1010, 1, double, 1, 8)], |state| {
                state.s[2] = 0x0001_8000;
            });
            assert_eq!(result(&state, double).to_bits(), f64::to_bits(1.5));
            // And back, to fixed point.
            let state = ran(&[other(0b1110, 1, double, 1, 8)], |state| {
                put(state, double, 2, -1.5);
            });
            assert_eq!(state.s[2], (-0x0001_8000_i32).cast_unsigned());
        }
        // VCVT between precisions, A8.8.309: single `S6` into `D1`, and double `D3` into `S2`.
        let state = ran(&[other(0b0111, 1, false, 1, 3)], |state| {
            place(state, false, [0.0, 0.0, 2.5]);
        });
        assert_eq!(result(&state, true).to_bits(), f64::to_bits(2.5));
        let state = ran(&[other(0b0111, 1, true, 1, 3)], |state| {
            place(state, true, [0.0, 0.0, 2.5]);
        });
        assert_eq!(result(&state, false).to_bits(), f64::to_bits(2.5));
    }

    /// The arithmetic takes its rounding, flushing and default NaN from `FPSCR`, A2.7.
    #[test]
    fn fpscr_controls_the_arithmetic() {
        let divide = data(0b1000, 0, false, OPERANDS);
        let toward_zero = 0b11 << 22;
        let third = |fpscr: u32| {
            let state = ran(&[divide], |state| {
                place(state, false, [0.0, 1.0, 3.0]);
                state.fpscr = fpscr;
            });
            state.s[2]
        };
        assert_eq!(third(0), (1.0_f32 / 3.0).to_bits());
        assert_eq!(third(toward_zero), (1.0_f32 / 3.0).to_bits() - 1);
        // FZ flushes a denormal input to zero and sets IDC, A2.7.3.
        let state = ran(&[data(0b0011, 0, false, OPERANDS)], |state| {
            state.s[4] = 1;
            state.fpscr = mask(fpscr::FZ);
        });
        assert_eq!(state.s[2], 0);
        assert_eq!(state.fpscr, mask(fpscr::FZ) | mask(fpscr::IDC));
        // DN gives the default NaN for a NaN operand, A2.7.4.
        let state = ran(&[data(0b0011, 0, false, OPERANDS)], |state| {
            state.s[4] = 0x7FC0_1234;
            state.fpscr = mask(fpscr::DN);
        });
        assert_eq!(state.s[2], 0x7FC0_0000);
    }

    /// The bytes `value` takes in memory of `endian`.
    fn bytes(endian: Endian, value: u64) -> [u8; 8] {
        match endian {
            Endian::Little => value.to_le_bytes(),
            Endian::Big => value.to_be_bytes(),
        }
    }

    /// A7.6: VLDR and VSTR of a single and a double, a double's high word first in big-endian
    /// memory, A8.8.333 and A8.8.413.
    #[test]
    fn loads_and_stores_move_words_in_the_parts_byte_order() {
        let value = 1.5_f64.to_bits();
        for endian in BOTH {
            // VLDR d1, [r0], VSTR d1, [r0, #8], VLDR s4, [r0], VSTR s4, [r0, #-4]
            let code = [0xED90_1B00, 0xED80_1B02, 0xED90_2A00, 0xED00_2A01];
            let mut bench = enabled(endian, &code);
            bench.write(RAM + 0x10, &bytes(endian, value));
            bench.core.state.r[0] = RAM + 0x10;
            bench.run(4);
            assert_eq!(bench.raised(), None);
            let state = &bench.core.state;
            assert_eq!(
                result(state, true).to_bits(),
                f64::to_bits(1.5),
                "{endian:?}"
            );
            let stored: Vec<u8> = (0x18..0x20)
                .map(|offset| bench.byte(RAM + offset))
                .collect();
            assert_eq!(stored, bytes(endian, value), "{endian:?}");
            let first = &bytes(endian, value)[..4];
            let word = match endian {
                Endian::Little => u32::from_le_bytes(first.try_into().unwrap()),
                Endian::Big => u32::from_be_bytes(first.try_into().unwrap()),
            };
            assert_eq!(bench.core.state.s[4], word, "{endian:?}");
            let below: Vec<u8> = (0xC..0x10).map(|offset| bench.byte(RAM + offset)).collect();
            assert_eq!(below, first, "{endian:?}");
        }
    }

    /// A7.6: VPUSH, VPOP, VSTM and VLDM, A8.8.367, A8.8.368, A8.8.412 and A8.8.332.
    #[test]
    fn multiple_transfers_write_back_and_keep_the_order() {
        for endian in BOTH {
            // VPUSH {d0, d1}, VPOP {d2, d3}, VSTMIA r0!, {s0-s2}, VLDMDB r0!, {s8-s10}
            let code = [0xED2D_0B04, 0xECBD_2B04, 0xECA0_0A03, 0xED30_4A03];
            let mut bench = enabled(endian, &code);
            let words = [0x1111_1111, 0x2222_2222, 0x3333_3333, 0x4444_4444];
            bench.core.state.s[..4].copy_from_slice(&words);
            bench.core.state.r[13] = RAM + 0x100;
            bench.core.state.r[0] = RAM + 0x200;
            bench.run(2);
            let state = &bench.core.state;
            assert_eq!(state.s[4..8], words, "{endian:?}");
            assert_eq!(state.r[13], RAM + 0x100, "{endian:?}");
            // The first double went to the lowest address, high word first in big-endian memory.
            let low: Vec<u8> = (0..8)
                .map(|offset| bench.byte(RAM + 0xF0 + offset))
                .collect();
            assert_eq!(low, bytes(endian, 0x2222_2222_1111_1111), "{endian:?}");
            bench.run(2);
            assert_eq!(bench.raised(), None);
            let state = &bench.core.state;
            assert_eq!(state.s[8..11], words[..3], "{endian:?}");
            assert_eq!(state.r[0], RAM + 0x200, "{endian:?}");
        }
    }

    /// A8.8.332 and A8.8.413: ARM state takes the PC as the base of VLDM without writeback and of
    /// VSTR, as `Align(PC, 4)`, which Thumb state leaves UNPREDICTABLE.
    #[test]
    fn arm_state_takes_the_pc_as_a_base() {
        // VLDM pc, {s0}, which reads the word at 8.
        let mut bench = enabled(Endian::Little, &[0xEC9F_0A01, 0, 0x3FC0_0000]);
        bench.run(1);
        assert_eq!(bench.raised(), None);
        assert_eq!(bench.core.state.s[0], 0x3FC0_0000);
        // VSTR s0, [pc] and VSTM pc, {s0}, run from RAM, which write the words 8 and 12 past
        // the first.
        let mut bench = enabled(Endian::Little, &[]);
        bench.place_arm(RAM, &[0xED8F_0A00, 0xEC8F_0A01, 0, 0]);
        bench.core.state.r[15] = RAM;
        bench.core.state.s[0] = 0x1234_5678;
        // Each writes the block's own page, so each returns to the run loop.
        bench.run(1);
        bench.run(1);
        assert_eq!(bench.core.state.r[15], RAM + 8);
        assert_eq!(bench.raised(), None);
        let written: Vec<u8> = (8..16).map(|offset| bench.byte(RAM + offset)).collect();
        assert_eq!(written, [0x78, 0x56, 0x34, 0x12, 0x78, 0x56, 0x34, 0x12]);
        // VLDM pc!, {s0} is UNPREDICTABLE in either state.
        assert!(refused(0xECBF_0A01));
        for word in [0xEC9F_0A01, 0xED8F_0A00] {
            let mut bench = Bench::thumb(Endian::Little, &thumb(word));
            grant(&mut bench, FULL, mask(fpexc::EN));
            bench.run(1);
            assert_eq!(bench.raised(), UNDEFINED, "{word:#010x}");
        }
    }

    /// A7.8 and A7.9: every VMOV between core registers and extension registers.
    #[test]
    fn every_core_register_vmov_moves_its_words() {
        let state = ran(
            &[
                0xEE00_1A10, // VMOV s0, r1
                0xEE10_2A10, // VMOV r2, s0
                0xEC42_1A30, // VMOV s1, s2, r1, r2
                0xEC54_3A30, // VMOV r3, r4, s1, s2
                0xEC42_1B12, // VMOV d2, r1, r2
                0xEC56_5B12, // VMOV r5, r6, d2
                0xEE23_7B10, // VMOV d3[1], r7
                0xEE33_8B10, // VMOV r8, d3[1]
                0xEE03_7B10, // VMOV d3[0], r7
            ],
            |state| {
                state.r[1] = 0x1111_1111;
                state.r[2] = 0x2222_2222;
                state.r[7] = 0x7777_7777;
            },
        );
        assert_eq!(state.s[0], 0x1111_1111);
        assert_eq!(state.r[2], 0x1111_1111);
        assert_eq!(state.s[1..3], [0x1111_1111, 0x1111_1111]);
        assert_eq!(state.r[3..5], [0x1111_1111, 0x1111_1111]);
        assert_eq!(state.s[4..6], [0x1111_1111, 0x1111_1111]);
        assert_eq!(state.r[5..7], [0x1111_1111, 0x1111_1111]);
        assert_eq!(state.s[6..8], [0x7777_7777, 0x7777_7777]);
        assert_eq!(state.r[8], 0x7777_7777);
    }

    /// A8.8.343 to A8.8.345: the SP is a core register ARM state may name, and Thumb state's
    /// UNPREDICTABLE. The PC is neither's.
    #[test]
    fn arm_state_moves_the_sp() {
        let state = ran(&[0xEE00_DA10, 0xEC4D_DB10], |state| state.r[13] = 0x1234);
        assert_eq!(state.s[0..2], [0x1234, 0x1234]);
        // VMSR FPSCR, r13, then VMRS r13, FPSID and VMRS r12, FPSCR.
        let state = ran(&[0xEEE1_DA10, 0xEEF0_DA10, 0xEEF1_CA10], |state| {
            state.r[13] = 0x0040_0000;
        });
        assert_eq!([state.r[13], state.r[12]], [0x4102_3153, 0x0040_0000]);
        for word in [0xEE00_DA10, 0xEC4D_DB10, 0xEEF1_DA10, 0xEEF0_DA10] {
            let mut bench = Bench::thumb(Endian::Little, &thumb(word));
            grant(&mut bench, FULL, mask(fpexc::EN));
            bench.run(1);
            assert_eq!(bench.raised(), UNDEFINED, "{word:#010x}");
        }
        for word in [0xEE00_FA10, 0xEC4F_1B10, 0xEEE1_FA10, 0xEEE8_FA10] {
            assert!(refused(word), "{word:#010x}");
        }
    }

    /// The system registers, Table B1-24 and DDI 0460D 11.3.
    #[test]
    fn system_registers_read_and_write() {
        let state = ran(
            &[
                0xEEF0_0A10, // VMRS r0, FPSID
                0xEEF7_1A10, // VMRS r1, MVFR0
                0xEEF6_2A10, // VMRS r2, MVFR1
                0xEEE1_3A10, // VMSR FPSCR, r3
                0xEEF1_4A10, // VMRS r4, FPSCR
                0xEEF1_FA10, // VMRS APSR_nzcv, FPSCR
                0xEEE0_3A10, // VMSR FPSID, r3
                0xEEE8_3A10, // VMSR FPEXC, r3
            ],
            |state| state.r[3] = u32::MAX,
        );
        assert_eq!(state.r[0..3], [0x4102_3153, 0x1011_0221, 0x0000_0011]);
        // The trap enables, AHP and QC read as zero, DDI 0460D Table 11-5.
        assert_eq!(state.r[4], 0xF3F7_009F);
        assert_eq!([state.n, state.z, state.c, state.v], [1, 1, 1, 1]);
        assert_eq!(state.fpexc, 0x6000_0000);
        let state = ran(&[0xEEF8_5A10], |state| state.fpexc = 0x6000_0000);
        assert_eq!(state.r[5], 0x6000_0000);
        // MVFR0 and MVFR1 can't be written, nor the registers Table B1-24 leaves out.
        for word in [
            0xEEE7_0A10,
            0xEEE6_0A10,
            0xEEF2_0A10,
            0xEEF9_0A10,
            0xEEE5_0A10,
        ] {
            assert!(refused(word), "{word:#010x}");
        }
    }

    /// B1.11.1 and DDI 0460D Table 11-3: User mode reaches `FPSCR` only, and `FPEXC.EN` clear
    /// leaves the privileged registers alone reachable.
    #[test]
    fn system_registers_follow_privilege_and_the_enable() {
        let fpsid = 0xEEF0_0A10;
        let fpscr = 0xEEF1_0A10;
        let fpexc_read = 0xEEF8_0A10;
        let mvfr0_read = 0xEEF7_0A10;
        for (mode, enable, word, allowed) in [
            (Mode::User, mask(fpexc::EN), fpscr, true),
            (Mode::User, mask(fpexc::EN), fpsid, false),
            (Mode::User, mask(fpexc::EN), fpexc_read, false),
            (Mode::User, mask(fpexc::EN), mvfr0_read, false),
            (Mode::Supervisor, 0, fpscr, false),
            (Mode::Supervisor, 0, fpsid, true),
            (Mode::Supervisor, 0, fpexc_read, true),
            (Mode::Supervisor, 0, mvfr0_read, true),
        ] {
            let mut bench = Bench::arm(Endian::Little, &[word]);
            grant(&mut bench, FULL, enable);
            bench.core.state.set_mode(mode);
            bench.run(1);
            let expected = if allowed { None } else { UNDEFINED };
            assert_eq!(
                bench.raised(),
                expected,
                "{mode:?} {enable:#x} {word:#010x}"
            );
        }
    }

    /// B1.11.1: `CPACR` grants CP10 and CP11 at the privilege it names, and `FPEXC.EN` turns the
    /// unit on. Without both, every instruction is UNDEFINED, `VMRS` from `FPEXC` too when
    /// `CPACR` refuses.
    #[test]
    fn the_check_follows_cpacr_per_privilege_and_fpexc() {
        let vadd = data(0b0011, 0, false, OPERANDS);
        let fpexc_read = 0xEEF8_0A10;
        for (cpacr, enable, mode, word, allowed) in [
            (FULL, mask(fpexc::EN), Mode::User, vadd, true),
            (FULL, mask(fpexc::EN), Mode::Supervisor, vadd, true),
            (PRIVILEGED, mask(fpexc::EN), Mode::Supervisor, vadd, true),
            (PRIVILEGED, mask(fpexc::EN), Mode::System, vadd, true),
            (PRIVILEGED, mask(fpexc::EN), Mode::User, vadd, false),
            (0, mask(fpexc::EN), Mode::Supervisor, vadd, false),
            (FULL, 0, Mode::Supervisor, vadd, false),
            (FULL, 0, Mode::User, vadd, false),
            // The reserved grant, and CP10 and CP11 apart, UNPREDICTABLE.
            (0b1010 << 20, mask(fpexc::EN), Mode::Supervisor, vadd, false),
            (
                mask(cpacr::CP10),
                mask(fpexc::EN),
                Mode::Supervisor,
                vadd,
                false,
            ),
            (0, 0, Mode::Supervisor, fpexc_read, false),
            (PRIVILEGED, 0, Mode::Supervisor, fpexc_read, true),
        ] {
            let mut bench = Bench::arm(Endian::Little, &[word]);
            grant(&mut bench, cpacr, enable);
            bench.core.state.set_mode(mode);
            bench.run(1);
            let expected = if allowed { None } else { UNDEFINED };
            assert_eq!(
                bench.raised(),
                expected,
                "{cpacr:#x} {enable:#x} {mode:?} {word:#010x}"
            );
        }
    }

    /// Writing `FPEXC.EN` ends the block, so the next instruction's check sees it.
    #[test]
    fn clearing_the_enable_refuses_the_next_instruction() {
        let vadd = data(0b0011, 0, false, OPERANDS);
        let mut bench = enabled(Endian::Little, &[vadd, 0xEEE8_0A10, vadd]);
        bench.core.state.r[0] = 0;
        bench.run(3);
        assert_eq!(bench.raised(), Some((Exception::Undefined, 8)));
    }

    /// DDI 0460D 11.1.1: the R5F has neither the half-precision conversions nor the fused
    /// multiply-adds, and `FPv5`'s instructions aren't `VFPv3`'s. In ARM state `FPv5`'s are under
    /// condition `1111`, which A5.7 leaves UNDEFINED for the coprocessors.
    #[test]
    fn the_r5f_leaves_out_half_precision_fused_and_fpv5() {
        let conditional = [
            other(0b0010, 0, false, 1, 3),    // VCVTB.F32.F16
            other(0b0011, 1, false, 1, 3),    // VCVTT.F16.F32
            data(0b1010, 0, false, OPERANDS), // VFMA
            data(0b1010, 1, true, OPERANDS),  // VFMS
            data(0b1001, 0, false, OPERANDS), // VFNMS
            data(0b1001, 1, true, OPERANDS),  // VFNMA
            other(0b0110, 0, false, 1, 3),    // VRINTR
            other(0b0110, 1, true, 1, 3),     // VRINTZ
            other(0b0111, 0, false, 1, 3),    // VRINTX
        ];
        let unconditional = [
            0xFE00_0A00, // VSELEQ.F32 s0, s0, s0
            0xFE80_0A00, // VMAXNM.F32 s0, s0, s0
            0xFE80_0A40, // VMINNM.F32 s0, s0, s0
            0xFEB8_0A40, // VRINTA.F32 s0, s0
            0xFEBC_0AC0, // VCVTA.S32.F32 s0, s0
        ];
        for word in conditional.into_iter().chain(unconditional) {
            assert!(refused(word), "{word:#010x}");
            let mut bench = Bench::thumb(
                Endian::Little,
                &[
                    u16::try_from(word >> 16).unwrap(),
                    u16::try_from(word & 0xFFFF).unwrap(),
                ],
            );
            grant(&mut bench, FULL, mask(fpexc::EN));
            bench.run(1);
            assert_eq!(bench.raised(), UNDEFINED, "Thumb {word:#010x}");
        }
        // D16 to D31 aren't there, DDI 0460D 11.1.2.
        assert!(refused(data(0b0011, 0, true, OPERANDS) | 1 << 22));
    }

    /// DDI 0460D 11.1.1: with `LEN` or `STRIDE` nonzero, an instruction Appendix K makes a vector
    /// is UNDEFINED. One writing the first bank stays scalar, K.4, and a compare is never a
    /// vector, K.1.1.
    #[test]
    fn a_vector_is_undefined() {
        for (word, vector) in [
            (data(0b0011, 0, false, (4, 2, 3)), true), // VADD.F32 s8, s4, s6
            (data(0b0011, 0, true, (4, 2, 3)), true),  // VADD.F64 d4, d2, d3
            (data(0b1011, 0, false, (4, 7, 8)), true), // VMOV.F32 s8, #1.5
            (other(0b0001, 0, false, 4, 3), true),     // VNEG.F32 s8, s6
            (other(0b0001, 1, true, 4, 3), true),      // VSQRT.F64 d4, d3
            (data(0b0011, 0, false, OPERANDS), false), // VADD.F32 s2, s4, s6
            (data(0b0011, 0, true, (3, 4, 5)), false), // VADD.F64 d3, d4, d5
            (other(0b0100, 0, false, 4, 3), false),    // VCMP.F32 s8, s6
            (other(0b1101, 1, false, 4, 3), false),    // VCVT.S32.F32 s8, s6
        ] {
            for control in [0b001 << 16, 0b11 << 20] {
                let mut bench = enabled(Endian::Little, &[word]);
                bench.core.state.fpscr = control;
                bench.run(1);
                let expected = if vector { UNDEFINED } else { None };
                assert_eq!(bench.raised(), expected, "{word:#010x} {control:#x}");
            }
        }
    }

    /// DDI 0460D Table 11-6: the Undefined Instruction exception a vector raises sets
    /// `FPEXC.DEX`, and one taken for any other reason clears it.
    #[test]
    fn fpexc_dex_says_a_vector_was_refused() {
        let vector = data(0b0011, 0, false, (4, 2, 3));
        let mut bench = enabled(Endian::Little, &[vector]);
        bench.core.state.fpscr = 0b001 << 16;
        bench.run(1);
        assert_eq!(bench.raised(), UNDEFINED);
        assert_eq!(bench.core.state.fpexc, 0x6000_0000);
        // UDF, A8.8.247, with DEX set.
        let mut bench = enabled(Endian::Little, &[0xE7F0_00F0]);
        bench.core.state.fpexc = 0x6000_0000;
        bench.run(1);
        assert_eq!(bench.raised(), UNDEFINED);
        assert_eq!(bench.core.state.fpexc, 0x4000_0000);
    }

    /// An R5 without the unit has no CP10 or CP11, B1.10.2.
    #[test]
    fn a_core_without_the_unit_refuses_every_one() {
        for word in [data(0b0011, 0, false, OPERANDS), 0xEEF1_0A10, 0xEEF0_0A10] {
            let little = ties(Endian::Little);
            let mut bench = Bench::of(Ties {
                high_vectors: true,
                options: Options {
                    fpu: Fpu::None,
                    ..little.options
                },
                ..little
            });
            bench.place_arm(CODE, &[word]);
            grant(&mut bench, FULL, mask(fpexc::EN));
            bench.run(1);
            assert_eq!(bench.raised(), UNDEFINED, "{word:#010x}");
        }
    }

    /// A7.5 to A7.9 in ARM state run under the instruction's condition.
    #[test]
    fn arm_state_runs_under_the_condition() {
        let vadd = data(0b0011, 0, false, OPERANDS) & 0x0FFF_FFFF;
        for (cond, z, runs) in [(0b0000, 1, true), (0b0000, 0, false), (0b0001, 1, false)] {
            let state = ran(&[vadd | cond << 28], |state| {
                place(state, false, [0.0, 1.0, 2.0]);
                state.z = z;
            });
            let expected = if runs { 3.0 } else { 0.0 };
            assert_eq!(
                result(&state, false).to_bits(),
                f64::to_bits(expected),
                "{cond:#06b} {z}"
            );
        }
        assert!(refused(vadd | 0b1111 << 28));
    }

    /// Thumb state runs the same encodings in an IT block under its condition.
    #[test]
    fn thumb_state_runs_them_in_an_it_block() {
        let [hw1, hw2] = thumb(data(0b0011, 0, false, OPERANDS));
        // IT EQ, then VADDEQ.F32 s2, s4, s6.
        for (z, expected) in [(1, 3.0), (0, 0.0)] {
            let mut bench = Bench::thumb(Endian::Little, &[0xBF08, hw1, hw2]);
            grant(&mut bench, FULL, mask(fpexc::EN));
            place(&mut bench.core.state, false, [0.0, 1.0, 2.0]);
            bench.core.state.z = z;
            bench.run(2);
            assert_eq!(bench.raised(), None);
            assert_eq!(
                result(&bench.core.state, false).to_bits(),
                f64::to_bits(expected),
                "{z}"
            );
        }
    }
}
