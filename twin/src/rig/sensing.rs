//! Parameters of a transducer with its conditioner.

use serde::{Deserialize, Serialize};

use super::range::Range;

/// A transducer with its conditioner, up to the input connector.
///
/// # Equation
/// `S(f) = S0 G H0(f) Hh(f) Hl(f)` with the seismic oscillator of ISO 16063-43 formula (1),
/// `H0 = 1 / (1 + j q/Q - q^2)`, `q = f/f0` (so `S0 = rho / w0^2` and `Q = 1 / (2 delta)`), a
/// first-order high-pass `Hh` and a second-order Butterworth low-pass `Hl`.
///
/// # Source
/// ISO 16063-43:2015, 7.1, formulae (1) and (2).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sensing {
    /// S0, sensitivity of the transducer far below its resonance, V/(m/s2).
    pub sensitivity_v_per_ms2: f64,
    /// f0, mounted resonance, Hz.
    pub resonance_hz: f64,
    /// Q of that resonance.
    pub quality_factor: f64,
    /// G, gain of the conditioner.
    pub conditioner_gain: f64,
    /// Corner of the conditioner's first-order high-pass, Hz.
    pub high_pass_hz: f64,
    /// Corner of the conditioner's second-order Butterworth low-pass, Hz.
    pub low_pass_hz: f64,
    /// White noise at the converter, V r.m.s. per sample.
    pub noise_rms_v: f64,
    /// Offset of the input, V.
    pub offset_v: f64,
}

impl Sensing {
    pub(super) fn ranges(&self, table: &str) -> Vec<Range> {
        let range = |name: &str, value, lowest, highest| {
            Range::new(format!("{table}.{name}"), value, lowest, highest)
        };
        vec![
            range(
                "sensitivity_v_per_ms2",
                self.sensitivity_v_per_ms2.abs(),
                1e-9,
                1e3,
            ),
            range("resonance_hz", self.resonance_hz, 10.0, 1e6),
            range("quality_factor", self.quality_factor, 0.3, 1e3),
            range("conditioner_gain", self.conditioner_gain.abs(), 1e-6, 1e6),
            range("high_pass_hz", self.high_pass_hz, 1e-4, 1e4),
            range("low_pass_hz", self.low_pass_hz, 100.0, 1e6),
            range("noise_rms_v", self.noise_rms_v, 0.0, 10.0),
            range("offset_v", self.offset_v, -100.0, 100.0),
        ]
    }
}
