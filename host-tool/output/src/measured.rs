//! Measured quantities of a point beside its result: the one list, as JSON and as columns.
//!
//! Each field of [`Observed`] is a key of JSON. Each entry of [`MEASURED`] is a column of CSV and, where
//! it has a heading, a column that the printed table of a certificate can have.

use super::number::{decimal, degrees, finite, percent};
use calib_core::point::PointResult;
use schemars::JsonSchema;
use serde::Serialize;

/// Observed at a point, whether or not it has a result.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Observed {
    /// Total harmonic distortion of the device under test.
    pub distortion_dut_rel: Option<f32>,
    /// Total harmonic distortion of the reference channel.
    pub distortion_reference_rel: Option<f32>,
    /// Signal to residual noise of the device under test, dB.
    pub signal_to_noise_dut_db: Option<f32>,
    /// Signal to residual noise of the device under test in its worst block, dB; none with
    /// broadband excitation.
    pub signal_to_noise_dut_worst_block_db: Option<f32>,
    /// Signal to residual noise of the reference channel, dB.
    pub signal_to_noise_reference_db: Option<f32>,
    /// Relative experimental standard deviation of the mean over the blocks.
    pub repeatability_rel: Option<f32>,
    /// Experimental standard deviation of the mean phase over the blocks, degrees.
    pub repeatability_phase_deg: Option<f64>,
    /// Amplitude of what the mains may still do to the result, relative; as many rad of phase.
    pub hum_rel: Option<f32>,
    /// Part of the tone that may be missing, relative: power beside it that is absent at rest, over its own.
    pub dropout_rel: Option<f32>,
    /// Largest relative change of the acceleration amplitude while measuring.
    pub amplitude_stability_rel: Option<f32>,
    /// Blocks averaged.
    pub blocks: u16,
    /// Drive voltage, V peak.
    pub drive_peak_v: f32,
    /// Time until the level was settled, s.
    pub settling_s: f32,
    /// Largest relative excess of the amplitude over the set level while settling.
    pub overshoot_rel: Option<f32>,
}

impl Observed {
    /// Of a measured point.
    pub(crate) fn of(point: &PointResult) -> Self {
        Self {
            distortion_dut_rel: finite(point.distortion_dut_rel),
            distortion_reference_rel: finite(point.distortion_reference_rel),
            signal_to_noise_dut_db: finite(point.signal_to_noise_dut_db),
            signal_to_noise_dut_worst_block_db: point
                .signal_to_noise_worst_block_db
                .and_then(finite),
            signal_to_noise_reference_db: finite(point.signal_to_noise_reference_db),
            repeatability_rel: finite(point.repeatability_rel),
            repeatability_phase_deg: finite(point.repeatability_phase_rad).map(degrees),
            hum_rel: finite(point.hum_rel),
            dropout_rel: finite(point.dropout_rel),
            amplitude_stability_rel: finite(point.amplitude_stability_rel),
            blocks: point.blocks,
            drive_peak_v: point.drive_peak_v,
            settling_s: point.settling_s,
            overshoot_rel: finite(point.overshoot_rel),
        }
    }
}

/// A quantity measured at each point.
pub struct Measured {
    /// Heading in CSV, with the unit.
    pub key: &'static str,
    /// Value in that unit; none where it was not measured.
    pub of: fn(&PointResult) -> Option<f64>,
    /// Column of the printed table.
    pub heading: Option<Heading>,
}

/// A column of the printed table.
pub struct Heading {
    /// Name in layouts.
    pub name: &'static str,
    /// Heading in each language of a certificate.
    pub words: [&'static str; 2],
    /// Unit as printed.
    pub unit: &'static str,
    /// Decimals printed.
    pub decimals: usize,
    /// Printed where the layout names no columns.
    pub usual: bool,
}

/// Every quantity there is, in the order of CSV and of the printed table.
pub const MEASURED: [Measured; 11] = [
    Measured {
        key: "distortion_dut_percent",
        of: |p| Some(percent(p.distortion_dut_rel)),
        heading: Some(Heading {
            name: "distortion",
            words: ["Distortion", "Klirrfaktor"],
            unit: "%",
            decimals: 2,
            usual: true,
        }),
    },
    plain("distortion_reference_percent", |p| {
        Some(percent(p.distortion_reference_rel))
    }),
    Measured {
        key: "signal_to_noise_dut_db",
        of: |p| Some(decimal(p.signal_to_noise_dut_db)),
        heading: Some(Heading {
            name: "signal_to_noise",
            words: ["S/N", "S/N"],
            unit: "dB",
            decimals: 0,
            usual: true,
        }),
    },
    plain("signal_to_noise_dut_worst_block_db", |p| {
        p.signal_to_noise_worst_block_db.map(decimal)
    }),
    plain("signal_to_noise_reference_db", |p| {
        Some(decimal(p.signal_to_noise_reference_db))
    }),
    plain("repeatability_percent", |p| {
        Some(percent(p.repeatability_rel))
    }),
    plain("hum_percent", |p| Some(percent(p.hum_rel))),
    plain("dropout_percent", |p| Some(percent(p.dropout_rel))),
    plain("amplitude_stability_percent", |p| {
        Some(percent(p.amplitude_stability_rel))
    }),
    plain("drive_peak_v", |p| Some(decimal(p.drive_peak_v))),
    plain("settling_s", |p| Some(decimal(p.settling_s))),
];

/// A quantity that is not printed.
const fn plain(key: &'static str, of: fn(&PointResult) -> Option<f64>) -> Measured {
    Measured {
        key,
        of,
        heading: None,
    }
}
