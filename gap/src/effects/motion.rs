//! Motion that the two transducers do not share, or share beyond the armature.

use super::about::{About, Parameter, Stage};
use super::resonance::second_order;
use super::start::{Start, ratios};
use super::{Effect, Facts};
use crate::model::chain::Transfer;
use crate::model::row::Row;
use num_complex::Complex64;

/// Compliance between the surfaces the two transducers see.
pub(super) struct RelativeMotion;
/// Sideways motion picked up through transverse sensitivity.
pub(super) struct TransverseMotion;
/// Axial mode of the moving element.
pub(super) struct ArmatureMode;

static RELATIVE: About = About {
    id: "relative_motion",
    stage: Stage::Mount,
    formula: "r = 1 - kappa m f^2",
    parameters: &[Parameter::linear(
        "kappa_per_kg_hz2",
        "1/(kg Hz2)",
        0.0,
        1e-4,
    )],
    columns: &["frequency_hz", "payload_kg", "ratio"],
    confused_with: &["mount_compliance", "dut_lowpass_2", "averaging_window"],
    separate_by: "a second payload; phase at the highest frequencies",
};
static TRANSVERSE: About = About {
    id: "transverse_motion",
    stage: Stage::Mount,
    formula: "r = 1 + (t0 + t1 H(f; fr, Q)) cos(rotation - beta), H a second-order rocking mode",
    parameters: &[
        Parameter::linear("t0", "1", -0.3, 0.3),
        Parameter::linear("beta_rad", "rad", -10.0, 10.0),
        Parameter::linear("t1", "1", -0.3, 0.3),
        Parameter::log("rocking_hz", "Hz", 20.0, 60_000.0),
        Parameter::log("quality", "1", 0.7, 300.0),
    ],
    columns: &["frequency_hz", "rotation_deg", "ratio"],
    confused_with: &["gravity_tilt"],
    separate_by: "rotation in steps of 90 degrees over the whole band",
};
static ARMATURE: About = About {
    id: "armature_mode",
    stage: Stage::Exciter,
    formula: "d x (1 + kappa q^2/(1 - q^2 + 2 j zeta q)), q = f/fa, the same for all payloads",
    parameters: &[
        Parameter::linear("kappa", "1", -3.0, 3.0),
        Parameter::log("mode_hz", "Hz", 1000.0, 40_000.0),
        Parameter::log("zeta", "1", 0.0005, 0.7),
    ],
    columns: &["frequency_hz", "ref_v", "coil_v", "ref_deg"],
    confused_with: &["reference_resonance", "lossy_inductance"],
    separate_by: "ratio beside the drive (a reference resonance shows there); points around the mode",
};

impl Effect for RelativeMotion {
    fn is_linear(&self) -> bool {
        true
    }
    fn about(&self) -> &'static About {
        &RELATIVE
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
    fn about(&self) -> &'static About {
        &TRANSVERSE
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

impl Effect for ArmatureMode {
    fn is_linear(&self) -> bool {
        true
    }
    fn about(&self) -> &'static About {
        &ARMATURE
    }
    fn applies(&self, facts: &Facts) -> bool {
        facts.drive
    }
    fn starts(&self, facts: &Facts) -> Vec<Start> {
        let mut starts = Vec::new();
        for mode_hz in ratios(1500.0, 25_000.0, 30) {
            for zeta in [0.008, 0.03, 0.1] {
                starts.push(Start::signed(vec![0.01, mode_hz, zeta], 0));
            }
        }
        starts.retain(|s| s.members[0][1] < 4.0 * facts.highest_hz);
        starts
    }
    fn transfer(&self, p: &[f64], _row: &Row, frequency_hz: f64, transfer: &mut Transfer) {
        let q = frequency_hz / p[1];
        transfer.table *= 1.0 + p[0] * q * q / Complex64::new(1.0 - q * q, 2.0 * p[2] * q);
    }
}
