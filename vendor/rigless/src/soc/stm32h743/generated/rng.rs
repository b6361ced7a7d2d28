// rigless svd from STM32H743.svd, sha256 28dd22d7923a16c1167bda9cfe6cb20cc9e98d44095dd930fd987029a839af58. Do not edit.
// Copyright (c) 2025 STMicroelectronics.
// SPDX-License-Identifier: Apache-2.0
//! Registers of `RNG` and the instances derived from it.

use rigless::soc::{Access, FieldSpec, Layout, ReadAction, RegisterSpec, Width, WriteModify};

/// The registers by name, where a variant's index is its row in [`REGISTERS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// `CR` at offset `0x0`, resets to `0x0000_0000`, read-write.
    Cr = 0,
    /// `SR` at offset `0x4`, resets to `0x0000_0000`, read-write.
    Sr = 1,
    /// `DR` at offset `0x8`, resets to `0x0000_0000`, read-only.
    Dr = 2,
}

impl Register {
    /// Every register, in table order.
    pub const ALL: [Self; 3] = [Self::Cr, Self::Sr, Self::Dr];
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
    /// `RNGEN`, bit 2.
    pub const RNGEN: &FieldSpec = &super::REGISTERS[0].fields[0];
    /// `IE`, bit 3.
    pub const IE: &FieldSpec = &super::REGISTERS[0].fields[1];
    /// `CED`, bit 5.
    pub const CED: &FieldSpec = &super::REGISTERS[0].fields[2];
}

/// The fields of `SR`.
pub mod sr {
    use super::FieldSpec;
    /// `DRDY`, bit 0, read-only.
    pub const DRDY: &FieldSpec = &super::REGISTERS[1].fields[0];
    /// `CECS`, bit 1, read-only.
    pub const CECS: &FieldSpec = &super::REGISTERS[1].fields[1];
    /// `SECS`, bit 2, read-only.
    pub const SECS: &FieldSpec = &super::REGISTERS[1].fields[2];
    /// `CEIS`, bit 5.
    pub const CEIS: &FieldSpec = &super::REGISTERS[1].fields[3];
    /// `SEIS`, bit 6.
    pub const SEIS: &FieldSpec = &super::REGISTERS[1].fields[4];
}

/// The fields of `DR`.
pub mod dr {
    use super::FieldSpec;
    /// `RNDATA`, bits 0..=31.
    pub const RNDATA: &FieldSpec = &super::REGISTERS[2].fields[0];
}

/// The register table.
pub static REGISTERS: [RegisterSpec; 3] = [
    RegisterSpec { name: "CR", offset: 0x0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "RNGEN", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IE", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CED", bit: 5, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SR", offset: 0x4, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DRDY", bit: 0, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CECS", bit: 1, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SECS", bit: 2, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CEIS", bit: 5, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SEIS", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DR", offset: 0x8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "RNDATA", bit: 0, width: 32, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
];
