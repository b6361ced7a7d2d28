//! The library of explanations: what can cause a gap, by name.
//!
//! Words are those of the vocabulary ([`calib_effects`]). One explanation says
//! when data can show the effect, where a fit starts, and what it does to one
//! row. An effect that can sit in either channel, or whose text leaves a detail
//! open, has variants: several explanations of one name, of which the best one
//! speaks for the name.

mod adc;
mod amplifier;
mod exciter;
mod filters;
mod gains;
mod motion;
mod mount;
mod noise;
mod resonance;
mod suspension;
mod timing;

use crate::error::GapError;
use crate::model::effect::Effect;
use std::sync::LazyLock;

/// All explanations, in the order in which equals are preferred.
pub(crate) fn library() -> &'static [&'static dyn Effect] {
    static LIBRARY: LazyLock<Vec<&'static dyn Effect>> = LazyLock::new(|| {
        [
            resonance::EXPLANATIONS,
            motion::EXPLANATIONS,
            mount::EXPLANATIONS,
            gains::EXPLANATIONS,
            filters::EXPLANATIONS,
            timing::EXPLANATIONS,
            noise::EXPLANATIONS,
            adc::EXPLANATIONS,
            suspension::EXPLANATIONS,
            exciter::EXPLANATIONS,
            amplifier::EXPLANATIONS,
        ]
        .concat()
    });
    &LIBRARY
}

/// Looks a name up, oscillator effects and constant gains included.
///
/// # Errors
/// [`GapError::UnknownEffect`] with the nearest name.
pub fn check_name(name: &str) -> Result<(), GapError> {
    if calib_effects::effect(name).is_some() {
        return Ok(());
    }
    let nearest = calib_effects::nearest(name);
    Err(GapError::UnknownEffect {
        name: name.into(),
        hint: nearest.map_or(String::new(), |n| format!(" (did you mean {n}?)")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_effects::{Of, entries};

    #[test]
    fn every_effect_that_can_be_named_is_explained_and_nothing_else() {
        for entry in entries(Of::Calibrator) {
            let explained = library().iter().any(|e| std::ptr::eq(e.entry(), entry));
            assert_eq!(explained, entry.identifiable, "{}", entry.id);
        }
        assert!(library().iter().all(|e| e.entry().of == Of::Calibrator));
    }

    #[test]
    fn what_is_fitted_is_in_the_vocabulary() {
        for effect in library() {
            let entry = effect.entry();
            for fitted in effect.parameters() {
                let known = entry.parameters.iter().chain(entry.only_fitted);
                assert!(
                    known.clone().any(|p| p == fitted),
                    "{} {}",
                    entry.id,
                    fitted.name
                );
            }
        }
    }
}
