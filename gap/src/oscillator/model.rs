//! The oscillator with its candidate terms: x'' + 2 delta w0 x' + w0^2 x + terms(x, x') = w0^2 gain u + force.

use super::parameters::Parameter::{self, *};
use super::parameters::{LINEAR, OscillatorParameters};
use super::run::Run;
use crate::thresholds;
use calib_effects::{Entry, Stage, oscillator};

/// Candidate terms.
pub(crate) const TERMS: [Term; 16] = [
    Term {
        entry: &oscillator::CUBIC_STIFFNESS,
        leading: true,
        has_kink: false,
        values: &[CubicStiffness],
    },
    Term {
        entry: &oscillator::QUADRATIC_STIFFNESS,
        leading: true,
        has_kink: false,
        values: &[QuadraticStiffness],
    },
    Term {
        entry: &oscillator::QUADRATIC_DAMPING,
        leading: false,
        has_kink: false,
        values: &[QuadraticDamping],
    },
    Term {
        entry: &oscillator::CUBIC_DAMPING,
        leading: false,
        has_kink: false,
        values: &[CubicDamping],
    },
    Term {
        entry: &oscillator::COULOMB_FRICTION,
        leading: false,
        has_kink: true,
        values: &[CoulombFriction],
    },
    Term {
        entry: &oscillator::INPUT_DELAY,
        leading: true,
        has_kink: false,
        values: &[Delay],
    },
    Term {
        entry: &oscillator::INPUT_SATURATION,
        leading: true,
        has_kink: true,
        values: &[Saturation],
    },
    Term {
        entry: &oscillator::INPUT_OFFSET,
        leading: false,
        has_kink: false,
        values: &[SteadyForce],
    },
    Term {
        entry: &oscillator::OUTPUT_HIGHPASS,
        leading: true,
        has_kink: false,
        values: &[HighpassCorner],
    },
    Term {
        entry: &oscillator::OUTPUT_LOWPASS,
        leading: true,
        has_kink: false,
        values: &[Lag],
    },
    Term {
        entry: &oscillator::OUTPUT_CLIPPING,
        leading: true,
        has_kink: false,
        values: &[Clipping],
    },
    Term {
        entry: &oscillator::OUTPUT_TREND,
        leading: true,
        has_kink: false,
        values: &[Trend],
    },
    Term {
        entry: &oscillator::RESONANCE_DRIFT,
        leading: true,
        has_kink: false,
        values: &[ResonanceDrift],
    },
    Term {
        entry: &oscillator::SECOND_MODE,
        leading: true,
        has_kink: false,
        values: &[ModeGain, ModeLnRatio, ModeDamping],
    },
    Term {
        entry: &oscillator::DEAD_ZONE,
        leading: false,
        has_kink: true,
        values: &[DeadZone],
    },
    Term {
        entry: &oscillator::HYSTERESIS,
        leading: false,
        has_kink: true,
        values: &[YieldingShare, LnYieldDeflection],
    },
];

/// A term a diagnosis may add.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Term {
    /// Its words; all its parameters are fitted.
    pub(crate) entry: &'static Entry,
    /// Whether it comes early in an expansion of the forces in powers.
    pub(crate) leading: bool,
    /// Whether its force has a kink, which the integration meets between two steps.
    pub(crate) has_kink: bool,
    /// Its values in a simulation; all of them zero: there is no such term.
    pub(crate) values: &'static [Parameter],
}

/// Whether a term shows beside others. A steady force moves what is straight as another zero of the
/// output does, and nothing is known of an amplifier without an input.
pub(super) fn shows(term: usize, beside: &[usize], record: &Run) -> bool {
    let bends = |t: &usize| {
        let value = TERMS[*t].values[0];
        matches!(value, CubicStiffness | QuadraticStiffness | DeadZone)
    };
    let force = record.driven || TERMS[term].entry.stage != Stage::Amplifier;
    force && (TERMS[term].values[0] != SteadyForce || beside.iter().any(bends))
}

/// Parameters of the state at the first sample with the given terms, as far as the samples from
/// there on show them. What a slow high-pass held back would be a zero of the record's own.
pub(super) fn states(
    terms: &[usize],
    values: &OscillatorParameters,
    record: &Run,
) -> Vec<Parameter> {
    let duration_s = record.interval_s * record.input.len() as f64;
    let forgets = values[HighpassCorner] * duration_s > thresholds::REMEMBERED;
    let mut states = vec![Displacement, Velocity];
    for term in terms {
        match TERMS[*term].values[0] {
            HighpassCorner if forgets => states.push(HeldBack),
            Lag if values[Lag] > thresholds::LAG_SEEN => states.push(Lagging),
            ModeGain => states.extend([ModeDisplacement, ModeVelocity]),
            _ => {}
        }
    }
    states
}

/// Parameters that a fit moves from there: of the linear oscillator, of the terms, of their states.
pub(super) fn free(terms: &[usize], values: &OscillatorParameters, record: &Run) -> Vec<Parameter> {
    let of_terms = terms.iter().flat_map(|t| TERMS[*t].values).copied();
    let states = states(terms, values, record);
    let states = states.into_iter().filter(|s| match s {
        Lagging => values[Lag] > thresholds::LAG_REMEMBERED,
        state => !LINEAR.contains(state),
    });
    LINEAR.into_iter().chain(of_terms).chain(states).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_term_of_the_vocabulary_is_fitted_with_all_its_parameters() {
        for entry in calib_effects::entries(calib_effects::Of::Oscillator) {
            let terms = TERMS.iter().filter(|term| std::ptr::eq(term.entry, entry));
            assert_eq!(terms.count(), 1, "{}", entry.id);
        }
        for term in &TERMS {
            assert_eq!(term.values.len(), term.entry.parameters.len());
        }
    }
}
