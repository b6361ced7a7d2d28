//! Drift of a sensor over the years, on one screen.

use calib_logbook::{History, HistoryResult};
use calib_metrology::reciprocity::Change;
use calib_plot::{Plot, Point, Scale};

/// Seconds of a Julian year.
const YEAR_S: f64 = 31_557_600.0;
/// Year of 1970-01-01.
const EPOCH_YEAR: f64 = 1970.0;

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

/// Time, relative change and half its bar, in percent over the years.
fn drawn(results: impl Iterator<Item = (i64, f64, f64)>, width: usize, height: usize) -> String {
    let point = |(at_s, change_rel, half_bar_rel): (i64, f64, f64)| {
        let year = EPOCH_YEAR + at_s as f64 / YEAR_S;
        Point::new(year, 100.0 * change_rel).with_bar(100.0 * half_bar_rel)
    };
    let points = results.map(point).collect();
    Plot::spanning("", Scale::Linear, "year", points).terminal(width, height)
}
