//! Scatter of the sampling instants.
//!
//! Both channels are sampled early or late at random: noise in proportion to the slope of the signal,
//! and a mean that is a little smaller.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "sampling_jitter",
    stage: Stage::Digitiser,
    formula: "d = exp(-(2 pi f sigma)^2/2), noise 2 pi f sigma A in both channels",
    parameters: &[Parameter::new("sigma_s", "s", [0.0, 1e-3], 3e-8)],
    apply: |values, _conditions, model| {
        model.jitter_s = model.jitter_s.hypot(values[0]);
    },
};
