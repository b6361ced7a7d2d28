//! Conditions along which a deviation may vary.

use crate::model::row::Row;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// Condition along which a deviation varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Frequency, in Hz.
    Frequency,
    /// Level, r.m.s., in m/s2.
    Level,
    /// In proportion to one over the level; its range is that of the level.
    InverseLevel,
    /// Travel of the table, r.m.s., in m.
    Travel,
    /// Time since the first point, in s.
    Time,
    /// Mass on the armature, in kg.
    Payload,
    /// Temperature above the reference temperature, in K.
    Temperature,
    /// Rotation of the device under test, in degrees.
    Rotation,
    /// Coil voltage, peak, in V.
    CoilVoltage,
    /// Size of the output of an oscillator, in the unit of the record.
    Amplitude,
}

impl Axis {
    /// Conditions of the rows of a table.
    pub(crate) const CONDITIONS: [Self; 8] = [
        Self::Frequency,
        Self::Level,
        Self::Travel,
        Self::Time,
        Self::Payload,
        Self::Temperature,
        Self::Rotation,
        Self::CoilVoltage,
    ];

    /// Value of a row on the axis; NaN where it is not known, and for an oscillator's axis.
    pub(crate) fn value(self, row: &Row) -> f64 {
        match self {
            Self::Frequency => row.frequency_hz,
            Self::Level | Self::InverseLevel => row.level_ms2,
            Self::Travel => row.travel_m(),
            Self::Time => row.time_s,
            Self::Payload => row.payload_kg,
            Self::Temperature => row.warmer_k,
            Self::Rotation => row.rotation.1.atan2(row.rotation.0).to_degrees(),
            Self::CoilVoltage => row.coil_peak_v,
            Self::Amplitude => f64::NAN,
        }
    }

    /// Name in JSON and in the terminal.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Frequency => "frequency_hz",
            Self::Level => "acceleration_ms2",
            Self::InverseLevel => "inverse_level",
            Self::Travel => "travel_m",
            Self::Time => "time_s",
            Self::Payload => "payload_kg",
            Self::Temperature => "temperature_above_reference_k",
            Self::Rotation => "rotation_deg",
            Self::CoilVoltage => "coil_v",
            Self::Amplitude => "amplitude",
        }
    }
}

impl Serialize for Axis {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl JsonSchema for Axis {
    fn schema_name() -> Cow<'static, str> {
        "Axis".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let others = [Self::InverseLevel, Self::Amplitude];
        let all = Self::CONDITIONS.into_iter().chain(others);
        json_schema!({
            "description": "Condition along which a deviation varies.",
            "type": "string",
            "enum": all.map(Self::name).collect::<Vec<_>>()
        })
    }
}
