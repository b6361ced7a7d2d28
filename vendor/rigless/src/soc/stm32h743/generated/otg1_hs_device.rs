// rigless svd from STM32H743.svd, sha256 28dd22d7923a16c1167bda9cfe6cb20cc9e98d44095dd930fd987029a839af58. Do not edit.
// Copyright (c) 2025 STMicroelectronics.
// SPDX-License-Identifier: Apache-2.0
//! Registers of `OTG1_HS_DEVICE` and the instances derived from it.

use rigless::soc::{Access, FieldSpec, Layout, ReadAction, RegisterSpec, Width, WriteModify};

/// The registers by name, where a variant's index is its row in [`REGISTERS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// `OTG_HS_DCFG` at offset `0x0`, resets to `0x0220_0000`, read-write.
    OtgHsDcfg = 0,
    /// `OTG_HS_DCTL` at offset `0x4`, resets to `0x0000_0000`, read-write.
    OtgHsDctl = 1,
    /// `OTG_HS_DSTS` at offset `0x8`, resets to `0x0000_0010`, read-only.
    OtgHsDsts = 2,
    /// `OTG_HS_DIEPMSK` at offset `0x10`, resets to `0x0000_0000`, read-write.
    OtgHsDiepmsk = 3,
    /// `OTG_HS_DOEPMSK` at offset `0x14`, resets to `0x0000_0000`, read-write.
    OtgHsDoepmsk = 4,
    /// `OTG_HS_DAINT` at offset `0x18`, resets to `0x0000_0000`, read-only.
    OtgHsDaint = 5,
    /// `OTG_HS_DAINTMSK` at offset `0x1C`, resets to `0x0000_0000`, read-write.
    OtgHsDaintmsk = 6,
    /// `OTG_HS_DVBUSDIS` at offset `0x28`, resets to `0x0000_17D7`, read-write.
    OtgHsDvbusdis = 7,
    /// `OTG_HS_DVBUSPULSE` at offset `0x2C`, resets to `0x0000_05B8`, read-write.
    OtgHsDvbuspulse = 8,
    /// `OTG_HS_DTHRCTL` at offset `0x30`, resets to `0x0000_0000`, read-write.
    OtgHsDthrctl = 9,
    /// `OTG_HS_DIEPEMPMSK` at offset `0x34`, resets to `0x0000_0000`, read-write.
    OtgHsDiepempmsk = 10,
    /// `OTG_HS_DEACHINT` at offset `0x38`, resets to `0x0000_0000`, read-write.
    OtgHsDeachint = 11,
    /// `OTG_HS_DEACHINTMSK` at offset `0x3C`, resets to `0x0000_0000`, read-write.
    OtgHsDeachintmsk = 12,
    /// `OTG_HS_DIEPCTL0` at offset `0x100`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl0 = 13,
    /// `OTG_HS_DIEPINT0` at offset `0x108`, resets to `0x0000_0080`, read-write.
    OtgHsDiepint0 = 14,
    /// `OTG_HS_DIEPTSIZ0` at offset `0x110`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz0 = 15,
    /// `OTG_HS_DIEPDMA1` at offset `0x114`, resets to `0x0000_0000`, read-write.
    OtgHsDiepdma1 = 16,
    /// `OTG_HS_DTXFSTS0` at offset `0x118`, resets to `0x0000_0000`, read-only.
    OtgHsDtxfsts0 = 17,
    /// `OTG_HS_DIEPCTL1` at offset `0x120`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl1 = 18,
    /// `OTG_HS_DIEPINT1` at offset `0x128`, resets to `0x0000_0000`, read-write.
    OtgHsDiepint1 = 19,
    /// `OTG_HS_DIEPTSIZ1` at offset `0x130`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz1 = 20,
    /// `OTG_HS_DIEPDMA2` at offset `0x134`, resets to `0x0000_0000`, read-write.
    OtgHsDiepdma2 = 21,
    /// `OTG_HS_DTXFSTS1` at offset `0x138`, resets to `0x0000_0000`, read-only.
    OtgHsDtxfsts1 = 22,
    /// `OTG_HS_DIEPCTL2` at offset `0x140`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl2 = 23,
    /// `OTG_HS_DIEPINT2` at offset `0x148`, resets to `0x0000_0000`, read-write.
    OtgHsDiepint2 = 24,
    /// `OTG_HS_DIEPTSIZ2` at offset `0x150`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz2 = 25,
    /// `OTG_HS_DIEPDMA3` at offset `0x154`, resets to `0x0000_0000`, read-write.
    OtgHsDiepdma3 = 26,
    /// `OTG_HS_DTXFSTS2` at offset `0x158`, resets to `0x0000_0000`, read-only.
    OtgHsDtxfsts2 = 27,
    /// `OTG_HS_DIEPCTL3` at offset `0x160`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl3 = 28,
    /// `OTG_HS_DIEPINT3` at offset `0x168`, resets to `0x0000_0000`, read-write.
    OtgHsDiepint3 = 29,
    /// `OTG_HS_DIEPTSIZ3` at offset `0x170`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz3 = 30,
    /// `OTG_HS_DIEPDMA4` at offset `0x174`, resets to `0x0000_0000`, read-write.
    OtgHsDiepdma4 = 31,
    /// `OTG_HS_DTXFSTS3` at offset `0x178`, resets to `0x0000_0000`, read-only.
    OtgHsDtxfsts3 = 32,
    /// `OTG_HS_DIEPCTL4` at offset `0x180`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl4 = 33,
    /// `OTG_HS_DIEPINT4` at offset `0x188`, resets to `0x0000_0000`, read-write.
    OtgHsDiepint4 = 34,
    /// `OTG_HS_DIEPTSIZ4` at offset `0x190`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz4 = 35,
    /// `OTG_HS_DIEPDMA5` at offset `0x194`, resets to `0x0000_0000`, read-write.
    OtgHsDiepdma5 = 36,
    /// `OTG_HS_DTXFSTS4` at offset `0x198`, resets to `0x0000_0000`, read-only.
    OtgHsDtxfsts4 = 37,
    /// `OTG_HS_DIEPCTL5` at offset `0x1A0`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl5 = 38,
    /// `OTG_HS_DIEPTSIZ6` at offset `0x1A0`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz6 = 39,
    /// `OTG_HS_DTXFSTS6` at offset `0x1A4`, resets to `0x0000_0000`, read-write.
    OtgHsDtxfsts6 = 40,
    /// `OTG_HS_DIEPINT5` at offset `0x1A8`, resets to `0x0000_0000`, read-write.
    OtgHsDiepint5 = 41,
    /// `OTG_HS_DIEPTSIZ7` at offset `0x1A8`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz7 = 42,
    /// `OTG_HS_DTXFSTS7` at offset `0x1AC`, resets to `0x0000_0000`, read-write.
    OtgHsDtxfsts7 = 43,
    /// `OTG_HS_DIEPTSIZ5` at offset `0x1B0`, resets to `0x0000_0000`, read-write.
    OtgHsDieptsiz5 = 44,
    /// `OTG_HS_DTXFSTS5` at offset `0x1B8`, resets to `0x0000_0000`, read-only.
    OtgHsDtxfsts5 = 45,
    /// `OTG_HS_DIEPCTL6` at offset `0x1C0`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl6 = 46,
    /// `OTG_HS_DIEPINT6` at offset `0x1C8`, resets to `0x0000_0000`, read-write.
    OtgHsDiepint6 = 47,
    /// `OTG_HS_DIEPCTL7` at offset `0x1E0`, resets to `0x0000_0000`, read-write.
    OtgHsDiepctl7 = 48,
    /// `OTG_HS_DIEPINT7` at offset `0x1E8`, resets to `0x0000_0000`, read-write.
    OtgHsDiepint7 = 49,
    /// `OTG_HS_DOEPCTL0` at offset `0x300`, resets to `0x0000_8000`, read-write.
    OtgHsDoepctl0 = 50,
    /// `OTG_HS_DOEPINT0` at offset `0x308`, resets to `0x0000_0080`, read-write.
    OtgHsDoepint0 = 51,
    /// `OTG_HS_DOEPTSIZ0` at offset `0x310`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz0 = 52,
    /// `OTG_HS_DOEPCTL1` at offset `0x320`, resets to `0x0000_0000`, read-write.
    OtgHsDoepctl1 = 53,
    /// `OTG_HS_DOEPINT1` at offset `0x328`, resets to `0x0000_0000`, read-write.
    OtgHsDoepint1 = 54,
    /// `OTG_HS_DOEPTSIZ1` at offset `0x330`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz1 = 55,
    /// `OTG_HS_DOEPCTL2` at offset `0x340`, resets to `0x0000_0000`, read-write.
    OtgHsDoepctl2 = 56,
    /// `OTG_HS_DOEPINT2` at offset `0x348`, resets to `0x0000_0000`, read-write.
    OtgHsDoepint2 = 57,
    /// `OTG_HS_DOEPTSIZ2` at offset `0x350`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz2 = 58,
    /// `OTG_HS_DOEPCTL3` at offset `0x360`, resets to `0x0000_0000`, read-write.
    OtgHsDoepctl3 = 59,
    /// `OTG_HS_DOEPINT3` at offset `0x368`, resets to `0x0000_0000`, read-write.
    OtgHsDoepint3 = 60,
    /// `OTG_HS_DOEPTSIZ3` at offset `0x370`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz3 = 61,
    /// `OTG_HS_DOEPCTL4` at offset `0x380`, resets to `0x0000_0000`, read-write.
    OtgHsDoepctl4 = 62,
    /// `OTG_HS_DOEPINT4` at offset `0x388`, resets to `0x0000_0000`, read-write.
    OtgHsDoepint4 = 63,
    /// `OTG_HS_DOEPTSIZ4` at offset `0x390`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz4 = 64,
    /// `OTG_HS_DOEPCTL5` at offset `0x3A0`, resets to `0x0000_0000`, read-write.
    OtgHsDoepctl5 = 65,
    /// `OTG_HS_DOEPINT5` at offset `0x3A8`, resets to `0x0000_0000`, read-write.
    OtgHsDoepint5 = 66,
    /// `OTG_HS_DOEPTSIZ5` at offset `0x3B0`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz5 = 67,
    /// `OTG_HS_DOEPCTL6` at offset `0x3C0`, resets to `0x0000_0000`, read-write.
    OtgHsDoepctl6 = 68,
    /// `OTG_HS_DOEPINT6` at offset `0x3C8`, resets to `0x0000_0000`, read-write.
    OtgHsDoepint6 = 69,
    /// `OTG_HS_DOEPTSIZ6` at offset `0x3D0`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz6 = 70,
    /// `OTG_HS_DOEPCTL7` at offset `0x3E0`, resets to `0x0000_0000`, read-write.
    OtgHsDoepctl7 = 71,
    /// `OTG_HS_DOEPINT7` at offset `0x3E8`, resets to `0x0000_0000`, read-write.
    OtgHsDoepint7 = 72,
    /// `OTG_HS_DOEPTSIZ7` at offset `0x3F0`, resets to `0x0000_0000`, read-write.
    OtgHsDoeptsiz7 = 73,
}

impl Register {
    /// Every register, in table order.
    pub const ALL: [Self; 74] = [Self::OtgHsDcfg, Self::OtgHsDctl, Self::OtgHsDsts, Self::OtgHsDiepmsk, Self::OtgHsDoepmsk, Self::OtgHsDaint, Self::OtgHsDaintmsk, Self::OtgHsDvbusdis, Self::OtgHsDvbuspulse, Self::OtgHsDthrctl, Self::OtgHsDiepempmsk, Self::OtgHsDeachint, Self::OtgHsDeachintmsk, Self::OtgHsDiepctl0, Self::OtgHsDiepint0, Self::OtgHsDieptsiz0, Self::OtgHsDiepdma1, Self::OtgHsDtxfsts0, Self::OtgHsDiepctl1, Self::OtgHsDiepint1, Self::OtgHsDieptsiz1, Self::OtgHsDiepdma2, Self::OtgHsDtxfsts1, Self::OtgHsDiepctl2, Self::OtgHsDiepint2, Self::OtgHsDieptsiz2, Self::OtgHsDiepdma3, Self::OtgHsDtxfsts2, Self::OtgHsDiepctl3, Self::OtgHsDiepint3, Self::OtgHsDieptsiz3, Self::OtgHsDiepdma4, Self::OtgHsDtxfsts3, Self::OtgHsDiepctl4, Self::OtgHsDiepint4, Self::OtgHsDieptsiz4, Self::OtgHsDiepdma5, Self::OtgHsDtxfsts4, Self::OtgHsDiepctl5, Self::OtgHsDieptsiz6, Self::OtgHsDtxfsts6, Self::OtgHsDiepint5, Self::OtgHsDieptsiz7, Self::OtgHsDtxfsts7, Self::OtgHsDieptsiz5, Self::OtgHsDtxfsts5, Self::OtgHsDiepctl6, Self::OtgHsDiepint6, Self::OtgHsDiepctl7, Self::OtgHsDiepint7, Self::OtgHsDoepctl0, Self::OtgHsDoepint0, Self::OtgHsDoeptsiz0, Self::OtgHsDoepctl1, Self::OtgHsDoepint1, Self::OtgHsDoeptsiz1, Self::OtgHsDoepctl2, Self::OtgHsDoepint2, Self::OtgHsDoeptsiz2, Self::OtgHsDoepctl3, Self::OtgHsDoepint3, Self::OtgHsDoeptsiz3, Self::OtgHsDoepctl4, Self::OtgHsDoepint4, Self::OtgHsDoeptsiz4, Self::OtgHsDoepctl5, Self::OtgHsDoepint5, Self::OtgHsDoeptsiz5, Self::OtgHsDoepctl6, Self::OtgHsDoepint6, Self::OtgHsDoeptsiz6, Self::OtgHsDoepctl7, Self::OtgHsDoepint7, Self::OtgHsDoeptsiz7];
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

/// The fields of `OTG_HS_DCFG`.
pub mod otg_hs_dcfg {
    use super::FieldSpec;
    /// `DSPD`, bits 0..=1.
    pub const DSPD: &FieldSpec = &super::REGISTERS[0].fields[0];
    /// `NZLSOHSK`, bit 2.
    pub const NZLSOHSK: &FieldSpec = &super::REGISTERS[0].fields[1];
    /// `DAD`, bits 4..=10.
    pub const DAD: &FieldSpec = &super::REGISTERS[0].fields[2];
    /// `PFIVL`, bits 11..=12.
    pub const PFIVL: &FieldSpec = &super::REGISTERS[0].fields[3];
    /// `PERSCHIVL`, bits 24..=25.
    pub const PERSCHIVL: &FieldSpec = &super::REGISTERS[0].fields[4];
}

/// The fields of `OTG_HS_DCTL`.
pub mod otg_hs_dctl {
    use super::FieldSpec;
    /// `RWUSIG`, bit 0.
    pub const RWUSIG: &FieldSpec = &super::REGISTERS[1].fields[0];
    /// `SDIS`, bit 1.
    pub const SDIS: &FieldSpec = &super::REGISTERS[1].fields[1];
    /// `GINSTS`, bit 2, read-only.
    pub const GINSTS: &FieldSpec = &super::REGISTERS[1].fields[2];
    /// `GONSTS`, bit 3, read-only.
    pub const GONSTS: &FieldSpec = &super::REGISTERS[1].fields[3];
    /// `TCTL`, bits 4..=6.
    pub const TCTL: &FieldSpec = &super::REGISTERS[1].fields[4];
    /// `SGINAK`, bit 7, write-only.
    pub const SGINAK: &FieldSpec = &super::REGISTERS[1].fields[5];
    /// `CGINAK`, bit 8, write-only.
    pub const CGINAK: &FieldSpec = &super::REGISTERS[1].fields[6];
    /// `SGONAK`, bit 9, write-only.
    pub const SGONAK: &FieldSpec = &super::REGISTERS[1].fields[7];
    /// `CGONAK`, bit 10, write-only.
    pub const CGONAK: &FieldSpec = &super::REGISTERS[1].fields[8];
    /// `POPRGDNE`, bit 11.
    pub const POPRGDNE: &FieldSpec = &super::REGISTERS[1].fields[9];
}

/// The fields of `OTG_HS_DSTS`.
pub mod otg_hs_dsts {
    use super::FieldSpec;
    /// `SUSPSTS`, bit 0.
    pub const SUSPSTS: &FieldSpec = &super::REGISTERS[2].fields[0];
    /// `ENUMSPD`, bits 1..=2.
    pub const ENUMSPD: &FieldSpec = &super::REGISTERS[2].fields[1];
    /// `EERR`, bit 3.
    pub const EERR: &FieldSpec = &super::REGISTERS[2].fields[2];
    /// `FNSOF`, bits 8..=21.
    pub const FNSOF: &FieldSpec = &super::REGISTERS[2].fields[3];
}

/// The fields of `OTG_HS_DIEPMSK`.
pub mod otg_hs_diepmsk {
    use super::FieldSpec;
    /// `XFRCM`, bit 0.
    pub const XFRCM: &FieldSpec = &super::REGISTERS[3].fields[0];
    /// `EPDM`, bit 1.
    pub const EPDM: &FieldSpec = &super::REGISTERS[3].fields[1];
    /// `TOM`, bit 3.
    pub const TOM: &FieldSpec = &super::REGISTERS[3].fields[2];
    /// `ITTXFEMSK`, bit 4.
    pub const ITTXFEMSK: &FieldSpec = &super::REGISTERS[3].fields[3];
    /// `INEPNMM`, bit 5.
    pub const INEPNMM: &FieldSpec = &super::REGISTERS[3].fields[4];
    /// `INEPNEM`, bit 6.
    pub const INEPNEM: &FieldSpec = &super::REGISTERS[3].fields[5];
    /// `TXFURM`, bit 8.
    pub const TXFURM: &FieldSpec = &super::REGISTERS[3].fields[6];
    /// `BIM`, bit 9.
    pub const BIM: &FieldSpec = &super::REGISTERS[3].fields[7];
}

/// The fields of `OTG_HS_DOEPMSK`.
pub mod otg_hs_doepmsk {
    use super::FieldSpec;
    /// `XFRCM`, bit 0.
    pub const XFRCM: &FieldSpec = &super::REGISTERS[4].fields[0];
    /// `EPDM`, bit 1.
    pub const EPDM: &FieldSpec = &super::REGISTERS[4].fields[1];
    /// `STUPM`, bit 3.
    pub const STUPM: &FieldSpec = &super::REGISTERS[4].fields[2];
    /// `OTEPDM`, bit 4.
    pub const OTEPDM: &FieldSpec = &super::REGISTERS[4].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[4].fields[4];
    /// `OPEM`, bit 8.
    pub const OPEM: &FieldSpec = &super::REGISTERS[4].fields[5];
    /// `BOIM`, bit 9.
    pub const BOIM: &FieldSpec = &super::REGISTERS[4].fields[6];
}

/// The fields of `OTG_HS_DAINT`.
pub mod otg_hs_daint {
    use super::FieldSpec;
    /// `IEPINT`, bits 0..=15.
    pub const IEPINT: &FieldSpec = &super::REGISTERS[5].fields[0];
    /// `OEPINT`, bits 16..=31.
    pub const OEPINT: &FieldSpec = &super::REGISTERS[5].fields[1];
}

/// The fields of `OTG_HS_DAINTMSK`.
pub mod otg_hs_daintmsk {
    use super::FieldSpec;
    /// `IEPM`, bits 0..=15.
    pub const IEPM: &FieldSpec = &super::REGISTERS[6].fields[0];
    /// `OEPM`, bits 16..=31.
    pub const OEPM: &FieldSpec = &super::REGISTERS[6].fields[1];
}

/// The fields of `OTG_HS_DVBUSDIS`.
pub mod otg_hs_dvbusdis {
    use super::FieldSpec;
    /// `VBUSDT`, bits 0..=15.
    pub const VBUSDT: &FieldSpec = &super::REGISTERS[7].fields[0];
}

/// The fields of `OTG_HS_DVBUSPULSE`.
pub mod otg_hs_dvbuspulse {
    use super::FieldSpec;
    /// `DVBUSP`, bits 0..=11.
    pub const DVBUSP: &FieldSpec = &super::REGISTERS[8].fields[0];
}

/// The fields of `OTG_HS_DTHRCTL`.
pub mod otg_hs_dthrctl {
    use super::FieldSpec;
    /// `NONISOTHREN`, bit 0.
    pub const NONISOTHREN: &FieldSpec = &super::REGISTERS[9].fields[0];
    /// `ISOTHREN`, bit 1.
    pub const ISOTHREN: &FieldSpec = &super::REGISTERS[9].fields[1];
    /// `TXTHRLEN`, bits 2..=10.
    pub const TXTHRLEN: &FieldSpec = &super::REGISTERS[9].fields[2];
    /// `RXTHREN`, bit 16.
    pub const RXTHREN: &FieldSpec = &super::REGISTERS[9].fields[3];
    /// `RXTHRLEN`, bits 17..=25.
    pub const RXTHRLEN: &FieldSpec = &super::REGISTERS[9].fields[4];
    /// `ARPEN`, bit 27.
    pub const ARPEN: &FieldSpec = &super::REGISTERS[9].fields[5];
}

/// The fields of `OTG_HS_DIEPEMPMSK`.
pub mod otg_hs_diepempmsk {
    use super::FieldSpec;
    /// `INEPTXFEM`, bits 0..=15.
    pub const INEPTXFEM: &FieldSpec = &super::REGISTERS[10].fields[0];
}

/// The fields of `OTG_HS_DEACHINT`.
pub mod otg_hs_deachint {
    use super::FieldSpec;
    /// `IEP1INT`, bit 1.
    pub const IEP1INT: &FieldSpec = &super::REGISTERS[11].fields[0];
    /// `OEP1INT`, bit 17.
    pub const OEP1INT: &FieldSpec = &super::REGISTERS[11].fields[1];
}

/// The fields of `OTG_HS_DEACHINTMSK`.
pub mod otg_hs_deachintmsk {
    use super::FieldSpec;
    /// `IEP1INTM`, bit 1.
    pub const IEP1INTM: &FieldSpec = &super::REGISTERS[12].fields[0];
    /// `OEP1INTM`, bit 17.
    pub const OEP1INTM: &FieldSpec = &super::REGISTERS[12].fields[1];
}

/// The fields of `OTG_HS_DIEPCTL0`.
pub mod otg_hs_diepctl0 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[13].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[13].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[13].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[13].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[13].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[13].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[13].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[13].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[13].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[13].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[13].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[13].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[13].fields[12];
}

/// The fields of `OTG_HS_DIEPINT0`.
pub mod otg_hs_diepint0 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[14].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[14].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[14].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[14].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[14].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[14].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[14].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[14].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[14].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[14].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[14].fields[10];
}

/// The fields of `OTG_HS_DIEPTSIZ0`.
pub mod otg_hs_dieptsiz0 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=6.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[15].fields[0];
    /// `PKTCNT`, bits 19..=20.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[15].fields[1];
}

/// The fields of `OTG_HS_DIEPDMA1`.
pub mod otg_hs_diepdma1 {
    use super::FieldSpec;
    /// `DMAADDR`, bits 0..=31.
    pub const DMAADDR: &FieldSpec = &super::REGISTERS[16].fields[0];
}

/// The fields of `OTG_HS_DTXFSTS0`.
pub mod otg_hs_dtxfsts0 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[17].fields[0];
}

/// The fields of `OTG_HS_DIEPCTL1`.
pub mod otg_hs_diepctl1 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[18].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[18].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[18].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[18].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[18].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[18].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[18].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[18].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[18].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[18].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[18].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[18].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[18].fields[12];
}

/// The fields of `OTG_HS_DIEPINT1`.
pub mod otg_hs_diepint1 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[19].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[19].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[19].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[19].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[19].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[19].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[19].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[19].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[19].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[19].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[19].fields[10];
}

/// The fields of `OTG_HS_DIEPTSIZ1`.
pub mod otg_hs_dieptsiz1 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[20].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[20].fields[1];
    /// `MCNT`, bits 29..=30.
    pub const MCNT: &FieldSpec = &super::REGISTERS[20].fields[2];
}

/// The fields of `OTG_HS_DIEPDMA2`.
pub mod otg_hs_diepdma2 {
    use super::FieldSpec;
    /// `DMAADDR`, bits 0..=31.
    pub const DMAADDR: &FieldSpec = &super::REGISTERS[21].fields[0];
}

/// The fields of `OTG_HS_DTXFSTS1`.
pub mod otg_hs_dtxfsts1 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[22].fields[0];
}

/// The fields of `OTG_HS_DIEPCTL2`.
pub mod otg_hs_diepctl2 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[23].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[23].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[23].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[23].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[23].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[23].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[23].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[23].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[23].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[23].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[23].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[23].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[23].fields[12];
}

/// The fields of `OTG_HS_DIEPINT2`.
pub mod otg_hs_diepint2 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[24].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[24].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[24].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[24].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[24].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[24].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[24].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[24].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[24].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[24].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[24].fields[10];
}

/// The fields of `OTG_HS_DIEPTSIZ2`.
pub mod otg_hs_dieptsiz2 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[25].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[25].fields[1];
    /// `MCNT`, bits 29..=30.
    pub const MCNT: &FieldSpec = &super::REGISTERS[25].fields[2];
}

/// The fields of `OTG_HS_DIEPDMA3`.
pub mod otg_hs_diepdma3 {
    use super::FieldSpec;
    /// `DMAADDR`, bits 0..=31.
    pub const DMAADDR: &FieldSpec = &super::REGISTERS[26].fields[0];
}

/// The fields of `OTG_HS_DTXFSTS2`.
pub mod otg_hs_dtxfsts2 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[27].fields[0];
}

/// The fields of `OTG_HS_DIEPCTL3`.
pub mod otg_hs_diepctl3 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[28].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[28].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[28].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[28].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[28].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[28].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[28].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[28].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[28].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[28].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[28].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[28].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[28].fields[12];
}

/// The fields of `OTG_HS_DIEPINT3`.
pub mod otg_hs_diepint3 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[29].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[29].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[29].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[29].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[29].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[29].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[29].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[29].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[29].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[29].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[29].fields[10];
}

/// The fields of `OTG_HS_DIEPTSIZ3`.
pub mod otg_hs_dieptsiz3 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[30].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[30].fields[1];
    /// `MCNT`, bits 29..=30.
    pub const MCNT: &FieldSpec = &super::REGISTERS[30].fields[2];
}

/// The fields of `OTG_HS_DIEPDMA4`.
pub mod otg_hs_diepdma4 {
    use super::FieldSpec;
    /// `DMAADDR`, bits 0..=31.
    pub const DMAADDR: &FieldSpec = &super::REGISTERS[31].fields[0];
}

/// The fields of `OTG_HS_DTXFSTS3`.
pub mod otg_hs_dtxfsts3 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[32].fields[0];
}

/// The fields of `OTG_HS_DIEPCTL4`.
pub mod otg_hs_diepctl4 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[33].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[33].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[33].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[33].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[33].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[33].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[33].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[33].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[33].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[33].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[33].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[33].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[33].fields[12];
}

/// The fields of `OTG_HS_DIEPINT4`.
pub mod otg_hs_diepint4 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[34].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[34].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[34].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[34].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[34].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[34].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[34].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[34].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[34].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[34].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[34].fields[10];
}

/// The fields of `OTG_HS_DIEPTSIZ4`.
pub mod otg_hs_dieptsiz4 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[35].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[35].fields[1];
    /// `MCNT`, bits 29..=30.
    pub const MCNT: &FieldSpec = &super::REGISTERS[35].fields[2];
}

/// The fields of `OTG_HS_DIEPDMA5`.
pub mod otg_hs_diepdma5 {
    use super::FieldSpec;
    /// `DMAADDR`, bits 0..=31.
    pub const DMAADDR: &FieldSpec = &super::REGISTERS[36].fields[0];
}

/// The fields of `OTG_HS_DTXFSTS4`.
pub mod otg_hs_dtxfsts4 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[37].fields[0];
}

/// The fields of `OTG_HS_DIEPCTL5`.
pub mod otg_hs_diepctl5 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[38].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[38].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[38].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[38].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[38].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[38].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[38].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[38].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[38].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[38].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[38].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[38].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[38].fields[12];
}

/// The fields of `OTG_HS_DIEPTSIZ6`.
pub mod otg_hs_dieptsiz6 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[39].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[39].fields[1];
    /// `MCNT`, bits 29..=30.
    pub const MCNT: &FieldSpec = &super::REGISTERS[39].fields[2];
}

/// The fields of `OTG_HS_DTXFSTS6`.
pub mod otg_hs_dtxfsts6 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[40].fields[0];
}

/// The fields of `OTG_HS_DIEPINT5`.
pub mod otg_hs_diepint5 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[41].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[41].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[41].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[41].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[41].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[41].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[41].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[41].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[41].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[41].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[41].fields[10];
}

/// The fields of `OTG_HS_DIEPTSIZ7`.
pub mod otg_hs_dieptsiz7 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[42].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[42].fields[1];
    /// `MCNT`, bits 29..=30.
    pub const MCNT: &FieldSpec = &super::REGISTERS[42].fields[2];
}

/// The fields of `OTG_HS_DTXFSTS7`.
pub mod otg_hs_dtxfsts7 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[43].fields[0];
}

/// The fields of `OTG_HS_DIEPTSIZ5`.
pub mod otg_hs_dieptsiz5 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[44].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[44].fields[1];
    /// `MCNT`, bits 29..=30.
    pub const MCNT: &FieldSpec = &super::REGISTERS[44].fields[2];
}

/// The fields of `OTG_HS_DTXFSTS5`.
pub mod otg_hs_dtxfsts5 {
    use super::FieldSpec;
    /// `INEPTFSAV`, bits 0..=15.
    pub const INEPTFSAV: &FieldSpec = &super::REGISTERS[45].fields[0];
}

/// The fields of `OTG_HS_DIEPCTL6`.
pub mod otg_hs_diepctl6 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[46].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[46].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[46].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[46].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[46].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[46].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[46].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[46].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[46].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[46].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[46].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[46].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[46].fields[12];
}

/// The fields of `OTG_HS_DIEPINT6`.
pub mod otg_hs_diepint6 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[47].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[47].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[47].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[47].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[47].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[47].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[47].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[47].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[47].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[47].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[47].fields[10];
}

/// The fields of `OTG_HS_DIEPCTL7`.
pub mod otg_hs_diepctl7 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[48].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[48].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[48].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[48].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[48].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[48].fields[5];
    /// `TXFNUM`, bits 22..=25.
    pub const TXFNUM: &FieldSpec = &super::REGISTERS[48].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[48].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[48].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[48].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[48].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[48].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[48].fields[12];
}

/// The fields of `OTG_HS_DIEPINT7`.
pub mod otg_hs_diepint7 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[49].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[49].fields[1];
    /// `TOC`, bit 3.
    pub const TOC: &FieldSpec = &super::REGISTERS[49].fields[2];
    /// `ITTXFE`, bit 4.
    pub const ITTXFE: &FieldSpec = &super::REGISTERS[49].fields[3];
    /// `INEPNE`, bit 6.
    pub const INEPNE: &FieldSpec = &super::REGISTERS[49].fields[4];
    /// `TXFE`, bit 7, read-only.
    pub const TXFE: &FieldSpec = &super::REGISTERS[49].fields[5];
    /// `TXFIFOUDRN`, bit 8.
    pub const TXFIFOUDRN: &FieldSpec = &super::REGISTERS[49].fields[6];
    /// `BNA`, bit 9.
    pub const BNA: &FieldSpec = &super::REGISTERS[49].fields[7];
    /// `PKTDRPSTS`, bit 11.
    pub const PKTDRPSTS: &FieldSpec = &super::REGISTERS[49].fields[8];
    /// `BERR`, bit 12.
    pub const BERR: &FieldSpec = &super::REGISTERS[49].fields[9];
    /// `NAK`, bit 13.
    pub const NAK: &FieldSpec = &super::REGISTERS[49].fields[10];
}

/// The fields of `OTG_HS_DOEPCTL0`.
pub mod otg_hs_doepctl0 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=1, read-only.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[50].fields[0];
    /// `USBAEP`, bit 15, read-only.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[50].fields[1];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[50].fields[2];
    /// `EPTYP`, bits 18..=19, read-only.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[50].fields[3];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[50].fields[4];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[50].fields[5];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[50].fields[6];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[50].fields[7];
    /// `EPDIS`, bit 30, read-only.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[50].fields[8];
    /// `EPENA`, bit 31, write-only.
    pub const EPENA: &FieldSpec = &super::REGISTERS[50].fields[9];
}

/// The fields of `OTG_HS_DOEPINT0`.
pub mod otg_hs_doepint0 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[51].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[51].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[51].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[51].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[51].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[51].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ0`.
pub mod otg_hs_doeptsiz0 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=6.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[52].fields[0];
    /// `PKTCNT`, bit 19.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[52].fields[1];
    /// `STUPCNT`, bits 29..=30.
    pub const STUPCNT: &FieldSpec = &super::REGISTERS[52].fields[2];
}

/// The fields of `OTG_HS_DOEPCTL1`.
pub mod otg_hs_doepctl1 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[53].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[53].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[53].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[53].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[53].fields[4];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[53].fields[5];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[53].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[53].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[53].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[53].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[53].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[53].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[53].fields[12];
}

/// The fields of `OTG_HS_DOEPINT1`.
pub mod otg_hs_doepint1 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[54].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[54].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[54].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[54].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[54].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[54].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ1`.
pub mod otg_hs_doeptsiz1 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[55].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[55].fields[1];
    /// `RXDPID_STUPCNT`, bits 29..=30.
    pub const RXDPID_STUPCNT: &FieldSpec = &super::REGISTERS[55].fields[2];
}

/// The fields of `OTG_HS_DOEPCTL2`.
pub mod otg_hs_doepctl2 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[56].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[56].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[56].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[56].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[56].fields[4];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[56].fields[5];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[56].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[56].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[56].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[56].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[56].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[56].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[56].fields[12];
}

/// The fields of `OTG_HS_DOEPINT2`.
pub mod otg_hs_doepint2 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[57].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[57].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[57].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[57].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[57].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[57].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ2`.
pub mod otg_hs_doeptsiz2 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[58].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[58].fields[1];
    /// `RXDPID_STUPCNT`, bits 29..=30.
    pub const RXDPID_STUPCNT: &FieldSpec = &super::REGISTERS[58].fields[2];
}

/// The fields of `OTG_HS_DOEPCTL3`.
pub mod otg_hs_doepctl3 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[59].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[59].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[59].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[59].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[59].fields[4];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[59].fields[5];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[59].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[59].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[59].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[59].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[59].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[59].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[59].fields[12];
}

/// The fields of `OTG_HS_DOEPINT3`.
pub mod otg_hs_doepint3 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[60].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[60].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[60].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[60].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[60].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[60].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ3`.
pub mod otg_hs_doeptsiz3 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[61].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[61].fields[1];
    /// `RXDPID_STUPCNT`, bits 29..=30.
    pub const RXDPID_STUPCNT: &FieldSpec = &super::REGISTERS[61].fields[2];
}

/// The fields of `OTG_HS_DOEPCTL4`.
pub mod otg_hs_doepctl4 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[62].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[62].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[62].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[62].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[62].fields[4];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[62].fields[5];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[62].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[62].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[62].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[62].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[62].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[62].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[62].fields[12];
}

/// The fields of `OTG_HS_DOEPINT4`.
pub mod otg_hs_doepint4 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[63].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[63].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[63].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[63].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[63].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[63].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ4`.
pub mod otg_hs_doeptsiz4 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[64].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[64].fields[1];
    /// `RXDPID_STUPCNT`, bits 29..=30.
    pub const RXDPID_STUPCNT: &FieldSpec = &super::REGISTERS[64].fields[2];
}

/// The fields of `OTG_HS_DOEPCTL5`.
pub mod otg_hs_doepctl5 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[65].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[65].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[65].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[65].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[65].fields[4];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[65].fields[5];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[65].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[65].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[65].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[65].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[65].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[65].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[65].fields[12];
}

/// The fields of `OTG_HS_DOEPINT5`.
pub mod otg_hs_doepint5 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[66].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[66].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[66].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[66].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[66].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[66].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ5`.
pub mod otg_hs_doeptsiz5 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[67].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[67].fields[1];
    /// `RXDPID_STUPCNT`, bits 29..=30.
    pub const RXDPID_STUPCNT: &FieldSpec = &super::REGISTERS[67].fields[2];
}

/// The fields of `OTG_HS_DOEPCTL6`.
pub mod otg_hs_doepctl6 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[68].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[68].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[68].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[68].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[68].fields[4];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[68].fields[5];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[68].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[68].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[68].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[68].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[68].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[68].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[68].fields[12];
}

/// The fields of `OTG_HS_DOEPINT6`.
pub mod otg_hs_doepint6 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[69].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[69].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[69].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[69].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[69].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[69].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ6`.
pub mod otg_hs_doeptsiz6 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[70].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[70].fields[1];
    /// `RXDPID_STUPCNT`, bits 29..=30.
    pub const RXDPID_STUPCNT: &FieldSpec = &super::REGISTERS[70].fields[2];
}

/// The fields of `OTG_HS_DOEPCTL7`.
pub mod otg_hs_doepctl7 {
    use super::FieldSpec;
    /// `MPSIZ`, bits 0..=10.
    pub const MPSIZ: &FieldSpec = &super::REGISTERS[71].fields[0];
    /// `USBAEP`, bit 15.
    pub const USBAEP: &FieldSpec = &super::REGISTERS[71].fields[1];
    /// `EONUM_DPID`, bit 16, read-only.
    pub const EONUM_DPID: &FieldSpec = &super::REGISTERS[71].fields[2];
    /// `NAKSTS`, bit 17, read-only.
    pub const NAKSTS: &FieldSpec = &super::REGISTERS[71].fields[3];
    /// `EPTYP`, bits 18..=19.
    pub const EPTYP: &FieldSpec = &super::REGISTERS[71].fields[4];
    /// `SNPM`, bit 20.
    pub const SNPM: &FieldSpec = &super::REGISTERS[71].fields[5];
    /// `Stall`, bit 21.
    pub const STALL: &FieldSpec = &super::REGISTERS[71].fields[6];
    /// `CNAK`, bit 26, write-only.
    pub const CNAK: &FieldSpec = &super::REGISTERS[71].fields[7];
    /// `SNAK`, bit 27, write-only.
    pub const SNAK: &FieldSpec = &super::REGISTERS[71].fields[8];
    /// `SD0PID_SEVNFRM`, bit 28, write-only.
    pub const SD0PID_SEVNFRM: &FieldSpec = &super::REGISTERS[71].fields[9];
    /// `SODDFRM`, bit 29, write-only.
    pub const SODDFRM: &FieldSpec = &super::REGISTERS[71].fields[10];
    /// `EPDIS`, bit 30.
    pub const EPDIS: &FieldSpec = &super::REGISTERS[71].fields[11];
    /// `EPENA`, bit 31.
    pub const EPENA: &FieldSpec = &super::REGISTERS[71].fields[12];
}

/// The fields of `OTG_HS_DOEPINT7`.
pub mod otg_hs_doepint7 {
    use super::FieldSpec;
    /// `XFRC`, bit 0.
    pub const XFRC: &FieldSpec = &super::REGISTERS[72].fields[0];
    /// `EPDISD`, bit 1.
    pub const EPDISD: &FieldSpec = &super::REGISTERS[72].fields[1];
    /// `STUP`, bit 3.
    pub const STUP: &FieldSpec = &super::REGISTERS[72].fields[2];
    /// `OTEPDIS`, bit 4.
    pub const OTEPDIS: &FieldSpec = &super::REGISTERS[72].fields[3];
    /// `B2BSTUP`, bit 6.
    pub const B2BSTUP: &FieldSpec = &super::REGISTERS[72].fields[4];
    /// `NYET`, bit 14.
    pub const NYET: &FieldSpec = &super::REGISTERS[72].fields[5];
}

/// The fields of `OTG_HS_DOEPTSIZ7`.
pub mod otg_hs_doeptsiz7 {
    use super::FieldSpec;
    /// `XFRSIZ`, bits 0..=18.
    pub const XFRSIZ: &FieldSpec = &super::REGISTERS[73].fields[0];
    /// `PKTCNT`, bits 19..=28.
    pub const PKTCNT: &FieldSpec = &super::REGISTERS[73].fields[1];
    /// `RXDPID_STUPCNT`, bits 29..=30.
    pub const RXDPID_STUPCNT: &FieldSpec = &super::REGISTERS[73].fields[2];
}

/// The register table.
pub static REGISTERS: [RegisterSpec; 74] = [
    RegisterSpec { name: "OTG_HS_DCFG", offset: 0x0, width: Width::W32, reset: 0x0220_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DSPD", bit: 0, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NZLSOHSK", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DAD", bit: 4, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PFIVL", bit: 11, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PERSCHIVL", bit: 24, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DCTL", offset: 0x4, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "RWUSIG", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SDIS", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GINSTS", bit: 2, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GONSTS", bit: 3, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TCTL", bit: 4, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SGINAK", bit: 7, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CGINAK", bit: 8, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SGONAK", bit: 9, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CGONAK", bit: 10, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "POPRGDNE", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DSTS", offset: 0x8, width: Width::W32, reset: 0x0000_0010, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SUSPSTS", bit: 0, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ENUMSPD", bit: 1, width: 2, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EERR", bit: 3, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "FNSOF", bit: 8, width: 14, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPMSK", offset: 0x10, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRCM", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDM", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOM", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFEMSK", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNMM", bit: 5, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNEM", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFURM", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BIM", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPMSK", offset: 0x14, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRCM", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDM", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUPM", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDM", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OPEM", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BOIM", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DAINT", offset: 0x18, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "IEPINT", bit: 0, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OEPINT", bit: 16, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DAINTMSK", offset: 0x1C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "IEPM", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OEPM", bit: 16, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DVBUSDIS", offset: 0x28, width: Width::W32, reset: 0x0000_17D7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "VBUSDT", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DVBUSPULSE", offset: 0x2C, width: Width::W32, reset: 0x0000_05B8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DVBUSP", bit: 0, width: 12, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTHRCTL", offset: 0x30, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "NONISOTHREN", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ISOTHREN", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXTHRLEN", bit: 2, width: 9, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXTHREN", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXTHRLEN", bit: 17, width: 9, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ARPEN", bit: 27, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPEMPMSK", offset: 0x34, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTXFEM", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DEACHINT", offset: 0x38, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "IEP1INT", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OEP1INT", bit: 17, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DEACHINTMSK", offset: 0x3C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "IEP1INTM", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OEP1INTM", bit: 17, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL0", offset: 0x100, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT0", offset: 0x108, width: Width::W32, reset: 0x0000_0080, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ0", offset: 0x110, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPDMA1", offset: 0x114, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAADDR", bit: 0, width: 32, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS0", offset: 0x118, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL1", offset: 0x120, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT1", offset: 0x128, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ1", offset: 0x130, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPDMA2", offset: 0x134, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAADDR", bit: 0, width: 32, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS1", offset: 0x138, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL2", offset: 0x140, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT2", offset: 0x148, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ2", offset: 0x150, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPDMA3", offset: 0x154, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAADDR", bit: 0, width: 32, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS2", offset: 0x158, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL3", offset: 0x160, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT3", offset: 0x168, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ3", offset: 0x170, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPDMA4", offset: 0x174, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAADDR", bit: 0, width: 32, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS3", offset: 0x178, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL4", offset: 0x180, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT4", offset: 0x188, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ4", offset: 0x190, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPDMA5", offset: 0x194, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAADDR", bit: 0, width: 32, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS4", offset: 0x198, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL5", offset: 0x1A0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ6", offset: 0x1A0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS6", offset: 0x1A4, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT5", offset: 0x1A8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ7", offset: 0x1A8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS7", offset: 0x1AC, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPTSIZ5", offset: 0x1B0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DTXFSTS5", offset: 0x1B8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "INEPTFSAV", bit: 0, width: 16, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL6", offset: 0x1C0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT6", offset: 0x1C8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPCTL7", offset: 0x1E0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFNUM", bit: 22, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DIEPINT7", offset: 0x1E8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TOC", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ITTXFE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "INEPNE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFE", bit: 7, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TXFIFOUDRN", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BNA", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTDRPSTS", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BERR", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAK", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL0", offset: 0x300, width: Width::W32, reset: 0x0000_8000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 2, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT0", offset: 0x308, width: Width::W32, reset: 0x0000_0080, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ0", offset: 0x310, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 7, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL1", offset: 0x320, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT1", offset: 0x328, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ1", offset: 0x330, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXDPID_STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL2", offset: 0x340, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT2", offset: 0x348, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ2", offset: 0x350, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXDPID_STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL3", offset: 0x360, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT3", offset: 0x368, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ3", offset: 0x370, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXDPID_STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL4", offset: 0x380, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT4", offset: 0x388, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ4", offset: 0x390, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXDPID_STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL5", offset: 0x3A0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT5", offset: 0x3A8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ5", offset: 0x3B0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXDPID_STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL6", offset: 0x3C0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT6", offset: 0x3C8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ6", offset: 0x3D0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXDPID_STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPCTL7", offset: 0x3E0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "MPSIZ", bit: 0, width: 11, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "USBAEP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EONUM_DPID", bit: 16, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NAKSTS", bit: 17, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPTYP", bit: 18, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNPM", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "Stall", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CNAK", bit: 26, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SNAK", bit: 27, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SD0PID_SEVNFRM", bit: 28, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SODDFRM", bit: 29, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDIS", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPENA", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPINT7", offset: 0x3E8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "EPDISD", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "STUP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OTEPDIS", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2BSTUP", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "NYET", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "OTG_HS_DOEPTSIZ7", offset: 0x3F0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "XFRSIZ", bit: 0, width: 19, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "PKTCNT", bit: 19, width: 10, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "RXDPID_STUPCNT", bit: 29, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
];
