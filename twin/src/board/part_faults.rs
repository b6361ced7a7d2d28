//! Faults of the part itself, for tests.
//!
//! Nothing here is known to the firmware: each is what the silicon would show.

use rigless::mcu::{Mcu, Operate};
use rigless::soc::Width;
use rigless::soc::stm32h743::Stm32h743;
use rigless::soc::stm32h743::generated::DMA1;
use rigless::soc::stm32h743::peripherals::flash::OptionBytes;
use rigless::time::VirtualNanos;

use super::flash::{SET_UP, word_of};
use super::flaws::{Flaw, Flawed};
use super::part::Part;

/// `CR`, `NDTR`, `PAR` and `M0AR` of a stream lie at this offset and distance (RM0433 Rev 9, table 116).
const STREAM_AT: u64 = 0x10;
const STREAM_BYTES: u64 = 0x18;
const MEMORY_AT: u64 = 0x0C;
const ENABLE: u64 = 1;
/// An address on the bus that nothing answers.
const NOWHERE: u64 = 0x6F00_0000;

/// A fault of the part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PartFault {
    /// The DMA was late for one pair of conversions: the next one overruns.
    AdcOverrun,
    /// A stream of DMA1 stops.
    DmaStops {
        /// Number of the stream.
        stream: u8,
    },
    /// A stream of DMA1 loses its way: its next access goes where nothing answers.
    DmaError {
        /// Number of the stream.
        stream: u8,
    },
    /// The clock from outside ends.
    ClockLost,
    /// The part has the erratum of ES0392 by which data of ADC2 stand beside those of another trigger
    /// of ADC1, for good: with one DMA channel and data kept in an overrun.
    SlaveShifted,
    /// The shift without a cause in the configuration, in so many of the next starts of the converters.
    StartsShifted {
        /// How many.
        starts: u32,
    },
    /// ADC1 (0) or ADC2 (1) never becomes ready, from its next start on.
    ConverterDead {
        /// Number of the converter.
        nth: u8,
    },
    /// There is no clock at OSC_IN, from the next start on.
    NoClock,
    /// Every sector of bank 2 is write-protected by the option bytes: what is erased or programmed
    /// there is refused with `WRPERR` (RM0433 Rev 9, section 4.5.2).
    FlashProtected,
    /// The option bytes are these, as `FLASH_OPTSR_CUR` shows them (RM0433 Rev 9, 4.9.8), until the part is
    /// mended: `0x0006_AAF0` is how the factory leaves a part, with brown-out level 0.
    OptionBytes {
        /// The register.
        status: u32,
    },
    /// One bit of a flash word is wrong, and the part mends it at each read, until its sector is erased.
    WeakWord {
        /// Any address in the word.
        address: u64,
    },
    /// Two bits of a flash word are wrong: it cannot be read until its sector is erased.
    PoisonedWord {
        /// Any address in the word.
        address: u64,
    },
    /// A converter has a flaw, or with one that is all zero none any more.
    Flaw {
        /// Which converter.
        of: Flawed,
        /// Its flaw.
        flaw: Flaw,
    },
    /// The supply of the converters, with the internal reference as the yardstick, until the next reset.
    ConverterSupply {
        /// Its voltage, mV.
        millivolts: u32,
    },
    /// The processor's temperature is this one, not what the rig says; or again that.
    Processor {
        /// Hundredths of a degree Celsius.
        centi_c: Option<i32>,
    },
}

impl Part {
    /// Lets `fault` happen at `at`.
    pub(crate) fn fail(&mut self, at: VirtualNanos, fault: PartFault) {
        match fault {
            PartFault::AdcOverrun => self.converters().leave_a_pair_unread(),
            PartFault::DmaStops { stream } => self.change_stream(at, stream, None),
            PartFault::DmaError { stream } => self.change_stream(at, stream, Some(NOWHERE)),
            PartFault::ClockLost => self.lose_clock(at),
            PartFault::SlaveShifted => self.converters().give_slave_erratum(),
            PartFault::StartsShifted { starts } => self.converters().spoil_starts(starts),
            PartFault::ConverterDead { nth } => self.faults().kill_converter(usize::from(nth)),
            PartFault::NoClock => self.faults().stop_clock(),
            PartFault::FlashProtected => self.faults().protect_flash(),
            PartFault::OptionBytes { status } => self.set_options(OptionBytes {
                optsr: u64::from(status),
                ..self.options()
            }),
            PartFault::WeakWord { address } => self.flash_watch().weaken(address),
            PartFault::PoisonedWord { address } => self.flash_watch().poison([word_of(address)]),
            PartFault::Flaw { of, flaw } => self.flaws().set(of, flaw),
            PartFault::ConverterSupply { millivolts } => self.set_converter_supply(millivolts),
            PartFault::Processor { centi_c } => self.flaws().set_processor_centi_c(centi_c),
        }
        self.suffer();
    }

    /// Makes whole what is broken for good.
    pub(crate) fn mend(&mut self) {
        self.faults().mend();
        self.set_options(SET_UP);
        self.suffer();
    }

    /// Stops a stream; with another memory address it goes on from there.
    fn change_stream(&mut self, at: VirtualNanos, stream: u8, memory: Option<u64>) {
        let registers = DMA1.base + STREAM_AT + STREAM_BYTES * u64::from(stream);
        let Ok(control) = self.read(at, registers, Width::W32) else {
            return;
        };
        // Refused only where there is no such stream.
        let mut write = |address, value| {
            self.write(at, address, Width::W32, value).ok();
        };
        write(registers, control & !ENABLE);
        if let Some(memory) = memory {
            write(registers + MEMORY_AT, memory);
            write(registers, control | ENABLE);
        }
    }

    fn lose_clock(&mut self, at: VirtualNanos) {
        let (Ok(mut spare), Some(slot)) = (Stm32h743::new(), self.base.bus().slot_of("RCC")) else {
            return;
        };
        std::mem::swap(&mut spare.rcc, &mut self.base.rcc);
        let (registers, mut context) = self.base.bus_mut().drive(at, slot);
        spare.rcc.fail_hse(registers, &mut context);
        std::mem::swap(&mut spare.rcc, &mut self.base.rcc);
    }
}
