//! Certificate to strings in a language: what HTML and PDF print alike.

use super::model::{Budget, Certificate, Point, PointValues, Remark, Section, Value};
use super::plot;
use super::words::Language;
use serde::Serialize;
use std::collections::BTreeMap;

/// The certificate in words, ready to be set.
#[derive(Clone, Debug, Serialize)]
pub struct Presented {
    /// Language code for the document.
    pub language: &'static str,
    /// Certificate number.
    pub number: String,
    /// Fixed words by their message key, dots replaced by underscores.
    pub words: BTreeMap<String, String>,
    /// Result at the reference point.
    pub headline: Option<Headline>,
    /// Statements.
    pub sections: Vec<PresentedSection>,
    /// The table over frequency.
    pub table: Table,
    /// The statement of conformity, and its name for colours.
    pub conformity: Option<(String, String)>,
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

/// Result at the reference point.
#[derive(Clone, Debug, Serialize)]
pub struct Headline {
    /// "at 160 Hz and 10 m/s2 r.m.s."
    pub at: String,
    /// Sensitivity with U in mV/(m/s2).
    pub per_ms2: String,
    /// Sensitivity with U in mV/g.
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
    /// What is stated, in words.
    pub label: String,
    /// The statement; `None` is missing.
    pub value: Option<String>,
}

/// A table of strings.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    /// Heading and unit of each column.
    pub columns: Vec<(String, String)>,
    /// Rows; refused ones end in the reason.
    pub rows: Vec<Row>,
}

/// A row of the table over frequency.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// One cell per column.
    pub cells: Vec<String>,
    /// True when the point has no result.
    pub refused: bool,
    /// True at the reference point.
    pub reference: bool,
}

/// The budget in words.
#[derive(Clone, Debug, Serialize)]
pub struct PresentedBudget {
    /// Headings.
    pub columns: Vec<String>,
    /// Rows of strings.
    pub rows: Vec<Vec<String>>,
    /// Combined standard uncertainty, %.
    pub combined: String,
    /// Effective degrees of freedom.
    pub degrees: String,
    /// "Expanded uncertainty, k = 2".
    pub expanded_label: String,
    /// Expanded uncertainty, %.
    pub expanded: String,
}

/// A remark in words.
#[derive(Clone, Debug, Serialize)]
pub struct PresentedRemark {
    /// "error", "warning" or "note".
    pub severity: super::model::Severity,
    /// The severity in the language.
    pub label: String,
    /// What is said.
    pub text: String,
}

impl Presented {
    /// Puts a certificate into words.
    pub fn new(certificate: &Certificate, language: Language) -> Self {
        Self {
            language: language.code(),
            number: certificate.number.clone(),
            words: language.words(),
            headline: headline(certificate, language),
            sections: certificate
                .sections
                .iter()
                .map(|s| section(s, language))
                .collect(),
            table: table(certificate, language),
            conformity: conformity(certificate, language),
            introduction: certificate.particulars.texts.introduction.clone(),
            closing: certificate.particulars.texts.closing.clone(),
            as_found: as_found(certificate, language),
            budget: certificate.budget.as_ref().map(|b| budget(b, language)),
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
        Value::List(values) => {
            let words: Vec<String> = values.iter().map(|v| self::value(v, language)).collect();
            words.join("; ")
        }
    }
}

fn with_unit(number: String, unit: &str) -> String {
    if unit.is_empty() {
        number
    } else {
        format!("{number}\u{a0}{unit}")
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

fn conformity(certificate: &Certificate, language: Language) -> Option<(String, String)> {
    certificate.decision.as_ref()?;
    let name = certificate
        .conformity()
        .map_or("none", |conformity| conformity.name());
    Some((
        language.word(&format!("conformity.{name}")).to_owned(),
        name.to_owned(),
    ))
}

/// Degrees of freedom: whole numbers, truncated as GUM G.4.1 does.
fn degrees(value: f64, language: Language) -> String {
    if value.is_infinite() || value >= 1.0e4 {
        "\u{221e}".to_owned()
    } else {
        language.number(value.floor(), 0)
    }
}

fn rounded(rounded: &super::rounding::Rounded, unit: &str, language: Language) -> String {
    let number = |value| language.number(value, rounded.decimals);
    // ISO 80000-1: the degree follows the number without a space.
    let space = if unit == "°" { "" } else { "\u{a0}" };
    format!(
        "({} \u{b1} {}){space}{unit}",
        number(rounded.value),
        number(rounded.uncertainty)
    )
}

fn headline(certificate: &Certificate, language: Language) -> Option<Headline> {
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
    Some(Headline {
        at: language.phrase("result.at", &[&at[0], &at[1]]),
        per_ms2: rounded(&values.printed_mv_per_ms2, "mV/(m/s²)", language),
        per_g: rounded(&values.printed_mv_per_g, "mV/g", language),
        uncertainty: with_unit(language.number(uncertainty, decimals), "%"),
        phase: values.printed_phase_deg.map_or_else(
            || language.word("missing").to_owned(),
            |phase| rounded(&phase, "°", language),
        ),
        coverage: language.phrase("result.coverage", &[&coverage[0], &coverage[1]]),
        polarity: language.word(polarity).to_owned(),
    })
}

/// A column of the table over frequency.
pub(super) struct Column {
    /// Name in templates.
    pub(super) name: &'static str,
    /// Message key after `column.`.
    key: &'static str,
    /// Unit, empty for none.
    unit: &'static str,
    /// Cell of a point.
    cell: fn(&Point, Language) -> String,
}

/// Every column there is, in the order of the built-in layout.
pub(super) const COLUMNS: [Column; 14] = [
    column("frequency", "frequency", "Hz", |p, l| {
        l.shortest(p.nominal_frequency_hz)
    }),
    column("acceleration", "acceleration", "m/s²", |p, l| {
        l.number(p.acceleration_ms2, 3)
    }),
    column("sensitivity", "sensitivity", "mV/(m/s²)", |p, l| {
        cell(p, |v| Some(value_of(&v.printed_mv_per_ms2, l)))
    }),
    column("sensitivity_per_g", "sensitivity", "mV/g", |p, l| {
        cell(p, |v| Some(value_of(&v.printed_mv_per_g, l)))
    }),
    column("uncertainty", "uncertainty", "%", |p, l| {
        cell(p, |v| {
            Some(l.number(
                v.printed_uncertainty_percent.0,
                v.printed_uncertainty_percent.1,
            ))
        })
    }),
    column("coverage_factor", "coverage_factor", "", |p, l| {
        cell(p, |v| Some(l.number(v.coverage_factor, 2)))
    }),
    column("deviation", "deviation", "%", |p, l| {
        cell(p, |v| {
            Some(l.number(v.deviation_percent?, v.printed_uncertainty_percent.1))
        })
    }),
    // One percent is 0.087 dB: one more digit keeps the resolution.
    column("deviation_db", "deviation", "dB", |p, l| {
        cell(p, |v| {
            Some(l.number(v.deviation_db?, v.printed_uncertainty_percent.1 + 1))
        })
    }),
    column("phase", "phase", "°", |p, l| {
        cell(p, |v| Some(value_of(&v.printed_phase_deg?, l)))
    }),
    column("uncertainty_phase", "uncertainty_phase", "°", |p, l| {
        cell(p, |v| {
            v.printed_phase_deg
                .map(|r| l.number(r.uncertainty, r.decimals))
        })
    }),
    column("distortion", "distortion", "%", |p, l| {
        l.number(p.distortion_percent, 2)
    }),
    column("signal_to_noise", "signal_to_noise", "dB", |p, l| {
        l.number(p.signal_to_noise_db, 0)
    }),
    column("coherence", "coherence", "", |p, l| {
        p.coherence.map_or(DASH.to_owned(), |c| l.number(c, 4))
    }),
    column("verdict", "verdict", "", verdict),
];

const fn column(
    name: &'static str,
    key: &'static str,
    unit: &'static str,
    cell: fn(&Point, Language) -> String,
) -> Column {
    Column {
        name,
        key,
        unit,
        cell,
    }
}

/// Printed where there is no number.
const DASH: &str = "\u{2013}";

/// A result, or a dash where there is none.
fn cell(point: &Point, of: impl Fn(&PointValues) -> Option<String>) -> String {
    let values = point.outcome.as_ref().ok();
    values.and_then(of).unwrap_or_else(|| DASH.to_owned())
}

fn value_of(rounded: &super::rounding::Rounded, language: Language) -> String {
    language.number(rounded.value, rounded.decimals)
}

fn verdict(point: &Point, language: Language) -> String {
    match &point.outcome {
        Ok(values) => match values.assessment {
            Some(judged) => language
                .word(&format!("conformity.{}", judged.conformity.name()))
                .to_owned(),
            None => language.word("verdict.pass").to_owned(),
        },
        Err(refusal) => {
            let reason = language.word(&format!("reason.{}", refusal.0)).to_owned();
            format!("{}: {reason}", language.word("verdict.refused"))
        }
    }
}

fn table(certificate: &Certificate, language: Language) -> Table {
    let wanted = &certificate.particulars.layout.columns;
    let broadband = certificate.points.iter().any(|p| p.coherence.is_some());
    let columns: Vec<&Column> = match wanted.is_empty() {
        true => COLUMNS
            .iter()
            .filter(|column| column.name != "coherence" || broadband)
            .collect(),
        false => wanted
            .iter()
            .filter_map(|name| COLUMNS.iter().find(|c| c.name == name))
            .collect(),
    };
    let heading = |column: &&Column| {
        (
            language.word(&format!("column.{}", column.key)).to_owned(),
            column.unit.to_owned(),
        )
    };
    let row = |(index, point): (usize, &Point)| Row {
        cells: columns
            .iter()
            .map(|column| (column.cell)(point, language))
            .collect(),
        refused: point.outcome.is_err(),
        reference: certificate.reference == Some(index),
    };
    Table {
        columns: columns.iter().map(heading).collect(),
        rows: certificate.points.iter().enumerate().map(row).collect(),
    }
}

/// Results before and after an adjustment, side by side.
fn as_found(certificate: &Certificate, language: Language) -> Option<(Table, String)> {
    let found = certificate.as_found.as_deref()?;
    let heading = |key: &str, unit: &str| {
        let word = language.word(&format!("column.{key}")).to_owned();
        (word, unit.to_owned())
    };
    let mut columns = vec![
        heading("frequency", "Hz"),
        heading("acceleration", "m/s²"),
        heading("as_found", "mV/(m/s²)"),
        heading("uncertainty", "%"),
        heading("as_left", "mV/(m/s²)"),
        heading("uncertainty", "%"),
        heading("change", "%"),
    ];
    if certificate.decision.is_some() {
        columns.extend([
            heading("conformity_found", ""),
            heading("conformity_left", ""),
        ]);
    }
    let row = |(index, (left, found)): (usize, (&Point, Option<&Point>))| {
        let mut cells = vec![
            language.shortest(left.nominal_frequency_hz),
            language.shortest(left.nominal_acceleration_ms2),
        ];
        cells.extend(found.map_or([DASH.to_owned(), DASH.to_owned()], |p| state(p, language)));
        cells.extend(state(left, language));
        cells.push(cell(left, |values| {
            let change = super::adjustment::change_percent(found, left)?;
            Some(language.number(change, values.printed_uncertainty_percent.1))
        }));
        if certificate.decision.is_some() {
            cells.push(found.map_or(DASH.to_owned(), |p| verdict(p, language)));
            cells.push(verdict(left, language));
        }
        Row {
            cells,
            refused: left.outcome.is_err(),
            reference: certificate.reference == Some(index),
        }
    };
    let rows = certificate.pairs().enumerate().map(row).collect();
    let day = found.day.map_or(DASH.to_owned(), |day| day.to_string());
    let note = language.phrase("as_found.note", &[&found.number, &day]);
    Some((Table { columns, rows }, note))
}

/// Sensitivity and U of a point.
fn state(point: &Point, language: Language) -> [String; 2] {
    let uncertainty = |values: &PointValues| {
        let (percent, decimals) = values.printed_uncertainty_percent;
        Some(language.number(percent, decimals))
    };
    [
        cell(point, |v| Some(value_of(&v.printed_mv_per_ms2, language))),
        cell(point, uncertainty),
    ]
}

fn budget(budget: &Budget, language: Language) -> PresentedBudget {
    let keys = [
        "quantity",
        "description",
        "value",
        "distribution",
        "factor",
        "coefficient",
        "contribution",
        "degrees",
    ];
    let label = |key: &str| language.word(&format!("budget.{key}")).to_owned();
    let rows = budget.rows.iter().map(|row| {
        let (distribution, parameter) = row.distribution;
        let parameter = parameter
            .map(|value| language.shortest(value))
            .unwrap_or_default();
        vec![
            row.row.to_string(),
            language.word(&format!("row.{}", row.row)).to_owned(),
            significant(row.value_percent, language),
            language.phrase(&format!("distribution.{distribution}"), &[&parameter]),
            language.number(row.factor, 3),
            language.shortest(row.sensitivity_coefficient),
            significant(row.contribution_percent, language),
            degrees(row.degrees_of_freedom, language),
        ]
    });
    PresentedBudget {
        columns: keys.iter().map(|key| label(key)).collect(),
        rows: rows.collect(),
        combined: significant(budget.combined_percent, language),
        degrees: degrees(budget.effective_degrees_of_freedom, language),
        expanded_label: language.phrase(
            "budget.expanded",
            &[&language.number(budget.coverage_factor, 2)],
        ),
        expanded: significant(budget.expanded_percent, language),
    }
}

/// Two significant digits, as the table of Annex D has them.
fn significant(value: f64, language: Language) -> String {
    match super::rounding::round_uncertainty(value, 2) {
        Some((rounded, digit)) => language.number(rounded, usize::try_from(digit).unwrap_or(0)),
        None => language.number(value, 2),
    }
}
