// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The ARMv7-R family's [`Profile`]: where [`Family`] keeps what a block reads and writes, and the
//! parts of an instruction this profile does its own way. A load or store the page table misses
//! calls into the family, an interworking branch picks the instruction set from bit 0 of its
//! target, an exit chains to the next block by its key, and a divide by zero traps by
//! `SCTLR.DZ`.

use std::mem::offset_of;

use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value, condcodes::IntCC, types};

use super::super::family::{Family, helpers, offsets};
use super::super::registers::sctlr;
use super::super::state::State;
use super::LONGEST_BLOCK;
use crate::cpu::armv7::registers::mask;
use crate::cpu::armv7::translate::float::Fpu;
use crate::cpu::armv7::translate::{Attributes, Emitter, FIND, Fault, Profile, Size, status};
use crate::emulator::core::{Lookup, emit_find, emit_lookup, load_guest, store_guest};

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
    /// DDI 0406C B1.3.2's `Rmode[]` writes the SP as given, and makes a value with bits 1 and 0
    /// set UNPREDICTABLE only in Thumb state, so the core keeps whatever it's given in both.
    const ALIGNS_SP: bool = false;

    /// Loads `size` bytes at `address`, zero-extended to an `i32`, in the order `CPSR.E` gives,
    /// A2.5.3. A fault leaves the block as if the instruction hadn't run, so an instruction loads
    /// before it writes a register.
    fn load(
        e: &mut Emitter<'_, '_, Self>,
        address: Value,
        size: Size,
        attributes: Attributes,
    ) -> Value {
        e.accessed = true;
        // The page table holds what's inline at the processor's privilege, so an unprivileged
        // access always goes to the family, which checks it as one.
        if attributes.unprivileged {
            return read(e, address, size, attributes);
        }
        let slow = e.b.create_block();
        e.b.set_cold_block(slow);
        let join = e.b.create_block();
        e.b.append_block_param(join, types::I32);
        let table = table(e);
        let host = emit_lookup(e.b, table, address, Lookup::Read(size.bytes()), slow);
        let value = load_guest(e.b, size.host(), host, e.features.endian);
        let value = if size == Size::Word {
            value
        } else {
            e.b.ins().uextend(types::I32, value)
        };
        e.b.ins().jump(join, &[value.into()]);
        e.b.switch_to_block(slow);
        let value = read(e, address, size, attributes);
        e.b.ins().jump(join, &[value.into()]);
        e.b.seal_block(join);
        e.b.switch_to_block(join);
        e.b.block_params(join)[0]
    }

    /// Stores the low `size` bytes of `value` at `address`, in the order `CPSR.E` gives. A fault
    /// leaves the block as [`Profile::load`]'s does.
    fn store(
        e: &mut Emitter<'_, '_, Self>,
        address: Value,
        value: Value,
        size: Size,
        attributes: Attributes,
    ) {
        e.accessed = true;
        if attributes.unprivileged {
            write(e, address, value, size, attributes);
            return;
        }
        let slow = e.b.create_block();
        e.b.set_cold_block(slow);
        let join = e.b.create_block();
        let table = table(e);
        let host = emit_lookup(e.b, table, address, Lookup::Write(size.bytes()), slow);
        let narrow = if size == Size::Word {
            value
        } else {
            e.b.ins().ireduce(size.host(), value)
        };
        store_guest(e.b, narrow, host, e.features.endian);
        e.b.ins().jump(join, &[]);
        e.b.switch_to_block(slow);
        write(e, address, value, size, attributes);
        e.b.ins().jump(join, &[]);
        e.b.seal_block(join);
        e.b.switch_to_block(join);
    }

    /// `BXWritePC(address)`, A2.3.2, which `LoadWritePC` and ARM state's `ALUWritePC` are too:
    /// bit 0 is `CPSR.T`, and the next instruction is at the rest, with bit 1 cleared too in ARM
    /// state. A target in ARM state with bit 1 set is UNPREDICTABLE, and the core takes it as
    /// `BranchWritePC()` there would. Ends the block.
    fn branch_exchange(e: &mut Emitter<'_, '_, Self>, address: Value) {
        let thumb = e.b.ins().band_imm_s(address, 1);
        e.store_field(offset_of!(State, t), thumb);
        let low = e.b.ins().iconst(types::I32, 3);
        let one = e.b.ins().iconst(types::I32, 1);
        let alignment = e.b.ins().select(thumb, one, low);
        let target = e.b.ins().band_not(address, alignment);
        let chains = e.constant(1);
        e.exit_to_computed(target, chains);
    }

    /// The branch of `BLX` with a register, which A8.8.26 makes `BXWritePC()`. Ends the block.
    fn blx_write_pc(e: &mut Emitter<'_, '_, Self>, address: Value) {
        Self::branch_exchange(e, address);
    }

    /// Raises `fault` for this instruction. An `SVC` retires first and returns past itself, and
    /// every other fault leaves as if the instruction hadn't run. Ends the block.
    fn raise(e: &mut Emitter<'_, '_, Self>, fault: Fault) {
        let code = e.constant(fault as u32);
        e.call_plain(helpers::raise as *const () as usize, &[code]);
        if fault == Fault::SupervisorCall {
            let next = e.constant(e.next_pc());
            e.exit_to(next, status::EXCEPTION);
        } else {
            e.exit_before(status::EXCEPTION);
        }
    }

    /// An alignment fault, which on this profile is a Data Abort that writes `DFAR` with `address`
    /// and `DFSR.RW` with `write`, B5.5.2, recorded as an access the core refused is.
    fn raise_unaligned(
        e: &mut Emitter<'_, '_, Self>,
        misaligned: Value,
        address: Value,
        write: bool,
    ) {
        let refuse = e.b.create_block();
        e.b.set_cold_block(refuse);
        let go_on = e.b.create_block();
        e.b.ins().brif(misaligned, refuse, &[], go_on, &[]);
        e.b.seal_block(refuse);
        e.b.switch_to_block(refuse);
        let write = e.constant(u32::from(write));
        let answer = e.call_helper(
            helpers::unaligned as *const () as usize,
            &[address, write],
            types::I64,
        );
        e.fault_unless(answer);
        e.b.ins().jump(go_on, &[]);
        e.b.seal_block(go_on);
        e.b.switch_to_block(go_on);
    }

    /// `CheckVFPEnabled(TRUE)`, B1.11.1. An UNDEFINED encoding is the same Undefined Instruction
    /// exception whether or not the unit is on, so it checks nothing. Nothing a block runs changes
    /// `CPACR`, `FPEXC` or the mode without ending the block, so one check covers the rest. An R5
    /// without the unit has no CP10 or CP11, so every instruction for them is UNDEFINED, B1.10.2.
    fn fp_check(e: &mut Emitter<'_, '_, Self>, execute: bool) {
        if !execute || e.fp_checked {
            return;
        }
        if e.features.fpu == Fpu::None {
            let absent = e.b.ins().iconst(types::I8, 1);
            e.raise_if(absent, Fault::Undefined);
            return;
        }
        e.fp_checked = true;
        Self::check_vfp_enabled(e, true);
    }

    /// `SCTLR.DZ`, DDI 0460D 4.3.16, as 0 or 1.
    fn divide_by_zero_traps(e: &mut Emitter<'_, '_, Self>) -> Value {
        let sctlr = e.load_core(offsets::SCTLR);
        let dz = e.b.ins().band_imm_s(sctlr, i64::from(mask(sctlr::DZ)));
        let traps = e.b.ins().icmp_imm_s(IntCC::NotEqual, dz, 0);
        e.b.ins().uextend(types::I32, traps)
    }

    fn fp_registers(core: &mut Self) -> (&mut [u32; 32], &mut u32) {
        (&mut core.state.s, &mut core.state.fpscr)
    }
}

impl Family {
    /// B1.11.1's `CheckVFPEnabled(include_fpexc)`, which raises the Undefined Instruction
    /// exception where it refuses.
    pub(super) fn check_vfp_enabled(e: &mut Emitter<'_, '_, Self>, include_fpexc: bool) {
        let include = e.constant(u32::from(include_fpexc));
        let refused = e.call_helper(
            helpers::fp_refused as *const () as usize,
            &[include],
            types::I32,
        );
        let refused = e.b.ins().icmp_imm_s(IntCC::NotEqual, refused, 0);
        e.raise_if(refused, Fault::Undefined);
    }

    /// Returns from an exception to `address`, restoring `psr` as the CPSR, as `SUBS PC, LR`,
    /// `RFE` and `LDM` with the PC do, B1.8.10. The block leaves by an exit that never chains,
    /// since the next block's key hangs on the PSR. The run loop restores the PSR once the block
    /// is out, so the `ITSTATE` that stands is the PSR's and not the exit's. Ends the block.
    pub(crate) fn exception_return(e: &mut Emitter<'_, '_, Self>, address: Value, psr: Value) {
        let core = e.core();
        e.b.ins()
            .store(MemFlagsData::trusted(), psr, core, offsets::RESTORING);
        e.exit_to(address, status::EXCEPTION_RETURN);
    }

    /// Fills the leave block, once every exit has gone to it: every register and flag the block
    /// wrote goes back to the state, as each exit had it, with the next instruction's address,
    /// `ITSTATE` and the budget left. An exit with a link cell hands over to the next block when
    /// it's linked and nothing asked the core to return, and notes the cell for the core
    /// otherwise. An exit to a computed address finds the next block by its key, from the
    /// instruction set the exit leaves in `CPSR.T` and the block's `context`, its key's bits for
    /// the byte order and the privilege.
    pub(crate) fn finish(e: &mut Emitter<'_, '_, Self>, context: u64) {
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
        let chained = e.b.create_block();
        let plain = e.b.create_block();
        e.b.ins().brif(address, chained, &[], plain, &[]);
        e.b.seal_block(chained);
        e.b.seal_block(plain);
        e.b.switch_to_block(plain);
        e.b.ins().return_(&[status]);
        e.b.switch_to_block(chained);
        let computed = e.b.ins().icmp_imm_s(IntCC::Equal, address, FIND);
        let by_key = e.b.create_block();
        let by_cell = e.b.create_block();
        let found = e.b.create_block();
        e.b.append_block_param(found, e.pointer);
        e.b.ins().brif(computed, by_key, &[], by_cell, &[]);
        e.b.seal_block(by_key);
        e.b.seal_block(by_cell);
        e.b.switch_to_block(by_key);
        let thumb = e.load_field(offset_of!(State, t));
        let wide_pc = e.b.ins().uextend(types::I64, pc);
        let wide_it = e.b.ins().uextend(types::I64, it);
        let wide_it = e.b.ins().ishl_imm_s(wide_it, 32);
        let wide_thumb = e.b.ins().uextend(types::I64, thumb);
        let wide_thumb = e.b.ins().ishl_imm_s(wide_thumb, 48);
        let key = e.b.ins().bor(wide_pc, wide_it);
        let key = e.b.ins().bor(key, wide_thumb);
        let fixed = i64::from(LONGEST_BLOCK) << 40 | context.cast_signed();
        let key = e.b.ins().bor_imm_s(key, fixed);
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

/// A load through the family's [`helpers::read`], which faults the instruction where it's refused.
fn read(
    e: &mut Emitter<'_, '_, Family>,
    address: Value,
    size: Size,
    attributes: Attributes,
) -> Value {
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
    e.b.ins().ireduce(types::I32, answer)
}

/// A store through the family's [`helpers::write`], which faults the instruction where it's
/// refused.
fn write(
    e: &mut Emitter<'_, '_, Family>,
    address: Value,
    value: Value,
    size: Size,
    attributes: Attributes,
) {
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
}
