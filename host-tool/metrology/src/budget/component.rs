//! One line of a budget and the distribution assumed for it.

/// Assumed probability distribution of a component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// The value is an expanded uncertainty with this coverage factor; 1 for a
    /// standard uncertainty.
    Normal {
        /// Coverage factor the value was stated with.
        coverage_factor: f64,
    },
    /// The value is a half-width; divisor sqrt(3).
    Rectangular,
    /// The value is a half-width; divisor sqrt(6).
    Triangular,
    /// The value is an amplitude of an arcsine law; divisor sqrt(2).
    UShaped,
    /// Any other law, known by its divisor.
    Special {
        /// Value over standard uncertainty.
        divisor: f64,
        /// Drawn as `value * U1 * U2 * cos(angle)` with rectangular U1, U2 and
        /// angle: unknown transverse motion against an unknown transverse
        /// sensitivity (Table D.1 Note 3, divisor sqrt(18)). Other special
        /// laws are drawn as normal.
        transverse: bool,
    },
}

impl Distribution {
    /// Value over standard uncertainty.
    pub fn divisor(self) -> f64 {
        match self {
            Self::Normal { coverage_factor } => coverage_factor,
            Self::Rectangular => 3.0_f64.sqrt(),
            Self::Triangular => 6.0_f64.sqrt(),
            Self::UShaped => 2.0_f64.sqrt(),
            Self::Special { divisor, .. } => divisor,
        }
    }

    /// As the budget file spells it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Normal { .. } => "normal",
            Self::Rectangular => "rectangular",
            Self::Triangular => "triangular",
            Self::UShaped => "u_shaped",
            Self::Special { .. } => "special",
        }
    }
}

/// One component of a budget.
#[derive(Clone, Debug, PartialEq)]
pub struct Component {
    /// Name, unique within the budget.
    pub label: String,
    /// Half-width, or expanded uncertainty for [`Distribution::Normal`], in
    /// the unit of the budget; never negative.
    pub value: f64,
    /// Assumed distribution.
    pub distribution: Distribution,
    /// Partial derivative of the measurand; in relative budgets the exponent.
    pub sensitivity_coefficient: f64,
    /// Degrees of freedom of the standard uncertainty, above zero or infinite.
    pub degrees_of_freedom: f64,
}

impl Component {
    /// Standard uncertainty, in the unit of the budget.
    pub fn standard_uncertainty(&self) -> f64 {
        self.value / self.distribution.divisor()
    }

    /// `c_i u(x_i)` with the sign of the sensitivity coefficient.
    pub fn signed_contribution(&self) -> f64 {
        self.sensitivity_coefficient * self.standard_uncertainty()
    }
}
