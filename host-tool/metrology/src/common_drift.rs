//! Drift that several check standards show together: that of the reference they are measured with.
//!
//! # Equation
//! `ln S = a_s + b t`, one `a` for each standard and one `b` for all, by least squares:
//! `b = sum (t - t_s)(y - y_s) / sum (t - t_s)^2` with the means of each standard, and N - S - 1 degrees of
//! freedom. The reference's sensitivity drifts by as much the other way.
//!
//! # Source
//! GUM H.3; interval from drift and allowance: ILAC-G24:2022 (OIML D 10), method by the drift of control charts.

use crate::statistics::{mean, student_factor};
use schemars::JsonSchema;
use serde::Serialize;

/// Shortest and longest interval that is advised, years: nobody sends a reference away more often than four times
/// a year, and ISO 16063-21 knows none that is trusted for longer than five.
const INTERVAL_YEARS: (f64, f64) = (0.25, 5.0);
/// Shortest time a standard's results span, years: a month. Seven results of a minute gave 5 000 % a year.
const SHORTEST_YEARS: f64 = 1.0 / 12.0;
/// Coverage of the drift's expanded uncertainty.
const COVERAGE: f64 = 0.9545;

/// Results of one check standard.
pub type Series = Vec<Measured>;

/// A result of a check standard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Time, years from any origin.
    pub years: f64,
    /// Sensitivity, any unit.
    pub sensitivity: f64,
}

/// A drift that is common to all standards.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CommonDrift {
    /// Check standards it was found with.
    pub standards: usize,
    /// Their results.
    pub results: usize,
    /// Relative change in a year.
    pub drift_rel_per_year: f64,
    /// Its expanded uncertainty, 95.45 %.
    #[serde(rename = "expanded_uncertainty_drift_rel_per_year")]
    pub expanded_rel_per_year: f64,
}

/// The common drift of the standards whose results span a month or more; none without one, or with too few results to
/// leave a degree of freedom.
pub fn common_drift(all: &[Series]) -> Option<CommonDrift> {
    let series = || {
        all.iter()
            .filter(|series| span_years(series) >= SHORTEST_YEARS)
    };
    let (standards, results) = (series().count(), series().map(Vec::len).sum::<usize>());
    let degrees_of_freedom = results
        .checked_sub(standards + 1)
        .filter(|left| *left > 0)?;
    let centred: Vec<(f64, f64)> = series().flat_map(|series| centred(series)).collect();
    let square: f64 = centred.iter().map(|(t, _)| t * t).sum();
    if square <= 0.0 {
        return None;
    }
    let slope = centred.iter().map(|(t, y)| t * y).sum::<f64>() / square;
    let residuals: f64 = centred.iter().map(|(t, y)| (y - slope * t).powi(2)).sum();
    let degrees_of_freedom = degrees_of_freedom as f64;
    let u = (residuals / degrees_of_freedom / square).sqrt();
    Some(CommonDrift {
        standards,
        results,
        drift_rel_per_year: slope,
        expanded_rel_per_year: student_factor(COVERAGE, degrees_of_freedom) * u,
    })
}

/// From the first of the results to the last.
fn span_years(series: &[Measured]) -> f64 {
    let years = || series.iter().map(|result| result.years);
    years().fold(f64::NEG_INFINITY, f64::max) - years().fold(f64::INFINITY, f64::min)
}

/// Times and logarithms from their means.
fn centred(series: &[Measured]) -> Vec<(f64, f64)> {
    let of = |value: fn(&Measured) -> f64| series.iter().map(value).collect::<Vec<f64>>();
    let (t, y) = (of(|m| m.years), of(|m| m.sensitivity.ln()));
    let (middle_t, middle_y) = (mean(&t), mean(&y));
    let pairs = t.iter().zip(&y);
    pairs.map(|(t, y)| (t - middle_t, y - middle_y)).collect()
}

impl CommonDrift {
    /// True when it is more than its uncertainty.
    pub fn is_significant(&self) -> bool {
        self.drift_rel_per_year.abs() > self.expanded_rel_per_year
    }

    /// Years in which the drift, at most as large as it may be, uses up what the budget allows for it; at most
    /// five, and at least a quarter.
    pub fn interval_years(&self, allowed_rel: f64) -> f64 {
        let most = self.drift_rel_per_year.abs() + self.expanded_rel_per_year;
        (allowed_rel / most).clamp(INTERVAL_YEARS.0, INTERVAL_YEARS.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_chacha::rand_core::SeedableRng;
    use rand_distr::{Distribution, StandardNormal};

    /// Three standards of other sensitivities measured every month, scattering by 0.05 %.
    fn drawn(seed: u64, drift_rel_per_year: f64) -> Vec<Series> {
        let mut generator = ChaCha8Rng::seed_from_u64(seed);
        let mut scatter = || -> f64 { StandardNormal.sample(&mut generator) };
        let series = |sensitivity: f64, scatter: &mut dyn FnMut() -> f64| {
            let one = |month: u32| {
                let years = f64::from(month) / 12.0;
                let drift = 1.0 + drift_rel_per_year * years;
                Measured {
                    years,
                    sensitivity: sensitivity * drift * (1.0 + 5.0e-4 * scatter()),
                }
            };
            (0..12).map(one).collect()
        };
        [0.01, 0.1, 1.0].map(|s| series(s, &mut scatter)).to_vec()
    }

    #[test]
    fn results_of_a_day_show_no_drift() {
        let mut series = drawn(1, 0.01);
        for result in series.iter_mut().flatten() {
            result.years /= 365.0;
        }
        assert_eq!(common_drift(&series), None);
        assert_eq!(common_drift(&[Vec::new()]), None);
    }

    /// 95.45 % of 1 000, binomial deviation 6.6; five of them.
    #[test]
    fn the_drift_is_within_its_uncertainty_as_often_as_stated() {
        let covered = (0..1000).filter(|seed| {
            let found = common_drift(&drawn(*seed, 0.002)).expect("enough");
            (found.drift_rel_per_year - 0.002).abs() <= found.expanded_rel_per_year
        });
        let covered = covered.count();
        assert!((921..=987).contains(&covered), "{covered}");
    }

    #[test]
    fn a_drift_of_a_third_of_a_percent_a_year_is_found_and_none_is_not() {
        let found = common_drift(&drawn(1, 0.003)).expect("enough");
        assert!(found.is_significant() && found.standards == 3 && found.results == 36);
        assert!(
            !common_drift(&drawn(2, 0.0))
                .expect("enough")
                .is_significant()
        );
        assert_eq!(common_drift(&[vec![]]), None);
        assert_eq!(
            common_drift(
                &drawn(1, 0.0)
                    .iter()
                    .map(|s| s[..1].to_vec())
                    .collect::<Vec<_>>()
            ),
            None
        );
    }

    /// 0.15 % at 0.05 % + 0.025 % a year last two years.
    #[test]
    fn the_interval_is_what_drift_and_allowance_leave() {
        let drift = CommonDrift {
            standards: 1,
            results: 9,
            drift_rel_per_year: -5.0e-4,
            expanded_rel_per_year: 2.5e-4,
        };
        assert!((drift.interval_years(0.0015) - 2.0).abs() < 1e-12);
        assert_eq!(drift.interval_years(0.0), 0.25);
        assert_eq!(drift.interval_years(1.0), 5.0);
    }
}
