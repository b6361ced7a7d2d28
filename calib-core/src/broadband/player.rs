//! Plays a broadband period again and again, as codes for the converter.

use super::{Excitation, RECORD_SAMPLES};
use crate::converter::Width;
use num_complex::Complex32;
use serde::{Deserialize, Serialize};

/// Samples of a ramp from one amplitude to the next (20 ms).
pub const RAMP_SAMPLES: u16 = 1_000;

/// Signal the exciter plays.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BroadbandDrive {
    /// Band and phases.
    pub excitation: Excitation,
    /// Largest magnitude at the exciter, V; 0 is silence.
    pub peak_v: f32,
}

/// Room for one period; 32 KB.
pub struct PeriodMemory([Complex32; RECORD_SAMPLES]);

impl PeriodMemory {
    /// Empty memory, for a static.
    pub const fn new() -> Self {
        Self([Complex32::new(0.0, 0.0); RECORD_SAMPLES])
    }
}

impl Default for PeriodMemory {
    fn default() -> Self {
        Self::new()
    }
}

/// A period that repeats. Codes are rounded without noise shaping: what the
/// rounding adds is real motion, the same for both transducers.
pub struct Player<'m> {
    period: &'m mut PeriodMemory,
    excitation: Option<Excitation>,
    width: Width,
    code_per_volt: f32,
    next: usize,
    /// Amplitude now, its goal, and the step of the ramp, in codes.
    amplitude: f32,
    to: f32,
    step: f32,
}

impl<'m> Player<'m> {
    /// A silent player; `full_scale_peak_v` is the voltage for half of the range
    /// of a converter of `width`.
    pub fn new(period: &'m mut PeriodMemory, width: Width, full_scale_peak_v: f32) -> Self {
        let mut player = Self {
            period,
            excitation: None,
            width,
            code_per_volt: 0.0,
            next: 0,
            amplitude: 0.0,
            to: 0.0,
            step: 0.0,
        };
        player.scale(full_scale_peak_v);
        player
    }

    /// Another full scale; only in silence.
    pub fn scale(&mut self, full_scale_peak_v: f32) {
        self.code_per_volt = f32::from(self.width.mid_code()) / full_scale_peak_v;
    }

    /// Asks for another drive. The amplitude ramps; another excitation begins
    /// at once, with the jump that noise may have anyway.
    ///
    /// # Timing
    /// Another excitation costs one transform of 4096 points.
    pub fn set(&mut self, drive: BroadbandDrive) {
        if self.excitation != Some(drive.excitation) {
            let usable = drive.excitation.fill(&mut self.period.0).is_some();
            self.excitation = usable.then_some(drive.excitation);
        }
        let wanted = drive.peak_v * self.code_per_volt;
        // What is not a number is silence, and so is a band that is none.
        let usable = wanted.is_finite() && self.excitation.is_some();
        let to = if usable { wanted.abs() } else { 0.0 };
        let to = to.min(f32::from(self.width.mid_code()) - 2.0);
        if to != self.to {
            self.to = to;
            self.step = (to - self.amplitude).abs() / f32::from(RAMP_SAMPLES);
        }
    }

    /// Silence at once, without a ramp.
    pub fn mute(&mut self) {
        (self.amplitude, self.to) = (0.0, 0.0);
    }

    /// True when the output is constant mid-scale.
    pub fn is_silent(&self) -> bool {
        self.amplitude == 0.0 && self.to == 0.0
    }

    /// Fills `codes` with the next samples.
    pub fn fill(&mut self, codes: &mut [u16]) {
        let [mid_code, last_code] = [self.width.mid_code(), self.width.last_code()].map(f32::from);
        for code in codes {
            let left = self.to - self.amplitude;
            // The last step lands on the goal: rounding must not leave a rest.
            self.amplitude = if left.abs() <= self.step {
                self.to
            } else {
                self.amplitude + self.step.copysign(left)
            };
            let value = self.period.0.get(self.next).map_or(0.0, |value| value.re);
            self.next = (self.next + 1) % RECORD_SAMPLES;
            let position = mid_code + self.amplitude * value;
            *code = libm::roundf(position).max(0.0).min(last_code) as u16;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Phases;
    use super::*;

    fn drive(peak_v: f32, seed: u32) -> BroadbandDrive {
        let excitation = Excitation {
            first: 2,
            last: 800,
            phases: Phases::Random { seed },
        };
        BroadbandDrive { excitation, peak_v }
    }

    fn play(player: &mut Player<'_>, samples: usize) -> Vec<i32> {
        let mut codes = vec![0; samples];
        player.fill(&mut codes);
        codes.iter().map(|&code| i32::from(code) - 2048).collect()
    }

    #[test]
    fn the_period_repeats_at_the_peak_asked_for() {
        let mut memory = Box::new(PeriodMemory::new());
        let mut player = Player::new(&mut memory, Width::of_bits(12), 10.0);
        player.set(drive(5.0, 3));
        play(&mut player, usize::from(RAMP_SAMPLES));
        let one = play(&mut player, RECORD_SAMPLES);
        assert_eq!(one, play(&mut player, RECORD_SAMPLES));
        // 5 V of 10 V are 1024 codes, which noise reaches or almost.
        let peak = one.iter().map(|code| code.abs()).max();
        assert!(peak.is_some_and(|peak| (600..=1024).contains(&peak)));
        // Another seed, another noise.
        player.set(drive(5.0, 5));
        assert_ne!(one, play(&mut player, RECORD_SAMPLES));
    }

    #[test]
    fn silence_is_reached_by_a_ramp_or_at_once() {
        let mut memory = Box::new(PeriodMemory::new());
        let mut player = Player::new(&mut memory, Width::of_bits(12), 10.0);
        assert!(player.is_silent());
        player.set(drive(5.0, 3));
        play(&mut player, 5_000);
        player.set(drive(0.0, 3));
        assert!(!player.is_silent());
        play(&mut player, usize::from(RAMP_SAMPLES) + 1);
        assert!(player.is_silent());
        player.set(drive(5.0, 3));
        play(&mut player, 5_000);
        player.mute();
        assert_eq!(play(&mut player, 3), [0, 0, 0]);
        // What is no voltage, and a band that is none, stay silent.
        player.set(drive(f32::NAN, 3));
        assert!(player.is_silent());
        let mut none = drive(5.0, 3);
        none.excitation.first = 0;
        player.set(none);
        assert!(player.is_silent());
    }
}
