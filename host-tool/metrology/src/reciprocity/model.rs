//! The means over a check's runs at one frequency, and the exciter they show.

use super::equipment::Equipment;
use super::runs::{Pair, Reading, Runs};
use nalgebra::{Matrix3, Vector3};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// One load at one frequency.
#[derive(Clone, Copy, Debug)]
pub(super) struct Load {
    /// Reference's output over current, V/A.
    pub(super) r: Complex64,
    /// Voltage of coil and shunt over current, ohm.
    pub(super) z: Complex64,
}

impl Load {
    fn of(pair: &Pair, index: usize, equipment: &Equipment) -> Self {
        let [shunt, divider] = [&pair.shunt, &pair.divider].map(|run| run[index].ratio);
        let z = divider / shunt * (equipment.shunt_ohm / equipment.divider_volt_per_v);
        Self {
            r: equipment.shunt_ohm / shunt,
            z,
        }
    }

    fn mean(loads: &[Self]) -> Self {
        let count = loads.len() as f64;
        Self {
            r: loads.iter().map(|load| load.r).sum::<Complex64>() / count,
            z: loads.iter().map(|load| load.z).sum::<Complex64>() / count,
        }
    }
}

/// Both loads at one frequency.
#[derive(Clone, Debug)]
pub(super) struct At {
    pub(super) frequency_hz: f64,
    /// Without the mass, before and after.
    pub(super) before_after: [Load; 2],
    /// Each mounting.
    pub(super) mountings: [Load; 3],
    pub(super) bare: Load,
    pub(super) loaded: Load,
    /// Variance of either part of the mean ratios: shunt and divider bare, shunt and divider with the mass.
    pub(super) noise: [f64; 4],
    /// Acceleration, m/s2 r.m.s., without the mass and with it.
    pub(super) levels_rms_ms2: [f64; 2],
    /// Device's input over the reference's: shunt and divider bare, shunt and divider with the mass.
    pub(super) ratios: [Complex64; 4],
}

impl At {
    pub(super) fn new(runs: &Runs, index: usize, equipment: &Equipment) -> Self {
        let load = |pair: &Pair| Load::of(pair, index, equipment);
        let [before, after] = &runs.bare;
        let [one, two, three] = &runs.loaded;
        let before_after = [load(before), load(after)];
        let mountings = [load(one), load(two), load(three)];
        let readings = |pairs: &[Pair], run: fn(&Pair) -> &Vec<Reading>| -> Vec<Reading> {
            pairs.iter().map(|pair| run(pair)[index]).collect()
        };
        let of = |pairs: &[Pair]| {
            [
                readings(pairs, |pair| &pair.shunt),
                readings(pairs, |pair| &pair.divider),
            ]
        };
        let [shunt0, divider0] = of(&runs.bare);
        let [shunt1, divider1] = of(&runs.loaded);
        let all = [&shunt0, &divider0, &shunt1, &divider1];
        Self {
            frequency_hz: shunt0[0].frequency_hz,
            before_after,
            mountings,
            bare: Load::mean(&before_after),
            loaded: Load::mean(&mountings),
            noise: all.map(|readings| variance_of_mean(readings)),
            levels_rms_ms2: [&shunt0, &shunt1].map(|run| run[0].acceleration_rms_ms2),
            ratios: all.map(|readings| readings[0].ratio),
        }
    }

    pub(super) fn omega(&self) -> f64 {
        TAU * self.frequency_hz
    }

    /// `Z1 - Z0`, ohm.
    pub(super) fn difference(&self) -> Complex64 {
        self.loaded.z - self.bare.z
    }
}

fn variance_of_mean(readings: &[Reading]) -> f64 {
    let squares: f64 = readings
        .iter()
        .map(|reading| reading.scatter_rel.powi(2))
        .sum();
    squares / (readings.len() * readings.len()) as f64
}

/// The exciter without the mass, as the runs show it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Identified {
    /// Moving mass, kg.
    pub moving_mass_kg: f64,
    /// Stiffness, N/m.
    pub stiffness_n_per_m: f64,
    /// Damping, N s/m.
    pub damping_ns_per_m: f64,
    /// Bl, N/A.
    pub force_factor_n_per_a: f64,
    /// Direct current that carries the mass, A.
    pub hold_a: f64,
    /// By how much the coil with the mass was warmer or colder than without, ohm.
    pub warmer_ohm: f64,
}

/// The mass felt at a frequency: on its seat it moves more than the table.
pub(super) fn mass_felt_kg(equipment: &Equipment, omega: f64) -> f64 {
    let mass_kg = equipment.mass_kg + equipment.film_kg;
    mass_kg / (1.0 - omega * omega * mass_kg * equipment.seat_m_per_n[0])
}

/// Mechanical impedance without the mass, N s/m: `Zm1/Zm0 = r0/r1`.
pub(super) fn mechanical(at: &At, equipment: &Equipment) -> Complex64 {
    let added = Complex64::new(0.0, at.omega() * mass_felt_kg(equipment, at.omega()));
    added / (at.bare.r / at.loaded.r - 1.0)
}

/// `Bl^2` by `Z1 - Z0 = Bl^2 (1/Zm1 - 1/Zm0)`, (N/A)^2.
pub(super) fn force_factor_squared(at: &At, equipment: &Equipment) -> Complex64 {
    let bare = mechanical(at, equipment);
    let loaded = bare * at.bare.r / at.loaded.r;
    at.difference() / (loaded.inv() - bare.inv())
}

/// Mass, stiffness and damping by least squares of `jw M + c + k/jw`, each frequency by its relative deviation;
/// and the greatest relative deviation with its frequency.
pub(super) fn identify(points: &[&At], equipment: &Equipment) -> Option<([f64; 3], [f64; 2])> {
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    let rows = |at: &At| {
        let impedance = mechanical(at, equipment);
        let omega = at.omega();
        let scale = 1.0 / impedance.norm();
        // The unknowns are of the order of one another: w0 M, c, k/w0.
        let imaginary =
            Vector3::new(omega / REFERENCE_RAD_S, 0.0, -REFERENCE_RAD_S / omega) * scale;
        let real = Vector3::new(0.0, scale, 0.0);
        [
            (imaginary, impedance.im * scale),
            (real, impedance.re * scale),
        ]
    };
    for (row, value) in points.iter().flat_map(|at| rows(at)) {
        normal += row * row.transpose();
        right += row * value;
    }
    let solved = normal.lu().solve(&right)?;
    let residual = |at: &&At| {
        let squares: f64 = rows(at)
            .into_iter()
            .map(|(row, value)| (row.dot(&solved) - value).powi(2))
            .sum();
        [squares.sqrt(), at.frequency_hz]
    };
    let worst = points.iter().map(residual);
    let worst = worst.fold(
        [0.0; 2],
        |most, one| if one[0] > most[0] { one } else { most },
    );
    let found = [
        solved[0] / REFERENCE_RAD_S,
        solved[2] * REFERENCE_RAD_S,
        solved[1],
    ];
    Some((found, worst))
}

const REFERENCE_RAD_S: f64 = 500.0;
