//! Input files: every complaint names file, line and remedy.

mod table;
mod values;

pub use table::{Column, Row, Table};
pub use values::{HIGHEST_HZ, Number, Text, coverage_factor, finite, plain, positive};

use calib_files::{Error, Result, text};
use serde::de::DeserializeOwned;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A text file with the name complaints use.
#[derive(Clone, Debug)]
pub struct Source {
    /// Path as the user gave it.
    pub path: PathBuf,
    /// Content, without a byte order mark.
    pub text: String,
}

impl Source {
    /// Reads a UTF-8 text file.
    ///
    /// # Errors
    /// Unreadable, not UTF-8, or nothing but white space in it.
    pub fn read(path: &Path) -> Result<Self> {
        Self::from_text(path, text::read(path)?)
    }

    /// Reads from text already at hand; `path` is only a name.
    ///
    /// # Errors
    /// Nothing but white space in it.
    pub fn from_text(path: &Path, text: impl Into<String>) -> Result<Self> {
        let text = text.into();
        let source = Self {
            path: path.to_owned(),
            text: text
                .strip_prefix('\u{feff}')
                .map_or(text.clone(), str::to_owned),
        };
        if source.text.trim().is_empty() {
            return Err(source.at_line(
                1,
                "the file is empty",
                "fill it as docs/metrology describes, or name another file",
            ));
        }
        Ok(source)
    }

    /// A complaint about one line.
    pub fn at_line(
        &self,
        line: usize,
        problem: impl Into<String>,
        hint: impl Into<String>,
    ) -> Error {
        text::at_line(&self.path, line, problem, hint)
    }

    /// A complaint about the line in which a byte range begins.
    pub fn at(
        &self,
        span: &Range<usize>,
        problem: impl Into<String>,
        hint: impl Into<String>,
    ) -> Error {
        let line = text::line_at(self.text.as_bytes(), span.start);
        self.at_line(line, problem, hint)
    }

    /// Reads the text as TOML. Unknown keys are refused by the types.
    ///
    /// # Errors
    /// Not TOML, or a key that is missing, unknown or of the wrong type.
    pub fn parse_toml<T: DeserializeOwned>(&self, hint: &str) -> Result<T> {
        text::parse_toml(&self.path, &self.text, hint)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_file_is_named_with_its_line() {
        let error = Source::from_text(Path::new("budget.toml"), " \n\n").expect_err("empty");
        assert_eq!(error.to_string(), "budget.toml:1: the file is empty");
        assert!(error.hint().is_some_and(|hint| hint.contains("docs")));
    }

    #[test]
    fn a_complaint_counts_lines_from_one() {
        let source = Source::from_text(Path::new("a.toml"), "one\ntwo\nthree\n").expect("text");
        let error = source.at(&(4..7), "wrong", "right");
        assert_eq!(error.to_string(), "a.toml:2: wrong");
    }
}
