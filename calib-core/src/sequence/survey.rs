//! The course of a broadband run: level, averages, results.
//!
//! ```text
//!  start     record by record          64 records
//!  -----> approach the level -------> average -------> ramp down -> results
//!             |                          |                          point by
//!             +-- any fault: mute, the reason is every point's -----> point
//! ```
//!
//! # Source
//! ISO 16063-21:2003, 4.4 Note 1 (64 averages, coherence), 5.1 a (level).

use super::sequencer::{Activity, Progress, Sampling};
use crate::broadband::{
    BroadbandDrive, CrossSpectra, Excitation, LEAST_AVERAGES, Phases, RECORD_SAMPLES, Response,
    SpectraMemory, line_frequency_hz, nearest_line, player,
};
use crate::budget::point_budget;
use crate::converter::MID_SAMPLE;
use crate::output::Command;
use crate::point::{ExcitationKind, PointResult, PointSpec};
use crate::point_state::{PointState, Reason};
use crate::polarity::Polarity;
use crate::requirements::VibrationGeneration;
use crate::settings::Settings;
use crate::tone::Tone;

/// First drive, relative to the drive limit.
const PROBE_REL: f32 = 0.005;
/// Most a drive may grow from one record to the next.
const GROWTH: f32 = 10.0;
/// Level reached, relative to the set one: the response is a ratio, the level
/// only has to be the one that is stated.
const LEVEL_TOLERANCE_REL: f32 = 0.05;
/// Records in which the level must be reached: four decades of gain, and as
/// many corrections.
const MOST_APPROACHES: u32 = 12;
/// Drive, relative to the limit, at which a reference must show something:
/// reached by the first growth of the probe.
const ALIVE_AT_REL: f32 = 0.04;
/// R.m.s. codes below which it shows nothing: the converter's own noise.
const DEAD_CODES: f32 = 2.0;
/// Peak over r.m.s. value of motion behind an exciter; noise of this length
/// exceeds 4 once in four records.
const CREST: f32 = 4.0;
/// Records of one random realisation: to ring in, and to be measured.
const SETTLING_SAMPLES: u32 = RECORD_SAMPLES as u32;

/// Request for a broadband run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurveyRequest {
    /// Lowest and highest frequency wanted, Hz.
    pub band_hz: (f32, f32),
    /// Total acceleration of the band, m/s2 r.m.s.
    pub acceleration_rms_ms2: f32,
    /// Multisine or random.
    pub kind: ExcitationKind,
}

/// R.m.s. values of the motion in the band.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Motion {
    acceleration_ms2: f32,
    velocity_ms: f32,
    displacement_m: f32,
    /// Of the reference channel, samples r.m.s.
    samples: f32,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    Idle,
    /// A change of drive is on its way, or rings in.
    Waiting {
        left: u32,
    },
    Recording,
    Silencing {
        left: u32,
    },
}

/// A broadband run; see the module for its course.
pub struct Survey<'m> {
    spectra: CrossSpectra<'m>,
    sampling: Sampling,
    settings: Settings,
    excitation: Excitation,
    random: bool,
    wanted_rms_ms2: f32,
    /// Codes from mid-scale no wanted level can reach.
    overload_codes: f32,
    state: State,
    averaging: bool,
    approaches: u32,
    drive_peak_v: f32,
    motion: Motion,
    clipped: bool,
    fault: Option<Reason>,
    polarity: Polarity,
    command: Command,
    elapsed: u32,
    /// Pairs at hand that no command reaches, at most.
    at_hand: u32,
    settling_samples: u32,
}

impl<'m> Survey<'m> {
    /// A survey at rest.
    pub fn new(memory: &'m mut SpectraMemory, sampling: Sampling, settings: Settings) -> Self {
        Self {
            spectra: CrossSpectra::new(memory),
            sampling,
            settings,
            excitation: Excitation {
                first: 1,
                last: 1,
                phases: Phases::Multisine,
            },
            random: false,
            wanted_rms_ms2: 0.0,
            overload_codes: f32::INFINITY,
            state: State::Idle,
            averaging: false,
            approaches: 0,
            drive_peak_v: 0.0,
            motion: Motion::default(),
            clipped: false,
            fault: None,
            polarity: Polarity::default(),
            command: Command::Mute,
            elapsed: 0,
            at_hand: 0,
            settling_samples: 0,
        }
    }

    /// Begins a run with these settings. A run that cannot be driven ends with
    /// the next call of [`Self::feed`].
    pub fn start(&mut self, settings: Settings, request: SurveyRequest) {
        let rate_hz = self.sampling.sample_rate_hz;
        let (low_hz, high_hz) = request.band_hz;
        self.settings = settings;
        self.settings.limits = self.settings.limits.under_ceilings();
        self.random = request.kind == ExcitationKind::Random;
        self.excitation = Excitation {
            first: nearest_line(low_hz, rate_hz),
            last: nearest_line(high_hz, rate_hz),
            phases: Phases::Multisine,
        };
        self.wanted_rms_ms2 = request.acceleration_rms_ms2;
        self.drive_peak_v = PROBE_REL * self.settings.limits.drive_peak_v;
        (self.averaging, self.clipped) = (false, false);
        (self.approaches, self.elapsed, self.settling_samples) = (0, 0, 0);
        self.at_hand = 0;
        self.motion = Motion::default();
        self.fault = None;
        self.polarity = Polarity::default();
        match self.plan() {
            Ok(overload_codes) => {
                self.overload_codes = overload_codes;
                self.draw(0);
                self.spectra.restart();
                self.drive();
            }
            Err(reason) => self.refuse(reason),
        }
    }

    /// Takes the next pairs, in the order they were sampled and without a gap;
    /// true when the run is over and the exciter silent.
    ///
    /// # Timing
    /// A transform of 4096 points at the end of a record; while the level is
    /// approached, also one interpolation of the reference for each line.
    pub fn feed(&mut self, pairs: &[u32]) -> bool {
        let mut rest = pairs;
        self.at_hand = pairs.len() as u32;
        self.elapsed = self.elapsed.saturating_add(pairs.len() as u32);
        if !matches!(self.state, State::Idle | State::Silencing { .. }) {
            self.guard(pairs);
        }
        loop {
            let taken = match self.state {
                State::Idle => return true,
                State::Waiting { left: 0 } => {
                    self.state = State::Recording;
                    0
                }
                State::Silencing { left: 0 } => {
                    self.state = State::Idle;
                    return true;
                }
                _ if rest.is_empty() => return false,
                State::Waiting { left } => {
                    let taken = left.min(rest.len() as u32);
                    let left = left - taken;
                    self.state = State::Waiting { left };
                    taken as usize
                }
                State::Silencing { left } => {
                    let taken = left.min(rest.len() as u32);
                    let left = left - taken;
                    self.state = State::Silencing { left };
                    taken as usize
                }
                State::Recording => self.record(rest),
            };
            rest = rest.get(taken..).unwrap_or(&[]);
        }
    }

    /// Ends the run with this reason: lost samples, a stop.
    pub fn interrupt(&mut self, reason: Reason) {
        if !matches!(self.state, State::Idle | State::Silencing { .. }) {
            self.refuse(reason);
        }
    }

    /// Command to the exciter now; ask after every [`Self::feed`].
    pub fn command(&self) -> Command {
        self.command
    }

    /// Where the run stands.
    pub fn progress(&self) -> Progress {
        Progress {
            activity: match (self.state, self.averaging) {
                (State::Idle, _) => Activity::Idle,
                (State::Silencing { .. }, _) => Activity::Silencing,
                (_, false) => Activity::Settling,
                (_, true) => Activity::Measuring,
            },
            block: match self.averaging {
                true => self.spectra.averages() as u16,
                false => 0,
            },
            blocks: LEAST_AVERAGES as u16,
            acceleration_rms_ms2: self.motion.acceleration_ms2,
            drive_peak_v: match self.command {
                Command::Mute => 0.0,
                _ => self.drive_peak_v,
            },
        }
    }

    /// Result of a point, once [`Self::feed`] said that the run is over: that
    /// of the line nearest to it.
    pub fn result(&mut self, spec: PointSpec) -> PointResult {
        let line = nearest_line(spec.frequency_hz, self.sampling.sample_rate_hz);
        let tone = Tone {
            cycles: line as u16,
            period_samples: RECORD_SAMPLES as u16,
        };
        let mut result = PointResult::refused(spec, Some(tone), Reason::Stopped);
        result.acceleration_rms_ms2 = self.motion.acceleration_ms2;
        result.drive_peak_v = self.drive_peak_v;
        result.settling_s = self.settling_samples as f32 / self.sampling.sample_rate_hz;
        if let Some(reason) = self.fault {
            result.state = PointState::Refused(reason);
            return result;
        }
        let coherence = self.spectra.coherence(line);
        result.coherence = Some(coherence);
        result.state = match self.spectra.response(line) {
            Ok(response) => self.state(&mut result, line, response),
            Err(error) => PointState::Refused(error.into()),
        };
        result
    }

    /// Fills in sensitivity and uncertainty, and judges the point.
    fn state(&mut self, result: &mut PointResult, line: usize, response: Response) -> PointState {
        let frequency_hz = line_frequency_hz(line, self.sampling.sample_rate_hz);
        let Some(reference) = self.settings.reference.at(frequency_hz) else {
            return PointState::Refused(Reason::FrequencyUnavailable);
        };
        let sensitivity = self
            .settings
            .sensitivity(response.ratio, &reference, frequency_hz);
        result.sensitivity_v_per_ms2 = sensitivity.norm();
        (result.phase_rad, result.inverted) = self.polarity.split(sensitivity.arg());
        result.repeatability_rel = response.standard_uncertainty_rel;
        result.repeatability_phase_rad = response.standard_uncertainty_rel;
        result.blocks = self.spectra.averages() as u16;
        let noise = (1.0 - response.coherence).max(1.0e-9);
        let over_noise_db = 10.0 * libm::log10f(response.coherence / noise);
        result.signal_to_noise_reference_db = over_noise_db;
        result.signal_to_noise_dut_db = over_noise_db;
        let budget = point_budget(&self.settings, &reference, result);
        let Ok((magnitude, phase)) = budget.and_then(|budget| budget.expand()) else {
            return PointState::Refused(Reason::BudgetInvalid);
        };
        result.expanded_uncertainty_rel = magnitude.expanded_uncertainty;
        result.coverage_factor = magnitude.coverage.factor;
        result.effective_degrees_of_freedom = magnitude.effective_degrees_of_freedom;
        result.expanded_uncertainty_phase_rad = phase.expanded_uncertainty;
        let table = VibrationGeneration::of(self.settings.example);
        let off = frequency_hz / result.spec.frequency_hz - 1.0;
        match off.abs() <= table.frequency_rel {
            true => PointState::Valid,
            false => PointState::Refused(Reason::FrequencyDeviation),
        }
    }

    /// Codes of an overload, or why the run cannot be driven.
    fn plan(&self) -> Result<f32, Reason> {
        let limits = &self.settings.limits;
        let rate_hz = self.sampling.sample_rate_hz;
        let ends = [self.excitation.first, self.excitation.last];
        let [Some(low), Some(_)] =
            ends.map(|line| self.settings.reference.at(line_frequency_hz(line, rate_hz)))
        else {
            return Err(Reason::FrequencyUnavailable);
        };
        if self.excitation.first > self.excitation.last {
            return Err(Reason::FrequencyUnavailable);
        }
        let wanted_peak_ms2 = CREST * self.wanted_rms_ms2;
        if !(wanted_peak_ms2 > 0.0 && wanted_peak_ms2 <= limits.acceleration_peak_ms2) {
            return Err(Reason::AccelerationLimit);
        }
        let code_per_ms2 = low.sensitivity_v_per_ms2 / self.settings.reference_input.volt_per_code;
        Ok(limits.acceleration_peak_ms2 * code_per_ms2)
    }

    /// Phases of the next average.
    fn draw(&mut self, seed: u32) {
        self.excitation.phases = match self.random {
            // Odd seeds differ in the generator, which has no zero.
            true => Phases::Random { seed: 2 * seed + 1 },
            false => Phases::Multisine,
        };
    }

    /// Changes the drive and waits until it is in force and has rung in.
    fn drive(&mut self) {
        self.command = Command::PlayBroadband(BroadbandDrive {
            excitation: self.excitation,
            peak_v: self.drive_peak_v,
        });
        let ramp = u32::from(player::RAMP_SAMPLES);
        let left = self.way_samples() + ramp + SETTLING_SAMPLES;
        self.state = State::Waiting { left };
    }

    /// Samples until a command is in force, at most.
    fn way_samples(&self) -> u32 {
        self.at_hand + self.sampling.latency_samples
    }

    /// Mutes at once where the motion exceeds what the exciter may do.
    fn guard(&mut self, pairs: &[u32]) {
        let mut highest = 0;
        let input = self.sampling.input;
        let within = u32::from(input.first_sample()) + 1..u32::from(input.last_sample());
        for pair in pairs {
            let (reference, dut) = (pair & 0xFFFF, pair >> 16);
            highest = highest.max(reference.abs_diff(u32::from(MID_SAMPLE)));
            let at_end = |sample: u32| !within.contains(&sample);
            self.clipped |= at_end(reference) || at_end(dut);
        }
        if highest as f32 > self.overload_codes {
            self.refuse(Reason::Overload);
        }
    }

    fn record(&mut self, pairs: &[u32]) -> usize {
        let taken = self.spectra.push(pairs);
        if self.spectra.is_at_end_of_record() {
            if self.clipped {
                self.refuse(Reason::Clipped);
            } else if self.averaging {
                self.averaged();
            } else {
                self.approached();
            }
        }
        taken
    }

    /// One more average.
    fn averaged(&mut self) {
        let averages = self.spectra.averages();
        if averages >= LEAST_AVERAGES {
            self.motion = self.motion_of_band();
            self.finish();
        } else if self.random {
            self.draw(averages);
            self.drive();
        }
    }

    /// One record nearer to the level.
    fn approached(&mut self) {
        self.motion = self.motion_of_band();
        let limit_v = self.settings.limits.drive_peak_v;
        let ratio = self.wanted_rms_ms2 / self.motion.acceleration_ms2;
        self.approaches += 1;
        let dead_rms = DEAD_CODES * f32::from(self.sampling.input.sample_step());
        let dead = !(self.motion.samples >= dead_rms);
        if dead && self.drive_peak_v >= ALIVE_AT_REL * limit_v {
            return self.refuse(Reason::ReferenceDead);
        }
        if let (false, Err(reason)) = (dead, self.check_motion(ratio)) {
            return self.refuse(reason);
        }
        if !dead && (ratio - 1.0).abs() <= LEVEL_TOLERANCE_REL {
            return self.begin_averaging();
        }
        let wanted_v = self.drive_peak_v * if dead { GROWTH } else { ratio.min(GROWTH) };
        if wanted_v > limit_v && self.drive_peak_v >= limit_v {
            self.refuse(Reason::DriveLimit);
        } else if self.approaches >= MOST_APPROACHES {
            self.refuse(Reason::NotSettled);
        } else {
            self.drive_peak_v = wanted_v.min(limit_v);
            self.spectra.restart();
            self.drive();
        }
    }

    fn begin_averaging(&mut self) {
        self.settling_samples = self.elapsed;
        self.averaging = true;
        self.spectra.restart();
        if self.random {
            self.drive();
        }
    }

    /// Velocity and displacement once the level is reached.
    fn check_motion(&self, ratio: f32) -> Result<(), Reason> {
        let limits = &self.settings.limits;
        let peak = CREST * ratio;
        if peak * self.motion.velocity_ms > limits.velocity_peak_ms {
            Err(Reason::VelocityLimit)
        } else if peak * self.motion.displacement_m > limits.displacement_peak_m {
            Err(Reason::DisplacementLimit)
        } else {
            Ok(())
        }
    }

    /// Sums over the lines of the band.
    fn motion_of_band(&self) -> Motion {
        let mut squares = [0.0_f32; 4];
        for line in self.excitation.first..=self.excitation.last {
            let frequency_hz = line_frequency_hz(line, self.sampling.sample_rate_hz);
            let omega = core::f32::consts::TAU * frequency_hz;
            let Some(reference) = self.settings.reference.at(frequency_hz) else {
                continue;
            };
            let samples = self.spectra.reference_mean_square(line);
            let ms2_per_code = self.settings.reference_input.volt_per_code
                / reference.sensitivity_v_per_ms2
                / self.sampling.aperture.gain(frequency_hz);
            let acceleration = samples * ms2_per_code * ms2_per_code;
            let velocity = acceleration / (omega * omega);
            let seen = [acceleration, velocity, velocity / (omega * omega), samples];
            squares
                .iter_mut()
                .zip(seen)
                .for_each(|(sum, add)| *sum += add);
        }
        let [acceleration_ms2, velocity_ms, displacement_m, samples] = squares.map(libm::sqrtf);
        Motion {
            acceleration_ms2,
            velocity_ms,
            displacement_m,
            samples,
        }
    }

    /// Ends the run with a reason: mute first.
    fn refuse(&mut self, reason: Reason) {
        self.fault = Some(reason);
        self.command = Command::Mute;
        self.state = State::Silencing {
            left: self.way_samples(),
        };
    }

    /// Ends the run with its results: ramp down.
    fn finish(&mut self) {
        self.command = Command::PlayBroadband(BroadbandDrive {
            excitation: self.excitation,
            peak_v: 0.0,
        });
        self.state = State::Silencing {
            left: self.way_samples() + u32::from(player::RAMP_SAMPLES),
        };
    }
}
