//! Conversion between sensitivities to acceleration, velocity, displacement.

use crate::text::{significant, table};
use calib_core::quantity::{MotionQuantity, Sensitivity};
use schemars::JsonSchema;
use serde::Serialize;

/// A motion quantity by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Acceleration, m/s2.
    Acceleration,
    /// Velocity, m/s.
    Velocity,
    /// Displacement, m.
    Displacement,
}

impl Quantity {
    const ALL: [Self; 3] = [Self::Acceleration, Self::Velocity, Self::Displacement];

    fn core(self) -> MotionQuantity {
        match self {
            Self::Acceleration => MotionQuantity::Acceleration,
            Self::Velocity => MotionQuantity::Velocity,
            Self::Displacement => MotionQuantity::Displacement,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Acceleration => "acceleration",
            Self::Velocity => "velocity",
            Self::Displacement => "displacement",
        }
    }

    /// Unit of a sensitivity to it.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Acceleration => "V/(m/s2)",
            Self::Velocity => "V/(m/s)",
            Self::Displacement => "V/m",
        }
    }
}

/// A sensitivity to one quantity.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Converted {
    /// Quantity.
    pub quantity: Quantity,
    /// Magnitude, V per SI unit of the quantity.
    pub sensitivity: f64,
    /// Unit of the magnitude.
    pub unit: &'static str,
    /// Phase, degrees, in (-180, 180].
    pub phase_deg: f64,
}

/// Sensitivity of one transducer to all three quantities (clause 6 a, b).
pub fn convert(
    from: Quantity,
    sensitivity: f64,
    phase_deg: f64,
    frequency_hz: f64,
) -> [Converted; 3] {
    let known = Sensitivity {
        quantity: from.core(),
        magnitude: sensitivity as f32,
        phase_rad: phase_deg.to_radians() as f32,
    };
    Quantity::ALL.map(|quantity| {
        let found = known.to(quantity.core(), frequency_hz as f32);
        Converted {
            quantity,
            sensitivity: f64::from(found.magnitude),
            unit: quantity.unit(),
            phase_deg: f64::from(found.phase_rad).to_degrees(),
        }
    })
}

/// The three as a table.
pub fn conversion_report(converted: &[Converted], frequency_hz: f64) -> String {
    let rows: Vec<Vec<String>> = converted
        .iter()
        .map(|one| {
            vec![
                one.quantity.name().into(),
                format!("{} {}", significant(one.sensitivity, 6), one.unit),
                format!("{:.3} deg", one.phase_deg),
            ]
        })
        .collect();
    let header = ["sensitivity to", "magnitude", "phase"];
    format!("At {frequency_hz} Hz\n\n{}", table(&header, &rows))
}
