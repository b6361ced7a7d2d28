//! The exciter at rest: listening, and the first drive.

use super::listening::{Listening, block};
use super::{Plan, Sequencer, State};
use crate::correlation::block::MIN_FOLD_SAMPLES;
use crate::correlation::{Block, PairEstimate};
use crate::generator::Drive;
use crate::output::Command;

impl Sequencer<'_> {
    /// Samples will be taken without it, as a survey does: what was heard is of no use after that.
    pub fn forget_hum(&mut self) {
        self.listening = Listening::new();
    }

    /// Nothing is wanted: listens anew.
    pub(super) fn rest(&mut self) {
        self.state = State::Idle;
        self.listening.restart();
        self.correlator
            .start(block(self.sampling.sample_rate_hz), 0);
    }

    /// Takes pairs while the exciter rests; drives it once enough was heard, if that was waited for.
    pub(super) fn listen<'p>(&mut self, pairs: &'p [u32]) -> &'p [u32] {
        let taken = self.correlator.push(pairs);
        self.at_hand = (pairs.len() - taken) as u32;
        if self.correlator.is_complete() {
            if let Some(outline) = self.correlator.outline() {
                self.listening.add(&outline, self.correlator.energy());
            }
            self.correlator
                .start(block(self.sampling.sample_rate_hz), 0);
            if matches!(self.state, State::Listening) && self.listening.is_full() {
                self.listening.understand();
                self.begin_driving();
            }
        }
        pairs.get(taken..).unwrap_or(&[])
    }

    /// Whether what is known of the mains is too old for a point, or too little.
    pub(super) fn must_listen(&mut self, plan: &Plan) -> bool {
        let sample_rate_hz = self.sampling.sample_rate_hz;
        let frequency_hz = plan.tone.frequency_hz(sample_rate_hz);
        let set_peak = plan.level_loop.set_peak_ms2() * plan.code_per_ms2;
        self.listening
            .is_stale(frequency_hz, set_peak, sample_rate_hz)
    }

    /// The first drive of a point, and what is at its tone without it: samples show that until the drive can be in
    /// them, or from before it where 10 ms or a cycle are longer than that.
    pub(super) fn begin_driving(&mut self) {
        let Some(plan) = self.plan else { return };
        let meanwhile = self.at_hand + self.sampling.rest_samples;
        let block = Block::within(plan.tone, meanwhile.max(MIN_FOLD_SAMPLES));
        self.state = State::Resting { driven: None };
        self.correlator
            .start(block.unwrap_or(Block::control(plan.tone)), self.index);
        self.drive_in_time();
    }

    /// Drives an exciter that is still looked at, once the drive comes no sooner than the look ends.
    pub(super) fn drive_in_time(&mut self) {
        let Some(plan) = self.plan else { return };
        let left = self.correlator.remaining();
        let in_time = left <= self.at_hand + self.sampling.rest_samples;
        if in_time && matches!(self.state, State::Resting { driven: None }) {
            self.command = Command::Play(Drive {
                tone: plan.tone,
                peak_v: self.level.drive_peak_v(),
            });
            self.state = State::Resting {
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
