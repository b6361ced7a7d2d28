//! Identification of the accelerometer model from a shock record.
//!
//! # Source
//! ISO 16063-43:2015, 7.3, 8.4.2, 8.5.3, 9.2.

mod chart;
mod choice;
mod fit;
mod report;
mod solve;
mod spectra;

pub use chart::simulation_chart;
pub use choice::Choice;
pub use fit::{ShockIdentification, identify};
pub use report::report;
pub use spectra::Range;
