// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The system control coprocessor, DDI 0406C B5.8 and B6.1 and DDI 0460D chapter 4, with the
//! performance monitors of DDI 0460D chapter 6, as the Cortex-R5F r1p2 has them on this part.
//!
//! Every register DDI 0460D Table 4-2 lists answers here, the MPU's region registers with the
//! [`super::mpu`] they program. B5.6.2's rules hold: an
//! unallocated primary register is UNDEFINED, and so is an encoding Table 4-2 calls Undefined in
//! an allocated one, the R5's choice for what B5.6.2 leaves UNPREDICTABLE. User mode reaches only
//! what the table gives it. An `MCR` to a read-only register, which B5.6.2 makes UNPREDICTABLE,
//! changes nothing, and an `MRC` of a write-only one reads zero.
//!
//! The identification registers hold DDI 0460D's values for the [`Options`] the part chose. What
//! they don't settle is inferred, and says so where it's set.
//!
//! The caches aren't modeled, since the emulator's memory has none, so a maintenance operation is
//! accepted and does nothing. The barrier operations end their block as the instructions do.
//!
//! **The PMU's events.** The counters count what the core sees: instructions, cycles at one an
//! instruction, the core's own rate, exceptions taken and returned from, `CONTEXTIDR` writes,
//! software increments, and the errors the AXI master's bus ECC finds, which are the only
//! correctable and fatal events here. Every other event of Table 6-1 never happens here, and a
//! counter set to one stays where it is:
//!
//! | Events | Why they don't count |
//! |---|---|
//! | 0x01, 0x03, 0x04, 0x42, 0x43, 0x50 to 0x52, 0x55 to 0x59, 0x72, 0x73 | No cache, store buffer or AXI master is modeled |
//! | 0x06, 0x07, 0x0C to 0x10, 0x12, 0x53, 0x5D | Each needs a count from inside a translated block, which the core doesn't keep |
//! | 0x40, 0x41, 0x44, 0x45, 0x54, 0x46, 0x47 | No stall or masked cycle is counted, since the core runs an instruction a cycle |
//! | 0x5A to 0x5E | Nothing is dual-issued |
//! | 0x48, 0x49 | No ETM is modeled |
//! | 0x4A to 0x4F, 0x60 to 0x6D | No cache or TCM is modeled, so none has a parity or ECC error |
//!
//! `PMCR.X` exports the bus ECC's events to the part, which hears of each with the read that found
//! it, 6.4. Nothing else on the event bus reaches the part. The overflow flags are kept and the
//! interrupt enables with them, and the overflow interrupt, nPMUIRQ, has no way to the part's
//! interrupt controller yet.

use serde::{Deserialize, Serialize};

use super::family::{Family, MpuRegions, Options, SystemRegister};
use super::mpu::Mpu;
use super::registers::{
    actlr, afsr, auxiliary, build2, cache, ccsidr, cflr, counters, cpacr, fpexc, fsr, mpuir, pmcr,
    pmu, region, sctlr, slave_port,
};
use crate::cpu::armv7::registers::{get, is_set, mask, set};

/// `MIDR`, DDI 0460D Table 4-3: ARM, r1p2, the Cortex-R5, the revision DDI 0460D
/// documents, inferred.
const MIDR: u32 = 0x411F_C152;
/// `CTR`, Table 4-4: eight-word lines in both caches.
const CTR: u32 = 0x8003_C003;
/// `TCMTR`, Table 4-5, which always reports one ATCM and one BTCM.
const TCMTR: u32 = 0x0001_0001;
/// `MPIDR`, Table 4-7: from r1p0 a uniprocessor's, CPU0 of group 0. The group is the `GROUPID`
/// input, inferred zero.
const MPIDR: u32 = 0xC000_0000;
/// `ID_PFR0` to `ID_MMFR3`, Table 4-2.
const FEATURES: [u32; 8] = [
    0x0000_0131,
    0x0000_0001,
    0x0001_0400,
    0,
    0x0021_0030,
    0,
    0x0120_0000,
    0x0000_0211,
];
/// `ID_ISAR0` to `ID_ISAR5`, Table 4-2, with Table 4-15's divide field for r1p0 on: `SDIV` and
/// `UDIV` in both instruction sets. `ID_ISAR6` and `ID_ISAR7` read as zero.
const INSTRUCTION_SETS: [u32; 8] = [
    0x0210_1111,
    0x1311_2111,
    0x2123_2131,
    0x0111_2131,
    0x0001_0142,
    0,
    0,
    0,
];
/// `CCSIDR` of any size, Table 4-21: write-through, write-back, read and write allocation, four
/// ways and eight-word lines.
const CCSIDR_BUT_ITS_SETS: u32 = 0xF000_0019;
/// The bytes of a set, four ways of a 32-byte line.
const SET_BYTES: u32 = 4 * 32;
/// `CLIDR`'s level of unification and of coherency with caches implemented, Table 4-22. `LoUIS`
/// is inferred zero.
const CACHE_LEVEL_2: u32 = 0b001;
/// `CLIDR`'s level 1: an instruction cache and a data cache.
const SEPARATE_CACHES: u32 = 0b011;
/// `ACTLR`'s reset value, Table 4-25: `CEC` 0b100, and the TCM enables low, as with no TCMs,
/// inferred.
const ACTLR_RESET: u32 = set(actlr::CEC, 0, 0b100);
/// `ACTLR`'s bit 18, which is SBZ.
const ACTLR_WRITABLE: u32 = !mask(actlr::SBZ_18);
/// The secondary `ACTLR`'s reset value, Table 4-26: `DCHE` set, and the TCM read-modify-write
/// enables low, inferred.
const AUXILIARY_RESET: u32 = mask(auxiliary::DCHE);
/// The secondary `ACTLR`'s fields, bits 22 to 16, 13 to 8 and 3 to 0.
const AUXILIARY_WRITABLE: u32 =
    mask(auxiliary::CONTROLS) | mask(auxiliary::FPU_OUTPUTS) | mask(auxiliary::TCM);
/// `DFSR`'s fields, Table 4-29: `SD`, `RW`, `S` and `Status`.
const DFSR_WRITABLE: u32 = IFSR_WRITABLE | mask(fsr::RW);
/// `IFSR`'s, Table 4-30: `SD`, `S` and `Status`.
const IFSR_WRITABLE: u32 = mask(fsr::SD) | mask(fsr::S) | mask(fsr::STATUS);
/// `ADFSR`'s and `AIFSR`'s, Table 4-31: `CacheWay`, `Side`, `Recoverable error`, `SideExt` and
/// `Index`.
const AUXILIARY_FSR_WRITABLE: u32 = mask(afsr::SOURCE) | mask(afsr::INDEX);
/// The Slave Port Control Register's two bits, Table 4-45.
const SLAVE_PORT_WRITABLE: u32 = mask(slave_port::CONTROL);
/// `CFLR`'s fields in either of its layouts, Tables 4-56 and 4-57.
const CFLR_WRITABLE: u32 =
    mask(cflr::WAY) | mask(cflr::SIDE) | mask(cflr::ADDRESS) | mask(cflr::TYPE);
/// The event counters, Table 6-2's `N`.
const COUNTERS: usize = 3;
/// `PMCR`'s identification, Table 6-2.
const PMU_IMPLEMENTER: u32 = 0x41;
const PMU_IDCODE: u32 = 0x15;
/// The cycles `PMCR.D` counts once.
const CYCLES_PER_TICK: u64 = 64;

/// Table 6-1's events the model counts.
const SOFTWARE_INCREMENT: u32 = 0x00;
const INSTRUCTIONS: u32 = 0x08;
const EXCEPTIONS_TAKEN: u32 = 0x09;
const EXCEPTION_RETURNS: u32 = 0x0A;
const CONTEXT_CHANGES: u32 = 0x0B;
const CORRECTABLE: u32 = 0x6E;
const FATAL: u32 = 0x6F;
const BUS_CORRECTABLE: u32 = 0x70;
const BUS_FATAL: u32 = 0x71;
const CYCLES: u32 = 0x11;
const ALSO_CYCLES: u32 = 0xFF;

/// One counter: its value when last brought up to date, and the total of its event then.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
struct Counter {
    value: u32,
    base: u64,
}

/// The performance monitors, DDI 0460D 6.3. A counter is brought up to date from the totals of its
/// event whenever anything reads or changes it, so it counts nothing while it's off.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Pmu {
    /// `PMCR`'s `DP`, `X`, `D` and `E`.
    control: u32,
    /// `PMCNTENSET`, `PMOVSR` and `PMINTENSET`, in their layout.
    enabled: u32,
    overflowed: u32,
    interrupts: u32,
    /// `PMSELR` and `PMUSERENR`.
    selected: u32,
    user: u32,
    /// `PMXEVTYPER0` to `PMXEVTYPER2`.
    types: [u32; COUNTERS],
    events: [Counter; COUNTERS],
    cycles: Counter,
    /// How many exceptions the core has taken, returned from, and `CONTEXTIDR` writes made.
    pub(crate) taken: u64,
    pub(crate) returned: u64,
    context_changes: u64,
    /// How many words the bus ECC corrected, and found uncorrectable.
    pub(crate) bus_corrected: u64,
    pub(crate) bus_fatal: u64,
}

/// What CP15 keeps beyond `SCTLR` and the fault registers.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct System {
    csselr: u32,
    actlr: u32,
    /// The secondary `ACTLR`, Table 4-26.
    auxiliary: u32,
    cpacr: u32,
    /// The BTCM's and the ATCM's region registers' base addresses, 4.3.23 and 4.3.24.
    btcm: u32,
    atcm: u32,
    slave_port: u32,
    contextidr: u32,
    /// `TPIDRURW`, `TPIDRURO` and `TPIDRPRW`, 4.3.29.
    thread_ids: [u32; 3],
    /// The validation registers' IRQ, FIQ, reset and debug request enables, 4.3.30.
    validation: [u32; 4],
    cflr: u32,
    /// The enables of the peripheral interface regions: the AXI port's, the virtual AXI port's and
    /// the AHB port's, 4.3.34.
    ports: [bool; 3],
    pub(crate) pmu: Pmu,
    pub(crate) mpu: Mpu,
}

impl Default for System {
    /// What a reset leaves, Table 4-2. Where a reset value is UNPREDICTABLE it's zero.
    fn default() -> Self {
        Self {
            csselr: 0,
            actlr: ACTLR_RESET,
            auxiliary: AUXILIARY_RESET,
            cpacr: mask(cpacr::ASEDIS) | mask(cpacr::D32DIS),
            btcm: 0,
            atcm: 0,
            slave_port: 0,
            contextidr: 0,
            thread_ids: [0; 3],
            validation: [0; 4],
            cflr: 0,
            ports: [true, false, false],
            pmu: Pmu::default(),
            mpu: Mpu::default(),
        }
    }
}

/// `SCTLR`'s bits that read as one, Figure 4-27.
pub(crate) fn sctlr_ones() -> u32 {
    [
        sctlr::SBO_23_22,
        sctlr::FI,
        sctlr::SBO_18,
        sctlr::SBO_16,
        sctlr::Z,
        sctlr::SBO_6_3,
    ]
    .into_iter()
    .fold(0, |value, field| value | mask(field))
}

/// `SCTLR`'s bits an `MCR` writes, Table 4-24. `IE` and `NMFI` are the part's.
fn sctlr_writable() -> u32 {
    [
        sctlr::TE,
        sctlr::EE,
        sctlr::VE,
        sctlr::DZ,
        sctlr::BR,
        sctlr::RR,
        sctlr::V,
        sctlr::I,
        sctlr::SW,
        sctlr::C,
        sctlr::A,
        sctlr::M,
    ]
    .into_iter()
    .fold(0, |value, field| value | mask(field))
}

/// Build Options 2, Table 4-59, from the part's `options`. The FPU, a single CPU, big-endian
/// instructions supported and no split-lock logic, AHB port or TCM error cache are inferred.
fn build_options_2(options: Options) -> u32 {
    let regions = match options.mpu_regions {
        MpuRegions::Twelve => 0b10,
        MpuRegions::Sixteen => 0b11,
    };
    let no_tcms = u32::from(!options.tcms);
    [
        (build2::LOCK_STEP, u32::from(options.lock_step)),
        (build2::MPU_REGIONS, regions),
        (
            build2::BREAK_POINTS,
            u32::from(options.breakpoints.get()) - 1,
        ),
        (
            build2::WATCH_POINTS,
            u32::from(options.watchpoints.get()) - 1,
        ),
        (build2::NO_A_TCM_INF, no_tcms),
        (build2::NO_B0_TCM_INF, no_tcms),
        (build2::NO_B1_TCM_INF, no_tcms),
        (build2::ICACHE_ES, options.cache_error_schemes[0]),
        (build2::DCACHE_ES, options.cache_error_schemes[1]),
        (
            build2::NO_HARD_ERROR_CACHE,
            u32::from(!options.hard_error_cache),
        ),
        (
            build2::AXI_BUS_ECC,
            u32::from(options.axi_bus_ecc.is_some()),
        ),
        (build2::MICRO_SCU, u32::from(options.acp)),
    ]
    .into_iter()
    .fold(0, |value, (field, to)| set(field, value, to))
}

/// Whether an `MCR` with `(opc1, CRn, CRm, opc2)` is one of 4.3.22's cache maintenance operations
/// on c7 and c15, rather than a barrier or a NOP.
fn maintains_a_cache(register: (u32, u32, u32, u32)) -> bool {
    matches!(
        register,
        (0, 7, 5, 0 | 1) | (0, 7, 6 | 10 | 14, 1 | 2) | (0, 7, 11, 1) | (0, 15, 5, 0)
    )
}

impl Pmu {
    /// The running total of `event` with `instructions` retired, or `None` for an event with no
    /// total, which a counter counts only by software increment or not at all.
    fn total(&self, event: u32, instructions: u64) -> Option<u64> {
        match event {
            INSTRUCTIONS | CYCLES | ALSO_CYCLES => Some(instructions),
            EXCEPTIONS_TAKEN => Some(self.taken),
            EXCEPTION_RETURNS => Some(self.returned),
            CONTEXT_CHANGES => Some(self.context_changes),
            CORRECTABLE | BUS_CORRECTABLE => Some(self.bus_corrected),
            FATAL | BUS_FATAL => Some(self.bus_fatal),
            _ => None,
        }
    }

    /// The totals that move with no access to the PMU: the exceptions taken, the exception
    /// returns and the `CONTEXTIDR` writes.
    pub(crate) fn totals(&self) -> [u64; 3] {
        [self.taken, self.returned, self.context_changes]
    }

    pub(crate) fn set_totals(&mut self, [taken, returned, context_changes]: [u64; 3]) {
        self.taken = taken;
        self.returned = returned;
        self.context_changes = context_changes;
    }

    /// Whether `PMCR.X` exports the events to the event bus, 6.4.
    pub(crate) fn exports(&self) -> bool {
        is_set(pmcr::X, self.control)
    }

    /// `PMCR` as it reads.
    fn pmcr(&self) -> u32 {
        let identity = [
            (pmcr::IMP, PMU_IMPLEMENTER),
            (pmcr::IDCODE, PMU_IDCODE),
            (pmcr::N, u32::try_from(COUNTERS).expect("three counters")),
        ];
        identity
            .into_iter()
            .fold(self.control, |value, (field, to)| set(field, value, to))
    }

    /// Whether the counter of `bit`, in the enables' layout, counts now.
    fn counting(&self, bit: u32) -> bool {
        is_set(pmcr::E, self.control) && self.enabled & bit != 0
    }

    /// Brings every counter up to date with `instructions` retired, setting the overflow flag of
    /// each that wrapped, 6.3.4.
    fn catch_up(&mut self, instructions: u64) {
        for index in 0..COUNTERS {
            let bit = mask(counters::EACH[index]);
            let total = self.total(self.types[index], instructions);
            let counting = self.counting(bit);
            let counter = &mut self.events[index];
            if let Some(total) = total {
                if counting {
                    let (value, wrapped) = add(counter.value, total - counter.base);
                    counter.value = value;
                    if wrapped {
                        self.overflowed |= bit;
                    }
                }
                counter.base = total;
            }
        }
        let bit = mask(counters::C);
        let ticks = |cycles: u64, divided: bool| {
            if divided {
                cycles / CYCLES_PER_TICK
            } else {
                cycles
            }
        };
        let divided = is_set(pmcr::D, self.control);
        if self.counting(bit) {
            let elapsed = ticks(instructions, divided) - ticks(self.cycles.base, divided);
            let (value, wrapped) = add(self.cycles.value, elapsed);
            self.cycles.value = value;
            if wrapped {
                self.overflowed |= bit;
            }
        }
        self.cycles.base = instructions;
    }
}

/// `value` with `more` added in 32 bits, and whether it wrapped past the top.
fn add(value: u32, more: u64) -> (u32, bool) {
    let sum = u64::from(value) + more;
    let low = u32::try_from(sum & u64::from(u32::MAX)).expect("masked to 32 bits");
    (low, sum > u64::from(u32::MAX))
}

impl Family {
    /// B1.11.1's `CheckVFPEnabled(include_fpexc)` on a core without the Security and
    /// Virtualization Extensions: whether `CPACR` grants CP10 and CP11 at the current privilege
    /// and, when `include_fpexc`, `FPEXC.EN` is set. Grants that differ, or the reserved `0b10`,
    /// are UNPREDICTABLE, and refused here, the simplest outcome the pseudocode allows.
    pub(crate) fn fp_enabled(&self, include_fpexc: bool) -> bool {
        let cpacr = self.system.cpacr;
        let cp10 = get(cpacr::CP10, cpacr);
        let granted = cp10 == get(cpacr::CP11, cpacr)
            && match cp10 {
                0b01 => self.state.privileged(),
                0b11 => true,
                _ => false,
            };
        granted && (!include_fpexc || is_set(fpexc::EN, self.state.fpexc))
    }

    /// `register`'s value as an `MRC` reads it with `instructions` retired before it, or `None`
    /// where it's UNDEFINED.
    #[expect(
        clippy::match_same_arms,
        reason = "each arm is a register of its own, cited on its own"
    )]
    pub(crate) fn cp15_read(&mut self, register: SystemRegister, instructions: u64) -> Option<u32> {
        let SystemRegister {
            opc1,
            crn,
            crm,
            opc2,
        } = register;
        let privileged = self.state.privileged();
        let user_pmu = is_set(pmu::EN, self.system.pmu.user);
        let options = self.options();
        let system = &mut self.system;
        let value = match (opc1, crn, crm, opc2) {
            // TPIDRURW and TPIDRURO, which User mode reads, 4.3.29.
            (0, 13, 0, 2 | 3) => system.thread_ids[opc2 as usize - 2],
            // PMUSERENR, readable in any mode, 6.3.10.
            (0, 9, 14, 0) => system.pmu.user,
            (0, 9, 12 | 13, _) | (0, 15, 1, _) if privileged || user_pmu => {
                self.read_pmu_or_validation(crn, crm, opc2, instructions)?
            }
            _ if !privileged => return None,
            (0, 0, 0, 1) => CTR,
            (0, 0, 0, 2) => TCMTR,
            (0, 0, 0, 4) => set(mpuir::DREGION, 0, options.mpu_regions.count()),
            (0, 0, 0, 5) => MPIDR,
            // An unimplemented identification register reads as MIDR, 4.3.2.
            (0, 0, 0, _) => MIDR,
            (0, 0, 1, _) => FEATURES[opc2 as usize],
            (0, 0, 2, _) => INSTRUCTION_SETS[opc2 as usize],
            (0, 0, 3..=7, _) => 0,
            (1, 0, 0, 0) => {
                let kb = if is_set(cache::IND, system.csselr) {
                    options.instruction_cache_kb
                } else {
                    options.data_cache_kb
                };
                set(
                    ccsidr::NUM_SETS,
                    CCSIDR_BUT_ITS_SETS,
                    kb * 1024 / SET_BYTES - 1,
                )
            }
            (1, 0, 0, 1) => {
                let value = set(cache::LOU, 0, CACHE_LEVEL_2);
                let value = set(cache::LOC, value, CACHE_LEVEL_2);
                set(cache::CL1, value, SEPARATE_CACHES)
            }
            (1, 0, 0, 7) => 0,
            (2, 0, 0, 0) => system.csselr,
            (0, 1, 0, 0) => self.sctlr,
            (0, 1, 0, 1) => system.actlr,
            (0, 1, 0, 2) => system.cpacr,
            (0, 5, 0, 0) => self.faults.dfsr,
            (0, 5, 0, 1) => self.faults.ifsr,
            (0, 5, 1, 0) => self.faults.adfsr,
            (0, 5, 1, 1) => self.faults.aifsr,
            (0, 6, 0, 0) => self.faults.dfar,
            (0, 6, 0, 2) => self.faults.ifar,
            (0, 6, 1 | 2, _) => *self.system.mpu.register(crm, opc2)?.0,
            // The TCMs' region registers, 4.3.23 and 4.3.24: no TCM, so no size and no enable.
            (0, 9, 1, 0) => system.btcm,
            (0, 9, 1, 1) => system.atcm,
            // The TCM Selection Register, 4.3.25.
            (0, 9, 2, 0) => 0,
            (0, 9, 14, 1 | 2) => system.pmu.interrupts,
            (0, 11, 0, 0) => system.slave_port,
            // FCSE PID, which the R5 hasn't got, 4.3.27.
            (0, 13, 0, 0) => 0,
            (0, 13, 0, 1) => system.contextidr,
            (0, 13, 0, 4) => system.thread_ids[2],
            (0, 15, 0, 0) => system.auxiliary,
            (0, 15, 0, 1) => {
                let port = options.axi_peripheral;
                let value = set(region::BASE, 0, port.base >> region::BASE.bit);
                let value = set(region::SIZE, value, port.size);
                set(region::ENABLE, value, u32::from(system.ports[0]))
            }
            (0, 15, 0, 2 | 3) => u32::from(system.ports[opc2 as usize - 1]),
            // Build Options 1, Table 4-58: double precision, no peripheral port bus ECC and the
            // TCMs' high address zero, inferred. The Pin Options Register, Table 4-60, with every
            // pin low, inferred.
            (0, 15, 2, 0 | 7) => 0,
            (0, 15, 2, 1) => build_options_2(options),
            (0, 15, 3, 0) => system.cflr,
            // A write-only operation, which B5.6.2 makes UNPREDICTABLE to read.
            (0, 15, 5 | 14, 0) => 0,
            _ => return None,
        };
        Some(value)
    }

    /// Writes `value` to `register` as an `MCR` does with `instructions` retired before it, and
    /// answers whether it's defined.
    #[expect(
        clippy::match_same_arms,
        reason = "each arm is a register of its own, cited on its own"
    )]
    pub(crate) fn cp15_write(
        &mut self,
        register: SystemRegister,
        value: u32,
        instructions: u64,
    ) -> bool {
        let SystemRegister {
            opc1,
            crn,
            crm,
            opc2,
        } = register;
        let privileged = self.state.privileged();
        let user_pmu = is_set(pmu::EN, self.system.pmu.user);
        let encoding = (opc1, crn, crm, opc2);
        // AXISCEN gives the cache RAMs to the AXI slave port, and a maintenance operation is
        // then UNDEFINED, Table 4-25.
        if maintains_a_cache(encoding) && self.system.actlr & AXI_SLAVE_CACHE_ACCESS != 0 {
            return false;
        }
        let system = &mut self.system;
        match encoding {
            (0, 13, 0, 2) => system.thread_ids[0] = value,
            // CP15ISB, CP15DSB and CP15DMB, 4.3.22, which User mode reaches. `MCR` ends its
            // block, as `ISB` does.
            (0, 7, 5, 4) | (0, 7, 10, 4 | 5) => {}
            (0, 9, 12 | 13, _) | (0, 9, 14, 0) | (0, 15, 1, _)
                if privileged || user_pmu && encoding != (0, 9, 14, 0) =>
            {
                return self.write_pmu_or_validation(crn, crm, opc2, value, instructions);
            }
            _ if !privileged => return false,
            (2, 0, 0, 0) => system.csselr = value & mask(cache::IND),
            (0, 1, 0, 0) => {
                let writable = sctlr_writable();
                let was = self.sctlr;
                self.sctlr = self.sctlr & !writable | value & writable;
                let decides = mask(sctlr::M) | mask(sctlr::BR) | mask(sctlr::V);
                if (was ^ self.sctlr) & decides != 0 {
                    self.mpu_changed();
                }
                // With the MPU off, chained blocks and computed exits find a block without the run
                // loop's fetch check, so a block `SCTLR.V` makes execute-never, Table B5-1, has to
                // go.
                if (was ^ self.sctlr) & mask(sctlr::V) != 0 && !is_set(sctlr::M, self.sctlr) {
                    self.drop_translations();
                }
            }
            (0, 1, 0, 1) => system.actlr = value & ACTLR_WRITABLE,
            (0, 1, 0, 2) => {
                let grants = mask(cpacr::CP10) | mask(cpacr::CP11);
                system.cpacr = system.cpacr & !grants | value & grants;
            }
            (0, 5, 0, 0) => self.faults.dfsr = value & DFSR_WRITABLE,
            (0, 5, 0, 1) => self.faults.ifsr = value & IFSR_WRITABLE,
            (0, 5, 1, 0) => self.faults.adfsr = value & AUXILIARY_FSR_WRITABLE,
            (0, 5, 1, 1) => self.faults.aifsr = value & AUXILIARY_FSR_WRITABLE,
            (0, 6, 0, 0) => self.faults.dfar = value,
            (0, 6, 0, 2) => self.faults.ifar = value,
            (0, 6, 1 | 2, _) => {
                let Some((register, writable)) = self.system.mpu.register(crm, opc2) else {
                    return false;
                };
                *register = value & writable;
                // `RGNR` only selects a region.
                if crm == 1 {
                    self.regions_changed = true;
                }
            }
            // NOP, once Wait For Interrupt, the branch predictor's NOPs, and the cache maintenance
            // of 4.3.22, which does nothing with no cache.
            (0, 7, 0, 4) | (0, 7, 5, 6 | 7) | (0, 7, 13, 1) => {}
            _ if maintains_a_cache(encoding) => {}
            (0, 9, 1, 0) => system.btcm = value & mask(region::BASE),
            (0, 9, 1, 1) => system.atcm = value & mask(region::BASE),
            (0, 9, 2, 0) | (0, 13, 0, 0) => {}
            (0, 9, 14, 1) => system.pmu.interrupts |= value & PMU_COUNTERS,
            (0, 9, 14, 2) => system.pmu.interrupts &= !(value & PMU_COUNTERS),
            (0, 11, 0, 0) => system.slave_port = value & SLAVE_PORT_WRITABLE,
            (0, 13, 0, 1) => {
                system.contextidr = value;
                system.pmu.context_changes += 1;
            }
            (0, 13, 0, 3 | 4) => system.thread_ids[opc2 as usize - 2] = value,
            (0, 15, 0, 0) => system.auxiliary = value & AUXILIARY_WRITABLE,
            (0, 15, 0, 1..=3) => system.ports[opc2 as usize - 1] = is_set(region::ENABLE, value),
            // The cache size override, which can only pick a size the RAMs were built for,
            // 4.3.30, and the options registers, which an `MCR` leaves alone, B5.6.2.
            (0, 15, 14, 0) | (0, 15, 2, 0 | 1 | 7) => {}
            (0, 15, 3, 0) => system.cflr = value & CFLR_WRITABLE,
            // The identification registers, read-only, B5.6.2.
            (0, 0, 0..=7, _) | (1, 0, 0, 0 | 1 | 7) => {}
            _ => return false,
        }
        true
    }

    /// A performance monitor register, c9's c12 and c13, or a validation register, c15's c1,
    /// read with `instructions` retired, 6.3 and 4.3.30.
    fn read_pmu_or_validation(
        &mut self,
        crn: u32,
        crm: u32,
        opc2: u32,
        instructions: u64,
    ) -> Option<u32> {
        let pmu = &mut self.system.pmu;
        pmu.catch_up(instructions);
        let selected = pmu.selected as usize;
        Some(match (crn, crm, opc2) {
            (9, 12, 0) => pmu.pmcr(),
            (9, 12, 1 | 2) => pmu.enabled,
            (9, 12, 3) => pmu.overflowed,
            // PMSWINC, write-only, reads as zero.
            (9, 12, 4) => 0,
            (9, 12, 5) => pmu.selected,
            (9, 13, 0) => pmu.cycles.value,
            // PMSELR past the counters, which 6.3.6 makes UNPREDICTABLE, reaches none and reads
            // zero.
            (9, 13, 1) => pmu.types.get(selected).copied().unwrap_or(0),
            (9, 13, 2) => pmu.events.get(selected).map_or(0, |counter| counter.value),
            (15, 1, _) => self.system.validation[opc2 as usize % 4],
            _ => return None,
        })
    }

    /// Writes a performance monitor register or a validation register, and answers whether it's
    /// defined.
    #[expect(
        clippy::too_many_arguments,
        reason = "the register's three numbers, the value and the count are each the write's"
    )]
    fn write_pmu_or_validation(
        &mut self,
        crn: u32,
        crm: u32,
        opc2: u32,
        value: u32,
        instructions: u64,
    ) -> bool {
        let pmu = &mut self.system.pmu;
        pmu.catch_up(instructions);
        let selected = pmu.selected as usize;
        let chosen = value & PMU_COUNTERS;
        match (crn, crm, opc2) {
            (9, 12, 0) => {
                let kept = mask(pmcr::DP) | mask(pmcr::X) | mask(pmcr::D) | mask(pmcr::E);
                pmu.control = value & kept;
                if is_set(pmcr::C, value) {
                    pmu.cycles.value = 0;
                }
                if is_set(pmcr::P, value) {
                    for counter in &mut pmu.events {
                        counter.value = 0;
                    }
                }
            }
            (9, 12, 1) => pmu.enabled |= chosen,
            (9, 12, 2) => pmu.enabled &= !chosen,
            (9, 12, 3) => pmu.overflowed &= !chosen,
            (9, 12, 4) => {
                for index in 0..COUNTERS {
                    let bit = mask(counters::EACH[index]);
                    let counting = pmu.counting(bit);
                    // 6.3.5: an increment of a counter set to another event is UNPREDICTABLE,
                    // and changes nothing.
                    if value & bit != 0 && counting && pmu.types[index] == SOFTWARE_INCREMENT {
                        let (counted, wrapped) = add(pmu.events[index].value, 1);
                        pmu.events[index].value = counted;
                        if wrapped {
                            pmu.overflowed |= bit;
                        }
                    }
                }
            }
            (9, 12, 5) => pmu.selected = value & SELECT,
            (9, 13, 0) => pmu.cycles.value = value,
            (9, 13, 1) => {
                if let Some(event) = pmu.types.get_mut(selected) {
                    *event = value & EVENT;
                    // The new event's total starts where it stands, and an event with none, a
                    // software increment's, starts from nothing.
                    let event = *event;
                    pmu.events[selected].base = pmu.total(event, instructions).unwrap_or(0);
                }
            }
            (9, 13, 2) => {
                if let Some(counter) = pmu.events.get_mut(selected) {
                    counter.value = value;
                }
            }
            (9, 14, 0) => pmu.user = value & 1,
            // The set and clear pairs of the validation registers, 4.3.30.
            (15, 1, _) => {
                let enables = &mut self.system.validation[opc2 as usize % 4];
                if opc2 < 4 {
                    *enables |= chosen;
                } else {
                    *enables &= !chosen;
                }
            }
            _ => return false,
        }
        // A change of enables or of `D` counts from here on.
        self.system.pmu.catch_up(instructions);
        true
    }
}

/// The counters' bits, the cycle counter's and the three event counters'.
const PMU_COUNTERS: u32 = mask(counters::C) | mask(counters::P);
/// `PMSELR.SEL`, Table 6-7.
const SELECT: u32 = mask(pmu::COUNTER);
/// `PMXEVTYPER.SEL`, Table 6-8.
const EVENT: u32 = mask(pmu::EVENT);
/// `ACTLR.AXISCEN`, Table 4-25.
const AXI_SLAVE_CACHE_ACCESS: u32 = mask(actlr::AXISCEN);

#[cfg(test)]
mod tests {
    use super::super::state::Mode;
    use super::super::translate::testing::ties;
    use super::*;
    use crate::soc::Endian;

    fn register(opc1: u32, crn: u32, crm: u32, opc2: u32) -> SystemRegister {
        SystemRegister {
            opc1,
            crn,
            crm,
            opc2,
        }
    }

    /// Table 4-2: the identification registers' values, `MIDR` again for an unimplemented one,
    /// and the control registers' reset values, each UNDEFINED from User mode, B5.6.2.
    #[test]
    fn every_register_reads_its_reset_value_and_user_mode_reaches_none() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        for (opc1, crn, crm, opc2, value) in [
            (0, 0, 0, 0, 0x411F_C152),
            (0, 0, 0, 1, 0x8003_C003),
            (0, 0, 0, 2, 0x0001_0001),
            (0, 0, 0, 4, 0x0000_0C00),
            (0, 0, 0, 5, 0xC000_0000),
            (0, 0, 0, 7, 0x411F_C152),
            (0, 0, 1, 0, 0x0000_0131),
            (0, 0, 2, 0, 0x0210_1111),
            (1, 0, 0, 0, 0xF01F_E019),
            (1, 0, 0, 1, 0x0900_0003),
            (0, 1, 0, 1, 0x0000_0020),
            (0, 1, 0, 2, 0xC000_0000),
            (0, 9, 1, 0, 0),
            (0, 9, 12, 0, 0x4115_1800),
            (0, 15, 0, 0, 0x0040_0000),
        ] {
            let at = register(opc1, crn, crm, opc2);
            assert_eq!(core.cp15_read(at, 0), Some(value), "{at:?}");
        }
        assert!(core.cp15_write(register(2, 0, 0, 0), mask(cache::IND), 0));
        assert_eq!(
            core.cp15_read(register(1, 0, 0, 0), 0),
            Some(0xF00F_E019),
            "the 16 KB instruction cache"
        );
        core.state.set_mode(Mode::User);
        assert_eq!(core.cp15_read(register(0, 0, 0, 0), 0), None);
        assert!(!core.cp15_write(register(0, 1, 0, 2), u32::MAX, 0));
    }

    /// B5.6.2: an unallocated primary register is UNDEFINED, and so is an encoding Table 4-2
    /// calls Undefined, a read of c7 among them and c6's beside the MPU's registers.
    #[test]
    fn an_unallocated_or_undefined_encoding_is_undefined() {
        let mut core = Family::new(ties(Endian::Big)).unwrap();
        for at in [
            register(0, 2, 0, 0),
            register(0, 7, 5, 0),
            register(0, 6, 1, 1),
            register(0, 6, 2, 1),
            register(0, 1, 0, 3),
            register(0, 0, 8, 0),
        ] {
            assert_eq!(core.cp15_read(at, 0), None, "{at:?}");
        }
        assert!(!core.cp15_write(register(0, 7, 1, 0), 0, 0));
        assert!(core.cp15_write(register(0, 7, 5, 0), 0, 0), "ICIALLU");
    }

    /// 4.3.19 and 4.3.20: `CPACR` keeps only `cp10` and `cp11`, and the fault registers keep
    /// their fields.
    #[test]
    fn a_write_keeps_only_the_writable_fields() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        for (at, kept) in [
            (register(0, 1, 0, 2), 0xC0F0_0000),
            (register(0, 5, 0, 0), 0x0000_1C0F),
            (register(0, 5, 0, 1), 0x0000_140F),
            (register(0, 6, 0, 0), u32::MAX),
        ] {
            assert!(core.cp15_write(at, u32::MAX, 0), "{at:?}");
            assert_eq!(core.cp15_read(at, 0), Some(kept), "{at:?}");
        }
    }

    /// 6.3.1, 6.3.2 and 6.3.7: with `PMCR.E` and the cycle counter enabled, `PMCCNTR` counts a
    /// cycle an instruction from the write, and every 64 with `PMCR.D`.
    #[test]
    fn the_cycle_counter_counts_the_instructions_since_it_was_enabled() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        let cycles = register(0, 9, 13, 0);
        assert!(core.cp15_write(register(0, 9, 12, 1), mask(counters::C), 100));
        assert!(core.cp15_write(register(0, 9, 12, 0), mask(pmcr::E), 100));
        assert_eq!(core.cp15_read(cycles, 250), Some(150));
        assert!(core.cp15_write(register(0, 9, 12, 0), mask(pmcr::E) | mask(pmcr::D), 250));
        assert_eq!(core.cp15_read(cycles, 250 + 128), Some(152));
        core.state.set_mode(Mode::User);
        assert_eq!(core.cp15_read(cycles, 400), None, "PMUSERENR.EN is clear");
    }

    /// 6.3.6: a counter switched to another event while it runs keeps its count and counts the
    /// new event from the switch, through a software increment and back.
    #[test]
    fn a_running_counter_switched_to_another_event_counts_it_from_the_switch() {
        let mut core = Family::new(ties(Endian::Little)).unwrap();
        let (count, event) = (register(0, 9, 13, 2), register(0, 9, 13, 1));
        assert!(core.cp15_write(register(0, 9, 12, 5), 0, 0));
        assert!(core.cp15_write(event, INSTRUCTIONS, 0));
        assert!(core.cp15_write(register(0, 9, 12, 1), 1, 100));
        assert!(core.cp15_write(register(0, 9, 12, 0), mask(pmcr::E), 100));
        assert_eq!(core.cp15_read(count, 200), Some(100));
        assert!(core.cp15_write(event, EXCEPTIONS_TAKEN, 300));
        core.system.pmu.taken += 2;
        assert_eq!(core.cp15_read(count, 400), Some(202));
        assert!(core.cp15_write(event, SOFTWARE_INCREMENT, 400));
        assert!(core.cp15_write(event, INSTRUCTIONS, 500));
        assert_eq!(core.cp15_read(count, 600), Some(302));
    }
}
