//! One period of a nonlinear coil's deviation from its linear motion, step by step.

use nalgebra::{DMatrix, SMatrix, SVector};

use super::spectrum::{Grid, SILENCE, Spectrum};
use crate::model::{CoilModel, friction};
use crate::plant::network::{MovingCoil, Network};

/// Steps per period. A term that acts on the travel is resolved to `(pi h / N)^2 / 3` of itself at
/// harmonic h: 1e-5 for the fundamental, 3e-4 for the fifth.
pub(super) const STEPS: usize = 512;

/// Corrections of each step. A term changes its own argument by the share `stiffness step^2 / mass`
/// over a step, below 1e-2 at 5 Hz and less above: each correction gains two digits or more on a
/// prediction that is good to second order.
const CORRECTIONS: usize = 2;

/// Position of current, velocity and travel among the states; the travel is in mm, and so is that of a
/// body. What else there is belongs to an inductance with losses, or is nothing.
pub(super) const CURRENT: usize = 0;
pub(super) const VELOCITY: usize = 1;
pub(super) const TRAVEL: usize = 2;
const BODY_TRAVEL: usize = 4;
/// States per metre of travel.
pub(super) const TRAVEL_SCALE: f64 = 1000.0;

/// Inputs of the deviation.
const INPUTS: usize = 2;
const VOLTAGE: usize = 0;
const FORCE: usize = 1;

/// The linear motion at each step of a period.
pub(super) struct Drive {
    pub(super) current: Vec<f64>,
    pub(super) velocity: Vec<f64>,
    pub(super) travel: Vec<f64>,
}

impl Drive {
    pub(super) fn new(current: &Spectrum, travel: &Spectrum, omega: f64, grid: &Grid) -> Self {
        let mut velocity = SILENCE;
        for (order, value) in velocity.iter_mut().enumerate() {
            *value = travel[order] * nalgebra::Complex::new(0.0, omega * order as f64);
        }
        Self {
            current: grid.samples(current),
            velocity: grid.samples(&velocity),
            travel: grid.samples(travel),
        }
    }
}

/// One integrated period of the deviation.
pub(super) struct Period<const N: usize> {
    pub(super) end: SVector<f64, N>,
    pub(super) current: Vec<f64>,
    pub(super) travel: Vec<f64>,
    /// Travel of the body, if it moves.
    pub(super) body: Option<Vec<f64>>,
}

/// Matrices of one step of `N` states.
#[derive(Clone, Debug)]
pub(super) struct Stepping<const N: usize> {
    propagate: SMatrix<f64, N, N>,
    /// For the inputs at the start of the step, and at its end.
    at_start: [SVector<f64, N>; INPUTS],
    at_end: [SVector<f64, N>; INPUTS],
    /// For a force that is constant over the step.
    held_force: SVector<f64, N>,
    /// `(1 - propagate^STEPS)^-1`.
    pub(super) shortcut: SMatrix<f64, N, N>,
}

impl<const N: usize> Stepping<N> {
    /// `None` if the coil has more than `N` states or a period changes nothing.
    pub(super) fn new(coil: &CoilModel, time_s: f64, step_s: f64) -> Option<Self> {
        let mut network = Network::default();
        let voltage = network.input();
        let force = network.input();
        network.moving_coil(&voltage, &force, &MovingCoil::of(coil, time_s));
        let states = network.states();
        if states > N {
            return None;
        }
        let width = N + 2 * INPUTS;
        let mut augmented = DMatrix::zeros(width, width);
        let matrix = network.matrix() * step_s;
        for (at, from, count) in [(0, 0, states), (N, states, INPUTS)] {
            augmented
                .view_mut((0, at), (states, count))
                .copy_from(&matrix.columns(from, count));
        }
        // A state that there is not stays at rest, and comes to rest.
        for unused in states..N {
            augmented[(unused, unused)] = -1.0;
        }
        for input in 0..INPUTS {
            // The second pair of inputs is the change of the first over the step.
            augmented[(N + input, N + INPUTS + input)] = 1.0;
        }
        let exponential = augmented.exp();
        let column = |index: usize| SVector::from_fn(|row, _| exponential[(row, index)]);
        let (held, changed): (Vec<_>, Vec<_>) = (0..INPUTS)
            .map(|input| (column(N + input), column(N + INPUTS + input)))
            .unzip();
        let propagate = SMatrix::from_fn(|row, column| exponential[(row, column)]);
        let period = (0..STEPS.trailing_zeros())
            .fold(propagate, |power: SMatrix<f64, N, N>, _| power * power);
        Some(Self {
            propagate,
            at_start: std::array::from_fn(|input| held[input] - changed[input]),
            at_end: std::array::from_fn(|input| changed[input]),
            held_force: held[FORCE],
            shortcut: (SMatrix::identity() - period).try_inverse()?,
        })
    }

    /// Integrates the deviation over one period from `start`.
    pub(super) fn period(
        &self,
        coil: &CoilModel,
        drive: &Drive,
        start: &SVector<f64, N>,
    ) -> Period<N> {
        let mut state = *start;
        let mut now = bend(coil, drive, 0, start);
        let mut before = now;
        let mut current = Vec::with_capacity(STEPS);
        let mut travel = Vec::with_capacity(STEPS);
        let mut body = coil.body.map(|_| Vec::with_capacity(STEPS));
        for index in 0..STEPS {
            current.push(state[CURRENT]);
            travel.push(state[TRAVEL] / TRAVEL_SCALE);
            if let Some(body) = &mut body {
                body.push(state[BODY_TRAVEL] / TRAVEL_SCALE);
            }
            let after = (index + 1) % STEPS;
            let begun = self.propagate * state
                + self.at_start[VOLTAGE] * now[VOLTAGE]
                + self.at_start[FORCE] * now[FORCE];
            let v0 = drive.velocity[index] + state[VELOCITY];
            // Predicted to go on as it did, then corrected.
            let mut end = [
                2.0 * now[VOLTAGE] - before[VOLTAGE],
                2.0 * now[FORCE] - before[FORCE],
            ];
            for _ in 0..CORRECTIONS {
                state =
                    begun + self.at_end[VOLTAGE] * end[VOLTAGE] + self.at_end[FORCE] * end[FORCE];
                self.rub(coil, v0, drive.velocity[after], &mut state);
                end = bend(coil, drive, after, &state);
            }
            before = now;
            now = end;
        }
        Period {
            end: state,
            current,
            travel,
            body,
        }
    }

    /// Adds dry friction to the end of a step.
    fn rub(&self, coil: &CoilModel, v0: f64, drive_after: f64, end: &mut SVector<f64, N>) {
        if coil.friction_n != 0.0 {
            let free = drive_after + end[VELOCITY];
            let gain = self.held_force[VELOCITY];
            let rubbed = friction(v0, free, gain, coil.friction_n);
            *end += self.held_force * (rubbed.mean_n - 0.5 * rubbed.change_n)
                + self.at_end[FORCE] * rubbed.change_n;
        }
    }
}

/// Voltage and force of the smooth nonlinear terms.
fn bend<const N: usize>(
    coil: &CoilModel,
    drive: &Drive,
    index: usize,
    state: &SVector<f64, N>,
) -> [f64; INPUTS] {
    let current = drive.current[index] + state[CURRENT];
    let velocity = drive.velocity[index] + state[VELOCITY];
    let travel = drive.travel[index] + state[TRAVEL] / TRAVEL_SCALE;
    let square = travel * travel;
    let lost = coil.force_factor_n_per_a * coil.droop_per_m2 * square;
    let restoring = square * (coil.quadratic_n_per_m2 + coil.cubic_n_per_m3 * travel);
    [
        coil.emf_ratio * lost * velocity,
        -lost * current - restoring,
    ]
}
