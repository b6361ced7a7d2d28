//! Start of the simulation of a row, and its prediction.

use super::exciter::ExciterSlopes;
use crate::dataset::ExciterParameters;
use crate::observable::{Complex, Table};
use num_complex::Complex64;

/// Nominal values of a rig as a fit moves them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Nominal {
    pub(crate) exciter: Option<ExciterParameters<f64>>,
    /// ln of reference sensitivity (0 if unknown), and of DUT over reference sensitivity.
    pub(crate) drive_ln: f64,
    pub(crate) ratio_ln: f64,
    /// Gain of the device under test relative to its nominal value.
    pub(crate) dut_gain: f64,
    /// Sensitivity of the reference relative to its nominal value: the level is held by it.
    pub(crate) reference_gain: f64,
    /// Noise of a healthy channel: reference, device under test, in V.
    pub(crate) noise_v: [f64; 2],
    /// Its logarithm.
    pub(crate) noise_ln: [f64; 2],
}

/// Prediction of the simulation for one row.
#[derive(Debug, Clone)]
pub(crate) struct Prediction {
    /// Value of each observable.
    pub(crate) value: Table<f64>,
    /// Variance of each that the effects leave open.
    pub(crate) open: Table<f64>,
    pub(crate) slopes: Option<ExciterSlopes>,
    /// Mean square of the harmonics above 5 in each channel, in V^2.
    pub(crate) remainder_v2: [f64; 2],
    /// Share of it by which a response moved what no wave holds: how far a channel reaches is not
    /// known.
    pub(crate) remainder_carried: [f64; 2],
    /// Share of it that is not known better.
    pub(crate) remainder_open: [f64; 2],
    /// Noise power of each channel without it, in V^2.
    pub(crate) noise_power_v2: [f64; 2],
    /// Share of the healthy noise in the noise power of each channel.
    pub(crate) noise_share: [f64; 2],
    /// The balance of a nonlinear exciter was not reached.
    pub(crate) diverged: bool,
}

impl Prediction {
    /// Without signal, scatter or noise.
    pub(super) const EMPTY: Self = Self {
        value: Table::filled(0.0),
        open: Table::filled(0.0),
        slopes: None,
        remainder_v2: [0.0; 2],
        remainder_carried: [0.0; 2],
        remainder_open: [0.0; 2],
        noise_power_v2: [0.0; 2],
        noise_share: [1.0; 2],
        diverged: false,
    };

    /// Sets both parts of a complex value.
    pub(super) fn put(&mut self, [real, imaginary]: Complex, value: Complex64) {
        self.value[real] = value.re;
        self.value[imaginary] = value.im;
    }
}
