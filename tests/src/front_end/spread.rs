//! The ratio of two channels whose parts were drawn from their tolerances.

use super::ngspice::{Row, Run};
use crate::rigged::Fault;
use calib_twin::Complex;

/// Pairs of channels in a file of `spread.cir`.
pub const PAIRS: usize = 500;
/// Frequencies of a pair.
const FREQUENCIES: usize = 41;
/// Index of 158.5 Hz, the nearest to the reference frequency of 160 Hz.
const REFERENCE: usize = 22;

/// Root mean square of what a ratio is off one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Standard uncertainty of the magnitude, relative.
    pub magnitude_rel: f64,
    /// Standard uncertainty of the magnitude once the ratio at 160 Hz was measured and taken away.
    pub shape_rel: f64,
    /// Standard uncertainty of the phase, degrees.
    pub phase_deg: f64,
}

/// Spread of the two inputs, and of the two IEPE couplings, with capacitors of `percent`.
///
/// # Errors
/// The file is not there or holds another number of rows.
pub fn of(run: &Run, percent: &str) -> Result<[Vec<Spread>; 2], Fault> {
    let rows = run.rows(&format!("spread-{percent}.txt"))?;
    if rows.len() != PAIRS * FREQUENCIES || rows.iter().any(|row| row.values.len() != 4) {
        return Err(format!("spread-{percent}.txt has {} rows", rows.len()).into());
    }
    Ok([0, 2].map(|first| spread(&rows, first)))
}

fn spread(rows: &[Row], first: usize) -> Vec<Spread> {
    let ratio = |row: &Row| row.values[first + 1] / row.values[first];
    let pairs: Vec<Vec<Complex<f64>>> = rows
        .as_chunks::<FREQUENCIES>()
        .0
        .iter()
        .map(|pair| pair.iter().map(ratio).collect())
        .collect();
    let rms = |of: &dyn Fn(&Vec<Complex<f64>>) -> f64| {
        let sum: f64 = pairs.iter().map(|pair| of(pair).powi(2)).sum();
        (sum / PAIRS as f64).sqrt()
    };
    let at = |index: usize| Spread {
        frequency_hz: rows[index].frequency_hz,
        magnitude_rel: rms(&|pair| pair[index].norm() - 1.0),
        shape_rel: rms(&|pair| pair[index].norm() / pair[REFERENCE].norm() - 1.0),
        phase_deg: rms(&|pair| pair[index].arg().to_degrees()),
    };
    (0..FREQUENCIES).map(at).collect()
}
