//! Inductance with eddy currents.
//!
//! Eddy currents in the pole make the impedance grow slower than the frequency, with a loss angle.

use super::{Effect, Parameter, Stage};

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "lossy_inductance",
    stage: Stage::Exciter,
    formula: "Z = R + j^n w0 L (w/w0)^n, w0 = 2 pi 1 kHz, n 0.5..0.9 (1 = ideal)",
    parameters: &[Parameter::new("exponent", "1", [0.3, 1.0], 0.7)],
    apply: |values, _conditions, model| {
        model.coil.inductance_exponent = values[0];
    },
};
