//! `calib assure`: check standards against their own results, before a job is begun.

use super::history::{SIZE, plot, signed};
use super::sensors::cut;
use crate::cli::{Context, number::positive, time};
use calib_certificate::SensorKind;
use calib_files::file::{self, Existing};
use calib_host::assurance::{self, AssuranceReport, CheckState};
use calib_host::assurance_report;
use calib_host::self_check::ReferenceState;
use calib_host::{Error, Result, terminal};
use calib_logbook::{Certified, CheckStandard, History, HistoryResult, Logbook};
use calib_metrology::common_drift::CommonDrift;
use calib_metrology::control_chart::{ControlChart, FEWEST, Signal, control_chart};
use calib_metrology::text::Table;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// `calib assure [SERIAL]`.
#[derive(Debug, Args)]
#[command(after_help = "\
A check standard is a sensor that is measured for no customer, to see whether the calibrator still
gives what it gave (ISO/IEC 17025, 7.7.1). Name one with --every, measure it with `calib run --sensor`
before a job, and ask here. From then on a certificate of this instrument is refused while its check
standard is out of control or overdue, unless `check_override` under [calibration] gives a reason,
which the certificate prints.

Without SERIAL calib shows every check standard, the drift they show together, which is that of the
reference, and the interval between its calibrations that follows (ILAC-G24). Exit code 7 when one is
out of control or overdue, or does not agree with its certificate.

References checked by `calib selfcheck` are listed with their change since the baseline and a chart. A
significant change, or a chart that speaks against the latest check, is out of control too.")]
pub(crate) struct Assure {
    /// Serial number of the check standard; all of them without.
    serial: Option<String>,
    /// Frequency to compare at, Hz [default: that it was named with, else 160].
    #[arg(long, value_name = "HZ", requires = "serial", value_parser = positive::<f64>)]
    frequency: Option<f64>,
    /// Sensitivity at that frequency on its own certificate, from elsewhere: mV/(m/s2), or what
    /// certificates of its kind state.
    #[arg(long, value_name = "NUMBER", requires_all = ["certified_u", "serial"], value_parser = positive::<f64>)]
    certified: Option<f64>,
    /// Its expanded uncertainty (k = 2), %.
    #[arg(long, value_name = "PERCENT", requires = "certified", value_parser = positive::<f64>)]
    certified_u: Option<f64>,
    /// Names it a check standard that is measured every so many days at least.
    #[arg(long, value_name = "DAYS", requires = "serial", value_parser = clap::value_parser!(u32).range(1..=3650))]
    every: Option<u32>,
    /// Writes the report into a new file, a page that stands alone: charts for level and scatter, E_n, drift, interval.
    #[arg(long, value_name = "FILE.html", conflicts_with = "serial")]
    report: Option<PathBuf>,
    /// Makes it a check standard no longer; its records stay.
    #[arg(long, requires = "serial", conflicts_with_all = ["every", "certified", "frequency"])]
    no_longer: bool,
}

/// The latest result of a check standard judged.
#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Assurance {
    dut_serial: String,
    frequency_hz: f64,
    /// Number of the record judged, its instrument's.
    record_id: u32,
    /// Its key in the logbook.
    logbook_record: i64,
    /// Results before it.
    results_before: usize,
    sensitivity_v_per_ms2: f64,
    /// Mean of the results before it.
    mean_v_per_ms2: f64,
    /// Their standard deviation, by successive differences.
    standard_deviation_v_per_ms2: f64,
    /// Limits in which 99.73 % of sound results are.
    lower_v_per_ms2: f64,
    upper_v_per_ms2: f64,
    /// Signals against it; empty when it is in control.
    signals: Vec<Signal>,
    /// Against its certificate: beyond 1 the two do not agree; null when none is stated.
    e_n: Option<f64>,
    in_control: bool,
}

impl Assure {
    /// Names a check standard, judges one, or reports all.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let logbook = context.logbook()?;
        let Some(serial) = self.serial.as_deref() else {
            return all(context, &logbook, self.report.as_deref());
        };
        if self.no_longer {
            logbook.remove_check_standard(serial)?;
            return all(context, &logbook, None);
        }
        let known = logbook.check_standard(serial)?;
        let standard = self.standard(serial, known, logbook.kind_of(serial)?);
        if self.every.is_some() {
            logbook.put_check_standard(&standard)?;
            return print(context, &assurance::report(&logbook, now_s())?);
        }
        judged(context, &logbook, &standard)
    }

    /// Statements of before, completed by those of now.
    fn standard(
        &self,
        serial: &str,
        known: Option<CheckStandard>,
        kind: SensorKind,
    ) -> CheckStandard {
        let known_every = known.as_ref().map(|known| known.every_days);
        let known_hz = known.as_ref().map(|known| known.frequency_hz);
        let frequency_hz = self.frequency.or(known_hz).unwrap_or(160.0);
        let certified = self.certified.zip(self.certified_u);
        let certified = certified.map(|(stated, percent)| Certified {
            sensitivity_v_per_ms2: kind
                .to_v_per_ms2(kind.stated_unit().to_si(stated), frequency_hz),
            expanded_uncertainty_rel: percent / 100.0,
        });
        CheckStandard {
            serial: serial.to_owned(),
            frequency_hz,
            every_days: self.every.or(known_every).unwrap_or(1),
            certified: certified.or(known.and_then(|known| known.certified)),
        }
    }
}

fn now_s() -> i64 {
    i64::try_from(time::unix_time_s()).unwrap_or(i64::MAX)
}

fn print(context: &Context, report: &AssuranceReport) -> Result<()> {
    context.print(report, || report_text(report))
}

/// Every check standard; none is an error, as one that fails is no pass.
fn all(context: &Context, logbook: &Logbook, into: Option<&Path>) -> Result<()> {
    let report = assurance::report(logbook, now_s())?;
    if let Some(path) = into {
        file::write(
            path,
            assurance_report::html(&report, now_s())?.as_bytes(),
            Existing::Keep,
        )?;
    }
    print(context, &report)?;
    let failed = |state: &&CheckState| state.overdue || !state.in_control;
    let standards = report.standards.iter().filter(failed).count();
    if standards > 0 {
        return Err(Error::NotPassed(format!(
            "{standards} of {} check standards are out of control or overdue",
            report.standards.len()
        )));
    }
    let other = report.references.iter().find(|state| !state.in_control);
    let why = |state: &ReferenceState| {
        format!("the reference {} is out of control", state.reference_serial)
    };
    Error::not_passed(other.map(why))
}

fn report_text(report: &AssuranceReport) -> String {
    let mut text = standards_text(report);
    for state in &report.references {
        text.push_str(&reference_text(state));
    }
    text
}

/// A reference by its checks: chart and judgement.
fn reference_text(state: &ReferenceState) -> String {
    let latest = u64::try_from(state.last_unix_time_s).map_or(String::new(), time::date_and_minute);
    let mut text = format!(
        "\nreference {} of {}: {} by {} checks, the latest {latest}\n",
        state.reference_serial,
        state.instrument_serial,
        state.words(),
        state.checks,
    );
    if state.changes.len() > 1 {
        text.push_str("change since the baseline in %, bars are U\n");
        text.push_str(&terminal::show_changes(&state.changes, SIZE.0, SIZE.1));
        text.push('\n');
    }
    let latest = state.latest.iter().map(|change| change.words());
    let signals = state.signals.iter().map(|signal| signal.text().to_owned());
    for line in latest.chain(signals) {
        text.push_str(&format!("{line}\n"));
    }
    text
}

fn standards_text(report: &AssuranceReport) -> String {
    if report.standards.is_empty() {
        return "There is no check standard: `calib assure SERIAL --every DAYS` names one.\n"
            .into();
    }
    let mut table = Table::new(&["serial", "Hz", "every/d", "results", "latest", "E_n", ""]);
    for state in &report.standards {
        let latest = state.last_unix_time_s.and_then(|s| u64::try_from(s).ok());
        table.row([
            cut(&state.standard.serial, 16),
            state.standard.frequency_hz.to_string(),
            state.standard.every_days.to_string(),
            state.results.to_string(),
            latest.map_or("never".to_owned(), time::date_and_minute),
            state.e_n.map_or(String::new(), signed),
            state.words(),
        ]);
    }
    let mut text = table.to_string();
    if let Some(drift) = &report.common_drift {
        text.push_str(&drift_text(drift, report));
    }
    text
}

fn drift_text(drift: &CommonDrift, report: &AssuranceReport) -> String {
    let mut text = format!(
        "\ncommon drift   {:+.3} % a year, U = {:.3} %, by {} results of {} series\n",
        100.0 * drift.drift_rel_per_year,
        100.0 * drift.expanded_rel_per_year,
        drift.results,
        drift.standards,
    );
    text.push_str(match (drift.is_significant(), drift.standards) {
        (false, _) => "               less than its uncertainty: none is shown\n",
        (true, 1) => "               one series cannot tell its sensor from the reference\n",
        (true, _) => {
            "               the reference drifts by as much the other way, or the instrument\n"
        }
    });
    let interval = report
        .allowed_drift_rel
        .zip(report.reference_interval_years);
    if let Some((allowed, years)) = interval {
        text.push_str(&format!(
            "interval       {years:.1} years between calibrations of the reference: then drift and U\n               \
             use up the {:.2} % of row 10 (ILAC-G24)\n",
            100.0 * allowed
        ));
    }
    text
}

/// Draws the results of one, and judges the latest.
fn judged(context: &Context, logbook: &Logbook, standard: &CheckStandard) -> Result<()> {
    let history = logbook.history(&standard.serial, standard.frequency_hz)?;
    let values = history.results.iter().map(|r| r.sensitivity_v_per_ms2);
    let values: Vec<f64> = values.collect();
    let too_few = || too_few(standard, values.len());
    let chart = control_chart(&values).ok_or_else(too_few)?;
    let latest = history.results.last().ok_or_else(too_few)?;
    let assurance = judge(standard, &history, latest, chart);
    let kind = logbook.kind_of(&standard.serial)?;
    context.print(&assurance, || text(&assurance, &history, kind))?;
    let why = || format!("{} is out of control", standard.serial);
    Error::not_passed((!assurance.in_control).then(why))
}

fn too_few(standard: &CheckStandard, count: usize) -> Error {
    Error::input(
        format!("check standard {}", standard.serial),
        format!(
            "has {count} results at {} Hz, {FEWEST} are needed for a chart",
            standard.frequency_hz
        ),
        format!("`calib run --sensor {}` measures one more", standard.serial),
    )
}

fn judge(
    standard: &CheckStandard,
    history: &History,
    latest: &HistoryResult,
    chart: ControlChart,
) -> Assurance {
    let e_n = assurance::against_certificate(standard, latest);
    Assurance {
        dut_serial: history.sensor.clone(),
        frequency_hz: history.frequency_hz,
        record_id: latest.record_id,
        logbook_record: latest.record,
        results_before: history.results.len() - 1,
        sensitivity_v_per_ms2: latest.sensitivity_v_per_ms2,
        mean_v_per_ms2: chart.mean,
        standard_deviation_v_per_ms2: chart.standard_deviation,
        lower_v_per_ms2: chart.mean - chart.half_width,
        upper_v_per_ms2: chart.mean + chart.half_width,
        in_control: chart.signals.is_empty() && e_n.is_none_or(|e_n| e_n.abs() <= 1.0),
        signals: chart.signals,
        e_n,
    }
}

fn text(assurance: &Assurance, history: &History, kind: SensorKind) -> String {
    let unit = kind.stated_unit();
    let shown = |v_per_ms2: f64| {
        let si = kind.of_v_per_ms2(v_per_ms2, assurance.frequency_hz);
        format!("{:.5}", unit.of_si(si))
    };
    let mut lines = vec![
        plot(history),
        format!(
            "record {}: {} {}, limits {} to {} by {} results before",
            assurance.record_id,
            shown(assurance.sensitivity_v_per_ms2),
            unit.name(),
            shown(assurance.lower_v_per_ms2),
            shown(assurance.upper_v_per_ms2),
            assurance.results_before,
        ),
    ];
    if let Some(e_n) = assurance.e_n {
        lines.push(format!("against its certificate: E_n = {}", signed(e_n)));
    }
    let signals = assurance.signals.iter();
    lines.extend(signals.map(|signal| signal.text().to_owned()));
    lines.push(match assurance.in_control {
        true => "IN CONTROL".to_owned(),
        false => "OUT OF CONTROL: measure it once more; then mounting, cable, reference".to_owned(),
    });
    lines.join("\n")
}
