// Copyright (c) 2026 Rigless Labs.
// SPDX-License-Identifier: MIT OR Apache-2.0
//! The unit flown in a closed loop: a rigid 3U with three wheels on a 500 km sun-synchronous orbit,
//! under its magnetorquers, its wheels and the gravity gradient, in a tilted dipole's field, with
//! the unit sensing it once a second. The orbit is SGP4's from a set of elements, which the ground
//! uploads as they are or with its drag left out.

use super::*;
use crate::device::{DeviceContext, Effects};
use crate::soc::Peripheral;

const PERIPHERAL: Peripheral = Peripheral {
    name: "flight",
    base: 0,
    size: 0,
    interrupts: &[],
    registers: &[],
};

/// 2026-10-22T00:00:00Z: GPS week 2441, 345,618,000 ms, and the same instant as an element set's
/// epoch.
const WEEK: u16 = 2441;
const TIME_OF_WEEK: u32 = 345_618_000;
const EPOCH: f64 = 26_295.0;
/// A 500 km sun-synchronous orbit, the plant's default.
pub(super) const ELEMENTS: Elements = Elements {
    inclination: 97.4,
    eccentricity: 0.0001,
    node: 0.0,
    perigee: 90.0,
    bstar: 0.0,
    mean_motion: 15.22,
    mean_anomaly: 0.0,
};
const INERTIA: [f64; 3] = [0.035, 0.035, 0.007];
const MU: f64 = 3.986_004_418e14;
/// The field's dipole: 30 µT at the equator's surface, tilted 10° from the south pole.
const DIPOLE: [f64; 3] = [0.06, -0.17, -0.98];
const SURFACE_FIELD: f64 = 3.0e-5;
const EARTH_RADIUS: f64 = 6_378_137.0;
const SUBSTEPS: u32 = 10;
/// The wheels' own speed loop, which brings a wheel to its command in about a tenth of a second.
const WHEEL_LOOP: f64 = 0.1;

pub(super) struct Flight {
    pub(super) unit: Unit,
    effects: Effects,
    truth: Sgp4,
    /// Shuster's inertial-to-body quaternion, the same numbers as Hamilton's body-to-inertial.
    pub(super) attitude: [f64; 4],
    pub(super) rate: [f64; 3],
    pub(super) wheels: [f64; 3],
    pub(super) seconds: u32,
}

/// Inertial position and velocity in meters, at `seconds` after the epoch.
fn place(model: &Sgp4, seconds: u32) -> ([f64; 3], [f64; 3]) {
    let (position, velocity) = model
        .propagate(f64::from(seconds) / 60.0)
        .expect("a day of a 500 km orbit");
    (
        position.map(|km| km * 1000.0),
        velocity.map(|km| km * 1000.0),
    )
}

impl Flight {
    /// The spacecraft on the orbit `truth` gives, at rest on the inertial axes but turning at
    /// `rate`, the unit's loop running at 1 Hz.
    pub(super) fn new(truth: &Elements, rate: [f64; 3]) -> Self {
        let mut flight = Self {
            unit: Unit::new(),
            effects: Effects::default(),
            truth: Sgp4::new(truth).expect("a near-Earth set"),
            attitude: [1.0, 0.0, 0.0, 0.0],
            rate,
            wheels: [0.0; 3],
            seconds: 0,
        };
        flight.unit.set_epoch(WEEK, TIME_OF_WEEK);
        flight.unit.set_satellites(10);
        flight.sense();
        flight.send(RUN_MODE, &[LOOP_AT_1_HZ]);
        flight
    }

    /// Sends telecommand `id` with `parameters` and gives its error.
    pub(super) fn send(&mut self, id: u8, parameters: &[u8]) -> u8 {
        let mut frame = vec![ESCAPE, START];
        for &byte in std::iter::once(&id).chain(parameters) {
            frame.push(byte);
            if byte == ESCAPE {
                frame.push(ESCAPE);
            }
        }
        frame.extend([ESCAPE, END]);
        let now = VirtualNanos(u64::from(self.seconds) * CONTROL_PERIOD);
        let mut context = DeviceContext::new(now, 0, PERIPHERAL, &mut self.effects);
        let mut timeline = Timeline::new(&mut context);
        for byte in frame {
            self.unit.receive(u16::from(byte), &mut timeline);
        }
        let reply: Vec<u16> = std::iter::from_fn(|| self.unit.transmit(now)).collect();
        u8::try_from(reply[3]).expect("a byte")
    }

    /// Uploads `elements` as the SGP4 orbit (45).
    pub(super) fn upload(&mut self, elements: &Elements) -> u8 {
        let values = [
            elements.inclination,
            elements.eccentricity,
            elements.node,
            elements.perigee,
            elements.bstar,
            elements.mean_motion,
            elements.mean_anomaly,
            EPOCH,
        ];
        let parameters: Vec<u8> = values
            .iter()
            .flat_map(|value| value.to_le_bytes())
            .collect();
        self.send(ORBIT, &parameters)
    }

    /// The truth's inertial position and velocity now.
    pub(super) fn orbit(&self) -> ([f64; 3], [f64; 3]) {
        place(&self.truth, self.seconds)
    }

    fn angle(&self) -> f64 {
        GpsTime::from_week(WEEK, TIME_OF_WEEK)
            .plus(u64::from(self.seconds) * CONTROL_PERIOD)
            .sidereal_angle()
    }

    /// The field in tesla on the inertial axes, the tilted dipole's.
    fn field(&self) -> [f64; 3] {
        let (position, _) = self.orbit();
        let angle = self.angle();
        let dipole = inertial(unit(DIPOLE), angle);
        let distance = dot(position, position).sqrt();
        let out = unit(position);
        let scale = SURFACE_FIELD
            * (EARTH_RADIUS / distance)
            * (EARTH_RADIUS / distance)
            * (EARTH_RADIUS / distance);
        std::array::from_fn(|axis| scale * (3.0 * dot(dipole, out) * out[axis] - dipole[axis]))
    }

    /// The unit vector to the Sun, and whether the Earth's cylinder of shadow holds the spacecraft.
    pub(super) fn sun(&self) -> ([f64; 3], bool) {
        let (position, _) = self.orbit();
        let sun = GpsTime::from_week(WEEK, TIME_OF_WEEK)
            .plus(u64::from(self.seconds) * CONTROL_PERIOD)
            .sun();
        let along = dot(position, sun);
        let across = sub(position, sun.map(|part| part * along));
        (
            sun,
            along < 0.0 && dot(across, across).sqrt() < EARTH_RADIUS,
        )
    }

    /// Hands the unit what its sensors and receiver see now.
    fn sense(&mut self) {
        let (position, velocity) = self.orbit();
        let angle = self.angle();
        let ecef = inertial(position, -angle);
        let turning = [-EARTH_RATE * ecef[1], EARTH_RATE * ecef[0], 0.0];
        let moving = sub(inertial(velocity, -angle), turning);
        let to_body = attitude_matrix(self.attitude);
        let whole = |value: f64| i32::try_from(nearest(value)).expect("in range");
        let (sun, eclipse) = self.sun();
        self.unit
            .set_position(ecef.map(|meters| whole(meters * 100.0)));
        self.unit
            .set_velocity(moving.map(|speed| whole(speed * 1000.0)));
        self.unit
            .set_attitude(self.attitude.map(|part| whole(part * 1e9)));
        self.unit.set_rate(
            self.rate
                .map(|rate| whole(rate * DEGREES_PER_RADIAN * 1000.0)),
        );
        self.unit
            .set_field(multiply(&to_body, self.field()).map(|tesla| whole(tesla * 1e9)));
        self.unit.set_sun(
            multiply(&to_body, sun).map(|part| whole(part * 1e9)),
            eclipse,
        );
    }

    /// Flies one second: the actuators as the unit drives them, then the unit's step when its event
    /// comes.
    pub(super) fn second(&mut self) {
        let dipole = self
            .unit
            .magnetorquers()
            .map(|duty| f64::from(duty) / FULL_DUTY * FULL_DUTY_DIPOLE);
        let commanded = self
            .unit
            .wheel_speeds()
            .map(|rpm| f64::from(rpm) / RPM_PER_RADIAN_SECOND * WHEEL_INERTIA);
        let field = self.field();
        let (position, _) = self.orbit();
        let step = 1.0 / f64::from(SUBSTEPS);
        for _ in 0..SUBSTEPS {
            let motor: [f64; 3] = std::array::from_fn(|axis| {
                ((commanded[axis] - self.wheels[axis]) / WHEEL_LOOP)
                    .clamp(-WHEEL_TORQUE, WHEEL_TORQUE)
            });
            let wheels = self.wheels;
            let derivative = |attitude: [f64; 4], rate: [f64; 3], wheels: [f64; 3]| {
                let to_body = attitude_matrix(attitude);
                let down = multiply(&to_body, unit(position));
                let radius = dot(position, position).sqrt();
                let gradient = 3.0 * MU / (radius * radius * radius);
                let inertia_down: [f64; 3] = std::array::from_fn(|axis| INERTIA[axis] * down[axis]);
                let torque = add(
                    cross(dipole, multiply(&to_body, field)),
                    cross(down, inertia_down).map(|part| gradient * part),
                );
                let momentum: [f64; 3] =
                    std::array::from_fn(|axis| INERTIA[axis] * rate[axis] + wheels[axis]);
                let gyroscopic = cross(rate, momentum);
                let [w, x, y, z] = attitude;
                let turning =
                    |a: f64, b: f64, c: f64| 0.5 * (a * rate[0] + b * rate[1] + c * rate[2]);
                (
                    [
                        turning(-x, -y, -z),
                        turning(w, -z, y),
                        turning(z, w, -x),
                        turning(-y, x, w),
                    ],
                    std::array::from_fn::<f64, 3, _>(|axis| {
                        (torque[axis] - motor[axis] - gyroscopic[axis]) / INERTIA[axis]
                    }),
                )
            };
            let along = |by: f64, slope: &([f64; 4], [f64; 3])| {
                (
                    std::array::from_fn::<f64, 4, _>(|i| self.attitude[i] + by * slope.0[i]),
                    std::array::from_fn::<f64, 3, _>(|i| self.rate[i] + by * slope.1[i]),
                )
            };
            let wheels_at = |by: f64| -> [f64; 3] {
                std::array::from_fn(|axis| wheels[axis] + by * motor[axis])
            };
            let k1 = derivative(self.attitude, self.rate, wheels);
            let (a2, r2) = along(step / 2.0, &k1);
            let k2 = derivative(a2, r2, wheels_at(step / 2.0));
            let (a3, r3) = along(step / 2.0, &k2);
            let k3 = derivative(a3, r3, wheels_at(step / 2.0));
            let (a4, r4) = along(step, &k3);
            let k4 = derivative(a4, r4, wheels_at(step));
            self.attitude = std::array::from_fn(|i| {
                self.attitude[i] + step / 6.0 * (k1.0[i] + 2.0 * k2.0[i] + 2.0 * k3.0[i] + k4.0[i])
            });
            self.rate = std::array::from_fn(|i| {
                self.rate[i] + step / 6.0 * (k1.1[i] + 2.0 * k2.1[i] + 2.0 * k3.1[i] + k4.1[i])
            });
            self.wheels = wheels_at(step);
            let norm = dot(
                [self.attitude[1], self.attitude[2], self.attitude[3]],
                [self.attitude[1], self.attitude[2], self.attitude[3]],
            ) + self.attitude[0] * self.attitude[0];
            let norm = norm.sqrt();
            self.attitude = self.attitude.map(|part| part / norm);
        }
        self.seconds += 1;
        self.sense();
        let now = VirtualNanos(u64::from(self.seconds) * CONTROL_PERIOD);
        while let Some((event, _, at)) = self.effects.events.pop_due(now) {
            let mut context = DeviceContext::new(at, 0, PERIPHERAL, &mut self.effects);
            self.unit.on_event(event, &mut Timeline::new(&mut context));
        }
    }

    /// The angle in degrees between the body's attitude and `target`, an inertial-to-target matrix.
    pub(super) fn off(&self, target: &[[f64; 3]; 3]) -> f64 {
        let error = quaternion(&multiply_matrices(
            &attitude_matrix(self.attitude),
            &transpose(target),
        ));
        2.0 * atan2(
            dot(
                [error[1], error[2], error[3]],
                [error[1], error[2], error[3]],
            )
            .sqrt(),
            error[0],
        ) * DEGREES_PER_RADIAN
    }
}
