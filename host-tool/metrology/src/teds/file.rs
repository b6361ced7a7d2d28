//! Virtual TEDS in files: the bytes themselves, or in hexadecimal.

use super::template25::{Accelerometer, decode};
use calib_files::{Error, Result};
use std::path::Path;

/// Most bytes of a TEDS: the largest memory used is 4 kbit.
const MAX_BYTES: usize = 512;

/// Reads a virtual TEDS: binary, or pairs of hexadecimal digits with any spaces.
/// Checksums of memory pages must have been taken out, as readers do. Returns the
/// bytes too.
///
/// # Errors
/// [`Error::File`]; [`Error::Input`] when it is no TEDS of an accelerometer.
pub fn read(path: &Path) -> Result<(Accelerometer, Vec<u8>)> {
    let content = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
    parse(&path.display().to_string(), content)
}

/// Reads a virtual TEDS from bytes; `place` names it in errors.
///
/// # Errors
/// [`Error::Input`] when it is no TEDS of an accelerometer.
pub fn parse(place: &str, content: Vec<u8>) -> Result<(Accelerometer, Vec<u8>)> {
    let hint = "state the sensor itself instead";
    let wrong = |problem: String| Error::input(place, problem, hint);
    let bytes = hexadecimal(&content).unwrap_or(content);
    if bytes.len() > MAX_BYTES {
        return Err(wrong(format!(
            "has {} bytes, more than a TEDS",
            bytes.len()
        )));
    }
    let read = decode(&bytes).map_err(|error| wrong(error.to_string()))?;
    Ok((read, bytes))
}

/// The bytes a text of hexadecimal digits stands for, if it is one.
fn hexadecimal(content: &[u8]) -> Option<Vec<u8>> {
    let digits = content.iter().filter(|byte| !byte.is_ascii_whitespace());
    let bytes = hex::decode(digits.copied().collect::<Vec<u8>>()).ok()?;
    (!bytes.is_empty()).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_and_bytes_are_told_apart() {
        assert_eq!(hexadecimal(b"0a FF\n12"), Some(vec![10, 255, 18]));
        assert_eq!(hexadecimal(b"0a F"), None);
        assert_eq!(hexadecimal(&[0, 1, 2, 3]), None);
        assert_eq!(hexadecimal(b""), None);
    }
}
