//! Drift of one sensor over its calibrations, beside the uncertainty.

use super::Logbook;
use calib_certificate::{
    SensitivityUnit, certified_uncertainty_rel, expanded_uncertainty_of_change_rel,
};
use calib_protocol::record;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of one calibration.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Result {
    /// Key of the record in the logbook.
    #[serde(rename = "logbook_record")]
    pub record: i64,
    /// Number of the record, its instrument's.
    pub record_id: u32,
    /// Time of the calibration, s since 1970-01-01 UTC.
    pub unix_time_s: i64,
    /// Serial number of the instrument it was made with.
    #[serde(rename = "instrument_serial")]
    pub instrument: String,
    /// Nominal frequency of the point, Hz.
    pub frequency_hz: f64,
    /// Sensitivity as it was measured, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Sensitivity of the sensor, in the unit of the history.
    pub sensitivity: f64,
    /// Its relative expanded uncertainty, as a certificate of the record states it.
    pub expanded_uncertainty_rel: f64,
    /// Relative change since the calibration before; none for the first.
    pub drift_rel: Option<f64>,
    /// Expanded uncertainty of that change: what both calibrations share is not in it.
    #[serde(rename = "expanded_uncertainty_drift_rel")]
    pub u_drift_rel: Option<f64>,
    /// Change over its expanded uncertainty.
    pub e_n: Option<f64>,
    /// True when E_n is beyond 1: the sensor drifted, or something happened to it.
    pub drift_exceeds_uncertainty: bool,
}

/// All calibrations of a sensor at one frequency, oldest first.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct History {
    /// Serial number of the sensor.
    #[serde(rename = "dut_serial")]
    pub sensor: String,
    /// Frequency compared, Hz.
    pub frequency_hz: f64,
    /// Unit of `sensitivity`: that the sensor is specified in.
    pub unit: &'static str,
    /// Results of the calibrations.
    pub results: Vec<Result>,
}

impl Logbook {
    /// The calibrations of a sensor at `frequency_hz` (within 1 %), one per
    /// record: at several levels, the first that passed.
    ///
    /// # Errors
    /// Those of the file.
    pub fn history(&self, sensor: &str, frequency_hz: f64) -> calib_files::Result<History> {
        let mut results = self.results(sensor, frequency_hz)?;
        let u_of_change =
            |before: &Result, now: &Result| self.u_of_change(before, now, frequency_hz);
        state_drift(&mut results, u_of_change);
        let kind = self.kind_of(sensor)?;
        for result in &mut results {
            let si = kind.of_v_per_ms2(result.sensitivity_v_per_ms2, result.frequency_hz);
            result.sensitivity = kind.unit().of_si(si);
        }
        Ok(History {
            sensor: sensor.to_owned(),
            frequency_hz,
            unit: kind.unit().name(),
            results,
        })
    }

    /// [`Self::history`] without changes, oldest first.
    ///
    /// # Errors
    /// Those of the file.
    pub fn results(&self, sensor: &str, frequency_hz: f64) -> calib_files::Result<Vec<Result>> {
        let sql = "SELECT records.id, unix_time_s, points.sensitivity_v_per_ms2,
                   points.expanded_uncertainty_rel, instrument, points.frequency_hz,
                   number, min(position)
                   FROM records JOIN points ON record = id
                   WHERE sensor_serial = ?1 AND state = 'valid'
                   AND frequency_hz BETWEEN 0.99 * ?2 AND 1.01 * ?2
                   AND points.sensitivity_v_per_ms2 IS NOT NULL
                   AND points.expanded_uncertainty_rel IS NOT NULL
                   GROUP BY records.id ORDER BY unix_time_s, records.id";
        let mut results = self.all(sql, rusqlite::params![sensor, frequency_hz], |row| {
            Ok(Result {
                record: row.get(0)?,
                record_id: row.get(6)?,
                unix_time_s: row.get(1)?,
                frequency_hz: row.get(5)?,
                sensitivity_v_per_ms2: row.get(2)?,
                sensitivity: SensitivityUnit::default().of_si(row.get(2)?),
                expanded_uncertainty_rel: row.get(3)?,
                instrument: row.get(4)?,
                drift_rel: None,
                u_drift_rel: None,
                e_n: None,
                drift_exceeds_uncertainty: false,
            })
        })?;
        for result in &mut results {
            let bytes = self.record(result.record)?;
            let record = record::decode(&bytes).ok();
            let certified = record.and_then(|one| certified_uncertainty_rel(&one, frequency_hz));
            // The instrument's, where no budget can be made.
            result.expanded_uncertainty_rel = certified.unwrap_or(result.expanded_uncertainty_rel);
        }
        Ok(results)
    }
}

impl Logbook {
    /// Expanded uncertainty of the change between two results, from the budgets of their records; where those
    /// give none, that of results that share nothing.
    fn u_of_change(&self, before: &Result, now: &Result, frequency_hz: f64) -> f64 {
        let record = |result: &Result| {
            let bytes = self.record(result.record).ok()?;
            record::decode(&bytes).ok()
        };
        let from_budgets = || {
            let (before, now) = (record(before)?, record(now)?);
            expanded_uncertainty_of_change_rel(&before, &now, frequency_hz)
        };
        from_budgets().unwrap_or_else(|| {
            let [before, now] = [before, now].map(|result| result.expanded_uncertainty_rel);
            before.hypot(now)
        })
    }

    /// Sensitivities of a sensor's last record before a time: Hz and V/(m/s2), the first
    /// level of each frequency.
    pub(super) fn last_calibration(
        &self,
        sensor: &str,
        before_s: i64,
    ) -> calib_files::Result<Vec<(f64, f64)>> {
        let sql = "SELECT frequency_hz, points.sensitivity_v_per_ms2, min(position)
                   FROM points WHERE sensitivity_v_per_ms2 IS NOT NULL AND record =
                   (SELECT id FROM records WHERE sensor_serial = ?1 AND unix_time_s < ?2
                    AND reference_frequency_hz IS NOT NULL
                    ORDER BY unix_time_s DESC, id DESC LIMIT 1)
                   GROUP BY frequency_hz ORDER BY frequency_hz";
        let row = |row: &rusqlite::Row<'_>| Ok((row.get(0)?, row.get(1)?));
        self.all(sql, rusqlite::params![sensor, before_s], row)
    }
}

/// Drift of each result since the one before, judged by the uncertainty of the change.
fn state_drift(results: &mut [Result], u_of_change: impl Fn(&Result, &Result) -> f64) {
    for index in 1..results.len() {
        let (before, now) = (&results[index - 1], &results[index]);
        let drift_rel = now.sensitivity_v_per_ms2 / before.sensitivity_v_per_ms2 - 1.0;
        let u_rel = u_of_change(before, now);
        let e_n = drift_rel / u_rel;
        let result = &mut results[index];
        result.drift_rel = Some(drift_rel);
        result.u_drift_rel = Some(u_rel);
        result.e_n = Some(e_n).filter(|e_n| e_n.is_finite());
        result.drift_exceeds_uncertainty = e_n.abs() > 1.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_within_the_uncertainty_is_none() {
        let result = |sensitivity_v_per_ms2, expanded_uncertainty_rel| Result {
            record: 1,
            record_id: 1,
            unix_time_s: 0,
            instrument: String::new(),
            frequency_hz: 160.0,
            sensitivity_v_per_ms2,
            sensitivity: 1e3 * sensitivity_v_per_ms2,
            expanded_uncertainty_rel,
            drift_rel: None,
            u_drift_rel: None,
            e_n: None,
            drift_exceeds_uncertainty: false,
        };
        // + 0.9 % within 1 %, then + 1.1 % beyond it, then - 1.5 % within 2 %.
        let mut results = [
            result(1.0, 0.01),
            result(1.009, 0.01),
            result(1.009 * 1.011, 0.01),
            result(1.009 * 1.011 * 0.985, 0.02),
        ];
        state_drift(&mut results, |before, now| {
            before
                .expanded_uncertainty_rel
                .max(now.expanded_uncertainty_rel)
        });
        let exceeds = results.each_ref().map(|r| r.drift_exceeds_uncertainty);
        assert_eq!(exceeds, [false, false, true, false]);
        assert_eq!((results[0].drift_rel, results[0].e_n), (None, None));
        assert!((results[2].e_n.expect("judged") - 1.1).abs() < 1e-9);
        // f64 rounding of the products above.
        assert!((results[2].drift_rel.expect("drift") - 0.011).abs() < 1e-12);
    }
}
