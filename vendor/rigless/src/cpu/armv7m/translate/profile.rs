// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The ARMv7-M family's [`Profile`]: where [`Family`] keeps what a block reads and writes, and the
//! parts of an instruction this profile does its own way. A load or store the page table misses
//! calls into the family, a fault and an exception return are the family's exception model, an
//! exit chains to the next block by its address and `ITSTATE`, a floating-point instruction starts
//! with B1.6.3's `ExecuteFPCheck()`, and a divide by zero traps by `CCR.DIV_0_TRP`.

use std::mem::offset_of;

use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value, condcodes::IntCC, types};

use super::super::family::{Family, Position, helpers, offsets};
use super::super::registers::{ccr, control, cpacr, exc_return, fpccr};
use super::super::state::State;
use super::LONGEST_BLOCK;
use crate::cpu::armv7::fp;
use crate::cpu::armv7::registers::{is_set, mask};
use crate::cpu::armv7::translate::{
    Attributes, Emitter, FAULTED, FIND, Fault, KEEP_PC, Profile, Size, status,
};
use crate::emulator::core::{Lookup, Place, emit_find, emit_lookup, load_guest, store_guest};

impl Profile for Family {
    const STATE: usize = offsets::STATE;
    const BUDGET: i32 = offsets::BUDGET;
    const RETURNING: i32 = offsets::RETURNING;
    const R: usize = offset_of!(State, r);
    const N: usize = offset_of!(State, n);
    const Z: usize = offset_of!(State, z);
    const C: usize = offset_of!(State, c);
    const V: usize = offset_of!(State, v);
    const Q: usize = offset_of!(State, q);
    const GE: usize = offset_of!(State, ge);
    const S: usize = offset_of!(State, s);
    const FPSCR: usize = offset_of!(State, fpscr);
    const MONITOR: usize = offset_of!(State, exclusive_valid);
    const ALIGNS_SP: bool = true;

    /// Loads `size` bytes at `address`, zero-extended to an `i32`, A3.2. A fault leaves the block
    /// as if the instruction hadn't run, so an instruction loads before it writes a register.
    fn load(
        e: &mut Emitter<'_, '_, Self>,
        address: Value,
        size: Size,
        attributes: Attributes,
    ) -> Value {
        e.accessed = true;
        let slow = e.b.create_block();
        e.b.set_cold_block(slow);
        let join = e.b.create_block();
        e.b.append_block_param(join, types::I32);
        if attributes.unprivileged {
            // A page may be inline for privileged software alone.
            e.b.ins().jump(slow, &[]);
        } else {
            let table = table(e);
            let host = emit_lookup(e.b, table, address, Lookup::Read(size.bytes()), slow);
            // A3.3.1: the core's data order.
            let value = load_guest(e.b, size.host(), host, e.features.endian);
            let value = if size == Size::Word {
                value
            } else {
                e.b.ins().uextend(types::I32, value)
            };
            e.b.ins().jump(join, &[value.into()]);
        }
        e.b.switch_to_block(slow);
        let size = e.constant(size.bytes());
        let attributes = e.constant(attributes.bits());
        let pc = e.constant(e.pc());
        let index = e.constant(e.index);
        let answer = e.call_helper(
            helpers::read as *const () as usize,
            &[address, size, attributes, pc, index],
            types::I64,
        );
        e.fault_unless(answer);
        let value = e.b.ins().ireduce(types::I32, answer);
        e.b.ins().jump(join, &[value.into()]);
        e.b.seal_block(join);
        e.b.switch_to_block(join);
        e.b.block_params(join)[0]
    }

    /// Stores the low `size` bytes of `value` at `address`, A3.2. A fault leaves the block as
    /// [`Profile::load`]'s does.
    fn store(
        e: &mut Emitter<'_, '_, Self>,
        address: Value,
        value: Value,
        size: Size,
        attributes: Attributes,
    ) {
        e.accessed = true;
        let slow = e.b.create_block();
        e.b.set_cold_block(slow);
        let join = e.b.create_block();
        if attributes.unprivileged {
            e.b.ins().jump(slow, &[]);
        } else {
            let table = table(e);
            let host = emit_lookup(e.b, table, address, Lookup::Write(size.bytes()), slow);
            let narrow = if size == Size::Word {
                value
            } else {
                e.b.ins().ireduce(size.host(), value)
            };
            store_guest(e.b, narrow, host, e.features.endian);
            e.b.ins().jump(join, &[]);
        }
        e.b.switch_to_block(slow);
        let size = e.constant(size.bytes());
        let attributes = e.constant(attributes.bits());
        let pc = e.constant(e.pc());
        let index = e.constant(e.index);
        let answer = e.call_helper(
            helpers::write as *const () as usize,
            &[address, value, size, attributes, pc, index],
            types::I64,
        );
        e.fault_unless(answer);
        e.b.ins().jump(join, &[]);
        e.b.seal_block(join);
        e.b.switch_to_block(join);
    }

    /// `BXWritePC(address)`, A2.3.1, which `LoadWritePC` is too: in Handler mode an address
    /// from `0xF000_0000` up is an exception return, and otherwise bit 0 is `EPSR.T` and the next
    /// instruction is at the rest. Ends the block.
    fn branch_exchange(e: &mut Emitter<'_, '_, Self>, address: Value) {
        let returning = e.b.ins().icmp_imm_s(
            IntCC::UnsignedGreaterThanOrEqual,
            address,
            i64::from(mask(exc_return::PREFIX).cast_signed()),
        );
        let ipsr = e.load_field(offset_of!(State, ipsr));
        let handler = e.b.ins().icmp_imm_s(IntCC::NotEqual, ipsr, 0);
        let returning = e.b.ins().band(returning, handler);
        let exception_return = e.b.create_block();
        let exchange = e.b.create_block();
        e.b.ins()
            .brif(returning, exception_return, &[], exchange, &[]);
        e.b.seal_block(exception_return);
        e.b.seal_block(exchange);
        e.b.switch_to_block(exception_return);
        e.exit_to(address, status::EXCEPTION_RETURN);
        e.b.switch_to_block(exchange);
        Self::blx_write_pc(e, address);
    }

    /// `BLXWritePC(address)`, A2.3.1: bit 0 is `EPSR.T` and the next instruction is at the rest,
    /// with no exception return. A target with bit 0 clear never chains, so the core takes the
    /// INVSTATE UsageFault on it. Ends the block.
    fn blx_write_pc(e: &mut Emitter<'_, '_, Self>, address: Value) {
        let thumb = e.b.ins().band_imm_s(address, 1);
        e.store_field(offset_of!(State, t), thumb);
        let target = e.b.ins().band_imm_s(address, !1);
        e.exit_to_computed(target, thumb);
    }

    /// Raises `fault` for this instruction: the processor takes its exception before the next
    /// instruction. An `SVC` retires first and returns past itself, unless it locked up, which
    /// makes it UNDEFINED, B1.5.15. Every other fault leaves as if the instruction hadn't run.
    /// Ends the block.
    fn raise(e: &mut Emitter<'_, '_, Self>, fault: Fault) {
        let code = e.constant(fault as u32);
        let pc = e.constant(e.pc());
        let locked_up = e.call_plain(helpers::raise as *const () as usize, &[code, pc]);
        if fault != Fault::SupervisorCall {
            e.exit_before(status::EXCEPTION);
            return;
        }
        let undefined = e.b.create_block();
        let retired = e.b.create_block();
        e.b.ins().brif(locked_up, undefined, &[], retired, &[]);
        e.b.seal_block(undefined);
        e.b.seal_block(retired);
        e.b.switch_to_block(undefined);
        e.exit_before(status::EXCEPTION);
        e.b.switch_to_block(retired);
        let next = e.constant(e.next_pc());
        e.exit_to(next, status::EXCEPTION);
    }

    /// Emits B1.6.3's `ExecuteFPCheck()`, or only `CheckVFPEnabled()` when not `execute`, leaving
    /// through a fault when it refuses.
    fn fp_check(e: &mut Emitter<'_, '_, Self>, execute: bool) {
        // Nothing a block runs between two checks changes what they check without ending the block,
        // so once one has passed, the next would find nothing to do.
        if e.fp_checked {
            return;
        }
        e.fp_checked = execute;
        // With CP10 granting full access, its every bit set, no lazy save outstanding and the
        // context already the floating point's, ExecuteFPCheck() does nothing at all, B1.6.3, so
        // nothing is called.
        let cp10 = i64::from(mask(cpacr::CP10));
        let cpacr = e.load_core(offsets::CPACR);
        let access = e.b.ins().band_imm_s(cpacr, cp10);
        let full = e.b.ins().icmp_imm_s(IntCC::Equal, access, cp10);
        let fpccr = e.load_core(offsets::FPCCR);
        let lazy = e.b.ins().band_imm_s(fpccr, i64::from(mask(fpccr::LSPACT)));
        let settled = e.b.ins().icmp_imm_s(IntCC::Equal, lazy, 0);
        let control = e.load_field(offset_of!(State, control));
        let context =
            e.b.ins()
                .band_imm_s(control, i64::from(mask(control::FPCA)));
        let owned = e.b.ins().icmp_imm_s(IntCC::NotEqual, context, 0);
        let ready = e.b.ins().band(full, settled);
        let ready = e.b.ins().band(ready, owned);
        let slow = e.b.create_block();
        e.b.set_cold_block(slow);
        let done = e.b.create_block();
        e.b.ins().brif(ready, done, &[], slow, &[]);
        e.b.seal_block(slow);
        e.b.switch_to_block(slow);
        // The lazy preservation's stores are this instruction's accesses.
        e.accessed = true;
        let execute = e.constant(u32::from(execute));
        let pc = e.constant(e.pc());
        let index = e.constant(e.index);
        let answer = e.call_helper(
            execute_fp_check as *const () as usize,
            &[execute, pc, index],
            types::I64,
        );
        e.fault_unless(answer);
        e.b.ins().jump(done, &[]);
        e.b.seal_block(done);
        e.b.switch_to_block(done);
    }

    /// A UsageFault with `UFSR.UNALIGNED`, which holds no address.
    fn raise_unaligned(
        e: &mut Emitter<'_, '_, Self>,
        misaligned: Value,
        _address: Value,
        _write: bool,
    ) {
        e.raise_if(misaligned, Fault::Unaligned);
    }

    fn divide_by_zero_traps(e: &mut Emitter<'_, '_, Self>) -> Value {
        e.call_plain(zero_divide_traps as *const () as usize, &[])
    }

    fn hand_over(
        e: &mut Emitter<'_, '_, Self>,
        pc: u32,
        it: u32,
        left: Value,
        cell: Place,
    ) -> bool {
        let Some(signature) = e.chain.as_ref().map(|chain| chain.signature) else {
            return false;
        };
        let pc = e.constant(pc);
        e.store_field(offset_of!(State, r) + 15 * 4, pc);
        let it = e.constant(it);
        e.store_field(offset_of!(State, it), it);
        let core = e.core();
        let trusted = MemFlagsData::trusted();
        e.b.ins().store(trusted, left, core, offsets::BUDGET);
        let cell = cell.emit(e.b, e.pointer);
        let next = e.b.ins().load(e.pointer, trusted, cell, 0);
        let returning =
            e.b.ins()
                .load(types::I32, trusted, core, offsets::RETURNING);
        let [free, linked, unlinked] = std::array::from_fn(|_| e.b.create_block());
        e.b.set_cold_block(unlinked);
        e.b.ins().brif(returning, unlinked, &[], free, &[]);
        e.b.seal_block(free);
        e.b.switch_to_block(free);
        e.b.ins().brif(next, linked, &[], unlinked, &[]);
        e.b.seal_block(linked);
        e.b.seal_block(unlinked);
        e.b.switch_to_block(linked);
        e.b.ins().return_call_indirect(signature, next, &[core]);
        e.b.switch_to_block(unlinked);
        e.b.ins().store(trusted, cell, core, offsets::LINK);
        let answer = e.constant(status::NEXT);
        e.b.ins().return_(&[answer]);
        true
    }

    fn fp_registers(core: &mut Self) -> (&mut [u32; 32], &mut u32) {
        (&mut core.state.s, &mut core.state.fpscr)
    }
}

impl Family {
    /// Fills the leave block, once every exit has gone to it: every register and flag the block
    /// wrote goes back to the state, as each exit had it, with the next instruction's address,
    /// `ITSTATE` and the budget left. An exit with a link cell hands over to the next block when
    /// it's linked and nothing asked the core to return, and notes the cell for the core
    /// otherwise.
    pub(crate) fn finish(e: &mut Emitter<'_, '_, Self>) {
        let Some(leave) = e.leave.take() else {
            return;
        };
        e.b.switch_to_block(leave);
        e.b.seal_block(leave);
        let parameters = e.b.block_params(leave).to_vec();
        let [pc, packed, address] = parameters[..] else {
            unreachable!("the leave block's three parameters");
        };
        let it = e.b.ins().band_imm_s(packed, 0xFF);
        let retired = e.b.ins().ushr_imm_u(packed, 8);
        let retired = e.b.ins().band_imm_s(retired, 0xFF);
        let status = e.b.ins().ushr_imm_u(packed, 16);
        e.store_field(offset_of!(State, r) + 15 * 4, pc);
        e.store_field(offset_of!(State, it), it);
        let budget = e.b.use_var(e.budget);
        let left = e.b.ins().isub(budget, retired);
        let core = e.core();
        e.b.ins()
            .store(MemFlagsData::trusted(), left, core, offsets::BUDGET);
        let Some(chain) = e.chain.as_ref() else {
            e.b.ins().return_(&[status]);
            return;
        };
        let signature = chain.signature;
        let recent = chain.recent;
        let beside = u64::from(LONGEST_BLOCK) << 40 | chain.space;
        let chained = e.b.create_block();
        let plain = e.b.create_block();
        e.b.ins().brif(address, chained, &[], plain, &[]);
        e.b.seal_block(chained);
        e.b.seal_block(plain);
        e.b.switch_to_block(plain);
        e.b.ins().return_(&[status]);
        e.b.switch_to_block(chained);
        // An exit to a computed address finds the next block by its key, and one to a known
        // address reads its link cell.
        let computed = e.b.ins().icmp_imm_s(IntCC::Equal, address, FIND);
        let by_key = e.b.create_block();
        let by_cell = e.b.create_block();
        let found = e.b.create_block();
        e.b.append_block_param(found, e.pointer);
        e.b.ins().brif(computed, by_key, &[], by_cell, &[]);
        e.b.seal_block(by_key);
        e.b.seal_block(by_cell);
        e.b.switch_to_block(by_key);
        let wide_pc = e.b.ins().uextend(types::I64, pc);
        let wide_it = e.b.ins().uextend(types::I64, it);
        let wide_it = e.b.ins().ishl_imm_s(wide_it, 32);
        let key = e.b.ins().bor(wide_pc, wide_it);
        let beside = i64::try_from(beside).expect("a key below bit 63");
        let key = e.b.ins().bor_imm_s(key, beside);
        let next = emit_find(e.b, e.pointer, recent, key);
        e.b.ins().jump(found, &[next.into()]);
        e.b.switch_to_block(by_cell);
        let next =
            e.b.ins()
                .load(e.pointer, MemFlagsData::trusted(), address, 0);
        e.b.ins().jump(found, &[next.into()]);
        e.b.seal_block(found);
        e.b.switch_to_block(found);
        let next = e.b.block_params(found)[0];
        // Only a cell is noted for the core to link.
        let none = e.b.ins().iconst(e.pointer, 0);
        let address = e.b.ins().select(computed, none, address);
        let core = e.core();
        // A helper that reached the bus asked the core to return, which only the run loop does.
        let returning = e.b.ins().load(
            types::I32,
            MemFlagsData::trusted(),
            core,
            offsets::RETURNING,
        );
        let returning = e.b.ins().icmp_imm_s(IntCC::NotEqual, returning, 0);
        let returning = e.b.ins().uextend(e.pointer, returning);
        let stay = e.b.ins().band_imm_s(returning, 0);
        let next = e.b.ins().select(returning, stay, next);
        let linked = e.b.create_block();
        let unlinked = e.b.create_block();
        e.b.ins().brif(next, linked, &[], unlinked, &[]);
        e.b.seal_block(linked);
        e.b.seal_block(unlinked);
        e.b.switch_to_block(linked);
        let core = e.core();
        e.b.ins().return_call_indirect(signature, next, &[core]);
        e.b.switch_to_block(unlinked);
        let core = e.core();
        e.b.ins()
            .store(MemFlagsData::trusted(), address, core, offsets::LINK);
        e.b.ins().return_(&[status]);
    }
}

/// The page table, read again from the core wherever it's needed rather than kept.
fn table(e: &mut Emitter<'_, '_, Family>) -> Value {
    let core = e.core();
    e.b.ins()
        .load(e.pointer, MemFlagsData::trusted(), core, offsets::TABLE)
}

/// B1.6.3's `ExecuteFPCheck()`, or only `CheckVFPEnabled()` when not `execute`: 0, or
/// [`FAULTED`] when CP10 refused or the lazy preservation faulted, with [`KEEP_PC`] too when
/// that preservation locked up.
extern "C" fn execute_fp_check(core: &mut Family, execute: u32, pc: u32, index: u32) -> u64 {
    if !core.fp_enabled(core.state.privileged()) {
        core.raise_fault(Fault::NoCoprocessor);
        return FAULTED;
    }
    // B1.6.3: an outstanding lazy save is made before the instruction touches the registers, and
    // a save that faults leaves the instruction unrun.
    if execute != 0
        && is_set(fpccr::LSPACT, core.system.fpccr)
        && !core.preserve_fp_state(Position::Instruction { pc, index })
    {
        // TakePreserveFPException() locks up with BranchWritePC(0xFFFFFFFE), which is in r[15].
        return if core.state.locked_up != 0 {
            FAULTED | KEEP_PC
        } else {
            FAULTED
        };
    }
    if execute != 0
        && is_set(fpccr::ASPEN, core.system.fpccr)
        && !is_set(control::FPCA, core.state.control)
    {
        core.state.fpscr =
            core.state.fpscr & !fp::FPSCR_DEFAULTS | core.system.fpdscr & fp::FPSCR_DEFAULTS;
        core.state.control |= mask(control::FPCA);
    }
    0
}

/// `IntegerZeroDivideTrappingEnabled()`, D6.7.29: `CCR.DIV_0_TRP`, as 0 or 1.
extern "C" fn zero_divide_traps(core: &mut Family) -> u32 {
    u32::from(is_set(ccr::DIV_0_TRP, core.system.ccr))
}

#[cfg(test)]
mod tests {
    use super::super::testing::Bench;
    use super::*;
    use crate::cpu::armv7::registers::{fpscr, set};

    const ONE: u32 = 0x3F80_0000;
    const THREE: u32 = 0x4040_0000;
    /// CP10 and CP11 open to everything, B3.2.20.
    const CPACR_FULL: u32 = mask(cpacr::CP10) | mask(cpacr::CP11);
    const ROUND_ZERO: u32 = set(fpscr::RMODE, 0, 0b11);

    /// A bench running `code` with the extension open and a floating-point context already
    /// active, so the first instruction takes nothing from `FPDSCR`.
    fn bench(code: &[u16]) -> Bench {
        let mut bench = Bench::new(code);
        bench.core.system.cpacr = CPACR_FULL;
        bench.core.state.control |= mask(control::FPCA);
        bench
    }

    /// B1.6.3's `CheckVFPEnabled()` by CPACR's CP10 field, B3.2.20, for privileged and
    /// unprivileged Thread mode.
    #[test]
    fn cpacr_decides_who_may_use_the_extension() {
        let mut bench = bench(&[]);
        let refused = FAULTED;
        let both = |access| set(cpacr::CP11, set(cpacr::CP10, 0, access), access);
        for (cpacr, unprivileged, answer) in [
            (both(0b00), false, refused),
            (both(0b01), false, 0),
            (both(0b01), true, refused),
            (both(0b10), false, refused),
            (both(0b11), true, 0),
        ] {
            bench.core.system.cpacr = cpacr;
            let npriv = set(control::NPRIV, 0, u32::from(unprivileged));
            bench.core.state.control = mask(control::FPCA) | npriv;
            assert_eq!(
                execute_fp_check(&mut bench.core, 1, 0, 0),
                answer,
                "CPACR {cpacr:#x}, unprivileged {unprivileged}"
            );
        }
    }

    /// `ExecuteFPCheck()`: with `FPCCR.ASPEN` set, the first instruction of a context takes
    /// FPSCR's controls from `FPDSCR` and sets `CONTROL.FPCA`, and rounds by what it took. An
    /// UNDEFINED encoding only checks the extension's on.
    #[test]
    fn the_first_instruction_of_a_context_takes_fpdscr() {
        let one_third = |aspen: bool| {
            let mut bench = Bench::new(&[0xEE80, 0x0A81]);
            bench.core.system.cpacr = CPACR_FULL;
            bench.core.system.fpdscr = ROUND_ZERO;
            if !aspen {
                bench.core.system.fpccr &= !mask(fpccr::ASPEN);
            }
            bench.core.state.s[1..3].copy_from_slice(&[ONE, THREE]);
            bench.core.state.fpscr = mask(fpscr::N) | mask(fpscr::FZ);
            bench.run(1);
            bench
        };
        let bench = one_third(true);
        let state = &bench.core.state;
        assert_eq!(state.s[0], 0x3EAA_AAAA, "rounded towards zero");
        assert_eq!(
            state.fpscr,
            mask(fpscr::N) | ROUND_ZERO | mask(fpscr::IXC),
            "N kept, FZ replaced"
        );
        assert_eq!(state.control & mask(control::FPCA), mask(control::FPCA));

        let bench = one_third(false);
        assert_eq!(bench.core.state.s[0], 0x3EAA_AAAB, "FPSCR as it was");
        assert_eq!(bench.core.state.control & mask(control::FPCA), 0);

        let mut bench = Bench::new(&[]);
        bench.core.system.cpacr = CPACR_FULL;
        assert_eq!(execute_fp_check(&mut bench.core, 0, 0, 0), 0);
        assert_eq!(
            bench.core.state.control & mask(control::FPCA),
            0,
            "an UNDEFINED encoding starts no context"
        );
    }
}
