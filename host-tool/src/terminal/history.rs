//! Drift of a sensor over the years, on one screen.

use calib_logbook::{History, HistoryResult};
use calib_metrology::reciprocity::Change;
use calib_plot::{Plot, Point, Scale};
use jiff::Timestamp;
use jiff::tz::TimeZone;

/// Seconds of a day.
const DAY_S: f64 = 86_400.0;
/// Days on the axis beside the first: as many as there is room for on 80 columns.
const INTERVALS: u32 = 5;

/// The results over the years, in percent of the first, in `width` columns.
pub fn show(history: &History, width: usize, height: usize) -> String {
    let Some(first) = history.results.first() else {
        return String::new();
    };
    let point = |result: &HistoryResult| {
        let ratio = result.sensitivity_v_per_ms2 / first.sensitivity_v_per_ms2;
        let half_bar_rel = ratio * result.expanded_uncertainty_rel;
        (result.unix_time_s, ratio - 1.0, half_bar_rel)
    };
    drawn(history.results.iter().map(point), width, height)
}

/// Changes of a reference over the years by checks, each at its time (s since 1970-01-01 UTC), in percent.
pub fn show_changes(changes: &[(i64, Change)], width: usize, height: usize) -> String {
    let point = |(at_s, change): &(i64, Change)| (*at_s, change.change_rel, change.expanded_rel);
    drawn(changes.iter().map(point), width, height)
}

/// Time, relative change and half its bar, in percent over time.
fn drawn(results: impl Iterator<Item = (i64, f64, f64)>, width: usize, height: usize) -> String {
    let point = |(at_s, change_rel, half_bar_rel): (i64, f64, f64)| {
        Point::new(at_s as f64, 100.0 * change_rel).with_bar(100.0 * half_bar_rel)
    };
    let points = results.map(point).collect();
    let plot = Plot::spanning("", Scale::Linear, "UTC", points);
    let days = days(plot.x.low, plot.x.high);
    plot.terminal_marked(width, height, &days)
}

/// Places and labels of days, or of minutes where everything is of one.
fn days(low_s: f64, high_s: f64) -> Vec<(f64, String)> {
    let format = match high_s - low_s {
        span_s if span_s < DAY_S => "%Y-%m-%d %H:%M",
        _ => "%Y-%m-%d",
    };
    let mark = |step: u32| {
        let part = f64::from(step) / f64::from(INTERVALS);
        let at = Timestamp::from_second((low_s + part * (high_s - low_s)) as i64).ok()?;
        let label = at.to_zoned(TimeZone::UTC).strftime(format).to_string();
        Some((part, label))
    };
    let mut all: Vec<(f64, String)> = (0..=INTERVALS).filter_map(mark).collect();
    all.dedup_by(|a, b| a.1 == b.1);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axis_names_days_and_within_one_day_minutes_too() {
        // 2026-11-24 00:00 UTC, and a year later.
        let begun_s = 1_795_478_400.0;
        let labels = |span_s| -> Vec<String> {
            days(begun_s, begun_s + span_s)
                .into_iter()
                .map(|(_, label)| label)
                .collect()
        };
        let years = labels(365.0 * DAY_S);
        assert_eq!(
            (years[0].as_str(), years[5].as_str()),
            ("2026-11-24", "2027-11-24")
        );
        let morning = labels(3600.0);
        assert_eq!(
            (morning[0].as_str(), morning[5].as_str()),
            ("2026-11-24 00:00", "2026-11-24 01:00")
        );
        assert_eq!(labels(1.0), ["2026-11-24 00:00"]);
    }
}
