//! Tolerances: bands over frequency around a nominal or the reference.

use super::limits::{Band, Base, Limits};
use super::request::{API_670, Request};
use crate::kind::SensitivityUnit::MillivoltPerG;

/// Name of a specification.
#[derive(Clone, Debug, PartialEq)]
pub enum Name {
    /// In words that are the same in every language.
    Own(String),
    /// Plus or minus percent of the nominal sensitivity.
    Nominal(f64),
    /// Plus or minus percent of the sensitivity at the reference point.
    Relative(f64),
    /// The bands: the tolerance of a sensor.
    Bands,
}

/// A named set of bands.
#[derive(Clone, Debug, PartialEq)]
pub struct Specification {
    /// Its name.
    pub name: Name,
    /// Nominal sensitivity, SI unit of the sensor's kind.
    pub nominal: Option<f64>,
    /// Bands; where several apply, all must be met.
    pub bands: Vec<Band>,
    /// Sensitivities of the last calibration, Hz and the same unit.
    pub last: Vec<(f64, f64)>,
}

/// Sensitivities that tolerances are stated of, at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Nominal frequency, Hz.
    pub frequency_hz: f64,
    /// True at the reference point.
    pub at_reference_point: bool,
    /// Sensitivity measured at the reference point, SI unit of the sensor's kind.
    pub reference: f64,
}

/// A sensor of API 670: 100 mV/g within 5 % at the reference point, response
/// within 3 dB of it from 10 Hz to 10 kHz.
const API_670_MV_PER_G: f64 = 100.0;

impl Specification {
    pub(super) fn build(request: &Request) -> Result<Self, String> {
        let mut nominal = request.stated_nominal().map(|nominal| nominal.si);
        let (name, bands) = match request.specification.as_str() {
            "" if !request.bands.is_empty() => (Name::Bands, request.bands.clone()),
            "" => return Err("decision.specification: say api670, nominal, relative, or a name of your own with [[decision.band]]".to_owned()),
            API_670 => {
                nominal = nominal.or(Some(MillivoltPerG.to_si(API_670_MV_PER_G)));
                (Name::Own("API 670".to_owned()), api_670().to_vec())
            }
            "nominal" => {
                let percent = tolerance(request)?;
                (Name::Nominal(percent), vec![everywhere(Base::Nominal, percent)])
            }
            "relative" => {
                let percent = tolerance(request)?;
                (Name::Relative(percent), vec![everywhere(Base::Reference, percent)])
            }
            own => (Name::Own(own.to_owned()), request.bands.clone()),
        };
        let specification = Self {
            name,
            nominal,
            bands,
            last: request.last.clone(),
        };
        specification.check()?;
        Ok(specification)
    }

    fn check(&self) -> Result<(), String> {
        if self.bands.is_empty() {
            // Presets have bands.
            let name = match &self.name {
                Name::Own(name) => name.as_str(),
                Name::Nominal(_) | Name::Relative(_) | Name::Bands => "",
            };
            return Err(format!(
                "decision: '{name}' has no [[decision.band]]; presets are api670, nominal, relative"
            ));
        }
        for (index, band) in self.bands.iter().enumerate() {
            if !band.is_ordered() {
                return Err(format!(
                    "decision.band {}: needs 0 < from_hz <= to_hz and -100 < lower_percent < upper_percent",
                    index + 1
                ));
            }
        }
        let nominal = self.bands.iter().any(|band| band.base == Base::Nominal);
        match self.nominal {
            None if nominal => {
                Err("decision: state nominal_mv_per_g, nominal_mv_per_ms2, or nominal = \"4 mV/(mm/s)\"".to_owned())
            }
            Some(value) if !(value.is_finite() && value > 0.0) => {
                Err("decision: the nominal sensitivity must be positive".to_owned())
            }
            _ => Ok(()),
        }
    }

    /// Limits of the sensitivity at a frequency; `None` where
    /// nothing is specified. Of a base that is not known no limit is a number.
    pub fn limits(&self, place: Place) -> Option<Limits> {
        self.limits_of(place, |_| true)
    }

    /// Those of bands with these bases alone.
    pub fn limits_of(&self, place: Place, wanted: impl Fn(Base) -> bool) -> Option<Limits> {
        let bands = self.bands_at(place).filter(|(band, _)| wanted(band.base));
        let limits = bands.map(|(band, base)| band.around(base));
        limits.reduce(|a, b| Limits {
            // Not a number stays none.
            lower: if a.lower > b.lower || a.lower.is_nan() {
                a.lower
            } else {
                b.lower
            },
            upper: if a.upper < b.upper || a.upper.is_nan() {
                a.upper
            } else {
                b.upper
            },
        })
    }

    /// The band a value comes nearest to leaving or leaves furthest, and its base.
    pub fn decisive(&self, place: Place, value: f64) -> Option<(&Band, f64)> {
        let margin = |(band, base): &(&Band, f64)| {
            let limits = band.around(*base);
            (value - limits.lower).min(limits.upper - value)
        };
        self.bands_at(place)
            .min_by(|a, b| margin(a).total_cmp(&margin(b)))
    }

    fn bands_at(&self, place: Place) -> impl Iterator<Item = (&Band, f64)> {
        let at = place.at_reference_point;
        let applies = move |band: &&Band| band.applies(place.frequency_hz, at);
        let bands = self.bands.iter().filter(applies);
        bands.map(move |band| (band, self.base(band.base, place)))
    }

    /// Not a number where it is not known.
    fn base(&self, base: Base, place: Place) -> f64 {
        let near = |(hz, _): &&(f64, f64)| (hz / place.frequency_hz - 1.0).abs() < 0.01;
        match base {
            Base::Nominal => self.nominal.unwrap_or(f64::NAN),
            Base::Reference => place.reference,
            Base::Last => self.last.iter().find(near).map_or(f64::NAN, |last| last.1),
        }
    }
}

fn tolerance(request: &Request) -> Result<f64, String> {
    let percent = request
        .tolerance_percent
        .ok_or("decision: state tolerance_percent")?;
    match percent > 0.0 && percent < 100.0 {
        true => Ok(percent),
        false => Err(format!(
            "decision.tolerance_percent: {percent} is not between 0 and 100"
        )),
    }
}

pub(super) fn everywhere(base: Base, percent: f64) -> Band {
    Band {
        from_hz: f64::MIN_POSITIVE,
        to_hz: f64::MAX / 2.0,
        base,
        lower_percent: -percent,
        upper_percent: percent,
        reference_point_only: false,
    }
}

fn api_670() -> [Band; 2] {
    let three_db = |sign: f64| 100.0 * (10.0_f64.powf(sign * 3.0 / 20.0) - 1.0);
    [
        Band {
            reference_point_only: true,
            ..everywhere(Base::Nominal, 5.0)
        },
        Band {
            from_hz: 10.0,
            to_hz: 10_000.0,
            base: Base::Reference,
            lower_percent: three_db(-1.0),
            upper_percent: three_db(1.0),
            reference_point_only: false,
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn request(text: &str) -> Request {
        toml::from_str(text).expect("TOML")
    }

    fn place(frequency_hz: f64, reference: f64, at_reference_point: bool) -> Place {
        Place {
            frequency_hz,
            at_reference_point,
            reference,
        }
    }

    #[test]
    fn the_last_calibration_is_a_base_where_there_was_one() {
        let mut asked = request(
            "[[band]]\nfrom_hz = 10\nto_hz = 1000\nbase = 'last'\nlower_percent = -2\nupper_percent = 2",
        );
        asked.last = vec![(160.0, 0.010)];
        let specification = asked.build().expect("bands").specification;
        let at = specification
            .limits(place(160.0, 1.0, true))
            .expect("specified");
        assert!((at.lower / 0.0098 - 1.0).abs() < 1e-12);
        assert!((at.upper / 0.0102 - 1.0).abs() < 1e-12);
        let unknown = specification.limits(place(500.0, 1.0, false));
        assert!(unknown.expect("specified").lower.is_nan());
        assert_eq!(specification.limits(place(5000.0, 1.0, false)), None);
    }

    #[test]
    fn api_670_is_tight_at_the_reference_point_and_wide_elsewhere() {
        let decision = request("specification = 'api670'").build().expect("preset");
        let nominal = 0.1 / 9.806_65;
        let at = decision
            .specification
            .limits(place(160.0, nominal, true))
            .expect("specified");
        assert!(
            (at.lower / nominal - 0.95).abs() < 1e-12 && (at.upper / nominal - 1.05).abs() < 1e-12
        );
        // 3 dB: factors 0.70795 and 1.41254.
        let far = decision
            .specification
            .limits(place(10_000.0, nominal, false))
            .expect("specified");
        assert!((far.lower / nominal - 0.707_946).abs() < 1e-6);
        assert!((far.upper / nominal - 1.412_538).abs() < 1e-6);
        assert_eq!(
            decision
                .specification
                .limits(place(12_500.0, nominal, false)),
            None
        );
    }

    #[test]
    fn what_makes_no_sense_is_refused_with_the_way_out() {
        let cases = [
            ("", "api670"),
            ("specification = 'nominal'", "tolerance_percent"),
            (
                "specification = 'nominal'\ntolerance_percent = 5",
                "nominal_mv_per_g",
            ),
            ("specification = 'mine'", "[[decision.band]]"),
            ("specification = 'relative'\ntolerance_percent = -5", "-5"),
            (
                "specification = 'relative'\ntolerance_percent = 5\nrule = 'max_false_accept'",
                "max_false_accept_percent",
            ),
            (
                "specification = 'mine'\n[[band]]\nfrom_hz = 100\nto_hz = 10\nbase = 'reference'\nlower_percent = -5\nupper_percent = 5",
                "band 1",
            ),
        ];
        for (text, named) in cases {
            let problem = request(text).build().expect_err(text);
            assert!(problem.contains(named), "{problem}");
        }
    }
}
