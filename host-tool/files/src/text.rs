//! Text files that people write: what is wrong with one is named by its line.

use crate::{Error, Result};
use serde::de::DeserializeOwned;
use std::path::Path;

/// Reads a UTF-8 text file, without the byte order mark some editors put in front.
///
/// # Errors
/// [`Error::File`] when it cannot be read; [`Error::Input`] with its line when it
/// is not UTF-8.
pub fn read(path: &Path) -> Result<String> {
    let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid = error.utf8_error().valid_up_to();
        let line = line_at(error.as_bytes(), valid);
        let hint = "save the file as plain text with UTF-8 encoding";
        at_line(path, line, "not a text file in UTF-8", hint)
    })?;
    let unmarked = text.strip_prefix('\u{feff}').map(str::to_owned);
    Ok(unmarked.unwrap_or(text))
}

/// Reads `text`, the content of `path`, as TOML. Unknown keys are refused by the types.
///
/// # Errors
/// [`Error::Input`] with the line: not TOML, or a key that is missing, unknown or of
/// the wrong type.
pub fn parse_toml<T: DeserializeOwned>(path: &Path, text: &str, hint: &str) -> Result<T> {
    toml::from_str(text).map_err(|error| malformed(path, text, &error, hint))
}

/// Error of the TOML reader about `text`, with the line.
pub fn malformed(path: &Path, text: &str, error: &toml::de::Error, hint: &str) -> Error {
    let start = error.span().map_or(0, |span| span.start);
    let line = line_at(text.as_bytes(), start);
    at_line(path, line, error.message().trim(), hint)
}

/// A complaint about a line, counted from one.
pub fn at_line(
    path: &Path,
    line: usize,
    problem: impl Into<String>,
    hint: impl Into<String>,
) -> Error {
    Error::input(format!("{}:{line}", path.display()), problem, hint)
}

/// The line, counted from one, in which a byte stands.
pub fn line_at(bytes: &[u8], position: usize) -> usize {
    let before = &bytes[..position.min(bytes.len())];
    1 + before.iter().filter(|byte| **byte == b'\n').count()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(bytes: &[u8]) -> (tempfile::TempDir, std::path::PathBuf) {
        let folder = tempfile::tempdir().expect("folder");
        let path = folder.path().join("a.toml");
        std::fs::write(&path, bytes).expect("written");
        (folder, path)
    }

    #[test]
    fn what_is_no_text_is_an_input_with_its_line() {
        let (_folder, path) = written(b"one\ntwo\n\xff");
        let error = read(&path).expect_err("no UTF-8");
        assert!(error.to_string().contains("a.toml:3: "), "{error}");
        assert_eq!(error.exit_code(), 6);
    }

    #[test]
    fn a_byte_order_mark_is_no_content() {
        let (_folder, path) = written("\u{feff}a = 1\n".as_bytes());
        assert_eq!(read(&path).expect("text"), "a = 1\n");
    }

    #[test]
    fn a_long_line_is_not_repeated_in_the_complaint() {
        let text = format!("\na = [{}]", "1,".repeat(100_000));
        let table = parse_toml::<std::collections::BTreeMap<String, u8>>;
        let error = table(Path::new("a.toml"), &text, "").expect_err("no number");
        let message = error.to_string();
        assert!(message.starts_with("a.toml:2: "), "{message}");
        assert!(message.len() < 200);
    }
}
