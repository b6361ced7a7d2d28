//! An entry of the vocabulary that acts, and the sets of those that act alike.

use crate::model::{Conditions, Model};
use calib_effects::{Entry, Of};

/// Action of an effect on the model of a calibrator; values are in the order of its parameters.
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
    pub(super) apply: A,
}

impl<A> Effect<A> {
    pub(super) const fn new(entry: &'static Entry, apply: A) -> Self {
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
}
