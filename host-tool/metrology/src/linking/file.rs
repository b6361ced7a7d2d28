//! The linking file: results of two comparisons in one TOML table.

use super::link::{Linked, link};
use super::reference::OnFailure;
use crate::input::{self, Number, Source, Text};
use calib_files::Result;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;
use toml::Spanned;

const KEYS: &str = "known keys: title, coverage_factor, mandel_paule, and [[cipm]] and [[rmo]] tables with \
laboratory, frequency_hz, value, standard_uncertainty (or expanded_uncertainty with k); \
[[result]] with comparison = \"cipm\" or \"rmo\" is the same; see docs/metrology/linking.md";

/// Which comparison a result belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// The key comparison that sets the reference value.
    Cipm,
    /// The regional comparison to be linked.
    Rmo,
}

/// One result of a laboratory.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkResult {
    /// Comparison.
    pub comparison: Comparison,
    /// Laboratory.
    pub laboratory: String,
    /// Frequency, Hz; `None` when the file has no frequencies.
    pub frequency_hz: Option<f64>,
    /// Result.
    pub value: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
}

/// A checked linking file.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkFile {
    /// Title.
    pub title: String,
    /// Coverage factor of the expanded uncertainties reported.
    pub coverage_factor: f64,
    /// Treatment of inconsistent results; `mandel_paule = false` keeps
    /// the weighted mean.
    pub on_failure: OnFailure,
    /// Results in the order of the file, key comparison first.
    pub results: Vec<LinkResult>,
}

/// A linked frequency.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LinkedFrequency {
    /// Frequency, Hz.
    pub frequency_hz: Option<f64>,
    /// Everything else.
    #[serde(flatten)]
    pub linked: Linked,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Raw {
    title: Option<String>,
    coverage_factor: Option<Number>,
    mandel_paule: Option<bool>,
    #[serde(default)]
    cipm: Vec<Spanned<RawResult>>,
    #[serde(default)]
    rmo: Vec<Spanned<RawResult>>,
    #[serde(default)]
    result: Vec<Spanned<RawResult>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawResult {
    comparison: Option<Text>,
    laboratory: Text,
    frequency_hz: Option<Number>,
    value: Number,
    standard_uncertainty: Option<Number>,
    expanded_uncertainty: Option<Number>,
    k: Option<Number>,
}

/// Reads a linking file.
///
/// # Errors
/// Every fault with file, line and remedy.
pub fn load(path: &Path) -> Result<LinkFile> {
    parse(&Source::read(path)?)
}

/// Reads linking results from text.
///
/// # Errors
/// As [`load`].
pub fn parse(source: &Source) -> Result<LinkFile> {
    let raw: Raw = source.parse_toml(KEYS)?;
    let mut results: Vec<LinkResult> = Vec::new();
    let fixed = [(Comparison::Cipm, &raw.cipm), (Comparison::Rmo, &raw.rmo)];
    let listed = fixed
        .into_iter()
        .flat_map(|(comparison, tables)| tables.iter().map(move |table| (Some(comparison), table)));
    for (comparison, table) in listed.chain(raw.result.iter().map(|table| (None, table))) {
        let result = result(source, comparison, table.get_ref())?;
        let twin = results.iter().any(|other| {
            other.comparison == result.comparison
                && other.laboratory == result.laboratory
                && other.frequency_hz == result.frequency_hz
        });
        if twin {
            return Err(source.at(
                &table.get_ref().laboratory.span(),
                format!("{} has two results at this frequency", result.laboratory),
                "keep one result for each laboratory, frequency and comparison",
            ));
        }
        results.push(result);
    }
    let file = LinkFile {
        title: raw.title.unwrap_or_else(|| "linked comparison".into()),
        coverage_factor: match &raw.coverage_factor {
            Some(number) => input::coverage_factor(source, "coverage_factor", number)?,
            None => 2.0,
        },
        on_failure: match raw.mandel_paule {
            Some(false) => OnFailure::Keep,
            _ => OnFailure::MandelPaule,
        },
        results,
    };
    check_linkable(source, &file)?;
    Ok(file)
}

fn result(source: &Source, comparison: Option<Comparison>, raw: &RawResult) -> Result<LinkResult> {
    let comparison = match (comparison, &raw.comparison) {
        (Some(comparison), None) => comparison,
        (None, Some(text)) if text.get_ref().eq_ignore_ascii_case("cipm") => Comparison::Cipm,
        (None, Some(text)) if text.get_ref().eq_ignore_ascii_case("rmo") => Comparison::Rmo,
        _ => {
            return Err(source.at(
                &raw.laboratory.span(),
                "it is not clear which comparison this result belongs to",
                "use [[cipm]] or [[rmo]], or [[result]] with comparison = \"cipm\" or \"rmo\"",
            ));
        }
    };
    Ok(LinkResult {
        comparison,
        laboratory: raw.laboratory.get_ref().trim().to_owned(),
        frequency_hz: match &raw.frequency_hz {
            Some(number) => Some(input::positive(source, "frequency_hz", number)?),
            None => None,
        },
        value: nonzero(source, &raw.value)?,
        standard_uncertainty: standard_uncertainty(source, raw)?,
    })
}

/// A value the linking coefficient can be formed of.
fn nonzero(source: &Source, number: &Number) -> Result<f64> {
    let value = input::finite(source, "value", number)?;
    match value == 0.0 {
        false => Ok(value),
        true => Err(source.at(
            &number.span(),
            "value = 0: results are linked by a ratio, which zero does not have",
            "phase shifts and other differences cannot be linked this way",
        )),
    }
}

fn standard_uncertainty(source: &Source, raw: &RawResult) -> Result<f64> {
    match (&raw.standard_uncertainty, &raw.expanded_uncertainty) {
        (Some(number), None) => input::positive(source, "standard_uncertainty", number),
        (None, Some(number)) => {
            let expanded = input::positive(source, "expanded_uncertainty", number)?;
            let k = match &raw.k {
                Some(k) => input::coverage_factor(source, "k", k)?,
                None => 2.0,
            };
            Ok(expanded / k)
        }
        _ => Err(source.at(
            &raw.laboratory.span(),
            format!(
                "{} needs one uncertainty, standard or expanded",
                raw.laboratory.get_ref()
            ),
            "add standard_uncertainty = ..., or expanded_uncertainty = ... with k = 2",
        )),
    }
}

fn check_linkable(source: &Source, file: &LinkFile) -> Result<()> {
    if file.frequencies().is_empty() {
        return Err(source.at_line(
            1,
            "there is no result of the regional comparison",
            "add [[rmo]] tables, and [[cipm]] tables of the key comparison",
        ));
    }
    for frequency_hz in file.frequencies() {
        if file.link_at(frequency_hz).is_none() {
            let place = frequency_hz.map_or("no stated frequency".into(), |f| format!("{f} Hz"));
            return Err(source.at_line(
                1,
                format!("no laboratory took part in both comparisons at {place}"),
                "spell linking laboratories alike in [[cipm]] and [[rmo]], or leave this \
                 frequency out",
            ));
        }
    }
    Ok(())
}

impl LinkFile {
    /// Frequencies of the regional comparison, rising.
    pub fn frequencies(&self) -> Vec<Option<f64>> {
        let mut all: Vec<Option<f64>> = self
            .results
            .iter()
            .filter(|result| result.comparison == Comparison::Rmo)
            .map(|result| result.frequency_hz)
            .collect();
        all.sort_by(|a, b| a.unwrap_or(0.0).total_cmp(&b.unwrap_or(0.0)));
        all.dedup();
        all
    }

    /// Links the results at one frequency.
    pub fn link_at(&self, frequency_hz: Option<f64>) -> Option<Linked> {
        let of = |comparison: Comparison| -> Vec<(String, f64, f64)> {
            self.results
                .iter()
                .filter(|result| {
                    result.comparison == comparison && result.frequency_hz == frequency_hz
                })
                .map(|result| {
                    (
                        result.laboratory.clone(),
                        result.value,
                        result.standard_uncertainty,
                    )
                })
                .collect()
        };
        let x = of(Comparison::Cipm);
        match x.is_empty() {
            true => None,
            false => link(
                &x,
                &of(Comparison::Rmo),
                self.coverage_factor,
                self.on_failure,
            ),
        }
    }

    /// Links every frequency.
    pub fn link_all(&self) -> Vec<LinkedFrequency> {
        self.frequencies()
            .into_iter()
            .filter_map(|frequency_hz| {
                let linked = self.link_at(frequency_hz)?;
                Some(LinkedFrequency {
                    frequency_hz,
                    linked,
                })
            })
            .collect()
    }
}
