//! Tests whether a fitted oscillator leaves white noise.

use super::fit::{Fitted, compared, residual, rms, slopes};
use super::model::{TERMS, free};
use super::parameters::Parameter;
use super::run::Run;
use crate::estimation::column::{Column, OneBlock, dot};
use crate::estimation::significance::{
    chi_square_tail, lack_of_fit, length_beside, normal_deviates, two_sided,
};
use crate::estimation::tangent::Tangent;
use crate::thresholds;

/// Lags of the tests for memory: a few samples, and about a period of a resonance that is
/// sampled well.
const LAGS: [usize; 2] = [4, 40];
/// Forces whose trace is looked for: the terms that are linear in their size, with their parity.
const FORCES: [(Parameter, Parity); 6] = [
    (Parameter::CubicStiffness, Parity::Odd),
    (Parameter::QuadraticStiffness, Parity::Even),
    (Parameter::QuadraticDamping, Parity::Odd),
    (Parameter::CubicDamping, Parity::Odd),
    (Parameter::CoulombFriction, Parity::Odd),
    (Parameter::Delay, Parity::Linear),
];

/// Parity of a force: its change when the motion is mirrored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Parity {
    /// It is mirrored too.
    Odd,
    /// It stays.
    Even,
    /// It is a linear response.
    Linear,
}

/// Residuals of a fit.
#[derive(Debug, Clone)]
pub(super) struct Left {
    /// Probability that white noise leaves as much structure.
    pub(super) p_value: f64,
    /// Whether it is too small to be told from the error of the integration; the p-value is 1 then.
    pub(super) unresolved: bool,
    /// Samples that were compared.
    pub(super) samples: f64,
    /// Standard normal deviate of the trace of each of [`FORCES`] that the fit does not hold.
    pub(super) traces: Vec<(Parity, f64)>,
}

impl Left {
    /// Whether it looks like noise.
    pub(super) fn leaves_noise(&self) -> bool {
        self.p_value >= thresholds::UNEXPLAINED_P_VALUE
    }

    /// How many of so many samples count as independent.
    pub(super) fn independent(&self, samples: f64) -> f64 {
        if self.leaves_noise() {
            samples
        } else {
            samples * thresholds::INDEPENDENT
        }
    }
}

/// Tests the residual for memory and for traces of forces; the null is simulated. Beside a fit whose neighbours
/// diverge nothing is noise.
pub(super) fn examine(record: &Run, fit: &Fitted) -> Left {
    tested(record, fit).unwrap_or_else(|| Left {
        p_value: 0.0,
        unresolved: false,
        samples: compared(&record.output, record).len() as f64,
        traces: Vec::new(),
    })
}

fn tested(record: &Run, fit: &Fitted) -> Option<Left> {
    let left = residual(&fit.values, record)?;
    let moved = free(&fit.terms, &fit.values, record);
    let tangent = Tangent::new(slopes(record, &fit.values, &left, &moved)?, &[])?;
    let held = |force: Parameter| fit.terms.iter().any(|t| TERMS[*t].values[0] == force);
    let missing = FORCES.iter().filter(|f| !held(f.0));
    let (forces, parities): (Vec<_>, Vec<_>) = missing.copied().unzip();
    let columns = slopes(record, &fit.values, &left, &forces)?.into_iter();
    let traces = columns.zip(parities);
    let traces: Vec<Trace> = traces
        .filter_map(|(column, parity)| Trace::new(&tangent, column, parity))
        .collect();
    let known = thresholds::RESOLVED * rms(&left);
    let unresolved = known
        < fit
            .integration
            .max(thresholds::INTERPOLATED * thresholds::RESOLVED * rms(&record.output));
    let block = OneBlock(left.len());
    let (left, _) = tangent.reduce(&block, &left);
    let p_value = lack_of_fit(
        smallest(&left, &traces),
        &tangent,
        &block,
        |random| normal_deviates(random, left.len()),
        |left, _, _| smallest(left, &traces),
    );
    let deviates = deviates(&left, &traces);
    Some(Left {
        p_value: if unresolved { 1.0 } else { p_value },
        unresolved,
        samples: left.len() as f64,
        traces: traces.iter().map(|t| t.parity).zip(deviates).collect(),
    })
}

/// Response of the output to a little of a force.
struct Trace {
    column: Column<()>,
    /// Length of the column without what the fit takes over.
    length: f64,
    parity: Parity,
}

impl Trace {
    /// None where the force adds nothing.
    fn new(tangent: &Tangent<()>, mut column: Column<()>, parity: Parity) -> Option<Self> {
        let size = column.norm2().sqrt();
        column.scale(1.0 / size);
        (size > 0.0).then(|| Self {
            length: length_beside(tangent, &column),
            column,
            parity,
        })
    }
}

/// Smallest p-value over all tests; each takes the size of the noise from the residual itself.
fn smallest(left: &[f64], traces: &[Trace]) -> f64 {
    let traces = deviates(left, traces).into_iter().map(two_sided);
    let memory = LAGS.iter().map(|lags| memory(left, *lags));
    traces.chain(memory).fold(1.0, f64::min)
}

fn deviates(left: &[f64], traces: &[Trace]) -> Vec<f64> {
    let block = OneBlock(left.len());
    let sigma = (dot(left, left) / left.len() as f64)
        .sqrt()
        .max(f64::MIN_POSITIVE);
    let deviate = |trace: &Trace| trace.column.dot_data(&block, left) / (trace.length * sigma);
    traces.iter().map(deviate).collect()
}

/// p-value of the correlations of neighbours up to a lag (Ljung and Box 1978).
fn memory(left: &[f64], lags: usize) -> f64 {
    let (count, power) = (left.len() as f64, dot(left, left));
    let lags = lags.min(left.len() / 4).max(1);
    let of = |lag: usize| {
        let correlation = dot(&left[lag..], &left[..left.len() - lag]) / power;
        correlation * correlation / (count - lag as f64)
    };
    let square = count * (count + 2.0) * (1..=lags).map(of).sum::<f64>();
    chi_square_tail(square, lags as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimation::significance::stream;

    /// White noise has a p-value that is even over 0..1: of 40 the smallest is below
    /// 1e-4 once in 250 times. A first-order memory of 0.15 over 4000 samples is 9.5 sigma, give or take one: p < 1e-6.
    #[test]
    fn noise_with_a_memory_is_not_white() {
        let mut random = stream(3);
        let mut last = 0.0;
        let (mut least, mut with_memory) = (1.0_f64, Vec::new());
        for _ in 0..40 {
            let white: Vec<f64> = normal_deviates(&mut random, 4000);
            least = least.min(memory(&white, 4));
            with_memory = white
                .iter()
                .map(|w| {
                    last = 0.15 * last + w;
                    last
                })
                .collect();
        }
        assert!(least > 1e-4, "{least}");
        assert!(memory(&with_memory, 4) < 1e-6);
    }
}
