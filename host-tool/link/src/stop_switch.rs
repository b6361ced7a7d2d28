//! A stop that waits for nothing: asked for by any thread, passed on ahead of every pending answer.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

/// A stop that is not confirmed so long after it was asked for is an alarm: somebody has to use the button. One that
/// is confirmed later takes the alarm back.
pub const STOP_ALARM: Duration = Duration::from_millis(200);

/// Asks a [`Client`](crate::Client) of another thread for silence. Stops are counted from 1, so that each can
/// be told from the one before; a client passes on the latest and confirms all of them with it.
#[derive(Clone, Debug, Default)]
pub struct StopSwitch {
    counts: Arc<Counts>,
}

#[derive(Debug, Default)]
struct Counts {
    asked: AtomicU64,
    confirmed: AtomicU64,
}

impl StopSwitch {
    /// Asks for silence; returns the number of this stop.
    pub fn ask(&self) -> u64 {
        self.counts.asked.fetch_add(1, Ordering::SeqCst) + 1
    }

    /// Whether anybody asked for silence yet.
    pub fn is_asked(&self) -> bool {
        self.counts.asked.load(Ordering::SeqCst) > 0
    }

    /// Whether the calibrator has answered this stop or a later one: its exciter is silent.
    pub fn is_confirmed(&self, stop: u64) -> bool {
        self.counts.confirmed.load(Ordering::SeqCst) >= stop
    }

    /// The latest stop, unless it is confirmed.
    pub fn waiting(&self) -> Option<u64> {
        let asked = self.counts.asked.load(Ordering::SeqCst);
        (!self.is_confirmed(asked)).then_some(asked)
    }

    pub(super) fn confirm(&self, stop: u64) {
        self.counts.confirmed.fetch_max(stop, Ordering::SeqCst);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_latest_stop_confirms_those_before_and_not_the_next() {
        let switch = StopSwitch::default();
        assert_eq!(switch.waiting(), None);
        let (first, second) = (switch.ask(), switch.ask());
        assert_eq!(switch.waiting(), Some(second));
        switch.confirm(second);
        assert!(switch.is_confirmed(first) && switch.is_confirmed(second));
        assert_eq!(switch.waiting(), None);
        let third = switch.ask();
        assert_eq!(switch.waiting(), Some(third));
    }
}
