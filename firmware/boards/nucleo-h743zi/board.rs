//! NUCLEO-H743ZI (MB1137), the older board, with silicon revision Y.
//!
//! Never run on the board itself. UM1974 was not at hand; each line says what
//! it rests on:
//!
//! | item | value | rests on |
//! |---|---|---|
//! | LD1, LD3, button, virtual COM port, USB | as on the NUCLEO-H743ZI2 | secondary: board files of MicroPython and NuttX, alike for all boards MB1137 |
//! | LD2 | PB7, blue | secondary: MicroPython, the change that added the NUCLEO-H743ZI2 |
//! | button is high while pressed | | secondary: MicroPython; the pull-down of the part is assumed harmless beside the board's |
//! | 8 MHz from the MCO of the ST-LINK/V2-1 | | secondary: MicroPython (HSE bypass) |
//! | silicon | revision Y, 400 MHz | secondary: Mbed OS, pull request 11303 |
//! | converters' clock on revision Y | not halved, up to 36 MHz | assumed, from DS12110 before revision V |
//! | connectors A0, A1, D24 | PA3, PC0, PA4 | A0 and A1 secondary, D24 assumed |

use crate::board::{Clocks, Panel, Silicon, wiring};
use calib_core::converter::Converters;
use embassy_stm32::gpio::{Level, Pull};
use embassy_stm32::rcc::HseMode;

/// As the log has it.
pub(crate) const NAME: &str = "NUCLEO-H743ZI";

wiring! {
    // what        pin          on the board
    green:         PB0,         // LD1
    yellow:        PB7,         // LD2, which is blue
    red:           PB14,        // LD3
    button:        PC13,        // B1
    reference:     PA3,         // A0; ADC1 INP15
    dut:           PC0,         // A1; ADC2 INP10
    drive:         PA4 by Ch1,  // D24; DAC1 OUT1
    dither:        PC6,         // D16, assumed; TIM3 CH1
    serial:        USART3,      // virtual COM port of the ST-LINK/V2-1, CN1
    transmit:      PD8,
    receive:       PD9,
}

pub(crate) const PANEL: Panel = Panel {
    lit: Level::High,
    pressed: Level::High,
    button_pull: Pull::Down,
};

/// 384 MHz core: the fastest below 400 of which one PLL also makes 48 MHz for
/// USB. 96 MHz buses, for the converters take a quarter of that: 24 MHz.
pub(crate) const CLOCKS: Clocks = Clocks {
    silicon: Silicon::Y,
    hse_hz: 8_000_000,
    hse: HseMode::Bypass,
    pll_divider: 1,
    pll_multiplier: 96,
    core_divider: 2,
    usb_divider: 16,
    bus_divider: 4,
};

pub(crate) const CONVERTERS: Converters = Converters::FIELD;
