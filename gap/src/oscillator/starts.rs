//! Where the fit of the oscillator, and of a term, begins.
//!
//! Gain, zero and state of a linear oscillator follow from the record once its resonance and damping are given: that of
//! the rig, or any where the rig states none.
//!
//! A term near the fit of the others begins with the most promising of some values. A spring that is
//! bent so far that the linear fit is no neighbour of it begins far away: what a wrong spring does
//! to the phase grows with time, and hides the right one behind other minima, so short stretches
//! come first. Over a few periods a fit finds a resonance that is off by some per cent: resonances
//! that close are tried, each with springs from a softening to a hardening one.

use super::fit::{Fitted, compared, integrate_finely, refine, residual, rms, scale_of, slopes};
use super::model::TERMS;
use super::parameters::{LINEAR, OscillatorParameters, Parameter, bound};
use super::run::Run;
use super::simulate::simulate;
use crate::estimation::column::{Column, OneBlock, dot};
use crate::estimation::tangent::{Equations, RIDGE, Tangent};
use crate::thresholds;
use nalgebra::DVector;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Linear fit from the rig's resonance, by growing parts of the record; where that leaves much, or the rig states
/// none, from those that describe the first part best.
pub(super) fn linear(record: &Run, resonance_hz: Option<f64>, delta: f64) -> Option<Fitted> {
    let part = record.head(COMPARED);
    let stated = |factor: f64| {
        let w0 = TAU * factor * resonance_hz?;
        Some(driven(&part, w0, delta)?.1)
    };
    let first = stated(1.0).and_then(|start| by_parts(record, start));
    if let Some(fit) = first.as_ref().filter(|fit| explains(fit, record)) {
        return Some(fit.clone());
    }
    let near = [0.9, 1.1, 0.8, 1.25].into_iter().filter_map(stated);
    let starts: Vec<_> = near.chain(anywhere(&part)).collect();
    let fits = starts
        .into_par_iter()
        .filter_map(|start| by_parts(record, start));
    let fits: Vec<Fitted> = fits.collect();
    let fits = first.into_iter().chain(fits);
    fits.min_by(|a, b| a.square.total_cmp(&b.square))
}

/// Follows a start over longer and longer parts of a record.
fn by_parts(record: &Run, mut values: OscillatorParameters) -> Option<Fitted> {
    let mut last = None;
    for count in [2_000, 8_000, usize::MAX] {
        let part = record.head(count);
        // A stretch before a shock shows nothing but noise.
        if rms(&part.output) < thresholds::QUIET * scale_of(record) {
            continue;
        }
        last = refine(&part, values, &[], 30);
        values = last.as_ref().map_or(values, |fit| fit.values);
    }
    last
}

/// Resonances that are looked at where none is known, and damping ratios of each.
const LOOKED_AT: (usize, [f64; 3]) = (48, [0.01, 0.06, 0.4]);

/// Linear oscillators of any resonance that describe the record best: from two periods in it up to a sixth
/// of the rate.
fn anywhere(record: &Run) -> Vec<OscillatorParameters> {
    let duration_s = record.interval_s * record.input.len() as f64;
    let (lowest, highest) = (2.0 * TAU / duration_s, TAU / (6.0 * record.interval_s));
    let (count, dampings) = LOOKED_AT;
    let w0 = |at: usize| lowest * (highest / lowest).powf(at as f64 / (count - 1) as f64);
    let places = (0..count).into_par_iter();
    let of = |at: usize| {
        let fits = dampings
            .iter()
            .filter_map(|delta| driven(record, w0(at), *delta));
        fits.min_by(|a, b| a.0.total_cmp(&b.0))
    };
    let mut found: Vec<(f64, OscillatorParameters)> = places.filter_map(of).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.truncate(thresholds::BEST_STARTS);
    found.into_iter().map(|f| f.1).collect()
}

/// A linear oscillator with the gain, the zero and the state at the first sample that describe the record best,
/// and the sum of squares that it leaves.
fn driven(record: &Run, w0: f64, delta: f64) -> Option<(f64, OscillatorParameters)> {
    use Parameter::{Delta, Displacement, Gain, LnResonance, Offset, Velocity};
    let mut values = OscillatorParameters::default();
    values[LnResonance] = w0.ln();
    values[Delta] = delta;
    let unit = scale_of(record);
    let gain = match rms(&record.input) {
        0.0 => 0.0,
        input => unit / input,
    };
    let parts = [
        (Offset, unit),
        (Displacement, unit),
        (Velocity, unit),
        (Gain, gain),
    ];
    let column = |(parameter, size): &(Parameter, f64)| {
        let mut alone = values;
        alone[*parameter] = *size;
        let simulated = simulate(&alone, record)?;
        Some(Column::of_one_block(compared(&simulated, record).to_vec()))
    };
    let columns: Vec<Column<()>> = parts.iter().map(column).collect::<Option<_>>()?;
    let measured = compared(&record.output, record);
    let block = OneBlock(measured.len());
    let equations = Equations::new(&block, &columns, &[], measured, &[]);
    let sizes = equations.step(0.0)?;
    for ((parameter, size), share) in parts.iter().zip(sizes.iter()) {
        values[*parameter] = size * share;
    }
    Some((
        dot(measured, measured) - sizes.dot(&equations.gradient),
        values,
    ))
}

/// Whether a fit describes most of the output.
fn explains(fit: &Fitted, record: &Run) -> bool {
    fit.square < thresholds::DESCRIBES_LITTLE * record.output.iter().map(|x| x * x).sum::<f64>()
}

/// Samples on which starts are compared.
const COMPARED: usize = 4_000;
/// Frequencies of a second mode that are tried: a step of 7 % meets every mode
/// whose resonance is no sharper than that of the start.
const MODES: usize = 90;

/// Where the fit of a term begins: the most promising values of those it is not linear in.
pub(super) fn begin(
    record: &Run,
    base: &OscillatorParameters,
    term: usize,
) -> OscillatorParameters {
    let unit = scale_of(record);
    let values = TERMS[term].values;
    let starts = starts(record, base, values[0], unit);
    if starts.is_empty() {
        return *base;
    }
    let candidates = starts.into_iter().map(|start| {
        let mut candidate = *base;
        for (parameter, value) in values.iter().zip(start) {
            candidate[*parameter] = value;
        }
        as_before(&mut candidate, values[0], record);
        bound(&mut candidate, values, record, unit);
        candidate
    });
    let Some((mut best, size)) = most_promising(record, base, candidates) else {
        return *base;
    };
    // A width, a threshold or a time is no amplitude, and a spring's rest moves by more than a little.
    use Parameter::{Clipping, DeadZone, Lag, Saturation, SteadyForce};
    let amplitude = values[0];
    if !matches!(
        amplitude,
        DeadZone | Saturation | Clipping | Lag | SteadyForce
    ) {
        best[amplitude] *= size;
    }
    bound(&mut best, values, record, unit);
    best
}

/// Moves the linear values so that a term leaves the output about where it was: its size behind a
/// low-pass, its mean under a steady force.
fn as_before(values: &mut OscillatorParameters, term: Parameter, record: &Run) {
    use Parameter::{Displacement, Gain, Lag, Lagging, LnResonance, Offset, SteadyForce, Velocity};
    match term {
        Lag => {
            let lag = values[Lag] * values[LnResonance].exp() * record.interval_s;
            let seen = values[Displacement];
            for value in [Gain, Displacement, Velocity] {
                values[value] *= lag.hypot(1.0);
            }
            if values[Lag] > thresholds::LAG_REMEMBERED {
                values[Lagging] = seen - values[Displacement] + lag * values[Velocity];
            }
        }
        SteadyForce => {
            values[Offset] -= values[SteadyForce];
            values[Displacement] += values[SteadyForce];
        }
        _ => {}
    }
}

/// Values of a term, known by its first, that are tried; none for a term that is linear in its own.
fn starts(record: &Run, base: &OscillatorParameters, term: Parameter, unit: f64) -> Vec<Vec<f64>> {
    match term {
        Parameter::ModeGain => {
            let half_rate = std::f64::consts::PI / record.interval_s;
            let highest = (0.9 * half_rate).ln() - base[Parameter::LnResonance];
            let lowest = highest - 6.2;
            let of = |i: usize| lowest + (highest - lowest) * i as f64 / (MODES - 1) as f64;
            let modes = (0..MODES).map(|i| vec![1e-3, of(i), thresholds::MODE_DAMPING]);
            modes.collect()
        }
        Parameter::Saturation => {
            let largest = record.input.iter().fold(0.0, |m: f64, u| m.max(u.abs()));
            let shares = [0.97, 0.9, 0.8, 0.65, 0.5, 0.35, 0.2];
            shares.map(|share| vec![1.0 / (share * largest)]).into()
        }
        Parameter::Lag => (-3..8)
            .map(|octave| vec![f64::exp2(octave.into())])
            .collect(),
        Parameter::SteadyForce => [0.03, 0.1, 0.3, 1.0, -0.03, -0.1, -0.3, -1.0]
            .map(|force| vec![force * unit])
            .into(),
        Parameter::Clipping => {
            let largest = record.output.iter().fold(0.0, |m: f64, y| m.max(y.abs()));
            let shares = [1.0, 0.97, 0.9];
            shares.map(|share| vec![1.0 / (share * largest)]).into()
        }
        Parameter::DeadZone => {
            let widths = [0.003, 0.01, 0.03, 0.1, 0.3, 1.0];
            widths.map(|width| vec![width * unit]).into()
        }
        Parameter::YieldingShare => {
            let deflections: [f64; 5] = [0.03, 0.1, 0.3, 1.0, 3.0];
            deflections.map(|at| vec![1e-3, (at * unit).ln()]).into()
        }
        _ => Vec::new(),
    }
}

/// The candidate that, scaled, takes most out of what the base leaves beside the linear values, and
/// that scale.
fn most_promising(
    record: &Run,
    base: &OscillatorParameters,
    candidates: impl Iterator<Item = OscillatorParameters>,
) -> Option<(OscillatorParameters, f64)> {
    let part = record.head(COMPARED);
    let left = residual(base, &part)?;
    let block = OneBlock(left.len());
    let tangent = Tangent::new(slopes(&part, base, &left, &LINEAR)?, &[])?;
    let dots = tangent.columns.iter().map(|c| c.dot_data(&block, &left));
    let owed = tangent.halfway(DVector::from_iterator(LINEAR.len(), dots));
    let predicted_gain = |candidate: OscillatorParameters| {
        let there = residual(&candidate, &part)?;
        let change = left.iter().zip(&there).map(|(a, b)| a - b);
        let column = [Column::of_one_block(change.collect())];
        let beside = tangent.beside(&column, RIDGE);
        let product = beside.products(&block, &column, &left, &owed)?[0];
        let size = product / beside.matrix[(0, 0)];
        Some((candidate, size, size * product))
    };
    let predicted = candidates.filter_map(predicted_gain);
    let best = predicted.max_by(|a, b| a.2.total_cmp(&b.2))?;
    Some((best.0, best.1))
}

/// Resonances over that of the linear fit: how many, the lowest, and the factor between two.
const RESONANCES: (usize, f64, f64) = (24, 0.45, 1.04);
/// Stiffness at the amplitude of the stretch that is cubic, over that which is linear: 3 k3 sigma^2
/// for Gaussian motion of the standard deviation sigma.
const HARDENING: [f64; 6] = [-0.3, 0.1, 0.4, 1.0, 2.5, 6.0];
/// Factors on the damping: a linear fit takes for damping what does not repeat.
const DAMPING: [f64; 2] = [1.0, 0.2];
/// Samples of the first stretch, and steps of the fits on it.
const FIRST: (usize, usize) = (150, 14);
/// How much longer each stretch is than the one before, and steps of the fits on it. A motion that
/// jumps between branches is foreseen for a while only, which grows as the values get better.
const LONGER: (f64, usize) = (1.35, 40);
/// Starts that are followed from the first stretch on, and least of them.
const FOLLOWED: (usize, usize) = (12, 2);

/// The term whose fit may begin far away, the first of [`TERMS`].
pub(super) const SPRING: usize = 0;
const _: () = assert!(matches!(TERMS[SPRING].values, [Parameter::CubicStiffness]));

/// A cubic spring fitted from far away, and the steps per sample it takes; `None` where the linear
/// fit of a driven record is not poor.
pub(super) fn bent_spring(run: &Run, base: &Fitted) -> Option<(Fitted, usize)> {
    let size = rms(&run.output);
    // A decay has many periods of a pitch that changes: a spring is no neighbour of none there.
    if run.driven && base.square < thresholds::POOR * size * size * run.output.len() as f64 {
        return None;
    }
    let terms = [base.terms.as_slice(), &[SPRING]].concat();
    let head = rms(&run.head(FIRST.0).output).max(0.1 * size);
    let of = |lower: f64, hardening: f64, damping: f64| {
        let mut values = base.values;
        values[Parameter::LnResonance] += lower.ln();
        values[Parameter::Delta] *= damping / lower;
        values[Parameter::Gain] /= lower * lower;
        values[Parameter::CubicStiffness] = hardening / (3.0 * head * head);
        // The state at the first sample, from the samples: that of the linear fit is as wrong as it is.
        values.set_first_state(run);
        values
    };
    let (count, lowest, factor) = RESONANCES;
    let mut starts = Vec::with_capacity(count * HARDENING.len() * DAMPING.len());
    for i in 0..count {
        let lower = lowest * factor.powi(i as i32);
        for hardening in HARDENING {
            starts.extend(DAMPING.map(|damping| of(lower, hardening, damping)));
        }
    }
    let ((mut samples, mut most), (mut kept, least)) = (FIRST, FOLLOWED);
    let mut steps = run.steps;
    loop {
        let part = run.stretch(samples, steps);
        let fits = starts
            .iter()
            .filter_map(|s| refine(&part, *s, &terms, most));
        let mut fits: Vec<Fitted> = fits.collect();
        fits.sort_by(|a, b| a.square.total_cmp(&b.square));
        fits.truncate(kept);
        steps = integrate_finely(part, &mut fits).steps;
        if samples >= run.input.len() {
            return Some((fits.into_iter().next()?, steps));
        }
        starts = fits.into_iter().map(|f| f.values).collect();
        samples = (samples as f64 * LONGER.0) as usize;
        (most, kept) = (LONGER.1, (kept / 2).max(least));
    }
}
