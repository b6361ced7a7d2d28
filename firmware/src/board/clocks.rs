//! Clock tree: 480 MHz core, everything derived from the 8 MHz of the ST-LINK.

use embassy_stm32::Config;
use embassy_stm32::pac;
use embassy_stm32::rcc::{
    AHBPrescaler, APBPrescaler, Hse, HseMode, Pll, PllDiv, PllMul, PllPreDiv, PllSource, Sysclk,
    VoltageScale, mux,
};
use embassy_stm32::time::Hertz;

/// Core clock, Hz (DS12110 Rev 10, table 23: VOS0, revision V).
pub(crate) const CORE_HZ: u32 = 480_000_000;

/// Clock of the timers on APB1, Hz: twice PCLK1 (RM0433 Rev 8, 8.5.1).
pub(crate) const TIMER_HZ: u32 = CORE_HZ / 2;

/// The configuration of all clocks.
pub(crate) fn config() -> Config {
    let mut config = Config::default();
    let rcc = &mut config.rcc;
    // MCO of the ST-LINK (UM2407 Rev 4, 6.4.3): crystal accuracy, so the
    // frequency of every tone is within 50 ppm.
    rcc.hse = Some(Hse {
        freq: Hertz(8_000_000),
        mode: HseMode::Bypass,
    });
    rcc.voltage_scale = VoltageScale::Scale0;
    rcc.pll1 = Some(Pll {
        source: PllSource::HSE,
        prediv: PllPreDiv::DIV1,
        mul: PllMul::MUL120,
        fracn: None,
        divp: Some(PllDiv::DIV2),
        divq: Some(PllDiv::DIV20),
        divr: None,
    });
    rcc.sys = Sysclk::PLL1_P;
    rcc.ahb_pre = AHBPrescaler::DIV2;
    rcc.apb1_pre = APBPrescaler::DIV2;
    rcc.apb2_pre = APBPrescaler::DIV2;
    rcc.apb3_pre = APBPrescaler::DIV2;
    rcc.apb4_pre = APBPrescaler::DIV2;
    // 960 MHz / 20: what full-speed USB wants, as exact as the crystal.
    rcc.mux.usbsel = mux::Usbsel::PLL1_Q;
    // The internal oscillator, for ADC3 alone: the pair of ADC1 and ADC2 runs
    // on the bus clock.
    rcc.mux.adcsel = mux::Adcsel::PER;
    config
}

/// Watches the 8 MHz from now on: when they fail, the part goes on with its
/// internal oscillator, which no tone may be derived from, and raises the NMI,
/// whose handler silences the exciter (RM0433 Rev 8, 8.5.3).
pub(super) fn watch() {
    pac::RCC.cr().modify(|w| w.set_hsecsson(true));
}
