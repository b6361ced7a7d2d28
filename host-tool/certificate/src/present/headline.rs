//! The result at the reference point in words.

use super::budget::degrees;
use crate::model::Certificate;
use crate::rounding::Rounded;
use crate::words::{Language, with_unit};
use serde::Serialize;

/// Result at the reference point.
#[derive(Clone, Debug, Serialize)]
pub struct Headline {
    /// "at 160 Hz and 10 m/s2 r.m.s."
    pub at: String,
    /// Sensitivity with U.
    pub sensitivity: String,
    /// The sensitivity per standard acceleration of free fall; empty where sensors of this kind have none.
    pub per_g: String,
    /// U in %.
    pub uncertainty: String,
    /// Phase with U.
    pub phase: String,
    /// Coverage factor in a sentence.
    pub coverage: String,
    /// Polarity in a sentence.
    pub polarity: String,
}

/// The result at the reference point, if there is one.
pub(super) fn headline(certificate: &Certificate, language: Language) -> Option<Headline> {
    let (point, values) = certificate.reference_result()?;
    let (uncertainty, decimals) = values.printed_uncertainty_percent;
    let at = [
        language.shortest(point.nominal_frequency_hz),
        language.shortest(point.nominal_acceleration_ms2),
    ];
    let coverage = [
        language.number(values.coverage_factor, 2),
        degrees(values.effective_degrees_of_freedom, language),
    ];
    let polarity = if certificate.inverted {
        "result.inverted"
    } else {
        "result.not_inverted"
    };
    let per_g = values.printed_per_g.zip(certificate.kind.per_g_unit());
    Some(Headline {
        at: language.phrase("result.at", &[&at[0], &at[1]]),
        sensitivity: rounded(
            &values.printed,
            certificate.kind.stated_unit().printed(),
            language,
        ),
        per_g: per_g.map_or_else(String::new, |(printed, unit)| {
            rounded(&printed, unit.printed(), language)
        }),
        uncertainty: with_unit(language.number(uncertainty, decimals), "%"),
        phase: values.printed_phase_deg.map_or_else(
            || language.word("missing").to_owned(),
            |phase| rounded(&phase, "°", language),
        ),
        coverage: language.phrase("result.coverage", &[&coverage[0], &coverage[1]]),
        polarity: language.word(polarity).to_owned(),
    })
}

fn rounded(rounded: &Rounded, unit: &str, language: Language) -> String {
    let number = |value| language.number(value, rounded.decimals);
    // ISO 80000-1: the degree follows the number without a space.
    let space = if unit == "°" { "" } else { "\u{a0}" };
    format!(
        "({} \u{b1} {}){space}{unit}",
        number(rounded.value),
        number(rounded.uncertainty)
    )
}
