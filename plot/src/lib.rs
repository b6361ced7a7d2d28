//! Plots for the page, the certificate, the report and the terminal.
//!
//! ```text
//! ticks      round values on an axis
//! axis       an axis: its ends, its scale, where a value lies on it
//! mark       what stands in the frame: lines, points with bars, bands, bars, words
//! svg        a drawing complete without a script
//! terminal   rows of letters
//! ```
//!
//! ```
//! use calib_plot::{Axis, Ink, Mark, Plot, Point, Scale};
//!
//! let measured = [(20.0, 10.1), (160.0, 10.0), (5000.0, 9.8)];
//! let x = Axis::spanning(Scale::Logarithmic, measured.map(|p| p.0)).titled("Frequency in Hz");
//! let y = Axis::spanning(Scale::Linear, measured.map(|p| p.1));
//! let points = measured.map(|(x, y)| Point::new(x, y).with_bar(0.05));
//! let plot = Plot::new("Sensitivity in mV/(m/s²)", x, y)
//!     .with(Mark::Points { points: points.into(), ink: Ink::Blue });
//! assert!(plot.terminal(80, 12).contains("5k"));
//! assert!(plot.with_air().svg("sensitivity").starts_with("<svg"));
//! ```

mod axis;
mod mark;
mod svg;
mod terminal;
pub mod ticks;

pub use axis::{Axis, Scale};
pub use mark::{Ink, Mark, Point, Shape};
pub use svg::sheet;

/// A frame with axes and the marks in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What is drawn, with its unit: above the frame, and what a screen reader says.
    pub caption: String,
    /// From left to right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// A second scale of the same values, at the right.
    pub right: Option<Axis>,
    /// In drawing order.
    pub marks: Vec<Mark>,
    /// Sign between units and tenths in a drawing; a terminal has a point.
    pub decimal_sign: char,
    /// The drawing also carries, hidden, the finer ticks that a page's script shows when zooming.
    pub zoom: bool,
    /// Height of the drawing, at a width of 760.
    pub height: f64,
    /// Room for the numbers or names at the left.
    pub left: f64,
}

impl Plot {
    /// An empty frame.
    #[must_use]
    pub fn new(caption: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self {
            caption: caption.into(),
            x,
            y,
            right: None,
            marks: Vec::new(),
            decimal_sign: '.',
            zoom: false,
            height: 300.0,
            left: 62.0,
        }
    }

    /// With one more mark.
    #[must_use]
    pub fn with(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }

    /// With air around what the axes span, so that no mark touches the frame.
    #[must_use]
    pub fn with_air(mut self) -> Self {
        (self.x, self.y) = (self.x.with_air(), self.y.with_air());
        self
    }
}
