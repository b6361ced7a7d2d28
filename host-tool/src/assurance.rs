//! Check standards and references of the logbook: how each stands, what they show together, and which certificates they
//! block.

use crate::self_check::{self, ReferenceState, day};
use crate::{Error, Result};
use calib_certificate::{CheckProblem, FailedCheck, StandardPoint};
use calib_logbook::{CheckStandard, HistoryResult, Logbook};
use calib_metrology::common_drift::{CommonDrift, Measured, common_drift};
use calib_metrology::control_chart::{ControlChart, FEWEST, Signal, control_chart, e_n};
use calib_protocol::record::{self, Record};
use jiff::Timestamp;
use schemars::JsonSchema;
use serde::Serialize;

/// Seconds of a day.
const DAY_S: i64 = 86_400;
/// Seconds of a Julian year.
const YEAR_S: f64 = 31_557_600.0;
/// Row of Table A.1 that allows for the drift of the reference.
const DRIFT_ROW: u8 = 10;

/// How a check standard stands.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct CheckState {
    /// The check standard itself.
    #[serde(flatten)]
    pub standard: CheckStandard,
    /// Its results.
    pub results: usize,
    /// Time of the latest, s since 1970-01-01 UTC; none without a result.
    pub last_unix_time_s: Option<i64>,
    /// The latest is older than it may be.
    pub overdue: bool,
    /// Signals against the latest; empty with fewer than six results.
    pub signals: Vec<Signal>,
    /// The latest against its certificate: beyond 1 the two do not agree; none where none is stated.
    pub e_n: Option<f64>,
    /// The chart can judge.
    pub judged: bool,
    /// Neither chart nor certificate speaks against it.
    pub in_control: bool,
    /// Control charts for level and scatter; none with fewer than six results.
    pub chart: Option<Charts>,
}

/// Control charts of a check standard: each result within limits by those before the latest, and each difference from
/// the result before it below a limit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Charts {
    /// Times of the results, s since 1970-01-01 UTC, oldest first.
    pub unix_times_s: Vec<i64>,
    /// Results, V/(m/s2).
    pub sensitivities_v_per_ms2: Vec<f64>,
    /// Relative expanded uncertainty of each.
    pub expanded_uncertainties_rel: Vec<f64>,
    /// Mean of the results before the latest, V/(m/s2).
    pub mean_v_per_ms2: f64,
    /// Limits in which 99.73 % of sound results are, V/(m/s2).
    pub lower_v_per_ms2: f64,
    /// Upper one of these limits, V/(m/s2).
    pub upper_v_per_ms2: f64,
    /// Limit of the differences, which sound ones exceed in 0.92 %, V/(m/s2).
    pub range_limit_v_per_ms2: f64,
}

impl Charts {
    fn of(results: &[HistoryResult], chart: &ControlChart) -> Self {
        let of = |number: fn(&HistoryResult) -> f64| results.iter().map(number).collect();
        Self {
            unix_times_s: results.iter().map(|result| result.unix_time_s).collect(),
            sensitivities_v_per_ms2: of(|result| result.sensitivity_v_per_ms2),
            expanded_uncertainties_rel: of(|result| result.expanded_uncertainty_rel),
            mean_v_per_ms2: chart.mean,
            lower_v_per_ms2: chart.mean - chart.half_width,
            upper_v_per_ms2: chart.mean + chart.half_width,
            range_limit_v_per_ms2: chart.range_limit,
        }
    }

    /// Difference of each result but the first from the one before, V/(m/s2).
    pub fn ranges_v_per_ms2(&self) -> impl Iterator<Item = f64> {
        let pairs = self.sensitivities_v_per_ms2.windows(2);
        pairs.map(|pair| (pair[1] - pair[0]).abs())
    }
}

/// All check standards, and the references that were checked.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct AssuranceReport {
    /// Each of them.
    pub standards: Vec<CheckState>,
    /// References that were checked by reciprocity.
    pub references: Vec<ReferenceState>,
    /// Drift the check standards share; none with too few results.
    pub common_drift: Option<CommonDrift>,
    /// Relative drift the budget of the latest result allows for the reference, row 10.
    pub allowed_drift_rel: Option<f64>,
    /// Advised interval between calibrations of the reference, years (ILAC-G24).
    pub reference_interval_years: Option<f64>,
}

/// Every check standard at a time (s since 1970-01-01 UTC), and what they show together.
///
/// # Errors
/// Those of the logbook.
pub fn report(logbook: &Logbook, at_s: i64) -> Result<AssuranceReport> {
    let (mut standards, mut series, mut latest) = (Vec::new(), Vec::new(), None::<HistoryResult>);
    for standard in logbook.check_standards()? {
        let results = logbook.results(&standard.serial, standard.frequency_hz)?;
        series.extend(by_instrument(&results));
        let newer =
            |known: &HistoryResult, found: &HistoryResult| found.unix_time_s > known.unix_time_s;
        if let Some(last) = results.last()
            && latest.as_ref().is_none_or(|known| newer(known, last))
        {
            latest = Some(last.clone());
        }
        standards.push(state(standard, &results, at_s));
    }
    let common_drift = common_drift(&series);
    let allowed_drift_rel = match &latest {
        Some(latest) => allowed_drift_rel(&logbook.record(latest.record)?),
        None => None,
    };
    let interval = common_drift.zip(allowed_drift_rel);
    Ok(AssuranceReport {
        standards,
        references: self_check::states(logbook)?,
        common_drift,
        allowed_drift_rel,
        reference_interval_years: interval.map(|(drift, allowed)| drift.interval_years(allowed)),
    })
}

/// Results of one standard, apart by instrument: each has a reference of its own.
fn by_instrument(results: &[HistoryResult]) -> Vec<Vec<Measured>> {
    let mut all: Vec<(&str, Vec<Measured>)> = Vec::new();
    for result in results {
        let measured = Measured {
            years: result.unix_time_s as f64 / YEAR_S,
            sensitivity: result.sensitivity_v_per_ms2,
        };
        match all.iter_mut().find(|(name, _)| *name == result.instrument) {
            Some((_, series)) => series.push(measured),
            None => all.push((&result.instrument, vec![measured])),
        }
    }
    all.into_iter().map(|(_, series)| series).collect()
}

/// Half-width of row 10 in the settings of a record.
fn allowed_drift_rel(stored: &[u8]) -> Option<f64> {
    let record = record::decode(stored).ok()?;
    let rows = record.settings.influences.iter();
    let rows = rows.filter(|row| row.row == DRIFT_ROW);
    rows.map(|row| f64::from(row.value_rel)).reduce(f64::max)
}

/// A check standard at a time, by its results so far.
fn state(standard: CheckStandard, results: &[HistoryResult], at_s: i64) -> CheckState {
    let values: Vec<f64> = results.iter().map(|r| r.sensitivity_v_per_ms2).collect();
    let chart = control_chart(&values);
    let latest = results.last();
    let e_n = latest.and_then(|latest| against_certificate(&standard, latest));
    let judged = chart.is_some();
    let charts = chart.as_ref().map(|chart| Charts::of(results, chart));
    let signals = chart.map(|chart| chart.signals).unwrap_or_default();
    let last_unix_time_s = latest.map(|result| result.unix_time_s);
    CheckState {
        results: results.len(),
        last_unix_time_s,
        overdue: last_unix_time_s.is_none_or(|latest_s| is_overdue(&standard, latest_s, at_s)),
        in_control: signals.is_empty() && e_n.is_none_or(|e_n| e_n.abs() <= 1.0),
        judged,
        signals,
        e_n,
        standard,
        chart: charts,
    }
}

/// E_n of a result against the standard's own certificate, where one is stated.
pub fn against_certificate(standard: &CheckStandard, result: &HistoryResult) -> Option<f64> {
    let (certified, value) = (standard.certified?, result.sensitivity_v_per_ms2);
    let reference = certified.sensitivity_v_per_ms2;
    Some(e_n(
        value,
        value * result.expanded_uncertainty_rel,
        reference,
        reference * certified.expanded_uncertainty_rel,
    ))
}

fn is_overdue(standard: &CheckStandard, latest_s: i64, at_s: i64) -> bool {
    at_s - latest_s > i64::from(standard.every_days) * DAY_S
}

impl CheckState {
    /// How it stands, in words.
    pub fn words(&self) -> String {
        let mut words = vec![control_words(self.in_control, self.judged)];
        if self.overdue {
            words.push("OVERDUE".to_owned());
        }
        words.join(", ")
    }
}

impl ReferenceState {
    /// How it stands, in words.
    pub fn words(&self) -> String {
        control_words(self.in_control, self.judged)
    }
}

fn control_words(in_control: bool, judged: bool) -> String {
    match (in_control, judged) {
        (false, _) => "OUT OF CONTROL".to_owned(),
        (true, true) => "in control".to_owned(),
        (true, false) => format!("no chart before {FEWEST} results"),
    }
}

/// Check standards that speak against a certificate of this record: by what was measured with its instrument
/// until then, and by what was measured since.
///
/// # Errors
/// Those of the logbook.
pub fn failed_checks(logbook: Option<&Logbook>, record: &Record) -> Result<Vec<FailedCheck>> {
    let Some(logbook) = logbook else {
        return Ok(Vec::new());
    };
    let at_s = match i64::try_from(record.head.labels.unix_time_s) {
        Ok(at_s) if at_s > 0 => at_s,
        _ => Timestamp::now().as_second(),
    };
    let mut failed = Vec::new();
    for standard in logbook.check_standards()? {
        // Its own records are what it is judged by.
        if standard
            .serial
            .eq_ignore_ascii_case(&record.head.labels.dut_serial)
        {
            continue;
        }
        let mut results = logbook.results(&standard.serial, standard.frequency_hz)?;
        let instrument = record.head.instrument_serial.as_str();
        results.retain(|result| result.instrument == instrument);
        let serial = standard.serial.clone();
        if let Some(problem) = problem(standard, &results, at_s) {
            failed.push(FailedCheck { serial, problem });
        }
    }
    Ok(failed)
}

/// Statements of the certificate of a check standard.
///
/// # Errors
/// Those of the logbook, and [`Error::Files`] where nobody stated it.
pub fn certified(logbook: Option<&Logbook>, serial: &str) -> Result<Vec<StandardPoint>> {
    let known = match logbook {
        Some(logbook) => logbook.check_standard(serial)?,
        None => None,
    };
    let stated = known.and_then(|known| {
        let certified = known.certified?;
        Some(StandardPoint {
            frequency_hz: known.frequency_hz,
            sensitivity_v_per_ms2: certified.sensitivity_v_per_ms2,
            expanded_uncertainty_rel: certified.expanded_uncertainty_rel,
        })
    });
    let stated = stated.ok_or_else(|| {
        Error::input(
            format!("standard {serial}"),
            "nobody stated its sensitivity",
            "name the table of its certificate with --standard, or state it at one frequency: \
             `calib assure SERIAL --every DAYS --certified MV --certified-u PERCENT`",
        )
    })?;
    Ok(vec![stated])
}

fn problem(standard: CheckStandard, all: &[HistoryResult], at_s: i64) -> Option<CheckProblem> {
    let before = all.partition_point(|result| result.unix_time_s <= at_s);
    let then = state(standard.clone(), &all[..before], at_s);
    let Some(latest_s) = then.last_unix_time_s else {
        return Some(CheckProblem::Never);
    };
    if !then.in_control {
        return Some(CheckProblem::OutOfControl(day(latest_s)));
    }
    let since = state(standard, all, at_s);
    let since_s = since.last_unix_time_s.unwrap_or(latest_s);
    match (since.in_control, then.overdue) {
        (false, _) => Some(CheckProblem::OutOfControl(day(since_s))),
        (true, true) => Some(CheckProblem::Overdue(day(latest_s))),
        (true, false) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EVERY_DAYS: u32 = 7;

    fn standard() -> CheckStandard {
        CheckStandard {
            serial: "C".into(),
            frequency_hz: 160.0,
            every_days: EVERY_DAYS,
            certified: None,
        }
    }

    /// A result on each of these days; ten of 10 mV that scatter by 0.1 % are in control.
    fn results(values: &[f64]) -> Vec<HistoryResult> {
        let one = |(day, value): (i64, &f64)| HistoryResult {
            record: day,
            record_id: day as u32,
            unix_time_s: day * DAY_S,
            instrument: "CAL".into(),
            frequency_hz: 160.0,
            sensitivity_v_per_ms2: *value,
            sensitivity: 1e3 * *value,
            expanded_uncertainty_rel: 0.01,
            drift_rel: None,
            u_drift_rel: None,
            e_n: None,
            drift_exceeds_uncertainty: false,
        };
        (1..).zip(values).map(one).collect()
    }

    const SOUND: [f64; 10] = [
        1.0, 1.001, 0.999, 1.0005, 0.9995, 1.0, 1.001, 0.999, 1.0005, 0.9995,
    ];

    #[test]
    fn what_speaks_against_a_certificate() {
        let with = |more: &[f64]| results(&[&SOUND[..], more].concat());
        let at = |all: &[HistoryResult], day: i64| problem(standard(), all, day * DAY_S);
        let sound = with(&[]);
        assert_eq!(at(&sound, 10), None);
        assert_eq!(at(&sound, 17), None);
        let overdue = CheckProblem::Overdue(jiff::civil::Date::constant(1970, 1, 11));
        assert_eq!(at(&sound, 18), Some(overdue));
        assert_eq!(at(&sound, 0), Some(CheckProblem::Never));
        // 1 % off on the eleventh day: what was calibrated then, and what has no certificate yet.
        let off = CheckProblem::OutOfControl(jiff::civil::Date::constant(1970, 1, 12));
        assert_eq!(at(&with(&[1.01]), 12), Some(off));
        assert_eq!(at(&with(&[1.01]), 10), Some(off));
        // A sound result after it is one for later jobs alone.
        assert_eq!(at(&with(&[1.01, 1.0]), 11), Some(off));
    }

    /// Eleven results, the last 1 % off: one chart of them, one of the ten differences, and what speaks against it.
    #[test]
    fn the_report_has_charts_of_level_and_scatter_and_says_what_is_out_of_control() {
        let named = CheckStandard {
            serial: "<C&1>".into(),
            ..standard()
        };
        let state = state(named, &results(&[&SOUND[..], &[1.01]].concat()), 12 * DAY_S);
        let charts = state.chart.as_ref().expect("eleven results");
        let ranges: Vec<f64> = charts.ranges_v_per_ms2().collect();
        assert_eq!(ranges.len(), 10);
        // 1.01 after 0.9995; the mean of the nine before is 0.00128, times 3.267.
        assert!((ranges[9] - 0.0105).abs() < 1e-12);
        let limit = 3.267 * 0.0115 / 9.0;
        assert!(
            (charts.range_limit_v_per_ms2 - limit).abs() < 1e-9,
            "{charts:?}"
        );
        let report = AssuranceReport {
            standards: vec![state],
            references: Vec::new(),
            common_drift: None,
            allowed_drift_rel: None,
            reference_interval_years: None,
        };
        let page = crate::assurance_report::html(&report, 12 * DAY_S).expect("renders");
        for said in [
            "OUT OF CONTROL",
            "outside of the limits",
            "&lt;C&amp;1&gt;",
            "1970-01-13",
        ] {
            assert!(page.contains(said), "{said}: {page}");
        }
        assert_eq!(page.matches("<svg").count(), 2);
        assert!(!page.contains("NaN") && !page.contains("<C&"));
    }

    /// 2 % off at U = 1 % and 0.5 %: E_n = 0.02 / 0.0113.
    #[test]
    fn a_certificate_of_its_own_judges_from_the_first_result_on() {
        let certified = calib_logbook::Certified {
            sensitivity_v_per_ms2: 1.0,
            expanded_uncertainty_rel: 0.005,
        };
        let standard = CheckStandard {
            certified: Some(certified),
            ..standard()
        };
        let state = state(standard, &results(&[1.02]), 2 * DAY_S);
        let expected = 0.02 / (0.0102_f64.powi(2) + 0.005_f64.powi(2)).sqrt();
        assert!((state.e_n.expect("stated") - expected).abs() < 1e-9);
        assert!(!state.judged && !state.in_control && !state.overdue);
    }

    #[test]
    fn another_instrument_has_another_reference() {
        let mut all = results(&SOUND[..4]);
        all[3].instrument = "CAL-2".into();
        let lengths: Vec<usize> = by_instrument(&all).iter().map(Vec::len).collect();
        assert_eq!(lengths, [3, 1]);
    }
}
