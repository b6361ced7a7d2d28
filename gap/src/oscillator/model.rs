//! The oscillator with its candidate terms: x'' + 2 delta w0 x' + w0^2 x + terms(x, x') = w0^2 gain u + offset.

use crate::effects::Stage;

const COEFFICIENT: &[&str] = &["coefficient"];

/// Candidate terms; the values of each follow those of the one before.
pub(crate) const TERMS: [Term; 11] = [
    Term {
        name: "cubic_stiffness",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "the same record at half and at twice the amplitude",
    },
    Term {
        name: "quadratic_stiffness",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "the same input with its sign turned, and one with a steady offset",
    },
    Term {
        name: "quadratic_damping",
        leading: false,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    },
    Term {
        name: "cubic_damping",
        leading: false,
        has_kink: false,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "a sine at the resonance at several amplitudes: the loss per cycle over amplitude",
    },
    Term {
        name: "coulomb_friction",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: COEFFICIENT,
        separate_by: "a decay from the resonance down to rest, and the smallest amplitudes",
    },
    Term {
        name: "input_delay",
        leading: true,
        has_kink: false,
        stage: Stage::Amplifier,
        parameters: COEFFICIENT,
        separate_by: "frequencies far above the resonance",
    },
    Term {
        name: "input_saturation",
        leading: true,
        has_kink: true,
        stage: Stage::Amplifier,
        parameters: &["threshold"],
        separate_by: "an input of half the peak value, and the input as it arrives",
    },
    Term {
        name: "output_highpass",
        leading: true,
        has_kink: false,
        stage: Stage::Conditioning,
        parameters: &["corner_hz"],
        separate_by: "frequencies far below the resonance",
    },
    Term {
        name: "second_mode",
        leading: true,
        has_kink: false,
        stage: Stage::Dut,
        parameters: &["gain", "mode_hz", "damping"],
        separate_by: "a small-amplitude sweep around the second frequency",
    },
    Term {
        name: "dead_zone",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: &["half_width"],
        separate_by: "the smallest amplitudes, below and above the play",
    },
    Term {
        name: "hysteresis",
        leading: false,
        has_kink: true,
        stage: Stage::Dut,
        parameters: &["alpha", "yield_deflection"],
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
    /// Names of its values.
    pub(crate) parameters: &'static [&'static str],
}

/// Values every simulation has: ln w0, delta, gain, offset, and the state at the first sample.
pub(crate) const LINEAR: usize = 6;
/// All values of a simulation.
pub(crate) const VALUES: usize = LINEAR + 17;
/// Coefficients of damping and friction.
pub(crate) const LOSSES: std::ops::Range<usize> = LINEAR + 2..LINEAR + 5;
/// Delay of the input, in samples.
pub(crate) const DELAY: usize = LINEAR + 5;
/// One over the input at which it saturates.
pub(crate) const SATURATION: usize = LINEAR + 6;
/// Corner of the output's high-pass, in rad/s.
pub(crate) const HIGHPASS: usize = LINEAR + 7;
/// First value of the second mode: gain, ln of its frequency over w0, damping.
pub(crate) const SECOND_MODE: usize = LINEAR + 8;
/// Half width of the play.
pub(crate) const DEAD_ZONE: usize = LINEAR + 11;
/// First value of the hysteresis: alpha, ln of the yield deflection.
pub(crate) const HYSTERESIS: usize = LINEAR + 12;

/// What the high-pass holds back at the first sample: the first state that only some terms have.
pub(crate) const HELD_BACK: usize = LINEAR + 14;
/// Displacement and velocity of the second mode at the first sample.
pub(crate) const SECOND_STATE: usize = HELD_BACK + 1;

/// Places of the state at the first sample with the given terms.
pub(crate) fn states(terms: &[usize]) -> Vec<usize> {
    let mut states = vec![4, 5];
    for term in terms {
        match places(*term).start {
            HIGHPASS => states.push(HELD_BACK),
            SECOND_MODE => states.extend([SECOND_STATE, SECOND_STATE + 1]),
            _ => {}
        }
    }
    states
}

/// Places of the values of a term.
pub(crate) fn places(term: usize) -> std::ops::Range<usize> {
    let first = TERMS[..term]
        .iter()
        .map(|t| t.parameters.len())
        .sum::<usize>();
    LINEAR + first..LINEAR + first + TERMS[term].parameters.len()
}
