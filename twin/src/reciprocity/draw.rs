//! A calibrator with shunt, divider and mass, as they are and as they are stated.

use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;

use super::distributions as table;
use crate::model::{COPPER_PER_K, CoilInput, FREE_FALL_MS2, Reciprocity};
use crate::rig::Rig;

/// Stated mass, kg.
const MASS_KG: f64 = 0.050;
/// Stated shunt, ohm, and volts of the divider for a volt at the coil.
const SHUNT_OHM: f64 = 1.0;
const DIVIDER_VOLT_PER_V: f64 = 0.5;
/// Quality factor of the axial mode of coil against table.
const TABLE_QUALITY: f64 = 40.0;
/// Loss factor of a seat with a film, at its own resonance.
const SEAT_LOSS: f64 = 0.05;

/// Whether a direct current carries the mass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// It does: the coil stays where it was.
    Current,
    /// It does not: the mass lowers the coil.
    None,
}

/// Values of the equipment as told to whoever evaluates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stated {
    /// Added mass, kg.
    pub mass_kg: f64,
    /// Shunt, ohm.
    pub shunt_ohm: f64,
    /// Output of the divider for a volt across coil and shunt.
    pub divider_volt_per_v: f64,
}

/// A mounting of the mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounting {
    /// Mass with its film, kg.
    pub mass_kg: f64,
    /// Stiffness of the seat, N/m.
    pub seat_n_per_m: f64,
    /// Position of the coil from where it is without the mass, m, up.
    pub travel_m: f64,
    /// Acceleration that rocking adds at the reference, relative.
    pub rocking_rel: f64,
}

/// How the exciter changes with position.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Position {
    inductance_per_m: f64,
    force_factor_per_m: f64,
    force_factor_per_m2: f64,
    stiffness_per_m: f64,
    stiffness_per_m2: f64,
}

/// How the coil warms and how long hands take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Warming {
    pub(super) kelvin_per_w: f64,
    pub(super) time_constant_s: f64,
    pub(super) body_k_per_s: f64,
}

/// How the converters read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Reading {
    pub(super) ratio_error_rel: f64,
    pub(super) crosstalk: f64,
    pub(super) noise_rms_v: f64,
    pub(super) floor_rms_ms2: f64,
}

/// A drawn calibrator at one check.
#[derive(Clone, Debug, PartialEq)]
pub struct SelfCheckDraw {
    /// Without a mass, its coil cold, the shunt at the device's input.
    pub rig: Rig,
    /// Values of the equipment as told.
    pub stated: Stated,
    /// Whether the position is held.
    pub hold: Hold,
    /// The three mountings.
    pub mountings: [Mounting; 3],
    /// The rig whose reference was calibrated.
    pub certified_rig: Rig,
    /// Error of the reference's certificate, relative.
    pub certificate_error_rel: f64,
    /// Error of its phase, rad.
    pub certificate_error_rad: f64,
    /// Change by the temperature of the reference beyond that by the temperature read, relative.
    pub temperature_error_rel: f64,
    pub(super) warming: Warming,
    pub(super) reading: Reading,
    position: Position,
    equipment: Equipment,
    seed: u64,
}

/// Equipment that stays from check to check.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Equipment {
    mass_kg: f64,
    seat_n_per_m: f64,
    eccentricity_m: [f64; 2],
    off_axis_m: f64,
    inertia_kg_m2: f64,
    reference_per_k: f64,
}

impl SelfCheckDraw {
    /// The calibrator of this seed at its first check.
    pub fn new(seed: u64, hold: Hold) -> Self {
        let mut random = ChaCha12Rng::seed_from_u64(seed ^ 0x5E1F_C4EC);
        let mut draw = |line: &table::Drawn| line.draw(&mut random);
        let mut rig = Rig::draw(seed + 1);
        rig.exciter.payload_kg = 0.0;
        let exciter = &rig.exciter;
        let table_kg = draw(&table::TABLE_SHARE) * exciter.moving_mass_kg;
        let table_hz = draw(&table::TABLE_HZ);
        let armature_kg = exciter.moving_mass_kg - table_kg;
        let omega = std::f64::consts::TAU * table_hz;
        let table_n_per_m = omega * omega * table_kg * armature_kg / exciter.moving_mass_kg;
        let equipment = Equipment {
            mass_kg: MASS_KG * (1.0 + draw(&table::MASS_ERROR)),
            seat_n_per_m: draw(&table::SEAT_N_PER_M),
            eccentricity_m: [draw(&table::ECCENTRICITY_M), draw(&table::ECCENTRICITY_M)],
            off_axis_m: draw(&table::REFERENCE_OFF_AXIS_M),
            inertia_kg_m2: draw(&table::ROCKING_INERTIA_KG_M2),
            reference_per_k: draw(&table::REFERENCE_PER_K),
        };
        rig.reciprocity = Some(Reciprocity {
            input: CoilInput::Shunt,
            shunt_ohm: SHUNT_OHM * (1.0 + draw(&table::SHUNT_ERROR)),
            shunt_inductance_h: draw(&table::SHUNT_INDUCTANCE_H),
            divider_volt_per_v: DIVIDER_VOLT_PER_V * (1.0 + draw(&table::DIVIDER_ERROR)),
            divider_corner_hz: draw(&table::DIVIDER_CORNER_HZ),
            mass_kg: 0.0,
            seat_n_per_m: equipment.seat_n_per_m,
            seat_ns_per_m: 0.0,
            table_kg,
            table_n_per_m,
            table_ns_per_m: table_n_per_m / omega / TABLE_QUALITY,
            stray_h: draw(&table::STRAY_H),
            stray_ohm: draw(&table::STRAY_OHM),
            rocking_rel: 0.0,
            rocking_hz: draw(&table::ROCKING_HZ),
            rocking_quality: draw(&table::ROCKING_QUALITY),
        });
        let position = Position {
            inductance_per_m: draw(&table::INDUCTANCE_PER_M),
            force_factor_per_m: draw(&table::FORCE_FACTOR_PER_M),
            force_factor_per_m2: draw(&table::FORCE_FACTOR_PER_M2),
            stiffness_per_m: draw(&table::STIFFNESS_PER_M),
            stiffness_per_m2: draw(&table::STIFFNESS_PER_M2),
        };
        // F = k (x + k1 x^2/2 + k2 x^3/3): what bends at large travel is the same at both loads.
        let cubic_n_per_m3 = rig.exciter.stiffness_n_per_m * position.stiffness_per_m2 / 3.0;
        let bends = [
            format!(
                "lossy_inductance=exponent:{}",
                draw(&table::INDUCTANCE_EXPONENT)
            ),
            format!(
                "force_factor_droop=b2_per_m2:{}",
                position.force_factor_per_m2
            ),
            format!("suspension_cubic=k3_n_per_m3:{cubic_n_per_m3}"),
        ];
        rig.effects = bends
            .iter()
            .filter_map(|effect| effect.parse().ok())
            .collect();
        let stated = Stated {
            mass_kg: MASS_KG,
            shunt_ohm: SHUNT_OHM,
            divider_volt_per_v: DIVIDER_VOLT_PER_V,
        };
        let certificate_error_rel = draw(&table::CERTIFICATE);
        let certificate_error_rad = draw(&table::CERTIFICATE_RAD);
        let warming = Warming {
            kelvin_per_w: draw(&table::KELVIN_PER_W),
            time_constant_s: draw(&table::WARMING_S),
            body_k_per_s: 0.0,
        };
        let reading = Reading {
            ratio_error_rel: draw(&table::RATIO_ERROR),
            crosstalk: draw(&table::CROSSTALK),
            noise_rms_v: draw(&table::INPUT_NOISE_RMS_V),
            floor_rms_ms2: 0.0,
        };
        let first = Self {
            certified_rig: rig.clone(),
            rig,
            stated,
            hold,
            mountings: [Mounting::NONE; 3],
            certificate_error_rel,
            certificate_error_rad,
            temperature_error_rel: 0.0,
            warming,
            reading,
            position,
            equipment,
            seed,
        };
        first.on_another_day(0)
    }

    /// Draws the same calibrator with the same equipment at another check: what differs from day to day is drawn
    /// anew.
    #[must_use]
    pub fn on_another_day(&self, day: u64) -> Self {
        let mut random = ChaCha12Rng::seed_from_u64(self.seed ^ (day + 1).rotate_left(40));
        let mut draw = |line: &table::Drawn| line.draw(&mut random);
        let mut other = self.clone();
        other.warming.body_k_per_s = draw(&table::BODY_K_PER_S);
        other.reading.ratio_error_rel += draw(&table::RATIO_SCATTER);
        other.reading.floor_rms_ms2 = draw(&table::FLOOR_RMS_MS2);
        other.temperature_error_rel = draw(&table::THERMOMETER_K) * self.equipment.reference_per_k;
        for (place, mounting) in other.mountings.iter_mut().enumerate() {
            *mounting = self.mounting(place, &mut draw);
        }
        other
    }

    /// The reference's sensitivity changed by a factor.
    #[must_use]
    pub fn with_reference_changed(mut self, factor: f64) -> Self {
        self.rig.reference.sensitivity_v_per_ms2 *= factor;
        self
    }

    /// Seed for what is drawn while this check is measured.
    pub(super) fn seed(&self) -> u64 {
        self.seed
    }

    fn mounting(&self, place: usize, draw: &mut impl FnMut(&table::Drawn) -> f64) -> Mounting {
        let own = &self.equipment;
        let third = std::f64::consts::TAU / 3.0;
        let angle_rad = third * place as f64 + draw(&table::ANGLE_ERROR_RAD);
        let [x, y] = own.eccentricity_m;
        let turned = x * angle_rad.cos() - y * angle_rad.sin();
        let arm_m = turned + draw(&table::ECCENTRICITY_SCATTER_M);
        let mass_kg = own.mass_kg + draw(&table::GREASE_KG);
        let weight_n = mass_kg * FREE_FALL_MS2;
        let left_n = match self.hold {
            Hold::Current => draw(&table::HOLD_ERROR) * weight_n,
            Hold::None => weight_n,
        };
        Mounting {
            mass_kg,
            seat_n_per_m: own.seat_n_per_m * draw(&table::SEAT_SCATTER).exp(),
            travel_m: draw(&table::CREEP_M) - left_n / self.rig.exciter.stiffness_n_per_m,
            // The torque of the mass over the moment of inertia, at the reference.
            rocking_rel: mass_kg * arm_m * own.off_axis_m / own.inertia_kg_m2,
        }
    }

    /// The rig without a mass or in one of the mountings, its coil warmer than cold.
    pub fn loaded(&self, mounting: Option<usize>, input: CoilInput, coil_warmer_k: f64) -> Rig {
        let mut rig = self.rig.clone();
        rig.exciter.coil_resistance_ohm *= 1.0 + COPPER_PER_K * coil_warmer_k;
        let Some(check) = &mut rig.reciprocity else {
            return rig;
        };
        check.input = input;
        let Some(mounted) = mounting.and_then(|place| self.mountings.get(place)) else {
            return rig;
        };
        check.mass_kg = mounted.mass_kg;
        check.seat_n_per_m = mounted.seat_n_per_m;
        check.seat_ns_per_m = SEAT_LOSS * (mounted.seat_n_per_m * mounted.mass_kg).sqrt();
        check.rocking_rel = mounted.rocking_rel;
        let (at, x) = (&self.position, mounted.travel_m);
        let exciter = &mut rig.exciter;
        exciter.coil_inductance_h *= 1.0 + at.inductance_per_m * x;
        exciter.force_factor_n_per_a *=
            1.0 + at.force_factor_per_m * x - at.force_factor_per_m2 * x * x;
        exciter.stiffness_n_per_m *= 1.0 + at.stiffness_per_m * x + at.stiffness_per_m2 * x * x;
        rig
    }

    /// Current that carries the mass, A.
    pub fn hold_a(&self) -> f64 {
        match self.hold {
            Hold::Current => {
                self.stated.mass_kg * FREE_FALL_MS2 / self.rig.exciter.force_factor_n_per_a
            }
            Hold::None => 0.0,
        }
    }
}

impl Mounting {
    const NONE: Self = Self {
        mass_kg: 0.0,
        seat_n_per_m: 1.0,
        travel_m: 0.0,
        rocking_rel: 0.0,
    };
}
