//! A capture in numbers: what a table, a page or a program shows of it.

use super::{Capture, FitError, ToneFit, Window, fit, spectrum};
use schemars::JsonSchema;
use serde::Serialize;

/// Lines of the spectrum that are listed.
const PEAKS: usize = 5;

/// Result of a capture.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Report {
    /// Running number of the first sample.
    pub first_index: u64,
    /// Samples per second and channel, Hz.
    pub sample_rate_hz: f64,
    /// Samples of each channel.
    pub pairs: usize,
    /// Length, s.
    pub duration_s: f64,
    /// Reference channel.
    pub reference: Channel,
    /// Device under test.
    pub dut: Channel,
    /// Fundamental of the device over that of the reference, V/V.
    pub ratio: Option<f64>,
    /// Its phase in (-pi, pi] rad.
    #[schemars(description = "Phase of the ratio, degrees.")]
    #[serde(
        rename = "phase_deg",
        serialize_with = "calib_output::number::maybe_rad_as_deg"
    )]
    pub phase_rad: Option<f64>,
}

/// Result of one channel.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Channel {
    /// A sample lies at an end of the converter's range.
    pub clipped: bool,
    /// Mean, V.
    pub dc_v: f64,
    /// All but the mean, V r.m.s.
    pub ac_rms_v: f64,
    /// Fundamental, harmonics and noise, where the frequency is known.
    pub tone: Option<ToneFit>,
    /// Highest lines of the spectrum, the highest first.
    pub peaks: Vec<Peak>,
}

/// A line of the spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Peak {
    /// Hz, to the distance of two lines.
    pub frequency_hz: f64,
    /// V r.m.s., by a flat-top window.
    pub rms_v: f64,
}

impl Report {
    /// Evaluates the capture, with fundamental and harmonics if the exact
    /// `frequency_hz` is known.
    ///
    /// # Errors
    /// [`FitError`]: the frequency does not suit the capture.
    pub fn new(capture: &Capture, frequency_hz: Option<f64>) -> Result<Self, FitError> {
        let rate_hz = capture.sample_rate_hz;
        let channel = |volts: &[f64], clipped| Channel::new(volts, rate_hz, frequency_hz, clipped);
        let reference = channel(&capture.reference_v, capture.reference_clipped)?;
        let dut = channel(&capture.dut_v, capture.dut_clipped)?;
        let both = reference.tone.as_ref().zip(dut.tone.as_ref());
        Ok(Self {
            first_index: capture.first_index,
            sample_rate_hz: rate_hz,
            pairs: capture.reference_v.len(),
            duration_s: capture.duration_s(),
            ratio: both.map(|(reference, dut)| dut.rms_v / reference.rms_v),
            phase_rad: both.map(|(reference, dut)| dut.phase_after(reference)),
            reference,
            dut,
        })
    }
}

impl Channel {
    fn new(
        volts: &[f64],
        sample_rate_hz: f64,
        frequency_hz: Option<f64>,
        clipped: bool,
    ) -> Result<Self, FitError> {
        let tone = frequency_hz.map(|frequency_hz| fit(volts, sample_rate_hz, frequency_hz));
        let tone = tone.transpose()?;
        let count = volts.len().max(1) as f64;
        let mean_v = volts.iter().sum::<f64>() / count;
        let squares = volts.iter().map(|volt| (volt - mean_v).powi(2));
        let peaks = spectrum(volts, sample_rate_hz, Window::FlatTop).peaks(PEAKS);
        let peak = |(frequency_hz, rms_v)| Peak {
            frequency_hz,
            rms_v,
        };
        Ok(Self {
            clipped,
            // A fitted mean is not pulled by the part of a cycle at the end.
            dc_v: tone.as_ref().map_or(mean_v, |tone| tone.dc_v),
            ac_rms_v: (squares.sum::<f64>() / count).sqrt(),
            tone,
            peaks: peaks.into_iter().map(peak).collect(),
        })
    }
}
