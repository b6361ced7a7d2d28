//! Another device under test on another exciter, by seed.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

use super::Rig;

/// Draws values around those of the standard rig.
struct Spread(ChaCha12Rng);

impl Spread {
    /// Multiplies by a factor evenly distributed on a logarithmic scale from `1/ratio` to `ratio`.
    fn scale(&mut self, value: &mut f64, ratio: f64) {
        *value *= ratio.powf(self.0.random_range(-1.0..=1.0));
    }

    fn between(&mut self, value: &mut f64, lowest: f64, highest: f64) {
        *value = self.0.random_range(lowest..=highest);
    }
}

impl Rig {
    /// A rig of the standard kind with its own device under test, exciter and noise.
    ///
    /// Seed 0 is the standard rig. The reference stays, since it is the reference: what changes is
    /// the payload and the device on it (sensitivity 10 mV/(m/s2) within 20 %, resonance 30 kHz to
    /// 45 kHz, Q 20 to 30, corner frequencies of its conditioner), the exciter within 10 % to 20 %
    /// of its nominal values, and the offsets.
    pub fn draw(seed: u64) -> Self {
        let mut rig = Self::standard();
        if seed == 0 {
            return rig;
        }
        let mut spread = Spread(ChaCha12Rng::seed_from_u64(seed));
        rig.name = format!("{} {seed}", rig.name);
        rig.noise_seed = seed >> 1;
        rig.converter.unit = seed >> 1;
        spread.dut(&mut rig);
        spread.exciter(&mut rig);
        rig
    }
}

impl Spread {
    fn dut(&mut self, rig: &mut Rig) {
        let dut = &mut rig.dut;
        self.scale(&mut dut.sensitivity_v_per_ms2, 1.2);
        self.between(&mut dut.resonance_hz, 30e3, 45e3);
        self.between(&mut dut.quality_factor, 20.0, 30.0);
        self.between(&mut dut.high_pass_hz, 0.1, 0.3);
        self.scale(&mut dut.low_pass_hz, 1.2);
        self.between(&mut dut.offset_v, -0.005, 0.005);
        self.between(&mut rig.reference.offset_v, -0.005, 0.005);
    }

    fn exciter(&mut self, rig: &mut Rig) {
        let exciter = &mut rig.exciter;
        self.between(&mut exciter.payload_kg, 0.010, 0.030);
        self.scale(&mut exciter.moving_mass_kg, 1.05);
        self.scale(&mut exciter.stiffness_n_per_m, 1.2);
        self.scale(&mut exciter.damping_ns_per_m, 1.5);
        self.scale(&mut exciter.force_factor_n_per_a, 1.1);
        self.scale(&mut exciter.coil_resistance_ohm, 1.1);
        self.scale(&mut exciter.coil_inductance_h, 1.1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_draw_is_a_valid_rig_and_repeats() {
        for seed in (0..500).chain([u64::MAX]) {
            let rig = Rig::draw(seed);
            let text = rig.to_toml().expect("plain numbers");
            assert_eq!(Rig::parse(&text, "draw").expect("valid"), rig);
            assert_eq!(Rig::draw(seed), rig);
        }
        assert_ne!(Rig::draw(1).dut, Rig::draw(2).dut);
    }
}
