//! Trials of a budget: distributions in, values of the measurand out.

use super::elementary::{cos_sin_turn, ln};
use super::random::{LANES, Lanes};
use crate::budget::{Budget, Coefficient, Component, Correlation, Distribution, Model, Unit};
use nalgebra::{DMatrix, SymmetricEigen};

/// Trials drawn together: a multiple of two lanes that stays in the L1 cache.
pub const BATCH: usize = 8 * LANES;

/// How one component's error is drawn; lengths in the model's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Normal {
        standard: f64,
    },
    /// Scaled and shifted t (GUM-S1 6.4.9).
    Student {
        standard: f64,
        degrees_of_freedom: f64,
    },
    Rectangular {
        half: f64,
    },
    Triangular {
        half: f64,
    },
    UShaped {
        half: f64,
    },
    Transverse {
        half: f64,
    },
}

/// How a component enters the model.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Entry {
    /// A factor of the numerator.
    Factor,
    /// A factor of the denominator.
    Divisor,
    /// A factor to a power.
    Power(f64),
    /// A summand with this coefficient.
    Summand(f64),
}

/// A budget prepared for drawing.
#[derive(Clone, Debug)]
pub struct Plan {
    independent: Vec<(Shape, Entry)>,
    /// Correlated components: square root of their covariance matrix, row by
    /// row, drawn as joint normal.
    correlated: Vec<(Vec<f64>, Entry)>,
    /// Value units per model unit: 100 for percent.
    scale: f64,
    product: bool,
}

impl Plan {
    /// Prepares a checked budget.
    pub fn new(budget: &Budget) -> Self {
        let scale = match (budget.unit, budget.model) {
            (Unit::Percent, Model::Product) => 100.0,
            _ => 1.0,
        };
        let involved = correlated_indices(&budget.correlations);
        let mut plan = Self {
            independent: Vec::new(),
            correlated: correlated_rows(budget, &involved, scale),
            scale,
            product: budget.model == Model::Product,
        };
        for (index, component) in budget.components.iter().enumerate() {
            if component.value > 0.0 && !involved.contains(&index) {
                let entry = entry(component, budget.model);
                plan.independent.push((shape(component, scale), entry));
            }
        }
        plan
    }

    /// Fills `out` with trials of the measurand's deviation, in the unit of
    /// the budget. The length must be a multiple of [`BATCH`].
    pub fn fill(&self, lanes: &mut Lanes, out: &mut [f64]) {
        pulp::Arch::new().dispatch(Batches {
            plan: self,
            lanes,
            out,
        });
    }

    #[inline(always)]
    fn batch(&self, lanes: &mut Lanes, out: &mut [f64; BATCH]) {
        let start = if self.product { 1.0 } else { 0.0 };
        let mut above = [start; BATCH];
        let mut below = [1.0; BATCH];
        let mut error = [0.0; BATCH];
        for (shape, entry) in &self.independent {
            shape.fill(lanes, &mut error);
            entry.apply(&error, &mut above, &mut below);
        }
        self.apply_correlated(lanes, &mut above, &mut below);
        match self.product {
            true => {
                for index in 0..BATCH {
                    out[index] = (above[index] / below[index] - 1.0) * self.scale;
                }
            }
            false => out.copy_from_slice(&above),
        }
    }

    #[inline(always)]
    fn apply_correlated(
        &self,
        lanes: &mut Lanes,
        above: &mut [f64; BATCH],
        below: &mut [f64; BATCH],
    ) {
        if self.correlated.is_empty() {
            return;
        }
        let mut normals = vec![[0.0; BATCH]; self.correlated.len()];
        for numbers in &mut normals {
            lanes.fill_normal(numbers);
        }
        for (row, entry) in &self.correlated {
            let mut error = [0.0; BATCH];
            for (weight, numbers) in row.iter().zip(&normals) {
                for index in 0..BATCH {
                    error[index] += weight * numbers[index];
                }
            }
            entry.apply(&error, above, below);
        }
    }
}

struct Batches<'a> {
    plan: &'a Plan,
    lanes: &'a mut Lanes,
    out: &'a mut [f64],
}

impl pulp::NullaryFnOnce for Batches<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let mut lanes = self.lanes.clone();
        let (batches, _) = self.out.as_chunks_mut::<BATCH>();
        for batch in batches {
            self.plan.batch(&mut lanes, batch);
        }
        *self.lanes = lanes;
    }
}

impl Entry {
    #[inline(always)]
    fn apply(self, error: &[f64; BATCH], above: &mut [f64; BATCH], below: &mut [f64; BATCH]) {
        match self {
            Self::Factor => (0..BATCH).for_each(|index| above[index] *= 1.0 + error[index]),
            Self::Divisor => (0..BATCH).for_each(|index| below[index] *= 1.0 + error[index]),
            Self::Power(exponent) => {
                (0..BATCH).for_each(|index| above[index] *= (1.0 + error[index]).powf(exponent));
            }
            Self::Summand(coefficient) => {
                (0..BATCH).for_each(|index| above[index] += coefficient * error[index]);
            }
        }
    }
}

impl Shape {
    #[inline(always)]
    fn fill(self, lanes: &mut Lanes, out: &mut [f64; BATCH]) {
        let (chunks, _) = out.as_chunks_mut::<LANES>();
        match self {
            Self::Normal { standard } => {
                let (pairs, _) = chunks.as_chunks_mut::<2>();
                for [first, second] in pairs {
                    lanes.normal_into(first, second);
                    for lane in 0..LANES {
                        first[lane] *= standard;
                        second[lane] *= standard;
                    }
                }
            }
            Self::Student {
                standard,
                degrees_of_freedom,
            } => {
                for chunk in chunks {
                    student_into(lanes, standard, degrees_of_freedom, chunk);
                }
            }
            Self::Rectangular { half } => {
                for chunk in chunks {
                    rectangular_into(lanes, half, chunk);
                }
            }
            Self::Triangular { half } => {
                for chunk in chunks {
                    triangular_into(lanes, half, chunk);
                }
            }
            Self::UShaped { half } => {
                for chunk in chunks {
                    u_shaped_into(lanes, half, chunk);
                }
            }
            Self::Transverse { half } => {
                for chunk in chunks {
                    transverse_into(lanes, half, chunk);
                }
            }
        }
    }
}

#[inline(always)]
fn rectangular_into(lanes: &mut Lanes, half: f64, out: &mut [f64; LANES]) {
    lanes.uniform_into(out);
    for value in out.iter_mut() {
        *value = half * (2.0 * *value - 1.0);
    }
}

/// The difference of two rectangular ones.
#[inline(always)]
fn triangular_into(lanes: &mut Lanes, half: f64, out: &mut [f64; LANES]) {
    let mut other = [0.0; LANES];
    lanes.uniform_into(out);
    lanes.uniform_into(&mut other);
    for lane in 0..LANES {
        out[lane] = half * (out[lane] - other[lane]);
    }
}

/// The cosine of any angle.
#[inline(always)]
fn u_shaped_into(lanes: &mut Lanes, half: f64, out: &mut [f64; LANES]) {
    lanes.uniform_into(out);
    for value in out.iter_mut() {
        *value = half * cos_sin_turn(*value).0;
    }
}

/// Two rectangular factors and the cosine of any angle.
#[inline(always)]
fn transverse_into(lanes: &mut Lanes, half: f64, out: &mut [f64; LANES]) {
    let mut a = [0.0; LANES];
    let mut b = [0.0; LANES];
    lanes.uniform_into(&mut a);
    lanes.uniform_into(&mut b);
    lanes.uniform_into(out);
    for lane in 0..LANES {
        let size = (2.0 * a[lane] - 1.0) * (2.0 * b[lane] - 1.0);
        out[lane] = half * size * cos_sin_turn(out[lane]).0;
    }
}

/// Student's t by Bailey (1994): `sqrt(nu (U^(-2/nu) - 1)) cos(2 pi V)`.
#[inline(always)]
fn student_into(lanes: &mut Lanes, standard: f64, degrees_of_freedom: f64, out: &mut [f64; LANES]) {
    let mut angle = [0.0; LANES];
    lanes.uniform_into(out);
    lanes.uniform_into(&mut angle);
    for lane in 0..LANES {
        let power = (-2.0 / degrees_of_freedom * ln(1.0 - out[lane])).exp_m1();
        let length = (degrees_of_freedom * power).sqrt();
        out[lane] = standard * length * cos_sin_turn(angle[lane]).0;
    }
}

fn shape(component: &Component, scale: f64) -> Shape {
    let half = component.value / scale;
    let standard = component.standard_uncertainty() / scale;
    let degrees_of_freedom = component.degrees_of_freedom;
    match component.distribution {
        Distribution::Rectangular => Shape::Rectangular { half },
        Distribution::Triangular => Shape::Triangular { half },
        Distribution::UShaped => Shape::UShaped { half },
        Distribution::Special {
            transverse: true, ..
        } => Shape::Transverse { half },
        _ if degrees_of_freedom.is_finite() => Shape::Student {
            standard,
            degrees_of_freedom,
        },
        _ => Shape::Normal { standard },
    }
}

fn entry(component: &Component, model: Model) -> Entry {
    let coefficient = component.sensitivity_coefficient;
    match model {
        Model::Sum => Entry::Summand(coefficient),
        Model::Product if coefficient == 1.0 => Entry::Factor,
        Model::Product if coefficient == -1.0 => Entry::Divisor,
        Model::Product => Entry::Power(coefficient),
    }
}

fn correlated_indices(correlations: &[Correlation]) -> Vec<usize> {
    let mut indices: Vec<usize> = correlations
        .iter()
        .flat_map(|correlation| [correlation.a, correlation.b])
        .collect();
    indices.sort_unstable();
    indices.dedup();
    indices
}

/// Rows of the symmetric square root of the correlated components' covariance.
fn correlated_rows(budget: &Budget, involved: &[usize], scale: f64) -> Vec<(Vec<f64>, Entry)> {
    if involved.is_empty() {
        return Vec::new();
    }
    let component = |position: usize| &budget.components[involved[position]];
    let mut covariance = DMatrix::from_fn(involved.len(), involved.len(), |row, column| {
        match row == column {
            true => (component(row).standard_uncertainty() / scale).powi(2),
            false => 0.0,
        }
    });
    for correlation in &budget.correlations {
        let place = |index: usize| involved.binary_search(&index).unwrap_or(0);
        let (a, b) = (place(correlation.a), place(correlation.b));
        // The bound of D.4 is the correlation whose contributions add.
        let sign = component(a).sensitivity_coefficient * component(b).sensitivity_coefficient;
        let r = match correlation.coefficient {
            Coefficient::Known(r) => r,
            Coefficient::Unknown => sign.signum(),
        };
        let u = |position: usize| component(position).standard_uncertainty() / scale;
        covariance[(a, b)] = r * u(a) * u(b);
        covariance[(b, a)] = covariance[(a, b)];
    }
    let eigen = SymmetricEigen::new(covariance);
    let roots = DMatrix::from_diagonal(&eigen.eigenvalues.map(|value| value.max(0.0).sqrt()));
    let root = &eigen.eigenvectors * roots * eigen.eigenvectors.transpose();
    (0..involved.len())
        .map(|row| {
            let weights = root.row(row).iter().copied().collect();
            (weights, entry(component(row), budget.model))
        })
        .collect()
}
