//! Reports in plain text, at most 80 columns wide.

use std::fmt::Write;

/// Widest line of a report.
pub const WIDTH: usize = 80;

/// Wraps a paragraph at [`WIDTH`], each line indented by `indent` blanks.
pub fn wrap(paragraph: &str, indent: usize) -> String {
    let mut lines = vec![" ".repeat(indent)];
    for word in paragraph.split_whitespace() {
        let last = lines.len() - 1;
        let fits = lines[last].chars().count() + 1 + word.chars().count() <= WIDTH;
        match lines[last].trim().is_empty() {
            true => lines[last].push_str(word),
            false if fits => {
                lines[last].push(' ');
                lines[last].push_str(word);
            }
            false => lines.push(format!("{}{word}", " ".repeat(indent))),
        }
    }
    lines.join("\n") + "\n"
}

/// A number with `digits` significant digits, without an exponent where that
/// stays readable.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return match value.is_infinite() {
            true if value > 0.0 => "inf".into(),
            true => "-inf".into(),
            false => format!("{value}"),
        };
    }
    // Round first: 9.99 to two digits is 10, with one place less.
    let rounded: f64 = format!("{value:.*e}", digits.max(1) - 1)
        .parse()
        .unwrap_or(value);
    let exponent = rounded.abs().log10().floor() as i32;
    if !(-5..=6).contains(&exponent) {
        return format!("{rounded:.*e}", digits.max(1) - 1);
    }
    let places = (digits as i32 - 1 - exponent).max(0) as usize;
    format!("{rounded:.places$}")
}

/// Left-aligned text cut to a column's width.
pub fn cell(text: &str, width: usize) -> String {
    let count = text.chars().count();
    if count <= width {
        return format!("{text}{}", " ".repeat(width - count));
    }
    let kept: String = text.chars().take(width.saturating_sub(2)).collect();
    format!("{kept}..")
}

/// A bar of `fraction` of `width` characters.
pub fn bar(fraction: f64, width: usize) -> String {
    let filled = (fraction.clamp(0.0, 1.0) * width as f64).round() as usize;
    "#".repeat(filled)
}

/// A table with columns as wide as needed and two blanks between; printed, its
/// numbers go to the right and its words to the left.
#[derive(Clone, Debug)]
pub struct Table {
    /// The header first.
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these column titles.
    pub fn new(header: &[&str]) -> Self {
        let header = header.iter().map(ToString::to_string).collect();
        Self { rows: vec![header] }
    }

    /// Adds a row with one cell per column.
    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }

    fn is_numeric(&self, column: usize) -> bool {
        let mut cells = self.rows.iter().skip(1).filter_map(|row| row.get(column));
        self.rows.len() > 1 && cells.all(|cell| cell.is_empty() || cell.parse::<f64>().is_ok())
    }

    /// Lines of the table, each after `indent` blanks, the chosen columns to the right.
    fn aligned(&self, indent: usize, is_right: impl Fn(usize) -> bool) -> String {
        let count = |text: &String| text.chars().count();
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let cells = |column| self.rows.iter().filter_map(move |row| row.get(column));
        let width = |column| cells(column).map(count).max().unwrap_or(0);
        let columns: Vec<_> = (0..columns).map(|at| (width(at), is_right(at))).collect();
        let mut text = String::new();
        for row in &self.rows {
            let cells = row
                .iter()
                .zip(&columns)
                .map(|(cell, &(width, right))| match right {
                    true => format!("{cell:>width$}"),
                    false => format!("{cell:<width$}"),
                });
            let line = cells.collect::<Vec<_>>().join("  ");
            let _ = writeln!(text, "{}{}", " ".repeat(indent), line.trim_end());
        }
        text
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.aligned(0, |column| self.is_numeric(column)))
    }
}

/// A table of a report: two blanks before it, the first column to the left, the others to the right.
pub fn table(header: &[&str], rows: &[Vec<String>]) -> String {
    let mut table = Table::new(header);
    table.rows.extend_from_slice(rows);
    table.aligned(2, |column| column > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_significant_digits() {
        assert_eq!(significant(0.4252, 2), "0.43");
        assert_eq!(significant(9.99, 2), "10");
        assert_eq!(significant(51436.869, 6), "51436.9");
        assert_eq!(significant(1.5e-8, 2), "1.5e-8");
        assert_eq!(significant(f64::INFINITY, 3), "inf");
    }

    #[test]
    fn paragraphs_never_exceed_the_width() {
        let text = wrap(&"word ".repeat(100), 4);
        assert!(
            text.lines()
                .all(|line| line.len() <= WIDTH && line.starts_with("    "))
        );
    }

    #[test]
    fn words_go_left_and_numbers_right() {
        let mut table = Table::new(&["name", "Hz"]);
        table.row(["äb".to_owned(), "5".to_owned()]);
        table.row(["c".to_owned(), "160".to_owned()]);
        assert_eq!(table.to_string(), "name   Hz\näb      5\nc     160\n");
    }

    #[test]
    fn a_report_has_its_first_column_left_and_the_others_right() {
        let rows = [["a", "1"], ["bb", "pass"]].map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(
            super::table(&["", "d"], &rows),
            "         d\n  a      1\n  bb  pass\n"
        );
    }
}
