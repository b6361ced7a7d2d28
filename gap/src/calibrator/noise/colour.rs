//! Size and memory of what is left in a group of observables.
//!
//! Noise is as large between neighbours as over all, whichever way the rows are ordered (von Neumann
//! 1941). What repeats at the same frequency long after is no noise.

use super::outliers::{Kept, scale};
use crate::estimation::significance::chi_square_tail;
use crate::observable::Group;
use crate::thresholds;
use std::ops::Range;

/// Evidence needed to believe that noise is not as stated.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Demand {
    /// Of a group by itself.
    OfFirst,
    /// Once another group has shown it.
    OfOthers,
}

/// Remainder in a group.
pub(super) struct Colour {
    /// Data, and the standard deviation of a correlation between so many of them.
    count: f64,
    /// Mean square, and the probability that the stated uncertainty gives it.
    square: f64,
    p_value: f64,
    /// Scatter of the middle over that of all.
    middle: f64,
    /// Correlation of rows measured one after the other; the least of any observable.
    in_time: f64,
    least_in_time: f64,
    /// Correlation of rows at the same frequency, measured long after one another.
    again: Option<f64>,
    /// Correlation `again` that memory alone would give.
    remembered: f64,
    /// Scatter between rows of the same conditions, over the stated one.
    repeated: Option<f64>,
}

/// Sum of products of pairs.
#[derive(Default)]
struct Pairs {
    product: f64,
    square: f64,
    count: f64,
}

impl Pairs {
    fn add(&mut self, a: f64, b: f64) {
        self.product += a * b;
        self.square += 0.5 * (a * a + b * b);
        self.count += 1.0;
    }

    fn correlation(&self) -> f64 {
        self.product / self.square.max(1e-300)
    }

    /// Standard deviation of either of a pair.
    fn scatter(&self) -> f64 {
        ((self.square - self.product) / self.count).max(0.0).sqrt()
    }
}

/// Pairs of rows of a group: one after the other, at the same frequency long after, of the same conditions.
struct Neighbours {
    in_time: Pairs,
    least_in_time: f64,
    again: Pairs,
    lags: Vec<f64>,
    repeated: Pairs,
}

impl Default for Neighbours {
    fn default() -> Self {
        Self {
            in_time: Pairs::default(),
            least_in_time: f64::INFINITY,
            again: Pairs::default(),
            lags: Vec::new(),
            repeated: Pairs::default(),
        }
    }
}

impl Neighbours {
    /// The pairs of one observable.
    fn add(&mut self, kept: &Kept, data: Range<usize>) {
        let problem = &kept.problem;
        let of = |at: usize| (problem.row_of[at], kept.evaluation.residual[at]);
        let mut rows: Vec<(usize, f64)> = data.map(of).collect();
        if rows.is_empty() {
            return;
        }
        let mut own = Pairs::default();
        for pair in rows.windows(2) {
            own.add(pair[0].1, pair[1].1);
            self.in_time.add(pair[0].1, pair[1].1);
        }
        self.least_in_time = self.least_in_time.min(own.correlation());
        let hz = |row: usize| problem.rows[row].frequency_hz;
        rows.sort_by(|a, b| hz(a.0).total_cmp(&hz(b.0)).then(a.0.cmp(&b.0)));
        for pair in rows.windows(2) {
            let lag = pair[0].0.abs_diff(pair[1].0);
            if lag > thresholds::NEAR_ROWS {
                self.again.add(pair[0].1, pair[1].1);
                self.lags.push(lag as f64);
            }
        }
        for (at, (row, left)) in rows.iter().enumerate() {
            let after = rows[at + 1..].iter().take(thresholds::REPEATS_AMONG);
            let mut repeats = after.filter(|other| {
                row.abs_diff(other.0) > thresholds::NEAR_ROWS
                    && problem.rows[*row].repeats(&problem.rows[other.0])
            });
            if let Some((_, again)) = repeats.next() {
                self.repeated.add(*left, *again);
            }
        }
    }

    fn again(&self) -> Option<f64> {
        (self.again.count >= thresholds::FEWEST_OF_NOISE as f64).then(|| self.again.correlation())
    }

    fn repeated(&self) -> Option<f64> {
        (self.repeated.count >= thresholds::FEWEST_OF_NOISE as f64).then(|| self.repeated.scatter())
    }

    /// Correlation at the same frequency that memory alone would leave.
    fn remembered(&self) -> f64 {
        let memory = self.in_time.correlation().clamp(0.0, 1.0);
        let all = self.lags.iter().map(|lag| memory.powf(*lag)).sum::<f64>();
        all / (self.lags.len() as f64).max(1.0)
    }
}

impl Colour {
    /// Of a group with enough data.
    pub(super) fn of(kept: &Kept, group: Group) -> Option<Self> {
        let problem = &kept.problem;
        let data = problem.data_of_group(group);
        if data.len() < thresholds::FEWEST_OF_NOISE {
            return None;
        }
        let mut neighbours = Neighbours::default();
        for observable in group.observables() {
            neighbours.add(kept, problem.data_of(observable));
        }
        let left = &kept.evaluation.residual[data.clone()];
        let taken = kept.fit.theta.len() + kept.fit.parameter_count();
        let degrees = data.len() as f64 * (1.0 - (taken as f64 / problem.len() as f64).min(0.5));
        let sum: f64 = left.iter().map(|r| r * r).sum();
        let square = sum / degrees;
        Some(Self {
            count: data.len() as f64,
            square,
            p_value: chi_square_tail(sum, degrees),
            middle: scale(left) / square.sqrt().max(1e-300),
            in_time: neighbours.in_time.correlation(),
            least_in_time: neighbours.least_in_time,
            again: neighbours.again(),
            remembered: neighbours.remembered(),
            repeated: neighbours.repeated(),
        })
    }

    fn tolerance(&self) -> f64 {
        thresholds::COLOUR_SIGMA / self.count.sqrt()
    }

    /// Whether neighbours have nothing in common, in time and in frequency, and no few rows stand out.
    fn is_white(&self) -> bool {
        let again = self.again.unwrap_or(self.in_time);
        self.in_time.max(again) < self.tolerance()
            && self.middle > thresholds::MIDDLE - self.tolerance()
    }

    /// Scatter over the stated one; 1 where that holds, or what is left is no noise.
    pub(super) fn factor(&self, demand: Demand, remembers: bool) -> f64 {
        let unlikely = match demand {
            Demand::OfFirst => thresholds::NOISE_P_VALUE,
            Demand::OfOthers => thresholds::NOISE_P_VALUE.sqrt(),
        };
        let factor = self.square.sqrt();
        let is_noise = remembers || self.is_white();
        if self.p_value < unlikely && is_noise && self.is_believable(factor, remembers) {
            factor
        } else {
            1.0
        }
    }

    /// Whether repetitions show a factor on the uncertainty; without any, whether it is a guess's error. A cause
    /// outside the library looks like noise, too, where rows are far apart.
    fn is_believable(&self, factor: f64, remembers: bool) -> bool {
        match self.repeated {
            Some(scatter) if !remembers => factor < thresholds::MOST_OVER_REPEATED * scatter,
            _ => factor < thresholds::MOST_ON_U,
        }
    }

    /// Share that a row remembers; 0 where rows forget, or where what is left comes again at the
    /// same frequency. A drift of one value is an effect: all parts of a group must remember.
    pub(super) fn memory(&self, demand: Demand) -> f64 {
        let tolerance = self.tolerance();
        let remembers = self.in_time > thresholds::LEAST_MEMORY.max(tolerance);
        let in_all = self.least_in_time > thresholds::ALL_PARTS * self.in_time;
        let expected = self.remembered + thresholds::LEAST_MEMORY + tolerance;
        let no_repetition = in_all && self.again.is_some_and(|again| again < expected);
        if remembers && (no_repetition || demand == Demand::OfOthers) {
            // A correlation about a fitted course is too small by about (1 + 3 r)/n.
            let bias = (1.0 + 3.0 * self.in_time) / self.count;
            (self.in_time + bias).min(1.0 - thresholds::LEAST_FORGOTTEN)
        } else {
            0.0
        }
    }
}
