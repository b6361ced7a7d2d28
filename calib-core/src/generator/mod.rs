//! The tone for the exciter, as codes for the drive converter.
//!
//! | property | how |
//! |---|---|
//! | exact frequency and phase for ever | phase in whole samples of the tone's period |
//! | no steps | amplitude changes follow a smooth ramp, a tone changes only in silence |
//! | amplitude finer than a code | rounding errors are fed back past a zero at the tone |
//! | silence is silence | constant mid-scale code, no dither |

#[cfg(test)]
mod tests;

use crate::converter::Width;
use crate::phase::PhaseWalk;
use crate::tone::Tone;
use serde::{Deserialize, Serialize};

/// Shortest ramp from one amplitude to the next, in samples (5 ms).
pub const MIN_RAMP_SAMPLES: u16 = 250;

/// Longest, but for tones of less than 20 Hz (50 ms).
const MAX_RAMP_SAMPLES: u16 = 2500;

/// Signal the exciter plays.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Drive {
    /// Frequency.
    pub tone: Tone,
    /// Amplitude at the exciter, V peak; 0 is silence.
    pub peak_v: f32,
}

/// Length of the ramp between two amplitudes, in samples: seven quarters of a cycle of the tone, between
/// [`MIN_RAMP_SAMPLES`] and the longer of 50 ms and a cycle.
///
/// A suspension well below the tone rings behind it with 1 % of the level or less, behind a ramp of one cycle with
/// 2 to 6 %: test `a_ramp_hardly_makes_a_suspension_ring`.
pub fn ramp_samples(tone: Tone) -> u16 {
    let cycle = tone.period_samples / tone.cycles.max(1);
    (cycle / 4 * 7).clamp(MIN_RAMP_SAMPLES, cycle.max(MAX_RAMP_SAMPLES))
}

/// Fills buffers of converter codes.
///
/// # Accuracy
/// The fundamental of the code sequence is that of the ideal sine within 0.1 %
/// from one code peak upwards: test `amplitude_is_finer_than_a_code`.
#[derive(Clone, Debug)]
pub struct Generator {
    width: Width,
    code_per_volt: f32,
    tone: Tone,
    walk: PhaseWalk,
    /// Amplitude at the end of the ramp, codes.
    to: f32,
    /// Amplitude at its beginning, codes.
    from: f32,
    /// Samples of the ramp still to come.
    ramp_left: u16,
    pending: Option<Drive>,
    shaper: Shaper,
}

impl Generator {
    /// A silent generator.
    ///
    /// `full_scale_peak_v` is the voltage at the exciter for half of the range
    /// of a converter of `width`; `seed` starts the dither and may be any number.
    pub fn new(width: Width, full_scale_peak_v: f32, seed: u32) -> Self {
        let tone = Tone {
            cycles: 1,
            period_samples: MIN_RAMP_SAMPLES,
        };
        Self {
            width,
            code_per_volt: f32::from(width.mid_code()) / full_scale_peak_v,
            tone,
            walk: PhaseWalk::new(tone, 0),
            to: 0.0,
            from: 0.0,
            ramp_left: 0,
            pending: None,
            shaper: Shaper::new(width, tone, seed),
        }
    }

    /// Asks for another drive. Amplitudes ramp from where they are; another
    /// tone waits until this one has ramped down, and begins at phase 0.
    pub fn set(&mut self, drive: Drive) {
        if drive.tone == self.tone {
            self.pending = None;
            self.ramp_to(drive.peak_v * self.code_per_volt);
        } else if self.is_silent() {
            self.pending = None;
            self.change_tone(drive);
        } else {
            self.pending = Some(drive);
            self.ramp_to(0.0);
        }
    }

    /// Silence at once, without a ramp: for faults and overloads.
    pub fn mute(&mut self) {
        self.pending = None;
        self.to = 0.0;
        self.from = 0.0;
        self.ramp_left = 0;
    }

    /// True when the output is constant mid-scale.
    pub fn is_silent(&self) -> bool {
        self.ramp_left == 0 && self.to == 0.0
    }

    /// Fills `codes` with the next samples.
    ///
    /// # Timing
    /// About 60 instructions per sample.
    pub fn fill(&mut self, codes: &mut [u16]) {
        for code in codes {
            *code = self.next_code();
        }
    }

    fn next_code(&mut self) -> u16 {
        if self.is_silent() {
            if let Some(drive) = self.pending.take() {
                self.change_tone(drive);
            } else {
                // The walk goes on: the phase stays that of the sample clock.
                self.walk.skip();
                return self.width.mid_code();
            }
        }
        let (_, sine) = self.walk.next_cos_sin();
        let ideal = self.amplitude() * sine;
        self.shaper.code(ideal)
    }

    /// Amplitude of this sample; moves the ramp on.
    fn amplitude(&mut self) -> f32 {
        if self.ramp_left == 0 {
            return self.to;
        }
        let left = f32::from(self.ramp_left) / f32::from(ramp_samples(self.tone));
        self.ramp_left -= 1;
        // Smoothstep: no corner at either end, monotone in between.
        self.to + (self.from - self.to) * left * left * (3.0 - 2.0 * left)
    }

    fn ramp_to(&mut self, codes: f32) {
        // What is not a number is silence.
        let wanted = if codes.is_finite() { codes.abs() } else { 0.0 };
        let codes = wanted.min(f32::from(self.width.mid_code()) - 2.0);
        if codes != self.to {
            self.from = self.amplitude();
            self.to = codes;
            self.ramp_left = ramp_samples(self.tone);
        }
    }

    fn change_tone(&mut self, drive: Drive) {
        self.tone = drive.tone;
        self.walk = PhaseWalk::new(drive.tone, 0);
        self.shaper.tune(drive.tone);
        self.ramp_to(drive.peak_v * self.code_per_volt);
    }
}

/// Rounds to codes and feeds the rounding error back.
///
/// With `e` the error of each code, the output is `ideal + e - c1 e' - c2 e''`.
/// From 1/50 of the sample rate on, `1 - c1 z^-1 - c2 z^-2` has its zero at the
/// tone, so the error has no fundamental there at all; below, the plain
/// difference `1 - z^-1` is as good and adds less noise. Dither keeps the
/// error from repeating with the tone.
#[derive(Clone, Debug)]
struct Shaper {
    mid_code: f32,
    last_code: f32,
    feedback: [f32; 2],
    errors: [f32; 2],
    random: u32,
}

impl Shaper {
    fn new(width: Width, tone: Tone, seed: u32) -> Self {
        let mut shaper = Self {
            mid_code: f32::from(width.mid_code()),
            last_code: f32::from(width.last_code()),
            feedback: [1.0, 0.0],
            errors: [0.0; 2],
            // The generator of random numbers must not start at zero.
            random: seed | 1,
        };
        shaper.tune(tone);
        shaper
    }

    fn tune(&mut self, tone: Tone) {
        let (cycles, period) = (
            u32::from(tone.cycles),
            u32::from(tone.period_samples).max(1),
        );
        self.feedback = if 50 * cycles < period {
            [1.0, 0.0]
        } else {
            let (cosine, _) = crate::phase::cos_sin(cycles % period, period);
            [2.0 * cosine, -1.0]
        };
        self.errors = [0.0; 2];
    }

    fn code(&mut self, ideal: f32) -> u16 {
        let [last, before] = self.errors;
        let wanted = ideal + self.feedback[0] * last + self.feedback[1] * before;
        let position = self.mid_code + wanted + self.dither();
        // Not `clamp`, which panics at limits that are no numbers.
        let code = libm::roundf(position).max(0.0).min(self.last_code);
        // Limited, so that a clamped code does not wind the feedback up.
        let error = (wanted - (code - self.mid_code)).clamp(-1.0, 1.0);
        self.errors = [error, last];
        code as u16
    }

    /// Uniform in -0.5..0.5 codes (Marsaglia's xorshift, 32 bits).
    fn dither(&mut self) -> f32 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 17;
        self.random ^= self.random << 5;
        // 24 bits are what an f32 holds exactly.
        (self.random >> 8) as f32 / 16_777_216.0 - 0.5
    }
}
