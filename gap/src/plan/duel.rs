//! Two sets of effects: one is true, the other is refitted as well as it can be.

use super::side::{Datum, Parameters, Side};
use crate::calibrator::fit::Fit;
use crate::calibrator::problem::Problem;
use crate::estimation::tangent::Equations;
use crate::observable::{Group, Observable, Table};
use crate::thresholds;
use nalgebra::{Cholesky, DMatrix, DVector};

/// State of a comparison.
pub(super) struct Duel {
    /// Names of the set that is taken for true.
    pub(super) truth: Vec<&'static str>,
    /// Names of the set that tries to look like it.
    pub(super) rival: Vec<&'static str>,
    rows: Vec<Vec<Datum>>,
    normal: Equations,
    /// Inverse of the normal matrix.
    covariance: DMatrix<f64>,
    /// How far the refitted parameters have moved to look alike.
    moved: DVector<f64>,
    square: f64,
}

impl Duel {
    /// Compares fits of the problem `of` on the data there are (none: nothing measured yet).
    pub(super) fn new(
        old: Option<&Problem>,
        new: &Problem,
        of: &Problem,
        [truth, rival]: [&Fit; 2],
    ) -> Option<Self> {
        let fits = [truth, rival];
        let points = Side::on(new, of, fits);
        let measured = old.map(|old| Side::on(old, of, fits));
        let scales = points.scales(new.free.len());
        let names = Parameters::new(new, old, rival.parameter_count());
        // Priors are data too: the refit may have moved far from what is stated already.
        let prior = names.prior(new, old);
        let [true_theta, theta] = fits.map(|fit| names.values(of, old, &fit.theta));
        let cost = |theta: &DVector<f64>| theta.dot(&prior.component_mul(theta));
        let mut square = cost(&theta) - cost(&true_theta);
        let mut normal = Equations {
            gradient: -prior.component_mul(&theta),
            matrix: DMatrix::from_diagonal(&prior),
        };
        if let Some(side) = &measured {
            let rows = side.rows(&names.of_old, &scales, names.count);
            for datum in rows.iter().flatten() {
                normal.add(&datum.slopes, datum.difference);
                square += datum.difference * datum.difference;
            }
        }
        for i in 0..names.count {
            normal.matrix[(i, i)] += thresholds::UNTAUGHT_RIDGE * (1.0 + normal.matrix[(i, i)]);
        }
        let covariance = normal.covariance()?;
        let moved = &covariance * &normal.gradient;
        square -= normal.gradient.dot(&moved);
        Some(Self {
            truth: truth.names(),
            rival: rival.names(),
            rows: points.rows(&names.of_new, &scales, names.count),
            normal,
            covariance,
            moved,
            square: square.max(0.0),
        })
    }

    /// Separation in standard uncertainties.
    pub(super) fn sigma(&self) -> f64 {
        self.square.sqrt()
    }

    pub(super) fn square(&self) -> f64 {
        self.square
    }

    /// By how much a point raises the squared separation (Kalman's innovation), and how
    /// much it teaches about what is refitted (logarithm of the ratio of variances).
    pub(super) fn gain(&self, row: usize, known: &Table<bool>) -> (f64, f64) {
        let data: Vec<&Datum> = self.rows[row]
            .iter()
            .filter(|d| known[d.observable])
            .collect();
        if data.is_empty() {
            return (0.0, 0.0);
        }
        let slopes: Vec<DVector<f64>> = data.iter().map(|d| d.slopes.clone()).collect();
        let slopes = DMatrix::from_columns(&slopes);
        let mut scatter = slopes.transpose() * (&self.covariance * &slopes);
        for i in 0..data.len() {
            scatter[(i, i)] += 1.0;
        }
        let differences = data.iter().map(|d| d.difference);
        let innovation =
            DVector::from_iterator(data.len(), differences) - slopes.tr_mul(&self.moved);
        let Some(factor) = Cholesky::new(scatter) else {
            return (0.0, 0.0);
        };
        let logs = factor
            .l_dirty()
            .diagonal()
            .iter()
            .map(|l| l.ln())
            .sum::<f64>();
        (innovation.dot(&factor.solve(&innovation)), 2.0 * logs)
    }

    /// Adds a point.
    pub(super) fn add(&mut self, row: usize, known: &Table<bool>) {
        self.square += self.gain(row, known).0;
        for datum in self.rows[row].iter().filter(|d| known[d.observable]) {
            self.normal.add(&datum.slopes, datum.difference);
        }
        if let Some(covariance) = self.normal.covariance() {
            self.moved = &covariance * &self.normal.gradient;
            self.covariance = covariance;
        }
    }

    /// Observable in which a point tells the two apart.
    pub(super) fn look_at(&self, row: usize, known: &Table<bool>) -> &'static str {
        let left = |d: &&Datum| (d.difference - d.slopes.dot(&self.moved)).abs();
        let data = self.rows[row].iter().filter(|d| known[d.observable]);
        let most = data.max_by(|a, b| left(a).total_cmp(&left(b)));
        most.map_or("ratio", |d| words(d.observable))
    }
}

/// Words for an observable.
fn words(observable: Observable) -> &'static str {
    match (observable.group(), observable.is_phase()) {
        (Group::Ratio, false) => "ratio",
        (Group::Ratio, true) => "phase of the ratio",
        (Group::Drive, false) => "drive",
        (Group::Drive, true) => "phase of the drive",
        (Group::Current, false) => "coil current",
        (Group::Current, true) => "phase of the coil current",
        (Group::RefHarmonics, _) => "harmonics of the reference",
        (Group::DutHarmonics, _) => "harmonics of the device under test",
        (Group::Dc, _) => "d.c.",
        (Group::Noise, _) => "noise",
        (Group::Output, _) => "output",
    }
}
