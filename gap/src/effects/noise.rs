//! Effects that show as noise and as scatter, not as a response.

use crate::model::chain::Transfer;
use crate::model::effect::{Effect, Explanations, Start, Stated, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use crate::model::scatter::{Line, Scatter, taken};
use crate::observable::Observable;
use calib_effects::{Entry, Parameter, conditioning, digitiser, environment};
use std::f64::consts::{SQRT_2, TAU};

pub(super) static EXPLANATIONS: Explanations = &[
    &MainsPickup::Fundamental,
    &MainsPickup::Everywhere,
    &SamplingJitter,
    &AmbientVibration::Broadband,
    &AmbientVibration::ToneNearby,
    &AmbientVibration::ToneEverywhere,
];

/// Mains lines in the channel of the device under test.
///
/// How far the lines leak depends on the window of the instrument: into the
/// fundamental alone, or into every component that is computed alike.
enum MainsPickup {
    Fundamental,
    Everywhere,
}
/// Scatter of the sampling instants.
struct SamplingJitter;
/// Motion of the base.
enum AmbientVibration {
    Broadband,
    /// A tone that leaks into fundamentals within a bin.
    ToneNearby,
    /// A tone that leaks into all components, however far.
    ToneEverywhere,
}

/// Factors on the size of the best of the coarse starts.
const FINE: [f64; 7] = [0.75, 0.82, 0.9, 1.0, 1.1, 1.21, 1.33];
/// Sizes around the best of those: noise is known to 1 % a row, and a size off by more
/// looks worse than no effect.
const FINER: [f64; 7] = [0.955, 0.97, 0.985, 1.0, 1.015, 1.03, 1.045];

/// Sizes to start from, with the one that the noise columns show in the median row.
fn with_measured(mut sizes: Vec<f64>, measured: f64) -> Vec<f64> {
    if measured > 0.0 {
        sizes.push(measured);
    }
    sizes
}

impl Effect for MainsPickup {
    fn entry(&self) -> &'static Entry {
        &conditioning::MAINS_PICKUP
    }
    /// All lines as one, and how far they leak.
    fn parameters(&self) -> &'static [Parameter] {
        static FITTED: [Parameter; 2] = [
            conditioning::MAINS_PICKUP.parameters[0],
            conditioning::MAINS_PICKUP.only_fitted[0],
        ];
        &FITTED
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.dut_noise || (facts.ratio && facts.block_known)
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let largest = 0.3 * facts.largest_peak_v[1].max(10.0 * facts.noise_v);
        let coarse = ratios(0.1 * facts.noise_v.max(1e-6), largest, 24);
        with_measured(coarse, facts.excess_noise_v[1])
            .into_iter()
            .map(|v| Start::shape(vec![v, 0.0]))
            .collect()
    }
    fn around(&self, best: &[f64], round: usize, facts: &Facts) -> Vec<Vec<f64>> {
        match round {
            0 => FINE.map(|factor| vec![best[0] * factor, best[1]]).into(),
            1 => FINER.map(|factor| vec![best[0] * factor, best[1]]).into(),
            _ if !(facts.ratio && facts.block_known) => Vec::new(),
            _ => [0.1, 0.3, 0.6, 1.0]
                .map(|share| vec![best[0], share])
                .into(),
        }
    }
    fn scatter(&self, p: &[f64], row: &Row, _dut_gain: f64, scatter: &mut Scatter) {
        scatter.noise_v2[1] += p[0] * p[0];
        let rms_v = row.seen_v[1];
        if !row.bin_hz.is_finite() || !rms_v.is_finite() || p[1] == 0.0 {
            return;
        }
        let power_v2 = (p[0] * p[1]).powi(2);
        let relative = 0.5 * power_v2 / (rms_v * rms_v);
        scatter.leaks.response[0] += relative * row.mains_leak[0];
        if matches!(self, Self::Everywhere) {
            scatter.taken_v2[1] += p[0] * p[0] * row.mains_taken;
            for k in 0..4 {
                scatter.leaks.harmonics[1][k] += relative * row.mains_leak[k + 1];
            }
            scatter.leaks.dc_v2[1] += power_v2 * row.mains_leak_dc;
        }
    }
}

impl Effect for SamplingJitter {
    fn entry(&self) -> &'static Entry {
        &digitiser::SAMPLING_JITTER
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ref_noise || facts.dut_noise || facts.drive
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let largest = 0.3 / (TAU * facts.highest_hz);
        with_measured(ratios(1e-5 * largest, largest, 24), facts.excess_noise_s)
            .into_iter()
            .map(|v| Start::shape(vec![v]))
            .collect()
    }
    fn around(&self, best: &[f64], round: usize, _facts: &Facts) -> Vec<Vec<f64>> {
        match round {
            0 => FINE.map(|factor| vec![best[0] * factor]).into(),
            1 => FINER.map(|factor| vec![best[0] * factor]).into(),
            _ => Vec::new(),
        }
    }
    fn scatter(&self, p: &[f64], row: &Row, _dut_gain: f64, scatter: &mut Scatter) {
        let share = 1.0 - (-(row.omega * p[0]).powi(2)).exp();
        for (power, rms_v) in scatter.noise_v2.iter_mut().zip(row.seen_v) {
            if rms_v.is_finite() {
                *power += share * rms_v * rms_v;
            }
        }
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let loss = (-0.5 * (TAU * frequency_hz * p[0]).powi(2)).exp();
        transfer.reference *= loss;
        transfer.dut *= loss;
    }
}

/// Frequencies that a tone of the floor may have.
fn tone_hz() -> &'static Parameter {
    &environment::AMBIENT_VIBRATION.parameters[2]
}

impl Effect for AmbientVibration {
    fn entry(&self) -> &'static Entry {
        &environment::AMBIENT_VIBRATION
    }
    fn parameters(&self) -> &'static [Parameter] {
        match self {
            Self::Broadband => &self.entry().parameters[..1],
            _ => self.entry().parameters,
        }
    }
    /// Noise has the size of the whole motion, so that is what is fitted first.
    fn state(&self, values: &mut [Stated]) {
        if let [motion, tone, _] = values {
            let tone_ms2 = tone.value.min(motion.value);
            let broadband_ms2 = (motion.value.powi(2) - tone_ms2.powi(2)).sqrt();
            let moved = (motion.value * motion.u).hypot(tone_ms2 * tone.u);
            // It lies between nothing and the whole motion in any case.
            motion.u = (moved / broadband_ms2).min(motion.value);
            motion.value = broadband_ms2;
        }
    }
    fn applies(&self, facts: &Facts) -> bool {
        let noise = facts.level_known && (facts.ref_noise || facts.dut_noise);
        match self {
            Self::Broadband => noise,
            Self::ToneNearby | Self::ToneEverywhere => {
                facts.drive
                    && facts.level_known
                    && facts.block_known
                    && facts.lowest_hz < tone_hz().upper
            }
        }
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let smallest = 0.1 * facts.noise_v.max(1e-6) * facts.ms2_per_v[0];
        let tone_hz = tone_hz();
        let measured = facts.excess_noise_v.iter().zip(facts.ms2_per_v);
        let measured = measured.map(|(v, ms2_per_v)| v * ms2_per_v * SQRT_2);
        let measured = measured.fold(0.0, f64::max);
        with_measured(ratios(smallest, 3e4 * smallest, 20), measured)
            .into_iter()
            .map(|size| match self {
                Self::Broadband => Start::shape(vec![size]),
                _ => Start::shape(vec![
                    size,
                    0.1 * size,
                    facts.lowest_hz.clamp(tone_hz.lower, tone_hz.upper),
                ]),
            })
            .collect()
    }
    fn around(&self, best: &[f64], round: usize, facts: &Facts) -> Vec<Vec<f64>> {
        if round < 2 {
            let sized = |factor: f64| {
                let mut parameters = best.to_vec();
                parameters[0] *= factor;
                parameters
            };
            return if round == 0 { FINE } else { FINER }.map(sized).into();
        }
        if matches!(self, Self::Broadband) {
            return Vec::new();
        }
        let near = facts
            .frequencies_hz
            .iter()
            .filter(|f| **f < tone_hz().upper);
        let tones = near.take(12).flat_map(|tone| {
            [0.03, 0.1, 0.3, 1.0].map(|part| vec![best[0], best[0] * part, *tone])
        });
        tones.collect()
    }
    fn scatter(&self, p: &[f64], row: &Row, dut_gain: f64, scatter: &mut Scatter) {
        let v_per_ms2 =
            [row.ref_peak_v, row.dut_peak_v * dut_gain].map(|v| v / (SQRT_2 * row.level_ms2));
        for (power, v) in scatter.noise_v2.iter_mut().zip(v_per_ms2) {
            if v.is_finite() {
                *power += (p[0] * v).powi(2);
            }
        }
        if matches!(self, Self::Broadband) || !row.bin_hz.is_finite() {
            return;
        }
        // The tone is part of the motion: where noise was measured it shows there.
        let seen = row.u[Observable::RefNoise]
            .min(row.u[Observable::DutNoise])
            .is_finite();
        let tone_ms2 = if seen { p[1].min(p[0]) } else { p[1] };
        let tone = Line::new(p[2], row.frequency_hz, row.bin_hz);
        let relative = 0.5 * (tone_ms2 / row.level_ms2).powi(2);
        if matches!(self, Self::ToneNearby) {
            if tone.bins(1).abs() < 1.0 {
                scatter.leaks.response[1] += relative * tone.leaking(1);
            }
            return;
        }
        let leaking: [f64; 6] = std::array::from_fn(|order| tone.leaking(order));
        scatter.leaks.response[1] += relative * leaking[1];
        for harmonics in &mut scatter.leaks.harmonics {
            for (variance, share) in harmonics.iter_mut().zip(&leaking[2..]) {
                *variance += relative * share;
            }
        }
        let taken_ms2 = tone_ms2 * taken(&leaking).sqrt();
        for (channel, v) in v_per_ms2.into_iter().enumerate() {
            scatter.leaks.dc_v2[channel] += (tone_ms2 * v).powi(2) * leaking[0];
            scatter.taken_v2[channel] += (taken_ms2 * v).powi(2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 0.005 m/s2 in all, of which 0.003 are a tone: 0.004 are broadband. Of u = 1e-5 of the whole
    /// alone 5/4 arrive there, of the tone alone 3/4.
    #[test]
    fn the_broadband_part_is_what_the_tone_leaves_of_the_motion() {
        let of = |value, u| Stated { value, u };
        for (u, expected) in [([1e-5, 0.0], 1.25e-5), ([0.0, 1e-5], 0.75e-5)] {
            let mut values = [of(0.005, u[0]), of(0.003, u[1]), of(12.0, 0.1)];
            AmbientVibration::ToneNearby.state(&mut values);
            assert!((values[0].value / 0.004 - 1.0).abs() < 1e-12, "{values:?}");
            assert!((values[0].u / expected - 1.0).abs() < 1e-12, "{values:?}");
        }
        // A tone as large as the motion leaves nothing, or anything up to the motion.
        let mut values = [of(0.003, 3e-5), of(0.004, 4e-5), of(12.0, 0.1)];
        AmbientVibration::ToneEverywhere.state(&mut values);
        assert_eq!(values[0], of(0.0, 0.003));
    }
}
