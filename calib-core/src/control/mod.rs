//! Reaching and holding the set acceleration on an exciter nobody described.
//!
//! ```text
//!  probe ---------> approach ---------> trim ----------> settled
//!  0.5 % of the     70 % of the set     100 %, then      two blocks in
//!  drive limit,     level by the        corrected block  a row within
//!  more if nothing  gain just seen      by block         tolerance
//!  is seen
//! ```
//!
//! A point before at this level has shown how the gain changes from probe to set level: then the approach is left
//! out.
//!
//! Every state may end in a [`Reason`](crate::point_state::Reason) instead.

pub mod level_loop;
pub mod limits;

pub use level_loop::{Bend, Level, LevelLoop, LevelState, Next};
pub use limits::{check_level, full_output_peak_ms2};
