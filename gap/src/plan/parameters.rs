//! What is refitted: the parameters of the data there are and of those to come.

use crate::engine::nuisance::Nuisance;
use crate::engine::problem::Problem;
use nalgebra::DVector;

/// Where the columns of both problems belong: shared nuisances once, runs apart.
pub(super) struct Parameters {
    /// How many there are.
    pub(super) count: usize,
    /// Place of each column of the points that may be measured.
    pub(super) of_new: Vec<usize>,
    /// Place of each column of the data there are.
    pub(super) of_old: Vec<usize>,
}

impl Parameters {
    pub(super) fn new(new: &Problem, old: Option<&Problem>, effects: usize) -> Self {
        let shared = new.free.len();
        let mut count = shared;
        let mut of_old = Vec::new();
        for free in old.map_or(&[][..], |o| &o.free) {
            let same = new.free.iter().position(|f| f.kind == free.kind);
            of_old.push(match same.filter(|_| !of_run(free.kind)) {
                Some(at) => at,
                None => {
                    count += 1;
                    count - 1
                }
            });
        }
        let mut of_new: Vec<usize> = (0..shared).collect();
        of_new.extend(count..count + effects);
        of_old.extend(count..count + effects);
        Self {
            count: count + effects,
            of_new,
            of_old,
        }
    }

    /// Nuisance values of a fit of the problem `of`.
    pub(super) fn values(
        &self,
        of: &Problem,
        old: Option<&Problem>,
        theta: &[f64],
    ) -> DVector<f64> {
        let mut values = DVector::zeros(self.count);
        let is_old = old.is_some_and(|old| std::ptr::eq(old, of));
        let place = if is_old { &self.of_old } else { &self.of_new };
        for (value, at) in theta.iter().zip(place) {
            values[*at] = *value;
        }
        values
    }

    /// 1 for a parameter with a prior of one unit.
    pub(super) fn prior(&self, new: &Problem, old: Option<&Problem>) -> DVector<f64> {
        let mut prior = DVector::zeros(self.count);
        let bounded = |b: bool| f64::from(u8::from(b));
        for (free, at) in new.free.iter().zip(&self.of_new) {
            prior[*at] = bounded(free.bounded);
        }
        for (free, at) in old.map_or(&[][..], |o| &o.free).iter().zip(&self.of_old) {
            prior[*at] = bounded(free.bounded);
        }
        prior
    }
}

/// Whether it is a gain of one run.
pub(super) fn of_run(kind: Nuisance) -> bool {
    matches!(kind, Nuisance::RunReference(_) | Nuisance::RunDut(_))
}
