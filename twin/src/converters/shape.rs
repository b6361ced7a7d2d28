//! Characteristics of an input converter that its sheet allows.
//!
//! The sheet bounds the integral nonlinearity and says nothing of its shape. What is built against one drawn
//! shape is tried with others.

use rand::RngExt;
use rand_chacha::ChaCha12Rng;
use serde::{Deserialize, Serialize};

use super::{Quantity, Sheet};

/// Codes of the whole range, and of half of it (0 V).
const CODES: f64 = 65_536.0;
pub(crate) const MID_CODE: f64 = CODES / 2.0;
/// The largest bits, whose capacitors differ enough to show; the rest is within the bow.
const UNEQUAL_BITS: u32 = 8;
/// Codes of the smallest of them.
pub(super) const CELL: usize = 65_536 >> UNEQUAL_BITS;

/// Cells of the unequal bits.
const CELLS: usize = 65_536 / CELL;
/// Integral nonlinearity, codes, at most (DS12110 Rev 10, table 186, typical, UFBGA).
const INTEGRAL: f64 = 10.0;

/// Shape of the characteristic beside the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    /// A bow, and the step of the sheet where the largest bit turns; smaller ones where smaller bits turn.
    #[default]
    Bits,
    /// [`Shape::Bits`], all of it twice as large.
    BitsDoubled,
    /// [`Shape::Bits`], half as large.
    BitsHalved,
    /// A step of the sheet at each sixteenth of the range, mid-scale in the middle between two.
    Sixteenths,
    /// All that the sheet allows at once: the highest integral nonlinearity above mid-scale, the lowest below.
    Wall,
}

impl Shape {
    /// Whether it is that of the default.
    pub(crate) fn is_bits(&self) -> bool {
        *self == Self::Bits
    }

    /// Codes beside the line through both ends, by cell of the unequal bits: `(at its first code, at its
    /// last)`.
    pub(super) fn curve(self, sheet: Sheet, random: &mut ChaCha12Rng) -> Vec<[f64; 2]> {
        match self {
            Self::Bits => bits(sheet, 1.0, random),
            Self::BitsDoubled => bits(sheet, 2.0, random),
            Self::BitsHalved => bits(sheet, 0.5, random),
            Self::Sixteenths => {
                let carry = sign(random) * sheet.value(Quantity::InputCarry);
                by_code(|code| {
                    let tooth = 16.0 * code / (2.0 * MID_CODE) + 0.5;
                    carry * (tooth.fract() - 0.5)
                })
            }
            Self::Wall => {
                let high = sign(random) * INTEGRAL;
                by_code(|code| if code < MID_CODE { -high } else { high })
            }
        }
    }
}

fn sign(random: &mut ChaCha12Rng) -> f64 {
    if random.random_bool(0.5) { 1.0 } else { -1.0 }
}

/// A curve that is straight within each cell.
fn by_code(beside: impl Fn(f64) -> f64) -> Vec<[f64; 2]> {
    let ends = |cell: usize| {
        let first = (cell * CELL) as f64;
        // The last point of a cell is before the step at the next.
        [beside(first), beside(first + CELL as f64 - 1e-6)]
    };
    (0..CELLS).map(ends).collect()
}

/// A bow of second and third order, and bits whose weights are off, the largest so far that mid-scale has the
/// table's step.
fn bits(sheet: Sheet, factor: f64, random: &mut ChaCha12Rng) -> Vec<[f64; 2]> {
    let carry = factor * sheet.value(Quantity::InputCarry);
    let bow = factor * sheet.value(Quantity::InputBow);
    let signs = [sign(random), sign(random), sign(random)];
    let unequal = CELLS.ilog2();
    let mut weights: Vec<f64> = (1..unequal)
        .map(|bit| {
            let size = carry * 0.5_f64.powf(f64::from(bit) / 2.0);
            size * random.random_range(-1.0..=1.0)
        })
        .collect();
    weights.insert(0, signs[0] * carry + weights.iter().sum::<f64>());
    let bits = |cell: usize| -> f64 {
        let set = |bit: &usize| cell >> (weights.len() - 1 - bit) & 1 == 1;
        (0..weights.len()).filter(set).map(|bit| weights[bit]).sum()
    };
    let slope = bits(CELLS - 1) / (2.0 * MID_CODE - 1.0);
    // Peaks of 1 - x2 and of x - x3 between -1 and 1 are 1 and 2 / sqrt(27).
    let bowed = |code: f64| {
        let x = code / MID_CODE - 1.0;
        let even = signs[1] * (1.0 - x * x);
        let odd = signs[2] * (x - x * x * x) * 27.0_f64.sqrt() / 2.0;
        bow * 0.5 * (even + odd)
    };
    (0..CELLS)
        .map(|cell| {
            let first = (cell * CELL) as f64;
            let beside = |code: f64| bits(cell) - slope * code + bowed(code);
            [beside(first), beside(first + CELL as f64)]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;

    /// Value of a shape at the code, from either side.
    fn at(shape: Shape, code: usize) -> [f64; 2] {
        let mut random = ChaCha12Rng::seed_from_u64(4);
        let curve = shape.curve(Sheet::new(1.0), &mut random);
        [curve[code / CELL - 1][1], curve[code / CELL][0]]
    }

    #[test]
    fn every_shape_has_its_steps_where_it_says() {
        let step = |shape, code| {
            let [before, after] = at(shape, code);
            (after - before).abs()
        };
        for (shape, code, codes) in [
            (Shape::Bits, 32_768, 3.0),
            (Shape::BitsDoubled, 32_768, 6.0),
            (Shape::BitsHalved, 32_768, 1.5),
            (Shape::Sixteenths, 32_768, 0.0),
            (Shape::Sixteenths, 32_768 + 2048, 3.0),
            (Shape::Sixteenths, 32_768 + 6144, 3.0),
            (Shape::Wall, 32_768, 20.0),
            (Shape::Wall, 36_864, 0.0),
        ] {
            assert!((step(shape, code) - codes).abs() < 1e-4, "{shape:?} {code}");
        }
    }
}
