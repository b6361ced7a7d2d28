//! Marks in the frame of a plot.

/// Colour of a mark; its meaning is the caller's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ink {
    /// The usual one.
    #[default]
    Blue,
    /// For what is set against it.
    Red,
    /// Context, thin.
    Grey,
    /// A second context, thin.
    Green,
}

/// How a point looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shape {
    /// A filled circle.
    #[default]
    Dot,
    /// A circle with a white middle.
    Hollow,
    /// An upright cross.
    Cross,
}

/// A value with what is known of its spread.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// From left to right.
    pub x: f64,
    /// Upwards.
    pub y: f64,
    /// Half the length of its error bar, in the unit of `y`, not negative.
    pub half_bar: Option<f64>,
    /// Look.
    pub shape: Shape,
    /// Words that appear where a reader points at it; may be empty.
    pub title: String,
}

impl Point {
    /// A dot without a bar.
    #[must_use]
    pub fn new(x: f64, y: f64) -> Self {
        let (half_bar, shape, title) = (None, Shape::Dot, String::new());
        Self {
            x,
            y,
            half_bar,
            shape,
            title,
        }
    }

    /// With an error bar of this half length.
    #[must_use]
    pub fn with_bar(mut self, half_bar: f64) -> Self {
        self.half_bar = Some(half_bar);
        self
    }

    /// Lower and upper end of its bar.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        let half = self.half_bar.unwrap_or(0.0);
        [self.y - half, self.y + half]
    }
}

/// One layer of a plot.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A line through points.
    Line {
        /// In drawing order.
        points: Vec<(f64, f64)>,
        /// Colour.
        ink: Ink,
    },
    /// Points with error bars.
    Points {
        /// The points.
        points: Vec<Point>,
        /// Colour.
        ink: Ink,
    },
    /// An area with dashed edges: place, lower and upper limit, left to right.
    Band {
        /// Place, lower, upper.
        places: Vec<(f64, f64, f64)>,
        /// Colour.
        ink: Ink,
    },
    /// Limits that hold at one place alone: two short lines.
    Limits {
        /// Place.
        x: f64,
        /// Lower and upper limit.
        limits: [f64; 2],
    },
    /// A diagonal cross at the foot of the frame: there is no value here.
    Missing {
        /// Place.
        x: f64,
        /// Why, where a reader points at it.
        title: String,
    },
    /// Bars to the right, from the lower end of the axis: place on `y`, end on `x`.
    Bars {
        /// Place on `y` (of a named axis, in the middle of its name) and end.
        bars: Vec<(f64, f64)>,
        /// Colour.
        ink: Ink,
    },
    /// Words that begin beside a place.
    Words {
        /// Place.
        at: (f64, f64),
        /// The words.
        text: String,
    },
}
