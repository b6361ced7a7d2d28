//! Values with their uncertainty over frequency or over the years.
//!
//! ```text
//!    1.0 ┤        │
//!    0.0 ┤  ●  ●  ●  │
//!   -1.0 ┤           ●
//!        └──┬────────┬──
//!     Hz    10       100
//! ```

/// What goes from left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Horizontal {
    /// Frequencies in Hz, logarithmic.
    Frequency,
    /// Years with their fraction, linear.
    Years,
}

/// A value with its expanded uncertainty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// Where it stands on the horizontal axis.
    pub position: f64,
    /// Value, in the unit of the axis.
    pub value: f64,
    /// Half width of its bar, in the same unit, not negative.
    pub half_width: f64,
}

impl Mark {
    /// With the position as the axis has it, if all numbers can be drawn.
    fn on(self, horizontal: Horizontal) -> Option<Self> {
        let position = match horizontal {
            Horizontal::Frequency => self.position.log10(),
            Horizontal::Years => self.position,
        };
        let mark = Self { position, ..self };
        [mark.position, mark.value, mark.half_width]
            .iter()
            .all(|number| number.is_finite())
            .then_some(mark)
    }
}

/// Columns of the numbers at the value axis.
const LABEL: usize = 9;

/// Draws the marks in `width` columns and `height` rows, and two rows of axis.
///
/// Marks with a number that is not finite are left out. Empty when none is
/// left, or when there is no room.
pub fn draw(marks: &[Mark], horizontal: Horizontal, width: usize, height: usize) -> String {
    let on = |mark: &Mark| mark.on(horizontal);
    let marks: Vec<Mark> = marks.iter().filter_map(on).collect();
    let columns = width.saturating_sub(LABEL + 2);
    if marks.is_empty() || columns < 10 || height < 3 {
        return String::new();
    }
    let values = Axis::of_values(&marks, height);
    let across = Axis::of_positions(&marks, columns);
    let mut canvas = vec![vec![' '; columns]; height];
    for mark in &marks {
        let column = across.cell(mark.position);
        let low = values.cell(mark.value - mark.half_width);
        let high = values.cell(mark.value + mark.half_width);
        for row in canvas.iter_mut().take(high + 1).skip(low) {
            if row[column] == ' ' {
                row[column] = '│';
            }
        }
    }
    // Points last: a bar never hides one.
    for mark in &marks {
        canvas[values.cell(mark.value)][across.cell(mark.position)] = '●';
    }
    let mut text = String::new();
    for (index, row) in canvas.iter().enumerate().rev() {
        let label = values.label(index).unwrap_or_default();
        let tick = if label.is_empty() { '│' } else { '┤' };
        let row: String = row.iter().collect();
        text += format!("{label:>LABEL$} {tick}{row}").trim_end();
        text.push('\n');
    }
    text + &match horizontal {
        Horizontal::Frequency => across.line("Hz", &across.decades()),
        Horizontal::Years => across.line("year", &across.years()),
    }
}

/// One axis: its ends, and its number of cells.
struct Axis {
    low: f64,
    high: f64,
    cells: usize,
    step: f64,
}

impl Axis {
    fn of_values(marks: &[Mark], cells: usize) -> Self {
        let ends = marks
            .iter()
            .flat_map(|mark| [mark.value - mark.half_width, mark.value + mark.half_width]);
        let (low, high) = bounds(ends);
        let step = nice_step((high - low) / 4.0);
        Self {
            low: (low / step).floor() * step,
            high: (high / step).ceil() * step,
            cells,
            step,
        }
    }

    fn of_positions(marks: &[Mark], cells: usize) -> Self {
        let (low, high) = bounds(marks.iter().map(|mark| mark.position));
        Self {
            low,
            high,
            cells,
            step: nice_step((high - low) / 6.0),
        }
    }

    fn cell(&self, value: f64) -> usize {
        let last = (self.cells - 1) as f64;
        let position = (value - self.low) / (self.high - self.low) * last;
        position.round().clamp(0.0, last) as usize
    }

    /// The round value whose cell this is, if there is one.
    fn label(&self, cell: usize) -> Option<String> {
        let steps = ((self.high - self.low) / self.step).round() as usize;
        let decimals = (-self.step.log10().floor()).clamp(0.0, 6.0) as usize;
        (0..=steps)
            .map(|count| self.low + count as f64 * self.step)
            .find(|value| self.cell(*value) == cell)
            // No "-0.0".
            .map(|value| {
                format!(
                    "{:.decimals$}",
                    if value.abs() < self.step / 2.0 {
                        0.0
                    } else {
                        value
                    }
                )
            })
    }

    /// 1, 2, 5 of every decade, with their names.
    fn decades(&self) -> Vec<(f64, String)> {
        (self.low.floor() as i32..=self.high.ceil() as i32)
            .flat_map(|exponent| [1.0, 2.0, 5.0].map(|factor| factor * 10_f64.powi(exponent)))
            .map(|hz| (hz.log10(), frequency_name(hz)))
            .collect()
    }

    /// Round years, or round parts of one.
    fn years(&self) -> Vec<(f64, String)> {
        let decimals = (-self.step.log10().floor()).clamp(0.0, 4.0) as usize;
        let first = (self.low / self.step).ceil();
        (0..=6)
            .map(|count| (first + f64::from(count)) * self.step)
            .map(|year| (year, format!("{year:.decimals$}")))
            .collect()
    }

    /// The axis with these ticks, as many names as there is room for, and the unit.
    fn line(&self, unit: &str, ticks: &[(f64, String)]) -> String {
        let mut line = vec!['─'; self.cells];
        let mut names = vec![' '; self.cells];
        let mut taken = 0;
        for (position, name) in ticks {
            if *position < self.low - 1e-9 || *position > self.high + 1e-9 {
                continue;
            }
            let cell = self.cell(*position);
            line[cell] = '┬';
            let length = name.chars().count();
            let last = self.cells.saturating_sub(length);
            let start = cell.saturating_sub(length / 2).min(last);
            if start < taken {
                continue;
            }
            for (slot, letter) in names.iter_mut().skip(start).zip(name.chars()) {
                *slot = letter;
            }
            taken = start + length + 1;
        }
        let line: String = line.iter().collect();
        let names: String = names.iter().collect();
        let indent = " ".repeat(LABEL + 1);
        format!("{indent}└{line}\n{unit:>LABEL$}  {}\n", names.trim_end())
    }
}

fn frequency_name(hz: f64) -> String {
    match hz >= 1000.0 {
        true => format!("{}k", hz / 1000.0),
        false => format!("{hz}"),
    }
}

/// Least and largest value, apart by more than nothing.
fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    match high - low > 1e-12 * high.abs().max(1e-3) {
        true => (low, high),
        false => (low - 0.5, high + 0.5),
    }
}

/// The least of 1, 2, 5 times a power of ten that is not below `step`.
fn nice_step(step: f64) -> f64 {
    let power = 10_f64.powf(step.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|factor| factor * power >= step * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(position: f64, value: f64, half_width: f64) -> Mark {
        Mark {
            position,
            value,
            half_width,
        }
    }

    #[test]
    fn a_response_is_drawn_to_scale() {
        let marks = [
            mark(10.0, 0.0, 0.0),
            mark(100.0, 2.0, 2.0),
            mark(1000.0, 4.0, 0.0),
        ];
        // 11 columns for two decades, five rows for 0 to 4.
        let drawn = draw(&marks, Horizontal::Frequency, LABEL + 2 + 11, 5);
        let rows = [
            "        4 ┤     │    ●",
            "        3 ┤     │",
            "        2 ┤     ●",
            "        1 ┤     │",
            "        0 ┤●    │",
            // 20 Hz is at 10 log10(2) / 2 = 1.5 columns, 50 Hz at 3.5.
            "          └┬─┬┬─┬─┬┬─┬",
            "       Hz  10  100  1k",
        ];
        assert_eq!(drawn.lines().collect::<Vec<_>>(), rows, "{drawn}");
    }

    #[test]
    fn any_numbers_fit_in_the_width() {
        let wild = [
            mark(1e-3, -1e30, 0.0),
            mark(1e6, 1e30, 1e29),
            mark(f64::NAN, 1.0, 0.0),
            mark(-5.0, 1.0, 0.0),
        ];
        for marks in [&wild[..], &wild[..1], &wild[2..], &[]] {
            for width in [0, 20, 80] {
                for horizontal in [Horizontal::Frequency, Horizontal::Years] {
                    let drawn = draw(marks, horizontal, width, 12);
                    // Values beyond all reason have long names; the plot stays.
                    let axis = drawn.lines().find(|line| line.contains('└'));
                    assert!(axis.is_none_or(|line| line.chars().count() <= width));
                }
            }
        }
        assert_eq!(draw(&wild[2..], Horizontal::Frequency, 80, 12), "");
        let usual = [mark(20.0, 0.1, 0.8), mark(1e4, -0.2, 0.8)];
        let drawn = draw(&usual, Horizontal::Frequency, 80, 16);
        assert!(drawn.lines().all(|line| line.chars().count() <= 80));
    }

    #[test]
    fn years_are_round_and_at_their_place() {
        let marks = [mark(2021.0, 0.0, 1.0), mark(2026.0, 0.0, 1.0)];
        let drawn = draw(&marks, Horizontal::Years, LABEL + 2 + 51, 5);
        let names = drawn.lines().last().expect("names");
        for year in 2021..=2026 {
            assert!(names.contains(&year.to_string()), "{drawn}");
        }
        // 2023 is two fifths of the way: column 20, its name begins two before.
        assert_eq!(names.find("2023"), Some(LABEL + 2 + 20 - 2), "{drawn}");
    }

    #[test]
    fn steps_are_round() {
        for (step, nice) in [(0.3, 0.5), (1.0, 1.0), (0.011, 0.02), (6.0, 10.0)] {
            assert!((nice_step(step) / nice - 1.0).abs() < 1e-12, "{step}");
        }
    }
}
