//! Writes of a probe that give a board its brown-out level: RM0433 Rev 9, 4.4.3 and 4.5.1.

/// `FLASH_OPTSR_CUR`: the option bytes in force.
pub(crate) const CURRENT: u32 = 0x5200_201C;
/// Brown-out level 3 in bits 2 and 3, and nothing else.
const LEVEL_3: u32 = 0b11 << 2;
/// Two keys unlock `FLASH_OPTCR`, in this order and with no other register of the flash between.
const KEYR: u32 = 0x5200_2008;
const KEYS: [u32; 2] = [0x0819_2A3B, 0x4C5D_6E7F];
const CONTROL: u32 = 0x5200_2018;
const PROGRAM: u32 = 0x5200_2020;
/// `OPTSTART` of `FLASH_OPTCR`.
const START: u32 = 1 << 1;

/// Whether option bytes have it already.
pub(crate) fn is_set(current: u32) -> bool {
    current & LEVEL_3 == LEVEL_3
}

/// Addresses and words, in the order they are written: every other option byte stays what it is. The
/// next reset locks them again.
pub(crate) fn writes(current: u32) -> [(u32, u32); 4] {
    [
        (KEYR, KEYS[0]),
        (KEYR, KEYS[1]),
        (PROGRAM, current | LEVEL_3),
        (CONTROL, START),
    ]
}
