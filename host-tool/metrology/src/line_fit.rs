//! The straight line through points, with its uncertainty.
//!
//! # Source
//! GUM H.3 (equal weights, uncertainty from the residuals); ISO/TS 28037
//! clause 6 (known uncertainties of the ordinates).

use serde::Serialize;

/// `y = intercept + slope (x - origin)` with covariance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Line {
    /// Value at the origin.
    pub intercept: f64,
    /// Slope.
    pub slope: f64,
    /// Standard uncertainty of the intercept.
    pub u_intercept: f64,
    /// Standard uncertainty of the slope.
    pub u_slope: f64,
    /// Covariance of intercept and slope.
    pub covariance: f64,
    /// Abscissa of the intercept.
    pub origin: f64,
    /// Chi-squared (known uncertainties) or residual sum of squares.
    pub chi2: f64,
    /// Degrees of freedom, n - 2.
    pub degrees_of_freedom: usize,
}

impl Line {
    /// Fits points with known standard uncertainties `u`, or with equal
    /// unknown ones, found from the residuals.
    ///
    /// `None` for fewer than three points (two with known uncertainties),
    /// slices of different length, or abscissae that are all equal.
    pub fn fit(x: &[f64], y: &[f64], u: Option<&[f64]>, origin: f64) -> Option<Self> {
        let fewest = if u.is_some() { 2 } else { 3 };
        if x.len() < fewest || x.len() != y.len() || u.is_some_and(|u| u.len() != x.len()) {
            return None;
        }
        let weight = |index: usize| u.map_or(1.0, |u| 1.0 / (u[index] * u[index]));
        let sum = |f: &dyn Fn(usize) -> f64| (0..x.len()).map(|n| weight(n) * f(n)).sum::<f64>();
        let total = sum(&|_| 1.0);
        let (mx, my) = (sum(&|n| x[n]) / total, sum(&|n| y[n]) / total);
        let sxx = sum(&|n| (x[n] - mx).powi(2));
        if sxx <= 0.0 {
            return None;
        }
        let slope = sum(&|n| (x[n] - mx) * (y[n] - my)) / sxx;
        let chi2 = sum(&|n| (y[n] - my - slope * (x[n] - mx)).powi(2));
        let degrees_of_freedom = x.len() - 2;
        let variance = match u {
            Some(_) => 1.0,
            None => chi2 / degrees_of_freedom as f64,
        };
        let lever = origin - mx;
        Some(Self {
            intercept: my + slope * lever,
            slope,
            u_intercept: (variance * (1.0 / total + lever * lever / sxx)).sqrt(),
            u_slope: (variance / sxx).sqrt(),
            covariance: variance * lever / sxx,
            origin,
            chi2,
            degrees_of_freedom,
        })
    }

    /// Value at `x` with its standard uncertainty.
    pub fn at(&self, x: f64) -> (f64, f64) {
        let d = x - self.origin;
        let variance =
            self.u_intercept.powi(2) + d * d * self.u_slope.powi(2) + 2.0 * d * self.covariance;
        (self.intercept + self.slope * d, variance.max(0.0).sqrt())
    }

    /// Abscissa of a measured `y` with standard uncertainty `u`, with its own.
    pub fn inverse(&self, y: f64, u: f64) -> (f64, f64) {
        let x = self.origin + (y - self.intercept) / self.slope;
        let (_, u_line) = self.at(x);
        (x, u_line.hypot(u) / self.slope.abs())
    }

    /// Correlation coefficient of intercept and slope.
    pub fn correlation(&self) -> f64 {
        self.covariance / (self.u_intercept * self.u_slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gum_h3_thermometer() {
        // Table H.6: readings and corrections, reference temperature 20.
        let t = [
            21.521, 22.012, 22.512, 23.003, 23.507, 23.999, 24.513, 25.002, 25.503, 26.010, 26.511,
        ];
        let b = [
            -0.171, -0.169, -0.166, -0.159, -0.164, -0.165, -0.156, -0.157, -0.159, -0.161, -0.160,
        ];
        let line = Line::fit(&t, &b, None, 20.0).expect("line");
        let near = |value: f64, expected: f64| (value / expected - 1.0).abs() < 2e-8;
        assert!(near(line.intercept, -0.171_203_790), "{line:?}");
        assert!(near(line.u_intercept, 0.002_877_597_8));
        assert!(near(line.slope, 0.002_182_697_7), "{line:?}");
        assert!(near(line.u_slope, 0.000_667_938_766));
        assert!(near(line.correlation(), -0.930_429_603));
        let (value, u) = line.at(30.0);
        assert!(
            near(value, -0.149_376_813) && near(u, 0.004_138_595_8),
            "{value} {u}"
        );
        assert_eq!(line.degrees_of_freedom, 9);
    }

    #[test]
    fn iso_ts_28037_wls1() {
        let x = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let y = [3.3, 5.6, 7.1, 9.3, 10.7, 12.1];
        let line = Line::fit(&x, &y, Some(&[0.5; 6]), 0.0).expect("line");
        assert!((line.intercept - 1.866_667).abs() < 5e-7);
        assert!((line.slope - 1.757_143).abs() < 5e-7);
        assert!((line.u_intercept - 0.465_474_7).abs() < 5e-8);
        assert!((line.u_slope - 0.119_522_9).abs() < 5e-8);
        assert!((line.covariance + 0.050).abs() < 5e-4);
        assert!((line.chi2 - 1.665).abs() < 5e-4);
        let (x, u) = line.inverse(10.5, 0.5);
        assert!((x - 4.913).abs() < 5e-4 && (u - 0.322).abs() < 5e-4);
    }
}
