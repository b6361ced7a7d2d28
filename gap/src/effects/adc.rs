//! Bent characteristics of one converter.

use super::about::{About, Parameter, Stage};
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::Chain;
use crate::model::row::Row;
use crate::model::waveform::Characteristic;

#[derive(Clone, Copy)]
enum Bend {
    Cubic,
    Quadratic,
    DeadZone,
    Clipping,
}

/// One kind of error in one channel (0 reference, 1 device under test).
pub(super) struct Adc {
    bend: Bend,
    channel: usize,
}

impl Adc {
    pub(super) const CUBIC_REF: Self = Self::of(Bend::Cubic, 0);
    pub(super) const CUBIC_DUT: Self = Self::of(Bend::Cubic, 1);
    pub(super) const QUADRATIC_REF: Self = Self::of(Bend::Quadratic, 0);
    pub(super) const QUADRATIC_DUT: Self = Self::of(Bend::Quadratic, 1);
    pub(super) const DEAD_ZONE_REF: Self = Self::of(Bend::DeadZone, 0);
    pub(super) const DEAD_ZONE_DUT: Self = Self::of(Bend::DeadZone, 1);
    pub(super) const CLIPPING_REF: Self = Self::of(Bend::Clipping, 0);
    pub(super) const CLIPPING_DUT: Self = Self::of(Bend::Clipping, 1);

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
        }
    }
}

const HARMONIC_COLUMNS: &[&str] = &[
    "acceleration_ms2",
    "ratio",
    "ref_h3",
    "dut_h3",
    "ref_h5",
    "dut_h5",
];
static CUBIC: About = About {
    id: "adc_cubic",
    stage: Stage::Digitiser,
    formula: "gain 1 + 3/4 c3 A^2, H3 = c3 A^2/4 in one channel",
    parameters: &[Parameter::linear("c3_per_v2", "1/V2", -0.5, 0.5)],
    columns: HARMONIC_COLUMNS,
    confused_with: &["dut_level_nonlinearity", "adc_clipping", "adc_dead_zone"],
    separate_by: "a wider range of levels, with harmonics",
};
static QUADRATIC: About = About {
    id: "adc_quadratic",
    stage: Stage::Digitiser,
    formula: "H2 = c2 A/2 and d.c. = c2 A^2/2 in one channel",
    parameters: &[Parameter::linear("c2_per_v", "1/V", -0.5, 0.5)],
    columns: &[
        "acceleration_ms2",
        "ref_h2",
        "dut_h2",
        "ref_dc_v",
        "dut_dc_v",
    ],
    confused_with: &["dut_level_nonlinearity"],
    separate_by: "d.c. of both channels at the highest level",
};
static DEAD_ZONE: About = About {
    id: "adc_dead_zone",
    stage: Stage::Digitiser,
    formula: "gain 1 - 4 delta/(pi A), H3 and H5 as 1/A in one channel",
    parameters: &[Parameter::linear("delta_v", "V", 0.0, 1.0)],
    columns: HARMONIC_COLUMNS,
    confused_with: &["dut_level_nonlinearity", "adc_cubic"],
    separate_by: "the smallest levels, with harmonics",
};
static CLIPPING: About = About {
    id: "adc_clipping",
    stage: Stage::Digitiser,
    formula: "saturation of one channel at large outputs: odd harmonics and loss of gain",
    parameters: &[Parameter::log("threshold_v", "V", 1e-4, 100.0)],
    columns: HARMONIC_COLUMNS,
    confused_with: &["adc_cubic", "loose_mount"],
    separate_by: "levels around the threshold, with harmonics",
};

impl Effect for Adc {
    fn about(&self) -> &'static About {
        match self.bend {
            Bend::Cubic => &CUBIC,
            Bend::Quadratic => &QUADRATIC,
            Bend::DeadZone => &DEAD_ZONE,
            Bend::Clipping => &CLIPPING,
        }
    }
    fn distorts(&self) -> bool {
        true
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
    fn chain(&self, p: &[f64], _row: &Row, chain: &mut Chain) {
        let characteristic = Some(self.characteristic(p[0]));
        if self.channel == 0 {
            chain.ref_adc = characteristic
        } else {
            chain.dut_adc = characteristic
        }
    }
}
