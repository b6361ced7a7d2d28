//! The parameters of a voltage-driven moving-coil exciter.

use serde::Deserialize;
use std::ops::{Index, IndexMut};

/// One entry per parameter of the exciter: its value, or what depends on it.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ExciterParameters<T> {
    /// Armature without payload, in kg.
    pub(crate) moving_mass_kg: T,
    /// Suspension stiffness, in N/m.
    pub(crate) stiffness_n_per_m: T,
    /// Mechanical damping, in N s/m.
    pub(crate) damping_ns_per_m: T,
    /// Force factor Bl, in N/A.
    pub(crate) force_factor_n_per_a: T,
    /// Coil resistance, in ohm.
    pub(crate) coil_resistance_ohm: T,
    /// Coil inductance at 1 kHz, in H.
    pub(crate) coil_inductance_h: T,
}

/// A parameter of the exciter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ExciterParameter {
    MovingMass,
    Stiffness,
    Damping,
    ForceFactor,
    CoilResistance,
    CoilInductance,
}

impl ExciterParameter {
    /// All of them, in the order of the nuisances.
    pub(crate) const ALL: [Self; 6] = [
        Self::MovingMass,
        Self::Stiffness,
        Self::Damping,
        Self::ForceFactor,
        Self::CoilResistance,
        Self::CoilInductance,
    ];

    /// Name in `rig.toml` and in JSON.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::MovingMass => "moving_mass_kg",
            Self::Stiffness => "stiffness_n_per_m",
            Self::Damping => "damping_ns_per_m",
            Self::ForceFactor => "force_factor_n_per_a",
            Self::CoilResistance => "coil_resistance_ohm",
            Self::CoilInductance => "coil_inductance_h",
        }
    }
}

impl<T: Copy> ExciterParameters<T> {
    /// Gives every parameter one value.
    pub(crate) const fn all(value: T) -> Self {
        Self {
            moving_mass_kg: value,
            stiffness_n_per_m: value,
            damping_ns_per_m: value,
            force_factor_n_per_a: value,
            coil_resistance_ohm: value,
            coil_inductance_h: value,
        }
    }

    /// Parameter by parameter.
    pub(crate) fn map<U>(self, of: impl Fn(T) -> U) -> ExciterParameters<U> {
        ExciterParameters {
            moving_mass_kg: of(self.moving_mass_kg),
            stiffness_n_per_m: of(self.stiffness_n_per_m),
            damping_ns_per_m: of(self.damping_ns_per_m),
            force_factor_n_per_a: of(self.force_factor_n_per_a),
            coil_resistance_ohm: of(self.coil_resistance_ohm),
            coil_inductance_h: of(self.coil_inductance_h),
        }
    }
}

impl ExciterParameters<Option<Quantity>> {
    /// The quantities, if all are known: else the exciter is not simulated.
    pub(crate) fn complete(&self) -> Option<ExciterParameters<Quantity>> {
        Some(ExciterParameters {
            moving_mass_kg: self.moving_mass_kg?,
            stiffness_n_per_m: self.stiffness_n_per_m?,
            damping_ns_per_m: self.damping_ns_per_m?,
            force_factor_n_per_a: self.force_factor_n_per_a?,
            coil_resistance_ohm: self.coil_resistance_ohm?,
            coil_inductance_h: self.coil_inductance_h?,
        })
    }
}

impl<T> Index<ExciterParameter> for ExciterParameters<T> {
    type Output = T;

    fn index(&self, parameter: ExciterParameter) -> &T {
        match parameter {
            ExciterParameter::MovingMass => &self.moving_mass_kg,
            ExciterParameter::Stiffness => &self.stiffness_n_per_m,
            ExciterParameter::Damping => &self.damping_ns_per_m,
            ExciterParameter::ForceFactor => &self.force_factor_n_per_a,
            ExciterParameter::CoilResistance => &self.coil_resistance_ohm,
            ExciterParameter::CoilInductance => &self.coil_inductance_h,
        }
    }
}

impl<T> IndexMut<ExciterParameter> for ExciterParameters<T> {
    fn index_mut(&mut self, parameter: ExciterParameter) -> &mut T {
        match parameter {
            ExciterParameter::MovingMass => &mut self.moving_mass_kg,
            ExciterParameter::Stiffness => &mut self.stiffness_n_per_m,
            ExciterParameter::Damping => &mut self.damping_ns_per_m,
            ExciterParameter::ForceFactor => &mut self.force_factor_n_per_a,
            ExciterParameter::CoilResistance => &mut self.coil_resistance_ohm,
            ExciterParameter::CoilInductance => &mut self.coil_inductance_h,
        }
    }
}

/// A value and its standard uncertainty in the unit of the entry (0 = exact).
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Quantity {
    /// Best estimate.
    pub(crate) value: f64,
    /// Standard uncertainty.
    pub(crate) u: f64,
}

impl Quantity {
    /// Relative standard uncertainty.
    pub(crate) fn relative_u(self) -> f64 {
        self.u / self.value
    }
}
