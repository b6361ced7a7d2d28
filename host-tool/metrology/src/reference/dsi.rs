//! Units of D-SI: `\milli\volt\metre\tothe{-1}\second\tothe{2}` as a factor and exponents.

use super::certified::{RAD_PER_DEGREE, STANDARD_GRAVITY_MS2};

/// A unit by what it is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Unit {
    /// Times this gives the coherent unit.
    pub(super) factor: f64,
    volt: i32,
    metre: i32,
    second: i32,
    radian: i32,
    coulomb: i32,
}

/// Kind of quantity of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Hz.
    Frequency,
    /// V/(m/s2).
    Sensitivity,
    /// rad.
    Angle,
    /// A ratio; a factor of 0.01 is percent.
    Ratio,
    /// C/(m/s2).
    Charge,
    /// V/(m/s) or V/m.
    OtherMotion,
}

const PREFIXES: [(&str, f64); 9] = [
    ("pico", 1e-12),
    ("nano", 1e-9),
    ("micro", 1e-6),
    ("milli", 1e-3),
    ("centi", 1e-2),
    ("hecto", 1e2),
    ("kilo", 1e3),
    ("mega", 1e6),
    ("giga", 1e9),
];

impl Unit {
    /// Reads a unit of D-SI; none where it is none, or of something else.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let text = text.trim().strip_prefix('\\')?;
        let mut unit = Self {
            factor: 1.0,
            ..Self::default()
        };
        let (mut prefix, mut sign) = (1.0, 1);
        let mut parts = text.split('\\').peekable();
        while let Some(part) = parts.next() {
            if let Some((_, factor)) = PREFIXES.iter().find(|(name, _)| *name == part) {
                prefix = *factor;
                continue;
            }
            if part == "per" {
                sign = -1;
                continue;
            }
            let power = parts.peek().and_then(|next| next.strip_prefix("tothe{"));
            let exponent: i8 = match power {
                Some(power) => power.strip_suffix('}')?.trim().parse().ok()?,
                None => 1,
            };
            let exponent = i32::from(exponent);
            if power.is_some() {
                parts.next();
            }
            unit.multiply(part, prefix, sign * exponent)?;
            (prefix, sign) = (1.0, 1);
        }
        Some(unit)
    }

    fn multiply(&mut self, name: &str, prefix: f64, exponent: i32) -> Option<()> {
        if exponent.abs() > 4 {
            return None;
        }
        let scale = match name {
            "degree" => RAD_PER_DEGREE,
            "percent" => 0.01,
            "standardgravity" => STANDARD_GRAVITY_MS2,
            _ => 1.0,
        };
        self.factor *= (prefix * scale).powi(exponent);
        match name {
            "volt" => self.volt += exponent,
            "metre" => self.metre += exponent,
            "second" => self.second += exponent,
            "hertz" => self.second -= exponent,
            "degree" | "radian" => self.radian += exponent,
            "coulomb" => self.coulomb += exponent,
            "standardgravity" => {
                self.metre += exponent;
                self.second -= 2 * exponent;
            }
            "one" | "percent" => {}
            _ => return None,
        }
        Some(())
    }

    /// Its kind of quantity, if a certificate of a transducer has that kind.
    pub(super) fn kind(&self) -> Option<Kind> {
        let exponents = (
            self.volt,
            self.coulomb,
            self.metre,
            self.second,
            self.radian,
        );
        match exponents {
            (0, 0, 0, -1, 0) => Some(Kind::Frequency),
            (1, 0, -1, 2, 0) => Some(Kind::Sensitivity),
            (0, 0, 0, 0, 1) => Some(Kind::Angle),
            (0, 0, 0, 0, 0) => Some(Kind::Ratio),
            (0, 1, -1, 2, 0) => Some(Kind::Charge),
            (1, 0, -1, 0 | 1, 0) => Some(Kind::OtherMotion),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_certificates_are_what_they_measure() {
        let g = 9.806_65;
        for (text, factor, kind) in [
            (r"\hertz", 1.0, Kind::Frequency),
            (r"\kilo\hertz", 1e3, Kind::Frequency),
            (r"\second\tothe{-1}", 1.0, Kind::Frequency),
            (
                r"\milli\volt\metre\tothe{-1}\second\tothe{2}",
                1e-3,
                Kind::Sensitivity,
            ),
            (r"\volt\per\metre\second\tothe{2}", 1.0, Kind::Sensitivity),
            (
                r"\milli\volt\per\standardgravity",
                1e-3 / g,
                Kind::Sensitivity,
            ),
            // A prefix counts as often as its unit.
            (
                r"\volt\milli\metre\tothe{-1}\second\tothe{2}",
                1e3,
                Kind::Sensitivity,
            ),
            (
                r"\pico\coulomb\metre\tothe{-1}\second\tothe{2}",
                1e-12,
                Kind::Charge,
            ),
            (
                r"\milli\volt\milli\metre\tothe{-1}\second",
                1.0,
                Kind::OtherMotion,
            ),
            (r"\degree", RAD_PER_DEGREE, Kind::Angle),
            (r"\percent", 0.01, Kind::Ratio),
        ] {
            let unit = Unit::parse(text).expect(text);
            assert_eq!(unit.kind(), Some(kind), "{text}");
            assert!((unit.factor / factor - 1.0).abs() < 1e-12, "{text}");
        }
        for text in [
            "Hz",
            r"\furlong",
            r"\volt\tothe{x}",
            r"\volt\tothe{99}",
            "",
            r"\volt\tothe{2",
            r"\volt\per\metre\tothe{-2147483648}",
        ] {
            assert_eq!(Unit::parse(text), None, "{text}");
        }
    }
}
