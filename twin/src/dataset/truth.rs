//! The rig as it is: nominal within its uncertainties, mounted anew in each run.

use std::collections::HashMap;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;
use rand_distr::{Distribution, StandardNormal};

use super::Setting;
use super::nominal::{Nominal, Quantity};
use crate::effects::ActiveEffect;
use crate::model::{Channel, Conditions, Model};

/// Standard uncertainties a parameter is off at most: more would be a gap by definition.
const FARTHEST_U: f64 = 2.5;

/// The true values of a rig.
pub(super) struct TrueRig {
    values: Nominal,
    /// Gains of reference and device in each run.
    runs: HashMap<usize, [f64; 2]>,
    mounting: ChaCha12Rng,
}

impl TrueRig {
    /// Draws all values; `off_by` replaces the size of each draw.
    pub(super) fn new(nominal: &Nominal, off_by: Option<f64>, random: &mut ChaCha12Rng) -> Self {
        let mut values = nominal.clone();
        let exciter = &mut values.exciter;
        for quantity in [
            &mut values.reference.sensitivity_v_per_ms2,
            &mut values.dut.sensitivity_v_per_ms2,
            &mut exciter.moving_mass_kg,
            &mut exciter.stiffness_n_per_m,
            &mut exciter.damping_ns_per_m,
            &mut exciter.force_factor_n_per_a,
            &mut exciter.coil_resistance_ohm,
            &mut exciter.coil_inductance_h,
        ] {
            settle(quantity, off_by, random);
        }
        Self {
            values,
            runs: HashMap::new(),
            mounting: ChaCha12Rng::seed_from_u64(random.random()),
        }
    }

    /// The rig under `conditions`, with its effects.
    pub(super) fn model(
        &mut self,
        setting: &Setting,
        conditions: &Conditions,
        effects: &[ActiveEffect],
    ) -> Model {
        let [reference_gain, dut_gain] = self.run_gains(setting.run);
        let channel = |sensitivity: Quantity, gain| {
            let mut channel = Channel::flat(sensitivity.value);
            channel.gain = gain;
            channel
        };
        let mut model = Model::new(
            self.values.exciter.model(setting.payload_kg),
            channel(self.values.reference.sensitivity_v_per_ms2, reference_gain),
            channel(self.values.dut.sensitivity_v_per_ms2, dut_gain),
        );
        for effect in effects {
            effect.apply(conditions, &mut model);
        }
        model
    }

    fn run_gains(&mut self, run: usize) -> [f64; 2] {
        let repeatability = self.values.repeatability;
        let mounting = &mut self.mounting;
        *self.runs.entry(run).or_insert_with(|| {
            [repeatability.reference_gain, repeatability.dut_gain].map(|deviation| {
                let unit: f64 = StandardNormal.sample(mounting);
                1.0 + deviation * unit
            })
        })
    }
}

fn settle(quantity: &mut Quantity, off_by: Option<f64>, random: &mut ChaCha12Rng) {
    let unit: f64 = StandardNormal.sample(random);
    let off = match off_by {
        Some(size) => size * unit.signum(),
        None => unit.clamp(-FARTHEST_U, FARTHEST_U),
    };
    quantity.value += off * quantity.u;
}
