// rigless svd from STM32H743.svd, sha256 28dd22d7923a16c1167bda9cfe6cb20cc9e98d44095dd930fd987029a839af58. Do not edit.
// Copyright (c) 2025 STMicroelectronics.
// SPDX-License-Identifier: Apache-2.0
//! Registers of `WWDG` and the instances derived from it.

use rigless::soc::{Access, FieldSpec, Layout, ReadAction, RegisterSpec, Width, WriteModify};

/// The registers by name, where a variant's index is its row in [`REGISTERS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// `CR` at offset `0x0`, resets to `0x0000_007F`, read-write.
    Cr = 0,
    /// `CFR` at offset `0x4`, resets to `0x0000_007F`, read-write.
    Cfr = 1,
    /// `SR` at offset `0x8`, resets to `0x0000_0000`, read-write.
    Sr = 2,
}

impl Register {
    /// Every register, in table order.
    pub const ALL: [Self; 3] = [Self::Cr, Self::Cfr, Self::Sr];
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
    /// `T`, bits 0..=6.
    pub const T: &FieldSpec = &super::REGISTERS[0].fields[0];
    /// `WDGA`, bit 7.
    pub const WDGA: &FieldSpec = &super::REGISTERS[0].fields[1];
}

/// The fields of `CFR`.
pub mod cfr {
    use super::FieldSpec;
    /// `W`, bits 0..=6.
    pub const W: &FieldSpec = &super::REGISTERS[1].fields[0];
    /// `EWI`, bit 9.
    pub const EWI: &FieldSpec = &super::REGISTERS[1].fields[1];
    /// `WDGTB`, bits 11..=12.
    pub const WDGTB: &FieldSpec = &super::REGISTERS[1].fields[2];
}

/// The fields of `SR`.
pub mod sr {
    use super::FieldSpec;
    /// `EWIF`, bit 0.
    pub const EWIF: &FieldSpec = &super::REGISTERS[2].fields[0];
}

/// The register table.
pub static REGISTERS: [RegisterSpec; 3] = [
    RegisterSpec { name: "CR", offset: 0x0, width: Width::W32, reset: 0x0000_007F, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "T", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "WDGA", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CFR", offset: 0x4, width: Width::W32, reset: 0x0000_007F, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "W", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EWI", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "WDGTB", bit: 11, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SR", offset: 0x8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "EWIF", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
];
