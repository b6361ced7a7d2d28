//! Detection and naming over the size of a gap.

use super::answers::Pair;
use super::rates::Share;
use schemars::JsonSchema;
use serde::Serialize;

/// Edges of the sizes over which detection and naming are counted, in sigma.
const SIZE_EDGES: [f64; 7] = [1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1001.0];
/// Deviate of a one-sided test with 1 % false alarms.
const DEVIATE_OF_ONE_PERCENT: f64 = 2.326_347_874;

/// Detection and naming of effects of one range of sizes.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SizeScore {
    /// Smallest size, standard uncertainties of the whole dataset.
    pub from_sigma: f64,
    /// Largest.
    pub to_sigma: f64,
    /// Anything but "no gap".
    pub detected: Share,
    /// The best set is the true one.
    pub named: Share,
    /// Detection by a likelihood ratio that knows form and size, with 1 % false
    /// alarms: no diagnosis does better.
    pub best_possible: f64,
}

pub(super) fn sizes(cases: &[Pair<'_>]) -> Vec<SizeScore> {
    let mut scores = Vec::new();
    for edge in SIZE_EDGES.windows(2) {
        let inside = |c: &&Pair<'_>| (edge[0]..edge[1]).contains(&c.truth.size_sigma);
        let chosen: Vec<&Pair<'_>> = cases.iter().filter(inside).collect();
        let count = |test: &dyn Fn(&Pair<'_>) -> bool| {
            Share::new(chosen.iter().filter(|c| test(c)).count(), chosen.len())
        };
        let power = |c: &&Pair<'_>| normal(c.truth.size_sigma - DEVIATE_OF_ONE_PERCENT);
        if !chosen.is_empty() {
            scores.push(SizeScore {
                from_sigma: edge[0],
                to_sigma: edge[1],
                detected: count(&|c| c.alarmed()),
                named: count(&|c| c.named()),
                best_possible: chosen.iter().map(power).sum::<f64>() / chosen.len() as f64,
            });
        }
    }
    scores
}

/// Distribution function of the standard normal.
fn normal(z: f64) -> f64 {
    0.5 * statrs::function::erf::erfc(-z / std::f64::consts::SQRT_2)
}
