//! Motion that the two transducers do not share.

use super::resonance::second_order;
use crate::model::chain::Transfer;
use crate::model::effect::{Effect, Explanations, Start, ratios};
use crate::model::facts::Facts;
use crate::model::row::Row;
use calib_effects::{Entry, mount};
use num_complex::Complex64;

pub(super) static EXPLANATIONS: Explanations =
    &[&RelativeMotion, &TransverseMotion, &RotationTwice];

/// Compliance between the surfaces the two transducers see.
struct RelativeMotion;
/// Sideways motion picked up through transverse sensitivity.
struct TransverseMotion;

/// A mounting face that bends differently along its two axes.
struct RotationTwice;

impl Effect for RelativeMotion {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &mount::RELATIVE_MOTION
    }
    fn applies(&self, facts: &Facts) -> bool {
        (facts.ratio || facts.ratio_phase)
            && (facts.largest_payload_kg > 0.0 || !facts.payload_stated)
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let payload = if facts.largest_payload_kg > 0.0 {
            facts.largest_payload_kg
        } else {
            0.04
        };
        let unit = 1.0 / (payload * facts.highest_hz * facts.highest_hz);
        [0.01, 0.1, 0.4]
            .map(|s| Start::positive(vec![s * unit], 0))
            .into()
    }
    fn transfer(&self, p: &[f64], row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let payload = if row.payload_stated {
            row.payload_kg
        } else {
            0.04
        };
        transfer.dut *= 1.0 - p[0] * payload * frequency_hz * frequency_hz;
    }
}

impl Effect for TransverseMotion {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &mount::TRANSVERSE_MOTION
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio && facts.rotation_varies
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let quarter = std::f64::consts::FRAC_PI_2;
        let mut starts = Vec::new();
        for rocking_hz in ratios(facts.lowest_hz.max(50.0), 4.0 * facts.highest_hz, 18) {
            for quality in [3.0, 12.0, 40.0] {
                let member = |t0, beta, t1| vec![t0, beta, t1, rocking_hz, quality];
                let members = vec![
                    member(1e-3, 0.0, 0.0),
                    member(1e-3, quarter, 0.0),
                    member(0.0, 0.0, 1e-3),
                    member(0.0, quarter, 1e-3),
                ];
                starts.push(Start {
                    members,
                    amplitude: None,
                    signed: true,
                });
            }
        }
        starts
    }
    /// The static and the rocking part share their direction: that of the larger one.
    fn combine(&self, start: &Start, a: &[f64]) -> Vec<f64> {
        let (still, rocking) = (a[0].hypot(a[1]), a[2].hypot(a[3]));
        let beta = if still > rocking {
            a[1].atan2(a[0])
        } else {
            a[3].atan2(a[2])
        };
        let along = |c: f64, s: f64| 1e-3 * (c * beta.cos() + s * beta.sin());
        vec![
            along(a[0], a[1]),
            beta,
            along(a[2], a[3]),
            start.members[0][3],
            start.members[0][4],
        ]
    }
    fn transfer(&self, p: &[f64], row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let direction = row.rotation.0 * p[1].cos() + row.rotation.1 * p[1].sin();
        let rocking = if p[2] == 0.0 {
            Complex64::ZERO
        } else {
            second_order(frequency_hz, p[3], p[4]) * p[2]
        };
        transfer.dut *= 1.0 + (p[0] + rocking) * direction;
    }
}

impl Effect for RotationTwice {
    fn is_linear(&self) -> bool {
        true
    }
    fn entry(&self) -> &'static Entry {
        &mount::ROTATION_TWICE
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.ratio && facts.rotation_varies
    }
    /// Along the axes and between them.
    fn starts(&self, _facts: &Facts) -> Vec<Start> {
        let between = std::f64::consts::FRAC_PI_4;
        vec![Start {
            members: vec![vec![1e-3, 0.0], vec![1e-3, between]],
            amplitude: None,
            signed: true,
        }]
    }
    fn combine(&self, _start: &Start, a: &[f64]) -> Vec<f64> {
        vec![1e-3 * a[0].hypot(a[1]), 0.5 * a[1].atan2(a[0])]
    }
    fn transfer(&self, p: &[f64], row: &Row, _frequency_hz: f64, transfer: &mut Transfer) {
        let (cos_twice, sin_twice) = row.rotation_twice();
        let along = cos_twice * (2.0 * p[1]).cos() + sin_twice * (2.0 * p[1]).sin();
        transfer.dut *= 1.0 + p[0] * along;
    }
}
