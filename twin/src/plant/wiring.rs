//! From a model to the linear network of the plant.

use super::network::{Carried, CoilSignals, MovingCoil, Network, Signal};
use super::realise::realise;
use crate::model::{Channel, CoilInput, Model, Reciprocity, SecondOrder, Section};
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
    /// Velocity of the armature from the body, m/s.
    pub(super) velocity: Signal,
    /// Travel of the armature from the body, m.
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
        let check = model.reciprocity.as_ref();
        let coil = moving_coil(model, time_s);
        let coil = network.moving_coil(&voltage, &force, &coil);
        let table = table_of(check, &coil);
        let table = chain(&mut network, &model.table, &table, &coil.position);
        let shaken = table.clone().plus(1.0, &base);
        let channels = [&model.reference, &model.dut];
        let advances = channels.map(advance_s);
        let mut faces = Vec::with_capacity(2);
        let mut inputs = Vec::with_capacity(2);
        for (index, channel) in channels.into_iter().enumerate() {
            let mut face = chain(&mut network, &channel.motion, &shaken, &coil.position);
            if let (0, Some(check)) = (index, check) {
                face = network.second_order(&face, rocking(check));
            }
            let moved = face.clone().plus(1.0, &term[FACE_TERMS[index]]);
            faces.push(face);
            let felt = moved.scaled(channel.sensitivity_v_per_ms2 * channel.gain);
            let volt = chain(&mut network, &channel.response, &felt, &coil.position);
            // What the other channel is early, this one is late.
            let late = Section::Delay(advances[1 - index]);
            let volt = realise(&mut network, &late, &volt, &coil.position);
            let volt = match converter.common_source {
                Some(source) => demand.clone().scaled(source.gains()[index]),
                None => volt,
            };
            let volt = match check {
                Some(check) => sensed(&mut network, check, index, &volt, &demand, &coil),
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

/// The coil with what it carries and the shunt in its circuit.
fn moving_coil(model: &Model, time_s: f64) -> MovingCoil {
    let mut coil = MovingCoil::of(&model.coil, time_s);
    let Some(check) = &model.reciprocity else {
        return coil;
    };
    coil.resistance_ohm += check.shunt_ohm;
    coil.ladder.inductance_h += check.shunt_inductance_h;
    coil.mass_kg -= check.table_kg;
    let table = Carried {
        mass_kg: check.table_kg,
        stiffness_n_per_m: check.table_n_per_m,
        damping_ns_per_m: check.table_ns_per_m,
    };
    let mass = Carried {
        mass_kg: check.mass_kg,
        stiffness_n_per_m: check.seat_n_per_m,
        damping_ns_per_m: check.seat_ns_per_m,
    };
    coil.carried = [table, mass]
        .into_iter()
        .filter(|one| one.mass_kg > 0.0)
        .collect();
    coil
}

/// Acceleration of the table: that of the armature where it is rigid.
fn table_of(check: Option<&Reciprocity>, coil: &CoilSignals) -> Signal {
    match (check, coil.carried.first()) {
        (Some(check), Some(table)) if check.table_kg > 0.0 => table.clone(),
        _ => coil.acceleration.clone(),
    }
}

fn rocking(check: &Reciprocity) -> SecondOrder {
    SecondOrder {
        corner_hz: check.rocking_hz,
        quality_factor: check.rocking_quality,
        numerator: [1.0, 1.0 / check.rocking_quality, 1.0 + check.rocking_rel],
    }
}

/// Volts at a connector while the reference is checked: the coil's field reaches the reference's, and the
/// device's reads the coil. The amplifier is taken as linear.
fn sensed(
    network: &mut Network,
    check: &Reciprocity,
    channel: usize,
    volt: &Signal,
    coil_v: &Signal,
    coil: &CoilSignals,
) -> Signal {
    match (channel, check.input) {
        (0, _) => volt
            .clone()
            .plus(check.stray_ohm, &coil.current)
            .plus(check.stray_h, &coil.current_rate),
        (_, CoilInput::Shunt) => coil
            .current
            .scaled(check.shunt_ohm)
            .plus(check.shunt_inductance_h, &coil.current_rate),
        (_, CoilInput::Divider) => {
            let divided = coil_v.scaled(check.divider_volt_per_v);
            network.low_pass(&divided, check.divider_corner_hz)
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
