//! Whether a board is what it should be: what its converters show of themselves, and the limits.
//!
//! | file | idea |
//! |---|---|
//! | [`figures`] | offset and noise at rest, and with single conversions the dither; gain, offset, distortion and noise of the drive's converter |
//! | [`judge`] | lines with limits |
//! | [`option_bytes`] | what the part was told in the workshop |
//!
//! The self-test measures the board and nothing on it: the drive's converter is heard on the chip,
//! with its pin let go, and the table stays where it is.

pub mod figures;
pub mod judge;
pub mod option_bytes;

pub use figures::{AtRest, Loopback, at_rest, fill_tone, loopback};
pub use judge::{Check, Evidence, Line, MAX_LINES, WrongWords, judge};
pub use option_bytes::{BROWN_OUT_LEVEL, OptionBytes};
