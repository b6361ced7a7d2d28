//! Shapes a residual is tested for: courses over frequency, alone and with a condition.

use super::column::Column;
use super::problem::Problem;
use crate::model::row::{NOISE, REF_HARMONICS, Row, SLOTS};

/// Bands of the tests for local structure.
pub(crate) const BANDS: usize = 14;
/// Highest order of the courses over frequency: of a response, and of a harmonic or a mean.
const COURSES: [usize; 2] = [7, 2];
/// Highest order of the courses over which a condition acts.
const COURSES_OF_CONDITIONS: usize = 2;

/// One direction in which a residual is looked at.
pub(super) struct Test {
    pub(super) slot: usize,
    /// Condition along which the shape runs, as the answer names it.
    pub(super) axis: &'static str,
    /// Number of the shape within its slot, from 1: the same in all response slots.
    pub(super) shape: usize,
    pub(super) column: Column,
}

/// All tests of a problem, slot by slot, those of the bands last.
pub(super) fn battery(problem: &Problem) -> Vec<Test> {
    let mut tests = Vec::new();
    for slot in (0..SLOTS).filter(|s| !problem.slots[*s].is_empty()) {
        let mut of_slot = OfSlot {
            problem,
            slot,
            shapes: 0,
            tests: &mut tests,
        };
        let response = !(REF_HARMONICS..NOISE).contains(&slot);
        of_slot.add_courses(COURSES[usize::from(!response)]);
        of_slot.add_conditions(response);
        of_slot.add_sizes();
        if response {
            of_slot.add_bands();
        }
    }
    tests
}

/// Collects the tests of one slot.
struct OfSlot<'a> {
    problem: &'a Problem,
    slot: usize,
    /// Shapes so far, also those that are zero in every row.
    shapes: usize,
    tests: &'a mut Vec<Test>,
}

impl OfSlot<'_> {
    fn add(&mut self, axis: &'static str, shape: &dyn Fn(&Row) -> f64) {
        let problem = self.problem;
        let range = problem.slots[self.slot].clone();
        let values: Vec<f64> = range
            .map(|at| finite(shape(&problem.rows[problem.row_of[at]])))
            .collect();
        self.shapes += 1;
        if values.iter().any(|v| *v != 0.0) {
            self.tests.push(Test {
                slot: self.slot,
                axis,
                shape: self.shapes,
                column: Column {
                    parts: vec![(self.slot, values)],
                },
            });
        }
    }

    /// Smooth courses over frequency alone.
    fn add_courses(&mut self, most: usize) {
        let problem = self.problem;
        for order in 0..=most {
            self.add("frequency_hz", &|row| course(problem, order, row));
        }
    }

    /// Each condition that varies, times a smooth course over frequency.
    fn add_conditions(&mut self, response: bool) {
        let problem = self.problem;
        let facts = &problem.facts;
        for order in 0..=COURSES_OF_CONDITIONS {
            let p = |row: &Row| course(problem, order, row);
            self.add("acceleration_ms2", &|row| p(row) * row.level_ms2.ln());
            if !response {
                continue;
            }
            self.add("inverse level", &|row| p(row) / row.level_ms2);
            if facts.rotation_varies {
                self.add("rotation_deg", &|row| p(row) * row.rotation.0);
                self.add("rotation_deg", &|row| p(row) * row.rotation.1);
            }
            if facts.payload_varies {
                self.add("payload_kg", &|row| p(row) * row.payload_kg);
            }
            if facts.temperature_varies {
                self.add("temperature_c", &|row| p(row) * row.warmer_k);
            }
            self.add("time_s", &|row| p(row) * row.time_s);
        }
    }

    /// Level, travel and coil voltage themselves.
    fn add_sizes(&mut self) {
        let travel_m = |row: &Row| row.level_ms2 / (row.omega * row.omega);
        self.add("acceleration_ms2", &|row| row.level_ms2);
        self.add("acceleration_ms2", &|row| row.level_ms2 * row.level_ms2);
        self.add("travel_m", &travel_m);
        self.add("travel_m", &|row| travel_m(row).powi(2));
        self.add("coil_v", &|row| row.coil_peak_v);
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
            self.add("frequency_hz", &|row| {
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
