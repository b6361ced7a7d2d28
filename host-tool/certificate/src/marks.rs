//! DRAFT and SIMULATED: what stands across every page of what is no certificate yet, or of
//! nothing real.

use super::model::Certificate;
use super::words::Language;
use schemars::JsonSchema;
use serde::Serialize;

/// Mark of a document that looks like a certificate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mark {
    /// Measured by an emulated instrument.
    Simulated,
    /// Something is missing that ISO/IEC 17025 7.8 or ISO 16063-21 clause 7 wants.
    Draft,
}

/// Statements a certificate cannot be without: section and key.
const REQUIRED: [(&str, &str); 9] = [
    ("item", "model"),
    ("item", "serial"),
    ("calibration", "measurand"),
    ("calibration", "method"),
    ("calibration", "date"),
    ("calibration", "issued"),
    ("calibration", "approved_by"),
    ("conditions", "ambient_temperature"),
    ("conditions", "humidity"),
];

impl Certificate {
    /// Missing items, as keys of the message file; empty when it is complete.
    pub(crate) fn missing(&self) -> Vec<String> {
        let stated =
            |words: &Option<String>| words.as_deref().is_some_and(|w| !w.trim().is_empty());
        let (house, customer) = (&self.particulars.laboratory, &self.particulars.customer);
        let parties = [
            ("laboratory.name", stated(&house.name)),
            (
                "laboratory.address",
                stated(&house.street) && stated(&house.city),
            ),
            ("laboratory.customer", stated(&customer.name)),
        ];
        let parties = parties.into_iter().filter(|(_, stated)| !stated);
        let without = |(section, key): &&(&str, &str)| self.statement(section, key).is_none();
        let statements = REQUIRED.iter().filter(without);
        let statements = statements.map(|(section, key)| format!("{section}.{key}"));
        // Asked for where there is one.
        let entries = self.sections.iter().flat_map(|section| &section.entries);
        let mut of_standard = entries.filter(|entry| entry.key == "standard_certificate");
        let unknown = of_standard.any(|entry| entry.value.is_none());
        let unknown = unknown.then(|| "calibration.standard_certificate".to_owned());
        parties
            .map(|(key, _)| key.to_owned())
            .chain(statements)
            .chain(unknown)
            .collect()
    }

    /// The marks it carries, the graver first.
    pub fn marks(&self) -> Vec<Mark> {
        let simulated = self.simulated.then_some(Mark::Simulated);
        let draft = (!self.missing().is_empty()).then_some(Mark::Draft);
        simulated.into_iter().chain(draft).collect()
    }

    /// Every mark with its reason.
    pub(crate) fn marks_in_words(&self, language: Language) -> Vec<(String, String)> {
        let words = |mark: Mark| {
            let missing = self.missing();
            let missing: Vec<&str> = missing.iter().map(|key| language.word(key)).collect();
            let reason = match mark {
                Mark::Simulated => language.word("mark.simulated_because").to_owned(),
                Mark::Draft => language.phrase("mark.draft_because", &[&missing.join(", ")]),
            };
            (mark.title(language).to_owned(), reason)
        };
        self.marks().into_iter().map(words).collect()
    }

    /// Every mark on one line, or nothing.
    pub(crate) fn marked(&self, language: Language) -> String {
        let titles: Vec<&str> = self
            .marks()
            .iter()
            .map(|mark| mark.title(language))
            .collect();
        titles.join(", ")
    }
}

impl Mark {
    /// The mark in capitals.
    fn title(self, language: Language) -> &'static str {
        language.word(match self {
            Self::Simulated => "mark.simulated",
            Self::Draft => "mark.draft",
        })
    }
}
