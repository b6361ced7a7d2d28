//! Diagnosis of the gap between a simulated and a measured vibration calibrator.
//!
//! Reads a dataset (what was measured, what the simulation believes), and
//! answers where the two differ, which unmodelled effect does it, how far the
//! difference shrinks once the effect is added, and what to measure next.

mod answer;
mod axis;
mod calibrator;
mod dataset;
mod diagnose;
mod effects;
mod error;
mod estimation;
mod model;
mod observable;
mod options;
mod oscillator;
mod others;
mod pictures;
mod plan;
mod report;
mod summary;
mod thresholds;

pub use answer::{
    Answer, Cause, Confirmation, DatasetSummary, Distance, Estimate, OwnNoise, Remainder, Verdict,
    Where,
};
pub use axis::Axis;
pub use calibrator::misfit;
pub use diagnose::{diagnose, diagnose_all};
pub use effects::check_name;
pub use error::GapError;
pub use estimation::gap::{Gap, GapSize, Slice};
pub use observable::{Channel, Group, Observable, Table};
pub use options::Options;
pub use pictures::{Conditions, Datum, Pictures, Residuals, Trace};
pub use plan::{Measurement, Pair, Plan, plan};
pub use report::report;
pub use summary::three_digits;
pub use thresholds::{ENOUGH_SIGMA, PLACE_P_VALUE, POSSIBLE_PROBABILITY};
