//! Columns of a Jacobian, sparse by block of data.

use std::ops::Range;

/// Blocks in which the data of a model lie, one behind the other.
pub(crate) trait Blocks {
    /// Key of a block.
    type Block: Copy + PartialEq;

    /// Places of the data of a block.
    fn data_of(&self, block: Self::Block) -> Range<usize>;

    /// All blocks with data.
    fn blocks(&self) -> impl Iterator<Item = (Self::Block, Range<usize>)>;
}

/// Data that are not told apart: so many in one block.
pub(crate) struct OneBlock(pub(crate) usize);

impl Blocks for OneBlock {
    type Block = ();

    fn data_of(&self, (): ()) -> Range<usize> {
        0..self.0
    }

    fn blocks(&self) -> impl Iterator<Item = ((), Range<usize>)> {
        std::iter::once(((), 0..self.0))
    }
}

impl Column<()> {
    /// Column over data of one block.
    pub(crate) fn of_one_block(values: Vec<f64>) -> Self {
        Self {
            parts: vec![((), values)],
        }
    }
}

/// One column of a Jacobian: values in the blocks it touches.
#[derive(Debug, Clone)]
pub(crate) struct Column<B> {
    pub(crate) parts: Vec<(B, Vec<f64>)>,
}

impl<B> Default for Column<B> {
    fn default() -> Self {
        Self { parts: Vec::new() }
    }
}

impl<B: Copy + PartialEq> Column<B> {
    /// Inner product with another column.
    pub(crate) fn dot(&self, other: &Self) -> f64 {
        let mut sum = 0.0;
        for (block, a) in &self.parts {
            if let Some((_, b)) = other.parts.iter().find(|(s, _)| s == block) {
                sum += dot(a, b);
            }
        }
        sum
    }

    /// Inner product with a vector over all data.
    pub(crate) fn dot_data(&self, of: &impl Blocks<Block = B>, data: &[f64]) -> f64 {
        self.parts
            .iter()
            .map(|(block, a)| dot(a, &data[of.data_of(*block)]))
            .sum()
    }

    /// Square of the length.
    pub(crate) fn norm2(&self) -> f64 {
        self.parts.iter().map(|(_, a)| dot(a, a)).sum()
    }

    /// The column with each value times that of a vector over all data.
    pub(crate) fn weighted(&self, of: &impl Blocks<Block = B>, data: &[f64]) -> Self {
        let of_block = |(block, values): &(B, Vec<f64>)| {
            let weights = &data[of.data_of(*block)];
            let products = values.iter().zip(weights).map(|(v, w)| v * w);
            (*block, products.collect())
        };
        Self {
            parts: self.parts.iter().map(of_block).collect(),
        }
    }

    /// Adds values in a block.
    pub(crate) fn add_part(&mut self, block: B, values: Vec<f64>) {
        match self.parts.iter_mut().find(|(s, _)| *s == block) {
            Some((_, sum)) => sum.iter_mut().zip(values).for_each(|(s, v)| *s += v),
            None => self.parts.push((block, values)),
        }
    }

    /// Multiplies the column.
    pub(crate) fn scale(&mut self, factor: f64) {
        for (_, values) in &mut self.parts {
            values.iter_mut().for_each(|v| *v *= factor);
        }
    }

    /// Adds a multiple of the column to a vector over all data.
    pub(crate) fn add_to(&self, of: &impl Blocks<Block = B>, data: &mut [f64], factor: f64) {
        for (block, values) in &self.parts {
            let data = &mut data[of.data_of(*block)];
            for (d, v) in data.iter_mut().zip(values) {
                *d += factor * v;
            }
        }
    }

    /// Column of differences `(b - a) * scale` over all data, zero blocks left out.
    pub(crate) fn difference(
        of: &impl Blocks<Block = B>,
        a: &[f64],
        b: &[f64],
        scale: f64,
    ) -> Self {
        let mut parts = Vec::new();
        for (block, range) in of.blocks() {
            let values: Vec<f64> = a[range.clone()]
                .iter()
                .zip(&b[range.clone()])
                .map(|(a, b)| (b - a) * scale)
                .collect();
            if values.iter().any(|v| v.abs() > 1e-11 * scale.abs()) {
                parts.push((block, values));
            }
        }
        Self { parts }
    }
}

/// Inner product in four lanes, so that the compiler may use vector instructions.
#[inline]
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; 4];
    let ((chunks_a, rest_a), (chunks_b, rest_b)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    for (x, y) in chunks_a.iter().zip(chunks_b) {
        for lane in 0..4 {
            lanes[lane] += x[lane] * y[lane];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(x, y)| x * y).sum();
    lanes.iter().sum::<f64>() + rest
}
