//! The runs of a check, one after another, while the coil warms and cools.
//!
//! ```text
//! bare: shunt, divider | mass at 0: shunt, divider | at 120: the same | at 240: the same | bare: shunt, divider
//! ```

use std::f64::consts::SQRT_2;

use nalgebra::Complex;
use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;
use rand_distr::{ChiSquared, Distribution as _, StandardNormal};

use super::distributions as table;
use super::draw::SelfCheckDraw;
use super::response;
use crate::model::CoilInput;

/// The runs: mounting of the mass, and what the device's input reads.
pub const RUNS: [(Option<usize>, CoilInput); 10] = [
    (None, CoilInput::Shunt),
    (None, CoilInput::Divider),
    (Some(0), CoilInput::Shunt),
    (Some(0), CoilInput::Divider),
    (Some(1), CoilInput::Shunt),
    (Some(1), CoilInput::Divider),
    (Some(2), CoilInput::Shunt),
    (Some(2), CoilInput::Divider),
    (None, CoilInput::Shunt),
    (None, CoilInput::Divider),
];

/// A frequency with the levels of both loads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Without the mass, m/s2 r.m.s.
    pub bare_rms_ms2: f64,
    /// With it, m/s2 r.m.s.
    pub loaded_rms_ms2: f64,
}

/// How a check is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The list, of each load.
    pub levels: Vec<Level>,
    /// Time from tone to tone, s.
    pub tone_s: f64,
    /// Blocks of a tone.
    pub blocks: u16,
    /// Samples of a tone.
    pub samples: f64,
}

/// A ratio as an instrument states it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Device's input over the reference's, V/V.
    pub ratio: Complex<f64>,
    /// Standard deviation of the mean over the blocks, relative, of either part.
    pub scatter_rel: f64,
    /// Acceleration of the table, m/s2 r.m.s.
    pub acceleration_rms_ms2: f64,
}

/// Knots of the error of a converter, an octave apart, the first at 2^-12 V.
const KNOTS: usize = 16;
const FIRST_OCTAVE: f64 = -12.0;

/// Error of a channel by its level: a straight line between octaves.
struct Converter([f64; KNOTS]);

impl Converter {
    fn new(random: &mut ChaCha12Rng) -> Self {
        Self(std::array::from_fn(|_| table::READING_ERROR.draw(random)))
    }

    fn error_rel(&self, peak_v: f64) -> f64 {
        let place = (peak_v.log2() - FIRST_OCTAVE).clamp(0.0, (KNOTS - 1) as f64 - 1e-9);
        let (knot, part) = (place.floor(), place.fract());
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "0 to 14"
        )]
        let knot = knot as usize;
        self.0[knot] * (1.0 - part) + self.0[knot + 1] * part
    }
}

/// State of the coil between tones.
struct Coil<'a> {
    draw: &'a SelfCheckDraw,
    elapsed_s: f64,
    warmer_k: f64,
}

impl Coil<'_> {
    fn rest(&mut self, duration_s: f64, power_w: f64) {
        let warming = &self.draw.warming;
        let end_k = warming.kelvin_per_w * power_w;
        let left = (-duration_s / warming.time_constant_s).exp();
        self.warmer_k = end_k + (self.warmer_k - end_k) * left;
        self.elapsed_s += duration_s;
    }

    fn above_cold_k(&self) -> f64 {
        self.warmer_k + self.draw.warming.body_k_per_s * self.elapsed_s
    }
}

/// Measures all runs; `day` as in [`SelfCheckDraw::on_another_day`] makes other noise.
pub fn measure(draw: &SelfCheckDraw, plan: &Plan, day: u64) -> Vec<Vec<Reading>> {
    // What the converters are stays from day to day, noise does not.
    let mut unit = ChaCha12Rng::seed_from_u64(draw.seed().wrapping_mul(31) + 7);
    let converters = [Converter::new(&mut unit), Converter::new(&mut unit)];
    let mut random = ChaCha12Rng::seed_from_u64(draw.seed() ^ (day + 1).rotate_left(20));
    let mut coil = Coil {
        draw,
        elapsed_s: 0.0,
        warmer_k: 0.0,
    };
    let mut runs = Vec::with_capacity(RUNS.len());
    for (place, (mounting, input)) in RUNS.into_iter().enumerate() {
        let swapped = place % 2 == 1;
        let pause = if swapped {
            &table::SWAP_S
        } else {
            &table::PAUSE_S
        };
        coil.rest(pause.draw(&mut random), 0.0);
        let tone = |level: &Level| {
            tone(
                &mut coil,
                plan,
                (mounting, input),
                level,
                &converters,
                &mut random,
            )
        };
        runs.push(plan.levels.iter().filter_map(tone).collect());
    }
    runs
}

fn tone(
    coil: &mut Coil<'_>,
    plan: &Plan,
    (mounting, input): (Option<usize>, CoilInput),
    level: &Level,
    converters: &[Converter; 2],
    random: &mut ChaCha12Rng,
) -> Option<Reading> {
    let draw = coil.draw;
    let acceleration_rms_ms2 = match mounting {
        None => level.bare_rms_ms2,
        Some(_) => level.loaded_rms_ms2,
    };
    let hold_a = mounting.map_or(0.0, |_| draw.hold_a());
    let rig = draw.loaded(mounting, input, coil.above_cold_k());
    let before = response::motion(&rig, level.frequency_hz, acceleration_rms_ms2)?;
    let resistance_ohm = rig.exciter.coil_resistance_ohm;
    let square_a2 = before.current_a.norm_sqr() / 2.0 + hold_a * hold_a;
    coil.rest(plan.tone_s / 2.0, square_a2 * resistance_ohm);
    let rig = draw.loaded(mounting, input, coil.above_cold_k());
    let at = response::motion(&rig, level.frequency_hz, acceleration_rms_ms2)?;
    coil.rest(plan.tone_s / 2.0, square_a2 * resistance_ohm);
    let reading = &draw.reading;
    let [reference_v, device_v] = at.inputs_v;
    let [reference_v, device_v] = [
        reference_v + device_v * reading.crosstalk,
        device_v + reference_v * reading.crosstalk,
    ];
    let peaks = [reference_v.norm(), device_v.norm()];
    let noise_v = reading.noise_rms_v * (2.0 / plan.samples).sqrt();
    let floor = reading.floor_rms_ms2 * SQRT_2 / (SQRT_2 * acceleration_rms_ms2);
    let parts = [noise_v / peaks[0], noise_v / peaks[1], floor / SQRT_2];
    let scatter = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    let mut unit = || -> f64 { StandardNormal.sample(random) };
    let noise = Complex::new(1.0 + scatter * unit(), scatter * unit());
    let linearity = converters[1].error_rel(peaks[1]) - converters[0].error_rel(peaks[0]);
    let temperature = 1.0 + draw.temperature_error_rel;
    let gain = (1.0 + reading.ratio_error_rel + linearity) / temperature;
    let freedom = f64::from(plan.blocks.saturating_sub(1).max(1));
    let spread = ChiSquared::new(freedom).map_or(1.0, |chi| (chi.sample(random) / freedom).sqrt());
    Some(Reading {
        frequency_hz: level.frequency_hz,
        ratio: device_v / reference_v * gain * noise,
        scatter_rel: scatter * spread,
        acceleration_rms_ms2,
    })
}
