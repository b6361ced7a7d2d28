//! A record prepared for the integration: its input on a grid finer than its samples.
//!
//! Between two samples the input is that of a band-limited signal, or it is held, as a converter does: which of
//! them it is shows in the fit. The one taken for the other costs half a sample of delay, a cubic through the
//! neighbours a part of the amplitude above a fifth of the rate.

use super::mode::NODES;
use crate::dataset::Record;
use crate::estimation::column::dot;
use std::f64::consts::PI;
use std::sync::{Arc, Mutex, PoisonError};

/// Least and most steps of the integration per sample.
pub(super) const FEWEST_STEPS: usize = 2;
const MOST_STEPS: usize = 16;
/// Most values of a grid: longer records are integrated in fewer steps.
const MOST_VALUES: usize = 20_000_000;
/// Output over the largest of the record beyond which a simulation diverges.
const DIVERGED: f64 = 1e6;
/// Samples on each side that take part in the interpolation.
pub(super) const REACH: usize = 24;
/// Shape of the window (Kaiser): sidelobes near -130 dB, and the passband up to 0.4 of the rate.
const BETA: f64 = 14.0;

/// Input and output of a record, and how finely it is integrated.
pub(super) struct Run {
    pub(super) interval_s: f64,
    /// Samples of the file before the first one here.
    pub(super) before: usize,
    pub(super) input: Vec<f64>,
    pub(super) output: Vec<f64>,
    /// Whether the input drives it: else the motion is a decay.
    pub(super) driven: bool,
    pub(super) steps: usize,
    /// Output beyond which a simulation diverges.
    pub(super) largest: f64,
    /// Whether the input keeps its value until the next sample.
    pub(super) holds: bool,
    grid: Arc<Vec<f64>>,
    /// The grid of the last delay that was asked for.
    delayed: Mutex<Option<(f64, Arc<Vec<f64>>)>>,
}

impl Run {
    /// A record with a band-limited input.
    pub(super) fn new(record: &Record, steps: usize) -> Self {
        Self::of(record.clone(), steps, false)
    }

    /// This record with an input that is held between the samples, or is not.
    pub(super) fn holding(&self, holds: bool) -> Self {
        Self::of(self.first(usize::MAX), self.steps, holds)
    }

    /// This record, integrated as another one is.
    pub(super) fn as_in(&self, other: &Self) -> Self {
        Self::of(self.first(usize::MAX), other.steps, other.holds)
    }

    fn of(record: Record, steps: usize, holds: bool) -> Self {
        let mut steps = steps;
        while steps > FEWEST_STEPS && 2 * steps * record.input.len() > MOST_VALUES {
            steps /= 2;
        }
        let grid = Arc::new(between(holds, &record.input, steps, 0.0));
        let peak = record.output.iter().fold(0.0_f64, |m, y| m.max(y.abs()));
        Self {
            largest: DIVERGED * peak.max(f64::MIN_POSITIVE),
            holds,
            interval_s: record.interval_s,
            before: record.before,
            driven: record.input.iter().any(|u| *u != 0.0),
            input: record.input,
            output: record.output,
            steps,
            grid,
            delayed: Mutex::new(None),
        }
    }

    /// The first samples, integrated as finely.
    pub(super) fn head(&self, count: usize) -> Self {
        self.stretch(count, self.steps)
    }

    /// The first samples, with a number of steps per sample.
    pub(super) fn stretch(&self, count: usize, steps: usize) -> Self {
        Self::of(self.first(count), steps, self.holds)
    }

    fn first(&self, count: usize) -> Record {
        let count = self.input.len().min(count);
        Record {
            interval_s: self.interval_s,
            before: self.before,
            input: self.input[..count].to_vec(),
            output: self.output[..count].to_vec(),
        }
    }

    /// Displacement and velocity at the first sample, from the first three; `ln_w0` as in a simulation.
    pub(super) fn first_state(&self, ln_w0: f64) -> (f64, f64) {
        match self.output[..] {
            [x0, x1, x2, ..] => {
                let interval = ln_w0.exp() * self.interval_s;
                (x0, (4.0 * x1 - 3.0 * x0 - x2) / (2.0 * interval))
            }
            _ => (0.0, 0.0),
        }
    }

    /// Takes a quarter of the steps, if there are so many.
    pub(super) fn coarser(&self) -> Self {
        self.stretch(usize::MAX, (self.steps / 4).max(FEWEST_STEPS))
    }

    /// Doubles the steps per sample, if that is possible.
    pub(super) fn finer(&self) -> Option<Self> {
        if self.steps >= MOST_STEPS {
            return None;
        }
        let finer = self.stretch(usize::MAX, 2 * self.steps);
        (finer.steps > self.steps).then_some(finer)
    }

    /// Input about a step after a sample, of a grid of [`Run::input_at`].
    pub(super) fn nodes(&self, input: &[f64], sample: usize, step: usize) -> Option<[f64; NODES]> {
        // The grid begins a sample before the record.
        let step = self.steps * (sample + 1) + step;
        if self.holds {
            return input.get(step).map(|value| [*value; NODES]);
        }
        input.get(2 * step - 2..)?.first_chunk::<NODES>().copied()
    }

    /// Input delayed by some samples: of each step where it is held, else at two places per step. The first
    /// sample is at the number of them per sample.
    pub(super) fn input_at(&self, delay: f64) -> Arc<Vec<f64>> {
        if delay == 0.0 {
            return Arc::clone(&self.grid);
        }
        let mut last = self.delayed.lock().unwrap_or_else(PoisonError::into_inner);
        match &*last {
            Some((of, grid)) if *of == delay => Arc::clone(grid),
            _ => {
                let grid = Arc::new(between(self.holds, &self.input, self.steps, delay));
                *last = Some((delay, Arc::clone(&grid)));
                grid
            }
        }
    }
}

/// Input from one sample before the record to one after it.
fn between(holds: bool, input: &[f64], steps: usize, delay: f64) -> Vec<f64> {
    if holds {
        held_steps(input, steps, delay)
    } else {
        grid(input, steps, delay)
    }
}

/// Mean over each step of an input that is held.
fn held_steps(input: &[f64], steps: usize, delay: f64) -> Vec<f64> {
    let last = input.len() as isize - 1;
    let at = |sample: f64| input[(sample as isize).clamp(0, last) as usize];
    let of = |step: usize| {
        let (from, to) = (
            step as f64 / steps as f64 - 1.0 - delay,
            (step + 1) as f64 / steps as f64 - 1.0 - delay,
        );
        // A step no longer than a sample sees one edge at most.
        let edge = to.floor().max(from);
        let share = (to - edge) * steps as f64;
        (1.0 - share) * at(from.floor()) + share * at(to.floor())
    };
    (0..steps * (input.len() + 2)).map(of).collect()
}

/// Band-limited input from one sample before the record to one after it, at 2 `steps` places per sample.
fn grid(input: &[f64], steps: usize, delay: f64) -> Vec<f64> {
    let places = 2 * steps;
    let mut grid = vec![0.0; places * (input.len() + 2)];
    // A delay beyond the record leaves its first value.
    let delay = delay.clamp(-(input.len() as f64), input.len() as f64);
    for place in 0..places {
        let by = place as f64 / places as f64 - delay;
        let (whole, weights) = (by.floor(), window(by - by.floor()));
        let first = whole as isize - REACH as isize;
        let padded = padded(input, first, input.len() + 2 + 2 * REACH);
        for n in 0..input.len() + 2 {
            grid[n * places + place] = dot(&padded[n..n + 2 * REACH], &weights);
        }
    }
    grid
}

/// `count` samples from index `first` on. Beyond an end the input goes on as its image turned
/// about the end: it has no step and no kink there.
fn padded(input: &[f64], first: isize, count: usize) -> Vec<f64> {
    let last = input.len() as isize - 1;
    let at = |i: isize| {
        if i < 0 {
            2.0 * input[0] - input[(-i).min(last) as usize]
        } else if i > last {
            2.0 * input[last as usize] - input[(2 * last - i).max(0) as usize]
        } else {
            input[i as usize]
        }
    };
    (first..first + count as isize).map(at).collect()
}

/// Weights of the samples around a place between two of them: a sine over its angle, under a window.
fn window(part: f64) -> [f64; 2 * REACH] {
    let mut weights: [f64; 2 * REACH] = std::array::from_fn(|k| {
        let distance = part + REACH as f64 - 1.0 - k as f64;
        let sinc = if distance == 0.0 {
            1.0
        } else {
            (PI * distance).sin() / (PI * distance)
        };
        let out = (distance / REACH as f64).powi(2);
        sinc * bessel(BETA * (1.0 - out).max(0.0).sqrt())
    });
    let sum: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|w| *w /= sum);
    weights
}

/// Modified Bessel function of order zero, by its series.
fn bessel(x: f64) -> f64 {
    let (mut term, mut sum) = (1.0, 1.0);
    for k in 1..60 {
        term *= (0.5 * x / f64::from(k)).powi(2);
        sum += term;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Below 0.4 of the rate the window is flat to its sidelobes, 3e-7.
    #[test]
    fn a_sine_is_moved_by_part_of_a_sample() {
        let sine = |n: f64| (std::f64::consts::TAU * 0.37 * n).sin();
        let input: Vec<f64> = (0..200).map(|n| sine(f64::from(n))).collect();
        for delay in [0.0, -0.25, 0.7, 1.5] {
            let grid = grid(&input, 2, delay);
            for (at, value) in grid.iter().enumerate().take(600).skip(200) {
                let place = at as f64 / 4.0 - 1.0 - delay;
                assert!((value - sine(place)).abs() < 2e-6, "{delay} {at}");
            }
        }
    }
}
