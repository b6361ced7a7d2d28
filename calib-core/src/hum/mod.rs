//! Lines of the mains: found with the exciter at rest, taken out of a point, and what they may leave.
//!
//! A line within the width of a block is no noise: it beats with the tone so slowly that the blocks of a
//! point are off together, and their scatter does not show it. So lines are looked for while the
//! exciter rests, which tells mains frequency and amplitudes, and fitted jointly with the tone over all
//! blocks of a point. What cannot be separated goes into row 5 of the budget.
//!
//! ```text
//! watch    at rest: blocks of 0.1 s at all multiples of 50 and 60 Hz -> mains frequency, lines
//! separate while measuring: amplitudes of the blocks -> without the lines, and what is left
//! normal   the small system of equations behind it
//! ```

mod normal;
mod separate;
mod watch;

pub use separate::{Left, Span, separate};
pub use watch::{Hum, LINES, WATCH_BLOCKS, Watch};
