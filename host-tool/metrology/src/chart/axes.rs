//! A pair of axes: linear or logarithmic, with ticks people expect.

use super::{GREY, Svg};

/// Linear or logarithmic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios; both ends must be above zero.
    Logarithmic,
}

/// One axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it shows, with unit.
    pub title: String,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Scale.
    pub scale: Scale,
}

impl Axis {
    /// An axis that holds all values with a little room around them.
    pub fn fitting(title: &str, scale: Scale, values: impl Iterator<Item = f64>) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.filter(|value| value.is_finite()) {
            low = low.min(value);
            high = high.max(value);
        }
        if low > high {
            (low, high) = (1.0, 2.0);
        }
        let (low, high) = match scale {
            Scale::Logarithmic => (low.max(1e-30) / 1.1, high.max(1e-30) * 1.1),
            Scale::Linear => {
                let room = 0.06 * (high - low).max(1e-12 * high.abs().max(1e-12));
                (low - room, high + room)
            }
        };
        Self {
            title: title.into(),
            low,
            high,
            scale,
        }
    }

    /// Place of a value along the axis, 0 to 1.
    pub fn fraction(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Logarithmic => (value / self.low).ln() / (self.high / self.low).ln(),
        }
    }

    /// Values to mark.
    pub fn ticks(&self) -> Vec<f64> {
        match self.scale {
            Scale::Linear => self.linear_ticks(),
            Scale::Logarithmic => self.decade_ticks(),
        }
    }

    fn linear_ticks(&self) -> Vec<f64> {
        let raw = (self.high - self.low) / 6.0;
        let decade = 10.0_f64.powf(raw.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0]
            .into_iter()
            .map(|factor| factor * decade)
            .find(|step| *step >= raw)
            .unwrap_or(raw);
        let first = (self.low / step).ceil() as i64;
        let last = (self.high / step).floor() as i64;
        (first..=last).map(|n| n as f64 * step).collect()
    }

    fn decade_ticks(&self) -> Vec<f64> {
        let first = self.low.log10().floor() as i32;
        let last = self.high.log10().ceil() as i32;
        let steps: &[f64] = match last - first > 3 {
            true => &[1.0],
            false => &[1.0, 2.0, 5.0],
        };
        (first..=last)
            .flat_map(|decade| steps.iter().map(move |step| step * 10.0_f64.powi(decade)))
            .filter(|tick| (self.low..=self.high).contains(tick))
            .collect()
    }
}

/// A plot area inside a sheet.
#[derive(Clone, Debug)]
pub struct Axes {
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Left, top, width and height of the area.
    pub area: (f64, f64, f64, f64),
}

impl Axes {
    /// Sheet coordinates of a point, kept inside the area.
    pub fn place(&self, x: f64, y: f64) -> (f64, f64) {
        let (left, top, width, height) = self.area;
        let inside = |fraction: f64| match fraction.is_finite() {
            true => fraction.clamp(0.0, 1.0),
            false => 0.0,
        };
        (
            left + width * inside(self.x.fraction(x)),
            top + height * (1.0 - inside(self.y.fraction(y))),
        )
    }

    /// Frame, grid, numbers and titles.
    pub fn draw(&self, svg: &mut Svg) {
        let (left, top, width, height) = self.area;
        for tick in self.x.ticks() {
            let (x, _) = self.place(tick, self.y.low);
            svg.polyline(&[(x, top), (x, top + height)], "#dddddd", 0.7);
            svg.text(x, top + height + 14.0, "middle", 10.0, &written(tick));
        }
        for tick in self.y.ticks() {
            let (_, y) = self.place(self.x.low, tick);
            svg.polyline(&[(left, y), (left + width, y)], "#dddddd", 0.7);
            svg.text(left - 5.0, y + 3.5, "end", 10.0, &written(tick));
        }
        let corners = [
            (left, top),
            (left + width, top),
            (left + width, top + height),
            (left, top + height),
            (left, top),
        ];
        svg.polyline(&corners, GREY, 1.0);
        let below = top + height + 30.0;
        svg.text(left + width / 2.0, below, "middle", 11.0, &self.x.title);
        svg.text(left, top - 6.0, "start", 11.0, &self.y.title);
    }
}

/// A tick without rounding noise.
fn written(tick: f64) -> String {
    let rounded: f64 = format!("{tick:.6e}").parse().unwrap_or(tick);
    match rounded.abs() {
        0.0 => "0".into(),
        size if !(1.0e-4..1.0e6).contains(&size) => format!("{rounded:e}"),
        _ => format!("{rounded}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::fitting("f / Hz", Scale::Logarithmic, [20.0, 5000.0].into_iter());
        assert_eq!(axis.ticks().first(), Some(&20.0));
        let axis = Axis::fitting("S", Scale::Linear, [0.9, 2.1].into_iter());
        assert!(axis.ticks().contains(&1.2) || axis.ticks().contains(&1.0));
        assert!((axis.fraction(axis.low)).abs() < 1e-12);
        assert_eq!(written(0.30000000000000004), "0.3");
    }
}
