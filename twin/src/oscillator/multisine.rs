//! A random-phase multisine: a noise-like input that is known at all times.

use std::f64::consts::{SQRT_2, TAU};

use nalgebra::Complex;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha12Rng;

/// Odd harmonics of a base frequency with equal amplitudes and random phases.
#[derive(Clone, Debug, PartialEq)]
pub struct Multisine {
    base_hz: f64,
    tones: Vec<(u32, Complex<f64>)>,
    /// Amplitude at the start and growth of it per second.
    ramp: [f64; 2],
}

impl Multisine {
    /// All odd multiples of `base_hz` up to `highest_hz`, together `rms`.
    pub fn new(base_hz: f64, highest_hz: f64, rms: f64, seed: u64) -> Self {
        let mut random = ChaCha12Rng::seed_from_u64(seed);
        let orders: Vec<u32> = (0..)
            .map(|index| 2 * index + 1)
            .take_while(|&order| f64::from(order) * base_hz <= highest_hz)
            .collect();
        let amplitude = rms * SQRT_2 / (orders.len().max(1) as f64).sqrt();
        let mut tone = |order| {
            (
                order,
                Complex::from_polar(amplitude, random.random_range(0.0..TAU)),
            )
        };
        Self {
            base_hz,
            tones: orders.into_iter().map(&mut tone).collect(),
            ramp: [1.0, 0.0],
        }
    }

    /// Lets the amplitude grow from nothing to its value at `duration_s`.
    #[must_use]
    pub fn growing(mut self, duration_s: f64) -> Self {
        self.ramp = [0.0, 1.0 / duration_s];
        self
    }

    /// Values at `count` instants from `start_s` in steps of `step_s`.
    pub fn values(&self, start_s: f64, step_s: f64, count: usize) -> Vec<f64> {
        let mut values = vec![0.0; count];
        for &(order, amplitude) in &self.tones {
            let omega = TAU * self.base_hz * f64::from(order);
            let turn = Complex::from_polar(1.0, omega * step_s);
            let mut phasor = amplitude * Complex::from_polar(1.0, omega * start_s);
            for value in &mut values {
                *value += phasor.re;
                phasor *= turn;
            }
        }
        for (index, value) in values.iter_mut().enumerate() {
            let time_s = start_s + index as f64 * step_s;
            *value *= self.ramp[0] + self.ramp[1] * time_s;
        }
        values
    }
}
