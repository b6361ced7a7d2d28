//! The one clock of converters and generator: TIM6, update event as TRGO, and how long the inputs convert at
//! each of its triggers (RM0433 Rev 8, chapter 25).
//!
//! DAC and both ADCs start on the same edge, so a tone is a whole number of
//! cycles in a whole number of samples and its phase does not drift.

use super::clocks::TIMER_HZ;
use super::description::Silicon;
use super::selected::{CLOCKS, CONVERTERS};
use calib_core::aperture::Aperture;
use embassy_stm32::pac::{self, timer::vals::Mms};
use embassy_stm32::{Peri, peripherals, rcc};

/// Sample pairs per second, Hz.
pub(crate) const SAMPLE_RATE_HZ: u32 = 50_000;

const _: () = assert!(
    TIMER_HZ.is_multiple_of(SAMPLE_RATE_HZ) && TIMER_HZ / SAMPLE_RATE_HZ <= 1 << 16,
    "the sample clock must be an exact division of the timer clock"
);

/// Clock of the pair, before revision V halves it.
pub(super) const ADC_CLOCK_HZ: u32 = CLOCKS.bus_hz() / 4;
/// Conversions at each trigger, whose sum the part hands over as 16 bits: a
/// third of one conversion's noise, 1.9 % less of 10 kHz, and a period of the
/// dither. Both converters must be set alike (25.4.30).
pub(super) const CONVERSIONS: u16 = 8;
/// Clock of the conversions (revision V halves it), and twice the cycles of each:
/// 32.5 of sampling, and a half and half a cycle a bit (25.4.17).
const CONVERSION_HZ: u32 = match CLOCKS.silicon {
    Silicon::Y => ADC_CLOCK_HZ,
    Silicon::V => ADC_CLOCK_HZ / 2,
};
const HALF_CYCLES: u32 = 65 + 1 + CONVERTERS.input.bits() as u32;
/// Conversions of which a sample is the mean.
pub(crate) const APERTURE: Aperture = Aperture {
    conversions: CONVERSIONS,
    apart_s: HALF_CYCLES as f32 / (2 * CONVERSION_HZ) as f32,
};

/// Ticks of the timers in which the conversions of a trigger are done.
pub(super) const TRIGGER_TICKS: u32 =
    CONVERSIONS as u32 * HALF_CYCLES * (TIMER_HZ / CONVERSION_HZ) / 2;

const _: () = assert!(TIMER_HZ.is_multiple_of(CONVERSION_HZ));
const _: () = assert!(
    CONVERSIONS as u32 * HALF_CYCLES * (SAMPLE_RATE_HZ / 1000) < 9 * 2 * CONVERSION_HZ / 10_000,
    "the conversions of a trigger must end well before the next"
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
