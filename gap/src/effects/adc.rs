//! Bent characteristics of one converter.

use crate::model::chain::{Chain, Transfer};
use crate::model::effect::{Effect, Explanations, Shows, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use crate::model::waveform::Characteristic;
use crate::observable::Channel;
use crate::thresholds;
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
    &RangeStep {
        channel: Channel::Reference,
    },
    &RangeStep {
        channel: Channel::Dut,
    },
];

#[derive(Clone, Copy)]
enum Kind {
    Cubic,
    Quadratic,
    DeadZone,
    Clipping,
    Soft,
}

/// One kind of error in one channel.
struct Adc {
    kind: Kind,
    channel: Channel,
}

/// Another gain above a level of one channel.
struct RangeStep {
    channel: Channel,
}

impl Adc {
    const CUBIC_REF: Self = Self::of(Kind::Cubic, Channel::Reference);
    const CUBIC_DUT: Self = Self::of(Kind::Cubic, Channel::Dut);
    const QUADRATIC_REF: Self = Self::of(Kind::Quadratic, Channel::Reference);
    const QUADRATIC_DUT: Self = Self::of(Kind::Quadratic, Channel::Dut);
    const DEAD_ZONE_REF: Self = Self::of(Kind::DeadZone, Channel::Reference);
    const DEAD_ZONE_DUT: Self = Self::of(Kind::DeadZone, Channel::Dut);
    const CLIPPING_REF: Self = Self::of(Kind::Clipping, Channel::Reference);
    const CLIPPING_DUT: Self = Self::of(Kind::Clipping, Channel::Dut);
    const SOFT_REF: Self = Self::of(Kind::Soft, Channel::Reference);
    const SOFT_DUT: Self = Self::of(Kind::Soft, Channel::Dut);

    const fn of(kind: Kind, channel: Channel) -> Self {
        Self { kind, channel }
    }

    fn characteristic(&self, p: f64) -> Characteristic {
        match self.kind {
            Kind::Cubic => Characteristic::Polynomial {
                second: 0.0,
                third: p,
            },
            Kind::Quadratic => Characteristic::Polynomial {
                second: p,
                third: 0.0,
            },
            Kind::DeadZone => Characteristic::DeadZone { threshold: p },
            Kind::Clipping => Characteristic::Clip { threshold: p },
            Kind::Soft => Characteristic::Soft { threshold: p },
        }
    }
}

impl Effect for Adc {
    fn entry(&self) -> &'static Entry {
        match self.kind {
            Kind::Cubic => &digitiser::CUBIC,
            Kind::Quadratic => &digitiser::QUADRATIC,
            Kind::DeadZone => &digitiser::DEAD_ZONE,
            Kind::Clipping => &digitiser::CLIPPING,
            Kind::Soft => &digitiser::SOFT_CLIPPING,
        }
    }
    /// The channel is a variant, not fitted.
    fn parameters(&self) -> &'static [Parameter] {
        &self.entry().parameters[..1]
    }
    /// Of less than that nothing but its cubic part shows.
    fn within(&self, facts: &Facts) -> Option<[f64; 2]> {
        let largest_v = facts.largest_peak_v[self.channel as usize];
        matches!(self.kind, Kind::Soft).then_some([0.0, thresholds::FARTHEST_SOFT * largest_v])
    }
    fn distorts(&self) -> bool {
        true
    }
    fn shows(&self) -> Shows {
        Shows::Harmonics
    }
    fn applies(&self, facts: &Facts) -> bool {
        let seen = match self.kind {
            Kind::Quadratic => [
                facts.ref_harmonics || facts.ref_dc,
                facts.dut_harmonics || facts.dut_dc,
            ][self.channel as usize],
            _ => facts.ratio || [facts.ref_harmonics, facts.dut_harmonics][self.channel as usize],
        };
        seen && facts.largest_peak_v[self.channel as usize].is_finite()
            && facts.largest_peak_v[self.channel as usize] > 0.0
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let (small, large) = (
            facts.smallest_peak_v[self.channel as usize],
            facts.largest_peak_v[self.channel as usize],
        );
        match self.kind {
            Kind::Cubic => vec![Start::signed(vec![0.001 / (large * large)], 0)],
            Kind::Soft => vec![Start::positive(vec![2.0 * large], 0)],
            Kind::Quadratic => vec![Start::signed(vec![0.001 / large], 0)],
            Kind::DeadZone => ratios(1e-5 * small, 0.3 * large, 12)
                .into_iter()
                .map(|d| Start::positive(vec![d], 0))
                .collect(),
            // Just below the largest output nothing but the noise of the highest levels shows.
            Kind::Clipping => ratios(0.4 * large, 0.87 * large, 9)
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
        match self.kind {
            Kind::Soft => vec![start.members[0][0] / size.max(1e-8).sqrt()],
            _ => start.scaled(size),
        }
    }
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        let characteristic = Some(self.characteristic(p[0]));
        if self.channel == Channel::Reference {
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
        (facts.ratio || (facts.drive_modulus && self.channel == Channel::Reference))
            && !facts.between_v[self.channel as usize].is_empty()
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let places = facts.between_v[self.channel as usize].iter();
        places.map(|v| Start::signed(vec![0.002, *v], 0)).collect()
    }
    fn transfer(&self, p: &[f64], row: &Row, _frequency_hz: f64, transfer: &mut Transfer) {
        if row.seen_v[self.channel as usize] * std::f64::consts::SQRT_2 > p[1] {
            let gain = 1.0 + p[0];
            match self.channel {
                Channel::Reference => transfer.reference *= gain,
                Channel::Dut => transfer.dut *= gain,
            }
        }
    }
}
