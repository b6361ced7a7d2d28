//! Least squares of the simulated against the recorded output.

use super::channel;
use super::model::{TERMS, free};
use super::parameters::{LINEAR, OscillatorParameters, Parameter, bound, slope_step};
use super::run::{REACH, Run};
use super::simulate::simulate;
use crate::estimation::column::{Column, OneBlock};
use crate::estimation::descent::{Effort, LeastSquares, descend};
use crate::estimation::tangent::Equations;
use crate::thresholds;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use std::ops::Range;

/// Samples at the end beyond which the interpolation of the input would have to look.
const ENDING: usize = REACH;

/// A fitted oscillator.
#[derive(Clone)]
pub(super) struct Fitted {
    pub(super) values: OscillatorParameters,
    /// Terms in use.
    pub(super) terms: Vec<usize>,
    /// Sum of squared simulation errors.
    pub(super) square: f64,
    /// Covariance of the free values, residual variance included.
    pub(super) covariance: DMatrix<f64>,
    /// Estimated error of the integration, r.m.s.; zero where nobody asked.
    pub(super) integration: f64,
    /// Sum of squared simulation errors on the part that is held out; infinite where the simulation
    /// diverges there, and where nobody asked.
    pub(super) unseen: f64,
}

impl Fitted {
    /// Difference, r.m.s., to an integration in other steps.
    pub(super) fn off(&self, run: &Run, finer: &Run) -> Option<f64> {
        let (here, there) = (simulate(&self.values, run)?, simulate(&self.values, finer)?);
        let off: Vec<f64> = here.iter().zip(&there).map(|(a, b)| a - b).collect();
        Some(rms(compared(&off, run)))
    }

    /// Covariance of two values, of the linear oscillator or of terms in use; NaN of others.
    pub(super) fn covariance_of(&self, one: Parameter, other: Parameter) -> f64 {
        let row = |wanted: Parameter| {
            let of_terms = self.terms.iter().flat_map(|term| TERMS[*term].values);
            let mut fitted = LINEAR.iter().chain(of_terms);
            fitted.position(|parameter| *parameter == wanted)
        };
        let place = row(one).zip(row(other));
        place.map_or(f64::NAN, |place| self.covariance[place])
    }
}

/// Refines the linear values and the given terms; none where the start diverges.
pub(super) fn refine(
    record: &Run,
    start: OscillatorParameters,
    terms: &[usize],
    most_steps: usize,
) -> Option<Fitted> {
    let descend =
        |start, moved: &[Parameter]| descend_from(start, moved, record, judged(record), most_steps);
    let mut moved = free(terms, &start, record);
    let (mut place, mut equations) = descend(start, &moved)?;
    // Where the fit has come to, the samples may show a state that they did not where it began.
    let shown = free(terms, &place.values, record);
    if shown.len() > moved.len() {
        (place, equations) = descend(place.values, &shown)?;
        moved = shown;
    }
    let variance = place.square() / (record.output.len() as f64 - moved.len() as f64);
    Some(Fitted {
        square: place.square(),
        values: place.values,
        terms: terms.to_vec(),
        covariance: equations.covariance()? * variance,
        integration: 0.0,
        unseen: f64::INFINITY,
    })
}

/// Moves some values to where the simulation errs least on some samples; none where the start
/// diverges.
pub(super) fn descend_from(
    start: OscillatorParameters,
    free: &[Parameter],
    record: &Run,
    samples: Range<usize>,
    most_steps: usize,
) -> Option<(Place, Equations)> {
    let mut model = Model {
        record,
        free,
        samples,
        unit: scale_of(record),
    };
    let start = model.place(start)?;
    let effort = Effort {
        within: f64::INFINITY,
        most_steps,
        enough: thresholds::STEP_WORTH * start.left.len() as f64,
        share: 0.0,
        small_steps: 1,
        damping: 1e-3,
        leap: 10.0,
    };
    descend(&mut model, start, effort)
}

/// Samples of a record that a simulation is to describe.
struct Model<'a> {
    record: &'a Run,
    /// Values that are moved.
    free: &'a [Parameter],
    samples: Range<usize>,
    /// Size of the output.
    unit: f64,
}

/// Values on the way of a fit, and what they leave.
pub(super) struct Place {
    pub(super) values: OscillatorParameters,
    left: Vec<f64>,
}

impl Place {
    fn square(&self) -> f64 {
        self.left.iter().map(|r| r * r).sum()
    }
}

impl Model<'_> {
    fn place(&self, values: OscillatorParameters) -> Option<Place> {
        let left = errors(&values, self.record, self.samples.clone())?;
        Some(Place { values, left })
    }
}

impl LeastSquares for Model<'_> {
    type State = Place;

    /// The variance of the errors is not known: it is theirs.
    fn objective(&self, at: &Place) -> f64 {
        at.left.len() as f64 * at.square().max(f64::MIN_POSITIVE).ln()
    }

    fn gain(&self, at: &Place, square: f64) -> f64 {
        let left = 1.0 - square / at.square().max(f64::MIN_POSITIVE);
        -(at.left.len() as f64) * left.max(f64::MIN_POSITIVE).ln()
    }

    fn equations(&mut self, at: &Place) -> Option<Equations> {
        let columns = columns(self.record, &at.values, &at.left, self.free, &self.samples)?;
        let block = OneBlock(at.left.len());
        Some(Equations::new(&block, &columns, &[], &at.left, &[]))
    }

    fn moved(&mut self, from: &Place, step: &DVector<f64>) -> Option<Place> {
        let mut values = from.values;
        for (&parameter, change) in self.free.iter().zip(step.iter()) {
            values[parameter] += change;
        }
        if step.iter().any(|change| !change.is_finite()) {
            return None;
        }
        bound(&mut values, self.free, self.record, self.unit);
        self.place(values)
    }
}

/// Change of the simulated output with some values, from where it leaves `left`.
pub(super) fn slopes(
    record: &Run,
    values: &OscillatorParameters,
    left: &[f64],
    moved: &[Parameter],
) -> Option<Vec<Column<()>>> {
    columns(record, values, left, moved, &judged(record))
}

/// Columns from values where a simulation leaves `left` of some samples: by differences, but for
/// those of the output's channel.
fn columns(
    record: &Run,
    values: &OscillatorParameters,
    left: &[f64],
    moved: &[Parameter],
    samples: &Range<usize>,
) -> Option<Vec<Column<()>>> {
    let unit = scale_of(record);
    let of = |&parameter: &Parameter| {
        let direct = |at: usize| {
            let simulated = record.output[at] - left[at - samples.start];
            channel::slope(values, parameter, at, record, simulated)
        };
        if let Some(slopes) = samples.clone().map(direct).collect() {
            return Some(Column::of_one_block(slopes));
        }
        let mut there = *values;
        let step = slope_step(values, parameter, unit);
        there[parameter] += step;
        let there = errors(&there, record, samples.clone())?;
        let change = left.iter().zip(there).map(|(a, b)| (a - b) / step);
        Some(Column::of_one_block(change.collect()))
    };
    moved.iter().map(of).collect()
}

/// Measured minus simulated output after the settling samples; `None` where the simulation diverges.
pub(super) fn residual(values: &OscillatorParameters, record: &Run) -> Option<Vec<f64>> {
    errors(values, record, judged(record))
}

fn errors(values: &OscillatorParameters, record: &Run, samples: Range<usize>) -> Option<Vec<f64>> {
    let simulated = simulate(values, record)?;
    let measured = record.output[samples.clone()].iter();
    let both = measured.zip(&simulated[samples]);
    Some(both.map(|(m, s)| m - s).collect())
}

/// Samples a fit is judged by: the first settle the state, and at the last the input that follows
/// is not known. Where there is no input, all of them.
fn judged(record: &Run) -> Range<usize> {
    let samples = record.output.len();
    if !record.driven {
        return 0..samples;
    }
    let end = samples
        .saturating_sub(ENDING)
        .max(thresholds::SETTLING)
        .min(samples);
    thresholds::SETTLING.min(end)..end
}

/// Of values at the samples of a record those that a fit is judged by.
pub(super) fn compared<'v>(values: &'v [f64], record: &Run) -> &'v [f64] {
    &values[judged(record)]
}

/// Root mean square.
pub(super) fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|r| r * r).sum::<f64>() / values.len() as f64).sqrt()
}

/// Root mean square of the output.
pub(super) fn scale_of(record: &Run) -> f64 {
    rms(&record.output).max(f64::MIN_POSITIVE)
}

/// Halves the steps of the integration until its error is small beside what the best set leaves,
/// and fits the leading sets anew.
pub(super) fn integrate_finely(run: Run, tried: &mut [Fitted]) -> Run {
    let mut run = run;
    while let (Some(best), Some(finer)) = (tried.first_mut(), run.finer()) {
        let (Some(off), Some(left)) = (best.off(&run, &finer), residual(&best.values, &run)) else {
            break;
        };
        best.integration = off;
        if off < thresholds::RESOLVED_FINELY * rms(&left) {
            break;
        }
        run = finer;
        let leading = tried.len().min(thresholds::MOST_REFINED);
        tried[..leading].par_iter_mut().for_each(|fit| {
            if let Some(mut further) =
                refine(&run, fit.values, &fit.terms, thresholds::STEPS_OF_LEADING)
            {
                // Half the steps err by half at most, a kink included.
                further.integration = 0.5 * off;
                *fit = further;
            }
        });
        tried[..leading].sort_by(|a, b| a.square.total_cmp(&b.square));
    }
    run
}
