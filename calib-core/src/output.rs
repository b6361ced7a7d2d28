//! The one output: a tone or a broadband period, never both.

use crate::broadband::{BroadbandDrive, PeriodMemory, Player};
use crate::converter::Width;
use crate::generator::{Drive, Generator};

/// Command to the exciter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Command {
    /// Play this tone, ramping from what is played now.
    Play(Drive),
    /// Play this band, ramping from what is played now.
    PlayBroadband(BroadbandDrive),
    /// Silence at once.
    Mute,
}

/// Source of the converter's codes.
pub struct Output<'m> {
    tone: Generator,
    broadband: Player<'m>,
    width: Width,
    seed: u32,
}

impl<'m> Output<'m> {
    /// A silent output; see [`Generator::new`] and [`Player::new`].
    pub fn new(
        period: &'m mut PeriodMemory,
        width: Width,
        full_scale_peak_v: f32,
        seed: u32,
    ) -> Self {
        Self {
            tone: Generator::new(width, full_scale_peak_v, seed),
            broadband: Player::new(period, width, full_scale_peak_v),
            width,
            seed,
        }
    }

    /// Another full scale; only between runs, in silence.
    pub fn scale(&mut self, full_scale_peak_v: f32) {
        self.tone = Generator::new(self.width, full_scale_peak_v, self.seed);
        self.broadband.scale(full_scale_peak_v);
    }

    /// Carries out a command. Tone and broadband only follow each other
    /// through silence: a run has one of them.
    pub fn apply(&mut self, command: Command) {
        match command {
            Command::Play(drive) => {
                self.broadband.mute();
                self.tone.set(drive);
            }
            Command::PlayBroadband(drive) => {
                self.tone.mute();
                self.broadband.set(drive);
            }
            Command::Mute => self.mute(),
        }
    }

    /// Silence at once, without a ramp: for faults and overloads.
    pub fn mute(&mut self) {
        self.tone.mute();
        self.broadband.mute();
    }

    /// True when the output is constant mid-scale.
    pub fn is_silent(&self) -> bool {
        self.tone.is_silent() && self.broadband.is_silent()
    }

    /// Fills `codes` with the next samples.
    pub fn fill(&mut self, codes: &mut [u16]) {
        if self.broadband.is_silent() {
            self.tone.fill(codes);
        } else {
            self.broadband.fill(codes);
        }
    }
}
