//! The square wave of which the front end makes the dither of both inputs: TIM3.
//!
//! A period is as long as all conversions of a trigger together, which is no whole part of the sample
//! period. So every trigger has the dither's values of a whole period, evenly spread, and its mean has none of
//! it; from trigger to trigger they are others ([why](../../../docs/hardware.md#dither)).

use super::clocks::TIMER_HZ;
use super::sample_clock::{SAMPLE_RATE_HZ, TRIGGER_TICKS};
use super::wiring::DitherParts;
use embassy_stm32::pac::{self, timer::vals::OcmGp};
use embassy_stm32::{peripherals, rcc};

const _: () = assert!(
    TRIGGER_TICKS.is_multiple_of(2) && TRIGGER_TICKS <= 1 << 16,
    "half of a period is high"
);
const _: () = assert!(
    PHASES >= 8,
    "from trigger to trigger the dither takes other values"
);

/// Triggers after which the dither comes again as it was.
const PHASES: u32 = TRIGGER_TICKS / common_divisor(TIMER_HZ / SAMPLE_RATE_HZ, TRIGGER_TICKS);

const fn common_divisor(mut a: u32, mut b: u32) -> u32 {
    while b > 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// TIM3 and its pin, owned so that nothing else retunes it.
pub(super) struct Dither {
    _parts: DitherParts,
}

impl Dither {
    /// Plays the wave for ever.
    pub(super) fn start(parts: DitherParts) -> Self {
        rcc::enable_and_reset::<peripherals::TIM3>();
        let registers = pac::TIM3;
        registers
            .arr()
            .write(|w| w.set_arr((TRIGGER_TICKS - 1) as u16));
        registers
            .ccr(0)
            .write(|w| w.set_ccr((TRIGGER_TICKS / 2) as u16));
        registers
            .ccmr_output(0)
            .write(|w| w.set_ocm(0, OcmGp::PWM_MODE1));
        registers.ccer().write(|w| w.set_cce(0, true));
        registers.cr1().write(|w| w.set_cen(true));
        Self { _parts: parts }
    }
}
