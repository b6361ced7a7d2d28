//! S1 over frequency, or why the data speak against the model.

use super::ReciprocityError;
use super::budget::{self, Row};
use super::equipment::Equipment;
use super::model::{self, At, Identified};
use super::runs::{Certified, RatioRow, Runs};
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Where the mechanics are those of a mass on a spring, Hz.
const MECHANICS_HZ: [f64; 2] = [40.0, 400.0];
/// Where the phase shows how warm the coil was, Hz: the difference of the impedances is small there.
const WARMTH_FROM_HZ: f64 = 100.0;
/// By how much the bare calibrator may differ before and after: ten times what a sound one shows.
const BRACKET_REL: f64 = 5e-3;
/// By how much mountings may differ to 315 Hz.
const MOUNTINGS_REL: f64 = 5e-3;
/// By how much the motion may be off that of a mass on a spring.
const MECHANICS_REL: f64 = 0.03;
/// By how much the phase may be off, beside three times its uncertainty, rad.
const PHASE_RAD: f64 = 0.02;
/// By how many standard uncertainties of its own a point may be off what all have in common.
const FLATNESS_U: f64 = 4.5;
/// Less than this is no reason to refuse: it is in U, and the statistic is a mean.
const FLATNESS_REL: f64 = 1e-3;
/// Where the model is held against the data, Hz.
const JUDGED_HZ: [f64; 2] = [50.0, 400.0];

/// S1 at one frequency.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CheckPoint {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Sensitivity of the reference by reciprocity, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// Its phase, degrees.
    pub phase_deg: f64,
    /// Relative expanded uncertainty (k = 2).
    pub expanded_uncertainty_rel: f64,
    /// Expanded uncertainty of the phase (k = 2), degrees.
    pub expanded_uncertainty_phase_deg: f64,
    /// Sensitivity on the certificate, V/(m/s2).
    pub certified_v_per_ms2: f64,
    /// Its relative expanded uncertainty (k = 2).
    pub certified_expanded_uncertainty_rel: f64,
    /// Result over certificate, less 1.
    pub change_rel: f64,
}

/// Result of a check.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Evaluation {
    /// Each frequency.
    pub points: Vec<CheckPoint>,
    /// The budget: each row with its standard uncertainty at each frequency, signed where it is one quantity.
    pub budget: Vec<Row>,
    /// The exciter.
    pub exciter: Identified,
    /// With what it was found.
    pub equipment: Equipment,
    /// Temperature of the calibrator, degrees Celsius; sensitivities are those at that of the certificate.
    #[serde(default)]
    pub temperature_c: Option<f64>,
    /// The ratio of the channels it was found with; empty where nobody measured it.
    #[serde(default)]
    pub ratio: Vec<RatioRow>,
}

/// Evaluates a check.
///
/// # Errors
/// [`ReciprocityError`] where the data speak against the model.
///
/// # Accuracy
/// `./run bench selfcheck`; test `a_calibrator_by_hand_gives_its_sensitivity`.
pub fn evaluate(runs: &Runs, equipment: &Equipment) -> Result<Evaluation, ReciprocityError> {
    let points: Vec<At> = (0..runs.len())
        .map(|index| At::new(runs, index, equipment))
        .collect();
    check_loads(&points)?;
    let exciter = identified(&points, &runs.certified, equipment)?;
    let mut budget = budget::rows(&points, &runs.certified, equipment, &exciter);
    let [warmer_rel, _] = equipment.by_temperature_rel(runs.temperature_c);
    budget.push(budget::by_temperature(
        equipment,
        runs.temperature_c,
        points.len(),
    ));
    let expanded = budget::expanded_rel(&budget, points.len());
    let of = |(index, at): (usize, &At)| {
        let known = runs.certified[index];
        let square = square(at, equipment, exciter.warmer_ohm) * turned_back(&known);
        let sensitivity = square.re.max(0.0).sqrt() / (1.0 + warmer_rel);
        let phase_rad = known.phase_rad + square.arg() / 2.0;
        CheckPoint {
            frequency_hz: at.frequency_hz,
            sensitivity_v_per_ms2: sensitivity,
            phase_deg: phase_rad.to_degrees(),
            expanded_uncertainty_rel: expanded[index],
            expanded_uncertainty_phase_deg: (2.0 * budget::phase_standard_rad(at, equipment))
                .to_degrees(),
            certified_v_per_ms2: known.sensitivity_v_per_ms2,
            certified_expanded_uncertainty_rel: known.expanded_uncertainty_rel,
            change_rel: sensitivity / known.sensitivity_v_per_ms2 - 1.0,
        }
    };
    let evaluation = Evaluation {
        points: points.iter().enumerate().map(of).collect(),
        budget,
        exciter,
        equipment: *equipment,
        temperature_c: runs.temperature_c,
        ratio: runs.ratio.clone(),
    };
    check_phase(&evaluation, &runs.certified)?;
    check_flatness(&evaluation)?;
    Ok(evaluation)
}

/// `S1^2`, the coil being warmer with the mass by a resistance, (V/(m/s2))^2.
fn square(at: &At, equipment: &Equipment, warmer_ohm: f64) -> Complex64 {
    let mass_kg = model::mass_felt_kg(equipment, at.omega());
    let difference = at.difference() - warmer_ohm;
    -mass_kg * at.bare.r * at.loaded.r / (Complex64::new(0.0, at.omega()) * difference)
}

/// Turns the square of a sensitivity of the certified phase onto the real axis.
fn turned_back(known: &Certified) -> Complex64 {
    Complex64::from_polar(1.0, -2.0 * known.phase_rad)
}

/// Steps of the fit: the first is off by the square of what the resistance turns, the third by 1e-4 of it.
const WARMTH_STEPS: usize = 4;

/// By how much the coil was warmer with the mass: what takes the quadrature out of `S1^2` by least squares.
///
/// # Equation
/// With the difference of the impedances D, `S1^2 (1 + d/D)`: where D is imaginary, above the resonance, a
/// resistance d turns `S1^2` and does not change it, and near the resonance it does.
fn warmer_ohm(points: &[At], certified: &[Certified], equipment: &Equipment) -> f64 {
    (0..WARMTH_STEPS).fold(0.0, |warmer_ohm, _| {
        warmer_ohm + still_warmer_ohm(points, certified, equipment, warmer_ohm)
    })
}

fn still_warmer_ohm(
    points: &[At],
    certified: &[Certified],
    equipment: &Equipment,
    warmer_ohm: f64,
) -> f64 {
    let (mut sum, mut weight) = (0.0, 0.0);
    for (at, known) in points.iter().zip(certified) {
        if at.frequency_hz < WARMTH_FROM_HZ {
            continue;
        }
        let square = square(at, equipment, warmer_ohm) * turned_back(known);
        let turn = (square / square.norm() / (at.difference() - warmer_ohm)).im;
        let noise = budget::noise_variance(at, Complex64::new(0.0, 1.0)) + 1e-6;
        sum -= square.im / square.norm() * turn / noise;
        weight += turn * turn / noise;
    }
    if weight > 0.0 { sum / weight } else { 0.0 }
}

fn check_loads(points: &[At]) -> Result<(), ReciprocityError> {
    for at in points {
        let [before, after] = at.before_after;
        let changed = (after.r / before.r - 1.0).norm();
        if changed.is_nan() || changed > BRACKET_REL {
            return Err(ReciprocityError::Bracket {
                frequency_hz: at.frequency_hz,
                change_percent: 100.0 * (after.r.norm() / before.r.norm() - 1.0),
            });
        }
        let off = |mounting: &model::Load| (mounting.r / at.loaded.r - 1.0).norm();
        let spread = at.mountings.iter().map(off).fold(0.0, f64::max);
        if at.frequency_hz <= 330.0 && (spread.is_nan() || spread > MOUNTINGS_REL) {
            return Err(ReciprocityError::Mountings {
                frequency_hz: at.frequency_hz,
                spread_percent: 100.0 * spread,
            });
        }
    }
    Ok(())
}

fn identified(
    points: &[At],
    certified: &[Certified],
    equipment: &Equipment,
) -> Result<Identified, ReciprocityError> {
    let [from_hz, to_hz] = MECHANICS_HZ;
    let within = |at: &&At| (from_hz..=to_hz).contains(&at.frequency_hz);
    let within: Vec<&At> = points.iter().filter(within).collect();
    let off = |frequency_hz: f64, residual: f64| ReciprocityError::Mechanics {
        frequency_hz,
        residual_percent: 100.0 * residual,
    };
    let found = model::identify(&within, equipment);
    let ([moving_mass_kg, stiffness_n_per_m, damping_ns_per_m], [residual, worst_hz]) =
        found.ok_or_else(|| off(from_hz, f64::INFINITY))?;
    if !(residual <= MECHANICS_REL && moving_mass_kg > 0.0) {
        return Err(off(worst_hz, residual));
    }
    let squares = within
        .iter()
        .map(|at| model::force_factor_squared(at, equipment).re);
    let square = squares.sum::<f64>() / within.len().max(1) as f64;
    let force_factor_n_per_a = square.max(0.0).sqrt();
    Ok(Identified {
        moving_mass_kg,
        stiffness_n_per_m,
        damping_ns_per_m,
        force_factor_n_per_a,
        hold_a: equipment.mass_kg * budget::FREE_FALL_MS2 / force_factor_n_per_a,
        warmer_ohm: warmer_ohm(points, certified, equipment),
    })
}

fn is_judged(point: &CheckPoint) -> bool {
    (JUDGED_HZ[0]..=JUDGED_HZ[1]).contains(&point.frequency_hz)
}

fn check_phase(evaluation: &Evaluation, certified: &[Certified]) -> Result<(), ReciprocityError> {
    for (point, known) in evaluation.points.iter().zip(certified) {
        let off_deg = point.phase_deg - known.phase_rad.to_degrees();
        let allowed_deg = 1.5 * point.expanded_uncertainty_phase_deg + PHASE_RAD.to_degrees();
        if is_judged(point) && (off_deg.is_nan() || off_deg.abs() > allowed_deg) {
            return Err(ReciprocityError::Phase {
                frequency_hz: point.frequency_hz,
                phase_deg: off_deg,
            });
        }
    }
    Ok(())
}

/// Whether what differs from frequency to frequency is within its uncertainty: the reference changes as a whole.
fn check_flatness(evaluation: &Evaluation) -> Result<(), ReciprocityError> {
    let judged: Vec<usize> = (0..evaluation.points.len())
        .filter(|index| is_judged(&evaluation.points[*index]))
        .collect();
    let count = judged.len().max(1) as f64;
    let deviation = |index: &usize| evaluation.points[*index].change_rel;
    let mean = judged.iter().map(deviation).sum::<f64>() / count;
    let means = budget::means(&evaluation.budget, &judged);
    for index in &judged {
        let off = deviation(index) - mean;
        let own = budget::from_mean_standard_rel(&evaluation.budget, &means, &judged, *index);
        let allowed = (FLATNESS_U * own).max(FLATNESS_REL);
        if off.is_nan() || off.abs() > allowed {
            return Err(ReciprocityError::Flatness {
                frequency_hz: evaluation.points[*index].frequency_hz,
                spread_percent: 100.0 * off,
            });
        }
    }
    Ok(())
}
