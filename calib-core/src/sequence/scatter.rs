//! Mean and scatter of complex ratios over repeated blocks.

use num_complex::Complex32;

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
    /// `s^2 = (sum d^2 - n mean(d)^2) / (n (n - 1))` (GUM 4.2.3).
    pub fn standard_deviations_of_mean(&self) -> (f32, f32) {
        if self.count < 2 {
            return (0.0, 0.0);
        }
        let n = f32::from(self.count);
        let of = |squares: f32, sum: f32| {
            let spread = (squares - sum * sum / n).max(0.0);
            libm::sqrtf(spread / (n * (n - 1.0)))
        };
        (
            of(self.squares[0], self.sum.re),
            of(self.squares[1], self.sum.im),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
