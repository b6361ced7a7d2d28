//! JSON: every number of the certificate, not rounded, in the keys of every output.
//!
//! ```text
//! { "certificate", "marks", "missing", "replaces", "language", "item": {..}, "calibration": {..}, ..., "inverted",
//!   "reference": {point}, "points": [{point}], "conformity", "conformity_statement", "budget": {..},
//!   "as_found": {..}, "mounted_resonance": {..}, "record_chain", "remarks": [..] }
//! ```

use super::conformity_statement::ConformityStatement;
use super::from_record::closing_remark;
use super::kind::{Output, SensorKind};
use super::marks::Mark;
use super::model::MountedResonance;
use super::model::{self, Certificate, Point, Section, Severity};
use super::particulars::Amendment;
use super::rounding::Rounded;
use super::words::Language;
use crate::decision::{Limits, Stated};
use calib_files::{Error, Result};
use calib_output::{PointView, SetPoint, json};
use calib_protocol::record::Record;
use calib_record::hash_chain::Standing;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// The certificate as JSON, UTF-8, with a newline at the end.
///
/// # Errors
/// [`Error::Input`] if the writer fails, which memory does not.
pub(super) fn render(certificate: &Certificate, language: Language) -> Result<Vec<u8>> {
    json::document(&Document::new(certificate, language))
        .map(String::into_bytes)
        .map_err(|error| Error::input("JSON", error.to_string(), "report this as a defect"))
}

/// Statements in words by their key; none where nothing is stated.
type Statements = BTreeMap<&'static str, Option<String>>;

/// A certificate for programs.
#[derive(Serialize, JsonSchema)]
pub struct Document {
    /// Number of the certificate.
    certificate: String,
    /// Marks of a document that is no complete certificate: `simulated`, `draft`; empty for a complete one.
    marks: Vec<Mark>,
    /// Items a draft lacks, in words.
    missing: Vec<String>,
    /// The certificate that this one replaces, and why; none when it replaces none.
    replaces: Option<Amendment>,
    /// Language of the statements, ISO 639-1.
    language: &'static str,
    /// Statements by section.
    #[serde(flatten)]
    sections: BTreeMap<&'static str, Statements>,
    /// Quantity and unit of `in_unit` of the points.
    kind: Kind,
    /// The object is inverted in the sense of Annex B, against its own motion.
    inverted: bool,
    /// The reference point (ISO 16063-21, 5.3); none when no point is valid.
    reference: Option<JudgedPoint>,
    /// Points in rising frequency, then level.
    points: Vec<JudgedPoint>,
    /// Statements about the whole object.
    conformity: Stated,
    /// Conformity in words, with the reason; none when no tolerance was stated.
    conformity_statement: Option<ConformityStatement>,
    /// Budget at the reference point.
    budget: Option<Budget>,
    /// Results before an adjustment.
    as_found: Option<AsFound>,
    /// The mounted resonance by the points; none where there is none from 1 kHz on.
    mounted_resonance: Option<MountedResonance>,
    /// Place of the record in the chain; none when nobody looked.
    record_chain: Option<Standing>,
    /// Remarks a reader needs beside the numbers.
    remarks: Vec<Remark>,
}

impl Document {
    /// The certificate with its statements in words of `language`.
    pub fn new(certificate: &Certificate, language: Language) -> Self {
        let points: Vec<JudgedPoint> = judged(certificate).collect();
        let sections = certificate.sections.iter();
        Self {
            certificate: certificate.number.clone(),
            marks: certificate.marks(),
            missing: certificate
                .missing()
                .iter()
                .map(|key| language.word(key).to_owned())
                .collect(),
            replaces: certificate.particulars.calibration.replaces.clone(),
            language: language.code(),
            sections: sections
                .map(|section| (section.key, statements(section, language)))
                .collect(),
            kind: Kind::from(certificate.kind),
            inverted: certificate.inverted,
            reference: certificate
                .reference
                .and_then(|index| points.get(index).cloned()),
            points,
            conformity: certificate.stated_conformity(),
            conformity_statement: certificate.conformity_statement(language),
            budget: certificate.budget.as_ref().map(Budget::from),
            as_found: as_found(certificate),
            mounted_resonance: certificate.resonance,
            record_chain: certificate.record_chain,
            remarks: certificate
                .remarks
                .iter()
                .map(|said| remark(said, language))
                .collect(),
        }
    }
}

/// A point with what the certificate makes of it.
#[derive(Clone, Serialize, JsonSchema)]
struct JudgedPoint {
    #[serde(flatten)]
    measured: PointView,
    /// Relative deviation from the reference point.
    deviation_rel: Option<f64>,
    /// Deviation in dB.
    deviation_db: Option<f64>,
    /// Expanded uncertainty of the deviation, relative to the reference point; none there.
    expanded_uncertainty_deviation_rel: Option<f64>,
    /// Expanded uncertainty of the deviation, dB.
    expanded_uncertainty_deviation_db: Option<f64>,
    /// Its coverage factor.
    coverage_factor_deviation: Option<f64>,
    /// Statements about the point.
    conformity: Stated,
    /// Lower limit of the tolerance, V/(m/s2); none for sensors of another kind.
    lower_limit_v_per_ms2: Option<f64>,
    /// Upper limit of the tolerance, V/(m/s2); none for sensors of another kind.
    upper_limit_v_per_ms2: Option<f64>,
    /// Probability of a false acceptance; none when it is not accepted.
    false_accept_probability: Option<f64>,
    /// Probability of a false rejection; none when it is accepted.
    false_reject_probability: Option<f64>,
    /// Result in the quantity and unit of the sensor (`kind`); what the instrument measured stands beside it as it is,
    /// volts of the whole chain against acceleration.
    in_unit: Option<InUnit>,
    /// Sensitivity and U as printed, mV/(m/s2); none for sensors of another kind.
    printed_mv_per_ms2: Option<Rounded>,
    /// Sensitivity and U as printed, mV per standard acceleration of free fall; none for sensors of another kind.
    printed_mv_per_g: Option<Rounded>,
    /// Phase against the motion of the kind and its U as printed, degrees.
    printed_phase_deg: Option<Rounded>,
}

fn judged(certificate: &Certificate) -> impl Iterator<Item = JudgedPoint> {
    let (kind, as_measured) = (certificate.kind, certificate.kind.is_as_measured());
    let unit = kind.unit();
    let point = move |point: &Point| {
        let values = point.values();
        let judged = values.and_then(|v| v.assessment);
        let deviation = values.and_then(|v| v.deviation);
        let of_deviation = deviation.and_then(|d| d.uncertainty);
        let limit = |of: fn(Limits) -> f64| {
            let limit = judged.map(|judged| of(judged.tolerance));
            limit.filter(|limit| limit.is_finite())
        };
        JudgedPoint {
            measured: point.view.clone(),
            deviation_rel: deviation.map(|d| d.percent / 100.0),
            deviation_db: deviation.map(|d| d.db),
            expanded_uncertainty_deviation_rel: of_deviation.map(|u| u.expanded_percent / 100.0),
            expanded_uncertainty_deviation_db: of_deviation.map(|u| u.expanded_db),
            coverage_factor_deviation: of_deviation.map(|u| u.coverage_factor),
            conformity: certificate.conformity_of(point),
            lower_limit_v_per_ms2: limit(|tolerance| tolerance.lower).filter(|_| as_measured),
            upper_limit_v_per_ms2: limit(|tolerance| tolerance.upper).filter(|_| as_measured),
            false_accept_probability: judged.and_then(|j| j.false_accept),
            false_reject_probability: judged.and_then(|j| j.false_reject),
            in_unit: values.map(|v| InUnit {
                sensitivity: unit.of_si(v.sensitivity),
                expanded_uncertainty: unit.of_si(v.sensitivity) * v.expanded_uncertainty_percent
                    / 100.0,
                phase_deg: v.phase_deg,
                amplitude_rms: point.amplitude_rms,
                lower_limit: limit(|tolerance| tolerance.lower).map(|si| unit.of_si(si)),
                upper_limit: limit(|tolerance| tolerance.upper).map(|si| unit.of_si(si)),
            }),
            printed_mv_per_ms2: values.map(|v| v.printed).filter(|_| as_measured),
            printed_mv_per_g: values.and_then(|v| v.printed_per_g).filter(|_| as_measured),
            printed_phase_deg: values.and_then(|v| v.printed_phase_deg),
        }
    };
    certificate.points.iter().map(point)
}

/// Quantity and unit of a sensitivity.
#[derive(Clone, Serialize, JsonSchema)]
struct Kind {
    /// Motion: `acceleration`, `velocity` or `displacement`.
    quantity: &'static str,
    /// Output of the sensor: `voltage`, `charge` or `current`.
    output: Output,
    /// Unit of the sensitivity.
    unit: &'static str,
    /// Gain of the charge amplifier or burden, with its expanded uncertainty; none of a voltage.
    conditioner: Option<String>,
}

impl From<SensorKind> for Kind {
    fn from(kind: SensorKind) -> Self {
        Self {
            quantity: kind.quantity_name(),
            output: kind.unit().output(),
            unit: kind.unit().name(),
            conditioner: kind.conditioner_words(),
        }
    }
}

/// A result in the unit of `kind`.
#[derive(Clone, Serialize, JsonSchema)]
struct InUnit {
    /// Magnitude of the sensitivity.
    sensitivity: f64,
    /// Its expanded uncertainty.
    expanded_uncertainty: f64,
    /// Phase against the motion of the kind, degrees; polarity is apart.
    phase_deg: f64,
    /// Motion that was reached, r.m.s.: m/s2, mm/s or um.
    amplitude_rms: f64,
    /// Lower limit of the tolerance.
    lower_limit: Option<f64>,
    /// Upper limit of the tolerance.
    upper_limit: Option<f64>,
}

/// The certificate as found, and the change of each point since.
#[derive(Serialize, JsonSchema)]
struct AsFound {
    /// Number of the certificate as found.
    certificate: String,
    /// Day of that calibration, ISO 8601.
    calibrated_day: Option<String>,
    /// Statement about the whole object.
    conformity: Stated,
    /// Points as found.
    points: Vec<JudgedPoint>,
    /// Change of each point as left.
    pairs: Vec<Change>,
}

/// Change of a point by the adjustment.
#[derive(Serialize, JsonSchema)]
struct Change {
    #[serde(flatten)]
    set: SetPoint,
    /// Relative change of the sensitivity; none without one as found.
    change_rel: Option<f64>,
}

fn as_found(certificate: &Certificate) -> Option<AsFound> {
    let found = certificate.as_found.as_deref()?;
    let change = |(left, found): (&Point, Option<&Point>)| Change {
        set: left.view.set,
        change_rel: super::adjustment::change_percent(found, left).map(|c| c / 100.0),
    };
    Some(AsFound {
        certificate: found.number.clone(),
        calibrated_day: found.day.map(|day| day.to_string()),
        conformity: found.stated_conformity(),
        points: judged(found).collect(),
        pairs: certificate.pairs().map(change).collect(),
    })
}

fn statements(section: &Section, language: Language) -> Statements {
    let said = |value: &model::Value| super::present::value(value, language);
    let entries = section.entries.iter();
    entries
        .map(|entry| (entry.key, entry.value.as_ref().map(said)))
        .collect()
}

/// Budget of the sensitivity at the reference point.
#[derive(Serialize, JsonSchema)]
struct Budget {
    /// Contributions, by row of Table A.1.
    components: Vec<BudgetRow>,
    /// Combined relative standard uncertainty.
    combined_standard_uncertainty_rel: f64,
    /// Effective degrees of freedom; none when infinite.
    effective_degrees_of_freedom: Option<f64>,
    /// Coverage factor.
    coverage_factor: f64,
    /// Relative expanded uncertainty.
    expanded_uncertainty_rel: f64,
}

/// One line of the budget.
#[derive(Serialize, JsonSchema)]
struct BudgetRow {
    /// Row of Table A.1, 1 to 18.
    row: u8,
    /// Relative expanded uncertainty or bound.
    value_rel: f64,
    /// Distribution, in snake case.
    distribution: &'static str,
    /// Its parameter, such as the coverage factor of a normal one.
    distribution_parameter: Option<f64>,
    /// Value over standard uncertainty.
    divisor: f64,
    /// Sensitivity coefficient.
    sensitivity_coefficient: f64,
    /// Relative contribution.
    contribution_rel: f64,
    /// Degrees of freedom; none when infinite.
    degrees_of_freedom: Option<f64>,
}

impl From<&model::Budget> for Budget {
    fn from(budget: &model::Budget) -> Self {
        let finite = |value: f64| value.is_finite().then_some(value);
        let row = |row: &model::BudgetRow| BudgetRow {
            row: row.row,
            value_rel: row.value_percent / 100.0,
            distribution: row.distribution.0,
            distribution_parameter: row.distribution.1,
            divisor: row.divisor,
            sensitivity_coefficient: row.sensitivity_coefficient,
            contribution_rel: row.contribution_percent / 100.0,
            degrees_of_freedom: finite(row.degrees_of_freedom),
        };
        Self {
            components: budget.rows.iter().map(row).collect(),
            combined_standard_uncertainty_rel: budget.combined_percent / 100.0,
            effective_degrees_of_freedom: finite(budget.effective_degrees_of_freedom),
            coverage_factor: budget.coverage_factor,
            expanded_uncertainty_rel: budget.expanded_percent / 100.0,
        }
    }
}

/// A remark of the certificate.
#[derive(Serialize, JsonSchema)]
struct Remark {
    /// How serious it is.
    severity: Severity,
    /// Subject, in snake case.
    key: &'static str,
    /// In words.
    text: String,
}

/// Remark of a certificate of the record about the first point's repetition at the end of the run; none unless
/// the sensitivity changed meanwhile, or nobody knows.
pub fn said_of_closing(record: &Record, language: Language) -> Option<String> {
    closing_remark(record).map(|said| remark(&said, language).text)
}

fn remark(remark: &model::Remark, language: Language) -> Remark {
    Remark {
        severity: remark.severity,
        key: remark.key,
        text: super::present::remark_text(remark, language),
    }
}
