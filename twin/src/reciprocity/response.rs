//! Device's input over reference's while the reference is checked, in steady state.
//!
//! Impedances of the masses, springs and the coil, in f64; what bends is averaged over a period.

use std::f64::consts::{SQRT_2, TAU};

use nalgebra::Complex;

use crate::model::{CoilInput, CoilModel, Reciprocity, SecondOrder, Section};
use crate::oracle;
use crate::rig::Rig;

/// Instants of a period for the means.
const INSTANTS: u32 = 64;

/// A state of the exciter at one frequency, peak values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Coil current, A.
    pub current_a: Complex<f64>,
    /// Voltage across coil and shunt, V.
    pub coil_v: Complex<f64>,
    /// Acceleration of the table, m/s2.
    pub table_ms2: Complex<f64>,
    /// Volts at the reference's connector and at the device's.
    pub inputs_v: [Complex<f64>; 2],
}

/// Nonlinear changes at the amplitude of a motion, as factors of the fundamental.
struct Bent {
    force: Complex<f64>,
    emf: Complex<f64>,
    /// Added to the stiffness, N/m.
    stiffness: Complex<f64>,
}

/// The rig's motion at a frequency and an acceleration of its table, m/s2 r.m.s.; `None` for a rig without
/// coil sensing.
pub fn motion(rig: &Rig, frequency_hz: f64, acceleration_rms_ms2: f64) -> Option<Motion> {
    let check = rig.reciprocity?;
    let coil = rig.model().coil;
    let straight = Bent {
        force: Complex::new(1.0, 0.0),
        emf: Complex::new(1.0, 0.0),
        stiffness: Complex::new(0.0, 0.0),
    };
    let reached = |bent: &Bent| {
        let found = solve(&coil, &check, frequency_hz, bent);
        let scale = SQRT_2 * acceleration_rms_ms2 / found.table_ms2.norm();
        found.scaled(scale)
    };
    let linear = reached(&straight);
    let solved = reached(&bend(&coil, &linear, frequency_hz));
    Some(read(rig, &check, &solved, frequency_hz))
}

/// Currents, voltages and motions, peak, of any level.
struct Solved {
    current_a: Complex<f64>,
    coil_v: Complex<f64>,
    travel_m: Complex<f64>,
    table_ms2: Complex<f64>,
}

impl Solved {
    fn scaled(&self, factor: f64) -> Self {
        Self {
            current_a: self.current_a * factor,
            coil_v: self.coil_v * factor,
            travel_m: self.travel_m * factor,
            table_ms2: self.table_ms2 * factor,
        }
    }
}

/// For a current of 1 A.
fn solve(coil: &CoilModel, check: &Reciprocity, frequency_hz: f64, bent: &Bent) -> Solved {
    let s = Complex::new(0.0, TAU * frequency_hz);
    let spring = |stiffness: f64, damping: f64| stiffness / s + damping;
    let in_series = |one: Complex<f64>, other: Complex<f64>| one * other / (one + other);
    let mut armature = s * coil.mass_kg;
    let mut above = Complex::new(0.0, 0.0);
    if check.mass_kg > 0.0 {
        let seat = spring(check.seat_n_per_m, check.seat_ns_per_m);
        above = in_series(seat, s * check.mass_kg);
    }
    // Velocity of the table over that of the armature.
    let mut passed = Complex::new(1.0, 0.0);
    if check.table_kg > 0.0 {
        let neck = spring(check.table_n_per_m, check.table_ns_per_m);
        let table = s * check.table_kg + above;
        passed = neck / (neck + table);
        above = in_series(neck, table);
        armature -= s * check.table_kg;
    }
    let suspension = (bent.stiffness + coil.stiffness_n_per_m) / s + coil.damping_ns_per_m;
    let velocity = bent.force * coil.force_factor_n_per_a / (armature + suspension + above);
    let blocked = coil.blocked_impedance(s.im, 0.0) + s * check.shunt_inductance_h;
    let emf = bent.emf * coil.force_factor_n_per_a * velocity;
    Solved {
        current_a: Complex::new(1.0, 0.0),
        coil_v: blocked + check.shunt_ohm + emf,
        travel_m: velocity / s,
        table_ms2: s * velocity * passed,
    }
}

/// Means over a period of `Bl(x) i`, `Bl(x) v` and the cubic of the spring, at their fundamental.
fn bend(coil: &CoilModel, at: &Solved, frequency_hz: f64) -> Bent {
    let velocity = at.travel_m * Complex::new(0.0, TAU * frequency_hz);
    let [mut force, mut emf, mut stiffness] = [Complex::new(0.0, 0.0); 3];
    for instant in 0..INSTANTS {
        let turn = Complex::from_polar(1.0, TAU * f64::from(instant) / f64::from(INSTANTS));
        let now = |phasor: Complex<f64>| (phasor * turn).re;
        let x = now(at.travel_m);
        let left = 1.0 - coil.droop_per_m2 * x * x;
        let share = turn.conj() * (2.0 / f64::from(INSTANTS));
        force += share * (left * now(at.current_a));
        emf += share * (left * now(velocity));
        stiffness += share * (coil.cubic_n_per_m3 * x * x * x);
    }
    Bent {
        force: force / at.current_a,
        emf: emf / velocity,
        stiffness: stiffness / at.travel_m,
    }
}

fn read(rig: &Rig, check: &Reciprocity, solved: &Solved, frequency_hz: f64) -> Motion {
    let s = Complex::new(0.0, TAU * frequency_hz);
    let rocking = Section::SecondOrder(SecondOrder {
        corner_hz: check.rocking_hz,
        quality_factor: check.rocking_quality,
        numerator: [1.0, 1.0 / check.rocking_quality, 1.0 + check.rocking_rel],
    });
    let felt = solved.table_ms2 * rocking.response(frequency_hz);
    let stray = (s * check.stray_h + check.stray_ohm) * solved.current_a;
    let device = match check.input {
        CoilInput::Shunt => (s * check.shunt_inductance_h + check.shunt_ohm) * solved.current_a,
        CoilInput::Divider => {
            let corner = Section::LowPass(check.divider_corner_hz).response(frequency_hz);
            check.divider_volt_per_v * corner * solved.coil_v
        }
    };
    Motion {
        current_a: solved.current_a,
        coil_v: solved.coil_v,
        table_ms2: solved.table_ms2,
        inputs_v: [
            felt * oracle::reference_sensitivity(rig, frequency_hz) + stray,
            device,
        ],
    }
}
