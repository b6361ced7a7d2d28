//! Output for an arbitrary input, and the input behind an output.
//!
//! The forward model is the difference equation (19). Its inverse has a double
//! pole at half the sample rate: it would amplify noise without bound. A
//! second-order low-pass filter cancels exactly that pole, and is run a second
//! time backwards so that the estimate is not delayed.
//!
//! # Source
//! ISO 16063-43:2015, clause 1 and 9.2; Elster, Link, Bruns, Meas. Sci.
//! Technol. 18 (2007) 3682 for the time-dependent uncertainty.

mod model;
mod signal;

pub use model::{Model, load_model};
pub use signal::{Estimate, Request, estimate_input, predict_output};
