//! Tables with one header line: CSV as laboratories write it.
//!
//! Comma, semicolon or tab; lines that begin with `#` are remarks. With
//! semicolons a decimal comma is understood. Header names are compared in
//! lower case with every unit bracket turned into a suffix, so `Frequency
//! (Hz)`, `frequency [Hz]` and `frequency_hz` are the same column.

use super::Source;
use super::values::LARGEST;
use calib_files::Result;

/// A table of cells with the lines they stood in.
#[derive(Clone, Debug)]
pub struct Table {
    /// The file.
    pub source: Source,
    /// Line of the header, from 1.
    pub header_line: usize,
    /// Columns in the order of the file.
    pub columns: Vec<Column>,
    /// Rows below the header.
    pub rows: Vec<Row>,
    decimal_comma: bool,
}

/// One column of the header.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Position, from 0.
    pub index: usize,
    /// As written.
    pub written: String,
    /// In comparable form.
    pub name: String,
}

/// One row with its place.
#[derive(Clone, Debug)]
pub struct Row {
    /// Line in the file, from 1.
    pub line: usize,
    /// Cells, trimmed.
    pub cells: Vec<String>,
}

impl Table {
    /// Splits a text into header and rows.
    ///
    /// # Errors
    /// No row below the header, two columns of one name, or a row with
    /// another number of cells than the header.
    pub fn parse(source: Source) -> Result<Self> {
        let delimiter = delimiter_of(&source.text);
        let mut rows = rows_of(&source, delimiter)?;
        rows.retain(|row| row.cells.iter().any(|cell| !cell.is_empty()));
        Self::assemble(source, rows, delimiter == b';')
    }

    fn assemble(source: Source, mut rows: Vec<Row>, decimal_comma: bool) -> Result<Self> {
        if rows.is_empty() {
            return Err(source.at_line(1, "the table is empty", "write a header and rows"));
        }
        let header = rows.remove(0);
        let columns: Vec<Column> = header
            .cells
            .iter()
            .enumerate()
            .map(|(index, written)| Column {
                index,
                written: written.clone(),
                name: comparable(written),
            })
            .collect();
        let table = Self {
            source,
            header_line: header.line,
            columns,
            rows,
            decimal_comma,
        };
        table.check_shape()?;
        Ok(table)
    }

    fn check_shape(&self) -> Result<()> {
        for (index, column) in self.columns.iter().enumerate() {
            let twin = self.columns[..index]
                .iter()
                .any(|other| other.written == column.written);
            if twin && !column.name.is_empty() {
                return Err(self.source.at_line(
                    self.header_line,
                    format!("column '{}' is there twice", column.written),
                    "keep one of the two columns",
                ));
            }
        }
        if self.rows.is_empty() {
            return Err(self.source.at_line(
                self.header_line,
                "there is no row below the header",
                "add one line for each measured value",
            ));
        }
        if self
            .columns
            .iter()
            .all(|column| column.written.parse::<f64>().is_ok())
        {
            return Err(self.source.at_line(
                self.header_line,
                "the first line holds numbers, not column names",
                "begin the file with a header line that names each column",
            ));
        }
        self.check_widths()
    }

    fn check_widths(&self) -> Result<()> {
        let wanted = self.columns.len();
        match self.rows.iter().find(|row| row.cells.len() != wanted) {
            None => Ok(()),
            Some(row) => Err(self.source.at_line(
                row.line,
                format!("{} cells, but the header names {wanted}", row.cells.len()),
                "give each row one cell per column",
            )),
        }
    }

    /// The column with one of these comparable names, blanks between; a name that ends in `*`
    /// matches as a prefix.
    ///
    /// # Errors
    /// Two columns answer: the meaning would be a guess.
    pub fn find(&self, names: &str) -> Result<Option<&Column>> {
        let mut found = self.columns.iter().filter(|column| {
            names.split(' ').any(|name| match name.strip_suffix('*') {
                Some(prefix) => column.name.starts_with(prefix),
                None => column.name == name,
            })
        });
        let first = found.next();
        match (first, found.next()) {
            (Some(first), Some(second)) => Err(self.source.at_line(
                self.header_line,
                format!(
                    "columns '{}' and '{}' state the same quantity",
                    first.written, second.written
                ),
                "keep one of the two columns",
            )),
            _ => Ok(first),
        }
    }

    /// As [`Table::find`], but the column must be there.
    ///
    /// # Errors
    /// As [`Table::find`], or no such column.
    pub fn require(&self, what: &str, names: &str) -> Result<&Column> {
        self.find(names)?.ok_or_else(|| {
            let have: Vec<_> = self
                .columns
                .iter()
                .map(|column| column.written.as_str())
                .collect();
            let first = names.split(' ').next().unwrap_or(names);
            self.source.at_line(
                self.header_line,
                format!("no column for {what}; there are: {}", have.join(", ")),
                format!("name the column '{}'", first.trim_end_matches('*')),
            )
        })
    }

    /// A cell as a finite number of at most 1e60.
    ///
    /// # Errors
    /// Empty, not a number, NaN, infinite or larger; names line and column.
    pub fn number(&self, row: &Row, column: &Column) -> Result<f64> {
        let cell = row.cells[column.index].as_str();
        let text = match self.decimal_comma {
            true => cell.replace(',', "."),
            false => cell.to_owned(),
        };
        match text.parse::<f64>() {
            Ok(value) if value.abs() <= LARGEST => Ok(value),
            _ => Err(self.source.at_line(
                row.line,
                format!(
                    "{} = '{cell}' is not a finite number of at most {LARGEST:e}",
                    column.written
                ),
                "write a number with a decimal point, or remove the row",
            )),
        }
    }

    /// A cell as text.
    ///
    /// # Errors
    /// The cell is empty.
    pub fn text<'a>(&self, row: &'a Row, column: &Column) -> Result<&'a str> {
        match row.cells[column.index].as_str() {
            "" => Err(self.source.at_line(
                row.line,
                format!("{} is empty", column.written),
                "fill the cell, or remove the row",
            )),
            cell => Ok(cell),
        }
    }

    /// Columns not in `used`, for a remark that they are not read.
    pub fn unread(&self, used: &[&Column]) -> Vec<String> {
        self.columns
            .iter()
            .filter(|column| !used.contains(column))
            .map(|column| column.written.clone())
            .collect()
    }
}

/// Cells of every line that is neither empty nor a remark; quotation marks as in
/// RFC 4180, but within their line.
fn rows_of(source: &Source, delimiter: u8) -> Result<Vec<Row>> {
    let lines = (1..).zip(source.text.lines());
    let lines = lines.filter(|(_, text)| !text.trim().is_empty() && !text.starts_with('#'));
    let (numbers, lines): (Vec<usize>, Vec<&str>) = lines.unzip();
    let text = lines.join("\n");
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut rows = Vec::with_capacity(numbers.len());
    for (record, &line) in reader.records().zip(&numbers) {
        let unclosed =
            |problem| source.at_line(line, problem, "close every quotation mark in its line");
        let record = record.map_err(|error| unclosed(error.to_string()))?;
        // A cell that holds the end of a line was opened and not closed.
        if record.iter().any(|cell| cell.contains('\n')) {
            return Err(unclosed("a quotation mark is not closed".into()));
        }
        let cells = record.iter().map(str::to_owned).collect();
        rows.push(Row { line, cells });
    }
    Ok(rows)
}

/// The delimiter the header line uses.
fn delimiter_of(text: &str) -> u8 {
    let header = text
        .lines()
        .find(|line| !line.trim().is_empty() && !line.starts_with('#'))
        .unwrap_or("");
    match (
        header.contains(';'),
        header.contains('\t'),
        header.contains(','),
    ) {
        (true, _, _) => b';',
        (false, true, false) => b'\t',
        _ => b',',
    }
}

/// Lower case, units as suffix: `Phase (°)` becomes `phase_deg`.
pub(super) fn comparable(written: &str) -> String {
    let text = written
        .to_lowercase()
        .replace('°', "deg")
        .replace('%', "percent")
        .replace(['ω', 'Ω'], "omega")
        .replace('φ', "phi");
    let words: Vec<&str> = text
        .split(|letter: char| !letter.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .collect();
    words.join("_")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn table(text: &str) -> Result<Table> {
        Table::parse(Source::from_text(Path::new("t.csv"), text)?)
    }

    #[test]
    fn headers_with_units_are_the_same_column() {
        assert_eq!(comparable("Frequency (Hz)"), "frequency_hz");
        assert_eq!(comparable("phase [°]"), "phase_deg");
        assert_eq!(comparable("u(S) / %"), "u_s_percent");
        assert_eq!(comparable("|S|"), "s");
    }

    #[test]
    fn a_decimal_comma_is_read_with_semicolons() {
        let table = table("f; S\n# remark\n1,5; 2,25\n").expect("table");
        let column = table.require("S", "s").expect("column").clone();
        assert_eq!(table.rows[0].line, 3);
        assert_eq!(table.number(&table.rows[0], &column).ok(), Some(2.25));
    }

    #[test]
    fn faults_name_the_line() {
        let cases = [
            ("f,s\n", "t.csv:1"),
            ("f,s\n1,2\n1\n", "t.csv:3"),
            ("f,f\n1,2\n", "t.csv:1"),
            ("1,2\n3,4\n", "t.csv:1"),
            ("f,s\n# remark\n1,\"2\n3,4\n", "t.csv:3"),
        ];
        for (text, place) in cases {
            let message = table(text).expect_err(text).to_string();
            assert!(message.starts_with(place), "{message}");
        }
        let table = table("f,s\n1,2\n\n3,nan\n").expect("shape");
        let column = table.require("S", "s").expect("column").clone();
        let message = table.number(&table.rows[1], &column).expect_err("NaN");
        assert!(message.to_string().starts_with("t.csv:4"), "{message}");
    }
}
