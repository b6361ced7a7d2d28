// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! ARM state's coprocessor instructions and `SVC`, DDI 0406C A5.6.
//!
//! The R5's coprocessors are CP15, the system control coprocessor, CP14 for debug, and CP10 and
//! CP11 for its floating-point unit, DDI 0460D 4.2, 12.3 and 11.1. Every other one is UNDEFINED,
//! B1.10.2. CP15 and CP14 take `MCR` and `MRC` and nothing else, but for the `LDC` and `STC` of the
//! debug data transfer registers, B5.6.2.
//!
//! Where the manual says UNPREDICTABLE, you get what the pseudocode does when it can run: `MCR`
//! from the PC sends the instruction's address plus 8, A2.3, and `MRC` to `APSR_nzcv` sets the
//! flags. A writeback to the PC is UNDEFINED, since `R[]` can't write it, A2.3.2.

use cranelift_codegen::ir::{InstBuilder, Value, types};

use super::super::family::{Family, SystemRegister, helpers};
use super::super::registers::cpsr;
use super::arm_misc::refuse_in_user_mode;
use super::float_r;
use crate::cpu::armv7::translate::{
    ALWAYS, Attributes, Emitter, Fault, Flag, InstructionSet, Profile, Size, Translated, Undefined,
    bits, thumb32,
};

/// The system control coprocessor.
const SYSTEM: u32 = 15;
/// The debug coprocessor.
const DEBUG: u32 = 14;
/// CP14's register `LDC` and `STC` transfer, `c5`, DDI 0460D Table 12-2.
const DATA_TRANSFER: u32 = 5;

/// A5.6, the coprocessor instructions and `SVC`, Table A5-22, by `op1`, bits 25 to 20, and
/// `coproc`.
pub(super) fn coprocessor_supervisor_call(
    e: &mut Emitter<'_, '_, Family>,
    word: u32,
) -> Translated {
    let op1 = bits(word, 25, 20);
    match op1 >> 1 {
        // SVC, A8.8.228, which retires and returns past itself.
        0b11_000..=0b11_111 => {
            Family::raise(e, Fault::SupervisorCall);
            return Ok(());
        }
        0 => return Err(Undefined),
        _ => {}
    }
    match bits(word, 11, 8) {
        0b1010 | 0b1011 => floating_point(e, word),
        SYSTEM => system(e, word),
        DEBUG => debug(e, word),
        _ => Err(Undefined),
    }
}

/// Whether `word` is `MCR` or `MRC`, Table A5-22's `op1` of 10xxxx with `op` set.
fn moves_one_word(word: u32) -> bool {
    bits(word, 25, 24) == 0b10 && bits(word, 4, 4) == 1
}

/// Whether `word` is `MRC`, which reads the coprocessor, rather than `MCR`.
fn reads(word: u32) -> bool {
    bits(word, 20, 20) == 1
}

/// CP15's `MCR` and `MRC`, A8.8.98 and A8.8.107, through the family's [`helpers::mcr`] and
/// [`helpers::mrc`], which answer UNDEFINED for a register the R5 hasn't got or the privilege may
/// not reach. A write ends the block, since what the next instruction's translation depends on
/// may have changed, B5.6.3. B5.6.2 makes every other CP15 encoding UNDEFINED. An `MCR` from the
/// PC, or from the SP in Thumb state, is UNPREDICTABLE, A8.8.98, and UNDEFINED here.
fn system(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    if !moves_one_word(word) {
        return Err(Undefined);
    }
    let t = bits(word, 15, 12);
    if !reads(word) && (t == 15 || t == 13 && e.state() == InstructionSet::Thumb) {
        return Err(Undefined);
    }
    let instruction = e.constant(word);
    let index = e.constant(e.index);
    if reads(word) {
        let answer = e.call_helper(
            helpers::mrc as *const () as usize,
            &[instruction, index],
            types::I64,
        );
        e.fault_unless(answer);
        let value = e.b.ins().ireduce(types::I32, answer);
        write_transferred(e, t, value);
    } else {
        let value = e.reg(t);
        let answer = e.call_helper(
            helpers::mcr as *const () as usize,
            &[instruction, value, index],
            types::I64,
        );
        e.fault_unless(answer);
        e.end_block();
    }
    Ok(())
}

/// What `MRC` does with the word it reads, A8.8.107: `R[t]`, or the flags from its top four bits
/// for a `t` of 1111, `APSR_nzcv`.
fn write_transferred(e: &mut Emitter<'_, '_, Family>, t: u32, value: Value) {
    if t != 15 {
        e.set_reg(t, value);
        return;
    }
    for (flag, field) in [
        (Flag::N, cpsr::N),
        (Flag::Z, cpsr::Z),
        (Flag::C, cpsr::C),
        (Flag::V, cpsr::V),
    ] {
        let bit = e.b.ins().ushr_imm_u(value, i64::from(field.bit));
        let bit = e.b.ins().band_imm_u(bit, 1);
        e.set_flag(flag, bit);
    }
}

/// CP14, DDI 0460D 12.3.3 and 3.9: `MRC` and `MCR` to the registers Tables 12-2 and 3-7 list, and
/// `LDC` and `STC` to the data transfer registers. Every other CP14 encoding is UNDEFINED, as 12.3.3
/// says.
fn debug(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    if moves_one_word(word) {
        return debug_register(e, word);
    }
    // Table A5-22's `LDC` and `STC`, `op1` of 0xxxxx but 000x0x, without `D`.
    let transfers = bits(word, 25, 25) == 0 && bits(word, 24, 21) & 0b1101 != 0;
    if transfers && bits(word, 22, 22) == 0 && bits(word, 15, 12) == DATA_TRANSFER {
        return transfer_data(e, word);
    }
    Err(Undefined)
}

/// `MRC` and `MCR` to CP14's debug registers, DDI 0460D Table 12-2, and its Jazelle registers,
/// Table 3-7. The debug logic isn't modeled, so each reads as zero and ignores what's written. With
/// `DBGDSCR.UDCCdis` reading as zero, User mode reaches every debug register, 12.3.2. Of the
/// Jazelle registers it reads `JIDR` and reaches `JMCR`, but writes to `JIDR` and any access to
/// `JOSCR` are UNDEFINED there, DDI 0406C B1.13, B6.1.63 and B5.6.2.
fn debug_register(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let SystemRegister {
        opc1,
        crn,
        crm,
        opc2,
    } = SystemRegister::of(word);
    let read = reads(word);
    let os_control = (opc1, crn, crm, opc2) == (7, 1, 0, 0);
    let id_written = (opc1, crn, crm, opc2) == (7, 0, 0, 0) && !read;
    let listed = match (opc1, crn, crm, opc2) {
        // DBGDIDR, DBGDRAR, DBGDSAR and DBGDSCRint, which are only read.
        (0, 0..=2, 0, 0) | (0, 0, 1, 0) => read,
        // DBGDTRRXint read and DBGDTRTXint written, then JIDR, JOSCR and JMCR.
        (0, 0, 5, 0) | (7, 0..=2, 0, 0) => true,
        _ => false,
    };
    if !listed {
        return Err(Undefined);
    }
    if os_control || id_written {
        refuse_in_user_mode(e);
    }
    if read {
        let zero = e.constant(0);
        write_transferred(e, bits(word, 15, 12), zero);
    }
    Ok(())
}

/// `LDC` and `STC` to CP14's `c5`, A8.8.55, A8.8.56 and A8.8.198: one word from `DBGDTRTXint`, which
/// reads as zero, or to `DBGDTRRXint`, which ignores it, DDI 0460D 12.4.5, at `R[n]` or
/// `R[n] ± imm8 * 4`, with the writeback `W` asks for. A base of the PC reads as `Align(PC, 4)`,
/// the literal form, and a writeback to it is UNDEFINED.
fn transfer_data(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let (n, wback) = (bits(word, 19, 16), bits(word, 21, 21) == 1);
    if n == 15 && wback {
        return Err(Undefined);
    }
    let base = if n == 15 {
        e.constant(e.aligned_pc())
    } else {
        e.reg(n)
    };
    let offset = i64::from(bits(word, 7, 0) * 4);
    let offset = if bits(word, 23, 23) == 1 {
        offset
    } else {
        -offset
    };
    let offset_addr = e.b.ins().iadd_imm_s(base, offset);
    let address = if bits(word, 24, 24) == 1 {
        offset_addr
    } else {
        base
    };
    if reads(word) {
        Family::load(e, address, Size::Word, Attributes::ALIGNED);
    } else {
        let zero = e.constant(0);
        Family::store(e, address, zero, Size::Word, Attributes::ALIGNED);
    }
    if wback {
        e.set_reg(n, offset_addr);
    }
    Ok(())
}

/// CP10 and CP11, the floating-point extension's, through the decode both profiles share. A7.5 to
/// A7.9 give each of its encodings the same bits below the top four in either state, so it's handed
/// the Thumb encoding with `1110` on top, and the instruction's own condition stays the
/// translator's. The R profile's own system registers go first, as in Thumb state.
fn floating_point(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    let [hw1_high, hw1_low, hw2_high, hw2_low] = (word & 0x0FFF_FFFF | ALWAYS << 28).to_be_bytes();
    let hw1 = u16::from_be_bytes([hw1_high, hw1_low]);
    let hw2 = u16::from_be_bytes([hw2_high, hw2_low]);
    if float_r::owns(hw1, hw2) {
        return float_r::system_register(e, hw1, hw2);
    }
    thumb32(e, hw1, hw2)
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::registers::sctlr;
    use super::super::super::state::{Mode, State};
    use super::super::testing::{Bench, RAM};
    use super::*;
    use crate::cpu::armv7::registers::mask;
    use crate::soc::Endian;

    const BOTH: [Endian; 2] = [Endian::Little, Endian::Big];
    /// The Undefined Instruction exception, taken at the instruction at 0.
    const UNDEFINED: Option<(Exception, u32)> = Some((Exception::Undefined, 0));
    /// Where the tests' data is.
    const BASE: u32 = RAM + 0x100;

    /// `MCR` or `MRC`, by `read`, to `coproc`'s register `opc1`, `CRn`, `CRm` and `opc2`, with `Rt`.
    fn transfer(read: bool, coproc: u32, [opc1, crn, crm, opc2]: [u32; 4], rt: u32) -> u32 {
        ALWAYS << 28
            | 0b1110 << 24
            | opc1 << 21
            | u32::from(read) << 20
            | crn << 16
            | rt << 12
            | coproc << 8
            | opc2 << 5
            | 1 << 4
            | crm
    }

    /// `LDC` or `STC`, by `load`, to `coproc`'s `CRd`, with `P`, `U`, `D` and `W` and `imm8`.
    fn memory(load: bool, coproc: u32, [p, u, d, w]: [u32; 4], rn: u32, crd: u32) -> u32 {
        const IMM8: u32 = 2;
        ALWAYS << 28
            | 0b110 << 25
            | p << 24
            | u << 23
            | d << 22
            | w << 21
            | u32::from(load) << 20
            | rn << 16
            | crd << 12
            | coproc << 8
            | IMM8
    }

    /// A bench on a part in `endian` that's run `word` after `prepare`, and whether it retired:
    /// whether it ran with no exception taken at it but the call `SVC` makes.
    fn ran(endian: Endian, word: u32, prepare: impl FnOnce(&mut Family)) -> (Bench, bool) {
        let mut bench = Bench::arm(endian, &[word]);
        prepare(&mut bench.core);
        let (_, ran) = bench.run(1);
        let faulted = bench
            .raised()
            .is_some_and(|(exception, _)| exception != Exception::SupervisorCall);
        (bench, ran == 1 && !faulted)
    }

    /// The state after `word` ran and retired, set up by `prepare`.
    fn run(word: u32, prepare: impl FnOnce(&mut State)) -> State {
        let (bench, retired) = ran(Endian::Little, word, |core| prepare(&mut core.state));
        assert!(retired, "{word:#010x} retires");
        assert_eq!(bench.taken(), None, "{word:#010x}");
        bench.core.state
    }

    /// Whether `word` is refused as UNDEFINED from `mode`, without retiring or changing a register.
    fn undefined_in(word: u32, mode: Mode) {
        let (bench, retired) = ran(Endian::Little, word, |core| {
            core.state.r[0] = 0x1234;
            core.state.set_mode(mode);
        });
        assert!(!retired, "{word:#010x}");
        assert_eq!(bench.raised(), UNDEFINED, "{word:#010x}");
        let (r, _) = bench.before_taken();
        assert_eq!((r[0], r[15]), (0x1234, 0), "{word:#010x}");
    }

    fn undefined(word: u32) {
        undefined_in(word, Mode::Supervisor);
    }

    /// A8.8.228: `SVC` retires and raises the Supervisor Call exception. With its condition failing
    /// it does nothing.
    #[test]
    fn svc_retires_and_calls_the_supervisor() {
        let (bench, retired) = ran(Endian::Little, 0xEF00_0042, |_| {});
        assert!(retired);
        assert_eq!(
            (bench.raised(), bench.returns(Exception::SupervisorCall).0),
            (Some((Exception::SupervisorCall, 0)), 4)
        );
        let state = run(0x0F00_0042, |_| {}); // SVCEQ, with Z clear
        assert_eq!(state.r[15], 4);
    }

    /// A8.8.98 and A8.8.107: `MRC` reads CP15's registers, `SCTLR` at its reset value, into `Rt` or, with `Rt` the PC, the
    /// flags from the top four bits, `MCR` writes them, the PC as the address plus 8, and from User
    /// mode both are UNDEFINED, DDI 0460D 4.3.16.
    #[test]
    fn mcr_and_mrc_reach_cp15() {
        let (sctlr, midr) = ([0, 1, 0, 0], [0, 0, 0, 0]);
        let state = run(transfer(true, SYSTEM, sctlr, 3), |_| {});
        assert_eq!(
            state.r[3],
            0x00E5_0878 | mask(sctlr::V),
            "the bench ties high vectors"
        );
        let state = run(transfer(true, SYSTEM, midr, 15), |_| {});
        assert_eq!((state.n, state.z, state.c, state.v), (0, 1, 0, 0));
        let a = 1 << 1;
        let (bench, retired) = ran(Endian::Big, transfer(false, SYSTEM, sctlr, 2), |core| {
            core.state.r[2] = core.sctlr | a;
        });
        assert!(retired);
        assert_eq!(bench.core.sctlr & a, a);
        // A8.8.98: in ARM state an `MCR` from the SP runs, here to `TPIDRPRW`.
        let tpidrprw = [0, 13, 0, 4];
        let (mut bench, retired) =
            ran(Endian::Big, transfer(false, SYSTEM, tpidrprw, 13), |core| {
                core.state.r[13] = 0x1234;
            });
        assert!(retired);
        let [opc1, crn, crm, opc2] = tpidrprw;
        let register = SystemRegister {
            opc1,
            crn,
            crm,
            opc2,
        };
        assert_eq!(bench.core.cp15_read(register, 0), Some(0x1234));
        for word in [
            transfer(true, SYSTEM, sctlr, 0),
            transfer(false, SYSTEM, sctlr, 0),
        ] {
            undefined_in(word, Mode::User);
        }
    }

    /// B5.6.2: every CP15 and CP14 encoding but `MCR` and `MRC`, and CP14's `LDC` and `STC` of
    /// `c5`, is UNDEFINED, `MCRR`, `MRRC` and `CDP` among them, and so are CP14's registers Table
    /// 12-2 doesn't list, DDI 0460D 12.3.3.
    #[test]
    fn cp15_and_cp14_refuse_every_other_encoding() {
        for word in [
            transfer(false, SYSTEM, [0, 1, 0, 0], 15), // MCR from the PC
            0xEC40_0F00,                               // MCRR p15, 0, r0, r0, c0
            0xEC50_0F00,                               // MRRC p15, 0, r0, r0, c0
            0xEE00_0F00,                               // CDP p15, 0, c0, c0, c0
            0xED90_0F00,                               // LDC p15, c0, [r0]
            0xED80_0F00,                               // STC p15, c0, [r0]
            0xEC40_0E00,                               // MCRR p14, 0, r0, r0, c0
            0xEC50_0E00,                               // MRRC p14, 0, r0, r0, c0
            0xEE00_0E00,                               // CDP p14, 0, c0, c0, c0
            memory(true, DEBUG, [1, 1, 1, 0], 1, DATA_TRANSFER), // LDCL p14, c5
            memory(true, DEBUG, [1, 1, 0, 0], 1, 4),   // LDC p14, c4
            memory(false, DEBUG, [1, 1, 0, 0], 1, 6),  // STC p14, c6
            memory(true, DEBUG, [0, 1, 0, 1], 15, DATA_TRANSFER), // a writeback to the PC
            transfer(false, DEBUG, [0, 0, 0, 0], 0),   // MCR to DBGDIDR
            transfer(false, DEBUG, [0, 0, 1, 0], 0),   // MCR to DBGDSCRint
            transfer(true, DEBUG, [0, 0, 2, 0], 0),    // MRC of c0, c2
            transfer(true, DEBUG, [1, 0, 0, 0], 0),    // MRC of the trace registers
            transfer(true, DEBUG, [6, 0, 0, 0], 0),    // MRC of ThumbEE's
            transfer(true, DEBUG, [7, 3, 0, 0], 0),    // MRC of p14, 7, c3
        ] {
            undefined(word);
        }
    }

    /// DDI 0460D Tables 12-2 and 3-7: CP14's debug and Jazelle registers read as zero and ignore
    /// writes, from any mode, but `JOSCR` and a write to `JIDR`, which only PL1 reaches, DDI 0406C
    /// B1.13 and B6.1.63. An `MRC` of
    /// `DBGDSCRint` to `APSR_nzcv` clears the flags.
    #[test]
    fn cp14_s_registers_read_as_zero_and_ignore_writes() {
        let readable: [[u32; 4]; 8] = [
            [0, 0, 0, 0], // DBGDIDR
            [0, 1, 0, 0], // DBGDRAR
            [0, 2, 0, 0], // DBGDSAR
            [0, 0, 1, 0], // DBGDSCRint
            [0, 0, 5, 0], // DBGDTRRXint
            [7, 0, 0, 0], // JIDR
            [7, 1, 0, 0], // JOSCR
            [7, 2, 0, 0], // JMCR
        ];
        for register in readable {
            for mode in [Mode::Supervisor, Mode::User] {
                let word = transfer(true, DEBUG, register, 3);
                if register == [7, 1, 0, 0] && mode == Mode::User {
                    undefined_in(word, mode);
                    continue;
                }
                let state = run(word, |s| {
                    (s.r[3], s.n) = (0x1234, 1);
                    s.set_mode(mode);
                });
                assert_eq!((state.r[3], state.n), (0, 1), "{word:#010x} {mode:?}");
            }
        }
        undefined_in(transfer(false, DEBUG, [7, 0, 0, 0], 3), Mode::User);
        let state = run(transfer(false, DEBUG, [7, 0, 0, 0], 3), |s| s.r[3] = 0x1234);
        assert_eq!(
            (state.r[3], state.r[15]),
            (0x1234, 4),
            "JIDR from Supervisor mode"
        );
        for register in [[0, 0, 5, 0], [7, 2, 0, 0]] {
            let word = transfer(false, DEBUG, register, 3);
            let state = run(word, |s| {
                s.r[3] = 0x1234;
                s.set_mode(Mode::User);
            });
            assert_eq!((state.r[3], state.r[15]), (0x1234, 4), "{word:#010x}");
        }
        let state = run(transfer(true, DEBUG, [0, 0, 1, 0], 15), |s| {
            (s.n, s.z, s.c, s.v) = (1, 1, 1, 1);
        });
        assert_eq!((state.n, state.z, state.c, state.v), (0, 0, 0, 0));
    }

    /// A8.8.198 and A8.8.55 with DDI 0460D Table 12-2: `STC p14, c5` stores `DBGDTRRXint`, which
    /// reads as zero, at the address its indexing gives and nowhere else, and `LDC p14, c5` loads a
    /// word for `DBGDTRTXint`, which ignores it, changing no memory. Each writes back what `W` asks
    /// for, in the data's byte order.
    #[test]
    fn ldc_and_stc_move_one_word_through_the_data_transfer_registers() {
        const FILL: u8 = 0xAA;
        let span = BASE - 8..BASE + 12;
        for ([p, u, w], at, written) in [
            ([1, 1, 0], BASE + 8, BASE),
            ([1, 0, 1], BASE - 8, BASE - 8),
            ([1, 1, 1], BASE + 8, BASE + 8),
            ([0, 1, 1], BASE, BASE + 8),
            ([0, 0, 1], BASE, BASE - 8),
            ([0, 1, 0], BASE, BASE),
        ] {
            for endian in BOTH {
                for load in [false, true] {
                    let word = memory(load, DEBUG, [p, u, 0, w], 1, DATA_TRANSFER);
                    let mut bench = Bench::arm(endian, &[word]);
                    bench.write(span.start, &[FILL; 20]);
                    bench.core.state.r[1] = BASE;
                    assert_eq!(bench.run(1).1, 1, "{word:#010x}");
                    assert_eq!(bench.core.raised, None, "{word:#010x}");
                    for k in span.clone() {
                        let stored = !load && (at..at + 4).contains(&k);
                        let expected = if stored { 0 } else { FILL };
                        assert_eq!(bench.byte(k), expected, "{word:#010x} {endian:?} {k:#x}");
                    }
                    assert_eq!(bench.core.state.r[1], written, "{word:#010x}");
                }
            }
        }
        let (bench, _) = ran(Endian::Little, 0xED9F_5E01, |core| {
            core.state.r[1] = 1;
        }); // LDC p14, c5, [pc, #4]
        assert_eq!((bench.taken(), bench.core.state.r[15]), (None, 4));
    }

    /// A3.2.1: `LDC` and `STC` are word-aligned accesses, and an unaligned one is a Data Abort that
    /// leaves the base as it was.
    #[test]
    fn ldc_and_stc_refuse_an_unaligned_address() {
        for load in [true, false] {
            let word = memory(load, DEBUG, [0, 1, 0, 1], 1, DATA_TRANSFER);
            let (bench, retired) = ran(Endian::Big, word, |core| core.state.r[1] = BASE + 2);
            assert!(!retired, "{word:#010x}");
            assert!(bench.aborted().is_some(), "{word:#010x}");
            assert_eq!(bench.core.state.r[1], BASE + 2, "{word:#010x}");
        }
    }

    /// A5.6: CP10 and CP11 answer what the shared floating-point decode answers for the same
    /// encoding in Thumb state, and every coprocessor the R5 hasn't got is UNDEFINED, as are
    /// Table A5-22's rows that no coprocessor gets.
    #[test]
    fn cp10_and_cp11_go_to_the_floating_point_decode() {
        for word in [
            0xEE30_0A00, // VADD.F32 s0, s0, s0
            0xED90_0B00, // VLDR d0, [r0]
            0xEEF1_0A10, // VMRS r0, FPSCR
            0xEC41_0B10, // VMOV d0, r0, r1
            0xEE00_0A10, // VMOV s0, r0
        ] {
            let thumb = [word >> 16, word & 0xFFFF].map(|half| u16::try_from(half).unwrap());
            let mut on_thumb = Bench::thumb(Endian::Little, &thumb);
            on_thumb.run(1);
            let (bench, _) = ran(Endian::Little, word, |_| {});
            assert!(bench.raised().is_some(), "{word:#010x}");
            assert_eq!(bench.raised(), on_thumb.raised(), "{word:#010x}");
        }
        for word in [
            0xEE01_0010, // MCR p0, 0, r0, c1, c0
            0xEE11_0710, // MRC p7, 0, r0, c1, c0
            0xEE11_0D10, // MRC p13, 0, r0, c1, c0
            0xED90_0C00, // LDC p12, c0, [r0]
            0xEC00_0F00, // op1 000000
            0xEC10_0A00, // op1 000001, CP10
        ] {
            undefined(word);
        }
    }
}
