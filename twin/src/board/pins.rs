//! Connections of the board.

use std::sync::Arc;

use super::analog::Analog;
use super::flash::FlashWatch;
use super::flaws::{Flaws, Lasting};
use super::schematic::Schematic;
use super::serial_line::SerialLine;
use super::usb::UsbPort;
use super::write_buffer::WriteBuffer;
use crate::rig_port::RigPort;

/// Rail of the part, and of its converters.
pub(super) const SUPPLY_MV: u32 = 3300;

/// Instructions per second of virtual time.
///
/// The emulator gives every instruction the same time and knows neither caches, wait states nor dual
/// issue. 250 million is about half an instruction per clock of the real core, so a deadline met here
/// is met on the hardware unless a path is bound by memory. [`instructions_per_s`](super::instructions_per_s)
/// has others.
pub const INSTRUCTIONS_PER_S: u64 = 250_000_000;

/// Devices connected to the board, each a handle that others may hold too.
#[derive(Debug, Clone)]
pub struct Pins {
    /// Which pin is which.
    pub schematic: Arc<Schematic>,
    /// The rig on the analogue pins.
    pub analog: Analog,
    /// Flaws of the part's converters.
    pub(super) flaws: Flaws,
    /// The far end of the serial port.
    pub serial: SerialLine,
    /// A view of the record flash's operations.
    pub flash: FlashWatch,
    /// The USB connector.
    pub usb: UsbPort,
    /// Buffer of writes to the memory kept over a reset.
    pub write_buffer: WriteBuffer,
    /// Instructions its core runs in a second.
    pub instructions_per_s: u64,
    /// Faults of the part that last until it is mended.
    pub faults: Lasting,
}

impl Pins {
    /// A board with `rig` on its connectors.
    #[must_use]
    pub fn new(schematic: Arc<Schematic>, rig: Box<dyn RigPort>) -> Self {
        Self {
            schematic,
            analog: Analog::new(rig),
            flaws: Flaws::default(),
            serial: SerialLine::default(),
            flash: FlashWatch::default(),
            usb: UsbPort::default(),
            write_buffer: WriteBuffer::default(),
            instructions_per_s: INSTRUCTIONS_PER_S,
            faults: Lasting::default(),
        }
    }
}

// The far end of the serial port, the flash and USB are kept by the models that hold them; a part
// that is broken is not kept.
rigless::store!(Pins {
    values: [],
    parts: [analog],
    built: [
        schematic,
        flaws,
        serial,
        flash,
        usb,
        write_buffer,
        instructions_per_s,
        faults
    ],
});
