//! The periodic motion of a moving coil, by integration in time where it is nonlinear.
//!
//! The motion is the linear response, known exactly, plus a deviation `z` that the nonlinear terms
//! `w` drive: `z' = A z + B w(linear + z)`. Over each step `z` is propagated exactly for a `w` that
//! changes linearly (predicted, then corrected); dry friction acts as the mean of its sign over the
//! step, which needs no smoothing and lets the armature stick. A period maps the deviation at its
//! start to that at its end; the periodic one is the fixed point, found by quasi-Newton steps
//! that start from the linear map.

use std::f64::consts::TAU;

use nalgebra::{Complex, SMatrix, SVector};

use super::spectrum::{Grid, HARMONICS, SILENCE, Spectrum};
use super::stepping::{CURRENT, Drive, Period, STEPS, Stepping, TRAVEL, TRAVEL_SCALE, VELOCITY};
use crate::model::{CoilModel, RETARDATIONS};

/// Periods that are tried before the motion is called unsteady.
const LONGEST_SEARCH: usize = 80;

/// Deviation left at the end of a period, relative to the motion.
const TOLERANCE: f64 = 1e-8;

/// Current, velocity and travel; velocity and travel of a body that moves.
const PLAIN: usize = 3;
const OF_BODY: usize = 2;

/// Harmonics of current and travel.
#[derive(Clone, Debug)]
pub(super) struct Motion {
    /// Coil current, A peak.
    pub(super) current: Spectrum,
    /// Travel from the body, m peak.
    pub(super) travel: Spectrum,
    /// Travel in space, m peak.
    pub(super) position: Spectrum,
}

/// How the motion is found.
enum Method {
    Linear,
    Bent(Box<dyn Periodic>),
}

/// A coil at one frequency and time.
pub(super) struct SteadyCoil<'a> {
    coil: &'a CoilModel,
    omega: f64,
    time_s: f64,
    method: Method,
}

impl<'a> SteadyCoil<'a> {
    /// `None` if the coil has no periodic motion at all.
    pub(super) fn new(coil: &'a CoilModel, frequency_hz: f64, time_s: f64) -> Option<Self> {
        let step_s = 1.0 / frequency_hz / STEPS as f64;
        let method = if coil.is_linear() {
            Method::Linear
        } else {
            Method::Bent(search(coil, time_s, step_s)?)
        };
        Some(Self {
            coil,
            omega: TAU * frequency_hz,
            time_s,
            method,
        })
    }

    /// The motion for a coil voltage; `None` if it does not become periodic.
    pub(super) fn motion(&mut self, voltage: &Spectrum, grid: &Grid) -> Option<Motion> {
        let linear = self.linear(voltage);
        let (coil, omega) = (self.coil, self.omega);
        match &mut self.method {
            Method::Linear => Some(linear),
            Method::Bent(search) => search.motion(coil, omega, &linear, grid),
        }
    }

    fn linear(&self, voltage: &Spectrum) -> Motion {
        let mut motion = Motion {
            current: SILENCE,
            travel: SILENCE,
            position: SILENCE,
        };
        for (order, &volt) in voltage.iter().enumerate().skip(1) {
            if volt != Complex::new(0.0, 0.0) {
                let omega = self.omega * order as f64;
                let [current, position] = self.coil.linear_response(omega, self.time_s);
                motion.current[order] = current * volt;
                motion.position[order] = position * volt;
                motion.travel[order] = position * volt * self.coil.from_body(omega);
            }
        }
        motion.travel[0].re = self.coil.static_force_n / self.coil.suspension_n_per_m(0.0).re;
        motion
    }
}

/// A search for the periodic deviation, whatever the number of states.
trait Periodic {
    /// The whole motion; `None` if it does not become periodic.
    fn motion(
        &mut self,
        coil: &CoilModel,
        omega: f64,
        linear: &Motion,
        grid: &Grid,
    ) -> Option<Motion>;
}

/// The search for a coil with at least as many states as it has.
fn search(coil: &CoilModel, time_s: f64, step_s: f64) -> Option<Box<dyn Periodic>> {
    fn of<const N: usize>(coil: &CoilModel, time_s: f64, step_s: f64) -> Option<Box<dyn Periodic>> {
        Some(Box::new(Search::<N>::new(coil, time_s, step_s)?))
    }
    let of_body = coil.body.map_or(0, |_| OF_BODY);
    let of_creep = coil.creep().map_or(0, |_| usize::from(RETARDATIONS));
    match PLAIN + of_body + of_creep + coil.ladder().pairs.len() {
        PLAIN => of::<PLAIN>(coil, time_s, step_s),
        4..=6 => of::<6>(coil, time_s, step_s),
        7..=33 => of::<33>(coil, time_s, step_s),
        _ => of::<47>(coil, time_s, step_s),
    }
}

/// The search for the periodic deviation.
struct Search<const N: usize> {
    stepping: Stepping<N>,
    /// Deviation at the start of the period, kept as the start of the next search.
    start: SVector<f64, N>,
}

impl<const N: usize> Search<N> {
    fn new(coil: &CoilModel, time_s: f64, step_s: f64) -> Option<Self> {
        Some(Self {
            stepping: Stepping::new(coil, time_s, step_s)?,
            start: SVector::zeros(),
        })
    }
}

impl<const N: usize> Periodic for Search<N> {
    fn motion(
        &mut self,
        coil: &CoilModel,
        omega: f64,
        linear: &Motion,
        grid: &Grid,
    ) -> Option<Motion> {
        let drive = Drive::new(&linear.current, &linear.travel, omega, grid);
        let size = sizes::<N>(&drive);
        let mut inverse = self.stepping.shortcut;
        let mut last: Option<(SVector<f64, N>, SVector<f64, N>)> = None;
        for _ in 0..LONGEST_SEARCH {
            let period = self.stepping.period(coil, &drive, &self.start);
            let left = period.end - self.start;
            let worst = left.component_div(&size).amax();
            if worst < TOLERANCE {
                return Some(add(linear, &period, grid));
            }
            if !worst.is_finite() {
                break;
            }
            if let Some((step, before)) = last.take() {
                improve(&mut inverse, &step, &(left - before));
            }
            let step = inverse * left;
            self.start += step;
            last = Some((step, left));
        }
        self.start.fill(0.0);
        None
    }
}

/// Size of each state of the motion; the states of a lossy inductance are currents.
fn sizes<const N: usize>(drive: &Drive) -> SVector<f64, N> {
    let largest = |values: &[f64]| {
        values
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    let mut size = SVector::repeat(largest(&drive.current));
    size[CURRENT] = largest(&drive.current);
    size[VELOCITY] = largest(&drive.velocity);
    size[TRAVEL] = largest(&drive.travel) * TRAVEL_SCALE;
    size
}

/// Broyden's update of the inverse of minus the derivative of what is left after a period.
fn improve<const N: usize>(
    inverse: &mut SMatrix<f64, N, N>,
    step: &SVector<f64, N>,
    change: &SVector<f64, N>,
) {
    let reached = *inverse * change;
    let denominator = -step.dot(&reached);
    if denominator.abs() > 1e-6 * step.norm_squared() {
        let row = inverse.tr_mul(step);
        *inverse += (step + reached) * row.transpose() / denominator;
    }
}

fn add<const N: usize>(linear: &Motion, period: &Period<N>, grid: &Grid) -> Motion {
    let mut motion = linear.clone();
    let current = grid.spectrum(&period.current, HARMONICS);
    let travel = grid.spectrum(&period.travel, HARMONICS);
    let body = period.body.as_ref();
    let body = body.map_or(SILENCE, |samples| grid.spectrum(samples, HARMONICS));
    for order in 0..=HARMONICS {
        motion.current[order] += current[order];
        motion.travel[order] += travel[order];
        motion.position[order] += travel[order] + body[order];
    }
    motion
}
