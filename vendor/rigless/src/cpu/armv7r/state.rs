// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The processor's state an instruction reads and writes, laid out for generated code to reach at
//! fixed offsets, DDI 0406C B1.3.

use serde::{Deserialize, Serialize};

use super::exception::FOR_EVENT;
use super::registers::cpsr;
use crate::cpu::armv7::registers::{get, set};

/// A processor mode the R profile has, Table B1-1. Without the Security Extensions and the
/// Virtualization Extensions there's no Monitor mode and no Hyp mode, so B1.3.1's `BadMode()` is
/// true of their encodings too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub(crate) enum Mode {
    User = 0b10000,
    Fiq = 0b10001,
    Irq = 0b10010,
    Supervisor = 0b10011,
    Abort = 0b10111,
    Undefined = 0b11011,
    System = 0b11111,
}

/// The banks of R13 and R14, one for each mode with its own, and User mode's, which System mode
/// shares, B1.3.2.
const BANKS: usize = 6;
/// The modes with an SPSR, every one an exception is taken to, B1.3.3.
const SPSRS: usize = 5;
/// The bank R8 to R12 come from in every mode but FIQ mode, and the bank of R13 and R14 User mode
/// and System mode share.
const USER: usize = 0;
/// The bank FIQ mode's own R8 to R12 come from.
const FIQ: usize = 1;
/// The first register FIQ mode banks, R8, B1.3.2.
const FIRST_FIQ_REGISTER: usize = 8;
/// The stack pointer, the first register every exception mode banks.
const SP: usize = 13;

impl Mode {
    /// The mode `bits` encode, or `None` where `BadMode()` is true, B1.3.1.
    pub(crate) fn from_bits(bits: u32) -> Option<Self> {
        Some(match bits {
            0b10000 => Self::User,
            0b10001 => Self::Fiq,
            0b10010 => Self::Irq,
            0b10011 => Self::Supervisor,
            0b10111 => Self::Abort,
            0b11011 => Self::Undefined,
            0b11111 => Self::System,
            _ => return None,
        })
    }

    /// Which bank of R13 and R14 it reads, B1.3.2's `RBankSelect()`.
    fn bank(self) -> usize {
        match self {
            Self::User | Self::System => USER,
            Self::Fiq => FIQ,
            Self::Irq => 2,
            Self::Supervisor => 3,
            Self::Abort => 4,
            Self::Undefined => 5,
        }
    }

    /// Which bank of R8 to R12 it reads, B1.3.2's `RfiqBankSelect()`.
    fn high_bank(self) -> usize {
        if self == Self::Fiq { FIQ } else { USER }
    }
}

/// A mode an exception is taken to, each with an SPSR of its own, B1.3.3. User mode and System mode
/// have none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ExceptionMode {
    Fiq,
    Irq,
    Supervisor,
    Abort,
    Undefined,
}

impl ExceptionMode {
    /// `mode`, or `None` for User mode and System mode, which have no SPSR, B1.3.3's `SPSR[]`.
    pub(crate) fn of(mode: Mode) -> Option<Self> {
        Some(match mode {
            Mode::User | Mode::System => return None,
            Mode::Fiq => Self::Fiq,
            Mode::Irq => Self::Irq,
            Mode::Supervisor => Self::Supervisor,
            Mode::Abort => Self::Abort,
            Mode::Undefined => Self::Undefined,
        })
    }
}

/// Every register and flag of one ARMv7-R processor, and its state between instructions.
///
/// Every field is a plain integer, since generated code reads and writes them at their offsets.
/// Each flag is a word of its own holding 0 or 1, so generated code loads and stores it whole. The
/// CPSR is assembled from them when something reads it whole. `r` is the current mode's view of
/// the registers, and every other mode's banked registers wait in `banked_high` and
/// `banked_sp_lr` until a change of mode swaps them in, B1.3.2.
#[repr(C)]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct State {
    /// `R0` to `R15` as the current mode sees them. `r[15]` is the address of the next
    /// instruction, which is only kept here between blocks.
    pub(crate) r: [u32; 16],
    /// `CPSR.N`, `Z`, `C`, `V` and `Q`, each 0 or 1.
    pub(crate) n: u32,
    pub(crate) z: u32,
    pub(crate) c: u32,
    pub(crate) v: u32,
    pub(crate) q: u32,
    /// `CPSR.GE`, in its low four bits.
    pub(crate) ge: u32,
    /// `ITSTATE`, its eight bits as A2.5.2 lays them out.
    pub(crate) it: u32,
    /// `CPSR.T`, 1 in Thumb state and 0 in ARM state, A2.5.1.
    pub(crate) t: u32,
    /// `CPSR.E`, 1 when data is big-endian, A2.5.3.
    pub(crate) e: u32,
    /// `CPSR.A`, `I` and `F`, each 1 while it masks its exception, B1.3.3.
    pub(crate) a: u32,
    pub(crate) i: u32,
    pub(crate) f: u32,
    /// `CPSR.M`, a mode's bits, which only [`State::set_mode`] writes. [`State::mode`] reads it.
    pub(crate) mode: u32,
    /// R8 to R12 of User mode, which every mode but FIQ mode reads, and of FIQ mode, as each was
    /// when a change of mode last swapped it out.
    pub(crate) banked_high: [[u32; 5]; 2],
    /// R13 and R14 of each bank, as each was when a change of mode last swapped it out.
    pub(crate) banked_sp_lr: [[u32; 2]; BANKS],
    /// `SPSR_fiq`, `SPSR_irq`, `SPSR_svc`, `SPSR_abt` and `SPSR_und`.
    pub(crate) spsr: [u32; SPSRS],
    /// `D0` to `D15` of the floating-point extension, as the single registers `S0` to `S31` they
    /// hold, A2.6.1.
    pub(crate) s: [u32; 32],
    pub(crate) fpscr: u32,
    pub(crate) fpexc: u32,
    /// Whether the local exclusive monitor is in the Exclusive Access state, A3.4.
    pub(crate) exclusive_valid: u32,
    /// What the processor waits for: 0 for nothing, or `exception`'s `FOR_INTERRUPT` after `WFI`
    /// or `FOR_EVENT` after `WFE`.
    pub(crate) sleeping: u32,
    /// The event register, B1.8.13.
    pub(crate) event: u32,
}

impl Default for State {
    /// What B1.9.1's `TakeReset()` leaves: Supervisor mode with every asynchronous exception
    /// masked, no IT block, and ARM state and little-endian data where `SCTLR.TE` and `SCTLR.EE`
    /// are clear. Everything else is UNKNOWN, which is zero here.
    fn default() -> Self {
        Self {
            r: [0; 16],
            n: 0,
            z: 0,
            c: 0,
            v: 0,
            q: 0,
            ge: 0,
            it: 0,
            t: 0,
            e: 0,
            a: 1,
            i: 1,
            f: 1,
            mode: Mode::Supervisor as u32,
            banked_high: [[0; 5]; 2],
            banked_sp_lr: [[0; 2]; BANKS],
            spsr: [0; SPSRS],
            s: [0; 32],
            fpscr: 0,
            fpexc: 0,
            exclusive_valid: 0,
            sleeping: 0,
            event: 0,
        }
    }
}

impl State {
    /// The CPSR, B1.3.3.
    pub(crate) fn cpsr(&self) -> u32 {
        let it = self.it;
        set(cpsr::N, 0, self.n)
            | set(cpsr::Z, 0, self.z)
            | set(cpsr::C, 0, self.c)
            | set(cpsr::V, 0, self.v)
            | set(cpsr::Q, 0, self.q)
            | set(cpsr::IT_1_0, 0, it)
            | set(cpsr::GE, 0, self.ge)
            | set(cpsr::IT_7_2, 0, it >> cpsr::IT_1_0.width)
            | set(cpsr::E, 0, self.e)
            | set(cpsr::A, 0, self.a)
            | set(cpsr::I, 0, self.i)
            | set(cpsr::F, 0, self.f)
            | set(cpsr::T, 0, self.t)
            | set(cpsr::M, 0, self.mode)
    }

    /// Sets every field the CPSR holds from `value`, swapping in the banked registers of the mode
    /// it names. A mode `BadMode()` refuses leaves the mode as it was, B1.3.3.
    pub(crate) fn set_cpsr(&mut self, value: u32) {
        self.n = get(cpsr::N, value);
        self.z = get(cpsr::Z, value);
        self.c = get(cpsr::C, value);
        self.v = get(cpsr::V, value);
        self.q = get(cpsr::Q, value);
        self.it = get(cpsr::IT_1_0, value) | get(cpsr::IT_7_2, value) << cpsr::IT_1_0.width;
        self.ge = get(cpsr::GE, value);
        self.e = get(cpsr::E, value);
        self.a = get(cpsr::A, value);
        self.i = get(cpsr::I, value);
        self.f = get(cpsr::F, value);
        self.t = get(cpsr::T, value);
        if let Some(mode) = Mode::from_bits(get(cpsr::M, value)) {
            self.set_mode(mode);
        }
    }

    /// Whether every field holds a value the processor could: each flag 0 or 1, four bits of
    /// `GE` and eight of `ITSTATE`, a wait the core makes, and a mode `BadMode()` accepts. A saved state is refused unless
    /// it does.
    pub(crate) fn consistent(&self) -> bool {
        let flags = [
            self.n,
            self.z,
            self.c,
            self.v,
            self.q,
            self.t,
            self.e,
            self.a,
            self.i,
            self.f,
            self.exclusive_valid,
            self.event,
        ];
        flags.iter().all(|&flag| flag <= 1)
            && self.sleeping <= FOR_EVENT
            && self.ge <= 0xF
            && self.it <= 0xFF
            && Mode::from_bits(self.mode).is_some()
    }

    /// Whether software runs at PL1 now, B1.3.1's `CurrentModeIsNotUser()`.
    pub(crate) fn privileged(&self) -> bool {
        self.mode() != Mode::User
    }

    /// The current mode.
    pub(crate) fn mode(&self) -> Mode {
        Mode::from_bits(self.mode)
            .expect("set_mode writes only a mode BadMode() accepts, and a load refuses any other")
    }

    /// Changes the mode to `mode`, swapping in its banked registers and swapping out the old
    /// mode's, B1.3.2.
    pub(crate) fn set_mode(&mut self, mode: Mode) {
        let old = self.mode();
        if old.high_bank() != mode.high_bank() {
            let high = FIRST_FIQ_REGISTER..SP;
            self.banked_high[old.high_bank()].copy_from_slice(&self.r[high.clone()]);
            self.r[high].copy_from_slice(&self.banked_high[mode.high_bank()]);
        }
        if old.bank() != mode.bank() {
            let sp_lr = SP..15;
            self.banked_sp_lr[old.bank()].copy_from_slice(&self.r[sp_lr.clone()]);
            self.r[sp_lr].copy_from_slice(&self.banked_sp_lr[mode.bank()]);
        }
        self.mode = mode as u32;
    }

    /// `mode`'s `R[n]` from any mode, for `n` below 15: User mode's as `LDM` and `STM` with the
    /// User registers read it, B9.3.6 and B9.3.17, and any mode's for a debugger.
    pub(crate) fn reg_of(&self, mode: Mode, n: usize) -> u32 {
        match self.bank_of(mode, n) {
            Some(Waiting::High(bank, at)) => self.banked_high[bank][at],
            Some(Waiting::SpLr(bank, at)) => self.banked_sp_lr[bank][at],
            None => self.r[n],
        }
    }

    /// Writes `mode`'s `R[n]` from any mode, for `n` below 15.
    pub(crate) fn set_reg_of(&mut self, mode: Mode, n: usize, value: u32) {
        match self.bank_of(mode, n) {
            Some(Waiting::High(bank, at)) => self.banked_high[bank][at] = value,
            Some(Waiting::SpLr(bank, at)) => self.banked_sp_lr[bank][at] = value,
            None => self.r[n] = value,
        }
    }

    /// Where `mode`'s `R[n]` waits while the current mode reads a bank of its own, or `None`
    /// where the current mode reads `mode`'s.
    fn bank_of(&self, mode: Mode, n: usize) -> Option<Waiting> {
        assert!(n < 15, "the PC isn't banked");
        let current = self.mode();
        if (FIRST_FIQ_REGISTER..SP).contains(&n) && current.high_bank() != mode.high_bank() {
            return Some(Waiting::High(mode.high_bank(), n - FIRST_FIQ_REGISTER));
        }
        if n >= SP && current.bank() != mode.bank() {
            return Some(Waiting::SpLr(mode.bank(), n - SP));
        }
        None
    }

    /// `mode`'s SPSR from any mode.
    pub(crate) fn spsr_of(&self, mode: ExceptionMode) -> u32 {
        self.spsr[mode as usize]
    }

    /// Writes `mode`'s SPSR from any mode.
    pub(crate) fn set_spsr_of(&mut self, mode: ExceptionMode, value: u32) {
        self.spsr[mode as usize] = value;
    }

    /// The current mode's SPSR, or `None` in User mode and System mode, where B1.3.3's `SPSR[]` is
    /// UNPREDICTABLE.
    pub(crate) fn spsr(&self) -> Option<u32> {
        ExceptionMode::of(self.mode()).map(|mode| self.spsr_of(mode))
    }

    /// Writes the current mode's SPSR, and answers whether it has one.
    pub(crate) fn set_spsr(&mut self, value: u32) -> bool {
        let Some(mode) = ExceptionMode::of(self.mode()) else {
            return false;
        };
        self.set_spsr_of(mode, value);
        true
    }
}

/// Where a banked register waits: R8 to R12 in `banked_high`, or R13 and R14 in `banked_sp_lr`,
/// each by its bank and its index there.
enum Waiting {
    High(usize, usize),
    SpLr(usize, usize),
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every mode's registers, filled so each register of each bank holds a value of its own.
    fn banked() -> State {
        let mut state = State::default();
        for mode in [
            Mode::User,
            Mode::Fiq,
            Mode::Irq,
            Mode::Supervisor,
            Mode::Abort,
            Mode::Undefined,
        ] {
            state.set_mode(mode);
            // Every mode but FIQ mode reads User mode's R8 to R12.
            let first = if matches!(mode, Mode::User | Mode::Fiq) {
                FIRST_FIQ_REGISTER
            } else {
                SP
            };
            for n in first..15 {
                state.r[n] = mode as u32 * 0x100 + u32::try_from(n).unwrap();
            }
        }
        state
    }

    /// B1.3.2, Figure B1-2: FIQ mode has R8 to R14 of its own, every other exception mode R13 and
    /// R14, and System mode shares User mode's.
    #[test]
    fn a_change_of_mode_swaps_in_its_banked_registers() {
        let mut state = banked();
        let user = |n: u32| Mode::User as u32 * 0x100 + n;
        for (mode, high, sp_lr) in [
            (Mode::Fiq, Mode::Fiq, Mode::Fiq),
            (Mode::Irq, Mode::User, Mode::Irq),
            (Mode::System, Mode::User, Mode::User),
            (Mode::Supervisor, Mode::User, Mode::Supervisor),
            (Mode::User, Mode::User, Mode::User),
        ] {
            state.set_mode(mode);
            let expected: Vec<u32> = (8..13)
                .map(|n| high as u32 * 0x100 + n)
                .chain((13..15).map(|n| sp_lr as u32 * 0x100 + n))
                .collect();
            assert_eq!(state.r[8..15], expected[..], "{mode:?}");
            assert_eq!(state.reg_of(Mode::User, 8), user(8), "{mode:?}");
            assert_eq!(state.reg_of(Mode::User, 14), user(14), "{mode:?}");
        }
    }

    /// B9.3.6 and B9.3.17: from FIQ mode the User registers are the ones it banked away, and a
    /// write to one lands there, leaving FIQ mode's own alone.
    #[test]
    fn the_user_registers_are_reached_from_any_mode() {
        let mut state = banked();
        state.set_mode(Mode::Fiq);
        state.set_reg_of(Mode::User, 9, 0x99);
        state.set_reg_of(Mode::User, 13, 0x1300);
        state.set_reg_of(Mode::User, 3, 0x33);
        assert_eq!(
            (state.r[9], state.r[13], state.r[3]),
            (
                Mode::Fiq as u32 * 0x100 + 9,
                Mode::Fiq as u32 * 0x100 + 13,
                0x33
            )
        );
        state.set_mode(Mode::User);
        assert_eq!((state.r[9], state.r[13]), (0x99, 0x1300));
    }

    /// B1.3.3: each exception mode has an SPSR of its own, and User mode and System mode none.
    #[test]
    fn every_exception_mode_has_an_spsr_of_its_own() {
        let mut state = State::default();
        let modes = [
            Mode::Fiq,
            Mode::Irq,
            Mode::Supervisor,
            Mode::Abort,
            Mode::Undefined,
        ];
        for (value, &mode) in (1..).zip(&modes) {
            state.set_mode(mode);
            assert!(state.set_spsr(value));
        }
        for (value, &mode) in (1..).zip(&modes) {
            state.set_mode(mode);
            assert_eq!(state.spsr(), Some(value), "{mode:?}");
        }
        for mode in [Mode::User, Mode::System] {
            state.set_mode(mode);
            assert!(!state.set_spsr(0));
            assert_eq!(state.spsr(), None, "{mode:?}");
        }
    }

    /// B1.3.3's layout: IT[1:0] at bits 26:25 and IT[7:2] at 15:10, and the mode in bits 4:0.
    #[test]
    fn the_cpsr_holds_every_field_where_the_manual_puts_it() {
        let mut state = State {
            n: 1,
            z: 0,
            c: 1,
            v: 0,
            q: 1,
            ge: 0b1010,
            it: 0b1100_0110,
            t: 1,
            e: 1,
            a: 0,
            i: 1,
            f: 0,
            ..State::default()
        };
        state.set_mode(Mode::Irq);
        assert_eq!(state.cpsr(), 0xAC0A_C6B2);
        assert!(state.privileged());
        state.set_mode(Mode::User);
        assert!(!state.privileged());
    }

    /// B1.3.1: Monitor mode and Hyp mode are bad modes on the R profile, as is every encoding
    /// Table B1-1 doesn't list.
    #[test]
    fn only_the_modes_the_r_profile_has_decode() {
        let modes: Vec<u32> = (0..32)
            .filter(|&bits| Mode::from_bits(bits).is_some())
            .collect();
        assert_eq!(
            modes,
            [
                0b10000, 0b10001, 0b10010, 0b10011, 0b10111, 0b11011, 0b11111
            ]
        );
        for bits in modes {
            assert_eq!(Mode::from_bits(bits).map(|mode| mode as u32), Some(bits));
        }
    }
}
