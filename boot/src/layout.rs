//! Where things lie in flash; `memory.x` holds the linker to the same.

/// First address of the flash.
pub const FLASH: u32 = 0x0800_0000;
/// Bytes programmed at once, with check bits of their own.
pub const WORD: usize = 32;
/// Bytes erased at once.
pub const SECTOR: u32 = 0x2_0000;
/// Sectors of a slot.
pub const SLOT_SECTORS: u32 = 3;
/// Bytes of a slot.
pub const SLOT_BYTES: u32 = SLOT_SECTORS * SECTOR;
/// Bytes of a manifest, the last of its slot.
pub const MANIFEST_BYTES: usize = 256;
/// Longest image, bytes.
pub const LONGEST_IMAGE: u32 = SLOT_BYTES - MANIFEST_BYTES as u32;
/// The journal: one sector.
pub const JOURNAL: u32 = FLASH + 7 * SECTOR;

/// A place for an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Slot {
    /// Sectors 1 to 3.
    A = 0,
    /// Sectors 4 to 6.
    B = 1,
}

impl Slot {
    /// Both.
    pub const ALL: [Self; 2] = [Self::A, Self::B];

    /// The one of this number, 0 or 1.
    pub fn of(number: u8) -> Option<Self> {
        Self::ALL.get(usize::from(number)).copied()
    }

    /// The slot around an address, such as that of the code that runs.
    pub fn around(address: u32) -> Option<Self> {
        let holds = |slot: &Self| (slot.start()..slot.start() + SLOT_BYTES).contains(&address);
        Self::ALL.into_iter().find(holds)
    }

    /// First address, where the image begins.
    pub const fn start(self) -> u32 {
        FLASH + SECTOR + self as u32 * SLOT_BYTES
    }

    /// Address of the manifest.
    pub const fn manifest(self) -> u32 {
        self.start() + LONGEST_IMAGE
    }

    /// The other one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::A => Self::B,
            Self::B => Self::A,
        }
    }

    /// Its letter.
    pub const fn letter(self) -> char {
        match self {
            Self::A => 'A',
            Self::B => 'B',
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The addresses of `memory.x`, stated once more.
    #[test]
    fn the_map_is_that_of_the_linker() {
        assert_eq!(Slot::A.start(), 0x0802_0000);
        assert_eq!(Slot::B.start(), 0x0808_0000);
        assert_eq!(JOURNAL, 0x080E_0000);
        assert_eq!(Slot::A.manifest(), 0x0807_FF00);
        assert_eq!(Slot::B.start() + SLOT_BYTES, JOURNAL);
        assert_eq!(Slot::around(0x0807_FFFF), Some(Slot::A));
        assert_eq!(Slot::around(0x0808_0000), Some(Slot::B));
        assert_eq!(Slot::around(0x0800_0000), None);
    }
}
