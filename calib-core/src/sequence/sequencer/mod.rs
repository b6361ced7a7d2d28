//! The state machine of a point.

mod gathered;
mod listen;
mod listening;
mod result;

use super::checks::judge;
use crate::aperture::Aperture;
use crate::control::level_loop::OVERLOAD_REL;
use crate::control::{Bend, Level, LevelLoop, LevelState, Next};
use crate::converter::Width;
use crate::correlation::{
    Block, ChannelEstimate, Correlator, Energy, FoldMemory, PairEstimate, SQUARE_STRIDE,
};
use crate::generator::{Drive, ramp_samples};
use crate::output::Command;
use crate::point::{PointResult, PointSpec};
use crate::point_state::{PointState, Reason};
use crate::polarity::Polarity;
use crate::reference::ReferenceSensitivity;
use crate::settings::Settings;
use crate::tone::Tone;
use core::f32::consts::{FRAC_1_SQRT_2, SQRT_2, TAU};
use gathered::Gathered;
use listening::Listening;
use num_complex::Complex32;

/// Shortest measuring block, s: of a point that nothing disturbs, and of any other. The period of 31.5 Hz, three
/// cycles in 4762 samples, is just longer, and is not taken twice.
const QUIET_BLOCK_S: f32 = 0.010;
const MEASURING_BLOCK_S: f32 = 0.095;
/// A point is disturbed by what is at rest at its tone, or by lines of the mains, from this share of the set level on:
/// a fifth of the smallest U.
const QUIET_REL: f32 = 1.5e-3;
/// Standard deviation, relative, that a block of a quiet point has at most: three of them leave a twentieth of U.
const QUIET_NOISE_REL: f32 = 4.0e-4;
/// Longest block of the level loop for noisy signals, s.
const LONGEST_CONTROL_BLOCK_S: f32 = 0.1;
/// Noise of a block, relative to the set level, the level loop likes to see.
const CONTROL_NOISE_REL: f32 = 1.5e-4;
/// A device under test whose tone is not this many times its own noise, or not
/// half a code, shows no signal.
const OPEN_NOISE_FACTOR: f32 = 10.0;
const OPEN_CODES: f32 = 0.5;
/// Level relative to the set one below which the reference has died.
const DEAD_REL: f32 = 0.002;
/// Factors of frequency and level within which an exciter bends alike.
const NEAR_FREQUENCY: f32 = 1.7;
const NEAR_LEVEL: f32 = 1.3;
/// Level relative to the set one below which measuring makes no sense.
const LOST_REL: f32 = 0.5;

/// How the hardware around the sequencer samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Width of both inputs.
    pub input: Width,
    /// Pairs per second.
    pub sample_rate_hz: f32,
    /// Conversions a sample is the mean of.
    pub aperture: Aperture,
    /// Upper bound of the pairs between the end of those handed over with
    /// [`Sequencer::feed`], when [`Sequencer::command`] changed, and the first pair taken
    /// while the generator plays it. Ramps are not counted here.
    pub latency_samples: u32,
    /// Lower bound of the same: so many pairs after the command show the exciter as it was.
    pub rest_samples: u32,
}

/// Phase of the sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Activity {
    /// No point in work.
    Idle,
    /// Approaching the level.
    Settling,
    /// Measuring blocks.
    Measuring,
    /// Ramping down.
    Silencing,
}

/// Where a point stands, for displays.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Progress {
    /// Current phase.
    pub activity: Activity,
    /// Blocks measured.
    pub block: u16,
    /// Blocks wanted.
    pub blocks: u16,
    /// Acceleration of the last block, m/s2 r.m.s.
    pub acceleration_rms_ms2: f32,
    /// Drive, V peak.
    pub drive_peak_v: f32,
}

/// How much the exciter's gain changed between the probe and the set level of a point.
#[derive(Clone, Copy, Debug)]
struct Bent {
    spec: PointSpec,
    bend: f32,
}

impl Bent {
    /// The bend as another point has it: none at another level.
    fn of(&self, spec: &PointSpec) -> Option<Bend> {
        let near = |a: f32, b: f32, factor: f32| a < factor * b && b < factor * a;
        let level = spec.acceleration_rms_ms2;
        near(self.spec.acceleration_rms_ms2, level, NEAR_LEVEL).then_some(Bend {
            log_gain: self.bend,
            near: near(self.spec.frequency_hz, spec.frequency_hz, NEAR_FREQUENCY),
        })
    }
}

/// Everything known of a point before its first sample.
#[derive(Clone, Copy, Debug)]
struct Plan {
    spec: PointSpec,
    tone: Tone,
    reference: ReferenceSensitivity,
    /// Amplitude of the reference, in codes, of 1 m/s2.
    code_per_ms2: f32,
    level_loop: LevelLoop,
    /// Amplitude, in codes, that no wanted level reaches.
    overload_peak: f32,
    /// Angle of the tone per sample, rad.
    angle_rad: f32,
    /// Bound of the sum of a sine of 1 over the places whose squares are summed.
    place_sum: f32,
}

#[derive(Clone, Copy, Debug)]
enum State {
    /// Listening to the mains, as long as nothing is wanted.
    Idle,
    /// Listening to the mains before the exciter is driven.
    Listening,
    /// The first drive is not in the samples yet: what is there at the tone without it.
    Resting {
        /// It is on its way: samples from the end of this block until it is reached.
        driven: Option<u32>,
    },
    /// A change of drive is on its way.
    Waiting,
    Settling,
    Measuring,
    /// The result is delivered when the exciter is silent.
    Silencing {
        left: u32,
        result: PointResult,
    },
}

/// Runs points one after another; see the module for the course of a point.
pub struct Sequencer<'m> {
    correlator: Correlator<'m>,
    sampling: Sampling,
    settings: Settings,
    holds: bool,
    polarity: Polarity,
    plan: Option<Plan>,
    level: LevelState,
    state: State,
    command: Command,
    gathered: Gathered,
    listening: Listening,
    /// Complex amplitudes of both channels at the tone before its first drive, codes; none where they are not known.
    rest: Option<[Complex32; 2]>,
    /// Shape of the measuring blocks; before the level is reached, of short ones that may follow a trim.
    measuring: Option<Block>,
    /// How the exciter bent at the point before.
    bent: Option<Bent>,
    /// Number of the next sample, modulo the period of the tone.
    index: u32,
    /// Its value at the first sample that was measured.
    measured_from: u32,
    /// Samples since the drive began.
    elapsed: u32,
    /// Pairs at hand behind those in work: no command reaches them.
    at_hand: u32,
    /// Samples by which the command that is waited for is late.
    late: u32,
    settling_samples: u32,
    /// Mean of the reference in the last block, codes; none before the first.
    reference_mean: Option<f32>,
    last_level_peak_ms2: f32,
}

impl<'m> Sequencer<'m> {
    /// A sequencer at rest.
    pub fn new(memory: &'m mut FoldMemory, sampling: Sampling, settings: Settings) -> Self {
        let block = listening::block(sampling.sample_rate_hz);
        Self {
            correlator: Correlator::new(memory, sampling.input, block, 0),
            sampling,
            settings,
            holds: false,
            polarity: Polarity::default(),
            plan: None,
            level: LevelState::silent(),
            state: State::Idle,
            command: Command::Mute,
            gathered: Gathered::default(),
            listening: Listening::new(),
            rest: None,
            measuring: None,
            bent: None,
            index: 0,
            measured_from: 0,
            elapsed: 0,
            at_hand: 0,
            late: 0,
            settling_samples: 0,
            reference_mean: None,
            last_level_peak_ms2: 0.0,
        }
    }

    /// Begins a run with these settings; the polarity is open again. With `holds` every point takes all of its
    /// blocks, whether its result needs them or not.
    pub fn start_run(&mut self, settings: Settings, holds: bool) {
        self.settings = settings;
        self.holds = holds;
        self.polarity = Polarity::default();
        self.bent = None;
        if !matches!(self.state, State::Idle) {
            self.rest();
        }
        self.command = Command::Mute;
    }

    /// Begins a point. A point that cannot be driven is refused by the next
    /// call of [`Self::feed`].
    pub fn start_point(&mut self, spec: PointSpec) {
        self.gathered = Gathered::default();
        self.index = 0;
        self.elapsed = 0;
        self.at_hand = 0;
        self.settling_samples = 0;
        self.reference_mean = None;
        self.rest = None;
        self.measuring = None;
        self.last_level_peak_ms2 = 0.0;
        match self.plan(spec) {
            Ok(plan) => {
                self.plan = Some(plan);
                let bend = self.bent.and_then(|bent| bent.of(&spec));
                self.level = plan.level_loop.start(bend);
                if self.must_listen(&plan) {
                    self.state = State::Listening;
                } else {
                    self.begin_driving();
                }
            }
            Err((tone, reason)) => {
                self.plan = None;
                self.level = LevelState::silent();
                let result = PointResult::refused(spec, tone, reason);
                self.state = State::Silencing { left: 0, result };
            }
        }
    }

    /// Takes the next pairs, in the order they were sampled and without a gap;
    /// returns the result when the point is over and the exciter silent.
    ///
    /// # Timing
    /// The correlation's cost per pair, and once per block that of its
    /// evaluation: see [`Correlator`].
    pub fn feed(&mut self, pairs: &[u32]) -> Option<PointResult> {
        let mut rest = pairs;
        self.listening.pass(pairs.len());
        loop {
            match self.state {
                State::Idle | State::Listening if rest.is_empty() => return None,
                State::Idle | State::Listening => rest = self.listen(rest),
                State::Silencing { left, result } => {
                    let taken = left.min(rest.len() as u32);
                    if taken == left {
                        self.rest();
                        return Some(result);
                    }
                    let left = left - taken;
                    self.state = State::Silencing { left, result };
                    return None;
                }
                _ if rest.is_empty() => {
                    self.at_hand = 0;
                    self.drive_in_time();
                    return None;
                }
                _ => rest = self.correlate(rest),
            }
        }
    }

    /// Ends the point in work with this reason: lost samples, a stop.
    pub fn interrupt(&mut self, reason: Reason) {
        if matches!(self.state, State::Idle) {
            self.rest();
        }
        if !matches!(self.state, State::Idle | State::Silencing { .. }) {
            self.refuse(reason);
        }
    }

    /// The hardware's way from a command to the samples is now another.
    pub fn set_latency(&mut self, latency_samples: u32, rest_samples: u32) {
        self.sampling.latency_samples = latency_samples;
        self.sampling.rest_samples = rest_samples;
    }

    /// The last command is played so many samples later than [`Sampling::latency_samples`] says.
    pub fn postpone(&mut self, samples: u32) {
        match &mut self.state {
            State::Waiting => self.late += samples,
            State::Resting { driven: Some(left) } | State::Silencing { left, .. } => {
                *left += samples;
            }
            _ => {}
        }
    }

    /// Command to the exciter now; ask after every [`Self::feed`].
    pub fn command(&self) -> Command {
        self.command
    }

    /// Where the point stands.
    pub fn progress(&self) -> Progress {
        Progress {
            activity: match self.state {
                State::Idle => Activity::Idle,
                State::Listening | State::Resting { .. } | State::Waiting | State::Settling => {
                    Activity::Settling
                }
                State::Measuring => Activity::Measuring,
                State::Silencing { .. } => Activity::Silencing,
            },
            block: self.gathered.count(),
            blocks: self.settings.blocks,
            acceleration_rms_ms2: self.last_level_peak_ms2 * FRAC_1_SQRT_2,
            drive_peak_v: match self.command {
                Command::Play(drive) => drive.peak_v,
                Command::PlayBroadband(_) | Command::Mute => 0.0,
            },
        }
    }

    /// Tone, reference and loop of a point, or why there are none.
    fn plan(&self, spec: PointSpec) -> Result<Plan, (Option<Tone>, Reason)> {
        let rate_hz = self.sampling.sample_rate_hz;
        let tone = Tone::nearest(spec.frequency_hz, rate_hz)
            .ok_or((None, Reason::FrequencyUnavailable))?;
        let refuse = |reason| (Some(tone), reason);
        let frequency_hz = tone.frequency_hz(rate_hz);
        let reference = self
            .settings
            .reference
            .at(frequency_hz)
            .ok_or(refuse(Reason::FrequencyUnavailable))?;
        let set_peak_ms2 = spec.acceleration_rms_ms2 * SQRT_2;
        let level_loop =
            LevelLoop::new(&self.settings.limits, frequency_hz, set_peak_ms2).map_err(refuse)?;
        let code_per_ms2 = reference.sensitivity_v_per_ms2
            / self.settings.reference_input.volt_per_code
            * self.sampling.aperture.gain(frequency_hz);
        let angle_rad = TAU * frequency_hz / rate_hz;
        let half_step_rad = 0.5 * SQUARE_STRIDE as f32 * angle_rad;
        Ok(Plan {
            spec,
            tone,
            reference,
            code_per_ms2,
            level_loop,
            overload_peak: OVERLOAD_REL * set_peak_ms2 * code_per_ms2,
            angle_rad,
            place_sum: 2.0 / libm::sinf(half_step_rad).abs(),
        })
    }

    /// Feeds the correlator; at the end of a block, decides what follows.
    fn correlate<'p>(&mut self, pairs: &'p [u32]) -> &'p [u32] {
        let before = self.correlator.energy();
        let taken = self.correlator.push(pairs);
        let energy = self.correlator.energy().since(before);
        let period = u32::from(self.correlator.block().tone().period_samples);
        self.index = (self.index + taken as u32) % period;
        self.elapsed = self.elapsed.saturating_add(taken as u32);
        self.at_hand = (pairs.len() - taken) as u32;
        if self.overloaded(energy, taken) {
            self.refuse(Reason::Overload);
        } else if self.correlator.is_complete() {
            self.block_ended();
        }
        pairs.get(taken..).unwrap_or(&[])
    }

    /// True when a stretch of at least 5 ms has more energy than the set level
    /// allows at any place of a cycle: stops a runaway before its block ends.
    ///
    /// # Equation
    /// The mean of `A^2 sin^2` over an angle `b` is at most
    /// `A^2/2 (1 + min(1, 1/b))`, wherever it begins. Of places that happen to
    /// be all at the crest it is `A^2`, still below the bound at 1.06 times the
    /// set level.
    ///
    /// An offset `m` adds `m^2 + 2 m A mean(sin)`, and part of a cycle has a mean:
    /// over `n` places an angle `t` apart at most `1 / (n sin(t/2))`, twice that
    /// where the fold begins anew between them, and 1.
    fn overloaded(&self, energy: Energy, taken: usize) -> bool {
        let long_enough = taken as f32 >= 0.005 * self.sampling.sample_rate_hz;
        match (self.plan, self.reference_mean) {
            (Some(plan), Some(mean)) if long_enough => {
                let place = 1.0 + (1.0 / (plan.angle_rad * taken as f32)).min(1.0);
                let sine_mean = (plan.place_sum / energy.samples as f32).min(1.0);
                let peak = plan.overload_peak;
                let by_offset = mean * mean + 2.0 * mean.abs() * peak * sine_mean;
                energy.mean_square(0) > by_offset + 0.5 * place * peak * peak
            }
            _ => false,
        }
    }

    fn block_ended(&mut self) {
        let Some(plan) = self.plan else { return };
        if matches!(self.state, State::Waiting) {
            // What was waited for tells nothing, and evaluating it takes time.
            if self.late > 0 {
                let late = core::mem::take(&mut self.late);
                return self.wait_for(plan.tone, late);
            }
            return self.settle(self.behind_drive(plan.tone));
        }
        let Some(estimate) = self.correlator.estimate() else {
            return;
        };
        match self.state {
            State::Resting { driven } => self.rested(&plan, &estimate, driven),
            State::Settling => self.control(&plan, &estimate),
            State::Measuring => self.measure(&plan, &estimate),
            State::Waiting | State::Idle | State::Listening | State::Silencing { .. } => {}
        }
    }

    /// Begins a block of the level loop.
    fn settle(&mut self, block: Block) {
        self.state = State::Settling;
        self.correlator.start(block, self.index);
    }

    /// Changes the drive and waits until it is in force.
    fn drive(&mut self, tone: Tone, peak_v: f32) {
        self.command = Command::Play(Drive { tone, peak_v });
        self.wait_for(tone, self.way_samples(tone));
    }

    /// Waits for so many samples until a drive is in force.
    fn wait_for(&mut self, tone: Tone, samples: u32) {
        self.late = 0;
        self.state = State::Waiting;
        self.correlator
            .start(Block::discard(tone, samples), self.index);
    }

    /// Samples from now until a command is in force to the end of its ramp.
    fn way_samples(&self, tone: Tone) -> u32 {
        self.at_hand + self.sampling.latency_samples + u32::from(ramp_samples(tone))
    }

    /// One step of the level loop.
    fn control(&mut self, plan: &Plan, estimate: &PairEstimate) {
        let level = self.level_of(plan, estimate);
        if estimate.reference.clipped {
            return self.refuse(Reason::Clipped);
        }
        match plan.level_loop.step(&mut self.level, level) {
            Next::Hold if self.level.may_ring() => self.settle(self.first_block(plan.tone)),
            Next::Hold => self.settle(self.control_block(plan, level, estimate)),
            Next::Drive(peak_v) => {
                self.measuring = self.quiet_block(plan, estimate);
                self.drive(plan.tone, peak_v);
            }
            Next::Settled => self.settled(plan, level, estimate),
            Next::Failed(reason) => self.refuse(reason),
        }
    }

    /// Keeps what the next point may go by, and measures: a block behind a trim is the first of those that do.
    fn settled(&mut self, plan: &Plan, level: Level, estimate: &PairEstimate) {
        let measures = self.level.is_trimmed() && self.measuring == Some(estimate.block);
        let measured = if measures {
            estimate.block.samples()
        } else {
            0
        };
        self.settling_samples = self.elapsed.saturating_sub(measured);
        let bend = self.level.bend(level.peak_ms2);
        self.bent = bend.map(|bend| Bent {
            spec: plan.spec,
            bend,
        });
        if measures {
            self.state = State::Measuring;
            self.measured_from = self.correlator.start_index();
            return self.measure(plan, estimate);
        }
        let quiet = self.quiet_block(plan, estimate);
        self.measuring = Some(quiet.unwrap_or(self.long_block(plan.tone)));
        self.begin_measuring(plan.tone);
    }

    /// The first block behind a drive: behind a trim, one that measures where that is short.
    fn behind_drive(&self, tone: Tone) -> Block {
        let measuring = self.measuring.filter(|_| self.level.is_trimmed());
        measuring.unwrap_or(self.first_block(tone))
    }

    /// The first blocks behind a drive: with a ramp, two of them fit into two buffers.
    fn first_block(&self, tone: Tone) -> Block {
        let buffers = 2 * self.sampling.rest_samples;
        let most = buffers.saturating_sub(u32::from(ramp_samples(tone)) + 2) / 2;
        Block::control_within(tone, most).unwrap_or(Block::control(tone))
    }

    /// The block the loop needs for its noise: the usual one, or one long
    /// enough for a noise of 0.015 % of the set level, up to 0.1 s.
    fn control_block(&self, plan: &Plan, level: Level, estimate: &PairEstimate) -> Block {
        let excess = level.noise_ms2 / (CONTROL_NOISE_REL * plan.level_loop.set_peak_ms2());
        let wanted = excess * excess * estimate.block.samples() as f32;
        let longest = LONGEST_CONTROL_BLOCK_S * self.sampling.sample_rate_hz;
        Block::control_of(plan.tone, wanted.min(longest) as u32)
    }

    fn begin_measuring(&mut self, tone: Tone) {
        self.state = State::Measuring;
        if self.gathered.count() == 0 {
            self.measured_from = self.index;
        }
        let block = self.measuring_block(tone);
        self.correlator.start(block, self.index);
    }

    fn measuring_block(&self, tone: Tone) -> Block {
        self.measuring.unwrap_or(Block::measuring(tone, 1))
    }

    /// The measuring block where something may be beside the tone.
    fn long_block(&self, tone: Tone) -> Block {
        let long = MEASURING_BLOCK_S * self.sampling.sample_rate_hz;
        Block::measuring(tone, long as u32)
    }

    fn measures_short(&self, tone: Tone) -> bool {
        let long = self.long_block(tone).samples();
        self.measuring.is_some_and(|block| block.samples() < long)
    }

    /// The measuring block for what this one shows, as short as its noise allows; none where something is beside the
    /// tone, and where the point is held.
    fn quiet_block(&self, plan: &Plan, estimate: &PairEstimate) -> Option<Block> {
        let rate_hz = self.sampling.sample_rate_hz;
        let for_noise = self.noise_rel(estimate) / QUIET_NOISE_REL;
        let block_s = (for_noise * for_noise / rate_hz).max(QUIET_BLOCK_S);
        let is_quiet = !self.holds && block_s < MEASURING_BLOCK_S && self.is_undisturbed(estimate);
        is_quiet.then(|| Block::control_of(plan.tone, (block_s * rate_hz) as u32))
    }

    /// Standard deviation of the noisier channel's amplitude by one sample, relative.
    fn noise_rel(&self, estimate: &PairEstimate) -> f32 {
        let of = |seen: &ChannelEstimate| seen.amplitude_noise(1) / seen.amplitude_peak();
        of(&estimate.reference).max(of(&estimate.dut))
    }

    /// Whether neither the mains nor what was there at rest reaches the ratio of the channels.
    ///
    /// A motion that was there at rest, or still rang then, is in both channels alike and leaves their ratio.
    fn is_undisturbed(&self, estimate: &PairEstimate) -> bool {
        let channels = [&estimate.reference, &estimate.dut];
        let apart = self.rest.map(|[reference, dut]| {
            let beside = dut / estimate.dut.amplitude - reference / estimate.reference.amplitude;
            beside.norm()
        });
        let mut lines = channels.iter().enumerate().map(|(channel, seen)| {
            self.listening.largest_line_peak(channel) / seen.amplitude_peak()
        });
        apart.is_some_and(|apart| apart <= QUIET_REL) && lines.all(|line| line <= QUIET_REL)
    }

    /// Takes a measured block, or goes back to the level it shows to be another.
    fn measure(&mut self, plan: &Plan, estimate: &PairEstimate) {
        let level = self.level_of(plan, estimate);
        let unconfirmed = self.gathered.count() == 0 && !self.level.is_trimmed();
        let next = match self.lost(plan, level, estimate) {
            Some(reason) => Next::Failed(reason),
            None if unconfirmed => plan.level_loop.confirm(&mut self.level, level),
            None => Next::Settled,
        };
        match next {
            Next::Failed(reason) => self.refuse(reason),
            Next::Drive(peak_v) => self.drive(plan.tone, peak_v),
            Next::Hold | Next::Settled => self.gather(plan, level, estimate),
        }
    }

    /// Why a block can be no part of a result.
    fn lost(&self, plan: &Plan, level: Level, estimate: &PairEstimate) -> Option<Reason> {
        let level_rel = level.peak_ms2 / plan.level_loop.set_peak_ms2();
        let dut = &estimate.dut;
        let noise = dut.amplitude_noise(estimate.block.samples());
        let open_peak = OPEN_CODES * f32::from(self.sampling.input.sample_step());
        let open = dut.amplitude_peak() < (OPEN_NOISE_FACTOR * noise).max(open_peak);
        match level_rel {
            above if above > OVERLOAD_REL => Some(Reason::Overload),
            nothing if nothing < DEAD_REL => Some(Reason::ReferenceDead),
            half if half < LOST_REL => Some(Reason::AmplitudeUnstable),
            _ => open.then_some(Reason::DutOpen),
        }
    }

    /// Adds a block, and ends the point or begins another.
    fn gather(&mut self, plan: &Plan, level: Level, estimate: &PairEstimate) {
        self.gathered
            .add(level.peak_ms2, estimate, self.settings.blocks);
        match self.result_if_enough(plan) {
            // What beats with a short block beats less with a long one.
            Some(result) if !self.is_steady(&result) && self.measures_short(plan.tone) => {
                self.gathered = Gathered::default();
                self.measuring = Some(self.long_block(plan.tone));
                self.begin_measuring(plan.tone);
            }
            Some(result) => self.finish(plan, result),
            None => self.begin_measuring(plan.tone),
        }
    }

    /// Acceleration by the reference in this block.
    fn level_of(&mut self, plan: &Plan, estimate: &PairEstimate) -> Level {
        self.reference_mean = Some(estimate.reference.mean);
        let ms2_per_code = 1.0 / plan.code_per_ms2;
        let reference = &estimate.reference;
        let noise_codes = reference.amplitude_noise(estimate.block.samples());
        self.last_level_peak_ms2 = reference.amplitude_peak() * ms2_per_code;
        Level {
            peak_ms2: self.last_level_peak_ms2,
            noise_ms2: noise_codes * ms2_per_code,
        }
    }

    /// Ends the point with a reason: mute first.
    fn refuse(&mut self, reason: Reason) {
        let Some(plan) = self.plan else { return };
        let result = self.result(&plan, PointState::Refused(reason));
        self.command = Command::Mute;
        self.end(&plan, result);
    }

    /// Ends the point with its result: ramp down.
    fn finish(&mut self, plan: &Plan, mut result: PointResult) {
        // It may have no budget.
        if result.state == PointState::Valid {
            let measured = self.measured(plan, &result);
            result.state = judge(self.settings.example, &measured);
        }
        self.command = Command::Play(Drive {
            tone: plan.tone,
            peak_v: 0.0,
        });
        self.end(plan, result);
    }

    fn end(&mut self, plan: &Plan, result: PointResult) {
        let left = self.way_samples(plan.tone);
        self.state = State::Silencing { left, result };
    }
}
