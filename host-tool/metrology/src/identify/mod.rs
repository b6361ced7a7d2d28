//! Identification of the accelerometer model from sinusoidal calibration.
//!
//! ```text
//! POINTS.csv -> read -> Points -> fit -> Identification -> report, chart
//! ```
//!
//! # Source
//! ISO 16063-43:2015, 7.2, 8.3, 8.4.1, 8.5.2.

mod advice;
mod chart;
mod fit;
mod header;
mod identification;
mod monte_carlo;
mod points;
mod report;

pub use chart::response_chart;
pub use fit::identify;
pub use identification::{Deviation, Identification, Weighting};
pub use monte_carlo::{Spread, propagate};
pub use points::{Point, Points, read};
pub use report::report;
