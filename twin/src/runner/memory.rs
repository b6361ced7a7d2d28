//! The board's memories as the emulator's host sees them.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rigless::emulator::{Error as EmulatorError, Host};
use rigless::soc::Width;

use crate::board::{SECTOR_BYTES, SECTORS, WriteBuffer};

/// Size of the record flash.
pub(super) const RECORD_FLASH_BYTES: usize = SECTORS * SECTOR_BYTES as usize;

/// Size of the bank the code is in.
pub(super) const BANK_BYTES: usize = 8 * SECTOR_BYTES as usize;

/// The memories that lose their content with the supply: DTCM, AXI SRAM, SRAM1 to SRAM4.
const VOLATILE: [(u64, u64); 5] = [
    (0x2000_0000, 128 << 10),
    (0x2400_0000, 512 << 10),
    (0x3000_0000, 256 << 10),
    (0x3004_0000, 32 << 10),
    (0x3800_0000, 64 << 10),
];

/// Reads `length` bytes from `address`, a multiple of 8 both.
pub(super) fn read(
    host: &mut dyn Host,
    address: u64,
    length: usize,
) -> Result<Vec<u8>, EmulatorError> {
    let mut bytes = Vec::with_capacity(length);
    for at in (address..address + length as u64).step_by(8) {
        bytes.extend(host.read(at, Width::W64)?.to_le_bytes());
    }
    Ok(bytes)
}

/// Reads one word.
pub(super) fn word(host: &mut dyn Host, address: u64) -> Result<u32, EmulatorError> {
    Ok(host.read(address, Width::W32)? as u32)
}

/// Fills every volatile memory with noise drawn from `seed`, as power-on does.
pub(super) fn scramble(host: &mut dyn Host, seed: u64) -> Result<(), EmulatorError> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    for (base, size) in VOLATILE {
        for at in (base..base + size).step_by(8) {
            host.write(at, Width::W64, random.next_u64())?;
        }
    }
    Ok(())
}

/// Takes note of what the memory that is kept over a reset holds.
pub(super) fn note_kept(host: &mut dyn Host, buffer: &WriteBuffer) {
    let content = WriteBuffer::addresses()
        .filter_map(|address| Some((address, host.read(address, Width::W64).ok()?)));
    buffer.set(content.collect());
}

/// Fills `length` bytes from `address`, a multiple of 8 both, with `byte`.
pub(super) fn fill(
    host: &mut dyn Host,
    address: u64,
    length: usize,
    byte: u8,
) -> Result<(), EmulatorError> {
    for at in (address..address + length as u64).step_by(8) {
        host.write(at, Width::W64, u64::from_le_bytes([byte; 8]))?;
    }
    Ok(())
}

/// Puts `bytes` into flash at `address`, a multiple of 8 both, as they are.
pub(super) fn program(
    host: &mut dyn Host,
    address: u64,
    bytes: &[u8],
) -> Result<(), EmulatorError> {
    let (words, _) = bytes.as_chunks();
    for (at, word) in (address..).step_by(8).zip(words) {
        host.program(at, Width::W64, u64::from_le_bytes(*word))?;
    }
    Ok(())
}

/// Puts `halfwords` into flash at `address` and hands back what was there.
pub(super) fn patch(
    host: &mut dyn Host,
    address: u64,
    halfwords: &[u16],
) -> Result<Vec<u16>, EmulatorError> {
    let first = address & !7;
    let bytes = (address - first) as usize + 2 * halfwords.len();
    let mut words = read(host, first, bytes.next_multiple_of(8))?;
    let (places, _) = words[(address - first) as usize..].as_chunks_mut::<2>();
    let mut before = Vec::with_capacity(halfwords.len());
    for (place, halfword) in places.iter_mut().zip(halfwords) {
        before.push(u16::from_le_bytes(*place));
        *place = halfword.to_le_bytes();
    }
    program(host, first, &words)?;
    Ok(before)
}
