//! The converters of the part, as they are: what each does wrong, from one table.
//!
//! A unit keeps its faults: curve, offset and gain are drawn once, from the number of the unit, and
//! only noise differs from sample to sample. Every line of the table says what it
//! rests on, the sheet or an assumption, and what is assumed can be halved and doubled.

mod dither;
mod drive;
mod input;
mod shape;
mod sheet;

pub(crate) use dither::Dithering;
pub(crate) use drive::DriveConverter;
pub(crate) use input::{Input, InputConverter, nearest_code, ripple};
pub(crate) use shape::MID_CODE;
pub use shape::Shape;
pub use sheet::{Basis, Entry, SHEET};
pub(crate) use sheet::{Quantity, Sheet};
