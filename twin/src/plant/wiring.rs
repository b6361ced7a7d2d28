//! From the values of a rig to the linear network of the plant.

use super::network::{MovingCoil, Network, Signal};
use crate::model::SecondOrder;
use crate::rig::{Rig, Sensing};

/// The linear network of a rig and the signals that leave it.
#[derive(Clone, Debug)]
pub(super) struct Wiring {
    pub(super) network: Network,
    /// Coil current, A.
    pub(super) current: Signal,
    /// Travel of the table, m.
    pub(super) travel: Signal,
    /// Acceleration of the table, m/s2.
    pub(super) acceleration: Signal,
    /// Volts at both input converters: reference, device under test.
    pub(super) converter: [Signal; 2],
}

/// Number of the input that carries the drive, V.
pub(super) const DRIVE_INPUT: usize = 0;

impl Wiring {
    pub(super) fn new(rig: &Rig) -> Self {
        let mut network = Network::default();
        let drive = network.input();
        let converter = &rig.converter;
        let voltage = network.butterworth(
            &drive,
            converter.reconstruction_order,
            converter.reconstruction_hz,
        );
        let coil = network.moving_coil(
            &voltage,
            &Signal::default(),
            &MovingCoil::of(&rig.exciter.model(), 0.0),
        );
        let inputs = [&rig.reference, &rig.dut].map(|sensing| {
            let connector = sense(&mut network, &coil.acceleration, sensing);
            network.butterworth(
                &connector,
                converter.anti_alias_order,
                converter.anti_alias_hz,
            )
        });
        Self {
            network,
            current: coil.current,
            travel: coil.travel,
            acceleration: coil.acceleration,
            converter: inputs,
        }
    }
}

/// Transducer and conditioner: volts at the connector.
fn sense(network: &mut Network, acceleration: &Signal, sensing: &Sensing) -> Signal {
    let gain = sensing.sensitivity_v_per_ms2 * sensing.conditioner_gain;
    let transducer = SecondOrder {
        corner_hz: sensing.resonance_hz,
        quality_factor: sensing.quality_factor,
        numerator: [gain, 0.0, 0.0],
    };
    let charge = network.second_order(acceleration, transducer);
    let coupled = network.high_pass(&charge, sensing.high_pass_hz);
    network.butterworth(&coupled, 2, sensing.low_pass_hz)
}
