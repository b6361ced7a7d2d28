//! Random numbers of the part's generator (RM0433 Rev 8, 34), for the instrument's key.
//!
//! It runs while it is asked and no longer. The HAL's driver waits for a word for ever, at the start too: a
//! generator out of order would keep the board from coming up.

use calib_firmware::device_key::RANDOM_BYTES;
use embassy_futures::yield_now;
use embassy_stm32::pac::rng::regs::Sr;
use embassy_stm32::pac::{RCC, RNG};
use embassy_stm32::{Peri, peripherals};

/// Looks at the generator until a word is there: the first takes 5 us, a look some 0.1 us.
const LOOKS: u32 = 10_000;

/// The generator.
pub(crate) struct RandomSource {
    /// Held, so that nothing else uses it.
    _generator: Peri<'static, peripherals::RNG>,
}

impl RandomSource {
    /// The generator, at rest.
    pub(crate) fn new(generator: Peri<'static, peripherals::RNG>) -> Self {
        Self {
            _generator: generator,
        }
    }

    /// Bytes that nobody knows; none when the generator gives none, or finds itself out of order.
    pub(crate) async fn bytes(&self) -> Option<[u8; RANDOM_BYTES]> {
        RCC.ahb2enr().modify(|w| w.set_rngen(true));
        // The clock is there two cycles later (RM0433 Rev 8, 8.5.11).
        let _ = RCC.ahb2enr().read();
        RNG.cr().write(|w| w.set_rngen(true));
        let bytes = read().await;
        RNG.cr().write(|w| w.set_rngen(false));
        RCC.ahb2enr().modify(|w| w.set_rngen(false));
        bytes
    }
}

/// Words of which none is like the one before; the first is that of no key (RM0433 Rev 8, 34.3.5).
async fn read() -> Option<[u8; RANDOM_BYTES]> {
    let mut bytes = [0; RANDOM_BYTES];
    let mut before = next()?;
    for place in bytes.chunks_exact_mut(4) {
        yield_now().await;
        let word = next().filter(|word| *word != before)?;
        place.copy_from_slice(&word.to_le_bytes());
        before = word;
    }
    Some(bytes)
}

/// The next word; a zero is none (RM0433 Rev 8, 34.7.3).
fn next() -> Option<u32> {
    let is_sound = |state: Sr| !(state.seis() || state.secs() || state.ceis() || state.cecs());
    for _ in 0..LOOKS {
        let state = RNG.sr().read();
        if !is_sound(state) {
            return None;
        }
        if state.drdy() {
            return Some(RNG.dr().read()).filter(|word| *word != 0);
        }
    }
    None
}
