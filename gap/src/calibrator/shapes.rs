//! Shapes a residual is tested for: courses over frequency, alone and with a condition.

use super::problem::{Column, Problem};
use crate::axis::Axis;
use crate::model::row::Row;
use crate::observable::Observable;
use std::ops::Range;

/// Bands of the tests for local structure.
pub(crate) const BANDS: usize = 14;
/// Highest order of the courses over frequency: of a response, and of a harmonic or a mean.
const COURSES: [usize; 2] = [7, 2];
/// Highest order of the courses over which a condition acts.
const COURSES_OF_CONDITIONS: usize = 2;

/// One direction in which a residual is looked at.
pub(super) struct Test {
    pub(super) observable: Observable,
    /// Condition along which the shape runs.
    pub(super) axis: Axis,
    /// Number of the shape within its observable, from 1: the same in all responses.
    pub(super) shape: usize,
    pub(super) column: Column,
}

/// All tests of a problem, one observable after the other, those of the bands last.
pub(super) fn shapes(problem: &Problem) -> Vec<Test> {
    let mut tests = Vec::new();
    for (observable, data) in problem.measured_observables() {
        let mut collected = OfObservable {
            problem,
            observable,
            data,
            shapes: 0,
            tests: &mut tests,
        };
        let response = observable.group().is_response() || observable.is_noise();
        collected.add_courses(COURSES[usize::from(!response)]);
        collected.add_conditions(response);
        collected.add_sizes();
        if response {
            collected.add_bands();
        }
    }
    tests
}

/// Collects the tests of one observable.
struct OfObservable<'a> {
    problem: &'a Problem,
    observable: Observable,
    data: Range<usize>,
    /// Shapes so far, also those that are zero in every row.
    shapes: usize,
    tests: &'a mut Vec<Test>,
}

impl OfObservable<'_> {
    fn add(&mut self, axis: Axis, shape: &dyn Fn(&Row) -> f64) {
        let problem = self.problem;
        let rows = self.data.clone();
        let values: Vec<f64> = rows
            .map(|at| finite(shape(&problem.rows[problem.row_of[at]])))
            .collect();
        self.shapes += 1;
        if values.iter().any(|v| *v != 0.0) {
            self.tests.push(Test {
                observable: self.observable,
                axis,
                shape: self.shapes,
                column: Column {
                    parts: vec![(self.observable, values)],
                },
            });
        }
    }

    /// Smooth courses over frequency alone.
    fn add_courses(&mut self, most: usize) {
        let problem = self.problem;
        for order in 0..=most {
            self.add(Axis::Frequency, &|row| course(problem, order, row));
        }
    }

    /// Each condition that varies, times a smooth course over frequency.
    fn add_conditions(&mut self, response: bool) {
        let problem = self.problem;
        let facts = &problem.facts;
        for order in 0..=COURSES_OF_CONDITIONS {
            let p = |row: &Row| course(problem, order, row);
            self.add(Axis::Level, &|row| p(row) * row.level_ms2.ln());
            if !response {
                continue;
            }
            self.add(Axis::InverseLevel, &|row| p(row) / row.level_ms2);
            if facts.rotation_varies {
                self.add(Axis::Rotation, &|row| p(row) * row.rotation.0);
                self.add(Axis::Rotation, &|row| p(row) * row.rotation.1);
                self.add(Axis::Rotation, &|row| p(row) * row.rotation_twice().0);
                self.add(Axis::Rotation, &|row| p(row) * row.rotation_twice().1);
            }
            if facts.payload_varies {
                self.add(Axis::Payload, &|row| p(row) * row.payload_kg);
            }
            if facts.temperature_varies {
                self.add(Axis::Temperature, &|row| p(row) * row.warmer_k);
            }
            self.add(Axis::Time, &|row| p(row) * row.time_s);
            // What settles, as a part that warms up does.
            self.add(Axis::Time, &|row| {
                let place = 2.0 * row.time_s / facts.longest_s - 1.0;
                p(row) * legendre(2, place)
            });
        }
    }

    /// Level, travel and coil voltage themselves.
    fn add_sizes(&mut self) {
        self.add(Axis::Level, &|row| row.level_ms2);
        self.add(Axis::Level, &|row| row.level_ms2 * row.level_ms2);
        self.add(Axis::Travel, &Row::travel_m);
        self.add(Axis::Travel, &|row| row.travel_m().powi(2));
        self.add(Axis::CoilVoltage, &|row| row.coil_peak_v);
    }

    /// Bands with the same number of frequencies each, or one fewer.
    fn add_bands(&mut self) {
        let frequencies_hz = &self.problem.facts.frequencies_hz;
        let bands = BANDS.min(frequencies_hz.len());
        let limit = |band: usize| {
            let at = band * frequencies_hz.len() / bands;
            frequencies_hz.get(at).copied().unwrap_or(f64::INFINITY)
        };
        for band in 0..bands {
            let inside = limit(band)..limit(band + 1);
            self.add(Axis::Frequency, &|row| {
                f64::from(u8::from(inside.contains(&row.frequency_hz)))
            });
        }
    }
}

/// Legendre polynomial of the logarithm of a row's frequency, the band from -1 to 1.
fn course(problem: &Problem, order: usize, row: &Row) -> f64 {
    let facts = &problem.facts;
    let place = if facts.highest_hz > facts.lowest_hz {
        2.0 * (row.frequency_hz / facts.lowest_hz).ln() / (facts.highest_hz / facts.lowest_hz).ln()
            - 1.0
    } else {
        0.0
    };
    legendre(order, place)
}

fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { 0.0 }
}

/// By Bonnet's recursion.
fn legendre(order: usize, x: f64) -> f64 {
    let (mut a, mut b) = (1.0, x);
    if order == 0 {
        return 1.0;
    }
    for n in 1..order {
        let k = n as f64;
        (a, b) = (b, ((2.0 * k + 1.0) * x * b - k * a) / (k + 1.0));
    }
    b
}
