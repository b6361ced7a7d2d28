//! The course of a ratio's deviation over frequency, in words.

use super::pattern::{Kind, Pattern, bands, column};
use crate::calibrator::fit::{Fit, Workspace};
use crate::calibrator::linear::Linearised;
use crate::calibrator::problem::{Column, Problem};
use crate::calibrator::settled::Settled;
use crate::observable::Observable;
use crate::thresholds;

/// A function of the frequency.
type Course = fn(f64) -> f64;

/// Courses that have a word.
const POWERS: [(&str, Course); 5] = [
    ("1/f^2", |f| 1.0 / (f * f)),
    ("1/f", |f| 1.0 / f),
    ("log f", f64::ln),
    ("f", |f| f),
    ("f^2", |f| f * f),
];
/// Word for what is constant below a frequency and falls as 1/f^2 above it.
const CORNER: &str = "corner";
/// Corners that are tried, evenly over the logarithm of the band.
const CORNERS: usize = 24;

/// Words for the course of the ratio's magnitude over frequency, most probable first;
/// `None` where no simple course describes it.
pub(crate) fn of_ratio(problem: &Problem, fit: &Fit, work: &mut Workspace) -> Option<String> {
    let (evaluation, tangent) = Linearised::new(problem, fit, work).tangent()?;
    let weight = &evaluation.weight;
    let residual = Settled::new(problem, fit, &tangent, evaluation.residual).left;
    let along = |course: &dyn Fn(f64) -> f64| {
        column(problem, weight, &[(Observable::Ratio, 1.0)], &|row| {
            course(row.frequency_hz)
        })
    };
    let gain = |columns: Vec<Column>| {
        let pattern = Pattern::new(problem, &tangent, Kind::Ratio, columns)?;
        Some(pattern.fit(problem, &residual).1)
    };
    let steps = bands(problem);
    let free = steps.iter().map(|course| along(course)).collect::<Vec<_>>();
    let free = gain(free.into_iter().filter(|c| c.norm2() > 0.0).collect())?;
    let cost = (problem.data_of(Observable::Ratio).len() as f64).ln();
    let powers = POWERS
        .iter()
        .filter_map(|(word, course)| Some((*word, gain(vec![along(course)])? - cost)));
    let (low, high) = (problem.facts.lowest_hz, problem.facts.highest_hz);
    let corner = |i: usize| low * (high / low).powf((i as f64 + 0.5) / CORNERS as f64);
    let corners = (0..CORNERS).filter_map(|i| {
        let corner_hz = corner(i);
        gain(vec![along(&|f| 1.0 / (1.0 + (f / corner_hz).powi(2)))])
    });
    let corner = corners
        .reduce(f64::max)
        .map(|gain| (CORNER, gain - 2.0 * cost));
    let mut words: Vec<(&str, f64)> = powers.chain(corner).collect();
    words.sort_by(|a, b| b.1.total_cmp(&a.1));
    let best = words.first()?.1;
    let near = words
        .iter()
        .filter(|w| w.1 > best - thresholds::SHAPE_ODDS)
        .map(|w| w.0);
    (best > 0.0 && best + cost > thresholds::SHAPE_SHARE * free)
        .then(|| near.collect::<Vec<_>>().join(" or "))
}
