//! The tolerance of a sensor, as it is typed, kept and read.
//!
//! ```text
//! 5                          +-5 % of the nominal sensitivity, at every frequency
//! 5:nominal:reference        the same, at the reference point alone
//! 10:reference:20-5000       +-10 % of the reference point, 20 Hz to 5 kHz
//! -5/+10:reference:5000-10000
//! 2:last                     +-2 % of the last calibration at the same frequency
//! api670                     that standard
//! ```
//!
//! Several, separated by commas, must all be met where they apply.

use super::limits::{Band, Base};
use super::request::{API_670, Request};
use super::specification::everywhere;
use std::fmt;
use std::str::FromStr;

/// Tolerance of a sensor; a logbook keeps its text.
#[derive(Clone, Debug, PartialEq)]
pub enum Tolerance {
    /// API 670: 5 % of 100 mV/g at the reference point, 3 dB of it from 10 Hz to 10 kHz.
    Api670,
    /// Bands of one's own.
    Bands(Vec<Band>),
}

impl Tolerance {
    /// States this tolerance where a request has none.
    pub(crate) fn complete(&self, request: &mut Request) {
        if !request.is_open() {
            return;
        }
        match self {
            Self::Api670 => request.specification = API_670.to_owned(),
            Self::Bands(bands) => request.bands.clone_from(bands),
        }
    }

    /// True when the nominal sensitivity must be known.
    pub fn needs_nominal(&self) -> bool {
        match self {
            Self::Api670 => false,
            Self::Bands(bands) => bands.iter().any(|band| band.base == Base::Nominal),
        }
    }
}

impl Tolerance {
    /// Whether two limits are of the same base for the same frequencies, as `2,5` reads that was meant for 2.5.
    pub fn repeats(&self) -> bool {
        let Self::Bands(bands) = self else {
            return false;
        };
        let same = |one: &Band, other: &Band| {
            let place = |b: &Band| (b.from_hz, b.to_hz, b.reference_point_only);
            one.base == other.base && place(one) == place(other)
        };
        let repeated = |(at, one)| bands[..at].iter().any(|before| same(one, before));
        bands.iter().enumerate().any(repeated)
    }
}

impl FromStr for Tolerance {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.trim() == API_670 {
            return Ok(Self::Api670);
        }
        let bands: Result<Vec<Band>, String> = text.split(',').map(band).collect();
        bands.map(Self::Bands)
    }
}

fn band(text: &str) -> Result<Band, String> {
    let wrong = || {
        format!(
            "'{}' is no tolerance; such are 5, 5:nominal:reference, 10:reference:20-5000, \
             -5/+10:last, api670",
            text.trim()
        )
    };
    let mut parts = text.trim().split(':');
    let (lower, upper) = limits(parts.next().unwrap_or_default()).ok_or_else(wrong)?;
    let base = match parts.next().unwrap_or("nominal") {
        "nominal" => Base::Nominal,
        "reference" => Base::Reference,
        "last" => Base::Last,
        _ => return Err(wrong()),
    };
    let mut band = Band {
        lower_percent: lower,
        upper_percent: upper,
        ..everywhere(base, upper)
    };
    match parts.next() {
        None => (),
        Some("reference") => band.reference_point_only = true,
        Some(range) => {
            let (from, to) = range.split_once('-').ok_or_else(wrong)?;
            band.from_hz = from.trim().parse().map_err(|_| wrong())?;
            band.to_hz = to.trim().parse().map_err(|_| wrong())?;
        }
    }
    let ends = parts.next().is_none();
    match ends && band.is_ordered() {
        true => Ok(band),
        false => Err(wrong()),
    }
}

/// `5`, `5%`, or `-5/+10`; percent.
fn limits(text: &str) -> Option<(f64, f64)> {
    let number = |text: &str| text.trim().trim_end_matches('%').trim().parse::<f64>().ok();
    match text.split_once('/') {
        Some((lower, upper)) => Some((number(lower)?, number(upper)?)),
        None => number(text).filter(|v| *v > 0.0).map(|v| (-v, v)),
    }
}

impl fmt::Display for Tolerance {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::Bands(bands) = self else {
            return formatter.write_str(API_670);
        };
        for (index, band) in bands.iter().enumerate() {
            let comma = if index > 0 { "," } else { "" };
            write!(formatter, "{comma}{}", written(band))?;
        }
        Ok(())
    }
}

fn written(band: &Band) -> String {
    let limit = match band.is_symmetric() {
        true => band.upper_percent.to_string(),
        false => format!("{}/{:+}", band.lower_percent, band.upper_percent),
    };
    let base = match band.base {
        Base::Nominal => "nominal",
        Base::Reference => "reference",
        Base::Last => "last",
    };
    let place = match (band.reference_point_only, band.is_everywhere()) {
        (true, _) => ":reference".to_owned(),
        (false, true) => String::new(),
        (false, false) => format!(":{}-{}", band.from_hz, band.to_hz),
    };
    format!("{limit}:{base}{place}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        for text in [
            "api670",
            "5",
            "5 %",
            "5:nominal:reference,10:reference:20-5000",
            "-5/+10:last:5000-10000",
        ] {
            let tolerance: Tolerance = text.parse().expect(text);
            assert_eq!(tolerance.to_string().parse(), Ok(tolerance), "{text}");
        }
        let tolerance: Tolerance = "-5/+10:reference:20-5000".parse().expect("a band");
        let Tolerance::Bands(bands) = tolerance else {
            panic!("bands")
        };
        assert_eq!(
            (bands[0].lower_percent, bands[0].upper_percent),
            (-5.0, 10.0)
        );
        assert_eq!((bands[0].from_hz, bands[0].to_hz), (20.0, 5000.0));
        assert_eq!(bands[0].base, Base::Reference);
    }

    #[test]
    fn a_comma_for_a_point_is_seen() {
        let repeats = |text: &str| text.parse::<Tolerance>().expect(text).repeats();
        assert!(repeats("2,5") && repeats("5:reference,3:reference"));
        for text in [
            "api670",
            "5",
            "5:nominal:reference,10",
            "5:nominal,2:last",
            "5:last:20-50,3:last:50-90",
        ] {
            assert!(!repeats(text), "{text}");
        }
    }

    #[test]
    fn what_is_no_tolerance_is_refused_with_examples() {
        for text in [
            "",
            "0",
            "-5",
            "x",
            "5:nowhere",
            "5:nominal:500-20",
            "5:nominal:20",
            "NaN",
            "10/5",
            "5:nominal:20-50:more",
            "-200/5",
            "inf",
        ] {
            let error = text.parse::<Tolerance>().expect_err(text);
            assert!(error.contains("5:nominal:reference"), "{error}");
        }
    }
}
