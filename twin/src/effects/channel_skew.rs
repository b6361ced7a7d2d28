//! Fixed delay between the channels.
//!
//! Multiplexed converters sample one channel later than the other.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "channel_skew",
    stage: Stage::Digitiser,
    formula: "r = exp(-j 2 pi f tau)",
    parameters: &[Parameter::new("tau_s", "s", [-1e-3, 1e-3], 1e-6)],
    apply: |values, _conditions, model| {
        model.dut.response.push(Section::Delay(values[0]));
    },
};
