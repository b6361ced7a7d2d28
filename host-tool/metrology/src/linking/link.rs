//! The link itself: every result as a linear form of all inputs.
//!
//! Each derived quantity carries its gradient by all results of both
//! comparisons. Covariances then follow from one sum, and the formulae of the
//! report come out of it rather than being typed in; test
//! `the_printed_formulae_follow` compares them.

use super::reference::{OnFailure, ReferenceValue, reference_value};
use schemars::JsonSchema;
use serde::Serialize;

/// One linked laboratory.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LinkedLaboratory {
    /// Name.
    pub laboratory: String,
    /// Took part in both comparisons.
    pub linking: bool,
    /// Linked result `z = r y`.
    pub value: f64,
    /// Its standard uncertainty.
    pub standard_uncertainty: f64,
    /// Degree of equivalence against the reference value.
    pub d: f64,
    /// Expanded uncertainty of `d`.
    #[serde(rename = "expanded_uncertainty")]
    pub u_expanded: f64,
    /// `d / u_expanded`.
    pub e_n: f64,
}

/// Degree of equivalence between two laboratories.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Pair {
    /// First laboratory.
    pub a: String,
    /// Second laboratory.
    pub b: String,
    /// Difference of the linked results, a - b.
    pub d: f64,
    /// Expanded uncertainty of the difference.
    #[serde(rename = "expanded_uncertainty")]
    pub u_expanded: f64,
    /// `d / u_expanded`.
    pub e_n: f64,
}

/// A linked comparison at one frequency.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Linked {
    /// Reference value of the key comparison.
    pub reference_value: ReferenceValue,
    /// Weighted mean of the linking laboratories in the regional comparison.
    pub linking_mean: ReferenceValue,
    /// Linking coefficient `r = x / y`.
    pub linking_coefficient: f64,
    /// Its standard uncertainty.
    #[serde(rename = "standard_uncertainty_linking_coefficient")]
    pub u_linking_coefficient: f64,
    /// Linked laboratories in the order of the regional comparison.
    pub laboratories: Vec<LinkedLaboratory>,
    /// Every pair of them.
    pub pairs: Vec<Pair>,
}

/// A quantity with its gradient by all inputs.
#[derive(Clone, Debug)]
struct Form {
    value: f64,
    gradient: Vec<f64>,
}

impl Form {
    /// `a self + b other`, with the value given.
    fn combine(&self, a: f64, other: &Self, b: f64, value: f64) -> Self {
        let gradients = self.gradient.iter().zip(&other.gradient);
        Self {
            value,
            gradient: gradients.map(|(g, h)| a * g + b * h).collect(),
        }
    }

    fn standard_uncertainty(&self, variances: &[f64]) -> f64 {
        let terms = self.gradient.iter().zip(variances);
        terms.map(|(g, v)| g * g * v).sum::<f64>().sqrt()
    }
}

/// Links the results `y` to those of the key comparison `x`.
///
/// Entries are (laboratory, value, standard uncertainty); a name in both lists
/// is a linking laboratory. Returns `None` without one. Results of different
/// comparisons are taken as uncorrelated.
///
/// # Equation
/// x and y are weighted means, y over the linking laboratories with the
/// weights of **their own results in the regional comparison** (the report
/// prints u(x_l) there); r = x/y; z_i = r y_i; d_i = z_i - x; u(d_i) includes
/// the covariances of r with y_i and of z_i with x.
///
/// # Accuracy
/// First order. Test `linked_degrees_cover_the_truth`.
pub fn link(
    x: &[(String, f64, f64)],
    y: &[(String, f64, f64)],
    coverage_factor: f64,
    on_failure: OnFailure,
) -> Option<Linked> {
    let inputs = Inputs::new(x, y, on_failure)?;
    let x_form = inputs.reference_form();
    let r = inputs.linking_coefficient(&x_form);
    let linked: Vec<Form> = (0..y.len()).map(|index| inputs.linked(index, &r)).collect();
    let laboratories = linked
        .iter()
        .enumerate()
        .map(|(index, z)| inputs.laboratory(index, z, &x_form, coverage_factor))
        .collect();
    Some(Linked {
        linking_coefficient: r.value,
        u_linking_coefficient: r.standard_uncertainty(&inputs.variances),
        laboratories,
        pairs: pairs(y, &linked, &inputs.variances, coverage_factor),
        reference_value: inputs.reference,
        linking_mean: inputs.mean,
    })
}

/// The results of both comparisons, those of the key comparison first.
struct Inputs<'a> {
    x: &'a [(String, f64, f64)],
    y: &'a [(String, f64, f64)],
    /// Places in `y` of those who took part in both.
    linking: Vec<usize>,
    reference: ReferenceValue,
    mean: ReferenceValue,
    variances: Vec<f64>,
}

impl<'a> Inputs<'a> {
    fn new(
        x: &'a [(String, f64, f64)],
        y: &'a [(String, f64, f64)],
        on_failure: OnFailure,
    ) -> Option<Self> {
        let in_both = |index: &usize| x.iter().any(|(name, ..)| *name == y[*index].0);
        let linking: Vec<usize> = (0..y.len()).filter(in_both).collect();
        if linking.is_empty() {
            return None;
        }
        let (values, u): (Vec<f64>, Vec<f64>) = x.iter().map(|(_, v, u)| (*v, *u)).unzip();
        let reference = reference_value(&values, &u, on_failure);
        let linkers = linking.iter().map(|&index| (y[index].1, y[index].2));
        let (values, u): (Vec<f64>, Vec<f64>) = linkers.unzip();
        let mean = reference_value(&values, &u, on_failure);
        Some(Self {
            variances: variances(x, y, &linking, &reference, &mean),
            x,
            y,
            linking,
            reference,
            mean,
        })
    }

    /// A quantity that depends on nothing yet.
    fn constant(&self, value: f64) -> Form {
        let gradient = vec![0.0; self.variances.len()];
        Form { value, gradient }
    }

    /// x, the reference value.
    fn reference_form(&self) -> Form {
        let mut form = self.constant(self.reference.value);
        form.gradient[..self.x.len()].copy_from_slice(&self.reference.weights);
        form
    }

    /// r = x / y.
    fn linking_coefficient(&self, x: &Form) -> Form {
        let mut y = self.constant(self.mean.value);
        for (&index, weight) in self.linking.iter().zip(&self.mean.weights) {
            y.gradient[self.x.len() + index] = *weight;
        }
        let r = x.value / y.value;
        x.combine(1.0 / y.value, &y, -r / y.value, r)
    }

    /// z = r y of one laboratory.
    fn linked(&self, index: usize, r: &Form) -> Form {
        let mut own = self.constant(self.y[index].1);
        own.gradient[self.x.len() + index] = 1.0;
        r.combine(own.value, &own, r.value, r.value * own.value)
    }

    fn laboratory(
        &self,
        index: usize,
        z: &Form,
        x: &Form,
        coverage_factor: f64,
    ) -> LinkedLaboratory {
        let d = z.combine(1.0, x, -1.0, z.value - x.value);
        let u_expanded = coverage_factor * d.standard_uncertainty(&self.variances);
        LinkedLaboratory {
            laboratory: self.y[index].0.clone(),
            linking: self.linking.contains(&index),
            value: z.value,
            standard_uncertainty: z.standard_uncertainty(&self.variances),
            d: d.value,
            u_expanded,
            e_n: d.value / u_expanded,
        }
    }
}

/// Variances of all inputs; where a mean needed a variance between
/// laboratories, it belongs to the results that formed the mean.
fn variances(
    x: &[(String, f64, f64)],
    y: &[(String, f64, f64)],
    linking: &[usize],
    reference: &ReferenceValue,
    mean: &ReferenceValue,
) -> Vec<f64> {
    let of_x = x
        .iter()
        .map(|(.., u)| u * u + reference.between_laboratories.powi(2));
    let of_y = y.iter().enumerate().map(|(index, (.., u))| {
        let between = match linking.contains(&index) {
            true => mean.between_laboratories.powi(2),
            false => 0.0,
        };
        u * u + between
    });
    of_x.chain(of_y).collect()
}

fn pairs(
    y: &[(String, f64, f64)],
    linked: &[Form],
    variances: &[f64],
    coverage_factor: f64,
) -> Vec<Pair> {
    let mut all = Vec::new();
    for a in 0..y.len() {
        for b in a + 1..y.len() {
            let value = linked[a].value - linked[b].value;
            let difference = linked[a].combine(1.0, &linked[b], -1.0, value);
            let u_expanded = coverage_factor * difference.standard_uncertainty(variances);
            all.push(Pair {
                a: y[a].0.clone(),
                b: y[b].0.clone(),
                d: value,
                u_expanded,
                e_n: value / u_expanded,
            });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_formulae_follow() {
        let named = |list: &[(&str, f64, f64)]| -> Vec<(String, f64, f64)> {
            list.iter()
                .map(|(n, v, u)| ((*n).to_owned(), *v, *u))
                .collect()
        };
        let x = named(&[("A", 130.1, 0.2), ("B", 129.9, 0.3), ("C", 130.2, 0.4)]);
        let y = named(&[
            ("A", 1.001, 0.002),
            ("B", 0.998, 0.003),
            ("D", 1.004, 0.004),
        ]);
        let linked = link(&x, &y, 2.0, OnFailure::Keep).expect("A and B link");
        let (ux, xm) = (
            linked.reference_value.standard_uncertainty,
            linked.reference_value.value,
        );
        let (uy, ym) = (
            linked.linking_mean.standard_uncertainty,
            linked.linking_mean.value,
        );
        let r = xm / ym;
        // (3), and (2) with the laboratories' own u(y_l).
        assert!((1.0 / (uy * uy) - (1.0 / 4e-6 + 1.0 / 9e-6)).abs() < 1.0);
        let ur2 = (ux / ym).powi(2) + (xm * uy / (ym * ym)).powi(2);
        assert!((linked.u_linking_coefficient - ur2.sqrt()).abs() < 1e-12);
        for (laboratory, (_, yl, ul)) in linked.laboratories.iter().zip(&y) {
            // (4): u(r, y_l) = -(x / y^2) u^2(y) for linking laboratories.
            let covariance = match laboratory.linking {
                true => -xm / (ym * ym) * uy * uy,
                false => 0.0,
            };
            let uz2 = yl * yl * ur2 + r * r * ul * ul + 2.0 * r * yl * covariance;
            assert!((laboratory.standard_uncertainty - uz2.sqrt()).abs() < 1e-12);
            let z = r * yl;
            let ud2 = uz2 + (1.0 - 2.0 * z / xm) * ux * ux;
            assert!((laboratory.u_expanded - 2.0 * ud2.sqrt()).abs() < 1e-9);
            assert!((laboratory.d - (z - xm)).abs() < 1e-12);
        }
        assert_eq!(linked.pairs.len(), 3);
    }
}
