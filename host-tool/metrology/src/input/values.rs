//! Values of TOML files that remember where they stood.

use super::Source;
use calib_files::Result;
use std::ops::Range;
use toml::{Spanned, Value};

/// A number as a person writes it: `2`, `2.0`, `inf` or `"infinite"`.
pub type Number = Spanned<Value>;
/// A text with its place.
pub type Text = Spanned<String>;

/// Largest magnitude of a value: no quantity has it in any unit, and the fourth power
/// (Welch-Satterthwaite) of what is made of it is still a number.
pub(super) const LARGEST: f64 = 1.0e60;

/// Highest frequency anybody calibrates a vibration transducer at, Hz: laser vibrometry of PTB's high-frequency
/// exciters ends near 100 kHz. What is above is a frequency in another unit.
pub const HIGHEST_HZ: f64 = 200.0e3;

/// A finite number of at most 1e60.
///
/// # Errors
/// Not a number, NaN, infinite or larger: named with its line.
pub fn finite(source: &Source, name: &str, number: &Number) -> Result<f64> {
    let value = plain(source, name, number)?;
    if value.abs() <= LARGEST {
        return Ok(value);
    }
    Err(source.at(
        &number.span(),
        format!("{name} = {value:e}: not a finite number of at most {LARGEST:e}"),
        "write a finite number, or leave the key out",
    ))
}

/// A finite number above zero, from 1e-60 to 1e60.
///
/// # Errors
/// As [`finite`], and smaller values.
pub fn positive(source: &Source, name: &str, number: &Number) -> Result<f64> {
    let value = finite(source, name, number)?;
    if value >= LARGEST.recip() {
        return Ok(value);
    }
    Err(source.at(
        &number.span(),
        format!("{name} = {value}: must be greater than zero"),
        format!("write {name} as a positive number"),
    ))
}

/// A number that may be infinite (degrees of freedom), but not NaN.
///
/// # Errors
/// Not a number, or NaN.
pub fn plain(source: &Source, name: &str, number: &Number) -> Result<f64> {
    let span: Range<usize> = number.span();
    let value = match number.get_ref() {
        Value::Float(value) => *value,
        Value::Integer(value) => *value as f64,
        Value::String(text) => match text.trim().to_lowercase().as_str() {
            "inf" | "infinite" | "infinity" | "+inf" => f64::INFINITY,
            other => other.parse().unwrap_or(f64::NAN),
        },
        _ => f64::NAN,
    };
    if value.is_nan() {
        return Err(source.at(
            &span,
            format!("{name} is not a number"),
            format!("write {name} as a number with a decimal point, such as 0.25"),
        ));
    }
    Ok(value)
}

/// A coverage factor that can be one: from the standard uncertainty itself to what one degree of
/// freedom needs for 95.45 % (13.97).
///
/// # Errors
/// As [`positive`], and what is outside of that.
pub fn coverage_factor(source: &Source, name: &str, number: &Number) -> Result<f64> {
    let factor = positive(source, name, number)?;
    match (1.0..=14.0).contains(&factor) {
        true => Ok(factor),
        false => Err(source.at(
            &number.span(),
            format!("{name} = {factor} is no coverage factor: they lie between 1 and 14"),
            "k = 2 covers about 95 % of a normal distribution",
        )),
    }
}
