//! Dry friction beyond the orders that are carried: its force jumps where the armature turns, and the
//! orders of a jump fall as slowly as 1/n.

use super::spectrum::HARMONICS;
use super::{Channel, Point};
use nalgebra::Complex;
use std::f64::consts::{PI, TAU};

/// Highest order that is summed: beyond it are 3 parts in 10 000 of the power of all.
const SUMMED: usize = 1_999;

impl Point<'_> {
    /// Mean square of those orders at a channel's converter, V^2. The force `4 F/(pi n)` of a square
    /// wave moves what the linear terms of the exciter let move; a converter that samples folds them
    /// back, with their power.
    pub(super) fn dry_beyond_v2(&self, channel: &Channel) -> f64 {
        let coil = &self.model.coil;
        if coil.friction_n == 0.0 {
            return 0.0;
        }
        let first = HARMONICS + 1 - HARMONICS % 2;
        let orders = (first..=SUMMED).step_by(2);
        let gain = channel.sensitivity_v_per_ms2 * channel.gain;
        let peaks = orders.map(|order| {
            let force_n = 4.0 * coil.friction_n / (PI * order as f64);
            let sections = [&self.model.table, &channel.motion, &channel.response];
            let way = sections.map(|sections| self.response(sections, order));
            gain * force_n * self.acceleration_per_n(order) * way.iter().product::<Complex<f64>>()
        });
        0.5 * peaks.map(|peak| peak.norm_sqr()).sum::<f64>()
    }

    /// Response to a force on the armature, (m/s2)/N: a voltage makes the force `Bl/Z` of it.
    fn acceleration_per_n(&self, order: usize) -> Complex<f64> {
        let (coil, time_s) = (&self.model.coil, self.conditions.time_s);
        let omega = TAU * self.frequency_hz * order as f64;
        let [_, travel_per_v] = coil.linear_response(omega, time_s);
        let force_per_v = coil.force_factor_n_per_a / coil.blocked_impedance(omega, time_s);
        -omega * omega * travel_per_v / force_per_v
    }
}
