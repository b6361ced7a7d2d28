//! Influence quantities that differ from point to point: the one list.
//!
//! What is the same at every point is an [`Influence`](super::Influence). Here each quantity has a
//! coefficient, which is a setting, and a formula that makes of it the half-width at a point.

use crate::point::PointResult;
use serde::{Deserialize, Serialize};

/// Coefficients of the influence quantities that differ from point to point. 0 leaves one out of the
/// budget.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PointInfluences {}

/// What a quantity comes to at a point: a component of rectangular distribution in both budgets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtPoint {
    /// Row of Table A.1; that of Table A.2 follows from it.
    pub row: u8,
    /// What it is, in words.
    pub label: &'static str,
    /// Half-width of the magnitude, relative.
    pub half_width_rel: f32,
    /// Half-width of the phase, rad.
    pub half_width_phase_rad: f32,
}

impl PointInfluences {
    /// No such influence.
    pub const NONE: Self = Self {};

    /// The coefficients in the order they are stored: a new one goes to the end.
    pub fn coefficients_mut(&mut self) -> [&mut f32; 0] {
        []
    }

    /// What the quantities come to at a point.
    pub fn at(&self, _point: &PointResult) -> [AtPoint; 0] {
        []
    }

    /// Whether every coefficient is finite and not negative.
    pub(super) fn is_valid(mut self) -> bool {
        let coefficients = self.coefficients_mut();
        coefficients
            .iter()
            .all(|value| value.is_finite() && **value >= 0.0)
    }
}
