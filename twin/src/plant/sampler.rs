//! From volts at a converter's input to its code: everything that happens at sampling.

use std::f64::consts::TAU;

use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use crate::converters::{Input, InputConverter};
use crate::model::{Channel, Model};
use crate::rig::Sensing;
use crate::rig_port::Conversions;

/// A signal and its derivative at the sampling instant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sampled {
    pub(super) volt: f64,
    pub(super) volt_per_s: f64,
    /// Mean square of the motion of the mounting face, (m/s2)2.
    pub(super) face_m2s4: f64,
    /// Volts at the other channel's converter.
    pub(super) other_v: f64,
    /// Of the converters' reference, of its peak.
    pub(super) ripple: f64,
}

/// One channel's converter.
#[derive(Clone, Debug)]
pub(super) struct Sampler {
    channel: Channel,
    converter: InputConverter,
    noise_rms_v: f64,
    offset_v: f64,
    jitter_s: f64,
    start_s: f64,
}

impl Sampler {
    pub(super) fn new(
        model: &Model,
        channel: &Channel,
        sensing: &Sensing,
        converter: InputConverter,
        start_s: f64,
    ) -> Self {
        Self {
            channel: channel.clone(),
            converter,
            noise_rms_v: sensing.noise_rms_v,
            offset_v: sensing.offset_v,
            jitter_s: model.jitter_s,
            start_s,
        }
    }

    /// The converter is set so from now on.
    pub(super) fn set_conversions(&mut self, conversions: Conversions) {
        self.converter.set(conversions);
    }

    /// Whether the derivative of the signal matters.
    pub(super) fn needs_slope(&self) -> bool {
        self.jitter_s != 0.0 || self.channel.clock_delta != 0.0
    }

    /// Time on the clock of the rig's surroundings, s.
    pub(super) fn time_s(&self, elapsed_s: f64) -> f64 {
        self.start_s + elapsed_s
    }

    /// The code at `elapsed_s` after the start, with so much dither at each of its conversions.
    pub(super) fn code(
        &mut self,
        sampled: Sampled,
        dither_v: &[f64],
        elapsed_s: f64,
        noise: &mut ChaCha8Rng,
    ) -> u16 {
        let mut normal = || -> f64 { StandardNormal.sample(noise) };
        let time_s = self.time_s(elapsed_s);
        let channel = &self.channel;
        let level_rms_ms2 = sampled.face_m2s4.sqrt();
        let peak_v = std::f64::consts::SQRT_2
            * level_rms_ms2
            * (channel.sensitivity_v_per_ms2 * channel.gain).abs();
        let gain = channel.gain_at(time_s)
            * channel.range_gain(peak_v)
            * (1.0 + channel.level_gain_per_ms2 * level_rms_ms2);
        // First order in the error of the instant: second order is the loss of amplitude, which
        // below 1 % of a period is below 2e-3.
        let mut early_s = -channel.clock_delta * time_s;
        if self.jitter_s != 0.0 {
            early_s += self.jitter_s * normal();
        }
        let volt = (sampled.volt + sampled.volt_per_s * early_s) * gain;
        let signal_rms_v = match self.impact_rms_v(level_rms_ms2) {
            0.0 => self.noise_rms_v.abs(),
            impact_rms_v => self.noise_rms_v.hypot(impact_rms_v),
        };
        let noise_rms_v = self.converter.noise_rms_v(signal_rms_v);
        let picked_up_v = self.pickup_v(time_s);
        let total = volt + picked_up_v + self.offset_v + noise_rms_v * normal();
        let volt = channel.converter.output_v(total);
        let input = Input {
            volt,
            other_v: sampled.other_v,
            ripple: sampled.ripple,
        };
        self.converter.code(input, dither_v)
    }

    fn impact_rms_v(&self, level_rms_ms2: f64) -> f64 {
        let peak_ms2 = level_rms_ms2 * std::f64::consts::SQRT_2;
        self.channel.separation.map_or(0.0, |separation| {
            separation.impact_noise
                * separation.excess_ms2(peak_ms2)
                * (self.channel.sensitivity_v_per_ms2 * self.channel.gain).abs()
        })
    }

    fn pickup_v(&self, time_s: f64) -> f64 {
        let pickup = &self.channel.pickup;
        let mut sum = 0.0;
        for (order, rms) in (1..).zip(pickup.lines_rms_v).filter(|line| line.1 != 0.0) {
            // Phases that are no multiples of each other.
            let angle = f64::from(order) * (TAU * pickup.mains_hz * time_s + 1.0);
            sum += std::f64::consts::SQRT_2 * rms * angle.sin();
        }
        sum
    }
}
