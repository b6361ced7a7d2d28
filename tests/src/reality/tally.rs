//! Outcomes of the points of a stratum.

use serde::Serialize;

/// Outcome of a point.
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
        /// Standard uncertainty of what every draw has and of what the record shows, relative.
        known_rel: f64,
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
    /// Largest error over U of a point that passed, phase.
    pub worst_phase: f64,
    /// Sum of U of the magnitude over the points that passed.
    pub expanded_sum_rel: f64,
    /// Sum of the squares of the errors of the magnitude.
    pub error_squares_rel: f64,
    /// Sum of the squares of what an informed budget has without the effect.
    pub known_squares_rel: f64,
}

impl Tally {
    /// Counts a point.
    pub fn add(&mut self, fate: Fate) {
        self.points += 1;
        let Fate::Stated {
            magnitude,
            phase,
            expanded_rel,
            known_rel,
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
        let error_rel = magnitude * expanded_rel;
        if error_rel.is_finite() {
            self.error_squares_rel += error_rel * error_rel;
        }
        self.known_squares_rel += known_rel * known_rel;
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
        self.error_squares_rel += other.error_squares_rel;
        self.known_squares_rel += other.known_squares_rel;
    }

    /// Share in percent of all points.
    pub fn percent(&self, count: u32) -> f64 {
        100.0 * f64::from(count) / f64::from(self.points.max(1))
    }

    /// Mean U of the points that passed, percent.
    pub fn mean_expanded_percent(&self) -> f64 {
        100.0 * self.expanded_sum_rel / self.stated()
    }

    /// U (k = 2) of an informed budget, percent: what every draw has by its distribution, what the record shows by its
    /// value, and the effect by the mean square of what it does in these points.
    pub fn informed_percent(&self) -> f64 {
        let squares = self.error_squares_rel.max(self.known_squares_rel);
        200.0 * (squares / self.stated()).sqrt()
    }

    /// Points that passed, at least 1.
    fn stated(&self) -> f64 {
        f64::from((self.points - self.refused).max(1))
    }

    /// Passed and beyond U of magnitude or phase, untold.
    pub fn wrong(&self) -> u32 {
        self.points - self.right - self.refused - self.told
    }
}

/// Mean U over that of an informed budget: band by band, since a budget knows the frequency.
pub fn over_informed(bands: &[Tally]) -> f64 {
    let weighted = |of: fn(&Tally) -> f64| -> f64 {
        let bands = bands.iter().filter(|band| band.points > band.refused);
        bands.map(|band| of(band) * band.stated()).sum()
    };
    weighted(Tally::mean_expanded_percent) / weighted(Tally::informed_percent)
}

/// Runs of `runs` that may be wrong where U holds in 95.45 %: of 200 strata one has more by an accident of 1 in 100.
///
/// # Equation
/// The smallest `k` with `P(X > k) <= 5e-5`, `X` binomial with 0.0455; 73 of 1 000, 7.3 %.
pub fn most_by_chance(runs: u32) -> u32 {
    const WRONG: f64 = 0.0455;
    let mut at_k = (1.0 - WRONG).powi(runs as i32);
    let mut up_to_k = at_k;
    let mut k = 0;
    while 1.0 - up_to_k > 5.0e-5 && k < runs {
        at_k *= f64::from(runs - k) / f64::from(k + 1) * WRONG / (1.0 - WRONG);
        up_to_k += at_k;
        k += 1;
    }
    k
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
            known_rel: 0.004,
            told: false,
        };
        let warned = Fate::Stated {
            magnitude: 1.5,
            phase: 0.0,
            expanded_rel: 0.01,
            known_rel: 0.004,
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
        assert_eq!(tally.wrong(), 3);
        // Errors of 0.9, 1.1, 0.1 and 1.5 %, and one that is no number: five points.
        let squares: f64 = [0.9_f64, 1.1, 0.1, 1.5].map(|e| e * e).iter().sum();
        assert!((tally.informed_percent() - 2.0 * (squares / 5.0).sqrt()).abs() < 1e-9);
    }

    #[test]
    fn of_1000_runs_73_may_be_wrong_by_chance() {
        assert_eq!(most_by_chance(1000), 73);
        // By hand: P(X > 4) of ten is 252 * 0.0455^5 and less = 4e-5, P(X > 3) = 210 * 0.0455^4 * 0.76 = 7e-4.
        assert_eq!(most_by_chance(10), 4);
    }

    #[test]
    fn an_informed_budget_never_knows_less_than_what_every_draw_has() {
        let mut tally = Tally::default();
        tally.add(Fate::Stated {
            magnitude: 0.01,
            phase: 0.0,
            expanded_rel: 0.02,
            known_rel: 0.005,
            told: false,
        });
        assert!((tally.informed_percent() - 1.0).abs() < 1e-9);
    }
}
