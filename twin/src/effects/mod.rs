//! What a real calibrator does and the nominal simulation leaves out: how each entry of the
//! vocabulary acts, one file per stage.
//!
//! An effect changes the [`Model`] it is applied to, nothing else. It acts at one place of the
//! physics, so what it does to every observable follows and is not stated here. Words are shared
//! with whoever explains measured data ([`calib_effects`]); equations are not.

mod active;
mod amplifier;
mod conditioning;
mod digitiser;
mod dut;
mod environment;
mod exciter;
pub mod fault;
mod mount;
pub mod oscillator;
mod reference;

use crate::model::{Conditions, Model};
use calib_effects::{Entry, Of};
use std::sync::LazyLock;

pub use self::active::{ActiveEffect, EffectError};

/// What an effect of a calibrator does to a model; values are in the order of its parameters.
pub type CalibratorAction = fn(&[f64], &Conditions, &mut Model);

/// A set of effects with the same kind of action.
pub trait Library: Copy + 'static {
    /// The entries of the vocabulary that act like this.
    const OF: Of;

    /// All its effects, by name.
    fn effects() -> &'static [Effect<Self>];
}

/// An entry of the vocabulary and how it acts, on a calibrator if not said otherwise.
#[derive(Clone, Copy)]
pub struct Effect<A: 'static = CalibratorAction> {
    /// Its words.
    pub entry: &'static Entry,
    /// Changes a model.
    apply: A,
}

impl Library for CalibratorAction {
    const OF: Of = Of::Calibrator;

    fn effects() -> &'static [Effect<Self>] {
        static BY_NAME: LazyLock<Vec<Effect>> = LazyLock::new(|| {
            let stages = [
                dut::EFFECTS,
                reference::EFFECTS,
                mount::EFFECTS,
                conditioning::EFFECTS,
                digitiser::EFFECTS,
                exciter::EFFECTS,
                amplifier::EFFECTS,
                environment::EFFECTS,
            ];
            let mut all = stages.concat();
            all.sort_by_key(|effect| effect.entry.id);
            all
        });
        &BY_NAME
    }
}

impl<A> Effect<A> {
    const fn new(entry: &'static Entry, apply: A) -> Self {
        Self { entry, apply }
    }
}

impl<A: Library> Effect<A> {
    /// All effects of the library, by name.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        A::effects().iter()
    }

    /// The effect called `id`.
    pub fn named(id: &str) -> Option<&'static Self> {
        Self::all().find(|effect| effect.entry.id == id)
    }

    /// The effect with the usual value of each parameter.
    pub fn usual(&'static self) -> ActiveEffect<A> {
        let parameters = self.entry.parameters.iter();
        ActiveEffect::trusted(self, parameters.map(|parameter| parameter.usual).collect())
    }
}
