//! Screening of effects that only scatter: noise and leakage, no response.
//!
//! Beside a fit that makes no noise of its own the noise columns say the same of a
//! start whatever else the fit holds: that part is summed once for a dataset. What
//! leaks into the components is computed only where it could make a start the best.

use super::evaluation::Evaluation;
use super::nuisance::Nuisance;
use super::problem::Problem;
use crate::model::chain::Transfer;
use crate::model::effect::Active;
use crate::model::scatter::Scatter;
use crate::observable::{Channel, Group, Observable, Table};
use std::collections::HashMap;

/// Effects of starts beside fits that make no noise, by entry and parameters.
#[derive(Default)]
pub(super) struct QuietStarts {
    of_start: HashMap<(usize, Vec<u64>), Shown>,
}

/// Action of a start on the noise columns, and the other places where it shows.
#[derive(Clone, Copy)]
struct Shown {
    noise: [NoiseSum; 2],
    /// Observables into which it leaks.
    leaks: Table<bool>,
    /// Whether the drive loses by it.
    loses: bool,
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
    /// Most that leakage into an observable can gain, whatever its size.
    most_leaked: Table<f64>,
    /// Most that a smaller drive can gain.
    most_lost: f64,
}

impl<'a> Scene<'a> {
    /// `higher_v2` is the power of the harmonics of each row that count as noise.
    pub(super) fn new(
        problem: &'a Problem,
        effects: &[Active<'_>],
        theta: &'a [f64],
        here: &'a Evaluation,
        higher_v2: Option<&[[f64; 2]]>,
    ) -> Self {
        let nominal = problem.nominal(&problem.stated_noise(theta));
        let before = problem.rows.iter().enumerate().map(|(at, row)| {
            let mut scatter = Scatter {
                noise_v2: higher_v2.map_or([0.0; 2], |all| all[at]),
                ..Scatter::default()
            };
            for effect in effects {
                effect.scatter(row, nominal.dut_gain, &mut scatter);
            }
            scatter
        });
        let before: Vec<Scatter> = before.collect();
        let mut noise = problem.data_of_group(Group::Noise);
        let as_stated = noise.all(|at| here.weight[at] == 1.0 / problem.uncertainty(at));
        let squares = |observable: Observable| {
            let residual = here.residual[problem.data_of(observable)].iter();
            residual.map(|r| r * r)
        };
        Self {
            problem,
            here,
            theta,
            dut_gain: nominal.dut_gain,
            healthy_v2: nominal.noise_v.map(|v| v * v),
            quiet: as_stated && before.iter().all(|s| *s == Scatter::default()),
            before,
            // A variance widened by the factor q gains r2 (1 - 1/q) - ln q: most at q = r2.
            most_leaked: Table::from_fn(|observable| {
                let large = squares(observable).filter(|r2| *r2 > 1.0 && !observable.is_noise());
                large.map(|r2| r2 - 1.0 - r2.ln()).sum()
            }),
            most_lost: squares(Observable::Drive).sum(),
        }
    }

    /// The best of some starts of an entry and its gain, if it gains more than `floor`.
    pub(super) fn best(
        &self,
        starts: impl Iterator<Item = Active<'static>>,
        mut floor: f64,
        known: &mut QuietStarts,
    ) -> Option<(Active<'static>, f64)> {
        let bounded = starts.map(|start| {
            let shown = self.shown(&start, known);
            let noise = self.noise(&shown.noise);
            (start, shown, noise, noise + self.most(&shown))
        });
        let mut bounded: Vec<_> = bounded.collect();
        bounded.sort_by(|a, b| b.3.total_cmp(&a.3));
        let mut best = None;
        for (start, shown, noise, most) in bounded {
            if most <= floor {
                break;
            }
            let gain = noise + self.leaked(&start, &shown) + self.lost(&start, &shown);
            if gain.is_finite() && gain > floor {
                (floor, best) = (gain, Some((start, gain)));
            }
        }
        best
    }

    /// Most that a start can gain outside of the noise columns.
    fn most(&self, shown: &Shown) -> f64 {
        let leaking = self.most_leaked.iter().filter(|(o, _)| shown.leaks[*o]);
        let leaked: f64 = leaking.map(|(_, most)| most).sum();
        leaked + if shown.loses { self.most_lost } else { 0.0 }
    }

    fn after(&self, row: usize, added: &Active<'_>) -> Scatter {
        let mut after = self.before[row];
        added.scatter(&self.problem.rows[row], self.dut_gain, &mut after);
        after
    }

    fn shown(&self, added: &Active<'_>, known: &mut QuietStarts) -> Shown {
        if !self.quiet {
            return self.look(added);
        }
        let bits = added.parameters.iter().map(|p| p.to_bits()).collect();
        let known = known.of_start.entry((added.entry, bits));
        *known.or_insert_with(|| self.look(added))
    }

    fn look(&self, added: &Active<'_>) -> Shown {
        let mut shown = Shown {
            noise: [NoiseSum::default(); 2],
            leaks: Table::filled(false),
            loses: false,
        };
        for (row, before) in self.before.iter().enumerate() {
            let after = self.after(row, added);
            if after.leaks != before.leaks {
                for (observable, leaks) in shown.leaks.iter_mut() {
                    *leaks |= after.leaks.of(observable) != before.leaks.of(observable);
                }
            }
            shown.loses |= self.transfer(row, added) != Transfer::default();
            for (sum, channel) in shown.noise.iter_mut().zip(Channel::BOTH) {
                let Some(at) = self.problem.datum(row, Observable::noise(channel)) else {
                    continue;
                };
                let healthy = self.healthy_v2[channel as usize];
                let (power, open) = after.noise(channel, healthy);
                let open = open - before.noise(channel, healthy).1;
                let difference = self.problem.measured[at] - 0.5 * power.ln();
                sum.add(difference, healthy / power, self.here.weight[at], open);
            }
        }
        shown
    }

    /// Gain in the noise columns, the healthy noise fitted anew.
    fn noise(&self, sums: &[NoiseSum; 2]) -> f64 {
        let data = self.problem.data_of_group(Group::Noise);
        let mut gain: f64 = self.here.residual[data].iter().map(|r| r * r).sum();
        for (sum, channel) in sums.iter().zip(Channel::BOTH) {
            let mut free = self.problem.free.iter().zip(self.theta);
            let healthy = free.find(|(f, _)| f.kind == Nuisance::Noise(channel));
            let (unit, pull) = healthy.map_or((0.0, 0.0), |(f, theta)| (f.unit, *theta));
            gain += pull * pull - sum.least(unit);
        }
        gain
    }

    /// Gain where residuals count less, minus what it costs that they do.
    fn leaked(&self, added: &Active<'_>, shown: &Shown) -> f64 {
        let leaking = shown.leaks.iter().filter(|(_, leaks)| **leaks);
        let leaking: Vec<Observable> = leaking.map(|(observable, _)| observable).collect();
        if leaking.is_empty() {
            return 0.0;
        }
        let rows = 0..self.before.len();
        let after: Vec<Scatter> = rows.map(|row| self.after(row, added)).collect();
        let mut gain = 0.0;
        let mut ratios = Product::default();
        for observable in leaking {
            let rows = after.iter().zip(&self.before);
            let open: Vec<f64> = rows
                .map(|(after, before)| after.leaks.of(observable) - before.leaks.of(observable))
                .collect();
            let range = self.problem.data_of(observable);
            let (residual, weight) = (
                &self.here.residual[range.clone()],
                &self.here.weight[range.clone()],
            );
            for ((row, r), w) in self.problem.row_of[range].iter().zip(residual).zip(weight) {
                let wider = open[*row] * w * w;
                gain += r * r * wider / (1.0 + wider);
                ratios.times(1.0 + wider);
            }
        }
        gain - ratios.ln()
    }

    fn transfer(&self, row: usize, added: &Active<'_>) -> Transfer {
        let row = &self.problem.rows[row];
        let mut transfer = Transfer::default();
        added.transfer(row, row.frequency_hz, &mut transfer);
        transfer
    }

    /// Gain by the response that goes with the scatter: the reference loses, the ratio does not.
    fn lost(&self, added: &Active<'_>, shown: &Shown) -> f64 {
        if !shown.loses {
            return 0.0;
        }
        let change = |at: usize| {
            let loss = self
                .transfer(self.problem.row_of[at], added)
                .reference
                .norm();
            let moved = loss.ln() * self.here.weight[at];
            moved * (2.0 * self.here.residual[at] - moved)
        };
        self.problem.data_of(Observable::Drive).map(change).sum()
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
