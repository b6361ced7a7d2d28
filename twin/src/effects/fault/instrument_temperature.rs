//! An instrument in the sun, or out of a cold van: its processor takes another temperature.

use super::super::{Effect, Parameter, Stage};
use super::{AT_S, FaultEffect};

/// See the module.
pub(super) const EFFECT: FaultEffect = Effect {
    id: "instrument_temperature",
    stage: Stage::Environment,
    formula: "the processor is at celsius from at_s on",
    parameters: &[
        AT_S,
        Parameter::new("celsius", "degrees Celsius", [-100.0, 200.0], 100.0),
    ],
    apply: |values, faults| faults.processor_c = Some((values[0], values[1])),
};
