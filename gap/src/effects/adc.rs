//! Bent characteristics of one converter.

use crate::model::chain::{Chain, Transfer};
use crate::model::effect::{Effect, Explanations, Shows, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use crate::model::waveform::Characteristic;
use calib_effects::{Entry, Parameter, digitiser};

pub(super) static EXPLANATIONS: Explanations = &[
    &Adc::CUBIC_REF,
    &Adc::CUBIC_DUT,
    &Adc::QUADRATIC_REF,
    &Adc::QUADRATIC_DUT,
    &Adc::DEAD_ZONE_REF,
    &Adc::DEAD_ZONE_DUT,
    &Adc::CLIPPING_REF,
    &Adc::CLIPPING_DUT,
    &Adc::SOFT_REF,
    &Adc::SOFT_DUT,
    &RangeStep { channel: 0 },
    &RangeStep { channel: 1 },
];

/// Threshold over the largest peak up to which a soft bend is more than a cubic one: at a quarter the third
/// harmonic is 5e-3, 3 % of it less than that of a cubic with the same gain.
const FARTHEST_SOFT: f64 = 4.0;

#[derive(Clone, Copy)]
enum Bend {
    Cubic,
    Quadratic,
    DeadZone,
    Clipping,
    Soft,
}

/// One kind of error in one channel (0 reference, 1 device under test).
struct Adc {
    bend: Bend,
    channel: usize,
}

/// Another gain above a level of one channel.
struct RangeStep {
    channel: usize,
}

impl Adc {
    const CUBIC_REF: Self = Self::of(Bend::Cubic, 0);
    const CUBIC_DUT: Self = Self::of(Bend::Cubic, 1);
    const QUADRATIC_REF: Self = Self::of(Bend::Quadratic, 0);
    const QUADRATIC_DUT: Self = Self::of(Bend::Quadratic, 1);
    const DEAD_ZONE_REF: Self = Self::of(Bend::DeadZone, 0);
    const DEAD_ZONE_DUT: Self = Self::of(Bend::DeadZone, 1);
    const CLIPPING_REF: Self = Self::of(Bend::Clipping, 0);
    const CLIPPING_DUT: Self = Self::of(Bend::Clipping, 1);
    const SOFT_REF: Self = Self::of(Bend::Soft, 0);
    const SOFT_DUT: Self = Self::of(Bend::Soft, 1);

    const fn of(bend: Bend, channel: usize) -> Self {
        Self { bend, channel }
    }

    fn characteristic(&self, p: f64) -> Characteristic {
        match self.bend {
            Bend::Cubic => Characteristic::Polynomial {
                second: 0.0,
                third: p,
            },
            Bend::Quadratic => Characteristic::Polynomial {
                second: p,
                third: 0.0,
            },
            Bend::DeadZone => Characteristic::DeadZone { threshold: p },
            Bend::Clipping => Characteristic::Clip { threshold: p },
            Bend::Soft => Characteristic::Soft { threshold: p },
        }
    }
}

impl Effect for Adc {
    fn entry(&self) -> &'static Entry {
        match self.bend {
            Bend::Cubic => &digitiser::CUBIC,
            Bend::Quadratic => &digitiser::QUADRATIC,
            Bend::DeadZone => &digitiser::DEAD_ZONE,
            Bend::Clipping => &digitiser::CLIPPING,
            Bend::Soft => &digitiser::SOFT_CLIPPING,
        }
    }
    /// The channel is a variant, not fitted.
    fn parameters(&self) -> &'static [Parameter] {
        &self.entry().parameters[..1]
    }
    /// Of less than that nothing but its cubic part shows.
    fn within(&self, facts: &Facts) -> Option<[f64; 2]> {
        let largest_v = facts.largest_peak_v[self.channel];
        matches!(self.bend, Bend::Soft).then_some([0.0, FARTHEST_SOFT * largest_v])
    }
    fn distorts(&self) -> bool {
        true
    }
    fn shows(&self) -> Shows {
        Shows::Harmonics
    }
    fn applies(&self, facts: &Facts) -> bool {
        let seen = match self.bend {
            Bend::Quadratic => [
                facts.ref_harmonics || facts.ref_dc,
                facts.dut_harmonics || facts.dut_dc,
            ][self.channel],
            _ => facts.ratio || [facts.ref_harmonics, facts.dut_harmonics][self.channel],
        };
        seen && facts.largest_peak_v[self.channel].is_finite()
            && facts.largest_peak_v[self.channel] > 0.0
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let (small, large) = (
            facts.smallest_peak_v[self.channel],
            facts.largest_peak_v[self.channel],
        );
        match self.bend {
            Bend::Cubic => vec![Start::signed(vec![0.001 / (large * large)], 0)],
            Bend::Soft => vec![Start::positive(vec![2.0 * large], 0)],
            Bend::Quadratic => vec![Start::signed(vec![0.001 / large], 0)],
            Bend::DeadZone => ratios(1e-5 * small, 0.3 * large, 12)
                .into_iter()
                .map(|d| Start::positive(vec![d], 0))
                .collect(),
            // Just below the largest output nothing but the noise of the highest levels shows.
            Bend::Clipping => ratios(0.4 * large, 0.87 * large, 9)
                .into_iter()
                .chain([0.9, 0.92, 0.94, 0.955, 0.97, 0.98, 0.99].map(|s| s * large))
                .chain([0.997, 0.9985, 0.9993, 0.9998].map(|s| s * large))
                .map(|c| Start::shape(vec![c]))
                .collect(),
        }
    }
    /// The effect of a soft threshold goes with the square of its reciprocal.
    fn combine(&self, start: &Start, amplitudes: &[f64]) -> Vec<f64> {
        let size = amplitudes[0];
        match self.bend {
            Bend::Soft => vec![start.members[0][0] / size.max(1e-8).sqrt()],
            _ => start.scaled(size),
        }
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        let characteristic = Some(self.characteristic(p[0]));
        if self.channel == 0 {
            chain.ref_adc = characteristic
        } else {
            chain.dut_adc = characteristic
        }
    }
}

impl Effect for RangeStep {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &digitiser::RANGE_STEP
    }
    /// The channel is a variant, not fitted.
    fn parameters(&self) -> &'static [Parameter] {
        &self.entry().parameters[..2]
    }
    fn applies(&self, facts: &Facts) -> bool {
        (facts.ratio || (facts.drive_modulus && self.channel == 0))
            && !facts.between_v[self.channel].is_empty()
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let places = facts.between_v[self.channel].iter();
        places.map(|v| Start::signed(vec![0.002, *v], 0)).collect()
    }
    fn transfer(&self, p: &[f64], row: &Row, _frequency_hz: f64, transfer: &mut Transfer) {
        if row.seen_v[self.channel] * std::f64::consts::SQRT_2 > p[1] {
            let gain = 1.0 + p[0];
            match self.channel {
                0 => transfer.reference *= gain,
                _ => transfer.dut *= gain,
            }
        }
    }
}
