//! Tolerance and rule of a list kept on an instrument, in single precision.

use super::limits::{Band, Base};
use super::request::{Request, RuleName};
use super::rule::Rule;
use super::specification::everywhere;
use super::tolerance::Tolerance;
use crate::kind::{SensitivityUnit, SensorKind, Specified};
use calib_core::stored_list::{self, ANY_HZ, ListTerms};
use calib_output::number::{decimal, percent};

impl Request {
    /// Tolerance and rule by which a record says it was judged.
    pub fn of_terms(terms: &ListTerms) -> Self {
        let nominal = Some(terms.nominal_v_per_ms2).filter(|nominal| *nominal > 0.0);
        Self {
            nominal: nominal.map(|nominal| as_measured(decimal(nominal))),
            bands: terms.bands.iter().map(from_instrument).collect(),
            rule: match terms.rule {
                stored_list::Rule::Simple => RuleName::Simple,
                stored_list::Rule::GuardBand => RuleName::GuardBand,
            },
            ..Self::default()
        }
    }

    /// Tolerance, rule and nominal sensitivity of this request, for a sensor of this kind, as an instrument keeps
    /// them, without a name.
    ///
    /// # Errors
    /// A sentence that names what is missing, or what an instrument cannot judge by.
    pub fn terms(&self, kind: SensorKind) -> Result<ListTerms, String> {
        if kind.steps() != 0 {
            return Err(format!(
                "an instrument by itself judges sensors to acceleration, and not in {}",
                kind.unit().name()
            ));
        }
        self.fits(kind)?;
        let decision = self.build()?;
        let rule = match decision.rule {
            Rule::Simple => stored_list::Rule::Simple,
            Rule::GuardBand => stored_list::Rule::GuardBand,
            Rule::MaxFalseAccept(_) => {
                return Err("an instrument judges by the rules simple and guard_band".to_owned());
            }
        };
        let nominal = decision.specification.nominal;
        // Of a sensor to acceleration it is one number for all frequencies.
        let nominal = nominal.map(|nominal| kind.to_v_per_ms2(nominal, 160.0));
        let mut terms = ListTerms {
            nominal_v_per_ms2: nominal.map_or(0.0, |nominal| nominal as f32),
            rule,
            ..ListTerms::NONE
        };
        for band in &decision.specification.bands {
            let added = terms.bands.push(to_instrument(band)?);
            added.map_err(|_| {
                let most = stored_list::MAX_BANDS;
                format!("an instrument keeps a tolerance of {most} bands at most")
            })?;
        }
        Ok(terms)
    }
}

impl Tolerance {
    /// The tolerance a list is judged by.
    pub fn of_terms(terms: &ListTerms) -> Self {
        Self::Bands(terms.bands.iter().map(from_instrument).collect())
    }

    /// A request for this tolerance by this rule, of a sensor of this nominal sensitivity.
    pub fn request(&self, rule: RuleName, nominal: Option<Specified>) -> Request {
        let mut request = Request {
            rule,
            ..Request::default()
        };
        self.complete(&mut request);
        if let Some(nominal) = nominal {
            request.know_nominal(nominal);
        }
        request
    }
}

/// V/(m/s2), which an instrument measures and keeps.
fn as_measured(v_per_ms2: f64) -> Specified {
    Specified::of_si(v_per_ms2, SensitivityUnit::default())
}

fn from_instrument(band: &stored_list::Band) -> Band {
    let any = everywhere(Base::Nominal, 0.0);
    let (from_hz, to_hz) = match (band.from_hz, band.to_hz) == ANY_HZ {
        true => (any.from_hz, any.to_hz),
        false => (decimal(band.from_hz), decimal(band.to_hz)),
    };
    Band {
        from_hz,
        to_hz,
        base: match band.base {
            stored_list::Base::Nominal => Base::Nominal,
            stored_list::Base::Reference => Base::Reference,
        },
        lower_percent: percent(band.lower_rel),
        upper_percent: percent(band.upper_rel),
        reference_point_only: band.reference_point_only,
    }
}

fn to_instrument(band: &Band) -> Result<stored_list::Band, String> {
    let base = match band.base {
        Base::Nominal => stored_list::Base::Nominal,
        Base::Reference => stored_list::Base::Reference,
        Base::Last => {
            return Err(
                "an instrument does not know the last calibration: state the tolerance of nominal or \
                 of the reference point"
                    .to_owned(),
            );
        }
    };
    let (from_hz, to_hz) = match band.is_everywhere() {
        true => ANY_HZ,
        false => (band.from_hz as f32, band.to_hz as f32),
    };
    Ok(stored_list::Band {
        from_hz,
        to_hz,
        base,
        lower_rel: (band.lower_percent / 100.0) as f32,
        upper_rel: (band.upper_percent / 100.0) as f32,
        reference_point_only: band.reference_point_only,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept(tolerance: &str, rule: RuleName) -> Result<ListTerms, String> {
        let tolerance: Tolerance = tolerance.parse().expect(tolerance);
        tolerance
            .request(rule, Some(as_measured(0.0102)))
            .terms(SensorKind::default())
    }

    #[test]
    fn what_an_instrument_keeps_is_what_was_asked_for() {
        for text in [
            "5:nominal",
            "5:nominal:reference,10:reference:20-5000",
            "-5/+10.7:reference:5000-10000",
        ] {
            let terms = kept(text, RuleName::Simple).expect(text);
            assert_eq!(Tolerance::of_terms(&terms).to_string(), text);
            let again = Request::of_terms(&terms);
            assert_eq!(again.rule, RuleName::Simple);
            assert_eq!(again.terms(SensorKind::default()), Ok(terms));
        }
        // 3 dB of the reference point, and 5 % of 100 mV/g.
        let api_670 = kept("api670", RuleName::GuardBand).expect("preset");
        assert!((f64::from(api_670.nominal_v_per_ms2) / (0.1 / 9.806_65) - 1.0).abs() < 1e-7);
        assert!((api_670.bands[1].upper_rel - 0.412_538).abs() < 1e-6);
        assert!(api_670.bands[0].reference_point_only);
    }

    #[test]
    fn what_an_instrument_cannot_judge_by_is_refused_with_the_way_out() {
        let last = kept("2:last", RuleName::Simple).expect_err("no last");
        assert!(last.contains("of nominal"), "{last}");
        let risk = kept("5", RuleName::MaxFalseAccept).expect_err("no risk");
        assert!(risk.contains("max_false_accept_percent"), "{risk}");
        let many = kept("5,4,3,2,1,6,7", RuleName::Simple).expect_err("seven");
        assert!(many.contains("6 bands"), "{many}");
        let tolerance: Tolerance = "5".parse().expect("percent");
        let without = tolerance
            .request(RuleName::Simple, None)
            .terms(SensorKind::default());
        assert!(without.expect_err("no nominal").contains("nominal"));
    }
}
