//! From sample buffers to results: the course of every point.
//!
//! ```text
//!        start_point                 level loop: settled     blocks full
//!  idle ------------> wait <-> settle ---------------> measure ---------+
//!   ^                  |         |                        |             v
//!   |                  +---------+------------------------+--------> silence
//!   +------------------------------ result -----------------------------+
//!                 any fault: mute, the reason becomes the state of the point
//! ```
//!
//! A broadband run (4.4, Note 1) has all its points in one [`Survey`].
//!
//! A task hands over every buffer of sample pairs and passes
//! [`Sequencer::command`] on to the generator. Nothing here knows of time
//! but by counting samples.

mod checks;
mod scatter;
mod sequencer;
mod stretches;
mod survey;
#[cfg(test)]
mod survey_tests;
#[cfg(test)]
mod tests;

pub use checks::{Measured, judge};
pub use scatter::Scatter;
pub use sequencer::{Activity, Progress, Sampling, Sequencer};
pub use survey::{Survey, SurveyRequest};
