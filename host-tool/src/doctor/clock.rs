//! The clock of this computer: it dates records and certificates.

use super::finding::{Finding, State};
use jiff::Timestamp;

/// Day this tool was written on: no true clock is before it.
const WRITTEN: i64 = 1_795_219_200; // 2026-11-21 00:00 UTC

/// Longest plausible age of this tool, s: thirty years.
const LIFE_S: i64 = 30 * 31_557_600;

pub(super) fn check(now: Timestamp) -> Finding {
    let shown = now.strftime("%Y-%m-%d %H:%MZ");
    let finding = |state| Finding::new("clock", state, format!("this computer says {shown}"));
    match (WRITTEN..WRITTEN + LIFE_S).contains(&now.as_second()) {
        true => finding(State::Good),
        false => finding(State::Failed).with_remedy(
            "set the clock before measuring: the calibrator has none, and records carry this time",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_that_lost_its_battery_is_named() {
        let at = |seconds| check(Timestamp::from_second(seconds).expect("a time")).state;
        assert_eq!(at(0), State::Failed);
        assert_eq!(at(WRITTEN - 1), State::Failed);
        assert_eq!(at(WRITTEN), State::Good);
        assert_eq!(at(WRITTEN + LIFE_S), State::Failed);
    }
}
