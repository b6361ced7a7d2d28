//! The network of a plant in time, with its nonlinear terms and the motion of the base.

use nalgebra::{DMatrix, RowDVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use serde::{Deserialize, Serialize};

use super::bends::{Bends, Instant, Levels};
use super::network::{Network, Signal};
use super::stepper::Stepper;
use super::wiring::{BASE_INPUT, DRIVE_INPUT, FRICTION_INPUT, RATE_INPUT, TERMS, Wiring};
use crate::model::{AmbientMotion, Model, friction};
use crate::rig::Converter;
use crate::rig_port::{Conversions, INPUT_CHANNELS};

/// Non-zero coefficients of a signal over (states, inputs).
type Tap = Vec<(usize, f64)>;

/// Steps in a sample period where there are nonlinear terms. A term that acts at 10 kHz is then
/// 0.8 % short, one at 1 kHz 1e-4.
const STEPS_PER_SAMPLE: u64 = 4;

/// Corrections of each such step.
const CORRECTIONS: usize = 2;

/// Taps that are read at every step.
#[derive(Clone, Debug)]
struct Taps {
    demand: Tap,
    current: Tap,
    velocity: Tap,
    travel: Tap,
    acceleration: Tap,
    faces: [Tap; INPUT_CHANNELS],
    converter: [Tap; INPUT_CHANNELS],
    converter_rate: [Tap; INPUT_CHANNELS],
}

/// Nonlinear terms at work.
#[derive(Clone, Debug)]
struct Nonlinear {
    bends: Bends,
    terms: [f64; TERMS],
    /// Columns of the states that hold them.
    columns: [usize; TERMS],
    step_ns: u64,
    /// Velocity after a step per newton held over it.
    velocity_per_newton: f64,
}

/// The plant in time.
#[derive(Clone, Debug)]
pub(super) struct Simulation {
    stepper: Stepper,
    taps: Taps,
    /// Volts of both converters, and their derivatives, as means over a trigger's conversions.
    volts: PairTap,
    rates: PairTap,
    nonlinear: Option<Box<Nonlinear>>,
    levels: Levels,
    /// Whether anything needs the levels.
    levelled: bool,
    ambient: AmbientMotion,
    ambient_noise: ChaCha8Rng,
    elapsed_ns: u64,
    sample_ns: u64,
    /// Acceleration of a blow, to be felt during the next hold, m/s2.
    blow_ms2: f64,
}

/// All that changes in a simulation while it runs.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Motion {
    /// States, then inputs.
    source: Vec<f64>,
    terms: Option<[f64; TERMS]>,
    levels: Levels,
    /// How far the generator of the ambient motion has come, in words.
    ambient_words: u128,
    elapsed_ns: u64,
    blow_ms2: f64,
}

impl Simulation {
    /// Where it is.
    pub(super) fn motion(&self) -> Motion {
        Motion {
            source: self.stepper.source().to_vec(),
            terms: self.nonlinear.as_ref().map(|nonlinear| nonlinear.terms),
            levels: self.levels,
            ambient_words: self.ambient_noise.get_word_pos(),
            elapsed_ns: self.elapsed_ns,
            blow_ms2: self.blow_ms2,
        }
    }

    /// Goes on from where another of the same model was.
    pub(super) fn go_on(&mut self, motion: Motion) {
        self.stepper.go_on(&motion.source);
        if let (Some(nonlinear), Some(terms)) = (&mut self.nonlinear, motion.terms) {
            nonlinear.terms = terms;
        }
        self.levels = motion.levels;
        self.ambient_noise.set_word_pos(motion.ambient_words);
        self.elapsed_ns = motion.elapsed_ns;
        self.blow_ms2 = motion.blow_ms2;
    }

    pub(super) fn new(model: &Model, converter: &Converter, start_s: f64, seed: u64) -> Self {
        let bends = Bends::of(model, start_s);
        let wiring = Wiring::new(model, converter, start_s, bends.is_some());
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "1 us to 1 ms"
        )]
        let sample_ns = (1e9 / converter.sample_rate_hz).round() as u64;
        let step_ns = sample_ns / STEPS_PER_SAMPLE;
        let tick_ns = if bends.is_some() { step_ns } else { sample_ns };
        let stepper = Stepper::new(wiring.network.matrix(), tick_ns);
        let nonlinear = bends.zip(wiring.terms.as_ref()).map(|(bends, terms)| {
            Box::new(Nonlinear::new(bends, terms, &wiring, &stepper, step_ns))
        });
        let channels = [&model.reference, &model.dut];
        let taps = Taps::new(&wiring);
        Self {
            volts: PairTap::of(&taps.converter),
            rates: PairTap::of(&taps.converter_rate),
            taps,
            stepper,
            levelled: nonlinear.is_some()
                || channels
                    .iter()
                    .any(|channel| channel.level_gain_per_ms2 != 0.0 || channel.range.is_some()),
            nonlinear,
            levels: Levels::default(),
            ambient: model.ambient,
            // Another stream than that of the converters, from the same seed.
            ambient_noise: ChaCha8Rng::seed_from_u64(seed.wrapping_add(0x5EED)),
            elapsed_ns: 0,
            sample_ns,
            blow_ms2: 0.0,
        }
    }

    /// Goes on from where `before` is: the same network, some of its values others.
    pub(super) fn succeed(&mut self, before: &Self) {
        self.stepper.restore(&before.stepper.clone_state());
        if let (Some(nonlinear), Some(before)) = (&mut self.nonlinear, &before.nonlinear) {
            nonlinear.terms = before.terms;
        }
        self.levels = before.levels;
        self.ambient_noise = before.ambient_noise.clone();
        self.elapsed_ns = before.elapsed_ns;
    }

    /// Turns the armature back where it moves outward beyond `travel_m`, with `restitution` of its
    /// velocity; both transducers feel the blow over the next sample period.
    pub(super) fn stop_at(&mut self, travel_m: f64, restitution: f64) {
        let Instant {
            travel_m: at_m,
            velocity_ms,
            ..
        } = self.instant();
        if at_m.abs() < travel_m || at_m * velocity_ms <= 0.0 {
            return;
        }
        // The velocity is a state of its own.
        let Some(&(column, factor)) = self.taps.velocity.first() else {
            return;
        };
        let back_ms = -restitution * velocity_ms;
        self.stepper.set_state(column, back_ms / factor);
        self.blow_ms2 = (back_ms - velocity_ms) / (self.sample_ns as f64 * 1e-9);
    }

    /// Advances by `duration_ns` with the drive constant.
    pub(super) fn hold(&mut self, drive_v: f64, duration_ns: u64) {
        self.stepper.set_input(DRIVE_INPUT, drive_v);
        self.stepper
            .set_input(BASE_INPUT, std::mem::take(&mut self.blow_ms2));
        self.shake();
        match self.nonlinear.take() {
            None => self.stepper.advance(duration_ns),
            Some(mut nonlinear) => {
                self.advance_bent(&mut nonlinear, duration_ns);
                self.nonlinear = Some(nonlinear);
            }
        }
        self.elapsed_ns += duration_ns;
        if self.levelled {
            let instant = self.instant();
            self.levels
                .take(&instant, (duration_ns as f64 * 1e-9).min(0.1));
        }
    }

    /// The base moves on: a tone, and noise that is white up to half the sample rate.
    fn shake(&mut self) {
        let ambient = &self.ambient;
        if *ambient == AmbientMotion::default() {
            return;
        }
        let unit: f64 = StandardNormal.sample(&mut self.ambient_noise);
        // The middle of the hold that begins, so that the steps are not late.
        let time_s = (self.elapsed_ns + self.sample_ns / 2) as f64 * 1e-9;
        let angle = std::f64::consts::TAU * ambient.tone_hz * time_s;
        let tone = std::f64::consts::SQRT_2 * ambient.tone_rms_ms2 * angle.sin();
        self.stepper
            .set_input(BASE_INPUT, ambient.broadband_rms_ms2 * unit + tone);
    }

    fn advance_bent(&mut self, nonlinear: &mut Nonlinear, duration_ns: u64) {
        let steps = duration_ns / nonlinear.step_ns;
        let begun_ns = self.elapsed_ns;
        for step in 0..steps {
            let end_ns = begun_ns + (step + 1) * nonlinear.step_ns;
            self.step_bent(nonlinear, end_ns as f64 * 1e-9);
        }
        // What is left is shorter than a step: the terms stay as they are.
        self.stepper
            .advance(duration_ns - steps * nonlinear.step_ns);
    }

    /// One step with terms that change linearly, predicted and corrected.
    fn step_bent(&mut self, nonlinear: &mut Nonlinear, end_s: f64) {
        let begun = self.stepper.clone_state();
        let step_s = nonlinear.step_ns as f64 * 1e-9;
        let v0 = self.instant().velocity_ms;
        let now = nonlinear.terms;
        let mut end = now;
        for _ in 0..CORRECTIONS {
            self.stepper.restore(&begun);
            for (term, (end, now)) in end.iter().zip(&now).enumerate() {
                self.stepper
                    .set_input(RATE_INPUT + term, (end - now) / step_s);
            }
            let coulomb_n = nonlinear.bends.friction_n();
            if coulomb_n != 0.0 {
                self.stepper.set_input(FRICTION_INPUT, 0.0);
                self.stepper.advance(nonlinear.step_ns);
                let free = self.instant().velocity_ms;
                self.stepper.restore(&begun);
                let rubbed = friction(v0, free, nonlinear.velocity_per_newton, coulomb_n);
                self.stepper.set_input(FRICTION_INPUT, rubbed.mean_n);
            }
            self.stepper.advance(nonlinear.step_ns);
            let mut instant = self.instant();
            instant.elapsed_s = end_s;
            end = nonlinear.bends.terms(&instant, &self.levels);
        }
        for (term, (&column, &value)) in nonlinear.columns.iter().zip(&end).enumerate() {
            self.stepper.set_state(column, value);
            self.stepper.set_input(RATE_INPUT + term, 0.0);
        }
        nonlinear.terms = end;
    }

    /// State the nonlinear terms depend on, at present.
    pub(super) fn instant(&self) -> Instant {
        Instant {
            elapsed_s: self.elapsed_s(),
            demand_v: self.read(&self.taps.demand),
            current_a: self.read(&self.taps.current),
            velocity_ms: self.read(&self.taps.velocity),
            travel_m: self.read(&self.taps.travel),
            faces_ms2: [
                self.read(&self.taps.faces[0]),
                self.read(&self.taps.faces[1]),
            ],
        }
    }

    /// From now on a sample is the mean over `conversions`: the signals at their instants follow from the
    /// present state, the inputs being held, so the mean is a signal of its own.
    pub(super) fn average_over(&mut self, conversions: Conversions) {
        let apart = self.stepper.transition(conversions.apart_ns());
        let count = conversions.count.max(1);
        let mean = |taps: &[Tap; INPUT_CHANNELS]| {
            PairTap::of(&[0, 1].map(|channel| mean_tap(&taps[channel], &apart, count)))
        };
        self.volts = mean(&self.taps.converter);
        self.rates = mean(&self.taps.converter_rate);
    }

    /// Since the start, s.
    pub(super) fn elapsed_s(&self) -> f64 {
        self.elapsed_ns as f64 * 1e-9
    }

    /// Voltage at the coil, V.
    pub(super) fn coil_v(&self) -> f64 {
        let instant = self.instant();
        let beside = self
            .nonlinear
            .as_ref()
            .map_or(0.0, |bent| bent.bends.amplifier_v(&instant, &self.levels));
        instant.demand_v + beside
    }

    /// Acceleration of the table, m/s2.
    pub(super) fn acceleration_ms2(&self) -> f64 {
        self.read(&self.taps.acceleration)
    }

    /// Volts at both input converters.
    pub(super) fn converters_v(&self) -> [f64; INPUT_CHANNELS] {
        self.volts.read(self.stepper.source())
    }

    /// Their derivatives, V/s.
    pub(super) fn converters_v_per_s(&self) -> [f64; INPUT_CHANNELS] {
        self.rates.read(self.stepper.source())
    }

    /// Mean square of the motion of a mounting face, (m/s2)2.
    pub(super) fn face_m2s4(&self, channel: usize) -> f64 {
        self.levels.faces_m2s4[channel]
    }

    fn read(&self, tap: &Tap) -> f64 {
        let source = self.stepper.source();
        tap.iter()
            .map(|&(column, factor)| factor * source[column])
            .sum()
    }
}

/// The taps of both channels, read in one pass.
#[derive(Clone, Debug)]
struct PairTap(Vec<(usize, [f64; INPUT_CHANNELS])>);

impl PairTap {
    /// Each channel's terms stay in the order they have, so that its sum is that of its tap.
    fn of(taps: &[Tap; INPUT_CHANNELS]) -> Self {
        let mut terms: Vec<(usize, [f64; INPUT_CHANNELS])> = Vec::new();
        for (channel, tap) in taps.iter().enumerate() {
            let mut from = 0;
            for &(column, factor) in tap {
                // A term before those this channel has already would change the order.
                let known = terms[from..].iter().position(|term| term.0 == column);
                let place = known.map_or(terms.len(), |place| from + place);
                if known.is_none() {
                    terms.push((column, [0.0; INPUT_CHANNELS]));
                }
                terms[place].1[channel] = factor;
                from = place + 1;
            }
        }
        Self(terms)
    }

    fn read(&self, source: &[f64]) -> [f64; INPUT_CHANNELS] {
        let mut sums = [0.0; INPUT_CHANNELS];
        for &(column, factors) in &self.0 {
            let value = source[column];
            for (sum, factor) in sums.iter_mut().zip(factors) {
                *sum += factor * value;
            }
        }
        sums
    }
}

impl Nonlinear {
    fn new(
        bends: Bends,
        terms: &[Signal; TERMS],
        wiring: &Wiring,
        stepper: &Stepper,
        step_ns: u64,
    ) -> Self {
        let column = |signal: &Signal| {
            wiring
                .network
                .columns(signal)
                .first()
                .map_or(0, |term| term.0)
        };
        // The answer to one newton, from rest.
        let mut probe = stepper.clone();
        probe.set_input(FRICTION_INPUT, 1.0);
        probe.advance(step_ns);
        let velocity = wiring.network.columns(&wiring.velocity);
        let velocity_per_newton = velocity
            .iter()
            .map(|&(column, factor)| factor * probe.source()[column])
            .sum();
        Self {
            bends,
            terms: [0.0; TERMS],
            columns: std::array::from_fn(|term| column(&terms[term])),
            step_ns,
            velocity_per_newton,
        }
    }
}

impl Taps {
    fn new(wiring: &Wiring) -> Self {
        let network = &wiring.network;
        let tap = |signal: &Signal| network.columns(signal);
        let rate = |signal: &Signal| rate(network, signal);
        Self {
            demand: tap(&wiring.demand),
            current: tap(&wiring.current),
            velocity: tap(&wiring.velocity),
            travel: tap(&wiring.travel),
            acceleration: tap(&wiring.acceleration),
            faces: [tap(&wiring.faces[0]), tap(&wiring.faces[1])],
            converter: [tap(&wiring.converter[0]), tap(&wiring.converter[1])],
            converter_rate: [rate(&wiring.converter[0]), rate(&wiring.converter[1])],
        }
    }
}

/// Mean of a signal over `count` instants, the first now and each a `step` of the network further.
fn mean_tap(signal: &Tap, step: &DMatrix<f64>, count: u32) -> Tap {
    if count == 1 {
        return signal.clone();
    }
    let mut row = RowDVector::zeros(step.ncols());
    for &(column, factor) in signal {
        row[column] = factor;
    }
    let mut sum = row.clone();
    for _ in 1..count {
        row *= step;
        sum += &row;
    }
    let mean = sum.iter().map(|factor| factor / f64::from(count));
    mean.enumerate().filter(|entry| entry.1 != 0.0).collect()
}

/// Coefficients of a signal's derivative; the signal depends on states only.
fn rate(network: &Network, signal: &Signal) -> Tap {
    let matrix = network.matrix();
    let mut sums = vec![0.0; matrix.ncols()];
    for (state, factor) in network.columns(signal) {
        for (column, sum) in sums.iter_mut().enumerate() {
            *sum += factor * matrix[(state, column)];
        }
    }
    sums.into_iter()
        .enumerate()
        .filter(|entry| entry.1 != 0.0)
        .collect()
}
