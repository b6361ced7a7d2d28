//! Combined standard uncertainty and effective degrees of freedom.

use super::component::Component;
use core::fmt;
use heapless::Vec;

/// Most components of one budget.
pub const MAX_COMPONENTS: usize = 32;
/// Most correlated pairs of one budget.
pub const MAX_CORRELATIONS: usize = 16;

/// Correlation coefficient of two components.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Correlation {
    a: u8,
    b: u8,
    coefficient: f32,
}

/// Why a budget cannot be evaluated; indices count components from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum BudgetError {
    /// More components or correlations than there is room for.
    Full,
    /// A value is negative or not finite.
    Value(u8),
    /// Coverage factor or divisor of the distribution is not positive and finite.
    Divisor(u8),
    /// The sensitivity coefficient is not finite.
    SensitivityCoefficient(u8),
    /// Degrees of freedom are not positive.
    DegreesOfFreedom(u8),
    /// A correlation coefficient is outside -1..=1.
    CorrelationCoefficient,
    /// A correlation names a component there is not, or one with itself.
    CorrelationIndex(u8),
    /// The correlations contradict each other: the variance is negative.
    NegativeVariance,
    /// There is no component, or none that is larger than zero.
    Empty,
}

impl fmt::Display for BudgetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let line = |f: &mut fmt::Formatter<'_>, index: u8, what: &str| {
            write!(f, "component {}: {what}", u16::from(index) + 1)
        };
        match *self {
            Self::Full => f.write_str("more components or correlations than a budget holds"),
            Self::Value(i) => line(f, i, "the value must be finite and not negative"),
            Self::Divisor(i) => line(f, i, "the coverage factor or divisor must be positive"),
            Self::SensitivityCoefficient(i) => {
                line(f, i, "the sensitivity coefficient must be finite")
            }
            Self::DegreesOfFreedom(i) => line(f, i, "degrees of freedom must be positive"),
            Self::CorrelationCoefficient => {
                f.write_str("a correlation coefficient must lie in -1..=1")
            }
            Self::CorrelationIndex(i) => line(f, i, "no such component for a correlation"),
            Self::NegativeVariance => f.write_str(
                "the correlation coefficients contradict each other: the variance is negative",
            ),
            Self::Empty => f.write_str("the budget has no component above zero"),
        }
    }
}

impl core::error::Error for BudgetError {}

/// A list of components and their correlations.
#[derive(Clone, Debug, Default)]
pub struct Budget<'a> {
    components: Vec<Component<'a>, MAX_COMPONENTS>,
    correlations: Vec<Correlation, MAX_CORRELATIONS>,
}

/// Result of a budget before coverage, in the unit of its contributions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Combined {
    /// Combined standard uncertainty.
    pub standard_uncertainty: f32,
    /// Effective degrees of freedom (Welch-Satterthwaite); may be infinite.
    pub effective_degrees_of_freedom: f32,
}

impl<'a> Budget<'a> {
    /// An empty budget.
    pub const fn new() -> Self {
        Self {
            components: Vec::new(),
            correlations: Vec::new(),
        }
    }

    /// Adds a component and returns its index.
    ///
    /// # Errors
    /// [`BudgetError::Full`], or the property of the component that is wrong.
    pub fn add(&mut self, component: Component<'a>) -> Result<u8, BudgetError> {
        let index = self.components.len() as u8;
        check(&component, index)?;
        self.components
            .push(component)
            .map_err(|_| BudgetError::Full)?;
        Ok(index)
    }

    /// States the correlation coefficient of two input quantities.
    ///
    /// # Errors
    /// [`BudgetError::CorrelationIndex`], [`BudgetError::CorrelationCoefficient`]
    /// or [`BudgetError::Full`].
    pub fn correlate(&mut self, a: u8, b: u8, coefficient: f32) -> Result<(), BudgetError> {
        let known = |index: u8| usize::from(index) < self.components.len();
        if !known(a) || a == b {
            return Err(BudgetError::CorrelationIndex(a));
        }
        if !known(b) {
            return Err(BudgetError::CorrelationIndex(b));
        }
        if !(-1.0..=1.0).contains(&coefficient) {
            return Err(BudgetError::CorrelationCoefficient);
        }
        let correlation = Correlation { a, b, coefficient };
        let pushed = self.correlations.push(correlation);
        pushed.map_err(|_| BudgetError::Full)
    }

    /// True when a correlation was stated.
    pub fn has_correlations(&self) -> bool {
        !self.correlations.is_empty()
    }

    /// The components in the order added.
    pub fn components(&self) -> &[Component<'a>] {
        &self.components
    }

    /// Combines the components.
    ///
    /// # Equation
    /// `u_c^2 = sum (c_i u_i)^2 + 2 sum r_ij c_i u_i c_j u_j` (A.1, A.4), and
    /// `nu_eff = u_c^4 / sum ((c_i u_i)^4 / nu_i)` (GUM G.4.1).
    /// Both are formed relative to the largest contribution, so that fourth
    /// powers of small numbers do not vanish in f32.
    ///
    /// # Errors
    /// [`BudgetError::Empty`] or [`BudgetError::NegativeVariance`].
    ///
    /// # Accuracy
    /// 1e-6 relative; tests `the_end_gauge_of_the_gum_in_metres` and
    /// `table_d1_comes_out_row_by_row`.
    pub fn combine(&self) -> Result<Combined, BudgetError> {
        let largest = self
            .components
            .iter()
            .fold(0.0_f32, |largest, c| largest.max(c.contribution().abs()));
        if largest <= 0.0 {
            return Err(BudgetError::Empty);
        }
        let relative = |index: u8| {
            let component = self.components.get(usize::from(index));
            component.map_or(0.0, |c| c.contribution() / largest)
        };
        let (mut variance, mut welch) = (0.0_f32, 0.0_f32);
        for component in &self.components {
            let share = component.contribution() / largest;
            let square = share * share;
            variance += square;
            welch += square * square / component.degrees_of_freedom;
        }
        for c in &self.correlations {
            variance += 2.0 * c.coefficient * relative(c.a) * relative(c.b);
        }
        // Full cancellation may leave a rounding error below zero.
        if variance < -1.0e-5 {
            return Err(BudgetError::NegativeVariance);
        }
        let variance = variance.max(0.0);
        let degrees = if welch > 0.0 {
            variance * variance / welch
        } else {
            f32::INFINITY
        };
        Ok(Combined {
            standard_uncertainty: largest * libm::sqrtf(variance),
            effective_degrees_of_freedom: degrees,
        })
    }
}

/// Finds the first property of a component that makes no sense.
fn check(component: &Component<'_>, index: u8) -> Result<(), BudgetError> {
    if !(component.value.is_finite() && component.value >= 0.0) {
        return Err(BudgetError::Value(index));
    }
    let divisor = component.distribution.divisor();
    if !(divisor.is_finite() && divisor > 0.0) {
        return Err(BudgetError::Divisor(index));
    }
    if !component.sensitivity_coefficient.is_finite() {
        return Err(BudgetError::SensitivityCoefficient(index));
    }
    if !(component.degrees_of_freedom > 0.0) {
        return Err(BudgetError::DegreesOfFreedom(index));
    }
    Ok(())
}
