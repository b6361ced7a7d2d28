// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! ARM state's media instructions and multiplies, DDI 0406C A5.4 and A5.2.5 to A5.2.7.
//!
//! Each lowers through the shared [`multiplies`] and [`data32`] operations Thumb's run through.
//! ARM state differs in its encodings, in the `S` forms of its multiplies, and in what a register
//! may be. Where the manual says UNPREDICTABLE, you get what the pseudocode does when it can run:
//! the PC reads as the instruction's address plus 8, A2.3, the SP is any other register, a long
//! multiply whose `RdHi` is its `RdLo` keeps the low word, written last, and the `(0)` and `(1)`
//! bits are ignored. A destination of the PC is UNDEFINED, since `R[]` can't write it, A2.3.2, and
//! so is a bit field with no bits.

use cranelift_codegen::ir::{InstBuilder, condcodes::IntCC, types};

use super::super::family::Family;
use crate::cpu::armv7::translate::alu::decode_imm_shift;
use crate::cpu::armv7::translate::data32::{self, Bound, Extension, Field, Widths, writable};
use crate::cpu::armv7::translate::multiply::{
    self as multiplies, Accumulating, Combine, Half, Kept, Lanes, Long, Parallel, Rearrange,
};
use crate::cpu::armv7::translate::{Emitter, Flag, Translated, Undefined, bits};

/// A5.4, the media instructions of Table A5-16, by `op1`, bits 24 to 20, and `op2`, bits 7 to 5.
/// `UDF`, A8.8.247, is one of the encodings it leaves UNDEFINED.
pub(super) fn media(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (op1, op2) = (bits(word, 24, 20), bits(word, 7, 5));
    let [d, n] = [bits(word, 15, 12), bits(word, 3, 0)];
    let field = |msbit| Field {
        lsbit: bits(word, 11, 7),
        msbit,
    };
    let widthminus1 = bits(word, 20, 16);
    match (op1, op2) {
        (0b0_0000..=0b0_0111, _) => parallel(e, word),
        (0b0_1000..=0b0_1111, _) => packing(e, word),
        (0b1_0000..=0b1_0111, _) => signed_multiply(e, word),
        // USAD8 and USADA8, A8.8.264 and A8.8.265, by whether `Ra` is 1111.
        (0b1_1000, 0b000) => {
            let [d, a, m] = [bits(word, 19, 16), bits(word, 15, 12), bits(word, 11, 8)];
            let accumulator = (a != 15).then_some(a);
            multiply_into(e, d, Accumulating::AbsoluteDifferences, [n, m], accumulator)
        }
        // SBFX and UBFX, A8.8.164 and A8.8.246.
        (0b1_1010 | 0b1_1011 | 0b1_1110 | 0b1_1111, 0b010 | 0b110) => {
            let field = field(bits(word, 11, 7) + widthminus1);
            data32::extract(e, [writable(d)?, n], field, op1 >> 2 != 0b111)
        }
        // BFC and BFI, A8.8.19 and A8.8.20, which is BFC with an `Rn` of 1111.
        (0b1_1100 | 0b1_1101, 0b000 | 0b100) => {
            data32::insert(e, [writable(d)?, n], field(bits(word, 20, 16)))
        }
        _ => Err(Undefined),
    }
}

/// A5.4.1 and A5.4.2, the parallel additions and subtractions, signed and unsigned by bit 22,
/// Tables A5-17 and A5-18, A8.8.135 to A8.8.143, A8.8.158 to A8.8.174, A8.8.195 to A8.8.197,
/// A8.8.243 to A8.8.263 and A8.8.268 to A8.8.270.
fn parallel(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let kept = match bits(word, 21, 20) {
        0b01 => Kept::Ge,
        0b10 => Kept::Saturated,
        0b11 => Kept::Halved,
        _ => return Err(Undefined),
    };
    let lanes = match bits(word, 7, 5) {
        0b000 => Lanes::Add16,
        0b001 => Lanes::AddSubtractExchange,
        0b010 => Lanes::SubtractAddExchange,
        0b011 => Lanes::Subtract16,
        0b100 => Lanes::Add8,
        0b111 => Lanes::Subtract8,
        _ => return Err(Undefined),
    };
    let operation = Parallel {
        lanes,
        kept,
        signed: bits(word, 22, 22) == 0,
    };
    let registers = [
        writable(bits(word, 15, 12))?,
        bits(word, 19, 16),
        bits(word, 3, 0),
    ];
    multiplies::parallel(e, operation, registers);
    Ok(())
}

/// A5.4.3, packing, unpacking, saturation and reversal, Table A5-19, by `op1`, bits 22 to 20, and
/// `op2`, bits 7 to 5. `SSAT` and `USAT` take their bound from bits 20 to 16, and their 16-bit
/// forms from 19 to 16.
fn packing(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (op1, op2) = (bits(word, 22, 20), bits(word, 7, 5));
    let [d, n, m] = [
        writable(bits(word, 15, 12))?,
        bits(word, 19, 16),
        bits(word, 3, 0),
    ];
    let shift = decode_imm_shift(bits(word, 6, 6) << 1, bits(word, 11, 7));
    let how = match (op1, op2) {
        // PKHBT and PKHTB, A8.8.125.
        (0b000, 0b000 | 0b010 | 0b100 | 0b110) => {
            data32::pack_halfword(e, [d, n, m], shift);
            return Ok(());
        }
        // SEL, A8.8.166.
        (0b000, 0b101) => {
            let result = multiplies::select_bytes(e, n, m);
            e.set_reg(d, result);
            return Ok(());
        }
        // SSAT and USAT, A8.8.193 and A8.8.266.
        (0b010 | 0b011 | 0b110 | 0b111, 0b000 | 0b010 | 0b100 | 0b110) => {
            let sat_imm = bits(word, 20, 16);
            data32::saturate(e, [d, m], shift, Bound::of(op1 >> 2 == 1, sat_imm));
            return Ok(());
        }
        // SSAT16 and USAT16, A8.8.194 and A8.8.267.
        (0b010 | 0b110, 0b001) => {
            let sat_imm = bits(word, 19, 16);
            data32::saturate16(e, [d, m], Bound::of(op1 == 0b110, sat_imm));
            return Ok(());
        }
        (_, 0b011) => return extend(e, word, [d, n, m]),
        (0b011, 0b001) => Rearrange::Reverse,
        (0b011, 0b101) => Rearrange::Reverse16,
        (0b111, 0b001) => Rearrange::ReverseBits,
        (0b111, 0b101) => Rearrange::ReverseSignedHalfword,
        _ => return Err(Undefined),
    };
    let result = multiplies::rearrange(e, m, how);
    e.set_reg(d, result);
    Ok(())
}

/// Table A5-19's extends, by `op1`: SXTAB16, SXTAB and SXTAH, A8.8.231, A8.8.230 and A8.8.232,
/// and UXTAB16, UXTAB and UXTAH, A8.8.272, A8.8.271 and A8.8.273, which are SXTB16 to UXTH,
/// A8.8.233 to A8.8.235 and A8.8.274 to A8.8.276, with an `Rn` of 1111. `Rm` is rotated right by
/// eight times bits 11 and 10 first.
fn extend(e: &mut Emitter<'_, '_, Family>, word: u32, registers: [u32; 3]) -> Translated {
    let op1 = bits(word, 22, 20);
    let widths = match op1 & 0b11 {
        0b00 => Widths::BytePair,
        0b10 => Widths::Byte,
        0b11 => Widths::Halfword,
        _ => return Err(Undefined),
    };
    let extension = Extension {
        widths,
        signed: op1 >> 2 == 0,
    };
    data32::extend(e, registers, extension, bits(word, 11, 10) * 8);
    Ok(())
}

/// A5.4.4, the signed multiplies and the divides, Table A5-20, by `op1`, bits 22 to 20, and `op2`,
/// bits 7 to 5. An `Ra` of 1111 means no accumulator for `SMLAD`, `SMLSD` and `SMMLA`, which are
/// `SMUAD`, `SMUSD` and `SMMUL` then, and for `SMMLS` it's UNPREDICTABLE and reads the PC.
fn signed_multiply(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (op1, op2) = (bits(word, 22, 20), bits(word, 7, 5));
    let [d, a, m, n] = [
        bits(word, 19, 16),
        bits(word, 15, 12),
        bits(word, 11, 8),
        bits(word, 3, 0),
    ];
    let swap_or_round = bits(word, 5, 5) == 1;
    let accumulator = (a != 15).then_some(a);
    let (operation, accumulator) = match (op1, op2 >> 1) {
        // SMLAD and SMUAD, A8.8.177 and A8.8.187, and SMLSD and SMUSD, A8.8.182 and A8.8.191.
        (0b000, 0b00) => (Accumulating::Dual(Combine::Add, swap_or_round), accumulator),
        (0b000, 0b01) => (
            Accumulating::Dual(Combine::Subtract, swap_or_round),
            accumulator,
        ),
        // SDIV and UDIV, A8.8.165 and A8.8.248.
        (0b001 | 0b011, 0b00) if op2 == 0 => {
            let d = writable(d)?;
            let result = multiplies::divide(e, [n, m], op1 == 0b001);
            e.set_reg(d, result);
            return Ok(());
        }
        // SMLALD and SMLSLD, A8.8.180 and A8.8.183.
        (0b100, 0b00 | 0b01) => {
            let combine = if op2 >> 1 == 0 {
                Combine::Add
            } else {
                Combine::Subtract
            };
            let operation = Long::Dual(combine, swap_or_round);
            return multiply_long(e, operation, [a, d], [n, m], false);
        }
        // SMMLA and SMMUL, A8.8.184 and A8.8.186, and SMMLS, A8.8.185.
        (0b101, 0b00) => (
            Accumulating::MostSignificant(Combine::Add, swap_or_round),
            accumulator,
        ),
        (0b101, 0b11) => (
            Accumulating::MostSignificant(Combine::Subtract, swap_or_round),
            Some(a),
        ),
        _ => return Err(Undefined),
    };
    multiply_into(e, d, operation, [n, m], accumulator)
}

/// A5.2.5, the multiplies and multiply accumulates of Table A5-7, by `op`, bits 23 to 20, whose
/// bit 20 is `S` where it sets the flags.
pub(super) fn multiply(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let op = bits(word, 23, 20);
    let setflags = op & 1 == 1;
    let [high, low, m, n] = [
        bits(word, 19, 16),
        bits(word, 15, 12),
        bits(word, 11, 8),
        bits(word, 3, 0),
    ];
    let long = match op >> 1 {
        // MUL, A8.8.114, whose `Ra` is `(0)` bits, and MLA, A8.8.100.
        0b000 | 0b001 => {
            let accumulator = (op >> 1 == 1).then_some(low);
            let d = writable(high)?;
            let result = multiplies::multiply_word(e, Accumulating::Multiply, [n, m], accumulator);
            e.set_reg(d, result);
            if setflags {
                e.set_nz(result);
            }
            return Ok(());
        }
        // UMAAL, A8.8.255.
        0b010 if !setflags => Long::AccumulateAccumulate,
        // MLS, A8.8.101.
        0b011 if !setflags => {
            return multiply_into(e, high, Accumulating::MultiplySubtract, [n, m], Some(low));
        }
        // UMULL, UMLAL, SMULL and SMLAL, A8.8.257, A8.8.256, A8.8.189 and A8.8.178.
        0b100 => Long::Multiply(false),
        0b101 => Long::Accumulate(false),
        0b110 => Long::Multiply(true),
        0b111 => Long::Accumulate(true),
        _ => return Err(Undefined),
    };
    multiply_long(e, long, [low, high], [n, m], setflags)
}

/// A5.2.6, the saturating additions and subtractions of Table A5-8, by `op`, bits 22 and 21:
/// QADD, QSUB, QDADD and QDSUB, A8.8.134, A8.8.141, A8.8.138 and A8.8.139, with `Rn` at bits 19 to
/// 16 and `Rm` at 3 to 0.
pub(super) fn saturating(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let op = bits(word, 22, 21);
    let combine = if op & 1 == 0 {
        Combine::Add
    } else {
        Combine::Subtract
    };
    let d = writable(bits(word, 15, 12))?;
    let result = multiplies::saturating(
        e,
        bits(word, 19, 16),
        bits(word, 3, 0),
        combine,
        op >> 1 == 1,
    );
    e.set_reg(d, result);
    Ok(())
}

/// A5.2.7, the halfword multiplies of Table A5-9, by `op1`, bits 22 and 21, and `op`, bit 5, with
/// `N` at bit 5 and `M` at bit 6: SMLABB to SMLATT, A8.8.176, SMLAWB and SMLAWT, A8.8.181, SMULWB
/// and SMULWT, A8.8.190, SMLALBB to SMLALTT, A8.8.179, and SMULBB to SMULTT, A8.8.188.
pub(super) fn halfword_multiply(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let [high, low, m, n] = [
        bits(word, 19, 16),
        bits(word, 15, 12),
        bits(word, 11, 8),
        bits(word, 3, 0),
    ];
    let (of_n, of_m) = (Half::of(bits(word, 5, 5)), Half::of(bits(word, 6, 6)));
    let (operation, accumulator) = match (bits(word, 22, 21), bits(word, 5, 5)) {
        (0b00, _) => (Accumulating::Halfwords(of_n, of_m), Some(low)),
        (0b01, 0) => (Accumulating::WordByHalfword(of_m), Some(low)),
        (0b01, _) => (Accumulating::WordByHalfword(of_m), None),
        (0b10, _) => {
            let operation = Long::Halfwords(of_n, of_m);
            return multiply_long(e, operation, [low, high], [n, m], false);
        }
        _ => (Accumulating::Halfwords(of_n, of_m), None),
    };
    multiply_into(e, high, operation, [n, m], accumulator)
}

/// Writes `R[d]` with `operation` on `R[n]` and `R[m]`. An accumulating one adds `R[a]` too.
fn multiply_into(
    e: &mut Emitter<'_, '_, Family>,
    d: u32,
    operation: Accumulating,
    registers: [u32; 2],
    accumulator: Option<u32>,
) -> Translated {
    let d = writable(d)?;
    let result = multiplies::multiply_word(e, operation, registers, accumulator);
    e.set_reg(d, result);
    Ok(())
}

/// `operation` on `R[n]` and `R[m]` into `R[dHi]:R[dLo]`, which sets N from bit 63 of the result
/// and Z where all 64 bits are zero when `setflags`, A8.8.257.
fn multiply_long(
    e: &mut Emitter<'_, '_, Family>,
    operation: Long,
    [lo, hi]: [u32; 2],
    registers: [u32; 2],
    setflags: bool,
) -> Translated {
    let destination = [writable(lo)?, writable(hi)?];
    let result = multiplies::multiply_long(e, operation, destination, registers);
    if setflags {
        let negative = e.b.ins().ushr_imm_u(result, 63);
        let negative = e.b.ins().ireduce(types::I32, negative);
        let zero = e.b.ins().icmp_imm_s(IntCC::Equal, result, 0);
        let zero = e.b.ins().uextend(types::I32, zero);
        e.set_flag(Flag::N, negative);
        e.set_flag(Flag::Z, zero);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::registers::sctlr;
    use super::super::super::state::State;
    use super::super::testing::{Bench, SPUN};
    use crate::cpu::armv7::registers::mask;
    use crate::cpu::armv7::translate::ALWAYS;
    use crate::soc::Endian;

    /// The Undefined Instruction exception, taken at the instruction at 0.
    const UNDEFINED: Option<(Exception, u32)> = Some((Exception::Undefined, 0));

    /// Table A5-7's layout, A5.2.5: `op`, then `Rd` or `RdHi`, `Ra` or `RdLo`, `Rm` and `Rn`.
    fn multiply(op: u32, [high, low, m, n]: [u32; 4]) -> u32 {
        ALWAYS << 28 | op << 20 | high << 16 | low << 12 | m << 8 | 0b1001 << 4 | n
    }

    /// A5.2.6's and A5.2.7's layout: `op1` at bits 22 and 21, bits 7 to 4, and the four register
    /// fields from the top.
    fn halfword(op1: u32, low: u32, [r19, r15, r11, r3]: [u32; 4]) -> u32 {
        ALWAYS << 28 | 0b10 << 23 | op1 << 21 | r19 << 16 | r15 << 12 | r11 << 8 | low << 4 | r3
    }

    /// Table A5-16's layout, A5.4: `op1` at bits 24 to 20, `op2` at 7 to 5, and the four register
    /// fields from the top.
    fn media(op1: u32, op2: u32, [r19, r15, r11, r3]: [u32; 4]) -> u32 {
        ALWAYS << 28
            | 0b011 << 25
            | op1 << 20
            | r19 << 16
            | r15 << 12
            | r11 << 8
            | op2 << 5
            | 1 << 4
            | r3
    }

    /// Table A5-16's layout with a five-bit field at bits 20 to 16 and another at 11 to 7: `op1`'s
    /// bits 24 to 21 and `op2`'s bits 6 and 5.
    fn fields(op1: u32, op2: u32, [high, d, low, n]: [u32; 4]) -> u32 {
        ALWAYS << 28
            | 0b011 << 25
            | op1 << 21
            | high << 16
            | d << 12
            | low << 7
            | op2 << 5
            | 1 << 4
            | n
    }

    /// The state after `word` ran with R0 to R3 from `r`, Q and GE as given, and N, Z, C and V as
    /// 0, 0, 1 and 1, which only an `S` form changes.
    fn run(word: u32, r: [u32; 4], q: u32, ge: u32) -> State {
        let mut bench = Bench::arm(Endian::Little, &[word]);
        let state = &mut bench.core.state;
        state.r[..4].copy_from_slice(&r);
        (state.q, state.ge) = (q, ge);
        (state.n, state.z, state.c, state.v) = (0, 0, 1, 1);
        let (_, ran) = bench.run(1);
        assert_eq!((ran, bench.taken()), (1, None), "{word:#010x}");
        bench.core.state
    }

    /// R0 after `word` ran from `r`, with Q, GE and the flags checked unchanged.
    fn result(word: u32, r: [u32; 4]) -> u32 {
        let state = run(word, r, 0, 0b1010);
        assert_eq!(
            (state.q, state.ge, state.n, state.z, state.c, state.v),
            (0, 0b1010, 0, 0, 1, 1),
            "{word:#010x}"
        );
        state.r[0]
    }

    /// R0 and Q after `word` ran from `r` with Q clear.
    fn saturated(word: u32, r: [u32; 4]) -> (u32, u32) {
        let state = run(word, r, 0, 0);
        (state.r[0], state.q)
    }

    /// R0, R1, N and Z after `word` ran from `r`.
    fn long(word: u32, r: [u32; 4]) -> [u32; 4] {
        let state = run(word, r, 0, 0);
        assert_eq!((state.c, state.v), (1, 1), "{word:#010x}");
        [state.r[0], state.r[1], state.n, state.z]
    }

    /// Whether `word` is refused as UNDEFINED without retiring.
    fn undefined(word: u32) {
        let mut bench = Bench::arm(Endian::Little, &[word]);
        assert_eq!(bench.run(1).1, SPUN, "{word:#010x}");
        assert_eq!(bench.raised(), UNDEFINED, "{word:#010x}");
    }

    const MUL: u32 = 0b0000;
    const MLA: u32 = 0b0010;
    const UMAAL: u32 = 0b0100;
    const MLS: u32 = 0b0110;
    const UMULL: u32 = 0b1000;
    const UMLAL: u32 = 0b1010;
    const SMULL: u32 = 0b1100;
    const SMLAL: u32 = 0b1110;
    const S: u32 = 1;

    /// A8.8.114, A8.8.100 and A8.8.101: `MUL`, `MLA` and `MLS` keep the low word, and `S` sets N
    /// and Z from it and leaves C and V.
    #[test]
    fn mul_mla_and_mls_keep_the_low_word() {
        let mul = multiply(MUL, [0, 0, 2, 1]); // MUL r0, r1, r2
        let mla = multiply(MLA, [0, 3, 2, 1]); // MLA r0, r1, r2, r3
        let mls = multiply(MLS, [0, 3, 2, 1]); // MLS r0, r1, r2, r3
        assert_eq!(result(mul, [9, 7, 6, 0]), 42);
        assert_eq!(result(mul, [9, 0x1_0000, 0x1_0000, 0]), 0);
        assert_eq!(result(mla, [9, 3, 4, 5]), 17);
        assert_eq!(result(mls, [9, 3, 4, 100]), 88);
        assert_eq!(result(mls, [9, 1, 1, 0]), 0xFFFF_FFFF);
        for (word, r, flags) in [
            (mul | S << 20, [9, 0xFFFF_FFFF, 5, 0], [0xFFFF_FFFB, 1, 0]),
            (mul | S << 20, [9, 0x1_0000, 0x1_0000, 0], [0, 0, 1]),
            (mla | S << 20, [9, 3, 4, 5], [17, 0, 0]),
        ] {
            let state = run(word, r, 0, 0);
            assert_eq!(
                [state.r[0], state.n, state.z, state.c, state.v],
                [flags[0], flags[1], flags[2], 1, 1],
                "{word:#010x}"
            );
        }
    }

    /// A8.8.257, A8.8.256, A8.8.189, A8.8.178 and A8.8.255: the long multiplies write `RdHi` and
    /// `RdLo`, the accumulating ones adding to them, and `S` sets N from bit 63 and Z from all 64
    /// bits.
    #[test]
    fn the_long_multiplies_write_both_halves() {
        let form = |op: u32| multiply(op, [1, 0, 3, 2]); // op r0, r1, r2, r3
        for (op, r, expected) in [
            (UMULL, [9, 9, u32::MAX, u32::MAX], [1, 0xFFFF_FFFE]),
            (SMULL, [9, 9, 0xFFFF_FFFE, 3], [0xFFFF_FFFA, 0xFFFF_FFFF]),
            (SMULL, [9, 9, 0x8000_0000, 0x8000_0000], [0, 0x4000_0000]),
            (UMLAL, [u32::MAX, 0, 1, 1], [0, 1]),
            (SMLAL, [0, 1, u32::MAX, 1], [u32::MAX, 0]),
            (UMAAL, [5, 7, 2, 3], [18, 0]),
            (UMAAL, [u32::MAX; 4], [u32::MAX, u32::MAX]),
        ] {
            assert_eq!(
                long(form(op), r),
                [expected[0], expected[1], 0, 0],
                "{op:04b}"
            );
        }
        for (op, r, expected) in [
            (UMULL, [9, 9, u32::MAX, u32::MAX], [1, 0xFFFF_FFFE, 1, 0]),
            (SMULL, [9, 9, 0, 3], [0, 0, 0, 1]),
            (UMLAL, [u32::MAX, 0, 1, 1], [0, 1, 0, 0]),
            (SMLAL, [1, 0, u32::MAX, 1], [0, 0, 0, 1]),
        ] {
            assert_eq!(long(form(op | S), r), expected, "{op:04b} S");
        }
    }

    /// Table A5-7's UNDEFINED rows, and a destination of the PC. The other register choices
    /// A8.8.114 and its kind make UNPREDICTABLE run the pseudocode: the PC reads as the address
    /// plus 8, and an `RdHi` that's `RdLo` keeps the low word.
    #[test]
    fn the_multiplies_refuse_the_pc_as_a_destination_only() {
        for word in [
            multiply(0b0101, [0, 1, 2, 3]),
            multiply(0b0111, [0, 1, 2, 3]),
            multiply(MUL, [15, 0, 2, 1]),
            multiply(MLS, [15, 3, 2, 1]),
            multiply(UMULL, [15, 0, 3, 2]),
            multiply(SMLAL, [1, 15, 3, 2]),
            multiply(UMAAL, [1, 15, 3, 2]),
        ] {
            undefined(word);
        }
        assert_eq!(result(multiply(MUL, [0, 0, 2, 15]), [9, 0, 3, 0]), 24);
        assert_eq!(result(multiply(MLA, [0, 15, 2, 1]), [9, 2, 3, 0]), 14);
        assert_eq!(
            long(multiply(UMULL, [0, 0, 3, 2]), [9, 9, u32::MAX, 2])[..2],
            [0xFFFF_FFFE, 9]
        );
        let state = run(multiply(MUL, [13, 0, 2, 1]), [0, 3, 5, 0], 0, 0);
        assert_eq!(state.r[13], 15);
    }

    const QADD: u32 = 0b00;
    const QSUB: u32 = 0b01;
    const QDADD: u32 = 0b10;
    const QDSUB: u32 = 0b11;

    /// A8.8.134, A8.8.141, A8.8.138 and A8.8.139: `Rm` plus or minus `Rn`, doubled first by the
    /// `D` forms, and a saturation in either step sets Q, which nothing clears. A destination of
    /// the PC is UNDEFINED.
    #[test]
    fn the_saturating_additions_set_q_when_they_saturate() {
        let form = |op: u32| halfword(op, 0b0101, [1, 0, 0, 2]); // op r0, r2, r1
        assert_eq!(saturated(form(QADD), [9, 6, 5, 0]), (11, 0));
        assert_eq!(
            saturated(form(QADD), [9, 0x20, 0x7FFF_FFF0, 0]),
            (0x7FFF_FFFF, 1)
        );
        assert_eq!(saturated(form(QSUB), [9, 3, 10, 0]), (7, 0));
        assert_eq!(
            saturated(form(QSUB), [9, 1, 0x8000_0000, 0]),
            (0x8000_0000, 1)
        );
        assert_eq!(saturated(form(QDADD), [9, 3, 10, 0]), (16, 0));
        assert_eq!(
            saturated(form(QDADD), [9, 0x4000_0000, u32::MAX, 0]),
            (0x7FFF_FFFE, 1)
        );
        assert_eq!(saturated(form(QDSUB), [9, 3, 10, 0]), (4, 0));
        assert_eq!(
            saturated(form(QDSUB), [9, 0xC000_0000, 0, 0]),
            (0x7FFF_FFFF, 1)
        );
        assert_eq!(run(form(QADD), [9, 1, 2, 0], 1, 0).q, 1);
        undefined(halfword(QADD, 0b0101, [1, 15, 0, 2]));
    }

    /// A8.8.176, A8.8.181, A8.8.190, A8.8.179 and A8.8.188: the halfword multiplies take the
    /// halves `N`, bit 5, and `M`, bit 6, name, and the 32-bit accumulates set Q when the sum
    /// overflows.
    #[test]
    fn the_halfword_multiplies_take_the_halves_they_name() {
        let smla = |n_m: u32| halfword(0b00, 0b1000 | n_m << 1, [0, 3, 2, 1]); // SMLA<x><y> r0, r1, r2, r3
        let smul = |n_m: u32| halfword(0b11, 0b1000 | n_m << 1, [0, 0, 2, 1]); // SMUL<x><y> r0, r1, r2
        let r = [9, 0x0003_FFFE, 0xFFFF_0005, 100];
        // `n_m` is M then N, the bits at 6 and 5.
        assert_eq!(result(smla(0b00), r), 90, "SMLABB");
        assert_eq!(result(smla(0b11), r), 97, "SMLATT");
        assert_eq!(result(smul(0b00), r), 0xFFFF_FFF6, "SMULBB");
        assert_eq!(result(smul(0b10), r), 2, "SMULBT");
        assert_eq!(result(smul(0b01), r), 15, "SMULTB");
        assert_eq!(result(smul(0b11), r), 0xFFFF_FFFD, "SMULTT");
        assert_eq!(
            saturated(smla(0b00), [9, 0x8000, 0x8000, 0x4000_0000]),
            (0x8000_0000, 1)
        );
        let smlaw = |m: u32| halfword(0b01, 0b1000 | m << 2, [0, 3, 2, 1]);
        let smulw = |m: u32| halfword(0b01, 0b1010 | m << 2, [0, 0, 2, 1]);
        assert_eq!(result(smlaw(0), [9, 0x1_0000, 3, 10]), 13, "SMLAWB");
        assert_eq!(result(smlaw(1), [9, 0x1_0000, 0x2_0000, 10]), 12, "SMLAWT");
        assert_eq!(result(smulw(0), [9, 0x1_0000, 3, 0]), 3, "SMULWB");
        assert_eq!(result(smulw(1), [9, 0x1_0000, 0x2_0000, 0]), 2, "SMULWT");
        assert_eq!(
            saturated(smlaw(0), [9, 0x1_0000, 1, 0x7FFF_FFFF]),
            (0x8000_0000, 1)
        );
        let smlal = |n_m: u32| halfword(0b10, 0b1000 | n_m << 1, [1, 0, 3, 2]); // r0, r1, r2, r3
        let (n, m) = (0x0003_FFFE, 0xFFFF_0005);
        assert_eq!(
            long(smlal(0b00), [0, 0, n, m]),
            [0xFFFF_FFF6, 0xFFFF_FFFF, 0, 0],
            "SMLALBB"
        );
        assert_eq!(
            long(smlal(0b01), [u32::MAX, u32::MAX, n, m]),
            [14, 0, 0, 0],
            "SMLALTB"
        );
        undefined(smul(0b00) | 15 << 16);
        undefined(smlal(0b00) | 15 << 16);
    }

    /// A8.8.135 to A8.8.143, A8.8.158 to A8.8.174, A8.8.195 to A8.8.197, A8.8.243 to A8.8.263 and
    /// A8.8.268 to A8.8.270: each of Tables A5-17 and A5-18's lanes, with GE set by the plain
    /// forms only, and Q never. An `Rn` of the PC, which they make UNPREDICTABLE, reads as the
    /// address plus 8.
    #[test]
    fn the_parallel_arithmetic_works_lane_by_lane() {
        // Each row is `op1`, then for `op2` of 000, 001, 010, 011, 100 and 111, Rn, Rm, the result
        // and the GE it leaves from 0b1010.
        type Lanes = [(u32, u32, u32, u32); 6];
        let rows: [(u32, Lanes); 6] = [
            (
                0b0_0001,
                [
                    (0x7FFF_0001, 0x0001_FFFE, 0x8000_FFFF, 0b1100),
                    (0x0005_0003, 0x0004_0002, 0x0007_FFFF, 0b1100),
                    (0x0005_0003, 0x0004_0006, 0xFFFF_0007, 0b0011),
                    (0x0005_0003, 0x0004_0006, 0x0001_FFFD, 0b1100),
                    (0x7F80_01FF, 0x01FF_0101, 0x807F_0200, 0b1011),
                    (0x0580_0010, 0x0601_0101, 0xFF7F_FF0F, 0b0001),
                ],
            ),
            (
                0b0_0010,
                [
                    (0x7FFF_8000, 0x0001_FFFF, 0x7FFF_8000, 0b1010),
                    (0x0010_0020, 0x0005_0003, 0x0013_001B, 0b1010),
                    (0x0010_0020, 0x0005_0003, 0x000D_0025, 0b1010),
                    (0x8000_0005, 0x0001_0007, 0x8000_FFFE, 0b1010),
                    (0x7F80_1001, 0x01FF_1002, 0x7F80_2003, 0b1010),
                    (0x807F_0500, 0x01FF_0700, 0x807F_FE00, 0b1010),
                ],
            ),
            (
                0b0_0011,
                [
                    (0x7FFF_FFFF, 0x7FFF_FFFE, 0x7FFF_FFFE, 0b1010),
                    (0x0010_0000, 0x0005_0003, 0x0009_FFFD, 0b1010),
                    (0x0010_0000, 0x0005_0003, 0x0006_0002, 0b1010),
                    (0x8000_0000, 0x7FFF_0001, 0x8000_FFFF, 0b1010),
                    (0x7F80_FF03, 0x7F80_FE04, 0x7F80_FE03, 0b1010),
                    (0x807F_0005, 0x7F80_0102, 0x807F_FF01, 0b1010),
                ],
            ),
            (
                0b0_0101,
                [
                    (0xFFFF_0001, 0x0001_0002, 0x0000_0003, 0b1100),
                    (0xFFFF_0003, 0x0004_0001, 0x0000_FFFF, 0b1100),
                    (0x0003_FFFF, 0x0001_0004, 0xFFFF_0000, 0b0011),
                    (0x0005_0003, 0x0004_0006, 0x0001_FFFD, 0b1100),
                    (0xFF80_0110, 0x0180_0110, 0x0000_0220, 0b1100),
                    (0x0005_8010, 0x0105_7F20, 0xFF00_01F0, 0b0110),
                ],
            ),
            (
                0b0_0110,
                [
                    (0xFFFF_0001, 0x0001_0002, 0xFFFF_0003, 0b1010),
                    (0xFFFF_0003, 0x0004_0001, 0xFFFF_0000, 0b1010),
                    (0x0003_FFFF, 0x0001_0004, 0x0000_FFFF, 0b1010),
                    (0x0005_0003, 0x0004_0006, 0x0001_0000, 0b1010),
                    (0xFF80_0110, 0x0180_0110, 0xFFFF_0220, 0b1010),
                    (0x0005_8010, 0x0105_7F20, 0x0000_0100, 0b1010),
                ],
            ),
            (
                0b0_0111,
                [
                    (0xFFFF_0001, 0xFFFF_0002, 0xFFFF_0001, 0b1010),
                    (0xFFFF_0003, 0x0004_0001, 0x8000_FFFF, 0b1010),
                    (0x0003_FFFF, 0x0001_0004, 0xFFFF_8000, 0b1010),
                    (0x0000_FFFF, 0xFFFF_0001, 0x8000_7FFF, 0b1010),
                    (0xFF80_0110, 0xFF80_0230, 0xFF80_0120, 0b1010),
                    (0x0005_8010, 0xFF05_7F20, 0x8000_00F8, 0b1010),
                ],
            ),
        ];
        for (op1, lanes) in rows {
            for (op2, (rn, rm, expected, ge)) in [0b000, 0b001, 0b010, 0b011, 0b100, 0b111]
                .into_iter()
                .zip(lanes)
            {
                let word = media(op1, op2, [1, 0, 0xF, 2]); // op r0, r1, r2
                for q in [0, 1] {
                    let state = run(word, [9, rn, rm, 0], q, 0b1010);
                    assert_eq!(
                        (state.r[0], state.ge, state.q),
                        (expected, ge, q),
                        "{word:#010x} from Q {q}"
                    );
                }
            }
        }
        for word in [
            media(0b0_0000, 0b000, [1, 0, 0xF, 2]), // op1 00
            media(0b0_0100, 0b000, [1, 0, 0xF, 2]),
            media(0b0_0001, 0b101, [1, 0, 0xF, 2]), // op2 101 and 110
            media(0b0_0101, 0b110, [1, 0, 0xF, 2]),
            media(0b0_0001, 0b000, [1, 15, 0xF, 2]), // Rd 15
        ] {
            undefined(word);
        }
        assert_eq!(
            result(media(0b0_0110, 0b000, [15, 0, 0xF, 2]), [9, 0, 1, 0]),
            9
        );
    }

    /// A8.8.125 and A8.8.166: `PKHBT` takes the bottom of `Rn` and the top of `Rm` shifted left,
    /// `PKHTB` the top of `Rn` and the bottom of `Rm` shifted right arithmetically, by 32 for an
    /// `imm5` of zero, and `SEL` takes each byte from `Rn` where its GE bit is set.
    #[test]
    fn pkh_and_sel_put_together_two_registers() {
        let pkh = |tb: u32, imm5: u32| fields(0b0100, tb << 1, [1, 0, imm5, 2]); // PKH r0, r1, r2
        let r = [9, 0x1111_2222, 0x3333_4444, 0];
        assert_eq!(result(pkh(0, 8), r), 0x3344_2222, "PKHBT LSL #8");
        assert_eq!(result(pkh(0, 0), r), 0x3333_2222, "PKHBT");
        assert_eq!(result(pkh(1, 8), r), 0x1111_3344, "PKHTB ASR #8");
        assert_eq!(
            result(pkh(1, 0), [9, 0x1111_2222, 0x8000_0000, 0]),
            0x1111_FFFF,
            "PKHTB ASR #32"
        );
        let sel = media(0b0_1000, 0b101, [1, 0, 0xF, 2]); // SEL r0, r1, r2
        let state = run(sel, [9, 0x1122_3344, 0xAABB_CCDD, 0], 0, 0b0101);
        assert_eq!((state.r[0], state.ge), (0xAA22_CC44, 0b0101));
    }

    /// A8.8.193, A8.8.266, A8.8.194 and A8.8.267: `SSAT` and `USAT` saturate `Rn` shifted, and
    /// the 16-bit forms each halfword, setting Q when they saturate.
    #[test]
    fn ssat_and_usat_saturate_and_set_q() {
        let ssat =
            |sat_imm: u32, sh: u32, imm5: u32| fields(0b0101, sh << 1, [sat_imm, 0, imm5, 2]);
        let usat =
            |sat_imm: u32, sh: u32, imm5: u32| fields(0b0111, sh << 1, [sat_imm, 0, imm5, 2]);
        let with = |value: u32| [9, 0, value, 0];
        assert_eq!(saturated(ssat(7, 0, 0), with(200)), (127, 1));
        assert_eq!(
            saturated(ssat(7, 0, 0), with(0xFFFF_FF38)),
            (0xFFFF_FF80, 1)
        );
        assert_eq!(saturated(ssat(7, 0, 0), with(100)), (100, 0));
        assert_eq!(saturated(ssat(7, 0, 4), with(0x10)), (127, 1), "LSL #4");
        assert_eq!(
            saturated(ssat(7, 1, 4), with(0xFFFF_F000)),
            (0xFFFF_FF80, 1),
            "ASR #4"
        );
        assert_eq!(
            saturated(ssat(31, 0, 0), with(0x8000_0000)),
            (0x8000_0000, 0)
        );
        assert_eq!(saturated(usat(8, 0, 0), with(300)), (255, 1));
        assert_eq!(saturated(usat(8, 0, 0), with(0xFFFF_FFFB)), (0, 1));
        assert_eq!(saturated(usat(8, 0, 0), with(77)), (77, 0));
        assert_eq!(saturated(usat(8, 1, 1), with(0x200)), (255, 1), "ASR #1");
        let ssat16 = media(0b0_1010, 0b001, [7, 0, 0xF, 2]); // SSAT16 r0, #8, r2
        let usat16 = media(0b0_1110, 0b001, [4, 0, 0xF, 2]); // USAT16 r0, #4, r2
        assert_eq!(saturated(ssat16, with(0x7FFF_FF00)), (0x007F_FF80, 1));
        assert_eq!(saturated(ssat16, with(0x0005_FFFB)), (0x0005_FFFB, 0));
        assert_eq!(saturated(usat16, with(0xFFFF_0020)), (0x0000_000F, 1));
        assert_eq!(run(ssat(7, 0, 0), with(1), 1, 0).q, 1, "Q stays set");
    }

    /// A8.8.230 to A8.8.235 and A8.8.271 to A8.8.276: the extends take a byte, a halfword or a
    /// byte of each halfword from `Rm` rotated right by a multiple of 8, and add `Rn` unless it's
    /// 1111.
    #[test]
    fn the_extends_take_a_rotated_part_of_rm() {
        let extend = |op1: u32, n: u32, rotate: u32| media(op1, 0b011, [n, 0, rotate << 2, 2]); // r0, rN, r2
        for (op1, n, rotate, r1, r2, expected) in [
            (0b0_1010, 15, 1, 0, 0x1234_8056, 0xFFFF_FF80), // SXTB r0, r2, ROR #8
            (0b0_1010, 1, 0, 10, 0xFF, 9),                  // SXTAB
            (0b0_1011, 15, 0, 0, 0x0001_8000, 0xFFFF_8000), // SXTH
            (0b0_1011, 1, 2, 0x1_0000, 0x8000_0001, 0x8000), // SXTAH, ROR #16
            (0b0_1000, 15, 0, 0, 0x0080_007F, 0xFF80_007F), // SXTB16
            (0b0_1000, 1, 0, 0x0001_0001, 0x0080_007F, 0xFF81_0080), // SXTAB16
            (0b0_1110, 15, 3, 0, 0x1234_5678, 0x12),        // UXTB r0, r2, ROR #24
            (0b0_1110, 1, 0, 0x100, 0x1FF, 0x1FF),          // UXTAB
            (0b0_1111, 15, 0, 0, 0x1234_ABCD, 0xABCD),      // UXTH
            (0b0_1111, 1, 0, 1, 0xFFFF, 0x1_0000),          // UXTAH
            (0b0_1100, 15, 0, 0, 0x1234_5678, 0x0034_0078), // UXTB16
            (0b0_1100, 1, 0, 0x00FF_0001, 0x1234_5678, 0x0133_0079), // UXTAB16
        ] {
            assert_eq!(
                result(extend(op1, n, rotate), [9, r1, r2, 0]),
                expected,
                "{op1:05b} Rn {n} ROR {rotate}"
            );
        }
    }

    /// A8.8.145 to A8.8.147 and A8.8.144: `REV`, `REV16`, `REVSH` and `RBIT` rearrange `Rm`.
    #[test]
    fn the_reverses_rearrange_rm() {
        let reverse = |op1: u32, op2: u32| media(op1, op2, [0xF, 0, 0xF, 2]); // op r0, r2
        let r = [9, 0, 0x1234_5678, 0];
        assert_eq!(result(reverse(0b0_1011, 0b001), r), 0x7856_3412, "REV");
        assert_eq!(result(reverse(0b0_1011, 0b101), r), 0x3412_7856, "REV16");
        assert_eq!(result(reverse(0b0_1111, 0b001), r), 0x1E6A_2C48, "RBIT");
        assert_eq!(
            result(reverse(0b0_1111, 0b101), [9, 0, 0x1234_5680, 0]),
            0xFFFF_8056,
            "REVSH"
        );
    }

    /// Table A5-19's rows it leaves UNDEFINED, and a destination of the PC.
    #[test]
    fn table_a5_19_refuses_what_it_leaves_out() {
        for word in [
            media(0b0_1001, 0b011, [1, 0, 0, 2]), // op1 001, op2 011
            media(0b0_1101, 0b011, [1, 0, 0, 2]), // op1 101, op2 011
            media(0b0_1000, 0b001, [1, 0, 0xF, 2]),
            media(0b0_1000, 0b111, [1, 0, 0xF, 2]),
            media(0b0_1001, 0b001, [1, 0, 0xF, 2]),
            media(0b0_1011, 0b111, [1, 0, 0xF, 2]),
            media(0b0_1100, 0b001, [1, 0, 0xF, 2]),
            media(0b0_1011, 0b001, [0xF, 15, 0xF, 2]), // REV pc, r2
            fields(0b0101, 0, [7, 15, 0, 2]),          // SSAT pc, #8, r2
            media(0b0_1010, 0b011, [15, 15, 0, 2]),    // SXTB pc, r2
        ] {
            undefined(word);
        }
    }

    /// A8.8.177, A8.8.187, A8.8.182 and A8.8.191: the dual multiplies add or subtract the products
    /// of the halves, `X` exchanging `Rm`'s, and accumulate `Ra` unless it's 1111, setting Q when
    /// the sum overflows.
    #[test]
    fn the_dual_multiplies_combine_both_products() {
        let dual = |op2: u32, a: u32| media(0b1_0000, op2, [0, a, 2, 1]); // op r0, r1, r2, rA
        let r = [9, 0x0002_0003, 0x0004_0005, 100];
        for (op2, a, expected) in [
            (0b000, 15, 23), // SMUAD
            (0b001, 15, 22), // SMUADX
            (0b000, 3, 123), // SMLAD
            (0b001, 3, 122), // SMLADX
            (0b010, 15, 7),  // SMUSD
            (0b011, 15, 2),  // SMUSDX
            (0b010, 3, 107), // SMLSD
            (0b011, 3, 102), // SMLSDX
        ] {
            assert_eq!(result(dual(op2, a), r), expected, "{op2:03b} Ra {a}");
        }
        assert_eq!(
            saturated(dual(0b000, 15), [9, 0x8000_8000, 0x8000_8000, 0]),
            (0x8000_0000, 1)
        );
        assert_eq!(
            saturated(dual(0b000, 3), [9, 0x0001_0001, 0x0001_0001, 0x7FFF_FFFF]),
            (0x8000_0001, 1)
        );
        let dual_long = |op2: u32| media(0b1_0100, op2, [1, 0, 3, 2]); // op r0, r1, r2, r3
        let r = [0, 1, 0x0002_0003, 0x0004_0005];
        assert_eq!(long(dual_long(0b000), r), [23, 1, 0, 0], "SMLALD");
        assert_eq!(long(dual_long(0b001), r), [22, 1, 0, 0], "SMLALDX");
        assert_eq!(long(dual_long(0b010), r), [7, 1, 0, 0], "SMLSLD");
        assert_eq!(long(dual_long(0b011), r), [2, 1, 0, 0], "SMLSLDX");
    }

    /// A8.8.184 to A8.8.186: the top word of the product, added to or subtracted from `Ra`, with
    /// 0x80000000 added first when `R` rounds. `SMMLS` always accumulates, and an `Ra` of 1111,
    /// which A8.8.185 makes UNPREDICTABLE, reads the PC.
    #[test]
    fn the_most_significant_multiplies_keep_the_top_word() {
        let form = |op2: u32, a: u32| media(0b1_0101, op2, [0, a, 2, 1]); // op r0, r1, r2, rA
        for (op2, a, r, expected) in [
            (0b000, 15, [9, 0x4000_0000, 4, 0], 1),           // SMMUL
            (0b000, 15, [9, 0x8000_0000, 1, 0], 0xFFFF_FFFF), // SMMUL
            (0b001, 15, [9, 0x8000_0000, 1, 0], 0),           // SMMULR
            (0b000, 3, [9, 0x4000_0000, 4, 5], 6),            // SMMLA
            (0b001, 3, [9, 0x8000_0000, 1, 5], 5),            // SMMLAR
            (0b110, 3, [9, 0x4000_0000, 4, 5], 4),            // SMMLS
            (0b111, 3, [9, 1, 1, 0], 0),                      // SMMLSR
            (0b110, 15, [9, 0x4000_0000, 4, 0], 8 - 1),       // SMMLS from the PC
        ] {
            assert_eq!(result(form(op2, a), r), expected, "{op2:03b} Ra {a}");
        }
    }

    /// A8.8.165 and A8.8.248: `SDIV` and `UDIV` round toward zero and give zero for a zero
    /// divisor while `SCTLR.DZ` is clear. With it set, a zero divisor is the Undefined Instruction
    /// exception, DDI 0460D 4.3.16, raised before the divide retires.
    #[test]
    fn sdiv_and_udiv_divide_and_trap_a_zero_divisor_by_sctlr_dz() {
        let sdiv = media(0b1_0001, 0b000, [0, 0xF, 2, 1]); // SDIV r0, r1, r2
        let udiv = media(0b1_0011, 0b000, [0, 0xF, 2, 1]); // UDIV r0, r1, r2
        assert_eq!(result(sdiv, [9, 7, 0xFFFF_FFFE, 0]), 0xFFFF_FFFD);
        assert_eq!(result(sdiv, [9, 0x8000_0000, u32::MAX, 0]), 0x8000_0000);
        assert_eq!(result(sdiv, [9, 5, 0, 0]), 0);
        assert_eq!(result(udiv, [9, u32::MAX, 2, 0]), 0x7FFF_FFFF);
        assert_eq!(result(udiv, [9, 7, 0, 0]), 0);
        for word in [sdiv, udiv] {
            let mut bench = Bench::arm(Endian::Little, &[word]);
            bench.core.sctlr |= mask(sctlr::DZ);
            bench.core.state.r[..3].copy_from_slice(&[9, 7, 0]);
            assert_eq!(bench.run(1).1, SPUN, "{word:#010x}");
            assert_eq!(
                (bench.raised(), bench.core.state.r[0]),
                (UNDEFINED, 9),
                "{word:#010x}"
            );
            // The handler returns to the divide, which runs again with a divisor.
            bench.core.state.r[15] = 0;
            bench.core.state.sleeping = 0;
            bench.core.state.r[2] = 2;
            assert_eq!(bench.run(1).1, 1, "{word:#010x}");
            assert_eq!(bench.core.state.r[0], 3, "{word:#010x}");
        }
    }

    /// Table A5-20's rows it leaves UNDEFINED, and a destination of the PC.
    #[test]
    fn table_a5_20_refuses_what_it_leaves_out() {
        for word in [
            media(0b1_0000, 0b100, [0, 3, 2, 1]),    // op1 000, op2 1xx
            media(0b1_0001, 0b001, [0, 0xF, 2, 1]),  // op1 001, op2 001
            media(0b1_0010, 0b000, [0, 3, 2, 1]),    // op1 010
            media(0b1_0100, 0b100, [1, 0, 3, 2]),    // op1 100, op2 1xx
            media(0b1_0101, 0b010, [0, 3, 2, 1]),    // op1 101, op2 01x
            media(0b1_0101, 0b100, [0, 3, 2, 1]),    // op1 101, op2 10x
            media(0b1_0110, 0b000, [0, 3, 2, 1]),    // op1 110
            media(0b1_0111, 0b000, [0, 3, 2, 1]),    // op1 111
            media(0b1_0000, 0b000, [15, 3, 2, 1]),   // SMLAD pc
            media(0b1_0001, 0b000, [15, 0xF, 2, 1]), // SDIV pc
            media(0b1_0100, 0b000, [15, 0, 3, 2]),   // SMLALD with RdHi 15
        ] {
            undefined(word);
        }
    }

    /// A8.8.264 and A8.8.265: `USAD8` sums the bytes' absolute differences, and `USADA8` adds
    /// `Ra` to them.
    #[test]
    fn usad8_and_usada8_sum_absolute_differences() {
        let r = [9, 0x01FF_1005, 0x0300_2001, 1000];
        assert_eq!(result(media(0b1_1000, 0b000, [0, 15, 2, 1]), r), 277);
        assert_eq!(result(media(0b1_1000, 0b000, [0, 3, 2, 1]), r), 1277);
        undefined(media(0b1_1000, 0b000, [15, 3, 2, 1]));
    }

    /// A8.8.164, A8.8.246, A8.8.20 and A8.8.19: `SBFX` and `UBFX` extract a field, and `BFI` and
    /// `BFC` write one and keep the rest. A field past bit 31 and an `msb` below `lsb` name no
    /// bits and are UNDEFINED, as is a destination of the PC.
    #[test]
    fn the_bit_field_instructions_work_on_a_field() {
        let sbfx = |lsb: u32, widthm1: u32| fields(0b1101, 0b10, [widthm1, 0, lsb, 1]); // SBFX r0, r1
        let ubfx = |lsb: u32, widthm1: u32| fields(0b1111, 0b10, [widthm1, 0, lsb, 1]); // UBFX r0, r1
        let bfi = |lsb: u32, msb: u32, n: u32| fields(0b1110, 0b00, [msb, 0, lsb, n]); // BFI r0, rN
        let with = |r0: u32, r1: u32| [r0, r1, 0, 0];
        assert_eq!(result(sbfx(4, 7), with(9, 0xF80)), 0xFFFF_FFF8);
        assert_eq!(result(sbfx(4, 7), with(9, 0x770)), 0x77);
        assert_eq!(result(ubfx(4, 7), with(9, 0xF80)), 0xF8);
        assert_eq!(result(ubfx(0, 31), with(9, 0x8765_4321)), 0x8765_4321);
        assert_eq!(result(sbfx(31, 0), with(9, 0x8000_0000)), 0xFFFF_FFFF);
        assert_eq!(result(ubfx(31, 0), with(9, 0x8000_0000)), 1);
        assert_eq!(
            result(bfi(8, 11, 1), with(0xFFFF_FFFF, 0xFFFF_FFF5)),
            0xFFFF_F5FF
        );
        assert_eq!(result(bfi(0, 31, 1), with(0, 0x1234_5678)), 0x1234_5678);
        assert_eq!(
            result(bfi(4, 11, 15), with(0xFFFF_FFFF, 0)),
            0xFFFF_F00F,
            "BFC"
        );
        assert_eq!(
            result(bfi(31, 31, 15), with(0xFFFF_FFFF, 0)),
            0x7FFF_FFFF,
            "BFC"
        );
        for word in [
            sbfx(4, 28),
            ubfx(31, 1),
            bfi(4, 3, 1),
            sbfx(0, 7) | 15 << 12,
            bfi(0, 7, 1) | 15 << 12,
        ] {
            undefined(word);
        }
    }

    /// Table A5-16's last rows: `UDF` and the encodings beside the bit field instructions it
    /// leaves UNDEFINED.
    #[test]
    fn table_a5_16_refuses_what_it_leaves_out() {
        for word in [
            0xE7F0_00F0, // UDF #0
            media(0b1_1001, 0b000, [0, 15, 2, 1]),
            media(0b1_1000, 0b001, [0, 15, 2, 1]),
            fields(0b1101, 0b00, [7, 0, 4, 1]), // SBFX's op1 with op2 000
            fields(0b1110, 0b01, [7, 0, 4, 1]), // BFI's op1 with op2 x01
            fields(0b1111, 0b11, [7, 0, 4, 1]),
        ] {
            undefined(word);
        }
    }
}
