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

/// A table: first column left-aligned, the others right-aligned.
pub fn table(header: &[&str], rows: &[Vec<String>]) -> String {
    let count = |text: &str| text.chars().count();
    let mut widths: Vec<usize> = header.iter().map(|name| count(name)).collect();
    for row in rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(count(cell));
        }
    }
    let mut text = String::new();
    let head: Vec<String> = header.iter().map(|&name| name.to_owned()).collect();
    for row in std::iter::once(&head).chain(rows) {
        let mut line = String::from(" ");
        for (index, (cell, width)) in row.iter().zip(&widths).enumerate() {
            let pad = " ".repeat(width - count(cell));
            match index {
                0 => line.push_str(&format!(" {cell}{pad}")),
                _ => line.push_str(&format!("  {pad}{cell}")),
            }
        }
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
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
}
