//! Requests of a page: measurements, and sensors to be registered.

use crate::about_sensor::{self, AboutSensor};
use crate::clock::unix_time_s;
use crate::{Error, Result};
use calib_core::point::PointSpec;
use calib_link::session::{self, label, temperature_centi_c};
use calib_logbook::{Logbook, Sensor};
use calib_metrology::teds;
use calib_protocol::record::RunLabels;
use serde::Deserialize;
use std::path::Path;

/// The body of `POST /api/run`.
#[derive(Deserialize)]
#[serde(default)]
pub(super) struct Run {
    sensor: String,
    dut_model: String,
    dut_serial: String,
    operator: String,
    mounting: String,
    set_acceleration_rms_ms2: f32,
    temperature_c: Option<f64>,
    frequencies_hz: Vec<f32>,
}

impl Default for Run {
    fn default() -> Self {
        Self {
            sensor: String::new(),
            dut_model: String::new(),
            dut_serial: String::new(),
            operator: String::new(),
            mounting: String::new(),
            set_acceleration_rms_ms2: 10.0,
            temperature_c: None,
            frequencies_hz: Vec::new(),
        }
    }
}

impl Run {
    /// The point list; the default one when no frequency was named.
    pub(super) fn points(&self) -> Result<Vec<PointSpec>> {
        let usable = |value: f32| value.is_finite() && value > 0.0;
        let all = self.frequencies_hz.iter().copied().all(usable);
        if !usable(self.set_acceleration_rms_ms2) || !all {
            return Err(usage("frequencies and level are numbers above zero"));
        }
        if self.frequencies_hz.is_empty() {
            return Ok(session::default_points(self.set_acceleration_rms_ms2));
        }
        let point = |frequency_hz: &f32| PointSpec {
            frequency_hz: *frequency_hz,
            acceleration_rms_ms2: self.set_acceleration_rms_ms2,
        };
        Ok(self.frequencies_hz.iter().map(point).collect())
    }

    /// A sensor of the logbook by its serial number, or what was typed.
    pub(super) fn labels(&self, logbook: &Path) -> Result<RunLabels> {
        // Who names no sensor waits for no logbook.
        let logbook = match self.sensor.as_str() {
            "" => None,
            _ => Logbook::open_if_there(logbook)?,
        };
        let known = match logbook {
            Some(logbook) => logbook.known_sensor(&self.sensor)?,
            None => Sensor {
                serial: self.dut_serial.clone(),
                model: self.dut_model.clone(),
                ..Sensor::default()
            },
        };
        let mounting = match self.mounting.as_str() {
            "" => known.mounting.clone().unwrap_or_default(),
            stated => stated.to_owned(),
        };
        Ok(RunLabels {
            unix_time_s: unix_time_s(),
            dut_model: label("model", &known.name())?,
            dut_serial: label("serial number", &known.serial)?,
            operator: label("operator", &self.operator)?,
            temperature_centi_c: temperature_centi_c("the temperature", self.temperature_c)?,
            mounting: label("mounting", &mounting)?,
        })
    }
}

/// The body of `POST /api/sensors`.
#[derive(Default, Deserialize)]
#[serde(default)]
pub(super) struct NewSensor {
    serial: Option<String>,
    /// Hexadecimal digits of a virtual TEDS.
    teds: Option<String>,
    #[serde(flatten)]
    about: AboutSensor,
}

impl NewSensor {
    /// Enters it in the logbook, which is made if there is none.
    pub(super) fn register(self, logbook: &Path) -> Result<Sensor> {
        let sensor = match (self.teds, self.serial) {
            (Some(digits), serial) => {
                let (read, bytes) = teds::parse("the TEDS", digits.into_bytes())?;
                about_sensor::from_teds(&read, bytes, serial)
            }
            (None, Some(serial)) => about_sensor::of_serial(serial),
            (None, None) => return Err(usage("a sensor has a serial number")),
        };
        let sensor = self.about.onto(sensor)?;
        Logbook::open(logbook)?.add_sensor(&sensor)?;
        Ok(sensor)
    }
}

fn usage(problem: &str) -> Error {
    Error::usage(problem, "")
}
