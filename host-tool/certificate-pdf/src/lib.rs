//! From a typst template and its files to PDF/A-3b, the same bytes each time.
//!
//! A crate of its own, because the typesetter takes longer to compile than the
//! rest of the tool together. It knows nothing of calibration: names, bytes
//! and a template go in, a document comes out. Fonts are embedded here and
//! fonts of the system are never looked at, so that a certificate looks the
//! same on every machine.
#![forbid(unsafe_code)]

mod document;
mod fonts;

pub use document::{Error, File, render};
pub use fonts::printable;
