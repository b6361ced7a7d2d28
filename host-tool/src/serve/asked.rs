//! Requests of a page: measurements, and sensors to be registered.

use super::view::{Measured, RunView};
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
    /// Measures again what has no valid result in the last run, refused or never tried, of its device and at its
    /// levels.
    pub(super) retry: bool,
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
            retry: false,
        }
    }
}

impl Run {
    /// The point list; the default one when no frequency was named, what is left of the last run for a retry.
    pub(super) fn points(&self, last: Option<&RunView>) -> Result<Vec<PointSpec>> {
        if self.retry {
            let left = last.map(RunView::without_result).unwrap_or_default();
            return match left.is_empty() {
                false => Ok(left),
                true => Err(usage("there is nothing to measure again")),
            };
        }
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

    /// The measured quantity: that of the last run for a retry, else the one that is named.
    pub(super) fn measured(&self, logbook: &Path, last: Option<&RunView>) -> Result<Measured> {
        match last.filter(|_| self.retry) {
            Some(last) => {
                let mut again = last.measured.clone();
                again.labels.unix_time_s = unix_time_s();
                again.kept = last.valid();
                Ok(again)
            }
            None => self.named(logbook),
        }
    }

    /// A sensor of the logbook by its serial number, or what was typed.
    fn named(&self, logbook: &Path) -> Result<Measured> {
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
        let labels = RunLabels {
            unix_time_s: unix_time_s(),
            dut_model: label("model", &known.name())?,
            dut_serial: label("serial number", &known.serial)?,
            operator: label("operator", &self.operator)?,
            temperature_centi_c: temperature_centi_c("the temperature", self.temperature_c)?,
            mounting: label("mounting", &mounting)?,
        };
        Ok(Measured {
            labels,
            kind: known.kind()?,
            kept: Vec::new(),
        })
    }
}

/// The body of `POST /api/sensors`, beside [`AboutSensor`].
#[derive(Default, Deserialize)]
#[serde(default)]
struct Named {
    serial: Option<String>,
    /// Hexadecimal digits of a virtual TEDS.
    teds: Option<String>,
}

/// A sensor to be registered.
pub(super) struct NewSensor {
    named: Named,
    about: AboutSensor,
}

impl NewSensor {
    /// Reads both out of one object. Flattened into one another no number would be one: a dependency has serde_json
    /// keep the digits of numbers, and serde takes what is kept for a map.
    pub(super) fn read(body: serde_json::Value) -> Result<Self> {
        let unusable = |error: serde_json::Error| usage(&error.to_string());
        Ok(Self {
            named: serde_json::from_value(body.clone()).map_err(unusable)?,
            about: serde_json::from_value(body).map_err(unusable)?,
        })
    }

    /// Enters it in the logbook, which is made if there is none.
    pub(super) fn register(self, logbook: &Path) -> Result<Sensor> {
        let sensor = match (self.named.teds, self.named.serial) {
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
