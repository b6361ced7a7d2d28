//! `calib selftest`: whether the board is what it should be.

use super::Context;
use calib_host::{Error, Result};
use calib_output::{LineView, SelfTestView};
use clap::Args;

/// `calib selftest`.
#[derive(Debug, Args)]
pub(crate) struct SelfTest {}

impl SelfTest {
    /// Prints each line with its limits; a line that failed is not a pass.
    pub(crate) fn run(self, context: &Context) -> Result<()> {
        let lines = context.connect()?.self_test()?;
        let view = SelfTestView::from(lines.as_slice());
        context.print(&view, || view.lines.iter().map(text).collect())?;
        let failed = view.lines.iter().filter(|line| !line.passed).count();
        let all = view.lines.len();
        let why = || format!("{failed} of {all} lines of the self-test failed");
        Error::not_passed((!view.passed).then(why))
    }
}

fn text(line: &LineView) -> String {
    let state = if line.passed { "PASS" } else { "FAIL" };
    let value = line.value.map_or_else(|| "none".to_owned(), number);
    let unit = if line.unit == "1" { "" } else { line.unit };
    let mut text = format!(
        "{:>2} {state}  {:<40} {value:>10} {unit:<8} {}\n",
        line.number,
        line.what,
        limits(line)
    );
    if let Some(remedy) = line.remedy {
        text += &format!("{:>9}{remedy}\n", "");
    }
    text
}

fn limits(line: &LineView) -> String {
    match (line.lower, line.upper) {
        (Some(lower), Some(upper)) => format!("{} to {}", number(lower), number(upper)),
        (Some(lower), None) => format!("at least {}", number(lower)),
        (None, Some(upper)) => format!("at most {}", number(upper)),
        (None, None) => String::new(),
    }
}

/// Four digits, without an exponent where it is short.
fn number(value: f32) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        magnitude if magnitude >= 1000.0 => format!("{value:.0}"),
        magnitude if magnitude >= 1.0 => format!("{value:.3}"),
        magnitude if magnitude >= 0.01 => format!("{value:.4}"),
        _ => format!("{value:.2e}"),
    }
}
