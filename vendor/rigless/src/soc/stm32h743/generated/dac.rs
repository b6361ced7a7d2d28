// rigless svd from STM32H743.svd, sha256 28dd22d7923a16c1167bda9cfe6cb20cc9e98d44095dd930fd987029a839af58. Do not edit.
// Copyright (c) 2025 STMicroelectronics.
// SPDX-License-Identifier: Apache-2.0
//! Registers of `DAC` and the instances derived from it.

use rigless::soc::{Access, FieldSpec, Layout, ReadAction, RegisterSpec, Width, WriteModify};

/// The registers by name, where a variant's index is its row in [`REGISTERS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// `CR` at offset `0x0`, resets to `0x0000_0000`, read-write.
    Cr = 0,
    /// `SWTRGR` at offset `0x4`, resets to `0x0000_0000`, write-only.
    Swtrgr = 1,
    /// `DHR12R1` at offset `0x8`, resets to `0x0000_0000`, read-write.
    Dhr12r1 = 2,
    /// `DHR12L1` at offset `0xC`, resets to `0x0000_0000`, read-write.
    Dhr12l1 = 3,
    /// `DHR8R1` at offset `0x10`, resets to `0x0000_0000`, read-write.
    Dhr8r1 = 4,
    /// `DHR12R2` at offset `0x14`, resets to `0x0000_0000`, read-write.
    Dhr12r2 = 5,
    /// `DHR12L2` at offset `0x18`, resets to `0x0000_0000`, read-write.
    Dhr12l2 = 6,
    /// `DHR8R2` at offset `0x1C`, resets to `0x0000_0000`, read-write.
    Dhr8r2 = 7,
    /// `DHR12RD` at offset `0x20`, resets to `0x0000_0000`, read-write.
    Dhr12rd = 8,
    /// `DHR12LD` at offset `0x24`, resets to `0x0000_0000`, read-write.
    Dhr12ld = 9,
    /// `DHR8RD` at offset `0x28`, resets to `0x0000_0000`, read-write.
    Dhr8rd = 10,
    /// `DOR1` at offset `0x2C`, resets to `0x0000_0000`, read-only.
    Dor1 = 11,
    /// `DOR2` at offset `0x30`, resets to `0x0000_0000`, read-only.
    Dor2 = 12,
    /// `SR` at offset `0x34`, resets to `0x0000_0000`, read-write.
    Sr = 13,
    /// `CCR` at offset `0x38`, resets to `0x0000_0000`, read-write.
    Ccr = 14,
    /// `MCR` at offset `0x3C`, resets to `0x0000_0000`, read-write.
    Mcr = 15,
    /// `SHSR1` at offset `0x40`, resets to `0x0000_0000`, read-write.
    Shsr1 = 16,
    /// `SHSR2` at offset `0x44`, resets to `0x0000_0000`, read-write.
    Shsr2 = 17,
    /// `SHHR` at offset `0x48`, resets to `0x0001_0001`, read-write.
    Shhr = 18,
    /// `SHRR` at offset `0x4C`, resets to `0x0001_0001`, read-write.
    Shrr = 19,
}

impl Register {
    /// Every register, in table order.
    pub const ALL: [Self; 20] = [Self::Cr, Self::Swtrgr, Self::Dhr12r1, Self::Dhr12l1, Self::Dhr8r1, Self::Dhr12r2, Self::Dhr12l2, Self::Dhr8r2, Self::Dhr12rd, Self::Dhr12ld, Self::Dhr8rd, Self::Dor1, Self::Dor2, Self::Sr, Self::Ccr, Self::Mcr, Self::Shsr1, Self::Shsr2, Self::Shhr, Self::Shrr];
}

impl Layout for Register {
    const REGISTERS: &'static [RegisterSpec] = &REGISTERS;
    fn from_index(index: usize) -> Option<Self> {
        Self::ALL.get(index).copied()
    }
    fn index(self) -> usize {
        self as usize
    }
}

/// The fields of `CR`.
pub mod cr {
    use super::FieldSpec;
    /// `EN1`, bit 0.
    pub const EN1: &FieldSpec = &super::REGISTERS[0].fields[0];
    /// `TEN1`, bit 1.
    pub const TEN1: &FieldSpec = &super::REGISTERS[0].fields[1];
    /// `TSEL1`, bits 2..=4.
    pub const TSEL1: &FieldSpec = &super::REGISTERS[0].fields[2];
    /// `WAVE1`, bits 6..=7.
    pub const WAVE1: &FieldSpec = &super::REGISTERS[0].fields[3];
    /// `MAMP1`, bits 8..=11.
    pub const MAMP1: &FieldSpec = &super::REGISTERS[0].fields[4];
    /// `DMAEN1`, bit 12.
    pub const DMAEN1: &FieldSpec = &super::REGISTERS[0].fields[5];
    /// `DMAUDRIE1`, bit 13.
    pub const DMAUDRIE1: &FieldSpec = &super::REGISTERS[0].fields[6];
    /// `CEN1`, bit 14.
    pub const CEN1: &FieldSpec = &super::REGISTERS[0].fields[7];
    /// `EN2`, bit 16.
    pub const EN2: &FieldSpec = &super::REGISTERS[0].fields[8];
    /// `TEN2`, bit 17.
    pub const TEN2: &FieldSpec = &super::REGISTERS[0].fields[9];
    /// `TSEL2`, bits 18..=20.
    pub const TSEL2: &FieldSpec = &super::REGISTERS[0].fields[10];
    /// `WAVE2`, bits 22..=23.
    pub const WAVE2: &FieldSpec = &super::REGISTERS[0].fields[11];
    /// `MAMP2`, bits 24..=27.
    pub const MAMP2: &FieldSpec = &super::REGISTERS[0].fields[12];
    /// `DMAEN2`, bit 28.
    pub const DMAEN2: &FieldSpec = &super::REGISTERS[0].fields[13];
    /// `DMAUDRIE2`, bit 29.
    pub const DMAUDRIE2: &FieldSpec = &super::REGISTERS[0].fields[14];
    /// `CEN2`, bit 30.
    pub const CEN2: &FieldSpec = &super::REGISTERS[0].fields[15];
}

/// The fields of `SWTRGR`.
pub mod swtrgr {
    use super::FieldSpec;
    /// `SWTRIG1`, bit 0.
    pub const SWTRIG1: &FieldSpec = &super::REGISTERS[1].fields[0];
    /// `SWTRIG2`, bit 1.
    pub const SWTRIG2: &FieldSpec = &super::REGISTERS[1].fields[1];
}

/// The fields of `DHR12R1`.
pub mod dhr12r1 {
    use super::FieldSpec;
    /// `DACC1DHR`, bits 0..=11.
    pub const DACC1DHR: &FieldSpec = &super::REGISTERS[2].fields[0];
}

/// The fields of `DHR12L1`.
pub mod dhr12l1 {
    use super::FieldSpec;
    /// `DACC1DHR`, bits 4..=15.
    pub const DACC1DHR: &FieldSpec = &super::REGISTERS[3].fields[0];
}

/// The fields of `DHR8R1`.
pub mod dhr8r1 {
    use super::FieldSpec;
    /// `DACC1DHR`, bits 0..=7.
    pub const DACC1DHR: &FieldSpec = &super::REGISTERS[4].fields[0];
}

/// The fields of `DHR12R2`.
pub mod dhr12r2 {
    use super::FieldSpec;
    /// `DACC2DHR`, bits 0..=11.
    pub const DACC2DHR: &FieldSpec = &super::REGISTERS[5].fields[0];
}

/// The fields of `DHR12L2`.
pub mod dhr12l2 {
    use super::FieldSpec;
    /// `DACC2DHR`, bits 4..=15.
    pub const DACC2DHR: &FieldSpec = &super::REGISTERS[6].fields[0];
}

/// The fields of `DHR8R2`.
pub mod dhr8r2 {
    use super::FieldSpec;
    /// `DACC2DHR`, bits 0..=7.
    pub const DACC2DHR: &FieldSpec = &super::REGISTERS[7].fields[0];
}

/// The fields of `DHR12RD`.
pub mod dhr12rd {
    use super::FieldSpec;
    /// `DACC1DHR`, bits 0..=11.
    pub const DACC1DHR: &FieldSpec = &super::REGISTERS[8].fields[0];
    /// `DACC2DHR`, bits 16..=27.
    pub const DACC2DHR: &FieldSpec = &super::REGISTERS[8].fields[1];
}

/// The fields of `DHR12LD`.
pub mod dhr12ld {
    use super::FieldSpec;
    /// `DACC1DHR`, bits 4..=15.
    pub const DACC1DHR: &FieldSpec = &super::REGISTERS[9].fields[0];
    /// `DACC2DHR`, bits 20..=31.
    pub const DACC2DHR: &FieldSpec = &super::REGISTERS[9].fields[1];
}

/// The fields of `DHR8RD`.
pub mod dhr8rd {
    use super::FieldSpec;
    /// `DACC1DHR`, bits 0..=7.
    pub const DACC1DHR: &FieldSpec = &super::REGISTERS[10].fields[0];
    /// `DACC2DHR`, bits 8..=15.
    pub const DACC2DHR: &FieldSpec = &super::REGISTERS[10].fields[1];
}

/// The fields of `DOR1`.
pub mod dor1 {
    use super::FieldSpec;
    /// `DACC1DOR`, bits 0..=11.
    pub const DACC1DOR: &FieldSpec = &super::REGISTERS[11].fields[0];
}

/// The fields of `DOR2`.
pub mod dor2 {
    use super::FieldSpec;
    /// `DACC2DOR`, bits 0..=11.
    pub const DACC2DOR: &FieldSpec = &super::REGISTERS[12].fields[0];
}

/// The fields of `SR`.
pub mod sr {
    use super::FieldSpec;
    /// `DMAUDR1`, bit 13.
    pub const DMAUDR1: &FieldSpec = &super::REGISTERS[13].fields[0];
    /// `CAL_FLAG1`, bit 14, read-only.
    pub const CAL_FLAG1: &FieldSpec = &super::REGISTERS[13].fields[1];
    /// `BWST1`, bit 15, read-only.
    pub const BWST1: &FieldSpec = &super::REGISTERS[13].fields[2];
    /// `DMAUDR2`, bit 29.
    pub const DMAUDR2: &FieldSpec = &super::REGISTERS[13].fields[3];
    /// `CAL_FLAG2`, bit 30, read-only.
    pub const CAL_FLAG2: &FieldSpec = &super::REGISTERS[13].fields[4];
    /// `BWST2`, bit 31, read-only.
    pub const BWST2: &FieldSpec = &super::REGISTERS[13].fields[5];
}

/// The fields of `CCR`.
pub mod ccr {
    use super::FieldSpec;
    /// `OTRIM1`, bits 0..=4.
    pub const OTRIM1: &FieldSpec = &super::REGISTERS[14].fields[0];
    /// `OTRIM2`, bits 16..=20.
    pub const OTRIM2: &FieldSpec = &super::REGISTERS[14].fields[1];
}

/// The fields of `MCR`.
pub mod mcr {
    use super::FieldSpec;
    /// `MODE1`, bits 0..=2.
    pub const MODE1: &FieldSpec = &super::REGISTERS[15].fields[0];
    /// `MODE2`, bits 16..=18.
    pub const MODE2: &FieldSpec = &super::REGISTERS[15].fields[1];
}

/// The fields of `SHSR1`.
pub mod shsr1 {
    use super::FieldSpec;
    /// `TSAMPLE1`, bits 0..=9.
    pub const TSAMPLE1: &FieldSpec = &super::REGISTERS[16].fields[0];
}

/// The fields of `SHSR2`.
pub mod shsr2 {
    use super::FieldSpec;
    /// `TSAMPLE2`, bits 0..=9.
    pub const TSAMPLE2: &FieldSpec = &super::REGISTERS[17].fields[0];
}

/// The fields of `SHHR`.
pub mod shhr {
    use super::FieldSpec;
    /// `THOLD1`, bits 0..=9.
    pub const THOLD1: &FieldSpec = &super::REGISTERS[18].fields[0];
    /// `THOLD2`, bits 16..=25.
    pub const THOLD2: &FieldSpec = &super::REGISTERS[18].fields[1];
}

/// The fields of `SHRR`.
pub mod shrr {
    use super::FieldSpec;
    /// `TREFRESH1`, bits 0..=7.
    pub const TREFRESH1: &FieldSpec = &super::REGISTERS[19].fields[0];
    /// `TREFRESH2`, bits 16..=23.
    pub const TREFRESH2: &FieldSpec = &super::REGISTERS[19].fields[1];
}

/// The register table.
pub static REGISTERS: [RegisterSpec; 20] = [
    RegisterSpec { name: "CR", offset: 0x0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "EN1", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TEN1", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TSEL1", bit: 2, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "WAVE1", bit: 6, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MAMP1", bit: 8, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DMAEN1", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DMAUDRIE1", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CEN1", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EN2", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TEN2", bit: 17, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TSEL2", bit: 18, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "WAVE2", bit: 22, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MAMP2", bit: 24, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DMAEN2", bit: 28, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DMAUDRIE2", bit: 29, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CEN2", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SWTRGR", offset: 0x4, width: Width::W32, reset: 0x0000_0000, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SWTRIG1", bit: 0, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SWTRIG2", bit: 1, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR12R1", offset: 0x8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC1DHR", bit: 0, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR12L1", offset: 0xC, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC1DHR", bit: 4, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR8R1", offset: 0x10, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC1DHR", bit: 0, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR12R2", offset: 0x14, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC2DHR", bit: 0, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR12L2", offset: 0x18, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC2DHR", bit: 4, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR8R2", offset: 0x1C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC2DHR", bit: 0, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR12RD", offset: 0x20, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC1DHR", bit: 0, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DACC2DHR", bit: 16, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR12LD", offset: 0x24, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC1DHR", bit: 4, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DACC2DHR", bit: 20, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DHR8RD", offset: 0x28, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC1DHR", bit: 0, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DACC2DHR", bit: 8, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DOR1", offset: 0x2C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC1DOR", bit: 0, width: 12, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DOR2", offset: 0x30, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DACC2DOR", bit: 0, width: 12, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SR", offset: 0x34, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAUDR1", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CAL_FLAG1", bit: 14, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BWST1", bit: 15, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DMAUDR2", bit: 29, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CAL_FLAG2", bit: 30, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BWST2", bit: 31, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCR", offset: 0x38, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "OTRIM1", bit: 0, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTRIM2", bit: 16, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "MCR", offset: 0x3C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MODE1", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MODE2", bit: 16, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SHSR1", offset: 0x40, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "TSAMPLE1", bit: 0, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SHSR2", offset: 0x44, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "TSAMPLE2", bit: 0, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SHHR", offset: 0x48, width: Width::W32, reset: 0x0001_0001, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "THOLD1", bit: 0, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "THOLD2", bit: 16, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SHRR", offset: 0x4C, width: Width::W32, reset: 0x0001_0001, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "TREFRESH1", bit: 0, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TREFRESH2", bit: 16, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
];
