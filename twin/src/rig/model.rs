//! The model of a rig: its linear elements, ready for effects.

use super::{Rig, Sensing};
use crate::model::{Channel, Conditions, Model, SecondOrder, Section};

impl Rig {
    /// The calibrator these values describe, with its effects.
    pub fn model(&self) -> Model {
        let mut model = Model::new(
            self.exciter.model(),
            self.reference.model(),
            self.dut.model(),
        );
        model.reciprocity = self.reciprocity;
        for effect in &self.effects {
            effect.apply(&self.conditions(), &mut model);
        }
        model
    }

    /// The conditions under which it works.
    pub fn conditions(&self) -> Conditions {
        self.surroundings.conditions(self.exciter.payload_kg)
    }
}

impl Sensing {
    /// Transducer, high-pass and low-pass of this channel.
    fn model(&self) -> Channel {
        let mut channel = Channel::flat(self.sensitivity_v_per_ms2 * self.conditioner_gain);
        // A second-order Butterworth low-pass has Q = 1/sqrt(2).
        let low_pass = SecondOrder::low_pass(self.low_pass_hz, std::f64::consts::FRAC_1_SQRT_2);
        channel.response = vec![
            Section::SecondOrder(SecondOrder::low_pass(
                self.resonance_hz,
                self.quality_factor,
            )),
            Section::HighPass(self.high_pass_hz),
            Section::SecondOrder(low_pass),
        ];
        channel
    }
}
