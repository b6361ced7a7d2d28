//! Measured points of a calibrator with effects.

use rand::SeedableRng;
use rand_chacha::ChaCha12Rng;

use super::Setting;
use super::nominal::Nominal;
use super::observe::{Instrument, Uncertainties};
use super::point::{Columns, Point};
use super::truth::TrueRig;
use crate::effects::ActiveEffect;
use crate::model::Conditions;
use crate::steady::Solver;

/// How a dataset is made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Seed of everything random.
    pub seed: u64,
    /// Columns that are kept.
    pub columns: Columns,
    /// Random part of each row.
    pub uncertainties: Uncertainties,
    /// If stated, each nominal parameter is off by this many of its standard uncertainties, with a
    /// random sign; else by a normal draw of at most 2.5.
    pub parameters_off_by: Option<f64>,
}

/// Measured values.
#[derive(Clone, Debug, PartialEq)]
pub struct Generated {
    /// Points in the order of their settings.
    pub points: Vec<Point>,
    /// Settings at which the rig could not be held, or a harmonic was above 0.3.
    pub left_out: usize,
}

/// Largest relative harmonic of a row.
const LARGEST_HARMONIC: f64 = 0.3;

/// Measures the points of `design` on a rig that is `nominal` within its uncertainties and has
/// `effects`.
pub fn generate(
    nominal: &Nominal,
    design: &[Setting],
    effects: &[ActiveEffect],
    options: &Options,
) -> Generated {
    let mut random = ChaCha12Rng::seed_from_u64(options.seed);
    let mut rig = TrueRig::new(nominal, options.parameters_off_by, &mut random);
    let mut instrument = Instrument::new(nominal, options.uncertainties, random);
    let solver = Solver::default();
    let measure = |(index, setting): (usize, &Setting)| {
        instrument.begin_row(index);
        let conditions = conditions(nominal, setting);
        let model = rig.model(setting, &conditions, effects);
        let level_v = setting.level_ms2 * nominal.reference.sensitivity_v_per_ms2.value;
        let held = solver.hold(&model, &conditions, setting.frequency_hz, level_v);
        let mut point = instrument.observe(&model, setting, &held.ok()?);
        if model.amplifier.drift_per_s != 0.0 {
            // Nothing at the coil is measured then: the demanded voltage stands for its voltage.
            Columns::NoCurrent.restrict(&mut point);
        }
        is_usable(&point).then(|| {
            options.columns.restrict(&mut point);
            point
        })
    };
    let points: Vec<Point> = design.iter().enumerate().filter_map(measure).collect();
    Generated {
        left_out: design.len() - points.len(),
        points,
    }
}

fn conditions(nominal: &Nominal, setting: &Setting) -> Conditions {
    Conditions {
        time_s: setting.time_s,
        warmer_k: setting.temperature_c - nominal.environment.reference_temperature_c,
        rotation_rad: setting.rotation_deg.to_radians(),
        tilt_rad: setting.tilt_deg.to_radians(),
        payload_kg: setting.payload_kg,
        mains_hz: nominal.environment.mains_hz,
    }
}

fn is_usable(point: &Point) -> bool {
    let channels = [point.ref_harmonics, point.dut_harmonics];
    let mut harmonics = channels.iter().flatten().flatten();
    harmonics.all(|harmonic| harmonic.amplitude <= LARGEST_HARMONIC)
}
