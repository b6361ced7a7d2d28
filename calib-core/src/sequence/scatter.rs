//! Mean and scatter of complex ratios over repeated blocks.

use num_complex::Complex32;

/// Largest correlation that is made up for: the scatter then counts 4.4 times.
const MOST_CORRELATED: f32 = 0.9;
/// Correlation of neighbours that chance exceeds once in 20, times the root of their number.
const CHANCE: f32 = 1.645;

/// Streaming mean and experimental standard deviations of a complex ratio.
///
/// The ratios of one point differ by parts in a thousand. They are taken
/// relative to the first one, so that sums of squares of small differences are
/// formed instead of small differences of large squares.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scatter {
    first: Complex32,
    count: u16,
    /// Sum of `ratio / first - 1`.
    sum: Complex32,
    /// Sums of its squared real and imaginary part.
    squares: [f32; 2],
    /// Sums of the products with the one before.
    products: [f32; 2],
    /// The last of it.
    last: Complex32,
    /// Complex parameters that were fitted to the ratios beside their mean.
    fitted: u16,
    /// Bound of the standard deviations from below.
    least: f32,
}

impl Scatter {
    /// Adds the ratio of one block. Ratios that are zero or not finite are left
    /// out: the sequencer refuses such blocks before.
    pub fn add(&mut self, ratio: Complex32) {
        if !(ratio.norm_sqr() > 0.0 && ratio.is_finite()) {
            return;
        }
        if self.count == 0 {
            self.first = ratio;
        }
        let difference = ratio / self.first - Complex32::new(1.0, 0.0);
        self.count += 1;
        self.sum += difference;
        self.squares[0] += difference.re * difference.re;
        self.squares[1] += difference.im * difference.im;
        self.products[0] += difference.re * self.last.re;
        self.products[1] += difference.im * self.last.im;
        self.last = difference;
    }

    /// States how many complex parameters were fitted beside the mean. The scatter of the ratios loses as many
    /// degrees of freedom.
    pub fn fit_took(&mut self, parameters: usize) {
        self.fitted = parameters as u16;
    }

    /// Standard deviations of the mean are no smaller than this, relative and rad.
    pub fn at_least(&mut self, deviation: f32) {
        self.least = deviation;
    }

    /// Ratios added.
    pub fn count(&self) -> u16 {
        self.count
    }

    /// Mean ratio; zero before the first.
    pub fn mean(&self) -> Complex32 {
        if self.count == 0 {
            return Complex32::new(0.0, 0.0);
        }
        let mean = self.sum / f32::from(self.count);
        self.first * (mean + Complex32::new(1.0, 0.0))
    }

    /// Experimental standard deviations of the mean: of the magnitude,
    /// relative, and of the phase, rad. Zero for fewer than two ratios.
    ///
    /// # Equation
    /// With `d = ratio / first - 1`, to first order `Re d` is the relative
    /// deviation of the magnitude and `Im d` that of the phase;
    /// `s^2 = (sum d^2 - n mean(d)^2) / (n (n - 1 - p))` with `p` parameters fitted beside the mean
    /// (GUM 4.2.3). Where neighbours are correlated beyond chance, by `r`, the mean scatters more than
    /// that: `(1 + r) / (1 - r)` times the variance, as of a first-order autoregression.
    pub fn standard_deviations_of_mean(&self) -> (f32, f32) {
        if self.count < 2 {
            return (0.0, 0.0);
        }
        let n = f32::from(self.count);
        let free = f32::from(self.count.saturating_sub(1 + self.fitted).max(1));
        let of = |squares: f32, products: f32, sum: f32, last: f32| {
            let spread = (squares - sum * sum / n).max(0.0);
            // The first difference is zero.
            let ends = 2.0 * sum - last;
            let together = products - sum / n * ends + (n - 1.0) * (sum / n) * (sum / n);
            let deviation = libm::sqrtf(spread / (n * free) * of_correlated(together / spread, n));
            deviation.max(self.least)
        };
        let [[re, im], [re_products, im_products]] = [self.squares, self.products];
        (
            of(re, re_products, self.sum.re, self.last.re),
            of(im, im_products, self.sum.im, self.last.im),
        )
    }
}

/// Factor of the variance of a mean of `n` whose neighbours have this correlation; 1 if chance may have
/// made it.
fn of_correlated(correlation: f32, n: f32) -> f32 {
    if correlation > CHANCE / libm::sqrtf(n) {
        let r = correlation.min(MOST_CORRELATED);
        (1.0 + r) / (1.0 - r)
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A slow beat through a quarter of its cycle: 20 blocks that rise and stay correlated, r about 0.85 by an
    /// f64 calculation, so that s of the mean is (1.85 / 0.15)^1/2 = 3.5 times that of independent blocks.
    #[test]
    fn correlated_blocks_scatter_more_than_they_seem_to() {
        let value = |i: u32| 1.0e-3 * (f64::from(i) / 20.0 * 1.6).sin();
        let values: Vec<f64> = (0..20).map(value).collect();
        let mean = values.iter().sum::<f64>() / 20.0;
        let spread: f64 = values.iter().map(|v| (v - mean).powi(2)).sum();
        let together: f64 = values
            .windows(2)
            .map(|w| (w[0] - mean) * (w[1] - mean))
            .sum();
        let r = together / spread;
        let expected = (spread / (20.0 * 19.0) * (1.0 + r) / (1.0 - r)).sqrt();
        let mut scatter = Scatter::default();
        for value in values {
            scatter.add(Complex32::new(1.0 + value as f32, 0.0));
        }
        let (magnitude, phase) = scatter.standard_deviations_of_mean();
        // f32 keeps 1e-7 of 1 in differences of 1e-3; 1 / (1 - r) is seven times as sensitive.
        assert!(
            (f64::from(magnitude) / expected - 1.0).abs() < 5.0e-3,
            "{r} {magnitude}"
        );
        assert!(r > 0.8 && phase == 0.0);
    }

    #[test]
    fn mean_and_scatter_are_those_of_an_f64_calculation() {
        // Deviations 1e-4 and below about a ratio of arbitrary phase.
        let steps = [0.3, -1.1, 0.7, 0.2, -0.4, 1.3, -0.9, 0.05];
        let centre = Complex32::from_polar(2.5, 2.0);
        let mut scatter = Scatter::default();
        let mut magnitudes = Vec::new();
        let mut phases = Vec::new();
        for (i, step) in steps.iter().enumerate() {
            let magnitude = 1.0 + 1.0e-4 * step;
            let phase = 0.7e-4 * steps[(i + 3) % steps.len()];
            magnitudes.push(f64::from(magnitude));
            phases.push(f64::from(phase));
            scatter.add(centre * Complex32::from_polar(magnitude, phase));
        }
        let deviation = |values: &[f64]| {
            let n = values.len() as f64;
            let mean = values.iter().sum::<f64>() / n;
            let square: f64 = values.iter().map(|v| (v - mean) * (v - mean)).sum();
            (square / (n * (n - 1.0))).sqrt()
        };
        let (magnitude, phase) = scatter.standard_deviations_of_mean();
        // Each ratio carries an f32 rounding of 1e-7 of itself, 1e-3 of the
        // scatter of 1e-4.
        assert!((f64::from(magnitude) / deviation(&magnitudes) - 1.0).abs() < 2.0e-3);
        assert!((f64::from(phase) / deviation(&phases) - 1.0).abs() < 2.0e-3);
        assert_eq!(scatter.count(), 8);
    }

    #[test]
    fn one_block_has_no_scatter_and_none_no_mean() {
        let mut scatter = Scatter::default();
        assert_eq!(scatter.mean(), Complex32::new(0.0, 0.0));
        scatter.add(Complex32::new(0.0, f32::NAN));
        assert_eq!(scatter.count(), 0);
        scatter.add(Complex32::new(0.5, 0.5));
        assert_eq!(scatter.mean(), Complex32::new(0.5, 0.5));
        assert_eq!(scatter.standard_deviations_of_mean(), (0.0, 0.0));
    }
}
