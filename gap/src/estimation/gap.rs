//! How large the gap is, before and after, as the answer states it.

use crate::observable::Group;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// How large a gap is, on rows that took no part in choosing or fitting.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct GapSize {
    /// Root mean square relative error of the nominal simulation.
    pub before_rel: f64,
    /// Root mean square relative error with the named effects added.
    pub after_rel: f64,
    /// Remainder by measurement noise alone.
    pub floor_rel: f64,
    /// Share that was closed; none where there was no gap. Of several observables, the mean of their shares,
    /// weighted by the excess of their chi-square.
    pub closed: Option<f64>,
    /// Root mean square of error over standard uncertainty, before.
    pub chi_before: f64,
    /// Root mean square of error over standard uncertainty, after.
    pub chi_after: f64,
}

impl GapSize {
    /// Of root mean square errors before and after, beside the noise and the size of what was measured.
    pub(crate) fn of_errors([before, after]: [f64; 2], noise: f64, size: f64) -> Self {
        Self {
            before_rel: before / size,
            after_rel: after / size,
            floor_rel: noise / size,
            closed: (before > noise).then(|| closed_share(before, after, noise)),
            chi_before: before / noise,
            chi_after: after / noise,
        }
    }
}

/// Gap over all observables on the held-out rows.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Gap {
    /// Ratio, drive and current (or what there is) pooled.
    #[serde(flatten)]
    pub size: GapSize,
    /// Rows that took no part in choosing or fitting.
    pub held_out_rows: usize,
    /// Effects chosen on the other rows.
    pub chosen: Vec<&'static str>,
    /// Simulation error of a record in the unit of its output, r.m.s., before.
    pub rms_before: Option<f64>,
    /// Simulation error of a record in the unit of its output, r.m.s., after.
    pub rms_after: Option<f64>,
    /// By observable.
    pub by_observable: BTreeMap<Group, GapSize>,
    /// By level, each fitted without it; empty where there is one level or none.
    ///
    /// Of points: r.m.s. acceleration, in m/s2. Of a record: largest output of a
    /// stretch of the held-out part, in its unit.
    pub by_level: Vec<Slice>,
    /// By band of frequency in Hz, each fitted without it.
    pub by_band: Vec<Slice>,
}

/// Share of a gap that is closed: 1 where nothing but noise is left; far worse counts as ninefold.
pub(crate) fn closed_share(before: f64, after: f64, floor: f64) -> f64 {
    ((before - after) / (before - floor)).clamp(-9.0, 1.0)
}

/// Gap on one level or band that took no part in the fit.
///
/// Of points: fitted to the rows of all other levels (bands). Of a record: the
/// stretches of this level in the held-out part, or the spectrum of its errors.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Slice {
    /// Lowest level or frequency.
    pub from: f64,
    /// Highest.
    pub to: f64,
    /// Points or samples; of a band of a record, spectral lines.
    pub rows: usize,
    /// Whether it lies at or beyond the edge of what was fitted.
    pub beyond: bool,
    /// Choice of the fit without it; empty where the cause does not pay there.
    pub chosen: Vec<&'static str>,
    /// Of a band of a record relative to the whole output. Closed is none where no observable stands out of its noise.
    #[serde(flatten)]
    pub size: GapSize,
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
            size: GapSize {
                closed: gap.size.closed.filter(|_| is_gap),
                ..gap.size
            },
        }
    }
}
