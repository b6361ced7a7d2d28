//! NUCLEO-H743ZI2 (MB1364), the board the instrument is made for.
//!
//! Sources: UM2407 Rev 4 for the board, DS12110 Rev 10 for the part.

use crate::board::{Clocks, Panel, Silicon, wiring};
use calib_core::converter::Converters;
use embassy_stm32::gpio::{Level, Pull};
use embassy_stm32::rcc::HseMode;

/// As the log has it.
pub(crate) const NAME: &str = "NUCLEO-H743ZI2";

wiring! {
    // what        pin          on the board
    green:         PB0,         // LD1 (6.5)
    yellow:        PE1,         // LD2
    red:           PB14,        // LD3
    button:        PC13,        // B1
    reference:     PA3,         // A0, CN9-1; ADC1 INP15 (DS12110, table 9)
    dut:           PC0,         // A1, CN9-3; ADC2 INP10
    drive:         PA4 by Ch1,  // D24, CN7-17; DAC1 OUT1
    dither:        PC6,         // D16, CN7-1; TIM3 CH1 (DS12110, table 12)
    serial:        USART3,      // virtual COM port of the ST-LINK, CN1
    transmit:      PD8,
    receive:       PD9,
}

pub(crate) const PANEL: Panel = Panel {
    lit: Level::High,
    pressed: Level::High,
    button_pull: Pull::Down,
};

/// 480 MHz core, 240 MHz buses.
pub(crate) const CLOCKS: Clocks = Clocks {
    silicon: Silicon::V,
    // MCO of the ST-LINK (6.4.3): worth what its crystal is, assumed 50 ppm
    // (docs/hardware.md, Clock).
    hse_hz: 8_000_000,
    hse: HseMode::Bypass,
    pll_divider: 1,
    pll_multiplier: 120,
    core_divider: 2,
    usb_divider: 20,
    bus_divider: 2,
};

pub(crate) const CONVERTERS: Converters = Converters::FIELD;
