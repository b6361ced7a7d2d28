// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! ARM state's data processing, DDI 0406C A5.2.1 to A5.2.3, with `MOVW` and `MOVT`.
//!
//! Every operation lowers through the shared [`data32::operate`], which Thumb's run through too.
//! ARM state differs in what writes the PC. An `Rd` of 1111 without `S` is `ALUWritePC()`, A2.3.1,
//! and with `S` it's an exception return, B9.3.20. The register-shifted register forms can't write
//! the PC at all, A2.3.1, so there an `Rd` of 1111 is UNDEFINED, which the glossary lets an
//! UNPREDICTABLE encoding be. Every other register choice the manual calls UNPREDICTABLE runs the
//! pseudocode: the PC reads as the instruction's address plus 8, A2.3. A `(0)` bit that's 1 is
//! ignored, since no pseudocode reads it.

use cranelift_codegen::ir::{InstBuilder, Value};

use super::super::family::{Family, helpers};
use super::arm_alu::{arm_expand_imm, arm_expand_imm_c, decode_reg_shift};
use crate::cpu::armv7::translate::alu::{decode_imm_shift, shift_c, shift_c_register};
use crate::cpu::armv7::translate::data32::{self, Destination, Operation};
use crate::cpu::armv7::translate::{Emitter, Flag, Translated, Undefined, bits};

/// A5.2.1, data processing with a register, shifted by a constant.
pub(super) fn register(e: &mut Emitter<'_, '_, Family>, word: u32) {
    let (operation, tests) = operation(word);
    let (shift_type, amount) = decode_imm_shift(bits(word, 6, 5), bits(word, 11, 7));
    let value = e.reg(bits(word, 3, 0));
    let carry_in = e.flag(Flag::C);
    let (operand, carry) = shift_c(e, value, shift_type, amount, carry_in);
    let n = bits(word, 19, 16);
    if returns_from_exception(word, tests) {
        exception_return(e, operation, n, operand);
    } else {
        let destination = destination(word, tests);
        data32::operate(e, operation, n, destination, (operand, Some(carry)));
    }
}

/// A5.2.2, data processing with a register shifted by the bottom byte of another, A8.4.2. None of
/// these can write the PC, A2.3.1.
pub(super) fn register_shifted_register(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (operation, tests) = operation(word);
    if bits(word, 15, 12) == 15 && !tests {
        return Err(Undefined);
    }
    let amount = e.reg(bits(word, 11, 8));
    let amount = e.b.ins().band_imm_u(amount, 0xFF);
    let value = e.reg(bits(word, 3, 0));
    let carry_in = e.flag(Flag::C);
    let shift_type = decode_reg_shift(bits(word, 6, 5));
    let (operand, carry) = shift_c_register(e, value, shift_type, amount, carry_in);
    let (n, destination) = (bits(word, 19, 16), destination(word, tests));
    data32::operate(e, operation, n, destination, (operand, Some(carry)));
    Ok(())
}

/// A5.2.3, data processing with a modified immediate constant, A5.2.4. `ADR`, A8.8.12, is `ADD`
/// or `SUB` from the PC, whose `Align(PC, 4)` is the PC itself in ARM state.
pub(super) fn immediate(e: &mut Emitter<'_, '_, Family>, word: u32) {
    let (operation, tests) = operation(word);
    let (n, imm12) = (bits(word, 19, 16), bits(word, 11, 0));
    if returns_from_exception(word, tests) {
        let operand = e.constant(arm_expand_imm(imm12));
        exception_return(e, operation, n, operand);
        return;
    }
    let (imm32, carry) = arm_expand_imm_c(imm12);
    let operand = e.constant(imm32);
    let carry = carry.map(|carry| e.constant(carry));
    data32::operate(e, operation, n, destination(word, tests), (operand, carry));
}

/// `MOVW` and `MOVT`, A8.8.102 encoding A2 and A8.8.106, by bit 22. An `Rd` of 1111 is
/// UNPREDICTABLE, and since `R[]` can't write the PC, it's UNDEFINED.
pub(super) fn move_wide(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let d = bits(word, 15, 12);
    if d == 15 {
        return Err(Undefined);
    }
    let imm16 = bits(word, 19, 16) << 12 | bits(word, 11, 0);
    data32::move_halfword(e, d, imm16, bits(word, 22, 22) == 1);
    Ok(())
}

/// Tables A5-3, A5-4 and A5-5's operation, by `op`, bits 24 to 21, and whether it's a test,
/// `TST`, `TEQ`, `CMP` or `CMN`, which sets the flags of an `AND`, `EOR`, `SUB` or `ADD` and
/// writes nothing.
fn operation(word: u32) -> (Operation, bool) {
    use Operation::{Adc, Add, And, Bic, Eor, Mov, Mvn, Orr, Rsb, Rsc, Sbc, Sub};
    const BY_OP: [Operation; 16] = [
        And, Eor, Sub, Rsb, Add, Adc, Sbc, Rsc, And, Eor, Sub, Add, Orr, Mov, Bic, Mvn,
    ];
    let op = bits(word, 24, 21);
    (BY_OP[op as usize], op >> 2 == 0b10)
}

/// Where the result goes: the flags alone for a test, whose `Rd` is `(0)` bits, the PC through
/// `ALUWritePC()` for an `Rd` of 1111, A2.3.1, and `Rd` otherwise.
fn destination(word: u32, tests: bool) -> Destination {
    match bits(word, 15, 12) {
        _ if tests => Destination::Flags,
        15 => Destination::Pc,
        d => Destination::Register {
            d,
            setflags: bits(word, 20, 20) == 1,
        },
    }
}

/// Whether the instruction writes the PC with `S` set, which B9.3.20 makes an exception return.
fn returns_from_exception(word: u32, tests: bool) -> bool {
    !tests && bits(word, 15, 12) == 15 && bits(word, 20, 20) == 1
}

/// `SUBS PC, LR` and the rest of B9.3.20: the operation's result is where the exception returns
/// to, the flags are left alone, and the SPSR becomes the CPSR, which picks the instruction set the
/// result is aligned for. In User mode and System mode, which have no SPSR, it's UNPREDICTABLE,
/// B9.1.1, and [`helpers::spsr`] hands back the CPSR, so the return restores nothing and only
/// branches.
pub(super) fn exception_return(
    e: &mut Emitter<'_, '_, Family>,
    operation: Operation,
    n: u32,
    operand: Value,
) {
    let (result, _, _) = data32::compute(e, operation, n, (operand, None));
    let spsr = e.call(helpers::spsr as *const () as usize, &[]);
    Family::exception_return(e, result, spsr);
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::registers::cpsr;
    use super::super::super::state::{Mode, State};
    use super::super::testing::{Bench, SPUN};
    use crate::cpu::armv7::registers::mask;
    use crate::cpu::armv7::translate::ALWAYS;
    use crate::soc::Endian;

    const AND: u32 = 0b0000;
    const EOR: u32 = 0b0001;
    const SUB: u32 = 0b0010;
    const RSB: u32 = 0b0011;
    const ADD: u32 = 0b0100;
    const ADC: u32 = 0b0101;
    const SBC: u32 = 0b0110;
    const RSC: u32 = 0b0111;
    const TST: u32 = 0b1000;
    const TEQ: u32 = 0b1001;
    const CMP: u32 = 0b1010;
    const CMN: u32 = 0b1011;
    const ORR: u32 = 0b1100;
    const MOV: u32 = 0b1101;
    const BIC: u32 = 0b1110;
    const MVN: u32 = 0b1111;

    const LSL: u32 = 0b00;
    const LSR: u32 = 0b01;
    const ASR: u32 = 0b10;
    const ROR: u32 = 0b11;

    /// Table A5-3's layout, `op{S} Rd, Rn, Rm, <shift> #imm5`.
    fn register(op: u32, s: u32, [rd, rn, rm]: [u32; 3], (shift_type, imm5): (u32, u32)) -> u32 {
        ALWAYS << 28 | op << 21 | s << 20 | rn << 16 | rd << 12 | imm5 << 7 | shift_type << 5 | rm
    }

    /// Table A5-4's layout, `op{S} Rd, Rn, Rm, <shift> Rs`.
    fn shifted_by(op: u32, s: u32, [rd, rn, rm, rs]: [u32; 4], shift_type: u32) -> u32 {
        ALWAYS << 28
            | op << 21
            | s << 20
            | rn << 16
            | rd << 12
            | rs << 8
            | shift_type << 5
            | 1 << 4
            | rm
    }

    /// Table A5-5's layout, `op{S} Rd, Rn, #<const>`, with the constant's `imm12`.
    fn immediate(op: u32, s: u32, [rd, rn]: [u32; 2], imm12: u32) -> u32 {
        ALWAYS << 28 | 1 << 25 | op << 21 | s << 20 | rn << 16 | rd << 12 | imm12
    }

    /// The state after one instruction at 0, set up by `set`, which retires.
    fn run(word: u32, set: impl FnOnce(&mut State)) -> State {
        let mut bench = Bench::arm(Endian::Little, &[word]);
        set(&mut bench.core.state);
        let (_, ran) = bench.run(1);
        assert_eq!((ran, bench.taken()), (1, None), "{word:#010x}");
        bench.core.state.clone()
    }

    fn nzcv(state: &State) -> [u32; 4] {
        [state.n, state.z, state.c, state.v]
    }

    /// Whether `word` is refused as UNDEFINED without running.
    fn undefined(word: u32) {
        let mut bench = Bench::arm(Endian::Little, &[word]);
        assert_eq!(bench.run(1).1, SPUN, "{word:#010x}");
        assert_eq!(
            bench.raised(),
            Some((Exception::Undefined, 0)),
            "{word:#010x}"
        );
    }

    /// Each operation of Tables A5-3, A5-4 and A5-5 on `R[n]` and an operand that's a constant
    /// with no rotation, a register with no shift or one shifted by a zero `Rs`, so the shifter
    /// leaves C alone: the result, and the flags `S` sets from the carry in and the V out each
    /// A8.8 page gives. Without `S` the flags stay as they were.
    #[test]
    fn every_operation_gives_the_result_and_flags_its_page_does() {
        // (x, the operand and its imm12, the carry in, and per operation the result and NZCV
        // from N, Z and V clear.) The operand 0x80000000 is rotated, and sets C to its bit 31,
        // which the carry in already is.
        type Rows = [(u32, u32, [u32; 4]); 16];
        let cases: [(u32, (u32, u32), u32, Rows); 3] = [
            (
                0x7FFF_FFFF,
                (1, 0x001),
                1,
                [
                    (AND, 1, [0, 0, 1, 0]),
                    (EOR, 0x7FFF_FFFE, [0, 0, 1, 0]),
                    (SUB, 0x7FFF_FFFE, [0, 0, 1, 0]),
                    (RSB, 0x8000_0002, [1, 0, 0, 0]),
                    (ADD, 0x8000_0000, [1, 0, 0, 1]),
                    (ADC, 0x8000_0001, [1, 0, 0, 1]),
                    (SBC, 0x7FFF_FFFE, [0, 0, 1, 0]),
                    (RSC, 0x8000_0002, [1, 0, 0, 0]),
                    (TST, 0, [0, 0, 1, 0]),
                    (TEQ, 0, [0, 0, 1, 0]),
                    (CMP, 0, [0, 0, 1, 0]),
                    (CMN, 0, [1, 0, 0, 1]),
                    (ORR, 0x7FFF_FFFF, [0, 0, 1, 0]),
                    (MOV, 1, [0, 0, 1, 0]),
                    (BIC, 0x7FFF_FFFE, [0, 0, 1, 0]),
                    (MVN, 0xFFFF_FFFE, [1, 0, 1, 0]),
                ],
            ),
            (
                0xFFFF_FFFF,
                (0xFF, 0x0FF),
                0,
                [
                    (AND, 0xFF, [0, 0, 0, 0]),
                    (EOR, 0xFFFF_FF00, [1, 0, 0, 0]),
                    (SUB, 0xFFFF_FF00, [1, 0, 1, 0]),
                    (RSB, 0x100, [0, 0, 0, 0]),
                    (ADD, 0xFE, [0, 0, 1, 0]),
                    (ADC, 0xFE, [0, 0, 1, 0]),
                    (SBC, 0xFFFF_FEFF, [1, 0, 1, 0]),
                    (RSC, 0xFF, [0, 0, 0, 0]),
                    (TST, 0, [0, 0, 0, 0]),
                    (TEQ, 0, [1, 0, 0, 0]),
                    (CMP, 0, [1, 0, 1, 0]),
                    (CMN, 0, [0, 0, 1, 0]),
                    (ORR, 0xFFFF_FFFF, [1, 0, 0, 0]),
                    (MOV, 0xFF, [0, 0, 0, 0]),
                    (BIC, 0xFFFF_FF00, [1, 0, 0, 0]),
                    (MVN, 0xFFFF_FF00, [1, 0, 0, 0]),
                ],
            ),
            (
                0x8000_0000,
                (0x8000_0000, 0x102),
                1,
                [
                    (AND, 0x8000_0000, [1, 0, 1, 0]),
                    (EOR, 0, [0, 1, 1, 0]),
                    (SUB, 0, [0, 1, 1, 0]),
                    (RSB, 0, [0, 1, 1, 0]),
                    (ADD, 0, [0, 1, 1, 1]),
                    (ADC, 1, [0, 0, 1, 1]),
                    (SBC, 0, [0, 1, 1, 0]),
                    (RSC, 0, [0, 1, 1, 0]),
                    (TST, 0, [1, 0, 1, 0]),
                    (TEQ, 0, [0, 1, 1, 0]),
                    (CMP, 0, [0, 1, 1, 0]),
                    (CMN, 0, [0, 1, 1, 1]),
                    (ORR, 0x8000_0000, [1, 0, 1, 0]),
                    (MOV, 0x8000_0000, [1, 0, 1, 0]),
                    (BIC, 0, [0, 1, 1, 0]),
                    (MVN, 0x7FFF_FFFF, [0, 0, 1, 0]),
                ],
            ),
        ];
        for (x, (y, imm12), carry, rows) in cases {
            for (op, result, flags) in rows {
                let tests = op >> 2 == 0b10;
                let forms = [
                    register(op, 1, [0, 1, 2], (LSL, 0)),
                    shifted_by(op, 1, [0, 1, 2, 3], ROR),
                    immediate(op, 1, [0, 1], imm12),
                ];
                for word in forms {
                    let state = run(word, |s| {
                        (s.r[0], s.r[1], s.r[2], s.r[3]) = (0xDEAD, x, y, 0x100);
                        s.c = carry;
                    });
                    let written = if tests { 0xDEAD } else { result };
                    assert_eq!(state.r[0], written, "{word:#010x}");
                    assert_eq!(nzcv(&state), flags, "{word:#010x}");
                    assert_eq!(state.r[15], 4, "{word:#010x}");
                }
                if tests {
                    continue;
                }
                for word in [
                    register(op, 0, [0, 1, 2], (LSL, 0)),
                    shifted_by(op, 0, [0, 1, 2, 3], LSL),
                    immediate(op, 0, [0, 1], imm12),
                ] {
                    let state = run(word, |s| {
                        (s.r[1], s.r[2], s.r[3]) = (x, y, 0);
                        (s.n, s.z, s.c, s.v) = (1, 1, carry, 1);
                    });
                    assert_eq!(state.r[0], result, "{word:#010x}");
                    assert_eq!(nzcv(&state), [1, 1, carry, 1], "{word:#010x}");
                }
            }
        }
    }

    /// A8.4.1 and A8.4.3: a constant shift of 0 is LSL #0 or RRX, and of 32 for LSR and ASR, and
    /// the shift's carry goes to C for a logical operation.
    #[test]
    fn a_constant_shift_sets_the_carry_of_a_logical_operation() {
        let movs = |shift| register(MOV, 1, [0, 0, 1], shift);
        for (shift, value, carry_in, result, flags) in [
            ((LSL, 0), 0x8000_0001, 1, 0x8000_0001, [1, 0, 1, 0]),
            ((LSL, 1), 0x8000_0001, 0, 2, [0, 0, 1, 0]),
            ((LSL, 31), 3, 0, 0x8000_0000, [1, 0, 1, 0]),
            ((LSR, 0), 0x8000_0000, 0, 0, [0, 1, 1, 0]),
            ((LSR, 4), 0x0000_00F8, 0, 0xF, [0, 0, 1, 0]),
            ((ASR, 0), 0x8000_0000, 0, 0xFFFF_FFFF, [1, 0, 1, 0]),
            ((ASR, 4), 0x8000_0007, 1, 0xF800_0000, [1, 0, 0, 0]),
            ((ROR, 0), 3, 1, 0x8000_0001, [1, 0, 1, 0]),
            ((ROR, 0), 2, 0, 1, [0, 0, 0, 0]),
            ((ROR, 4), 0x12, 0, 0x2000_0001, [0, 0, 0, 0]),
            ((ROR, 1), 1, 0, 0x8000_0000, [1, 0, 1, 0]),
        ] {
            let state = run(movs(shift), |s| {
                s.r[1] = value;
                s.c = carry_in;
            });
            assert_eq!((state.r[0], nzcv(&state)), (result, flags), "{shift:?}");
        }
        let state = run(register(ORR, 1, [0, 1, 2], (LSR, 1)), |s| {
            (s.r[1], s.r[2]) = (0x10, 3);
        });
        assert_eq!((state.r[0], nzcv(&state)), (0x11, [0, 0, 1, 0]));
        let state = run(register(ADD, 1, [0, 1, 2], (LSL, 31)), |s| {
            (s.r[1], s.r[2]) = (0x8000_0000, 1);
        });
        assert_eq!(
            (state.r[0], nzcv(&state)),
            (0, [0, 1, 1, 1]),
            "an add's own C"
        );
    }

    /// A8.4.2: a register-controlled shift takes the bottom byte of `Rs`, so amounts up to 255
    /// reach `Shift_C`, and a zero amount leaves C.
    #[test]
    fn a_register_shift_takes_the_bottom_byte_of_rs() {
        let movs = |shift_type| shifted_by(MOV, 1, [0, 0, 1, 2], shift_type);
        for (shift_type, value, amount, carry_in, result, carry) in [
            (LSL, 0x8000_0001, 0x100, 1, 0x8000_0001, 1),
            (LSL, 0x8000_0001, 0x101, 0, 2, 1),
            (LSL, 1, 32, 0, 0, 1),
            (LSL, 1, 33, 1, 0, 0),
            (LSR, 0x8000_0000, 32, 0, 0, 1),
            (LSR, 0x8000_0000, 0xFF, 1, 0, 0),
            (ASR, 0x8000_0000, 200, 0, 0xFFFF_FFFF, 1),
            (ROR, 0x12, 0x24, 1, 0x2000_0001, 0),
            (ROR, 0x8000_0000, 32, 0, 0x8000_0000, 1),
        ] {
            let state = run(movs(shift_type), |s| {
                (s.r[1], s.r[2]) = (value, amount);
                s.c = carry_in;
            });
            assert_eq!(
                (state.r[0], state.c),
                (result, carry),
                "{shift_type:02b} by {amount:#x}"
            );
        }
    }

    /// A5.2.4's carry out: a logical operation with a rotated constant sets C to the constant's
    /// bit 31, and one with an unrotated constant leaves it.
    #[test]
    fn a_rotated_constant_sets_the_carry_of_a_logical_operation() {
        for (imm12, carry_in, result, carry) in [
            (0x4FF, 0, 0xFF00_0000, 1),
            (0x42B, 1, 0x2B00_0000, 0),
            (0x0FF, 1, 0xFF, 1),
            (0x0FF, 0, 0xFF, 0),
        ] {
            let state = run(immediate(AND, 1, [0, 1], imm12), |s| {
                s.r[1] = 0xFFFF_FFFF;
                s.c = carry_in;
            });
            assert_eq!((state.r[0], state.c), (result, carry), "{imm12:#05x}");
        }
        let state = run(immediate(TST, 1, [0, 1], 0x4FF), |s| s.r[1] = 0x00FF_FFFF);
        assert_eq!(nzcv(&state), [0, 1, 1, 0]);
    }

    /// A2.3: the PC reads as the instruction's address plus 8, which `ADR` adds to and
    /// subtracts from, A8.8.12, and as an operand of the register-shifted forms too, where it's
    /// UNPREDICTABLE.
    #[test]
    fn the_pc_reads_as_the_address_plus_8() {
        let at = |word| {
            let mut bench = Bench::arm(Endian::Little, &[0xE1A0_0000, word]); // MOV r0, r0
            bench.core.state.r[3] = 0;
            assert_eq!(bench.run(2).1, 2);
            bench.core.state.clone()
        };
        assert_eq!(at(0xE28F_0010).r[0], 0x1C, "ADR r0, . + 0x18");
        assert_eq!(at(0xE24F_0004).r[0], 0x8, "ADR r0, . + 4");
        assert_eq!(at(0xE1A0_000F).r[0], 0xC, "MOV r0, pc");
        assert_eq!(at(shifted_by(ADD, 0, [0, 15, 15, 3], LSL)).r[0], 0x18);
        assert_eq!(at(0xE08F_0000).r[0], 0xC, "ADD r0, pc, r0, with r0 0");
        let orr = immediate(ORR, 0, [0, 15], 0x001);
        assert_eq!(at(orr).r[0], 0xD, "ORR r0, pc, #1, which isn't Thumb's MOV");
    }

    /// A2.3.1: without `S`, an `Rd` of 1111 is `ALUWritePC()`, which in ARM state is
    /// `BXWritePC()`, picking Thumb state from bit 0. A target with bits 1 and 0 of `10` is
    /// UNPREDICTABLE, and branches as `BranchWritePC()` would.
    #[test]
    fn an_alu_write_to_the_pc_is_an_interworking_branch() {
        for (word, r1, pc, thumb) in [
            (register(MOV, 0, [15, 0, 1], (LSL, 0)), 0x201, 0x200, 1),
            (register(MOV, 0, [15, 0, 1], (LSL, 0)), 0x206, 0x204, 0),
            (immediate(ADD, 0, [15, 1], 0x004), 0x200, 0x204, 0),
            (immediate(SUB, 0, [15, 1], 0x001), 0x200, 0x1FF & !1, 1),
            (register(EOR, 0, [15, 1, 1], (LSL, 0)), 0x300, 0, 0),
            (immediate(MVN, 0, [15, 0], 0x0FF), 0, 0xFFFF_FF00, 0),
        ] {
            let state = run(word, |s| {
                s.r[1] = r1;
                (s.n, s.z, s.c, s.v) = (1, 0, 1, 0);
            });
            assert_eq!((state.r[15], state.t), (pc, thumb), "{word:#010x}");
            assert_eq!(nzcv(&state), [1, 0, 1, 0], "{word:#010x}: no flags");
        }
    }

    /// A2.3.1's note: the register-shifted register forms can't write the PC, so an `Rd` of 1111
    /// is UNDEFINED, unless it's a test, whose `Rd` is only `(0)` bits.
    #[test]
    fn a_register_shifted_register_form_never_writes_the_pc() {
        for op in [AND, EOR, SUB, ADD, ORR, MOV, MVN] {
            undefined(shifted_by(op, 0, [15, 1, 2, 3], LSL));
            undefined(shifted_by(op, 1, [15, 1, 2, 3], LSL));
        }
        let state = run(shifted_by(CMP, 1, [15, 1, 2, 3], LSL), |s| {
            (s.r[1], s.r[2], s.r[3]) = (1, 1, 0);
        });
        assert_eq!((state.r[15], nzcv(&state)), (4, [0, 1, 1, 0]));
    }

    /// The `(0)` bits of a test's `Rd`, A8.8.240, and of `MOV`'s and `MVN`'s `Rn`, A8.8.102 and
    /// A8.8.116, are UNPREDICTABLE when they aren't zero, and are ignored.
    #[test]
    fn should_be_zero_fields_are_ignored() {
        let state = run(immediate(TST, 1, [7, 1], 0x001), |s| {
            (s.r[1], s.r[7]) = (2, 9);
        });
        assert_eq!((state.r[7], nzcv(&state)), (9, [0, 1, 0, 0]));
        let state = run(immediate(MOV, 0, [0, 7], 0x0AB), |s| s.r[7] = 0x100);
        assert_eq!(state.r[0], 0xAB);
        let state = run(register(MVN, 0, [0, 7, 1], (LSL, 0)), |s| s.r[1] = 0);
        assert_eq!(state.r[0], 0xFFFF_FFFF);
    }

    /// A8.8.102 encoding A2 and A8.8.106: `MOVW` writes the bottom half and zeroes the top, and
    /// `MOVT` writes the top and keeps the bottom. An `Rd` of 1111 is UNDEFINED.
    #[test]
    fn movw_and_movt_write_each_half() {
        let state = run(0xE30A_0BCD, |s| s.r[0] = 0xFFFF_FFFF); // MOVW r0, #0xABCD
        assert_eq!(state.r[0], 0xABCD);
        let state = run(0xE341_0234, |s| s.r[0] = 0x5678_9ABC); // MOVT r0, #0x1234
        assert_eq!(state.r[0], 0x1234_9ABC);
        let state = run(0xE34F_DFFF, |s| s.r[13] = 0x2000_0013); // MOVT sp, #0xFFFF
        assert_eq!(state.r[13], 0xFFFF_0013);
        undefined(0xE300_F001); // MOVW pc, #1
        undefined(0xE340_F001); // MOVT pc, #1
    }

    /// B9.3.20: `SUBS PC, LR` and its kind return from an exception, restoring the SPSR as the
    /// CPSR, its mode, its banked registers and its instruction set among it, and branching to the
    /// result aligned for that instruction set. The flags come from the SPSR, not the result.
    #[test]
    fn subs_pc_lr_returns_from_an_exception() {
        let thumb_user = mask(cpsr::T) | mask(cpsr::Z) | Mode::User as u32;
        let arm_irq = mask(cpsr::N) | mask(cpsr::C) | mask(cpsr::I) | Mode::Irq as u32;
        for (word, lr, spsr, pc) in [
            (0xE25E_F004, 0x1004, Mode::User as u32, 0x1000), // SUBS pc, lr, #4
            (0xE1B0_F00E, 0x2005, thumb_user, 0x2004),        // MOVS pc, lr
            (0xE1B0_F00E, 0x2007, arm_irq, 0x2004),
            (
                register(ADD, 1, [15, 14, 1], (LSL, 2)),
                0x3000,
                Mode::User as u32,
                0x3008,
            ),
            (
                immediate(MVN, 1, [15, 0], 0x0FF),
                0,
                Mode::User as u32,
                0xFFFF_FF00,
            ),
        ] {
            let mut bench = Bench::arm(Endian::Big, &[word]);
            let state = &mut bench.core.state;
            state.r[1] = 2;
            state.r[13] = 0x5000;
            state.r[14] = lr;
            assert!(state.set_spsr(spsr));
            (state.n, state.z, state.c, state.v) = (0, 0, 0, 1);
            assert_eq!(bench.run(1).1, 1, "{word:#010x}");
            let state = &bench.core.state;
            assert_eq!((state.r[15], state.cpsr()), (pc, spsr), "{word:#010x}");
            assert_ne!(state.r[13], 0x5000, "{word:#010x}: the mode's own SP");
        }
    }

    /// B9.1.1: an exception return in User mode or System mode, which have no SPSR, is
    /// UNPREDICTABLE. It keeps the CPSR and only branches.
    #[test]
    fn an_exception_return_without_an_spsr_only_branches() {
        for mode in [Mode::User, Mode::System] {
            let mut bench = Bench::arm(Endian::Little, &[0xE25E_F004]); // SUBS pc, lr, #4
            bench.core.cpsr_write_by_instr(mode as u32, 0b0001, false);
            bench.core.state.r[14] = 0x1004;
            bench.core.state.c = 1;
            let cpsr = bench.core.state.cpsr();
            assert_eq!(bench.run(1).1, 1, "{mode:?}");
            let state = &bench.core.state;
            assert_eq!((state.r[15], state.cpsr()), (0x1000, cpsr), "{mode:?}");
        }
    }
}
