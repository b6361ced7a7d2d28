//! Progress on standard error; nothing moves when it is no terminal.

use super::Context;
use calib_core::point::PointSpec;
use calib_link::session::{self, Progress};
use calib_protocol::message::RunState;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::time::{Duration, Instant};

/// Resolution of the run's bar.
const STEPS: u64 = 1000;

/// A bar for bytes.
pub(crate) fn bytes(context: &Context) -> ProgressBar {
    bar(context, "downloading [{bar:32}] {bytes}/{total_bytes}")
}

fn bar(context: &Context, template: &str) -> ProgressBar {
    let bar = ProgressBar::new(STEPS).with_style(style(template));
    if context.quiet || context.json {
        bar.set_draw_target(ProgressDrawTarget::hidden());
    }
    bar
}

fn style(template: &str) -> ProgressStyle {
    // A wrong template is a mistake of ours and no reason not to measure.
    let style = ProgressStyle::with_template(template);
    style
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ")
}

/// A bar for a run: points, frequency, level, time left.
pub(crate) struct RunProgress {
    bar: ProgressBar,
    begun: Instant,
    shown: usize,
    silent: bool,
}

impl RunProgress {
    /// A bar at zero.
    pub(crate) fn new(context: &Context) -> Self {
        Self {
            bar: bar(context, "[{bar:24}] {msg}"),
            begun: Instant::now(),
            shown: 0,
            silent: context.quiet || context.json,
        }
    }

    /// Shows where the run stands. Without a terminal: one line per point.
    pub(crate) fn show(&mut self, progress: &Progress<'_>, list: &[PointSpec]) {
        self.bar
            .set_position((progress.fraction * STEPS as f64) as u64);
        let left = session::time_left(self.begun.elapsed(), progress.fraction);
        self.bar.set_message(message(progress, list, left));
        if self.bar.is_hidden() && !self.silent {
            for point in progress.points.iter().skip(self.shown) {
                eprintln!("{}", super::text::point_line(point));
            }
        }
        self.shown = progress.points.len();
    }
}

impl Drop for RunProgress {
    /// Removes the bar, however the run ended.
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

fn message(progress: &Progress<'_>, list: &[PointSpec], left: Option<Duration>) -> String {
    let status = &progress.status;
    let doing = match status.state {
        RunState::Idle => return "starting".to_owned(),
        RunState::Settling => "settling",
        RunState::Measuring => "measuring",
        _ => return "storing".to_owned(),
    };
    let left = left.map_or(String::new(), |left| format!(", {} s left", left.as_secs()));
    format!(
        "{}/{} {:>7} Hz {doing:<9} {:6.3} m/s2 r.m.s.{left}",
        usize::from(status.point) + 1,
        list.len(),
        list.get(usize::from(status.point))
            .map_or(status.frequency_hz, |point| point.frequency_hz),
        status.acceleration_rms_ms2,
    )
}
