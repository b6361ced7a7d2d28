//! The budget of one measured point, made alike by firmware and host.

use super::catalogue::Row;
use super::combine::{Budget, BudgetError};
use super::component::Component;
use super::coverage::{CoverageRule, Expanded, PROBABILITY_K2};
use crate::point::PointResult;
use crate::reference::ReferenceSensitivity;
use crate::response_table::Response;
use crate::settings::{Distribution, Influence, Settings};

/// Expanded uncertainties of the tables are stated with this factor.
const EXPANDED_K2: Distribution = Distribution::Normal {
    coverage_factor: 2.0,
};

/// Row of Table A.1 for the ratio of the two voltages.
const RATIO: u8 = 3;

/// Standard uncertainties are entered with this one.
const STANDARD: Distribution = Distribution::Normal {
    coverage_factor: 1.0,
};

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
/// table had to be interpolated (5.1); the influences of the settings follow, of
/// which a measured ratio of the channels replaces that of row 3, then those that
/// differ from point to point, the hum, and noise that comes with the motion; the last row is the measurement's own
/// scatter with blocks - 1 degrees of freedom.
///
/// # Errors
/// [`BudgetError`] names the component that makes no sense.
///
/// # Source
/// ISO 16063-21:2003, Tables A.1 and A.2.
pub fn point_budget(
    settings: &Settings,
    reference: &ReferenceSensitivity,
    point: &PointResult,
) -> Result<PointBudget<'static>, BudgetError> {
    let mut budget = PointBudget {
        magnitude: Budget::new(),
        phase: Budget::new(),
    };
    budget.add(
        1,
        EXPANDED_K2,
        [
            reference.expanded_uncertainty_rel,
            reference.expanded_uncertainty_phase_rad,
        ],
    )?;
    budget.add_above_zero(
        1,
        "interpolation in the table of the reference",
        Distribution::Rectangular,
        [
            reference.interpolation_rel,
            reference.interpolation_phase_rad,
        ],
    )?;
    let channels = settings.channel_ratio.at(point.spec.frequency_hz);
    if let Some(known) = channels {
        budget.add_ratio(&known)?;
    }
    // Measured, it is known better than by the tolerances of the parts.
    let known = |influence: &&Influence| channels.is_some() && influence.row == RATIO;
    for influence in settings.influences.iter().filter(|i| !known(i)) {
        let distribution = influence.distribution;
        let values = [influence.value_rel, influence.value_phase_rad];
        budget.add(influence.row, distribution, values)?;
    }
    let mut at_point = settings.point_influences;
    if channels.is_some() {
        at_point.channel_delay_s = 0.0;
    }
    for at_point in at_point.at(point, reference) {
        let half_widths = [at_point.half_width_rel, at_point.half_width_phase_rad];
        budget.add_above_zero(
            at_point.row,
            at_point.label,
            at_point.distribution,
            half_widths,
        )?;
    }
    budget.add(5, Distribution::UShaped, [point.hum_rel; 2])?;
    budget.add_above_zero(
        5,
        "noise that comes with the motion",
        // Nothing, or all of it: a contact that opens takes all, and nothing else that is known takes some.
        Distribution::UShaped,
        [point.dropout_rel; 2],
    )?;
    let degrees = f32::from(point.blocks.saturating_sub(1).max(1));
    for (budget, row, value) in [
        (&mut budget.magnitude, Row::a1(18), point.repeatability_rel),
        (
            &mut budget.phase,
            Row::a2_from_a1(18),
            point.repeatability_phase_rad,
        ),
    ] {
        let random = Component::new(row, value, STANDARD);
        budget.add(random.with_degrees_of_freedom(degrees))?;
    }
    Ok(budget)
}

impl PointBudget<'static> {
    /// Adds a component of this row of Table A.1, and of Table A.2.
    #[inline(never)]
    fn add(
        &mut self,
        row: u8,
        distribution: Distribution,
        [magnitude, phase]: [f32; 2],
    ) -> Result<(), BudgetError> {
        let component = |row, value| Component::new(row, value, distribution);
        self.magnitude.add(component(Row::a1(row), magnitude))?;
        self.phase.add(component(Row::a2_from_a1(row), phase))?;
        Ok(())
    }

    /// Adds the uncertainty of the ratio of the channels, where it was measured.
    fn add_ratio(&mut self, known: &Response) -> Result<(), BudgetError> {
        let values = [
            known.expanded_uncertainty_rel,
            known.expanded_uncertainty_phase_rad,
        ];
        let label = "ratio of the channels, as measured";
        self.add_above_zero(RATIO, label, EXPANDED_K2, values)?;
        self.add_above_zero(
            RATIO,
            "interpolation of the ratio of the channels",
            Distribution::Rectangular,
            [known.interpolation_rel, known.interpolation_phase_rad],
        )
    }

    /// Adds components where their half-widths are above zero.
    #[inline(never)]
    fn add_above_zero(
        &mut self,
        row: u8,
        label: &'static str,
        distribution: Distribution,
        [magnitude, phase]: [f32; 2],
    ) -> Result<(), BudgetError> {
        let component =
            |row, half_width| Component::new(row, half_width, distribution).labelled(label);
        if magnitude > 0.0 {
            self.magnitude.add(component(Row::a1(row), magnitude))?;
        }
        if phase > 0.0 {
            self.phase.add(component(Row::a2_from_a1(row), phase))?;
        }
        Ok(())
    }
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
