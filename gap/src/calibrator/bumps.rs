//! Local bumps over frequency that the best set of effects leaves.
//!
//! A small resonance of an adapter or a cable shows in a few neighbouring points.
//! The tests by class ask for wide shapes; here each group of one to three
//! frequencies is compared with the line between its neighbours, magnitude and
//! phase together. What stands out is followed to both sides as long as more
//! than noise is left there.

use super::problem::Problem;
use crate::estimation::significance::two_sided;
use crate::observable::{Complex, Observable};
use crate::thresholds;

/// A bump.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bump {
    /// Magnitude of the response.
    pub(crate) observable: Observable,
    pub(crate) from_hz: f64,
    pub(crate) to_hz: f64,
    /// Sum of the squared residuals in it.
    pub(crate) square: f64,
    /// Probability that noise shows as much anywhere.
    pub(crate) p_value: f64,
}

/// Bumps in what a fit leaves, by response and frequency.
pub(crate) fn bumps(problem: &Problem, residual: &[f64]) -> Vec<Bump> {
    let responses = [Observable::RATIO, Observable::DRIVE, Observable::CURRENT];
    let of = |response| Spectrum::new(problem, residual, response).bumps();
    responses.into_iter().flat_map(of).collect()
}

/// Residuals of magnitude and phase by frequency, in standard uncertainties.
struct Spectrum {
    magnitude: Observable,
    frequency_hz: Vec<f64>,
    /// One or two parts.
    parts: Vec<Vec<f64>>,
}

/// A group of neighbouring frequencies that stands out; places in a list of them.
struct Cluster {
    first: usize,
    last: usize,
    p_value: f64,
}

impl Spectrum {
    fn new(problem: &Problem, residual: &[f64], response: Complex) -> Self {
        let frequency_hz: Vec<f64> = problem
            .facts
            .frequencies_hz
            .iter()
            .copied()
            .filter(|f| {
                let mut data = problem.data_of(response[0]);
                data.any(|at| problem.rows[problem.row_of[at]].frequency_hz == *f)
            })
            .collect();
        let mean = |observable: Observable| -> Vec<f64> {
            let at_frequency = |f: &f64| {
                let data = problem.data_of(observable);
                let here = data.filter(|at| problem.rows[problem.row_of[*at]].frequency_hz == *f);
                let (sum, count) = here.fold((0.0, 0.0), |(s, n), at| (s + residual[at], n + 1.0));
                if count > 0.0 {
                    sum / f64::sqrt(count)
                } else {
                    0.0
                }
            };
            frequency_hz.iter().map(at_frequency).collect()
        };
        let parts = response.into_iter();
        let parts = parts.filter(|o| !problem.data_of(*o).is_empty());
        Self {
            magnitude: response[0],
            parts: parts.map(mean).collect(),
            frequency_hz,
        }
    }

    /// The least probable group first, then that of the rest without it.
    fn bumps(&self) -> Vec<Bump> {
        let mut rest: Vec<usize> = (0..self.frequency_hz.len()).collect();
        let mut bumps: Vec<Bump> = Vec::new();
        while bumps.len() < thresholds::MOST_BUMPS
            && let Some(group) = self
                .largest(&rest)
                .filter(|g| g.p_value < thresholds::BUMP_P_VALUE)
        {
            let (first, last) = self.followed(&rest, &group);
            bumps.push(Bump {
                observable: self.magnitude,
                from_hz: self.frequency_hz[rest[first]],
                to_hz: self.frequency_hz[rest[last]],
                square: rest[first..=last].iter().map(|at| self.square(*at)).sum(),
                p_value: group.p_value,
            });
            rest.drain(first..=last);
        }
        bumps.sort_by(|a, b| a.from_hz.total_cmp(&b.from_hz));
        bumps
    }

    fn square(&self, at: usize) -> f64 {
        self.parts.iter().map(|part| part[at] * part[at]).sum()
    }

    /// A group with those of its neighbours that more than noise is left in.
    fn followed(&self, rest: &[usize], group: &Cluster) -> (usize, usize) {
        let noise = self.parts.len() as f64;
        let more = |at: &&usize| self.square(**at) > noise;
        let before = rest[..group.first].iter().rev().take_while(more).count();
        let after = rest[group.last + 1..].iter().take_while(more).count();
        (group.first - before, group.last + after)
    }

    /// The least probable group of the frequencies that are left.
    fn largest(&self, rest: &[usize]) -> Option<Cluster> {
        let groups = (1..=thresholds::WIDEST_BUMP).flat_map(|width| {
            let windows = rest.windows(width + 2).enumerate();
            windows.map(move |(at, window)| Cluster {
                first: at + 1,
                last: at + width,
                p_value: self.probability(window),
            })
        });
        let groups: Vec<Cluster> = groups.collect();
        let tested = groups.len() as f64;
        let least = groups
            .into_iter()
            .min_by(|a, b| a.p_value.total_cmp(&b.p_value));
        least.map(|group| Cluster {
            p_value: (tested * group.p_value).min(1.0),
            ..group
        })
    }

    /// Probability that noise lifts the inner frequencies as far off the line between the outer two.
    fn probability(&self, window: &[usize]) -> f64 {
        let (first, last) = (window[0], window[window.len() - 1]);
        let inner = &window[1..window.len() - 1];
        let ln = |at: usize| self.frequency_hz[at].ln();
        let share = |at: &usize| (ln(*at) - ln(first)) / (ln(last) - ln(first));
        let count = inner.len() as f64;
        let mean_share = inner.iter().map(share).sum::<f64>() / count;
        // Each residual has the variance 1; the line is that of two of them.
        let variance = 1.0 / count + (1.0 - mean_share).powi(2) + mean_share.powi(2);
        let lifted = |part: &Vec<f64>| {
            let mean = inner.iter().map(|at| part[*at]).sum::<f64>() / count;
            mean - part[first] - mean_share * (part[last] - part[first])
        };
        let square: f64 = self
            .parts
            .iter()
            .map(|p| lifted(p).powi(2) / variance)
            .sum();
        // Chi-square of one or two degrees of freedom.
        match self.parts.len() {
            1 => two_sided(square.sqrt()),
            _ => (-0.5 * square).exp(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimation::significance::{normal_deviates, stream};

    fn noise(count: usize, seed: u64) -> Spectrum {
        let mut random = stream(seed);
        let mut part = || normal_deviates(&mut random, count);
        let parts = vec![part(), part()];
        let frequency_hz = (0..count).map(|n| 100.0 * 1.1_f64.powi(n as i32)).collect();
        Spectrum {
            magnitude: Observable::Ratio,
            frequency_hz,
            parts,
        }
    }

    #[test]
    fn bumps_are_found_where_they_are() {
        let mut spectrum = noise(50, 3);
        for part in &mut spectrum.parts {
            part.iter_mut().for_each(|r| *r *= 0.5);
        }
        // A peak of two points, and a resonance: down, then up in phase.
        spectrum.parts[0][20] += 14.0;
        spectrum.parts[0][21] += 12.0;
        spectrum.parts[0][40] -= 14.0;
        spectrum.parts[1][40] -= 14.0;
        spectrum.parts[1][41] += 14.0;
        let found = spectrum.bumps();
        let ranges: Vec<(f64, f64)> = found.iter().map(|b| (b.from_hz, b.to_hz)).collect();
        let f = |n: usize| spectrum.frequency_hz[n];
        // A neighbour with half the noise is taken for a part of it with the
        // probability that a chi-square of two exceeds 8: 2 %.
        assert_eq!(ranges, [(f(20), f(21)), (f(40), f(41))], "{found:?}");
    }

    /// At most the share of records that is allowed, within three standard deviations of a count.
    #[test]
    fn noise_has_no_bumps() {
        let records = 400;
        let alarms = (0..records).filter(|seed| !noise(50, *seed as u64 + 1).bumps().is_empty());
        let (alarms, allowed) = (
            alarms.count() as f64,
            thresholds::BUMP_P_VALUE * f64::from(records),
        );
        assert!(
            alarms <= allowed + 3.0 * allowed.sqrt(),
            "{alarms} of {records}"
        );
    }
}
