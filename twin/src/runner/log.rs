//! Log of the firmware over RTT, collected as a debug probe would.
//!
//! RTT is a ring buffer in the firmware's RAM that a probe drains: a control block with the
//! descriptors of its channels, of which the first carries the log (SEGGER, UM08001, chapter 16).

use defmt_decoder::{DecodeError, Table};
use rigless::emulator::Host;

use super::{Firmware, memory};

/// Where the descriptor of the first up channel starts in the control block.
const UP_CHANNEL: u64 = 24;
/// Offsets in a channel's descriptor: buffer, its size, write offset, read offset.
const BUFFER: u64 = 4;
const SIZE: u64 = 8;
const WRITE: u64 = 12;
const READ: u64 = 16;
/// Signature of the control block once the firmware has set it up.
const ID: u64 = u64::from_le_bytes(*b"SEGGER R");
/// The largest buffer taken for real: a damaged descriptor is left alone.
const LARGEST_BYTES: u32 = 1 << 16;

/// Raw bytes of the firmware's log, in the order written.
#[derive(Debug, Clone, Default)]
pub struct Log {
    /// The encoded stream (defmt frames).
    pub bytes: Vec<u8>,
}

impl Log {
    /// The messages as text, one per line: time stamp, level, message. What cannot be decoded is
    /// named as such; a firmware without defmt has no lines.
    #[must_use]
    pub fn lines(&self, firmware: &Firmware) -> Vec<String> {
        let Ok(Some(table)) = Table::parse(firmware.bytes()) else {
            return Vec::new();
        };
        let mut decoder = table.new_stream_decoder();
        decoder.received(&self.bytes);
        let mut lines = Vec::new();
        loop {
            match decoder.decode() {
                Ok(frame) => lines.push(frame.display(false).to_string()),
                Err(DecodeError::UnexpectedEof) => return lines,
                Err(DecodeError::Malformed) if !table.encoding().can_recover() => return lines,
                Err(DecodeError::Malformed) => lines.push("(a damaged log message)".into()),
            }
        }
    }
}

/// Drains the first up channel of the control block at `control`, if there is one.
pub(super) fn drain(host: &mut dyn Host, control: u64, log: &mut Log) -> Option<()> {
    let descriptor = control + UP_CHANNEL;
    let write = memory::word(host, descriptor + WRITE).ok()?;
    let read = memory::word(host, descriptor + READ).ok()?;
    if write == read {
        return None;
    }
    let id = host.read(control, rigless::soc::Width::W64).ok()?;
    let buffer = u64::from(memory::word(host, descriptor + BUFFER).ok()?);
    let size = memory::word(host, descriptor + SIZE).ok()?;
    if id != ID || write >= size || read >= size || size > LARGEST_BYTES {
        return None;
    }
    let mut at = read;
    while at != write {
        let byte = host.read(buffer + u64::from(at), rigless::soc::Width::W8);
        log.bytes.push(byte.ok()? as u8);
        at = (at + 1) % size;
    }
    let read_offset = descriptor + READ;
    host.write(read_offset, rigless::soc::Width::W32, u64::from(write))
        .ok()
}
