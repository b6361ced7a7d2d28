//! Memory of a row between evaluations.

use super::balance::{Balanced, Purpose, balance};
use super::exciter::{Added, Exciter, Fundamental, Nonlinearity};
use super::grid::{ORDERS, Wave};
use num_complex::Complex64;

/// Memory of the harmonic balance of one row between evaluations.
#[derive(Debug, Clone)]
pub(crate) struct Memory {
    motion: Wave,
    /// Last balanced input, and its result: many effects leave the exciter as it was.
    last: Option<(Exciter, Nonlinearity, f64, Balanced)>,
    /// The linear exciter of the last evaluation that had one.
    still: Option<(Exciter, Added, Fundamental)>,
}

impl Default for Memory {
    fn default() -> Self {
        Self {
            motion: [Complex64::ZERO; ORDERS + 1],
            last: None,
            still: None,
        }
    }
}

/// How an evaluation uses the memory of a row.
pub(crate) enum Recall<'a> {
    /// Starts from it, and leaves its own solution there.
    Keep(&'a mut Memory),
    /// Starts from it and leaves it as it is: for a small step.
    Look(&'a Memory),
}

impl Recall<'_> {
    /// The linear exciter, from memory if it is the same as last time.
    pub(super) fn still(
        &mut self,
        exciter: &Exciter,
        added: Added,
        drive: impl FnOnce() -> Fundamental,
    ) -> Fundamental {
        if let Some((e, a, known)) = &self.memory().still
            && (e, a) == (exciter, &added)
        {
            return *known;
        }
        let drive = drive();
        if let Self::Keep(memory) = self {
            memory.still = Some((*exciter, added, drive));
        }
        drive
    }

    fn memory(&self) -> &Memory {
        match self {
            Self::Keep(memory) => memory,
            Self::Look(memory) => memory,
        }
    }

    pub(super) fn balance(
        &mut self,
        exciter: &Exciter,
        bend: &Nonlinearity,
        omega: f64,
        peak_ms2: f64,
    ) -> Balanced {
        let memory = self.memory();
        if let Some((e, b, level, balanced)) = &memory.last
            && (e, b, level) == (exciter, bend, &peak_ms2)
        {
            return *balanced;
        }
        let mut motion = memory.motion;
        // Only from a balance nearby is the first correction the size of the step.
        let purpose = match (&*self, &memory.last) {
            (Self::Look(_), Some((.., near))) if near.converged => Purpose::Slope,
            _ => Purpose::Value,
        };
        let balanced = balance(exciter, bend, omega, peak_ms2, &mut motion, purpose);
        if let Self::Keep(memory) = self {
            memory.motion = motion;
            memory.last = Some((*exciter, *bend, peak_ms2, balanced));
        }
        balanced
    }
}
