//! Sensitivity that falls by a constant share per decade.
//!
//! Piezoelectric ceramics relax over a wide spectrum of time constants: about 2 % per decade.
//!
//! # Source
//! ISO 16063-21:2003, Annex D: `S2(f) = S2(fref) (1 - 0.02 lg(f/fref))`.

use super::{Effect, Parameter, Stage};
use crate::model::Section;

/// Frequency at which the sensitivity is stated, Hz.
const REFERENCE_HZ: f64 = 160.0;

/// See the module.
pub(super) const EFFECT: Effect = Effect {
    id: "dut_frequency_slope",
    stage: Stage::Dut,
    formula: "r = 1 - s lg(f/fref), fref = 160 Hz",
    parameters: &[Parameter::new("slope_per_decade", "1", [0.0, 0.3], 0.02)],
    apply: |values, _conditions, model| {
        model.dut.response.push(Section::Slope {
            per_decade: values[0],
            reference_hz: REFERENCE_HZ,
        });
    },
};
