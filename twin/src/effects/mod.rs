//! What a real calibrator does and the nominal simulation leaves out: one file per effect.
//!
//! An effect changes the [`Model`] it is applied to, nothing else. It acts at one place of the
//! physics, so what it does to every observable follows and is not stated here. Names and parameters
//! are shared with whoever explains measured data; equations are not.

mod active;
mod adc_clipping;
mod adc_cubic;
mod adc_dead_zone;
mod adc_quadratic;
mod ambient_vibration;
mod amplifier_clipping;
mod amplifier_even_order;
mod amplifier_gain_drift;
mod armature_mode;
mod averaging_window;
mod back_emf;
mod base_strain;
mod channel_skew;
mod clock_offset;
mod coil_heating;
mod coulomb_friction;
mod crosstalk;
mod dut_drift;
mod dut_frequency_slope;
mod dut_gain;
mod dut_highpass;
mod dut_level_nonlinearity;
mod dut_lowpass_1;
mod dut_lowpass_2;
mod dut_resonance;
mod dut_temperature;
pub mod fault;
mod force_factor_droop;
mod gravity_tilt;
mod loose_mount;
mod lossy_inductance;
mod mains_pickup;
mod mechanical_damping;
mod mount_compliance;
pub mod oscillator;
mod payload_mass;
mod reference_drift;
mod reference_gain;
mod reference_highpass;
mod reference_resonance;
mod reference_temperature;
mod relative_motion;
mod sampling_jitter;
mod suspension_asymmetry;
mod suspension_cubic;
mod transverse_motion;

use crate::model::{Channel, Conditions, Model};

pub use self::active::{ActiveEffect, EffectError};

/// Part of the measuring chain in which an effect sits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Device under test.
    Dut,
    /// Reference transducer.
    Reference,
    /// Between table and transducers.
    Mount,
    /// Amplifiers and filters between transducer and converter.
    Conditioning,
    /// Converter and its clock.
    Digitiser,
    /// Moving coil and suspension.
    Exciter,
    /// Power amplifier.
    Amplifier,
    /// What comes from outside.
    Environment,
}

/// A parameter of an effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Name, with its unit as suffix where it has one.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
    /// Smallest and largest value that is accepted.
    pub bounds: [f64; 2],
    /// A value that is usual in the field and clearly seen in a good measurement.
    pub usual: f64,
}

impl Parameter {
    const fn new(name: &'static str, unit: &'static str, bounds: [f64; 2], usual: f64) -> Self {
        Self {
            name,
            unit,
            bounds,
            usual,
        }
    }
}

/// What an effect of a calibrator does to a model; values are in the order of its parameters.
pub type CalibratorAction = fn(&[f64], &Conditions, &mut Model);

/// A set of effects with the same kind of action.
pub trait Library: Copy + 'static {
    /// All its effects, by name.
    fn effects() -> &'static [Effect<Self>];
}

impl Library for CalibratorAction {
    fn effects() -> &'static [Effect<Self>] {
        &EFFECTS
    }
}

/// An effect of a library, of a calibrator if not said otherwise.
#[derive(Clone, Copy)]
pub struct Effect<A: 'static = CalibratorAction> {
    /// Name in the library, on the command line and in files.
    pub id: &'static str,
    /// Where it sits.
    pub stage: Stage,
    /// First-order shape: r = dut/ref, d = ref/coil voltage, z = coil voltage/current, A level,
    /// q = f/f0.
    pub formula: &'static str,
    /// Parameters in the order of their values.
    pub parameters: &'static [Parameter],
    /// Changes a model.
    apply: A,
}

/// All effects of a calibrator, by name.
pub static EFFECTS: [Effect; 44] = [
    adc_clipping::EFFECT,
    adc_cubic::EFFECT,
    adc_dead_zone::EFFECT,
    adc_quadratic::EFFECT,
    ambient_vibration::EFFECT,
    amplifier_clipping::EFFECT,
    amplifier_even_order::EFFECT,
    amplifier_gain_drift::EFFECT,
    armature_mode::EFFECT,
    averaging_window::EFFECT,
    back_emf::EFFECT,
    base_strain::EFFECT,
    channel_skew::EFFECT,
    clock_offset::EFFECT,
    coil_heating::EFFECT,
    coulomb_friction::EFFECT,
    crosstalk::EFFECT,
    dut_drift::EFFECT,
    dut_frequency_slope::EFFECT,
    dut_gain::EFFECT,
    dut_highpass::EFFECT,
    dut_level_nonlinearity::EFFECT,
    dut_lowpass_1::EFFECT,
    dut_lowpass_2::EFFECT,
    dut_resonance::EFFECT,
    dut_temperature::EFFECT,
    force_factor_droop::EFFECT,
    gravity_tilt::EFFECT,
    loose_mount::EFFECT,
    lossy_inductance::EFFECT,
    mains_pickup::EFFECT,
    mechanical_damping::EFFECT,
    mount_compliance::EFFECT,
    payload_mass::EFFECT,
    reference_drift::EFFECT,
    reference_gain::EFFECT,
    reference_highpass::EFFECT,
    reference_resonance::EFFECT,
    reference_temperature::EFFECT,
    relative_motion::EFFECT,
    sampling_jitter::EFFECT,
    suspension_asymmetry::EFFECT,
    suspension_cubic::EFFECT,
    transverse_motion::EFFECT,
];

impl<A: Library> Effect<A> {
    /// All effects of the library, by name.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        A::effects().iter()
    }

    /// The effect called `id`.
    pub fn named(id: &str) -> Option<&'static Self> {
        Self::all().find(|effect| effect.id == id)
    }

    /// The effect with the usual value of each parameter.
    pub fn usual(&'static self) -> ActiveEffect<A> {
        let values = self
            .parameters
            .iter()
            .map(|parameter| parameter.usual)
            .collect();
        ActiveEffect::trusted(self, values)
    }
}

/// The channel a parameter selects: 0 reference, 1 device under test.
fn channel(model: &mut Model, selector: f64) -> &mut Channel {
    if selector < 0.5 {
        &mut model.reference
    } else {
        &mut model.dut
    }
}
