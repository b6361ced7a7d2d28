//! Errors on the held-out part of a record by level and by band.
//!
//! A record has no rows of one level. Its held-out part is cut into stretches of a
//! few periods, and these are put in order of their largest output; its errors
//! are split by frequency.

use super::fit::rms;
use crate::estimation::gap::{GapSize, Slice};
use crate::thresholds::{BAND_EDGES, LEVELS_OF_RECORDS, PERIODS_OF_A_STRETCH};
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

/// A held-out part: what was measured, and what two simulations miss of it.
pub(super) struct Errors<'a> {
    pub(super) output: &'a [f64],
    pub(super) before: &'a [f64],
    pub(super) after: &'a [f64],
    /// Noise of the output, r.m.s.
    pub(super) noise: f64,
    pub(super) interval_s: f64,
    pub(super) resonance_hz: f64,
    /// Terms of the second simulation.
    pub(super) chosen: Vec<&'static str>,
    /// Largest output that was fitted.
    pub(super) fitted_peak: f64,
}

/// Sums of squares of a level or band.
#[derive(Default, Clone, Copy)]
struct Squares {
    before: f64,
    after: f64,
    /// Of the noise.
    noise: f64,
    /// Of what the errors are relative to.
    output: f64,
}

/// Samples of a stretch: a few periods.
pub(super) fn stretch(resonance_hz: f64, interval_s: f64) -> usize {
    ((PERIODS_OF_A_STRETCH / (resonance_hz * interval_s)).ceil() as usize).max(16)
}

impl Errors<'_> {
    /// Stretches by their largest output.
    pub(super) fn by_level(&self) -> Vec<Slice> {
        let length = stretch(self.resonance_hz, self.interval_s);
        let peak = |at: usize| {
            let end = (at + length).min(self.output.len());
            self.output[at..end]
                .iter()
                .fold(0.0, |m: f64, x| m.max(x.abs()))
        };
        let mut stretches: Vec<(f64, usize)> = (0..self.output.len())
            .step_by(length)
            .map(|at| (peak(at), at))
            .collect();
        stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
        if stretches.len() < 2 * LEVELS_OF_RECORDS {
            return Vec::new();
        }
        let level = |group: &[(f64, usize)]| {
            let mut sums = Squares::default();
            let mut rows = 0;
            for (_, at) in group {
                let range = *at..(at + length).min(self.output.len());
                let square = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>();
                sums.before += square(&self.before[range.clone()]);
                sums.after += square(&self.after[range.clone()]);
                sums.output += square(&self.output[range.clone()]);
                rows += range.len();
            }
            sums.noise = rows as f64 * self.noise * self.noise;
            let (from, to) = (group[0].0, group[group.len() - 1].0);
            let beyond = to > self.fitted_peak;
            self.slice((from, to), beyond, rows, sums)
        };
        let share = |at: usize| at * stretches.len() / LEVELS_OF_RECORDS;
        (0..LEVELS_OF_RECORDS)
            .map(|at| level(&stretches[share(at)..share(at + 1)]))
            .collect()
    }

    /// Parts of the spectrum, relative to the whole output.
    pub(super) fn by_band(&self) -> Vec<Slice> {
        let count = self.output.len();
        let line_hz = 1.0 / (count as f64 * self.interval_s);
        let lines = count / 2;
        let [before, after] = [self.before, self.after].map(spectrum);
        let edge = |over: f64| ((over * self.resonance_hz / line_hz) as usize).min(lines);
        let mut edges = vec![0];
        edges.extend(BAND_EDGES.map(edge));
        edges.push(lines);
        let total = count as f64 * rms(self.output).powi(2);
        let bands = edges.windows(2).filter(|edge| edge[1] > edge[0]);
        let band = |edge: &[usize]| {
            let range = edge[0]..edge[1];
            let share = range.len() as f64 / lines as f64;
            let sums = Squares {
                before: before[range.clone()].iter().sum(),
                after: after[range.clone()].iter().sum(),
                noise: share * count as f64 * self.noise * self.noise,
                output: total,
            };
            let ends = (edge[0] as f64 * line_hz, edge[1] as f64 * line_hz);
            self.slice(ends, false, range.len(), sums)
        };
        bands.map(band).collect()
    }

    fn slice(&self, (from, to): (f64, f64), beyond: bool, rows: usize, sums: Squares) -> Slice {
        let [before, after, noise, output] =
            [sums.before, sums.after, sums.noise, sums.output].map(f64::sqrt);
        Slice {
            from,
            to,
            rows,
            beyond,
            chosen: self.chosen.clone(),
            size: GapSize::of_errors([before, after], noise, output),
        }
    }
}

/// Energy of each line up to half the rate; together with their mirror images, that of the values.
fn spectrum(values: &[f64]) -> Vec<f64> {
    let mut lines: Vec<Complex<f64>> = values.iter().map(|v| Complex::new(*v, 0.0)).collect();
    let count = lines.len();
    FftPlanner::new()
        .plan_fft_forward(count)
        .process(&mut lines);
    let energy = |(at, line): (usize, &Complex<f64>)| {
        let twice = if at == 0 { 1.0 } else { 2.0 };
        twice * line.norm_sqr() / count as f64
    };
    lines[..count / 2].iter().enumerate().map(energy).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sine of 0.1 whose error is a tenth of it in its loud half, and a hundredth
    /// in its quiet one, at a frequency between one and two resonances.
    #[test]
    fn errors_are_found_at_their_level_and_in_their_band() {
        let at = |n: usize| (std::f64::consts::TAU * 0.015 * n as f64).sin();
        let loud = |n: usize| if n < 4000 { 1.0 } else { 10.0 };
        let output: Vec<f64> = (0..8000).map(|n| 0.01 * loud(n) * at(n)).collect();
        let before: Vec<f64> = (0..8000).map(|n| 1e-4 * loud(n).powi(2) * at(n)).collect();
        let after = vec![1e-6; 8000];
        let errors = Errors {
            output: &output,
            before: &before,
            after: &after,
            noise: 1e-6,
            interval_s: 0.01,
            resonance_hz: 1.0,
            chosen: vec!["cubic_stiffness"],
            fitted_peak: 0.05,
        };
        let levels = errors.by_level();
        assert_eq!(levels.len(), 5);
        let (quiet, last) = (&levels[0], &levels[4]);
        assert!((quiet.size.before_rel - 0.01).abs() < 1e-9, "{quiet:?}");
        assert!((last.size.before_rel - 0.1).abs() < 1e-9, "{last:?}");
        assert!(last.beyond && !quiet.beyond);
        assert_eq!(levels.iter().map(|l| l.rows).sum::<usize>(), 8000);
        let bands = errors.by_band();
        // 1.5 Hz: whole periods in each half, but for the step between the halves.
        let there = bands.iter().find(|b| b.from < 1.5 && b.to > 1.5);
        let there = there.expect("the bands reach from 0 to half the rate");
        let all: f64 = bands.iter().map(|b| b.size.before_rel.powi(2)).sum();
        assert!(there.size.before_rel.powi(2) > 0.99 * all, "{bands:?}");
        // Parseval: r.m.s. of the error over that of the output.
        let expected = rms(&before) / rms(&output);
        assert!((all.sqrt() / expected - 1.0).abs() < 1e-6, "{all}");
    }
}
