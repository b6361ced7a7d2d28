//! Effects that show as noise and as scatter, not as a response.

use super::about::{About, Parameter, Stage};
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::{Chain, Transfer};
use crate::model::leakage::leaking;
use crate::model::row::Row;
use std::f64::consts::{SQRT_2, TAU};

/// Mains lines in the channel of the device under test.
pub(super) struct MainsPickup;
/// Scatter of the sampling instants.
pub(super) struct SamplingJitter;
/// Motion of the base.
pub(super) enum AmbientVibration {
    Broadband,
    Tone,
}

static MAINS: About = About {
    id: "mains_pickup",
    stage: Stage::Conditioning,
    formula: "lines at n x mains in the DUT channel, not locked to the block: noise, and leakage near n x mains",
    parameters: &[
        Parameter::log("pickup_v", "V", 1e-9, 1.0),
        Parameter::linear("leaking_share", "1", 0.0, 2.0),
    ],
    columns: &["dut_noise_v", "ratio", "acceleration_ms2"],
    confused_with: &["ambient_vibration"],
    separate_by: "noise of both channels with the exciter at rest; points at and beside multiples of the mains frequency",
};
static JITTER: About = About {
    id: "sampling_jitter",
    stage: Stage::Digitiser,
    formula: "d = exp(-(2 pi f sigma)^2/2), noise 2 pi f sigma A in both channels",
    parameters: &[Parameter::log("sigma_s", "s", 1e-12, 1e-3)],
    columns: &[
        "frequency_hz",
        "acceleration_ms2",
        "ref_noise_v",
        "dut_noise_v",
    ],
    confused_with: &["ambient_vibration", "mains_pickup"],
    separate_by: "noise at the highest frequency and level",
};
static AMBIENT: About = About {
    id: "ambient_vibration",
    stage: Stage::Environment,
    formula: "tone (1..30 Hz) and broadband motion of the base, the same in both channels: noise, and leakage near the tone",
    parameters: &[Parameter::log("motion_ms2", "m/s2", 1e-7, 10.0)],
    columns: &["ref_noise_v", "dut_noise_v", "ref_v", "coil_v"],
    confused_with: &["mains_pickup"],
    separate_by: "noise of both channels with the exciter at rest",
};
static AMBIENT_TONE: About = About {
    parameters: &[
        Parameter::log("motion_ms2", "m/s2", 1e-7, 10.0),
        Parameter::log("tone_ms2", "m/s2", 1e-7, 10.0),
        Parameter::linear("tone_hz", "Hz", 0.5, 45.0),
    ],
    ..AMBIENT
};

impl Effect for MainsPickup {
    fn about(&self) -> &'static About {
        &MAINS
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.dut_noise || (facts.ratio && facts.block_known)
    }
    fn scatters(&self) -> bool {
        true
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let largest = 0.3 * facts.largest_peak_v[1].max(10.0 * facts.noise_v);
        let shares: &[f64] = if facts.ratio && facts.block_known {
            &[0.0, 0.5, 1.0]
        } else {
            &[0.0]
        };
        ratios(0.1 * facts.noise_v.max(1e-6), largest, 24)
            .into_iter()
            .flat_map(|v| shares.iter().map(move |s| Start::shape(vec![v, *s])))
            .collect()
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        chain.noise_v2[1] += p[0] * p[0];
        let rms_v = row.dut_peak_v / SQRT_2 * chain.dut_gain;
        if !row.bin_hz.is_finite() || !rms_v.is_finite() || p[1] == 0.0 {
            return;
        }
        let relative = 0.5 * (p[0] * p[1] / rms_v).powi(2);
        chain.leakage[0] += relative * row.mains_leak[0];
        for k in 0..4 {
            chain.harmonic_leakage[1][k] += relative * row.mains_leak[k + 1];
        }
    }
}

impl Effect for SamplingJitter {
    fn about(&self) -> &'static About {
        &JITTER
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ref_noise || facts.dut_noise || facts.drive
    }
    fn scatters(&self) -> bool {
        true
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let largest = 0.3 / (TAU * facts.highest_hz);
        ratios(1e-5 * largest, largest, 24)
            .into_iter()
            .map(|v| Start::shape(vec![v]))
            .collect()
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        let share = 1.0 - (-(row.omega * p[0]).powi(2)).exp();
        for (channel, peak_v) in [row.ref_peak_v, row.dut_peak_v * chain.dut_gain]
            .into_iter()
            .enumerate()
        {
            if peak_v.is_finite() {
                chain.noise_v2[channel] += share * peak_v * peak_v / 2.0;
            }
        }
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let loss = (-0.5 * (TAU * frequency_hz * p[0]).powi(2)).exp();
        transfer.reference *= loss;
        transfer.dut *= loss;
    }
}

impl Effect for AmbientVibration {
    fn about(&self) -> &'static About {
        if matches!(self, Self::Broadband) {
            &AMBIENT
        } else {
            &AMBIENT_TONE
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        let noise = facts.level_known && (facts.ref_noise || facts.dut_noise);
        match self {
            Self::Broadband => noise,
            Self::Tone => {
                facts.drive && facts.level_known && facts.block_known && facts.lowest_hz < 40.0
            }
        }
    }
    fn scatters(&self) -> bool {
        true
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let smallest = 0.1 * facts.noise_v.max(1e-6) * facts.ms2_per_v[0];
        let sizes = ratios(smallest, 3e4 * smallest, 20);
        match self {
            Self::Broadband => sizes.into_iter().map(|s| Start::shape(vec![s])).collect(),
            Self::Tone => {
                let mut tones: Vec<f64> = facts
                    .frequencies_hz
                    .iter()
                    .copied()
                    .filter(|f| *f < 40.0)
                    .collect();
                tones.truncate(10);
                let one = |size: f64, tone: f64| {
                    [0.3, 1.0].map(|part| Start::shape(vec![size, size * part, tone]))
                };
                sizes
                    .into_iter()
                    .step_by(3)
                    .flat_map(|s| {
                        tones
                            .iter()
                            .flat_map(move |t| one(s, *t))
                            .collect::<Vec<_>>()
                    })
                    .collect()
            }
        }
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        let v_per_ms2 =
            [row.ref_peak_v, row.dut_peak_v * chain.dut_gain].map(|v| v / (SQRT_2 * row.level_ms2));
        for (power, v) in chain.noise_v2.iter_mut().zip(v_per_ms2) {
            if v.is_finite() {
                *power += (p[0] * v).powi(2);
            }
        }
        if let (Self::Tone, true) = (self, row.bin_hz.is_finite()) {
            let bins = (row.frequency_hz - p[2]) / row.bin_hz;
            let share = leaking(bins);
            chain.leakage[1] += 0.5 * (p[1] / row.level_ms2).powi(2) * share;
            if bins.abs() < 1.0 {
                // Near the tone part of it counts as fundamental, not as noise.
                chain
                    .noise_open
                    .iter_mut()
                    .for_each(|o| *o += 0.5 * (p[1] / p[0]).min(1.0));
            }
        }
    }
}
