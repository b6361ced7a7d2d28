//! Facts a board's file states beside its pins.

use embassy_stm32::gpio::{Level, Pull};
use embassy_stm32::rcc::HseMode;

/// Revision of the part's silicon (ES0392).
#[derive(Clone, Copy, PartialEq, Eq)]
#[allow(dead_code, reason = "a board has one of them")]
pub(crate) enum Silicon {
    /// Core up to 400 MHz; converters run at the clock they are given, up to 36 MHz.
    Y,
    /// Core up to 480 MHz; converters halve their clock.
    V,
}

/// The clock tree: one PLL, from the clock at OSC_IN.
pub(crate) struct Clocks {
    /// Revision of the part on the board.
    pub(crate) silicon: Silicon,
    /// Clock at OSC_IN, Hz.
    pub(crate) hse_hz: u32,
    /// A finished clock, or a crystal between OSC_IN and OSC_OUT.
    pub(crate) hse: HseMode,
    /// DIVM1: the PLL is fed with the clock at OSC_IN over this.
    pub(crate) pll_divider: u8,
    /// DIVN1: its oscillator runs at this times what it is fed with.
    pub(crate) pll_multiplier: u16,
    /// DIVP1: the core runs at the oscillator over this.
    pub(crate) core_divider: u8,
    /// DIVQ1: USB runs at the oscillator over this, which must be 48 MHz.
    pub(crate) usb_divider: u8,
    /// HPRE: buses, timers and the pair of converters run at the core's clock
    /// over this: 2 or 4.
    pub(crate) bus_divider: u8,
}

impl Clocks {
    /// The PLL's oscillator, Hz.
    pub(crate) const fn pll_hz(&self) -> u32 {
        self.hse_hz / self.pll_divider as u32 * self.pll_multiplier as u32
    }

    /// The core, Hz.
    pub(crate) const fn core_hz(&self) -> u32 {
        self.pll_hz() / self.core_divider as u32
    }

    /// The buses, Hz.
    pub(crate) const fn bus_hz(&self) -> u32 {
        self.core_hz() / self.bus_divider as u32
    }
}

/// Lamps and button.
pub(crate) struct Panel {
    /// Level at which a lamp is lit.
    pub(crate) lit: Level,
    /// Level of the button while it is pressed.
    pub(crate) pressed: Level,
    /// The part's own resistor at the button's pin.
    pub(crate) button_pull: Pull,
}
