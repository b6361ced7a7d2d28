//! Drift of a sensor over the years, on one screen.

use calib_logbook::{History, HistoryResult};
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
        let year = EPOCH_YEAR + result.unix_time_s as f64 / YEAR_S;
        let half_bar = 100.0 * ratio * result.expanded_uncertainty_rel;
        Point::new(year, 100.0 * (ratio - 1.0)).with_bar(half_bar)
    };
    let points = history.results.iter().map(point).collect();
    Plot::spanning("", Scale::Linear, "year", points).terminal(width, height)
}
