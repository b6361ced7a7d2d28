//! Weighted linear least squares on the inverse response.

use super::advice;
use super::identification::{Deviation, Estimator, Identification, Weighting};
use super::points::{Point, Points};
use crate::oscillator::Oscillator;
use crate::statistics;
use calib_files::{Error, Result};
use nalgebra::{Matrix2, Matrix2x3, Matrix3, Vector2, Vector3};
use std::f64::consts::TAU;

/// Identifies the model.
///
/// `p` is the significance of the chi-squared test, at most 0.05 (8.5.1).
///
/// # Errors
/// Points no mass-spring-damper belongs to.
///
/// # Accuracy
/// Test `the_ptb_accelerometer_is_identified_and_rejected`.
///
/// # Source
/// ISO 16063-43 (7) to (16), (37), (38).
pub fn identify(points: &Points, weighting: Weighting, p: f64) -> Result<Identification> {
    let fit = Fit::new(points, weighting).ok_or_else(|| no_resonance(points))?;
    let mut result = fit.interpret(points)?;
    if weighting == Weighting::Covariance {
        let degrees_of_freedom = fit.degrees_of_freedom as f64;
        let limit = statistics::chi_squared_quantile(1.0 - p / 2.0, degrees_of_freedom);
        let p_value = statistics::chi_squared_survival(fit.chi2, degrees_of_freedom);
        result.chi2 = Some(fit.chi2);
        result.chi2_limit = Some(limit);
        result.p_value = Some(p_value);
        result.consistent = Some(fit.chi2 <= limit);
    }
    result.weighting = weighting;
    result.warnings = advice::advise(points, &result);
    Ok(result)
}

/// The weighted least squares, solved.
struct Fit {
    rows: Vec<Equation>,
    /// From scaled parameters to mu.
    unit: Matrix3<f64>,
    /// Inverse of the normal matrix, scaled.
    inverse: Matrix3<f64>,
    /// The solution, scaled.
    scaled: Vector3<f64>,
    /// Variance of an equation of weight one.
    variance: f64,
    chi2: f64,
    degrees_of_freedom: usize,
}

impl Fit {
    /// `None` when the equations have no solution.
    fn new(points: &Points, weighting: Weighting) -> Option<Self> {
        // mu in units of the mean frequency keeps the normal matrix well scaled.
        let frequencies = points.points.iter().map(|point| point.frequency_hz);
        let scale = TAU * frequencies.sum::<f64>() / points.points.len() as f64;
        let equation = |point| Equation::new(point, scale, weighting);
        let rows: Vec<Equation> = points.points.iter().map(equation).collect();
        let normal: Matrix3<f64> = rows.iter().map(Equation::normal).sum();
        let inverse = normal.try_inverse()?;
        let right: Vector3<f64> = rows.iter().map(Equation::right).sum();
        let scaled = inverse * right;
        let chi2 = rows.iter().map(|row| row.chi2(&scaled)).sum();
        let degrees_of_freedom = 2 * rows.len() - 3;
        Some(Self {
            rows,
            unit: Matrix3::from_diagonal(&Vector3::new(1.0, 1.0 / scale, 1.0 / (scale * scale))),
            inverse,
            scaled,
            // Without uncertainties the residuals stand in for them.
            variance: match weighting {
                Weighting::Covariance => 1.0,
                Weighting::None => chi2 / degrees_of_freedom as f64,
            },
            chi2,
            degrees_of_freedom,
        })
    }

    /// Parameters of the oscillator from the solution.
    fn interpret(&self, points: &Points) -> Result<Identification> {
        let Self { unit, inverse, .. } = self;
        let block = |row: &Equation| unit * inverse * row.design.transpose() * row.weight;
        let blocks = self.rows.iter().map(block).collect();
        let mu = unit * self.scaled;
        let covariance = unit * inverse * unit * self.variance;
        let oscillator = Oscillator::from_inverse(&mu).ok_or_else(|| no_resonance(points))?;
        let estimator = Estimator { blocks };
        Ok(assemble(points, oscillator, &mu, &covariance, estimator))
    }
}

/// Real and imaginary part of one inverse response.
struct Equation {
    y: Vector2<f64>,
    design: Matrix2x3<f64>,
    weight: Matrix2<f64>,
}

impl Equation {
    fn new(point: &Point, scale: f64, weighting: Weighting) -> Self {
        let omega = TAU * point.frequency_hz / scale;
        Self {
            y: inverse_response(point.magnitude, point.phase_rad),
            design: Matrix2x3::new(1.0, 0.0, -omega * omega, 0.0, omega, 0.0),
            weight: match weighting {
                Weighting::Covariance => precision(point),
                Weighting::None => Matrix2::identity(),
            },
        }
    }

    /// Its part of the normal matrix.
    fn normal(&self) -> Matrix3<f64> {
        self.design.transpose() * self.weight * self.design
    }

    /// Its part of the right side.
    fn right(&self) -> Vector3<f64> {
        self.design.transpose() * self.weight * self.y
    }

    /// Its part of the weighted sum of squares at these parameters.
    fn chi2(&self, parameters: &Vector3<f64>) -> f64 {
        let residual = self.y - self.design * parameters;
        residual.dot(&(self.weight * residual))
    }
}

/// `1 / (S e^{i phi})` as (R, J) of (6).
pub(super) fn inverse_response(magnitude: f64, phase_rad: f64) -> Vector2<f64> {
    Vector2::new(phase_rad.cos(), -phase_rad.sin()) / magnitude
}

/// Inverse of the covariance (7): along the response `S^2/u(S)` to the second,
/// across it `S/u(phi)` to the second.
fn precision(point: &Point) -> Matrix2<f64> {
    let along = inverse_response(1.0, point.phase_rad);
    let across = Vector2::new(-along[1], along[0]);
    let s = point.magnitude;
    let weight_along = (s * s / point.u_magnitude).powi(2);
    let weight_across = (s / point.u_phase_rad).powi(2);
    along * along.transpose() * weight_along + across * across.transpose() * weight_across
}

fn assemble(
    points: &Points,
    oscillator: Oscillator,
    mu: &Vector3<f64>,
    covariance_mu: &Matrix3<f64>,
    estimator: Estimator,
) -> Identification {
    let jacobian = Oscillator::inverse_jacobian(mu);
    let covariance = jacobian * covariance_mu * jacobian.transpose();
    let u = |index: usize| covariance[(index, index)].max(0.0).sqrt();
    let correlation = std::array::from_fn(|row| {
        std::array::from_fn(|column| covariance[(row, column)] / (u(row) * u(column)))
    });
    Identification {
        oscillator,
        rho: oscillator.rho(),
        u_s0: u(0),
        u_f0_hz: u(1),
        u_delta: u(2),
        u_rho: covariance_mu[(2, 2)].max(0.0).sqrt() / (mu[2] * mu[2]),
        correlation,
        weighting: Weighting::None,
        frequencies: points.points.len(),
        chi2: None,
        degrees_of_freedom: 2 * points.points.len() - 3,
        chi2_limit: None,
        p_value: None,
        consistent: None,
        deviation: deviation(points, &oscillator),
        warnings: Vec::new(),
        estimator,
    }
}

fn deviation(points: &Points, oscillator: &Oscillator) -> Deviation {
    let (mut magnitude, mut phase) = (Vec::new(), Vec::new());
    for point in &points.points {
        let (magnitude_rel, phase_rad) = distance(point, oscillator);
        magnitude.push(magnitude_rel);
        phase.push(phase_rad.to_degrees());
    }
    let rms = |values: &[f64]| {
        (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
    };
    let largest = |values: &[f64]| {
        values
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    Deviation {
        magnitude_rms_rel: rms(&magnitude),
        magnitude_max_rel: largest(&magnitude),
        phase_rms_deg: rms(&phase),
        phase_max_deg: largest(&phase),
    }
}

/// Relative deviation of the magnitude and deviation of the phase, rad, of a
/// point from the model.
pub(super) fn distance(point: &Point, oscillator: &Oscillator) -> (f64, f64) {
    let model = oscillator.response(point.frequency_hz);
    let turn = (point.phase_rad - model.arg()) / TAU;
    (
        point.magnitude / model.norm() - 1.0,
        (turn - turn.round()) * TAU,
    )
}

fn no_resonance(points: &Points) -> Error {
    let inverted = points
        .points
        .iter()
        .filter(|point| point.phase_rad.cos() < 0.0)
        .count()
        * 2
        > points.points.len();
    let hint = match inverted {
        true => {
            "the phase is near 180 degrees: the transducer is inverted (ISO 16063-21 \
             Annex B); state its polarity and remove the 180 degrees from the phase"
        }
        false => {
            "the sensitivity must rise towards a resonance; measure closer to it, and \
             check that the phase column has the stated unit"
        }
    };
    Error::input(
        "points",
        "no mass-spring-damper model fits: the response has no resonance above the data",
        hint,
    )
}
