//! Actions on an oscillator beside ISO 16063-43 formula (1).

use super::active::ActiveEffect;
use super::effect::{Effect, Library};
use crate::oscillator::Oscillator;
use calib_effects::oscillator;

/// Action of an effect on an oscillator; values are in the order of its parameters.
pub type OscillatorAction = fn(&[f64], &mut Oscillator);

/// An effect of an oscillator.
pub type OscillatorEffect = Effect<OscillatorAction>;

static EFFECTS: [OscillatorEffect; 16] = [
    Effect::new(&oscillator::COULOMB_FRICTION, |values, oscillator| {
        oscillator.friction += values[0];
    }),
    Effect::new(&oscillator::CUBIC_DAMPING, |values, oscillator| {
        oscillator.cubic_damping += values[0];
    }),
    Effect::new(&oscillator::CUBIC_STIFFNESS, |values, oscillator| {
        oscillator.cubic_stiffness += values[0];
    }),
    Effect::new(&oscillator::DEAD_ZONE, |values, oscillator| {
        oscillator.dead_zone += values[0];
    }),
    Effect::new(&oscillator::HYSTERESIS, |values, oscillator| {
        oscillator.hysteresis = values[0];
        oscillator.yield_deflection = values[1];
    }),
    Effect::new(&oscillator::INPUT_DELAY, |values, oscillator| {
        oscillator.input_delay_s += values[0];
    }),
    Effect::new(&oscillator::INPUT_OFFSET, |values, oscillator| {
        oscillator.input_offset += values[0];
    }),
    Effect::new(&oscillator::INPUT_SATURATION, |values, oscillator| {
        oscillator.input_threshold = oscillator.input_threshold.min(values[0]);
    }),
    Effect::new(&oscillator::OUTPUT_CLIPPING, |values, oscillator| {
        oscillator.output_threshold = oscillator.output_threshold.min(values[0]);
    }),
    Effect::new(&oscillator::OUTPUT_HIGHPASS, |values, oscillator| {
        oscillator.output_corner_hz = values[0];
    }),
    Effect::new(&oscillator::OUTPUT_LOWPASS, |values, oscillator| {
        oscillator.output_lowpass_hz = values[0];
    }),
    Effect::new(&oscillator::OUTPUT_TREND, |values, oscillator| {
        oscillator.output_drift_per_s += values[0];
    }),
    Effect::new(&oscillator::QUADRATIC_DAMPING, |values, oscillator| {
        oscillator.quadratic_damping += values[0];
    }),
    Effect::new(&oscillator::QUADRATIC_STIFFNESS, |values, oscillator| {
        oscillator.quadratic_stiffness += values[0];
    }),
    Effect::new(&oscillator::RESONANCE_DRIFT, |values, oscillator| {
        oscillator.resonance_drift_per_s += values[0];
    }),
    Effect::new(&oscillator::SECOND_MODE, |values, oscillator| {
        oscillator.second_gain = values[0];
        oscillator.second_hz = values[1];
        oscillator.second_damping = values[2];
    }),
];

impl Library for OscillatorAction {
    const OF: calib_effects::Of = calib_effects::Of::Oscillator;

    fn effects() -> &'static [Effect<Self>] {
        &EFFECTS
    }
}

impl ActiveEffect<OscillatorAction> {
    /// Changes `oscillator` as the effect does.
    pub fn apply_to(&self, oscillator: &mut Oscillator) {
        (self.effect.apply)(&self.values, oscillator);
    }
}
