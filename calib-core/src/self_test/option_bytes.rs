//! Option bytes: what a part was told once, in the workshop, and keeps for good.

use serde::{Deserialize, Serialize};

/// Brown-out level a board is set up with: reset below 2.54 to 2.68 V (DS12110 Rev 11, table 116).
pub const BROWN_OUT_LEVEL: u8 = 3;

/// The option bytes as `FLASH_OPTSR_CUR` shows them.
///
/// # Source
/// RM0433 Rev 9, 4.9.8 and table 21.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct OptionBytes(pub u32);

/// One that is not as the factory left it, and as the instrument needs it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deviation {
    /// Read-out protection: taking it away erases image and records.
    ReadProtected,
    /// The watchdog starts by itself with every reset, 0.5 s before the image has set it.
    HardwareWatchdog,
    /// Secure access mode: its loader stands before the image.
    Security,
    /// Pins fast for a supply below 2.5 V: damaged by more.
    LowVoltagePins,
    /// The banks have changed their places: records would be written over the image.
    BanksSwapped,
}

impl Deviation {
    /// All there are, with their bits and what those are on a part as delivered.
    const ALL: [(Self, u32, u32); 5] = [
        (Self::ReadProtected, 0xFF << 8, 0xAA << 8),
        (Self::HardwareWatchdog, 1 << 4, 1 << 4),
        (Self::Security, 1 << 21, 0),
        (Self::LowVoltagePins, 1 << 29, 0),
        (Self::BanksSwapped, 1 << 31, 0),
    ];

    /// Its name in the manual, and what it does.
    pub const fn text(self) -> &'static str {
        match self {
            Self::ReadProtected => "RDP: the flash is protected against being read",
            Self::HardwareWatchdog => "IWDG1_SW: the watchdog is started by the hardware",
            Self::Security => "SECURITY: secure access mode",
            Self::LowVoltagePins => "IO_HSLV: pins are set for a supply below 2.5 V",
            Self::BanksSwapped => "SWAP_BANK_OPT: the flash banks are exchanged",
        }
    }
}

impl OptionBytes {
    /// Level of the brown-out reset, 0 (as delivered, 1.7 V) to 3 (2.7 V).
    pub const fn brown_out_level(self) -> u8 {
        (self.0 >> 2) as u8 & 0b11
    }

    /// The others that are not as delivered.
    pub fn deviations(self) -> impl Iterator<Item = Deviation> {
        let deviating =
            move |&(_, bits, delivered): &(Deviation, u32, u32)| self.0 & bits != delivered;
        Deviation::ALL
            .into_iter()
            .filter(deviating)
            .map(|(deviation, ..)| deviation)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the factory leaves them (RM0433 Rev 9, table 21), by hand.
    const FACTORY: u32 = 0x0006_AAF0;

    #[test]
    fn the_factory_leaves_level_0_and_nothing_else_amiss() {
        let options = OptionBytes(FACTORY);
        assert_eq!(options.brown_out_level(), 0);
        assert_eq!(options.deviations().count(), 0);
        let set_up = OptionBytes(FACTORY | 0b1100);
        assert_eq!(set_up.brown_out_level(), BROWN_OUT_LEVEL);
        assert_eq!(set_up.deviations().count(), 0);
    }

    #[test]
    fn each_deviation_is_told_by_its_bit_alone() {
        for (word, deviation) in [
            (0x0006_55F0, Deviation::ReadProtected),
            (0x0006_AAE0, Deviation::HardwareWatchdog),
            (0x0026_AAF0, Deviation::Security),
            (0x2006_AAF0, Deviation::LowVoltagePins),
            (0x8006_AAF0, Deviation::BanksSwapped),
        ] {
            assert!(OptionBytes(word).deviations().eq([deviation]), "{word:#x}");
        }
    }
}
