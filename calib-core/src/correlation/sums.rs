//! Sums in f32 that do not lose digits with their length.

/// Terms summed plainly before they are carried over.
const CARRY_AFTER: u32 = 64;

/// `N` sums side by side, in two levels.
///
/// 64 terms are summed plainly, their sums with Neumaier's compensation: the
/// relative error stays near that of 64 additions however many terms come.
#[derive(Clone, Copy)]
pub(super) struct Sums<const N: usize> {
    inner: [f32; N],
    outer: [f32; N],
    lost: [f32; N],
    count: u32,
}

impl<const N: usize> Sums<N> {
    pub(super) fn new() -> Self {
        Self {
            inner: [0.0; N],
            outer: [0.0; N],
            lost: [0.0; N],
            count: 0,
        }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, terms: [f32; N]) {
        for (sum, term) in self.inner.iter_mut().zip(terms) {
            *sum += term;
        }
        self.count += 1;
        if self.count == CARRY_AFTER {
            self.carry();
        }
    }

    #[inline(never)]
    fn carry(&mut self) {
        let sums = self.outer.iter_mut().zip(&mut self.lost);
        for ((outer, lost), inner) in sums.zip(&mut self.inner) {
            let sum = *outer + *inner;
            // The larger of the two keeps its digits; what the other lost:
            *lost += if outer.abs() >= inner.abs() {
                (*outer - sum) + *inner
            } else {
                (*inner - sum) + *outer
            };
            *outer = sum;
            *inner = 0.0;
        }
        self.count = 0;
    }

    pub(super) fn total(mut self) -> [f32; N] {
        self.carry();
        let mut total = self.outer;
        for (sum, lost) in total.iter_mut().zip(self.lost) {
            *sum += lost;
        }
        total
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_small_terms_are_not_lost_beside_a_large_sum() {
        // 3 million times 0.1 (the f32 nearest to it): plain f32 summation is
        // off by some per cent here, 64 plain additions by at most 64 * 2^-24.
        let mut sums = Sums::<1>::new();
        for _ in 0..3_000_000 {
            sums.add([0.1]);
        }
        let exact = 3.0e6 * f64::from(0.1_f32);
        let [total] = sums.total();
        assert!((f64::from(total) / exact - 1.0).abs() < 64.0 / 16_777_216.0);
    }
}
