//! One statistic: the mean over 63 Hz to 250 Hz of a result over an earlier one, or over the certificate.

use super::budget::{self, Row, Spread};
use super::evaluate::Evaluation;
use schemars::JsonSchema;
use serde::Serialize;

/// Band of the statistic, Hz: where a check is best.
pub const STATISTIC_HZ: [f64; 2] = [63.0, 250.0];
/// Coverage factor of 99 %: of sound references one in a hundred is suspected.
const FACTOR_99: f64 = 2.576;
/// Fewest frequencies of the statistic.
const FEWEST: usize = 3;

/// With what a result is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Against {
    /// A check with the same equipment: what the equipment does to both cancels.
    Baseline,
    /// The reference's certificate.
    Certificate,
}

/// By how much the reference changed, or differs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Change {
    /// With what it is compared.
    pub against: Against,
    /// Frequencies it is the mean of.
    pub frequencies: usize,
    /// Result over what it is compared with, less 1.
    pub change_rel: f64,
    /// Its expanded uncertainty, k = 2.
    #[serde(rename = "expanded_uncertainty_change_rel")]
    pub expanded_rel: f64,
    /// It is beyond what 99 % of sound references show.
    pub significant: bool,
}

/// Comparison over all frequencies, to which each row adds its part.
struct Compared {
    logarithm: f64,
    count: usize,
    square: f64,
}

impl Compared {
    fn judged(self, against: Against) -> Change {
        let standard = self.square.sqrt();
        let change_rel = self.logarithm.exp() - 1.0;
        Change {
            against,
            frequencies: self.count,
            change_rel,
            expanded_rel: 2.0 * standard,
            significant: change_rel.abs() > FACTOR_99 * standard,
        }
    }
}

pub(super) fn is_within(frequency_hz: f64) -> bool {
    // Nominal frequencies and those played differ by less than a thousandth.
    (STATISTIC_HZ[0] * 0.999..=STATISTIC_HZ[1] * 1.001).contains(&frequency_hz)
}

/// Square of the standard uncertainty of the mean by the rows that are taken.
fn square(rows: &[Row], indices: &[usize], takes: impl Fn(Spread) -> bool) -> f64 {
    let means = budget::means(rows, indices);
    let rows = rows.iter().zip(means).filter(|(row, _)| takes(row.spread));
    rows.map(|(_, mean)| mean * mean).sum()
}

/// Square of what the coefficient of the reference leaves between two temperatures that were told.
fn warmer_square(now: &Evaluation, baseline: &Evaluation) -> f64 {
    let [_, per_k] = now.equipment.reference_per_k;
    let told = now.temperature_c.zip(baseline.temperature_c);
    told.map_or(0.0, |(now, then)| (per_k * (now - then)).powi(2))
}

/// By how much the reference changed since another check with the same calibrator and equipment; none where
/// fewer than three frequencies are in both, or mass, shunt, divider or hold are others.
///
/// # Accuracy
/// `./run bench selfcheck`: of sound references at most 1 % are suspected, a change of 0.5 % is found in 99 %.
pub fn change(now: &Evaluation, baseline: &Evaluation) -> Option<Change> {
    if !now.equipment.is_that_of(&baseline.equipment) {
        return None;
    }
    let place = |hz: f64| {
        let same = |frequency_hz: f64| (frequency_hz / hz - 1.0).abs() < 1e-3;
        baseline
            .points
            .iter()
            .position(|point| same(point.frequency_hz))
    };
    let both = now.points.iter().enumerate().filter_map(|(index, point)| {
        let other = place(point.frequency_hz).filter(|_| is_within(point.frequency_hz))?;
        Some((index, other))
    });
    let both: Vec<(usize, usize)> = both.collect();
    let (of_now, of_baseline): (Vec<usize>, Vec<usize>) = both.iter().copied().unzip();
    let logarithms = both.iter().map(|(index, other)| {
        let [now, then] = [now.points[*index], baseline.points[*other]];
        (now.sensitivity_v_per_ms2 / then.sensitivity_v_per_ms2).ln()
    });
    let varies = |spread| spread != Spread::OfTheEquipment;
    let compared = Compared {
        logarithm: logarithms.sum::<f64>() / both.len().max(1) as f64,
        count: both.len(),
        square: square(&now.budget, &of_now, varies)
            + square(&baseline.budget, &of_baseline, varies)
            + warmer_square(now, baseline),
    };
    (both.len() >= FEWEST).then(|| compared.judged(Against::Baseline))
}

/// By how much the reference differs from its certificate, whose uncertainty counts as one quantity; none with
/// fewer than three frequencies.
pub fn from_certificate(now: &Evaluation) -> Option<Change> {
    let within = |index: &usize| is_within(now.points[*index].frequency_hz);
    let indices: Vec<usize> = (0..now.points.len()).filter(within).collect();
    let count = indices.len().max(1) as f64;
    let mean = |of: fn(&super::CheckPoint) -> f64| {
        indices
            .iter()
            .map(|index| of(&now.points[*index]))
            .sum::<f64>()
            / count
    };
    let certified = mean(|point| point.certified_expanded_uncertainty_rel) / 2.0;
    let compared = Compared {
        logarithm: mean(|point| (1.0 + point.change_rel).ln()),
        count: indices.len(),
        square: square(&now.budget, &indices, |_| true) + certified * certified,
    };
    (indices.len() >= FEWEST).then(|| compared.judged(Against::Certificate))
}

impl Change {
    /// In one sentence.
    pub fn words(&self) -> String {
        let value = format!(
            "{:+.2} % +- {:.2} %",
            100.0 * self.change_rel,
            100.0 * self.expanded_rel
        );
        match (self.against, self.significant) {
            (Against::Baseline, true) => format!("changed by {value} since the baseline"),
            (Against::Baseline, false) => format!("no change since the baseline: {value}"),
            (Against::Certificate, true) => format!("differs from the certificate by {value}"),
            (Against::Certificate, false) => format!("agrees with the certificate: {value}"),
        }
    }
}
