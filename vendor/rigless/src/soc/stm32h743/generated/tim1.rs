// rigless svd from STM32H743.svd, sha256 28dd22d7923a16c1167bda9cfe6cb20cc9e98d44095dd930fd987029a839af58. Do not edit.
// Copyright (c) 2025 STMicroelectronics.
// SPDX-License-Identifier: Apache-2.0
//! Registers of `TIM1` and the instances derived from it.

use rigless::soc::{Access, FieldSpec, Layout, ReadAction, RegisterSpec, Width, WriteModify};

/// The registers by name, where a variant's index is its row in [`REGISTERS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Register {
    /// `CR1` at offset `0x0`, resets to `0x0000_0000`, read-write.
    Cr1 = 0,
    /// `CR2` at offset `0x4`, resets to `0x0000_0000`, read-write.
    Cr2 = 1,
    /// `SMCR` at offset `0x8`, resets to `0x0000_0000`, read-write.
    Smcr = 2,
    /// `DIER` at offset `0xC`, resets to `0x0000_0000`, read-write.
    Dier = 3,
    /// `SR` at offset `0x10`, resets to `0x0000_0000`, read-write.
    Sr = 4,
    /// `EGR` at offset `0x14`, resets to `0x0000_0000`, write-only.
    Egr = 5,
    /// `CCMR1_Input` at offset `0x18`, resets to `0x0000_0000`, read-write.
    Ccmr1Input = 6,
    /// `CCMR1_Output` at offset `0x18`, resets to `0x0000_0000`, read-write.
    Ccmr1Output = 7,
    /// `CCMR2_Input` at offset `0x1C`, resets to `0x0000_0000`, read-write.
    Ccmr2Input = 8,
    /// `CCMR2_Output` at offset `0x1C`, resets to `0x0000_0000`, read-write.
    Ccmr2Output = 9,
    /// `CCER` at offset `0x20`, resets to `0x0000_0000`, read-write.
    Ccer = 10,
    /// `CNT` at offset `0x24`, resets to `0x0000_0000`, read-write.
    Cnt = 11,
    /// `PSC` at offset `0x28`, resets to `0x0000_0000`, read-write.
    Psc = 12,
    /// `ARR` at offset `0x2C`, resets to `0x0000_0000`, read-write.
    Arr = 13,
    /// `RCR` at offset `0x30`, resets to `0x0000_0000`, read-write.
    Rcr = 14,
    /// `CCR1` at offset `0x34`, resets to `0x0000_0000`, read-write.
    Ccr1 = 15,
    /// `CCR2` at offset `0x38`, resets to `0x0000_0000`, read-write.
    Ccr2 = 16,
    /// `CCR3` at offset `0x3C`, resets to `0x0000_0000`, read-write.
    Ccr3 = 17,
    /// `CCR4` at offset `0x40`, resets to `0x0000_0000`, read-write.
    Ccr4 = 18,
    /// `BDTR` at offset `0x44`, resets to `0x0000_0000`, read-write.
    Bdtr = 19,
    /// `DCR` at offset `0x48`, resets to `0x0000_0000`, read-write.
    Dcr = 20,
    /// `DMAR` at offset `0x4C`, resets to `0x0000_0000`, read-write.
    Dmar = 21,
    /// `CCMR3_Output` at offset `0x54`, resets to `0x0000_0000`, read-write.
    Ccmr3Output = 22,
    /// `CCR5` at offset `0x58`, resets to `0x0000_0000`, read-write.
    Ccr5 = 23,
    /// `CCR6` at offset `0x5C`, resets to `0x0000_0000`, read-write.
    Ccr6 = 24,
    /// `AF1` at offset `0x60`, resets to `0x0000_0000`, read-write.
    Af1 = 25,
    /// `AF2` at offset `0x64`, resets to `0x0000_0000`, read-write.
    Af2 = 26,
    /// `TISEL` at offset `0x68`, resets to `0x0000_0000`, read-write.
    Tisel = 27,
}

impl Register {
    /// Every register, in table order.
    pub const ALL: [Self; 28] = [Self::Cr1, Self::Cr2, Self::Smcr, Self::Dier, Self::Sr, Self::Egr, Self::Ccmr1Input, Self::Ccmr1Output, Self::Ccmr2Input, Self::Ccmr2Output, Self::Ccer, Self::Cnt, Self::Psc, Self::Arr, Self::Rcr, Self::Ccr1, Self::Ccr2, Self::Ccr3, Self::Ccr4, Self::Bdtr, Self::Dcr, Self::Dmar, Self::Ccmr3Output, Self::Ccr5, Self::Ccr6, Self::Af1, Self::Af2, Self::Tisel];
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

/// The fields of `CR1`.
pub mod cr1 {
    use super::FieldSpec;
    /// `CEN`, bit 0.
    pub const CEN: &FieldSpec = &super::REGISTERS[0].fields[0];
    /// `UDIS`, bit 1.
    pub const UDIS: &FieldSpec = &super::REGISTERS[0].fields[1];
    /// `URS`, bit 2.
    pub const URS: &FieldSpec = &super::REGISTERS[0].fields[2];
    /// `OPM`, bit 3.
    pub const OPM: &FieldSpec = &super::REGISTERS[0].fields[3];
    /// `DIR`, bit 4.
    pub const DIR: &FieldSpec = &super::REGISTERS[0].fields[4];
    /// `CMS`, bits 5..=6.
    pub const CMS: &FieldSpec = &super::REGISTERS[0].fields[5];
    /// `ARPE`, bit 7.
    pub const ARPE: &FieldSpec = &super::REGISTERS[0].fields[6];
    /// `CKD`, bits 8..=9.
    pub const CKD: &FieldSpec = &super::REGISTERS[0].fields[7];
    /// `UIFREMAP`, bit 11.
    pub const UIFREMAP: &FieldSpec = &super::REGISTERS[0].fields[8];
}

/// The fields of `CR2`.
pub mod cr2 {
    use super::FieldSpec;
    /// `CCPC`, bit 0.
    pub const CCPC: &FieldSpec = &super::REGISTERS[1].fields[0];
    /// `CCUS`, bit 2.
    pub const CCUS: &FieldSpec = &super::REGISTERS[1].fields[1];
    /// `CCDS`, bit 3.
    pub const CCDS: &FieldSpec = &super::REGISTERS[1].fields[2];
    /// `MMS`, bits 4..=6.
    pub const MMS: &FieldSpec = &super::REGISTERS[1].fields[3];
    /// `TI1S`, bit 7.
    pub const TI1S: &FieldSpec = &super::REGISTERS[1].fields[4];
    /// `OIS1`, bit 8.
    pub const OIS1: &FieldSpec = &super::REGISTERS[1].fields[5];
    /// `OIS1N`, bit 9.
    pub const OIS1N: &FieldSpec = &super::REGISTERS[1].fields[6];
    /// `OIS2`, bit 10.
    pub const OIS2: &FieldSpec = &super::REGISTERS[1].fields[7];
    /// `OIS2N`, bit 11.
    pub const OIS2N: &FieldSpec = &super::REGISTERS[1].fields[8];
    /// `OIS3`, bit 12.
    pub const OIS3: &FieldSpec = &super::REGISTERS[1].fields[9];
    /// `OIS3N`, bit 13.
    pub const OIS3N: &FieldSpec = &super::REGISTERS[1].fields[10];
    /// `OIS4`, bit 14.
    pub const OIS4: &FieldSpec = &super::REGISTERS[1].fields[11];
    /// `OIS5`, bit 16.
    pub const OIS5: &FieldSpec = &super::REGISTERS[1].fields[12];
    /// `OIS6`, bit 18.
    pub const OIS6: &FieldSpec = &super::REGISTERS[1].fields[13];
    /// `MMS2`, bits 20..=23.
    pub const MMS2: &FieldSpec = &super::REGISTERS[1].fields[14];
}

/// The fields of `SMCR`.
pub mod smcr {
    use super::FieldSpec;
    /// `SMS`, bits 0..=2.
    pub const SMS: &FieldSpec = &super::REGISTERS[2].fields[0];
    /// `TS`, bits 4..=6.
    pub const TS: &FieldSpec = &super::REGISTERS[2].fields[1];
    /// `MSM`, bit 7.
    pub const MSM: &FieldSpec = &super::REGISTERS[2].fields[2];
    /// `ETF`, bits 8..=11.
    pub const ETF: &FieldSpec = &super::REGISTERS[2].fields[3];
    /// `ETPS`, bits 12..=13.
    pub const ETPS: &FieldSpec = &super::REGISTERS[2].fields[4];
    /// `ECE`, bit 14.
    pub const ECE: &FieldSpec = &super::REGISTERS[2].fields[5];
    /// `ETP`, bit 15.
    pub const ETP: &FieldSpec = &super::REGISTERS[2].fields[6];
    /// `SMS_3`, bit 16.
    pub const SMS_3: &FieldSpec = &super::REGISTERS[2].fields[7];
    /// `TS_4_3`, bits 20..=21.
    pub const TS_4_3: &FieldSpec = &super::REGISTERS[2].fields[8];
}

/// The fields of `DIER`.
pub mod dier {
    use super::FieldSpec;
    /// `UIE`, bit 0.
    pub const UIE: &FieldSpec = &super::REGISTERS[3].fields[0];
    /// `CC1IE`, bit 1.
    pub const CC1IE: &FieldSpec = &super::REGISTERS[3].fields[1];
    /// `CC2IE`, bit 2.
    pub const CC2IE: &FieldSpec = &super::REGISTERS[3].fields[2];
    /// `CC3IE`, bit 3.
    pub const CC3IE: &FieldSpec = &super::REGISTERS[3].fields[3];
    /// `CC4IE`, bit 4.
    pub const CC4IE: &FieldSpec = &super::REGISTERS[3].fields[4];
    /// `COMIE`, bit 5.
    pub const COMIE: &FieldSpec = &super::REGISTERS[3].fields[5];
    /// `TIE`, bit 6.
    pub const TIE: &FieldSpec = &super::REGISTERS[3].fields[6];
    /// `BIE`, bit 7.
    pub const BIE: &FieldSpec = &super::REGISTERS[3].fields[7];
    /// `UDE`, bit 8.
    pub const UDE: &FieldSpec = &super::REGISTERS[3].fields[8];
    /// `CC1DE`, bit 9.
    pub const CC1DE: &FieldSpec = &super::REGISTERS[3].fields[9];
    /// `CC2DE`, bit 10.
    pub const CC2DE: &FieldSpec = &super::REGISTERS[3].fields[10];
    /// `CC3DE`, bit 11.
    pub const CC3DE: &FieldSpec = &super::REGISTERS[3].fields[11];
    /// `CC4DE`, bit 12.
    pub const CC4DE: &FieldSpec = &super::REGISTERS[3].fields[12];
    /// `COMDE`, bit 13.
    pub const COMDE: &FieldSpec = &super::REGISTERS[3].fields[13];
    /// `TDE`, bit 14.
    pub const TDE: &FieldSpec = &super::REGISTERS[3].fields[14];
}

/// The fields of `SR`.
pub mod sr {
    use super::FieldSpec;
    /// `UIF`, bit 0.
    pub const UIF: &FieldSpec = &super::REGISTERS[4].fields[0];
    /// `CC1IF`, bit 1.
    pub const CC1IF: &FieldSpec = &super::REGISTERS[4].fields[1];
    /// `CC2IF`, bit 2.
    pub const CC2IF: &FieldSpec = &super::REGISTERS[4].fields[2];
    /// `CC3IF`, bit 3.
    pub const CC3IF: &FieldSpec = &super::REGISTERS[4].fields[3];
    /// `CC4IF`, bit 4.
    pub const CC4IF: &FieldSpec = &super::REGISTERS[4].fields[4];
    /// `COMIF`, bit 5.
    pub const COMIF: &FieldSpec = &super::REGISTERS[4].fields[5];
    /// `TIF`, bit 6.
    pub const TIF: &FieldSpec = &super::REGISTERS[4].fields[6];
    /// `BIF`, bit 7.
    pub const BIF: &FieldSpec = &super::REGISTERS[4].fields[7];
    /// `B2IF`, bit 8.
    pub const B2IF: &FieldSpec = &super::REGISTERS[4].fields[8];
    /// `CC1OF`, bit 9.
    pub const CC1OF: &FieldSpec = &super::REGISTERS[4].fields[9];
    /// `CC2OF`, bit 10.
    pub const CC2OF: &FieldSpec = &super::REGISTERS[4].fields[10];
    /// `CC3OF`, bit 11.
    pub const CC3OF: &FieldSpec = &super::REGISTERS[4].fields[11];
    /// `CC4OF`, bit 12.
    pub const CC4OF: &FieldSpec = &super::REGISTERS[4].fields[12];
    /// `SBIF`, bit 13.
    pub const SBIF: &FieldSpec = &super::REGISTERS[4].fields[13];
    /// `CC5IF`, bit 16.
    pub const CC5IF: &FieldSpec = &super::REGISTERS[4].fields[14];
    /// `CC6IF`, bit 17.
    pub const CC6IF: &FieldSpec = &super::REGISTERS[4].fields[15];
}

/// The fields of `EGR`.
pub mod egr {
    use super::FieldSpec;
    /// `UG`, bit 0.
    pub const UG: &FieldSpec = &super::REGISTERS[5].fields[0];
    /// `CC1G`, bit 1.
    pub const CC1G: &FieldSpec = &super::REGISTERS[5].fields[1];
    /// `CC2G`, bit 2.
    pub const CC2G: &FieldSpec = &super::REGISTERS[5].fields[2];
    /// `CC3G`, bit 3.
    pub const CC3G: &FieldSpec = &super::REGISTERS[5].fields[3];
    /// `CC4G`, bit 4.
    pub const CC4G: &FieldSpec = &super::REGISTERS[5].fields[4];
    /// `COMG`, bit 5.
    pub const COMG: &FieldSpec = &super::REGISTERS[5].fields[5];
    /// `TG`, bit 6.
    pub const TG: &FieldSpec = &super::REGISTERS[5].fields[6];
    /// `BG`, bit 7.
    pub const BG: &FieldSpec = &super::REGISTERS[5].fields[7];
    /// `B2G`, bit 8.
    pub const B2G: &FieldSpec = &super::REGISTERS[5].fields[8];
}

/// The fields of `CCMR1_Input`.
pub mod ccmr1_input {
    use super::FieldSpec;
    /// `CC1S`, bits 0..=1.
    pub const CC1S: &FieldSpec = &super::REGISTERS[6].fields[0];
    /// `IC1PSC`, bits 2..=3.
    pub const IC1PSC: &FieldSpec = &super::REGISTERS[6].fields[1];
    /// `IC1F`, bits 4..=7.
    pub const IC1F: &FieldSpec = &super::REGISTERS[6].fields[2];
    /// `CC2S`, bits 8..=9.
    pub const CC2S: &FieldSpec = &super::REGISTERS[6].fields[3];
    /// `IC2PSC`, bits 10..=11.
    pub const IC2PSC: &FieldSpec = &super::REGISTERS[6].fields[4];
    /// `IC2F`, bits 12..=15.
    pub const IC2F: &FieldSpec = &super::REGISTERS[6].fields[5];
}

/// The fields of `CCMR1_Output`.
pub mod ccmr1_output {
    use super::FieldSpec;
    /// `CC1S`, bits 0..=1.
    pub const CC1S: &FieldSpec = &super::REGISTERS[7].fields[0];
    /// `OC1FE`, bit 2.
    pub const OC1FE: &FieldSpec = &super::REGISTERS[7].fields[1];
    /// `OC1PE`, bit 3.
    pub const OC1PE: &FieldSpec = &super::REGISTERS[7].fields[2];
    /// `OC1M`, bits 4..=6.
    pub const OC1M: &FieldSpec = &super::REGISTERS[7].fields[3];
    /// `OC1CE`, bit 7.
    pub const OC1CE: &FieldSpec = &super::REGISTERS[7].fields[4];
    /// `CC2S`, bits 8..=9.
    pub const CC2S: &FieldSpec = &super::REGISTERS[7].fields[5];
    /// `OC2FE`, bit 10.
    pub const OC2FE: &FieldSpec = &super::REGISTERS[7].fields[6];
    /// `OC2PE`, bit 11.
    pub const OC2PE: &FieldSpec = &super::REGISTERS[7].fields[7];
    /// `OC2M`, bits 12..=14.
    pub const OC2M: &FieldSpec = &super::REGISTERS[7].fields[8];
    /// `OC2CE`, bit 15.
    pub const OC2CE: &FieldSpec = &super::REGISTERS[7].fields[9];
    /// `OC1M_3`, bit 16.
    pub const OC1M_3: &FieldSpec = &super::REGISTERS[7].fields[10];
    /// `OC2M_3`, bit 24.
    pub const OC2M_3: &FieldSpec = &super::REGISTERS[7].fields[11];
}

/// The fields of `CCMR2_Input`.
pub mod ccmr2_input {
    use super::FieldSpec;
    /// `CC3S`, bits 0..=1.
    pub const CC3S: &FieldSpec = &super::REGISTERS[8].fields[0];
    /// `IC3PSC`, bits 2..=3.
    pub const IC3PSC: &FieldSpec = &super::REGISTERS[8].fields[1];
    /// `IC3F`, bits 4..=7.
    pub const IC3F: &FieldSpec = &super::REGISTERS[8].fields[2];
    /// `CC4S`, bits 8..=9.
    pub const CC4S: &FieldSpec = &super::REGISTERS[8].fields[3];
    /// `IC4PSC`, bits 10..=11.
    pub const IC4PSC: &FieldSpec = &super::REGISTERS[8].fields[4];
    /// `IC4F`, bits 12..=15.
    pub const IC4F: &FieldSpec = &super::REGISTERS[8].fields[5];
}

/// The fields of `CCMR2_Output`.
pub mod ccmr2_output {
    use super::FieldSpec;
    /// `CC3S`, bits 0..=1.
    pub const CC3S: &FieldSpec = &super::REGISTERS[9].fields[0];
    /// `OC3FE`, bit 2.
    pub const OC3FE: &FieldSpec = &super::REGISTERS[9].fields[1];
    /// `OC3PE`, bit 3.
    pub const OC3PE: &FieldSpec = &super::REGISTERS[9].fields[2];
    /// `OC3M`, bits 4..=6.
    pub const OC3M: &FieldSpec = &super::REGISTERS[9].fields[3];
    /// `OC3CE`, bit 7.
    pub const OC3CE: &FieldSpec = &super::REGISTERS[9].fields[4];
    /// `CC4S`, bits 8..=9.
    pub const CC4S: &FieldSpec = &super::REGISTERS[9].fields[5];
    /// `OC4FE`, bit 10.
    pub const OC4FE: &FieldSpec = &super::REGISTERS[9].fields[6];
    /// `OC4PE`, bit 11.
    pub const OC4PE: &FieldSpec = &super::REGISTERS[9].fields[7];
    /// `OC4M`, bits 12..=14.
    pub const OC4M: &FieldSpec = &super::REGISTERS[9].fields[8];
    /// `OC4CE`, bit 15.
    pub const OC4CE: &FieldSpec = &super::REGISTERS[9].fields[9];
    /// `OC3M_3`, bit 16.
    pub const OC3M_3: &FieldSpec = &super::REGISTERS[9].fields[10];
    /// `OC4M_4`, bit 24.
    pub const OC4M_4: &FieldSpec = &super::REGISTERS[9].fields[11];
}

/// The fields of `CCER`.
pub mod ccer {
    use super::FieldSpec;
    /// `CC1E`, bit 0.
    pub const CC1E: &FieldSpec = &super::REGISTERS[10].fields[0];
    /// `CC1P`, bit 1.
    pub const CC1P: &FieldSpec = &super::REGISTERS[10].fields[1];
    /// `CC1NE`, bit 2.
    pub const CC1NE: &FieldSpec = &super::REGISTERS[10].fields[2];
    /// `CC1NP`, bit 3.
    pub const CC1NP: &FieldSpec = &super::REGISTERS[10].fields[3];
    /// `CC2E`, bit 4.
    pub const CC2E: &FieldSpec = &super::REGISTERS[10].fields[4];
    /// `CC2P`, bit 5.
    pub const CC2P: &FieldSpec = &super::REGISTERS[10].fields[5];
    /// `CC2NE`, bit 6.
    pub const CC2NE: &FieldSpec = &super::REGISTERS[10].fields[6];
    /// `CC2NP`, bit 7.
    pub const CC2NP: &FieldSpec = &super::REGISTERS[10].fields[7];
    /// `CC3E`, bit 8.
    pub const CC3E: &FieldSpec = &super::REGISTERS[10].fields[8];
    /// `CC3P`, bit 9.
    pub const CC3P: &FieldSpec = &super::REGISTERS[10].fields[9];
    /// `CC3NE`, bit 10.
    pub const CC3NE: &FieldSpec = &super::REGISTERS[10].fields[10];
    /// `CC3NP`, bit 11.
    pub const CC3NP: &FieldSpec = &super::REGISTERS[10].fields[11];
    /// `CC4E`, bit 12.
    pub const CC4E: &FieldSpec = &super::REGISTERS[10].fields[12];
    /// `CC4P`, bit 13.
    pub const CC4P: &FieldSpec = &super::REGISTERS[10].fields[13];
    /// `CC4NP`, bit 15.
    pub const CC4NP: &FieldSpec = &super::REGISTERS[10].fields[14];
    /// `CC5E`, bit 16.
    pub const CC5E: &FieldSpec = &super::REGISTERS[10].fields[15];
    /// `CC5P`, bit 17.
    pub const CC5P: &FieldSpec = &super::REGISTERS[10].fields[16];
    /// `CC6E`, bit 20.
    pub const CC6E: &FieldSpec = &super::REGISTERS[10].fields[17];
    /// `CC6P`, bit 21.
    pub const CC6P: &FieldSpec = &super::REGISTERS[10].fields[18];
}

/// The fields of `CNT`.
pub mod cnt {
    use super::FieldSpec;
    /// `CNT`, bits 0..=15.
    pub const CNT: &FieldSpec = &super::REGISTERS[11].fields[0];
    /// `UIFCPY`, bit 31, read-only.
    pub const UIFCPY: &FieldSpec = &super::REGISTERS[11].fields[1];
}

/// The fields of `PSC`.
pub mod psc {
    use super::FieldSpec;
    /// `PSC`, bits 0..=15.
    pub const PSC: &FieldSpec = &super::REGISTERS[12].fields[0];
}

/// The fields of `ARR`.
pub mod arr {
    use super::FieldSpec;
    /// `ARR`, bits 0..=15.
    pub const ARR: &FieldSpec = &super::REGISTERS[13].fields[0];
}

/// The fields of `RCR`.
pub mod rcr {
    use super::FieldSpec;
    /// `REP`, bits 0..=7.
    pub const REP: &FieldSpec = &super::REGISTERS[14].fields[0];
}

/// The fields of `CCR1`.
pub mod ccr1 {
    use super::FieldSpec;
    /// `CCR1`, bits 0..=15.
    pub const CCR1: &FieldSpec = &super::REGISTERS[15].fields[0];
}

/// The fields of `CCR2`.
pub mod ccr2 {
    use super::FieldSpec;
    /// `CCR2`, bits 0..=15.
    pub const CCR2: &FieldSpec = &super::REGISTERS[16].fields[0];
}

/// The fields of `CCR3`.
pub mod ccr3 {
    use super::FieldSpec;
    /// `CCR3`, bits 0..=15.
    pub const CCR3: &FieldSpec = &super::REGISTERS[17].fields[0];
}

/// The fields of `CCR4`.
pub mod ccr4 {
    use super::FieldSpec;
    /// `CCR4`, bits 0..=15.
    pub const CCR4: &FieldSpec = &super::REGISTERS[18].fields[0];
}

/// The fields of `BDTR`.
pub mod bdtr {
    use super::FieldSpec;
    /// `DTG`, bits 0..=7.
    pub const DTG: &FieldSpec = &super::REGISTERS[19].fields[0];
    /// `LOCK`, bits 8..=9.
    pub const LOCK: &FieldSpec = &super::REGISTERS[19].fields[1];
    /// `OSSI`, bit 10.
    pub const OSSI: &FieldSpec = &super::REGISTERS[19].fields[2];
    /// `OSSR`, bit 11.
    pub const OSSR: &FieldSpec = &super::REGISTERS[19].fields[3];
    /// `BKE`, bit 12.
    pub const BKE: &FieldSpec = &super::REGISTERS[19].fields[4];
    /// `BKP`, bit 13.
    pub const BKP: &FieldSpec = &super::REGISTERS[19].fields[5];
    /// `AOE`, bit 14.
    pub const AOE: &FieldSpec = &super::REGISTERS[19].fields[6];
    /// `MOE`, bit 15.
    pub const MOE: &FieldSpec = &super::REGISTERS[19].fields[7];
    /// `BKF`, bits 16..=19.
    pub const BKF: &FieldSpec = &super::REGISTERS[19].fields[8];
    /// `BK2F`, bits 20..=23.
    pub const BK2F: &FieldSpec = &super::REGISTERS[19].fields[9];
    /// `BK2E`, bit 24.
    pub const BK2E: &FieldSpec = &super::REGISTERS[19].fields[10];
    /// `BK2P`, bit 25.
    pub const BK2P: &FieldSpec = &super::REGISTERS[19].fields[11];
}

/// The fields of `DCR`.
pub mod dcr {
    use super::FieldSpec;
    /// `DBA`, bits 0..=4.
    pub const DBA: &FieldSpec = &super::REGISTERS[20].fields[0];
    /// `DBL`, bits 8..=12.
    pub const DBL: &FieldSpec = &super::REGISTERS[20].fields[1];
}

/// The fields of `DMAR`.
pub mod dmar {
    use super::FieldSpec;
    /// `DMAB`, bits 0..=15.
    pub const DMAB: &FieldSpec = &super::REGISTERS[21].fields[0];
}

/// The fields of `CCMR3_Output`.
pub mod ccmr3_output {
    use super::FieldSpec;
    /// `OC5FE`, bit 2.
    pub const OC5FE: &FieldSpec = &super::REGISTERS[22].fields[0];
    /// `OC5PE`, bit 3.
    pub const OC5PE: &FieldSpec = &super::REGISTERS[22].fields[1];
    /// `OC5M`, bits 4..=6.
    pub const OC5M: &FieldSpec = &super::REGISTERS[22].fields[2];
    /// `OC5CE`, bit 7.
    pub const OC5CE: &FieldSpec = &super::REGISTERS[22].fields[3];
    /// `OC6FE`, bit 10.
    pub const OC6FE: &FieldSpec = &super::REGISTERS[22].fields[4];
    /// `OC6PE`, bit 11.
    pub const OC6PE: &FieldSpec = &super::REGISTERS[22].fields[5];
    /// `OC6M`, bits 12..=14.
    pub const OC6M: &FieldSpec = &super::REGISTERS[22].fields[6];
    /// `OC6CE`, bit 15.
    pub const OC6CE: &FieldSpec = &super::REGISTERS[22].fields[7];
    /// `OC5M3`, bit 16.
    pub const OC5M3: &FieldSpec = &super::REGISTERS[22].fields[8];
    /// `OC6M3`, bit 24.
    pub const OC6M3: &FieldSpec = &super::REGISTERS[22].fields[9];
}

/// The fields of `CCR5`.
pub mod ccr5 {
    use super::FieldSpec;
    /// `CCR5`, bits 0..=15.
    pub const CCR5: &FieldSpec = &super::REGISTERS[23].fields[0];
    /// `GC5C1`, bit 29.
    pub const GC5C1: &FieldSpec = &super::REGISTERS[23].fields[1];
    /// `GC5C2`, bit 30.
    pub const GC5C2: &FieldSpec = &super::REGISTERS[23].fields[2];
    /// `GC5C3`, bit 31.
    pub const GC5C3: &FieldSpec = &super::REGISTERS[23].fields[3];
}

/// The fields of `CCR6`.
pub mod ccr6 {
    use super::FieldSpec;
    /// `CCR6`, bits 0..=15.
    pub const CCR6: &FieldSpec = &super::REGISTERS[24].fields[0];
}

/// The fields of `AF1`.
pub mod af1 {
    use super::FieldSpec;
    /// `BKINE`, bit 0.
    pub const BKINE: &FieldSpec = &super::REGISTERS[25].fields[0];
    /// `BKCMP1E`, bit 1.
    pub const BKCMP1E: &FieldSpec = &super::REGISTERS[25].fields[1];
    /// `BKCMP2E`, bit 2.
    pub const BKCMP2E: &FieldSpec = &super::REGISTERS[25].fields[2];
    /// `BKDF1BK0E`, bit 8.
    pub const BKDF1BK0E: &FieldSpec = &super::REGISTERS[25].fields[3];
    /// `BKINP`, bit 9.
    pub const BKINP: &FieldSpec = &super::REGISTERS[25].fields[4];
    /// `BKCMP1P`, bit 10.
    pub const BKCMP1P: &FieldSpec = &super::REGISTERS[25].fields[5];
    /// `BKCMP2P`, bit 11.
    pub const BKCMP2P: &FieldSpec = &super::REGISTERS[25].fields[6];
    /// `ETRSEL`, bits 14..=17.
    pub const ETRSEL: &FieldSpec = &super::REGISTERS[25].fields[7];
}

/// The fields of `AF2`.
pub mod af2 {
    use super::FieldSpec;
    /// `BK2INE`, bit 0.
    pub const BK2INE: &FieldSpec = &super::REGISTERS[26].fields[0];
    /// `BK2CMP1E`, bit 1.
    pub const BK2CMP1E: &FieldSpec = &super::REGISTERS[26].fields[1];
    /// `BK2CMP2E`, bit 2.
    pub const BK2CMP2E: &FieldSpec = &super::REGISTERS[26].fields[2];
    /// `BK2DF1BK1E`, bit 8.
    pub const BK2DF1BK1E: &FieldSpec = &super::REGISTERS[26].fields[3];
    /// `BK2INP`, bit 9.
    pub const BK2INP: &FieldSpec = &super::REGISTERS[26].fields[4];
    /// `BK2CMP1P`, bit 10.
    pub const BK2CMP1P: &FieldSpec = &super::REGISTERS[26].fields[5];
    /// `BK2CMP2P`, bit 11.
    pub const BK2CMP2P: &FieldSpec = &super::REGISTERS[26].fields[6];
}

/// The fields of `TISEL`.
pub mod tisel {
    use super::FieldSpec;
    /// `TI1SEL`, bits 0..=3.
    pub const TI1SEL: &FieldSpec = &super::REGISTERS[27].fields[0];
    /// `TI2SEL`, bits 8..=11.
    pub const TI2SEL: &FieldSpec = &super::REGISTERS[27].fields[1];
    /// `TI3SEL`, bits 16..=19.
    pub const TI3SEL: &FieldSpec = &super::REGISTERS[27].fields[2];
    /// `TI4SEL`, bits 24..=27.
    pub const TI4SEL: &FieldSpec = &super::REGISTERS[27].fields[3];
}

/// The register table.
pub static REGISTERS: [RegisterSpec; 28] = [
    RegisterSpec { name: "CR1", offset: 0x0, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CEN", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "UDIS", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "URS", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OPM", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DIR", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CMS", bit: 5, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ARPE", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CKD", bit: 8, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "UIFREMAP", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CR2", offset: 0x4, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CCPC", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CCUS", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CCDS", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MMS", bit: 4, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TI1S", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS1", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS1N", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS2", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS2N", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS3", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS3N", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS4", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS5", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OIS6", bit: 18, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MMS2", bit: 20, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SMCR", offset: 0x8, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "SMS", bit: 0, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TS", bit: 4, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MSM", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ETF", bit: 8, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ETPS", bit: 12, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ECE", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ETP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SMS_3", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TS_4_3", bit: 20, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DIER", offset: 0xC, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "UIE", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1IE", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2IE", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3IE", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4IE", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COMIE", bit: 5, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TIE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BIE", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "UDE", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1DE", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2DE", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3DE", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4DE", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COMDE", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TDE", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "SR", offset: 0x10, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "UIF", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1IF", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2IF", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3IF", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4IF", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COMIF", bit: 5, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TIF", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BIF", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2IF", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1OF", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2OF", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3OF", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4OF", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "SBIF", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC5IF", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC6IF", bit: 17, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "EGR", offset: 0x14, width: Width::W32, reset: 0x0000_0000, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "UG", bit: 0, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1G", bit: 1, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2G", bit: 2, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3G", bit: 3, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4G", bit: 4, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "COMG", bit: 5, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TG", bit: 6, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BG", bit: 7, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "B2G", bit: 8, width: 1, access: Access::WriteOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCMR1_Input", offset: 0x18, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CC1S", bit: 0, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC1PSC", bit: 2, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC1F", bit: 4, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2S", bit: 8, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC2PSC", bit: 10, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC2F", bit: 12, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCMR1_Output", offset: 0x18, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CC1S", bit: 0, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC1FE", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC1PE", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC1M", bit: 4, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC1CE", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2S", bit: 8, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC2FE", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC2PE", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC2M", bit: 12, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC2CE", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC1M_3", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC2M_3", bit: 24, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCMR2_Input", offset: 0x1C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CC3S", bit: 0, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC3PSC", bit: 2, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC3F", bit: 4, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4S", bit: 8, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC4PSC", bit: 10, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "IC4F", bit: 12, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCMR2_Output", offset: 0x1C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CC3S", bit: 0, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC3FE", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC3PE", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC3M", bit: 4, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC3CE", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4S", bit: 8, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC4FE", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC4PE", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC4M", bit: 12, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC4CE", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC3M_3", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC4M_4", bit: 24, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCER", offset: 0x20, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CC1E", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1P", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1NE", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC1NP", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2E", bit: 4, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2P", bit: 5, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2NE", bit: 6, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC2NP", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3E", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3P", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3NE", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC3NP", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4E", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4P", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC4NP", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC5E", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC5P", bit: 17, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC6E", bit: 20, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "CC6P", bit: 21, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CNT", offset: 0x24, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CNT", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "UIFCPY", bit: 31, width: 1, access: Access::ReadOnly, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "PSC", offset: 0x28, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "PSC", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "ARR", offset: 0x2C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "ARR", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "RCR", offset: 0x30, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "REP", bit: 0, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCR1", offset: 0x34, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CCR1", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCR2", offset: 0x38, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CCR2", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCR3", offset: 0x3C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CCR3", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCR4", offset: 0x40, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CCR4", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "BDTR", offset: 0x44, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DTG", bit: 0, width: 8, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "LOCK", bit: 8, width: 2, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OSSI", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OSSR", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKE", bit: 12, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKP", bit: 13, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "AOE", bit: 14, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "MOE", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKF", bit: 16, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2F", bit: 20, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2E", bit: 24, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2P", bit: 25, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DCR", offset: 0x48, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DBA", bit: 0, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "DBL", bit: 8, width: 5, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "DMAR", offset: 0x4C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "DMAB", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCMR3_Output", offset: 0x54, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "OC5FE", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC5PE", bit: 3, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC5M", bit: 4, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC5CE", bit: 7, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC6FE", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC6PE", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC6M", bit: 12, width: 3, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC6CE", bit: 15, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC5M3", bit: 16, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "OC6M3", bit: 24, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCR5", offset: 0x58, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CCR5", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GC5C1", bit: 29, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GC5C2", bit: 30, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "GC5C3", bit: 31, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "CCR6", offset: 0x5C, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "CCR6", bit: 0, width: 16, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "AF1", offset: 0x60, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "BKINE", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKCMP1E", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKCMP2E", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKDF1BK0E", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKINP", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKCMP1P", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BKCMP2P", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "ETRSEL", bit: 14, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "AF2", offset: 0x64, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "BK2INE", bit: 0, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2CMP1E", bit: 1, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2CMP2E", bit: 2, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2DF1BK1E", bit: 8, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2INP", bit: 9, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2CMP1P", bit: 10, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "BK2CMP2P", bit: 11, width: 1, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
    RegisterSpec { name: "TISEL", offset: 0x68, width: Width::W32, reset: 0x0000_0000, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None, fields: &[
        FieldSpec { name: "TI1SEL", bit: 0, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TI2SEL", bit: 8, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TI3SEL", bit: 16, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
        FieldSpec { name: "TI4SEL", bit: 24, width: 4, access: Access::ReadWrite, read: ReadAction::None, write: WriteModify::None },
    ] },
];
