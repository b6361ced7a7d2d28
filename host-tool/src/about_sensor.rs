//! Statements about a sensor when it is registered: by options of a verb, and by the page.

use crate::number::{finite, positive};
use crate::{Error, Result};
use calib_certificate::SensorKind;
use calib_certificate::decision::Tolerance;
use calib_logbook::Sensor;
use calib_metrology::teds;
use clap::Args;
use serde::{Deserialize, Deserializer};
use std::fmt;
use std::str::FromStr;

/// Statements about a sensor.
#[derive(Debug, Default, Args, Deserialize)]
#[serde(default)]
pub struct AboutSensor {
    /// Manufacturer.
    #[arg(long, value_name = "TEXT")]
    manufacturer: Option<String>,
    /// Model.
    #[arg(long, value_name = "TEXT")]
    model: Option<String>,
    /// Nominal sensitivity, in the unit of --unit.
    #[arg(long, value_name = "NUMBER", value_parser = positive::<f64>)]
    sensitivity: Option<f64>,
    /// Unit its sensitivity is specified in, which is its kind: mV/(m/s2), mV/g, mV/(mm/s), mV/um; "pC/g at 10 mV/pC
    /// +-0.5%", with the gain of the charge amplifier and its U (k = 2); "mA/(mm/s) at 250 ohm +-0.1%", with the burden
    /// [default: mV/(m/s2)].
    #[arg(long, value_name = "UNIT")]
    #[serde(deserialize_with = "as_typed")]
    unit: Option<SensorKind>,
    /// Tolerance it is judged by: percent of nominal, such as 5; 5:nominal:reference (at the
    /// reference point alone), 10:reference:20-5000 (of the reference point, 20 Hz to 5 kHz),
    /// 2:last (of its last calibration), -5/+10:nominal; several after commas; or api670.
    #[arg(long, value_name = "TOLERANCE", allow_hyphen_values = true)]
    #[serde(deserialize_with = "as_typed")]
    tolerance: Option<Tolerance>,
    /// Measuring range, m/s2 peak.
    #[arg(long, value_name = "MS2", value_parser = positive::<f64>)]
    range: Option<f64>,
    /// Mounted resonance by its data sheet, Hz: what a sweep shows is compared with it.
    #[arg(long, value_name = "HZ", value_parser = finite::<f64>)]
    resonance: Option<f64>,
    /// Whether it has IEPE electronics.
    #[arg(long, value_name = "true|false")]
    iepe: Option<bool>,
    /// How it is mounted for calibration.
    #[arg(long, value_name = "TEXT")]
    mounting: Option<String>,
    /// Who it belongs to.
    #[arg(long, value_name = "NAME")]
    owner: Option<String>,
    /// Day the next calibration is due, such as 2027-11-20.
    #[arg(long = "due", value_name = "DAY")]
    due_day: Option<String>,
}

fn as_typed<'de, D, T>(stated: D) -> std::result::Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
    T: FromStr<Err: fmt::Display>,
{
    let text = Option::<String>::deserialize(stated)?;
    let parsed = text.map(|text| text.parse().map_err(serde::de::Error::custom));
    parsed.transpose()
}

impl AboutSensor {
    /// The sensor with what is stated here in place of what it had.
    ///
    /// # Errors
    /// Those of the sensor's unit; [`Error::Usage`] when it becomes one of another quantity, of which no sensitivity
    /// is known.
    pub fn onto(self, sensor: Sensor) -> Result<Sensor> {
        let before = sensor.kind()?;
        let kind = self.unit.unwrap_or(before);
        let kept = sensor.sensitivity.filter(|_| self.sensitivity.is_none());
        if let (Some(_), Err(problem)) = (kept, before.shown_in(kind.unit())) {
            let hint = "state its nominal sensitivity anew with --sensitivity";
            return Err(Error::usage(problem, hint));
        }
        Ok(Sensor {
            unit: Some(kind.to_string()),
            tolerance: self.tolerance.map(|t| t.to_string()).or(sensor.tolerance),
            manufacturer: self.manufacturer.unwrap_or(sensor.manufacturer),
            model: self.model.unwrap_or(sensor.model),
            sensitivity: self
                .sensitivity
                .map(|stated| kind.unit().to_si(stated))
                .or(kept),
            range_ms2: self.range.or(sensor.range_ms2),
            resonance_hz: self.resonance.or(sensor.resonance_hz),
            iepe: self.iepe.or(sensor.iepe),
            mounting: self.mounting.or(sensor.mounting),
            owner: self.owner.or(sensor.owner),
            due_day: self.due_day.or(sensor.due_day),
            ..sensor
        })
    }
}

/// A sensor of which nothing but its serial number is known.
pub fn of_serial(serial: String) -> Sensor {
    Sensor {
        serial,
        ..Sensor::default()
    }
}

/// The sensor that a TEDS describes, by its own serial number or by `serial`. Numbers of maker and model stay
/// numbers: their lists are not public.
pub fn from_teds(read: &teds::Accelerometer, bytes: Vec<u8>, serial: Option<String>) -> Sensor {
    let basic = &read.basic;
    Sensor {
        manufacturer: format!("IEEE 1451.4 manufacturer {}", basic.manufacturer_id),
        model: format!(
            "{} {}{}",
            basic.model_number, basic.version_letter, basic.version_number
        ),
        sensitivity: read.sensitivity_v_per_ms2,
        resonance_hz: read.resonance_hz,
        // Template 25 is for constant current supply alone.
        iepe: Some(true),
        due_day: read.due().map(|day| day.to_string()),
        teds: Some(bytes),
        ..of_serial(serial.unwrap_or_else(|| basic.serial_number.to_string()))
    }
}
