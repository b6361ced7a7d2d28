//! Relative motion between the mounting faces of the two transducers.
//!
//! The table between them strains under the inertia of the payload: far below its own resonance the
//! faces differ by a share that grows with mass and frequency squared.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "relative_motion",
    stage: Stage::Mount,
    formula: "r = 1 - kappa m f^2",
    parameters: &[Parameter::new(
        "kappa_per_kg_hz2",
        "1/(kg Hz2)",
        [0.0, 1e-4],
        5e-9,
    )],
    apply: |values, conditions, model| {
        let per_hz2 = values[0] * conditions.payload_kg;
        model.dut.motion.push(Section::InverseSquare(per_hz2));
    },
};
