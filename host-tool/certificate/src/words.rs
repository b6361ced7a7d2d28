//! Words and numbers of a language, from the one message file.

use calib_core::budget::Table;
use calib_core::point_state::Reason;
use calib_output::number::fixed;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Every reason the instrument gives, in the order of its codes.
pub const REASONS: [Reason; 25] = [
    Reason::Clipped,
    Reason::Distortion,
    Reason::SignalToNoise,
    Reason::AmplitudeUnstable,
    Reason::FrequencyDeviation,
    Reason::NotSettled,
    Reason::DriveLimit,
    Reason::AccelerationLimit,
    Reason::VelocityLimit,
    Reason::DisplacementLimit,
    Reason::ReferenceDead,
    Reason::DutOpen,
    Reason::Overload,
    Reason::Overrun,
    Reason::FrequencyUnavailable,
    Reason::Stopped,
    Reason::BudgetInvalid,
    Reason::TooFewAverages,
    Reason::LowCoherence,
    Reason::LevelNotFollowing,
    Reason::DutDistortion,
    Reason::TemperatureOutOfRange,
    Reason::ChannelsNotAligned,
    Reason::Hum,
    Reason::HostsSilent,
];

/// The message file.
static MESSAGES: LazyLock<Messages> = LazyLock::new(|| {
    // Note(unwrap): the file is part of the program; a test reads it.
    let messages = toml::from_str(include_str!("messages.toml")).expect("messages.toml is valid");
    with_rows(messages)
});

/// Language -> key -> text.
type Messages = BTreeMap<String, BTreeMap<String, String>>;

/// Adds the English words of Table A.1's rows and of refusals, which are calib-core's.
fn with_rows(mut messages: Messages) -> Messages {
    let rows = Table::A1.sources().iter().zip(1..);
    let english = messages.entry(Language::En.code().to_owned()).or_default();
    english.extend(rows.map(|(text, row)| (format!("row.{row}"), (*text).to_owned())));
    let reason = |reason: Reason| (format!("reason.{reason:?}"), reason.to_string());
    english.extend(REASONS.map(reason));
    messages
}

/// Language of a certificate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Language {
    /// English, decimal point.
    #[default]
    En,
    /// German, decimal comma.
    De,
}

impl Language {
    /// Every language there is.
    pub const ALL: [Self; 2] = [Self::En, Self::De];

    /// Two-letter code of ISO 639-1.
    pub fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::De => "de",
        }
    }

    /// The text of `key`; the key itself when there is none, so that a defect
    /// shows and no text disappears.
    pub fn word(self, key: &str) -> &str {
        MESSAGES
            .get(self.code())
            .and_then(|words| words.get(key))
            .map_or(key, String::as_str)
    }

    /// The text of this language among those of [`Self::ALL`].
    pub(crate) fn one_of(self, texts: [&str; 2]) -> &str {
        match (self, texts) {
            (Self::En, [english, _]) => english,
            (Self::De, [_, german]) => german,
        }
    }

    /// Every text, dots of the keys replaced by underscores for templates.
    pub fn words(self) -> BTreeMap<String, String> {
        let words = MESSAGES.get(self.code()).into_iter().flatten();
        words
            .map(|(key, text)| (key.replace('.', "_"), text.clone()))
            .collect()
    }

    /// The text of `key` with `{0}`, `{1}` ... replaced.
    pub fn phrase(self, key: &str, values: &[&str]) -> String {
        let mut text = self.word(key).to_owned();
        for (index, value) in values.iter().enumerate() {
            text = text.replace(&format!("{{{index}}}"), value);
        }
        text
    }

    /// A number with a fixed count of decimals and the decimal sign of the
    /// language; the minus sign is U+2212, as a printer would set it. What is
    /// not finite is a dash.
    pub fn number(self, value: f64, decimals: usize) -> String {
        if !value.is_finite() {
            return "\u{2013}".to_owned();
        }
        self.with_sign(fixed(value, decimals).replace('-', "\u{2212}"))
    }

    /// A number as short as it can be written without loss.
    pub fn shortest(self, value: f64) -> String {
        self.with_sign(format!("{value}"))
    }

    /// Decimal mark.
    pub fn decimal_sign(self) -> char {
        match self {
            Self::En => '.',
            Self::De => ',',
        }
    }

    pub(super) fn with_sign(self, text: String) -> String {
        text.replace('.', &self.decimal_sign().to_string())
    }
}

impl std::str::FromStr for Language {
    type Err = String;

    fn from_str(code: &str) -> Result<Self, String> {
        let language = Self::ALL
            .into_iter()
            .find(|language| language.code() == code);
        let known = Self::ALL.map(Self::code).join(", ");
        language.ok_or_else(|| format!("no language '{code}'; there are {known}"))
    }
}

/// A number and its unit, which stay on one line.
pub(crate) fn with_unit(number: String, unit: &str) -> String {
    if unit.is_empty() {
        number
    } else {
        format!("{number}\u{a0}{unit}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_language_has_every_key() {
        let english: Vec<_> = MESSAGES["en"].keys().collect();
        for language in Language::ALL {
            let own: Vec<_> = MESSAGES[language.code()].keys().collect();
            assert_eq!(own, english, "{language:?}");
        }
    }

    #[test]
    fn translations_take_the_same_values() {
        let places = |text: &str| {
            (0..5)
                .map(|i| text.contains(&format!("{{{i}}}")))
                .collect::<Vec<_>>()
        };
        for (key, text) in &MESSAGES["en"] {
            assert_eq!(places(text), places(&MESSAGES["de"][key]), "{key}");
        }
    }

    #[test]
    fn numbers_follow_the_language() {
        assert_eq!(Language::De.number(-10.25, 1), "\u{2212}10,2");
        assert_eq!(Language::En.number(-0.001, 2), "0.00");
        assert_eq!(Language::De.shortest(31.5), "31,5");
        assert_eq!(
            Language::En.phrase("remark.refused", &["2", "31"]),
            "2 of 31 points were refused. Their numbers are not results and are not given."
        );
    }
}
