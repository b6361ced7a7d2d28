//! The share of the gap that is closed on rows that took no part.

use super::fit::Fit;
use super::problem::Problem;
use crate::dataset::Rig;
use crate::model::row::{CURRENT, DC, DRIVE, DUT_HARMONICS, NOISE, RATIO, REF_HARMONICS, SLOTS};
use serde::Serialize;
use std::collections::BTreeMap;

/// Observables with the slots they fill.
pub(crate) const OBSERVABLES: [(&str, usize, usize); 7] = [
    ("ratio", RATIO, DRIVE),
    ("drive", DRIVE, CURRENT),
    ("current", CURRENT, REF_HARMONICS),
    ("ref_harmonics", REF_HARMONICS, DUT_HARMONICS),
    ("dut_harmonics", DUT_HARMONICS, DC),
    ("dc", DC, NOISE),
    ("noise", NOISE, SLOTS),
];

/// Gap of one observable on the held-out rows.
#[derive(Debug, Clone, Serialize)]
pub struct ObservableGap {
    /// Root mean square relative error of the nominal simulation, in percent.
    pub before_percent: f64,
    /// The same with the named effects added.
    pub after_percent: f64,
    /// What measurement noise alone leaves.
    pub floor_percent: f64,
    /// Share that was closed; none where there was no gap.
    pub closed: Option<f64>,
    /// Root mean square of error over standard uncertainty, before.
    pub chi_before: f64,
    /// The same, after.
    pub chi_after: f64,
}

/// Gap over all observables on the held-out rows.
#[derive(Debug, Clone, Serialize)]
pub struct Gap {
    /// See [`ObservableGap`]; ratio, drive and current (or what there is) pooled.
    pub before_percent: f64,
    /// See [`ObservableGap`].
    pub after_percent: f64,
    /// See [`ObservableGap`].
    pub floor_percent: f64,
    /// Mean of the observables' shares, weighted by the excess of their chi-square.
    pub closed: Option<f64>,
    /// See [`ObservableGap`].
    pub chi_before: f64,
    /// See [`ObservableGap`].
    pub chi_after: f64,
    /// Rows that took no part in choosing or fitting.
    pub held_out_rows: usize,
    /// Effects chosen on the other rows.
    pub chosen: Vec<&'static str>,
    /// Simulation error of a record in the unit of its output, r.m.s., before.
    pub rms_before: Option<f64>,
    /// The same, after.
    pub rms_after: Option<f64>,
    /// By observable.
    pub by_observable: BTreeMap<&'static str, ObservableGap>,
    /// By level, each fitted without it; empty where there is one level or none.
    ///
    /// Of points: r.m.s. acceleration, in m/s2. Of a record: largest output of a
    /// stretch of the held-out part, in its unit.
    pub by_level: Vec<Slice>,
    /// By band of frequency in Hz, each fitted without it.
    pub by_band: Vec<Slice>,
}

/// Gap on one level or band that took no part in the fit.
///
/// Of points: fitted to the rows of all other levels (bands). Of a record: the
/// stretches of this level in the held-out part, or the spectrum of its errors.
#[derive(Debug, Clone, Serialize)]
pub struct Slice {
    /// Lowest level or frequency.
    pub from: f64,
    /// Highest.
    pub to: f64,
    /// Points or samples; of a band of a record, spectral lines.
    pub rows: usize,
    /// Whether it lies at or beyond the edge of what was fitted.
    pub beyond: bool,
    /// What the fit without it chose; empty where the cause does not pay there.
    pub chosen: Vec<&'static str>,
    /// See [`ObservableGap`]; of a band of a record relative to the whole output.
    pub before_percent: f64,
    /// See [`ObservableGap`].
    pub after_percent: f64,
    /// See [`ObservableGap`].
    pub floor_percent: f64,
    /// See [`Gap`]; none where no observable stands out of its noise.
    pub closed: Option<f64>,
    /// See [`ObservableGap`].
    pub chi_before: f64,
    /// See [`ObservableGap`].
    pub chi_after: f64,
}

impl Slice {
    /// A part of the conditions with the gap in it.
    pub(crate) fn new((from, to): (f64, f64), gap: &Gap) -> Self {
        let is_gap = gap.by_observable.values().any(|o| o.closed.is_some());
        Self {
            from,
            to,
            rows: gap.held_out_rows,
            beyond: false,
            chosen: gap.chosen.clone(),
            before_percent: gap.before_percent,
            after_percent: gap.after_percent,
            floor_percent: gap.floor_percent,
            closed: gap.closed.filter(|_| is_gap),
            chi_before: gap.chi_before,
            chi_after: gap.chi_after,
        }
    }
}

/// Rows to choose and fit on, and rows that take no part: every third frequency.
pub(crate) fn split(problem: &Problem, rig: &Rig) -> (Problem, Problem) {
    let held = held_out(problem);
    let training = problem.subset(rig, &|row| !held[row]);
    let testing = problem.subset(rig, &|row| held[row]);
    (training, testing)
}

/// Scores fits of one problem on another with the same rig.
pub(crate) fn score_on(training: &Problem, testing: &Problem, nominal: &Fit, chosen: &Fit) -> Gap {
    let before = errors(training, testing, nominal);
    let after = errors(training, testing, chosen);
    let mut by_observable = BTreeMap::new();
    let (mut closed, mut weights) = (0.0, 0.0);
    let mut pooled = [0.0; 4];
    let mut chi = [0.0; 3];
    let has_response = !testing.slots[0..REF_HARMONICS]
        .iter()
        .all(std::ops::Range::is_empty);
    for (index, (name, _, _)) in OBSERVABLES.into_iter().enumerate() {
        let (b, a) = (&before[index], &after[index]);
        if b.rows == 0.0 {
            continue;
        }
        let percent = |sum: f64| 100.0 * (sum / b.rows).sqrt();
        let (e_before, e_after, e_floor) = (percent(b.square), percent(a.square), percent(b.floor));
        let excess = b.chi - b.data;
        let is_gap = excess > 4.0 * (2.0 * b.data).sqrt() && e_before > e_floor;
        let share = ((e_before - e_after) / (e_before - e_floor)).clamp(-9.0, 1.0);
        if is_gap {
            closed += share * excess;
            weights += excess;
        }
        let pool = if has_response { index < 3 } else { true };
        if pool {
            for (sum, value) in pooled.iter_mut().zip([b.square, a.square, b.floor, b.rows]) {
                *sum += value;
            }
        }
        for (sum, value) in chi.iter_mut().zip([b.chi, a.chi, b.data]) {
            *sum += value;
        }
        by_observable.insert(
            name,
            ObservableGap {
                before_percent: e_before,
                after_percent: e_after,
                floor_percent: e_floor,
                closed: is_gap.then_some(share),
                chi_before: (b.chi / b.data).sqrt(),
                chi_after: (a.chi / b.data).sqrt(),
            },
        );
    }
    let percent = |sum: f64| 100.0 * (sum / pooled[3].max(1.0)).sqrt();
    Gap {
        before_percent: percent(pooled[0]),
        after_percent: percent(pooled[1]),
        floor_percent: percent(pooled[2]),
        closed: if weights > 0.0 {
            Some(closed / weights)
        } else if !chosen.effects.is_empty() && pooled[0] > pooled[2] {
            // No observable stands out of its noise by itself: what all of them together show.
            let [before, after, floor] = [pooled[0], pooled[1], pooled[2]].map(percent);
            Some(((before - after) / (before - floor)).clamp(-9.0, 1.0))
        } else {
            None
        },
        chi_before: (chi[0] / chi[2].max(1.0)).sqrt(),
        chi_after: (chi[1] / chi[2].max(1.0)).sqrt(),
        held_out_rows: testing.rows.len(),
        chosen: chosen.names(),
        rms_before: None,
        rms_after: None,
        by_observable,
        by_level: Vec::new(),
        by_band: Vec::new(),
    }
}

/// Every third frequency; every third row where there are few frequencies.
pub(crate) fn held_out(problem: &Problem) -> Vec<bool> {
    let frequencies = &problem.facts.frequencies_hz;
    if frequencies.len() < 9 {
        return (0..problem.rows.len()).map(|i| i % 3 == 1).collect();
    }
    problem
        .rows
        .iter()
        .map(|r| frequencies.partition_point(|f| *f < r.frequency_hz) % 3 == 1)
        .collect()
}

#[derive(Clone, Copy, Default)]
struct Errors {
    square: f64,
    floor: f64,
    rows: f64,
    chi: f64,
    data: f64,
}

fn errors(training: &Problem, testing: &Problem, fit: &Fit) -> [Errors; 7] {
    let theta = testing.translate(training, &fit.theta);
    let evaluation = testing.evaluate(&fit.effects, &theta, &mut testing.memory());
    let mut all = [Errors::default(); 7];
    for (errors, (_, from, to)) in all.iter_mut().zip(OBSERVABLES) {
        let mut seen = vec![false; testing.rows.len()];
        for at in testing.slots[from].start..testing.slots[to - 1].end {
            let (u, row) = (testing.uncertainty(at), testing.row_of[at]);
            let difference = evaluation.residual[at] / evaluation.weight[at];
            let scale = if from == DC {
                let channel = testing.slots[DC + 1].contains(&at);
                let row = &testing.rows[row];
                1.0 / if channel {
                    row.dut_peak_v
                } else {
                    row.ref_peak_v
                }
            } else {
                1.0
            };
            if scale.is_finite() {
                errors.square += (difference * scale).powi(2);
                errors.floor += (u * scale).powi(2);
            }
            errors.chi += evaluation.residual[at].powi(2);
            errors.data += 1.0;
            seen[row] = true;
        }
        errors.rows = seen.iter().filter(|s| **s).count() as f64;
    }
    all
}
