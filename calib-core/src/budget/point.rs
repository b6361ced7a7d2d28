//! The budget of one measured point, made alike by firmware and host.

use super::catalogue::Row;
use super::combine::{Budget, BudgetError};
use super::component::Component;
use super::coverage::{CoverageRule, Expanded, PROBABILITY_K2};
use crate::reference::ReferenceSensitivity;
use crate::settings::{Distribution, Settings};

/// Expanded uncertainties of the reference table are stated with this factor.
const REFERENCE: Distribution = Distribution::Normal {
    coverage_factor: 2.0,
};

/// Standard uncertainties are entered with this one.
const STANDARD: Distribution = Distribution::Normal {
    coverage_factor: 1.0,
};

/// The random part of a point: standard deviations of the mean over its blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TypeA {
    /// Of the magnitude, relative.
    pub repeatability_rel: f32,
    /// Of the phase, rad.
    pub repeatability_phase_rad: f32,
    /// Blocks averaged.
    pub blocks: u16,
}

impl TypeA {
    /// Degrees of freedom: blocks - 1.
    pub fn degrees_of_freedom(self) -> f32 {
        f32::from(self.blocks.saturating_sub(1).max(1))
    }
}

/// Magnitude (relative) and phase (rad) budget of a point.
#[derive(Clone, Debug)]
pub struct PointBudget<'a> {
    /// Table A.1.
    pub magnitude: Budget<'a>,
    /// Table A.2.
    pub phase: Budget<'a>,
}

/// Lists the components of a point.
///
/// Row 1 is the reference's calibration, with a second component when its
/// table had to be interpolated (5.1); the influences of the settings follow;
/// the last row is the measurement's own scatter with blocks - 1 degrees of
/// freedom.
///
/// # Errors
/// [`BudgetError`] names the component that makes no sense.
///
/// # Source
/// ISO 16063-21:2003, Tables A.1 and A.2.
pub fn point_budget(
    settings: &Settings,
    reference: &ReferenceSensitivity,
    type_a: TypeA,
) -> Result<PointBudget<'static>, BudgetError> {
    Ok(PointBudget {
        magnitude: magnitude(settings, reference, type_a)?,
        phase: phase(settings, reference, type_a)?,
    })
}

fn magnitude(
    settings: &Settings,
    reference: &ReferenceSensitivity,
    type_a: TypeA,
) -> Result<Budget<'static>, BudgetError> {
    let mut budget = Budget::new();
    let expanded = reference.expanded_uncertainty_rel;
    budget.add(Component::new(Row::a1(1), expanded, REFERENCE))?;
    add_interpolation(&mut budget, Row::a1(1), reference.interpolation_rel)?;
    for influence in &settings.influences {
        let row = Row::a1(influence.row);
        let value = influence.value_rel;
        budget.add(Component::new(row, value, influence.distribution))?;
    }
    let random = Component::new(Row::a1(18), type_a.repeatability_rel, STANDARD);
    budget.add(random.with_degrees_of_freedom(type_a.degrees_of_freedom()))?;
    Ok(budget)
}

fn phase(
    settings: &Settings,
    reference: &ReferenceSensitivity,
    type_a: TypeA,
) -> Result<Budget<'static>, BudgetError> {
    let mut budget = Budget::new();
    let expanded = reference.expanded_uncertainty_phase_rad;
    budget.add(Component::new(Row::a2(1), expanded, REFERENCE))?;
    add_interpolation(&mut budget, Row::a2(1), reference.interpolation_phase_rad)?;
    for influence in &settings.influences {
        let row = Row::a2_from_a1(influence.row);
        let value = influence.value_phase_rad;
        budget.add(Component::new(row, value, influence.distribution))?;
    }
    let random = Component::new(Row::a2(17), type_a.repeatability_phase_rad, STANDARD);
    budget.add(random.with_degrees_of_freedom(type_a.degrees_of_freedom()))?;
    Ok(budget)
}

fn add_interpolation(
    budget: &mut Budget<'static>,
    row: Row,
    half_width: f32,
) -> Result<(), BudgetError> {
    if half_width > 0.0 {
        let component = Component::new(row, half_width, Distribution::Rectangular);
        budget.add(component.labelled("interpolation in the table of the reference"))?;
    }
    Ok(())
}

impl PointBudget<'_> {
    /// Expanded magnitude and phase for the probability of `k = 2`.
    ///
    /// # Errors
    /// Those of [`Budget::combine`].
    pub fn expand(&self) -> Result<(Expanded, Expanded), BudgetError> {
        let rule = CoverageRule::Probability(PROBABILITY_K2);
        Ok((self.magnitude.expand(rule)?, self.phase.expand(rule)?))
    }
}
