//! The one clock of converters and generator: TIM6, update event as TRGO.
//!
//! DAC and both ADCs start on the same edge, so a tone is a whole number of
//! cycles in a whole number of samples and its phase does not drift.

use super::clocks::TIMER_HZ;
use embassy_stm32::pac::{self, timer::vals::Mms};
use embassy_stm32::{Peri, peripherals, rcc};

/// Sample pairs per second, Hz.
pub(crate) const SAMPLE_RATE_HZ: u32 = 50_000;

const _: () = assert!(
    TIMER_HZ.is_multiple_of(SAMPLE_RATE_HZ) && TIMER_HZ / SAMPLE_RATE_HZ <= 1 << 16,
    "the sample clock must be an exact division of the timer clock"
);

/// TIM6, owned so that nothing else retunes it.
pub(crate) struct SampleClock {
    _timer: Peri<'static, peripherals::TIM6>,
}

impl SampleClock {
    /// Sets the rate; the clock stands still until [`Self::start`].
    pub(crate) fn new(timer: Peri<'static, peripherals::TIM6>) -> Self {
        rcc::enable_and_reset::<peripherals::TIM6>();
        let registers = pac::TIM6;
        registers.psc().write_value(0);
        registers
            .arr()
            .write(|w| w.set_arr((TIMER_HZ / SAMPLE_RATE_HZ - 1) as u16));
        registers.cr2().write(|w| w.set_mms(Mms::UPDATE));
        Self { _timer: timer }
    }

    /// Starts converters and generator on the same edge, for ever.
    pub(crate) fn start(self) {
        pac::TIM6.cr1().modify(|w| w.set_cen(true));
    }
}
