//! Clock tree: everything derived from the clock at OSC_IN.

use super::description::Silicon;
use super::selected::CLOCKS;
use embassy_stm32::Config;
use embassy_stm32::pac;
use embassy_stm32::rcc::{
    AHBPrescaler, APBPrescaler, Hse, HseMode, Hsi48Config, LsConfig, Pll, PllDiv, PllMul,
    PllPreDiv, PllSource, Sysclk, VoltageScale, mux,
};
use embassy_stm32::time::Hertz;

/// Clock of the timers on APB1, Hz: twice PCLK1, which is half of the bus clock
/// (RM0433 Rev 8, 8.5.1).
pub(crate) const TIMER_HZ: u32 = CLOCKS.bus_hz();

/// Cycles of the core in a microsecond.
pub(crate) const CORE_MHZ: f32 = CLOCKS.core_hz() as f32 / 1e6;

/// Highest core clock of the silicon, Hz (DS12110 Rev 10, table 23: VOS0 of
/// revision V; VOS1).
const HIGHEST_CORE_HZ: u32 = match CLOCKS.silicon {
    Silicon::Y => 400_000_000,
    Silicon::V => 480_000_000,
};

/// The fastest core of voltage scale 1, Hz.
const SCALE_1_CORE_HZ: u32 = 400_000_000;

const _: () = {
    assert!(CLOCKS.core_hz() <= HIGHEST_CORE_HZ, "core");
    assert!(CLOCKS.bus_hz() <= HIGHEST_CORE_HZ / 2, "buses");
    let usb_hz = CLOCKS.pll_hz() / CLOCKS.usb_divider as u32;
    assert!(usb_hz == 48_000_000, "USB wants 48 MHz");
    assert!(
        CLOCKS.pll_hz().is_multiple_of(INSIDE_HZ),
        "the oscillator inside does not lead to it"
    );
};

/// The internal oscillator, Hz, and what the PLL is fed with of it.
const INTERNAL_HZ: u32 = 64_000_000;
const INSIDE_HZ: u32 = 8_000_000;

/// Looks at a clock that is coming up: some 100 ms at the 64 MHz the core starts with, where a
/// crystal takes 2 ms (DS12110 Rev 10, table 47).
const LOOKS: u32 = 600_000;

/// Whether there is a clock at OSC_IN; waited for at most 0.1 s, so that a board without one comes
/// up all the same. The oscillator is left as it was found: off.
pub(super) fn is_clocked() -> bool {
    pac::RCC
        .cr()
        .modify(|w| w.set_hsebyp(CLOCKS.hse != HseMode::Oscillator));
    pac::RCC.cr().modify(|w| w.set_hseon(true));
    let is_clocked = (0..LOOKS).any(|_| pac::RCC.cr().read().hserdy());
    pac::RCC.cr().modify(|w| w.set_hseon(false));
    is_clocked
}

/// The configuration of all clocks: by the clock at OSC_IN, or without it at the same frequencies
/// by the internal oscillator, within some percent.
pub(crate) fn config(clocked: bool) -> Config {
    let mut config = Config::default();
    let rcc = &mut config.rcc;
    rcc.hse = clocked.then_some(Hse {
        freq: Hertz(CLOCKS.hse_hz),
        mode: CLOCKS.hse,
    });
    rcc.voltage_scale = if CLOCKS.core_hz() > SCALE_1_CORE_HZ {
        VoltageScale::Scale0
    } else {
        VoltageScale::Scale1
    };
    rcc.pll1 = Some(Pll {
        source: match clocked {
            true => PllSource::HSE,
            false => PllSource::HSI,
        },
        prediv: PllPreDiv::from_bits(match clocked {
            true => CLOCKS.pll_divider,
            false => (INTERNAL_HZ / INSIDE_HZ) as u8,
        }),
        mul: PllMul::from_bits(match clocked {
            true => CLOCKS.pll_multiplier - 1,
            false => (CLOCKS.pll_hz() / INSIDE_HZ) as u16 - 1,
        }),
        fracn: None,
        divp: Some(PllDiv::from_bits(CLOCKS.core_divider - 1)),
        divq: Some(PllDiv::from_bits(CLOCKS.usb_divider - 1)),
        divr: None,
    });
    // Nobody reads the RTC. On the LSI, a dip of the supply could make it run too fast, and the watchdog with it, which
    // starts that oscillator itself (ES0392 Rev 13, 2.2.19).
    rcc.ls = LsConfig::off();
    rcc.sys = Sysclk::PLL1_P;
    rcc.ahb_pre = const {
        match CLOCKS.bus_divider {
            2 => AHBPrescaler::DIV2,
            4 => AHBPrescaler::DIV4,
            _ => panic!("the buses run at a half or a quarter of the core's clock"),
        }
    };
    rcc.apb1_pre = APBPrescaler::DIV2;
    rcc.apb2_pre = APBPrescaler::DIV2;
    rcc.apb3_pre = APBPrescaler::DIV2;
    rcc.apb4_pre = APBPrescaler::DIV2;
    // As exact as the clock at OSC_IN; without it, an oscillator that follows the host's frames.
    rcc.mux.usbsel = match clocked {
        true => mux::Usbsel::PLL1_Q,
        false => mux::Usbsel::HSI48,
    };
    rcc.hsi48 = Some(Hsi48Config {
        sync_from_usb: !clocked,
    });
    // The internal oscillator, for ADC3 alone: the pair of ADC1 and ADC2 runs
    // on the bus clock.
    rcc.mux.adcsel = mux::Adcsel::PER;
    config
}

/// Watches the clock at OSC_IN from now on: when it fails, the part goes on with
/// its internal oscillator, which no tone may be derived from, and raises the NMI,
/// whose handler silences the exciter (RM0433 Rev 8, 8.5.3).
pub(super) fn watch() {
    pac::RCC.cr().modify(|w| w.set_hsecsson(true));
}
