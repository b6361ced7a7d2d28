//! What came of the points of a stratum.

use serde::Serialize;

/// What became of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// Passed: error over U of magnitude and phase, and U of the magnitude.
    Stated {
        /// Of the magnitude.
        magnitude: f64,
        /// Of the phase.
        phase: f64,
        /// Expanded uncertainty of the magnitude, relative.
        expanded_rel: f64,
        /// The certificate warns of what went wrong.
        told: bool,
    },
    /// Refused, or never begun.
    Refused,
}

/// Counts of one effect in one band; a draw has one point in it.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Tally {
    /// Points.
    pub points: u32,
    /// Passed, and the truth within U of magnitude and phase.
    pub right: u32,
    /// Refused.
    pub refused: u32,
    /// Beyond U, and the certificate warns of what went wrong.
    pub told: u32,
    /// The certificate warns.
    pub warned: u32,
    /// Passed, and the magnitude beyond U.
    pub wrong_magnitude: u32,
    /// Passed, and the phase beyond U.
    pub wrong_phase: u32,
    /// Passed, and magnitude or phase beyond 2 U.
    pub beyond_2_u: u32,
    /// Largest error over U of a point that passed, magnitude.
    pub worst_magnitude: f64,
    /// The same of the phase.
    pub worst_phase: f64,
    /// Sum of U of the magnitude over the points that passed.
    pub expanded_sum_rel: f64,
}

impl Tally {
    /// Counts a point.
    pub fn add(&mut self, fate: Fate) {
        self.points += 1;
        let Fate::Stated {
            magnitude,
            phase,
            expanded_rel,
            told,
        } = fate
        else {
            self.refused += 1;
            return;
        };
        // Written so that what is not a number is wrong.
        let wrong = |error: f64| u32::from(error.is_nan() || error > 1.0);
        self.warned += u32::from(told);
        self.expanded_sum_rel += expanded_rel;
        let [by_magnitude, by_phase] = [wrong(magnitude), wrong(phase)];
        if told && by_magnitude.max(by_phase) > 0 {
            self.told += 1;
            return;
        }
        self.wrong_magnitude += by_magnitude;
        self.wrong_phase += by_phase;
        self.right += 1 - by_magnitude.max(by_phase);
        self.beyond_2_u += wrong(0.5 * magnitude).max(wrong(0.5 * phase));
        self.worst_magnitude = self.worst_magnitude.max(magnitude);
        self.worst_phase = self.worst_phase.max(phase);
    }

    /// Adds the counts of another.
    pub fn merge(&mut self, other: &Self) {
        self.points += other.points;
        self.right += other.right;
        self.refused += other.refused;
        self.told += other.told;
        self.warned += other.warned;
        self.wrong_magnitude += other.wrong_magnitude;
        self.wrong_phase += other.wrong_phase;
        self.beyond_2_u += other.beyond_2_u;
        self.worst_magnitude = self.worst_magnitude.max(other.worst_magnitude);
        self.worst_phase = self.worst_phase.max(other.worst_phase);
        self.expanded_sum_rel += other.expanded_sum_rel;
    }

    /// Share in percent of all points.
    pub fn percent(&self, count: u32) -> f64 {
        100.0 * f64::from(count) / f64::from(self.points.max(1))
    }

    /// Mean U of the points that passed, percent.
    pub fn mean_expanded_percent(&self) -> f64 {
        100.0 * self.expanded_sum_rel / f64::from((self.points - self.refused).max(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_is_right_refused_or_wrong_and_no_number_is_wrong() {
        let mut tally = Tally::default();
        let stated = |magnitude, phase| Fate::Stated {
            magnitude,
            phase,
            expanded_rel: 0.01,
            told: false,
        };
        let warned = Fate::Stated {
            magnitude: 1.5,
            phase: 0.0,
            expanded_rel: 0.01,
            told: true,
        };
        for fate in [
            stated(0.9, 1.0),
            stated(1.1, 0.2),
            stated(0.1, 2.1),
            stated(f64::NAN, 0.0),
            Fate::Refused,
            warned,
        ] {
            tally.add(fate);
        }
        let counts = [tally.points, tally.right, tally.refused, tally.beyond_2_u];
        assert_eq!(counts[..3], [6, 1, 1]);
        assert_eq!([tally.told, tally.warned], [1, 1]);
        assert_eq!([tally.wrong_magnitude, tally.wrong_phase], [2, 1]);
        assert_eq!(tally.mean_expanded_percent(), 1.0);
    }
}
