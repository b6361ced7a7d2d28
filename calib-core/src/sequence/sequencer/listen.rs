//! Listening while the exciter rests: to the mains, and to how much noise there is.

use super::{Plan, Sampling, Sequencer, Stage};
use crate::correlation::block::MIN_FOLD_SAMPLES;
use crate::correlation::{Block, Energy, Outline, PairEstimate};
use crate::generator::Drive;
use crate::hum::{Hum, WATCH_BLOCKS, Watch};
use crate::output::Command;
use crate::tone::Tone;

/// Time for which the mains as heard hold for a point far from every line, s.
const GOOD_FOR_S: f32 = 60.0;
/// And for one beside a line: the grid moves by 10 mHz in such a time.
const GOOD_BESIDE_A_LINE_FOR_S: f32 = 5.0;
/// Beside a line, Hz: within the width of a block of 0.1 s.
const BESIDE_HZ: f32 = 10.0;
/// A line that is less of the set level does not need to be heard again.
const SMALL_REL: f32 = 2.0e-4;

/// The mains as last heard, and the noise.
#[derive(Clone, Debug)]
pub(super) struct Listening {
    watch: Watch,
    /// Mean square of both channels about their means over the last blocks, codes squared.
    noise_square: [f32; 2],
    /// `noise_square` when a point last took over what was heard.
    rest_square: [f32; 2],
    /// A second was heard, and this was in it.
    heard: Option<Option<Hum>>,
    /// Samples since.
    age: u32,
}

impl Listening {
    pub(super) const fn new() -> Self {
        Self {
            watch: Watch::new(),
            noise_square: [0.0; 2],
            rest_square: [0.0; 2],
            heard: None,
            age: 0,
        }
    }

    /// So many samples have passed.
    pub(super) fn pass(&mut self, samples: usize) {
        self.age = self.age.saturating_add(samples as u32);
    }

    /// The lines there are.
    pub(super) fn hum(&self) -> Option<Hum> {
        self.heard.flatten()
    }

    /// The largest line of a channel, codes; 0 as long as nobody listened.
    pub(super) fn largest_line_peak(&self, channel: usize) -> f32 {
        let hum = self.hum();
        let lines = hum.iter().flat_map(|hum| &hum.lines_peak);
        lines
            .filter_map(|peaks| peaks.get(channel))
            .fold(0.0, |a, b| a.max(*b))
    }

    /// Mean square of both channels with the exciter at rest, codes squared: what has nothing to do with
    /// the motion. 0 as long as nobody listened.
    pub(super) fn rest_square(&self) -> [f32; 2] {
        self.rest_square
    }

    /// Adds a block at rest.
    fn add(&mut self, outline: &Outline, energy: Energy) {
        let weight = 1.0 / (self.watch.count() + 1).min(WATCH_BLOCKS) as f32;
        for (channel, square) in self.noise_square.iter_mut().enumerate() {
            let values = outline.iter().filter_map(|pair| pair.get(channel));
            let mean = values.sum::<f32>() / outline.len() as f32;
            *square += (energy.mean_square(channel) - mean * mean - *square) * weight;
        }
        self.watch.add(outline);
    }
}

/// A block in which every multiple of 50 and 60 Hz has whole cycles.
pub(super) fn block(sampling: &Sampling) -> Block {
    let tone = Tone {
        cycles: 1,
        period_samples: (0.1 * sampling.sample_rate_hz) as u16,
    };
    Block::measuring(tone, 1)
}

impl Sequencer<'_> {
    /// Samples will be taken without it, as a survey does: what was heard is of no use after that.
    pub fn forget_hum(&mut self) {
        self.listening = Listening::new();
    }

    /// Nothing is wanted: listens anew.
    pub(super) fn rest(&mut self) {
        self.stage = Stage::Idle;
        self.listening.watch.restart();
        self.correlator.start(block(&self.sampling), 0);
    }

    /// Takes pairs while the exciter rests; drives it once enough was heard, if that was waited for.
    pub(super) fn listen<'p>(&mut self, pairs: &'p [u32]) -> &'p [u32] {
        let taken = self.correlator.push(pairs);
        self.at_hand = (pairs.len() - taken) as u32;
        if self.correlator.is_complete() {
            if let Some(outline) = self.correlator.outline() {
                self.listening.add(&outline, self.correlator.energy());
            }
            self.correlator.start(block(&self.sampling), 0);
            if matches!(self.stage, Stage::Listening) && self.listening.watch.is_full() {
                self.understand();
                self.begin_driving();
            }
        }
        pairs.get(taken..).unwrap_or(&[])
    }

    /// Takes over what was heard.
    fn understand(&mut self) {
        self.listening.heard = Some(self.listening.watch.hum());
        self.listening.rest_square = self.listening.noise_square;
        self.listening.age = 0;
    }

    /// Whether what is known of the mains is too old for a point, or too little.
    pub(super) fn must_listen(&mut self, plan: &Plan) -> bool {
        if self.listening.watch.is_full() {
            self.understand();
        }
        let age_s = self.listening.age as f32 / self.sampling.sample_rate_hz;
        match self.listening.heard {
            None => true,
            Some(None) => age_s > GOOD_FOR_S,
            Some(Some(hum)) if self.is_beside_a_line(plan, &hum) => {
                age_s > GOOD_BESIDE_A_LINE_FOR_S
            }
            Some(Some(_)) => age_s > GOOD_FOR_S,
        }
    }

    fn is_beside_a_line(&self, plan: &Plan, hum: &Hum) -> bool {
        let frequency_hz = plan.tone.frequency_hz(self.sampling.sample_rate_hz);
        let set_peak = plan.level_loop.set_peak_ms2() * plan.code_per_ms2;
        hum.lines_peak.iter().zip(1_u16..).any(|(peaks, multiple)| {
            let beside_hz = (frequency_hz - f32::from(multiple) * hum.mains_hz).abs();
            let largest = peaks.iter().fold(0.0_f32, |a, b| a.max(*b));
            beside_hz < BESIDE_HZ && largest > SMALL_REL * set_peak
        })
    }

    /// The first drive of a point, and what is at its tone without it: samples show that until the drive can be in
    /// them, or from before it where 10 ms or a cycle are longer than that.
    pub(super) fn begin_driving(&mut self) {
        let Some(plan) = self.plan else { return };
        let meanwhile = self.at_hand + self.sampling.rest_samples;
        let block = Block::within(plan.tone, meanwhile.max(MIN_FOLD_SAMPLES));
        self.stage = Stage::Resting { driven: None };
        self.correlator
            .start(block.unwrap_or(Block::control(plan.tone)), self.index);
        self.drive_in_time();
    }

    /// Drives an exciter that is still looked at, once the drive comes no sooner than the look ends.
    pub(super) fn drive_in_time(&mut self) {
        let Some(plan) = self.plan else { return };
        let left = self.correlator.remaining();
        let in_time = left <= self.at_hand + self.sampling.rest_samples;
        if in_time && matches!(self.stage, Stage::Resting { driven: None }) {
            self.command = Command::Play(Drive {
                tone: plan.tone,
                peak_v: self.level.drive_peak_v(),
            });
            self.stage = Stage::Resting {
                driven: Some(self.way_samples(plan.tone).saturating_sub(left)),
            };
            self.elapsed = 0;
        }
    }

    /// Keeps what is at rest at the tone.
    pub(super) fn rested(&mut self, plan: &Plan, estimate: &PairEstimate, left: Option<u32>) {
        self.rest = Some([estimate.reference.amplitude, estimate.dut.amplitude]);
        self.level
            .see_rest(estimate.reference.amplitude_peak() / plan.code_per_ms2);
        match left {
            Some(left) => self.wait_for(plan.tone, left),
            None => self.drive(plan.tone, self.level.drive_peak_v()),
        }
    }
}
