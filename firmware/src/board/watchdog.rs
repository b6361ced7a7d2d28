//! The watchdog before the tasks run: a start that hangs is one more restart, and counted.
//!
//! From then on [`crate::tasks::supervise`] has it, with a shorter time. Source: RM0433 Rev 8,
//! chapter 45.

use embassy_stm32::pac::IWDG1;
use embassy_stm32::pac::iwdg::vals::{Key, Pr};
use embassy_stm32::rcc::LSI_FREQ;

/// The prescaler that takes the counter furthest.
const PRESCALER: u32 = 256;

/// Starts the watchdog with this time, microseconds, at most 32 s.
pub(super) fn unleash(limit_us: u32) {
    let counts = limit_us / 1_000 * (LSI_FREQ.0 / 1_000) / PRESCALER;
    IWDG1.kr().write(|w| w.set_key(Key::START));
    IWDG1.kr().write(|w| w.set_key(Key::ENABLE));
    IWDG1.pr().write(|w| w.set_pr(Pr::DIVIDE_BY256));
    IWDG1.rlr().write(|w| w.set_rl(counts as u16));
    pet();
}

/// The start goes on.
pub(super) fn pet() {
    IWDG1.kr().write(|w| w.set_key(Key::RESET));
}
