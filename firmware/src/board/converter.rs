//! Bringing a converter of the part up: what ADC1, ADC2 and ADC3 have in common.
//!
//! Source: RM0433 Rev 8, sections 25.4.6 to 25.4.9.

use super::description::Silicon;
use super::selected::CLOCKS;
use embassy_stm32::pac::adc::{Adc, vals};
use embassy_time::{Duration, Timer, with_timeout};

/// The converter is ready within microseconds.
const ENABLE_LIMIT: Duration = Duration::from_millis(1);
/// Longest offset and linearity calibration: 165 010 cycles of the converter
/// clock (DS12110 Rev 10, table 87), of 16 MHz at least, with a margin of two.
const CALIBRATION_LIMIT: Duration = Duration::from_millis(20);

/// A converter does not answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, defmt::Format)]
pub(crate) struct NotReady;

/// Boost the comparators of a converter fed with `clock_hz` need (25.6.3).
const fn boost(clock_hz: u32) -> vals::Boost {
    match CLOCKS.silicon {
        // One bit, above 20 MHz: the lower of the two that revision V has.
        Silicon::Y if clock_hz > 20_000_000 => vals::Boost::LT12_5,
        Silicon::Y => vals::Boost::LT6_25,
        Silicon::V => match clock_hz / 2 {
            ..=6_250_000 => vals::Boost::LT6_25,
            ..=12_500_000 => vals::Boost::LT12_5,
            ..=25_000_000 => vals::Boost::LT25,
            _ => vals::Boost::LT50,
        },
    }
}

/// Powers a converter that is fed with `clock_hz` and measures its offset and
/// linearity (25.4.8).
pub(super) async fn calibrate(adc: Adc, clock_hz: u32) -> Result<(), NotReady> {
    adc.cr().modify(|w| {
        w.set_deeppwd(false);
        w.set_advregen(true);
        w.set_boost(boost(clock_hz));
    });
    regulator_ready(adc).await?;
    adc.cr().modify(|w| {
        w.set_adcaldif(vals::Adcaldif::SINGLE_ENDED);
        w.set_adcallin(true);
        w.set_adcal(true);
    });
    within(CALIBRATION_LIMIT, || !adc.cr().read().adcal()).await
}

/// Waits for the regulator: a calibration before it is up goes wrong without a word
/// (zephyr PR 75048). Revision Y has no flag for it, only the longest start-up,
/// t_ADCVREG_STUP (DS12110 Rev 10, table 87).
async fn regulator_ready(adc: Adc) -> Result<(), NotReady> {
    match CLOCKS.silicon {
        Silicon::Y => {
            Timer::after_micros(10).await;
            Ok(())
        }
        Silicon::V => within(ENABLE_LIMIT, || adc.isr().read().ldordy()).await,
    }
}

pub(super) async fn enable(adc: Adc) -> Result<(), NotReady> {
    adc.isr().write(|w| w.set_adrdy(true));
    adc.cr().modify(|w| w.set_aden(true));
    within(ENABLE_LIMIT, || adc.isr().read().adrdy()).await
}

/// Looks every 0.1 ms until `ready`, at most for `limit`.
pub(super) async fn within(limit: Duration, ready: impl Fn() -> bool) -> Result<(), NotReady> {
    let poll = async {
        while !ready() {
            Timer::after_micros(100).await;
        }
    };
    with_timeout(limit, poll).await.map_err(|_| NotReady)
}
