//! Readings at one point.

use calib_core::consecutive::Consecutive;
use num_complex::Complex32;

/// Readings of one point; complex, the phase being 0 where none was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Frequency, Hz.
    pub frequency_hz: f32,
    /// Readings.
    pub values: Values,
}

/// Readings, depending on the method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Values {
    /// Outputs at the same time, V.
    Comparison {
        /// Sensitivity of the reference.
        reference: Complex32,
        /// Its output.
        reference_output: Complex32,
        /// Output of the device under test.
        dut: Complex32,
    },
    /// Outputs one after another, V.
    Consecutive {
        /// Sensitivity of the reference.
        reference: Complex32,
        /// The three readings.
        readings: Consecutive,
    },
    /// Output at a stated amplitude.
    Calibrator {
        /// Amplitude of the calibrator, in the unit of the quantity, r.m.s.
        amplitude_rms: f32,
        /// Output of the device under test, V r.m.s.
        dut: Complex32,
    },
}
