//! The adaptive Monte Carlo procedure of GUM-S1 7.9.

use super::draw::{BATCH, Plan};
use super::interval::{Interval, coverage_intervals};
use super::random::Lanes;
use super::tolerance::numerical_tolerance;
use crate::statistics;
use schemars::JsonSchema;
use serde::Serialize;
use std::thread;

/// Trials of one block: `M = max(J, 10^4)`, J = 100 / (1 - p) (GUM-S1 7.9.4 b).
pub const BLOCK: usize = 20 * BATCH;
/// Blocks between two looks at the stopping rule, whatever the cores.
const WAVE: usize = 32;

/// Quantity to compute.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Coverage probability.
    pub probability: f64,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Significant digits the standard uncertainty must be stable in.
    pub digits: u32,
    /// Share of the numerical tolerance to reach: 1 for a result, 0.2 where a
    /// first-order result is judged by it (GUM-S1 8.2 Note 2).
    pub share: f64,
    /// Trials at which to give up, at least one wave.
    pub most_trials: usize,
    /// Threads; the result does not depend on it.
    pub threads: usize,
}

impl Default for Options {
    /// 95 %, two digits, at most 20 million trials, every core.
    fn default() -> Self {
        Self {
            probability: 0.95,
            seed: 1,
            digits: 2,
            share: 1.0,
            most_trials: 20_000_000,
            threads: thread::available_parallelism().map_or(1, usize::from),
        }
    }
}

/// Result of the propagation, in the unit of the budget.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Outcome {
    /// Trials drawn.
    pub trials: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// The results are stable to the numerical tolerance.
    pub stable: bool,
    /// Numerical tolerance of the results.
    pub numerical_tolerance: f64,
    // Of the measurand's deviation from its estimate.
    /// Mean.
    pub estimate: f64,
    /// Standard uncertainty.
    pub standard_uncertainty: f64,
    /// Coverage probability of the intervals.
    pub coverage_probability: f64,
    /// Probabilistically symmetric interval.
    pub symmetric_interval: Interval,
    /// Shortest interval.
    pub shortest_interval: Interval,
}

/// Estimate, standard uncertainty and symmetric interval of one block.
type Block = [f64; 4];

/// Propagates the distributions of a prepared budget.
///
/// # Accuracy
/// The tolerance reported, at about 95 % confidence. Tests
/// `four_normal_inputs`, `four_rectangular_inputs` and
/// `the_result_does_not_depend_on_the_threads`.
pub fn propagate(plan: &Plan, options: &Options) -> Outcome {
    let mut values: Vec<f64> = Vec::new();
    let mut blocks: Vec<Block> = Vec::new();
    loop {
        let first = blocks.len();
        let offset = values.len();
        values.resize(offset + WAVE * BLOCK, 0.0);
        let wave = &mut values[offset..];
        blocks.extend(draw_wave(plan, options, first as u64, wave));
        let tolerance = tolerance(&values, options);
        let stable = is_stable(&blocks, tolerance);
        if stable || values.len() + WAVE * BLOCK > options.most_trials {
            return outcome(values, options, tolerance, stable);
        }
    }
}

fn draw_wave(plan: &Plan, options: &Options, first: u64, wave: &mut [f64]) -> Vec<Block> {
    let share = WAVE.div_ceil(options.threads.clamp(1, WAVE));
    thread::scope(|scope| {
        let workers: Vec<_> = wave
            .chunks_mut(share * BLOCK)
            .enumerate()
            .map(|(index, part)| {
                let first = first + (index * share) as u64;
                scope.spawn(move || draw_blocks(plan, options, first, part))
            })
            .collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().unwrap_or_default())
            .collect()
    })
}

fn draw_blocks(plan: &Plan, options: &Options, first: u64, part: &mut [f64]) -> Vec<Block> {
    part.chunks_mut(BLOCK)
        .enumerate()
        .map(|(index, block)| {
            let mut lanes = Lanes::new(options.seed, first + index as u64);
            plan.fill(&mut lanes, block);
            let (mean, deviation) = moments(block);
            let (symmetric, _) = coverage_intervals(block, options.probability);
            [mean, deviation, symmetric.low, symmetric.high]
        })
        .collect()
}

/// Mean and standard deviation in eight partial sums: short rounding chains.
fn moments(values: &[f64]) -> (f64, f64) {
    let (chunks, rest) = values.as_chunks::<8>();
    let mut sums = [0.0; 8];
    for chunk in chunks {
        (0..8).for_each(|lane| sums[lane] += chunk[lane]);
    }
    let count = values.len() as f64;
    let mean = (sums.iter().sum::<f64>() + rest.iter().sum::<f64>()) / count;
    let mut squares = [0.0; 8];
    for chunk in chunks {
        (0..8).for_each(|lane| squares[lane] += (chunk[lane] - mean) * (chunk[lane] - mean));
    }
    let remaining: f64 = rest.iter().map(|value| (value - mean).powi(2)).sum();
    let sum = squares.iter().sum::<f64>() + remaining;
    (mean, (sum / (count - 1.0)).sqrt())
}

fn tolerance(values: &[f64], options: &Options) -> f64 {
    options.share * numerical_tolerance(moments(values).1, options.digits)
}

/// GUM-S1 7.9.4 h: twice the standard deviation of each average.
fn is_stable(blocks: &[Block], tolerance: f64) -> bool {
    (0..4).all(|quantity| {
        let series: Vec<f64> = blocks.iter().map(|block| block[quantity]).collect();
        let deviation = statistics::standard_deviation(&series) / (series.len() as f64).sqrt();
        2.0 * deviation < tolerance
    })
}

fn outcome(mut values: Vec<f64>, options: &Options, tolerance: f64, stable: bool) -> Outcome {
    let (estimate, standard_uncertainty) = moments(&values);
    let (symmetric, shortest) = coverage_intervals(&mut values, options.probability);
    Outcome {
        trials: values.len(),
        seed: options.seed,
        stable,
        numerical_tolerance: tolerance,
        estimate,
        standard_uncertainty,
        coverage_probability: options.probability,
        symmetric_interval: symmetric,
        shortest_interval: shortest,
    }
}
