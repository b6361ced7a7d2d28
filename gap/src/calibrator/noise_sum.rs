//! Sums over the noise columns of one channel.

/// Sums over the noise of one channel, from which its healthy noise is fitted.
#[derive(Clone, Copy, Default)]
pub(super) struct NoiseSum {
    square: f64,
    mixed: f64,
    share: f64,
    widened: f64,
}

impl NoiseSum {
    /// One more datum.
    pub(super) fn add(&mut self, difference: f64, share: f64, weight: f64, open: f64) {
        let ratio = 1.0 + open * weight * weight;
        let w2 = weight * weight / ratio;
        self.square += difference * difference * w2;
        self.mixed += difference * share * w2;
        self.share += share * share * w2;
        self.widened += ratio.ln();
    }

    /// Least sum of squares over the healthy noise with its prior of one unit.
    pub(super) fn least(&self, unit: f64) -> f64 {
        self.square + self.widened - (unit * self.mixed).powi(2) / (1.0 + unit * unit * self.share)
    }
}
