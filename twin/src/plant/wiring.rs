//! From a model to the linear network of the plant.

use super::network::{MovingCoil, Network, Signal};
use super::realise::realise;
use crate::model::{Channel, Model, Section};
use crate::rig::Converter;

/// The linear network of a model and the signals that leave it.
///
/// Nonlinear terms act as further inputs. Each is a state whose rate is an input: held over a step,
/// the rate lets the term change linearly, and the state can be set to the term itself.
#[derive(Clone, Debug)]
pub(super) struct Wiring {
    pub(super) network: Network,
    /// Demand at the amplifier, V.
    pub(super) demand: Signal,
    /// Coil current, A.
    pub(super) current: Signal,
    /// Velocity of the armature, m/s.
    pub(super) velocity: Signal,
    /// Travel of the armature, m.
    pub(super) travel: Signal,
    /// Acceleration of the table, m/s2.
    pub(super) acceleration: Signal,
    /// Acceleration of the mounting faces before any separation, m/s2.
    pub(super) faces: [Signal; 2],
    /// Volts at both input converters: reference, device under test.
    pub(super) converter: [Signal; 2],
    /// States that hold the nonlinear terms, if there are any.
    pub(super) terms: Option<[Signal; TERMS]>,
}

/// Number of the input that carries the drive, V.
pub(super) const DRIVE_INPUT: usize = 0;
/// Number of the input that carries the motion of the base, m/s2.
pub(super) const BASE_INPUT: usize = 1;
/// Number of the input that carries dry friction, N.
pub(super) const FRICTION_INPUT: usize = 2;
/// Number of the first input that carries the rate of a term.
pub(super) const RATE_INPUT: usize = 3;

/// Nonlinear terms: voltage at the coil, force on the armature, motion of either face.
pub(super) const TERMS: usize = 4;
pub(super) const VOLTAGE_TERM: usize = 0;
pub(super) const FORCE_TERM: usize = 1;
pub(super) const FACE_TERMS: [usize; 2] = [2, 3];

impl Wiring {
    pub(super) fn new(model: &Model, converter: &Converter, time_s: f64, nonlinear: bool) -> Self {
        let mut network = Network::default();
        let drive = network.input();
        let base = network.input();
        let friction = network.input();
        let terms = nonlinear.then(|| {
            std::array::from_fn(|_| {
                let rate = network.input();
                network.integral(&rate)
            })
        });
        let silence: [Signal; TERMS] = std::array::from_fn(|_| Signal::default());
        let term = terms.as_ref().unwrap_or(&silence);
        let demand = network.butterworth(
            &drive,
            converter.reconstruction_order,
            converter.reconstruction_hz,
        );
        let voltage = demand.clone().plus(1.0, &term[VOLTAGE_TERM]);
        let force = friction.plus(1.0, &term[FORCE_TERM]);
        let coil = network.moving_coil(&voltage, &force, &MovingCoil::of(&model.coil, time_s));
        let table = chain(&mut network, &model.table, &coil.acceleration, &coil.travel);
        let shaken = table.clone().plus(1.0, &base);
        let channels = [&model.reference, &model.dut];
        let advances = channels.map(advance_s);
        let mut faces = Vec::with_capacity(2);
        let mut inputs = Vec::with_capacity(2);
        for (index, channel) in channels.into_iter().enumerate() {
            let face = chain(&mut network, &channel.motion, &shaken, &coil.travel);
            let moved = face.clone().plus(1.0, &term[FACE_TERMS[index]]);
            faces.push(face);
            let felt = moved.scaled(channel.sensitivity_v_per_ms2 * channel.gain);
            let volt = chain(&mut network, &channel.response, &felt, &coil.travel);
            // What the other channel is early, this one is late.
            let late = Section::Delay(advances[1 - index]);
            let volt = realise(&mut network, &late, &volt, &coil.travel);
            let volt = match converter.common_source {
                Some(source) => demand.clone().scaled(source.gains()[index]),
                None => volt,
            };
            inputs.push(input(&mut network, converter, index, &volt));
        }
        let two =
            |mut list: Vec<Signal>| std::array::from_fn(|index| std::mem::take(&mut list[index]));
        Self {
            demand,
            current: coil.current,
            velocity: coil.velocity,
            travel: coil.travel,
            acceleration: table,
            faces: two(faces),
            converter: two(inputs),
            terms,
            network,
        }
    }
}

/// From the connector of a channel to its converter.
fn input(network: &mut Network, converter: &Converter, channel: usize, volt: &Signal) -> Signal {
    let order = converter.anti_alias_order;
    if channel == 0 {
        return network.butterworth(volt, order, converter.anti_alias_hz);
    }
    let late = Section::Delay(converter.dut_delay_s);
    let volt = realise(network, &late, volt, &Signal::default());
    let corner_hz = converter.anti_alias_hz * (1.0 + converter.dut_corner_excess_rel);
    network.butterworth(&volt, order, corner_hz)
}

fn chain(network: &mut Network, sections: &[Section], input: &Signal, travel: &Signal) -> Signal {
    sections.iter().fold(input.clone(), |signal, section| {
        realise(network, section, &signal, travel)
    })
}

/// By how much the pure delays of a channel are negative, s.
fn advance_s(channel: &Channel) -> f64 {
    let advance = |section: &Section| match section {
        Section::Delay(delay_s) => (-delay_s).max(0.0),
        _ => 0.0,
    };
    channel.response.iter().map(advance).sum()
}
