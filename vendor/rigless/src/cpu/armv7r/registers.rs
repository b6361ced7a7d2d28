// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The bit fields of the R profile's registers the core answers itself, by hand from ARM DDI 0406C.
//!
//! A part's SVD doesn't describe the core, so nothing generates these. Each table carries a field's
//! position, width and the access the manual gives it, and a field is named as the manual spells
//! it.

use crate::soc::{Access, FieldSpec};

/// The CPSR's and the SPSRs' fields, B1.3.3. `J`, bit 24, is left out. B1.8.10 lets a core with
/// neither Jazelle state nor the Thumb Execution Environment read it as zero in every PSR and
/// ignore writes to it.
pub(crate) mod cpsr {
    use super::{Access, FieldSpec};
    pub(crate) const N: &FieldSpec = &FieldSpec::new("N", 31, 1, Access::ReadWrite);
    pub(crate) const Z: &FieldSpec = &FieldSpec::new("Z", 30, 1, Access::ReadWrite);
    pub(crate) const C: &FieldSpec = &FieldSpec::new("C", 29, 1, Access::ReadWrite);
    pub(crate) const V: &FieldSpec = &FieldSpec::new("V", 28, 1, Access::ReadWrite);
    pub(crate) const Q: &FieldSpec = &FieldSpec::new("Q", 27, 1, Access::ReadWrite);
    pub(crate) const IT_1_0: &FieldSpec = &FieldSpec::new("IT[1:0]", 25, 2, Access::ReadWrite);
    pub(crate) const GE: &FieldSpec = &FieldSpec::new("GE[3:0]", 16, 4, Access::ReadWrite);
    pub(crate) const IT_7_2: &FieldSpec = &FieldSpec::new("IT[7:2]", 10, 6, Access::ReadWrite);
    pub(crate) const E: &FieldSpec = &FieldSpec::new("E", 9, 1, Access::ReadWrite);
    pub(crate) const A: &FieldSpec = &FieldSpec::new("A", 8, 1, Access::ReadWrite);
    pub(crate) const I: &FieldSpec = &FieldSpec::new("I", 7, 1, Access::ReadWrite);
    pub(crate) const F: &FieldSpec = &FieldSpec::new("F", 6, 1, Access::ReadWrite);
    pub(crate) const T: &FieldSpec = &FieldSpec::new("T", 5, 1, Access::ReadWrite);
    pub(crate) const M: &FieldSpec = &FieldSpec::new("M[4:0]", 0, 5, Access::ReadWrite);
}

/// `SCTLR`'s fields, DDI 0406C B6.1.86 and DDI 0460D 4.3.16, Table 4-24.
pub(crate) mod sctlr {
    use super::{Access, FieldSpec};
    /// Instruction endianness, which the part ties, DDI 0460D 3.11.
    pub(crate) const IE: &FieldSpec = &FieldSpec::new("IE", 31, 1, Access::ReadOnly);
    /// Thumb exception enable, whose reset value the part ties.
    pub(crate) const TE: &FieldSpec = &FieldSpec::new("TE", 30, 1, Access::ReadWrite);
    /// Non-maskable FIQs, which the part ties.
    pub(crate) const NMFI: &FieldSpec = &FieldSpec::new("NMFI", 27, 1, Access::ReadOnly);
    /// Exception endianness, whose reset value the part ties.
    pub(crate) const EE: &FieldSpec = &FieldSpec::new("EE", 25, 1, Access::ReadWrite);
    /// IRQ handlers' addresses from the VIC port, DDI 0460D 3.8.3.
    pub(crate) const VE: &FieldSpec = &FieldSpec::new("VE", 24, 1, Access::ReadWrite);
    /// Should be one, with `FI`, Figure 4-27.
    pub(crate) const SBO_23_22: &FieldSpec = &FieldSpec::new("SBO", 22, 2, Access::ReadOnly);
    /// Fast interrupts, always enabled.
    pub(crate) const FI: &FieldSpec = &FieldSpec::new("FI", 21, 1, Access::ReadOnly);
    /// Divide by zero traps.
    pub(crate) const DZ: &FieldSpec = &FieldSpec::new("DZ", 19, 1, Access::ReadWrite);
    pub(crate) const SBO_18: &FieldSpec = &FieldSpec::new("SBO", 18, 1, Access::ReadOnly);
    /// The MPU's background region.
    pub(crate) const BR: &FieldSpec = &FieldSpec::new("BR", 17, 1, Access::ReadWrite);
    pub(crate) const SBO_16: &FieldSpec = &FieldSpec::new("SBO", 16, 1, Access::ReadOnly);
    /// Round-robin replacement, which the caches never use.
    pub(crate) const RR: &FieldSpec = &FieldSpec::new("RR", 14, 1, Access::ReadWrite);
    /// High vectors, whose reset value the part ties, B1.8.1.
    pub(crate) const V: &FieldSpec = &FieldSpec::new("V", 13, 1, Access::ReadWrite);
    /// The instruction cache's enable.
    pub(crate) const I: &FieldSpec = &FieldSpec::new("I", 12, 1, Access::ReadWrite);
    /// Branch prediction, which the R5 always has on.
    pub(crate) const Z: &FieldSpec = &FieldSpec::new("Z", 11, 1, Access::ReadOnly);
    /// `SWP` and `SWPB` enable, which are UNDEFINED while it's clear.
    pub(crate) const SW: &FieldSpec = &FieldSpec::new("SW", 10, 1, Access::ReadWrite);
    pub(crate) const SBO_6_3: &FieldSpec = &FieldSpec::new("SBO", 3, 4, Access::ReadOnly);
    /// The data cache's enable.
    pub(crate) const C: &FieldSpec = &FieldSpec::new("C", 2, 1, Access::ReadWrite);
    /// Alignment checks on every access.
    pub(crate) const A: &FieldSpec = &FieldSpec::new("A", 1, 1, Access::ReadWrite);
    /// The MPU's enable.
    pub(crate) const M: &FieldSpec = &FieldSpec::new("M", 0, 1, Access::ReadWrite);
}

/// `DFSR`'s and `IFSR`'s fields, DDI 0460D 4.3.20, Tables 4-29 and 4-30. `IFSR` has no `RW`.
pub(crate) mod fsr {
    use super::{Access, FieldSpec};
    /// An AXI slave error rather than a decode error, for an external abort.
    pub(crate) const SD: &FieldSpec = &FieldSpec::new("SD", 12, 1, Access::ReadWrite);
    /// A write caused the abort, `DFSR` only.
    pub(crate) const RW: &FieldSpec = &FieldSpec::new("RW", 11, 1, Access::ReadWrite);
    /// The status's fifth bit.
    pub(crate) const S: &FieldSpec = &FieldSpec::new("S", 10, 1, Access::ReadWrite);
    pub(crate) const STATUS: &FieldSpec = &FieldSpec::new("Status", 0, 4, Access::ReadWrite);
}

/// `PMCR`'s fields, DDI 0460D Table 6-2.
pub(crate) mod pmcr {
    use super::{Access, FieldSpec};
    pub(crate) const IMP: &FieldSpec = &FieldSpec::new("IMP", 24, 8, Access::ReadOnly);
    pub(crate) const IDCODE: &FieldSpec = &FieldSpec::new("IDCODE", 16, 8, Access::ReadOnly);
    pub(crate) const N: &FieldSpec = &FieldSpec::new("N", 11, 5, Access::ReadOnly);
    /// Stops `PMCCNTR` where counting is prohibited.
    pub(crate) const DP: &FieldSpec = &FieldSpec::new("DP", 5, 1, Access::ReadWrite);
    /// Exports the events to the event bus, 6.4.
    pub(crate) const X: &FieldSpec = &FieldSpec::new("X", 4, 1, Access::ReadWrite);
    /// Counts every 64th cycle.
    pub(crate) const D: &FieldSpec = &FieldSpec::new("D", 3, 1, Access::ReadWrite);
    /// Resets `PMCCNTR`, and reads as zero.
    pub(crate) const C: &FieldSpec = &FieldSpec::new("C", 2, 1, Access::WriteOnly);
    /// Resets the event counters, and reads as zero.
    pub(crate) const P: &FieldSpec = &FieldSpec::new("P", 1, 1, Access::WriteOnly);
    pub(crate) const E: &FieldSpec = &FieldSpec::new("E", 0, 1, Access::ReadWrite);
}

/// The counters' bits in `PMCNTENSET`, `PMCNTENCLR`, `PMOVSR`, `PMINTENSET`, `PMINTENCLR`,
/// `PMSWINC` and the validation registers, DDI 0460D Tables 6-3 to 6-6 and 4-46.
pub(crate) mod counters {
    use super::{Access, FieldSpec};
    /// The cycle counter's.
    pub(crate) const C: &FieldSpec = &FieldSpec::new("C", 31, 1, Access::ReadWrite);
    /// The event counters', one bit each.
    pub(crate) const P: &FieldSpec = &FieldSpec::new("P", 0, 3, Access::ReadWrite);
    /// Each event counter's own bit of `P`.
    pub(crate) const EACH: [&FieldSpec; 3] = [
        &FieldSpec::new("P0", 0, 1, Access::ReadWrite),
        &FieldSpec::new("P1", 1, 1, Access::ReadWrite),
        &FieldSpec::new("P2", 2, 1, Access::ReadWrite),
    ];
}

/// `CPACR`'s fields, DDI 0460D Table 4-27.
pub(crate) mod cpacr {
    use super::{Access, FieldSpec};
    pub(crate) const ASEDIS: &FieldSpec = &FieldSpec::new("ASEDIS", 31, 1, Access::ReadOnly);
    pub(crate) const D32DIS: &FieldSpec = &FieldSpec::new("D32DIS", 30, 1, Access::ReadOnly);
    pub(crate) const CP11: &FieldSpec = &FieldSpec::new("cp11", 22, 2, Access::ReadWrite);
    pub(crate) const CP10: &FieldSpec = &FieldSpec::new("cp10", 20, 2, Access::ReadWrite);
}

/// `FPEXC`'s fields, DDI 0460D Table 11-6. The rest read as zero.
pub(crate) mod fpexc {
    use super::{Access, FieldSpec};
    pub(crate) const EN: &FieldSpec = &FieldSpec::new("EN", 30, 1, Access::ReadWrite);
    pub(crate) const DEX: &FieldSpec = &FieldSpec::new("DEX", 29, 1, Access::ReadWrite);
}

/// `MVFR0`'s fields, DDI 0460D Table 11-7. The rest, short vectors and trapping, read as zero.
pub(crate) mod mvfr0 {
    use super::{Access, FieldSpec};
    pub(crate) const RM: &FieldSpec = &FieldSpec::new("RM", 28, 4, Access::ReadOnly);
    pub(crate) const SR: &FieldSpec = &FieldSpec::new("SR", 20, 4, Access::ReadOnly);
    pub(crate) const D: &FieldSpec = &FieldSpec::new("D", 16, 4, Access::ReadOnly);
    pub(crate) const DP: &FieldSpec = &FieldSpec::new("DP", 8, 4, Access::ReadOnly);
    pub(crate) const SP: &FieldSpec = &FieldSpec::new("SP", 4, 4, Access::ReadOnly);
    pub(crate) const RB: &FieldSpec = &FieldSpec::new("RB", 0, 4, Access::ReadOnly);
}

/// `CSSELR`'s and `CLIDR`'s fields, DDI 0460D Tables 4-22 and 4-23.
pub(crate) mod cache {
    use super::{Access, FieldSpec};
    /// `CSSELR`: the instruction cache rather than the data cache.
    pub(crate) const IND: &FieldSpec = &FieldSpec::new("InD", 0, 1, Access::ReadWrite);
    pub(crate) const LOU: &FieldSpec = &FieldSpec::new("LoU", 27, 3, Access::ReadOnly);
    pub(crate) const LOC: &FieldSpec = &FieldSpec::new("LoC", 24, 3, Access::ReadOnly);
    pub(crate) const CL1: &FieldSpec = &FieldSpec::new("CL 1", 0, 3, Access::ReadOnly);
}

/// The fields of the TCM region registers and the peripheral interface region registers, DDI
/// 0460D Tables 4-43, 4-44 and 4-61.
pub(crate) mod region {
    use super::{Access, FieldSpec};
    pub(crate) const BASE: &FieldSpec = &FieldSpec::new("Base address", 12, 20, Access::ReadWrite);
    pub(crate) const SIZE: &FieldSpec = &FieldSpec::new("Size", 2, 5, Access::ReadOnly);
    pub(crate) const ENABLE: &FieldSpec = &FieldSpec::new("Enable", 0, 1, Access::ReadWrite);
}

/// `MPUIR`'s field, DDI 0460D Table 4-6.
pub(crate) mod mpuir {
    use super::{Access, FieldSpec};
    /// The MPU's regions, unified.
    pub(crate) const DREGION: &FieldSpec = &FieldSpec::new("DRegion", 8, 8, Access::ReadOnly);
}

/// `CCSIDR`'s field the cache's size decides, DDI 0460D Table 4-21.
pub(crate) mod ccsidr {
    use super::{Access, FieldSpec};
    /// The sets less one.
    pub(crate) const NUM_SETS: &FieldSpec = &FieldSpec::new("NumSets", 13, 15, Access::ReadOnly);
}

/// `RGNR`'s field, DDI 0460D Table 4-39.
pub(crate) mod rgnr {
    use super::{Access, FieldSpec};
    pub(crate) const REGION: &FieldSpec = &FieldSpec::new("Region", 0, 4, Access::ReadWrite);
}

/// `DRBAR`'s field, DDI 0460D Table 4-33.
pub(crate) mod drbar {
    use super::{Access, FieldSpec};
    pub(crate) const BASE: &FieldSpec = &FieldSpec::new("Base address", 5, 27, Access::ReadWrite);
}

/// `DRSR`'s fields, DDI 0460D Table 4-34.
pub(crate) mod drsr {
    use super::{Access, FieldSpec};
    /// One bit a subregion, subregion 0 the lowest.
    pub(crate) const SRD: &FieldSpec =
        &FieldSpec::new("Sub-region disable", 8, 8, Access::ReadWrite);
    /// The region is 2 to the power of one more than this, in bytes.
    pub(crate) const SIZE: &FieldSpec = &FieldSpec::new("Region size", 1, 5, Access::ReadWrite);
    pub(crate) const ENABLE: &FieldSpec = &FieldSpec::new("Enable", 0, 1, Access::ReadWrite);
}

/// `DRACR`'s fields, DDI 0460D Table 4-35.
pub(crate) mod dracr {
    use super::{Access, FieldSpec};
    /// Execute-never.
    pub(crate) const XN: &FieldSpec = &FieldSpec::new("XN", 12, 1, Access::ReadWrite);
    /// The access permissions, Table 4-38.
    pub(crate) const AP: &FieldSpec = &FieldSpec::new("AP", 8, 3, Access::ReadWrite);
    /// The memory type and cache policy with `C` and `B`, Table 4-36.
    pub(crate) const TEX: &FieldSpec = &FieldSpec::new("TEX", 3, 3, Access::ReadWrite);
    pub(crate) const S: &FieldSpec = &FieldSpec::new("S", 2, 1, Access::ReadWrite);
    pub(crate) const C: &FieldSpec = &FieldSpec::new("C", 1, 1, Access::ReadWrite);
    pub(crate) const B: &FieldSpec = &FieldSpec::new("B", 0, 1, Access::ReadWrite);
}

/// The fields of Build Options 2 this part sets, DDI 0460D Table 4-59.
pub(crate) mod build2 {
    use super::{Access, FieldSpec};
    pub(crate) const LOCK_STEP: &FieldSpec = &FieldSpec::new("LOCK_STEP", 30, 1, Access::ReadOnly);
    pub(crate) const MPU_REGIONS: &FieldSpec =
        &FieldSpec::new("MPU_REGIONS", 20, 2, Access::ReadOnly);
    pub(crate) const BREAK_POINTS: &FieldSpec =
        &FieldSpec::new("BREAK_POINTS", 17, 3, Access::ReadOnly);
    pub(crate) const WATCH_POINTS: &FieldSpec =
        &FieldSpec::new("WATCH_POINTS", 14, 3, Access::ReadOnly);
    pub(crate) const NO_A_TCM_INF: &FieldSpec =
        &FieldSpec::new("NO_A_TCM_INF", 13, 1, Access::ReadOnly);
    pub(crate) const NO_B0_TCM_INF: &FieldSpec =
        &FieldSpec::new("NO_B0_TCM_INF", 12, 1, Access::ReadOnly);
    pub(crate) const NO_B1_TCM_INF: &FieldSpec =
        &FieldSpec::new("NO_B1_TCM_INF", 11, 1, Access::ReadOnly);
    pub(crate) const ICACHE_ES: &FieldSpec = &FieldSpec::new("ICACHE_ES", 7, 2, Access::ReadOnly);
    pub(crate) const DCACHE_ES: &FieldSpec = &FieldSpec::new("DCACHE_ES", 5, 2, Access::ReadOnly);
    pub(crate) const NO_HARD_ERROR_CACHE: &FieldSpec =
        &FieldSpec::new("NO_HARD_ERROR_CACHE", 4, 1, Access::ReadOnly);
    pub(crate) const AXI_BUS_ECC: &FieldSpec =
        &FieldSpec::new("AXI_BUS_ECC", 3, 1, Access::ReadOnly);
    pub(crate) const MICRO_SCU: &FieldSpec = &FieldSpec::new("MICRO_SCU", 0, 1, Access::ReadOnly);
}

/// `ACTLR`'s fields CP15 reads itself, DDI 0460D Table 4-25.
pub(crate) mod actlr {
    use super::{Access, FieldSpec};
    /// Gives the cache RAMs to the AXI slave port, which makes cache maintenance UNDEFINED.
    pub(crate) const AXISCEN: &FieldSpec = &FieldSpec::new("AXISCEN", 24, 1, Access::ReadWrite);
    /// SBZ.
    pub(crate) const SBZ_18: &FieldSpec = &FieldSpec::new("SBZ", 18, 1, Access::ReadOnly);
    /// Cache error control, whose reset value is 0b100.
    pub(crate) const CEC: &FieldSpec = &FieldSpec::new("CEC", 3, 3, Access::ReadWrite);
}

/// The secondary `ACTLR`'s fields, DDI 0460D Table 4-26.
pub(crate) mod auxiliary {
    use super::{Access, FieldSpec};
    /// `DCHE` to `DOOFMACS`.
    pub(crate) const CONTROLS: &FieldSpec =
        &FieldSpec::new("DCHE..DOOFMACS", 16, 7, Access::ReadWrite);
    /// `DCHE`, set at reset.
    pub(crate) const DCHE: &FieldSpec = &FieldSpec::new("DCHE", 22, 1, Access::ReadWrite);
    /// `IXC` to `IDC`, the FPU's exception outputs.
    pub(crate) const FPU_OUTPUTS: &FieldSpec = &FieldSpec::new("IXC..IDC", 8, 6, Access::ReadWrite);
    /// `BTCMECC` to `ATCMRMW`.
    pub(crate) const TCM: &FieldSpec = &FieldSpec::new("BTCMECC..ATCMRMW", 0, 4, Access::ReadWrite);
}

/// `ADFSR`'s and `AIFSR`'s fields, DDI 0460D Table 4-31.
pub(crate) mod afsr {
    use super::{Access, FieldSpec};
    /// `CacheWay`, `Side`, `Recoverable error` and `SideExt`.
    pub(crate) const SOURCE: &FieldSpec =
        &FieldSpec::new("CacheWay..SideExt", 20, 8, Access::ReadWrite);
    pub(crate) const INDEX: &FieldSpec = &FieldSpec::new("Index", 5, 9, Access::ReadWrite);
}

/// The Correctable Fault Location Register's fields in either layout, DDI 0460D Tables 4-56 and
/// 4-57.
pub(crate) mod cflr {
    use super::{Access, FieldSpec};
    pub(crate) const WAY: &FieldSpec = &FieldSpec::new("Way", 26, 4, Access::ReadWrite);
    pub(crate) const SIDE: &FieldSpec = &FieldSpec::new("Side", 24, 2, Access::ReadWrite);
    /// The TCM layout's `Address[22:3]`, which holds the cache layout's `Index`.
    pub(crate) const ADDRESS: &FieldSpec = &FieldSpec::new("Address", 3, 20, Access::ReadWrite);
    pub(crate) const TYPE: &FieldSpec = &FieldSpec::new("Type", 0, 2, Access::ReadWrite);
}

/// The Slave Port Control Register's fields, DDI 0460D Table 4-45.
pub(crate) mod slave_port {
    use super::{Access, FieldSpec};
    pub(crate) const CONTROL: &FieldSpec = &FieldSpec::new(
        "Privileged access, AXI slave enable",
        0,
        2,
        Access::ReadWrite,
    );
}

/// The PMU's selection fields: `PMSELR.SEL`, `PMXEVTYPER.SEL` and `PMUSERENR.EN`, DDI 0460D Tables
/// 6-7 to 6-9.
pub(crate) mod pmu {
    use super::{Access, FieldSpec};
    pub(crate) const COUNTER: &FieldSpec = &FieldSpec::new("SEL", 0, 5, Access::ReadWrite);
    pub(crate) const EVENT: &FieldSpec = &FieldSpec::new("SEL", 0, 8, Access::ReadWrite);
    pub(crate) const EN: &FieldSpec = &FieldSpec::new("EN", 0, 1, Access::ReadWrite);
}
