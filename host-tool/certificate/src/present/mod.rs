//! Certificate to strings in a language: what HTML and PDF print alike.

mod adjustment;
mod budget;
mod columns;
mod headline;
mod table;

use budget::PresentedBudget;
pub(super) use columns::columns;
use headline::Headline;
use table::Table;

use super::conformity_statement::ConformityStatement;
use super::model::{Certificate, Remark, Section, Value};
use super::plot;
use super::words::{Language, with_unit};
use serde::Serialize;
use std::collections::BTreeMap;

/// The certificate in words, ready to be set.
#[derive(Clone, Debug, Serialize)]
pub struct Presented {
    /// Language code for the document.
    pub language: &'static str,
    /// Certificate number.
    pub number: String,
    /// DRAFT, SIMULATED, each with its reason.
    pub marks: Vec<(String, String)>,
    /// Which certificate it replaces, and why.
    pub amendment: Option<String>,
    /// Fixed words by their message key, dots replaced by underscores.
    pub words: BTreeMap<String, String>,
    /// Result at the reference point.
    pub headline: Option<Headline>,
    /// Statements.
    pub sections: Vec<PresentedSection>,
    /// The table over frequency.
    pub table: Table,
    /// Conformity of the whole object in words.
    pub conformity_statement: Option<ConformityStatement>,
    /// Texts of the laboratory above the results.
    pub introduction: Vec<String>,
    /// Texts of the laboratory at the end.
    pub closing: Vec<String>,
    /// Results before and after an adjustment, and a note on them.
    pub as_found: Option<(Table, String)>,
    /// The budget at the reference point.
    pub budget: Option<PresentedBudget>,
    /// Remarks, most serious first.
    pub remarks: Vec<PresentedRemark>,
    /// Sensitivity over frequency, SVG.
    pub plot_sensitivity: String,
    /// Phase over frequency, SVG.
    pub plot_phase: String,
}

/// Statements of one kind.
#[derive(Clone, Debug, Serialize)]
pub struct PresentedSection {
    /// Key of the section.
    pub key: &'static str,
    /// Its heading.
    pub title: String,
    /// Statements in the order they are printed.
    pub entries: Vec<PresentedEntry>,
}

/// One statement.
#[derive(Clone, Debug, Serialize)]
pub struct PresentedEntry {
    /// Key within the section.
    pub key: &'static str,
    /// Statement in words.
    pub label: String,
    /// The statement; `None` is missing.
    pub value: Option<String>,
}

/// A remark in words.
#[derive(Clone, Debug, Serialize)]
pub struct PresentedRemark {
    /// "error", "warning" or "note".
    pub severity: super::model::Severity,
    /// The severity in the language.
    pub label: String,
    /// Text.
    pub text: String,
}

impl Presented {
    /// Puts a certificate into words.
    pub fn new(certificate: &Certificate, language: Language) -> Self {
        Self {
            language: language.code(),
            number: certificate.number.clone(),
            marks: certificate.marks_in_words(language),
            amendment: certificate
                .statement("calibration", "replaces")
                .map(|said| value(said, language)),
            words: language.words(),
            headline: headline::headline(certificate, language),
            sections: certificate
                .sections
                .iter()
                .map(|s| section(s, language))
                .collect(),
            table: table::table(certificate, language),
            conformity_statement: certificate.conformity_statement(language),
            introduction: certificate.particulars.texts.introduction.clone(),
            closing: certificate.particulars.texts.closing.clone(),
            as_found: adjustment::as_found(certificate, language),
            budget: certificate
                .budget
                .as_ref()
                .map(|b| budget::budget(b, language)),
            remarks: certificate
                .remarks
                .iter()
                .map(|r| remark(r, language))
                .collect(),
            plot_sensitivity: plot::sensitivity(certificate, language),
            plot_phase: plot::phase(certificate, language),
        }
    }
}

/// A statement in words.
pub(super) fn value(value: &Value, language: Language) -> String {
    match value {
        Value::Text(text) => text.clone(),
        Value::Phrase(key, values) => {
            let values: Vec<String> = values.iter().map(|v| self::value(v, language)).collect();
            let values: Vec<&str> = values.iter().map(String::as_str).collect();
            language.phrase(key, &values)
        }
        Value::Number(number, decimals, unit) => {
            with_unit(language.number(*number, *decimals), unit)
        }
        Value::Exact(number, unit) => with_unit(language.shortest(*number), unit),
        Value::Day(day) => day.to_string(),
        Value::Band(band) => super::conformity_statement::band_words(band, language),
        Value::List(values) => {
            let words: Vec<String> = values.iter().map(|v| self::value(v, language)).collect();
            words.join("; ")
        }
    }
}

fn section(section: &Section, language: Language) -> PresentedSection {
    let entries = section.entries.iter().map(|entry| {
        let label = format!("{}.{}", section.key, entry.key);
        let label = language.word(&label);
        PresentedEntry {
            key: entry.key,
            label: label.to_owned(),
            value: entry.value.as_ref().map(|v| value(v, language)),
        }
    });
    PresentedSection {
        key: section.key,
        title: language
            .word(&format!("section.{}", section.key))
            .to_owned(),
        entries: entries.collect(),
    }
}

impl Certificate {
    /// A remark in words, by its key.
    pub fn remark(&self, key: &str, language: Language) -> Option<String> {
        let mut remarks = self.remarks.iter();
        let remark = remarks.find(|remark| remark.key == key)?;
        Some(remark_text(remark, language))
    }
}

/// A remark as a sentence.
pub(super) fn remark_text(remark: &Remark, language: Language) -> String {
    let values: Vec<String> = remark.values.iter().map(|v| value(v, language)).collect();
    let values: Vec<&str> = values.iter().map(String::as_str).collect();
    language.phrase(&format!("remark.{}", remark.key), &values)
}

fn remark(remark: &Remark, language: Language) -> PresentedRemark {
    let severity = format!("severity.{:?}", remark.severity).to_lowercase();
    PresentedRemark {
        severity: remark.severity,
        label: language.word(&severity).to_owned(),
        text: remark_text(remark, language),
    }
}
