//! How measured values scatter, and how that differs from what is stated.

use super::random::Random;
use super::table::VALUES;

/// True scatter beside the stated one.
#[derive(Clone)]
pub(crate) enum Scatter {
    /// Independent and as large as stated.
    AsStated,
    /// Independent and larger by a factor.
    Scaled(f64),
    /// As stated, but for so many rows that were misread.
    Misread(usize),
    /// As large as stated, each row remembering this share of the one before it.
    Correlated(f64),
}

/// A misread row is off by so many standard uncertainties, either way.
const MISREAD_SIGMA: (f64, f64) = (12.0, 60.0);

/// The deviates of a table, row by row.
pub(crate) struct Deviates {
    scatter: Scatter,
    /// Last deviate of each value, where rows remember.
    last: [Option<f64>; VALUES],
    /// Rows that were misread.
    pub(crate) misread: Vec<usize>,
}

impl Deviates {
    /// Misread rows are among the first `rows` that are written.
    pub(crate) fn new(scatter: Scatter, rows: usize, random: &mut Random) -> Self {
        let mut misread = Vec::new();
        if let Scatter::Misread(count) = scatter {
            while misread.len() < count.min(rows) {
                let row = random.below(rows);
                if !misread.contains(&row) {
                    misread.push(row);
                }
            }
            misread.sort_unstable();
        }
        Self {
            scatter,
            last: [None; VALUES],
            misread,
        }
    }

    /// Deviate of a value in units of its stated standard uncertainty. The values of a row are
    /// numbered from the ratio, its magnitude and phase.
    pub(crate) fn of(&mut self, row: usize, value: usize, random: &mut Random) -> f64 {
        let fresh = random.normal();
        match self.scatter {
            Scatter::AsStated => fresh,
            Scatter::Scaled(factor) => factor * fresh,
            Scatter::Misread(_) if value < 2 && self.misread.contains(&row) => {
                fresh + random.log_between(MISREAD_SIGMA.0, MISREAD_SIGMA.1) * random.sign()
            }
            Scatter::Misread(_) => fresh,
            Scatter::Correlated(memory) => {
                let before = self.last[value];
                let now = before.map_or(fresh, |before| {
                    memory * before + (1.0 - memory * memory).sqrt() * fresh
                });
                self.last[value] = Some(now);
                now
            }
        }
    }
}
