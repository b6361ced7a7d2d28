//! How large a gap is to whoever knows the rig only within its uncertainties.
//!
//! Damping that an effect adds is no gap where the nominal damping is as uncertain. So the size of a
//! gap is what is left of it when nominal values, mounting and the measurand have been fitted: the
//! root of the least sum of squares, priors included, over the standard uncertainties of all values.

use super::differences::differences;
use calib_gap::{Observable, Table};
use calib_twin::dataset::{Generated, Nominal, Options, Point, Quantity, Setting, generate};
use nalgebra::{DMatrix, DVector};
use std::cell::OnceCell;

/// Gauss-Newton steps at most.
const STEPS: usize = 8;
/// Times a step that leads nowhere is halved.
const HALVINGS: usize = 4;
/// Share by which a step has to lower the sum of squares to be followed by another.
const WORTH: f64 = 1e-2;
/// Standard uncertainties a nominal value moves at most.
const FARTHEST_U: f64 = 6.0;
/// Standard uncertainties by which a nominal value is moved for a slope.
const SMALL: f64 = 0.1;
/// Gaps smaller than this, in sigma, are not fitted.
const NOTHING: f64 = 1.0;

type Pick = fn(&mut Nominal) -> &mut Quantity;
/// Nominal values that move. The device's sensitivity is the measurand: a gain without a prior.
const QUANTITIES: [Pick; 8] = [
    |n| &mut n.reference.sensitivity_v_per_ms2,
    |n| &mut n.exciter.moving_mass_kg,
    |n| &mut n.exciter.stiffness_n_per_m,
    |n| &mut n.exciter.damping_ns_per_m,
    |n| &mut n.exciter.force_factor_n_per_a,
    |n| &mut n.exciter.coil_resistance_ohm,
    |n| &mut n.exciter.coil_inductance_h,
    |n| &mut n.digitiser.noise_v,
];

/// A rig without effects, against which rigs with effects of the same seed are held.
pub(super) struct Yardstick<'a> {
    nominal: &'a Nominal,
    design: &'a [Setting],
    options: &'a Options,
    bare: Generated,
    /// Changes by the gains, one column each.
    gains: DMatrix<f64>,
    /// Weights of the priors of all free values: the measurand has none.
    prior: DVector<f64>,
    /// Changes by each free value at the nominal ones.
    columns: OnceCell<DMatrix<f64>>,
}

impl<'a> Yardstick<'a> {
    pub(super) fn new(nominal: &'a Nominal, design: &'a [Setting], options: &'a Options) -> Self {
        let bare = generate(nominal, design, &[], options);
        let gains = gains(nominal, &bare.points);
        let measurand = QUANTITIES.len();
        Self {
            prior: DVector::from_fn(measurand + gains.ncols(), |at, _| {
                f64::from(u8::from(at != measurand))
            }),
            nominal,
            design,
            options,
            bare,
            gains,
            columns: OnceCell::new(),
        }
    }

    /// The points without effects.
    pub(super) fn into_points(self) -> Vec<Point> {
        self.bare.points
    }

    /// Size of the gap of `points`, in standard uncertainties of the whole dataset.
    pub(super) fn sigma(&self, points: &[Point]) -> f64 {
        let gap = differences(&self.bare.points, points);
        let shown = DVector::from_iterator(
            gap.len() * Observable::ALL.len(),
            gap.iter()
                .flat_map(Table::iter)
                .map(|(_, v)| f64::from(u8::from(v.is_some()))),
        );
        let gap = vector(&gap);
        if gap.norm() < NOTHING {
            return gap.norm();
        }
        let mut values = DVector::zeros(self.prior.len());
        let mut left = gap.clone();
        let mut least = left.norm_squared();
        for step in 0..STEPS {
            let columns = match step {
                0 => self.columns.get_or_init(|| self.changes(&values)).clone(),
                _ => self.changes(&values),
            };
            let Some(better) = self.step(&gap, &shown, columns, &values, &left, least) else {
                break;
            };
            let gained = least - better.2;
            (values, left, least) = better;
            if gained < WORTH * least {
                break;
            }
        }
        least.sqrt()
    }

    /// One step that lowers the sum of squares: values, what they leave, and the sum.
    fn step(
        &self,
        gap: &DVector<f64>,
        shown: &DVector<f64>,
        mut columns: DMatrix<f64>,
        values: &DVector<f64>,
        left: &DVector<f64>,
        least: f64,
    ) -> Option<(DVector<f64>, DVector<f64>, f64)> {
        columns
            .column_iter_mut()
            .for_each(|mut column| column.component_mul_assign(shown));
        let mut normal = columns.tr_mul(&columns);
        normal.set_diagonal(&(normal.diagonal() + &self.prior));
        let slope = columns.tr_mul(left) - values.component_mul(&self.prior);
        // Note: the measurand shows in the ratio, which every row has; all others have a prior.
        let mut step = normal.cholesky()?.solve(&slope);
        for _ in 0..=HALVINGS {
            let mut there = values + &step;
            for value in there.iter_mut().take(QUANTITIES.len()) {
                *value = value.clamp(-FARTHEST_U, FARTHEST_U);
            }
            let left = (gap - self.moved(&there)).component_mul(shown);
            let square = left.norm_squared() + there.component_mul(&there).dot(&self.prior);
            if square < least {
                return Some((there, left, square));
            }
            step *= 0.5;
        }
        None
    }

    /// Change by all free values together.
    fn moved(&self, values: &DVector<f64>) -> DVector<f64> {
        let points = generate(&self.at(values), self.design, &[], self.options).points;
        let change = vector(&differences(&self.bare.points, &points));
        // Gains are linear in the logarithms.
        let gains = values.rows(QUANTITIES.len(), self.gains.ncols());
        change + &self.gains * gains
    }

    /// The rig with its nominal values moved.
    fn at(&self, values: &DVector<f64>) -> Nominal {
        let mut nominal = self.nominal.clone();
        for (pick, value) in QUANTITIES.iter().zip(values.iter()) {
            let quantity = pick(&mut nominal);
            quantity.value += value * quantity.u;
        }
        nominal
    }

    /// Change by one unit of each free value, from `values` on: each quantity by its standard
    /// uncertainty, then the gains.
    fn changes(&self, values: &DVector<f64>) -> DMatrix<f64> {
        let here = self.moved(values);
        let quantities = (0..QUANTITIES.len()).map(|at| {
            let mut there = values.clone();
            there[at] += SMALL;
            (self.moved(&there) - &here) / SMALL
        });
        let gains = self.gains.column_iter().map(|column| column.into_owned());
        DMatrix::from_columns(&quantities.chain(gains).collect::<Vec<_>>())
    }
}

/// The measurand by one per cent, and the gains of both channels in each run by their repeatability.
fn gains(nominal: &Nominal, points: &[Point]) -> DMatrix<f64> {
    let repeatability = &nominal.repeatability;
    let runs = (0..points.iter().map(|p| p.run + 1).max().unwrap_or(0)).flat_map(|run| {
        let (dut, reference) = (repeatability.dut_gain, repeatability.reference_gain);
        [
            gain(points, Some(run), dut, 0.0),
            gain(points, Some(run), -reference, reference),
        ]
    });
    let measurand = std::iter::once(gain(points, None, 0.01, 0.0));
    DMatrix::from_columns(&measurand.chain(runs).collect::<Vec<_>>())
}

/// Effect of relative changes of ratio and drive in a run, or in all.
fn gain(points: &[Point], run: Option<usize>, ratio: f64, drive: f64) -> DVector<f64> {
    let row = |point: &Point| {
        let mut values = Table::filled(None);
        if run.is_none_or(|run| point.run == run) {
            values[Observable::Ratio] = point.u_ratio.map(|u| ratio / u);
            values[Observable::Drive] = point.u_drive.map(|u| drive / u);
        }
        values
    };
    vector(&points.iter().map(row).collect::<Vec<_>>())
}

/// All values one below the other; zero where there is none.
fn vector(rows: &[Table<Option<f64>>]) -> DVector<f64> {
    let values = rows.iter().flat_map(Table::iter);
    let values = values.map(|(_, value)| value.unwrap_or(0.0));
    DVector::from_iterator(rows.len() * Observable::ALL.len(), values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use calib_twin::dataset::standard_design;
    use calib_twin::effects::{ActiveEffect, CalibratorAction};

    fn size(text: &str) -> (f64, f64) {
        let nominal = Nominal::standard();
        let design = standard_design(&nominal);
        let options = Options::default();
        let yardstick = Yardstick::new(&nominal, &design, &options);
        let effect = text
            .parse::<ActiveEffect<CalibratorAction>>()
            .expect("an effect");
        let points = generate(&nominal, &design, &[effect], &options).points;
        let raw = vector(&differences(&yardstick.bare.points, &points)).norm();
        (raw, yardstick.sigma(&points))
    }

    /// Damping off by two of its standard uncertainties changes the drive by thousands of sigma, and
    /// is worth the two: with the prior the least sum of squares is just below 2^2, found to 1 %. Four of them
    /// are worth four at most, however much they change.
    #[test]
    fn what_a_nominal_value_can_be_is_no_gap() {
        let (raw, sigma) = size("mechanical_damping=added_damping_ns_per_m:1.2");
        assert!(raw > 500.0, "{raw}");
        assert!((1.9..2.01).contains(&sigma), "{sigma}");
        let (raw, sigma) = size("mechanical_damping=added_damping_ns_per_m:-2.4");
        assert!(
            raw > 1000.0 && (2.0..4.02).contains(&sigma),
            "{raw} {sigma}"
        );
    }

    /// A gain is the measurand, whatever its size.
    #[test]
    fn the_measurand_is_no_gap() {
        let (raw, sigma) = size("dut_gain=gain:0.05");
        assert!(raw > 1000.0 && sigma < 1.0, "{raw} {sigma}");
    }

    /// A resonance bends the course over frequency, which no nominal value does: next to all stays.
    #[test]
    fn what_no_nominal_value_does_keeps_its_size() {
        let (raw, sigma) = size("dut_resonance=resonance_hz:30000,quality:25");
        assert!(sigma <= raw && sigma > 0.5 * raw, "{raw} {sigma}");
    }

    /// Rows that a clipped amplifier cannot hold are left out, and those that are left have the same
    /// noise as without: above their peaks there is nothing to be seen.
    #[test]
    fn rows_left_out_are_no_gap() {
        let (raw, _) = size("amplifier_clipping=threshold_v:11.652580477257448");
        assert!(raw < 1e-6, "{raw}");
    }
}
