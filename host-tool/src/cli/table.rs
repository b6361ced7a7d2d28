//! Plain tables: columns as wide as needed, two spaces between.

use std::fmt;

/// A table that is printed with [`fmt::Display`]; numbers go to the right.
pub(crate) struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table with these column titles.
    pub(crate) fn new(header: &[&str]) -> Self {
        Self {
            header: header.iter().map(ToString::to_string).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row with one cell per column.
    pub(crate) fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }

    fn column(&self, index: usize) -> (usize, bool) {
        let cells = || self.rows.iter().filter_map(|row| row.get(index));
        let widest = cells().map(|cell| cell.chars().count()).max().unwrap_or(0);
        let title = self.header[index].chars().count();
        let numeric = cells().all(|cell| cell.is_empty() || cell.parse::<f64>().is_ok());
        (widest.max(title), numeric && !self.rows.is_empty())
    }
}

impl fmt::Display for Table {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let columns: Vec<_> = (0..self.header.len()).map(|i| self.column(i)).collect();
        for row in std::iter::once(&self.header).chain(&self.rows) {
            let mut line = String::new();
            for (cell, (width, numeric)) in row.iter().zip(&columns) {
                let padding = " ".repeat(width - cell.chars().count());
                let cell = match numeric {
                    true => format!("{padding}{cell}  "),
                    false => format!("{cell}{padding}  "),
                };
                line.push_str(&cell);
            }
            writeln!(formatter, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_go_left_and_numbers_right() {
        let mut table = Table::new(&["name", "Hz"]);
        table.row(["äb".to_owned(), "5".to_owned()]);
        table.row(["c".to_owned(), "160".to_owned()]);
        assert_eq!(table.to_string(), "name   Hz\näb      5\nc     160\n");
    }
}
