//! Flaws of the converters of a part, what else is broken in it for good, and the way from DAC to ADC2 in a
//! sound one.
//!
//! Flaws outlive a reset, as silicon does. Those of the DAC show on its pin and on the chip alike, but
//! for its noise, which only the way on the chip has: on the pin the rig's output stage has its own.
//! Noise is drawn from the instant of the conversion, so that a run is the same run every time.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A flaw of one converter: added to what it would give, in this order. All zero is a sound one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Flaw {
    /// Relative error of the gain about mid-scale, parts per million.
    pub gain_ppm: i32,
    /// Offset, in codes of the converter: 16 bits of an ADC, 12 of the DAC.
    pub offset: i32,
    /// Peak of even noise, in the same codes.
    pub noise_peak: u32,
    /// Bits of the code that are always set.
    pub stuck_high: u16,
    /// Whether all bits stand still, at mid-scale.
    pub dead: bool,
}

/// A converter that can have a flaw.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flawed {
    /// ADC1: the reference's input.
    Adc1,
    /// ADC2: the input of the device under test.
    Adc2,
    /// DAC1: the drive.
    Dac,
}

/// Noise of a sound DAC on its way to ADC2, 16-bit codes peak: 68 dB below its full scale (DS12110
/// Rev 10, table 188), 9 codes r.m.s.
const INTERNAL_NOISE_PEAK: f64 = 16.0;

/// Flaws of all converters. A shared handle.
#[derive(Debug, Clone, Default)]
pub(super) struct Flaws(Arc<Mutex<State>>);

/// State behind the handle [`Flaws`].
#[derive(Debug, Default)]
pub(super) struct State {
    flaws: [Flaw; 3],
    /// Code of the DAC while a mode connects it to the converters on the chip.
    internal: Option<u16>,
    processor_centi_c: Option<i32>,
}

impl Flaws {
    /// The flaws, for more than one call.
    pub(super) fn lock(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(super) fn set(&self, of: Flawed, flaw: Flaw) {
        self.lock().flaws[of as usize] = flaw;
    }

    pub(super) fn set_processor_centi_c(&self, centi_c: Option<i32>) {
        self.lock().processor_centi_c = centi_c;
    }

    pub(super) fn processor_centi_c(&self) -> Option<i32> {
        self.lock().processor_centi_c
    }
}

impl State {
    /// Output of the DAC for `code`.
    pub(super) fn dac(&self, code: u16) -> u16 {
        self.flaws[Flawed::Dac as usize].of(code, 12, || 0.0)
    }

    /// The DAC's output reaches the converters on the chip with this code, or no more.
    pub(super) fn connect(&mut self, code: Option<u16>) {
        self.internal = code;
    }

    /// 16-bit code of the DAC's output on the chip; 0 V while none is connected.
    pub(super) fn internal(&self, now_ns: u64) -> u16 {
        let noise_peak = f64::from(self.flaws[Flawed::Dac as usize].noise_peak) * 16.0;
        let noise = even(now_ns, 3) * (INTERNAL_NOISE_PEAK + noise_peak);
        let level = f64::from(self.internal.unwrap_or(0)) * 16.0 + noise;
        level.round().clamp(0.0, 65_535.0) as u16
    }

    /// Results of ADC1 (0) and ADC2 (1) for `codes`.
    pub(super) fn adc(&self, codes: [u16; 2], now_ns: u64) -> [u16; 2] {
        [0, 1].map(|nth| self.flaws[nth].of(codes[nth], 16, || even(now_ns, nth as u64)))
    }
}

impl Flaw {
    /// The code of a converter of `bits` that should give `code`; `noise` is -1 to 1.
    fn of(&self, code: u16, bits: u32, noise: impl FnOnce() -> f64) -> u16 {
        if *self == Self::default() {
            return code;
        }
        let (mid, last) = (
            f64::from(1_u32 << (bits - 1)),
            f64::from((1_u32 << bits) - 1),
        );
        if self.dead {
            return mid as u16;
        }
        let gain = 1.0 + f64::from(self.gain_ppm) * 1e-6;
        let level = mid + (f64::from(code) - mid) * gain + f64::from(self.offset);
        let noisy = level + noise() * f64::from(self.noise_peak);
        noisy.round().clamp(0.0, last) as u16 | self.stuck_high
    }
}

/// Even noise of -1 to 1, the same each time for an instant.
fn even(now_ns: u64, salt: u64) -> f64 {
    let instant = now_ns.wrapping_mul(4).wrapping_add(salt);
    ChaCha8Rng::seed_from_u64(instant).random_range(-1.0..1.0)
}

/// Faults that outlive a reset and a power cycle, until they are mended. A shared handle.
#[derive(Debug, Clone, Default)]
pub struct Lasting(Arc<Mutex<Broken>>);

/// Faults in force.
#[derive(Debug, Clone, Copy, Default)]
struct Broken {
    converters: [bool; 2],
    clock: bool,
    flash: bool,
}

impl Lasting {
    fn lock(&self) -> MutexGuard<'_, Broken> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Whether ADC1 (0) or ADC2 (1) answers.
    pub(super) fn converter_answers(&self, nth: usize) -> bool {
        self.lock().converters.get(nth) != Some(&true)
    }

    /// Whether there is a clock at OSC_IN.
    pub(super) fn is_clocked(&self) -> bool {
        !self.lock().clock
    }

    /// Whether bank 2 is write-protected.
    pub(super) fn flash_is_protected(&self) -> bool {
        self.lock().flash
    }

    /// ADC1 (0) or ADC2 (1) answers no more.
    pub(super) fn kill_converter(&self, nth: usize) {
        if let Some(dead) = self.lock().converters.get_mut(nth) {
            *dead = true;
        }
    }

    /// There is no clock at OSC_IN any more.
    pub(super) fn stop_clock(&self) {
        self.lock().clock = true;
    }

    /// Bank 2 is write-protected.
    pub(super) fn protect_flash(&self) {
        self.lock().flash = true;
    }

    /// Mends all faults of the part.
    pub(crate) fn mend(&self) {
        *self.lock() = Broken::default();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flaws_by_hand() {
        let sound = Flaw::default();
        assert_eq!(
            (sound.of(100, 12, || 1.0), sound.of(65_535, 16, || 0.0)),
            (100, 65_535)
        );
        let flaw = Flaw {
            gain_ppm: -50_000,
            offset: 7,
            ..sound
        };
        // 2048 + 0.95 * 1000 + 7.
        assert_eq!(flaw.of(3048, 12, || 0.0), 3005);
        assert_eq!(
            Flaw {
                stuck_high: 0x20,
                ..sound
            }
            .of(64, 12, || 0.0),
            96
        );
        assert_eq!(
            Flaw {
                dead: true,
                ..sound
            }
            .of(64, 16, || 0.0),
            32_768
        );
        assert_eq!(
            Flaw {
                noise_peak: 10,
                ..sound
            }
            .of(64, 16, || -1.0),
            54
        );
    }

    #[test]
    fn noise_is_even_and_of_the_instant() {
        let draws: Vec<f64> = (0..10_000).map(|nth| even(nth * 20_000, 1)).collect();
        let mean = draws.iter().sum::<f64>() / 1e4;
        let power = draws.iter().map(|draw| draw * draw).sum::<f64>() / 1e4;
        // Of even noise 1/3, known to 1 %; a mean of 10 000 to 0.006.
        assert!(
            mean.abs() < 0.02 && (power - 1.0 / 3.0).abs() < 0.01,
            "{mean} {power}"
        );
        assert_eq!(even(7, 1), even(7, 1));
    }
}
