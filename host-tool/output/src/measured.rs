//! Measured quantities of a point beside its result: the one list.
//!
//! Each entry is a column of CSV and, where it has a heading, a column that the printed
//! table can have. JSON states them by [`calib_output::PointView`].

use calib_core::point::PointResult;
use calib_output::number::{decimal, percent};

/// A quantity measured at each point.
pub(crate) struct Measured {
    /// Heading in CSV, with the unit.
    pub(crate) key: &'static str,
    /// Value in that unit; none where it was not measured.
    pub(crate) of: fn(&PointResult) -> Option<f64>,
    /// Column of the printed table.
    pub(crate) heading: Option<Heading>,
}

/// A column of the printed table.
pub(crate) struct Heading {
    /// Name in layouts.
    pub(crate) name: &'static str,
    /// Heading in each language of [`crate::Language::ALL`].
    pub(crate) words: [&'static str; 2],
    /// Unit as printed.
    pub(crate) unit: &'static str,
    /// Decimals printed.
    pub(crate) decimals: usize,
    /// Printed where the layout names no columns.
    pub(crate) usual: bool,
}

/// Every quantity there is, in the order of CSV and of the printed table.
pub(crate) const MEASURED: [Measured; 11] = [
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
