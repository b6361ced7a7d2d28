//! The emulated board: an STM32H743ZI and what a [`Schematic`] says is around it. It runs the shipping
//! image unmodified.
//!
//! The core, clocks, flash, pins, DMA and serial ports are the emulator's (`rigless`); what this
//! instrument needs beyond them is modelled here, one peripheral per file:
//!
//! | File | What |
//! |---|---|
//! | `pins` | what is connected to the board |
//! | `schematic` | which pin and port has which task on a board: data |
//! | `analog` | drive, reference, device under test: where converters meet the rig |
//! | `tim6` | sample clock |
//! | `dac` | DAC1, drive |
//! | `adc` | ADC1 and ADC2, reference and device under test |
//! | `dma1`, `dmamux`, `request_lines` | DMA controller, the request multiplexer before it, its lines |
//! | `flash` | flash interface, watched: what a power cut leaves behind, which words are poisoned |
//! | `flash_bus` | the core's loads from flash: faults of poisoned words, stalls by a bank at work |
//! | `iwdg` | watchdog |
//! | `overdrive`, `voltage_scale` | SYSCFG's switch to voltage scale 0; what that scale allows |
//! | `serial_line`, `line_rate` | the serial port's far end; what it hears of another rate |
//! | `usb` | OTG FS in device mode, and the host's end of its cable |
//! | `front_panel` | lamps and button |
//! | `write_buffer` | what a reset undoes of memory that is kept |
//! | `part_faults` | what can fail in the part |
//! | `memory_map`, `part`, `cortex_m7` | address map, the part as a whole, its core |
//!
//! Citations: RM0433 is the reference manual of the part, DS12110 its datasheet, ES0392 its errata,
//! PM0253 the core's programming manual.

mod adc;
mod analog;
mod check_bits;
mod cortex_m7;
mod dac;
mod dma1;
mod dmamux;
mod flash;
mod flash_bus;
mod flaws;
mod front_panel;
mod input_pin;
mod iwdg;
mod line_rate;
mod memory_map;
mod overdrive;
mod part;
mod part_faults;
mod pins;
mod request_lines;
mod schematic;
mod serial_line;
#[cfg(test)]
mod tests;
mod tim3;
mod tim6;
pub mod usb;
mod voltage_scale;
mod write_buffer;

use rigless::machine::{Board, Target};
use rigless::mcu::Mcu;

pub use analog::Analog;
pub(crate) use check_bits::CheckBits;
pub use cortex_m7::instructions_per_s;
pub use flash::{
    CODE_FLASH, CutOff, FlashWatch, Operation, RECORD_FLASH, SECTOR_BYTES, SECTORS, WORD_BYTES,
    torn_sector, torn_word,
};
pub use flaws::{Flaw, Flawed};
pub use front_panel::Leds;
pub use part::Part;
pub use part_faults::PartFault;
pub use pins::{INSTRUCTIONS_PER_S, Pins};
pub use schematic::{Schematic, SchematicError};
pub use serial_line::SerialLine;
pub use write_buffer::WriteBuffer;

/// Name of the board and of its one core.
const NAME: &str = "calibrator";
const CORE: &str = "stm32h743zi";

/// The board: the part, and what is soldered around it.
#[derive(Debug)]
pub struct CalibratorBoard {
    /// The microcontroller.
    pub part: Part,
    /// The emulated core takes the shortcuts nobody can see.
    pub shortcuts: bool,
}

impl CalibratorBoard {
    /// A board just powered on.
    ///
    /// # Errors
    ///
    /// A mistake in the board's own description: nothing a caller can cause.
    pub fn new(pins: Pins) -> Result<Self, rigless::soc::Error> {
        let part = Part::new(pins)?;
        Ok(Self {
            part,
            shortcuts: true,
        })
    }
}

rigless::store!(CalibratorBoard {
    values: [],
    parts: [part],
    built: [shortcuts],
});

impl Board for CalibratorBoard {
    fn name(&self) -> &'static str {
        NAME
    }

    fn targets(&mut self) -> Vec<Target<'_>> {
        let core = cortex_m7::spec(&self.part, self.shortcuts);
        vec![Target::new(CORE, &mut self.part, core)]
    }

    fn target_names(&self) -> Vec<&'static str> {
        vec![CORE]
    }

    fn mcu(&mut self, target: usize) -> Option<&mut dyn Mcu> {
        (target == 0).then_some(&mut self.part)
    }
}
