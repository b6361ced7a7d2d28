//! What real oscillators do beside ISO 16063-43 formula (1): one file per effect.
//!
//! Amplitudes are in the unit of the output, which is whatever the record states.

mod coulomb_friction;
mod cubic_damping;
mod cubic_stiffness;
mod dead_zone;
mod hysteresis;
mod input_delay;
mod input_saturation;
mod output_highpass;
mod quadratic_damping;
mod quadratic_stiffness;
mod second_mode;

use super::{Effect, Library};
use crate::oscillator::Oscillator;

/// What an effect does to an oscillator; values are in the order of its parameters.
pub type OscillatorAction = fn(&[f64], &mut Oscillator);

/// An effect of an oscillator.
pub type OscillatorEffect = Effect<OscillatorAction>;

/// All effects of an oscillator, by name.
pub static OSCILLATOR_EFFECTS: [OscillatorEffect; 11] = [
    coulomb_friction::EFFECT,
    cubic_damping::EFFECT,
    cubic_stiffness::EFFECT,
    dead_zone::EFFECT,
    hysteresis::EFFECT,
    input_delay::EFFECT,
    input_saturation::EFFECT,
    output_highpass::EFFECT,
    quadratic_damping::EFFECT,
    quadratic_stiffness::EFFECT,
    second_mode::EFFECT,
];

impl Library for OscillatorAction {
    fn effects() -> &'static [Effect<Self>] {
        &OSCILLATOR_EFFECTS
    }
}
