//! The certificate between record and formats: every format renders this.
//!
//! ```text
//! Record --from_record--> Certificate --present--> strings --> HTML, PDF
//!                                     \------------ numbers --> CSV, JSON, DCC, UFF
//! ```
//!
//! Numbers are f64 in the unit their name states; accelerations are r.m.s.,
//! uncertainties expanded. A missing item is `None` and is printed as missing.

use super::deviation::OfRatio;
use super::kind::SensorKind;
use super::particulars::Particulars;
use super::rounding::{Rounded, round_uncertainty};
use crate::decision::{Assessment, Band, Conformity, Decision, Stated};
use calib_core::point::PointResult;
use calib_output::PointView;
use calib_record::hash_chain::Standing;
use jiff::civil::Date;
use schemars::JsonSchema;
use serde::Serialize;

/// Everything a certificate says.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// Number of the certificate, unique for the instrument.
    pub number: String,
    /// Day of calibration, UTC.
    pub day: Option<Date>,
    /// Of a run whose time nobody told, the first and the last day it can be of.
    pub between: Option<(Date, Date)>,
    /// Statements beside the record.
    pub particulars: Particulars,
    /// The quantity that the sensitivities are ones of, and their unit.
    pub kind: SensorKind,
    /// Statements in the order they are printed.
    pub sections: Vec<Section>,
    /// True when the object is inverted in the sense of Annex B.
    pub inverted: bool,
    /// Index of the reference point in `points` (clause 5.3), if one passed.
    pub reference: Option<usize>,
    /// Points in rising frequency, then level.
    pub points: Vec<Point>,
    /// Budget at the reference point.
    pub budget: Option<Budget>,
    /// Specification and rule the results are judged by.
    pub decision: Option<Decision>,
    /// Remarks a reader needs beside the numbers.
    pub remarks: Vec<Remark>,
    /// Certificate from before an adjustment, when this is from after it.
    pub as_found: Option<Box<Certificate>>,
    /// Mounted resonance as the points show it.
    pub resonance: Option<MountedResonance>,
    /// Place of the record in the chain, once somebody looked.
    pub record_chain: Option<Standing>,
    /// Points of the list that were never attempted, Hz.
    pub untried_hz: Vec<f64>,
    /// No first point was asked again at the end of the run and refused.
    pub is_closed: bool,
    /// Measured by an emulated instrument.
    pub simulated: bool,
    /// The chain of the reference is stated in full, was in force, and is a real one's.
    pub traceable: bool,
}

impl Certificate {
    /// The reference point and its result.
    pub fn reference_result(&self) -> Option<(&Point, &PointValues)> {
        let point = self.points.get(self.reference?)?;
        Some((point, point.outcome.as_ref().ok()?))
    }

    /// Results of the points that passed their checks.
    pub fn results(&self) -> impl Iterator<Item = (&Point, &PointValues)> {
        let result = |point| Some((point, Point::values(point)?));
        self.points.iter().filter_map(result)
    }

    /// The statement about the whole object: the worst of all judged points.
    /// `None` when nothing is judged, or when a point without a result, or a first point that could not be repeated
    /// at the end, keeps the others from passing the object; a failure stays one.
    pub fn conformity(&self) -> Option<Conformity> {
        let judged = self.results().filter_map(|(_, values)| values.assessment);
        let worst = judged.map(|assessment| assessment.conformity).max()?;
        let every = self.untried_hz.is_empty() && self.points.iter().all(|p| p.outcome.is_ok());
        let whole = self.is_closed && every;
        (whole || worst == Conformity::Fail).then_some(worst)
    }

    /// [`Self::conformity`] as programs read it.
    pub fn stated_conformity(&self) -> Stated {
        match self.conformity() {
            Some(conformity) => conformity.into(),
            None => self.not_judged(),
        }
    }

    /// Statements about one point, as programs read them.
    pub fn conformity_of(&self, point: &Point) -> Stated {
        match point.values().map(|values| values.assessment) {
            Some(Some(judged)) => judged.conformity.into(),
            // The specification says nothing at this frequency.
            Some(None) if self.decision.is_some() => Stated::NotSpecified,
            _ => self.not_judged(),
        }
    }

    /// Why there is no statement: nobody asked for one, or it cannot be made.
    fn not_judged(&self) -> Stated {
        match self.particulars.decision {
            None => Stated::NotSpecified,
            Some(_) => Stated::NotJudgeable,
        }
    }

    /// Points beside those of the same frequency and level as found.
    pub fn pairs(&self) -> impl Iterator<Item = (&Point, Option<&Point>)> {
        let found = self.as_found.as_deref();
        self.points.iter().map(move |left| {
            let same = |p: &&Point| {
                p.nominal_frequency_hz == left.nominal_frequency_hz
                    && p.nominal_acceleration_ms2 == left.nominal_acceleration_ms2
            };
            (left, found.and_then(|found| found.points.iter().find(same)))
        })
    }

    /// Reasons for which it was issued although something spoke against it.
    pub fn overrides(&self) -> Vec<&str> {
        let stated = &self.particulars.calibration;
        let used = |key: &str| self.remarks.iter().any(|remark| remark.key == key);
        let reasons = [
            ("reference_override", &stated.overdue_reference),
            ("check_override", &stated.check_override),
        ];
        let reasons = reasons.into_iter().filter(|(key, _)| used(key));
        reasons.filter_map(|(_, why)| why.as_deref()).collect()
    }

    /// A statement by section and key.
    pub fn statement(&self, section: &str, key: &str) -> Option<&Value> {
        let section = self.sections.iter().find(|s| s.key == section)?;
        let entry = section.entries.iter().find(|e| e.key == key)?;
        entry.value.as_ref()
    }
}

/// Statements of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Message key after `section.`.
    pub key: &'static str,
    /// Statements in the order they are printed.
    pub entries: Vec<Entry>,
}

/// Key, clause and value of a statement.
pub(super) type Line = (&'static str, &'static str, Option<Value>);

impl Section {
    /// The statements `lines` under a key.
    pub(super) fn new(key: &'static str, lines: impl IntoIterator<Item = Line>) -> Self {
        let entry = |(key, clause, value)| Entry { key, clause, value };
        Self {
            key,
            entries: lines.into_iter().map(entry).collect(),
        }
    }
}

/// One statement.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Key; the message is `<section>.<key>`.
    pub key: &'static str,
    /// Clause that asks for it; empty when none does.
    pub clause: &'static str,
    /// Stated value; `None` is printed as missing.
    pub value: Option<Value>,
}

/// Content of a statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Words of the operator or the instrument.
    Text(String),
    /// A message key and its values.
    Phrase(String, Vec<Value>),
    /// A number, its decimals and its unit.
    Number(f64, usize, &'static str),
    /// A number as it was given, and its unit.
    Exact(f64, &'static str),
    /// A day.
    Day(Date),
    /// Several statements.
    List(Vec<Value>),
    /// A tolerance over a range of frequencies.
    Band(Band),
}

/// One calibration point.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// Nominal frequency, Hz.
    pub nominal_frequency_hz: f64,
    /// Frequency that was played, Hz.
    pub frequency_hz: f64,
    /// Set acceleration, m/s2 r.m.s.
    pub nominal_acceleration_ms2: f64,
    /// Acceleration reached, m/s2 r.m.s.
    pub acceleration_ms2: f64,
    /// Motion of the sensor's kind reached, r.m.s.: m/s2, mm/s or um.
    pub amplitude_rms: f64,
    /// Results, or the reason why there are none.
    pub outcome: Result<PointValues, Refusal>,
    /// The point as the record has it.
    pub measured: PointResult,
    /// The point as every output states it.
    pub view: PointView,
}

impl Point {
    /// Results, if the point passed its checks.
    pub fn values(&self) -> Option<&PointValues> {
        self.outcome.as_ref().ok()
    }
}

/// Why a point has no result: the name of a reason, as in `reason.<name>`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Refusal(pub String);

/// Results of a point that passed its checks.
#[derive(Clone, Debug, PartialEq)]
pub struct PointValues {
    /// Magnitude of the sensitivity, SI unit of the sensor's kind, not rounded.
    pub sensitivity: f64,
    /// Relative expanded uncertainty of the magnitude, %, not rounded.
    pub expanded_uncertainty_percent: f64,
    /// Coverage factor.
    pub coverage_factor: f64,
    /// Effective degrees of freedom, possibly infinite.
    pub effective_degrees_of_freedom: f64,
    /// Phase against the motion of the kind, degrees, not rounded.
    pub phase_deg: f64,
    /// Coverage factor of the phase, where its budget gives the stated U.
    pub coverage_factor_phase: Option<f64>,
    /// Expanded uncertainty of the phase, degrees, not rounded.
    pub expanded_uncertainty_phase_deg: f64,
    /// Deviation from the reference point.
    pub deviation: Option<Deviation>,
    /// Judgement by the decision rule, SI unit of the kind, where something is specified.
    pub assessment: Option<Assessment>,
    /// Sensitivity and U in the unit that certificates of this kind state, as printed.
    pub printed: Rounded,
    /// The sensitivity per standard acceleration of free fall, of a sensor to acceleration.
    pub printed_per_g: Option<Rounded>,
    /// Phase and U in degrees, as printed; `None` when the phase has no U.
    pub printed_phase_deg: Option<Rounded>,
    /// U in %, as printed, with its decimals.
    pub printed_uncertainty_percent: (f64, usize),
}

/// Deviation of a magnitude from that at the reference point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// In percent, not rounded.
    pub percent: f64,
    /// In dB, not rounded.
    pub db: f64,
    /// Its expanded uncertainty, % and dB, and the coverage factor; none at the reference point.
    pub uncertainty: Option<DeviationUncertainty>,
    /// Decimals it is printed with in percent; in dB with one more, one percent being 0.087 dB.
    pub decimals: usize,
}

/// Uncertainty of a [`Deviation`]: what both points share is not in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeviationUncertainty {
    /// Expanded, %, not rounded.
    pub expanded_percent: f64,
    /// Expanded, dB, not rounded.
    pub expanded_db: f64,
    /// Expanded, %, as printed.
    pub printed_percent: f64,
    /// Coverage factor.
    pub coverage_factor: f64,
}

impl Deviation {
    /// That of a ratio to the sensitivity at the reference point. Without an uncertainty it is printed
    /// with `decimals`.
    pub(super) fn new(ratio: f64, uncertainty: Option<OfRatio>, decimals: usize) -> Self {
        let stated = uncertainty.and_then(|of_ratio| {
            let expanded_percent = 100.0 * ratio * of_ratio.expanded_rel;
            let (printed_percent, digit) = round_uncertainty(expanded_percent, 2)?;
            let stated = DeviationUncertainty {
                expanded_percent,
                expanded_db: 20.0 * std::f64::consts::LOG10_E * of_ratio.expanded_rel,
                printed_percent,
                coverage_factor: of_ratio.coverage_factor,
            };
            Some((stated, usize::try_from(digit).unwrap_or(0)))
        });
        Self {
            percent: 100.0 * (ratio - 1.0),
            // Every platform has a logarithm of its own: this one prints the same digits on all.
            db: 20.0 * libm::log10(ratio),
            uncertainty: stated.map(|(stated, _)| stated),
            decimals: stated.map_or(decimals, |(_, decimals)| decimals),
        }
    }
}

/// Budget of the sensitivity at one point, in D.1's shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Budget {
    /// Contributions, by row of Table A.1.
    pub rows: Vec<BudgetRow>,
    /// Combined relative standard uncertainty, %.
    pub combined_percent: f64,
    /// Effective degrees of freedom, possibly infinite.
    pub effective_degrees_of_freedom: f64,
    /// Coverage factor.
    pub coverage_factor: f64,
    /// Relative expanded uncertainty, %.
    pub expanded_percent: f64,
}

/// One line of the budget.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetRow {
    /// Row of Table A.1, 1 to 18.
    pub row: u8,
    /// Expanded uncertainty or bound, %.
    pub value_percent: f64,
    /// Message key of the distribution and its value.
    pub distribution: (&'static str, Option<f64>),
    /// Value over standard uncertainty.
    pub divisor: f64,
    /// Sensitivity coefficient.
    pub sensitivity_coefficient: f64,
    /// Relative contribution, %.
    pub contribution_percent: f64,
    /// Degrees of freedom, possibly infinite.
    pub degrees_of_freedom: f64,
}

/// A remark of the certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct Remark {
    /// How serious it is.
    pub severity: Severity,
    /// Message key after `remark.`.
    pub key: &'static str,
    /// Values of the message.
    pub values: Vec<Value>,
}

/// How serious a remark is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The certificate must not be used.
    Error,
    /// The reader decides whether it matters.
    Warning,
    /// For information.
    Note,
}

/// The mounted resonance of device and mount together, by the points of a record.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MountedResonance {
    /// As the sweep shows it, Hz; none where it does not.
    pub frequency_hz: Option<f64>,
    /// Its expanded uncertainty (k = 2), Hz.
    pub expanded_uncertainty_hz: Option<f64>,
    /// It is no lower than this, Hz; none where the points do not say.
    pub at_least_hz: Option<f64>,
    /// That of the data sheet, Hz; none where nobody stated it.
    pub data_sheet_hz: Option<f64>,
    /// Relative shift of it by torque, grease and face that U contains.
    pub spread_rel: f64,
}
