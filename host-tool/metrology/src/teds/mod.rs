//! Virtual TEDS (IEEE 1451.4): what an accelerometer says about itself.
//!
//! | bits | content |
//! |---|---|
//! | 64 | basic TEDS: manufacturer, model, version, serial number |
//! | 2 | selector: 0 = a standard template follows |
//! | 8 | template, 25 = accelerometer with constant current supply |
//! | rest | the template ([`Accelerometer`]) |
//!
//! Bits are taken from each byte lowest first, and the first bit of a number is
//! its lowest. The layout was taken from the published overviews of the standard's
//! templates and agrees with an independent open decoder; the text of the
//! standard was not at hand.

mod bits;
mod error;
mod file;
mod template25;

pub use error::TedsError;
pub use file::{parse, read};
pub use template25::{Accelerometer, Basic, decode};
