//! Small charts as self-contained SVG: no scripts, no fonts, no network.

mod axes;
mod svg;

pub use axes::{Axes, Axis, Scale};
pub use svg::Svg;

/// Measured values.
pub const BLUE: &str = "#1f5fa8";
/// Models and fits.
pub const RED: &str = "#b5331d";
/// Limits and everything that is only context.
pub const GREY: &str = "#8a8a8a";
/// A second measured quantity.
pub const GREEN: &str = "#2c7a4b";
