//! Effects with values drawn around what is usual in the field.

use calib_effects::Parameter;
use calib_twin::effects::{ActiveEffect, CalibratorAction, Effect, Library};
use rand_chacha::ChaCha12Rng;
use rand_chacha::rand_core::Rng;

/// Largest factor between a drawn value and the usual one.
const LARGEST_FACTOR: f64 = 2.0;

/// An effect of a calibrator with values at work.
pub type Drawn = ActiveEffect<CalibratorAction>;

/// Uniform in 0..1.
pub fn uniform(random: &mut ChaCha12Rng) -> f64 {
    // 53 bits are what a double holds.
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A whole number below `count`.
pub fn below(count: usize, random: &mut ChaCha12Rng) -> usize {
    ((uniform(random) * count as f64) as usize).min(count - 1)
}

/// Effects that can be told from the measurand at all.
pub fn nameable() -> Vec<&'static Effect> {
    CalibratorAction::effects()
        .iter()
        .filter(|effect| effect.entry.identifiable)
        .collect()
}

/// `effect` with each value up to a factor of two from the usual one, of either
/// sign where both occur, and its switches either way.
pub fn draw(effect: &'static Effect, random: &mut ChaCha12Rng) -> Drawn {
    let mut values: Vec<f64> = effect
        .entry
        .parameters
        .iter()
        .map(|parameter| value(parameter, random))
        .collect();
    if let Some(other_way) = effect.entry.other_way
        && uniform(random) < 0.5
    {
        let mut either = |size: f64| {
            if size == 0.0 {
                0.0
            } else {
                signed(size, random)
            }
        };
        values = other_way.iter().map(|size| either(*size)).collect();
    }
    // Note: bounds are kept by `value`; the usual values are within them.
    ActiveEffect::new(effect, &values).unwrap_or_else(|_| effect.usual())
}

fn value(parameter: &Parameter, random: &mut ChaCha12Rng) -> f64 {
    let [lowest, highest] = parameter.simulated;
    if parameter.is_switch {
        return f64::from(uniform(random) < 0.5);
    }
    let factor = LARGEST_FACTOR.powf(2.0 * uniform(random) - 1.0);
    let size = parameter.usual * factor;
    let value = if lowest < 0.0 && highest >= -lowest {
        signed(size, random)
    } else {
        size
    };
    value.clamp(lowest, highest)
}

fn signed(size: f64, random: &mut ChaCha12Rng) -> f64 {
    if uniform(random) < 0.5 { -size } else { size }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::rand_core::SeedableRng;

    #[test]
    fn every_effect_is_drawn_within_its_bounds_and_not_always_the_same() {
        let mut random = ChaCha12Rng::seed_from_u64(1);
        for effect in nameable() {
            let all: Vec<Drawn> = (0..8).map(|_| draw(effect, &mut random)).collect();
            assert!(all.iter().any(|drawn| drawn.values() != all[0].values()));
            for drawn in all {
                for (value, parameter) in drawn.values().iter().zip(effect.entry.parameters) {
                    let [lowest, highest] = parameter.simulated;
                    assert!((lowest..=highest).contains(value), "{drawn}");
                }
            }
        }
    }
}
