//! The answer of a diagnosis, as it is written to JSON.

use crate::axis::Axis;
use crate::estimation::gap::Gap;
pub use crate::estimation::verdict::Verdict;
use crate::observable::Group;
use crate::pictures::Pictures;
use crate::thresholds;
use calib_effects::{Of, Scale, Stage, named};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// A place where simulation and measurement differ.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Where {
    /// Stage of the chain it points to.
    pub stage: Stage,
    /// Observable in which it shows.
    pub observable: Group,
    /// Condition along which it varies.
    pub axis: Axis,
    /// Conditions that go with it in these data, so that it may be any of them.
    pub or_along: Vec<Axis>,
    /// Lowest value of that condition (or of frequency).
    pub from: f64,
    /// Highest value.
    pub to: f64,
    /// Share of the excess over noise.
    pub share: f64,
    /// Probability that noise alone does this.
    pub p_value: f64,
    /// Parity or class of the structure.
    pub class: &'static str,
    /// Course of the ratio's magnitude over frequency in words, where a simple one describes it:
    /// `1/f^2`, `1/f`, `log f`, `f`, `f^2`, `corner` (constant below, `1/f^2` above), joined by
    /// " or " where the data allow several.
    pub shape: Option<String>,
}

/// Value and standard uncertainty of a parameter.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Estimate {
    /// Best value.
    pub value: f64,
    /// Standard uncertainty.
    #[serde(rename = "standard_uncertainty")]
    pub u: f64,
}

/// A set of effects with its probability.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Cause {
    /// Names.
    pub effects: Vec<&'static str>,
    /// Posterior probability; those of all sets and `probability_other` add up to 1.
    pub probability: f64,
    /// BIC above the smallest.
    pub delta_bic: f64,
    /// Share of bootstrap samples of the rows (of a record: of its stretches) in which this set is the best.
    pub stability: f64,
    /// Share of the runs without any one of which this set is still the best; none where
    /// there is one run.
    pub stability_over_runs: Option<f64>,
    /// Why to doubt it: sizes that may be zero, values at their bounds. Empty where nothing does.
    pub cautions: Vec<String>,
    /// By effect, by parameter.
    pub parameters: BTreeMap<&'static str, BTreeMap<&'static str, Estimate>>,
}

/// Noise that is not what is stated; all empty where it is.
#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
pub struct OwnNoise {
    /// Scatter over the stated uncertainty, by observable. The gap and all probabilities go by the
    /// scatter.
    pub factor_on_u: BTreeMap<Group, f64>,
    /// Share of its deviate that a row remembers of the row before it, by observable.
    pub memory: BTreeMap<Group, f64>,
    /// Rows of the table, from 1, that no set fits which fits all others. They are left out.
    pub outlier_rows: Vec<usize>,
}

/// Remainder of the leading set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Remainder {
    /// Observable in which most of it is.
    pub observable: Group,
    /// Root mean square of it there, relative as the gap is.
    pub rms_rel: f64,
    /// Condition along which it varies.
    pub axis: Axis,
    /// Lowest value of that condition.
    pub from: f64,
    /// Highest value.
    pub to: f64,
}

/// Gap between records of the simulator and the measurement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Distance {
    /// Root mean square error of the simulator without the effect.
    pub before_rel: f64,
    /// Root mean square error of the simulator with the effect added.
    pub after_rel: f64,
    /// Rows compared.
    pub rows: usize,
}

/// Result of the whole instrument's simulator with a cause added to it.
///
/// No part of the diagnosis: who runs the simulator fills it in.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Confirmation {
    /// Effects that were added, with their values.
    pub effects: Vec<String>,
    /// Ratio and drive together; `None` when no row could be compared.
    pub gap: Option<Distance>,
    /// By observable: `ratio` (complex, but for a constant gain, which is the measurand),
    /// `drive` (magnitude), `ref_harmonics` and `dut_harmonics` (absolute, relative to the
    /// fundamental), `dc` (over the peak of the channel).
    pub by_observable: BTreeMap<Group, Distance>,
    /// Points the simulated instrument refused.
    pub refused: usize,
}

/// Dataset that was read.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct DatasetSummary {
    /// Folder, as given.
    pub path: String,
    /// Number of rows.
    pub rows: usize,
    /// Columns that held values.
    pub columns_used: Vec<String>,
    /// Of a record: whether its input keeps its value until the next sample, as that of a converter does, and is no
    /// smooth signal between them. The record says so itself; none where nothing drives it.
    pub input_held: Option<bool>,
    /// Hash of rig and table.
    pub sha256: String,
}

/// The whole answer; every field is always present.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Answer {
    /// The answer in a sentence or two.
    pub summary: String,
    /// Outcome.
    pub verdict: Verdict,
    /// Where the gap lies, largest first.
    pub r#where: Vec<Where>,
    /// Sets above 1 %, best first.
    pub causes: Vec<Cause>,
    /// Probability that noise leaves as much structure as the best set does.
    pub none_of_these_p_value: f64,
    /// Sets that these data cannot tell apart.
    pub confusable: Vec<Vec<String>>,
    /// Next measurement.
    pub next_measurement: String,
    /// How far the gap shrinks on held-out rows.
    pub gap: Gap,
    /// Remainder of the leading set; none where it is noise.
    pub remainder: Option<Remainder>,
    /// Noise that is not what is stated.
    pub noise: OwnNoise,
    /// Probability of a cause outside the library.
    pub probability_other: f64,
    /// Nominal parameters as fitted within their uncertainty.
    pub nominal_parameters: BTreeMap<&'static str, Estimate>,
    /// Dataset that was read.
    pub dataset: DatasetSummary,
    /// Result of the simulator with the cause added; `None` where nobody asked it.
    pub confirmation: Option<Confirmation>,
    /// Data for the pictures of a report; no part of the JSON.
    #[serde(skip)]
    pub pictures: Pictures,
}

impl Cause {
    /// With its cautions: a size that may be zero, a value at its bound.
    pub(crate) fn with_cautions(mut self, of: Of) -> Self {
        for (id, estimates) in &self.parameters {
            let Some(entry) = named(of, id) else {
                continue;
            };
            for (at, parameter) in entry.parameters.iter().enumerate() {
                let Some(Estimate { value, u }) = estimates.get(parameter.name) else {
                    continue;
                };
                let name = parameter.name;
                let reach = thresholds::AT_BOUND * (parameter.upper - parameter.lower).abs();
                let near = |bound: f64| match parameter.scale {
                    Scale::Log => (value / bound).ln().abs() < thresholds::AT_BOUND,
                    Scale::Linear => {
                        bound != 0.0
                            && (value - bound).abs() < reach.min(thresholds::AT_BOUND * bound.abs())
                    }
                };
                if at < entry.sizes && value.abs() < thresholds::ZERO_SIGMA * u {
                    self.cautions.push(format!("{id}: {name} may be zero"));
                } else if near(parameter.lower) || near(parameter.upper) {
                    self.cautions.push(format!("{id}: {name} is at its bound"));
                }
            }
        }
        self
    }
}

/// The leading set with each other that these data leave possible.
pub(crate) fn hardly_separated(causes: &[Cause], verdict: Verdict) -> Vec<Vec<String>> {
    let name = |c: &Cause| c.effects.join("+");
    match causes {
        [first, rest @ ..] if verdict != Verdict::NoGap => {
            let possible = rest
                .iter()
                .filter(|c| c.probability > thresholds::POSSIBLE_PROBABILITY);
            possible.map(|c| vec![name(first), name(c)]).collect()
        }
        _ => Vec::new(),
    }
}
