//! Numbers of a line.

use super::errors::ScpiError;
use core::fmt::Write;

/// SCPI's "not a number".
pub(super) const NOT_A_NUMBER: f32 = 9.91e37;

/// A positive number with one of these units, or with none.
pub(super) fn number(text: &str, units: &[(&str, f32)]) -> Result<f32, ScpiError> {
    if text.is_empty() {
        return Err(ScpiError::MissingParameter);
    }
    let upper = |unit: &str| {
        let start = text.len().checked_sub(unit.len())?;
        let tail = text.get(start..)?;
        tail.eq_ignore_ascii_case(unit).then(|| text.get(..start))?
    };
    // The longest unit that fits: KHZ ends in HZ.
    let found = units
        .iter()
        .rev()
        .find_map(|(unit, factor)| Some((upper(unit)?, *factor)));
    let (digits, factor) = found.unwrap_or((text, 1.0));
    let value: f32 = digits.trim().parse().map_err(|_| ScpiError::DataType)?;
    let value = value * factor;
    match value.is_finite() && value > 0.0 {
        true => Ok(value),
        false => Err(ScpiError::DataOutOfRange),
    }
}

/// A mask of eight bits; IEEE 488.2 rounds what is no whole number.
pub(super) fn mask(text: &str) -> Result<u8, ScpiError> {
    if text.is_empty() {
        return Err(ScpiError::MissingParameter);
    }
    let value: f32 = text.parse().map_err(|_| ScpiError::DataType)?;
    match (-0.5..255.5).contains(&value) {
        // Cut to whole numbers, upwards from a half.
        true => Ok((value + 0.5) as u8),
        false => Err(ScpiError::DataOutOfRange),
    }
}

/// A number in SCPI's NR3 form.
pub(super) fn put(out: &mut impl Write, value: f32) {
    let _ = write!(out, "{value:E}");
}
