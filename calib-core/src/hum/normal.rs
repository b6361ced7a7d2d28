//! Normal equations of a few unknowns, by Cholesky's method.

/// Most unknowns: tone and three lines, complex.
pub(super) const MOST: usize = 8;

/// A symmetric system `M x = b`, `M` positive definite.
pub(super) struct Normal {
    unknowns: usize,
    matrix: [[f32; MOST]; MOST],
    right: [f32; MOST],
}

impl Normal {
    /// A system of so many unknowns, all zero but what `diagonal` says.
    pub(super) fn new(unknowns: usize, diagonal: impl Fn(usize) -> f32) -> Self {
        let mut matrix = [[0.0; MOST]; MOST];
        for (index, row) in matrix.iter_mut().enumerate() {
            if let Some(value) = row.get_mut(index) {
                *value = diagonal(index);
            }
        }
        Self {
            unknowns: unknowns.min(MOST),
            matrix,
            right: [0.0; MOST],
        }
    }

    /// Adds an equation `sum row x = value` of weight 1.
    #[inline(never)]
    pub(super) fn add(&mut self, row: &[f32; MOST], value: f32) {
        let rows = self.matrix.iter_mut().zip(&mut self.right).zip(row);
        for ((sums, right), factor) in rows.take(self.unknowns) {
            for (sum, other) in sums.iter_mut().zip(row).take(self.unknowns) {
                *sum += factor * other;
            }
            *right += factor * value;
        }
    }

    /// The solution, and the first two of the diagonal of the inverse.
    #[inline(never)]
    pub(super) fn solve(mut self) -> ([f32; MOST], [f32; 2]) {
        self.factorise();
        let inverse = [0, 1].map(|index| {
            let mut unit = [0.0; MOST];
            if let Some(one) = unit.get_mut(index) {
                *one = 1.0;
            }
            let solved = self.back(self.forth(unit));
            solved.get(index).copied().unwrap_or_default()
        });
        (self.back(self.forth(self.right)), inverse)
    }

    /// Puts the factor `L` of `M = L L'` into the lower triangle.
    #[inline(never)]
    fn factorise(&mut self) {
        for column in 0..self.unknowns {
            for row in column..self.unknowns {
                let known: f32 = (0..column)
                    .map(|k| self.at(row, k) * self.at(column, k))
                    .sum();
                let rest = self.at(row, column) - known;
                let value = if row == column {
                    // Positive but for rounding.
                    libm::sqrtf(rest.max(f32::MIN_POSITIVE))
                } else {
                    rest / self.at(column, column)
                };
                if let Some(place) = self.matrix.get_mut(row).and_then(|r| r.get_mut(column)) {
                    *place = value;
                }
            }
        }
    }

    fn at(&self, row: usize, column: usize) -> f32 {
        let row = self.matrix.get(row);
        row.and_then(|row| row.get(column)).copied().unwrap_or(1.0)
    }

    /// Solves `L y = b`.
    #[inline(never)]
    fn forth(&self, mut b: [f32; MOST]) -> [f32; MOST] {
        for row in 0..self.unknowns {
            let known: f32 = b
                .iter()
                .take(row)
                .enumerate()
                .map(|(k, y)| self.at(row, k) * y)
                .sum();
            if let Some(value) = b.get_mut(row) {
                *value = (*value - known) / self.at(row, row);
            }
        }
        b
    }

    /// Solves `L' x = y`.
    #[inline(never)]
    fn back(&self, mut y: [f32; MOST]) -> [f32; MOST] {
        for row in (0..self.unknowns).rev() {
            let later = y.iter().enumerate().take(self.unknowns).skip(row + 1);
            let known: f32 = later.map(|(k, x)| self.at(k, row) * x).sum();
            if let Some(value) = y.get_mut(row) {
                *value = (*value - known) / self.at(row, row);
            }
        }
        y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: x + y = 3, x - y = 1 and x = 2 have x = 2, y = 1; `M` is diag(3, 2).
    #[test]
    fn three_equations_of_two_unknowns() {
        let mut normal = Normal::new(2, |_| 0.0);
        for (x, y, value) in [(1.0, 1.0, 3.0), (1.0, -1.0, 1.0), (1.0, 0.0, 2.0)] {
            let mut row = [0.0; MOST];
            (row[0], row[1]) = (x, y);
            normal.add(&row, value);
        }
        let (solution, inverse) = normal.solve();
        for (value, expected) in [
            (solution[0], 2.0),
            (solution[1], 1.0),
            (inverse[0], 1.0 / 3.0),
            (inverse[1], 0.5),
        ] {
            assert!((value - expected).abs() < 1.0e-6, "{value} {expected}");
        }
    }
}
