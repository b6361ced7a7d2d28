// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! ARM state's branches and block transfers, DDI 0406C A5.5.
//!
//! `LDM` and `STM` lower through the shared [`memory`] multiples Thumb's run through, which walk
//! all four ways in ARM state. The forms with `^` reach the User mode registers, B9.3.6 and
//! B9.3.17, or return from an exception, B9.3.5.
//!
//! Where the manual says UNPREDICTABLE, you get what the pseudocode does when it can run: a base of
//! the PC reads as the instruction's address plus 8, A2.3, a list of none transfers nothing, a
//! base in its own list keeps what it loaded, and a `(0)` bit is ignored. A writeback to the PC is
//! UNDEFINED, since `R[]` can't write it, A2.3.2. In User mode and System mode, the User registers
//! are the current ones, and an exception return finds no SPSR and only branches, B9.1.1.

use cranelift_codegen::ir::{InstBuilder, Value};

use super::super::family::{Family, helpers};
use super::super::state::Mode;
use crate::cpu::armv7::translate::memory::{self, Step};
use crate::cpu::armv7::translate::{Attributes, Emitter, Profile, Size, Translated, bits};

/// A5.5, branch, branch with link, and block data transfer, Table A5-21.
pub(super) fn branch_block_transfer(e: &mut Emitter<'_, '_, Family>, word: u32) -> Translated {
    if bits(word, 25, 25) == 1 {
        branch(e, word);
        return Ok(());
    }
    let (n, registers) = (bits(word, 19, 16), bits(word, 15, 0));
    let wback = bits(word, 21, 21) == 1;
    let step = match (bits(word, 24, 24), bits(word, 23, 23)) {
        (0, 0) => Step::DecrementAfter,
        (0, _) => Step::IncrementAfter,
        (_, 0) => Step::DecrementBefore,
        _ => Step::IncrementBefore,
    };
    match (bits(word, 22, 22) == 1, bits(word, 20, 20) == 1) {
        (false, true) => {
            memory::load_multiple(e, n, registers, wback, step, Family::branch_exchange)
        }
        (false, false) => memory::store_multiple(e, n, registers, wback, step),
        (true, false) => {
            store_user_registers(e, n, registers, step);
            Ok(())
        }
        (true, true) if registers >> 15 == 0 => {
            load_user_registers(e, n, registers, step);
            Ok(())
        }
        (true, true) => memory::load_multiple(e, n, registers, wback, step, exception_return),
    }
}

/// `B` and `BL`, A8.8.18 and A8.8.25 encoding A1, by bit 24: a branch to the PC, the instruction's
/// address plus 8, and `imm24:'00'` sign-extended. `BL` leaves the next instruction's address in
/// LR first.
fn branch(e: &mut Emitter<'_, '_, Family>, word: u32) {
    let imm32 = ((bits(word, 23, 0) << 8).cast_signed() >> 6).cast_unsigned();
    if bits(word, 24, 24) == 1 {
        let link = e.constant(e.next_pc());
        e.set_reg(14, link);
    }
    e.branch_to(e.pc().wrapping_add(8).wrapping_add(imm32));
}

/// `LDM` with the PC and `^`, B9.3.5: the word for the PC is where the exception returns to, and
/// the SPSR becomes the CPSR, after the other registers are loaded in the current mode.
fn exception_return(e: &mut Emitter<'_, '_, Family>, address: Value) {
    let spsr = e.call(helpers::spsr as *const () as usize, &[]);
    Family::exception_return(e, address, spsr);
}

/// `LDM` with `^` and no PC, B9.3.6: each word into User mode's register, from any mode. Its `W`
/// is a `(0)` bit, so it never writes back.
fn load_user_registers(e: &mut Emitter<'_, '_, Family>, n: u32, registers: u32, step: Step) {
    let base = e.reg(n);
    let (mut address, _) = memory::span(e, base, 4 * registers.count_ones(), step);
    let mut loaded = Vec::new();
    for i in (0..15).filter(|i| registers & (1 << i) != 0) {
        loaded.push((i, Family::load(e, address, Size::Word, Attributes::ALIGNED)));
        address = e.b.ins().iadd_imm_s(address, 4);
    }
    for (i, value) in loaded {
        let i = e.constant(i);
        e.call(set_user_register as *const () as usize, &[i, value]);
    }
}

/// `STM` with `^`, B9.3.17: User mode's registers, from any mode, and the PC as `PCStoreValue()`.
/// Its `W` is a `(0)` bit, so it never writes back.
fn store_user_registers(e: &mut Emitter<'_, '_, Family>, n: u32, registers: u32, step: Step) {
    let base = e.reg(n);
    let (mut address, _) = memory::span(e, base, 4 * registers.count_ones(), step);
    for i in (0..16).filter(|i| registers & (1 << i) != 0) {
        let value = if i == 15 {
            e.reg(15)
        } else {
            let i = e.constant(i);
            e.call(user_register as *const () as usize, &[i])
        };
        Family::store(e, address, value, Size::Word, Attributes::ALIGNED);
        address = e.b.ins().iadd_imm_s(address, 4);
    }
}

/// B9.3.17's `Rmode[n, '10000']`: User mode's `R[n]`, for `n` below 15.
extern "C" fn user_register(core: &mut Family, n: u32) -> u32 {
    core.state
        .reg_of(Mode::User, usize::try_from(n).expect("a register"))
}

/// B9.3.6's `Rmode[n, '10000'] = value`, for `n` below 15. A call answers a value, and this one's
/// is always 0.
extern "C" fn set_user_register(core: &mut Family, n: u32, value: u32) -> u32 {
    core.state
        .set_reg_of(Mode::User, usize::try_from(n).expect("a register"), value);
    0
}

#[cfg(test)]
mod tests {
    use super::super::super::exception::Exception;
    use super::super::super::registers::cpsr;
    use super::super::super::state::Mode;
    use super::super::testing::{Bench, RAM, SPUN};
    use crate::cpu::armv7::registers::mask;
    use crate::cpu::armv7::translate::ALWAYS;
    use crate::soc::Endian;

    const BOTH: [Endian; 2] = [Endian::Little, Endian::Big];
    /// Where the tests' data is. RAM around it holds each word's own address, so a word loaded
    /// says where it was loaded from.
    const BASE: u32 = RAM + 0x100;

    /// `P` and `U` for each way a block transfer walks, A8.8.57 to A8.8.61 and A8.8.199 to
    /// A8.8.202.
    const IA: u32 = 0b01;
    const IB: u32 = 0b11;
    const DA: u32 = 0b00;
    const DB: u32 = 0b10;

    /// Table A5-21's layout for a block transfer, walking `step`, with `S`, `W` and `L`.
    fn multiple(step: u32, [s, w, l]: [u32; 3], rn: u32, list: u32) -> u32 {
        ALWAYS << 28 | 0b100 << 25 | step << 23 | s << 22 | w << 21 | l << 20 | rn << 16 | list
    }

    const STM: [u32; 3] = [0, 0, 0];
    const STM_WB: [u32; 3] = [0, 1, 0];
    const LDM: [u32; 3] = [0, 0, 1];
    const LDM_WB: [u32; 3] = [0, 1, 1];
    const STM_USER: [u32; 3] = [1, 0, 0];
    const LDM_USER: [u32; 3] = [1, 0, 1];
    const LDM_RETURN_WB: [u32; 3] = [1, 1, 1];

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
            .flat_map(|at| match endian {
                Endian::Little => at.to_le_bytes(),
                Endian::Big => at.to_be_bytes(),
            })
            .collect();
        bench.write(BASE - 0x40, &filled);
        prepare(&mut bench);
        bench
    }

    /// [`ready`], with `count` instructions run, each retiring.
    fn after(endian: Endian, code: &[u32], count: u32, prepare: impl FnOnce(&mut Bench)) -> Bench {
        let mut bench = ready(endian, code, prepare);
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

    /// A8.8.18 and A8.8.25: `B` and `BL` branch to the PC, the address plus 8, and the offset,
    /// either way, and `BL` leaves the address after it in LR. A branch whose condition fails
    /// writes nothing and goes on.
    #[test]
    fn b_and_bl_branch_from_the_pc_plus_8() {
        for (at, word, pc, lr) in [
            (0x40, 0xEA00_0002, 0x50, 0xDEAD), // B . + 0x10
            (0x40, 0xEAFF_FFF2, 0x10, 0xDEAD), // B . - 0x30
            (0x40, 0xEB00_0006, 0x60, 0x44),   // BL . + 0x20
            (0x40, 0xEBFF_FFEE, 0, 0x44),      // BL . - 0x40
            (0x40, 0xEAFF_FFFE, 0x40, 0xDEAD), // B .
            (0x40, 0x1B00_0006, 0x44, 0xDEAD), // BLNE . + 0x20, with Z set
        ] {
            let mut bench = Bench::arm(Endian::Big, &[]);
            bench.place_arm(at, &[word]);
            let state = &mut bench.core.state;
            (state.r[14], state.r[15], state.z) = (0xDEAD, at, 1);
            assert_eq!(bench.run(1).1, 1, "{word:#010x}");
            let state = &bench.core.state;
            assert_eq!((state.r[15], state.r[14]), (pc, lr), "{word:#010x}");
        }
    }

    /// A8.8.58 to A8.8.61 and A8.8.199 to A8.8.202: the four ways a block transfer walks, the
    /// lowest register at the lowest address, and the writeback each gives.
    #[test]
    fn ldm_and_stm_walk_each_way_from_the_base() {
        for (step, first, written) in [
            (IA, BASE, BASE + 12),
            (IB, BASE + 4, BASE + 12),
            (DA, BASE - 8, BASE - 12),
            (DB, BASE - 12, BASE - 12),
        ] {
            for endian in BOTH {
                let list = 1 << 1 | 1 << 2 | 1 << 7;
                let code = [
                    multiple(step, LDM_WB, 0, list),
                    multiple(step, STM, 3, list),
                ];
                let registers = [(0, BASE), (3, BASE + 0x20)];
                let bench = after(endian, &code, 2, with(&registers));
                let state = &bench.core.state;
                let loaded = [state.r[1], state.r[2], state.r[7], state.r[0]];
                assert_eq!(loaded, [first, first + 4, first + 8, written], "{step:02b}");
                let at = first + 0x20;
                let stored = [0, 4, 8].map(|k| word_at(&bench, endian, at + k));
                assert_eq!(
                    stored,
                    [first, first + 4, first + 8],
                    "{step:02b} {endian:?}"
                );
                let bench = after(
                    endian,
                    &[multiple(step, STM_WB, 0, 1 << 4)],
                    1,
                    with(&registers),
                );
                let one = if step & 1 == 1 { 4 } else { -4_i32 }.cast_unsigned();
                assert_eq!(bench.core.state.r[0], BASE.wrapping_add(one), "{step:02b}");
            }
        }
    }

    /// A8.8.133 and A8.8.132: `PUSH` and `POP` are `STMDB` and `LDM` on the SP with writeback, and
    /// `POP` to the PC is `LoadWritePC()`, which interworks, A2.3.2.
    #[test]
    fn push_and_pop_go_through_the_sp() {
        let push = 0xE92D_4010; // PUSH {r4, lr}
        let pop = 0xE8BD_8010; // POP {r4, pc}
        assert_eq!(push, multiple(DB, STM_WB, 13, 1 << 4 | 1 << 14));
        assert_eq!(pop, multiple(IA, LDM_WB, 13, 1 << 4 | 1 << 15));
        for endian in BOTH {
            let registers = [(4, 0x44), (13, BASE), (14, 0x201)];
            let mut bench = after(endian, &[push], 1, with(&registers));
            assert_eq!(bench.core.state.r[13], BASE - 8);
            let pushed = [
                word_at(&bench, endian, BASE - 8),
                word_at(&bench, endian, BASE - 4),
            ];
            assert_eq!(pushed, [0x44, 0x201], "{endian:?}");
            bench.place_arm(4, &[pop]);
            bench.core.state.r[4] = 0;
            assert_eq!(bench.run(1).1, 1);
            let state = &bench.core.state;
            assert_eq!(
                (state.r[4], state.r[13], state.r[15], state.t),
                (0x44, BASE, 0x200, 1),
                "{endian:?}"
            );
        }
    }

    /// A8.8.199: an `STM` of the PC stores `PCStoreValue()`, the address plus 8, A2.3.2, and an
    /// `LDM` of it branches to the word loaded, after its writeback, in ARM state with bit 0
    /// clear.
    #[test]
    fn the_pc_in_a_list_stores_the_address_plus_8_and_loads_a_branch() {
        for endian in BOTH {
            let code = [
                multiple(IA, STM, 0, 1 << 1 | 1 << 15),
                multiple(IB, LDM_WB, 0, 1 << 15),
            ];
            let bench = after(endian, &code, 2, with(&[(0, BASE), (1, 0x11)]));
            let stored = [
                word_at(&bench, endian, BASE),
                word_at(&bench, endian, BASE + 4),
            ];
            assert_eq!(stored, [0x11, 8], "{endian:?}");
            let state = &bench.core.state;
            assert_eq!(
                (state.r[15], state.t, state.r[0]),
                (8, 0, BASE + 4),
                "{endian:?}"
            );
        }
    }

    /// The choices A8.8.58 and A8.8.199 make UNPREDICTABLE run the pseudocode: a base in its own
    /// list keeps what it loaded, a base stored after a lower register stores its old value, which
    /// A8.8.199's UNKNOWN allows, a base of the PC reads as the address plus 8, and a list of none
    /// transfers nothing. A writeback to the PC is UNDEFINED.
    #[test]
    fn unpredictable_block_transfers_run_the_pseudocode() {
        let code = [
            multiple(IA, LDM_WB, 0, 1 << 0 | 1 << 1),
            multiple(IA, STM_WB, 3, 1 << 2 | 1 << 3),
            multiple(DB, LDM, 15, 1 << 5),
            multiple(IA, STM_WB, 6, 0),
        ];
        for endian in BOTH {
            let registers = [(0, BASE), (2, 0x22), (3, BASE + 0x20), (6, BASE)];
            let bench = after(endian, &code, 4, with(&registers));
            let state = &bench.core.state;
            assert_eq!(state.r[..2], [BASE, BASE + 4], "{endian:?}");
            let stored = [0, 4].map(|k| word_at(&bench, endian, BASE + 0x20 + k));
            assert_eq!(stored, [0x22, BASE + 0x20], "{endian:?}");
            assert_eq!(state.r[3], BASE + 0x28, "{endian:?}");
            assert_eq!(state.r[5], code[3], "{endian:?}: from 8 + 8 - 4");
            assert_eq!(state.r[6], BASE, "{endian:?}");
        }
        for word in [multiple(IA, STM_WB, 15, 1), multiple(IA, LDM_WB, 15, 1)] {
            let mut bench = Bench::arm(Endian::Little, &[word]);
            assert_eq!(bench.run(1).1, SPUN, "{word:#010x}");
            assert_eq!(bench.raised(), Some((Exception::Undefined, 0)));
        }
    }

    /// B9.3.6 and B9.3.17: with `^` and no PC to load, `LDM` and `STM` reach User mode's
    /// registers from FIQ mode, leaving FIQ mode's own alone, and never write back. `STM` stores
    /// the PC as `PCStoreValue()`.
    #[test]
    fn ldm_and_stm_with_the_user_registers_reach_them_from_fiq_mode() {
        let list = 1 << 1 | 1 << 8 | 1 << 13 | 1 << 14;
        let code = [
            multiple(IA, STM_USER, 0, list | 1 << 15),
            multiple(DB, [1, 1, 1], 2, list),
        ];
        for endian in BOTH {
            let bench = after(endian, &code, 2, |bench| {
                bench
                    .core
                    .cpsr_write_by_instr(Mode::Fiq as u32, 0b0001, false);
                let state = &mut bench.core.state;
                for n in [8, 13, 14] {
                    state.set_reg_of(Mode::User, n, 0x100 + u32::try_from(n).unwrap());
                    state.r[n] = 0xF00 + u32::try_from(n).unwrap();
                }
                (state.r[0], state.r[1], state.r[2]) = (BASE + 0x20, 0x11, BASE);
            });
            let stored = [0, 4, 8, 12, 16].map(|k| word_at(&bench, endian, BASE + 0x20 + k));
            assert_eq!(stored, [0x11, 0x108, 0x10D, 0x10E, 8], "{endian:?}");
            let state = &bench.core.state;
            assert_eq!(state.r[1], BASE - 16, "{endian:?}: R1 is no mode's own");
            let user = [8, 13, 14].map(|n| state.reg_of(Mode::User, n));
            assert_eq!(user, [BASE - 12, BASE - 8, BASE - 4], "{endian:?}");
            assert_eq!(
                state.r[8..15],
                [0xF08, 0, 0, 0, 0, 0xF0D, 0xF0E],
                "{endian:?}"
            );
            assert_eq!(state.r[2], BASE, "{endian:?}: no writeback");
        }
    }

    /// A User register `LDM` writes has its new value for the next instruction of the block, in a
    /// mode that shares it.
    #[test]
    fn a_user_register_loaded_is_current_for_the_next_instruction() {
        let code = [multiple(IA, LDM_USER, 0, 1 << 8), 0xE1A0_1008]; // MOV r1, r8
        let bench = after(Endian::Little, &code, 2, with(&[(0, BASE + 4)]));
        assert_eq!(bench.core.state.r[..2], [BASE + 4, BASE + 4]);
        assert_eq!(bench.core.state.r[8], BASE + 4);
    }

    /// B9.3.5: `LDM` with the PC and `^` loads the other registers in the current mode, writes
    /// back, and then returns from the exception, restoring the SPSR as the CPSR and branching to
    /// the word loaded for the PC, aligned for the instruction set it returns to.
    #[test]
    fn ldm_with_the_pc_and_s_returns_from_an_exception() {
        let thumb_user = mask(cpsr::T) | mask(cpsr::C) | Mode::User as u32;
        for (word, spsr, pc, sp) in [
            (
                multiple(IA, LDM_RETURN_WB, 13, 1 << 0 | 1 << 15),
                thumb_user,
                BASE + 4,
                BASE + 8,
            ),
            (
                multiple(DA, [1, 0, 1], 13, 1 << 0 | 1 << 15),
                Mode::Irq as u32,
                BASE,
                BASE,
            ),
        ] {
            for endian in BOTH {
                let bench = after(endian, &[word], 1, |bench| {
                    let state = &mut bench.core.state;
                    state.r[13] = BASE;
                    assert!(state.set_spsr(spsr));
                });
                let mut state = bench.core.state.clone();
                assert_eq!(state.cpsr(), spsr, "{word:#010x} {endian:?}");
                let first = if word & 1 << 23 == 0 { BASE - 4 } else { BASE };
                assert_eq!(
                    (state.r[0], state.r[15]),
                    (first, pc),
                    "{word:#010x} {endian:?}"
                );
                state.set_mode(Mode::Supervisor);
                assert_eq!(state.r[13], sp, "{word:#010x} {endian:?}");
            }
        }
    }

    /// B9.1.1: an exception return in User mode or System mode, which have no SPSR, is
    /// UNPREDICTABLE. It keeps the CPSR and only branches.
    #[test]
    fn an_ldm_exception_return_without_an_spsr_only_branches() {
        let word = multiple(IA, LDM_RETURN_WB, 13, 1 << 15);
        for mode in [Mode::User, Mode::System] {
            let bench = after(Endian::Big, &[word], 1, |bench| {
                bench.core.cpsr_write_by_instr(mode as u32, 0b0001, false);
                bench.core.state.r[13] = BASE;
            });
            let state = &bench.core.state;
            assert_eq!(
                (state.mode(), state.r[15], state.r[13]),
                (mode, BASE, BASE + 4)
            );
        }
    }

    /// B9.3.6 and B9.3.17: the User register forms are UNPREDICTABLE in User mode and System mode,
    /// whose own registers are the User registers, so they reach those.
    #[test]
    fn the_user_registers_are_the_current_ones_in_user_and_system_mode() {
        let code = [
            multiple(IA, STM_USER, 0, 1 << 13 | 1 << 14),
            multiple(IA, LDM_USER, 1, 1 << 13),
        ];
        for mode in [Mode::User, Mode::System] {
            for endian in BOTH {
                let bench = after(endian, &code, 2, |bench| {
                    bench.core.cpsr_write_by_instr(mode as u32, 0b0001, false);
                    with(&[(0, BASE + 0x20), (1, BASE), (13, 0x1D), (14, 0x1E)])(bench);
                });
                let stored = [0, 4].map(|k| word_at(&bench, endian, BASE + 0x20 + k));
                assert_eq!(stored, [0x1D, 0x1E], "{mode:?} {endian:?}");
                assert_eq!(bench.core.state.r[13], BASE, "{mode:?} {endian:?}");
            }
        }
    }
}
