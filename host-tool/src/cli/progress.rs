//! Progress on standard error; nothing moves when it is no terminal.

use super::context::Form;
use super::{Context, text};
use calib_core::point::{PointResult, PointSpec};
use calib_host::in_unit::{StatedPoint, Stating};
use calib_link::session::{self, Progress};
use calib_output::StatusView;
use calib_protocol::message::RunState;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use schemars::JsonSchema;
use serde::Serialize;
use std::time::{Duration, Instant};

/// Resolution of the run's bar.
const STEPS: u64 = 1000;

/// A bar for bytes.
pub(crate) fn bytes(context: &Context) -> ProgressBar {
    bar(context, "downloading [{bar:32}] {bytes}/{total_bytes}")
}

/// A bar for the bytes of an update.
pub(crate) fn update(context: &Context) -> ProgressBar {
    bar(context, "sending [{bar:32}] {bytes}/{total_bytes}")
}

fn bar(context: &Context, template: &str) -> ProgressBar {
    let bar = ProgressBar::new(STEPS).with_style(style(template));
    if context.quiet || context.for_program() {
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

/// A line of a run with `--json-lines`.
#[derive(Serialize, JsonSchema)]
#[serde(tag = "event", rename_all = "snake_case")]
pub(crate) enum RunEvent<'a, R> {
    /// Where the run stands.
    Progress {
        /// State of the calibrator.
        #[serde(flatten)]
        status: StatusView,
        /// Work done, 0 to 1.
        fraction: f64,
        /// Time left by this computer's clock, s; none at the beginning.
        left_s: Option<f64>,
    },
    /// A point was measured.
    Point(Box<StatedPoint>),
    /// The document that `--json` prints.
    Result(&'a R),
}

/// Prints how a run ended: in a stream as the last event.
pub(crate) fn print_result<R: Serialize + JsonSchema>(
    context: &Context,
    result: &R,
    text: impl FnOnce() -> String,
) -> calib_host::Result<()> {
    match context.form {
        Form::JsonLines => context.stream(&RunEvent::Result(result)),
        Form::Text | Form::Json => context.print(result, text),
    }
}

/// A bar for a run: points, frequency, level, time left.
pub(crate) struct RunProgress<'a> {
    context: &'a Context,
    stating: Stating,
    bar: ProgressBar,
    begun: Instant,
    shown: usize,
    silent: bool,
    /// Points are what the verb prints, on standard output, and no remarks on the way.
    points_are_result: bool,
}

impl<'a> RunProgress<'a> {
    /// A bar at zero; points are shown as this states them.
    pub(crate) fn new(context: &'a Context, stating: Stating) -> Self {
        Self {
            context,
            stating,
            bar: bar(context, "[{bar:24}] {msg}"),
            begun: Instant::now(),
            shown: 0,
            silent: context.quiet || context.for_program(),
            points_are_result: false,
        }
    }

    /// Prints each point on standard output when it is there, above the bar.
    pub(crate) fn with_points_as_result(mut self) -> Self {
        self.points_are_result = true;
        self
    }

    /// Shows where the run stands. Without a terminal: one line per point, or events.
    pub(crate) fn show(&mut self, progress: &Progress<'_>, list: &[PointSpec]) {
        self.bar
            .set_position((progress.fraction * STEPS as f64) as u64);
        let left = session::time_left(self.begun.elapsed(), progress.fraction);
        self.bar.set_message(message(progress, list, left));
        self.show_points(progress.points);
        self.stream(progress, left);
    }

    /// One line for each point that was not shown yet. A run goes on, whoever stopped reading.
    fn show_points(&mut self, points: &[PointResult]) {
        for point in points.iter().skip(self.shown) {
            let stated = self.stating.point(point);
            let line = text::point_line(point, &stated, self.stating.kind().unit());
            let _ = self
                .context
                .stream(&RunEvent::<()>::Point(Box::new(stated)));
            if self.points_are_result {
                let _ = self.bar.suspend(|| self.context.line(&line));
            } else if self.bar.is_hidden() && !self.silent {
                eprintln!("{line}");
            }
        }
        self.shown = points.len().max(self.shown);
    }

    /// The run has ended with these points.
    pub(crate) fn end(mut self, points: &[PointResult]) {
        self.show_points(points);
    }

    /// A run goes on, whoever stopped reading.
    fn stream(&self, progress: &Progress<'_>, left: Option<Duration>) {
        let _ = self.context.stream(&RunEvent::<()>::Progress {
            status: StatusView::from(&progress.status),
            fraction: progress.fraction,
            left_s: left.map(|left| left.as_secs_f64()),
        });
    }
}

impl Drop for RunProgress<'_> {
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
    let index = usize::from(status.point);
    let (place, frequency_hz) = match list.get(index) {
        Some(point) => (format!("{}/{}", index + 1, list.len()), point.frequency_hz),
        None => ("again".to_owned(), status.frequency_hz),
    };
    let reached = status.acceleration_rms_ms2;
    format!("{place} {frequency_hz:>7} Hz {doing:<9} {reached:6.3} m/s2 r.m.s.{left}")
}
