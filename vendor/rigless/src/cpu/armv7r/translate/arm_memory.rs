// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! ARM state's loads and stores, DDI 0406C A5.3 and A5.2.8 to A5.2.10.
//!
//! Each lowers through the shared [`memory`] operations Thumb's run through, with ARM state's
//! register-shifted offsets and its post-indexed unprivileged forms. Every access is made before a
//! register is written, so a Data Abort leaves the instruction as if it never ran, B1.9.8.
//!
//! Where the manual says UNPREDICTABLE, you get what the pseudocode does when it can run: the PC
//! reads as the instruction's address plus 8, A2.3, a store of it stores that, a base in a
//! writeback that's also the register loaded keeps what the pseudocode writes last, and the `(1)`
//! and `(0)` bits are ignored. The pseudocode can't write the PC through `R[]`, A2.3.2, so a
//! writeback to it, or a load to it other than `LDR`'s `LoadWritePC()`, is UNDEFINED, which the
//! glossary lets an UNPREDICTABLE encoding be.

use cranelift_codegen::ir::{InstBuilder, condcodes::IntCC};

use super::super::family::{Family, offsets};
use super::super::registers::sctlr;
use crate::cpu::armv7::registers::mask;
use crate::cpu::armv7::translate::alu::{ShiftType, decode_imm_shift};
use crate::cpu::armv7::translate::memory::{self, Exclusive, Indexing, Offset, Single};
use crate::cpu::armv7::translate::{
    Attributes, Emitter, Fault, Profile, Size, Translated, Undefined, bits,
};

/// A5.3, the word and unsigned byte loads and stores, Table A5-15.
pub(super) fn word_unsigned_byte(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    transfer(e, bits(word, 20, 20) == 1, word_or_byte(word))
}

/// A5.2.8, the halfword, signed and doubleword loads and stores, Table A5-10.
pub(super) fn extra(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    match halfword_or_signed(word) {
        Some((size, signed)) => {
            transfer(e, bits(word, 20, 20) == 1, extra_single(word, size, signed))
        }
        // With `L` clear, an `op2` of 10 is LDRD and 11 is STRD.
        None => dual(e, bits(word, 6, 5) == 0b10, word),
    }
}

/// A5.2.9, the unprivileged halfword and signed loads and stores, Table A5-11, which are always
/// post-indexed, A8.8.83, A8.8.87, A8.8.91 and A8.8.219.
pub(super) fn extra_unprivileged(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    // Table A5-11 makes a doubleword's encodings UNPREDICTABLE with an even `Rt` and UNDEFINED
    // with an odd one.
    let (size, signed) = halfword_or_signed(word).ok_or(Undefined)?;
    transfer(e, bits(word, 20, 20) == 1, extra_single(word, size, signed))
}

/// A5.2.10, the synchronization primitives, Table A5-12. Every other encoding there is UNDEFINED.
pub(super) fn synchronization(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (n, rt) = (bits(word, 19, 16), bits(word, 15, 12));
    let op = bits(word, 23, 20);
    if op & 0b1011 == 0 {
        return swap(e, word);
    }
    if op >> 3 == 0 {
        return Err(Undefined);
    }
    let (size, doubleword) = match bits(op, 2, 1) {
        0b00 => (Size::Word, false),
        0b01 => (Size::Word, true),
        0b10 => (Size::Byte, false),
        _ => (Size::Halfword, false),
    };
    // The doublewords' `Rt` must be even and below LR, A8.8.77 and A8.8.214. An odd one runs with
    // `t2 = t + 1`, and one of 1111, whose `t2` isn't a register, is UNDEFINED.
    let exclusive = |t: u32| {
        if doubleword && t == 15 {
            return Err(Undefined);
        }
        Ok(Exclusive {
            t,
            t2: doubleword.then_some(t + 1),
            n,
            imm32: 0,
            size,
        })
    };
    if op & 1 == 1 {
        memory::load_exclusive(e, exclusive(rt)?)
    } else {
        memory::store_exclusive(e, rt, exclusive(bits(word, 3, 0))?)
    }
}

/// Table A5-15's transfer, decoded: `A`, bit 25, picks a register shifted by a constant, A8.4.1,
/// over a 12-bit constant, and `B`, bit 22, a byte over a word.
fn word_or_byte(word: u32) -> Single {
    let offset = if bits(word, 25, 25) == 1 {
        let (shift_type, shift) = decode_imm_shift(bits(word, 6, 5), bits(word, 11, 7));
        Offset::Register {
            m: bits(word, 3, 0),
            shift_type,
            shift,
        }
    } else {
        Offset::Immediate(bits(word, 11, 0))
    };
    let size = if bits(word, 22, 22) == 1 {
        Size::Byte
    } else {
        Size::Word
    };
    Single {
        offset,
        ..indexed(word, size)
    }
}

/// Table A5-10's and A5-11's size, and whether a load sign-extends, by `op2`, bits 6 and 5, and
/// `L`, bit 20, or `None` for a doubleword.
fn halfword_or_signed(word: u32) -> Option<(Size, bool)> {
    match (bits(word, 6, 5), bits(word, 20, 20)) {
        (0b01, _) => Some((Size::Halfword, false)),
        (0b10, 1) => Some((Size::Byte, true)),
        (0b11, 1) => Some((Size::Halfword, true)),
        _ => None,
    }
}

/// Table A5-10's and A5-11's transfer of `size`, decoded: `imm4H:imm4L` where bit 22 is set, and
/// `Rm` unshifted otherwise, whose bits 11 to 8 are `(0)` bits, and `P` and `W` the indexing. `P`
/// clear with `W` set is an unprivileged form, post-indexed.
fn extra_single(word: u32, size: Size, signed: bool) -> Single {
    let offset = if bits(word, 22, 22) == 1 {
        Offset::Immediate(bits(word, 11, 8) << 4 | bits(word, 3, 0))
    } else {
        Offset::Register {
            m: bits(word, 3, 0),
            shift_type: ShiftType::Lsl,
            shift: 0,
        }
    };
    Single {
        offset,
        signed,
        ..indexed(word, size)
    }
}

/// A transfer of `size` between `Rt`, bits 15 to 12, and memory at `Rn`, bits 19 to 16, indexed as
/// `P`, `U` and `W`, bits 24, 23 and 21, say, with an offset of zero. `P` clear with `W` set is
/// unprivileged and post-indexed, A8.8.92.
fn indexed(word: u32, size: Size) -> Single {
    let (p, w) = (bits(word, 24, 24) == 1, bits(word, 21, 21) == 1);
    Single {
        indexing: Indexing {
            index: p,
            add: bits(word, 23, 23) == 1,
            wback: !p || w,
        },
        unprivileged: !p && w,
        ..Single::immediate(bits(word, 15, 12), bits(word, 19, 16), 0, size)
    }
}

/// Loads or stores `single`. A load with a constant offset from the PC is a literal, A8.8.64,
/// A8.8.69, A8.8.81, A8.8.85 and A8.8.89, whose `P` and `W` are `(1)` and `(0)` bits, unless it's
/// unprivileged. What the pseudocode can't run is refused: a writeback to the PC, and a load to it
/// that isn't `LDR`'s `LoadWritePC()`, A8.8.63 and A8.8.66. `LDRT` can't load the PC, A8.8.92.
fn transfer(e: &mut Emitter<'_, '_, Family>, load: bool, single: Single) -> Translated {
    let branches = single.size == Size::Word && !single.unprivileged;
    if load && single.t == 15 && !branches {
        return Err(Undefined);
    }
    if load
        && single.n == 15
        && !single.unprivileged
        && let Offset::Immediate(imm32) = single.offset
    {
        let address = memory::literal(e, single.indexing.add, imm32);
        memory::load_literal(e, single.t, address, single.size, single.signed);
        return Ok(());
    }
    if single.indexing.wback && single.n == 15 {
        return Err(Undefined);
    }
    if load {
        memory::load_one(e, single);
    } else {
        memory::store_one(e, single);
    }
    Ok(())
}

/// `LDRD` and `STRD`, A8.8.72 to A8.8.74, A8.8.210 and A8.8.211, into or from `Rt` and the
/// register after it. An odd `Rt` is UNPREDICTABLE and runs with that `t2`, but for one of 1111,
/// whose `t2` isn't a register. With `P` clear and `W` set they're Table A5-11's, which refuses
/// them.
fn dual(e: &mut Emitter<'_, '_, Family>, load: bool, word: u32) -> Translated {
    let single = extra_single(word, Size::Word, false);
    if single.t == 15 {
        return Err(Undefined);
    }
    memory::transfer_dual(e, load, single, single.t + 1)
}

/// `SWP` and `SWPB`, A8.8.229, which DDI 0460D 4.3.16's `SCTLR.SW` makes UNDEFINED while it's
/// clear. The word is always aligned or refused, Table A3-1, so `ROR(data, 8*UInt(R[n]<1:0>))`
/// turns it by nothing. An `Rt` of 1111 is UNPREDICTABLE, and UNDEFINED since `R[]` can't write
/// the PC.
fn swap(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (n, t, t2) = (bits(word, 19, 16), bits(word, 15, 12), bits(word, 3, 0));
    if t == 15 {
        return Err(Undefined);
    }
    let size = if bits(word, 22, 22) == 1 {
        Size::Byte
    } else {
        Size::Word
    };
    let control = e.load_core(offsets::SCTLR);
    let enabled = e.b.ins().band_imm_u(control, i64::from(mask(sctlr::SW)));
    let disabled = e.b.ins().icmp_imm_s(IntCC::Equal, enabled, 0);
    e.raise_if(disabled, Fault::Undefined);
    let address = e.reg(n);
    let data = Family::load(e, address, size, Attributes::ALIGNED);
    let value = e.reg(t2);
    Family::store(e, address, value, size, Attributes::ALIGNED);
    e.set_reg(t, data);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::family::{Raised, Refused};
    use super::super::testing::{Bench, DEVICE, RAM, SPUN};
    use super::*;
    use crate::cpu::armv7::translate::ALWAYS;
    use crate::emulator::Exit;
    use crate::soc::Endian;

    const BOTH: [Endian; 2] = [Endian::Little, Endian::Big];
    /// Where the tests' data is. RAM around it holds each word's own address, so a word loaded
    /// says where it was loaded from.
    const BASE: u32 = RAM + 0x100;

    const LDR: u32 = 1;
    const STR: u32 = 0;
    const WORD: u32 = 0;
    const BYTE: u32 = 1;
    const UP: u32 = 1;
    const DOWN: u32 = 0;
    /// `P` and `W` for each indexing, A8.5.
    const OFFSET: [u32; 2] = [1, 0];
    const PRE: [u32; 2] = [1, 1];
    const POST: [u32; 2] = [0, 0];
    const UNPRIVILEGED: [u32; 2] = [0, 1];

    const LSL: u32 = 0b00;
    const LSR: u32 = 0b01;
    const ASR: u32 = 0b10;
    const ROR: u32 = 0b11;

    /// A transfer's `P`, `U`, `W` and `L` bits, 24, 23, 21 and 20, for a load or store with the
    /// indexing `[p, w]`, adding its offset or not.
    fn form(l: u32, [p, w]: [u32; 2], u: u32) -> u32 {
        p << 24 | u << 23 | w << 21 | l << 20
    }

    /// Table A5-15's layout with a 12-bit constant, for the transfer `form` and `B`.
    fn word_imm(form: u32, b: u32, [rt, rn]: [u32; 2], imm12: u32) -> u32 {
        ALWAYS << 28 | 0b010 << 25 | form | b << 22 | rn << 16 | rt << 12 | imm12
    }

    /// Table A5-15's layout with a register shifted by a constant.
    fn word_reg(form: u32, b: u32, [rt, rn, rm]: [u32; 3], (shift_type, imm5): (u32, u32)) -> u32 {
        word_imm(form, b, [rt, rn], imm5 << 7 | shift_type << 5 | rm) | 1 << 25
    }

    /// Table A5-10's layout with an 8-bit constant, by `op2`.
    fn extra_imm(form: u32, op2: u32, [rt, rn]: [u32; 2], imm8: u32) -> u32 {
        let low = (imm8 >> 4) << 8 | 1 << 7 | op2 << 5 | 1 << 4 | (imm8 & 0xF);
        ALWAYS << 28 | form | 1 << 22 | rn << 16 | rt << 12 | low
    }

    /// Table A5-10's layout with a register.
    fn extra_reg(form: u32, op2: u32, [rt, rn, rm]: [u32; 3]) -> u32 {
        extra_imm(form, op2, [rt, rn], rm) & !(1 << 22)
    }

    /// Table A5-12's layout: `Rd` or a load's `Rt`, `Rn`, and a store's `Rt` in bits 3 to 0.
    fn exclusive(op: u32, [rd, rn, rt]: [u32; 3]) -> u32 {
        ALWAYS << 28 | 1 << 24 | op << 20 | rn << 16 | rd << 12 | 0xF9 << 4 | rt
    }

    /// `value` as its four bytes in `endian`.
    fn in_order(endian: Endian, value: u32) -> [u8; 4] {
        match endian {
            Endian::Little => value.to_le_bytes(),
            Endian::Big => value.to_be_bytes(),
        }
    }

    /// The word at `at` as `endian` reads it.
    fn word_at(bench: &Bench, endian: Endian, at: u32) -> u32 {
        let bytes = [0, 1, 2, 3].map(|k| bench.byte(at + k));
        match endian {
            Endian::Little => u32::from_le_bytes(bytes),
            Endian::Big => u32::from_be_bytes(bytes),
        }
    }

    /// A bench on a part in `endian` about to run `code`, with RAM around [`BASE`] holding each
    /// word's address, after `prepare`.
    fn ready(endian: Endian, code: &[u32], prepare: impl FnOnce(&mut Bench)) -> Bench {
        let mut bench = Bench::arm(endian, code);
        let filled: Vec<u8> = (BASE - 0x40..BASE + 0x40)
            .step_by(4)
            .flat_map(|at| in_order(endian, at))
            .collect();
        bench.write(BASE - 0x40, &filled);
        prepare(&mut bench);
        bench
    }

    /// [`ready`], with every instruction of `code` run, each retiring.
    fn after(endian: Endian, code: &[u32], prepare: impl FnOnce(&mut Bench)) -> Bench {
        let mut bench = ready(endian, code, prepare);
        let count = u32::try_from(code.len()).unwrap();
        let (_, ran) = bench.run(count);
        assert_eq!(
            (ran, bench.taken()),
            (u64::from(count), None),
            "{endian:?} {code:08x?}"
        );
        bench
    }

    /// Sets each of `registers`.
    fn with(registers: &[(usize, u32)]) -> impl FnOnce(&mut Bench) + '_ {
        move |bench| {
            for &(n, value) in registers {
                bench.core.state.r[n] = value;
            }
        }
    }

    /// `word` alone is refused as UNDEFINED, retiring nothing.
    fn undefined(word: u32) {
        let mut bench = ready(Endian::Little, &[word], with(&[(1, BASE), (2, 4)]));
        assert_eq!(bench.run(1).1, SPUN, "{word:#010x}");
        assert_eq!(
            bench.raised(),
            Some((Exception::Undefined, 0)),
            "{word:#010x}"
        );
    }

    /// The alignment fault of a load, or of a store with `write`, at `BASE + 2`.
    fn unaligned(write: bool) -> Raised {
        Raised::DataAbort {
            refused: Refused::Unaligned(BASE + 2),
            write,
        }
    }

    /// `word` alone raises `raised` at `BASE + 2` in each byte order, retiring nothing and leaving
    /// the registers as they were.
    fn refused(word: u32, raised: Raised) {
        for endian in BOTH {
            let mut bench = ready(endian, &[word], with(&[(1, BASE + 2)]));
            let before = bench.core.state.r;
            assert_eq!(bench.run(1).1, SPUN, "{word:#010x} {endian:?}");
            assert_eq!(
                (bench.raised(), bench.aborted()),
                (Some((Exception::DataAbort, 0)), Some(raised)),
                "{word:#010x} {endian:?}"
            );
            assert_eq!(bench.before_taken().0, before, "{word:#010x} {endian:?}");
        }
    }

    /// A3.3: a store lays a word's bytes out in the data's byte order, a load reads them back that
    /// way, and with `SCTLR.A` clear an unaligned `LDR` is made, A3.2.1.
    #[test]
    fn words_and_bytes_follow_the_data_byte_order() {
        let code = [
            word_imm(form(STR, OFFSET, UP), WORD, [1, 2], 0),
            word_imm(form(STR, OFFSET, UP), BYTE, [1, 2], 4),
            word_imm(form(LDR, OFFSET, UP), WORD, [3, 2], 0),
            word_imm(form(LDR, OFFSET, UP), BYTE, [4, 2], 1),
            word_imm(form(LDR, OFFSET, UP), WORD, [5, 2], 1),
        ];
        assert_eq!(code[0], 0xE582_1000, "STR r1, [r2]");
        for (endian, stored, loaded) in [
            (
                Endian::Little,
                [0x44, 0x33, 0x22, 0x11, 0x44],
                [0x1122_3344, 0x33, 0x4411_2233],
            ),
            (
                Endian::Big,
                [0x11, 0x22, 0x33, 0x44, 0x44],
                [0x1122_3344, 0x22, 0x2233_4444],
            ),
        ] {
            let bench = after(endian, &code, with(&[(1, 0x1122_3344), (2, BASE)]));
            let bytes = [0, 1, 2, 3, 4].map(|k| bench.byte(BASE + k));
            assert_eq!(bytes, stored, "{endian:?}");
            assert_eq!(bench.core.state.r[3..6], loaded, "{endian:?}");
        }
    }

    /// A8.5: offset addressing leaves the base, pre-indexed writes back the address it used, and
    /// post-indexed uses the base and writes back the offset address. A register offset takes any
    /// constant shift, A8.8.66, with RRX by the carry.
    #[test]
    fn each_addressing_form_reaches_its_address_and_writes_back() {
        for (word, address, base) in [
            (
                word_imm(form(LDR, OFFSET, UP), WORD, [0, 1], 4),
                BASE + 4,
                BASE,
            ),
            (
                word_imm(form(LDR, OFFSET, DOWN), WORD, [0, 1], 4),
                BASE - 4,
                BASE,
            ),
            (
                word_imm(form(LDR, PRE, UP), WORD, [0, 1], 4),
                BASE + 4,
                BASE + 4,
            ),
            (
                word_imm(form(LDR, PRE, DOWN), WORD, [0, 1], 8),
                BASE - 8,
                BASE - 8,
            ),
            (
                word_imm(form(LDR, POST, UP), WORD, [0, 1], 4),
                BASE,
                BASE + 4,
            ),
            (
                word_imm(form(LDR, POST, DOWN), WORD, [0, 1], 12),
                BASE,
                BASE - 12,
            ),
            (
                word_reg(form(LDR, OFFSET, UP), WORD, [0, 1, 2], (LSL, 0)),
                BASE + 8,
                BASE,
            ),
            (
                word_reg(form(LDR, OFFSET, DOWN), WORD, [0, 1, 2], (LSL, 1)),
                BASE - 16,
                BASE,
            ),
            (
                word_reg(form(LDR, PRE, UP), WORD, [0, 1, 2], (LSR, 1)),
                BASE + 4,
                BASE + 4,
            ),
            (
                word_reg(form(LDR, POST, DOWN), WORD, [0, 1, 2], (ASR, 1)),
                BASE,
                BASE - 4,
            ),
            (
                word_reg(form(LDR, OFFSET, UP), WORD, [0, 1, 2], (ROR, 1)),
                BASE + 4,
                BASE,
            ),
            (
                word_reg(form(LDR, OFFSET, UP), WORD, [0, 1, 2], (LSR, 0)),
                BASE,
                BASE,
            ),
        ] {
            for endian in BOTH {
                let bench = after(endian, &[word], with(&[(1, BASE), (2, 8)]));
                let state = &bench.core.state;
                assert_eq!((state.r[0], state.r[1]), (address, base), "{word:#010x}");
            }
        }
        // RRX of 8 with C set is 0x80000004, which reaches BASE + 4 from a base 0x80000000 below
        // it, where LSR #1's 4 would reach nothing mapped.
        let rrx = word_reg(form(LDR, OFFSET, UP), WORD, [0, 1, 2], (ROR, 0));
        for endian in BOTH {
            let bench = after(endian, &[rrx], |bench| {
                with(&[(1, BASE.wrapping_sub(0x8000_0000)), (2, 8)])(bench);
                bench.core.state.c = 1;
            });
            assert_eq!(bench.core.state.r[0], BASE + 4, "{endian:?}");
        }
        let push = 0xE52D_4004; // PUSH {r4}, which is STR r4, [sp, #-4]!
        assert_eq!(push, word_imm(form(STR, PRE, DOWN), WORD, [4, 13], 4));
        for endian in BOTH {
            let bench = after(endian, &[push], with(&[(4, 0xCAFE), (13, BASE)]));
            assert_eq!(bench.core.state.r[13], BASE - 4);
            assert_eq!(word_at(&bench, endian, BASE - 4), 0xCAFE, "{endian:?}");
        }
    }

    /// B1.9.8: a Data Abort leaves the instruction as if it never ran, its writeback too.
    #[test]
    fn an_aborted_access_writes_nothing_back() {
        let ldr = word_imm(form(LDR, POST, UP), WORD, [0, 1], 4);
        let mut bench = ready(Endian::Big, &[ldr], with(&[(0, 7), (1, DEVICE)]));
        bench.bus.fails_from = Some(u64::from(DEVICE));
        assert_eq!(
            bench.run(1),
            (Exit::Returned, 0),
            "the bus asked for the runner"
        );
        assert_eq!(
            bench.aborted(),
            Some(Raised::DataAbort {
                refused: Refused::Bus(DEVICE),
                write: false
            })
        );
        assert_eq!(bench.core.state.r[..2], [7, DEVICE]);
    }

    /// A8.8.80 to A8.8.90 and A8.8.217 and A8.8.218: halfwords in the data's byte order, and the
    /// signed loads sign-extend.
    #[test]
    fn halfwords_and_signed_bytes_follow_the_data_byte_order() {
        let code = [
            extra_imm(form(LDR, OFFSET, UP), 0b01, [2, 1], 0x10),
            extra_imm(form(LDR, OFFSET, UP), 0b11, [3, 1], 0x12),
            extra_imm(form(LDR, OFFSET, UP), 0b10, [4, 1], 0x11),
            extra_reg(form(LDR, OFFSET, DOWN), 0b01, [5, 14, 6]),
            extra_imm(form(STR, PRE, DOWN), 0b01, [7, 8], 2),
            extra_reg(form(LDR, POST, UP), 0b10, [9, 10, 11]),
            extra_reg(form(LDR, PRE, UP), 0b11, [12, 13, 6]),
            extra_reg(form(STR, POST, DOWN), 0b01, [7, 0, 11]),
        ];
        assert_eq!(code[0], 0xE1D1_21B0, "LDRH r2, [r1, #0x10]");
        for (endian, loaded, stored) in [
            (
                Endian::Little,
                [0x8281, 0xFFFF_8483, 0xFFFF_FF82, 0x8281],
                [0x44, 0x33],
            ),
            (
                Endian::Big,
                [0x8182, 0xFFFF_8384, 0xFFFF_FF82, 0x8182],
                [0x33, 0x44],
            ),
        ] {
            let bench = after(endian, &code, |bench| {
                bench.write(BASE + 0x10, &[0x81, 0x82, 0x83, 0x84]);
                let registers = [
                    (1, BASE),
                    (14, BASE + 0x20),
                    (6, 0x10),
                    (7, 0x1122_3344),
                    (8, BASE + 0x22),
                    (10, BASE + 0x13),
                    (11, 3),
                    (13, BASE + 2),
                    (0, BASE + 0x24),
                ];
                with(&registers)(bench);
            });
            let state = &bench.core.state;
            assert_eq!(state.r[2..6], loaded, "{endian:?}");
            assert_eq!(
                (state.r[12], state.r[13]),
                (loaded[1], BASE + 0x12),
                "LDRSH"
            );
            let bytes = [bench.byte(BASE + 0x24), bench.byte(BASE + 0x25)];
            assert_eq!(
                (bytes, state.r[0]),
                (stored, BASE + 0x21),
                "{endian:?} STRH"
            );
            let bytes = [bench.byte(BASE + 0x20), bench.byte(BASE + 0x21)];
            assert_eq!(bytes, stored, "{endian:?}");
            assert_eq!(state.r[8], BASE + 0x20, "{endian:?}");
            assert_eq!((state.r[9], state.r[10]), (0xFFFF_FF84, BASE + 0x16));
        }
    }

    /// A8.8.64, A8.8.69, A8.8.81, A8.8.85 and A8.8.89: a literal is read from `Align(PC, 4)`, the instruction's
    /// address plus 8 in ARM state. `P` and `W` are `(1)` and `(0)` bits, and the last load here,
    /// with both clear, reads at the offset and writes nothing back.
    #[test]
    fn literals_are_read_from_the_pc_plus_8() {
        let code = [
            word_imm(form(LDR, OFFSET, UP), WORD, [0, 15], 16),
            word_imm(form(LDR, OFFSET, UP), BYTE, [1, 15], 12),
            extra_imm(form(LDR, OFFSET, UP), 0b11, [2, 15], 8),
            word_imm(form(LDR, POST, DOWN), WORD, [3, 15], 12),
            extra_imm(form(LDR, OFFSET, UP), 0b01, [4, 15], 0),
            extra_imm(form(LDR, OFFSET, DOWN), 0b10, [5, 15], 1),
        ];
        for (endian, byte, halfword, others) in [
            (Endian::Little, 0x84, 0xFFFF_8384, [0x8384, 0xFFFF_FF81]),
            (Endian::Big, 0x81, 0xFFFF_8182, [0x8182, 0xFFFF_FF84]),
        ] {
            let bench = after(endian, &code, |bench| bench.place_arm(24, &[0x8182_8384]));
            let state = &bench.core.state;
            assert_eq!(state.r[4..6], others, "{endian:?} LDRH and LDRSB");
            assert_eq!(
                state.r[..4],
                [0x8182_8384, byte, halfword, code[2]],
                "{endian:?}"
            );
            assert_eq!(state.r[15], 24, "{endian:?}");
        }
    }

    /// A8.8.63 and A8.8.132: `LDR` to the PC is `LoadWritePC()`, `BXWritePC()` in `ARMv7`, A2.3.2,
    /// after any writeback. A target in ARM state with bit 1 set is UNPREDICTABLE, and branches as
    /// `BranchWritePC()` would.
    #[test]
    fn a_load_to_the_pc_is_an_interworking_branch() {
        let pop = 0xE49D_F004; // POP {pc}, which is LDR pc, [sp], #4
        assert_eq!(pop, word_imm(form(LDR, POST, UP), WORD, [15, 13], 4));
        for (word, value, at, pc, thumb, base) in [
            (pop, 0x3004, BASE, 0x3004, 0, (13, BASE + 4)),
            (
                word_imm(form(LDR, OFFSET, UP), WORD, [15, 1], 0),
                0x2001,
                BASE,
                0x2000,
                1,
                (1, BASE),
            ),
            (
                word_imm(form(LDR, PRE, UP), WORD, [15, 1], 4),
                0x206,
                BASE + 4,
                0x204,
                0,
                (1, BASE + 4),
            ),
            (
                word_imm(form(LDR, OFFSET, DOWN), WORD, [15, 15], 4),
                0x101,
                4,
                0x100,
                1,
                (1, BASE),
            ),
        ] {
            for endian in BOTH {
                let bench = after(endian, &[word], |bench| {
                    bench.write(at, &in_order(endian, value));
                    with(&[(1, BASE), (13, BASE)])(bench);
                });
                let state = &bench.core.state;
                assert_eq!(
                    (state.r[15], state.t, state.r[base.0]),
                    (pc, thumb, base.1),
                    "{word:#010x} {endian:?}"
                );
            }
        }
    }

    /// A8.8.92, A8.8.71, A8.8.209, A8.8.220, and the halfword and signed ones of A5.2.9: the
    /// unprivileged forms are post-indexed, by a constant or a register, and checked as
    /// unprivileged accesses.
    #[test]
    fn the_unprivileged_forms_are_post_indexed() {
        let ldrt = word_imm(form(LDR, UNPRIVILEGED, UP), WORD, [0, 1], 4);
        let ldrbt = word_reg(form(LDR, UNPRIVILEGED, DOWN), BYTE, [2, 3, 4], (LSL, 1));
        let strt = word_imm(form(STR, UNPRIVILEGED, DOWN), WORD, [5, 6], 4);
        let strbt = word_reg(form(STR, UNPRIVILEGED, UP), BYTE, [5, 7, 8], (LSL, 0));
        let ldrht = extra_imm(form(LDR, UNPRIVILEGED, UP), 0b01, [9, 10], 2);
        let ldrsbt = extra_reg(form(LDR, UNPRIVILEGED, DOWN), 0b10, [11, 12, 8]);
        let strht = extra_imm(form(STR, UNPRIVILEGED, UP), 0b01, [5, 14], 2);
        let code = [ldrt, ldrbt, strt, strbt, ldrht, ldrsbt, strht];
        for word in [ldrt, ldrbt, strt, strbt] {
            let single = word_or_byte(word);
            assert!(single.unprivileged, "{word:#010x}");
            assert!(
                !single.indexing.index && single.indexing.wback,
                "{word:#010x}"
            );
        }
        for (word, size, signed) in [
            (ldrht, Size::Halfword, false),
            (ldrsbt, Size::Byte, true),
            (strht, Size::Halfword, false),
        ] {
            assert_eq!(
                halfword_or_signed(word),
                Some((size, signed)),
                "{word:#010x}"
            );
            let single = extra_single(word, size, signed);
            assert!(single.unprivileged, "{word:#010x}");
            assert!(
                !single.indexing.index && single.indexing.wback,
                "{word:#010x}"
            );
        }
        assert!(!word_or_byte(word_imm(form(LDR, POST, UP), WORD, [0, 1], 4)).unprivileged);
        for (endian, byte, half, signed) in [
            (Endian::Little, 0x00, 0x0128, 0x2C),
            (Endian::Big, 0x20, 0x2000, 0x20),
        ] {
            let registers = [
                (1, BASE),
                (3, BASE),
                (4, 2),
                (5, 0x1122_3344),
                (6, BASE + 0x20),
                (7, BASE + 0x24),
                (8, 3),
                (10, BASE + 0x28),
                (12, BASE + 0x2C),
                (14, BASE + 0x30),
            ];
            let bench = after(endian, &code, with(&registers));
            let state = &bench.core.state;
            assert_eq!((state.r[0], state.r[1]), (BASE, BASE + 4), "LDRT");
            assert_eq!(
                (state.r[2], state.r[3]),
                (byte, BASE - 4),
                "{endian:?} LDRBT"
            );
            assert_eq!(word_at(&bench, endian, BASE + 0x20), 0x1122_3344, "STRT");
            assert_eq!(state.r[6], BASE + 0x1C, "STRT");
            assert_eq!((bench.byte(BASE + 0x24), state.r[7]), (0x44, BASE + 0x27));
            assert_eq!(
                (state.r[9], state.r[10]),
                (half, BASE + 0x2A),
                "{endian:?} LDRHT"
            );
            assert_eq!(
                (state.r[11], state.r[12]),
                (signed, BASE + 0x29),
                "{endian:?}"
            );
            let stored = [bench.byte(BASE + 0x30), bench.byte(BASE + 0x31)];
            assert_eq!(
                stored,
                in_order(endian, 0x3344 << 16 | 0x3344)[..2],
                "STRHT"
            );
            assert_eq!(state.r[14], BASE + 0x32, "STRHT");
        }
        let registers = [
            word_reg(form(LDR, UNPRIVILEGED, UP), WORD, [0, 1, 2], (LSL, 2)),
            word_reg(form(STR, UNPRIVILEGED, DOWN), WORD, [3, 4, 2], (LSL, 3)),
            extra_imm(form(LDR, UNPRIVILEGED, DOWN), 0b11, [5, 6], 2),
        ];
        for word in &registers[..2] {
            assert!(word_or_byte(*word).unprivileged, "{word:#010x}");
        }
        assert!(extra_single(registers[2], Size::Halfword, true).unprivileged);
        for (endian, halfword) in [(Endian::Little, 0xFFFF_8281), (Endian::Big, 0xFFFF_8182)] {
            let bench = after(endian, &registers, |bench| {
                bench.write(BASE + 0x10, &[0x81, 0x82]);
                let registers = [
                    (1, BASE),
                    (2, 1),
                    (3, 0x1122_3344),
                    (4, BASE + 0x20),
                    (6, BASE + 0x10),
                ];
                with(&registers)(bench);
            });
            let state = &bench.core.state;
            assert_eq!(
                (state.r[0], state.r[1]),
                (BASE, BASE + 4),
                "{endian:?} LDRT"
            );
            assert_eq!(word_at(&bench, endian, BASE + 0x20), 0x1122_3344, "STRT");
            assert_eq!(state.r[4], BASE + 0x18, "{endian:?} STRT");
            assert_eq!(
                (state.r[5], state.r[6]),
                (halfword, BASE + 0xE),
                "{endian:?}"
            );
        }
    }

    /// A8.8.72 to A8.8.74, A8.8.210 and A8.8.211: `LDRD` and `STRD` move `Rt` and the register
    /// after it, in every addressing form and from a literal. An odd `Rt` is UNPREDICTABLE and runs
    /// with that `t2`, and a `t2` of the PC stores what `R[15]` reads.
    #[test]
    fn ldrd_and_strd_move_two_words() {
        let ldrd = |indexing: [u32; 2], u: u32, registers: [u32; 2], imm8: u32| {
            extra_imm(form(STR, indexing, u), 0b10, registers, imm8)
        };
        let strd = |indexing: [u32; 2], u: u32, registers: [u32; 2], imm8: u32| {
            extra_imm(form(STR, indexing, u), 0b11, registers, imm8)
        };
        let code = [
            ldrd(OFFSET, UP, [4, 1], 8),
            extra_reg(form(STR, PRE, DOWN), 0b10, [6, 2, 3]),
            strd(POST, UP, [8, 13], 16),
            ldrd(OFFSET, UP, [11, 1], 0),
            ldrd(OFFSET, DOWN, [0, 15], 0x18),
            strd(OFFSET, UP, [14, 10], 0),
        ];
        assert_eq!(code[0], 0xE1C1_40D8, "LDRD r4, r5, [r1, #8]");
        for endian in BOTH {
            let registers = [
                (1, BASE),
                (2, BASE),
                (3, 8),
                (8, 0x1122_3344),
                (9, 0x99),
                (13, BASE + 0x20),
                (10, BASE + 0x30),
                (14, 0x5566_7788),
            ];
            let bench = after(endian, &code, with(&registers));
            let state = &bench.core.state;
            assert_eq!(state.r[4..6], [BASE + 8, BASE + 12], "{endian:?} offset");
            assert_eq!(
                state.r[6..8],
                [BASE - 8, BASE - 4],
                "{endian:?} pre-indexed"
            );
            assert_eq!(state.r[2], BASE - 8, "{endian:?}");
            let stored = [0, 4].map(|k| word_at(&bench, endian, BASE + 0x20 + k));
            assert_eq!(stored, [0x1122_3344, 0x99], "{endian:?} post-indexed");
            assert_eq!(state.r[13], BASE + 0x30, "{endian:?}");
            assert_eq!(state.r[11..13], [BASE, BASE + 4], "{endian:?} an odd Rt");
            assert_eq!(state.r[..2], [code[0], code[1]], "{endian:?} a literal");
            let stored = [0, 4].map(|k| word_at(&bench, endian, BASE + 0x30 + k));
            assert_eq!(stored, [0x5566_7788, 5 * 4 + 8], "{endian:?} LR and the PC");
        }
        let strd = extra_reg(form(STR, OFFSET, DOWN), 0b11, [4, 1, 3]);
        for endian in BOTH {
            let registers = [(1, BASE + 8), (3, 8), (4, 0xA), (5, 0xB)];
            let bench = after(endian, &[strd], with(&registers));
            let stored = [0, 4].map(|k| word_at(&bench, endian, BASE + k));
            assert_eq!(stored, [0xA, 0xB], "{endian:?} STRD (register)");
            assert_eq!(bench.core.state.r[1], BASE + 8, "{endian:?}");
        }
        refused(ldrd(OFFSET, UP, [4, 1], 0), unaligned(false));
    }

    /// A8.8.75 to A8.8.78 and A8.8.212 to A8.8.215: a store exclusive stores, and answers 0, only
    /// after a load exclusive has opened the local monitor, and closes it again. A3.2.1 checks
    /// every exclusive's alignment, a doubleword's to eight bytes.
    #[test]
    fn a_store_exclusive_stores_only_with_the_monitor_open() {
        let code = [
            exclusive(0b1001, [0, 1, 0xF]),   // LDREX r0, [r1]
            exclusive(0b1000, [2, 1, 3]),     // STREX r2, r3, [r1]
            exclusive(0b1000, [4, 1, 5]),     // STREX r4, r5, [r1]
            exclusive(0b1011, [6, 8, 0xF]),   // LDREXD r6, r7, [r8]
            exclusive(0b1010, [9, 8, 10]),    // STREXD r9, r10, r11, [r8]
            exclusive(0b1101, [12, 13, 0xF]), // LDREXB r12, [sp]
            exclusive(0b1100, [14, 13, 3]),   // STREXB lr, r3, [sp]
        ];
        assert_eq!(code[0], 0xE191_0F9F, "LDREX r0, [r1]");
        for (endian, byte) in [(Endian::Little, 0x18), (Endian::Big, 0x20)] {
            let registers = [
                (1, BASE),
                (3, 0x1122_3344),
                (5, 0x5566_7788),
                (8, BASE + 8),
                (10, 0xAAAA_0001),
                (11, 0xBBBB_0002),
                (13, BASE + 0x18),
            ];
            let bench = after(endian, &code, with(&registers));
            let state = &bench.core.state;
            assert_eq!(state.r[..5], [BASE, BASE, 0, 0x1122_3344, 1], "{endian:?}");
            assert_eq!(word_at(&bench, endian, BASE), 0x1122_3344, "{endian:?}");
            assert_eq!(
                state.r[6..10],
                [BASE + 8, BASE + 12, BASE + 8, 0],
                "{endian:?}"
            );
            let stored = [0, 4].map(|k| word_at(&bench, endian, BASE + 8 + k));
            assert_eq!(stored, [0xAAAA_0001, 0xBBBB_0002], "{endian:?}");
            assert_eq!(state.r[12], byte, "{endian:?}");
            assert_eq!(
                (state.r[14], bench.byte(BASE + 0x18)),
                (0, 0x44),
                "{endian:?}"
            );
            assert_eq!(state.exclusive_valid, 0, "{endian:?}");
        }
        // A store exclusive checks the alignment before the monitor, which is closed here, B2.3.7.
        for (word, write) in [
            (exclusive(0b1001, [0, 1, 0xF]), false),
            (exclusive(0b1000, [2, 1, 3]), true),
            (exclusive(0b1011, [6, 1, 0xF]), false),
            (exclusive(0b1010, [9, 1, 10]), true),
        ] {
            refused(word, unaligned(write));
        }
        let halves = [exclusive(0b1111, [0, 1, 0xF]), exclusive(0b1110, [2, 1, 3])];
        for endian in BOTH {
            let bench = after(endian, &halves, with(&[(1, BASE + 4), (3, 0xABCD)]));
            let read = in_order(endian, BASE + 4);
            let expected = match endian {
                Endian::Little => u32::from(u16::from_le_bytes([read[0], read[1]])),
                Endian::Big => u32::from(u16::from_be_bytes([read[0], read[1]])),
            };
            assert_eq!(
                bench.core.state.r[..3],
                [expected, BASE + 4, 0],
                "{endian:?}"
            );
            let stored = [bench.byte(BASE + 4), bench.byte(BASE + 5)];
            assert_eq!(stored, in_order(endian, 0xABCD_ABCD)[..2], "{endian:?}");
        }
    }

    /// A8.8.229: `SWP` and `SWPB` load and store as one, with DDI 0460D 4.3.16's `SCTLR.SW` set,
    /// and are UNDEFINED with it clear. `SWP` is always aligned, Table A3-1.
    #[test]
    fn swp_swaps_only_with_sctlr_sw_set() {
        let swp = 0xE102_0091; // SWP r0, r1, [r2]
        let swpb = 0xE145_3094; // SWPB r3, r4, [r5]
        let mut bench = ready(Endian::Little, &[swp], with(&[(2, BASE)]));
        assert_eq!(bench.run(1).1, SPUN);
        assert_eq!(bench.raised(), Some((Exception::Undefined, 0)));
        for (endian, byte) in [(Endian::Little, 0x04), (Endian::Big, 0x20)] {
            let registers = [(1, 0x1122_3344), (2, BASE), (4, 0xAB), (5, BASE + 4)];
            let bench = after(endian, &[swp, swpb], |bench| {
                bench.core.sctlr |= mask(sctlr::SW);
                with(&registers)(bench);
            });
            let state = &bench.core.state;
            assert_eq!((state.r[0], state.r[3]), (BASE, byte), "{endian:?}");
            assert_eq!(word_at(&bench, endian, BASE), 0x1122_3344, "{endian:?}");
            assert_eq!(bench.byte(BASE + 4), 0xAB, "{endian:?}");
        }
        let mut bench = ready(Endian::Big, &[swp], with(&[(2, BASE + 2)]));
        bench.core.sctlr |= mask(sctlr::SW);
        assert_eq!(bench.run(1).1, SPUN);
        assert_eq!(
            bench.aborted(),
            Some(Raised::DataAbort {
                refused: Refused::Unaligned(BASE + 2),
                write: false
            })
        );
    }

    /// The encodings the pseudocode can't run: a writeback to the PC, a load to it other than
    /// `LDR`'s, a doubleword's second register past R14 or a load's at the PC, and Table A5-11's
    /// and A5-12's unallocated rows.
    #[test]
    fn what_the_pseudocode_cannot_run_is_undefined() {
        for word in [
            word_imm(form(STR, PRE, UP), WORD, [0, 15], 4),
            word_reg(form(LDR, PRE, UP), WORD, [0, 15, 1], (LSL, 0)),
            word_reg(form(STR, POST, UP), BYTE, [0, 15, 1], (LSL, 0)),
            word_imm(form(LDR, OFFSET, UP), BYTE, [15, 1], 0),
            word_imm(form(LDR, OFFSET, UP), BYTE, [15, 15], 0),
            word_imm(form(LDR, UNPRIVILEGED, UP), WORD, [15, 1], 4),
            word_imm(form(LDR, UNPRIVILEGED, UP), WORD, [0, 15], 4),
            word_imm(form(STR, UNPRIVILEGED, UP), WORD, [0, 15], 4),
            extra_imm(form(LDR, OFFSET, UP), 0b01, [15, 1], 0),
            extra_imm(form(LDR, OFFSET, UP), 0b10, [15, 15], 0),
            extra_imm(form(STR, PRE, UP), 0b01, [0, 15], 2),
            extra_imm(form(LDR, UNPRIVILEGED, UP), 0b01, [0, 15], 2),
            extra_imm(form(LDR, UNPRIVILEGED, UP), 0b11, [15, 1], 2),
            extra_imm(form(STR, UNPRIVILEGED, UP), 0b10, [0, 1], 0),
            extra_imm(form(STR, UNPRIVILEGED, UP), 0b11, [1, 1], 0),
            extra_imm(form(STR, OFFSET, UP), 0b10, [14, 1], 0),
            extra_imm(form(STR, OFFSET, UP), 0b10, [15, 1], 0),
            extra_imm(form(STR, OFFSET, UP), 0b11, [15, 1], 0),
            extra_imm(form(STR, PRE, UP), 0b11, [0, 15], 0),
            extra_reg(form(STR, PRE, UP), 0b10, [0, 15, 2]),
            exclusive(0b1001, [15, 1, 0xF]),
            exclusive(0b1000, [15, 1, 2]),
            exclusive(0b1011, [14, 1, 0xF]),
            exclusive(0b1011, [15, 1, 0xF]),
            exclusive(0b1010, [0, 1, 15]),
            0xE102_F091, // SWP pc, r1, [r2]
        ] {
            undefined(word);
        }
        for op in [0b0001, 0b0010, 0b0011, 0b0101, 0b0110, 0b0111] {
            undefined(exclusive(op, [0, 1, 2]));
        }
    }

    /// The register choices the manual calls UNPREDICTABLE run the pseudocode: `STR` and `STRB` of
    /// the PC store `PCStoreValue()`, the address plus 8, a word load wins over its own writeback
    /// and a byte load loses to it, a store stores its base before writing it back, and an `Rm` of
    /// the PC reads as the address plus 8.
    #[test]
    fn unpredictable_choices_run_the_pseudocode() {
        for (word, register, value, stored) in [
            (
                word_imm(form(STR, OFFSET, UP), WORD, [15, 1], 0),
                1,
                BASE,
                Some(8),
            ),
            (
                word_imm(form(STR, OFFSET, UP), BYTE, [15, 1], 0),
                1,
                BASE,
                None,
            ),
            (
                word_imm(form(LDR, POST, UP), WORD, [1, 1], 8),
                1,
                BASE,
                None,
            ),
            (
                word_imm(form(LDR, POST, UP), BYTE, [1, 1], 8),
                1,
                BASE + 8,
                None,
            ),
            (
                word_reg(form(LDR, OFFSET, UP), WORD, [0, 1, 15], (LSL, 0)),
                0,
                BASE + 8,
                None,
            ),
            (
                word_imm(form(STR, PRE, UP), WORD, [1, 1], 4),
                1,
                BASE + 4,
                Some(BASE),
            ),
        ] {
            for endian in BOTH {
                let bench = after(endian, &[word], with(&[(1, BASE)]));
                assert_eq!(
                    bench.core.state.r[register], value,
                    "{word:#010x} {endian:?}"
                );
                if let Some(stored) = stored {
                    let at = bench.core.state.r[1];
                    assert_eq!(word_at(&bench, endian, at), stored, "{word:#010x}");
                }
            }
        }
        let bench = after(
            Endian::Big,
            &[word_imm(form(STR, OFFSET, UP), BYTE, [15, 1], 0)],
            with(&[(1, BASE)]),
        );
        assert_eq!(bench.byte(BASE), 8);
    }
}
