//! Check standards: sensors that are measured for no customer, to see that the calibrator still gives what it gave.

use super::Logbook;
use super::journal::Subject;
use calib_files::{Error, Result};
use rusqlite::{OptionalExtension, params};
use schemars::JsonSchema;
use serde::Serialize;

/// A sensor that is a check standard.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckStandard {
    /// Serial number of the sensor.
    #[serde(rename = "dut_serial")]
    pub serial: String,
    /// Frequency it is compared at, Hz.
    pub frequency_hz: f64,
    /// Days after which it has to be measured again.
    pub every_days: u32,
    /// Sensitivity there on its own certificate, V/(m/s2), and its relative expanded uncertainty (k = 2).
    pub certified: Option<Certified>,
}

/// Certified values of a check standard.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Certified {
    /// Sensitivity, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Relative expanded uncertainty (k = 2).
    pub expanded_uncertainty_rel: f64,
}

const COLUMNS: &str =
    "serial, frequency_hz, every_days, certified_v_per_ms2, certified_expanded_uncertainty_rel";

impl CheckStandard {
    fn check(&self) -> Result<()> {
        let above = |value: f64| value.is_finite() && value > 0.0;
        let certified = self.certified.is_none_or(|certified| {
            above(certified.sensitivity_v_per_ms2) && above(certified.expanded_uncertainty_rel)
        });
        match self.every_days > 0 && above(self.frequency_hz) && certified {
            true => Ok(()),
            false => Err(Error::usage(
                "days, frequency and what is certified are above zero",
                "see `calib assure --help`",
            )),
        }
    }

    fn from_row(row: &rusqlite::Row<'_>) -> rusqlite::Result<Self> {
        let certified: (Option<f64>, Option<f64>) = (row.get(3)?, row.get(4)?);
        let certified = certified.0.zip(certified.1);
        Ok(Self {
            serial: row.get(0)?,
            frequency_hz: row.get(1)?,
            every_days: row.get(2)?,
            certified: certified.map(|(sensitivity_v_per_ms2, expanded_uncertainty_rel)| {
                Certified {
                    sensitivity_v_per_ms2,
                    expanded_uncertainty_rel,
                }
            }),
        })
    }
}

impl Logbook {
    /// Names a sensor of the logbook a check standard, or states anew what it is.
    ///
    /// # Errors
    /// [`Error::Usage`] when a value cannot be, [`Error::Input`] when the sensor is not there.
    pub fn put_check_standard(&self, standard: &CheckStandard) -> Result<()> {
        standard.check()?;
        let serial = self.known_sensor(&standard.serial)?.serial;
        let put =
            format!("INSERT OR REPLACE INTO check_standards ({COLUMNS}) VALUES (?1,?2,?3,?4,?5)");
        let certified = standard.certified;
        let values = params![
            serial,
            standard.frequency_hz,
            standard.every_days,
            certified.map(|c| c.sensitivity_v_per_ms2),
            certified.map(|c| c.expanded_uncertainty_rel),
        ];
        self.change(Subject::CheckStandard, &serial, &put, values)
    }

    /// Takes the name of check standard from a sensor; its records stay.
    ///
    /// # Errors
    /// [`Error::Input`] when it is none.
    pub fn remove_check_standard(&self, serial: &str) -> Result<()> {
        let Some(standard) = self.check_standard(serial)? else {
            return Err(Error::input(
                format!("sensor {serial}"),
                "is no check standard",
                "`calib assure` lists those there are",
            ));
        };
        let remove = "DELETE FROM check_standards WHERE serial = ?1";
        self.change(
            Subject::CheckStandard,
            &standard.serial,
            remove,
            [&standard.serial],
        )
    }

    /// The check standard of this serial number, if it is one; capitals do not matter.
    ///
    /// # Errors
    /// Those of the file.
    pub fn check_standard(&self, serial: &str) -> Result<Option<CheckStandard>> {
        let find =
            format!("SELECT {COLUMNS} FROM check_standards WHERE serial = ?1 COLLATE NOCASE");
        self.connection
            .query_row(&find, [serial], CheckStandard::from_row)
            .optional()
            .map_err(|error| self.failure(error))
    }

    /// All check standards.
    ///
    /// # Errors
    /// Those of the file.
    pub fn check_standards(&self) -> Result<Vec<CheckStandard>> {
        let find = format!("SELECT {COLUMNS} FROM check_standards ORDER BY serial");
        self.all(&find, [], CheckStandard::from_row)
    }
}
