// rigless svd from STM32H743.svd, sha256 28dd22d7923a16c1167bda9cfe6cb20cc9e98d44095dd930fd987029a839af58. Do not edit.
// Copyright (c) 2025 STMicroelectronics.
// SPDX-License-Identifier: Apache-2.0
//! Registers of `DMAMUX1` and the instances derived from it.

use rigless::soc::{Access, FieldSpec, Layout, ReadAction, RegisterSpec, Width, WriteModify};

/// The registers by name, where a variant's index is its row in [`REGISTERS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// `DMAMUX_C0CR` at offset `0x0`, resets to `0x0000_0000`, read-write.
    DmamuxC0cr = 0,
    /// `DMAMUX_C1CR` at offset `0x4`, resets to `0x0000_0000`, read-write.
    DmamuxC1cr = 1,
    /// `DMAMUX_C2CR` at offset `0x8`, resets to `0x0000_0000`, read-write.
    DmamuxC2cr = 2,
    /// `DMAMUX_C3CR` at offset `0xC`, resets to `0x0000_0000`, read-write.
    DmamuxC3cr = 3,
    /// `DMAMUX_C4CR` at offset `0x10`, resets to `0x0000_0000`, read-write.
    DmamuxC4cr = 4,
    /// `DMAMUX_C5CR` at offset `0x14`, resets to `0x0000_0000`, read-write.
    DmamuxC5cr = 5,
    /// `DMAMUX_C6CR` at offset `0x18`, resets to `0x0000_0000`, read-write.
    DmamuxC6cr = 6,
    /// `DMAMUX_C7CR` at offset `0x1C`, resets to `0x0000_0000`, read-write.
    DmamuxC7cr = 7,
    /// `DMAMUX_C8CR` at offset `0x20`, resets to `0x0000_0000`, read-write.
    DmamuxC8cr = 8,
    /// `DMAMUX_C9CR` at offset `0x24`, resets to `0x0000_0000`, read-write.
    DmamuxC9cr = 9,
    /// `DMAMUX_C10CR` at offset `0x28`, resets to `0x0000_0000`, read-write.
    DmamuxC10cr = 10,
    /// `DMAMUX_C11CR` at offset `0x2C`, resets to `0x0000_0000`, read-write.
    DmamuxC11cr = 11,
    /// `DMAMUX_C12CR` at offset `0x30`, resets to `0x0000_0000`, read-write.
    DmamuxC12cr = 12,
    /// `DMAMUX_C13CR` at offset `0x34`, resets to `0x0000_0000`, read-write.
    DmamuxC13cr = 13,
    /// `DMAMUX_C14CR` at offset `0x38`, resets to `0x0000_0000`, read-write.
    DmamuxC14cr = 14,
    /// `DMAMUX_C15CR` at offset `0x3C`, resets to `0x0000_0000`, read-write.
    DmamuxC15cr = 15,
    /// `DMAMUX_CSR` at offset `0x80`, resets to `0x0000_0000`, read-write.
    DmamuxCsr = 16,
    /// `DMAMUX_CFR` at offset `0x84`, resets to `0x0000_0000`, read-write.
    DmamuxCfr = 17,
    /// `DMAMUX_RG0CR` at offset `0x100`, resets to `0x0000_0000`, read-write.
    DmamuxRg0cr = 18,
    /// `DMAMUX_RG1CR` at offset `0x104`, resets to `0x0000_0000`, read-write.
    DmamuxRg1cr = 19,
    /// `DMAMUX_RG2CR` at offset `0x108`, resets to `0x0000_0000`, read-write.
    DmamuxRg2cr = 20,
    /// `DMAMUX_RG3CR` at offset `0x10C`, resets to `0x0000_0000`, read-write.
    DmamuxRg3cr = 21,
    /// `DMAMUX_RG4CR` at offset `0x110`, resets to `0x0000_0000`, read-write.
    DmamuxRg4cr = 22,
    /// `DMAMUX_RG5CR` at offset `0x114`, resets to `0x0000_0000`, read-write.
    DmamuxRg5cr = 23,
    /// `DMAMUX_RG6CR` at offset `0x118`, resets to `0x0000_0000`, read-write.
    DmamuxRg6cr = 24,
    /// `DMAMUX_RG7CR` at offset `0x11C`, resets to `0x0000_0000`, read-write.
    DmamuxRg7cr = 25,
    /// `DMAMUX_RGSR` at offset `0x140`, resets to `0x0000_0000`, read-write.
    DmamuxRgsr = 26,
    /// `DMAMUX_RGCFR` at offset `0x144`, resets to `0x0000_0000`, read-write.
    DmamuxRgcfr = 27,
}

impl Register {
    /// Every register, in table order.
    pub const ALL: [Self; 28] = [Self::DmamuxC0cr, Self::DmamuxC1cr, Self::DmamuxC2cr, Self::DmamuxC3cr, Self::DmamuxC4cr, Self::DmamuxC5cr, Self::DmamuxC6cr, Self::DmamuxC7cr, Self::DmamuxC8cr, Self::DmamuxC9cr, Self::DmamuxC10cr, Self::DmamuxC11cr, Self::DmamuxC12cr, Self::DmamuxC13cr, Self::DmamuxC14cr, Self::DmamuxC15cr, Self::DmamuxCsr, Self::DmamuxCfr, Self::DmamuxRg0cr, Self::DmamuxRg1cr, Self::DmamuxRg2cr, Self::DmamuxRg3cr, Self::DmamuxRg4cr, Self::DmamuxRg5cr, Self::DmamuxRg6cr, Self::DmamuxRg7cr, Self::DmamuxRgsr, Self::DmamuxRgcfr];
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

/// The fields of `DMAMUX_C0CR`.
pub mod dmamux_c0cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[0].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[0].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[0].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[0].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[0].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[0].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[0].fields[6];
}

/// The fields of `DMAMUX_C1CR`.
pub mod dmamux_c1cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[1].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[1].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[1].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[1].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[1].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[1].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[1].fields[6];
}

/// The fields of `DMAMUX_C2CR`.
pub mod dmamux_c2cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[2].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[2].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[2].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[2].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[2].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[2].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[2].fields[6];
}

/// The fields of `DMAMUX_C3CR`.
pub mod dmamux_c3cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[3].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[3].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[3].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[3].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[3].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[3].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[3].fields[6];
}

/// The fields of `DMAMUX_C4CR`.
pub mod dmamux_c4cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[4].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[4].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[4].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[4].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[4].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[4].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[4].fields[6];
}

/// The fields of `DMAMUX_C5CR`.
pub mod dmamux_c5cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[5].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[5].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[5].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[5].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[5].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[5].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[5].fields[6];
}

/// The fields of `DMAMUX_C6CR`.
pub mod dmamux_c6cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[6].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[6].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[6].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[6].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[6].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[6].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[6].fields[6];
}

/// The fields of `DMAMUX_C7CR`.
pub mod dmamux_c7cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[7].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[7].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[7].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[7].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[7].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[7].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[7].fields[6];
}

/// The fields of `DMAMUX_C8CR`.
pub mod dmamux_c8cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[8].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[8].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[8].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[8].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[8].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[8].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[8].fields[6];
}

/// The fields of `DMAMUX_C9CR`.
pub mod dmamux_c9cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[9].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[9].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[9].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[9].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[9].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[9].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[9].fields[6];
}

/// The fields of `DMAMUX_C10CR`.
pub mod dmamux_c10cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[10].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[10].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[10].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[10].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[10].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[10].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[10].fields[6];
}

/// The fields of `DMAMUX_C11CR`.
pub mod dmamux_c11cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[11].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[11].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[11].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[11].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[11].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[11].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[11].fields[6];
}

/// The fields of `DMAMUX_C12CR`.
pub mod dmamux_c12cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[12].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[12].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[12].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[12].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[12].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[12].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[12].fields[6];
}

/// The fields of `DMAMUX_C13CR`.
pub mod dmamux_c13cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[13].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[13].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[13].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[13].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[13].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[13].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[13].fields[6];
}

/// The fields of `DMAMUX_C14CR`.
pub mod dmamux_c14cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[14].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[14].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[14].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[14].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[14].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[14].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[14].fields[6];
}

/// The fields of `DMAMUX_C15CR`.
pub mod dmamux_c15cr {
    use super::FieldSpec;
    /// `DMAREQ_ID`, bits 0..=6.
    pub const DMAREQ_ID: &FieldSpec = &super::REGISTERS[15].fields[0];
    /// `SOIE`, bit 8.
    pub const SOIE: &FieldSpec = &super::REGISTERS[15].fields[1];
    /// `EGE`, bit 9.
    pub const EGE: &FieldSpec = &super::REGISTERS[15].fields[2];
    /// `SE`, bit 16.
    pub const SE: &FieldSpec = &super::REGISTERS[15].fields[3];
    /// `SPOL`, bits 17..=18.
    pub const SPOL: &FieldSpec = &super::REGISTERS[15].fields[4];
    /// `NBREQ`, bits 19..=23.
    pub const NBREQ: &FieldSpec = &super::REGISTERS[15].fields[5];
    /// `SYNC_ID`, bits 24..=26.
    pub const SYNC_ID: &FieldSpec = &super::REGISTERS[15].fields[6];
}

/// The fields of `DMAMUX_CSR`.
pub mod dmamux_csr {
    use super::FieldSpec;
    /// `SOF0`, bit 0, read-only.
    pub const SOF0: &FieldSpec = &super::REGISTERS[16].fields[0];
    /// `SOF1`, bit 1, read-only.
    pub const SOF1: &FieldSpec = &super::REGISTERS[16].fields[1];
    /// `SOF2`, bit 2, read-only.
    pub const SOF2: &FieldSpec = &super::REGISTERS[16].fields[2];
    /// `SOF3`, bit 3, read-only.
    pub const SOF3: &FieldSpec = &super::REGISTERS[16].fields[3];
    /// `SOF4`, bit 4, read-only.
    pub const SOF4: &FieldSpec = &super::REGISTERS[16].fields[4];
    /// `SOF5`, bit 5, read-only.
    pub const SOF5: &FieldSpec = &super::REGISTERS[16].fields[5];
    /// `SOF6`, bit 6, read-only.
    pub const SOF6: &FieldSpec = &super::REGISTERS[16].fields[6];
    /// `SOF7`, bit 7, read-only.
    pub const SOF7: &FieldSpec = &super::REGISTERS[16].fields[7];
    /// `SOF8`, bit 8, read-only.
    pub const SOF8: &FieldSpec = &super::REGISTERS[16].fields[8];
    /// `SOF9`, bit 9, read-only.
    pub const SOF9: &FieldSpec = &super::REGISTERS[16].fields[9];
    /// `SOF10`, bit 10, read-only.
    pub const SOF10: &FieldSpec = &super::REGISTERS[16].fields[10];
    /// `SOF11`, bit 11, read-only.
    pub const SOF11: &FieldSpec = &super::REGISTERS[16].fields[11];
    /// `SOF12`, bit 12, read-only.
    pub const SOF12: &FieldSpec = &super::REGISTERS[16].fields[12];
    /// `SOF13`, bit 13, read-only.
    pub const SOF13: &FieldSpec = &super::REGISTERS[16].fields[13];
    /// `SOF14`, bit 14, read-only.
    pub const SOF14: &FieldSpec = &super::REGISTERS[16].fields[14];
    /// `SOF15`, bit 15, read-only.
    pub const SOF15: &FieldSpec = &super::REGISTERS[16].fields[15];
}

/// The fields of `DMAMUX_CFR`.
pub mod dmamux_cfr {
    use super::FieldSpec;
    /// `CSOF0`, bit 0, write-only.
    pub const CSOF0: &FieldSpec = &super::REGISTERS[17].fields[0];
    /// `CSOF1`, bit 1, write-only.
    pub const CSOF1: &FieldSpec = &super::REGISTERS[17].fields[1];
    /// `CSOF2`, bit 2, write-only.
    pub const CSOF2: &FieldSpec = &super::REGISTERS[17].fields[2];
    /// `CSOF3`, bit 3, write-only.
    pub const CSOF3: &FieldSpec = &super::REGISTERS[17].fields[3];
    /// `CSOF4`, bit 4, write-only.
    pub const CSOF4: &FieldSpec = &super::REGISTERS[17].fields[4];
    /// `CSOF5`, bit 5, write-only.
    pub const CSOF5: &FieldSpec = &super::REGISTERS[17].fields[5];
    /// `CSOF6`, bit 6, write-only.
    pub const CSOF6: &FieldSpec = &super::REGISTERS[17].fields[6];
    /// `CSOF7`, bit 7, write-only.
    pub const CSOF7: &FieldSpec = &super::REGISTERS[17].fields[7];
    /// `CSOF8`, bit 8, write-only.
    pub const CSOF8: &FieldSpec = &super::REGISTERS[17].fields[8];
    /// `CSOF9`, bit 9, write-only.
    pub const CSOF9: &FieldSpec = &super::REGISTERS[17].fields[9];
    /// `CSOF10`, bit 10, write-only.
    pub const CSOF10: &FieldSpec = &super::REGISTERS[17].fields[10];
    /// `CSOF11`, bit 11, write-only.
    pub const CSOF11: &FieldSpec = &super::REGISTERS[17].fields[11];
    /// `CSOF12`, bit 12, write-only.
    pub const CSOF12: &FieldSpec = &super::REGISTERS[17].fields[12];
    /// `CSOF13`, bit 13, write-only.
    pub const CSOF13: &FieldSpec = &super::REGISTERS[17].fields[13];
    /// `CSOF14`, bit 14, write-only.
    pub const CSOF14: &FieldSpec = &super::REGISTERS[17].fields[14];
    /// `CSOF15`, bit 15, write-only.
    pub const CSOF15: &FieldSpec = &super::REGISTERS[17].fields[15];
}

/// The fields of `DMAMUX_RG0CR`.
pub mod dmamux_rg0cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[18].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[18].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[18].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[18].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[18].fields[4];
}

/// The fields of `DMAMUX_RG1CR`.
pub mod dmamux_rg1cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[19].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[19].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[19].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[19].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[19].fields[4];
}

/// The fields of `DMAMUX_RG2CR`.
pub mod dmamux_rg2cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[20].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[20].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[20].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[20].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[20].fields[4];
}

/// The fields of `DMAMUX_RG3CR`.
pub mod dmamux_rg3cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[21].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[21].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[21].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[21].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[21].fields[4];
}

/// The fields of `DMAMUX_RG4CR`.
pub mod dmamux_rg4cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[22].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[22].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[22].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[22].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[22].fields[4];
}

/// The fields of `DMAMUX_RG5CR`.
pub mod dmamux_rg5cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[23].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[23].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[23].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[23].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[23].fields[4];
}

/// The fields of `DMAMUX_RG6CR`.
pub mod dmamux_rg6cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[24].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[24].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[24].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[24].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[24].fields[4];
}

/// The fields of `DMAMUX_RG7CR`.
pub mod dmamux_rg7cr {
    use super::FieldSpec;
    /// `SIG_ID`, bits 0..=2.
    pub const SIG_ID: &FieldSpec = &super::REGISTERS[25].fields[0];
    /// `OIE`, bit 8.
    pub const OIE: &FieldSpec = &super::REGISTERS[25].fields[1];
    /// `GE`, bit 16.
    pub const GE: &FieldSpec = &super::REGISTERS[25].fields[2];
    /// `GPOL`, bits 17..=18.
    pub const GPOL: &FieldSpec = &super::REGISTERS[25].fields[3];
    /// `GNBREQ`, bits 19..=23.
    pub const GNBREQ: &FieldSpec = &super::REGISTERS[25].fields[4];
}

/// The fields of `DMAMUX_RGSR`.
pub mod dmamux_rgsr {
    use super::FieldSpec;
    /// `OF0`, bit 0, read-only.
    pub const OF0: &FieldSpec = &super::REGISTERS[26].fields[0];
    /// `OF1`, bit 1, read-only.
    pub const OF1: &FieldSpec = &super::REGISTERS[26].fields[1];
    /// `OF2`, bit 2, read-only.
    pub const OF2: &FieldSpec = &super::REGISTERS[26].fields[2];
    /// `OF3`, bit 3, read-only.
    pub const OF3: &FieldSpec = &super::REGISTERS[26].fields[3];
    /// `OF4`, bit 4, read-only.
    pub const OF4: &FieldSpec = &super::REGISTERS[26].fields[4];
    /// `OF5`, bit 5, read-only.
    pub const OF5: &FieldSpec = &super::REGISTERS[26].fields[5];
    /// `OF6`, bit 6, read-only.
    pub const OF6: &FieldSpec = &super::REGISTERS[26].fields[6];
    /// `OF7`, bit 7, read-only.
    pub const OF7: &FieldSpec = &super::REGISTERS[26].fields[7];
}

/// The fields of `DMAMUX_RGCFR`.
pub mod dmamux_rgcfr {
    use super::FieldSpec;
    /// `COF0`, bit 0, write-only.
    pub const COF0: &FieldSpec = &super::REGISTERS[27].fields[0];
    /// `COF1`, bit 1, write-only.
    pub const COF1: &FieldSpec = &super::REGISTERS[27].fields[1];
    /// `COF2`, bit 2, write-only.
    pub const COF2: &FieldSpec = &super::REGISTERS[27].fields[2];
    /// `COF3`, bit 3, write-only.
    pub const COF3: &FieldSpec = &super::REGISTERS[27].fields[3];
    /// `COF4`, bit 4, write-only.
    pub const COF4: &FieldSpec = &super::REGISTERS[27].fields[4];
    /// `COF5`, bit 5, write-only.
    pub const COF5: &FieldSpec = &super::REGISTERS[27].fields[5];
    /// `COF6`, bit 6, write-only.
    pub const COF6: &FieldSpec = &super::REGISTERS[27].fields[6];
    /// `COF7`, bit 7, write-only.
    pub const COF7: &FieldSpec = &super::REGISTERS[27].fields[7];
}

/// The register table.
pub static REGISTERS: [RegisterSpec; 28] = [
    RegisterSpec { name: "DMAMUX_C0CR", offset: 0x0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C1CR", offset: 0x4, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C2CR", offset: 0x8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C3CR", offset: 0xC, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C4CR", offset: 0x10, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C5CR", offset: 0x14, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C6CR", offset: 0x18, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C7CR", offset: 0x1C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C8CR", offset: 0x20, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C9CR", offset: 0x24, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C10CR", offset: 0x28, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C11CR", offset: 0x2C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C12CR", offset: 0x30, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C13CR", offset: 0x34, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C14CR", offset: 0x38, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_C15CR", offset: 0x3C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAREQ_ID", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EGE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SYNC_ID", bit: 24, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_CSR", offset: 0x80, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SOF0", bit: 0, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF1", bit: 1, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF2", bit: 2, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF3", bit: 3, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF4", bit: 4, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF5", bit: 5, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF6", bit: 6, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF7", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF8", bit: 8, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF9", bit: 9, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF10", bit: 10, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF11", bit: 11, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF12", bit: 12, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF13", bit: 13, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF14", bit: 14, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SOF15", bit: 15, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_CFR", offset: 0x84, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CSOF0", bit: 0, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF1", bit: 1, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF2", bit: 2, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF3", bit: 3, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF4", bit: 4, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF5", bit: 5, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF6", bit: 6, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF7", bit: 7, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF8", bit: 8, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF9", bit: 9, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF10", bit: 10, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF11", bit: 11, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF12", bit: 12, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF13", bit: 13, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF14", bit: 14, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CSOF15", bit: 15, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG0CR", offset: 0x100, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG1CR", offset: 0x104, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG2CR", offset: 0x108, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG3CR", offset: 0x10C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG4CR", offset: 0x110, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG5CR", offset: 0x114, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG6CR", offset: 0x118, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RG7CR", offset: 0x11C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SIG_ID", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GE", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GPOL", bit: 17, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GNBREQ", bit: 19, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RGSR", offset: 0x140, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "OF0", bit: 0, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OF1", bit: 1, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OF2", bit: 2, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OF3", bit: 3, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OF4", bit: 4, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OF5", bit: 5, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OF6", bit: 6, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OF7", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAMUX_RGCFR", offset: 0x144, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "COF0", bit: 0, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COF1", bit: 1, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COF2", bit: 2, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COF3", bit: 3, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COF4", bit: 4, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COF5", bit: 5, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COF6", bit: 6, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COF7", bit: 7, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
];
