//! Parts that a check of the reference by reciprocity adds to a calibrator: the coil's current or voltage in
//! place of a device, a mass on the table, and the side effects of real ones.

use serde::{Deserialize, Serialize};

/// Quantity the device's input reads in place of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CoilInput {
    /// Voltage of the shunt: the coil's current.
    Shunt,
    /// Divided voltage of coil and shunt.
    Divider,
}

/// Coil sensing and an added mass.
///
/// # Equation
/// ```text
/// amplifier --+-- coil --- shunt --- ground      armature --(table)-- table --(seat)-- mass
///             +-- divider
/// ```
/// The shunt is in the circuit whatever is read. Table and seat are springs with dampers; a table of 0 kg
/// is rigid, a mass of 0 kg not there.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reciprocity {
    /// Quantity that is read.
    pub input: CoilInput,
    /// Resistance of the shunt, ohm.
    pub shunt_ohm: f64,
    /// Its inductance, H.
    pub shunt_inductance_h: f64,
    /// Output of the divider for a volt across coil and shunt.
    pub divider_volt_per_v: f64,
    /// Corner of the divider with its cable, Hz.
    pub divider_corner_hz: f64,
    /// Added mass, kg.
    pub mass_kg: f64,
    /// Stiffness between table and mass, N/m.
    pub seat_n_per_m: f64,
    /// Damping there, N s/m.
    pub seat_ns_per_m: f64,
    /// Part of the moving mass that is the table, kg.
    pub table_kg: f64,
    /// Stiffness between armature and table, N/m.
    pub table_n_per_m: f64,
    /// Damping there, N s/m.
    pub table_ns_per_m: f64,
    /// Voltage the coil's field induces in the reference's channel, V for 1 A/s.
    pub stray_h: f64,
    /// Voltage of the coil's field in phase with the current, V/A.
    pub stray_ohm: f64,
    /// Acceleration that rocking by a mass off the axis adds at the reference far above the mode, relative.
    pub rocking_rel: f64,
    /// Frequency of the rocking mode, Hz.
    pub rocking_hz: f64,
    /// Its quality factor.
    pub rocking_quality: f64,
}
