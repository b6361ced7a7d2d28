//! How many of how many, on standard error.

use super::super::Context;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// A bar on a terminal, else ten lines in all.
pub(super) struct Count {
    bar: ProgressBar,
    what: &'static str,
    lines: bool,
}

impl Count {
    pub(super) fn new(context: &Context, what: &'static str) -> Self {
        let style = ProgressStyle::with_template("[{bar:32}] {pos}/{len} {msg}, {eta} left");
        let bar = ProgressBar::new(1)
            .with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
            .with_message(what);
        if context.quiet {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        }
        Self {
            bar,
            what,
            lines: !context.quiet && !std::io::stderr().is_terminal(),
        }
    }

    pub(super) fn show(&self, done: usize, all: usize) {
        self.bar.set_length(all as u64);
        self.bar.set_position(done as u64);
        let step = all.div_ceil(10).max(1);
        if self.lines && all > 1 && (done.is_multiple_of(step) || done == all) {
            eprintln!("{done} of {all} {}", self.what);
        }
    }
}

impl Drop for Count {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
