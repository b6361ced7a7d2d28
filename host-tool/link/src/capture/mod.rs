//! Captures: the waveforms of both channels, and what is in them.
//!
//! ```text
//!   Inputs::of(client)          sample rate and volts per code, once
//!      |
//!   Inputs::capture(client, n)  n pairs, arm to last byte        (or `Taking`, step by step)
//!   measure(client, .., point)  the same while a point is held
//!      |
//!   Capture                     volts of reference and device under test
//!      |-- fit(volts, fs, f)    d.c., fundamental, harmonics 2 to 5, noise
//!      |-- spectrum(volts, fs)  amplitudes over frequency
//!      |-- Report::new          all of it in numbers, for tables and programs
//!      '-- write_csv            the waveform for other programs
//! ```
//!
//! The calibrator only hands out pairs; everything is computed here, in f64 and
//! without the code of the instrument, so that its results can be compared.

mod at_point;
mod csv;
mod harmonics;
mod report;
mod spectrum;
mod take;

pub use at_point::{Measured, measure, pairs_for, tone_frequency_hz};
pub use csv::write_csv;
pub use harmonics::{FitError, HIGHEST_ORDER, Harmonic, ToneFit, fit};
pub use report::{Channel, Peak, Report};
pub use spectrum::{Spectrum, Window, spectrum};
pub use take::{Inputs, Taking};

/// Consecutive samples of both channels; the channels share each instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Capture {
    /// Running number of the first sample, as `Status::samples` counts.
    pub first_index: u64,
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f64,
    /// Reference channel, V at the connector.
    pub reference_v: Vec<f64>,
    /// Device under test, V at the connector.
    pub dut_v: Vec<f64>,
    /// A sample of the reference lies at an end of the converter's range: the
    /// waveform is cut off.
    pub reference_clipped: bool,
    /// Whether the device under test clipped.
    pub dut_clipped: bool,
}

impl Capture {
    /// Length, s.
    pub fn duration_s(&self) -> f64 {
        self.reference_v.len() as f64 / self.sample_rate_hz
    }
}
