//! `calib convert`: a sensitivity as that to another motion quantity.

use super::Context;
use super::number::{finite, reachable};
use calib_host::{Error, Result};
use calib_metrology::sensitivity::{self, Converted, Quantity};
use clap::{Args, ValueEnum};
use schemars::JsonSchema;
use serde::Serialize;

/// Names of [`Quantity`] on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum QuantityName {
    /// Acceleration, m/s2.
    Acceleration,
    /// Velocity, m/s.
    Velocity,
    /// Displacement, m.
    Displacement,
}

impl From<QuantityName> for Quantity {
    fn from(name: QuantityName) -> Self {
        match name {
            QuantityName::Acceleration => Self::Acceleration,
            QuantityName::Velocity => Self::Velocity,
            QuantityName::Displacement => Self::Displacement,
        }
    }
}

/// `calib convert --frequency F --sensitivity S`.
#[derive(Debug, Args)]
pub(crate) struct Convert {
    /// Frequency, Hz.
    #[arg(long, value_name = "HZ", value_parser = finite::<f64>)]
    frequency: f64,
    /// Magnitude of the sensitivity, V per SI unit.
    #[arg(long, value_name = "V", value_parser = finite::<f64>)]
    sensitivity: f64,
    /// Its phase, degrees.
    #[arg(
        long,
        value_name = "DEG",
        default_value_t = 0.0,
        allow_negative_numbers = true,
        value_parser = finite::<f64>
    )]
    phase: f64,
    /// Quantity it refers to.
    #[arg(long, value_enum, default_value_t = QuantityName::Acceleration)]
    from: QuantityName,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Output {
    frequency_hz: f64,
    sensitivities: [Converted; 3],
}

impl Convert {
    /// Converts and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        if self.frequency <= 0.0 || self.sensitivity <= 0.0 {
            return Err(Error::usage(
                "--frequency and --sensitivity are numbers above zero",
                "an inverted transducer has --phase 180",
            ));
        }
        reachable("--frequency", self.frequency)?;
        let (from, hz) = (self.from.into(), self.frequency);
        let output = Output {
            frequency_hz: hz,
            sensitivities: sensitivity::convert(from, self.sensitivity, self.phase, hz),
        };
        context.print(&output, || {
            sensitivity::conversion_report(&output.sensitivities, hz)
        })
    }
}
