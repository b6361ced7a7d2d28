//! The measured part of a dataset.

use super::point::Point;
use super::record::Record;

/// The measured part of a dataset.
#[derive(Debug, Clone)]
pub(crate) enum Measured {
    /// Steady-state sine points of a calibrator, and the names of the columns that held values.
    Points {
        /// One entry per row of `points.csv`.
        points: Vec<Point>,
        /// Columns that were present.
        columns: Vec<String>,
    },
    /// A uniformly sampled record of an oscillator.
    Record(Record),
}
