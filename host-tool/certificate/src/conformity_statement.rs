//! Conformity of the whole object in words: every output prints this statement.

use super::model::{Certificate, Point, PointValues};
use super::words::Language;
use crate::decision::specification::Place;
use crate::decision::{Assessment, Band, Base, Conformity, Stated};
use calib_record::hash_chain::Standing;
use schemars::JsonSchema;
use serde::Serialize;

/// Statement of conformity by the tolerance and the decision rule that were asked for.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ConformityStatement {
    /// The conformity.
    pub conformity: Stated,
    /// The conformity in capitals of the language, such as `PASS`.
    pub title: String,
    /// Reason in words: `+5.9 % of nominal, limit ±5 %, at 160 Hz`.
    pub because: String,
    /// Frequency of the point that decided, Hz; none when no point did.
    pub frequency_hz: Option<f64>,
    /// Base of the tolerance there.
    pub base: Option<Base>,
    /// Deviation from the base, relative.
    pub deviation_from_base_rel: Option<f64>,
    /// Lower limit of it.
    pub lower_limit_rel: Option<f64>,
    /// Upper limit of it.
    pub upper_limit_rel: Option<f64>,
}

/// A point that decides, by one band of the tolerance.
struct Decisive<'a> {
    point: &'a Point,
    values: &'a PointValues,
    judged: Assessment,
    band: &'a Band,
    deviation_percent: f64,
}

impl Certificate {
    /// The conformity in words, if a tolerance was stated.
    pub fn conformity_statement(&self, language: Language) -> Option<ConformityStatement> {
        self.particulars.decision.as_ref()?;
        let conformity = self.stated_conformity();
        let title = language.word(conformity.message()).to_uppercase();
        let plain = |because: String| ConformityStatement {
            conformity,
            title: title.clone(),
            because,
            frequency_hz: None,
            base: None,
            deviation_from_base_rel: None,
            lower_limit_rel: None,
            upper_limit_rel: None,
        };
        if self.record_chain == Some(Standing::Broken) {
            return Some(plain(language.word("conformity.chain_broken").to_owned()));
        }
        let refused = self.points.iter().filter(|p| p.outcome.is_err()).count();
        let without = refused + self.untried_hz.len();
        if self.conformity().is_none() && without > 0 {
            let all = self.points.len() + self.untried_hz.len();
            let counts = [without.to_string(), all.to_string()];
            let because = language.phrase("conformity.without", &[&counts[0], &counts[1]]);
            return Some(plain(because));
        }
        if self.conformity().is_none() && !self.is_closed {
            return Some(plain(language.word("conformity.not_closed").to_owned()));
        }
        let Some(decisive) = self.decisive() else {
            return Some(plain(language.word("conformity.nothing").to_owned()));
        };
        Some(ConformityStatement {
            frequency_hz: Some(decisive.point.nominal_frequency_hz),
            base: Some(decisive.band.base),
            deviation_from_base_rel: finite(decisive.deviation_percent / 100.0),
            lower_limit_rel: Some(decisive.band.lower_percent / 100.0),
            upper_limit_rel: Some(decisive.band.upper_percent / 100.0),
            ..plain(decisive.words(language))
        })
    }

    /// Of the points that carry the whole object's statement: the reference point, else
    /// the one furthest beyond its limits, or nearest to them.
    fn decisive(&self) -> Option<Decisive<'_>> {
        let worst = self.conformity()?;
        let candidates: Vec<_> = self
            .points
            .iter()
            .enumerate()
            .filter_map(|(index, point)| Some((index, self.decided(index, point)?)))
            .filter(|(_, decided)| decided.judged.conformity == worst)
            .collect();
        let reference = |(index, _): &(usize, Decisive<'_>)| Some(*index) == self.reference;
        let at = candidates.iter().position(reference).or_else(|| {
            let used = candidates
                .iter()
                .map(|(_, decided)| decided.used())
                .enumerate();
            used.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(at, _)| at)
        })?;
        candidates.into_iter().nth(at).map(|(_, decided)| decided)
    }

    fn decided<'a>(&'a self, index: usize, point: &'a Point) -> Option<Decisive<'a>> {
        let specification = &self.decision.as_ref()?.specification;
        let values = point.values()?;
        let judged = values.assessment?;
        let (_, reference) = self.reference_result()?;
        let place = Place {
            frequency_hz: point.nominal_frequency_hz,
            at_reference_point: Some(index) == self.reference,
            reference: reference.sensitivity,
        };
        let (band, base) = specification.decisive(place, values.sensitivity)?;
        let deviation_percent = 100.0 * (values.sensitivity / base - 1.0);
        Some(Decisive {
            point,
            values,
            judged,
            band,
            deviation_percent,
        })
    }
}

impl Decisive<'_> {
    /// Share of the tolerance that is used up; above 1 outside.
    fn used(&self) -> f64 {
        let limit = match self.deviation_percent < 0.0 {
            true => self.band.lower_percent,
            false => self.band.upper_percent,
        };
        self.deviation_percent / limit
    }

    fn words(&self, language: Language) -> String {
        let at = language.shortest(self.point.nominal_frequency_hz);
        let deviation = self
            .values
            .deviation
            .filter(|_| self.band.base == Base::Reference);
        let of_deviation =
            deviation.and_then(|d| Some((d.uncertainty?.printed_percent, d.decimals)));
        let (uncertainty, decimals) =
            of_deviation.unwrap_or(self.values.printed_uncertainty_percent);
        let uncertainty = language.number(uncertainty, decimals);
        let limit = limit(self.band, language);
        let of = language.word(base(self.band.base));
        if !self.deviation_percent.is_finite() {
            return language.phrase("conformity.no_base", &[of, &at]);
        }
        let decimals = decimals.clamp(1, 2);
        let deviation = signed(self.deviation_percent, decimals, language);
        let key = match self.judged.conformity {
            Conformity::NotJudgeable => "conformity.too_uncertain",
            _ => "conformity.decisive",
        };
        language.phrase(key, &[&deviation, of, &limit, &at, &uncertainty])
    }
}

/// The limits of a band, percent.
fn limit(band: &Band, language: Language) -> String {
    match band.is_symmetric() {
        true => format!("\u{b1}{}", language.shortest(band.upper_percent)),
        false => format!(
            "{} ... {}",
            signed_shortest(band.lower_percent, language),
            signed_shortest(band.upper_percent, language)
        ),
    }
}

fn base(base: Base) -> &'static str {
    match base {
        Base::Nominal => "base.nominal",
        Base::Reference => "base.reference",
        Base::Last => "base.last",
    }
}

/// A number with its sign; what rounds to zero has none.
fn signed(value: f64, decimals: usize, language: Language) -> String {
    let number = language.number(value, decimals);
    let zero = !number.contains(|c: char| c.is_ascii_digit() && c != '0');
    match value > 0.0 && !zero {
        true => format!("+{number}"),
        false => number,
    }
}

/// Three digits after the point are more than a limit has: 3 dB is 41.254 %.
fn signed_shortest(value: f64, language: Language) -> String {
    let rounded = (value * 1000.0).round() / 1000.0;
    let sign = if rounded > 0.0 { "+" } else { "" };
    let number = language.shortest(rounded).replace('-', "\u{2212}");
    format!("{sign}{number}")
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// A band in words, for the statement of what was specified: limits, base, range.
pub(super) fn band_words(band: &Band, language: Language) -> String {
    let of = language.word(base(band.base));
    let limit = limit(band, language);
    let text = language.phrase("specification.band", &[&limit, of]);
    match (band.reference_point_only, band.is_everywhere()) {
        (true, _) => format!("{text}, {}", language.word("specification.reference_point")),
        (false, true) => text,
        (false, false) => {
            let (from, to) = (
                language.shortest(band.from_hz),
                language.shortest(band.to_hz),
            );
            format!("{text}, {from} Hz ... {to} Hz")
        }
    }
}
