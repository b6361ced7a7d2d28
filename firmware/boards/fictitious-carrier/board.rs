//! A fictitious carrier: nobody has built it.
//!
//! An STM32H743ZI on which everything a board decides is otherwise than on the
//! NUCLEO boards, so that the tests show where the firmware takes it from.

use crate::board::{Clocks, Panel, Silicon, wiring};
use calib_core::converter::{Converters, Width};
use embassy_stm32::gpio::{Level, Pull};
use embassy_stm32::rcc::HseMode;

/// As the log has it.
pub(crate) const NAME: &str = "fictitious carrier";

wiring! {
    // what        pin
    green:         PD10,
    yellow:        PD11,
    red:           PG3,
    button:        PG2,
    reference:     PA6,         // ADC1 INP3
    dut:           PB1,         // ADC2 INP5
    drive:         PA5 by Ch2,  // DAC1 OUT2
    dither:        PB4,         // TIM3 CH1
    serial:        USART2,
    transmit:      PD5,
    receive:       PD6,
}

/// Lamps from the supply to the pin, a button to ground.
pub(crate) const PANEL: Panel = Panel {
    lit: Level::Low,
    pressed: Level::Low,
    button_pull: Pull::Up,
};

/// 480 MHz core, 240 MHz buses, of a crystal of 25 MHz.
pub(crate) const CLOCKS: Clocks = Clocks {
    silicon: Silicon::V,
    hse_hz: 25_000_000,
    hse: HseMode::Oscillator,
    pll_divider: 5,
    pll_multiplier: 192,
    core_divider: 2,
    usb_divider: 20,
    bus_divider: 2,
};

/// Inputs of 14 bits and half the range, and an exciter of half the voltage.
pub(crate) const CONVERTERS: Converters = Converters {
    input: Width::of_bits(14).with_dither(),
    input_full_scale_peak_v: 2.5,
    drive: Width::of_bits(12),
    drive_full_scale_peak_v: 5.0,
};
