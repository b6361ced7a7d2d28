//! `calib assure SERIAL`: a check standard against its own results, before a job is begun.

use super::history::plot;
use crate::cli::{Context, number::positive};
use calib_host::{Error, Result};
use calib_logbook::History;
use calib_metrology::control_chart::{ControlChart, FEWEST, Signal, control_chart, e_n};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

/// `calib assure SERIAL`.
#[derive(Debug, Args)]
#[command(after_help = "\
A check standard is a sensor that is measured for no customer, to see whether the calibrator still
gives what it gave (ISO/IEC 17025, 7.7.1). Measure it with `calib run --sensor` first. Exit code 7
when its latest result is out of control, or does not agree with its certificate.")]
pub(crate) struct Assure {
    /// Serial number of the check standard.
    serial: String,
    /// Frequency to compare at, Hz.
    #[arg(long, value_name = "HZ", default_value_t = 160.0, value_parser = positive::<f64>)]
    frequency: f64,
    /// Sensitivity at that frequency on its own certificate, from elsewhere, mV/(m/s2).
    #[arg(long, value_name = "MV", requires = "certified_u", value_parser = positive::<f64>)]
    certified: Option<f64>,
    /// Its expanded uncertainty (k = 2), %.
    #[arg(long, value_name = "PERCENT", requires = "certified", value_parser = positive::<f64>)]
    certified_u: Option<f64>,
}

/// The latest result of a check standard judged.
#[derive(Serialize, JsonSchema)]
pub(in crate::cli) struct Assurance {
    dut_serial: String,
    frequency_hz: f64,
    /// Number in the logbook of the record judged.
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
    /// What speaks against it; empty when it is in control.
    signals: Vec<Signal>,
    /// Against its certificate: beyond 1 the two do not agree; null when none is stated.
    e_n: Option<f64>,
    in_control: bool,
}

impl Assure {
    /// Draws the results, and judges the latest.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let history = context.logbook()?.history(&self.serial, self.frequency)?;
        let values = history.results.iter().map(|r| r.sensitivity_v_per_ms2);
        let values: Vec<f64> = values.collect();
        let chart = control_chart(&values).ok_or_else(|| self.too_few(values.len()))?;
        let assurance = self.judge(&history, chart)?;
        context.print(&assurance, || text(&assurance, &history))?;
        match assurance.in_control {
            true => Ok(()),
            false => Err(Error::NotPassed(format!(
                "{} is out of control",
                self.serial
            ))),
        }
    }

    fn too_few(&self, count: usize) -> Error {
        Error::input(
            format!("check standard {}", self.serial),
            format!(
                "has {count} results at {} Hz, {FEWEST} are needed for a chart",
                self.frequency
            ),
            format!("`calib run --sensor {}` measures one more", self.serial),
        )
    }

    fn judge(&self, history: &History, chart: ControlChart) -> Result<Assurance> {
        let latest = history.results.last().ok_or_else(|| self.too_few(0))?;
        let value = latest.sensitivity_v_per_ms2;
        let expanded = value * latest.expanded_uncertainty_rel;
        let certified = self.certified.zip(self.certified_u);
        let e_n = certified.map(|(certified_mv, certified_percent)| {
            let certified = certified_mv / 1000.0;
            e_n(
                value,
                expanded,
                certified,
                certified * certified_percent / 100.0,
            )
        });
        Ok(Assurance {
            dut_serial: history.sensor.clone(),
            frequency_hz: history.frequency_hz,
            logbook_record: latest.record,
            results_before: history.results.len() - 1,
            sensitivity_v_per_ms2: value,
            mean_v_per_ms2: chart.mean,
            standard_deviation_v_per_ms2: chart.standard_deviation,
            lower_v_per_ms2: chart.mean - chart.half_width,
            upper_v_per_ms2: chart.mean + chart.half_width,
            in_control: chart.signals.is_empty() && e_n.is_none_or(|e_n| e_n.abs() <= 1.0),
            signals: chart.signals,
            e_n,
        })
    }
}

fn text(assurance: &Assurance, history: &History) -> String {
    let mv = |value: f64| format!("{:.5}", 1000.0 * value);
    let mut lines = vec![
        plot(history),
        format!(
            "record {}: {} mV/(m/s2), limits {} to {} by {} results before",
            assurance.logbook_record,
            mv(assurance.sensitivity_v_per_ms2),
            mv(assurance.lower_v_per_ms2),
            mv(assurance.upper_v_per_ms2),
            assurance.results_before,
        ),
    ];
    if let Some(e_n) = assurance.e_n {
        lines.push(format!("against its certificate: E_n = {e_n:+.2}"));
    }
    let signals = assurance.signals.iter();
    lines.extend(signals.map(|signal| signal.text().to_owned()));
    lines.push(match assurance.in_control {
        true => "IN CONTROL".to_owned(),
        false => "OUT OF CONTROL: measure it once more; then mounting, cable, reference".to_owned(),
    });
    lines.join("\n")
}
