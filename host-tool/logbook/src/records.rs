//! Records of both kinds: kept as they were downloaded, listed by what people look for.

use super::Logbook;
use super::Sensor;
use super::journal::{self, Subject};
use super::keys::place;
use calib_certificate::{Certificate, Particulars, SensorKind};
use calib_core::point::PointResult;
use calib_core::point_state::PointState;
use calib_core::settings::Settings;
use calib_files::{Error, Result};
use calib_protocol::change::{self, ReferenceChange};
use calib_protocol::record::{self, Record, RecordError, RecordHead, RecordKind, Sha256Sum};
use rusqlite::{Connection, OptionalExtension, Transaction, params};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::HashMap;

/// Fate of a record that was handed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// It is new, under this number of the logbook.
    Added(i64),
    /// The logbook has it already, under this number.
    Known(i64),
}

/// One line of the list.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Listed {
    /// Key in the logbook.
    #[serde(rename = "logbook_record")]
    pub id: i64,
    /// Serial number of the instrument.
    #[serde(rename = "instrument_serial")]
    pub instrument: String,
    /// Number of the record, its instrument's.
    #[serde(rename = "record_id")]
    pub number: u32,
    /// Seconds since 1970-01-01 UTC; none when the time was not known.
    pub unix_time_s: Option<i64>,
    /// Serial number of the sensor.
    #[serde(rename = "dut_serial")]
    pub sensor_serial: String,
    /// Its maker and model.
    #[serde(rename = "dut_model")]
    pub sensor_model: String,
    /// Who calibrated.
    pub operator: String,
    /// Points in the record.
    pub points: u32,
    /// Points refused.
    pub refused: u32,
    /// A calibration, or the log of a change of settings, which has no points.
    #[schemars(with = "&str")]
    pub kind: RecordKind,
    /// Frequency of the reference point (clause 5.3), Hz.
    pub reference_frequency_hz: Option<f64>,
    /// Sensitivity there as it was measured, V/(m/s2).
    pub sensitivity_v_per_ms2: Option<f64>,
    /// Sensitivity of the sensor there, in `unit`.
    pub sensitivity: Option<f64>,
    /// Unit the sensor is specified in.
    pub unit: &'static str,
    /// Its relative expanded uncertainty by the instrument, which knows neither temperature nor mount: a certificate
    /// states another.
    pub expanded_uncertainty_rel: Option<f64>,
}

impl Listed {
    /// States the sensitivity of a sensor of this kind.
    fn state(&mut self, kind: SensorKind) {
        let measured = self.sensitivity_v_per_ms2.zip(self.reference_frequency_hz);
        let si = measured.map(|(v_per_ms2, hz)| kind.of_v_per_ms2(v_per_ms2, hz));
        self.sensitivity = si.map(|si| kind.unit().of_si(si));
        self.unit = kind.unit().name();
    }
}

/// Which records are wanted; all by default.
#[derive(Clone, Debug, Default)]
pub struct Filter {
    /// Of this sensor.
    pub sensor: Option<String>,
    /// Measured at this time or later, s since 1970-01-01 UTC.
    pub from_s: Option<i64>,
    /// Measured before this time.
    pub before_s: Option<i64>,
}

/// Way out of a record that cannot be the instrument's.
pub(super) const TRUE_ONE: &str =
    "do not use it; the instrument has the true one: `calib download` gets it";

/// Temperature that adds nothing to a budget, degrees Celsius.
const ROOM_C: f64 = 23.0;
/// Kind of the log of a change of settings, in the tables.
const REFERENCE_CHANGE: &str = "reference_change";

const LISTED: &str = "SELECT id, instrument, number, unix_time_s, sensor_serial, sensor_model,
    operator, points, refused, reference_frequency_hz, sensitivity_v_per_ms2,
    expanded_uncertainty_rel, kind FROM records";

impl Logbook {
    /// Keeps the bytes of a record as `calib download` wrote them. Instrument
    /// and operator are entered too.
    ///
    /// # Errors
    /// [`Error::Input`] when the bytes are no record of this version, when the logbook has another of this
    /// number, and when the signature is not that of the instrument's key.
    pub fn keep(&mut self, bytes: &[u8]) -> Result<Kept> {
        let kept = self.keep_all(std::iter::once(bytes))?;
        kept.into_iter()
            .next()
            .ok_or_else(|| Error::input("record", "was not kept", "report this as a defect"))
    }

    /// Keeps many records, or none of them.
    ///
    /// # Errors
    /// As [`Self::keep`], for the first that fails.
    pub fn keep_all<'a>(&mut self, all: impl IntoIterator<Item = &'a [u8]>) -> Result<Vec<Kept>> {
        let path = self.path.clone();
        let failed = |error| super::store::failure(&path, error);
        let transaction = self.writing().map_err(failed)?;
        let mut kept = Vec::new();
        for bytes in all {
            let content = Content::of(bytes).map_err(|error| {
                Error::input("record", error.to_string(), "download it once more")
            })?;
            if let Some(id) = known(&transaction, bytes).map_err(failed)? {
                kept.push(Kept::Known(id));
                continue;
            }
            let place = place(&transaction, bytes).map_err(failed)?;
            let series = place.map_err(|why| Error::input("record", why, TRUE_ONE))?;
            let new = keep_new(&transaction, bytes, series, &content);
            kept.push(new.map_err(failed)?);
        }
        transaction.commit().map_err(failed)?;
        Ok(kept)
    }

    /// Whether a record with this sum is there.
    ///
    /// # Errors
    /// Those of the file.
    pub fn has(&self, sum: &Sha256Sum) -> Result<bool> {
        let find = "SELECT count(*) FROM records WHERE sha256 = ?1";
        Ok(self.one::<i64>(find, [&sum[..]])? > 0)
    }

    /// Why these bytes cannot be a record of the instrument they name; none when nothing speaks against it.
    ///
    /// # Errors
    /// Those of the file.
    pub(super) fn objection(&self, bytes: &[u8]) -> Result<Option<String>> {
        let found = || match known(&self.connection, bytes)? {
            Some(_) => Ok(None),
            None => Ok(place(&self.connection, bytes)?.err()),
        };
        found().map_err(|error| self.failure(error))
    }

    /// Lines of the records wanted, newest first.
    ///
    /// # Errors
    /// Those of the file.
    pub fn records(&self, filter: &Filter) -> Result<Vec<Listed>> {
        let sql = format!(
            "{LISTED} WHERE unix_time_s >= ?1 AND unix_time_s < ?2 {}
             ORDER BY unix_time_s DESC, id DESC",
            match filter.sensor {
                Some(_) => "AND sensor_serial = ?3",
                None => "AND ?3 IS NULL",
            }
        );
        let from_s = filter.from_s.unwrap_or(i64::MIN);
        let before_s = filter.before_s.unwrap_or(i64::MAX);
        let kinds = self.kinds()?;
        self.all(&sql, params![from_s, before_s, filter.sensor], |row| {
            let mut line = listed(row)?;
            let kind = kinds.get(&line.sensor_serial.to_lowercase());
            line.state(kind.copied().unwrap_or_default());
            Ok(line)
        })
    }

    /// Kinds of the sensors by serial number, whose capitals do not matter. One that this release does not know is
    /// left out.
    fn kinds(&self) -> Result<HashMap<String, SensorKind>> {
        let kind = |sensor: Sensor| Some((sensor.serial.to_lowercase(), sensor.kind().ok()?));
        let sensors = self.sensors("")?;
        Ok(sensors.into_iter().filter_map(kind).collect())
    }

    /// The bytes of an instrument's record, by its running number in this series.
    ///
    /// # Errors
    /// Those of the file; a wrong sum.
    pub fn numbered(&self, instrument: &str, series: i64, number: u32) -> Result<Option<Vec<u8>>> {
        let sql = "SELECT id FROM records WHERE instrument = ?1 AND series = ?2 AND number = ?3";
        let id: Option<i64> = self
            .connection
            .query_row(sql, params![instrument, series, number], |row| row.get(0))
            .optional()
            .map_err(|error| self.failure(error))?;
        id.map(|id| self.record(id)).transpose()
    }

    /// The bytes of the record of this number, of the instrument whose serial number ends so and of this series of its
    /// numbers; any where none is named.
    ///
    /// # Errors
    /// [`Error::Input`] when there is none, or several; a wrong sum.
    pub fn record_of(
        &self,
        number: u32,
        instrument: Option<&str>,
        series: Option<i64>,
    ) -> Result<Vec<u8>> {
        let place = || format!("record {number} of {}", self.path.display());
        let sql = "SELECT id, instrument, series FROM records WHERE number = ?1 ORDER BY instrument, series";
        let all: Vec<(i64, String, i64)> = self.all(sql, [number], |row| {
            Ok((row.get(0)?, row.get(1)?, row.get(2)?))
        })?;
        let wanted = |(_, serial, of): &&(i64, String, i64)| {
            instrument.is_none_or(|end| serial.ends_with(end)) && series.is_none_or(|s| s == *of)
        };
        match all.iter().filter(wanted).collect::<Vec<_>>()[..] {
            [(id, ..)] => self.record(*id),
            [] => Err(Error::input(
                place(),
                "is not there",
                "`calib logbook records` lists them, `calib sync` fetches what is missing",
            )),
            ref several => Err(Error::input(
                place(),
                format!("there are {}: {}", several.len(), of_several(several)),
                "name one with --instrument, and with --series where its instrument began to count anew; `calib logbook get` \
                 writes it into a file",
            )),
        }
    }

    /// Times, s since 1970-01-01 UTC, of the records of an instrument that are next to this number of its series and have
    /// one: with a lower number and with a higher.
    ///
    /// # Errors
    /// Those of the file.
    pub fn times_around(
        &self,
        instrument: &str,
        series: i64,
        number: u32,
    ) -> Result<(Option<u64>, Option<u64>)> {
        let sql = "SELECT
            (SELECT unix_time_s FROM records WHERE instrument = ?1 AND series = ?2 AND number < ?3
             AND unix_time_s > 0 ORDER BY number DESC LIMIT 1),
            (SELECT unix_time_s FROM records WHERE instrument = ?1 AND series = ?2 AND number > ?3
             AND unix_time_s > 0 ORDER BY number LIMIT 1)";
        let time = |time: Option<i64>| time.and_then(|time| u64::try_from(time).ok());
        let row = self
            .connection
            .query_row(sql, params![instrument, series, number], |row| {
                Ok((time(row.get(0)?), time(row.get(1)?)))
            });
        row.map_err(|error| self.failure(error))
    }

    /// The bytes of a record, by its number in the logbook.
    ///
    /// # Errors
    /// [`Error::Input`] when there is none, or its sum is wrong.
    pub fn record(&self, id: i64) -> Result<Vec<u8>> {
        let sql = "SELECT bytes, sha256 FROM contents JOIN records ON id = record WHERE id = ?1";
        let found: Option<(Vec<u8>, Vec<u8>)> = self
            .connection
            .query_row(sql, [id], |row| Ok((row.get(0)?, row.get(1)?)))
            .optional()
            .map_err(|error| self.failure(error))?;
        let place = format!("record {id} of {}", self.path.display());
        match found {
            None => Err(Error::input(
                place,
                "is not there",
                "`calib logbook records` lists them",
            )),
            Some((bytes, sum)) if record::digest(&bytes)[..] == sum[..] => Ok(bytes),
            Some(_) => Err(Error::input(
                place,
                "is damaged: its SHA-256 is not what it was",
                "put the last backup in its place, or download the record once more",
            )),
        }
    }
}

/// Whose they are, in words.
fn of_several(several: &[&(i64, String, i64)]) -> String {
    let of = |(_, serial, series): &&(i64, String, i64)| match series {
        0 => serial.clone(),
        later => format!("{serial} in its series {later}"),
    };
    several.iter().map(of).collect::<Vec<_>>().join(", ")
}

fn listed(row: &rusqlite::Row<'_>) -> rusqlite::Result<Listed> {
    Ok(Listed {
        id: row.get(0)?,
        instrument: row.get(1)?,
        number: row.get(2)?,
        unix_time_s: Some(row.get(3)?).filter(|time_s| *time_s != 0),
        sensor_serial: row.get(4)?,
        sensor_model: row.get(5)?,
        operator: row.get(6)?,
        points: row.get(7)?,
        refused: row.get(8)?,
        reference_frequency_hz: row.get(9)?,
        sensitivity_v_per_ms2: row.get(10)?,
        sensitivity: None,
        unit: "",
        expanded_uncertainty_rel: row.get(11)?,
        kind: match row.get_ref(12)?.as_str()? {
            REFERENCE_CHANGE => RecordKind::ReferenceChange,
            _ => RecordKind::Calibration,
        },
    })
}

/// A record of either kind.
pub(super) enum Content {
    Calibration(Box<Record>),
    ReferenceChange(Box<ReferenceChange>),
}

impl Content {
    pub(super) fn of(bytes: &[u8]) -> Result<Self, RecordError> {
        match record::decode(bytes) {
            Err(RecordError::Kind {
                found: RecordKind::ReferenceChange,
            }) => Ok(Self::ReferenceChange(Box::new(change::decode(bytes)?))),
            other => Ok(Self::Calibration(Box::new(other?))),
        }
    }

    pub(super) fn head(&self) -> &RecordHead {
        match self {
            Self::Calibration(record) => &record.head,
            Self::ReferenceChange(change) => &change.head,
        }
    }

    /// Settings in force from it on.
    fn settings(&self) -> &Settings {
        match self {
            Self::Calibration(record) => &record.settings,
            Self::ReferenceChange(change) => &change.settings,
        }
    }

    pub(super) fn points(&self) -> &[PointResult] {
        match self {
            Self::Calibration(record) => &record.points,
            Self::ReferenceChange(_) => &[],
        }
    }
}

/// Number of a record that is there to the byte.
fn known(connection: &Connection, bytes: &[u8]) -> rusqlite::Result<Option<i64>> {
    connection
        .prepare_cached("SELECT id FROM records WHERE sha256 = ?1")?
        .query_row([&record::digest(bytes)[..]], |row| row.get(0))
        .optional()
}

fn keep_new(
    transaction: &Transaction<'_>,
    bytes: &[u8],
    series: i64,
    content: &Content,
) -> rusqlite::Result<Kept> {
    let id = insert_line(transaction, content, series, record::digest(bytes))?;
    transaction
        .prepare_cached("INSERT INTO contents (record, bytes) VALUES (?1, ?2)")?
        .execute(params![id, bytes])?;
    for (position, point) in content.points().iter().enumerate() {
        insert_point(transaction, id, position as i64, point)?;
    }
    super::people::enter(transaction, content.head(), content.settings())?;
    journal::enter(transaction, Subject::Record, &id.to_string())?;
    Ok(Kept::Added(id))
}

fn insert_line(
    transaction: &Transaction<'_>,
    content: &Content,
    series: i64,
    sum: Sha256Sum,
) -> rusqlite::Result<i64> {
    let kind = match content {
        Content::Calibration(_) => "calibration",
        Content::ReferenceChange(_) => REFERENCE_CHANGE,
    };
    let (complete, certificate) = match content {
        Content::Calibration(record) => {
            // What the list says of a record follows from its bytes, not from what nobody stated.
            let mut particulars = Particulars::default();
            particulars.conditions.ambient_temperature_c = Some(ROOM_C);
            let certificate = Certificate::from_record(record, &particulars);
            (record.complete, Some(certificate))
        }
        Content::ReferenceChange(_) => (true, None),
    };
    let reference = certificate.as_ref().and_then(Certificate::reference_result);
    let (head, points) = (content.head(), content.points());
    let refused = points
        .iter()
        .filter(|point| point.state != PointState::Valid);
    transaction
        .prepare_cached(
            "INSERT INTO records (sha256, instrument, number, unix_time_s, sensor_serial,
             sensor_model, operator, complete, points, refused, reference_frequency_hz,
             sensitivity_v_per_ms2, expanded_uncertainty_rel, kind, series)
             VALUES (?1,?2,?3,?4,?5,?6,?7,?8,?9,?10,?11,?12,?13,?14,?15)",
        )?
        .insert(params![
            &sum[..],
            head.instrument_serial.as_str(),
            head.id,
            i64::try_from(head.labels.unix_time_s).unwrap_or(0),
            head.labels.dut_serial.as_str(),
            head.labels.dut_model.as_str(),
            head.labels.operator.as_str(),
            complete,
            points.len() as i64,
            refused.count() as i64,
            reference.map(|(point, _)| point.nominal_frequency_hz),
            reference.map(|(_, values)| values.sensitivity),
            // The instrument's: conditions that others state later are no part of the list.
            reference.map(
                |(point, _)| 100.0 * f64::from(point.measured.expanded_uncertainty_rel) / 100.0
            ),
            kind,
            series,
        ])
}

/// Numbers of a refused point are diagnostic: the list has none of them.
fn insert_point(
    transaction: &Transaction<'_>,
    record: i64,
    position: i64,
    point: &PointResult,
) -> rusqlite::Result<()> {
    let number = |value: f32| {
        let value = f64::from(value);
        (point.state == PointState::Valid && value.is_finite()).then_some(value)
    };
    transaction
        .prepare_cached("INSERT INTO points VALUES (?1,?2,?3,?4,?5,?6,?7,?8,?9,?10)")?
        .execute(params![
            record,
            position,
            f64::from(point.spec.frequency_hz),
            f64::from(point.spec.acceleration_rms_ms2),
            point.state.to_string(),
            number(point.sensitivity_v_per_ms2),
            number(point.expanded_uncertainty_rel),
            number(point.coverage_factor),
            number(point.phase_rad),
            number(point.expanded_uncertainty_phase_rad),
        ])
        .map(drop)
}
