//! Nonlinear terms of the plant: what the linear network leaves out.

use crate::model::{Model, Separation};

use super::wiring::{FACE_TERMS, FORCE_TERM, TERMS, VOLTAGE_TERM};

/// State the terms depend on, at one instant.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Instant {
    /// Since the model's own time, s.
    pub(super) elapsed_s: f64,
    pub(super) demand_v: f64,
    pub(super) current_a: f64,
    pub(super) velocity_ms: f64,
    pub(super) travel_m: f64,
    pub(super) faces_ms2: [f64; 2],
}

/// Mean squares over the recent past.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub(super) struct Levels {
    /// Demand, V2.
    pub(super) demand_v2: f64,
    /// Motion of either face, (m/s2)2.
    pub(super) faces_m2s4: [f64; 2],
}

/// Time over which levels are taken, s: longer than the period of the lowest frequency.
const LEVEL_TIME_S: f64 = 0.5;

impl Levels {
    /// Takes one more sample of `interval_s`.
    pub(super) fn take(&mut self, at: &Instant, interval_s: f64) {
        let share = interval_s / LEVEL_TIME_S;
        let follow = |level: &mut f64, value: f64| *level += share * (value * value - *level);
        follow(&mut self.demand_v2, at.demand_v);
        for (level, face) in self.faces_m2s4.iter_mut().zip(at.faces_ms2) {
            follow(level, face);
        }
    }
}

/// The nonlinear and time-varying terms of a model.
#[derive(Clone, Debug)]
pub(super) struct Bends {
    model: Model,
    start_s: f64,
    cold_ohm: f64,
}

impl Bends {
    /// The terms of `model`, or `None` if it is linear and does not change with time.
    pub(super) fn of(model: &Model, start_s: f64) -> Option<Self> {
        let coil = &model.coil;
        let channels = [&model.reference, &model.dut];
        let linear = coil.is_linear()
            && coil.rise_k == 0.0
            && coil.static_force_n == 0.0
            && model.amplifier.is_linear()
            && model.amplifier.drift_per_s == 0.0
            && channels
                .iter()
                .all(|channel| channel.separation.is_none() && channel.level_second_per_ms2 == 0.0);
        (!linear).then(|| Self {
            model: model.clone(),
            start_s,
            cold_ohm: coil.warm_resistance_ohm(start_s),
        })
    }

    /// Dry friction of the armature, N.
    pub(super) fn friction_n(&self) -> f64 {
        self.model.coil.friction_n
    }

    /// All terms at one instant.
    pub(super) fn terms(&self, at: &Instant, levels: &Levels) -> [f64; TERMS] {
        let mut terms = [0.0; TERMS];
        let coil = &self.model.coil;
        let square = at.travel_m * at.travel_m;
        let lost = coil.force_factor_n_per_a * coil.droop_per_m2 * square;
        terms[VOLTAGE_TERM] = self.amplifier_v(at, levels) + coil.emf_ratio * lost * at.velocity_ms
            - self.heating_ohm(at.elapsed_s) * at.current_a;
        terms[FORCE_TERM] = coil.static_force_n
            - lost * at.current_a
            - square * (coil.quadratic_n_per_m2 + coil.cubic_n_per_m3 * at.travel_m);
        for (index, channel) in [&self.model.reference, &self.model.dut]
            .into_iter()
            .enumerate()
        {
            let face = at.faces_ms2[index];
            let separated = channel.separation.map_or(0.0, |separation: Separation| {
                separation.motion_ms2(face) - face
            });
            // sqrt(2) p (a^2 - mean a^2) has the second harmonic p A_rms over the fundamental.
            let bent = std::f64::consts::SQRT_2
                * channel.level_second_per_ms2
                * (face * face - levels.faces_m2s4[index]);
            terms[FACE_TERMS[index]] = separated + bent;
        }
        terms
    }

    /// Output of the amplifier beside the demand, V.
    pub(super) fn amplifier_v(&self, at: &Instant, levels: &Levels) -> f64 {
        let amplifier = &self.model.amplifier;
        let gain = 1.0 + amplifier.drift_per_s * (self.start_s + at.elapsed_s);
        // The output is a.c. coupled: the mean of the even part does not pass.
        let mean_v = amplifier.even_per_v * levels.demand_v2;
        amplifier.output_v(at.demand_v * gain) - mean_v - at.demand_v
    }

    fn heating_ohm(&self, elapsed_s: f64) -> f64 {
        self.model
            .coil
            .warm_resistance_ohm(self.start_s + elapsed_s)
            - self.cold_ohm
    }
}
