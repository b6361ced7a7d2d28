//! The oscillator with its candidate terms: x'' + 2 delta w0 x' + w0^2 x + terms(x, x') = w0^2 gain u + offset.

use super::parameters::Parameter::{self, *};
use super::parameters::{LINEAR, OscillatorParameters};
use super::run::Run;
use crate::effects::Stage;

const COEFFICIENT: &[&str] = &["coefficient"];

/// Candidate terms.
pub(crate) const TERMS: [Term; 11] = [
    Term {
        name: "cubic_stiffness",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        values: &[CubicStiffness],
        separate_by: "the same record at half and at twice the amplitude",
    },
    Term {
        name: "quadratic_stiffness",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        values: &[QuadraticStiffness],
        separate_by: "the same input with its sign turned, and one with a steady offset",
    },
    Term {
        name: "quadratic_damping",
        leading: false,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        values: &[QuadraticDamping],
        separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    },
    Term {
        name: "cubic_damping",
        leading: false,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        values: &[CubicDamping],
        separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    },
    Term {
        name: "coulomb_friction",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        values: &[CoulombFriction],
        separate_by: "a decay from the resonance down to rest, and the smallest amplitudes",
    },
    Term {
        name: "input_delay",
        leading: true,
        has_kink: false,
        stage: Stage::Amplifier,
        parameters: COEFFICIENT,
        values: &[Delay],
        separate_by: "frequencies far above the resonance",
    },
    Term {
        name: "input_saturation",
        leading: true,
        has_kink: true,
        stage: Stage::Amplifier,
        parameters: &["threshold"],
        values: &[Saturation],
        separate_by: "an input of half the peak value, and the input as it arrives",
    },
    Term {
        name: "output_highpass",
        leading: true,
        has_kink: false,
        stage: Stage::Conditioning,
        parameters: &["corner_hz"],
        values: &[HighpassCorner],
        separate_by: "frequencies far below the resonance",
    },
    Term {
        name: "second_mode",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: &["gain", "mode_hz", "damping"],
        values: &[ModeGain, ModeLnRatio, ModeDamping],
        separate_by: "a small-amplitude sweep around the second frequency",
    },
    Term {
        name: "dead_zone",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: &["half_width"],
        values: &[DeadZone],
        separate_by: "the smallest amplitudes, below and above the play",
    },
    Term {
        name: "hysteresis",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: &["alpha", "yield_deflection"],
        values: &[YieldingShare, LnYieldDeflection],
        separate_by: "slow loading and unloading: the path of the restoring force",
    },
];

/// A term a diagnosis may add.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Term {
    /// Name in the library.
    pub(crate) name: &'static str,
    /// Whether it comes early in an expansion of the forces in powers.
    pub(crate) leading: bool,
    /// Whether its force has a kink, which the integration meets between two steps.
    pub(crate) has_kink: bool,
    /// Where it sits.
    pub(crate) stage: Stage,
    /// The record that tells it from the others.
    pub(crate) separate_by: &'static str,
    /// Its values in a simulation; all of them zero: there is no such term.
    pub(crate) values: &'static [Parameter],
    /// Names of its values.
    pub(crate) parameters: &'static [&'static str],
}

/// Parameters of the state at the first sample with the given terms.
pub(super) fn states(terms: &[usize]) -> Vec<Parameter> {
    let mut states = vec![Displacement, Velocity];
    for term in terms {
        match TERMS[*term].values[0] {
            HighpassCorner => states.push(HeldBack),
            ModeGain => states.extend([ModeDisplacement, ModeVelocity]),
            _ => {}
        }
    }
    states
}

/// Times a record is longer than the memory of a high-pass from which what it held back
/// before is fitted; left free in a slower one it would be an offset of the output.
const REMEMBERED: f64 = 8.0;

/// Parameters that a fit moves from there: of the linear oscillator, of the terms, of their states.
pub(super) fn free(terms: &[usize], values: &OscillatorParameters, record: &Run) -> Vec<Parameter> {
    let duration_s = record.interval_s * record.input.len() as f64;
    let forgets = values[HighpassCorner] * duration_s > REMEMBERED;
    let of_terms = terms.iter().flat_map(|t| TERMS[*t].values).copied();
    let states = states(terms).into_iter().filter(|s| match s {
        HeldBack => forgets,
        state => !LINEAR.contains(state),
    });
    LINEAR.into_iter().chain(of_terms).chain(states).collect()
}
