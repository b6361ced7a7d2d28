//! What an IEPE supply that breaks down does, whichever way: open or short.

use super::super::Parameter;
use super::{AT_S, CHANNEL};
use crate::faults::{Faults, Surge};

/// Parameters of both.
pub(super) const PARAMETERS: [Parameter; 4] = [
    CHANNEL,
    AT_S,
    Parameter::new("jump_v", "V", [0.0, 30.0], 12.0),
    Parameter::new("decay_s", "s", [1e-3, 100.0], 1.0),
];

/// The bias jumps up (`direction` 1) or down (-1).
pub(super) fn surge(values: &[f64], direction: f64, faults: &mut Faults) {
    faults.channel(values[0]).surge = Some(Surge {
        at_s: values[1],
        volt: direction * values[2],
        time_constant_s: values[3],
    });
}
