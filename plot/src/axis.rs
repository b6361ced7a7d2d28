//! An axis: its ends, its scale, and where a value lies on it.

use crate::ticks::{self, Tick};

/// How values go along an axis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios; both ends must be above zero.
    Logarithmic,
    /// Names, each one wide: the middle of the first is at 0.5.
    Named(Vec<String>),
}

/// One axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Title with unit; may be empty.
    pub title: String,
    /// Lower end.
    pub low: f64,
    /// Upper end, above the lower one.
    pub high: f64,
    /// Scale.
    pub scale: Scale,
}

impl Axis {
    /// An axis with these ends.
    #[must_use]
    pub fn new(scale: Scale, low: f64, high: f64) -> Self {
        let title = String::new();
        Self {
            title,
            low,
            high,
            scale,
        }
    }

    /// An axis of names.
    #[must_use]
    pub fn named(names: Vec<String>) -> Self {
        let high = names.len().max(1) as f64;
        Self::new(Scale::Named(names), 0.0, high)
    }

    /// The narrowest axis that holds all values; those that cannot be drawn do
    /// not count. Ends around it where there is one value, some ends where none.
    #[must_use]
    pub fn spanning(scale: Scale, values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = match (ends(&scale, values), &scale) {
            (None, _) => return Self::of_nothing(scale),
            (Some((low, high)), Scale::Logarithmic) if high / low < 1.0 + 1e-9 => {
                (low / 2.0, high * 2.0)
            }
            (Some((low, high)), Scale::Linear) if high - low <= 1e-12 * high.abs().max(1e-3) => {
                (low - 0.5, high + 0.5)
            }
            (Some(ends), _) => ends,
        };
        Self::new(scale, low, high)
    }

    /// An axis that holds all values with air around them, so that no mark
    /// touches the frame. A logarithmic one spans a factor of five at least:
    /// that has two labels.
    #[must_use]
    pub fn around(scale: Scale, values: impl IntoIterator<Item = f64>) -> Self {
        let Some((low, high)) = ends(&scale, values) else {
            return Self::of_nothing(scale);
        };
        if scale == Scale::Logarithmic {
            let span = high / low;
            let air = span.powf(0.03).max(1.3).max((5.0 / span).sqrt());
            return Self::new(scale, low / air, high * air);
        }
        // A single value without width still needs an axis.
        let span = (high - low).max(high.abs() * 1.0e-3);
        let air = 0.08 * if span > 0.0 { span } else { 1.0 };
        Self::new(scale, low - air, high + air)
    }

    fn of_nothing(scale: Scale) -> Self {
        match scale {
            Scale::Logarithmic => Self::new(scale, 10.0, 1000.0),
            _ => Self::new(scale, 0.0, 1.0),
        }
    }

    /// With a title.
    #[must_use]
    pub fn titled(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Place of a value, 0 at the lower end and 1 at the upper one; `None` for what cannot be drawn.
    #[must_use]
    pub fn fraction(&self, value: f64) -> Option<f64> {
        let fraction = match self.scale {
            Scale::Logarithmic => (value / self.low).ln() / (self.high / self.low).ln(),
            _ => (value - self.low) / (self.high - self.low),
        };
        fraction.is_finite().then_some(fraction)
    }

    /// Values in `count` even steps from end to end.
    pub fn places(&self, count: u32) -> impl Iterator<Item = f64> + '_ {
        (0..=count).map(move |step| {
            let part = f64::from(step) / f64::from(count);
            match self.scale {
                Scale::Logarithmic => self.low * (self.high / self.low).powf(part),
                _ => self.low + (self.high - self.low) * part,
            }
        })
    }

    /// Values to mark.
    #[must_use]
    pub fn ticks(&self) -> Vec<Tick> {
        let named = |(at, name): (usize, &String)| Tick {
            value: at as f64 + 0.5,
            level: 0,
            label: name.clone(),
        };
        match &self.scale {
            Scale::Linear => ticks::linear(self.low, self.high),
            Scale::Logarithmic => ticks::logarithmic(self.low, self.high),
            Scale::Named(names) => names.iter().enumerate().map(named).collect(),
        }
    }
}

/// Least and largest of the values that can be drawn.
fn ends(scale: &Scale, values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    let above = match scale {
        Scale::Logarithmic => 0.0,
        _ => f64::NEG_INFINITY,
    };
    let drawn = values.into_iter().filter(|v| v.is_finite() && *v > above);
    drawn.fold(None, |ends, value| {
        let (low, high) = ends.unwrap_or((value, value));
        Some((low.min(value), high.max(value)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_spans_what_can_be_drawn() {
        let axis = Axis::spanning(Scale::Logarithmic, [f64::NAN, -3.0, 20.0, 5000.0]);
        assert_eq!((axis.low, axis.high), (20.0, 5000.0));
        assert_eq!(axis.fraction(20.0), Some(0.0));
        assert!(axis.fraction(-1.0).is_none() && axis.fraction(0.0).is_none());
        // The middle of equal ratios is the geometric mean.
        let middle = axis.fraction((20.0_f64 * 5000.0).sqrt()).expect("inside");
        assert!((middle - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_single_value_has_an_axis_around_it() {
        for scale in [Scale::Linear, Scale::Logarithmic] {
            let axis = Axis::around(scale, [160.0]);
            assert!(axis.low < 160.0 && 160.0 < axis.high);
            assert!(axis.ticks().iter().filter(|tick| tick.level == 0).count() > 1);
        }
    }

    #[test]
    fn places_run_from_end_to_end() {
        let axis = Axis::new(Scale::Logarithmic, 1.0, 100.0);
        let places: Vec<f64> = axis.places(2).collect();
        assert!(
            places
                .iter()
                .zip([1.0, 10.0, 100.0])
                .all(|(a, b)| (a / b - 1.0).abs() < 1e-12)
        );
    }
}
