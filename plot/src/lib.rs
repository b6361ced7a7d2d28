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
//! use calib_plot::{Plot, Point, Scale};
//!
//! let measured = [(20.0, 10.1), (160.0, 10.0), (5000.0, 9.8)];
//! let points = measured.map(|(hz, value)| Point::new(hz, value).with_bar(0.05));
//! let plot = Plot::spanning("Sensitivity in mV/(m/s²)", Scale::Logarithmic, "Hz", points.into());
//! assert!(plot.terminal(80, 12).contains("5k"));
//! assert!(plot.svg("sensitivity").starts_with("<svg"));
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
    /// Caption with unit: above the frame, and for a screen reader.
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

    /// Points in the narrowest frame that holds them and their bars, over an axis of this scale and title.
    #[must_use]
    pub fn spanning(
        caption: impl Into<String>,
        scale: Scale,
        title: &str,
        points: Vec<Point>,
    ) -> Self {
        let x = Axis::spanning(scale, points.iter().map(|point| point.x)).titled(title);
        let y = Axis::spanning(Scale::Linear, points.iter().flat_map(Point::ends));
        Self::new(caption, x, y).with(Mark::Points {
            points,
            ink: Ink::Blue,
        })
    }

    /// With one more mark.
    #[must_use]
    pub fn with(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }
}
