//! JSON as every verb, the page and the certificate write it.
//!
//! Numbers are as short as their type allows, zero has no sign, and what is not
//! finite is `null`.

use serde::Serialize;
use serde_json::ser::{CompactFormatter, Formatter, PrettyFormatter};
use serde_json::{Result, Serializer};
use std::io::{self, Write};

/// A document for people and programs: indented, with a newline at the end.
///
/// # Errors
/// Keys that are no text.
pub fn document(value: &impl Serialize) -> Result<String> {
    write(value, PrettyFormatter::new())
}

/// A document on one line, with a newline at the end.
///
/// # Errors
/// As [`document`].
pub fn line(value: &impl Serialize) -> Result<String> {
    write(value, CompactFormatter)
}

/// One object per line: each row of a list, else the whole document.
///
/// # Errors
/// As [`document`].
pub fn lines(value: &impl Serialize) -> Result<String> {
    let text = write(value, RowPerLine::default())?;
    let rows = text.split_inclusive('\n').filter(|row| *row != "\n");
    Ok(rows.collect())
}

fn write(value: &impl Serialize, formatter: impl Formatter) -> Result<String> {
    let mut bytes = Vec::new();
    value.serialize(&mut Serializer::with_formatter(
        &mut bytes,
        Unsigned(formatter),
    ))?;
    bytes.push(b'\n');
    String::from_utf8(bytes).map_err(serde::ser::Error::custom)
}

/// Writes zero without a sign, and leaves the rest to another formatter.
struct Unsigned<F>(F);

/// Methods that are those of the other formatter.
macro_rules! pass_on {
    ($($name:ident $(, $argument:ident)?);+) => {
        $(fn $name<W: ?Sized + Write>(&mut self, writer: &mut W $(, $argument: bool)?) -> io::Result<()> {
            self.0.$name(writer $(, $argument)?)
        })+
    };
}

impl<F: Formatter> Formatter for Unsigned<F> {
    // Minus zero plus zero is zero.
    fn write_f32<W: ?Sized + Write>(&mut self, writer: &mut W, value: f32) -> io::Result<()> {
        self.0.write_f32(writer, value + 0.0)
    }

    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        self.0.write_f64(writer, value + 0.0)
    }

    pass_on! {
        begin_array; end_array; begin_array_value, first; end_array_value;
        begin_object; end_object; begin_object_key, first; end_object_key;
        begin_object_value; end_object_value
    }
}

/// Writes the rows of a list on lines of their own, without the brackets around them.
#[derive(Default)]
struct RowPerLine {
    /// Arrays and objects that are open; none outside of rows.
    open: u32,
    is_list: bool,
}

impl RowPerLine {
    fn is_outside(&self) -> bool {
        self.is_list && self.open == 1
    }
}

impl Formatter for RowPerLine {
    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.is_list |= self.open == 0;
        self.open += 1;
        match self.is_outside() {
            true => Ok(()),
            false => writer.write_all(b"["),
        }
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        let is_outside = self.is_outside();
        self.open -= 1;
        match is_outside {
            true => Ok(()),
            false => writer.write_all(b"]"),
        }
    }

    fn begin_array_value<W>(&mut self, writer: &mut W, first: bool) -> io::Result<()>
    where
        W: ?Sized + Write,
    {
        match (first, self.is_outside()) {
            (true, _) => Ok(()),
            (false, true) => writer.write_all(b"\n"),
            (false, false) => writer.write_all(b","),
        }
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open += 1;
        writer.write_all(b"{")
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open -= 1;
        writer.write_all(b"}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Serialize)]
    struct Row {
        a: f32,
        b: f64,
    }

    #[test]
    fn numbers_are_short_and_zero_has_no_sign() {
        let row = Row { a: 0.1071, b: -0.0 };
        assert_eq!(line(&row).expect("writes"), "{\"a\":0.1071,\"b\":0.0}\n");
        let row = Row {
            a: -0.0,
            b: f64::INFINITY,
        };
        let pretty = document(&row).expect("writes");
        assert_eq!(pretty, "{\n  \"a\": 0.0,\n  \"b\": null\n}\n");
    }

    #[test]
    fn a_list_is_one_object_per_line_and_a_document_one_line() {
        let row = || Row { a: 1.0, b: 2.0 };
        let one = "{\"a\":1.0,\"b\":2.0}\n";
        assert_eq!(lines(&row()).expect("writes"), one);
        assert_eq!(lines(&[row(), row()]).expect("writes"), one.repeat(2));
        assert_eq!(lines(&[[1]; 2]).expect("writes"), "[1]\n[1]\n");
        assert_eq!(lines(&[0_u8; 0]).expect("writes"), "");
    }
}
