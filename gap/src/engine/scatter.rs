//! Screening of effects that only scatter: noise and leakage, no response.
//!
//! Beside a fit that makes no noise of its own the noise columns say the same of a
//! start whatever else the fit holds: that part is summed once for a dataset.

use super::nuisance::Nuisance;
use super::problem::{Evaluation, Problem};
use crate::effects::Active;
use crate::model::chain::Transfer;
use crate::model::row::{DRIVE, NOISE};
use crate::model::scatter::Scatter;
use std::collections::HashMap;

/// Sums over noise of starts beside fits that make no noise, by entry and parameters.
#[derive(Default)]
pub(super) struct QuietSums {
    of_start: HashMap<(usize, Vec<u64>), StartSums>,
}

/// What a start does beside such a fit.
#[derive(Clone, Copy)]
struct StartSums {
    noise: [NoiseSum; 2],
    leaks: bool,
}

/// A fit as effects are added to it that only scatter, all else but the healthy noise kept.
pub(super) struct Scene<'a> {
    problem: &'a Problem,
    here: &'a Evaluation,
    theta: &'a [f64],
    /// Gain of the device under test over its nominal one.
    dut_gain: f64,
    healthy_v2: [f64; 2],
    /// Scatter of each row by the effects of the fit.
    before: Vec<Scatter>,
    /// Whether there is none, and no noise was judged by another rule.
    quiet: bool,
    /// Square of each residual and of each weight.
    squares: Vec<[f64; 2]>,
}

impl<'a> Scene<'a> {
    pub(super) fn new(
        problem: &'a Problem,
        effects: &[Active<'_>],
        theta: &'a [f64],
        here: &'a Evaluation,
    ) -> Self {
        let nominal = problem.nominal(&problem.stated_noise(theta));
        let before = problem.rows.iter().map(|row| {
            let mut scatter = Scatter::default();
            for effect in effects {
                effect.scatter(row, nominal.dut_gain, &mut scatter);
            }
            scatter
        });
        let before: Vec<Scatter> = before.collect();
        let squares = here.residual.iter().zip(&here.weight);
        let mut noise = problem.slots[NOISE].start..problem.len();
        let as_stated = noise.all(|at| here.weight[at] == 1.0 / problem.uncertainty(at));
        Self {
            problem,
            here,
            theta,
            dut_gain: nominal.dut_gain,
            healthy_v2: nominal.noise_v.map(|v| v * v),
            quiet: as_stated && before.iter().all(|s| *s == Scatter::default()),
            before,
            squares: squares.map(|(r, w)| [r * r, w * w]).collect(),
        }
    }

    /// Gain of the objective when an effect is added.
    pub(super) fn gain(&self, added: &Active<'_>, known: &mut QuietSums) -> f64 {
        let bits = added.parameters.iter().map(|p| p.to_bits()).collect();
        let key = (added.entry, bits);
        let sums = match known.of_start.get(&key).filter(|_| self.quiet) {
            Some(sums) => *sums,
            None => {
                let sums = self.sums(added);
                if self.quiet {
                    known.of_start.insert(key, sums);
                }
                sums
            }
        };
        let leaked = if sums.leaks { self.leaked(added) } else { 0.0 };
        leaked + self.lost(added) + self.noise(&sums.noise)
    }

    fn after(&self, row: usize, added: &Active<'_>) -> Scatter {
        let mut after = self.before[row];
        added.scatter(&self.problem.rows[row], self.dut_gain, &mut after);
        after
    }

    fn sums(&self, added: &Active<'_>) -> StartSums {
        let mut sums = StartSums {
            noise: [NoiseSum::default(); 2],
            leaks: false,
        };
        for (row, before) in self.before.iter().enumerate() {
            let after = self.after(row, added);
            sums.leaks |= after.leaks != before.leaks;
            for (channel, sum) in sums.noise.iter_mut().enumerate() {
                let Some(at) = self.problem.datum(row, NOISE + channel) else {
                    continue;
                };
                let healthy = self.healthy_v2[channel];
                let (power, open) = after.noise(channel, healthy);
                let open = open - before.noise(channel, healthy).1;
                let difference = self.problem.measured[at] - 0.5 * power.ln();
                sum.add(difference, healthy / power, self.here.weight[at], open);
            }
        }
        sums
    }

    /// Gain in the noise columns, the healthy noise fitted anew.
    fn noise(&self, sums: &[NoiseSum; 2]) -> f64 {
        let data = self.problem.slots[NOISE].start..self.problem.len();
        let mut gain: f64 = self.squares[data].iter().map(|[r2, _]| r2).sum();
        for (channel, sum) in sums.iter().enumerate() {
            let mut free = self.problem.free.iter().zip(self.theta);
            let healthy = free.find(|(f, _)| f.kind == Nuisance::Noise(channel));
            let (unit, pull) = healthy.map_or((0.0, 0.0), |(f, theta)| (f.unit, *theta));
            gain += pull * pull - sum.least(unit);
        }
        gain
    }

    /// Gain where residuals count less, minus what it costs that they do.
    fn leaked(&self, added: &Active<'_>) -> f64 {
        let rows = 0..self.before.len();
        let after: Vec<Scatter> = rows.map(|row| self.after(row, added)).collect();
        let mut gain = 0.0;
        let mut ratios = Product::default();
        for slot in 0..NOISE {
            let range = self.problem.slots[slot].clone();
            let data = self.squares[range.clone()].iter();
            for ([r2, w2], row) in data.zip(&self.problem.row_of[range]) {
                let open = after[*row].leaks.of(slot) - self.before[*row].leaks.of(slot);
                let wider = open * w2;
                gain += r2 * wider / (1.0 + wider);
                ratios.times(1.0 + wider);
            }
        }
        gain - ratios.ln()
    }

    /// Gain by the response that goes with the scatter: the reference loses, the ratio does not.
    fn lost(&self, added: &Active<'_>) -> f64 {
        let range = self.problem.slots[DRIVE].clone();
        let change = |(at, row): (usize, &usize)| {
            let row = &self.problem.rows[*row];
            let mut transfer = Transfer::default();
            added.transfer(row, row.frequency_hz, &mut transfer);
            if transfer == Transfer::default() {
                return 0.0;
            }
            let moved = transfer.reference.norm().ln() * self.here.weight[at];
            moved * (2.0 * self.here.residual[at] - moved)
        };
        range
            .clone()
            .zip(&self.problem.row_of[range])
            .map(change)
            .sum()
    }
}

/// A product of many factors of one or more, of which the logarithm is wanted.
struct Product {
    factors: f64,
    ln: f64,
}

impl Default for Product {
    fn default() -> Self {
        Self {
            factors: 1.0,
            ln: 0.0,
        }
    }
}

impl Product {
    fn times(&mut self, factor: f64) {
        self.factors *= factor;
        if self.factors > 1e150 {
            self.ln += self.factors.ln();
            self.factors = 1.0;
        }
    }

    fn ln(self) -> f64 {
        self.ln + self.factors.ln()
    }
}

/// Sums over the noise of one channel, from which its healthy noise is fitted.
#[derive(Clone, Copy, Default)]
pub(super) struct NoiseSum {
    square: f64,
    mixed: f64,
    share: f64,
    widened: f64,
}

impl NoiseSum {
    /// One more datum.
    pub(super) fn add(&mut self, difference: f64, share: f64, weight: f64, open: f64) {
        let ratio = 1.0 + open * weight * weight;
        let w2 = weight * weight / ratio;
        self.square += difference * difference * w2;
        self.mixed += difference * share * w2;
        self.share += share * share * w2;
        self.widened += ratio.ln();
    }

    /// Least sum of squares over the healthy noise with its prior of one unit.
    pub(super) fn least(&self, unit: f64) -> f64 {
        self.square + self.widened - (unit * self.mixed).powi(2) / (1.0 + unit * unit * self.share)
    }
}
