//! `calib risk`: what decision rules let through, over many sensors.

use super::Context;
use super::number::finite;
use calib_certificate::decision::risk::{self, guard_band};
use calib_host::{Error, Result};
use calib_metrology::text::Table;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

/// `calib risk`.
#[derive(Debug, Args)]
pub(crate) struct Risk {
    /// Tolerance over expanded uncertainty (k = 2), the test uncertainty ratio.
    #[arg(long, value_name = "TUR", value_parser = finite::<f64>)]
    ratio: f64,
    /// Share of the sensors that are within tolerance, %.
    #[arg(long, value_name = "PERCENT", default_value_t = 95.0, value_parser = finite::<f64>)]
    in_tolerance: f64,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Row {
    rule: &'static str,
    /// Share of the tolerance up to which a result is accepted.
    acceptance_limit_rel: f64,
    false_accept_probability: f64,
    false_reject_probability: f64,
    bad_among_accepted_probability: f64,
}

impl Risk {
    /// Computes and prints.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        // Below one, tolerance less U leaves nothing to accept.
        if self.ratio <= 1.0 || !(50.0..100.0).contains(&self.in_tolerance) {
            return Err(Error::usage(
                "--ratio is above 1, --in-tolerance from 50 to below 100 %",
                "a tolerance of 5 % and U = 0.8 % have a ratio of 6.25",
            ));
        }
        let rows = self.rows();
        context.print(&rows, || table(&rows))
    }

    fn rows(&self) -> Vec<Row> {
        let items = risk::spread_of_items(self.in_tolerance / 100.0);
        let row = |(rule, acceptance): (&'static str, f64)| {
            let risk = risk::global(items, 0.5 / self.ratio, acceptance);
            Row {
                rule,
                acceptance_limit_rel: acceptance,
                false_accept_probability: risk.false_accept,
                false_reject_probability: risk.false_reject,
                bad_among_accepted_probability: risk.conditional_false_accept(),
            }
        };
        let rules = [
            ("simple acceptance", 1.0),
            ("guard band w = U", guard_band::expanded(self.ratio)),
            ("root sum square", guard_band::root_sum_square(self.ratio)),
            ("at most 2 % (Dobbert)", guard_band::dobbert(self.ratio)),
        ];
        rules.into_iter().map(row).collect()
    }
}

fn table(rows: &[Row]) -> String {
    let mut table = Table::new(&[
        "rule",
        "limit/%",
        "false accept/%",
        "false reject/%",
        "bad of acc./%",
    ]);
    for row in rows {
        let cells = [
            row.rule.to_owned(),
            format!("{:.1}", 100.0 * row.acceptance_limit_rel),
            format!("{:.3}", 100.0 * row.false_accept_probability),
            format!("{:.3}", 100.0 * row.false_reject_probability),
            format!("{:.3}", 100.0 * row.bad_among_accepted_probability),
        ];
        table.row(cells);
    }
    table.to_string()
}
