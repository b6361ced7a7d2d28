//! Effects of the mounting on the device under test.

use crate::model::chain::{Chain, Transfer};
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use crate::model::scatter::Scatter;
use crate::model::waveform::Characteristic;
use calib_effects::{Entry, Parameter, mount};

pub(super) static EXPLANATIONS: Explanations = &[
    &BaseStrain,
    &GravityTilt,
    &LooseMount {
        upper: false,
        with_gravity: false,
    },
    &LooseMount {
        upper: true,
        with_gravity: false,
    },
    &LooseMount {
        upper: false,
        with_gravity: true,
    },
    &LooseMount {
        upper: true,
        with_gravity: true,
    },
];

/// Standard acceleration of free fall, in m/s2 (ISO 80000-3).
pub(super) const FREE_FALL_MS2: f64 = 9.806_65;

/// Strain of the base, driven by the payload at low frequency.
struct BaseStrain;
/// Tilt in proportion to travel.
struct GravityTilt;
/// A device that lifts off when the table falls away.
struct LooseMount {
    /// The cut is on the positive side.
    upper: bool,
    /// Weight holds the device down: tilting lowers the threshold.
    with_gravity: bool,
}

impl Effect for BaseStrain {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &mount::BASE_STRAIN
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio && (facts.largest_payload_kg > 0.0 || !facts.payload_stated)
    }
    fn starts(&self, _facts: &Facts) -> Vec<Start> {
        ratios(6.0, 180.0, 9)
            .into_iter()
            .map(|corner| Start::signed(vec![0.002, corner], 0))
            .collect()
    }
    fn transfer(&self, p: &[f64], row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let payload = if row.payload_stated {
            row.payload_kg / 0.04
        } else {
            1.0
        };
        let q = frequency_hz / p[1];
        transfer.dut *= 1.0 + p[0] * payload / (1.0 + q * q);
    }
}

impl Effect for GravityTilt {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &mount::GRAVITY_TILT
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        vec![Start::signed(
            vec![0.001 * facts.lowest_hz * facts.lowest_hz],
            0,
        )]
    }
    fn transfer(&self, p: &[f64], row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        transfer.dut *= 1.0 + p[0] * row.rotation.0 / (frequency_hz * frequency_hz);
    }
}

impl LooseMount {
    fn threshold(&self, p: &[f64], row: &Row) -> f64 {
        let lowered = if self.with_gravity {
            FREE_FALL_MS2 * (1.0 - row.vertical)
        } else {
            0.0
        };
        (p[0] - lowered).max(0.2)
    }
}

impl Effect for LooseMount {
    fn entry(&self) -> &'static Entry {
        &mount::LOOSE_MOUNT
    }
    fn parameters(&self) -> &'static [Parameter] {
        &mount::LOOSE_MOUNT.parameters[..2]
    }
    fn distorts(&self) -> bool {
        true
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.level_known
            && (facts.ratio || facts.dut_harmonics)
            && (!self.with_gravity || facts.tilt_varies)
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let peak = facts.largest_level_ms2 * std::f64::consts::SQRT_2;
        let added = if self.with_gravity {
            FREE_FALL_MS2
        } else {
            0.0
        };
        ratios(0.15 * peak, 0.99 * peak, 14)
            .into_iter()
            .filter(|t| (1.0..100.0).contains(t))
            .flat_map(|t| [1e-6, 1e-3, 2e-2].map(|noise| Start::shape(vec![t + added, noise])))
            .collect()
    }
    fn chain(&self, p: &[f64], row: &Row, chain: &mut Chain) {
        let threshold = self.threshold(p, row);
        chain.mount = Some(Characteristic::OneSided {
            threshold,
            upper: self.upper,
        });
    }
    fn scatter(&self, p: &[f64], row: &Row, _dut_gain: f64, scatter: &mut Scatter) {
        let peak = row.level_ms2 * std::f64::consts::SQRT_2;
        let excess = peak - self.threshold(p, row);
        if excess > 0.0 && peak.is_finite() {
            let impact_v = p[1] * excess * row.dut_peak_v / peak;
            scatter.noise_v2[1] += impact_v * impact_v;
            // How impacts grow above the threshold depends on the contact: only that they grow is used.
            scatter.noise_open[1] += 0.3 * (1.0 - (-impact_v / 1e-5).exp());
        }
    }
}
