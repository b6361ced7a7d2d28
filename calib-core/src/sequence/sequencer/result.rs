//! From what was gathered to the result of a point.

use super::{Plan, Sequencer};
use crate::budget::point_budget;
use crate::hum::Span;
use crate::phase::PhaseWalk;
use crate::point::PointResult;
use crate::point_state::{PointState, Reason};
use crate::requirements::VibrationGeneration;
use crate::sequence::checks::Measured;
use crate::sequence::stretches::Ratio;
use crate::tone::Tone;
use core::f32::consts::FRAC_1_SQRT_2;
use num_complex::Complex32;

/// Fewest blocks of a point, unless the settings want fewer: their agreement shows that nothing changes.
const FEWEST_BLOCKS: u16 = 3;
/// Type A below this share of U adds nothing to U: 0.5 % of it, as squares add.
const ENOUGH_OF_U: f32 = 0.05;
/// Blocks that differ by less than this share of U agree, whatever their noise: a beat that is at its crest for three
/// blocks may hide eight times as much.
const AGREE_OF_U: f32 = 0.01;
/// Deviation of three blocks over that of the noise within them, which chance exceeds in one of a thousand:
/// chi-square of 2 degrees of freedom, (13.8 / 2)^1/2.
const CHANCE_OF_NOISE: f32 = 2.6;

impl Sequencer<'_> {
    /// Values of `result` that the checks judge.
    pub(super) fn measured(&self, plan: &Plan, result: &PointResult) -> Measured {
        let rate_hz = self.sampling.sample_rate_hz;
        let frequency_hz = plan.tone.frequency_hz(rate_hz);
        Measured {
            frequency_hz: plan.spec.frequency_hz,
            frequency_deviation_rel: frequency_hz / plan.spec.frequency_hz - 1.0,
            clipped: self.gathered.clipped,
            distortion_rel: self.gathered.distortion_rel(0),
            dut_distortion_rel: self.gathered.distortion_rel(1),
            repeatability_rel: result.repeatability_rel,
            hum_rel: result.hum_rel,
            dut_signal_to_noise_db: self.gathered.dut_worst_signal_to_noise_db(),
            amplitude_stability_rel: result.amplitude_stability_rel,
        }
    }

    /// The result of a point that needs no more blocks: as many as the settings want are there, or more would
    /// make U no smaller and nothing near the tone needs the time to be told from it.
    pub(super) fn result_if_enough(&mut self, plan: &Plan) -> Option<PointResult> {
        let [blocks, wanted] = [self.gathered.count(), self.settings.blocks.max(2)];
        let fewest = match self.holds {
            true => wanted,
            false => FEWEST_BLOCKS.min(wanted),
        };
        if blocks < fewest {
            return None;
        }
        let mut ratio = self.ratio(plan);
        if blocks >= wanted {
            return Some(self.result_of(plan, PointState::Valid, &ratio));
        }
        let between = ratio.scatter.standard_deviations_of_mean();
        // So few blocks agree by chance: the noise within them says how much of that it is.
        ratio.scatter.at_least(ratio.noise_rel);
        let result = self.result_of(plan, PointState::Valid, &ratio);
        let is_small = |deviation: f32, expanded: f32| {
            deviation.max(FRAC_1_SQRT_2 * result.hum_rel) <= ENOUGH_OF_U * expanded
        };
        // More than that noise between blocks is something slow, which more blocks show.
        let agree = |between: f32, expanded: f32| {
            between <= (CHANCE_OF_NOISE * ratio.noise_rel).max(AGREE_OF_U * expanded)
        };
        let is_enough = ratio.fitted == 0
            && agree(between.0, result.expanded_uncertainty_rel)
            && agree(between.1, result.expanded_uncertainty_phase_rad)
            && result.state == PointState::Valid
            && self.is_steady(&result)
            && is_small(result.repeatability_rel, result.expanded_uncertainty_rel)
            && is_small(
                result.repeatability_phase_rad,
                result.expanded_uncertainty_phase_rad,
            );
        is_enough.then_some(result)
    }

    /// The amplitude keeps to Table 2.
    pub(super) fn is_steady(&self, result: &PointResult) -> bool {
        let most = VibrationGeneration::of(self.settings.example).amplitude_stability_rel;
        result.amplitude_stability_rel <= most
    }

    /// Sensitivity, uncertainty and diagnostics of what was gathered.
    pub(super) fn result(&mut self, plan: &Plan, state: PointState) -> PointResult {
        let ratio = match self.gathered.count() {
            0 | 1 => Ratio::default(),
            _ => self.ratio(plan),
        };
        self.result_of(plan, state, &ratio)
    }

    fn result_of(&mut self, plan: &Plan, state: PointState, ratio: &Ratio) -> PointResult {
        let gathered = self.gathered;
        let mut result = PointResult::refused(plan.spec, Some(plan.tone), Reason::Stopped);
        result.state = state;
        self.describe_drive(plan, &mut result);
        if gathered.count() < 2 {
            return result;
        }
        let sensitivity = self.settings.sensitivity(
            ratio.scatter.mean(),
            &plan.reference,
            plan.spec.frequency_hz,
        );
        let (phase_rad, inverted) = self.polarity.split(sensitivity.arg());
        let (repeatability_rel, repeatability_phase_rad) =
            ratio.scatter.standard_deviations_of_mean();
        result.acceleration_rms_ms2 = gathered.mean_level_peak() * FRAC_1_SQRT_2;
        result.sensitivity_v_per_ms2 = sensitivity.norm();
        result.phase_rad = phase_rad;
        result.inverted = inverted;
        result.repeatability_rel = repeatability_rel;
        result.repeatability_phase_rad = repeatability_phase_rad;
        result.hum_rel = ratio.hum_rel;
        result.dropout_rel = gathered.dropout_rel(self.listening.rest_square());
        result.blocks = gathered.count();
        result.distortion_reference_rel = gathered.distortion_rel(0);
        result.distortion_dut_rel = gathered.distortion_rel(1);
        result.signal_to_noise_reference_db = gathered.signal_to_noise_db(0);
        result.signal_to_noise_dut_db = gathered.signal_to_noise_db(1);
        result.signal_to_noise_worst_block_db = Some(gathered.dut_worst_signal_to_noise_db());
        result.amplitude_stability_rel = ratio.moved_rel;
        self.state_uncertainty(plan, &mut result);
        result
    }

    /// Ratio of the channels, without the mains as far as it can be told from the tone.
    fn ratio(&self, plan: &Plan) -> Ratio {
        let Tone {
            cycles,
            period_samples,
        } = plan.tone;
        let stretches = &self.gathered.stretches;
        let samples =
            self.measuring_block(plan.tone).samples() * u32::from(stretches.blocks_each());
        let (re, im) = PhaseWalk::new(plan.tone, self.measured_from).next_cos_sin();
        let span = Span {
            tone_per_sample: f32::from(cycles) / f32::from(period_samples),
            sample_rate_hz: self.sampling.sample_rate_hz,
            samples,
            start: Complex32::new(re, im),
        };
        let noise_rel = [0, 1].map(|channel| self.gathered.amplitude_noise_rel(channel, samples));
        let hum = self.listening.hum();
        stretches.ratio(hum.as_ref(), &span, noise_rel)
    }

    fn describe_drive(&self, plan: &Plan, result: &mut PointResult) {
        let settling = if self.settling_samples > 0 {
            self.settling_samples
        } else {
            self.elapsed
        };
        let set = plan.level_loop.set_peak_ms2();
        result.acceleration_rms_ms2 = self.last_level_peak_ms2 * FRAC_1_SQRT_2;
        result.drive_peak_v = self.level.drive_peak_v();
        result.settling_s = settling as f32 / self.sampling.sample_rate_hz;
        result.overshoot_rel = (self.level.highest_peak_ms2() / set - 1.0).max(0.0);
    }

    /// Fills in the budget's numbers; a budget that makes no sense refuses.
    fn state_uncertainty(&self, plan: &Plan, result: &mut PointResult) {
        let budget = point_budget(&self.settings, &plan.reference, result);
        match budget.and_then(|budget| budget.expand()) {
            Ok((magnitude, phase)) => {
                result.expanded_uncertainty_rel = magnitude.expanded_uncertainty;
                result.coverage_factor = magnitude.coverage.factor;
                result.effective_degrees_of_freedom = magnitude.effective_degrees_of_freedom;
                result.expanded_uncertainty_phase_rad = phase.expanded_uncertainty;
            }
            Err(_) => result.state = PointState::Refused(Reason::BudgetInvalid),
        }
    }
}
