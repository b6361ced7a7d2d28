//! Effects of real calibrators that the nominal simulation leaves out: how each entry of the
//! vocabulary acts, one file per stage.
//!
//! An effect changes the [`Model`](crate::model::Model) it is applied to, nothing else. It acts at
//! one place of the physics, so what it does to every observable follows and is not stated here.
//! Words are shared with whoever explains measured data ([`calib_effects`]); equations are not.

mod active;
mod amplifier;
mod conditioning;
mod digitiser;
mod dut;
mod effect;
mod environment;
mod exciter;
pub mod fault;
mod mount;
pub mod oscillator;
mod reference;

use calib_effects::Of;
use std::sync::LazyLock;

pub use self::active::{ActiveEffect, EffectError};
pub use self::effect::{CalibratorAction, Effect, Library};

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
