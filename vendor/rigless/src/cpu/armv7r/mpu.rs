// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The MPU of the PMSA, version 7, DDI 0406C B5.1 to B5.4 with B5.10.2's `TranslateAddressP()`, as DDI 0460D
//! chapter 7 has it: 12 or 16 unified regions, each with its `DRBAR`, `DRSR` and `DRACR`, which `RGNR`
//! selects, 4.3.21.
//!
//! While `SCTLR.M` is set, every data access is checked by [`Family::mpu_check`]. A fetch is
//! checked at block lookup with the MPU on or off, since the default map is execute-never in
//! places either way, B5.1.5. Memory types and cache policies aren't modeled beyond what decides
//! a fetch, since the emulator's memory has no cache.

use serde::{Deserialize, Serialize};

use super::family::{Family, Refused};
use super::registers::{dracr, drbar, drsr, rgnr, sctlr};
use crate::cpu::armv7::registers::{get, is_set, mask};
use crate::emulator::core::Inline;

/// The most regions an R5 has, DDI 0460D 7.1.1.
const REGIONS: usize = 16;

/// The smallest region the R5 has, 32 bytes, as a power of two, DDI 0460D Table 4-34.
pub(crate) const SMALLEST_REGION_BITS: u32 = 5;

/// A region of 256 bytes or more has eight subregions, B5.1.2.
const SUBREGION_BITS: u32 = 8;

/// `AP` for full access, which the background region gives PL1, B5.10.2.
const FULL_ACCESS: u32 = 0b011;

/// What an access does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Read,
    Write,
    Fetch,
}

/// The MPU's registers. A reset disables every region, DDI 0460D Table 4-34, and leaves the rest
/// zero where it's UNKNOWN.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Mpu {
    rgnr: u32,
    drbar: [u32; REGIONS],
    drsr: [u32; REGIONS],
    dracr: [u32; REGIONS],
}

impl Mpu {
    /// The c6 register `MRC` or `MCR` names by `crm` and `opc2`, of the region `RGNR` selects,
    /// and its bits that aren't SBZ, Tables 4-33 to 4-35 and 4-39. `RGNR` holds 4 bits, so it
    /// always selects one of the 16 regions.
    pub(crate) fn register(&mut self, crm: u32, opc2: u32) -> Option<(&mut u32, u32)> {
        let region = get(rgnr::REGION, self.rgnr) as usize;
        let fields = |fields: &[&crate::soc::FieldSpec]| fields.iter().fold(0, |v, f| v | mask(f));
        match (crm, opc2) {
            (1, 0) => Some((&mut self.drbar[region], mask(drbar::BASE))),
            (1, 2) => Some((
                &mut self.drsr[region],
                fields(&[drsr::SRD, drsr::SIZE, drsr::ENABLE]),
            )),
            (1, 4) => Some((
                &mut self.dracr[region],
                fields(&[
                    dracr::XN,
                    dracr::AP,
                    dracr::TEX,
                    dracr::S,
                    dracr::C,
                    dracr::B,
                ]),
            )),
            (2, 0) => Some((&mut self.rgnr, mask(rgnr::REGION))),
            _ => None,
        }
    }

    /// The `DRACR` of the highest of the first `regions` enabled holding `address` in an enabled
    /// subregion, B5.1.3 and B5.10.2.
    fn matching(&self, address: u32, regions: u32) -> Option<u32> {
        (0..regions as usize).rev().find_map(|region| {
            let size = self.drsr[region];
            if !is_set(drsr::ENABLE, size) {
                return None;
            }
            // A size below 32 bytes is UNPREDICTABLE, Table 4-34, and `DRBAR` can't place a
            // region finer than that, so that's what you get.
            let bits = (get(drsr::SIZE, size) + 1).max(SMALLEST_REGION_BITS);
            // B5.10.2 compares the bits above the size only, so a base not aligned to it, which
            // DDI 0460D 7.1.1 makes UNPREDICTABLE, is aligned down.
            let offset =
                u64::from(address).wrapping_sub(u64::from(self.drbar[region]) >> bits << bits);
            if offset >> bits != 0 {
                return None;
            }
            let disabled =
                bits >= SUBREGION_BITS && get(drsr::SRD, size) >> (offset >> (bits - 3)) & 1 != 0;
            (!disabled).then_some(self.dracr[region])
        })
    }
}

/// Whether `AP` grants an access, Table B5-3. The reserved encodings are UNPREDICTABLE, and grant
/// nothing here.
fn grants(ap: u32, kind: Kind, privileged: bool) -> bool {
    let write = kind == Kind::Write;
    match ap {
        0b001 => privileged,
        0b010 => privileged || !write,
        0b011 => true,
        0b101 => privileged && !write,
        0b110 => !write,
        _ => false,
    }
}

/// Whether `DRACR`'s `TEX`, `C` and `B` make the region Device or Strongly-ordered, Table 4-36.
/// A fetch from either is UNPREDICTABLE, DDI 0406C A3.5.7, and DDI 0460D 7.1.1 says the R5 never
/// executes from them. The reserved encodings are taken as Normal.
fn device(access: u32) -> bool {
    let cb = get(dracr::C, access) << 1 | get(dracr::B, access);
    matches!(
        (get(dracr::TEX, access), cb),
        (0b000, 0b00 | 0b01) | (0b010, 0b00)
    )
}

impl Family {
    /// The default map's execute-never, Table B5-1, as B5.10.2 gives it: the top 256 MB unless the
    /// vectors are high, and everything else from `0x8000_0000`.
    fn default_execute_never(&self, address: u32) -> bool {
        if address >> 28 == 0xF {
            !is_set(sctlr::V, self.sctlr)
        } else {
            address >> 31 != 0
        }
    }

    /// Checks an access of `kind` at `address`, B5.4.2's sequence, which Figure B5-2 draws, at the
    /// processor's privilege, or unprivileged for `LDRT` and its kind. A refusal carries the
    /// address, the `DFAR` or `IFAR` B5.5.2 and B5.5.3 report.
    ///
    /// With the MPU off a data access is never refused, and a fetch only where the default map is
    /// execute-never, as a Permission fault, B5.1.5. With it on, the highest region holding the
    /// address decides, then the default map for a PL1 access with `SCTLR.BR` set, and otherwise
    /// it's a Background fault. A fetch needs read access and `XN` clear, DDI 0460D Table 4-38. A
    /// fetch from Device or Strongly-ordered memory is a Permission fault too, a choice for what
    /// DDI 0406C A3.5.7 makes UNPREDICTABLE and DDI 0460D 7.1.1 says the R5 never runs.
    pub(crate) fn mpu_check(
        &self,
        address: u32,
        kind: Kind,
        unprivileged: bool,
    ) -> Result<(), Refused> {
        let privileged = self.state.privileged() && !unprivileged;
        let (ap, execute_never) = if !is_set(sctlr::M, self.sctlr) {
            if kind != Kind::Fetch {
                return Ok(());
            }
            (FULL_ACCESS, self.default_execute_never(address))
        } else if let Some(access) = self
            .system
            .mpu
            .matching(address, self.options().mpu_regions.count())
        {
            let xn = is_set(dracr::XN, access) || device(access);
            (get(dracr::AP, access), xn)
        } else if privileged && is_set(sctlr::BR, self.sctlr) {
            (FULL_ACCESS, self.default_execute_never(address))
        } else {
            return Err(Refused::Background(address));
        };
        let allowed = grants(ap, kind, privileged) && !(kind == Kind::Fetch && execute_never);
        if allowed {
            Ok(())
        } else {
            Err(Refused::Permission(address))
        }
    }

    /// Whether the processor may run an instruction fetched from `address` now.
    pub(crate) fn mpu_fetch_allows(&self, address: u32) -> bool {
        self.mpu_check(address, Kind::Fetch, false).is_ok()
    }

    /// The data accesses of the `size` bytes at `base` the MPU lets through at the processor's
    /// privilege, checked a smallest region at a time, since no region decides less. `base` and
    /// `size` are multiples of that.
    pub(crate) fn mpu_inline(&self, base: u32, size: u32) -> Inline {
        let granules =
            (0..size >> SMALLEST_REGION_BITS).map(|g| base + (g << SMALLEST_REGION_BITS));
        let all = |kind| {
            granules
                .clone()
                .all(|at| self.mpu_check(at, kind, false).is_ok())
        };
        // Table B5-3 never grants a write without a read.
        if all(Kind::Write) {
            Inline::Both
        } else if all(Kind::Read) {
            Inline::Reads
        } else {
            Inline::Neither
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::exception::Exception;
    use super::super::family::{Raised, SystemRegister};
    use super::super::registers::{fsr, mpuir};
    use super::super::state::Mode;
    use super::super::translate::testing::{Bench, CODE, RAM, VECTORS};
    use super::*;
    use crate::cpu::armv7::registers::set;
    use crate::soc::Endian;

    /// c6's registers by `crm` and `opc2`, and `SCTLR`.
    const RGNR: (u32, u32, u32) = (6, 2, 0);
    const DRBAR: (u32, u32, u32) = (6, 1, 0);
    const DRSR: (u32, u32, u32) = (6, 1, 2);
    const DRACR: (u32, u32, u32) = (6, 1, 4);
    const SCTLR: (u32, u32, u32) = (1, 0, 0);
    /// `AP` values, Table B5-3.
    const NO_ACCESS: u32 = 0b000;
    const PRIVILEGED_ONLY: u32 = 0b001;
    const USER_READS: u32 = 0b010;
    const PRIVILEGED_READS: u32 = 0b101;
    const EVERYONE_READS: u32 = 0b110;
    /// `TEX` 001, `C` and `B` set: Normal memory, write-back, write-allocate, Table 4-36.
    const NORMAL: u32 = 0b00_1011;
    /// `FSR[10, 3:0]`, Tables B5-7 and B5-8.
    const BACKGROUND: u32 = 0b0_0000;
    const PERMISSION: u32 = 0b0_1101;

    fn reg((crn, crm, opc2): (u32, u32, u32)) -> SystemRegister {
        SystemRegister {
            opc1: 0,
            crn,
            crm,
            opc2,
        }
    }

    fn write(core: &mut Family, register: (u32, u32, u32), value: u32) {
        assert!(core.cp15_write(reg(register), value, 0), "{register:?}");
    }

    fn read(core: &mut Family, register: (u32, u32, u32)) -> u32 {
        core.cp15_read(reg(register), 0).expect("a register")
    }

    /// Region `number` of 2 to the `bits` bytes at `base`, its subregions `srd` disabled, with
    /// `ap`, Normal memory and `XN` from `xn`.
    #[expect(
        clippy::too_many_arguments,
        reason = "each is one of the region's own registers' fields"
    )]
    fn region(core: &mut Family, number: u32, base: u32, bits: u32, srd: u32, ap: u32, xn: bool) {
        write(core, RGNR, number);
        write(core, DRBAR, base);
        let size = set(drsr::SIZE, mask(drsr::ENABLE), bits - 1);
        write(core, DRSR, set(drsr::SRD, size, srd));
        let access = set(dracr::AP, NORMAL, ap);
        write(core, DRACR, set(dracr::XN, access, u32::from(xn)));
    }

    /// Turns the MPU on, with the background region if `background`.
    fn enable(core: &mut Family, background: bool) {
        let value = read(core, SCTLR) | mask(sctlr::M);
        write(core, SCTLR, set(sctlr::BR, value, u32::from(background)));
    }

    fn check(core: &Family, address: u32, kind: Kind) -> Result<(), Refused> {
        core.mpu_check(address, kind, false)
    }

    /// A bench in ARM state whose code and vectors are full access, MPU on, the background region
    /// off.
    fn protected(code: &[u32]) -> Bench {
        let mut bench = Bench::arm(Endian::Little, code);
        region(&mut bench.core, 0, CODE, 16, 0, FULL_ACCESS, false);
        region(&mut bench.core, 1, VECTORS, 12, 0, FULL_ACCESS, false);
        enable(&mut bench.core, false);
        bench
    }

    fn status(value: u32) -> u32 {
        get(fsr::S, value) << fsr::STATUS.width | get(fsr::STATUS, value)
    }

    /// DDI 0460D 4.3.21: each register holds its own bits, reads back what `RGNR` selects, and
    /// User mode reaches none of them. B5.1.6: `DRBAR` gives the smallest region, 32 bytes.
    #[test]
    fn each_region_register_keeps_its_bits_for_the_region_selected() {
        let mut core = Family::new(super::super::translate::testing::ties(Endian::Big)).unwrap();
        write(&mut core, RGNR, 0xFFFF_FFFF);
        assert_eq!(read(&mut core, RGNR), 15);
        write(&mut core, DRBAR, 0xFFFF_FFFC);
        assert_eq!(
            read(&mut core, DRBAR),
            0xFFFF_FFE0,
            "32 bytes at the finest"
        );
        write(&mut core, DRSR, u32::MAX);
        assert_eq!(read(&mut core, DRSR), 0xFF3F);
        write(&mut core, DRACR, u32::MAX);
        assert_eq!(read(&mut core, DRACR), 0x173F);
        write(&mut core, RGNR, 3);
        assert_eq!(
            [DRBAR, DRSR, DRACR].map(|register| read(&mut core, register)),
            [0; 3],
            "region 3's own"
        );
        core.state.set_mode(Mode::User);
        for register in [RGNR, DRBAR, DRSR, DRACR] {
            assert_eq!(core.cp15_read(reg(register), 0), None);
            assert!(!core.cp15_write(reg(register), 0, 0));
        }
    }

    /// Table 4-6: the bench's core, built with 12 regions, reports them, and never matches past
    /// them.
    #[test]
    fn a_core_of_twelve_regions_uses_only_those() {
        let mut core = Family::new(super::super::translate::testing::ties(Endian::Big)).unwrap();
        assert_eq!(
            core.cp15_read(reg((0, 0, 4)), 0),
            Some(set(mpuir::DREGION, 0, 12))
        );
        region(&mut core, 12, RAM, 12, 0, FULL_ACCESS, false);
        enable(&mut core, false);
        assert_eq!(check(&core, RAM, Kind::Read), Err(Refused::Background(RAM)));
    }

    /// B5.1.3: the highest numbered region holding an address decides it.
    #[test]
    fn the_highest_region_decides_where_regions_overlap() {
        let mut core = Family::new(super::super::translate::testing::ties(Endian::Big)).unwrap();
        region(&mut core, 1, 0, 14, 0, PRIVILEGED_ONLY, false);
        region(&mut core, 2, 0x3000, 12, 0, USER_READS, false);
        enable(&mut core, false);
        core.state.set_mode(Mode::User);
        assert_eq!(check(&core, 0x3010, Kind::Read), Ok(()));
        assert_eq!(
            check(&core, 0x3010, Kind::Write),
            Err(Refused::Permission(0x3010))
        );
        assert_eq!(
            check(&core, 0x2FFC, Kind::Read),
            Err(Refused::Permission(0x2FFC))
        );
        assert_eq!(
            check(&core, 0x4000, Kind::Read),
            Err(Refused::Background(0x4000))
        );
        core.state.set_mode(Mode::Supervisor);
        region(&mut core, 3, 0, 14, 0, FULL_ACCESS, false);
        core.state.set_mode(Mode::User);
        assert_eq!(
            check(&core, 0x3010, Kind::Write),
            Ok(()),
            "region 3 over region 2"
        );
    }

    /// B5.1.2: a disabled subregion isn't part of its region, so the one below decides, or the
    /// background.
    #[test]
    fn a_disabled_subregion_falls_through_to_the_region_below() {
        let mut core = Family::new(super::super::translate::testing::ties(Endian::Big)).unwrap();
        region(&mut core, 0, 0, 12, 0, EVERYONE_READS, false);
        // 4 KB in eighths of 512 bytes, the third disabled.
        region(&mut core, 1, 0, 12, 0b0000_0100, FULL_ACCESS, false);
        enable(&mut core, false);
        assert_eq!(check(&core, 0x3FC, Kind::Write), Ok(()));
        assert_eq!(
            check(&core, 0x400, Kind::Write),
            Err(Refused::Permission(0x400))
        );
        assert_eq!(check(&core, 0x5FF, Kind::Read), Ok(()));
        assert_eq!(check(&core, 0x600, Kind::Write), Ok(()));
        region(&mut core, 0, 0, 12, 0, EVERYONE_READS, false);
        write(&mut core, DRSR, 0);
        assert_eq!(
            check(&core, 0x400, Kind::Read),
            Err(Refused::Background(0x400))
        );
        // A region below 256 bytes has no subregions.
        region(&mut core, 2, 0x800, 7, 0xFF, FULL_ACCESS, false);
        assert_eq!(check(&core, 0x87C, Kind::Write), Ok(()));
    }

    /// B5.1.4: with `SCTLR.BR` set the default map is the background for PL1 only, execute-never
    /// as Table B5-1 has it, and with it clear a miss is a Background fault for everyone.
    #[test]
    fn the_background_region_is_for_privileged_accesses() {
        let mut core = Family::new(super::super::translate::testing::ties(Endian::Big)).unwrap();
        enable(&mut core, false);
        assert_eq!(check(&core, RAM, Kind::Read), Err(Refused::Background(RAM)));
        enable(&mut core, true);
        assert_eq!(check(&core, RAM, Kind::Write), Ok(()));
        assert_eq!(check(&core, RAM, Kind::Fetch), Ok(()));
        assert_eq!(
            check(&core, 0x8000_0000, Kind::Fetch),
            Err(Refused::Permission(0x8000_0000))
        );
        assert_eq!(
            core.mpu_check(RAM, Kind::Read, true),
            Err(Refused::Background(RAM)),
            "LDRT"
        );
        core.state.set_mode(Mode::User);
        assert_eq!(check(&core, RAM, Kind::Read), Err(Refused::Background(RAM)));
    }

    /// B5.1.5: with the MPU off no data access is refused, and a fetch only where Table B5-1 says
    /// execute-never, the top 256 MB by `SCTLR.V`.
    #[test]
    fn the_default_map_refuses_only_fetches_from_execute_never_space() {
        let mut core = Family::new(super::super::translate::testing::ties(Endian::Big)).unwrap();
        for address in [0, RAM, 0x7FFF_FFFC] {
            assert!(core.mpu_fetch_allows(address), "{address:#x}");
        }
        for address in [0x8000_0000, 0xC000_0000, 0xEFFF_FFFC, VECTORS] {
            assert!(!core.mpu_fetch_allows(address), "{address:#x}");
            assert_eq!(core.mpu_check(address, Kind::Write, true), Ok(()));
        }
        let high = read(&mut core, SCTLR) | mask(sctlr::V);
        write(&mut core, SCTLR, high);
        assert!(core.mpu_fetch_allows(VECTORS));
    }

    /// Table B5-3 for each privilege, and DDI 0460D Table 4-38: a fetch needs read access and
    /// `XN` clear, and 7.1.1 never runs Device or Strongly-ordered memory.
    #[test]
    fn each_permission_grants_what_its_table_says() {
        let (r, w, x) = (Kind::Read, Kind::Write, Kind::Fetch);
        // AP, then what PL1 and User mode may do.
        let table: [(u32, &[Kind], &[Kind]); 6] = [
            (NO_ACCESS, &[], &[]),
            (PRIVILEGED_ONLY, &[r, w, x], &[]),
            (USER_READS, &[r, w, x], &[r, x]),
            (FULL_ACCESS, &[r, w, x], &[r, w, x]),
            (PRIVILEGED_READS, &[r, x], &[]),
            (EVERYONE_READS, &[r, x], &[r, x]),
        ];
        let mut core = Family::new(super::super::translate::testing::ties(Endian::Big)).unwrap();
        enable(&mut core, true);
        for (ap, privileged, user) in table {
            region(&mut core, 0, RAM, 12, 0, ap, false);
            for (mode, allowed) in [(Mode::Supervisor, privileged), (Mode::User, user)] {
                core.state.set_mode(mode);
                for kind in [r, w, x] {
                    let expected = if allowed.contains(&kind) {
                        Ok(())
                    } else {
                        Err(Refused::Permission(RAM))
                    };
                    assert_eq!(
                        check(&core, RAM, kind),
                        expected,
                        "{ap:#05b} {mode:?} {kind:?}"
                    );
                }
            }
            core.state.set_mode(Mode::Supervisor);
        }
        region(&mut core, 0, RAM, 12, 0, FULL_ACCESS, true);
        assert_eq!(check(&core, RAM, x), Err(Refused::Permission(RAM)), "XN");
        assert_eq!(check(&core, RAM, r), Ok(()));
        // TEX 000, C 0, B 1: Shareable Device.
        write(
            &mut core,
            DRACR,
            set(dracr::AP, mask(dracr::B), FULL_ACCESS),
        );
        assert_eq!(
            check(&core, RAM, x),
            Err(Refused::Permission(RAM)),
            "Device"
        );
    }

    /// B5.5.2 and Table B5-8: a refused load or store is a Data Abort reporting a Background or
    /// Permission fault, with `RW` for a store, and the address in `DFAR`.
    #[test]
    fn a_refused_access_reports_its_fault_in_dfsr() {
        // LDR r0, [r4] then STR r0, [r5].
        let code = [0xE594_0000, 0xE585_0000];
        let mut bench = protected(&code);
        region(&mut bench.core, 2, RAM, 12, 0, EVERYONE_READS, false);
        bench.core.state.r[4] = RAM + 0x1000;
        bench.core.state.r[5] = RAM;
        bench.run(2);
        assert_eq!(bench.raised(), Some((Exception::DataAbort, CODE)));
        let faults = &bench.core.faults;
        assert_eq!(
            (status(faults.dfsr), faults.dfar),
            (BACKGROUND, RAM + 0x1000)
        );
        assert!(!is_set(fsr::RW, faults.dfsr));
        let mut bench = protected(&code);
        region(&mut bench.core, 2, RAM, 12, 0, EVERYONE_READS, false);
        bench.core.state.r[4] = RAM;
        bench.core.state.r[5] = RAM + 4;
        bench.run(2);
        assert_eq!(bench.raised(), Some((Exception::DataAbort, CODE + 4)));
        let faults = &bench.core.faults;
        assert_eq!((status(faults.dfsr), faults.dfar), (PERMISSION, RAM + 4));
        assert!(is_set(fsr::RW, faults.dfsr));
        assert_eq!(
            bench.aborted(),
            Some(Raised::DataAbort {
                refused: Refused::Permission(RAM + 4),
                write: true
            })
        );
    }

    /// B5.5.3 and Table B5-7: a fetch from an `XN` region is a Prefetch Abort reporting a
    /// Permission fault at the instruction in `IFAR`, and from no region a Background fault.
    #[test]
    fn a_refused_fetch_is_a_prefetch_abort() {
        let mut bench = protected(&[]);
        region(&mut bench.core, 2, RAM, 12, 0, FULL_ACCESS, true);
        bench.core.state.r[15] = RAM;
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::PrefetchAbort, RAM)));
        let faults = &bench.core.faults;
        assert_eq!((status(faults.ifsr), faults.ifar), (PERMISSION, RAM));
        let mut bench = protected(&[]);
        bench.core.state.r[15] = RAM + 0x2000;
        bench.run(1);
        let faults = &bench.core.faults;
        assert_eq!(
            (status(faults.ifsr), faults.ifar),
            (BACKGROUND, RAM + 0x2000)
        );
    }

    /// A block runs only as far as its fetches are allowed: the instruction before an `XN` region
    /// retires, and the first one in it aborts.
    #[test]
    fn a_block_stops_where_execution_is_refused() {
        // MOV r0, #1, then MOV r1, #2 in the next 32 bytes.
        let mut bench = protected(&[]);
        let at = CODE + 0x1C;
        bench.place_arm(at, &[0xE3A0_0001, 0xE3A0_1002]);
        region(&mut bench.core, 2, CODE + 0x20, 5, 0, FULL_ACCESS, true);
        bench.core.state.r[15] = at;
        bench.run(4);
        assert_eq!(bench.raised(), Some((Exception::PrefetchAbort, at + 4)));
        assert_eq!(bench.core.state.r[0], 1);
    }

    /// The pseudocode's `MemU_with_priv()` checks an unaligned access a byte at a time, so the
    /// first byte refused is the one `DFAR` reports, B5.5.2.
    #[test]
    fn an_unaligned_access_reports_the_byte_refused() {
        // LDR r0, [r4], two bytes either side of the end of a region.
        let mut bench = protected(&[0xE594_0000]);
        region(&mut bench.core, 2, RAM, 12, 0, FULL_ACCESS, false);
        bench.core.state.r[4] = RAM + 0xFFE;
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::DataAbort, CODE)));
        let faults = &bench.core.faults;
        assert_eq!(
            (status(faults.dfsr), faults.dfar),
            (BACKGROUND, RAM + 0x1000)
        );
    }

    /// B5.5.3: a 32-bit Thumb instruction whose second halfword can't be fetched aborts at the
    /// instruction, with that halfword's address in `IFAR`.
    #[test]
    fn a_thumb_instruction_across_into_execute_never_reports_its_second_halfword() {
        let mut bench = protected(&[]);
        let at = CODE + 0x1E;
        bench.place_thumb(at, &[0xF201, 0x0000]); // ADDW r0, r1, #0
        region(&mut bench.core, 2, at + 2, 5, 0, FULL_ACCESS, true);
        bench.core.state.t = 1;
        bench.core.state.r[15] = at;
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::PrefetchAbort, at)));
        let faults = &bench.core.faults;
        assert_eq!((status(faults.ifsr), faults.ifar), (PERMISSION, at + 2));
    }

    /// Table B5-1: with the MPU off, clearing `SCTLR.V` makes the top 256 MB execute-never, and a
    /// block there that the run loop found before isn't run again through a chain or a computed
    /// exit.
    #[test]
    fn clearing_high_vectors_refuses_a_block_found_before() {
        // MCR p15, 0, r0, c1, c0, 0 then BX r1, and up high MOV r0, r3 then BX r2.
        let mut bench = Bench::arm(Endian::Little, &[0xEE01_0F10, 0xE12F_FF11]);
        let high = VECTORS + 0x100;
        bench.place_arm(high, &[0xE1A0_0003, 0xE12F_FF12]);
        let sctlr = read(&mut bench.core, SCTLR);
        let state = &mut bench.core.state;
        (state.r[0], state.r[1], state.r[2]) = (sctlr, high, CODE);
        state.r[3] = sctlr & !mask(sctlr::V);
        bench.run(12);
        let faults = &bench.core.faults;
        assert_eq!((status(faults.ifsr), faults.ifar), (PERMISSION, high));
    }

    /// The privileged forms reach what the region gives PL1, and `LDRT` and `STRT` are checked
    /// as User mode's, A8.8.92, B5.2.1.
    #[test]
    fn an_unprivileged_access_is_refused_where_only_pl1_may_go() {
        // LDR r0, [r4], then LDRT r1, [r4].
        let mut bench = protected(&[0xE594_0000, 0xE4B4_1000]);
        region(&mut bench.core, 2, RAM, 12, 0, PRIVILEGED_ONLY, false);
        bench.core.state.r[4] = RAM;
        bench.run(2);
        assert_eq!(bench.raised(), Some((Exception::DataAbort, CODE + 4)));
        let faults = &bench.core.faults;
        assert_eq!((status(faults.dfsr), faults.dfar), (PERMISSION, RAM));
    }

    /// The MPU never drops a translation: the block keeps running from the code cache, and each
    /// configuration is checked afresh when the block is looked up.
    #[test]
    fn a_reconfigured_mpu_refuses_a_block_it_allowed_before() {
        // MOV r0, #1, then B . from the next word.
        let mut bench = protected(&[0xE3A0_0001, 0xEAFF_FFFE]);
        bench.run(4);
        assert_eq!(bench.core.state.r[0], 1);
        assert_eq!(bench.raised(), None);
        let blocks = bench.core.translated();
        write(&mut bench.core, RGNR, 0);
        write(
            &mut bench.core,
            DRACR,
            set(dracr::XN, set(dracr::AP, NORMAL, FULL_ACCESS), 1),
        );
        assert_eq!(bench.core.translated(), blocks, "nothing dropped");
        bench.core.state.r[15] = CODE;
        bench.core.state.sleeping = 0;
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::PrefetchAbort, CODE)));
    }

    /// The block after an `MCR` that turns the MPU on is looked up afresh, since the write ends
    /// its block unchained, and so is checked.
    #[test]
    fn turning_the_mpu_on_checks_the_next_fetch() {
        // MCR p15, 0, r0, c1, c0, 0 at the end of a smallest region, then MOV r0, r2 and a branch
        // back to it.
        let mut bench = Bench::arm(Endian::Little, &[]);
        let at = CODE + 0x1C;
        bench.place_arm(at, &[0xEE01_0F10, 0xE1A0_0002, 0xEAFF_FFFC]);
        region(&mut bench.core, 0, CODE, 16, 0, FULL_ACCESS, false);
        region(&mut bench.core, 1, VECTORS, 12, 0, FULL_ACCESS, false);
        region(&mut bench.core, 2, at + 4, 5, 0, FULL_ACCESS, true);
        let off = read(&mut bench.core, SCTLR);
        bench.core.state.r[0] = off;
        bench.core.state.r[2] = off | mask(sctlr::M);
        bench.core.state.r[15] = at;
        bench.run(8);
        assert_eq!(bench.raised(), Some((Exception::PrefetchAbort, at + 4)));
    }

    /// B5.2.1: a page is inline only for what the MPU lets through at the privilege that made the
    /// access, and that's forgotten when the privilege changes.
    #[test]
    fn a_page_is_inline_only_for_the_privilege_that_reached_it() {
        // LDR r0, [r4] then STR r0, [r4], twice.
        let mut bench = protected(&[0xE594_0000, 0xE584_0000, 0xE594_0000, 0xEAFF_FFFE]);
        region(&mut bench.core, 2, RAM, 12, 0, USER_READS, false);
        bench.core.state.r[4] = RAM;
        bench.run(3);
        assert_eq!(bench.core.inline(RAM), Inline::Both);
        bench.core.state.set_mode(Mode::User);
        bench.core.state.r[15] = CODE;
        bench.run(1);
        assert_eq!(bench.core.inline(RAM), Inline::Reads);
        bench.run(1);
        assert_eq!(bench.raised(), Some((Exception::DataAbort, CODE + 4)));
    }
}
