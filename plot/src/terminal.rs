//! A plot in rows of letters.
//!
//! ```text
//!    1.0 ┤        │
//!    0.0 ┤  ●  ●  ●  │
//!   -1.0 ┤           ●
//!        └──┬────────┬──
//!     Hz    10       100
//! ```

use crate::{Axis, Mark, Plot, Point, Scale, ticks};

/// Columns of the numbers at the value axis.
const LABEL: usize = 9;

impl Plot {
    /// The plot's points with their bars, `width` columns wide: its caption, if it has
    /// one, `height` rows, and two rows of axis. Values end at round numbers,
    /// the horizontal axis where its ends are, with its title as the unit.
    ///
    /// Points that are not finite are left out, lines and areas not drawn. Empty
    /// without any point, or without room.
    #[must_use]
    pub fn terminal(&self, width: usize, height: usize) -> String {
        self.terminal_marked(width, height, &across_ticks(&self.x))
    }

    /// The plot with ticks of one's own on the horizontal axis: places from 0 at its left end to 1, and labels.
    #[must_use]
    pub fn terminal_marked(&self, width: usize, height: usize, ticks: &[(f64, String)]) -> String {
        let points = || self.points().filter(|p| self.is_drawn(p));
        let columns = width.saturating_sub(LABEL + 2);
        if points().next().is_none() || columns < 10 || height < 3 {
            return String::new();
        }
        let values = Rows::of(&self.y, height);
        let across = |x: f64| self.x.fraction(x).map_or(0, |part| cell(part, columns));
        let mut canvas = vec![vec![' '; columns]; height];
        for point in points() {
            let column = across(point.x);
            let [low, high] = point.ends().map(|end| values.cell(end));
            for row in canvas.iter_mut().take(high + 1).skip(low) {
                row[column] = '│';
            }
        }
        // Points last: a bar never hides one.
        for point in points() {
            canvas[values.cell(point.y)][across(point.x)] = '●';
        }
        let mut text = match self.caption.as_str() {
            "" => String::new(),
            caption => format!("{caption}\n"),
        };
        for (index, row) in canvas.iter().enumerate().rev() {
            text += &values.row(index, row);
        }
        text + &self.foot(columns, ticks)
    }

    fn points(&self) -> impl Iterator<Item = &Point> {
        self.marks.iter().flat_map(|mark| match mark {
            Mark::Points { points, .. } => points.as_slice(),
            _ => &[],
        })
    }

    fn is_drawn(&self, point: &Point) -> bool {
        self.x.fraction(point.x).is_some() && point.ends().iter().all(|end| end.is_finite())
    }

    /// The horizontal axis with its ticks, as many labels as there is room for, and the unit.
    fn foot(&self, columns: usize, ticks: &[(f64, String)]) -> String {
        let mut line = vec!['─'; columns];
        let mut names = vec![' '; columns];
        let mut taken = 0;
        for (at, name) in ticks {
            let cell = cell(*at, columns);
            line[cell] = '┬';
            let length = name.chars().count();
            let start = cell
                .saturating_sub(length / 2)
                .min(columns.saturating_sub(length));
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
        format!(
            "{indent}└{line}\n{:>LABEL$}  {}\n",
            self.x.title,
            names.trim_end()
        )
    }
}

/// Place and label of what is marked on the horizontal axis.
fn across_ticks(axis: &Axis) -> Vec<(f64, String)> {
    let place = |value: f64| {
        axis.fraction(value)
            .filter(|at| (-1e-9..=1.0 + 1e-9).contains(at))
    };
    if axis.scale != Scale::Linear {
        let ticks = axis.ticks().into_iter().filter(|tick| tick.level == 0);
        return ticks
            .filter_map(|tick| Some((place(tick.value)?, tick.label)))
            .collect();
    }
    let step = ticks::nice_step((axis.high - axis.low) / 6.0);
    let first = (axis.low / step - 1e-9).ceil();
    let ticks = (0..=6).map(|count| (first + f64::from(count)) * step);
    ticks
        .filter_map(|value| {
            Some((
                place(value)?,
                ticks::label(value, step, ticks::decimals(step)),
            ))
        })
        .collect()
}

/// The value axis: round ends, and its number of cells.
struct Rows {
    low: f64,
    high: f64,
    step: f64,
    cells: usize,
}

impl Rows {
    fn of(axis: &Axis, cells: usize) -> Self {
        let step = ticks::nice_step((axis.high - axis.low) / 4.0);
        let (low, high) = (
            (axis.low / step).floor() * step,
            (axis.high / step).ceil() * step,
        );
        Self {
            low,
            high,
            step,
            cells,
        }
    }

    fn cell(&self, value: f64) -> usize {
        cell((value - self.low) / (self.high - self.low), self.cells)
    }

    fn row(&self, index: usize, row: &[char]) -> String {
        let label = self.label(index).unwrap_or_default();
        let tick = if label.is_empty() { '│' } else { '┤' };
        let row: String = row.iter().collect();
        format!("{label:>LABEL$} {tick}{}\n", row.trim_end())
    }

    /// The round value whose cell this is, if there is one.
    fn label(&self, cell: usize) -> Option<String> {
        let steps = ((self.high - self.low) / self.step).round() as usize;
        (0..=steps)
            .map(|count| self.low + count as f64 * self.step)
            .find(|value| self.cell(*value) == cell)
            .map(|value| ticks::label(value, self.step, ticks::decimals(self.step)))
    }
}

/// Which of `count` cells holds a part of the whole.
fn cell(part: f64, count: usize) -> usize {
    let last = (count - 1) as f64;
    (part * last).round().clamp(0.0, last) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(scale: Scale, unit: &str, points: &[(f64, f64, f64)]) -> Plot {
        let points: Vec<Point> = points
            .iter()
            .map(|(x, y, u)| Point::new(*x, *y).with_bar(*u))
            .collect();
        Plot::spanning("", scale, unit, points)
    }

    #[test]
    fn a_response_is_drawn_to_scale() {
        let points = [(10.0, 0.0, 0.0), (100.0, 2.0, 2.0), (1000.0, 4.0, 0.0)];
        // 11 columns for two decades, five rows for 0 to 4.
        let drawn = plot(Scale::Logarithmic, "Hz", &points).terminal(LABEL + 2 + 11, 5);
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
            (1e-3, -1e30, 0.0),
            (1e6, 1e30, 1e29),
            (f64::NAN, 1.0, 0.0),
            (-5.0, 1.0, 0.0),
        ];
        for points in [&wild[..], &wild[..1], &wild[2..], &[]] {
            for width in [0, 20, 80] {
                for scale in [Scale::Logarithmic, Scale::Linear] {
                    let drawn = plot(scale, "Hz", points).terminal(width, 12);
                    assert!(
                        drawn.lines().all(|line| line.chars().count() <= width),
                        "{drawn}"
                    );
                }
            }
        }
        assert_eq!(
            plot(Scale::Logarithmic, "Hz", &wild[2..]).terminal(80, 12),
            ""
        );
        let usual = plot(
            Scale::Logarithmic,
            "Hz",
            &[(20.0, 0.1, 0.8), (1e4, -0.2, 0.8)],
        );
        assert_eq!(usual.terminal(80, 16).lines().count(), 16 + 2);
    }

    #[test]
    fn years_are_round_and_at_their_place() {
        let years = plot(
            Scale::Linear,
            "year",
            &[(2021.0, 0.0, 1.0), (2026.0, 0.0, 1.0)],
        );
        let drawn = years.terminal(LABEL + 2 + 51, 5);
        let names = drawn.lines().last().expect("names");
        for year in 2021..=2026 {
            assert!(names.contains(&year.to_string()), "{drawn}");
        }
        // 2023 is two fifths of the way: column 20, its name begins two before.
        assert_eq!(names.find("2023"), Some(LABEL + 2 + 20 - 2), "{drawn}");
    }

    #[test]
    fn a_caption_stands_above() {
        let mut plot = plot(Scale::Linear, "s", &[(0.0, 0.0, 0.0), (1.0, 1.0, 0.0)]);
        plot.caption = "level in dB".into();
        assert!(plot.terminal(40, 5).starts_with("level in dB\n"));
    }
}
