//! Sensors: what is known about a device under test, typed once.

use super::Logbook;
use super::journal::Subject;
use calib_certificate::decision::Tolerance;
use calib_certificate::{Known, SensorKind, Specified};
use calib_files::{Error, Result};
use calib_output::number::shortened;
use calib_protocol::text::is_plain;
use rusqlite::{OptionalExtension, params};
use schemars::JsonSchema;
use serde::Serialize;

/// A transducer that comes for calibration.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
#[serde(into = "SensorView")]
pub struct Sensor {
    /// Serial number; a logbook has each once.
    pub serial: String,
    /// Manufacturer.
    pub manufacturer: String,
    /// Model.
    pub model: String,
    /// Nominal sensitivity, SI unit of its kind.
    pub sensitivity: Option<f64>,
    /// Measuring range, m/s2 peak.
    pub range_ms2: Option<f64>,
    /// Mounted resonance by its data sheet, Hz.
    pub resonance_hz: Option<f64>,
    /// True when it has IEPE electronics.
    pub iepe: Option<bool>,
    /// How it is mounted for calibration.
    pub mounting: Option<String>,
    /// Who it belongs to.
    pub owner: Option<String>,
    /// Day the next calibration is due, ISO 8601.
    pub due_day: Option<String>,
    /// Tolerance it is judged by, such as `5:nominal`; see [`Tolerance`].
    pub tolerance: Option<String>,
    /// Its kind: the unit its sensitivity is specified in, such as `mV/g`, with what stands before the input; see
    /// [`SensorKind`].
    pub unit: Option<String>,
    /// The virtual TEDS it was made of.
    pub teds: Option<Vec<u8>>,
}

/// [`Sensor`] as programs read it.
#[derive(Clone, Serialize, JsonSchema)]
struct SensorView {
    /// Serial number; a logbook has each once.
    serial: String,
    /// Manufacturer.
    manufacturer: String,
    /// Model.
    model: String,
    /// Nominal sensitivity, in the unit that `unit` begins with.
    sensitivity: Option<f64>,
    /// Nominal sensitivity, V/(m/s2); none for sensors of another kind.
    sensitivity_v_per_ms2: Option<f64>,
    /// Measuring range, m/s2 peak.
    range_ms2: Option<f64>,
    /// Mounted resonance by its data sheet, Hz.
    resonance_hz: Option<f64>,
    /// True when it has IEPE electronics.
    iepe: Option<bool>,
    /// How it is mounted for calibration.
    mounting: Option<String>,
    /// Who it belongs to.
    owner: Option<String>,
    /// Day the next calibration is due, ISO 8601.
    due_day: Option<String>,
    /// Tolerance it is judged by, such as `5:nominal`.
    tolerance: Option<String>,
    /// Its kind: the unit its sensitivity is specified in, such as `mV/g`, with what stands before the input, such as
    /// `pC/g at 10 mV/pC +-0.5%`.
    unit: Option<String>,
}

impl From<Sensor> for SensorView {
    fn from(sensor: Sensor) -> Self {
        let kind = sensor.kind().ok();
        let in_unit = kind.zip(sensor.sensitivity);
        let as_measured = kind.is_some_and(SensorKind::is_as_measured);
        Self {
            serial: sensor.serial,
            manufacturer: sensor.manufacturer,
            model: sensor.model,
            sensitivity: in_unit.map(|(kind, si)| shortened(kind.unit().of_si(si), 12)),
            sensitivity_v_per_ms2: sensor.sensitivity.filter(|_| as_measured),
            range_ms2: sensor.range_ms2,
            resonance_hz: sensor.resonance_hz,
            iepe: sensor.iepe,
            mounting: sensor.mounting,
            owner: sensor.owner,
            due_day: sensor.due_day,
            tolerance: sensor.tolerance,
            unit: sensor.unit,
        }
    }
}

/// Mounted resonances there are, from a seat pad to a shock sensor.
const RESONANCES_HZ: std::ops::RangeInclusive<f64> = 500.0..=1.0e6;

const COLUMNS: &str = "serial, manufacturer, model, sensitivity, range_ms2, iepe, \
                       mounting, owner, due_day, teds, tolerance, unit, resonance_hz";

/// The fault of `2,5` for a tolerance.
pub const TWICE: &str = "a tolerance states two limits for the same frequencies: a decimal is written 2.5, with a point";

impl Sensor {
    /// Manufacturer and model, as a record names it.
    pub fn name(&self) -> String {
        format!("{} {}", self.manufacturer, self.model)
            .trim()
            .to_owned()
    }

    /// Its kind.
    ///
    /// # Errors
    /// [`Error::Input`] when the logbook names one there is not.
    pub fn kind(&self) -> Result<SensorKind> {
        let place = || format!("sensor {}", self.serial);
        let hint = "state it anew with `calib sensors change`";
        match self.unit.as_deref().map(str::parse) {
            None => Ok(SensorKind::default()),
            Some(unit) => unit.map_err(|problem: String| Error::input(place(), problem, hint)),
        }
    }

    fn texts(&self) -> impl Iterator<Item = &str> {
        let stated = [&self.mounting, &self.owner].into_iter().flatten();
        [&self.serial, &self.manufacturer, &self.model]
            .into_iter()
            .chain(stated)
            .map(String::as_str)
    }

    fn check(&self) -> Result<()> {
        let wrong = |what: &str| Err(Error::usage(what, "see `calib sensors add --help`"));
        let positive = |value: Option<f64>| value.is_none_or(|v| v.is_finite() && v > 0.0);
        if self.serial.trim().is_empty() {
            return wrong("a sensor has a serial number");
        }
        if !self.texts().all(is_plain) {
            return wrong("what is said about a sensor is one line, without control characters");
        }
        if !positive(self.sensitivity) {
            return wrong("a sensitivity is a number above zero");
        }
        if !positive(self.range_ms2) {
            return wrong("a measuring range is a number above zero");
        }
        let plausible = |hz: f64| RESONANCES_HZ.contains(&hz);
        if !self.resonance_hz.is_none_or(plausible) {
            return wrong("a mounted resonance is between 500 Hz and 1 MHz, stated in Hz");
        }
        let tolerance = self.tolerance.as_deref().map(str::parse::<Tolerance>);
        if let Some(Err(problem)) = &tolerance {
            return wrong(problem);
        }
        if let Some(Ok(tolerance)) = &tolerance
            && tolerance.repeats()
        {
            return wrong(TWICE);
        }
        let of_nominal = matches!(&tolerance, Some(Ok(tolerance)) if tolerance.needs_nominal());
        if of_nominal && self.sensitivity.is_none() {
            return wrong("a tolerance of nominal needs the nominal sensitivity");
        }
        let kind = self.kind()?;
        if kind.is_reported_only() && tolerance.is_some() {
            return wrong("a transmitter with a current is reported only: it has no tolerance");
        }
        if matches!(tolerance, Some(Ok(Tolerance::Api670))) && !kind.is_as_measured() {
            return wrong("API 670 is for accelerometers of 100 mV/g");
        }
        let day = self.due_day.as_deref();
        if day.is_some_and(|day| day.parse::<jiff::civil::Date>().is_err()) {
            return wrong("the due day looks like 2027-11-20");
        }
        Ok(())
    }

    fn from_row(row: &rusqlite::Row<'_>) -> rusqlite::Result<Self> {
        Ok(Self {
            serial: row.get(0)?,
            manufacturer: row.get(1)?,
            model: row.get(2)?,
            sensitivity: row.get(3)?,
            range_ms2: row.get(4)?,
            iepe: row.get(5)?,
            mounting: row.get(6)?,
            owner: row.get(7)?,
            due_day: row.get(8)?,
            teds: row.get(9)?,
            tolerance: row.get(10)?,
            unit: row.get(11)?,
            resonance_hz: row.get::<_, Option<i64>>(12)?.map(|hz| hz as f64),
        })
    }
}

impl Logbook {
    /// Adds a sensor.
    ///
    /// # Errors
    /// [`Error::Usage`] when a value cannot be; [`Error::Input`] when the logbook
    /// has this serial number already.
    pub fn add_sensor(&self, sensor: &Sensor) -> Result<()> {
        if let Some(known) = self.sensor(&sensor.serial)? {
            return Err(Error::input(
                format!("sensor {}", known.serial),
                format!("is in the logbook already: {}", known.name()),
                "change it with `calib sensors change`",
            ));
        }
        self.put_sensor(sensor)
    }

    /// Adds a sensor, or replaces what is known about it.
    ///
    /// # Errors
    /// [`Error::Usage`] when a value cannot be.
    pub fn put_sensor(&self, sensor: &Sensor) -> Result<()> {
        sensor.check()?;
        let values = params![
            sensor.serial,
            sensor.manufacturer,
            sensor.model,
            sensor.sensitivity,
            sensor.range_ms2,
            sensor.iepe,
            sensor.mounting,
            sensor.owner,
            sensor.due_day,
            sensor.teds,
            sensor.tolerance,
            sensor.unit,
            sensor.resonance_hz.map(|hz| hz.round() as i64),
        ];
        let put = format!(
            "INSERT OR REPLACE INTO sensors ({COLUMNS}) VALUES (?1,?2,?3,?4,?5,?6,?7,?8,?9,?10,?11,?12,?13)"
        );
        self.change(Subject::Sensor, &sensor.serial, &put, values)
    }

    /// Removes a sensor; its records and certificates stay.
    ///
    /// # Errors
    /// [`Error::Input`] when it is not there.
    pub fn remove_sensor(&self, serial: &str) -> Result<Sensor> {
        let sensor = self.known_sensor(serial)?;
        let remove = "DELETE FROM sensors WHERE serial = ?1";
        self.change(Subject::Sensor, &sensor.serial, remove, [&sensor.serial])?;
        Ok(sensor)
    }

    /// The sensor of this serial number, if the logbook has it; capitals do not matter.
    ///
    /// # Errors
    /// Those of the file.
    pub fn sensor(&self, serial: &str) -> Result<Option<Sensor>> {
        let find = format!(
            "SELECT {COLUMNS} FROM sensors WHERE serial = ?1 COLLATE NOCASE
             ORDER BY serial = ?1 DESC LIMIT 1"
        );
        self.connection
            .query_row(&find, [serial], Sensor::from_row)
            .optional()
            .map_err(|error| self.failure(error))
    }

    /// Kind of a sensor; an accelerometer with a voltage where nobody registered it.
    ///
    /// # Errors
    /// Those of the file.
    pub fn kind_of(&self, serial: &str) -> Result<SensorKind> {
        let sensor = self.sensor(serial)?;
        sensor.map_or(Ok(SensorKind::default()), |sensor| sensor.kind())
    }

    /// Knowledge of this sensor needed to judge a run begun at this time (s since 1970-01-01 UTC):
    /// nominal sensitivity, tolerance, and the calibration before.
    ///
    /// # Errors
    /// Those of the file.
    pub fn known(&self, serial: &str, unix_time_s: u64) -> Result<Known> {
        let Some(sensor) = self.sensor(serial)? else {
            return Ok(Known::default());
        };
        let tolerance = sensor.tolerance.as_deref().map(str::parse::<Tolerance>);
        let place = || format!("sensor {}", sensor.serial);
        let hint = "state it anew with `calib sensors change`";
        let tolerance = tolerance.transpose();
        let before_s = i64::try_from(unix_time_s).unwrap_or(i64::MAX);
        let kind = sensor.kind()?;
        let nominal = |si| Specified::of_si(si, kind.unit());
        Ok(Known {
            // Of one that was entered before there were kinds nobody has said any.
            kind: sensor.unit.is_some().then_some(kind),
            nominal: sensor.sensitivity.map(nominal),
            resonance_hz: sensor.resonance_hz,
            tolerance: tolerance.map_err(|problem| Error::input(place(), problem, hint))?,
            last: self.last_calibration(&sensor.serial, before_s)?,
        })
    }

    /// As [`Self::sensor`].
    ///
    /// # Errors
    /// [`Error::Input`] when it is not there.
    pub fn known_sensor(&self, serial: &str) -> Result<Sensor> {
        self.sensor(serial)?.ok_or_else(|| {
            Error::input(
                format!("sensor {serial}"),
                format!("is not in the logbook {}", self.path.display()),
                "`calib sensors list` shows what is, `calib sensors add` adds one",
            )
        })
    }

    /// Sensors whose serial number, maker, model or owner holds `text`.
    ///
    /// # Errors
    /// Those of the file.
    pub fn sensors(&self, text: &str) -> Result<Vec<Sensor>> {
        let find = format!(
            "SELECT {COLUMNS} FROM sensors
             WHERE instr(lower(serial || ' ' || manufacturer || ' ' || model || ' '
                               || coalesce(owner, '')), lower(?1)) > 0
             ORDER BY manufacturer, model, serial"
        );
        self.all(&find, [text], Sensor::from_row)
    }
}
